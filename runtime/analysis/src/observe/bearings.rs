//! What bearings bear, and how far they give.

use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::bearing::Placed;
use calyx_model::ids::{BearingId, BodyId};
use calyx_model::observed::Observed;

/// A bearing in equilibrium.
pub struct Borne {
    /// How far the first race has moved against the second: m along, and rad about, the bearing's axes.
    pub deflection: [f64; 6],
    /// What holds the first race, and pushes the second one the other way: force (N) and moment about the bearing's origin (N m),
    /// along the bearing's axes.
    pub push: [f64; 6],
    placed: Placed,
}

/// Along which line a force, a moment or a motion of a bearing is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// An axis of the ground, 0 to 2.
    Ground(usize),
    /// The bearing's axis.
    Axial,
    /// All that is square to the bearing's axis, by its size.
    Radial,
}

impl Borne {
    /// What it does to one of the bodies it connects: force (N) and moment about the body's axle (N m), along ground axes.
    pub fn wrench_on(&self, body: BodyId) -> [f64; 6] {
        self.placed.wrench_on(body, self.push)
    }

    fn along(&self, [x, y, z]: [f64; 3], direction: Direction) -> f64 {
        match direction {
            Direction::Ground(axis) => self.placed.to_ground([x, y, z])[axis],
            Direction::Axial => z,
            Direction::Radial => x.hypot(y),
        }
    }
}

impl Equilibrium<'_> {
    /// What a bearing of the scene bears; `None` if the scene has no such bearing, or its races have parted.
    pub fn bearing(self, bearing: BearingId) -> Option<Borne> {
        let system = self.system;
        let own = system.scene.bearings.get(bearing.0)?;
        let placed = Placed::at(&system.scene.bodies, own, self.step.time).ok()?;
        let of = |motions: &[f64]| {
            let mut deflection = [0.0; 6];
            for (freedom, motion) in system.freedoms.iter().zip(motions) {
                for (sum, part) in deflection.iter_mut().zip(placed.deflection(freedom)) {
                    *sum += part * motion;
                }
            }
            deflection
        };
        let (deflection, rate) = (of(&self.step.motion), of(&self.step.velocity));
        let before = system.bearings.iter().take_while(|&&other| other != bearing.0);
        let skipped: usize = before.map(|&other| system.scene.bearings[other].walls()).sum();
        let width = system.width(own.body.0);
        let walls: Vec<f64> = self.step.stops.iter().skip(skipped).map(|force| width * force).collect();
        let walls = if system.bearings.contains(&bearing.0) { &walls[..] } else { &[] };
        let (sprung, damped) = (own.push(&deflection, walls), own.damping_at(&rate));
        let push = std::array::from_fn(|k| sprung[k] - damped[k]);
        Some(Borne { deflection, push, placed })
    }

    /// What all bearings of a body do to its frame, as [`Borne::wrench_on`].
    pub fn bearings_on(self, body: BodyId) -> [f64; 6] {
        let mut total = [0.0; 6];
        for (index, bearing) in self.system.scene.bearings.iter().enumerate() {
            let Some(borne) =
                bearing.bodies().find(|b| *b == body).and_then(|_| self.bearing(BearingId(index)))
            else {
                continue;
            };
            for (sum, part) in total.iter_mut().zip(borne.wrench_on(body)) {
                *sum += part;
            }
        }
        total
    }
}

/// Which three of six numbers along and about a bearing's axes.
fn half(numbers: [f64; 6], about: bool) -> [f64; 3] {
    let from = if about { 3 } else { 0 };
    std::array::from_fn(|k| numbers[from + k])
}

fn observed(at: &Equilibrium<'_>, bearing: BearingId, of: impl Fn(&Borne) -> f64) -> Observed {
    Observed::number(at.bearing(bearing).map_or(f64::NAN, |borne| of(&borne)))
}

/// The force with which a bearing holds the body of its first race. N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingForce(pub BearingId, pub Direction);

impl Observable for BearingForce {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_force", "N")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |borne| borne.along(half(borne.push, false), self.1))
    }
}

/// The moment with which a bearing holds the body of its first race, about the bearing's origin. N m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingMoment(pub BearingId, pub Direction);

impl Observable for BearingMoment {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_moment", "N*m")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |borne| borne.along(half(borne.push, true), self.1))
    }
}

/// How far the first race has moved against the second. m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingDeflection(pub BearingId, pub Direction);

impl Observable for BearingDeflection {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_deflection", "m")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |borne| borne.along(half(borne.deflection, false), self.1))
    }
}

/// How far the first race has turned against the second. rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingTilt(pub BearingId, pub Direction);

impl Observable for BearingTilt {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_tilt", "rad")
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |borne| borne.along(half(borne.deflection, true), self.1))
    }
}
