//! Cases of a vibration from the motions of its nodes in any file.

use super::cases::{CaseKind, Nodes, QUANTITIES, Skipped, VibrationCase, refused, to_velocity};
use calyx_numerics::error::EngineError;
use faer::c64;
use std::collections::{BTreeMap, BTreeSet};

/// Labels of nodes, with amplitudes of their translations along the global axes.
type NodalValues = Vec<(i64, [c64; 3])>;

/// Motion of nodes at one frequency.
pub(super) struct NodalMotion<'f> {
    /// Location in the file.
    pub place: String,
    /// Kind.
    pub kind: CaseKind,
    /// Frequency, Hz, above zero.
    pub frequency: f64,
    /// Quantity, one of [`QUANTITIES`].
    pub quantity: i64,
    /// Returns the values in the units of the file. Values of motions that are skipped are never
    /// converted.
    pub values: Box<dyn Fn() -> NodalValues + 'f>,
}

/// Converts motions to cases, one of each kind and frequency: velocities are preferred to
/// displacements, and those to accelerations.
///
/// # Errors
/// E0784: a node that is not in the file or has two values, or a value that is not finite.
pub(super) fn motion_cases(
    motions: Vec<NodalMotion<'_>>,
    nodes: &Nodes<'_>,
    skipped: &mut Skipped,
) -> Result<Vec<VibrationCase>, EngineError> {
    let rank = |motion: &NodalMotion<'_>| QUANTITIES.iter().position(|quantity| *quantity == motion.quantity);
    // Bits of positive numbers have the order of the numbers.
    let mut found: BTreeMap<(CaseKind, u64), NodalMotion<'_>> = BTreeMap::new();
    for motion in motions {
        let key = (motion.kind.clone(), motion.frequency.to_bits());
        match found.get(&key) {
            Some(other) if rank(other) <= rank(&motion) => {
                skipped.add("further motion of the same case and frequency");
            }
            other => {
                other.iter().for_each(|_| skipped.add("further motion of the same case and frequency"));
                found.insert(key, motion);
            }
        }
    }
    found.into_values().map(|motion| case(motion, nodes)).collect()
}

fn case(motion: NodalMotion<'_>, nodes: &Nodes<'_>) -> Result<VibrationCase, EngineError> {
    let NodalMotion { place, kind, frequency, quantity, values } = motion;
    let to_velocity = to_velocity(quantity, frequency) / nodes.factor;
    let mut velocities = vec![[c64::new(f64::NAN, 0.0); 3]; nodes.index.len()];
    let mut known: BTreeSet<i64> = BTreeSet::new();
    for (label, value) in values() {
        let at_node = |message: String, help: &str| refused(format!("{place}: {message}"), help);
        if !nodes.positions.contains_key(&label) {
            let message = format!("the results have the node {label}, which is not in the {}", nodes.owner);
            return Err(at_node(message, nodes.help));
        }
        if !known.insert(label) {
            let message = format!("the results have the node {label} twice");
            return Err(at_node(message, "leave one of its values out"));
        }
        let own = value.map(|component| component * to_velocity);
        if !own.iter().all(|value| value.re.is_finite() && value.im.is_finite()) {
            let message = format!("the velocity of the node {label} is not finite");
            return Err(at_node(message, "correct the values"));
        }
        if let Some(&node) = nodes.index.get(&label) {
            velocities[node] = own;
        }
    }
    Ok(VibrationCase { kind, frequency, place, velocities })
}
