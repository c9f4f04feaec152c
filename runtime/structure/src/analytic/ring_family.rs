//! Rings below teeth whose section varies along the face: the flexibility between the root of a
//! tooth in one section and the root of a tooth in another section.
//!
//! Developed sections of conical gears are sectors of rings. A sector of the part `c` of the full
//! circle is the whole circumference of the gear, so that the harmonics are those of the wave
//! numbers `n / c`, and everything else is as in [`super::FoundationRing`]: also for teeth that are
//! inclined by the spiral angle, which may vary along the face.
//!
//! In one section a harmonic has the compliance `t A t'` with the traction coefficients `t` of a
//! load and the symmetric positive definite matrix `A`. Between two sections `t S S' t'` with the
//! square roots `S S = A` replaces it. This is a Gram matrix whatever the sections are, and equals
//! the former if they are similar. All quantities are those of rings of unit radius, which do not
//! depend on the size of a section.

use super::cantilever::RootLoad;
use super::foundation_ring::{PHASE, RingHarmonics, tractions};
use super::{RingShape, sections::At};
use calyx_fe::material::{Material, Plane};
use std::f64::consts::{PI, TAU};

/// Displacements (axial, transverse, rotation) of a root by loads on another root.
type Entry = [[f64; 3]; 3];

/// Flexibility of the rings of several sections.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RingFamily {
    /// By the distance of two teeth: entries by section of the tooth ahead and of the one behind.
    entries: Vec<Vec<Entry>>,
    sections: usize,
    sectors: u32,
}

/// Relation of two teeth of a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Relation {
    apart: usize,
    /// Whether the second one is ahead; false for the same tooth.
    pub is_ahead: bool,
    /// Whether both are the same tooth.
    pub is_same: bool,
}

/// Displacements of the roots of another tooth by one load, by section: axial, transverse, and
/// rotation.
pub(super) type Moved = Vec<[f64; 3]>;

/// Harmonic of one section: square root of its compliance times the tractions of the three loads.
type Answer = [[f64; 3]; 2];

impl RingFamily {
    /// Builds the rings of sections at equal distances. `part` is the part of the full circle that
    /// the teeth take in the developed sections.
    pub fn new(shapes: &[RingShape], part: f64, material: Material) -> RingFamily {
        let sections = shapes.len();
        let sectors = shapes.first().map_or(1, |shape| shape.sectors.max(1));
        let ratio = |shape: &RingShape| shape.fixed_radius / shape.radius;
        let harmonics: Vec<RingHarmonics> =
            shapes.iter().map(|shape| RingHarmonics::new(ratio(shape), material, Plane::Strain)).collect();
        let shortest = shapes.iter().map(|shape| shape.half_arc).fold(f64::INFINITY, f64::min);
        let last = (PHASE / shortest * part).ceil() as u32;
        let mut entries = vec![vec![Entry::default(); sections * sections]; sectors as usize / 2 + 1];
        for n in 0..=last {
            let around = f64::from(n) / part;
            let answers: Vec<Answer> = harmonics
                .iter()
                .zip(shapes)
                .map(|(harmonics, shape)| {
                    answer(harmonics.answer(around / shape.lean), &tractions(around, shape.half_arc, part))
                })
                .collect();
            let norm = part * if n == 0 { TAU } else { PI };
            for (apart, entries) in entries.iter_mut().enumerate() {
                let (sine, cosine) = (TAU * f64::from(n) * apart as f64 / f64::from(sectors)).sin_cos();
                for (ahead, second) in answers.iter().enumerate() {
                    // Sections of one tooth are in the relation of transposed matrices.
                    let count = if apart == 0 { ahead + 1 } else { sections };
                    for (behind, first) in answers[..count].iter().enumerate() {
                        add(&mut entries[ahead * sections + behind], second, first, norm, [sine, cosine]);
                    }
                }
            }
        }
        for ahead in 0..sections {
            for behind in ahead + 1..sections {
                let of = entries[0][behind * sections + ahead];
                let transposed = [0, 1, 2].map(|i: usize| [0, 1, 2].map(|j: usize| of[j][i]));
                entries[0][ahead * sections + behind] = transposed;
            }
        }
        RingFamily { entries, sections, sectors }
    }

    /// Returns the relation of two teeth.
    pub fn relation(&self, one: u32, other: u32) -> Relation {
        let ahead = (other + self.sectors - one % self.sectors) % self.sectors;
        let behind = self.sectors - ahead;
        let apart = ahead.min(behind) as usize;
        // If two teeth are opposite, the one with the larger number counts as ahead.
        let is_behind = behind < ahead || (behind == ahead && other < one);
        let (is_same, is_ahead) = (ahead == 0, ahead > 0 && !is_behind);
        Relation { apart, is_ahead, is_same }
    }

    /// Returns the displacements of the roots of a tooth by a load on a tooth behind it, or on
    /// itself, at a position along the face. Loads are those of a ring of unit radius.
    pub fn moved(&self, relation: Relation, load: &RootLoad, at: At) -> Moved {
        let first = [load.axial, load.shear, load.moment];
        let entries = &self.entries[relation.apart];
        let of = |ahead: usize| {
            let mut sum = [0.0; 3];
            for (behind, weight) in at.weights() {
                for (sum, row) in sum.iter_mut().zip(&entries[ahead * self.sections + behind]) {
                    *sum += weight * (row[0] * first[0] + row[1] * first[1] + row[2] * first[2]);
                }
            }
            sum
        };
        (0..self.sections).map(of).collect()
    }

    /// Returns the displacement along a load at a position along the face by the one that has moved
    /// the roots.
    pub fn compliance(moved: &Moved, load: &RootLoad, at: At) -> f64 {
        let parts = [load.axial, load.shear, load.moment];
        let of = |(section, weight): (usize, f64)| {
            let moved = moved.get(section).copied().unwrap_or_default();
            weight * (0..3).map(|k| parts[k] * moved[k]).sum::<f64>()
        };
        at.weights().into_iter().map(of).sum()
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        self.entries.iter().map(|entries| size_of_val(entries.as_slice())).sum()
    }
}

/// Adds a harmonic to the displacements of a tooth `second` by a tooth `first` behind it.
fn add(sum: &mut Entry, second: &Answer, first: &Answer, norm: f64, [sine, cosine]: [f64; 2]) {
    for (i, row) in sum.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            // An axial force is even about its tooth, the others are odd.
            let phase = match (i == 0, j == 0) {
                (true, false) => sine,
                (false, true) => -sine,
                _ => cosine,
            };
            let work = second[0][i] * first[0][j] + second[1][i] * first[1][j];
            *entry += phase * norm * work;
        }
    }
}

/// Returns the harmonic of a section from its compliance, symmetric, and its tractions.
fn answer([[a, b], [_, d]]: [[f64; 2]; 2], loads: &[[f64; 2]; 3]) -> Answer {
    // The square root of a positive definite matrix of two rows (Cayley and Hamilton).
    let root = (a * d - b * b).max(0.0).sqrt();
    let scale = (a + d + 2.0 * root).max(f64::MIN_POSITIVE).sqrt();
    let rows = [[a + root, b], [b, d + root]];
    rows.map(|row| [0, 1, 2].map(|load: usize| (row[0] * loads[load][0] + row[1] * loads[load][1]) / scale))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::FoundationRing;

    const LOADS: [RootLoad; 3] = [
        RootLoad { axial: 1.0, shear: 0.0, moment: 0.0 },
        RootLoad { axial: 0.0, shear: 1.0, moment: 0.0 },
        RootLoad { axial: 0.0, shear: 0.0, moment: 1.0 },
    ];
    const UNIT: Material = Material { youngs_modulus: 1.0, poissons_ratio: 0.3, density: 0.0 };

    fn compliance(
        family: &RingFamily,
        (one, first, at): (u32, &RootLoad, At),
        (other, second, to): (u32, &RootLoad, At),
    ) -> f64 {
        let relation = family.relation(one, other);
        if relation.is_same || relation.is_ahead {
            RingFamily::compliance(&family.moved(relation, first, at), second, to)
        } else {
            RingFamily::compliance(&family.moved(relation, second, to), first, at)
        }
    }

    fn shapes(sectors: u32) -> Vec<RingShape> {
        let shape = |k: f64| RingShape {
            radius: 1.0,
            fixed_radius: 0.6 + 0.1 * k,
            half_arc: 0.08 + 0.01 * k,
            lean: 1.0 - 0.1 * k,
            sectors,
        };
        [0.0, 1.0, 2.0].map(shape).to_vec()
    }

    /// One section of a whole circle is the foundation ring.
    #[test]
    fn in_one_section_it_is_the_foundation_ring() {
        for (number, shape) in shapes(24).into_iter().enumerate() {
            let family = RingFamily::new(&[shape], 1.0, UNIT);
            let ring = FoundationRing::new(&shape, UNIT, Plane::Strain);
            let at = At { section: 0, weight: 0.0 };
            for first in &LOADS {
                for second in &LOADS {
                    for other in 0..24 {
                        let found = compliance(&family, (3, first, at), (other, second, at));
                        let exact = ring.link(3, other).compliance(first, second);
                        let bound = 1e-9 * (exact.abs() + 1.0);
                        assert!((found - exact).abs() < bound, "{number} {other}: {found} {exact}");
                    }
                }
            }
        }
    }

    /// No loads in any sections of any teeth have negative strain energy, also if sections differ
    /// and loads are between them.
    #[test]
    fn it_is_positive_definite_between_sections() {
        for part in [1.0, 0.4, 1e-3] {
            // The developed arcs are as long as the teeth are wide.
            let shapes = shapes(24).into_iter().map(|shape| RingShape {
                fixed_radius: 1.0 - part * (1.0 - shape.fixed_radius),
                half_arc: part * shape.half_arc,
                ..shape
            });
            let family = RingFamily::new(&shapes.collect::<Vec<_>>(), part, UNIT);
            let mut loads = Vec::new();
            for tooth in 0..24 {
                for (section, weight) in [(0, 0.0), (0, 0.3), (1, 1.0)] {
                    // The dimension of a moment is that of a force on the width of the tooth.
                    loads.extend(LOADS.map(|load| {
                        let load = RootLoad { moment: part * load.moment, ..load };
                        (tooth, load, At { section, weight })
                    }));
                }
            }
            let matrix = nalgebra::DMatrix::from_fn(loads.len(), loads.len(), |i, j| {
                let [(one, first, at), (other, second, to)] = [&loads[i], &loads[j]];
                compliance(&family, (*one, first, *at), (*other, second, *to))
            });
            assert!((&matrix - matrix.transpose()).amax() < 1e-12 * matrix.amax());
            let least = matrix.clone().symmetric_eigenvalues().min();
            assert!(least > -1e-9 * matrix.amax(), "{part}: {least}");
        }
    }

    /// A rack of teeth is the limit of vanishing parts.
    #[test]
    fn narrow_parts_are_a_rack() {
        let at = At { section: 0, weight: 0.0 };
        let of = |part: f64| {
            let shape = RingShape {
                radius: 1.0,
                fixed_radius: 1.0 - 0.3 * part,
                half_arc: 0.08 * part,
                lean: 1.0,
                sectors: 24,
            };
            let family = RingFamily::new(&[shape], part, UNIT);
            let moment = RootLoad { moment: part, ..RootLoad::default() };
            [&LOADS[0], &LOADS[1], &moment].map(|load| compliance(&family, (0, load, at), (0, load, at)))
        };
        let [coarse, fine, finest] = [0.04, 0.004, 0.0004].map(of);
        for k in 0..3 {
            let [first, second] = [coarse[k] - finest[k], fine[k] - finest[k]].map(f64::abs);
            assert!(
                first < 0.05 * finest[k] && second < 0.2 * first + 1e-6 * finest[k],
                "{k}: {first} {second}"
            );
        }
    }
}
