//! Ring of equal sectors as a chain of substructures, condensed onto the cuts between them (report
//! section 2.6).
//!
//! A sector is condensed onto its two cuts: the Schur complement (stiffness) of the cut degrees of
//! freedom, and an equivalent load on the cuts for every load inside the sector. Displacements of a
//! cut are expressed in the frame of the sector that it is the *first* cut of. Every sector
//! therefore has the same matrix, whatever its angle, and rotating the ring only renumbers the
//! sectors.
//!
//! Unloaded sectors are joined in pairs, then groups of four and so on: O(log N) condensations for
//! N sectors. Joining eliminates the cut between two chains. The stiffness of that cut with both
//! ends fixed is positive definite even if the ring itself is free, so no step needs pivoting.
//!
//! A ring whose bore has mean constraints has unknowns that all sectors share
//! ([`shared_unknowns`]): the constraint forces. They are retained in every elimination, so sectors
//! and chains are condensed onto their cuts and these unknowns.
//!
//! See `docs/theory/substructures.md`.

mod chain;
mod shared_unknowns;

use super::bore_interface::BoreInterface;
use super::dense::{Interruptible, mirror_lower};
use super::error::StructureError;
pub use super::error::UnrestrainedRing;
use super::spline_teeth::SplineToothSet;
use calyx_numerics::interrupt::Interrupt;
use chain::{Chain, ChainEnds};
use faer::{Mat, MatRef};
pub(crate) use shared_unknowns::SharedUnknowns;
use std::f64::consts::TAU;
use std::ops::Range;
use std::sync::Arc;

/// If the independent part of a mean is a smaller share of it than this, the mean depends linearly
/// on the others.
const DEPENDENT: f64 = 1e-12;

/// A sector, or a chain of sectors, condensed onto its first and last cut and the shared unknowns.
#[derive(Clone, Debug)]
pub struct CutStiffness {
    /// Symmetric matrix over first cut, last cut and shared unknowns. The block of the shared
    /// unknowns is negative: their compliance with the cuts fixed.
    matrix: Mat<f64>,
    shared: Arc<SharedUnknowns>,
    /// Number of sectors.
    sectors: u32,
}

impl CutStiffness {
    /// Builds the stiffness of a sector. `matrix` is symmetric of even size: the degrees of freedom
    /// of the first cut, then as many of the last one, in N/m (per metre of face width in a plane
    /// model). Only its lower triangle is read.
    pub fn new(matrix: Mat<f64>) -> Self {
        Self::with_shared(matrix, SharedUnknowns::default())
    }

    /// Builds the stiffness as [`Self::new`], with the shared unknowns after those of the cuts.
    pub(crate) fn with_shared(matrix: Mat<f64>, shared: SharedUnknowns) -> Self {
        Self::chain(matrix, Arc::new(shared), 1)
    }

    fn chain(mut matrix: Mat<f64>, shared: Arc<SharedUnknowns>, sectors: u32) -> Self {
        assert!(
            matrix.nrows() == matrix.ncols() && (matrix.nrows() - shared.count).is_multiple_of(2),
            "two cuts of equal size"
        );
        mirror_lower(&mut matrix);
        Self { matrix, shared, sectors }
    }

    /// Returns the degrees of freedom of one cut.
    pub fn cut_size(&self) -> usize {
        (self.matrix.nrows() - self.shared.count) / 2
    }

    fn block(&self, row: usize, column: usize) -> MatRef<'_, f64> {
        let n = self.cut_size();
        self.matrix.as_ref().submatrix(row * n, column * n, n, n)
    }

    /// Returns the block of the cuts by the shared unknowns, expressed in the frame of a chain that
    /// begins at the angle `before` earlier.
    fn by_shared(&self, before: f64) -> Mat<f64> {
        let n = self.cut_size();
        self.shared.turned_back(self.matrix.as_ref().submatrix(0, 2 * n, 2 * n, self.shared.count), before)
    }

    /// Returns the block among the shared unknowns for such a chain.
    fn among_shared(&self, before: f64) -> Mat<f64> {
        let (n, count) = (self.cut_size(), self.shared.count);
        let own = self.matrix.as_ref().submatrix(2 * n, 2 * n, count, count);
        let once = self.shared.turned_back(own, before);
        self.shared.turned_back(once.transpose(), before)
    }

    /// Returns the chain of `self` followed by `next`, with the cut between them condensed (report
    /// eq. 2.80), and the dependence of that cut on the ends of the chain and the shared unknowns.
    /// `pitch` is the angle of a sector.
    fn join(&self, next: &Self, pitch: f64, interrupt: &Interrupt) -> Result<(Self, Inner), StructureError> {
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let (n, count) = (self.cut_size(), self.shared.count);
        let between = self.block(1, 1) + next.block(0, 0);
        let factor = dense.cholesky(between)?.ok_or(UnrestrainedRing)?;
        let own_shared = self.by_shared(0.0);
        let next_shared = next.by_shared(f64::from(self.sectors) * pitch);
        let mut coupling = Mat::zeros(n, 2 * n + count);
        coupling.as_mut().submatrix_mut(0, 0, n, n).copy_from(self.block(1, 0));
        coupling.as_mut().submatrix_mut(0, n, n, n).copy_from(next.block(0, 1));
        let by_shared = own_shared.as_ref().subrows(n, n) + next_shared.as_ref().subrows(0, n);
        coupling.as_mut().submatrix_mut(0, 2 * n, n, count).copy_from(by_shared);
        let coupling = dense.solve_lower(factor.as_ref(), coupling)?;
        let mut matrix = Mat::zeros(2 * n + count, 2 * n + count);
        matrix.as_mut().submatrix_mut(0, 0, n, n).copy_from(self.block(0, 0));
        matrix.as_mut().submatrix_mut(n, n, n, n).copy_from(next.block(1, 1));
        let (first, last) = (own_shared.as_ref().subrows(0, n), next_shared.as_ref().subrows(n, n));
        matrix.as_mut().submatrix_mut(2 * n, 0, count, n).copy_from(first.transpose());
        matrix.as_mut().submatrix_mut(2 * n, n, count, n).copy_from(last.transpose());
        let among = self.among_shared(0.0) + next.among_shared(f64::from(self.sectors) * pitch);
        matrix.as_mut().submatrix_mut(2 * n, 2 * n, count, count).copy_from(among);
        dense.add_product_lower(matrix.as_mut(), -1.0, coupling.transpose(), coupling.as_ref())?;
        let chain = Self::chain(matrix, self.shared.clone(), self.sectors + next.sectors);
        Ok((chain, Inner { factor, coupling }))
    }
}

/// Cut between two chains: its displacements are `-L^-T C` times those of both ends, first before
/// last, and the shared unknowns.
struct Inner {
    /// Cholesky factor `L` of the stiffness of the cut with the ends fixed.
    factor: Mat<f64>,
    /// `C = L^-1 K`, with `K` the coupling of the cut to the ends and the shared unknowns.
    coupling: Mat<f64>,
}

impl Inner {
    fn displacements(
        &self,
        first: MatRef<'_, f64>,
        last: MatRef<'_, f64>,
        shared: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, StructureError> {
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let n = self.factor.nrows();
        let coupling = self.coupling.as_ref();
        let mut forces = Mat::zeros(n, first.ncols());
        dense.add_product(forces.as_mut(), -1.0, coupling.subcols(0, n), first)?;
        dense.add_product(forces.as_mut(), -1.0, coupling.subcols(n, n), last)?;
        if shared.nrows() > 0 {
            dense.add_product(forces.as_mut(), -1.0, coupling.subcols(2 * n, shared.nrows()), shared)?;
        }
        dense.solve_upper(self.factor.as_ref(), forces)
    }
}

/// Flexibility of a ring: displacements of the cuts of every sector in a window, per unit force on
/// the cuts of the first one. Those of the other sectors are recovered on demand.
#[derive(Clone)]
pub struct RingFlexibility {
    /// Matrices by offset from the loaded sector. Rows are the first and last cut of the observed
    /// sector and the shared unknowns in its frame, columns those of the loaded one.
    by_offset: Vec<Mat<f64>>,
    shared: Arc<SharedUnknowns>,
    sectors: u32,
    /// Sectors outside the window, from behind it on to the loaded sector; `None` if there are
    /// none.
    outside: Option<Chain>,
}

/// Constrained mean displacements of the bore.
pub(crate) struct ConstrainedMeans {
    /// Rotation of the means from sector to sector.
    pub shared: SharedUnknowns,
    /// Forces on the means by their values.
    pub stiffness: Mat<f64>,
    /// Constraint forces by forces on the cuts and the means of a sector, one row for each.
    pub constraint_forces: Mat<f64>,
}

/// Mean displacements of the bore that were constrained and have been released.
pub(crate) struct ReleasedMeans {
    /// Rotation of the means from sector to sector.
    pub shared: SharedUnknowns,
    /// Values of the means by forces on them; with spline teeth in the body's frame, otherwise in
    /// that of any sector.
    pub release: Mat<f64>,
    /// Former constraint forces by forces on the cuts and the means of a sector, one row for each.
    pub constraint_forces: Mat<f64>,
    /// Spline teeth that support the means now. Without them, the ring's responses are those with
    /// the means released.
    pub spline_teeth: Option<SplineToothSet>,
    /// Displacements of the bore on which contact outside of the structure acts.
    pub interface: Option<BoreInterface>,
}

impl RingFlexibility {
    /// Builds the flexibility of a ring of `sectors` equal sectors: offsets `0 ..= window`, at most
    /// halfway round.
    ///
    /// The sectors outside the window are condensed by doubling. Those of the window are joined to
    /// them one by one, from the last one back to the loaded one; the displacements of the
    /// eliminated cuts follow from those of the loaded sector. There is a checkpoint before each
    /// piece of a dense operation.
    ///
    /// # Errors
    /// The ring has a rigid-body motion, or the computation is interrupted.
    pub fn new(
        sector: &CutStiffness,
        sectors: u32,
        window: u32,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        assert!(sectors >= 1, "a ring has sectors");
        let window = window.min(sectors / 2).min(sectors - 1);
        let (n, count) = (sector.cut_size(), sector.shared.count);
        // Memory to join two chains, for each doubling two chains with the eliminated cut, and for
        // each sector of the window the eliminated cut, its cuts, its rows and its result.
        let doublings = (sectors - window).ilog2() + 1;
        let matrices = 12 + 4 * u64::from(window + doublings);
        let bytes = matrices * (size_of::<f64>() * (2 * n + count).pow(2)) as u64;
        let _room = interrupt.reserve_memory(bytes).map_err(StructureError::Interrupted)?;
        let pitch = TAU / f64::from(sectors);
        let ends = [[0, 0], [0, 1], [1, 0], [1, 1]];
        if sectors == 1 {
            // Both ends of the single sector are the same degrees of freedom.
            let mut closed = Mat::zeros(n + count, n + count);
            for [row, column] in ends {
                let mut target = closed.as_mut().submatrix_mut(0, 0, n, n);
                target += sector.block(row, column);
            }
            let by_shared = sector.by_shared(0.0);
            let by_shared = by_shared.as_ref().subrows(0, n) + by_shared.as_ref().subrows(n, n);
            closed.as_mut().submatrix_mut(n, 0, count, n).copy_from(by_shared.transpose());
            closed.as_mut().submatrix_mut(n, n, count, count).copy_from(sector.among_shared(0.0));
            let alone = inverse(closed, n, interrupt)?;
            let place = |index: usize| if index < 2 * n { index % n } else { index - n };
            let size = 2 * n + count;
            let both = Mat::from_fn(size, size, |row, column| alone[(place(row), place(column))]);
            return Ok(Self { by_offset: vec![both], shared: sector.shared.clone(), sectors, outside: None });
        }
        // The sectors outside the window, or its last one if there are none, extend from cut
        // `known` back to cut 0.
        let outside = match sectors - window - 1 {
            0 => None,
            count => Some(Chain::sector(sector).repeated(count, pitch, interrupt)?),
        };
        let (mut rest, known) = match &outside {
            None => (sector.clone(), window),
            Some(outside) => (outside.stiffness.clone(), window + 1),
        };
        let mut passed = Vec::new();
        for _ in 1..known {
            let (longer, inner) = sector.join(&rest, pitch, interrupt)?;
            passed.push(inner);
            rest = longer;
        }
        interrupt.check().map_err(StructureError::Interrupted)?;
        let mut closed = sector.matrix.clone();
        for [row, column] in ends {
            let mut target = closed.as_mut().submatrix_mut((1 - row) * n, (1 - column) * n, n, n);
            target += rest.block(row, column);
        }
        // The rest begins at the end of the loaded sector.
        let by_shared = rest.by_shared(pitch);
        for end in 0..2 {
            let mut target = closed.as_mut().submatrix_mut(2 * n, (1 - end) * n, count, n);
            target += by_shared.as_ref().subrows(end * n, n).transpose();
        }
        let mut target = closed.as_mut().submatrix_mut(2 * n, 2 * n, count, count);
        target += rest.among_shared(pitch);
        let loaded = inverse(closed, 2 * n, interrupt)?;
        let size = 2 * n + count;
        let (first, second) =
            (loaded.as_ref().subrows(0, n).to_owned(), loaded.as_ref().subrows(n, n).to_owned());
        let shared = |places: usize| {
            let mut rows = loaded.as_ref().subrows(2 * n, count).to_owned();
            sector.shared.turn_rows(rows.as_mut(), places as f64 * pitch);
            rows
        };
        let mut cuts = vec![first, second];
        while let Some(inner) = passed.pop() {
            // The chain behind the last known cut begins with the sector of that index.
            let from = cuts.len() - 1;
            let ends = [&cuts[from], &cuts[0]].map(Mat::as_ref);
            let next = inner.displacements(ends[0], ends[1], shared(from).as_ref(), interrupt)?;
            cuts.push(next);
        }
        let of_sector = |offset: usize| {
            let mut rows = Mat::zeros(size, size);
            for (end, cut) in [offset, (offset + 1) % cuts.len()].into_iter().enumerate() {
                rows.as_mut().submatrix_mut(end * n, 0, n, size).copy_from(&cuts[cut]);
            }
            rows.as_mut().submatrix_mut(2 * n, 0, count, size).copy_from(shared(offset));
            rows
        };
        let by_offset = (0..=window as usize).map(of_sector).collect();
        Ok(Self { by_offset, shared: sector.shared.clone(), sectors, outside })
    }

    /// Returns the means that the shared unknowns from index `first` on constrain. `None` if there
    /// are none.
    pub fn bound(&self, first: usize) -> Option<ConstrainedMeans> {
        let own = self.by_offset.first().filter(|_| first < self.shared.count)?;
        let (from, count) = (own.nrows() - self.shared.count + first, self.shared.count - first);
        Some(ConstrainedMeans {
            shared: self.shared.from(first),
            // With prescribed amplitudes, the ring responds with these forces, negative.
            stiffness: Mat::from_fn(count, count, |row, column| -own[(from + row, from + column)]),
            constraint_forces: own.as_ref().subrows(from, count).to_owned(),
        })
    }

    /// Releases the means that the shared unknowns from index `first` on constrain, except for what
    /// another body carries: `carried`, forces by means, symmetric. `None` if there are none.
    ///
    /// # Errors
    /// The released ring has a rigid-body motion, or the computation is interrupted.
    pub fn release(
        &mut self,
        first: usize,
        carried: Option<&Mat<f64>>,
        interrupt: &Interrupt,
    ) -> Result<Option<ReleasedMeans>, StructureError> {
        let Some(ConstrainedMeans { shared, mut stiffness, constraint_forces }) = self.bound(first) else {
            return Ok(None);
        };
        if let Some(carried) = carried {
            stiffness += carried;
        }
        let count = shared.count;
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let factor = dense.cholesky(stiffness)?.ok_or(UnrestrainedRing)?;
        let release = dense.solve(factor.as_ref(), Mat::identity(count, count))?;
        let amplitudes = dense.product(release.as_ref(), constraint_forces.as_ref())?;
        for flexibility in &mut self.by_offset {
            let from = flexibility.ncols() - count;
            let by_amplitudes = flexibility.as_ref().subcols(from, count).to_owned();
            dense.add_product(flexibility.as_mut(), 1.0, by_amplitudes.as_ref(), amplitudes.as_ref())?;
        }
        Ok(Some(ReleasedMeans { shared, release, constraint_forces, spline_teeth: None, interface: None }))
    }

    /// Returns the number of sectors of the ring.
    pub fn sectors(&self) -> u32 {
        self.sectors
    }

    /// Returns the degrees of freedom of one cut.
    pub fn cut_size(&self) -> usize {
        (self.at(0).nrows() - self.shared.count) / 2
    }

    /// Returns the largest stored offset.
    pub fn window(&self) -> u32 {
        self.by_offset.len() as u32 - 1
    }

    /// Returns the cut displacements of the sector at an offset ahead, and the shared unknowns in
    /// its frame. `offset <= window()`.
    pub fn at(&self, offset: u32) -> MatRef<'_, f64> {
        self.by_offset[offset as usize].as_ref()
    }

    /// Returns the offsets of the sectors outside the window, ahead and behind.
    pub fn offsets_outside(&self) -> Range<u32> {
        let window = self.window();
        window + 1..self.sectors.saturating_sub(window).max(window + 1)
    }

    /// Returns the cut displacements of the sectors outside the window, and the shared unknowns in
    /// their frames, under forces on the cuts and the shared unknowns of the loaded sector: one
    /// matrix for each of [`Self::offsets_outside`], with a column for each column of `forces`.
    ///
    /// # Errors
    /// The computation is interrupted.
    pub(crate) fn outside(
        &self,
        forces: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<Vec<Mat<f64>>, StructureError> {
        let Some(chain) = &self.outside else { return Ok(Vec::new()) };
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let (pitch, count) = (TAU / f64::from(self.sectors), self.shared.count);
        let n = self.cut_size();
        let offsets = self.offsets_outside();
        let last = dense.product(self.at(0).subrows(0, n), forces)?;
        let shared = dense.product(self.at(0).subrows(2 * n, count), forces)?;
        let shared = |offset: u32| {
            let mut rows = shared.clone();
            self.shared.turn_rows(rows.as_mut(), f64::from(offset) * pitch);
            rows
        };
        let mut cuts = vec![dense.product(self.at(self.window()).subrows(n, n), forces)?];
        let first = cuts[0].clone();
        let at_start = shared(offsets.start);
        let ends = ChainEnds { first: first.as_ref(), last: last.as_ref(), shared: at_start.as_ref() };
        chain.recover(ends, pitch, &mut cuts, interrupt)?;
        cuts.push(last);
        let of_sector = |offset: u32| {
            let place = (offset - offsets.start) as usize;
            let mut rows = Mat::zeros(forces.nrows(), forces.ncols());
            rows.as_mut().subrows_mut(0, n).copy_from(&cuts[place]);
            rows.as_mut().subrows_mut(n, n).copy_from(&cuts[place + 1]);
            rows.as_mut().subrows_mut(2 * n, count).copy_from(shared(offset));
            rows
        };
        Ok(offsets.clone().map(of_sector).collect())
    }
}

/// Inverts the closed matrix of a ring, of which the lower triangle is read: `size` degrees of
/// freedom of cuts, then shared unknowns. The constraint forces are eliminated first, because
/// without them the ring may have rigid-body motions.
fn inverse(closed: Mat<f64>, size: usize, interrupt: &Interrupt) -> Result<Mat<f64>, StructureError> {
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    let dense = Interruptible(&checkpoint);
    let count = closed.nrows() - size;
    let mut stiffness = closed.as_ref().submatrix(0, 0, size, size).to_owned();
    if count == 0 {
        let factor = dense.cholesky(stiffness)?.ok_or(UnrestrainedRing)?;
        return dense.solve(factor.as_ref(), Mat::identity(size, size));
    }
    // [K G'; G -H] with H positive definite: the compliance of the constraints with the cuts fixed.
    let yielding = Mat::from_fn(count, count, |row, column| -closed[(size + row, size + column)]);
    let own = yielding.diagonal().column_vector().to_owned();
    let yielding = dense.cholesky(yielding)?.ok_or(StructureError::CoarseBore)?;
    if (0..count).any(|mean| yielding[(mean, mean)].powi(2) <= DEPENDENT * own[mean]) {
        return Err(StructureError::CoarseBore);
    }
    let conditions = closed.as_ref().submatrix(size, 0, count, size);
    let half = dense.solve_lower(yielding.as_ref(), conditions.to_owned())?;
    dense.add_product_lower(stiffness.as_mut(), 1.0, half.transpose(), half.as_ref())?;
    let factor = dense.cholesky(stiffness)?.ok_or(UnrestrainedRing)?;
    let constrained = dense.solve_upper(yielding.as_ref(), half)?;
    let mut forces = Mat::zeros(size, size + count);
    forces.as_mut().submatrix_mut(0, 0, size, size).copy_from(Mat::<f64>::identity(size, size));
    forces.as_mut().submatrix_mut(0, size, size, count).copy_from(constrained.transpose());
    let cuts = dense.solve(factor.as_ref(), forces)?;
    let mut shared = dense.product(constrained.as_ref(), cuts.as_ref())?;
    let mut own = shared.as_mut().submatrix_mut(0, size, count, count);
    own -= dense.solve(yielding.as_ref(), Mat::identity(count, count))?;
    let mut all = Mat::zeros(size + count, size + count);
    all.as_mut().submatrix_mut(0, 0, size, size + count).copy_from(cuts);
    all.as_mut().submatrix_mut(size, 0, count, size + count).copy_from(shared);
    Ok(all)
}

#[cfg(test)]
mod tests;
