//! Solid meshes: displacement nodes and coordinate nodes of their own, elements of any kind, and named sets of faces.

use super::interpolation::{Cell, Interpolation, SolidShape};
use super::sweep::{FaceChart, Swept};
use std::collections::{BTreeMap, BTreeSet};

/// A mesh in space. Elements share the nodes of shared faces, both displacement and coordinate nodes.
///
/// Degrees of freedom are `3 * node + axis` of the displacement nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidMesh {
    /// Displacement nodes, where the coordinate interpolation puts them, m.
    pub nodes: Vec<[f64; 3]>,
    /// Coordinate nodes, m.
    pub coordinate_nodes: Vec<[f64; 3]>,
    /// In no particular order, unless [`SolidMesh::swept`] is there.
    pub elements: Vec<SolidElement>,
    /// Named sets of element faces: `"bore"`, `"cut_left"`, `"flank_0"`, `"face_start"`.
    pub faces: BTreeMap<String, FaceSet>,
    /// Named sets of displacement nodes.
    pub node_sets: BTreeMap<String, Vec<usize>>,
    /// How it came from a plane section, if it did.
    pub swept: Option<Swept>,
    /// Elements without material: of a section that is not there at every axial coordinate, as a web thinner than its rim. Nodes that
    /// only they have are the set [`ABSENT`].
    pub absent: BTreeSet<usize>,
}

/// Set of the nodes that only absent elements have: nothing holds them, so they are to be held.
pub const ABSENT: &str = "absent";

/// An element. Where the coordinates are of no higher order than the displacements, it has the rigid-body motions exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidElement {
    /// Of displacements.
    pub interpolation: Interpolation,
    /// Into [`SolidMesh::nodes`], in the numbering of the interpolation.
    pub nodes: Vec<usize>,
    /// Of the coordinates, over the same cell.
    pub coordinate_interpolation: Interpolation,
    /// Into [`SolidMesh::coordinate_nodes`].
    pub coordinates: Vec<usize>,
}

/// A place in an element, by its local coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidPlace {
    /// Index in [`SolidMesh::elements`].
    pub element: usize,
    /// `xi`, `eta`, `zeta`, see [`Cell`].
    pub local: [f64; 3],
}

/// A face of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ElementFace {
    /// Index in [`SolidMesh::elements`].
    pub element: usize,
    /// See [`Cell`].
    pub face: usize,
}

/// Faces of elements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceSet {
    /// In order along the chart, if there is one.
    pub faces: Vec<ElementFace>,
    /// Coordinates on the surface they make: of sets swept from a chain of the section.
    pub chart: Option<FaceChart>,
}

/// A point of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePoint {
    /// Where in which element.
    pub place: SolidPlace,
    /// m
    pub position: [f64; 3],
    /// Orthonormal, in the tangent plane: along the first coordinate (on charts, growing arc length), and across it on the side to
    /// which the second coordinate (on charts, the axial one) grows.
    pub tangents: [[f64; 3]; 2],
    /// Unit normal, out of the element.
    pub normal: [f64; 3],
    /// Area of the surface per unit of both coordinates: on charts, of arc length times axial coordinate (no unit).
    pub area: f64,
}

/// Position and derivatives by the local coordinates: `jacobian[axis][local]`.
pub(super) struct Mapped {
    pub position: [f64; 3],
    pub jacobian: [[f64; 3]; 3],
}

impl SolidMesh {
    /// The mesh with the elements taken out that `absent` names by their index.
    #[must_use]
    pub fn without(mut self, absent: impl Fn(usize) -> bool) -> Self {
        self.absent = (0..self.elements.len()).filter(|&element| absent(element)).collect();
        let mut held_by_none = vec![true; self.nodes.len()];
        for (index, element) in self.elements.iter().enumerate() {
            if !self.absent.contains(&index) {
                element.nodes.iter().for_each(|&node| held_by_none[node] = false);
            }
        }
        let nodes = (0..self.nodes.len()).filter(|&node| held_by_none[node]).collect();
        self.node_sets.insert(ABSENT.to_owned(), nodes);
        self
    }

    /// Number of displacement unknowns, three a node.
    pub fn dof_count(&self) -> usize {
        3 * self.nodes.len()
    }

    /// Memory that a stiffness takes at most, bytes: as if no two elements shared a node.
    pub fn stiffness_memory(&self) -> u64 {
        let entries = |element: &SolidElement| (3 * element.nodes.len() as u64).pow(2);
        let all: u64 = self.elements.iter().map(entries).sum();
        // Values and where they are.
        all * (size_of::<f64>() + size_of::<usize>()) as u64
    }

    /// The set of faces of that name, if there is one.
    pub fn face_set(&self, name: &str) -> Option<&FaceSet> {
        self.faces.get(name)
    }

    /// Displacement nodes on a set of faces, each once. On a chart: along the chain, at each of its nodes with growing axial
    /// coordinate ([`Swept::axodes_on`] has them axode by axode; chains measured on the mesh run counter-clockwise around the section, so
    /// those of its two cuts run against each other); of other sets, ascending.
    pub fn nodes_on(&self, set: &FaceSet) -> Vec<usize> {
        if let (Some(chart), Some(swept)) = (&set.chart, &self.swept) {
            return swept.axodes_on(chart).into_iter().flatten().collect();
        }
        let mut nodes = BTreeSet::new();
        for face in &set.faces {
            let element = &self.elements[face.element];
            let locals = element.interpolation.face_nodes(face.face);
            nodes.extend(locals.into_iter().map(|local| element.nodes[local]));
        }
        nodes.into_iter().collect()
    }

    /// Position of a place, m.
    pub fn position(&self, place: SolidPlace) -> [f64; 3] {
        self.map(place).position
    }

    /// `jacobian[axis][local]`: derivatives of the position by the local coordinates at a place, m.
    pub fn jacobian(&self, place: SolidPlace) -> [[f64; 3]; 3] {
        self.map(place).jacobian
    }

    fn map(&self, place: SolidPlace) -> Mapped {
        let element = &self.elements[place.element];
        let shapes = element.coordinate_interpolation.shapes(place.local);
        let mut position = [0.0; 3];
        for (shape, &node) in shapes.iter().zip(&element.coordinates) {
            for axis in 0..3 {
                position[axis] += shape[0] * self.coordinate_nodes[node][axis];
            }
        }
        Mapped { position, jacobian: self.jacobian_of(element, &shapes) }
    }

    /// `jacobian[axis][local]` from coordinate shape functions already evaluated.
    pub(super) fn jacobian_of(&self, element: &SolidElement, shapes: &[SolidShape]) -> [[f64; 3]; 3] {
        let mut jacobian = [[0.0; 3]; 3];
        for (shape, &node) in shapes.iter().zip(&element.coordinates) {
            let point = self.coordinate_nodes[node];
            for axis in 0..3 {
                for local in 0..3 {
                    jacobian[axis][local] += shape[1 + local] * point[axis];
                }
            }
        }
        jacobian
    }

    /// The point of a face at its coordinates (see [`Cell::face_place`]).
    pub fn face_point(&self, face: ElementFace, at: [f64; 2]) -> FacePoint {
        let cell = self.elements[face.element].interpolation.cell();
        let (local, directions) = cell.face_place(face.face, at);
        let place = SolidPlace { element: face.element, local };
        let Mapped { position, jacobian } = self.map(place);
        let along = directions.map(|direction| [0, 1, 2].map(|axis| dot(jacobian[axis], direction)));
        FacePoint::new(place, position, along)
    }

    /// The box around all coordinate nodes: least and greatest x, y and z, m.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for point in &self.coordinate_nodes {
            for axis in 0..3 {
                bounds[0][axis] = bounds[0][axis].min(point[axis]);
                bounds[1][axis] = bounds[1][axis].max(point[axis]);
            }
        }
        bounds
    }

    /// The first element that is folded or turned over, with a position there, m: its Jacobian is not positive at a node or in
    /// the middle. `None` if all are sound.
    pub fn folded(&self) -> Option<(usize, [f64; 3])> {
        let mut tables = BTreeMap::new();
        for (index, element) in self.elements.iter().enumerate() {
            let kind = &element.coordinate_interpolation;
            let table = tables.entry(kind).or_insert_with(|| {
                let mut places = kind.node_places();
                places.push(kind.cell().middle());
                places.into_iter().map(|place| (place, kind.shapes(place))).collect::<Vec<_>>()
            });
            for (local, shapes) in table {
                // Negated, so that what is not a number counts as folded.
                let sound = determinant(self.jacobian_of(element, shapes)) > 0.0;
                if !sound {
                    return Some((index, self.position(SolidPlace { element: index, local: *local })));
                }
            }
        }
        None
    }
}

impl Interpolation {
    /// Numbers of the nodes on a face, ascending.
    pub fn face_nodes(&self, face: usize) -> Vec<usize> {
        let cell: Cell = self.cell();
        let places = self.node_places().into_iter().enumerate();
        places.filter(|(_, place)| cell.is_on_face(face, *place)).map(|(node, _)| node).collect()
    }
}

impl FacePoint {
    /// From the derivatives of the position by the two coordinates, whose cross product points out.
    pub(super) fn new(place: SolidPlace, position: [f64; 3], along: [[f64; 3]; 2]) -> Self {
        let outward = cross(along[0], along[1]);
        let area = norm(outward);
        let normal = outward.map(|part| part / area);
        let speed = norm(along[0]);
        let first = along[0].map(|part| part / speed);
        Self { place, position, tangents: [first, cross(normal, first)], normal, area }
    }
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

pub(super) fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    dot(a, cross(b, c))
}
