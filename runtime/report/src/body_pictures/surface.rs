//! Outer surface of a meshed body: faces that belong to one cell only, shells, and beams as lines.

use calyx_runtime::elastic_body::CellShape;
use calyx_runtime::observables::{BodyField, ElasticBodyField, Fields};
use calyx_runtime::stress::von_mises;
use calyx_runtime::structure::outer_surface::{Cell, CellKind, outer_faces};

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
    let mut cells: Vec<(CellKind, Vec<usize>)> = Vec::new();
    for sector in &body.sectors {
        let first = surface.points.len();
        surface.points.extend(&sector.points);
        surface.displacements.extend(&sector.displacements);
        surface.stresses.extend(sector.stresses.iter().map(|&stress| von_mises(stress)));
        cells.extend(sector.cells.iter().map(|cell| {
            let kind = if cell.len() == 8 { CellKind::Hexahedron } else { CellKind::Face };
            (kind, cell.iter().map(|corner| first + corner).collect())
        }));
    }
    let cells = cells.iter().enumerate();
    let cells = cells.map(|(element, (kind, corners))| Cell { kind: *kind, corners, element });
    surface.faces.extend(outer_faces(cells).into_iter().map(|face| face.corners));
    surface
}

fn of_elastic_body(body: &ElasticBodyField) -> Surface {
    let mut surface = Surface::empty(&body.body, body.number);
    surface.points.clone_from(&body.points);
    surface.displacements.clone_from(&body.displacements);
    surface.stresses = body.stresses.iter().map(|&stress| von_mises(stress)).collect();
    let cells = body.cells.iter().enumerate();
    let cells =
        cells.map(|(index, (shape, nodes)): (usize, &(CellShape, Vec<usize>))| shape.cell(nodes, index));
    let beams = cells.clone().filter(|cell| cell.kind == CellKind::Line);
    surface.lines.extend(beams.map(|cell| [cell.corners[0], cell.corners[cell.corners.len() - 1]]));
    surface.faces.extend(outer_faces(cells).into_iter().map(|face| face.corners));
    surface
}

impl Surface {
    /// Creates the surface of triangles without stress and displacements.
    pub fn of_triangles(body: &str, points: &[[f64; 3]], triangles: &[[usize; 3]]) -> Surface {
        Surface {
            points: points.to_vec(),
            displacements: vec![[0.0; 3]; points.len()],
            stresses: vec![f64::NAN; points.len()],
            faces: triangles.iter().map(|triangle| triangle.to_vec()).collect(),
            ..Surface::empty(body, 0)
        }
    }

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
    use calyx_runtime::elastic::model::SolidShape;

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
}
