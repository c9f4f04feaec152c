//! Rigid-body motions that the supports of an elastic body resist.
//!
//! A body can have supports that leave it free to move: two fixed nodes are a hinge. Its condensed
//! stiffness has this motion, but the restraint check, which condenses nothing, needs it from the
//! supports alone.

use calyx_elastic::connectivity::nodes_of;
use calyx_elastic::model::{ElasticModel, Element, ElementKind};
use calyx_numerics::vec3::{Vector, cross};
use nalgebra::DMatrix;

/// Singular value of the rows of all supports, relative to the largest, below which they do not
/// resist a motion.
const RESISTED: f64 = 1e-6;

/// Displacement of the origin along the axes of the body, m, and rotation about them, rad, of each
/// row times this motion of the body is a motion that its supports resist.
pub type SupportRow = [f64; 6];

/// Returns the motions that the fixed components and the springs to ground of a model resist, one
/// per row. Rotations of nodes count if an element or a constraint can resist them.
pub(super) fn support_rows(model: &ElasticModel) -> Vec<SupportRow> {
    let rotating = nodes_with_rotations(model);
    let row = |node: usize, component: usize| {
        let (position, axis) = (model.nodes[node].position, model.nodes[node].axes[component % 3]);
        match component < 3 {
            true => joined(axis, cross(position, axis)),
            false if rotating[node] => joined([0.0; 3], axis),
            false => [0.0; 6],
        }
    };
    let fixed = model.fixed.iter().flat_map(|fixed| {
        let components = (0..6).filter(|&component| fixed.components[component]);
        components.map(|component| (fixed.node, component)).collect::<Vec<_>>()
    });
    let springs = model.elements.iter().filter_map(on_ground);
    fixed.chain(springs).map(|(node, component)| row(node, component)).collect()
}

/// Returns node and component of a spring between a node and ground; `None` for other elements.
pub(super) fn on_ground(element: &Element) -> Option<(usize, usize)> {
    match (&element.kind, &element.nodes[..]) {
        (ElementKind::Spring { components, .. }, &[node]) => Some((node, components[0])),
        _ => None,
    }
}

/// Returns for each node whether an element or a constraint can resist its rotation.
fn nodes_with_rotations(model: &ElasticModel) -> Vec<bool> {
    let mut rotating = vec![false; model.nodes.len()];
    for element in &model.elements {
        if !matches!(element.kind, ElementKind::Solid(_) | ElementKind::Mass { .. }) {
            element.nodes.iter().for_each(|&node| rotating[node] = true);
        }
    }
    for node in model.constraints.iter().flat_map(nodes_of) {
        rotating[node] = true;
    }
    rotating
}

/// Returns an orthonormal basis of the motions that rows resist, with rotations times `size` (m);
/// `None` if they resist all six.
pub(super) fn resisted(rows: &[SupportRow], size: f64) -> Option<Vec<SupportRow>> {
    let scale = |k: usize| if k < 3 { 1.0 } else { size.recip() };
    // Rows without an entry complete the matrix, so that its decomposition has all directions.
    let matrix = DMatrix::from_fn(rows.len().max(6), 6, |row, k| {
        rows.get(row).map_or(0.0, |support| scale(k) * support[k])
    });
    let decomposition = matrix.svd(false, true);
    let directions = decomposition.v_t?;
    let largest = decomposition.singular_values.iter().copied().fold(0.0, f64::max);
    let basis: Vec<SupportRow> = (0..6)
        .filter(|&k| decomposition.singular_values[k] > RESISTED * largest)
        .map(|k| std::array::from_fn(|column| directions[(k, column)]))
        .collect();
    (basis.len() < 6).then_some(basis)
}

fn joined([x, y, z]: Vector, [about_x, about_y, about_z]: Vector) -> SupportRow {
    [x, y, z, about_x, about_y, about_z]
}
