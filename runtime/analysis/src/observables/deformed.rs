//! Deformed meshes of elastic bodies at a solved position: position, elastic displacements and
//! stresses.
//!
//! Displacements are elastic, relative to the body's frame. The frame has the position at which the
//! contact grid was created, as for the pressures and stresses of [`super::Fields`]. A vibrating
//! body is shown with the quasi-static deformation under its forces. Deformation due to friction is
//! neglected, as in the contact problem.

use super::Equilibrium;
use calyx_model::connection::{CondensedShaft, ConnectionState, ElasticConnection};
use calyx_model::elastic_body::{CellShape, DeformedElasticBody, Recovery};
use calyx_model::fidelity::{BodyModel, StructureOptions};
use calyx_model::ids::{BodyId, ConnectionId};
use calyx_model::mechanism::Mechanism;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::stress::{Stress, rotated};
use calyx_numerics::vec3::plus;
use calyx_solve::system::Bodies;
use calyx_structure::{BodyLoads, DeformedSector, DisplacedSector, MeshedBody, VisualizationMesh};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Mesh of an elastic body, in ground coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyField {
    /// Name of the body.
    pub body: String,
    /// Index of the body in the scene, from 0.
    pub number: usize,
    /// Sectors: all of them in a plane model, those around the loaded teeth in three dimensions.
    pub sectors: Vec<SectorField>,
    /// The other sectors that move, without stresses. Their points and cells are those of
    /// `sectors`, rotated about the axis of the body.
    pub displaced: Vec<DisplacedSector>,
}

/// Mesh of a tooth and its sector of the rim, in ground coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct SectorField {
    /// Number of the tooth, counter-clockwise from 0.
    pub tooth: u32,
    /// Undeformed points, m; z = 0 in a plane model.
    pub points: Vec<[f64; 3]>,
    /// Corners of each cell as indices of points. Plane cells have four, counter-clockwise.
    /// Three-dimensional cells have eight: the first four around a face, then the opposite four.
    pub cells: Vec<Vec<usize>>,
    /// Index of the finite element of each cell.
    pub elements: Vec<usize>,
    /// Elastic displacement of each point relative to the body's frame, m.
    pub displacements: Vec<[f64; 3]>,
    /// Stresses xx, yy, zz, yz, zx, xy at each point, Pa.
    pub stresses: Vec<Stress>,
    /// Estimated errors of the stresses as von Mises stresses, Pa.
    pub stress_errors: Vec<f64>,
}

/// Mesh of an elastic body of any shape, in ground coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct ElasticBodyField {
    /// Name of the body.
    pub body: String,
    /// Number of the body: elastic connections of the scene count after its bodies.
    pub number: usize,
    /// Undeformed points, m.
    pub points: Vec<[f64; 3]>,
    /// Elements with their nodes, as indices of points.
    pub cells: Vec<(CellShape, Vec<usize>)>,
    /// Displacement of each point from its position in the undeformed body that moves as
    /// prescribed, m.
    pub displacements: Vec<[f64; 3]>,
    /// Stresses xx, yy, zz, yz, zx, xy at each point, Pa; of a shell on the outer surface with the
    /// larger von Mises stress. NaN at points without solids and shells.
    pub stresses: Vec<Stress>,
    /// Estimated errors of the stresses as von Mises stresses, Pa; NaN where there is no estimate,
    /// as for nominal stresses of shafts.
    pub stress_errors: Vec<f64>,
}

/// Factorized meshes of the bodies of a scene that have one.
pub(crate) struct MeshedBodies {
    bodies: Vec<Option<Arc<MeshedBody>>>,
    /// Elastic bodies of any shape by the index of their connection.
    elastic: Vec<(usize, Recovery)>,
    /// Names of the bodies without a mesh, with the reason.
    pub without: Vec<(String, &'static str)>,
    interrupt: Interrupt,
}

impl MeshedBodies {
    /// Creates the meshes of all bodies of the plan; bodies that share a structure share a mesh.
    ///
    /// # Errors
    /// A body cannot be meshed, or those of the interrupt.
    pub fn new(scene: &Mechanism, plan: &Plan, resources: &Resources) -> Result<Self, EngineError> {
        let mut shared: BTreeMap<usize, VisualizationMesh> = BTreeMap::new();
        let (mut bodies, mut without) = (Vec::new(), Vec::new());
        for (index, number) in plan.structures(scene).into_iter().enumerate() {
            let body = &scene.bodies[index];
            // Stress recovery in fillets is not needed here.
            let options = StructureOptions { stresses: false, ..plan.bodies[index].options };
            let about = |error: EngineError| error.about(Subject::Body(index));
            let mesh = match number {
                None if plan.bodies[index].left_out => VisualizationMesh::Unavailable("takes no part"),
                // Sections of shafts and attachments of elastic bodies are no bodies of the user.
                None if scene.connections_of(BodyId(index)).next().is_some() => {
                    bodies.push(None);
                    continue;
                }
                None => VisualizationMesh::Unavailable("is rigid"),
                Some(number) => {
                    if let std::collections::btree_map::Entry::Vacant(place) = shared.entry(number) {
                        let meshed =
                            || body.prototype.meshed(&options, plan.three_dimensional, &resources.interrupt);
                        place.insert(resources.install(meshed).map_err(about)?);
                    }
                    match &shared[&number] {
                        VisualizationMesh::Unavailable(reason) => VisualizationMesh::Unavailable(reason),
                        VisualizationMesh::Mesh(mesh) => {
                            let own =
                                body.prototype.shape_meshed(mesh.clone(), &options, plan.three_dimensional);
                            VisualizationMesh::Mesh(own.map_err(about)?)
                        }
                    }
                }
            };
            match mesh {
                VisualizationMesh::Mesh(mesh) => bodies.push(Some(mesh)),
                VisualizationMesh::Unavailable(reason) => {
                    bodies.push(None);
                    without.push((body.name.clone(), reason));
                }
            }
        }
        let elastic = recoveries(scene, plan, resources, &mut without)?;
        Ok(Self { bodies, elastic, without, interrupt: resources.interrupt.clone() })
    }
}

/// Prepares the modelled elastic bodies of any shape; those without a mesh are added to `without`.
fn recoveries(
    scene: &Mechanism,
    plan: &Plan,
    resources: &Resources,
    without: &mut Vec<(String, &'static str)>,
) -> Result<Vec<(usize, Recovery)>, EngineError> {
    let mut found = Vec::new();
    for index in plan.modelled_connections() {
        let connection = &scene.connections[index];
        let Some(body) = &connection.body else {
            if connection.shaft.as_ref().is_some_and(|shaft| shaft.rigid) {
                without.push((connection.name.clone(), "is rigid"));
            }
            continue;
        };
        if plan.fidelity.body_model() == BodyModel::Rigid {
            without.push((connection.name.clone(), "is rigid"));
            continue;
        }
        let recovery = resources.install(|| body.0.recovery(&resources.interrupt));
        match recovery.map_err(|error| connection.named(error))? {
            Some(recovery) => found.push((index, recovery)),
            None => without.push((connection.name.clone(), "is given by condensed matrices")),
        }
    }
    Ok(found)
}

impl Equilibrium<'_> {
    /// Returns the deformed meshes of elastic bodies of any shape.
    ///
    /// # Errors
    /// A frame is NaN, or an element is degenerate.
    pub(crate) fn deformed_elastic_bodies(
        self,
        meshed: &MeshedBodies,
    ) -> Result<Vec<ElasticBodyField>, EngineError> {
        let scene = self.system.scene;
        let field = |(index, recovery): &(usize, Recovery)| {
            let connection = &self.system.elastic_connections[*index];
            let state = ConnectionState::at(&scene.bodies, connection, self.time())?;
            let motions = state.motions(&self.system.dofs, &self.step.motion);
            let on_raceways = self.raceway_forces(*index);
            let forces = connection.forces_on_body(&motions, &on_raceways);
            let deformed = recovery
                .deformed(&motions, &forces, &on_raceways)
                .map_err(|error| connection.named(error))?;
            let first = connection.body.as_ref().and_then(|body| body.0.positions().first().copied());
            Ok(placed(&connection.name, scene.bodies.len() + index, &state, first, deformed))
        };
        meshed.elastic.iter().map(field).collect()
    }

    /// Returns the deformed elastic shafts, as meshes with nominal stresses.
    pub(crate) fn deformed_shafts(self) -> Vec<ElasticBodyField> {
        let connections = self.system.elastic_connections.iter().enumerate();
        let field = |(index, connection): (usize, &ElasticConnection)| {
            let CondensedShaft { shaft, stations, rigid: false } = connection.shaft.as_ref()? else {
                return None;
            };
            // The plan leaves shafts out that no output depends on.
            if !self.system.connections.contains(&index) {
                return None;
            }
            let load = self.connection(ConnectionId(index))?;
            let deformed = shaft.deformed(stations, &load.motions, &load.forces_on_shaft());
            let first = stations.first().map(|&z| [0.0, 0.0, z]);
            let number = self.system.scene.bodies.len() + index;
            Some(placed(&connection.name, number, load.state(), first, deformed))
        };
        connections.filter_map(field).collect()
    }

    /// Returns the deformed meshes of the bodies.
    ///
    /// # Errors
    /// A frame is NaN, memory is exhausted, or those of the interrupt.
    pub(crate) fn deformed(self, meshed: &MeshedBodies) -> Result<Vec<BodyField>, EngineError> {
        let mut fields = Vec::new();
        for (index, mesh) in meshed.bodies.iter().enumerate() {
            let Some(mesh) = mesh else { continue };
            let (body, id) = (&self.system.scene.bodies[index], BodyId(index));
            let (surfaces, segments);
            let interface = self.interface_forces(id);
            let loads = match &self.system.bodies {
                Bodies::Plane(_) => {
                    surfaces = self.surface_loads(id);
                    BodyLoads::Plane { surfaces: &surfaces, interface: &interface }
                }
                Bodies::Solid(_) => {
                    segments = self.segment_loads(id);
                    BodyLoads::Solid { segments: &segments, interface: &interface }
                }
            };
            let frame = self.system.displaced_pose(index, self.time(), &self.step.start)?;
            let pose = frame.rotated_first(body.phase);
            let placed = |sector: DeformedSector| SectorField {
                tooth: sector.tooth,
                points: sector.points.into_iter().map(|point| pose.point(point)).collect(),
                cells: sector.cells,
                elements: sector.elements,
                displacements: sector.displacements.into_iter().map(|by| pose.direction(by)).collect(),
                stresses: sector.stresses.into_iter().map(|own| rotated(&pose.rotation, own)).collect(),
                stress_errors: sector.stress_errors,
            };
            let sectors = mesh.deformed(loads, &meshed.interrupt)?.into_iter().map(placed).collect();
            let mut displaced = mesh.displaced(loads, &meshed.interrupt)?;
            for by in displaced.iter_mut().flat_map(|sector| &mut sector.displacements) {
                *by = pose.direction(*by);
            }
            fields.push(BodyField { body: body.name.clone(), number: index, sectors, displaced });
        }
        Ok(fields)
    }
}

/// Returns a deformed body in ground coordinates, from the position of the first attachment of its
/// connection in its own coordinates, m.
fn placed(
    name: &str,
    number: usize,
    state: &ConnectionState,
    first: Option<[f64; 3]>,
    deformed: DeformedElasticBody,
) -> ElasticBodyField {
    let origin = state.origin(first.unwrap_or_default());
    let rotation = [0, 1, 2].map(|row: usize| state.axes.map(|axis| axis[row]));
    let point = |point| plus(origin, state.to_ground(point));
    ElasticBodyField {
        body: name.to_owned(),
        number,
        points: deformed.points.into_iter().map(point).collect(),
        cells: deformed.cells,
        displacements: deformed.displacements.into_iter().map(|by| state.to_ground(by)).collect(),
        stresses: deformed.stresses.into_iter().map(|own| rotated(&rotation, own)).collect(),
        stress_errors: deformed.stress_errors,
    }
}
