//! Bearings whose outer raceway is the bore of a gear or a seat of an elastic body.

use calyx_model::bearing::{
    Bearing, ElasticRaceway, HalfSpaceShare, RacewayCylinder, RollingElements, Support, half_space_share,
};
use calyx_model::connection::ElasticConnection;
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::EngineError;
use calyx_structure::Raceway;
use faer::MatRef;
use nalgebra::DMatrix;
use std::sync::Arc;

/// Bearing with rollers on an elastic raceway.
#[derive(Clone)]
pub(crate) struct BearingOnRaceway {
    /// Index of the bearing in the scene.
    pub bearing: usize,
    cylinder: RacewayCylinder,
    raceway: Raceway,
    pub of: RacewayOwner,
    /// Half-space displacements in the terms of the raceway, by row of the bearing.
    shares: Vec<HalfSpaceShare>,
}

/// What an elastic raceway is a part of.
#[derive(Clone)]
pub(crate) enum RacewayOwner {
    /// Gear, with the compliance of the terms in its bore.
    Gear(Arc<DMatrix<f64>>),
    /// Elastic connection of this index, with the first of its coefficients that belong to the seat.
    Connection { index: usize, first_term: usize },
}

/// Converts a matrix of the structures.
pub(crate) fn dense(matrix: MatRef<'_, f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| matrix[(row, column)])
}

/// Finds the modelled bearings whose rollers run on an elastic raceway. `raceway_of` returns the
/// raceway in the bore of a gear with the compliance of its terms, if it has one.
pub(crate) fn find(
    scene: &Mechanism,
    modelled: &[usize],
    connections: &[ElasticConnection],
    raceway_of: impl Fn(usize) -> Option<(Raceway, DMatrix<f64>)>,
) -> Vec<BearingOnRaceway> {
    let of = |&index: &usize| {
        let bearing: &Bearing = scene.bearings.get(index)?;
        let (elements, body) = (bearing.rolling()?, bearing.outer_body()?);
        let in_gear = raceway_of(body).map(|(raceway, compliance)| {
            let cylinder = RacewayCylinder::bore(body, raceway.radius);
            (cylinder, raceway, RacewayOwner::Gear(Arc::new(compliance)))
        });
        let (cylinder, raceway, of) = in_gear.or_else(|| in_seat(connections, body))?;
        let shares = elements.bearing.rows().iter().map(|row| half_space_share(row, &raceway)).collect();
        Some(BearingOnRaceway { bearing: index, cylinder, raceway, of, shares })
    };
    modelled.iter().filter_map(of).collect()
}

/// Returns the raceway in the seat that a body is.
fn in_seat(
    connections: &[ElasticConnection],
    body: usize,
) -> Option<(RacewayCylinder, Raceway, RacewayOwner)> {
    let with_raceways = connections.iter().enumerate();
    let mut with_raceways = with_raceways.filter(|(_, connection)| connection.raceways.terms() > 0);
    with_raceways.find_map(|(index, connection)| {
        let seats = connection.body.as_ref()?.0.raceways();
        let is_on = |to: Support| matches!(to, Support::Body(id) if id.0 == body);
        let at = connection.attachments.iter().position(|attachment| is_on(attachment.to))?;
        let seat = (*seats.get(at)?)?;
        let first_term = seats[..at].iter().flatten().map(|seat| seat.raceway.terms()).sum();
        let owner = RacewayOwner::Connection { index, first_term };
        Some((RacewayCylinder::seat(body, &seat), seat.raceway, owner))
    })
}

impl BearingOnRaceway {
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
        let compliance = match &self.of {
            RacewayOwner::Gear(compliance) => Some(compliance.as_ref()),
            RacewayOwner::Connection { .. } => None,
        };
        ElasticRaceway::at(
            &scene.bodies,
            (&scene.bearings[self.bearing], elements),
            (&self.cylinder, &self.raceway, compliance),
            &self.shares,
            width(self.cylinder.body),
            time,
        )
    }
}
