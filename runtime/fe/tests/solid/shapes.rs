//! Meshes of every kind of element over the same boxes.

use calyx_fe::solid::{Cell, SolidMesh};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, Side, uniform};

/// A kind of element with the orders of its displacements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Lagrange elements.
    Cells(Cell, u8),
    /// Swept: order in the section, order along.
    Swept(u8, u8),
}

impl Kind {
    /// The order at which theory has it converge.
    pub fn order(self) -> u8 {
        match self {
            Self::Cells(_, order) => order,
            Self::Swept(section, axial) => section.min(axial),
        }
    }
}

/// Every kind.
pub fn kinds() -> Vec<Kind> {
    let cells = [Cell::Hexahedron, Cell::Pentahedron, Cell::Tetrahedron];
    let mut kinds =
        cells.iter().flat_map(|&cell| (1..=3).map(move |order| Kind::Cells(cell, order))).collect::<Vec<_>>();
    kinds.extend(
        [(1, 1), (2, 2), (3, 3), (1, 3), (3, 2), (2, 5)].map(|(section, axial)| Kind::Swept(section, axial)),
    );
    kinds
}

/// The unit cube divided into this number of boxes along each axis, each of one hexahedron, two
/// pentahedra or six tetrahedra, and then deformed.
pub fn cube(
    kind: Kind,
    coordinate_order: u8,
    divisions: [usize; 3],
    bend: &dyn Fn([f64; 3]) -> [f64; 3],
) -> SolidMesh {
    match kind {
        Kind::Cells(cell, order) => {
            let (points, cells) = boxes(cell, divisions);
            SolidMesh::of_cells(&points, &cells, order, coordinate_order, bend).expect("sound")
        }
        Kind::Swept(section, axial) => {
            let block = Block::new(
                Curve::line([0.0, 0.0], [1.0, 0.0]),
                Curve::line([1.0, 0.0], [1.0, 1.0]),
                Curve::line([0.0, 1.0], [1.0, 1.0]),
                Curve::line([0.0, 0.0], [0.0, 1.0]),
            )
            .divided(uniform(divisions[0]), uniform(divisions[1]))
            .named(Side::Left, "x = 0");
            let mut builder = MeshBuilder::new();
            builder.block(block).coordinate_order(ElementOrder::full(coordinate_order));
            let plane = builder.finish(ElementOrder::full(section)).expect("one block");
            let orders = vec![axial; plane.nodes.len()];
            let place = |[x, y]: [f64; 2], z: f64| bend([x, y, z]);
            SolidMesh::swept_with(&plane, &uniform(divisions[2]), &orders, coordinate_order, &place)
                .expect("sound")
        }
    }
}

/// Cells with their corners.
type Cells = Vec<(Cell, Vec<usize>)>;

/// Parts of a box, as corners in lexicographic order: 0 (0,0,0), 1 (1,0,0), 2 (0,1,0) ... 7
/// (1,1,1).
pub fn parts(cell: Cell) -> &'static [&'static [usize]] {
    match cell {
        Cell::Hexahedron => &[&[0, 1, 2, 3, 4, 5, 6, 7]],
        Cell::Pentahedron => &[&[0, 1, 3, 4, 5, 7], &[0, 3, 2, 4, 7, 6]],
        // Kuhn's: one for each order in which the axes are walked along, from corner 0 to corner 7.
        Cell::Tetrahedron => {
            &[&[0, 1, 3, 7], &[0, 3, 2, 7], &[0, 2, 6, 7], &[0, 6, 4, 7], &[0, 4, 5, 7], &[0, 5, 1, 7]]
        }
    }
}

fn boxes(cell: Cell, [l, m, n]: [usize; 3]) -> (Vec<[f64; 3]>, Cells) {
    let at = |i: usize, j: usize, k: usize| (k * (m + 1) + j) * (l + 1) + i;
    let mut points = Vec::new();
    for k in 0..=n {
        for j in 0..=m {
            points.extend((0..=l).map(|i| [i as f64 / l as f64, j as f64 / m as f64, k as f64 / n as f64]));
        }
    }
    let mut cells = Vec::new();
    for k in 0..n {
        for j in 0..m {
            for i in 0..l {
                let corner = |c: usize| at(i + c % 2, j + c / 2 % 2, k + c / 4);
                cells
                    .extend(parts(cell).iter().map(|part| (cell, part.iter().map(|&c| corner(c)).collect())));
            }
        }
    }
    (points, cells)
}
