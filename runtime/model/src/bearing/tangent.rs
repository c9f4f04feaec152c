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
    /// Elements on elastic raceways; stiffness and load are those after their elimination.
    pub raceway: Option<RacewayTangent>,
}

/// Linearized elements on elastic raceways, which are eliminated.
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
    /// Returns the stiffness of the elements by displacements of the raceways.
    pub fn stiffness(&self) -> &DMatrix<f64> {
        &self.stiffness
    }

    /// Returns the loads on the raceways by deflections of the bearing.
    pub fn coupling(&self) -> DMatrix<f64> {
        self.release.transpose() * &self.coupling
    }

    /// Returns the loads on the raceways without deflection and displacement.
    pub fn load(&self) -> DVector<f64> {
        self.release.transpose() * &self.load
    }

    /// Returns the linearized loads of the elements on the raceways at a deflection; `moved` is the
    /// displacement of the raceways by forces of teeth and of seats.
    pub fn load_at(&self, deflection: &[f64; 5], moved: &[f64]) -> Vec<f64> {
        let load = &self.load + &self.coupling * DVector::from_row_slice(deflection);
        let on = self.release.transpose() * load - &self.stiffness * DVector::from_row_slice(moved);
        on.as_slice().to_vec()
    }

    /// Returns the increase of the load on the first race by the displacement of the raceways by
    /// forces of teeth and of seats.
    pub fn push_of(&self, moved: &[f64]) -> [f64; 5] {
        let by = self.coupling.transpose() * (&self.release * DVector::from_row_slice(moved));
        std::array::from_fn(|k| -by[k])
    }
}
