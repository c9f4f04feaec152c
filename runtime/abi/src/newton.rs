//! Newton's method for implicit functions: the single definition that the interpreter and machine
//! code use.
//!
//! The iteration is damped by the natural monotonicity test (Deuflhard, *Newton Methods for
//! Nonlinear Problems*, 2004, section 3.3). The test compares corrections instead of residuals, so
//! neither the units of the residuals nor their scale affects it.

use crate::call::KernelFn;
use std::cell::Cell;

/// The kind of point that an iteration finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Search {
    /// A point at which all residuals vanish.
    Root,
    /// A minimum: the residuals are the gradient of a function and the Jacobian is its Hessian,
    /// which must be positive definite at the solution.
    Minimum,
}

/// Limit of the number of unknowns of one system.
pub const MOST_UNKNOWNS: usize = 4;

/// Number of values of the largest system: the residuals, and the Jacobian row by row.
pub const MOST_VALUES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 1);

/// Limit of the number of evaluations, including those of rejected steps.
const MOST_EVALUATIONS: usize = 100;

/// The smallest damping factor.
const SMALLEST_DAMPING: f64 = 1.0 / 4096.0;

/// A correction of this size relative to the unknowns does not change the solution.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Bound of corrections that rounding errors of the residual explain, relative to the largest
/// unknown of all iterates.
const NOISE: f64 = 1e-11;

/// The same bound for a solution at zero, SI units.
const NOISE_AT_ZERO: f64 = 1e-15;

/// Numbers of unsuccessful iterations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Failures {
    /// Searches of a root that did not converge.
    pub roots: u64,
    /// Searches of a minimum that did not converge, or converged to another stationary point.
    pub minima: u64,
}

thread_local! {
    static FAILURES: Cell<Failures> = const { Cell::new(Failures { roots: 0, minima: 0 }) };
}

/// Returns the numbers of unsuccessful iterations on this thread.
pub fn failures() -> Failures {
    FAILURES.get()
}

/// Solves a system of up to [`MOST_UNKNOWNS`] equations.
///
/// `inputs` starts with the guess, which the solution replaces; `evaluate` receives `inputs` and
/// writes the residuals, followed by their derivatives with respect to the unknowns, row by row.
/// The residual at the last iterate verifies the solution: the correction that follows the last
/// one is estimated to be smaller than a rounding error of the unknowns, or the corrections no
/// longer decrease and are rounding errors of the residual. The Hessian at a minimum is evaluated
/// at the solution itself.
///
/// Returns `false`, and NaN for all unknowns, if the iteration does not converge, or if the
/// solution is not a minimum although one is searched. Does not allocate or panic.
pub fn newton(
    search: Search,
    unknowns: usize,
    inputs: &mut [f64],
    evaluate: impl FnMut(&[f64], &mut [f64; MOST_VALUES]),
) -> bool {
    let found = inputs.len() >= unknowns
        && match unknowns {
            1 => find::<1>(search, inputs, evaluate),
            2 => find::<2>(search, inputs, evaluate),
            3 => find::<3>(search, inputs, evaluate),
            4 => find::<4>(search, inputs, evaluate),
            _ => false,
        };
    if !found {
        let mut failures = FAILURES.get();
        let count = match search {
            Search::Root => &mut failures.roots,
            Search::Minimum => &mut failures.minima,
        };
        *count = count.wrapping_add(1);
        FAILURES.set(failures);
        inputs.iter_mut().take(unknowns).for_each(|unknown| *unknown = f64::NAN);
    }
    found
}

/// Repeats an iteration that failed, and leaves the unknowns at its last iterate. Returns the
/// residuals there, followed by their derivatives.
pub fn last_iterate(
    search: Search,
    unknowns: usize,
    inputs: &mut [f64],
    mut evaluate: impl FnMut(&[f64], &mut [f64; MOST_VALUES]),
) -> [f64; MOST_VALUES] {
    let mut values = [f64::NAN; MOST_VALUES];
    if inputs.len() < unknowns {
        return values;
    }
    match unknowns {
        1 => find::<1>(search, inputs, &mut evaluate),
        2 => find::<2>(search, inputs, &mut evaluate),
        3 => find::<3>(search, inputs, &mut evaluate),
        4 => find::<4>(search, inputs, &mut evaluate),
        _ => return values,
    };
    evaluate(inputs, &mut values);
    values
}

fn find<const N: usize>(
    search: Search,
    inputs: &mut [f64],
    mut evaluate: impl FnMut(&[f64], &mut [f64; MOST_VALUES]),
) -> bool {
    if !iterate::<N>(inputs, &mut evaluate) {
        return false;
    }
    match search {
        Search::Root => true,
        Search::Minimum => {
            let mut values = [0.0; MOST_VALUES];
            evaluate(inputs, &mut values);
            is_positive_definite::<N>(&values)
        }
    }
}

/// Returns `true` if the Hessian that follows the gradient is positive definite: all pivots of its
/// factorization `L D L^T` are positive, by more than their rounding errors.
fn is_positive_definite<const N: usize>(values: &[f64; MOST_VALUES]) -> bool {
    let mut matrix = [[0.0; N]; N];
    for (i, row) in matrix.iter_mut().enumerate() {
        row.copy_from_slice(&values[N + i * N..N + (i + 1) * N]);
    }
    let diagonal: [f64; N] = std::array::from_fn(|i| matrix[i][i]);
    for k in 0..N {
        let pivot = matrix[k][k];
        let rounding = diagonal[k] * (N as f64 * f64::EPSILON);
        // A NaN is not finite.
        if !pivot.is_finite() || !rounding.is_finite() || pivot <= rounding.max(0.0) {
            return false;
        }
        for i in k + 1..N {
            let factor = matrix[i][k] / pivot;
            for j in k + 1..N {
                matrix[i][j] -= factor * matrix[k][j];
            }
        }
    }
    true
}

fn iterate<const N: usize>(
    inputs: &mut [f64],
    mut evaluate: impl FnMut(&[f64], &mut [f64; MOST_VALUES]),
) -> bool {
    let mut values = [0.0; MOST_VALUES];
    let mut x = [0.0; N];
    x.copy_from_slice(&inputs[..N]);
    evaluate(inputs, &mut values);
    let Some(mut jacobian) = Factors::<N>::new(&values) else { return false };
    let mut correction = jacobian.solve(&values);
    let mut size = largest(&correction);
    // The largest unknown so far.
    let mut range = largest(&x);
    let mut previous = f64::INFINITY;
    let mut damping = 1.0;
    for _ in 0..MOST_EVALUATIONS {
        if !size.is_finite() {
            return false;
        }
        let trial: [f64; N] = std::array::from_fn(|i| x[i] - damping * correction[i]);
        inputs[..N].copy_from_slice(&trial);
        // The corrections of a quadratically convergent iteration satisfy d'' = d' (d' / d)^2.
        let next = if previous.is_finite() { size * (size / previous) * (size / previous) } else { size };
        let magnitude = largest(&trial);
        if damping == 1.0 && next <= ROUNDING * magnitude.max(1e-4 * range) {
            return true;
        }
        evaluate(inputs, &mut values);
        let simplified = largest(&jacobian.solve(&values));
        if simplified < (1.0 - damping / 4.0) * size
            && let Some(factors) = Factors::new(&values)
        {
            (x, jacobian) = (trial, factors);
            correction = jacobian.solve(&values);
            previous = if damping == 1.0 { size } else { f64::INFINITY };
            size = largest(&correction);
            range = range.max(magnitude);
            damping = 1.0;
            continue;
        }
        if size <= (NOISE * range).max(NOISE_AT_ZERO) {
            // If the trial gave NaN, its correction is not smaller either.
            let better = if simplified < size { trial } else { x };
            inputs[..N].copy_from_slice(&better);
            return true;
        }
        damping *= 0.5;
        if damping < SMALLEST_DAMPING {
            return false;
        }
    }
    false
}

/// Returns the largest absolute value; NaN if there is a NaN.
fn largest<const N: usize>(vector: &[f64; N]) -> f64 {
    vector
        .iter()
        .fold(0.0, |largest, x| if x.abs() <= largest || largest.is_nan() { largest } else { x.abs() })
}

/// Triangular factors of a Jacobian with rows scaled to a largest entry of 1.
struct Factors<const N: usize> {
    /// The rows in pivot order: multipliers below the diagonal, the upper factor from it on.
    rows: [[f64; N]; N],
    /// For each row in pivot order, its index in the Jacobian and its scale.
    order: [(usize, f64); N],
}

impl<const N: usize> Factors<N> {
    /// Factors the Jacobian that follows the residuals; `None` if it is singular or not finite.
    fn new(values: &[f64; MOST_VALUES]) -> Option<Self> {
        let mut rows = [[0.0; N]; N];
        let mut order = [(0, 1.0); N];
        for (i, (row, place)) in rows.iter_mut().zip(&mut order).enumerate() {
            row.copy_from_slice(&values[N + i * N..N + (i + 1) * N]);
            let scale = largest(row);
            if !(scale > 0.0 && scale.is_finite()) {
                return None;
            }
            *place = (i, scale);
            if N > 1 {
                row.iter_mut().for_each(|entry| *entry /= scale);
            }
        }
        for k in 0..N {
            let mut pivot = k;
            for i in k + 1..N {
                if rows[i][k].abs() > rows[pivot][k].abs() {
                    pivot = i;
                }
            }
            rows.swap(k, pivot);
            order.swap(k, pivot);
            if rows[k][k] == 0.0 {
                return None;
            }
            for i in k + 1..N {
                let factor = rows[i][k] / rows[k][k];
                rows[i][k] = factor;
                for j in k + 1..N {
                    rows[i][j] -= factor * rows[k][j];
                }
            }
        }
        Some(Factors { rows, order })
    }

    /// Returns the correction for the residuals at the start of `values`.
    fn solve(&self, values: &[f64; MOST_VALUES]) -> [f64; N] {
        let mut x: [f64; N] = std::array::from_fn(|k| {
            let (row, scale) = self.order[k];
            if N > 1 { values[row] / scale } else { values[row] }
        });
        for k in 1..N {
            for j in 0..k {
                x[k] -= self.rows[k][j] * x[j];
            }
        }
        for k in (0..N).rev() {
            for j in k + 1..N {
                x[k] -= self.rows[k][j] * x[j];
            }
            x[k] /= self.rows[k][k];
        }
        x
    }
}

/// [`newton`] for machine code. `inputs` holds `count` numbers: the guess and the arguments of the
/// residual kernel. Returns 0 if the iteration converges, otherwise 1.
///
/// # Safety
/// `inputs` must be valid for reading and writing `count` numbers. `residual` must read at most
/// `count` inputs and write at most [`MOST_VALUES`] outputs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_math_newton(
    residual: KernelFn,
    unknowns: usize,
    inputs: *mut f64,
    count: usize,
) -> i32 {
    // SAFETY: guaranteed by the caller.
    unsafe { search(Search::Root, residual, unknowns, (inputs, count)) }
}

/// As [`calyx_math_newton`], for a minimum: the residual kernel returns the gradient of a function
/// and its Hessian.
///
/// # Safety
/// As for [`calyx_math_newton`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_math_minimum(
    gradient: KernelFn,
    unknowns: usize,
    inputs: *mut f64,
    count: usize,
) -> i32 {
    // SAFETY: guaranteed by the caller.
    unsafe { search(Search::Minimum, gradient, unknowns, (inputs, count)) }
}

/// # Safety
/// As for [`calyx_math_newton`].
unsafe fn search(
    search: Search,
    residual: KernelFn,
    unknowns: usize,
    (inputs, count): (*mut f64, usize),
) -> i32 {
    // SAFETY: guaranteed by the caller.
    let inputs = unsafe { std::slice::from_raw_parts_mut(inputs, count) };
    let found = newton(search, unknowns, inputs, |inputs, values| {
        // SAFETY: guaranteed by the caller.
        unsafe { residual(inputs.as_ptr(), values.as_mut_ptr()) };
    });
    i32::from(!found)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Solves one equation and returns the solution and the number of evaluations.
    fn root(guess: f64, f: impl Fn(f64) -> (f64, f64)) -> (f64, usize) {
        let (mut inputs, mut count) = ([guess], 0);
        newton(Search::Root, 1, &mut inputs, |x, values| {
            count += 1;
            (values[0], values[1]) = f(x[0]);
        });
        (inputs[0], count)
    }

    #[test]
    fn solutions_are_accurate_to_rounding() {
        let (x, evaluations) = root(1.0, |x| (x * x - 2.0, 2.0 * x));
        assert!((x - std::f64::consts::SQRT_2).abs() <= f64::EPSILON, "{x}");
        assert!(evaluations <= 5, "{evaluations}");
        // Kepler's equation; the solution was computed with 50 digits.
        let (x, _) = root(1.0, |x| (x - 0.9 * x.sin() - 1.0, 1.0 - 0.9 * x.cos()));
        assert!((x - 1.862_086_686_874_532_3).abs() <= 4.0 * f64::EPSILON, "{x:.17}");
    }

    #[test]
    fn a_solution_at_zero_and_an_exact_guess_are_found() {
        assert!(root(0.5, |x| (x.sin(), x.cos())).0.abs() < 1e-30);
        assert_eq!(root(0.0, |x| (x.sin(), x.cos())), (0.0, 1));
        // Rounding errors of the residual are larger than those of the unknown.
        let (x, evaluations) = root(0.0, |x| ((x + 1.0) - 1.0 + 3e-17, 1.0));
        assert!(x.abs() < 1e-15 && evaluations < 10, "{x} {evaluations}");
        let (x, _) = root(0.1, |x| (x.exp() - 1.0, x.exp()));
        assert!(x.abs() < 1e-15, "{x}");
    }

    #[test]
    fn damping_finds_solutions_that_full_steps_miss() {
        let (x, _) = root(10.0, |x| (x.atan(), 1.0 / (1.0 + x * x)));
        assert!(x.abs() < 1e-15, "{x}");
    }

    #[test]
    fn failures_are_nan_and_counted() {
        let before = failures();
        assert!(root(1.0, |x| (x * x + 1.0, 2.0 * x)).0.is_nan());
        assert!(root(0.0, |x| (x * x - 1.0, 2.0 * x)).0.is_nan());
        assert!(root(f64::NAN, |x| (x, 1.0)).0.is_nan());
        assert!(root(1.0, |_| (f64::NAN, f64::NAN)).0.is_nan());
        assert!(root(1.0, |x| (x, f64::INFINITY)).0.is_nan());
        assert_eq!(failures(), Failures { roots: before.roots + 5, ..before });
        assert!(!newton(Search::Root, 5, &mut [0.0; 5], |_, _| ()));
        // The residual of x^2 + 1 is smallest at 0, where its derivative vanishes.
        let mut inputs = [1.0];
        let values = last_iterate(Search::Root, 1, &mut inputs, |x, values| {
            (values[0], values[1]) = (x[0] * x[0] + 1.0, 2.0 * x[0]);
        });
        assert!(inputs[0].abs() < 0.1 && values[0] == inputs[0] * inputs[0] + 1.0, "{inputs:?}");
        assert!(!newton(Search::Root, 2, &mut [0.0], |_, _| ()));
    }

    #[test]
    fn only_a_minimum_satisfies_the_second_order_condition() {
        // The stationary points of x^4 - 2 x^2 are a maximum at 0 and minima at -1 and 1.
        let minimum = |guess: f64| {
            let mut inputs = [guess];
            let found = newton(Search::Minimum, 1, &mut inputs, |x, values| {
                let x = x[0];
                (values[0], values[1]) = (4.0 * x * (x * x - 1.0), 12.0 * x * x - 4.0);
            });
            (found, inputs[0])
        };
        assert_eq!(minimum(1.3), (true, 1.0));
        assert_eq!(minimum(-0.9), (true, -1.0));
        let before = failures();
        assert!(!minimum(0.1).0 && minimum(0.1).1.is_nan());
        assert_eq!(failures(), Failures { minima: before.minima + 2, ..before });
        // x^2 + a y^2 + b x y has a minimum at the origin for 4 a > b^2, otherwise a saddle point.
        let quadratic = |a: f64, b: f64| {
            newton(Search::Minimum, 2, &mut [0.3, -0.2], |x, values| {
                let [x, y] = [x[0], x[1]];
                let all = [2.0 * x + b * y, 2.0 * a * y + b * x, 2.0, b, b, 2.0 * a];
                values[..6].copy_from_slice(&all);
            })
        };
        assert!(quadratic(1.0, 0.5) && quadratic(1e-6, 1e-4) && quadratic(1e6, 1.9e3));
        assert!(!quadratic(-1.0, 0.5) && !quadratic(1.0, 2.5) && !quadratic(1.0, 2.0));
    }

    #[test]
    fn systems_are_solved_whatever_the_scale_of_their_residuals() {
        // A circle and a parabola, the equations scaled by 1e12 and 1e-9.
        let mut inputs = [0.5, 2.0];
        assert!(newton(Search::Root, 2, &mut inputs, |x, values| {
            let [a, b] = [x[0], x[1]];
            let residuals = [(a * a + b * b - 4.0) * 1e12, (b - a * a) * 1e-9];
            let jacobian = [2e12 * a, 2e12 * b, -2e-9 * a, 1e-9];
            values[..2].copy_from_slice(&residuals);
            values[2..6].copy_from_slice(&jacobian);
        }));
        let b = (17f64.sqrt() - 1.0) / 2.0;
        assert!((inputs[1] - b).abs() < 4e-16 && (inputs[0] - b.sqrt()).abs() < 4e-16, "{inputs:?}");

        // A linear system that needs pivoting.
        let matrix = [[0.0, 2.0, 1.0, 0.0], [1.0, 0.0, 0.0, 3.0], [0.0, 0.0, 4.0, 1.0], [2.0, 1.0, 0.0, 0.0]];
        let expected = [1.0, -2.0, 0.5, 3.0];
        let mut inputs = [0.0; 4];
        assert!(newton(Search::Root, 4, &mut inputs, |x, values| {
            for (i, row) in matrix.iter().enumerate() {
                values[i] = (0..4).map(|j| row[j] * (x[j] - expected[j])).sum();
                values[4 + 4 * i..8 + 4 * i].copy_from_slice(row);
            }
        }));
        assert!(inputs.iter().zip(expected).all(|(x, e)| (x - e).abs() < 1e-15), "{inputs:?}");
    }
}
