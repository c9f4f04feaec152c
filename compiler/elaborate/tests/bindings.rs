//! Tests the display form of `:=` definitions.

use calyx_elaborate::ModelLoader;
use calyx_elaborate::binding::{Binding, binding, definition_in};
use calyx_lang::ir::Program;

fn program(text: &str) -> Program {
    let checked = calyx_lang::check_program("model.cx", text, &ModelLoader::default());
    checked.program.unwrap_or_else(|| panic!("{:?}", checked.diagnostics))
}

/// Returns the binding in the statement that begins with `head`.
fn of(text: &str, head: &str) -> Option<Binding> {
    let start = text.find(head).unwrap_or_else(|| panic!("no {head}"));
    let end = start + text[start..].find(";").expect("an end");
    let program = program(text);
    binding(&program, definition_in(&program, 0, start as u32, end as u32)?)
}

fn shown(text: &str, head: &str) -> String {
    let Some(binding) = of(text, head) else { return "nothing".into() };
    let symbols: Vec<String> = binding.symbols.iter().map(|s| format!("{:?} {}", s.kind, s.name)).collect();
    let mut lines = Vec::new();
    match &binding.expression {
        None => lines.push("too long".to_owned()),
        Some(infix) => {
            lines.push(format!("{}{}", infix.value, if infix.bare { " [SI]" } else { "" }));
            lines.extend(infix.parts.iter().map(|(name, part)| format!("{name} = {part}")));
        }
    }
    format!("{} | {} | {}", lines.join("\n"), symbols.join(", "), binding.operations)
}

const MOTION: &str = "
param speed = 3 rpm;
param r = 50 mm;
const rise = 4 mm;
var k = 2.5;
var th := speed * Time;
var x := r * cos(th) + k * r * sin(2 * th) + rise;
var v := derivative(x, Time);
var X := Rotate(th, e3) * Translate(r * e1 + rise * e2);
var p := X * (r * e2);
var shape := if (r > 20 mm) sin(th)^3 else exp(-Time / 4 s);
var _unused := 2 * Time;
var w := -(th - 0.5 rad) * (th - 7 rad)^2 / (k * (th + 1 rad));
function f(in u, in t) := u^2 + t * speed;
print(v at Time = 0.1 s, p at Time = 0.1 s, X at Time = 0 s, shape at Time = 1 s, w at Time = 0 s);
print(f((4 rad)^0.5, 3 s) at Time = 1 s);
";

#[test]
fn expressions_read_as_they_are_written() {
    for (head, expected) in [
        ("var th", "speed * Time | Time Time, Param speed | 1"),
        (
            "var x",
            "r * cos(speed * Time) + r * k * sin(2 * speed * Time) + rise | Time Time, Param r, Param speed, Captured k | 9",
        ),
        (
            "var X",
            "Rotate(speed * Time, e3) * Translate(r * e1 + rise * e2) | Time Time, Param r, Param speed | 1",
        ),
        (
            "var shape",
            "if (20 mm < r) sin(speed * Time)^3 else exp(-Time / 4 s) | Time Time, Param r, Param speed | 9",
        ),
        ("var _unused", "nothing"),
        ("function f", "u^2 + t * speed | Param speed, Argument t, Argument u | 3"),
    ] {
        assert_eq!(shown(MOTION, head), expected, "{head}");
    }
}

#[test]
fn derivatives_are_taken_and_simplified() {
    assert_eq!(
        shown(MOTION, "var v"),
        "speed * (r * k * 2 * cos(2 * speed * Time) - r * sin(speed * Time)) | Time Time, Param r, Param speed, Captured k | 10"
    );
    assert_eq!(
        shown(MOTION, "var w"),
        "-(speed * Time - 0.5 rad) * (speed * Time - 7 rad)^2 / (k * (speed * Time + 1)) | Time Time, Param speed, Captured k | 9"
    );
}

#[test]
fn what_is_used_again_and_long_gets_a_name() {
    assert_eq!(
        shown(MOTION, "var p"),
        "((r - rise) * sin(speed * Time) - r * cos(speed * Time)) * e1 + (r * sin(speed * Time) + (r - rise) * cos(speed * Time)) * e2 | Time Time, Param r, Param speed | 10"
    );
    let text = "param a = 2; param u1 = 1;\n\
        var y := sin(sqrt(a * Time / 3 s + u1)) + cos(sqrt(a * Time / 3 s + u1));\n\
        print(y at Time = 1 s);";
    assert_eq!(
        shown(text, "var y"),
        "sin(v1) + cos(v1)\nv1 = sqrt(a * Time / 3 s + u1) | Time Time, Param a, Param u1 | 7"
    );
}

#[test]
fn numbers_that_were_computed_say_that_they_are_in_si() {
    let text = "param a = 2 mm;\nvar y := a * sin(2 * pi * 50 / 1 s * Time);\nprint(y at Time = 1 s);";
    assert_eq!(shown(text, "var y"), "a * sin(314.159 * Time) [SI] | Time Time, Param a | 3");
}

#[test]
fn what_nobody_reads_is_counted_only() {
    let terms: Vec<String> =
        (1..100).map(|n| format!("sin({n} * Time / 1 s) * exp({n} * Time / 1 s)")).collect();
    let text = format!("var y := {};\nprint(y at Time = 1 s);", terms.join(" + "));
    assert_eq!(shown(&text, "var y"), "too long | Time Time | 493");
}

#[test]
fn an_expression_chosen_when_the_model_runs_is_a_symbol() {
    let text = "var X := Translate(0 mm * e1);\n\
        for (var i = 0; i < 3; i = i + 1) { X := X * Rotate(i * 1 rad/s * Time, e3); }\n\
        var o := origin(X);\nprint(o at Time = 0 s);";
    assert_eq!(shown(text, "X := X"), "X * Rotate(i * Time, e3) | Time Time, Captured X, Captured i | 1");
    assert!(shown(text, "var o").ends_with("| Captured X | 18"), "{}", shown(text, "var o"));
}

#[test]
fn outputs_name_what_they_observe() {
    let text = include_str!("../../../examples/spur_pair.cx");
    assert_eq!(
        shown(text, "output transmission_error_length"),
        "gears.transmission_error(mesh) * gears.base_radius(gear_blank) | \
         Captured gears.base_radius(gear_blank), Observable gears.transmission_error(mesh) | 1"
    );
    let frame = "frame := Rotate(-speed";
    assert_eq!(
        shown(text, frame),
        "Rotate(-20 * speed / 40 * Time, e3) * Translate(center_distance * e1) | \
         Time Time, Param center_distance, Captured speed | 3"
    );
}
