//! Matrices of an elastic body on its attachments.

use serde::{Deserialize, Serialize};

/// Stiffness and mass of an elastic body on its attachments, row-major, six rows an attachment:
/// three displacements and three rotations.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AttachmentMatrices {
    /// Stiffness, N/m, N and N m.
    pub stiffness: Vec<f64>,
    /// Mass, kg, kg m and kg m²; empty if it has not been computed.
    pub mass: Vec<f64>,
}

impl AttachmentMatrices {
    /// Returns the memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * (self.stiffness.len() + self.mass.len())
    }

    /// Returns the bytes for the disk cache.
    pub fn stored(&self) -> Option<Vec<u8>> {
        postcard::to_stdvec(self).ok()
    }

    /// Restores the matrices of a number of attachments; `None` if the bytes do not describe them.
    pub fn restored(stored: &[u8], attachments: usize, with_mass: bool) -> Option<AttachmentMatrices> {
        let matrices: AttachmentMatrices = postcard::from_bytes(stored).ok()?;
        let entries = 36 * attachments * attachments;
        let fits =
            matrices.stiffness.len() == entries && matrices.mass.len() == if with_mass { entries } else { 0 };
        fits.then_some(matrices)
    }
}
