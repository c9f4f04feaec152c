//! Inertia forces of a rigid body about its prescribed motion.
//!
//! A particle of the body is at `A + u + r + theta x r`. A is the prescribed position of the axis
//! of rotation, r the particle's position relative to A after the prescribed rotation, and u and
//! theta are the small deviations of the frame. With the prescribed angular velocity W and angular
//! acceleration W', `r'' = W' x r + W x (W x r)`. Newton's and Euler's equations, about the
//! displaced axis and to first order in u, theta and their rates, give the inertia forces
//! (negative)
//!
//! ```text
//! force:   m u'' + theta'' x s + 2 theta' x (W x s) + theta x s'' + m A'' + s''
//! moment:  I theta'' + s x u'' - 2 W x (P theta') + theta x H' + (theta x s) x A'' + H' + s x A''
//! ```
//!
//! with the mass m, the first moment `s = sum r`, the inertia tensor I about A, the second moment
//! `P = sum r r' = tr(I) / 2 - I`, the derivative `s'' = W' x s + W x (W x s)`, and the derivative
//! of the prescribed angular momentum, `H' = I W' + W x I W`. For a body of revolution the term of
//! P is the gyroscopic moment `J W theta' x a`.
//!
//! See `docs/theory/dynamics.md`.

use crate::system::System;
use calyx_fe::inertia::Inertia;
use calyx_model::motion::{angular_acceleration, angular_velocity, point_acceleration};
use calyx_numerics::vec3::{Vector, cross, dot, minus, plus, scaled};

/// Translation or force, and rotation or moment, along ground axes.
pub(super) type Pair = [Vector; 2];

/// Inertia and prescribed motion of a body at a time, along ground axes.
#[derive(Clone, Copy, Default)]
pub(super) struct BodyInertia {
    /// Directions of the DOFs.
    axes: [Vector; 3],
    /// Angular velocity, rad/s, and acceleration, rad/s².
    pub(super) angular_velocity: Vector,
    pub(super) angular_acceleration: Vector,
    /// Acceleration of the axis of rotation, m/s².
    pub(super) acceleration: Vector,
    /// Mass, kg, first moment, kg m, and inertia tensor, kg m², about the axis of rotation.
    mass: f64,
    first: Vector,
    about: [Vector; 3],
}

fn times(matrix: &[Vector; 3], vector: Vector) -> Vector {
    matrix.map(|row| dot(row, vector))
}

fn opposite(sum: &[Vector]) -> Vector {
    scaled(sum.iter().copied().fold([0.0; 3], plus), -1.0)
}

impl BodyInertia {
    /// Returns the inertia of a body of a system at a time, from its inertia about its axis of
    /// rotation along its own axes.
    pub(super) fn at(system: &System<'_>, body: usize, inertia: &Inertia, time: f64) -> BodyInertia {
        let motion = system.scene.bodies[body].motion.as_ref();
        let Inertia { mass, moment, about } = system.inertia_on_ground(body, time, inertia);
        BodyInertia {
            axes: system.axes(body, time),
            angular_velocity: angular_velocity(motion, time),
            angular_acceleration: angular_acceleration(motion, time),
            acceleration: point_acceleration(motion, time, system.origin(body, time)),
            mass,
            first: moment,
            about,
        }
    }

    /// Returns whether the prescribed motion is without acceleration and rotation.
    pub(super) fn is_uniform(&self) -> bool {
        [self.angular_velocity, self.angular_acceleration, self.acceleration] == [[0.0; 3]; 3]
    }

    /// Transforms six components along the DOFs to ground axes.
    pub(super) fn to_ground(self, by: [f64; 6]) -> Pair {
        let sum = |from: usize| {
            (0..3).fold([0.0; 3], |sum, axis| plus(sum, scaled(self.axes[axis], by[from + axis])))
        };
        [sum(0), sum(3)]
    }

    /// Returns the component of a force and a moment on a DOF.
    pub(super) fn along(&self, [force, moment]: Pair, component: usize) -> f64 {
        dot(self.axes[component % 3], if component < 3 { force } else { moment })
    }

    /// Returns the second derivative of the first moment, and the derivative of the angular
    /// momentum, of the prescribed rotation.
    fn prescribed(&self) -> Pair {
        let (w, by) = (self.angular_velocity, self.angular_acceleration);
        let swept = plus(cross(by, self.first), cross(w, cross(w, self.first)));
        let momentum = plus(times(&self.about, by), cross(w, times(&self.about, w)));
        [swept, momentum]
    }

    /// Returns the inertia force and moment of the prescribed motion.
    pub(super) fn load(&self) -> Pair {
        let [swept, momentum] = self.prescribed();
        let force = opposite(&[scaled(self.acceleration, self.mass), swept]);
        [force, opposite(&[momentum, cross(self.first, self.acceleration)])]
    }

    /// Returns the inertia force and moment due to deviations and their rates.
    pub(super) fn following(&self, [_, turn]: Pair, [_, turning]: Pair) -> Pair {
        let (w, s) = (self.angular_velocity, self.first);
        let [swept, momentum] = self.prescribed();
        let trace = self.about[0][0] + self.about[1][1] + self.about[2][2];
        let second = minus(scaled(turning, 0.5 * trace), times(&self.about, turning));
        let coriolis = scaled(cross(turning, cross(w, s)), 2.0);
        let force = opposite(&[coriolis, cross(turn, swept)]);
        let shifted = cross(cross(turn, s), self.acceleration);
        let moment = opposite(&[scaled(cross(w, second), -2.0), cross(turn, momentum), shifted]);
        [force, moment]
    }

    /// Returns the inertia force and moment due to accelerations of the deviations.
    pub(super) fn resisting(&self, [shift, turn]: Pair) -> Pair {
        let force = opposite(&[scaled(shift, self.mass), cross(turn, self.first)]);
        [force, opposite(&[times(&self.about, turn), cross(self.first, shift)])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_close(one: Vector, other: Vector, tolerance: f64) {
        assert!((0..3).all(|k| (one[k] - other[k]).abs() < tolerance), "{one:?} {other:?}");
    }

    /// Rotates by Rodrigues' formula.
    fn rotated(by: Vector, x: Vector) -> Vector {
        let angle = dot(by, by).sqrt();
        if angle == 0.0 {
            return x;
        }
        let axis = scaled(by, angle.recip());
        let across = plus(scaled(x, angle.cos()), scaled(cross(axis, x), angle.sin()));
        plus(across, scaled(axis, dot(axis, x) * (1.0 - angle.cos())))
    }

    /// Four particles without symmetry that rotate with acceleration about a fixed direction while
    /// the axis moves and the frame deviates: the forces of the particles, by differences of their
    /// positions, are those of the formulas.
    #[test]
    fn inertia_forces_are_those_of_particles() {
        let particles: [(f64, Vector); 4] = [
            (1.0, [0.3, 0.1, -0.2]),
            (2.0, [-0.1, 0.4, 0.1]),
            (0.5, [0.2, -0.3, 0.5]),
            (1.5, [-0.4, -0.2, 0.3]),
        ];
        let axis: Vector = [2.0 / 3.0, 1.0 / 3.0, -2.0 / 3.0];
        let (speed, growth) = (3.0, 5.0);
        let small = 1e-6;
        let origin = |t: f64| [0.2 * t * t, -0.5 * t * t, 0.1 + 0.3 * t * t];
        let shift = |t: f64| [small * (1.0 + t - 2.0 * t * t), small * t * t, small * (2.0 - t)];
        let turn = |t: f64| {
            [small * (0.5 - t + t * t), small * (1.0 + 2.0 * t - t * t), small * (-0.3 + t + 2.0 * t * t)]
        };
        let r = |x: Vector, t: f64| rotated(scaled(axis, speed * t + 0.5 * growth * t * t), x);
        let arm = |x: Vector, t: f64| rotated(turn(t), r(x, t));
        let h = 1e-3;
        // Fourth-order difference of the second derivative at 0.
        let second = |f: &dyn Fn(f64) -> Vector| -> Vector {
            let at = |k: f64| f(k * h);
            std::array::from_fn(|i| {
                let sum =
                    -at(-2.0)[i] + 16.0 * at(-1.0)[i] - 30.0 * at(0.0)[i] + 16.0 * at(1.0)[i] - at(2.0)[i];
                sum / (12.0 * h * h)
            })
        };
        let (mut prescribed, mut deviating) = ([[0.0; 3]; 2], [[0.0; 3]; 2]);
        let mut body = BodyInertia {
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            angular_velocity: scaled(axis, speed),
            angular_acceleration: scaled(axis, growth),
            acceleration: second(&origin),
            ..BodyInertia::default()
        };
        let add = |sum: &mut Pair, [force, moment]: Pair| {
            *sum = [plus(sum[0], force), plus(sum[1], moment)];
        };
        for (mass, x) in particles {
            body.mass += mass;
            body.first = plus(body.first, scaled(x, mass));
            for i in 0..3 {
                for j in 0..3 {
                    let square = if i == j { dot(x, x) } else { 0.0 };
                    body.about[i][j] += mass * (square - x[i] * x[j]);
                }
            }
            // Differences of the deviations alone are not rounded by the large prescribed motion.
            let force = scaled(plus(second(&|t| r(x, t)), second(&origin)), -mass);
            let more = scaled(second(&|t| plus(shift(t), minus(arm(x, t), r(x, t)))), -mass);
            let moved = minus(arm(x, 0.0), r(x, 0.0));
            add(&mut prescribed, [force, cross(x, force)]);
            add(&mut deviating, [more, plus(cross(moved, force), cross(arm(x, 0.0), more))]);
        }
        let rate = [[small, 0.0, -small], [-small, 2.0 * small, small]];
        let acceleration = [[-4.0 * small, 2.0 * small, 0.0], [2.0 * small, -2.0 * small, 4.0 * small]];
        let [load, moment] = body.load();
        assert_close(load, prescribed[0], 1e-7);
        assert_close(moment, prescribed[1], 1e-7);
        let (following, resisting) =
            (body.following([shift(0.0), turn(0.0)], rate), body.resisting(acceleration));
        for half in [0, 1] {
            // Products of deviations are a few hundred times the square of them.
            assert_close(plus(following[half], resisting[half]), deviating[half], 1e-3 * small);
            assert!(dot(deviating[half], deviating[half]).sqrt() > small, "all terms are negligible");
        }
    }

    /// A wheel that rotates about the third axis has the gyroscopic moment `J W theta' x a`.
    #[test]
    fn a_wheel_has_a_gyroscopic_moment() {
        let wheel = BodyInertia {
            about: [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]],
            angular_velocity: [0.0, 0.0, 10.0],
            ..BodyInertia::default()
        };
        let [_, moment] = wheel.following([[0.0; 3]; 2], [[0.0; 3], [0.1, 0.2, 0.3]]);
        let meant = scaled(cross([0.1, 0.2, 0.3], [0.0, 0.0, 1.0]), -30.0);
        assert_close(moment, meant, 1e-12);
    }
}
