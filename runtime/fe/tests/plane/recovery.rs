//! Smoothed stress of fields that elements represent.

use crate::plane::MATERIAL;
use calyx_fe::material::Plane;
use calyx_fe::{
    Block, ElementOrder, ElementPoint, MeshBuilder, PlaneModel, StressRecovery, principal_stresses, uniform,
};

#[test]
fn stresses_of_polynomial_displacements_are_recovered_exactly() {
    let corners = [[0.0, 0.0], [0.3, 0.05], [0.35, 0.25], [0.05, 0.2]];
    for degree in 1..=3 {
        let block = Block::quadrilateral(corners).divided(uniform(3), uniform(4));
        let mesh = MeshBuilder::new().block(block).finish(ElementOrder::full(degree)).expect("one block");
        let model = PlaneModel::new(mesh, MATERIAL, Plane::Stress);
        let power = i32::from(degree);
        // u = (a x + b y)^p and its like: parallelograms represent them.
        let displaced = |[x, y]: [f64; 2]| [(x + 2.0 * y).powi(power), (0.7 * x - y).powi(power)];
        let displacements = model.mesh.nodes.iter().flat_map(|&node| displaced(node)).collect::<Vec<_>>();
        let [d11, d12, d33] = model.elasticity();
        let recovery = StressRecovery::new(&model);
        for element in 0..model.mesh.elements.len() {
            let place = ElementPoint { element, xi: 0.4, eta: -1.0 };
            let [x, y] = model.mesh.position(place);
            let (f, g) = (
                f64::from(power) * (x + 2.0 * y).powi(power - 1),
                f64::from(power) * (0.7 * x - y).powi(power - 1),
            );
            let exact = [d11 * f - d12 * g, d12 * f - d11 * g, d33 * (2.0 * f + 0.7 * g)];
            for (found, exact) in recovery.stress(place, &displacements).iter().zip(&exact) {
                assert!((found - exact).abs() < 1e-11 * d11, "degree {degree}: {found} is not {exact}");
            }
        }
    }
}

#[test]
fn principal_stresses_are_the_eigenvalues() {
    for stress in [[3.0, -1.0, 2.0], [0.0, 0.0, 5.0], [4.0, 4.0, 0.0]] {
        let [xx, yy, xy] = stress;
        let [large, small] = principal_stresses(stress);
        assert!(large >= small);
        assert!((large + small - xx - yy).abs() < 1e-14 && (large * small - xx * yy + xy * xy).abs() < 1e-13);
    }
}
