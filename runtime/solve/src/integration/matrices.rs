//! Mass matrix, damping matrix and inertia loads of all coordinates of a plane model at a time.
//!
//! The position of a particle of a body is `A + u + R(phi + theta) (X + sum phi_k q_k)`. A is the
//! prescribed position of the axis of rotation, phi the prescribed angle, and u and theta are the
//! deviations of the frame (u along ground axes). X is the particle's position relative to the axis
//! and phi_k its displacement by the modal coordinate q_k, both in the body's axes. Let a be the
//! acceleration of A, omega and alpha the angular velocity and acceleration of phi, and e the
//! rotation by a right angle (`e3 x`). The virtual work of the particles' inertia, to first order
//! in u, theta, q and their rates, gives the inertia forces (negative)
//!
//! ```text
//! on u:      m u'' + theta'' e s - 2 omega theta' s - (alpha s + omega² e s) theta
//!            + m a + alpha e s - omega² s
//!            + sum (c q'' + 2 omega e c q' + (alpha e - omega²) c q)
//! on theta:  J theta'' + e s . u'' - (s . a) theta + J alpha + e s . a
//!            + sum (b q'' + 2 omega x q' + (2 alpha x + e c . a) q)
//! on q_k:    q_k'' + c . u'' + b theta'' - 2 omega x theta' + (e c . a) theta
//!            + c . a + b alpha - omega² x + sum (2 omega g q_l' + alpha g q_l)
//! ```
//!
//! with the mass m, the first moment `s = R int X` and the second moment J about the axis; for a
//! mode `c = R int phi`, `b = int phi . e X`, `x = int phi . X` and `g = int phi_k . e phi_l`, all
//! integrals over the mass. So frames and modes are coupled by Coriolis, Euler and centrifugal
//! terms. Forces and moments on a whole body are the rates of its momentum and angular momentum.
//! Constrained components of a frame have the same terms as reactions.
//!
//! **Neglected terms.** The equation of q_k also contains `- omega² q_k`, by which rotation softens
//! modes. The centrifugal tension stiffens a rotating body, by more than that if the mode bends a
//! rim; it is of second order in the displacements and not among the modal data. Both change a
//! natural frequency by fractions of the order of `(omega / omega_n)²`, and including only one
//! would give the wrong sign, so both are neglected. At a tenth of the lowest natural frequency
//! this is one percent; from there on a step issues a warning ([`Matrices::speed_warnings`]). The
//! effect of the acceleration of the path on the stiffness of modes is neglected for the same
//! reason. External loads act on the axis along ground axes, so they do not depend on deviations.
//!
//! Mass-proportional (Rayleigh) damping acts on the rates of deviations: it damps deviations from
//! the prescribed motion, not that motion.
//!
//! See `docs/theory/dynamics.md`.

use crate::system::System;
use calyx_fe::inertia::Inertia;
use calyx_model::bearing::{Support, damping};
use calyx_model::connection::ConnectionState;
use calyx_model::dof::Dof;
use calyx_model::elastic_body::SharedElasticBody;
use calyx_model::fidelity::Fidelity;
use calyx_model::frames::pose;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::{angular_acceleration, angular_velocity, point_acceleration};
use calyx_model::plan::Plan;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec2::dot;

/// Matrices at a time, per width of the model: DOFs first, then modal coordinates.
pub struct Matrices {
    /// Mass matrix of the DOFs, row-major.
    pub mass: Vec<f64>,
    /// Mass coupling, DOFs by modal coordinates, row-major.
    pub coupling: Vec<f64>,
    /// Damping matrix of bearings between DOFs, row-major.
    pub damping: Vec<f64>,
    /// Inertia loads of the prescribed motion on the DOFs.
    pub load: Vec<f64>,
    /// Inertia loads of the prescribed motion on the modal coordinates.
    pub modal_load: Vec<f64>,
    /// State of every body.
    bodies: Vec<BodyMotion>,
    /// Coupling of every modal coordinate.
    arms: Vec<ModalArm>,
    /// Elastic connections with mass, by their index in the scene.
    connections: Vec<(usize, ConnectionState)>,
}

/// State of a body at a time.
#[derive(Clone, Copy, Default)]
struct BodyMotion {
    /// Angular velocity, rad/s, and acceleration, rad/s².
    spin: f64,
    spinning_up: f64,
    /// Acceleration of the axis, m/s².
    acceleration: [f64; 2],
    /// Mass and moments about the axis along ground axes, kg, kg m and kg m².
    mass: f64,
    first: [f64; 2],
    polar: f64,
    /// Inertia force (N) and moment (N m) of the prescribed motion.
    load: [f64; 3],
}

/// Coupling of a modal coordinate with its frame, along ground axes about the axis of rotation.
#[derive(Clone, Copy, Default)]
struct ModalArm {
    /// `c`.
    along: [f64; 2],
    /// `b`.
    about: f64,
    /// `x`.
    outwards: f64,
}

/// Forces on the frame of every body along x and y (N), moments about its axis (N m), and forces on
/// modal coordinates.
pub struct Forces {
    frames: Vec<[f64; 3]>,
    /// Generalized forces on modal coordinates, per width of the model.
    pub modal: Vec<f64>,
}

/// Angular velocity relative to a body's lowest natural frequency from which the neglected terms
/// cause a warning; beyond the second value they are an error.
const FAST: f64 = 0.1;
const TOO_FAST: f64 = 0.5;
/// Indices of the in-plane components of a frame in [`calyx_model::dof::DOF_NAMES`].
const IN_PLANE: [usize; 3] = [0, 1, 5];

/// Rotates by a right angle.
fn across([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

impl Matrices {
    /// Assembles the matrices at a time; `inertias` are those of the bodies about their axes of
    /// rotation.
    ///
    /// # Errors
    /// A frame is NaN.
    pub fn at(system: &System<'_>, inertias: &[Inertia], time: f64) -> Result<Matrices, EngineError> {
        let (dofs, modes) = (&system.dofs, &system.modes);
        let (m, count) = (dofs.len(), modes.count());
        let mut matrices = Matrices {
            mass: vec![0.0; m * m],
            coupling: Vec::new(),
            damping: {
                let Mechanism { bodies, bearings, .. } = system.scene;
                damping(bodies, bearings, &system.bearings, dofs, |body| system.width(body), time)?
            },
            load: vec![0.0; m],
            modal_load: vec![0.0; count],
            bodies: Vec::with_capacity(system.scene.bodies.len()),
            arms: modal_arms(system, time)?,
            connections: Vec::new(),
        };
        for index in 0..system.scene.bodies.len() {
            let body = &system.scene.bodies[index];
            let spin = angular_velocity(body.motion.as_ref(), time)[2];
            let (angle, ground) = (pose(system.scene, index, time)?.angle, system.origin(index, time));
            let [ax, ay, _] = point_acceleration(body.motion.as_ref(), time, ground);
            let alpha = angular_acceleration(body.motion.as_ref(), time)[2];
            let own = inertias.get(index).copied().unwrap_or_default();
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
            matrices.bodies.push(BodyMotion {
                spin,
                spinning_up: alpha,
                acceleration: [ax, ay],
                mass: own.mass,
                first: s,
                polar: own.polar(),
                load: by_motion,
            });
            for (i, one) in dofs.iter().enumerate().filter(|(_, dof)| dof.body == index) {
                for (j, other) in dofs.iter().enumerate().filter(|(_, dof)| dof.body == index) {
                    matrices.mass[i * m + j] += entry(one.component, other.component) / system.width(index);
                }
            }
            let Some((own, first)) = modes.of_body(index) else { continue };
            let loads = matrices.modal_load.iter_mut().zip(&matrices.arms);
            for (load, arm) in loads.skip(first).take(own.count()) {
                *load = spin * spin * arm.outwards - dot(arm.along, [ax, ay]) - arm.about * alpha;
            }
        }
        matrices.add_connections(system, time)?;
        matrices.coupling = on_dofs_by_modes(system, &matrices.arms);
        let by_motion: Vec<[f64; 3]> = matrices.bodies.iter().map(|body| body.load).collect();
        matrices.load = on_dofs(system, &by_motion);
        Ok(matrices)
    }

    /// Adds mass and inertia loads of elastic connections.
    fn add_connections(&mut self, system: &System<'_>, time: f64) -> Result<(), EngineError> {
        let scene = system.scene;
        system.add_connection_mass(&mut self.mass, |body| system.width(body), time)?;
        for &index in &system.connections {
            let connection = &system.elastic_connections[index];
            if connection.mass.is_empty() {
                continue;
            }
            let state = ConnectionState::at(&scene.bodies, connection, time)?;
            // Accelerations of the prescribed motion, as values of all DOFs.
            let dofs = IN_PLANE
                .into_iter()
                .flat_map(|component| connection.bodies().map(move |BodyId(body)| Dof { body, component }));
            let dofs: Vec<Dof> = dofs.collect();
            let of = |dof: &Dof| {
                let BodyMotion { acceleration: [ax, ay], spinning_up, .. } = self.bodies[dof.body];
                [ax, ay, spinning_up][dof.component.min(2)]
            };
            let accelerations: Vec<f64> = dofs.iter().map(of).collect();
            let forces = connection.inertia_forces(&state.motions(&dofs, &accelerations));
            for body in connection.bodies() {
                let wrench = state.wrench_on(body, &forces);
                let load = &mut self.bodies[body.0].load;
                load.iter_mut().zip(IN_PLANE).for_each(|(load, component)| *load += wrench[component]);
            }
            self.connections.push((index, state));
        }
        Ok(())
    }

    /// Returns the inertia forces due to displacements and rates of all coordinates: all terms of
    /// the module's equations except those of accelerations and of the prescribed motion. Linear in
    /// both.
    pub fn following(&self, system: &System<'_>, displacement: &[f64], rate: &[f64]) -> Forces {
        let m = system.dofs.len();
        let mut forces =
            Forces { frames: vec![[0.0; 3]; self.bodies.len()], modal: vec![0.0; self.arms.len()] };
        for (index, body) in self.bodies.iter().enumerate() {
            let BodyMotion { spin, spinning_up, acceleration, first: s, .. } = *body;
            if spin == 0.0 && spinning_up == 0.0 && acceleration == [0.0; 2] {
                continue;
            }
            let turn = system.moved(index, &displacement[..m])[5];
            let turning = system.moved(index, &rate[..m])[5];
            let (by, ahead) = (2.0 * spin * turning + spinning_up * turn, spin * spin * turn);
            let mut frame = [
                by * s[0] + ahead * across(s)[0],
                by * s[1] + ahead * across(s)[1],
                dot(s, acceleration) * turn,
            ];
            if let Some((own, from)) = system.modes.of_body(index) {
                let (count, width) = (own.count(), system.width(index));
                let (q, rates) = (&displacement[m + from..][..count], &rate[m + from..][..count]);
                for (k, arm) in self.arms[from..from + count].iter().enumerate() {
                    let sideways = across(arm.along);
                    let (by, out) = (2.0 * spin * rates[k] + spinning_up * q[k], spin * spin * q[k]);
                    frame[0] += width * (out * arm.along[0] - by * sideways[0]);
                    frame[1] += width * (out * arm.along[1] - by * sideways[1]);
                    let pulled = dot(sideways, acceleration);
                    let about = 2.0 * spin * rates[k] + 2.0 * spinning_up * q[k];
                    frame[2] -= width * (about * arm.outwards + pulled * q[k]);
                    forces.modal[from + k] = 2.0 * spin * arm.outwards * turning - pulled * turn;
                }
                let modal = &mut forces.modal[from..from + count];
                for l in 0..count {
                    let by = 2.0 * spin * rates[l] + spinning_up * q[l];
                    modal.iter_mut().zip(own.gyroscopic.col_as_slice(l)).for_each(|(sum, g)| *sum -= g * by);
                }
            }
            forces.frames[index] = frame;
        }
        forces
    }

    /// Returns warnings about the neglected terms, in sentences.
    ///
    /// # Errors
    /// E0767: a body rotates so fast that its modes differ from those at rest.
    pub fn speed_warnings(&self, system: &System<'_>) -> Result<Vec<String>, EngineError> {
        let mut warnings = Vec::new();
        for (index, body) in self.bodies.iter().enumerate() {
            let Some((own, _)) = system.modes.of_body(index) else { continue };
            let part = own.frequencies.first().map_or(0.0, |lowest| body.spin.abs() / lowest);
            let name = &system.scene.bodies[index].name;
            if part > TOO_FAST {
                return Err(EngineError::new(
                    "E0767",
                    format!("body \"{name}\" turns at more than half of its lowest natural frequency"),
                    "its modes are those of a body that hardly turns: let it turn slower, make it stiffer, or leave modes out by `highest_frequency = 0 Hz`",
                )
                .blame("highest_frequency")
                .about(Subject::Body(index)));
            }
            if part > FAST {
                warnings.push(format!(
                    "body \"{name}\" turns at more than a tenth of its lowest natural frequency: that tension stiffens its modes and turning softens them is left out, and changes the lowest ones by more than a hundredth"
                ));
            }
        }
        Ok(warnings)
    }

    /// Returns the inertia forces of every body on its frame, in the order of
    /// [`calyx_model::dof::DOF_NAMES`], N and N m: those of the prescribed motion, of displacements
    /// and rates, and of the accelerations of DOFs and modal coordinates.
    pub fn inertia(&self, system: &System<'_>, following: &Forces, acceleration: &[f64]) -> Vec<[f64; 6]> {
        let m = system.dofs.len();
        let of = |(index, body): (usize, &BodyMotion)| {
            let [ax, ay, .., turn] = system.moved(index, &acceleration[..m]);
            let ([sx, sy], BodyMotion { load, mass, polar, .. }) = (body.first, *body);
            let own = [mass * ax - sy * turn, mass * ay + sx * turn, polar * turn + sx * ay - sy * ax];
            let mut wrench = [0.0; 6];
            for (k, component) in IN_PLANE.into_iter().enumerate() {
                wrench[component] = load[k] + following.frames[index][k] - own[k];
            }
            if let Some((own, from)) = system.modes.of_body(index) {
                let width = system.width(index);
                for (arm, q) in self.arms[from..from + own.count()].iter().zip(&acceleration[m + from..]) {
                    wrench[0] -= width * arm.along[0] * q;
                    wrench[1] -= width * arm.along[1] * q;
                    wrench[5] -= width * arm.about * q;
                }
            }
            wrench
        };
        let mut wrenches: Vec<[f64; 6]> = self.bodies.iter().enumerate().map(of).collect();
        for (index, state) in &self.connections {
            let connection = &system.elastic_connections[*index];
            let forces = connection.inertia_forces(&state.motions(&system.dofs, &acceleration[..m]));
            for body in connection.bodies() {
                let wrench = state.wrench_on(body, &forces);
                for component in IN_PLANE {
                    wrenches[body.0][component] += wrench[component];
                }
            }
        }
        wrenches
    }
}

impl Forces {
    /// Returns the forces on the DOFs, per width of the model, then on the modal coordinates.
    pub fn on_coordinates(&self, system: &System<'_>) -> Vec<f64> {
        let mut all = on_dofs(system, &self.frames);
        all.extend(&self.modal);
        all
    }
}

fn turned([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    let (sine, cosine) = by.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

/// Returns the coupling of every modal coordinate with its frame at a time.
fn modal_arms(system: &System<'_>, time: f64) -> Result<Vec<ModalArm>, EngineError> {
    let mut arms = Vec::with_capacity(system.modes.count());
    for (index, body) in system.scene.bodies.iter().enumerate() {
        let Some((own, _)) = system.modes.of_body(index) else { continue };
        // Mode shapes are in the axes of the teeth.
        let stands = pose(system.scene, index, time)?.angle + body.phase;
        let [px, py, _] = system.axle(index);
        let [px, py] = turned([px, py], -body.phase);
        arms.extend(own.coupling.iter().zip(&own.centrifugal).map(|(&[cx, cy, about], outwards)| ModalArm {
            along: turned([cx, cy], stands),
            about: about - (px * cy - py * cx),
            outwards: outwards - (px * cx + py * cy),
        }));
    }
    Ok(arms)
}

/// Returns the mass coupling between DOFs and modal coordinates of a plane model at a time,
/// row-major, per width of the model.
///
/// # Errors
/// A frame is NaN.
pub fn coupling(system: &System<'_>, time: f64) -> Result<Vec<f64>, EngineError> {
    Ok(on_dofs_by_modes(system, &modal_arms(system, time)?))
}

fn on_dofs_by_modes(system: &System<'_>, arms: &[ModalArm]) -> Vec<f64> {
    let count = arms.len();
    let mut coupling = vec![0.0; system.dofs.len() * count];
    for (i, dof) in system.dofs.iter().enumerate() {
        let Some((own, first)) = system.modes.of_body(dof.body) else { continue };
        for (k, arm) in arms.iter().enumerate().skip(first).take(own.count()) {
            coupling[i * count + k] = match dof.component {
                0 => arm.along[0],
                1 => arm.along[1],
                5 => arm.about,
                _ => 0.0,
            };
        }
    }
    coupling
}

/// Transforms forces and moments on frames to the DOFs, per width of the model.
fn on_dofs(system: &System<'_>, frames: &[[f64; 3]]) -> Vec<f64> {
    let of = |dof: &Dof| {
        let component = IN_PLANE.iter().position(|component| *component == dof.component);
        component.map_or(0.0, |component| frames[dof.body][component] / system.width(dof.body))
    };
    system.dofs.iter().map(of).collect()
}

/// Checks that transient analysis supports the model, before structures are built: it must be plane
/// and elastic.
///
/// # Errors
/// E0761: the model is three-dimensional. E0781: its bodies are rigid.
pub fn check_section(fidelity: Fidelity) -> Result<(), EngineError> {
    match fidelity {
        Fidelity::Analytic | Fidelity::Plane => Ok(()),
        Fidelity::Rigid => Err(EngineError::new(
            "E0781",
            "the fidelity level \"rigid\" has no forces, so bodies cannot vibrate on their teeth",
            "",
        )
        .blame("fidelity")),
        Fidelity::Solid(_) => Err(solid_model_error()),
    }
}

/// Checks a plan whose fidelity permits both dimensions.
///
/// # Errors
/// E0761: the model is three-dimensional.
pub fn check_in_section(plan: &Plan) -> Result<(), EngineError> {
    if plan.three_dimensional { Err(solid_model_error()) } else { Ok(()) }
}

fn solid_model_error() -> EngineError {
    EngineError::new("E0761", "dynamic analyses are of plane models", "").blame("fidelity")
}

/// Checks that free bodies have mass.
///
/// # Errors
/// E0762: a free DOF has no inertia.
pub fn check_inertia(scene: &Mechanism, dofs: &[Dof], inertias: &[Inertia]) -> Result<(), EngineError> {
    for dof in dofs {
        let body = &scene.bodies[dof.body];
        let inertia = inertias.get(dof.body).copied().unwrap_or_default();
        let (resists, what) = match dof.component {
            0..3 => (inertia.mass, "mass"),
            component => {
                let about = component.saturating_sub(3).min(2);
                (inertia.about[about][about], "moment of inertia")
            }
        };
        let restrained = resists.is_finite() && resists > 0.0;
        if !restrained && !connection_resists(scene, dof) {
            if scene.connections_of(BodyId(dof.body)).any(|connection| connection.body.is_some()) {
                let message = format!("the elastic body of the attachment \"{}\" has no mass", body.name);
                let help = "state the density of its materials, or fix the attachment";
                return Err(EngineError::new("E0762", message, help).about(Subject::Body(dof.body)));
            }
            return Err(EngineError::new(
                "E0762",
                format!("body \"{}\" is free to move and has no {what}", body.name),
                "give it a `mass` and an `inertia`, or constrain it",
            )
            .blame("free")
            .about(Subject::Body(dof.body)));
        }
    }
    Ok(())
}

/// Returns whether an elastic connection has inertia along a DOF.
fn connection_resists(scene: &Mechanism, dof: &Dof) -> bool {
    scene.connections_of(BodyId(dof.body)).any(|connection| {
        // The mass of an elastic body is condensed later, onto all components of its attachments.
        if let Some(SharedElasticBody(body)) = &connection.body {
            return body.has_mass();
        }
        let size = connection.size();
        let own = connection.attachments.iter().enumerate();
        own.filter(|(_, attachment)| attachment.to == Support::Body(BodyId(dof.body))).any(|(index, _)| {
            let row = 6 * index + dof.component;
            connection.mass.get(row * size + row).is_some_and(|&entry| entry > 0.0)
        })
    })
}
