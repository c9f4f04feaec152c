//! Outer surface of a meshed body: faces that belong to one cell only, shells, and beams as lines.

use crate::von_mises::von_mises;
use calyx_runtime::elastic::model::{ShellShape, SolidShape};
use calyx_runtime::elastic_body::CellShape;
use calyx_runtime::observables::{BodyField, ElasticBodyField, Fields};
use std::collections::BTreeMap;

/// Faces of a cell, as indices of its corners.
type Faces = &'static [&'static [usize]];

/// Faces of a hexahedron, wedge and tetrahedron, outward.
const HEXAHEDRON: [&[usize]; 6] =
    [&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]];
const WEDGE: [&[usize]; 5] = [&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]];
const TETRAHEDRON: [&[usize]; 4] = [&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]];

/// Outer surface of a body. Faces have their corners only; those between them are straight.
pub struct Surface {
    pub body: String,
    pub number: usize,
    /// Undeformed points, m.
    pub points: Vec<[f64; 3]>,
    pub displacements: Vec<[f64; 3]>,
    /// Von Mises stress at each point, Pa; NaN if unknown.
    pub stresses: Vec<f64>,
    /// Triangles and quadrilaterals, as indices of points.
    pub faces: Vec<Vec<usize>>,
    /// Beams.
    pub lines: Vec<[usize; 2]>,
}

/// A meshed body.
pub enum Meshed<'f> {
    Gear(&'f BodyField),
    ElasticBody(&'f ElasticBodyField),
}

/// Returns all meshed bodies.
pub fn all(fields: &Fields) -> impl Iterator<Item = Meshed<'_>> {
    let elastic_bodies = fields.elastic_bodies.iter().map(Meshed::ElasticBody);
    fields.bodies.iter().map(Meshed::Gear).chain(elastic_bodies)
}

impl Meshed<'_> {
    /// Returns the name of the body.
    pub fn name(&self) -> &str {
        match self {
            Meshed::Gear(body) => &body.body,
            Meshed::ElasticBody(body) => &body.body,
        }
    }

    /// Returns the largest known von Mises stress of all nodes, Pa.
    pub fn largest_stress(&self) -> f64 {
        let largest = |stresses: &[[f64; 6]]| {
            let known = stresses.iter().map(|&stress| von_mises(stress)).filter(|stress| stress.is_finite());
            known.fold(0.0, f64::max)
        };
        match self {
            Meshed::Gear(body) => {
                body.sectors.iter().map(|sector| largest(&sector.stresses)).fold(0.0, f64::max)
            }
            Meshed::ElasticBody(body) => largest(&body.stresses),
        }
    }

    /// Returns the largest displacement of all nodes, m.
    pub fn largest_displacement(&self) -> f64 {
        match self {
            Meshed::Gear(body) => {
                body.sectors.iter().map(|sector| largest(&sector.displacements)).fold(0.0, f64::max)
            }
            Meshed::ElasticBody(body) => largest(&body.displacements),
        }
    }

    /// Returns the outer surface.
    pub fn surface(&self) -> Surface {
        match self {
            Meshed::Gear(body) => of_gear(body),
            Meshed::ElasticBody(body) => of_elastic_body(body),
        }
    }
}

/// Returns the largest length of vectors.
fn largest(vectors: &[[f64; 3]]) -> f64 {
    vectors.iter().map(|[x, y, z]| (x * x + y * y + z * z).sqrt()).fold(0.0, f64::max)
}

fn of_gear(body: &BodyField) -> Surface {
    let mut surface = Surface::empty(&body.body, body.number);
    let mut cells: Vec<(Faces, Vec<usize>)> = Vec::new();
    for sector in &body.sectors {
        let first = surface.points.len();
        surface.points.extend(&sector.points);
        surface.displacements.extend(&sector.displacements);
        surface.stresses.extend(sector.stresses.iter().map(|&stress| von_mises(stress)));
        for cell in &sector.cells {
            let corners: Vec<usize> = cell.iter().map(|corner| first + corner).collect();
            match corners.len() {
                8 => cells.push((&HEXAHEDRON, corners)),
                _ => surface.faces.push(corners),
            }
        }
    }
    surface.faces.extend(outer_faces(&cells));
    surface
}

fn of_elastic_body(body: &ElasticBodyField) -> Surface {
    let mut surface = Surface::empty(&body.body, body.number);
    surface.points.clone_from(&body.points);
    surface.displacements.clone_from(&body.displacements);
    surface.stresses = body.stresses.iter().map(|&stress| von_mises(stress)).collect();
    let mut cells: Vec<(Faces, Vec<usize>)> = Vec::new();
    for (shape, nodes) in &body.cells {
        match shape {
            CellShape::Line => surface.lines.push([nodes[0], nodes[nodes.len() - 1]]),
            CellShape::Shell(ShellShape::Triangle3 | ShellShape::Triangle6) => {
                surface.faces.push(nodes[..3].to_vec());
            }
            CellShape::Shell(
                ShellShape::Quadrilateral4 | ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9,
            ) => surface.faces.push(nodes[..4].to_vec()),
            CellShape::Solid(SolidShape::Tetrahedron4 | SolidShape::Tetrahedron10) => {
                cells.push((&TETRAHEDRON, nodes[..4].to_vec()));
            }
            CellShape::Solid(SolidShape::Wedge6 | SolidShape::Wedge15) => {
                cells.push((&WEDGE, nodes[..6].to_vec()));
            }
            CellShape::Solid(
                SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 | SolidShape::Hexahedron20,
            ) => {
                cells.push((&HEXAHEDRON, nodes[..8].to_vec()));
            }
        }
    }
    surface.faces.extend(outer_faces(&cells));
    surface
}

/// Returns the faces that belong to one cell only.
fn outer_faces(cells: &[(Faces, Vec<usize>)]) -> Vec<Vec<usize>> {
    let mut found: BTreeMap<Vec<usize>, Option<Vec<usize>>> = BTreeMap::new();
    for (faces, corners) in cells {
        for face in *faces {
            let face: Vec<usize> = face.iter().map(|&corner| corners[corner]).collect();
            let mut key = face.clone();
            key.sort_unstable();
            found.entry(key).and_modify(|other| *other = None).or_insert(Some(face));
        }
    }
    found.into_values().flatten().collect()
}

impl Surface {
    fn empty(body: &str, number: usize) -> Surface {
        let (points, displacements, stresses) = (Vec::new(), Vec::new(), Vec::new());
        let (faces, lines) = (Vec::new(), Vec::new());
        Surface { body: body.to_owned(), number, points, displacements, stresses, faces, lines }
    }

    /// Returns the points that belong to a face or a line.
    fn shown(&self) -> impl Iterator<Item = usize> + '_ {
        self.faces.iter().flatten().copied().chain(self.lines.iter().flatten().copied())
    }

    /// Returns the largest displacement, m.
    pub fn largest_displacement(&self) -> f64 {
        largest(&self.displacements)
    }

    /// Returns the diagonal of the bounding box, m.
    pub fn diagonal(&self) -> f64 {
        let range = |k: usize| {
            let values = self.shown().map(|point| self.points[point][k]);
            let [least, most] = values
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)]);
            (most - least).max(0.0)
        };
        (range(0).powi(2) + range(1).powi(2) + range(2).powi(2)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::cube;
    use super::*;

    #[test]
    fn common_faces_of_cells_are_inside() {
        let mut field = cube(0, 1.0);
        let second: Vec<[f64; 3]> = field.points.iter().map(|[x, y, z]| [*x, *y, z + 1.0]).collect();
        field.points.extend(&second[4..]);
        field.displacements.resize(12, [0.0; 3]);
        field.stresses.resize(12, [f64::NAN; 6]);
        let hexahedron = CellShape::Solid(SolidShape::Hexahedron8);
        field.cells.push((hexahedron, vec![4, 5, 6, 7, 8, 9, 10, 11]));
        field.cells.push((CellShape::Line, vec![0, 6]));
        let surface = of_elastic_body(&field);
        assert_eq!((surface.faces.len(), surface.lines.len()), (10, 1));
        assert!(!surface.faces.iter().any(|face| face.iter().all(|corner| (4..8).contains(corner))));
        assert!((surface.diagonal() - 6.0_f64.sqrt()).abs() < 1e-15);
    }

    /// Faces of all shapes are outward: their normals point away from the centre.
    #[test]
    fn faces_are_outward() {
        let shapes: [(Faces, Vec<[f64; 3]>); 3] = [
            (&HEXAHEDRON, cube(0, 1.0).points),
            (
                &WEDGE,
                [0.0, 1.0].iter().flat_map(|&z| [[0.0, 0.0, z], [1.0, 0.0, z], [0.0, 1.0, z]]).collect(),
            ),
            (&TETRAHEDRON, vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        ];
        for (faces, points) in shapes {
            let centre = |corners: &[usize], k: usize| {
                corners.iter().map(|&corner| points[corner][k]).sum::<f64>() / corners.len() as f64
            };
            let every: Vec<usize> = (0..points.len()).collect();
            for face in faces {
                let edge = |from: usize, to: usize| -> [f64; 3] {
                    std::array::from_fn(|k| points[face[to]][k] - points[face[from]][k])
                };
                let [a, b] = [edge(0, 1), edge(0, 2)];
                let normal: [f64; 3] = std::array::from_fn(|k| {
                    a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]
                });
                let outward: f64 = (0..3).map(|k| normal[k] * (centre(face, k) - centre(&every, k))).sum();
                assert!(outward > 0.0, "{face:?}");
            }
        }
    }
}
