//! Whirl modes of rotating systems about an equilibrium: frequencies with gyroscopic terms, their
//! sense, and their variation with the speeds (Campbell diagram).

use super::{Equilibrium, ModesRequest, ModesTable, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::motion::angular_velocity;
use calyx_model::observed::Observed;
use calyx_numerics::vec3::length;
use calyx_solve::vibrations::WhirlModes;
use std::f64::consts::TAU;
use std::sync::Arc;

impl Equilibrium<'_> {
    /// Returns the whirl modes about the equilibrium at the prescribed speeds, computed once per
    /// position; `None` if a DOF has no inertia or nothing vibrates.
    pub fn whirl(self) -> Option<Arc<WhirlModes>> {
        self.vibrations()?.whirl()
    }
}

/// Whirl frequency of the scene about its equilibrium at the prescribed speeds, Hz; number 0 is the
/// lowest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhirlFrequency(pub usize);

impl Observable for WhirlFrequency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("whirl_frequency", "Hz")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let found = at.whirl().and_then(|all| all.frequencies.get(self.0).copied());
        Observed::number(found.map_or(f64::NAN, |omega| omega / TAU))
    }
}

/// Sense of whirl of a mode, from -1 (backward) to 1 (forward), see [`WhirlModes::senses`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WhirlSense(pub usize);

impl Observable for WhirlSense {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("whirl_sense", "1")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let found = at.whirl().and_then(|all| all.senses.get(self.0).copied());
        Observed::number(found.unwrap_or(f64::NAN))
    }
}

/// Request for a Campbell diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct CampbellRequest {
    /// Body whose speed is the abscissa. All speeds are proportional to it.
    pub body: BodyId,
    /// Highest speed of this body, rad/s.
    pub highest_speed: f64,
    /// Number of speeds, from 0 to the highest, at equal distances; at least two.
    pub speeds: usize,
    /// Number of modes, from the lowest; `None` for all.
    pub modes: Option<usize>,
}

/// Whirl modes about a position over speed.
#[derive(Clone, Debug, PartialEq)]
pub struct CampbellDiagram {
    /// Name of the body whose speed is the abscissa.
    pub body: String,
    /// Points by speed, then by mode.
    pub points: Vec<CampbellPoint>,
}

/// Mode at a speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CampbellPoint {
    /// Speed of the body, rad/s.
    pub speed: f64,
    /// Index of the mode at this speed, from the lowest frequency, from 0.
    pub mode: usize,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Sense of whirl from -1 to 1.
    pub sense: f64,
}

impl Equilibrium<'_> {
    /// Computes the requested table of modes and Campbell diagram, as far as they exist.
    pub fn requested_modes(
        self,
        modes: Option<&ModesRequest>,
        campbell: Option<&CampbellRequest>,
    ) -> (Option<ModesTable>, Option<CampbellDiagram>) {
        let modes = modes.and_then(|request| self.modes_table(request));
        (modes, campbell.and_then(|request| self.campbell_diagram(request)))
    }

    /// Computes the requested Campbell diagram. The equilibrium is that of the position at all
    /// speeds. `None` if nothing vibrates, or if the body does not rotate.
    pub fn campbell_diagram(self, request: &CampbellRequest) -> Option<CampbellDiagram> {
        let vibrations = self.vibrations()?;
        let body = &self.system.scene.bodies[request.body.0];
        let own = length(angular_velocity(body.motion.as_ref(), self.time()));
        let mut points = Vec::new();
        for step in 0..request.speeds {
            let speed = request.highest_speed * (step as f64 / (request.speeds - 1).max(1) as f64);
            let factor = speed / own;
            let whirl = factor.is_finite().then(|| vibrations.whirl_at(factor)).flatten()?;
            let modes = whirl.frequencies.iter().zip(&whirl.senses).enumerate();
            points.extend(modes.take(request.modes.unwrap_or(usize::MAX)).map(
                |(mode, (frequency, sense))| CampbellPoint {
                    speed,
                    mode,
                    frequency: frequency / TAU,
                    sense: *sense,
                },
            ));
        }
        Some(CampbellDiagram { body: body.name.clone(), points })
    }
}
