//! Rolling elements between the races of a bearing: their load is a nonlinear function of the
//! deflection, and contact problems have its tangent.

use super::{Bearing, BearingMatrix};
use calyx_numerics::error::EngineError;
use calyx_rolling::rating::{bearing_capacity, static_safety};
use calyx_rolling::{Displacement, ElementState, Evaluation, Motion, RollingBearing, RollingError, Start};
use nalgebra::{Matrix5, SymmetricEigen, Vector5};

/// Rolling elements of a bearing with rigid rings.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingElements {
    /// Rows of rolling elements.
    pub bearing: RollingBearing,
    /// Speeds of the rings and azimuth of the elements.
    pub motion: Motion,
    /// The inner ring is on the second race.
    is_inverted: bool,
    typical: BearingMatrix,
}

/// Linearized load of rolling elements at a deflection.
#[derive(Clone, Debug, Default)]
pub struct Tangent {
    /// Symmetric part of the stiffness by deflections, with an addition that keeps steps short.
    pub stiffness: BearingMatrix,
    /// Force on the first race at zero deflection of the linearized bearing, N and N m.
    pub load: [f64; 6],
}

/// State of the rolling elements of one bearing in the search for equilibrium.
#[derive(Clone, Debug)]
pub struct RollingState {
    /// Deflection: displacement of the first race relative to the second.
    pub deflection: Displacement,
    /// Load on the first race and stiffness there.
    pub evaluation: Evaluation,
    start: Start,
}

impl RollingElements {
    /// Creates the elements of a bearing from its rows. The inner ring is on the first race.
    ///
    /// # Errors
    /// E0697: an input is not finite, or the bearing without deflection would indent its raceways.
    pub fn new(bearing: RollingBearing, motion: Motion) -> Result<Self, EngineError> {
        let mut elements = Self { bearing, motion, is_inverted: false, typical: [[0.0; 6]; 6] };
        elements.check_preload()?;
        // Tangents on all sides of the clearance together resist all motions that any one resists.
        // At high speed, centrifugal force opens a clearance at the inner ring beyond this reach.
        let (reach, still) = (elements.bearing.reach(), without_speed(&elements.motion));
        for direction in 0..3 {
            for side in [reach, -reach] {
                let mut deflection = [0.0; 5];
                deflection[direction] = side;
                let mut start = Start::default();
                let at =
                    elements.bearing.evaluate(&deflection, &still, &mut start).map_err(rejected)?.stiffness;
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

    /// Moves the inner ring to the second race.
    pub fn inverted(self) -> Self {
        Self { is_inverted: !self.is_inverted, ..self }
    }

    /// Returns half of the largest pitch diameter, m, which makes moments comparable with forces.
    pub fn radius(&self) -> f64 {
        self.bearing.rows().iter().map(|row| 0.5 * row.pitch_diameter()).fold(0.0, f64::max)
    }

    /// Returns whether the elements carry load without deflection.
    pub fn is_preloaded(&self) -> bool {
        self.state([0.0; 5]).is_ok_and(|state| state.evaluation.scale > 0.0)
    }

    /// Returns whether the elements resist displacements of the first race to +z and to -z.
    pub fn axial_supports(&self) -> [bool; 2] {
        let [positive, negative] = self.bearing.axial_supports();
        if self.is_inverted { [negative, positive] } else { [positive, negative] }
    }

    /// Returns the static load rating of all rows, N.
    pub fn static_rating(&self) -> f64 {
        bearing_capacity(&self.bearing).static_load
    }

    /// Returns warnings about the elements at a deflection, each the end of a sentence about the
    /// bearing. They state no values, so that all positions of an analysis have the same ones.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn warnings(&self, deflection: &[f64; 6]) -> Result<Vec<&'static str>, EngineError> {
        let states = self.elements(deflection)?;
        let mut found = Vec::new();
        if static_safety(&states) < 1.0 {
            found.push(match states.first().and_then(ElementState::ball) {
                Some(_) => {
                    "indents its raceways: the contact pressure exceeds 4200 MPa, the limit of ISO 76 for balls; \
                     `gears.bearing_static_safety` is below 1"
                }
                None => {
                    "indents its raceways: the contact pressure exceeds 4000 MPa, the limit of ISO 76 for rollers; \
                     `gears.bearing_static_safety` is below 1"
                }
            });
        }
        if self.bearing.is_loaded_on_opposite_flanks(&states) {
            found.push(
                "carries axial force against its `thrust`: balls touch the flanks opposite to the contact angle, where a real \
                 angular contact bearing has no groove; reverse `thrust` or add a bearing for this sense",
            );
        }
        Ok(found)
    }

    /// Rejects preload and centrifugal force whose pressure exceeds the limit of ISO 76 without any
    /// deflection.
    fn check_preload(&self) -> Result<(), EngineError> {
        let state = |motion: &Motion| self.bearing.elements(&[0.0; 5], motion).map_err(rejected);
        let elements = state(&self.motion)?;
        if static_safety(&elements) >= 1.0 {
            return Ok(());
        }
        let pressure = 1e-6 * elements.iter().map(ElementState::pressure).fold(0.0, f64::max);
        if static_safety(&state(&without_speed(&self.motion))?) >= 1.0 {
            let Motion { inner_speed, outer_speed, .. } = self.motion;
            let inner = inner_speed.abs() >= outer_speed.abs();
            return Err(EngineError::new(
                "E0697",
                format!(
                    "the centrifugal force of the elements indents the outer raceway: without external load the pressure is {pressure:.0} MPa"
                ),
                "reduce the speed of the rings, and check its unit",
            )
            .blame(if inner { "inner_speed" } else { "outer_speed" }));
        }
        Err(EngineError::new(
            "E0697",
            format!(
                "the bearing indents its raceways: without external load the pressure is {pressure:.0} MPa"
            ),
            "reduce the preload, which is usually some micrometres",
        ))
    }

    /// Evaluates the elements at a deflection.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn state(&self, deflection: Displacement) -> Result<RollingState, EngineError> {
        self.evaluate(deflection, Start::default())
    }

    /// Evaluates the elements at another deflection, starting from a state.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn moved(&self, from: &RollingState, deflection: Displacement) -> Result<RollingState, EngineError> {
        self.evaluate(deflection, from.start.clone())
    }

    fn evaluate(&self, deflection: Displacement, mut start: Start) -> Result<RollingState, EngineError> {
        let inner = self.of_inner_ring(deflection);
        let mut evaluation = self.bearing.evaluate(&inner, &self.motion, &mut start).map_err(rejected)?;
        evaluation.load = self.of_inner_ring(evaluation.load);
        Ok(RollingState { deflection, evaluation, start })
    }

    /// Converts a displacement or load of the first race to that of the inner ring, or back.
    fn of_inner_ring(&self, components: [f64; 5]) -> [f64; 5] {
        if self.is_inverted { components.map(|part| -part) } else { components }
    }

    /// Returns the states of all elements at a deflection.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn elements(&self, deflection: &[f64; 6]) -> Result<Vec<ElementState>, EngineError> {
        self.bearing.elements(&self.of_inner_ring(five(deflection)), &self.motion).map_err(rejected)
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

impl Tangent {
    /// Returns the linearized load on the first race at a deflection.
    pub fn load_at(&self, deflection: &Displacement) -> [f64; 5] {
        std::array::from_fn(|i| {
            let sprung: f64 = (0..5).map(|j| self.stiffness[i][j] * deflection[j]).sum();
            sprung - self.load[i]
        })
    }
}

impl RollingState {
    /// Linearizes the load, with `addition` times the typical stiffness added about this state.
    ///
    /// The stiffness is symmetric and positive semidefinite: gyroscopic moments make that of balls
    /// slightly asymmetric, and large tilting under load can make it indefinite.
    pub fn tangent(&self, elements: &RollingElements, addition: f64) -> Tangent {
        let at = positive_part(&self.evaluation.stiffness, elements.radius());
        let mut tangent = Tangent::default();
        for i in 0..5 {
            for j in 0..5 {
                tangent.stiffness[i][j] = at[(i, j)] + addition * elements.typical[i][j];
                tangent.load[i] += tangent.stiffness[i][j] * self.deflection[j];
            }
            tangent.load[i] -= self.evaluation.load[i];
        }
        tangent
    }
}

fn without_speed(motion: &Motion) -> Motion {
    Motion { inner_speed: 0.0, outer_speed: 0.0, ..*motion }
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
