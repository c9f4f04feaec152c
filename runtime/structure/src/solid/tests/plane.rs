//! With Poisson's ratio 0, a load that is uniform along the face causes no axial stress: the body
//! is equivalent to the plane model.

use super::bodies::{Ring, TEETH};
use crate::kernel::{Mollifier, PairQuadrature};
use crate::solid::half_space::ReciprocalMeans;
use crate::solid::screw::Screw;
use crate::solid::{ElasticSolid, SegmentLoad, SolidSplitOptions, SolidStructure, SurfaceSegment};
use crate::tests::bodies::{COARSE, Divisions, ring_source, toothed_sector};
use crate::{Chart, ElasticStructure, SplitOptions, Structure};
use calyx_fe::PlaneModel;
use calyx_fe::material::{Material, Plane};
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::quadrature::gauss_legendre;
use std::f64::consts::PI;

fn points(strip: &Mollifier) -> Vec<(f64, f64)> {
    let rule = gauss_legendre(8).into_iter();
    rule.map(|(x, weight)| {
        let s = strip.center + strip.width * x;
        (s, weight * strip.width * strip.value(s))
    })
    .collect()
}

/// Returns the mean compliance between strips in the plane model.
fn in_the_plane(
    structure: &ElasticStructure,
    observed: (Chart, &Mollifier),
    loaded: (Chart, &Mollifier),
) -> f64 {
    let (rows, columns) = (points(observed.1), points(loaded.1));
    let s = |points: &[(f64, f64)]| points.iter().map(|point| point.0).collect::<Vec<_>>();
    let mut block = vec![0.0; rows.len() * columns.len()];
    structure.add_compliance(observed.0, &s(&rows), loaded.0, &s(&columns), &mut block);
    let mut mean = 0.0;
    for (i, row) in rows.iter().enumerate() {
        for (j, column) in columns.iter().enumerate() {
            mean += row.1 * column.1 * block[i * columns.len() + j];
        }
    }
    if observed.0 == loaded.0 {
        let logarithm = PairQuadrature::default().logarithm(observed.1, loaded.1);
        mean -= 2.0 / (PI * structure.surface_modulus()) * (logarithm - structure.reference_length().ln());
    }
    mean
}

/// Returns points of a strip that is uniform along the face, with their shares.
fn spread(structure: &ElasticSolid, strip: &Mollifier) -> Vec<([f64; 2], f64)> {
    let modes = &structure.modes;
    let along = modes.quadrature(modes.range(), 0);
    let at = |(s, weight): (f64, f64)| {
        let part = move |&(v, part): &(f64, f64)| ([s, v], weight * part / modes.length().sqrt());
        along.iter().map(part).collect::<Vec<_>>()
    };
    points(strip).into_iter().flat_map(at).collect()
}

/// Returns the mean compliance in the three-dimensional model, for loads and observers that are
/// uniform along the face.
fn three_dimensional(
    structure: &ElasticSolid,
    observed: (Chart, &Mollifier),
    loaded: (Chart, &Mollifier),
) -> f64 {
    let modes = &structure.modes;
    let (rows, columns) = (spread(structure, observed.1), spread(structure, loaded.1));
    let places = |points: &[([f64; 2], f64)]| {
        points.iter().map(|point| SurfaceSegment::from(point.0)).collect::<Vec<_>>()
    };
    let mut block = vec![0.0; rows.len() * columns.len()];
    structure.add_compliance(observed.0, &places(&rows), loaded.0, &places(&columns), &mut block);
    let mut mean = 0.0;
    for (i, row) in rows.iter().enumerate() {
        for (j, column) in columns.iter().enumerate() {
            mean += row.1 * column.1 * block[i * columns.len() + j];
        }
    }
    if observed.0 == loaded.0 {
        let surface = structure.surface(observed.0.surface);
        let screw = Screw::of(surface.as_ref(), surface.range()[0]).unwrap();
        let means = ReciprocalMeans::new(screw, modes, [true; 2], observed.1.width.min(loaded.1.width));
        mean += means.between(observed.1, loaded.1)[(0, 0)] / (PI * structure.surface_modulus());
    }
    mean
}

fn ring(divisions: Divisions, ratio: f64) -> Ring {
    Ring { divisions, ratio, helix: 0.0, face_width: 1.5, layers: 3, axial_order: 2 }
}

fn plane(divisions: Divisions, ratio: f64) -> ElasticStructure {
    let (model, surfaces) = toothed_sector(TEETH, 1.0, divisions);
    let model =
        PlaneModel::new(model.mesh, Material { poissons_ratio: ratio, ..model.material }, Plane::Strain);
    ElasticStructure::ring(
        &model,
        &ring_source(TEETH),
        &surfaces,
        &SplitOptions::default(),
        &Interrupt::never(),
    )
    .unwrap()
}

fn strips(length: f64) -> Vec<(u32, Mollifier)> {
    [(0, 0.2, 0.06), (0, 0.5, 0.03), (0, 0.53, 0.04), (0, 0.8, 0.03), (0, 0.92, 0.015), (1, 0.5, 0.03)]
        .map(|(surface, share, width)| {
            (surface, Mollifier::new(share * length, share * length, width * length))
        })
        .to_vec()
}

#[test]
fn uniform_loads_meet_the_compliance_of_the_plane() {
    let (plane, solid) = (plane(COARSE, 0.0), ring(COARSE, 0.0).structure(&SolidSplitOptions::default()));
    let strips = strips(plane.reference_length());
    let mut worst = 0.0_f64;
    for offset in 0..=2 {
        for (surface, observed) in &strips {
            for (other, loaded) in &strips {
                let observe = (Chart { tooth: 4 + offset, surface: *surface }, observed);
                let load = (Chart { tooth: 4, surface: *other }, loaded);
                let (flat, spatial) =
                    (in_the_plane(&plane, observe, load), three_dimensional(&solid, observe, load));
                let own = |chart: Chart, strip| in_the_plane(&plane, (chart, strip), (chart, strip));
                let scale = (own(observe.0, observed) * own(load.0, loaded)).sqrt();
                worst = worst.max((spatial - flat).abs() / scale);
            }
        }
    }
    // The narrowest strip, next to the tip, lies between samples.
    assert!(worst < 1.5e-3, "{worst:.1e}");
}

#[test]
fn matching_depth_hardly_matters() {
    let ring = ring(Divisions { flank: 14, thickness: 12, ..COARSE }, 0.3);
    let values = |depth: f64| {
        let structure =
            ring.structure(&SolidSplitOptions { matching_depth: depth, ..SolidSplitOptions::default() });
        let chart = Chart { tooth: 0, surface: 0 };
        let strips = strips(structure.surface(0).range()[0][1]);
        let compliance =
            [1, 3].map(|k| three_dimensional(&structure, (chart, &strips[k].1), (chart, &strips[k].1)));
        let loads: Vec<SegmentLoad> = spread(&structure, &strips[3].1)
            .into_iter()
            .map(|(place, force)| SegmentLoad { chart, segment: place.into(), force })
            .collect();
        let stresses = structure.stresses(0, 0, &loads).into_iter();
        let stress = stresses.map(|stress| stress.principal()[0]).fold(0.0, f64::max);
        [compliance[0], compliance[1], stress]
    };
    let reference = values(1.0);
    for depth in [0.7, 1.4] {
        let changes: Vec<f64> = values(depth)
            .iter()
            .zip(&reference)
            .map(|(value, reference)| (value / reference - 1.0).abs())
            .collect();
        assert!(changes[0] < 5e-3 && changes[1] < 5e-3 && changes[2] < 2e-3, "{depth}: {changes:?}");
    }
}
