//! Plates with elements of six degrees of freedom per node: distorted meshes down to a thickness of
//! 1e-4 of the length, and offsets.

use super::support::{Mesh, Model, SHAPES, assert_close, material, uniform};
use calyx_elastic::model::ShellShape;

/// Returns the deflection at the centre of the square plate of the report's table 2.2 for a
/// thickness, times its cube relative to 0.1, from a quarter with distorted elements.
fn deflection(shape: ShellShape, nodes: usize, thickness: f64, clamped: bool) -> f64 {
    let linear = matches!(shape, ShellShape::Triangle3 | ShellShape::Quadrilateral4);
    let count = if linear { nodes } else { nodes / 2 };
    let lines = uniform(count);
    let size = 5.0 / count as f64;
    let mesh = Mesh::grid(shape, &lines, &lines, |[u, v]| [5.0 * u, 5.0 * v, 0.0]).straight(|[x, y, _]| {
        let inside = |t: f64| t > 0.01 && t < 4.99;
        let wave = |a: f64, b: f64| 0.2 * size * (3.0 * (a * x + b * y)).sin();
        [if inside(x) { x + wave(1.0, 2.3) } else { x }, if inside(y) { y + wave(-1.7, 0.9) } else { y }, 0.0]
    });
    let steel = material(30e6, 0.3, 0.0);
    let mut model = Model::of_mesh(&mesh, thickness, 0.0, &steel);
    for (nodes, positions) in mesh.each() {
        let element = calyx_elastic::shell::ShellElement {
            shape,
            positions: &positions,
            thickness: &vec![thickness; shape.corner_count()],
            offset: 0.0,
            material: &steel,
            added_mass: 0.0,
        };
        let pressure = vec![-100.0; shape.corner_count()];
        model.add_load(nodes, &calyx_elastic::shell::pressure_load(&element, &pressure).unwrap());
    }
    model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 4, 5]);
    model.fix_all(&mesh.nodes(|[_, v]| v == 0.0), &[1, 3, 5]);
    // Rotation about x along the side x = 5.
    let supports: [&[usize]; 2] = if clamped { [&[0, 1, 2, 3, 4]; 2] } else { [&[2, 3], &[2, 4]] };
    model.fix_all(&mesh.nodes(|[u, _]| u == 1.0), supports[0]);
    model.fix_all(&mesh.nodes(|[_, v]| v == 1.0), supports[1]);
    model.solve()[6 * mesh.node([0.0, 0.0]) + 2] * (thickness / 0.1).powi(3)
}

#[test]
fn thin_plates_do_not_lock() {
    for shape in SHAPES {
        // Mindlin plates of thickness 0.01, and Kirchhoff plates of thickness 1e-4, relative to the
        // length.
        for (clamped, thick, thin) in
            [(true, 0.4615005165164572, 0.460576147842839), (false, 1.4794625505597, 1.47869636848572)]
        {
            for (thickness, reference) in [(0.1, thick), (1e-2, thin), (1e-3, thin)] {
                let found = deflection(shape, 12, thickness, clamped);
                println!("{shape:?} {clamped} {thickness}: {:.2e}", found / reference - 1.0);
                let allowed = if shape == ShellShape::Triangle3 { 0.02 } else { 0.01 };
                assert_close(found, reference, allowed, &format!("{shape:?} {clamped} {thickness}"));
            }
        }
    }
}

/// Cantilever of two layers of different thickness and modulus on common nodes at their interface,
/// under a moment at its end: curvature M / (D - B^2 / A) of the composite section.
#[test]
fn offset_layers_are_a_composite_section() {
    let (length, width, moment) = (4.0, 1.0, 1e-3);
    let layers = [(2.0, 0.1, -0.05), (1.0, 0.2, 0.1)];
    let (mut a, mut b, mut d) = (0.0, 0.0, 0.0);
    for (e, t, z) in layers {
        a += e * t;
        b += e * t * z;
        d += e * (f64::powi(t, 3) / 12.0 + t * z * z);
    }
    let curvature = moment / (width * (d - b * b / a));
    for shape in SHAPES {
        let mesh = Mesh::grid(shape, &uniform(4), &[0.0, 1.0], |[u, v]| [length * u, width * v, 0.0]);
        let mut model = Model::new(mesh.positions.len());
        for (e, t, z) in layers {
            model.add_mesh(&mesh, t, z, &material(e, 0.0, 0.0));
        }
        model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 1, 2, 3, 4, 5]);
        let tip = mesh.nodes(|[u, _]| u == 1.0);
        for &node in &tip {
            let middle = mesh.parameters[node][1] == 0.5;
            let share = if tip.len() == 2 {
                0.5
            } else if middle {
                4.0 / 6.0
            } else {
                1.0 / 6.0
            };
            // A moment about -y lifts the end.
            model.load[6 * node + 4] = -share * moment;
        }
        let found = model.solve();
        let lifted = found[6 * tip[0] + 2];
        assert_close(lifted, 0.5 * curvature * length * length, 1e-8, &format!("{shape:?} deflection"));
        assert_close(found[6 * tip[0] + 4], -curvature * length, 1e-8, &format!("{shape:?} rotation"));
        // Axial displacement of the interface: -B / A times the rotation.
        let axial = found[6 * tip[0]];
        assert_close(axial, b / a * curvature * length, 1e-8, &format!("{shape:?} axial"));
    }
}

/// Returns the deflection of the end of a cantilever 6 long and 0.2 high of six elements that bends
/// in its plane, relative to beam theory, under a moment (no force) or a force at its end. `slope`
/// shifts the upper nodes of inner mesh lines, in alternating directions for trapezoids.
fn in_plane(shape: ShellShape, slope: f64, trapezoids: bool, force: bool) -> f64 {
    let (length, height, thickness) = (6.0, 0.2, 0.1);
    let steel = material(1e7, 0.3, 0.0);
    let mesh = Mesh::grid(shape, &uniform(6), &[0.0, 1.0], |[u, v]| [length * u, height * v, 0.0]);
    let mesh = mesh.straight(|[x, y, z]| {
        if !(0.01..length - 0.01).contains(&x) {
            return [x, y, z];
        }
        let sign = if trapezoids && x.round() as i64 % 2 == 0 { -1.0 } else { 1.0 };
        let middle = if trapezoids { y - 0.5 * height } else { y };
        [x + sign * slope * middle, y, z]
    });
    let mut model = Model::of_mesh(&mesh, thickness, 0.0, &steel);
    model.fix_all(&mesh.nodes(|_| true), &[2, 3, 4]);
    model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0]);
    model.fix(mesh.node([0.0, 0.0]), &[1]);
    let second = thickness * f64::powi(height, 3) / 12.0;
    for node in mesh.nodes(|[u, _]| u == 1.0) {
        let v = mesh.parameters[node][1];
        if force {
            let quadratic = shape.node_count() > 4;
            let share = if !quadratic {
                0.5
            } else if v == 0.5 {
                4.0 / 6.0
            } else {
                1.0 / 6.0
            };
            model.load[6 * node + 1] = share;
        } else {
            model.load[6 * node] = (1.0 - 2.0 * v) / height;
        }
    }
    let expected = if force {
        length.powi(3) / 3.0 / (1e7 * second) + 1.2 * length / (steel.shear_modulus * height * thickness)
    } else {
        length * length / 2.0 / (1e7 * second)
    };
    model.solve()[6 * mesh.node([1.0, 0.0]) + 1] / expected
}

/// Cantilever of MacNeal and Harder 1985, with elements five times as long as high.
#[test]
fn quadrilaterals_bend_in_their_plane() {
    for shape in &SHAPES[1..] {
        // A moment on rectangles is exact.
        let moment = in_plane(*shape, 0.0, false, false);
        assert!((moment - 1.0).abs() < 1e-8, "{shape:?} moment: {moment}");
        let force = in_plane(*shape, 0.0, false, true);
        assert!((force - 1.0).abs() < 0.02, "{shape:?} force: {force}");
        let parallelograms = in_plane(*shape, 1.0, false, true);
        let trapezoids = in_plane(*shape, 1.0, true, true);
        println!("{shape:?}: {force} {parallelograms} {trapezoids}");
        let allowed = if *shape == ShellShape::Quadrilateral4 { 0.3 } else { 0.05 };
        assert!((parallelograms - 1.0).abs() < allowed, "{shape:?} parallelograms: {parallelograms}");
    }
}

/// Cantilever whose thickness varies linearly, under a force at its end: the deflection by
/// Timoshenko's beam theory as in the test of the report's element.
#[test]
fn a_cantilever_of_varying_thickness_bends_as_a_beam() {
    let (length, [root, tip]) = (10.0, [0.2_f64, 0.1]);
    let steel = material(1e7, 0.0, 0.0);
    let slope = (tip - root) / length;
    let antiderivative = |t: f64| -tip * tip / (2.0 * t * t) + 2.0 * tip / t + t.ln();
    let bending = 12.0 / 1e7 * (antiderivative(tip) - antiderivative(root)) / slope.powi(3);
    let expected = bending + 1.2 / steel.shear_modulus * (tip / root).ln() / slope;
    for shape in SHAPES {
        let quadratic = shape.node_count() > 4;
        let lines = uniform(if quadratic { 10 } else { 20 });
        let mesh = Mesh::grid(shape, &lines, &[0.0, 1.0], |[u, v]| [length * u, v, 0.0]);
        let mut model = Model::new(mesh.positions.len());
        for (nodes, positions) in mesh.each() {
            let corners = &positions[..shape.corner_count()];
            let thickness = corners.iter().map(|at| root + slope * at[0]).collect::<Vec<_>>();
            let element = calyx_elastic::shell::ShellElement {
                shape,
                positions: &positions,
                thickness: &thickness,
                offset: 0.0,
                material: &steel,
                added_mass: 0.0,
            };
            model.add_stiffness(nodes, calyx_elastic::shell::stiffness(&element).unwrap());
        }
        model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 1, 2, 3, 4, 5]);
        for node in mesh.nodes(|[u, _]| u == 1.0) {
            let middle = mesh.parameters[node][1] == 0.5;
            let share = if !quadratic {
                0.5
            } else if middle {
                4.0 / 6.0
            } else {
                1.0 / 6.0
            };
            model.load[6 * node + 2] = share;
        }
        let found = model.solve()[6 * mesh.node([1.0, 0.0]) + 2];
        println!("{shape:?} tapered: {:.2e}", found / expected - 1.0);
        assert_close(found, expected, if quadratic { 5e-4 } else { 5e-3 }, &format!("{shape:?}"));
    }
}
