//! Spline teeth with clearance: displacements of the spline teeth and of the ring's teeth by forces
//! of the spline teeth.
//!
//! Such spline teeth are part of the contact problem and not of the structure
//! (`spline_contact`): the contact state of spline teeth is solved together with that of the
//! gear teeth. The ring therefore has mean constraints on its bore, like a free ring, and its
//! rigid-body motion belongs to its frame. Let `G` be the amplitudes of the bore's series by forces
//! on them after release, and `L` the displacements of the spline teeth by amplitudes. Then spline
//! teeth move by `L G L'` under their own forces and by `L G h` under those of gear teeth, where
//! `h` are the constraint forces of the amplitudes. The mean constraints carry the part of a spline
//! tooth's force that moves the ring as a whole, without strain. In the frame this part is in
//! equilibrium with all other forces, so the constraint forces vanish in the solution.

use super::StructureError;
use super::dense::{Interruptible, mirror_lower};
use super::spline_teeth::SplineToothForms;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};

/// Spline teeth with clearance. See the module documentation. All quantities are in the body's
/// frame; displacements and forces are tangential, counter-clockwise.
#[derive(Clone, Debug)]
pub(crate) struct SplineWithClearance {
    /// Displacements by forces on the bore's amplitudes, one row for each spline tooth.
    pub by_amplitudes: Mat<f64>,
    /// Displacements by forces of spline teeth on the ring, m/(N/m).
    pub compliance: Mat<f64>,
}

impl SplineToothForms {
    /// Builds the spline teeth on a ring whose amplitudes, from index `first` on, respond to forces
    /// by `release`; the preceding ones are constrained.
    ///
    /// # Errors
    /// The series cannot distinguish the spline teeth, or the computation is interrupted.
    pub fn with_clearance(
        &self,
        first: usize,
        release: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<SplineWithClearance, StructureError> {
        let displacements = self.displacements.as_ref().subcols(first, release.nrows());
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let by_amplitudes = dense.product(displacements, release)?;
        let mut compliance = dense.product(by_amplitudes.as_ref(), displacements.transpose())?;
        mirror_lower(&mut compliance);
        dense.cholesky(compliance.clone())?.ok_or(StructureError::CoarseSplineTeeth)?;
        Ok(SplineWithClearance { by_amplitudes, compliance })
    }
}

impl SplineWithClearance {
    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        let entries = |matrix: &Mat<f64>| matrix.nrows() * matrix.ncols();
        (entries(&self.by_amplitudes) + entries(&self.compliance)) * size_of::<f64>()
    }
}
