//! Condensation onto attachment nodes against the uncondensed body.

use crate::attachments::ring;
use crate::meshes::{assert_close, block, load, rotated};
use calyx_elastic::assembly::System;
use calyx_elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_elastic::condensation::{CondensedBody, Synthesis, component_modes, static_condensation};
use calyx_elastic::model::SolidShape;
use calyx_elastic::modes::{Request, natural_modes};
use calyx_elastic::{ElasticModel, Element, ElementKind, FixedComponents, NodalLoad, Resources, statics};
use faer::Mat;
use faer::linalg::solvers::Solve;
use nalgebra::DMatrix;

const RESOURCES: fn() -> Resources = Resources::default;

/// Returns a bar along z with attachment nodes at both ends; `moved` places it.
fn bar(connections: [Connection; 2], moved: impl Fn([f64; 3]) -> [f64; 3]) -> (ElasticModel, Vec<usize>) {
    let mut model =
        block(SolidShape::Hexahedron20, [2, 2, 6], |[x, y, z]| moved([0.02 * x, 0.03 * y, 0.05 * z]));
    let mut nodes = Vec::new();
    for (k, connection) in connections.into_iter().enumerate() {
        let at = 0.3 * k as f64;
        let origin = moved([0.02, 0.03, at]);
        let [tip, root] = [moved([0.0, 0.0, 1.0]), moved([0.0; 3])];
        let normal = [0, 1, 2].map(|axis| tip[axis] - root[axis]);
        let attachment = Attachment {
            name: format!("end {k}"),
            position: Some(origin),
            region: Region::Plane { origin, normal, tolerance: 1e-9 },
            connection,
        };
        nodes.push(attach(&mut model, &attachment).expect("attached")[0]);
    }
    (model, nodes)
}

/// Returns the pairs of connections that are tested.
fn pairs() -> [[Connection; 2]; 3] {
    use Connection::{Average, Rigid};
    [[Rigid, Rigid], [Rigid, Average], [Average, Average]]
}

/// Adds a spring to each component of a node against ground.
fn ground(model: &mut ElasticModel, node: usize, stiffness: [f64; 6]) {
    for (component, stiffness) in stiffness.into_iter().enumerate() {
        let kind = ElementKind::Spring { components: [component; 2], stiffness };
        model.elements.push(Element {
            label: 9000 + component as u64,
            kind,
            nodes: vec![node],
            material: None,
        });
    }
}

const SPRINGS: [[f64; 6]; 2] = [[1e9, 2e9, 3e9, 4e5, 5e5, 6e5], [7e8, 8e8, 9e8, 3e5, 2e5, 1e5]];

/// Returns the condensed matrix with springs at the attachments.
fn sprung(body: &CondensedBody, matrix: &Mat<f64>) -> Mat<f64> {
    let mut matrix = matrix.clone();
    for k in 0..body.components.len() {
        matrix[(k, k)] += SPRINGS[k / 6][k % 6];
    }
    matrix
}

#[test]
fn static_condensation_is_exact() {
    for connections in pairs() {
        let (mut model, ends) = bar(connections, |at| at);
        let cases = [
            vec![load(ends[0], [1e3, 2e3, 3e3, 10.0, 20.0, 30.0])],
            vec![load(40, [1e3, -2e3, 3e3, 0.0, 0.0, 0.0]), load(77, [0.0, 1e3, 0.0, 0.0, 0.0, 0.0])],
        ];
        let resources = RESOURCES();
        let system = System::new(&model, &resources).expect("valid");
        let condensed = static_condensation(&system, &ends, &cases, &resources).expect("condensed");
        assert_eq!(condensed.components.len(), 12);
        // Rigid-body motions cause no force.
        let values = DMatrix::from_fn(12, 12, |i, j| condensed.stiffness[(i, j)]).symmetric_eigenvalues();
        let largest = values.amax();
        assert_eq!(values.iter().filter(|value| value.abs() < 1e-9 * largest).count(), 6, "{values}");
        let found = sprung(&condensed, &condensed.stiffness).partial_piv_lu().solve(&condensed.loads);
        for (k, &end) in ends.iter().enumerate() {
            ground(&mut model, end, SPRINGS[k]);
        }
        let system = System::new(&model, &resources).expect("valid");
        let whole = statics::solve(&system, &cases, &resources).expect("supported");
        for (case, solution) in whole.iter().enumerate() {
            let scale = [0, 3].map(|first| {
                let of = |node: &[f64; 6]| node[first..first + 3].iter().fold(0.0_f64, |m, x| m.max(x.abs()));
                ends.iter().map(|&end| of(&solution.displacements[end])).fold(0.0_f64, f64::max)
            });
            for (k, &(node, component)) in condensed.components.iter().enumerate() {
                let error = (found[(k, case)] - solution.displacements[node][component]).abs();
                assert!(
                    error < 1e-9 * scale[component / 3],
                    "{case} {k}: {:e}",
                    error / scale[component / 3]
                );
            }
            // Displacements conjugate to the cases themselves.
            for (other, loads) in cases.iter().enumerate() {
                let moved = |load: &NodalLoad| -> f64 {
                    let by = solution.displacements[load.node];
                    load.load.iter().zip(by).map(|(force, moved)| force * moved).sum()
                };
                let expected: f64 = loads.iter().map(moved).sum();
                let by_motion: f64 =
                    (0..12).map(|row| condensed.loads[(row, other)] * found[(row, case)]).sum();
                assert_close(by_motion + condensed.between_loads[(other, case)], expected, 1e-9);
            }
        }
    }
}

#[test]
fn prescribed_displacements_act_through_the_condensed_loads() {
    use Connection::Rigid;
    let (mut model, ends) = bar([Rigid, Rigid], |at| at);
    let far = ends[1];
    // The second end is attached to ground by a spring that is displaced with the first end fixed.
    model.fixed.push(FixedComponents { node: ends[0], components: [true; 6], value: 1e-5 });
    let resources = RESOURCES();
    let system = System::new(&model, &resources).expect("valid");
    let condensed = static_condensation(&system, &[far], &[vec![]], &resources).expect("condensed");
    let found = condensed.stiffness.partial_piv_lu().solve(&condensed.loads);
    let whole = statics::solve(&system, &[vec![]], &resources).expect("supported").remove(0);
    for component in 0..6 {
        assert_close(found[(component, 0)], whole.displacements[far][component], 1e-9);
    }
}

/// Returns the lowest natural frequencies of a condensed body on springs.
fn condensed_frequencies(body: &CondensedBody) -> Vec<f64> {
    let count = body.unknown_count();
    let mass = body.mass.as_ref().expect("a mass");
    let stiffness = sprung(body, &body.stiffness);
    let factor = DMatrix::from_fn(count, count, |i, j| mass[(i, j)]).cholesky().expect("definite").l();
    let right = factor.solve_lower_triangular(&DMatrix::from_fn(count, count, |i, j| stiffness[(i, j)]));
    let reduced = factor.solve_lower_triangular(&right.expect("regular").transpose()).expect("regular");
    let mut values: Vec<f64> =
        (0.5 * (&reduced + reduced.transpose())).symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values.into_iter().map(|value| value.max(0.0).sqrt() / std::f64::consts::TAU).collect()
}

#[test]
fn component_modes_reproduce_the_modes_of_the_whole() {
    let cut_off = 30e3;
    for connections in pairs() {
        let (model, ends) = bar(connections, |at| at);
        let mut whole = model.clone();
        for (k, &end) in ends.iter().enumerate() {
            ground(&mut whole, end, SPRINGS[k]);
        }
        let resources = RESOURCES();
        let system = System::new(&whole, &resources).expect("valid");
        let mass = system.mass(&resources).expect("valid");
        let exact =
            natural_modes(&system, &mass, Request::Below(0.5 * cut_off), &resources).expect("converges");
        let exact = exact.frequencies();
        assert!(exact.len() >= 10, "{exact:?}");
        let free = System::new(&model, &resources).expect("valid");
        for synthesis in [Synthesis::FixedInterface, Synthesis::FreeInterface] {
            let body = component_modes(&free, &ends, &[], synthesis, cut_off, &resources).expect("condensed");
            let found = condensed_frequencies(&body);
            for (k, expected) in exact.iter().enumerate() {
                assert!(
                    (found[k] / expected - 1.0).abs() < 1e-3,
                    "{synthesis:?} {k}: {} {expected}",
                    found[k]
                );
            }
        }
    }
}

#[test]
fn component_modes_keep_the_static_solution_and_the_rigid_mass() {
    for connections in pairs() {
        let (model, ends) = bar(connections, |at| at);
        let resources = RESOURCES();
        let system = System::new(&model, &resources).expect("valid");
        let cases = [vec![load(ends[1], [1e3, 2e3, 3e3, 10.0, 20.0, 30.0])]];
        let exact = static_condensation(&system, &ends, &cases, &resources).expect("condensed");
        let reference = sprung(&exact, &exact.stiffness).partial_piv_lu().solve(&exact.loads);
        let mass = system.mass(&resources).expect("valid");
        let rigid = system.rigid_mass(&mass, [0.0; 3])[(0, 0)];
        for synthesis in [Synthesis::FixedInterface, Synthesis::FreeInterface] {
            let body =
                component_modes(&system, &ends, &cases, synthesis, 20e3, &resources).expect("condensed");
            let found = sprung(&body, &body.stiffness).partial_piv_lu().solve(&body.loads);
            let scale = (0..12).fold(0.0_f64, |m, k| m.max(reference[(k, 0)].abs()));
            for k in 0..12 {
                let error = (found[(k, 0)] - reference[(k, 0)]).abs();
                assert!(error < 1e-9 * scale, "{synthesis:?} {k}: {:e}", error / scale);
            }
            // The recovered motion of the attachment nodes is that of the unknowns.
            let unknowns: Vec<f64> = (0..body.unknown_count()).map(|k| found[(k, 0)]).collect();
            let moved = body.displacements(&system, &unknowns).expect("shapes");
            for (k, &(node, component)) in body.components.iter().enumerate() {
                assert!((moved[node][component] - unknowns[k]).abs() < 1e-9 * scale);
            }
            // Translation along x: both ends by one; the modal coordinates by equilibrium without
            // load.
            let translation =
                DMatrix::from_fn(body.unknown_count(), 1, |k, _| f64::from(u8::from(k == 0 || k == 6)));
            let matrix = body.mass.as_ref().expect("a mass");
            let mass = DMatrix::from_fn(body.unknown_count(), body.unknown_count(), |i, j| matrix[(i, j)]);
            if synthesis == Synthesis::FixedInterface {
                assert_close((translation.transpose() * mass * translation)[(0, 0)], rigid, 1e-9);
            }
        }
    }
}

#[test]
fn condensation_is_invariant_under_rotation_of_the_body() {
    use Connection::{Average, Rigid};
    let resources = RESOURCES();
    let condensed = |turn: bool| {
        let moved = |at: [f64; 3]| if turn { rotated(at) } else { at };
        let (mut model, ends) = bar([Rigid, Average], moved);
        if turn {
            for &end in &ends {
                model.nodes[end].axes = crate::meshes::BASIC.map(rotated);
            }
        }
        let system = System::new(&model, &resources).expect("valid");
        let exact = static_condensation(&system, &ends, &[], &resources).expect("condensed").stiffness;
        let body = component_modes(&system, &ends, &[], Synthesis::FixedInterface, 20e3, &resources);
        (exact, body.expect("condensed"))
    };
    let ((one, first), (other, second)) = (condensed(false), condensed(true));
    for i in 0..12 {
        for j in 0..12 {
            let scale = (one[(i, i)] * one[(j, j)]).sqrt();
            assert!((one[(i, j)] - other[(i, j)]).abs() < 1e-9 * scale);
        }
    }
    assert_eq!(first.eigenvalues.len(), second.eigenvalues.len());
    for (a, b) in first.eigenvalues.iter().zip(&second.eigenvalues) {
        assert_close(*a, *b, 1e-8);
    }
}

#[test]
fn averaged_seats_support_a_free_ring() {
    // The ring is supported by its average alone; the outer surface is loaded.
    let mut model = ring(12);
    let used: Vec<usize> = model.elements.iter().flat_map(|element| element.nodes.clone()).collect();
    let surface = |model: &ElasticModel, radius: f64| -> Vec<u64> {
        let region = Region::Cylinder {
            origin: [0.0; 3],
            axis: [0.0, 0.0, 1.0],
            radius,
            heights: [0.0, 1.0],
            tolerance: 1e-9,
        };
        let nodes = region.nodes(model).expect("nodes").into_iter();
        nodes.filter(|node| used.contains(node)).map(|node| model.nodes[node].label).collect()
    };
    let mut nodes = Vec::new();
    for radius in [1.0, 2.0] {
        let region = Region::Labels(surface(&model, radius));
        let connection = Connection::Average;
        let attachment =
            Attachment { name: radius.to_string(), position: Some([0.0, 0.0, 0.5]), region, connection };
        nodes.push(attach(&mut model, &attachment).expect("attached")[0]);
    }
    let resources = RESOURCES();
    let condense = |model: &ElasticModel, nodes: &[usize]| {
        let system = System::new(model, &resources).expect("valid");
        let body = static_condensation(&system, nodes, &[], &resources).expect("condensed");
        DMatrix::from_fn(body.components.len(), body.components.len(), |i, j| body.stiffness[(i, j)])
    };
    let both = condense(&model, &nodes);
    // Fixing the first average by springs that dominate gives the stiffness of the second one.
    ground(&mut model, nodes[0], [1e18; 6]);
    let second = condense(&model, &nodes[1..]);
    for i in 0..6 {
        assert_close(second[(i, i)], both[(6 + i, 6 + i)], 1e-5);
    }
}
