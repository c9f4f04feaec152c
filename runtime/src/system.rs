//! The planned scene, built: structures condensed, freedoms numbered, loads gathered. What every position starts from.

use crate::contact::Placement;
use crate::error::{EngineError, Subject};
use crate::load::Wrench;
use crate::motion::PlanePose;
use crate::plan::Plan;
use crate::scene::{Scene, StructureOptions};
use crate::structure::Structure;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A free component of a body's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedom {
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
    /// External generalised forces on the freedoms at the position being solved, per unit of face width (N/m, N).
    pub(crate) load: Vec<f64>,
    /// Width over which all plane quantities are spread, m.
    pub(crate) face_width: f64,
    /// Poses at time 0, from which kinematic angles are counted.
    pub(crate) initial: Vec<PlanePose>,
    /// Cells that carried load at the position before, by pair of teeth: the warm start.
    pub(crate) warm: BTreeMap<Teeth, Vec<usize>>,
}

impl<'s> System<'s> {
    /// Builds what the plan asks for. Bodies with the same prototype and options share one structure.
    pub fn new(scene: &'s Scene, plan: &Plan) -> Result<Self, EngineError> {
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
        let load = vec![0.0; freedoms.len()];
        let initial = scene
            .bodies
            .iter()
            .enumerate()
            .map(|(body, _)| pose(scene, body, 0.0))
            .collect::<Result<_, _>>()?;
        let structures = build_structures(scene, plan)?;
        Ok(System { scene, structures, freedoms, load, face_width, initial, warm: BTreeMap::new() })
    }

    /// Takes the external loads of a time.
    pub(crate) fn load_at(&mut self, time: f64) -> Result<(), EngineError> {
        let loads = loads_on(self.scene, &self.freedoms, time)?;
        self.load = loads.into_iter().map(|load| load / self.face_width).collect();
        Ok(())
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

fn build_structures(scene: &Scene, plan: &Plan) -> Result<Vec<Option<Arc<dyn Structure>>>, EngineError> {
    let numbers = plan.structures(scene);
    let mut wanted: Vec<(usize, StructureOptions)> = Vec::new();
    for (index, (number, body)) in numbers.iter().zip(&plan.bodies).enumerate() {
        let Some(number) = *number else { continue };
        match wanted.get_mut(number) {
            // One that needs stresses serves all that share it.
            Some((_, options)) => options.stresses |= body.options.stresses,
            None => wanted.push((index, body.options)),
        }
    }
    let built: Vec<Arc<dyn Structure>> = wanted
        .par_iter()
        .map(|(index, options)| scene.bodies[*index].prototype.build(options))
        .collect::<Result<_, _>>()?;
    Ok(numbers.into_iter().map(|number| number.and_then(|number| built.get(number).cloned())).collect())
}
