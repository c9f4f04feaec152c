//! Benchmarks kernels for the position, velocity and acceleration of the tip of a chain of joints.
//!
//! The first part measures the cost of differentiation and scheduling against the length of the
//! chain. The second part compares the interpreted kernel of eight joints with the same formulas
//! written by hand, in the same run.

use calyx_abi::math;
use calyx_symbolic::{Frame, Graph, Tape};
use divan::{Bencher, black_box};

const TIME: u32 = 0;
const JOINTS: usize = 8;

fn main() {
    let (tape, mut scratch) = (kernel(JOINTS), Vec::new());
    let mut outputs = [0.0; 9];
    tape.eval(&[0.37], &mut scratch, &mut outputs);
    for (interpreted, by_hand) in outputs.iter().zip(by_hand(0.37)) {
        assert!((interpreted - by_hand).abs() <= 1e-12 * by_hand.abs().max(1.0), "{interpreted} {by_hand}");
    }
    println!("{} instructions", tape.instructions.len());
    divan::main();
}

/// Returns the rate of a joint's angle and the length of the arm beyond the joint.
fn joint(index: usize) -> (f64, f64) {
    (1.0 + index as f64, 0.5 + 0.1 * index as f64)
}

fn kernel(joints: usize) -> Tape {
    let mut g = Graph::new();
    let time = g.symbol(TIME);
    let (zero, one) = (g.constant(0.0), g.constant(1.0));
    let mut frame = Frame::ground();
    for index in 0..joints {
        let (rate, arm) = joint(index);
        let (angle, arm) = (g.scale(rate, time), g.constant(arm));
        let axis = if index % 2 == 0 { [zero, zero, one] } else { [zero, one, zero] };
        frame = Frame::translate([arm, zero, zero]).after(&Frame::rotate(angle, axis)).after(&frame);
    }
    let outputs =
        [frame.origin(&mut g), frame.velocity(&mut g, TIME), frame.acceleration(&mut g, TIME)].concat();
    g.schedule(1, &outputs)
}

/// Computes the same values with hand-written code, from the tip to the base.
fn by_hand(time: f64) -> [f64; 9] {
    let (mut x, mut v, mut a) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    for index in (0..JOINTS).rev() {
        let (rate, arm) = joint(index);
        let (sine, cosine) = math::sincos(rate * time);
        x[0] += arm;
        // Right-handed rotation from axis i to axis j.
        let (i, j) = if index % 2 == 0 { (0, 1) } else { (2, 0) };
        let (first_i, first_j) = (v[i] - rate * x[j], v[j] + rate * x[i]);
        a[i] -= rate * (v[j] + first_j);
        a[j] += rate * (v[i] + first_i);
        (v[i], v[j]) = (first_i, first_j);
        for vector in [&mut x, &mut v, &mut a] {
            (vector[i], vector[j]) =
                (cosine * vector[i] - sine * vector[j], sine * vector[i] + cosine * vector[j]);
        }
    }
    [x[0], x[1], x[2], v[0], v[1], v[2], a[0], a[1], a[2]]
}

#[divan::bench(args = [4, 8, 16, 32, 64])]
fn derive_and_schedule(joints: usize) -> Tape {
    kernel(joints)
}

#[divan::bench]
fn interpreted(bencher: Bencher) {
    let (tape, mut scratch, mut outputs) = (kernel(JOINTS), Vec::new(), [0.0; 9]);
    bencher.bench_local(|| {
        tape.eval(black_box(&[0.37]), &mut scratch, &mut outputs);
        outputs
    });
}

#[divan::bench]
fn written_by_hand() -> [f64; 9] {
    by_hand(black_box(0.37))
}
