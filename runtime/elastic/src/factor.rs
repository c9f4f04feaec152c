//! Sparse factorization of symmetric matrices, definite or not, with the number of negative pivots.
//!
//! The matrix `K - sigma M` is factorized into `L S L^T` with a lower triangular `L` and signs `S`,
//! by the multifrontal method in the order of a nested dissection ([`Dissection`]). By Sylvester's
//! law of inertia, the number of negative signs is the number of eigenvalues of `K x = lambda M x`
//! below
//! `sigma` (Sturm count). There is no pivoting: a small pivot, relative to its diagonal entry, is
//! reported, and the caller moves the shift. Results do not depend on the number of threads bit for
//! bit.

use crate::error::ElasticError;
use crate::resources::Resources;
use calyx_fe::dissection::{Dissection, Part};
use calyx_numerics::dense::Interruptible;
use calyx_numerics::interrupt::MemoryReservation;
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::sparse::SparseColMat;
use faer::{Accum, Mat, MatMut, MatRef, Par};
use rayon::prelude::*;
use std::sync::OnceLock;

/// A pivot that is a smaller share of its diagonal entry is zero to working precision: there is a
/// mechanism.
const SINGULAR: f64 = 1e-13;
/// Size of a matrix that is factorized column by column.
const COLUMNS: usize = 32;
/// Number of right-hand sides that are solved in one sequential pass; twice as many if there are
/// many.
const TOGETHER: usize = 4;
/// Pivot in place of a zero one: its unknown does not move.
const FIXED: f64 = 1e100;

/// Matrix `K - shift M`; both matrices have the same pattern.
#[derive(Clone, Copy, Debug)]
pub struct Pencil<'a> {
    /// Stiffness K, both triangles.
    pub stiffness: &'a SparseColMat<usize, f64>,
    /// Mass M and shift, (rad/s)^2.
    pub shifted: Option<(&'a SparseColMat<usize, f64>, f64)>,
}

impl<'a> Pencil<'a> {
    /// Creates the pencil of the stiffness alone.
    pub fn stiffness(stiffness: &'a SparseColMat<usize, f64>) -> Self {
        Self { stiffness, shifted: None }
    }

    fn column(&self, column: usize) -> impl Iterator<Item = (usize, f64)> {
        let values = self.stiffness.val_of_col(column);
        let masses = self.shifted.map(|(mass, shift)| (mass.val_of_col(column), shift));
        self.stiffness.row_idx_of_col(column).enumerate().map(move |(index, row)| {
            let value = values[index];
            (row, masses.map_or(value, |(mass, shift)| value - shift * mass[index]))
        })
    }
}

/// Factor columns of one part.
struct PartFactor {
    /// Rows of the pivots, then of the boundary.
    columns: Mat<f64>,
    signs: Vec<f64>,
}

/// Factorized matrix.
pub struct Factor {
    dissection: Dissection,
    parts: Vec<PartFactor>,
    /// Degrees of freedom whose pivots are zero to working precision.
    pub singular: Vec<usize>,
    /// Number of negative pivots.
    pub negative: usize,
    /// Smallest ratio of a pivot to its diagonal entry.
    pub smallest_pivot: f64,
    _room: MemoryReservation,
}

/// Matrix that a part passes to the one above it; its rows are the part's boundary.
struct Work<'a, C> {
    pencil: Pencil<'a>,
    dissection: &'a Dissection,
    slots: &'a [OnceLock<(PartFactor, Vec<usize>, f64)>],
    checkpoint: C,
}

/// Returns the largest memory of a factorization, bytes, and the number of entries of the factor.
pub fn memory(dissection: &Dissection) -> (u64, u64) {
    let mut peaks: Vec<u64> = Vec::with_capacity(dissection.parts.len());
    let left = |part: &Part| (part.boundary.len() * part.boundary.len()) as u64;
    let mut entries = 0;
    for part in &dissection.parts {
        let own = (part.pivots.len() * (part.pivots.len() + part.boundary.len())) as u64;
        let below_peak: u64 = part.below.iter().map(|&below| peaks[below]).sum();
        let below_left: u64 = part.below.iter().map(|&below| left(&dissection.parts[below])).sum();
        // Both parts below can be in work at the same time; a copy of the scaled columns is
        // transient.
        peaks.push(below_peak.max(below_left + left(part) + own));
        entries += own;
    }
    let peak = peaks.last().copied().unwrap_or(0);
    (8 * (entries + peak), entries)
}

impl Factor {
    /// Factorizes the matrix without the `constrained` degrees of freedom. The nodes have six
    /// degrees of freedom each, at `positions`.
    ///
    /// # Errors
    /// Memory is insufficient, or the caller ends the computation.
    pub fn new(
        pencil: Pencil<'_>,
        positions: &[[f64; 3]],
        constrained: &[usize],
        resources: &Resources,
    ) -> Result<Self, ElasticError> {
        let checkpoint = || resources.check();
        let dissection = Dissection::new_until(pencil.stiffness, positions, constrained, &[], &checkpoint)?;
        Self::with_order(pencil, dissection, resources)
    }

    /// Factorizes the matrix in a given order.
    ///
    /// # Errors
    /// As for [`Factor::new`].
    pub fn with_order(
        pencil: Pencil<'_>,
        dissection: Dissection,
        resources: &Resources,
    ) -> Result<Self, ElasticError> {
        let unknowns = dissection.order.iter().flatten().count();
        let (bytes, _) = memory(&dissection);
        let room = resources.reserve("the factorization", bytes, unknowns, 4.0 / 3.0)?;
        let slots: Vec<OnceLock<_>> = dissection.parts.iter().map(|_| OnceLock::new()).collect();
        let work = Work { pencil, dissection: &dissection, slots: &slots, checkpoint: || resources.check() };
        if let Some(top) = dissection.parts.last() {
            for &part in &top.below {
                work.part(part)?;
            }
        }
        let (mut parts, mut singular, mut smallest_pivot) = (Vec::new(), Vec::new(), f64::INFINITY);
        for slot in slots {
            let empty = || (PartFactor { columns: Mat::new(), signs: Vec::new() }, Vec::new(), f64::INFINITY);
            let (part, zero, smallest) = slot.into_inner().unwrap_or_else(empty);
            parts.push(part);
            singular.extend(zero);
            smallest_pivot = smallest_pivot.min(smallest);
        }
        let signs = parts.iter().flat_map(|part| &part.signs);
        let negative = signs.filter(|&&sign| sign < 0.0).count();
        Ok(Self { dissection, parts, singular, negative, smallest_pivot, _room: room })
    }

    /// Returns the order of elimination.
    pub fn dissection(&self) -> &Dissection {
        &self.dissection
    }

    /// Returns the number of entries of the factor.
    pub fn entry_count(&self) -> u64 {
        memory(&self.dissection).1
    }

    /// Solves for the right-hand sides in the columns, in place; rows are all degrees of freedom,
    /// and those that are not unknowns become zero.
    ///
    /// # Errors
    /// The caller ends the computation.
    pub fn solve_in_place(
        &self,
        mut right: MatMut<'_, f64>,
        resources: &Resources,
    ) -> Result<(), ElasticError> {
        resources.check()?;
        for column in 0..right.ncols() {
            for (dof, order) in self.dissection.order.iter().enumerate() {
                if order.is_none() {
                    right[(dof, column)] = 0.0;
                }
            }
        }
        let together = if right.ncols() < 4 * TOGETHER { TOGETHER } else { 2 * TOGETHER };
        right.par_col_chunks_mut(together).try_for_each(|mut right| {
            resources.check()?;
            self.solve_chunk(right.as_mut());
            Ok(())
        })
    }

    fn solve_chunk(&self, mut right: MatMut<'_, f64>) {
        let count = right.ncols();
        let gather = |right: &MatMut<'_, f64>, dofs: &[usize]| {
            Mat::from_fn(dofs.len(), count, |row, column| right[(dofs[row], column)])
        };
        let split = |part: &PartFactor| part.signs.len();
        for (part, factor) in self.dissection.parts.iter().zip(&self.parts) {
            if part.pivots.is_empty() {
                continue;
            }
            let (pivots, lower) = factor.columns.as_ref().split_at_row(split(factor));
            let mut own = gather(&right, &part.pivots);
            solve_lower_triangular_in_place(pivots, own.as_mut(), Par::Seq);
            let mut onto = Mat::zeros(part.boundary.len(), count);
            matmul(onto.as_mut(), Accum::Replace, lower, own.as_ref(), -1.0, Par::Seq);
            for column in 0..count {
                for (row, &dof) in part.pivots.iter().enumerate() {
                    right[(dof, column)] = factor.signs[row] * own[(row, column)];
                }
                for (row, &dof) in part.boundary.iter().enumerate() {
                    right[(dof, column)] += onto[(row, column)];
                }
            }
        }
        for (part, factor) in self.dissection.parts.iter().zip(&self.parts).rev() {
            if part.pivots.is_empty() {
                continue;
            }
            let (pivots, lower) = factor.columns.as_ref().split_at_row(split(factor));
            let mut own = gather(&right, &part.pivots);
            let above = gather(&right, &part.boundary);
            matmul(own.as_mut(), Accum::Add, lower.transpose(), above.as_ref(), -1.0, Par::Seq);
            solve_upper_triangular_in_place(pivots.transpose(), own.as_mut(), Par::Seq);
            for column in 0..count {
                for (row, &dof) in part.pivots.iter().enumerate() {
                    right[(dof, column)] = own[(row, column)];
                }
            }
        }
    }
}

impl<C: Fn() -> Result<(), ElasticError> + Sync> Work<'_, C> {
    /// Factorizes a part and all below it, and returns its update matrix over its boundary.
    fn part(&self, number: usize) -> Result<Mat<f64>, ElasticError> {
        let part = &self.dissection.parts[number];
        let below = match *part.below.as_slice() {
            [] => Vec::new(),
            [only] => vec![(only, self.part(only)?)],
            [first, second, ..] => {
                let (one, other) = rayon::join(|| self.part(first), || self.part(second));
                vec![(first, one?), (second, other?)]
            }
        };
        (self.checkpoint)()?;
        self.front(number, below)
    }

    fn front(&self, number: usize, below: Vec<(usize, Mat<f64>)>) -> Result<Mat<f64>, ElasticError> {
        let part = &self.dissection.parts[number];
        let (count, rest) = (part.pivots.len(), part.boundary.len());
        let slot = |dof: usize| self.dissection.order[dof].unwrap_or(usize::MAX);
        let first = part.pivots.first().map_or(0, |&dof| slot(dof));
        let slots: Vec<usize> = part.boundary.iter().map(|&dof| slot(dof)).collect();
        let mut columns = Mat::<f64>::zeros(count + rest, count);
        let mut square = Mat::<f64>::zeros(rest, rest);
        let mut own = Vec::with_capacity(count);
        for (column, &dof) in part.pivots.iter().enumerate() {
            for (row, value) in self.pencil.column(dof) {
                let Some(slot) = self.dissection.order[row].filter(|&slot| slot >= first + column) else {
                    continue;
                };
                let place = if slot < first + count {
                    slot - first
                } else {
                    count + slots.partition_point(|&other| other < slot)
                };
                columns[(place, column)] += value;
            }
            own.push(columns[(column, column)].abs());
        }
        for (from, update) in below {
            let mut next = 0;
            let mut places = Vec::with_capacity(update.nrows());
            for &dof in &self.dissection.parts[from].boundary {
                let slot = slot(dof);
                if slot < first + count {
                    places.push(slot - first);
                } else {
                    next += slots[next..].partition_point(|&other| other < slot);
                    places.push(count + next);
                }
            }
            for (from, &place) in places.iter().enumerate() {
                let values = update.col(from);
                let (mut target, offset) = if place < count {
                    (columns.col_mut(place), 0)
                } else {
                    (square.col_mut(place - count), count)
                };
                for (row, &to) in places.iter().enumerate().skip(from) {
                    target[to - offset] += values[row];
                }
            }
        }
        let dense = Interruptible(&self.checkpoint);
        let mut state = Signed { own, signs: vec![1.0; count], zero: Vec::new(), smallest: f64::INFINITY };
        let (mut pivots, mut lower) = columns.as_mut().split_at_row_mut(count);
        state.factorize(dense, pivots.as_mut(), 0)?;
        state.divide(dense, lower.as_mut(), pivots.as_ref(), 0)?;
        let scaled = state.scaled(lower.as_ref(), 0);
        dense.add_product_lower(square.as_mut(), -1.0, lower.as_ref(), scaled.as_ref().transpose())?;
        let zero = state.zero.iter().map(|&pivot| part.pivots[pivot]).collect();
        let factor = PartFactor { columns, signs: state.signs };
        // Each part is factorized once.
        let _ = self.slots[number].set((factor, zero, state.smallest));
        Ok(square)
    }
}

/// State of a dense factorization `L S L^T`.
struct Signed {
    /// Diagonal entries of the matrix, absolute.
    own: Vec<f64>,
    signs: Vec<f64>,
    zero: Vec<usize>,
    smallest: f64,
}

impl Signed {
    /// Factorizes in place of the lower triangle; `first` is the index of the first column.
    fn factorize<C: Fn() -> Result<(), ElasticError> + Sync>(
        &mut self,
        dense: Interruptible<'_, C>,
        matrix: MatMut<'_, f64>,
        first: usize,
    ) -> Result<(), ElasticError> {
        let size = matrix.nrows();
        if size <= COLUMNS {
            self.by_columns(matrix, first);
            return Ok(());
        }
        let cut = (size / 2).next_multiple_of(16);
        let (mut one, _, mut between, mut last) = matrix.split_at_mut(cut, cut);
        self.factorize(dense, one.as_mut(), first)?;
        self.divide(dense, between.as_mut(), one.as_ref(), first)?;
        let scaled = self.scaled(between.as_ref(), first);
        dense.add_product_lower(last.as_mut(), -1.0, between.as_ref(), scaled.as_ref().transpose())?;
        self.factorize(dense, last, first + cut)
    }

    fn by_columns(&mut self, mut matrix: MatMut<'_, f64>, first: usize) {
        let size = matrix.nrows();
        for k in 0..size {
            let pivot = matrix[(k, k)];
            let own = self.own[first + k];
            let ratio = pivot.abs() / own;
            if ratio.is_nan() || ratio <= SINGULAR {
                self.zero.push(first + k);
                matrix[(k, k)] = FIXED;
            } else {
                self.smallest = self.smallest.min(ratio);
                matrix[(k, k)] = pivot.abs().sqrt();
                self.signs[first + k] = pivot.signum();
            }
            let (root, sign) = (matrix[(k, k)], self.signs[first + k]);
            for row in k + 1..size {
                matrix[(row, k)] *= sign / root;
            }
            for column in k + 1..size {
                let factor = sign * matrix[(column, k)];
                for row in column..size {
                    let value = matrix[(row, k)] * factor;
                    matrix[(row, column)] -= value;
                }
            }
        }
    }

    /// Computes `B L^-T S` in place of `B`.
    fn divide<C: Fn() -> Result<(), ElasticError> + Sync>(
        &self,
        dense: Interruptible<'_, C>,
        mut right: MatMut<'_, f64>,
        lower: MatRef<'_, f64>,
        first: usize,
    ) -> Result<(), ElasticError> {
        dense.divide_by_cholesky_factor(right.as_mut(), lower)?;
        for column in (0..right.ncols()).filter(|&column| self.signs[first + column] < 0.0) {
            right.as_mut().col_mut(column).iter_mut().for_each(|value| *value = -*value);
        }
        Ok(())
    }

    /// Returns a copy with the columns multiplied by their signs.
    fn scaled(&self, matrix: MatRef<'_, f64>, first: usize) -> Mat<f64> {
        Mat::from_fn(matrix.nrows(), matrix.ncols(), |row, column| {
            self.signs[first + column] * matrix[(row, column)]
        })
    }
}
