//! Mesh of an elastic body whose surface radiates sound, with openings to be closed and panels
//! whose contributions are of interest.

use super::CellShape;
use calyx_numerics::vec3::Vector;

/// Mesh of an elastic body in its coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyMesh {
    /// Positions of the nodes, m.
    pub points: Vec<Vector>,
    /// Labels of the nodes in their file.
    pub labels: Vec<u64>,
    /// Elements with their nodes, as indices of points.
    pub cells: Vec<(CellShape, Vec<usize>)>,
    /// Openings of its surface that lids close.
    pub openings: Vec<Opening>,
    /// Panels of its surface.
    pub panels: Vec<Panel>,
}

/// Opening of the surface of a body, such as a bearing bore.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Name.
    pub name: String,
    /// Indices of the nodes of its rim, or of a bore between two rims, ascending.
    pub nodes: Vec<usize>,
}

/// Part of the surface of a body, such as a cover.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// Name.
    pub name: String,
    /// Indices of the nodes of its elements, ascending.
    pub nodes: Vec<usize>,
}

impl Panel {
    /// Name of the surface that belongs to no panel, in results.
    pub const REST: &str = "rest";
}
