//! Tests generated flanks, written in Calyx as envelopes by the equation of meshing, against the
//! reference values of machine-cut gears and of the face-milling workload.

use crate::common::text::{check, defaults, read};
use calyx_abi::Kernel;
use calyx_codegen::compile_jit_with_tapes;
use calyx_lang::ir::{Program, SymbolicFunctionId};
use calyx_lower::kernels::lower_kernel;
use calyx_symbolic::TapeKernel;
use std::f64::consts::PI;

/// Returns the outputs of an exported function, the same from the interpreted and the compiled
/// kernel.
fn evaluator(program: &Program, function: &str) -> impl Fn(&[f64]) -> Vec<f64> {
    let position = program.symbolic_functions.iter().position(|f| f.exported && f.name == function);
    let tape = lower_kernel(program, SymbolicFunctionId(position.expect("the function") as u32)).unwrap();
    let module = compile_jit_with_tapes(&Program::default(), std::slice::from_ref(&tape), &[]);
    let params = defaults(program);
    let interpreted = TapeKernel(tape);
    let compiled = module.ok().and_then(|module| module.kernels().into_iter().next());
    move |arguments| {
        let inputs = [&[f64::NAN], params.as_slice(), arguments].concat();
        let mut outputs = vec![f64::NAN; interpreted.outputs()];
        interpreted.eval(&inputs, &mut outputs);
        if let Some(compiled) = &compiled {
            let mut same = outputs.clone();
            compiled.eval(&inputs, &mut same);
            assert!(outputs.iter().zip(&same).all(|(a, b)| a.to_bits() == b.to_bits()), "{inputs:?}");
        }
        outputs
    }
}

#[track_caller]
fn assert_close(found: &[f64], expected: &[f64], tolerance: f64, what: &str) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{what}: {found} instead of {expected}");
    }
}

#[test]
fn the_flank_of_a_hypoid_pinion_is_an_envelope() {
    let program = check(&read("examples/kinematics/generated_flank.cx"));
    let flank = evaluator(&program, "flank");
    let text = read("compiler/codegen/tests/data/generated_flank.txt");
    let rows = text.lines().filter(|line| !line.starts_with('#'));
    for row in rows {
        let row: Vec<f64> = row.split(' ').map(|word| word.parse().unwrap()).collect();
        let [radius, height] = [row[0], row[1]].map(|length| length * 1e-3);
        let found = flank(&[radius, height]);
        let millimetres: Vec<f64> = found[..3].iter().map(|x| x * 1e3).collect();
        assert_close(&millimetres, &row[2..5], 1e-9, "point, mm");
        assert_close(&found[3..6], &row[5..8], 1e-10, "normal");
        // The derivative at a fixed radius and height, along the normal, is that at a fixed point
        // of the cutter.
        let along = |at: usize| (0..3).map(|i| found[at + i] * found[3 + i]).sum::<f64>();
        let deviations = [along(6), along(9), along(12) * 1e3 * PI / 180.0];
        for (found, expected) in deviations.iter().zip(&row[8..]) {
            let error = (found - expected).abs() / expected.abs();
            assert!(error <= 1e-8, "derivative {found} instead of {expected}");
        }
    }
}

#[test]
fn the_envelope_of_the_face_milling_workload_is_solved_for_its_rotation() {
    let text = read("examples/kinematics/face_milling.cx")
        + "function level(in th, in u, in ph, in value) := envelope(u, th, ph) - value;
           function line(in u: Length, in ph: Angle, in value: Area, in guess: Angle) := {
               var th = solve(level, guess, u, ph, value);
               return [th, derivative(th, u), derivative(th, ph), point(u, th, ph)];
           }";
    let program = check(&text);
    let line = evaluator(&program, "line");
    let data = read("compiler/codegen/tests/data/kinematics.txt");
    for row in data.lines().filter_map(|line| line.strip_prefix("W2 ")) {
        let numbers = |text: &str| text.split(' ').map(|word| word.parse().unwrap()).collect::<Vec<f64>>();
        let (inputs, outputs) = row.split_once(" : ").unwrap();
        let (inputs, outputs) = (numbers(inputs), numbers(outputs));
        let [u, th, ph] = inputs[..] else { panic!("three variables") };
        // The envelope function at the point and its gradient follow the point and three vectors.
        let [value, by_u, by_th, by_ph] = outputs[12..16] else { panic!("a value and its gradient") };
        let found = line(&[u, ph, value, th + 0.03]);
        let expected = [th, -by_u / by_th, -by_ph / by_th, outputs[0], outputs[1], outputs[2]];
        for (found, expected) in found.iter().zip(expected) {
            let error = (found - expected).abs() / expected.abs().max(1.0);
            assert!(error <= 1e-12, "{found} instead of {expected}");
        }
    }
}
