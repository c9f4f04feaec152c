//! Rolling bearings as models describe them: against the bearing alone, turned as a whole, with
//! exchanged rings, without load, and reversed.

use crate::models::engine;
use calyx::{Module, check_text};
use std::collections::BTreeMap;

/// Largest and smallest value of each output over the positions, SI.
pub(crate) fn solved(text: &str) -> BTreeMap<String, [f64; 2]> {
    let module = Module::from_text(&engine(), "model.cx", text).unwrap_or_else(|error| panic!("{error}"));
    let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
    let outputs = text.lines().filter_map(|line| line.trim().strip_prefix("output "));
    let of = |name: &str| {
        let summary = results.summary_si(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        (name.to_owned(), [summary.min, summary.max])
    };
    outputs.filter_map(|line| line.split(" :=").next()).map(of).collect()
}

#[track_caller]
pub(crate) fn close(what: &str, found: f64, expected: f64, tolerance: f64, scale: f64) {
    let difference = (found - expected).abs();
    assert!(difference <= tolerance * scale.max(expected.abs()), "{what}: {found} instead of {expected}");
}

/// Bearings of the pinion in the model, in a language with `{at}` for positions.
const TAPERED: &str = "count = 17, roller_diameter = 8 mm, roller_length = 12 mm, pitch_diameter = 52 mm,
    contact_angle = 15 deg, axial_preload = 3 um";
const BALLS: &str = "count = 9, ball_diameter = 11.9 mm, pitch_diameter = 60 mm, clearance = 12 um";

/// A helical pair whose pinion is on bearings; `bearings` creates `near` and `far`. The whole is
/// turned by an angle in degrees.
pub(crate) fn helical(bearings: &str, torque: f64, turned: f64) -> String {
    format!(
        "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var turned = {turned} deg;
var module = 2 mm;
function blank(in teeth, in hand) {{
    var diameter = teeth * module / cos(15 deg);
    return gears.external(
        teeth = teeth,
        rack = gears.rack(module = module, tip_radius = 0.5 mm, plane = \"normal\"),
        face_width = 20 mm,
        outer_diameter = diameter + 2 * module,
        root_diameter = diameter - 2.5 * module,
        material = steel,
        modifications = [gears.lead_crown(3 um)],
        helix_angle = 15 deg,
        hand = hand);
}}
var speed = 600 rpm;
var center_distance = 0.5 * (23 + 38) * module / cos(15 deg) + 0.05 mm;
var pinion = gears.body(
    \"pinion\",
    blank(23, \"right\"),
    free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\", \"theta_z\"],
    moment = {torque} N*m * e3,
    frame := Rotate(turned, e3) * Rotate(speed * Time, e3));
var gear = gears.body(
    \"gear\",
    blank(38, \"left\"),
    frame := Rotate(-speed * 23 / 38 * Time, e3) * Translate(center_distance * e1) * Rotate(turned, e3));
{bearings}
var mesh = gears.mesh(pinion, gear);
output near_radial := gears.bearing_force(near, \"radial\");
output far_radial := gears.bearing_force(far, \"radial\");
output near_axial := gears.bearing_force(near, \"axial\");
output tilt := gears.bearing_tilt(near, \"radial\");
output radial := gears.bearing_deflection(far, \"radial\");
output pressure := gears.max_bearing_pressure(near);
output largest := gears.max_rolling_element_load(near);
output first := gears.rolling_element_load(near, 1);
output loaded := gears.loaded_rolling_elements(far);
output safety := gears.bearing_static_safety(near);
output life := gears.bearing_life(near);
output transmission_error := gears.transmission_error(mesh);
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 3), fidelity = \"analytic\", error_estimates = \"none\");
"
    )
}

fn tapered(azimuth: f64) -> String {
    format!(
        "var near = gears.tapered_roller_bearing(\"near\", pinion, at = 40 mm * e3, {TAPERED}, azimuth = {azimuth} deg);
var far = gears.tapered_roller_bearing(\"far\", pinion, at = 120 mm * e3, {TAPERED}, thrust = \"-z\", azimuth = {azimuth} deg);"
    )
}

fn balls(azimuth: f64) -> String {
    format!(
        "var near = gears.ball_bearing(\"near\", pinion, at = 40 mm * e3, {BALLS}, azimuth = {azimuth} deg);
var far = gears.ball_bearing(\"far\", pinion, at = 120 mm * e3, {BALLS}, azimuth = {azimuth} deg);"
    )
}

/// Palmgren's torque: the part of the load, with the force of deep groove bearings, and the viscous
/// part; the power is that of the speed of the shaft.
#[test]
fn friction_is_that_of_the_forces_and_the_speed() {
    let bearings = format!(
        "function balls(in name, in at) {{ return gears.ball_bearing(name, pinion, at = at * e3, {BALLS}); }}
var near = balls(\"near\", -40 mm);
var far = balls(\"far\", 60 mm);
var near_force := gears.bearing_force(near, \"radial\");
var near_thrust := abs(gears.bearing_force(near, \"axial\"));
output excess := gears.bearing_friction_torque(near, 30 mm^2/s, viscous_coefficient = 0) / (2.5e-4 * 60 mm)
    - max(near_force, 3 * near_thrust - 0.1 * near_force);
output viscous := gears.bearing_friction_torque(near, 30 mm^2/s, load_coefficient = 0);
output rate := gears.bearing_friction_loss(near, 30 mm^2/s) / gears.bearing_friction_torque(near, 30 mm^2/s);"
    );
    let found = solved(&helical(&bearings, 80.0, 0.0));
    let viscous = 2.0 * (30.0 * 600.0_f64).powf(2.0 / 3.0) * 60.0_f64.powi(3) * 1e-10;
    for end in [0, 1] {
        close("force", found["excess"][end], 0.0, 1e-9, 1000.0);
        close("viscous torque", found["viscous"][end], viscous, 1e-9, 0.0);
        close("speed", found["rate"][end], 20.0 * std::f64::consts::PI, 1e-9, 0.0);
    }
}

/// Model and elements turned by the same angle have the same results.
#[test]
fn the_turned_whole_has_the_same_results() {
    for bearings in [tapered, balls] {
        let expected = solved(&helical(&bearings(7.0), 100.0, 0.0));
        let found = solved(&helical(&bearings(7.0 + 37.0), 100.0, 37.0));
        assert_eq!(expected.len(), 12);
        for (name, expected) in &expected {
            for (found, expected) in found[name].iter().zip(expected) {
                close(name, *found, *expected, 1e-6, 0.0);
            }
        }
    }
}

/// Reversed torque loads the other flanks and the other sense of the axial force.
#[test]
fn reversed_and_vanishing_torque() {
    let forward = solved(&helical(&tapered(0.0), 100.0, 0.0));
    let backward = solved(&helical(&tapered(0.0), -100.0, 0.0));
    for results in [&forward, &backward] {
        assert!(results["near_radial"][0] > 1e3 && results["loaded"][1] > 2.0, "{results:?}");
        assert!(results["safety"][0] > 1.0 && results["life"][0] > 1e6, "{results:?}");
    }
    // Without load, the preload of both bearings remains; both press each other.
    let unloaded = solved(&helical(&tapered(0.0), 0.0, 0.0));
    assert!(unloaded["pressure"][0] > 1e8 && unloaded["loaded"] == [17.0, 17.0], "{unloaded:?}");
    // Without preload and load, no ball is loaded.
    let idle = solved(&helical(&balls(0.0), 0.0, 0.0));
    assert_eq!((idle["pressure"], idle["loaded"], idle["near_radial"]), ([0.0; 2], [0.0; 2], [0.0; 2]));
}

/// A sleeve in a housing: the inner ring on the sleeve, or the outer ring on the housing, with the
/// bearing seen from the other body.
#[test]
fn exchanged_rings_are_the_same_bearing() {
    let sleeve = |bearings: &str, rotating_ring: &str| {
        let bearings = format!(
            "var sleeve = gears.rigid_body(\"sleeve\", free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\"], frame := Translate(0 mm * e3));
var housing = gears.rigid_body(\"housing\", frame := Translate(0 mm * e3));
gears.bearing(\"shaft\", pinion, to = sleeve, at = 80 mm * e3, radial_stiffness = 1e9 N/m, axial_stiffness = 1e9 N/m,
    tilting_stiffness = 1e7 N*m/rad);
{bearings}"
        );
        let life = format!("bearing_life(near{rotating_ring})");
        solved(&helical(&bearings, 100.0, 0.0).replace("bearing_life(near)", &life))
    };
    let inner = sleeve(&tapered(5.0).replace("pinion,", "sleeve, to = housing,"), "");
    let exchanged = tapered(5.0)
        .replace("pinion,", "housing, to = sleeve, ring = \"outer\",")
        // The force on the housing is opposite.
        .replace("thrust = \"-z\", ", "")
        .replace("\"near\", housing,", "\"near\", housing, thrust = \"-z\",");
    let outer = sleeve(&exchanged, ", rotating_ring = \"inner\"");
    for (name, expected) in &inner {
        let sign = if name == "near_axial" { -1.0 } else { 1.0 };
        let [low, high] = outer[name];
        let found = if sign < 0.0 { [-high, -low] } else { [low, high] };
        for (found, expected) in found.iter().zip(expected) {
            close(name, *found, *expected, 1e-8, 0.0);
        }
    }
    // The ring on the body is the one that rotates relative to the load if the model states none.
    let stated = sleeve(&exchanged, ", rotating_ring = \"outer\"");
    let default = sleeve(&exchanged, "");
    assert_eq!(default["life"], stated["life"]);
    assert_ne!(default["life"], outer["life"]);
    // A ring with a speed rotates.
    let rotating = exchanged.replace("ring = \"outer\",", "ring = \"outer\", inner_speed = 600 rpm,");
    assert_ne!(rotating, exchanged);
    let stated = sleeve(&rotating, ", rotating_ring = \"inner\"");
    assert_eq!(sleeve(&rotating, "")["life"], stated["life"]);
}

/// Two rows of a bearing are two bearings with one row each.
#[test]
fn two_rows_are_two_bearings() {
    let balls = "count = 14, ball_diameter = 9 mm, pitch_diameter = 50 mm, contact_angle = 25 deg, axial_preload = 4 um";
    let far = format!("var far = gears.ball_bearing(\"far\", pinion, at = 120 mm * e3, {BALLS});");
    let one = |name: &str, at: &str, thrust: &str, rows: &str| {
        format!(
            "var {name} = gears.angular_contact_bearing(\"{name}\", pinion, at = {at} * e3, {balls}, thrust = \"{thrust}\"{rows});\n"
        )
    };
    for (arrangement, [first, second]) in [
        ("back_to_back", ["+z", "-z"]),
        ("face_to_face", ["-z", "+z"]),
        ("tandem", ["+z", "+z"]),
        ("tandem", ["-z", "-z"]),
    ] {
        let rows = format!(", arrangement = \"{arrangement}\", row_distance = 14 mm");
        let pair = one("near", "40 mm", first, &rows);
        let single = one("near", "33 mm", first, "") + &one("_other", "47 mm", second, "");
        let results = [pair, single].map(|near| solved(&helical(&format!("{near}{far}"), 100.0, 0.0)));
        for name in ["far_radial", "radial", "tilt", "transmission_error"] {
            for (found, expected) in results[1][name].iter().zip(results[0][name]) {
                close(&format!("{arrangement} {first} {name}"), *found, expected, 1e-6, 0.0);
            }
        }
    }
}

/// The load of a spherical roller bearing passes through the centre of its outer sphere: it does
/// not resist tilting.
#[test]
fn spherical_roller_bearings_do_not_resist_tilting() {
    let bearing = |name: &str, at: f64| {
        format!(
            "var {name} = gears.spherical_roller_bearing(\"{name}\", pinion, at = {at} mm * e3, count = 14, roller_diameter = 8 mm,
    roller_length = 8 mm, pitch_diameter = 50 mm, contact_angle = 11 deg, clearance = 10 um);\n"
        )
    };
    let text = helical(&(bearing("near", 40.0) + &bearing("far", 120.0)), 100.0, 0.0)
        .replace("output tilt ", "output moment := gears.bearing_moment(near, \"radial\");\noutput tilt ");
    let results = solved(&text);
    let (moment, force) = (results["moment"][1], results["near_radial"][0]);
    assert!(results["tilt"][0] > 1e-4 && moment < 0.02 * force * 25e-3, "{results:?}");
}

/// Invalid bearings are rejected at the argument that is wrong.
#[test]
fn invalid_bearings_are_rejected_at_their_argument() {
    let good = balls(0.0);
    for (from, to, code, at) in [
        ("count = 9", "count = 17", "E0697", "17"),
        ("count = 9", "count = 8.5", "E0697", "8.5"),
        ("clearance = 12 um", "clearance = -300 um", "E0697", "-300 um"),
        ("clearance = 12 um", "clearance = 5 mm", "E0697", "5 mm"),
        ("clearance = 12 um", "inner_conformity = 0.5", "E0697", "0.5"),
        ("pitch_diameter = 60 mm", "pitch_diameter = 11 mm", "E0697", "11 mm"),
    ] {
        let text = helical(&good.replacen(from, to, 1), 100.0, 0.0);
        let found = check_text("model.cx", &text).diagnostics;
        let error =
            found.iter().find(|found| found.code == code).unwrap_or_else(|| panic!("{to}: {found:?}"));
        let span = &text[error.primary.span.start as usize..error.primary.span.end as usize];
        assert!(span.contains(at), "{to}: {span}");
    }
    let crushed = tapered(0.0).replace("axial_preload = 3 um", "axial_preload = 500 um");
    let found = check_text("model.cx", &helical(&crushed, 100.0, 0.0)).diagnostics;
    assert!(found.iter().any(|found| found.code == "E0697"), "{found:?}");
}

/// The helical pair on bearings that are linearized at the forces of the rolling ones.
#[test]
fn linearized_bearings_have_the_forces_and_stiffness_of_the_operating_point() {
    let components = ["x", "y", "z"];
    let outputs: String = ["near", "far"]
        .iter()
        .flat_map(|name| {
            components.map(|axis| {
                format!(
                    "output {name}_{axis} := gears.bearing_force({name}, \"{axis}\");
output {name}_stiffness_{axis} := gears.bearing_stiffness({name}, \"{axis}\", \"{axis}\");\n"
                )
            })
        })
        .collect();
    let elements = ["pressure", "largest", "first", "loaded", "safety", "life"];
    let model = |bearings: &str| {
        let text = helical(bearings, 100.0, 0.0);
        let lines = text
            .lines()
            .filter(|line| !elements.iter().any(|name| line.starts_with(&format!("output {name} "))));
        lines.collect::<Vec<_>>().join("\n").replace("analyze(", &format!("{outputs}analyze("))
    };
    let rolling = solved(&model(&tapered(0.0)));
    let mean = |name: &str| 0.5 * (rolling[name][0] + rolling[name][1]);
    let at = |name: &str| {
        let [x, y, z] = components.map(|axis| -mean(&format!("{name}_{axis}")));
        format!("linearized_at = {x} N * e1 + {y} N * e2 + {z} N * e3")
    };
    let linear = tapered(0.0)
        .replace("at = 40 mm * e3,", &format!("at = 40 mm * e3, {},", at("near")))
        .replace("at = 120 mm * e3,", &format!("at = 120 mm * e3, {},", at("far")));
    let found = solved(&model(&linear));
    for name in ["near", "far"] {
        for axis in components {
            let force = format!("{name}_{axis}");
            close(&force, found[&force][0], rolling[&force][0], 0.02, rolling[&format!("{name}_radial")][0]);
            // The rolling bearings tilt by a tenth of a milliradian, the linearized ones do not.
            let stiffness = format!("{name}_stiffness_{axis}");
            close(&stiffness, found[&stiffness][0], rolling[&stiffness][0], 0.05, 0.0);
        }
    }
    close("transmission error", found["transmission_error"][1], rolling["transmission_error"][1], 0.01, 0.0);
}

/// Reactions, which observables evaluate on their own, balance a load on a rigid body at every
/// level, with the contacts of rollers of this level. The body may tilt in three dimensions.
#[test]
fn reactions_balance_the_load_at_every_level() {
    let kinds = [
        "ball_bearing(n, body, at = z, count = 9, ball_diameter = 11.9 mm, pitch_diameter = 60 mm",
        "cylindrical_roller_bearing(n, body, at = z, count = 14, roller_diameter = 10 mm, roller_length = 10 mm, pitch_diameter = 55 mm, clearance = 20 um",
        "needle_bearing(n, body, at = z, count = 20, roller_diameter = 3 mm, roller_length = 15 mm, pitch_diameter = 43 mm",
        "tapered_roller_bearing(n, body, at = z, count = 17, roller_diameter = 8 mm, roller_length = 12 mm, pitch_diameter = 52 mm, contact_angle = 15 deg, axial_preload = 3 um, thrust = thrust",
    ];
    for kind in kinds {
        for fidelity in ["plane", "analytic", "medium"] {
            let is_plane = fidelity == "plane";
            if is_plane && kind.starts_with("tapered") {
                continue;
            }
            let (free, axial) = if is_plane {
                ("", "")
            } else {
                let axial = "gears.bearing(\"axial\", body, axial_stiffness = 5e7 N/m);";
                (", \"u_z\", \"theta_x\", \"theta_y\"", axial)
            };
            let model = format!(
                "import gears;
units mm_N_s;
var body = gears.rigid_body(\"body\", free = [\"u_x\", \"u_y\"{free}], force = 2000 N * e1 + 300 N * e2, frame := Rotate(100 rpm * Time, e3));
{axial}
function rolling(in n, in z, in thrust) {{ return gears.{kind}); }}
var near = rolling(\"near\", -30 mm * e3, \"+z\");
var far = rolling(\"far\", 70 mm * e3, \"-z\");
output near_x := gears.bearing_force(near, \"x\");
output near_y := gears.bearing_force(near, \"y\");
output far_x := gears.bearing_force(far, \"x\");
output far_y := gears.bearing_force(far, \"y\");
analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"{fidelity}\", error_estimates = \"none\");
"
            );
            let found = solved(&model);
            let sum = |axis: &str| found[&format!("near_{axis}")][0] + found[&format!("far_{axis}")][0];
            let what = format!("{kind} at {fidelity}");
            close(&what, sum("x"), -2000.0, 1e-8, 2000.0);
            close(&what, sum("y"), -300.0, 1e-8, 2000.0);
        }
    }
}
