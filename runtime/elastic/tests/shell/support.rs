//! Meshes and assembly for tests of shells.

use calyx_elastic::model::{Material, ShellShape};
use calyx_elastic::shell::{
    DirectorNode, DirectorShape, DirectorShell, Integration, ShellElement, mass, stiffness,
};
use calyx_fe::solve::{Constraints, Solver};
use calyx_fe::sparse::summed;
use nalgebra::{DMatrix, DVector, Matrix3};
use std::collections::BTreeMap;

pub const SHAPES: [ShellShape; 5] = [
    ShellShape::Triangle3,
    ShellShape::Triangle6,
    ShellShape::Quadrilateral4,
    ShellShape::Quadrilateral8,
    ShellShape::Quadrilateral9,
];

/// Isotropic material.
pub fn material(youngs_modulus: f64, poissons_ratio: f64, density: f64) -> Material {
    Material {
        youngs_modulus,
        poissons_ratio,
        shear_modulus: 0.5 * youngs_modulus / (1.0 + poissons_ratio),
        density,
        structural_damping: 0.0,
    }
}

/// Shell mesh of one shape.
pub struct Mesh {
    pub shape: ShellShape,
    pub positions: Vec<[f64; 3]>,
    /// Parameters of the nodes, 0 to 1.
    pub parameters: Vec<[f64; 2]>,
    pub elements: Vec<Vec<usize>>,
}

/// Returns `count + 1` equally spaced values of 0 ..= 1.
pub fn uniform(count: usize) -> Vec<f64> {
    (0..=count).map(|k| k as f64 / count as f64).collect()
}

/// Nodes by their parameters, numbered in the order of their first use.
struct Numbering<'a> {
    known: BTreeMap<[i64; 2], usize>,
    parameters: Vec<[f64; 2]>,
    bend: &'a dyn Fn([f64; 2]) -> [f64; 2],
}

impl Numbering<'_> {
    fn node(&mut self, at: [f64; 2]) -> usize {
        let key = at.map(|x| (x * 1e9).round() as i64);
        let (next, bend) = (self.parameters.len(), self.bend);
        let parameters = &mut self.parameters;
        *self.known.entry(key).or_insert_with(|| {
            parameters.push(bend(at));
            next
        })
    }
}

/// Returns the corners of the elements of a grid; cells are divided along one diagonal.
fn cells(triangles: bool, u: &[f64], v: &[f64]) -> Vec<Vec<[f64; 2]>> {
    let mut cells = Vec::new();
    for rows in v.windows(2) {
        for columns in u.windows(2) {
            let [a, b, c, d] =
                [[columns[0], rows[0]], [columns[1], rows[0]], [columns[1], rows[1]], [columns[0], rows[1]]];
            if triangles {
                cells.extend([vec![a, b, c], vec![a, c, d]]);
            } else {
                cells.push(vec![a, b, c, d]);
            }
        }
    }
    cells
}

/// Interpolates from the corners of a cell.
fn within(corners: &[[f64; 2]], at: [f64; 2]) -> [f64; 2] {
    let [x, y] = at;
    let weights = if corners.len() == 3 {
        vec![1.0 - x - y, x, y]
    } else {
        let (f, g) = ([0.5 * (1.0 - x), 0.5 * (1.0 + x)], [0.5 * (1.0 - y), 0.5 * (1.0 + y)]);
        vec![f[0] * g[0], f[1] * g[0], f[1] * g[1], f[0] * g[1]]
    };
    let sum = |axis: usize| corners.iter().zip(&weights).map(|(corner, weight)| corner[axis] * weight).sum();
    [sum(0), sum(1)]
}

impl Mesh {
    /// Meshes the image of the unit square with elements between the lines `u` and `v`. `map` gives
    /// positions.
    pub fn grid(shape: ShellShape, u: &[f64], v: &[f64], map: impl Fn([f64; 2]) -> [f64; 3]) -> Self {
        let mut numbering = Numbering { known: BTreeMap::new(), parameters: Vec::new(), bend: &|at| at };
        let elements = cells(shape.is_triangle(), u, v)
            .into_iter()
            .map(|corners| {
                let nodes = shape.node_coordinates();
                nodes.into_iter().map(|at| numbering.node(within(&corners, at))).collect()
            })
            .collect();
        let positions = numbering.parameters.iter().map(|at| map(*at)).collect();
        Self { shape, positions, parameters: numbering.parameters, elements }
    }

    /// Moves the corners by `shift` and places all other nodes between them.
    pub fn straight(mut self, shift: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        let corners = self.shape.corner_count();
        let mut moved = vec![None; self.positions.len()];
        for element in &self.elements {
            let positions =
                element[..corners].iter().map(|&node| shift(self.positions[node])).collect::<Vec<_>>();
            for (&node, at) in element.iter().zip(self.shape.node_coordinates()) {
                let axis = |axis: usize| {
                    within(&positions.iter().map(|p| [p[axis], 0.0]).collect::<Vec<_>>(), at)[0]
                };
                moved[node] = Some([axis(0), axis(1), axis(2)]);
            }
        }
        self.positions = moved.into_iter().map(Option::unwrap).collect();
        self
    }

    /// Returns the nodes whose parameters satisfy a condition.
    pub fn nodes(&self, condition: impl Fn([f64; 2]) -> bool) -> Vec<usize> {
        (0..self.positions.len()).filter(|&node| condition(self.parameters[node])).collect()
    }

    /// Returns the node nearest to a parameter.
    pub fn node(&self, [u, v]: [f64; 2]) -> usize {
        let distance = |node: &usize| (self.parameters[*node][0] - u).hypot(self.parameters[*node][1] - v);
        (0..self.positions.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap()
    }

    /// Returns nodes and positions of each element.
    pub fn each(&self) -> impl Iterator<Item = (&[usize], Vec<[f64; 3]>)> {
        self.elements
            .iter()
            .map(|nodes| (nodes.as_slice(), nodes.iter().map(|&node| self.positions[node]).collect()))
    }
}

/// Stiffness, mass and load over six components per node.
#[derive(Default)]
pub struct Model {
    /// Axes of each node: components refer to them.
    pub axes: Vec<Matrix3<f64>>,
    pub stiffness: Vec<(usize, usize, f64)>,
    pub mass: Vec<(usize, usize, f64)>,
    pub load: Vec<f64>,
    pub constraints: Constraints,
}

impl Model {
    pub fn new(nodes: usize) -> Self {
        Self { axes: vec![Matrix3::identity(); nodes], load: vec![0.0; 6 * nodes], ..Self::default() }
    }

    /// Builds the model of a mesh of constant thickness.
    pub fn of_mesh(mesh: &Mesh, thickness: f64, offset: f64, material: &Material) -> Self {
        let mut model = Self::new(mesh.positions.len());
        model.add_mesh(mesh, thickness, offset, material);
        model
    }

    pub fn add_mesh(&mut self, mesh: &Mesh, thickness: f64, offset: f64, material: &Material) {
        let thickness = vec![thickness; mesh.shape.corner_count()];
        for (nodes, positions) in mesh.each() {
            let element = ShellElement {
                shape: mesh.shape,
                positions: &positions,
                thickness: &thickness,
                offset,
                material,
                added_mass: 0.0,
            };
            self.add_stiffness(nodes, stiffness(&element).unwrap());
            if material.density > 0.0 {
                self.add_mass(nodes, mass(&element).unwrap());
            }
        }
    }

    /// Returns a matrix in the axes of the nodes.
    fn rotated(&self, nodes: &[usize], mut matrix: DMatrix<f64>) -> DMatrix<f64> {
        for (index, &node) in nodes.iter().enumerate() {
            if self.axes[node] != Matrix3::identity() {
                for part in [6 * index, 6 * index + 3] {
                    let columns = matrix.columns(part, 3) * self.axes[node];
                    matrix.columns_mut(part, 3).copy_from(&columns);
                    let rows = self.axes[node].transpose() * matrix.rows(part, 3);
                    matrix.rows_mut(part, 3).copy_from(&rows);
                }
            }
        }
        matrix
    }

    pub fn add_stiffness(&mut self, nodes: &[usize], matrix: DMatrix<f64>) {
        let matrix = self.rotated(nodes, matrix);
        Self::add(&mut self.stiffness, nodes, &matrix);
    }

    pub fn add_mass(&mut self, nodes: &[usize], matrix: DMatrix<f64>) {
        let matrix = self.rotated(nodes, matrix);
        Self::add(&mut self.mass, nodes, &matrix);
    }

    fn add(entries: &mut Vec<(usize, usize, f64)>, nodes: &[usize], matrix: &DMatrix<f64>) {
        let dof = |index: usize| 6 * nodes[index / 6] + index % 6;
        for column in 0..matrix.ncols() {
            let values = (0..matrix.nrows()).map(|row| (dof(column), dof(row), matrix[(row, column)]));
            entries.extend(values.filter(|entry| entry.2 != 0.0));
        }
    }

    /// Adds a load in basic axes.
    pub fn add_load(&mut self, nodes: &[usize], load: &DVector<f64>) {
        for (index, &node) in nodes.iter().enumerate() {
            for part in [0, 3] {
                let own = self.axes[node].transpose() * load.rows(6 * index + part, 3);
                (0..3).for_each(|axis| self.load[6 * node + part + axis] += own[axis]);
            }
        }
    }

    pub fn fix(&mut self, node: usize, components: &[usize]) {
        for component in components {
            self.constraints.prescribe(6 * node + component, 0.0);
        }
    }

    pub fn fix_all(&mut self, nodes: &[usize], components: &[usize]) {
        nodes.iter().for_each(|&node| self.fix(node, components));
    }

    /// Returns the displacements in the axes of the nodes.
    pub fn solve(&self) -> Vec<f64> {
        self.try_solve().unwrap()
    }

    /// Returns the displacements as [`Model::solve`]; `None` if the stiffness is singular.
    pub fn try_solve(&self) -> Option<Vec<f64>> {
        self.solver()?.solve_one(&self.load).ok()
    }

    /// Factorizes the stiffness; `None` if it is singular.
    pub fn solver(&self) -> Option<Solver> {
        let stiffness = summed(self.load.len(), self.stiffness.clone());
        Solver::new(&stiffness, self.constraints.clone()).ok()
    }

    /// Returns stiffness times displacements.
    pub fn forces(&self, displacements: &[f64]) -> Vec<f64> {
        product(&self.stiffness, displacements)
    }
}

pub fn product(entries: &[(usize, usize, f64)], vector: &[f64]) -> Vec<f64> {
    let mut result = vec![0.0; vector.len()];
    entries.iter().for_each(|&(column, row, value)| result[row] += value * vector[column]);
    result
}

/// Mesh of report elements.
pub struct DirectorMesh {
    pub nodes: Vec<DirectorNode>,
    pub parameters: Vec<[f64; 2]>,
    pub elements: Vec<(DirectorShape, Vec<usize>)>,
}

impl DirectorMesh {
    /// Meshes the image of the unit square; `map` gives the node at parameters.
    pub fn grid(
        triangles: bool,
        order: u8,
        u: &[f64],
        v: &[f64],
        map: impl Fn([f64; 2]) -> DirectorNode,
    ) -> Self {
        let shape =
            if triangles { DirectorShape::Triangle(order) } else { DirectorShape::Quadrilateral(order) };
        let mut numbering = Numbering { known: BTreeMap::new(), parameters: Vec::new(), bend: &|at| at };
        let elements = cells(triangles, u, v)
            .into_iter()
            .map(|corners| {
                let places = places(shape);
                (shape, places.into_iter().map(|at| numbering.node(within(&corners, at))).collect())
            })
            .collect();
        let nodes = numbering.parameters.iter().map(|at| map(*at)).collect();
        Self { nodes, parameters: numbering.parameters, elements }
    }

    /// Moves the corners by `shift` and places all other nodes between them.
    pub fn straighten(&mut self, shift: impl Fn([f64; 3]) -> [f64; 3]) {
        let before = self.nodes.clone();
        for (shape, nodes) in &self.elements {
            let moved = corners(*shape).into_iter().map(|corner| shift(before[nodes[corner]].position));
            let moved = moved.collect::<Vec<_>>();
            for (&node, at) in nodes.iter().zip(places(*shape)) {
                self.nodes[node].position = std::array::from_fn(|axis| {
                    within(&moved.iter().map(|p| [p[axis], 0.0]).collect::<Vec<_>>(), at)[0]
                });
            }
        }
    }

    pub fn nodes_where(&self, condition: impl Fn([f64; 2]) -> bool) -> Vec<usize> {
        (0..self.nodes.len()).filter(|&node| condition(self.parameters[node])).collect()
    }

    /// Calls a function with each element.
    pub fn each(
        &self,
        material: &Material,
        integration: Integration,
        mut call: impl FnMut(&[usize], &DirectorShell<'_>),
    ) {
        for (shape, indices) in &self.elements {
            let nodes = indices.iter().map(|&node| self.nodes[node]).collect::<Vec<_>>();
            call(indices, &DirectorShell { shape: *shape, nodes: &nodes, material, integration });
        }
    }
}

/// Returns the indices of the corners of a report element.
pub fn corners(shape: DirectorShape) -> Vec<usize> {
    match shape {
        DirectorShape::Quadrilateral(order) => {
            let n = usize::from(order);
            vec![0, n, n * (n + 2), n * (n + 1)]
        }
        DirectorShape::Triangle(order) => vec![0, usize::from(order), shape.node_count() - 1],
    }
}

/// Returns the local coordinates of the nodes of a report element.
pub fn places(shape: DirectorShape) -> Vec<[f64; 2]> {
    match shape {
        DirectorShape::Quadrilateral(order) => {
            let line = uniform(usize::from(order)).into_iter().map(|x| 2.0 * x - 1.0).collect::<Vec<_>>();
            line.iter().flat_map(|&y| line.iter().map(move |&x| [x, y])).collect()
        }
        DirectorShape::Triangle(order) => {
            let n = usize::from(order);
            let place = |i: usize| i as f64 / n as f64;
            (0..=n).flat_map(|j| (0..=n - j).map(move |i| [place(i), place(j)])).collect()
        }
    }
}

/// Asserts that a value agrees with a reference within a relative tolerance.
#[track_caller]
pub fn assert_close(value: f64, reference: f64, tolerance: f64, what: &str) {
    let error = (value / reference - 1.0).abs();
    assert!(error <= tolerance, "{what}: {value}, reference {reference}, relative difference {error:.2e}");
}
