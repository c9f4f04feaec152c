//! The meshes of elastic bodies at a solved position: where they stand, how they are deformed and what stresses them.
//!
//! Displacements are elastic only, relative to the body's frame; the frame stands where contact was laid out, as pressures and stresses
//! of [`super::Fields`] do. A body that vibrates is shown as the forces on it would deform it at rest, and no body by its friction, which contact
//! takes no notice of either.

use super::Equilibrium;
use calyx_model::fidelity::StructureOptions;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::interrupt::Interrupt;
use calyx_solve::system::Bodies;
use calyx_structure::turned_tensor;
use calyx_structure::{BodyLoads, DeformedSector, Drawable, MeshedBody};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The mesh of an elastic body, in ground coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyField {
    /// Its name.
    pub body: String,
    /// In the order of the scene, from 0.
    pub number: usize,
    /// In the plane all around, in space around the loaded ones.
    pub sectors: Vec<SectorField>,
}

/// The mesh of a tooth and its sector of the rim, in ground coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct SectorField {
    /// Counted counter-clockwise from 0.
    pub tooth: u32,
    /// Without deformation, m; of a plane model with z = 0.
    pub points: Vec<[f64; 3]>,
    /// Corners of each cell among the points: of a plane model four, counter-clockwise; in space eight, the first four round a face, then their
    /// opposites.
    pub cells: Vec<Vec<usize>>,
    /// Elastic displacement of each point relative to the body's frame, m.
    pub displacements: Vec<[f64; 3]>,
    /// xx, yy, zz, yz, zx, xy at each point, Pa.
    pub stresses: Vec<[f64; 6]>,
}

/// The meshes of the bodies of a scene that have one, decomposed.
pub(crate) struct MeshedBodies {
    bodies: Vec<Option<Arc<MeshedBody>>>,
    /// Names of the others, with the reason.
    pub without: Vec<(String, &'static str)>,
    interrupt: Interrupt,
}

impl MeshedBodies {
    /// Of all bodies that the plan models; those that share a structure share a mesh.
    ///
    /// # Errors
    /// A mesh cannot be made, or the interrupt's.
    pub fn new(scene: &Mechanism, plan: &Plan, resources: &Resources) -> Result<Self, EngineError> {
        let mut shared: BTreeMap<usize, Drawable> = BTreeMap::new();
        let (mut bodies, mut without) = (Vec::new(), Vec::new());
        for (index, number) in plan.structures(scene).into_iter().enumerate() {
            let body = &scene.bodies[index];
            // Fillets have no part in it.
            let options = StructureOptions { stresses: false, ..plan.bodies[index].options };
            let about = |error: EngineError| error.about(Subject::Body(index));
            let mesh = match number {
                None => Drawable::Not(if plan.bodies[index].left_out { "takes no part" } else { "is rigid" }),
                Some(number) => {
                    if let std::collections::btree_map::Entry::Vacant(place) = shared.entry(number) {
                        let meshed = || body.prototype.meshed(&options, plan.in_space, &resources.interrupt);
                        place.insert(resources.install(meshed).map_err(about)?);
                    }
                    match &shared[&number] {
                        Drawable::Not(reason) => Drawable::Not(reason),
                        Drawable::Mesh(mesh) => {
                            let own = body.prototype.shape_meshed(mesh.clone(), &options, plan.in_space);
                            Drawable::Mesh(own.map_err(about)?)
                        }
                    }
                }
            };
            match mesh {
                Drawable::Mesh(mesh) => bodies.push(Some(mesh)),
                Drawable::Not(reason) => {
                    bodies.push(None);
                    without.push((body.name.clone(), reason));
                }
            }
        }
        Ok(Self { bodies, without, interrupt: resources.interrupt.clone() })
    }
}

impl Equilibrium<'_> {
    /// The bodies that have meshes, deformed.
    ///
    /// # Errors
    /// A frame is not a number, memory runs out, or the interrupt's.
    pub(crate) fn deformed(self, meshed: &MeshedBodies) -> Result<Vec<BodyField>, EngineError> {
        let mut fields = Vec::new();
        for (index, mesh) in meshed.bodies.iter().enumerate() {
            let Some(mesh) = mesh else { continue };
            let (body, id) = (&self.system.scene.bodies[index], BodyId(index));
            let (surfaces, spots, lugs);
            let loads = match &self.system.bodies {
                Bodies::Plane(_) => {
                    (surfaces, lugs) = (self.surface_loads(id), self.loose_lug_forces(id));
                    BodyLoads::Plane { surfaces: &surfaces, lugs: &lugs }
                }
                Bodies::Solid(_) => {
                    spots = self.spot_loads(id);
                    BodyLoads::Solid(&spots)
                }
            };
            let frame = self.system.pose_moved(index, self.time(), &self.step.start)?;
            let pose = frame.turned_first(body.phase);
            let placed = |sector: DeformedSector| SectorField {
                tooth: sector.tooth,
                points: sector.points.into_iter().map(|point| pose.point(point)).collect(),
                cells: sector.cells,
                displacements: sector.displacements.into_iter().map(|by| pose.direction(by)).collect(),
                stresses: sector.stresses.into_iter().map(|own| turned_tensor(&pose.rotation, own)).collect(),
            };
            let sectors = mesh.deformed(loads, &meshed.interrupt)?.into_iter().map(placed).collect();
            fields.push(BodyField { body: body.name.clone(), number: index, sectors });
        }
        Ok(fields)
    }
}
