//! Springs, clearances and stops from very soft to very stiff, and nearly redundant ones.

use super::case::{Case, Refusal, off, worst};
use calyx_runtime::bearing::{Bearing, Stop, axisymmetric};
use calyx_runtime::disc::{Facing, Platen};
use calyx_runtime::error::EngineError;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{Displacement, MaxContactPressure};
use calyx_runtime::plan::Plan;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, Scene, StructureOptions, SurfacePair};
use calyx_runtime::system::System;
use std::sync::Arc;

pub fn cases() -> Vec<Case> {
    vec![
        Case::holds(
            "A body on a spring",
            "stiffnesses of 1e-12 to 1e30 N/m, loads of 1e-9 to 1e9 N",
            1e-12,
            "force over stiffness",
            || {
                let stiffnesses = [1e-12, 1.0, 1e15, 1e30];
                worst(stiffnesses.into_iter().flat_map(|stiffness| {
                    [1e-9, 1.0, 1e9]
                        .map(|force| off(on(&[stiffness], [force, 0.0], &[])[0], force / stiffness))
                }))
            },
        ),
        Case::holds(
            "Two springs in series, the load on the second",
            "the first 1e12 times as stiff as the second",
            1e-12,
            "springs in series",
            || in_a_row([1e15, 1e3]),
        ),
        Case::holds(
            "Two springs in series, the load on the second",
            "the second 1e9 times as stiff as the first",
            1e-5,
            "springs in series: digits of the softer one that remain in the sum of both stiffnesses",
            || in_a_row([1e3, 1e12]),
        ),
        Case::holds(
            "Two springs in series, the load on the second",
            "the second 1e12 times as stiff as the first",
            1e-2,
            "the same",
            || in_a_row([1e3, 1e15]),
        ),
        Case::refused(
            "Two springs in series, the load on the second",
            "the second 1e20 times as stiff as the first",
            "E0714",
            "no digit of the softer one remains in the sum",
            || row_of([1e3, 1e23]).err().map(Refusal::from),
        ),
        Case::holds(
            "A bearing with clearance: displacement beyond the clearance",
            "clearances of 0 m, 1e-12 m and 1 m, and a deflection of 1e-6 m beyond them",
            1e-6,
            "force over stiffness: the stops that approximate a round clearance have an error of a millionth",
            || worst([0.0, 1e-12, 1.0].map(with_clearance)),
        ),
        Case::holds(
            "Two stops that carry load together",
            "at angles of 1e-3, 1e-9 and 0 rad to each other",
            1e-6,
            "half of the load each",
            || worst([1e-3, 1e-9, 0.0].map(nearly_the_same)),
        ),
        Case::holds(
            "A hundred identical stops",
            "all equal, with 1e-12 m of clearance",
            1e-9,
            "a hundredth of the load each",
            || {
                let wall = Stop::Wall {
                    clearance: 1e-12,
                    direction: [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                    stiffness: 1e7,
                };
                off(on(&[1e-3], [1e3, 0.0], &vec![wall; 100])[0], 1e-12 + 1e3 / 1e9)
            },
        ),
        Case::refused(
            "A body without a support",
            "a load along the free degree of freedom",
            "E0714",
            "there is no equilibrium",
            || {
                let along = axisymmetric(0.0, 0.0, 0.0, 1.0);
                refused(Bearing::new("torsion", BODY, 0.0, along))
            },
        ),
    ]
}

const BODY: BodyId = BodyId(2);

/// Two distant plates, and rigid bodies on bearings next to them.
fn scene(bodies: &[Wrench]) -> Scene {
    let mut scene = Scene::default();
    let platen = |facing| Arc::new(Platen::new(0.1, 0.01, facing));
    let at = |y: f64| SteadyRotation::at_rest([0.0, y]);
    let below = scene.add_body(Body::new("below", platen(Facing::Up), at(-1.0)));
    let above = scene.add_body(Body::new("above", platen(Facing::Down), at(0.0)));
    let plates = scene.add_pair(SurfacePair::new([below, above], [Platen::SURFACE; 2]));
    scene.add_observable(MaxContactPressure(plates));
    for (index, load) in bodies.iter().enumerate() {
        let motion = SteadyRotation::at_rest([0.5 + 0.1 * index as f64, 0.0]);
        let body = Body::new(format!("body {index}"), Arc::new(RigidBody), motion);
        let body = scene.add_body(body.free_in(&[Component::Ux, Component::Uy]).loaded(*load));
        // Unobserved bodies are left out.
        scene.add_observable(Displacement(body, 0));
    }
    scene
}

fn solved(scene: &Scene) -> Result<Vec<f64>, EngineError> {
    let plan = Plan::new(scene, Fidelity::Plane, StructureOptions::default())?;
    let step = System::new(scene, &plan)?.solve(0.0)?;
    assert!(step.certificate.largest() <= 1e-9, "{:?}", step.certificate);
    assert_eq!(step.warnings, Vec::<String>::new());
    Ok(step.motion)
}

/// Displacement of a body along x and y on springs and stops.
fn on(springs: &[f64], [x, y]: [f64; 2], stops: &[Stop]) -> Vec<f64> {
    let mut scene = scene(&[Wrench::of_force([x, y, 0.0])]);
    for (index, &stiffness) in springs.iter().enumerate() {
        let spring =
            Bearing::new(format!("spring {index}"), BODY, 0.0, axisymmetric(stiffness, 0.0, 0.0, 0.0));
        scene.add_bearing(spring).expect("a bearing");
    }
    if !stops.is_empty() {
        let stops = Bearing {
            stops: stops.to_vec(),
            ..Bearing::new("stops", BODY, 0.0, axisymmetric(0.0, 0.0, 0.0, 0.0))
        };
        scene.add_bearing(stops).expect("a bearing");
    }
    solved(&scene).expect("equilibrium")
}

fn with_clearance(clearance: f64) -> f64 {
    let ring = Stop::Ring { clearance, stiffness: 1e8 };
    off(on(&[], [100.0, 0.0], &[ring])[0] - clearance, 1e-6)
}

fn row_of([first, second]: [f64; 2]) -> Result<Vec<f64>, EngineError> {
    let mut scene = scene(&[Wrench::NONE, Wrench::of_force([10.0, 0.0, 0.0])]);
    // Both at one position: a bearing has one origin.
    scene.bodies[3].motion = Arc::new(SteadyRotation::at_rest([0.5, 0.0]));
    let spring =
        |name: &str, body, stiffness| Bearing::new(name, body, 0.0, axisymmetric(stiffness, 0.0, 0.0, 0.0));
    scene.add_bearing(spring("first", BODY, first)).expect("a bearing");
    scene.add_bearing(spring("second", BodyId(3), second).between(BODY)).expect("a bearing");
    solved(&scene)
}

fn in_a_row(stiffnesses: [f64; 2]) -> f64 {
    let [first, second] = stiffnesses;
    let found = row_of(stiffnesses).expect("equilibrium");
    worst([off(found[0], 10.0 / first), off(found[2], 10.0 / first + 10.0 / second)])
}

fn nearly_the_same(angle: f64) -> f64 {
    let wall = |angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        Stop::Wall { clearance: 1e-6, direction: [-cosine, -sine, 0.0, 0.0, 0.0, 0.0], stiffness: 1e8 }
    };
    let found = on(&[1.0], [1e3, 0.0], &[wall(0.5 * angle), wall(-0.5 * angle)]);
    off(found[0], (1e3 - 1e-6) / (2e8 * (0.5 * angle).cos().powi(2)) + 1e-6)
}

fn refused(bearing: Bearing) -> Option<Refusal> {
    let mut scene = scene(&[Wrench::of_force([1.0, 0.0, 0.0])]);
    scene.add_bearing(bearing).expect("a bearing");
    solved(&scene).err().map(Refusal::from)
}
