//! Sound of a surface whose vibration another program has computed or measured.
//!
//! [`Vibration::of_unv`] reads a mesh and the motion of its nodes from a universal file,
//! [`Vibration::of_nastran`] joins the mesh of a NASTRAN deck with results, and [`surface_sound`]
//! closes the surface, coarsens it to what the wavelength needs, and computes power, radiation
//! efficiency and pressures at points for each frequency or normal mode.

mod cases;
mod deck;
mod functions;
mod motions;
mod results;
mod solution;
mod surface;
mod vibration;

pub use cases::{CaseKind, VibrationCase};
pub use deck::{DeckMesh, GridPoint};
pub use results::{CaseSound, SurfaceOfSound, SurfaceSound};
pub use solution::{SoundOptions, surface_sound};
pub use vibration::Vibration;
