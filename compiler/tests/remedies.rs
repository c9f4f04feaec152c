//! Checks that numbers in help messages fix the error: each row is a model with an error, and the
//! change that its help advises.

use calyx::{Engine, Module, check_text};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Quantity of a model: its name in the text, its number and its unit.
type Given = (&'static str, f64, &'static str);

/// Change by the number with this index in the help, from 0.
enum Remedy {
    Set(&'static str, usize),
    Add(&'static str, usize),
}
use Remedy::{Add, Set};

struct Row {
    code: &'static str,
    /// Model text, with names of quantities in angle brackets.
    model: &'static str,
    given: Vec<Given>,
    remedy: Vec<Remedy>,
}

const RACK: &str = "
import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = <modulus>, poissons_ratio = 0.3, density = <density>);
var rack = gears.rack(module = 2 mm, tip_radius = <tip_radius>, plane = \"<plane>\");
var blank = gears.external(
    teeth = <teeth>, rack = rack, face_width = <face_width>, outer_diameter = <outer>, root_diameter = <root>, material = steel,
    rim = gears.simple_rim(diameter = <rim>, inner_diameter = <bore>), profile_shift = <shift>, tooth_thickness = <thickness>,
    helix_angle = <helix>);
";

const PAIR: &str = "
import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var rack = gears.rack(module = 2 mm, tip_radius = 0.4 mm);
function blank(in teeth) {
    return gears.external(teeth, rack, 10 mm, (teeth + 2) * 2 mm, teeth * 2 mm - 5 mm, steel,
                          gears.simple_rim(teeth * 2 mm - 8 mm, teeth * 2 mm - 18 mm), tooth_thickness = 3.13 mm);
}
var pinion = gears.body(\"pinion\", blank(24), free = [\"theta_z\"], moment = 20 N*m * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", blank(37), frame := Rotate(-60 rpm * 24/37 * Time, e3) * Translate(<distance> * e1));
var mesh = gears.mesh(pinion, gear);
";

const RING: &str = "
import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var shaper = gears.shaper(teeth = 20, module = 2 mm, tip_radius = <tip_radius>, addendum = <addendum>);
var ring = gears.internal(
    teeth = 60, shaper = shaper, face_width = 10 mm, minor_diameter = <minor>, root_diameter = 125 mm, material = steel,
    rim = gears.outer_rim(diameter = 128 mm, outer_diameter = <outer>), tooth_thickness = <thickness>);
var pinion = gears.body(
    \"pinion\", gears.external(18, gears.rack(module = 2 mm, tip_radius = 0.4 mm), 10 mm, 40 mm, 31 mm, steel,
                             gears.simple_rim(28 mm, 20 mm), tooth_thickness = 3.1 mm),
    free = [\"theta_z\"], moment = 20 N*m * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", ring, frame := Rotate(18 rpm * Time, e3) * Translate(<distance> * e1));
var mesh = gears.mesh(pinion, gear);
";

/// Returns the model of a gear from a rack, with number of teeth, plane of the rack, helix angle in
/// degrees, and further arguments.
fn gear(
    code: &'static str,
    (plane, helix, teeth): (&'static str, f64, f64),
    differing: &[Given],
    remedy: Vec<Remedy>,
) -> Row {
    let stretch = if plane == "normal" { helix.to_radians().cos() } else { 1.0 };
    let pitch = 2.0 * teeth / stretch;
    let mut given = vec![
        ("modulus", 206.0, "GPa"),
        ("density", 7850.0, "kg/m^3"),
        ("tip_radius", 0.4, "mm"),
        ("plane", 0.0, plane),
        ("teeth", teeth, ""),
        ("face_width", 10.0, "mm"),
        ("outer", pitch + 4.0, "mm"),
        ("root", pitch - 5.0, "mm"),
        ("rim", pitch - 8.0, "mm"),
        ("bore", (pitch - 18.0).max(4.0), "mm"),
        ("shift", 0.0, ""),
        ("thickness", 0.0, "mm"),
        ("helix", helix, "deg"),
    ];
    change(&mut given, differing);
    Row { code, model: RACK, given, remedy }
}

fn pair(code: &'static str, distance: f64) -> Row {
    Row { code, model: PAIR, given: vec![("distance", distance, "mm")], remedy: vec![Set("distance", 0)] }
}

fn ring(code: &'static str, differing: &[Given], remedy: Vec<Remedy>) -> Row {
    let mut given = vec![
        ("tip_radius", 0.3, "mm"),
        ("addendum", 2.5, "mm"),
        ("minor", 116.8, "mm"),
        ("outer", 140.0, "mm"),
        ("thickness", 3.1, "mm"),
        ("distance", 42.0, "mm"),
    ];
    change(&mut given, differing);
    Row { code, model: RING, given, remedy }
}

fn change(given: &mut [Given], differing: &[Given]) {
    for (name, number, unit) in differing {
        let quantity = given.iter_mut().find(|(known, ..)| known == name).expect("a quantity");
        *quantity = (name, *number, unit);
    }
}

fn rows() -> Vec<Row> {
    let [spur, transverse, normal] = [("transverse", 0.0), ("transverse", 25.0), ("normal", 25.0)];
    let mut rows = Vec::new();
    for (plane, helix) in [spur, transverse, normal, ("normal", 12.0), ("normal", 40.0)] {
        for teeth in [9.0, 11.0, 13.0] {
            let kind = (plane, helix, teeth);
            let undercut = || vec![Add("shift", 0), Add("root", 1), Add("outer", 1)];
            if helix < 40.0 || teeth < 10.0 && plane != "normal" {
                rows.push(gear("W0614", kind, &[], undercut()));
            }
        }
        let kind = (plane, helix, 30.0);
        rows.push(gear("E0612", kind, &[("tip_radius", 1.3, "mm")], vec![Set("tip_radius", 0)]));
        rows.push(gear("E0605", kind, &[("thickness", 9.0, "mm")], vec![Set("thickness", 0)]));
        rows.push(gear(
            "E0805",
            kind,
            &[("thickness", 3.3, "mm"), ("shift", 0.3, "")],
            vec![Set("shift", 0)],
        ));
    }
    let kind = ("transverse", 0.0, 30.0);
    rows.push(gear("E0803", kind, &[("face_width", 0.02, "mm")], vec![Set("face_width", 0)]));
    rows.push(gear("W0802", kind, &[("modulus", 206.0, "MPa")], vec![Set("modulus", 0)]));
    rows.push(gear("W0802", kind, &[("density", 7.85, "kg/m^3")], vec![Set("density", 0)]));
    rows.push(gear("W0804", kind, &[("bore", 51.9, "mm")], vec![Set("bore", 0)]));
    rows.push(gear(
        "W0804",
        kind,
        &[("rim", 54.8, "mm"), ("bore", 54.6, "mm")],
        vec![Set("bore", 0), Set("rim", 0)],
    ));
    rows.extend([pair("E0631", 50.0), pair("E0632", 70.0), pair("W0635", 60.9)]);
    rows.push(ring(
        "W0635",
        &[("distance", 42.2, "mm"), ("thickness", 3.13, "mm")],
        vec![Set("distance", 0)],
    ));
    rows.push(ring("E0626", &[("tip_radius", 1.2, "mm")], vec![Set("tip_radius", 0)]));
    rows.push(ring("E0628", &[("minor", 113.3, "mm")], vec![Set("minor", 0)]));
    rows
}

fn text(model: &str, given: &[Given]) -> String {
    let mut text = model.to_owned();
    for (name, number, unit) in given {
        let quantity = if *name == "plane" { (*unit).to_owned() } else { format!("{number:?} {unit}") };
        text = text.replace(&format!("<{name}>"), quantity.trim_end());
    }
    text
}

/// Returns the help of a finding by its code; `None` if there is no such finding.
fn help(text: &str, code: &str) -> Option<String> {
    let found = check_text("model.cx", text).diagnostics;
    found.into_iter().find(|found| found.code == code).map(|found| found.help.unwrap_or_default())
}

/// Returns the numbers in a sentence, each with the following word.
fn quantities(sentence: &str) -> Vec<(f64, String)> {
    let words: Vec<&str> = sentence.split_whitespace().collect();
    let number = |word: &str| word.trim_end_matches([',', ';', '?', ')', ':']).parse::<f64>().ok();
    let at = |(index, word): (usize, &&str)| {
        let unit = words.get(index + 1).map_or("", |unit| unit.trim_end_matches([',', ';', '?', ')', ':']));
        Some((number(word)?, unit.to_owned()))
    };
    words.iter().enumerate().filter_map(at).collect()
}

#[test]
fn a_remedy_cures() {
    let (mut wrong, rows) = (String::new(), rows());
    for Row { code, model, given, remedy } in &rows {
        let before = text(model, given);
        let Some(advice) = help(&before, code) else {
            let found = check_text("model.cx", &before).diagnostics;
            let found: Vec<String> = found.iter().map(|d| format!("{}: {}", d.code, d.message)).collect();
            let _ = writeln!(wrong, "{code} is not found of {given:?}, but {found:?}");
            continue;
        };
        let numbers = quantities(&advice);
        let mut given = given.clone();
        for step in remedy {
            let (Set(name, index) | Add(name, index)) = step;
            let Some((number, unit)) = numbers.get(*index) else {
                let _ = writeln!(wrong, "{code}: there is no number {index} in \"{advice}\"");
                continue;
            };
            let (_, value, own) = given.iter_mut().find(|(known, ..)| known == name).expect("a quantity");
            *value = if matches!(step, Add(..)) { *value + number } else { *number };
            if unit == "GPa" {
                *own = "GPa";
            }
        }
        if let Some(again) = help(&text(model, &given), code) {
            let _ = writeln!(wrong, "{code}: \"{advice}\" leads to {given:?}, and again \"{again}\"");
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(rows.len() > 30, "{} rows", rows.len());
}

/// The template that `calyx new --template bodies` creates.
const TEMPLATE: &str = include_str!("../templates/bodies.cx");

/// Warnings, largest contact pressure and its estimated error (Pa) of the template with a param
/// and further arguments of its mesh.
fn solved((param, value): (&str, f64), arguments: &str) -> (BTreeSet<String>, f64, f64) {
    let text = TEMPLATE.replace("gears.mesh(pinion, gear)", &format!("gears.mesh(pinion, gear{arguments})"));
    let mut model = Module::from_text(&Engine::default(), "model.cx", &text).expect("a model").instantiate();
    model.set(param, value).expect("a param");
    model.set("steps", 8.0).expect("a param");
    let results = model.solve().expect("results");
    let rows = &results.analysis().expect("an analysis").rows;
    let warnings = rows.iter().flat_map(|row| row.warnings.clone()).collect();
    let pressure = results.summary_si("contact_pressure").expect("an output");
    (warnings, pressure.max, pressure.error.as_ref().expect("an estimate").total.max)
}

#[test]
fn an_advised_grid_width_suits_all_patches() {
    let cases = [("tip_relief", 0.0), ("torque", 200.0)];
    for case in cases {
        let (warnings, pressure, error) = solved(case, "");
        assert_eq!(warnings, BTreeSet::new(), "{case:?}: the automatic widths suit");
        let mut followed = BTreeSet::new();
        for width in [0.02, 0.2, 8.0] {
            let (warnings, ..) = solved(case, &format!(", grid_width = {width} mm"));
            assert!(!warnings.is_empty(), "{case:?}: a width of {width} mm is reported");
            for warning in warnings {
                let (_, advised) = warning.split_once("`grid_width = ").expect("a width");
                let (advised, _) = advised.split_once('`').expect("a width");
                if !followed.insert(advised.to_owned()) {
                    continue;
                }
                let (again, cured, cured_error) = solved(case, &format!(", grid_width = {advised}"));
                assert_eq!(again, BTreeSet::new(), "{case:?}: {warning}");
                let difference = (cured - pressure).abs();
                assert!(
                    difference <= error + cured_error,
                    "{case:?}: {warning}: {cured} instead of {pressure} Pa"
                );
            }
        }
    }
}
