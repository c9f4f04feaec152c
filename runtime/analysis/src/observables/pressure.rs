//! Observables of contact pressure.

use super::{Equilibrium, Observable, Quantity};
use calyx_contact::zone::Zone;
use calyx_model::ids::PairId;
use calyx_model::observed::Observed;

/// Largest pressure on the flanks of a pair, at least one Hertzian half-width away from edges, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxContactPressure(pub PairId);

impl Observable for MaxContactPressure {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_contact_pressure", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(at, self.0, Zone::Flank)
    }

    fn is_flank_pressure(&self) -> bool {
        true
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Largest pressure on the edges of a pair, and within one Hertzian half-width of them, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxEdgePressure(pub PairId);

impl Observable for MaxEdgePressure {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_edge_pressure", "Pa")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        largest(at, self.0, Zone::Edge)
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the largest pressure of all patches in a zone.
fn largest(at: &Equilibrium<'_>, pair: PairId, zone: Zone) -> Observed {
    let mut largest = Observed::number(0.0);
    for contact in at.contacts(pair) {
        let larger = |(pressure, _): &(f64, _)| *pressure > largest.value || pressure.is_nan();
        if let Some((value, place)) = contact.peak(0, zone).filter(larger) {
            largest = Observed { value, least: None, location: place };
        }
    }
    largest
}
