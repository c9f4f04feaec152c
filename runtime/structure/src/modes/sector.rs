//! Equations of one sector of a ring at a shift: `K - sigma M`, with the interior eliminated.
//!
//! The interior of a sector does not depend on the number of nodal diameters: it is factorized once
//! for all of them. The Schur complement on the cuts is small and real; with the phase condition of
//! a number of nodal diameters it becomes a small Hermitian matrix ([`super::harmonic`]). By
//! Sylvester's law of inertia both parts together have as many negative eigenvalues as the whole
//! matrix. This gives the number of modes below a frequency.

use super::super::StructureError;
use super::super::condense::{Cuts, turn};
use super::super::ring::SharedUnknowns;
use calyx_fe::sparse::summed;
use calyx_fe::{SolveError, SparseVector};
use calyx_numerics::dense::{add_product, product};
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SparseColMat;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLdltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::{Conj, Mat, Par, Side};

/// Largest accepted backward error of a factorization: residual of a load, relative to the terms
/// that it is summed from.
const BACKWARD_ERROR: f64 = 1e-11;

/// Sector of a ring, or a body of a single mesh as a ring of one sector without cuts.
pub(in super::super) struct Sector {
    /// Stiffness, N/m per metre of face width, and mass, kg/m.
    pub stiffness: SparseColMat<usize, f64>,
    pub mass: SparseColMat<usize, f64>,
    /// Positions of the displacement nodes, m.
    pub nodes: Vec<[f64; 2]>,
    /// Number of sectors around the ring.
    pub count: u32,
    /// Degrees of freedom of the first cut, and the corresponding ones of the last cut; by node, x
    /// before y.
    pub cuts: [Vec<usize>; 2],
    /// Rotation of the last cut, rad.
    pub angle: f64,
    /// Linear forms, in the frame of each sector, whose sums around the ring vanish.
    pub forms: Vec<SparseVector>,
    /// Rotation of the forms from sector to sector.
    pub shared: SharedUnknowns,
    /// Degrees of freedom that are neither constrained nor on a cut.
    pub inner: Vec<usize>,
}

impl Sector {
    /// Builds a sector. `constrained` are constrained degrees of freedom; `cuts` contain none of
    /// them.
    pub fn new(
        (stiffness, mass): (SparseColMat<usize, f64>, SparseColMat<usize, f64>),
        nodes: Vec<[f64; 2]>,
        constrained: &[usize],
        count: u32,
        cuts: Option<&Cuts>,
    ) -> Self {
        let of_nodes =
            |nodes: &Vec<usize>| nodes.iter().flat_map(|node| [2 * node, 2 * node + 1]).collect::<Vec<_>>();
        // The mass matrix does not couple x and y: half of the stored entries are zero.
        let present = mass.triplet_iter().filter(|entry| *entry.val != 0.0);
        let mass = summed(mass.ncols(), present.map(|entry| (entry.col, entry.row, *entry.val)).collect());
        let angle = cuts.map_or(0.0, |cuts| cuts.angle);
        let cuts = cuts.map_or_else(Default::default, |cuts| [&cuts.first, &cuts.last].map(of_nodes));
        let mut is_inner = vec![true; stiffness.ncols()];
        constrained.iter().chain(cuts.iter().flatten()).for_each(|&dof| is_inner[dof] = false);
        let inner = (0..stiffness.ncols()).filter(|&dof| is_inner[dof]).collect();
        let (forms, shared) = (Vec::new(), SharedUnknowns::default());
        Self { stiffness, mass, nodes, count, cuts, angle, forms, shared, inner }
    }

    /// Adds mean constraints.
    pub fn with_mean_constraints(self, forms: Vec<SparseVector>, shared: SharedUnknowns) -> Self {
        Self { forms, shared, ..self }
    }

    /// Returns the degrees of freedom of the mesh, including constrained ones.
    pub fn dofs(&self) -> usize {
        self.stiffness.ncols()
    }
}

/// Sector factorized at a shift.
pub(super) struct Shifted<'s> {
    pub sector: &'s Sector,
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
    /// Number of negative eigenvalues of the interior.
    pub negative: usize,
    /// Interior displacements by displacements of the first and of the last cut, both in the frame
    /// of the sector.
    pub follows: Mat<f64>,
    /// Forces on the cuts by their displacements; both are in the frame rotated by a pitch for the
    /// last cut.
    pub closed: Mat<f64>,
    /// Memory reservations.
    _rooms: [MemoryReservation; 2],
}

impl<'s> Shifted<'s> {
    /// Returns `None` if the shift is too close to a natural frequency of the sector with fixed
    /// cuts.
    pub fn new(
        sector: &'s Sector,
        shift: f64,
        interrupt: &Interrupt,
    ) -> Result<Option<Self>, StructureError> {
        let room = |bytes: usize| interrupt.reserve_memory(bytes as u64).map_err(StructureError::Interrupted);
        let (count, cut) = (sector.inner.len(), 2 * sector.cuts[0].len());
        let mut place = vec![None; sector.dofs()];
        sector.inner.iter().enumerate().for_each(|(index, &dof)| place[dof] = Some(index));
        let mut on_cut = vec![None; sector.dofs()];
        sector.cuts.iter().flatten().enumerate().for_each(|(index, &dof)| on_cut[dof] = Some(index));
        let of_cuts = room(3 * count * cut * size_of::<f64>())?;
        let mut entries = Vec::new();
        let (mut coupling, mut closed) = (Mat::zeros(count, cut), Mat::zeros(cut, cut));
        for (matrix, factor) in [(&sector.stiffness, 1.0), (&sector.mass, -shift)] {
            for entry in matrix.triplet_iter() {
                let value = factor * *entry.val;
                match (place[entry.row], place[entry.col], on_cut[entry.row], on_cut[entry.col]) {
                    (Some(row), Some(column), ..) => entries.push((column, row, value)),
                    (Some(row), _, _, Some(column)) => coupling[(row, column)] += value,
                    (_, _, Some(row), Some(column)) => closed[(row, column)] += value,
                    _ => {}
                }
            }
        }
        let inside = summed(count, entries);
        let memory = || StructureError::Solve(SolveError::Memory { unknowns: count });
        let params = CholeskySymbolicParams::default();
        let symbolic =
            factorize_symbolic_cholesky(inside.symbolic(), Side::Lower, SymmetricOrdering::Amd, params)
                .map_err(|_| memory())?;
        let of_values = room((symbolic.len_val() + inside.compute_nnz()) * 2 * size_of::<f64>())?;
        let mut values = vec![0.0; symbolic.len_val()];
        let scratch = symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Default::default());
        let mut scratch = MemBuffer::try_new(scratch).map_err(|_| memory())?;
        let stack = MemStack::new(&mut scratch);
        let regularization = Default::default();
        let decomposed = symbolic.factorize_numeric_ldlt(
            &mut values,
            inside.as_ref(),
            Side::Lower,
            regularization,
            Par::Seq,
            stack,
            Default::default(),
        );
        if decomposed.is_err() {
            return Ok(None);
        }
        let negative = negative_pivots(&symbolic, &values);
        let mut shifted = Self {
            sector,
            symbolic,
            values,
            negative,
            follows: Mat::zeros(0, 0),
            closed,
            _rooms: [of_cuts, of_values],
        };
        if !shifted.is_reliable(&inside) {
            return Ok(None);
        }
        interrupt.check().map_err(StructureError::Interrupted)?;
        shifted.follows = shifted.inside(coupling.clone());
        shifted.follows *= -1.0;
        add_product(shifted.closed.as_mut(), 1.0, coupling.transpose(), shifted.follows.as_ref());
        for _ in 0..2 {
            turn(&mut shifted.closed, cut / 2..cut, 2, sector.angle);
            shifted.closed = shifted.closed.transpose().to_owned();
        }
        turn(&mut shifted.follows, cut / 2..cut, 2, sector.angle);
        Ok(Some(shifted))
    }

    /// Returns true if the residual of a pseudorandom load is of the order of rounding.
    fn is_reliable(&self, inside: &SparseColMat<usize, f64>) -> bool {
        let load = scattered(inside.ncols(), 1);
        let answer = self.inside(load.clone());
        let (mut left, mut size) =
            (load.clone(), Mat::from_fn(load.nrows(), 1, |row, _| load[(row, 0)].abs()));
        for entry in inside.triplet_iter() {
            let part = *entry.val * answer[(entry.col, 0)];
            left[(entry.row, 0)] -= part;
            size[(entry.row, 0)] += part.abs();
        }
        let largest = size.col(0).iter().copied().fold(0.0, f64::max);
        let worst = left.col(0).iter().map(|value| value.abs()).fold(0.0, f64::max);
        // NaN fails the test.
        worst <= BACKWARD_ERROR * largest && largest.is_finite()
    }

    /// Returns the interior displacements under interior forces, with the cuts fixed.
    pub fn inside(&self, mut forces: Mat<f64>) -> Mat<f64> {
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(forces.ncols(), Par::Seq);
        let mut scratch = MemBuffer::new(scratch);
        LdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            forces.as_mut(),
            Par::Seq,
            MemStack::new(&mut scratch),
        );
        forces
    }

    /// Returns the equivalent forces on the fixed cuts of interior forces.
    pub fn on_cuts(&self, forces: &Mat<f64>) -> Mat<f64> {
        product(self.follows.transpose(), forces.as_ref())
    }
}

/// Counts the negative pivots of a factorization.
fn negative_pivots(symbolic: &SymbolicCholesky<usize>, values: &[f64]) -> usize {
    match symbolic.raw() {
        // Each column begins with its pivot.
        SymbolicCholeskyRaw::Simplicial(symbolic) => {
            let starts = symbolic.col_ptr();
            starts[..starts.len() - 1].iter().filter(|&&start| values[start] < 0.0).count()
        }
        SymbolicCholeskyRaw::Supernodal(symbolic) => {
            let factor = SupernodalLdltRef::new(symbolic, values);
            let of_block = |block: usize| {
                let block = factor.supernode(block).val();
                (0..block.ncols()).filter(|&pivot| block[(pivot, pivot)] < 0.0).count()
            };
            (0..symbolic.n_supernodes()).map(of_block).sum()
        }
    }
}

/// Returns deterministic pseudorandom numbers.
pub(super) fn scattered(rows: usize, columns: usize) -> Mat<f64> {
    Mat::from_fn(rows, columns, |row, column| {
        let place =
            (row as f64 + 1.0) * 0.618_033_988_749_895 + (column as f64 + 1.0) * 0.754_877_666_246_693;
        // The second pass decorrelates neighbours.
        ((place.fract() + 1.0).powi(3) * 1e3).fract() - 0.5
    })
}
