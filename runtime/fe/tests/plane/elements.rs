//! Single elements: shape functions, rigid-body motions, mass.

use crate::plane::MATERIAL;
use calyx_fe::material::Plane;
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneMesh, PlaneModel, quadrature::gauss_legendre};
use nalgebra::DMatrix;

/// All full, boundary-only and some uneven orders.
fn orders() -> Vec<ElementOrder> {
    let mut orders = (1..=3).map(ElementOrder::full).collect::<Vec<_>>();
    orders.extend([2, 3].map(ElementOrder::serendipity));
    for sides in [[1, 2, 3, 1], [3, 2, 3, 2], [1, 1, 2, 1], [2, 3, 3, 3]] {
        for interior in [[1, 1], [2, 2], [3, 2], [3, 3]] {
            orders.push(ElementOrder { sides, interior });
        }
    }
    orders
}

fn element(order: ElementOrder) -> PlaneMesh {
    let block = Block::new(
        Curve::new(|u| [0.02 * u, 0.003 * u * (1.0 - u)]),
        Curve::line([0.02, 0.0], [0.024, 0.013]),
        Curve::new(|u| [0.002 + 0.022 * u, 0.011 + 0.002 * u + 0.004 * u * (1.0 - u) * (0.3 - u)]),
        Curve::line([0.0, 0.0], [0.002, 0.011]),
    );
    MeshBuilder::new().block(block).finish(order).expect("one sound block")
}

#[test]
fn shape_functions_are_one_at_their_node_and_zero_at_the_others() {
    for order in orders() {
        let places = order.node_coordinates();
        assert_eq!(places.len(), order.node_count());
        for (node, place) in places.iter().enumerate() {
            for (index, shape) in order.shapes(place[0], place[1]).iter().enumerate() {
                let expected = if index == node { 1.0 } else { 0.0 };
                assert!((shape[0] - expected).abs() < 1e-14, "{order:?}: function {index} at node {node}");
            }
        }
    }
}

#[test]
fn shape_functions_sum_to_one_and_differentiate_consistently() {
    let (xi, eta, step) = (0.31, -0.47, 1e-5);
    for order in orders() {
        let sum =
            order.shapes(xi, eta).iter().fold([0.0; 3], |sum, shape| [0, 1, 2].map(|k| sum[k] + shape[k]));
        assert!((sum[0] - 1.0).abs() < 1e-14 && sum[1].abs() < 1e-13 && sum[2].abs() < 1e-13, "{order:?}");
        let around = [(xi - step, eta), (xi + step, eta), (xi, eta - step), (xi, eta + step)];
        let [west, east, south, north] = around.map(|(xi, eta)| order.shapes(xi, eta));
        for (node, shape) in order.shapes(xi, eta).iter().enumerate() {
            // Central differences of cubics: error of order step² plus rounding over step.
            let by_xi = (east[node][0] - west[node][0]) / (2.0 * step);
            let by_eta = (north[node][0] - south[node][0]) / (2.0 * step);
            assert!((by_xi - shape[1]).abs() < 1e-8 && (by_eta - shape[2]).abs() < 1e-8, "{order:?} {node}");
        }
    }
}

#[test]
fn full_orders_interpolate_their_whole_tensor_product() {
    for degree in 1..=3_u8 {
        let order = ElementOrder::full(degree);
        let power = |[x, y]: [f64; 2]| (0.3 + x).powi(degree.into()) * (y - 0.8).powi(degree.into());
        let place = [0.37, -0.59];
        let shapes = order.shapes(place[0], place[1]);
        let value = order
            .node_coordinates()
            .iter()
            .zip(&shapes)
            .map(|(&node, shape)| power(node) * shape[0])
            .sum::<f64>();
        assert!((value - power(place)).abs() < 1e-13);
    }
}

#[test]
fn a_free_element_has_three_zero_modes() {
    for order in orders() {
        for plane in [Plane::Strain, Plane::Stress] {
            let model = PlaneModel::new(element(order), MATERIAL, plane);
            let stiffness = model.stiffness();
            let mut dense = DMatrix::zeros(model.dof_count(), model.dof_count());
            for entry in stiffness.triplet_iter() {
                dense[(entry.row, entry.col)] = *entry.val;
            }
            assert_eq!(dense, dense.transpose(), "symmetric to the bit");
            for mode in model.rigid_body_modes() {
                let force = &dense * nalgebra::DVector::from_vec(mode.clone());
                let size = mode.iter().map(|value| value.abs()).fold(0.0, f64::max);
                assert!(force.amax() < 1e-13 * dense.amax() * size * 10.0, "{order:?}");
            }
            let mut values = dense.symmetric_eigen().eigenvalues.as_slice().to_vec();
            values.sort_by(f64::total_cmp);
            let largest = values[values.len() - 1];
            assert!(values[2] < 1e-13 * largest && values[0] > -1e-13 * largest, "{order:?}: {values:?}");
            assert!(values[3] > 1e-4 * largest, "{order:?}: {values:?}");
        }
    }
}

#[test]
fn mass_is_density_times_area_and_moments() {
    // Orders 2 and 3 represent the parabola of the bottom exactly, but only order 3 the cubic of
    // the top.
    let model = PlaneModel::new(element(ElementOrder::CUBIC), MATERIAL, Plane::Strain);
    let modes = model.rigid_body_modes();
    let mass = model.mass();
    let product =
        |a: &[f64], b: &[f64]| mass.triplet_iter().map(|m| a[m.row] * m.val * b[m.col]).sum::<f64>();
    // Green's theorem along the exact boundary: area = ∮ x dy, polar moment = ∮ (x³/3 dy - y³/3
    // dx).
    let sides: [&dyn Fn(f64) -> [f64; 2]; 4] = [
        &|u| [0.02 * u, 0.003 * u * (1.0 - u)],
        &|v| [0.02 + 0.004 * v, 0.013 * v],
        &|u| {
            let u = 1.0 - u;
            [0.002 + 0.022 * u, 0.011 + 0.002 * u + 0.004 * u * (1.0 - u) * (0.3 - u)]
        },
        &|v| [0.002 * (1.0 - v), 0.011 * (1.0 - v)],
    ];
    let (mut area, mut polar) = (0.0, 0.0);
    for side in sides {
        for (x, weight) in gauss_legendre(8) {
            let (u, step) = (0.5 * (1.0 + x), 0.01);
            let [x, y] = side(u);
            // Exact for the cubics of these sides: a five-point difference.
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| side(u + k * step));
            let [dx, dy] =
                [0, 1].map(|axis| (a[axis] - 8.0 * b[axis] + 8.0 * c[axis] - d[axis]) / (12.0 * step));
            area += 0.5 * weight * x * dy;
            polar += 0.5 * weight * (x.powi(3) * dy - y.powi(3) * dx) / 3.0;
        }
    }
    let relative = |found: f64, exact: f64| (found / exact - 1.0).abs();
    assert!(relative(product(&modes[0], &modes[0]), MATERIAL.density * area) < 1e-10);
    assert!(relative(product(&modes[2], &modes[2]), MATERIAL.density * polar) < 1e-10);
}

#[test]
fn gauss_legendre_is_exact_to_twice_its_points() {
    for count in 1..=20 {
        for degree in 0..2 * count {
            let found =
                gauss_legendre(count).iter().map(|(x, weight)| weight * x.powi(degree as i32)).sum::<f64>();
            let exact = if degree % 2 == 0 { 2.0 / (degree as f64 + 1.0) } else { 0.0 };
            assert!((found - exact).abs() < 1e-14, "{count} points, degree {degree}: {found} {exact}");
        }
    }
}
