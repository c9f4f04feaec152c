//! Elasticity on a plane mesh, per unit of face width: stiffness, mass, rows of displacement and of
//! stress.

use super::interpolation::{ElementOrder, Shape};
use super::mesh::{Element, ElementPoint, PlaneMesh};
use super::sparse::{SparseVector, summed};
use crate::material::{Material, Plane};
use calyx_numerics::quadrature::gauss_legendre;
use faer::sparse::SparseColMat;
use std::collections::BTreeMap;

/// Mesh with its material.
#[derive(Clone, Debug, PartialEq)]
pub struct PlaneModel {
    /// Mesh of the model.
    pub mesh: PlaneMesh,
    /// Material of all elements.
    pub material: Material,
    /// Plane stress or plane strain.
    pub plane: Plane,
}

/// Quadrature point: weight, displacement shape functions, coordinate shape functions.
struct Tabulated {
    weight: f64,
    displacement: Vec<Shape>,
    coordinate: Vec<Shape>,
}

impl PlaneModel {
    /// Builds a model of one material.
    pub fn new(mesh: PlaneMesh, material: Material, plane: Plane) -> Self {
        Self { mesh, material, plane }
    }

    /// Returns the number of displacements, two for each node.
    pub fn dof_count(&self) -> usize {
        self.mesh.dof_count()
    }

    /// Returns `[D11, D12, D33]` of the isotropic law: stress xx = D11 e_xx + D12 e_yy, xy = D33
    /// g_xy, Pa.
    pub fn elasticity(&self) -> [f64; 3] {
        let (e, nu) = (self.material.youngs_modulus, self.material.poissons_ratio);
        let direct = match self.plane {
            Plane::Strain => [1.0 - nu, nu].map(|part| part * e / ((1.0 + nu) * (1.0 - 2.0 * nu))),
            Plane::Stress => [1.0, nu].map(|part| part * e / (1.0 - nu * nu)),
        };
        [direct[0], direct[1], 0.5 * e / (1.0 + nu)]
    }

    /// Assembles the global stiffness in N/m per metre of face width; symmetric bit for bit, both
    /// triangles stored.
    pub fn stiffness(&self) -> SparseColMat<usize, f64> {
        self.assemble(
            |element| element.order.highest().max(element.coordinate_order.highest()) + 1,
            |table, element| self.element_stiffness(element, table),
        )
    }

    /// Assembles the consistent mass in kg per metre of face width, stored like the stiffness.
    pub fn mass(&self) -> SparseColMat<usize, f64> {
        // The integrand has degree 2p + 2q - 1 in each direction, p and q the orders of
        // displacements and coordinates.
        self.assemble(
            |element| element.order.highest() + element.coordinate_order.highest(),
            |table, element| self.element_mass(element, table),
        )
    }

    /// Returns the number of entries of all element matrices.
    fn entries(&self) -> usize {
        self.mesh.elements.iter().map(|element| (2 * element.nodes.len()).pow(2)).sum()
    }

    /// Returns the largest memory to assemble a matrix, bytes: its entries with their rows and
    /// columns, and half as much to sort them.
    pub fn assembly_memory(&self) -> u64 {
        (self.entries() * size_of::<(usize, usize, f64)>() * 3 / 2) as u64
    }

    /// Sums element matrices (row-major, unknowns of a node adjacent) into a sparse one, in a fixed
    /// order.
    fn assemble(
        &self,
        points_across: impl Fn(&Element) -> u8,
        matrix: impl Fn(&[Tabulated], &Element) -> Vec<f64>,
    ) -> SparseColMat<usize, f64> {
        let mut tables = BTreeMap::<(ElementOrder, ElementOrder), Vec<Tabulated>>::new();
        let mut entries = Vec::with_capacity(self.entries());
        for element in &self.mesh.elements {
            let table = tables
                .entry((element.order, element.coordinate_order))
                .or_insert_with(|| tabulate(element, usize::from(points_across(element))));
            let dofs = element.nodes.iter().flat_map(|&node| [2 * node, 2 * node + 1]).collect::<Vec<_>>();
            let values = matrix(table, element);
            for (&row, values) in dofs.iter().zip(values.chunks(dofs.len())) {
                entries.extend(dofs.iter().zip(values).map(|(&column, &value)| (column, row, value)));
            }
        }
        summed(self.dof_count(), entries)
    }

    fn element_stiffness(&self, element: &Element, table: &[Tabulated]) -> Vec<f64> {
        let [d11, d12, d33] = self.elasticity();
        let size = 2 * element.nodes.len();
        let mut stiffness = vec![0.0; size * size];
        for point in table {
            let (_, jacobian) = self.mesh.map_with(element, &point.coordinate);
            let (gradients, area) = gradients(&point.displacement, jacobian);
            let weight = point.weight * area;
            for (i, [ax, ay]) in gradients.iter().enumerate() {
                for (j, [bx, by]) in gradients.iter().enumerate().skip(i) {
                    let block = [
                        [d11 * ax * bx + d33 * ay * by, d12 * ax * by + d33 * ay * bx],
                        [d12 * ay * bx + d33 * ax * by, d11 * ay * by + d33 * ax * bx],
                    ];
                    for a in 0..2 {
                        for b in 0..2 {
                            stiffness[(2 * i + a) * size + 2 * j + b] += weight * block[a][b];
                        }
                    }
                }
            }
        }
        for row in 0..size {
            for column in 0..row {
                stiffness[row * size + column] = stiffness[column * size + row];
            }
        }
        stiffness
    }

    fn element_mass(&self, element: &Element, table: &[Tabulated]) -> Vec<f64> {
        let size = 2 * element.nodes.len();
        let mut mass = vec![0.0; size * size];
        for point in table {
            let (_, jacobian) = self.mesh.map_with(element, &point.coordinate);
            let weight = point.weight * determinant(jacobian) * self.material.density;
            for (i, a) in point.displacement.iter().enumerate() {
                for (j, b) in point.displacement.iter().enumerate() {
                    // The product of the shape functions comes first, so that the matrix is
                    // symmetric to the bit.
                    let value = weight * (a[0] * b[0]);
                    mass[2 * i * size + 2 * j] += value;
                    mass[(2 * i + 1) * size + 2 * j + 1] += value;
                }
            }
        }
        mass
    }

    /// Returns the row for the displacement at a point in a direction; also the load vector of a
    /// unit force there.
    pub fn displacement_row(&self, place: ElementPoint, direction: [f64; 2]) -> SparseVector {
        let element = &self.mesh.elements[place.element];
        let shapes = element.order.shapes(place.xi, place.eta);
        let terms = element.nodes.iter().zip(&shapes).filter(|(_, shape)| shape[0] != 0.0);
        terms
            .flat_map(|(&node, shape)| (0..2).map(move |axis| (2 * node + axis, shape[0] * direction[axis])))
            .collect()
    }

    /// Returns the displacement at a point, from a full vector.
    pub fn displacement(&self, place: ElementPoint, displacements: &[f64]) -> [f64; 2] {
        [[1.0, 0.0], [0.0, 1.0]].map(|axis| self.displacement_row(place, axis).dot(displacements))
    }

    /// Returns the rows for the element stresses xx, yy, xy (Pa) at a point, without smoothing.
    pub fn stress_rows(&self, place: ElementPoint) -> [SparseVector; 3] {
        let [d11, d12, d33] = self.elasticity();
        let element = &self.mesh.elements[place.element];
        let shapes = element.order.shapes(place.xi, place.eta);
        let (gradients, _) = gradients(&shapes, self.mesh.jacobian(place));
        let rows = [(d11, d12, 0.0), (d12, d11, 0.0), (0.0, 0.0, d33)];
        rows.map(|(from_xx, from_yy, from_xy)| {
            let terms = element.nodes.iter().zip(&gradients);
            terms
                .flat_map(|(&node, [dx, dy])| {
                    [(2 * node, from_xx * dx + from_xy * dy), (2 * node + 1, from_yy * dy + from_xy * dx)]
                })
                .collect()
        })
    }

    /// Returns the stresses xx, yy, xy (Pa) at a point, from a full displacement vector.
    pub fn stress(&self, place: ElementPoint, displacements: &[f64]) -> [f64; 3] {
        self.stress_rows(place).map(|row| row.dot(displacements))
    }

    /// Returns unit translations along x and y, and the rotation by 1 rad about the origin, as full
    /// vectors.
    pub fn rigid_body_modes(&self) -> [Vec<f64>; 3] {
        let nodes = || self.mesh.nodes.iter();
        [
            nodes().flat_map(|_| [1.0, 0.0]).collect(),
            nodes().flat_map(|_| [0.0, 1.0]).collect(),
            nodes().flat_map(|[x, y]| [-y, *x]).collect(),
        ]
    }
}

/// Returns the principal stresses, the larger first, from the stresses xx, yy, xy.
pub fn principal_stresses([xx, yy, xy]: [f64; 3]) -> [f64; 2] {
    let (mean, radius) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    [mean + radius, mean - radius]
}

fn tabulate(element: &Element, points_across: usize) -> Vec<Tabulated> {
    let rule = gauss_legendre(points_across);
    let mut table = Vec::with_capacity(rule.len() * rule.len());
    for (eta, eta_weight) in &rule {
        for (xi, xi_weight) in &rule {
            table.push(Tabulated {
                weight: xi_weight * eta_weight,
                displacement: element.order.shapes(*xi, *eta),
                coordinate: element.coordinate_order.shapes(*xi, *eta),
            });
        }
    }
    table
}

fn determinant([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    a * d - b * c
}

/// Returns the derivatives of the shape functions by x and y, and the Jacobian determinant.
pub(super) fn gradients(shapes: &[Shape], jacobian: [[f64; 2]; 2]) -> (Vec<[f64; 2]>, f64) {
    let area = determinant(jacobian);
    let [[x_xi, x_eta], [y_xi, y_eta]] = jacobian;
    let gradient = |&[_, d_xi, d_eta]: &Shape| {
        [(y_eta * d_xi - y_xi * d_eta) / area, (x_xi * d_eta - x_eta * d_xi) / area]
    };
    (shapes.iter().map(gradient).collect(), area)
}
