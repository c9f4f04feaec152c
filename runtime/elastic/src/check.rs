//! Check of a model for motions without stiffness: rigid-body motions of its parts, mechanisms
//! within them, and nodes without stiffness.

use crate::assembly::{System, dot, multiply};
use crate::connectivity::connected_parts;
use crate::error::ElasticError;
use crate::factor::{Factor, Pencil};
use crate::model::Component;
use crate::resources::Resources;
use nalgebra::{DMatrix, Matrix6};

/// A rigid-body motion is free if it causes forces of at most this share of those of an equal
/// motion of single degrees of freedom.
const FREE: f64 = 1e-11;
/// Number of nodes whose rows are orthogonalized at a time.
const ROWS: usize = 1024;
/// Number of labels in a message.
const NAMED: usize = 10;

/// Connected part of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Indices of the nodes, ascending.
    pub nodes: Vec<usize>,
    /// Rigid-body motions without stiffness or support: displacements of all independent degrees of
    /// freedom of the model.
    pub free_motions: Vec<Vec<f64>>,
}

/// Result of [`check`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Smallest label, number of nodes and number of free rigid-body motions of each connected
    /// part.
    pub parts: Vec<(u64, usize, usize)>,
    /// Labels of nodes without stiffness in any component.
    pub without_stiffness: Vec<u64>,
    /// Labels and components that move without stiffness in addition to rigid-body motions: one for
    /// each mechanism.
    pub mechanisms: Vec<(u64, Component)>,
}

impl Report {
    /// Returns the number of free rigid-body motions of all parts.
    pub fn free_motion_count(&self) -> usize {
        self.parts.iter().map(|part| part.2).sum()
    }
}

/// Returns the connected parts of a model with their free rigid-body motions.
pub fn parts(system: &System<'_>) -> Vec<Part> {
    let members = connected_parts(system.model);
    let diagonal: Vec<f64> = (0..system.dof_count())
        .map(|dof| {
            let mut column = system.stiffness.row_idx_of_col(dof).zip(system.stiffness.val_of_col(dof));
            column.find(|entry| entry.0 == dof).map_or(0.0, |entry| *entry.1)
        })
        .collect();
    members
        .into_iter()
        .map(|nodes| Part { free_motions: free_motions(system, &nodes, &diagonal), nodes })
        .filter(|part| part.nodes.iter().any(|&node| has_stiffness(system, node)))
        .collect()
}

/// Returns true if a component of the node is an unknown, prescribed or dependent.
fn has_stiffness(system: &System<'_>, node: usize) -> bool {
    (6 * node..6 * node + 6).any(|dof| {
        system.is_unknown(dof)
            || system.prescribed.contains_key(&dof)
            || system.expansion.of(dof).is_some_and(|terms| !terms.entries.is_empty())
    })
}

/// Returns the rigid-body motions of a part that cause no force and move no prescribed component.
fn free_motions(system: &System<'_>, nodes: &[usize], diagonal: &[f64]) -> Vec<Vec<f64>> {
    let count = nodes.len() as f64;
    let positions = nodes.iter().map(|&node| system.positions[node]);
    let sum = positions.clone().fold([0.0; 3], |sum, at| [0, 1, 2].map(|axis| sum[axis] + at[axis]));
    let centre = sum.map(|sum| sum / count);
    let square = |at: [f64; 3]| (0..3).map(|axis| (at[axis] - centre[axis]).powi(2)).sum::<f64>();
    let radius = (positions.map(square).sum::<f64>() / count).sqrt();
    let length = if radius > 0.0 { radius } else { 1.0 };
    let mut belongs = vec![false; system.model.nodes.len()];
    nodes.iter().for_each(|&node| belongs[node] = true);
    let mut motions = system.rigid_motions(centre);
    for (k, motion) in motions.iter_mut().enumerate() {
        for (dof, value) in motion.iter_mut().enumerate() {
            let active = system.is_unknown(dof) || system.is_support(dof);
            *value *= if !belongs[dof / 6] || !active {
                0.0
            } else if k < 3 {
                1.0
            } else {
                1.0 / length
            };
        }
    }
    let moved = motions.clone();
    let forces = moved.each_ref().map(|motion| multiply(&system.stiffness, motion));
    // Triangular factor of all rows: the squares of a Gram matrix would lose half of the digits.
    let mut triangle = DMatrix::<f64>::zeros(0, 6);
    for nodes in nodes.chunks(ROWS) {
        let mut rows = Vec::with_capacity(6 * nodes.len());
        for &node in nodes {
            for dof in 6 * node..6 * node + 6 {
                let scale = if dof % 6 < 3 { 1.0 } else { length };
                let row = |k: usize| {
                    if system.is_support(dof) {
                        moved[k][dof] * scale
                    } else if system.is_unknown(dof) && diagonal[dof] > 0.0 {
                        forces[k][dof] / diagonal[dof] * scale
                    } else {
                        0.0
                    }
                };
                rows.push(std::array::from_fn::<f64, 6, _>(row));
            }
        }
        let old = triangle.nrows();
        let stacked =
            DMatrix::from_fn(
                old + rows.len(),
                6,
                |i, j| {
                    if i < old { triangle[(i, j)] } else { rows[i - old][j] }
                },
            );
        triangle = stacked.qr().r();
    }
    let square = Matrix6::from_fn(|i, j| if i < triangle.nrows() { triangle[(i, j)] } else { 0.0 });
    let svd = square.svd(false, true);
    let Some(directions) = svd.v_t else { return Vec::new() };
    let mut free = Vec::new();
    for (k, value) in svd.singular_values.iter().enumerate() {
        if *value <= FREE * count.sqrt() {
            let mut motion = vec![0.0; system.dof_count()];
            for (j, column) in moved.iter().enumerate() {
                let factor = directions[(k, j)];
                motion.iter_mut().zip(column).for_each(|(sum, value)| *sum += factor * value);
            }
            if dot(&motion, &motion) > 0.0 {
                free.push(motion);
            }
        }
    }
    independent(free)
}

/// Orthonormalizes motions and removes those that depend on others.
fn independent(motions: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let largest = motions.iter().map(|motion| dot(motion, motion).sqrt()).fold(0.0, f64::max);
    for mut motion in motions {
        for _ in 0..2 {
            for other in &basis {
                let share = dot(&motion, other);
                motion.iter_mut().zip(other).for_each(|(value, other)| *value -= share * other);
            }
        }
        let norm = dot(&motion, &motion).sqrt();
        if norm > 1e-9 * largest {
            motion.iter_mut().for_each(|value| *value /= norm);
            basis.push(motion);
        }
    }
    basis
}

/// Returns degrees of freedom that support the motions in a statically determinate way, far from
/// each other: those with the largest remaining motion, in turn. Translations are preferred.
pub fn determinate_support(system: &System<'_>, motions: &[Vec<f64>]) -> Vec<usize> {
    let mut motions = independent(motions.to_vec());
    let mut support = Vec::new();
    let mut largest = 0.0_f64;
    while !motions.is_empty() {
        let size = |dof: usize| motions.iter().map(|motion| motion[dof].powi(2)).sum::<f64>();
        let best = |translations: bool| {
            let candidates = (0..system.dof_count())
                .filter(|&dof| system.is_unknown(dof) && (dof % 6 < 3) == translations);
            candidates
                .map(|dof| (dof, size(dof)))
                .reduce(|best, next| if next.1 > best.1 { next } else { best })
        };
        let found = [best(true), best(false)];
        let Some((dof, moved)) =
            found.into_iter().flatten().find(|(_, moved)| *moved > 1e-12 * largest && *moved > 0.0)
        else {
            return support;
        };
        largest = largest.max(moved);
        // Rotates the motions so that only the last one moves the degree of freedom.
        let weights: Vec<f64> = motions.iter().map(|motion| motion[dof]).collect();
        let norm = moved.sqrt();
        let combined: Vec<f64> = (0..system.dof_count())
            .map(|k| motions.iter().zip(&weights).map(|(motion, weight)| motion[k] * weight / norm).sum())
            .collect();
        for (motion, weight) in motions.iter_mut().zip(&weights) {
            let share = weight / norm;
            motion.iter_mut().zip(&combined).for_each(|(value, other)| *value -= share * other);
        }
        support.push(dof);
        motions = independent(motions);
        motions.truncate(weights.len() - 1);
    }
    support
}

/// Checks a model.
///
/// # Errors
/// Memory is insufficient, or the caller ends the computation.
pub fn check(system: &System<'_>, resources: &Resources) -> Result<Report, ElasticError> {
    let parts = parts(system);
    let label = |node: usize| system.model.nodes[node].label;
    let motions: Vec<Vec<f64>> = parts.iter().flat_map(|part| part.free_motions.clone()).collect();
    let mut constrained = system.constrained();
    constrained.extend(determinate_support(system, &motions));
    let factor =
        Factor::new(Pencil::stiffness(&system.stiffness), &system.positions, &constrained, resources)?;
    let nodes = 0..system.model.nodes.len();
    Ok(Report {
        parts: parts
            .iter()
            .map(|part| (label(part.nodes[0]), part.nodes.len(), part.free_motions.len()))
            .collect(),
        without_stiffness: nodes.filter(|&node| !has_stiffness(system, node)).map(label).collect(),
        mechanisms: factor.singular.iter().map(|&dof| (label(dof / 6), dof % 6)).collect(),
    })
}

/// Returns the error of a body with free rigid-body motions or mechanisms.
pub fn mechanism(system: &System<'_>, singular: &[usize]) -> ElasticError {
    let parts = parts(system);
    let free: Vec<&Part> = parts.iter().filter(|part| !part.free_motions.is_empty()).collect();
    let label = |node: usize| system.model.nodes[node].label;
    if let Some(part) = free.first() {
        let motions: usize = free.iter().map(|part| part.free_motions.len()).sum();
        return ElasticError::Mechanism {
            message: format!(
                "the body has {motions} free rigid-body motions: of {} connected parts, {} are not supported, the \
                 first with node {}",
                parts.len(),
                free.len(),
                label(part.nodes[0])
            ),
            help: "fix more components, or connect the parts".into(),
            nodes: free.iter().map(|part| label(part.nodes[0])).collect(),
        };
    }
    let mut nodes: Vec<u64> = singular.iter().map(|&dof| label(dof / 6)).collect();
    nodes.sort_unstable();
    nodes.dedup();
    let named: Vec<String> = nodes.iter().take(NAMED).map(u64::to_string).collect();
    let more = if nodes.len() > NAMED { " and others" } else { "" };
    ElasticError::Mechanism {
        message: format!("mechanisms without stiffness move the nodes {}{more}", named.join(", ")),
        help: "fix these nodes, or connect them to elements that resist the motion".into(),
        nodes,
    }
}

/// Returns the error of mechanisms within a body, whose free rigid-body motions are normal.
pub(crate) fn mechanism_within(system: &System<'_>, dofs: &[usize]) -> ElasticError {
    let mut nodes: Vec<u64> = dofs.iter().map(|&dof| system.model.nodes[dof / 6].label).collect();
    nodes.dedup();
    match nodes.as_slice() {
        [] => mechanism(system, dofs),
        [first, ..] => ElasticError::Mechanism {
            message: format!(
                "with its attachments fixed, the body has {} mechanisms without stiffness, the first at node {first}",
                dofs.len()
            ),
            help: "connect these nodes to elements that resist the motion".into(),
            nodes,
        },
    }
}
