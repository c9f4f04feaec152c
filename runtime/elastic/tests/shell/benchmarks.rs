//! Curved shells of the literature with elements of six degrees of freedom per node, against
//! converged solutions.

use super::support::{Mesh, Model, SHAPES, assert_close, material, uniform};
use calyx_elastic::model::ShellShape;
use std::f64::consts::PI;

/// Number of elements along a side of equal numbers of nodes: quadratic elements are twice as
/// large.
fn count(shape: ShellShape, linear: usize) -> usize {
    if matches!(shape, ShellShape::Triangle3 | ShellShape::Quadrilateral4) { linear } else { linear / 2 }
}

/// Adds nodal forces of a force per area in direction z.
fn add_dead_load(model: &mut Model, mesh: &Mesh, thickness: f64, per_area: f64) {
    let weight = material(1.0, 0.0, per_area.abs() / thickness);
    let mut unit = Model::of_mesh(mesh, thickness, 0.0, &weight);
    let mut up = vec![0.0; unit.load.len()];
    (0..mesh.positions.len()).for_each(|node| up[6 * node + 2] = per_area.signum());
    unit.load = super::support::product(&unit.mass, &up);
    for node in 0..mesh.positions.len() {
        model.load[6 * node + 2] += unit.load[6 * node + 2];
    }
}

/// Scordelis-Lo roof: returns the deflection of the middle of the free edge.
fn roof(shape: ShellShape, nodes: usize) -> f64 {
    let steel = material(4.32e8, 0.0, 0.0);
    let lines = uniform(count(shape, nodes));
    let mesh = Mesh::grid(shape, &lines, &lines, |[u, v]| {
        let angle = 40.0_f64.to_radians() * u;
        [25.0 * angle.sin(), 25.0 * v, 25.0 * angle.cos()]
    });
    let mut model = Model::of_mesh(&mesh, 0.25, 0.0, &steel);
    add_dead_load(&mut model, &mesh, 0.25, -90.0);
    model.fix_all(&mesh.nodes(|[_, v]| v == 0.0), &[0, 2]);
    model.fix_all(&mesh.nodes(|[_, v]| v == 1.0), &[1, 3, 5]);
    model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 4, 5]);
    -model.solve()[6 * mesh.node([1.0, 1.0]) + 2]
}

/// Pinched cylinder with end diaphragms: returns the displacement under the load.
fn cylinder(shape: ShellShape, nodes: usize) -> f64 {
    let steel = material(3e6, 0.3, 0.0);
    let lines = uniform(count(shape, nodes));
    let mesh = Mesh::grid(shape, &lines, &lines, |[u, v]| {
        let angle = 0.5 * PI * u;
        [300.0 * angle.sin(), 300.0 * v, 300.0 * angle.cos()]
    });
    let mut model = Model::of_mesh(&mesh, 3.0, 0.0, &steel);
    model.fix_all(&mesh.nodes(|[_, v]| v == 0.0), &[0, 2]);
    model.fix_all(&mesh.nodes(|[_, v]| v == 1.0), &[1, 3, 5]);
    model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 4, 5]);
    model.fix_all(&mesh.nodes(|[u, _]| u == 1.0), &[2, 3, 4]);
    let loaded = 6 * mesh.node([0.0, 1.0]) + 2;
    model.load[loaded] = -0.25;
    -model.solve()[loaded]
}

/// Hemisphere with a hole of 18 degrees: returns the displacement under a load.
fn hemisphere(shape: ShellShape, nodes: usize) -> f64 {
    let steel = material(6.825e7, 0.3, 0.0);
    let lines = uniform(count(shape, nodes));
    let mesh = Mesh::grid(shape, &lines, &lines, |[u, v]| {
        let (azimuth, height) = (0.5 * PI * u, 72.0_f64.to_radians() * v);
        [10.0 * azimuth.cos() * height.cos(), 10.0 * azimuth.sin() * height.cos(), 10.0 * height.sin()]
    });
    let mut model = Model::of_mesh(&mesh, 0.04, 0.0, &steel);
    model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[1, 3, 5]);
    model.fix_all(&mesh.nodes(|[u, _]| u == 1.0), &[0, 4, 5]);
    let (a, b) = (mesh.node([0.0, 0.0]), mesh.node([1.0, 0.0]));
    model.fix(a, &[2]);
    model.load[6 * a] = 1.0;
    model.load[6 * b + 1] = -1.0;
    model.solve()[6 * a]
}

/// Beam twisted by 90 degrees: returns the displacements of the middle of the tip in the direction
/// of unit loads along and across its width.
fn twisted_beam(shape: ShellShape, nodes: usize, thickness: f64) -> [f64; 2] {
    let steel = material(29e6, 0.22, 0.0);
    let lines = [uniform(count(shape, 6 * nodes)), uniform(count(shape, nodes))];
    let mesh = Mesh::grid(shape, &lines[0], &lines[1], |[u, v]| {
        let (angle, across) = (0.5 * PI * u, 1.1 * (v - 0.5));
        [12.0 * u, across * angle.cos(), across * angle.sin()]
    });
    [2, 1].map(|direction| {
        let mut model = Model::of_mesh(&mesh, thickness, 0.0, &steel);
        model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 1, 2, 3, 4, 5]);
        let mut tip = mesh.nodes(|[u, _]| u == 1.0);
        tip.sort_by(|a, b| mesh.parameters[*a][1].total_cmp(&mesh.parameters[*b][1]));
        // Consistent with linear or quadratic displacements.
        let quadratic = count(shape, nodes) != nodes;
        let steps = tip.len() - 1;
        for (index, node) in tip.iter().enumerate() {
            let end = index == 0 || index == steps;
            let part = match (quadratic, end) {
                (false, true) => 0.5,
                (false, false) => 1.0,
                (true, true) => 1.0 / 3.0,
                (true, false) => [2.0, 4.0][index % 2] / 3.0,
            };
            model.load[6 * node + direction] += part / steps as f64;
        }
        model.solve()[6 * mesh.node([1.0, 0.5]) + direction]
    })
}

/// Allowed deviations from the converged solutions, for each shape: roof, cylinder and hemisphere
/// with 16 linear or 8 quadratic elements along each side, twisted beam of thickness 0.32 and 0.05
/// with 4 linear or 2 quadratic elements across.
///
/// The triangle of three nodes has constant membrane strain and converges slowly where the membrane
/// bends in its plane. The load on the cylinder is a point load.
const ALLOWED: [(ShellShape, [f64; 4]); 5] = [
    (ShellShape::Triangle3, [0.04, 0.11, 0.02, 0.09]),
    (ShellShape::Triangle6, [0.01, 0.08, 0.015, 0.01]),
    (ShellShape::Quadrilateral4, [0.01, 0.08, 0.01, 0.01]),
    (ShellShape::Quadrilateral8, [0.01, 0.01, 0.01, 0.01]),
    (ShellShape::Quadrilateral9, [0.01, 0.01, 0.01, 0.01]),
];

const ROOF: f64 = 0.3014689;
const CYLINDER: f64 = 1.82718e-5;
const HEMISPHERE: f64 = 0.09374;
const TWISTED: [(f64, [f64; 2]); 2] = [(0.32, [0.0054153, 0.0017505]), (0.05, [1.3875, 0.342843])];

#[test]
fn usual_meshes_agree_with_converged_solutions() {
    for (shape, allowed) in ALLOWED {
        let mut cases = vec![
            ("roof", roof(shape, 16), ROOF, allowed[0]),
            ("cylinder", cylinder(shape, 16), CYLINDER, allowed[1]),
            ("hemisphere", hemisphere(shape, 16), HEMISPHERE, allowed[2]),
        ];
        for (thickness, references) in TWISTED {
            let found = twisted_beam(shape, 4, thickness);
            cases.extend((0..2).map(|k| ("twisted beam", found[k], references[k], allowed[3])));
        }
        for (name, found, reference, allowed) in cases {
            println!("{shape:?} {name}: {:.4}", found / reference);
            assert_close(found, reference, allowed, &format!("{shape:?} {name}"));
        }
    }
}

/// Thickness over length 2.7e-4 with warped elements: Belytschko, Wong and Stolarski 1989.
#[test]
fn a_thin_twisted_beam_does_not_lock() {
    for shape in SHAPES {
        for (found, reference) in twisted_beam(shape, 4, 0.0032).into_iter().zip([5256.0, 1294.0]) {
            assert_close(found, reference, 0.015, &format!("{shape:?}"));
        }
    }
}

#[test]
#[ignore = "takes half a minute"]
fn fine_meshes_agree_with_converged_solutions() {
    for shape in SHAPES {
        let slow = if shape == ShellShape::Triangle3 { 2.0 } else { 1.0 };
        assert_close(roof(shape, 32), ROOF, 0.006 * slow, &format!("{shape:?} roof"));
        assert_close(cylinder(shape, 32), CYLINDER, 0.015 * slow, &format!("{shape:?} cylinder"));
        assert_close(hemisphere(shape, 32), HEMISPHERE, 0.006 * slow, &format!("{shape:?} hemisphere"));
        for (thickness, references) in TWISTED {
            let found = twisted_beam(shape, 8, thickness);
            for (found, reference) in found.into_iter().zip(references) {
                let allowed = if slow > 1.0 { 0.03 } else { 0.0025 };
                assert_close(found, reference, allowed, &format!("{shape:?} twisted beam"));
            }
        }
    }
}

/// Quarter of a thin ring clamped at one end, with a radial force at the other: pi P R^3 / (4 E I)
/// for thickness over radius of 1e-4.
#[test]
fn thin_curved_strips_do_not_lock() {
    let (radius, thickness, width) = (10.0_f64, 1e-3_f64, 1.0);
    let steel = material(1e9, 0.0, 0.0);
    let expected = PI * radius.powi(3) / (4.0 * 1e9 * width * thickness.powi(3) / 12.0);
    for shape in SHAPES {
        let lines = uniform(count(shape, 16));
        let mesh = Mesh::grid(shape, &lines, &[0.0, 1.0], |[u, v]| {
            let angle = 0.5 * PI * u;
            [radius * angle.sin(), width * v, radius * angle.cos()]
        });
        let mut model = Model::of_mesh(&mesh, thickness, 0.0, &steel);
        model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[0, 1, 2, 3, 4, 5]);
        let tip = mesh.nodes(|[u, _]| u == 1.0);
        for &node in &tip {
            let middle = tip.len() == 3 && mesh.parameters[node][1] == 0.5;
            let share = if tip.len() == 2 {
                0.5
            } else if middle {
                4.0 / 6.0
            } else {
                1.0 / 6.0
            };
            model.load[6 * node] = share;
        }
        let found = model.solve()[6 * tip[0]];
        assert_close(found, expected, 0.01, &format!("{shape:?}"));
    }
}
