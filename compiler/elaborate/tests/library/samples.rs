//! Scenes for calls of library functions, and arguments that are valid in them.

/// A pair of spur gears on their frames, and one object of every other kind.
pub const SCENE: &str = r#"
import gears;
function same(in x) { return x; }
var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);
var shaper = gears.shaper(teeth = 20, module = 2 mm, tip_radius = 0.2 mm);
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var rim = gears.simple_rim(diameter = 30 mm, inner_diameter = 20 mm);
var outer_rim = gears.outer_rim(diameter = 130 mm, outer_diameter = 150 mm);
var pinion_gear = gears.external(teeth = 20, rack = rack, face_width = 10 mm, outer_diameter = 44 mm,
    root_diameter = 35 mm, material = steel, rim = rim, tooth_thickness = 3.1 mm);
var ring_gear = gears.internal(teeth = 60, shaper = shaper, face_width = 10 mm, minor_diameter = 116.4 mm,
    root_diameter = 125 mm, material = steel, rim = outer_rim, tooth_thickness = 3.1 mm);
function at(in radius: Length, in angle: Number, in z: Length) {
    return radius * cos(angle * rad) * e1 + radius * sin(angle * rad) * e2 + z * e3;
}
function flank(in side) {
    return [[at(18 mm + 0.5 mm * k, side * (0.09 - 0.006 * k), z) for k in 0 .. 9] for z in [-5 mm, 0 mm, 5 mm]];
}
function fillet(in side) {
    return [[at(18 mm - 0.6 mm * sin(k * pi / 16), side * (0.13 - 0.04 * cos(k * pi / 16)), z) for k in 0 .. 9]
        for z in [-5 mm, 0 mm, 5 mm]];
}
var lubrication = gears.lubrication("ISO VG 220", temperature = 70, roughness = 0.6 um);
var speed = 1000 rpm;
var member = gears.lumped_member(1 kg, 1e-3 kg*m^2, 20 mm, 1e8 N/m);
var planet_member = gears.lumped_member(1 kg, 1e-3 kg*m^2, 20 mm);
var modes = gears.lumped_planetary(member, member, member, planet_member, 1e8 N/m, 1e8 N/m, 1e8 N/m, 20 deg, 20 deg);
"#;

/// The scene of functions of `iso21771`.
pub const GEAR_DATA: &str = r#"
import gears;
import iso21771;
var pinion_gear = gears.external(24, normal_module = 3 mm, face_width = 30 mm);
var mesh = gears.pair(pinion_gear, pinion_gear, center_distance = 72 mm, torque = 10 N*m, speed = 1000 rpm).mesh;
function same(in x) { return x; }
var gear_data = iso21771.gear_data(24, 30 mm, normal_module = 3 mm);
var pair_data = iso21771.pair_data(gear_data, gear_data);
"#;

/// Two gears in mesh, with a bearing and a gauge.
pub const PAIR: &str = r#"
var pinion = gears.body("pinion", pinion_gear, free = ["theta_z"], moment = 10 N*m * e3, frame := Rotate(speed * Time, e3));
var wheel = gears.body("wheel", pinion_gear, frame := Rotate(-speed * Time, e3) * Translate(40 mm * e1));
var housing = gears.rigid_body("housing", free = ["u_x", "u_y"], mass = 1 kg, frame := Translate(1 m * e1));
var bearing = gears.bearing("seat", housing, radial_stiffness = 1e8 N/m);
var mesh = gears.mesh(pinion, wheel, coast_side_contact = TRUE, lubrication = lubrication);
var gauge = gears.gauge(pinion);
output error := gears.transmission_error(mesh);
"#;

/// A shaft on two bearings.
pub const SHAFT: &str = r#"
var shaft = gears.shaft("shaft", [gears.shaft_segment(length = 80 mm, diameter = 30 mm)], steel,
    prescribed_rotation_at = 0 mm, frame := Translate(2 m * e1));
gears.bearing("left", shaft, at = 10 mm * e3, radial_stiffness = 1e8 N/m, axial_stiffness = 1e8 N/m);
gears.bearing("right", shaft, at = 70 mm * e3, radial_stiffness = 1e8 N/m);
"#;

/// A rolling bearing.
pub const ROLLING: &str = r#"
var rolling = gears.ball_bearing("rolling", housing, count = 8, ball_diameter = 10 mm, pitch_diameter = 50 mm);
"#;

/// Bodies that may be meshed: those of [`PAIR`] are.
pub const MESHLESS: &str = r#"
var sun_like = gears.body("third", pinion_gear, free = ["theta_z"], moment = 10 N*m * e3, frame := Rotate(speed * Time, e3) * Translate(1 m * e2));
var planet_like = gears.body("fourth", pinion_gear, frame := Rotate(-speed * Time, e3) * Translate(40 mm * e1 + 1 m * e2));
"#;

/// Returns a value of a type in [`SCENE`].
pub fn sample_of(ty: &str) -> Option<String> {
    let known = match ty {
        "Rack" => "rack",
        "Shaper" => "shaper",
        "Material" => "steel",
        "Modification" => "gears.profile_slope(deviation = 5 um)",
        "Rim" => "rim",
        "Gear" | "gears.Gear" => "pinion_gear",
        "Body" => "pinion",
        "Mesh" | "gears.Mesh" => "mesh",
        "Gauge" => "gauge",
        "Lubrication" => "lubrication",
        "Bearing" => "bearing",
        "Positions" => "gears.mesh_cycle(mesh, 2)",
        "Modes" => "modes",
        "LumpedMember" => "member",
        "Array(TimeRange)" => "[gears.time_range(1 ms, step = 0.1 ms)]",
        "Symbolic(Transform)" => "Translate(1 mm * e1)",
        "BasicRack" => "iso21771.BasicRack()",
        "GearData" => "gear_data",
        "PairData" => "pair_data",
        "PinionCutter" => "iso21771.PinionCutter(20, 68 mm)",
        "Limit" => "\"upper\"",
        "Extreme" => "\"maximum\"",
        "Member" => "\"second\"",
        "PathPoint" => "\"B\"",
        "String" => "\"x\"",
        _ => return None,
    };
    Some(known.into())
}

/// Returns a value of a parameter of `iso21771`, which has the same meaning in every function.
pub fn sample_of_gear_data(parameter: &str) -> Option<String> {
    let known = match parameter {
        "angle" => "20 deg",
        "value" => "0.01 rad",
        "diameter" => "74 mm",
        "radius" => "10 mm",
        "thickness" => "5 mm",
        "ball" | "pin" => "5.5 mm",
        "center_distance" => "72 mm",
        "face_width" => "30 mm",
        "measured" => "80 mm",
        "teeth" => "24",
        _ => return None,
    };
    Some(known.into())
}

/// Values that do not follow from types, as (function, parameter, value).
pub const SAMPLES: &[(&str, &str, &str)] = &[
    ("mesh_part", "group", "\"walls\""),
    ("node_set", "name", "\"feet\""),
    ("node", "label", "\"1\""),
    ("nearest_node", "point", "0 mm * e1"),
    ("cylinder_region", "center", "0 mm * e1"),
    ("cylinder_region", "axis", "e3"),
    ("cylinder_region", "radius", "20 mm"),
    ("cylinder_region", "from", "0 mm"),
    ("cylinder_region", "to", "10 mm"),
    ("plane_region", "point", "0 mm * e1"),
    ("plane_region", "normal", "e3"),
    ("box_region", "lowest", "0 mm * e1"),
    ("box_region", "highest", "1 mm * (e1 + e2 + e3)"),
    ("sphere_region", "center", "0 mm * e1"),
    ("sphere_region", "radius", "1 mm"),
    ("sphere_field", "radius", "1 m"),
    ("hemisphere_field", "radius", "1 m"),
    ("box_field", "distance", "1 m"),
    ("plane_field", "corner", "1 m * e1"),
    ("plane_field", "first_edge", "1 m * e2"),
    ("plane_field", "second_edge", "1 m * e3"),
    ("carrier", "hub", "wheel"),
    ("carrier", "planets", "3"),
    ("carrier", "material", "steel"),
    ("carrier", "pin_circle_diameter", "120 mm"),
    ("carrier", "pin_diameter", "24 mm"),
    ("carrier", "outside_diameter", "176 mm"),
    ("carrier", "bore_diameter", "50 mm"),
    ("carrier", "thickness", "16 mm"),
    ("carrier", "gap", "30 mm"),
    ("ball_bearing", "body", "housing"),
    ("ball_bearing", "count", "8"),
    ("ball_bearing", "ball_diameter", "10 mm"),
    ("ball_bearing", "pitch_diameter", "50 mm"),
    ("angular_contact_bearing", "body", "housing"),
    ("angular_contact_bearing", "count", "8"),
    ("angular_contact_bearing", "ball_diameter", "10 mm"),
    ("angular_contact_bearing", "pitch_diameter", "50 mm"),
    ("angular_contact_bearing", "contact_angle", "25 deg"),
    ("four_point_bearing", "body", "housing"),
    ("four_point_bearing", "count", "8"),
    ("four_point_bearing", "ball_diameter", "10 mm"),
    ("four_point_bearing", "pitch_diameter", "50 mm"),
    ("four_point_bearing", "contact_angle", "35 deg"),
    ("cylindrical_roller_bearing", "body", "housing"),
    ("cylindrical_roller_bearing", "count", "12"),
    ("cylindrical_roller_bearing", "roller_diameter", "8 mm"),
    ("cylindrical_roller_bearing", "roller_length", "12 mm"),
    ("cylindrical_roller_bearing", "pitch_diameter", "52 mm"),
    ("needle_bearing", "body", "housing"),
    ("needle_bearing", "count", "12"),
    ("needle_bearing", "roller_diameter", "8 mm"),
    ("needle_bearing", "roller_length", "12 mm"),
    ("needle_bearing", "pitch_diameter", "52 mm"),
    ("tapered_roller_bearing", "body", "housing"),
    ("tapered_roller_bearing", "count", "12"),
    ("tapered_roller_bearing", "roller_diameter", "8 mm"),
    ("tapered_roller_bearing", "roller_length", "12 mm"),
    ("tapered_roller_bearing", "pitch_diameter", "52 mm"),
    ("tapered_roller_bearing", "contact_angle", "15 deg"),
    ("spherical_roller_bearing", "body", "housing"),
    ("spherical_roller_bearing", "count", "12"),
    ("spherical_roller_bearing", "roller_diameter", "8 mm"),
    ("spherical_roller_bearing", "roller_length", "12 mm"),
    ("spherical_roller_bearing", "pitch_diameter", "52 mm"),
    ("spherical_roller_bearing", "contact_angle", "10 deg"),
    ("catalogue_bearing", "body", "housing"),
    ("catalogue_bearing", "bore", "30 mm"),
    ("catalogue_bearing", "outside_diameter", "62 mm"),
    ("catalogue_bearing", "width", "16 mm"),
    ("catalogue_bearing", "dynamic_rating", "20.8 kN"),
    ("catalogue_bearing", "static_rating", "11.2 kN"),
    ("max_bearing_pressure", "bearing", "rolling"),
    ("max_rolling_element_load", "bearing", "rolling"),
    ("rolling_element_load", "bearing", "rolling"),
    ("loaded_rolling_elements", "bearing", "rolling"),
    ("bearing_static_safety", "bearing", "rolling"),
    ("bearing_life", "bearing", "rolling"),
    ("modified_bearing_life", "bearing", "rolling"),
    ("bearing_friction_torque", "bearing", "rolling"),
    ("bearing_friction_torque", "viscosity", "30 mm^2/s"),
    ("bearing_friction_loss", "bearing", "rolling"),
    ("bearing_friction_loss", "viscosity", "30 mm^2/s"),
    ("rolling_element_load", "element", "1"),
    ("modified_bearing_life", "viscosity_ratio", "1"),
    ("shaft_segment", "length", "20 mm"),
    ("shaft_segment", "diameter", "30 mm"),
    ("shaft", "segments", "[gears.shaft_segment(length = 80 mm, diameter = 30 mm)]"),
    ("shaft", "prescribed_rotation_at", "0 mm"),
    ("mount", "on", "shaft"),
    ("mount", "at", "40 mm"),
    ("shaft_disc", "mass", "1 kg"),
    ("shaft_disc", "inertia", "1e-3 kg*m^2"),
    ("shaft_displacement", "shaft", "shaft"),
    ("shaft_displacement", "at", "20 mm"),
    ("shaft_rotation", "shaft", "shaft"),
    ("shaft_rotation", "at", "20 mm"),
    ("shaft_moment", "shaft", "shaft"),
    ("shaft_moment", "at", "20 mm"),
    ("shaft_stress", "shaft", "shaft"),
    ("shaft_stress", "at", "20 mm"),
    ("shaft_load", "shaft", "shaft"),
    ("shaft_load", "at", "20 mm"),
    ("shaft_disc", "shaft", "shaft"),
    ("shaft_disc", "at", "20 mm"),
    ("analyze", "method", "\"quasi_static\""),
    ("analyze", "fidelity", "\"analytic\""),
    ("analyze", "error_estimates", "\"none\""),
    ("interpolate", "xs", "[0 mm, 1 mm, 3 mm]"),
    ("interpolate", "ys", "[0, 1, 4]"),
    ("interpolate", "x", "2 mm"),
    ("material", "youngs_modulus", "206 GPa"),
    ("material", "poissons_ratio", "0.3"),
    ("external", "rack", "rack"),
    ("internal", "shaper", "shaper"),
    ("rack", "module", "2 mm"),
    ("rack", "tip_radius", "0.5 mm"),
    ("with_protuberance", "protuberance", "0.1 mm"),
    ("shaper", "teeth", "20"),
    ("shaper", "module", "2 mm"),
    ("shaper", "tip_radius", "0.2 mm"),
    ("simple_rim", "diameter", "30 mm"),
    ("simple_rim", "inner_diameter", "20 mm"),
    ("pair", "torque", "10 N*m"),
    ("outer_rim", "diameter", "130 mm"),
    ("outer_rim", "outer_diameter", "150 mm"),
    ("webbed_rim", "diameter", "30 mm"),
    ("webbed_rim", "inner_diameter", "26 mm"),
    ("webbed_rim", "bore_diameter", "10 mm"),
    ("webbed_rim", "web_thickness", "4 mm"),
    ("disc_web", "diameter", "30 mm"),
    ("disc_web", "inner_diameter", "26 mm"),
    ("disc_web", "bore_diameter", "10 mm"),
    ("disc_web", "web_thickness", "4 mm"),
    ("splined", "teeth", "8"),
    ("tip_relief", "depth", "10 um"),
    ("tip_relief", "start_roll_angle", "0.5 rad"),
    ("root_relief", "depth", "10 um"),
    ("root_relief", "start_roll_angle", "0.2 rad"),
    ("profile_crown", "depth", "5 um"),
    ("lead_crown", "depth", "5 um"),
    ("end_relief", "depth", "5 um"),
    ("end_relief", "length", "2 mm"),
    ("twist", "amount", "5 um"),
    ("modification_amount", "roll_angle", "0.4 rad"),
    ("profile_table", "roll_angles", "[0.1 rad, 0.3 rad, 0.6 rad]"),
    ("profile_table", "depths", "[0 um, 1 um, 5 um]"),
    ("lead_table", "axial_positions", "[-5 mm, 0 mm, 5 mm]"),
    ("lead_table", "depths", "[3 um, 0 um, 3 um]"),
    ("topography", "roll_angles", "[0.1 rad, 0.3 rad, 0.6 rad]"),
    ("topography", "axial_positions", "[-5 mm, 5 mm]"),
    ("topography", "depths", "[0 um, 1 um, 2 um, 3 um, 4 um, 5 um]"),
    ("topography_of_points", "roll_angles", "[0.1 rad, 0.6 rad, 0.1 rad, 0.6 rad]"),
    ("topography_of_points", "axial_positions", "[-5 mm, -5 mm, 5 mm, 5 mm]"),
    ("topography_of_points", "depths", "[0 um, 1 um, 2 um, 3 um]"),
    ("profile_slope", "deviation", "5 um"),
    ("helix_slope", "deviation", "5 um"),
    ("external", "teeth", "20"),
    ("external", "face_width", "10 mm"),
    ("external", "outer_diameter", "44 mm"),
    ("external", "root_diameter", "35 mm"),
    ("internal", "teeth", "60"),
    ("internal", "face_width", "10 mm"),
    ("internal", "minor_diameter", "116.4 mm"),
    ("internal", "root_diameter", "125 mm"),
    ("internal", "rim", "outer_rim"),
    ("tabulated_gear", "teeth", "20"),
    ("tabulated_gear", "flanks", "[flank(1), flank(-1)]"),
    ("tabulated_gear", "fillets", "[fillet(1), fillet(-1)]"),
    ("body", "name", "\"another\""),
    ("rigid_body", "name", "\"another\""),
    ("bearing", "name", "\"another\""),
    ("bearing", "body", "housing"),
    ("bearing", "radial_stiffness", "1e8 N/m"),
    ("mesh", "first", "sun_like"),
    ("mesh", "second", "planet_like"),
    ("mesh_cycle", "steps", "3"),
    ("times", "to", "1 ms"),
    ("times", "count", "3"),
    ("time_range", "duration", "1 ms"),
    ("time_range", "step", "0.1 ms"),
    ("impulse", "at", "1 ms"),
    ("impulse", "duration", "1 ms"),
    ("spectrum", "output", "\"error\""),
    ("spectrogram", "output", "\"error\""),
    ("spectrogram", "segment", "1 ms"),
    ("order_map", "output", "\"error\""),
    ("order_map", "shaft", "pinion"),
    ("transfer_function", "output", "\"error\""),
    ("transfer_function", "from", "0 s"),
    ("transfer_function", "momentum", "1"),
    ("torque_from_power", "power", "1 kW"),
    ("torque_from_power", "speed", "1000 rpm"),
    ("pair", "first_name", "\"a\""),
    ("pair", "second_name", "\"b\""),
    ("planetary", "sun", "pinion_gear"),
    ("planetary", "planet", "pinion_gear"),
    ("planetary", "ring", "ring_gear"),
    ("planetary", "center_distance", "40 mm"),
    ("planetary", "sun_speed", "1000 rpm"),
    ("planetary", "sun_torque", "10 N*m"),
    ("planetary", "planets", "4"),
    ("natural_frequency", "mode", "1"),
    ("whirl_frequency", "mode", "1"),
    ("whirl_sense", "mode", "1"),
    ("campbell_diagram", "highest_speed", "3000 rpm"),
    ("forced_response", "highest_speed", "3000 rpm"),
    ("modal_energy_share", "mode", "1"),
    ("mode_type", "mode", "1"),
    ("mode_type", "planets", "[wheel]"),
    ("lumped_natural_frequency", "mode", "1"),
    ("lumped_natural_frequency", "planets", "[wheel]"),
    ("lumped_natural_frequency", "sun_meshes", "[mesh]"),
    ("lumped_natural_frequency", "ring_meshes", "[mesh]"),
    ("tooth_load", "tooth", "0"),
    ("lubrication", "oil", "\"ISO VG 220\""),
    ("lubrication", "temperature", "70"),
    ("lubrication", "roughness", "0.6 um"),
    ("friction_loss", "coefficient", "0.05"),
    ("efficiency", "coefficient", "0.05"),
    ("spline_tooth_force", "tooth", "0"),
    ("lumped_member", "mass", "1 kg"),
    ("lumped_member", "inertia", "1e-3 kg*m^2"),
    ("lumped_member", "radius", "20 mm"),
    ("lumped_planetary", "planet", "planet_member"),
    ("lumped_planetary", "planet_bearing_stiffness", "1e8 N/m"),
    ("lumped_planetary", "sun_mesh_stiffness", "1e8 N/m"),
    ("lumped_planetary", "ring_mesh_stiffness", "1e8 N/m"),
    ("lumped_planetary", "sun_pressure_angle", "20 deg"),
    ("lumped_planetary", "ring_pressure_angle", "20 deg"),
    ("mode_energy", "mode", "0"),
    ("gear_data", "normal_module", "3 mm"),
];
