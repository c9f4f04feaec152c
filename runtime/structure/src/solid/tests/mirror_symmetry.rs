//! A body condensed by its mirror-symmetric halves is equal to the body condensed whole.

use super::bodies::{Ring, TEETH};
use crate::elastic::OffsetTables;
use crate::solid::mirror_symmetry::MirrorMap;
use crate::solid::{ElasticSolid, SolidSplitOptions};
use crate::tests::bodies::{COARSE, ring_source};
use calyx_fe::solid::SolidModel;
use calyx_numerics::interrupt::Interrupt;
use faer::Mat;

fn ring(layers: usize, helix: f64) -> Ring {
    Ring { divisions: COARSE, ratio: 0.3, helix, face_width: 0.5, layers, axial_order: 2 }
}

fn largest_difference(one: &[Vec<Mat<f64>>], other: &[Vec<Mat<f64>>]) -> f64 {
    let largest =
        |matrix: &Mat<f64>| matrix.col_iter().flat_map(|c| c.iter()).fold(0.0_f64, |a, b| a.max(b.abs()));
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    pairs.map(|(one, other)| largest(&(one - other)) / largest(other)).fold(0.0, f64::max)
}

#[test]
fn halves_are_the_whole() {
    // With and without nodes on the mirror plane.
    for (layers, axial_order) in [(2, 2), (3, 3), (3, 2)] {
        let ring = Ring { axial_order, ..ring(layers, 0.0) };
        let (model, surfaces) = ring.sector();
        let mirrored = MirrorMap::of(&model.mesh);
        assert!(mirrored.is_some());
        let by = |mirrored| {
            ElasticSolid::ring_by(
                mirrored,
                &model,
                &ring_source(TEETH),
                (&surfaces, &SolidSplitOptions::default()),
                &Interrupt::never(),
            )
            .unwrap()
        };
        let (halves, whole) = (by(mirrored.as_ref()), by(None));
        assert_eq!(halves.offsets.len(), whole.offsets.len());
        for (one, other) in halves.offsets.iter().zip(&whole.offsets) {
            let tables = |tables: &OffsetTables, k: usize| match k {
                0 => tables.compliance.clone(),
                1 => tables.stress_ahead.clone(),
                _ => tables.stress_behind.clone(),
            };
            for k in 0..3 {
                let difference = largest_difference(&tables(one, k), &tables(other, k));
                assert!(difference < 1e-9, "{layers} layers, table {k}: {difference:e}");
            }
        }
    }
}

#[test]
fn what_is_no_mirror_image_is_not_taken_for_one() {
    let of = |model: &SolidModel| MirrorMap::of(&model.mesh).is_some();
    assert!(!of(&ring(2, 0.2).sector().0));
    let (mut model, _) = ring(2, 0.0).sector();
    assert!(of(&model));
    // A web at one side.
    let count = model.mesh.elements.len();
    model.mesh = model.mesh.without(|element| element == count - 1);
    assert!(!of(&model));
    model.mesh = model.mesh.without(|element| element == count - 1 || element == count / 2 - 1);
    assert!(of(&model));
}
