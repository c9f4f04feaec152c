//! Motions of nodes within an elastic body from its condensed unknowns: against harmonic solutions
//! of the whole body.

use crate::bars::bar;
use calyx_elastic::assembly::System;
use calyx_elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_elastic::{ElasticModel, FixedComponents, NodalLoad, Resources};
use calyx_model::elastic_body::{ElasticBody, FiniteElementBody, MassReduction};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::Key;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use std::sync::Arc;

fn attachments() -> [Attachment; 3] {
    let at = |name: &str, x: f64, connection| Attachment {
        name: name.into(),
        position: None,
        region: Region::Plane { origin: [x, 0.0, 0.0], normal: [1.0, 0.0, 0.0], tolerance: 1e-9 },
        connection,
    };
    [
        at("left", 0.0, Connection::Rigid),
        at("middle", 0.15, Connection::Average),
        at("right", 0.3, Connection::Rigid),
    ]
}

/// Loads on the first two attachments; the last one is fixed.
const LOADS: [f64; 12] = [100.0, -30.0, 20.0, 1.0, 0.5, -2.0, 10.0, 70.0, -40.0, 0.0, 3.0, 1.0];

/// Displacements of all nodes of the whole body under harmonic loads.
fn whole(frequency: f64) -> Vec<[f64; 6]> {
    let mut model: ElasticModel = bar([8, 2, 2], 1.0);
    let nodes: Vec<usize> =
        attachments().iter().map(|own| attach(&mut model, own).expect("attached")[0]).collect();
    model.fixed.push(FixedComponents { node: nodes[2], components: [true; 6], value: 0.0 });
    let resources = Resources::default();
    let system = System::new(&model, &resources).expect("valid");
    let mass = system.mass(&resources).expect("a mass");
    let dofs = system.unknowns();
    let entry = |matrix: &faer::sparse::SparseColMat<usize, f64>, row: usize, column: usize| {
        matrix.get(dofs[row], dofs[column]).copied().unwrap_or(0.0)
    };
    let square = (TAU * frequency).powi(2);
    let dynamic = DMatrix::from_fn(dofs.len(), dofs.len(), |row, column| {
        entry(&system.stiffness, row, column) - square * entry(&mass, row, column)
    });
    let load = |at: usize| NodalLoad {
        node: nodes[at],
        load: std::array::from_fn(|component| LOADS[6 * at + component]),
    };
    let all = system.loads(&[load(0), load(1)]).expect("loads");
    let right = DVector::from_fn(dofs.len(), |row, _| all[dofs[row]]);
    let solved = dynamic.lu().solve(&right).expect("no resonance");
    let mut independent = vec![0.0; system.dof_count()];
    dofs.iter().zip(solved.iter()).for_each(|(&dof, value)| independent[dof] = *value);
    system.expand(&independent).chunks_exact(6).map(|node| std::array::from_fn(|k| node[k])).collect()
}

/// Displacements of nodes from the condensed equations and the shapes of the unknowns.
fn condensed(frequency: f64, highest: f64, nodes: &[usize]) -> Vec<[f64; 3]> {
    let mut body = FiniteElementBody::new(Arc::new(bar([8, 2, 2], 1.0)), Key::of("bar").finish());
    for attachment in attachments() {
        body.attach(&attachment).expect("an attachment");
    }
    let (mass, interrupt) = (MassReduction::ComponentModes(highest), Interrupt::never());
    let matrices = body.condense(mass, &interrupt).expect("condensed");
    let shapes = body.motion_shapes(mass, nodes, &interrupt).expect("condensed").expect("a mesh");
    let modes = matrices.modes.count();
    assert_eq!(shapes.eigenvalues, matrices.modes.eigenvalues);
    assert_eq!(shapes.coupling, matrices.modes.coupling);
    assert_eq!(shapes.displacements.len(), 18 + modes);
    // The last attachment is fixed.
    let (square, size) = ((TAU * frequency).powi(2), 12 + modes);
    let attached = |matrix: &[f64], row: usize, column: usize| matrix[18 * row + column];
    let dynamic =
        DMatrix::from_fn(size, size, |row, column| match (row.checked_sub(12), column.checked_sub(12)) {
            (None, None) => {
                attached(&matrices.stiffness, row, column) - square * attached(&matrices.mass, row, column)
            }
            (None, Some(mode)) => -square * matrices.modes.coupling[modes * row + mode],
            (Some(mode), None) => -square * matrices.modes.coupling[modes * column + mode],
            (Some(one), Some(other)) if one == other => matrices.modes.eigenvalues[one] - square,
            _ => 0.0,
        });
    let right = DVector::from_fn(size, |row, _| if row < 12 { LOADS[row] } else { 0.0 });
    let solved = dynamic.lu().solve(&right).expect("no resonance");
    let at = |node: usize| {
        let mut sum = [0.0; 3];
        for (unknown, value) in solved.iter().enumerate() {
            let shape = shapes.displacements[if unknown < 12 { unknown } else { unknown + 6 }][node];
            (0..3).for_each(|k| sum[k] += value * shape[k]);
        }
        sum
    };
    (0..nodes.len()).map(at).collect()
}

/// Below the highest frequency of the component modes, the nodes move as in the whole body. Static
/// shapes are exact up to the condition of the stiffness matrix. Modes from 8000 Hz on are omitted;
/// pseudo-modes reduce their error, of the order (f / 8000 Hz)², to less than a seventh.
#[test]
fn nodes_move_as_in_a_harmonic_solution_of_the_whole_body() {
    let count = bar([8, 2, 2], 1.0).nodes.len();
    let nodes: Vec<usize> = (0..count).collect();
    for (frequency, tolerance) in [(0.0, 1e-8), (300.0, 2e-4), (1500.0, 2e-3), (3500.0, 5e-3)] {
        let expected = whole(frequency);
        let found = condensed(frequency, 8000.0, &nodes);
        let size = |moved: &[f64]| moved.iter().map(|part| part * part).sum::<f64>();
        let largest = expected.iter().take(count).map(|moved| size(&moved[..3])).fold(0.0, f64::max).sqrt();
        for (found, expected) in found.iter().zip(&expected) {
            let difference = size(&[0, 1, 2].map(|k: usize| found[k] - expected[k])).sqrt();
            assert!(difference < tolerance * largest, "{frequency} Hz: {:e}", difference / largest);
        }
    }
}

/// Without component modes there are the static shapes, and nodes may be few.
#[test]
fn static_shapes_carry_rigid_motions() {
    let mut body = FiniteElementBody::new(Arc::new(bar([4, 1, 1], 1.0)), Key::of("bar").finish());
    for attachment in attachments() {
        body.attach(&attachment).expect("an attachment");
    }
    let shapes = body.motion_shapes(MassReduction::Static, &[3, 7], &Interrupt::never());
    let shapes = shapes.expect("condensed").expect("a mesh");
    assert_eq!((shapes.displacements.len(), shapes.eigenvalues.len()), (18, 0));
    for axis in 0..3 {
        for node in 0..2 {
            let moved: [f64; 3] = std::array::from_fn(|k| {
                (0..3).map(|own| shapes.displacements[6 * own + axis][node][k]).sum()
            });
            for (k, part) in moved.into_iter().enumerate() {
                assert!((part - f64::from(u8::from(k == axis))).abs() < 1e-9, "{moved:?}");
            }
        }
    }
}
