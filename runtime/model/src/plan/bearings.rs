//! Plan of bearings: which are modelled, and what their models ignore.

use super::{BearingPlan, BodyPlan, DAMPING, Plan};
use crate::bearing::{Bearing, NonlinearLoad};
use crate::dof::DOF_NAMES;
use crate::ids::BodyId;
use crate::mechanism::Mechanism;
use crate::pairs::SurfacePair;
use crate::prototype::Ignored;
use calyx_numerics::error::{EngineError, Subject};

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
pub(super) fn ignored_bearing_inputs(bearing: &Bearing, three_dimensional: bool) -> Vec<Ignored> {
    let mut unseen = Vec::new();
    if bearing.damping.iter().flatten().any(|&entry| entry != 0.0) {
        unseen.push(Ignored {
            input: DAMPING.into(),
            reason: "a quasi-static analysis neglects velocities, so bearings have no damping except in a forced response".into(),
        });
    }
    let typical = match &bearing.nonlinear {
        Some(NonlinearLoad::Curves(curves)) => curves.typical_stiffness(),
        Some(NonlinearLoad::Rolling(_)) | None => [[0.0; 6]; 6],
    };
    let out_of_plane =
        |row: &usize| bearing.stiffness[*row].iter().chain(&typical[*row]).any(|&entry| entry != 0.0);
    if !three_dimensional && bearing.linearization.is_none() && [2, 3, 4].iter().any(out_of_plane) {
        unseen.push(Ignored {
            input: "bearing".into(),
            reason:
                "in a two-dimensional model bearings support u_x, u_y and theta_z; u_z, theta_x and theta_y are zero"
                    .into(),
        });
    }
    unseen
}

impl Plan {
    /// Returns warnings about modelled bearings that resist displacements in which their bodies are
    /// fixed, in a three-dimensional model.
    ///
    /// Balls and rollers without contact angle resist axial motion without being made for it, so a
    /// fixed axial position matters only if something pushes there.
    pub fn partly_fixed_bearings(&self, scene: &Mechanism) -> Vec<EngineError> {
        let modelled = self.modelled_bearings().into_iter().filter(|_| self.three_dimensional);
        modelled.filter_map(|bearing| partly_fixed(scene, bearing)).collect()
    }
}

fn partly_fixed(scene: &Mechanism, index: usize) -> Option<EngineError> {
    let bearing = scene.bearings.get(index)?;
    let mobility = bearing.mobility(&scene.bodies).ok()?;
    let is_helical = |pair: &SurfacePair| pair.mesh.as_ref().is_none_or(|mesh| mesh.overlap_ratio != 0.0);
    let has_contact_angle = match (bearing.rolling(), bearing.linearization) {
        (Some(elements), _) => elements.bearing.has_contact_angle(),
        (None, Some(linearization)) => linearization.has_contact_angle,
        (None, None) => true,
    };
    let is_axial_of_use = has_contact_angle || scene.pairs.iter().any(is_helical);
    let fixed: Vec<&str> = (0..3)
        .filter(|&k| mobility.resists[k] && !mobility.moves[k] && (k != 2 || is_axial_of_use))
        .map(|k| DOF_NAMES[k])
        .collect();
    if fixed.is_empty() {
        return None;
    }
    let message = format!(
        "bearing \"{}\" carries no force along {}: the bodies that it connects are not free there, and their frames carry this force",
        bearing.name,
        fixed.join(" and ")
    );
    let quoted: Vec<String> = fixed.iter().map(|name| format!("\"{name}\"")).collect();
    let help = format!(
        "add {} to `free` of a body that it supports; otherwise its load is too small and its life too long",
        quoted.join(" and ")
    );
    Some(EngineError::new("E0728", message, help).about(Subject::Bearing(index)))
}
