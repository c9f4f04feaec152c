//! Mass matrix, damping matrix and inertia loads of all coordinates at a time.
//!
//! The inertia forces of rigid bodies are those of [`super::body_inertia`]. This module adds the
//! modal coordinates and the elastic connections.
//!
//! **Modes of gears**, in plane models. The position of a particle of a body is `A + u + R(phi +
//! theta) (X + sum phi_k q_k)`. A is the prescribed position of the axis of rotation, phi the
//! prescribed angle, and u and theta are the deviations of the frame (u along ground axes). X is
//! the particle's position relative to the axis and phi_k its displacement by the modal coordinate
//! q_k, both in the body's axes. Let a be the acceleration of A, omega and alpha the angular
//! velocity and acceleration of phi, and e the rotation by a right angle (`e3 x`). To first order
//! in u, theta, q and their rates, the virtual work of the particles' inertia adds the inertia
//! forces (negative)
//!
//! ```text
//! on u:      sum (c q'' + 2 omega e c q' + (alpha e - omega²) c q)
//! on theta:  sum (b q'' + 2 omega x q' + (2 alpha x + e c . a) q)
//! on q_k:    q_k'' + c . u'' + b theta'' - 2 omega x theta' + (e c . a) theta
//!            + c . a + b alpha - omega² x + sum (2 omega g q_l' + alpha g q_l)
//! ```
//!
//! with `c = R int phi`, `b = int phi . e X`, `x = int phi . X` and `g = int phi_k . e phi_l`, all
//! integrals over the mass. So frames and modes are coupled by Coriolis, Euler and centrifugal
//! terms. Forces and moments on a whole body are the rates of its momentum and angular momentum.
//! Constrained components of a frame have the same terms as reactions.
//!
//! **Elastic connections**, such as shafts and housings, have the mass matrix of their attachments,
//! in three dimensions also their component modes with the mass between both, and shafts have
//! gyroscopic terms ([`calyx_model::connection`]).
//!
//! **Neglected terms.** The equation of q_k also contains `- omega² q_k`, by which rotation softens
//! modes. The centrifugal tension stiffens a rotating body, by more than that if the mode bends a
//! rim; it is of second order in the displacements and not among the modal data. Both change a
//! natural frequency by fractions of the order of `(omega / omega_n)²`, and including only one
//! would give the wrong sign, so both are neglected. At a tenth of the lowest natural frequency
//! this is one percent; from there on a step issues a warning ([`Matrices::warnings`]). The
//! effect of the acceleration of the path on the stiffness of modes is neglected for the same
//! reason. Of the elastic bodies that rotate, only shafts have gyroscopic terms. External loads act
//! on the axis along ground axes, so they do not depend on deviations.
//!
//! Mass-proportional (Rayleigh) damping acts on the rates of deviations: it damps deviations from
//! the prescribed motion, not that motion.
//!
//! See `docs/theory/dynamics.md`.

use super::body_inertia::{BodyInertia, Pair};
use super::requirements::check_axis;
use crate::system::{Bodies, System};
use calyx_model::bearing::damping;
use calyx_model::connection::{ConnectionState, GyroscopicShaft};
use calyx_model::dof::Dof;
use calyx_model::frames::{pose, solid_pose};
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec2::dot;
use calyx_numerics::vec3::length;
use std::f64::consts::PI;

/// Matrices at a time, per width of the model: DOFs first, then modal coordinates of gears and of
/// elastic connections.
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
    bodies: Vec<BodyInertia>,
    /// Inertia forces and moments on every body by the prescribed motion, along ground axes.
    loads: Vec<Pair>,
    /// Coupling of every modal coordinate of gears.
    arms: Vec<ModalArm>,
    /// Elastic connections with mass.
    connections: Vec<ConnectionInertia>,
}

/// Elastic connection with mass at a time.
struct ConnectionInertia {
    /// Index in the scene.
    index: usize,
    state: ConnectionState,
    /// Index of its first component mode among all modal coordinates.
    first_mode: usize,
    /// Gyroscopic terms, if it is a rotating shaft.
    rotation: Option<GyroscopicShaft>,
    /// True if it rotates and is no shaft.
    lacks_coriolis_forces: bool,
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

/// Forces (N) and moments about the axis (N m) on the frame of every body, along ground axes, and
/// forces on modal coordinates.
pub struct Forces {
    frames: Vec<Pair>,
    /// Generalized forces on modal coordinates, per width of the model.
    pub modal: Vec<f64>,
}

/// Angular velocity relative to a body's lowest natural frequency from which the neglected terms
/// cause a warning; beyond the second value they are an error.
const FAST: f64 = 0.1;
const TOO_FAST: f64 = 0.5;
/// Components of a frame outside the plane in [`calyx_model::dof::DOF_NAMES`].
const OUT_OF_PLANE: [usize; 3] = [2, 3, 4];

/// Rotates by a right angle.
fn across([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

fn add(sum: &mut Pair, more: Pair) {
    for (sum, more) in sum.iter_mut().flatten().zip(more.into_iter().flatten()) {
        *sum += more;
    }
}

fn pair_of([fx, fy, fz, mx, my, mz]: [f64; 6]) -> Pair {
    [[fx, fy, fz], [mx, my, mz]]
}

impl Matrices {
    /// Assembles the matrices at a time.
    ///
    /// # Errors
    /// E0710: a frame is NaN. E0610: the axis of a body does not keep its direction. E0869: a
    /// connection has parted.
    pub fn at(system: &System<'_>, time: f64) -> Result<Matrices, EngineError> {
        let m = system.dofs.len();
        let mut bodies = Vec::with_capacity(system.scene.bodies.len());
        for (index, inertia) in system.inertias().iter().enumerate() {
            solid_pose(system.scene, index, time)?;
            let body = BodyInertia::at(system, index, inertia, time);
            if !system.left_out[index] {
                check_axis(system.scene, index, time)?;
            }
            bodies.push(body);
        }
        let mut matrices = Matrices {
            mass: system.mass_matrix(time).transpose().as_slice().to_vec(),
            coupling: Vec::new(),
            damping: {
                let Mechanism { bodies, bearings, .. } = system.scene;
                damping(bodies, bearings, &system.bearings, &system.dofs, |body| system.width(body), time)?
            },
            load: vec![0.0; m],
            modal_load: vec![0.0; system.mode_count()],
            loads: bodies.iter().map(BodyInertia::load).collect(),
            bodies,
            arms: modal_arms(system, time)?,
            connections: Vec::new(),
        };
        for (row, dof) in matrices.mass.chunks_exact_mut(m.max(1)).zip(&system.dofs) {
            row.iter_mut().for_each(|entry| *entry /= system.width(dof.body));
        }
        for (index, body) in matrices.bodies.iter().enumerate() {
            let Some((own, first)) = system.modes.of_body(index) else { continue };
            let [[ax, ay, _], spin, alpha] =
                [body.acceleration, body.angular_velocity, body.angular_acceleration];
            let loads = matrices.modal_load.iter_mut().zip(&matrices.arms);
            for (load, arm) in loads.skip(first).take(own.count()) {
                *load = spin[2] * spin[2] * arm.outwards - dot(arm.along, [ax, ay]) - arm.about * alpha[2];
            }
        }
        matrices.add_connections(system, time)?;
        matrices.coupling = mass_coupling(system, &matrices.arms, time)?;
        matrices.load = matrices.on_dofs(system, &matrices.loads);
        Ok(matrices)
    }

    /// Adds the inertia loads of elastic connections.
    fn add_connections(&mut self, system: &System<'_>, time: f64) -> Result<(), EngineError> {
        let mut first_mode = system.modes.count();
        for &index in &system.connections {
            let connection = &system.elastic_connections[index];
            let own = first_mode..first_mode + connection.modes.count();
            first_mode = own.end;
            if connection.mass.is_empty() {
                continue;
            }
            let state = ConnectionState::at(&system.scene.bodies, connection, time)?;
            // Accelerations of the prescribed motion, as values of all DOFs.
            let dofs =
                (0..6).flat_map(|component| connection.bodies().map(move |id| Dof { body: id.0, component }));
            let dofs: Vec<Dof> = dofs.collect();
            let of = |dof: &Dof| {
                let body = &self.bodies[dof.body];
                body.along([body.acceleration, body.angular_acceleration], dof.component)
            };
            let accelerations = state.motions(&dofs, &dofs.iter().map(of).collect::<Vec<_>>());
            let forces = connection.inertia_forces(&accelerations);
            for body in connection.bodies() {
                add(&mut self.loads[body.0], pair_of(state.wrench_on(body, &forces)));
            }
            for (load, force) in
                self.modal_load[own.clone()].iter_mut().zip(connection.modal_inertia_forces(&accelerations))
            {
                *load += force;
            }
            let rotation = GyroscopicShaft::at(&system.scene.bodies, connection, &state, time);
            let rotates = connection.bodies().any(|id| self.bodies[id.0].angular_velocity != [0.0; 3]);
            self.connections.push(ConnectionInertia {
                index,
                state,
                first_mode: own.start,
                rotation,
                lacks_coriolis_forces: rotates && connection.shaft.is_none(),
            });
        }
        Ok(())
    }

    /// Returns the inertia forces due to displacements and rates of all coordinates: all terms
    /// except those of accelerations and of the prescribed motion. Linear in both.
    pub fn following(&self, system: &System<'_>, displacement: &[f64], rate: &[f64]) -> Forces {
        let m = system.dofs.len();
        let mut forces = Forces {
            frames: vec![[[0.0; 3]; 2]; self.bodies.len()],
            modal: vec![0.0; self.modal_load.len()],
        };
        for (index, body) in self.bodies.iter().enumerate() {
            if body.is_uniform() {
                continue;
            }
            let moved = |values: &[f64]| body.to_ground(system.moved(index, &values[..m]));
            let (deviation, moving) = (moved(displacement), moved(rate));
            let mut frame = body.following(deviation, moving);
            if let Some((own, from)) = system.modes.of_body(index) {
                let ([_, [_, _, turn]], [_, [_, _, turning]]) = (deviation, moving);
                let (spin, spinning_up) = (body.angular_velocity[2], body.angular_acceleration[2]);
                let acceleration = [body.acceleration[0], body.acceleration[1]];
                let (count, width) = (own.count(), system.width(index));
                let (q, rates) = (&displacement[m + from..][..count], &rate[m + from..][..count]);
                for (k, arm) in self.arms[from..from + count].iter().enumerate() {
                    let sideways = across(arm.along);
                    let (by, out) = (2.0 * spin * rates[k] + spinning_up * q[k], spin * spin * q[k]);
                    frame[0][0] += width * (out * arm.along[0] - by * sideways[0]);
                    frame[0][1] += width * (out * arm.along[1] - by * sideways[1]);
                    let pulled = dot(sideways, acceleration);
                    let about = 2.0 * spin * rates[k] + 2.0 * spinning_up * q[k];
                    frame[1][2] -= width * (about * arm.outwards + pulled * q[k]);
                    forces.modal[from + k] = 2.0 * spin * arm.outwards * turning - pulled * turn;
                }
                let modal = &mut forces.modal[from..from + count];
                for l in 0..count {
                    let by = 2.0 * spin * rates[l] + spinning_up * q[l];
                    modal.iter_mut().zip(own.gyroscopic.col_as_slice(l)).for_each(|(sum, g)| *sum -= g * by);
                }
            }
            add(&mut forces.frames[index], frame);
        }
        for ConnectionInertia { index, state, first_mode, rotation, .. } in &self.connections {
            let Some(rotation) = rotation else { continue };
            let connection = &system.elastic_connections[*index];
            let modes = *first_mode..first_mode + connection.modes.count();
            let [moved, rates] = [displacement, rate].map(|values| state.motions(&system.dofs, &values[..m]));
            let modal = [displacement, rate].map(|values| &values[m + modes.start..m + modes.end]);
            let (on_attachments, on_modes) = rotation.forces([&moved, &rates], modal);
            for body in connection.bodies() {
                add(&mut forces.frames[body.0], pair_of(state.wrench_on(body, &on_attachments)));
            }
            forces.modal[modes].iter_mut().zip(on_modes).for_each(|(sum, force)| *sum += force);
        }
        forces
    }

    /// Returns a warning for each gear that passes half of a tooth in a time step of this length,
    /// s.
    fn skipped_teeth(&self, system: &System<'_>, step: f64) -> Vec<String> {
        let mut gears: Vec<usize> =
            system.scene.pairs.iter().flat_map(|pair| pair.bodies).map(|body| body.0).collect();
        gears.sort_unstable();
        gears.dedup();
        let skips = |&gear: &usize| {
            // A single tooth has no pitch.
            let teeth = system.teeth(gear).filter(|&teeth| teeth > 1)?;
            let turned = length(self.bodies[gear].angular_velocity) * step;
            let name = &system.scene.bodies[gear].name;
            (turned > PI / f64::from(teeth)).then(|| {
                format!("body \"{name}\" rotates by more than half of a tooth in a time step: take steps of a twentieth of the shortest period of interest")
            })
        };
        gears.iter().filter_map(skips).collect()
    }

    /// Returns warnings about neglected terms and steps that are too long, in sentences.
    ///
    /// # Errors
    /// E0767: a body rotates so fast that its modes differ from those at rest.
    pub fn warnings(&self, system: &System<'_>, step: f64) -> Result<Vec<String>, EngineError> {
        let mut warnings = self.skipped_teeth(system, step);
        for (index, body) in self.bodies.iter().enumerate() {
            let Some((own, _)) = system.modes.of_body(index) else { continue };
            let part = own.frequencies.first().map_or(0.0, |lowest| body.angular_velocity[2].abs() / lowest);
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
        let rotating = self.connections.iter().filter(|connection| connection.lacks_coriolis_forces);
        warnings.extend(rotating.map(|connection| {
            let name = &system.elastic_connections[connection.index].name;
            format!("the elastic body \"{name}\" rotates: the Coriolis and centrifugal forces of its vibration are left out")
        }));
        Ok(warnings)
    }

    /// Returns the inertia force and moment of every body on its frame along ground axes, in the
    /// order of [`calyx_model::dof::DOF_NAMES`], N and N m: those of the prescribed motion, of
    /// displacements and rates, and of the accelerations of DOFs and modal coordinates.
    pub fn inertia(&self, system: &System<'_>, following: &Forces, acceleration: &[f64]) -> Vec<[f64; 6]> {
        let m = system.dofs.len();
        let of = |(index, body): (usize, &BodyInertia)| {
            let mut wrench = body.resisting(body.to_ground(system.moved(index, &acceleration[..m])));
            add(&mut wrench, self.loads[index]);
            add(&mut wrench, following.frames[index]);
            if let Some((own, from)) = system.modes.of_body(index) {
                let width = system.width(index);
                for (arm, q) in self.arms[from..from + own.count()].iter().zip(&acceleration[m + from..]) {
                    wrench[0][0] -= width * arm.along[0] * q;
                    wrench[0][1] -= width * arm.along[1] * q;
                    wrench[1][2] -= width * arm.about * q;
                }
            }
            wrench
        };
        let mut wrenches: Vec<Pair> = self.bodies.iter().enumerate().map(of).collect();
        for ConnectionInertia { index, state, first_mode, .. } in &self.connections {
            let connection = &system.elastic_connections[*index];
            let modal = &acceleration[m + first_mode..][..connection.modes.count()];
            let accelerations = state.motions(&system.dofs, &acceleration[..m]);
            let mut forces = connection.inertia_forces(&accelerations);
            connection.add_inertia_of_modes(&mut forces, modal);
            for body in connection.bodies() {
                add(&mut wrenches[body.0], pair_of(state.wrench_on(body, &forces)));
            }
        }
        let plane = matches!(system.bodies, Bodies::Plane(_));
        let flat = |[force, moment]: Pair| {
            let [[fx, fy, fz], [mx, my, mz]] = [force, moment];
            let mut wrench = [fx, fy, fz, mx, my, mz];
            OUT_OF_PLANE.into_iter().filter(|_| plane).for_each(|component| wrench[component] = 0.0);
            wrench
        };
        wrenches.into_iter().map(flat).collect()
    }

    /// Returns the components on the DOFs of forces and moments on all frames, per width of the
    /// model.
    fn on_dofs(&self, system: &System<'_>, frames: &[Pair]) -> Vec<f64> {
        let of =
            |dof: &Dof| self.bodies[dof.body].along(frames[dof.body], dof.component) / system.width(dof.body);
        system.dofs.iter().map(of).collect()
    }

    /// Returns forces on the DOFs, per width of the model, then on the modal coordinates.
    pub fn on_coordinates(&self, system: &System<'_>, forces: &Forces) -> Vec<f64> {
        let mut all = self.on_dofs(system, &forces.frames);
        all.extend(&forces.modal);
        all
    }

    /// Adds to a force and moment on a body along ground axes those on its six components, N and
    /// N m.
    pub fn add_on_body(&self, wrench: &mut [f64; 6], body: usize, along: [f64; 6]) {
        let pair = self.bodies[body].to_ground(along);
        wrench.iter_mut().zip(pair.into_iter().flatten()).for_each(|(sum, more)| *sum += more);
    }
}

fn turned([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    let (sine, cosine) = by.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

/// Returns the coupling of every modal coordinate of gears with its frame at a time.
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

/// Returns the mass coupling between DOFs and modal coordinates of gears in a plane model at a
/// time, row-major, per width of the model.
///
/// # Errors
/// E0710: a frame is NaN.
pub fn coupling(system: &System<'_>, time: f64) -> Result<Vec<f64>, EngineError> {
    Ok(on_dofs_by_modes(system, &modal_arms(system, time)?))
}

/// Returns the mass coupling between DOFs and all modal coordinates, row-major, per width of the
/// model.
fn mass_coupling(system: &System<'_>, arms: &[ModalArm], time: f64) -> Result<Vec<f64>, EngineError> {
    let (of_gears, of_connections) = (on_dofs_by_modes(system, arms), system.connection_mode_coupling(time)?);
    let (gears, connections) = (arms.len(), system.mode_count() - arms.len());
    let row = |dof: usize| {
        let own = of_gears[dof * gears..].iter().take(gears);
        own.chain(of_connections[dof * connections..].iter().take(connections))
    };
    Ok((0..system.dofs.len()).flat_map(row).copied().collect())
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
