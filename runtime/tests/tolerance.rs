//! Tests of tolerances for a roller between plates, whose fidelity levels and meshes are cheap: the
//! selected setting, its actual error, and unattainable tolerances.

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

const RADIUS: f64 = 0.02;
const WIDTH: f64 = 0.01;
const DISC: Disc = Disc::new(RADIUS, WIDTH, Material::STEEL);

/// Disc that records the options with which it was built.
#[derive(Default)]
struct Counted {
    built: Mutex<Vec<StructureOptions>>,
}

impl Prototype for Counted {
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

/// Creates a roller that a plate of some length presses on another plate, with outputs for the
/// plate's displacement and the largest pressure.
fn squeezed(plate: f64) -> (Scene, Vec<OutputRequest>, Arc<Counted>) {
    let roller: Arc<Counted> = Arc::default();
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
        // On a contact patch that ends with the plate.
        match plate < LONG {
            true => OutputRequest::observing("pressure", scene.add_observable(MaxEdgePressure(pressed))),
            false => OutputRequest::observing("pressure", scene.add_observable(MaxContactPressure(pressed))),
        },
    ];
    (scene, outputs, roller)
}

const LONG: f64 = 2.0 * RADIUS;

/// Structure cache of all tests except those that count structures.
static ROLLERS: LazyLock<Arc<OperatorCache>> = LazyLock::new(|| Arc::new(OperatorCache::new(1 << 30)));

fn from(fidelity: Fidelity) -> AnalysisOptions {
    let resources = Resources { cache: Some(ROLLERS.clone()), ..Resources::default() };
    AnalysisOptions { fidelity, resources, ..AnalysisOptions::default() }
}

/// Returns the values at the only position.
fn values(result: &AnalysisResult) -> Vec<f64> {
    result.rows[0].outputs.iter().map(|output| output.value).collect()
}

/// Rigid bodies have no approach, and a disc has neither a closed form nor a 3-D model: only a
/// plane mesh meets a tolerance. The actual error of the selected setting is at most twice the
/// tolerance, the accuracy of the estimates; a tighter tolerance requires more effort.
#[test]
fn what_is_taken_keeps_to_the_tolerance_and_a_tighter_one_takes_more() {
    let (mut scene, outputs, _) = squeezed(LONG);
    let at = [Position::at(0.0)];
    let within = |tolerance: f64| {
        quasi_static_within(tolerance, &scene, &at, &outputs, &from(Fidelity::Rigid), &mut ())
            .expect("it can be had")
    };
    let [with_clearance, tight] = [0.02, 2e-4].map(|tolerance| (tolerance, within(tolerance)));
    let mut finest = from(Fidelity::Plane);
    finest.structure.refinement = 2.0;
    scene.pairs.iter_mut().for_each(|pair| pair.grid.half_cells = Some(192));
    let exact = values(&quasi_static(&scene, &at, &outputs, &finest, &mut ()).expect("equilibrium"));
    let mut effort = Vec::new();
    for (tolerance, result) in [with_clearance, tight] {
        for (value, exact) in values(&result).iter().zip(&exact) {
            assert!((value / exact - 1.0).abs() <= 2.0 * tolerance, "{tolerance}: {value} {exact}");
        }
        let chosen = result.chosen.expect("something was chosen");
        println!("{}", chosen.describe());
        assert_eq!(chosen.setting.fidelity, Fidelity::Plane);
        assert_eq!(
            (chosen.tried[0].setting.fidelity, chosen.tried[0].worst.1),
            (Fidelity::Rigid, f64::INFINITY)
        );
        assert!(chosen.tried.last().is_some_and(|tried| tried.whole && tried.worst.1 <= tolerance));
        assert!(chosen.level_unseen.is_some_and(|reason| reason.starts_with("E0690")));
        effort.push(chosen.setting.refinement * chosen.setting.cells as f64);
    }
    assert!(effort[1] > effort[0], "{effort:?}");
}

/// A rigid roller has no displacement: without another level that estimates the error, this level
/// is not selected.
#[test]
fn a_level_that_nothing_judges_is_not_taken() {
    let (scene, outputs, _) = squeezed(LONG);
    let at = [Position::at(0.0)];
    let options = from(Fidelity::Rigid);
    let result =
        quasi_static_within(0.05, &scene, &at, &outputs[..1], &options, &mut ()).expect("it can be had");
    assert_eq!(result.plan.fidelity, Fidelity::Plane);
    assert!(values(&result)[0] < -1e-6);
}

#[test]
fn no_structure_is_condensed_twice() {
    let (scene, outputs, roller) = squeezed(LONG);
    let at = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Position::at);
    let options = AnalysisOptions { resources: Resources::default(), ..from(Fidelity::Plane) };
    let result = quasi_static_within(1e-3, &scene, &at, &outputs, &options, &mut ()).expect("it can be had");
    assert!(result.chosen.is_some_and(|chosen| chosen.tried.len() > 1));
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
        let (scene, outputs, roller) = squeezed(plate);
        let at = [Position::at(0.0)];
        let options = from(Fidelity::Plane);
        let result = quasi_static_within(tolerance, &scene, &at, &outputs, &options, &mut ());
        let result = result.unwrap_or_else(|error| panic!("{tolerance} of a plate of {plate}: {error:?}"));
        assert_eq!((result.rows.len(), result.plan.fidelity), (1, Fidelity::Plane));
        let missed = result
            .chosen
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

/// An observer can end the search at any fidelity level.
#[test]
fn an_observer_ends_the_search() {
    struct Full;
    impl Observer for Full {
        fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
            match event {
                Event::Step { .. } => Err(EngineError::new("E0704", "nobody takes steps any more", "")),
                _ => Ok(()),
            }
        }
    }
    let (scene, outputs, _) = squeezed(LONG);
    let at = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(Position::at);
    let ended = quasi_static_within(0.05, &scene, &at, &outputs, &from(Fidelity::Rigid), &mut Full);
    assert_eq!(ended.err().map(|error| error.code), Some("E0704"));
    // So can an interrupt.
    let stopped = Interrupt::new(|| Err(EngineError::new("E0704", "the run was cancelled", "")));
    let resources = Resources { interrupt: stopped, ..Resources::default() };
    let options = AnalysisOptions { resources, ..from(Fidelity::Rigid) };
    let ended = quasi_static_within(0.05, &scene, &at, &outputs, &options, &mut ());
    assert_eq!(ended.err().map(|error| error.code), Some("E0704"));
}

/// Observer that counts its events, and interrupts a search after the first results.
struct Ending {
    ended: Arc<AtomicBool>,
    steps: Vec<(usize, f64)>,
}

impl Observer for Ending {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        match event {
            Event::SearchProgress(choosing) => {
                let described = choosing.describe();
                assert_eq!(
                    choosing.best.is_some(),
                    described.contains("; the best so far is "),
                    "{described}"
                );
                let finite = choosing.best.as_ref().is_some_and(|best| best.worst.1.is_finite());
                self.ended.fetch_or(finite, Ordering::Relaxed);
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
fn a_search_that_is_ended_has_the_best_results() {
    let (scene, outputs, _) = squeezed(LONG);
    let at: Vec<Position> = (0..12).map(|time| Position::at(f64::from(time))).collect();
    let ended = Arc::new(AtomicBool::new(false));
    let asked = ended.clone();
    let interrupt = Interrupt::new(move || match asked.load(Ordering::Relaxed) {
        true => Err(EngineError::new("E0704", "the run was cancelled", "")),
        false => Ok(()),
    });
    let cache = Some(ROLLERS.clone());
    let resources = Resources { interrupt, cache, ..Resources::default() };
    let options = AnalysisOptions { resources, ..from(Fidelity::Rigid) };
    let mut ending = Ending { ended, steps: Vec::new() };
    let result = quasi_static_within(1e-5, &scene, &at, &outputs, &options, &mut ending);
    let result = result.expect("there are results when it is ended");
    let chosen = result.chosen.as_ref().expect("it says what they are of");
    assert_eq!(chosen.ended.as_deref(), Some("the run was cancelled"));
    let taken = &chosen.tried[chosen.taken];
    assert!(taken.worst.1 > 1e-5 && chosen.tried.iter().all(|tried| tried.worst.1 >= taken.worst.1));
    assert_eq!((taken.setting, taken.whole), (chosen.setting, result.rows.len() == at.len()));
    let missed = chosen.missed().expect("the tolerance is missed");
    assert_eq!((missed.code, missed.argument), ("E0793", Some("tolerance")));
    for part in ["0.001 %", "the run was cancelled", "at a few of the positions", " % in `"] {
        assert!(missed.message.contains(part), "{part} in {}", missed.message);
    }
    assert!(chosen.describe().starts_with("tolerance 0.001 % not met, because the run was cancelled"));
    let rows: Vec<(usize, f64)> = result.rows.iter().map(|row| row.position.time).enumerate().collect();
    assert_eq!(ending.steps, rows);
}
