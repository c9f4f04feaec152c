//! Tests that the kinematic workloads in `examples/kinematics` reproduce reference values computed
//! with fifty digits.

use crate::common::text::{check, defaults, read};
use crate::workloads::WORKLOADS;
use calyx_abi::Kernel;
use calyx_codegen::compile_jit_with_tapes;
use calyx_lang::ir::{Program, SymbolicFunctionId};
use calyx_lower::kernels::lower_kernel;
use calyx_symbolic::{Tape, TapeKernel};
use std::collections::HashMap;

/// Workload, file, function.
const WRITTEN: [(&str, &str, &str); 4] = [
    ("W1", "planet", "motion"),
    ("W2", "face_milling", "surface"),
    ("W3", "face_milling", "sensitivity"),
    ("W4", "chain", "motion"),
];

/// Variables and outputs at the points of each workload.
type Points = HashMap<String, Vec<(Vec<f64>, Vec<f64>)>>;

fn reference() -> Points {
    let mut points = Points::new();
    let text = read("compiler/codegen/tests/data/kinematics.txt");
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let numbers = |text: &str| text.split(' ').map(|word| word.parse().unwrap()).collect();
        let (name, rest) = line.split_once(' ').unwrap();
        let (inputs, outputs) = rest.split_once(" : ").unwrap();
        points.entry(name.into()).or_default().push((numbers(inputs), numbers(outputs)));
    }
    points
}

fn tape(program: &Program, function: &str) -> Tape {
    let position = program.symbolic_functions.iter().position(|f| f.exported && f.name == function);
    lower_kernel(program, SymbolicFunctionId(position.expect("the function") as u32)).unwrap()
}

fn assert_reproduces(kernel: &dyn Kernel, params: &[f64], points: &[(Vec<f64>, Vec<f64>)], name: &str) {
    let mut found = Vec::new();
    for (variables, expected) in points {
        // The outputs depend on time only through the argument.
        let inputs = [&[f64::NAN], params, variables].concat();
        assert_eq!((kernel.inputs(), kernel.outputs()), (inputs.len(), expected.len()), "{name}");
        let mut outputs = vec![f64::NAN; expected.len()];
        kernel.eval(&inputs, &mut outputs);
        found.push(outputs);
    }
    for column in 0..found[0].len() {
        let scale = points.iter().map(|(_, expected)| expected[column].abs()).fold(0.0, f64::max);
        for (outputs, (_, expected)) in found.iter().zip(points) {
            let error = (outputs[column] - expected[column]).abs() / scale;
            assert!(error <= 1e-13, "{name} output {column}: {} {error:e}", outputs[column]);
        }
    }
}

#[test]
fn the_examples_reproduce_the_reference() {
    let reference = reference();
    for (name, file, function) in WRITTEN {
        let program = check(&read(&format!("examples/kinematics/{file}.cx")));
        let params = defaults(&program);
        let tape = tape(&program, function);
        let module = compile_jit_with_tapes(&program, std::slice::from_ref(&tape), &crate::common::externs());
        assert_reproduces(&*module.unwrap().kernels()[0], &params, &reference[name], name);
        assert_reproduces(&TapeKernel(tape), &params, &reference[name], name);
    }
}

#[test]
fn what_is_written_costs_no_more_than_the_graph_built_by_hand() {
    for (workload, (name, file, function)) in WORKLOADS.iter().zip(WRITTEN) {
        let program = check(&read(&format!("examples/kinematics/{file}.cx")));
        let (written, built) =
            (tape(&program, function).instructions.len(), workload.tape().instructions.len());
        println!("{name}: {written} operations written, {built} built by hand");
        assert!(written * 10 <= built * 11, "{name}: {written} operations, {built} built by hand");
    }
}

#[test]
fn a_chain_costs_in_proportion_to_its_length() {
    let operations = |factors: usize| {
        let turn = |k: usize| format!("Translate(0.{k}1 m*e1) * Rotate(0.{k}3*t, e{})", k % 3 + 1);
        let chain: Vec<String> = (1..=factors).map(turn).collect();
        let text = format!(
            "function x(in t) := {};
             function motion(in t) := [x(t)*(1 m*e2), derivative(x(t)*(1 m*e2), t),
                 derivative(derivative(x(t)*(1 m*e2), t), t)];",
            chain.join(" * ")
        );
        tape(&check(&text), "motion").instructions.len() as f64
    };
    let (short, middle, long) = (operations(10), operations(20), operations(40));
    assert!(long - middle < 2.1 * (middle - short), "{short} {middle} {long}");
}
