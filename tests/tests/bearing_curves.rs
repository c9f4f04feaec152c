//! Bearings with load curves as models describe them: against the curve itself, against linear
//! bearings, and their stiffness in natural frequencies.

use crate::rolling_bearings::{close, helical, solved};
use calyx::{Engine, Module};

/// A block of 2 kg on one bearing, under a force.
fn block(bearing: &str, force: &str) -> String {
    format!(
        "import gears;
units mm_N_s;
var body = gears.rigid_body(\"block\", frame := Translate(0 mm * e3), mass = 2 kg, force = {force},
    free = [\"u_x\", \"u_y\", \"u_z\"]);
var bearing = gears.bearing(\"bearing\", body, {bearing});
output radial := gears.bearing_deflection(bearing, \"radial\");
output x := gears.bearing_deflection(bearing, \"x\");
output y := gears.bearing_deflection(bearing, \"y\");
output z := gears.bearing_deflection(bearing, \"axial\");
output force := gears.bearing_force(bearing, \"radial\");
output axial := gears.bearing_force(bearing, \"axial\");
output mode_1 := gears.natural_frequency(1);
output mode_2 := gears.natural_frequency(2);
output mode_3 := gears.natural_frequency(3);
analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"analytic\");
"
    )
}

/// The force at a point of the curve deflects the bearing by the displacement of this point, in the
/// direction of the force, from the unloaded position; and frequencies are those of the slopes.
#[test]
fn a_load_at_a_point_deflects_by_its_displacement() {
    let curves = "radial_displacements = [0, 10, 20, 30, 40] um, radial_forces = [0, 10, 40, 90, 160] kN,
        axial_displacements = [-20, 0, 5, 30] um, axial_forces = [-8, 0, 0, 50] kN, unloaded_displacement = 3 um * e1";
    let angle: f64 = 0.7;
    let found = solved(&block(
        curves,
        &format!("40 kN * (cos({angle} rad) * e1 + sin({angle} rad) * e2) - 8 kN * e3"),
    ));
    close("x", found["x"][0], 2e-5 * angle.cos() + 3e-6, 1e-9, 0.0);
    close("y", found["y"][0], 2e-5 * angle.sin(), 1e-9, 0.0);
    close("z", found["z"][0], -2e-5, 1e-9, 0.0);
    close("force", found["force"][0], 4e4, 1e-9, 0.0);
    close("axial", found["axial"][0].abs(), 8e3, 1e-9, 0.0);
    // Across the load the bearing has its secant stiffness, along it the slope of the curve, which
    // is the harmonic mean of those on both sides.
    let along = 2.0 * 3e9 * 5e9 / (3e9 + 5e9);
    // At the first point, that of the parabola through the secants 4e8 and 0 N/m.
    let axial = (2.0 * 20.0 + 5.0) * 4e8 / (20.0 + 5.0);
    let mut expected = [along, 4e4 / 2e-5, axial].map(|k: f64| (k / 2.0).sqrt() / std::f64::consts::TAU);
    expected.sort_by(f64::total_cmp);
    for (mode, expected) in (1..).zip(expected) {
        close("frequency", found[&format!("mode_{mode}")][0], expected, 1e-9, 0.0);
    }
}

/// A straight curve is a linear bearing; one with a clearance is a linear bearing with this
/// clearance, within the direction of the polygon of the latter.
#[test]
fn a_straight_curve_is_a_linear_bearing() {
    let pair = |radial: &str, axial: &str| {
        let bearing = |name: &str, at: f64, axial: &str| {
            format!("var {name} = gears.bearing(\"{name}\", pinion, at = {at} mm * e3, {radial}{axial});\n")
        };
        let bearings = bearing("near", 40.0, axial) + &bearing("far", 120.0, "");
        let model = helical(&bearings, 100.0, 0.0);
        let elements = ["pressure", "largest", "first", "loaded", "safety", "life"];
        let kept = model
            .lines()
            .filter(|line| !elements.iter().any(|name| line.starts_with(&format!("output {name} "))));
        solved(&kept.collect::<Vec<_>>().join("\n"))
    };
    let linear = pair("radial_stiffness = 4e8 N/m", ", axial_stiffness = 2e8 N/m");
    let curve = pair(
        "radial_displacements = [0, 1, 5] um, radial_forces = [0, 400, 2000] N",
        ", axial_displacements = [0, 20] um, axial_forces = [0, 4] kN",
    );
    for (name, expected) in &linear {
        for (found, expected) in curve[name].iter().zip(expected) {
            close(name, *found, *expected, 1e-8, 0.0);
        }
    }
    let clearance =
        pair("radial_stiffness = 4e8 N/m, radial_clearance = 20 um", ", axial_stiffness = 2e8 N/m");
    // 4e8 N/m beyond 10 um; the bend of the monotone cubic is between 10 and 10.01 um.
    let curve = pair(
        "radial_displacements = [0, 10, 10.01, 20] um, radial_forces = [0, 0, 4, 4000] N",
        ", axial_displacements = [0, 20] um, axial_forces = [0, 4] kN",
    );
    for (name, tolerance) in
        [("near_radial", 0.01), ("far_radial", 0.01), ("radial", 0.02), ("transmission_error", 0.01)]
    {
        close(name, curve[name][1], clearance[name][1], tolerance, 0.0);
    }
    assert!(curve["radial"][0] > linear["radial"][0] + 9e-6);
}

/// Without load, a bearing has the slope of its curve at zero. A clearance has none.
#[test]
fn an_unloaded_bearing_has_the_first_slope() {
    let curves = "radial_displacements = [0, 10, 20] um, radial_forces = [0, 1, 4] kN,
        axial_displacements = [0, 10] um, axial_forces = [0, 3] kN";
    let found = solved(&block(curves, "0 N * e1"));
    // Slope at the start of a parabola through the first secants, 1e8 and 3e8 N/m.
    let radial = (3.0 * 1e8 - 3e8) / 2.0;
    assert_eq!(radial, 0.0);
    let curves = curves.replace("[0, 1, 4] kN", "[0, 2, 5] kN");
    let found_stiffer = solved(&block(&curves, "0 N * e1"));
    let radial: f64 = (3.0 * 2e8 - 3e8) / 2.0;
    for mode in 1..=2 {
        let expected = (radial / 2.0).sqrt() / std::f64::consts::TAU;
        close("frequency", found_stiffer[&format!("mode_{mode}")][0], expected, 1e-9, 0.0);
        assert!(found[&format!("mode_{mode}")][0] > 0.0);
    }
}

/// Rotations are assumed to be small: a run warns of a body that tilts by more than 5 mrad.
#[test]
fn large_tilts_are_reported() {
    let warnings = |moment: f64| {
        let text = format!(
            "import gears;
units SI;
var body = gears.rigid_body(\"hub\", free = [\"theta_x\", \"theta_y\"], moment = {moment} N*m * e1, frame := Translate(0 m * e3));
var bearing = gears.bearing(\"soft\", body, radial_stiffness = 1e8 N/m, tilting_stiffness = 1e3 N*m/rad);
output tilt := gears.bearing_tilt(bearing, \"x\");
analyze(\"quasi_static\", over = gears.times(to = 0 s, count = 1), fidelity = \"analytic\");"
        );
        let module = Module::from_text(&Engine::default(), "tilt.cx", &text).expect("the model compiles");
        let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error:?}"));
        results.warnings()
    };
    assert_eq!(warnings(4.0), Vec::<String>::new());
    let found = warnings(6.0);
    assert!(found.len() == 1 && found[0].contains("the load tilts \"hub\" by more than 5 mrad"), "{found:?}");
}
