//! Tests of the tolerance search with a roller between plates, for which all fidelity levels are
//! cheap: the selected setting and its actual error, tolerances that no setting satisfies, and
//! cancellation.

use calyx_runtime::analysis::{AnalysisOptions, Event, Observer, Position, quasi_static};
use calyx_runtime::cache::{Key, OperatorCache};
use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{Displacement, MaxContactPressure, MaxEdgePressure};
use calyx_runtime::resources::Resources;
use calyx_runtime::results::{AnalysisResult, OutputRequest};
use calyx_runtime::scene::{
    Body, BodyModel, Component, Fidelity, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::structure::Structure;
use calyx_runtime::tolerance::{ToleranceOutcome, quasi_static_within};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock, Mutex};

/// Radius of the roller, m.
const RADIUS: f64 = 0.02;
/// Face width of roller and plates, m.
const WIDTH: f64 = 0.01;
const DISC: Disc = Disc::new(RADIUS, WIDTH, Material::STEEL);

/// Disc that records the options of each finite element model that is built.
#[derive(Default)]
struct RecordingDisc {
    built: Mutex<Vec<StructureOptions>>,
}

impl Prototype for RecordingDisc {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        if options.model == BodyModel::Elements {
            self.built.lock().expect("nothing panics under the lock").push(*options);
        }
        DISC.build(options, interrupt)
    }

    fn key(&self, options: &StructureOptions) -> Option<Key> {
        DISC.key(options)
    }

    fn enclosing_radius(&self) -> f64 {
        DISC.enclosing_radius()
    }

    fn face_width(&self) -> f64 {
        DISC.face_width()
    }
}

/// Creates a roller between two plates. A force on the upper plate, of length `plate` (m), presses
/// them together. The outputs are the displacement of the upper plate and the largest pressure.
fn roller_between_plates(plate: f64) -> (Scene, Vec<OutputRequest>, Arc<RecordingDisc>) {
    let roller: Arc<RecordingDisc> = Arc::default();
    let at = |y: f64| SteadyRotation::at_rest([0.0, y]);
    let platen = |length, facing| Arc::new(Platen::new(length, WIDTH, facing));
    let up = &[Component::Uy];
    let mut scene = Scene::default();
    let disc = scene.add_body(Body::new("roller", roller.clone(), at(0.0)).free_in(up));
    let table = scene.add_body(Body::new("table", platen(2.0 * RADIUS, Facing::Up), at(-RADIUS)));
    let press = Body::new("press", platen(plate, Facing::Down), at(RADIUS));
    let load = Wrench::of_force([0.0, -2e4, 0.0]);
    let press = scene.add_body(press.free_in(up).loaded(load));
    let pressed = scene.add_pair(SurfacePair::new([disc, press], [Disc::TOP, Platen::SURFACE]));
    scene.add_pair(SurfacePair::new([disc, table], [Disc::BOTTOM, Platen::SURFACE]));
    let outputs = vec![
        OutputRequest::observing("approach", scene.add_observable(Displacement(press, 1))),
        // Under a short plate, the contact patch ends at the edges of the plate.
        match plate < LONG {
            true => OutputRequest::observing("pressure", scene.add_observable(MaxEdgePressure(pressed))),
            false => OutputRequest::observing("pressure", scene.add_observable(MaxContactPressure(pressed))),
        },
    ];
    (scene, outputs, roller)
}

/// Length of a plate that extends beyond the contact patch, m.
const LONG: f64 = 2.0 * RADIUS;

/// Structure cache of all tests except those that count structures.
static ROLLERS: LazyLock<Arc<OperatorCache>> = LazyLock::new(|| Arc::new(OperatorCache::new(1 << 30)));

/// Returns options of a search that starts at a fidelity level.
fn from(fidelity: Fidelity) -> AnalysisOptions {
    let resources = Resources { cache: Some(ROLLERS.clone()), ..Resources::default() };
    AnalysisOptions { fidelity, resources, ..AnalysisOptions::default() }
}

/// Returns the values at the only position.
fn values(result: &AnalysisResult) -> Vec<f64> {
    result.rows[0].outputs.iter().map(|output| output.value).collect()
}

/// Rigid bodies have no displacement, and a disc has neither a closed form nor a solid model, so
/// only a plane mesh satisfies a tolerance. The actual error of the selected setting is at most
/// twice the tolerance, because estimates are accurate to a factor of two. A tighter tolerance
/// selects a finer mesh or contact grid.
#[test]
fn the_selected_setting_satisfies_the_tolerance() {
    let (mut scene, outputs, _) = roller_between_plates(LONG);
    let at = [Position::at(0.0)];
    let within = |tolerance: f64| {
        quasi_static_within(tolerance, &scene, &at, &outputs, &from(Fidelity::Rigid), &mut ())
            .expect("a setting satisfies it")
    };
    let [loose, tight] = [0.02, 2e-4].map(|tolerance| (tolerance, within(tolerance)));
    let mut finest = from(Fidelity::Plane);
    finest.structure.refinement = 2.0;
    scene.pairs.iter_mut().for_each(|pair| pair.grid.half_cells = Some(192));
    let exact = values(&quasi_static(&scene, &at, &outputs, &finest, &mut ()).expect("equilibrium"));
    let mut effort = Vec::new();
    for (tolerance, result) in [loose, tight] {
        for (value, exact) in values(&result).iter().zip(&exact) {
            assert!((value / exact - 1.0).abs() <= 2.0 * tolerance, "{tolerance}: {value} {exact}");
        }
        let outcome = result.tolerance_search.expect("an outcome of the search");
        println!("{}", outcome.describe());
        assert_eq!(outcome.setting.fidelity, Fidelity::Plane);
        assert_eq!(
            (outcome.attempts[0].setting.fidelity, outcome.attempts[0].worst.1),
            (Fidelity::Rigid, f64::INFINITY)
        );
        assert!(outcome.attempts.last().is_some_and(|attempt| attempt.whole && attempt.worst.1 <= tolerance));
        assert!(outcome.excluded_model_error.is_some_and(|reason| reason.starts_with("E0690")));
        effort.push(outcome.setting.refinement * outcome.setting.cells as f64);
    }
    assert!(effort[1] > effort[0], "{effort:?}");
}

/// A rigid roller has no displacement, and no other level estimates the error of this output. The
/// search does not select the level.
#[test]
fn a_level_without_an_error_estimate_is_not_selected() {
    let (scene, outputs, _) = roller_between_plates(LONG);
    let at = [Position::at(0.0)];
    let options = from(Fidelity::Rigid);
    let result = quasi_static_within(0.05, &scene, &at, &outputs[..1], &options, &mut ())
        .expect("a setting satisfies it");
    assert_eq!(result.plan.fidelity, Fidelity::Plane);
    assert!(values(&result)[0] < -1e-6);
}

#[test]
fn no_structure_is_condensed_twice() {
    let (scene, outputs, roller) = roller_between_plates(LONG);
    let at = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Position::at);
    let options = AnalysisOptions { resources: Resources::default(), ..from(Fidelity::Plane) };
    let result =
        quasi_static_within(1e-3, &scene, &at, &outputs, &options, &mut ()).expect("a setting satisfies it");
    assert!(result.tolerance_search.is_some_and(|outcome| outcome.attempts.len() > 1));
    let built = roller.built.lock().expect("nothing panics under the lock");
    for (index, options) in built.iter().enumerate() {
        assert!(!built[..index].contains(options), "{options:?} twice");
    }
}

/// The pressure under the end of a short plate is infinite, and a tolerance of 1e-9 exceeds the
/// accuracy of every grid. Both are detected before expensive settings are tried, and the results
/// are the best so far, marked as missing the tolerance.
#[test]
fn a_tolerance_that_no_setting_meets_ends_with_the_best_results() {
    for (plate, tolerance) in [(1e-4, 0.01), (LONG, 1e-9)] {
        let (scene, outputs, roller) = roller_between_plates(plate);
        let at = [Position::at(0.0)];
        let options = from(Fidelity::Plane);
        let result = quasi_static_within(tolerance, &scene, &at, &outputs, &options, &mut ());
        let result = result.unwrap_or_else(|error| panic!("{tolerance} of a plate of {plate}: {error:?}"));
        assert_eq!((result.rows.len(), result.plan.fidelity), (1, Fidelity::Plane));
        let missed = result
            .tolerance_search
            .as_ref()
            .and_then(ToleranceOutcome::missed)
            .expect("it does not meet the tolerance");
        assert_eq!((missed.code, missed.argument), ("E0793", Some("tolerance")), "{}", missed.message);
        assert!(
            missed.message.contains("because no setting is estimated to meet it: they are of \"plane\""),
            "{}",
            missed.message
        );
        assert!(missed.help.starts_with("ask for a larger tolerance"), "{}", missed.help);
        assert!(plate == LONG || missed.message.contains("`pressure`"), "{}", missed.message);
        assert!(roller.built.lock().expect("nothing panics under the lock").len() <= 2);
    }
}

/// The error of an observer ends the search, and so does an interrupt.
#[test]
fn observers_and_interrupts_end_the_search() {
    struct Cancelling;
    impl Observer for Cancelling {
        fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
            match event {
                Event::Step { .. } => Err(EngineError::new("E0704", "the observer cancelled the run", "")),
                _ => Ok(()),
            }
        }
    }
    let (scene, outputs, _) = roller_between_plates(LONG);
    let at = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Position::at);
    let ended = quasi_static_within(0.05, &scene, &at, &outputs, &from(Fidelity::Rigid), &mut Cancelling);
    assert_eq!(ended.err().map(|error| error.code), Some("E0704"));
    let stopped = Interrupt::new(|| Err(EngineError::new("E0704", "the run was cancelled", "")));
    let resources = Resources { interrupt: stopped, ..Resources::default() };
    let options = AnalysisOptions { resources, ..from(Fidelity::Rigid) };
    let ended = quasi_static_within(0.05, &scene, &at, &outputs, &options, &mut ());
    assert_eq!(ended.err().map(|error| error.code), Some("E0704"));
}

/// Observer that records the solved positions, and requests the end of the search after the first
/// results.
struct CancelAfterFirstResult {
    cancelled: Arc<AtomicBool>,
    /// Index and time of each position of the latest list.
    steps: Vec<(usize, f64)>,
}

impl Observer for CancelAfterFirstResult {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        match event {
            Event::SearchProgress(progress) => {
                let described = progress.describe();
                assert_eq!(
                    progress.best.is_some(),
                    described.contains("; the best so far is "),
                    "{described}"
                );
                let finite = progress.best.as_ref().is_some_and(|best| best.worst.1.is_finite());
                self.cancelled.fetch_or(finite, Ordering::Relaxed);
            }
            Event::Step { index, solved, .. } => {
                // A new list of positions replaces the earlier one.
                self.steps.truncate(index);
                self.steps.push((index, solved.row.position.time));
            }
            _ => {}
        }
        Ok(())
    }
}

/// A cancelled search returns its best results, and observers have received their positions.
#[test]
fn a_cancelled_search_returns_the_best_results() {
    let (scene, outputs, _) = roller_between_plates(LONG);
    let at: Vec<Position> = (0..12).map(|time| Position::at(f64::from(time))).collect();
    let cancelled = Arc::new(AtomicBool::new(false));
    let requested = cancelled.clone();
    let interrupt = Interrupt::new(move || match requested.load(Ordering::Relaxed) {
        true => Err(EngineError::new("E0704", "the run was cancelled", "")),
        false => Ok(()),
    });
    let cache = Some(ROLLERS.clone());
    let resources = Resources { interrupt, cache, ..Resources::default() };
    let options = AnalysisOptions { resources, ..from(Fidelity::Rigid) };
    let mut observer = CancelAfterFirstResult { cancelled, steps: Vec::new() };
    let result = quasi_static_within(1e-5, &scene, &at, &outputs, &options, &mut observer);
    let result = result.expect("results of the cancelled search");
    let outcome = result.tolerance_search.as_ref().expect("an outcome of the search");
    assert_eq!(outcome.ended.as_deref(), Some("the run was cancelled"));
    let taken = &outcome.attempts[outcome.selected];
    assert!(taken.worst.1 > 1e-5 && outcome.attempts.iter().all(|attempt| attempt.worst.1 >= taken.worst.1));
    assert_eq!((taken.setting, taken.whole), (outcome.setting, result.rows.len() == at.len()));
    let missed = outcome.missed().expect("the tolerance is missed");
    assert_eq!((missed.code, missed.argument), ("E0793", Some("tolerance")));
    for part in ["0.001 %", "the run was cancelled", "at a few of the positions", " % in `"] {
        assert!(missed.message.contains(part), "{part} in {}", missed.message);
    }
    assert!(outcome.describe().starts_with("tolerance 0.001 % not met, because the run was cancelled"));
    let rows: Vec<(usize, f64)> = result.rows.iter().map(|row| row.position.time).enumerate().collect();
    assert_eq!(observer.steps, rows);
}
