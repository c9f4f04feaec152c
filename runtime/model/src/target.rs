//! What outputs look at of a mechanism, from which follows what of it has to be modelled.

use crate::fidelity::Needs;
use crate::ids::{BearingId, BodyId, PairId};
use crate::mechanism::Mechanism;

/// Parts of a mechanism that an observable looks at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// Least that bodies have to be modelled with.
    pub needs: Needs,
    /// Body whose stresses are recovered for it.
    pub stresses_of: Option<BodyId>,
    /// Body whose frame it looks at, whether or not the body touches anything.
    pub frame_of: Option<BodyId>,
    /// Bearing that it looks at.
    pub bearing_of: Option<BearingId>,
    /// Pair of surfaces that it looks at.
    pub pair_of: Option<PairId>,
    /// Mode that it tells of, from 0.
    pub mode: Option<usize>,
    /// True if it reads beside the middle of the face, which a plane model does not see.
    pub off_middle: bool,
}

impl Target {
    /// Returns true if it names no part of the mechanism, and so looks at all of it.
    pub fn is_everything(&self) -> bool {
        let parts = [self.frame_of.is_some(), self.stresses_of.is_some()];
        let others = [self.bearing_of.is_some(), self.pair_of.is_some()];
        self.mode.is_some() || ![parts, others].concat().contains(&true)
    }
}

/// A mechanism and what is observed of it: what a plan is made for.
pub trait Examined {
    /// What is simulated.
    fn mechanism(&self) -> &Mechanism;

    /// One per observable, in the order of their indices.
    fn targets(&self) -> Vec<Target>;

    /// Returns true if a table of the modes at the first position is requested.
    fn examines_modes(&self) -> bool;
}

/// A mechanism of which nothing is observed.
impl Examined for Mechanism {
    fn mechanism(&self) -> &Mechanism {
        self
    }

    fn targets(&self) -> Vec<Target> {
        Vec::new()
    }

    fn examines_modes(&self) -> bool {
        false
    }
}
