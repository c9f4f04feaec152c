//! Tests of outputs in the frequency domain, from the model to the files: a pair over two mesh
//! cycles shows its harmonics.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

const MODEL: &str = "import gears;
units SI;
var rack = gears.rack(module = 3 mm, tip_radius = 0.9 mm);
var blank = gears.external(teeth = 20, rack = rack, face_width = 20 mm, outer_diameter = 66 mm, root_diameter = 52.5 mm,
    material = gears.material(206 GPa, 0.3), rim = gears.simple_rim(45 mm, 30 mm));
var one = gears.body(\"one\", blank, free = [\"theta_z\"], moment = 50 N*m*e3, frame := Rotate(60 rpm*Time, e3));
var two = gears.body(\"two\", blank, frame := Rotate(-60 rpm*Time, e3)*Translate(60.3 mm*e1));
var mesh = gears.mesh(one, two, contact_cells = 6, tip_corner_contact = FALSE);
output te := gears.transmission_error(mesh);
output still := 0*gears.rotation(one, \"z\");
SIGNALS
analyze(\"quasi_static\", over = gears.times(to = 0.1 s - 0.1 s/32, count = 32));
";

/// A shaft that oscillates about its prescribed rotation: order tracking uses the actual angle, as
/// from a tachometer.
#[test]
fn orders_are_counted_by_the_angle_that_an_output_gives() {
    let directory = tempfile::tempdir().unwrap();
    // One revolution per second, with an oscillation of a twentieth of a revolution at order 3, and
    // an event of order 7 of the actual angle.
    let asked = "var swing := 0.3*sin(6*pi*Time/(1 s)) + 0*gears.rotation(one, \"z\")/(1 rad);
output ahead := 1 rad*swing;
output whole := 1 rad*(swing + 2*pi*Time/(1 s) - 60*pi);
output events := cos(7*(swing + 2*pi*Time/(1 s)));
gears.order_map(\"events\", shaft = one, angle = \"ahead\", revolutions = 2, highest = 20);
gears.order_map(\"events\", angle = \"whole\", revolutions = 2, highest = 20);
gears.order_map(\"events\", shaft = one, revolutions = 2, highest = 20);";
    let path = directory.path().join("model.cx");
    let model =
        MODEL.replace("SIGNALS", asked).replace("to = 0.1 s - 0.1 s/32, count = 32", "to = 8 s, count = 801");
    fs::write(&path, model).unwrap();
    let output =
        Command::new(env!("CARGO_BIN_EXE_calyx")).arg("run").arg(&path).arg("--no-cache").output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let largest = |name: &str| {
        let table = fs::read_to_string(directory.path().join("model.cx.run/signals").join(name)).unwrap();
        let numbers = |row: &str| row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let rows: Vec<Vec<f64>> = table.lines().skip(1).map(numbers).collect();
        [7.0, 10.0].map(|order: f64| {
            let on = rows.iter().filter(|row| (row[1] - order).abs() < 1e-9).map(|row| row[2]);
            on.collect::<Vec<f64>>()
        })
    };
    for name in ["events_order_map.csv", "events_order_map_2.csv"] {
        let [seventh, tenth] = largest(name);
        assert!(seventh.len() > 3 && seventh.iter().all(|a| (a - 1.0).abs() < 1e-4), "{name} {seventh:?}");
        assert!(tenth.iter().all(|amplitude| *amplitude < 1e-4), "{name} {tenth:?}");
    }
    // Over the prescribed angle, the oscillation spreads the order into sidebands.
    let [seventh, tenth] = largest("events_order_map_3.csv");
    assert!(seventh.iter().all(|a| *a < 0.5) && tenth.iter().all(|a| *a > 0.1), "{seventh:?} {tenth:?}");
}

fn run(directory: &Path, signals: &str) -> Output {
    let model = directory.join("model.cx");
    fs::write(&model, MODEL.replace("SIGNALS", signals)).unwrap();
    Command::new(env!("CARGO_BIN_EXE_calyx"))
        .arg("run")
        .arg(&model)
        .args(["--no-cache", "--out"])
        .arg(directory.join("run"))
        .output()
        .unwrap()
}

#[test]
fn a_pair_shows_the_harmonics_of_its_mesh_in_tables_and_pictures() {
    let directory = tempfile::tempdir().unwrap();
    let asked = "gears.spectrum(\"te\", window = \"rectangular\");
        gears.spectrum(\"te\", window = \"rectangular\", scaling = \"density\");
        gears.spectrogram(\"te\", segment = 0.05 s);";
    let output = run(directory.path(), asked);
    let printed = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{printed}");
    // Two cycles of 20 Hz.
    assert!(
        printed.lines().any(|line| line.starts_with("te_spectrum [urad]: ") && line.contains("at 20 Hz")),
        "{printed}"
    );
    let below = directory.path().join("run/signals");
    let table = fs::read_to_string(below.join("te_spectrum.csv")).unwrap();
    assert_eq!(table.lines().next(), Some("frequency,amplitude,phase"));
    let numbers = |row: &str| row.split(',').map(|cell| cell.parse().unwrap()).collect();
    let rows: Vec<Vec<f64>> = table.lines().skip(1).map(numbers).collect();
    assert_eq!(rows.len(), 17);
    let largest = rows[1..].iter().fold(0.0f64, |most, row| most.max(row[1]));
    assert_eq!((rows[2][0], rows[2][1]), (20.0, largest));
    // A signal with the mesh period has no content between its harmonics.
    for row in rows.iter().skip(1).step_by(2) {
        assert!(row[1] < 1e-6 * largest, "{row:?} {largest}");
    }
    // The density of a harmonic is its mean square divided by the frequency resolution.
    let density = fs::read_to_string(below.join("te_spectral_density.csv")).unwrap();
    assert_eq!(density.lines().next(), Some("frequency,density"));
    let densities: Vec<Vec<f64>> = density.lines().skip(1).map(numbers).collect();
    assert!((densities[2][1] / (0.5 * largest * largest / 10.0) - 1.0).abs() < 1e-9, "{densities:?}");
    // The record of the run contains the signals.
    let record = fs::read_to_string(directory.path().join("run/run.json")).unwrap();
    let record: serde_json::Value = serde_json::from_str(&record).unwrap();
    let listed = record["signals"].as_array().unwrap();
    let kinds: Vec<&str> = listed.iter().filter_map(|signal| signal["kind"].as_str()).collect();
    assert_eq!(kinds, ["spectrum", "spectral_density", "spectrogram"]);
    assert_eq!(listed[1]["unit"], "rad^2/Hz");
    for signal in listed {
        for file in ["table", "plot"] {
            assert!(directory.path().join("run").join(signal[file].as_str().unwrap()).exists(), "{signal}");
        }
    }
    assert_eq!(listed[0]["peaks"][0]["frequency"].as_f64().map(f64::round), Some(20.0));
    for name in ["te_spectrum", "te_spectral_density", "te_spectrogram"] {
        let picture = fs::read_to_string(below.join(format!("{name}.svg"))).unwrap();
        let shapes = picture.matches("<rect").count() + picture.matches("<polyline").count();
        assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"), "{name}");
        assert!(shapes > 2 && picture.contains("Hz"), "{name}: {shapes}");
    }
}

/// Pair at very low speed; a torsional spring supports the second gear.
const STRUCK: &str = "import gears;
units SI;
var rack = gears.rack(module = 3 mm, tip_radius = 0.9 mm);
var blank = gears.external(teeth = 20, rack = rack, face_width = 20 mm, outer_diameter = 66 mm, root_diameter = 52.5 mm,
    material = gears.material(206 GPa, 0.3), rim = gears.simple_rim(45 mm, 30 mm));
var one = gears.body(\"one\", blank, free = [\"theta_z\"], moment = 50 N*m*e3, inertia = 2e-3 kg*m^2,
    frame := Rotate(1e-3 rpm*Time, e3));
var two = gears.body(\"two\", blank, free = [\"theta_z\"], inertia = 2e-3 kg*m^2,
    frame := Rotate(-1e-3 rpm*Time, e3)*Translate(60.3 mm*e1));
var _spring = gears.bearing(\"spring\", two, torsional_stiffness = 1e5 N*m/rad);
var _mesh = gears.mesh(one, two, contact_cells = 4, tip_corner_contact = FALSE);
// So small that the loaded cells stay the same.
gears.impulse(one, at = 0.1 ms, duration = 0.04 ms, angular_momentum = 1e-4 N*m*s*e3);
";
const AT_REST: &str = "output lower := gears.natural_frequency(1);
output upper := gears.natural_frequency(2);
analyze(\"quasi_static\", over = gears.times(to = 1 ms, count = 1), fidelity = \"analytic\");
";
const AFTERWARDS: &str = "output swing := gears.rotation(one, \"z\");
gears.spectrum(\"swing\", from = 0.2 ms);
gears.transfer_function(\"swing\", from = 0.1 ms, momentum = 1e-4);
analyze(\"dynamic\", over = gears.time_ranges([gears.time_range(20 ms, step = 10 us)]), fidelity = \"analytic\",
    rayleigh_mass = 500 Hz, error_estimates = \"none\");
";

/// After an impulse, the spectrum has peaks at the natural frequencies about the equilibrium, which
/// are computed without dynamics.
#[test]
fn after_a_impulse_lines_are_at_the_natural_frequencies() {
    let record = |asked: &str| -> serde_json::Value {
        let directory = tempfile::tempdir().unwrap();
        let model = directory.path().join("model.cx");
        fs::write(&model, format!("{STRUCK}{asked}")).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
        let output = command.arg("run").arg(&model).arg("--no-cache").output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let record = fs::read_to_string(directory.path().join("model.cx.run/run.json")).unwrap();
        serde_json::from_str(&record).unwrap()
    };
    let (at_rest, record) = (record(AT_REST), record(AFTERWARDS));
    let natural = ["lower", "upper"].map(|name| at_rest["outputs"][name]["max"].as_f64().unwrap());
    // Both gears in phase on the spring, and in opposite phase on the mesh stiffness.
    assert!(natural[1] > 2.0 * natural[0] && natural[0] > 500.0, "{natural:?}");
    for signal in record["signals"].as_array().unwrap() {
        let mut peaks: Vec<f64> = signal["peaks"]
            .as_array()
            .unwrap()
            .iter()
            .filter_map(|peak| peak["frequency"].as_f64())
            .collect();
        peaks.truncate(2);
        peaks.sort_by(f64::total_cmp);
        assert_eq!(peaks.len(), 2, "{signal}");
        for (peak, natural) in peaks.iter().zip(natural) {
            // The spectral resolution is 50 Hz, so peaks are at most 25 Hz off.
            assert!((peak - natural).abs() < 25.0, "{}: {peaks:?} {natural:?}", signal["kind"]);
        }
    }
}

/// E0776 and E0777 are warnings.
#[test]
fn what_the_rows_cannot_show_is_said_at_the_request_and_spoils_nothing() {
    let directory = tempfile::tempdir().unwrap();
    let asked = [
        ("gears.spectrum(\"te\", from = 0.09 s);", "at least 4 samples, and there are"),
        (
            "gears.spectrum(\"te\", segment = 1 ms);",
            "a segment of 0.001 s has 0 samples, which are 0.003125 s apart",
        ),
        (
            "gears.spectrum(\"te\", segment = 1 s);",
            "a segment of 1 s is longer than the 32 samples, which last 0.1 s",
        ),
        ("gears.spectrogram(\"te\", segment = 9 ms);", "a segment of 0.009 s has 3 samples"),
        (
            "gears.order_map(\"te\", shaft = two, revolutions = 8);",
            "a segment of 8 revolutions is longer than the signal",
        ),
        ("gears.order_map(\"te\", angle = \"still\");", "the shaft stops or reverses"),
    ];
    // One per line, from the tenth line.
    let all: Vec<&str> = asked.iter().map(|(asked, _)| *asked).collect();
    let output = run(directory.path(), &all.join("\n"));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{said}");
    let warnings: Vec<&str> = said.split("[W0776] Warning: ").skip(1).collect();
    assert_eq!(warnings.len(), asked.len(), "{said}");
    for (index, (warning, (asked, expected))) in warnings.iter().zip(asked).enumerate() {
        let place = format!("model.cx:{}:", 11 + index);
        assert!(warning.contains(expected) && warning.contains(&place), "{asked}: {warning}");
    }
    // Time ranges with different steps.
    let directory = tempfile::tempdir().unwrap();
    let model = directory.path().join("model.cx");
    let over = "over = gears.time_ranges([gears.time_range(1 ms, step = 0.25 ms), gears.time_range(1 ms, step = 0.5 ms)])";
    let text = MODEL.replace("SIGNALS", "gears.spectrum(\"te\");");
    let begin = text.find("over = ").unwrap();
    fs::write(&model, format!("{}{over});\n", &text[..begin]).replace("quasi_static", "dynamic")).unwrap();
    let output =
        Command::new(env!("CARGO_BIN_EXE_calyx")).arg("run").arg(&model).arg("--no-cache").output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && said.contains("W0777"), "{said}");
}
