//! Tests that compiled kernels of any length produce the same bits as interpreted tapes.

use calyx_abi::Repr;
use calyx_codegen::compile_jit_with_tapes;
use calyx_lang::ir::{Block, Function, Program, Terminator};
use calyx_lang::span::Span;
use calyx_symbolic::{Instruction, Tape};

fn empty_program() -> Program {
    let main = Function {
        name: "main".into(),
        parameters: vec![],
        result: Repr::Unit,
        locals: vec![],
        blocks: vec![Block {
            statements: vec![],
            terminator: Terminator::Return(None),
            handler: None,
            span: Span::default(),
        }],
        span: Span::default(),
    };
    Program { functions: vec![main], ..Program::default() }
}

/// Marsaglia's xorshift* generator, for reproducible tapes.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11
    }

    fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit as u64) as usize
    }

    fn number(&mut self) -> f64 {
        const SPECIAL: [f64; 10] = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            5e-324,
            -1e308,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
            std::f64::consts::FRAC_PI_2,
        ];
        match self.below(8) {
            0 => SPECIAL[self.below(SPECIAL.len())],
            _ => (self.next() as f64 / (1u64 << 52) as f64 - 1.0) * 8.0,
        }
    }
}

const INPUTS: usize = 6;
/// Evaluations of each tape.
const RUNS: usize = 40;
const KINDS: usize = 31;

fn instruction(kind: usize, random: &mut Random, before: usize) -> Instruction {
    use Instruction as I;
    // Mostly near operands, sometimes any operand, so that values are passed between functions.
    let mut operand = || {
        let near = before.min(if random.below(5) == 0 { before } else { 24 });
        (before - 1 - random.below(near)) as u32
    };
    let (a, b, c) = (operand(), operand(), operand());
    match kind {
        0 => I::Constant(random.number()),
        1 => I::Input(random.below(INPUTS) as u32),
        2 => I::Negate(a),
        3 => I::Abs(a),
        4 => I::Sqrt(a),
        5 => I::Sin(a),
        6 => I::Cos(a),
        7 => I::Tan(a),
        8 => I::Asin(a),
        9 => I::Acos(a),
        10 => I::Atan(a),
        11 => I::Exp(a),
        12 => I::Log(a),
        13 => I::Floor(a),
        14 => I::Ceil(a),
        15 => I::Round(a),
        16 => I::Not(a),
        17 => I::Add(a, b),
        18 => I::Subtract(a, b),
        19 => I::Multiply(a, b),
        20 => I::Divide(a, b),
        21 => I::Power(a, b),
        22 => I::Atan2(a, b),
        23 => I::Min(a, b),
        24 => I::Max(a, b),
        25 => I::Less(a, b),
        26 => I::LessEqual(a, b),
        27 => I::Equal(a, b),
        28 => I::And(a, b),
        29 => I::Or(a, b),
        _ => I::Select(a, b, c),
    }
}

/// Returns a tape of `length` instructions of every kind, a third of whose values are outputs.
fn random_tape(length: usize, seed: u64) -> Tape {
    let mut random = Random(seed | 1);
    let mut instructions = vec![Instruction::Input(0)];
    while instructions.len() < length {
        let kind = if instructions.len() <= KINDS { instructions.len() - 1 } else { random.below(KINDS) };
        // A sine whose cosine is also needed.
        let paired = match instructions.last() {
            Some(Instruction::Sin(angle)) if random.below(2) == 0 => Some(Instruction::Cos(*angle)),
            _ => None,
        };
        let next = paired.unwrap_or_else(|| instruction(kind, &mut random, instructions.len()));
        instructions.push(next);
    }
    let outputs = (0..length as u32).filter(|_| random.below(3) == 0).chain([0, 0]).collect();
    Tape { inputs: INPUTS, instructions, outputs, ..Tape::default() }
}

/// Evaluates a tape both ways for many inputs. Returns the share of outputs that are finite and not
/// integers; if it is small, the comparison has little significance.
fn assert_same_bits(tape: &Tape, seed: u64) -> f64 {
    let module = compile_jit_with_tapes(&empty_program(), std::slice::from_ref(tape), &[]).unwrap();
    let kernel = &module.kernels()[0];
    assert_eq!((kernel.inputs(), kernel.outputs()), (tape.inputs, tape.outputs.len()));
    let mut random = Random(seed | 1);
    let mut ordinary = 0;
    for _ in 0..RUNS {
        let inputs: Vec<f64> = (0..tape.inputs).map(|_| random.number()).collect();
        let mut expected = vec![0.0; tape.outputs.len()];
        let mut compiled = expected.clone();
        tape.eval(&inputs, &mut Vec::new(), &mut expected);
        kernel.eval(&inputs, &mut compiled);
        for (position, (compiled, expected)) in compiled.iter().zip(&expected).enumerate() {
            let same = compiled.to_bits() == expected.to_bits() || compiled.is_nan() && expected.is_nan();
            ordinary += usize::from(expected.is_finite() && expected.fract() != 0.0);
            let id = tape.outputs[position];
            assert!(
                same,
                "{:?} of {inputs:?}: {compiled:e}, not {expected:e}",
                tape.instructions[id as usize]
            );
        }
    }
    ordinary as f64 / (RUNS * tape.outputs.len()) as f64
}

#[test]
fn random_tapes_have_the_same_bits() {
    // 1,000 operations are one function; more are several.
    for length in [1, 2, 40, 300, 999, 1100, 2500, 5000] {
        for seed in 1..=2 {
            let ordinary = assert_same_bits(&random_tape(length, seed * 7919 + length as u64), seed);
            assert!(ordinary > 0.2, "{ordinary} of the values of a tape of {length} are ordinary");
        }
    }
}

#[test]
fn arithmetic_is_not_fused() {
    // a * b + c with a product that needs 106 bits: fused and unfused results differ.
    use Instruction::{Add, Input, Multiply};
    let instructions = vec![Input(0), Input(1), Input(2), Multiply(0, 1), Add(3, 2)];
    let tape = Tape { inputs: 3, instructions, outputs: vec![4], ..Tape::default() };
    let module = compile_jit_with_tapes(&empty_program(), &[tape], &[]).unwrap();
    let x = 1.0 + f64::EPSILON;
    let mut output = [f64::NAN];
    module.kernels()[0].eval(&[x, x, -(x * x)], &mut output);
    assert_eq!(output, [0.0]);
    assert_ne!(x.mul_add(x, -(x * x)), 0.0);
}

#[test]
fn an_empty_kernel_and_outputs_that_are_leaves() {
    assert_same_bits(&Tape::default(), 3);
    let instructions = vec![Instruction::Constant(-0.0), Instruction::Input(1)];
    assert_same_bits(&Tape { inputs: 2, instructions, outputs: vec![1, 0, 1], ..Tape::default() }, 3);
}

#[test]
fn tapes_that_contradict_themselves_are_refused() {
    use Instruction::{Input, Negate};
    for (instructions, outputs) in
        [(vec![Negate(0)], vec![]), (vec![Input(1)], vec![]), (vec![Input(0)], vec![1])]
    {
        let tape = Tape { inputs: 1, instructions, outputs, ..Tape::default() };
        assert!(compile_jit_with_tapes(&empty_program(), &[tape], &[]).is_err());
    }
}
