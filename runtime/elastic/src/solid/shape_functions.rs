//! Shape functions of solid elements with their derivatives by the reference coordinates.
//!
//! Hexahedra occupy -1 <= xi, eta, zeta <= 1. Wedges occupy the triangle xi, eta >= 0, xi + eta <=
//! 1 times -1 <= zeta <= 1. Tetrahedra occupy xi, eta, zeta >= 0, xi + eta + zeta <= 1. Elements of
//! 20, 15 and 10 nodes are of the serendipity family (Zienkiewicz and Taylor, 5th ed., chapter 8).

use crate::model::SolidShape;

/// Value and derivatives of a shape function by xi, eta and zeta.
pub type ShapeFunction = [f64; 4];

/// Corners of the hexahedron.
const HEXAHEDRON: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Edges of the hexahedron by their corners, in the order of the midside nodes.
pub const HEXAHEDRON_EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 5], [2, 6], [3, 7], [4, 5], [5, 6], [6, 7], [7, 4]];

/// Edges of the wedge by their corners, in the order of the midside nodes.
pub const WEDGE_EDGES: [[usize; 2]; 9] =
    [[0, 1], [1, 2], [2, 0], [0, 3], [1, 4], [2, 5], [3, 4], [4, 5], [5, 3]];

/// Edges of the tetrahedron by their corners, in the order of the midside nodes.
pub const TETRAHEDRON_EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

/// Gradients of the triangle's barycentric coordinates.
const TRIANGLE: [[f64; 3]; 3] = [[-1.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

/// Gradients of the tetrahedron's barycentric coordinates.
const TETRAHEDRON: [[f64; 3]; 4] = [[-1.0, -1.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl SolidShape {
    /// Returns the number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            Self::Hexahedron8 | Self::IncompatibleHexahedron8 => 8,
            Self::Hexahedron20 => 20,
            Self::Wedge6 => 6,
            Self::Wedge15 => 15,
            Self::Tetrahedron4 => 4,
            Self::Tetrahedron10 => 10,
        }
    }

    /// Returns the reference coordinates of the corners.
    pub fn corners(self) -> Vec<[f64; 3]> {
        let triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        match self {
            Self::Hexahedron8 | Self::IncompatibleHexahedron8 | Self::Hexahedron20 => HEXAHEDRON.to_vec(),
            Self::Wedge6 | Self::Wedge15 => wedge_corners()
                .map(|(corner, side)| [triangle[corner][0], triangle[corner][1], side])
                .collect(),
            Self::Tetrahedron4 | Self::Tetrahedron10 => {
                vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            }
        }
    }

    /// Returns the edges with midside nodes, by their corners, in the order of these nodes.
    pub fn midside_edges(self) -> &'static [[usize; 2]] {
        match self {
            Self::Hexahedron20 => &HEXAHEDRON_EDGES,
            Self::Wedge15 => &WEDGE_EDGES,
            Self::Tetrahedron10 => &TETRAHEDRON_EDGES,
            Self::Hexahedron8 | Self::IncompatibleHexahedron8 | Self::Wedge6 | Self::Tetrahedron4 => &[],
        }
    }

    /// Returns the shape functions at a point, in the order of the nodes.
    pub fn shape_functions(self, point: [f64; 3]) -> Vec<ShapeFunction> {
        match self {
            Self::Hexahedron8 | Self::IncompatibleHexahedron8 => {
                HEXAHEDRON.iter().map(|&corner| trilinear(point, corner)).collect()
            }
            Self::Hexahedron20 => hexahedron20(point),
            Self::Wedge6 => {
                wedge_corners().map(|(corner, side)| wedge6_corner(point, corner, side)).collect()
            }
            Self::Wedge15 => wedge15(point),
            Self::Tetrahedron4 => (0..4).map(|corner| tetrahedron_coordinate(point, corner)).collect(),
            Self::Tetrahedron10 => tetrahedron10(point),
        }
    }
}

/// Returns the product of two functions.
fn product(a: ShapeFunction, b: ShapeFunction) -> ShapeFunction {
    [a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + a[0] * b[2], a[3] * b[0] + a[0] * b[3]]
}

/// Returns `scale a + constant`.
fn affine(a: ShapeFunction, scale: f64, constant: f64) -> ShapeFunction {
    [scale * a[0] + constant, scale * a[1], scale * a[2], scale * a[3]]
}

fn sum(a: ShapeFunction, b: ShapeFunction) -> ShapeFunction {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]
}

/// Returns a reference coordinate as a function.
fn coordinate(point: [f64; 3], axis: usize) -> ShapeFunction {
    let mut function = [point[axis], 0.0, 0.0, 0.0];
    function[axis + 1] = 1.0;
    function
}

/// Returns `1 - x^2` of a coordinate.
fn bubble(point: [f64; 3], axis: usize) -> ShapeFunction {
    let x = coordinate(point, axis);
    affine(product(x, x), -1.0, 1.0)
}

/// Returns `(1 + x x_i) / 2` of a coordinate.
fn linear(point: [f64; 3], axis: usize, at: f64) -> ShapeFunction {
    affine(coordinate(point, axis), 0.5 * at, 0.5)
}

fn trilinear(point: [f64; 3], corner: [f64; 3]) -> ShapeFunction {
    let [x, y, z] = [0, 1, 2].map(|axis| linear(point, axis, corner[axis]));
    product(x, product(y, z))
}

fn hexahedron20(point: [f64; 3]) -> Vec<ShapeFunction> {
    let corner = |corner: [f64; 3]| {
        let mut bracket = [-2.0, 0.0, 0.0, 0.0];
        for axis in 0..3 {
            bracket = sum(bracket, affine(coordinate(point, axis), corner[axis], 0.0));
        }
        product(trilinear(point, corner), bracket)
    };
    let midside = |[from, to]: [usize; 2]| {
        let at = [0, 1, 2].map(|axis| 0.5 * (HEXAHEDRON[from][axis] + HEXAHEDRON[to][axis]));
        let factor =
            |axis: usize| if at[axis] == 0.0 { bubble(point, axis) } else { linear(point, axis, at[axis]) };
        product(factor(0), product(factor(1), factor(2)))
    };
    HEXAHEDRON.into_iter().map(corner).chain(HEXAHEDRON_EDGES.into_iter().map(midside)).collect()
}

/// Returns a barycentric coordinate of the triangle.
fn triangle_coordinate(point: [f64; 3], corner: usize) -> ShapeFunction {
    let [a, b, c] = TRIANGLE[corner];
    let constant = if corner == 0 { 1.0 } else { 0.0 };
    [constant + a * point[0] + b * point[1], a, b, c]
}

/// Returns a barycentric coordinate of the tetrahedron.
fn tetrahedron_coordinate(point: [f64; 3], corner: usize) -> ShapeFunction {
    let [a, b, c] = TETRAHEDRON[corner];
    let constant = if corner == 0 { 1.0 } else { 0.0 };
    [constant + a * point[0] + b * point[1] + c * point[2], a, b, c]
}

/// Returns the corners of the wedge: corner of the triangle, and zeta.
fn wedge_corners() -> impl Iterator<Item = (usize, f64)> {
    [-1.0, 1.0].into_iter().flat_map(|side| (0..3).map(move |corner| (corner, side)))
}

fn wedge6_corner(point: [f64; 3], corner: usize, side: f64) -> ShapeFunction {
    product(triangle_coordinate(point, corner), linear(point, 2, side))
}

fn wedge15(point: [f64; 3]) -> Vec<ShapeFunction> {
    let corner = |(corner, side): (usize, f64)| {
        let area = triangle_coordinate(point, corner);
        let quadratic = product(affine(area, 2.0, -1.0), linear(point, 2, side));
        product(area, sum(quadratic, affine(bubble(point, 2), -0.5, 0.0)))
    };
    let midside = |[from, to]: [usize; 2]| {
        let [one, other] = [from, to].map(|corner| triangle_coordinate(point, corner % 3));
        if from % 3 == to % 3 {
            product(one, bubble(point, 2))
        } else {
            let side = if from < 3 { -1.0 } else { 1.0 };
            affine(product(product(one, other), linear(point, 2, side)), 4.0, 0.0)
        }
    };
    wedge_corners().map(corner).chain(WEDGE_EDGES.into_iter().map(midside)).collect()
}

fn tetrahedron10(point: [f64; 3]) -> Vec<ShapeFunction> {
    let corner = |corner: usize| {
        let volume = tetrahedron_coordinate(point, corner);
        product(volume, affine(volume, 2.0, -1.0))
    };
    let midside = |edge: [usize; 2]| {
        let [one, other] = edge.map(|corner| tetrahedron_coordinate(point, corner));
        affine(product(one, other), 4.0, 0.0)
    };
    (0..4).map(corner).chain(TETRAHEDRON_EDGES.into_iter().map(midside)).collect()
}
