//! Slow run-up and run-down of a damped spur pair through its mesh resonance. Tooth separation
//! makes the mesh softer with increasing vibration, so the amplitude jumps up and down at different
//! speeds. The reduced model with one degree of freedom predicts the speeds: a spring with the mesh
//! stiffness that transmits no tension, about the static transmission error, both from the
//! quasi-static run of the same pair.
//!
//! The jumps are delayed in proportion to the rate of the sweep, so the reduced model has the same
//! sweep.

use crate::common::pair::{COARSE, FIRST, MESH, PLAIN, PairOptions, RELIEVED, SECOND, TORQUE, pair, system};
use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::motion::Motion;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{DynamicFactor, MeshForce, MeshStiffness, Rotation};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::rows::StepRow;
use calyx_runtime::scene::Scene;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Number of teeth of the driven gear, whose shaft follows the sweep.
const TEETH: f64 = 20.0;
/// Steps of the pair's sweep per mesh cycle, and cycles of a sweep.
const STEPS: usize = 40;
const CYCLES: usize = 150;
/// Steps of the reduced model per step of the pair.
const FINER: usize = 16;
/// Positions of the quasi-static run over a mesh cycle.
const POSITIONS: usize = 64;
/// Damping ratio for the mean stiffness.
const DAMPING_RATIO: f64 = 0.075;
/// Number of cycles over which a jump is measured.
const ACROSS: usize = 5;
/// Number of cycles after which the initial transient has decayed.
const SETTLED: usize = 15;

/// Shaft through a point with constant angular acceleration. `ratio` relates its speed to that of
/// the first gear, whose initial tooth passing frequency is `from`, rad/s.
#[derive(Clone, Copy)]
struct Sweep {
    origin: [f64; 2],
    ratio: f64,
    from: f64,
    /// Rate of the sweep, rad/s².
    rate: f64,
}

impl Sweep {
    /// Angle of the first gear, and its first two derivatives.
    fn turn(&self, time: f64) -> [f64; 3] {
        let speed = self.from + self.rate * time;
        [(self.from + 0.5 * self.rate * time) * time, speed, self.rate].map(|part| part / TEETH)
    }

    /// The rotation part of the frame for an angle, without the constant part.
    fn turned(&self, angle: f64) -> [f64; 12] {
        let ((sin, cos), [x, y]) = (angle.sin_cos(), self.origin);
        [cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 0.0, -(cos * x + sin * y), sin * x - cos * y, 0.0]
    }

    fn own(&self, time: f64) -> [f64; 3] {
        self.turn(time).map(|part| self.ratio * part)
    }
}

impl Motion for Sweep {
    fn frame(&self, time: f64) -> [f64; 12] {
        let mut frame = self.turned(self.own(time)[0]);
        frame[8] = 1.0;
        frame
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        let [angle, speed, _] = self.own(time);
        self.turned(angle + 0.25 * TAU).map(|entry| speed * entry)
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        let [angle, speed, rate] = self.own(time);
        let (along, towards) = (self.turned(angle + 0.25 * TAU), self.turned(angle));
        std::array::from_fn(|k| rate * along[k] - speed * speed * towards[k])
    }
}

/// The pair at 1 rad/s.
fn coarse_pair() -> Scene {
    coarse(&PairOptions::chapter_5(&PLAIN))
}

fn coarse(options: &PairOptions) -> Scene {
    let (mut scene, _) = pair(&PairOptions { speed: 1.0, ..options.clone() });
    scene.pairs[0].grid.half_cells = Some(3);
    scene.pairs[0].grid.width = Some(8e-4);
    scene.observables.clear();
    scene.bodies[FIRST.0] = scene.bodies[FIRST.0].clone().with_added(Inertia::axial(0.0, 2e-3, 0.0));
    scene
}

/// Static results over a mesh cycle.
struct Statics {
    /// Rotation of the loaded gear, rad, and torsional stiffness, N m/rad.
    rows: Vec<[f64; 2]>,
    inertia: f64,
}

impl Statics {
    fn new() -> Statics {
        let (scene, lever) = (coarse_pair(), PLAIN[0].gear().base_radius);
        let system = system(&scene);
        let row = |k: usize| {
            let step = system.solve(TAU / TEETH * k as f64 / POSITIONS as f64).expect("equilibrium");
            let value = |observable: &dyn calyx_runtime::observables::Observable| {
                system.value(&step, observable).value
            };
            [value(&Rotation(FIRST, 2)), value(&MeshStiffness(MESH)) * lever * lever]
        };
        Statics { rows: (0..POSITIONS).map(row).collect(), inertia: scene.bodies[FIRST.0].inertia().polar() }
    }

    /// Natural frequency for the mean stiffness, rad/s.
    fn resonance(&self) -> f64 {
        let mean = self.rows.iter().map(|row| row[1]).sum::<f64>() / POSITIONS as f64;
        (mean / self.inertia).sqrt()
    }

    /// Values after a number of mesh cycles.
    fn at(&self, cycles: f64) -> [f64; 2] {
        let place = cycles.fract() * POSITIONS as f64;
        let (k, part) = (place.floor() as usize, place.fract());
        let [one, other] = [k, k + 1].map(|k| self.rows[k % POSITIONS]);
        [0, 1].map(|what: usize| (1.0 - part) * one[what] + part * other[what])
    }
}

/// Rotation of the gear (rad) and ratio of the tooth moment to the load, step by step.
type Course = Vec<[f64; 2]>;

fn course_of_the_pair(from: f64, rate: f64, step: f64, damping: f64) -> Course {
    let mut scene = coarse_pair();
    let centers = [[0.0; 2], [3.0 * crate::common::INCH, 0.0]];
    for (body, ratio) in [(FIRST, 1.0), (SECOND, -0.5)] {
        let sweep = Sweep { origin: centers[body.0], ratio, from, rate };
        scene.bodies[body.0].motion = Arc::new(sweep);
    }
    let outputs = [
        OutputRequest::observing("turn", scene.add_observable(Rotation(FIRST, 2))),
        OutputRequest::observing("force", scene.add_observable(MeshForce(MESH))),
    ];
    let lever = PLAIN[0].gear().base_radius;
    let rows = integrated(&scene, &outputs, [step, damping], STEPS * CYCLES);
    rows.into_iter().map(|row| [row[0], row[1] * lever / TORQUE]).collect()
}

/// Outputs of every time step (s) with mass-proportional damping (1/s), from equilibrium on.
fn integrated(
    scene: &Scene,
    outputs: &[OutputRequest],
    [step, damping]: [f64; 2],
    steps: usize,
) -> Vec<Vec<f64>> {
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(step * steps as f64, steps)],
        scheme: Scheme::AVERAGE,
        rayleigh: [damping, 0.0],
        start: Start::Equilibrium,
    };
    let options = AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() };
    let history = History::new(scene, outputs, &options, &dynamics, &mut ()).expect("it can begin");
    let values = |solved: StepRow| solved.outputs.iter().map(|output| output.value).collect();
    history.map(|solved| values(solved.expect("it goes on").row)).collect()
}

fn course_of_the_reduced(statics: &Statics, from: f64, rate: f64, step: f64, damping: f64) -> Course {
    let (h, inertia) = (step / FINER as f64, statics.inertia);
    let moment = |turn: f64, time: f64| {
        let [rest, stiffness] = statics.at((from + 0.5 * rate * time) * time / TAU);
        (TORQUE + stiffness * (turn - rest)).max(0.0)
    };
    let (mut turn, mut speed) = (statics.rows[0][0], 0.0);
    let mut course = vec![[turn, 1.0]];
    for k in 1..=STEPS * CYCLES * FINER {
        // The acceleration of the frame makes the gear lag.
        let time = k as f64 * h;
        let resisted = moment(turn, time) + damping * inertia * speed;
        speed += h * ((TORQUE - resisted) / inertia - rate / TEETH);
        turn += h * speed;
        if k % FINER == 0 {
            course.push([turn, moment(turn, time) / TORQUE]);
        }
    }
    course
}

/// Jump of the vibration amplitude.
#[derive(Debug)]
struct Jump {
    /// Ratio of the tooth passing frequency to the resonance.
    at: f64,
    /// Ratio of the amplitudes after and before the jump.
    growth: f64,
    /// Smallest moment of the teeth before and after.
    least: [f64; 2],
}

/// The largest jump in a direction: +1 up, -1 down.
fn jump(course: &[[f64; 2]], frequency: impl Fn(f64) -> f64, sense: f64) -> Jump {
    // In cycles of the mean speed. The phase of the teeth differs between cycles, which hardly
    // affects the amplitude.
    let cycles: Vec<[f64; 2]> = course
        .chunks_exact(STEPS)
        .map(|cycle| {
            let most = cycle.iter().map(|row| row[0]).fold(f64::NEG_INFINITY, f64::max);
            let least = cycle.iter().map(|row| row[0]).fold(f64::INFINITY, f64::min);
            [most - least, cycle.iter().map(|row| row[1]).fold(f64::INFINITY, f64::min)]
        })
        .collect();
    let growth = |k: usize| (cycles[k + ACROSS][0] / cycles[k][0]).ln();
    let candidates = SETTLED..cycles.len() - ACROSS;
    let k = candidates.max_by(|a, b| (sense * growth(*a)).total_cmp(&(sense * growth(*b)))).expect("cycles");
    let at = frequency((k as f64 + 0.5 * (ACROSS + 1) as f64) / cycles.len() as f64);
    Jump { at, growth: growth(k).exp(), least: [cycles[k][1], cycles[k + ACROSS][1]] }
}

#[test]
fn jumps_are_where_the_reduced_model_has_them() {
    let statics = Statics::new();
    let resonance = statics.resonance();
    let damping = 2.0 * DAMPING_RATIO * resonance;
    let [up, down] = [(0.78, 1.0, 1.0), (1.0, 0.74, -1.0)].map(|(from, to, sense)| {
        let step = TAU / (0.5 * (from + to) * resonance * STEPS as f64);
        let rate = (to - from) * resonance / (step * (STEPS * CYCLES) as f64);
        let pair = course_of_the_pair(from * resonance, rate, step, damping);
        let reduced = course_of_the_reduced(&statics, from * resonance, rate, step, damping);
        let [own, expected] = [&pair, &reduced].map(|course| jump(course, |k| from + k * (to - from), sense));
        // The remaining difference is the load dependence of the contact stiffness, which the
        // reduced model neglects.
        assert!((own.at / expected.at - 1.0).abs() < 0.02, "{own:?} {expected:?}");
        assert!((own.growth / expected.growth - 1.0).abs() < 0.15, "{own:?} {expected:?}");
        (own, pair)
    });
    let least = |course: &[[f64; 2]]| course.iter().map(|row| row[1]).fold(f64::INFINITY, f64::min);
    // Below the jump the teeth stay in contact; above it they separate, and on the way back they
    // continue to separate far below the speed of the first jump.
    let ((up, upwards), (down, _)) = (up, down);
    let kept = least(&upwards[SETTLED * STEPS..upwards.len() / 4]);
    assert!(kept > 0.05, "{kept}");
    assert!(up.growth > 1.2 && up.least[1] == 0.0, "{up:?}");
    assert!(down.growth < 0.6 && down.least[0] == 0.0 && down.least[1] > 0.2, "{down:?}");
    assert!(up.at - down.at > 0.06, "{up:?} {down:?}");
}

/// Largest dynamic factor and largest mesh force over the static one, of the last cycles after
/// `settled` mesh cycles at a constant tooth passing frequency, rad/s. `steps` is the number of
/// steps per cycle.
fn largest_factors(
    mut scene: Scene,
    [frequency, damping]: [f64; 2],
    steps: usize,
    settled: usize,
) -> [f64; 2] {
    let centers = [[0.0; 2], [3.0 * crate::common::INCH, 0.0]];
    for (body, ratio) in [(FIRST, 1.0), (SECOND, -0.5)] {
        let motion = Sweep { origin: centers[body.0], ratio, from: frequency, rate: 0.0 };
        scene.bodies[body.0].motion = Arc::new(motion);
    }
    let mesh = scene.pairs[MESH.0].mesh.as_mut().expect("a mesh");
    // The cycle in time of the scene, which is created at 1 rad/s of the first gear.
    let scale = TEETH / frequency;
    (mesh.start, mesh.period) = (mesh.start * scale, mesh.period * scale);
    let outputs = [
        OutputRequest::observing("factor", scene.add_observable(DynamicFactor(MESH))),
        OutputRequest::observing("force", scene.add_observable(MeshForce(MESH))),
    ];
    let step = TAU / (frequency * steps as f64);
    let rows = integrated(&scene, &outputs, [step, damping], steps * settled * 6 / 5);
    let steady = &rows[steps * settled..];
    let largest = |output: usize| steady.iter().map(|row| row[output]).fold(0.0, f64::max);
    // The static force on a gear under a constant moment is constant.
    [largest(0), largest(1) * PLAIN[0].gear().base_radius / TORQUE]
}

/// The maximum of the dynamic factor is the ratio of the dynamic to the static force: near 1 far
/// below resonance, and larger at resonance.
#[test]
fn the_dynamic_factor_is_the_largest_force_over_the_static_one() {
    let statics = Statics::new();
    let resonance = statics.resonance();
    let damping = 2.0 * DAMPING_RATIO * resonance;
    // The load on pairs with tip relief changes without steps: vibration vanishes with the speed.
    let relieved = PairOptions { edges: true, ..PairOptions::chapter_5(&RELIEVED) };
    let factors = |scene: Scene, ratio: f64, [steps, settled]: [usize; 2], tolerance: f64| {
        let [factor, force] = largest_factors(scene, [ratio * resonance, damping], steps, settled);
        assert!((factor / force - 1.0).abs() < tolerance, "{ratio}: {factor} {force}");
        factor
    };
    // Slow cycles have 20 steps per natural period. Tips that touch outside the path of contact
    // push with another lever, so the static force of these pairs varies slightly.
    let slow = factors(coarse(&relieved), 0.04, [500, 5], 2e-3);
    assert!(slow > 1.0 && slow < 1.1, "{slow}");
    let resonant = factors(coarse_pair(), 0.85, [STEPS, 50], 1e-9);
    assert!(resonant > slow, "{resonant} {slow}");
}
