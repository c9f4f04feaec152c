//! Fields of a solved position for tables and VTU files: pressures by cell, line loads along
//! contact lines, stresses along fillets.

use super::deformed::{BodyField, ElasticBodyField, MeshedBodies};
use super::flank_cells::FlankCorners;
use super::parts::{Part, PartForce, PartMotion};
use super::rolling::RollingBearingField;
use super::stress::{RootStress, around_contact};
use super::{Contact, Equilibrium, Slice, Zone};
use calyx_contact::solid::Pose;
use calyx_model::ids::BodyId;
use calyx_model::lubrication::RollingContact;
use calyx_model::observed::Location;
use calyx_numerics::error::EngineError;
use calyx_solve::step::ContactGrid;
use std::sync::Arc;

/// Fields of a solved position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fields {
    /// Contact patches, loaded or not, in the order of the solution.
    pub contacts: Vec<ContactField>,
    /// Fillets of loaded teeth and their neighbours, body by body, if stresses are recovered.
    pub fillets: Vec<FilletField>,
    /// Meshes of elastic bodies, if requested ([`crate::options::AnalysisOptions::bodies`]).
    pub bodies: Vec<BodyField>,
    /// Elastic shafts, and meshes of elastic bodies of any shape, such as housings, if meshes are
    /// requested.
    pub elastic_bodies: Vec<ElasticBodyField>,
    /// Rolling bearings.
    pub rolling_bearings: Vec<RollingBearingField>,
    /// Parts with their outer surfaces, if requested
    /// ([`crate::options::AnalysisOptions::parts`]); equal at all positions.
    pub parts: Arc<Vec<Part>>,
    /// Pose of each part; `None` for a part that has no position, see [`Equilibrium::poses`].
    pub poses: Vec<Option<Pose>>,
    /// Displacements of bearings and rigid shafts that move, if parts are requested.
    pub motions: Vec<PartMotion>,
    /// Forces of bearings and meshes, if parts are requested.
    pub forces: Vec<PartForce>,
    /// Bodies without a mesh, with the reason, phrased to follow the name.
    pub without_mesh: Vec<(String, &'static str)>,
}

/// Contact patch.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactField {
    /// Names of the two bodies.
    pub bodies: [String; 2],
    /// Tooth of each body.
    pub teeth: [u32; 2],
    /// Surface of each body, as in [`calyx_structure::Chart::surface`].
    pub surfaces: [u32; 2],
    /// True for coast flanks.
    pub back: bool,
    /// All cells of the contact problem, including those without load. That of a time step leaves
    /// out cells that stay open.
    pub cells: Vec<PressedCell>,
    /// Slices along the contact line.
    pub slices: Vec<Slice>,
    /// Sliding and rolling of each slice, in the order of `slices`; `None` without load.
    pub states: Vec<Option<LocalState>>,
}

/// Sliding, rolling and lubrication at a point of a contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalState {
    /// Rolling contact.
    pub contact: RollingContact,
    /// Friction, temperature and film, if the mesh has lubrication.
    pub lubricated: Option<LubricatedState>,
}

/// Friction, temperature and film at a point of a lubricated contact line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LubricatedState {
    /// Coefficient of friction.
    pub friction: f64,
    /// Frictional power per length of the contact line, W/m.
    pub friction_power: f64,
    /// Flash temperature, K.
    pub flash_temperature: f64,
    /// Film thickness, m.
    pub film_thickness: f64,
}

/// Cell of a contact patch.
#[derive(Clone, Debug, PartialEq)]
pub struct PressedCell {
    /// Corners in ground coordinates, in order around the cell, m. A plane model's cell extends
    /// over the whole face.
    pub corners: [[f64; 3]; 4],
    /// Locations of its centre on both bodies.
    pub locations: [Location; 2],
    /// Pressure, Pa.
    pub pressure: f64,
    /// True if either surface is on its rounded edge here.
    pub edge: bool,
    /// Zone of the largest pressures to which the cell belongs: that of
    /// [`MaxContactPressure`](super::MaxContactPressure) or of
    /// [`MaxEdgePressure`](super::MaxEdgePressure). `None` next to a side face.
    pub zone: Option<Zone>,
    /// Corners on both flanks, in the order of `corners`; `None` without pressure and for meshes on
    /// parallel axes.
    pub flank_corners: Option<[FlankCorners; 2]>,
}

/// Stresses on one fillet of a tooth.
#[derive(Clone, Debug, PartialEq)]
pub struct FilletField {
    /// Name of the body.
    pub body: String,
    /// Number of the tooth, counter-clockwise from 0.
    pub tooth: u32,
    /// Flank next to the fillet, as in [`calyx_structure::Chart::surface`].
    pub flank: u32,
    /// Stresses along the profile, by section along the face; a plane model has one section.
    pub sections: Vec<Vec<FilletStress>>,
}

/// Stress at a point of a fillet.
#[derive(Clone, Debug, PartialEq)]
pub struct FilletStress {
    /// Point in ground coordinates, m.
    pub point: [f64; 3],
    /// Location on the body.
    pub location: Location,
    /// Distance along the profile from the end of the flank towards the root, m.
    pub depth: f64,
    /// Stress along the profile, along the face, and shear stress, Pa. A plane model provides only
    /// the first; the others are 0.
    pub components: [f64; 3],
    /// Largest and smallest principal stress, Pa.
    pub principal: [f64; 2],
}

/// Shapes of the bodies that fields include on request.
#[derive(Default)]
pub(crate) struct Displayed {
    /// Factorized meshes.
    pub meshed: Option<MeshedBodies>,
    /// Parts with their outer surfaces.
    pub parts: Option<Arc<Vec<Part>>>,
}

impl Equilibrium<'_> {
    /// Returns all fields except the meshes of bodies other than shafts. Rigid shafts and bearings
    /// have none.
    pub fn fields(self) -> Fields {
        let bodies = 0..self.system.scene.bodies.len();
        let is_rigid = self.system.rigid;
        Fields {
            contacts: self.all_contacts().map(|contact| contact.field()).collect(),
            fillets: bodies.flat_map(|body| self.fillets(BodyId(body))).collect(),
            elastic_bodies: if is_rigid { Vec::new() } else { self.deformed_shafts() },
            rolling_bearings: if is_rigid { Vec::new() } else { self.rolling_bearings() },
            ..Fields::default()
        }
    }

    /// Returns all fields, including the requested meshes of bodies and parts.
    ///
    /// # Errors
    /// Those of [`Equilibrium::deformed`] and [`Equilibrium::deformed_elastic_bodies`].
    pub(crate) fn fields_with(self, shown: &Displayed) -> Result<Fields, EngineError> {
        let mut fields = self.fields();
        if let Some(parts) = &shown.parts {
            fields.poses = self.poses(parts);
            fields.motions = self.part_motions(parts);
            fields.forces = self.part_forces();
            fields.parts = parts.clone();
        }
        let Some(meshed) = &shown.meshed else { return Ok(fields) };
        let mut elastic_bodies = self.deformed_elastic_bodies(meshed)?;
        elastic_bodies.extend(fields.elastic_bodies);
        Ok(Fields {
            bodies: self.deformed(meshed)?,
            elastic_bodies,
            without_mesh: meshed.without.clone(),
            ..fields
        })
    }

    fn fillets(self, body: BodyId) -> Vec<FilletField> {
        let scene = self.system.scene;
        let (Some(mut stresses), Ok(frame)) =
            (around_contact(&self, body), self.system.displaced_pose(body.0, self.time(), &self.step.start))
        else {
            return Vec::new();
        };
        let pose = frame.rotated_first(scene.bodies[body.0].phase);
        // Order the sections of one fillet along the face, each along the profile, by coordinates
        // on the fillet, with a tolerance for rounding.
        let key = |stress: &RootStress| (stress.location.tooth, stress.surface);
        let chart = |stress: &RootStress| [stress.chart[1], stress.chart[0]];
        stresses.sort_by(|a, b| {
            let (p, q) = (chart(a), chart(b));
            key(a).cmp(&key(b)).then(p[0].total_cmp(&q[0])).then(p[1].total_cmp(&q[1]))
        });
        let fillet = |fillet: &[RootStress]| {
            let sections = fillet.chunk_by(|a, b| a.chart[1] == b.chart[1]);
            let shown = |stress: &RootStress| FilletStress {
                point: pose.point(stress.position),
                location: stress.location.clone(),
                depth: stress.chart[0],
                components: stress.components,
                principal: stress.principal,
            };
            FilletField {
                body: scene.bodies[body.0].name.clone(),
                tooth: fillet[0].location.tooth,
                flank: fillet[0].surface,
                sections: sections.map(|section| section.iter().map(shown).collect()).collect(),
            }
        };
        stresses.chunk_by(|a, b| key(a) == key(b)).map(fillet).collect()
    }
}

impl Contact<'_> {
    fn field(&self) -> ContactField {
        let name = |body: BodyId| self.at.system.scene.bodies[body.0].name.clone();
        let corners = self.corners();
        let pressures = self.patch.pressures();
        let zones = self.patch.zones();
        let cell = |(index, (corners, pressure)): (usize, ([[f64; 3]; 4], f64))| {
            let (first, second) = (self.location(0, index)?, self.location(1, index)?);
            let on_edge = match &self.patch.grid {
                ContactGrid::Plane { .. } => false,
                ContactGrid::Solid(grid) => grid.cells[index].edge,
            };
            let on_flanks = if pressure > 0.0 { self.flank_corners(index, &corners) } else { None };
            let locations = [first, second];
            let zone = zones[index];
            Some(PressedCell { corners, locations, pressure, edge: on_edge, zone, flank_corners: on_flanks })
        };
        let (slices, contacts): (Vec<Slice>, Vec<_>) = self.rolling_states().into_iter().unzip();
        let state = |contact: RollingContact| {
            let lubricated = self.lubrication().map(|lubrication| LubricatedState {
                friction: lubrication.friction(&contact),
                friction_power: lubrication.friction_power(&contact),
                flash_temperature: lubrication.flash_temperature(&contact),
                film_thickness: lubrication.film_thickness(&contact),
            });
            LocalState { contact, lubricated }
        };
        ContactField {
            bodies: self.bodies().map(name),
            teeth: self.teeth(),
            surfaces: self.patch.surfaces,
            back: self.at.system.scene.pairs[self.patch.pair].front.is_some(),
            cells: corners.into_iter().zip(pressures).enumerate().filter_map(cell).collect(),
            slices,
            states: contacts.into_iter().map(|contact| contact.map(state)).collect(),
        }
    }

    /// Returns the corners of every cell, in ground coordinates.
    fn corners(&self) -> Vec<[[f64; 3]; 4]> {
        match &self.patch.grid {
            ContactGrid::Plane { frame, cells, .. } => {
                let half_face = 0.5 * self.width();
                let at = |x: f64, z: f64| {
                    let [px, py] = [0, 1].map(|axis| frame.point[axis] + x * frame.tangent[axis]);
                    [px, py, z]
                };
                let corners = |[low, high]: [f64; 2]| {
                    [at(low, -half_face), at(high, -half_face), at(high, half_face), at(low, half_face)]
                };
                cells.iter().map(|cell| corners(cell.x)).collect()
            }
            ContactGrid::Solid(grid) => {
                let corners = |cell: &calyx_contact::solid::Cell| {
                    let ([left, right], [low, high]) = (cell.ends(0), cell.ends(1));
                    [[left, low], [right, low], [right, high], [left, high]].map(|at| grid.frame.at(at))
                };
                grid.cells.iter().map(corners).collect()
            }
        }
    }
}
