//! The plan of a model in words.

use calyx_elaborate::{Cancel, Given, ModelLoader, Override, Params, Planned, elaborate};

const PAIR: &str = include_str!("../../../examples/spur_pair.cx");

fn planned(text: &str, set: &[(&str, &str)]) -> Option<Planned> {
    let checked = calyx_lang::check::check_program("model.cx", text, &ModelLoader { folder: None });
    let program = checked.program.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    let given: Vec<Given> = set.iter().map(|(name, text)| Given::text(*name, *text)).collect();
    elaborate(&program, Params::Given(&given, Override::default(), None), &Cancel::default())
        .expect("nobody cancels")
        .plan
}

#[test]
fn the_plan_says_what_how_and_why() {
    assert_eq!(
        planned(PAIR, &[("fidelity", "plane")]).expect("a plan").text(),
        "How
  fidelity \"plane\": one transverse section in plane strain, the same all along the face

Bodies
  \"pinion\": 20 teeth, face width 1 inch
    elastic, with stress recovery: an output asks for its root stress
  \"gear\": 40 teeth, face width 1 inch
    elastic, with stress recovery: an output asks for its root stress

Structures
  \"pinion\": 20 sectors of 946 elements and 17,286 degrees of freedom, 344,400 in all
    condensed to 132 unknowns of cuts
    known of a tooth: 256 loads on its flanks, 104 places of stress
    about 118 million multiplications, 3.6 MB kept
  \"gear\": 40 sectors of 1,064 elements and 19,428 degrees of freedom, 774,000 in all
    condensed to 156 unknowns of cuts
    known of a tooth: 256 loads on its flanks, 112 places of stress
    about 159 million multiplications, 3.7 MB kept

Contact
  \"pinion\" with \"gear\": flanks and tip edges, 49 cells a pair of teeth, contact ratio 1.493

Degrees of freedom
  theta_z of \"pinion\", moment 1000 lbf*inch

Wanted
  transmission_error, transmission_error_length, load_share, mesh_stiffness, max_contact_pressure,
  max_edge_pressure, max_root_stress_pinion, max_root_stress_gear

Left out
  `lead_crown`: a plane model has no direction along the face

Cost
  2 elastic structures are condensed, each once
  together about 277 million multiplications, 7.3 MB kept
  35 positions, each one contact problem of about 98 contact pressures and 1 free motion
"
    );
}

#[test]
fn params_change_the_plan() {
    let plan = planned(PAIR, &[("steps", "4"), ("tip_corner_contact", "FALSE"), ("lead_crown", "0")])
        .expect("a plan");
    assert_eq!((plan.positions, plan.meshes[0].edges, plan.not_seen.len()), (vec![7], false, 0));
}

#[test]
fn bodies_of_one_gear_share_a_structure() {
    let text = PAIR.replace(
        "var mesh = gears.mesh(",
        "var other = gears.body(\"other\", pinion_blank,\n    \
             frame := Rotate(speed * Time, e3) * Translate(2 * center_distance * e1));\n\
         var second = gears.mesh(gear, other);\noutput second_share := gears.load_share(second);\nvar mesh = gears.mesh(",
    );
    let plan = planned(
        &text.replace(
            "    \"gear\",\n    gear_blank,",
            "    \"gear\",\n    gear_blank,\n    free = [\"theta_z\"],",
        ),
        &[],
    )
    .expect("a plan");
    assert_eq!((plan.bodies.len(), plan.structures, plan.meshes.len(), plan.freedoms()), (3, 2, 2, 2));
}

#[test]
fn what_is_wrong_or_touches_nothing_has_no_plan() {
    assert!(planned("print(1);", &[]).is_none());
    assert!(planned(&PAIR.replace("teeth = 20,", "teeth = 2,"), &[]).is_none());
    assert!(planned(PAIR, &[("torque", "-1")]).is_none());
}
