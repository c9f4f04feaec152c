//! Patch tests: constant membrane strain, curvature and transverse shear on distorted meshes.

use super::support::{Mesh, Model, SHAPES, material, uniform};
use calyx_elastic::model::ShellShape;

/// Distorted mesh of the unit square with straight sides.
pub fn distorted(shape: ShellShape) -> Mesh {
    let lines = uniform(3);
    Mesh::grid(shape, &lines, &lines, |[u, v]| [u, v, 0.0]).straight(|[x, y, _]| {
        let inside = |t: f64| t > 0.01 && t < 0.99;
        if inside(x) && inside(y) {
            let wave = |a: f64, b: f64| 0.09 * (17.0 * (a * x + b * y)).sin();
            [x + wave(1.0, 2.3), y + wave(-1.7, 0.9), 0.0]
        } else {
            [x, y, 0.0]
        }
    })
}

/// Motion of a node at x and y: translations of the mid-surface and rotations.
type Field = Box<dyn Fn(f64, f64) -> ([f64; 3], [f64; 3])>;

fn fields() -> Vec<(&'static str, Field)> {
    vec![
        ("stretch x", Box::new(|x, _| ([1e-3 * x, 0.0, 0.0], [0.0; 3]))),
        ("stretch y", Box::new(|_, y| ([0.0, 1e-3 * y, 0.0], [0.0; 3]))),
        ("in-plane shear", Box::new(|x, _| ([0.0, 1e-3 * x, 0.0], [0.0, 0.0, 0.5e-3]))),
        ("curvature x", Box::new(|x, _| ([0.0, 0.0, 0.5 * x * x], [0.0, -x, 0.0]))),
        ("curvature y", Box::new(|_, y| ([0.0, 0.0, 0.5 * y * y], [y, 0.0, 0.0]))),
        ("twist", Box::new(|x, y| ([0.0, 0.0, x * y], [x, -y, 0.0]))),
    ]
}

#[test]
fn constant_membrane_strain_and_curvature_are_exact() {
    let steel = material(2.0, 0.3, 0.0);
    for shape in SHAPES {
        for (thickness, offset) in [(0.1, 0.0), (0.1, 0.07), (1e-4, 0.0)] {
            for (name, field) in fields() {
                let mesh = distorted(shape);
                let mut model = Model::new(mesh.positions.len());
                model.add_mesh(&mesh, thickness, offset, &steel);
                let motion = |node: usize| {
                    let [x, y, _] = mesh.positions[node];
                    let (u, turn) = field(x, y);
                    // The field is that of the mid-surface: u of the node = u - theta x offset.
                    [u[0] - turn[1] * offset, u[1] + turn[0] * offset, u[2], turn[0], turn[1], turn[2]]
                };
                let border = |t: f64| !(0.01..0.99).contains(&t);
                for node in mesh.nodes(|[u, v]| border(u) || border(v)) {
                    for (component, value) in motion(node).into_iter().enumerate() {
                        model.constraints.prescribe(6 * node + component, value);
                    }
                }
                let found = model.solve();
                let largest = (0..mesh.positions.len()).flat_map(motion).fold(0.0_f64, |m, x| m.max(x.abs()));
                for node in 0..mesh.positions.len() {
                    for (component, value) in motion(node).into_iter().enumerate() {
                        let error = (found[6 * node + component] - value).abs() / largest;
                        let allowed = if thickness < 1e-3 { 1e-6 } else { 1e-10 };
                        assert!(
                            error < allowed,
                            "{shape:?} {name} t {thickness} offset {offset}: node {node} component \
                             {component}: {error:.1e}"
                        );
                    }
                }
            }
        }
    }
}

/// A constant transverse shear strain needs moments per area for its equilibrium, so the patch test
/// checks strain energy and transverse forces. The plate is so thick that these moments do not bend
/// it within an element.
#[test]
fn constant_transverse_shear_is_exact() {
    let steel = material(2.0, 0.3, 0.0);
    let (thickness, strain) = (1e4, 1e-3);
    for shape in SHAPES {
        for direction in 0..2 {
            let mesh = distorted(shape);
            let model = Model::of_mesh(&mesh, thickness, 0.0, &steel);
            let mut motion = vec![0.0; 6 * mesh.positions.len()];
            for (node, at) in mesh.positions.iter().enumerate() {
                motion[6 * node + 2] = strain * at[direction];
            }
            let forces = model.forces(&motion);
            let energy = forces.iter().zip(&motion).map(|(f, u)| f * u).sum::<f64>();
            let expected = 5.0 / 6.0 * steel.shear_modulus * thickness * strain * strain;
            assert!((energy / expected - 1.0).abs() < 1e-7, "{shape:?}: {energy} {expected}");
            let inside = |t: f64| (0.01..0.99).contains(&t);
            for node in mesh.nodes(|[u, v]| inside(u) && inside(v)) {
                let force = forces[6 * node + 2] / (expected / strain);
                assert!(force.abs() < 1e-7, "{shape:?}: force {force:.1e} on node {node}");
            }
        }
    }
}
