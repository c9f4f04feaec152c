//! Certificate of a local optimum, after Karush, Kuhn and Tucker: nonnegative multipliers of the
//! active functions, whose gradients balance.

use super::evaluation::{Evaluator, Functions, Stop};
use super::functions::Shape;
use calyx_report::optimization::{Multiplier, Optimality};
use std::collections::BTreeMap;

/// Step of the gradients, relative to the ranges of the variables.
const STEP: f64 = 1e-4;
/// Distance of a function from the largest one below which it is active, relative to the magnitude
/// of the objective or bound.
const NEAR: f64 = 2e-3;

/// Function near its bound, with its gradient by the coordinates of the unit cube.
struct Active {
    /// Constraint and load case; `None` for the objective's common bound.
    constraint: Option<usize>,
    case: usize,
    /// True for a bound of a variable.
    is_bound: bool,
    gradient: Vec<f64>,
}

/// Returns the multipliers at a design; `None` if a design near it failed.
///
/// `scale` is the magnitude of the objective.
///
/// # Errors
/// The optimization is cancelled, or the journal cannot be written.
pub fn certificate(evaluator: &Evaluator<'_>, at: &[f64], scale: f64) -> Result<Option<Optimality>, Stop> {
    let functions = |at: &[f64]| evaluator.functions(0, at, Shape::Positions, scale);
    let Some(center) = functions(at)? else { return Ok(None) };
    let exact = evaluator.slopes(at, Shape::Positions, scale)?.unwrap_or_default();
    let values = all_of(&center);
    let mut slopes: Vec<Vec<f64>> = Vec::new();
    for k in 0..at.len() {
        let exact = exact.get(k).and_then(Option::as_ref).filter(|exact| exact.len() == values.len());
        if let Some(exact) = exact {
            slopes.push(exact.clone());
            continue;
        }
        // Central differences, and one-sided ones at the ends of the ranges.
        let ends = [-STEP, STEP].map(|step| (at[k] + step).clamp(0.0, 1.0));
        let moved = |end: f64| {
            let mut moved = at.to_vec();
            moved[k] = end;
            Ok(functions(&moved)?.map(|found| all_of(&found)))
        };
        let (Some(below), Some(above)) = (moved(ends[0])?, moved(ends[1])?) else { return Ok(None) };
        if below.len() != values.len() || above.len() != values.len() {
            return Ok(None);
        }
        let width = ends[1] - ends[0];
        slopes.push(above.iter().zip(&below).map(|(above, below)| (above - below) / width).collect());
    }
    Ok(Some(balance(&active(at, &center, &slopes))))
}

/// Returns the functions of the objective and then those of the constraints.
fn all_of(functions: &Functions) -> Vec<f64> {
    let constraints = functions.constraints.iter().map(|(_, value)| *value);
    functions.objective.iter().copied().chain(constraints).collect()
}

/// `slopes` are the derivatives of all functions by each variable.
fn active(at: &[f64], center: &Functions, slopes: &[Vec<f64>]) -> Vec<Active> {
    let gradient = |function: usize| slopes.iter().map(|slopes| slopes[function]).collect::<Vec<f64>>();
    let largest = center.objective.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut all = Vec::new();
    for (index, value) in center.objective.iter().enumerate() {
        if largest - value <= NEAR {
            let case = center.cases.get(index).copied().unwrap_or_default();
            all.push(Active { constraint: None, case, is_bound: false, gradient: gradient(index) });
        }
    }
    for (index, ((constraint, case), value)) in center.constraints.iter().enumerate() {
        if *value >= -NEAR {
            let gradient = gradient(center.objective.len() + index);
            all.push(Active { constraint: Some(*constraint), case: *case, is_bound: false, gradient });
        }
    }
    for (k, part) in at.iter().enumerate() {
        for (distance, sign) in [(*part, -1.0), (1.0 - part, 1.0)] {
            if distance <= NEAR {
                let mut gradient = vec![0.0; at.len()];
                gradient[k] = sign;
                all.push(Active { constraint: None, case: 0, is_bound: true, gradient });
            }
        }
    }
    all
}

/// Finds nonnegative multipliers, those of the objective with the sum one, for which the weighted
/// sum of the gradients is smallest.
fn balance(all: &[Active]) -> Optimality {
    let largest = all.iter().filter(|one| !one.is_bound).map(|one| norm(&one.gradient)).fold(0.0, f64::max);
    let weight = 100.0 * largest.max(f64::MIN_POSITIVE);
    // An equation per variable, and one with a large weight for the sum.
    let column = |one: &Active| {
        let mut column = one.gradient.clone();
        column.push(if one.constraint.is_none() && !one.is_bound { weight } else { 0.0 });
        column
    };
    let columns: Vec<Vec<f64>> = all.iter().map(column).collect();
    let rows = columns.first().map_or(1, Vec::len);
    let mut target = vec![0.0; rows];
    target[rows - 1] = weight;
    let multipliers = nonnegative_least_squares(&columns, &target);
    let mut sum = vec![0.0; rows - 1];
    let mut by_function: BTreeMap<(Option<usize>, usize), f64> = BTreeMap::new();
    for ((one, column), multiplier) in all.iter().zip(&columns).zip(&multipliers) {
        sum.iter_mut().zip(column).for_each(|(sum, part)| *sum += multiplier * part);
        if !one.is_bound && *multiplier > 1e-6 {
            *by_function.entry((one.constraint, one.case)).or_default() += multiplier;
        }
    }
    let multipliers = by_function
        .into_iter()
        .map(|((constraint, case), value)| Multiplier { constraint, case, value })
        .collect();
    Optimality { multipliers, residual: norm(&sum) }
}

fn norm(vector: &[f64]) -> f64 {
    vector.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// Finds nonnegative weights that minimize the length of the weighted sum of the columns minus the
/// target: the algorithm of Lawson and Hanson, "Solving Least Squares Problems" (1974), chapter 23.
fn nonnegative_least_squares(columns: &[Vec<f64>], target: &[f64]) -> Vec<f64> {
    let mut weights = vec![0.0; columns.len()];
    let mut chosen: Vec<usize> = Vec::new();
    // Each pass adds a column, so that few passes suffice; rounding could make it return to earlier
    // ones.
    for _ in 0..3 * columns.len() {
        let rest = remainder(columns, &weights, target);
        let slope = |k: usize| dot(&columns[k], &rest) / norm(&columns[k]).max(f64::MIN_POSITIVE);
        let open = (0..columns.len()).filter(|k| !chosen.contains(k));
        let Some(next) = open.max_by(|one, other| slope(*one).total_cmp(&slope(*other))) else { break };
        if slope(next) <= 1e-10 * norm(target) {
            break;
        }
        chosen.push(next);
        while let Some(trial) = least_squares(columns, &chosen, target) {
            if trial.iter().all(|weight| *weight > 0.0) {
                chosen.iter().zip(&trial).for_each(|(&k, weight)| weights[k] = *weight);
                break;
            }
            // The largest part of the way on which all weights remain nonnegative.
            let part = |(&k, trial): (&usize, &f64)| {
                if *trial > 0.0 { f64::INFINITY } else { weights[k] / (weights[k] - trial) }
            };
            let way = chosen.iter().zip(&trial).map(part).fold(1.0, f64::min);
            let way = if way.is_finite() { way } else { 0.0 };
            for (&k, trial) in chosen.iter().zip(&trial) {
                weights[k] += way * (trial - weights[k]);
                if weights[k] <= 1e-14 {
                    weights[k] = 0.0;
                }
            }
            chosen.retain(|&k| weights[k] > 0.0);
        }
        // Dependent columns: the last one adds nothing.
        if chosen.last().is_some_and(|&k| weights[k] == 0.0) {
            chosen.pop();
            break;
        }
    }
    weights
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// Returns the target minus the weighted sum of the columns.
fn remainder(columns: &[Vec<f64>], weights: &[f64], target: &[f64]) -> Vec<f64> {
    let mut rest = target.to_vec();
    for (column, weight) in columns.iter().zip(weights).filter(|(_, weight)| **weight != 0.0) {
        rest.iter_mut().zip(column).for_each(|(rest, part)| *rest -= weight * part);
    }
    rest
}

/// Solves the unconstrained problem for some of the columns, by the normal equations and
/// elimination with pivots; `None` if they are dependent.
fn least_squares(columns: &[Vec<f64>], chosen: &[usize], target: &[f64]) -> Option<Vec<f64>> {
    let count = chosen.len();
    let entry = |row: usize, column: usize| match column {
        column if column < count => dot(&columns[chosen[row]], &columns[chosen[column]]),
        _ => dot(&columns[chosen[row]], target),
    };
    let mut matrix: Vec<Vec<f64>> =
        (0..count).map(|row| (0..=count).map(|column| entry(row, column)).collect()).collect();
    let largest = (0..count).map(|k| matrix[k][k]).fold(0.0, f64::max);
    for k in 0..count {
        let pivot =
            (k..count).max_by(|one, other| matrix[*one][k].abs().total_cmp(&matrix[*other][k].abs()))?;
        matrix.swap(k, pivot);
        if matrix[k][k].abs() <= 1e-13 * largest {
            return None;
        }
        let row = matrix[k].clone();
        for below in matrix.iter_mut().skip(k + 1) {
            let factor = below[k] / row[k];
            below.iter_mut().zip(&row).skip(k).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    let mut solution = vec![0.0; count];
    for k in (0..count).rev() {
        let known: f64 = (k + 1..count).map(|column| matrix[k][column] * solution[column]).sum();
        solution[k] = (matrix[k][count] - known) / matrix[k][k];
    }
    Some(solution)
}
