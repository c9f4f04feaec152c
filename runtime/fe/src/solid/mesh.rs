//! Solid meshes: separate displacement nodes and coordinate nodes, elements of any type, and named
//! sets of faces.

use super::interpolation::{Cell, Interpolation, SolidShape};
use super::swept::{FaceChart, Swept};
use calyx_numerics::vec3::{cross, dot, length};
use std::collections::{BTreeMap, BTreeSet};

/// Three-dimensional mesh. Elements share the nodes of shared faces, both displacement and
/// coordinate nodes.
///
/// Degrees of freedom are `3 * node + axis` of the displacement nodes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SolidMesh {
    /// Displacement nodes at the positions of the coordinate interpolation, m.
    pub nodes: Vec<[f64; 3]>,
    /// Coordinate nodes, m.
    pub coordinate_nodes: Vec<[f64; 3]>,
    /// Elements in no particular order, unless [`SolidMesh::swept`] is set.
    pub elements: Vec<SolidElement>,
    /// Named sets of element faces: `"bore"`, `"cut_left"`, `"flank_0"`, `"face_start"`.
    pub faces: BTreeMap<String, FaceSet>,
    /// Named sets of displacement nodes.
    pub node_sets: BTreeMap<String, Vec<usize>>,
    /// Origin from a plane section, if the mesh was swept.
    pub swept: Option<Swept>,
    /// Elements without material, where the section does not exist at every axial coordinate, such
    /// as a web thinner than its rim. The set [`ABSENT`] contains the nodes that belong to no other
    /// elements.
    pub absent: BTreeSet<usize>,
}

/// Set of the nodes that belong to absent elements only: they have no stiffness and must be fixed.
pub const ABSENT: &str = "absent";

/// Element. If the coordinates are of no higher order than the displacements, it represents
/// rigid-body motions exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidElement {
    /// Interpolation of the displacements.
    pub interpolation: Interpolation,
    /// Indices into [`SolidMesh::nodes`], in the numbering of the interpolation.
    pub nodes: Vec<usize>,
    /// Interpolation of the coordinates, over the same cell.
    pub coordinate_interpolation: Interpolation,
    /// Indices into [`SolidMesh::coordinate_nodes`].
    pub coordinates: Vec<usize>,
}

/// Point in an element, by its local coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidElementPoint {
    /// Index in [`SolidMesh::elements`].
    pub element: usize,
    /// Local coordinates `xi`, `eta`, `zeta`, see [`Cell`].
    pub local: [f64; 3],
}

/// Face of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ElementFace {
    /// Index in [`SolidMesh::elements`].
    pub element: usize,
    /// Index of the face, see [`Cell`].
    pub face: usize,
}

/// Set of element faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceSet {
    /// Faces in order along the chart, if there is one.
    pub faces: Vec<ElementFace>,
    /// Coordinates on the surface, for sets swept from a chain of the section.
    pub chart: Option<FaceChart>,
}

/// Point of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePoint {
    /// Element and local coordinates.
    pub place: SolidElementPoint,
    /// Position, m.
    pub position: [f64; 3],
    /// Orthonormal tangents: along the first coordinate (on charts, increasing arc length), and
    /// normal to it on the side of increasing second coordinate (on charts, the axial one).
    pub tangents: [[f64; 3]; 2],
    /// Unit normal, out of the element.
    pub normal: [f64; 3],
    /// Area of the surface per unit of both coordinates: on charts, of arc length times axial
    /// coordinate (dimensionless).
    pub area: f64,
}

/// Position and derivatives by the local coordinates: `jacobian[axis][local]`.
pub(super) struct Mapped {
    pub position: [f64; 3],
    pub jacobian: [[f64; 3]; 3],
}

impl SolidMesh {
    /// Returns the mesh without the elements whose index satisfies `absent`.
    #[must_use]
    pub fn without(mut self, absent: impl Fn(usize) -> bool) -> Self {
        self.absent = (0..self.elements.len()).filter(|&element| absent(element)).collect();
        let mut constrained_by_none = vec![true; self.nodes.len()];
        for (index, element) in self.elements.iter().enumerate() {
            if !self.absent.contains(&index) {
                element.nodes.iter().for_each(|&node| constrained_by_none[node] = false);
            }
        }
        let nodes = (0..self.nodes.len()).filter(|&node| constrained_by_none[node]).collect();
        self.node_sets.insert(ABSENT.to_owned(), nodes);
        self
    }

    /// Returns the number of displacement unknowns, three for each node.
    pub fn dof_count(&self) -> usize {
        3 * self.nodes.len()
    }

    /// Returns an upper bound of the memory of a stiffness, bytes: as if no two elements shared a
    /// node.
    pub fn stiffness_memory(&self) -> u64 {
        let entries = |element: &SolidElement| (3 * element.nodes.len() as u64).pow(2);
        let all: u64 = self.elements.iter().map(entries).sum();
        // Values and row indices.
        all * (size_of::<f64>() + size_of::<usize>()) as u64
    }

    /// Returns coordinates of the displacement nodes for the order of elimination
    /// ([`crate::dissection::Dissection`]): those in which cuts at a constant coordinate follow the
    /// faces of elements. For a swept mesh they are radius (m) and angle (rad) in the section and
    /// the number of layers, also where sections are rotated, scaled or inclined along the face;
    /// otherwise they are the positions, m.
    pub fn ordering_coordinates(&self) -> Vec<[f64; 3]> {
        match &self.swept {
            Some(swept) => swept.polar_coordinates(),
            None => self.nodes.clone(),
        }
    }

    /// Returns the set of faces of that name, if any.
    pub fn face_set(&self, name: &str) -> Option<&FaceSet> {
        self.faces.get(name)
    }

    /// Returns the displacement nodes on a set of faces, each once. On a chart they follow the
    /// chain, at each of its nodes with increasing axial coordinate ([`Swept::axodes_on`] returns
    /// them axode by axode). Chains measured on the mesh run counter-clockwise around the section,
    /// so those of its two cuts have opposite directions. Nodes of other sets are ascending.
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

    /// Returns the position of a point, m.
    pub fn position(&self, place: SolidElementPoint) -> [f64; 3] {
        self.map(place).position
    }

    /// Returns `jacobian[axis][local]`: derivatives of the position by the local coordinates at a
    /// point, m.
    pub fn jacobian(&self, place: SolidElementPoint) -> [[f64; 3]; 3] {
        self.map(place).jacobian
    }

    fn map(&self, place: SolidElementPoint) -> Mapped {
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

    /// Returns `jacobian[axis][local]` from evaluated coordinate shape functions.
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

    /// Returns the point of a face at its coordinates (see [`Cell::face_coordinates`]).
    pub fn face_point(&self, face: ElementFace, at: [f64; 2]) -> FacePoint {
        let cell = self.elements[face.element].interpolation.cell();
        let (local, directions) = cell.face_coordinates(face.face, at);
        let place = SolidElementPoint { element: face.element, local };
        let Mapped { position, jacobian } = self.map(place);
        let along = directions.map(|direction| [0, 1, 2].map(|axis| dot(jacobian[axis], direction)));
        FacePoint::new(place, position, along)
    }

    /// Returns the bounding box of all coordinate nodes: least and greatest x, y and z, m.
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

    /// Finds the first folded or inverted element, with a position in it, m: its Jacobian
    /// determinant is not positive at a node or in the middle. `None` if all are valid.
    pub fn folded(&self) -> Option<(usize, [f64; 3])> {
        let mut tables = BTreeMap::new();
        for (index, element) in self.elements.iter().enumerate() {
            let kind = &element.coordinate_interpolation;
            let table = tables.entry(kind).or_insert_with(|| {
                let mut places = kind.node_coordinates();
                places.push(kind.cell().middle());
                places.into_iter().map(|place| (place, kind.shapes(place))).collect::<Vec<_>>()
            });
            for (local, shapes) in table {
                // The comparison is negated so that NaN counts as folded.
                let sound = determinant(self.jacobian_of(element, shapes)) > 0.0;
                if !sound {
                    return Some((index, self.position(SolidElementPoint { element: index, local: *local })));
                }
            }
        }
        None
    }
}

impl Interpolation {
    /// Returns the indices of the nodes on a face, ascending.
    pub fn face_nodes(&self, face: usize) -> Vec<usize> {
        let cell: Cell = self.cell();
        let places = self.node_coordinates().into_iter().enumerate();
        places.filter(|(_, place)| cell.is_on_face(face, *place)).map(|(node, _)| node).collect()
    }
}

impl FacePoint {
    /// Builds a face point from the derivatives of the position by the two coordinates, whose cross
    /// product points outwards.
    pub(super) fn new(place: SolidElementPoint, position: [f64; 3], along: [[f64; 3]; 2]) -> Self {
        let outward = cross(along[0], along[1]);
        let area = length(outward);
        let normal = outward.map(|part| part / area);
        let speed = length(along[0]);
        let first = along[0].map(|part| part / speed);
        Self { place, position, tangents: [first, cross(normal, first)], normal, area }
    }
}

pub(super) fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    dot(a, cross(b, c))
}
