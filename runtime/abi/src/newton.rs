//! Newton's method for implicit functions: the single definition that the interpreter and machine
//! code use.
//!
//! The iteration is damped by the natural monotonicity test (Deuflhard, *Newton Methods for
//! Nonlinear Problems*, 2004, section 3.3). The test compares corrections instead of residuals, so
//! neither the units of the residuals nor their scale affects it.
//!
//! [`Step`] contains the arithmetic of one iteration. [`newton`] executes it; the code generator
//! emits the same arithmetic around the inlined residuals.

mod step;

use std::cell::Cell;

pub use step::{
    Arithmetic, Judgement, MOST_UNKNOWNS, MOST_VALUES, Numbers, Step, Trial, is_positive_definite,
};

/// The kind of point that an iteration finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Search {
    /// A point at which all residuals vanish.
    Root,
    /// A minimum: the residuals are the gradient of a function and the Jacobian is its Hessian,
    /// which must be positive definite at the solution.
    Minimum,
}

/// Limit of the number of evaluations after that of the guess, including those of rejected steps.
pub const MOST_EVALUATIONS: usize = 100;

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
    let found = match unknowns {
        1 => find::<1>(search, inputs, evaluate),
        2 => find::<2>(search, inputs, evaluate),
        3 => find::<3>(search, inputs, evaluate),
        4 => find::<4>(search, inputs, evaluate),
        _ => None,
    };
    if found.is_none() {
        count_failure(search);
        inputs.iter_mut().take(unknowns).for_each(|unknown| *unknown = f64::NAN);
    }
    found.is_some()
}

fn count_failure(search: Search) {
    let mut failures = FAILURES.get();
    let count = match search {
        Search::Root => &mut failures.roots,
        Search::Minimum => &mut failures.minima,
    };
    *count = count.wrapping_add(1);
    FAILURES.set(failures);
}

/// Counts an iteration of machine code that failed: 0 for a root, otherwise a minimum.
#[unsafe(no_mangle)]
pub extern "C" fn calyx_math_unsolved(search: usize) {
    count_failure(if search == 0 { Search::Root } else { Search::Minimum });
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

/// Returns `None` if the iteration fails. The start of `inputs` contains the last trial point.
fn find<const N: usize>(
    search: Search,
    inputs: &mut [f64],
    mut evaluate: impl FnMut(&[f64], &mut [f64; MOST_VALUES]),
) -> Option<()> {
    let mut values = [0.0; MOST_VALUES];
    let solution = iterate::<N>(inputs, &mut values, &mut evaluate)?;
    inputs.first_chunk_mut::<N>()?.copy_from_slice(&solution);
    if search == Search::Root {
        return Some(());
    }
    evaluate(inputs, &mut values);
    is_positive_definite::<Numbers, N>(&mut Numbers, &values)?.then_some(())
}

/// Returns the solution; `None` if the iteration fails. The code generator emits the same blocks.
fn iterate<const N: usize>(
    inputs: &mut [f64],
    values: &mut [f64; MOST_VALUES],
    mut evaluate: impl FnMut(&[f64], &mut [f64; MOST_VALUES]),
) -> Option<[f64; N]> {
    let a = &mut Numbers;
    let mut step = Step::<f64, N>::new(a, *inputs.first_chunk::<N>()?);
    for _ in 0..=MOST_EVALUATIONS {
        let trial = step.propose(a);
        if trial.converged {
            return Some(trial.x);
        }
        inputs.first_chunk_mut::<N>()?.copy_from_slice(&trial.x);
        evaluate(inputs, values);
        let judgement = step.judge(a, values)?;
        let promising = if judgement.accepted {
            let finite;
            (step, finite) = step.accept(a, &trial, values, judgement)?;
            finite
        } else {
            let (better, settled) = step.settle(a, &trial, &judgement);
            if settled {
                return Some(better);
            }
            let worthwhile;
            (step, worthwhile) = step.damp(a);
            worthwhile
        };
        if !promising {
            return None;
        }
    }
    None
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

        // The same with an exchange of the equations and of the unknowns.
        let mut inputs = [2.0, 0.5];
        assert!(newton(Search::Root, 2, &mut inputs, |x, values| {
            let [b, a] = [x[0], x[1]];
            values[..2].copy_from_slice(&[(b - a * a) * 1e-9, (a * a + b * b - 4.0) * 1e12]);
            values[2..6].copy_from_slice(&[1e-9, -2e-9 * a, 2e12 * b, 2e12 * a]);
        }));
        assert!((inputs[0] - b).abs() < 4e-16 && (inputs[1] - b.sqrt()).abs() < 4e-16, "{inputs:?}");
        // Equations that are nearly dependent: x + y = 2, x + (1 + 2^-30) y = 2 + 2^-30.
        let mut inputs = [0.0, 0.0];
        let small = 2f64.powi(-30);
        assert!(newton(Search::Root, 2, &mut inputs, |x, values| {
            let sum = (x[0] - 1.0) + (x[1] - 1.0);
            values[..2].copy_from_slice(&[sum, sum + small * (x[1] - 1.0)]);
            values[2..6].copy_from_slice(&[1.0, 1.0, 1.0, 1.0 + small]);
        }));
        assert_eq!(inputs, [1.0, 1.0]);

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
        assert!(!newton(Search::Root, 3, &mut [0.1; 3], |x, values| {
            // The third equation is the sum of the others.
            values[..3].copy_from_slice(&[x[0] + x[1], x[1] - x[2], x[0] + 2.0 * x[1] - x[2] - 1.0]);
            values[3..12].copy_from_slice(&[1.0, 1.0, 0.0, 0.0, 1.0, -1.0, 1.0, 2.0, -1.0]);
        }));
    }
}
