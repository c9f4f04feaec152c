//! Constraints between nodes: dependent components as linear combinations of independent ones.
//!
//! Rigid elements (RBE2), weighted averages (RBE3) and equations (MPC) are eliminated by the
//! transformation `u = T x`. A constraint can depend on components of another one, but not on its
//! own. See `docs/theory/elastic-bodies.md`.

use crate::error::ElementError;
use crate::model::{Component, Components, Constraint, ElasticModel, Node};
use calyx_fe::sparse::SparseVector;
use nalgebra::{Matrix6, SymmetricEigen, Vector3, Vector6};
use std::collections::BTreeMap;

/// Share of the largest eigenvalue below which the nodes of a weighted average do not determine a
/// motion.
const SINGULAR: f64 = 1e-10;

/// Transformation from independent degrees of freedom to all of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Expansion {
    /// Combination of independent degrees of freedom for each dependent one.
    dependent: BTreeMap<usize, SparseVector>,
}

/// Dependent degree of freedom before nested constraints are resolved.
struct Raw {
    label: u64,
    terms: Vec<(usize, f64)>,
}

impl Expansion {
    /// Collects the constraints of a model.
    ///
    /// # Errors
    /// A component is dependent in two constraints or on itself, or the nodes of a weighted average
    /// do not determine a requested component.
    pub fn new(model: &ElasticModel) -> Result<Self, ElementError> {
        let mut raw: BTreeMap<usize, Raw> = BTreeMap::new();
        for constraint in &model.constraints {
            let label = label(constraint);
            let combinations = combinations(model, constraint)
                .map_err(|error| error.within(format_args!("constraint {label}")))?;
            for (dof, terms) in combinations {
                if let Some(other) = raw.insert(dof, Raw { label, terms }) {
                    return Err(ElementError::new(
                        format!(
                            "constraints {} and {label} both determine component {} of node {}",
                            other.label,
                            dof % 6 + 1,
                            model.nodes[dof / 6].label
                        ),
                        "make the component dependent in one of them only",
                    ));
                }
            }
        }
        let mut resolved = BTreeMap::new();
        for &dof in raw.keys() {
            resolve(model, dof, &raw, &mut resolved, &mut Vec::new())?;
        }
        Ok(Self { dependent: resolved })
    }

    /// Returns the combination of a dependent degree of freedom; `None` for an independent one.
    pub fn of(&self, dof: usize) -> Option<&SparseVector> {
        self.dependent.get(&dof)
    }

    /// Returns the dependent degrees of freedom with their combinations, ascending.
    pub fn dependent(&self) -> impl Iterator<Item = (usize, &SparseVector)> {
        self.dependent.iter().map(|(&dof, terms)| (dof, terms))
    }

    /// Returns a degree of freedom as a combination of independent ones.
    pub fn form(&self, dof: usize) -> SparseVector {
        self.of(dof).cloned().unwrap_or_else(|| SparseVector { entries: vec![(dof, 1.0)] })
    }
}

/// Returns the label of a constraint.
pub fn label(constraint: &Constraint) -> u64 {
    match constraint {
        Constraint::Rigid { label, .. }
        | Constraint::WeightedAverage { label, .. }
        | Constraint::Equation { label, .. } => *label,
    }
}

/// Resolves the terms of a dependent degree of freedom that are dependent themselves. `open` are
/// the degrees of freedom that wait for it.
fn resolve(
    model: &ElasticModel,
    dof: usize,
    raw: &BTreeMap<usize, Raw>,
    resolved: &mut BTreeMap<usize, SparseVector>,
    open: &mut Vec<usize>,
) -> Result<(), ElementError> {
    if resolved.contains_key(&dof) {
        return Ok(());
    }
    if open.contains(&dof) || open.len() > 1000 {
        return Err(ElementError::new(
            format!(
                "constraint {}: component {} of node {} depends on itself",
                raw[&dof].label,
                dof % 6 + 1,
                model.nodes[dof / 6].label
            ),
            "remove the circle of constraints",
        ));
    }
    open.push(dof);
    let mut entries = Vec::new();
    for &(term, factor) in &raw[&dof].terms {
        if raw.contains_key(&term) {
            resolve(model, term, raw, resolved, open)?;
            entries.extend(resolved[&term].entries.iter().map(|&(dof, value)| (dof, factor * value)));
        } else {
            entries.push((term, factor));
        }
    }
    open.pop();
    let sum: SparseVector = entries.into_iter().collect();
    let entries = sum.entries.into_iter().filter(|entry| entry.1 != 0.0).collect();
    resolved.insert(dof, SparseVector { entries });
    Ok(())
}

fn axes(node: &Node) -> [Vector3<f64>; 3] {
    node.axes.map(Vector3::from)
}

/// Returns a component of a node by the motion of a rigid body with the point `about`: its
/// translations and rotations along the basic axes.
pub fn rigid_row(node: &Node, component: Component, about: [f64; 3]) -> Vector6<f64> {
    let axis = axes(node)[component % 3];
    if component >= 3 {
        return Vector6::new(0.0, 0.0, 0.0, axis.x, axis.y, axis.z);
    }
    // a . (theta x r) = (r x a) . theta
    let moment = (Vector3::from(node.position) - Vector3::from(about)).cross(&axis);
    Vector6::new(axis.x, axis.y, axis.z, moment.x, moment.y, moment.z)
}

/// Dependent degrees of freedom with their terms.
type Combinations = Vec<(usize, Vec<(usize, f64)>)>;

fn combinations(model: &ElasticModel, constraint: &Constraint) -> Result<Combinations, ElementError> {
    let node = |index: usize| {
        model.nodes.get(index).ok_or_else(|| {
            ElementError::new("the constraint refers to a node that does not exist", "define all nodes")
        })
    };
    match constraint {
        Constraint::Rigid { reference, dependents, .. } => {
            let leader = node(*reference)?;
            let mut combinations = Vec::new();
            for &(index, components) in dependents {
                let follower = node(index)?;
                for component in (0..6).filter(|&component| components[component]) {
                    let row = in_axes(rigid_row(follower, component, leader.position), leader);
                    let terms = (0..6).filter(|&k| row[k] != 0.0).map(|k| (6 * reference + k, row[k]));
                    combinations.push((6 * index + component, terms.collect()));
                }
            }
            Ok(combinations)
        }
        Constraint::WeightedAverage { reference, components, terms, .. } => {
            for &(_, index, _) in terms {
                node(index)?;
            }
            average(model, *reference, node(*reference)?, components, terms)
        }
        Constraint::Equation { terms, .. } => {
            for &(index, component, _) in terms {
                node(index)?;
                if component > 5 {
                    return Err(ElementError::new("a component is not between 1 and 6", "correct it"));
                }
            }
            let Some(&(index, component, factor)) = terms.first().filter(|term| term.2 != 0.0) else {
                return Err(ElementError::new(
                    "the first coefficient of the equation is zero",
                    "begin with a component that the equation determines",
                ));
            };
            let others = terms[1..].iter().map(|&(node, other, value)| (6 * node + other, -value / factor));
            Ok(vec![(6 * index + component, others.collect())])
        }
    }
}

/// Converts a row over motions along the basic axes to the displacement axes of a node.
fn in_axes(row: Vector6<f64>, node: &Node) -> Vector6<f64> {
    let axes = axes(node);
    let (translation, rotation) = (row.fixed_rows::<3>(0), row.fixed_rows::<3>(3));
    Vector6::from_fn(|k, _| if k < 3 { axes[k].dot(&translation) } else { axes[k - 3].dot(&rotation) })
}

/// Returns the motion of the reference node that has the least weighted sum of squared differences
/// to the other nodes. Rotations of nodes have the weight of a translation at their mean distance.
fn average(
    model: &ElasticModel,
    reference: usize,
    leader: &Node,
    components: &Components,
    terms: &[(f64, usize, Components)],
) -> Result<Combinations, ElementError> {
    if terms.iter().any(|term| !(term.0 >= 0.0 && term.0.is_finite())) {
        return Err(ElementError::new("a weight is negative or not finite", "state positive weights"));
    }
    let distance =
        |index: usize| (Vector3::from(model.nodes[index].position) - Vector3::from(leader.position)).norm();
    let mean = terms.iter().map(|term| distance(term.1)).sum::<f64>() / terms.len().max(1) as f64;
    let length = if mean > 0.0 { mean } else { 1.0 };
    // Rotations of the reference node are scaled by the length.
    let mut rows: Vec<(usize, f64, Vector6<f64>)> = Vec::new();
    for &(weight, index, components) in terms {
        for component in (0..6).filter(|&component| components[component]) {
            let mut row = rigid_row(&model.nodes[index], component, leader.position);
            row.fixed_rows_mut::<3>(3).scale_mut(1.0 / length);
            let scale = if component < 3 { 1.0 } else { length };
            rows.push((6 * index + component, weight * scale * scale, row));
        }
    }
    let mut normal = Matrix6::zeros();
    for (_, weight, row) in &rows {
        normal += *weight * row * row.transpose();
    }
    let eigen = SymmetricEigen::new(normal);
    let largest = eigen.eigenvalues.max();
    let leader_axes = axes(leader);
    let mut combinations = Vec::new();
    for component in (0..6).filter(|&component| components[component]) {
        let axis = leader_axes[component % 3];
        let mut request = Vector6::zeros();
        request.fixed_rows_mut::<3>(component / 3 * 3).copy_from(&axis);
        let mut solution = Vector6::zeros();
        for (k, &value) in eigen.eigenvalues.iter().enumerate() {
            let vector = eigen.eigenvectors.column(k);
            let share = vector.dot(&request);
            if value > SINGULAR * largest {
                solution += vector * (share / value);
            } else if share.abs() > 1e-6 {
                return Err(ElementError::new(
                    format!(
                        "the averaged nodes do not determine component {} of node {}",
                        component + 1,
                        leader.label
                    ),
                    "add nodes that are not on one line, or add their rotations",
                ));
            }
        }
        let scale = if component < 3 { 1.0 } else { 1.0 / length };
        let terms = rows.iter().map(|(dof, weight, row)| (*dof, scale * weight * row.dot(&solution)));
        combinations.push((6 * reference + component, terms.collect()));
    }
    Ok(combinations)
}
