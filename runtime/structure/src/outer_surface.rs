//! Outer surfaces of bodies, for display: triangles, and the edges of the finite elements.

use crate::mesh_cells::{Outline, cells};
use calyx_fe::solid::{FaceSet, SolidMesh};
use calyx_numerics::vec3::{cross, dot};
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::f64::consts::TAU;

/// Number of sections of a whole surface of revolution.
const SECTIONS: usize = 96;

/// Outer surface of a body in its own coordinates. A gear has one sector, which is repeated about
/// the z axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OuterSurface {
    /// Number of copies of the surface about the z axis, counter-clockwise.
    pub copies: u32,
    /// Points, m.
    pub points: Vec<[f64; 3]>,
    /// Triangles, counter-clockwise seen from outside, as indices of points.
    pub triangles: Vec<[u32; 3]>,
    /// Edges of the elements or of the body, as indices of points.
    pub edges: Vec<[u32; 2]>,
    /// True if the surface contains shells, whose both sides are visible: it encloses no volume.
    pub open: bool,
    /// Number of triangles at the end of the list that belong to no finite-element mesh of the body,
    /// such as those of a web. Their points and edges are at the end of the other lists.
    pub without_mesh: usize,
}

/// Shape of a cell. The corners of solids are in VTK order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellKind {
    /// Hexahedron.
    Hexahedron,
    /// Wedge.
    Wedge,
    /// Tetrahedron.
    Tetrahedron,
    /// Triangle or quadrilateral, of a shell or a plane mesh.
    Face,
    /// Beam or rod.
    Line,
}

/// Cell of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Cell<'a> {
    /// Shape.
    pub kind: CellKind,
    /// Corners, as indices of points.
    pub corners: &'a [usize],
    /// Index of the finite element to which the cell belongs.
    pub element: usize,
}

/// Face of a cell that no other cell shares.
#[derive(Clone, Debug, PartialEq)]
pub struct OuterFace {
    /// Three or four corners, counter-clockwise seen from outside, as indices of points.
    pub corners: Vec<usize>,
    /// Element, and side of it: cells of one side of one element form one face of that element.
    side: (usize, usize),
}

/// Part of a mesh that is visible from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Points of the surface, as indices of points of the mesh, ascending.
    pub nodes: Vec<usize>,
    /// Triangles, counter-clockwise seen from outside, as indices of `nodes`.
    pub triangles: Vec<[u32; 3]>,
    /// Edges of elements and beams, as indices of `nodes`.
    pub edges: Vec<[u32; 2]>,
    /// True if the mesh contains shells.
    pub open: bool,
}

impl CellKind {
    /// Returns the faces, outward, as indices of corners.
    fn faces(self) -> &'static [&'static [usize]] {
        match self {
            CellKind::Hexahedron => {
                &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
            }
            CellKind::Wedge => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
            CellKind::Tetrahedron => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
            CellKind::Face | CellKind::Line => &[],
        }
    }
}

/// Returns the faces that belong to one cell only, and all cells that are faces.
pub fn outer_faces<'a>(cells: impl Iterator<Item = Cell<'a>> + Clone) -> Vec<OuterFace> {
    let solids = || cells.clone().flat_map(|cell| cell.kind.faces().iter().map(move |face| (cell, *face)));
    let key = |cell: Cell<'_>, face: &[usize]| {
        // A triangle has its last corner twice.
        let mut key: [usize; 4] = std::array::from_fn(|k| cell.corners[face[k.min(face.len() - 1)]]);
        key.sort_unstable();
        key
    };
    let mut counts: HashMap<[usize; 4], u32> = HashMap::new();
    for (cell, face) in solids() {
        *counts.entry(key(cell, face)).or_default() += 1;
    }
    let mut faces = Vec::new();
    for cell in cells.clone() {
        for (side, face) in cell.kind.faces().iter().enumerate() {
            if counts[&key(cell, face)] == 1 {
                let corners = face.iter().map(|&corner| cell.corners[corner]).collect();
                faces.push(OuterFace { corners, side: (cell.element, side) });
            }
        }
        if cell.kind == CellKind::Face {
            faces.push(OuterFace { corners: cell.corners.to_vec(), side: (cell.element, 0) });
        }
    }
    faces
}

impl Skin {
    /// Returns the outer surface of a mesh, without the faces whose corners satisfy `left_out`.
    pub fn new<'a>(
        cells: impl Iterator<Item = Cell<'a>> + Clone,
        left_out: impl Fn(&[usize]) -> bool,
    ) -> Skin {
        let mut faces = outer_faces(cells.clone());
        faces.retain(|face| !left_out(&face.corners));
        let open = cells.clone().any(|cell| cell.kind == CellKind::Face);
        let beams = cells.filter(|cell| cell.kind == CellKind::Line);
        let beams: Vec<[usize; 2]> =
            beams.map(|cell| [cell.corners[0], cell.corners[cell.corners.len() - 1]]).collect();
        let all = faces.iter().flat_map(|face| face.corners.iter()).chain(beams.iter().flatten());
        let mut nodes: Vec<usize> = all.copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let place = |node: usize| nodes.partition_point(|&other| other < node) as u32;
        let triangles = faces.iter().flat_map(|face| {
            let corners = face.corners.iter().map(|&node| place(node)).collect::<Vec<_>>();
            (2..corners.len()).map(move |k| [corners[0], corners[k - 1], corners[k]])
        });
        let triangles = triangles.collect();
        let edges = element_edges(&faces).into_iter().chain(beams).map(|edge| edge.map(place)).collect();
        Skin { nodes, triangles, edges, open }
    }

    /// Returns the surface at the points of the mesh, m.
    pub fn at(self, points: &[[f64; 3]]) -> OuterSurface {
        let points = self.nodes.iter().map(|&node| points[node]).collect();
        OuterSurface {
            copies: 1,
            points,
            triangles: self.triangles,
            edges: self.edges,
            open: self.open,
            without_mesh: 0,
        }
    }
}

/// Returns the edges between faces of different elements, or different sides of an element, and at
/// the boundary of the surface.
fn element_edges(faces: &[OuterFace]) -> Vec<[usize; 2]> {
    let mut sides: BTreeMap<[usize; 2], Option<(usize, usize)>> = BTreeMap::new();
    let mut inner = BTreeSet::new();
    for face in faces {
        for (k, &start) in face.corners.iter().enumerate() {
            let end = face.corners[(k + 1) % face.corners.len()];
            let edge = [start.min(end), start.max(end)];
            let known = sides.entry(edge).or_default();
            if *known == Some(face.side) {
                inner.insert(edge);
            }
            *known = Some(face.side);
        }
    }
    sides.into_keys().filter(|edge| !inner.contains(edge)).collect()
}

impl OuterSurface {
    /// Returns the surface of a sector of a gear, without its faces on two cuts, with this number
    /// of copies. Sets that the mesh does not contain are ignored.
    pub fn of_sector(mesh: &SolidMesh, cuts: [&str; 2], copies: u32) -> OuterSurface {
        let mut kinds = BTreeMap::new();
        for element in &mesh.elements {
            kinds
                .entry(&element.interpolation)
                .or_insert_with(|| cells(&element.interpolation.node_coordinates()));
        }
        let present = mesh.elements.iter().enumerate().filter(|(index, _)| !mesh.absent.contains(index));
        let elements =
            present.map(|(_, element)| (&element.nodes[..], &kinds[&element.interpolation][0][..]));
        let outline = Outline::new(elements);
        let on_cut = |set: &FaceSet| {
            let nodes: BTreeSet<usize> = mesh.nodes_on(set).into_iter().collect();
            outline.nodes.iter().map(|node| nodes.contains(node)).collect::<Vec<bool>>()
        };
        let cuts: Vec<Vec<bool>> = cuts.iter().filter_map(|cut| mesh.face_set(cut)).map(on_cut).collect();
        let cells = outline.cells.iter().zip(&outline.elements).map(|(corners, &element)| Cell {
            kind: CellKind::Hexahedron,
            corners,
            element,
        });
        let skin = Skin::new(cells, |corners| {
            cuts.iter().any(|on_cut| corners.iter().all(|&corner| on_cut[corner]))
        });
        let points: Vec<[f64; 3]> = outline.nodes.iter().map(|&node| mesh.nodes[node]).collect();
        OuterSurface { copies: copies.max(1), ..skin.at(&points) }
    }

    /// Returns the surface of revolution about the z axis of a closed polygon of positions z and
    /// radii (m), in either orientation.
    pub fn revolved(polygon: &[[f64; 2]]) -> OuterSurface {
        OuterSurface::revolved_in(polygon, SECTIONS)
    }

    /// Returns such a surface with this number of sections around the axis.
    pub fn revolved_in(polygon: &[[f64; 2]], sections: usize) -> OuterSurface {
        revolved(polygon, (1, sections), 0.0)
    }

    /// Returns a sector of a surface of revolution, from the angle `start` (rad), with this number
    /// of copies.
    pub fn revolved_sector(polygon: &[[f64; 2]], copies: u32, start: f64) -> OuterSurface {
        let copies = copies.max(1);
        revolved(polygon, (copies, SECTIONS.div_ceil(copies as usize).max(2)), start)
    }

    /// Returns the volume that all copies together enclose, m³.
    pub fn volume(&self) -> f64 {
        let tetrahedron = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| self.points[corner as usize]);
            dot(a, cross(b, c)) / 6.0
        };
        f64::from(self.copies) * self.triangles.iter().map(tetrahedron).sum::<f64>()
    }

    /// Adds another surface with the same number of copies.
    pub fn add(&mut self, other: OuterSurface) {
        let first = self.points.len() as u32;
        self.points.extend(other.points);
        self.triangles.extend(other.triangles.into_iter().map(|corners| corners.map(|k| first + k)));
        self.edges.extend(other.edges.into_iter().map(|ends| ends.map(|k| first + k)));
        self.open |= other.open;
    }

    /// Adds a surface that belongs to no finite-element mesh of the body.
    pub fn add_without_mesh(&mut self, other: OuterSurface) {
        self.without_mesh += other.triangles.len();
        self.add(other);
    }
}

/// Returns a surface of revolution from the angle `start` (rad), with this number of copies and of
/// sections.
fn revolved(polygon: &[[f64; 2]], (copies, sections): (u32, usize), start: f64) -> OuterSurface {
    let whole = copies == 1;
    let rings = if whole { sections } else { sections + 1 };
    let step = TAU / f64::from(copies) / sections as f64;
    let point = |ring: usize, [z, radius]: [f64; 2]| {
        let (sine, cosine) = (start + step * ring as f64).sin_cos();
        [radius * cosine, radius * sine, z]
    };
    let points = (0..rings).flat_map(|ring| polygon.iter().map(move |&at| point(ring, at))).collect();
    let count = polygon.len();
    let next = |k: usize| (k + 1) % count;
    let area: f64 =
        (0..count).map(|k| polygon[k][0] * polygon[next(k)][1] - polygon[next(k)][0] * polygon[k][1]).sum();
    let index = |ring: usize, k: usize| (ring % rings * count + k) as u32;
    let (mut triangles, mut edges) = (Vec::new(), Vec::new());
    for ring in 0..sections {
        for k in 0..count {
            let [a, b] = [index(ring, k), index(ring, next(k))];
            let [c, d] = [index(ring + 1, next(k)), index(ring + 1, k)];
            // Points on the axis make no area.
            let both = [([a, b, c], polygon[next(k)][1]), ([a, c, d], polygon[k][1])];
            let own = both.into_iter().filter(|(_, radius)| *radius > 0.0).map(|(corners, _)| corners);
            triangles.extend(own.map(|[i, j, k]| if area > 0.0 { [i, j, k] } else { [i, k, j] }));
            if polygon[k][1] > 0.0 {
                edges.push([a, d]);
            }
        }
    }
    OuterSurface { copies, points, triangles, edges, open: false, without_mesh: 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume of a polygon of 96 corners is that of the circle less 0.07 %.
    #[test]
    fn surfaces_of_revolution_enclose_their_volume() {
        let tube = [[0.0, 1.0], [3.0, 1.0], [3.0, 2.0], [0.0, 2.0]];
        let circle = SECTIONS as f64 / TAU * (TAU / SECTIONS as f64).sin();
        let exact = 0.5 * TAU * 3.0 * 3.0;
        for polygon in [tube, [tube[3], tube[2], tube[1], tube[0]]] {
            assert!((OuterSurface::revolved(&polygon).volume() - circle * exact).abs() < 1e-9 * exact);
        }
        // A solid cylinder has its polygon on the axis.
        let solid = OuterSurface::revolved(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]]);
        assert!((solid.volume() - circle * TAU).abs() < 1e-9);
        // The sides of a sector on the cuts are open; its copies are closed.
        let sector = OuterSurface::revolved_sector(&tube, 12, 0.3);
        assert!((sector.volume() - circle * exact).abs() < 1e-9 * exact);
    }

    /// Faces of all shapes are outward: the volumes are positive.
    #[test]
    fn faces_are_outward() {
        let prism = |base: &[[f64; 2]]| -> Vec<[f64; 3]> {
            [0.0, 1.0].iter().flat_map(|&z| base.iter().map(move |&[x, y]| [x, y, z])).collect()
        };
        let square = prism(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let triangle = prism(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        let tetrahedron = triangle[..4].to_vec();
        for (kind, points, expected) in [
            (CellKind::Hexahedron, square, 1.0),
            (CellKind::Wedge, triangle, 0.5),
            (CellKind::Tetrahedron, tetrahedron, 1.0 / 6.0),
        ] {
            let corners: Vec<usize> = (0..points.len()).collect();
            let cell = Cell { kind, corners: &corners, element: 0 };
            let surface = Skin::new(std::iter::once(cell), |_| false).at(&points);
            assert!((surface.volume() - expected).abs() < 1e-15, "{kind:?}");
        }
    }

    /// Two hexahedra of one element have neither a face nor an edge between them.
    #[test]
    fn edges_are_those_of_elements() {
        let at = |i: usize, j: usize, k: usize| i + 3 * j + 6 * k;
        let cell = |i: usize| -> Vec<usize> {
            [0, 1]
                .iter()
                .flat_map(|&k| [at(i, 0, k), at(i + 1, 0, k), at(i + 1, 1, k), at(i, 1, k)])
                .collect()
        };
        let both = [cell(0), cell(1)];
        let points: Vec<[f64; 3]> =
            (0..12).map(|node| [(node % 3) as f64, (node / 3 % 2) as f64, (node / 6) as f64]).collect();
        for (elements, edges) in [([0, 0], 16), ([0, 1], 20)] {
            let cells = both.iter().zip(elements).map(|(corners, element)| Cell {
                kind: CellKind::Hexahedron,
                corners,
                element,
            });
            let skin = Skin::new(cells.clone(), |_| false);
            assert_eq!((skin.nodes.len(), skin.triangles.len(), skin.edges.len()), (12, 20, edges));
            assert!((skin.at(&points).volume() - 2.0).abs() < 1e-12);
            let open = Skin::new(cells, |corners| corners.iter().all(|node| node % 3 == 0));
            assert_eq!((open.triangles.len(), open.edges.len()), (18, edges));
        }
    }
}
