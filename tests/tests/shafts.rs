//! Gears on flexible shafts as models describe them: against beams by hand, against the same gears
//! on bearings without a shaft, in other orientations, and with several gears on a shaft.

use crate::models::{close, codes, engine, ranges};
use calyx::Module;
use calyx::rt::{RunOptions, run};
use std::f64::consts::PI;

/// The example of a pinion on bearings, with the pinion on a rigid shaft instead, that has its
/// origin elsewhere and its torque at a coupling.
#[test]
fn a_rigid_shaft_has_the_results_of_a_gear_on_bearings() {
    let path = calyx_tests::root().join("examples/helical_on_bearings.cx");
    let text = std::fs::read_to_string(path)
        .expect("the example")
        .replace("fidelity = \"medium\" in", "fidelity = \"analytic\" in");
    let start = text.find("var pinion = gears.body(").expect("the pinion");
    let end = text.find("var gear = gears.body(").expect("the gear");
    let shaft = "
var shaft = gears.shaft(
    \"input\",
    segments = [
        gears.shaft_segment(length = 100 mm, diameter = 30 mm),
        gears.shaft_segment(length = 200 mm, diameter = 40 mm, end_diameter = 35 mm, bore = 8 mm)],
    material = steel,
    elastic = FALSE,
    frame := Rotate(speed * Time, e3) * Translate(-70 mm * e3));
var pinion = gears.mount(\"pinion\", blank(23, \"right\"), on = shaft, at = 70 mm);
gears.shaft_load(shaft, at = 220 mm, moment = torque * e3);
";
    let mounted = format!("{}{shaft}{}", &text[..start], &text[end..])
        .replace(
            "\"inner\",\n    pinion,\n    at = overhang",
            "\"inner\",\n    shaft,\n    at = (70 mm + overhang)",
        )
        .replace(
            "\"outer\",\n    pinion,\n    at = (overhang",
            "\"outer\",\n    shaft,\n    at = (70 mm + overhang",
        );
    assert_eq!(mounted.matches("    shaft,\n").count(), 2);
    let (expected, found) = (ranges(&text), ranges(&mounted));
    assert_eq!(expected.len(), 11);
    for (name, expected) in expected {
        for (found, expected) in found[&name].iter().zip(expected) {
            close(&name, *found, expected, 1e-9);
        }
    }
}

const LENGTHS: [f64; 3] = [0.015, 0.065, 0.135];
const DIAMETER: f64 = 0.032;
const BORE: f64 = 0.008;
const STIFFNESS: f64 = 3e8;

/// A helical pair: the pinion at 65 mm between bearings at 15 mm and 135 mm of a uniform hollow
/// shaft, the torque at 160 mm. `placed` is a transform of the whole from ground, `axis` the axes'
/// direction then.
fn helical_pair(placed: &str, axis: &str, fidelity: &str) -> String {
    format!(
        "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
function blank(in teeth, in hand) {{
    return gears.external(teeth, normal_module = 2 mm, helix_angle = 15 deg, hand = hand, face_width = 20 mm, material = steel);
}}
var a = blank(23, \"right\"), b = blank(38, \"left\");
var axis = {axis};
var shaft = gears.shaft(
    \"input\",
    segments = [gears.shaft_segment(length = 160 mm, diameter = 32 mm, bore = 8 mm)],
    material = steel,
    frame := Rotate(600 rpm * Time, e3) * Translate(-65 mm * e3){placed});
var first = gears.mount(\"pinion\", a, on = shaft, at = 65 mm);
gears.shaft_load(shaft, at = 160 mm, moment = 120 N*m * axis);
var left = gears.bearing(\"left\", shaft, at = 15 mm * e3, radial_stiffness = 3e8 N/m, axial_stiffness = 1e8 N/m);
var right = gears.bearing(\"right\", shaft, at = 135 mm * e3, radial_stiffness = 3e8 N/m);
var second = gears.body(\"gear\", b,
    frame := Rotate(-600 rpm * 23 / 38 * Time, e3) * Translate((gears.center_distance(a, b) + 0.05 mm) * e1){placed});
var mesh = gears.mesh(first, second);
output left_radial := gears.bearing_force(left, \"radial\");
output right_radial := gears.bearing_force(right, \"radial\");
output left_x := gears.bearing_force(left, \"x\");
output left_y := gears.bearing_force(left, \"y\");
output left_z := gears.bearing_force(left, \"axial\");
output right_x := gears.bearing_force(right, \"x\");
output right_y := gears.bearing_force(right, \"y\");
output tilt_x := gears.rotation(first, \"x\");
output tilt_y := gears.rotation(first, \"y\");
output u_x := gears.displacement(first, \"x\");
output u_z := gears.displacement(first, \"z\");
output deflection := gears.shaft_displacement(shaft, 100 mm, \"x\");
output twist := gears.shaft_rotation(shaft, 160 mm, \"axial\") - gears.shaft_rotation(shaft, 65 mm, \"axial\");
output bending := gears.shaft_moment(shaft, 40 mm);
output torque := gears.shaft_moment(shaft, 100 mm, \"torque\");
output stress := gears.shaft_stress(shaft, 40 mm, \"bending\");
output shear := gears.shaft_stress(shaft, 100 mm, \"torsion\");
output largest := gears.shaft_stress(shaft);
output residual_x := gears.support_force(shaft, \"x\");
output residual_m := gears.support_moment(shaft, \"z\");
output force := gears.mesh_force(mesh);
output uneven := gears.face_load_factor(mesh);
output te := gears.transmission_error(mesh);
analyze(\"quasi_static\", over = gears.times(1 ms, 1 ms, 1), fidelity = \"{fidelity}\", error_estimates = \"none\");
"
    )
}

/// Misalignment, deflection and bearing reactions from influence coefficients of a simply supported
/// beam on its bearings.
#[test]
fn a_helical_pair_bends_its_shaft_as_influence_coefficients_say() {
    let found = ranges(&helical_pair("", "e3", "analytic"));
    let of = |name: &str| found[name][1];
    let [from, gear, to] = LENGTHS;
    let (span, a, b) = (to - from, gear - from, to - gear);
    let area = 0.25 * PI * (DIAMETER * DIAMETER - BORE * BORE);
    let inertia = PI / 64.0 * (DIAMETER.powi(4) - BORE.powi(4));
    let (ei, g) = (206e9 * inertia, 206e9 / 2.6);
    let square = (BORE / DIAMETER).powi(2);
    let sum = (1.0 + square).powi(2);
    let kappa = 7.8 * sum / (8.8 * sum + 23.6 * square);
    for (plane, tilt, sense) in [("x", of("tilt_y"), 1.0), ("y", of("tilt_x"), -1.0)] {
        let [left, right] = ["left", "right"].map(|side| of(&format!("{side}_{plane}")));
        // Load of the teeth at mid-face: a force, and a couple in the plane of bending, from
        // equilibrium with the reactions.
        let force = -(left + right);
        let couple = a * left - b * right;
        // The deflections of the bearings rotate the shaft as a rigid body.
        let [moved_left, moved_right] = [left, right].map(|force| -force / STIFFNESS);
        let rigid = (moved_right - moved_left) / span;
        let bent = force * a * b * (b - a) / (3.0 * ei * span)
            + couple * ((a * a - a * b + b * b) / (3.0 * ei * span) + 1.0 / (kappa * g * area * span));
        close(&format!("tilt in the plane of {plane}"), sense * tilt, rigid + bent, 1e-7);
        if plane == "x" {
            let rigid = moved_left + rigid * a;
            let by_force = force * (a * a * b * b / (3.0 * ei * span) + a * b / (span * kappa * g * area));
            let by_couple = couple * a * b * (b - a) / (3.0 * ei * span);
            close("deflection at the pinion", of("u_x"), rigid + by_force + by_couple, 1e-6);
        }
    }
    // Wind-up, tension, section moments and nominal stresses.
    close("wind-up", of("twist"), 120.0 * 0.095 / (g * 2.0 * inertia), 1e-8);
    close("axial force", of("left_z"), -1e8 * (of("u_z") + of("left_z") * a / (206e9 * area)), 1e-7);
    close("torque", of("torque"), 120.0, 1e-8);
    close("bending moment", of("bending"), of("left_radial") * (0.04 - from), 1e-8);
    let modulus = 2.0 * inertia / DIAMETER;
    // The axial force acts between its bearing and the pinion.
    let bending = of("bending") / modulus + of("left_z").abs() / area;
    close("bending stress", of("stress"), bending, 1e-8);
    close("shear stress", of("shear"), 60.0 / modulus, 1e-8);
    assert!(of("largest") > of("stress"));
    // The teeth transmit the torque, and all forces balance.
    let base_radius = 0.023 / 15_f64.to_radians().cos()
        * (20_f64.to_radians().tan() / 15_f64.to_radians().cos()).atan().cos();
    let transverse = (of("left_x") + of("right_x")).hypot(of("left_y") + of("right_y"));
    close("transverse force", transverse, 120.0 / base_radius, 2e-3);
    for residual in ["residual_x", "residual_m"] {
        assert!(of(residual).abs() < 1e-9 * of("force"), "{residual}: {}", of(residual));
    }
}

/// The same pair with inclined axes.
#[test]
fn the_orientation_in_space_has_no_effect() {
    let upright = ranges(&helical_pair("", "e3", "analytic"));
    let inclined =
        ranges(&helical_pair(" * Rotate(50 deg, e1)", "(cos(50 deg) * e3 - sin(50 deg) * e2)", "analytic"));
    let names = [
        "left_radial",
        "right_radial",
        "left_z",
        "twist",
        "bending",
        "largest",
        "force",
        "uneven",
        "te",
        "tilt_x",
        "tilt_y",
    ];
    for name in names {
        close(name, inclined[name][1], upright[name][1], 1e-7);
    }
}

/// A flexible shaft lets the pinion tilt more and wind up; the rigid limit is that of hard shafts.
#[test]
fn a_stiff_shaft_approaches_the_rigid_one() {
    let text = helical_pair("", "e3", "analytic");
    let without_sections: String = text
        .lines()
        .filter(|line| !["shaft_moment", "shaft_stress"].iter().any(|name| line.contains(name)))
        .collect::<Vec<_>>()
        .join("\n");
    let elastic = ranges(&without_sections);
    let rigid = ranges(&without_sections.replace(
        "    material = steel,\n    frame",
        "    material = steel,\n    elastic = FALSE,\n    frame",
    ));
    let hard = "    material = gears.material(youngs_modulus = 1e6 GPa, poissons_ratio = 0.3),\n    frame";
    let stiff = ranges(&without_sections.replace("    material = steel,\n    frame", hard));
    for name in ["tilt_x", "tilt_y", "left_radial", "right_radial"] {
        let [elastic, rigid, stiff] = [&elastic, &rigid, &stiff].map(|found| found[name][1]);
        let share = (stiff - rigid) / (elastic - rigid);
        // 4854 times the stiffness: the difference from rigid is smaller by that factor.
        assert!((0.5..1.5).contains(&(share * 1e6 / 206.0)), "{name}: {elastic} {rigid} {stiff}");
    }
}

/// A countershaft with two gears: the torque between them, and the reaction of the output.
#[test]
fn two_gears_on_one_shaft_transmit_the_torque() {
    let text = "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
function blank(in teeth) { return gears.external(teeth, module = 2.5 mm, face_width = 18 mm, material = steel); }
var a = blank(20), b = blank(41), c = blank(22), d = blank(45);
var first_distance = gears.center_distance(a, b) + 0.05 mm;
var second_distance = gears.center_distance(c, d) + 0.05 mm;
var input = gears.body(\"input\", a, free = [\"theta_z\"], moment = 60 N*m * e3, frame := Rotate(900 rpm * Time, e3));
var counter = gears.shaft(
    \"counter\",
    segments = [
        gears.shaft_segment(length = 30 mm, diameter = 25 mm),
        gears.shaft_segment(length = 80 mm, diameter = 32 mm),
        gears.shaft_segment(length = 30 mm, diameter = 25 mm)],
    material = steel,
    elastic = ELASTIC,
    frame := Rotate(-900 rpm * 20 / 41 * Time, e3) * Translate(first_distance * e1 - 45 mm * e3));
var gear = gears.mount(\"gear\", b, on = counter, at = 45 mm);
var pinion = gears.mount(\"pinion\", c, on = counter, at = 95 mm);
var left = gears.bearing(\"left\", counter, at = 12 mm * e3, radial_stiffness = 4e8 N/m, axial_stiffness = 1e8 N/m);
var right = gears.bearing(\"right\", counter, at = 128 mm * e3, radial_stiffness = 4e8 N/m);
var driven = gears.body(\"driven\", d,
    frame := Rotate(900 rpm * 20 / 41 * 22 / 45 * Time, e3)
        * Translate((first_distance + second_distance) * e1 + 50 mm * e3));
var one = gears.mesh(input, gear), two = gears.mesh(pinion, driven);
output first_force := gears.mesh_force(one);
output second_force := gears.mesh_force(two);
output left_y := gears.bearing_force(left, \"y\");
output right_y := gears.bearing_force(right, \"y\");
output twist := gears.rotation(gear, \"z\") - gears.rotation(pinion, \"z\");
output reaction := gears.support_moment(driven, \"z\");
TORQUE
analyze(\"quasi_static\", over = gears.times(1 ms, 1 ms, 1), fidelity = \"analytic\", error_estimates = \"none\");
";
    let elastic = text
        .replace("ELASTIC", "TRUE")
        .replace("TORQUE", "output torque := gears.shaft_moment(counter, 70 mm, \"torque\");");
    let found = ranges(&elastic);
    let of = |name: &str| found[name][1];
    let base = |teeth: f64| 0.5 * 0.0025 * teeth * 20_f64.to_radians().cos();
    close("first mesh", of("first_force"), 60.0 / base(20.0), 1e-2);
    close("torque of the shaft", of("torque").abs(), of("first_force") * base(41.0), 1e-2);
    close("second mesh", of("second_force"), of("torque").abs() / base(22.0), 1e-2);
    close("reaction", of("reaction").abs(), 60.0 * 41.0 / 20.0 * 45.0 / 22.0, 1e-2);
    // Twist of 50 mm of the thick part.
    let gj = 206e9 / 2.6 * PI / 32.0 * 0.032_f64.powi(4);
    close("twist", of("twist").abs(), of("torque").abs() * 0.05 / gj, 1e-8);
    // On a rigid shaft both gears rotate together, almost.
    let rigid = ranges(&text.replace("ELASTIC", "FALSE").replace("TORQUE", ""));
    assert!(rigid["twist"][1].abs() < 2e-5 * of("twist").abs(), "{}", rigid["twist"][1]);
    close("second mesh", rigid["second_force"][1], of("second_force"), 1e-2);
}

/// In two dimensions a shaft twists: the wind-up is that of its length, and does not reach the
/// teeth.
#[test]
fn a_shaft_twists_in_a_plane_model() {
    let found = ranges(
        "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var a = gears.external(24, module = 2.5 mm, face_width = 20 mm), b = gears.external(37, module = 2.5 mm, face_width = 20 mm);
var shaft = gears.shaft(
    \"input\", [gears.shaft_segment(length = 200 mm, diameter = 20 mm)], steel, free = [\"theta_z\"], frame := Rotate(600 rpm * Time, e3));
var first = gears.mount(\"pinion\", a, on = shaft, at = 0 mm);
gears.shaft_load(shaft, at = 200 mm, moment = 80 N*m * e3);
var second = gears.body(\"gear\", b, frame := Rotate(-600 rpm * 24 / 37 * Time, e3) * Translate(76.3 mm * e1));
var mesh = gears.mesh(first, second);
output end := gears.shaft_rotation(shaft, 200 mm, \"z\");
output teeth := gears.rotation(first, \"z\");
output force := gears.mesh_force(mesh);
output radial := gears.support_force(shaft, \"x\");
analyze(\"quasi_static\", over = gears.times(1 ms, 1 ms, 1), fidelity = \"plane\", error_estimates = \"none\");
",
    );
    let twist = 80.0 * 0.2 / (206e9 / 2.6 * PI / 32.0 * 0.02_f64.powi(4));
    close("wind-up", found["end"][1] - found["teeth"][1], twist, 1e-8);
    close("force", found["force"][1], 80.0 / (0.5 * 24.0 * 0.0025 * 20_f64.to_radians().cos()), 2e-3);
    // The constraints of the sections carry the separating force.
    assert!(found["radial"][1].abs() > 100.0);
}

/// Two torsional modes of a flywheel and a pinion on a light shaft, from the mesh stiffness.
#[test]
fn a_shaft_with_a_flywheel_has_two_torsional_modes() {
    let found = ranges(
        "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var light = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 1e-3 kg/m^3);
var a = gears.external(24, module = 2.5 mm, face_width = 20 mm, material = light), b = gears.external(37, module = 2.5 mm, face_width = 20 mm);
var shaft = gears.shaft(
    \"input\", [gears.shaft_segment(length = 200 mm, diameter = 20 mm)], light, free = [\"theta_z\"], frame := Rotate(600 rpm * Time, e3));
var first = gears.mount(\"pinion\", a, on = shaft, at = 0 mm, inertia = 4e-4 kg*m^2);
gears.shaft_disc(shaft, at = 200 mm, mass = 5 kg, inertia = 9e-3 kg*m^2);
gears.shaft_load(shaft, at = 200 mm, moment = 80 N*m * e3);
var second = gears.body(\"gear\", b, frame := Rotate(-600 rpm * 24 / 37 * Time, e3) * Translate(76.3 mm * e1));
var mesh = gears.mesh(first, second);
output stiffness := gears.mesh_stiffness(mesh);
output low := gears.natural_frequency(1);
output high := gears.natural_frequency(2);
analyze(\"quasi_static\", over = gears.times(1 ms, 1 ms, 1), fidelity = \"plane\", error_estimates = \"none\");
",
    );
    let radius = 0.5 * 24.0 * 0.0025 * 20_f64.to_radians().cos();
    let shaft = 206e9 / 2.6 * PI / 32.0 * 0.02_f64.powi(4) / 0.2;
    let [pinion, wheel] = [4e-4, 9e-3];
    let mesh = found["stiffness"][1] * radius * radius;
    // (mesh + shaft - pinion w²)(shaft - wheel w²) = shaft².
    let (a, b, c) = (pinion * wheel, -(pinion * shaft + wheel * (mesh + shaft)), mesh * shaft);
    let root = |sign: f64| ((-b + sign * (b * b - 4.0 * a * c).sqrt()) / (2.0 * a)).sqrt() / (2.0 * PI);
    close("low", found["low"][1], root(-1.0), 1e-3);
    close("high", found["high"][1], root(1.0), 1e-3);
}

/// In two dimensions, where only gears have modes, a highest frequency below those of the gears
/// changes nothing: bending modes of the shaft do not appear.
#[test]
fn a_shaft_in_a_plane_model_has_no_component_modes() {
    let model = |highest: f64| {
        ranges(&format!(
            "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3, density = 7850 kg/m^3);
var a = gears.external(24, module = 2.5 mm, face_width = 20 mm, material = steel), b = gears.external(37, module = 2.5 mm, face_width = 20 mm, material = steel);
var shaft = gears.shaft(
    \"input\", [gears.shaft_segment(length = 200 mm, diameter = 20 mm)], steel, free = [\"theta_z\"], frame := Rotate(600 rpm * Time, e3));
var first = gears.mount(\"pinion\", a, on = shaft, at = 0 mm);
gears.shaft_disc(shaft, at = 200 mm, mass = 5 kg, inertia = 9e-3 kg*m^2);
gears.shaft_load(shaft, at = 200 mm, moment = 80 N*m * e3);
var second = gears.body(\"gear\", b, frame := Rotate(-600 rpm * 24 / 37 * Time, e3) * Translate(76.3 mm * e1));
var mesh = gears.mesh(first, second);
output low := gears.natural_frequency(1);
output high := gears.natural_frequency(2);
analyze(\"quasi_static\", over = gears.times(1 ms, 1 ms, 1), fidelity = \"plane\", highest_frequency = {highest} Hz, error_estimates = \"none\");
"
        ))
    };
    let [without, with] = [0.0, 3000.0].map(model);
    for mode in ["low", "high"] {
        close(mode, with[mode][1], without[mode][1], 1e-9);
    }
}

/// A picture has 24 points around a section, so its largest stress is at most 1 % below that of the
/// section.
#[test]
fn pictures_of_shafts_have_their_nominal_stress_and_deflection() {
    let path = calyx_tests::root().join("examples/flexible_shafts.cx");
    let text = std::fs::read_to_string(path)
        .expect("the example")
        .replace("steps = 4", "steps = 2")
        .replace("\nanalyze(", "\noutput stress := gears.shaft_stress(input);\nanalyze(");
    let found = ranges(&text);
    let folder = tempfile::tempdir().expect("a folder");
    let model = folder.path().join("model.cx");
    std::fs::write(&model, &text).expect("written");
    let module = Module::from_file(&engine(), &model).expect("a model");
    let directory = folder.path().join("run");
    let options = RunOptions { directory: directory.clone(), quiet: true, ..RunOptions::default() };
    run(module.as_program(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    let list = std::fs::read_to_string(directory.join("pictures/list.json")).expect("pictures");
    let list: Vec<serde_json::Value> = serde_json::from_str(&list).expect("a list");
    let of = |name: &str| list.iter().find(|picture| picture["body"] == name);
    assert!(of("output").is_some(), "{list:?}");
    let input = of("input").expect("a picture of the shaft");
    let number = |name: &str| input[name].as_f64().expect("a number");
    let (shown, stress) = (number("largest_stress"), found["stress"][1]);
    assert!((0.99 * stress..=(1.0 + 1e-6) * stress).contains(&shown), "{shown} instead of {stress}");
    assert!(number("largest_displacement") > found["deflection"][0], "{input}");
}

/// What a run would reject, a check rejects, with the argument.
#[test]
fn checks_reject_impossible_shafts() {
    assert_eq!(codes(&helical_pair("", "e3", "analytic")), Vec::<String>::new());
    let plane = codes(&helical_pair("", "e3", "plane"));
    assert!(plane.contains(&"E0611".to_owned()), "{plane:?}");
    let loose = helical_pair("", "e3", "analytic");
    let loose: Vec<&str> = loose
        .lines()
        .filter(|line| !["= gears.bearing(", "gears.bearing_force("].iter().any(|part| line.contains(part)))
        .collect();
    let loose = codes(&loose.join("\n"));
    assert!(loose.contains(&"E0715".to_owned()) || loose.contains(&"E0714".to_owned()), "{loose:?}");
}
