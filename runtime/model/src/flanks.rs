//! Flanks of spline teeth with clearance in the contact problem: bodies that have them, their arms
//! and gap equations.

use crate::bearing::Springs;
use crate::dof::Dof;
use crate::frames::pose;
use crate::mechanism::Mechanism;
use crate::motion::axle;
use crate::plan::Plan;
use crate::spline_contact::SplineContact;
use calyx_numerics::error::EngineError;
use faer::MatRef;

/// Returns the bodies of a planned scene with spline teeth with clearance, by index.
pub fn spline_contacts(scene: &Mechanism, plan: &Plan) -> Vec<(usize, SplineContact)> {
    let bodies = scene.bodies.iter().zip(&plan.bodies).enumerate();
    let elastic = bodies.filter(|(_, (_, plan))| plan.is_elastic());
    elastic.filter_map(|(index, (body, _))| Some((index, body.prototype.spline_contact()?))).collect()
}

/// Returns [`SplineContact::arms`] of a body at a time (s).
///
/// # Errors
/// Those of [`pose`].
pub fn arms_at(
    scene: &Mechanism,
    body: usize,
    contact: &SplineContact,
    time: f64,
) -> Result<Vec<[f64; 3]>, EngineError> {
    let (stands, body) = (pose(scene, body, time)?, &scene.bodies[body]);
    let about = stands.point(axle(body.motion.as_ref()));
    let off = [0, 1].map(|k: usize| stands.origin[k] - about[k]);
    Ok(contact.arms(stands.angle + body.phase, off))
}

/// Appends the flanks of a body's spline teeth at a time (s) to the gap equations of bearings;
/// `between` as in [`SplineContact::compliance`].
///
/// # Errors
/// Those of [`pose`].
pub fn add_flanks(
    springs: &mut Springs,
    scene: &Mechanism,
    (body, contact): (usize, &SplineContact),
    dofs: &[Dof],
    time: f64,
    between: Option<MatRef<'_, f64>>,
) -> Result<(), EngineError> {
    let arms = arms_at(scene, body, contact, time)?;
    let on_dofs = arms.iter().flat_map(|arms| {
        dofs.iter().map(move |dof| match (dof.body == body, dof.component) {
            (true, component @ 0..2) => arms[component],
            (true, 5) => arms[2],
            _ => 0.0,
        })
    });
    let gaps = vec![0.5 * contact.clearance; arms.len()];
    springs.add_walls(&gaps, on_dofs, &contact.compliance(between));
    Ok(())
}
