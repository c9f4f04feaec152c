//! Plan of bearings: which are modelled, and what their models ignore.

use super::{BearingPlan, BodyPlan, DAMPING};
use crate::bearing::Bearing;
use crate::dof::DOF_NAMES;
use crate::ids::BodyId;
use crate::mechanism::Mechanism;
use crate::pairs::SurfacePair;
use crate::prototype::Ignored;

/// Decides whether a bearing is modelled.
pub(super) fn plan_bearing(scene: &Mechanism, bodies: &[BodyPlan], bearing: &Bearing) -> BearingPlan {
    let unwanted = bearing.bodies().all(|body| bodies.get(body.0).is_none_or(|plan| plan.left_out));
    let moves = |body: BodyId| scene.bodies.get(body.0).is_some_and(|body| body.free.contains(&true));
    let idle = !bearing.bodies().any(moves) && bearing.is_unloaded_without_motion();
    BearingPlan {
        name: bearing.name.clone(),
        reason: match (unwanted, idle) {
            (true, _) => "left out: no output depends on the bodies that it connects",
            (_, true) => "left out: the frames on both sides are constrained, and it carries no load",
            _ => "a stiffness between the frames of its races",
        },
        left_out: unwanted || idle,
    }
}

/// Returns the inputs of a bearing that the analysis ignores.
pub(super) fn ignored_bearing_inputs(
    scene: &Mechanism,
    bearing: &Bearing,
    three_dimensional: bool,
) -> Vec<Ignored> {
    let mut unseen = Vec::new();
    if bearing.damping.iter().flatten().any(|&entry| entry != 0.0) {
        unseen.push(Ignored {
            input: DAMPING.into(),
            reason: "a quasi-static analysis neglects velocities, so bearings have no damping".into(),
        });
    }
    let out_of_plane = |row: &usize| bearing.stiffness[*row].iter().any(|&entry| entry != 0.0);
    if !three_dimensional && [2, 3, 4].iter().any(out_of_plane) {
        unseen.push(Ignored {
            input: "bearing".into(),
            reason:
                "in a two-dimensional model bearings support u_x, u_y and theta_z; u_z, theta_x and theta_y are zero"
                    .into(),
        });
    }
    if three_dimensional {
        unseen.extend(resisted_by_frames(scene, bearing));
    }
    unseen
}

/// Reports the displacements that a bearing resists and the frames of its bodies prevent.
///
/// Balls and rollers without contact angle resist axial motion without being made for it, so a
/// fixed axial position matters only if something pushes there.
fn resisted_by_frames(scene: &Mechanism, bearing: &Bearing) -> Option<Ignored> {
    let mobility = bearing.mobility(scene).ok()?;
    let is_helical = |pair: &SurfacePair| pair.mesh.as_ref().is_none_or(|mesh| mesh.overlap_ratio != 0.0);
    let has_axial_load = || {
        scene.pairs.iter().any(is_helical)
            || bearing.rolling.as_ref().is_some_and(|elements| elements.bearing.has_contact_angle())
    };
    let matters =
        |k: usize| k != 2 || bearing.stiffness[2][2] > 0.0 || !bearing.stops.is_empty() || has_axial_load();
    let fixed: Vec<&str> = (0..3)
        .filter(|&k| mobility.resists[k] && !mobility.moves[k] && matters(k))
        .map(|k| DOF_NAMES[k])
        .collect();
    (!fixed.is_empty()).then(|| Ignored {
        input: "bearing".into(),
        reason: format!(
            "bearing \"{}\" resists {}, where the bodies that it connects are not `free`: their frames carry this load, and the forces and the life of the bearing do not include it",
            bearing.name,
            fixed.join(" and ")
        ),
    })
}
