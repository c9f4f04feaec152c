//! Tests of params files.

use calyx_rt::InvalidParam;
use calyx_rt::param_assignment::{AssignedValue, Origin, ParamAssignment};
use calyx_rt::params_file::read;

fn parsed(format: &str, text: &str) -> Result<Vec<ParamAssignment>, InvalidParam> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(format!("params.{format}"));
    std::fs::write(&file, text).unwrap();
    read(&file)
}

#[test]
fn both_formats_say_the_same() {
    let json =
        "{\"$schema\": \"params.json\", \"torque\": 0.1,\n \"tip\": \"0.5 mm\", \"edges\": false, \"n\": 12}";
    let toml = "# A variant.\ntorque = 0.1\ntip = '0.5 mm'\nedges = false\nn = 12\n";
    for (format, text) in [("json", json), ("toml", toml)] {
        let all = parsed(format, text).unwrap();
        let values: Vec<_> = all.iter().map(|given| (given.name.as_str(), &given.value)).collect();
        let (tip, no) = (AssignedValue::String("0.5 mm".into()), AssignedValue::Bool(false));
        let (torque, n) = (AssignedValue::Number(0.1), AssignedValue::Number(12.0));
        assert_eq!(values, [("torque", &torque), ("tip", &tip), ("edges", &no), ("n", &n)], "{format}");
        let shown = |origin: &Option<Origin>| {
            let origin = origin.as_ref().unwrap();
            text[origin.start..origin.end].to_owned()
        };
        let tip = &all[1];
        assert!(shown(&tip.name_origin).trim_matches('"') == "tip", "{format}");
        assert!(shown(&tip.origin).trim_matches(['"', '\'']) == "0.5 mm", "{format}");
    }
    assert_eq!(parsed("toml", "n = 0x10").unwrap()[0].value, AssignedValue::Number(16.0));
    assert_eq!(parsed("toml", "n = 1_000.5").unwrap()[0].value, AssignedValue::Number(1000.5));
}

#[test]
fn params_of_instances_are_nested() {
    let json = "{\"low\": {\"torque\": 1, \"pinion\": {\"speed\": 2}}, \"stages\": [{}, {\"torque\": 3}]}";
    let toml = "[low]\ntorque = 1\npinion.speed = 2\n[[stages]]\n[[stages]]\ntorque = 3\n";
    let flat = "\"low.torque\" = 1\n\"low.pinion.speed\" = 2\n\"stages[1].torque\" = 3\n";
    for (format, text) in [("json", json), ("toml", toml), ("toml", flat)] {
        let all = parsed(format, text).unwrap();
        let names: Vec<_> = all.iter().map(|given| given.name.as_str()).collect();
        assert_eq!(names, ["low.torque", "low.pinion.speed", "stages[1].torque"], "{format}");
        let number = AssignedValue::Number(3.0);
        assert_eq!(all[2].value, number, "{format}");
    }
}

#[test]
fn what_is_no_param_is_refused_at_its_place() {
    for (format, text, message, marked) in [
        ("json", "{\"a\": [[1]]}", "`a` is an array of arrays", "[[1]]"),
        ("json", "{\"a\": null}", "`a` is null", "null"),
        ("json", "{\"a\": {\"b\": null}}", "`a.b` is null", "null"),
        ("json", "{\"a\": [{\"b\": 1}, 2]}", "`a` is an object", "[{\"b\": 1}, 2]"),
        ("json", "{\"a\": {\"b\": 1}, \"a.b\": 2}", "`a.b` is given twice", "\"a.b\""),
        ("json", "{\"a\": 1, \"a\": 2}", "`a` is given twice", "\"a\""),
        ("json", "{\"é\": 1,, }", "not as it should be: ", ""),
        ("json", "[1]", "expected an object of params", ""),
        ("json", "{} {}", "trailing characters", ""),
        ("json", "", "EOF", ""),
        ("toml", "a = [[1]]", "`a` is an array of arrays", "a"),
        ("toml", "[a]\nb = [[1]]", "`a.b` is an array of arrays", "b"),
        ("toml", "a = 2026-11-20", "`a` is a date", "a"),
        ("toml", "a = 1\na = 2", "duplicate key", "a"),
        ("toml", "a = 3 mm", "not as it should be", ""),
    ] {
        let refused = parsed(format, text).unwrap_err();
        assert!(refused.message.contains(message), "{text}: {}", refused.message);
        let origin = refused.origin.unwrap();
        let shown = &text[origin.start..origin.end];
        assert!(marked.is_empty() || shown == marked, "{text}: `{shown}`");
        assert!(!refused.help.is_empty());
    }
}

#[test]
fn files_of_another_kind_are_not_guessed() {
    assert!(read("params.yaml".as_ref()).unwrap_err().message.contains("neither a .json nor a .toml"));
    let missing = read("missing.json".as_ref()).unwrap_err();
    assert!(missing.message.starts_with("cannot read missing.json: "), "{}", missing.message);
}
