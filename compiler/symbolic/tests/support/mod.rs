//! Shared test support: reproducible random numbers, and evaluation.
#![allow(dead_code, reason = "each test file uses its part")]

pub mod complex;

use calyx_symbolic::{Graph, NodeId};

/// The SplitMix64 generator (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    /// Returns a number uniformly distributed in `low..high`.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        low + (high - low) * ((z >> 11) as f64 * 2f64.powi(-53))
    }
}

/// Evaluates expressions at the given inputs.
pub fn evaluate(graph: &Graph, nodes: &[NodeId], inputs: &[f64]) -> Vec<f64> {
    let mut outputs = vec![0.0; nodes.len()];
    graph.schedule(inputs.len(), nodes).eval(inputs, &mut Vec::new(), &mut outputs);
    outputs
}

/// Weights of the sixth-order central difference at -3h .. 3h, multiplied by 60 h.
const SIXTH_ORDER: [f64; 7] = [-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0];

/// Returns the derivative of `f` at `x` by the sixth-order central difference with step `h`. The
/// truncation error is `h^6 f^(7)(x) / 140`; rounding adds about `2e-16 f / h`.
pub fn difference(f: impl Fn(f64) -> f64, x: f64, h: f64) -> f64 {
    let terms = SIXTH_ORDER.iter().zip(-3..=3).filter(|(weight, _)| **weight != 0.0);
    terms.map(|(weight, k)| weight * f(x + f64::from(k) * h)).sum::<f64>() / (60.0 * h)
}

/// Asserts that two numbers differ by at most `tolerance` times the larger of 1 and `expected`.
#[track_caller]
pub fn assert_close(actual: f64, expected: f64, tolerance: f64, what: &str) {
    let error = (actual - expected).abs() / expected.abs().max(1.0);
    assert!(error <= tolerance, "{what}: {actual} instead of {expected}, error {error:e}");
}
