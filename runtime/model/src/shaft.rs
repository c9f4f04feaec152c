//! Shafts: straight beams of circular sections with shear deformation and rotary inertia
//! (Timoshenko), condensed onto their stations; or solids of revolution ([`solid`]).
//!
//! A shaft extends along the z axis of its coordinates, from 0 to its length. Forces and masses of
//! gears, bearings and couplings act at its *stations*. Between neighbouring stations the shaft is
//! statically determinate, so its stiffness matrix is the inverse of the flexibility of that
//! stretch: the condensation is exact for any number of segments and for tapers ([`beam`]). The
//! mass matrix follows from the static displacements between the stations (Guyan). The parts beyond
//! the outermost stations carry no load and move rigidly with these stations.
//!
//! Motions and forces have six components each, in the order of [`crate::dof::DOF_NAMES`], along
//! and about the axes of the shaft.
//!
//! See `docs/theory/shafts.md`.

mod beam;
mod deformed;
mod modes;
mod segment;
mod solid;
mod surface;

pub use beam::SectionForces;
pub use segment::{ShaftSegment, shear_coefficient};
pub use solid::SolidShaftMesh;

use beam::{Integrals, Stretch};
use calyx_fe::inertia::Inertia;
use calyx_fe::material::Material;
use calyx_numerics::error::EngineError;
use calyx_numerics::quadrature::gauss_legendre;
use calyx_structure::cache::Key;
use segment::Section;

/// Motion or force: three components along and three about the axes of the shaft.
pub type Six = [f64; 6];

/// Number of Gauss points over each part of a shaft between two steps or stations.
const POINTS: usize = 8;
/// Number of parts into which a tapered segment is divided for integration.
const TAPERED: usize = 8;
/// Distance of two positions on a shaft, relative to its length, below which they are one.
pub const SAME_POSITION: f64 = 1e-9;

/// Shaft without stations: its segments in sequence, and its material.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    segments: Vec<ShaftSegment>,
    material: Material,
    /// Positions of the ends of the segments, m, from 0 to the length.
    ends: Vec<f64>,
}

impl Shaft {
    /// Creates a shaft from segments in the order of their positions.
    ///
    /// # Errors
    /// E0858: there is no segment, or two neighbours do not touch each other.
    pub fn new(segments: Vec<ShaftSegment>, material: Material) -> Result<Shaft, EngineError> {
        if segments.is_empty() {
            return Err(EngineError::new(
                "E0858",
                "a shaft has no segment",
                "give at least one, such as `gears.shaft_segment(length = 80 mm, diameter = 30 mm)`",
            )
            .blame("segments"));
        }
        for (index, pair) in segments.windows(2).enumerate() {
            let [end, start] =
                [pair[0].section(1.0), pair[1].section(0.0)].map(|section| section.carrying_radii());
            if end[0].max(start[0]) >= end[1].min(start[1]) {
                let message = format!(
                    "segments {} and {} of a shaft do not touch: the bore of one is not smaller than the diameter of the other",
                    index + 1,
                    index + 2
                );
                let help = "let their walls overlap where they meet";
                return Err(EngineError::new("E0858", message, help).blame("segments"));
            }
        }
        let mut ends = vec![0.0];
        for segment in &segments {
            ends.push(ends[ends.len() - 1] + segment.length);
        }
        Ok(Shaft { segments, material, ends })
    }

    /// Returns a key of the contents, for caches.
    pub fn key(&self) -> Key {
        let Material { youngs_modulus, poissons_ratio, density } = self.material;
        let material = Key::of("shaft").numbers(&[youngs_modulus, poissons_ratio, density]);
        let all = self.segments.iter().fold(material, |key, segment| {
            let ShaftSegment { length, diameter: [start, end], bore, stiffness_diameter } = *segment;
            key.numbers(&[length, start, end, bore[0], bore[1]]).number(stiffness_diameter.unwrap_or(0.0))
        });
        all.finish()
    }

    /// Returns the length, m.
    pub fn length(&self) -> f64 {
        self.ends.last().copied().unwrap_or_default()
    }

    /// Returns the largest outside diameter, m.
    pub fn largest_diameter(&self) -> f64 {
        self.segments.iter().flat_map(|segment| segment.diameter).fold(0.0, f64::max)
    }

    /// Returns the outside diameter and the bore at a position (m), m; at a step those of the
    /// larger outside diameter.
    pub fn diameters_at(&self, z: f64) -> [f64; 2] {
        let [before, after] = [false, true].map(|after| self.section(z, after).diameters());
        if after[0] > before[0] { after } else { before }
    }

    /// Returns the positions of the ends of the segments, m.
    pub fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// Returns the position on the shaft next to `z` if both differ by rounding only, at the end of
    /// a segment that end; `None` if `z` is off the shaft.
    pub fn on_shaft(&self, z: f64) -> Option<f64> {
        let slack = SAME_POSITION * self.length();
        let end = self.ends.iter().copied().find(|end| (z - end).abs() <= slack);
        end.or((0.0 < z && z < self.length()).then_some(z))
    }

    /// Returns the segment at a position, and the section there. At a step it is the segment
    /// towards -z, or towards +z if `after`.
    fn section(&self, z: f64, after: bool) -> Section {
        let inner = &self.ends[1..self.ends.len() - 1];
        let index = inner.iter().filter(|&&end| if after { end <= z } else { end < z }).count();
        let segment = &self.segments[index];
        segment.section((z - self.ends[index]) / segment.length)
    }

    /// Returns the parts of the shaft between two positions over which its sections are smooth.
    fn parts(&self, from: f64, to: f64) -> Vec<[f64; 2]> {
        let mut parts = Vec::new();
        for (segment, ends) in self.segments.iter().zip(self.ends.windows(2)) {
            let (start, end) = (ends[0].max(from), ends[1].min(to));
            if end <= start {
                continue;
            }
            let count = if segment.is_tapered() { TAPERED } else { 1 };
            let at = |k: usize| start + (end - start) * (k as f64 / count as f64);
            parts.extend((0..count).map(|k| [at(k), at(k + 1)]));
        }
        parts
    }

    /// Returns Gauss points and weights between two positions, m.
    fn gauss(&self, from: f64, to: f64) -> Vec<(f64, f64)> {
        let rule = gauss_legendre(POINTS);
        let mut points = Vec::new();
        for [start, end] in self.parts(from, to) {
            let half = 0.5 * (end - start);
            points.extend(rule.iter().map(|(x, w)| (start + half * (1.0 + x), half * w)));
        }
        points
    }

    /// Integrates the compliances of the sections between two positions; lever arms are measured
    /// from `origin`.
    fn integrals(&self, [from, to]: [f64; 2], origin: f64) -> Integrals {
        self.gauss(from, to).into_iter().fold(Integrals::default(), |sum, (z, weight)| {
            sum.plus(&self.section(z, false), &self.material, z - origin, weight)
        })
    }

    fn stretch(&self, from: f64, to: f64) -> Stretch {
        Stretch::new(to - from, self.integrals([from, to], from))
    }

    /// Returns the stiffness matrix between stations at these ascending positions (m), six rows a
    /// station, row-major. Rigid-body motions of the shaft cause no forces.
    pub fn stiffness(&self, stations: &[f64]) -> Vec<f64> {
        let size = 6 * stations.len();
        let mut matrix = vec![0.0; size * size];
        for (first, ends) in stations.windows(2).enumerate() {
            let stretch = self.stretch(ends[0], ends[1]);
            for column in 0..12 {
                let mut unit = [[0.0; 6]; 2];
                unit[column / 6][column % 6] = 1.0;
                let forces = stretch.end_forces(&unit[0], &unit[1]);
                for row in 0..12 {
                    matrix[(6 * first + row) * size + 6 * first + column] += forces[row / 6][row % 6];
                }
            }
        }
        symmetric(&mut matrix, size);
        matrix
    }

    /// Returns the mass matrix of the shaft on the same stations, with rotary inertia.
    pub fn mass(&self, stations: &[f64]) -> Vec<f64> {
        let product =
            |one: &Six, inertia: &Six, other: &Six| (0..6).map(|k| one[k] * inertia[k] * other[k]).sum();
        let mut matrix = self.inertia_matrix(stations, product);
        symmetric(&mut matrix, 6 * stations.len());
        matrix
    }

    /// Returns the gyroscopic matrix of the shaft on the same stations per angular velocity (rad/s)
    /// about +z, kg m²: skew-symmetric, from the same displacements as the mass matrix. Its product
    /// with the velocities of the stations is the inertia force, as with the mass matrix.
    pub fn gyroscopic(&self, stations: &[f64]) -> Vec<f64> {
        // A section of the polar inertia J has the spin momentum J e3, which follows its rotation.
        // The rate of change of this momentum is J (theta' x e3).
        self.inertia_matrix(stations, |one, inertia, other| {
            inertia[5] * (one[3] * other[4] - one[4] * other[3])
        })
    }

    /// Integrates a bilinear form of the motions of sections and of their inertia along the shaft,
    /// in the displacements between the stations.
    fn inertia_matrix(&self, stations: &[f64], form: impl Fn(&Six, &Six, &Six) -> f64) -> Vec<f64> {
        let size = 6 * stations.len();
        let mut matrix = vec![0.0; size * size];
        let (Some(&low), Some(&high)) = (stations.first(), stations.last()) else { return matrix };
        let mut add = |first: usize, shapes: &[[Six; 6]], inertia: &Six, weight: f64| {
            for (i, one) in shapes.iter().flatten().enumerate() {
                for (j, other) in shapes.iter().flatten().enumerate() {
                    matrix[(6 * first + i) * size + 6 * first + j] += weight * form(one, inertia, other);
                }
            }
        };
        let units: [Six; 6] = std::array::from_fn(|k| std::array::from_fn(|row| f64::from(row == k)));
        let overhangs = [(0, 0.0, low), (stations.len() - 1, high, self.length())];
        for (station, from, to) in overhangs {
            for (z, weight) in self.gauss(from, to) {
                let inertia = self.section(z, false).inertia(&self.material);
                let shapes = units.map(|unit| beam::carried(z - stations[station], &unit));
                add(station, &[shapes], &inertia, weight);
            }
        }
        for (first, ends) in stations.windows(2).enumerate() {
            let stretch = self.stretch(ends[0], ends[1]);
            for (z, weight) in self.gauss(ends[0], ends[1]) {
                let up_to = self.integrals([ends[0], z], ends[0]);
                let shape = |left: &Six, right: &Six| stretch.within(z - ends[0], &up_to, left, right);
                let shapes =
                    [units.map(|unit| shape(&unit, &[0.0; 6])), units.map(|unit| shape(&[0.0; 6], &unit))];
                add(first, &shapes, &self.section(z, false).inertia(&self.material), weight);
            }
        }
        matrix
    }

    /// Returns the motion of the section at `z` (m) from the motions of the stations.
    pub fn motion_at(&self, stations: &[f64], motions: &[Six], z: f64) -> Six {
        let (Some(&low), Some(&high)) = (stations.first(), stations.last()) else { return [f64::NAN; 6] };
        if z <= low {
            return beam::carried(z - low, &motions[0]);
        }
        if z >= high {
            return beam::carried(z - high, &motions[stations.len() - 1]);
        }
        let first = stations[1..].iter().filter(|&&end| end <= z).count();
        let [from, to] = [stations[first], stations[first + 1]];
        let up_to = self.integrals([from, z], from);
        self.stretch(from, to).within(z - from, &up_to, &motions[first], &motions[first + 1])
    }

    /// Returns the forces in the section at `z` (m): those of the part towards +z on the part
    /// towards -z, from the forces of gears, bearings and couplings on the shaft at its stations.
    /// Those at `z` itself count as beyond the section, or as before it if `after`.
    pub fn section_forces(&self, stations: &[f64], forces: &[Six], (z, after): (f64, bool)) -> SectionForces {
        let slack = SAME_POSITION * self.length();
        let mut sum = [0.0; 6];
        for (&station, force) in stations.iter().zip(forces) {
            let before = if after { station <= z + slack } else { station < z - slack };
            if before {
                let moved = beam::force_moved(station - z, force);
                sum.iter_mut().zip(moved).for_each(|(sum, part)| *sum -= part);
            }
        }
        SectionForces(sum)
    }

    /// Returns the nominal stresses in the section at `z` (m) under these forces: of bending with
    /// axial force, of torsion, and the equivalent stress of both (von Mises), Pa. Stress
    /// concentrations are not included.
    pub fn nominal_stress(&self, (z, after): (f64, bool), forces: &SectionForces) -> [f64; 3] {
        let section = self.section(z, after);
        let normal =
            forces.bending_moment() / section.bending_modulus() + forces.axial().abs() / section.area();
        let shear = forces.torque().abs() / (2.0 * section.bending_modulus());
        [normal, shear, (normal * normal + 3.0 * shear * shear).sqrt()]
    }

    /// Returns the inertia of the whole shaft about the origin of its coordinates.
    pub fn inertia(&self) -> Inertia {
        self.gauss(0.0, self.length()).into_iter().fold(Inertia::default(), |sum, (z, weight)| {
            let [mass, _, _, across, _, polar] =
                self.section(z, false).inertia(&self.material).map(|entry| weight * entry);
            sum + Inertia::axial(mass, polar, across).shifted_along(z)
        })
    }
}

/// Makes a matrix exactly symmetric.
fn symmetric(matrix: &mut [f64], size: usize) {
    for row in 0..size {
        for column in 0..row {
            let mean = 0.5 * (matrix[row * size + column] + matrix[column * size + row]);
            matrix[row * size + column] = mean;
            matrix[column * size + row] = mean;
        }
    }
}
