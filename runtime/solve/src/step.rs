//! Solution of one position in equilibrium, or of one time step: search for contact, grids, contact
//! problem.
//!
//! The procedure is common to plane and three-dimensional models, in [`contact_layout`] and
//! [`contact_solution`]. The dimension-dependent part (positions of bodies, closest approach, grids
//! and compliances) is behind the trait [`contact_geometry::ContactGeometry`], implemented in
//! [`plane`] and [`solid`].
//!
//! See `docs/theory/equilibrium.md`.

mod contact_geometry;
mod contact_layout;
mod contact_solution;
mod contact_state;
mod estimated_position;
mod friction;
mod grid_sizes;
mod grid_warnings;
mod linearized_bearings;
mod nonlinear_bearings;
mod participation;
mod patch;
mod plane;
mod reduced_grids;
mod relinearization;
mod solid;
mod surface_boxes;

pub use contact_state::{ContactState, GridState, PatchCells};
pub use participation::Participating;
pub use patch::{ContactGrid, ContactPatch};

use crate::modal::ModalElimination;
use crate::system::{Bodies, System};
use crate::vibrations::Vibrations;
use calyx_contact::problem::{Certificate, ContactProblem};
use calyx_model::bearing::{NonlinearState, RacewayDisplacement, Springs, Tangent};
use calyx_numerics::error::EngineError;
use contact_layout::{Conditions, Solver};
use nonlinear_bearings::{NonlinearBearings, SeatResponse};
use plane::Plane;
use solid::Solid;
use std::sync::{Arc, OnceLock};

/// Tilt of an axis that causes a warning, rad: the direction of forces changes by half a percent.
const LARGE_TILT: f64 = 5e-3;

/// Solved position. Contains the contact problem and its active set, which provide sensitivities.
#[derive(Clone, Debug)]
pub struct StepResult {
    /// Time, s.
    pub time: f64,
    /// Contact patches of tooth pairs, loaded or not.
    pub patches: Vec<ContactPatch>,
    /// Deviation of every DOF from its prescribed motion, m or rad.
    pub motion: Vec<f64>,
    /// Part of the deviation at which the contact grid was created. It is zero unless teeth may
    /// touch on both flanks with backlash, or the load displaces bodies beyond the grids of their
    /// unloaded position.
    pub start: Vec<f64>,
    /// Contact problem; with modal coordinates the static problem of the same cells.
    pub problem: ContactProblem,
    /// Active set: indices of the loaded cells.
    pub active: Vec<usize>,
    /// Grids that were solved one after the other, of which the last one is that of the solution.
    pub grids: Vec<GridState>,
    /// Number of estimates of the position that preceded them.
    pub estimates: usize,
    /// Modal coordinates, body by body; empty without modes.
    pub modal: Vec<f64>,
    /// Rates of the DOFs and of the modal coordinates, per second; empty in equilibrium.
    pub velocity: Vec<f64>,
    /// Additional forces on the frame of each body besides contact, bearings and its whole load, in
    /// the order of [`calyx_model::dof::DOF_NAMES`]: inertia, and the part of the load that a step
    /// leaves out; N and N m. Empty in equilibrium.
    pub other_loads: Vec<[f64; 6]>,
    /// Free vibrations about the position, computed on request, see [`System::vibrations`].
    pub vibrations: OnceLock<Option<Arc<Vibrations>>>,
    /// Forces on the stops of bearings, whose gap equations follow those of the patches, and then
    /// on the flanks of spline teeth: N, in a plane model N per metre of face width.
    pub stops: Vec<f64>,
    /// Bearings on raceways of elastic bodies.
    pub raceways: Vec<RacewayResult>,
    /// Bearings with a nonlinear load in equilibrium, by their index in the scene.
    pub bearings: Vec<(usize, NonlinearState)>,
    /// Residuals of the contact solution.
    pub certificate: Certificate,
    /// Warnings about the position, in sentences.
    pub warnings: Vec<String>,
}

impl StepResult {
    /// Returns the state of a bearing with a nonlinear load at its deflection in this result;
    /// `None` if it is not known, as at another deflection.
    pub fn bearing_state(&self, bearing: usize, deflection: &[f64; 6]) -> Option<&NonlinearState> {
        let (_, state) = self.bearings.iter().find(|(own, _)| *own == bearing)?;
        state.is_at(deflection).then_some(state)
    }
}

/// Raceways of a bearing in elastic bodies.
#[derive(Clone, Debug)]
pub struct RacewayResult {
    /// Index of the bearing in the scene.
    pub bearing: usize,
    /// Displacement of the outer relative to the inner raceway at each element.
    pub displacement: Vec<RacewayDisplacement>,
    /// Conjugate loads of the elements, three for each: N and N m.
    pub loads: Vec<f64>,
}

impl System<'_> {
    /// Solves the equilibrium of the scene at a time (s).
    ///
    /// The result does not depend on earlier solutions, bit for bit.
    ///
    /// # Errors
    /// A load is NaN, the load meets no resistance, the problem is degenerate, or those of the
    /// interrupt.
    pub fn solve(&self, time: f64) -> Result<StepResult, EngineError> {
        if self.rigid {
            return self.touch(time);
        }
        let load = self.load_at(time)?;
        self.solve_under(time, &load, &load, None)
    }

    /// Solves the equilibrium at a time (s) in a given state of contact: with the cells that carry
    /// force there, as a smooth continuation of a neighbouring scene. Only influence coefficients
    /// between these cells are computed, so that the gaps of others and the certificate have no
    /// meaning. If the patches differ, the state is found as usual; compare it with
    /// [`StepResult::contact_state`].
    ///
    /// # Errors
    /// Those of [`System::solve`].
    pub fn solve_in_state(&self, time: f64, state: &ContactState) -> Result<StepResult, EngineError> {
        if self.rigid {
            return self.touch(time);
        }
        let load = self.load_at(time)?;
        self.equilibrium(time, &load, &load, None, (None, Some(state)))
    }

    /// Computes the rigid-body limit at a time (s): surfaces touch as the load vanishes.
    ///
    /// # Errors
    /// Those of [`System::solve`].
    pub fn touch(&self, time: f64) -> Result<StepResult, EngineError> {
        // Without load, linearized bearings have no deflection.
        let load: Vec<f64> = self.linearized_preload(time)?.iter().map(|load| -load).collect();
        self.solve_under(time, &load, &self.load_at(time)?, None)
    }

    /// Solves under a load, or in the limit of a load along a direction.
    pub fn solve_under(
        &self,
        time: f64,
        load: &[f64],
        direction: &[f64],
        elastic: Option<&ModalElimination<'_>>,
    ) -> Result<StepResult, EngineError> {
        self.equilibrium(time, load, direction, elastic, (None, None))
    }

    /// Solves the initial equilibrium of a transient analysis. `sizing` is the load for the sizes
    /// of grids, as for its steps, because `load` includes inertia and may include nothing else.
    pub fn begin(
        &self,
        time: f64,
        load: &[f64],
        elastic: Option<&ModalElimination<'_>>,
        sizing: &[f64],
    ) -> Result<StepResult, EngineError> {
        self.equilibrium(time, load, load, elastic, (Some(sizing), None))
    }

    fn equilibrium(
        &self,
        time: f64,
        load: &[f64],
        direction: &[f64],
        elastic: Option<&ModalElimination<'_>>,
        (sizing, state): (Option<&[f64]>, Option<&ContactState>),
    ) -> Result<StepResult, EngineError> {
        let solve = |tangents: &[Option<Tangent>],
                     nonlinear: Option<&NonlinearBearings<'_>>,
                     seats: &[SeatResponse]| {
            let mut springs = self.springs_with(time, tangents)?;
            seats.iter().for_each(|seats| seats.add_to(&mut springs.stiffness, &mut springs.load));
            let springs = &springs;
            let load: Vec<f64> = load.iter().zip(&springs.load).map(|(load, own)| load + own).collect();
            let under = Conditions {
                direction,
                springs,
                nonlinear,
                start: &[],
                elastic,
                sizing,
                in_time: false,
                state,
                one_cell_per_slice: false,
            };
            match &self.bodies {
                Bodies::Plane(bodies) => {
                    Solver { system: self, space: &Plane { system: self, bodies }, under }.solve(time, &load)
                }
                Bodies::Solid(bodies) => {
                    Solver { system: self, space: &Solid { system: self, bodies, in_time: false }, under }
                        .solve(time, &load)
                }
            }
        };
        // With rigid bodies, nonlinear bearings do not deflect: they have their typical stiffness
        // without load.
        let mut step = match self.has_nonlinear_bearings() && !self.rigid {
            // Time steps have rigid raceways.
            true => self.with_nonlinear_bearings(time, load, solve, sizing.is_none())?,
            false => solve(&[], None, &[])?,
        };
        if !self.rigid {
            self.warn_of_linearized_bearings(time, &mut step)?;
            self.warn_of_tilt(&mut step);
        }
        Ok(step)
    }

    /// Warns of bodies that tilt so much that the assumption of small rotations is inaccurate.
    fn warn_of_tilt(&self, step: &mut StepResult) {
        for (index, body) in self.scene.bodies.iter().enumerate() {
            let about = |component: usize| {
                let mut all = self.dofs.iter().zip(&step.motion);
                all.find(|(dof, _)| (dof.body, dof.component) == (index, component))
                    .map_or(0.0, |(_, &motion)| motion)
            };
            if about(3).hypot(about(4)) > LARGE_TILT {
                step.warnings.push(format!(
                    "the load tilts \"{}\" by more than {} mrad: rotations are assumed to be small, and forces and torques have errors of some tenths of a percent or more; check the bearings",
                    body.name,
                    1e3 * LARGE_TILT
                ));
            }
        }
    }

    /// Solves the end of a time step (s) that starts with the deviations `start` from the
    /// prescribed motions. `springs` contains the matrix of the step and the stops relative to the
    /// start, `load` the forces on the DOFs there, both without nonlinear bearings. The resulting
    /// motion is relative to the prescribed one.
    ///
    /// # Errors
    /// Those of [`System::solve`]. E0726: nonlinear bearings find no equilibrium.
    pub fn step(
        &self,
        time: f64,
        springs: &Springs,
        load: &[f64],
        start: &[f64],
        elastic: Option<&ModalElimination<'_>>,
        sizing: &[f64],
    ) -> Result<StepResult, EngineError> {
        let (direction, sizing) = (sizing, Some(sizing));
        let bearings = match self.has_nonlinear_bearings() {
            true => Some(NonlinearBearings::in_time(self, time, load)?),
            false => None,
        };
        let nonlinear = bearings.as_ref();
        let state = None;
        let under = Conditions {
            direction,
            springs,
            nonlinear,
            start,
            elastic,
            sizing,
            in_time: true,
            state,
            one_cell_per_slice: false,
        };
        let mut step = match &self.bodies {
            Bodies::Plane(bodies) => {
                Solver { system: self, space: &Plane { system: self, bodies }, under }.take(time, load)
            }
            Bodies::Solid(bodies) => {
                Solver { system: self, space: &Solid { system: self, bodies, in_time: true }, under }
                    .take(time, load)
            }
        }?;
        if let Some(bearings) = &bearings {
            bearings.warn(&mut step)?;
        }
        Ok(step)
    }
}
