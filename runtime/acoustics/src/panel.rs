//! Flat triangles with the quantities of their integrals.

use crate::mesh::SurfaceMesh;
use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};

/// Triangle of the surface or its mirror image.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Panel {
    pub corners: [Vector; 3],
    /// Vertex of the mesh at each corner.
    pub nodes: [usize; 3],
    /// Equal numbers for corners at the same position: images of vertices off the plane have
    /// numbers of their own.
    pub keys: [usize; 3],
    pub normal: Vector,
    pub area: f64,
    /// Surface curls n × ∇φ of the three shape functions, up to a common sign, 1/m.
    pub curls: [Vector; 3],
    pub centroid: Vector,
    /// Largest distance of a corner from the centroid, m.
    pub radius: f64,
}

impl Panel {
    fn new(corners: [Vector; 3], nodes: [usize; 3], keys: [usize; 3], normal: Vector, area: f64) -> Self {
        let [a, b, c] = corners;
        let centroid = scaled(plus(plus(a, b), c), 1.0 / 3.0);
        let radius = corners.map(|corner| length(minus(corner, centroid))).into_iter().fold(0.0, f64::max);
        let curls = [minus(c, b), minus(a, c), minus(b, a)].map(|edge| scaled(edge, 0.5 / area));
        Self { corners, nodes, keys, normal, area, curls, centroid, radius }
    }

    /// Returns a triangle that belongs to no mesh.
    pub fn separate(corners: [Vector; 3]) -> Self {
        let [a, b, c] = corners;
        let product = cross(minus(b, a), minus(c, a));
        let area = 0.5 * length(product);
        Self::new(corners, [0, 1, 2], [0, 1, 2], unit(product), area)
    }

    /// Returns a triangle of a mesh.
    pub fn of(mesh: &SurfaceMesh, triangle: usize) -> Self {
        let nodes = mesh.triangles()[triangle];
        Self::new(mesh.corners(triangle), nodes, nodes, mesh.normals()[triangle], mesh.areas()[triangle])
    }

    /// Returns the mirror image of a triangle of a mesh in its rigid plane; its normal points into
    /// the mirrored fluid. `None` without a plane.
    pub fn image(mesh: &SurfaceMesh, triangle: usize) -> Option<Self> {
        let plane = mesh.plane()?;
        let [a, b, c] = mesh.triangles()[triangle];
        let nodes = [a, c, b];
        let count = mesh.vertices().len();
        let tolerance = 1e-9 * mesh.size();
        let corners = nodes.map(|vertex| plane.mirror(mesh.vertices()[vertex]));
        let keys = nodes.map(|vertex| {
            let on_plane = plane.distance(mesh.vertices()[vertex]).abs() <= tolerance;
            if on_plane { vertex } else { count + vertex }
        });
        let normal = mesh.normals()[triangle];
        let along = 2.0 * dot(normal, plane.normal());
        let mirrored = minus(normal, scaled(plane.normal(), along));
        Some(Self::new(corners, nodes, keys, mirrored, mesh.areas()[triangle]))
    }
}
