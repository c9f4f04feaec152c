//! Search for the triangle of a surface that is nearest to a point.

use crate::mesh::SurfaceMesh;
use crate::point::distance;
use calyx_numerics::vec3::{Vector, dot, length, minus};

/// Triangles of a mesh with spheres around them.
pub(crate) struct NearestTriangle<'m> {
    mesh: &'m SurfaceMesh,
    /// Centroid and distance of the farthest corner, m.
    spheres: Vec<(Vector, f64)>,
}

impl NearestTriangle<'_> {
    pub fn new(mesh: &SurfaceMesh) -> NearestTriangle<'_> {
        let sphere = |triangle: usize| {
            let center = mesh.centroid(triangle);
            let radius = mesh.corners(triangle).map(|corner| length(minus(corner, center)));
            (center, radius.into_iter().fold(0.0, f64::max))
        };
        NearestTriangle { mesh, spheres: (0..mesh.triangles().len()).map(sphere).collect() }
    }

    /// Returns the triangle that is nearest to a point among those whose normals do not oppose a
    /// normal.
    pub fn find(&self, at: Vector, normal: Vector) -> usize {
        let (mut best, mut least) = (0, f64::INFINITY);
        for (triangle, (center, radius)) in self.spheres.iter().enumerate() {
            if length(minus(at, *center)) - radius >= least
                || dot(self.mesh.normals()[triangle], normal) <= 0.0
            {
                continue;
            }
            let own = distance(at, self.mesh.corners(triangle));
            if own < least {
                (best, least) = (triangle, own);
            }
        }
        best
    }
}
