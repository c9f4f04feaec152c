//! Universal files (UNV): exchange of meshes, results and measured functions with other programs.
//!
//! [`read`] and [`write()`] handle text datasets 55, 58, 82, 151, 164, 2411, 2412 and 2414. The
//! reader lists other datasets as skipped. Quantities stay in the units of the file;
//! [`UnvFile::length_factor`] converts lengths.

mod dataset;
mod reader;
mod record;
mod surface;
mod writer;

pub use dataset::{
    Abscissae, AnalysisData, Element, Entity, Function, FunctionAxis, FunctionEnd, Header, LocatedValues,
    NodalData, Node, Ordinates, ResultKind, SkippedDataset, TraceLine, Units, UnvDataset, UnvFile,
};
pub use reader::read;
pub use record::UnvError;
pub(crate) use record::real;
pub use surface::{mesh_datasets, pressure_dataset, surface_mesh, triangle_datasets};
pub use writer::write;
