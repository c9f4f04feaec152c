//! Computing times of bevel gears: `cargo bench -p calyx --bench bevel`. They cover points of a
//! flank with and without sensitivities, the check of `examples/spiral_bevel.cx` as a whole and
//! after edits as editors run it, and its analysis over a mesh cycle without and with cached
//! structures. Times depend on the machine; the last column is the ratio to a time measured before
//! in the same run.

use calyx::{Engine, Module, Override, check_text};
use calyx_elaborate::{Cancel, ModelLoader, Params, elaborate};
use calyx_lang::db::Database;
use calyx_runtime::estimate::Estimates;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Repetitions of a run, of which the fastest counts.
const RUNS: usize = 5;
/// Numbers of points of the two loops over flank points; their difference excludes everything else.
const POINTS: [u32; 2] = [2_000, 22_000];
/// Points of a measuring grid with sensitivities, and its repetitions.
const GRIDS: [u32; 2] = [2, 22];

/// Settings of the pinion of the aerospace pair, and two loops over the points of its flank.
const FLANK: &str = r#"
import bevel;
import envelope;
units inch_lbf_s;
/// Points one by one.
param points = 0 in 0 .. 1000000;
/// Measuring grids of 5 by 9 points with the sensitivities of each point to all settings.
param grids = 0 in 0 .. 1000000;
var settings = bevel.Settings(
    bevel.Cutter(2.965621 inch, 18.04567 deg, edge_radius = 0.045 inch),
    root_angle = 16.8666 deg,
    center_to_back = -0.04023062 inch,
    radial_setting = 2.947802 inch,
    cradle_angle = 63.94203 deg,
    blank_offset = 0.1545759 inch,
    sliding_base = 0.01167273 inch,
    ratio_of_roll = 3.242698536);
var pinion = bevel.BevelGear("generated", 12, "left", concave = settings, convex = settings);
var blank = bevel.Blank(3.691, 1, 18.433 deg, 22.31667 deg, 16.8666 deg);
var at = bevel.section_point(pinion, blank, 0.5, 0.5);
var first = bevel.flank_point(pinion, "concave", at.x, at.z);
var sum = 0 inch;
for (k in 0 .. points) {
    var moved = 0.2 inch * (k / points - 0.5);
    var point = bevel.flank_point_near(pinion, "concave", first.parameters, at.x, at.z + moved);
    sum = sum + point.point.x;
}
for (k in 0 .. grids) {
    var grid = bevel.measuring_grid(pinion, "concave", blank, margin = 0.2);
    for (line in grid)
        for (point in line) {
            var by = bevel.flank_sensitivities(pinion, "concave", point);
            sum = sum + 0.001 * by.center_to_back * 1 inch;
        }
}
print(sum);
"#;

fn example() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spiral_bevel.cx")
}

/// Returns the shortest time of some runs, s.
fn shortest(runs: usize, mut run: impl FnMut()) -> f64 {
    let once = |_| {
        let begun = Instant::now();
        run();
        begun.elapsed().as_secs_f64()
    };
    (0..runs).map(once).fold(f64::INFINITY, f64::min)
}

/// Returns the time of one repetition of a loop of [`FLANK`], s.
fn repetition(module: &Module, param: &str, counts: [u32; 2]) -> f64 {
    let [few, many] = counts.map(|count| {
        shortest(RUNS, || {
            let mut instance = module.instantiate();
            instance.set(param, f64::from(count)).expect("in range");
            instance.solve().expect("flank points");
        })
    });
    (many - few) / f64::from(counts[1] - counts[0])
}

/// Edits of the example: what they change, a text, and the text that replaces it, where `#` is the
/// number of the edit. No edit repeats an earlier one.
const EDITS: [(&str, &str, &str); 5] = [
    ("a comment", "// The pair and its load.", "// The pair and its load, #."),
    ("the torque", "2613.33 lbf", "2613.33# lbf"),
    ("an axial displacement", "pinion_axial = 0 inch", "pinion_axial = 0.0000# inch"),
    ("an edge radius", "edge_radius_pinion = 0.045 inch", "edge_radius_pinion = 0.045# inch"),
    ("a machine setting", "2.947802 inch", "2.947802# inch"),
];

/// Returns the shortest time of a check after an edit, s, with the database of an editor, and the
/// part of the language in it.
fn after_edits(text: &str, [old, new]: [&str; 2]) -> [f64; 2] {
    let loader = ModelLoader::default();
    let mut database = Database::new(&loader);
    let mut check = |text: &str| {
        let begun = Instant::now();
        database.set_model("model.cx", text);
        database.load_imports("model.cx", &loader);
        let checked = database.check("model.cx").expect("the model is there");
        let language = begun.elapsed().as_secs_f64();
        let program = checked.program.as_ref().expect("a program");
        let found = elaborate(program, Params::Defaults, &Cancel::default()).expect("nobody cancels");
        assert!(found.plan.is_some(), "{:?}", found.found);
        [begun.elapsed().as_secs_f64(), language]
    };
    check(text);
    assert!(text.contains(old), "the edit changes the model");
    // Odd numbers do not end in zeros, which would leave a decimal fraction as it is.
    let odd = (0..2 * RUNS).map(|edit| (2 * edit + 1).to_string());
    let edits = odd.map(|number| check(&text.replace(old, &new.replace('#', &number))));
    edits.min_by(|a, b| a[0].total_cmp(&b[0])).unwrap_or_default()
}

fn main() {
    let row =
        |what: &str, time: f64, ratio: String| println!("{what:<58} {:>12.4} ms {ratio:>14}", 1e3 * time);
    let engine = Engine::default();
    let checked = check_text("flank.cx", FLANK);
    let flank = Module::from_checked(&engine, checked).expect("the model compiles");
    let point = repetition(&flank, "points", POINTS);
    row("point of a flank with its normal", point, String::new());
    let grid = repetition(&flank, "grids", GRIDS);
    row("grid of 5 x 9 points with 23 sensitivities each", grid, format!("{:.0} points", grid / point));

    let text = std::fs::read_to_string(example()).expect("the example");
    let check = shortest(RUNS, || assert!(!check_text("spiral_bevel.cx", &text).has_errors()));
    row("check of spiral_bevel.cx", check, format!("{:.0} points", check / point));

    for (what, old, new) in EDITS {
        let [time, language] = after_edits(&text, [old, new]);
        row(&format!("check after an edit of {what}"), time, format!("{:.2} language", language / time));
    }

    for fidelity in ["rigid", "medium", "finest"] {
        let engine = Engine::default();
        let module = Module::from_file(&engine, example()).expect("the example compiles");
        let cycle = |error_estimates: Option<Estimates>| {
            let mut instance = module.instantiate();
            instance.set("fidelity", fidelity).expect("a level");
            instance.set("steps", 11).expect("in range");
            instance.override_analysis(Override { error_estimates, ..Override::default() });
            instance.solve().expect("an equilibrium");
        };
        let cold = shortest(1, || cycle(None));
        row(&format!("11 positions at {fidelity}"), cold, String::new());
        let again = [("cached structures", None), ("without error estimates", Some(Estimates::None))];
        for (what, error_estimates) in again {
            let cached = shortest(1, || cycle(error_estimates));
            let ratio = format!("{:.3} of cold", cached / cold);
            row(&format!("11 positions at {fidelity}, {what}"), cached, ratio);
        }
    }
}
