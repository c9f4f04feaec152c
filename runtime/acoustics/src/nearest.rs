//! Search for the triangle of a surface that is nearest to a point.

use crate::cluster::{Cluster, ClusterTree};
use crate::mesh::SurfaceMesh;
use crate::point::distance;
use calyx_numerics::vec3::{Vector, dot};

/// Largest number of triangles in a leaf of the tree.
const LEAF: usize = 8;

/// Triangles of a mesh in a tree of bounding boxes.
pub(crate) struct NearestTriangle<'m> {
    mesh: &'m SurfaceMesh,
    tree: ClusterTree,
}

impl NearestTriangle<'_> {
    pub fn new(mesh: &SurfaceMesh) -> NearestTriangle<'_> {
        let bounds = |triangle: usize| {
            let corners = mesh.corners(triangle);
            [f64::min, f64::max].map(|extreme| {
                [0, 1, 2]
                    .map(|axis: usize| corners[1..].iter().fold(corners[0][axis], |x, c| extreme(x, c[axis])))
            })
        };
        let supports: Vec<[Vector; 2]> = (0..mesh.triangles().len()).map(bounds).collect();
        NearestTriangle { mesh, tree: ClusterTree::new(&supports, LEAF) }
    }

    /// Returns the triangle that is nearest to a point among those whose normals do not oppose a
    /// normal; the first one of equally near ones.
    pub fn find(&self, at: Vector, normal: Vector) -> usize {
        let point = Cluster { range: 0..0, bounds: [at, at], halves: None };
        let clusters = &self.tree.clusters;
        let (mut best, mut least) = (0, f64::INFINITY);
        // Clusters with their distances; the nearest one is the last.
        let mut open = vec![(0, 0.0)];
        while let Some((index, from)) = open.pop() {
            if from > least {
                continue;
            }
            if let Some(halves) = clusters[index].halves {
                let mut halves = halves.map(|half| (half, clusters[half].distance(&point)));
                halves.sort_by(|one, other| other.1.total_cmp(&one.1));
                open.extend(halves);
                continue;
            }
            for &triangle in self.tree.items(index) {
                if dot(self.mesh.normals()[triangle], normal) <= 0.0 {
                    continue;
                }
                let own = distance(at, self.mesh.corners(triangle));
                if own < least || (own == least && triangle < best) {
                    (best, least) = (triangle, own);
                }
            }
        }
        best
    }
}
