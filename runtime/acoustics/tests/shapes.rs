//! Meshes of spheres, cylinders and plates for the tests.

use calyx_acoustics::{Face, RigidPlane, SurfaceMesh};
use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};
use std::collections::HashMap;

/// Vertices and triangles of a sphere of unit radius: an icosahedron whose edges are divided into
/// two `level` times. It has 20 · 4^level triangles.
pub fn icosphere(level: usize) -> (Vec<Vector>, Vec<[usize; 3]>) {
    let golden = 0.5 * (1.0 + 5f64.sqrt());
    let mut vertices: Vec<Vector> = Vec::new();
    for a in [-1.0, 1.0] {
        for b in [-golden, golden] {
            vertices.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
        }
    }
    refined(vertices, level)
}

/// The same from an octahedron: edges lie in the coordinate planes. It has 8 · 4^level triangles.
pub fn octasphere(level: usize) -> (Vec<Vector>, Vec<[usize; 3]>) {
    let vertices = [0, 1, 2]
        .into_iter()
        .flat_map(|axis| [-1.0, 1.0].map(|sign| [0, 1, 2].map(|k| if k == axis { sign } else { 0.0 })));
    refined(vertices.collect(), level)
}

/// Refines the polyhedron whose triangles connect vertices at the least distance.
fn refined(mut vertices: Vec<Vector>, level: usize) -> (Vec<Vector>, Vec<[usize; 3]>) {
    let count = vertices.len();
    vertices.iter_mut().for_each(|vertex| *vertex = unit(*vertex));
    let distance = |a: usize, b: usize| length(minus(vertices[a], vertices[b]));
    let edge = (1..count).map(|other| distance(0, other)).fold(f64::INFINITY, f64::min);
    let near = |a: usize, b: usize| distance(a, b) < 1.01 * edge;
    let mut triangles = Vec::new();
    for a in 0..count {
        for b in a + 1..count {
            for c in b + 1..count {
                if near(a, b) && near(b, c) && near(a, c) {
                    let [p, q, r] = [a, b, c].map(|vertex| vertices[vertex]);
                    let is_outward = dot(p, cross(q, r)) > 0.0;
                    triangles.push(if is_outward { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..level {
        let mut middles: HashMap<[usize; 2], usize> = HashMap::new();
        let mut next = Vec::new();
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[p, q]| {
                *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                    vertices.push(unit(plus(vertices[p], vertices[q])));
                    vertices.len() - 1
                })
            });
            next.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        triangles = next;
    }
    (vertices, triangles)
}

pub fn faces(triangles: &[[usize; 3]]) -> Vec<Face> {
    triangles.iter().map(|triangle| Face::Triangle(*triangle)).collect()
}

/// Scales a sphere to the area of one with a radius: an inscribed mesh would have too little.
fn scaled_sphere((vertices, triangles): (Vec<Vector>, Vec<[usize; 3]>), radius: f64) -> SurfaceMesh {
    let inscribed = SurfaceMesh::new(vertices.clone(), &faces(&triangles), None).expect("closed");
    let scale = radius * (4.0 * std::f64::consts::PI / inscribed.area()).sqrt();
    let vertices = vertices.iter().map(|vertex| scaled(*vertex, scale)).collect();
    SurfaceMesh::new(vertices, &faces(&triangles), None).expect("closed")
}

/// Sphere from an icosahedron with the area of a sphere of this radius.
pub fn sphere(level: usize, radius: f64) -> SurfaceMesh {
    scaled_sphere(icosphere(level), radius)
}

/// Sphere from an octahedron, and its half above the rigid plane z = 0.
pub fn sphere_and_half(level: usize, radius: f64) -> [SurfaceMesh; 2] {
    let whole = scaled_sphere(octasphere(level), radius);
    let mut numbers = HashMap::new();
    let mut vertices = Vec::new();
    let triangles: Vec<[usize; 3]> = (0..whole.triangles().len())
        .filter(|&triangle| whole.centroid(triangle)[2] > 0.0)
        .map(|triangle| {
            whole.triangles()[triangle].map(|vertex| {
                *numbers.entry(vertex).or_insert_with(|| {
                    vertices.push(whole.vertices()[vertex]);
                    vertices.len() - 1
                })
            })
        })
        .collect();
    let plane = RigidPlane::new([0.0; 3], [0.0, 0.0, 1.0]).expect("valid");
    let half = SurfaceMesh::new(vertices, &faces(&triangles), Some(plane)).expect("closed by the plane");
    [whole, half]
}

/// Corners of the triangles of a disc around z at a height. `rings` rings, with six more triangles
/// along each; the area is that of a circle of this radius.
pub fn disc(rings: usize, radius: f64) -> (Vec<Vector>, Vec<[usize; 3]>) {
    let mut vertices = vec![[0.0; 3]];
    let mut triangles = Vec::new();
    let start = |ring: usize| if ring == 0 { 0 } else { 1 + 3 * ring * (ring - 1) };
    for ring in 1..=rings {
        let count = 6 * ring;
        for k in 0..count {
            let (sine, cosine) = (std::f64::consts::TAU * k as f64 / count as f64).sin_cos();
            let r = ring as f64 / rings as f64;
            vertices.push([r * cosine, r * sine, 0.0]);
        }
        for sector in 0..6 {
            for k in 0..ring {
                let outer = |j: usize| start(ring) + (sector * ring + j) % count;
                let inner = |j: usize| {
                    let inner_count = (6 * (ring - 1)).max(1);
                    start(ring - 1) + (sector * (ring - 1) + j) % inner_count
                };
                triangles.push([outer(k), outer(k + 1), inner(k)]);
                if k + 1 < ring {
                    triangles.push([inner(k), outer(k + 1), inner(k + 1)]);
                }
            }
        }
    }
    let area: f64 = triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| vertices[vertex]);
            0.5 * cross(minus(b, a), minus(c, a))[2]
        })
        .sum();
    let scale = radius * (std::f64::consts::PI / area).sqrt();
    vertices.iter_mut().for_each(|vertex| *vertex = scaled(*vertex, scale));
    (vertices, triangles)
}

/// Axis-parallel box of quadrilaterals, with this number of cells along each edge.
pub fn cuboid(size: Vector, cells: [usize; 3]) -> (Vec<Vector>, Vec<Face>) {
    let mut vertices = Vec::new();
    let mut numbers: HashMap<[usize; 3], usize> = HashMap::new();
    let mut faces = Vec::new();
    for axis in 0..3 {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for side in [0, 1] {
            for i in 0..cells[u] {
                for j in 0..cells[v] {
                    let corner = |di: usize, dj: usize| {
                        let mut at = [0; 3];
                        (at[axis], at[u], at[v]) = (side * cells[axis], i + di, j + dj);
                        at
                    };
                    let mut around = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if side == 0 {
                        around.reverse();
                    }
                    faces.push(Face::Quadrilateral(around.map(|at| {
                        *numbers.entry(at).or_insert_with(|| {
                            vertices.push([0, 1, 2].map(|k| size[k] * at[k] as f64 / cells[k] as f64));
                            vertices.len() - 1
                        })
                    })));
                }
            }
        }
    }
    (vertices, faces)
}
