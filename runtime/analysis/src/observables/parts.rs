//! Parts of a scene for display: outer surfaces of bodies, shafts, elastic bodies and bearings,
//! their poses at a solved position, and the forces between them.

use super::{Contact, Equilibrium};
use calyx_contact::solid::Pose;
use calyx_model::bearing::{Bearing, BearingState, Support, marker};
use calyx_model::connection::{Attachment, ConnectionState};
use calyx_model::elastic_body::SharedElasticBody;
use calyx_model::ids::{BearingId, BodyId, PairId};
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::spatial_pose;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, plus};
use calyx_structure::outer_surface::OuterSurface;
use rayon::prelude::*;

/// Radius of the mark of a bearing relative to the size of its body, if no shaft determines it.
const MARK: f64 = 0.2;

/// Kind of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartKind {
    /// Body with teeth or other surfaces.
    Gear,
    /// Shaft.
    Shaft,
    /// Elastic body of any shape.
    Body,
    /// Bearing.
    Bearing,
}

/// Element of the scene that a part displays, as an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartOf {
    /// Body.
    Body(usize),
    /// Elastic connection.
    Connection(usize),
    /// Bearing.
    Bearing(usize),
}

/// Part of a scene with a shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Name in the model.
    pub name: String,
    /// Kind.
    pub kind: PartKind,
    /// Element of the scene.
    pub of: PartOf,
    /// Outer surface in the coordinates of the part.
    pub surface: OuterSurface,
    /// Share of the motion of the outer ring in that of each point, from 0 on the inner ring to 1;
    /// empty if the part moves as a whole.
    pub with_outer: Vec<f64>,
}

/// Displacement of a part without a mesh by the motions of the bodies that it is on, in the axes of
/// the part: translation of its reference point (m) and rotation (rad). The rotation about the axis
/// of a part of revolution is left out, because it is not visible.
#[derive(Clone, Debug, PartialEq)]
pub struct PartMotion {
    /// Index of the part.
    pub part: usize,
    /// Reference point in the coordinates of the part, m.
    pub at: Vector,
    /// Motion of the part or of its inner ring, and that of its outer ring.
    pub motions: [[f64; 6]; 2],
}

/// Force between two parts, or between a part and ground.
#[derive(Clone, Debug, PartialEq)]
pub struct PartForce {
    /// Name of the bearing, or names of both gears.
    pub name: String,
    /// The bearing or the two bodies in mesh. The force acts on the first body.
    pub of: ForceOf,
    /// Point of application in ground coordinates, m.
    pub point: Vector,
    /// Force along ground axes, N.
    pub force: Vector,
    /// Moment about the point along ground axes, N m.
    pub moment: Vector,
}

/// Cause of a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceOf {
    /// Bearing, as an index; the force acts on the body of its first race.
    Bearing(usize),
    /// Mesh of two bodies, as indices.
    Mesh([usize; 2]),
}

/// Returns the parts of a scene that have a shape. Bodies that no analysis needs are included: a
/// part is displayed whether or not it is modelled.
///
/// # Errors
/// Those of the interrupt. A body that cannot be meshed has no shape.
pub fn parts(scene: &Mechanism, plan: &Plan, resources: &Resources) -> Result<Vec<Part>, EngineError> {
    let mut all = Vec::new();
    for (index, surface) in body_surfaces(scene, plan, resources)?.into_iter().enumerate() {
        let Some(surface) = surface else { continue };
        let name = scene.bodies[index].name.clone();
        all.push(Part {
            name,
            kind: PartKind::Gear,
            of: PartOf::Body(index),
            surface,
            with_outer: Vec::new(),
        });
    }
    for (index, connection) in scene.connections.iter().enumerate() {
        let of_shaft = connection.shaft.as_ref().map(|own| (PartKind::Shaft, own.shaft.outer_surface()));
        let of_body = || {
            let SharedElasticBody(body) = connection.body.as_ref()?;
            Some((PartKind::Body, body.outer_surface()?))
        };
        let Some((kind, surface)) = of_shaft.or_else(of_body) else { continue };
        let (name, of) = (connection.name.clone(), PartOf::Connection(index));
        all.push(Part { name, kind, of, surface, with_outer: Vec::new() });
    }
    resources.interrupt.check()?;
    for (index, bearing) in scene.bearings.iter().enumerate() {
        let (surface, with_outer) = match bearing.rolling() {
            Some(elements) => elements.outer_surface(),
            None => (marker(radius_at(scene, bearing)), Vec::new()),
        };
        let name = bearing.name.clone();
        all.push(Part { name, kind: PartKind::Bearing, of: PartOf::Bearing(index), surface, with_outer });
    }
    Ok(all)
}

/// Returns the outer surface of each body, by several threads; `None` without a shape. Bodies that
/// share a structure share a surface.
fn body_surfaces(
    scene: &Mechanism,
    plan: &Plan,
    resources: &Resources,
) -> Result<Vec<Option<OuterSurface>>, EngineError> {
    let structures = plan.structures(scene);
    let first_alike = |index: usize| {
        let number = structures[index]?;
        structures.iter().position(|other| *other == Some(number))
    };
    let own = |index: usize| {
        if first_alike(index).is_some_and(|first| first != index) || resources.interrupt.check().is_err() {
            return None;
        }
        let (prototype, options) = (&scene.bodies[index].prototype, &plan.bodies[index].options);
        prototype.outer_surface(options, plan.three_dimensional, &resources.interrupt).ok().flatten()
    };
    let found: Vec<Option<OuterSurface>> =
        resources.install(|| (0..scene.bodies.len()).into_par_iter().map(own).collect());
    resources.interrupt.check()?;
    let of_body = |index: usize| found[first_alike(index).unwrap_or(index)].clone();
    Ok((0..scene.bodies.len()).map(of_body).collect())
}

/// Returns the radius of the shaft under a bearing, or one in proportion to the size of its body,
/// m.
fn radius_at(scene: &Mechanism, bearing: &Bearing) -> f64 {
    let of_shaft = scene.connections.iter().find_map(|connection| {
        let own = connection.shaft.as_ref()?;
        let is_on = |attachment: &Attachment| attachment.to == Support::Body(bearing.body);
        let station = connection.attachments.iter().position(is_on)?;
        Some(0.5 * own.shaft.diameters_at(own.stations[station])[0])
    });
    of_shaft.unwrap_or_else(|| MARK * scene.bodies[bearing.body.0].prototype.enclosing_radius())
}

/// Returns the poses of parts by the prescribed motions of a scene at a time (s), without solving;
/// `None` as in [`Equilibrium::poses`].
pub fn prescribed_poses(scene: &Mechanism, parts: &[Part], time: f64) -> Vec<Option<Pose>> {
    let pose = |part: &Part| match part.of {
        PartOf::Body(index) => {
            let body = &scene.bodies[index];
            Ok(spatial_pose(body.motion.as_ref(), time)?.rotated_first(body.phase))
        }
        PartOf::Connection(index) => connection_pose(scene, index, time),
        PartOf::Bearing(index) => bearing_pose(scene, index, time),
    };
    parts.iter().map(|part| pose(part).ok()).collect()
}

fn connection_pose(scene: &Mechanism, index: usize, time: f64) -> Result<Pose, EngineError> {
    let connection = &scene.connections[index];
    let state = ConnectionState::at(&scene.bodies, connection, time)?;
    let of_shaft = || Some([0.0, 0.0, *connection.shaft.as_ref()?.stations.first()?]);
    let of_body = || connection.body.as_ref()?.0.positions().first().copied();
    let first = of_shaft().or_else(of_body).unwrap_or_default();
    Ok(from_axes(state.axes, state.origin(first)))
}

fn bearing_pose(scene: &Mechanism, index: usize, time: f64) -> Result<Pose, EngineError> {
    let state = BearingState::at(&scene.bodies, &scene.bearings[index], time)?;
    Ok(from_axes(state.axes, state.origin))
}

impl Equilibrium<'_> {
    /// Returns the poses of parts: their coordinates in those of ground. A part that is left out of
    /// the analysis has the pose of its prescribed motion. It may have none, if its frame is NaN or
    /// the races of a bearing have separated: this is no error, because results do not depend on
    /// it.
    pub fn poses(self, parts: &[Part]) -> Vec<Option<Pose>> {
        parts.iter().map(|part| self.pose(part.of).ok()).collect()
    }

    fn pose(self, of: PartOf) -> Result<Pose, EngineError> {
        let (system, scene) = (self.system, self.system.scene);
        match of {
            PartOf::Body(index) => {
                let frame = system.displaced_pose(index, self.time(), &self.step.start)?;
                Ok(frame.rotated_first(scene.bodies[index].phase))
            }
            PartOf::Connection(index) => connection_pose(scene, index, self.time()),
            PartOf::Bearing(index) => bearing_pose(scene, index, self.time()),
        }
    }

    /// Returns the displacements of bearings and rigid shafts from their prescribed positions.
    pub fn part_motions(self, parts: &[Part]) -> Vec<PartMotion> {
        let (system, time) = (self.system, self.time());
        let values = &self.step.motion;
        let motion = |(part, of): (usize, PartOf)| {
            let (at, mut motions) = match of {
                PartOf::Bearing(index) => {
                    let bearing = &system.scene.bearings[index];
                    let state = BearingState::at(&system.scene.bodies, bearing, time).ok()?;
                    let [first, second] = state.motions(&system.dofs, values);
                    let is_inverted = bearing.rolling().is_some_and(|elements| elements.is_inverted());
                    ([0.0; 3], if is_inverted { [second, first] } else { [first, second] })
                }
                PartOf::Connection(index) => {
                    let connection = &system.elastic_connections[index];
                    let shaft = connection.shaft.as_ref().filter(|shaft| shaft.rigid)?;
                    let state = ConnectionState::at(&system.scene.bodies, connection, time).ok()?;
                    let first = *state.motions(&system.dofs, values).first()?;
                    ([0.0, 0.0, *shaft.stations.first()?], [first; 2])
                }
                PartOf::Body(_) => return None,
            };
            motions.iter_mut().for_each(|motion| motion[5] = 0.0);
            (motions != [[0.0; 6]; 2]).then_some(PartMotion { part, at, motions })
        };
        parts.iter().map(|part| part.of).enumerate().filter_map(motion).collect()
    }

    /// Returns the forces of all bearings and meshes that carry load.
    pub fn part_forces(self) -> Vec<PartForce> {
        let scene = self.system.scene;
        let bearing = |index: usize| {
            let load = self.bearing(BearingId(index))?;
            let [x, y, z, mx, my, mz] = load.push;
            let [force, moment] = [[x, y, z], [mx, my, mz]].map(|own| load.to_ground(own));
            let (name, point) = (scene.bearings[index].name.clone(), load.origin());
            Some(PartForce { name, of: ForceOf::Bearing(index), point, force, moment })
        };
        let mesh = |index: usize| {
            let pair = &scene.pairs[index];
            if pair.front.is_some() {
                return None;
            }
            let contacts: Vec<Contact<'_>> = self.mesh_contacts(PairId(index)).collect();
            let (mut force, mut point, mut total) = ([0.0; 3], [0.0; 3], 0.0);
            for contact in &contacts {
                let [x, y, z, ..] = contact.wrench(0);
                force = plus(force, [x, y, z]);
                for (at, part) in contact.centres() {
                    total += part;
                    point = plus(point, at.map(|axis| part * axis));
                }
            }
            let name = |BodyId(body): BodyId| scene.bodies[body].name.clone();
            let name = pair.bodies.map(name).join(" / ");
            let of = ForceOf::Mesh(pair.bodies.map(|body| body.0));
            (total > 0.0).then(|| PartForce {
                name,
                of,
                point: point.map(|axis| axis / total),
                force,
                moment: [0.0; 3],
            })
        };
        let bearings = (0..scene.bearings.len()).filter_map(bearing);
        let loaded = |force: &PartForce| force.force != [0.0; 3] || force.moment != [0.0; 3];
        bearings.chain((0..scene.pairs.len()).filter_map(mesh)).filter(loaded).collect()
    }
}

/// Returns the pose of coordinates with these axes and this origin.
fn from_axes(axes: [Vector; 3], origin: Vector) -> Pose {
    Pose { rotation: [0, 1, 2].map(|row: usize| axes.map(|axis| axis[row])), origin }
}
