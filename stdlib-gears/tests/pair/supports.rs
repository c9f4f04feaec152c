//! Diagnostics of scenes that are unconstrained or unloaded, or have unsuitable contact grids.

use crate::common::pair::{COARSE, FIRST, PLAIN, PairOptions, TORQUE, member, pair, system};
use crate::common::{INCH, chapter_5_data, resources};
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::error::EngineError;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::RelocatedMotion;
use calyx_runtime::observables::Observe;
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{Body, Fidelity};
use calyx_runtime::system::System;
use std::sync::Arc;

/// Error from solving the chapter 5 pair after a change of its bodies.
fn failure(options: &PairOptions, change: impl Fn(&mut Vec<Body>)) -> EngineError {
    let (mut scene, mesh) = pair(options);
    change(&mut scene.bodies);
    let plan = match Plan::new(&scene, Fidelity::Plane, COARSE) {
        Ok(plan) => plan,
        Err(error) => return error,
    };
    let system = System::with(&scene, &plan, &resources()).expect("it can be built");
    system.solve(mesh.start + 0.6 * mesh.period).expect_err("nothing holds it")
}

#[test]
fn what_nothing_holds_is_named_with_its_direction() {
    type Change = fn(&mut Vec<Body>);
    let along_line_of_action =
        PairOptions { direction: 20.0_f64.to_radians(), ..PairOptions::chapter_5(&PLAIN) };
    let plain = PairOptions::chapter_5(&PLAIN);
    let apart = PairOptions { center_distance: 3.17 * INCH, ..plain.clone() };
    let cases: [(&PairOptions, Change, &str, &str); 6] = [
        (
            &plain,
            |bodies| bodies[1].free[5] = true,
            "E0714",
            "theta_z of body \"second\" in the negative sense",
        ),
        (&plain, |bodies| bodies[0].free[0] = true, "E0714", "u_x of body \"first\""),
        (&plain, |bodies| bodies[1].free[1] = true, "E0714", "u_y of body \"second\""),
        (&plain, |bodies| bodies[1].free[2] = true, "E0611", "body \"second\" is free in u_z"),
        (&along_line_of_action, |bodies| bodies[1].free[0] = true, "E0715", "u_x of body \"second\""),
        (&apart, |_| {}, "E0714", "theta_z of body \"first\" in the positive sense"),
    ];
    for (options, change, code, named) in cases {
        let error = failure(options, change);
        assert_eq!(error.code, code, "{}", error.message);
        assert!(error.message.contains(named), "{}: wanted {named}", error.message);
        assert!(!error.help.is_empty());
    }
}

#[test]
fn a_scene_without_pairs_is_refused() {
    let (mut scene, _) = pair(&PairOptions::chapter_5(&PLAIN));
    scene.pairs.clear();
    let plan = Plan::new(&scene, Fidelity::Plane, COARSE).expect("a plan");
    let error = System::new(&scene, &plan).err().expect("nothing to solve");
    assert_eq!(error.code, "E0713");
    assert!(error.help.contains("gears.mesh"), "{}", error.help);
}

#[test]
fn gears_constrained_where_they_overlap_press_as_the_load_that_moved_them_there() {
    let (scene, mesh) = pair(&PairOptions::chapter_5(&PLAIN));
    let time = mesh.start + 0.6 * mesh.period;
    let plan = Plan::new(&scene, Fidelity::Plane, COARSE).expect("a plan");
    let deflection =
        System::new(&scene, &plan).and_then(|system| system.solve(time)).expect("it is held").motion[0];

    let mut constrained = scene.clone();
    constrained.bodies[0].free = [false; 6];
    constrained.bodies[0].load = Arc::new(Wrench::NONE);
    constrained.bodies[0].phase += deflection;
    let plan = Plan::new(&constrained, Fidelity::Plane, COARSE).expect("a plan");
    let system = System::new(&constrained, &plan).expect("it can be built");
    let step = system.solve(time).expect("nothing moves");
    let moment = system.contact_force(&step, FIRST)[5];
    // The closest approach is searched with the gear rotated, at a slightly different point of the
    // flanks.
    assert!((moment / -TORQUE - 1.0).abs() < 1e-3, "{moment}");
    assert!(step.certificate.largest() <= 1e-12);
}

#[test]
fn faces_of_unequal_width_are_reported() {
    let [first, second] = [20, 40].map(|teeth| chapter_5_data(teeth, 0.02, 0.15708));
    let ignored = |widths: [f64; 2]| {
        let gears = [member(first, widths[0] * INCH), member(second, widths[1] * INCH)];
        let (scene, _) = pair(&PairOptions::chapter_5(&gears));
        Plan::new(&scene, Fidelity::Plane, COARSE).expect("a plan").ignored
    };
    assert!(ignored([1.0, 1.0]).is_empty());
    let found = ignored([1.0, 1.25]);
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].input, "face_width");
    assert!(found[0].reason.contains("25.4 mm"), "{}", found[0].reason);
}

/// A plane model reports the axial loads and offset faces that it ignores.
#[test]
fn what_stands_out_of_the_plane_is_reported() {
    let ignored = |change: &dyn Fn(&mut [Body])| -> Vec<String> {
        let (mut scene, _) = pair(&PairOptions::chapter_5(&PLAIN));
        change(&mut scene.bodies);
        let plan = Plan::new(&scene, Fidelity::Plane, COARSE).expect("a plan");
        plan.ignored.into_iter().map(|ignored| ignored.input).collect()
    };
    assert!(ignored(&|_| {}).is_empty());
    let wrench = Wrench { force: [0.0, 0.0, 5.0], moment: [1.0, 0.0, TORQUE] };
    assert_eq!(ignored(&|bodies| bodies[0].load = Arc::new(wrench)), ["force", "moment"]);
    let beside = |bodies: &mut [Body]| {
        let motion = bodies[1].motion.clone();
        let pose =
            Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0, 0.0, 5e-3] };
        bodies[1].motion = Arc::new(RelocatedMotion { motion, pose });
    };
    assert_eq!(ignored(&beside), ["frame"]);
}

/// The width that warnings recommend, m.
fn advice(warnings: &[String]) -> Option<f64> {
    let warning = warnings.first()?;
    let (_, rest) = warning.split_once("`grid_width = ")?;
    let (width, _) = rest.split_once(" mm`")?;
    Some(1e-3 * width.parse::<f64>().ok()?)
}

#[test]
fn a_grid_that_does_not_suit_is_reported_with_one_that_does() {
    let warned = |width: Option<f64>| {
        let options = PairOptions { grid_width: width, moment: TORQUE, ..PairOptions::chapter_5(&PLAIN) };
        let (scene, mesh) = pair(&options);
        system(&scene).solve(mesh.start + 0.6 * mesh.period).expect("equilibrium").warnings
    };
    assert_eq!(warned(None), Vec::<String>::new());
    // The patch is about 0.2 mm wide.
    for (width, trouble) in [(0.05e-3, "too narrow"), (0.15e-3, "too narrow"), (5e-3, "too wide")] {
        let mut width = width;
        let mut warnings = warned(Some(width));
        assert!(warnings[0].contains(trouble), "{warnings:?}");
        // If the grid is much too narrow, the recommendation is only a lower bound and may have to
        // be followed repeatedly.
        for _ in 0..4 {
            match advice(&warnings) {
                Some(better) => width = better,
                None => break,
            }
            warnings = warned(Some(width));
        }
        assert_eq!(warnings, Vec::<String>::new(), "width {width}");
    }
}
