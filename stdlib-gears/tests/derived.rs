//! Derived quantities of gears and meshes, compared with the published geometry, closed forms, and
//! the gears themselves.

use calyx_gears::blank::Rim;
use calyx_gears::derived_quantities::{Quantity, of_gear, of_mesh};
use calyx_gears::external::{ExternalGear, ExternalGearData};
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::material::Material;
use calyx_runtime::structure::BoreSupport;
use serde_json::Value;

const ALPHA: f64 = 20.0 * std::f64::consts::PI / 180.0;

fn prototype(data: ExternalGearData, modifications: Vec<Modification>) -> GearPrototype {
    let gear = ExternalGear::new(data).expect("a sound gear");
    let rim = Rim {
        radius: 0.9 * gear.root_radius,
        fixed_radius: 0.5 * gear.root_radius,
        web: None,
        support: BoreSupport::Rigid,
    };
    let steel = Material { youngs_modulus: 2.06e11, poissons_ratio: 0.3, density: 7850.0 };
    GearPrototype::new(gear, modifications, steel, rim, 0.01, Vec::new()).expect("a sound gear")
}

/// Gear data with addendum 1, dedendum 1.25 and tip radius 0.38 modules.
fn standard(teeth: u32, module: f64, shift: f64) -> ExternalGearData {
    let rack = Rack::new(module, ALPHA, 0.38 * module).expect("a sound rack");
    let pitch_radius = 0.5 * f64::from(teeth) * module;
    ExternalGearData {
        teeth,
        rack,
        tooth_thickness: rack.thickness_of_shift(shift),
        outer_radius: pitch_radius + (1.0 + shift) * module,
        root_radius: pitch_radius - (1.25 - shift) * module,
        tip_edge_radius: None,
    }
}

fn find<'q>(quantities: &'q [Quantity], symbol: &str, member: Option<usize>) -> &'q Quantity {
    let wanted = |quantity: &&Quantity| quantity.symbol == symbol && quantity.member == member;
    quantities.iter().find(wanted).unwrap_or_else(|| panic!("no {symbol} in {quantities:#?}"))
}

fn close(value: f64, expected: f64, what: &str) {
    assert!(
        (value - expected).abs() <= 1e-12 * expected.abs().max(1e-3),
        "{what}: {value} is not {expected}"
    );
}

fn number(object: &Value, key: &str) -> f64 {
    object[key].as_f64().unwrap_or_else(|| panic!("no number {key}"))
}

/// Gear of the reference data, in its unit of length.
fn published(object: &Value) -> GearPrototype {
    let teeth = number(object, "N");
    let data = ExternalGearData {
        teeth: teeth as u32,
        rack: Rack::new(2.0 * number(object, "rp") / teeth, ALPHA, number(object, "rack_tip_radius"))
            .expect("a sound rack"),
        tooth_thickness: number(object, "pitch_thickness"),
        outer_radius: number(object, "ra"),
        root_radius: number(object, "root_r"),
        tip_edge_radius: None,
    };
    prototype(data, Vec::new())
}

#[test]
fn published_pairs_are_told_as_published() {
    let data: Value = serde_json::from_str(include_str!("data/gear_geometry.json")).expect("valid JSON");
    for name in ["ch5", "shifted_17_42_m3"] {
        let pair = &data["pairs"][name];
        let gears = ["g1", "g2"].map(|gear| published(&pair[gear]));
        for (gear, key) in gears.iter().zip(["g1", "g2"]) {
            let (quantities, object) = (of_gear(gear), &pair[key]);
            let value = |symbol: &str| find(&quantities, symbol, None).value;
            for (symbol, key) in
                [("d", "rp"), ("d_b", "rb"), ("d_a", "ra"), ("d_f", "root_r"), ("d_Ff", "form_r")]
            {
                close(value(symbol), 2.0 * number(object, key), symbol);
            }
            let fillet = "root_fillet_curvature_radius";
            for (symbol, key) in
                [("s_a", "tip_thickness"), ("p_b", "base_pitch"), ("rho_f", fillet), ("z", "N")]
            {
                close(value(symbol), number(object, key), symbol);
            }
            for (symbol, key) in [("xi_a", "roll_tip_deg"), ("xi_Ff", "form_roll_deg")] {
                close(value(symbol).to_degrees(), number(object, key), symbol);
            }
            let standard_pin = (number(object, "pin") - 1.728 * value("m_t")).abs() < 1e-12;
            if standard_pin {
                close(value("M_d"), number(object, "over_pins"), "M_d");
            }
            assert_eq!(standard_pin, name == "ch5");
        }
        let object = &pair["mesh"];
        let [first, second] = [0, 1].map(|member: usize| gears[member].gear.external().expect("external"));
        let mesh = MeshGeometry::external(first, second, number(object, "C")).expect("a mesh");
        let quantities = of_mesh([first.into(), second.into()], &mesh);
        let value = |symbol: &str| find(&quantities, symbol, None).value;
        close(value("a"), number(object, "C"), "a");
        close(value("alpha_wt").to_degrees(), number(object, "operating_pressure_angle_deg"), "alpha_wt");
        close(value("epsilon_alpha"), number(object, "contact_ratio"), "epsilon_alpha");
        close(value("g_alpha"), number(object, "line_of_action_length"), "g_alpha");
        for (symbol, point) in [("d_Nf", "SAP"), ("d_LPSTC", "LPSTC"), ("d_HPSTC", "HPSTC")] {
            let diameter = find(&quantities, symbol, Some(0)).value;
            let roll = object["roll1_deg"][point].as_f64().expect("a roll angle");
            close(first.roll_at_radius(0.5 * diameter).to_degrees(), roll, symbol);
            if let Some(radius) = object["r1"][point].as_f64() {
                close(diameter, 2.0 * radius, symbol);
            }
        }
        if name == "shifted_17_42_m3" {
            close(find(&of_gear(&gears[0]), "x", None).value, number(pair, "x1"), "x1");
            close(value("a_min"), number(pair, "zero_backlash_C"), "a_min");
        }
    }
}

#[test]
fn points_of_both_members_are_the_same_contacts() {
    let [first, second] = [20, 33].map(|teeth| ExternalGear::new(standard(teeth, 2.0, 0.0)).expect("sound"));
    let mesh = MeshGeometry::external(&first, &second, 53.0).expect("a mesh");
    let quantities = of_mesh([(&first).into(), (&second).into()], &mesh);
    let swapped = MeshGeometry::external(&second, &first, 53.0).expect("a mesh");
    let told_swapped = of_mesh([(&second).into(), (&first).into()], &swapped);
    for symbol in ["d_w", "c", "d_Nf", "c_F", "d_LPSTC", "d_HPSTC"] {
        for member in [0, 1] {
            let seen = find(&quantities, symbol, Some(member)).value;
            close(find(&told_swapped, symbol, Some(1 - member)).value, seen, symbol);
        }
    }
    close(find(&quantities, "d_w", Some(0)).value, 40.0, "operating is reference at the standard distance");
    close(find(&quantities, "c", Some(1)).value, 0.5, "a quarter of a module");
}

#[test]
fn where_two_pairs_always_touch_there_is_no_single_tooth_contact() {
    let high = |teeth: u32| {
        let data = standard(teeth, 1.0, 0.0);
        let rack = Rack::new(1.0, 17.0_f64.to_radians(), 0.2).expect("a sound rack");
        let (outer_radius, root_radius) = (data.outer_radius + 0.35, data.root_radius - 0.35);
        ExternalGear::new(ExternalGearData { rack, outer_radius, root_radius, ..data }).expect("sound")
    };
    let (first, second) = (high(60), high(70));
    let mesh = MeshGeometry::external(&first, &second, 65.0).expect("a mesh");
    assert!(mesh.contact_ratio > 2.0, "{}", mesh.contact_ratio);
    assert!(
        of_mesh([(&first).into(), (&second).into()], &mesh)
            .iter()
            .all(|quantity| quantity.symbol != "d_LPSTC")
    );
}

#[test]
fn spans_are_those_of_the_tables() {
    // W_k / m of gears without profile shift and with a pressure angle of 20 degrees.
    for (teeth, over, span) in [(20, 3, 7.6604), (40, 5, 13.8448), (17, 2, 4.6663), (100, 12, 35.3501)] {
        let quantities = of_gear(&prototype(standard(teeth, 1.0, 0.0), Vec::new()));
        let quantities = find(&quantities, "W_k", None);
        assert!((quantities.value - span).abs() < 5e-5, "{teeth}: {}", quantities.value);
        assert_eq!(quantities.note, format!("over {over} teeth"));
    }
}

#[test]
fn the_margin_of_undercut_is_the_shift_that_reaches_it() {
    for teeth in [8, 12, 17, 18, 40] {
        let margin = prototype(standard(teeth, 2.0, 0.2), Vec::new())
            .gear
            .external()
            .expect("external")
            .undercut_margin();
        let undercut = |shift| ExternalGear::new(standard(teeth, 2.0, shift)).map(|gear| gear.undercut);
        let limit = 0.2 - margin;
        if limit > -0.5 {
            assert_eq!([undercut(limit + 1e-3), undercut(limit - 1e-3)], [Ok(false), Ok(true)], "{teeth}");
        }
    }
    let quantities = of_gear(&prototype(standard(12, 2.0, 0.0), Vec::new()));
    assert!(find(&quantities, "x - x_min", None).note.starts_with("undercut"));
    // Full depth of one module is reached by the straight flank: 2 / sin^2.
    let quantities = of_gear(&prototype(standard(20, 2.0, 0.0), Vec::new()));
    let straight = 1.25 - 0.38 + 0.38 * ALPHA.sin();
    close(find(&quantities, "z_min", None).value, 2.0 * straight / ALPHA.sin().powi(2), "z_min");
}

#[test]
fn a_relief_is_told_by_the_diameter_where_it_begins() {
    let relief = Modification::tip_relief(2e-5, 0.45, ReliefShape::Linear);
    let gear = prototype(standard(25, 3e-3, 0.0), vec![relief]);
    let quantities = of_gear(&gear);
    close(find(&quantities, "d_Ca", None).value, 2.0 * gear.form().base_radius * 0.45_f64.hypot(1.0), "d_Ca");
}

/// A tip edge of a drawing ends the involute, and the path of contact. The default edge belongs to
/// the contact analysis.
#[test]
fn only_stated_tip_edges_end_the_involute() {
    let data = standard(25, 3e-3, 0.0);
    let default = prototype(data, Vec::new());
    let quantities = of_gear(&default);
    assert_eq!(find(&quantities, "d_Fa", None).value, find(&quantities, "d_a", None).value);
    let rounded = prototype(ExternalGearData { tip_edge_radius: Some(0.3e-3), ..data }, Vec::new());
    let form = rounded.form();
    let [flank, _] = rounded.flanks();
    close(form.tip_form_roll, flank.edge_roll(), "the beginning of the edge");
    let quantities = of_gear(&rounded);
    close(find(&quantities, "d_Fa", None).value, 2.0 * form.radius_at_roll(flank.edge_roll()), "d_Fa");
    let gear = |prototype: &GearPrototype| prototype.gear.external().expect("external").clone();
    let mesh = MeshGeometry::external(&gear(&rounded), &gear(&default), 75e-3).expect("a mesh");
    close(mesh.first_roll.end_of_active_profile, flank.edge_roll(), "the end of contact");
    let sharp = MeshGeometry::external(&gear(&default), &gear(&default), 75e-3).expect("a mesh");
    let shorter = form.base_radius * (form.tip_roll - form.tip_form_roll);
    close(sharp.line_of_action_length - mesh.line_of_action_length, shorter, "g_alpha");
}
