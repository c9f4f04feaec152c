//! Simulated part of a scene, without observables: bodies, bearings and surface pairs.

use crate::bearing::Bearing;
use crate::body::Body;
use crate::ids::{BearingId, BodyId, PairId};
use crate::pairs::SurfacePair;
use calyx_numerics::error::EngineError;

/// Bodies, bearings and surface pairs.
#[derive(Clone, Default)]
pub struct Mechanism {
    /// Bodies, indexed by [`BodyId`].
    pub bodies: Vec<Body>,
    /// Bearings, indexed by [`BearingId`].
    pub bearings: Vec<Bearing>,
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
    /// Those of [`Bearing::check`].
    pub fn add_bearing(&mut self, bearing: Bearing) -> Result<BearingId, EngineError> {
        bearing.check(&self.bodies, &self.bearings)?;
        self.bearings.push(bearing);
        Ok(BearingId(self.bearings.len() - 1))
    }

    /// Adds a pair of surfaces that may come into contact.
    pub fn add_pair(&mut self, pair: SurfacePair) -> PairId {
        self.pairs.push(pair);
        PairId(self.pairs.len() - 1)
    }
}
