//! Gauss-Legendre quadrature on -1 ..= 1.

use std::sync::OnceLock;

/// Number of rules that are kept.
const KEPT: usize = 32;

/// Returns points and weights of the rule with `count` points, ascending, exact to degree
/// `2 * count - 1`.
pub fn gauss_legendre(count: usize) -> Vec<(f64, f64)> {
    static RULES: [OnceLock<Vec<(f64, f64)>>; KEPT] = [const { OnceLock::new() }; KEPT];
    match RULES.get(count) {
        Some(rule) => rule.get_or_init(|| computed(count)).clone(),
        None => computed(count),
    }
}

fn computed(count: usize) -> Vec<(f64, f64)> {
    let n = count as f64;
    let mut rule = Vec::with_capacity(count);
    for index in 0..count {
        // Tricomi's estimate of the root, then Newton's method.
        let mut x = -(std::f64::consts::PI * (index as f64 + 0.75) / (n + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..20 {
            let (mut previous, mut value) = (1.0, x);
            for degree in 2..=count {
                let k = degree as f64;
                (previous, value) = (value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k);
            }
            slope = n * (previous - x * value) / (1.0 - x * x);
            let step = value / slope;
            x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        rule.push((x, 2.0 / ((1.0 - x * x) * slope * slope)));
    }
    rule
}
