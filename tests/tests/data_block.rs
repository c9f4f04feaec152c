//! Compares the section `gear_data` of `run.json` with the closed-form geometry of
//! `gear_geometry.json`, and with the module `iso21771`.

use crate::models::engine;
use calyx::Module;
use calyx::rt::{RunOptions, run};
use calyx_tests::root;
use serde_json::Value;
use std::fmt::Write;

/// Runs a model and returns the section `gear_data` of its `run.json`.
fn gear_data(text: &str) -> Value {
    let module = Module::from_text(&engine(), "model.cx", text).unwrap_or_else(|error| panic!("{error}"));
    let directory = tempfile::tempdir().expect("a directory");
    let options =
        RunOptions { directory: directory.path().join("run"), quiet: true, ..RunOptions::default() };
    run(module.as_program().clone(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    let text = std::fs::read_to_string(directory.path().join("run/run.json")).expect("run.json");
    let run: Value = serde_json::from_str(&text).expect("JSON");
    run["gear_data"].clone()
}

/// Value in SI of an entry.
fn si(data: &Value, key: &str) -> f64 {
    data[key]["value"].as_f64().unwrap_or_else(|| panic!("no {key} in {data:#}"))
}

fn close(value: f64, expected: f64, what: &str) {
    assert!((value - expected).abs() <= 1e-9 * expected.abs().max(1e-3), "{what}: {value} is not {expected}");
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("no number {key}"))
}

/// Call of `gears.external` or `gears.internal` with the data of a gear, in a unit of length.
fn gear_call(gear: &Value, unit: &str) -> String {
    let (teeth, reference) = (number(gear, "N"), 2.0 * number(gear, "rp"));
    let module = reference / teeth;
    let mut call = String::new();
    if gear["minor_r"].is_null() {
        write!(
            call,
            "gears.external(teeth = {teeth}, face_width = 10 * {module:?} {unit}, \
             rack = gears.rack(module = {module:?} {unit}, tip_radius = {:?} {unit}), \
             tip_diameter = 2 * {:?} {unit}, root_diameter = 2 * {:?} {unit}, \
             transverse_thickness = {:?} {unit}",
            number(gear, "rack_tip_radius"),
            number(gear, "ra"),
            number(gear, "root_r"),
            number(gear, "pitch_thickness"),
        )
    } else {
        write!(
            call,
            "gears.internal(teeth = {teeth}, module = {module:?} {unit}, face_width = 10 * {module:?} {unit}, \
             tip_diameter = 2 * {:?} {unit}, transverse_thickness = {:?} {unit}",
            number(gear, "minor_r"),
            gear["thickness_at_r"][0][1].as_f64().expect("a thickness at the reference circle"),
        )
    }
    .expect("text");
    // The dimension over balls repeats the thickness: both statements have to agree.
    let (argument, over) = match gear["minor_r"].is_null() {
        true => ("over_balls", &gear["over_pins"]),
        false => ("between_balls", &gear["between_pins"]),
    };
    if let (Some(over), Some(pin)) = (over.as_f64(), gear["pin"].as_f64()) {
        write!(call, ", {argument} = {over:?} {unit}, ball = {pin:?} {unit}").expect("text");
    }
    call + ")"
}

fn check_gear(data: &Value, gear: &Value, metres: f64) {
    let external = gear["minor_r"].is_null();
    close(si(data, "z"), number(gear, "N"), "z");
    for (key, radius) in [
        ("d", "rp"),
        ("d_b", "rb"),
        ("d_a", if external { "ra" } else { "minor_r" }),
        ("d_f", "root_r"),
        ("d_Ff", "form_r"),
    ] {
        let Some(radius) = gear[radius].as_f64() else { continue };
        close(si(data, key), 2.0 * radius * metres, key);
    }
    close(si(data, "s_an"), number(gear, "tip_thickness") * metres, "s_an");
    if let Some(thickness) = gear["pitch_thickness"].as_f64() {
        close(si(data, "s_t"), thickness * metres, "s_t");
        assert_eq!(data["s_t"]["value"], data["s_n"]["value"], "both sections of a spur gear are equal");
    }
    let over = if external { &gear["over_pins"] } else { &gear["between_pins"] };
    if let Some(over) = over.as_f64() {
        close(si(data, "D_M"), number(gear, "pin") * metres, "D_M");
        close(si(data, "M_dK"), over * metres, "M_dK");
    }
    assert!(si(data, "mass") > 0.0 && si(data, "inertia") > 0.0);
}

#[test]
fn run_json_has_the_closed_form_geometry() {
    let path = root().join("stdlib-gears/tests/data/gear_geometry.json");
    let data: Value = serde_json::from_str(&std::fs::read_to_string(path).expect("the data")).expect("JSON");
    let mut compared = 0;
    for (name, pair) in data["pairs"].as_object().expect("pairs") {
        let (unit, metres) = if name == "ch5" { ("inch", 0.0254) } else { ("mm", 1e-3) };
        let system = if name == "ch5" { "inch_lbf_s" } else { "mm_N_s" };
        let mesh = &pair["mesh"];
        let distance = number(mesh, "C");
        let sign = if pair["g2"]["minor_r"].is_null() { -1.0 } else { 1.0 };
        let ratio = sign * number(&pair["g1"], "N") / number(&pair["g2"], "N");
        let text = format!(
            "import gears;\nunits {system};\n\
             var first = gears.body(\"first\", {}, free = [\"theta_z\"], moment = 1 N*m * e3, \
             frame := Rotate(1 rad/s * Time, e3));\n\
             var second = gears.body(\"second\", {}, \
             frame := Rotate({ratio:?} rad/s * Time, e3) * Translate({:?} {unit} * e1));\n\
             var mesh = gears.mesh(first, second);\n\
             output teeth := 1;\n",
            gear_call(&pair["g1"], unit),
            gear_call(&pair["g2"], unit),
            -sign * distance,
        );
        let found = gear_data(&text);
        assert_eq!(found["gears"].as_array().map(Vec::len), Some(2), "{name}: {found:#}");
        for (gear, key) in found["gears"].as_array().expect("gears").iter().zip(["g1", "g2"]) {
            check_gear(&gear["data"], &pair[key], metres);
        }
        let (common, members) = (&found["meshes"][0]["data"], &found["meshes"][0]["members"]);
        close(si(common, "a"), distance * metres, "a");
        let angle = number(mesh, "operating_pressure_angle_deg").to_radians();
        close(si(common, "alpha_wt"), angle, "alpha_wt");
        assert_eq!(common["alpha_wt"]["value"], common["alpha_wn"]["value"]);
        close(si(common, "epsilon_alpha"), number(mesh, "contact_ratio"), "epsilon_alpha");
        close(si(common, "g_alpha"), number(mesh, "line_of_action_length") * metres, "g_alpha");
        for (key, point) in [("d_Nf", "SAP"), ("d_LPSTC", "LPSTC"), ("d_HPSTC", "HPSTC"), ("d_Na", "EAP")] {
            let roll = number(&mesh["roll1_deg"], point).to_radians();
            let diameter = 2.0 * number(&pair["g1"], "rb") * roll.hypot(1.0);
            close(si(&members[0], key), diameter * metres, key);
            compared += 1;
        }
    }
    assert_eq!(compared, 12);
}

/// The helical pair of the guide to drawings, with allowances.
const HELICAL: &str = "
import gears;
import iso21771;
units mm_N_s;
var teeth = [19, 47], shifts = [0.25, -0.1], hands = [\"right\", \"left\"];
var upper = [-0.04 mm, -0.05 mm], lower = [-0.07 mm, -0.09 mm];
function blank(in i) {
    return gears.external(
        teeth = teeth[i], normal_module = 3 mm, helix_angle = 14 deg, hand = hands[i], face_width = 32 mm,
        profile_shift = shifts[i], upper_allowance = upper[i], lower_allowance = lower[i],
        thickness_limit = \"mean\", material = \"1.7131\");
}
function data(in i) {
    return iso21771.gear_data(
        teeth = teeth[i], normal_module = 3 mm, helix_angle = 14 deg,
        hand = if (i == 0) iso21771.Hand.right else iso21771.Hand.left, face_width = 32 mm,
        profile_shift = shifts[i], upper_allowance = upper[i], lower_allowance = lower[i]);
}
var blanks = [blank(0), blank(1)], g = [data(0), data(1)];
var pair = iso21771.pair_data(g[0], g[1]);
var first = gears.body(\"pinion\", blanks[0], free = [\"theta_z\"], moment = 1 N*m * e3,
    frame := Rotate(1 rad/s * Time, e3));
var second = gears.body(\"gear\", blanks[1],
    frame := Rotate(-19 / 47 * 1 rad/s * Time, e3) * Translate(pair.center_distance * e1));
var mesh = gears.mesh(first, second);
";

/// Pair with tips that the drawing rounds by 0.25 mm and 0.4 mm, external and internal.
const ROUNDED: [&str; 2] = [
    "var first = gears.external(teeth = 19, normal_module = 3 mm, helix_angle = 14 deg, profile_shift = 0.25,
        face_width = 32 mm, tip_edge_radius = 0.25 mm);
    var second = gears.external(teeth = 47, normal_module = 3 mm, helix_angle = 14 deg, hand = \"left\",
        face_width = 32 mm, tip_edge_radius = 0.4 mm);",
    "var first = gears.external(teeth = 21, module = 3 mm, face_width = 32 mm, tip_edge_radius = 0.25 mm);
    var second = gears.internal(teeth = 70, module = 3 mm, face_width = 32 mm, tip_diameter = 205 mm,
        tip_edge_radius = 0.4 mm);",
];

/// The involute ends at the tip form circle, and the path of contact with it (ISO 21771). Both data
/// blocks have one definition.
#[test]
fn contact_ends_at_the_tip_form_circles() {
    let of_mesh =
        [("epsilon_alpha", "transverse_contact_ratio(data)"), ("g_alpha", "path_length(data) / 1 m")];
    let of_member = [
        ("d_Na", "active_tip_diameter(data, \"first\") / 1 m"),
        ("d_Nf", "path_diameter(data, \"A\", \"first\") / 1 m"),
        ("d_LPSTC", "path_diameter(data, \"B\", \"first\") / 1 m"),
        ("d_HPSTC", "path_diameter(data, \"D\", \"first\") / 1 m"),
        ("zeta_max", "specific_sliding(data, \"A\", \"first\")"),
    ];
    for gears in ROUNDED {
        let mut text = format!(
            "import gears;\nimport iso21771;\nunits mm_N_s;\n{gears}
            var pair = gears.pair(first, second, torque = 100 N*m, speed = 1000 rpm);
            var data = iso21771.pair_data_of(pair.mesh);
            output ratio := gears.contact_ratio(pair.mesh);\n"
        );
        for (index, (_, expression)) in of_mesh.iter().chain(&of_member).enumerate() {
            writeln!(text, "output value_{index} := iso21771.{expression};").expect("text");
        }
        let module =
            Module::from_text(&engine(), "model.cx", &text).unwrap_or_else(|error| panic!("{error}"));
        let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
        let value = |name: &str| results.summary_si(name).expect("an output").max;
        let data = gear_data(&text);
        let (mesh, gears) = (&data["meshes"][0], &data["gears"]);
        let members = &mesh["members"];
        let sections = of_mesh.map(|entry| (entry.0, &mesh["data"]));
        let sections = sections.into_iter().chain(of_member.map(|entry| (entry.0, &members[0])));
        for (index, (key, section)) in sections.enumerate() {
            close(si(section, key), value(&format!("value_{index}")), key);
        }
        close(si(&mesh["data"], "epsilon_alpha"), value("ratio"), "contact_ratio");
        for member in 0..2 {
            let gear = &gears[member]["data"];
            assert!((si(gear, "d_Fa") - si(gear, "d_a")).abs() > 1e-4, "{gear:#}");
            close(si(&members[member], "d_Na"), si(gear, "d_Fa"), "d_Na");
        }
    }
}

#[test]
fn the_data_block_agrees_with_the_module_of_gear_data() {
    let of_gear = [
        ("s_n", "normal_thickness(g[0]) / 1 m"),
        ("s_ns", "normal_thickness(g[0], \"upper\") / 1 m"),
        ("s_nm", "normal_thickness(g[0], \"mean\") / 1 m"),
        ("s_ti", "transverse_thickness(g[0], \"lower\") / 1 m"),
        ("x", "generated_profile_shift(g[0])"),
        ("x_E", "generated_profile_shift(g[0], \"mean\")"),
        ("W_k", "span(g[0]) / 1 m"),
        ("W_ks", "span(g[0], limit = \"upper\") / 1 m"),
        ("W_ki", "span(g[0], limit = \"lower\") / 1 m"),
        ("span_teeth", "span_teeth(g[0])"),
        ("M_dK", "dimension_over_balls(g[0], 1.728 * 3 mm) / 1 m"),
        ("M_dKs", "dimension_over_balls(g[0], 1.728 * 3 mm, \"upper\") / 1 m"),
        ("beta_b", "base_helix_angle(g[0]) / 1 rad"),
        ("alpha_t", "transverse_pressure_angle(g[0]) / 1 rad"),
        ("d_f", "root_diameter(g[0]) / 1 m"),
        ("d_fE", "root_diameter(g[0], \"mean\") / 1 m"),
        ("d_FfE", "root_form_diameter(g[0], \"mean\") / 1 m"),
        ("h", "tooth_depth(g[0]) / 1 m"),
        ("h_E", "tip_diameter(g[0]) / 2 m - iso21771.root_diameter(g[0], \"mean\") / 2 m"),
        ("s_an", "tip_thickness(g[0]) / 1 m"),
        ("s_anE", "tip_thickness(g[0], \"mean\") / 1 m"),
        ("x_E - x_Emin", "generated_profile_shift(g[0], \"mean\") - iso21771.undercut_limit(g[0])"),
    ];
    let of_mesh = [
        ("a", "center_distance_of_shifts(g[0], g[1]) / 1 m"),
        ("alpha_wn", "normal_working_pressure_angle(pair) / 1 rad"),
        ("beta_w", "working_helix_angle(pair) / 1 rad"),
        ("epsilon_gamma", "total_contact_ratio(pair)"),
        ("j_wt", "circumferential_backlash(pair, \"mean\") / 1 m"),
        ("j_wt_min", "circumferential_backlash(pair, \"minimum\") / 1 m"),
        ("j_wt_max", "circumferential_backlash(pair, \"maximum\") / 1 m"),
        ("j_bn", "normal_backlash(pair, \"mean\") / 1 m"),
    ];
    let of_member = [
        ("d_LPSTC", "path_diameter(pair, \"B\", \"first\") / 1 m"),
        ("d_HPSTC", "path_diameter(pair, \"D\", \"first\") / 1 m"),
        ("d_Nf", "path_diameter(pair, \"A\", \"first\") / 1 m"),
        ("d_Na", "path_diameter(pair, \"E\", \"first\") / 1 m"),
        ("zeta_max", "specific_sliding(pair, \"A\", \"first\")"),
        ("j_phi", "angular_backlash(pair, \"first\", \"mean\") / 1 rad"),
        ("c", "tip_clearance(pair, \"second\") / 1 m"),
        ("c_E", "tip_clearance(pair, \"second\", \"mean\") / 1 m"),
    ];
    let mut text = HELICAL.to_owned();
    let all = of_gear.iter().chain(&of_mesh).chain(&of_member);
    for (index, (_, expression)) in all.enumerate() {
        writeln!(text, "output value_{index} := iso21771.{expression};").expect("text");
    }
    let module = Module::from_text(&engine(), "model.cx", &text).unwrap_or_else(|error| panic!("{error}"));
    let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
    let data = gear_data(&text);
    let sections = [
        (&of_gear[..], &data["gears"][0]["data"]),
        (&of_mesh[..], &data["meshes"][0]["data"]),
        (&of_member[..], &data["meshes"][0]["members"][0]),
    ];
    let mut index = 0;
    for (entries, section) in sections {
        for (key, _) in entries {
            let expected = results.summary_si(&*format!("value_{index}")).expect("an output").max;
            close(si(section, key), expected, key);
            index += 1;
        }
    }
    assert_eq!(data["gears"][0]["data"]["material"]["value"], "16MnCr5");
    assert_eq!(data["gears"][0]["data"]["rack"]["value"], "ISO 53 A");
    assert_eq!(data["gears"][0]["data"]["thickness_limit"]["value"], "mean");
    assert_eq!(data["gears"][1]["data"]["hand"]["value"], "left");
    assert_eq!(data["gears"][0]["data"]["d_a"]["display"]["text"], "66.2450");
}
