//! Smoothed stresses of whole solutions, and the error estimate made of them.

use crate::solid::convergence::{Problem, cylinder, solved, sphere};
use crate::solid::shapes::{Kind, cube, kinds};
use crate::solid::{GRADIENT, MATERIAL, dot, linear_field};
use calyx_fe::solid::{SolidElementPoint, SolidModel};

/// Energies of the error, relative to that of the solution: of the solution's own stresses, of the
/// smoothed ones, and as estimated.
fn errors(problem: &Problem<'_>, kind: Kind, divisions: [usize; 3]) -> [f64; 3] {
    let (model, displacements) = solved(problem, kind, divisions);
    let recovered = model.recover_stress(&displacements);
    let estimate = recovered.error_estimate();
    let (mut own, mut smoothed, mut whole) = (0.0, 0.0, 0.0);
    for (index, element) in model.mesh.elements.iter().enumerate() {
        let [p, q] = element.interpolation.highest().map(|order| usize::from(order) + 3);
        for (local, weight) in element.interpolation.cell().quadrature([p, q]) {
            let place = SolidElementPoint { element: index, local };
            let [a, b, c] = model.mesh.jacobian(place);
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            let weight = weight * dot(a, cross);
            let exact = (problem.stress)(model.mesh.position(place));
            let energy = |found: [f64; 6]| {
                weight * model.energy_density(std::array::from_fn(|part| found[part] - exact[part]))
            };
            own += energy(model.stress(place, &displacements));
            smoothed += energy(recovered.at(place));
            whole += energy([0.0; 6]);
        }
    }
    [own, smoothed, estimate.elements.iter().sum::<f64>()].map(|energy| energy / whole)
}

/// The ratio of estimated to true error (the effectivity) approaches 1. Smoothed stresses are more
/// accurate than the solution's own ones and converge faster.
fn check(
    name: &str,
    problem: &Problem<'_>,
    divisions: impl Fn(u8) -> [usize; 3],
    bounds: impl Fn(u8) -> [f64; 2],
) {
    for kind in kinds() {
        let coarse = divisions(kind.order());
        let runs = [1, 2].map(|finer| errors(problem, kind, coarse.map(|count| count * finer)));
        let effectivity = runs.map(|[own, _, estimated]| (estimated / own).sqrt());
        let gain = runs.map(|[own, smoothed, _]| (smoothed / own).sqrt());
        let rate = 0.5 * (runs[0][1] / runs[1][1]).log2();
        println!(
            "{name} {kind:?}: effectivity {effectivity:.3?}, smoothed over own {gain:.3?}, rate {rate:.2}"
        );
        let [least, most] = bounds(kind.order());
        assert!(
            effectivity[1] > least && effectivity[1] < most,
            "{name} {kind:?}: effectivity {}",
            effectivity[1]
        );
        // On a mesh that is too coarse for its order, the estimate is too large and smoothing is
        // inaccurate.
        assert!(gain[1] < 0.8 || effectivity[1] > 1.2, "{name} {kind:?}: smoothed over own {}", gain[1]);
        assert!(rate > f64::from(kind.order()) + 0.4, "{name} {kind:?}: smoothed stresses at {rate}");
    }
}

#[test]
fn estimates_of_a_sphere() {
    check(
        "sphere",
        &sphere(MATERIAL),
        |order| if order == 1 { [4, 4, 4] } else { [2, 2, 2] },
        |_| [0.9, 1.15],
    );
}

#[test]
fn estimates_of_a_cylinder() {
    check(
        "cylinder",
        &cylinder(MATERIAL),
        |order| [[4, 8, 1], [3, 6, 1], [3, 6, 1]][usize::from(order) - 1],
        |order| [0.9, if order == 3 { 2.0 } else { 1.15 }],
    );
}

#[test]
fn smoothed_stresses_of_constant_strain_are_exact_and_have_no_error() {
    let skew = |[x, y, z]: [f64; 3]| [x + 0.1 * y * z, 1.3 * y - 0.2 * x * x, 0.8 * z + 0.1 * x * y];
    for kind in kinds() {
        let model = SolidModel::new(cube(kind, 1, [2, 2, 2], &skew), MATERIAL);
        let field = model.mesh.nodes.iter().flat_map(|&node| linear_field(node)).collect::<Vec<_>>();
        let recovered = model.recover_stress(&field);
        let exact = model.stress_of(GRADIENT);
        for stress in &recovered.nodal {
            for (found, exact) in stress.iter().zip(&exact) {
                assert!(
                    (found - exact).abs() < 1e-9 * MATERIAL.youngs_modulus * 1e-3,
                    "{kind:?}: {found} {exact}"
                );
            }
        }
        assert!(recovered.error_estimate().relative() < 1e-9, "{kind:?}");
    }
}
