//! Whirl of rotors as models describe them: against exact solutions of a continuous rotor, closed
//! forms of rigid rotors, in other orientations, and for concentric shafts.

use crate::models::{close, codes, means};
use std::f64::consts::{PI, TAU};

/// Start of a model of a rotor.
const START: &str = "import gears;
units SI;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 7850 kg/m^3);
var light = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 1e-3 kg/m^3);
";
const END: &str = "analyze(\"quasi_static\", over = gears.times(1 ms, 1 ms, 1), fidelity = \"analytic\", error_estimates = \"none\");
";

/// Outputs of the lowest modes of the rotor: frequencies with and without rotation, and sense.
fn modes(count: usize) -> String {
    let of = |mode: usize| {
        let number = mode + 1;
        format!(
            "output w{mode} := gears.whirl_frequency({number});\noutput s{mode} := gears.whirl_sense({number});\noutput n{mode} := gears.natural_frequency({number});\n"
        )
    };
    (0..count).map(of).collect()
}

/// Whirl frequencies and natural frequencies (rad/s) and senses of the modes of a rotor.
#[derive(Debug)]
struct Found {
    whirl: Vec<f64>,
    sense: Vec<f64>,
    natural: Vec<f64>,
}

impl Found {
    fn of(rotor: &str, count: usize) -> Found {
        Found::with_modes(rotor, count, 0.0)
    }

    /// The modes of a rotor with component modes up to this frequency, Hz.
    fn with_modes(rotor: &str, count: usize, highest: f64) -> Found {
        let end = END.replace("fidelity =", &format!("highest_frequency = {highest} Hz, fidelity ="));
        let found = means(&format!("{START}{rotor}{}{end}", modes(count)));
        let all =
            |letter: char| (0..count).map(|mode| found[&format!("{letter}{mode}")]).collect::<Vec<f64>>();
        let radians = |all: Vec<f64>| all.into_iter().map(|frequency| TAU * frequency).collect();
        Found { whirl: radians(all('w')), sense: all('s'), natural: radians(all('n')) }
    }

    /// Returns the frequencies of modes whose sense has this sign.
    fn in_sense(&self, sign: f64) -> Vec<f64> {
        let own = self.whirl.iter().zip(&self.sense).filter(|(_, sense)| **sense * sign > 0.5);
        own.map(|(frequency, _)| *frequency).collect()
    }
}

/// Stepped rotor of the reference solution in bending, with sections at equal distances.
fn stepped(speed: f64, sections: usize, frame: &str) -> String {
    let ends = [0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.56, 0.62];
    let diameters = [0.03, 0.03, 0.045, 0.045, 0.05, 0.05, 0.035, 0.03];
    let segments = ends.windows(2).zip(diameters).map(|(ends, diameter)| {
        format!("gears.shaft_segment(length = {} m, diameter = {diameter} m)", ends[1] - ends[0])
    });
    let positions = ends.windows(2).flat_map(|ends| {
        (1..=sections).map(move |k| ends[0] + (ends[1] - ends[0]) * k as f64 / sections as f64)
    });
    let positions: Vec<String> = positions.map(|at| format!("{at:.9} m")).collect();
    format!(
        "var rotor = gears.shaft(
    \"rotor\", [{}], steel, free = [\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"], sections = [{}],
    frame := Rotate({speed} rad/s * Time, e3){frame});
gears.shaft_disc(rotor, at = 0.2 m, mass = 8.2 kg, inertia = 0.045 kg*m^2, diametral_inertia = 0.025 kg*m^2);
gears.shaft_disc(rotor, at = 0.4 m, mass = 5.5 kg, inertia = 0.026 kg*m^2, diametral_inertia = 0.014 kg*m^2);
gears.bearing(\"A\", rotor, at = 0.05 m * e3, radial_stiffness = 5e7 N/m);
gears.bearing(\"B\", rotor, at = 0.56 m * e3, radial_stiffness = 8e7 N/m);
",
        segments.collect::<Vec<_>>().join(", "),
        positions.join(", "),
    )
}

/// Exact transfer matrices of the continuous rotor at 800 rad/s.
const FORWARD: [f64; 6] = [
    1051.9061498141152,
    3272.9221265695974,
    6501.890038721919,
    9652.839033983799,
    11305.859833496568,
    13006.502465508416,
];
const BACKWARD: [f64; 6] = [
    1019.5744039539683,
    3112.0573508256384,
    5548.786612914229,
    9163.083862159252,
    11072.949671747218,
    12399.83179172834,
];
const AT_REST: [f64; 6] = [
    1036.1269316179591,
    3197.4442678492956,
    6002.296351904817,
    9422.924336101634,
    11175.565757603617,
    12674.279503396072,
];

/// Largest relative difference to the exact frequencies at 800 rad/s and at rest.
fn difference(sections: usize) -> [f64; 3] {
    let found = Found::of(&stepped(800.0, sections, ""), 12);
    let worst = |found: &[f64], exact: &[f64]| {
        assert_eq!(found.len(), exact.len(), "{found:?}");
        found.iter().zip(exact).map(|(found, exact)| (found / exact - 1.0).abs()).fold(0.0, f64::max)
    };
    let rest: Vec<f64> = found.natural.iter().step_by(2).copied().collect();
    println!("{sections}: {:?} {:?}", found.in_sense(1.0), found.in_sense(-1.0));
    [worst(&found.in_sense(1.0), &FORWARD), worst(&found.in_sense(-1.0), &BACKWARD), worst(&rest, &AT_REST)]
}

/// The condensed mass between stations converges to that of a continuous rotor.
#[test]
fn a_stepped_rotor_has_the_whirl_frequencies_of_a_continuous_one() {
    let differences = [1, 2, 4].map(difference);
    println!("{differences:?}");
    for k in 0..3 {
        let [coarse, middle, fine] = differences.map(|all| all[k]);
        assert!(fine < 1.2e-4, "{differences:?}");
        // Shear by the inertia between stations converges with the second order, bending with the
        // fourth.
        for (more, less) in [(coarse, middle), (middle, fine)] {
            let order = (more / less).log2();
            assert!((1.8..4.2).contains(&order), "{order} {differences:?}");
        }
    }
}

/// With component modes the rotor needs no sections between its bearings and discs.
#[test]
fn component_modes_replace_sections() {
    for speed in [800.0, -800.0] {
        let found = Found::with_modes(&stepped(speed, 0, ""), 12, 5000.0);
        let worst = |found: &[f64], exact: &[f64]| {
            assert_eq!(found.len(), exact.len(), "{found:?}");
            found.iter().zip(exact).map(|(found, exact)| (found / exact - 1.0).abs()).fold(0.0, f64::max)
        };
        let rest: Vec<f64> = found.natural.iter().step_by(2).copied().collect();
        let differences = [
            worst(&found.in_sense(1.0), &FORWARD),
            worst(&found.in_sense(-1.0), &BACKWARD),
            worst(&rest, &AT_REST),
        ];
        println!("{differences:?}");
        assert!(differences.iter().all(|difference| *difference < 3e-5), "{differences:?}");
    }
    // More modes than sections can resolve are rejected before the run.
    let end = END.replace("fidelity =", "highest_frequency = 1e7 Hz, fidelity =");
    let found = codes(&format!("{START}{}{}{end}", stepped(800.0, 0, ""), modes(1)));
    assert!(found.contains(&"E0858".to_owned()), "{found:?}");
    // Without modes and sections, the shaft has the mass of its static displacements.
    assert!(difference(0)[0] > 1e-2);
}

/// Rotation of all axes and a rotation in the opposite sense change neither frequencies nor senses.
#[test]
fn whirl_does_not_depend_on_the_axes() {
    let found = Found::of(&stepped(800.0, 1, ""), 8);
    let turned = " * Rotate(-37 deg, e1) * Rotate(71 deg, e2) * Translate(0.3 m * e2)";
    for (speed, frame) in [(800.0, turned), (-800.0, ""), (-800.0, turned)] {
        let other = Found::of(&stepped(speed, 1, frame), 8);
        for mode in 0..8 {
            close("frequency", other.whirl[mode], found.whirl[mode], 1e-9);
            close("sense", other.sense[mode], found.sense[mode], 1e-7);
            close("isotropic whirl", found.sense[mode].abs(), 1.0, 1e-7);
        }
    }
}

/// Without rotation, whirl frequencies are natural frequencies.
#[test]
fn a_rotor_at_rest_has_its_natural_frequencies() {
    let found = Found::of(&stepped(0.0, 1, ""), 12);
    for (whirl, natural) in found.whirl.iter().zip(&found.natural) {
        close("frequency", *whirl, *natural, 1e-9);
    }
    assert!(found.sense.iter().all(|sense| *sense == 0.0), "{:?}", found.sense);
}

/// Stiffness, mass and arms of the rigid rotor.
const RADIAL: f64 = 3e7;
const MASS: f64 = 12.0;
const POLAR: f64 = 0.09;
const DIAMETRAL: f64 = 0.06;
const ARM: f64 = 0.11;

fn rigid(speed: f64) -> String {
    format!(
        "var rotor = gears.shaft(
    \"rotor\", [gears.shaft_segment(length = {} m, diameter = 30 mm)], light, elastic = FALSE,
    free = [\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"], frame := Rotate({speed} rad/s * Time, e3));
gears.shaft_disc(rotor, at = {ARM} m, mass = {MASS} kg, inertia = {POLAR} kg*m^2, diametral_inertia = {DIAMETRAL} kg*m^2);
gears.bearing(\"A\", rotor, at = 0 m * e3, radial_stiffness = {RADIAL} N/m);
gears.bearing(\"B\", rotor, at = {} m * e3, radial_stiffness = {RADIAL} N/m);
",
        2.0 * ARM,
        2.0 * ARM
    )
}

/// A symmetric rigid rotor translates at the same frequency at all speeds; it tilts forward and
/// backward at `w = sqrt(a² + k / I) ± a` with `a = J W / 2 I`.
#[test]
fn a_rigid_rotor_whirls_by_its_closed_form() {
    let translation = (2.0 * RADIAL / MASS).sqrt();
    let tilt = 2.0 * RADIAL * ARM * ARM / DIAMETRAL;
    for speed in [100.0, 1500.0, 8000.0] {
        let found = Found::of(&rigid(speed), 4);
        let half = 0.5 * POLAR * speed / DIAMETRAL;
        let [forward, backward] = [1.0, -1.0].map(|sign| (half * half + tilt).sqrt() + sign * half);
        let sorted = |mut all: [f64; 2]| {
            all.sort_by(f64::total_cmp);
            all
        };
        for (found, expected) in found.in_sense(1.0).iter().zip(sorted([forward, translation])) {
            close("forward", *found, expected, 1e-7);
        }
        for (found, expected) in found.in_sense(-1.0).iter().zip(sorted([backward, translation])) {
            close("backward", *found, expected, 1e-7);
        }
        assert_eq!([1.0, -1.0].map(|sign| found.in_sense(sign).len()), [2, 2], "{found:?}");
        let [low, high] = sorted([tilt.sqrt(), translation]);
        for (found, expected) in found.natural.iter().zip([low, low, high, high]) {
            close("natural frequency", *found, expected, 1e-7);
        }
    }
}

/// A rotor that nothing drives rotates freely, which is a mode without frequency. The others are
/// those of a rotor whose rotation is prescribed.
#[test]
fn a_rotor_that_rotates_freely_has_a_mode_of_zero_frequency() {
    let prescribed = rigid(1500.0);
    let free = prescribed.replace("\"theta_y\"]", "\"theta_y\", \"theta_z\"]");
    let (prescribed, free) = (Found::of(&prescribed, 4), Found::of(&free, 5));
    for (found, expected) in [(&free.natural, &prescribed.natural), (&free.whirl, &prescribed.whirl)] {
        assert!(found[0] < 1e-3 * found[1], "{found:?}");
        for (found, expected) in found[1..].iter().zip(expected) {
            close("frequency", *found, *expected, 1e-9);
        }
    }
}

/// Codes of the errors of a model.
fn errors(text: &str) -> Vec<String> {
    codes(text).into_iter().filter(|code| code.starts_with('E')).collect()
}

/// A table of modes and a Campbell diagram have the modes that exist, once.
#[test]
fn impossible_campbell_diagrams_are_rejected() {
    let with = |request: &str| errors(&format!("{START}{}{}{request}{END}", rigid(100.0), modes(1)));
    let diagram = |rest: &str| format!("gears.campbell_diagram(rotor, highest_speed = 10000 rpm{rest});\n");
    assert_eq!(with(&diagram("")), Vec::<String>::new());
    assert_eq!(with(&diagram(", modes = 4")), Vec::<String>::new());
    assert_eq!(with(&diagram(", modes = 5")), ["E0770"]);
    assert_eq!(with(&diagram("").repeat(2)), ["E0773"]);
    assert_eq!(with(&diagram("").replace("10000 rpm", "0 rpm")), ["E0773"]);
    assert_eq!(with("gears.modes_table(modes = 5);\n"), ["E0770"]);
    assert_eq!(with("gears.modes_table();\ngears.modes_table();\n"), ["E0773"]);
}

/// Nothing is left to solve without a free body, and its bearings carry nothing.
#[test]
fn constrained_rotors_are_rejected() {
    let fixed = rigid(100.0).replace("[\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"]", "[]");
    assert_eq!(errors(&format!("{START}{fixed}{}{END}", modes(1))), ["E0728"]);
    let deflection = "output deflection := gears.shaft_displacement(rotor, 0 m, \"x\");\n";
    assert_eq!(errors(&format!("{START}{fixed}{deflection}{END}")), ["E0728"]);
}

/// With different stiffness along two axes orbits are elliptical: the characteristic polynomial of
/// the two tilts is `(kx - I w²)(ky - I w²) = (J W w)²`.
#[test]
fn an_anisotropic_rigid_rotor_whirls_by_its_characteristic_polynomial() {
    let speed = 2000.0;
    let rows = "translation_stiffness = [2e7 N/m * e1, 5e7 N/m * e2, 0 N/m * e3]";
    let text = rigid(speed).replace(&format!("radial_stiffness = {RADIAL} N/m"), rows);
    let found = Found::of(&text, 4);
    let [kx, ky] = [5e7, 2e7].map(|k| 2.0 * k * ARM * ARM);
    let (a, b) = (DIAMETRAL * DIAMETRAL, DIAMETRAL * (kx + ky) + (POLAR * speed).powi(2));
    let roots =
        [-1.0, 1.0].map(|sign: f64| ((b + sign * (b * b - 4.0 * a * kx * ky).sqrt()) / (2.0 * a)).sqrt());
    for root in roots {
        let near = found.whirl.iter().position(|found| (found / root - 1.0).abs() < 1e-8);
        let mode = near.unwrap_or_else(|| panic!("{root} in {found:?}"));
        assert!((0.01..0.9999).contains(&found.sense[mode].abs()), "{found:?}");
    }
}

/// Inner and outer rigid rotors with a pair of bearings between them and one to ground: the tilts
/// satisfy a polynomial of both spin momenta. The inner one rotates in the opposite sense.
#[test]
fn concentric_rigid_rotors_are_coupled_by_their_bearings() {
    let (speeds, polar, diametral) = ([3000.0, -1100.0], [0.02, 0.15], [0.015, 0.1]);
    let (between, ground, arm) = (2e7, 6e7, 0.1);
    let rotor = |name: &str, bore: f64, k: usize| {
        format!(
            "var {name} = gears.shaft(
    \"{name}\", [gears.shaft_segment(length = 0.2 m, diameter = {} m, bore = {bore} m)], light, elastic = FALSE,
    free = [\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"], frame := Rotate({} rad/s * Time, e3));
gears.shaft_disc({name}, at = 0.1 m, mass = 5 kg, inertia = {} kg*m^2, diametral_inertia = {} kg*m^2);
",
            bore + 0.02,
            speeds[k],
            polar[k],
            diametral[k]
        )
    };
    let mut text = rotor("inner", 0.0, 0) + &rotor("outer", 0.03, 1);
    for (end, at) in [("left", 0.0), ("right", 0.2)] {
        text += &format!(
            "gears.bearing(\"{end} between\", inner, to = outer, at = {at} m * e3, radial_stiffness = {between} N/m);
gears.bearing(\"{end} ground\", outer, at = {at} m * e3, radial_stiffness = {ground} N/m);
"
        );
    }
    let found = Found::of(&text, 8);
    let [tied, held] = [between, ground].map(|k| 2.0 * k * arm * arm);
    // Tilt phi of both in the complex plane with exp(i w t), w of either sign.
    let polynomial = |omega: f64| {
        let own = |k: usize, stiffness: f64| {
            stiffness - diametral[k] * omega * omega + polar[k] * speeds[k] * omega
        };
        own(0, tied) * own(1, tied + held) - tied * tied
    };
    let mut tilts = 0;
    for omega in &found.whirl {
        let slope = |omega: f64| (polynomial(1.0001 * omega) - polynomial(0.9999 * omega)) / 2e-4;
        let is_root = |omega: f64| (polynomial(omega) / slope(omega)).abs() < 1e-7;
        tilts += usize::from(is_root(*omega) || is_root(-omega));
    }
    assert_eq!(tilts, 4, "{found:?}");
    // Translations of both, each twice, do not depend on the speeds.
    let (a, b, c) = (25.0, -5.0 * (4.0 * between + 2.0 * ground), 4.0 * between * ground);
    for sign in [-1.0, 1.0] {
        let root = ((-b + sign * (f64::powi(b, 2) - 4.0 * a * c).sqrt()) / (2.0 * a)).sqrt();
        let count = found.whirl.iter().filter(|omega| (*omega / root - 1.0).abs() < 1e-7).count();
        assert_eq!(count, 2, "{root} in {found:?}");
    }
}

/// An inner shaft between ground and a needle bearing in the overhang of a hollow outer shaft.
#[test]
fn concentric_elastic_shafts_share_a_load_by_their_flexibilities() {
    let (force, inner, span, overhang) = (2000.0_f64, 0.4_f64, 0.15, 0.05);
    let [ground, needle] = [1e8, 3e8];
    let text = format!(
        "{START}var outer = gears.shaft(
    \"outer\", [gears.shaft_segment(length = {} m, diameter = 60 mm, bore = 35 mm)], steel,
    free = [\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"], frame := Rotate(20 rad/s * Time, e3) * Translate({inner} m * e3));
gears.bearing(\"q\", outer, at = {overhang} m * e3, radial_stiffness = {ground} N/m);
gears.bearing(\"p\", outer, at = {} m * e3, radial_stiffness = {ground} N/m);
var inner = gears.shaft(
    \"inner\", [gears.shaft_segment(length = {inner} m, diameter = 30 mm)], steel,
    free = [\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"], frame := Rotate(-70 rad/s * Time, e3));
var a = gears.bearing(\"a\", inner, radial_stiffness = {ground} N/m);
var between = gears.bearing(\"needle\", inner, to = outer, at = {inner} m * e3, radial_stiffness = {needle} N/m);
gears.shaft_load(inner, at = {} m, force = {force} N * e1);
output middle := gears.shaft_displacement(inner, {} m, \"x\");
output tip := gears.shaft_displacement(outer, 0 m, \"x\");
output carried := gears.bearing_force(between, \"radial\");
output opposite := gears.bearing_force(a, \"radial\");
{END}",
        overhang + span,
        overhang + span,
        0.5 * inner,
        0.5 * inner,
    );
    let found = means(&text);
    let bending = |outside: f64, bore: f64| 206e9 * PI / 64.0 * (outside.powi(4) - bore.powi(4));
    let shear = |outside: f64, bore: f64| {
        let kappa = calyx_runtime::shaft::shear_coefficient(0.3, bore / outside);
        kappa * 206e9 / 2.6 * 0.25 * PI * (outside * outside - bore * bore)
    };
    let (ei, ga) = (bending(0.06, 0.035), shear(0.06, 0.035));
    let ratio = overhang / span;
    let outer = overhang * overhang * (span + overhang) / (3.0 * ei)
        + (overhang + ratio * ratio * span) / ga
        + ((1.0 + ratio).powi(2) + ratio * ratio) / ground;
    let tip = 0.5 * force * outer;
    close("force of the needle bearing", found["carried"], 0.5 * force, 1e-9);
    close("force at the other end", found["opposite"], 0.5 * force, 1e-9);
    close("tip of the outer shaft", found["tip"], tip, 1e-8);
    let own = force * inner.powi(3) / (48.0 * bending(0.03, 0.0)) + force * inner / (4.0 * shear(0.03, 0.0));
    let ends = 0.5 * (0.5 * force / ground + 0.5 * force / needle + tip);
    close("middle of the inner shaft", found["middle"], own + ends, 1e-8);
}
