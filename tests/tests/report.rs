//! Checks that the two programs printed in the report compile, and behave equally in the
//! interpreter and as machine code.

use crate::models::engine;
use calyx::rt::{ParamAssignment, Program, apply};
use calyx::{Interpreted, Module, check_file};
use calyx_abi::{Context, Purity};
use calyx_gears::host::ModelHost;
use calyx_tests::root;
use std::sync::{Arc, Mutex};

/// Returns the lines that a model prints with some params set.
fn printed(program: &dyn Program, set: &[(&str, &str)]) -> Vec<String> {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let mut context = Context::new(Box::new(ModelHost::default()));
    context.kernels = program.kernels();
    let kept = lines.clone();
    context.print = Box::new(move |line| kept.lock().expect("one thread").push(line.to_string()));
    let given: Vec<ParamAssignment> =
        set.iter().map(|(name, value)| ParamAssignment::text(*name, *value)).collect();
    apply(program, &given, &mut context).expect("params");
    program.main(&mut context).expect("the model runs");
    let lines = lines.lock().expect("one thread");
    lines.clone()
}

/// Returns the output of both evaluators after comparing it.
fn run(name: &str, set: &[(&str, &str)]) -> Vec<String> {
    let checked = check_file(&root().join("tests/report").join(name)).expect("the file is there");
    assert!(checked.diagnostics.is_empty(), "{:#?}", checked.diagnostics);
    let program = checked.program.clone().expect("a program");
    let interpreted = Interpreted::new(&program, Purity::Effect).expect("linked");
    let expected = printed(&interpreted, set);
    let module = Module::from_checked(&engine(), checked).expect("compiled");
    assert_eq!(
        printed(module.as_program().as_ref(), set),
        expected,
        "machine code (left) and interpreter (right) differ"
    );
    expected
}

#[test]
fn the_planet_is_where_it_must_be() {
    // The program itself asserts the positions.
    assert_eq!(run("planet.cx", &[]).len(), 1);
}

#[test]
fn the_generator_script_runs_both_ways() {
    let done = "Done generating pinion tooth finite element mesh.";
    let left = run("generator.cx", &[]);
    assert_eq!(left[1], "11 pinion.msh TRUE 1 TRUE FALSE");
    assert_eq!(left[2], format!("side 1: 0 {} 0", std::f64::consts::PI));
    assert_eq!((left[4].as_str(), left[5].as_str()), ("[0.001 m, 0 m, 0 m] [0.002 m, 0 m, 0 m]", done));
    let right = run("generator.cx", &[("isLeftHanded", "FALSE"), ("MESHTYPE", "2")]);
    assert_eq!(right[1], "11 pinion.msh TRUE 8 TRUE FALSE");
    assert_eq!(right[3], format!("side 2: 0 {} 0", std::f64::consts::PI));
    assert_eq!(right[4], "[0.002 m, 0 m, 0 m] [0.001 m, 0 m, 0 m]");
}
