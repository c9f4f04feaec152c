//! Gears on bearings in two dimensions, compared with closed forms. All cells of a patch act along
//! one normal, so the contribution of a bearing is exact.

use crate::common::pair::{
    COARSE, FIRST, MESH, PLAIN, PairOptions, SECOND, Scale, TORQUE, chapter_5_member, pair, system,
};
use calyx_runtime::analysis::{AnalysisOptions, mesh_cycle, quasi_static};
use calyx_runtime::bearing::{Bearing, Stop, axisymmetric};
use calyx_runtime::contact::interior_point;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    BearingDeflection, BearingForce, Direction, Displacement, Equilibrium, MaxContactPressure, MeshStiffness,
    Observable, TransmissionError, UnloadedTransmissionError,
};
use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{BearingId, Body, BodyId, Component, Fidelity, GearMesh, Scene};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

const K: f64 = 2e8;
const BEARING: BearingId = BearingId(0);
/// Free components of the second gear in addition to rotation.
const ACROSS: [Component; 2] = [Component::Ux, Component::Uy];

/// The chapter 5 pair on bearings, with a second gear that is free to move in the plane.
fn on(bearings: impl IntoIterator<Item = Bearing>) -> (Scene, GearMesh) {
    let (mut scene, mesh) = pair(&PairOptions::chapter_5(&PLAIN));
    scene.bodies[SECOND.0] = scene.bodies[SECOND.0].clone().free_in(&ACROSS);
    for bearing in bearings {
        scene.add_bearing(bearing).expect("a bearing");
    }
    (scene, mesh)
}

fn radial(stiffness: f64) -> Bearing {
    Bearing::new("bearing", SECOND, 0.0, axisymmetric(stiffness, 0.0, 0.0, 0.0))
}

fn with_stop(stiffness: f64, stop: Stop) -> Bearing {
    Bearing { stops: vec![stop], ..radial(stiffness) }
}

/// Force along the line of action and the base radius of the second gear.
fn force() -> (f64, f64) {
    let [first, second] = [0, 1].map(|side: usize| PLAIN[side].form().base_radius);
    (TORQUE / first, second)
}

fn solved<T>((scene, mesh): &(Scene, GearMesh), look: impl FnOnce(&System<'_>, &StepResult) -> T) -> T {
    let system = system(scene);
    let step = system.solve(mesh.start + 0.6 * mesh.period).expect("it is in equilibrium");
    assert!(step.certificate.largest() <= 1e-11, "{:?}", step.certificate);
    look(&system, &step)
}

fn value(scene: &(Scene, GearMesh), observable: &dyn Observable) -> f64 {
    solved(scene, |system, step| system.value(step, observable).value)
}

/// Transmission error along the line of action, m.
fn lag(scene: &(Scene, GearMesh)) -> f64 {
    force().1 * value(scene, &TransmissionError(MESH))
}

fn constrained() -> (Scene, GearMesh) {
    pair(&PairOptions::chapter_5(&PLAIN))
}

#[test]
fn a_gear_on_a_bearing_gives_by_force_over_stiffness_and_so_does_the_mesh() {
    let (force, _) = force();
    let given = force / K;
    let sprung = on([radial(K)]);
    let [x, y] = [0, 1].map(|axis| value(&sprung, &Displacement(SECOND, axis)));
    assert!((x.hypot(y) / given - 1.0).abs() < 1e-10, "{} {given}", x.hypot(y));
    assert!(((lag(&sprung) - lag(&constrained())) / given - 1.0).abs() < 1e-8);
    // Direction of the line of action: away from the driver, at the operating pressure angle.
    let borne = [0, 1].map(|axis| value(&sprung, &BearingForce(BEARING, Direction::Ground(axis))));
    assert!((borne[0].hypot(borne[1]) / force - 1.0).abs() < 1e-10);
    assert!((borne[0] + K * x).abs() < 1e-10 * force && (borne[1] + K * y).abs() < 1e-10 * force);
    // As the load vanishes, all deflections vanish.
    let [unloaded, as_constrained] =
        [&sprung, &constrained()].map(|scene| value(scene, &UnloadedTransmissionError(MESH)));
    assert!((unloaded - as_constrained).abs() < 1e-15, "{unloaded} {as_constrained}");
    // Springs in series.
    let [soft, hard] = [&sprung, &constrained()].map(|scene| value(scene, &MeshStiffness(MESH)));
    assert!((soft * (1.0 / hard + 1.0 / K) - 1.0).abs() < 1e-9, "{soft} {hard}");
}

#[test]
fn ever_stiffer_bearings_converge_to_a_constrained_gear() {
    let constrained = lag(&constrained());
    let [near, nearer] = [1e10, 1e12].map(|stiffness| lag(&on([radial(stiffness)])) - constrained);
    assert!((near / nearer / 100.0 - 1.0).abs() < 1e-3, "{near} {nearer}");
}

#[test]
fn bodies_in_a_row_are_springs_in_series_and_nothing_is_lost_on_the_way() {
    let (mut scene, mesh) = on([]);
    let carrier = Body::new("carrier", Arc::new(PLAIN[1].clone()), scene_motion(&scene)).free_in(&ACROSS);
    let carrier = scene.add_body(carrier);
    let [one, other] = [K, 0.25 * K].map(|k| axisymmetric(k, 0.0, 0.0, 0.0));
    scene.add_bearing(Bearing::new("pin", SECOND, 0.0, one).between(carrier)).expect("a bearing");
    scene.add_bearing(Bearing::new("housing", carrier, 0.0, other)).expect("a bearing");
    let scene = (scene, mesh);
    let (force, _) = force();
    assert!(((lag(&scene) - lag(&constrained())) / (5.0 * force / K) - 1.0).abs() < 1e-8);
    let plan = Plan::new(&scene.0, Fidelity::Plane, COARSE).expect("a plan");
    assert!(plan.bodies[carrier.0].rigid && !plan.bodies[carrier.0].left_out);
    assert_eq!(plan.structures(&scene.0).iter().flatten().count(), 2);
    solved(&scene, |system, step| {
        let at = Equilibrium::new(system, step);
        let mut on_ground = [0.0; 3];
        for body in [FIRST, SECOND, carrier] {
            let support = at.support(body);
            let free = scene.0.bodies[body.0].free;
            assert!((0..6).all(|k| !free[k] || support[k].abs() < 1e-10 * TORQUE.max(force)), "{support:?}");
            let load = scene.0.bodies[body.0].load.at(0.0).force;
            (0..3).for_each(|k| on_ground[k] += support[k] + load[k]);
        }
        let housing = at.bearing(BearingId(1)).expect("it is there").wrench_on(carrier);
        (0..3).for_each(|k| on_ground[k] += housing[k]);
        assert!(on_ground.iter().all(|part| part.abs() < 1e-10 * force), "{on_ground:?}");
    });
}

/// Motion of the second gear's axis, at rest.
fn scene_motion(scene: &Scene) -> SteadyRotation {
    let frame = scene.bodies[SECOND.0].motion.frame(0.0);
    let origin =
        [-(frame[0] * frame[9] + frame[3] * frame[10]), -(frame[1] * frame[9] + frame[4] * frame[10])];
    SteadyRotation::at_rest(origin)
}

#[test]
fn unloaded_deformations_and_loads_move_what_the_springs_hold() {
    let (force, _) = force();
    let plain = on([radial(K)]);
    let before = [0, 1].map(|axis| value(&plain, &Displacement(SECOND, axis)));
    let unloaded = on([Bearing { unloaded: [3e-6, -2e-6, 0.0, 0.0, 0.0, 0.0], ..radial(K) }]);
    let pushed = on([Bearing { load: [3e-6 * K, -2e-6 * K, 0.0, 0.0, 0.0, 0.0], ..radial(K) }]);
    for scene in [unloaded, pushed] {
        for (axis, shift) in [3e-6, -2e-6].into_iter().enumerate() {
            let moved = value(&scene, &Displacement(SECOND, axis)) - before[axis];
            assert!((moved - shift).abs() < 1e-10 * force / K, "{moved} {shift}");
            // The teeth carry the same load, and the bearing reacts to it.
            let [own, other] =
                [&scene, &plain].map(|scene| value(scene, &BearingForce(BEARING, Direction::Ground(axis))));
            assert!((own - other).abs() < 1e-9 * force, "{own} {other}");
        }
    }
}

#[test]
fn a_wall_bears_nothing_until_its_clearance_is_used_up_and_its_stiffness_beyond() {
    let (force, _) = force();
    let plain = on([radial(K)]);
    let free = value(&plain, &Displacement(SECOND, 0));
    let wall = |clearance: f64| {
        let direction = [-free.signum(), 0.0, 0.0, 0.0, 0.0, 0.0];
        on([with_stop(K, Stop::Wall { clearance, direction, stiffness: 3.0 * K })])
    };
    let open = wall(1.01 * free.abs());
    assert_eq!(solved(&open, |_, step| step.stops.clone()), [0.0]);
    assert!((value(&open, &Displacement(SECOND, 0)) - free).abs() < 1e-10 * free.abs());
    let clearance = 0.4 * free.abs();
    let closed = wall(clearance);
    // K u + 3 K (u - delta) = K u_free.
    let expected = (free.abs() + 3.0 * clearance) / 4.0;
    let moved = value(&closed, &Displacement(SECOND, 0)).abs();
    assert!((moved / expected - 1.0).abs() < 1e-9, "{moved} {expected}");
    let borne = value(&closed, &BearingForce(BEARING, Direction::Ground(0)));
    assert!((borne + K * free).abs() < 1e-9 * force, "{borne}");
}

#[test]
fn a_ring_gives_by_its_clearance_and_then_by_its_stiffness_alike_in_all_directions() {
    let (force, base_radius) = force();
    let clearance = 25e-6;
    for direction in [0.0, 0.7, 2.1] {
        let options = PairOptions { direction, ..PairOptions::chapter_5(&PLAIN) };
        let (mut scene, mesh) = pair(&options);
        scene.bodies[SECOND.0] = scene.bodies[SECOND.0].clone().free_in(&ACROSS);
        let ring = Stop::Ring { clearance, stiffness: K };
        scene.add_bearing(with_stop(0.0, ring)).expect("a bearing");
        let scene = (scene, mesh);
        let borne = value(&scene, &BearingForce(BEARING, Direction::Radial));
        assert!((borne / force - 1.0).abs() < 1e-9, "{borne} {force}");
        let moved = value(&scene, &BearingDeflection(BEARING, Direction::Radial));
        assert!((moved / (clearance + force / K) - 1.0).abs() < 2e-3, "{moved}");
        let more = (clearance + force / K) / base_radius;
        let [own, rigid] = [&scene, &constrained()].map(|scene| value(scene, &TransmissionError(MESH)));
        assert!(((own - rigid) / more - 1.0).abs() < 2e-3, "{own} {rigid} {more}");
        // The clearance remains closed as the load vanishes.
        let unloaded = value(&scene, &UnloadedTransmissionError(MESH)) * base_radius;
        assert!((unloaded / clearance - 1.0).abs() < 5e-3, "{unloaded}");
        let (forces, again) = solved(&scene, |_, step| {
            let mut forces = vec![0.0; step.problem.cells()];
            let cells: Vec<f64> = step.patches.iter().flat_map(|patch| patch.forces.clone()).collect();
            forces[..cells.len()].copy_from_slice(&cells);
            forces[cells.len()..].copy_from_slice(&step.stops);
            let (again, _) = interior_point::solve(&step.problem).expect("it converges");
            (step.problem.objective(&forces, &step.motion), step.problem.objective(&again, &step.motion))
        });
        assert!((forces / again - 1.0).abs() < 1e-6, "{forces} {again}");
    }
}

#[test]
fn a_gear_that_stays_on_its_grid_is_solved_where_its_frame_is() {
    let (start, warnings) = solved(&on([radial(K)]), |_, step| (step.start.clone(), step.warnings.clone()));
    assert!(start.iter().all(|&moved| moved == 0.0) && warnings.is_empty(), "{start:?} {warnings:?}");
}

/// The scene with its second gear fixed at the position to which the bearings of another scene have
/// moved it, and its first gear rotated until rigid teeth touch; also returns this rotation.
fn constrained_at(scene: &Scene, mesh: &GearMesh, [x, y]: [f64; 2]) -> (Scene, f64) {
    let SteadyRotation { origin: [from_x, from_y], .. } = scene_motion(scene);
    let mut constrained = scene.clone();
    constrained.bearings.clear();
    let speed = -0.5 * 0.05 * TAU;
    constrained.bodies[SECOND.0].motion =
        Arc::new(SteadyRotation { origin: [from_x + x, from_y + y], start: 0.0, speed });
    constrained.bodies[SECOND.0].free = [false; 6];
    let mut turn = 0.0;
    for _ in 0..3 {
        let mut unloaded = constrained.clone();
        unloaded.bodies[FIRST.0].load = Arc::new(Wrench::NONE);
        let unloaded = (unloaded, mesh.clone());
        let more = solved(&unloaded, |_, step| step.motion[0]);
        constrained.bodies[FIRST.0].phase += more;
        turn += more;
    }
    (constrained, turn)
}

/// Soft bearings, preloads and clearances that move the second gear by up to a tenth of a module
/// (2.54 mm): the solution equals that with the gear fixed there, and the operating pressure angle
/// is that of the new centre distance.
#[test]
fn a_gear_that_is_carried_far_is_solved_where_it_is_carried() {
    let (force, _) = force();
    let soft = force / 0.15e-3;
    let ring = Stop::Ring { clearance: 0.3e-3, stiffness: 0.2 * K };
    let offset = |x: f64, y: f64| Bearing { unloaded: [x, y, 0.0, 0.0, 0.0, 0.0], ..radial(soft) };
    let cases = [
        radial(0.4 * soft),
        offset(0.25e-3, 0.0),
        offset(-0.05e-3, 0.2e-3),
        with_stop(0.0, ring.clone()),
        with_stop(0.3 * soft, ring),
    ];
    for bearing in cases {
        let (scene, mesh) = on([bearing]);
        let (motion, borne, pressures) = solved(&(scene.clone(), mesh.clone()), |system, step| {
            assert!(step.warnings.is_empty(), "{:?}", step.warnings);
            assert!(step.start.iter().any(|&moved| moved != 0.0), "{:?}", step.motion);
            let at = Equilibrium::new(system, step);
            let (contact, constrained) = (at.contact_force(SECOND), at.bearings_on(SECOND));
            assert!(
                (0..2).all(|k| (contact[k] + constrained[k]).abs() < 1e-10 * force),
                "{contact:?} {constrained:?}"
            );
            (step.motion.clone(), contact, system.value(step, &MaxContactPressure(MESH)).value)
        });
        let [turn, x, y] = motion[..] else { panic!("three freedoms") };
        assert!((0.1e-3..0.5e-3).contains(&x.hypot(y)), "{x} {y}");
        let (constrained, before) = constrained_at(&scene, &mesh, [x, y]);
        solved(&(constrained, mesh.clone()), |system, step| {
            let contact = system.contact_force(step, SECOND);
            for k in 0..2 {
                // A shift of a thousandth of half a grid rotates the line of action by some
                // millionths.
                assert!((contact[k] - borne[k]).abs() < 5e-6 * force, "{contact:?} {borne:?}");
            }
            let own = step.motion[0];
            assert!((turn - before - own).abs() < 1e-5 * own.abs(), "{turn} {before} {own}");
            let pressure = system.value(step, &MaxContactPressure(MESH)).value;
            assert!((pressure / pressures - 1.0).abs() < 1e-5, "{pressure} {pressures}");
        });
        // The torque is the force times the base radius, and the force is inclined by the operating
        // pressure angle of the new distance.
        assert!((borne[0].hypot(borne[1]) / force - 1.0).abs() < 1e-9, "{borne:?} {force}");
        let across = [scene_motion(&scene).origin[0] + x, scene_motion(&scene).origin[1] + y];
        let distance = across[0].hypot(across[1]);
        let cosine = (mesh.base_radii[0] + mesh.base_radii[1]) / distance;
        let apart = (borne[0] * across[0] + borne[1] * across[1]) / (force * distance);
        assert!((apart / (1.0 - cosine * cosine).sqrt() - 1.0).abs() < 1e-5, "{apart} {cosine}");
    }
}

/// The transmission error of a displaced gear is that at its new position. Without load, that of
/// unmodified involutes is constant, because their ratio does not depend on the centre distance.
#[test]
fn without_load_a_clearance_that_is_used_up_is_geometry_not_first_order() {
    let ring = Stop::Ring { clearance: 0.4e-3, stiffness: K };
    let (scene, mesh) = on([with_stop(0.0, ring)]);
    let system = system(&scene);
    let errors: Vec<f64> = [0.1, 0.4, 0.7, 0.95]
        .map(|part| {
            let step = system.solve(mesh.start + part * mesh.period).expect("it is in equilibrium");
            assert!(step.warnings.is_empty(), "{:?}", step.warnings);
            system.value(&step, &UnloadedTransmissionError(MESH)).value
        })
        .to_vec();
    assert!(errors.iter().all(|error| (error / errors[0] - 1.0).abs() < 1e-5), "{errors:?}");
}

#[test]
fn units_make_no_difference() {
    let of = |length: f64, modulus: f64| {
        let scale = Scale { length, modulus };
        let gears = [20, 40].map(|teeth| chapter_5_member(teeth, 0.0, scale));
        let plain = PairOptions::chapter_5(&gears);
        let (distance, moment) = (length * plain.center_distance, modulus * length.powi(3) * plain.moment);
        let (mut scene, mesh) = pair(&PairOptions { center_distance: distance, moment, ..plain });
        scene.bodies[SECOND.0] = scene.bodies[SECOND.0].clone().free_in(&ACROSS);
        let ring = Stop::Ring { clearance: length * 1e-5, stiffness: modulus * length * K };
        scene.add_bearing(with_stop(modulus * length * 0.1 * K, ring)).expect("a bearing");
        value(&(scene, mesh), &TransmissionError(MESH))
    };
    let [one, other] = [of(1.0, 1.0), of(40.0, 1e-3)];
    assert!((one / other - 1.0).abs() < 1e-8, "{one} {other}");
}

#[test]
fn bits_do_not_depend_on_threads() {
    let ring = Stop::Ring { clearance: 1e-5, stiffness: K };
    let (mut scene, mesh) = on([with_stop(0.1 * K, ring)]);
    let force = scene.add_observable(BearingForce(BEARING, Direction::Radial));
    let outputs = [OutputRequest::observing("force", force)];
    let positions = mesh_cycle(&mesh, 4);
    let rows = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let resources = Resources { pool: Some(Arc::new(pool)), ..Resources::default() };
        let options = AnalysisOptions { structure: COARSE, resources, ..AnalysisOptions::default() };
        let result = quasi_static(&scene, &positions, &outputs, &options, &mut ()).expect("it is solved");
        assert!(result.certificate.largest() < 1e-11);
        result.rows.iter().map(|row| row.outputs[0].value.to_bits()).collect::<Vec<_>>()
    });
    assert_eq!(rows[0], rows[1]);
}

#[test]
fn bearings_that_nothing_depends_on_are_left_out_with_the_reason() {
    let (mut scene, _) = constrained();
    scene.add_bearing(radial(K)).expect("a bearing");
    let idler = scene.add_body(
        Body::new("idler", Arc::new(PLAIN[0].clone()), SteadyRotation::at_rest([1.0, 0.0]))
            .free_in(&[Component::Ux]),
    );
    let own = axisymmetric(K, K, K, 0.0);
    let damping = axisymmetric(1.0, 0.0, 0.0, 0.0);
    scene.add_bearing(Bearing { damping, ..Bearing::new("idle", idler, 0.0, own) }).expect("a bearing");
    let reasons = |scene: &Scene| {
        let plan = Plan::new(scene, Fidelity::Plane, COARSE).expect("a plan");
        let ignored: Vec<String> = plan.ignored.into_iter().map(|ignored| ignored.input).collect();
        (
            plan.bearings.into_iter().map(|bearing| (bearing.left_out, bearing.reason)).collect::<Vec<_>>(),
            ignored,
        )
    };
    let (bearings, ignored) = reasons(&scene);
    assert!(bearings[0].0 && bearings[0].1.contains("constrained"), "{bearings:?}");
    assert!(bearings[1].0 && bearings[1].1.contains("no output depends"), "{bearings:?}");
    assert!(ignored.is_empty());
    scene.add_observable(Displacement(idler, 0));
    let (bearings, ignored) = reasons(&scene);
    assert!(!bearings[1].0, "{bearings:?}");
    assert_eq!(ignored, ["bearing", "damping"]);
}

#[test]
fn what_a_bearing_cannot_be_is_refused_with_the_reason() {
    let mut unsymmetric = axisymmetric(K, 0.0, 0.0, 0.0);
    unsymmetric[0][1] = 0.1 * K;
    let mut giving = unsymmetric;
    giving[0][1] = 2.0 * K;
    giving[1][0] = 2.0 * K;
    let plain = radial(K);
    let cases = [
        (Bearing { stiffness: unsymmetric, ..plain.clone() }, "E0686", "not symmetric: between u_y and u_x"),
        (
            Bearing { stiffness: giving, ..plain.clone() },
            "E0686",
            "negative eigenvalue: moved in u_x and u_y",
        ),
        (
            Bearing { stiffness: axisymmetric(K, -1.0, 0.0, 0.0), ..plain.clone() },
            "E0686",
            "for u_z is negative",
        ),
        (plain.clone().between(SECOND), "E0685", "both races on one body"),
        (plain.clone().between(FIRST), "E0687", "do not stay together"),
        (Bearing { at: [1e-3, 0.0, 0.0], ..plain.clone() }, "E0687", "do not stay together"),
        (with_stop(K, Stop::Ring { clearance: 1e-6, stiffness: 0.0 }), "E0688", "no stiffness behind it"),
    ];
    for (bearing, code, words) in cases {
        let (mut scene, _) = on([]);
        let error = scene.add_bearing(bearing).expect_err(words);
        assert_eq!(error.code, code, "{}", error.message);
        assert!(error.message.contains(words), "{}: {words}", error.message);
        assert!(!error.help.is_empty());
    }
    // Handles of another scene with more bodies.
    for foreign in [Bearing { body: BodyId(7), ..plain.clone() }, plain.clone().between(BodyId(7))] {
        let (mut scene, mesh) = on([]);
        let error = scene.add_bearing(foreign.clone()).expect_err("no such body");
        assert_eq!(error.code, "E0653", "{}", error.message);
        assert!(error.message.contains("body 7") && error.help.contains("add_body"), "{}", error.message);
        // If added directly, the bearing is left out, or rejected when the scene is analysed.
        let left_out = foreign.body != SECOND;
        scene.bearings.push(foreign);
        let options = AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() };
        let error = quasi_static(&scene, &mesh_cycle(&mesh, 2), &[], &options, &mut ())
            .expect_err("nothing holds it");
        assert_eq!(error.code, if left_out { "E0714" } else { "E0653" }, "{}", error.message);
    }
    let (mut scene, _) = on([plain.clone()]);
    assert_eq!(scene.add_bearing(plain).expect_err("the name is taken").code, "E0671");
}

#[test]
fn what_bearings_leave_free_is_named() {
    // The bearing is stiff along y only, and the force has a part along x.
    let mut along_y = axisymmetric(0.0, 0.0, 0.0, 0.0);
    along_y[1][1] = K;
    let (scene, mesh) = on([Bearing::new("bearing", SECOND, 0.0, along_y)]);
    let error = system(&scene).solve(mesh.start).expect_err("nothing holds it");
    assert_eq!(error.code, "E0714");
    assert!(error.message.contains("u_x of body \"second\""), "{}", error.message);
    assert!(error.help.contains("bearing"), "{}", error.help);
    let options = AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() };
    let early =
        quasi_static(&scene, &mesh_cycle(&mesh, 2), &[], &options, &mut ()).expect_err("it is known before");
    assert_eq!(early.code, "E0714");
}
