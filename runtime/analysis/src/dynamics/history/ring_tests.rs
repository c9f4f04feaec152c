//! Tests of freely vibrating and rotating rings, and of gauges on them.

use super::*;
use crate::observables::{Displacement, FilletSide, Gauge, GaugeReading, Reading};
use calyx_fe::inertia::Inertia;
use calyx_fe::material::Material;
use calyx_model::body::Body;
use calyx_model::disc::{Disc, Facing, Platen};
use calyx_model::dof::Component;
use calyx_model::fidelity::StructureOptions;
use calyx_model::ids::BodyId;
use calyx_model::motion::SteadyRotation;
use calyx_model::pairs::SurfacePair;
use calyx_model::prototype::Prototype;
use calyx_numerics::interrupt::Interrupt;
use calyx_solve::integration::{Scheme, TimeRange};
use calyx_structure::tests::annulus::{Annulus, THIN};
use calyx_structure::tests::bodies::{COARSE, ring_source, toothed_sector};
use calyx_structure::{BodyModes, BoreSupport, ElasticStructure, RingSource, SplitOptions, Structure};
use std::f64::consts::TAU;
use std::sync::Arc;

const TEETH: u32 = 9;

/// Ring with teeth, or the modes of a ring without teeth on another body.
struct Ring {
    modes: Arc<BodyModes>,
    toothed: bool,
}

impl Ring {
    fn toothed(highest: f64) -> Ring {
        let (model, surfaces) = toothed_sector(TEETH, 1.0, COARSE);
        let (source, options) = (ring_source(TEETH), SplitOptions::default());
        let modes = BodyModes::ring(&model, &source, &surfaces, &options, highest, &Interrupt::never());
        Ring { modes: Arc::new(modes.expect("modes")), toothed: true }
    }

    fn plain(ring: Annulus, highest: f64) -> Ring {
        let support = BoreSupport::Means { harmonics: None, degree: 0 };
        let source = RingSource { support, ..ring_source(ring.sectors) };
        let options = SplitOptions::default();
        let modes = BodyModes::ring(&ring.sector(), &source, &[], &options, highest, &Interrupt::never());
        Ring { modes: Arc::new(modes.expect("modes")), toothed: false }
    }
}

impl Prototype for Ring {
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        if !self.toothed {
            let few = StructureOptions { refinement: 0.2, order: 1, ..*options };
            return Disc::new(1.0, self.face_width(), Material::STEEL).build(&few, interrupt);
        }
        let (model, surfaces) = toothed_sector(TEETH, 1.0, COARSE);
        let (source, split) = (ring_source(TEETH), SplitOptions::default());
        let structure = ElasticStructure::ring(&model, &source, &surfaces, &split, interrupt);
        Ok(Arc::new(structure.expect("a structure")))
    }

    fn modes(
        &self,
        _: &StructureOptions,
        _: f64,
        _: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        Ok(Some(self.modes.clone()))
    }

    fn inertia(&self) -> Inertia {
        let [mass, polar] = [self.modes.rigid_mass[0][0], self.modes.rigid_mass[2][2]];
        Inertia::axial(mass * self.face_width(), polar * self.face_width(), 0.0)
    }

    fn enclosing_radius(&self) -> f64 {
        1.1
    }

    fn face_width(&self) -> f64 {
        0.2
    }
}

const RING: BodyId = BodyId(1);

/// Scene of a ring far from any contact.
fn scene(ring: Ring, speed: f64, free: &[Component]) -> Scene {
    let mut scene = Scene::default();
    let platen = Arc::new(Platen::new(0.1, 0.2, Facing::Up));
    let below = scene.add_body(Body::new("platen", platen, SteadyRotation::at_rest([0.0, -10.0])));
    let motion = SteadyRotation { origin: [0.0; 2], start: 0.0, speed };
    let ring = scene.add_body(Body::new("ring", Arc::new(ring), motion).free_in(free));
    scene.add_pair(SurfacePair::new([below, ring], [Platen::SURFACE, 0]));
    scene
}

fn options() -> AnalysisOptions {
    AnalysisOptions { highest_frequency: 1.0, ..AnalysisOptions::default() }
}

fn steps(duration: f64, steps: usize, keep: usize) -> DynamicOptions {
    DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange { keep, ..TimeRange::steady(duration, steps) }],
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        start: Start::Frames,
    }
}

/// Relative to a thin rotating ring, its vibration pattern precesses by `2 Omega / (n² + 1)`
/// against the rotation (Bryan 1890). The two coordinates of a pair of modes exchange their
/// vibrations at `2 n Omega / (n² + 1)`, which splits their frequency by twice that. The energy is
/// conserved for any ratio of step to period.
#[test]
fn harmonics_on_a_spinning_ring_go_round_as_bryan_says() {
    let ring = Ring::plain(THIN, 1500.0);
    let modes = ring.modes.clone();
    let lowest = modes.frequencies[0];
    let spin = 0.02 * lowest;
    let mut scene = scene(ring, spin, &[]);
    scene.observables.clear();
    for (per_period, cycles) in [(300.0, 3.0), (3.0, 100.0)] {
        let period = TAU / lowest;
        let count = (cycles * per_period) as usize;
        let analysis = options();
        let asked = steps(cycles * period, count, 1);
        let mut history = History::new(&scene, &[], &analysis, &asked, &mut ()).expect("it can begin");
        // The cosine mode of each pair starts with the same energy.
        for pair in 0..modes.count() / 2 {
            history.state.displacement[2 * pair] = 1e-6 / modes.frequencies[2 * pair];
        }
        let energy = |state: &State| -> f64 {
            let swing =
                |k: usize| state.velocity[k].powi(2) + (modes.frequencies[k] * state.displacement[k]).powi(2);
            (0..modes.count()).map(swing).sum()
        };
        let mut seen: Vec<State> = Vec::new();
        while let Some(row) = history.next() {
            row.expect("it goes on");
            seen.push(history.state().clone());
        }
        // The centrifugal load acts on the harmonic without nodal diameters, whose frequency is
        // above the highest.
        let (before, after) = (energy(&seen[1]), energy(seen.last().expect("a state")));
        assert!((after / before - 1.0).abs() < 1e-9, "{per_period}: {before:e} {after:e}");
        // Bryan's result requires steps that are small compared with the periods.
        let pairs = if per_period > 100.0 { 3 } else { 0 };
        for pair in 0..pairs {
            let n = 2.0 + pair as f64;
            // Direction of the vibration over the last of its periods.
            let last = (per_period * lowest / modes.frequencies[2 * pair]).round() as usize;
            let ends: Vec<[f64; 2]> = seen[seen.len() - 1 - last..]
                .iter()
                .map(|state| [state.displacement[2 * pair], state.displacement[2 * pair + 1]])
                .collect();
            let sum = |of: fn([f64; 2]) -> f64| ends.iter().map(|q| of(*q)).sum::<f64>();
            let (cross, apart) = (sum(|[a, b]| 2.0 * a * b), sum(|[a, b]| a * a - b * b));
            let gone = 0.5 * cross.atan2(apart).abs();
            let middle = cycles * period - 0.5 * last as f64 * cycles * period / count as f64;
            let expected = 2.0 * n / (n * n + 1.0) * spin * middle;
            assert!(expected < 1.4, "within a quarter of a turn: {expected}");
            assert!((gone / expected - 1.0).abs() < 0.01, "{n}: {gone} {expected}");
        }
    }
}

#[test]
fn what_turns_nearly_as_fast_as_it_vibrates_is_told() {
    let ring = Ring::plain(THIN, 700.0);
    let lowest = ring.modes.frequencies[0];
    for (part, warnings, refused) in [(0.05, 0, None), (0.2, 1, None), (0.6, 0, Some("E0767"))] {
        let ring = Ring { modes: ring.modes.clone(), toothed: false };
        let scene = scene(ring, part * lowest, &[]);
        let analysis = options();
        let mut history =
            History::new(&scene, &[], &analysis, &steps(1e-3, 2, 1), &mut ()).expect("it can begin");
        let row = history.next().expect("a row");
        assert_eq!(row.as_ref().err().map(|error| error.code), refused);
        assert_eq!(row.map_or(0, |solved| solved.row.warnings.len()), warnings);
    }
}

/// A gauge on a ring that vibrates in one mode reads that mode's stress times its coordinate.
#[test]
fn a_gauge_on_a_ring_that_vibrates_follows_its_mode() {
    let ring = Ring::toothed(60_000.0);
    let modes = ring.modes.clone();
    let mut scene = scene(ring, 0.0, &[]);
    let gauge = |tooth: Option<u32>| Gauge {
        body: RING,
        place: [0.0, 0.0],
        direction: 0.0,
        length: 0.0,
        side: FilletSide::Loaded,
        tooth,
        material: Material::STEEL,
    };
    // On one tooth, on each of them, on any of them.
    let teeth = (0..TEETH).map(Some).chain([None]);
    let observed = std::iter::once(Some(2)).chain(teeth).map(gauge);
    let outputs: Vec<OutputRequest> = observed
        .map(|gauge| {
            OutputRequest::observing("gauge", scene.add_observable(GaugeReading(gauge, Reading::Stress)))
        })
        .collect();
    let analysis = options();
    for mode in [0, 1, 5] {
        let period = TAU / modes.frequencies[mode];
        let asked = steps(period, 40, 1);
        let mut history = History::new(&scene, &outputs, &analysis, &asked, &mut ()).expect("it can begin");
        history.state.displacement[mode] = 1e-3;
        let (mut coordinates, mut readings) = (Vec::new(), Vec::new());
        while let Some(row) = history.next() {
            let values: Vec<f64> =
                row.expect("it goes on").row.outputs.iter().map(|output| output.value).collect();
            readings.push(values[0]);
            let (on_any, on_each) = (values[values.len() - 1], &values[1..values.len() - 1]);
            assert_eq!(on_any, on_each.iter().copied().fold(f64::NEG_INFINITY, f64::max));
            coordinates.push(history.state().displacement[mode]);
        }
        // The first row gives the reading per unit of the coordinate.
        let unit = readings[0] / coordinates[0];
        let by_mode = modes.stresses(2, 0);
        let (least, most) = (0..by_mode.nrows())
            .map(|row| by_mode[(row, mode)])
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), s| (least.min(s), most.max(s)));
        let room = 0.3 * (most - least) + 1e-9 * most.abs();
        assert!(unit.abs() > 0.0 && (least - room..most + room).contains(&unit), "{unit} {least} {most}");
        assert!(coordinates.iter().any(|q| *q < -0.9e-3), "it swings");
        for (reading, q) in readings.iter().zip(&coordinates) {
            assert!((reading - unit * q).abs() < 1e-9 * readings[0].abs(), "{reading} {}", unit * q);
        }
    }
}

/// A load ramp does not scale impulses.
#[test]
fn a_impulse_is_as_strong_whatever_part_of_the_loads_is_on() {
    let ring = Ring { modes: Ring::plain(THIN, 1.0).modes, toothed: false };
    let mass = ring.inertia().mass;
    let mut scene = scene(ring, 0.0, &[Component::Ux]);
    scene.bodies[RING.0].load = Arc::new(Wrench::of_force([500.0, 0.0, 0.0]));
    let momentum = Wrench::of_force([2.0, 0.0, 0.0]);
    scene.bodies[RING.0].impulses.push(calyx_model::load::Impulse { at: 2e-4, duration: 4e-4, momentum });
    for part in [0.0, 0.5] {
        let mut asked = steps(1e-3, 50, 50);
        asked.ranges[0].load = [part; 2];
        let analysis = options();
        let mut history = History::new(&scene, &[], &analysis, &asked, &mut ()).expect("it can begin");
        history.by_ref().for_each(|row| assert!(row.is_ok()));
        let expected = (2.0 + part * 500.0 * 1e-3) / mass;
        let found = history.state().velocity[0];
        assert!((found / expected - 1.0).abs() < 1e-9, "{part}: {found} {expected}");
    }
}

/// The error estimate repeats a run with steps of two and four times the length; an impulse whose
/// duration is not a multiple of these would have another momentum.
#[test]
fn steps_that_longer_ones_do_not_tell_of_are_told_so() {
    let ring = Ring { modes: Ring::plain(THIN, 1.0).modes, toothed: false };
    let mut scene = scene(ring, 0.0, &[Component::Ux]);
    let momentum = Wrench::of_force([2.0, 0.0, 0.0]);
    scene.bodies[RING.0].impulses.push(calyx_model::load::Impulse { at: 2e-4, duration: 4e-4, momentum });
    let outputs = [OutputRequest::observing("place", scene.add_observable(Displacement(RING, 0)))];
    let analysis = AnalysisOptions { error_estimates: Estimates::Cheap, ..options() };
    // An impulse takes 40, 10, 8 and 4 of these steps, and the longest are four of them.
    for (count, refused) in [(100, false), (25, true), (20, false), (10, true)] {
        let asked = steps(1e-3, count, 1);
        let mut history = History::new(&scene, &outputs, &analysis, &asked, &mut ()).expect("it can begin");
        history.by_ref().for_each(|row| assert!(row.is_ok()));
        let result = history.finish().expect("it ends");
        let error = result.summaries[0].error.clone().expect("it is estimated");
        let reason = error.not_estimated.iter().find(|(part, _)| *part == estimate::Part::TimeStep);
        match refused {
            true => {
                assert!(
                    reason.is_some_and(
                        |(_, reason)| reason.contains("the duration of an impulse is not a multiple")
                    ),
                    "{count}"
                )
            }
            false => assert_eq!(reason, None, "{count}"),
        }
    }
}
