//! How bodies deform: elastic behaviour relative to the body's frame, seen through its loadable surfaces.
//!
//! Displacements are elastic only: what moves the body as a whole belongs to its frame.
//! Everything here is per unit of face width (a plane model): forces in N/m, compliances in m/(N/m). Bodies in space are in [`solid`].

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
use crate::profile::Profile;
use faer::{Mat, MatRef};
use ring::FreeRing;
use solid::SolidStructure;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Why a structure cannot be made of a mesh.
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
    /// For a prototype whose mesh was to be sound.
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
    /// Which tooth (or repeated sector), counted counter-clockwise from 0. 0 where nothing repeats.
    pub tooth: u32,
    /// Which surface of it. Gears: 0 is the flank whose outward normal points counter-clockwise, 1 the other.
    pub surface: u32,
}

/// A normal force on a surface: positive presses into the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceLoad {
    /// Where it acts.
    pub chart: Chart,
    /// Arc length on the chart's profile, m.
    pub s: f64,
    /// N per metre of face width.
    pub force: f64,
}

/// Where a recovered stress is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StressPlace {
    /// Counted counter-clockwise from 0.
    pub tooth: u32,
    /// As [`Chart::surface`].
    pub surface: u32,
    /// Arc length on the fillet from the end of the flank, m.
    pub s: f64,
    /// In the body's frame, m.
    pub position: [f64; 2],
}

/// Elastic behaviour of a body.
///
/// The compliance of a surface is split: `A(s, s') = G(s - s') + R(s, s')`. `G` is the half-plane's,
/// `-2 / (pi E') ln(|s - s'| / L)` with `E'` = [`Structure::surface_modulus`] and `L` =
/// [`Structure::reference_length`], between points of the same chart only (0 between different charts).
/// `R` is everything else, smooth, and evaluated here.
pub trait Structure: Send + Sync {
    /// The profile of a chart in the body's frame (already turned to its tooth), and the chart's profile in
    /// tooth coordinates is the same for every tooth.
    fn profile(&self, surface: u32) -> Arc<dyn Profile>;

    /// Angle by which tooth `tooth` is turned in the body's frame, rad (counter-clockwise).
    fn tooth_angle(&self, tooth: u32) -> f64 {
        let teeth = self.teeth();
        TAU * f64::from(tooth % teeth) / f64::from(teeth)
    }

    /// Number of repeated sectors; 1 where nothing repeats.
    fn teeth(&self) -> u32;

    /// E' in Pa. Infinite for a rigid body, whose `G` and `R` are zero.
    fn surface_modulus(&self) -> f64;

    /// L in the half-plane's logarithm, m.
    fn reference_length(&self) -> f64;

    /// Adds `R` to `block`, row-major, `observe_s.len()` rows by `load_s.len()` columns: inward normal displacement
    /// at `observe_s` on `observe` per unit inward normal force at `load_s` on `load`, m/(N/m).
    /// Symmetric: exchanging loads and observers transposes it, bit for bit.
    fn add_compliance(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
    );

    /// Principal stress of largest tension (Pa) at each point where stress is recovered, for the given loads, on tooth
    /// `tooth`: on a free surface the stress along it, negative where compressed. Empty if the structure recovers none.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPlace, f64)>;

    /// What the lugs that hold the body exert on it under the given loads, each in turn; none if no lugs hold it.
    fn lug_forces(&self, _loads: &[SurfaceLoad]) -> Vec<LugForce> {
        Vec::new()
    }

    /// Displacements of the body's loose lugs ([`BoreHold::LooseLugs`]) by forces on them, all counter-clockwise, m/(N/m): square and
    /// symmetric to the bit; `None` of a body that has none.
    fn lug_compliance(&self) -> Option<MatRef<'_, f64>> {
        None
    }

    /// Displacements of the same lugs by unit inward normal forces at points of a chart, lugs by points; and so the inward displacements there
    /// by forces of lugs.
    fn lug_displacements(&self, _load: Chart, load_s: &[f64]) -> Mat<f64> {
        Mat::zeros(0, load_s.len())
    }

    /// What forces of these lugs on the body, one each, counter-clockwise, add to [`Structure::stresses`], Pa. Empty where they add nothing.
    fn stresses_by_lugs(&self, _tooth: u32, _surface: u32, _forces: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// The same body with surfaces that differ from its own by little, one for each; `None` if it cannot be had so.
    ///
    /// What is pressed is the new curve, along its own normal; how the body gives is that of the old one.
    fn reshaped(self: Arc<Self>, _surfaces: Vec<ReshapedSurface>) -> Option<Arc<dyn Structure>> {
        None
    }

    /// Memory that the structure takes, in bytes, to the nearest few percent: what a cache counts.
    fn bytes(&self) -> usize;

    /// All of it but the surfaces that contact sees, to be kept on disk for [`Prototype::restore`](crate::scene::Prototype::restore);
    /// `None` if it is made faster than read.
    fn stored(&self) -> Option<Vec<u8>> {
        None
    }
}

/// A structure of either kind.
#[derive(Clone)]
pub enum AnyStructure {
    /// In the plane.
    Plane(Arc<dyn Structure>),
    /// In space.
    Solid(Arc<dyn SolidStructure>),
}

impl AnyStructure {
    /// Memory that it takes, in bytes.
    pub fn bytes(&self) -> usize {
        match self {
            AnyStructure::Plane(structure) => structure.bytes(),
            AnyStructure::Solid(structure) => structure.bytes(),
        }
    }

    /// What of it is to be kept on disk.
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
