//! Tests that object files link with a C compiler and produce the same bits as code in memory.
#![cfg(unix)]

use crate::common::*;
use calyx_abi::{Fingerprint, entry, math};
use calyx_codegen::{ObjectOptions, TargetCpu};
use calyx_lang::ir::*;
use calyx_lang::span::Span;
use calyx_symbolic::{Instruction, Tape};
use std::process::Command;

/// A C program that prints the contents of the table: description, bits of each param's default,
/// and bits of each kernel's outputs for fixed inputs.
const RUNNER: &str = r#"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
typedef int32_t (*slot_fn)(void *, const uint64_t *, uint64_t *);
typedef void (*kernel_fn)(const double *, double *);
struct table {
    uint64_t abi; slot_fn main; kernel_fn *kernels; uint64_t kernel_count;
    const char *description; uint64_t description_len; slot_fn *param_functions;
};
struct context { uint64_t granted, depth; uint32_t place[3]; };
double calyx_math_floor(double x) { return floor(x); }
int calyx_rt_main(int argc, char **argv, const struct table *model) {
    printf("%llu %.*s %d\n", (unsigned long long)model->abi, (int)model->description_len,
           model->description, argc);
    struct context context = {1000, 0, {0, 0, 0}};
    uint64_t result = 0;
    if (model->main(&context, 0, 0) || model->param_functions[0](&context, 0, &result) ||
        model->param_functions[1] || context.depth)
        return 1;
    printf("%llx\n", (unsigned long long)result);
    double inputs[2] = {0.1, -7.3}, outputs[4];
    for (uint64_t k = 0; k < model->kernel_count; k++) {
        model->kernels[k](inputs, outputs);
        for (int i = 0; i < 4; i++) {
            memcpy(&result, &outputs[i], 8);
            printf("%llx\n", (unsigned long long)result);
        }
    }
    return 7;
}
"#;

/// Returns definitions of all functions that the code may call and the C program lacks; each ends
/// the process.
fn stubs() -> String {
    let helpers = entry::entry_points().into_iter().map(|row| row.symbol);
    let functions = math::FUNCTIONS.iter().map(|row| row.0).filter(|symbol| *symbol != "calyx_math_floor");
    helpers.chain(functions).map(|symbol| format!("void {symbol}(void) {{ abort(); }}\n")).collect()
}

/// Returns a model whose main is empty and whose param's default is the sum of the squares below
/// 20.
fn model() -> Program {
    let square = op(Op::Multiply, vec![n(0), n(0)]);
    let body = vec![assign(1, add(n(1), square)), assign(0, add(n(0), number(1.0)))];
    let sum = function(
        &[],
        vec![N, N],
        N,
        vec![
            block(vec![], branch(less(n(0), number(20.0)), 1, 2)),
            block(body, jump(0)),
            block(vec![], ret(op(Op::Sqrt, vec![n(1)]))),
        ],
    );
    let main = function(&[], vec![], calyx_abi::Repr::Unit, vec![block(vec![], Terminator::Return(None))]);
    let param = Param {
        name: "p".into(),
        doc: String::new(),
        repr: N,
        default: FunctionId(1),
        low: None,
        high: None,
        choices: vec![],
        unit: DisplayUnit { name: String::new(), factor: 1.0, dimension: [(0, 1); 8] },
        integral: false,
        span: Span::default(),
        given: None,
    };
    Program { functions: vec![main, sum], params: vec![param], ..Program::default() }
}

/// Returns a kernel of several functions with only exact operations.
fn tape() -> Tape {
    use Instruction as I;
    let mut instructions = vec![I::Input(0), I::Input(1), I::Constant(1.25)];
    for k in 3..2600u32 {
        instructions.push(match k % 7 {
            0 => I::Multiply(k - 1, k % 3),
            1 => I::Add(k - 1, k - 3),
            2 => I::Sqrt(k - 2),
            3 => I::Subtract(k / 2, k - 1),
            4 => I::Floor(k - 3),
            5 => I::Max(k - 1, k / 3),
            _ => I::Divide(k - 2, 2),
        });
    }
    Tape { inputs: 2, instructions, outputs: vec![2599, 1300, 17, 800], ..Tape::default() }
}

#[test]
fn a_linked_object_file_runs() {
    let (program, tapes) = (model(), [tape()]);
    let module = calyx_codegen::compile_jit_with_tapes(&program, &tapes, &[]).unwrap();
    let mut ctx = calyx_abi::Context::new(Box::new(()));
    let default = module.run_function(FunctionId(1), &[], &mut ctx).unwrap()[0];
    let mut outputs = [0.0; 4];
    module.kernels()[0].eval(&[0.1, -7.3], &mut outputs);
    assert!(outputs.iter().any(|x| x.is_finite() && x.fract() != 0.0), "{outputs:?}");
    let bits = outputs.map(|x| format!("{:x}\n", x.to_bits())).concat();
    let abi = Fingerprint(77);
    let expected = format!("{} {{\"é\":1}} 2\n{default:x}\n{bits}", abi.0);

    let directory = tempfile::tempdir().unwrap();
    let file = |name: &str| directory.path().join(name);
    let options =
        ObjectOptions { entry: true, cpu: TargetCpu::Native, ..ObjectOptions::new("m", "{\"é\":1}", abi) };
    let object = calyx_codegen::compile_object_with_tapes(&program, &tapes, &options).unwrap();
    std::fs::write(file("model.o"), object).unwrap();
    std::fs::write(file("runner.c"), [RUNNER, &stubs()].concat()).unwrap();
    let linked = Command::new("cc")
        .args([file("runner.c"), file("model.o")])
        .args(["-fno-builtin", "-lm", "-o"])
        .arg(file("model"))
        .output()
        .unwrap();
    assert!(linked.status.success(), "{}", String::from_utf8_lossy(&linked.stderr));
    let run = Command::new(file("model")).arg("argument").output().unwrap();
    assert_eq!(String::from_utf8_lossy(&run.stdout), expected);
    assert_eq!(run.status.code(), Some(7));
}
