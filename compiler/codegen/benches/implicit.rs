//! Benchmarks kernels with implicit functions against the same Newton iteration written by hand,
//! interleaved in one run. The ratios are meaningful, the absolute times are not. Run it with
//! `cargo bench -p calyx-codegen --bench implicit`.
//!
//! The hand-written code contains the residual and its derivatives inline, evaluates them with the
//! numeric functions of the project, and stops by the same criterion, so both take the same steps.

use calyx_abi::math::{exp, sincos};
use calyx_codegen::compile_kernel;
use calyx_symbolic::{Graph, NodeId, Tape, Unary};
use std::hint::black_box;
use std::time::Instant;

const POINTS: usize = 4000;
const ROUNDS: usize = 25;
/// Symbols of the unknowns.
const X: [u32; 2] = [100, 101];

struct Case {
    name: &'static str,
    tape: Tape,
    by_hand: fn(&[f64; 3]) -> [f64; 2],
}

fn main() {
    // `cargo test --benches` only checks that the benchmark runs.
    let rounds = if std::env::args().any(|argument| argument == "--bench") { ROUNDS } else { 1 };
    println!("ns per solution       kernel   by hand   ratio");
    let cases = [
        Case { name: "Kepler", tape: kepler(), by_hand: kepler_by_hand },
        Case { name: "line of action", tape: slider(), by_hand: slider_by_hand },
        Case { name: "two unknowns", tape: pair(), by_hand: pair_by_hand },
    ];
    for case in &cases {
        compare(case, rounds);
    }
}

fn compare(case: &Case, rounds: usize) {
    let kernel = compile_kernel(&case.tape).expect("the tape compiles");
    let points: Vec<[f64; 3]> = (0..POINTS)
        .map(|i| {
            let part = i as f64 / POINTS as f64;
            [0.3 + 2.0 * part, 0.2 + 0.5 * (1.0 - part), 1.0 + 0.3 * part * part]
        })
        .collect();
    let count = case.tape.outputs.len();
    for point in &points {
        let mut found = [0.0; 2];
        kernel.eval(point, &mut found[..count]);
        let expected = (case.by_hand)(point);
        for (found, expected) in found.iter().zip(expected).take(count) {
            assert!((found - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{} {point:?}", case.name);
        }
    }
    let mut best = [f64::INFINITY; 2];
    for _ in 0..rounds {
        let start = Instant::now();
        for point in &points {
            let mut found = [0.0; 2];
            kernel.eval(black_box(point), &mut found[..count]);
            black_box(found);
        }
        best[0] = best[0].min(start.elapsed().as_secs_f64());
        let start = Instant::now();
        for point in &points {
            black_box((case.by_hand)(black_box(point)));
        }
        best[1] = best[1].min(start.elapsed().as_secs_f64());
    }
    let [kernel, by_hand] = best.map(|seconds| seconds / POINTS as f64 * 1e9);
    println!("{:<18} {kernel:>9.1} {by_hand:>9.1} {:>7.2}", case.name, kernel / by_hand);
}

/// Damped Newton iteration for one unknown with the criteria of `calyx_abi::newton`.
#[inline(always)]
fn newton(guess: f64, f: impl Fn(f64) -> (f64, f64)) -> f64 {
    const ROUNDING: f64 = f64::EPSILON / 2.0;
    let mut x = guess;
    let (mut residual, mut slope) = f(x);
    let (mut previous, mut range, mut damping) = (f64::INFINITY, x.abs(), 1.0);
    for _ in 0..100 {
        let correction = residual / slope;
        let size = correction.abs();
        let trial = x - damping * correction;
        let next = if previous.is_finite() { size * (size / previous) * (size / previous) } else { size };
        if damping == 1.0 && next <= ROUNDING * trial.abs().max(1e-4 * range) {
            return trial;
        }
        let (after, slope_after) = f(trial);
        if (after / slope).abs() < (1.0 - damping / 4.0) * size {
            (x, residual, slope) = (trial, after, slope_after);
            previous = if damping == 1.0 { size } else { f64::INFINITY };
            range = range.max(x.abs());
            damping = 1.0;
        } else if size <= (1e-11 * range).max(1e-15) {
            return x;
        } else {
            damping *= 0.5;
        }
    }
    f64::NAN
}

/// Kepler's equation.
fn kepler() -> Tape {
    let mut g = Graph::new();
    let (mean, eccentricity, x) = (g.symbol(0), g.symbol(1), g.symbol(X[0]));
    let sine = g.sin(x);
    let product = g.multiply(eccentricity, sine);
    let left = g.subtract(x, product);
    let residual = g.subtract(left, mean);
    let root = g.solve(&X[..1], &[residual], &[mean]).expect("one equation");
    g.schedule(3, &root)
}

fn kepler_by_hand(&[mean, eccentricity, _]: &[f64; 3]) -> [f64; 2] {
    let root = newton(mean, |x| {
        let (sine, cosine) = sincos(x);
        (x - eccentricity * sine - mean, 1.0 - eccentricity * cosine)
    });
    [root, 0.0]
}

/// The angle at which the normal of a rotating ellipse passes through a fixed point: an equation of
/// meshing.
fn slider() -> Tape {
    let mut g = Graph::new();
    let [turn, height, width] = [0, 1, 2].map(|symbol| g.symbol(symbol));
    let x = g.symbol(X[0]);
    let (sine, cosine) = (g.sin(x), g.cos(x));
    let (px, py) = (g.multiply(width, cosine), g.multiply(height, sine));
    let (across, along) = (g.multiply(width, sine), g.multiply(height, cosine));
    let across = g.negate(across);
    let (s, c) = (g.sin(turn), g.cos(turn));
    // The point in the ellipse's own coordinates.
    let [fx, fy] = [c, s].map(|part| g.scale(3.0, part));
    let (dx, dy) = (g.subtract(px, fx), g.subtract(py, fy));
    let (first, second) = (g.multiply(dx, across), g.multiply(dy, along));
    let residual = g.add(first, second);
    let root = g.solve(&X[..1], &[residual], &[turn]).expect("one equation");
    g.schedule(3, &root)
}

fn slider_by_hand(&[turn, height, width]: &[f64; 3]) -> [f64; 2] {
    let (s, c) = sincos(turn);
    let (fx, fy) = (3.0 * c, 3.0 * s);
    let root = newton(turn, |x| {
        let (sine, cosine) = sincos(x);
        let (px, py) = (width * cosine, height * sine);
        let (across, along) = (-width * sine, height * cosine);
        let (dx, dy) = (px - fx, py - fy);
        let residual = dx * across + dy * along;
        let slope = across * across - dx * px + along * along - dy * py;
        (residual, slope)
    });
    [root, 0.0]
}

/// Two equations with two unknowns.
fn pair() -> Tape {
    let mut g = Graph::new();
    let [a, b, c] = [0, 1, 2].map(|symbol| g.symbol(symbol));
    let [x, y] = X.map(|symbol| g.symbol(symbol));
    let product = g.multiply(b, y);
    let exponential = g.unary(Unary::Exp, product);
    let sum = g.add(x, exponential);
    let right: NodeId = g.add(a, c);
    let first = g.subtract(sum, right);
    let sine = g.sin(x);
    let product = g.multiply(b, sine);
    let sum = g.add(y, product);
    let second = g.subtract(sum, a);
    let roots = g.solve(&X, &[first, second], &[a, b]).expect("two equations");
    g.schedule(3, &roots)
}

fn pair_by_hand(&[a, b, c]: &[f64; 3]) -> [f64; 2] {
    const ROUNDING: f64 = f64::EPSILON / 2.0;
    let right = a + c;
    let f = |[x, y]: [f64; 2]| {
        let e = exp(b * y);
        let (sine, cosine) = sincos(x);
        ([x + e - right, y + b * sine - a], [1.0, b * e, b * cosine, 1.0])
    };
    let solve = |[r, s]: [f64; 2], [j, k, l, m]: [f64; 4]| {
        let determinant = j * m - k * l;
        [(m * r - k * s) / determinant, (j * s - l * r) / determinant]
    };
    let largest = |[x, y]: [f64; 2]| x.abs().max(y.abs());
    let mut x = [a, b];
    let (mut residual, mut jacobian) = f(x);
    let (mut previous, mut range, mut damping) = (f64::INFINITY, largest(x), 1.0);
    for _ in 0..100 {
        let correction = solve(residual, jacobian);
        let size = largest(correction);
        let trial = [x[0] - damping * correction[0], x[1] - damping * correction[1]];
        let next = if previous.is_finite() { size * (size / previous) * (size / previous) } else { size };
        if damping == 1.0 && next <= ROUNDING * largest(trial).max(1e-4 * range) {
            return trial;
        }
        let (after, jacobian_after) = f(trial);
        if largest(solve(after, jacobian)) < (1.0 - damping / 4.0) * size {
            (x, residual, jacobian) = (trial, after, jacobian_after);
            previous = if damping == 1.0 { size } else { f64::INFINITY };
            range = range.max(largest(x));
            damping = 1.0;
        } else if size <= (1e-11 * range).max(1e-15) {
            return x;
        } else {
            damping *= 0.5;
        }
    }
    [f64::NAN; 2]
}
