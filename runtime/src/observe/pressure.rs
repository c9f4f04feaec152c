//! How hard surfaces are pressed together.

use super::{Equilibrium, Observable, Quantity};
use crate::results::Observed;
use crate::scene::PairId;

/// The largest pressure on the flanks of a pair, edges left out. Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxContactPressure(pub PairId);

impl Observable for MaxContactPressure {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_contact_pressure", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(at, self.0, false)
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// The largest pressure on the edges of a pair. Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxEdgePressure(pub PairId);

impl Observable for MaxEdgePressure {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_edge_pressure", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(at, self.0, true)
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Of the patches that an edge cuts off, or of the others.
fn largest(at: &Equilibrium<'_>, pair: PairId, at_edge: bool) -> Observed {
    let mut largest = Observed::number(0.0);
    for contact in at.contacts(pair).filter(|contact| contact.at_edge() == at_edge) {
        let larger = |(pressure, _): &(f64, _)| *pressure > largest.value || pressure.is_nan();
        if let Some((value, place)) = contact.peak(0).filter(larger) {
            largest = Observed { value, least: None, place };
        }
    }
    largest
}
