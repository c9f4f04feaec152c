//! Three-dimensional view of a run: the files of shapes, positions and meshes in a run directory,
//! and a self-contained page that displays them in a browser.
//!
//! The format of the files is described in `docs/view-files.md`. The page's program is the bundle
//! in `web/dist`, whose sources are in `web/src`.

#![warn(missing_docs)]

pub mod array_file;
pub mod content;
pub mod files;
pub mod mesh;
pub mod page;

pub use files::{FOLDER, ViewFiles};
