//! Skin of a solid finite-element mesh, with lids over its openings.

use crate::error::AcousticError;
use crate::mesh::{Face, SurfaceMesh};
use crate::openings::{edges, sorted};
use crate::plane::RigidPlane;
use calyx_numerics::vec3::{Vector, cross, dot, minus, plus, scaled};
use faer::c64;
use std::collections::{BTreeMap, HashMap, HashSet};

/// Solid element: indices of its corner nodes. The corners of the first face are followed by those
/// of the second face in the same sense, as in NASTRAN; midside nodes are omitted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    /// Tetrahedron.
    Tetrahedron([usize; 4]),
    /// Wedge.
    Wedge([usize; 6]),
    /// Hexahedron.
    Hexahedron([usize; 8]),
}

impl Solid {
    /// Returns the faces with normals out of an element of positive volume.
    fn faces(&self) -> Vec<Face> {
        let triangle = |n: &[usize], [a, b, c]: [usize; 3]| Face::Triangle([n[a], n[b], n[c]]);
        let quadrilateral =
            |n: &[usize], [a, b, c, d]: [usize; 4]| Face::Quadrilateral([n[a], n[b], n[c], n[d]]);
        match self {
            Self::Tetrahedron(n) => {
                [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|corners| triangle(n, corners)).to_vec()
            }
            Self::Wedge(n) => {
                let mut faces = [[0, 2, 1], [3, 4, 5]].map(|corners| triangle(n, corners)).to_vec();
                faces.extend([[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]].map(|c| quadrilateral(n, c)));
                faces
            }
            Self::Hexahedron(n) => {
                [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
                    .map(|corners| quadrilateral(n, corners))
                    .to_vec()
            }
        }
    }
}

/// Outer skin of a solid mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Skin {
    /// Surface mesh.
    pub mesh: SurfaceMesh,
    /// Nodes of the solid mesh whose mean motion each vertex has: one node, or all of the rim for
    /// the centre of a lid.
    pub nodes: Vec<Vec<usize>>,
}

impl Skin {
    /// Extracts the skin of solid elements. Closed cavities are omitted.
    ///
    /// Each lid closes an opening: it is a loop of nodes along edges of the skin. The skin is cut
    /// along the loops, and the part that reaches furthest is kept and closed by triangles from
    /// each loop to its centre. A lid moves with its rim. Loops on other parts, such as the inner
    /// end of a bore, close nothing.
    ///
    /// # Errors
    /// An element has a node that does not exist, a loop does not follow edges of the skin, or the
    /// result does not enclose a body.
    pub fn new(
        nodes: &[Vector],
        solids: &[Solid],
        lids: &[Vec<usize>],
        plane: Option<RigidPlane>,
    ) -> Result<Self, AcousticError> {
        let faces = boundary(nodes, solids)?;
        let rims = rims(&faces, lids)?;
        let parts = parts(&faces, &rims);
        // Lids separate the outside from the inside; without them, every outer surface stays.
        let mut kept: Vec<Face> = if lids.is_empty() {
            parts.into_iter().filter(|part| volume(nodes, part) > 0.0).flatten().collect()
        } else {
            let reach = |part: &Vec<Face>| extent(nodes, part);
            let mut largest: Option<Vec<Face>> = None;
            for part in parts {
                if largest.as_ref().is_none_or(|other| reach(&part) > reach(other)) {
                    largest = Some(part);
                }
            }
            largest.unwrap_or_default()
        };
        let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
        let mut origins: Vec<Vec<usize>> = Vec::new();
        let mut vertices: Vec<Vector> = Vec::new();
        let directed: HashSet<[usize; 2]> = kept.iter().flat_map(edges).collect();
        let mut index = |node: usize| {
            *numbers.entry(node).or_insert_with(|| {
                vertices.push(nodes[node]);
                origins.push(vec![node]);
                vertices.len() - 1
            })
        };
        for face in &mut kept {
            *face = match *face {
                Face::Triangle(corners) => Face::Triangle(corners.map(&mut index)),
                Face::Quadrilateral(corners) => Face::Quadrilateral(corners.map(&mut index)),
            };
        }
        for lid in lids.iter().filter(|lid| lid.iter().any(|node| numbers.contains_key(node))) {
            let center = vertices.len();
            let sum = lid.iter().fold([0.0; 3], |sum, node| plus(sum, nodes[*node]));
            vertices.push(scaled(sum, 1.0 / lid.len() as f64));
            origins.push(lid.clone());
            for (at, &from) in lid.iter().enumerate() {
                let to = lid[(at + 1) % lid.len()];
                let (Some(&a), Some(&b)) = (numbers.get(&from), numbers.get(&to)) else {
                    return Err(not_on_skin(from, to));
                };
                // The lid runs along the rim in the opposite sense.
                let triangle = if directed.contains(&[from, to]) { [b, a, center] } else { [a, b, center] };
                kept.push(Face::Triangle(triangle));
            }
        }
        Ok(Self { mesh: SurfaceMesh::new(vertices, &kept, plane)?, nodes: origins })
    }

    /// Returns the normal velocities of the triangles, m/s, from the velocities of the nodes of the
    /// solid mesh.
    ///
    /// # Errors
    /// A node of the skin has no velocity.
    pub fn normal_velocities(&self, velocities: &[[c64; 3]]) -> Result<Vec<c64>, AcousticError> {
        let largest = self.nodes.iter().flatten().max().copied().unwrap_or(0);
        if largest >= velocities.len() {
            return Err(AcousticError::input(
                format!("{} velocities, but the skin has the node {largest}", velocities.len()),
                "pass one velocity for each node of the solid mesh",
            ));
        }
        let mean = |nodes: &Vec<usize>| {
            [0, 1, 2].map(|axis| {
                nodes.iter().map(|&node| velocities[node][axis]).sum::<c64>() / nodes.len() as f64
            })
        };
        self.mesh.normal_velocities(&self.nodes.iter().map(mean).collect::<Vec<_>>())
    }
}

fn not_on_skin(from: usize, to: usize) -> AcousticError {
    AcousticError::input(
        format!("a lid has the nodes {from} and {to}, which no edge of the skin connects"),
        "list the nodes of the rim in their order along the edges of the skin",
    )
}

/// Returns the faces that belong to one element only, with normals out of the elements.
///
/// # Errors
/// An element has a node that does not exist.
pub fn boundary(nodes: &[Vector], solids: &[Solid]) -> Result<Vec<Face>, AcousticError> {
    let mut count: HashMap<Vec<usize>, usize> = HashMap::new();
    let mut all: Vec<(Vec<usize>, Face)> = Vec::new();
    for (element, solid) in solids.iter().enumerate() {
        let mut faces = solid.faces();
        let place = || format!("solid element {element}");
        if let Some(node) = faces.iter().flat_map(Face::vertices).find(|node| **node >= nodes.len()) {
            let message = format!("node {node} does not exist; the mesh has {} nodes", nodes.len());
            return Err(AcousticError::mesh(place(), message, "correct the nodes of the element"));
        }
        if volume(nodes, &faces) < 0.0 {
            faces.iter_mut().for_each(|face| match face {
                Face::Triangle(corners) => corners.reverse(),
                Face::Quadrilateral(corners) => corners.reverse(),
            });
        }
        for face in faces {
            let mut key = face.vertices().to_vec();
            key.sort_unstable();
            *count.entry(key.clone()).or_default() += 1;
            all.push((key, face));
        }
    }
    Ok(all.into_iter().filter(|(key, _)| count[key] == 1).map(|(_, face)| face).collect())
}

/// Returns the edges along the loops of the lids.
fn rims(faces: &[Face], lids: &[Vec<usize>]) -> Result<HashSet<[usize; 2]>, AcousticError> {
    let known: HashSet<[usize; 2]> = faces.iter().flat_map(edges).map(sorted).collect();
    let mut rims = HashSet::new();
    for lid in lids {
        if lid.len() < 3 {
            return Err(AcousticError::input(
                format!("a lid has {} nodes", lid.len()),
                "list at least three nodes along the rim of the opening",
            ));
        }
        for (at, &from) in lid.iter().enumerate() {
            let to = lid[(at + 1) % lid.len()];
            let edge = sorted([from, to]);
            if !known.contains(&edge) {
                return Err(not_on_skin(from, to));
            }
            rims.insert(edge);
        }
    }
    Ok(rims)
}

/// Returns the parts of the surface that edges connect, without those along the rims.
fn parts(faces: &[Face], rims: &HashSet<[usize; 2]>) -> Vec<Vec<Face>> {
    let mut around: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
    for (index, face) in faces.iter().enumerate() {
        for edge in edges(face).into_iter().map(sorted).filter(|edge| !rims.contains(edge)) {
            around.entry(edge).or_default().push(index);
        }
    }
    let mut reached = vec![false; faces.len()];
    let mut parts = Vec::new();
    for start in 0..faces.len() {
        if std::mem::replace(&mut reached[start], true) {
            continue;
        }
        let mut part = vec![start];
        let mut at = 0;
        while let Some(&index) = part.get(at) {
            at += 1;
            for edge in edges(&faces[index]).into_iter().map(sorted) {
                for &other in around.get(&edge).into_iter().flatten() {
                    if !std::mem::replace(&mut reached[other], true) {
                        part.push(other);
                    }
                }
            }
        }
        part.sort_unstable();
        parts.push(part.into_iter().map(|index| faces[index]).collect());
    }
    parts
}

/// Volume that faces enclose, m³.
pub(crate) fn volume(nodes: &[Vector], faces: &[Face]) -> f64 {
    let Some(first) = faces.first() else {
        return 0.0;
    };
    let origin = nodes[first.vertices()[0]];
    let part = |face: &Face| {
        let corners: Vec<Vector> = face.vertices().iter().map(|node| minus(nodes[*node], origin)).collect();
        let fan = (1..corners.len() - 1).map(|k| dot(corners[0], cross(corners[k], corners[k + 1])) / 6.0);
        fan.sum::<f64>()
    };
    faces.iter().map(part).sum()
}

/// Size of the bounding box of faces, m.
pub(crate) fn extent(nodes: &[Vector], faces: &[Face]) -> f64 {
    let points: Vec<Vector> =
        faces.iter().flat_map(|face| face.vertices().iter().map(|node| nodes[*node])).collect();
    crate::check::size(&points)
}
