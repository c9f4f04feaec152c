//! Strain gauges in fillets: readings at a location, in a direction and over a gauge length.
//!
//! Stress is recovered on a grid of points along the profile and along the face. Between them the
//! components are interpolated by cubics through the nearest points; the error of this is well
//! below that of the mesh. A gauge of finite length reads the mean along its line.

use super::stress::{FilletSide, Fillets, RootStress, Teeth, stresses};
use super::{Equilibrium, Observable, Quantity};
use calyx_fe::material::Material;
use calyx_fe::quadrature::gauss_legendre;
use calyx_model::ids::BodyId;
use calyx_model::observed::{Location, Observed};

/// Number of points along a gauge at which stress is evaluated.
const PLACES: usize = 8;

/// Strain gauge in the fillets of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gauge {
    /// Body of the fillets.
    pub body: BodyId,
    /// Location of the gauge's centre: along the profile from the end of the flank towards the
    /// root, and along the axis from mid-face, m. The axial coordinate has no effect in a plane
    /// model.
    pub place: [f64; 2],
    /// Direction in the surface, from the profile (towards the root) to the positive axis, rad.
    pub direction: f64,
    /// Gauge length over which it averages, m; 0 for a point.
    pub length: f64,
    /// Side of the tooth. For [`FilletSide::Both`] and for the loaded flanks of a planet it reads
    /// two fillets and returns the larger value.
    pub side: FilletSide,
    /// Tooth of the gauge; `None` reads all teeth: the loaded teeth and two neighbours on either
    /// side cover the passage of one tooth.
    pub tooth: Option<u32>,
    /// Material of the body, which determines the strain, and the out-of-plane stress of a plane
    /// model.
    pub material: Material,
}

/// Quantity read from a gauge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// Strain along its direction, averaged over its length.
    Strain,
    /// Normal stress along its direction, Pa.
    Stress,
    /// Largest principal stress in the surface, Pa.
    LargestPrincipal,
    /// Smallest principal stress in the surface, Pa.
    SmallestPrincipal,
}

/// Reading of a gauge: the largest value over all teeth, together with the smallest. Over a mesh
/// cycle these bound the time history of each tooth. Without load, all teeth of a body with modes
/// are read; a body without modes reads 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaugeReading(pub Gauge, pub Reading);

impl Observable for GaugeReading {
    fn quantity(&self) -> Quantity {
        let (name, unit) = match self.1 {
            Reading::Strain => ("gauge_strain", "1"),
            Reading::Stress => ("gauge_stress", "Pa"),
            Reading::LargestPrincipal | Reading::SmallestPrincipal => ("gauge_principal_stress", "Pa"),
        };
        match self.0.tooth {
            None => Quantity::repeating(name, unit),
            Some(_) => Quantity::passing(name, unit),
        }
    }

    fn off_middle(&self) -> bool {
        self.0.place[1] != 0.0
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let GaugeReading(gauge, reading) = self;
        let of = Fillets { teeth: gauge.tooth.map_or(Teeth::Near(2), Teeth::One), side: gauge.side };
        let Some(stresses) = stresses(at, gauge.body, of) else { return Observed::number(f64::NAN) };
        let fillets =
            stresses.chunk_by(|a, b| (a.location.tooth, a.surface) == (b.location.tooth, b.surface));
        let read = |fillet: &[RootStress]| {
            let grid = Grid::of(fillet)?;
            let (middle, tooth) =
                (grid.at(gauge.place, |stress| stress.position), fillet.first()?.location.tooth);
            let place = match grid.in_plane() {
                true => at.location(gauge.body, tooth, [middle[0], middle[1]]),
                false => at.solid_location(gauge.body, tooth, middle),
            };
            Some((reading.of(gauge.mean(&grid), gauge), place))
        };
        let mut read: Vec<(f64, Location)> = fillets.filter_map(read).collect();
        read.sort_by(|a, b| a.0.total_cmp(&b.0));
        let least = read.first().map(|(least, _)| *least);
        match read.pop() {
            None => Observed { least: Some(0.0), ..Observed::number(0.0) },
            Some((value, place)) => Observed { value, least, location: Some(place) },
        }
    }

    fn stresses_of(&self) -> Option<BodyId> {
        Some(self.0.body)
    }
}

impl Gauge {
    /// Returns the mean stress components over the gauge on one fillet: along the profile, along
    /// the face and shear, Pa.
    fn mean(&self, grid: &Grid<'_>) -> [f64; 3] {
        let components = |place: [f64; 2]| {
            let [along, across, shear] = grid.at(place, |stress| stress.components);
            match grid.in_plane() {
                // Plane strain: the strain normal to the section vanishes.
                true => [along, self.material.poissons_ratio * along, 0.0],
                false => [along, across, shear],
            }
        };
        if self.length == 0.0 {
            return components(self.place);
        }
        let step = grid.step(self.place, self.direction);
        let mut mean = [0.0; 3];
        for (x, weight) in gauss_legendre(PLACES) {
            let there = [0, 1].map(|axis| self.place[axis] + 0.5 * self.length * x * step[axis]);
            mean.iter_mut().zip(components(there)).for_each(|(sum, part)| *sum += 0.5 * weight * part);
        }
        mean
    }
}

impl Reading {
    /// Evaluates a reading from the stress components along the profile, along the face and shear,
    /// Pa.
    fn of(self, [along, across, shear]: [f64; 3], gauge: &Gauge) -> f64 {
        let (sine, cosine) = gauge.direction.sin_cos();
        let sheared = 2.0 * shear * sine * cosine;
        let stress = along * cosine * cosine + across * sine * sine + sheared;
        let other_loads = along * sine * sine + across * cosine * cosine - sheared;
        let (mean, radius) = (0.5 * (along + across), (0.5 * (along - across)).hypot(shear));
        let Material { youngs_modulus, poissons_ratio, .. } = gauge.material;
        match self {
            Reading::Strain => (stress - poissons_ratio * other_loads) / youngs_modulus,
            Reading::Stress => stress,
            Reading::LargestPrincipal => mean + radius,
            Reading::SmallestPrincipal => mean - radius,
        }
    }
}

/// Grid of points of a fillet at which stress is recovered, along the profile and along the face.
struct Grid<'a> {
    stresses: &'a [RootStress],
    /// Coordinates along the profile and along the axis, ascending, m.
    nodes: [Vec<f64>; 2],
}

impl<'a> Grid<'a> {
    /// Creates the grid; `None` if the points do not form one. Points with the same profile
    /// coordinate must be contiguous.
    fn of(stresses: &'a [RootStress]) -> Option<Self> {
        let [first, _] = stresses.first()?.chart;
        let face: Vec<f64> = stresses
            .iter()
            .take_while(|stress| stress.chart[0] == first)
            .map(|stress| stress.chart[1])
            .collect();
        let profile: Vec<f64> = stresses.iter().step_by(face.len()).map(|stress| stress.chart[0]).collect();
        (profile.len() * face.len() == stresses.len()).then_some(Grid { stresses, nodes: [profile, face] })
    }

    /// Returns whether the grid belongs to a plane model, which has one section.
    fn in_plane(&self) -> bool {
        self.nodes[1].len() == 1
    }

    /// Interpolates values of the points.
    fn at(&self, place: [f64; 2], value: impl Fn(&RootStress) -> [f64; 3]) -> [f64; 3] {
        let [profile, face] = [0, 1].map(|axis| weights(&self.nodes[axis], place[axis]));
        let width = self.nodes[1].len();
        let mut sum = [0.0; 3];
        for (row, a) in profile {
            for &(column, b) in &face {
                let there = value(&self.stresses[row * width + column]);
                sum.iter_mut().zip(there).for_each(|(sum, part)| *sum += a * b * part);
            }
        }
        sum
    }

    /// Returns the derivatives of both coordinates by length in a direction of the surface. A helix
    /// is inclined to the axis and longer than its axial extent.
    fn step(&self, place: [f64; 2], direction: f64) -> [f64; 2] {
        let (sine, cosine) = direction.sin_cos();
        if self.in_plane() {
            return [cosine, 0.0];
        }
        let derivative = |axis: usize| {
            let nodes = &self.nodes[axis];
            let reach = 0.05 * (nodes[nodes.len() - 1] - nodes[0]);
            let other_loads = |step: f64| {
                let mut there = place;
                there[axis] += step;
                self.at(there, |stress| stress.position)
            };
            let (ahead, behind) = (other_loads(reach), other_loads(-reach));
            [0, 1, 2].map(|i| (ahead[i] - behind[i]) / (2.0 * reach))
        };
        let (profile, face) = (derivative(0), derivative(1));
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let length = dot(profile, profile).sqrt();
        let leans = dot(face, profile) / length;
        let across = (dot(face, face) - leans * leans).sqrt();
        [(cosine - leans * sine / across) / length, sine / across]
    }
}

/// Returns the interpolation weights of nodes at `x`: of the cubic through the four nearest, or of
/// a lower degree with fewer.
fn weights(nodes: &[f64], x: f64) -> Vec<(usize, f64)> {
    let count = nodes.len().min(4);
    let after = nodes.partition_point(|node| *node < x);
    let first = after.saturating_sub(count / 2).min(nodes.len() - count);
    let near = first..first + count;
    let weight = |i: usize| {
        let others = near.clone().filter(|j| *j != i);
        others.map(|j| (x - nodes[j]) / (nodes[i] - nodes[j])).product()
    };
    near.clone().map(|i| (i, weight(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_fe::block::{graded, uniform};
    use calyx_fe::solid::{SolidMesh, SolidModel};
    use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, Side};
    use calyx_numerics::interrupt::Interrupt;
    use calyx_structure::solid::test_surface::ScrewedArc;
    use calyx_structure::solid::tests::bodies::{Ring, TEETH};
    use calyx_structure::solid::{
        ElasticSolid, SegmentLoad, SolidSplitOptions, SolidStructure, SolidSurfaceSource, SurfaceStress,
    };
    use calyx_structure::tests::bodies::{COARSE, Divisions, ring_source};
    use calyx_structure::{Chart, MeshSupport};
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    use std::sync::Arc;

    const STEEL: Material = Material::STEEL;
    const RADIUS: f64 = 0.05;
    const TWIST: f64 = 8.0;

    /// Circular fillet with a twist and prescribed stresses.
    fn fillet(twist: f64, components: impl Fn([f64; 2]) -> [f64; 3]) -> Vec<RootStress> {
        let places =
            (0..24).flat_map(|i| (0..13).map(move |j| [1e-4 * f64::from(i), 2e-3 * f64::from(j - 6)]));
        let stress = |[s, z]: [f64; 2]| {
            let (sine, cosine) = (s / RADIUS + twist * z).sin_cos();
            let position = [RADIUS * cosine, RADIUS * sine, z];
            let location =
                Location { body: String::new(), tooth: 0, roll_angle: None, radius: RADIUS, axial: Some(z) };
            let components = components([s, z]);
            RootStress { location, surface: 0, chart: [s, z], position, components, principal: [0.0; 2] }
        };
        places.map(stress).collect()
    }

    /// Converts a recovered stress to the form that observables use.
    fn seen(stress: SurfaceStress) -> RootStress {
        let SurfaceStress { tooth, surface, place: chart, position, components } = stress;
        let location =
            Location { body: String::new(), tooth, roll_angle: None, radius: 0.0, axial: Some(chart[1]) };
        RootStress { location, surface, chart, position, components, principal: stress.principal() }
    }

    fn gauge(direction: f64) -> Gauge {
        let place = [1.13e-3, 2.7e-3];
        let (body, material) = (BodyId(0), STEEL);
        Gauge { body, place, direction, length: 0.0, side: FilletSide::Loaded, tooth: None, material }
    }

    #[test]
    fn cubics_are_found_between_places_and_beyond_them() {
        let cubic = |[s, z]: [f64; 2]| {
            let (s, z) = (1e3 * s, 1e2 * z);
            [1.0 + s - s * s * s, z * z * z + s * z, s * s * z]
        };
        let stresses = fillet(0.0, cubic);
        let grid = Grid::of(&stresses).expect("a grid");
        for place in [[1.13e-3, 2.7e-3], [0.0, -12e-3], [2.32e-3, 12e-3], [-0.4e-4, 0.0]] {
            let (found, exact) = (grid.at(place, |stress| stress.components), cubic(place));
            for part in 0..3 {
                assert!((found[part] - exact[part]).abs() < 1e-11, "{place:?}: {found:?} {exact:?}");
            }
        }
        assert!(Grid::of(&stresses[1..]).is_none());
    }

    #[test]
    fn readings_are_those_of_a_strained_surface() {
        // Tension of 100 MPa at 20 degrees from the profile, and 40 MPa across it.
        let turned = 20.0_f64.to_radians();
        let (sine, cosine) = turned.sin_cos();
        let components = [
            100e6 * cosine * cosine + 40e6 * sine * sine,
            100e6 * sine * sine + 40e6 * cosine * cosine,
            60e6 * sine * cosine,
        ];
        let (young, ratio) = (STEEL.youngs_modulus, STEEL.poissons_ratio);
        for (direction, stress, other_loads) in [(turned, 100e6, 40e6), (turned + FRAC_PI_2, 40e6, 100e6)] {
            let gauge = gauge(direction);
            let read = |reading: Reading| reading.of(components, &gauge);
            assert!((read(Reading::Stress) - stress).abs() < 1e-6);
            assert!((read(Reading::Strain) - (stress - ratio * other_loads) / young).abs() < 1e-15);
            assert!((read(Reading::LargestPrincipal) - 100e6).abs() < 1e-6);
            assert!((read(Reading::SmallestPrincipal) - 40e6).abs() < 1e-6);
        }
    }

    /// A slender clamped bar with a load near its free end: the stress on its side is the bending
    /// moment divided by the section modulus.
    #[test]
    fn a_tooth_like_a_cantilever_is_stressed_by_the_moment_of_its_load() {
        let (height, length, foot) = (10e-3, 100e-3, 60e-3);
        let top = 0.5 * height;
        let line = |from: [f64; 2], to: [f64; 2]| Curve::line(from, to);
        let bar = |from: f64, to: f64| {
            Block::new(
                line([from, -top], [to, -top]),
                line([to, -top], [to, top]),
                line([from, top], [to, top]),
                line([from, -top], [from, top]),
            )
        };
        let towards_end: Vec<f64> = graded(12, 5.0).iter().rev().map(|x| 1.0 - x).collect();
        let mut builder = MeshBuilder::new();
        let held = bar(0.0, foot).divided(uniform(12), uniform(8));
        builder.block(held.named(Side::Left, "foot").named(Side::Top, "side"));
        let pressed = bar(foot, length).divided(towards_end, uniform(8));
        builder.block(pressed.on_profile(Side::Top, "flank", [length - foot, 0.0]));
        let plane = builder.finish(ElementOrder::QUADRATIC).expect("a mesh");
        let stations = [-1.0, 0.0, 1.0].map(|part| part * top);
        let mesh = SolidMesh::swept(&plane, &stations, 3, &|[x, y], z| [x, y, z]).expect("a swept mesh");
        let flank = ScrewedArc {
            rate: 0.0,
            start: [length, top],
            angle: PI,
            curvature: 0.0,
            length: length - foot,
            range: [-top, top],
        };
        let source = SolidSurfaceSource {
            surface: Arc::new(flank),
            faces: "flank".into(),
            edges: [Some(0.0), None],
            stress_faces: Some("side".into()),
            stress_points: [3, 4],
        };
        let structure = ElasticSolid::single(
            &SolidModel::new(mesh, STEEL),
            MeshSupport::Chain("foot"),
            &[source],
            &SolidSplitOptions::default(),
            &Interrupt::never(),
        );
        let structure = structure.expect("a structure");
        let pressed_at = 20e-3;
        let rule = gauss_legendre(8);
        let loads = rule.iter().map(|(x, weight)| SegmentLoad {
            chart: Chart { tooth: 0, surface: 0 },
            segment: [pressed_at, top * x].into(),
            force: 500.0 * weight,
        });
        let stresses: Vec<RootStress> =
            structure.stresses(0, 0, &loads.collect::<Vec<_>>()).into_iter().map(seen).collect();
        let grid = Grid::of(&stresses).expect("a grid");
        for (s, z) in [(23.4e-3, 0.0), (30e-3, 3.1e-3), (36.6e-3, -4.4e-3)] {
            let [x, ..] = grid.at([s, z], |stress| stress.position);
            let stress = 1000.0 * (length - pressed_at - x) * top / (height.powi(4) / 12.0);
            let (young, ratio) = (STEEL.youngs_modulus, STEEL.poissons_ratio);
            for (direction, part, strain) in
                [(0.0, 1.0, 1.0), (FRAC_PI_2, 0.0, -ratio), (FRAC_PI_4, 0.5, 0.5 * (1.0 - ratio))]
            {
                // The load also causes shear; the mean of two gauges inclined to either side
                // eliminates it.
                let read = |reading: Reading| {
                    let leaning = [direction, -direction].map(|direction| {
                        let gauge = Gauge { place: [s, z], length: 3e-3, ..gauge(direction) };
                        reading.of(gauge.mean(&grid), &gauge)
                    });
                    0.5 * (leaning[0] + leaning[1]) / stress
                };
                let found = [read(Reading::Stress), young * read(Reading::Strain)];
                assert!((found[0] - part).abs() < 5e-3, "{x} {z} {direction}: {found:?}");
                assert!((found[1] - strain).abs() < 5e-3, "{x} {z} {direction}: {found:?}");
            }
        }
    }

    #[test]
    fn between_places_gauges_read_what_is_recovered_there() {
        let divisions = Divisions { tooth_root: 8, ..COARSE };
        let ring = Ring { divisions, ratio: 0.3, helix: 0.3, face_width: 1.0, layers: 4, axial_order: 3 };
        let recovered = |places: [usize; 2]| {
            let (model, mut surfaces) = ring.sector();
            surfaces.iter_mut().for_each(|source| source.stress_points = places);
            let options = SolidSplitOptions::default();
            let structure =
                ElasticSolid::ring(&model, &ring_source(TEETH), &surfaces, &options, &Interrupt::never());
            let chart = Chart { tooth: 3, surface: 0 };
            let structure = structure.expect("a ring");
            // Load concentrated at one end of the face.
            let [[_, length], _] = structure.surface(0).range();
            let rule = gauss_legendre(16).into_iter();
            let load = |(z, weight)| SegmentLoad {
                chart,
                segment: [0.6 * length, 0.5 * z].into(),
                force: (1e3 + 3e2 * z) * weight,
            };
            let stresses = structure.stresses(3, 0, &rule.map(load).collect::<Vec<_>>());
            stresses.into_iter().map(seen).collect::<Vec<_>>()
        };
        let (on_grid, between) = (recovered([8, 3]), recovered([5, 2]));
        let grid = Grid::of(&on_grid).expect("a grid");
        let size = between.iter().map(|stress| stress.components[0].abs()).fold(0.0, f64::max);
        for stress in &between {
            let components = grid.at(stress.chart, |stress| stress.components);
            let position = grid.at(stress.chart, |stress| stress.position);
            for part in 0..3 {
                let error = (components[part] - stress.components[part]).abs() / size;
                assert!(error < 0.01, "{:?}: {components:?} {:?}", stress.chart, stress.components);
                assert!(
                    (position[part] - stress.position[part]).abs() < 1e-4,
                    "{position:?} {:?}",
                    stress.position
                );
            }
        }
    }

    #[test]
    fn gauges_run_along_the_surface() {
        // On a helix a step along the axis also has a circumferential part, so across the profile
        // it is longer than its axial part.
        let stresses = fillet(TWIST, |_| [0.0; 3]);
        let grid = Grid::of(&stresses).expect("a grid");
        for direction in [0.0, 0.4, 1.2, -0.7, FRAC_PI_2] {
            let place = [1.13e-3, 2.7e-3];
            let step = grid.step(place, direction);
            let length = 1e-3;
            let at = |part: f64| {
                grid.at([0, 1].map(|axis| place[axis] + part * length * step[axis]), |stress| stress.position)
            };
            let (a, b) = (at(-0.5), at(0.5));
            let apart = [0, 1, 2].map(|i| b[i] - a[i]);
            let found = apart.iter().map(|part| part * part).sum::<f64>().sqrt();
            assert!((found / length - 1.0).abs() < 2e-4, "{direction}: {found}");
            // Unrolled cylinder: the profile is circumferential, the face axial.
            assert!((apart[2] / length - direction.sin()).abs() < 2e-4, "{direction}: {apart:?}");
        }
    }
}
