//! Elastic compliance of bodies relative to the body's frame, at their loadable surfaces.
//!
//! Displacements are elastic only: rigid-body motion belongs to the frame. The models in this
//! module are plane models, per unit of face width: forces in N/m, compliances in m/(N/m).
//! [`solid`] contains three-dimensional bodies.
//!
//! See `docs/theory/compliance.md` and `docs/theory/substructures.md`.

pub mod analytic;
mod answers;
mod bore;
pub(crate) mod bore_coupling;
mod condense;
pub(crate) mod deformed;
pub(crate) mod elastic;
pub(crate) mod far_coupling;
pub(crate) mod kernel;
pub(crate) mod loose_lugs;
pub(crate) mod lugs;
mod modes;
mod reshaped;
pub(crate) mod rigid;
pub(crate) mod ring;
pub(crate) mod sampling;
mod size;
pub mod solid;
pub(crate) mod spline;
mod stored;
mod web;

pub use bore::BoreHold;
pub use deformed::{BodyLoads, DeformedSector, Drawable, MeshedBody};
pub use elastic::{ElasticStructure, Hold, RingSource, SurfaceSource};
pub use lugs::{LugForce, Lugs};
pub use modes::BodyModes;
pub use reshaped::ReshapedSurface;
pub use rigid::RigidStructure;
pub use sampling::SplitOptions;
pub use size::StructureSize;
pub use web::RevolvedWeb;

use crate::dense;
use crate::error::EngineError;
use crate::fe::SolveError;
use crate::interrupt::Interrupt;
use crate::profile::Profile;
use faer::{Mat, MatRef};
use ring::FreeRing;
use solid::SolidStructure;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Reasons why a structure cannot be built from a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs, reason = "each says itself in its message")]
pub enum StructureError {
    #[error("the mesh has no chain of edges `{chain}`")]
    NoChain { chain: String },
    #[error("`{chain}` has too few elements: contact cannot be matched to the mesh on them")]
    Coarse { chain: String },
    #[error("the nodes of `{}`, turned by a pitch, are not those of `{}`", cuts[0], cuts[1])]
    CutsDiffer { cuts: [String; 2] },
    #[error("the mesh has no set of faces `{faces}`")]
    NoFaces { faces: String },
    #[error("the faces `{faces}` are not swept along the z axis")]
    NotSwept { faces: String },
    #[error("the mesh has no area")]
    NoArea,
    #[error("the mesh of the bore is too coarse for the order of its constraints")]
    CoarseBore,
    #[error("the web cannot be meshed: {error}")]
    Web { error: String },
    #[error("the mesh of the bore is too coarse for the harmonics of its spline teeth")]
    CoarseLugs,
    #[error("its modes cannot be computed: {0}")]
    Modes(&'static str),
    #[error("spline teeth support it, which breaks the cyclic symmetry: it has no component modes")]
    ModesOnLugs,
    #[error(transparent)]
    Ring(#[from] FreeRing),
    #[error(transparent)]
    Solve(#[from] SolveError),
    #[error(transparent)]
    Interrupted(EngineError),
}

impl From<StructureError> for EngineError {
    /// Converts the error for a prototype whose mesh is expected to be valid.
    fn from(error: StructureError) -> Self {
        match error {
            StructureError::Interrupted(error) => error,
            StructureError::CoarseBore => EngineError::new(
                "E0649",
                "the mesh is too coarse for the order up to which the rim is constrained",
                "reduce the rim's orders around or along the axis, or take more elements along the face",
            )
            .blame("rim"),
            StructureError::CoarseLugs => EngineError::new(
                "E0656",
                "the mesh of the bore is too coarse for the spline teeth that support the rim",
                "reduce the number of spline teeth, make them wider, or use a lower axial order or a finer mesh",
            )
            .blame("rim"),
            StructureError::Modes(reason) => EngineError::new(
                "E0758",
                format!("the modes of a body cannot be computed: {reason}"),
                "ask for a lower highest frequency, or take another refinement of the mesh",
            ),
            StructureError::ModesOnLugs => EngineError::new(
                "E0759",
                "a body on spline teeth has no component modes: they break its cyclic symmetry",
                "use a rigid or free bore, or model it as a rigid body in vibration",
            )
            .blame("rim"),
            error => EngineError::new("E0678", format!("the structure cannot be condensed: {error}"), ""),
        }
    }
}

/// A loadable surface of a structure: a flank of one tooth, or the rim of a disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Chart {
    /// Index of the tooth (or repeated sector), counted counter-clockwise from 0. 0 where nothing
    /// repeats.
    pub tooth: u32,
    /// Index of the surface on the tooth. Gears: 0 is the flank whose outward normal points
    /// counter-clockwise, 1 the other.
    pub surface: u32,
}

/// A normal force on a surface: positive presses into the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceLoad {
    /// Surface on which the force acts.
    pub chart: Chart,
    /// Arc length on the chart's profile, m.
    pub s: f64,
    /// Force, N per metre of face width.
    pub force: f64,
}

/// Location of a recovered stress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StressPlace {
    /// Index of the tooth, counted counter-clockwise from 0.
    pub tooth: u32,
    /// Index of the surface, as in [`Chart::surface`].
    pub surface: u32,
    /// Arc length on the fillet, from the end of the flank, m.
    pub s: f64,
    /// Position in the body's frame, m.
    pub position: [f64; 2],
}

/// Elastic behaviour of a body.
///
/// The compliance of a surface is split: `A(s, s') = G(s - s') + R(s, s')`. `G` is the compliance
/// of the half-plane, `-2 / (pi E') ln(|s - s'| / L)` with `E'` = [`Structure::surface_modulus`]
/// and `L` = [`Structure::reference_length`]. It applies between points of the same chart only and
/// is 0 between different charts. `R` is the smooth remainder, which the structure evaluates.
pub trait Structure: Send + Sync {
    /// Returns the profile of a surface of tooth 0 in the body's frame. In tooth coordinates the
    /// profile is the same for every tooth.
    fn profile(&self, surface: u32) -> Arc<dyn Profile>;

    /// Returns the angle of tooth `tooth` in the body's frame, rad (counter-clockwise).
    fn tooth_angle(&self, tooth: u32) -> f64 {
        let teeth = self.teeth();
        TAU * f64::from(tooth % teeth) / f64::from(teeth)
    }

    /// Returns the number of repeated sectors; 1 where nothing repeats.
    fn teeth(&self) -> u32;

    /// Returns the plane-strain modulus E', Pa. Infinite for a rigid body, whose `G` and `R` are
    /// zero.
    fn surface_modulus(&self) -> f64;

    /// Returns the reference length L in the logarithm of the half-plane, m.
    fn reference_length(&self) -> f64;

    /// Adds `R` to `block`, row-major, `observe_s.len()` rows by `load_s.len()` columns: inward
    /// normal displacement at `observe_s` on `observe` per unit inward normal force at `load_s` on
    /// `load`, m/(N/m). The result is symmetric: exchanging loads and observers transposes it, bit
    /// for bit.
    fn add_compliance(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
    );

    /// [`Structure::add_compliance`] with checkpoints, as many cells take long.
    ///
    /// # Errors
    /// The interrupt's.
    fn add_compliance_until(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        interrupt.check()?;
        self.add_compliance(observe, observe_s, load, load_s, block);
        Ok(())
    }

    /// Returns the first principal stress (the largest tension, Pa) under the given loads at each
    /// stress recovery point of tooth `tooth`. On a free surface it is the stress along the
    /// surface, negative in compression. Empty if the structure recovers no stress.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPlace, f64)>;

    /// Returns the forces of the supporting spline teeth on the body under the given loads, one
    /// entry a spline tooth; empty if spline teeth do not support the body.
    fn lug_forces(&self, _loads: &[SurfaceLoad]) -> Vec<LugForce> {
        Vec::new()
    }

    /// Returns the compliance matrix of the spline teeth with clearance ([`BoreHold::LooseLugs`]):
    /// displacements by forces on them, all positive counter-clockwise, m/(N/m). The matrix is
    /// square and symmetric to the bit; `None` for a body without such spline teeth.
    fn lug_compliance(&self) -> Option<MatRef<'_, f64>> {
        None
    }

    /// Returns the displacements of the same spline teeth by unit inward normal forces at points of
    /// a chart, spline teeth by points. By reciprocity these are also the inward displacements at
    /// the points by forces of the spline teeth.
    fn lug_displacements(&self, _load: Chart, load_s: &[f64]) -> Mat<f64> {
        Mat::zeros(0, load_s.len())
    }

    /// Returns the contribution to [`Structure::stresses`] of the forces of these spline teeth on
    /// the body, one force each, counter-clockwise, Pa. Empty if they contribute nothing.
    fn stresses_by_lugs(&self, _tooth: u32, _surface: u32, _forces: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the same body with surfaces that differ slightly from its own, one for each; `None`
    /// if the structure does not support this.
    ///
    /// Contact acts on the new curve, along its own normal; the compliance is that of the old
    /// surface.
    fn reshaped(self: Arc<Self>, _surfaces: Vec<ReshapedSurface>) -> Option<Arc<dyn Structure>> {
        None
    }

    /// Returns the memory of the structure, in bytes, to within a few percent: the size that a
    /// cache counts.
    fn bytes(&self) -> usize;

    /// Returns everything but the contact surfaces, to be stored on disk for
    /// [`Prototype::restore`](crate::scene::Prototype::restore); `None` if building the structure
    /// is faster than reading it.
    fn stored(&self) -> Option<Vec<u8>> {
        None
    }
}

/// Structure of a two- or three-dimensional body.
#[derive(Clone)]
pub enum AnyStructure {
    /// Two-dimensional structure.
    Plane(Arc<dyn Structure>),
    /// Three-dimensional structure.
    Solid(Arc<dyn SolidStructure>),
}

impl AnyStructure {
    /// Returns the memory of the structure, in bytes.
    pub fn bytes(&self) -> usize {
        match self {
            AnyStructure::Plane(structure) => structure.bytes(),
            AnyStructure::Solid(structure) => structure.bytes(),
        }
    }

    /// Returns the data to be stored on disk.
    pub(crate) fn stored(&self) -> Option<Vec<u8>> {
        match self {
            AnyStructure::Plane(structure) => structure.stored(),
            AnyStructure::Solid(structure) => structure.stored(),
        }
    }
}

impl From<Arc<dyn Structure>> for AnyStructure {
    fn from(structure: Arc<dyn Structure>) -> Self {
        AnyStructure::Plane(structure)
    }
}

impl From<Arc<dyn SolidStructure>> for AnyStructure {
    fn from(structure: Arc<dyn SolidStructure>) -> Self {
        AnyStructure::Solid(structure)
    }
}

#[cfg(test)]
pub(crate) mod tests;
