//! Forced response over the speed: against time integration of the same model, against the closed
//! form of a pair on stiff teeth, in the limit of slow rotation, and refusals.

use crate::models::{codes, solved};
use calyx_runtime::forced_response::ForcedResponse;
use std::f64::consts::TAU;

/// A spur pair whose gear carries a brake torque and rotates freely, at a speed of the pinion, rpm.
fn pair(speed: f64, end: &str) -> String {
    format!(
        "import gears;
units mm_N_s;
var rack = gears.rack(module = 2.54 mm, tip_radius = 0.5 mm);
function blank(in teeth, in bore) {{
    var diameter = teeth * 2.54 mm;
    return gears.external(
        teeth = teeth, rack = rack, tooth_thickness = 3.96 mm, face_width = 25 mm,
        outer_diameter = diameter + 4.6 mm, root_diameter = diameter - 6.1 mm,
        material = gears.material(206 GPa, 0.3, density = 7850 kg/m^3),
        rim = gears.simple_rim(diameter - 14 mm, bore));
}}
var pinion = gears.body(\"pinion\", blank(20, 30 mm), frame := Rotate({speed} rpm * Time, e3));
var gear = gears.body(
    \"gear\", blank(40, 60 mm), free = [\"theta_z\"], moment = 200 N*m * e3, inertia = 0.002 kg*m^2,
    frame := Rotate(-{speed} rpm / 2 * Time, e3) * Translate(76.2 mm * e1));
var mesh = gears.mesh(pinion, gear, coast_side_contact = TRUE, contact_cells = 8);
output error := gears.transmission_error(mesh);
output force := gears.mesh_force(mesh);
output frequency := gears.natural_frequency(1);
{end}"
    )
}

/// The statement that requests the response at two speeds close to each other.
fn request(speed: f64, harmonics: usize, damping: f64) -> String {
    format!(
        "gears.forced_response(mesh, highest_speed = {} rpm, lowest_speed = {speed} rpm, speeds = 2, harmonics = {harmonics}, damping_ratio = {damping});
analyze(\"quasi_static\", over = gears.times(0 s, 60 s / {speed} / 20, 65), fidelity = \"analytic\", error_estimates = \"none\");
",
        speed + 1.0
    )
}

/// Returns the root mean square of the lowest harmonics of values over one period.
fn rms_of_harmonics(values: &[f64], highest: usize) -> f64 {
    let count = values.len() as f64;
    let amplitude = |harmonic: usize| {
        let phase = |k: usize| TAU * (harmonic * k) as f64 / count;
        let part = |of: fn(f64) -> f64| -> f64 {
            values.iter().enumerate().map(|(k, value)| value * of(phase(k))).sum::<f64>() * 2.0 / count
        };
        part(f64::cos).hypot(part(f64::sin))
    };
    (1..=highest).map(|harmonic| 0.5 * amplitude(harmonic).powi(2)).sum::<f64>().sqrt()
}

/// Root mean square of the variation about the mean.
fn rms(values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt()
}

/// Frequency of the mean stiffness, rad/s, from the natural frequencies over a mesh cycle.
fn mean_frequency(rows: &[Vec<f64>]) -> f64 {
    let squares: Vec<f64> = rows.iter().skip(1).map(|row| (TAU * row[2]).powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

/// Below, between and above the resonances, where teeth do not separate, the response agrees with
/// the last mesh cycle of a time integration with the same damping, by which the transient has
/// decayed to 1e-6.
#[test]
fn the_response_agrees_with_time_integration() {
    const DAMPING: f64 = 2000.0;
    for speed in [1800.0, 5000.0, 13_500.0] {
        let cycle = 60.0 / speed / 20.0;
        let cycles = (-2.0 * 1e-6f64.ln() / DAMPING / cycle).ceil() + 1.0;
        let integrated = format!(
            "analyze(\"dynamic\", over = gears.time_ranges([gears.time_range({} s, step = {} s)]), fidelity = \"analytic\", rayleigh_mass = {DAMPING} Hz, error_estimates = \"none\");\n",
            cycles * cycle,
            cycle / 256.0
        );
        let (rows, _) = solved(&pair(speed, &integrated));
        let last = &rows[rows.len() - 256..];
        let column = |k: usize| last.iter().map(|row| row[k]).collect::<Vec<f64>>();
        assert!(column(1).iter().all(|force| *force > 0.0), "teeth separate at {speed} rpm");
        let frequency = mean_frequency(&solved(&pair(speed, &request(speed, 1, 0.0))).0);
        let (_, response) = solved(&pair(speed, &request(speed, 10, 0.5 * DAMPING / frequency)));
        let response = response.expect("a response");
        let at = |kind: &str| {
            response.quantities.iter().position(|quantity| quantity.name.starts_with(kind)).expect("it")
        };
        let [error, torque] =
            ["transmission_error", "tooth_torque"].map(|kind| response.points[0].rms(at(kind)));
        let force = column(1);
        let mean = force.iter().sum::<f64>() / force.len() as f64;
        for (what, found, expected) in
            [("error", error, rms(&column(0))), ("torque", torque / 200.0, rms(&force) / mean)]
        {
            assert!(
                (found / expected - 1.0).abs() < 0.02,
                "{what} at {speed} rpm: {found:e} instead of {expected:e}"
            );
        }
    }
}

/// Near twice the natural frequency the varying stiffness makes the vibration unstable.
#[test]
fn parametric_resonance_is_reported() {
    let growth = |speed: f64, damping: f64| {
        let (rows, response) = solved(&pair(speed, &request(speed, 8, damping)));
        let response = response.expect("a response");
        (mean_frequency(&rows), response.points[0].growth, response.warnings())
    };
    let (frequency, stable, _) = growth(11_000.0, 0.03);
    assert!(stable < 1.0, "{stable}");
    let speed = 2.0 * frequency / TAU * 60.0 / 20.0;
    let (_, grows, warnings) = growth(speed, 0.01);
    assert!(grows > 1.05 && warnings.len() == 1, "{grows} {warnings:?}");
    let (_, damped, warnings) = growth(speed, 0.2);
    assert!(damped < 1.0 && warnings.is_empty(), "{damped} {warnings:?}");
}

/// At low speed the response is the static transmission error, and the mean torque is the load.
#[test]
fn slow_rotation_gives_the_static_transmission_error() {
    let (rows, response) = solved(&pair(1.0, &request(1.0, 16, 0.03)));
    let response = response.expect("a response");
    let values: Vec<f64> = rows.iter().skip(1).map(|row| row[0]).collect();
    let found = response.points[0].rms(0);
    assert!((found / rms(&values) - 1.0).abs() < 5e-3, "{found:e} instead of {:e}", rms(&values));
    let torque = response.points[0].amplitudes[1][0].re;
    assert!((torque.abs() - 200.0).abs() < 1e-6, "{torque}");
}

/// A response belongs to a periodic quasi-static analysis of elastic teeth.
#[test]
fn impossible_responses_are_rejected() {
    let with = |arguments: &str| {
        let request = format!("gears.forced_response(mesh, {arguments});\n");
        codes(&pair(
            1000.0,
            &format!("{request}analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 8));\n"),
        ))
    };
    assert_eq!(with("highest_speed = 9000 rpm"), Vec::<String>::new());
    assert_eq!(with("highest_speed = 100 rpm, lowest_speed = 100 rpm"), ["E0774"]);
    assert_eq!(with("highest_speed = 100 rpm, speeds = 2.5"), ["E0774"]);
    let rigid = "gears.forced_response(mesh, highest_speed = 9000 rpm);
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 8), fidelity = \"rigid\");
";
    assert!(codes(&pair(1000.0, rigid)).contains(&"E0774".to_owned()));
    let dynamic = "gears.forced_response(mesh, highest_speed = 9000 rpm);
analyze(\"dynamic\", over = gears.time_ranges([gears.time_range(1 ms, step = 5 us)]), fidelity = \"analytic\");
";
    assert_eq!(codes(&pair(1000.0, dynamic)), ["E0774"]);
    let periodic = "gears.forced_response(mesh, highest_speed = 9000 rpm);
analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 8), fidelity = \"analytic\");
";
    let unequal =
        pair(1000.0, periodic).replace("face_width = 25 mm", "face_width = 25 mm, pitch_errors = [1 um]");
    assert_eq!(codes(&unequal), ["E0774"]);
}

/// A helical pair on bearings in three dimensions, with the axes of both gears along a direction.
fn helical(orientation: &str, end: &str) -> String {
    format!(
        "import gears;
units mm_N_s;
function blank(in teeth, in hand) {{
    return gears.external(
        teeth, normal_module = 2 mm, helix_angle = 15 deg, hand = hand, face_width = 16 mm,
        modifications = [gears.lead_crown(4 um)]);
}}
function mounted(in name: String, in gear, in frame: Symbolic(Transform) :=, in moment, in turns) {{
    var free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\"];
    if (turns) push(free, \"theta_z\");
    var body = gears.body(name, gear, free = free, moment = moment, frame := frame);
    gears.bearing(name, body, radial_stiffness = 2e8 N/m, axial_stiffness = 1e8 N/m, tilting_stiffness = 1e5 N*m/rad);
    return body;
}}
var place := {orientation};
var axis = direction(place at Time = 0 s, e3);
var pinion = mounted(\"pinion\", blank(23, \"right\"), frame := Rotate(600 rpm * Time, e3) * place, moment = 60 N*m * axis, turns = TRUE);
var gear = mounted(
    \"gear\", blank(38, \"left\"), frame := Rotate(-600 rpm * 23 / 38 * Time, e3) * Translate(63.2 mm * e1) * place,
    moment = 0 N*m * axis, turns = FALSE);
var mesh = gears.mesh(pinion, gear, contact_cells = 4, contact_slices = 3);
output force := gears.mesh_force(mesh);
{end}analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 4), fidelity = \"analytic\", error_estimates = \"none\");
"
    )
}

/// In three dimensions, the response does not depend on the orientation of the axes or on the range
/// of speeds.
#[test]
fn the_response_is_invariant() {
    let request = |highest: f64| {
        format!(
            "gears.forced_response(mesh, highest_speed = {highest} rpm, lowest_speed = 3000 rpm, speeds = 2, harmonics = 3);\n"
        )
    };
    let of = |orientation: &str, highest: f64| {
        solved(&helical(orientation, &request(highest))).1.expect("a response")
    };
    let upright = of("Rotate(0 rad/s * Time, e3)", 9000.0);
    let value = |response: &ForcedResponse, kind: &str, harmonic: usize| {
        let index = response.quantities.iter().position(|quantity| quantity.name.starts_with(kind));
        response.points[0].amplitudes[index.expect("the quantity")][harmonic].norm()
    };
    for (other, tolerance) in [
        (of("Rotate(0 rad/s * Time, e3) * Rotate(90 deg, e2) * Translate(30 mm * e3)", 9000.0), 1e-6),
        (of("Rotate(0 rad/s * Time, e3)", 30_000.0), 2e-2),
    ] {
        for kind in ["transmission_error", "tooth_torque", "bearing_force_z(pinion)"] {
            for harmonic in 1..=2 {
                let (found, expected) = (value(&other, kind, harmonic), value(&upright, kind, harmonic));
                assert!(
                    (found / expected - 1.0).abs() < tolerance,
                    "{kind} {harmonic}: {found:e} {expected:e}"
                );
            }
        }
    }
}

/// A two-stage spur train in the plane: the mesh frequencies have the ratio 8 to 5. A torsional
/// spring is the intermediate shaft, and dampers are the only damping.
fn train(speed: f64, end: &str) -> String {
    format!(
        "import gears;
units mm_N_s;
var rack = gears.rack(module = 2.54 mm, tip_radius = 0.5 mm);
function blank(in teeth, in bore) {{
    var diameter = teeth * 2.54 mm;
    return gears.external(
        teeth = teeth, rack = rack, tooth_thickness = 3.96 mm, face_width = 25 mm,
        outer_diameter = diameter + 4.6 mm, root_diameter = diameter - 6.1 mm,
        material = gears.material(206 GPa, 0.3, density = 7850 kg/m^3),
        rim = gears.simple_rim(diameter - 14 mm, bore));
}}
function damped(in name: String, in body: Body, in damping) {{
    gears.bearing(name, body, torsional_damping = damping);
}}
var input = gears.body(\"input\", blank(20, 30 mm), frame := Rotate({speed} rpm * Time, e3));
var wheel = gears.body(
    \"wheel\", blank(40, 60 mm), free = [\"theta_z\"],
    frame := Rotate(-{speed} rpm / 2 * Time, e3) * Translate(76.2 mm * e1));
var pinion = gears.body(
    \"pinion\", blank(25, 40 mm), free = [\"theta_z\"],
    frame := Rotate(-{speed} rpm / 2 * Time, e3) * Translate(76.2 mm * e1));
var output_gear = gears.body(
    \"output\", blank(50, 60 mm), free = [\"theta_z\"], moment = -300 N*m * e3, inertia = 0.004 kg*m^2,
    frame := Rotate({speed} rpm / 4 * Time, e3) * Translate(171.45 mm * e1));
gears.bearing(\"shaft\", wheel, to = pinion, torsional_stiffness = 4e4 N*m/rad, torsional_damping = 1 N*m*s/rad);
damped(\"wheel damper\", wheel, damping = 3 N*m*s/rad);
damped(\"pinion damper\", pinion, damping = 1 N*m*s/rad);
damped(\"output damper\", output_gear, damping = 15 N*m*s/rad);
var first = gears.mesh(input, wheel, coast_side_contact = TRUE, contact_cells = 8);
var second = gears.mesh(pinion, output_gear, coast_side_contact = TRUE, contact_cells = 8);
output first_error := gears.transmission_error(first);
output second_error := gears.transmission_error(second);
output first_force := gears.mesh_force(first);
output second_force := gears.mesh_force(second);
{end}"
    )
}

/// Two mesh frequencies above the resonances.
#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn two_mesh_frequencies_agree_with_time_integration() {
    agrees_with_time_integration(7000.0);
}

/// Two mesh frequencies between the resonances.
#[test]
#[ignore = "long; part of .ci/full"]
fn two_mesh_frequencies_agree_between_resonances() {
    agrees_with_time_integration(3400.0);
}

/// Compares the response of two meshes at a speed (rpm) with the last common period of a time
/// integration, and its lines with the harmonics of both meshes.
fn agrees_with_time_integration(speed: f64) {
    // Eight cycles of the first mesh are five of the second.
    let cycle = 60.0 / speed / 20.0;
    let integrated = format!(
        "analyze(\"dynamic\", over = gears.time_ranges([gears.time_range({} s, step = {} s)]), fidelity = \"analytic\", error_estimates = \"none\");\n",
        40.0 * cycle,
        cycle / 256.0
    );
    let (rows, _) = solved(&train(speed, &integrated));
    let last = &rows[rows.len() - 8 * 256..];
    let column = |k: usize| last.iter().map(|row| row[k]).collect::<Vec<f64>>();
    assert!(column(2).iter().chain(&column(3)).all(|force| *force > 0.0), "teeth separate at {speed} rpm");
    let request = format!(
        "gears.forced_response(first, highest_speed = {} rpm, lowest_speed = {speed} rpm, speeds = 2, harmonics = 8, damping_ratio = 0);
analyze(\"quasi_static\", over = gears.mesh_cycle(first, 8), fidelity = \"analytic\", error_estimates = \"none\");
",
        speed + 1.0
    );
    let (_, response) = solved(&train(speed, &request));
    let response = response.expect("a response");
    assert!(response.points[0].growth < 1.0, "{}", response.points[0].growth);
    let errors = response.quantities.iter().enumerate();
    let errors: Vec<usize> = errors
        .filter(|(_, quantity)| quantity.name.starts_with("transmission_error"))
        .map(|(index, _)| index)
        .collect();
    for (mesh, &quantity) in errors.iter().enumerate() {
        let (found, expected) = (response.points[0].rms(quantity), rms(&column(mesh)));
        assert!(
            (found / expected - 1.0).abs() < 0.02,
            "mesh {mesh} at {speed} rpm: {found:e} instead of {expected:e}"
        );
    }
    for line in &response.lines {
        // The eighth harmonic of the second mesh is the fifth of the first.
        let own = |mesh: &str| if mesh == "input, wheel" { 20.0 } else { 12.5 };
        let sideband = line.sideband as f64 * own(&line.modulation);
        let order = (line.harmonic as f64 * own(&line.mesh) + sideband).abs();
        assert!((line.order - order).abs() < 1e-9, "{line:?}");
    }
}

/// A planetary set of which sun and planets move on springs, with the speed of the carrier relative
/// to the ring, rpm. The carrier is at rest, or else the ring. The planets are in sequential phase,
/// so that the mesh cycle moves the sun.
fn planetary(speed: f64, carrier_rests: bool, end: &str) -> String {
    let speeds = match carrier_rests {
        true => format!("sun_speed = {speed} rpm * 71 / 25, ring_speed = -{speed} rpm"),
        false => format!("sun_speed = {speed} rpm * 96 / 25"),
    };
    format!(
        "import gears;
units mm_N_s;
var rack = gears.rack(module = 2.5 mm, tip_radius = 0.5 mm);
function blank(in teeth) {{
    var diameter = teeth * 2.5 mm;
    return gears.external(
        teeth = teeth, rack = rack, tooth_thickness = 3.88 mm, face_width = 25 mm,
        outer_diameter = diameter + 5 mm, root_diameter = diameter - 6.25 mm,
        material = gears.material(206 GPa, 0.3, density = 7850 kg/m^3),
        rim = gears.simple_rim(diameter - 12 mm, 0.4 * diameter));
}}
var ring = gears.internal(
    teeth = 71, shaper = gears.shaper(teeth = 23, module = 2.5 mm, tip_radius = 0.5 mm, addendum = 3.1 mm),
    tooth_thickness = 3.88 mm, face_width = 25 mm, minor_diameter = 173 mm, root_diameter = 183.7 mm,
    material = gears.material(206 GPa, 0.3, density = 7850 kg/m^3),
    rim = gears.outer_rim(diameter = 188 mm, outer_diameter = 228 mm));
var set = gears.planetary(
    sun = blank(25), planet = blank(23), ring = ring, center_distance = 60 mm, planets = 3,
    {speeds}, sun_torque = 400 N*m,
    pin_stiffness = 2e8 N/m, pin_damping = 3e3 N*s/m, sun_stiffness = 2e7 N/m, sun_damping = 1e3 N*s/m,
    contact_cells = 8, tip_corner_contact = FALSE, coast_side_contact = TRUE);
gears.bearing(\"damper\", set.sun, torsional_damping = 1 N*m*s/rad);
for (i in 0 .. 3) gears.bearing(\"damper {{i}}\", set.planets[i], to = set.carrier, torsional_damping = 1 N*m*s/rad);
output error := gears.transmission_error(set.sun_meshes[0]);
output sun_x := gears.displacement(set.sun, \"x\");
output sun_y := gears.displacement(set.sun, \"y\");
output forces := [gears.mesh_force(mesh) for mesh in set.sun_meshes];
{end}"
    )
}

/// With a carrier that rotates, the displacements of the sun have sidebands of the mesh frequency,
/// and the transmission error has none. Both equal those of the set with a carrier at rest, but for
/// Coriolis forces, which are about 2 / 71 of the inertia forces.
#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn a_rotating_carrier_gives_the_vibration_of_one_at_rest() {
    for speed in [200.0, 700.0] {
        let response = |carrier_rests: bool| {
            let of_sun = speed * if carrier_rests { 71.0 } else { 96.0 } / 25.0;
            let request = format!(
                "gears.forced_response(set.sun_meshes[0], highest_speed = {} rpm, lowest_speed = {of_sun} rpm, speeds = 2, harmonics = 10, damping_ratio = 0);
analyze(\"quasi_static\", over = gears.mesh_cycle(set.sun_meshes[0], 4), fidelity = \"analytic\", error_estimates = \"none\");
",
                of_sun + 1.0
            );
            solved(&planetary(speed, carrier_rests, &request)).1.expect("a response")
        };
        let [rotating, resting] = [false, true].map(response);
        let cycle = 60.0 / speed / 71.0;
        let integrated = format!(
            "analyze(\"dynamic\", over = gears.time_ranges([gears.time_range({} s, step = {} s)]), fidelity = \"analytic\", error_estimates = \"none\");\n",
            16.0 * cycle,
            cycle / 256.0
        );
        let (rows, _) = solved(&planetary(speed, false, &integrated));
        let last = &rows[rows.len() - 256..];
        let column = |k: usize| last.iter().map(|row| row[k]).collect::<Vec<f64>>();
        let square =
            |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64;
        let index = |response: &ForcedResponse, name: &str| {
            let found = response.quantities.iter().position(|quantity| quantity.name.starts_with(name));
            found.unwrap_or_else(|| panic!("no {name}"))
        };
        let error =
            |response: &ForcedResponse| response.points[0].rms(index(response, "transmission_error(sun"));
        let sun = |response: &ForcedResponse| {
            let along = ["u_x(sun)", "u_y(sun)"].map(|name| response.points[0].rms(index(response, name)));
            along[0].hypot(along[1])
        };
        for (what, found, at_rest, integrated) in [
            ("transmission error", error(&rotating), error(&resting), rms_of_harmonics(&column(0), 10)),
            ("sun", sun(&rotating), sun(&resting), (square(&column(1)) + square(&column(2))).sqrt()),
        ] {
            let near = |expected: f64, tolerance: f64| (found / expected - 1.0).abs() < tolerance;
            assert!(near(at_rest, 0.02), "{what} at {speed} rpm: {found:e}, at rest {at_rest:e}");
            // The response is linear: a patch does not change its size with the vibration.
            assert!(near(integrated, 0.07), "{what} at {speed} rpm: {found:e}, integrated {integrated:e}");
        }
        let largest = |name: &str, sideband: bool| {
            let amplitudes = &rotating.points[0].amplitudes[index(&rotating, name)];
            let lines = rotating.lines.iter().zip(amplitudes).skip(1);
            let of_kind = lines.filter(|(line, _)| (line.sideband != 0) == sideband);
            of_kind.map(|(_, amplitude)| amplitude.norm()).fold(0.0, f64::max)
        };
        let name = "transmission_error(sun";
        assert!(largest(name, true) < 0.02 * largest(name, false), "sidebands of the transmission error");
        assert!(largest("u_x(sun)", false) < 0.02 * largest("u_x(sun)", true), "mesh frequency of the sun");
    }
}
