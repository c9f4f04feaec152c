//! Elasticity on a solid mesh: stiffness, mass, rigid-body motions, rows of displacement and of
//! stress.

use super::assembly::{Coupling, assemble};
use super::interpolation::{Interpolation, SolidShape};
use super::mesh::{SolidElement, SolidElementPoint, SolidMesh, determinant};
use crate::material::Material;
use crate::sparse::SparseVector;
use calyx_numerics::vec3::{cross, dot};
use faer::linalg::matmul::triangular::{BlockStructure, matmul};
use faer::sparse::SparseColMat;
use faer::{Accum, Mat, MatRef, Par};
use std::collections::BTreeMap;
use std::convert::Infallible;

/// Rows of stress. Stresses and strains are in the order xx, yy, zz, yz, zx, xy; the entries of a
/// node are its three displacements.
pub type StressRows = [SparseVector; 6];

/// Mesh with its material.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidModel {
    /// Mesh of the model.
    pub mesh: SolidMesh,
    /// Material of all elements.
    pub material: Material,
}

/// Shape functions at quadrature points.
struct Table {
    weights: Vec<f64>,
    /// Displacement shape functions, for each point.
    displacement: Vec<Vec<SolidShape>>,
    coordinate: Vec<Vec<SolidShape>>,
}

/// Interpolations of displacements and of coordinates.
type Kinds<'a> = (&'a Interpolation, &'a Interpolation);

impl SolidModel {
    /// Builds a model of one material.
    pub fn new(mesh: SolidMesh, material: Material) -> Self {
        Self { mesh, material }
    }

    /// Returns the number of displacements, three for each node.
    pub fn dof_count(&self) -> usize {
        self.mesh.dof_count()
    }

    /// Returns Lamé's constants: stress = lambda trace(strain) + 2 mu strain, Pa.
    pub fn lame(&self) -> [f64; 2] {
        let (e, nu) = (self.material.youngs_modulus, self.material.poissons_ratio);
        [e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 * e / (1.0 + nu)]
    }

    /// Assembles the stiffness in N/m; symmetric bit for bit, both triangles stored.
    pub fn stiffness(&self) -> SparseColMat<usize, f64> {
        let Ok(stiffness) = self.stiffness_until(|| Ok::<_, Infallible>(()));
        stiffness
    }

    /// Assembles the stiffness with a `checkpoint` before each block of elements.
    ///
    /// # Errors
    /// That of the checkpoint.
    pub fn stiffness_until<E>(
        &self,
        checkpoint: impl Fn() -> Result<(), E>,
    ) -> Result<SparseColMat<usize, f64>, E> {
        self.reduced_stiffness(&self.mesh, |_, matrix| matrix, checkpoint)
    }

    /// Assembles the stiffness of a subset of nodes that determine the others. `mesh` has those
    /// nodes; its elements correspond to the first ones of this model and list the nodes that they
    /// depend on. `reduced` converts the matrix of an element to these nodes: for each column node
    /// those of its row nodes, for each pair the column-major 3 by 3 block. There is a `checkpoint`
    /// before each block of elements.
    ///
    /// # Errors
    /// That of the checkpoint.
    pub fn reduced_stiffness<E>(
        &self,
        mesh: &SolidMesh,
        reduced: impl Fn(usize, Vec<f64>) -> Vec<f64> + Sync,
        checkpoint: impl Fn() -> Result<(), E>,
    ) -> Result<SparseColMat<usize, f64>, E> {
        // Exact for constant strain in curved elements, where a gradient times the Jacobian
        // determinant has degree p + 2 a - 1; exact for all strains in straight ones.
        let enough = |p: u8, a: u8| (p + 1).max((p + 2 * a).div_ceil(2));
        let tables = self.tables(|(displacement, coordinate)| {
            let ([p, q], [a, b]) = (displacement.highest(), coordinate.highest());
            [enough(p, a), enough(q, b)]
        });
        let matrix = |index: usize| {
            let element = &self.mesh.elements[index];
            reduced(index, self.element_stiffness(element, &tables[&element.kinds()]))
        };
        assemble(mesh, Coupling::Full, matrix, checkpoint)
    }

    /// Assembles the consistent mass in kg, with each axis coupled to itself only; symmetric bit
    /// for bit, both triangles stored.
    pub fn mass(&self) -> SparseColMat<usize, f64> {
        // The Jacobian determinant has degree 3 a - 1 in each coordinate of a hexahedron, and total
        // degree 3 a - 3 in a tetrahedron.
        let tables = self.tables(|(displacement, coordinate)| {
            let ([p, q], [a, b]) = (displacement.highest(), coordinate.highest());
            let enough = |p: u8, a: u8| (2 * p + 3 * a).div_ceil(2);
            match displacement.cell() {
                super::Cell::Hexahedron => [enough(p, a), enough(q, b)],
                super::Cell::Pentahedron | super::Cell::Tetrahedron => [enough(p, a) + 1, enough(q, b) + 1],
            }
        });
        let matrix = |index: usize| {
            let element = &self.mesh.elements[index];
            self.element_mass(element, &tables[&element.kinds()])
        };
        let Ok(mass) = assemble(&self.mesh, Coupling::SameAxis, matrix, || Ok::<_, Infallible>(()));
        mass
    }

    fn tables(&self, points: impl Fn(Kinds<'_>) -> [u8; 2]) -> BTreeMap<Kinds<'_>, Table> {
        let mut tables = BTreeMap::new();
        for element in &self.mesh.elements {
            let kinds = element.kinds();
            tables.entry(kinds).or_insert_with(|| {
                let rule = kinds.0.cell().quadrature(points(kinds).map(usize::from));
                let shapes =
                    |kind: &Interpolation| rule.iter().map(|(place, _)| kind.shapes(*place)).collect();
                Table {
                    weights: rule.iter().map(|(_, weight)| *weight).collect(),
                    displacement: shapes(kinds.0),
                    coordinate: shapes(kinds.1),
                }
            });
        }
        tables
    }

    /// Returns the stiffness of an element. With the sums over the points
    /// `H_ai,bj = w dN_i/da dN_j/db`, the block of nodes i and j is
    /// `lambda H_ai,bj + mu H_bi,aj + mu (H_xi,xj + H_yi,yj + H_zi,zj) delta_ab`.
    fn element_stiffness(&self, element: &SolidElement, table: &Table) -> Vec<f64> {
        let [lambda, mu] = self.lame();
        let count = element.nodes.len();
        // One column for each point, three rows for each node, times the square root of the weight:
        // H is this matrix times its transpose.
        let mut columns = Vec::with_capacity(3 * count * table.weights.len());
        for ((weight, displacement), coordinate) in
            table.weights.iter().zip(&table.displacement).zip(&table.coordinate)
        {
            let inverse = Inverse::new(self.mesh.jacobian_of(element, coordinate));
            let root = (weight * inverse.determinant).sqrt();
            let scaled = inverse.rows.map(|row| row.map(|part| part * root));
            for &[_, x, y, z] in displacement {
                columns.extend(scaled.map(|row| row[0] * x + row[1] * y + row[2] * z));
            }
        }
        let sums = products(&columns, 3 * count);
        let mut stiffness = vec![0.0; 9 * count * count];
        for j in 0..count {
            for i in j..count {
                // Within the block of a node with itself the upper triangle was not summed.
                let part = |a: usize, b: usize| {
                    if i == j && a < b { sums[(3 * i + b, 3 * i + a)] } else { sums[(3 * i + a, 3 * j + b)] }
                };
                let h: [[f64; 3]; 3] = std::array::from_fn(|a| std::array::from_fn(|b| part(a, b)));
                let shear = mu * (h[0][0] + h[1][1] + h[2][2]);
                for b in 0..3 {
                    for a in 0..3 {
                        let value = lambda * h[a][b] + mu * h[b][a] + if a == b { shear } else { 0.0 };
                        stiffness[9 * (j * count + i) + 3 * b + a] = value;
                        stiffness[9 * (i * count + j) + 3 * a + b] = value;
                    }
                }
            }
        }
        stiffness
    }

    fn element_mass(&self, element: &SolidElement, table: &Table) -> Vec<f64> {
        let count = element.nodes.len();
        // One column for each point, times the square root of the weight.
        let mut columns = Vec::with_capacity(count * table.weights.len());
        for ((weight, displacement), coordinate) in
            table.weights.iter().zip(&table.displacement).zip(&table.coordinate)
        {
            let volume = determinant(self.mesh.jacobian_of(element, coordinate));
            let root = (weight * volume * self.material.density).sqrt();
            columns.extend(displacement.iter().map(|shape| shape[0] * root));
        }
        let sums = products(&columns, count);
        let at = |row: usize, column: usize| sums[(row.max(column), row.min(column))];
        (0..count)
            .flat_map(|column| (0..count).map(move |row| (row, column)))
            .map(|(row, column)| at(row, column))
            .collect()
    }

    /// Returns the displacements of rigid-body motions: unit translations along x, y and z, then
    /// unit rotations about these axes through the origin, as full vectors.
    pub fn rigid_body_modes(&self) -> [Vec<f64>; 6] {
        std::array::from_fn(|mode| {
            let mut axis = [0.0; 3];
            axis[mode % 3] = 1.0;
            let of = |&node: &[f64; 3]| if mode < 3 { axis } else { cross(axis, node) };
            self.mesh.nodes.iter().flat_map(of).collect()
        })
    }

    /// Returns the row for the displacement at a point in a direction; also the load vector of a
    /// unit force there.
    pub fn displacement_row(&self, place: SolidElementPoint, direction: [f64; 3]) -> SparseVector {
        let element = &self.mesh.elements[place.element];
        let shapes = element.interpolation.shapes(place.local);
        let terms = element.nodes.iter().zip(&shapes).filter(|(_, shape)| shape[0] != 0.0);
        terms
            .flat_map(|(&node, shape)| (0..3).map(move |axis| (3 * node + axis, shape[0] * direction[axis])))
            .collect()
    }

    /// Returns the displacement at a point, from a full vector, m.
    pub fn displacement(&self, place: SolidElementPoint, displacements: &[f64]) -> [f64; 3] {
        let element = &self.mesh.elements[place.element];
        let mut sum = [0.0; 3];
        for (shape, &node) in element.interpolation.shapes(place.local).iter().zip(&element.nodes) {
            for axis in 0..3 {
                sum[axis] += shape[0] * displacements[3 * node + axis];
            }
        }
        sum
    }

    /// Returns the derivatives of the displacement shape functions of an element by x, y and z, in
    /// the order of its nodes.
    pub fn gradients(&self, place: SolidElementPoint) -> Vec<[f64; 3]> {
        let element = &self.mesh.elements[place.element];
        let inverse = Inverse::new(self.mesh.jacobian(place));
        element.interpolation.shapes(place.local).iter().map(|shape| inverse.gradient(shape)).collect()
    }

    /// Returns the element stresses (Pa) at a point, without smoothing, from a full vector.
    pub fn stress(&self, place: SolidElementPoint, displacements: &[f64]) -> [f64; 6] {
        let element = &self.mesh.elements[place.element];
        let mut gradient = [[0.0; 3]; 3];
        for (shape, &node) in self.gradients(place).iter().zip(&element.nodes) {
            for a in 0..3 {
                for b in 0..3 {
                    gradient[a][b] += displacements[3 * node + a] * shape[b];
                }
            }
        }
        self.stress_of(gradient)
    }

    /// Returns the stress of a displacement gradient `[axis of displacement][axis of derivative]`.
    pub fn stress_of(&self, g: [[f64; 3]; 3]) -> [f64; 6] {
        let [lambda, mu] = self.lame();
        let mean = lambda * (g[0][0] + g[1][1] + g[2][2]);
        let direct = |a: usize| mean + 2.0 * mu * g[a][a];
        let shear = |a: usize, b: usize| mu * (g[a][b] + g[b][a]);
        [direct(0), direct(1), direct(2), shear(1, 2), shear(2, 0), shear(0, 1)]
    }

    /// Returns the rows for the element stresses (Pa) at a point, without smoothing.
    pub fn stress_rows(&self, place: SolidElementPoint) -> StressRows {
        let element = &self.mesh.elements[place.element];
        let gradients = self.gradients(place);
        let terms = element.nodes.iter().copied().zip(gradients).collect::<Vec<_>>();
        std::array::from_fn(|part| self.stress_row(&terms, UNIT_TENSORS[part]))
    }

    /// Returns the row for `stress : tensor` (tensor symmetric), where the displacement gradient is
    /// the sum over the terms of the node's displacement times the vector. A node may occur several
    /// times.
    pub(super) fn stress_row(&self, terms: &[(usize, [f64; 3])], tensor: [[f64; 3]; 3]) -> SparseVector {
        let [lambda, mu] = self.lame();
        let trace = tensor[0][0] + tensor[1][1] + tensor[2][2];
        let row = |&(node, gradient): &(usize, [f64; 3])| {
            [0, 1, 2].map(|axis| {
                (3 * node + axis, lambda * trace * gradient[axis] + 2.0 * mu * dot(tensor[axis], gradient))
            })
        };
        terms.iter().flat_map(row).collect()
    }
}

/// Symmetric tensors that extract xx, yy, zz, yz, zx, xy from a stress.
const UNIT_TENSORS: [[[f64; 3]; 3]; 6] = [
    [[1.0, 0.0, 0.0], [0.0; 3], [0.0; 3]],
    [[0.0; 3], [0.0, 1.0, 0.0], [0.0; 3]],
    [[0.0; 3], [0.0; 3], [0.0, 0.0, 1.0]],
    [[0.0; 3], [0.0, 0.0, 0.5], [0.0, 0.5, 0.0]],
    [[0.0, 0.0, 0.5], [0.0; 3], [0.5, 0.0, 0.0]],
    [[0.0, 0.5, 0.0], [0.5, 0.0, 0.0], [0.0; 3]],
];

impl SolidElement {
    pub(super) fn kinds(&self) -> Kinds<'_> {
        (&self.interpolation, &self.coordinate_interpolation)
    }
}

/// Returns the lower triangle of a matrix times its transpose; the matrix is given column by
/// column.
fn products(columns: &[f64], rows: usize) -> Mat<f64> {
    let matrix = MatRef::from_column_major_slice(columns, rows, columns.len() / rows);
    let mut products = Mat::zeros(rows, rows);
    matmul(
        products.as_mut(),
        BlockStructure::TriangularLower,
        Accum::Replace,
        matrix,
        BlockStructure::Rectangular,
        matrix.transpose(),
        BlockStructure::Rectangular,
        1.0,
        Par::Seq,
    );
    products
}

/// Transposed inverse of a Jacobian: converts local derivatives to those by x, y and z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inverse {
    pub rows: [[f64; 3]; 3],
    pub determinant: f64,
}

impl Inverse {
    pub fn new([x, y, z]: [[f64; 3]; 3]) -> Self {
        let cofactors = [cross(y, z), cross(z, x), cross(x, y)];
        let determinant = dot(x, cofactors[0]);
        Self { rows: cofactors.map(|row| row.map(|part| part / determinant)), determinant }
    }

    pub fn gradient(&self, &[_, x, y, z]: &SolidShape) -> [f64; 3] {
        self.rows.map(|row| row[0] * x + row[1] * y + row[2] * z)
    }
}
