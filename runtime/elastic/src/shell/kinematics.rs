//! Geometry and strains of a solid that is linear in its thickness coordinate zeta (degenerated
//! solid, Ahmad, Irons and Zienkiewicz 1970):
//!
//! `x = sum N (x_i + zeta h_i)` and `u = sum N (u_i + zeta w_i)`,
//!
//! where `h_i` is half of the thickness vector at a node and `w_i` the derivative of the
//! displacement by zeta. Columns of strain rows are `u_i` and `w_i` of each node in turn.

use super::interpolation::Shape;
use crate::error::ElementError;
use crate::model::Material;
use calyx_numerics::vec3::{cross, dot, length, minus, plus, scaled, unit};
use nalgebra::{DMatrix, Matrix3, Matrix5, SMatrix};

/// Ratio of the shear stiffness of a section to that of uniform shear stress (Reissner 1945).
pub(super) const SHEAR_FACTOR: f64 = 5.0 / 6.0;

/// Strains in the order 11, 22, 12, 13, 23; shear strains are twice the tensor components.
pub(super) const STRAINS: usize = 5;

/// Vectors along three directions.
pub(super) type Basis = [[f64; 3]; 3];

/// Nodes of the reference surface.
pub(super) struct Geometry {
    /// Positions at zeta = 0, m.
    pub middle: Vec<[f64; 3]>,
    /// Halves of the thickness vectors, m.
    pub half: Vec<[f64; 3]>,
}

/// Shape functions at a point of the surface.
#[derive(Clone)]
pub(super) struct Sample {
    /// Of the positions.
    pub position: Vec<Shape>,
    /// Of the displacements `u`; internal nodes follow those of the element.
    pub translation: Vec<Shape>,
    /// Of the derivatives `w`.
    pub director: Vec<Shape>,
}

impl Sample {
    /// Interpolates positions and displacements in the same way.
    pub fn isoparametric(shapes: Vec<Shape>) -> Self {
        Self { position: shapes.clone(), translation: shapes.clone(), director: shapes }
    }

    /// Adds an internal node with bubble functions of both displacements.
    pub fn with_bubbles(mut self, translation: Shape, director: Shape) -> Self {
        self.translation.push(translation);
        self.director.push(director);
        self
    }
}

impl Geometry {
    /// Returns the covariant base vectors: derivatives of the position by xi, eta and zeta.
    pub fn base(&self, sample: &Sample, zeta: f64) -> Basis {
        let mut base = [[0.0; 3]; 3];
        for ((shape, middle), half) in sample.position.iter().zip(&self.middle).zip(&self.half) {
            let at = plus(*middle, scaled(*half, zeta));
            base[0] = plus(base[0], scaled(at, shape[1]));
            base[1] = plus(base[1], scaled(at, shape[2]));
            base[2] = plus(base[2], scaled(*half, shape[0]));
        }
        base
    }

    /// Returns the position at zeta.
    pub fn point(&self, sample: &Sample, zeta: f64) -> [f64; 3] {
        let nodes = sample.position.iter().zip(&self.middle).zip(&self.half);
        nodes.fold([0.0; 3], |sum, ((shape, middle), half)| {
            plus(sum, scaled(plus(*middle, scaled(*half, zeta)), shape[0]))
        })
    }

    /// Returns the covariant strain rows.
    pub fn covariant(&self, sample: &Sample, zeta: f64) -> DMatrix<f64> {
        let [a, b, c] = self.base(sample, zeta);
        let mut rows = DMatrix::zeros(STRAINS, 6 * sample.translation.len());
        for (node, (n, m)) in sample.translation.iter().zip(&sample.director).enumerate() {
            for axis in 0..3 {
                let (a, b, c) = (a[axis], b[axis], c[axis]);
                let u = [a * n[1], b * n[2], a * n[2] + b * n[1], c * n[1], c * n[2]];
                let across = [a * m[0], b * m[0]];
                let w = [
                    zeta * a * m[1],
                    zeta * b * m[2],
                    zeta * (a * m[2] + b * m[1]),
                    zeta * c * m[1] + across[0],
                    zeta * c * m[2] + across[1],
                ];
                for strain in 0..STRAINS {
                    rows[(strain, 6 * node + axis)] = u[strain];
                    rows[(strain, 6 * node + 3 + axis)] = w[strain];
                }
            }
        }
        rows
    }
}

/// Returns the triple product of base vectors: the volume per reference volume.
pub(super) fn volume(base: &Basis) -> f64 {
    dot(cross(base[0], base[1]), base[2])
}

/// Returns the contravariant base vectors; `None` if the base is singular.
pub(super) fn contravariant(base: &Basis) -> Option<Basis> {
    let inverse = Matrix3::from_fn(|row, column| base[row][column]).try_inverse()?;
    Some(std::array::from_fn(|vector| std::array::from_fn(|axis| inverse[(axis, vector)])))
}

/// Returns the orthonormal base e_r, e_s, e_t of the surface of constant zeta: e_t is its normal,
/// and e_r the direction in the surface nearest to `reference`. The base is constant in flat
/// elements.
pub(super) fn lamina(base: &Basis, reference: [f64; 3]) -> Basis {
    let normal = unit(cross(base[0], base[1]));
    let r = unit(minus(reference, scaled(normal, dot(normal, reference))));
    [r, cross(normal, r), normal]
}

/// Returns the matrix that converts covariant strains to strains in the base `local`, from
/// contravariant base vectors. The strain across the thickness takes no part.
pub(super) fn conversion(dual: &Basis, local: &Basis) -> Matrix5<f64> {
    // c[a][i] = g^a . e_i
    let c: [[f64; 3]; 3] = std::array::from_fn(|a| std::array::from_fn(|i| dot(dual[a], local[i])));
    const PAIRS: [[usize; 2]; STRAINS] = [[0, 0], [1, 1], [0, 1], [0, 2], [1, 2]];
    Matrix5::from_fn(|row, column| {
        let ([i, j], [a, b]) = (PAIRS[row], PAIRS[column]);
        // Strain ij = sum over ab of c_ai c_bj e_ab; shear strains count twice in rows.
        let twice = if i == j { 1.0 } else { 2.0 };
        let sum = if a == b { c[a][i] * c[a][j] } else { 0.5 * (c[a][i] * c[b][j] + c[b][i] * c[a][j]) };
        twice * sum
    })
}

/// Returns the transposed Cholesky factor of the elasticity in a lamina: plane stress, and
/// transverse shear with [`SHEAR_FACTOR`]. The product with strains is the root of twice the energy
/// density.
///
/// # Errors
/// The material has no positive definite elasticity.
pub(super) fn elasticity_root(material: &Material) -> Result<SMatrix<f64, STRAINS, STRAINS>, ElementError> {
    let (e, nu, shear) = (material.youngs_modulus, material.poissons_ratio, material.shear_modulus);
    let refusal = |message: String, help: &str| Err(ElementError { message, help: help.to_owned() });
    if !(e > 0.0 && e.is_finite()) {
        return refusal(
            format!("Young's modulus of the shell element is {e}"),
            "state a positive Young's modulus",
        );
    }
    if !(nu > -1.0 && nu < 1.0) {
        return refusal(
            format!("Poisson's ratio of the shell element is {nu}"),
            "state a Poisson's ratio between -1 and 0.5",
        );
    }
    if !(shear > 0.0 && shear.is_finite()) {
        return refusal(
            format!("the shear modulus of the shell element is {shear}"),
            "state a positive shear modulus, for isotropic materials E / 2 (1 + nu)",
        );
    }
    // Cholesky factor of E / (1 - nu²) [[1, nu], [nu, 1]].
    let plane = (e / (1.0 - nu * nu)).sqrt();
    let mut root = SMatrix::zeros();
    root[(0, 0)] = plane;
    root[(0, 1)] = plane * nu;
    root[(1, 1)] = e.sqrt();
    root[(2, 2)] = (0.5 * e / (1.0 + nu)).sqrt();
    root[(3, 3)] = (SHEAR_FACTOR * shear).sqrt();
    root[(4, 4)] = root[(3, 3)];
    Ok(root)
}

/// Returns `s^T s`, symmetric to the last bit.
pub(super) fn squared(s: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, count) = s.shape();
    let columns = s.as_slice().chunks_exact(rows).collect::<Vec<_>>();
    let mut product = DMatrix::zeros(count, count);
    for (column, a) in columns.iter().enumerate() {
        for (row, b) in columns.iter().enumerate().skip(column) {
            let value = a.iter().zip(*b).map(|(a, b)| a * b).sum::<f64>();
            product[(row, column)] = value;
            product[(column, row)] = value;
        }
    }
    product
}

/// Returns true for positive numbers; false for NaN.
pub(super) fn is_positive(value: f64) -> bool {
    value > 0.0
}

/// Returns the area per reference area and the unit normal at a point of the reference surface.
pub(super) fn area(base: &Basis) -> (f64, [f64; 3]) {
    let normal = cross(base[0], base[1]);
    let area = length(normal);
    (area, scaled(normal, area.recip()))
}
