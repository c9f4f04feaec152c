//! Outputs in the frequency domain, from the model to the files: a pair over two turns of its mesh shows its harmonics.

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
var mesh = gears.mesh(one, two, cells = 6, tip_corner_contact = FALSE);
output te := gears.transmission_error(mesh);
SIGNALS
analyze(\"quasi_static\", over = gears.times(to = 0.1 s - 0.1 s/32, count = 32));
";

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
        gears.spectrogram(\"te\", piece = 0.05 s);";
    let output = run(directory.path(), asked);
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success(), "{told}");
    // Two cycles of 20 Hz.
    assert!(
        told.lines().any(|line| line.starts_with("te_spectrum [rad]: ") && line.contains("at 20 Hz")),
        "{told}"
    );
    let below = directory.path().join("run/signals");
    let table = fs::read_to_string(below.join("te_spectrum.csv")).unwrap();
    assert_eq!(table.lines().next(), Some("frequency,amplitude,phase"));
    let numbers = |row: &str| row.split(',').map(|cell| cell.parse().unwrap()).collect();
    let rows: Vec<Vec<f64>> = table.lines().skip(1).map(numbers).collect();
    assert_eq!(rows.len(), 17);
    let largest = rows[1..].iter().fold(0.0f64, |most, row| most.max(row[1]));
    assert_eq!((rows[2][0], rows[2][1]), (20.0, largest));
    // What repeats with the mesh has nothing between its harmonics.
    for row in rows.iter().skip(1).step_by(2) {
        assert!(row[1] < 1e-6 * largest, "{row:?} {largest}");
    }
    for name in ["te_spectrum", "te_spectrogram"] {
        let picture = fs::read_to_string(below.join(format!("{name}.svg"))).unwrap();
        let shapes = picture.matches("<rect").count() + picture.matches("<polyline").count();
        assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"), "{name}");
        assert!(shapes > 2 && picture.contains("Hz"), "{name}: {shapes}");
    }
}

/// E0776 and E0777, as warnings.
#[test]
fn what_the_rows_cannot_show_is_said_at_the_request_and_spoils_nothing() {
    for (asked, code) in [
        ("gears.spectrum(\"te\", from = 0.09 s);", "W0776"),
        ("gears.spectrogram(\"te\", piece = 1 s);", "W0776"),
        ("gears.order_map(\"te\", shaft = two, turns = 8);", "W0776"),
    ] {
        let directory = tempfile::tempdir().unwrap();
        let output = run(directory.path(), asked);
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(
            output.status.success() && said.contains(code) && said.contains("model.cx:10"),
            "{asked}: {said}"
        );
    }
    // Ranges of different steps.
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
