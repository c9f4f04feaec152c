//! Rolling elements between the races of a bearing, whose load is a nonlinear function of the
//! deflection.

use super::BearingMatrix;
use super::nonlinear_state::NonlinearState;
use calyx_numerics::error::EngineError;
use calyx_rolling::ball::BallState;
use calyx_rolling::rating::{LoadDirection, bearing_capacity, static_safety};
use calyx_rolling::{
    ContactModel, Displacement, ElasticContact, ElementState, Motion, RacewayDisplacement, RollingBearing,
    RollingError, Start,
};
use std::sync::{Arc, OnceLock};

/// Coefficient of friction at the outer race beyond which balls do not withstand their gyroscopic
/// moment: that of boundary lubrication.
const GYROSCOPIC_FRICTION: f64 = 0.1;

/// Rolling elements of a bearing.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingElements {
    /// Rows of rolling elements.
    pub bearing: RollingBearing,
    /// Speeds of the rings and azimuth of the elements.
    pub motion: Motion,
    /// The inner ring is on the second race.
    is_inverted: bool,
    typical: BearingMatrix,
    elastic: ElasticRollers,
    /// Displacement of elastic raceways by element; empty between rigid ones.
    raceway: Arc<[RacewayDisplacement]>,
}

/// The same elements with elastic contacts of rollers, computed on request. Copies have their own,
/// because their motion may change.
#[derive(Debug, Default)]
struct ElasticRollers(OnceLock<Arc<RollingElements>>);

impl Clone for ElasticRollers {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for ElasticRollers {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl RollingElements {
    /// Creates the elements of a bearing from its rows. The inner ring is on the first race.
    ///
    /// # Errors
    /// E0697: an input is not finite, or the bearing without deflection would indent its raceways.
    pub fn new(bearing: RollingBearing, motion: Motion) -> Result<Self, EngineError> {
        let mut elements = Self {
            bearing,
            motion,
            is_inverted: false,
            typical: [[0.0; 6]; 6],
            elastic: ElasticRollers::default(),
            raceway: Arc::default(),
        };
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

    /// Returns the elements with elastic contacts of rollers; balls have Hertz's solution anyway.
    pub fn with_elastic_rollers(self: &Arc<Self>) -> Arc<Self> {
        if !self.bearing.has_rollers() {
            return self.clone();
        }
        let model = ContactModel::Elastic(ElasticContact::default());
        let build = || match self.bearing.with_contact(model) {
            Ok(bearing) => Arc::new(Self { bearing, ..self.as_ref().clone() }),
            Err(_) => self.clone(),
        };
        self.elastic.0.get_or_init(build).clone()
    }

    /// Returns the displacement of elastic raceways by element; empty between rigid ones.
    pub(super) fn raceway(&self) -> &[RacewayDisplacement] {
        &self.raceway
    }

    /// Returns the elements between raceways of elastic bodies with this displacement at each
    /// element.
    pub fn on_raceway(&self, displacement: &[RacewayDisplacement]) -> Self {
        Self { raceway: displacement.into(), ..self.clone() }
    }

    /// Returns the mean stiffness on all sides of the clearance, which restrains the bearing in the
    /// directions that the elements support.
    pub fn typical_stiffness(&self) -> &BearingMatrix {
        &self.typical
    }

    /// Returns whether the elements orbit.
    pub fn orbit(&self) -> bool {
        self.cage_speed() != 0.0
    }

    /// Returns the elements at a time, s: they have orbited with their cage since time 0. `None` if
    /// they do not orbit.
    pub fn at_time(&self, time: f64) -> Option<Self> {
        let azimuth = self.motion.azimuth + self.cage_speed() * time;
        self.orbit().then(|| Self { motion: Motion { azimuth, ..self.motion }, ..self.clone() })
    }

    /// Returns the orbital speed of the elements, rad/s. Rows of a bearing orbit alike.
    fn cage_speed(&self) -> f64 {
        self.bearing.rows().first().map_or(0.0, |row| row.cage_speed(&self.motion))
    }

    /// Moves the inner ring to the second race.
    pub fn inverted(self) -> Self {
        Self { is_inverted: !self.is_inverted, ..self }
    }

    /// Returns whether the inner ring is on the second race, as of a planet on its pin.
    pub fn is_inverted(&self) -> bool {
        self.is_inverted
    }

    /// Returns the ring relative to which the load is steady if a model does not state it: the one
    /// without a speed, if the other has one, or else the ring on the second race: the housing of a
    /// shaft, the pin of a planet.
    pub fn load_direction(&self) -> LoadDirection {
        let is_outer_rotating = match (self.motion.inner_speed != 0.0, self.motion.outer_speed != 0.0) {
            (true, false) => false,
            (false, true) => true,
            _ => self.is_inverted,
        };
        if is_outer_rotating { LoadDirection::InnerRing } else { LoadDirection::OuterRing }
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
    pub fn warnings(
        &self,
        deflection: &[f64; 6],
        known: Option<&NonlinearState>,
    ) -> Result<Vec<&'static str>, EngineError> {
        let states = self.elements(deflection, known)?;
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
        let slides = |ball: &BallState| {
            let load: f64 = ball.outer.iter().map(|contact| contact.load).sum();
            ball.friction > GYROSCOPIC_FRICTION * load
        };
        if states.iter().filter_map(ElementState::ball).any(slides) {
            found.push(
                "has balls whose gyroscopic moment exceeds the friction at the outer race at a coefficient of friction of 0.1: they \
                 would rotate about the contact; increase the preload or reduce the speed",
            );
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
    pub fn state(&self, deflection: Displacement) -> Result<NonlinearState, EngineError> {
        self.evaluate(deflection, &self.raceway, Start::default())
    }

    /// Evaluates the elements at a deflection and a displacement of the raceways from the
    /// positions of another evaluation.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub(super) fn evaluate(
        &self,
        deflection: Displacement,
        raceway: &[RacewayDisplacement],
        mut start: Start,
    ) -> Result<NonlinearState, EngineError> {
        let inner = self.of_inner_ring(deflection);
        let evaluated = self.bearing.evaluate_with(&inner, raceway, &self.motion, &mut start);
        let (mut evaluation, raceway_loads) = evaluated.map_err(rejected)?;
        evaluation.load = self.of_inner_ring(evaluation.load);
        Ok(NonlinearState { deflection, evaluation, raceway: raceway.to_vec(), raceway_loads, start })
    }

    /// Converts a displacement or load of the first race to that of the inner ring, or back.
    pub(super) fn of_inner_ring(&self, components: [f64; 5]) -> [f64; 5] {
        if self.is_inverted { components.map(|part| -part) } else { components }
    }

    /// Returns the states of all elements at a deflection, from an evaluation there if it is known.
    ///
    /// # Errors
    /// E0697: the deflection is not finite.
    pub fn elements(
        &self,
        deflection: &[f64; 6],
        known: Option<&NonlinearState>,
    ) -> Result<Vec<ElementState>, EngineError> {
        let inner = self.of_inner_ring(five(deflection));
        let none = Start::default();
        let start = known.map_or(&none, |known| &known.start);
        self.bearing.elements_with(&inner, &self.raceway, &self.motion, start).map_err(rejected)
    }
}

fn without_speed(motion: &Motion) -> Motion {
    Motion { inner_speed: 0.0, outer_speed: 0.0, ..*motion }
}

/// Returns the components of a deflection without the rotation about the axis.
pub fn five([x, y, z, about_x, about_y, _]: &[f64; 6]) -> Displacement {
    [*x, *y, *z, *about_x, *about_y]
}

/// Returns the error of the engine for one of a rolling bearing.
pub fn rejected(error: RollingError) -> EngineError {
    EngineError::new("E0697", error.to_string(), error.help().to_owned())
}
