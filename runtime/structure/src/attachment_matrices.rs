//! Matrices of an elastic body on its attachments.

use serde::{Deserialize, Serialize};

/// Vibrations of an elastic body with fixed attachments, which are added to the motions of these
/// (Craig and Bampton 1968). The modal masses are 1.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ComponentModes {
    /// Squared natural frequencies, (rad/s)².
    pub eigenvalues: Vec<f64>,
    /// Mass between attachment components (rows) and modal coordinates (columns), row-major, kg^1/2
    /// and m kg^1/2.
    pub coupling: Vec<f64>,
    /// Gyroscopic matrix of a body that rotates about the third axis, per angular velocity:
    /// attachment components, then modal coordinates, row-major. Empty for other bodies.
    pub gyroscopic: Vec<f64>,
    /// Form of the sense of whirl of such a body, for a rotation in the positive sense, in the same
    /// order.
    pub whirl_form: Vec<f64>,
}

impl ComponentModes {
    /// Returns the number of modes.
    pub fn count(&self) -> usize {
        self.eigenvalues.len()
    }
}

/// Raceways in the attachments of an elastic body. The coefficients `r` of their series follow from
/// the motions `u` of the attachments and the forces `f` on the coefficients: `r = A u + C f`. The
/// forces of the attachments on the body are `K u - A' f`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RacewayMatrices {
    /// A: coefficients of all raceways (rows) by the components of the attachments, row-major.
    pub motions: Vec<f64>,
    /// C: between the coefficients, row-major, m/N.
    pub compliance: Vec<f64>,
}

impl RacewayMatrices {
    /// Returns the number of coefficients.
    pub fn terms(&self) -> usize {
        self.compliance.len().isqrt()
    }
}

/// Stiffness and mass of an elastic body on its attachments, row-major, six rows an attachment:
/// three displacements and three rotations.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct AttachmentMatrices {
    /// Stiffness, N/m, N and N m.
    pub stiffness: Vec<f64>,
    /// Mass, kg, kg m and kg m²; empty if it has not been computed.
    pub mass: Vec<f64>,
    /// Modes with fixed attachments; none if they have not been requested.
    pub modes: ComponentModes,
    /// Raceways in the attachments; empty without any.
    pub raceways: RacewayMatrices,
}

impl AttachmentMatrices {
    /// Returns the memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of::<f64>()
            * (self.stiffness.len()
                + self.mass.len()
                + self.modes.eigenvalues.len()
                + self.modes.coupling.len()
                + self.modes.gyroscopic.len()
                + self.modes.whirl_form.len()
                + self.raceways.motions.len()
                + self.raceways.compliance.len())
    }

    /// Returns the bytes for the disk cache.
    pub fn stored(&self) -> Option<Vec<u8>> {
        postcard::to_stdvec(self).ok()
    }

    /// Restores the matrices of a number of attachments; `None` if the bytes do not describe them.
    pub fn restored(stored: &[u8], attachments: usize, with_mass: bool) -> Option<AttachmentMatrices> {
        let matrices: AttachmentMatrices = postcard::from_bytes(stored).ok()?;
        let entries = 36 * attachments * attachments;
        let (of_mass, modes) = (if with_mass { entries } else { 0 }, &matrices.modes);
        let terms = matrices.raceways.terms();
        let fits = matrices.stiffness.len() == entries
            && matrices.mass.len() == of_mass
            && modes.coupling.len() == 6 * attachments * modes.count()
            && matrices.raceways.compliance.len() == terms * terms
            && matrices.raceways.motions.len() == terms * 6 * attachments;
        fits.then_some(matrices)
    }
}
