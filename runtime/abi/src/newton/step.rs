//! The steps of Newton's method, written once for all evaluators.
//!
//! A step is straight-line arithmetic of an [`Arithmetic`]. Numbers execute it; the code generator
//! emits it as instructions around the inlined residuals. Both therefore give the same bits.

use crate::math;

/// Largest number of unknowns of one system.
pub const MOST_UNKNOWNS: usize = 4;

/// Number of values of the largest system: the residuals, and the Jacobian row by row.
pub const MOST_VALUES: usize = MOST_UNKNOWNS * (MOST_UNKNOWNS + 1);

/// The smallest damping factor.
const SMALLEST_DAMPING: f64 = 1.0 / 4096.0;

/// A correction of this size relative to the unknowns does not change the solution.
const ROUNDING: f64 = f64::EPSILON / 2.0;

/// Bound of corrections that rounding errors of the residual explain, relative to the largest
/// unknown of all iterates.
const NOISE: f64 = 1e-11;

/// The same bound for a solution at zero, SI units.
const NOISE_AT_ZERO: f64 = 1e-15;

/// The operations in which a [`Step`] is written: on numbers ([`Numbers`]), or on the values of
/// machine code under construction.
pub trait Arithmetic {
    type Number: Copy;
    type Truth: Copy;

    fn constant(&mut self, value: f64) -> Self::Number;
    fn add(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn subtract(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn multiply(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn divide(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    fn abs(&mut self, a: Self::Number) -> Self::Number;
    /// See [`math::max`].
    fn max(&mut self, a: Self::Number, b: Self::Number) -> Self::Number;
    /// `a < b`; false if either is NaN.
    fn less(&mut self, a: Self::Number, b: Self::Number) -> Self::Truth;
    /// `a <= b`; false if either is NaN.
    fn less_equal(&mut self, a: Self::Number, b: Self::Number) -> Self::Truth;
    fn both(&mut self, a: Self::Truth, b: Self::Truth) -> Self::Truth;
    /// `a` if the condition is true, else `b`.
    fn choose(&mut self, condition: Self::Truth, a: Self::Number, b: Self::Number) -> Self::Number;

    /// The larger one; `b` if either is NaN. One machine instruction, unlike `max`.
    fn larger(&mut self, a: Self::Number, b: Self::Number) -> Self::Number {
        let greater = self.less(b, a);
        self.choose(greater, a, b)
    }
}

/// Arithmetic that is executed.
#[derive(Clone, Copy, Debug)]
pub struct Numbers;

impl Arithmetic for Numbers {
    type Number = f64;
    type Truth = bool;

    #[inline]
    fn constant(&mut self, value: f64) -> f64 {
        value
    }
    #[inline]
    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }
    #[inline]
    fn subtract(&mut self, a: f64, b: f64) -> f64 {
        a - b
    }
    #[inline]
    fn multiply(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }
    #[inline]
    fn divide(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }
    #[inline]
    fn abs(&mut self, a: f64) -> f64 {
        math::abs(a)
    }
    #[inline]
    fn max(&mut self, a: f64, b: f64) -> f64 {
        math::max(a, b)
    }
    #[inline]
    fn less(&mut self, a: f64, b: f64) -> bool {
        a < b
    }
    #[inline]
    fn less_equal(&mut self, a: f64, b: f64) -> bool {
        a <= b
    }
    #[inline]
    fn both(&mut self, a: bool, b: bool) -> bool {
        a && b
    }
    #[inline]
    fn choose(&mut self, condition: bool, a: f64, b: f64) -> f64 {
        if condition { a } else { b }
    }
}

/// The state of the iteration after an accepted iterate.
pub struct Step<V, const N: usize> {
    /// The unknowns of the iterate.
    x: [V; N],
    /// The Jacobian at the iterate, ready for [`Jacobian::correction`].
    jacobian: Jacobian<V, N>,
    /// The correction that a full step subtracts, and its largest absolute value.
    correction: [V; N],
    size: V,
    /// Size of the correction before, if the step with it was not damped, otherwise infinite.
    previous: V,
    /// The largest unknown so far.
    range: V,
    damping: V,
}

/// A point at which the equations are evaluated.
pub struct Trial<V, T, const N: usize> {
    /// The unknowns.
    pub x: [V; N],
    /// The largest absolute value of the unknowns.
    magnitude: V,
    /// `true` if the point is the solution: the correction that would follow is smaller than a
    /// rounding error of the unknowns.
    pub converged: T,
}

/// The evaluation at a trial point, compared with the step that led to it.
pub struct Judgement<V, T, const N: usize> {
    /// `true` if the trial point becomes the next iterate.
    pub accepted: T,
    /// Size of the correction at the trial point with the Jacobian of the iterate.
    simplified: V,
    /// The Jacobian at the trial point.
    jacobian: Jacobian<V, N>,
}

impl<V: Copy, const N: usize> Step<V, N> {
    /// Number of numbers of a state.
    pub const NUMBERS: usize = 2 * N + N * N + 4;

    /// Returns the state before the first evaluation: an infinite correction, so that any finite
    /// residual at the guess is smaller, with a Jacobian that makes all corrections zero.
    pub fn new<A: Arithmetic<Number = V>>(a: &mut A, guess: [V; N]) -> Self {
        let (zero, one, infinity) = (a.constant(0.0), a.constant(1.0), a.constant(f64::INFINITY));
        let entry = if N == 1 { infinity } else { zero };
        Step {
            x: guess,
            jacobian: Jacobian { entries: [[entry; N]; N] },
            correction: [zero; N],
            size: infinity,
            previous: infinity,
            range: zero,
            damping: one,
        }
    }

    /// Returns all numbers of the state.
    pub fn numbers(&self) -> Vec<V> {
        let vectors = self.x.iter().chain(self.jacobian.entries.as_flattened()).chain(&self.correction);
        vectors.copied().chain([self.size, self.previous, self.range, self.damping]).collect()
    }

    /// Returns the state with the [`Step::numbers`] of another one; `None` for a wrong count.
    pub fn from_numbers(numbers: &[V]) -> Option<Self> {
        let (x, rest) = numbers.split_first_chunk::<N>()?;
        let (entries, rest) = rest.split_at_checked(N * N)?;
        let (correction, rest) = rest.split_first_chunk::<N>()?;
        let &[size, previous, range, damping] = rest else { return None };
        let jacobian =
            Jacobian { entries: std::array::from_fn(|i| std::array::from_fn(|j| entries[i * N + j])) };
        Some(Step { x: *x, jacobian, correction: *correction, size, previous, range, damping })
    }

    /// Returns the next trial point.
    pub fn propose<A: Arithmetic<Number = V>>(&self, a: &mut A) -> Trial<V, A::Truth, N> {
        let x = std::array::from_fn(|i| {
            let part = a.multiply(self.damping, self.correction[i]);
            a.subtract(self.x[i], part)
        });
        // The corrections of a quadratically convergent iteration satisfy d'' = d' (d' / d)^2.
        let ratio = a.divide(self.size, self.previous);
        let next = a.multiply(self.size, ratio);
        let next = a.multiply(next, ratio);
        let known = is_finite(a, self.previous);
        let next = a.choose(known, next, self.size);
        let magnitude = largest(a, &x);
        let small = a.constant(1e-4);
        let floor = a.multiply(small, self.range);
        let scale = a.larger(floor, magnitude);
        let rounding = a.constant(ROUNDING);
        let bound = a.multiply(rounding, scale);
        let negligible = a.less_equal(next, bound);
        let one = a.constant(1.0);
        let full = a.less_equal(one, self.damping);
        Trial { x, magnitude, converged: a.both(negligible, full) }
    }

    /// Compares the values at the trial point (residuals, then Jacobian) with the state.
    pub fn judge<A: Arithmetic<Number = V>>(
        &self,
        a: &mut A,
        values: &[V],
    ) -> Option<Judgement<V, A::Truth, N>> {
        let simplified = self.jacobian.correction(a, values)?;
        let simplified = largest(a, &simplified);
        let (jacobian, regular) = Jacobian::new(a, values)?;
        let (one, quarter) = (a.constant(1.0), a.constant(0.25));
        let decrease = a.multiply(quarter, self.damping);
        let factor = a.subtract(one, decrease);
        let bound = a.multiply(factor, self.size);
        let smaller = a.less(simplified, bound);
        Some(Judgement { accepted: a.both(smaller, regular), simplified, jacobian })
    }

    /// Returns the state with the trial point as iterate, and whether its correction is finite.
    pub fn accept<A: Arithmetic<Number = V>>(
        &self,
        a: &mut A,
        trial: &Trial<V, A::Truth, N>,
        values: &[V],
        judgement: Judgement<V, A::Truth, N>,
    ) -> Option<(Self, A::Truth)> {
        let jacobian = judgement.jacobian;
        let correction = jacobian.correction(a, values)?;
        let size = largest(a, &correction);
        let (one, infinity) = (a.constant(1.0), a.constant(f64::INFINITY));
        let full = a.less_equal(one, self.damping);
        let previous = a.choose(full, self.size, infinity);
        let range = a.larger(self.range, trial.magnitude);
        let finite = is_finite(a, size);
        Some((Step { x: trial.x, jacobian, correction, size, previous, range, damping: one }, finite))
    }

    /// Returns the better one of iterate and trial point, and whether it is the solution although
    /// the trial point was rejected: rounding errors of the residual explain the correction.
    pub fn settle<A: Arithmetic<Number = V>>(
        &self,
        a: &mut A,
        trial: &Trial<V, A::Truth, N>,
        judgement: &Judgement<V, A::Truth, N>,
    ) -> ([V; N], A::Truth) {
        let (noise, least) = (a.constant(NOISE), a.constant(NOISE_AT_ZERO));
        let noise = a.multiply(noise, self.range);
        let noise = a.larger(noise, least);
        // If the trial point gave NaN, its correction is not smaller either.
        let smaller = a.less(judgement.simplified, self.size);
        let better = std::array::from_fn(|i| a.choose(smaller, trial.x[i], self.x[i]));
        (better, a.less_equal(self.size, noise))
    }

    /// Returns the state with half the damping factor, and whether another trial point is
    /// worthwhile.
    pub fn damp<A: Arithmetic<Number = V>>(mut self, a: &mut A) -> (Self, A::Truth) {
        let (half, least) = (a.constant(0.5), a.constant(SMALLEST_DAMPING));
        self.damping = a.multiply(half, self.damping);
        let large = a.less_equal(least, self.damping);
        // Before the first evaluation, the correction is infinite.
        let finite = is_finite(a, self.size);
        (self, a.both(large, finite))
    }
}

/// Returns whether the Hessian that follows the gradient in `values` is positive definite: all
/// pivots of its factorization `L D L^T` are positive, by more than their rounding errors.
pub fn is_positive_definite<A: Arithmetic, const N: usize>(
    a: &mut A,
    values: &[A::Number],
) -> Option<A::Truth> {
    let mut matrix: [[A::Number; N]; N] = rows(values)?;
    let diagonal: [A::Number; N] = std::array::from_fn(|i| matrix[i][i]);
    let (zero, epsilon) = (a.constant(0.0), a.constant(N as f64 * f64::EPSILON));
    let mut definite = a.less_equal(zero, zero);
    for k in 0..N {
        let pivot = matrix[k][k];
        let rounding = a.multiply(diagonal[k], epsilon);
        let rounding = a.max(rounding, zero);
        let (positive, finite) = (a.less(rounding, pivot), is_finite(a, pivot));
        definite = a.both(definite, positive);
        definite = a.both(definite, finite);
        for i in k + 1..N {
            let factor = a.divide(matrix[i][k], pivot);
            for j in k + 1..N {
                let product = a.multiply(factor, matrix[k][j]);
                matrix[i][j] = a.subtract(matrix[i][j], product);
            }
        }
    }
    Some(definite)
}

/// The Jacobian in a form that gives corrections by few operations: the derivative itself for one
/// unknown, otherwise the inverse.
///
/// An inverse is computed once and applied twice per iterate. Its rounding errors are those of a
/// factorization times a small factor, and affect only the last digits of a correction.
struct Jacobian<V, const N: usize> {
    entries: [[V; N]; N],
}

impl<V: Copy, const N: usize> Jacobian<V, N> {
    /// Prepares the Jacobian that follows the residuals, and returns whether it is finite and not
    /// singular.
    fn new<A: Arithmetic<Number = V>>(a: &mut A, values: &[V]) -> Option<(Self, A::Truth)> {
        let entries = rows(values)?;
        Some(match N {
            1 => {
                let size = a.abs(entries[0][0]);
                let regular = is_normal(a, size);
                (Jacobian { entries }, regular)
            }
            2 => Jacobian::by_cofactors(a, entries),
            _ => Jacobian::by_elimination(a, entries),
        })
    }

    /// Inverts a matrix of two rows. Cramer's rule is forward stable for two unknowns (Higham,
    /// *Accuracy and Stability of Numerical Algorithms*, 2002, section 1.10.1), whatever the scales
    /// of the rows.
    fn by_cofactors<A: Arithmetic<Number = V>>(a: &mut A, m: [[V; N]; N]) -> (Self, A::Truth) {
        let (main, other) = (a.multiply(m[0][0], m[1][1]), a.multiply(m[0][1], m[1][0]));
        let determinant = a.subtract(main, other);
        let size = a.abs(determinant);
        let regular = is_normal(a, size);
        let (zero, one) = (a.constant(0.0), a.constant(1.0));
        let factor = a.divide(one, determinant);
        let opposite = a.subtract(zero, factor);
        let mut entries = m;
        entries[0][0] = a.multiply(m[1][1], factor);
        entries[0][1] = a.multiply(m[0][1], opposite);
        entries[1][0] = a.multiply(m[1][0], opposite);
        entries[1][1] = a.multiply(m[0][0], factor);
        (Jacobian { entries }, regular)
    }

    /// Inverts a matrix by Gauss-Jordan elimination with partial pivoting, after scaling its rows
    /// to a largest entry of 1.
    fn by_elimination<A: Arithmetic<Number = V>>(a: &mut A, mut left: [[V; N]; N]) -> (Self, A::Truth) {
        let (zero, one) = (a.constant(0.0), a.constant(1.0));
        let mut regular = a.less_equal(zero, zero);
        let mut right = [[zero; N]; N];
        for i in 0..N {
            let scale = largest(a, &left[i]);
            let normal = is_normal(a, scale);
            regular = a.both(regular, normal);
            right[i][i] = a.divide(one, scale);
            left[i] = left[i].map(|entry| a.multiply(entry, right[i][i]));
        }
        for k in 0..N {
            for i in k + 1..N {
                let (upper, lower) = (a.abs(left[k][k]), a.abs(left[i][k]));
                let exchange = a.less(upper, lower);
                for matrix in [&mut left, &mut right] {
                    for j in 0..N {
                        let (upper, lower) = (matrix[k][j], matrix[i][j]);
                        matrix[k][j] = a.choose(exchange, lower, upper);
                        matrix[i][j] = a.choose(exchange, upper, lower);
                    }
                }
            }
            let pivot = a.abs(left[k][k]);
            let positive = a.less(zero, pivot);
            regular = a.both(regular, positive);
            let factor = a.divide(one, left[k][k]);
            for j in k + 1..N {
                left[k][j] = a.multiply(left[k][j], factor);
            }
            right[k] = right[k].map(|entry| a.multiply(entry, factor));
            for i in (0..N).filter(|&i| i != k) {
                let factor = left[i][k];
                for j in k + 1..N {
                    let product = a.multiply(factor, left[k][j]);
                    left[i][j] = a.subtract(left[i][j], product);
                }
                for j in 0..N {
                    let product = a.multiply(factor, right[k][j]);
                    right[i][j] = a.subtract(right[i][j], product);
                }
            }
        }
        (Jacobian { entries: right }, regular)
    }

    /// Returns the correction for the residuals at the start of `values`.
    fn correction<A: Arithmetic<Number = V>>(&self, a: &mut A, values: &[V]) -> Option<[V; N]> {
        let residuals = values.first_chunk::<N>()?;
        if N == 1 {
            return Some(residuals.map(|residual| a.divide(residual, self.entries[0][0])));
        }
        Some(self.entries.map(|row| {
            let first = a.multiply(row[0], residuals[0]);
            (1..N).fold(first, |sum, j| {
                let product = a.multiply(row[j], residuals[j]);
                a.add(sum, product)
            })
        }))
    }
}

/// Returns the matrix that follows the residuals.
fn rows<T: Copy, const N: usize>(values: &[T]) -> Option<[[T; N]; N]> {
    let entries = values.get(N..N + N * N)?;
    Some(std::array::from_fn(|i| std::array::from_fn(|j| entries[i * N + j])))
}

/// Returns the largest absolute value; NaN if there is a NaN.
fn largest<A: Arithmetic, const N: usize>(a: &mut A, vector: &[A::Number; N]) -> A::Number {
    let first = a.abs(vector[0]);
    vector[1..].iter().fold(first, |largest, &x| {
        let size = a.abs(x);
        a.max(largest, size)
    })
}

/// Returns whether a number that is not negative is finite.
fn is_finite<A: Arithmetic>(a: &mut A, size: A::Number) -> A::Truth {
    let most = a.constant(f64::MAX);
    a.less_equal(size, most)
}

/// Returns whether a number that is not negative is finite, and so large that its reciprocal is.
fn is_normal<A: Arithmetic>(a: &mut A, size: A::Number) -> A::Truth {
    let least = a.constant(f64::MIN_POSITIVE);
    let (large, finite) = (a.less_equal(least, size), is_finite(a, size));
    a.both(large, finite)
}
