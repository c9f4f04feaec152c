//! Constraints: rigid elements, weighted averages, equations, and their errors.

use crate::meshes::{BASIC, assert_close, block, clamped, load, nodes, rotated};
use calyx_elastic::assembly::System;
use calyx_elastic::constraint::Expansion;
use calyx_elastic::model::{Components, SolidShape};
use calyx_elastic::{Constraint, ElasticModel, Resources, statics};

const TRANSLATIONS: Components = [true, true, true, false, false, false];

/// Returns a model of nodes without elements.
fn points(positions: &[[f64; 3]]) -> ElasticModel {
    ElasticModel { nodes: nodes(positions), ..ElasticModel::default() }
}

/// Returns the coefficient of a component of a node in a dependent one.
fn coefficient(expansion: &Expansion, dependent: [usize; 2], of: [usize; 2]) -> f64 {
    let terms = expansion.of(6 * dependent[0] + dependent[1]).expect("dependent");
    terms.entries.iter().find(|entry| entry.0 == 6 * of[0] + of[1]).map_or(0.0, |entry| entry.1)
}

#[test]
fn rigid_element_transfers_rotation_by_the_lever() {
    let mut model = points(&[[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]);
    // The dependent node has axes rotated by 90 degrees about z.
    model.nodes[1].axes = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    model.constraints.push(Constraint::Rigid { label: 7, reference: 0, dependents: vec![(1, [true; 6])] });
    let expansion = Expansion::new(&model).expect("valid");
    // u_y = u_y0 + theta_z x - theta_x z is its first component.
    for (component, expected) in [0.0, 1.0, 0.0, -3.0, 0.0, 1.0].into_iter().enumerate() {
        assert_eq!(coefficient(&expansion, [1, 0], [0, component]), expected);
    }
    // Its second component is -u_x = -(u_x0 + theta_y z - theta_z y).
    for (component, expected) in [-1.0, 0.0, 0.0, 0.0, -3.0, 2.0].into_iter().enumerate() {
        assert_eq!(coefficient(&expansion, [1, 1], [0, component]), expected);
    }
    assert_eq!(coefficient(&expansion, [1, 3], [0, 4]), 1.0);
}

#[test]
fn weighted_average_of_a_square() {
    // Corners of a square of half edge a about the reference node, unit weights.
    let a = 0.5;
    let corners = [[a, a, 0.0], [-a, a, 0.0], [-a, -a, 0.0], [a, -a, 0.0]];
    let mut model = points(&[corners.as_slice(), &[[0.0; 3]]].concat());
    let terms = (0..4).map(|node| (1.0, node, TRANSLATIONS)).collect();
    model.constraints.push(Constraint::WeightedAverage {
        label: 1,
        reference: 4,
        components: [true; 6],
        terms,
    });
    let expansion = Expansion::new(&model).expect("valid");
    for (node, [x, y, _]) in corners.into_iter().enumerate() {
        for axis in 0..3 {
            assert_close(coefficient(&expansion, [4, axis], [node, axis]), 0.25, 1e-13);
        }
        // theta_z = sum (x u_y - y u_x) / sum r^2; sum r^2 = 8 a^2, sum y^2 = 4 a^2.
        assert_close(coefficient(&expansion, [4, 5], [node, 0]), -y / (8.0 * a * a), 1e-13);
        assert_close(coefficient(&expansion, [4, 5], [node, 1]), x / (8.0 * a * a), 1e-13);
        assert_close(coefficient(&expansion, [4, 3], [node, 2]), y / (4.0 * a * a), 1e-13);
        assert_close(coefficient(&expansion, [4, 4], [node, 2]), -x / (4.0 * a * a), 1e-13);
    }
}

#[test]
fn weighted_average_distributes_forces_like_fasteners() {
    // Weights 1 and 3 at x = 0 and 4, and 0.5 each at two points across, which do not share a force
    // along y through the centre: the centre of the weights is at x = 2.6.
    let positions = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 1.0, 0.0], [2.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let weights = [1.0, 3.0, 0.5, 0.5];
    let mut model = points(&positions);
    let terms = (0..4).map(|node| (weights[node], node, TRANSLATIONS)).collect();
    model.constraints.push(Constraint::WeightedAverage {
        label: 1,
        reference: 4,
        components: [true; 6],
        terms,
    });
    let expansion = Expansion::new(&model).expect("valid");
    // A load on the reference node gives an equivalent system of forces: same resultants.
    for component in 0..6 {
        let force = |node: usize| [0, 1, 2].map(|axis| coefficient(&expansion, [4, component], [node, axis]));
        let (mut sum, mut moment) = ([0.0; 3], [0.0; 3]);
        for (node, &at) in positions.iter().enumerate().take(4) {
            let f = force(node);
            let arm = [0, 1, 2].map(|axis| at[axis] - positions[4][axis]);
            for axis in 0..3 {
                sum[axis] += f[axis];
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                moment[axis] += arm[next] * f[last] - arm[last] * f[next];
            }
        }
        for axis in 0..3 {
            let expected = [axis == component, axis + 3 == component].map(|is| f64::from(u8::from(is)));
            assert!((sum[axis] - expected[0]).abs() < 1e-13, "{component}: {sum:?}");
            assert!((moment[axis] - expected[1]).abs() < 1e-13, "{component}: {moment:?}");
        }
    }
}

#[test]
fn rotations_of_averaged_nodes_have_the_weight_of_their_mean_distance() {
    // Two nodes at distance b on both sides, with rotations: about x, the translations along y and
    // z give nothing, and the rotations are averaged; about z, both resist.
    let b = 2.0;
    let mut model = points(&[[b, 0.0, 0.0], [-b, 0.0, 0.0], [0.0; 3]]);
    let terms = vec![(1.0, 0, [true; 6]), (1.0, 1, [true; 6])];
    model.constraints.push(Constraint::WeightedAverage {
        label: 1,
        reference: 2,
        components: [true; 6],
        terms,
    });
    let expansion = Expansion::new(&model).expect("valid");
    assert_close(coefficient(&expansion, [2, 3], [0, 3]), 0.5, 1e-13);
    // theta_z: rows x u_y / b with weight 1 and theta_z with weight b^2: sum of squares 4 b^2.
    assert_close(coefficient(&expansion, [2, 5], [0, 5]), 0.25, 1e-13);
    assert_close(coefficient(&expansion, [2, 5], [0, 1]), 0.25 / b, 1e-13);
}

#[test]
fn nested_constraints_and_equations() {
    let mut model = points(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
    model
        .constraints
        .push(Constraint::Equation { label: 1, terms: vec![(2, 0, 2.0), (1, 0, -4.0), (0, 1, 6.0)] });
    model.constraints.push(Constraint::Rigid { label: 2, reference: 0, dependents: vec![(1, TRANSLATIONS)] });
    let expansion = Expansion::new(&model).expect("valid");
    assert_eq!(coefficient(&expansion, [2, 0], [0, 0]), 2.0);
    assert_eq!(coefficient(&expansion, [2, 0], [0, 1]), -3.0);
}

#[test]
fn contradicting_constraints_are_rejected() {
    let rigid = |label, reference, node| Constraint::Rigid {
        label,
        reference,
        dependents: vec![(node, TRANSLATIONS)],
    };
    let line = (0..2).map(|node| (1.0, node, TRANSLATIONS)).collect();
    let cases = [
        (vec![rigid(1, 0, 1), rigid(2, 2, 1)], "constraints 1 and 2 both determine component 1 of node 2"),
        (vec![rigid(1, 0, 1), rigid(2, 1, 0)], "depends on itself"),
        (
            vec![Constraint::WeightedAverage { label: 3, reference: 2, components: [true; 6], terms: line }],
            "constraint 3: the averaged nodes do not determine component 4 of node 3",
        ),
        (vec![Constraint::Equation { label: 4, terms: vec![(0, 0, 0.0)] }], "the first coefficient"),
    ];
    for (constraints, expected) in cases {
        let mut model = points(&[[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]]);
        model.constraints = constraints;
        let error = Expansion::new(&model).expect_err(expected);
        assert!(error.message.contains(expected), "{error}");
        assert!(!error.help.is_empty());
    }
}

#[test]
fn displacement_axes_and_rotation_of_the_body_change_nothing() {
    let solve = |rotate: bool, axes: bool| {
        let turn = |vector: [f64; 3]| if rotate { rotated(vector) } else { vector };
        let mut model = block(SolidShape::Hexahedron8, [2, 2, 3], turn);
        let top: Vec<usize> = (27..36).collect();
        model.nodes.push(calyx_elastic::Node { label: 100, position: turn([1.0, 1.0, 3.5]), axes: BASIC });
        let reference = model.nodes.len() - 1;
        let terms = top.into_iter().map(|node| (1.0, node, TRANSLATIONS)).collect();
        model.constraints.push(Constraint::WeightedAverage {
            label: 1,
            reference,
            components: [true; 6],
            terms,
        });
        model.fixed.extend(
            (0..9).map(|node| calyx_elastic::FixedComponents { components: TRANSLATIONS, ..clamped(node) }),
        );
        if axes {
            for node in &mut model.nodes {
                node.axes = [turn(BASIC[0]), turn(BASIC[1]), turn(BASIC[2])];
            }
        }
        let [force, moment] = [[1e6, 2e6, -3e6], [4e6, 5e6, 6e6]].map(turn);
        let loads = vec![load(reference, [force[0], force[1], force[2], moment[0], moment[1], moment[2]])];
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        statics::solve(&system, &[loads], &resources).expect("supported").remove(0).displacements[reference]
    };
    let (plain, turned) = (solve(false, false), solve(true, true));
    for component in 0..6 {
        assert_close(turned[component], plain[component], 1e-9);
    }
    let basic = solve(true, false);
    let vectors = [rotated([plain[0], plain[1], plain[2]]), rotated([plain[3], plain[4], plain[5]])];
    for component in 0..6 {
        assert_close(basic[component], vectors[component / 3][component % 3], 1e-9);
    }
}
