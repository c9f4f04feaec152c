//! Linear system of harmonic balance at a speed.
//!
//! Its unknowns are the complex amplitudes of all modes at all orders. Small systems are solved
//! directly. In larger ones the varying stiffness is iterated: an iterative method whose
//! preconditioner solves the system of each harmonic with its sidebands, which only the variation
//! of the stiffness over the mesh cycles couples.

use super::orders::Orders;
use calyx_numerics::complex::{ComplexLu, solve_complex, solve_iteratively};
use calyx_numerics::dense::symmetric_eigen;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatMut, MatRef, Par, c64};
use nalgebra::{Complex, DMatrix};
use std::collections::BTreeMap;

/// Largest number of unknowns of a system that is solved directly from the start.
const DIRECT: usize = 120;
/// Largest number of unknowns of a system that is solved directly without convergence of the
/// iteration: 150 MB, and some seconds.
const FALLBACK: usize = 3000;
/// Residual relative to the right-hand side at which the iteration ends.
const RESIDUAL: f64 = 1e-11;
/// Largest number of iterations; after it the system is solved directly.
const ITERATIONS: usize = 100;
/// Coefficients of the stiffness that are smaller than this fraction of the largest one are left
/// out.
const NEGLIGIBLE: f64 = 1e-9;

/// Eigenvalue, relative to the largest one, of a sum of squares that is rounding: motions on which
/// coefficients act with less than 1e-7 of the largest ones are left out.
const ROUNDING: f64 = 1e-14;

/// Coupling of orders by coefficients of the stiffness and of the modal damping.
pub(super) struct Couplings {
    modes: usize,
    orders: Vec<i64>,
    clusters: Vec<Vec<usize>>,
    /// Mean stiffness and modal damping.
    means: [DMatrix<f64>; 2],
    /// Coefficients of other orders.
    all: Vec<Coupling>,
    /// Orthonormal basis, by column, of the motions on which these coefficients act: those of the
    /// meshes, which are fewer than the modes.
    acting: Mat<c64>,
}

/// Coefficient of a matrix at an order, and the pairs of orders of the response that differ by it:
/// the row, then the column.
struct Coupling {
    coefficient: Mat<c64>,
    /// The same in the basis of the motions on which the coefficients act.
    reduced: Mat<c64>,
    pairs: Vec<(usize, usize)>,
    /// True for damping, which multiplies the rate.
    is_damping: bool,
}

/// Fourier coefficients of a matrix by order from zero.
pub(super) type Coefficients = BTreeMap<i64, DMatrix<Complex<f64>>>;

/// Blocks of the orders without their coupling, at a speed.
struct Blocks {
    own: Vec<Mat<c64>>,
    /// Frequencies of the orders, rad/s.
    omegas: Vec<f64>,
}

impl Blocks {
    /// Returns the factor of a coupling at the column of an order: that of the rate for damping.
    fn factor(&self, coupling: &Coupling, column: usize) -> c64 {
        if coupling.is_damping { c64::new(0.0, self.omegas[column]) } else { c64::new(1.0, 0.0) }
    }
}

impl Couplings {
    /// Collects the coefficients of the stiffness and of the modal damping.
    pub fn new(orders: &Orders, stiffness: &Coefficients, damping: &Coefficients) -> Couplings {
        let response = orders.response();
        let mut all = Vec::new();
        for (series, is_damping) in [(stiffness, false), (damping, true)] {
            all.extend(couplings(response, series, is_damping));
        }
        let modes = stiffness.values().next().map_or(0, DMatrix::nrows);
        let mean = |series: &Coefficients| match series.get(&0) {
            Some(mean) => mean.map(|entry| entry.re),
            None => DMatrix::zeros(modes, modes),
        };
        let acting = acting(modes, &all);
        for coupling in &mut all {
            coupling.reduced = acting.transpose() * &coupling.coefficient * &acting;
        }
        Couplings {
            modes,
            orders: response.to_vec(),
            clusters: orders.clusters().to_vec(),
            means: [mean(stiffness), mean(damping)],
            all,
            acting,
        }
    }

    /// Solves the system at a frequency of the common period (rad/s) with the matrix of bearings'
    /// damping and gyroscopic moments of the modes at this speed. `extra` is added to the diagonal
    /// of the mean values. The columns of the right-hand side and of the solution are those of the
    /// orders. `None` if the solution is not finite.
    pub fn solve(
        &self,
        frequency: f64,
        rates: &DMatrix<f64>,
        extra: &[f64],
        right: &Mat<c64>,
    ) -> Option<Mat<c64>> {
        let blocks = self.orders.len();
        let omegas: Vec<f64> = self.orders.iter().map(|&order| order as f64 * frequency).collect();
        let own: Vec<Mat<c64>> = omegas.iter().map(|&omega| self.inertia(omega, rates, extra)).collect();
        let own = Blocks { own, omegas };
        let column = Mat::from_fn(blocks * self.modes, 1, |k, _| right[(k % self.modes, k / self.modes)]);
        let found = match blocks * self.modes {
            ..=DIRECT => None,
            _ => self.iterated(&own, &column),
        };
        let every: Vec<usize> = (0..blocks).collect();
        let found = match found {
            Some(found) => found,
            None if column.nrows() <= FALLBACK => solve_complex(self.assembled(&own, &every), column)?,
            None => return None,
        };
        Some(Mat::from_fn(self.modes, blocks, |i, block| found[(block * self.modes + i, 0)]))
    }

    /// Returns the block of an order with the mean stiffness and modal damping.
    fn inertia(&self, omega: f64, rates: &DMatrix<f64>, extra: &[f64]) -> Mat<c64> {
        Mat::from_fn(self.modes, self.modes, |i, j| {
            let [stiffness, damping] = [0, 1].map(|kind: usize| self.means[kind][(i, j)]);
            let own = c64::new(stiffness, omega * (rates[(i, j)] + damping));
            match (i == j, omega == 0.0) {
                (true, true) => own + c64::new(extra[i], 0.0),
                (true, false) => own - c64::new(omega * omega, 0.0),
                (false, _) => own,
            }
        })
    }

    /// Assembles the matrix of some orders.
    fn assembled(&self, blocks: &Blocks, of: &[usize]) -> Mat<c64> {
        let size = self.modes;
        let mut place = vec![None; self.orders.len()];
        for (index, &order) in of.iter().enumerate() {
            place[order] = Some(index);
        }
        let mut matrix = Mat::<c64>::zeros(of.len() * size, of.len() * size);
        for (index, &order) in of.iter().enumerate() {
            let mut block = matrix.as_mut().submatrix_mut(index * size, index * size, size, size);
            block += &blocks.own[order];
        }
        for coupling in &self.all {
            for &(row, of_column) in &coupling.pairs {
                let (Some(row), Some(column)) = (place[row], place[of_column]) else { continue };
                let factor = blocks.factor(coupling, of_column);
                let mut block = matrix.as_mut().submatrix_mut(row * size, column * size, size, size);
                for j in 0..size {
                    for i in 0..size {
                        block[(i, j)] += factor * coupling.coefficient[(i, j)];
                    }
                }
            }
        }
        matrix
    }

    /// Solves the system with the harmonics as preconditioner; `None` without convergence.
    fn iterated(&self, blocks: &Blocks, right: &Mat<c64>) -> Option<Mat<c64>> {
        let size = self.modes;
        let factors: Vec<ComplexLu> =
            self.clusters.iter().map(|cluster| ComplexLu::new(self.assembled(blocks, cluster))).collect();
        let apply = |from: MatRef<'_, c64>, mut to: MatMut<'_, c64>| {
            for (block, own) in blocks.own.iter().enumerate() {
                let part = to.as_mut().submatrix_mut(block * size, 0, size, 1);
                let from = from.submatrix(block * size, 0, size, 1);
                matmul(part, Accum::Replace, own, from, c64::new(1.0, 0.0), Par::Seq);
            }
            self.add_couplings(blocks, from, to);
        };
        let precondition = |from: MatRef<'_, c64>, mut to: MatMut<'_, c64>| {
            for (cluster, factor) in self.clusters.iter().zip(&factors) {
                let gathered = |k: usize, _: usize| from[(cluster[k / size] * size + k % size, 0)];
                let mut part = Mat::from_fn(cluster.len() * size, 1, gathered);
                factor.solve_in_place(part.as_mut());
                for (k, value) in part.col(0).iter().enumerate() {
                    to[(cluster[k / size] * size + k % size, 0)] = *value;
                }
            }
        };
        solve_iteratively(&apply, &precondition, right.as_ref(), (RESIDUAL, ITERATIONS))
    }

    /// Adds the product of the couplings and a column of all orders.
    fn add_couplings(&self, blocks: &Blocks, from: MatRef<'_, c64>, mut to: MatMut<'_, c64>) {
        let (size, count, one) = (self.modes, self.orders.len(), c64::new(1.0, 0.0));
        let acting = self.acting.as_ref();
        let by_order = Mat::from_fn(size, count, |i, block| from[(block * size + i, 0)]);
        let mut moved = Mat::<c64>::zeros(acting.ncols(), count);
        matmul(moved.as_mut(), Accum::Replace, acting.transpose(), &by_order, one, Par::Seq);
        let mut forces = Mat::<c64>::zeros(acting.ncols(), count);
        for coupling in &self.all {
            let Coupling { reduced, pairs, .. } = coupling;
            let gathered = Mat::from_fn(acting.ncols(), pairs.len(), |i, k| {
                moved[(i, pairs[k].1)] * blocks.factor(coupling, pairs[k].1)
            });
            let mut product = Mat::<c64>::zeros(acting.ncols(), pairs.len());
            matmul(product.as_mut(), Accum::Replace, reduced, &gathered, one, Par::Seq);
            for (k, &(row, _)) in pairs.iter().enumerate() {
                for i in 0..acting.ncols() {
                    forces[(i, row)] += product[(i, k)];
                }
            }
        }
        let mut added = Mat::<c64>::zeros(size, count);
        matmul(added.as_mut(), Accum::Replace, acting, &forces, one, Par::Seq);
        for block in 0..count {
            for i in 0..size {
                to[(block * size + i, 0)] += added[(i, block)];
            }
        }
    }
}

/// Returns an orthonormal basis, by column, of the motions on which coefficients act. They are
/// symmetric, so that the eigenvectors of the sum of their squares are such a basis.
fn acting(modes: usize, couplings: &[Coupling]) -> Mat<c64> {
    let mut squares = Mat::<f64>::zeros(modes, modes);
    for Coupling { coefficient, .. } in couplings {
        for part in [|entry: &c64| entry.re, |entry: &c64| entry.im] {
            let part = Mat::from_fn(modes, modes, |i, j| part(&coefficient[(i, j)]));
            squares += &part * part.transpose();
        }
    }
    let everything = || Mat::from_fn(modes, modes, |i, j| c64::new(f64::from(u8::from(i == j)), 0.0));
    let Some((values, vectors)) = symmetric_eigen(squares.as_ref()) else { return everything() };
    let largest = values.last().copied().unwrap_or_default();
    let first = values.partition_point(|value| *value <= ROUNDING * largest);
    Mat::from_fn(modes, modes - first, |i, k| c64::new(vectors[(i, first + k)], 0.0))
}

/// Returns the couplings of orders of the response by the coefficients of a series but its mean.
fn couplings(response: &[i64], series: &Coefficients, is_damping: bool) -> Vec<Coupling> {
    let largest = series.values().map(amplitude).fold(0.0, f64::max);
    let counts = |(order, coefficient): &(&i64, &DMatrix<Complex<f64>>)| {
        **order != 0 && amplitude(coefficient) > NEGLIGIBLE * largest
    };
    let mut all = Vec::new();
    for (&order, coefficient) in series.iter().filter(counts) {
        for signed in [-order, order] {
            let pair = |(row, of_row): (usize, &i64)| {
                response.binary_search(&(of_row - signed)).ok().map(|column| (row, column))
            };
            let pairs: Vec<(usize, usize)> = response.iter().enumerate().filter_map(pair).collect();
            let entry = |i: usize, j: usize| {
                let value = coefficient[(i, j)];
                c64::new(value.re, if signed < 0 { -value.im } else { value.im })
            };
            let coefficient = Mat::from_fn(coefficient.nrows(), coefficient.ncols(), entry);
            if !pairs.is_empty() {
                all.push(Coupling { coefficient, reduced: Mat::new(), pairs, is_damping });
            }
        }
    }
    all
}

/// Returns the largest magnitude of an entry.
fn amplitude(matrix: &DMatrix<Complex<f64>>) -> f64 {
    matrix.iter().map(|entry| entry.norm()).fold(0.0, f64::max)
}
