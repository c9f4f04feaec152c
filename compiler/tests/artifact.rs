//! Checks that a serialized and loaded module is equivalent to the compiled one, even after its
//! source files are deleted.

use calyx::rt::run::RunError;
use calyx::rt::{Error, ParamAssignment, RunOptions, run};
use calyx::{Checked, Engine, Module, TargetCpu, check_file, check_text, is_artifact};
use calyx_lang::diagnostic::Diagnostic;
use std::fs;
use std::path::Path;

fn loaded(bytes: &[u8]) -> Module {
    assert!(is_artifact(bytes));
    // SAFETY: this process has just written the bytes.
    unsafe { Module::deserialize(&Engine::default(), bytes) }.unwrap_or_else(|error| panic!("{error}"))
}

fn compiled(checked: Checked) -> Module {
    Module::from_checked(&Engine::default(), checked).unwrap()
}

/// Returns the result of a run: its table and findings, or its error as shown to users.
fn outcome(module: &Module, set: &[(&str, &str)]) -> Result<(String, Vec<Diagnostic>), Box<Diagnostic>> {
    let directory = tempfile::tempdir().unwrap();
    let given: Vec<_> = set.iter().map(|(name, value)| ParamAssignment::text(*name, *value)).collect();
    let options =
        RunOptions { directory: directory.path().into(), given, quiet: true, ..RunOptions::default() };
    match run(module.as_program(), &options) {
        Ok(report) => {
            let table = fs::read_to_string(directory.path().join("steps.csv")).unwrap_or_default();
            Ok((table, module.findings(&report.findings)))
        }
        Err(RunError::Run(Error::Model(error))) => Err(Box::new(module.error(&error))),
        Err(error) => panic!("{error:?}"),
    }
}

/// Checks that two modules have equal descriptions and diagnostics.
fn same_answers(a: &Module, b: &Module) {
    assert_eq!(a.description(), b.description());
    let files = |module: &Module| -> Vec<(String, String)> {
        module.files().iter().map(|file| (file.name.clone(), file.text.clone())).collect()
    };
    assert_eq!(files(a), files(b));
    assert_eq!(a.has_errors(), b.has_errors());
    assert_eq!(a.kernel_names(), b.kernel_names());
    for name in a.kernel_names() {
        let (a, b) = (a.kernel(name).unwrap(), b.kernel(name).unwrap());
        assert_eq!((a.name(), a.doc()), (b.name(), b.doc()));
        assert_eq!((a.arguments(), a.outputs()), (b.arguments(), b.outputs()));
    }
    assert_eq!(a.serialize().unwrap(), b.serialize().unwrap());
}

#[test]
fn a_loaded_model_gives_the_same_bits() {
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    let module = compiled(check_file(&model).unwrap());
    let set = [("steps", "2"), ("fidelity", "plane")];
    let expected = outcome(&module, &set);
    assert!(expected.as_ref().is_ok_and(|(table, _)| table.lines().count() > 2), "{expected:?}");
    for cpu in [TargetCpu::Native, TargetCpu::Baseline] {
        let loaded = loaded(&module.serialize_for(cpu).unwrap());
        assert_eq!(outcome(&loaded, &set), expected, "{cpu:?}");
        same_answers(&module, &loaded);
    }
}

#[test]
fn a_loaded_calculation_gives_the_same_bits() {
    let text = "param d = 20 mm; output area := pi * d^2 / 4; output all := [d / i for i in 1 .. 3];";
    let module = compiled(check_text("model.cx", text));
    let set = [("d", "0.3 inch")];
    let expected = outcome(&module, &set);
    assert!(expected.as_ref().is_ok_and(|(table, _)| table.lines().count() == 2), "{expected:?}");
    let loaded = loaded(&module.serialize_for(TargetCpu::Baseline).unwrap());
    assert_eq!(outcome(&loaded, &set), expected);
}

/// Values that anonymous functions capture, and the error of an index beyond an array.
#[test]
fn captured_values_of_a_loaded_model_give_the_same_bits() {
    let module = compiled(check_text("captures.cx", include_str!("data/captures.cx")));
    let loaded = loaded(&module.serialize().unwrap());
    let set = [("level", "6 mm"), ("low.load", "7 N")];
    let expected = outcome(&module, &set);
    assert!(expected.as_ref().is_ok_and(|(table, _)| table.lines().count() == 2), "{expected:?}");
    assert_eq!(outcome(&loaded, &set), expected);
    let beyond = [("heights", "[1, 2] mm")];
    let expected = outcome(&module, &beyond);
    assert_eq!(expected.as_ref().map_err(|error| error.code.as_str()), Err("E0701"));
    assert_eq!(outcome(&loaded, &beyond), expected);
    same_answers(&module, &loaded);
}

/// Params of every kind, kernels, and an imported module that is deleted before the artifact is
/// loaded.
#[test]
fn a_loaded_model_needs_none_of_its_files() {
    let directory = tempfile::tempdir().unwrap();
    fs::create_dir(directory.path().join("parts")).unwrap();
    fs::write(
        directory.path().join("parts/arm.cx"),
        "function reach(in length) { return if (length > 0 mm) 2*length else refuse(\"short\", 0); }
         function refuse(in what, in n) { assert(FALSE, what); return n * 1 mm; }",
    )
    .unwrap();
    let model = directory.path().join("model.cx");
    fs::write(
        &model,
        "units mm_N_s; import parts.arm;
         param length = 3 mm in -1 mm .. 4 mm; param long = FALSE; param label = \"a\" in [\"a\", \"b\"];
         /// Its end.
         function end(in turn) := length*cos(turn);
         print(\"{arm.reach(length)} {label} {long} {end(0) at Time = 0 s}\");",
    )
    .unwrap();
    let checked = check_file(&model).unwrap();
    assert!(!checked.has_errors(), "{}", checked.render());
    let module = compiled(checked);
    let bytes = module.serialize().unwrap();
    drop(directory);
    let loaded = loaded(&bytes);
    assert!(outcome(&loaded, &[]).is_ok());
    // An error inside the deleted module, with its call stack.
    let failed = outcome(&loaded, &[("length", "-1 mm")]);
    let diagnostic = failed.clone().unwrap_err();
    assert_eq!(diagnostic.code, "E0705", "{diagnostic:?}");
    assert_eq!(failed, outcome(&module, &[("length", "-1 mm")]));
    same_answers(&module, &loaded);
    let values = |module: &Module| {
        let params = module.param_values(&[("length", "2 mm")]).unwrap();
        module.kernel("end").unwrap().evaluate(&params, &[0.5]).unwrap()
    };
    assert_eq!(values(&module), values(&loaded));
}

/// The source of a NaN is determined from the stored sources.
#[test]
fn a_loaded_model_traces_nan() {
    let text = "units mm_N_s; param x = 1 in -1 .. 1;
        var angle := sqrt(x)*Time*(1 rad/s); var frame := Rotate(angle, e3);
        var q = origin(frame at Time = 1 s); var n = sqrt(x); assert(n == n, \"not a number\");";
    let module = compiled(check_text("nan.cx", text));
    let loaded = loaded(&module.serialize().unwrap());
    let expected = outcome(&module, &[("x", "-1")]);
    assert!(expected.is_err());
    assert_eq!(outcome(&loaded, &[("x", "-1")]), expected);
}

#[test]
fn many_threads_share_a_loaded_module() {
    let text = "param n = 5 in 0 .. 20; function f(in n) { return if (n < 2) 1 else n*f(n - 1); }
        assert(f(n) > 0, \"{f(n)}\");";
    let module = loaded(&compiled(check_text("f.cx", text)).serialize().unwrap());
    std::thread::scope(|scope| {
        for n in 0..20 {
            let module = &module;
            scope.spawn(move || {
                assert!(outcome(module, &[("n", &n.to_string())]).is_ok());
                assert!(module.kernel_names().is_empty());
            });
        }
    });
}
