//! Flanks in `run.json`: tolerances and traces against the modules `iso1328` and `inspection`, and
//! locations of extremes against those of their outputs.

use crate::models::engine;
use calyx::Module;
use calyx::rt::{RunOptions, run};
use calyx_tests::printed::printed_numbers;
use serde_json::Value;
use std::fmt::Write;
use std::path::Path;

/// Runs a model in a directory and returns its `run.json`.
fn run_in(directory: &Path, text: &str) -> Value {
    let module = Module::from_text(&engine(), "model.cx", text).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { directory: directory.join("run"), quiet: true, ..RunOptions::default() };
    run(module.as_program().clone(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    let text = std::fs::read_to_string(directory.join("run/run.json")).expect("run.json");
    serde_json::from_str(&text).expect("JSON")
}

fn run_json(text: &str) -> Value {
    run_in(tempfile::tempdir().expect("a directory").path(), text)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap_or_else(|| panic!("no array: {value}")).iter().map(number).collect()
}

/// Symbols of the data block in the order in which the model prints the tolerances.
const SYMBOLS: [&str; 9] =
    ["f_pt", "F_p", "F_alpha", "f_falpha", "f_Halpha", "F_beta", "f_fbeta", "f_Hbeta", "F_r"];

/// Sizes of gears: teeth, normal module and face width in mm, helix angle in degrees, grade.
const SIZES: [(u32, f64, f64, f64, u32); 8] = [
    (19, 3.0, 32.0, 14.0, 6),
    (97, 14.0, 280.0, 10.0, 5),
    (25, 0.6, 4.5, 0.0, 9),
    (40, 2.0, 20.0, 0.0, 1),
    (60, 3.5, 40.0, 20.0, 11),
    (21, 6.0, 80.0, 30.0, 7),
    (150, 10.0, 160.0, 8.0, 3),
    (34, 25.0, 400.0, 0.0, 8),
];

#[test]
fn tolerances_of_a_grade_are_those_of_the_module() {
    for edition in ["1995", "2013"] {
        let (mut printing, mut gears) = (String::new(), String::new());
        for (teeth, module, width, helix, grade) in SIZES {
            writeln!(
                printing,
                "t = iso1328.flank_tolerances({teeth} * {module} mm / cos({helix} deg), {module} mm, {width} mm, {grade}, \"{edition}\");\n\
                 for (x in [t.f_pt, t.F_p, t.F_alpha, t.f_falpha, t.f_Halpha, t.F_beta, t.f_fbeta, t.f_Hbeta, t.F_r]) print(x / (1 m));",
            )
            .unwrap();
            writeln!(
                gears,
                "g = gears.external({teeth}, normal_module = {module} mm, helix_angle = {helix} deg, \
                 face_width = {width} mm, accuracy_grade = {grade}, accuracy_edition = \"{edition}\");\nprint(gears.teeth(g));",
            )
            .unwrap();
        }
        let expected = printed_numbers(
            "tolerances.cx",
            &format!("import iso1328;\nvar t = iso1328.flank_tolerances(50 mm, 3 mm, 30 mm, 6);\n{printing}"),
        );
        assert_eq!(expected.len(), 9 * SIZES.len());
        let text = format!("import gears;\nunits mm_N_s;\nvar g;\n{gears}output teeth := 1;\n");
        let run = run_json(&text);
        let found = run["gear_data"]["gears"].as_array().expect("gears");
        assert_eq!(found.len(), SIZES.len());
        for (gear, expected) in found.iter().zip(expected.chunks_exact(9)) {
            for (symbol, expected) in SYMBOLS.into_iter().zip(expected) {
                let value = number(&gear["data"][symbol]["value"]);
                assert!((value - expected).abs() < 1e-12, "{symbol} of {edition}: {value} is not {expected}");
            }
            let grade = gear["data"]["accuracy_grade"]["value"].as_str().expect("a grade");
            assert!(grade.ends_with(&format!("(ISO 1328-1:{edition})")), "{grade}");
        }
    }
}

/// A pair with intended modifications and deviations on the pinion, and with twist on the gear.
const PAIR: &str = r#"
import gears;
import inspection;
units mm_N_s;
var intended = [
    gears.tip_relief(20 um, length = 2 mm, shape = "linear"),
    gears.lead_crown(6 um),
    gears.end_relief(10 um, length = 4 mm, end = "+e3", flank = "left")];
var slips = [gears.profile_slope(-5 um), gears.helix_slope(7 um)];
function blank(in teeth, in hand, in modifications) {
    return gears.external(
        teeth,
        normal_module = 3 mm,
        helix_angle = 14 deg,
        hand = hand,
        face_width = 32 mm,
        modifications = modifications,
        accuracy_grade = 6);
}
var deviating = [gears.as_deviation(slips[0]), gears.as_deviation(slips[1])];
var pinion = blank(23, "right", [intended[0], intended[1], intended[2], deviating[0], deviating[1]]);
"#;

const REST: &str = r#"
var gear = blank(47, "left", [gears.twist(12 um)]);
var pair = gears.pair(pinion, gear, torque = 100 N*m);
output ratio := gears.contact_ratio(pair.mesh);
analyze("quasi_static", over = gears.mesh_cycle(pair.mesh, 2), fidelity = "rigid");
"#;

#[test]
fn traces_and_deviations_are_those_of_the_inspection() {
    let data = run_json(&format!("{PAIR}{REST}"))["gear_data"].clone();
    let flanks = &data["gears"][0]["flanks"];
    let point = |symbol: &str| {
        let points = flanks["points"].as_array().expect("points");
        let found = points.iter().find(|point| point["symbol"] == symbol);
        found.unwrap_or_else(|| panic!("no {symbol} in {flanks:#}")).clone()
    };
    let near = |found: f64, expected: f64, what: &str| {
        assert!(
            (found - expected).abs() < 1e-12 * expected.abs().max(1e3),
            "{what}: {found} is not {expected}"
        );
    };
    let member = &data["meshes"][0]["members"][0];
    for (symbol, of) in [("d_Nf", member), ("d_Na", member), ("d_Ff", &data["gears"][0]["data"])] {
        near(number(&point(symbol)["diameter"]), number(&of[symbol]["value"]), symbol);
    }
    let base = number(&data["gears"][0]["data"]["d_b"]["value"]);
    let start = point("d_Nf");
    let tangent = 0.5 * (number(&start["diameter"]).powi(2) - base * base).sqrt();
    near(number(&start["roll_length"]), tangent, "roll length");

    let mut text = PAIR.to_owned();
    let (start, end) = (number(&start["roll_length"]), number(&point("d_Fa")["roll_length"]));
    writeln!(
        text,
        "var slipped = blank(23, \"right\", slips);\nvar designed = blank(23, \"right\", intended);\n\
         function show(in found) {{ for (x in [found.total, found.form, found.slope]) print(x / (1 m)); }}\n\
         for (flank in [\"left\", \"right\"]) {{\n\
             show(inspection.profile_deviations(inspection.profile_trace_of(slipped, flank = flank), slipped, {start:?} m, {end:?} m));\n\
             show(inspection.helix_deviations(inspection.helix_trace_of(slipped, 32 mm, flank = flank), slipped, 32 mm));\n\
         }}"
    )
    .unwrap();
    // Amounts at some points of the traces, of the flank and of the design.
    let mut expected_points = Vec::new();
    for (side, index) in [("left", 20), ("left", 100), ("right", 60), ("right", 119)] {
        let profile = &flanks[side]["profiles"][0];
        let helix = &flanks[side]["helix"];
        let (length, axial) = (numbers(&profile["positions"])[index], numbers(&helix["positions"])[index]);
        for (gear, key) in [("pinion", "flank"), ("designed", "design")] {
            writeln!(
                text,
                "print(-gears.modification_amount({gear}, {length:?} m / gears.base_radius({gear}) * 1 rad, 0 mm, \"{side}\") / (1 m));\n\
                 print(-gears.modification_amount({gear}, inspection.roll_lengths({gear}, [gears.reference_diameter({gear})])[0] / gears.base_radius({gear}) * 1 rad, {axial:?} m, \"{side}\") / (1 m));"
            )
            .unwrap();
            expected_points.extend([numbers(&profile[key])[index], numbers(&helix[key])[index]]);
        }
    }
    let printed = printed_numbers("traces.cx", &text);
    let (deviations, amounts) = printed.split_at(12);
    let mut rest = deviations.iter();
    for side in ["left", "right"] {
        for trace in [&flanks[side]["profiles"][0], &flanks[side]["helix"]] {
            for key in ["total", "form", "slope"] {
                let (found, expected) = (number(&trace["deviations"][key]), *rest.next().unwrap());
                assert!((found - expected).abs() < 1e-13, "{side} {key}: {found} is not {expected}");
            }
        }
    }
    // Towards +e3, a positive helix slope adds material to the left flank.
    assert!(number(&flanks["left"]["helix"]["deviations"]["slope"]) > 6e-6);
    assert!(number(&flanks["right"]["helix"]["deviations"]["slope"]) < -6e-6);
    assert_eq!(amounts.len(), expected_points.len());
    for (found, expected) in expected_points.iter().zip(amounts) {
        assert!((found - expected).abs() < 1e-14, "{found} is not {expected}");
    }

    let symbols = |side: &str| -> Vec<(String, f64, bool)> {
        let amounts = flanks[side]["amounts"].as_array().expect("amounts").iter();
        let symbol = |amount: &Value| amount["symbol"].as_str().expect("a symbol").to_owned();
        amounts
            .map(|amount| (symbol(amount), number(&amount["value"]), amount["deviation"] == true))
            .collect()
    };
    let named = |all: &[(&str, f64, bool)]| -> Vec<(String, f64, bool)> {
        all.iter().map(|(symbol, value, slip)| ((*symbol).to_owned(), *value, *slip)).collect()
    };
    let common = [("C_alphaa", 20e-6, false), ("C_beta", 6e-6, false)];
    let slips = [("f_Halpha", -5e-6, true), ("f_Hbeta", 7e-6, true)];
    assert_eq!(symbols("left"), named(&[&common[..], &[("C_betaI", 10e-6, false)], &slips].concat()));
    assert_eq!(symbols("right"), named(&[&common[..], &slips].concat()));

    // The profile of a twisted flank varies along the face; a crowned one only moves.
    assert_eq!(flanks["left"]["profiles"].as_array().map(Vec::len), Some(1));
    let twisted = &data["gears"][1]["flanks"]["left"]["profiles"];
    assert_eq!(twisted.as_array().map(Vec::len), Some(3));
    assert!(twisted[1]["design"].is_null(), "no deviation from the design");
}

#[test]
fn locations_of_extremes_are_those_of_their_outputs() {
    let quantities = [
        "max_sliding_velocity",
        "max_friction_power_per_length",
        "max_flash_temperature",
        "max_contact_temperature",
        "min_film_thickness",
        "min_specific_film_thickness",
    ];
    let mut text = String::from(
        "import gears;\nunits mm_N_s;\n\
         var pinion = gears.external(23, normal_module = 3 mm, helix_angle = 14 deg, face_width = 32 mm, modifications = [gears.lead_crown(5 um)]);\n\
         var gear = gears.external(47, normal_module = 3 mm, helix_angle = 14 deg, hand = \"left\", face_width = 32 mm);\n\
         var pair = gears.pair(pinion, gear, torque = 100 N*m, speed = 1500 rpm,\n\
             lubrication = gears.lubrication(\"ISO VG 220\", temperature = 70, roughness = 0.6 um));\n",
    );
    for quantity in quantities {
        writeln!(
            text,
            "output {quantity} := gears.{quantity}(pair.mesh);\n\
             output {quantity}_radius := gears.radius_of_max(pair.first, \"{quantity}\");\n\
             output {quantity}_tooth := gears.tooth_of_max(pair.first, \"{quantity}\");\n\
             output {quantity}_axial := gears.axial_position_of_max(pair.first, \"{quantity}\");"
        )
        .unwrap();
    }
    text += "analyze(\"quasi_static\", over = gears.mesh_cycle(pair.mesh, 4), fidelity = \"analytic\");\n";
    let directory = tempfile::tempdir().expect("a directory");
    let run = run_in(directory.path(), &text);
    let steps = std::fs::read_to_string(directory.path().join("run/steps.csv")).expect("steps.csv");
    let mut rows = steps.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let header = rows.next().expect("a header");
    let rows: Vec<Vec<String>> = rows.collect();
    let column = |name: &str| header.iter().position(|cell| cell == name).unwrap_or_else(|| panic!("{name}"));
    for quantity in quantities {
        // The location of an output is that of its extreme over the points of a position, also at
        // the position with the thickest film.
        let extreme = &run["outputs"][quantity]["max_at"];
        let step = extreme["step"].as_u64().unwrap_or_else(|| panic!("{extreme}")) as usize;
        let cell = |suffix: &str| -> f64 {
            rows[step][column(&format!("{quantity}_{suffix}"))].parse().expect("a number")
        };
        let location = &extreme["location"];
        assert!((cell("radius") - number(&location["radius"])).abs() < 1e-9, "{quantity}: {location}");
        assert!((cell("axial") - number(&location["axial"])).abs() < 1e-9, "{quantity}: {location}");
        assert!((cell("tooth") - number(&location["tooth"])).abs() < 1e-9, "{quantity}: {location}");
        assert!(cell("radius") > 0.03);
    }
}

/// An idler with two different mates.
const IDLER: &str = r#"
import gears;
units mm_N_s;
function blank(in teeth, in modifications) {
    return gears.external(teeth = teeth, module = 3 mm, face_width = 20 mm, modifications = modifications);
}
var gear = blank(30, [gears.lead_crown(5 um)]), speed = 100 rpm;
var driver = gears.body("driver", blank(20, []), free = ["theta_z"], moment = 10 N*m * e3,
    frame := Rotate(speed * 30 / 20 * Time, e3));
var idler = gears.body("idler", gear, free = ["theta_z"],
    frame := Rotate(-speed * Time, e3) * Translate(75 mm * e1));
var driven = gears.body("driven", blank(60, []),
    frame := Rotate(speed * 30 / 60 * Time, e3) * Translate(210 mm * e1));
var input = gears.mesh(driver, idler), output_mesh = gears.mesh(idler, driven);
output ratio := gears.contact_ratio(input);
analyze("quasi_static", over = gears.mesh_cycle(input, 2), fidelity = "rigid");
"#;

#[test]
fn each_mesh_of_a_gear_has_its_active_profile() {
    let data = run_json(IDLER)["gear_data"].clone();
    let gears = data["gears"].as_array().expect("gears");
    let idler = gears.iter().find(|gear| gear["flanks"].is_object()).expect("the modified gear");
    let points = idler["flanks"]["points"].as_array().expect("points");
    let mut starts = Vec::new();
    for (mate, mesh, member) in [("driver", 0, 1), ("driven", 1, 0)] {
        for symbol in ["d_Nf", "d_Na"] {
            let found: Vec<_> =
                points.iter().filter(|point| point["symbol"] == symbol && point["mate"] == mate).collect();
            assert_eq!(found.len(), 1, "{symbol} with {mate}: {points:#?}");
            let expected = number(&data["meshes"][mesh]["members"][member][symbol]["value"]);
            assert!((number(&found[0]["diameter"]) - expected).abs() < 1e-12, "{symbol} with {mate}");
            if symbol == "d_Nf" {
                starts.push(number(&found[0]["roll_length"]));
            }
        }
    }
    // The larger mate reaches nearer to the root.
    assert!(starts[0] > starts[1], "{starts:?}");
    let range = numbers(&idler["flanks"]["profile_range"]);
    assert_eq!(range[0], starts[1], "the evaluation range begins at the lower SAP");
    assert!(points.iter().all(|point| point["symbol"] != "d_a" || point.get("mate").is_none()));
}
