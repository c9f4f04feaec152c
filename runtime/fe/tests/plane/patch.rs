//! The patch test: distorted meshes of any orders reproduce constant strain.

use crate::plane::MATERIAL;
use calyx_fe::material::Plane;
use calyx_fe::{
    Block, Constraints, Curve, ElementOrder, ElementPoint, MeshBuilder, PlaneMesh, PlaneModel, Side, Solver,
    uniform,
};
use std::collections::BTreeSet;

const TOLERANCE: f64 = 1e-10;

/// Displacement gradient and translation of the field.
const GRADIENT: [[f64; 2]; 2] = [[1.1e-3, -0.7e-3], [0.4e-3, -0.9e-3]];

fn field([x, y]: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|axis| 2e-3 + GRADIENT[axis][0] * x + GRADIENT[axis][1] * y)
}

/// Four distorted blocks of a square around an inner point, of given orders. The inner lines are
/// curved by `bulge`.
fn square(orders: [ElementOrder; 4], coordinates: Option<ElementOrder>, bulge: f64) -> PlaneMesh {
    let points = [
        [[0.0, 0.0], [0.45, 0.0], [1.0, 0.0]],
        [[0.0, 0.6], [0.57, 0.42], [1.0, 0.35]],
        [[0.0, 1.0], [0.6, 1.0], [1.0, 1.0]],
    ];
    let line = |from: [f64; 2], to: [f64; 2], bulge: f64| {
        let across = [from[1] - to[1], to[0] - from[0]];
        Curve::new(move |t| {
            let out = bulge * t * (1.0 - t) * (1.3 - t);
            [0, 1].map(|axis| (1.0 - t) * from[axis] + t * to[axis] + out * across[axis])
        })
    };
    let mut builder = MeshBuilder::new();
    for (index, order) in orders.into_iter().enumerate() {
        let (i, j) = (index % 2, index / 2);
        let [a, b, c, d] = [points[j][i], points[j][i + 1], points[j + 1][i + 1], points[j + 1][i]];
        let inner = |yes: bool| if yes { bulge } else { 0.0 };
        let mut block = Block::new(
            line(a, b, inner(j == 1)),
            line(b, c, inner(i == 0)),
            line(d, c, inner(j == 0)),
            line(a, d, inner(i == 1)),
        )
        .divided(vec![0.0, 0.4, 1.0], uniform(2))
        .order(order);
        block = block.named(if j == 0 { Side::Bottom } else { Side::Top }, "rim");
        block = block.named(if i == 0 { Side::Left } else { Side::Right }, "rim");
        builder.block(block);
    }
    if let Some(order) = coordinates {
        builder.coordinate_order(order);
    }
    builder.finish(ElementOrder::LINEAR).expect("the blocks conform")
}

fn check(name: &str, mesh: PlaneMesh) {
    let model = PlaneModel::new(mesh, MATERIAL, Plane::Strain);
    let stiffness = model.stiffness();
    let mesh = &model.mesh;
    let rim = mesh.chain("rim").expect("named");
    let exact = mesh.nodes.iter().flat_map(|&node| field(node)).collect::<Vec<_>>();

    let mut constraints = Constraints::new();
    for node in mesh.chain_nodes(rim).into_iter().collect::<BTreeSet<_>>() {
        constraints.prescribe_node(node, field(mesh.nodes[node]));
    }
    let solver = Solver::new(&stiffness, constraints).expect("held all around");
    let solved = solver.solve_one(&vec![0.0; model.dof_count()]).expect("solves");
    for (solved, exact) in solved.iter().zip(&exact) {
        assert!((solved - exact).abs() < TOLERANCE * 2e-3, "{name}: displacement {solved} is not {exact}");
    }

    let [d11, d12, d33] = model.elasticity();
    let [[xx, xy], [yx, yy]] = GRADIENT;
    let stress = [d11 * xx + d12 * yy, d12 * xx + d11 * yy, d33 * (xy + yx)];
    for element in 0..mesh.elements.len() {
        for (xi, eta) in [(0.0, 0.0), (-1.0, 1.0), (0.7, -0.3)] {
            let found = model.stress(ElementPoint { element, xi, eta }, &solved);
            for (found, stress) in found.iter().zip(&stress) {
                assert!(
                    (found - stress).abs() < TOLERANCE * d11 * 1e-2,
                    "{name}: stress {found} is not {stress}"
                );
            }
        }
    }

    // The tractions of the constant stress balance it: loads and stiffness integrate alike.
    let load = model.edge_load(rim, |_, point| {
        let [x, y] = point.normal;
        [stress[0] * x + stress[2] * y, stress[2] * x + stress[1] * y]
    });
    let mut residual = load.to_full(model.dof_count());
    for entry in stiffness.triplet_iter() {
        residual[entry.row] -= entry.val * exact[entry.col];
    }
    let worst = residual.iter().map(|value| value.abs()).fold(0.0, f64::max);
    assert!(worst < TOLERANCE * d11 * 1e-3, "{name}: residual {worst}");
}

#[test]
fn constant_strain_of_every_order_and_coordinate_order() {
    for order in 1..=3 {
        for coordinates in 1..=3 {
            let mesh = square([ElementOrder::full(order); 4], Some(ElementOrder::full(coordinates)), 0.0);
            check(&format!("order {order}, coordinates {coordinates}"), mesh);
        }
    }
}

#[test]
fn constant_strain_across_mixed_orders() {
    let [one, two, three] = [1, 2, 3].map(ElementOrder::full);
    let anisotropic = ElementOrder { sides: [3, 2, 3, 2], interior: [3, 2] };
    let uneven = ElementOrder { sides: [1, 2, 3, 1], interior: [2, 3] };
    let cases = [
        [one, two, three, one],
        [three, one, one, two],
        [ElementOrder::serendipity(2), two, ElementOrder::serendipity(3), three],
        [anisotropic, uneven, one, anisotropic],
    ];
    for orders in cases {
        // Straight with linear coordinates, and curved with coordinates of the order of the
        // displacements.
        check(&format!("{orders:?}"), square(orders, Some(ElementOrder::LINEAR), 0.0));
        check(&format!("{orders:?}, curved"), square(orders, None, 0.3));
    }
}

#[test]
fn constant_strain_where_coordinates_are_simpler_than_displacements() {
    for (order, coordinates) in [(2, 1), (3, 1), (3, 2), (2, 2), (3, 3)] {
        let mesh = square([ElementOrder::full(order); 4], Some(ElementOrder::full(coordinates)), 0.4);
        check(&format!("curved, order {order}, coordinates {coordinates}"), mesh);
    }
}
