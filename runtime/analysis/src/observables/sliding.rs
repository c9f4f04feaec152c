//! Observables of sliding: velocities and frictional losses.

use super::loads::pairs_teeth;
use super::{Contact, Equilibrium, Needs, Observable, Quantity};
use calyx_model::ids::PairId;
use calyx_model::observed::{Location, Observed};
use std::ops::Add;

/// Sliding velocity of a tooth pair, numbered as by [`super::PairLoad`], m/s: the velocity of the
/// contact along the first gear's flank, outwards, minus that along the second's; 0 without load.
/// It is positive on the addendum of a driving gear and negative on its dedendum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingVelocity(pub PairId, pub i32);

impl Observable for SlidingVelocity {
    fn quantity(&self) -> Quantity {
        Quantity::passing("sliding_velocity", "m/s")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let fastest = pairs_teeth(at, self.0, self.1).filter_map(|contact| fastest(&contact));
        let fastest = fastest.max_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()));
        fastest.map_or(Observed::number(0.0), |(value, place)| Observed {
            value,
            least: None,
            location: place,
        })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Largest magnitude of the sliding velocity of loaded flanks, m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxSlidingVelocity(pub PairId);

impl Observable for MaxSlidingVelocity {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_sliding_velocity", "m/s")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let fastest = at.contacts(self.0).filter_map(|contact| fastest(&contact));
        let fastest = fastest.max_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()));
        fastest.map_or(Observed::number(0.0), |(value, place)| Observed {
            value: value.abs(),
            least: None,
            location: place,
        })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the signed sliding velocity of the fastest loaded slice, and its location on the first
/// body.
fn fastest(contact: &Contact<'_>) -> Option<(f64, Option<Location>)> {
    let sliding = contact.sliding_points(0).into_iter().map(|(point, place)| {
        let velocity = contact.sliding(point);
        let outward = contact.away_from_axis(0, point);
        // The contact moves outwards at the velocity at which the material of the flank moves
        // inwards through it.
        let along: f64 = velocity.iter().zip(outward).map(|(velocity, outward)| -velocity * outward).sum();
        (size(velocity).copysign(along), place)
    });
    sliding.max_by(|(a, _), (b, _)| a.abs().total_cmp(&b.abs()))
}

/// Frictional power loss at a given coefficient of friction: coefficient times force times sliding
/// velocity, over all contact lines, W. Its mean over a mesh cycle is the loss. The forces are
/// those without friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLoss(pub PairId, pub f64);

impl Observable for FrictionLoss {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("friction_loss", "W")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let of = |contact: Contact<'_>| -> f64 {
            contact.slices().iter().map(|slice| slice.force * size(contact.sliding(slice.point))).sum()
        };
        Observed::number(self.1 * at.mesh_contacts(self.0).map(of).fold(0.0, Add::add))
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Efficiency of the mesh at a given coefficient of friction; 1 without motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Efficiency(pub PairId, pub f64);

impl Observable for Efficiency {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("efficiency", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let power = transmitted_power(at, self.0);
        let loss = FrictionLoss(self.0, self.1).value(at).value;
        Observed::number(if power > 0.0 { 1.0 - loss / power } else { 1.0 })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Returns the power that a mesh transmits, W: that of the contact forces on the first body.
pub(super) fn transmitted_power(at: &Equilibrium<'_>, pair: PairId) -> f64 {
    at.mesh_contacts(pair).map(|contact| contact.power(0)).sum::<f64>().abs()
}

impl Contact<'_> {
    /// Returns the power of the patch's normal forces on the body of a side relative to the line of
    /// centres, W: the power that the mesh transmits.
    fn power(&self, side: usize) -> f64 {
        if self.at.mesh(self.pair()).is_some_and(|(mesh, _)| mesh.first_contact.is_some()) {
            // Cells act in different directions.
            return self.torque(side)
                * self.at.system.speed_on_carrier(self.patch.pair, side, self.at.time());
        }
        let normal = self.normal();
        let sense = if side == 0 { -1.0 } else { 1.0 };
        let of = |point: [f64; 3]| -> f64 {
            let own = self.at.velocity(self.bodies()[side], point);
            let along = self.at.system.carrier_velocity(self.pair().0, self.at.time(), point);
            (0..3).map(|k| (own[k] - along[k]) * normal[k]).sum()
        };
        self.slices().iter().map(|slice| sense * slice.force * of(slice.point)).sum()
    }

    /// Returns the direction from the axis of a body to a point, in the transverse plane.
    fn away_from_axis(&self, side: usize, point: [f64; 3]) -> [f64; 3] {
        let body = self.bodies()[side].0;
        let (origin, axis) =
            (self.at.system.origin(body, self.at.time()), self.at.system.axes(body, self.at.time())[2]);
        let from = [0, 1, 2].map(|k: usize| point[k] - origin[k]);
        let along: f64 = (0..3).map(|k| from[k] * axis[k]).sum();
        [0, 1, 2].map(|k: usize| from[k] - along * axis[k])
    }
}

pub(super) fn size([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}
