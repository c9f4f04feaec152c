//! Deformed meshes of elastic bodies at a solved position: position, elastic displacements and
//! stresses.
//!
//! Displacements are elastic, relative to the body's frame. The frame has the position at which the
//! contact grid was created, as for the pressures and stresses of [`super::Fields`]. A vibrating
//! body is shown with the quasi-static deformation under its forces. Deformation due to friction is
//! neglected, as in the contact problem.

use super::Equilibrium;
use calyx_model::fidelity::StructureOptions;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::interrupt::Interrupt;
use calyx_solve::system::Bodies;
use calyx_structure::rotated_tensor;
use calyx_structure::{BodyLoads, DeformedSector, MeshedBody, VisualizationMesh};
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
    /// Elastic displacement of each point relative to the body's frame, m.
    pub displacements: Vec<[f64; 3]>,
    /// Stresses xx, yy, zz, yz, zx, xy at each point, Pa.
    pub stresses: Vec<[f64; 6]>,
}

/// Factorized meshes of the bodies of a scene that have one.
pub(crate) struct MeshedBodies {
    bodies: Vec<Option<Arc<MeshedBody>>>,
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
                None => VisualizationMesh::Unavailable(if plan.bodies[index].left_out {
                    "takes no part"
                } else {
                    "is rigid"
                }),
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
        Ok(Self { bodies, without, interrupt: resources.interrupt.clone() })
    }
}

impl Equilibrium<'_> {
    /// Returns the deformed meshes of the bodies.
    ///
    /// # Errors
    /// A frame is NaN, memory is exhausted, or those of the interrupt.
    pub(crate) fn deformed(self, meshed: &MeshedBodies) -> Result<Vec<BodyField>, EngineError> {
        let mut fields = Vec::new();
        for (index, mesh) in meshed.bodies.iter().enumerate() {
            let Some(mesh) = mesh else { continue };
            let (body, id) = (&self.system.scene.bodies[index], BodyId(index));
            let (surfaces, segments, spline_teeth);
            let loads = match &self.system.bodies {
                Bodies::Plane(_) => {
                    (surfaces, spline_teeth) = (self.surface_loads(id), self.spline_clearance_forces(id));
                    BodyLoads::Plane { surfaces: &surfaces, spline_teeth: &spline_teeth }
                }
                Bodies::Solid(_) => {
                    segments = self.segment_loads(id);
                    BodyLoads::Solid(&segments)
                }
            };
            let frame = self.system.displaced_pose(index, self.time(), &self.step.start)?;
            let pose = frame.rotated_first(body.phase);
            let placed = |sector: DeformedSector| SectorField {
                tooth: sector.tooth,
                points: sector.points.into_iter().map(|point| pose.point(point)).collect(),
                cells: sector.cells,
                displacements: sector.displacements.into_iter().map(|by| pose.direction(by)).collect(),
                stresses: sector
                    .stresses
                    .into_iter()
                    .map(|own| rotated_tensor(&pose.rotation, own))
                    .collect(),
            };
            let sectors = mesh.deformed(loads, &meshed.interrupt)?.into_iter().map(placed).collect();
            fields.push(BodyField { body: body.name.clone(), number: index, sectors });
        }
        Ok(fields)
    }
}
