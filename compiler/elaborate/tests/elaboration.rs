//! Tests that elaboration ends, can be cancelled, and continues after problems of the model.

use calyx_elaborate::values::{default_of, range_of};
use calyx_elaborate::{
    Cancel, Cancelled, Elaboration, ModelLoader, Override, ParamAssignment, Params, elaborate,
};
use calyx_lang::dimension::Dimension;
use calyx_lang::ir::Program;
use std::thread;
use std::time::Duration;

fn program(text: &str) -> Program {
    let checked = calyx_lang::check_program("model.cx", text, &ModelLoader::default());
    checked.program.unwrap_or_else(|| panic!("{:?}", checked.diagnostics))
}

fn elaborated(text: &str) -> Elaboration {
    elaborate(&program(text), Params::Defaults, &Cancel::default()).expect("nobody cancels")
}

fn codes(elaboration: &Elaboration) -> Vec<&str> {
    elaboration.found.iter().map(|found| found.code.as_str()).collect()
}

#[test]
fn what_is_cancelled_before_it_begins_does_not_run() {
    let cancel = Cancel::default();
    cancel.cancel();
    assert_eq!(elaborate(&program("print(1);"), Params::Defaults, &cancel).unwrap_err(), Cancelled);
}

#[test]
fn another_thread_cancels_a_loop_without_end() {
    // A run has no limit of steps that would end it before the cancellation.
    let (program, cancel) = (program("var n = 0; while (n >= 0) { n = n + 1; }"), Cancel::default());
    let switch = cancel.clone();
    let ended = thread::scope(|scope| {
        scope.spawn(move || {
            thread::sleep(Duration::from_millis(20));
            switch.cancel();
        });
        elaborate(&program, Params::Defaults, &cancel)
    });
    assert!(ended.is_err());
}

#[test]
fn a_loop_without_end_is_found() {
    assert_eq!(codes(&elaborated("while (TRUE) {}")), ["W0703"]);
    // A run has a memory limit only if one is given.
    let text = "var text = \"x\"; for (i in 0 .. 40) text = \"{text}{text}\";";
    assert_eq!(codes(&elaborated(text)), ["W0707"]);
}

#[test]
fn the_last_printed_lines_are_kept() {
    assert_eq!(elaborated("print(\"first\");").printed, ["first"]);
    let line = "x".repeat(999);
    let lines = elaborated(&format!("print(\"first\"); for (i in 0 .. 64) print(\"{line}\");")).printed;
    assert_eq!((lines.len(), lines[0].as_str()), (65, "... (1 line before)"));
    assert!(lines[1..].iter().all(|kept| *kept == line));
}

#[test]
fn params_from_outside_are_used_or_refused() {
    let program = program("param n = 3 in 1 .. 5; assert(n < 4);");
    let given = |text: &str| [ParamAssignment::text("n", text)];
    let ended = |text: &str| {
        elaborate(&program, Params::Given(&given(text), Override::default(), None), &Cancel::default())
            .unwrap()
    };
    assert!(codes(&ended("2")).is_empty());
    assert_eq!(codes(&ended("5")), ["E0705"]);
    assert!(ended("9").refused.is_some_and(|refused| refused.message.contains("`n`")));
    // The description has the ranges of the model, not those of the run.
    assert_eq!(ended("2").description.params[0].high, Some(5.0));
}

#[test]
fn a_program_that_the_engine_cannot_run_says_why() {
    let ended = elaborated("extern pure function nowhere(in x: Number) -> Number; print(nowhere(1));");
    assert_eq!((codes(&ended), ended.runnable), (vec!["E0708"], false));
}

/// A loop of the library builds a mesh with sun and ring for each planet; both have an error.
#[test]
fn the_errors_of_a_loop_are_reported_once() {
    let text = "import gears;
        var steel = gears.material(206 GPa, 0.3);
        var rack = gears.rack(module = 2 mm, tip_radius = 0.5 mm);
        var gear = gears.external(20, rack, 10 mm, 44 mm, 35 mm, steel, gears.simple_rim(30 mm, 20 mm),
            tooth_thickness = 3.1 mm);
        var shaper = gears.shaper(20, module = 2 mm, tip_radius = 0.2 mm);
        var ring = gears.internal(64, shaper, 10 mm, 124.4 mm, 133 mm, steel, gears.outer_rim(138 mm, 158 mm),
            tooth_thickness = 3.1 mm);
        var set = gears.planetary(gear, gear, ring, 4 mm, planets = 4, sun_speed = 9 rpm, sun_torque = 9 N*m);
        print(set.mesh_period);";
    assert_eq!(codes(&elaborated(text)), ["E0631", "E0631"]);
}

#[test]
fn values_are_those_at_the_end_in_units_of_the_file() {
    let ended = elaborated(
        "units mm_N_s;
         /// How wide.
         param width = 3 mm in 1 mm .. 20 mm;
         param kind = \"wide\" in [\"wide\", \"slim\"];
         var length = 2 * width;
         length = length + 1 inch;
         var at = length * e1 - 2 mm * e3;
         var long = length > 1 mm;
         var name = \"{kind}\";
         var moving := length * Time;
         for (var i = 0; i < 2; i = i + 1) { var twice = i; print(twice); }
         for (var k = 0; k < 2; k = k + 1) { var twice = 7 * k; print(twice, moving at Time = 1 s, at, long, name); }",
    );
    assert!(ended.found.is_empty(), "{:?}", ended.found);
    let shown = |name: &str, dimension: &str| {
        let dimension = Dimension::from_name(dimension).unwrap_or(Dimension::NONE);
        ended.values.get(name)?.shown(dimension, "mm_N_s")
    };
    assert_eq!(shown("length", "Length").as_deref(), Some("31.4 mm"));
    assert_eq!(shown("at", "Length").as_deref(), Some("(31.4, 0, -2) mm"));
    assert_eq!(shown("long", "").as_deref(), Some("TRUE"));
    assert_eq!(shown("name", "").as_deref(), Some("\"wide\""));
    assert_eq!((shown("moving", "Length"), shown("twice", "")), (None, None));
    let [width, kind] = &ended.description.params[..] else { panic!("two params") };
    assert_eq!([default_of(width), range_of(width)].map(Option::unwrap), ["3 mm", "1 mm .. 20 mm"]);
    assert_eq!([default_of(kind), range_of(kind)].map(Option::unwrap), ["\"wide\"", "\"wide\", \"slim\""]);
}

/// Elaborations share kernels of equal sites. These sites differ in one part each: an operation, a
/// number, the function that they call, the symbol of a derivative, the captured value.
#[test]
fn kernels_of_earlier_elaborations_serve_equal_sites_only() {
    let model = |function: &str, value: &str, p: &str| {
        let text = format!(
            "function f(in x, in y) := {function};\nfunction g(in x, in y) := x*y;\n\
             var p = {p}; var t := Time / (1 s);\nvar v := {value};\nprint(v at Time = 3 s);"
        );
        elaborated(&text).printed
    };
    let cases = [
        ("x^2 + y", "f(t, p)", "4", "13"),
        ("x^3 + y", "f(t, p)", "4", "31"),
        ("x^2 - y", "f(t, p)", "4", "5"),
        ("x^2 + 2*y", "f(t, p)", "4", "17"),
        ("x^2 + y", "f(p, t)", "4", "19"),
        ("x^2 + y", "g(t, p)", "4", "12"),
        ("derivative(x^2 + y, x)", "f(t, p)", "4", "6"),
        ("derivative(x^2 + y, y)", "f(t, p)", "4", "1"),
        ("x^2 + y", "f(t, p)", "5", "14"),
        ("x^2 + y", "f(t, p) + f(t, p)", "4", "26"),
        ("x^2 + y", "f(t, p) + g(t, p)", "4", "25"),
    ];
    for _ in 0..2 {
        for (function, value, p, expected) in cases {
            assert_eq!(model(function, value, p), [expected], "{function}, {value}, {p}");
        }
    }
}
