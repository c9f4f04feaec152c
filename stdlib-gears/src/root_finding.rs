//! Roots of scalar functions with a known bracket.

/// Finds the sign change of `f` between `a` and `b`, to the last bits.
///
/// Bisection accelerated by false position (Illinois variant). If `f` has the same sign at both
/// ends, the result is the end with the smaller magnitude of `f`.
pub(crate) fn solve_bracketed(f: impl Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let (mut fa, mut fb) = (f(a), f(b));
    if fa * fb > 0.0 {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    for iteration in 0..200 {
        // Every third step halves the bracket, because false position alone may converge slowly.
        let middle = 0.5 * (a + b);
        let secant = b - fb * (b - a) / (fb - fa);
        let next = if iteration % 3 == 2 || !secant.is_finite() { middle } else { secant };
        let value = f(next);
        if value == 0.0 || (b - a).abs() <= 2.0 * f64::EPSILON * a.abs().max(b.abs()) {
            return next;
        }
        if value * fb < 0.0 {
            (a, fa) = (b, fb);
        } else {
            fa *= 0.5;
        }
        (b, fb) = (next, value);
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_simple_and_flat_roots() {
        let cubic = solve_bracketed(|x| x * x * x - 2.0, 0.0, 3.0);
        assert!((cubic - 2.0_f64.cbrt()).abs() < 4e-16, "{cubic}");
        let flat = solve_bracketed(|x: f64| (x - 0.3).powi(3), -1.0, 5.0);
        assert!((flat - 0.3).abs() < 1e-5, "{flat}");
        assert_eq!(solve_bracketed(|x| x, 0.0, 1.0), 0.0);
    }
}
