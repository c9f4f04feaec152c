//! All numbers of `data/gear_geometry.json`: closed-form geometry of an external, a shifted and an
//! internal pair, computed independently of this code to at least twelve digits.

use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::internal::{InternalGear, InternalGearData};
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use serde_json::Value;

/// Compares values with the members of a JSON object and counts them.
struct Comparison<'a> {
    name: String,
    object: &'a Value,
    compared: usize,
}

impl Comparison<'_> {
    fn close(&mut self, key: &str, value: f64) {
        self.equal(key, &self.object[key].clone(), value);
    }

    fn equal(&mut self, key: &str, expected: &Value, value: f64) {
        let expected = expected.as_f64().unwrap_or_else(|| panic!("{} has no number {key}", self.name));
        let scale = expected.abs().max(1e-3);
        assert!((value - expected).abs() < 1e-12 * scale, "{} {key}: {value} is not {expected}", self.name);
        self.compared += 1;
    }
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("no number {key}"))
}

fn external(object: &Value) -> ExternalGear {
    let teeth = number(object, "N");
    let module = 2.0 * number(object, "rp") / teeth;
    ExternalGear::new(ExternalGearData {
        teeth: teeth as u32,
        rack: Rack::new(module, 20.0_f64.to_radians(), number(object, "rack_tip_radius"))
            .expect("a valid rack"),
        tooth_thickness: number(object, "pitch_thickness"),
        outer_radius: number(object, "ra"),
        root_radius: number(object, "root_r"),
        tip_edge_radius: None,
    })
    .expect("a valid gear")
}

fn compare_external(name: &str, object: &Value) -> (ExternalGear, usize) {
    let gear = external(object);
    let mut with = Comparison { name: name.to_owned(), object, compared: 0 };
    with.close("rp", gear.pitch_radius);
    with.close("rb", gear.base_radius);
    with.close("base_pitch", gear.base_pitch);
    with.close("tip_thickness", gear.tip_thickness());
    with.close("roll_tip_deg", gear.tip_roll.to_degrees());
    with.close("form_r", gear.form_radius);
    with.close("form_roll_deg", gear.form_roll.to_degrees());
    with.close("rack_tip_centre_halfwidth", gear.rack_tip_centre_halfwidth);
    with.close("root_fillet_curvature_radius", gear.root_fillet_curvature_radius());
    assert_eq!(Some(gear.undercut), object["undercut"].as_bool(), "{name}");
    for row in object["thickness_at_r"].as_array().expect("rows") {
        let radius = row[0].as_f64().expect("a radius");
        with.equal("thickness", &row[1], gear.thickness_at(radius));
        with.equal("roll", &row[2], gear.roll_at_radius(radius).to_degrees());
    }
    if !object["pin"].is_null() {
        let pin = number(object, "pin");
        with.close("pin_centre_r", gear.pin_centre_radius(pin, 0.0));
        with.close("over_pins", gear.over_pins(pin, 0.0));
    }
    (gear, with.compared)
}

fn compare_mesh(name: &str, object: &Value, mesh: &MeshGeometry) -> usize {
    let mut with = Comparison { name: format!("{name} mesh"), object, compared: 0 };
    with.close("operating_pressure_angle_deg", mesh.operating_pressure_angle.to_degrees());
    with.close("line_of_action_length", mesh.line_of_action_length);
    with.close("contact_ratio", mesh.contact_ratio);
    for (point, roll) in ["SAP", "LPSTC", "pitch", "HPSTC", "EAP"].iter().zip(mesh.first_roll.points()) {
        with.equal(point, &object["roll1_deg"][point], roll.to_degrees());
        if !object["r1"][point].is_null() {
            with.equal(point, &object["r1"][point], mesh.first_radius(roll));
        }
    }
    with.compared
}

#[test]
fn all_pairs_agree_with_the_closed_forms() {
    let text = include_str!("data/gear_geometry.json");
    let data: Value = serde_json::from_str(text).expect("valid JSON");
    let pairs = &data["pairs"];
    let mut compared = 0;

    for name in ["ch5", "shifted_17_42_m3"] {
        let pair = &pairs[name];
        let (first, count) = compare_external(&format!("{name} g1"), &pair["g1"]);
        let (second, more) = compare_external(&format!("{name} g2"), &pair["g2"]);
        let center_distance = number(&pair["mesh"], "C");
        let mesh = MeshGeometry::external(&first, &second, center_distance).expect("a mesh");
        compared += count + more + compare_mesh(name, &pair["mesh"], &mesh);
        if !pair["x1"].is_null() {
            let mut with = Comparison { name: name.to_owned(), object: pair, compared: 0 };
            with.close("x1", first.profile_shift());
            with.close("x2", second.profile_shift());
            with.close("zero_backlash_C", mesh.zero_backlash_center_distance.expect("a distance"));
            assert!(mesh.backlash.abs() < 1e-12, "{}", mesh.backlash);
            compared += with.compared;
        }
        let back = mesh.second_roll(mesh.first_roll.start_of_active_profile);
        assert!((back - second.tip_roll).abs() < 1e-14);
    }

    let pair = &pairs["internal_20_60_m4"];
    let (pinion, count) = compare_external("internal g1", &pair["g1"]);
    let ring = &pair["g2"];
    // The reference does not specify root and cutter, and none of its numbers depends on them.
    let shaper = Shaper::new(20, 4.0, 20.0_f64.to_radians(), 5.0, 1.0).expect("a shaper");
    let gear = InternalGear::new(InternalGearData {
        teeth: 60,
        shaper,
        tooth_thickness: pair["g2"]["thickness_at_r"][0][1].as_f64().expect("a thickness"),
        minor_radius: number(ring, "minor_r"),
        root_radius: 125.0,
        tip_edge_radius: None,
    })
    .expect("a valid gear");
    let mut with = Comparison { name: "internal g2".to_owned(), object: ring, compared: 0 };
    with.close("rp", gear.pitch_radius);
    with.close("rb", gear.base_radius);
    with.close("tip_thickness", gear.thickness_at(gear.minor_radius));
    for row in ring["thickness_at_r"].as_array().expect("rows") {
        with.equal("thickness", &row[1], gear.thickness_at(row[0].as_f64().expect("a radius")));
    }
    with.close("between_pins", gear.between_pins(number(ring, "pin"), 0.0));
    let mesh = MeshGeometry::internal(&pinion, &gear, number(&pair["mesh"], "C")).expect("a mesh");
    // Two teeth with a thickness of half a pitch each at the standard distance: no backlash.
    assert!(mesh.backlash.abs() < 1e-12, "{}", mesh.backlash);
    compared += count + with.compared + compare_mesh("internal", &pair["mesh"], &mesh);
    assert_eq!(compared, 126, "every number was compared");
}
