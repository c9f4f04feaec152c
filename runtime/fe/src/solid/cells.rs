//! Solid meshes from cells given by their corners: nodes of any order are numbered so that cells
//! share those of shared faces.

use super::interpolation::{Cell, Interpolation};
use super::mesh::{ElementFace, FacePoint, FaceSet, SolidElement, SolidMesh};
use std::collections::{BTreeMap, HashMap};

/// Reasons why cells do not form a mesh. Positions in m.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "each says itself in its message")]
pub enum CellError {
    #[error("interpolation orders must be 1, 2 or 3")]
    Order,
    #[error("cell {cell} has {found} corners; a cell of its kind has {expected}")]
    CornerCount { cell: usize, found: usize, expected: usize },
    #[error("cell {cell} has a corner {corner}, but there are {count} points")]
    Corner { cell: usize, corner: usize, count: usize },
    #[error("cell {cell} is folded or turned over at ({}, {}, {})", at[0], at[1], at[2])]
    Folded { cell: usize, at: [f64; 3] },
}

impl Cell {
    /// Returns the Lagrange interpolation of an order over the cell.
    pub fn interpolation(self, order: u8) -> Interpolation {
        match self {
            Self::Hexahedron => Interpolation::Hexahedron(order),
            Self::Pentahedron => Interpolation::Pentahedron(order),
            Self::Tetrahedron => Interpolation::Tetrahedron(order),
        }
    }
}

impl SolidMesh {
    /// Builds a mesh of cells, each with its corners in the numbering of the linear interpolation,
    /// as indices of `points`.
    ///
    /// Nodes are equally spaced in the straight cells, and then moved by `bend`. Element `k` is
    /// cell `k`.
    ///
    /// # Errors
    /// An order is not 1, 2 or 3, or a cell has a wrong number of corners or is folded.
    pub fn of_cells(
        points: &[[f64; 3]],
        cells: &[(Cell, Vec<usize>)],
        order: u8,
        coordinate_order: u8,
        bend: &dyn Fn([f64; 3]) -> [f64; 3],
    ) -> Result<Self, CellError> {
        if ![order, coordinate_order].iter().all(|order| (1..=3).contains(order)) {
            return Err(CellError::Order);
        }
        for (cell, (kind, corners)) in cells.iter().enumerate() {
            let expected = kind.interpolation(1).node_count();
            if corners.len() != expected {
                return Err(CellError::CornerCount { cell, found: corners.len(), expected });
            }
            if let Some(&corner) = corners.iter().find(|&&corner| corner >= points.len()) {
                return Err(CellError::Corner { cell, corner, count: points.len() });
            }
        }
        let (nodes, positions) = number(points, cells, order);
        let (coordinates, places) = number(points, cells, coordinate_order);
        let elements = cells.iter().zip(nodes).zip(coordinates);
        let mut mesh = Self {
            nodes: positions,
            coordinate_nodes: places.into_iter().map(bend).collect(),
            elements: elements
                .map(|(((kind, _), nodes), coordinates)| SolidElement {
                    interpolation: kind.interpolation(order),
                    nodes,
                    coordinate_interpolation: kind.interpolation(coordinate_order),
                    coordinates,
                })
                .collect(),
            ..Self::default()
        };
        mesh.place_nodes();
        match mesh.folded() {
            Some((cell, at)) => Err(CellError::Folded { cell, at }),
            None => Ok(mesh),
        }
    }

    /// Returns the faces that belong to one element only, in the order of the elements.
    pub fn boundary(&self) -> Vec<ElementFace> {
        let mut faces = BTreeMap::<Vec<usize>, Vec<ElementFace>>::new();
        for (index, element) in self.elements.iter().enumerate() {
            for face in 0..element.interpolation.cell().face_count() {
                let locals = element.interpolation.face_nodes(face);
                let mut nodes = locals.into_iter().map(|local| element.nodes[local]).collect::<Vec<_>>();
                nodes.sort_unstable();
                faces.entry(nodes).or_default().push(ElementFace { element: index, face });
            }
        }
        let mut boundary =
            faces.into_values().filter(|shared| shared.len() == 1).flatten().collect::<Vec<_>>();
        boundary.sort_unstable();
        boundary
    }

    /// Names the boundary faces whose middle satisfies a condition.
    pub fn name_faces(&mut self, name: &str, mut condition: impl FnMut(&FacePoint) -> bool) {
        let middle = |face: &ElementFace| {
            let cell = self.elements[face.element].interpolation.cell();
            let at = if cell.is_triangle(face.face) { [1.0 / 3.0; 2] } else { [0.0; 2] };
            self.face_point(*face, at)
        };
        let faces = self.boundary().into_iter().filter(|face| condition(&middle(face))).collect();
        self.faces.insert(name.to_owned(), FaceSet { faces, chart: None });
    }
}

/// Returns the nodes of each cell, and their positions in the straight cells.
fn number(points: &[[f64; 3]], cells: &[(Cell, Vec<usize>)], order: u8) -> (Vec<Vec<usize>>, Vec<[f64; 3]>) {
    // A node is identified by the corners of which it is an average and their shares; this key is
    // the same in every cell.
    let mut known = HashMap::<Vec<(usize, i64)>, usize>::new();
    let mut positions = Vec::new();
    let mut of_cell = |(kind, corners): &(Cell, Vec<usize>)| {
        let places = kind.interpolation(order).node_coordinates();
        let node = |place: [f64; 3]| {
            let shares = kind.interpolation(1).shapes(place);
            // Shares are whole multiples of this.
            let unit = f64::from(order).powi(-3);
            let shares =
                corners.iter().zip(shares).map(|(&corner, shape)| (corner, (shape[0] / unit).round()));
            let shares = shares.filter(|(_, share)| *share != 0.0).collect::<Vec<_>>();
            let mut key = shares.iter().map(|&(corner, share)| (corner, share as i64)).collect::<Vec<_>>();
            key.sort_unstable();
            *known.entry(key).or_insert_with_key(|key| {
                let mut position = [0.0; 3];
                for &(corner, share) in key {
                    for axis in 0..3 {
                        position[axis] += share as f64 * unit * points[corner][axis];
                    }
                }
                positions.push(position);
                positions.len() - 1
            })
        };
        places.into_iter().map(node).collect::<Vec<_>>()
    };
    let nodes = cells.iter().map(&mut of_cell).collect();
    (nodes, positions)
}
