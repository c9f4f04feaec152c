//! Three-dimensional model of the same teeth: thin slices across the axis, coupled along the face.
//!
//! The compliance of slices is distributed along the face by `K(z, z')`, the response of a row of
//! slices coupled in shear to a load on one of them, between free side faces:
//! `K - length² K'' = delta`. Its integral over the face is one, so a uniform load gives the
//! compliance of the plane model, whatever the length. This is the model of a cantilever plate:
//! with deflections `w(z) x²` its bending stiffness `4 D / H³` and its twisting stiffness
//! `8/3 (1 - nu) D / H` give `length² = 2/3 (1 - nu) H²` (Kantorovich's method; bending along the
//! face, which decays faster, is neglected).
//!
//! Near a load the half-space replaces the half-plane, with the same reference depth:
//! `1 / r - 1 / sqrt(r² + h h')` over `pi E'`, whose integral along a line is the plane model's
//! `ln(1 + h h' / x²) / (pi E')`. The first term is the near field of all structures, with its
//! images in the side faces; this module adds the second one.

use super::foundation_ring::FoundationRing;
use super::{Local, Tooth, ToothShape};
use crate::Chart;
use crate::solid::{Mirror, SegmentLoad, SolidStructure, SurfaceSegment, SurfaceStress};
use crate::surface::Surface;
use calyx_fe::material::{Material, Plane};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::PI;
use std::sync::Arc;

/// Number of stations along the face with recovered stress.
const STATIONS: usize = 17;
/// Two stretches are averaged to second order if the distance of their middles from each other or
/// from their common line is at least this many mean lengths: the error is below 2.6e-4.
const FAR: f64 = 4.0;

/// Slices of teeth around a ring with closed-form compliances.
pub struct AnalyticSolid {
    surfaces: Vec<Arc<dyn Surface>>,
    tooth: Tooth,
    ring: FoundationRing,
    teeth: u32,
    face: Face,
    mirrors: [Mirror; 2],
}

/// Face, and the coupling of its slices.
#[derive(Clone, Copy, Debug)]
struct Face {
    width: f64,
    /// Counter-clockwise rotation of slices per length along z, rad/m.
    twist: f64,
    /// Length over which slices distribute a load, m.
    spread: f64,
    /// Common factor of the exponentials in K, 1/m.
    share: f64,
    /// Exponential of the whole width.
    across: f64,
}

/// Stretch of a flank under a unit force, and its slice.
struct Place {
    slice: Local,
    position: [f64; 3],
    z: f64,
    /// Length of the stretch along the face.
    length: f64,
    /// Length on the flank per length along the face.
    stretch: f64,
    /// Factor on exponentials along the face by averaging over the stretch.
    swelling: f64,
    /// Exponentials that are one in the lower and in the upper side face.
    ends: [f64; 2],
}

impl AnalyticSolid {
    /// Builds the body. `surfaces` are the flanks of tooth 0 over arc lengths of the profile and
    /// distances from mid-face; `twist` is the counter-clockwise rotation of sections per length
    /// along z, rad/m.
    pub fn new(
        surfaces: Vec<Arc<dyn Surface>>,
        shape: &ToothShape,
        [face_width, twist]: [f64; 2],
        material: Material,
    ) -> AnalyticSolid {
        let tooth = Tooth::new(shape, material, Plane::Strain);
        let height = tooth.cantilever.length();
        // Length along the tooth; along the face it is shorter.
        let spread = shape.ring.lean * height * (2.0 / 3.0 * (1.0 - material.poissons_ratio)).sqrt();
        let mirror = |z: f64| Mirror { point: [0.0, 0.0, z], normal: [0.0, 0.0, 1.0] };
        AnalyticSolid {
            surfaces,
            tooth,
            ring: FoundationRing::new(&shape.ring, material, Plane::Strain),
            teeth: shape.ring.sectors.max(1),
            face: Face::new(face_width, twist, spread),
            mirrors: [-0.5, 0.5].map(|part| mirror(part * face_width)),
        }
    }

    fn places(&self, chart: Chart, segments: &[SurfaceSegment]) -> Vec<Place> {
        let Some(surface) = self.surfaces.get(chart.surface as usize) else { return Vec::new() };
        segments.iter().map(|segment| self.place(surface.as_ref(), segment)).collect()
    }

    fn place(&self, surface: &dyn Surface, segment: &SurfaceSegment) -> Place {
        let ([s, z], face) = (segment.place, &self.face);
        let on = surface.at(s, z);
        let (sine, cosine) = (face.twist * z).sin_cos();
        // Coordinates of the slice, with the tooth along x.
        let turned = |[x, y, _]: [f64; 3]| [cosine * x + sine * y, cosine * y - sine * x];
        let entering = surface.edge_from().map_or(on, |edge| surface.at(s.min(edge), z));
        let [point, entry] = [on, entering].map(|on| (turned(on.position), turned(on.normal)));
        let slice = self.tooth.local_at(s, point, entry);
        let [x, y, w] = on.tangents[1];
        Place {
            slice,
            position: on.position,
            z,
            length: segment.length,
            stretch: x.hypot(y).hypot(w) / w.abs().max(f64::MIN_POSITIVE),
            swelling: swelling(0.5 * segment.length / face.spread),
            ends: face.ends(z),
        }
    }

    /// Returns the contribution of the reference depth beneath the loads, to be subtracted from the
    /// half-space and its images, m/N.
    fn near(&self, one: &Place, other: &Place) -> f64 {
        let stretch = (one.stretch * other.stretch).sqrt();
        let lengths = [one, other].map(|place| stretch * place.length);
        let depths = one.slice.depth * other.slice.depth;
        // Images in side faces have the same distance in the section as the points.
        let flat: f64 = (0..2).map(|k| (one.position[k] - other.position[k]).powi(2)).sum();
        let apart = |axial: f64| {
            let along = stretch * axial.abs();
            let across = (flat + axial * axial - along * along).max(0.0);
            mean_inverse((across + depths).sqrt(), along, lengths)
        };
        let images: f64 = [-1.0, 1.0].iter().map(|end| apart(one.z + other.z + end * self.face.width)).sum();
        -(apart(one.z - other.z) + images) / (PI * self.tooth.modulus)
    }
}

/// Returns `sinh(x) / x`.
fn swelling(x: f64) -> f64 {
    if x < 1e-3 { 1.0 + x * x / 6.0 } else { x.sinh() / x }
}

impl Face {
    fn new(width: f64, twist: f64, spread: f64) -> Face {
        let round_trip = -2.0 * width / spread;
        let share = (2.0 * spread * -round_trip.exp_m1()).recip();
        Face { width, twist, spread, share, across: (0.5 * round_trip).exp() }
    }

    fn ends(&self, z: f64) -> [f64; 2] {
        [-1.0, 1.0].map(|end| ((end * z - 0.5 * self.width) / self.spread).exp())
    }

    /// Returns K, averaged over both stretches, 1/m. Exchanging the two gives the same bits.
    ///
    /// It is a sum of exponentials: that of the slice, those of its images in both side faces, and
    /// that of their images in turn; the denominator accounts for all further images.
    fn spread(&self, one: &Place, other: &Place) -> f64 {
        let apart = (one.z - other.z).abs() / self.spread;
        let (lower, upper) = if one.z < other.z { (one, other) } else { (other, one) };
        let swollen = one.swelling * other.swelling;
        let [first, second] = [one, other].map(|place| place.length / self.spread);
        let (reach, difference) = (0.5 * (first + second), 0.5 * (first - second).abs());
        let [direct, beyond] = if apart >= reach || first * second < 1e-8 {
            [swollen * (-apart).exp(), swollen * (upper.ends[1] * lower.ends[0] * self.across)]
        } else {
            // Overlapping stretches: second differences of the second antiderivative.
            let mean = |twice: &dyn Fn(f64) -> f64| {
                let ends = (twice(apart + reach) - twice(apart + difference))
                    + (twice(apart - reach) - twice(apart - difference));
                ends / (first * second)
            };
            let across = self.across * self.across;
            let growing = |u: f64| (u.abs().exp() - u.abs()) * across;
            [mean(&|u: f64| (-u.abs()).exp() + u.abs()), mean(&growing)]
        };
        let images = swollen * (one.ends[0] * other.ends[0] + one.ends[1] * other.ends[1]);
        (direct + beyond + images) * self.share
    }
}

/// Returns the mean of `1 / sqrt(a² + u²)` over two stretches of a line whose middles are `along`
/// apart.
pub(super) fn mean_inverse(a: f64, along: f64, [first, second]: [f64; 2]) -> f64 {
    let square = a * a + along * along;
    let (sum, difference) = (0.5 * (first + second), 0.5 * (first - second).abs());
    if square > (FAR * sum).powi(2) || first * second == 0.0 {
        // Variance of the distance between two points of the stretches, relative to the square of
        // the distance.
        let variance = (first * first + second * second) / (12.0 * square);
        let bent = 3.0 * along * along / square - 1.0;
        return (1.0 + 0.5 * variance * bent) / square.sqrt();
    }
    // Second differences of the second antiderivative: `u asinh(u / a) - sqrt(a² + u²)`.
    let twice = |u: f64| {
        let (u, r) = (u.abs(), (a * a + u * u).sqrt());
        u * ((u + r) / a).ln() - r
    };
    let ends =
        (twice(along + sum) - twice(along + difference)) + (twice(along - sum) - twice(along - difference));
    ends / (first * second)
}

impl SolidStructure for AnalyticSolid {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.surfaces[surface as usize].clone()
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        self.tooth.modulus
    }

    fn mirrors(&self) -> &[Mirror] {
        &self.mirrors
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observers: &[SurfaceSegment],
        load: Chart,
        loads: &[SurfaceSegment],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        // The coupling of two points is the same from either side.
        let is_own = observe == load && observers == loads;
        let (observers, loads) = (self.places(observe, observers), self.places(load, loads));
        if loads.is_empty() {
            return Ok(());
        }
        let ring = self.ring.link(observe.tooth, load.tooth);
        let columns = loads.len();
        for (i, observer) in observers.iter().enumerate() {
            interrupt.check()?;
            let all = if is_own { i + 1 } else { columns };
            for (j, loaded) in loads[..all].iter().enumerate() {
                let (one, other) = (&observer.slice, &loaded.slice);
                let mut slices = ring.compliance(&one.load, &other.load);
                if observe.tooth == load.tooth {
                    slices += self.tooth.between(one, other);
                }
                let mut given = slices * self.face.spread(observer, loaded);
                if observe == load {
                    given += self.near(observer, loaded);
                }
                block[i * columns + j] += given;
                if is_own && j < i {
                    block[j * columns + i] += given;
                }
            }
        }
        Ok(())
    }

    /// Returns the stress of the standard in each slice under the force that slices pass on to it.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SegmentLoad]) -> Vec<SurfaceStress> {
        let Some(section) = &self.tooth.section else { return Vec::new() };
        let side = if surface == 0 { 1.0 } else { -1.0 };
        let own = loads.iter().filter(|load| load.chart.tooth == tooth);
        let by: Vec<(Place, f64)> = own
            .filter_map(|load| {
                let place =
                    self.place(self.surfaces.get(load.chart.surface as usize)?.as_ref(), &load.segment);
                let stress = load.force * self.tooth.stress(section, &place.slice, side);
                Some((place, stress))
            })
            .collect();
        let station = |k: usize| {
            let z = self.face.width * (k as f64 / (STATIONS - 1) as f64 - 0.5);
            let (slice, position) = (Local::default(), [0.0, 0.0, z]);
            let ends = self.face.ends(z);
            let here = Place { slice, position, z, length: 0.0, stretch: 1.0, swelling: 1.0, ends };
            let along = by.iter().map(|(place, stress)| stress * self.face.spread(place, &here)).sum();
            let (sine, cosine) = (self.tooth_angle(tooth) + self.face.twist * z).sin_cos();
            let [x, y] = [section.position[0], side * section.position[1]];
            SurfaceStress {
                tooth,
                surface,
                place: [section.s, z],
                position: [cosine * x - sine * y, sine * x + cosine * y, z],
                components: [along, 0.0, 0.0],
            }
        };
        (0..STATIONS).map(station).collect()
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.tooth.cantilever.bytes() + self.ring.bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::super::RingShape;
    use super::super::tests::Slab;
    use super::*;
    use crate::Structure;
    use crate::analytic::AnalyticStructure;
    use crate::surface::SurfacePoint;

    /// Side of a slab, constant along a face.
    struct Wall(Slab, f64);

    impl Surface for Wall {
        fn range(&self) -> [[f64; 2]; 2] {
            [[0.0, self.0.length], [-0.5 * self.1, 0.5 * self.1]]
        }

        fn at(&self, u: f64, v: f64) -> SurfacePoint {
            let on = crate::profile::Profile::at(&self.0, u);
            let ([x, y], [nx, ny], [tx, ty]) = (on.position, on.normal, on.tangent);
            SurfacePoint {
                position: [x, y, v],
                tangents: [[tx, ty, 0.0], [0.0, 0.0, 1.0]],
                normal: [nx, ny, 0.0],
            }
        }
    }

    const WIDTH: f64 = 6e-3;
    const FLANK: Chart = Chart { tooth: 2, surface: 0 };

    fn bodies(material: Material) -> (AnalyticStructure, AnalyticSolid) {
        let ring = RingShape { radius: 10e-3, fixed_radius: 8e-3, half_arc: 0.05, lean: 1.0, sectors: 20 };
        let slab = |side| Slab { from: ring.root(), length: 1e-3, half: 0.3e-3, side };
        let depths = (0..=10).map(|k| [0.1e-3 * f64::from(k), 0.3e-3]).collect();
        let shape = ToothShape { sense: 1.0, depths, ring, section: None };
        let plane = AnalyticStructure::new(
            vec![Arc::new(slab(1.0)), Arc::new(slab(-1.0))],
            &shape,
            material,
            Plane::Strain,
        );
        let walls: [Arc<dyn Surface>; 2] =
            [1.0, -1.0].map(|side| Arc::new(Wall(slab(side), WIDTH)) as Arc<dyn Surface>);
        (plane, AnalyticSolid::new(walls.to_vec(), &shape, [WIDTH, 0.0], material))
    }

    /// Returns slices of a face with different lengths.
    fn slices(s: f64) -> Vec<SurfaceSegment> {
        let ends = [-0.5, -0.45, -0.3, -0.25, 0.0, 0.1, 0.3, 0.42, 0.5];
        let slice = |pair: &[f64]| SurfaceSegment {
            place: [s, 0.5 * (pair[0] + pair[1]) * WIDTH],
            length: (pair[1] - pair[0]) * WIDTH,
        };
        ends.windows(2).map(slice).collect()
    }

    fn block(
        of: &AnalyticSolid,
        one: (Chart, &[SurfaceSegment]),
        other: (Chart, &[SurfaceSegment]),
    ) -> Vec<f64> {
        let mut block = vec![0.0; one.1.len() * other.1.len()];
        of.add_compliance(one.0, one.1, other.0, other.1, &mut block);
        block
    }

    /// A uniform load along the face gives the compliance of the plane model at every slice for any
    /// Poisson's ratio, except for the near field's images of images, a thousandth of it here.
    #[test]
    fn an_even_load_is_the_planes() {
        for nu in [0.0, 0.3, 0.45] {
            let (plane, solid) = bodies(Material { poissons_ratio: nu, ..Material::STEEL });
            let [low, high] = [0.5e-3, 0.8e-3];
            for (chart, near) in [
                (Chart { tooth: 3, surface: 0 }, false),
                (Chart { surface: 1, ..FLANK }, false),
                (FLANK, true),
            ] {
                let mut expected = [0.0];
                plane.add_compliance(FLANK, &[low], chart, &[high], &mut expected);
                let loads = slices(high);
                let given = block(&solid, (FLANK, &slices(low)), (chart, &loads));
                for (row, observer) in given.chunks(loads.len()).zip(slices(low)) {
                    let mut sum: f64 = row.iter().zip(&loads).map(|(c, load)| c * load.length).sum();
                    if near {
                        // Difference between the half-space's response to the line, with its
                        // images, and the half-plane's.
                        let (z, apart) = (observer.place[1], high - low);
                        let line: f64 =
                            [1.5 * WIDTH - z, 1.5 * WIDTH + z].iter().map(|end| (end / apart).asinh()).sum();
                        let modulus = plane.surface_modulus();
                        sum += (line - 2.0 * (plane.reference_length() / apart).ln()) / (PI * modulus);
                    }
                    let tolerance = if near { 2e-3 } else { 1e-12 };
                    assert!((sum / expected[0] - 1.0).abs() < tolerance, "{nu} {near}: {sum} {expected:?}");
                }
            }
        }
    }

    #[test]
    fn it_is_reciprocal_to_the_bit() {
        let (_, solid) = bodies(Material::STEEL);
        let segments: Vec<SurfaceSegment> = [0.3e-3, 0.32e-3, 0.9e-3].into_iter().flat_map(slices).collect();
        let turned: Vec<SurfaceSegment> = segments.iter().rev().copied().collect();
        for other in [FLANK, Chart { tooth: 3, surface: 1 }, Chart { surface: 1, ..FLANK }] {
            let [there, back] = [
                block(&solid, (FLANK, &segments), (other, &turned)),
                block(&solid, (other, &turned), (FLANK, &segments)),
            ];
            for i in 0..segments.len() {
                for j in 0..segments.len() {
                    assert_eq!(
                        there[i * segments.len() + j].to_bits(),
                        back[j * segments.len() + i].to_bits(),
                        "{i} {j}"
                    );
                }
            }
        }
    }

    /// Mirroring the result of one half of the pairs gives the same result as computing all pairs.
    #[test]
    fn places_seen_by_themselves_are_seen_as_by_others() {
        let (_, solid) = bodies(Material::STEEL);
        let segments: Vec<SurfaceSegment> = [0.3e-3, 0.9e-3].into_iter().flat_map(slices).collect();
        let own = block(&solid, (FLANK, &segments), (FLANK, &segments));
        for (row, segment) in own.chunks(segments.len()).zip(&segments) {
            assert_eq!(row, block(&solid, (FLANK, &[*segment]), (FLANK, &segments)));
        }
    }

    /// Means of the inverse distance against sums over many points.
    #[test]
    fn stretches_see_each_other_in_the_mean() {
        for (a, along, lengths) in [
            (0.3, 0.0, [1.0, 1.0]),
            (0.05, 0.8, [1.0, 0.5]),
            (0.3, 3.9, [1.0, 1.0]),
            (0.3, 4.1, [1.0, 1.0]),
            (4.2, 0.3, [1.0, 0.4]),
        ] {
            let count = 400;
            let at = |k: usize, length: f64| length * ((k as f64 + 0.5) / count as f64 - 0.5);
            let pairs = (0..count * count).map(|pair| {
                let u = along + at(pair / count, lengths[0]) - at(pair % count, lengths[1]);
                (a * a + u * u).sqrt().recip()
            });
            let sum = pairs.sum::<f64>() / (count * count) as f64;
            let found = mean_inverse(a, along, lengths);
            assert!((found / sum - 1.0).abs() < 3e-4, "{a} {along}: {found} {sum}");
        }
    }

    /// A load on one end of the face bends that end most.
    #[test]
    fn slices_hold_each_other_over_a_tooths_height() {
        let (_, solid) = bodies(Material::STEEL);
        let through = Chart { surface: 1, ..FLANK };
        let at = |z: f64| [SurfaceSegment { place: [0.8e-3, z], length: 0.0 }];
        let of = |z: f64| -block(&solid, (through, &at(z)), (FLANK, &at(-0.5 * WIDTH)))[0];
        let spread = 1e-3 * (2.0f64 / 3.0 * 0.7).sqrt();
        let [end, one, middle] = [of(-0.5 * WIDTH), of(-0.5 * WIDTH + spread), of(0.0)];
        assert!((one / end - (-1.0f64).exp()).abs() < 1e-3 && middle < 0.02 * end, "{end} {one} {middle}");
    }
}
