//! Tests of errors and warnings as text.

use calyx_abi::RuntimeError;
use calyx_abi::description::{CallDescription, FileDescription, ModelDescription};
use calyx_gears::error::Severity;
use calyx_rt::InvalidParam;
use calyx_rt::messages::{problem, refused};

#[test]
fn control_characters_of_the_source_do_not_reach_the_terminal() {
    let text = "var a = \"\u{1b}]0;title\u{7}\"; a[3];\n";
    let file = FileDescription { name: "\u{1b}[2Jm.cx".into(), text: text.into() };
    let description = ModelDescription { files: [file].into(), ..ModelDescription::default() };
    let place = Some((0, 22, 26));
    let error = RuntimeError { place, ..RuntimeError::new("E0701", "\u{1b}[31mindex 3", "\u{9b}2J less") };
    let shown = problem(Severity::Error, &error, &description);
    let expected = "error[E0701]: ␛[31mindex 3\n  --> ␛[2Jm.cx:1:23\n   |\n 1 | var a = \"␛]0;title␇\"; a[3];\n   |                       ^^^^\n  help: \u{fffd}2J less\n";
    assert_eq!(shown, expected);
    let why = InvalidParam::new("no param `\u{1b}[31m`", "\u{202e}");
    assert_eq!(refused(&why), "error: no param `␛[31m`\n  help: \u{fffd}\n");
}

#[test]
fn the_line_is_shown_and_marked() {
    let description = ModelDescription {
        files: [FileDescription { name: "m.cx".into(), text: "var é = 1;\n\tprint(é[3]);\n".into() }].into(),
        ..ModelDescription::default()
    };
    let error = RuntimeError { place: Some((0, 22, 23)), ..RuntimeError::new("E0701", "index 3", "less") };
    let expected =
        "error[E0701]: index 3\n  --> m.cx:2:10\n   |\n 2 | \tprint(é[3]);\n   | \t        ^\n  help: less\n";
    assert_eq!(problem(Severity::Error, &error, &description), expected);
    let mut called = error.clone();
    called.passed("f", (0, 13, 18));
    assert_eq!(
        problem(Severity::Error, &called, &description),
        format!("{expected}  in `f`, called at m.cx:2:2\n")
    );
    // An error about an argument is located at the argument, and a warning has the code of a
    // warning.
    let calls = vec![CallDescription {
        place: (0, 13, 24),
        arguments: vec![("x".into(), (0, 22, 23))],
        carried: Vec::new(),
        function: String::new(),
    }];
    let blamed = RuntimeError { place: Some((0, 13, 24)), ..error.clone().of_argument("x") };
    let description = ModelDescription { calls, ..description };
    let warning = expected.replacen("error[E", "warning[W", 1);
    assert_eq!(problem(Severity::Warning, &blamed, &description), warning);
    // A location outside of the file is omitted.
    let nowhere = RuntimeError { place: Some((0, 400, 401)), ..error };
    assert_eq!(problem(Severity::Error, &nowhere, &description), "error[E0701]: index 3\n  help: less\n");
}
