//! Shell element of the report (2.3): displacements and their derivatives by the thickness
//! coordinate at each node, without rotations.

use super::element::too_thick;
use super::interpolation::{Weighted, lagrange_quadrilateral, lagrange_triangle, square_rule, triangle_rule};
use super::kinematics::{
    Geometry, STRAINS, Sample, contravariant, conversion, elasticity_root, is_positive, lamina, squared,
    volume,
};
use crate::error::ElementError;
use crate::model::Material;
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::{cross, length, plus, scaled, unit};
use nalgebra::{DMatrix, DVector};

/// Shape and order of a [`DirectorShell`]. Nodes are equally spaced; xi runs fastest, then eta.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectorShape {
    /// Lagrange quadrilateral of order 1, 2 or 3 over -1 <= xi, eta <= 1.
    Quadrilateral(u8),
    /// Triangle of complete polynomials of order 1, 2 or 3 over xi, eta >= 0, xi + eta <= 1.
    Triangle(u8),
}

/// Node of a [`DirectorShell`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectorNode {
    /// Position, m.
    pub position: [f64; 3],
    /// Half of the thickness vector: derivative of the position by zeta, m.
    pub half_thickness: [f64; 3],
    /// Offset of the mid-surface from the position, in half thicknesses: zeta = 0 is at the
    /// position plus this factor times the half thickness.
    pub offset: f64,
}

/// Quadrature over the surface; two points across the thickness in all cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integration {
    /// Full order for all strains: order + 1 points in each direction. Locks.
    Full,
    /// One order less for all strains. Leaves mechanisms.
    Reduced,
    /// Full order for strains in the lamina, one order less for transverse shear.
    SelectivelyReduced,
}

/// Shell element with displacement `u` and its thickness derivative `w` at each node: six
/// components per node in basic axes.
///
/// The element has no stiffness against strain across its thickness. The
/// [constraint](DirectorNode::thickness_constraint) of each node, or a joint with a solid, supplies
/// it.
#[derive(Clone, Copy, Debug)]
pub struct DirectorShell<'a> {
    /// Shape and order.
    pub shape: DirectorShape,
    /// Nodes.
    pub nodes: &'a [DirectorNode],
    /// Material.
    pub material: &'a Material,
    /// Quadrature of the stiffness.
    pub integration: Integration,
}

impl DirectorShape {
    /// Returns the number of nodes.
    pub fn node_count(self) -> usize {
        match self {
            Self::Quadrilateral(order) => (usize::from(order) + 1).pow(2),
            Self::Triangle(order) => (usize::from(order) + 1) * (usize::from(order) + 2) / 2,
        }
    }

    fn order(self) -> u8 {
        match self {
            Self::Quadrilateral(order) | Self::Triangle(order) => order,
        }
    }

    pub(super) fn sample(self, at: [f64; 2]) -> Sample {
        Sample::isoparametric(match self {
            Self::Quadrilateral(order) => lagrange_quadrilateral(order, at),
            Self::Triangle(order) => lagrange_triangle(order, at),
        })
    }

    /// Returns the rule of the full order, or of one order less.
    fn rule(self, reduced: bool) -> Vec<Weighted> {
        let points = usize::from(self.order()) + usize::from(!reduced);
        match self {
            Self::Quadrilateral(_) => square_rule(points),
            Self::Triangle(_) => triangle_rule(2 * points - if reduced { 2 } else { 1 }),
        }
    }
}

impl DirectorNode {
    /// Returns the coefficients of `w` whose sum is the strain across the thickness times the half
    /// thickness; the report constrains it to zero.
    pub fn thickness_constraint(&self) -> [f64; 3] {
        unit(self.half_thickness)
    }

    /// Returns two unit vectors that span the derivatives `w` permitted by the constraint.
    pub fn tangents(&self) -> [[f64; 3]; 2] {
        let normal = unit(self.half_thickness);
        // The axis with the smallest component is never parallel to the normal.
        let axis =
            (0..3).fold(0, |least, axis| if normal[axis].abs() < normal[least].abs() { axis } else { least });
        let mut along = [0.0; 3];
        along[axis] = 1.0;
        let first = unit(cross(along, normal));
        [first, cross(normal, first)]
    }
}

impl DirectorShell<'_> {
    /// Returns the stiffness over `u` and `w` of each node (N/m).
    ///
    /// # Errors
    /// The element is degenerate, folded, or has impossible properties.
    pub fn stiffness(&self) -> Result<DMatrix<f64>, ElementError> {
        let geometry = self.geometry()?;
        let root = elasticity_root(self.material)?;
        let [full, reduced] = [false, true].map(|reduced| self.shape.rule(reduced));
        let (lamina_rule, shear_rule) = match self.integration {
            Integration::Full => (&full, &full),
            Integration::Reduced => (&reduced, &reduced),
            Integration::SelectivelyReduced => (&full, &reduced),
        };
        let mut rows = DMatrix::zeros(6 * lamina_rule.len() + 4 * shear_rule.len(), 6 * self.nodes.len());
        let mut first = 0;
        for (rule, strains) in [(lamina_rule, 0..3), (shear_rule, 3..STRAINS)] {
            for &(at, weight) in rule {
                let sample = self.shape.sample(at);
                for (zeta, height) in gauss_legendre(2) {
                    let base = geometry.base(&sample, zeta);
                    let volume = volume(&base);
                    let dual = contravariant(&base).filter(|_| is_positive(volume)).ok_or_else(too_thick)?;
                    let local =
                        conversion(&dual, &lamina(&base, base[0])) * geometry.covariant(&sample, zeta);
                    let local = root * (volume * height * weight).sqrt() * local;
                    rows.rows_mut(first, strains.len()).copy_from(&local.rows(strains.start, strains.len()));
                    first += strains.len();
                }
            }
        }
        Ok(squared(&self.nodal_columns(rows)))
    }

    /// Returns the consistent mass over `u` and `w` of each node (kg).
    ///
    /// # Errors
    /// As for [`DirectorShell::stiffness`].
    pub fn mass(&self) -> Result<DMatrix<f64>, ElementError> {
        let geometry = self.geometry()?;
        // Shape functions squared, times the determinant of straight or curved elements.
        let order = usize::from(self.shape.order());
        let rule = match self.shape {
            DirectorShape::Quadrilateral(_) => square_rule((5 * order).div_ceil(2)),
            DirectorShape::Triangle(_) => triangle_rule(5 * order),
        };
        let mut rows = DMatrix::zeros(6 * rule.len(), 6 * self.nodes.len());
        let mut first = 0;
        for (at, weight) in rule {
            let sample = self.shape.sample(at);
            for (zeta, height) in gauss_legendre(2) {
                let volume = volume(&geometry.base(&sample, zeta));
                if !is_positive(volume) {
                    return Err(too_thick());
                }
                let mass = (self.material.density * volume * height * weight).sqrt();
                for (node, shape) in sample.translation.iter().enumerate() {
                    for axis in 0..3 {
                        rows[(first + axis, 6 * node + axis)] = mass * shape[0];
                        rows[(first + axis, 6 * node + 3 + axis)] = mass * shape[0] * zeta;
                    }
                }
                first += 3;
            }
        }
        Ok(squared(&self.nodal_columns(rows)))
    }

    /// Returns the load of a pressure (Pa) on the surface of constant zeta, against the normal,
    /// over `u` and `w` of each node (N).
    ///
    /// # Errors
    /// As for [`DirectorShell::stiffness`].
    pub fn pressure_load(&self, zeta: f64, pressure: f64) -> Result<DVector<f64>, ElementError> {
        let geometry = self.geometry()?;
        let mut row = DMatrix::zeros(1, 6 * self.nodes.len());
        let rule = match self.shape {
            DirectorShape::Quadrilateral(order) => square_rule(2 * usize::from(order)),
            DirectorShape::Triangle(order) => triangle_rule(3 * usize::from(order)),
        };
        for (at, weight) in rule {
            let sample = self.shape.sample(at);
            let base = geometry.base(&sample, zeta);
            let force = scaled(cross(base[0], base[1]), -pressure * weight);
            for (node, shape) in sample.translation.iter().enumerate() {
                for axis in 0..3 {
                    row[6 * node + axis] += shape[0] * force[axis];
                    row[6 * node + 3 + axis] += shape[0] * zeta * force[axis];
                }
            }
        }
        Ok(self.nodal_columns(row).transpose().column(0).into_owned())
    }

    /// Returns the mid-surface.
    pub(super) fn geometry(&self) -> Result<Geometry, ElementError> {
        let refusal = |message: String, help: &str| Err(ElementError { message, help: help.to_owned() });
        if !(1..=3).contains(&self.shape.order()) {
            return refusal(
                format!("the order of the shell element is {}", self.shape.order()),
                "choose order 1, 2 or 3",
            );
        }
        let expected = self.shape.node_count();
        if self.nodes.len() != expected {
            return refusal(
                format!("a shell element of {expected} nodes has {}", self.nodes.len()),
                "state each node of the element",
            );
        }
        let finite = |node: &DirectorNode| {
            [node.position, node.half_thickness].concat().iter().chain([&node.offset]).all(|x| x.is_finite())
        };
        if let Some(node) = self.nodes.iter().position(|node| !finite(node)) {
            return refusal(
                format!("node {} of the shell element is not finite", node + 1),
                "state finite coordinates",
            );
        }
        if let Some(node) = self.nodes.iter().position(|node| !is_positive(length(node.half_thickness))) {
            return refusal(
                format!("the shell element has no thickness at its node {}", node + 1),
                "state a thickness vector other than zero",
            );
        }
        let middle = |node: &DirectorNode| plus(node.position, scaled(node.half_thickness, node.offset));
        let geometry = Geometry {
            middle: self.nodes.iter().map(middle).collect(),
            half: self.nodes.iter().map(|node| node.half_thickness).collect(),
        };
        let folded = self.shape.rule(false).iter().any(|(at, _)| {
            let volume = volume(&geometry.base(&self.shape.sample(*at), 0.0));
            !is_positive(volume)
        });
        if folded {
            return refusal(
                "the shell element is folded, has no area, or its thickness vectors point against the order of \
                 its nodes"
                    .to_owned(),
                "order the nodes counter-clockwise seen against the thickness vectors",
            );
        }
        Ok(geometry)
    }

    /// Converts columns of the displacement of the mid-surface to those of the nodes.
    pub(super) fn nodal_columns(&self, mut rows: DMatrix<f64>) -> DMatrix<f64> {
        for (index, node) in self.nodes.iter().enumerate().filter(|(_, node)| node.offset != 0.0) {
            for axis in 0..3 {
                // u of the mid-surface = u + offset w.
                let own = rows.column(6 * index + axis) * node.offset;
                let mut column = rows.column_mut(6 * index + 3 + axis);
                column += own;
            }
        }
        rows
    }
}
