//! Friction of a patch: the force that opposes the sliding of the first body and drives the second.

use crate::system::System;
use calyx_contact::solid::sliding;
use calyx_model::pairs::SurfacePair;

/// Points of action of the cells of a patch and their common normal, out of the first body, in
/// ground coordinates.
pub(super) struct Action {
    pub normal: [f64; 3],
    /// Unit vector across the contact line.
    pub across: [f64; 3],
    /// Points of action, m.
    pub points: Vec<[f64; 3]>,
}

impl Action {
    /// Returns the friction force on the first body per unit normal force of each cell, along
    /// ground axes, with the deviations `start` from the prescribed motions; empty for a pair
    /// without friction.
    pub fn friction_vectors(
        &self,
        system: &System,
        pair: &SurfacePair,
        time: f64,
        start: &[f64],
    ) -> Vec<[f64; 3]> {
        if pair.friction == 0.0 {
            return Vec::new();
        }
        let of = |&point: &[f64; 3]| {
            let velocities = pair.bodies.map(|body| system.velocity(body.0, time, start, point));
            sliding(self.normal, velocities)
                .map_or([0.0; 3], |direction| direction.map(|d| -pair.friction * d))
        };
        self.points.iter().map(of).collect()
    }

    /// Returns the generalized forces of that friction on the DOFs per unit normal force on each
    /// cell, row by row.
    pub fn works(
        &self,
        system: &System,
        pair: &SurfacePair,
        time: f64,
        friction_vectors: &[[f64; 3]],
        start: &[f64],
    ) -> Vec<f64> {
        let count = system.dofs.len();
        let mut works = vec![0.0; self.points.len() * count];
        for (column, dof) in system.dofs.iter().enumerate() {
            for side in (0..2).filter(|&side| pair.bodies[side].0 == dof.body) {
                let axes = system.axes(dof.body, time);
                let origin = system.displaced_origin(dof.body, time, start);
                for (row, (friction_vectors, point)) in friction_vectors.iter().zip(&self.points).enumerate()
                {
                    works[row * count + column] +=
                        work(*friction_vectors, side, dof.component, &axes, origin, *point);
                }
            }
        }
        works
    }
}

/// Returns the work of a friction force on the body of a side by a component of its motion, in the
/// order of [`calyx_model::dof::DOF_NAMES`]: displacements along `axes`, rotations about them
/// through `origin`.
pub(super) fn work(
    friction_vectors: [f64; 3],
    side: usize,
    component: usize,
    axes: &[[f64; 3]; 3],
    origin: [f64; 3],
    point: [f64; 3],
) -> f64 {
    let [x, y, z] = friction_vectors;
    let [a, b, c] = [0, 1, 2].map(|axis: usize| point[axis] - origin[axis]);
    let vector = if component < 3 { friction_vectors } else { [b * z - c * y, c * x - a * z, a * y - b * x] };
    let axis = axes[component % 3];
    let on_first = axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
    if side == 0 { on_first } else { -on_first }
}
