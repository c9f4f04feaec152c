//! Checks of surface meshes: a mesh must enclose a body, with normals that point into the fluid.

use crate::error::AcousticError;
use crate::plane::RigidPlane;
use calyx_numerics::vec3::{Vector, cross, dot, length, minus};
use std::collections::HashMap;

/// Distance below which two vertices coincide, relative to the size of the mesh.
const COINCIDENT: f64 = 1e-9;
/// Height of a triangle below which it is degenerate, relative to its longest edge.
const DEGENERATE: f64 = 1e-6;

/// Triangles of a face: its index, and the vertices of each triangle.
pub(crate) struct Surface<'m> {
    pub vertices: &'m [Vector],
    pub triangles: &'m [[usize; 3]],
    /// Index of the face of each triangle.
    pub faces: &'m [usize],
    pub plane: Option<&'m RigidPlane>,
}

/// Returns the length of the diagonal of the bounding box.
pub(crate) fn size(vertices: &[Vector]) -> f64 {
    let mut box_ = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for vertex in vertices {
        for axis in 0..3 {
            box_[0][axis] = box_[0][axis].min(vertex[axis]);
            box_[1][axis] = box_[1][axis].max(vertex[axis]);
        }
    }
    length(minus(box_[1], box_[0]))
}

impl Surface<'_> {
    /// Checks positions, shape of the elements, connectivity and orientation.
    pub fn check(&self) -> Result<(), AcousticError> {
        if self.triangles.is_empty() {
            return Err(AcousticError::mesh("mesh", "it has no elements", "pass at least four triangles"));
        }
        self.positions()?;
        self.coincident_vertices()?;
        self.shapes()?;
        let neighbours = self.edges()?;
        self.fans()?;
        self.orientation(&neighbours)
    }

    fn place(&self, triangle: usize) -> String {
        format!("element {}", self.faces[triangle])
    }

    /// Every vertex is finite, belongs to an element, and is in front of the rigid plane.
    fn positions(&self) -> Result<(), AcousticError> {
        let tolerance = COINCIDENT * size(self.vertices);
        for (index, vertex) in self.vertices.iter().enumerate() {
            let place = || format!("vertex {index}");
            if !vertex.iter().all(|x| x.is_finite()) {
                let message = format!("the position {vertex:?} is not finite");
                return Err(AcousticError::mesh(place(), message, "correct the coordinates"));
            }
            let depth = self.plane.map_or(0.0, |plane| -plane.distance(*vertex));
            if depth > tolerance {
                return Err(AcousticError::mesh(
                    place(),
                    format!("it lies {depth:.3e} m behind the rigid plane"),
                    "move the plane, or cut the mesh at the plane",
                ));
            }
        }
        let mut used = vec![false; self.vertices.len()];
        self.triangles.iter().flatten().for_each(|&vertex| used[vertex] = true);
        match used.iter().position(|used| !used) {
            Some(index) => Err(AcousticError::mesh(
                format!("vertex {index}"),
                "it belongs to no element",
                "remove vertices without elements",
            )),
            None => Ok(()),
        }
    }

    fn coincident_vertices(&self) -> Result<(), AcousticError> {
        let tolerance = COINCIDENT * size(self.vertices);
        let mut order: Vec<usize> = (0..self.vertices.len()).collect();
        order.sort_by(|a, b| self.vertices[*a][0].total_cmp(&self.vertices[*b][0]).then(a.cmp(b)));
        for (at, &first) in order.iter().enumerate() {
            let near = order[at + 1..]
                .iter()
                .take_while(|&&other| self.vertices[other][0] - self.vertices[first][0] <= tolerance);
            for &second in near {
                if length(minus(self.vertices[first], self.vertices[second])) <= tolerance {
                    let (low, high) = (first.min(second), first.max(second));
                    return Err(AcousticError::mesh(
                        format!("vertices {low} and {high}"),
                        "both are at the same position",
                        "merge coincident vertices",
                    ));
                }
            }
        }
        Ok(())
    }

    fn shapes(&self) -> Result<(), AcousticError> {
        let tolerance = COINCIDENT * size(self.vertices);
        for (index, triangle) in self.triangles.iter().enumerate() {
            let [a, b, c] = triangle.map(|vertex| self.vertices[vertex]);
            let edges = [minus(b, a), minus(c, b), minus(a, c)];
            let longest = edges.map(length).into_iter().fold(0.0, f64::max);
            let height = length(cross(edges[0], edges[1])) / longest;
            if height.is_nan() || height < DEGENERATE * longest {
                return Err(AcousticError::mesh(
                    self.place(index),
                    "it has no area",
                    "remove the element, or correct its vertices",
                ));
            }
            let on_plane = |at: Vector| self.plane.is_some_and(|p| p.distance(at).abs() <= tolerance);
            if [a, b, c].into_iter().all(on_plane) {
                return Err(AcousticError::mesh(
                    self.place(index),
                    "it lies in the rigid plane, so no fluid is in front of it",
                    "remove the element, or move the plane",
                ));
            }
        }
        Ok(())
    }

    /// Every edge belongs to two triangles that traverse it in opposite directions, or to one if it
    /// lies in the rigid plane. Returns the triangles behind each directed edge.
    fn edges(&self) -> Result<HashMap<[usize; 2], usize>, AcousticError> {
        let tolerance = COINCIDENT * size(self.vertices);
        let mut count: HashMap<[usize; 2], usize> = HashMap::new();
        let mut owner: HashMap<[usize; 2], usize> = HashMap::new();
        let edges = |triangle: &[usize; 3]| {
            let [a, b, c] = *triangle;
            [[a, b], [b, c], [c, a]]
        };
        for triangle in self.triangles {
            for [a, b] in edges(triangle) {
                *count.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
        for (index, triangle) in self.triangles.iter().enumerate() {
            for [a, b] in edges(triangle) {
                let uses = count[&[a.min(b), a.max(b)]];
                let edge = format!("the edge between the vertices {a} and {b}");
                let on_plane = |vertex: usize| {
                    self.plane.is_some_and(|p| p.distance(self.vertices[vertex]).abs() <= tolerance)
                };
                if uses == 1 && !(on_plane(a) && on_plane(b)) {
                    return Err(AcousticError::mesh(
                        self.place(index),
                        format!("{edge} belongs to no other element: the surface is open"),
                        "close the opening with elements, or merge the vertices along it",
                    ));
                }
                if uses > 2 {
                    return Err(AcousticError::mesh(
                        self.place(index),
                        format!("{edge} belongs to {uses} elements"),
                        "keep the two elements between the fluid and the body",
                    ));
                }
                if let Some(other) = owner.insert([a, b], index) {
                    return Err(AcousticError::mesh(
                        self.place(index),
                        format!("its normal is opposite to that of element {}", self.faces[other]),
                        "reverse the order of the vertices of one of them",
                    ));
                }
            }
        }
        Ok(owner)
    }

    /// The triangles at a vertex form one fan: surfaces do not touch in a single vertex.
    fn fans(&self) -> Result<(), AcousticError> {
        let mut around: Vec<Vec<usize>> = vec![Vec::new(); self.vertices.len()];
        for (index, triangle) in self.triangles.iter().enumerate() {
            triangle.iter().for_each(|&vertex| around[vertex].push(index));
        }
        for (vertex, triangles) in around.iter().enumerate() {
            let mut reached = vec![triangles[0]];
            let mut at = 0;
            while let Some(&current) = reached.get(at) {
                at += 1;
                for &other in triangles {
                    let shared = self.triangles[other]
                        .iter()
                        .filter(|v| **v != vertex && self.triangles[current].contains(v));
                    if shared.count() > 0 && !reached.contains(&other) {
                        reached.push(other);
                    }
                }
            }
            if reached.len() < triangles.len() {
                return Err(AcousticError::mesh(
                    format!("vertex {vertex}"),
                    "two parts of the surface touch in this vertex only",
                    "separate the parts, or connect them along an edge",
                ));
            }
        }
        Ok(())
    }

    /// Every connected part of the surface encloses a positive volume, so its normals point out.
    fn orientation(&self, owner: &HashMap<[usize; 2], usize>) -> Result<(), AcousticError> {
        let origin = self.plane.map_or(self.vertices[0], RigidPlane::point);
        let mut part = vec![usize::MAX; self.triangles.len()];
        for start in 0..self.triangles.len() {
            if part[start] != usize::MAX {
                continue;
            }
            let mut volume = 0.0;
            let mut stack = vec![start];
            part[start] = start;
            while let Some(index) = stack.pop() {
                let [a, b, c] = self.triangles[index];
                let [p, q, r] = [a, b, c].map(|vertex| minus(self.vertices[vertex], origin));
                volume += dot(p, cross(q, r)) / 6.0;
                for edge in [[b, a], [c, b], [a, c]] {
                    if let Some(&other) = owner.get(&edge)
                        && part[other] == usize::MAX
                    {
                        part[other] = start;
                        stack.push(other);
                    }
                }
            }
            if volume <= 0.0 {
                return Err(AcousticError::mesh(
                    self.place(start),
                    "the normals of its connected surface point into the body",
                    "reverse the order of the vertices of all its elements, or remove a surface inside of the body",
                ));
            }
        }
        Ok(())
    }
}
