//! Lowest natural frequencies and mode shapes, none missed.
//!
//! A block Krylov space of the shift-inverted pencil with full orthogonalization (Grimes, Lewis and
//! Simon, SIAM J. Matrix Anal. Appl. 15, 1994) gives the lowest modes. The inertia of a second
//! factorization counts the eigenvalues below the highest one (Sturm count); the iteration
//! continues with new start vectors until it has found that number. Linear forms of the
//! displacements can be constrained to zero by Lagrange multipliers, without dense coupling. See
//! `docs/theory/elastic-bodies.md`.

use crate::assembly::{System, dot, multiply};
use crate::check::{mechanism_within, parts};
use crate::error::ElasticError;
use crate::factor::{Factor, Pencil};
use crate::resources::Resources;
use calyx_fe::sparse::SparseVector;
use calyx_numerics::dense::{Interruptible, mirror_lower, symmetric_eigen};
use calyx_numerics::interrupt::MemoryReservation;
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::sparse::SparseColMat;
use faer::{Mat, MatMut, MatRef};

/// Residual of a converged eigenpair of the inverted pencil, relative to the eigenvalue.
const TOLERANCE: f64 = 1e-10;
/// Pivot ratio below which a Sturm count is repeated with another shift.
const UNSAFE_PIVOT: f64 = 1e-10;
/// Share of a vector's norm that remains if it depends on others.
const DEPENDENT: f64 = 1e-10;

/// Requested modes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Request {
    /// The given number of lowest modes, rigid-body motions included.
    Count(usize),
    /// All modes up to a frequency, Hz.
    Below(f64),
}

/// Eigenvalue problem `K x = lambda M x` with `G x = 0`.
#[derive(Clone, Copy)]
pub struct Problem<'a> {
    /// Stiffness K.
    pub stiffness: &'a SparseColMat<usize, f64>,
    /// Mass M, with the pattern of the stiffness.
    pub mass: &'a SparseColMat<usize, f64>,
    /// Positions of the nodes, m.
    pub positions: &'a [[f64; 3]],
    /// Degrees of freedom without motion.
    pub constrained: &'a [usize],
    /// Forms of the displacements that vanish, G.
    pub forms: &'a [SparseVector],
    /// True if the stiffness without the forms is singular: the body can move freely.
    pub is_free: bool,
}

/// Natural modes.
#[derive(Clone, Debug)]
pub struct Modes {
    /// Squared angular frequencies, (rad/s)^2, ascending.
    pub eigenvalues: Vec<f64>,
    /// Mass-normalized mode shapes, one per column, over all degrees of freedom; those of dependent
    /// components are zero.
    pub shapes: Mat<f64>,
}

impl Modes {
    /// Returns an empty list of modes.
    pub(crate) fn none(problem: &Problem<'_>) -> Self {
        Self { eigenvalues: Vec::new(), shapes: Mat::zeros(problem.stiffness.ncols(), 0) }
    }

    /// Returns the natural frequencies, Hz; zero for rigid-body motions.
    pub fn frequencies(&self) -> Vec<f64> {
        self.eigenvalues.iter().map(|value| value.max(0.0).sqrt() / std::f64::consts::TAU).collect()
    }
}

/// Computes the requested modes of a body; `mass` is that of the system.
///
/// # Errors
/// As for [`solve`].
pub fn natural_modes(
    system: &System<'_>,
    mass: &SparseColMat<usize, f64>,
    request: Request,
    resources: &Resources,
) -> Result<Modes, ElasticError> {
    let constrained = system.constrained();
    let problem = Problem {
        stiffness: &system.stiffness,
        mass,
        positions: &system.positions,
        constrained: &constrained,
        forms: &[],
        is_free: parts(system).iter().any(|part| !part.free_motions.is_empty()),
    };
    solve(&problem, request, |dofs| mechanism_within(system, dofs), resources)
}

/// Inverse of `K - shift M` under the constraints.
pub(crate) struct Operator {
    pub(crate) factor: Factor,
    /// Responses to the forms, one per column.
    responses: Mat<f64>,
    /// Forms of the responses.
    schur: Option<PartialPivLu<f64>>,
    /// Number of negative eigenvalues of the forms' responses.
    negative_forms: usize,
}

impl Operator {
    pub(crate) fn new(
        problem: &Problem<'_>,
        shift: f64,
        resources: &Resources,
    ) -> Result<Self, ElasticError> {
        let shifted = (shift != 0.0).then_some((problem.mass, shift));
        let pencil = Pencil { stiffness: problem.stiffness, shifted };
        let factor = Factor::new(pencil, problem.positions, problem.constrained, resources)?;
        let count = problem.forms.len();
        let mut responses = Mat::zeros(problem.stiffness.ncols(), count);
        if count == 0 {
            return Ok(Self { factor, responses, schur: None, negative_forms: 0 });
        }
        for (column, form) in problem.forms.iter().enumerate() {
            form.entries.iter().for_each(|&(dof, value)| responses[(dof, column)] += value);
        }
        factor.solve_in_place(responses.as_mut(), resources)?;
        let mut schur = apply(problem.forms, responses.as_ref());
        mirror_lower(&mut schur);
        let values = symmetric_eigen(schur.as_ref()).map(|(values, _)| values);
        let values = values.ok_or_else(|| ElasticError::Convergence("a factorization failed".into()))?;
        let negative_forms = values.iter().filter(|&&value| value < 0.0).count();
        Ok(Self { factor, responses, schur: Some(schur.partial_piv_lu()), negative_forms })
    }

    /// Solves in place.
    pub(crate) fn solve_in_place(
        &self,
        forms: &[SparseVector],
        mut right: MatMut<'_, f64>,
        resources: &Resources,
    ) -> Result<(), ElasticError> {
        self.factor.solve_in_place(right.as_mut(), resources)?;
        if let Some(schur) = &self.schur {
            let multipliers = schur.solve(apply(forms, right.as_ref()));
            let check = || resources.check();
            Interruptible(&check).add_product(right, -1.0, self.responses.as_ref(), multipliers.as_ref())?;
        }
        Ok(())
    }
}

/// Returns the forms of the columns.
pub(crate) fn apply(forms: &[SparseVector], columns: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(forms.len(), columns.ncols(), |row, column| {
        forms[row].entries.iter().map(|&(dof, value)| value * columns[(dof, column)]).sum()
    })
}

/// Returns the number of eigenvalues below a shift, (rad/s)^2.
///
/// # Errors
/// Memory is insufficient, or the caller ends the computation.
pub fn count_below(problem: &Problem<'_>, shift: f64, resources: &Resources) -> Result<usize, ElasticError> {
    let mut moved = shift;
    for attempt in 1..=4 {
        let operator = Operator::new(problem, moved, resources)?;
        if operator.factor.singular.is_empty() && operator.factor.smallest_pivot > UNSAFE_PIVOT {
            return Ok(operator.factor.negative.saturating_sub(operator.negative_forms));
        }
        moved = shift * (1.0 + 1e-7 * f64::from(attempt).powi(3));
    }
    Err(ElasticError::Convergence(format!(
        "the number of natural frequencies below {:.6e} Hz cannot be counted: the factorization is unstable",
        shift.abs().sqrt() / std::f64::consts::TAU
    )))
}

/// Returns a small negative shift, with which the pencil of a free body is definite.
fn negative_shift(problem: &Problem<'_>, request: Request) -> f64 {
    if let Request::Below(frequency) = request {
        return -1e-2 * (std::f64::consts::TAU * frequency).powi(2);
    }
    let diagonal = |matrix: &SparseColMat<usize, f64>, dof: usize| {
        let mut column = matrix.row_idx_of_col(dof).zip(matrix.val_of_col(dof));
        column.find(|entry| entry.0 == dof).map_or(0.0, |entry| *entry.1)
    };
    let translations = (0..problem.stiffness.ncols()).filter(|dof| dof % 6 < 3);
    let ratio = |dof| (diagonal(problem.stiffness, dof), diagonal(problem.mass, dof));
    let ratios = translations.map(ratio).filter(|(_, mass)| *mass > 0.0);
    let largest = ratios.fold(0.0_f64, |largest, (stiffness, mass)| largest.max(stiffness / mass));
    if largest > 0.0 { -1e-9 * largest } else { -1.0 }
}

/// Computes the requested modes.
///
/// # Errors
/// The body has a mechanism (`mechanism` makes the error from the degrees of freedom), the
/// iteration does not converge, memory is insufficient, or the caller ends the computation.
pub fn solve(
    problem: &Problem<'_>,
    request: Request,
    mechanism: impl Fn(&[usize]) -> ElasticError,
    resources: &Resources,
) -> Result<Modes, ElasticError> {
    let wanted = wanted(problem, request, resources)?;
    if wanted == 0 {
        return Ok(Modes::none(problem));
    }
    let operator = Operator::new(problem, shift(problem, request), resources)?;
    if !operator.factor.singular.is_empty() {
        return Err(mechanism(&operator.factor.singular));
    }
    iterate(problem, &operator, request, wanted, resources)
}

/// Returns the number of requested modes.
pub(crate) fn wanted(
    problem: &Problem<'_>,
    request: Request,
    resources: &Resources,
) -> Result<usize, ElasticError> {
    match request {
        Request::Below(frequency) => {
            count_below(problem, (std::f64::consts::TAU * frequency).powi(2), resources)
        }
        Request::Count(count) => Ok(count),
    }
}

/// Returns the shift with which the pencil is definite.
pub(crate) fn shift(problem: &Problem<'_>, request: Request) -> f64 {
    if problem.is_free { negative_shift(problem, request) } else { 0.0 }
}

/// Computes modes with the inverse at [`shift`]; a [`Request::Below`] has `wanted` of them.
pub(crate) fn iterate(
    problem: &Problem<'_>,
    operator: &Operator,
    request: Request,
    mut wanted: usize,
    resources: &Resources,
) -> Result<Modes, ElasticError> {
    let limit = match request {
        Request::Below(frequency) => Some((std::f64::consts::TAU * frequency).powi(2)),
        Request::Count(_) => None,
    };
    let shift = shift(problem, request);
    let mut space = Space::new(problem, operator, shift, wanted);
    loop {
        space.converge(wanted, resources)?;
        let found = space.eigenvalues.len();
        if space.is_complete || limit.is_some() && space.below(limit.unwrap_or(0.0)) >= wanted {
            break;
        }
        match limit {
            // The count is exact: a mode is missing.
            Some(_) => space.restart(resources)?,
            None => {
                let (expected, between) = space.gap(wanted);
                if expected < found {
                    let count = count_below(problem, between, resources)?;
                    if count <= expected {
                        break;
                    }
                    space.restart(resources)?;
                }
                wanted = wanted.max(expected) + 1;
            }
        }
    }
    let keep = match (request, limit) {
        (Request::Count(count), _) => count.min(space.eigenvalues.len()),
        (_, Some(limit)) => space.below(limit).min(wanted),
        (Request::Below(_), None) => 0,
    };
    space.modes(keep)
}

/// Krylov space of the inverted pencil.
struct Space<'a> {
    problem: Problem<'a>,
    operator: &'a Operator,
    shift: f64,
    /// Unknowns: rows of the basis.
    unknowns: Vec<usize>,
    /// Mass-orthonormal basis; columns beyond `size` are spare.
    basis: Mat<f64>,
    size: usize,
    /// First column of the last block, to which the operator has not been applied.
    open: usize,
    /// Projected operator.
    projected: Mat<f64>,
    block: usize,
    /// State of the generator of start vectors.
    seed: u64,
    /// Shifted eigenvalues of the projection, ascending, with the norms of their residuals.
    eigenvalues: Vec<f64>,
    residuals: Vec<f64>,
    vectors: Mat<f64>,
    /// Least size before convergence is judged.
    least: usize,
    /// True if the basis spans all modes.
    is_complete: bool,
    room: MemoryReservation,
}

impl<'a> Space<'a> {
    fn new(problem: &Problem<'a>, operator: &'a Operator, shift: f64, wanted: usize) -> Self {
        let order = &operator.factor.dissection().order;
        let unknowns: Vec<usize> = (0..order.len()).filter(|&dof| order[dof].is_some()).collect();
        Self {
            problem: *problem,
            operator,
            shift,
            unknowns,
            basis: Mat::new(),
            size: 0,
            open: 0,
            projected: Mat::new(),
            block: wanted.div_ceil(4).clamp(2, 8),
            seed: 0x9e37_79b9_7f4a_7c15,
            eigenvalues: Vec::new(),
            residuals: Vec::new(),
            vectors: Mat::new(),
            least: 0,
            is_complete: false,
            room: MemoryReservation::default(),
        }
    }

    /// Returns the number of eigenvalues below a limit.
    fn below(&self, limit: f64) -> usize {
        self.eigenvalues.iter().zip(&self.residuals).filter(|(value, _)| **value < limit).count()
    }

    /// Returns the number of eigenvalues, at least `wanted`, before a gap, and a value within the
    /// gap.
    fn gap(&self, wanted: usize) -> (usize, f64) {
        let scale = self.shift.abs();
        for count in wanted..self.eigenvalues.len() {
            let (below, above) = (self.eigenvalues[count - 1], self.eigenvalues[count]);
            if above - below > 1e-4 * (above.abs() + scale) {
                return (count, below + 0.1 * (above - below));
            }
        }
        (self.eigenvalues.len(), f64::INFINITY)
    }

    /// Extends the space until the lowest `wanted` eigenpairs have converged.
    fn converge(&mut self, wanted: usize, resources: &Resources) -> Result<(), ElasticError> {
        if self.size == 0 {
            self.restart(resources)?;
        }
        let largest = (8 * wanted + 200).min(self.unknowns.len());
        let mut next = self.size;
        loop {
            if self.size >= next || self.is_complete {
                self.ritz()?;
                let good = |k: usize| k < self.residuals.len() && self.residuals[k] <= TOLERANCE;
                if self.is_complete || self.size >= self.least && (0..wanted).all(good) {
                    return Ok(());
                }
                if self.size > largest {
                    return Err(ElasticError::Convergence(format!(
                        "{wanted} natural frequencies have not converged in {} iterations",
                        self.size / self.block
                    )));
                }
                next = (self.size + self.size / 5).max(self.size + self.block);
            }
            self.extend(resources)?;
        }
    }

    /// Converts the columns from `first` of the basis to full vectors and applies the mass.
    fn masses(&self, vectors: MatRef<'_, f64>) -> Mat<f64> {
        let mut result = Mat::zeros(self.problem.stiffness.ncols(), vectors.ncols());
        for column in 0..vectors.ncols() {
            let mut full = vec![0.0; result.nrows()];
            self.unknowns.iter().enumerate().for_each(|(row, &dof)| full[dof] = vectors[(row, column)]);
            for (dof, value) in multiply(self.problem.mass, &full).into_iter().enumerate() {
                result[(dof, column)] = value;
            }
        }
        result
    }

    fn compact(&self, full: &Mat<f64>) -> Mat<f64> {
        Mat::from_fn(self.unknowns.len(), full.ncols(), |row, column| full[(self.unknowns[row], column)])
    }

    /// Applies the inverted pencil to the vectors.
    fn operate(&self, vectors: MatRef<'_, f64>, resources: &Resources) -> Result<Mat<f64>, ElasticError> {
        let mut full = self.masses(vectors);
        self.operator.solve_in_place(self.problem.forms, full.as_mut(), resources)?;
        Ok(self.compact(&full))
    }

    /// Adds a block of pseudorandom vectors.
    fn restart(&mut self, resources: &Resources) -> Result<(), ElasticError> {
        let mut state = self.seed;
        let start = Mat::from_fn(self.unknowns.len(), self.block, |_, _| {
            // xorshift64 (Marsaglia 2003).
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        });
        self.seed = state;
        let start = self.operate(start.as_ref(), resources)?;
        let before = self.size;
        self.append(start, None, resources)?;
        self.is_complete = self.size == before && self.open == self.size;
        self.least = self.size + 6 * self.block;
        Ok(())
    }

    /// Applies the operator to the open block and appends the result.
    fn extend(&mut self, resources: &Resources) -> Result<(), ElasticError> {
        let open = self.basis.as_ref().subcols(self.open, self.size - self.open).to_owned();
        let first = self.open;
        let before = self.size;
        let next = self.operate(open.as_ref(), resources)?;
        self.open = self.size;
        self.append(next, Some(first), resources)?;
        if self.size == before {
            // The space is invariant: other modes need other start vectors.
            self.restart(resources)?;
        }
        Ok(())
    }

    /// Orthonormalizes vectors and appends them. `image_of` is the first column of the basis whose
    /// images they are.
    fn append(
        &mut self,
        mut vectors: Mat<f64>,
        image_of: Option<usize>,
        resources: &Resources,
    ) -> Result<(), ElasticError> {
        let check = || resources.check();
        let dense = Interruptible(&check);
        let capacity = self.size + vectors.ncols();
        self.reserve(capacity, resources)?;
        let norms = |vectors: MatRef<'_, f64>, masses: &Mat<f64>, unknowns: &[usize]| {
            let norm = |column: usize| {
                let terms = unknowns
                    .iter()
                    .enumerate()
                    .map(|(row, &dof)| vectors[(row, column)] * masses[(dof, column)]);
                terms.sum::<f64>().max(0.0).sqrt()
            };
            (0..vectors.ncols()).map(norm).collect::<Vec<f64>>()
        };
        let mut before = Vec::new();
        for pass in 0..2 {
            let masses = self.masses(vectors.as_ref());
            if pass == 0 {
                before = norms(vectors.as_ref(), &masses, &self.unknowns);
            }
            let masses = self.compact(&masses);
            let basis = self.basis.as_ref().subcols(0, self.size);
            let shares = dense.product(basis.transpose(), masses.as_ref())?;
            dense.add_product(vectors.as_mut(), -1.0, basis, shares.as_ref())?;
            if let Some(first) = image_of {
                for column in 0..vectors.ncols() {
                    for row in 0..self.size {
                        self.projected[(row, first + column)] += shares[(row, column)];
                    }
                }
            }
        }
        let old = self.size;
        for column in 0..vectors.ncols() {
            self.append_one(
                vectors.as_ref().subcols(column, 1),
                before[column],
                old,
                image_of.map(|k| k + column),
            );
        }
        Ok(())
    }

    fn append_one(&mut self, vector: MatRef<'_, f64>, before: f64, old: usize, image_of: Option<usize>) {
        let mut vector: Vec<f64> = vector.col(0).iter().copied().collect();
        let mut norm = 0.0;
        for _ in 0..3 {
            let column = MatRef::from_column_major_slice(&vector, vector.len(), 1);
            let masses = self.compact(&self.masses(column));
            let masses: Vec<f64> = masses.col(0).iter().copied().collect();
            for other in old..self.size {
                let basis = self.basis.col(other);
                let share: f64 = basis.iter().zip(&masses).map(|(a, b)| a * b).sum();
                vector.iter_mut().zip(basis.iter()).for_each(|(value, other)| *value -= share * other);
                if let Some(image) = image_of {
                    self.projected[(other, image)] += share;
                }
            }
            norm = dot(&vector, &masses).max(0.0).sqrt();
        }
        if norm.is_nan() || norm <= DEPENDENT * before {
            return;
        }
        let column = MatRef::from_column_major_slice(&vector, vector.len(), 1);
        let masses = self.compact(&self.masses(column));
        norm = vector
            .iter()
            .enumerate()
            .map(|(row, value)| value * masses[(row, 0)])
            .sum::<f64>()
            .max(0.0)
            .sqrt();
        let mut target = self.basis.col_mut(self.size);
        vector.iter().enumerate().for_each(|(row, value)| target[row] = value / norm);
        if let Some(image) = image_of {
            self.projected[(self.size, image)] += norm;
        }
        self.size += 1;
    }

    fn reserve(&mut self, capacity: usize, resources: &Resources) -> Result<(), ElasticError> {
        if capacity > self.basis.ncols() {
            let columns = (capacity + capacity / 4).max(32);
            let rows = self.unknowns.len();
            let bytes = 8 * columns as u64 * (rows + columns) as u64;
            self.room = resources.reserve("the space of the mode shapes", bytes, rows, 1.0)?;
            self.basis.resize_with(self.unknowns.len(), columns, |_, _| 0.0);
            self.projected.resize_with(columns, columns, |_, _| 0.0);
        }
        Ok(())
    }

    /// Computes the eigenpairs of the projection onto the columns to which the operator was
    /// applied.
    fn ritz(&mut self) -> Result<(), ElasticError> {
        let size = if self.is_complete { self.size } else { self.open };
        let symmetric = Mat::from_fn(size, size, |row, column| {
            0.5 * (self.projected[(row, column)] + self.projected[(column, row)])
        });
        let (values, vectors) = symmetric_eigen(symmetric.as_ref())
            .ok_or_else(|| ElasticError::Convergence("the projected eigenvalue problem failed".into()))?;
        (self.eigenvalues, self.residuals) = (Vec::new(), Vec::new());
        let mut order: Vec<usize> = (0..size).filter(|&k| values[k] != 0.0).collect();
        order.sort_by(|&a, &b| values[b].total_cmp(&values[a]));
        for &k in &order {
            let residual = (size..self.size)
                .map(|row| {
                    (0..size).map(|column| self.projected[(row, column)] * vectors[(column, k)]).sum::<f64>()
                })
                .fold(0.0, |sum, value| sum + value * value)
                .sqrt();
            self.eigenvalues.push(self.shift + 1.0 / values[k]);
            self.residuals.push(residual / values[k].abs());
        }
        self.vectors = Mat::from_fn(size, order.len(), |row, column| vectors[(row, order[column])]);
        Ok(())
    }

    /// Returns the lowest modes, with Rayleigh quotients as eigenvalues.
    fn modes(self, count: usize) -> Result<Modes, ElasticError> {
        let dofs = self.problem.stiffness.ncols();
        let size = self.vectors.nrows();
        let mut found = Vec::with_capacity(count);
        for mode in 0..count {
            let mut full = vec![0.0; dofs];
            for column in 0..size {
                let factor = self.vectors[(column, mode)];
                let basis = self.basis.col(column);
                self.unknowns.iter().enumerate().for_each(|(row, &dof)| full[dof] += factor * basis[row]);
            }
            let modal_mass = dot(&full, &multiply(self.problem.mass, &full));
            // Translations of the largest component point in a positive direction.
            let largest =
                full.iter().fold(
                    0.0_f64,
                    |best, value| if value.abs() > 1.000_001 * best.abs() { *value } else { best },
                );
            let scale = largest.signum() / modal_mass.sqrt();
            full.iter_mut().for_each(|value| *value *= scale);
            let eigenvalue = dot(&full, &multiply(self.problem.stiffness, &full));
            found.push((eigenvalue, full));
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let shapes = Mat::from_fn(dofs, count, |row, column| found[column].1[row]);
        Ok(Modes { eigenvalues: found.into_iter().map(|entry| entry.0).collect(), shapes })
    }
}
