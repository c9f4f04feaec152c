//! Bearings whose raceways are the bore of a gear or seats of elastic bodies.

use calyx_model::bearing::{
    BodyRaceway, ElasticRaceways, PositionOnCylinder, RacewayCylinder, RacewayOwner, Ring, RollingElements,
    SeatTerms, half_space_shares,
};
use calyx_model::connection::{ElasticConnection, Seat};
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::EngineError;
use calyx_structure::{Raceway, RacewayMatrices};
use faer::MatRef;
use nalgebra::{DMatrix, SymmetricEigen};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Bearing on elastic raceways.
#[derive(Clone)]
pub(crate) struct BearingOnRaceways {
    /// Index of the bearing in the scene.
    pub bearing: usize,
    raceways: Vec<BodyRaceway>,
}

/// Bearings on elastic raceways.
#[derive(Clone, Default)]
pub(crate) struct RacewaySet {
    pub bearings: Vec<BearingOnRaceways>,
    /// `L` with the compliance `L L'` of the terms of all seats, by elastic connection.
    pub factors: BTreeMap<usize, Arc<DMatrix<f64>>>,
}

/// Converts a matrix of the structures.
pub(crate) fn dense(matrix: MatRef<'_, f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| matrix[(row, column)])
}

/// Finds the modelled bearings that run on elastic raceways. `raceway_of` returns the raceway in
/// the bore of a gear with its plane-strain modulus (Pa) and the compliance of its terms, if it has
/// one.
pub(crate) fn find(
    scene: &Mechanism,
    modelled: &[usize],
    connections: &[ElasticConnection],
    raceway_of: impl Fn(usize) -> Option<(Raceway, f64, DMatrix<f64>)>,
) -> RacewaySet {
    let mut set = RacewaySet::default();
    for &index in modelled {
        let Some(bearing) = scene.bearings.get(index) else { continue };
        let Some(elements) = bearing.rolling() else { continue };
        let on = |ring: Ring| {
            let body = bearing.body_of(ring)?;
            // Elements outside of a gear run on its teeth.
            let in_gear = (ring == Ring::Outer).then(|| raceway_of(body)).flatten();
            let in_gear = in_gear.map(|(series, modulus, compliance)| {
                let cylinder = RacewayCylinder::bore(body, series.radius);
                (cylinder, series, modulus, RacewayOwner::Gear(Arc::new(compliance)))
            });
            let (cylinder, series, modulus, owner) = in_gear.or_else(|| in_seat(connections, body))?;
            // A bearing that is not coaxial is rejected at its position.
            let placed = PositionOnCylinder::at(&scene.bodies, bearing, &cylinder, 0.0).ok();
            let shares = half_space_shares(elements, (ring, &series, modulus), placed);
            Some(BodyRaceway { cylinder, ring, series, shares, owner })
        };
        let raceways: Vec<BodyRaceway> = [Ring::Outer, Ring::Inner].into_iter().filter_map(on).collect();
        for raceway in &raceways {
            if let RacewayOwner::Seat(SeatTerms { connection, .. }) = raceway.owner {
                set.factors.entry(connection).or_insert_with(|| Arc::new(factor(&connections[connection])));
            }
        }
        if !raceways.is_empty() {
            set.bearings.push(BearingOnRaceways { bearing: index, raceways });
        }
    }
    set
}

/// Returns the raceway of the seat of an elastic body and its plane-strain modulus (Pa) by the
/// index of its attachment among the bodies.
fn in_seat(
    connections: &[ElasticConnection],
    body: usize,
) -> Option<(RacewayCylinder, Raceway, f64, RacewayOwner)> {
    let with_raceways = connections.iter().enumerate();
    let mut with_raceways = with_raceways.filter(|(_, connection)| connection.raceways.terms() > 0);
    with_raceways.find_map(|(connection, own)| {
        let Seat { raceway: seat, first_term: first, .. } =
            own.seats().into_iter().find(|seat| seat.body == body)?;
        let owner = RacewayOwner::Seat(SeatTerms { connection, first });
        Some((RacewayCylinder::seat(body, &seat), seat.raceway, seat.modulus, owner))
    })
}

/// Returns a factor of the compliance of the terms of all seats of an elastic body.
fn factor(connection: &ElasticConnection) -> DMatrix<f64> {
    let RacewayMatrices { compliance, .. } = &connection.raceways;
    let terms = connection.raceways.terms();
    square_root(DMatrix::from_row_slice(terms, terms, compliance))
}

/// Returns a factor `L` of a positive semidefinite matrix `L L'`.
fn square_root(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(matrix);
    eigenvectors * DMatrix::from_diagonal(&eigenvalues.map(|value| value.max(0.0).sqrt()))
}

impl BearingOnRaceways {
    /// Places the raceways at a time (s), with these elements of the bearing; `width` (m) is that
    /// of a body in a plane model and 1 in three dimensions.
    ///
    /// # Errors
    /// Those of [`ElasticRaceways::at`].
    pub fn at(
        &self,
        scene: &Mechanism,
        elements: &RollingElements,
        width: impl Fn(usize) -> f64,
        time: f64,
    ) -> Result<ElasticRaceways, EngineError> {
        let bearing = &scene.bearings[self.bearing];
        let width = self.raceways.first().map_or(1.0, |raceway| width(raceway.cylinder.body));
        ElasticRaceways::at(&scene.bodies, (bearing, elements), &self.raceways, width, time)
    }
}
