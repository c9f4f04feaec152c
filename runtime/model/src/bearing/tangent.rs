//! Linearized loads of bearings.

use super::BearingMatrix;
use calyx_rolling::Displacement;
use nalgebra::{DMatrix, DVector};

/// Linearized load at a deflection.
#[derive(Clone, Debug, Default)]
pub struct Tangent {
    /// Symmetric part of the stiffness by deflections, with an addition that keeps steps short.
    pub stiffness: BearingMatrix,
    /// Force on the first race at zero deflection of the linearized bearing, N and N m.
    pub load: [f64; 6],
    /// Rollers on an elastic raceway; stiffness and load are those after its elimination.
    pub raceway: Option<RacewayTangent>,
}

/// Linearized rollers on an elastic raceway, which is eliminated.
#[derive(Clone, Debug)]
pub struct RacewayTangent {
    /// `M` of [`super::raceway`].
    pub(super) release: DMatrix<f64>,
    /// `c` and `B`, with deflections of the first race.
    pub(super) load: DVector<f64>,
    pub(super) coupling: DMatrix<f64>,
    /// `K M`, symmetric.
    pub(super) stiffness: DMatrix<f64>,
}

impl Tangent {
    /// Returns the linearized load on the first race at a deflection.
    pub fn load_at(&self, deflection: &Displacement) -> [f64; 5] {
        std::array::from_fn(|i| {
            let sprung: f64 = (0..5).map(|j| self.stiffness[i][j] * deflection[j]).sum();
            sprung - self.load[i]
        })
    }
}

impl RacewayTangent {
    /// Returns the stiffness of the rollers by displacements of the raceway.
    pub fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// Returns the loads on the raceway by deflections of the bearing.
    pub fn coupling(&self) -> DMatrix<f64> {
        self.release.transpose() * &self.coupling
    }

    /// Returns the loads on the raceway without deflection and displacement.
    pub fn load(&self) -> DVector<f64> {
        self.release.transpose() * &self.load
    }

    /// Returns the linearized loads of the rollers on the raceway at a deflection; `moved` is the
    /// displacement of the raceway by forces of teeth.
    pub fn load_at(&self, deflection: &[f64; 5], moved: &[f64]) -> Vec<f64> {
        let load = &self.load + &self.coupling * DVector::from_row_slice(deflection);
        let on = self.release.transpose() * load - &self.stiffness * DVector::from_row_slice(moved);
        on.as_slice().to_vec()
    }

    /// Returns the increase of the load on the first race by the displacement of the raceway by
    /// forces of teeth.
    pub fn push_of(&self, moved: &[f64]) -> [f64; 5] {
        let by = self.coupling.transpose() * (&self.release * DVector::from_row_slice(moved));
        std::array::from_fn(|k| -by[k])
    }
}
