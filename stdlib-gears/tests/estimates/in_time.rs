//! Effectivities of dynamic analyses: a motion through the backlash from impact to impact, and one
//! whose steps do not permit an estimate.

use super::*;
use crate::backlash::reversing;
use crate::common::pair::{FIRST, MESH as TEETH, PairOptions, RELIEVED as RELIEVED_MEMBERS, pair};
use calyx_runtime::dynamics::{DynamicOptions, Scheme, Start, TimeRange, dynamic};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::observables::{MaxRootStress, MeshForce, Rotation, TransmissionError};

fn moving(ranges: Vec<TimeRange>, scheme: &str) -> DynamicOptions {
    let scheme = Scheme::named(scheme).expect("a scheme");
    DynamicOptions { from: 0.0, ranges, scheme, rayleigh: [0.0; 2], start: Start::Equilibrium }
}

fn moved(
    scene: &Scene,
    outputs: &[OutputRequest],
    dynamics: &DynamicOptions,
    error_estimates: Estimates,
) -> (AnalysisResult, Vec<String>) {
    let options = AnalysisOptions {
        fidelity: Fidelity::Analytic,
        error_estimates,
        resources: resources(),
        ..AnalysisOptions::default()
    };
    let result = dynamic(scene, outputs, &options, dynamics, &mut ()).expect("it moves");
    (result, outputs.iter().map(|output| output.name.clone()).collect())
}

/// Relieved pair at a speed, rad/s.
fn driven(speed: f64) -> (Scene, Vec<OutputRequest>, f64) {
    let options = PairOptions { speed, ..PairOptions::chapter_5(&RELIEVED_MEMBERS) };
    let (mut scene, mesh) = pair(&options);
    scene.pairs[0].grid.half_cells = Some(4);
    scene.pairs[0].grid.width = Some(8e-4);
    scene.observables.clear();
    scene.bodies[FIRST.0] = scene.bodies[FIRST.0].clone().with_added(Inertia::axial(0.0, 2e-3, 0.0));
    let outputs = vec![
        OutputRequest::observing("te", scene.add_observable(TransmissionError(TEETH))),
        OutputRequest::observing("force", scene.add_observable(MeshForce(TEETH))),
        OutputRequest::observing("pinion", scene.add_observable(MaxRootStress(FIRST))),
    ];
    (scene, outputs, mesh.period)
}

/// Ratio of the steps of the reference run to those of the others.
const FINER_STEPS: usize = 8;

fn wrong_by_steps(
    name: &str,
    scene: &Scene,
    outputs: &[OutputRequest],
    (duration, steps): (f64, usize),
    scheme: &str,
) -> Vec<String> {
    let run = |finer: usize, estimates| {
        let range = TimeRange { keep: finer, ..TimeRange::steady(duration, finer * steps) };
        moved(scene, outputs, &moving(vec![range], scheme), estimates)
    };
    let (own, _) = run(1, Estimates::Cheap);
    wrong_of(effectivities(name, &[Part::TimeStep], &own, &run(FINER_STEPS, Estimates::None)))
}

#[test]
fn of_steps_from_impulse_to_impulse() {
    let (mut scene, [front, back]) = reversing();
    let outputs = vec![
        OutputRequest::observing("turn", scene.add_observable(Rotation(FIRST, 2))),
        OutputRequest::observing("front", scene.add_observable(MeshForce(front))),
        OutputRequest::observing("back", scene.add_observable(MeshForce(back))),
    ];
    let wrong = wrong_by_steps("impacts", &scene, &outputs, (4e-3, 400), "average_acceleration");
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Relieved pair entering the mesh, where cells take up load step by step: the order of the error
/// is between one and two.
#[test]
fn of_steps_of_a_driven_pair() {
    let (scene, outputs, period) = driven(60.0);
    let wrong = wrong_by_steps("driven", &scene, &outputs, (0.25 * period, 100), "average_acceleration");
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// For a vibration with five steps per period, steps of twice the length give no estimate. Nor do
/// they if the steps resolve it but the errors come from the times at which cells take up load.
#[test]
fn steps_that_do_not_converge_are_told_so() {
    let (scene, outputs, period) = driven(60.0);
    for (part, steps, scheme) in [(3.0, 120, "average_acceleration"), (0.5, 200, "average_acceleration")] {
        let range = TimeRange::steady(part * period, steps);
        let (result, _) = moved(&scene, &outputs, &moving(vec![range], scheme), Estimates::Cheap);
        let error = result.summaries[0].error.as_ref().expect("it is estimated");
        let reason = error.not_estimated.iter().find(|(part, _)| *part == Part::TimeStep);
        assert!(reason.is_some_and(|(_, reason)| reason.starts_with("steps are too long")), "{reason:?}");
    }
}

/// "cheap" estimates contain only the time step error, "full" ones also the others; a run of single
/// steps gives no time step error.
#[test]
fn what_is_estimated_in_time() {
    let (scene, outputs, period) = driven(60.0);
    let parts = |ranges: Vec<TimeRange>, estimates| {
        let (result, _) = moved(&scene, &outputs, &moving(ranges, "average_acceleration"), estimates);
        let error = result.summaries[0].error.clone().expect("it is estimated");
        let missing: Vec<(Part, String)> = error.not_estimated;
        (error.parts.into_iter().map(|(part, _)| part).collect::<Vec<_>>(), missing)
    };
    let range = TimeRange::steady(0.1 * period, 40);
    let (cheap, missing) = parts(vec![range], Estimates::Cheap);
    assert_eq!(cheap, [Part::Positions, Part::TimeStep]);
    assert!(missing.iter().all(|(_, reason)| reason.contains("\"full\"")), "{missing:?}");
    let (full, missing) = parts(vec![range], Estimates::Full);
    assert_eq!(full, [Part::ContactGrid, Part::Positions, Part::Level, Part::TimeStep], "{missing:?}");
    let (single, missing) = parts(vec![TimeRange::steady(1e-5, 1)], Estimates::Cheap);
    assert_eq!(single, []);
    let steps = missing.iter().find(|(part, _)| *part == Part::TimeStep).map(|(_, reason)| reason.as_str());
    assert_eq!(steps, Some("of single steps no two make one"));
}
