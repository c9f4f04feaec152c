//! The engine: finite elements and contact. A scene becomes a plan, a plan a system, the system is stepped.
//! Knows nothing of the language.

pub mod contact;
pub mod error;
pub mod fe;
pub mod material;
pub mod motion;
pub mod profile;
pub mod structure;
