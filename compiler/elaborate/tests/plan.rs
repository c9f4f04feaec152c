//! Tests the text of a model's plan.

use calyx_elaborate::{Cancel, ModelLoader, Override, ParamAssignment, Params, Planned, elaborate};
use calyx_runtime::cost::Rates;
use calyx_runtime::estimate::Estimates;
use calyx_runtime::scene::Fidelity;
use calyx_runtime::tolerance::MOST_WORK;

const PAIR: &str = include_str!("../../../examples/spur_pair.cx");
const PLANETARY: &str = include_str!("../../../examples/planetary.cx");

fn planned(text: &str, set: &[(&str, &str)]) -> Option<Planned> {
    planned_with(text, set, Override::default())
}

fn planned_with(text: &str, set: &[(&str, &str)], overrides: Override) -> Option<Planned> {
    let checked = calyx_lang::check_program("model.cx", text, &ModelLoader::default());
    let program = checked.program.unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
    let given: Vec<ParamAssignment> =
        set.iter().map(|(name, text)| ParamAssignment::text(*name, *text)).collect();
    elaborate(&program, Params::Given(&given, overrides, None), &Cancel::default())
        .expect("nobody cancels")
        .plan
}

#[test]
fn the_plan_says_what_how_and_why() {
    assert_eq!(
        planned(PAIR, &[("fidelity", "plane")]).expect("a plan").text(),
        "Method
  fidelity \"plane\": two-dimensional transverse section (plane strain)

Bodies
  \"pinion\": 20 teeth, face width 1 inch
    elastic, with stress recovery: an output asks for its root stress
  \"gear\": 40 teeth, face width 1 inch
    elastic, with stress recovery: an output asks for its root stress

Structures
  \"pinion\": 20 sectors of 946 elements and 17,286 degrees of freedom, 344,400 in all
    condensed to 132 interface unknowns
    per tooth: 256 unit loads on the flanks, 104 stress points
    about 118 million multiplications, 3.7 MB stored
  \"gear\": 40 sectors of 1,064 elements and 19,428 degrees of freedom, 774,000 in all
    condensed to 156 interface unknowns
    per tooth: 256 unit loads on the flanks, 112 stress points
    about 159 million multiplications, 3.9 MB stored

Contact
  \"pinion\" with \"gear\": flanks and tip edges, 49 cells per tooth pair, contact ratio 1.493

Degrees of freedom
  theta_z of \"pinion\", moment 1000 lbf*inch

Outputs
  transmission_error, transmission_error_length, load_share, mesh_stiffness, max_contact_pressure,
  max_edge_pressure, max_root_stress_pinion, max_root_stress_gear

Omitted
  `lead_crown`: a plane model has no direction along the face

Cost
  static condensation of 2 elastic structures
  together about 277 million multiplications, 7.5 MB stored
  35 positions, each a contact problem with about 98 contact pressures and 1 degree of freedom
"
    );
}

#[test]
fn params_change_the_plan() {
    let plan = planned(PAIR, &[("steps", "4"), ("tip_corner_contact", "FALSE"), ("lead_crown", "0")])
        .expect("a plan");
    assert_eq!((plan.positions, plan.meshes[0].edges, plan.ignored_inputs.len()), (vec![7], false, 0));
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
    assert_eq!((plan.bodies.len(), plan.structures, plan.meshes.len(), plan.dofs()), (3, 2, 2, 2));
}

#[test]
fn what_is_wrong_or_touches_nothing_has_no_plan() {
    assert!(planned("print(1);", &[]).is_none());
    assert!(planned(&PAIR.replace("root_diameter = 1.76 inch", "root_diameter = 2.1 inch"), &[]).is_none());
    assert!(planned(PAIR, &[("torque", "-1")]).is_none());
}

/// A machine with two cores.
const RATES: Rates = Rates { products: 1e10, logarithms: 2.8e8, threads: 2 };

#[test]
fn costs_include_estimates_of_errors() {
    for fidelity in ["analytic", "plane", "medium"] {
        let of = |estimates: Estimates| {
            let overrides = Override { error_estimates: Some(estimates), ..Override::default() };
            planned_with(PAIR, &[("fidelity", fidelity)], overrides).expect("a plan").cost(&RATES)
        };
        let [none, cheap, full] = [Estimates::None, Estimates::Cheap, Estimates::Full].map(of);
        let [own, with, most] = [&none, &cheap, &full].map(|cost| cost.time());
        assert_eq!(none.analysis.errors.time, 0.0);
        assert!(with > 1.3 * own && with < 4.0 * own, "{fidelity}: {own} {with}");
        assert!(most > 1.5 * with, "{fidelity}: {with} {most}");
        assert!(
            !none.text().contains("error estimates") && cheap.text().contains("\"cheap\" error estimates: ")
        );
    }
}

#[test]
fn the_cost_of_a_tolerance_is_that_of_its_settings() {
    let text = PAIR.replace("fidelity = fidelity", "fidelity = \"rigid\", tolerance = 3 %");
    assert_ne!(text, PAIR);
    let cost = planned(&text, &[]).expect("a plan").cost(&RATES);
    let (tolerance, search) = cost.search.as_ref().expect("a search");
    assert_eq!((*tolerance, search.most), (0.03, MOST_WORK));
    let names: Vec<&str> = search.candidates.iter().map(|rung| rung.setting.fidelity.name()).collect();
    let expected = ["rigid", "analytic", "plane", "plane", "plane", "medium", "fineroot", "finest", "finest"];
    assert_eq!(names, expected);
    assert!(search.candidates.iter().all(|rung| rung.few > 0.0 && rung.all > 0.0), "{search:?}");
    let said = cost.text();
    for part in ["to a tolerance of 3 %", "\"medium\": ", "at most 10 min; "] {
        assert!(said.contains(part), "{part} in {said}");
    }
    // With a setting on the command line there is no tolerance search.
    let overrides = Override { fidelity: Fidelity::named("plane"), ..Override::default() };
    let cost = planned_with(&text, &[], overrides).expect("a plan").cost(&RATES);
    assert!(cost.search.is_none());
}

#[test]
fn the_disk_space_of_a_run_includes_its_meshes_on_request() {
    let of = |fidelity: &str| planned(PAIR, &[("fidelity", fidelity)]).expect("a plan").disk();
    let [analytic, plane, medium] = ["analytic", "plane", "medium"].map(of);
    assert_eq!(analytic.view, analytic.with_meshes);
    assert!(analytic.view > 1e5 && analytic.view < 2e6, "{analytic:?}");
    for disk in [plane, medium] {
        assert!(disk.with_meshes > 5.0 * disk.view, "{disk:?}");
        assert!(disk.text().contains(", with --vtu "), "{}", disk.text());
    }
}

#[test]
fn the_plan_names_elastic_raceways() {
    let set = |bearings| [("planet_bearings", bearings), ("fidelity", "plane")];
    let of = |bearings| planned(PLANETARY, &set(bearings)).expect("a plan").text();
    let elastic = "\"planet 1\" on \"carrier\", cylindrical roller bearing";
    let text = of("rollers");
    let line = text.lines().find(|line| line.contains(elastic)).expect("the bearing");
    assert!(line.ends_with("; elastic outer raceway in the bore of \"planet 1\""), "{line}");
    assert!(!of("springs").contains("raceway"));
}
