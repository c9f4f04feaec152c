//! Interpolation in solid elements: Lagrange hexahedra, pentahedra and tetrahedra, and section
//! elements with axodes (FQP, report 3.1.4). Used for displacements and coordinates.

use super::line_interpolation::{equispaced, lobatto};
use crate::interpolation::{ElementOrder, side_point};
use calyx_numerics::interpolation::lagrange_with_slopes;
use calyx_numerics::quadrature::gauss_legendre;
use std::sync::Arc;

/// Shape function at a point: value, derivatives by `xi`, `eta` and `zeta`.
pub type SolidShape = [f64; 4];

/// Reference cell of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cell {
    /// Hexahedron -1 <= xi, eta, zeta <= 1.
    ///
    /// Faces 0 to 3 are `eta = -1`, `xi = 1`, `eta = 1`, `xi = -1` (as the sides of a plane
    /// element), 4 is `zeta = -1`, 5 is `zeta = 1`.
    Hexahedron,
    /// Pentahedron xi, eta >= 0, xi + eta <= 1; -1 <= zeta <= 1.
    ///
    /// Faces 0 to 2 are `eta = 0`, `xi + eta = 1`, `xi = 0`; 3 is `zeta = -1`, 4 is `zeta = 1`.
    Pentahedron,
    /// Tetrahedron xi, eta, zeta >= 0, xi + eta + zeta <= 1.
    ///
    /// Faces 0 to 3 are `zeta = 0`, `eta = 0`, `xi = 0`, `xi + eta + zeta = 1`.
    Tetrahedron,
}

/// Interpolation of a field in an element.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Interpolation {
    /// Lagrange polynomials of order 1, 2 or 3 on equally spaced nodes; `xi` runs fastest, then
    /// `eta`.
    Hexahedron(u8),
    /// Complete polynomials of the order over the triangle, times Lagrange polynomials along
    /// `zeta`. Nodes in layers of constant `zeta`, in each with `xi` running fastest, then `eta`.
    Pentahedron(u8),
    /// Complete polynomials of order 1, 2 or 3; `xi` runs fastest, then `eta`.
    Tetrahedron(u8),
    /// Plane element in `xi` and `eta` with a line of nodes along `zeta` on Gauss-Lobatto points,
    /// an *axode*, in place of each of its nodes. Nodes are in the order of the axodes, along each
    /// with increasing `zeta`. Orders may differ between axodes: elements that share a side of the
    /// section share its axodes.
    Axodes {
        /// Order of the plane element.
        section: ElementOrder,
        /// Order of each axode, at least 1.
        axial: Arc<[u8]>,
    },
}

impl Interpolation {
    /// Returns an element whose axodes all have one order.
    pub fn axodes(section: ElementOrder, order: u8) -> Self {
        Self::Axodes { section, axial: vec![order; section.node_count()].into() }
    }

    /// Returns the reference cell.
    pub fn cell(&self) -> Cell {
        match self {
            Self::Hexahedron(_) | Self::Axodes { .. } => Cell::Hexahedron,
            Self::Pentahedron(_) => Cell::Pentahedron,
            Self::Tetrahedron(_) => Cell::Tetrahedron,
        }
    }

    /// Returns true if every order is supported.
    pub fn is_valid(&self) -> bool {
        match self {
            Self::Hexahedron(order) | Self::Pentahedron(order) | Self::Tetrahedron(order) => {
                (1..=3).contains(order)
            }
            Self::Axodes { section, axial } => {
                section.is_valid()
                    && axial.len() == section.node_count()
                    && axial.iter().all(|&order| order > 0)
            }
        }
    }

    /// Returns the highest order across the section (`xi`, `eta`) and along `zeta`.
    pub fn highest(&self) -> [u8; 2] {
        match self {
            Self::Hexahedron(order) | Self::Pentahedron(order) | Self::Tetrahedron(order) => [*order; 2],
            Self::Axodes { section, axial } => [section.highest(), axial.iter().copied().max().unwrap_or(1)],
        }
    }

    /// Returns the order of completeness across the section and along `zeta`.
    pub fn lowest(&self) -> [u8; 2] {
        match self {
            Self::Hexahedron(order) | Self::Pentahedron(order) | Self::Tetrahedron(order) => [*order; 2],
            Self::Axodes { section, axial } => {
                [section.lowest_side(), axial.iter().copied().min().unwrap_or(1)]
            }
        }
    }

    /// Returns the indices of the nodes at the corners of the cell, in the order of its linear
    /// interpolation.
    pub fn corners(&self) -> Vec<usize> {
        let places = self.node_coordinates();
        let node = |corner: [f64; 3]| {
            let distance =
                |place: &[f64; 3]| (0..3).map(|axis| (place[axis] - corner[axis]).abs()).sum::<f64>();
            places.iter().position(|place| distance(place) < 1e-9)
        };
        // Every interpolation has nodes at all corners.
        self.cell().interpolation(1).node_coordinates().into_iter().filter_map(node).collect()
    }

    /// Returns the number of nodes.
    pub fn node_count(&self) -> usize {
        let lines = |order: &u8| usize::from(*order) + 1;
        match self {
            Self::Hexahedron(order) => lines(order).pow(3),
            Self::Pentahedron(order) => lines(order) * triangle_count(*order),
            Self::Tetrahedron(order) => (0..=*order).map(triangle_count).sum(),
            Self::Axodes { axial, .. } => axial.iter().map(lines).sum(),
        }
    }

    /// Returns the local coordinates of the nodes.
    pub fn node_coordinates(&self) -> Vec<[f64; 3]> {
        match self {
            Self::Hexahedron(order) => {
                let line = equispaced(*order);
                let across = |z: f64| {
                    line.iter()
                        .flat_map({
                            let line = &line;
                            move |&y| line.iter().map(move |&x| [x, y, z])
                        })
                        .collect::<Vec<_>>()
                };
                line.iter().flat_map(|&z| across(z)).collect()
            }
            Self::Pentahedron(order) => {
                let n = f64::from(*order);
                let layer = |z: f64| {
                    lattice(*order, 2)
                        .into_iter()
                        .map(move |[_, i, j, _]| [f64::from(i) / n, f64::from(j) / n, z])
                };
                equispaced(*order).into_iter().flat_map(layer).collect()
            }
            Self::Tetrahedron(order) => {
                let n = f64::from(*order);
                let place = |[_, i, j, k]: [u8; 4]| [i, j, k].map(|index| f64::from(index) / n);
                lattice(*order, 3).into_iter().map(place).collect()
            }
            Self::Axodes { section, axial } => {
                let axode = |([xi, eta], &order): ([f64; 2], &u8)| {
                    lobatto(order).into_iter().map(move |zeta| [xi, eta, zeta])
                };
                section.node_coordinates().into_iter().zip(axial.iter()).flat_map(axode).collect()
            }
        }
    }

    /// Returns all shape functions at a point, in the numbering of the nodes.
    pub fn shapes(&self, [xi, eta, zeta]: [f64; 3]) -> Vec<SolidShape> {
        match self {
            Self::Hexahedron(order) => {
                let points = equispaced(*order);
                let [x, y, z] = [xi, eta, zeta].map(|at| lagrange_with_slopes(&points, at));
                let mut shapes = Vec::with_capacity(self.node_count());
                for &(h, dh) in &z {
                    for &(g, dg) in &y {
                        shapes
                            .extend(x.iter().map(|&(f, df)| [f * g * h, df * g * h, f * dg * h, f * g * dh]));
                    }
                }
                shapes
            }
            Self::Pentahedron(order) => {
                let section = simplex_shapes(*order, 2, [xi, eta, 0.0]);
                let along = lagrange_with_slopes(&equispaced(*order), zeta);
                let layer = |&(h, dh): &(f64, f64)| {
                    section
                        .iter()
                        .map(move |&[f, dx, dy, _]| [f * h, dx * h, dy * h, f * dh])
                        .collect::<Vec<_>>()
                };
                along.iter().flat_map(layer).collect()
            }
            Self::Tetrahedron(order) => simplex_shapes(*order, 3, [xi, eta, zeta]),
            Self::Axodes { section, axial } => {
                let mut lines = Vec::<(u8, Vec<(f64, f64)>)>::new();
                let mut shapes = Vec::with_capacity(self.node_count());
                for ([f, dx, dy], &order) in section.shapes(xi, eta).into_iter().zip(axial.iter()) {
                    let known = lines.iter().position(|line| line.0 == order).unwrap_or_else(|| {
                        lines.push((order, lagrange_with_slopes(&lobatto(order), zeta)));
                        lines.len() - 1
                    });
                    shapes.extend(lines[known].1.iter().map(|&(h, dh)| [f * h, dx * h, dy * h, f * dh]));
                }
                shapes
            }
        }
    }
}

/// Returns the number of nodes of a triangle.
fn triangle_count(order: u8) -> usize {
    let n = usize::from(order);
    (n + 1) * (n + 2) / 2
}

/// Returns the indices of the nodes of a triangle (`dimension` 2) or tetrahedron (3), whose sum is
/// the order: the one of the first corner, then those of `xi`, `eta`, `zeta`.
fn lattice(order: u8, dimension: usize) -> Vec<[u8; 4]> {
    let mut nodes = Vec::new();
    for k in 0..=if dimension == 3 { order } else { 0 } {
        for j in 0..=order - k {
            nodes.extend((0..=order - k - j).map(|i| [order - k - j - i, i, j, k]));
        }
    }
    nodes
}

/// Returns the shape functions of a simplex: products over its barycentric coordinates `l` of
/// `l (n l - 1) ... / m!`, m the node's index there.
fn simplex_shapes(order: u8, dimension: usize, [x, y, z]: [f64; 3]) -> Vec<SolidShape> {
    let n = f64::from(order);
    let barycentric = [1.0 - x - y - z, x, y, z];
    let factor = |coordinate: f64, index: u8| {
        let (mut value, mut slope) = (1.0, 0.0);
        for step in 0..index {
            let (part, divisor) = (n * coordinate - f64::from(step), f64::from(step) + 1.0);
            slope = (slope * part + value * n) / divisor;
            value *= part / divisor;
        }
        (value, slope)
    };
    let shape = |index: [u8; 4]| {
        let parts: [(f64, f64); 4] = std::array::from_fn(|k| factor(barycentric[k], index[k]));
        let by = |k: usize| {
            (0..4).map(|other| if other == k { parts[other].1 } else { parts[other].0 }).product::<f64>()
        };
        let by_first = by(0);
        let value = parts.iter().map(|part| part.0).product();
        let mut shape = [value, by(1) - by_first, by(2) - by_first, by(3) - by_first];
        if dimension == 2 {
            shape[3] = 0.0;
        }
        shape
    };
    lattice(order, dimension).into_iter().map(shape).collect()
}

impl Cell {
    /// Returns the number of faces.
    pub fn face_count(self) -> usize {
        match self {
            Self::Hexahedron => 6,
            Self::Pentahedron => 5,
            Self::Tetrahedron => 4,
        }
    }

    /// Returns true if a face is a triangle (coordinates a, b >= 0, a + b <= 1), false if it is a
    /// quadrilateral (-1 <= a, b <= 1).
    pub fn is_triangle(self, face: usize) -> bool {
        match self {
            Self::Hexahedron => false,
            Self::Pentahedron => face > 2,
            Self::Tetrahedron => true,
        }
    }

    /// Returns the local coordinates of a point of a face at its coordinates `a` and `b`, and their
    /// derivatives; the cross product of the images of the derivatives points outwards.
    pub fn face_coordinates(self, face: usize, [a, b]: [f64; 2]) -> ([f64; 3], [[f64; 3]; 2]) {
        match (self, face) {
            (Self::Hexahedron, 0..=3) => {
                let [xi, eta] = side_point(face, a);
                let [along_xi, along_eta] = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][face];
                ([xi, eta, b], [[along_xi, along_eta, 0.0], [0.0, 0.0, 1.0]])
            }
            (Self::Hexahedron, 4) => ([b, a, -1.0], [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
            (Self::Hexahedron, _) => ([a, b, 1.0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            (Self::Pentahedron, 0) => ([0.5 * (1.0 + a), 0.0, b], [[0.5, 0.0, 0.0], [0.0, 0.0, 1.0]]),
            (Self::Pentahedron, 1) => {
                ([0.5 * (1.0 - a), 0.5 * (1.0 + a), b], [[-0.5, 0.5, 0.0], [0.0, 0.0, 1.0]])
            }
            (Self::Pentahedron, 2) => ([0.0, 0.5 * (1.0 - a), b], [[0.0, -0.5, 0.0], [0.0, 0.0, 1.0]]),
            (Self::Pentahedron, 3) => ([b, a, -1.0], [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
            (Self::Pentahedron, _) => ([a, b, 1.0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            (Self::Tetrahedron, 0) => ([b, a, 0.0], [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]),
            (Self::Tetrahedron, 1) => ([a, 0.0, b], [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
            (Self::Tetrahedron, 2) => ([0.0, b, a], [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]),
            (Self::Tetrahedron, _) => ([1.0 - a - b, a, b], [[-1.0, 1.0, 0.0], [-1.0, 0.0, 1.0]]),
        }
    }

    /// Returns true if a point lies on a face, to rounding.
    pub fn is_on_face(self, face: usize, [xi, eta, zeta]: [f64; 3]) -> bool {
        let distance = match (self, face) {
            (Self::Hexahedron, 0) => eta + 1.0,
            (Self::Hexahedron, 1) => xi - 1.0,
            (Self::Hexahedron, 2) => eta - 1.0,
            (Self::Hexahedron, 3) => xi + 1.0,
            (Self::Hexahedron, 4) | (Self::Pentahedron, 3) => zeta + 1.0,
            (Self::Hexahedron, _) | (Self::Pentahedron, 4) => zeta - 1.0,
            (Self::Pentahedron, 0) | (Self::Tetrahedron, 1) => eta,
            (Self::Pentahedron, 1) => xi + eta - 1.0,
            (Self::Pentahedron, _) | (Self::Tetrahedron, 2) => xi,
            (Self::Tetrahedron, 0) => zeta,
            (Self::Tetrahedron, _) => xi + eta + zeta - 1.0,
        };
        distance.abs() < 1e-12
    }

    /// Returns the middle of the cell.
    pub fn middle(self) -> [f64; 3] {
        match self {
            Self::Hexahedron => [0.0; 3],
            Self::Pentahedron => [1.0 / 3.0, 1.0 / 3.0, 0.0],
            Self::Tetrahedron => [0.25; 3],
        }
    }

    /// Returns points and weights of a quadrature with a number of points across the section and
    /// along `zeta`: exact to degree `2 * points - 1` in each coordinate of a hexahedron, to total
    /// degree `2 * points - 2` in triangles, `2 * points - 3` in tetrahedra (where `across`
    /// counts).
    pub fn quadrature(self, [across, along]: [usize; 2]) -> Vec<([f64; 3], f64)> {
        let section = gauss_legendre(across);
        let on_unit = section.iter().map(|(x, weight)| (0.5 * (1.0 + x), 0.5 * weight)).collect::<Vec<_>>();
        let axis = gauss_legendre(along);
        let mut rule = Vec::new();
        match self {
            Self::Hexahedron => {
                for &(zeta, c) in &axis {
                    for &(eta, b) in &section {
                        rule.extend(section.iter().map(|&(xi, a)| ([xi, eta, zeta], a * b * c)));
                    }
                }
            }
            // Squares and cubes are collapsed onto the triangle and the tetrahedron.
            Self::Pentahedron => {
                for &(zeta, c) in &axis {
                    for &(v, b) in &on_unit {
                        let height = 1.0 - v;
                        rule.extend(
                            on_unit.iter().map(|&(u, a)| ([u * height, v, zeta], a * b * c * height)),
                        );
                    }
                }
            }
            Self::Tetrahedron => {
                for &(w, c) in &on_unit {
                    let top = 1.0 - w;
                    for &(v, b) in &on_unit {
                        let height = top * (1.0 - v);
                        let weight = b * c * top * height;
                        rule.extend(on_unit.iter().map(|&(u, a)| ([u * height, v * top, w], a * weight)));
                    }
                }
            }
        }
        rule
    }

    /// Returns coordinates and weights on a face with a number of points across.
    pub fn face_quadrature(self, face: usize, points: usize) -> Vec<([f64; 2], f64)> {
        let line = gauss_legendre(points);
        let mut rule = Vec::with_capacity(points * points);
        for &(y, b) in &line {
            for &(x, a) in &line {
                rule.push(if self.is_triangle(face) {
                    let (v, height) = (0.5 * (1.0 + y), 0.5 * (1.0 - y));
                    ([0.5 * (1.0 + x) * height, v], 0.25 * a * b * height)
                } else {
                    ([x, y], a * b)
                });
            }
        }
        rule
    }
}
