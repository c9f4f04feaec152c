//! Shell elements with six degrees of freedom per node: data, checks, and the relation to the
//! displacements of a solid that is linear in its thickness.

use super::interpolation::{square_bubble, triangle_bubble};
use super::kinematics::{Geometry, Sample, area, is_positive};
use crate::error::ElementError;
use crate::model::{Material, ShellShape};
use calyx_numerics::vec3::{cross, dot, length, minus, plus, scaled, unit};
use nalgebra::DMatrix;

/// Shell element with three translations and three rotations per node.
#[derive(Clone, Copy, Debug)]
pub struct ShellElement<'a> {
    /// Shape.
    pub shape: ShellShape,
    /// Positions of the nodes, m.
    pub positions: &'a [[f64; 3]],
    /// Thickness at the corners, m.
    pub thickness: &'a [f64],
    /// Offset of the mid-surface from the nodes along the normal, m.
    pub offset: f64,
    /// Material.
    pub material: &'a Material,
    /// Mass per area in addition to that of the material, kg/m^2.
    pub added_mass: f64,
}

/// Smallest area per reference area at a node, relative to the mean of the element.
const FLATTEST: f64 = 1e-6;

/// Geometry of a valid element.
pub(super) struct Prepared {
    pub shape: ShellShape,
    /// Mid-surface with halves of thickness vectors.
    pub middle: Geometry,
    /// Vectors from the nodes to the mid-surface, m.
    pub offsets: Vec<[f64; 3]>,
    /// Directions of the internal degrees of freedom: columns of the internal node, up to 6 rows.
    pub internal: DMatrix<f64>,
}

impl ShellElement<'_> {
    /// Checks the element and returns its mid-surface.
    pub(super) fn prepared(&self) -> Result<Prepared, ElementError> {
        self.check_data()?;
        let normals = self.normals()?;
        let mut half = Vec::new();
        for (at, normal) in self.shape.node_coordinates().into_iter().zip(&normals) {
            let shapes = self.shape.corner_shapes(at);
            let thickness = shapes.iter().zip(self.thickness).map(|(shape, t)| shape[0] * t).sum::<f64>();
            half.push(scaled(*normal, 0.5 * thickness));
        }
        let offsets = normals.iter().map(|normal| scaled(*normal, self.offset)).collect::<Vec<_>>();
        let middle = self.positions.iter().zip(&offsets).map(|(at, offset)| plus(*at, *offset)).collect();
        let middle = Geometry { middle, half };
        let internal = internal_directions(self.shape, &middle);
        let prepared = Prepared { shape: self.shape, middle, offsets, internal };
        prepared.check_middle(self.offset)?;
        Ok(prepared)
    }

    fn check_data(&self) -> Result<(), ElementError> {
        let refusal = |message: String, help: &str| Err(ElementError { message, help: help.to_owned() });
        let (nodes, corners) = (self.shape.node_count(), self.shape.corner_count());
        if self.positions.len() != nodes {
            return refusal(
                format!("a shell element of {nodes} nodes has {} positions", self.positions.len()),
                "state one position for each node",
            );
        }
        if self.thickness.len() != corners {
            return refusal(
                format!("a shell element of {corners} corners has {} thicknesses", self.thickness.len()),
                "state the thickness at each corner",
            );
        }
        if let Some(node) = self.positions.iter().position(|at| at.iter().any(|x| !x.is_finite())) {
            return refusal(
                format!("the position of node {} of the shell element is not finite", node + 1),
                "state finite coordinates",
            );
        }
        if let Some((corner, t)) =
            self.thickness.iter().enumerate().find(|(_, t)| !(**t > 0.0 && t.is_finite()))
        {
            return refusal(
                format!("the thickness at corner {} of the shell element is {t}", corner + 1),
                "state a positive thickness",
            );
        }
        if !self.offset.is_finite() {
            return refusal(
                format!("the offset of the shell element is {}", self.offset),
                "state a finite offset",
            );
        }
        for (name, value) in [("density", self.material.density), ("added mass", self.added_mass)] {
            if !(value >= 0.0 && value.is_finite()) {
                return refusal(
                    format!("the {name} of the shell element is {value}"),
                    "state a finite value of zero or more",
                );
            }
        }
        Ok(())
    }

    /// Returns the unit normals at the nodes.
    fn normals(&self) -> Result<Vec<[f64; 3]>, ElementError> {
        let surface =
            Geometry { middle: self.positions.to_vec(), half: vec![[0.0; 3]; self.positions.len()] };
        let vectors = self.shape.node_coordinates().into_iter().map(|at| {
            let base = surface.base(&Sample::isoparametric(self.shape.shapes(at)), 0.0);
            cross(base[0], base[1])
        });
        let vectors = vectors.collect::<Vec<_>>();
        let total = vectors[..self.shape.corner_count()].iter().fold([0.0; 3], |sum, v| plus(sum, *v));
        let extent =
            self.positions.iter().map(|at| length(minus(*at, self.positions[0]))).fold(0.0, f64::max);
        let mean = length(total) / self.shape.corner_count() as f64;
        if !is_positive(mean - FLATTEST * extent * extent) {
            return Err(ElementError {
                message: "the shell element has no area: its nodes coincide or lie on a line".to_owned(),
                help: "move the nodes apart, or remove the element".to_owned(),
            });
        }
        let up = unit(total);
        if let Some(node) = vectors.iter().position(|vector| !is_positive(dot(*vector, up) - FLATTEST * mean))
        {
            return Err(folded(node));
        }
        Ok(vectors.into_iter().map(unit).collect())
    }
}

fn folded(node: usize) -> ElementError {
    ElementError {
        message: format!("the shell element is folded at its node {}", node + 1),
        help:
            "order the nodes around the element, keep its angles below 180 degrees, and place midside nodes \
               near the middle of their side"
                .to_owned(),
    }
}

impl Prepared {
    /// Returns the shape functions at a point. Displacements of the internal node are bubbles on
    /// top of those of the other nodes; so are those of the ninth node
    /// ([`Prepared::without_bubbles`]).
    pub fn sample(&self, at: [f64; 2]) -> Sample {
        match self.shape {
            ShellShape::Triangle3 | ShellShape::Triangle6 => {
                Sample::isoparametric(self.shape.shapes(at)).with_bubbles([0.0; 3], triangle_bubble(at))
            }
            ShellShape::Quadrilateral8 | ShellShape::Quadrilateral9 => {
                let sample = Sample::isoparametric(ShellShape::Quadrilateral8.shapes(at));
                let sample = sample.with_bubbles(square_bubble(at), square_bubble(at));
                Sample { position: self.shape.shapes(at), ..sample }
            }
            ShellShape::Quadrilateral4 => Sample::isoparametric(self.shape.shapes(at)),
        }
    }

    /// Returns the number of nodes whose displacements are columns of strain rows.
    pub fn column_nodes(&self) -> usize {
        self.offsets.len() + usize::from(self.internal.ncols() > 0)
    }

    /// Converts columns of the bubble of the ninth node to those of its displacement.
    pub fn without_bubbles(&self, mut rows: DMatrix<f64>) -> DMatrix<f64> {
        if self.shape == ShellShape::Quadrilateral9 {
            let bubble = rows.columns(48, 6).into_owned();
            for (node, shape) in ShellShape::Quadrilateral8.shapes([0.0; 2]).iter().enumerate() {
                let mut columns = rows.columns_mut(6 * node, 6);
                columns -= &bubble * shape[0];
            }
        }
        rows
    }

    /// Converts columns of the displacements `u` and `w` of the mid-surface to those of the degrees
    /// of freedom: six of each node, then the internal ones.
    pub fn to_degrees_of_freedom(&self, rows: &DMatrix<f64>) -> DMatrix<f64> {
        let nodes = self.offsets.len();
        let internal = self.internal.ncols();
        let mut result = DMatrix::zeros(rows.nrows(), 6 * nodes + internal);
        for row in 0..rows.nrows() {
            let vector = |first: usize| std::array::from_fn(|axis| rows[(row, first + axis)]);
            for node in 0..nodes {
                let (u, w) = (vector(6 * node), vector(6 * node + 3));
                // u of the mid-surface = u + theta x offset, w = theta x half.
                let rotation = plus(cross(self.offsets[node], u), cross(self.middle.half[node], w));
                for axis in 0..3 {
                    result[(row, 6 * node + axis)] = u[axis];
                    result[(row, 6 * node + 3 + axis)] = rotation[axis];
                }
            }
            for column in 0..internal {
                let terms = (0..6).map(|part| rows[(row, 6 * nodes + part)] * self.internal[(part, column)]);
                result[(row, 6 * nodes + column)] = terms.sum();
            }
        }
        result
    }

    /// Checks that the mid-surface is not folded by the offset.
    fn check_middle(&self, offset: f64) -> Result<(), ElementError> {
        for (node, at) in self.shape.node_coordinates().into_iter().enumerate() {
            let base = self.middle.base(&self.sample(at), 0.0);
            if !is_positive(dot(cross(base[0], base[1]), self.middle.half[node])) {
                return Err(ElementError {
                    message: format!(
                        "the offset {offset} folds the mid-surface of the shell element at its node {}",
                        node + 1
                    ),
                    help: "reduce the offset below the radius of curvature".to_owned(),
                });
            }
        }
        Ok(())
    }
}

/// Returns the directions of the internal degrees of freedom: translations of the eight-node
/// quadrilateral, and rotations that leave the thickness unchanged.
fn internal_directions(shape: ShellShape, middle: &Geometry) -> DMatrix<f64> {
    let translations = match shape {
        ShellShape::Quadrilateral4 | ShellShape::Quadrilateral9 => return DMatrix::zeros(6, 0),
        ShellShape::Triangle3 | ShellShape::Triangle6 => 0,
        ShellShape::Quadrilateral8 => 3,
    };
    let centre = if shape.is_triangle() { [1.0 / 3.0; 2] } else { [0.0; 2] };
    let base = middle.base(&Sample::isoparametric(shape.shapes(centre)), 0.0);
    let (_, normal) = area(&base);
    let first = unit(base[0]);
    let second = cross(normal, first);
    let mut directions = DMatrix::zeros(6, translations + 2);
    for axis in 0..3 {
        if translations == 3 {
            directions[(axis, axis)] = 1.0;
        }
        // Scaled to rotations.
        directions[(3 + axis, translations)] = first[axis] * length(base[2]);
        directions[(3 + axis, translations + 1)] = second[axis] * length(base[2]);
    }
    directions
}
