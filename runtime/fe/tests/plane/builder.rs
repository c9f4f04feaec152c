//! Meshes from blocks: what conforms is merged, what does not is refused.

use crate::plane::distance;
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, MeshError, PlaneMesh, Side, graded, uniform};
use std::f64::consts::FRAC_PI_2;

/// A whole ring of four blocks with different orders.
fn ring(orders: [u8; 4]) -> PlaneMesh {
    let mut builder = MeshBuilder::new();
    for (quarter, order) in orders.into_iter().enumerate() {
        let (from, to) = (FRAC_PI_2 * quarter as f64, FRAC_PI_2 * (quarter + 1) as f64);
        let radial = |angle: f64| Curve::new(move |u| [(1.0 + u) * angle.cos(), (1.0 + u) * angle.sin()]);
        let block = Block::new(
            radial(from),
            Curve::arc([0.0; 2], 2.0, from, to),
            radial(to),
            Curve::arc([0.0; 2], 1.0, from, to),
        )
        .divided(uniform(2), graded(3, 0.5))
        .order(ElementOrder::full(order))
        .named(Side::Left, "bore")
        .named(Side::Right, "rim");
        builder.block(block);
    }
    builder.finish(ElementOrder::LINEAR).expect("the blocks conform")
}

#[test]
fn blocks_share_the_nodes_of_their_common_sides() {
    for order in 1..=3_usize {
        let mesh = ring([order as u8; 4]);
        assert_eq!(mesh.elements.len(), 4 * 6);
        assert_eq!(mesh.nodes.len(), (2 * order + 1) * 12 * order, "order {order}");
        for (index, a) in mesh.nodes.iter().enumerate() {
            assert!(mesh.nodes[..index].iter().all(|b| distance(*a, *b) > 1e-3), "two nodes at {a:?}");
        }
    }
}

#[test]
fn elements_of_different_order_share_all_nodes_of_a_side() {
    let mesh = ring([1, 3, 2, 1]);
    let (mut sides, mut shared) = (Vec::<Vec<usize>>::new(), 0);
    for element in &mesh.elements {
        for side in 0..4 {
            let mut nodes =
                element.order.side_nodes(side).iter().map(|&local| element.nodes[local]).collect::<Vec<_>>();
            nodes.sort_unstable();
            shared += usize::from(sides.contains(&nodes));
            sides.push(nodes);
        }
    }
    // Two rings of 12 elements: 12 sides between the rings, 24 across.
    assert_eq!(shared, 36);
}

#[test]
fn chains_run_end_to_end_with_the_material_on_the_left() {
    let mesh = ring([2; 4]);
    for (name, radius, turn) in [("bore", 1.0, -1.0), ("rim", 2.0, 1.0)] {
        let chain = mesh.chain(name).expect("named");
        let nodes = mesh.chain_nodes(chain);
        assert_eq!(nodes.len(), 24);
        for pair in nodes.windows(2) {
            let ([ax, ay], [bx, by]) = (mesh.nodes[pair[0]], mesh.nodes[pair[1]]);
            assert!(turn * (ax * by - ay * bx) > 0.0, "{name}");
        }
        for edge in &chain.edges {
            let point = mesh.edge_point(edge, 0.3);
            let outward =
                (point.normal[0] * point.position[0] + point.normal[1] * point.position[1]) / radius;
            assert!((outward - turn).abs() < 1e-2, "{name}");
        }
    }
}

#[test]
fn coordinates_have_an_order_of_their_own() {
    let error = |coordinates: u8| {
        let block = Block::new(
            Curve::line([1.0, 0.0], [2.0, 0.0]),
            Curve::arc([0.0; 2], 2.0, 0.0, 0.5),
            Curve::line([0.5_f64.cos(), 0.5_f64.sin()], [2.0 * 0.5_f64.cos(), 2.0 * 0.5_f64.sin()]),
            Curve::arc([0.0; 2], 1.0, 0.0, 0.5),
        )
        .named(Side::Right, "rim");
        let mut builder = MeshBuilder::new();
        let builder = builder.block(block).coordinate_order(ElementOrder::full(coordinates));
        let mesh = builder.finish(ElementOrder::LINEAR).expect("one block");
        assert_eq!(mesh.nodes.len(), 4);
        let edge = mesh.chain("rim").expect("named").edges[0];
        let radius = |t| distance(mesh.edge_point(&edge, t).position, [0.0; 2]);
        (0..=20).map(|k| (radius(-1.0 + f64::from(k) / 10.0) - 2.0).abs()).fold(0.0, f64::max)
    };
    // The error of the chord is its sagitta. Interpolation at angles h apart of a function with
    // derivatives of size 2 has an error of at most 2 max |(t - t0) ... (t - tp)| / (p + 1)!: h³ 2
    // / (9 sqrt 3) / 3, and h⁴ / 12.
    assert!((error(1) - 2.0 * (1.0 - 0.25_f64.cos())).abs() < 1e-4);
    let (half, third) = (0.5_f64 / 2.0, 0.5_f64 / 3.0);
    assert!(error(2) < half.powi(3) * 2.0 / (9.0 * 3.0_f64.sqrt()) && error(2) > 1e-5);
    assert!(error(3) < third.powi(4) / 12.0 && error(3) > 1e-7);
}

#[test]
fn gradings_grow_as_asked() {
    let at = graded(5, 3.0);
    let lengths = at.windows(2).map(|pair| pair[1] - pair[0]).collect::<Vec<_>>();
    assert_eq!((at[0], at[5]), (0.0, 1.0));
    assert!((lengths[4] / lengths[0] - 3.0).abs() < 1e-12);
    assert_eq!(graded(1, 7.0), [0.0, 1.0]);
}

fn unit_square(at: f64) -> [[f64; 2]; 4] {
    [[at, 0.0], [at + 1.0, 0.0], [at + 1.0, 1.0], [at, 1.0]]
}

fn build(blocks: Vec<Block>) -> Result<PlaneMesh, MeshError> {
    let mut builder = MeshBuilder::new();
    for block in blocks {
        builder.block(block);
    }
    builder.finish(ElementOrder::QUADRATIC)
}

#[test]
fn what_is_not_a_mesh_is_refused() {
    use MeshError::*;
    let square = |at: f64| Block::quadrilateral(unit_square(at));
    let [a, b, c, d] = unit_square(0.0);
    let bulged = Curve::new(|v| [1.0 + 0.1 * v * (1.0 - v), v]);
    let bent = Block::new(Curve::line(a, b), bulged, Curve::line(d, c), Curve::line(a, d));
    let open =
        Block::new(Curve::line(a, b), Curve::line([1.1, 0.0], c), Curve::line(d, c), Curve::line(a, d));

    assert_eq!(build(vec![]), Err(Empty));
    let divided = square(0.0).divided(vec![0.0, 0.7, 0.7, 1.0], uniform(1));
    assert_eq!(build(vec![divided]), Err(Divisions { block: 0 }));
    let overly = ElementOrder { sides: [2, 4, 2, 2], interior: [2, 2] };
    assert_eq!(build(vec![square(0.0).order(overly)]), Err(Order { block: 0 }));
    assert!(matches!(build(vec![open]), Err(OpenCorner { block: 0, .. })));
    assert!(matches!(build(vec![Block::quadrilateral([a, b, b, d])]), Err(Degenerate { block: 0, .. })));
    assert!(matches!(build(vec![bent, square(1.0)]), Err(Mismatch { blocks: [0, 1], .. })));
    assert!(matches!(build(vec![square(0.0), square(0.0), square(0.0)]), Err(Overlap { .. })));
    assert!(matches!(build(vec![square(0.0), square(0.0)]), Err(Overlap { block: 1, .. })));
    assert!(matches!(build(vec![Block::quadrilateral([a, d, c, b])]), Err(Folded { block: 0, .. })));
    let dart = [a, b, [0.2, 0.2], d];
    assert!(matches!(build(vec![Block::quadrilateral(dart)]), Err(Folded { block: 0, .. })));
    let mismatched =
        vec![square(0.0).divided(uniform(2), uniform(2)), square(1.0).divided(uniform(2), uniform(3))];
    assert!(matches!(build(mismatched), Err(Hanging { .. })));
    for profile in [[0.5, 0.5], [0.0, f64::NAN]] {
        let block = square(0.0).on_profile(Side::Top, "top", profile);
        assert_eq!(build(vec![block]), Err(EmptyProfile { block: 0, name: "top".to_owned() }));
    }
    let mixed = square(0.0).named(Side::Top, "top").on_profile(Side::Left, "top", [0.0, 1.0]);
    assert_eq!(build(vec![mixed]), Err(MixedChain { name: "top".to_owned() }));
}
