//! Lugs with clearance, as a structure sees them: what their forces do to each other and to the teeth of the ring that they stand on.
//!
//! Such lugs are no part of the structure but contact ([`crate::lug_contact`]): whether one bears follows with whether teeth do. So the ring
//! is held in the mean over its bore, as a free one, and its motion as a whole belongs to its frame. With `G` the amplitudes of the bore's
//! series by forces on them, let go, and `L` the lugs' displacements by amplitudes, lugs move by `L G L'` under each other's forces and by
//! `L G h` under those of teeth, `h` being what held the amplitudes against them. The part of a lug's force that moves the ring as a whole is
//! borne by the hold in the mean and strains nothing; on the frame it is in equilibrium with all else, so nothing is held in the end.

use super::StructureError;
use super::dense::{cholesky, mirror_lower, product};
use super::lugs::LugForms;
use faer::{Mat, MatRef};

/// See the module. In the body's frame; displacements are around, counter-clockwise, and so are forces.
#[derive(Clone, Debug)]
pub(crate) struct LooseLugs {
    /// Displacements by forces on the bore's amplitudes, a row a lug.
    pub by_amplitudes: Mat<f64>,
    /// Displacements by forces of lugs on the ring, m/(N/m).
    pub compliance: Mat<f64>,
}

impl LugForms {
    /// The lugs on a ring that follows forces on its amplitudes, from number `first` on, by `release`; those before are held.
    ///
    /// # Errors
    /// The series cannot tell the lugs apart.
    pub fn loose(&self, first: usize, release: MatRef<'_, f64>) -> Result<LooseLugs, StructureError> {
        let displacements = self.displacements.as_ref().subcols(first, release.nrows());
        let by_amplitudes = product(displacements, release);
        let mut compliance = product(by_amplitudes.as_ref(), displacements.transpose());
        mirror_lower(&mut compliance);
        cholesky(compliance.clone()).ok_or(StructureError::CoarseLugs)?;
        Ok(LooseLugs { by_amplitudes, compliance })
    }
}

impl LooseLugs {
    /// Memory, in bytes.
    pub fn bytes(&self) -> usize {
        let entries = |matrix: &Mat<f64>| matrix.nrows() * matrix.ncols();
        (entries(&self.by_amplitudes) + entries(&self.compliance)) * size_of::<f64>()
    }
}
