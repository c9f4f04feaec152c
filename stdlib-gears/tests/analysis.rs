//! Reproducibility of analyses: positions one by one, interruption at any checkpoint, continuation
//! of an earlier run, any number of threads, new or cached structures. In all cases a result has
//! the same bits.

use crate::common::pair::{PLAIN, PairOptions, RELIEVED, TORQUE, pair};
use calyx_gears::external::ExternalGear;
use calyx_gears::gear::Gear;
use calyx_gears::modification::Modification;
use calyx_gears::prototype::GearPrototype;
use calyx_runtime::analysis::{AnalysisOptions, Position, Steps, mesh_cycle, quasi_static};
use calyx_runtime::cache::{CacheCounts, OperatorCache, Store};
use calyx_runtime::error::EngineError;
use calyx_runtime::estimate::Estimates;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::results::{OutputRequest, Solved, StructureCounts};
use calyx_runtime::scene::{BodyModel, Fidelity, ObservableId, Prototype, Scene, StructureOptions, Template};
use calyx_runtime::structure::Chart;
use calyx_runtime::structure::solid::{SegmentLoad, SolidStructure, SurfaceSegment};
use calyx_runtime::system::System;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock, Mutex};

/// Smallest possible mesh of a gear.
const SMALLEST: StructureOptions = StructureOptions {
    refinement: 0.5,
    order: 1,
    model: BodyModel::Elements,
    template: Template::Medium,
    face_elements: None,
    axial_order: None,
    matching_depth: 1.0,
    stresses: true,
    sharp_edges: false,
    raceway_degrees: 0,
};

/// Pair of gears, its positions, and all observables as outputs.
struct Case {
    scene: Scene,
    positions: Vec<Position>,
    outputs: Vec<OutputRequest>,
}

impl Case {
    fn new(options: &PairOptions) -> Case {
        let (mut scene, mesh) = pair(options);
        for (body, member) in scene.bodies.iter_mut().zip(&options.gears) {
            body.prototype = member.prototype.clone();
        }
        let observing = |index| OutputRequest::observing(format!("output {index}"), ObservableId(index));
        let outputs = (0..scene.observables.len()).map(observing).collect();
        Case { scene, positions: mesh_cycle(&mesh, 3), outputs }
    }

    fn steps(&self, options: &AnalysisOptions) -> Result<Steps<'_>, EngineError> {
        Steps::new(&self.scene, &self.positions, &self.outputs, options)
    }

    fn bits(&self, options: &AnalysisOptions) -> String {
        self.steps(options).and_then(|steps| bits(steps)).expect("it can be solved")
    }
}

/// Cases with and without contact on tip edges, with tip relief, and without any load.
fn cases() -> Vec<Case> {
    let plain = PairOptions::chapter_5(&PLAIN);
    let edges = PairOptions { edges: true, ..PairOptions::chapter_5(&RELIEVED) };
    let unloaded = PairOptions { moment: 0.0, ..edges.clone() };
    [plain, edges, unloaded].iter().map(Case::new).collect()
}

/// All values of a result, to the last bit.
fn bits(steps: Steps<'_>) -> Result<String, EngineError> {
    let result = steps.finish()?;
    // Debug prints the shortest decimals that parse to the same number.
    Ok(format!("{:?}\n{:?}\n{:?}", result.rows, result.summaries, result.certificate))
}

fn options(resources: Resources) -> AnalysisOptions {
    AnalysisOptions { structure: SMALLEST, resources, ..AnalysisOptions::default() }
}

/// Interrupt that ends a run at its `last` checkpoint and at all later ones, and a counter of the
/// checkpoints.
fn stopping_at(last: usize) -> (Interrupt, Arc<AtomicUsize>) {
    let asked = Arc::new(AtomicUsize::new(0));
    let counter = asked.clone();
    let question = move || match counter.fetch_add(1, Ordering::Relaxed) + 1 {
        now if now < last => Ok(()),
        _ => Err(enough()),
    };
    (Interrupt::new(question), asked)
}

fn enough() -> EngineError {
    EngineError::new("E0704", "the run was cancelled", "")
}

static EDGES: LazyLock<Case> =
    LazyLock::new(|| Case::new(&PairOptions { edges: true, ..PairOptions::chapter_5(&RELIEVED) }));

#[test]
fn it_ends_at_whichever_checkpoint_says_so_and_leaves_nothing_half_done() {
    let pool = Arc::new(rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads"));
    let (interrupt, asked) = stopping_at(usize::MAX);
    let whole = Resources { interrupt, pool: Some(pool.clone()), cache: None };
    let expected = EDGES.bits(&options(whole));
    let checkpoints = asked.load(Ordering::Relaxed);
    // Structures, positions and the iterations of the solver all have checkpoints.
    assert!(checkpoints > 300, "{checkpoints}");

    let cache = Arc::new(OperatorCache::new(usize::MAX));
    let mut complete = [0; 3];
    // The first and the last ones, and a sample in between that covers every stage.
    let sample =
        (1..6).chain((6..checkpoints).step_by(checkpoints / 20)).chain(checkpoints - 3..=checkpoints);
    for last in sample {
        let (interrupt, asked) = stopping_at(last);
        // Every second run has no cache from earlier runs.
        let kept = (last % 2 == 0).then(|| cache.clone());
        let resources = Resources { interrupt, cache: kept.clone(), pool: Some(pool.clone()) };
        let ended = EDGES.steps(&options(resources)).and_then(bits);
        if asked.load(Ordering::Relaxed) >= last {
            assert_eq!(ended, Err(enough()), "checkpoint {last} of {checkpoints}");
        } else {
            // Structures from the cache have fewer checkpoints.
            assert!(kept.is_some());
            assert_eq!(ended.as_ref(), Ok(&expected));
        }
        complete[cache.counts().structures] += 1;
    }
    // The cache contains no interrupted structures, only complete ones.
    assert!(complete[0] > 0 && complete[2] > 0, "{complete:?}");
    let resources = Resources { cache: Some(cache.clone()), ..Resources::default() };
    assert_eq!(EDGES.bits(&options(resources)), expected);
    assert_eq!(cache.counts().structures, 2);
}

#[test]
fn an_interrupt_ends_the_iterator_and_what_was_solved_remains() {
    let stop = Arc::new(Mutex::new(false));
    let question = {
        let stop = stop.clone();
        move || if *stop.lock().expect("no panic") { Err(enough()) } else { Ok(()) }
    };
    let resources = Resources { interrupt: Interrupt::new(question), ..Resources::default() };
    let mut steps = EDGES.steps(&options(resources)).expect("structures");
    assert_eq!(steps.size_hint(), (1, Some(EDGES.positions.len())));
    assert!(steps.current().is_none());
    let first = steps.next().expect("a position").expect("equilibrium");
    assert_eq!(steps.current().map(|step| step.time), Some(first.row.position.time));
    assert!(steps.current().is_some_and(|step| step.patches.iter().any(|patch| patch.force() > 0.0)));
    *stop.lock().expect("no panic") = true;
    assert_eq!(steps.next(), Some(Err(enough())));
    assert_eq!((steps.next(), steps.size_hint()), (None, (0, Some(0))));
    assert_eq!(steps.solved(), [first]);
    // A failed run stays failed, even if nothing interrupts it any more.
    *stop.lock().expect("no panic") = false;
    assert_eq!(steps.finish().err(), Some(enough()));
}

/// Results do not depend on the number of positions that the caller takes one by one before.
#[test]
fn an_analysis_can_be_finished_at_any_position() {
    let all = EDGES.steps(&options(Resources::default())).expect("structures").finish().expect("equilibrium");
    for taken in 0..=EDGES.positions.len() {
        let mut steps = EDGES.steps(&options(Resources::default())).expect("structures");
        assert_eq!(steps.by_ref().take(taken).filter(Result::is_ok).count(), taken);
        assert_eq!(steps.finish().expect("equilibrium").rows, all.rows);
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let [one, two, eight] = [1, 2, 8].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        EDGES.bits(&options(Resources { pool: Some(Arc::new(pool)), ..Resources::default() }))
    });
    assert_eq!(one, two);
    assert_eq!(one, eight);
}

/// Options with error estimates, a number of threads, and positions solved by an earlier run.
fn estimating(threads: usize, solved: Vec<Solved>, resources: Resources) -> AnalysisOptions {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    let resources = Resources { pool: Some(Arc::new(pool)), ..resources };
    AnalysisOptions { error_estimates: Estimates::Cheap, solved, ..options(resources) }
}

#[test]
fn neither_threads_nor_a_resume_change_a_bit_of_estimates() {
    // All runs may share a cache, because a separate test verifies that structures have the same
    // bits however they are made.
    let cache = Arc::new(OperatorCache::new(usize::MAX));
    let kept = || Resources { cache: Some(cache.clone()), ..Resources::default() };
    let of = |threads, solved| EDGES.bits(&estimating(threads, solved, kept()));
    let one = of(1, Vec::new());
    assert!(one.contains("Discretization") && one.contains("ContactGrid"), "{one}");
    assert_eq!(of(2, Vec::new()), one);
    assert_eq!(of(8, Vec::new()), one);
    let mut steps = EDGES.steps(&estimating(2, Vec::new(), kept())).expect("structures");
    let first = steps.next().expect("a position").expect("equilibrium");
    assert_eq!(of(2, vec![first]), one);
}

/// An interrupt during the error estimates ends the run with the interrupt's own error, not with an
/// incomplete result.
#[test]
fn an_interrupt_ends_estimates() {
    let cache = Arc::new(OperatorCache::new(usize::MAX));
    let with = |interrupt| Resources { interrupt, cache: Some(cache.clone()), ..Resources::default() };
    let expected = EDGES.bits(&estimating(1, Vec::new(), with(Interrupt::never())));
    let asked = |options: AnalysisOptions, asked: Arc<AtomicUsize>| {
        EDGES.bits(&options);
        asked.load(Ordering::Relaxed)
    };
    let (interrupt, counter) = stopping_at(usize::MAX);
    let of_positions = asked(options(with(interrupt)), counter);
    let (interrupt, counter) = stopping_at(usize::MAX);
    let of_all = asked(estimating(1, Vec::new(), with(interrupt)), counter);
    assert!(of_all > of_positions + 10, "{of_positions} {of_all}");
    for part in 1..=8 {
        let last = of_positions + (of_all - of_positions) * part / 8;
        let (interrupt, _) = stopping_at(last);
        let steps =
            EDGES.steps(&estimating(1, Vec::new(), with(interrupt))).expect("structures that are kept");
        assert_eq!(bits(steps), Err(enough()), "at checkpoint {last} of {of_all}");
    }
    assert_eq!(EDGES.bits(&estimating(1, Vec::new(), with(Interrupt::never()))), expected);
}

/// Structures built on any number of threads or read from disk, and positions solved on as many
/// threads.
#[test]
fn the_number_of_threads_changes_no_bit_of_a_solid_model() {
    let folder = tempfile::tempdir().expect("a directory");
    let bits_on = |threads: usize, kept: bool| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let store = || OperatorCache::new(usize::MAX).with_store(Store::new(folder.path(), 1 << 30));
        let cache = kept.then(|| Arc::new(store()));
        let options = AnalysisOptions {
            fidelity: Fidelity::Solid(Template::Medium),
            structure: StructureOptions {
                face_elements: Some(2),
                axial_order: Some(2),
                ..StructureOptions::default()
            },
            resources: Resources { pool: Some(Arc::new(pool)), cache, ..Resources::default() },
            ..AnalysisOptions::default()
        };
        let steps = EDGES.steps(&options).expect("structures");
        let counts = steps.system().structure_counts();
        (bits(steps).expect("it can be solved"), counts.built)
    };
    let (one, built) = bits_on(1, true);
    assert_eq!(built, 2);
    for (threads, kept) in [(2, false), (8, false), (1, true), (8, true)] {
        let (again, built) = bits_on(threads, kept);
        assert_eq!(built, if kept { 0 } else { 2 });
        assert_eq!(again, one, "{threads} threads");
    }
}

#[test]
fn memory_is_asked_for_before_it_is_taken() {
    let within = |limit: u64| {
        let refused = || EngineError::new("E0707", "it is too much", "");
        let interrupt = Interrupt::counting(move |wanted| {
            if wanted.bytes + wanted.promised <= limit { Ok(()) } else { Err(refused()) }
        });
        // The memory that several threads use at the same time would depend on their speed.
        let pool = Some(Arc::new(rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread")));
        let options = options(Resources { interrupt: interrupt.clone(), pool, ..Resources::default() });
        let ended = EDGES.steps(&options).and_then(Steps::finish);
        (ended.map(|result| result.timing.memory).map_err(|error| error.code), interrupt.largest_request())
    };
    let (required, most) = within(u64::MAX);
    assert_eq!(required, Ok(most));
    assert!(most > 1 << 17, "{most}");
    assert_eq!(within(most), (Ok(most), most));
    assert_eq!(within(most - 1).0, Err("E0707"));
}

#[test]
fn each_position_alone_has_the_bits_it_has_in_its_row() {
    for case in cases() {
        let plan = Plan::new(&case.scene, Fidelity::Plane, SMALLEST).expect("a plan");
        let resources =
            Resources { cache: Some(Arc::new(OperatorCache::new(usize::MAX))), ..Resources::default() };
        let system = || System::with(&case.scene, &plan, &resources).expect("a system");
        let in_sequence = system();
        let together: Vec<_> = case
            .positions
            .iter()
            .map(|position| format!("{:?}", in_sequence.solve(position.time).expect("equilibrium")))
            .collect();
        for (position, expected) in case.positions.iter().zip(&together).rev() {
            let alone = system().solve(position.time).expect("equilibrium");
            assert_eq!(&format!("{alone:?}"), expected, "Time = {}", position.time);
        }
    }
}

#[test]
fn going_on_behind_an_earlier_run_gives_the_result_of_one_that_was_not_interrupted() {
    for case in cases() {
        let cache = Arc::new(OperatorCache::new(usize::MAX));
        let resources = Resources { cache: Some(cache), ..Resources::default() };
        let mut whole = case.steps(&options(resources.clone())).expect("structures");
        let solved: Vec<_> = whole.by_ref().collect::<Result<_, _>>().expect("equilibrium");
        let expected = bits(whole).expect("it is solved");
        for count in [0, 1, 3, solved.len() - 1, solved.len()] {
            let earlier = AnalysisOptions { solved: solved[..count].to_vec(), ..options(resources.clone()) };
            let mut steps = case.steps(&earlier).expect("structures");
            assert_eq!(steps.solved().len(), count);
            assert_eq!(steps.by_ref().count(), solved.len() - count);
            assert_eq!(bits(steps).expect("it is solved"), expected, "behind {count} positions");
        }
        // In the format of a journal on disk.
        let journal = serde_json::to_string(&solved).expect("plain data");
        assert_eq!(serde_json::from_str::<Vec<Solved>>(&journal).ok(), Some(solved.clone()));

        let mut foreign = solved;
        foreign[1].row.position.time = foreign[1].row.position.time.next_up();
        let refused = case.steps(&AnalysisOptions { solved: foreign, ..options(resources) }).err();
        assert_eq!(refused.map(|error| error.code), Some("E0724"));
    }
}

/// Another process, represented by a separate cache, reads structures from disk, in two and in
/// three dimensions.
#[test]
fn structures_from_disk_have_the_bits_of_those_made_anew() {
    let folder = tempfile::tempdir().expect("a directory");
    let store = || Store::new(folder.path(), 1 << 30);
    let resources = || {
        let cache = OperatorCache::new(usize::MAX).with_store(store());
        Resources { cache: Some(Arc::new(cache)), ..Resources::default() }
    };
    for case in cases() {
        let expected = case.bits(&options(Resources::default()));
        for expected_counts in [None, Some(StructureCounts { built: 0, reused: 2 })] {
            let options = options(resources());
            let steps = case.steps(&options).expect("structures");
            let counts = steps.system().structure_counts();
            assert!(expected_counts.is_none_or(|expected| counts == expected), "{counts:?}");
            assert_eq!(bits(steps).expect("it can be solved"), expected);
        }
    }
    // Intact bytes of another kind are not a structure.
    let prototype = &PLAIN[0].prototype;
    assert!(prototype.restore(&SMALLEST, b"something else").is_none());
    assert!(prototype.restore_solid(&SMALLEST, b"something else").is_none());

    let options =
        StructureOptions { face_elements: Some(1), axial_order: Some(1), ..StructureOptions::default() };
    let made = prototype.build_solid(&options, &Interrupt::never()).expect("a structure");
    let stored = made.stored().expect("it is worth keeping");
    let again = prototype.restore_solid(&options, &stored).expect("it is whole");
    assert_eq!(made.bytes(), again.bytes());
    assert_eq!(again.stored().as_ref(), Some(&stored));
    let [u, v] = made.surface(0).range();
    let place = |share: f64| [u, v].map(|[from, to]| from + share * (to - from));
    let places = [0.1, 0.4, 0.8].map(|share| SurfaceSegment { place: place(share), length: 1e-3 });
    let [here, there] = [0, 1].map(|tooth| Chart { tooth, surface: 0 });
    for loaded in [here, there] {
        let answer = |structure: &dyn SolidStructure| {
            let mut block = vec![0.0; 9];
            structure.add_compliance(here, &places, loaded, &places, &mut block);
            let load = SegmentLoad { chart: loaded, segment: places[1], force: 100.0 };
            format!("{block:?} {:?}", structure.stresses(0, 0, &[load]))
        };
        assert_eq!(answer(made.as_ref()), answer(again.as_ref()));
    }
}

#[test]
fn another_torque_needs_no_new_structure() {
    let cache = Arc::new(OperatorCache::new(usize::MAX));
    let with_cache = options(Resources { cache: Some(cache.clone()), ..Resources::default() });
    for (run, torque) in [TORQUE, 0.5 * TORQUE, TORQUE].into_iter().enumerate() {
        let mut case = Case::new(&PairOptions { edges: true, ..PairOptions::chapter_5(&RELIEVED) });
        case.scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, torque]));
        let result = quasi_static(&case.scene, &case.positions, &case.outputs, &with_cache, &mut ());
        let counts = result.expect("it can be solved").timing.structures;
        let expected = if run == 0 { [2, 0] } else { [0, 2] };
        assert_eq!([counts.built, counts.reused], expected);
        if run == 1 {
            assert_eq!(case.bits(&with_cache), case.bits(&options(Resources::default())));
        }
    }
    let CacheCounts { hits, misses, structures, .. } = cache.counts();
    assert_eq!((hits, misses, structures), (6, 2, 2));
}

#[test]
fn another_relief_needs_no_new_structure() {
    let cache = Arc::new(OperatorCache::new(usize::MAX));
    let with_cache = options(Resources { cache: Some(cache), ..Resources::default() });
    for (run, relief) in [0.0005, 0.0012].into_iter().enumerate() {
        let gears = [20, 40]
            .map(|teeth| crate::common::pair::chapter_5_member(teeth, relief, crate::common::pair::UNSCALED));
        let mut case = Case::new(&PairOptions::chapter_5(&gears));
        for (body, gear) in case.scene.bodies.iter_mut().zip(&gears) {
            body.prototype = gear.prototype.clone();
        }
        let result = quasi_static(&case.scene, &case.positions, &case.outputs, &with_cache, &mut ());
        let counts = result.expect("it can be solved").timing.structures;
        assert_eq!([counts.built, counts.reused], if run == 0 { [2, 0] } else { [0, 2] });
        if run == 1 {
            assert_eq!(case.bits(&with_cache), case.bits(&options(Resources::default())));
        }
    }
}

#[test]
fn analyses_at_the_same_time_build_each_structure_once() {
    let cache = Arc::new(OperatorCache::new(usize::MAX));
    let expected = EDGES.bits(&options(Resources::default()));
    std::thread::scope(|scope| {
        let run = || EDGES.bits(&options(Resources { cache: Some(cache.clone()), ..Resources::default() }));
        let runs: Vec<_> = (0..6).map(|_| scope.spawn(run)).collect();
        for run in runs {
            assert_eq!(run.join().expect("no panic"), expected);
        }
    });
    assert_eq!((cache.counts().misses, cache.counts().hits), (2, 10));
}

#[test]
fn keys_contain_the_inputs_of_a_structure_and_nothing_else() {
    let base = &PLAIN[0].prototype;
    let again = |change: &dyn Fn(&mut GearPrototype)| {
        let GearPrototype { gear, modifications, material, rim, face_width, pitch_errors, .. } = &**base;
        let mut changed = GearPrototype::new(
            gear.clone(),
            modifications.clone(),
            *material,
            rim.clone(),
            *face_width,
            pitch_errors.clone(),
        )
        .expect("a sound gear");
        change(&mut changed);
        changed.key(&SMALLEST)
    };
    let key = base.key(&SMALLEST);
    assert!(key.is_some());
    let irrelevant: [&dyn Fn(&mut GearPrototype); 6] = [
        &|_| {},
        &|gear| gear.face_width *= 2.0,
        &|gear| gear.pitch_errors = vec![1e-4],
        &|gear| gear.material.density *= 2.0,
        &|gear| gear.rim.radius *= 0.99,
        &|gear| gear.modifications.push(Modification::LeadCrown { depth: 1e-6 }),
    ];
    for (index, change) in irrelevant.iter().enumerate() {
        assert_eq!(again(change), key, "change {index}");
    }
    fn external(gear: &mut GearPrototype) -> &mut ExternalGear {
        match &mut gear.gear {
            Gear::External(gear) => gear,
            Gear::Internal(_) => unreachable!("the gear has external teeth"),
        }
    }
    let relevant: [&dyn Fn(&mut GearPrototype); 9] = [
        &|gear| external(gear).teeth += 1,
        &|gear| external(gear).outer_radius = external(gear).outer_radius.next_up(),
        &|gear| external(gear).root_radius = external(gear).root_radius.next_up(),
        &|gear| external(gear).tooth_thickness = external(gear).tooth_thickness.next_up(),
        &|gear| external(gear).tip_edge_radius = external(gear).tip_edge_radius.next_up(),
        &|gear| external(gear).rack.tip_radius = external(gear).rack.tip_radius.next_up(),
        &|gear| gear.material.poissons_ratio = gear.material.poissons_ratio.next_up(),
        &|gear| gear.material.youngs_modulus = gear.material.youngs_modulus.next_up(),
        &|gear| gear.rim.fixed_radius = gear.rim.fixed_radius.next_up(),
    ];
    let mut keys: Vec<_> = relevant.iter().map(|change| again(change)).collect();
    keys.extend([
        base.key(&StructureOptions { refinement: 1.0, ..SMALLEST }),
        base.key(&StructureOptions { order: 2, ..SMALLEST }),
        base.key(&StructureOptions { matching_depth: 1.1, ..SMALLEST }),
        base.key(&StructureOptions { stresses: false, ..SMALLEST }),
        base.key(&StructureOptions { sharp_edges: true, ..SMALLEST }),
        key,
    ]);
    let count = keys.len();
    keys.sort_unstable();
    keys.dedup();
    assert_eq!(keys.len(), count);
}

#[test]
fn equal_gears_share_a_structure_whoever_made_them() {
    let (gears, other) =
        (&PLAIN[0], crate::common::pair::chapter_5_member(20, 0.0, crate::common::pair::UNSCALED));
    let mut case = Case::new(&PairOptions {
        gears: [gears.clone(), other],
        center_distance: 2.0 * crate::common::INCH,
        ..PairOptions::chapter_5(&PLAIN)
    });
    let counts = |case: &Case| {
        case.steps(&options(Resources::default())).expect("structures").system().structure_counts()
    };
    assert!(!Arc::ptr_eq(&case.scene.bodies[0].prototype, &case.scene.bodies[1].prototype));
    assert_eq!(counts(&case), StructureCounts { built: 1, reused: 0 });
    case.scene.bodies[1].prototype = PLAIN[1].prototype.clone();
    assert_eq!(counts(&case), StructureCounts { built: 2, reused: 0 });
}
