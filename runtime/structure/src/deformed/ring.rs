//! Displacements of all nodes of the sectors of a ring under given forces, with any support of its
//! bore.
//!
//! The flexibility of the ring at its cuts ([`RingFlexibility`]) is that of its condensed
//! structure. Interior displacements of a sector follow from the displacements `u_c` of its two
//! cuts and the constraint forces `mu` of the bore: `u = K^-1 (f - K_c u_c - G mu)`. `K` is
//! factorized once for all sectors and positions.

use crate::StructureError;
use crate::bore::BoreMeans;
use crate::bore_coupling::BoreCoupling;
use crate::condense::{Assembled, Cuts, Support, condense};
use crate::dense::{add_product, product};
use crate::ring::RingFlexibility;
use calyx_fe::{Constraints, Solver, SparseVector};
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use faer::sparse::SparseColMat;
use faer::{ColMut, Mat, MatRef};

/// Ring that keeps its interior, in contrast to a condensed structure.
pub(super) struct SolvedRing {
    pub sectors: u32,
    /// Stiffness matrix of one sector, symmetric.
    stiffness: SparseColMat<usize, f64>,
    dofs_per_node: usize,
    /// Degrees of freedom of the first cut, and the corresponding ones of the last cut.
    cuts: [Vec<usize>; 2],
    /// Rotation of the last cut, rad.
    pitch: f64,
    /// Forms of the means that are constrained or released; empty for a rigid bore.
    forms: Vec<SparseVector>,
    /// Solver of the interior, with fixed supports and both cuts fixed.
    inside: Solver,
    ring: RingFlexibility,
    /// Coupling with what supports the bore, and its equivalent forces by those on cuts and means.
    bore: Option<(BoreCoupling, Mat<f64>)>,
    /// Memory reservation for the stiffness matrix.
    _room: MemoryReservation,
}

/// Displacements of the cuts of a ring under loads.
pub(super) struct LoadedRing {
    /// Displacements of the cuts and means of all sectors, one column each in the frame of the
    /// sector.
    unknowns: Mat<f64>,
    /// Largest displacement of a cut.
    pub largest: f64,
    /// Loaded sectors.
    loaded: Vec<u32>,
    /// Displacements of each loaded sector with fixed cuts.
    alone: Mat<f64>,
}

/// Sector of a ring, and the support of the ring.
pub(super) struct ConstrainedSector {
    pub sectors: u32,
    pub cuts: Cuts,
    /// Fixed degrees of freedom.
    pub constrained: Vec<usize>,
    pub means: Option<BoreMeans>,
}

impl SolvedRing {
    /// Builds the ring; `blamed` maps its errors.
    pub fn new(
        assembled: Assembled,
        sector: ConstrainedSector,
        blamed: impl Fn(StructureError) -> StructureError,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let ConstrainedSector { sectors, cuts, constrained, means } = sector;
        let support = Support::for_ring(&constrained, means.as_ref());
        let condensed = condense(&assembled, &support, Some(&cuts), &[], &[], interrupt)?;
        let stiffness = condensed.stiffness.ok_or(StructureError::NoArea)?;
        let mut ring = RingFlexibility::new(&stiffness, sectors, 0, interrupt).map_err(&blamed)?;
        let released = means.as_ref().map(|means| means.release(&mut ring, interrupt));
        let released = released.transpose().map_err(blamed)?;
        let bore = released.flatten().map(|released| {
            let constraint_forces = released.constraint_forces.clone();
            (BoreCoupling::new(released, sectors, cuts.angle), constraint_forces)
        });
        let dofs = [&cuts.first, &cuts.last].map(|nodes| assembled.dofs_of(nodes));
        let mut resting = Constraints::new();
        for &dof in constrained.iter().chain(dofs.iter().flatten()) {
            resting.prescribe(dof, 0.0);
        }
        interrupt.check().map_err(StructureError::Interrupted)?;
        let inside = Solver::dissected(&assembled.stiffness, &assembled.positions, resting)?;
        interrupt.check().map_err(StructureError::Interrupted)?;
        let Assembled { stiffness, dofs_per_node, room, .. } = assembled;
        let forms = means.map_or_else(Vec::new, |means| means.forms);
        Ok(Self {
            sectors,
            stiffness,
            dofs_per_node,
            cuts: dofs,
            pitch: cuts.angle,
            forms,
            inside,
            ring,
            bore,
            _room: room,
        })
    }

    /// Solves for the displacements of all cuts. The loads are full vectors of forces on some
    /// sectors, in their own frames, and forces on the interface of the bore, if any.
    pub fn under(
        &self,
        loads: &[(u32, Vec<f64>)],
        interface: &[f64],
        interrupt: &Interrupt,
    ) -> Result<LoadedRing, StructureError> {
        let dofs = self.stiffness.ncols();
        let forces = Mat::from_fn(dofs, loads.len(), |dof, column| loads[column].1[dof]);
        let alone = self.inside.solve(forces.as_ref())?;
        let on_cuts = self.on_cuts(&forces, &alone);
        let own = product(self.ring.at(0), on_cuts.as_ref());
        let others = self.ring.outside(on_cuts.as_ref(), interrupt)?;
        let mut unknowns = Mat::zeros(on_cuts.nrows(), self.sectors as usize);
        for (sector, mut sum) in (0..self.sectors).zip(unknowns.col_iter_mut()) {
            for (load, (loaded, _)) in loads.iter().enumerate() {
                let ahead = self.sectors_ahead(*loaded, sector) as usize;
                sum += ahead.checked_sub(1).map_or(&own, |place| &others[place]).col(load);
                self.add_through_bore(sum.as_mut(), sector, (*loaded, on_cuts.as_ref().subcols(load, 1)));
            }
            self.add_interface(sum.as_mut(), sector, interface);
        }
        let loaded = loads.iter().map(|&(sector, _)| sector).collect();
        let largest = unknowns.as_ref().subrows(0, 2 * self.cut_size()).norm_max();
        Ok(LoadedRing { unknowns, largest, loaded, alone })
    }

    /// Returns the displacements of sectors, one column each in the frame of the sector.
    pub fn displacements(&self, solution: &LoadedRing, wanted: &[u32]) -> Result<Mat<f64>, StructureError> {
        let rows = solution.unknowns.nrows();
        let unknowns =
            Mat::from_fn(rows, wanted.len(), |row, at| solution.unknowns[(row, wanted[at] as usize)]);
        let mut moved = Mat::zeros(self.stiffness.ncols(), wanted.len());
        let rest = self.forces_inside(&unknowns, &mut moved);
        moved += self.inside.solve(rest.as_ref())?;
        for (column, &sector) in wanted.iter().enumerate() {
            if let Some(load) = solution.loaded.iter().position(|&loaded| loaded == sector) {
                let mut own = moved.as_mut().col_mut(column);
                own += solution.alone.col(load);
            }
        }
        Ok(moved)
    }

    fn cut_size(&self) -> usize {
        self.cuts[0].len()
    }

    /// Returns the forces on the cuts (for the last one in the frame of the next sector) and on the
    /// means that are equivalent to each load; `alone` is its interior displacement with fixed
    /// cuts.
    fn on_cuts(&self, forces: &Mat<f64>, alone: &Mat<f64>) -> Mat<f64> {
        let n = self.cut_size();
        let (sin, cos) = self.pitch.sin_cos();
        let mut all = Mat::zeros(2 * n + self.forms.len(), forces.ncols());
        for column in 0..forces.ncols() {
            let alone = alone.col(column);
            for (place, &dof) in self.cuts.iter().flatten().enumerate() {
                let rows = self.stiffness.row_idx_of_col(dof).zip(self.stiffness.val_of_col(dof));
                let passed: f64 = rows.map(|(row, value)| value * alone[row]).sum();
                all[(place, column)] = forces[(dof, column)] - passed;
            }
            for first in (n..2 * n).step_by(self.dofs_per_node) {
                let [x, y] = [all[(first, column)], all[(first + 1, column)]];
                all[(first, column)] = cos * x + sin * y;
                all[(first + 1, column)] = cos * y - sin * x;
            }
            for (mean, form) in self.forms.iter().enumerate() {
                all[(2 * n + mean, column)] =
                    -form.entries.iter().map(|&(dof, value)| value * alone[dof]).sum::<f64>();
            }
        }
        all
    }

    /// Returns the number of sectors ahead, around the ring, from one sector to another.
    fn sectors_ahead(&self, from: u32, to: u32) -> u32 {
        (to % self.sectors + self.sectors - from % self.sectors) % self.sectors
    }

    /// Adds the displacements of a sector's cuts and means, in its own frame, that spline teeth
    /// cause under forces on those of another sector.
    fn add_through_bore(
        &self,
        sum: ColMut<'_, f64>,
        observer: u32,
        (loaded, forces): (u32, MatRef<'_, f64>),
    ) {
        let Some((bore, constraint_forces)) = self.bore.as_ref().filter(|(bore, _)| !bore.is_in_tables())
        else {
            return;
        };
        let felt = product(constraint_forces.as_ref(), forces);
        // A single load, without checkpoints.
        if let Ok(amplitudes) = bore.amplitudes(observer, (loaded, &felt), &Interrupt::never()) {
            add_product(sum.as_mat_mut(), 1.0, constraint_forces.transpose(), amplitudes.as_ref());
        }
    }

    /// Adds the displacements of a sector's cuts and means by forces on the interface of the bore.
    fn add_interface(&self, sum: ColMut<'_, f64>, observer: u32, interface: &[f64]) {
        let Some((bore, constraint_forces)) = self.bore.as_ref().filter(|_| !interface.is_empty()) else {
            return;
        };
        let interface = MatRef::from_column_major_slice(interface, interface.len(), 1);
        if let Some(amplitudes) = bore.amplitudes_by_interface(observer, interface) {
            add_product(sum.as_mat_mut(), 1.0, constraint_forces.transpose(), amplitudes.as_ref());
        }
    }

    /// Sets the cut displacements of sectors from the unknowns; returns the resulting interior
    /// forces.
    fn forces_inside(&self, unknowns: &Mat<f64>, moved: &mut Mat<f64>) -> Mat<f64> {
        let n = self.cut_size();
        let (sin, cos) = self.pitch.sin_cos();
        let mut forces = Mat::zeros(moved.nrows(), moved.ncols());
        for column in 0..moved.ncols() {
            for (place, &dof) in self.cuts.iter().flatten().enumerate() {
                moved[(dof, column)] = unknowns[(place, column)];
            }
            for last in self.cuts[1].chunks_exact(self.dofs_per_node) {
                let [x, y] = [moved[(last[0], column)], moved[(last[1], column)]];
                moved[(last[0], column)] = cos * x - sin * y;
                moved[(last[1], column)] = sin * x + cos * y;
            }
            let mut of_column = forces.as_mut().col_mut(column);
            for &dof in self.cuts.iter().flatten() {
                let by = moved[(dof, column)];
                for (row, value) in self.stiffness.row_idx_of_col(dof).zip(self.stiffness.val_of_col(dof)) {
                    of_column[row] -= value * by;
                }
            }
            for (mean, form) in self.forms.iter().enumerate() {
                let constraint_forces = unknowns[(2 * n + mean, column)];
                for &(dof, value) in &form.entries {
                    of_column[dof] -= value * constraint_forces;
                }
            }
        }
        forces
    }
}
