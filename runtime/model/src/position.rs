//! Positions at which a motion is analysed.

use crate::pairs::GearMesh;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Where the motion is analysed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// s
    pub time: f64,
    /// Part of the mesh cycle passed, 0 to 1.
    pub cycle: f64,
    /// Roll angle of the entering pair's first tooth, rad.
    pub roll: f64,
    /// Name of a characteristic point, or empty.
    pub name: Cow<'static, str>,
}

impl Position {
    /// A position by its time (s) alone, of a scene that has no mesh cycle.
    pub fn at(time: f64) -> Position {
        Position { time, cycle: 0.0, roll: 0.0, name: Cow::Borrowed("") }
    }
}

/// One mesh cycle: `steps` uniform positions from the moment a pair enters contact, and the characteristic points of
/// the path of contact.
///
/// Where a pair of rigid teeth enters or leaves, loads jump. Positions stand a millionth of the cycle beside every jump, on
/// both sides of it: just after a pair has entered and just before the next one does, just before the leaving pair leaves
/// and just after.
pub fn mesh_cycle(mesh: &GearMesh, steps: usize) -> Vec<Position> {
    const BESIDE: f64 = 1e-6;
    let mut at: Vec<(f64, &'static str)> = (0..steps).map(|i| (i as f64 / steps as f64, "")).collect();
    for point in &mesh.characteristic {
        let cycle = point.time / mesh.period + BESIDE * if point.after { 1.0 } else { -1.0 };
        // A uniform position at the jump itself would stand on neither side.
        at.retain(|&(other, name)| !(name.is_empty() && (other - cycle).abs() < 2.0 * BESIDE));
        at.push((cycle, point.name));
    }
    at.sort_by(|a, b| a.0.total_cmp(&b.0));
    at.into_iter()
        .map(|(cycle, name)| Position {
            time: mesh.start + cycle * mesh.period,
            cycle,
            roll: mesh.roll[0] + cycle * (mesh.roll[1] - mesh.roll[0]),
            name: Cow::Borrowed(name),
        })
        .collect()
}
