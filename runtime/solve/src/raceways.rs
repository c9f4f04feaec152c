//! Bearings whose outer raceway is the bore of an elastic body.

use crate::system::{Bodies, System};
use calyx_model::bearing::{Bearing, ElasticRaceway, HalfSpaceShare, NonlinearLoad, half_space_share};
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::EngineError;
use calyx_structure::Raceway;
use faer::MatRef;
use nalgebra::DMatrix;
use std::sync::Arc;

/// Bearing with rollers in the bore of an elastic body.
#[derive(Clone)]
pub(crate) struct BearingInBore {
    /// Index of the bearing in the scene.
    pub bearing: usize,
    /// Index of the body.
    body: usize,
    raceway: Raceway,
    /// Compliance of the terms of the raceway.
    compliance: Arc<DMatrix<f64>>,
    /// Half-space displacements in these terms, by row of the bearing.
    shares: Vec<HalfSpaceShare>,
}

/// Converts a matrix of the structures.
pub(crate) fn dense(matrix: MatRef<'_, f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| matrix[(row, column)])
}

/// Finds the modelled bearings whose rollers run in the bore of an elastic body.
pub(crate) fn find(scene: &Mechanism, bodies: &Bodies, modelled: &[usize]) -> Vec<BearingInBore> {
    let of = |&index: &usize| {
        let bearing: &Bearing = scene.bearings.get(index)?;
        let (elements, body) = (bearing.rolling()?, bearing.outer_body()?);
        let (raceway, compliance) = match bodies {
            Bodies::Plane(bodies) => {
                let structure = bodies.structures.get(body)?.as_deref()?;
                (structure.raceway()?, dense(structure.interface_compliance()?))
            }
            Bodies::Solid(bodies) => {
                let structure = bodies.structures.get(body)?.as_deref()?;
                (structure.raceway()?, dense(structure.interface_compliance()?))
            }
        };
        let shares = elements.bearing.rows().iter().map(|row| half_space_share(row, &raceway)).collect();
        Some(BearingInBore { bearing: index, body, raceway, compliance: Arc::new(compliance), shares })
    };
    modelled.iter().filter_map(of).collect()
}

impl System<'_> {
    /// Returns the elastic raceway of a bearing by its index in the scene at a time (s); `None` for
    /// one between rigid rings.
    ///
    /// # Errors
    /// Those of [`ElasticRaceway::at`].
    pub fn elastic_raceway(&self, bearing: usize, time: f64) -> Result<Option<ElasticRaceway>, EngineError> {
        let in_bore = self.raceways.iter().find(|in_bore| in_bore.bearing == bearing);
        let load = in_bore.and_then(|_| self.nonlinear_load(bearing, time));
        let (Some(in_bore), Some(NonlinearLoad::Rolling(elements))) = (in_bore, load) else {
            return Ok(None);
        };
        let placed = ElasticRaceway::at(
            &self.scene.bodies,
            (&self.scene.bearings[bearing], &elements),
            (in_bore.body, &in_bore.raceway, &in_bore.compliance),
            &in_bore.shares,
            self.width(in_bore.body),
            time,
        )?;
        Ok(Some(placed))
    }
}
