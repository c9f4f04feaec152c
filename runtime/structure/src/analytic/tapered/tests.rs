//! Teeth of constant section against [`AnalyticSolid`]. Conical teeth have tests with their gears.

use super::super::tests::Slab;
use super::super::{AnalyticSolid, CriticalSection, RingShape, ToothShape};
use super::*;
use crate::profile::Profile;

const WIDTH: f64 = 6e-3;
const FLANK: Chart = Chart { tooth: 2, surface: 0 };

/// Side of a slab, constant along a face.
struct Wall(Slab);

impl Surface for Wall {
    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.0.length], [-0.5 * WIDTH, 0.5 * WIDTH]]
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let on = self.0.at(u);
        let ([x, y], [nx, ny], [tx, ty]) = (on.position, on.normal, on.tangent);
        SurfacePoint {
            position: [x, y, v],
            tangents: [[tx, ty, 0.0], [0.0, 0.0, 1.0]],
            normal: [nx, ny, 0.0],
        }
    }
}

impl SectionedSurface for Wall {
    fn in_section(&self, u: f64, v: f64) -> SectionPoint {
        let point = self.at(u, v);
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        SectionPoint { point, place: [point.position[0], point.position[1]], axes }
    }

    fn as_surface(self: Arc<Self>) -> Arc<dyn Surface> {
        self
    }
}

const CRITICAL: CriticalSection =
    CriticalSection { at: 0.1e-3, chord: 0.6e-3, notch_radius: 0.1e-3, s: 0.0, position: [0.0; 2] };

fn bodies(sections: usize) -> [Box<dyn SolidStructure>; 2] {
    let ring = RingShape { radius: 10e-3, fixed_radius: 8e-3, half_arc: 0.05, lean: 1.0, sectors: 20 };
    let wall = |side| Wall(Slab { from: ring.root(), length: 1e-3, half: 0.3e-3, side });
    let depths: Vec<[f64; 2]> = (0..=10).map(|k| [0.1e-3 * f64::from(k), 0.3e-3]).collect();
    let section = Some(CRITICAL);
    let shape = ToothShape { sense: 1.0, depths: depths.clone(), ring, section };
    let walls = [1.0, -1.0].map(|side| Arc::new(wall(side)) as Arc<dyn Surface>);
    let constant = AnalyticSolid::new(walls.to_vec(), &shape, [WIDTH, 0.0], Material::STEEL);
    let station = RootStation { section: CRITICAL, place: [0.0; 2], position: [0.0; 3] };
    let of = ToothSection {
        root: [ring.root(), 0.0],
        radial: 0.0,
        tilt: 0.0,
        rise: 0.0,
        depths,
        ring,
        critical: Some([station; 2]),
    };
    let walls = [1.0, -1.0].map(|side| Arc::new(wall(side)) as Arc<dyn SectionedSurface>);
    let tapered = TaperedSolid::new(walls, &vec![of; sections], 1.0, Material::STEEL);
    [Box::new(constant), Box::new(tapered)]
}

fn slices(s: f64) -> Vec<SurfaceSegment> {
    let ends = [-0.5, -0.45, -0.3, -0.25, 0.0, 0.1, 0.3, 0.42, 0.5];
    let slice = |pair: &[f64]| SurfaceSegment {
        place: [s, 0.5 * (pair[0] + pair[1]) * WIDTH],
        length: (pair[1] - pair[0]) * WIDTH,
    };
    ends.windows(2).map(slice).collect()
}

#[test]
fn teeth_of_constant_section_are_those_of_the_model_of_spur_teeth() {
    let [constant, tapered] = bodies(5);
    let charts = [
        FLANK,
        Chart { surface: 1, ..FLANK },
        Chart { tooth: 3, surface: 0 },
        Chart { tooth: 1, surface: 1 },
    ];
    for chart in charts {
        let (observers, loads) = (slices(0.4e-3), slices(0.85e-3));
        let block = |body: &dyn SolidStructure| {
            let mut block = vec![0.0; observers.len() * loads.len()];
            body.add_compliance(FLANK, &observers, chart, &loads, &mut block);
            block
        };
        let (exact, found) = (block(constant.as_ref()), block(tapered.as_ref()));
        let largest = exact.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for (exact, found) in exact.iter().zip(&found) {
            assert!(
                (exact - found).abs() < 1e-3 * exact.abs() + 1e-4 * largest,
                "{chart:?}: {found} {exact}"
            );
        }
    }
    let load = |segment| SegmentLoad { chart: FLANK, segment, force: 10.0 };
    let loads: Vec<SegmentLoad> = slices(0.85e-3).into_iter().take(3).map(load).collect();
    let [[first, last], [found, end]] = [&constant, &tapered].map(|body| {
        let stresses = body.stresses(2, 0, &loads);
        [stresses[0].components[0], stresses[stresses.len() - 1].components[0]]
    });
    assert!(first > 1e6 && (found / first - 1.0).abs() < 1e-3, "{found} {first}");
    assert!((end - last).abs() < 1e-3 * first, "{end} {last}");
}

#[test]
fn it_is_reciprocal_to_the_bit() {
    let [_, body] = bodies(4);
    let segments: Vec<SurfaceSegment> = [0.3e-3, 0.32e-3, 0.9e-3].into_iter().flat_map(slices).collect();
    let turned: Vec<SurfaceSegment> = segments.iter().rev().copied().collect();
    let count = segments.len();
    for other in [FLANK, Chart { tooth: 3, surface: 1 }, Chart { surface: 1, ..FLANK }] {
        let mut there = vec![0.0; count * count];
        let mut back = there.clone();
        body.add_compliance(FLANK, &segments, other, &turned, &mut there);
        body.add_compliance(other, &turned, FLANK, &segments, &mut back);
        for i in 0..count {
            for j in 0..count {
                assert_eq!(
                    there[i * count + j].to_bits(),
                    back[j * count + i].to_bits(),
                    "{other:?} {i} {j}"
                );
            }
        }
    }
    let mut own = vec![0.0; count * count];
    body.add_compliance(FLANK, &segments, FLANK, &segments, &mut own);
    for (row, segment) in own.chunks(count).zip(&segments) {
        let mut single = vec![0.0; count];
        body.add_compliance(FLANK, &[*segment], FLANK, &segments, &mut single);
        assert_eq!(row, single);
    }
}

/// Slices of teeth whose sections differ, on both flanks of several teeth, have no negative strain
/// energy.
#[test]
fn slices_of_different_sections_are_positive() {
    let ring = |k: f64| RingShape {
        radius: 10e-3 + 1e-3 * k,
        fixed_radius: 8e-3 - 0.5e-3 * k,
        half_arc: 0.05 + 0.005 * k,
        lean: 1.0f64.hypot(0.2 + 0.1 * k).recip(),
        sectors: 20,
    };
    let section = |k: f64| {
        let ring = ring(k);
        let height = 1e-3 + 0.2e-3 * k;
        ToothSection {
            root: [9.99e-3, 0.02e-3 * k],
            radial: 0.01 * k,
            tilt: -0.05 * k,
            rise: 0.2 + 0.1 * k,
            depths: vec![[0.0, 0.4e-3 + 0.05e-3 * k * k], [height, 0.2e-3]],
            ring,
            critical: None,
        }
    };
    let wall = |side| Wall(Slab { from: 10e-3, length: 1e-3, half: 0.3e-3, side });
    let walls = [1.0, -1.0].map(|side| Arc::new(wall(side)) as Arc<dyn SectionedSurface>);
    let body = TaperedSolid::new(walls, &[0.0, 1.0, 2.0].map(section), 0.7, Material::STEEL);
    let mut places = Vec::new();
    for tooth in 0..3 {
        for surface in 0..2 {
            let segments: Vec<SurfaceSegment> =
                [0.2e-3, 0.5e-3, 0.9e-3].into_iter().flat_map(slices).collect();
            let chart = Chart { tooth, surface };
            places.extend(body.places(chart, &segments).into_iter().map(|place| (chart, place)));
        }
    }
    let compliance = |(one, first): &(Chart, Place), (other, second): &(Chart, Place)| {
        let relation = body.rings.relation(one.tooth, other.tooth);
        let moved = |place| body.moved(relation, std::slice::from_ref(place));
        let ring = RingBlock { relation, observers: moved(first), loads: moved(second) };
        let beam = if one.tooth == other.tooth { TaperedSolid::between(first, second) } else { 0.0 };
        (ring.compliance((0, first), (0, second)) + beam) * FaceCoupling::mean(&first.along, &second.along)
    };
    let matrix =
        nalgebra::DMatrix::from_fn(places.len(), places.len(), |i, j| compliance(&places[i], &places[j]));
    assert!(matrix == matrix.transpose());
    let least = matrix.clone().symmetric_eigenvalues().min();
    assert!(least > -1e-10 * matrix.amax(), "{least} {}", matrix.amax());
}
