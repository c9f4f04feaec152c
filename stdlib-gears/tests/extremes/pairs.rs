//! Gears in mesh with loads, sizes, speeds and stiffnesses far from the usual range.

use super::case::{Case, off, refusal, worst};
use crate::common::INCH;
use crate::common::pair::{
    FIRST, Member, PLAIN, PairOptions, RELIEVED, Scale, TORQUE, UNSCALED, Values, chapter_5_member, pair,
    solve_at, steel, system,
};
use crate::solid::pairs::{self as solid_pairs, Options};
use calyx_gears::assembly::{MeshOptions, Misalignment, add_body, mesh};
use calyx_gears::error::Refusal;
use calyx_gears::helix::{Hand, Helix};
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Plane;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::MeshForce;
use calyx_runtime::observables::Observe;
use calyx_runtime::scene::{Body, Component, Scene};
use std::f64::consts::{PI, TAU};

/// Fraction of the cycle at which one tooth pair carries, in the middle of its path of contact.
const ALONE: f64 = 0.75;
/// Fraction of the cycle at which two tooth pairs carry.
const TWO: f64 = 0.25;

pub fn cases() -> Vec<Case> {
    vec![
        Case::holds(
            "A spur pair: peak pressure against load",
            "1e-6 to 1 times the nominal load",
            5e-3,
            "Hertz: square root of the load; at a contact width of a fiftieth of the radius the curvature of the flanks adds a correction",
            || worst([1e-6, 1e-3, 0.1].map(pressed)),
        ),
        Case::holds(
            "The same",
            "1e-9 times the nominal load",
            0.1,
            "Hertz: the contact is 5 nm wide, and its gaps of 1e-15 m are at the rounding limit of the positions",
            || pressed(1e-9),
        ),
        Case::holds(
            "A spur pair: root stress against load",
            "1e-9 to 1 times the nominal load",
            1e-2,
            "the teeth are linear elastic",
            || {
                let nominal = loaded(1.0, ALONE).root_stress;
                worst(LIGHT.into_iter().flat_map(|part| {
                    let found = loaded(part, ALONE).root_stress;
                    [0, 1].map(|side: usize| off(found[side], part * nominal[side]))
                }))
            },
        ),
        Case::holds(
            "A spur pair: growth of the compliance as the load vanishes",
            "1e-9 to 1 times the nominal load",
            1e-2,
            "Hertz: its logarithm, in closed form",
            logarithm_of_the_load,
        ),
        Case::holds(
            "A spur pair: stresses, load shares, transmission error",
            "modules of 1e-5 m and 10 m, loads scaled alike",
            1e-7,
            "scaling: only lengths change",
            || worst([1e-5, 10.0].map(|module| scaled(module / (0.1 * INCH)))),
        ),
        Case::holds(
            "A two-dimensional spur pair",
            "face widths of 0.1 and 100 modules, loads scaled alike",
            1e-12,
            "scaling",
            || worst([0.1, 100.0].map(as_wide)),
        ),
        Case::holds(
            "A spur pair: compliance with a mate that is 1e12 times as stiff",
            "the one, the other, and both of steel",
            5e-3,
            "superposition, with Hertz's logarithm of the narrower contact in closed form",
            beside_a_stiff_mate,
        ),
        Case::holds(
            "A position",
            "100,000 revolutions later",
            1e-5,
            "the same position in the first revolution",
            || after(1e5),
        ),
        Case::holds(
            "A position",
            "speeds of 1e-9 and 1e9 rad/s",
            1e-9,
            "a static solution does not depend on speed",
            || worst([1e-9, 1e9].map(at_speed)),
        ),
        Case::holds(
            "A pair with tip reliefs of 13 um: transmission error",
            "a millionth of the nominal load, at which the relieved flanks are separated",
            0.1,
            "the relief at the nominal path of contact, to the first order of its slope",
            || worst([0.2, TWO, 0.28].map(far_relieved)),
        ),
        Case::holds(
            "A pair without backlash: force on both sides of the teeth",
            "no load, centre distances 0.1 and 1.1 um below that of zero backlash",
            1e-9,
            "statics: equal forces on both sides",
            || worst([-1e-7, -1.1e-6].map(tight)),
        ),
        Case::warns(
            "The same without a search for back-side contact",
            "a centre distance 0.1 mm below",
            "the backlash is negative",
            "contact is searched on the driving flanks only",
            || meshed(-1e-4, false).expect("they mesh").1,
        ),
        Case::holds(
            "A three-dimensional helical pair: ratio of axial to tangential force",
            "helix angles of 0.001 and 45 deg",
            1e-9,
            "the tangent of the helix angle",
            || worst([1e-3_f64, 45.0].map(|angle| axial(angle.to_radians(), 8.0))),
        ),
        Case::refused("A helix", "61 deg", "E0622", "outside the range of gears on parallel axes", || {
            refusal(Helix::new(61_f64.to_radians(), Hand::Left))
        }),
        Case::holds(
            "A three-dimensional helical pair: ratio of axial to tangential force",
            "faces of 0.1 and 100 modules at 20 deg",
            1e-9,
            "the tangent of the helix angle",
            || worst([0.1, 100.0].map(|modules| axial(20_f64.to_radians(), modules))),
        ),
        Case::holds(
            "A three-dimensional spur pair: torque ratio",
            "misalignment of 3 deg, contact in a corner of the face",
            1e-2,
            "the numbers of teeth",
            || {
                let misalignment = Misalignment { in_action: 3_f64.to_radians(), off_action: 0.0 };
                torques(&Options { misalignment, ..Options::spur() })
            },
        ),
    ]
}

/// Error of the peak pressure relative to the square root of the load.
fn pressed(part: f64) -> f64 {
    off(loaded(part, ALONE).contact_pressure, part.sqrt() * loaded(1.0, ALONE).contact_pressure)
}

const LIGHT: [f64; 4] = [1e-9, 1e-6, 1e-3, 0.1];

fn plain() -> PairOptions {
    PairOptions::chapter_5(&PLAIN)
}

fn loaded(part: f64, cycle: f64) -> Values {
    solve_at(&PairOptions { moment: part * TORQUE, ..plain() }, &[cycle])[0]
}

/// Line load on the line of action, N/m, and the base radius of the first gear, m.
fn line_load() -> (f64, f64) {
    let radius = PLAIN[0].gear().base_radius;
    (TORQUE / radius / INCH, radius)
}

/// The approach of a line contact of two half-planes is `q (C - ln q / (pi E*))`.
fn logarithm_of_the_load() -> f64 {
    let (load, radius) = line_load();
    let modulus = 0.5 * steel().surface_modulus(Plane::Strain);
    // The transmission error refers to the second gear, which has twice the radius.
    let by_decade = load / (2.0 * radius) * 10_f64.ln() / (PI * modulus);
    let parts = [1e-9, 1e-6, 1e-3, 1.0];
    let compliance = parts.map(|part| loaded(part, ALONE).transmission_error.abs() / part);
    worst(compliance.windows(2).map(|pair| off(pair[0] - pair[1], 3.0 * by_decade)))
}

fn scaled(length: f64) -> f64 {
    let scale = Scale { length, ..UNSCALED };
    let gears = [20, 40].map(|teeth| chapter_5_member(teeth, 0.0, scale));
    let options = PairOptions {
        gears,
        center_distance: 3.0 * INCH * length,
        moment: TORQUE * length.powi(3),
        ..plain()
    };
    let found = solve_at(&options, &[TWO])[0];
    let known = loaded(1.0, TWO);
    worst([
        off(found.transmission_error, known.transmission_error),
        off(found.load_share, known.load_share),
        off(found.contact_pressure, known.contact_pressure),
        off(found.root_stress[0], known.root_stress[0]),
        off(found.root_stress[1], known.root_stress[1]),
    ])
}

fn as_wide(modules: f64) -> f64 {
    let width = modules * 0.1 * INCH;
    let gears = [(20, &PLAIN[0]), (40, &PLAIN[1])].map(|(teeth, plain)| {
        let member = chapter_5_member(teeth, 0.0, UNSCALED);
        let mut prototype = std::sync::Arc::try_unwrap(member.prototype).ok().expect("nobody else has it");
        prototype.face_width = width;
        Member::new(prototype).sharing(plain)
    });
    let options = PairOptions { gears, moment: TORQUE * width / INCH, ..plain() };
    let found = solve_at(&options, &[TWO])[0];
    // For the whole face width.
    let stiffness = found.mesh_stiffness * INCH / width;
    Values { mesh_stiffness: stiffness, ..found }.difference(&loaded(1.0, TWO))
}

/// Each tooth deflects by `q (C - 2 ln a / (pi E'))`, and the contact on a stiff mate is narrower
/// by the square root of two.
fn beside_a_stiff_mate() -> f64 {
    let stiff = Scale { modulus: 1e12, ..UNSCALED };
    let [pinion, gear] = [20, 40].map(|teeth| chapter_5_member(teeth, 0.0, stiff));
    let error = |gears| solve_at(&PairOptions { gears, ..plain() }, &[ALONE])[0].transmission_error.abs();
    let [of_pinion, of_gear] = [error([PLAIN[0].clone(), gear]), error([pinion, PLAIN[1].clone()])];
    let both = loaded(1.0, ALONE).transmission_error.abs();
    let (load, radius) = line_load();
    let narrower = 2.0 * load * 2_f64.ln() / (PI * steel().surface_modulus(Plane::Strain)) / (2.0 * radius);
    off(of_pinion + of_gear - narrower, both)
}

fn after(revolutions: f64) -> f64 {
    let (scene, mesh) = pair(&plain());
    let system = system(&scene);
    let values = |revolutions: f64| {
        let time = mesh.start + TWO * mesh.period + revolutions * TAU / plain().speed;
        Values::of(&system, &system.solve(time).expect("equilibrium"))
    };
    // The gear makes half as many, an integer number of rotations.
    values(revolutions).difference(&values(0.0))
}

fn at_speed(speed: f64) -> f64 {
    solve_at(&PairOptions { speed, ..plain() }, &[TWO])[0].difference(&loaded(1.0, TWO))
}

/// Transmission error of relieved flanks under a very small load: on the line of action, the
/// smaller one of both pairs' gaps.
fn far_relieved(cycle: f64) -> f64 {
    let (depth, gears) = (0.0005, RELIEVED.clone());
    let options = PairOptions { gears: gears.clone(), moment: 1e-6 * TORQUE, ..plain() };
    let (_, mesh) = pair(&options);
    let [first, second] = [0, 1].map(|k: usize| gears[k].form());
    // Length of the line of action between the base circles.
    let length = {
        let sum: f64 = mesh.base_radii.iter().sum();
        let distance = options.center_distance;
        (distance * distance - sum * sum).sqrt()
    };
    let lacks = |form: &calyx_gears::gear::ToothForm, start: f64, roll: f64| {
        let tip = form.roll_at_radius(form.tip_radius);
        let part = ((roll - start) / (tip - start)).max(0.0);
        depth * INCH * part * part
    };
    let pitch = TAU / f64::from(first.teeth);
    let of_pair = |ahead: f64| {
        let roll = mesh.roll[0] + (cycle + ahead) * pitch;
        let other = (length - mesh.base_radii[0] * roll) / mesh.base_radii[1];
        lacks(&first, 27.25_f64.to_radians(), roll) + lacks(&second, 19.60_f64.to_radians(), other)
    };
    let known = of_pair(0.0).min(of_pair(1.0)) / mesh.base_radii[1];
    let found = solve_at(&options, &[cycle])[0].transmission_error.abs();
    off(found, known)
}

/// Pair at a centre distance different from that without backlash, and its diagnostics.
fn meshed(apart: f64, coast_side_contact: bool) -> Result<(Scene, Vec<String>), Refusal> {
    let mut scene = Scene::default();
    let turning = |x: f64, speed: f64| SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
    let first = Body::new("first", PLAIN[0].prototype.clone(), turning(0.0, 1.0))
        .free_in(&[Component::ThetaZ])
        .loaded(Wrench::NONE);
    let first = add_body(&mut scene, first)?;
    let second = add_body(
        &mut scene,
        Body::new("second", PLAIN[1].prototype.clone(), turning(3.0 * INCH + apart, -0.5)),
    )?;
    let options = MeshOptions { tip_corner_contact: false, coast_side_contact, ..MeshOptions::default() };
    let meshed = mesh(&mut scene, first, second, &options)?;
    Ok((scene, meshed.warnings.into_iter().map(|warning| warning.message.to_string()).collect()))
}

fn tight(apart: f64) -> f64 {
    let (scene, _) = meshed(apart, true).expect("they mesh");
    let system = system(&scene);
    let step = system.solve(0.01).expect("equilibrium");
    let [front, back] =
        [0, 1].map(|pair| system.value(&step, &MeshForce(calyx_runtime::scene::PairId(pair))).value);
    if front > 0.0 { off(back, front) } else { f64::INFINITY }
}

fn axial(angle: f64, modules: f64) -> f64 {
    let options =
        Options { face_width: modules * solid_pairs::MODULE, ..Options::helical(angle, Hand::Right) };
    let (scene, mesh) = options.scene();
    let system = solid_pairs::system(&scene, Default::default());
    worst([0.6].map(|part| {
        let step = system.solve(mesh.start + part * mesh.period).expect("equilibrium");
        let [_, _, axial, _, _, moment] = system.contact_force(&step, FIRST);
        let radius = 0.5 * solid_pairs::MODULE * f64::from(solid_pairs::TEETH[0]);
        off((axial * radius / moment).abs(), angle.tan())
    }))
}

fn torques(options: &Options) -> f64 {
    let (scene, mesh) = options.scene();
    let system = solid_pairs::system(&scene, Default::default());
    let step = system.solve(mesh.start + 0.3 * mesh.period).expect("equilibrium");
    let [one, other] =
        [solid_pairs::FIRST, solid_pairs::SECOND].map(|body| system.contact_force(&step, body)[5]);
    let [a, b] = solid_pairs::TEETH.map(f64::from);
    off(other / one, b / a)
}
