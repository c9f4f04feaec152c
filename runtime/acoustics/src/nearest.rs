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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Face;

    /// The tree finds what a search of all triangles finds, for points in, on and outside of an
    /// ellipsoid.
    #[test]
    fn the_tree_finds_the_nearest_triangle() {
        const RINGS: usize = 9;
        const SIDES: usize = 14;
        let at = |ring: usize, side: usize| {
            let polar = std::f64::consts::PI * ring as f64 / RINGS as f64;
            let (angle, radius) = (std::f64::consts::TAU * side as f64 / SIDES as f64, polar.sin());
            [radius * angle.cos(), 0.7 * radius * angle.sin(), 1.4 * polar.cos()]
        };
        let mut vertices = vec![at(0, 0), at(RINGS, 0)];
        vertices.extend((1..RINGS).flat_map(|ring| (0..SIDES).map(move |side| at(ring, side))));
        let index = |ring: usize, side: usize| match ring {
            0 => 0,
            RINGS => 1,
            _ => 2 + (ring - 1) * SIDES + side % SIDES,
        };
        let mut faces = Vec::new();
        for (ring, side) in (0..RINGS).flat_map(|ring| (0..SIDES).map(move |side| (ring, side))) {
            let [a, b] = [index(ring, side), index(ring, side + 1)];
            let [c, d] = [index(ring + 1, side + 1), index(ring + 1, side)];
            faces.push(match ring {
                0 => Face::Triangle([a, d, c]),
                _ if ring + 1 == RINGS => Face::Triangle([a, d, b]),
                _ => Face::Quadrilateral([a, d, c, b]),
            });
        }
        let mesh = SurfaceMesh::new(vertices, &faces, None).expect("closed");
        let search = NearestTriangle::new(&mesh);
        for k in 0..500 {
            let part = |step: f64| 3.0 * (step * f64::from(k)).fract() - 1.5;
            let at = [part(0.618), part(0.414), part(0.732)];
            let normal = [part(0.317), part(0.271), part(0.577)];
            let along = (0..mesh.triangles().len()).filter(|&t| dot(mesh.normals()[t], normal) > 0.0);
            let distances = along.map(|t| (distance(at, mesh.corners(t)), t));
            let expected = distances.min_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
            assert_eq!(Some(search.find(at, normal)), expected.map(|(_, triangle)| triangle));
        }
    }
}
