//! Solid finite elements: hexahedra, pentahedra, tetrahedra and swept sections, with separate
//! interpolation of coordinates and displacements.
//!
//! Contact uses the true surfaces (`calyx_structure::surface`), which the coordinates'
//! interpolation approximates. Loads on the charts of swept meshes are functions of true arc length
//! and axial coordinate, and have the exact total, independently of the mesh.
//!
//! The elements are pure displacement elements, without measures against locking; higher orders
//! avoid it. The table lists the error of the displacements of a thick cylinder under pressure as
//! Poisson's ratio approaches 1/2 (hexahedra, L2, relative; `tests/solid/convergence.rs`, which
//! prints every type), and the error of the end deflection of a cantilever of 4 elements by its
//! slenderness:
//!
//! | order | elements | 0.3 | 0.49 | 0.499 | 0.4999 | 0.49999 | length 2 | 20 | 100 |
//! |---|---|---|---|---|---|---|---|---|---|
//! | 1 | 4 x 8 | 4e-3 | 5e-2 | 3e-1 | 8e-1 | 1 | -13 % | -93 % | -99.7 % |
//! | 2 | 2 x 4 | 3e-4 | 1e-3 | 1e-2 | 1e-1 | 6e-1 | -0.3 % | -1.1 % | -1.5 % |
//! | 3 | 2 x 4 | 2e-5 | 2e-5 | 7e-5 | 7e-4 | 7e-3 | 0 | 0 | 0 |
//!
//! See `docs/theory/finite-elements.md`.

mod assembly;
pub mod cells;
pub mod dof_sets;
pub mod fourier;
pub mod interpolation;
pub mod line_interpolation;
mod load;
pub mod mesh;
pub mod model;
pub mod recovery;
mod surface_stress;
pub mod sweep;
mod swept;

pub use cells::CellError;
pub use dof_sets::{DofError, DofKind, DofSets, Reduced};
pub use fourier::{Component, RevolutionSurface, Series, Term};
pub use interpolation::{Cell, Interpolation};
pub use mesh::{ABSENT, ElementFace, FacePoint, FaceSet, SolidElement, SolidElementPoint, SolidMesh};
pub use model::SolidModel;
pub use recovery::{ErrorEstimate, RecoveredStress};
pub use surface_stress::{SurfaceStressRecovery, SurfaceStressRows};
pub use sweep::{FACE_END, FACE_START, SweepError, coordinate_stations};
pub use swept::{FaceChart, Swept};
