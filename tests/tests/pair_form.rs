//! Compares `gears.pair` with the bodies, bearings and the mesh that it stands for: every position
//! has the same results, to the last bit.

use crate::models::engine;
use calyx::Module;
use calyx::rt::{RunOptions, run};
use serde_json::Value;
use std::fs;

/// Gears and outputs of a model whose pair is written in two ways. The long form declares `first`,
/// `second` and `mesh`.
struct Case {
    name: &'static str,
    gears: &'static str,
    short: &'static str,
    long: &'static str,
    fidelity: &'static str,
}

const SPUR: &str = "
var a = gears.external(24, module = 2.5 mm, face_width = 20 mm);
var b = gears.external(37, module = 2.5 mm, face_width = 20 mm);
";

const HELICAL: &str = "
function blank(in teeth, in hand, in shift) {
    return gears.external(
        teeth, normal_module = 3 mm, helix_angle = 14 deg, hand = hand, profile_shift = shift, face_width = 32 mm);
}
var a = blank(19, \"right\", 0.25), b = blank(47, \"left\", -0.1);
";

const INTERNAL: &str = "
var a = gears.external(20, module = 4 mm, face_width = 30 mm);
var b = gears.internal(60, module = 4 mm, face_width = 30 mm, tip_alteration = -0.2);
";

const CASES: &[Case] = &[
    Case {
        name: "the first gear drives, without backlash",
        gears: SPUR,
        short: "gears.pair(a, b, torque = 120 N*m, speed = 1000 rpm)",
        long: "
var first = gears.body(\"pinion\", a, free = [\"theta_z\"], moment = 120 N*m * e3,
    frame := Rotate(1000 rpm * Time, e3));
var second = gears.body(\"gear\", b,
    frame := Rotate(-1000 rpm * 24 / 37 * Time, e3) * Translate(gears.center_distance(a, b) * e1));
var mesh = gears.mesh(first, second);",
        fidelity: "plane",
    },
    Case {
        name: "the second gear drives clockwise, stated by its power",
        gears: SPUR,
        short: "gears.pair(a, b, center_distance = 76.3 mm, power = 20 kW, speed = -1500 rpm,
            reference_gear = \"second\", driver = \"second\", contact_cells = 12)",
        long: "
var first = gears.body(\"pinion\", a, frame := Rotate(1500 rpm * 37 / 24 * Time, e3));
var second = gears.body(\"gear\", b, free = [\"theta_z\"],
    moment = gears.torque_from_power(20 kW, -1500 rpm) * e3,
    frame := Rotate(-1500 rpm * Time, e3) * Translate(76.3 mm * e1));
var mesh = gears.mesh(first, second, contact_cells = 12);",
        fidelity: "plane",
    },
    Case {
        name: "the first gear of a reducer is driven by the load on the second",
        gears: SPUR,
        short: "gears.pair(a, b, center_distance = 76.3 mm, torque = 90 N*m, speed = 700 rpm, driver = \"second\")",
        long: "
var first = gears.body(\"pinion\", a, free = [\"theta_z\"], moment = -90 N*m * e3,
    frame := Rotate(700 rpm * Time, e3));
var second = gears.body(\"gear\", b,
    frame := Rotate(-700 rpm * 24 / 37 * Time, e3) * Translate(76.3 mm * e1));
var mesh = gears.mesh(first, second);",
        fidelity: "plane",
    },
    Case {
        name: "an internal gear rotates in the direction of its pinion",
        gears: INTERNAL,
        short: "gears.pair(a, b, center_distance = 79.9 mm, torque = 200 N*m, speed = -60 rpm)",
        long: "
var first = gears.body(\"pinion\", a, free = [\"theta_z\"], moment = -200 N*m * e3,
    frame := Rotate(-60 rpm * Time, e3));
var second = gears.body(\"gear\", b,
    frame := Rotate(-60 rpm * 20 / 60 * Time, e3) * Translate(79.9 mm * e1));
var mesh = gears.mesh(first, second);",
        fidelity: "plane",
    },
    Case {
        name: "misalignment, friction and a grid",
        gears: HELICAL,
        short: "gears.pair(a, b, center_distance = 102.55 mm, torque = 200 N*m, speed = 1000 rpm,
            misalignment = 0.2 mrad, friction = 0.05, contact_cells = 6, contact_slices = 4)",
        long: "
var first = gears.body(\"pinion\", a, free = [\"theta_z\"], moment = 200 N*m * e3,
    frame := Rotate(1000 rpm * Time, e3));
var second = gears.body(\"gear\", b,
    frame := Rotate(-1000 rpm * 19 / 47 * Time, e3) * Translate(102.55 mm * e1));
var mesh = gears.mesh(first, second, misalignment = 0.2 mrad, friction = 0.05, contact_cells = 6,
    contact_slices = 4);",
        fidelity: "analytic",
    },
    Case {
        name: "supports",
        gears: HELICAL,
        short: "gears.pair(a, b, center_distance = 102.55 mm, torque = 200 N*m, speed = 1000 rpm,
            first_supports = [
                gears.Support(axial_position = 40 mm, radial_stiffness = 4e8 N/m, axial_stiffness = 2e8 N/m),
                gears.Support(axial_position = 110 mm, radial_stiffness = 4e8 N/m)],
            second_supports = [gears.Support(radial_stiffness = 6e8 N/m, tilting_stiffness = 1e7 N*m/rad)],
            contact_cells = 6, contact_slices = 4)",
        long: "
var first = gears.body(\"pinion\", a,
    free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\", \"theta_z\"], moment = 200 N*m * e3,
    frame := Rotate(1000 rpm * Time, e3));
var second = gears.body(\"gear\", b, free = [\"u_x\", \"u_y\", \"theta_x\", \"theta_y\"],
    frame := Rotate(-1000 rpm * 19 / 47 * Time, e3) * Translate(102.55 mm * e1));
gears.bearing(\"inner\", first, at = 40 mm * e3, radial_stiffness = 4e8 N/m, axial_stiffness = 2e8 N/m);
gears.bearing(\"outer\", first, at = 110 mm * e3, radial_stiffness = 4e8 N/m);
gears.bearing(\"gear\", second, radial_stiffness = 6e8 N/m, tilting_stiffness = 1e7 N*m/rad);
var mesh = gears.mesh(first, second, contact_cells = 6, contact_slices = 4);",
        fidelity: "analytic",
    },
];

/// Returns the rows of all positions and the outputs of a run.
fn results(case: &Case, pair: &str) -> (String, Value) {
    let text = format!(
        "import gears;\nunits mm_N_s;\n{}{pair}
output transmission_error := gears.transmission_error(mesh) * gears.base_radius(b);
output load_share := gears.load_share(mesh);
output sliding := gears.max_sliding_velocity(mesh);
output force := gears.mesh_force(mesh);
output pressure := gears.max_contact_pressure(mesh);
output root_stress_first := gears.max_root_stress(first);
output root_stress_second := gears.max_root_stress(second);
output tilt := gears.rotation(first, \"x\");
output moment := gears.support_moment(second, \"z\");
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 3), fidelity = \"{}\");\n",
        case.gears, case.fidelity
    );
    let module = Module::from_text(&engine(), "model.cx", &text)
        .unwrap_or_else(|error| panic!("{}: {error}", case.name));
    let directory = tempfile::tempdir().expect("a directory");
    let options =
        RunOptions { directory: directory.path().join("run"), quiet: true, ..RunOptions::default() };
    run(module.as_program().clone(), &options).unwrap_or_else(|error| panic!("{}: {error:?}", case.name));
    let read =
        |file: &str| fs::read_to_string(directory.path().join("run").join(file)).expect("a file of the run");
    let run: Value = serde_json::from_str(&read("run.json")).expect("JSON");
    (read("steps.csv"), run["outputs"].clone())
}

#[test]
fn a_pair_has_the_results_of_its_bodies_and_mesh() {
    for case in CASES {
        let short = format!(
            "var pair = {};\nvar first = pair.first, second = pair.second, mesh = pair.mesh;\n",
            case.short
        );
        let (short, long) = (results(case, &short), results(case, case.long));
        assert!(short.0.lines().count() > 3, "{}: {}", case.name, short.0);
        assert_eq!(short, long, "{}", case.name);
    }
}

/// Power and torque of either gear state the same load.
#[test]
fn the_load_has_one_meaning() {
    let force = |arguments: &str| {
        let text = format!(
            "import gears;\nunits mm_N_s;\n{SPUR}var pair = gears.pair(a, b, {arguments});
output force := gears.mesh_force(pair.mesh);
analyze(\"quasi_static\", over = gears.mesh_cycle(pair.mesh, 2), fidelity = \"plane\");\n"
        );
        let module =
            Module::from_text(&engine(), "model.cx", &text).unwrap_or_else(|error| panic!("{error}"));
        let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{arguments}: {error}"));
        results.summary_si("force").expect("an output").max
    };
    let expected = force("torque = 100 N*m");
    // Normal force of rigid teeth: torque over base radius. Deflections change the arm by a
    // thousandth.
    let base_radius = 0.5 * 24.0 * 0.0025 * 20_f64.to_radians().cos();
    let of_rigid_teeth = 100.0 / base_radius;
    assert!((expected / of_rigid_teeth - 1.0).abs() < 2e-3, "{expected} N is not {of_rigid_teeth} N");
    let power = 100.0 * 1500.0 * std::f64::consts::PI / 30.0;
    for (arguments, difference) in [
        (format!("power = {power:?} W, speed = 1500 rpm"), 1e-9),
        (format!("power = {power:?} W, torque = 100 N*m"), 1e-9),
        (format!("power = {power:?} W, torque = 100 N*m, speed = 1500 rpm"), 1e-9),
        // The other flanks, of equal teeth.
        (format!("power = {power:?} W, speed = -1500 rpm"), 1e-6),
        // The torque acts on the other gear, whose arm changes differently.
        ("torque = 100 N*m * 37 / 24, reference_gear = \"second\"".to_owned(), 2e-3),
        (format!("power = {power:?} W, speed = 1500 rpm * 24 / 37, reference_gear = \"second\""), 2e-3),
    ] {
        let found = force(&arguments);
        assert!((found / expected - 1.0).abs() < difference, "{arguments}: {found} N is not {expected} N");
    }
}
