//! Bearings whose outer raceway is the bore of a gear or a seat of an elastic body.

use calyx_model::bearing::{
    Bearing, ElasticRaceway, HalfSpaceShare, InBore, RacewayCylinder, RollingElements, half_space_shares,
};
use calyx_model::connection::{ElasticConnection, Seat};
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::EngineError;
use calyx_structure::{Raceway, RacewayMatrices};
use faer::MatRef;
use nalgebra::{DMatrix, SymmetricEigen};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Bearing on an elastic raceway.
#[derive(Clone)]
pub(crate) struct BearingOnRaceway {
    /// Index of the bearing in the scene.
    pub bearing: usize,
    cylinder: RacewayCylinder,
    raceway: Raceway,
    pub owner: RacewayOwner,
    /// Half-space displacements in the terms of the raceway, by row of the bearing.
    shares: Vec<HalfSpaceShare>,
}

/// Owner of an elastic raceway.
#[derive(Clone)]
pub(crate) enum RacewayOwner {
    /// Gear, with the compliance of the terms in its bore.
    Gear(Arc<DMatrix<f64>>),
    /// Elastic connection of this index, with the first of its coefficients that belong to the
    /// seat.
    Connection {
        index: usize,
        first_term: usize,
        /// `L` with the compliance `L L'` of all coefficients of the connection.
        factor: Arc<DMatrix<f64>>,
    },
}

/// Converts a matrix of the structures.
pub(crate) fn dense(matrix: MatRef<'_, f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |row, column| matrix[(row, column)])
}

/// Finds the modelled bearings that run on an elastic raceway. `raceway_of` returns the
/// raceway in the bore of a gear with its plane-strain modulus (Pa) and the compliance of its
/// terms, if it has one.
pub(crate) fn find(
    scene: &Mechanism,
    modelled: &[usize],
    connections: &[ElasticConnection],
    raceway_of: impl Fn(usize) -> Option<(Raceway, f64, DMatrix<f64>)>,
) -> Vec<BearingOnRaceway> {
    let mut factors = BTreeMap::new();
    let mut of = |&index: &usize| {
        let bearing: &Bearing = scene.bearings.get(index)?;
        let (elements, body) = (bearing.rolling()?, bearing.outer_body()?);
        let in_gear = raceway_of(body).map(|(raceway, modulus, compliance)| {
            let cylinder = RacewayCylinder::bore(body, raceway.radius);
            (cylinder, (raceway, modulus), RacewayOwner::Gear(Arc::new(compliance)))
        });
        let (cylinder, (raceway, modulus), owner) =
            in_gear.or_else(|| in_seat(connections, body, &mut factors))?;
        // A bearing that is not coaxial is rejected at its position.
        let placed = InBore::at(&scene.bodies, bearing, &cylinder, 0.0).ok();
        let shares = half_space_shares(elements, (&raceway, modulus), placed);
        Some(BearingOnRaceway { bearing: index, cylinder, raceway, owner, shares })
    };
    modelled.iter().filter_map(&mut of).collect()
}

/// Returns the raceway of the seat of an elastic body and its plane-strain modulus (Pa) by the
/// index of its attachment among the bodies.
fn in_seat(
    connections: &[ElasticConnection],
    body: usize,
    factors: &mut BTreeMap<usize, Arc<DMatrix<f64>>>,
) -> Option<(RacewayCylinder, (Raceway, f64), RacewayOwner)> {
    let with_raceways = connections.iter().enumerate();
    let mut with_raceways = with_raceways.filter(|(_, connection)| connection.raceways.terms() > 0);
    with_raceways.find_map(|(index, connection)| {
        let Seat { raceway: seat, first_term, .. } =
            connection.seats().into_iter().find(|seat| seat.body == body)?;
        let factor = factors.entry(index).or_insert_with(|| {
            let RacewayMatrices { compliance, .. } = &connection.raceways;
            let terms = connection.raceways.terms();
            Arc::new(square_root(DMatrix::from_row_slice(terms, terms, compliance)))
        });
        let owner = RacewayOwner::Connection { index, first_term, factor: factor.clone() };
        Some((RacewayCylinder::seat(body, &seat), (seat.raceway, seat.modulus), owner))
    })
}

/// Returns a factor `L` of a positive semidefinite matrix `L L'`.
fn square_root(matrix: DMatrix<f64>) -> DMatrix<f64> {
    let SymmetricEigen { eigenvalues, eigenvectors } = SymmetricEigen::new(matrix);
    eigenvectors * DMatrix::from_diagonal(&eigenvalues.map(|value| value.max(0.0).sqrt()))
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
        let compliance = match &self.owner {
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
