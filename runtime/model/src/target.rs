//! Dependence of observables on the parts of a mechanism, which determines the parts to be
//! modelled.

use crate::fidelity::Needs;
use crate::ids::{BearingId, BodyId, PairId};
use crate::mechanism::Mechanism;

/// Parts of a mechanism that an observable depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// Model requirements of the observable.
    pub needs: Needs,
    /// Body whose stresses are recovered for it.
    pub stresses_of: Option<BodyId>,
    /// Body whose frame it depends on, with or without contact.
    pub frame_of: Option<BodyId>,
    /// Bearing that it depends on.
    pub bearing_of: Option<BearingId>,
    /// Surface pair that it depends on.
    pub pair_of: Option<PairId>,
    /// Index of its mode, from 0.
    pub mode: Option<usize>,
    /// True if it is evaluated outside the middle of the face, which a plane model ignores.
    pub off_middle: bool,
}

impl Target {
    /// Returns whether it names no part of the mechanism and therefore depends on all of it.
    pub fn is_everything(&self) -> bool {
        let parts = [self.frame_of.is_some(), self.stresses_of.is_some()];
        let others = [self.bearing_of.is_some(), self.pair_of.is_some()];
        self.mode.is_some() || ![parts, others].concat().contains(&true)
    }
}

/// Mechanism with its observables, for which a plan is made.
pub trait Examined {
    /// Returns the mechanism.
    fn mechanism(&self) -> &Mechanism;

    /// Returns the parts that each observable depends on, in the order of their indices.
    fn targets(&self) -> Vec<Target>;

    /// Returns whether a table of the modes at the first position is requested.
    fn examines_modes(&self) -> bool;

    /// Returns the largest number of modes that such tables request; `None` if they have all modes.
    fn tabulated_modes(&self) -> Option<usize> {
        None
    }
}

/// A mechanism without observables.
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
