//! Prescribed positions of frames, the free components of planned bodies, and the loads on these.

use crate::dof::Dof;
use crate::mechanism::Mechanism;
use crate::motion::{Orientation, PlanePose, spatial_pose};
use crate::plan::Plan;
use calyx_contact::solid::Pose;
use calyx_numerics::error::{EngineError, Subject};

/// Returns the prescribed pose of a body's frame at a time in a plane model.
///
/// # Errors
/// The frame is NaN or tilted; the error names the body.
pub fn pose(scene: &Mechanism, body: usize, time: f64) -> Result<PlanePose, EngineError> {
    PlanePose::of(scene.bodies[body].motion.as_ref(), time).map_err(|error| error.about(Subject::Body(body)))
}

/// Returns the prescribed pose in three dimensions, where frames may tilt.
///
/// # Errors
/// The frame is NaN; the error names the body.
pub fn solid_pose(scene: &Mechanism, body: usize, time: f64) -> Result<Pose, EngineError> {
    spatial_pose(scene.bodies[body].motion.as_ref(), time).map_err(|error| error.about(Subject::Body(body)))
}

/// Returns the ground axes under the minimal rotation to a body's axis; NaN if its motion is NaN.
pub fn axes(scene: &Mechanism, body: usize, time: f64) -> [[f64; 3]; 3] {
    solid_pose(scene, body, time).map_or([[f64::NAN; 3]; 3], |pose| Orientation::of(&pose).axes)
}

/// Returns the free components of the modelled bodies, in order.
pub fn number_dofs(scene: &Mechanism, plan: &Plan) -> Vec<Dof> {
    let bodies = scene.bodies.iter().zip(&plan.bodies).enumerate().filter(|(_, (_, plan))| !plan.left_out);
    bodies
        .flat_map(|(index, (body, _))| {
            (0..6).filter(|&c| body.free[c]).map(move |component| Dof { body: index, component })
        })
        .collect()
}

/// Returns the external forces and moments on the DOFs at a time (s), with the loads scaled by
/// `part`, see [`crate::body::Body::acted_on`].
///
/// # Errors
/// E0710 if a frame is NaN, E0723 if a load is NaN.
pub fn loads_on(scene: &Mechanism, dofs: &[Dof], time: f64, part: f64) -> Result<Vec<f64>, EngineError> {
    let mut loads = Vec::with_capacity(dofs.len());
    let mut latest: Option<(usize, [f64; 6])> = None;
    for dof in dofs {
        // Evaluate a load once per position, however many components of its body are free.
        let along = match latest {
            Some((body, along)) if body == dof.body => along,
            _ => {
                let stance = Orientation::of(&solid_pose(scene, dof.body, time)?);
                scene.bodies[dof.body].acted_on(time, part).along(&stance.axes)
            }
        };
        latest = Some((dof.body, along));
        let load = along[dof.component];
        if !load.is_finite() {
            let body = &scene.bodies[dof.body].name;
            return Err(EngineError::new(
                "E0723",
                format!("the load on body \"{body}\" is not a finite number at Time = {time} s"),
                "check the function that gives the load; it must have a value at every position of the analysis",
            )
            .about(Subject::Body(dof.body)));
        }
        loads.push(load);
    }
    Ok(loads)
}
