//! Drift of contact along sliding and rolling surfaces under load. Gaps are linearized in the
//! motions of frames about the position at which the contact grid was created. A contact that moves
//! across its patch by more than the patch's half-width leaves its grid.

use super::friction::{Action, work};
use crate::system::System;
use calyx_model::mechanism::Mechanism;
use calyx_numerics::vec3::{cross, dot, length, minus, plus, scaled};

/// Point of action of a loaded patch, and its half-width.
pub(super) struct ContactReference {
    pub pair: usize,
    pub action: Action,
    /// Half the width of its grid, m.
    pub reach: f64,
}

impl ContactReference {
    /// Returns the drift of the contact across along either surface, in the transverse plane, by
    /// these motions of the DOFs at a time (s): relative to the half-width, at the position along
    /// the patch where it is largest.
    ///
    /// Contact lies where the line through both centres of curvature intersects the surfaces. The
    /// centre of curvature of an involute lies on the common normal at its closest point to the
    /// gear's axis, like that of a disc.
    fn relative_shift(&self, system: &System, time: f64, motion: &[f64]) -> f64 {
        let mesh = system.scene.pairs[self.pair].mesh.as_ref();
        if mesh.is_some_and(|mesh| mesh.first_contact.is_some()) {
            return self.relative_shift_on_general_axes(system, time, motion);
        }
        let bodies = system.scene.pairs[self.pair].bodies;
        let sides = bodies.map(|body| (system.origin(body.0, time), system.axes(body.0, time)));
        let axis = sides[0].1[2];
        let transverse = minus(self.action.normal, scaled(axis, dot(self.action.normal, axis)));
        let size = length(transverse);
        if !(size > 0.0 && self.reach > 0.0) {
            return 0.0;
        }
        let normal = transverse.map(|part| part / size);
        let across = cross(axis, normal);
        let moves = |side: usize, point: [f64; 3]| -> f64 {
            let own = system.dofs.iter().zip(motion).filter(|(dof, _)| bodies[side].0 == dof.body);
            let (origin, axes) = &sides[side];
            own.map(|(dof, motion)| motion * work(across, 0, dof.component, axes, *origin, point)).sum()
        };
        let at = |point: [f64; 3]| {
            let centre = |side: usize| {
                let along = dot(minus(sides[side].0, point), normal);
                (along, moves(side, plus(point, scaled(normal, along))))
            };
            let [(first, first_moves), (second, second_moves)] = [centre(0), centre(1)];
            let foot = match second - first {
                0.0 => 0.0,
                apart => (first_moves * second - second_moves * first) / apart,
            };
            (foot - moves(0, point)).abs().max((foot - moves(1, point)).abs())
        };
        self.action.points.iter().map(|&point| at(point)).fold(0.0, f64::max) / self.reach
    }

    /// Returns the drift on general axes: as for parallel ones, with the point of the common normal
    /// closest to a gear's axis as the centre of curvature.
    fn relative_shift_on_general_axes(&self, system: &System, time: f64, motion: &[f64]) -> f64 {
        let Action { normal, across, points } = &self.action;
        if self.reach.is_nan() || self.reach <= 0.0 {
            return 0.0;
        }
        let bodies = system.scene.pairs[self.pair].bodies;
        let sides = bodies.map(|body| (system.origin(body.0, time), system.axes(body.0, time)));
        let moves = |side: usize, point: [f64; 3]| -> f64 {
            let own = system.dofs.iter().zip(motion).filter(|(dof, _)| bodies[side].0 == dof.body);
            let (origin, axes) = &sides[side];
            own.map(|(dof, motion)| motion * work(*across, 0, dof.component, axes, *origin, point)).sum()
        };
        let at = |point: [f64; 3]| {
            let centre = |side: usize| {
                let (origin, axes) = &sides[side];
                // Directions normal to the axis.
                let away = |vector: [f64; 3]| minus(vector, scaled(axes[2], dot(vector, axes[2])));
                let (direction, offset) = (away(*normal), away(minus(*origin, point)));
                let along = dot(offset, direction) / dot(direction, direction);
                let along = if along.is_finite() { along } else { 0.0 };
                (along, moves(side, plus(point, scaled(*normal, along))))
            };
            let [(first, first_moves), (second, second_moves)] = [centre(0), centre(1)];
            let foot = match second - first {
                0.0 => 0.0,
                apart => (first_moves * second - second_moves * first) / apart,
            };
            (foot - moves(0, point)).abs().max((foot - moves(1, point)).abs())
        };
        points.iter().map(|&point| at(point)).fold(0.0, f64::max) / self.reach
    }

    /// Returns the warning that the contact drifts off its grid by this fraction of its half-width
    /// after all relinearizations.
    pub fn lost(&self, scene: &Mechanism, relative_shift: f64) -> String {
        let [first, second] = scene.pairs[self.pair].bodies.map(|body| scene.bodies[body.0].name.as_str());
        let relative_shift = relative_shift * self.reach * 1e3;
        // Round to two digits, so that all positions of a cycle have the same message.
        let relative_shift = format!("{relative_shift:.1e}").parse().unwrap_or(relative_shift);
        format!(
            "the load carries \"{first}\" and \"{second}\" so far that contact moves by {relative_shift} mm along them, off its grid, and further \
             wherever it is laid out anew; stiffen what holds them, or put the frames where the load takes them"
        )
    }
}

/// Returns the largest drift of some patches, see [`ContactReference::relative_shift`], and its
/// patch.
pub(super) fn farthest<'a>(
    system: &System,
    time: f64,
    references: &'a [ContactReference],
    motion: &[f64],
) -> (f64, Option<&'a ContactReference>) {
    references.iter().fold((0.0, None), |(most, whose), reference| {
        let relative_shift = reference.relative_shift(system, time, motion);
        if relative_shift > most { (relative_shift, Some(reference)) } else { (most, whose) }
    })
}
