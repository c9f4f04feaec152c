//! What radiated sound needs of an elastic body: its mesh, openings to be closed, and motions of
//! nodes.

use super::CellShape;
use calyx_numerics::interrupt::MemoryReservation;
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
}

/// Opening of the surface of a body, such as a bearing bore.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Name.
    pub name: String,
    /// Indices of the nodes of its rim, or of a bore between two rims, ascending.
    pub nodes: Vec<usize>,
}

/// Displacements of nodes by units of the unknowns of a condensed body.
#[derive(Debug)]
pub struct MotionShapes {
    /// Displacements along the axes of the body by unknown and node, m: by unit displacements (m)
    /// and rotations (rad) of each attachment, then by component modes (m kg^(1/2)).
    pub displacements: Vec<Vec<[f64; 3]>>,
    /// Squared angular frequencies of the component modes, (rad/s)².
    pub eigenvalues: Vec<f64>,
    pub(super) _room: MemoryReservation,
}
