//! Stiffness and mass of one element of a model, in the displacement axes of its nodes.

use crate::beam;
use crate::error::ElementError;
use crate::model::{ElasticModel, Element, ElementKind, Material, Node};
use crate::shell::{self, ShellElement};
use crate::solid::{self, SolidElement};
use nalgebra::{DMatrix, Matrix3, Vector3};

/// Matrix of an element over degrees of freedom of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementMatrix {
    /// Degrees of freedom: six times the index of the node plus the component.
    pub dofs: Vec<usize>,
    /// Symmetric matrix over them.
    pub matrix: DMatrix<f64>,
}

/// Quantity of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Stiffness.
    Stiffness,
    /// Mass.
    Mass,
}

/// Returns the degrees of freedom to which an element gives stiffness or mass.
pub fn dofs(element: &Element) -> Vec<usize> {
    let per_node = |count: usize| -> Vec<usize> {
        element.nodes.iter().flat_map(|&node| (0..count).map(move |component| 6 * node + component)).collect()
    };
    match &element.kind {
        ElementKind::Solid(_) => per_node(3),
        ElementKind::Spring { components, .. } => {
            element.nodes.iter().zip(components).map(|(&node, &component)| 6 * node + component).collect()
        }
        ElementKind::Shell { .. }
        | ElementKind::Beam(_)
        | ElementKind::Rod { .. }
        | ElementKind::Mass { .. } => per_node(6),
    }
}

/// Returns the stiffness or mass of an element.
///
/// # Errors
/// The element is degenerate, or refers to a node or material that does not exist.
pub fn matrix(
    model: &ElasticModel,
    element: &Element,
    quantity: Quantity,
) -> Result<ElementMatrix, ElementError> {
    let found = of_element(model, element, quantity);
    found.map_err(|error| error.within(format_args!("element {}", element.label)))
}

fn of_element(
    model: &ElasticModel,
    element: &Element,
    quantity: Quantity,
) -> Result<ElementMatrix, ElementError> {
    let nodes = element.nodes.iter().map(|&node| model.nodes.get(node)).collect::<Option<Vec<&Node>>>();
    let nodes = nodes.ok_or_else(|| {
        ElementError::new("the element refers to a node that does not exist", "define all nodes")
    })?;
    let positions: Vec<[f64; 3]> = nodes.iter().map(|node| node.position).collect();
    let in_basic_axes =
        |matrix: DMatrix<f64>| ElementMatrix { dofs: dofs(element), matrix: in_node_axes(matrix, &nodes) };
    let stiff = quantity == Quantity::Stiffness;
    match &element.kind {
        ElementKind::Solid(shape) => {
            let solid =
                SolidElement { shape: *shape, positions: &positions, material: material(model, element)? };
            let matrix = if stiff { solid::stiffness(&solid) } else { solid::mass(&solid) };
            Ok(in_basic_axes(matrix?))
        }
        ElementKind::Shell { shape, thickness, offset, added_mass } => {
            let shell = ShellElement {
                shape: *shape,
                positions: &positions,
                thickness,
                offset: *offset,
                material: material(model, element)?,
                added_mass: *added_mass,
            };
            let matrix = if stiff { shell::stiffness(&shell) } else { shell::mass(&shell) };
            Ok(in_basic_axes(matrix?))
        }
        ElementKind::Beam(properties) => {
            let (material, ends) = (material(model, element)?, two(&positions)?);
            let of = if stiff { beam::stiffness } else { beam::mass };
            Ok(in_basic_axes(of(properties, material, ends)?))
        }
        ElementKind::Rod { area, torsion_constant, added_mass } => {
            let (material, ends) = (material(model, element)?, two(&positions)?);
            let matrix = if stiff {
                beam::rod_stiffness([*area, *torsion_constant], material, ends)
            } else {
                beam::rod_mass(*area, *added_mass, material, ends)
            };
            Ok(in_basic_axes(matrix?))
        }
        ElementKind::Spring { components, stiffness } => {
            spring(element, *components, if stiff { *stiffness } else { 0.0 })
        }
        ElementKind::Mass { mass, offset, inertia } => {
            let matrix = if stiff { DMatrix::zeros(6, 6) } else { point_mass(*mass, *offset, *inertia) };
            if nodes.len() != 1 {
                return Err(ElementError::new("a mass needs one node", "state one node"));
            }
            Ok(in_basic_axes(matrix))
        }
    }
}

fn material<'a>(model: &'a ElasticModel, element: &Element) -> Result<&'a Material, ElementError> {
    let found = element.material.and_then(|material| model.materials.get(material));
    found.ok_or_else(|| ElementError::new("the element has no material", "define its material"))
}

fn two(positions: &[[f64; 3]]) -> Result<[[f64; 3]; 2], ElementError> {
    <[[f64; 3]; 2]>::try_from(positions)
        .map_err(|_| ElementError::new("the element needs two nodes", "state two nodes"))
}

fn spring(element: &Element, components: [usize; 2], stiffness: f64) -> Result<ElementMatrix, ElementError> {
    let count = element.nodes.len();
    if !(1..=2).contains(&count)
        || components.iter().any(|&component| component > 5)
        || !stiffness.is_finite()
    {
        return Err(ElementError::new(
            "a spring needs one or two nodes, components from 0 to 5 and a finite stiffness",
            "correct the definition of the spring",
        ));
    }
    let sign = |row: usize, column: usize| if row == column { 1.0 } else { -1.0 };
    let matrix = DMatrix::from_fn(count, count, |row, column| sign(row, column) * stiffness);
    Ok(ElementMatrix { dofs: dofs(element), matrix })
}

/// Returns the mass matrix of a rigid body about a point, over six components along the basic axes.
fn point_mass(mass: f64, offset: [f64; 3], inertia: [[f64; 3]; 3]) -> DMatrix<f64> {
    let lever = Vector3::from(offset).cross_matrix();
    let about_centre = Matrix3::from_fn(|i, j| 0.5 * (inertia[i][j] + inertia[j][i]));
    let rotational = about_centre - mass * lever * lever;
    let mut matrix = DMatrix::zeros(6, 6);
    for i in 0..3 {
        matrix[(i, i)] = mass;
        for j in 0..3 {
            matrix[(i, 3 + j)] = -mass * lever[(i, j)];
            matrix[(3 + j, i)] = -mass * lever[(i, j)];
            matrix[(3 + i, 3 + j)] = rotational[(i, j)];
        }
    }
    matrix
}

/// Converts a matrix from the basic axes to the displacement axes of the nodes.
fn in_node_axes(mut matrix: DMatrix<f64>, nodes: &[&Node]) -> DMatrix<f64> {
    let identity = Matrix3::identity();
    let per_node = matrix.nrows() / nodes.len().max(1);
    for (index, node) in nodes.iter().enumerate() {
        let axes = Matrix3::from_fn(|i, j| node.axes[i][j]);
        if axes == identity {
            continue;
        }
        for first in (per_node * index..per_node * (index + 1)).step_by(3) {
            let rows = axes * matrix.rows(first, 3);
            matrix.rows_mut(first, 3).copy_from(&rows);
            let columns = matrix.columns(first, 3) * axes.transpose();
            matrix.columns_mut(first, 3).copy_from(&columns);
        }
    }
    // Rotation leaves rounding; both triangles become equal to the bit.
    for column in 0..matrix.ncols() {
        for row in 0..column {
            let mean = 0.5 * (matrix[(row, column)] + matrix[(column, row)]);
            matrix[(row, column)] = mean;
            matrix[(column, row)] = mean;
        }
    }
    matrix
}
