//! Dynamic analyses, compared with closed forms, with statics for slow motion, and with the reduced
//! model of a pair with one degree of freedom.

use crate::common::built;
use crate::common::pair::{COARSE, FIRST, MESH, PLAIN, PairOptions, RELIEVED, SECOND, TORQUE, pair, system};
use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    Displacement, Equilibrium, FilletSide, Gauge, GaugeReading, MaxRootStress, MeshStiffness, ModeShare,
    NaturalFrequency, Reading, Rotation, SupportMoment, TransmissionError,
};
use calyx_runtime::results::{OutputRequest, Solved};
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, GearMesh, Scene};
use std::f64::consts::TAU;
use std::sync::Arc;

/// A coarse pair at a speed of the first gear, rad/s.
fn at_speed(speed: f64, gears: &[crate::common::pair::Member; 2]) -> (Scene, GearMesh) {
    let (mut scene, mesh) = pair(&PairOptions { speed, ..PairOptions::chapter_5(gears) });
    scene.pairs[0].grid.half_cells = Some(8);
    // Quasi-static analyses fit grids to the forces, dynamic ones do not.
    scene.pairs[0].grid.width = Some(8e-4);
    scene.observables.clear();
    (scene, mesh)
}

fn options() -> AnalysisOptions {
    AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() }
}

fn moving(ranges: Vec<TimeRange>) -> DynamicOptions {
    DynamicOptions {
        from: 0.0,
        ranges,
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        start: Start::Equilibrium,
    }
}

/// Rows of the scene's observables, with rigid bodies.
fn rows(scene: &Scene, dynamics: &DynamicOptions) -> Vec<(f64, Vec<f64>)> {
    rows_up_to(0.0, scene, dynamics)
}

/// The same rows with the modes of the bodies up to a natural frequency, Hz.
fn rows_up_to(highest_frequency: f64, scene: &Scene, dynamics: &DynamicOptions) -> Vec<(f64, Vec<f64>)> {
    rows_by(&AnalysisOptions { highest_frequency, ..options() }, scene, dynamics)
}

fn rows_by(options: &AnalysisOptions, scene: &Scene, dynamics: &DynamicOptions) -> Vec<(f64, Vec<f64>)> {
    let outputs = requests(scene);
    let history = History::new(scene, &outputs, options, dynamics, &mut ()).expect("it is analysed");
    history
        .map(|solved| {
            let Solved { row, .. } = solved.expect("it is solved");
            (row.position.time, row.outputs.iter().map(|output| output.value).collect())
        })
        .collect()
}

fn requests(scene: &Scene) -> Vec<OutputRequest> {
    let observable =
        |index| OutputRequest::observing(format!("{index}"), calyx_runtime::scene::ObservableId(index));
    (0..scene.observables.len()).map(observable).collect()
}

/// Adds a rigid body on a bearing, next to a pair at rest.
fn with_rigid(body: Body, bearing: Option<Bearing>) -> (Scene, BodyId) {
    let (mut scene, _) = at_speed(1e-3, &PLAIN);
    let id = scene.add_body(body);
    if let Some(bearing) = bearing {
        scene.add_bearing(Bearing { body: id, ..bearing }).expect("a bearing");
    }
    scene.add_observable(Displacement(id, 0));
    scene.add_observable(Displacement(id, 1));
    scene.add_observable(Rotation(id, 2));
    scene.add_observable(TransmissionError(MESH));
    (scene, id)
}

fn rigid(free: &[Component], motion: SteadyRotation) -> Body {
    Body::new("rotor", Arc::new(RigidBody), motion).free_in(free)
}

#[test]
fn a_torque_on_a_free_body_turns_it_as_newton_says() {
    let (torque, inertia) = (3.0, 0.02);
    let free = [Component::Ux, Component::Uy, Component::ThetaZ];
    let body = rigid(&free, SteadyRotation::at_rest([0.5, 0.0]))
        .with_added(Inertia::axial(1.0, inertia, 0.0))
        .loaded(Wrench::of_moment([0.0, 0.0, torque]));
    let bearing = Bearing::new("journal", BodyId(0), 0.0, axisymmetric(1e6, 0.0, 0.0, 0.0));
    let (scene, _) = with_rigid(body, Some(bearing));
    let dynamics = DynamicOptions { start: Start::Frames, ..moving(vec![TimeRange::steady(1e-3, 20)]) };
    for (time, values) in rows(&scene, &dynamics) {
        let turned = 0.5 * torque / inertia * time * time;
        assert!((values[2] - turned).abs() <= 1e-9 * turned + 1e-18, "{time} {} {turned}", values[2]);
    }
}

/// An unbalanced rotor on a bearing that is stiffer along y, undamped and from rest:
/// `x = A (cos wt - cos px t)` with `A = u w² / (kx - m w²)`.
#[test]
fn an_unbalance_shakes_a_rotor_in_a_bearing_at_its_own_speed() {
    let (mass, unbalance, speed) = (2.0, 1e-4, 150.0);
    let [kx, ky] = [4e5, 9e5];
    let mut stiffness = axisymmetric(kx, 0.0, 0.0, 0.0);
    stiffness[1][1] = ky;
    let added = Inertia { moment: [unbalance, 0.0, 0.0], ..Inertia::axial(mass, 1e-3, 0.0) };
    let motion = SteadyRotation { origin: [0.5, 0.0], start: 0.0, speed };
    let body = rigid(&[Component::Ux, Component::Uy], motion).with_added(added);
    let (scene, id) = with_rigid(body, Some(Bearing::new("bearing", BodyId(0), 0.0, stiffness)));
    assert_eq!(id, BodyId(2));
    let dynamics = DynamicOptions { start: Start::Frames, ..moving(vec![TimeRange::steady(0.05, 2000)]) };
    let exact = |k: f64, time: f64, phase: fn(f64) -> f64| {
        let (natural, drive) = ((k / mass).sqrt(), unbalance * speed * speed / (k - mass * speed * speed));
        match phase(0.0) {
            1.0 => drive * ((speed * time).cos() - (natural * time).cos()),
            _ => drive * ((speed * time).sin() - speed / natural * (natural * time).sin()),
        }
    };
    let size = unbalance * speed * speed / (kx - mass * speed * speed);
    for (time, values) in rows(&scene, &dynamics) {
        let (x, y) = (exact(kx, time, f64::cos), exact(ky, time, f64::sin));
        assert!(
            (values[0] - x).abs() < 2e-3 * size && (values[1] - y).abs() < 2e-3 * size,
            "{time} {values:?} {x} {y}"
        );
    }
}

/// A slow motion agrees with statics: with rigid bodies, and with modes, whose static part and
/// residual flexibility together make up the whole compliance.
#[test]
fn slow_motion_is_statics() {
    // One rotation in half an hour, in steps of minutes, by a scheme that damps what they cannot
    // resolve.
    let (mut scene, mesh) = at_speed(TAU / 2000.0, &RELIEVED);
    scene.add_observable(TransmissionError(MESH));
    scene.add_observable(SupportMoment(SECOND, 2));
    // Root stress of the tooth that carries most, and of a tooth next to the mesh.
    scene.add_observable(MaxRootStress(FIRST));
    let gauge = Gauge {
        body: FIRST,
        place: [0.5e-3, 0.0],
        direction: 0.0,
        length: 0.5e-3,
        side: FilletSide::Loaded,
        tooth: None,
        material: Material::STEEL,
    };
    scene.add_observable(GaugeReading(gauge, Reading::Strain));
    let system = system(&scene);
    let [rigid, modal] = [0.0, 60e3].map(|highest_frequency| {
        let dynamics = DynamicOptions {
            scheme: Scheme::named("backward_difference").expect("known"),
            ..moving(vec![TimeRange { keep: 4, ..TimeRange::steady(0.4 * mesh.period, 16) }])
        };
        rows_up_to(highest_frequency, &scene, &dynamics)
    });
    for ((time, rigid), (_, modal)) in rigid.iter().zip(&modal) {
        let step = system.solve(*time).expect("equilibrium");
        let statics = [
            system.value(&step, &TransmissionError(MESH)).value,
            system.value(&step, &SupportMoment(SECOND, 2)).value,
            system.value(&step, &MaxRootStress(FIRST)).value,
            system.value(&step, &GaugeReading(gauge, Reading::Strain)).value,
        ];
        // Quasi-static analyses build the contact layout at the nominal positions of the frames,
        // dynamic ones at those of the bodies.
        let near = |k: usize, by: f64| (rigid[k] - statics[k]).abs() <= by * statics[k].abs();
        assert!(
            near(0, 1e-3) && near(1, 1e-4) && near(2, 2e-3) && near(3, 2e-3),
            "{time}: {rigid:?} {statics:?}"
        );
        let same = |k: usize| (rigid[k] - modal[k]).abs() <= 1e-5 * rigid[k].abs();
        assert!((0..4).all(same), "{time}: {rigid:?} {modal:?}");
    }
}

/// The same for closed-form models: a motion that begins in equilibrium stays there, and a slow one
/// agrees with statics.
#[test]
fn slow_motion_without_meshes_is_statics() {
    let (mut scene, mesh) = at_speed(TAU / 2000.0, &RELIEVED);
    scene.add_observable(TransmissionError(MESH));
    scene.add_observable(SupportMoment(SECOND, 2));
    scene.add_observable(MaxRootStress(FIRST));
    let system = built(&scene, Fidelity::Analytic, COARSE);
    let dynamics = DynamicOptions {
        scheme: Scheme::named("backward_difference").expect("known"),
        ..moving(vec![TimeRange { keep: 4, ..TimeRange::steady(0.4 * mesh.period, 16) }])
    };
    let rows = rows_by(&AnalysisOptions { fidelity: Fidelity::Analytic, ..options() }, &scene, &dynamics);
    assert_eq!(rows.len(), 5);
    for (time, values) in rows {
        let step = system.solve(time).expect("equilibrium");
        let statics = [
            system.value(&step, &TransmissionError(MESH)).value,
            system.value(&step, &SupportMoment(SECOND, 2)).value,
            system.value(&step, &MaxRootStress(FIRST)).value,
        ];
        for ((value, statics), by) in values.iter().zip(&statics).zip([1e-3, 1e-4, 2e-3]) {
            assert!((value - statics).abs() <= by * statics.abs(), "{time}: {value} {statics}");
        }
    }
}

/// One gear that rotates on its teeth: at every fidelity level the square of its natural frequency
/// is the stiffness of the teeth at their lever arm divided by its inertia. The relative error of
/// closed-form frequencies is therefore half of that of the stiffness.
#[test]
fn frequencies_without_meshes_go_by_the_stiffness_of_the_teeth() {
    let (scene, mesh) = at_speed(1.0, &PLAIN);
    let inertia = scene.bodies[FIRST.0].inertia().polar();
    let [given, meshed] = [Fidelity::Analytic, Fidelity::Plane].map(|fidelity| {
        let system = built(&scene, fidelity, COARSE);
        let step = system.solve(0.3 * mesh.period).expect("equilibrium");
        let frequency = system.value(&step, &NaturalFrequency(0)).value;
        let stiffness = system.value(&step, &MeshStiffness(MESH)).value;
        let expected = (stiffness * mesh.base_radii[0].powi(2) / inertia).sqrt() / TAU;
        assert!((frequency / expected - 1.0).abs() < 1e-9, "{fidelity:?}: {frequency} {expected}");
        frequency
    });
    assert!((given / meshed - 1.0).abs() < 0.01, "{given} {meshed}");
}

/// The reduced model: J theta'' + c theta' = T - k(t) rb² (theta - theta_s(t)), with stiffness and
/// deflection from statics.
#[test]
fn a_pair_vibrates_as_its_reduced_model_says() {
    let speed = 300.0;
    let (mut scene, mesh) = at_speed(speed, &RELIEVED);
    scene.bodies[FIRST.0] = scene.bodies[FIRST.0].clone().with_added(Inertia::axial(0.0, 2e-3, 0.0));
    scene.add_observable(Rotation(FIRST, 2));
    let inertia = scene.bodies[FIRST.0].inertia().polar();
    let cycles = 3.0;
    let (steps, damping) = (240, 2000.0);
    let dynamics = DynamicOptions {
        rayleigh: [damping, 0.0],
        ..moving(vec![TimeRange::steady(cycles * mesh.period, steps)])
    };
    let found: Vec<f64> = rows(&scene, &dynamics).into_iter().map(|(_, values)| values[0]).collect();
    // Static solution at every step, and its torsional stiffness.
    let system = system(&scene);
    let statics: Vec<[f64; 2]> = (0..=steps)
        .map(|k| {
            let step = system.solve(cycles * mesh.period * k as f64 / steps as f64).expect("equilibrium");
            let turn = system.value(&step, &Rotation(FIRST, 2)).value;
            let lever = mesh.base_radii[0];
            let stiffness = system.value(&step, &MeshStiffness(MESH)).value;
            [turn, stiffness * lever * lever]
        })
        .collect();
    // The same time integration for a single equation.
    let h = cycles * mesh.period / steps as f64;
    let (mut x, mut v, mut a) = (statics[0][0], 0.0, 0.0);
    let mut worst = 0.0f64;
    let swing = |values: &mut dyn Iterator<Item = f64>| {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        values.for_each(|value| (low, high) = (low.min(value), high.max(value)));
        high - low
    };
    let size = swing(&mut found.iter().copied());
    for k in 1..=steps {
        let [rest, stiffness] = statics[k];
        let (px, pv) = (x + h * v + 0.25 * h * h * a, v + 0.5 * h * a);
        let force = stiffness * (rest - px) - damping * inertia * pv;
        a = force / (inertia + 0.5 * h * damping * inertia + 0.25 * h * h * stiffness);
        (x, v) = (px + 0.25 * h * h * a, pv + 0.5 * h * a);
        worst = worst.max((x - found[k]).abs());
    }
    assert!(size > 0.2 * TORQUE / statics[0][1], "it vibrates: {size:e}");
    assert!(worst < 0.03 * size, "{worst:e} of {size:e}");
}

/// Continues from the stored state of an earlier run with the same bits.
#[test]
fn a_history_goes_on_where_it_was_left() {
    let (mut scene, mesh) = at_speed(200.0, &PLAIN);
    scene.add_observable(TransmissionError(MESH));
    let outputs = requests(&scene);
    let dynamics = moving(vec![TimeRange { keep: 3, ..TimeRange::steady(0.2 * mesh.period, 10) }]);
    let all: Vec<Solved> = History::new(&scene, &outputs, &options(), &dynamics, &mut ())
        .expect("it is analysed")
        .map(|solved| solved.expect("it is solved"))
        .collect();
    assert_eq!(all.len(), 5);
    for kept in [1, 3, 5] {
        let options = AnalysisOptions { solved: all[..kept].to_vec(), ..options() };
        let history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it goes on");
        let rest: Vec<Solved> = history.map(|solved| solved.expect("it is solved")).collect();
        assert_eq!(rest, all[kept..], "{kept}");
    }
}

#[test]
fn what_has_no_mass_cannot_move_in_time() {
    let body = rigid(&[Component::Ux], SteadyRotation::at_rest([0.5, 0.0]));
    let (scene, _) =
        with_rigid(body, Some(Bearing::new("soft", BodyId(0), 0.0, axisymmetric(1e5, 0.0, 0.0, 0.0))));
    let outputs = requests(&scene);
    let refused =
        History::new(&scene, &outputs, &options(), &moving(vec![TimeRange::steady(1.0, 10)]), &mut ());
    assert_eq!(refused.err().map(|error| error.code), Some("E0762"));
    let none = History::new(&scene, &outputs, &options(), &moving(Vec::new()), &mut ());
    assert_eq!(none.err().map(|error| error.code), Some("E0764"));
}

/// Two gears on their mesh, the second with an additional spring: a two-by-two eigenvalue problem
/// with the static mesh stiffness.
#[test]
fn natural_frequencies_are_those_of_the_closed_form() {
    let (mut scene, mesh) = at_speed(1.0, &PLAIN);
    scene.bodies[SECOND.0] = scene.bodies[SECOND.0].clone().free_in(&[Component::ThetaZ, Component::Ux]);
    let (torsional, radial) = (4e5, 3e8);
    let spring = Bearing::new("spring", SECOND, 0.0, axisymmetric(radial, 0.0, 0.0, torsional));
    scene.add_bearing(spring).expect("a bearing");
    let system = system(&scene);
    let step = system.solve(0.3 * mesh.period).expect("equilibrium");
    let found = Equilibrium::new(&system, &step).vibrations().expect("they vibrate");
    // M and K orthogonality, and the equations themselves.
    let (mass, stiffness) = (&found.mass, &found.stiffness);
    let unit = found.shapes.transpose() * mass * &found.shapes;
    let squares = found.shapes.transpose() * stiffness * &found.shapes;
    for i in 0..3 {
        for j in 0..3 {
            let (one, square) = if i == j { (1.0, found.frequencies[i].powi(2)) } else { (0.0, 0.0) };
            assert!((unit[(i, j)] - one).abs() < 1e-12);
            assert!((squares[(i, j)] - square).abs() < 1e-11 * found.frequencies[2].powi(2));
        }
    }
    // Expected values from the stiffness of the teeth along the line of action, the lever arms of
    // both gears, and the direction of the line.
    let [one, two] = [FIRST, SECOND].map(|id| scene.bodies[id.0].inertia());
    let [r1, r2] = mesh.base_radii;
    let alone = stiffness[(0, 0)] / (r1 * r1);
    let cosine = (r1 + r2) / (3.0 * 0.0254);
    // In the order of the degrees of freedom: the first gear's rotation, the second one's
    // displacement and rotation.
    let along = [r1, (1.0 - cosine * cosine).sqrt(), r2];
    let by_hand = nalgebra::Matrix3::from_fn(|i, j| {
        let masses = [one.polar(), two.mass, two.polar()];
        let own = if i == j { [0.0, radial, torsional][i] } else { 0.0 };
        (alone * along[i] * along[j] + own) / (masses[i] * masses[j]).sqrt()
    });
    let mut squares: Vec<f64> = by_hand.symmetric_eigenvalues().iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    for (square, omega) in squares.iter().zip(&found.frequencies) {
        assert!((square.sqrt() / omega - 1.0).abs() < 1e-9, "{} {omega}", square.sqrt());
    }
    let share =
        |body, components| system.value(&step, &ModeShare { mode: 0, body, components, elastic: true }).value;
    let all = share(FIRST, [true; 6]) + share(SECOND, [true; 6]);
    assert!((all - 1.0).abs() < 1e-12, "{all}");
    let lowest = system.value(&step, &NaturalFrequency(0)).value;
    assert!((lowest * TAU / found.frequencies[0] - 1.0).abs() < 1e-14);
}

/// The stiffness matrix that modes and inertia leave in a time step is not the stiffness of the
/// teeth.
#[test]
fn the_stiffness_of_a_mesh_in_time_is_that_of_statics() {
    let (mut scene, mesh) = at_speed(100.0, &PLAIN);
    scene.add_observable(MeshStiffness(MESH));
    let ranges = vec![TimeRange::steady(0.02 * mesh.period, 4)];
    let [rigid, modal] = [0.0, 60e3].map(|highest| rows_up_to(highest, &scene, &moving(ranges.clone())));
    for ((time, rigid), (_, modal)) in rigid.iter().zip(&modal) {
        assert!((rigid[0] / modal[0] - 1.0).abs() < 0.01, "{time}: {rigid:?} {modal:?}");
    }
}

/// Modes of the bodies leave statics and its stiffness unchanged to the bit: with their complete
/// static response they equal rigid bodies. Natural frequencies change slightly, more modes hardly
/// change them further, and the bodies contain part of the energy.
#[test]
fn modes_of_bodies_change_natural_frequencies_and_leave_statics_as_it_is() {
    let (mut scene, mesh) = at_speed(1.0, &PLAIN);
    let journal = Bearing::new("journal", SECOND, 0.0, axisymmetric(3e8, 0.0, 0.0, 4e5));
    scene.bodies[SECOND.0] = scene.bodies[SECOND.0].clone().free_in(&[Component::ThetaZ, Component::Ux]);
    scene.add_bearing(journal).expect("a bearing");
    let plan = calyx_runtime::plan::Plan::new(&scene, Fidelity::Plane, COARSE).expect("a plan");
    let resources = calyx_runtime::resources::Resources::default();
    let rigid = system(&scene);
    let time = 0.3 * mesh.period;
    let step = rigid.solve(time).expect("equilibrium");
    let plain = Equilibrium::new(&rigid, &step).vibrations().expect("they vibrate");
    let mut last = plain.frequencies[..2].to_vec();
    for highest in [40e3, 80e3] {
        let elastic = system(&scene).with_modes(&plan, &resources, highest).expect("modes");
        let again = elastic.solve(time).expect("equilibrium");
        assert_eq!((&again.motion, &again.problem.compliance), (&step.motion, &step.problem.compliance));
        let found = Equilibrium::new(&elastic, &again).vibrations().expect("they vibrate");
        let count = found.frequencies.len();
        assert!(count > 3, "{count}");
        // Static condensation of the modal coordinates.
        let block = |i: usize, j: usize, rows: usize, columns: usize| {
            found.stiffness.view((i, j), (rows, columns)).into_owned()
        };
        let modal = block(3, 3, count - 3, count - 3).cholesky().expect("definite");
        let left = block(0, 0, 3, 3) - block(0, 3, 3, count - 3) * modal.solve(&block(3, 0, count - 3, 3));
        let error = (&left - &plain.stiffness).amax() / plain.stiffness.amax();
        assert!(error < 1e-9, "{error:e}");
        // The lowest frequencies, which are far below those of the bodies alone.
        for (mode, last) in last.iter_mut().enumerate() {
            let changed = (found.frequencies[mode] / plain.frequencies[mode] - 1.0).abs();
            assert!(changed > 1e-6 && changed < 0.05, "{mode}: {changed:e}");
            let more = (found.frequencies[mode] / *last - 1.0).abs();
            assert!(highest < 50e3 || more < 0.3 * changed, "{mode}: {more:e} of {changed:e}");
            *last = found.frequencies[mode];
        }
        let share = |body, elastic_too| {
            let share = ModeShare { mode: 2, body, components: [true; 6], elastic: elastic_too };
            elastic.value(&again, &share).value
        };
        let all = share(FIRST, true) + share(SECOND, true);
        assert!((all - 1.0).abs() < 1e-9 && share(FIRST, false) + share(SECOND, false) < 1.0 - 1e-5, "{all}");
    }
}
