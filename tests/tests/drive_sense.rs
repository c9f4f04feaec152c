//! Drive flanks of gears that transmit the load of earlier meshes.

use crate::models::means;

/// A shaft that one mesh drives loads any number of mates on the same flanks, in whatever order the
/// meshes are made.
#[test]
fn a_driven_shaft_loads_all_its_mates_on_the_same_flanks() {
    for speed in ["600 rpm", "-600 rpm"] {
        let text = format!(
            "import gears;
units mm_N_s;
function blank(in teeth) {{
    return gears.external(teeth, module = 2 mm, face_width = 20 mm, tooth_thickness = 3.05 mm);
}}
var speed = {speed};
var pinion = gears.body(
    \"pinion\", blank(20), free = [\"theta_z\"], moment = (if (speed > 0 rpm) 1 else -1) * 30 N*m * e3,
    frame := Rotate(speed * Time, e3) * Translate(60 mm * e2));
var wheel = gears.body(\"wheel\", blank(40), free = [\"theta_z\"], frame := Rotate(-speed / 2 * Time, e3));
var center = gears.body(
    \"center\", blank(24), free = [\"theta_z\"], frame := Rotate(-speed / 2 * Time, e3) * Translate(40 mm * e3));
gears.bearing(\"shaft\", center, to = wheel, torsional_stiffness = 1e7 N*m/rad);
var first = gears.mesh(pinion, wheel, contact_slices = 2);
var meshes = [];
for (var i = 0; i < 4; i = i + 1) {{
    var angle = 90 deg * i;
    var mate = gears.body(
        \"mate {{i + 1}}\", blank(30), free = [\"theta_z\"],
        frame := Rotate(speed / 2 * 24 / 30 * Time, e3) * Translate(54 mm * (cos(angle) * e1 + sin(angle) * e2) + 40 mm * e3));
    gears.bearing(\"brake {{i + 1}}\", mate, torsional_stiffness = 1e4 N*m/rad);
    push(meshes, gears.mesh(center, mate, contact_slices = 2));
}}
output driving := gears.mesh_force(first);
output f0 := gears.mesh_force(meshes[0]);
output f1 := gears.mesh_force(meshes[1]);
output f2 := gears.mesh_force(meshes[2]);
output f3 := gears.mesh_force(meshes[3]);
analyze(\"quasi_static\", over = gears.times(0 s, 1 ms, 3), fidelity = \"analytic\", error_estimates = \"none\");
"
        );
        let found = means(&text);
        let torque = 60.0 / (0.024 * 20f64.to_radians().cos());
        for mate in ["f0", "f1", "f2", "f3"] {
            let share = found[mate] / torque;
            assert!((share - 0.25).abs() < 0.02, "{speed}, {mate}: {share} of the torque");
        }
    }
}
