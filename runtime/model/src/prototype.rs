//! Interface of a body model: its structure, modes and inertia, each built on request.

use crate::fidelity::{Fidelity, StructureOptions};
use crate::spline_contact::SplineContact;
use calyx_fe::inertia::Inertia;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::Key;
use calyx_structure::outer_surface::OuterSurface;
use calyx_structure::solid::SolidStructure;
use calyx_structure::surface::Surface;
use calyx_structure::{BodyModes, MeshedBody, Structure, StructureSize, VisualizationMesh};
use std::any::Any;
use std::sync::Arc;

/// Model of a body; builds its [`Structure`] when the plan requires one.
///
/// Implementations can be downcast through [`std::any::Any`].
pub trait Prototype: Any + Send + Sync {
    /// Checks whether the body can be modelled as plane or as three-dimensional, without building:
    /// returns the errors of [`Prototype::build`] or [`Prototype::build_solid`] that follow from
    /// the data alone. The plan calls this before anything is built, regardless of the cache.
    ///
    /// # Errors
    /// Those of building.
    fn check(&self, _options: &StructureOptions, _three_dimensional: bool) -> Result<(), EngineError> {
        Ok(())
    }

    /// Builds the elastic structure, the expensive part. Equal prototypes with equal options give
    /// equal structures.
    ///
    /// # Errors
    /// The structure cannot be built. Also those of the interrupt, which is polled between batches
    /// of work.
    fn build(
        &self,
        options: &StructureOptions,
        interrupt: &Interrupt,
    ) -> Result<Arc<dyn Structure>, EngineError>;

    /// Returns a key of everything that the structure depends on. Prototypes with equal keys share
    /// a structure within a scene and, through the cache, between analyses. A prototype without a
    /// key has its own structure.
    fn key(&self, _options: &StructureOptions) -> Option<Key> {
        None
    }

    /// Restores a structure from the bytes of [`Structure::stored`], built by a prototype of the
    /// same key; `None` if this is impossible.
    fn restore(&self, _options: &StructureOptions, _stored: &[u8]) -> Option<Arc<dyn Structure>> {
        None
    }

    /// Derives the structure of this body from one built by [`Prototype::build`] of this prototype
    /// or another with the same key. This is cheap, because the shared part is already condensed.
    ///
    /// # Errors
    /// The shape of this body cannot be derived.
    fn shape(
        &self,
        shared: Arc<dyn Structure>,
        _options: &StructureOptions,
    ) -> Result<Arc<dyn Structure>, EngineError> {
        Ok(shared)
    }

    /// Computes all plane vibration modes of the body with natural frequencies up to `highest`,
    /// rad/s. Without modes the body vibrates as a rigid one.
    ///
    /// # Errors
    /// E0758: some modes cannot be found. E0759: spline teeth constrain the body. Otherwise those
    /// of [`Prototype::build`].
    fn modes(
        &self,
        _options: &StructureOptions,
        _highest: f64,
        _interrupt: &Interrupt,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        Ok(None)
    }

    /// Returns the reason why an elastic body has no modes, if so. The body vibrates as a rigid
    /// one, and the plan states the reason.
    fn without_modes(&self) -> Option<&'static str> {
        None
    }

    /// Returns the inertia of the body in its frame; zero by default.
    fn inertia(&self) -> Inertia {
        Inertia::default()
    }

    /// Returns a key of everything that the modes depend on, like [`Prototype::key`] of the
    /// structure; `None` for a body without modes.
    fn modes_key(&self, _options: &StructureOptions, _highest: f64) -> Option<Key> {
        None
    }

    /// Restores modes from the bytes of the disk cache, computed by a prototype of the same key;
    /// `None` if this is impossible.
    fn restore_modes(&self, _options: &StructureOptions, _stored: &[u8]) -> Option<Arc<BodyModes>> {
        None
    }

    /// Derives the modes of this body from those of [`Prototype::modes`] of a prototype with the
    /// same key, like [`Prototype::shape`].
    ///
    /// # Errors
    /// The shape of this body cannot be derived.
    fn shape_modes(
        &self,
        shared: Arc<BodyModes>,
        _options: &StructureOptions,
    ) -> Result<Arc<BodyModes>, EngineError> {
        Ok(shared)
    }

    /// Builds the three-dimensional elastic structure on the mesh template of the options. Equal
    /// prototypes with equal options give equal structures.
    ///
    /// # Errors
    /// E0690: the body has no three-dimensional model; this is the default. Otherwise those of
    /// [`Prototype::build`].
    fn build_solid(
        &self,
        _options: &StructureOptions,
        _interrupt: &Interrupt,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        Err(no_solid_model())
    }

    /// Returns the key of the three-dimensional structure, like [`Prototype::key`]. Keys contain
    /// the kind of structure, so those of plane and three-dimensional structures differ.
    fn solid_key(&self, _options: &StructureOptions) -> Option<Key> {
        None
    }

    /// Restores a three-dimensional structure, like [`Prototype::restore`].
    fn restore_solid(&self, _options: &StructureOptions, _stored: &[u8]) -> Option<Arc<dyn SolidStructure>> {
        None
    }

    /// Derives the three-dimensional structure of this body, like [`Prototype::shape`]. The result
    /// is usually a [`ModifiedStructure`](calyx_structure::solid::ModifiedStructure): the shared
    /// structure with the surfaces of this body.
    ///
    /// # Errors
    /// The shape of this body cannot be derived.
    fn shape_solid(
        &self,
        shared: Arc<dyn SolidStructure>,
        _options: &StructureOptions,
    ) -> Result<Arc<dyn SolidStructure>, EngineError> {
        Ok(shared)
    }

    /// Builds the finite element mesh of the structure of [`Prototype::build`] or
    /// [`Prototype::build_solid`], to display the deformed body. Equal prototypes with equal
    /// options give equal meshes.
    ///
    /// # Errors
    /// Those of [`Prototype::build`].
    fn meshed(
        &self,
        _options: &StructureOptions,
        _three_dimensional: bool,
        _interrupt: &Interrupt,
    ) -> Result<VisualizationMesh, EngineError> {
        Ok(VisualizationMesh::Unavailable("is of a kind that pictures do not have"))
    }

    /// Derives the mesh of this body from that of [`Prototype::meshed`] of a prototype with the
    /// same key, like [`Prototype::shape`] and [`Prototype::shape_solid`].
    ///
    /// # Errors
    /// The shape of this body cannot be derived.
    fn shape_meshed(
        &self,
        shared: Arc<MeshedBody>,
        _options: &StructureOptions,
        _three_dimensional: bool,
    ) -> Result<Arc<MeshedBody>, EngineError> {
        Ok(shared)
    }

    /// Returns the outer surface of the body, to display it: that of its finite element mesh, if it
    /// has one at these options; `None` if the body has no shape.
    ///
    /// # Errors
    /// The body cannot be meshed. Otherwise those of the interrupt.
    fn outer_surface(
        &self,
        _options: &StructureOptions,
        _three_dimensional: bool,
        _interrupt: &Interrupt,
    ) -> Result<Option<OuterSurface>, EngineError> {
        Ok(None)
    }

    /// Returns the numbers of equations that [`Prototype::build`] or [`Prototype::build_solid`]
    /// would condense, from the mesh alone; `None` if there are none or the body cannot be meshed.
    fn size(&self, _fidelity: Fidelity, _options: &StructureOptions) -> Option<StructureSize> {
        None
    }

    /// Radius of the enclosing circle about the origin of the body, m.
    fn enclosing_radius(&self) -> f64;

    /// Returns the roll angle at this radius (m), rad; `None` if the profile has no involute there.
    fn roll_angle(&self, _radius: f64) -> Option<f64> {
        None
    }

    /// Face width, m.
    fn face_width(&self) -> f64;

    /// Returns the flanks of equal teeth, for meshes on general axes; `None` for a body without
    /// such teeth.
    fn tooth_flanks(&self) -> Option<ToothFlanks> {
        None
    }

    /// Returns the pitch cone and the root of equal teeth in the meridian plane, to draw a tooth on
    /// its projection plane; `None` for a body without such teeth.
    fn tooth_meridian(&self) -> Option<ToothMeridian> {
        None
    }

    /// Returns the pitch deviation of a tooth as an angle, rad, counter-clockwise.
    fn pitch_error(&self, _tooth: u32) -> f64 {
        0.0
    }

    /// Returns the spline teeth with clearance that support the body, if any: those of
    /// [`BoreSupport::SplineWithClearance`](calyx_structure::BoreSupport::SplineWithClearance) of
    /// its structure.
    fn spline_contact(&self) -> Option<SplineContact> {
        None
    }

    /// Returns whether a plane section cannot represent the body. A scene with such a body is
    /// modelled in three dimensions unless the fidelity is plane.
    fn needs_solid_model(&self) -> bool {
        false
    }

    /// Returns inputs that a model of this fidelity ignores, with reasons.
    fn ignored(&self, _fidelity: Fidelity) -> Vec<Ignored> {
        Vec::new()
    }
}

/// Flanks of a body with equal teeth: exact surfaces, independent of any mesh.
#[derive(Clone)]
pub struct ToothFlanks {
    /// Number of teeth.
    pub teeth: u32,
    /// Counter-clockwise and clockwise flank of tooth 0 in the coordinates of the body, whose teeth
    /// are arranged about the z axis. Tooth `k` is rotated by `2 pi k / teeth`.
    pub surfaces: [Arc<dyn Surface>; 2],
}

/// Pitch cone and root of equal teeth in the meridian plane, whose coordinates are the axial
/// position and the radius, m.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothMeridian {
    /// Unit vector along the pitch cone, towards the larger radius (the heel). Axial for a
    /// cylinder.
    pub along: [f64; 2],
    /// Points of the root at equal distances along the face, in the order of the surface coordinate
    /// `v`.
    pub root: Vec<[f64; 2]>,
}

/// Returns the error for bodies that have only a plane model.
pub fn no_solid_model() -> EngineError {
    EngineError::new("E0690", "a body of this kind has no model in three dimensions", "")
}

/// Input that the chosen fidelity ignores.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Ignored {
    /// Name of the input.
    pub input: String,
    /// Reason.
    pub reason: String,
}
