//! Gyroscopic terms of rotating bodies and shafts, in axes that do not rotate.
//!
//! A body that rotates at the angular velocity W about its axis a has the spin momentum `J W a`
//! with its polar moment of inertia J. The momentum follows the axis: `J W theta x a` for a small
//! rotation theta. The rate of change `J W theta' x a` is a force `G theta'` with a skew-symmetric
//! matrix G. A shaft has this term in every section. Deviations of the inertia from symmetry about
//! the axis are zero in the mean over a revolution, and are neglected.
//!
//! See `docs/theory/modes.md`.

use crate::system::System;
use calyx_model::connection::{add_connection_gyroscopic, add_connection_whirl_form};
use calyx_model::motion::angular_velocity;
use calyx_model::whirl::{gyroscopic_moment, quarter_turn_momentum};
use calyx_numerics::vec3::dot;
use nalgebra::DMatrix;

impl System<'_> {
    /// Returns the prescribed angular velocity of a body about its own axis in ground axes, rad/s,
    /// including that of a carrier on which it is mounted.
    fn spin(&self, body: usize, time: f64) -> f64 {
        dot(self.axes(body, time)[2], angular_velocity(self.scene.bodies[body].motion.as_ref(), time))
    }

    /// Returns the free components of a body: the index of each DOF, and the component.
    fn own_dofs(&self, body: usize) -> Vec<(usize, usize)> {
        let own = self.dofs.iter().enumerate().filter(|(_, dof)| dof.body == body);
        own.map(|(index, dof)| (index, dof.component)).collect()
    }

    /// Returns the gyroscopic matrix of all coordinates at a time (s), kg m²/s: skew-symmetric, for
    /// the prescribed rotations of all bodies and elastic shafts; NaN if a connection is invalid.
    /// The modes of gears have no gyroscopic terms.
    pub fn gyroscopic_matrix(&self, time: f64) -> DMatrix<f64> {
        let count = self.dofs.len() + self.mode_count();
        let mut matrix = vec![0.0; count * count];
        let parts = (&self.scene.bodies[..], &self.elastic_connections[..]);
        if add_connection_gyroscopic(&mut matrix, parts, &self.connections, &self.dofs, time).is_err() {
            matrix.fill(f64::NAN);
        }
        for body in 0..self.scene.bodies.len() {
            let own: Vec<_> =
                self.own_dofs(body).into_iter().filter(|(_, component)| *component >= 3).collect();
            let spin = self.spin(body, time);
            if own.len() < 2 || spin == 0.0 {
                continue;
            }
            let axes = self.axes(body, time);
            let inertia = self.inertia_on_ground(body, time, &self.inertias()[body]);
            let polar = dot(axes[2], inertia.about.map(|row| dot(row, axes[2])));
            let moment = gyroscopic_moment(&axes, axes[2], polar * spin);
            for &(i, one) in &own {
                for &(j, other) in &own {
                    matrix[i * count + j] += moment[one - 3][other - 3];
                }
            }
        }
        DMatrix::from_row_slice(count, count, &matrix)
    }

    /// Returns the form of the sense of whirl of all coordinates at a time (s), with the units of
    /// the mass matrix: see [`quarter_turn_momentum`]. Bodies that do not rotate do not contribute.
    pub fn whirl_form(&self, time: f64) -> DMatrix<f64> {
        let count = self.dofs.len() + self.mode_count();
        let mut matrix = vec![0.0; count * count];
        let parts = (&self.scene.bodies[..], &self.elastic_connections[..]);
        if add_connection_whirl_form(&mut matrix, parts, &self.connections, &self.dofs, time).is_err() {
            matrix.fill(f64::NAN);
        }
        for body in 0..self.scene.bodies.len() {
            let (own, spin) = (self.own_dofs(body), self.spin(body, time));
            if own.is_empty() || spin == 0.0 {
                continue;
            }
            let form = quarter_turn_momentum(&self.body_mass(body, time), 6, spin.signum());
            for &(i, one) in &own {
                for &(j, other) in &own {
                    matrix[i * count + j] += form[6 * one + other];
                }
            }
        }
        DMatrix::from_row_slice(count, count, &matrix)
    }
}
