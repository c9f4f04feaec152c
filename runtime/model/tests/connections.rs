//! Elastic connections: their checks, the invariance of their forces, and balances.

use calyx_contact::solid::Pose;
use calyx_fe::material::Material;
use calyx_model::bearing::Support;
use calyx_model::body::Body;
use calyx_model::connection::{Attachment, ConnectionState, ElasticConnection, add_connection_stiffness};
use calyx_model::dof::Dof;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::{RelocatedMotion, SteadyRotation};
use calyx_model::rigid::RigidBody;
use calyx_model::shaft::{Shaft, ShaftSegment};
use calyx_structure::{ComponentModes, RacewayMatrices};
use std::sync::Arc;

const STATIONS: [f64; 3] = [0.0, 0.04, 0.1];

fn shaft() -> Shaft {
    let segment =
        ShaftSegment { length: 0.1, diameter: [0.03, 0.04], bore: [0.01; 2], stiffness_diameter: None };
    Shaft::new(vec![segment], Material::STEEL).expect("a shaft")
}

/// Bodies at the stations of a rotating shaft that is tilted by a rotation (by rows).
fn bodies(rotation: [[f64; 3]; 3]) -> Vec<Body> {
    let body = |(index, z): (usize, &f64)| {
        let spin = Arc::new(SteadyRotation { origin: [0.0; 2], start: 0.3, speed: 20.0 });
        let shifted =
            RelocatedMotion { motion: spin, pose: Pose { origin: [0.0, 0.0, *z], ..Pose::IDENTITY } };
        let tilted =
            RelocatedMotion { motion: Arc::new(shifted), pose: Pose { rotation, origin: [0.1, 0.2, 0.3] } };
        Body { free: [true; 6], ..Body::new(format!("section {index}"), Arc::new(RigidBody), tilted) }
    };
    STATIONS.iter().enumerate().map(body).collect()
}

fn connection() -> ElasticConnection {
    ElasticConnection {
        name: "shaft".into(),
        attachments: (0..3).map(|k| Attachment { to: Support::Body(BodyId(k)), at: [0.0; 3] }).collect(),
        stiffness: shaft().stiffness(&STATIONS),
        mass: shaft().mass(&STATIONS),
        modes: ComponentModes::default(),
        shaft: None,
        body: None,
        raceways: RacewayMatrices::default(),
    }
}

fn mechanism(bodies: Vec<Body>) -> Mechanism {
    Mechanism { bodies, ..Mechanism::default() }
}

fn dofs() -> Vec<Dof> {
    (0..18).map(|k| Dof { body: k / 6, component: k % 6 }).collect()
}

const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// Axis along x of ground.
const LYING: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];

/// DOFs follow the axis of the body, so the matrix is that of the shaft in any orientation and at
/// any time.
#[test]
fn the_stiffness_does_not_depend_on_the_orientation() {
    for (rotation, time) in [(UPRIGHT, 0.0), (UPRIGHT, 0.0123), (LYING, 0.05)] {
        let scene = mechanism(bodies(rotation));
        let mut matrix = vec![0.0; 18 * 18];
        let parts = (&scene.bodies[..], &[connection()][..]);
        add_connection_stiffness(&mut matrix, parts, &[0], &dofs(), |_| 1.0, time).expect("a connection");
        let expected = connection().stiffness;
        let size = |k: usize| expected[k * 18 + k].sqrt();
        for (entry, (found, expected)) in matrix.iter().zip(&expected).enumerate() {
            let (row, column) = (entry / 18, entry % 18);
            let scale = size(row) * size(column);
            assert!((found - expected).abs() < 1e-12 * scale, "{row} {column}: {found} {expected}");
            assert_eq!(*found, matrix[column * 18 + row]);
        }
    }
}

/// Forces on the bodies and their moments about one point vanish in sum, in any orientation.
#[test]
fn the_forces_of_a_connection_balance() {
    let scene = mechanism(bodies(LYING));
    let state = ConnectionState::at(&scene.bodies, &connection(), 0.02).expect("a state");
    let motion: Vec<f64> = (0..18).map(|k| 1e-5 * f64::from(k * k % 7) - 2e-5).collect();
    let push = connection().push(&state.motions(&dofs(), &motion));
    let mut sum = [0.0; 6];
    let mut largest = 0.0_f64;
    for (body, z) in STATIONS.into_iter().enumerate() {
        let [fx, fy, fz, mx, my, mz] = state.wrench_on(BodyId(body), &push);
        // The axis is along x of ground.
        let moment = [mx, my - z * fz, mz + z * fy];
        for (sum, part) in sum.iter_mut().zip([fx, fy, fz].into_iter().chain(moment)) {
            *sum += part;
            largest = largest.max(part.abs());
        }
    }
    assert!(largest > 1e3 && sum.iter().all(|sum| sum.abs() < 1e-11 * largest), "{sum:?} {largest}");
}

#[test]
fn impossible_connections_are_rejected() {
    let good = connection();
    assert!(mechanism(bodies(UPRIGHT)).add_connection(good.clone()).is_ok());
    let with = |stiffness: Vec<f64>| ElasticConnection { stiffness, ..good.clone() };
    let changed = |entry: usize, by: f64| {
        let mut matrix = good.stiffness.clone();
        matrix[entry] += by;
        with(matrix)
    };
    let grounded = changed(0, good.stiffness[0]);
    let wrong = [
        (with(vec![0.0; 9]), "has 9 entries instead of 324"),
        (changed(1, 1e9), "is not symmetric"),
        (changed(0, -3.0 * good.stiffness[0]), "negative"),
        (changed(5, f64::NAN), "not a finite number"),
        (grounded, "resists the rigid-body motion u_x"),
        (ElasticConnection { attachments: Vec::new(), ..good.clone() }, "has no attachments"),
    ];
    for (connection, message) in wrong {
        let error =
            mechanism(bodies(UPRIGHT)).add_connection(connection).expect_err("an impossible connection");
        assert_eq!(error.code, "E0869", "{error}");
        assert!(error.message.contains(message), "{error}");
    }
    // A body that moves away from the shaft.
    let mut parted = bodies(UPRIGHT);
    let motion = SteadyRotation { origin: [0.01, 0.0], start: 0.0, speed: 0.0 };
    let pose = Pose { origin: [0.0, 0.0, 0.1], ..Pose::IDENTITY };
    parted[0].motion = Arc::new(SteadyRotation { origin: [0.02, 0.0], start: 0.0, speed: 5.0 });
    parted[2].motion = Arc::new(RelocatedMotion { motion: Arc::new(motion), pose });
    let attachments = vec![good.attachments[1], good.attachments[2]];
    let still =
        ElasticConnection { attachments, stiffness: vec![0.0; 144], mass: Vec::new(), ..good.clone() };
    assert_eq!(mechanism(parted).add_connection(still).expect_err("it parts").code, "E0869");
    let mut scene = mechanism(bodies(UPRIGHT));
    scene.add_connection(good.clone()).expect("a connection");
    assert_eq!(scene.add_connection(good).expect_err("the same name").code, "E0671");
}
