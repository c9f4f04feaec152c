//! The planned scene, built: structures condensed, freedoms numbered, loads gathered. What every position starts from.

use crate::building::build_structures;
use crate::contact::Placement;
use crate::error::{EngineError, Subject};
use crate::interrupt::Interrupt;
use crate::load::Wrench;
use crate::motion::PlanePose;
use crate::plan::Plan;
use crate::resources::Resources;
use crate::results::StructureCounts;
use crate::scene::Scene;
use crate::structure::Structure;
use std::sync::Arc;

/// A free component of a body's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// Index of the body in the scene.
    pub body: usize,
    /// Index in [`crate::scene::FREEDOMS`].
    pub component: usize,
}

/// A pair of teeth of a surface pair.
pub(crate) type Teeth = (usize, [u32; 2]);

/// Everything that positions share.
pub struct System<'s> {
    pub(crate) scene: &'s Scene,
    /// One per body; `None` for a body the plan left out.
    pub(crate) structures: Vec<Option<Arc<dyn Structure>>>,
    pub(crate) freedoms: Vec<Freedom>,
    /// Width over which all plane quantities are spread, m.
    pub(crate) face_width: f64,
    /// Poses at time 0, from which kinematic angles are counted.
    pub(crate) initial: Vec<PlanePose>,
    pub(crate) interrupt: Interrupt,
    structure_counts: StructureCounts,
}

impl<'s> System<'s> {
    /// Builds what the plan asks for, without a cache and to the end.
    ///
    /// # Errors
    /// As [`System::with`].
    pub fn new(scene: &'s Scene, plan: &Plan) -> Result<Self, EngineError> {
        Self::with(scene, plan, &Resources::default())
    }

    /// Builds what the plan asks for. Bodies whose structures would be equal share one.
    ///
    /// # Errors
    /// Nothing touches anything, a frame is unusable, a structure cannot be built, or the interrupt's.
    pub fn with(scene: &'s Scene, plan: &Plan, resources: &Resources) -> Result<Self, EngineError> {
        let freedoms = number_freedoms(scene, plan);
        let widths = scene.bodies.iter().zip(&plan.bodies).filter(|(_, body)| !body.left_out);
        let face_width = widths.map(|(body, _)| body.prototype.face_width()).fold(f64::INFINITY, f64::min);
        if !face_width.is_finite() {
            return Err(EngineError::new(
                "E0713",
                "nothing in the scene touches anything",
                "mesh two bodies, like `gears.mesh(pinion, gear)`",
            ));
        }
        let initial = scene
            .bodies
            .iter()
            .enumerate()
            .map(|(body, _)| pose(scene, body, 0.0))
            .collect::<Result<_, _>>()?;
        let (structures, structure_counts) = build_structures(scene, plan, resources)?;
        let interrupt = resources.interrupt.clone();
        Ok(System { scene, structures, freedoms, face_width, initial, interrupt, structure_counts })
    }

    /// How many structures were built for this system, and how many there were already.
    pub fn structure_counts(&self) -> StructureCounts {
        self.structure_counts
    }

    /// External generalised forces on the freedoms at a time, per unit of face width (N/m, N).
    pub(crate) fn load_at(&self, time: f64) -> Result<Vec<f64>, EngineError> {
        let loads = loads_on(self.scene, &self.freedoms, time)?;
        Ok(loads.into_iter().map(|load| load / self.face_width).collect())
    }

    /// Where a body's teeth coordinates lie at a time, with the body's phase.
    pub(crate) fn placement(&self, body: usize, time: f64) -> Result<Placement, EngineError> {
        let pose = pose(self.scene, body, time)?;
        Ok(Placement::new(pose.angle + self.scene.bodies[body].phase, pose.origin))
    }

    /// Angle of a tooth in its body's coordinates, with its pitch error, rad.
    pub(crate) fn tooth_angle(&self, body: usize, structure: &dyn Structure, tooth: u32) -> f64 {
        structure.tooth_angle(tooth) + self.scene.bodies[body].prototype.pitch_error(tooth)
    }
}

/// Where a body's frame is meant to be at a time.
///
/// # Errors
/// The frame is not a number there, or tilted; the error is about that body.
pub(crate) fn pose(scene: &Scene, body: usize, time: f64) -> Result<PlanePose, EngineError> {
    PlanePose::of(scene.bodies[body].motion.as_ref(), time).map_err(|error| error.about(Subject::Body(body)))
}

/// Free components of the bodies that are modelled, in order.
pub(crate) fn number_freedoms(scene: &Scene, plan: &Plan) -> Vec<Freedom> {
    let bodies = scene.bodies.iter().zip(&plan.bodies).enumerate().filter(|(_, (_, plan))| !plan.left_out);
    bodies
        .flat_map(|(index, (body, _))| {
            (0..6).filter(|&c| body.free[c]).map(move |component| Freedom { body: index, component })
        })
        .collect()
}

/// The external forces and moments on freedoms at a time (s), in their order.
///
/// # Errors
/// E0723 if a load is not a number there.
pub(crate) fn loads_on(scene: &Scene, freedoms: &[Freedom], time: f64) -> Result<Vec<f64>, EngineError> {
    let mut loads = Vec::with_capacity(freedoms.len());
    let mut latest: Option<(usize, Wrench)> = None;
    for freedom in freedoms {
        // A load is asked once a position, however many components of its body are free.
        let wrench = match latest {
            Some((body, wrench)) if body == freedom.body => wrench,
            _ => scene.bodies[freedom.body].load.at(time),
        };
        latest = Some((freedom.body, wrench));
        let load = wrench.component(freedom.component);
        if !load.is_finite() {
            let body = &scene.bodies[freedom.body].name;
            return Err(EngineError::new(
                "E0723",
                format!("the load on body \"{body}\" is not a finite number at Time = {time} s"),
                "look at what gives the load; it must have a value at every position that is analysed",
            )
            .about(Subject::Body(freedom.body)));
        }
        loads.push(load);
    }
    Ok(loads)
}
