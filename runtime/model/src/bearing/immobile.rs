//! Directions in which a bearing cannot deflect, because its bodies are fixed there.

use super::{Bearing, BearingMatrix, BearingState, NonlinearLoad, Stop};
use crate::body::Body;
use crate::dof::Dof;
use calyx_numerics::error::EngineError;

/// Forces and deflections below this fraction of the largest are rounding.
const ROUNDING: f64 = 1e-9;

/// Deflections that the free components of the bodies of a bearing permit, and those that it
/// resists.
pub struct Mobility {
    /// For each direction of the bearing, in the order of [`crate::dof::DOF_NAMES`]: its bodies can
    /// move there.
    pub moves: [bool; 6],
    /// For each direction: springs, dampers, stops or rolling elements resist.
    pub resists: [bool; 6],
    /// No motion of its bodies causes a force.
    pub is_idle: bool,
}

impl Bearing {
    /// Finds the directions in which the bearing can deflect at time 0, and those that it resists.
    ///
    /// # Errors
    /// Those of [`BearingState::at`].
    pub fn mobility(&self, bodies: &[Body]) -> Result<Mobility, EngineError> {
        let placed = BearingState::at(bodies, self, 0.0)?;
        let free = |body: usize| bodies.get(body).map_or([false; 6], |body| body.free);
        let dofs = self.bodies().flat_map(|body| {
            (0..6).filter(move |&k| free(body.0)[k]).map(move |component| Dof { body: body.0, component })
        });
        let columns: Vec<[f64; 6]> = dofs.map(|dof| placed.deflection(&dof)).collect();
        let typical = self.nonlinear.as_ref().map(NonlinearLoad::typical_stiffness);
        let matrices: Vec<BearingMatrix> =
            [self.stiffness, self.damping].into_iter().chain(typical).collect();
        let walls: Vec<[f64; 6]> = self
            .stops
            .iter()
            .flat_map(|stop| match stop {
                Stop::Wall { direction, .. } => vec![*direction],
                Stop::Ring { .. } => vec![[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]],
            })
            .collect();
        let resists = std::array::from_fn(|k| {
            matrices.iter().any(|matrix| matrix[k][k] > 0.0) || walls.iter().any(|wall| wall[k] != 0.0)
        });
        let largest = columns.iter().flatten().fold(0.0f64, |most, part| most.max(part.abs()));
        let moves =
            std::array::from_fn(|k| columns.iter().any(|column| column[k].abs() > ROUNDING * largest));
        let is_resisted = |column: &[f64; 6]| {
            let by_matrix = |matrix: &BearingMatrix| {
                let terms = |row: &[f64; 6]| -> [f64; 6] { std::array::from_fn(|k| row[k] * column[k]) };
                let size = matrix.iter().flat_map(terms).fold(0.0f64, |most, term| most.max(term.abs()));
                matrix.iter().any(|row| terms(row).iter().sum::<f64>().abs() > ROUNDING * size)
            };
            let by_wall = |wall: &[f64; 6]| wall.iter().zip(column).any(|(wall, part)| wall * part != 0.0);
            matrices.iter().any(by_matrix) || walls.iter().any(by_wall)
        };
        Ok(Mobility { moves, resists, is_idle: !columns.iter().any(is_resisted) })
    }
}
