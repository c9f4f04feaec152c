//! Sections of a tooth along its face: their dimensions between the given ones, and the flexibility
//! of the tooth between loads in different sections.
//!
//! In one section the work of two loads in the cantilever is the integral of `M M' / (E' I)` and of
//! its shear and axial terms ([`super::Cantilever`]). All of it is the same in similar sections of
//! any size. Between two sections, `1 / (E' sqrt(I I'))` replaces `1 / (E' I)`, at equal fractions
//! of the height of the tooth. This is a Gram matrix of the moments over the square roots of the
//! stiffnesses, hence positive semidefinite whatever the sections are. Between the given sections
//! the reciprocal square roots are interpolated linearly.

use super::cantilever::{GAUSS, SHEAR};
use super::{CriticalSection, Flexibility, RingShape};
use calyx_fe::material::Material;

/// Number of intervals of the height of the tooth.
const INTERVALS: usize = 64;
/// Exponent that makes intervals shorter towards the root, where the fillet widens.
const GRADING: f64 = 1.6;
/// Least thickness of a tooth relative to its height: pointed tips have none.
const THINNEST: f64 = 0.02;

/// Section of a tooth and the ring below it, in coordinates of the section, m: for conical gears
/// those of the developed back cone. The tooth points along +x.
///
/// A tooth that is inclined to the normal of its section by the spiral angle bends in its normal
/// section, which is shorter across by the cosine of that angle.
#[derive(Clone, Debug)]
pub struct ToothSection {
    /// Middle of the root: [`RingShape::root`] on the ring's radius through the middle of its arc.
    pub root: [f64; 2],
    /// Direction of that radius: angle from x to y, rad.
    pub radial: f64,
    /// Angle from that radius to the centre line of the tooth, in the normal section, rad.
    pub tilt: f64,
    /// Tangent of the spiral angle: displacement of the tooth along y per length along the face.
    pub rise: f64,
    /// Distances along the centre line from the middle of the root, and half of the thickness of
    /// the tooth there, in the normal section; ascending, the first distance 0.
    pub depths: Vec<[f64; 2]>,
    /// Ring that supports the tooth.
    pub ring: RingShape,
    /// Critical sections of the root stress next to both flanks, in the normal section; `None` if
    /// stresses are not requested.
    pub critical: Option<[RootStation; 2]>,
}

/// Critical section of the root stress in a section along the face.
#[derive(Clone, Copy, Debug)]
pub struct RootStation {
    /// Dimensions; the position is that in the normal section.
    pub section: CriticalSection,
    /// Coordinates on the fillet: from the end of the flank, and along the face, m.
    pub place: [f64; 2],
    /// Position in the body's frame, m.
    pub position: [f64; 3],
}

/// Position between two of the sections at equal distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct At {
    /// Section below.
    pub section: usize,
    /// Weight of the next section.
    pub weight: f64,
}

impl At {
    /// Returns the position at a part of the face between sections.
    pub fn new(part: f64, sections: usize) -> At {
        let last = sections.saturating_sub(1);
        let along = (part * last as f64).clamp(0.0, last as f64);
        let section = (along as usize).min(last.saturating_sub(1));
        At { section, weight: along - section as f64 }
    }

    /// Returns the sections with their weights.
    pub fn weights(self) -> [(usize, f64); 2] {
        let next = self.section + usize::from(self.weight > 0.0);
        [(self.section, 1.0 - self.weight), (next, self.weight)]
    }

    fn between(self, values: &[f64]) -> f64 {
        self.weights().into_iter().map(|(section, weight)| weight * values[section]).sum()
    }
}

/// Dimensions of a section that vary along the face.
#[derive(Clone, Debug)]
pub(super) struct Dimensions {
    columns: [Vec<f64>; 7],
}

/// Dimensions at one position along the face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dimension {
    pub root: [f64; 2],
    pub radial: f64,
    pub tilt: f64,
    pub rise: f64,
    /// Length of the cantilever, m.
    pub height: f64,
    /// Radius of the ring, m.
    pub radius: f64,
}

impl Dimensions {
    pub fn new(sections: &[ToothSection]) -> Dimensions {
        let column = |of: &dyn Fn(&ToothSection) -> f64| sections.iter().map(of).collect();
        Dimensions {
            columns: [
                column(&|section| section.root[0]),
                column(&|section| section.root[1]),
                column(&|section| section.radial),
                column(&|section| section.tilt),
                column(&|section| section.rise),
                column(&ToothSection::height),
                column(&|section| section.ring.radius),
            ],
        }
    }

    pub fn at(&self, at: At) -> Dimension {
        let [x, y, radial, tilt, rise, height, radius] =
            [0, 1, 2, 3, 4, 5, 6].map(|k: usize| at.between(&self.columns[k]));
        Dimension { root: [x, y], radial, tilt, rise, height, radius }
    }

    pub fn bytes(&self) -> usize {
        self.columns.iter().map(|column| size_of_val(column.as_slice())).sum()
    }
}

impl ToothSection {
    /// Returns the height of the tooth above its root, m.
    pub fn height(&self) -> f64 {
        self.depths.last().map_or(0.0, |last| last[0])
    }
}

/// Flexibility of cantilevers of unit length between their sections.
#[derive(Clone, Debug)]
pub(super) struct BeamFamily {
    /// Fractions of the height.
    nodes: Vec<f64>,
    /// Thickness relative to the height at the nodes, by section.
    thicknesses: Vec<Vec<f64>>,
    /// Flexibility from the root up to each node, by pairs of sections.
    tables: Vec<Vec<Flexibility>>,
    modulus: f64,
    shear_modulus: f64,
}

impl BeamFamily {
    pub fn new(sections: &[ToothSection], material: Material) -> BeamFamily {
        let nodes: Vec<f64> = (0..=INTERVALS).map(|k| (k as f64 / INTERVALS as f64).powf(GRADING)).collect();
        let thickness = |section: &ToothSection| {
            let height = section.height();
            let at = |node: &f64| (2.0 * interpolated(&section.depths, node * height) / height).max(THINNEST);
            nodes.iter().map(at).collect::<Vec<f64>>()
        };
        let mut family = BeamFamily {
            thicknesses: sections.iter().map(thickness).collect(),
            nodes,
            tables: Vec::new(),
            modulus: material.surface_modulus(calyx_fe::material::Plane::Strain),
            shear_modulus: 0.5 * material.youngs_modulus / (1.0 + material.poissons_ratio),
        };
        let count = sections.len();
        let mut tables = Vec::with_capacity(count * count);
        for one in 0..count {
            for other in 0..count {
                let mut table = vec![Flexibility::default(); INTERVALS + 1];
                for k in 0..INTERVALS {
                    table[k + 1] = family.added(table[k], [one, other], k, 1.0);
                }
                tables.push(table);
            }
        }
        family.tables = tables;
        family
    }

    /// Adds the flexibility of a part of an interval.
    fn added(&self, mut sum: Flexibility, pair: [usize; 2], interval: usize, part: f64) -> Flexibility {
        let [start, end] = [self.nodes[interval], self.nodes[interval + 1]];
        let weight = 0.5 * part * (end - start);
        for x in [0.5 - 0.5 * GAUSS, 0.5 + 0.5 * GAUSS] {
            let share = part * x;
            let t = start + share * (end - start);
            let thickness = |section: usize| {
                let of = &self.thicknesses[section];
                of[interval] + share * (of[interval + 1] - of[interval])
            };
            let depth = (thickness(pair[0]) * thickness(pair[1])).sqrt();
            let bending = weight * 12.0 / (self.modulus * depth * depth * depth);
            sum.bending[0] += bending;
            sum.bending[1] += bending * t;
            sum.bending[2] += bending * t * t;
            sum.shear += weight * SHEAR / (self.shear_modulus * depth);
            sum.axial += weight / (self.modulus * depth);
        }
        sum
    }

    /// Returns the flexibility from the root up to a fraction of the height, between a position
    /// along the face and each section.
    pub fn up_to(&self, fraction: f64, at: At) -> Vec<Flexibility> {
        let fraction = fraction.clamp(0.0, 1.0);
        let interval = self.nodes.partition_point(|node| *node <= fraction).clamp(1, INTERVALS) - 1;
        let [start, end] = [self.nodes[interval], self.nodes[interval + 1]];
        let part = (fraction - start) / (end - start);
        let count = self.thicknesses.len();
        let between = |other: usize| {
            let of = |(section, weight): (usize, f64)| {
                let before = self.tables[section * count + other][interval];
                self.added(before, [section, other], interval, part).scaled(weight)
            };
            let [first, second] = at.weights().map(of);
            first.plus(&second)
        };
        (0..count).map(between).collect()
    }

    pub fn bytes(&self) -> usize {
        let tables: usize = self.tables.iter().map(|table| size_of_val(table.as_slice())).sum();
        tables + self.thicknesses.iter().map(|of| size_of_val(of.as_slice())).sum::<usize>()
    }
}

/// Returns the flexibility between two positions from that of [`BeamFamily::up_to`].
pub(super) fn at_position(by_section: &[Flexibility], at: At) -> Flexibility {
    let of = |(section, weight): (usize, f64)| by_section.get(section).map(|of| of.scaled(weight));
    let [first, second] = at.weights().map(|pair| of(pair).unwrap_or_default());
    first.plus(&second)
}

/// Returns the value at a distance in a list of ascending distances, constant beyond its ends.
fn interpolated(list: &[[f64; 2]], at: f64) -> f64 {
    let next = list.partition_point(|[distance, _]| *distance <= at);
    match (next.checked_sub(1).map(|last| list[last]), list.get(next)) {
        (Some([from, low]), Some([to, high])) => low + (at - from) / (to - from) * (high - low),
        (Some([_, last]), None) => last,
        (None, Some([_, first])) => *first,
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analytic::{Cantilever, RootLoad};
    use calyx_fe::material::Plane;
    use nalgebra::DMatrix;

    fn tapering(size: f64, slope: f64) -> ToothSection {
        let depths = (0..=40)
            .map(|k| f64::from(k) / 40.0)
            .map(|part| [size * part, size * (0.5 - slope * part)])
            .collect();
        let ring = RingShape {
            radius: 10.0 * size,
            fixed_radius: 8.0 * size,
            half_arc: 0.05,
            lean: 1.0,
            sectors: 20,
        };
        ToothSection {
            root: [10.0 * size, 0.0],
            radial: 0.0,
            tilt: 0.0,
            rise: 0.0,
            depths,
            ring,
            critical: None,
        }
    }

    fn load(crossing: f64) -> RootLoad {
        RootLoad { axial: -0.3, shear: 0.9, moment: 0.9 * crossing }
    }

    fn between(family: &BeamFamily, (one, at): (f64, At), (other, to): (f64, At)) -> f64 {
        let [(nearer, at), (_, to)] =
            if one <= other { [(one, at), (other, to)] } else { [(other, to), (one, at)] };
        let by_section = family.up_to(nearer, at);
        at_position(&by_section, to).between(&load(one), &load(other))
    }

    /// In one section, and between similar sections of different sizes, the family is the
    /// cantilever.
    #[test]
    fn similar_sections_are_one_cantilever() {
        let sections = [1e-3, 1.7e-3, 2.4e-3].map(|size| tapering(size, 0.3));
        let family = BeamFamily::new(&sections, Material::STEEL);
        let beam = Cantilever::new(&sections[0].depths, Material::STEEL, Plane::Strain);
        for (low, high) in [(0.3, 0.3), (0.4, 0.9), (0.77, 1.0)] {
            let scaled = |crossing: f64| {
                let load = load(crossing);
                RootLoad { moment: 1e-3 * load.moment, ..load }
            };
            let exact = beam.up_to(1e-3 * low).between(&scaled(low), &scaled(high));
            for (one, other) in [(0.0, 0.0), (0.0, 1.0), (0.3, 0.8)] {
                let [one, other] = [one, other].map(|part| At::new(part, 3));
                let found = between(&family, (low, one), (high, other));
                assert!((found / exact - 1.0).abs() < 2e-3, "{low} {high}: {found} {exact}");
            }
        }
    }

    #[test]
    fn different_sections_have_a_positive_flexibility() {
        let sections = [(1e-3, 0.1), (1.2e-3, 0.4), (3e-3, 0.2)].map(|(size, slope)| tapering(size, slope));
        let family = BeamFamily::new(&sections, Material::STEEL);
        let mut loads = Vec::new();
        for part in [0.0, 0.2, 0.5, 0.9, 1.0] {
            loads.extend([0.1, 0.35, 0.6, 0.85, 1.0].map(|crossing| (crossing, At::new(part, 3))));
        }
        let matrix = DMatrix::from_fn(loads.len(), loads.len(), |i, j| between(&family, loads[i], loads[j]));
        assert!((&matrix - matrix.transpose()).amax() < 1e-13 * matrix.amax());
        let least = matrix.clone().symmetric_eigenvalues().min();
        assert!(least > -1e-12 * matrix.amax(), "{least}");
    }

    #[test]
    fn dimensions_are_linear_between_sections() {
        let sections = [1e-3, 2e-3, 4e-3].map(|size| tapering(size, 0.3));
        let dimensions = Dimensions::new(&sections);
        for (part, height) in
            [(0.0, 1e-3), (0.25, 1.5e-3), (0.5, 2e-3), (0.75, 3e-3), (1.0, 4e-3), (1.2, 4e-3)]
        {
            let found = dimensions.at(At::new(part, 3));
            assert!((found.height - height).abs() < 1e-15, "{part}: {}", found.height);
            assert!((found.radius - 10.0 * height).abs() < 1e-14);
        }
    }
}
