//! Tests of omitted bodies: bodies without load path to an observable are omitted, and no
//! observable depends on them.

use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{Displacement, Equilibrium, MaxContactPressure, Observable, Quantity};
use calyx_runtime::plan::Plan;
use calyx_runtime::results::Observed;
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, PairId, Scene, StructureOptions, SurfacePair};
use calyx_runtime::system::System;
use std::sync::Arc;

const RADIUS: f64 = 0.02;
const WIDTH: f64 = 0.01;

/// Creates a number of discs next to each other, each pressed on a platen.
fn discs(count: usize) -> (Scene, Vec<BodyId>) {
    let mut scene = Scene::default();
    let steel = Material::new(210e9, 0.3, 7850.0).expect("steel");
    let disc = Arc::new(Disc::new(RADIUS, WIDTH, steel));
    let platen = Arc::new(Platen::new(2.0 * RADIUS, WIDTH, Facing::Up));
    let pressed = (0..count).map(|number| {
        let at = |y| SteadyRotation::at_rest([0.1 * number as f64, y]);
        let below = scene.add_body(Body::new("platen", platen.clone(), at(-RADIUS)));
        let force = Wrench::of_force([0.0, -1e3 * (number + 1) as f64, 0.0]);
        let disc = Body::new("disc", disc.clone(), at(0.0)).free_in(&[Component::Uy]).loaded(force);
        let disc = scene.add_body(disc);
        scene.add_pair(SurfacePair::new([disc, below], [Disc::BOTTOM, Platen::SURFACE]));
        disc
    });
    let pressed = pressed.collect();
    (scene, pressed)
}

fn planned(scene: &Scene) -> Plan {
    Plan::new(scene, Fidelity::Plane, StructureOptions::default()).expect("a plan")
}

fn left_out(plan: &Plan) -> Vec<bool> {
    plan.bodies.iter().map(|body| body.left_out).collect()
}

#[test]
fn what_nobody_looks_at_is_left_out_and_changes_nothing() {
    let (mut scene, pressed) = discs(2);
    let looked_at = Displacement(pressed[1], 1);
    scene.add_observable(looked_at);
    let whole = Plan::whole(&scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    let pruned = planned(&scene);
    assert_eq!(left_out(&whole), [false; 4]);
    assert_eq!(left_out(&pruned), [true, true, false, false]);
    assert!(pruned.bodies[0].reason.contains("no load goes through it"), "{}", pruned.bodies[0].reason);

    let [all, part] = [whole, pruned].map(|plan| {
        let system = System::new(&scene, &plan).expect("a system");
        let step = system.solve(0.0).expect("equilibrium");
        (step.patches.len(), system.value(&step, &looked_at).value)
    });
    assert_eq!((all.0, part.0), (2, 1));
    assert!((all.1 / part.1 - 1.0).abs() < 1e-12, "{all:?} {part:?}");
}

/// Observables of omitted bodies and of the whole scene have no value, even if requested later.
#[test]
fn what_was_left_out_has_no_value() {
    let (mut scene, pressed) = discs(2);
    scene.add_observable(Displacement(pressed[1], 1));
    let whole = Plan::whole(&scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    for (plan, known) in [(planned(&scene), false), (whole, true)] {
        let system = System::new(&scene, &plan).expect("a system");
        let step = system.solve(0.0).expect("equilibrium");
        let value = |observable: &dyn Observable| system.value(&step, observable).value;
        assert!(value(&Displacement(pressed[1], 1)) < 0.0);
        let others: [&dyn Observable; 3] =
            [&Displacement(pressed[0], 1), &MaxContactPressure(PairId(0)), &Patches];
        for observable in others {
            assert_eq!(value(observable).is_finite(), known, "{observable:?}: {}", value(observable));
        }
    }
}

/// A plane model distributes loads over the face width of the bodies that carry them, independent
/// of other bodies.
#[test]
fn a_width_is_that_of_the_bodies_that_load_each_other() {
    let (mut scene, pressed) = discs(2);
    // The first disc has a tenth of the width.
    scene.bodies[pressed[0].0].prototype = Arc::new(Disc::new(RADIUS, 0.1 * WIDTH, Material::STEEL));
    let looked_at = Displacement(pressed[1], 1);
    scene.add_observable(looked_at);
    scene.add_observable(MaxContactPressure(PairId(1)));
    let whole = Plan::whole(&scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    let reported = |plan: &Plan| plan.ignored.iter().any(|ignored| ignored.input == "face_width");
    let pruned = planned(&scene);
    assert_eq!([&whole, &pruned].map(reported), [true, false]);
    let [all, part] = [whole, pruned].map(|plan| {
        let system = System::new(&scene, &plan).expect("a system");
        let step = system.solve(0.0).expect("equilibrium");
        let narrow = system.value(&step, &MaxContactPressure(PairId(0))).value;
        let wide = system.value(&step, &MaxContactPressure(PairId(1))).value;
        assert!((Equilibrium::new(&system, &step).force(PairId(1)) / 2e3 - 1.0).abs() < 1e-9);
        (system.value(&step, &looked_at).value, narrow, wide)
    });
    assert!((all.0 / part.0 - 1.0).abs() < 1e-12 && (all.2 / part.2 - 1.0).abs() < 1e-9, "{all:?} {part:?}");
    // Hertz: the pressure grows with the square root of the load per width, which is five times as
    // large on the narrow disc.
    assert!((all.1 / all.2 / 5.0f64.sqrt() - 1.0).abs() < 0.02 && part.1.is_nan(), "{all:?}");
}

#[test]
fn motion_in_time_keeps_what_bears_no_load() {
    let (mut scene, pressed) = discs(2);
    scene.add_observable(Displacement(pressed[1], 1));
    let plan = Plan::in_time(&scene, Fidelity::Plane, StructureOptions::default()).expect("a plan");
    assert_eq!(left_out(&plan), [false; 4]);
}

/// Observable that may depend on the whole scene.
#[derive(Clone, Debug, PartialEq)]
struct Patches;

impl Observable for Patches {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("patches", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(at.all_contacts().count() as f64)
    }
}

#[test]
fn who_does_not_say_what_he_looks_at_sees_everything() {
    let (mut scene, pressed) = discs(2);
    scene.add_observable(Displacement(pressed[1], 1));
    scene.add_observable(Patches);
    assert_eq!(left_out(&planned(&scene)), [false; 4]);
    let (nothing_looked_at, _) = discs(2);
    assert_eq!(left_out(&planned(&nothing_looked_at)), [false; 4]);
}
