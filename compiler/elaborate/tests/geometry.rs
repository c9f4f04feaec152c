//! Tests the derived geometry by call: in the examples, in loops, and next to impossible gears.

use calyx_elaborate::{Cancel, CreatedAt, Elaboration, ModelLoader, Params, Quantity, elaborate, shown};

fn elaborated(text: &str) -> Elaboration {
    let checked = calyx_lang::check_program("model.cx", text, &ModelLoader::default());
    let program = checked.program.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    elaborate(&program, Params::Defaults, &Cancel::default()).expect("nobody cancels")
}

const PAIR: &str = include_str!("../../../examples/spur_pair.cx");

/// Returns the text of a call and the values of what it created.
fn listed<T>(text: &str, made: &CreatedAt<T>, system: &str, quantities: &[Quantity]) -> Vec<String> {
    let head = text[made.span.start as usize..made.span.end as usize].lines().next().unwrap_or_default();
    let mut lines = vec![head.to_owned()];
    lines.extend(quantities.iter().filter(|quantity| quantity.essential).map(|quantity| {
        let member = quantity.member.map(|member| format!(" [{member}]")).unwrap_or_default();
        let note = if quantity.note.is_empty() { String::new() } else { format!(" ({})", quantity.note) };
        format!("{}, {}{member} = {}{note}", quantity.name, quantity.symbol, shown::value(quantity, system))
    }));
    lines
}

#[test]
fn the_pair_of_the_report_is_told_in_inches() {
    let geometry = elaborated(PAIR).geometry;
    assert_eq!((geometry.gears.len(), geometry.meshes.len()), (2, 1));
    let pinion = &geometry.gears[0];
    assert_eq!(
        listed(PAIR, pinion, "inch_lbf_s", &pinion.first[0].quantities).join("\n"),
        "gears.external(
number of teeth, z = 20
transverse module, m_t = 0.1 inch
reference (pitch) diameter, d = 2 inch
base diameter, d_b = 1.87939 inch
tip (outside) diameter, d_a = 2.18 inch
root diameter, d_f = 1.76 inch
root form diameter, d_Ff = 1.88032 inch (the involute begins)
tooth thickness at the reference circle, s_t = 0.15708 inch
tooth thickness at the tip, s_a = 0.08077 inch (0.81 modules)
profile shift coefficient, x = 0 (of its tooth thickness)
profile shift above undercut, x - x_min = 0.1014 (undercut begins if the profile shift is smaller by this amount)"
    );
    let mesh = &geometry.meshes[0];
    assert_eq!(mesh.first[0].bodies, ["pinion", "gear"]);
    assert_eq!(mesh.first[0].gears, [geometry.gears[0].span, geometry.gears[1].span]);
    assert_eq!(
        listed(PAIR, mesh, "inch_lbf_s", &mesh.first[0].quantities).join("\n"),
        "gears.mesh(pinion, gear, tip_corner_contact = tip_corner_contact)
centre distance, a = 3 inch
operating pressure angle, alpha_wt = 20 deg
transverse contact ratio, epsilon_alpha = 1.4925
gear ratio, u = 2 (second over first)
circumferential backlash, j_wt = 0 inch
tip clearance at the root, c [0] = 0.03 inch (0.30 modules)
start of active profile, diameter, d_Nf [0] = 1.89262 inch
lowest single-tooth contact (LPSTC), diameter, d_LPSTC [0] = 1.94847 inch
highest single-tooth contact (HPSTC), diameter, d_HPSTC [0] = 2.04804 inch
tip clearance at the root, c [1] = 0.02 inch (0.20 modules)
start of active profile, diameter, d_Nf [1] = 3.87634 inch
lowest single-tooth contact (LPSTC), diameter, d_LPSTC [1] = 3.95748 inch
highest single-tooth contact (HPSTC), diameter, d_HPSTC [1] = 4.06121 inch"
    );
}

#[test]
fn gears_and_meshes_know_each_other() {
    let geometry = elaborated(PAIR).geometry;
    for (member, gears) in geometry.gears.iter().enumerate() {
        let gear = &gears.first[0];
        assert_eq!(gear.bodies, [["pinion", "gear"][member]]);
        let [membership] = gear.meshes[..] else { panic!("{:?}", gear.meshes) };
        assert_eq!(membership.member, member);
        assert_eq!(geometry.mesh(membership).map(|mesh| &mesh.bodies[member]), Some(&gear.bodies[0]));
    }
}

#[test]
fn a_place_finds_the_call_around_it() {
    let geometry = elaborated(PAIR).geometry;
    let offset = |what: &str| PAIR.find(what).unwrap_or_else(|| panic!("no {what}")) as u32;
    assert_eq!(geometry.gear_at(0, offset("outer_diameter = 4.18")), Some(&geometry.gears[1]));
    assert!(geometry.gear_at(0, offset("speed")).is_none());
    assert!(geometry.gear_at(1, offset("outer_diameter = 4.18")).is_none());
    assert!(geometry.mesh_at(0, offset("gears.mesh(")).is_some());
}

/// Returns a model of gears with the given tooth numbers, meshed with a first gear of 20 teeth
/// where `meshes`.
fn train(rest: &str) -> String {
    format!(
        "import gears;\nunits mm_N_s;\n\
         var steel = gears.material(206 GPa, 0.3);\n\
         var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);\n\
         function blank(in teeth: Number) {{\n\
             return gears.external(teeth = teeth, rack = rack, face_width = 10 mm,\n\
                 outer_diameter = (teeth + 2) * 2 mm, root_diameter = (teeth - 2.5) * 2 mm, material = steel,\n\
                 rim = gears.simple_rim((teeth - 5) * 2 mm, (teeth - 9) * 2 mm), tooth_thickness = 3.1 mm);\n\
         }}\n{rest}"
    )
}

#[test]
fn a_call_that_runs_often_is_counted_and_shows_the_first() {
    let text = train("for (var i = 0; i < 9; i = i + 1) { print(gears.base_radius(blank(20 + i))); }");
    let geometry = elaborated(&text).geometry;
    let [made] = &geometry.gears[..] else { panic!("{:?}", geometry.gears.len()) };
    assert_eq!((made.count, made.first.len()), (9, calyx_elaborate::geometry::MOST_PER_CALL));
    let teeth: Vec<f64> = made.first.iter().map(|gear| gear.quantities[0].value).collect();
    assert_eq!(teeth, [20.0, 21.0, 22.0, 23.0]);
}

#[test]
fn an_impossible_gear_does_not_hide_the_others() {
    // The root of the second gear is above its tip.
    let text = train(
        "var good = blank(20);\n\
         var bad = gears.external(teeth = 30, rack = rack, face_width = 10 mm, outer_diameter = 60 mm,\n\
             root_diameter = 62 mm, material = steel, rim = gears.simple_rim(40 mm, 30 mm));\n\
         var third = gears.external(teeth = 40, rack = rack, face_width = 10 mm, outer_diameter = 84 mm,\n\
             root_diameter = 75 mm, material = steel, rim = gears.simple_rim(60 mm, 50 mm));\n\
         var a = gears.body(\"a\", good, frame := Rotate(1 rpm * Time, e3));\n\
         var b = gears.body(\"b\", bad, frame := Rotate(-20/30 * 1 rpm * Time, e3) * Translate(50 mm * e1));\n\
         var c = gears.body(\"c\", third, frame := Rotate(-20/40 * 1 rpm * Time, e3) * Translate(60 mm * e1));\n\
         var ab = gears.mesh(a, b);\nvar ac = gears.mesh(a, c);\n\
         output x := gears.load_share(ac);\noutput y := gears.load_share(ab);",
    );
    let ended = elaborated(&text);
    let teeth: Vec<f64> = ended.geometry.gears.iter().map(|made| made.first[0].quantities[0].value).collect();
    assert_eq!(teeth, [20.0, 40.0]);
    let meshes: Vec<&[String; 2]> = ended.geometry.meshes.iter().map(|made| &made.first[0].bodies).collect();
    assert_eq!(meshes, [&["a".to_owned(), "c".to_owned()]]);
    assert!(ended.found.iter().any(|found| found.code == "E0929"), "{:?}", ended.found);
    assert!(ended.plan.is_none());
}

#[test]
fn a_pair_that_cannot_run_has_a_geometry_where_it_can_touch() {
    let apart = |distance: f64| {
        elaborated(&train(&format!(
            "var a = gears.body(\"a\", blank(20), frame := Rotate(1 rpm * Time, e3));\n\
             var b = gears.body(\"b\", blank(20), frame := Rotate(-1 rpm * Time, e3) * Translate({distance} mm * e1));\n\
             var ab = gears.mesh(a, b);\noutput x := gears.load_share(ab);"
        )))
    };
    let ended = apart(43.0);
    assert!(ended.found.iter().any(|found| found.code == "E0633"), "{:?}", ended.found);
    let contact = ended.geometry.meshes[0].first[0].quantities.iter().find(|q| q.symbol == "epsilon_alpha");
    assert!(contact.is_some_and(|contact| (0.0..1.0).contains(&contact.value)));
    assert!(apart(60.0).geometry.meshes.is_empty());
}
