//! Compares the quantities that the gear library derives for analyses and hover texts with those of
//! the module `iso21771`: a spur pair and a helical pair, both with profile shift.

use calyx_gears::blank::{GearBlank, Thickness};
use calyx_gears::derived_quantities::{Quantity, of_gear, of_mesh};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::mesh_geometry::{HelicalTeeth, MeshGeometry};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::{Plane, Rack};
use calyx_tests::printed::printed_numbers;
use std::fmt::Write;
use std::sync::Arc;

const MODULE: f64 = 3e-3;
const FACE_WIDTH: f64 = 32e-3;
const TEETH: [u32; 2] = [19, 47];
const SHIFTS: [f64; 2] = [0.25, -0.1];
/// Largest relative difference.
const ROUNDING: f64 = 1e-12;

/// Quantities of a gear by their symbols, and the expressions with the gear `g` of the module.
const OF_GEAR: &[(&str, &str)] = &[
    ("z", "g.teeth"),
    ("m_t", "geo.transverse_module(g) / (1 m)"),
    ("alpha_t", "geo.transverse_pressure_angle(g) / (1 rad)"),
    ("d", "geo.reference_diameter(g) / (1 m)"),
    ("d_b", "geo.base_diameter(g) / (1 m)"),
    ("d_a", "geo.tip_diameter(g) / (1 m)"),
    ("d_f", "geo.root_diameter(g) / (1 m)"),
    ("d_Ff", "geo.root_form_diameter(g) / (1 m)"),
    ("xi_Ff", "geo.roll_angle_at(g, geo.root_form_diameter(g)) / (1 rad)"),
    ("xi_a", "geo.roll_angle_at(g, geo.tip_diameter(g)) / (1 rad)"),
    ("p_b", "geo.transverse_base_pitch(g) / (1 m)"),
    ("s_t", "geo.transverse_thickness(g) / (1 m)"),
    ("s_a", "geo.transverse_thickness_at(g, geo.tip_diameter(g)) / (1 m)"),
    ("h", "geo.tooth_depth(g) / (1 m)"),
    ("x", "g.profile_shift"),
    ("M_d", "geo.dimension_over_balls(g, 1.728 * g.normal_module) / (1 m)"),
];

/// Further quantities of a helical gear.
const OF_HELIX: &[(&str, &str)] = &[
    ("beta", "g.helix_angle / (1 rad)"),
    ("beta_b", "geo.base_helix_angle(g) / (1 rad)"),
    ("m_n", "g.normal_module / (1 m)"),
    ("s_n", "geo.normal_thickness(g) / (1 m)"),
];

/// Quantities of a pair, with the pair `p` of the module.
const OF_MESH: &[(&str, Option<usize>, &str)] = &[
    ("a", None, "p.center_distance / (1 m)"),
    ("a_d", None, "geo.reference_center_distance(p.first, p.second) / (1 m)"),
    ("alpha_wt", None, "geo.working_pressure_angle(p) / (1 rad)"),
    ("epsilon_alpha", None, "geo.transverse_contact_ratio(p)"),
    ("g_alpha", None, "geo.path_length(p) / (1 m)"),
    ("u", None, "geo.gear_ratio(p)"),
    ("j_wt", None, "geo.circumferential_backlash(p) / (1 m)"),
    ("j_bn", None, "geo.normal_backlash(p) / (1 m)"),
    ("d_w", Some(0), "geo.working_diameter(p, \"first\") / (1 m)"),
    ("d_w", Some(1), "geo.working_diameter(p, \"second\") / (1 m)"),
    ("c", Some(0), "geo.tip_clearance(p, \"second\") / (1 m)"),
    ("c", Some(1), "geo.tip_clearance(p, \"first\") / (1 m)"),
    ("d_Nf", Some(0), "geo.path_diameter(p, \"A\", \"first\") / (1 m)"),
    ("d_Nf", Some(1), "geo.path_diameter(p, \"E\", \"second\") / (1 m)"),
];

/// Points of single-tooth contact, which a pair has at a total contact ratio below two.
const OF_SINGLE_CONTACT: &[(&str, Option<usize>, &str)] = &[
    ("d_LPSTC", Some(0), "geo.path_diameter(p, \"B\", \"first\") / (1 m)"),
    ("d_HPSTC", Some(0), "geo.path_diameter(p, \"D\", \"first\") / (1 m)"),
    ("d_LPSTC", Some(1), "geo.path_diameter(p, \"D\", \"second\") / (1 m)"),
    ("d_HPSTC", Some(1), "geo.path_diameter(p, \"B\", \"second\") / (1 m)"),
];

/// Further quantities of a helical pair.
const OF_HELICAL_MESH: &[(&str, Option<usize>, &str)] =
    &[("epsilon_beta", None, "geo.overlap_ratio(p)"), ("epsilon_gamma", None, "geo.total_contact_ratio(p)")];

fn gear(member: usize, helix_angle: f64) -> Arc<GearPrototype> {
    let (teeth, shift) = (TEETH[member], SHIFTS[member]);
    let hand = [Hand::Right, Hand::Left][member];
    let rack = Rack::new(MODULE, 20.0_f64.to_radians(), 0.38 * MODULE).expect("a rack");
    let diameter = f64::from(teeth) * MODULE / helix_angle.cos();
    let mut blank = GearBlank::standard(teeth, rack.in_plane(Plane::Normal))
        .diameters(diameter + 2.0 * (1.0 + shift) * MODULE, diameter - 2.0 * (1.25 - shift) * MODULE)
        .thickness(Thickness::ProfileShift(shift))
        .face_width(FACE_WIDTH);
    blank.helix = Helix::new(helix_angle, hand).expect("a helix");
    blank.cut().expect("a gear")
}

/// Numbers that expressions of the module have, for the pair `p` and the gears `first` and
/// `second`.
fn evaluated(helix_degrees: f64, center_distance: f64, expressions: &[String]) -> Vec<f64> {
    let mut text = String::from("import iso21771 as geo;\nunits SI;\n");
    for (member, name) in ["first", "second"].into_iter().enumerate() {
        writeln!(
            text,
            "var {name} = geo.gear_data({}, {FACE_WIDTH} m, normal_module = {MODULE} m, helix_angle = \
             {helix_degrees} deg, hand = \"{}\", profile_shift = {});",
            TEETH[member],
            ["right", "left"][member],
            SHIFTS[member],
        )
        .expect("text grows");
    }
    writeln!(text, "var p = geo.pair_data(first, second, {center_distance} m);").expect("text grows");
    for expression in expressions {
        writeln!(text, "print({expression});").expect("text grows");
    }
    printed_numbers("pair.cx", &text)
}

fn value(quantities: &[Quantity], symbol: &str, member: Option<usize>) -> f64 {
    let found = quantities.iter().find(|one| one.symbol == symbol && one.member == member);
    found.unwrap_or_else(|| panic!("no quantity {symbol}")).value
}

#[test]
fn derived_quantities_agree_with_the_module_of_gear_data() {
    for (helix_degrees, center_distance) in [(0.0, 99.6e-3), (14.0, 102.6e-3)] {
        let helix_angle = f64::to_radians(helix_degrees);
        let gears = [0, 1].map(|member| gear(member, helix_angle));
        let [first, second] = gears.each_ref().map(|gear| gear.gear.external().expect("external"));
        let mesh = MeshGeometry::external(first, second, center_distance).expect("they mesh");
        let helical = HelicalTeeth { first: gears[0].helix, width: FACE_WIDTH };
        let mesh = if helix_angle == 0.0 { mesh } else { mesh.across(first, &helical) };
        let of_pair = of_mesh(gears.each_ref().map(|gear| gear.form()), &mesh);

        let (mut names, mut expressions, mut found) = (Vec::new(), Vec::new(), Vec::new());
        for (gear, name) in gears.iter().zip(["first", "second"]) {
            let quantities = of_gear(gear);
            let further = if helix_angle == 0.0 { &[] } else { OF_HELIX };
            for (symbol, expression) in OF_GEAR.iter().chain(further) {
                names.push(format!("{symbol} of the {name} gear at {helix_degrees} degrees"));
                expressions
                    .push(expression.replace("(g", &format!("({name}")).replace("g.", &format!("{name}.")));
                found.push(value(&quantities, symbol, None));
            }
        }
        let further = if helix_angle == 0.0 { OF_SINGLE_CONTACT } else { OF_HELICAL_MESH };
        for (symbol, member, expression) in OF_MESH.iter().chain(further) {
            names.push(format!("{symbol} {member:?} at {helix_degrees} degrees"));
            expressions.push((*expression).to_owned());
            found.push(value(&of_pair, symbol, *member));
        }
        let known = evaluated(helix_degrees, center_distance, &expressions);
        assert_eq!(known.len(), found.len());
        let mut wrong = String::new();
        for ((name, found), known) in names.iter().zip(&found).zip(&known) {
            if (found - known).abs() > ROUNDING * known.abs() {
                writeln!(wrong, "{name}: {found:.16e} is not {known:.16e}").expect("text grows");
            }
        }
        assert!(wrong.is_empty(), "\n{wrong}");
    }
}
