//! Benchmarks checks after edits, elaboration and its cancellation, on the gear pair of the report
//! and a model with many gears, and the formatting of a symbolic definition. Run it with `cargo
//! bench -p calyx-elaborate`. `cargo bench -p calyx --bench bevel` measures a spiral bevel pair.

use calyx_elaborate::binding::{binding, definition_in};
use calyx_elaborate::{Cancel, ModelLoader, Params, elaborate};
use calyx_lang::db::Database;
use calyx_lang::ir::Program;
use std::thread;
use std::time::{Duration, Instant};

/// Number of edits, of which the fastest counts.
const EDITS: usize = 6;

/// Number of cancellation times per model.
const CANCELLED: u32 = 200;

fn main() {
    edited("spur pair", include_str!("../../../examples/spur_pair.cx"), ["import gears;", "import gears; "]);
    measure("spur pair", &program(include_str!("../../../examples/spur_pair.cx")));
    measure("train of 60 gears", &program(&train(60)));
    tell("a frame of the pair", include_str!("../../../examples/spur_pair.cx"), "frame := Rotate(-speed");
    let joints: Vec<String> =
        (1..=8).map(|k| format!("Rotate({k} rpm * Time, e3) * Translate({k} mm * e1)")).collect();
    let arm = format!(
        "var X := {};\nvar a := derivative(derivative(origin(X), Time), Time);\nprint(a at Time = 1 s);",
        joints.join(" * ")
    );
    tell("the acceleration of an arm of 8 joints", &arm, "var a");
}

fn program(text: &str) -> Program {
    let checked = calyx_lang::check_program("model.cx", text, &ModelLoader::default());
    checked.program.unwrap_or_else(|| panic!("{:?}", checked.diagnostics))
}

/// Returns a model with a row of distinct gears, each meshed with the previous one.
fn train(gears: usize) -> String {
    let mut text = String::from(
        "import gears;\nunits mm_N_s;\nvar steel = gears.material(206 GPa, 0.3);\n\
         var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);\n",
    );
    for k in 0..gears {
        let speed = if k % 2 == 0 { "1" } else { "-1" };
        let free = if k + 1 < gears { ", free = [\"theta_z\"]" } else { "" };
        text += &format!(
            "var blank{k} = gears.external(teeth = 30, rack = rack, face_width = 10 mm, outer_diameter = 64 mm,\n    \
                 root_diameter = 55 mm, material = steel, rim = gears.simple_rim(45 mm, 30 mm), tooth_thickness = 3.1 mm);\n\
             var body{k} = gears.body(\"body{k}\", blank{k}{free}, moment = {} * e3,\n    \
                 frame := Rotate({speed} rpm * Time, e3) * Translate({} mm * e1));\n",
            if k == 0 { "1 N*m" } else { "0 N*m" },
            60 * k,
        );
        if k > 0 {
            text += &format!(
                "var mesh{k} = gears.mesh(body{}, body{k});\noutput share{k} := gears.load_share(mesh{k});\n",
                k - 1
            );
        }
    }
    text
}

/// Prints the time of the first check of a model, and that of a check after an edit that replaces
/// one text by the other, as editors make them: with the database of the first check.
fn edited(name: &str, text: &str, [old, new]: [&str; 2]) {
    let loader = ModelLoader::default();
    let mut database = Database::new(&loader);
    let mut check = |text: &str| {
        let began = Instant::now();
        database.set_model("model.cx", text);
        database.load_imports("model.cx", &loader);
        let checked = database.check("model.cx").expect("the model is there");
        let language = began.elapsed();
        let program = checked.program.as_ref().unwrap_or_else(|| panic!("{:?}", checked.diagnostics));
        elaborate(program, Params::Defaults, &Cancel::default()).expect("nobody cancels");
        [language, began.elapsed()]
    };
    let [_, first] = check(text);
    let other = text.replace(old, new);
    assert_ne!(text, other, "the edit changes the model");
    let edits = (0..EDITS).map(|edit| check(if edit % 2 == 0 { &other } else { text }));
    let [language, all] = edits.min_by_key(|[_, all]| *all).unwrap_or_default();
    println!(
        "{name}: first check in {first:.1?}, after an edit in {all:.1?} ({:.2} of the first; language {language:.1?})",
        all.as_secs_f64() / first.as_secs_f64()
    );
}

fn measure(name: &str, program: &Program) {
    let whole = (0..5).map(|_| {
        let began = Instant::now();
        let ended = elaborate(program, Params::Defaults, &Cancel::default()).expect("nobody cancels");
        assert!(ended.plan.is_some(), "{:?}", ended.found);
        began.elapsed()
    });
    let whole = whole.min().unwrap_or_default();
    let mut late: Vec<Duration> =
        (1..=CANCELLED).filter_map(|k| cancelled(program, whole * k / (CANCELLED + 1))).collect();
    late.sort();
    let at = |part: f64| late.get((part * (late.len() as f64 - 1.0)) as usize).copied().unwrap_or_default();
    println!(
        "{name}: elaborated in {whole:.1?}; cancelled at {} moments, it ended {:.1?} later (median), {:.1?} at 95 %, {:.1?} at most",
        late.len(),
        at(0.5),
        at(0.95),
        at(1.0)
    );
}

/// Prints the time to format the definition in the statement or argument that begins with `head`.
fn tell(name: &str, text: &str, head: &str) {
    let program = program(text);
    let start = text.find(head).expect("the definition is there");
    let end = start + text[start..].find(';').expect("it ends");
    let samples = (0..20).map(|_| {
        let began = Instant::now();
        let id = definition_in(&program, 0, start as u32, end as u32).expect("it is used");
        let binding = binding(&program, id).expect("it is a formula");
        (began.elapsed(), binding.operations)
    });
    let (time, operations) = samples.min().expect("it was told");
    println!("{name}, {operations} operations, as text in {time:.1?}");
}

/// Returns the time from cancellation to the end of an elaboration; `None` if it ended before.
fn cancelled(program: &Program, after: Duration) -> Option<Duration> {
    let cancel = Cancel::default();
    let switch = cancel.clone();
    thread::scope(|scope| {
        let working = scope.spawn(move || {
            let ended = elaborate(program, Params::Defaults, &cancel);
            (ended.is_err(), Instant::now())
        });
        thread::sleep(after);
        let at = Instant::now();
        switch.cancel();
        let (was_cancelled, ended) = working.join().ok()?;
        was_cancelled.then(|| ended.duration_since(at))
    })
}
