//! Rows of rolling elements that carry axial force in one sense only, such as tapered rollers.
//!
//! The check of all other motions has their typical stiffness, which acts in both senses. A body
//! that moves freely along its axis is supported in both senses by springs, by stops and bearings
//! that each take one sense, or it leaves its bearings: by a load, by helical teeth, or by the
//! axial force that contact angles cause under radial load.

use calyx_model::bearing::{BearingState, Springs, Tangent, springs};
use calyx_model::connection::add_connection_stiffness;
use calyx_model::connection_building::connections_as_links;
use calyx_model::dof::Dof;
use calyx_model::frames::axes;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::plan::Plan;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::dot;

/// Strain energy of a motion, relative to that of each of its parts alone, that counts as rounding.
const NO_STRAIN: f64 = 1e-10;
/// Cosine of the largest angle between axes that are parallel.
const PARALLEL: f64 = 1.0 - 1e-9;

/// Rejects bodies that can leave their bearings along the axis in one sense.
///
/// # Errors
/// E0729: all axial supports of a body take the same sense.
pub(super) fn check(scene: &Mechanism, plan: &Plan, dofs: &[Dof], time: f64) -> Result<(), EngineError> {
    let modelled = plan.modelled_bearings();
    let one_sided = |&bearing: &usize| {
        let nonlinear = scene.bearings[bearing].nonlinear.as_ref();
        nonlinear.is_some_and(|load| matches!(load.axial_supports(), [true, false] | [false, true]))
    };
    let candidates: Vec<usize> = modelled.iter().copied().filter(one_sided).collect();
    if candidates.is_empty() || !plan.three_dimensional {
        return Ok(());
    }
    let mut tangents = vec![None; scene.bearings.len()];
    candidates.iter().for_each(|&bearing| tangents[bearing] = Some(Tangent::default()));
    let mut others = springs(&scene.bodies, &scene.bearings, &modelled, dofs, |_| 1.0, time, &tangents)?;
    let connections = connections_as_links(scene)?;
    let connections = (&scene.bodies[..], &connections[..]);
    let planned = plan.modelled_connections();
    add_connection_stiffness(&mut others.stiffness, connections, &planned, dofs, |_| 1.0, time)?;
    for &bearing in &candidates {
        for body in scene.bearings[bearing].bodies() {
            let Some(motion) = axial_motion(scene, body, dofs, time) else { continue };
            if strains(&others, &motion) {
                continue;
            }
            let mut resisted = resisted_by_stops(&others, &motion);
            let mut supports = Vec::new();
            for &other in &candidates {
                let sense = support(scene, other, (dofs, &motion), time)?;
                if sense != 0.0 {
                    resisted[usize::from(sense < 0.0)] = true;
                    supports.push(other);
                }
            }
            if !supports.is_empty() && resisted != [true, true] {
                return Err(unsupported(scene, body, &supports, resisted[0]));
            }
        }
    }
    Ok(())
}

/// Returns the displacement along the axis of a body and of all bodies that elastic connections
/// join to it, by DOF; `None` if one of them is fixed along this axis.
fn axial_motion(scene: &Mechanism, body: BodyId, dofs: &[Dof], time: f64) -> Option<Vec<f64>> {
    let axis = axes(scene, body.0, time)[2];
    let mut motion = vec![0.0; dofs.len()];
    let (mut known, mut next) = (vec![body], 0);
    while let Some(&member) = known.get(next) {
        next += 1;
        let along = dot(axis, axes(scene, member.0, time)[2]);
        let at = dofs.iter().position(|dof| dof.body == member.0 && dof.component == 2)?;
        if along.abs() < PARALLEL {
            return None;
        }
        motion[at] = along.signum();
        let joined = scene.connections_of(member).flat_map(|connection| connection.bodies());
        let more: Vec<BodyId> = joined.filter(|other| !known.contains(other)).collect();
        known.extend(more);
    }
    Some(motion)
}

fn strains(springs: &Springs, motion: &[f64]) -> bool {
    let m = motion.len();
    let (mut energy, mut scale) = (0.0, 0.0);
    for i in 0..m {
        for j in 0..m {
            energy += motion[i] * springs.stiffness[i * m + j] * motion[j];
        }
        scale += motion[i] * springs.stiffness[i * m + i] * motion[i];
    }
    energy > NO_STRAIN * scale
}

/// Returns whether stops resist a motion in the positive and in the negative sense.
fn resisted_by_stops(springs: &Springs, motion: &[f64]) -> [bool; 2] {
    let opened = |row: &[f64]| row.iter().zip(motion).map(|(arm, part)| arm * part).sum::<f64>();
    let rates: Vec<f64> = springs.arms.chunks_exact(motion.len()).map(opened).collect();
    [rates.iter().any(|rate| *rate < 0.0), rates.iter().any(|rate| *rate > 0.0)]
}

/// Returns the sense of a motion that a bearing with one axial sense resists; 0 for none.
fn support(
    scene: &Mechanism,
    bearing: usize,
    (dofs, motion): (&[Dof], &[f64]),
    time: f64,
) -> Result<f64, EngineError> {
    let own = &scene.bearings[bearing];
    let placed = BearingState::at(&scene.bodies, own, time)?;
    let axial: f64 = dofs.iter().zip(motion).map(|(dof, part)| part * placed.deflection(dof)[2]).sum();
    let positive = own.nonlinear.as_ref().is_some_and(|load| load.axial_supports()[0]);
    if axial.abs() < 0.5 {
        return Ok(0.0);
    }
    Ok(if positive { axial.signum() } else { -axial.signum() })
}

fn unsupported(scene: &Mechanism, body: BodyId, supports: &[usize], positive: bool) -> EngineError {
    let shaft = scene.connections_of(body).find(|connection| connection.shaft.is_some());
    let name = shaft.map_or(&scene.bodies[body.0].name, |connection| &connection.name);
    let [has, lacks] = if positive { ["+z", "-z"] } else { ["-z", "+z"] };
    let names: Vec<String> =
        supports.iter().map(|&bearing| format!("\"{}\"", scene.bearings[bearing].name)).collect();
    let rolling = supports.iter().all(|&bearing| scene.bearings[bearing].rolling().is_some());
    let by = if rolling { " (`thrust`)" } else { "" };
    let which = match &names[..] {
        [only] => format!("its only axial support, {only}, carries axial force to {has}{by} alone"),
        _ => format!("its axial supports {} carry axial force to {has}{by} alone", names.join(", ")),
    };
    let (argument, help) = match rolling {
        true => ("thrust", format!("mount one of two such bearings with `thrust = \"{lacks}\"`")),
        false => ("axial_forces", "let the axial load curve increase at both of its ends".to_owned()),
    };
    EngineError::new(
        "E0729",
        format!("nothing supports \"{name}\" against axial force to {lacks}: {which}"),
        format!("{help}, or add a bearing that carries axial force to {lacks}"),
    )
    .about(Subject::Bearing(supports.last().copied().unwrap_or_default()))
    .blame(argument)
}
