//! Radiated sound of models: the power balance of the housing, the effect of the transmission
//! error, agreement of outputs and tables, and refusals.

use crate::models::{codes, engine};
use calyx::rt::{RunOptions, run as run_in_directory};
use calyx::{Module, check_file};
use calyx_runtime::acoustics::SoundMethod;
use calyx_runtime::acoustics::levels::a_weighting;
use calyx_runtime::forced_response::ForcedResponse;
use calyx_runtime::radiated_sound::{RadiatedSound, Weighting};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// A box of plates in NASTRAN bulk data, mm: 120 x 100 x 60 in elements of 20 mm. The material has
/// this density, and the shells of the top are left out from this number on.
pub(crate) fn plates(density: &str, top: usize) -> String {
    let counts = [6, 5, 3];
    let mut text = format!("BEGIN BULK\nMAT1,1,2.1+5,,0.3,{density}\nPSHELL,1,1,4.0,1,,1\n");
    let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let mut shells: Vec<[usize; 4]> = Vec::new();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [0, counts[axis]] {
            for i in 0..counts[u] {
                for j in 0..counts[v] {
                    let is_top = axis == 1 && side > 0;
                    if is_top && counts[v] * i + j >= top {
                        continue;
                    }
                    let corner = |di: usize, dj: usize| {
                        let mut at = [0; 3];
                        (at[axis], at[u], at[v]) = (side, i + di, j + dj);
                        at
                    };
                    shells.push([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)].map(|at| {
                        let next = numbers.len() + 1;
                        *numbers.entry(at).or_insert(next)
                    }));
                }
            }
        }
    }
    for (at, number) in &numbers {
        let [x, y, z] = at.map(|at| 20.0 * at as f64);
        let _ = writeln!(text, "GRID,{number},,{x:.1},{y:.1},{z:.1}");
    }
    for (index, [a, b, c, d]) in shells.iter().enumerate() {
        let _ = writeln!(text, "CQUAD4,{},1,{a},{b},{c},{d}", index + 1);
    }
    text + "ENDDATA\n"
}

/// A helical pair on bearings in the plates. `outputs` and `analysis` end the model.
pub(crate) fn pair(torque: f64, outputs: &str, analysis: &str) -> String {
    format!(
        "import gears;
units mm_N_s;
function blank(in teeth, in hand) {{
    return gears.external(teeth, normal_module = 2 mm, helix_angle = 15 deg, hand = hand, face_width = 15 mm);
}}
var a = blank(20, \"right\"), b = blank(20, \"left\");
var distance = gears.center_distance(a, b) + 0.05 mm;
var housing = gears.nastran(\"housing\", \"plates.bdf\", units = \"N-mm-s\",
    frame := Translate(-40 mm * e1 - 50 mm * e2));
for (x in [0 mm, 120 mm]) for (z in [0 mm, 60 mm])
    gears.attachment(\"foot {{x}} {{z}}\", housing, gears.nearest_node(x * e1 + z * e3), fixed = TRUE);
function seat(in name, in from: Length, in to: Length, in at: Length) {{
    var region = gears.box_region(from * e1 + 39 mm * e2 - 1 mm * e3, to * e1 + 61 mm * e2 + 1 mm * e3);
    return gears.attachment(name, housing, region, position = at * e1 + 50 mm * e2);
}}
function held(in name, in body: Body, in to: Body) {{
    return gears.bearing(name, body, to = to, radial_stiffness = 2e8 N/m, axial_stiffness = 2e8 N/m,
        tilting_stiffness = 2e5 N*m/rad);
}}
var turning = 1500 rpm;
var pinion = gears.body(\"pinion\", a, free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\", \"theta_z\"],
    moment = {torque} N*m * e3, frame := Rotate(turning * Time, e3));
var gear = gears.body(\"gear\", b, free = [\"u_x\", \"u_y\", \"u_z\", \"theta_x\", \"theta_y\"],
    frame := Rotate(-turning * Time, e3) * Translate(distance * e1));
held(\"first bearing\", pinion, seat(\"first\", 19 mm, 61 mm, 40 mm));
held(\"second bearing\", gear, seat(\"second\", 79 mm, 101 mm, 40 mm + distance));
var mesh = gears.mesh(pinion, gear, contact_cells = 3, contact_slices = 1, tip_corner_contact = FALSE);
{outputs}
{analysis}"
    )
}

pub(crate) const RESPONSE: &str = "gears.forced_response(mesh, highest_speed = 3000 rpm, lowest_speed = 600 rpm, speeds = 9, harmonics = 3);\n";

pub(crate) fn analysis(highest: &str) -> String {
    format!(
        "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), fidelity = \"analytic\", highest_frequency = {highest}, error_estimates = \"none\");\n"
    )
}

/// Compiles a model in a folder, next to plates.
fn module(folder: &Path, text: &str) -> Module {
    fs::write(folder.join("plates.bdf"), plates("7.85-9", 99)).expect("written");
    let path = folder.join("model.cx");
    fs::write(&path, text).expect("written");
    Module::from_file(&engine(), &path).unwrap_or_else(|error| panic!("{error}"))
}

/// Values of the outputs at the first position, and the forced response.
pub(crate) fn run(text: &str) -> (Vec<f64>, ForcedResponse) {
    let folder = tempfile::tempdir().expect("a folder");
    let module = module(folder.path(), text);
    let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
    let result = results.analysis().expect("an analysis");
    let values = result.rows[0].outputs.iter().map(|output| output.value).collect();
    (values, result.forced_response.clone().expect("a response"))
}

/// The power that enters at the bearings is what the damping dissipates in the housing.
fn check_balance(sound: &RadiatedSound) {
    for point in sound.speeds.iter().chain([&sound.own]) {
        let [input, dissipated] = [&point.input, &point.dissipated].map(|all| all.iter().sum::<f64>());
        assert!(dissipated > 0.0 && (input / dissipated - 1.0).abs() < 0.01, "{input} {dissipated}");
        // The difference is the inertia of modes that the forced response condenses.
        for (line, (input, own)) in point.input.iter().zip(&point.dissipated).enumerate().skip(1) {
            if *own > 1e-3 * dissipated {
                assert!((input / own - 1.0).abs() < 0.01, "line {line} at {}: {input} {own}", point.speed);
            }
        }
        let radiated: f64 = point.powers.iter().sum();
        assert!(radiated > 0.0 && radiated < dissipated, "{radiated} {dissipated}");
    }
}

/// One run with all levels: balance, lines, and agreement of outputs with results.
#[test]
fn outputs_are_those_of_the_table_at_the_speed_of_the_model() {
    let outputs = "output power := gears.radiated_power(housing);
output level := gears.sound_power_level(housing);
output plain := gears.sound_power_level(housing, weighting = \"none\");
output second := gears.radiated_power(housing, harmonic = 2);
output efficiency := gears.radiation_efficiency(housing);
output equivalent := gears.radiated_power(housing, method = \"erp\");
output elements := gears.radiated_power(housing, method = \"boundary_elements\");
output near := gears.sound_pressure_level(housing, method = \"boundary_elements\", at = 3 m * e2, weighting = \"none\");
output far := gears.sound_pressure_level(housing, method = \"boundary_elements\", at = 6 m * e2, weighting = \"none\");
";
    let (values, response) = run(&pair(60.0, &format!("{RESPONSE}{outputs}"), &analysis("2500 Hz")));
    let [power, level, plain, second, efficiency, equivalent, elements, near, far] =
        values[..].try_into().expect("nine outputs");
    let methods: Vec<SoundMethod> = response.sounds.iter().map(|sound| sound.method).collect();
    assert_eq!(methods, [SoundMethod::Rayleigh, SoundMethod::EquivalentPower, SoundMethod::BoundaryElements]);
    let sound = &response.sounds[0];
    response.sounds.iter().for_each(check_balance);
    assert!((power / sound.own.powers.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    // Each line has its A-weighting.
    let weighted = |line: usize| match sound.own.powers[line] {
        0.0 => 0.0,
        power => power * 10f64.powf(0.1 * a_weighting(sound.frequency(line, sound.own.speed))),
    };
    let sum: f64 = (0..sound.own.powers.len()).map(weighted).sum();
    assert!((level - 10.0 * (sum / 1e-12).log10()).abs() < 1e-9);
    assert!((plain - 10.0 * (power / 1e-12).log10()).abs() < 1e-9);
    assert!((second / sound.own.powers[2] - 1.0).abs() < 1e-12);
    assert!((efficiency - power / equivalent).abs() < 1e-9 * efficiency);
    assert!(elements > 0.0);
    // In the far field the pressure decreases with the distance, up to terms of the size of the
    // body over the distance, here 2 %.
    assert!((near - far - 20.0 * 2f64.log10()).abs() < 0.15, "{near} {far}");
    // Lines are multiples of the mesh frequency, and those above the modes have no sound.
    for point in &sound.speeds {
        for (line, power) in point.powers.iter().enumerate() {
            let frequency = line as f64 * 20.0 * point.speed / std::f64::consts::TAU;
            assert!((sound.frequency(line, point.speed) - frequency).abs() < 1e-9 * frequency.max(1.0));
            assert_eq!(*power > 0.0, frequency > 0.0 && frequency <= 2500.0, "line {line}");
        }
    }
    // The interpolation ends at 0.5 %, and 5 % of the power are 0.2 dB.
    let elements = &response.sounds[2];
    assert!(elements.interpolation_error < 0.01 && elements.far_field_difference < 0.05);
    assert_eq!(elements.surface.closed, []);
    assert!(elements.solved_frequencies.len() > 4);
}

/// The sounds of a body have names by which they differ, a heavy fluid has a warning, and outputs
/// with and without the method of the fidelity share one sound.
#[test]
fn sounds_of_a_body_differ_in_method_fluid_and_plane() {
    let outputs = "output free := gears.radiated_power(housing);
output same := gears.radiated_power(housing, method = \"rayleigh\");
output sea := gears.radiated_power(housing, fluid = \"water\");
output ground := gears.radiated_power(housing, plane = -60 mm * e2);
";
    let short = RESPONSE
        .replace("speeds = 9, harmonics = 3", "speeds = 2, harmonics = 1")
        .replace("3000 rpm, lowest_speed = 600 rpm", "1600 rpm, lowest_speed = 1400 rpm");
    let model = pair(60.0, &format!("{short}{outputs}"), &analysis("2500 Hz"));
    let (values, response) = run(&model);
    let [free, sea, ground] = &response.sounds[..] else { panic!("three sounds") };
    assert_eq!(values[0].to_bits(), values[1].to_bits());
    assert_eq!((free.plane, ground.plane), (None, Some([[0.0, -0.06, 0.0], [0.0, 1.0, 0.0]])));
    let folder = tempfile::tempdir().expect("a folder");
    let module = module(folder.path(), &model);
    let directory = folder.path().join("run");
    let options = RunOptions { directory: directory.clone(), quiet: true, ..RunOptions::default() };
    run_in_directory(module.as_program().clone(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    let head = fs::read_to_string(directory.join("run.json")).expect("readable");
    let head: serde_json::Value = serde_json::from_str(&head).expect("JSON");
    let entries = head["radiated_sound"].as_array().expect("sounds");
    let names: Vec<&str> = entries.iter().filter_map(|one| one["body"].as_str()).collect();
    assert_eq!(
        names,
        [
            "housing, rayleigh, in air, in free space",
            "housing, rayleigh, in water, in free space",
            "housing, boundary_elements, in air, on the plane through (0, -60, 0) mm with normal (0, 1, 0)",
        ]
    );
    // The plates have 4 mm; 1.5 kg. Air of the reactance of a sphere with 72 mm radius has 4.3 g.
    let [air, water] = [free, sea].map(|sound| sound.fluid_mass_ratio().expect("a mass"));
    assert!(air > 1e-3 && air < 5e-3 && water > 1.0, "{air} {water}");
    let warned = |sound: &RadiatedSound| {
        sound.warnings().iter().any(|warning| warning.contains("computed without fluid"))
    };
    assert_eq!([free, sea, ground].map(warned), [false, true, false]);
    for sound in [free, ground] {
        // The error of the level belongs to the sum of the errors of all lines.
        let [power, error] = [&sound.own.powers, &sound.own.errors].map(|all| all.iter().sum::<f64>());
        let level = sound.level_error(&sound.own, Weighting::None);
        assert!((level - 10.0 * (1.0 + error / power).log10()).abs() < 1e-9 && level > 0.0, "{level}");
    }
}

/// Half the torque halves the transmission error of unmodified gears, and the level is 6 dB lower.
#[test]
fn half_the_transmission_error_lowers_the_level_by_six_decibels() {
    let outputs = "output level := gears.sound_power_level(housing, method = \"erp\");
output first := gears.sound_power_level(housing, method = \"erp\", harmonic = 1);
output second := gears.sound_power_level(housing, method = \"erp\", harmonic = 2);
";
    let at = |torque: f64| run(&pair(torque, &format!("{RESPONSE}{outputs}"), &analysis("2500 Hz")));
    let [(full, response), (half, of_half)] = [at(60.0), at(30.0)];
    let error = |response: &ForcedResponse| {
        response.points[0].amplitudes[0].iter().skip(1).map(|line| line.norm()).collect::<Vec<_>>()
    };
    let ratio = error(&of_half)[0] / error(&response)[0];
    // Contact is not linear, so the ratio is not exactly a half; 5 % of it are 0.4 dB.
    assert!((ratio - 0.5).abs() < 0.025, "{ratio}");
    for (full, half) in full.iter().zip(&half) {
        // Within the 0.4 dB by which the ratio of the transmission errors may deviate.
        assert!((full - half - 20.0 * 2f64.log10()).abs() < 0.3, "{full} {half}");
    }
    // Contact is not linear, so the level of a harmonic does not follow its transmission error
    // exactly. The difference is 0.11 dB, and hardly depends on the number of slices.
    let first = full[1] - half[1] + 20.0 * ratio.log10();
    assert!(first.abs() < 0.15, "{first}");
}

/// Codes of the diagnostics of a model next to plates.
fn codes_with(text: &str, deck: &str) -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("plates.bdf"), deck).expect("written");
    let path = folder.path().join("model.cx");
    fs::write(&path, text).expect("written");
    check_file(&path).expect("readable").diagnostics.into_iter().map(|found| found.code.clone()).collect()
}

#[test]
fn impossible_sound_is_rejected() {
    let power = "output power := gears.radiated_power(housing);\n";
    let with = |before: &str, end: &str| pair(60.0, &format!("{before}{power}"), end);
    let deck = plates("7.85-9", 99);
    let fine = with(RESPONSE, &analysis("2500 Hz"));
    assert_eq!(codes_with(&fine, &deck), Vec::<String>::new());
    // No forced response, no modes, rigid, no mass, a gear, and no whole harmonic.
    assert_eq!(codes_with(&with("", &analysis("2500 Hz")), &deck), ["E0784"]);
    assert_eq!(codes_with(&with(RESPONSE, &analysis("0 Hz")), &deck), ["E0784"]);
    let rigid = with(RESPONSE, &analysis("0 Hz")).replace("\"analytic\"", "\"rigid\"");
    assert_eq!(codes_with(&rigid, &deck), ["E0780"], "rigid gears do not vibrate");
    assert_eq!(codes_with(&fine, &plates("", 99)), ["E0784"]);
    let of_gear = fine.replace("radiated_power(housing)", "radiated_power(gear)");
    assert_eq!(codes_with(&of_gear, &deck), ["E0784"]);
    let harmonic = fine.replace("radiated_power(housing)", "radiated_power(housing, harmonic = 1.5)");
    assert_eq!(codes_with(&harmonic, &deck), ["E0784"]);
    let inside = fine.replace("radiated_power(housing)", "sound_pressure_level(housing, at = 20 mm * e3)");
    assert_eq!(codes_with(&inside, &deck), ["E0784"]);
    let rough = inside.replace("at = 20 mm * e3", "at = 1 m * e1, method = \"erp\"");
    assert_eq!(codes_with(&rough, &deck), ["E0784"]);
    // A harmonic that the response does not have, and a line above the modes.
    let high = fine.replace("radiated_power(housing)", "radiated_power(housing, harmonic = 4)");
    assert_eq!(codes_with(&high, &deck), ["E0784"]);
    assert_eq!(codes_with(&with(RESPONSE, &analysis("400 Hz")), &deck), ["E0784"]);
    // Planes through the body, in a wall, far away, and with walls that know nothing of a plane.
    let plane = |y: &str, more: &str| {
        let arguments = format!("radiated_power(housing, plane = {y} * e2{more})");
        codes_with(&fine.replace("radiated_power(housing)", &arguments), &deck)
    };
    assert_eq!(plane("-60 mm", ""), Vec::<String>::new());
    // A node without elements is no wall.
    let spare = deck.replace("ENDDATA", "GRID,99999,,0.0,-500.0,0.0\nENDDATA");
    let near = fine.replace("radiated_power(housing)", "radiated_power(housing, plane = -60 mm * e2)");
    assert_eq!(codes_with(&near, &spare), codes_with(&fine, &spare));
    for y in ["0 mm", "-50 mm", "-9 m"] {
        assert_eq!(plane(y, ""), ["E0784"], "{y}");
    }
    assert_eq!(plane("-60 mm", ", method = \"rayleigh\""), ["E0784"]);
    // Without its top, the box is open until an opening closes it.
    let open = plates("7.85-9", 0);
    assert_eq!(codes_with(&fine, &open), ["E0785"]);
    let rim = "gears.opening(\"top\", housing, gears.plane_region(100 mm * e2, e2));\n";
    assert_eq!(
        codes_with(&with(&format!("{RESPONSE}{rim}"), &analysis("2500 Hz")), &open),
        Vec::<String>::new()
    );
    let elsewhere = rim.replace("100 mm", "60 mm");
    let nothing = with(&format!("{RESPONSE}{elsewhere}"), &analysis("2500 Hz"));
    assert_eq!(codes_with(&nothing, &deck), ["E0785"]);
    // Without the file there is nothing to say about sound.
    assert_eq!(codes(&fine), ["E0730"]);
}

/// The example: orders are multiples of the mesh frequency, the powers balance, and the level of
/// the first harmonic follows the transmission error, by 6 dB for half of it.
#[test]
#[ignore = "long; part of .ci/full"]
fn the_example_radiates_the_orders_of_its_mesh() {
    let path = calyx_tests::root().join("examples/gearbox_noise.cx");
    let module = Module::from_file(&engine(), &path).unwrap_or_else(|error| panic!("{error}"));
    let at = |torque: &str| {
        let mut instance = module.instantiate();
        for (param, value) in [("torque", torque), ("method", "boundary_elements"), ("speeds", "4")] {
            instance.set(param, value).expect("a param");
        }
        let results = instance.solve().unwrap_or_else(|error| panic!("{error}"));
        results.analysis().and_then(|result| result.forced_response.clone()).expect("a response")
    };
    let [full, half] = ["120 N*m", "60 N*m"].map(at);
    let ratio = half.points[0].amplitudes[0][1].norm() / full.points[0].amplitudes[0][1].norm();
    assert!((ratio - 0.5).abs() < 0.05, "{ratio}");
    let sound = &full.sounds[0];
    check_balance(sound);
    for point in sound.speeds.iter().chain([&sound.own]) {
        for (line, power) in point.powers.iter().enumerate().skip(1) {
            let frequency = line as f64 * 23.0 * point.speed / std::f64::consts::TAU;
            assert!((sound.frequency(line, point.speed) / frequency - 1.0).abs() < 1e-12 && *power > 0.0);
        }
        // Radiation efficiencies hardly exceed one.
        let mut powers = point.powers.iter().zip(&point.equivalent_powers).skip(1);
        assert!(powers.all(|(power, equivalent)| *power < 2.0 * equivalent));
    }
    let first = half.sounds[0].own.powers[1] / sound.own.powers[1];
    assert!((10.0 * first.log10() - 20.0 * ratio.log10()).abs() < 0.5, "{first} {ratio}");
    assert!((10.0 * first.log10() + 20.0 * 2f64.log10()).abs() < 0.5, "{first}");
}

/// The surface is coarsened for the highest line, and sound of lower ones must not depend on it.
#[test]
#[ignore = "long; part of .ci/full"]
fn the_example_radiates_lines_that_do_not_depend_on_higher_ones() {
    let examples = calyx_tests::root().join("examples");
    let text = fs::read_to_string(examples.join("gearbox_noise.cx")).expect("readable");
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy(examples.join("housing.bdf"), folder.path().join("housing.bdf")).expect("copied");
    let efficiencies = |harmonics: usize| {
        let path = folder.path().join("model.cx");
        fs::write(&path, text.replace("harmonics = 4", &format!("harmonics = {harmonics}")))
            .expect("written");
        let module = Module::from_file(&engine(), &path).unwrap_or_else(|error| panic!("{error}"));
        let mut instance = module.instantiate();
        instance.set("method", "rayleigh").and_then(|()| instance.set("speeds", "4")).expect("params");
        let results = instance.solve().unwrap_or_else(|error| panic!("{error}"));
        let result = results.analysis().and_then(|result| result.forced_response.clone());
        let sound = result.expect("a response").sounds.remove(0);
        let points = sound.speeds.iter().chain([&sound.own]);
        let of_first = points.map(|point| point.powers[1] / point.equivalent_powers[1]).collect::<Vec<f64>>();
        (of_first, sound.surface.triangles)
    };
    let [(low, coarse), (high, fine)] = [1, 4].map(efficiencies);
    assert!(2 * coarse < fine, "{coarse} {fine}");
    // Samples of the velocities made a difference of a factor of two.
    for (low, high) in low.iter().zip(&high) {
        assert!((low / high - 1.0).abs() < 0.03, "{low} {high}");
    }
}
