//! Tooth contact of bevel gears in the run directory and in the report: outlines, ease-off and
//! unloaded contact, at fidelity "rigid".

use crate::models::engine;
use calyx::rt::{ParamAssignment, RunOptions, run};
use calyx::{Module, check_file};
use calyx_tests::root;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

type Row = BTreeMap<String, String>;

fn run_rigid(example: &str, steps: usize, given: &[(&str, &str)]) -> tempfile::TempDir {
    let checked = check_file(&root().join("examples").join(example)).expect("examples can be read");
    let module = Module::from_checked(&engine(), checked).expect("examples compile");
    let directory = tempfile::tempdir().expect("a directory");
    let steps = steps.to_string();
    let own = [("fidelity", "rigid"), ("steps", &*steps)];
    let given = own.iter().chain(given);
    let options = RunOptions {
        directory: directory.path().join("run"),
        given: given.map(|(name, value)| ParamAssignment::text(*name, *value)).collect(),
        quiet: true,
        ..RunOptions::default()
    };
    run(module.as_program(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    directory
}

fn table(directory: &Path, name: &str) -> Vec<Row> {
    let text = fs::read_to_string(directory.join("run").join(name)).expect("a table");
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let names = lines.next().expect("a header");
    lines.map(|cells| names.iter().cloned().zip(cells).collect()).collect()
}

fn value(row: &Row, name: &str) -> f64 {
    row[name].parse().unwrap_or_else(|_| panic!("{name} is {:?}", row[name]))
}

#[test]
fn conjugate_flanks_have_no_ease_off_and_touch_everywhere() {
    let directory = run_rigid("straight_bevel.cx", 2, &[]);
    let rows = table(directory.path(), "ease_off.csv");
    // The tips of both gears face fillets.
    assert!(rows.len() > 25 * 17 * 3 / 5, "{}", rows.len());
    for row in &rows {
        assert!(value(row, "ease_off") < 2e-7, "{row:?}");
        assert!(value(row, "gap") < 2e-7, "{row:?}");
    }
    let flanks = table(directory.path(), "tooth_flanks.csv");
    assert!(flanks.iter().all(|row| row["shape"] == "straight" && row["conical"] == "true"));
    let page = fs::read_to_string(directory.path().join("run/report.html")).expect("a report");
    for text in ["Tooth contact", "\ntoe\n", "\nheel\n", "clockwise flank (drive)"] {
        assert!(page.contains(text), "{text}");
    }
}

/// Flanks that are nearly undercut have a curvature that grows towards the fillet. The number of
/// points of a flank is chosen for it; with 17 points, the transmission error reaches 3e-8 rad.
#[test]
fn conjugate_flanks_have_no_transmission_error_near_undercut() {
    let given = [("pressure_angle", "20 deg"), ("edge_radius", "0.3 mm")];
    let directory = run_rigid("straight_bevel.cx", 8, &given);
    for row in table(directory.path(), "steps.csv") {
        let error = value(&row, "transmission_error");
        assert!(error.abs() < 1e-9, "{error}");
    }
}

/// The path of contact from the surfaces of the flanks agrees with the analysis of rigid bodies.
/// The unloaded contact of chapter 6's pair reaches the tip of the pinion, whose edge touches until
/// the next tooth pair overtakes.
#[test]
fn unloaded_contact_agrees_with_the_rigid_analysis() {
    let directory = run_rigid("spiral_bevel.cx", 4, &[]);
    let path = table(directory.path(), "unloaded_contact.csv");
    let touching: Vec<&Row> = path.iter().filter(|row| row["touches"] == "true").collect();
    let pitch = TAU / 12.0;
    let errors: Vec<[f64; 2]> =
        touching.iter().map(|row| ["rotation", "transmission_error"].map(|name| value(row, name))).collect();
    let length = errors[errors.len() - 1][0] - errors[0][0];
    assert!((length - pitch * 23.0 / 24.0).abs() < 1e-9, "{length}");
    for row in table(directory.path(), "steps.csv") {
        // The pinion rotates at 60 rpm.
        let rotation = TAU * value(&row, "time");
        let shifted = rotation - ((rotation - errors[0][0]) / pitch).floor() * pitch;
        let next = errors.iter().position(|error| error[0] > shifted).unwrap_or(errors.len() - 1).max(1);
        let ([x0, y0], [x1, y1]) = (errors[next - 1], errors[next]);
        let expected = y0 + (shifted - x0) / (x1 - x0) * (y1 - y0);
        let found = value(&row, "transmission_error");
        // Linear interpolation of a curve with a range of 600 urad.
        assert!((found - expected).abs() < 3e-6, "{rotation}: {found} {expected}");
    }
    let [first, last] = [touching[0], touching[touching.len() - 1]];
    assert!(value(first, "first_along_profile") > 0.2 && first["edge"] == "false");
    assert!(value(last, "first_along_profile") > 0.95 && last["edge"] == "true");
    let smallest = table(directory.path(), "ease_off.csv");
    let smallest = smallest.iter().min_by(|a, b| value(a, "ease_off").total_cmp(&value(b, "ease_off")));
    let along = value(smallest.expect("points"), "first_along_face");
    assert!((0.3..0.6).contains(&along), "{along}");
    let flanks = table(directory.path(), "tooth_flanks.csv");
    for (body, shape) in [("pinion", "concave"), ("gear", "convex")] {
        let of: Vec<&Row> = flanks.iter().filter(|row| row["body"] == body).collect();
        assert!(of.iter().all(|row| row["shape"] == shape), "{body}");
        let longest = of.iter().map(|row| value(row, "distance")).fold(0.0, f64::max);
        assert!((longest - 0.0254).abs() < 1e-9, "{longest}");
    }
}
