//! Teeth too far apart for tables of their own are coupled as by tables.

use super::bodies::{Ring, TEETH};
use crate::solid::{ElasticSolid, SegmentLoad, SolidSplitOptions, SolidStructure, SurfaceSegment};
use crate::tests::bodies::{COARSE, ring_source};
use crate::{BoreSupport, Chart, RingSource};
use calyx_numerics::interrupt::Interrupt;

const FREE: BoreSupport = BoreSupport::Means { harmonics: None, degree: 0 };

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// Compares a ring with tables of neighbours only to one with tables of all pairs: compliances
/// relative to those of neighbours, and stresses relative to those of the loaded tooth.
fn agree(support: BoreSupport, helix: f64) {
    let ring = Ring { divisions: COARSE, ratio: 0.3, helix, face_width: 0.5, layers: 2, axial_order: 2 };
    let (model, surfaces) = ring.sector();
    let options = SolidSplitOptions { samples: 8, ..SolidSplitOptions::default() };
    let build = |coupled| {
        let source = RingSource { support, coupled, ..ring_source(TEETH) };
        ElasticSolid::ring(&model, &source, &surfaces, &options, &Interrupt::never()).unwrap()
    };
    let (all, near) = (build(TEETH), build(1));
    assert!(all.far.is_none() && near.far.is_some());
    let restored = {
        let surfaces = surfaces.iter().map(|source| source.surface.clone()).collect();
        ElasticSolid::restored(&near.stored().unwrap(), surfaces).unwrap()
    };
    let [[_, length], [start, end]] = all.surface(0).range();
    let places = [[0.2, 0.1], [0.6, 0.5], [0.9, 0.8]];
    let segments =
        places.map(|[u, v]| SurfaceSegment { place: [u * length, start + v * (end - start)], length: 0.0 });
    let block = |structure: &ElasticSolid, a: Chart, b: Chart| {
        let mut block = vec![0.0; 9];
        structure.add_compliance(a, &segments, b, &segments, &mut block);
        block
    };
    let at = |tooth, surface| Chart { tooth, surface };
    let scale = largest(&block(&all, at(1, 0), at(0, 0)));
    let components = |structure: &ElasticSolid, tooth: u32, loads: &[SegmentLoad]| -> Vec<f64> {
        structure.stresses(tooth, 0, loads).iter().flat_map(|stress| stress.components).collect()
    };
    let mut felt = 0.0_f64;
    for (a, b) in [(2, 0), (0, 3), (5, 0), (6, 0), (1, 7), (2, 10)] {
        for (side, other) in [(0, 0), (0, 1), (1, 0)] {
            let (a, b) = (at(a, side), at(b, other));
            let (exact, found) = (block(&all, a, b), block(&near, a, b));
            felt = felt.max(largest(&exact));
            assert_eq!(found, block(&restored, a, b));
            for (exact, found) in exact.iter().zip(&found) {
                let error = (exact - found).abs() / scale;
                assert!(error < 1e-7, "{support:?}, {a:?} {b:?}: {exact:e} {found:e} ({error:.1e})");
            }
            let load = [SegmentLoad { chart: b, segment: segments[1], force: 1.0 }];
            let most = largest(&components(&all, b.tooth, &load));
            let [exact, found] = [&all, &near].map(|structure| components(structure, a.tooth, &load));
            for (exact, found) in exact.iter().zip(&found) {
                let error = (exact - found).abs() / most;
                assert!(error < 1e-7, "{support:?}, {a:?} {b:?}: {exact:e} {found:e} ({error:.1e})");
            }
        }
    }
    let share = if support == FREE { 0.05 } else { 1e-3 };
    assert!(felt > share * scale, "{felt:e} of {scale:e}");
}

/// Spur rings on a rigid bore are condensed by halves.
#[test]
fn distant_teeth_of_solid_rings_are_coupled_as_by_tables() {
    agree(BoreSupport::Rigid, 0.0);
    agree(BoreSupport::Rigid, 0.2);
    agree(FREE, 0.2);
    agree(BoreSupport::Raceway { harmonics: 6, degree: 1 }, 0.0);
}
