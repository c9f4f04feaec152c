//! Elastic housings as models describe them: against the whole housing, against bearings on ground,
//! and in another orientation.

use crate::models::ranges_with;
use calyx_runtime::cache::Key;
use calyx_runtime::elastic::assembly::System;
use calyx_runtime::elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_runtime::elastic::import::{NastranOptions, Units, Unreadable, read_nastran};
use calyx_runtime::elastic::modes::{Request, natural_modes};
use calyx_runtime::elastic::stress::nodal_stresses_of;
use calyx_runtime::elastic::{FixedComponents, NodalLoad, Resources, statics};
use calyx_runtime::elastic_body::{ElasticBody, FiniteElementBody, MassReduction};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::stress::von_mises;
use std::collections::BTreeMap;
use std::fs;
use std::sync::Arc;

fn examples() -> std::path::PathBuf {
    calyx_tests::root().join("examples")
}

fn housing_file() -> String {
    fs::read_to_string(examples().join("housing.bdf")).expect("the housing")
}

/// Smallest and largest value of each output of a model next to a housing.
fn in_housing(text: &str, housing: &str) -> BTreeMap<String, [f64; 2]> {
    ranges_with(text, &[("housing.bdf", housing)])
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// A helical pair, whose pinion is on a shaft in two seats of the housing. `placed` is a transform
/// of the whole from ground, `axis` the direction of the axes then.
fn pair_in_housing(placed: &str, axis: &str, how: &str) -> String {
    let mut text = format!(
        "import gears;
units mm_N_s;
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
function blank(in teeth, in hand) {{
    return gears.external(teeth, normal_module = 2 mm, helix_angle = 15 deg, hand = hand, face_width = 20 mm, material = steel);
}}
var a = blank(23, \"right\"), b = blank(38, \"left\");
var axis = {axis};
var housing = gears.nastran(\"housing\", \"housing.bdf\", units = \"N-mm-s\", frame := Translate(0 mm * e3){placed});
var foot_1 = gears.attachment(\"foot 1\", housing, gears.node_set(\"SET1 1\"), fixed = TRUE);
var foot_2 = gears.attachment(\"foot 2\", housing, gears.node_set(\"SET1 2\"), fixed = TRUE);
var foot_3 = gears.attachment(\"foot 3\", housing, gears.node_set(\"SET1 3\"), fixed = TRUE);
var foot_4 = gears.attachment(\"foot 4\", housing, gears.node_set(\"SET1 4\"), fixed = TRUE);
function seat(in name, in z: Length) {{
    return gears.attachment(name, housing,
        gears.cylinder_region(z * e3, e3, radius = 20 mm, from = 0 mm, to = 0 mm), how = \"{how}\", position = z * e3);
}}
var front_seat = seat(\"front seat\", -45 mm), back_seat = seat(\"back seat\", 45 mm);
var shaft = gears.shaft(\"input\", segments = [gears.shaft_segment(length = 140 mm, diameter = 30 mm, bore = 8 mm)],
    material = steel, frame := Rotate(600 rpm * Time, e3) * Translate(-60 mm * e3){placed});
var first = gears.mount(\"pinion\", a, on = shaft, at = 60 mm);
gears.shaft_load(shaft, at = 140 mm, moment = 120 N*m * axis);
var front = gears.bearing(\"front\", shaft, to = front_seat, at = 15 mm * e3, radial_stiffness = 4e8 N/m, axial_stiffness = 2e8 N/m, tilting_stiffness = 1e4 N*m/rad);
var back = gears.bearing(\"back\", shaft, to = back_seat, at = 105 mm * e3, radial_stiffness = 3e8 N/m);
var second = gears.body(\"gear\", b,
    frame := Rotate(-600 rpm * 23 / 38 * Time, e3) * Translate((gears.center_distance(a, b) + 0.05 mm) * e1){placed});
var mesh = gears.mesh(first, second);
output front_radial := gears.bearing_force(front, \"radial\");
output back_radial := gears.bearing_force(back, \"radial\");
output front_axial := gears.bearing_force(front, \"axial\");
output deflection := gears.shaft_displacement(shaft, 60 mm, \"radial\");
output te := gears.transmission_error(mesh);
output uneven := gears.face_load_factor(mesh);
"
    );
    for name in ["front", "back"] {
        for axis in AXES {
            text += &format!(
                "output {name}_force_{axis} := gears.bearing_force({name}, \"{axis}\");
output {name}_moment_{axis} := gears.bearing_moment({name}, \"{axis}\");
output {name}_shift_{axis} := gears.displacement({name}_seat, \"{axis}\");
output {name}_turn_{axis} := gears.rotation({name}_seat, \"{axis}\");
"
            );
        }
    }
    for foot in 1..=4 {
        for axis in AXES {
            text += &format!("output foot_{foot}_{axis} := gears.support_force(foot_{foot}, \"{axis}\");\n");
        }
    }
    text + "analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"analytic\", error_estimates = \"none\");\n"
}

/// Checks that the displacements and stresses of all nodes, which `--vtu` shows, are those of the
/// whole housing.
fn check_interior(body: &FiniteElementBody, motions: &[[f64; 6]], whole: &[[f64; 6]]) {
    let never = Interrupt::never();
    let matrices = body.condense(MassReduction::None, &never).expect("condensed");
    let recovery = body.recovery(&never).expect("solved").expect("a mesh");
    let values = motions.as_flattened();
    let row = |row: &[f64]| row.iter().zip(values).map(|(entry, moved)| entry * moved).sum();
    let forces: Vec<f64> = matrices.stiffness.chunks_exact(values.len()).map(row).collect();
    let forces: Vec<[f64; 6]> = forces.chunks_exact(6).map(|six| std::array::from_fn(|k| six[k])).collect();
    let deformed = recovery.deformed(motions, &forces, &[]).expect("valid");
    let whole = &whole[..body.model().nodes.len()];
    let size =
        |values: &mut dyn Iterator<Item = f64>| values.fold(0.0_f64, |size, value| size.max(value.abs()));
    let largest = size(&mut whole.iter().flat_map(|node| node[..3].to_vec()));
    assert!(largest > 1e-7, "{largest}");
    for (found, expected) in deformed.displacements.iter().zip(whole) {
        let difference = size(&mut (0..3).map(|k| found[k] - expected[k]));
        assert!(difference < 1e-8 * largest, "{found:?} instead of {expected:?}");
    }
    let stresses = nodal_stresses_of(body.model(), whole).expect("valid").stresses;
    let of_meshed = || stresses.iter().filter(|stress| !stress[0].is_nan());
    let highest = size(&mut of_meshed().map(|stress| von_mises(*stress)));
    assert!(highest > 1e5, "{highest}");
    for (found, expected) in deformed.stresses.iter().zip(&stresses) {
        if expected[0].is_nan() {
            continue;
        }
        let difference = size(&mut (0..6).map(|k| found[k] - expected[k]));
        assert!(difference < 1e-6 * highest, "{found:?} instead of {expected:?}");
    }
}

/// The displacements of the seats and the reactions of the feet are those of the whole housing
/// under the forces of the bearings, at one position.
#[test]
fn seats_and_feet_are_those_of_the_whole_housing() {
    for how in ["rigid", "average"] {
        let text = pair_in_housing("", "e3", how);
        let found = in_housing(&text, &housing_file());
        let value = |name: String| {
            let [least, most] = found[&name];
            assert_eq!(least, most, "{name}");
            most
        };
        let mut open = |path: &str| match path {
            "housing.bdf" => Ok(housing_file().into_bytes()),
            _ => Err(Unreadable::new("no such file", "")),
        };
        let options = NastranOptions { units: Units::N_MM_S, subcase: None };
        let mut model = read_nastran("housing.bdf", &options, &mut open).expect("a housing").model;
        let mut body = FiniteElementBody::new(Arc::new(model.clone()), Key::of("housing").finish());
        let seat = |name: &str, z: f64| Attachment {
            name: name.into(),
            position: Some([0.0, 0.0, z]),
            region: Region::Cylinder {
                origin: [0.0, 0.0, z],
                axis: [0.0, 0.0, 1.0],
                radius: 0.02,
                heights: [0.0, 0.0],
                tolerance: 2e-4,
            },
            connection: if how == "rigid" { Connection::Rigid } else { Connection::Average },
        };
        let mut feet = Vec::new();
        for foot in 1..=4 {
            let region = Region::Set(format!("SET1 {foot}"));
            let connection = Connection::Rigid;
            let foot = Attachment { name: format!("foot {foot}"), position: None, region, connection };
            body.attach(&foot).expect("a foot");
            feet.push(attach(&mut model, &foot).expect("a foot")[0]);
        }
        let seats = [("front", -0.045), ("back", 0.045)].map(|(name, z)| {
            body.attach(&seat(name, z)).expect("a seat");
            attach(&mut model, &seat(name, z)).expect("a seat")[0]
        });
        model.fixed.extend(feet.iter().map(|&node| FixedComponents {
            node,
            components: [true; 6],
            value: 0.0,
        }));
        // The bearings push the housing with the opposite of their forces on the shaft.
        let load = |(&node, name): (&usize, &str)| NodalLoad {
            node,
            load: std::array::from_fn(|k| {
                let kind = if k < 3 { "force" } else { "moment" };
                -value(format!("{name}_{kind}_{}", AXES[k % 3]))
            }),
        };
        let case = seats.iter().zip(["front", "back"]).map(load).collect();
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        let solution = &statics::solve(&system, &[case], &resources).expect("supported")[0];
        let of_seat = |name: &str| -> [f64; 6] {
            std::array::from_fn(|k| {
                let kind = if k < 3 { "shift" } else { "turn" };
                value(format!("{name}_{kind}_{}", AXES[k % 3]))
            })
        };
        let motions: Vec<[f64; 6]> =
            [[0.0; 6]; 4].into_iter().chain(["front", "back"].map(of_seat)).collect();
        check_interior(&body, &motions, &solution.displacements);
        for (kind, from) in [("shift", 0), ("turn", 3)] {
            let pairs = seats.iter().zip(["front", "back"]).flat_map(|(&node, name)| {
                (0..3).map(move |k| (format!("{name}_{kind}_{}", AXES[k]), (node, from + k)))
            });
            let pairs: Vec<_> =
                pairs.map(|(name, (node, k))| (value(name), solution.displacements[node][k])).collect();
            let scale = pairs.iter().fold(0.0_f64, |scale, pair| scale.max(pair.1.abs()));
            for (found, expected) in pairs {
                assert!((found - expected).abs() < 1e-9 * scale, "{how} {kind}: {found} {expected}");
            }
        }
        let largest = solution.reactions.iter().fold(0.0_f64, |most, reaction| most.max(reaction.2.abs()));
        for (node, foot) in feet.iter().zip(1..) {
            for (k, axis) in AXES.iter().enumerate() {
                let of = |reaction: &&(usize, usize, f64)| reaction.0 == *node && reaction.1 == k;
                let expected = solution.reactions.iter().find(of).expect("a reaction").2;
                let found = value(format!("foot_{foot}_{axis}"));
                assert!((found - expected).abs() < 1e-8 * largest, "{how} {foot} {axis}: {found} {expected}");
            }
        }
    }
}

/// A housing that is 10⁵ times stiffer has the results of bearings on ground.
#[test]
fn a_stiff_housing_is_ground() {
    let text = fs::read_to_string(examples().join("housing.cx")).expect("the example");
    let text = text.replace("fidelity = fidelity)", "fidelity = fidelity, error_estimates = \"none\")");
    let stiff = housing_file().replace("MAT1,1,1.73+5", "MAT1,1,1.73+10");
    assert_ne!(stiff, housing_file());
    let grounded = text.replace("param elastic_housing = TRUE", "param elastic_housing = FALSE");
    let expected = in_housing(&grounded, &housing_file());
    let found = in_housing(&text, &stiff);
    let elastic = in_housing(&text, &housing_file());
    for (name, expected) in &expected {
        let scale = expected[0].abs().max(expected[1].abs());
        for (found, expected) in found[name].iter().zip(expected) {
            assert!((found - expected).abs() < 2e-4 * scale, "{name}: {found} instead of {expected}");
        }
    }
    // The housing itself matters.
    assert!(elastic["transmission_error"][1] > 1.1 * expected["transmission_error"][1]);
}

/// The model in another orientation has the same results.
#[test]
fn the_orientation_of_a_housing_does_not_matter() {
    let upright = in_housing(&pair_in_housing("", "e3", "rigid"), &housing_file());
    let placed = " * Rotate(90 deg, e2) * Translate(3 mm * e1 - 2 mm * e2 + 5 mm * e3)";
    let tilted = in_housing(&pair_in_housing(placed, "e1", "rigid"), &housing_file());
    for name in ["front_radial", "back_radial", "front_axial", "deflection", "te", "uneven"] {
        let (found, expected) = (tilted[name], upright[name]);
        let scale = expected[0].abs().max(expected[1].abs());
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-7 * scale, "{name}: {found} instead of {expected}");
        }
    }
}

/// The mass of the housing lowers the lowest natural frequency of the pair, and a housing without
/// attachments on its walls has its mass at the seats.
#[test]
fn a_housing_takes_part_in_vibrations() {
    let text = fs::read_to_string(examples().join("housing.cx")).expect("the example");
    let one = "over = gears.times(to = 0 s, count = 1), error_estimates = \"none\", fidelity";
    let outputs =
        "output first := gears.natural_frequency(1);\noutput tenth := gears.natural_frequency(10);\n";
    let text = text
        .replace("over = gears.mesh_cycle(mesh, steps), fidelity", one)
        .replace("analyze(", &format!("{outputs}analyze("));
    let heavy = housing_file().replace(",0.275,7.1-9", ",0.275,7.1-8");
    assert_ne!(heavy, housing_file());
    let grounded = text.replace("param elastic_housing = TRUE", "param elastic_housing = FALSE");
    let [grounded, light, heavy] = [
        in_housing(&grounded, &housing_file()),
        in_housing(&text, &housing_file()),
        in_housing(&text, &heavy),
    ]
    .map(|outputs| ["first", "tenth"].map(|name| outputs[name][0]));
    for mode in 0..2 {
        assert!(light[mode] > 0.0 && light[mode].is_finite(), "{light:?}");
        assert!(
            light[mode] < grounded[mode] && heavy[mode] < light[mode],
            "{grounded:?} {light:?} {heavy:?}"
        );
    }
}

/// With component modes, a housing on its feet has the natural frequencies of the whole housing
/// below half of their highest frequency. By its static displacements it has the motions of its
/// seats only.
#[test]
fn a_housing_vibrates_like_the_whole_housing() {
    for how in ["rigid", "average"] {
        let mut open = |path: &str| match path {
            "housing.bdf" => Ok(housing_file().into_bytes()),
            _ => Err(Unreadable::new("no such file", "")),
        };
        let options = NastranOptions { units: Units::N_MM_S, subcase: None };
        let mut model = read_nastran("housing.bdf", &options, &mut open).expect("a housing").model;
        let mut text = String::from(
            "import gears;
units mm_N_s;
var housing = gears.nastran(\"housing\", \"housing.bdf\", units = \"N-mm-s\", frame := Translate(0 mm * e3));
",
        );
        for foot in 1..=4 {
            text += &format!(
                "gears.attachment(\"foot {foot}\", housing, gears.node_set(\"SET1 {foot}\"), fixed = TRUE);\n"
            );
            let region = Region::Set(format!("SET1 {foot}"));
            let foot = Attachment {
                name: format!("foot {foot}"),
                position: None,
                region,
                connection: Connection::Rigid,
            };
            let node = attach(&mut model, &foot).expect("a foot")[0];
            model.fixed.push(FixedComponents { node, components: [true; 6], value: 0.0 });
        }
        for (name, z) in [("front", -45.0), ("back", 45.0)] {
            text += &format!(
                "gears.attachment(\"{name}\", housing, gears.cylinder_region({z} mm * e3, e3, radius = 20 mm, from = 0 mm, to = 0 mm), how = \"{how}\", position = {z} mm * e3);\n"
            );
            let seat = Attachment {
                name: name.into(),
                position: Some([0.0, 0.0, 1e-3 * z]),
                region: Region::Cylinder {
                    origin: [0.0, 0.0, 1e-3 * z],
                    axis: [0.0, 0.0, 1.0],
                    radius: 0.02,
                    heights: [0.0, 0.0],
                    tolerance: 2e-4,
                },
                connection: if how == "rigid" { Connection::Rigid } else { Connection::Average },
            };
            attach(&mut model, &seat).expect("a seat");
        }
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        let mass = system.mass(&resources).expect("valid");
        let highest = 8000.0;
        let exact = natural_modes(&system, &mass, Request::Below(0.5 * highest), &resources);
        let exact = exact.expect("converges").frequencies();
        assert!(exact.len() >= 5, "{exact:?}");
        let found = |highest: f64| {
            let outputs: String = (1..=exact.len().min(12))
                .map(|mode| format!("output mode_{mode} := gears.natural_frequency({mode});\n"))
                .collect();
            let analysis = format!(
                "analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"analytic\", highest_frequency = {highest} Hz, error_estimates = \"none\");\n"
            );
            let ranges = in_housing(&format!("{text}{outputs}{analysis}"), &housing_file());
            (1..=exact.len().min(12)).map(|mode| ranges[&format!("mode_{mode}")][0]).collect::<Vec<_>>()
        };
        for (found, exact) in found(highest).iter().zip(&exact) {
            assert!((found / exact - 1.0).abs() < 1e-3, "{how}: {found} instead of {exact}");
        }
        let statically = found(0.0);
        assert!(
            statically.iter().zip(&exact).any(|(found, exact)| found / exact > 1.05),
            "{statically:?} {exact:?}"
        );
    }
}
