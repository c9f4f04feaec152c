//! Motions of a three-dimensional model that strain no spring and that no tooth can resist.
//!
//! On parallel axes the contact forces of a mesh act in its plane of action, normal to the teeth
//! and at any point of the plane. So a mesh resists at most two motions, a displacement along this
//! normal and a rotation about the normal of the plane. A motion that strains no spring and does no
//! work in either is free. One of them is the screw motion of a helical gear along its own teeth,
//! in which the axial force and the torque do opposite work: the flank is a helicoid and moves in
//! itself, its rounded edges included. Lead modifications resist it by forces that exceed the load
//! by far.

use calyx_contact::problem::{ContactError, FreeMotion};
use calyx_contact::unloaded_equilibrium::UnloadedEquilibrium;
use calyx_model::dof::Dof;
use calyx_model::frames::{axes, solid_pose};
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::axle;
use calyx_model::pairs::SurfacePair;
use calyx_model::plan::Plan;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{cross, dot, minus, plus, scaled, unit};
use nalgebra::DMatrix;
use std::f64::consts::PI;

/// Length, m, at which rotations are compared with displacements.
const RADIUS: f64 = 0.1;
/// Work of contact forces on a free motion, relative to the largest, that counts as rounding.
const NO_WORK: f64 = 1e-8;

/// Teeth and stops, which may resist the motions that strain no spring.
#[derive(Clone, Copy)]
pub(super) struct Teeth<'a> {
    pub scene: &'a Mechanism,
    pub plan: &'a Plan,
    pub dofs: &'a [Dof],
    /// Derivatives of the gaps of stops by the DOFs, row-major.
    pub stops: &'a [f64],
    /// Time, s.
    pub time: f64,
}

impl Teeth<'_> {
    /// Returns a motion, a combination of those that strain no spring (`free`), that neither stops
    /// nor teeth can resist. Of several such motions it is the one that the load drives most, if it
    /// drives any. Meshes on general axes and surfaces that are not gear flanks may resist any
    /// motion.
    ///
    /// # Errors
    /// A frame is NaN.
    pub fn unresisted_motion(
        &self,
        free: &[Vec<f64>],
        load: &[f64],
    ) -> Result<Option<Vec<f64>>, EngineError> {
        let mut rows = self.stops.to_vec();
        for pair in self.pairs() {
            let Some(of_pair) = resisted(self.scene, pair, self.dofs, self.time)? else { return Ok(None) };
            rows.extend(of_pair.into_iter().flatten());
        }
        Ok(idle_motion(self.dofs, &rows, free, load))
    }

    /// Returns the error if the load drives a motion that strains no spring in a sense that neither
    /// stops nor teeth resist. The force of a mesh is between the ends of the face, so forces at
    /// both ends represent all distributions.
    ///
    /// # Errors
    /// A frame is NaN. Those of the interrupt.
    pub fn driven(
        &self,
        unloaded: &UnloadedEquilibrium,
        load: &[f64],
        interrupt: &Interrupt,
    ) -> Result<Option<ContactError>, EngineError> {
        let m = self.dofs.len();
        let mut arms = self.stops.to_vec();
        for pair in self.pairs() {
            let rows = resisted(self.scene, pair, self.dofs, self.time)?;
            let Some([force, couple]) = rows else { return Ok(None) };
            for end in self.face_ends(pair)? {
                arms.extend(force.iter().zip(&couple).map(|(force, couple)| force + end / RADIUS * couple));
            }
        }
        let closed = vec![0.0; arms.len() / m.max(1)];
        let without_motion = UnloadedEquilibrium { motion: vec![0.0; m], ..unloaded.clone() };
        match without_motion.rigid_limit(&closed, &arms, load, interrupt) {
            Err(ContactError::Interrupted(error)) => Err(error),
            Err(error @ ContactError::Infeasible(_)) => Ok(Some(error)),
            _ => Ok(None),
        }
    }

    /// Returns the modelled surface pairs.
    fn pairs(&self) -> impl Iterator<Item = &SurfacePair> {
        let modelled =
            |pair: &&SurfacePair| pair.bodies.iter().all(|body| !self.plan.bodies[body.0].left_out);
        self.scene.pairs.iter().filter(modelled)
    }

    /// Returns the axial positions of the ends of both faces together, from the origin of the first
    /// body, m.
    fn face_ends(&self, pair: &SurfacePair) -> Result<[f64; 2], EngineError> {
        let [first, second] = pair.bodies.map(|body| body.0);
        let pose = |body: usize| solid_pose(self.scene, body, self.time);
        let axis = axes(self.scene, first, self.time)[2];
        let between = dot(axis, minus(pose(second)?.origin, pose(first)?.origin));
        let half = |body: usize| 0.5 * self.scene.bodies[body].prototype.face_width();
        Ok([(-half(first)).min(between - half(second)), half(first).max(between + half(second))])
    }
}

/// Returns a combination of free motions on which no row does work, see
/// [`Teeth::unresisted_motion`].
fn idle_motion(dofs: &[Dof], rows: &[f64], free: &[Vec<f64>], load: &[f64]) -> Option<Vec<f64>> {
    let (m, count) = (dofs.len(), free.len());
    let size = |k: usize| if dofs[k].component < 3 { 1.0 } else { RADIUS };
    let scale: Vec<f64> = free
        .iter()
        .map(|motion| (0..m).map(|k| motion[k].abs() * size(k)).fold(0.0, f64::max).recip())
        .collect();
    // Rows without an entry complete the matrix, so that its decomposition has all directions.
    let work = DMatrix::from_fn((rows.len() / m).max(count), count, |row, motion| {
        let row = rows.get(row * m..(row + 1) * m).unwrap_or_default();
        scale[motion] * row.iter().zip(&free[motion]).map(|(arm, part)| arm * part).sum::<f64>()
    });
    let decomposition = work.svd(false, true);
    let directions = decomposition.v_t?;
    let largest = decomposition.singular_values.iter().copied().fold(0.0, f64::max);
    let idle: Vec<Vec<f64>> = (0..count)
        .filter(|&direction| decomposition.singular_values[direction] <= NO_WORK * largest)
        .map(|direction| {
            let part = |k: usize| {
                (0..count).map(|of| directions[(direction, of)] * scale[of] * free[of][k]).sum::<f64>()
            };
            (0..m).map(part).collect()
        })
        .collect();
    let first = idle.first()?;
    // The basis of several motions is arbitrary. The sum of all of them, each times the work of the
    // load on it, is not: the load does no work on any motion at a right angle to it.
    let works: Vec<f64> = idle.iter().map(|motion| work_of(load, motion)).collect();
    let driven: Vec<f64> =
        (0..m).map(|k| idle.iter().zip(&works).map(|(motion, work)| work * motion[k]).sum()).collect();
    Some(if is_driven(dofs, load, &driven) { driven } else { first.clone() })
}

/// Returns the work of the load on a motion.
fn work_of(load: &[f64], motion: &[f64]) -> f64 {
    motion.iter().zip(load).map(|(part, load)| part * load).sum()
}

/// Returns whether the load drives a motion. Parts of the motion that are rounding do work with
/// large loads, so work compares with that of all loads on the largest part.
fn is_driven(dofs: &[Dof], load: &[f64], motion: &[f64]) -> bool {
    let size = |k: usize| if dofs[k].component < 3 { 1.0 } else { RADIUS };
    let largest = (0..motion.len()).map(|k| motion[k].abs() * size(k)).fold(0.0, f64::max);
    let all: f64 = (0..motion.len()).map(|k| load[k].abs() / size(k)).sum();
    work_of(load, motion).abs() > NO_WORK * largest * all
}

/// Returns the error about a free motion: whether the load drives it or not.
pub(super) fn error(mut motion: Vec<f64>, dofs: &[Dof], load: &[f64]) -> ContactError {
    let (work, driven) = (work_of(load, &motion), is_driven(dofs, load, &motion));
    let dof = (0..motion.len()).max_by(|&one, &other| motion[one].abs().total_cmp(&motion[other].abs()));
    let dof = dof.unwrap_or_default();
    let sense = if driven { work.signum() } else { 1.0 };
    let size = sense / motion.get(dof).map_or(1.0, |part| part.abs());
    motion.iter_mut().for_each(|part| *part *= size);
    let direction = motion.get(dof).map_or(1.0, |part| part.signum());
    let motion = FreeMotion { dof, direction, motion };
    if driven { ContactError::Infeasible(motion) } else { ContactError::Unconstrained(motion) }
}

/// Returns the work on each DOF of a force normal to the teeth, per transverse component, and of a
/// couple about the normal of the plane of action (per [`RADIUS`]), on the second body of a mesh
/// and, oppositely, on the first; `None` if the mesh may resist other motions.
fn resisted(
    scene: &Mechanism,
    pair: &SurfacePair,
    dofs: &[Dof],
    time: f64,
) -> Result<Option<[Vec<f64>; 2]>, EngineError> {
    let Some(mesh) = pair.mesh.as_ref().filter(|mesh| mesh.first_contact.is_none()) else { return Ok(None) };
    let bodies = pair.bodies.map(|body| body.0);
    let [first, second] =
        [solid_pose(scene, bodies[0], time)?.origin, solid_pose(scene, bodies[1], time)?.origin];
    let [x, y, z] = axes(scene, bodies[0], time);
    let between = minus(second, first);
    let across = [dot(between, x), dot(between, y)];
    let [radius, mate] = mesh.base_radii;
    let cosine = (radius + mesh.sign * mate).abs() / across[0].hypot(across[1]);
    if !(0.0..=1.0).contains(&cosine) {
        return Ok(None);
    }
    let contact = across[1].atan2(across[0]) + if mesh.sign < 0.0 { PI } else { 0.0 };
    let angle = contact + mesh.drive_sense * cosine.asin();
    let normal = unit(plus(scaled(x, angle.cos()), scaled(y, angle.sin())));
    // The line of action is tangent to the base circle of the first body.
    let point = plus(first, scaled(cross(normal, z), mesh.drive_sense * radius));
    let couple = scaled(cross(z, normal), RADIUS);
    // A rotation of the first gear about its axis and its displacement along its helix, of lead 2
    // pi / twist, do no work together.
    let force = minus(normal, scaled(z, mesh.drive_sense * radius * mesh.twist));
    let work = |dof: &Dof, row: usize| -> Result<f64, EngineError> {
        let Some(side) = bodies.iter().position(|body| *body == dof.body) else { return Ok(0.0) };
        let axis = axes(scene, dof.body, time)[dof.component % 3];
        let is_rotation = dof.component >= 3;
        let moved = if is_rotation {
            let origin =
                solid_pose(scene, dof.body, time)?.point(axle(scene.bodies[dof.body].motion.as_ref()));
            cross(axis, minus(point, origin))
        } else {
            axis
        };
        let along = match row {
            0 => dot(force, moved),
            _ if is_rotation => dot(couple, axis),
            _ => 0.0,
        };
        Ok(if side == 0 { -along } else { along })
    };
    let row = |row: usize| dofs.iter().map(|dof| work(dof, row)).collect::<Result<Vec<f64>, _>>();
    Ok(Some([row(0)?, row(1)?]))
}
