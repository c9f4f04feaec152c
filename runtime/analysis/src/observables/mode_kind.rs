//! Types of the modes of a planetary gear set, and the table of all modes of a scene.
//!
//! If planets are equal and equally spaced, every mode of rigid bodies has one of three types (J.
//! Lin and R. G. Parker, J. Vib. Acoust. 121(3), 1999). Rotational: central members rotate, and all
//! planets move alike. Translational: central members translate, and planets move with the sine and
//! cosine of their positions. Planet modes: central members are at rest, and the motions of the
//! planets add up to zero. A motion is projected on these patterns; the fractions of kinetic energy
//! in them add up to one. Mesh phases and elastic bodies mix the types slightly.
//!
//! See `docs/theory/modes.md`.

use super::{Equilibrium, Observable, Quantity};
use calyx_model::ids::BodyId;
use calyx_model::observed::Observed;
use calyx_solve::vibrations::Vibrations;
use std::f64::consts::TAU;

/// Type of a mode of a planetary gear set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// None of the others: planets differ or are not symmetrically placed.
    Mixed = 0,
    /// Central members rotate and do not translate.
    Rotational = 1,
    /// Central members translate and do not rotate.
    Translational = 2,
    /// Central members are at rest.
    Planet = 3,
    /// Bodies vibrate relative to their frames.
    Elastic = 4,
}

impl ModeKind {
    /// Returns the name.
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

/// Planets, and the body around whose axis they are placed. All other bodies are central members.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanetSet {
    /// Central body.
    pub around: BodyId,
    /// Three or more equal planets.
    pub planets: Vec<BodyId>,
}

/// Fraction of kinetic energy in elastic motion from which a mode is elastic.
const ELASTIC: f64 = 0.5;
/// Fraction of the energy of frames from which a mode has a type.
const OF_A_KIND: f64 = 0.9;
/// Squared norm of the new part of a pattern, per planet, below which the pattern depends on those
/// before it, as for two planets.
const OF_ITS_OWN: f64 = 1e-6;

/// Fractions of a mode's kinetic energy by pattern; they add up to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ModeEnergyShares {
    /// Central members rotate, planets move alike.
    pub rotational: f64,
    /// Central members translate, planets move with the sine and cosine of their positions.
    pub translational: f64,
    /// Other motion of the planets.
    pub planet: f64,
    /// Motion of bodies relative to their frames.
    pub elastic: f64,
}

impl ModeEnergyShares {
    /// Returns the type with a sufficient fraction.
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
    /// Computes the fractions of a mode in the patterns of a planetary gear set.
    pub fn kind_shares(self, all: &Vibrations, mode: usize, set: &PlanetSet) -> ModeEnergyShares {
        let dofs = &self.system.dofs;
        let energies = all.energies(mode);
        let mut shares =
            ModeEnergyShares { elastic: energies[dofs.len()..].iter().sum(), ..ModeEnergyShares::default() };
        for (dof, energy) in dofs.iter().zip(&energies) {
            if !set.planets.contains(&BodyId(dof.body)) {
                match dof.component {
                    0..3 => shares.translational += energy,
                    _ => shares.rotational += energy,
                }
            }
        }
        // Motions of the planets in radial and circumferential direction and about their axes,
        // scaled by the roots of their inertia.
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
                for (k, dof) in dofs.iter().enumerate().filter(|(_, dof)| dof.body == planet.0) {
                    own[dof.component] = all.shapes[(k, mode)] * all.mass[(k, k)].sqrt();
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

/// Returns the patterns over the planets: constant, cosine and sine of their positions;
/// orthonormalized, or zero.
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

/// Type of a mode of a planetary gear set: the number of its [`ModeKind`].
#[derive(Clone, Debug, PartialEq)]
pub struct ModeClassification {
    /// Index of the mode, from the lowest frequency, from 0.
    pub mode: usize,
    /// Planetary gear set.
    pub set: PlanetSet,
}

impl Observable for ModeClassification {
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

/// Request for a table of the modes.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesRequest {
    /// Number of modes, from the lowest; `None` for all.
    pub count: Option<usize>,
    /// Planetary gear set for the classification.
    pub set: Option<PlanetSet>,
}

/// Modes of a scene at a position.
#[derive(Clone, Debug, PartialEq)]
pub struct ModesTable {
    /// Time of the position, s.
    pub time: f64,
    /// Names of the bodies of the table, then those of elastic bodies with component modes.
    pub bodies: Vec<String>,
    /// Modes from the lowest frequency.
    pub modes: Vec<ModeRow>,
}

/// Mode of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeRow {
    /// Frequency, Hz.
    pub frequency: f64,
    /// Type, for a planetary gear set.
    pub kind: Option<ModeKind>,
    /// Fraction of kinetic energy in the translation of frames.
    pub translation: f64,
    /// Fraction of kinetic energy in the rotation of frames.
    pub rotation: f64,
    /// Fraction of kinetic energy in vibrations of bodies relative to their frames.
    pub elastic: f64,
    /// Fraction of kinetic energy of each body, in the order of [`ModesTable::bodies`]: for elastic
    /// bodies that of the motion relative to their attachments.
    pub bodies: Vec<f64>,
}

impl Equilibrium<'_> {
    /// Computes the requested table; `None` if nothing vibrates.
    pub fn modes_table(self, request: &ModesRequest) -> Option<ModesTable> {
        let all = self.vibrations()?;
        let (dofs, modes) = (&self.system.dofs, &self.system.modes);
        let (scene, elastic_bodies) = (self.system.scene, self.system.connection_modes());
        let moves = |body: &usize| dofs.iter().any(|dof| dof.body == *body) || modes.of_body(*body).is_some();
        let bodies: Vec<usize> = (0..scene.bodies.len()).filter(moves).collect();
        let row = |mode: usize| {
            let energies = all.energies(mode);
            let (frames, modal) = energies.split_at(dofs.len());
            let of_frames = |counts: &dyn Fn(usize, usize) -> bool| -> f64 {
                let counted = dofs.iter().zip(frames);
                counted.filter(|(dof, _)| counts(dof.body, dof.component)).map(|(_, part)| part).sum()
            };
            let of_body = |body: usize| {
                let own =
                    modes.of_body(body).map_or(&[][..], |(own, first)| &modal[first..first + own.count()]);
                of_frames(&|of, _| of == body) + own.iter().sum::<f64>()
            };
            let of_connections = elastic_bodies.iter().map(|(connection, first)| {
                modal[modes.count() + first..].iter().take(connection.modes.count()).sum::<f64>()
            });
            ModeRow {
                frequency: all.frequencies[mode] / TAU,
                kind: request.set.as_ref().map(|set| self.kind_shares(&all, mode, set).kind()),
                translation: of_frames(&|_, component| component < 3),
                rotation: of_frames(&|_, component| component >= 3),
                elastic: modal.iter().sum(),
                bodies: bodies.iter().map(|&body| of_body(body)).chain(of_connections).collect(),
            }
        };
        let count = all.frequencies.len().min(request.count.unwrap_or(usize::MAX));
        let mut names: Vec<String> = bodies.iter().map(|&body| scene.bodies[body].name.clone()).collect();
        for (connection, _) in &elastic_bodies {
            // A shaft has the name of its first section.
            let is_known = names.contains(&connection.name);
            names.push(if is_known {
                format!("{} (elastic)", connection.name)
            } else {
                connection.name.clone()
            });
        }
        Some(ModesTable { time: self.time(), bodies: names, modes: (0..count).map(row).collect() })
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
