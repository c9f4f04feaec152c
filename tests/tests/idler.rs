//! An idler with a small bore: the torques of its meshes cancel, so nothing twists the material
//! around the bore, and bore and support hardly affect the results.

use crate::rolling_bearings::solved;
use std::collections::BTreeMap;

fn results(bore: &str, diameter: f64, fidelity: &str) -> BTreeMap<String, [f64; 2]> {
    solved(&format!(
        "import gears;
units mm_N_s;
var rack = gears.rack(module = 2.5 mm, tip_radius = 0.8 mm);
var steel = gears.material(youngs_modulus = 206 GPa, poissons_ratio = 0.3);
function gear(in teeth, in rim: gears.Rim = none) {{
    return gears.external(teeth, rack = rack, face_width = 20 mm, material = steel, rim = rim);
}}
var small = gears.simple_rim(diameter = 52 mm, inner_diameter = {diameter} mm, bore = \"{bore}\");
var distance = 60.05 mm;
var input = gears.body(\"input\", gear(24), free = [\"theta_z\"], moment = 300 N*m * e3,
    frame := Rotate(100 rpm * Time, e3));
var idler = gears.body(\"idler\", gear(24, small), free = [\"theta_z\"],
    frame := Rotate(-100 rpm * Time, e3) * Translate(distance * e1));
var output_gear = gears.body(\"output\", gear(24), frame := Rotate(100 rpm * Time, e3) * Translate(2 * distance * e1));
var first = gears.mesh(input, idler);
var second = gears.mesh(idler, output_gear);
output first_error := gears.transmission_error(first);
output second_error := gears.transmission_error(second);
output stress := gears.max_root_stress(idler);
analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"{fidelity}\", error_estimates = \"none\");
"
    ))
}

/// If its meshes were independent, the transmission errors with a bore of 6 mm would be 2.5 times
/// as large: each mesh alone would twist that material.
#[test]
fn a_small_bore_has_no_effect_on_an_idler() {
    for fidelity in ["analytic", "plane", "medium"] {
        let small = results("rigid", 6.0, fidelity);
        // The force on the bore does not cancel. It deforms a free bore, and displaces the idler by
        // the more the smaller its bore is.
        for (other, tolerance) in
            [(results("free", 6.0, fidelity), 5e-3), (results("rigid", 30.0, fidelity), 0.25)]
        {
            for (name, [expected, _]) in &other {
                let [found, _] = small[name];
                println!("{fidelity}, {name}: {found:e}, {expected:e}");
                assert!(
                    (found / expected - 1.0).abs() < tolerance,
                    "{fidelity}, {name}: {found:e}, {expected:e}"
                );
            }
        }
    }
}
