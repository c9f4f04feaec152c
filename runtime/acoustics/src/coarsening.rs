//! Coarsening of skins to the element size that a wavelength permits.

use crate::error::AcousticError;
use crate::mesh::{Face, SurfaceMesh};
use crate::skin::Skin;
use calyx_numerics::vec3::{Vector, cross, dot, length, minus};
use std::collections::BTreeSet;

/// Largest deviation of a removed vertex from the new triangles, relative to the longest edge.
const DEVIATION: f64 = 0.1;
/// Least cosine of the angle by which a normal may turn.
const TURN: f64 = 0.7;
/// Least height of a triangle relative to its longest edge.
const HEIGHT: f64 = 0.2;

/// Returns a skin with fewer elements. Edges are contracted, the shortest ones first, as long as no
/// edge of a changed triangle exceeds `longest`, m, and the shape is kept: sharp edges, flat walls,
/// and curved ones up to a tenth of `longest`. A vertex has the mean motion of its own nodes and of
/// those of the vertices that were contracted to it.
///
/// # Errors
/// The length is not positive.
pub fn coarsened(skin: &Skin, longest: f64) -> Result<Skin, AcousticError> {
    if longest.is_nan() || longest <= 0.0 {
        return Err(AcousticError::input(
            format!("the longest edge of a coarsened skin is {longest} m"),
            "state a positive length, such as a sixth of the wavelength",
        ));
    }
    let mut surface = Contraction::new(skin, longest);
    while surface.pass() {}
    surface.finish()
}

/// Surface whose edges are contracted.
struct Contraction<'s> {
    mesh: &'s SurfaceMesh,
    triangles: Vec<Option<[usize; 3]>>,
    /// Triangles at each vertex; empty for removed vertices.
    around: Vec<Vec<usize>>,
    nodes: Vec<Vec<usize>>,
    on_plane: Vec<bool>,
    longest: f64,
}

impl<'s> Contraction<'s> {
    fn new(skin: &'s Skin, longest: f64) -> Self {
        let mesh = &skin.mesh;
        let mut around = vec![Vec::new(); mesh.vertices().len()];
        for (index, triangle) in mesh.triangles().iter().enumerate() {
            triangle.iter().for_each(|&vertex| around[vertex].push(index));
        }
        let tolerance = 1e-9 * mesh.size();
        let on_plane = |at: &Vector| mesh.plane().is_some_and(|p| p.distance(*at).abs() <= tolerance);
        Self {
            mesh,
            triangles: mesh.triangles().iter().copied().map(Some).collect(),
            around,
            nodes: skin.nodes.clone(),
            on_plane: mesh.vertices().iter().map(on_plane).collect(),
            longest,
        }
    }

    fn at(&self, vertex: usize) -> Vector {
        self.mesh.vertices()[vertex]
    }

    fn neighbours(&self, vertex: usize) -> BTreeSet<usize> {
        let triangles = self.around[vertex].iter().filter_map(|&index| self.triangles[index]);
        triangles.flatten().filter(|other| *other != vertex).collect()
    }

    /// Contracts edges that do not touch one another; returns whether there were any.
    fn pass(&mut self) -> bool {
        let mut edges: BTreeSet<[usize; 2]> = BTreeSet::new();
        for [a, b, c] in self.triangles.iter().flatten() {
            edges.extend([[a, b], [b, c], [c, a]].map(|[p, q]| [*p.min(q), *p.max(q)]));
        }
        let size = |[a, b]: [usize; 2]| length(minus(self.at(a), self.at(b)));
        let mut sorted: Vec<(f64, [usize; 2])> = edges
            .into_iter()
            .map(|edge| (size(edge), edge))
            .filter(|(size, _)| *size < self.longest)
            .collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut touched = vec![false; self.around.len()];
        let mut changed = false;
        for (_, [a, b]) in sorted {
            if touched[a] || touched[b] {
                continue;
            }
            for [from, to] in [[a, b], [b, a]] {
                if self.is_contractible(from, to) {
                    self.neighbours(from).into_iter().for_each(|vertex| touched[vertex] = true);
                    touched[from] = true;
                    self.contract(from, to);
                    changed = true;
                    break;
                }
            }
        }
        changed
    }

    /// Returns whether a vertex may move to a neighbour.
    fn is_contractible(&self, from: usize, to: usize) -> bool {
        let shared = self.around[from]
            .iter()
            .filter(|&&index| self.triangles[index].is_some_and(|triangle| triangle.contains(&to)))
            .count();
        // Vertices in the rigid plane stay in it, on the boundary of the mesh.
        if self.on_plane[from] && !(self.on_plane[to] && shared == 1) {
            return false;
        }
        let common = self.neighbours(from).intersection(&self.neighbours(to)).count();
        if common != shared || self.neighbours(from).len() < 3 {
            return false;
        }
        self.around[from].iter().filter_map(|&index| self.triangles[index]).all(|triangle| {
            if triangle.contains(&to) {
                return true;
            }
            let [p, q, r] = triangle.map(|vertex| self.at(vertex));
            let [a, b, c] = triangle.map(|vertex| self.at(if vertex == from { to } else { vertex }));
            let before = cross(minus(q, p), minus(r, p));
            let after = cross(minus(b, a), minus(c, a));
            let (old, new) = (length(before), length(after));
            let edge = [minus(a, b), minus(b, c), minus(c, a)].map(length).into_iter().fold(0.0, f64::max);
            edge <= self.longest
                && new >= HEIGHT * edge * edge
                && dot(before, after) >= TURN * old * new
                && dot(minus(self.at(from), a), after).abs() <= DEVIATION * self.longest * new
        })
    }

    fn contract(&mut self, from: usize, to: usize) {
        for index in std::mem::take(&mut self.around[from]) {
            let Some(triangle) = self.triangles[index] else {
                continue;
            };
            if triangle.contains(&to) {
                self.triangles[index] = None;
                for vertex in triangle {
                    self.around[vertex].retain(|other| *other != index);
                }
            } else {
                let moved = triangle.map(|vertex| if vertex == from { to } else { vertex });
                self.triangles[index] = Some(moved);
                self.around[to].push(index);
            }
        }
        let nodes = std::mem::take(&mut self.nodes[from]);
        self.nodes[to].extend(nodes);
    }

    fn finish(self) -> Result<Skin, AcousticError> {
        let mut numbers = vec![usize::MAX; self.around.len()];
        let (mut vertices, mut nodes) = (Vec::new(), Vec::new());
        for vertex in (0..self.around.len()).filter(|&vertex| !self.around[vertex].is_empty()) {
            numbers[vertex] = vertices.len();
            vertices.push(self.at(vertex));
            nodes.push(self.nodes[vertex].clone());
        }
        let face = |triangle: &[usize; 3]| Face::Triangle(triangle.map(|vertex| numbers[vertex]));
        let faces: Vec<Face> = self.triangles.iter().flatten().map(face).collect();
        let mesh = SurfaceMesh::new(vertices, &faces, self.mesh.plane().copied())?;
        Ok(Skin { mesh, nodes })
    }
}
