//! Compares the library module `iso21771` with published data blocks and closed-form geometry.
//!
//! `blocks.cx` and `internal.cx` compute the published quantities and print one row for each:
//! block, quantity and value. Sources of the numbers: `gear_data_blocks.json` names them; those in
//! `internal.cx` are from the KISSsoft 03/2017 reports of the NREL 5 MW gearbox (public repository
//! gfsReboucas/Drivetrain, `stage_01.rtf` and `stage_02.rtf`).

use calyx_tests::printed::printed_lines;
use calyx_tests::root;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Runs a model and returns the values that it prints, by block and quantity.
fn printed(name: &str, text: &str) -> BTreeMap<(String, String), f64> {
    let row = |line: &String| {
        let [block, quantity, value] = line.split('|').collect::<Vec<_>>()[..] else {
            panic!("not a row: {line}")
        };
        let value = value.parse().unwrap_or_else(|_| panic!("not a number: {line}"));
        ((block.to_owned(), quantity.to_owned()), value)
    };
    printed_lines(name, text).iter().map(row).collect()
}

fn data(name: &str) -> Value {
    let path = root().join("stdlib-gears/tests/data").join(name);
    serde_json::from_str(&std::fs::read_to_string(path).expect("the data")).expect("JSON")
}

fn model(name: &str) -> String {
    std::fs::read_to_string(root().join("tests/gear_data").join(name)).expect("the model")
}

/// Half a unit of the last printed digit, with a margin for the rounding of the printing program.
fn last_digit(printed: &str) -> f64 {
    let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    0.5001 * 10.0_f64.powi(-i32::try_from(decimals).expect("few digits"))
}

/// Compares two results of different programs, with 14 digits in the data.
fn close(value: f64, expected: f64) -> bool {
    (value - expected).abs() < 1e-12 * expected.abs().max(1e-3)
}

#[test]
fn data_blocks_have_their_published_digits() {
    let values = printed("blocks.cx", &model("blocks.cx"));
    let data = data("gear_data_blocks.json");
    let mut compared = 0;
    for row in data["comparisons"].as_array().expect("rows") {
        let text = |key: &str| row[key].as_str().expect("text").to_owned();
        let key = (text("block"), text("quantity"));
        let value = *values.get(&key).unwrap_or_else(|| panic!("no value of {key:?}"));
        let computed: f64 = text("own").parse().expect("a number");
        assert!(close(value, computed), "{key:?}: {value} is not {computed}");
        // The formulas of the standard do not reproduce every published digit.
        if row["within_last_digit"] == true {
            let published = text("published");
            let expected: f64 = published.parse().expect("a number");
            assert!(
                (value - expected).abs() <= last_digit(&published),
                "{key:?}: {value} is not {published}"
            );
        }
        compared += 1;
    }
    assert_eq!(compared, 169);
    for (block, quantities) in data["computed_14_digits"].as_object().expect("blocks") {
        for (quantity, expected) in quantities.as_object().expect("quantities") {
            let Some(value) = values.get(&(block.clone(), quantity.clone())) else { continue };
            let expected: f64 = expected
                .as_str()
                .map_or_else(|| expected.to_string(), str::to_owned)
                .parse()
                .expect("a number");
            assert!(close(*value, expected), "{block} {quantity}: {value} is not {expected}");
            compared += 1;
        }
    }
    assert_eq!(compared, 169 + 146);
}

/// Comments of `internal.cx` state the published digits.
#[test]
fn internal_gears_have_their_published_digits() {
    let text = model("internal.cx");
    let published: BTreeMap<(String, String), &str> = text
        .lines()
        .filter_map(|line| line.trim().strip_prefix("// published "))
        .map(|line| {
            let [block, quantity, value] = line.split('|').collect::<Vec<_>>()[..] else {
                panic!("not a row: {line}")
            };
            ((block.to_owned(), quantity.to_owned()), value)
        })
        .collect();
    let values = printed("internal.cx", &text);
    for (key, digits) in &published {
        let value = values.get(key).unwrap_or_else(|| panic!("no value of {key:?}"));
        let expected: f64 = digits.parse().expect("a number");
        assert!((value - expected).abs() <= last_digit(digits), "{key:?}: {value} is not {digits}");
    }
    assert_eq!(values.len(), published.len());
}

/// A model that prints the quantities of `gear_geometry.json`, and their expected values.
#[derive(Default)]
struct Geometry {
    text: String,
    expected: BTreeMap<(String, String), f64>,
}

impl Geometry {
    fn row(&mut self, block: &str, quantity: &str, expression: &str, expected: &Value) {
        let expected = expected.as_f64().unwrap_or_else(|| panic!("{block} has no {quantity}"));
        writeln!(self.text, "print(\"{block}|{quantity}|{{{expression}}}\");").unwrap();
        self.expected.insert((block.to_owned(), quantity.to_owned()), expected);
    }

    /// The same quantity if the data have it.
    fn optional(&mut self, block: &str, quantity: &str, expression: &str, expected: &Value) {
        if !expected.is_null() {
            self.row(block, quantity, expression, expected);
        }
    }

    /// Adds a gear, in millimetres whatever the unit of its data, and its quantities.
    fn gear(&mut self, variable: &str, gear: &Value) {
        let number = |key: &str| gear[key].as_f64().unwrap_or_else(|| panic!("no {key}"));
        let module = 2.0 * number("rp") / number("N");
        let rows = gear["thickness_at_r"].as_array().expect("rows");
        let internal = !gear["minor_r"].is_null();
        let thickness = gear["pitch_thickness"].as_f64().or(rows[0][1].as_f64()).expect("a thickness");
        write!(
            self.text,
            "var {variable} = iso21771.gear_data({}, 1 mm, normal_module = {module:?} mm, \
             transverse_thickness = {thickness:?} mm, ",
            number("N")
        )
        .unwrap();
        if internal {
            writeln!(self.text, "internal = TRUE, tip_diameter = 2 * {:?} mm);", number("minor_r")).unwrap();
        } else {
            // The rack of a stated root radius.
            let tangent = 20.0_f64.to_radians().tan();
            let shift = (thickness / module - std::f64::consts::FRAC_PI_2) / (2.0 * tangent);
            let dedendum = (number("rp") - number("root_r")) / module + shift;
            let radius = number("rack_tip_radius") / module;
            writeln!(
                self.text,
                "tip_diameter = 2 * {:?} mm, \
                 rack = iso21771.BasicRack(\"\", dedendum = {dedendum:?}, fillet_radius = {radius:?}));",
                number("ra")
            )
            .unwrap();
        }
        let length = |function: &str| format!("iso21771.{function}({variable}) / 1 mm");
        let radius = |function: &str| format!("iso21771.{function}({variable}) / 2 / 1 mm");
        self.row(variable, "rp", &radius("reference_diameter"), &gear["rp"]);
        self.row(variable, "rb", &radius("base_diameter"), &gear["rb"]);
        self.row(variable, "tip_thickness", &length("tip_thickness"), &gear["tip_thickness"]);
        self.optional(variable, "base_pitch", &length("transverse_base_pitch"), &gear["base_pitch"]);
        self.optional(variable, "form_r", &radius("root_form_diameter"), &gear["form_r"]);
        self.optional(variable, "root_r", &radius("root_diameter"), &gear["root_r"]);
        let roll = |diameter: &str| format!("iso21771.roll_angle_at({variable}, {diameter}) / 1 deg");
        let tip = roll(&format!("iso21771.tip_diameter({variable})"));
        self.optional(variable, "roll_tip_deg", &tip, &gear["roll_tip_deg"]);
        let form = roll(&format!("iso21771.root_form_diameter({variable})"));
        self.optional(variable, "form_roll_deg", &form, &gear["form_roll_deg"]);
        for (index, row) in rows.iter().enumerate() {
            let diameter = format!("2 * {:?} mm", row[0].as_f64().expect("a radius"));
            let thickness = format!("iso21771.transverse_thickness_at({variable}, {diameter}) / 1 mm");
            self.row(variable, &format!("thickness {index}"), &thickness, &row[1]);
            self.optional(variable, &format!("roll {index}"), &roll(&diameter), &row[2]);
        }
        if let Some(pin) = gear["pin"].as_f64() {
            let measured = |function: &str| format!("iso21771.{function}({variable}, {pin:?} mm) / 1 mm");
            let expected = if internal { &gear["between_pins"] } else { &gear["over_pins"] };
            self.row(variable, "over_pins", &measured("dimension_over_pins"), expected);
            let center = format!("{} / 2", measured("ball_center_diameter"));
            self.optional(variable, "pin_centre_r", &center, &gear["pin_centre_r"]);
        }
    }

    /// Adds a pair of two gears and its quantities.
    fn mesh(&mut self, name: &str, pair: &Value) {
        let mesh = &pair["mesh"];
        let distance = mesh["C"].as_f64().map_or(String::new(), |distance| format!(", {distance:?} mm"));
        let block = format!("{name}_pair");
        writeln!(self.text, "var {block} = iso21771.pair_data({name}_g1, {name}_g2{distance});").unwrap();
        let zero = format!("iso21771.center_distance_of_shifts({name}_g1, {name}_g2) / 1 mm");
        self.optional(&block, "zero_backlash_C", &zero, &pair["zero_backlash_C"]);
        let angle = format!("iso21771.working_pressure_angle({block}) / 1 deg");
        self.row(&block, "pressure angle", &angle, &mesh["operating_pressure_angle_deg"]);
        let length = format!("iso21771.path_length({block}) / 1 mm");
        self.row(&block, "length", &length, &mesh["line_of_action_length"]);
        let ratio = format!("iso21771.transverse_contact_ratio({block})");
        self.row(&block, "contact ratio", &ratio, &mesh["contact_ratio"]);
        for (key, point) in [("SAP", "A"), ("LPSTC", "B"), ("pitch", "C"), ("HPSTC", "D"), ("EAP", "E")] {
            let roll = format!(
                "iso21771.path_roll_angle({block}, iso21771.PathPoint.{point}, iso21771.Member.first) / 1 deg"
            );
            self.row(&block, &format!("roll {key}"), &roll, &mesh["roll1_deg"][key]);
            let diameter = format!(
                "iso21771.path_diameter({block}, iso21771.PathPoint.{point}, iso21771.Member.first) / 2 / 1 mm"
            );
            self.optional(&block, &format!("radius {key}"), &diameter, &mesh["r1"][key]);
        }
    }
}

#[test]
fn closed_form_geometry_is_reproduced() {
    let data = data("gear_geometry.json");
    let mut geometry = Geometry { text: "import iso21771;\nunits mm_N_s;\n".into(), ..Geometry::default() };
    for (name, pair) in data["pairs"].as_object().expect("pairs") {
        geometry.gear(&format!("{name}_g1"), &pair["g1"]);
        geometry.gear(&format!("{name}_g2"), &pair["g2"]);
        geometry.mesh(name, pair);
    }
    let values = printed("geometry.cx", &geometry.text);
    assert_eq!(values.len(), geometry.expected.len());
    for (key, expected) in &geometry.expected {
        assert!(close(values[key], *expected), "{key:?}: {} is not {expected}", values[key]);
    }
    assert!(values.len() >= 119, "{}", values.len());
}
