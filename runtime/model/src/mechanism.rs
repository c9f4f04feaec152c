//! Simulated part of a scene, without observables: bodies, bearings,
//! elastic connections and surface pairs.

use crate::bearing::Bearing;
use crate::body::Body;
use crate::connection::ElasticConnection;
use crate::ids::{BearingId, BodyId, ConnectionId, PairId};
use crate::pairs::SurfacePair;
use crate::seats::{MisplacedBearing, misplaced};
use calyx_numerics::error::EngineError;

/// Bodies, bearings, elastic connections and surface pairs.
#[derive(Clone, Default)]
pub struct Mechanism {
    /// Bodies, indexed by [`BodyId`].
    pub bodies: Vec<Body>,
    /// Bearings, indexed by [`BearingId`].
    pub bearings: Vec<Bearing>,
    /// Elastic connections, indexed by [`ConnectionId`].
    pub connections: Vec<ElasticConnection>,
    /// Surface pairs, indexed by [`PairId`].
    pub pairs: Vec<SurfacePair>,
}

impl Mechanism {
    /// Adds a body.
    pub fn add_body(&mut self, body: Body) -> BodyId {
        self.bodies.push(body);
        BodyId(self.bodies.len() - 1)
    }

    /// Adds a bearing.
    ///
    /// # Errors
    /// Those of [`Bearing::check`]. E0993: the bearing is too far away from an attachment of an
    /// elastic body that it is mounted on.
    pub fn add_bearing(&mut self, bearing: Bearing) -> Result<BearingId, EngineError> {
        bearing.check(&self.bodies, &self.bearings)?;
        if let Some(found) = self.misplaced(&bearing)?.filter(|found| found.impossible) {
            return Err(found.error);
        }
        self.bearings.push(bearing);
        Ok(BearingId(self.bearings.len() - 1))
    }

    /// Returns the finding about a bearing that is not at the attachments that it is mounted on.
    ///
    /// # Errors
    /// Those of [`misplaced`].
    pub fn misplaced(&self, bearing: &Bearing) -> Result<Option<MisplacedBearing>, EngineError> {
        misplaced(&self.bodies, &self.connections, bearing)
    }

    /// Adds an elastic connection.
    ///
    /// # Errors
    /// E0671: the scene has a connection of the same name. Otherwise those of
    /// [`ElasticConnection::check`].
    pub fn add_connection(&mut self, connection: ElasticConnection) -> Result<ConnectionId, EngineError> {
        connection.check(&self.bodies)?;
        if self.connections.iter().any(|other| other.name == connection.name) {
            let message = format!("there are two elastic connections called \"{}\"", connection.name);
            let help = "results speak of connections by name; give each its own";
            return Err(EngineError::new("E0671", message, help).blame("name"));
        }
        self.connections.push(connection);
        Ok(ConnectionId(self.connections.len() - 1))
    }

    /// Returns the elastic connections of a body.
    pub fn connections_of(&self, body: BodyId) -> impl Iterator<Item = &ElasticConnection> {
        self.connections.iter().filter(move |connection| connection.bodies().any(|other| other == body))
    }

    /// Adds a pair of surfaces that may come into contact.
    pub fn add_pair(&mut self, pair: SurfacePair) -> PairId {
        self.pairs.push(pair);
        PairId(self.pairs.len() - 1)
    }
}
