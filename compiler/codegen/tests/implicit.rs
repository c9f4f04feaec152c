//! Kernels with implicit functions give the bits of interpreted tapes: for one point, for many
//! points.

use crate::workloads::Random;
use calyx_abi::{Kernel, Repr};
use calyx_codegen::{compile_batch, compile_jit_with_tapes};
use calyx_lang::ir::{Block, Function, Program, Terminator};
use calyx_lang::span::Span;
use calyx_symbolic::{Graph, NodeId, Tape, TapeKernel, Unary};

const INPUTS: usize = 3;
/// Symbols of unknowns.
const X: [u32; 4] = [100, 101, 102, 103];

/// Returns Kepler's equation solved for the anomaly.
fn kepler(g: &mut Graph, mean: NodeId, eccentricity: NodeId) -> NodeId {
    let x = g.symbol(X[0]);
    let sine = g.sin(x);
    let product = g.multiply(eccentricity, sine);
    let left = g.subtract(x, product);
    let residual = g.subtract(left, mean);
    g.solve(&X[..1], &[residual], &[mean]).unwrap()[0]
}

/// Returns the solution of `x[i] + 0.3 sin(a x[i + 1]) = (i + 1) b` for cyclic `i`.
fn ring(g: &mut Graph, count: usize, [a, b]: [NodeId; 2]) -> Vec<NodeId> {
    let x: Vec<NodeId> = X[..count].iter().map(|&symbol| g.symbol(symbol)).collect();
    let mut residuals = Vec::new();
    for i in 0..count {
        let product = g.multiply(a, x[(i + 1) % count]);
        let sine = g.sin(product);
        let part = g.scale(0.3, sine);
        let sum = g.add(x[i], part);
        let right = g.scale((i + 1) as f64, b);
        residuals.push(g.subtract(sum, right));
    }
    let guess = vec![b; count];
    g.solve(&X[..count], &residuals, &guess).unwrap()
}

/// Returns the solution of an equation that is too long to be inlined into the iteration.
fn long(g: &mut Graph, a: NodeId, b: NodeId) -> NodeId {
    let x = g.symbol(X[0]);
    let mut residual = g.subtract(x, b);
    for k in 1..200 {
        let phase = g.scale(f64::from(k), a);
        let angle = g.add(x, phase);
        let sine = g.sin(angle);
        let part = g.scale(0.002, sine);
        residual = g.add(residual, part);
    }
    g.solve(&X[..1], &[residual], &[b]).unwrap()[0]
}

/// Returns a kernel with implicit functions of one and of several unknowns, within each other, and
/// two derivatives of all of them.
fn tape() -> Tape {
    let mut g = Graph::new();
    let [a, b, c] = [0, 1, 2].map(|symbol| g.symbol(symbol));
    let half = g.scale(0.4, b);
    let one = kepler(&mut g, a, half);
    let two = kepler(&mut g, one, half);
    // Two equations whose residuals contain an implicit function.
    let [x, y] = [1, 2].map(|i| g.symbol(X[i]));
    let inner = kepler(&mut g, x, half);
    let exponential = g.unary(Unary::Exp, y);
    let sum = g.add(inner, exponential);
    let first = g.subtract(sum, c);
    let cosine = g.cos(y);
    let product = g.scale(3.0, cosine);
    let difference = g.subtract(x, product);
    let second = g.subtract(difference, a);
    let guess = [c, g.constant(0.1)];
    let pair = g.solve(&X[1..3], &[first, second], &guess).unwrap();
    // A minimum: the gradient and the Hessian are one kernel.
    let (product, distance) = (g.multiply(b, x), g.subtract(x, c));
    let (cosine, square) = (g.cos(product), g.multiply(distance, distance));
    let wave = g.scale(0.2, cosine);
    let objective = g.add(square, wave);
    let minimum = g.minimize(&X[1..2], objective, &[c]).unwrap()[0];
    // A minimum of two unknowns, `(x - c)^2 + b^2 (y - x^2)^2 + y^2`.
    let square = g.multiply(x, x);
    let difference = g.subtract(y, square);
    let scaled = g.multiply(b, difference);
    let parts = [distance, scaled, y].map(|part| g.multiply(part, part));
    let objective = parts.into_iter().reduce(|sum, part| g.add(sum, part)).unwrap();
    let basin = g.minimize(&X[1..3], objective, &[c, c]).unwrap();
    let (three, four) = (ring(&mut g, 3, [a, b]), ring(&mut g, 4, [c, a]));
    let long = long(&mut g, a, b);
    let mut outputs = vec![one, two, pair[0], pair[1], minimum, long];
    outputs.extend(basin.into_iter().chain(three).chain(four));
    for at in 0..10 {
        let next = g.derivative(outputs[at], (at % INPUTS) as u32);
        outputs.push(next);
    }
    g.schedule(INPUTS, &outputs)
}

fn empty_program() -> Program {
    let terminator = Terminator::Return(None);
    let block = Block { statements: vec![], terminator, handler: None, span: Span::default() };
    let main = Function {
        name: "main".into(),
        parameters: vec![],
        result: Repr::Unit,
        locals: vec![],
        blocks: vec![block],
        span: Span::default(),
    };
    Program { functions: vec![main], ..Program::default() }
}

fn same(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan())
}

#[test]
fn kernels_for_one_point_have_the_bits_of_the_tape() {
    let tape = tape();
    let module = compile_jit_with_tapes(&empty_program(), std::slice::from_ref(&tape), &[]).unwrap();
    let (compiled, interpreted) = (&module.kernels()[0], TapeKernel(tape));
    let mut random = Random(7);
    let mut solved = 0;
    for _ in 0..300 {
        let inputs = [0; INPUTS].map(|_| random.uniform(-1.5, 3.0));
        let mut found = vec![0.0; compiled.outputs()];
        let mut expected = found.clone();
        compiled.eval(&inputs, &mut found);
        interpreted.eval(&inputs, &mut expected);
        assert!(same(&found, &expected), "{inputs:?}: {found:?}, not {expected:?}");
        solved += usize::from(expected.iter().all(|value| value.is_finite()));
    }
    assert!((50..300).contains(&solved), "{solved} of 300 points have a solution");
}

#[test]
fn batches_have_the_bits_of_the_tape() {
    let tape = tape();
    for varying in [[true; 3], [true, false, false], [false, true, true], [false; 3]] {
        let kernel = compile_batch(&tape, &varying).unwrap();
        let mut random = Random(11);
        let points = 67;
        let uniforms: Vec<f64> =
            varying.iter().filter(|&&varies| !varies).map(|_| random.uniform(0.1, 1.0)).collect();
        let columns: Vec<Vec<f64>> = varying
            .iter()
            .filter(|&&varies| varies)
            .map(|_| (0..points).map(|_| random.uniform(-0.5, 2.0)).collect())
            .collect();
        let mut outputs = vec![vec![0.0; points]; tape.outputs.len()];
        let views: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        let mut results: Vec<&mut [f64]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
        kernel.evaluate(&uniforms, &views, &mut results).unwrap();
        for point in 0..if views.is_empty() { 0 } else { points } {
            let (mut column, mut uniform) = (columns.iter(), uniforms.iter());
            let inputs = varying.map(|varies| match varies {
                true => column.next().unwrap()[point],
                false => *uniform.next().unwrap(),
            });
            let mut expected = vec![0.0; tape.outputs.len()];
            tape.eval(&inputs, &mut Vec::new(), &mut expected);
            let found: Vec<f64> = outputs.iter().map(|column| column[point]).collect();
            assert!(same(&found, &expected), "{varying:?} {inputs:?}: {found:?}, not {expected:?}");
        }
    }
}
