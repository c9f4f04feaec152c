//! What a mode of a planetary set is, and the table of all modes of a scene.
//!
//! Where planets are equal and equally spaced, every mode of rigid bodies is one of three kinds (J. Lin and R. G. Parker, J. Vib. Acoust. 121(3),
//! 1999): central members turn and all planets do the same; or they move sideways, and planets do as the sine and the cosine of their places
//! say; or they rest, and what planets do adds up to nothing. So a motion is split by these patterns: each has a part of its kinetic energy, and
//! together they have all of it. Teeth that are not in phase, and bodies that deform, mix the kinds a little.

use super::{Equilibrium, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::observed::Observed;
use calyx_solve::vibrations::Vibrations;
use std::f64::consts::TAU;

/// What a mode of a planetary set is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// None of the others: planets differ, or do not stand symmetrically.
    Mixed = 0,
    /// Central members turn, and do not move sideways.
    Rotational = 1,
    /// Central members move sideways, and do not turn.
    Translational = 2,
    /// Central members rest.
    Planet = 3,
    /// Bodies vibrate against their frames.
    Elastic = 4,
}

impl ModeKind {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            ModeKind::Mixed => "mixed",
            ModeKind::Rotational => "rotational",
            ModeKind::Translational => "translational",
            ModeKind::Planet => "planet",
            ModeKind::Elastic => "elastic",
        }
    }
}

/// Planets, and the body around whose axle they stand. All other bodies are central members.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanetSet {
    /// In the middle.
    pub around: BodyId,
    /// Three or more of one kind.
    pub planets: Vec<BodyId>,
}

/// Energy in elastic motion from which on a mode is one of bodies that deform.
const ELASTIC: f64 = 0.5;
/// Part of the energy of frames that makes a mode one of a kind.
const OF_A_KIND: f64 = 0.9;
/// What a pattern has beside those before it, squared, by planets: less is nothing of its own, as of two planets.
const OF_ITS_OWN: f64 = 1e-6;

/// Parts of a mode's kinetic energy by its patterns; they add up to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct KindShares {
    /// Central members turn, planets do alike.
    pub rotational: f64,
    /// Central members move sideways, planets with the sine and the cosine of their places.
    pub translational: f64,
    /// What else planets do.
    pub planet: f64,
    /// Bodies against their frames.
    pub elastic: f64,
}

impl KindShares {
    /// The kind that has enough of it.
    pub fn kind(&self) -> ModeKind {
        let frames = self.rotational + self.translational + self.planet;
        let of = |part: f64| part >= OF_A_KIND * frames;
        match () {
            () if self.elastic >= ELASTIC => ModeKind::Elastic,
            () if of(self.rotational) => ModeKind::Rotational,
            () if of(self.translational) => ModeKind::Translational,
            () if of(self.planet) => ModeKind::Planet,
            () => ModeKind::Mixed,
        }
    }
}

impl Equilibrium<'_> {
    /// How a mode, one of those that there are, is made up of the patterns of a planetary set.
    pub fn kind_shares(self, all: &Vibrations, mode: usize, set: &PlanetSet) -> KindShares {
        let freedoms = &self.system.freedoms;
        let energies = all.energies(mode);
        let mut shares =
            KindShares { elastic: energies[freedoms.len()..].iter().sum(), ..KindShares::default() };
        for (freedom, energy) in freedoms.iter().zip(&energies) {
            if !set.planets.contains(&BodyId(freedom.body)) {
                match freedom.component {
                    0..3 => shares.translational += energy,
                    _ => shares.rotational += energy,
                }
            }
        }
        // Motions of the planets outwards, around and about their axles, by the roots of their inertia.
        let centre = self.origin(set.around);
        let places = set.planets.iter().map(|&planet| {
            let place = self.origin(planet);
            (place[1] - centre[1]).atan2(place[0] - centre[0])
        });
        let places: Vec<f64> = places.collect();
        let moved: Vec<[f64; 3]> = set
            .planets
            .iter()
            .zip(&places)
            .map(|(planet, place)| {
                let mut own = [0.0; 6];
                for (k, freedom) in
                    freedoms.iter().enumerate().filter(|(_, freedom)| freedom.body == planet.0)
                {
                    own[freedom.component] = all.shapes[(k, mode)] * all.mass[(k, k)].sqrt();
                }
                let ([x, y, .., turn], (sine, cosine)) = (own, place.sin_cos());
                [cosine * x + sine * y, cosine * y - sine * x, turn]
            })
            .collect();
        let whole: f64 = moved.iter().flatten().map(|part| part * part).sum();
        let [all_alike, cosine, sine] = patterns(&places);
        let part = |pattern: &[f64]| -> f64 {
            (0..3)
                .map(|k| pattern.iter().zip(&moved).map(|(by, moved)| by * moved[k]).sum::<f64>().powi(2))
                .sum()
        };
        let (alike, sideways) = (part(&all_alike), part(&cosine) + part(&sine));
        shares.rotational += alike;
        shares.translational += sideways;
        shares.planet += (whole - alike - sideways).max(0.0);
        shares
    }
}

/// By planets: all alike, by the cosine and by the sine of their places; of unit length and at right angles to those before, or nothing.
fn patterns(places: &[f64]) -> [Vec<f64>; 3] {
    let mut found = [vec![1.0; places.len()], Vec::new(), Vec::new()];
    found[1] = places.iter().map(|place| place.cos()).collect();
    found[2] = places.iter().map(|place| place.sin()).collect();
    for k in 0..3 {
        let (before, own) = found.split_at_mut(k);
        let own = &mut own[0];
        for other in before {
            let along: f64 = own.iter().zip(&*other).map(|(a, b)| a * b).sum();
            own.iter_mut().zip(&*other).for_each(|(a, b)| *a -= along * b);
        }
        let square: f64 = own.iter().map(|a| a * a).sum();
        let scale = if square > OF_ITS_OWN * places.len() as f64 { square.sqrt().recip() } else { 0.0 };
        own.iter_mut().for_each(|a| *a *= scale);
    }
    found
}

/// What a mode of a planetary set is: the number of its [`ModeKind`].
#[derive(Clone, Debug, PartialEq)]
pub struct KindOfMode {
    /// From the lowest frequency up, from 0.
    pub mode: usize,
    /// Whose.
    pub set: PlanetSet,
}

impl Observable for KindOfMode {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("mode_kind", "1")
    }

    fn mode(&self) -> Option<usize> {
        Some(self.mode)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let all = at.vibrations().filter(|all| self.mode < all.frequencies.len());
        let kind = all.map(|all| at.kind_shares(&all, self.mode, &self.set).kind());
        Observed::number(kind.map_or(f64::NAN, |kind| f64::from(kind as u8)))
    }
}

/// That a table of the modes is wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesRequest {
    /// How many, from the lowest up; `None` for all.
    pub count: Option<usize>,
    /// Whose kinds they are told apart by.
    pub set: Option<PlanetSet>,
}

/// The modes of a scene at a position.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesTable {
    /// Of the position, s.
    pub time: f64,
    /// Names of those that take part.
    pub bodies: Vec<String>,
    /// From the lowest frequency up.
    pub modes: Vec<ModeRow>,
}

/// A mode of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeRow {
    /// Hz.
    pub frequency: f64,
    /// Of a planetary set.
    pub kind: Option<ModeKind>,
    /// What frames move sideways has this part of the kinetic energy.
    pub translation: f64,
    /// What they turn has this one.
    pub rotation: f64,
    /// What bodies vibrate against their frames has this one.
    pub elastic: f64,
    /// What each body has of it, in the order of [`ModesTable::bodies`].
    pub bodies: Vec<f64>,
}

impl Equilibrium<'_> {
    /// The table that is wanted; `None` if nothing vibrates.
    pub fn modes_table(self, request: &ModesRequest) -> Option<ModesTable> {
        let all = self.vibrations()?;
        let (freedoms, modes) = (&self.system.freedoms, &self.system.modes);
        let scene = self.system.scene;
        let moves = |body: &usize| {
            freedoms.iter().any(|freedom| freedom.body == *body) || modes.of_body(*body).is_some()
        };
        let bodies: Vec<usize> = (0..scene.bodies.len()).filter(moves).collect();
        let row = |mode: usize| {
            let energies = all.energies(mode);
            let (frames, modal) = energies.split_at(freedoms.len());
            let of_frames = |counts: &dyn Fn(usize, usize) -> bool| -> f64 {
                let counted = freedoms.iter().zip(frames);
                counted
                    .filter(|(freedom, _)| counts(freedom.body, freedom.component))
                    .map(|(_, part)| part)
                    .sum()
            };
            let of_body = |body: usize| {
                let own =
                    modes.of_body(body).map_or(&[][..], |(own, first)| &modal[first..first + own.count()]);
                of_frames(&|of, _| of == body) + own.iter().sum::<f64>()
            };
            ModeRow {
                frequency: all.frequencies[mode] / TAU,
                kind: request.set.as_ref().map(|set| self.kind_shares(&all, mode, set).kind()),
                translation: of_frames(&|_, component| component < 3),
                rotation: of_frames(&|_, component| component >= 3),
                elastic: modal.iter().sum(),
                bodies: bodies.iter().map(|&body| of_body(body)).collect(),
            }
        };
        let count = all.frequencies.len().min(request.count.unwrap_or(usize::MAX));
        let names = bodies.iter().map(|&body| scene.bodies[body].name.clone());
        Some(ModesTable { time: self.time(), bodies: names.collect(), modes: (0..count).map(row).collect() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn patterns_of_planets_are_at_right_angles() {
        for places in [vec![0.0, 1.5459, PI, 4.6874], vec![0.3, 2.4, 4.5], vec![0.0, PI], vec![1.0]] {
            let found = patterns(&places);
            for (a, one) in found.iter().enumerate() {
                for (b, other) in found.iter().enumerate() {
                    let product: f64 = one.iter().zip(other).map(|(x, y)| x * y).sum();
                    let lengths = [0.0, 1.0].iter().any(|length| (product - length).abs() < 1e-12);
                    assert!(if a == b { lengths } else { product.abs() < 1e-12 }, "{places:?}: {product}");
                }
            }
            let rank = found.iter().filter(|pattern| pattern.iter().any(|part| *part != 0.0)).count();
            assert_eq!(rank, places.len().min(3), "{places:?}");
        }
    }
}
