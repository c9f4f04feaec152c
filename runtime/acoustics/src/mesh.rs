//! Closed surface meshes of triangles.

use crate::check::{Surface, size};
use crate::error::AcousticError;
use crate::plane::RigidPlane;
use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};
use faer::c64;

/// Element of a surface: indices of its vertices, counter-clockwise seen from the fluid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// Triangle.
    Triangle([usize; 3]),
    /// Quadrilateral; the mesh divides it along its shorter diagonal.
    Quadrilateral([usize; 4]),
}

impl Face {
    /// Returns the indices of the vertices.
    pub fn vertices(&self) -> &[usize] {
        match self {
            Self::Triangle(vertices) => vertices,
            Self::Quadrilateral(vertices) => vertices,
        }
    }
}

/// Surface of a body in the fluid: triangles whose normals point into the fluid. The surface is
/// closed, or closed by the rigid plane on which the body stands.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceMesh {
    vertices: Vec<Vector>,
    triangles: Vec<[usize; 3]>,
    /// Index of the face of each triangle.
    faces: Vec<usize>,
    areas: Vec<f64>,
    normals: Vec<Vector>,
    plane: Option<RigidPlane>,
}

impl SurfaceMesh {
    /// Creates a mesh in free space, or in front of a rigid plane. Positions are in m.
    ///
    /// # Errors
    /// The mesh does not enclose a body: it is open, degenerate, non-manifold, not consistently
    /// oriented, has coincident vertices, or has a part behind the plane.
    pub fn new(
        vertices: Vec<Vector>,
        faces: &[Face],
        plane: Option<RigidPlane>,
    ) -> Result<Self, AcousticError> {
        let (mut triangles, mut owners) = (Vec::new(), Vec::new());
        for (index, face) in faces.iter().enumerate() {
            let corners = face.vertices();
            if let Some(vertex) = corners.iter().find(|vertex| **vertex >= vertices.len()) {
                return Err(AcousticError::mesh(
                    format!("element {index}"),
                    format!("vertex {vertex} does not exist; the mesh has {} vertices", vertices.len()),
                    "correct the vertices of the element",
                ));
            }
            match *face {
                Face::Triangle(triangle) => triangles.push(triangle),
                Face::Quadrilateral([a, b, c, d]) => {
                    let diagonal = |i: usize, j: usize| length(minus(vertices[i], vertices[j]));
                    if diagonal(a, c) <= diagonal(b, d) {
                        triangles.extend([[a, b, c], [a, c, d]]);
                    } else {
                        triangles.extend([[a, b, d], [b, c, d]]);
                    }
                }
            }
            owners.resize(triangles.len(), index);
        }
        let surface =
            Surface { vertices: &vertices, triangles: &triangles, faces: &owners, plane: plane.as_ref() };
        surface.check()?;
        let products: Vec<Vector> = triangles
            .iter()
            .map(|triangle| {
                let [a, b, c] = triangle.map(|vertex| vertices[vertex]);
                cross(minus(b, a), minus(c, a))
            })
            .collect();
        let areas = products.iter().map(|product| 0.5 * length(*product)).collect();
        let normals = products.into_iter().map(unit).collect();
        Ok(Self { vertices, triangles, faces: owners, areas, normals, plane })
    }

    /// Returns the positions of the vertices, m.
    pub fn vertices(&self) -> &[Vector] {
        &self.vertices
    }

    /// Returns the vertices of the triangles, counter-clockwise seen from the fluid.
    pub fn triangles(&self) -> &[[usize; 3]] {
        &self.triangles
    }

    /// Returns the index of the face of each triangle, as passed to [`SurfaceMesh::new`].
    pub fn faces(&self) -> &[usize] {
        &self.faces
    }

    /// Returns the areas of the triangles, m².
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// Returns the unit normals of the triangles, into the fluid.
    pub fn normals(&self) -> &[Vector] {
        &self.normals
    }

    /// Returns the rigid plane in front of which the mesh is.
    pub fn plane(&self) -> Option<&RigidPlane> {
        self.plane.as_ref()
    }

    /// Returns the area of the surface, m².
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// Returns the volume of the body, m³.
    pub fn volume(&self) -> f64 {
        let origin = self.plane.map_or([0.0; 3], |plane| plane.point());
        let parts = (0..self.triangles.len()).map(|triangle| {
            let [a, b, c] = self.corners(triangle).map(|corner| minus(corner, origin));
            dot(a, cross(b, c)) / 6.0
        });
        parts.sum()
    }

    /// Returns the corners of a triangle, m.
    pub fn corners(&self, triangle: usize) -> [Vector; 3] {
        self.triangles[triangle].map(|vertex| self.vertices[vertex])
    }

    /// Returns the centroid of a triangle, m.
    pub fn centroid(&self, triangle: usize) -> Vector {
        let [a, b, c] = self.corners(triangle);
        scaled(plus(plus(a, b), c), 1.0 / 3.0)
    }

    /// Returns the length of the diagonal of the bounding box, m.
    pub fn size(&self) -> f64 {
        size(&self.vertices)
    }

    /// Returns the length of the diagonal of the box around the mesh and its mirror image in the
    /// rigid plane, m: how fast the sound varies over the frequency and the direction.
    pub fn extent(&self) -> f64 {
        let mirrored = self.plane.iter().flat_map(|p| self.vertices.iter().map(|at| p.mirror(*at)));
        size(&self.vertices.iter().copied().chain(mirrored).collect::<Vec<_>>())
    }

    /// Returns the length of the longest edge, m.
    pub fn longest_edge(&self) -> f64 {
        let edges = (0..self.triangles.len()).flat_map(|triangle| {
            let [a, b, c] = self.corners(triangle);
            [length(minus(a, b)), length(minus(b, c)), length(minus(c, a))]
        });
        edges.fold(0.0, f64::max)
    }

    /// Returns the highest frequency at which the longest edge is a sixth of a wavelength, Hz.
    pub fn highest_frequency(&self, speed_of_sound: f64) -> f64 {
        speed_of_sound / (6.0 * self.longest_edge())
    }

    /// Returns the mean normal velocity of each triangle, m/s, from the velocities of the vertices.
    ///
    /// # Errors
    /// The number of velocities is not that of the vertices.
    pub fn normal_velocities(&self, velocities: &[[c64; 3]]) -> Result<Vec<c64>, AcousticError> {
        if velocities.len() != self.vertices.len() {
            return Err(AcousticError::input(
                format!("{} velocities for {} vertices", velocities.len(), self.vertices.len()),
                "pass one velocity for each vertex",
            ));
        }
        let normal = |(triangle, normal): (&[usize; 3], &Vector)| {
            let sum: c64 = triangle
                .iter()
                .flat_map(|&v| (0..3).map(move |axis| velocities[v][axis] * normal[axis]))
                .sum();
            sum / 3.0
        };
        Ok(self.triangles.iter().zip(&self.normals).map(normal).collect())
    }

    /// Returns the solid angle that the closed surface subtends at a point, divided by 4π: 1 for a
    /// point inside of the body, 0 for one in the fluid, and about a half for one on the surface.
    pub fn enclosure(&self, at: Vector) -> f64 {
        let angle = |corners: [Vector; 3]| {
            let [a, b, c] = corners.map(|corner| minus(corner, at));
            let [la, lb, lc] = [a, b, c].map(length);
            // Van Oosterom and Strackee 1983.
            let numerator = dot(a, cross(b, c));
            let denominator = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
            2.0 * numerator.atan2(denominator)
        };
        let mut sum = 0.0;
        for triangle in 0..self.triangles.len() {
            let corners = self.corners(triangle);
            sum += angle(corners);
            if let Some(plane) = &self.plane {
                let [a, b, c] = corners.map(|corner| plane.mirror(corner));
                sum += angle([a, c, b]);
            }
        }
        sum / (4.0 * std::f64::consts::PI)
    }
}
