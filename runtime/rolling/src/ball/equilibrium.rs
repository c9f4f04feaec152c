//! Equilibrium of one ball between the grooves.

use super::contact::GrooveForce;
use super::geometry::{BallKind, BallRow, Groove};
use super::motion::Motion;
use crate::element::{Local, Response};
use crate::linear::{dot, solve};
use libm::{atan2, hypot};

/// Largest number of steps of a ball's equilibrium.
const STEPS: usize = 60;
/// Residual relative to the largest force on a ball.
const TOLERANCE: f64 = 1e-13;

/// One contact of a ball.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BallContact {
    /// Contact load, N.
    pub load: f64,
    /// Contact angle, rad, from the radial direction; positive if the inner ring is pushed to +z.
    pub angle: f64,
    /// Largest pressure, Pa.
    pub pressure: f64,
    /// Semi-axis of the contact ellipse across the groove, m.
    pub across: f64,
    /// Semi-axis of the contact ellipse in the rolling direction, m.
    pub along: f64,
}

/// State of one ball.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BallState {
    /// Contacts with the inner ring: one, or two for four-point bearings (positive angle first).
    pub inner: Vec<BallContact>,
    /// Contacts with the outer ring.
    pub outer: Vec<BallContact>,
    /// Radial and axial displacement of the ball's centre from the pitch circle, m.
    pub center: [f64; 2],
    /// Friction at the outer race that balances the gyroscopic moment, N.
    pub friction: f64,
}

/// Forces at a position of the ball.
struct Balance {
    grooves: [GrooveForce; 4],
    /// Sum of the forces on the ball, N.
    residual: [f64; 2],
    /// Derivative of the residual with respect to the position of the ball.
    by_ball: [[f64; 2]; 2],
    /// Derivative of inertia with respect to the centre of the inner and of the outer groove.
    inertia_by_inner: [[f64; 2]; 2],
    /// Sum of the magnitudes of all forces, N.
    scale: f64,
    inertia: [f64; 2],
}

impl BallRow {
    /// Returns the centres of the grooves at a displacement of the inner ring.
    fn centers(&self, ring: &Local) -> [[f64; 2]; 4] {
        let mut centers = [[0.0; 2]; 4];
        for (center, groove) in centers.iter_mut().zip(&self.grooves) {
            let [radial, axial] = groove.center;
            let radius = self.radius(groove);
            *center = match groove.inner {
                true => [radial + (ring[0] + axial * ring[2]), axial + (ring[1] - radius * ring[2])],
                false => groove.center,
            };
        }
        centers
    }

    /// Returns the radius of the centre of a groove, m.
    fn radius(&self, groove: &Groove) -> f64 {
        0.5 * self.geometry.pitch_diameter + groove.center[0]
    }

    /// Returns the motion of a groove centre, radial and axial, with the displacement of the ring.
    fn ring_motion(&self, groove: &Groove) -> [[f64; 3]; 2] {
        [[1.0, 0.0, groove.center[1]], [0.0, 1.0, -self.radius(groove)]]
    }

    /// Returns whether both contacts of a ball have the same load and direction.
    fn is_series(&self, motion: &Motion) -> bool {
        !motion.has_inertia() && !matches!(self.geometry.kind, BallKind::FourPoint { .. })
    }

    /// Computes the response of a ball.
    pub(crate) fn response(&self, ring: &Local, motion: &Motion) -> Response {
        let centers = self.centers(ring);
        let mut response = Response::default();
        if self.is_series(motion) {
            let (inner, outer) = (centers[0], centers[1]);
            let force = self.series_force([inner[0] - outer[0], inner[1] - outer[1]]);
            if force.load > 0.0 {
                let motion = self.ring_motion(&self.grooves[0]);
                add_groove(&mut response, &motion, &force);
            }
            return response;
        }
        let (ball, balance, converged) = self.settle(&centers, motion);
        response.unconverged = !converged || !ball.iter().all(|x| x.is_finite());
        if balance.scale == 0.0 {
            return response;
        }
        // Derivative of the residual with respect to the displacement of the ring.
        let mut by_ring = [[0.0; 3]; 2];
        let mut force_by_ball = [[0.0; 2]; 3];
        for (groove, force) in self.grooves.iter().zip(&balance.grooves) {
            if !groove.inner {
                continue;
            }
            let motion = self.ring_motion(groove);
            add_groove(&mut response, &motion, force);
            for i in 0..2 {
                for k in 0..3 {
                    by_ring[i][k] += dot(&force.exact[i], &motion.map(|column| column[k]));
                }
                for k in 0..3 {
                    for j in 0..2 {
                        force_by_ball[k][j] -= motion[i][k] * force.exact[i][j];
                    }
                }
            }
        }
        let first = self.ring_motion(&self.grooves[0]);
        for i in 0..2 {
            for k in 0..3 {
                by_ring[i][k] += dot(&balance.inertia_by_inner[i], &first.map(|column| column[k]));
            }
        }
        if solve(balance.by_ball, &mut by_ring) {
            for i in 0..3 {
                for j in 0..3 {
                    response.stiffness[i][j] -=
                        force_by_ball[i][0] * by_ring[0][j] + force_by_ball[i][1] * by_ring[1][j];
                }
            }
        }
        response
    }

    /// Computes loads, contact angles and pressures of a ball.
    pub(crate) fn state(&self, ring: &Local, motion: &Motion) -> BallState {
        let centers = self.centers(ring);
        let (ball, forces, axial_inertia) = if self.is_series(motion) {
            let (inner, outer) = (centers[0], centers[1]);
            let force = self.series_force([inner[0] - outer[0], inner[1] - outer[1]]);
            (self.start(&centers, [0.0; 2]), [force; 4], 0.0)
        } else {
            let (ball, balance, _) = self.settle(&centers, motion);
            (ball, balance.grooves, balance.inertia[1])
        };
        // Centrifugal force has no axial component.
        let cosine = forces[self.grooves.len() / 2].direction[0];
        let friction = if axial_inertia == 0.0 { 0.0 } else { (axial_inertia / cosine).abs() };
        let mut state = BallState { center: ball, friction, ..BallState::default() };
        for (groove, force) in self.grooves.iter().zip(&forces) {
            let ellipse = self.contact(groove, force.direction[0]).ellipse(force.load);
            let contact = BallContact {
                load: force.load,
                angle: if force.load > 0.0 { atan2(force.direction[1], force.direction[0]) } else { 0.0 },
                pressure: ellipse.pressure,
                across: ellipse.x,
                along: ellipse.y,
            };
            if groove.inner { &mut state.inner } else { &mut state.outer }.push(contact);
        }
        state
    }

    /// Returns a first position of the ball.
    fn start(&self, centers: &[[f64; 2]; 4], inertia: [f64; 2]) -> [f64; 2] {
        if matches!(self.geometry.kind, BallKind::FourPoint { .. }) {
            let sum = |k: usize| centers.iter().map(|center| center[k]).sum::<f64>() / 4.0;
            return [sum(0), sum(1)];
        }
        let (inner, outer) = (centers[0], centers[1]);
        let v = [inner[0] - outer[0], inner[1] - outer[1]];
        let force = self.series_force(v);
        let (free, size) = (self.grooves[1].free, self.geometry.ball_diameter);
        if force.load > 0.0 {
            let contact = self.contact(&self.grooves[1], force.direction[0]);
            let reach = free + contact.compliance() * libm::pow(force.load, 2.0 / 3.0);
            return [outer[0] + reach * force.direction[0], outer[1] + reach * force.direction[1]];
        }
        // Inertia presses the unloaded ball against the outer groove.
        let load = hypot(inertia[0], inertia[1]);
        let direction = if load > 0.0 { [inertia[0] / load, inertia[1] / load] } else { force.direction };
        let contact = self.contact(&self.grooves[1], direction[0]);
        let reach = free + (contact.compliance() * libm::pow(load, 2.0 / 3.0)).min(0.1 * size);
        [outer[0] + reach * direction[0], outer[1] + reach * direction[1]]
    }

    /// Finds the position of the ball where its forces balance.
    ///
    /// Newton's method on all forces converges quadratically. Where it does not reduce the
    /// residual, the stiffness k of the contacts and inertia are kept at their last values: the
    /// ball then has a convex potential energy, which Newton's method with a line search minimizes
    /// from anywhere.
    fn settle(&self, centers: &[[f64; 2]; 4], motion: &Motion) -> ([f64; 2], Balance, bool) {
        let inertia = self.inertia(motion, self.free_angle, self.free_angle).map(|force| force.value);
        let mut ball = self.start(centers, inertia);
        let mut balance = self.balance(centers, ball, motion);
        let mut fallbacks = 0;
        for _ in 0..STEPS {
            let size = hypot(balance.residual[0], balance.residual[1]);
            if size <= TOLERANCE * balance.scale {
                return (ball, balance, true);
            }
            let mut step = balance.residual.map(|force| [-force]);
            let mut improved = false;
            if solve(balance.by_ball, &mut step) {
                for fraction in [1.0, 0.5, 0.25] {
                    let next = [ball[0] + fraction * step[0][0], ball[1] + fraction * step[1][0]];
                    let trial = self.balance(centers, next, motion);
                    if hypot(trial.residual[0], trial.residual[1]) < 0.9 * size && trial.scale > 0.0 {
                        (ball, balance, improved) = (next, trial, true);
                        break;
                    }
                }
            }
            if improved {
                continue;
            }
            // The residual is as small as rounding permits.
            if size <= 1e3 * TOLERANCE * balance.scale {
                return (ball, balance, true);
            }
            if fallbacks == 20 {
                break;
            }
            fallbacks += 1;
            ball = self.minimize(centers, ball, balance.inertia);
            balance = self.balance(centers, ball, motion);
        }
        let size = hypot(balance.residual[0], balance.residual[1]);
        let converged = size <= 1e-9 * balance.scale;
        (ball, balance, converged)
    }

    /// Computes all forces on a ball.
    fn balance(&self, centers: &[[f64; 2]; 4], ball: [f64; 2], motion: &Motion) -> Balance {
        let mut balance = Balance {
            grooves: Default::default(),
            residual: [0.0; 2],
            by_ball: [[0.0; 2]; 2],
            inertia_by_inner: [[0.0; 2]; 2],
            scale: 0.0,
            inertia: [0.0; 2],
        };
        for (k, groove) in self.grooves.iter().enumerate() {
            let force = self.groove_force(groove, centers[k], ball, None);
            balance.scale += force.load;
            for i in 0..2 {
                balance.residual[i] += force.force[i];
                for j in 0..2 {
                    balance.by_ball[i][j] -= force.exact[i][j];
                }
            }
            balance.grooves[k] = force;
        }
        if !motion.has_inertia() {
            return balance;
        }
        let outer = self.grooves.len() / 2;
        let direction = [balance.grooves[0].direction, balance.grooves[outer].direction];
        // Four-point bearings have several angles; their orbital speed is nominal.
        let plain = Motion { gyroscopic: false, cage: super::CageSpeed::Nominal, ..*motion };
        let motion = if outer == 1 { motion } else { &plain };
        let angles = direction.map(|[radial, axial]| atan2(axial, radial));
        let inertia = self.inertia(motion, angles[0], angles[1]);
        let distance = [balance.grooves[0].distance, balance.grooves[outer].distance];
        for i in 0..2 {
            let force = inertia[i];
            balance.inertia[i] = force.value;
            balance.residual[i] += force.value;
            balance.scale += force.value.abs();
            for j in 0..2 {
                // An angle grows with the motion across the line to the groove centre.
                let across = |k: usize| {
                    let [radial, axial] = direction[k];
                    if distance[k] > 0.0 { [-axial, radial][j] / distance[k] } else { 0.0 }
                };
                balance.by_ball[i][j] += force.by[1] * across(1) - force.by[0] * across(0);
                balance.inertia_by_inner[i][j] = force.by[0] * across(0);
            }
        }
        balance
    }

    /// Minimizes the potential energy of a ball with fixed contact stiffness and inertia.
    fn minimize(&self, centers: &[[f64; 2]; 4], start: [f64; 2], inertia: [f64; 2]) -> [f64; 2] {
        let mut stiffness = [0.0; 4];
        for (k, groove) in self.grooves.iter().enumerate() {
            let direction = self.groove_force(groove, centers[k], start, Some(0.0)).direction;
            stiffness[k] = self.contact(groove, direction[0]).stiffness;
        }
        let evaluate = |ball: [f64; 2]| {
            let mut energy = -dot(&inertia, &ball);
            let mut gradient = [-inertia[0], -inertia[1]];
            let mut hessian = [[0.0; 2]; 2];
            for (k, groove) in self.grooves.iter().enumerate() {
                let force = self.groove_force(groove, centers[k], ball, Some(stiffness[k]));
                energy += 0.4 * force.load * force.compression.max(0.0);
                for i in 0..2 {
                    gradient[i] -= force.force[i];
                    for j in 0..2 {
                        hessian[i][j] += force.frozen[i][j];
                    }
                }
            }
            (energy, gradient, hessian)
        };
        let mut ball = start;
        let (mut energy, mut gradient, mut hessian) = evaluate(ball);
        let least = 1e-12 * stiffness[0].max(stiffness[1]) * self.grooves[0].free.sqrt();
        for _ in 0..STEPS {
            let size = hypot(gradient[0], gradient[1]);
            if size == 0.0 {
                break;
            }
            let added = least + 1e-12 * (hessian[0][0] + hessian[1][1]);
            hessian[0][0] += added;
            hessian[1][1] += added;
            let mut step = gradient.map(|force| [-force]);
            if !solve(hessian, &mut step) {
                break;
            }
            // A ball without contact has almost no stiffness: limit the step.
            let limit = (0.1 * self.geometry.ball_diameter / hypot(step[0][0], step[1][0])).min(1.0);
            let step = [limit * step[0][0], limit * step[1][0]];
            let slope = dot(&gradient, &step);
            let mut fraction = 1.0;
            let next = loop {
                let next = [ball[0] + fraction * step[0], ball[1] + fraction * step[1]];
                let trial = evaluate(next);
                if trial.0 <= energy + 1e-4 * fraction * slope || hypot(trial.1[0], trial.1[1]) < 0.9 * size {
                    break Some((next, trial));
                }
                fraction *= 0.5;
                if fraction < 1e-12 {
                    break None;
                }
            };
            let Some((next, trial)) = next else { break };
            ball = next;
            (energy, gradient, hessian) = trial;
        }
        ball
    }
}

/// Adds force and stiffness of an inner groove at a fixed ball.
fn add_groove(response: &mut Response, motion: &[[f64; 3]; 2], force: &GrooveForce) {
    for i in 0..3 {
        for j in 0..2 {
            response.force[i] += motion[j][i] * force.force[j];
            for k in 0..3 {
                response.stiffness[i][k] +=
                    motion[j][i] * (force.exact[j][0] * motion[0][k] + force.exact[j][1] * motion[1][k]);
            }
        }
    }
}
