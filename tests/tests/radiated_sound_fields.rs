//! Sound pressures on field meshes, contributions of panels, and sound on the surface of models:
//! agreement with the sound power, and refusals.

use crate::radiated_sound::{RESPONSE, analysis, pair, plates, run};
use calyx::check_file;
use calyx_runtime::acoustics::Fluid;
use calyx_runtime::acoustics::SoundMethod;
use calyx_runtime::radiated_sound::RadiatedSound;
use std::fs;

/// Level of the reference values for air: those of sound power and pressure belong to 400 Ns/m³.
fn reference() -> f64 {
    10.0 * (Fluid::AIR.impedance() / 400.0).log10()
}

const PANELS: &str = "gears.panel(\"top\", housing, gears.plane_region(100 mm * e2, e2));
gears.panel(\"bottom\", housing, gears.plane_region(0 mm * e2, e2));
gears.panel(\"wall\", housing, gears.box_region(-1 mm * e1 - 1 mm * e2 - 1 mm * e3, 121 mm * e1 + 101 mm * e2 + 1 mm * e3));
";

/// Contributions sum to the power at all speeds and lines.
fn check_panels(sound: &RadiatedSound) {
    let names: Vec<&str> = sound.panels.iter().map(|panel| panel.name.as_str()).collect();
    assert_eq!(names, ["top", "bottom", "wall", "rest"]);
    // Both plates with the normal y have 120 by 60 mm, the wall has 120 by 100 mm.
    for (panel, area) in sound.panels.iter().zip([7.2e-3, 7.2e-3, 12e-3, 24e-3]) {
        assert!((panel.area / area - 1.0).abs() < 1e-9, "{} {}", panel.name, panel.area);
    }
    for point in sound.speeds.iter().chain([&sound.own]) {
        for (power, panels) in point.powers.iter().zip(&point.panels) {
            let sum: f64 = panels.iter().sum();
            assert!((sum - power).abs() <= 1e-9 * power, "{sum} {power}");
        }
    }
}

/// Intensities on the surface integrate to the powers of the loudest lines, up to the difference of
/// the far field.
fn check_skin(sound: &RadiatedSound) {
    let skin = sound.skin.as_ref().expect("a skin");
    let area = |[a, b, c]: [[f64; 3]; 3]| {
        let edge = |to: [f64; 3]| -> [f64; 3] { std::array::from_fn(|k| to[k] - a[k]) };
        let (p, q) = (edge(b), edge(c));
        let product = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        0.5 * product.iter().map(|part| part * part).sum::<f64>().sqrt()
    };
    assert!(!skin.fields.is_empty());
    for field in &skin.fields {
        let areas = skin.triangles.iter().map(|triangle| area(triangle.map(|vertex| skin.vertices[vertex])));
        let power: f64 = areas.zip(&field.intensities).map(|(area, intensity)| area * intensity).sum();
        let expected = sound.own.powers[field.line];
        // The interpolation over the frequency adds its error.
        let bound = 1e-6 + if sound.method == SoundMethod::EquivalentPower { 0.0 } else { 0.02 };
        let difference = sound.far_field_difference.max(0.0);
        assert!(
            (power / expected - 1.0).abs() < bound + difference,
            "{:?}: {power} {expected}",
            sound.method
        );
        assert_eq!(field.pressures.is_empty(), sound.method != SoundMethod::BoundaryElements);
    }
}

#[test]
fn panels_and_fields_agree_with_the_sound_power() {
    let outputs = "output plain := gears.sound_power_level(housing, weighting = \"none\", method = \"boundary_elements\");
output weighted := gears.sound_power_level(housing, method = \"boundary_elements\");
output top := gears.radiated_power(housing, panel = \"top\", method = \"boundary_elements\");
output second := gears.radiated_power(housing, panel = \"top\", harmonic = 2, method = \"boundary_elements\");
var distant = gears.sphere_field(\"distant\", radius = 60 m);
output measured := gears.measured_sound_power_level(housing, distant, weighting = \"none\");
output measured_weighted := gears.measured_sound_power_level(housing, distant);
var map = gears.plane_field(\"map\", corner = 0.5 m * e1, first_edge = 1 m * e2, second_edge = 0.6 m * e3, first_points = 3,
    second_points = 2);
output mean := gears.mean_sound_pressure_level(housing, map, weighting = \"none\");
output point := gears.sound_pressure_level(housing, at = 0.5 m * e1 + 0.5 m * e2 + 0.45 m * e3, weighting = \"none\",
    method = \"boundary_elements\");
output rayleigh := gears.radiated_power(housing, method = \"rayleigh\");
output equivalent := gears.radiated_power(housing, method = \"erp\");
";
    // A narrow range needs few frequencies.
    let response = RESPONSE
        .replace("speeds = 9, harmonics = 3", "speeds = 3, harmonics = 2")
        .replace("3000 rpm, lowest_speed = 600 rpm", "1800 rpm, lowest_speed = 1300 rpm");
    let (values, response) = run(&pair(60.0, &format!("{PANELS}{response}{outputs}"), &analysis("2500 Hz")));
    let [plain, weighted, top, second, measured, measured_weighted, mean, point, ..] = values[..] else {
        panic!("{values:?}")
    };
    // Pressures need boundary elements, so outputs without `method` have the same sound.
    assert_eq!(response.sounds.len(), 3);
    response.sounds.iter().for_each(check_panels);
    response.sounds.iter().for_each(check_skin);
    let sound = &response.sounds[0];
    assert!((top - sound.own.panels.iter().map(|line| line[0]).sum::<f64>()).abs() < 1e-12 * top.abs());
    assert!((second - sound.own.panels[2][0]).abs() < 1e-12 * top.abs());
    // 0.5 % of the power.
    assert!((measured - reference() - plain).abs() < 0.022, "{measured} {plain}");
    assert!((measured_weighted - reference() - weighted).abs() < 0.022, "{measured_weighted} {weighted}");
    let [distant, map] = &sound.fields[..] else { panic!("two fields") };
    assert_eq!((distant.kind, distant.mesh.points.len(), map.grid), ("sphere", 200, Some([3, 2])));
    // The mean of the squares, and the last but one point of the plane.
    let square =
        |point: usize| -> f64 { map.pressures.iter().map(|line| 0.5 * line[point].norm_sqr()).sum() };
    let level = |square: f64| 10.0 * (square / 4e-10).log10();
    let all: f64 = (0..6).map(square).sum();
    assert!((mean - level(all / 6.0)).abs() < 1e-9);
    let [x, y, z] = map.mesh.points[4];
    assert!((x - 0.5).abs() + (y - 0.5).abs() + (z - 0.45).abs() < 1e-12);
    assert!((point - level(square(4))).abs() < 1e-9, "{point} {}", level(square(4)));
    // The level of the far field at 1 m is that at a distance, less its decay.
    let (line, directions) = (sound.skin.as_ref().expect("a skin").fields[0].line, &sound.directions);
    assert_eq!(sound.far_field[line].len(), directions.len());
    let loudest = sound.far_field[line].iter().map(|value| value.norm()).fold(0.0, f64::max);
    let largest = distant.pressures[line].iter().map(|value| value.norm()).fold(0.0, f64::max);
    assert!((loudest / (60.0 * largest) - 1.0).abs() < 0.1, "{loudest} {largest}");
}

/// Microphones on a hemisphere on the ground give the power that the housing radiates above it.
#[test]
fn microphones_on_a_hemisphere_give_the_power_above_a_rigid_plane() {
    let outputs =
        "output plain := gears.sound_power_level(housing, weighting = \"none\", plane = -60 mm * e2);
var all = gears.hemisphere_field(\"all\", radius = 60 m, rings = 6);
output measured := gears.measured_sound_power_level(housing, all, weighting = \"none\", plane = -60 mm * e2);
var few = gears.hemisphere_field(\"few\", radius = 1 m);
output standard := gears.measured_sound_power_level(housing, few, weighting = \"none\", plane = -60 mm * e2);
var around = gears.box_field(\"around\", distance = 1 m);
output box := gears.measured_sound_power_level(housing, around, weighting = \"none\", plane = -60 mm * e2);
";
    let short = RESPONSE
        .replace("speeds = 9, harmonics = 3", "speeds = 2, harmonics = 1")
        .replace("3000 rpm, lowest_speed = 600 rpm", "1600 rpm, lowest_speed = 1400 rpm");
    let (values, response) = run(&pair(60.0, &format!("{short}{outputs}"), &analysis("2500 Hz")));
    let [plain, measured, standard, around] = values[..] else { panic!("{values:?}") };
    assert!((measured - reference() - plain).abs() < 0.022, "{measured} {plain}");
    // The standard states standard deviations of reproducibility of 1.5 dB.
    assert!((standard - plain).abs() < 3.0 && (around - plain).abs() < 3.0, "{standard} {around} {plain}");
    // Without `method`, all outputs share one computation.
    let [sound] = &response.sounds[..] else { panic!("one sound") };
    assert!(sound.directions.iter().all(|at| at.vector[1] > -1e-9));
    let points = &sound.fields[1].mesh.points;
    // Below the middle of the box, on the plane: the highest microphone is above the centre.
    let top = points[9];
    assert!((top[0] - 0.02).abs() + (top[1] - 0.94).abs() + (top[2] - 0.03).abs() < 1e-9, "{top:?}");
}

/// Codes, messages and places of the diagnostics of a model next to plates.
fn refusal(text: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("plates.bdf"), plates("7.85-9", 99)).expect("written");
    let path = folder.path().join("model.cx");
    fs::write(&path, text).expect("written");
    let found = check_file(&path).expect("readable").diagnostics;
    let shown = |found: &calyx::Diagnostic| {
        let place = &text[found.primary.span.start as usize..found.primary.span.end as usize];
        format!("{}: {}; {} @{place}", found.code, found.message, found.help.clone().unwrap_or_default())
    };
    found.iter().map(shown).collect::<Vec<_>>().join("\n")
}

#[test]
fn impossible_fields_and_panels_are_rejected() {
    let field = |shape: &str, more: &str| {
        format!(
            "var field = gears.{shape};\noutput level := gears.mean_sound_pressure_level(housing, field{more});\n"
        )
    };
    let ground = ", plane = -60 mm * e2";
    let panel = |name: &str, region: &str| {
        format!(
            "gears.panel(\"{name}\", housing, gears.{region});\noutput power := gears.radiated_power(housing, panel = \"top\");\n"
        )
    };
    let cases = [
        (field("sphere_field(\"small\", radius = 60 mm)", ""), "does not enclose the body", "field"),
        (field("sphere_field(\"large\", radius = 1 m)", ground), "passes through the rigid plane", "field"),
        (field("hemisphere_field(\"free\", radius = 1 m)", ""), "the sound has none", "field"),
        (field("hemisphere_field(\"high\", radius = 1 m, center = 0 mm * e2)", ground), "is 60 mm from the rigid plane", "field"),
        (field("hemisphere_field(\"small\", radius = 0.1 m)", ground), "does not enclose the body", "field"),
        (field("box_field(\"near\", distance = 0.1 m)", ground), "nine microphones", "field"),
        (
            field("plane_field(\"cut\", corner = -1 m * e1 - 1 m * e2 + 30 mm * e3, first_edge = 2 m * e1, second_edge = 2 m * e2)", ""),
            "passes through the body", "field",
        ),
        (
            field("plane_field(\"deep\", corner = 1 m * e1 - 1 m * e2, first_edge = 2 m * e3, second_edge = 2 m * e2)", ground),
            "is behind the rigid plane", "field",
        ),
        (field("plane_field(\"line\", corner = 1 m * e1, first_edge = 1 m * e2, second_edge = 2 m * e2)", ""), "are parallel", "2 m * e2"),
        (field("box_field(\"tight\", distance = 0 mm)", ground), "would touch the body", "0 mm"),
        (field("sphere_field(\"odd\", radius = 1 m, rings = 4.5)", ""), "E0784: `rings` cannot be 4.5", "4.5"),
        (field("sphere_field(\"fine\", radius = 1 m)", ", method = \"rayleigh\""), "has no sound pressure", "\"rayleigh\""),
        (
            "var field = gears.plane_field(\"map\", corner = 1 m * e1, first_edge = 1 m * e2, second_edge = 1 m * e3);\noutput level := gears.measured_sound_power_level(housing, field);\n".into(),
            "does not enclose the body", "field",
        ),
        (panel("top", "plane_region(20 mm * e3, e3)"), "no whole element", "gears.radiated_power(housing, panel = \"top\")"),
        (panel("top", "node_set(\"none\")"), "E0991", "gears.node_set(\"none\")"),
        (panel("rest", "plane_region(100 mm * e2, e2)"), "has this name in results", "\"rest\""),
        (panel("cover", "plane_region(100 mm * e2, e2)"), "has no panel \"top\"; give one of its panels: \"cover\"", "\"top\""),
        (
            "output power := gears.radiated_power(housing, plane_normal = e1);\n".into(),
            "a normal without a plane has no effect",
            "e1",
        ),
        (
            format!("gears.panel(\"half\", housing, gears.plane_region(100 mm * e2, e2));\n{}", panel("top", "plane_region(100 mm * e2, e2)")),
            "have common elements", "gears.radiated_power(housing, panel = \"top\")",
        ),
    ];
    for (outputs, expected, place) in cases {
        let found = refusal(&pair(60.0, &format!("{RESPONSE}{outputs}"), &analysis("2500 Hz")));
        assert!(found.contains(expected) && found.lines().count() == 1, "{expected}:\n{found}\n{outputs}");
        let (message, at) = found.rsplit_once(" @").unwrap_or_default();
        assert_eq!(at, place, "{found}");
        let remedy = message.rsplit("; ").next().unwrap_or_default();
        assert!(!remedy.trim().is_empty(), "{found}");
    }
}
