//! Rolling elements between the races of a bearing: their load is a nonlinear function of the
//! deflection, and the contact problem has its tangent.

use super::{Bearing, BearingMatrix};
use calyx_numerics::error::EngineError;
use calyx_rolling::{Displacement, ElementState, Evaluation, Motion, RollingBearing, RollingError, Start};

/// Rolling elements of a bearing with rigid rings. The inner ring is on the first race.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingElements {
    /// Rows of rolling elements.
    pub bearing: RollingBearing,
    /// Speeds of the rings and azimuth of the elements.
    pub motion: Motion,
    typical: BearingMatrix,
}

/// Linearized load of rolling elements at a deflection.
#[derive(Clone, Debug)]
pub struct Tangent {
    /// Symmetric part of the stiffness by deflections, with an addition that keeps steps short.
    pub stiffness: BearingMatrix,
    /// Force on the first race at zero deflection of the linearized bearing, N and N m.
    pub load: [f64; 6],
}

/// State of the rolling elements of one bearing in the search for equilibrium.
#[derive(Clone, Debug)]
pub struct RollingState {
    /// Deflection: displacement of the inner ring.
    pub deflection: Displacement,
    /// Load and stiffness there.
    pub evaluation: Evaluation,
    start: Start,
}

impl RollingElements {
    /// Creates the elements of a bearing from its rows.
    ///
    /// # Errors
    /// E0697: an element has no equilibrium, or an input is not finite.
    pub fn new(bearing: RollingBearing, motion: Motion) -> Result<Self, EngineError> {
        let mut elements = Self { bearing, motion, typical: [[0.0; 6]; 6] };
        // Tangents on all sides of the clearance together resist all motions that any one resists.
        let reach = elements.bearing.reach();
        for direction in 0..3 {
            for side in [reach, -reach] {
                let mut deflection = [0.0; 5];
                deflection[direction] = side;
                let at = elements.state(deflection)?.evaluation.stiffness;
                for i in 0..5 {
                    for j in 0..5 {
                        elements.typical[i][j] += 0.5 * (at[i][j] + at[j][i]) / 6.0;
                    }
                }
            }
        }
        Ok(elements)
    }

    /// Returns the mean stiffness on all sides of the clearance, which restrains the bearing in the
    /// directions that the elements support.
    pub fn typical_stiffness(&self) -> &BearingMatrix {
        &self.typical
    }

    /// Evaluates the elements at a deflection.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn state(&self, deflection: Displacement) -> Result<RollingState, EngineError> {
        let mut start = Start::default();
        let evaluation = self.bearing.evaluate(&deflection, &self.motion, &mut start).map_err(rejected)?;
        Ok(RollingState { deflection, evaluation, start })
    }

    /// Evaluates the elements at another deflection, starting from a state.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn moved(&self, from: &RollingState, deflection: Displacement) -> Result<RollingState, EngineError> {
        let mut start = from.start.clone();
        let evaluation = self.bearing.evaluate(&deflection, &self.motion, &mut start).map_err(rejected)?;
        Ok(RollingState { deflection, evaluation, start })
    }

    /// Returns the states of all elements at a deflection.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn elements(&self, deflection: &[f64; 6]) -> Result<Vec<ElementState>, EngineError> {
        self.bearing.elements(&five(deflection), &self.motion).map_err(rejected)
    }

    /// Returns force and moment of the elements on the first race at a deflection, N and N m; NaN
    /// if the deflection is not finite.
    pub fn push(&self, deflection: &[f64; 6]) -> [f64; 6] {
        match self.state(five(deflection)) {
            Ok(state) => six(&state.evaluation.load.map(|load| -load)),
            Err(_) => [f64::NAN; 6],
        }
    }
}

impl RollingState {
    /// Linearizes the load, with `addition` times the typical stiffness added about this state.
    pub fn tangent(&self, elements: &RollingElements, addition: f64) -> Tangent {
        let at = &self.evaluation.stiffness;
        let mut tangent = Tangent { stiffness: [[0.0; 6]; 6], load: [0.0; 6] };
        for i in 0..5 {
            for j in 0..5 {
                tangent.stiffness[i][j] = 0.5 * (at[i][j] + at[j][i]) + addition * elements.typical[i][j];
                tangent.load[i] += tangent.stiffness[i][j] * self.deflection[j];
            }
            tangent.load[i] -= self.evaluation.load[i];
        }
        tangent
    }
}

impl Bearing {
    /// Returns the linearized rolling elements before their deflection is known: typical stiffness
    /// without load.
    pub(super) fn typical_tangent(&self) -> Option<Tangent> {
        let elements = self.rolling.as_ref()?;
        Some(Tangent { stiffness: *elements.typical_stiffness(), load: [0.0; 6] })
    }
}

/// Returns the components of a deflection without the rotation about the axis.
pub fn five([x, y, z, about_x, about_y, _]: &[f64; 6]) -> Displacement {
    [*x, *y, *z, *about_x, *about_y]
}

fn six([x, y, z, about_x, about_y]: &[f64; 5]) -> [f64; 6] {
    [*x, *y, *z, *about_x, *about_y, 0.0]
}

/// Returns the error of the engine for one of a rolling bearing.
pub fn rejected(error: RollingError) -> EngineError {
    EngineError::new("E0697", error.to_string(), error.help().to_owned())
}
