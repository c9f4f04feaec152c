//! Nonlinear loads of bearings by their deflection: rolling elements and load curves. Contact
//! problems have their tangents.

use super::nonlinear_state::NonlinearState;
use super::raceway::ElasticRaceways;
use super::tangent::Tangent;
use super::{Bearing, BearingMatrix, LoadCurves, RollingElements, five};
use calyx_numerics::error::EngineError;
use calyx_rolling::{Displacement, RacewayDisplacement, Start};
use nalgebra::{Matrix5, SymmetricEigen, Vector5};
use std::sync::Arc;

/// Nonlinear load of a bearing.
#[derive(Clone, Debug, PartialEq)]
pub enum NonlinearLoad {
    /// Rolling elements.
    Rolling(Arc<RollingElements>),
    /// Tables of force over displacement.
    Curves(Arc<LoadCurves>),
}

impl NonlinearLoad {
    /// Returns the load at a time, s, at which rolling elements have orbited with their cage.
    pub fn at_time(&self, time: f64) -> Self {
        match self {
            NonlinearLoad::Rolling(elements) => match elements.at_time(time) {
                Some(moved) => NonlinearLoad::Rolling(Arc::new(moved)),
                None => self.clone(),
            },
            NonlinearLoad::Curves(_) => self.clone(),
        }
    }

    /// Returns the load with elastic contacts of rollers.
    pub fn with_elastic_rollers(&self) -> Self {
        match self {
            NonlinearLoad::Rolling(elements) => NonlinearLoad::Rolling(elements.with_elastic_rollers()),
            NonlinearLoad::Curves(_) => self.clone(),
        }
    }

    /// Returns a mean stiffness, which restrains the bearing in the directions that it supports.
    pub fn typical_stiffness(&self) -> BearingMatrix {
        match self {
            NonlinearLoad::Rolling(elements) => *elements.typical_stiffness(),
            NonlinearLoad::Curves(curves) => curves.typical_stiffness(),
        }
    }

    /// Returns a length that makes moments comparable with forces, m.
    pub fn radius(&self) -> f64 {
        match self {
            NonlinearLoad::Rolling(elements) => elements.radius(),
            // Curves have no moments.
            NonlinearLoad::Curves(curves) => curves.reach(),
        }
    }

    /// Returns a displacement of the order of those under load, m.
    pub fn reach(&self) -> f64 {
        match self {
            NonlinearLoad::Rolling(elements) => elements.bearing.reach(),
            NonlinearLoad::Curves(curves) => curves.reach(),
        }
    }

    /// Returns whether the bearing carries load without deflection.
    pub fn is_preloaded(&self) -> bool {
        match self {
            NonlinearLoad::Rolling(elements) => elements.is_preloaded(),
            NonlinearLoad::Curves(curves) => curves.is_preloaded(),
        }
    }

    /// Returns the static load rating of rolling elements, or the largest force of curves, N.
    pub fn highest_load(&self) -> f64 {
        match self {
            NonlinearLoad::Rolling(elements) => elements.static_rating(),
            NonlinearLoad::Curves(curves) => curves.largest_force(),
        }
    }

    /// Returns whether displacements of the first race to +z and to -z are resisted.
    pub fn axial_supports(&self) -> [bool; 2] {
        match self {
            NonlinearLoad::Rolling(elements) => elements.axial_supports(),
            NonlinearLoad::Curves(curves) => curves.axial_supports(),
        }
    }

    /// Returns warnings about a deflection, each the end of a sentence about the bearing. `known`
    /// is the state there, if it has been evaluated.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn warnings(
        &self,
        deflection: &[f64; 6],
        known: Option<&NonlinearState>,
    ) -> Result<Vec<&'static str>, EngineError> {
        match self {
            NonlinearLoad::Rolling(elements) => elements.warnings(deflection, known),
            NonlinearLoad::Curves(curves) => Ok(curves.warnings(&five(deflection))),
        }
    }

    /// Evaluates the load at a deflection, starting from a state if there is one.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn state(
        &self,
        from: Option<&NonlinearState>,
        deflection: Displacement,
    ) -> Result<NonlinearState, EngineError> {
        match self {
            NonlinearLoad::Rolling(elements) => {
                let start = from.map_or_else(Start::default, |from| from.start.clone());
                elements.evaluate(deflection, elements.raceway(), start)
            }
            NonlinearLoad::Curves(curves) => curves.state(deflection),
        }
    }

    /// Evaluates the load like [`NonlinearLoad::state`] with a displacement of elastic raceways, by
    /// element.
    ///
    /// # Errors
    /// Those of [`NonlinearLoad::state`].
    pub fn state_on(
        &self,
        from: &NonlinearState,
        deflection: Displacement,
        raceway: &[RacewayDisplacement],
    ) -> Result<NonlinearState, EngineError> {
        match self {
            NonlinearLoad::Rolling(elements) => elements.evaluate(deflection, raceway, from.start.clone()),
            NonlinearLoad::Curves(curves) => curves.state(deflection),
        }
    }

    /// Returns the load between raceways with this displacement at each element.
    pub fn on_raceway(&self, displacement: &[RacewayDisplacement]) -> Self {
        match self {
            NonlinearLoad::Rolling(elements) => {
                NonlinearLoad::Rolling(Arc::new(elements.on_raceway(displacement)))
            }
            NonlinearLoad::Curves(_) => self.clone(),
        }
    }

    /// Returns force and moment on the first race at a deflection, N and N m; NaN if the deflection
    /// is not finite.
    pub fn push(&self, deflection: &[f64; 6]) -> [f64; 6] {
        self.state(None, five(deflection)).map_or([f64::NAN; 6], |state| state.push())
    }

    /// Returns the tangent without deflection if it supports what the load supports: that of curves
    /// without clearance. Rolling elements have hardly any stiffness there.
    pub fn unloaded_tangent(&self) -> Option<Tangent> {
        let NonlinearLoad::Curves(curves) = self else { return None };
        let tangent = self.tangent(&curves.state([0.0; 5]).ok()?, 0.0);
        let typical = self.typical_stiffness();
        let supports = (0..3).all(|k| typical[k][k] == 0.0 || tangent.stiffness[k][k] > 0.0);
        supports.then_some(tangent)
    }

    /// Linearizes the load about a state, with `addition` times the typical stiffness added.
    ///
    /// The stiffness is symmetric and positive semidefinite: gyroscopic moments make that of balls
    /// slightly asymmetric, and large tilting under load can make it indefinite. Elastic
    /// raceways are eliminated.
    pub fn tangent_with(
        &self,
        state: &NonlinearState,
        addition: f64,
        raceway: Option<&ElasticRaceways>,
    ) -> Tangent {
        let mut tangent = self.tangent(state, addition);
        if let (Some(raceway), NonlinearLoad::Rolling(elements)) = (raceway, self) {
            raceway.eliminate(&mut tangent, state, if elements.is_inverted() { -1.0 } else { 1.0 });
        }
        tangent
    }

    /// Linearizes the load about a state as [`NonlinearLoad::tangent_with`], between raceways
    /// that do not yield.
    pub fn tangent(&self, state: &NonlinearState, addition: f64) -> Tangent {
        let at = positive_part(&state.evaluation.stiffness, self.radius());
        let typical = self.typical_stiffness();
        let mut tangent = Tangent::default();
        for i in 0..5 {
            for j in 0..5 {
                tangent.stiffness[i][j] = at[(i, j)] + addition * typical[i][j];
                tangent.load[i] += tangent.stiffness[i][j] * state.deflection[j];
            }
            tangent.load[i] -= state.evaluation.load[i];
        }
        tangent
    }
}

impl Bearing {
    /// Returns the rolling elements, if any.
    pub fn rolling(&self) -> Option<&Arc<RollingElements>> {
        match &self.nonlinear {
            Some(NonlinearLoad::Rolling(elements)) => Some(elements),
            Some(NonlinearLoad::Curves(_)) | None => None,
        }
    }

    /// Returns the linearized load before the deflection is known: typical stiffness without load.
    pub(super) fn typical_tangent(&self) -> Option<Tangent> {
        let nonlinear = self.nonlinear.as_ref()?;
        Some(Tangent { stiffness: nonlinear.typical_stiffness(), ..Tangent::default() })
    }
}

/// Returns the symmetric part of a stiffness without its negative eigenvalues. Rotations are
/// compared with displacements at a radius, m.
fn positive_part(stiffness: &[[f64; 5]; 5], radius: f64) -> Matrix5<f64> {
    let symmetric = Matrix5::from_fn(|i, j| 0.5 * (stiffness[i][j] + stiffness[j][i]));
    let lengths = Vector5::from_fn(|i, _| if i < 3 { 1.0 } else { radius });
    let scaled = Matrix5::from_fn(|i, j| symmetric[(i, j)] / (lengths[i] * lengths[j]));
    if !scaled.iter().all(|entry| entry.is_finite()) {
        return symmetric;
    }
    let eigen = SymmetricEigen::new(scaled);
    if eigen.eigenvalues.min() >= -1e-12 * eigen.eigenvalues.max() {
        return symmetric;
    }
    let kept = eigen.eigenvalues.map(|value| value.max(0.0));
    let positive = eigen.eigenvectors * Matrix5::from_diagonal(&kept) * eigen.eigenvectors.transpose();
    Matrix5::from_fn(|i, j| 0.5 * (positive[(i, j)] + positive[(j, i)]) * lengths[i] * lengths[j])
}
