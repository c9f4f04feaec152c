//! Positions of a mechanism that are analysed.

use crate::pairs::GearMesh;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Position of the mechanism that is analysed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Position {
    /// Time, s.
    pub time: f64,
    /// Fraction of the mesh cycle, 0 to 1.
    pub cycle: f64,
    /// Roll angle of the first gear's tooth of the entering pair, rad.
    pub roll: f64,
    /// Name of a characteristic point, or empty.
    pub name: Cow<'static, str>,
}

impl Position {
    /// Creates a position from its time (s) alone, for a scene without a mesh cycle.
    pub fn at(time: f64) -> Position {
        Position { time, cycle: 0.0, roll: 0.0, name: Cow::Borrowed("") }
    }
}

/// Returns the positions of one mesh cycle: `steps` uniform positions from the start of contact of
/// a tooth pair, and the characteristic points of the path of contact.
///
/// The load on rigid teeth jumps where a pair enters or leaves contact. Positions lie a millionth
/// of the cycle on both sides of every jump: just before and after the entry of a pair, and just
/// before and after the exit of the leaving pair.
pub fn mesh_cycle(mesh: &GearMesh, steps: usize) -> Vec<Position> {
    const BESIDE: f64 = 1e-6;
    let mut at: Vec<(f64, &'static str)> = (0..steps).map(|i| (i as f64 / steps as f64, "")).collect();
    for point in &mesh.characteristic {
        let cycle = point.time / mesh.period + BESIDE * if point.after { 1.0 } else { -1.0 };
        // A uniform position at a jump would lie on neither side of it.
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
