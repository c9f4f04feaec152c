//! Mesh that a deck has for results.

use super::SkippedInput;
use crate::model::Node;

/// Mesh of a NASTRAN deck, in its unit of length: what is needed to locate results.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NastranMesh {
    /// Grid points in ascending order of their label.
    pub nodes: Vec<Node>,
    /// Shell and solid elements.
    pub elements: Vec<NastranMeshElement>,
    /// Names of all files that were read.
    pub files: Vec<String>,
    /// Elements that are no part of the mesh, such as beams, springs and fluids.
    pub skipped: Vec<SkippedInput>,
}

/// Element of a [`NastranMesh`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NastranMeshElement {
    /// Label.
    pub label: u64,
    /// Shape.
    pub shape: NastranMeshShape,
    /// Indices of its corners, in the order of NASTRAN; midside nodes are left out.
    pub nodes: Vec<usize>,
}

/// Shape of a [`NastranMeshElement`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NastranMeshShape {
    /// Triangle.
    Triangle,
    /// Quadrilateral.
    Quadrilateral,
    /// Tetrahedron.
    Tetrahedron,
    /// Wedge.
    Wedge,
    /// Hexahedron.
    Hexahedron,
}

impl NastranMeshShape {
    /// Returns the number of corners.
    pub fn corners(self) -> usize {
        match self {
            Self::Triangle => 3,
            Self::Quadrilateral | Self::Tetrahedron => 4,
            Self::Wedge => 6,
            Self::Hexahedron => 8,
        }
    }

    /// Returns whether the shape is that of a solid element.
    pub fn is_solid(self) -> bool {
        matches!(self, Self::Tetrahedron | Self::Wedge | Self::Hexahedron)
    }
}
