//! Tests of the readers of finite-element models.

mod cases;
mod decks;
pub mod files;
mod formats;
mod hostile;
mod mesh_of_decks;
mod mutations;
mod summary;
