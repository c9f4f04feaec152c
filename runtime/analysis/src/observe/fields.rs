//! What tables and pictures show of a solved position: pressure cell by cell, load along lines of contact, stress along fillets.

use super::deformed::{BodyField, MeshedBodies};
use super::stress::{RootStress, around_contact};
use super::{Contact, Equilibrium, Slice};
use calyx_model::ids::BodyId;
use calyx_model::observed::Place;
use calyx_numerics::error::EngineError;
use calyx_solve::step::PatchGrid;

/// The fields of a solved position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fields {
    /// Patches in which surfaces touch or may, in the order of the solution.
    pub contacts: Vec<ContactField>,
    /// Fillets of loaded teeth and their neighbours, body by body, where stress is recovered.
    pub fillets: Vec<FilletField>,
    /// Meshes of elastic bodies, where somebody wants them ([`crate::options::AnalysisOptions::bodies`]).
    pub bodies: Vec<BodyField>,
    /// Bodies that are to be seen and have no mesh, with the reason, in words that follow the name.
    pub without_mesh: Vec<(String, &'static str)>,
}

/// A patch.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactField {
    /// Names of the two bodies.
    pub bodies: [String; 2],
    /// One of each body.
    pub teeth: [u32; 2],
    /// Of the sides of teeth that are behind those which drive.
    pub back: bool,
    /// All of them, those without load too.
    pub cells: Vec<PressedCell>,
    /// Pieces along the line of contact.
    pub slices: Vec<Slice>,
}

/// A cell of a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct PressedCell {
    /// In ground coordinates, in order round the cell, m. A plane model's cell reaches over its whole face.
    pub corners: [[f64; 3]; 4],
    /// Of its middle on either body.
    pub places: [Place; 2],
    /// Pa
    pub pressure: f64,
}

/// Stresses on one fillet of a tooth.
#[derive(Clone, Debug, PartialEq)]
pub struct FilletField {
    /// Name of the body.
    pub body: String,
    /// Counted counter-clockwise from 0.
    pub tooth: u32,
    /// The flank that it lies beside, as [`calyx_structure::Chart::surface`] counts them.
    pub flank: u32,
    /// Along the profile, section by section along the face; a plane model has one section.
    pub sections: Vec<Vec<FilletStress>>,
}

/// A stress on a fillet.
#[derive(Clone, Debug, PartialEq)]
pub struct FilletStress {
    /// In ground coordinates, m.
    pub point: [f64; 3],
    /// On the body.
    pub place: Place,
    /// Distance along the profile from the end of the flank towards the root, m.
    pub depth: f64,
    /// Along the profile, along the face, and in shear, Pa; of a plane model only the first is known, and the others are 0.
    pub components: [f64; 3],
    /// Largest and smallest principal stress, Pa.
    pub principal: [f64; 2],
}

impl Equilibrium<'_> {
    /// Everything that tables show of the position, and pictures but for the meshes of bodies.
    pub fn fields(self) -> Fields {
        let bodies = 0..self.system.scene.bodies.len();
        Fields {
            contacts: self.all_contacts().map(|contact| contact.field()).collect(),
            fillets: bodies.flat_map(|body| self.fillets(BodyId(body))).collect(),
            ..Fields::default()
        }
    }

    /// The same with the meshes of bodies, if there are any.
    ///
    /// # Errors
    /// Those of [`Equilibrium::deformed`].
    pub(crate) fn fields_with(self, meshed: Option<&MeshedBodies>) -> Result<Fields, EngineError> {
        let fields = self.fields();
        let Some(meshed) = meshed else { return Ok(fields) };
        Ok(Fields { bodies: self.deformed(meshed)?, without_mesh: meshed.without.clone(), ..fields })
    }

    fn fillets(self, body: BodyId) -> Vec<FilletField> {
        let scene = self.system.scene;
        let (Some(mut stresses), Ok(frame)) =
            (around_contact(&self, body), self.system.pose_moved(body.0, self.time(), &self.step.start))
        else {
            return Vec::new();
        };
        let pose = frame.turned_first(scene.bodies[body.0].phase);
        // Sections of one fillet in order along the face, each along the profile: by coordinates on the fillet, which rounding does not
        // tell apart.
        let key = |stress: &RootStress| (stress.place.tooth, stress.surface);
        let chart = |stress: &RootStress| [stress.chart[1], stress.chart[0]];
        stresses.sort_by(|a, b| {
            let (p, q) = (chart(a), chart(b));
            key(a).cmp(&key(b)).then(p[0].total_cmp(&q[0])).then(p[1].total_cmp(&q[1]))
        });
        let fillet = |fillet: &[RootStress]| {
            let sections = fillet.chunk_by(|a, b| a.chart[1] == b.chart[1]);
            let shown = |stress: &RootStress| FilletStress {
                point: pose.point(stress.position),
                place: stress.place.clone(),
                depth: stress.chart[0],
                components: stress.components,
                principal: stress.principal,
            };
            FilletField {
                body: scene.bodies[body.0].name.clone(),
                tooth: fillet[0].place.tooth,
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
        let cell = |(index, (corners, pressure)): (usize, ([[f64; 3]; 4], f64))| {
            let (first, second) = (self.place(0, index)?, self.place(1, index)?);
            Some(PressedCell { corners, places: [first, second], pressure })
        };
        ContactField {
            bodies: self.bodies().map(name),
            teeth: self.teeth(),
            back: self.at.system.scene.pairs[self.patch.pair].front.is_some(),
            cells: corners.into_iter().zip(pressures).enumerate().filter_map(cell).collect(),
            slices: self.slices(),
        }
    }

    /// The corners of every cell, in ground coordinates.
    fn corners(&self) -> Vec<[[f64; 3]; 4]> {
        match &self.patch.grid {
            PatchGrid::Plane { frame, cells, .. } => {
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
            PatchGrid::Solid(grid) => {
                let corners = |cell: &calyx_contact::solid::Cell| {
                    let ([left, right], [low, high]) = (cell.ends(0), cell.ends(1));
                    [[left, low], [right, low], [right, high], [left, high]].map(|at| grid.frame.at(at))
                };
                grid.cells.iter().map(corners).collect()
            }
        }
    }
}
