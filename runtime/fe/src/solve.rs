//! Direct solution of stiffness equations with prescribed displacements, for multiple loads.

use super::dissection::Dissection;
use super::sparse::summed;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::perm::Perm;
use faer::sparse::SparseColMat;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::{Conj, Mat, MatRef, Par, Side};
use std::collections::BTreeMap;

/// A stiffness is singular to working precision if its inverse, relative to its own diagonal, is
/// larger than this: there is a mechanism.
const SINGULAR: f64 = 1e14;

/// Prescribed displacements by degree of freedom.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Constraints {
    values: BTreeMap<usize, f64>,
}

impl Constraints {
    /// Creates an empty set of constraints.
    pub fn new() -> Self {
        Self::default()
    }

    /// Prescribes a degree of freedom; a later value replaces an earlier one.
    pub fn prescribe(&mut self, dof: usize, value: f64) -> &mut Self {
        self.values.insert(dof, value);
        self
    }

    /// Prescribes the x and y displacement of a node, m.
    pub fn prescribe_node(&mut self, node: usize, [x, y]: [f64; 2]) -> &mut Self {
        self.prescribe(2 * node, x).prescribe(2 * node + 1, y)
    }

    /// Fixes a node.
    pub fn fix_node(&mut self, node: usize) -> &mut Self {
        self.prescribe_node(node, [0.0; 2])
    }

    /// Returns the prescribed displacements by degree of freedom, m.
    pub fn values(&self) -> &BTreeMap<usize, f64> {
        &self.values
    }
}

/// Reasons why equations cannot be solved.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs, reason = "each says itself in its message")]
pub enum SolveError {
    #[error("the stiffness is singular: the constraints leave a motion free, or an element has no stiffness")]
    Singular,
    #[error("not enough memory for the decomposition of {unknowns} unknowns")]
    Memory { unknowns: usize },
}

/// Factorized stiffness with its constraints.
#[derive(Debug)]
pub struct Solver {
    dof_count: usize,
    /// Unconstrained degrees of freedom, ascending.
    free: Vec<usize>,
    constraints: Constraints,
    /// Loads from prescribed displacements: `(unknown, value)`.
    reactions: Vec<(usize, f64)>,
    symbolic: SymbolicCholesky<usize>,
    factor: Vec<f64>,
}

impl Solver {
    /// Factorizes the stiffness (symmetric, both triangles) of the unconstrained degrees of
    /// freedom. The factorization is sequential: independent bodies are factorized in parallel.
    ///
    /// # Errors
    /// The constraints leave a rigid-body motion, or memory is insufficient.
    pub fn new(stiffness: &SparseColMat<usize, f64>, constraints: Constraints) -> Result<Self, SolveError> {
        Self::in_order(stiffness, constraints, None)
    }

    /// Factorizes as [`Solver::new`], in the order of a [`Dissection`] of the mesh by the positions
    /// of its nodes, m. For three-dimensional meshes the factor is smaller than with minimum
    /// degree.
    ///
    /// # Errors
    /// As for [`Solver::new`].
    pub fn dissected(
        stiffness: &SparseColMat<usize, f64>,
        positions: &[[f64; 3]],
        constraints: Constraints,
    ) -> Result<Self, SolveError> {
        let constrained: Vec<usize> = constraints.values.keys().copied().collect();
        let dissection = Dissection::new(stiffness, positions, &constrained, &[]);
        // Unknowns are the free degrees of freedom, ascending.
        let places: Vec<usize> = dissection.order.into_iter().flatten().collect();
        Self::in_order(stiffness, constraints, Some(places))
    }

    /// Factorizes in the order of elimination `places`, the position of each unknown; `None`
    /// selects minimum degree.
    fn in_order(
        stiffness: &SparseColMat<usize, f64>,
        constraints: Constraints,
        places: Option<Vec<usize>>,
    ) -> Result<Self, SolveError> {
        let dof_count = stiffness.ncols();
        let free = (0..dof_count).filter(|dof| !constraints.values.contains_key(dof)).collect::<Vec<_>>();
        let mut unknown = vec![None; dof_count];
        for (index, &dof) in free.iter().enumerate() {
            unknown[dof] = Some(index);
        }
        let (mut entries, mut reactions, mut largest) = (Vec::new(), Vec::new(), 0.0_f64);
        for entry in stiffness.triplet_iter() {
            match (unknown[entry.row], unknown[entry.col]) {
                (Some(row), Some(column)) => {
                    entries.push((column, row, *entry.val));
                    largest = largest.max(entry.val.abs());
                }
                (Some(row), None) => reactions.push((row, entry.val * constraints.values[&entry.col])),
                (None, _) => {}
            }
        }
        let reduced = summed(free.len(), entries);
        let memory = || SolveError::Memory { unknowns: free.len() };

        let order = places.map(|places| {
            let mut unknowns = vec![0; places.len()];
            places.iter().enumerate().for_each(|(unknown, &place)| unknowns[place] = unknown);
            Perm::new_checked(unknowns.into(), places.into(), free.len())
        });
        let symbolic = factorize_symbolic_cholesky(
            reduced.symbolic(),
            Side::Lower,
            order.as_ref().map_or(SymmetricOrdering::Amd, |order| SymmetricOrdering::Custom(order.as_ref())),
            CholeskySymbolicParams::default(),
        )
        .map_err(|_| memory())?;
        let mut factor = vec![0.0; symbolic.len_val()];
        let scratch = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut scratch = MemBuffer::try_new(scratch).map_err(|_| memory())?;
        symbolic
            .factorize_numeric_llt(
                &mut factor,
                reduced.as_ref(),
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut scratch),
                Default::default(),
            )
            .map_err(|_| SolveError::Singular)?;
        let solver = Self { dof_count, free, constraints, reactions, symbolic, factor };
        solver.check_regular(largest)?;
        Ok(solver)
    }

    /// Detects singularity: rounding can make the pivots of a free motion positive, but then a
    /// pseudorandom load causes a very large displacement.
    fn check_regular(&self, largest: f64) -> Result<(), SolveError> {
        let mut load =
            Mat::from_fn(self.free.len(), 1, |row, _| ((row as f64 + 1.0) * 0.618_033_988_75).fract() - 0.5);
        self.solve_unknowns(&mut load)?;
        let moved = load.col(0).iter().map(|value| value.abs()).fold(0.0, f64::max);
        // The comparison is negated so that NaN fails it.
        let regular = moved * largest <= SINGULAR || self.free.is_empty();
        if regular { Ok(()) } else { Err(SolveError::Singular) }
    }

    fn solve_unknowns(&self, loads: &mut Mat<f64>) -> Result<(), SolveError> {
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(loads.ncols(), Par::Seq);
        let mut scratch =
            MemBuffer::try_new(scratch).map_err(|_| SolveError::Memory { unknowns: self.free.len() })?;
        LltRef::new(&self.symbolic, &self.factor).solve_in_place_with_conj(
            Conj::No,
            loads.as_mut(),
            Par::Seq,
            MemStack::new(&mut scratch),
        );
        Ok(())
    }

    /// Returns the displacements of all degrees of freedom for the loads in the columns (one row
    /// for each degree of freedom). The prescribed displacements act in every column.
    ///
    /// # Errors
    /// Memory is insufficient.
    pub fn solve(&self, loads: MatRef<'_, f64>) -> Result<Mat<f64>, SolveError> {
        let mut unknowns =
            Mat::from_fn(self.free.len(), loads.ncols(), |row, column| loads[(self.free[row], column)]);
        for column in 0..loads.ncols() {
            for &(row, reaction) in &self.reactions {
                unknowns[(row, column)] -= reaction;
            }
        }
        self.solve_unknowns(&mut unknowns)?;
        let mut displacements = Mat::zeros(self.dof_count, loads.ncols());
        for column in 0..loads.ncols() {
            for (row, &dof) in self.free.iter().enumerate() {
                displacements[(dof, column)] = unknowns[(row, column)];
            }
            for (&dof, &value) in &self.constraints.values {
                displacements[(dof, column)] = value;
            }
        }
        Ok(displacements)
    }

    /// Solves as [`Solver::solve`], for one load.
    ///
    /// # Errors
    /// Memory is insufficient.
    pub fn solve_one(&self, load: &[f64]) -> Result<Vec<f64>, SolveError> {
        let displacements = self.solve(MatRef::from_column_major_slice(load, self.dof_count, 1))?;
        Ok(displacements.col(0).iter().copied().collect())
    }
}
