//! Elastic bodies as connections: against the uncondensed body, in other orientations, as rigid
//! bodies, with masses, and from the cache.

use crate::bars::bar;
use calyx_contact::solid::Pose;
use calyx_elastic::assembly::System;
use calyx_elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_elastic::import::{CondensedMatrices, CondensedNode};
use calyx_elastic::stress::nodal_stresses_of;
use calyx_elastic::{Constraint, ElasticModel, Element, ElementKind, FixedComponents, NodalLoad};
use calyx_elastic::{Resources as ElasticResources, statics};
use calyx_model::body::Body;
use calyx_model::connection::{ConnectionState, ElasticConnection, add_connection_stiffness};
use calyx_model::connection_building::{build_connections, connections_as_links};
use calyx_model::dof::Dof;
use calyx_model::elastic_body::{ElasticBody, FiniteElementBody, MassReduction, MatrixBody};
use calyx_model::fidelity::{Fidelity, StructureOptions};
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::{RelocatedMotion, SteadyRotation};
use calyx_model::pairs::SurfacePair;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_model::rigid::RigidBody;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::stress::von_mises;
use calyx_structure::AttachmentMatrices;
use calyx_structure::cache::{Key, OperatorCache, Store};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Rotation that takes z to x and x to y.
const TILTED: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// Seats at the ends and a foot under the middle, with these connections.
fn attachments([left, right]: [Connection; 2]) -> [Attachment; 3] {
    let end = |name: &str, x: f64, connection| Attachment {
        name: name.into(),
        position: None,
        region: Region::Plane { origin: [x, 0.0, 0.0], normal: [1.0, 0.0, 0.0], tolerance: 1e-9 },
        connection,
    };
    let foot = Attachment {
        name: "foot".into(),
        position: None,
        region: Region::Box { lowest: [0.1, -1.0, -1e-6], highest: [0.2, 1.0, 1e-6] },
        connection: Connection::Rigid,
    };
    [end("left", 0.0, left), end("right", 0.3, right), foot]
}

fn body(connections: [Connection; 2], factor: f64) -> FiniteElementBody {
    let content = Key::of("bar").number(factor).finish();
    let mut body = FiniteElementBody::new(Arc::new(bar([6, 2, 2], factor)), content);
    for attachment in attachments(connections) {
        body.attach(&attachment).expect("an attachment");
    }
    body
}

/// A scene with a body on its attachments; the foot is fixed, and the whole rotated and moved.
fn scene(body: Arc<dyn ElasticBody>, placed: Pose) -> Mechanism {
    let mut scene = Mechanism::default();
    let positions = body.positions();
    let foot = positions.len() - 1;
    for (index, position) in positions.into_iter().enumerate() {
        let at_rest = Arc::new(SteadyRotation::at_rest([0.0; 2]));
        let own = RelocatedMotion { motion: at_rest, pose: Pose { origin: position, ..Pose::IDENTITY } };
        let placed = RelocatedMotion { motion: Arc::new(own), pose: placed };
        let body = Body::new(format!("attachment {index}"), Arc::new(RigidBody), placed);
        scene.add_body(Body { free: [index != foot; 6], ..body });
    }
    let ids: Vec<BodyId> = (0..=foot).map(BodyId).collect();
    let connection = ElasticConnection::of_body("housing".into(), body, &ids, placed.origin);
    scene.add_connection(connection).expect("a connection");
    scene
}

fn plan(scene: &Mechanism, fidelity: Fidelity) -> Plan {
    Plan::whole(scene, fidelity, StructureOptions::default()).expect("a plan")
}

/// The plan with all bodies, which no contact keeps.
fn whole(scene: &Mechanism, fidelity: Fidelity) -> Plan {
    let mut plan = plan(scene, fidelity);
    plan.bodies.iter_mut().for_each(|body| body.left_out = false);
    plan.connections.iter_mut().for_each(|connection| connection.left_out = false);
    plan
}

fn built(scene: &Mechanism, plan: &Plan) -> Vec<ElasticConnection> {
    build_connections(scene, plan, &Resources::default()).expect("condensed").0
}

fn dofs() -> Vec<Dof> {
    (0..12).map(|k| Dof { body: k / 6, component: k % 6 }).collect()
}

fn stiffness(scene: &Mechanism, connections: &[ElasticConnection]) -> DMatrix<f64> {
    let mut matrix = vec![0.0; 144];
    add_connection_stiffness(&mut matrix, (&scene.bodies, connections), &[0], &dofs(), |_| 1.0, 0.0)
        .expect("a stiffness");
    DMatrix::from_row_slice(12, 12, &matrix)
}

const SPRINGS: [[f64; 6]; 2] = [[1e9, 2e9, 3e9, 4e5, 5e5, 6e5], [7e8, 8e8, 9e8, 3e5, 2e5, 1e5]];
const LOADS: [[f64; 6]; 2] = [[1e3, -2e3, 3e3, 10.0, 20.0, -30.0], [-4e3, 5e3, 600.0, 70.0, -80.0, 90.0]];

fn springs() -> DMatrix<f64> {
    DMatrix::from_diagonal(&DVector::from_iterator(12, SPRINGS.into_iter().flatten()))
}

fn displaced(scene: &Mechanism, connections: &[ElasticConnection]) -> Vec<f64> {
    let load = DVector::from_iterator(12, LOADS.into_iter().flatten());
    let matrix = stiffness(scene, connections) + springs();
    matrix.cholesky().expect("supported").solve(&load).iter().copied().collect()
}

fn close(found: &[f64], expected: &[f64], tolerance: f64) {
    for half in [0, 3] {
        let of = |values: &[f64]| -> Vec<f64> {
            values.chunks(6).flat_map(|six| six[half..half + 3].to_vec()).collect()
        };
        let (found, expected) = (of(found), of(expected));
        let scale = expected.iter().fold(0.0_f64, |scale, value| scale.max(value.abs()));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() <= tolerance * scale, "{found} instead of {expected}");
        }
    }
}

fn kinds() -> [[Connection; 2]; 3] {
    use Connection::{Average, Fourier, Rigid};
    [[Rigid, Rigid], [Rigid, Average], [Average, Fourier { axis: [1.0, 0.0, 0.0], harmonics: vec![2] }]]
}

/// Checks that the displacements of all nodes, recovered from these displacements of the seats, are
/// those of the whole body, also after a rigid-body motion of all attachments, and that they cause
/// the stresses of the whole body.
fn check_interior(
    body: &FiniteElementBody,
    scene: &Mechanism,
    connection: &ElasticConnection,
    seats: &[f64],
    whole: &[[f64; 6]],
) {
    let recovery = body.recovery(&Interrupt::never()).expect("solved").expect("a mesh");
    let state = ConnectionState::at(&scene.bodies, connection, 0.0).expect("a state");
    let motions = state.motions(&dofs(), seats);
    let deformed =
        recovery.deformed(&motions, &connection.forces_on_body(&motions, &[]), &[]).expect("valid");
    let model = body.model();
    assert_eq!(deformed.points.len(), model.nodes.len());
    assert_eq!(deformed.cells.len(), model.elements.len());
    let largest = whole[..model.nodes.len()].iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (found, expected) in deformed.displacements.iter().zip(whole) {
        for axis in 0..3 {
            let difference = (found[axis] - expected[axis]).abs();
            assert!(difference < 1e-9 * largest, "{found:?} instead of {expected:?}");
        }
    }
    let stresses = nodal_stresses_of(model, &whole[..model.nodes.len()]).expect("valid").stresses;
    let highest = stresses.iter().map(|stress| von_mises(*stress)).fold(0.0, f64::max);
    for (found, expected) in deformed.stresses.iter().zip(&stresses) {
        let difference = (0..6).map(|k| (found[k] - expected[k]).abs()).fold(0.0, f64::max);
        assert!(difference < 1e-8 * highest, "{found:?} instead of {expected:?}");
    }
    // A translation by 1 mm and a rotation by 1 mrad about the first attachment.
    let first = body.positions()[0];
    let moved: Vec<[f64; 6]> = motions
        .iter()
        .zip(body.positions())
        .map(|(motion, at)| {
            let by = [1e-3 - 1e-3 * (at[1] - first[1]), 1e-3 * (at[0] - first[0]), 0.0, 0.0, 0.0, 1e-3];
            std::array::from_fn(|k| motion[k] + by[k])
        })
        .collect();
    let displaced = recovery.deformed(&moved, &connection.forces_on_body(&moved, &[]), &[]).expect("valid");
    for ((found, own), at) in
        displaced.displacements.iter().zip(&deformed.displacements).zip(&deformed.points)
    {
        let by = [1e-3 - 1e-3 * (at[1] - first[1]), 1e-3 * (at[0] - first[0]), 0.0];
        let difference = (0..3).map(|k| (found[k] - own[k] - by[k]).abs()).fold(0.0, f64::max);
        assert!(difference < 1e-9 * 1e-3 + 1e-6 * largest, "{difference}");
    }
}

/// Displacements of the seats on springs, and their reactions, are those of the whole body.
#[test]
fn a_condensed_body_moves_like_the_whole_one() {
    // The middle of the face is a node on the axis of the Fourier surface: leave that pair out.
    for connections in [kinds()[0].clone(), kinds()[1].clone()] {
        let mut model = bar([6, 2, 2], 1.0);
        let mut nodes = Vec::new();
        for attachment in attachments(connections.clone()) {
            nodes.push(attach(&mut model, &attachment).expect("attached")[0]);
        }
        model.fixed.push(FixedComponents { node: nodes[2], components: [true; 6], value: 0.0 });
        for (node, springs) in nodes.iter().zip(SPRINGS) {
            for (component, stiffness) in springs.into_iter().enumerate() {
                let kind = ElementKind::Spring { components: [component; 2], stiffness };
                model.elements.push(Element { label: 0, kind, nodes: vec![*node], material: None });
            }
        }
        let resources = ElasticResources::default();
        let system = System::new(&model, &resources).expect("valid");
        let case = nodes.iter().zip(LOADS).map(|(&node, load)| NodalLoad { node, load }).collect();
        let solution = &statics::solve(&system, &[case], &resources).expect("supported")[0];
        let expected: Vec<f64> = nodes[..2].iter().flat_map(|&node| solution.displacements[node]).collect();

        let body = body(connections, 1.0);
        let scene = scene(Arc::new(body.clone()), Pose::IDENTITY);
        let connections = built(&scene, &whole(&scene, Fidelity::Analytic));
        let found = displaced(&scene, &connections);
        close(&found, &expected, 1e-9);
        check_interior(&body, &scene, &connections[0], &found, &solution.displacements);
        let reactions = |values: &[f64]| -> Vec<f64> {
            values.iter().zip(SPRINGS.into_iter().flatten()).map(|(value, spring)| value * spring).collect()
        };
        close(&reactions(&found), &reactions(&expected), 1e-9);
        // The reaction of the foot, which has no degree of freedom.
        let state = ConnectionState::at(&scene.bodies, &connections[0], 0.0).expect("a state");
        let push = connections[0].push(&state.motions(&dofs(), &found));
        let reaction: Vec<f64> = (0..6)
            .map(|k| {
                let of = |reaction: &&(usize, usize, f64)| reaction.0 == nodes[2] && reaction.1 == k;
                -solution.reactions.iter().find(of).expect("a reaction").2
            })
            .collect();
        close(&push[2], &reaction, 1e-8);
    }
}

/// A rotated and displaced body has the same stiffness along its own axes.
#[test]
fn the_orientation_of_a_body_does_not_matter() {
    let condensed = |placed: Pose| {
        let scene = scene(Arc::new(body(kinds()[1].clone(), 1.0)), placed);
        let connections = built(&scene, &whole(&scene, Fidelity::Analytic));
        let state = ConnectionState::at(&scene.bodies, &connections[0], 0.0).expect("a state");
        let motions: Vec<[f64; 6]> =
            (0..3).map(|k| [0, 1, 2, 3, 4, 5].map(|c| 1e-6 * f64::from(7 * k + c * c % 5))).collect();
        let forces = connections[0].push(&motions).concat();
        (forces, state.positions(), stiffness(&scene, &connections).symmetric_eigenvalues())
    };
    let placed = Pose { rotation: TILTED, origin: [0.4, -0.2, 0.7] };
    let ((forces, positions, values), (other, moved, others)) =
        (condensed(Pose::IDENTITY), condensed(placed));
    close(&other, &forces, 1e-9);
    for (one, other) in positions.iter().flatten().zip(moved.iter().flatten()) {
        assert!((one - other).abs() < 1e-12);
    }
    let ascending = |values: DVector<f64>| {
        let mut values: Vec<f64> = values.iter().copied().collect();
        values.sort_by(f64::total_cmp);
        values
    };
    for (one, other) in ascending(values).into_iter().zip(ascending(others)) {
        assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
    }
}

#[test]
fn rigid_body_motions_cause_no_force() {
    for connections in [kinds()[0].clone(), kinds()[1].clone()] {
        let scene = scene(Arc::new(body(connections, 1.0)), Pose::IDENTITY);
        for (fidelity, tolerance) in [(Fidelity::Analytic, 1e-10), (Fidelity::Rigid, 1e-13)] {
            let connections = built(&scene, &whole(&scene, fidelity));
            let state = ConnectionState::at(&scene.bodies, &connections[0], 0.0).expect("a state");
            let motion = |k: usize| -> Vec<[f64; 6]> {
                let of = |[x, y, z]: [f64; 3]| match k {
                    3 => [0.0, -z, y, 1.0, 0.0, 0.0],
                    4 => [z, 0.0, -x, 0.0, 1.0, 0.0],
                    5 => [-y, x, 0.0, 0.0, 0.0, 1.0],
                    _ => std::array::from_fn(|component| f64::from(component == k)),
                };
                state.positions().into_iter().map(of).collect()
            };
            for k in 0..6 {
                let moved = motion(k);
                let size = connections[0].size();
                let forces = connections[0].push(&moved).concat();
                for (row, force) in forces.iter().enumerate() {
                    let own = |at: usize| connections[0].stiffness[at * size + at].sqrt();
                    let terms: f64 =
                        (0..size).map(|at| own(row) * own(at) * moved[at / 6][at % 6].abs()).sum();
                    assert!(force.abs() <= tolerance * terms, "{fidelity:?} {k} {row}: {force} {terms}");
                }
            }
        }
    }
}

/// A body that is much stiffer than its springs moves like the rigid body of the lowest fidelity,
/// and like the springs alone at the foot.
#[test]
fn a_stiff_body_is_the_rigid_one() {
    let moved = |factor: f64, fidelity: Fidelity| {
        let scene = scene(Arc::new(body(kinds()[0].clone(), factor)), Pose::IDENTITY);
        displaced(&scene, &built(&scene, &whole(&scene, fidelity)))
    };
    let elastic = moved(1.0, Fidelity::Analytic);
    let stiff = moved(1e5, Fidelity::Analytic);
    let rigid = moved(1.0, Fidelity::Rigid);
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    assert!(largest(&stiff) < 1e-4 * largest(&elastic));
    assert!(largest(&rigid) < 1e-2 * largest(&elastic), "{rigid:?} {elastic:?}");
}

/// Supports of the file act on ground, at the position of the body.
#[test]
fn supports_of_the_model_are_attachments_to_ground() {
    let mut model = bar([6, 2, 2], 1.0);
    let fixed: Vec<usize> =
        Region::Box { lowest: [0.1, -1.0, -1e-6], highest: [0.2, 1.0, 1e-6] }.nodes(&model).expect("nodes");
    let components = [true, true, true, false, false, false];
    model.fixed.extend(fixed.iter().map(|&node| FixedComponents { node, components, value: 0.0 }));
    let mut grounded = FiniteElementBody::new(Arc::new(model), Key::of("grounded").finish());
    let [left, right, _] = attachments(kinds()[0].clone());
    for attachment in [left, right] {
        grounded.attach(&attachment).expect("an attachment");
    }
    for placed in [Pose::IDENTITY, Pose { rotation: TILTED, origin: [0.4, -0.2, 0.7] }] {
        let mut scene = scene(Arc::new(grounded.clone()), placed);
        scene.bodies[1].free = [true; 6];
        assert_eq!(scene.connections[0].attachments.len(), 3);
        let connections = built(&scene, &whole(&scene, Fidelity::Analytic));
        if placed == Pose::IDENTITY {
            // The foot of the other body fixes the same nodes.
            let body = Arc::new(body(kinds()[0].clone(), 1.0));
            let attached = self::scene(body, Pose::IDENTITY);
            let expected = displaced(&attached, &built(&attached, &whole(&attached, Fidelity::Analytic)));
            close(&displaced(&scene, &connections), &expected, 1e-9);
        }
    }
}

/// The condensed mass has the mass and the moments of inertia of the body under rigid motion.
#[test]
fn the_condensed_mass_is_that_of_the_body() {
    let body = body(kinds()[1].clone(), 1.0);
    let matrices = body.condense(MassReduction::Static, &Interrupt::never()).expect("condensed");
    let plain = body.condense(MassReduction::None, &Interrupt::never()).expect("condensed");
    close(&matrices.stiffness, &plain.stiffness, 1e-8);
    let positions = body.positions();
    let rows = 18;
    let product = |one: &[f64], other: &[f64]| -> f64 {
        (0..rows * rows).map(|k| one[k / rows] * matrices.mass[k] * other[k % rows]).sum()
    };
    let shift: Vec<f64> = (0..rows).map(|row| f64::from(row % 6 == 1)).collect();
    let turn: Vec<f64> = positions.iter().flat_map(|[x, y, _]| [-y, *x, 0.0, 0.0, 0.0, 1.0]).collect();
    let properties = body.mass();
    let mass = 0.3 * 0.04 * 0.05 * 7850.0;
    assert!((properties.mass / mass - 1.0).abs() < 1e-12);
    assert!((product(&shift, &shift) / mass - 1.0).abs() < 1e-9);
    assert!((product(&shift, &turn) / (mass * properties.centre[0]) - 1.0).abs() < 1e-8);
    // Consistent mass of linear elements has the exact second moments of a linear displacement.
    assert!((product(&turn, &turn) / properties.inertia[2][2] - 1.0).abs() < 1e-8);
}

/// Body that fails if it is condensed.
struct Uncondensed(FiniteElementBody);

impl ElasticBody for Uncondensed {
    fn positions(&self) -> Vec<[f64; 3]> {
        self.0.positions()
    }

    fn key(&self) -> Option<Key> {
        self.0.key()
    }

    fn condense(&self, _: MassReduction, _: &Interrupt) -> Result<AttachmentMatrices, EngineError> {
        Err(EngineError::new("E0992", "condensed", ""))
    }

    fn typical_stiffness(&self) -> f64 {
        self.0.typical_stiffness()
    }

    fn typical_size(&self) -> f64 {
        self.0.typical_size()
    }
}

#[test]
fn bodies_that_are_left_out_or_checked_are_not_condensed() {
    let scene = scene(Arc::new(Uncondensed(body(kinds()[0].clone(), 1.0))), Pose::IDENTITY);
    // Without surface pairs, the scene consists of bodies on bearings and elastic connections.
    assert!(!plan(&scene, Fidelity::Analytic).connections[0].left_out);
    let mut touching = scene.clone();
    let rigid = |name: &str| Body::new(name, Arc::new(RigidBody), SteadyRotation::at_rest([0.0; 2]));
    let pair = ["first", "second"].map(|name| touching.add_body(rigid(name)));
    touching.add_pair(SurfacePair::new(pair, [0, 0]));
    let planned = plan(&touching, Fidelity::Analytic);
    // Nothing observes the body, and no load goes through it.
    assert!(planned.connections[0].left_out);
    let connections = built(&scene, &planned);
    assert!(connections[0].stiffness.is_empty());
    // Links are an upper bound of the restraints without condensation.
    let links = connections_as_links(&scene).expect("links");
    assert_eq!(links[0].stiffness.len(), 18 * 18);
    built(&scene, &whole(&scene, Fidelity::Rigid));
    let refused = build_connections(&scene, &whole(&scene, Fidelity::Analytic), &Resources::default());
    let error = refused.expect_err("condensed");
    assert_eq!((error.code, error.message.as_str()), ("E0992", "the elastic body \"housing\": condensed"));
}

#[test]
fn a_body_is_condensed_once_and_stored_on_disk() {
    let directory = tempfile::tempdir().unwrap();
    let with_store = || {
        let store = Store::new(directory.path(), 1 << 30);
        let cache = Some(Arc::new(OperatorCache::new(1 << 30).with_store(store)));
        Resources { cache, ..Resources::default() }
    };
    let scene_of = |body: FiniteElementBody| scene(Arc::new(body), Pose::IDENTITY);
    let counted = |scene: &Mechanism, resources: &Resources| {
        let (connections, counts) =
            build_connections(scene, &whole(scene, Fidelity::Analytic), resources).expect("condensed");
        (connections[0].stiffness.clone(), counts.built, counts.reused)
    };
    let scene = scene_of(body(kinds()[0].clone(), 1.0));
    let resources = with_store();
    let (first, built, reused) = counted(&scene, &resources);
    assert_eq!((built, reused), (1, 0));
    assert_eq!(counted(&scene, &resources), (first.clone(), 0, 1));
    // Another process reads the matrices from the disk.
    assert_eq!(counted(&scene, &with_store()), (first.clone(), 0, 1));
    // Another connection, another material and another orientation.
    assert_eq!(counted(&scene_of(body(kinds()[1].clone(), 1.0)), &with_store()).1, 1);
    assert_eq!(counted(&scene_of(body(kinds()[0].clone(), 2.0)), &with_store()).1, 1);
    let tilted =
        self::scene(Arc::new(body(kinds()[0].clone(), 1.0)), Pose { rotation: TILTED, origin: [0.1; 3] });
    assert_eq!(counted(&tilted, &with_store()).1, 0);
}

#[test]
fn a_condensation_is_interrupted_and_respects_the_memory_limit() {
    let scene = scene(Arc::new(body(kinds()[0].clone(), 1.0)), Pose::IDENTITY);
    let plan = whole(&scene, Fidelity::Analytic);
    let of = |interrupt: Interrupt| Resources { interrupt, ..Resources::default() };
    let stop = Interrupt::new(|| Err(EngineError::new("E0704", "stopped", "")));
    let error = build_connections(&scene, &plan, &of(stop)).expect_err("stopped");
    assert_eq!(error.code, "E0704");
    let small = Interrupt::counting(|request| match request.bytes + request.promised {
        bytes if bytes > 100_000 => Err(EngineError::new("E0707", "too large", "")),
        _ => Ok(()),
    });
    let error = build_connections(&scene, &plan, &of(small)).expect_err("too large");
    assert_eq!(error.code, "E0707");
}

/// A body of given matrices, of which one node is no attachment, moves like the elements from which
/// the matrices are.
#[test]
fn matrices_may_be_given() {
    let body = body(kinds()[0].clone(), 1.0);
    let matrices = body.condense(MassReduction::Static, &Interrupt::never()).expect("condensed");
    let matrix = |entries: &[f64]| DMatrix::from_row_slice(18, 18, entries);
    // The order of the nodes in the file is another one.
    let node = |(index, position): (usize, &[f64; 3])| CondensedNode {
        label: ["left", "right", "foot"][index].into(),
        position: Some(*position),
    };
    let given = CondensedMatrices {
        nodes: body.positions().iter().enumerate().map(node).collect(),
        components: (0..18).map(|row| (row / 6, row % 6)).collect(),
        stiffness: matrix(&matrices.stiffness),
        mass: Some(matrix(&matrices.mass)),
    };
    let given = Arc::new(given);
    let content = Key::of("given").finish();
    let mut all = MatrixBody::new(given.clone(), content);
    assert!(!all.is_grounded());
    let mut ends = all.clone();
    for label in ["left", "right", "foot"] {
        all.attach(label, label, None).expect("an attachment");
    }
    let copied = all.condense(MassReduction::Static, &Interrupt::never()).expect("copied");
    // Without further nodes there are no modes, and far above all modes no pseudo-modes.
    let modes = |body: &MatrixBody, highest: f64| {
        let reduction = MassReduction::ComponentModes(highest);
        body.condense(reduction, &Interrupt::never()).expect("condensed").modes.count()
    };
    assert_eq!(modes(&all, 1e4), 0);
    assert_eq!(modes(&all, 1e9), 0);
    close(&copied.stiffness, &matrices.stiffness, 1e-15);
    close(&copied.mass, &matrices.mass, 1e-15);

    let mut elements = FiniteElementBody::new(Arc::new(bar([6, 2, 2], 1.0)), Key::of("bar").finish());
    for (attachment, label) in attachments(kinds()[0].clone()).iter().zip(["left", "right"]) {
        elements.attach(attachment).expect("an attachment");
        ends.attach(label, label, None).expect("an attachment");
    }
    assert_eq!(modes(&ends, 1e9), 6);
    let free_foot = ends.condense(MassReduction::Static, &Interrupt::never()).expect("condensed");
    // The rigid foot stiffens the bar, so only the order of magnitude is that of the bare bar.
    let bare = elements.condense(MassReduction::Static, &Interrupt::never()).expect("condensed");
    assert!(free_foot.stiffness[0] > bare.stiffness[0] && free_foot.stiffness[0] < 2.0 * bare.stiffness[0]);
    let total = |mass: &[f64]| -> f64 {
        (0..144).filter(|k| k / 12 % 6 == 0 && k % 12 % 6 == 0).map(|k| mass[k]).sum()
    };
    assert!((total(&free_foot.mass) / total(&bare.mass) - 1.0).abs() < 1e-9);
    for (label, text) in [("top", "has no node \"top\""), ("left", "is an attachment already")] {
        let error = all.attach("seat", label, None).expect_err(text);
        assert!(error.message.contains(text) && error.code == "E0991", "{}", error.message);
    }
}

/// Natural frequencies of matrices, Hz, ascending.
fn frequencies(stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Vec<f64> {
    let lower = mass.clone().cholesky().expect("positive").l();
    let half = lower.solve_lower_triangular(stiffness).expect("regular");
    let scaled = lower.solve_lower_triangular(&half.transpose()).expect("regular");
    let mut squares: Vec<f64> = SymmetricEigen::new(scaled).eigenvalues.iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares.into_iter().map(|square| square.max(0.0).sqrt() / TAU).collect()
}

/// Matrices with the modes as further unknowns, and their springs on the first components.
fn with_modes(matrices: &AttachmentMatrices, springs: &DMatrix<f64>) -> [DMatrix<f64>; 2] {
    let (rows, modes) = (springs.nrows(), &matrices.modes);
    let size = rows + modes.count();
    let block = |matrix: &[f64]| DMatrix::from_row_slice(rows, rows, matrix).resize(size, size, 0.0);
    let mut stiffness = block(&matrices.stiffness) + springs.clone().resize(size, size, 0.0);
    let mut mass = block(&matrices.mass);
    for (mode, eigenvalue) in modes.eigenvalues.iter().enumerate() {
        stiffness[(rows + mode, rows + mode)] = *eigenvalue;
        mass[(rows + mode, rows + mode)] = 1.0;
        for row in 0..rows {
            let entry = modes.coupling[row * modes.count() + mode];
            mass[(row, rows + mode)] = entry;
            mass[(rows + mode, row)] = entry;
        }
    }
    [stiffness, mass]
}

/// A bar that is given by the matrices of seven cross-sections, of which both ends are attached,
/// has the natural frequencies of these matrices below half of the highest frequency of its modes,
/// on springs at both ends and at one.
#[test]
fn component_modes_complete_given_matrices() {
    let mut sections = FiniteElementBody::new(Arc::new(bar([6, 2, 2], 1.0)), Key::of("bar").finish());
    let stations: Vec<f64> = (0..7).map(|k| 0.05 * f64::from(k)).collect();
    for &x in &stations {
        let region = Region::Plane { origin: [x, 0.0, 0.0], normal: [1.0, 0.0, 0.0], tolerance: 1e-9 };
        let name = format!("{x}");
        let section = Attachment { name, position: None, region, connection: Connection::Rigid };
        sections.attach(&section).expect("a section");
    }
    let whole = sections.condense(MassReduction::Static, &Interrupt::never()).expect("condensed");
    let rows = 6 * stations.len();
    let matrix = |entries: &[f64]| DMatrix::from_row_slice(rows, rows, entries);
    let position = |x: &f64| CondensedNode { label: format!("{x}"), position: Some([*x, 0.02, 0.025]) };
    let given = CondensedMatrices {
        nodes: stations.iter().map(position).collect(),
        components: (0..rows).map(|row| (row / 6, row % 6)).collect(),
        stiffness: matrix(&whole.stiffness),
        mass: Some(matrix(&whole.mass)),
    };
    let mut body = MatrixBody::new(Arc::new(given), Key::of("given").finish());
    for x in [stations[0], stations[6]] {
        body.attach(&format!("{x}"), &format!("{x}"), None).expect("an end");
    }
    for springs in [
        springs(),
        DMatrix::from_diagonal(
            &springs().diagonal().map_with_location(|row, _, entry| if row < 6 { entry } else { 0.0 }),
        ),
    ] {
        let mut on_whole = DMatrix::zeros(rows, rows);
        for (k, place) in (0..6).chain(rows - 6..rows).enumerate() {
            on_whole[(place, place)] = springs[(k, k)];
        }
        let exact = frequencies(&(matrix(&whole.stiffness) + on_whole), &matrix(&whole.mass));
        let of = |reduction| {
            let matrices = body.condense(reduction, &Interrupt::never()).expect("condensed");
            let [stiffness, mass] = with_modes(&matrices, &springs);
            frequencies(&stiffness, &mass)
        };
        let highest = 40e3;
        let (by_modes, statically) = (of(MassReduction::ComponentModes(highest)), of(MassReduction::Static));
        let below: Vec<f64> = exact.iter().copied().take_while(|exact| *exact < 0.5 * highest).collect();
        assert!(below.len() > 12, "{exact:?}");
        for (found, exact) in by_modes.iter().zip(&below) {
            assert!((found / exact - 1.0).abs() < 1e-3, "{found} instead of {exact}");
        }
        // The twelve motions of the ends cannot have all of them.
        assert!(statically.len() < below.len());
        assert!(statically.iter().zip(&below).any(|(found, exact)| found / exact > 1.05));
    }
}

#[test]
fn impossible_attachments_are_refused() {
    let content = || Key::of("bar").finish();
    let at = |name: &str, region: Region, connection: Connection| Attachment {
        name: name.into(),
        position: None,
        region,
        connection,
    };
    let all = || Region::Box { lowest: [-1.0; 3], highest: [1.0; 3] };
    let edge = || Region::Box { lowest: [-1e-6, -1e-6, -1e-6], highest: [1.0, 1e-6, 1e-6] };
    let refused = |model: ElasticModel, attached: &[Attachment], text: &str| {
        let mut body = FiniteElementBody::new(Arc::new(model), content());
        let (last, before) = attached.split_last().expect("an attachment");
        for attachment in before {
            body.attach(attachment).expect("an attachment");
        }
        let error = body.attach(last).expect_err(text);
        assert!(error.message.contains(text), "{}", error.message);
        assert_eq!(error.code, "E0991");
    };
    let bar = || bar([6, 2, 2], 1.0);
    use Connection::{Average, Rigid};
    let none = Region::Box { lowest: [1.0; 3], highest: [2.0; 3] };
    refused(bar(), &[at("none", none, Rigid)], "contains no node");
    refused(bar(), &[at("unknown", Region::Set("feet".into()), Rigid)], "no node set `feet`");
    refused(bar(), &[at("edge", edge(), Rigid)], "lie on a line");
    refused(bar(), &[at("corner", Region::Nearest([0.0; 3]), Rigid)], "does not resist rotation");
    let both = [at("one", all(), Rigid), at("other", all(), Rigid)];
    refused(bar(), &both, "belong to the attachment \"one\"");
    let harmonics = Connection::Fourier { axis: [1.0, 0.0, 0.0], harmonics: vec![1] };
    refused(bar(), &[at("ring", all(), harmonics)], "harmonic");
    let mut model = bar();
    model.fixed.push(FixedComponents { node: 0, components: [true; 6], value: 0.0 });
    refused(model, &[at("fixed", all(), Rigid)], "node 1 is fixed in the file");
    let mut model = bar();
    let dependents = (1..5).map(|node| (node, [true, true, true, false, false, false])).collect();
    model.constraints.push(Constraint::Rigid { label: 1, reference: 0, dependents });
    refused(model, &[at("tied", all(), Rigid)], "a constraint of the file determines its node 2");
    let both = [at("one", all(), Rigid), at("other", all(), Average)];
    refused(bar(), &both, "all of its nodes belong to the attachment \"one\"");
    let both = [at("one", all(), Average), at("other", all(), Average)];
    refused(bar(), &both, "all of its nodes belong to the attachment \"one\"");
    // Averages leave their nodes independent.
    let half = || Region::Box { lowest: [-1.0; 3], highest: [0.11, 1.0, 1.0] };
    let mut body = FiniteElementBody::new(Arc::new(bar()), content());
    body.attach(&at("rigid", half(), Rigid)).expect("an attachment");
    body.attach(&at("average", all(), Average)).expect("an attachment");
}
