//! Meshes whose axes move: rotations, speeds and velocities relative to the carrier of the mesh,
//! see [`calyx_model::mesh_carrier`].

use crate::system::System;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::mesh_carrier::{MeshAxes, MovingAxes};
use calyx_model::motion::{Motion, angular_velocity, point_velocity, rotation_speed};
use calyx_model::pairs::SurfacePair;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, cross, dot, minus, plus, scaled};

/// Returns the prescribed motions of the bodies of a pair.
fn motions<'a>(scene: &'a Mechanism, pair: &SurfacePair) -> [&'a dyn Motion; 2] {
    pair.bodies.map(|body| scene.bodies[body.0].motion.as_ref())
}

impl System<'_> {
    /// Returns the prescribed direction from the axis of a pair's first body to that of its second
    /// in the transverse plane of the first body, rad.
    fn line_of_centres(&self, pair: &SurfacePair, time: f64) -> f64 {
        let [first, second] = pair.bodies.map(|body| self.origin(body.0, time));
        let (across, axes) = (minus(second, first), self.axes(pair.bodies[0].0, time));
        dot(across, axes[1]).atan2(dot(across, axes[0]))
    }

    /// Determines the moving axes of all pairs.
    ///
    /// # Errors
    /// E0710: a frame is NaN or infinite.
    pub(crate) fn find_moving_axes(&self) -> Result<Vec<Option<MovingAxes>>, EngineError> {
        let of = |pair: &SurfacePair| {
            let Some(mesh) = pair.mesh.as_ref().filter(|mesh| mesh.carrier != [0.0; 3]) else {
                return Ok(None);
            };
            if mesh.first_contact.is_none() {
                return Ok(Some(MovingAxes::Parallel { line_of_centres: self.line_of_centres(pair, 0.0) }));
            }
            let axes = MeshAxes::at(motions(self.scene, pair), 0.0)?;
            Ok(Some(MovingAxes::General { rotations: [axes.rotation(0), axes.rotation(1)] }))
        };
        self.scene.pairs.iter().map(of).collect()
    }

    /// Returns the rotation of the line of centres of a pair on parallel axes since time 0, rad,
    /// modulo whole revolutions; 0 for gears on fixed axes.
    pub fn rotated_line_of_centres(&self, pair: usize, time: f64) -> f64 {
        match self.moving_axes[pair] {
            Some(MovingAxes::Parallel { line_of_centres }) => {
                self.line_of_centres(&self.scene.pairs[pair], time) - line_of_centres
            }
            Some(MovingAxes::General { .. }) | None => 0.0,
        }
    }

    /// Returns the prescribed rotation of a member of a pair since time 0 about its own axis and
    /// relative to the carrier of the mesh, rad, modulo whole revolutions; NaN if the motion is
    /// NaN.
    pub fn turned_on_carrier(&self, pair: usize, side: usize, time: f64) -> f64 {
        let surfaces = &self.scene.pairs[pair];
        match self.moving_axes[pair] {
            Some(MovingAxes::General { rotations }) => MeshAxes::at(motions(self.scene, surfaces), time)
                .map_or(f64::NAN, |axes| axes.rotation(side) - rotations[side]),
            _ => self.turned(surfaces.bodies[side].0, time) - self.rotated_line_of_centres(pair, time),
        }
    }

    /// Returns the prescribed angular velocity of a member of a pair on general axes about its own
    /// axis and relative to the carrier of the mesh, rad/s; NaN if the motion is NaN.
    pub fn speed_on_carrier(&self, pair: usize, side: usize, time: f64) -> f64 {
        let surfaces = &self.scene.pairs[pair];
        let motions = motions(self.scene, surfaces);
        if self.moving_axes[pair].is_none() {
            return rotation_speed(motions[side], time).unwrap_or(f64::NAN);
        }
        let speed = |axes: MeshAxes| {
            let carrier = axes.carrier_velocity(motions, time).angular;
            dot(minus(angular_velocity(motions[side], time), carrier), axes.directions[side])
        };
        MeshAxes::at(motions, time).map_or(f64::NAN, speed)
    }

    /// Returns the velocity of the carrier of a mesh at a point in ground coordinates (m), m/s:
    /// zero for fixed axes. Mesh motions are relative to it.
    pub fn carrier_velocity(&self, pair: usize, time: f64, point: [f64; 3]) -> [f64; 3] {
        let SurfacePair { bodies: [first, second], .. } = self.scene.pairs[pair];
        match self.moving_axes[pair] {
            None => return [0.0; 3],
            Some(MovingAxes::General { .. }) => {
                let motions = motions(self.scene, &self.scene.pairs[pair]);
                return MeshAxes::at(motions, time)
                    .map_or([f64::NAN; 3], |axes| axes.carrier_velocity(motions, time).at(point));
            }
            Some(MovingAxes::Parallel { .. }) => {}
        }
        let at = |body: BodyId| {
            let place = self.origin(body.0, time);
            (place, point_velocity(self.scene.bodies[body.0].motion.as_ref(), time, place))
        };
        let ([from, velocity], [to, other]) = (at(first).into(), at(second).into());
        let axis = self.axes(first.0, time)[2];
        let transverse = |vector: Vector| minus(vector, scaled(axis, dot(vector, axis)));
        let across = transverse(minus(to, from));
        let turning = dot(cross(across, minus(other, velocity)), axis) / dot(across, across);
        plus(transverse(velocity), scaled(cross(axis, minus(point, from)), turning))
    }
}
