//! What the model says, before anything is built: bodies, the surfaces that may touch, and what is to be observed.

use crate::bearing::Bearing;
use crate::cache::Key;
use crate::error::EngineError;
use crate::inertia::Inertia;
use crate::interrupt::Interrupt;
use crate::load::{Blow, Load, Wrench};
use crate::lug_contact::LugContact;
use crate::motion::Motion;
use crate::observe::{ModesRequest, Needs, Observable};
use crate::structure::solid::SolidStructure;
use crate::structure::{BodyModes, Drawable, MeshedBody, Structure, StructureSize};
use std::any::Any;
use std::f64::consts::TAU;
use std::iter;
use std::sync::Arc;

/// The six freedoms of a frame, in the order of their indices: names of [`Component`].
pub const FREEDOMS: [&str; 6] = ["u_x", "u_y", "u_z", "theta_x", "theta_y", "theta_z"];

/// A component of a frame's motion along and about the ground axes, in the order of [`FREEDOMS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// Displacement along x.
    Ux,
    /// Displacement along y.
    Uy,
    /// Displacement along z, across a plane model.
    Uz,
    /// Turn about x.
    ThetaX,
    /// Turn about y.
    ThetaY,
    /// Turn about z, in the plane of a plane model.
    ThetaZ,
}

/// How a body is to be modelled; makes its [`Structure`] when the plan says so.
///
/// A type, not a view: whoever knows what a body is made of finds it again by [`std::any::Any`].
pub trait Prototype: Any + Send + Sync {
    /// Builds the elastic structure (the costly part). Equal prototypes with equal options give equal structures.
    ///
    /// # Errors
    /// The structure cannot be built, or the interrupt's: it is asked wherever the work comes in batches.
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError>;

    /// Everything that the structure depends on: prototypes of one key share a structure, within a scene and, with a cache,
    /// from analysis to analysis. Without a key every prototype has its own.
    fn key(&self, _options: &StructureOptions) -> Option<Key> {
        None
    }

    /// The structure whose [`Structure::stored`] gave these bytes, built by a prototype of the same key; `None` if it cannot be made of
    /// them.
    fn restore(&self, _options: &StructureOptions, _stored: &[u8]) -> Option<Arc<dyn Structure>> {
        None
    }

    /// The structure of this very body, made of one that [`Prototype::build`] gave it or another of the same key. It takes little
    /// time: what is shared has been condensed.
    ///
    /// # Errors
    /// The body's own shape cannot be had.
    fn shape(
        &self,
        shared: Arc<dyn Structure>,
        _options: &StructureOptions,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        Ok(shared)
    }

    /// The body's modes of vibration in the plane at natural frequencies up to `highest`, rad/s: all of them. Without any the body
    /// vibrates as a rigid one.
    ///
    /// # Errors
    /// E0758: some cannot be found. E0759: lugs hold the body. Else as [`Prototype::build`].
    fn modes(
        &self,
        _options: &StructureOptions,
        _highest: f64,
        _interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        Ok(None)
    }

    /// Why an elastic body that might have modes has none, if that is so: it vibrates as a rigid one, and the plan says so.
    fn without_modes(&self) -> Option<&'static str> {
        None
    }

    /// What the body weighs, in its frame; nothing unless somebody says so.
    fn inertia(&self) -> Inertia {
        Inertia::default()
    }

    /// Everything that the modes depend on, as [`Prototype::key`] of the structure; none of a body that has none.
    fn modes_key(&self, _options: &StructureOptions, _highest: f64) -> Option<Key> {
        None
    }

    /// The modes that were kept on disk as these bytes, found by a prototype of the same key; `None` if they cannot be made of them.
    fn restore_modes(&self, _options: &StructureOptions, _stored: &[u8]) -> Option<Arc<BodyModes>> {
        None
    }

    /// The modes of this very body, made of those that [`Prototype::modes`] gave it or another of the same key, as [`Prototype::shape`].
    ///
    /// # Errors
    /// The body's own shape cannot be had.
    fn shape_modes(
        &self,
        shared: Arc<BodyModes>,
        _options: &StructureOptions,
    ) -> Result<Arc<BodyModes>, EngineError> {
        Ok(shared)
    }

    /// Builds the elastic structure in space, of the mesh template that the options name. Equal prototypes with equal options give
    /// equal structures.
    ///
    /// # Errors
    /// E0690: the body has no model in space, which is so unless this is implemented. Else as [`Prototype::build`].
    fn build_solid(
        &self,
        _options: &StructureOptions,
        _interrupt: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        Err(EngineError::new(
            "E0690",
            "a body of this kind has no model in space",
            "choose the fidelity \"plane\", which has one of every body",
        ))
    }

    /// As [`Prototype::key`], of the structure in space. A kind of structure is the plane's or one in space, so the keys of both never
    /// meet.
    fn solid_key(&self, _options: &StructureOptions) -> Option<Key> {
        None
    }

    /// As [`Prototype::restore`], in space.
    fn restore_solid(&self, _options: &StructureOptions, _stored: &[u8]) -> Option<Arc<dyn SolidStructure>> {
        None
    }

    /// As [`Prototype::shape`], in space: usually [`Reshaped`](crate::structure::solid::Reshaped), the shared structure under the surfaces
    /// of this body.
    ///
    /// # Errors
    /// The body's own shape cannot be had.
    fn shape_solid(
        &self,
        shared: Arc<dyn SolidStructure>,
        _options: &StructureOptions,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        Ok(shared)
    }

    /// The finite elements of the structure that [`Prototype::build`], or in space [`Prototype::build_solid`], condenses, to show the body
    /// deformed. Equal prototypes with equal options give equal ones.
    ///
    /// # Errors
    /// As [`Prototype::build`].
    fn meshed(
        &self,
        _options: &StructureOptions,
        _in_space: bool,
        _interrupt: &Interrupt,
    ) -> Result<Drawable, EngineError> {
        Ok(Drawable::Not("is of a kind that pictures do not have"))
    }

    /// The mesh of this very body, made of one that [`Prototype::meshed`] gave it or another of the same key, as [`Prototype::shape`]
    /// and [`Prototype::shape_solid`].
    ///
    /// # Errors
    /// The body's own shape cannot be had.
    fn shape_meshed(
        &self,
        shared: Arc<MeshedBody>,
        _options: &StructureOptions,
        _in_space: bool,
    ) -> Result<Arc<MeshedBody>, EngineError> {
        Ok(shared)
    }

    /// How large the structure's equations are that [`Prototype::build`] or [`Prototype::build_solid`] would condense, from the mesh alone;
    /// `None` if there are none, or no mesh can be made.
    fn size(&self, _fidelity: Fidelity, _options: &StructureOptions) -> Option<StructureSize> {
        None
    }

    /// Radius of the circle about the body's origin that encloses it, m.
    fn enclosing_radius(&self) -> f64;

    /// Angle of contact along an involute from its root, rad, for a point at this radius (m); `None` if there is no
    /// involute there.
    fn roll_angle(&self, _radius: f64) -> Option<f64> {
        None
    }

    /// m.
    fn face_width(&self) -> f64;

    /// Angle by which tooth `tooth` stands off its nominal place, rad, counter-clockwise.
    fn pitch_error(&self, _tooth: u32) -> f64 {
        0.0
    }

    /// The lugs by which the body rests in what is around it by contact, if it does: those of its structure's
    /// [`BoreHold::LooseLugs`](crate::structure::BoreHold::LooseLugs).
    fn lug_contact(&self) -> Option<LugContact> {
        None
    }

    /// Whether a section in the plane does not show what it is, so that a scene with it lies in space unless the fidelity is of the plane.
    fn needs_space(&self) -> bool {
        false
    }

    /// Inputs that a model of this fidelity cannot see, and why.
    fn ignored(&self, _fidelity: Fidelity) -> Vec<Ignored> {
        Vec::new()
    }
}

/// An input that the chosen fidelity cannot see.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Ignored {
    /// Its name.
    pub input: String,
    /// Why it is not seen.
    pub reason: String,
}

/// How bodies are modelled: the ladder from cheap to exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Fidelity {
    /// Bodies that do not deform, where they touch as the load vanishes: tooth contact analysis. In the plane if the scene lies in one, else
    /// in space.
    Rigid,
    /// Teeth and what carries them in closed forms, with the near field that all levels have. In the plane if the scene lies in one, else in space.
    Analytic,
    /// Plane finite elements with the semi-analytic near field.
    Plane,
    /// Finite elements in space with the semi-analytic near field, on meshes of this kind.
    Solid(Template),
}

/// Meshes in space by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Template {
    /// For loads, deflections and stresses of usual gears.
    #[default]
    Medium,
    /// Finer in the fillets.
    FineRoot,
    /// Finer everywhere.
    Finest,
    /// For rims not much thicker than the teeth are high, or thinner.
    ThinRim,
}

impl Template {
    /// Its name, which is that of the fidelity.
    pub fn name(self) -> &'static str {
        match self {
            Template::Medium => "medium",
            Template::FineRoot => "fineroot",
            Template::Finest => "finest",
            Template::ThinRim => "thinrim",
        }
    }
}

impl Fidelity {
    /// From cheap to exact.
    pub const ALL: [Fidelity; 7] = [
        Fidelity::Rigid,
        Fidelity::Analytic,
        Fidelity::Plane,
        Fidelity::Solid(Template::Medium),
        Fidelity::Solid(Template::ThinRim),
        Fidelity::Solid(Template::FineRoot),
        Fidelity::Solid(Template::Finest),
    ];

    /// The one that sees more.
    pub fn above(self) -> Option<Fidelity> {
        match self {
            Fidelity::Rigid => Some(Fidelity::Analytic),
            Fidelity::Analytic => Some(Fidelity::Plane),
            Fidelity::Plane => Some(Fidelity::Solid(Template::Medium)),
            Fidelity::Solid(Template::Medium | Template::ThinRim) => {
                Some(Fidelity::Solid(Template::FineRoot))
            }
            Fidelity::Solid(Template::FineRoot) => Some(Fidelity::Solid(Template::Finest)),
            Fidelity::Solid(Template::Finest) => None,
        }
    }

    /// All that see more, from cheap to exact.
    pub fn all_above(self) -> impl Iterator<Item = Fidelity> {
        iter::successors(self.above(), |fidelity| fidelity.above())
    }

    /// A fidelity by its name.
    pub fn named(name: &str) -> Option<Fidelity> {
        Fidelity::ALL.into_iter().find(|fidelity| fidelity.name() == name)
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Fidelity::Rigid => "rigid",
            Fidelity::Analytic => "analytic",
            Fidelity::Plane => "plane",
            Fidelity::Solid(template) => template.name(),
        }
    }

    /// What bodies are made of.
    pub fn body_model(self) -> BodyModel {
        match self {
            Fidelity::Rigid => BodyModel::Rigid,
            Fidelity::Analytic => BodyModel::Analytic,
            Fidelity::Plane | Fidelity::Solid(_) => BodyModel::Elements,
        }
    }

    /// The most that an observable may need.
    pub fn gives(self) -> Needs {
        match self {
            Fidelity::Rigid => Needs::Motions,
            Fidelity::Analytic => Needs::RootStress,
            Fidelity::Plane | Fidelity::Solid(_) => Needs::Stresses,
        }
    }
}

/// What a structure is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum BodyModel {
    /// Nothing that deforms.
    Rigid,
    /// Closed forms.
    Analytic,
    /// Finite elements.
    #[default]
    Elements,
}

/// Knobs of a structure's discretisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StructureOptions {
    /// Multiplies the number of elements along every direction of the mesh; 1 is the default mesh.
    pub refinement: f64,
    /// Order of displacement interpolation in the section, 1 to 3.
    pub order: usize,
    /// What it is made of; without elements all that is said of meshes is idle.
    pub model: BodyModel,
    /// The mesh of a body in space; a plane one has no use for it and for the next two.
    pub template: Template,
    /// Elements along the face, 1 to 64; `None` takes the template's.
    pub face_elements: Option<usize>,
    /// Order of displacement interpolation along the face, 1 to 8; `None` takes the template's.
    pub axial_order: Option<usize>,
    /// Multiplies the matching depth of near and far field; 1 is the default.
    pub matching_depth: f64,
    /// Recover stresses (costs one map per structure).
    pub stresses: bool,
    /// Surfaces run up to their nominal ends, without the rounding of edges: contact is confined to them.
    pub sharp_edges: bool,
}

impl Default for StructureOptions {
    fn default() -> Self {
        StructureOptions {
            refinement: 1.0,
            order: 3,
            model: BodyModel::default(),
            template: Template::default(),
            face_elements: None,
            axial_order: None,
            matching_depth: 1.0,
            stresses: true,
            sharp_edges: false,
        }
    }
}

impl StructureOptions {
    /// Whether a mesh can be made by them.
    ///
    /// # Errors
    /// E0675: the order is not 1 to 3, or the refinement is not positive. E0691: nor are elements along the face 1 to 64, or their
    /// order 1 to 8.
    pub fn check(&self) -> Result<(), EngineError> {
        if !((1..=3).contains(&self.order) && self.refinement.is_finite() && self.refinement > 0.0) {
            return Err(EngineError::new(
                "E0675",
                "a mesh needs elements of order 1 to 3 and a positive refinement",
                "order 3 and refinement 1 are the defaults",
            ));
        }
        let refuse = |argument, what: &str, given: usize, most: usize| {
            Err(EngineError::new(
                "E0691",
                format!("{what} cannot be {given}"),
                format!("give a whole number from 1 to {most}, or leave it to the fidelity"),
            )
            .blame(argument))
        };
        match (self.face_elements, self.axial_order) {
            (Some(count), _) if !(1..=64).contains(&count) => {
                refuse("face_elements", "the number of elements along the face", count, 64)
            }
            (_, Some(order)) if !(1..=8).contains(&order) => {
                refuse("displacement_order", "the order of displacements along the face", order, 8)
            }
            _ => Ok(()),
        }
    }
}

/// A body of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BodyId(pub usize);
/// A bearing of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BearingId(pub usize);
/// A pair of surfaces of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PairId(pub usize);
/// An observable of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ObservableId(pub usize);

/// A deformable body on a moving frame.
#[derive(Clone)]
pub struct Body {
    /// What results and messages call it.
    pub name: String,
    /// How it is modelled. Bodies that share one share its structure.
    pub prototype: Arc<dyn Prototype>,
    /// Where its frame is meant to be; deviations of free components are measured from there.
    pub motion: Arc<dyn Motion>,
    /// Turns the structure in its frame, rad: the phase at which a gear was mounted.
    pub phase: f64,
    /// Freedoms of the frame that are not held, in the order of [`FREEDOMS`].
    pub free: [bool; 6],
    /// What acts on the frame from outside.
    pub load: Arc<dyn Load>,
    /// What hits the frame besides; ramps of the load leave it as it is.
    pub blows: Vec<Blow>,
    /// Masses on the frame beside the body's own.
    pub added: Inertia,
}

impl Body {
    /// A body that is held on its frame and not loaded.
    pub fn new(
        name: impl Into<String>,
        prototype: Arc<dyn Prototype>,
        motion: impl Motion + 'static,
    ) -> Body {
        Body {
            name: name.into(),
            prototype,
            motion: Arc::new(motion),
            phase: 0.0,
            free: [false; 6],
            load: Arc::new(Wrench::NONE),
            blows: Vec::new(),
            added: Inertia::default(),
        }
    }

    /// The body with these components of its frame free: there contact and load are in equilibrium.
    pub fn free_in(mut self, components: &[Component]) -> Body {
        for component in components {
            self.free[*component as usize] = true;
        }
        self
    }

    /// The body with masses on its frame beside its own.
    pub fn with_added(mut self, inertia: Inertia) -> Body {
        self.added = self.added + inertia;
        self
    }

    /// All that it weighs.
    pub fn inertia(&self) -> Inertia {
        self.prototype.inertia() + self.added
    }

    /// What acts on the frame from outside at a time (s), if so large a part of the load is on it.
    pub fn acted_on(&self, time: f64, part: f64) -> Wrench {
        let load = self.load.at(time);
        let load = if part == 1.0 { load } else { part * load };
        self.blows.iter().fold(load, |sum, blow| sum + blow.at(time))
    }

    /// The body under a load: a [`Wrench`] or a closure of time, see [`Load`].
    pub fn loaded(mut self, load: impl Load + 'static) -> Body {
        self.load = Arc::new(load);
        self
    }
}

/// Two surfaces that may touch: surface `surfaces[0]` of every tooth of the first body and `surfaces[1]` of the second.
#[derive(Clone)]
pub struct SurfacePair {
    /// The two bodies.
    pub bodies: [BodyId; 2],
    /// Index of the surface of each, as its [`Structure`] counts them.
    pub surfaces: [u32; 2],
    /// How contact between them is discretised.
    pub grid: GridOptions,
    /// Coefficient of friction: beside its pressure a surface that slides carries this part of it, against the sliding of the prescribed
    /// motions.
    pub friction: f64,
    /// Present when the two bodies are gears in mesh.
    pub mesh: Option<GearMesh>,
    /// Of the surfaces on the back sides of teeth, the pair of those that drive: both are one mesh, with one transmission error.
    pub front: Option<PairId>,
}

impl SurfacePair {
    /// Two surfaces that are no gears', with the default grid and without friction.
    pub fn new(bodies: [BodyId; 2], surfaces: [u32; 2]) -> SurfacePair {
        SurfacePair { bodies, surfaces, grid: GridOptions::default(), friction: 0.0, mesh: None, front: None }
    }
}

/// The contact grid of a surface pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// M: a grid has 2M + 1 cells across before refinement at edges; `None` takes what suits the fidelity, see
    /// [`GridOptions::half_cells_in_space`].
    pub half_cells: Option<usize>,
    /// N: in space a grid has 2N + 1 slices along the face.
    pub half_slices: usize,
    /// Total width, m; `None` takes it from the Hertz half-width under the full load.
    pub width: Option<f64>,
    /// Search for contact on rounded edges and beyond the nominal path of contact. Otherwise surfaces end sharply at
    /// their nominal ends, and gear teeth touch on the nominal path only, even where a relief would let them touch a
    /// little before and after.
    pub edges: bool,
}

impl GridOptions {
    /// M in the plane, where a cell costs little.
    pub fn half_cells_in_plane(&self) -> usize {
        self.half_cells.unwrap_or(24)
    }

    /// M in space, where every cell is there once for each slice: peaks of pressure are right to a few thousandths by it.
    pub fn half_cells_in_space(&self) -> usize {
        self.half_cells.unwrap_or(10)
    }
}

impl Default for GridOptions {
    fn default() -> Self {
        GridOptions { half_cells: None, half_slices: 8, width: None, edges: true }
    }
}

/// What makes a surface pair a gear mesh: enough to speak of transmission error and of its cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct GearMesh {
    /// Numbers of teeth.
    pub teeth: [u32; 2],
    /// m.
    pub base_radii: [f64; 2],
    /// +1 if the first body pushes counter-clockwise, -1 if clockwise.
    pub drive_sense: f64,
    /// +1 external, -1 internal: a positive turn of the first body turns the second by `-sign`.
    pub sign: f64,
    /// Teeth of the pair that enters contact at the start of the cycle.
    pub entering: [u32; 2],
    /// Time at which it does, s.
    pub start: f64,
    /// Time of one pitch, s.
    pub period: f64,
    /// The characteristic points of the path of contact, in order of time.
    pub characteristic: Vec<CharacteristicPoint>,
    /// Roll angle of the entering pair's first tooth at the start and at the end of the cycle, rad.
    pub roll: [f64; 2],
    /// The nominal path of contact: least and greatest roll angle of the first gear, rad.
    pub path: [f64; 2],
    /// Roll angle of the first gear's tooth 0, were it in contact, where that gear's angle is zero and the line of centres is where it is
    /// at time 0, rad.
    pub roll_at_zero: f64,
    /// How fast the line of centres turns at time 0, rad/s: of a planet, with its carrier. 0 where both axes rest.
    pub orbit: f64,
    /// How far the second gear would have to turn, from where it is meant to be, for rigid teeth to touch, rad. Of a mesh that phased a gear
    /// there is none; one that closes a loop may stand off by what axes are out of place and teeth too thin.
    pub stand_off: f64,
}

impl GearMesh {
    /// Whether a tooth of the first gear, whose body stands at `angle` (with its phase, less what the line of centres has turned since time
    /// 0), is on the nominal path of contact.
    pub fn on_path(&self, tooth: u32, angle: f64) -> bool {
        let turned = angle + TAU * f64::from(tooth) / f64::from(self.teeth[0]);
        let roll = self.roll_at_zero + self.drive_sense * turned;
        // Of all whole turns, the one that brings the tooth nearest to the middle of the path.
        let middle = 0.5 * (self.path[0] + self.path[1]);
        let roll = roll - TAU * ((roll - middle) / TAU).round();
        (self.path[0]..=self.path[1]).contains(&roll)
    }
}

/// A point of the path of contact where a pair of teeth enters or leaves, so that the load jumps on rigid teeth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CharacteristicPoint {
    /// `SAP` and `EAP`, start and end of active profile; `LPSTC` and `HPSTC`, lowest and highest point of single-tooth
    /// contact.
    pub name: &'static str,
    /// s from the start of the cycle.
    pub time: f64,
    /// Whether the position of interest is just after the jump, or just before it.
    pub after: bool,
}

/// Everything the model says. Frozen by the first analysis.
#[derive(Clone, Default)]
pub struct Scene {
    /// By [`BodyId`].
    pub bodies: Vec<Body>,
    /// By [`BearingId`].
    pub bearings: Vec<Bearing>,
    /// By [`PairId`].
    pub pairs: Vec<SurfacePair>,
    /// By [`ObservableId`].
    pub observables: Vec<Arc<dyn Observable>>,
    /// Whether a table of the modes at the first position is wanted.
    pub modes_table: Option<ModesRequest>,
}

impl Scene {
    /// Adds a body.
    pub fn add_body(&mut self, body: Body) -> BodyId {
        self.bodies.push(body);
        BodyId(self.bodies.len() - 1)
    }

    /// Adds a bearing.
    ///
    /// # Errors
    /// As [`Bearing::check`].
    pub fn add_bearing(&mut self, bearing: Bearing) -> Result<BearingId, EngineError> {
        bearing.check(self)?;
        self.bearings.push(bearing);
        Ok(BearingId(self.bearings.len() - 1))
    }

    /// Adds a pair of surfaces that may touch.
    pub fn add_pair(&mut self, pair: SurfacePair) -> PairId {
        self.pairs.push(pair);
        PairId(self.pairs.len() - 1)
    }

    /// Observing the same thing twice costs nothing.
    pub fn observe(&mut self, observable: impl Observable) -> ObservableId {
        let known = self.observables.iter().position(|known| known.as_ref().equals(observable.as_any()));
        let at = known.unwrap_or_else(|| {
            self.observables.push(Arc::new(observable));
            self.observables.len() - 1
        });
        ObservableId(at)
    }
}
