//! Helpers shared by several test files.

/// Returns a model with a pair of spur gears, `param torque` and two outputs. `params` declares
/// further params, `analysis` is the statement that runs.
pub fn pair(params: &str, analysis: &str) -> String {
    format!("{HEAD}{params}{GEARS}{analysis}")
}

const HEAD: &str = "import gears;
units mm_N_s;
param torque = 20 N*m in 0 N*m .. 50 N*m;
";

const GEARS: &str = "var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
var rack = gears.rack(module = 2 mm, tip_radius = 0.6 mm);
var blank = gears.external(
    teeth = 24, rack = rack, face_width = 10 mm, outer_diameter = 52 mm, root_diameter = 43 mm, material = steel,
    rim = gears.simple_rim(diameter = 40 mm, inner_diameter = 30 mm));
var pinion = gears.body(\"pinion\", blank, free = [\"theta_z\"], moment = torque * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", blank, frame := Rotate(-60 rpm * Time, e3) * Translate(48.05 mm * e1));
var mesh = gears.mesh(pinion, gear);
/// Lag of the gear.
output transmission_error := gears.transmission_error(mesh);
/// Contact pressure of the flanks.
output max_contact_pressure := gears.max_contact_pressure(mesh);
";
