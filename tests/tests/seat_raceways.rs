//! Bearings in elastic seats of a housing that supports a pair of gears: turned as a whole, in
//! equilibrium, with more harmonics, and with other bearings in the same housing.

use crate::models::ranges_with;
use crate::rolling_bearings::close;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Nodes of the housing around its bores.
const AROUND: usize = 96;
const ALONG: usize = 8;

/// A tube with these radii inside and outside that extends as far to both sides of z = 0 (mm), with
/// this Young's modulus (GPa), as a bulk data deck.
pub fn tube([inside, outside]: [f64; 2], half: f64, modulus: f64) -> String {
    let mut deck = format!("BEGIN BULK\nMAT1,1,{:e},,0.3,7.85-9\nPSOLID,1,1,,BUBBLE\n", 1e3 * modulus);
    let index = |i: usize, j: usize, k: usize| 1 + i % AROUND + AROUND * (j + 3 * k);
    for k in 0..=ALONG {
        for j in 0..3 {
            for i in 0..AROUND {
                let (sine, cosine) = (TAU * i as f64 / AROUND as f64).sin_cos();
                let radius = inside + 0.5 * (outside - inside) * j as f64;
                let z = half * (2.0 * k as f64 / ALONG as f64 - 1.0);
                writeln!(
                    deck,
                    "GRID,{},,{:.12},{:.12},{z:.6}",
                    index(i, j, k),
                    radius * cosine,
                    radius * sine
                )
                .expect("written");
            }
        }
    }
    let mut label = 0;
    for k in 0..ALONG {
        for j in 0..2 {
            for i in 0..AROUND {
                label += 1;
                let face =
                    |k| [index(i, j, k), index(i, j + 1, k), index(i + 1, j + 1, k), index(i + 1, j, k)];
                let ([a, b, c, d], [e, f, g, h]) = (face(k), face(k + 1));
                writeln!(deck, "CHEXA,{label},1,{a},{b},{c},{d},{e},{f}\n,{g},{h}").expect("written");
            }
        }
    }
    deck + "ENDDATA\n"
}

struct Housing {
    how: &'static str,
    harmonics: usize,
    /// Connection of the seat of the other bearing.
    other: &'static str,
    /// Angle about which the whole is turned, degrees.
    turned: f64,
    bearings: Bearings,
}

/// Kind and dimensions of both bearings, without the sense of their thrust.
struct Bearings {
    call: &'static str,
    /// Thrust of the near and of the far bearing, on a pinion that is free along its axis.
    thrust: Option<[&'static str; 2]>,
}

const CYLINDRICAL: Bearings = Bearings {
    call: "gears.cylindrical_roller_bearing(name, pinion, to = to, at = at, count = 14, roller_diameter = 6 mm, roller_length = 16 mm, pitch_diameter = 34 mm, clearance = 10 um",
    thrust: None,
};
const TAPERED: Bearings = Bearings {
    call: "gears.tapered_roller_bearing(name, pinion, to = to, at = at, count = 14, roller_diameter = 6 mm, roller_length = 14 mm, pitch_diameter = 33 mm, contact_angle = 14 deg, axial_preload = 5 um",
    thrust: Some(["+z", "-z"]),
};
const ANGULAR: Bearings = Bearings {
    call: "gears.angular_contact_bearing(name, pinion, to = to, at = at, count = 12, ball_diameter = 6 mm, pitch_diameter = 34 mm, contact_angle = 25 deg, axial_preload = 5 um",
    thrust: Some(["+z", "-z"]),
};

const HOUSING: Housing =
    Housing { how: "raceway", harmonics: 12, other: "raceway", turned: 0.0, bearings: CYLINDRICAL };

impl Housing {
    fn results(&self) -> BTreeMap<String, [f64; 2]> {
        ranges_with(&self.model(), &[("tube.bdf", &tube([20.0, 23.0], 40.0, 206.0))])
    }

    fn model(&self) -> String {
        let Housing { how, harmonics, other, turned, bearings: Bearings { call, thrust } } = self;
        let along = thrust.map_or("", |_| "\"u_z\", ");
        let [near, far] = thrust.map_or([String::new(), String::new()], |both| {
            both.map(|sense| format!(", thrust = \"{sense}\""))
        });
        let mut text = format!(
            "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var turned = {turned} deg;
function blank(in teeth) {{
    return gears.external(teeth, module = 2 mm, face_width = 10 mm, material = steel);
}}
var housing = gears.nastran(\"housing\", \"tube.bdf\", units = \"N-mm-s\", frame := Rotate(turned, e3));
var foot = gears.attachment(\"foot\", housing, gears.box_region(-8 mm * e1 - 24 mm * e2 - 41 mm * e3, 8 mm * e1 - 22 mm * e2 + 41 mm * e3), fixed = TRUE);
function seat(in name, in z: Length, in how) {{
    return gears.attachment(name, housing,
        gears.cylinder_region(z * e3, e3, radius = 20 mm, from = -10 mm, to = 10 mm), how = how, raceway_harmonics = {harmonics});
}}
var near_seat = seat(\"near seat\", -30 mm, \"{how}\"), far_seat = seat(\"far seat\", 30 mm, \"{other}\");
var pinion = gears.body(\"pinion\", blank(18), free = [\"u_x\", \"u_y\", {along}\"theta_x\", \"theta_y\", \"theta_z\"],
    moment = 150 N*m * e3, frame := Rotate(100 rpm * Time, e3) * Translate(-5 mm * e3) * Rotate(turned, e3));
function near_bearing(in name, in to, in at) {{ return {call}{near}); }}
function far_bearing(in name, in to, in at) {{ return {call}{far}); }}
var near = near_bearing(\"near\", near_seat, -25 mm * e3), far = far_bearing(\"far\", far_seat, 35 mm * e3);
var gear = gears.body(\"gear\", blank(40),
    frame := Rotate(-100 rpm * 18 / 40 * Time, e3) * Translate(58.05 mm * e1) * Translate(-5 mm * e3) * Rotate(turned, e3));
var mesh = gears.mesh(pinion, gear);
output transmission_error := gears.transmission_error(mesh);
output mesh_force := gears.mesh_force(mesh);
output near_force := gears.bearing_force(near, \"radial\");
output far_force := gears.bearing_force(far, \"radial\");
output near_largest := gears.max_rolling_element_load(near);
output far_largest := gears.max_rolling_element_load(far);
output loaded := gears.loaded_rolling_elements(near);
output deflection := gears.bearing_deflection(near, \"radial\");
"
        );
        for axis in ["x", "y", "z"] {
            writeln!(text, "output foot_{axis} := gears.support_force(foot, \"{axis}\");").expect("written");
            writeln!(text, "output gear_{axis} := gears.support_force(gear, \"{axis}\");").expect("written");
            writeln!(text, "output moment_{axis} := gears.support_moment(foot, \"{axis}\");")
                .expect("written");
            writeln!(text, "output gear_moment_{axis} := gears.support_moment(gear, \"{axis}\");")
                .expect("written");
        }
        text + "analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"medium\", error_estimates = \"none\");\n"
    }
}

const SCALARS: [&str; 7] = [
    "transmission_error",
    "mesh_force",
    "near_force",
    "far_force",
    "near_largest",
    "far_largest",
    "deflection",
];

#[test]
fn the_turned_whole_has_the_same_results() {
    for bearings in [|| CYLINDRICAL, || TAPERED] {
        let [own, turned] =
            [0.0, 37.0].map(|turned| Housing { turned, bearings: bearings(), ..HOUSING }.results());
        for name in SCALARS {
            close(name, turned[name][0], own[name][0], 1e-7, 0.0);
        }
    }
}

/// The foot and the gear carry the torque on the pinion, in three dimensions.
#[test]
fn the_foot_carries_the_forces_of_the_bearings() {
    for bearings in [CYLINDRICAL, TAPERED, ANGULAR] {
        check_equilibrium(&Housing { bearings, ..HOUSING }.results());
    }
}

fn check_equilibrium(found: &BTreeMap<String, [f64; 2]>) {
    let force = found["mesh_force"][0];
    for axis in ["x", "y", "z"] {
        let sum = found[&format!("foot_{axis}")][0] + found[&format!("gear_{axis}")][0];
        assert!(sum.abs() < 1e-7 * force, "{axis}: {sum} N of {force} N");
    }
    // Moments across the axis, about the middle of the tube; the gear is at z = -5 mm.
    let of = |name: &str| found[name][0];
    let about_x = of("moment_x") + of("gear_moment_x") + 5e-3 * of("gear_y");
    let about_y = of("moment_y") + of("gear_moment_y") - 5e-3 * of("gear_x");
    assert!(about_x.hypot(about_y) < 1e-7 * force * 5e-3, "{about_x} {about_y}");
    // The torque about the axis of the pinion.
    let of_gear = of("gear_moment_z") + 58.05e-3 * of("gear_y");
    assert!((150.0 + of_gear).abs() < 1e-7 * 150.0, "{of_gear}");
}

/// The foot is next to the load: a housing that yields at its sides leaves it to few rollers. A
/// rigid ring has the mean motion of the seat instead, and both bearings are independent of how the
/// other one is mounted, except for their shares of the load.
#[test]
fn a_thin_housing_changes_the_loads_of_the_elements() {
    let rigid = Housing { how: "average", other: "average", ..HOUSING }.results();
    let change = |other, name: &str| {
        let found = Housing { other, ..HOUSING }.results();
        (found[name][0] - rigid[name][0]) / rigid[name][0]
    };
    for other in ["raceway", "average"] {
        let largest = change(other, "near_largest");
        println!("{other}: largest load {:+.1} %", 100.0 * largest);
        assert!(largest > 0.5, "{largest}");
    }
    let of_rigid = change("average", "far_largest") - change("average", "far_force");
    assert!(of_rigid.abs() < 0.02, "{of_rigid}");
    for (name, bearings) in [("tapered", [TAPERED, TAPERED]), ("angular contact", [ANGULAR, ANGULAR])] {
        let [rigid, elastic] = bearings;
        let rigid = Housing { how: "average", other: "average", bearings: rigid, ..HOUSING }.results();
        let elastic = Housing { bearings: elastic, ..HOUSING }.results();
        let change = elastic["near_largest"][0] / rigid["near_largest"][0] - 1.0;
        println!("{name}: largest load {:+.1} %", 100.0 * change);
        assert!(change > 0.1, "{name}: {change}");
    }
}

#[test]
fn results_converge_with_the_harmonics() {
    let [some, many] = [12, 20].map(|harmonics| Housing { harmonics, ..HOUSING }.results());
    for name in SCALARS {
        close(name, some[name][0], many[name][0], 5e-3, 0.0);
    }
}
