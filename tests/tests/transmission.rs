//! Assembled transmissions against the same models by hand, bevel gears on shafts, and the
//! misalignment of meshes.

use crate::models::{close, means, solved};
use std::fmt::Write;

/// Two helical gears of module 2.5 mm, and a deep groove ball bearing.
const GEARS: &str = "import gears;
import transmission;
units mm_N_s;
function blank(in count, in hand) {
    return gears.external(
        count, normal_module = 2.5 mm, helix_angle = 20 deg, hand = hand, face_width = 24 mm, tooth_thickness = 3.9 mm);
}
var small = blank(25, \"left\"), large = blank(47, \"right\");
var distance = gears.center_distance(small, large);
var segments = [gears.shaft_segment(length = 200 mm, diameter = 40 mm)];
function ball_bearing(in name: String, in shaft: Body, in to: Body, in at: Vector(Length)) {
    return gears.ball_bearing(
        name, shaft, to = to, at = at, count = 9, ball_diameter = 12 mm, pitch_diameter = 60 mm);
}
";

#[test]
fn an_assembled_transmission_is_the_one_made_by_hand() {
    let assembled = format!(
        "{GEARS}
var input = transmission.rotor(
    \"input\", segments = segments, start = -90 mm, gears = [transmission.gear(\"pinion\", small, hub_width = 20 mm)],
    coupling = -90 mm);
var driven = transmission.rotor(
    \"output\", point = distance * e1, segments = segments, start = -100 mm,
    gears = [transmission.gear(\"wheel\", large, at = 2 mm)], coupling = 100 mm);
var box = transmission.assemble(
    [input, driven], meshes = [transmission.mesh(\"pair\", \"pinion\", \"wheel\", contact_slices = 3, contact_cells = 5)],
    speeds = [transmission.Speed(input, 1500 rpm)], torques = [transmission.Torque(input, 120 N*m)], reactions = [driven]);
for (rotor in [input, driven]) {{
    transmission.connect(box, \"{{rotor.rotor.name}} front\", ball_bearing, rotor, at = -80 mm);
    transmission.connect(box, \"{{rotor.rotor.name}} back\", ball_bearing, rotor, at = 80 mm);
}}
var mesh = transmission.mesh_of(box, \"pair\");
output lag := transmission.transmission_error(box, input, driven);
output torque := gears.support_moment(transmission.body(box, driven), \"z\");
output pressure := gears.max_contact_pressure(mesh);
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"analytic\", error_estimates = \"none\");
"
    );
    let by_hand = format!(
        "{GEARS}
var input = gears.shaft(
    \"input\", segments, \"steel\", frame := Translate(-90 mm * e3) * Rotate(1500 rpm * Time, e3));
var pinion = gears.mount(\"pinion\", small, on = input, at = 90 mm, hub_width = 20 mm);
gears.shaft_load(input, at = 0 mm, moment = 120 N*m * e3);
var driven = gears.shaft(
    \"output\", segments, \"steel\", prescribed_rotation_at = 200 mm,
    frame := Translate(-100 mm * e3) * Rotate(-1500 rpm * 25 / 47 * Time, e3) * Translate(distance * e1));
var wheel = gears.mount(\"wheel\", large, on = driven, at = 102 mm);
var mesh = gears.mesh(pinion, wheel, contact_slices = 3, contact_cells = 5);
ball_bearing(\"input front\", input, gears.ground(), 10 mm * e3);
ball_bearing(\"input back\", input, gears.ground(), 170 mm * e3);
ball_bearing(\"output front\", driven, gears.ground(), 20 mm * e3);
ball_bearing(\"output back\", driven, gears.ground(), 180 mm * e3);
output lag := -gears.shaft_rotation(input, 0 mm, \"axial\") * 25 / 47 - gears.shaft_rotation(driven, 200 mm, \"axial\");
output torque := gears.support_moment(driven, \"z\");
output pressure := gears.max_contact_pressure(mesh);
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"analytic\", error_estimates = \"none\");
"
    );
    // The output rotates in the negative sense, in which it lags.
    let (found, expected) = (solved(&assembled).0, solved(&by_hand).0);
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(&expected) {
        close("lag", found[0], -expected[0], 1e-9);
        close("torque", found[1], expected[1], 1e-9);
        close("pressure", found[2], expected[2], 1e-9);
    }
}

/// The slopes that a mesh has because its second gear tilts are those of the arguments of `mesh`.
#[test]
fn slopes_are_the_misalignment_that_loads_the_teeth_alike() {
    let pair = |torque: &str, [second, support]: [&str; 2], mesh: &str| {
        format!(
            "{GEARS}
var first = gears.body(
    \"first\", small, free = [\"theta_z\"], moment = {torque} * e3, frame := Rotate(1500 rpm * Time, e3));
var second = gears.body(
    \"second\", large, {second}
    frame := Rotate(-1500 rpm * 25 / 47 * Time, e3) * Translate(distance * (cos(70 deg) * e1 + sin(70 deg) * e2)));
{support}
var mesh = gears.mesh(first, second, contact_slices = 5, contact_cells = 10{mesh});
output slope := gears.misalignment_slope(mesh);
output slope_normal := gears.misalignment_slope(mesh, \"normal\");
output line_load := gears.max_line_load(mesh);
output error := gears.transmission_error(mesh);
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"analytic\", error_estimates = \"none\");
"
        )
    };
    let tilting = [
        "free = [\"theta_x\", \"theta_y\"], moment = 400 N*m * e1 + 700 N*m * e2,",
        "gears.bearing(\"support\", second, tilting_stiffness = 1e6 N*m/rad);",
    ];
    for torque in ["150 N*m", "-150 N*m"] {
        let straight = means(&pair(torque, ["", ""], ""));
        let tilted = means(&pair(torque, tilting, ""));
        let [slope, normal] = ["slope", "slope_normal"].map(|name| tilted[name]);
        // The teeth resist the tilt, too.
        close("tilt", slope.hypot(normal), 400f64.hypot(700.0) * 1e-6, 0.05);
        let stated = format!(", misalignment = {slope} rad, misalignment_out_of_plane = {normal} rad");
        let stated = means(&pair(torque, ["", ""], &stated));
        // Contact grids are in the planes of the stated misalignment, and not of the deflection.
        for (name, tolerance) in [("line_load", 0.05), ("error", 0.01)] {
            let change = (tilted[name] / straight[name] - 1.0).abs();
            assert!(change > 0.05, "{torque}: {name} changes by {change} only");
            close(name, stated[name], tilted[name], tolerance);
        }
    }
}

/// A straight bevel pair, with the pinion on a rigid shaft or a body of its own, on springs.
fn bevel_pair(on_shaft: bool) -> String {
    let mut text = "import bevel;
import bevel_gear;
import gears;
units mm_N_s;
var module = 5 mm;
var pitch_angle = atan(18 / 27);
var cone_distance = 9 * module / sin(pitch_angle);
var thickness = pi / 2 * module * (cone_distance - 7 mm) / cone_distance - 0.05 mm;
function gear_of(in count, in angle) {
    var blank = bevel.Blank(
        outer_cone_distance = cone_distance, face_width = 14 mm, pitch_angle = angle,
        face_angle = angle + atan(0.8 * module / cone_distance),
        root_angle = angle - atan(module / cone_distance));
    return bevel_gear.gear(bevel.straight(count, angle, 22.5 deg, 0.8 mm), blank, thickness = thickness);
}
var small = gear_of(18, pitch_angle), large = gear_of(27, 90 deg - pitch_angle);
var gear = gears.body(
    \"gear\", large, free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\"],
    frame := Rotate(-40 rpm * Time, e3) * Rotate(180 deg, e1) * Rotate(90 deg, e2));
gears.bearing(
    \"gear support\", gear, radial_stiffness = 2e8 N/m, axial_stiffness = 1e8 N/m, tilting_stiffness = 3e6 N*m/rad);
"
    .to_owned();
    let bearing = "radial_stiffness = 3e8 N/m, axial_stiffness = 1e8 N/m";
    let (pinion, first, second) = match on_shaft {
        true => (
            "var shaft = gears.shaft(
    \"shaft\", [gears.shaft_segment(length = 120 mm, diameter = 20 mm)], \"steel\", elastic = FALSE,
    frame := Translate(-180 mm * e3) * Rotate(60 rpm * Time, e3));
gears.shaft_load(shaft, at = 0 mm, moment = 60 N*m * e3);
var pinion = gears.mount(\"pinion\", small, on = shaft, at = 180 mm);",
            format!("gears.bearing(\"head\", shaft, at = 90 mm * e3, {bearing})"),
            format!("gears.bearing(\"tail\", shaft, at = 10 mm * e3, {bearing})"),
        ),
        false => (
            "var pinion = gears.body(
    \"pinion\", small, free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\", \"theta_z\"], moment = 60 N*m * e3,
    frame := Rotate(60 rpm * Time, e3));",
            format!("gears.bearing(\"head\", pinion, at = -90 mm * e3, {bearing})"),
            format!("gears.bearing(\"tail\", pinion, at = -170 mm * e3, {bearing})"),
        ),
    };
    write!(
        text,
        "{pinion}
var head = {first};
var tail = {second};
var mesh = gears.mesh(pinion, gear, contact_slices = 3, contact_cells = 4);
output error := gears.transmission_error(mesh);
output pressure := gears.max_contact_pressure(mesh);
output head_force := gears.bearing_force(head, \"radial\");
output tail_force := gears.bearing_force(tail, \"radial\");
output offset := gears.alignment_error(mesh, \"offset\");
output pinion_axial := gears.alignment_error(mesh, \"first_axial\");
output gear_axial := gears.alignment_error(mesh, \"second_axial\");
output shaft_angle := gears.shaft_angle_error(mesh);
output ux := gears.displacement(pinion, \"x\");
output uy := gears.displacement(pinion, \"y\");
output uz := gears.displacement(pinion, \"z\");
output turned := gears.rotation(pinion, \"y\");
output gx := gears.displacement(gear, \"x\");
output gy := gears.displacement(gear, \"y\");
output gz := gears.displacement(gear, \"z\");
output gear_turned := gears.rotation(gear, \"y\");
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"analytic\", error_estimates = \"none\");
"
    )
    .expect("written");
    text
}

#[test]
fn a_bevel_gear_on_a_rigid_shaft_is_one_with_bearings_of_its_own() {
    let (on_shaft, alone) = (means(&bevel_pair(true)), means(&bevel_pair(false)));
    for name in ["error", "pressure", "head_force", "tail_force"] {
        close(name, on_shaft[name], alone[name], 1e-6);
    }
}

/// The axis of the pinion is e3 and its teeth are at negative z; those of the gear are at positive
/// x. The offset is along e2, and both axes pass the origin.
#[test]
fn alignment_errors_of_a_bevel_pair_are_displacements_of_its_axes() {
    let found = means(&bevel_pair(false));
    // The axis of the gear is opposite to e1, so that its x direction is e3.
    let near = |name: &str, expected: f64| {
        let error = (found[name] - expected).abs();
        assert!(error <= 1e-9 * expected.abs() + 1e-15, "{name}: {} instead of {expected}", found[name]);
    };
    near("offset", found["uy"] - found["gy"]);
    near("pinion_axial", found["gx"] - found["uz"]);
    near("gear_axial", -found["gz"] - found["ux"]);
    near("shaft_angle", found["turned"] - found["gear_turned"]);
}

/// A pair whose pinion is loaded by itself or through a clutch, in some direction of the line of
/// centres.
fn driven_pair(moment: &str, rest: &str, direction: &str) -> String {
    format!(
        "{GEARS}
var pinion = gears.body(
    \"pinion\", small, free = [\"theta_z\"], moment = {moment}, frame := Rotate(1500 rpm * Time, e3));
var wheel = gears.body(
    \"wheel\", large, frame := Rotate(-1500 rpm * 25 / 47 * Time, e3) * Translate(distance * {direction}));
var mesh = gears.mesh(pinion, wheel, contact_slices = 3, contact_cells = 8{rest}
output error := gears.transmission_error(mesh);
output force := gears.mesh_force(mesh);
analyze(\"quasi_static\", over = gears.times(0.3 ms, 0.5 ms, 2), fidelity = \"analytic\", error_estimates = \"none\");
"
    )
}

/// Contact grids have the size of the load, wherever it acts.
#[test]
fn a_load_through_a_clutch_is_the_same_as_on_the_gear() {
    for torque in ["120", "-120"] {
        let on_gear = means(&driven_pair(&format!("{torque} N*m * e3"), ");", "e1"));
        let clutch = format!(
            ", torque_on_first = -{torque} * 1 N*m);
var motor = gears.rigid_body(
    \"motor\", free = [\"theta_z\"], moment = {torque} N*m * e3, frame := Rotate(1500 rpm * Time, e3));
gears.bearing(\"clutch\", motor, to = pinion, torsional_stiffness = 1e7 N*m/rad);"
        )
        .replace("--", "");
        for direction in ["e1", "e2", "(0.6 * e1 + 0.8 * e2)"] {
            let found = means(&driven_pair("0 N*m * e3", &clutch, direction));
            // The teeth touch at another phase of the same mesh.
            let tolerance = if direction == "e1" { 2e-3 } else { 0.1 };
            for name in ["error", "force"] {
                close(&format!("{torque} N*m, {direction}, {name}"), found[name], on_gear[name], tolerance);
            }
        }
    }
}

/// A planetary set that the sun drives, with the torque on the sun or on the carrier.
#[test]
fn a_torque_on_the_carrier_loads_a_planetary_set_as_one_on_the_sun() {
    let set = |loads: &str| {
        format!(
            "import gears;
import transmission;
units mm_N_s;
function blank(in count) {{
    return gears.external(count, module = 2 mm, face_width = 20 mm, tooth_thickness = 3.08 mm);
}}
var carrier = transmission.rotor(\"carrier\", free = [\"theta_z\"]);
var sun = transmission.rotor(\"sun\", gears = [transmission.gear(\"sun gear\", blank(30))], free = [\"theta_z\"]);
var ring = transmission.rotor(
    \"ring\", free = [],
    gears = [transmission.gear(\"ring gear\", gears.internal(
        72, module = 2 mm, face_width = 20 mm, tooth_thickness = 3.08 mm, minor_diameter = 140.6 mm))]);
var planets = transmission.planets(\"planet\", blank(21), carrier, 51 mm, free = [\"u_x\", \"u_y\", \"theta_z\"]);
var rotors = [carrier, sun, ring];
for (planet in planets) push(rotors, planet);
var meshes = transmission.planet_meshes(planets, \"sun gear\", contact_slices = 2, contact_cells = 5);
for (mesh in transmission.planet_meshes(
    planets, \"ring gear\", internal = TRUE, contact_slices = 2, contact_cells = 5)) push(meshes, mesh);
var box = transmission.assemble(
    rotors, meshes = meshes, speeds = [transmission.Speed(sun, 1000 rpm), transmission.Speed(ring, 0 rpm)], {loads});
function pin(in name: String, in body: Body, in to: Body, in at: Vector(Length)) {{
    return gears.bearing(name, body, to = to, at = at, radial_stiffness = 3e8 N/m);
}}
for (planet in planets)
    transmission.connect(
        box, \"pin of {{planet.rotor.name}}\", pin, planet, at = 0 mm, to = transmission.body(box, carrier));
output lag := transmission.transmission_error(box, sun, carrier);
output force := gears.mesh_force(box.meshes[1]);
output pressure := gears.max_contact_pressure(box.meshes[4]);
analyze(\"quasi_static\", over = gears.times(0.3 ms, 0.5 ms, 2), fidelity = \"analytic\", error_estimates = \"none\");
"
        )
    };
    let on_sun = means(&set("torques = [transmission.Torque(sun, 90 N*m)], reactions = [carrier]"));
    let on_carrier = means(&set("torques = [transmission.Torque(carrier, -306 N*m)], reactions = [sun]"));
    for (name, expected) in &on_sun {
        // The ratio of the torques varies with the transmission error.
        close(name, on_carrier[name], *expected, 0.02);
    }
}
