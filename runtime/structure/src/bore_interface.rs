//! Displacements of the bore of a ring on which contact outside of the structure acts: those of
//! spline teeth with clearance, or the series of a raceway.
//!
//! Such contacts are part of the contact problem and not of the structure. The ring therefore has
//! mean constraints on its bore, like a free ring, and its rigid-body motion belongs to its frame.
//! Let `G` be the amplitudes of the bore's series by forces on them after release, and `L` the
//! observed displacements by amplitudes. Then they are `L G L'` under their own forces and `L G h`
//! under those of gear teeth, where `h` are the constraint forces of the amplitudes. The mean
//! constraints carry the part of a force that moves the ring as a whole, without strain. In the
//! frame this part is in equilibrium with all other forces, so the constraint forces vanish in the
//! solution.

use super::StructureError;
use super::dense::{Interruptible, mirror_lower};
use super::raceway::{Raceway, RacewayForms};
use super::spline_teeth::SplineToothForms;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};

/// Observed displacements of a bore. See the module documentation. All quantities are in the body's
/// frame.
#[derive(Clone, Debug)]
pub(crate) struct BoreInterface {
    /// Displacements by forces on the bore's amplitudes, one row for each.
    pub by_amplitudes: Mat<f64>,
    /// Displacements by the conjugate forces, m/(N/m) in a plane model and m/N otherwise.
    pub compliance: Mat<f64>,
    /// The raceway whose series they are; `None` for spline teeth, whose displacements are
    /// tangential, counter-clockwise.
    pub raceway: Option<Raceway>,
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
    ) -> Result<BoreInterface, StructureError> {
        let displacements = self.displacements.as_ref().subcols(first, release.nrows());
        let interface = BoreInterface::new(displacements, release, interrupt)?;
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let factor = Interruptible(&checkpoint).cholesky(interface.compliance.clone())?;
        factor.ok_or(StructureError::CoarseSplineTeeth)?;
        Ok(interface)
    }
}

impl RacewayForms {
    /// Builds the raceway of a ring whose amplitudes, from index `first` on, respond to forces by
    /// `release`; the preceding ones are constrained.
    ///
    /// # Errors
    /// The computation is interrupted.
    pub fn released(
        &self,
        first: usize,
        release: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<BoreInterface, StructureError> {
        let coefficients = self.coefficients.as_ref().subcols(first, release.nrows());
        let interface = BoreInterface::new(coefficients, release, interrupt)?;
        Ok(BoreInterface { raceway: Some(self.raceway), ..interface })
    }
}

impl BoreInterface {
    /// Builds the interface of displacements by amplitudes (rows by amplitudes), which respond to
    /// forces by `release`.
    ///
    /// # Errors
    /// The computation is interrupted.
    pub fn new(
        displacements: MatRef<'_, f64>,
        release: MatRef<'_, f64>,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let by_amplitudes = dense.product(displacements, release)?;
        let mut compliance = dense.product(by_amplitudes.as_ref(), displacements.transpose())?;
        mirror_lower(&mut compliance);
        Ok(Self { by_amplitudes, compliance, raceway: None })
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        let entries = |matrix: &Mat<f64>| matrix.nrows() * matrix.ncols();
        (entries(&self.by_amplitudes) + entries(&self.compliance)) * size_of::<f64>()
    }
}
