//! One position in equilibrium, or a step in time: teeth that may touch are found, grids laid, the contact problem solved.
//!
//! All of this is the same in the plane and in space, and stands in [`places`] and [`cells`]; what has a dimension (where bodies are, how
//! surfaces approach, what grids and compliances are made of) is behind [`space::Space`], once in [`plane`] and once in [`solid`].

mod cells;
mod drag;
mod drift;
mod patch;
mod places;
mod plane;
mod solid;
mod space;

pub use patch::{Patch, PatchGrid};

use crate::modal::Elastic;
use crate::system::{Bodies, System};
use crate::vibrations::Vibrations;
use calyx_contact::problem::{Certificate, ContactProblem};
use calyx_model::bearing::Springs;
use calyx_numerics::error::EngineError;
use places::{Conditions, Solver};
use plane::Plane;
use solid::Solid;
use std::sync::{Arc, OnceLock};

/// A solved position. Keeps the contact problem and its active cells, from which sensitivities follow.
#[derive(Clone, Debug)]
pub struct StepResult {
    /// s
    pub time: f64,
    /// Pairs of teeth that touch or may.
    pub patches: Vec<Patch>,
    /// Deviation of every freedom from its prescribed motion, m or rad.
    pub motion: Vec<f64>,
    /// The part of it after which contact was laid out: nothing, unless teeth may touch on both sides with backlash between, or the
    /// load carries bodies off the grids that would lie where their frames are without load.
    pub start: Vec<f64>,
    /// What was solved; with modal coordinates the problem that statics has of the same cells.
    pub problem: ContactProblem,
    /// Cells that carry load, by index in the problem.
    pub active: Vec<usize>,
    /// Modal coordinates of the bodies, body after body; empty where no modes are asked for.
    pub modal: Vec<f64>,
    /// Rates of the freedoms and of the modal coordinates, per second; empty in equilibrium.
    pub velocity: Vec<f64>,
    /// What acts on the frame of each body beside contact, bearings and its whole load, in the order of [`calyx_model::freedom::FREEDOMS`]: inertia, and
    /// the part of the load that a step leaves out; N and N m. Empty in equilibrium.
    pub beside: Vec<[f64; 6]>,
    /// The free vibrations about it once somebody has asked for them, see [`crate::observe::Equilibrium::vibrations`].
    pub vibrations: OnceLock<Option<Arc<Vibrations>>>,
    /// Forces on the stops of bearings, whose gaps stand behind those of the patches, and behind them on the flanks of lugs: N, of a plane
    /// model N per metre of face width.
    pub stops: Vec<f64>,
    /// How well it is solved.
    pub certificate: Certificate,
    /// What should be known about the position, in sentences.
    pub warnings: Vec<String>,
}
impl System<'_> {
    /// Brings the scene into equilibrium at a time (s).
    ///
    /// What was solved before makes no difference, not in a bit.
    ///
    /// # Errors
    /// A load is not a number, nothing holds it, the problem is degenerate, or the interrupt's.
    pub fn solve(&self, time: f64) -> Result<StepResult, EngineError> {
        if self.rigid {
            return self.touch(time);
        }
        let load = self.load_at(time)?;
        self.solve_under(time, &load, &load, None)
    }

    /// The scene at a time (s) where its surfaces touch as the load vanishes.
    ///
    /// # Errors
    /// As [`System::solve`].
    pub fn touch(&self, time: f64) -> Result<StepResult, EngineError> {
        self.solve_under(time, &vec![0.0; self.freedoms.len()], &self.load_at(time)?, None)
    }

    /// Under a load, which may be the limit of one in a direction.
    pub fn solve_under(
        &self,
        time: f64,
        load: &[f64],
        direction: &[f64],
        elastic: Option<&Elastic<'_>>,
    ) -> Result<StepResult, EngineError> {
        self.equilibrium(time, load, direction, elastic, None)
    }

    /// The equilibrium in which a motion in time begins: `sizing` is the load that grids are sized for, as those of its steps, for `load` has inertia in it,
    /// and may have nothing else.
    pub fn begin(
        &self,
        time: f64,
        load: &[f64],
        elastic: Option<&Elastic<'_>>,
        sizing: &[f64],
    ) -> Result<StepResult, EngineError> {
        self.equilibrium(time, load, load, elastic, Some(sizing))
    }

    fn equilibrium(
        &self,
        time: f64,
        load: &[f64],
        direction: &[f64],
        elastic: Option<&Elastic<'_>>,
        sizing: Option<&[f64]>,
    ) -> Result<StepResult, EngineError> {
        let springs = &self.springs_at(time)?;
        let load: Vec<f64> = load.iter().zip(&springs.load).map(|(load, own)| load + own).collect();
        let under = Conditions { direction, springs, start: &[], elastic, sizing, in_time: false };
        match &self.bodies {
            Bodies::Plane(bodies) => {
                Solver { system: self, space: &Plane { system: self, bodies }, under }.solve(time, &load)
            }
            Bodies::Solid(bodies) => {
                Solver { system: self, space: &Solid { system: self, bodies }, under }.solve(time, &load)
            }
        }
    }

    /// The end of a step in time (s) that begins where bodies are off their prescribed motions by `start`: `springs` holds the step's matrix and the stops
    /// as seen from there, `load` what moves the freedoms from there. Its motion is counted from the prescribed one.
    pub fn step(
        &self,
        time: f64,
        springs: &Springs,
        load: &[f64],
        start: &[f64],
        elastic: Option<&Elastic<'_>>,
        sizing: &[f64],
    ) -> Result<StepResult, EngineError> {
        let (direction, sizing) = (sizing, Some(sizing));
        let under = Conditions { direction, springs, start, elastic, sizing, in_time: true };
        match &self.bodies {
            Bodies::Plane(bodies) => {
                Solver { system: self, space: &Plane { system: self, bodies }, under }.take(time, load)
            }
            Bodies::Solid(bodies) => {
                Solver { system: self, space: &Solid { system: self, bodies }, under }.take(time, load)
            }
        }
    }
}
