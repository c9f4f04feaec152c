//! Reasons why a structure cannot be built from a mesh.

use calyx_fe::SolveError;
use calyx_numerics::error::EngineError;

/// Error: the stiffness of a ring's cuts is not positive definite, so the ring has a mechanism or a
/// rigid-body motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the ring of sectors is not constrained: it has a rigid-body motion")]
pub struct UnrestrainedRing;

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
    #[error("the coordinates of the surface of `{faces}` are not those of its mesh")]
    CoordinatesDiffer { faces: String },
    #[error("the mesh has no area")]
    NoArea,
    #[error("the mesh of the bore is too coarse for the order of its constraints")]
    CoarseBore,
    #[error("the web cannot be meshed: {error}")]
    Web { error: String },
    #[error("the mesh of the bore is too coarse for the harmonics of its spline teeth")]
    CoarseSplineTeeth,
    #[error("its modes cannot be computed: {0}")]
    Modes(&'static str),
    #[error("spline teeth support it, which breaks the cyclic symmetry: it has no component modes")]
    ModesOnLugs,
    #[error(transparent)]
    Ring(#[from] UnrestrainedRing),
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
            StructureError::CoarseSplineTeeth => EngineError::new(
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
