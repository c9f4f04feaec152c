//! Motion of nodes from functions of their DOFs (dataset 58): response spectra.

use super::cases::{CaseKind, Nodes, QUANTITIES, Skipped, VibrationCase, refused, to_velocity};
use crate::unv::{Abscissae, Function, Ordinates, UnvDataset, UnvFile};
use calyx_numerics::error::EngineError;
use faer::c64;
use std::collections::{BTreeMap, BTreeSet};

/// Function types: general, frequency response, and spectrum.
const KINDS: [i64; 3] = [0, 4, 12];
/// Data types of an abscissa: unknown and frequency.
const FREQUENCY: [i64; 2] = [0, 18];
/// Data type of excitation forces.
const FORCE: i64 = 13;
/// Relative difference of frequencies of two functions that counts as rounding of their fields.
const SAME: f64 = 1e-5;

/// Functions of one reference and quantity, with their places in the file.
type Group<'f> = Vec<(usize, &'f Function)>;

/// Returns the motions of all functions. Directions without a function are at rest.
///
/// # Errors
/// E0784: functions have different frequencies, a node that is not in the file, or values that are
/// not finite.
pub(super) fn function_cases(
    file: &UnvFile,
    nodes: &Nodes<'_>,
    skipped: &mut Skipped,
) -> Result<Vec<VibrationCase>, EngineError> {
    let mut groups: BTreeMap<String, BTreeMap<usize, Group<'_>>> = BTreeMap::new();
    for (at, dataset) in file.datasets.iter().enumerate() {
        let UnvDataset::Function(function) = dataset else { continue };
        let Some(rank) = rank(function, skipped) else { continue };
        if !nodes.positions.contains_key(&function.response.node) {
            return Err(refused(
                format!(
                    "{}: the function has the node {}, which is not in the file",
                    file.place(at),
                    function.response.node
                ),
                "export the nodes (dataset 2411) of all functions",
            ));
        }
        let end = &function.reference;
        let reference = match end.node {
            0 => function.numbers[2].to_string(),
            node => format!("{node}:{:+}", end.direction),
        };
        groups.entry(reference).or_default().entry(rank).or_default().push((at, function));
    }
    let force = file.force_factor();
    let mut cases = Vec::new();
    for (reference, by_rank) in groups {
        for (number, (_, group)) in by_rank.into_iter().enumerate() {
            match number {
                0 => cases.extend(group_cases(file, &reference, &group, (nodes, force), skipped)?),
                _ => group.iter().for_each(|_| skipped.add("function of a further quantity")),
            }
        }
    }
    Ok(cases)
}

/// Returns the rank of the quantity of a function; `None` for others, which are skipped.
fn rank(function: &Function, skipped: &mut Skipped) -> Option<usize> {
    let [abscissa, ordinate, denominator, _] = &function.axes;
    let rank = QUANTITIES.iter().position(|quantity| *quantity == ordinate.quantity);
    let reason = if !KINDS.contains(&function.kind) {
        format!("function of the type {}", function.kind)
    } else if !FREQUENCY.contains(&abscissa.quantity) {
        format!("function over the quantity {}", abscissa.quantity)
    } else if rank.is_none() {
        format!("function of the quantity {}, which is no motion", ordinate.quantity)
    } else if ![0, FORCE].contains(&denominator.quantity) {
        format!("function per quantity {}", denominator.quantity)
    } else if !(1..=3).contains(&function.response.direction.unsigned_abs()) {
        format!("function in the direction {}", function.response.direction)
    } else {
        return rank;
    };
    skipped.add(reason);
    None
}

/// Returns the abscissae of a function.
fn frequencies(function: &Function) -> Vec<f64> {
    let count = match &function.ordinates {
        Ordinates::Real(values, _) => values.len(),
        Ordinates::Complex(values, _) => values.len(),
    };
    match &function.abscissae {
        Abscissae::Even { first, increment } => (0..count).map(|k| first + increment * k as f64).collect(),
        Abscissae::All(all) => all.clone(),
    }
}

/// Returns the motions of functions with the same reference and quantity.
fn group_cases(
    file: &UnvFile,
    reference: &str,
    group: &Group<'_>,
    (nodes, force): (&Nodes<'_>, f64),
    skipped: &mut Skipped,
) -> Result<Vec<VibrationCase>, EngineError> {
    let Some((first, function)) = group.first() else { return Ok(Vec::new()) };
    let all = frequencies(function);
    let place = file.place(*first);
    if let Some(wrong) = all.iter().find(|at| !(**at >= 0.0 && at.is_finite())) {
        let message = format!("{place}: the function has the frequency {wrong} Hz");
        return Err(refused(message, "export functions at frequencies above zero"));
    }
    let rest = [c64::new(f64::NAN, 0.0); 3];
    let mut motions = vec![vec![rest; nodes.index.len()]; all.len()];
    let mut known: BTreeSet<(i64, u64)> = BTreeSet::new();
    for (at, function) in group {
        let own = frequencies(function);
        let is_same = |(one, other): (&f64, &f64)| (one - other).abs() <= SAME * one.abs().max(other.abs());
        if own.len() != all.len() || !own.iter().zip(&all).all(is_same) {
            let message = format!("{}: the function has other frequencies than {place}", file.place(*at));
            return Err(refused(message, "export all functions at the same frequencies"));
        }
        let end = &function.response;
        if !known.insert((end.node, end.direction.unsigned_abs())) {
            skipped.add("further function of the same node and direction");
            continue;
        }
        let Some(&node) = nodes.index.get(&end.node) else { continue };
        let per_force = if function.axes[2].quantity == FORCE { force } else { 1.0 };
        let factor = per_force * end.direction.signum() as f64 / nodes.factor;
        let axis = end.direction.unsigned_abs() as usize - 1;
        for (k, motion) in motions.iter_mut().enumerate() {
            let value = match &function.ordinates {
                Ordinates::Real(values, _) => values.get(k).map(|value| c64::new(*value, 0.0)),
                Ordinates::Complex(values, _) => values.get(k).copied(),
            };
            let value = value.unwrap_or(c64::new(f64::NAN, 0.0));
            let velocity = value * to_velocity(function.axes[1].quantity, all[k]) * factor;
            if all[k] > 0.0 && !(velocity.re.is_finite() && velocity.im.is_finite()) {
                let message = format!("{}: the value at {} Hz is not finite", file.place(*at), all[k]);
                return Err(refused(message, "correct the values"));
            }
            // Other directions without a function are at rest.
            if motion[node][0].re.is_nan() {
                motion[node] = [c64::new(0.0, 0.0); 3];
            }
            motion[node][axis] = velocity;
        }
    }
    let case = |(frequency, velocities): (f64, Vec<[c64; 3]>)| VibrationCase {
        kind: CaseKind::Response(reference.to_owned()),
        frequency,
        place: format!("functions (dataset 58) from line {}", file.lines.get(*first).unwrap_or(&0)),
        velocities,
    };
    let moving = all.into_iter().zip(motions).filter(|(frequency, _)| *frequency > 0.0);
    Ok(moving.map(case).collect())
}
