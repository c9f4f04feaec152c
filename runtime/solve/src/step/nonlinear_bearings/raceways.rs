//! Elastic raceways in the equilibrium of nonlinear bearings.

use super::{Member, NonlinearBearings, NonlinearIteration, RacewayResult};
use calyx_contact::problem::ContactProblem;
use calyx_model::bearing::{NonlinearState, Tangent};
use calyx_numerics::error::EngineError;
use nalgebra::{DMatrix, DVector};

impl NonlinearBearings<'_> {
    /// Returns the growth of the gaps of cells by unit loads on the elastic raceways, by bearing;
    /// `of_terms` returns that by unit forces on the terms of the series of a body.
    pub(in crate::step) fn growths(
        &self,
        of_terms: impl Fn(usize) -> Result<DMatrix<f64>, EngineError>,
    ) -> Result<Vec<Option<DMatrix<f64>>>, EngineError> {
        let growth = |own: &Member| {
            let Some(raceways) = &own.raceways else { return Ok(None) };
            let Some(bore) = raceways.bore() else { return Ok(None) };
            Ok(raceways.growth(&of_terms(bore.body)?))
        };
        self.members.iter().map(growth).collect()
    }

    /// Adds the elements on elastic raceways to the cells of a contact problem.
    pub(super) fn put_raceways(
        &self,
        problem: &mut ContactProblem,
        tangents: &[Tangent],
        growths: &[Option<DMatrix<f64>>],
        start: &[f64],
    ) {
        for ((own, tangent), growth) in self.members.iter().zip(tangents).zip(growths) {
            if let (Some(raceways), Some(tangent), Some(growth)) = (&own.raceways, &tangent.raceway, growth) {
                raceways.put(problem, (tangent, growth), &own.arms, start);
            }
        }
    }

    /// Returns the displacements of elastic raceways by the forces on cells, by bearing.
    pub(super) fn moved_by(&self, growths: &[Option<DMatrix<f64>>], forces: &[f64]) -> Vec<Vec<f64>> {
        let mut moved = self.unmoved();
        for (moved, growth) in moved.iter_mut().zip(growths) {
            if let Some(growth) = growth {
                let on_cells = DVector::from_row_slice(&forces[..growth.nrows().min(forces.len())]);
                moved.copy_from_slice((growth.transpose() * on_cells).as_slice());
            }
        }
        moved
    }

    /// Returns the displacements of elastic raceways without forces on cells.
    pub(super) fn unmoved(&self) -> Vec<Vec<f64>> {
        self.members.iter().map(|own| vec![0.0; 3 * own.elements()]).collect()
    }

    /// Returns the elastic raceways.
    pub(in crate::step) fn raceways(&self, iteration: &NonlinearIteration) -> Vec<RacewayResult> {
        let members = self.members.iter().zip(&iteration.states);
        let elastic = members.filter(|(own, _)| own.raceways.is_some());
        let result = |(own, state): (&Member, &NonlinearState)| RacewayResult {
            bearing: own.bearing,
            displacement: state.raceway.clone(),
            loads: state.raceway_loads.iter().flat_map(|own| own.force).collect(),
        };
        elastic.map(result).collect()
    }
}
