//! Bearings whose outer raceway is the bore of an elastic body.

use calyx_model::bearing::{Bearing, ElasticRaceway, HalfSpaceShare, RollingElements, half_space_share};
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

/// Finds the modelled bearings whose rollers run in the bore of an elastic body. `raceway_of`
/// returns the raceway of a body with the compliance of its terms, if it has one.
pub(crate) fn find(
    scene: &Mechanism,
    modelled: &[usize],
    raceway_of: impl Fn(usize) -> Option<(Raceway, DMatrix<f64>)>,
) -> Vec<BearingInBore> {
    let of = |&index: &usize| {
        let bearing: &Bearing = scene.bearings.get(index)?;
        let (elements, body) = (bearing.rolling()?, bearing.outer_body()?);
        let (raceway, compliance) = raceway_of(body)?;
        let shares = elements.bearing.rows().iter().map(|row| half_space_share(row, &raceway)).collect();
        Some(BearingInBore { bearing: index, body, raceway, compliance: Arc::new(compliance), shares })
    };
    modelled.iter().filter_map(of).collect()
}

impl BearingInBore {
    /// Places the raceway at a time (s), with these elements of the bearing; `width` (m) is that of
    /// the body in a plane model and 1 in three dimensions.
    ///
    /// # Errors
    /// Those of [`ElasticRaceway::at`].
    pub fn at(
        &self,
        scene: &Mechanism,
        elements: &RollingElements,
        width: impl Fn(usize) -> f64,
        time: f64,
    ) -> Result<ElasticRaceway, EngineError> {
        ElasticRaceway::at(
            &scene.bodies,
            (&scene.bearings[self.bearing], elements),
            (self.body, &self.raceway, &self.compliance),
            &self.shares,
            width(self.body),
            time,
        )
    }
}
