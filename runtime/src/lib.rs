//! The engine: finite elements and contact. A scene becomes a plan, a plan a system, the system is stepped.
//! Knows nothing of the language.
//!
//! [`scene::Scene`] says what there is, [`plan::Plan`] how it is modelled, [`system::System`] is built once and solved at
//! each position ([`step`]), [`observe`] reads values off a solved position, [`analysis`] runs a list of positions.
//! [`resources`] are what an analysis uses and no result depends on: threads, kept structures, an interrupt.

pub mod analysis;
mod building;
pub mod cache;
pub mod contact;
pub mod disc;
pub mod error;
pub mod fe;
pub mod holding;
pub mod interrupt;
pub mod load;
pub mod material;
pub mod motion;
pub mod observe;
pub mod plan;
pub mod profile;
pub mod resources;
pub mod results;
pub mod scene;
pub mod step;
pub mod structure;
pub mod system;
