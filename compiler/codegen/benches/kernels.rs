//! Benchmarks compiled kernels against the interpreted tape and against the same formulas written
//! in Rust, and measures compile time. The ratios are meaningful, the absolute times are not. Run
//! it with `cargo bench -p calyx-codegen`.

use calyx_abi::{Repr, math};
use calyx_codegen::{JitModule, compile_jit_with_tapes};
use calyx_lang::ir::{Block, Function, Program, Terminator};
use calyx_lang::span::Span;
use calyx_symbolic::{Frame, Graph, Instruction, Tape};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// Links of the chain: each rotates about e3 at its own rate, then extends along its own first
/// axis.
const RATES: [f64; 4] = [1.0, -2.0, 3.0, 0.5];

/// Returns the tape for the position of the end of the chain; input 0 is time.
fn chain_tape() -> Tape {
    const TIME: u32 = 0;
    let mut graph = Graph::new();
    let (time, zero, one) = (graph.symbol(TIME), graph.constant(0.0), graph.constant(1.0));
    let mut frame = Frame::translate([zero; 3]);
    for rate in RATES {
        let rate = graph.constant(rate);
        let angle = graph.multiply(rate, time);
        frame = Frame::rotate(angle, [zero, zero, one]).after(&frame);
        frame = Frame::translate([one, zero, zero]).after(&frame);
    }
    let origin = frame.origin(&mut graph);
    graph.schedule(1, &origin)
}

/// Computes the same values with hand-written code, from tip to base.
fn chain_by_hand(time: f64) -> [f64; 3] {
    let mut tip = [0.0, 0.0];
    for rate in RATES.iter().rev() {
        let (sine, cosine) = math::sincos(rate * time);
        let x = tip[0] + 1.0;
        tip = [cosine * x - sine * tip[1], sine * x + cosine * tip[1]];
    }
    [tip[0], tip[1], 0.0]
}

fn compile(tape: &Tape) -> JitModule {
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
    let program = Program { functions: vec![main], ..Program::default() };
    compile_jit_with_tapes(&program, std::slice::from_ref(tape), &[]).expect("the bench compiles")
}

#[divan::bench(sample_size = 1000)]
fn chain_compiled(bencher: Bencher) {
    let kernel = compile(&chain_tape()).kernels().remove(0);
    let mut outputs = [0.0; 3];
    bencher.bench_local(|| {
        kernel.eval(black_box(&[0.7]), &mut outputs);
        outputs
    });
}

#[divan::bench(sample_size = 1000)]
fn chain_interpreted(bencher: Bencher) {
    let (tape, mut scratch, mut outputs) = (chain_tape(), Vec::new(), [0.0; 3]);
    bencher.bench_local(|| {
        tape.eval(black_box(&[0.7]), &mut scratch, &mut outputs);
        outputs
    });
}

#[divan::bench(sample_size = 1000)]
fn chain_written_by_hand(bencher: Bencher) {
    bencher.bench_local(|| chain_by_hand(black_box(0.7)));
}

/// Returns a tape of sums and products with near and far operands.
fn arithmetic_tape(operations: u32) -> Tape {
    let mut instructions: Vec<_> = (0..32).map(Instruction::Input).collect();
    for k in 32..32 + operations {
        // Occasional far operands keep values alive for long, which makes register allocation
        // expensive.
        let other = if k % 5 == 0 { k * 7 % k } else { k - 2 - k % 23 };
        let both = (k - 1, other);
        instructions.push(if k % 3 == 0 {
            Instruction::Multiply(both.0, both.1)
        } else {
            Instruction::Subtract(both.0, both.1)
        });
    }
    let last = instructions.len() as u32;
    Tape { inputs: 32, instructions, outputs: (last - 64..last).collect(), ..Tape::default() }
}

#[divan::bench(args = [1000, 3000, 10_000, 30_000])]
fn compile_arithmetic(bencher: Bencher, operations: u32) {
    let tape = arithmetic_tape(operations);
    bencher.counter(ItemsCount::new(operations)).bench_local(|| compile(&tape));
}

#[divan::bench(args = [1000, 10_000, 30_000])]
fn run_arithmetic(bencher: Bencher, operations: u32) {
    let kernel = compile(&arithmetic_tape(operations)).kernels().remove(0);
    let (inputs, mut outputs) = ([1.01; 32], [0.0; 64]);
    bencher
        .counter(ItemsCount::new(operations))
        .bench_local(|| kernel.eval(black_box(&inputs), &mut outputs));
}

#[divan::bench(args = [1000, 10_000, 30_000])]
fn interpret_arithmetic(bencher: Bencher, operations: u32) {
    let (tape, mut scratch) = (arithmetic_tape(operations), Vec::new());
    let (inputs, mut outputs) = ([1.01; 32], [0.0; 64]);
    bencher
        .counter(ItemsCount::new(operations))
        .bench_local(|| tape.eval(black_box(&inputs), &mut scratch, &mut outputs));
}
