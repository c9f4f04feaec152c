//! A structure in the plane or in three dimensions.

use crate::interface::Structure;
use crate::solid::SolidStructure;
use std::sync::Arc;

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
    pub fn stored(&self) -> Option<Vec<u8>> {
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
