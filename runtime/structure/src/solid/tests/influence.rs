//! Tests of exact properties: reciprocity, rotation of the ring, independence of threads, memory.

use super::bodies::{Ring, TEETH};
use crate::Chart;
use crate::elastic::NormalAngle;
use crate::solid::{ElasticSolid, SegmentLoad, SolidSplitOptions, SolidStructure, SurfaceSegment};
use crate::tests::bodies::COARSE;

fn small() -> ElasticSolid {
    let ring = Ring { divisions: COARSE, ratio: 0.3, helix: 0.2, face_width: 0.5, layers: 1, axial_order: 2 };
    ring.structure(&SolidSplitOptions { samples: 8, ..SolidSplitOptions::default() })
}

/// Returns points and stretches within the samples, beyond them and beyond the surface.
fn segments(structure: &ElasticSolid, shares: &[[f64; 2]]) -> Vec<SurfaceSegment> {
    let [[_, length], [_, end]] = structure.surface(0).range();
    let segment = |(index, [u, v]): (usize, &[f64; 2])| SurfaceSegment {
        place: [u * length, v * end],
        length: (index % 2) as f64 * 0.1 * end,
    };
    shares.iter().enumerate().map(segment).collect()
}

fn block(
    structure: &ElasticSolid,
    observe: Chart,
    observers: &[SurfaceSegment],
    load: Chart,
    loads: &[SurfaceSegment],
) -> Vec<f64> {
    let mut block = vec![0.0; observers.len() * loads.len()];
    structure.add_compliance(observe, observers, load, loads, &mut block);
    block
}

#[test]
fn exchanging_load_and_observer_transposes_to_the_bit_and_turning_renumbers() {
    let structure = small();
    let some = segments(&structure, &[[0.9, 0.1], [0.1, -0.9], [0.33, 1.1], [0.999, 0.4], [0.5, 0.0]]);
    let others = segments(&structure, &[[0.2, 0.5], [0.77, -0.3], [0.5, 0.0], [1.01, -1.0]]);
    let charts = || (0..TEETH).flat_map(|tooth| [0, 1].map(|surface| Chart { tooth, surface }));
    for a in charts() {
        for b in charts() {
            for (observers, loads) in [(&some, &others), (&some, &some)] {
                let there = block(&structure, a, observers, b, loads);
                let back = block(&structure, b, loads, a, observers);
                for (i, row) in there.chunks_exact(loads.len()).enumerate() {
                    for (j, value) in row.iter().enumerate() {
                        let exchanged = back[j * observers.len() + i];
                        assert_eq!(value.to_bits(), exchanged.to_bits(), "{a:?} {b:?} {i} {j}");
                    }
                }
            }
        }
    }
    let chart = |tooth: u32, surface| Chart { tooth: tooth % TEETH, surface };
    for (from, to) in [(0, 1), (1, 0), (0, 2), (2, 0), (3, 3)] {
        let turned = |by: u32| block(&structure, chart(from + by, 0), &some, chart(to + by, 1), &others);
        assert_eq!(turned(0), turned(4));
        let load = |by: u32| SegmentLoad { chart: chart(from + by, 0), segment: some[0], force: 3.0 };
        let principal = |by: u32| {
            let stresses = structure.stresses((to + by) % TEETH, 0, &[load(by)]);
            stresses.into_iter().map(|stress| stress.principal()).collect::<Vec<_>>()
        };
        assert_eq!(principal(0), principal(4));
        assert!(!principal(0).is_empty());
    }
}

#[test]
fn stresses_add_up() {
    let structure = small();
    let place = segments(&structure, &[[0.6, 0.2], [0.4, -0.5]]);
    let chart = |tooth| Chart { tooth, surface: 0 };
    let load = |tooth, place, force| SegmentLoad { chart: chart(tooth), segment: place, force };
    let at = |loads: &[SegmentLoad]| structure.stresses(1, 1, loads);
    let twice = at(&[load(1, place[0], 1.0), load(0, place[1], 2.0), load(1, place[0], 1.0)]);
    let once = at(&[load(1, place[0], 2.0), load(0, place[1], 2.0)]);
    for (a, b) in twice.iter().zip(&once) {
        assert!((a.principal()[0] - b.principal()[0]).abs() < 1e-9 * a.principal()[0].abs().max(1.0));
        assert!(a.principal()[0] >= a.principal()[1]);
    }
    assert!(at(&[]).iter().all(|stress| stress.principal() == [0.0; 2]));
}

#[test]
fn the_number_of_threads_changes_no_bit_and_memory_is_told() {
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let structure = pool.install(small);
        let some = segments(&structure, &[[0.9, 0.1], [0.1, -0.9], [0.3, 0.3]]);
        let [observe, load] = [3, 2].map(|tooth| Chart { tooth, surface: 1 });
        let mut all = block(&structure, observe, &some, load, &some);
        all.extend(block(&structure, load, &some, load, &some));
        (all.into_iter().map(f64::to_bits).collect::<Vec<_>>(), structure.bytes())
    };
    let (one, three) = (of(1), of(3));
    assert_eq!(one, three);
    // Tables of samples and polynomials, independent of the mesh: (8 * 3)² for each pair of
    // surfaces of four offsets, and stress rows ahead and behind, which are identical for a sector
    // with itself.
    let loads = 8 * 3;
    let compliance = 4 * (2 * loads) * (2 * loads);
    // Three components at two points on each of three edges, at both ends of the layer and in its
    // middle.
    let rows = 3 * (2 * 3) * 3;
    let stress = (4 * 2 - 1) * (2 * rows) * (2 * loads);
    let expected = (compliance + stress) * size_of::<f64>();
    assert!(one.1 >= expected && one.1 < expected + expected / 4, "{} against {expected}", one.1);
}

/// Terms of several points at a time are those of single ones, also where points coincide.
#[test]
fn curvature_terms_are_those_of_single_points() {
    let structure = small();
    let surface = &structure.surfaces[0];
    let [from, to] = surface.range;
    let angles: Vec<NormalAngle> =
        (0..11).map(|k| surface.normal_angle_at(from + (to - from) * f64::from(k) / 10.0)).collect();
    for own in &angles {
        for count in 1..=angles.len() {
            let mut terms = vec![f64::NAN; count];
            structure.curvature_terms(surface, *own, &angles[..count], &mut terms);
            for (term, other) in terms.iter().zip(&angles) {
                let expected = structure.curvature_term(surface, *own, *other);
                assert!(
                    (term - expected).abs() <= 1e-14 * expected.abs().max(1e-20),
                    "{term:e} {expected:e}"
                );
            }
        }
    }
}
