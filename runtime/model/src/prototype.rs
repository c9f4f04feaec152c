//! What a body is made of, as whoever describes it implements it: its structure, modes and inertia, each made when it is asked for.

use crate::fidelity::{Fidelity, StructureOptions};
use crate::lug_contact::LugContact;
use calyx_fe::inertia::Inertia;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::Key;
use calyx_structure::solid::SolidStructure;
use calyx_structure::{BodyModes, Drawable, MeshedBody, Structure, StructureSize};
use std::any::Any;
use std::sync::Arc;

/// How a body is to be modelled; makes its [`Structure`] when the plan says so.
///
/// A type, not a view: whoever knows what a body is made of finds it again by [`std::any::Any`].
pub trait Prototype: Any + Send + Sync {
    /// Whether the body can be modelled so, in the plane or in three dimensions: what
    /// [`Prototype::build`] or [`Prototype::build_solid`] would reject after a look at the data.
    /// The plan asks this before anything is built, whatever a cache holds.
    ///
    /// # Errors
    /// What building would fail with.
    fn check(&self, _options: &StructureOptions, _in_space: bool) -> Result<(), EngineError> {
        Ok(())
    }

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
        Err(no_model_in_space())
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

    /// As [`Prototype::shape`], in space: usually [`Reshaped`](calyx_structure::solid::Reshaped), the shared structure under the surfaces
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
    /// [`BoreHold::LooseLugs`](calyx_structure::BoreHold::LooseLugs).
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

/// The refusal of bodies that have only a plane model.
pub fn no_model_in_space() -> EngineError {
    EngineError::new("E0690", "a body of this kind has no model in three dimensions", "")
}

/// An input that the chosen fidelity cannot see.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Ignored {
    /// Its name.
    pub input: String,
    /// Why it is not seen.
    pub reason: String,
}
