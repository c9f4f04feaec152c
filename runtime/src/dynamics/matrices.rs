//! Mass, damping and the loads by inertia of all coordinates of a plane model at a time.
//!
//! A body moves by its prescribed motion, by the deviations of its frame (two displacements along ground axes of its axle, a turn), and by its
//! modal coordinates, in its own axes. To the first order in what deviates, with s the first moment of mass about the axle in ground axes, a the
//! acceleration of the axle, omega and alpha the angular velocity and acceleration of the prescribed motion:
//!
//! - mass of the frame: `[m, 0, -s_y; 0, m, s_x; -s_y, s_x, J]`; with a mode `phi' M r`, turned to ground axes;
//! - load on the frame: `-(m a + alpha e3 x s - omega² s)` and `-(J alpha + s x a)`;
//! - load on a mode: `-(phi' M r) (a, alpha) + omega² phi' M (x - axle) - 2 omega phi' M (e3 x phi) q'`.
//!
//! The last one, of Coriolis, is taken at the velocities that the step begins with, gone on by their accelerations: it is of the second order in
//! the step as all else. That centrifugal tension stiffens a ring, and that its modes soften as they turn, is left out: both are of the order of
//! `(omega / omega_n)²`.

use super::modal::Modes;
use crate::bearing::damping;
use crate::error::EngineError;
use crate::inertia::Inertia;
use crate::motion::{angular_acceleration, angular_velocity, point_acceleration};
use crate::scene::Fidelity;
use crate::system::{System, pose};

/// At a time, per width of the model: freedoms first, then modal coordinates.
pub(super) struct Matrices {
    /// Between freedoms, row-major.
    pub mass: Vec<f64>,
    /// Freedoms by modal coordinates, row-major.
    pub coupling: Vec<f64>,
    /// Of bearings, between freedoms, row-major.
    pub damping: Vec<f64>,
    /// Loads by the prescribed motion on freedoms.
    pub load: Vec<f64>,
    /// The same on modal coordinates, but for those of Coriolis.
    pub modal_load: Vec<f64>,
    /// Of every body.
    bodies: Vec<Moving>,
}

/// A body at a time.
#[derive(Clone, Copy, Default)]
struct Moving {
    /// Angular velocity, rad/s.
    spin: f64,
    /// kg, kg m and kg m², about the axle along ground axes.
    mass: f64,
    first: [f64; 2],
    polar: f64,
    /// Force (N) and moment (N m) of inertia by the prescribed motion.
    load: [f64; 3],
}

/// Where the components of a frame in the plane stand among those of [`crate::scene::FREEDOMS`].
const IN_PLANE: [usize; 3] = [0, 1, 5];

impl Matrices {
    /// `inertias` are those of the bodies about their axles.
    ///
    /// # Errors
    /// A frame is not a number.
    pub fn at(
        system: &System<'_>,
        inertias: &[Inertia],
        modes: &Modes,
        time: f64,
    ) -> Result<Matrices, EngineError> {
        let (freedoms, width, count) = (&system.freedoms, system.width(), modes.count());
        let m = freedoms.len();
        let mut matrices = Matrices {
            mass: vec![0.0; m * m],
            coupling: vec![0.0; m * count],
            damping: damping(system.scene, &system.bearings, freedoms, width, time)?,
            load: vec![0.0; m],
            modal_load: vec![0.0; count],
            bodies: Vec::with_capacity(system.scene.bodies.len()),
        };
        for index in 0..system.scene.bodies.len() {
            let body = &system.scene.bodies[index];
            let modal = modes.of_body(index);
            let spin = angular_velocity(body.motion.as_ref(), time)[2];
            let axle = system.axle(index);
            let (angle, ground) = (pose(system.scene, index, time)?.angle, system.origin(index, time));
            let [ax, ay, _] = point_acceleration(body.motion.as_ref(), time, ground);
            let alpha = angular_acceleration(body.motion.as_ref(), time)[2];
            let own = inertias.get(index).copied().unwrap_or_default();
            let turned = |[x, y]: [f64; 2], by: f64| {
                let (sine, cosine) = by.sin_cos();
                [cosine * x - sine * y, sine * x + cosine * y]
            };
            let s = turned([own.moment[0], own.moment[1]], angle);
            let entry = |one: usize, other: usize| match (one.min(other), one.max(other)) {
                (0, 0) | (1, 1) => own.mass,
                (0, 5) => -s[1],
                (1, 5) => s[0],
                (5, 5) => own.polar(),
                _ => 0.0,
            };
            let by_motion = [
                -(own.mass * ax - alpha * s[1] - spin * spin * s[0]),
                -(own.mass * ay + alpha * s[0] - spin * spin * s[1]),
                -(own.polar() * alpha + s[0] * ay - s[1] * ax),
            ];
            matrices.bodies.push(Moving {
                spin,
                mass: own.mass,
                first: s,
                polar: own.polar(),
                load: by_motion,
            });
            let load = |component: usize| {
                IN_PLANE.iter().position(|c| *c == component).map_or(0.0, |at| by_motion[at])
            };
            for (i, one) in freedoms.iter().enumerate().filter(|(_, freedom)| freedom.body == index) {
                matrices.load[i] += load(one.component) / width;
                for (j, other) in freedoms.iter().enumerate().filter(|(_, freedom)| freedom.body == index) {
                    matrices.mass[i * m + j] += entry(one.component, other.component) / width;
                }
            }
            let Some((own, first)) = modal else { continue };
            // Modes are told in the axes of the teeth.
            let stands = angle + body.phase;
            let [px, py] = turned([axle[0], axle[1]], -body.phase);
            let [bx, by] = turned([ax, ay], -stands);
            for (k, &[cx, cy, about]) in own.coupling.iter().enumerate() {
                let about = about - (px * cy - py * cx);
                let [gx, gy] = turned([cx, cy], stands);
                let swung = own.centrifugal[k] - (px * cx + py * cy);
                matrices.modal_load[first + k] = spin * spin * swung - (cx * bx + cy * by) - about * alpha;
                for (i, freedom) in freedoms.iter().enumerate().filter(|(_, freedom)| freedom.body == index) {
                    matrices.coupling[i * count + first + k] = match freedom.component {
                        0 => gx,
                        1 => gy,
                        5 => about,
                        _ => 0.0,
                    };
                }
            }
        }
        Ok(matrices)
    }

    /// Adds the loads of Coriolis on modal coordinates that move with these velocities.
    pub fn add_coriolis(&self, modes: &Modes, velocity: &[f64], load: &mut [f64]) {
        let turning = self.bodies.iter().map(|body| body.spin).enumerate();
        for (body, spin) in turning.filter(|(_, spin)| *spin != 0.0) {
            let Some((own, first)) = modes.of_body(body) else { continue };
            for k in 0..own.count() {
                let across: f64 =
                    (0..own.count()).map(|l| own.gyroscopic[(k, l)] * velocity[first + l]).sum();
                load[first + k] -= 2.0 * spin * across;
            }
        }
    }
}

impl Matrices {
    /// What the inertia of every body does to its frame, in the order of [`crate::scene::FREEDOMS`], N and N m: by the prescribed motion and by
    /// the accelerations of freedoms and modal coordinates.
    pub fn inertia(&self, system: &System<'_>, modes: &Modes, acceleration: &[f64]) -> Vec<[f64; 6]> {
        let (m, count) = (system.freedoms.len(), modes.count());
        let of = |(index, body): (usize, &Moving)| {
            let [ax, ay, .., turn] = system.moved(index, &acceleration[..m]);
            let [sx, sy] = body.first;
            let mut wrench = [0.0; 6];
            wrench[0] = body.load[0] - (body.mass * ax - sy * turn);
            wrench[1] = body.load[1] - (body.mass * ay + sx * turn);
            wrench[5] = body.load[2] - (body.polar * turn + sx * ay - sy * ax);
            for (i, freedom) in
                system.freedoms.iter().enumerate().filter(|(_, freedom)| freedom.body == index)
            {
                let modal =
                    (0..count).map(|k| self.coupling[i * count + k] * acceleration[m + k]).sum::<f64>();
                wrench[freedom.component] -= system.width() * modal;
            }
            wrench
        };
        self.bodies.iter().enumerate().map(of).collect()
    }
}

/// What dynamics asks of a model before its structures are built: that it is a section.
///
/// # Errors
/// E0761: the model is in space.
pub(super) fn check_section(fidelity: Fidelity) -> Result<(), EngineError> {
    match fidelity {
        Fidelity::Plane => Ok(()),
        Fidelity::Solid(_) => Err(EngineError::new(
            "E0761",
            "dynamic analyses are of plane models",
            "choose the fidelity \"plane\", or the method \"quasi_static\"",
        )
        .blame("fidelity")),
    }
}

/// That free bodies have mass.
///
/// # Errors
/// E0762: a free freedom has no inertia.
pub(super) fn check(system: &System<'_>, inertias: &[Inertia]) -> Result<(), EngineError> {
    for freedom in &system.freedoms {
        let body = &system.scene.bodies[freedom.body];
        let inertia = inertias.get(freedom.body).copied().unwrap_or_default();
        let (resists, what) = match freedom.component {
            0..3 => (inertia.mass, "mass"),
            _ => (inertia.polar(), "moment of inertia"),
        };
        if !(resists.is_finite() && resists > 0.0) {
            return Err(EngineError::new(
                "E0762",
                format!("body \"{}\" is free to move and has no {what}", body.name),
                "give it a `mass` and an `inertia`, or hold it",
            )
            .blame("free")
            .about(crate::error::Subject::Body(freedom.body)));
        }
    }
    Ok(())
}
