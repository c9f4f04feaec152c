//! Shafts as solids of revolution: closed forms that the solid contains exactly, the limit of
//! slender beams, and convergence at steps.

use calyx_fe::material::Material;
use calyx_model::fidelity::StructureOptions;
use calyx_model::shaft::{Shaft, ShaftSegment, SolidShaftMesh};
use calyx_numerics::interrupt::Interrupt;
use nalgebra::DMatrix;
use std::f64::consts::PI;

const STEEL: Material = Material { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7850.0 };
const SHEAR_MODULUS: f64 = 206e9 / 2.6;

fn segment(length: f64, diameter: [f64; 2], bore: [f64; 2]) -> ShaftSegment {
    ShaftSegment { length, diameter, bore, stiffness_diameter: None }
}

fn cylinder(length: f64, diameter: f64, bore: f64) -> ShaftSegment {
    segment(length, [diameter; 2], [bore; 2])
}

fn shaft(segments: &[ShaftSegment]) -> Shaft {
    Shaft::new(segments.to_vec(), STEEL).expect("a shaft")
}

fn solid(shaft: &Shaft, stations: &[f64], fineness: usize) -> DMatrix<f64> {
    solid_of(shaft, stations, SolidShaftMesh::cubic(fineness))
}

fn solid_of(shaft: &Shaft, stations: &[f64], mesh: SolidShaftMesh) -> DMatrix<f64> {
    let size = 6 * stations.len();
    let matrix = shaft.solid_stiffness(stations, mesh, &Interrupt::never()).expect("a solid");
    DMatrix::from_row_slice(size, size, &matrix)
}

fn beam(shaft: &Shaft, stations: &[f64]) -> DMatrix<f64> {
    let size = 6 * stations.len();
    DMatrix::from_row_slice(size, size, &shaft.stiffness(stations))
}

/// Motion of the last station per unit force or moment on it, with the first one clamped.
fn flexibility(stiffness: &DMatrix<f64>) -> DMatrix<f64> {
    let n = stiffness.nrows() - 6;
    let all = stiffness.view((6, 6), (n, n)).into_owned().try_inverse().expect("it is clamped");
    all.view((n - 6, n - 6), (6, 6)).into_owned()
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found:e} instead of {expected:e}");
}

#[test]
fn uniform_tension_torsion_and_bending_are_exact() {
    // The elements of the thin tube are long, so rounding is larger.
    for (diameter, bore, length, rounding) in
        [(0.03, 0.0, 0.2, 1e-9), (0.04, 0.025, 0.03, 1e-9), (0.05, 0.048, 0.4, 1e-7)]
    {
        let shaft = shaft(&[cylinder(length, diameter, bore)]);
        let found = flexibility(&solid(&shaft, &[0.0, length], 1));
        let area = 0.25 * PI * (diameter * diameter - bore * bore);
        let inertia = PI / 64.0 * (diameter.powi(4) - bore.powi(4));
        close(found[(2, 2)], length / (206e9 * area), rounding);
        close(found[(5, 5)], length / (SHEAR_MODULUS * 2.0 * inertia), rounding);
        for (rotation, displacement, sign) in [(4, 0, 1.0), (3, 1, -1.0)] {
            close(found[(rotation, rotation)], length / (206e9 * inertia), rounding);
            close(
                found[(displacement, rotation)],
                sign * length * length / (2.0 * 206e9 * inertia),
                rounding,
            );
        }
    }
}

/// Under forces that are uniform over their sections, the deflection by shear grows along the shaft
/// with the shear coefficient of Hutchinson (Journal of Applied Mechanics 68, 2001, 87-92), and the
/// two loaded ends add the same at any length.
#[test]
fn shear_has_the_coefficient_of_hutchinson() {
    for bore in [0.0, 0.01] {
        let nu = 0.3;
        let (a, b) = (0.015_f64.powi(2), (0.5_f64 * bore).powi(2));
        let coefficient = 6.0 * (a + b).powi(2) * (1.0 + nu) * (1.0 + nu)
            / (7.0 * a * a
                + 34.0 * a * b
                + 7.0 * b * b
                + nu * (12.0 * a * a + 48.0 * a * b + 12.0 * b * b)
                + nu * nu * (4.0 * a * a + 16.0 * a * b + 4.0 * b * b));
        let (area, inertia) = (PI * (a - b), 0.25 * PI * (a * a - b * b));
        // Length of shaft whose shear is the addition of the ends, in diameters.
        let ends = [0.1, 0.2, 0.4].map(|length: f64| {
            let shaft = shaft(&[cylinder(length, 0.03, bore)]);
            let found = flexibility(&solid(&shaft, &[0.0, length], 2));
            let bending = length.powi(3) / (3.0 * 206e9 * inertia);
            ((found[(0, 0)] - bending) * SHEAR_MODULUS * area - length / coefficient) / 0.03
        });
        assert!(ends.iter().all(|end| (0.0..0.2).contains(end)), "{ends:?}");
        assert!((ends[1] - ends[0]).abs() < 2e-3 && (ends[2] - ends[0]).abs() < 2e-3, "{ends:?}");
    }
}

#[test]
fn rigid_body_motions_cause_no_forces_and_forces_are_reciprocal() {
    let shaft = shaft(&[
        cylinder(0.03, 0.025, 0.008),
        segment(0.05, [0.03, 0.045], [0.008, 0.02]),
        cylinder(0.02, 0.06, 0.02),
    ]);
    let stations = [0.0, 0.03, 0.07, 0.08, 0.1];
    let stiffness = solid(&shaft, &stations, 1);
    assert_eq!(stiffness, stiffness.transpose());
    for motion in 0..6 {
        let rigid = DMatrix::from_fn(stiffness.nrows(), 1, |row, _| {
            let (station, component) = (stations[row / 6], row % 6);
            match (motion, component) {
                (4, 0) => station,
                (3, 1) => -station,
                (one, other) => f64::from(one == other),
            }
        });
        let forces = &stiffness * &rigid;
        let scale = stiffness.diagonal().map(f64::sqrt).max() * stiffness.diagonal().min().sqrt();
        assert!(forces.amax() < 1e-9 * scale, "{motion}: {forces}");
    }
}

/// A step is softer than two beams: next to it, the outer part of the larger one carries no load.
/// The additional flexibility converges, and vanishes with the step.
#[test]
fn a_step_is_softer_than_two_beams() {
    let stepped = |larger: f64| shaft(&[cylinder(0.1, 0.02, 0.0), cylinder(0.1, larger, 0.0)]);
    let stations = [0.0, 0.2];
    let added = |larger: f64, fineness: usize, component: usize| {
        let shaft = stepped(larger);
        let of = |matrix: DMatrix<f64>| flexibility(&matrix)[(component, component)];
        of(solid(&shaft, &stations, fineness)) - of(beam(&shaft, &stations))
    };
    for component in [2, 3, 5] {
        let [coarse, medium, fine] = [1, 2, 4].map(|fineness| added(0.04, fineness, component));
        assert!(coarse > 0.0 && (medium - fine).abs() < 0.03 * fine && (coarse - fine).abs() < 0.07 * fine);
        assert!(added(0.0201, 1, component) < 0.05 * fine);
    }
    // Parts of the flexibility, as in docs/theory/shafts.md.
    let whole = flexibility(&solid(&stepped(0.04), &stations, 2));
    for (component, part) in [(2, 0.037), (3, 0.035), (5, 0.023)] {
        close(added(0.04, 2, component) / whole[(component, component)], part, 0.02);
    }
}

/// The mesh that estimates of the mesh error compare with shows the error of a step: its factor of
/// 2 on the difference covers the difference from a mesh twice as fine, and is not 6 times too
/// large.
#[test]
fn the_mesh_of_error_estimates_shows_the_error_of_a_step() {
    let other = StructureOptions { order: 2, refinement: 1.5, ..StructureOptions::default() };
    let [own, other] = [StructureOptions::default(), other].map(|options| SolidShaftMesh::of(&options));
    for larger in [0.022, 0.05] {
        let shaft = shaft(&[cylinder(0.05, 0.02, 0.0), cylinder(0.02, larger, 0.0)]);
        let [own, other, fine] = [own, other, SolidShaftMesh::cubic(4)]
            .map(|mesh| flexibility(&solid_of(&shaft, &[0.0, 0.07], mesh)));
        for at in [(2, 2), (3, 3), (5, 5)] {
            let (estimate, error) = (2.0 * (own[at] - other[at]).abs(), (own[at] - fine[at]).abs());
            assert!(estimate > error && estimate < 6.0 * error, "{larger} {at:?}: {estimate:e} {error:e}");
        }
    }
}

/// Forces act at stations, but stations without forces do not change the shaft.
#[test]
fn further_stations_change_nothing() {
    let shaft = shaft(&[cylinder(0.05, 0.02, 0.0), cylinder(0.04, 0.03, 0.0), cylinder(0.05, 0.02, 0.0)]);
    let few = flexibility(&solid(&shaft, &[0.0, 0.14], 1));
    let many = flexibility(&solid(&shaft, &[0.0, 0.02, 0.05, 0.07, 0.14], 1));
    for component in 0..6 {
        close(many[(component, component)], few[(component, component)], 3e-5);
    }
}

#[test]
fn segments_that_do_not_touch_are_refused() {
    let apart = vec![cylinder(0.05, 0.02, 0.0), cylinder(0.04, 0.03, 0.022)];
    let error = Shaft::new(apart, STEEL).expect_err("there is no wall in common");
    assert_eq!(error.code, "E0858");
    let touching = shaft(&[cylinder(0.05, 0.02, 0.0), cylinder(0.04, 0.03, 0.018)]);
    assert!(touching.check_solid(&[0.0, 0.05, 0.09]).is_ok());
    let error = touching.check_solid(&[0.0, 0.0, 0.09]).expect_err("stations coincide");
    assert_eq!(error.code, "E0858");
}

/// Positions that differ by rounding from the ends of segments are those ends.
#[test]
fn stations_at_ends_of_segments_may_be_rounded() {
    let three = shaft(&[cylinder(0.03, 0.02, 0.0), cylinder(0.04, 0.03, 0.0), cylinder(0.23, 0.02, 0.0)]);
    let exact = three.ends().to_vec();
    let rounded: Vec<f64> = exact.iter().map(|end| end * (1.0 - f64::EPSILON)).collect();
    let [one, other] = [exact, rounded].map(|stations| solid(&three, &stations, 1));
    assert!((one.clone() - other).amax() < 1e-9 * one.amax());
}

/// A shaft of 1 mm next to one of 1 m, a thin wall, an invisible step, a thin collar and a steep
/// cone.
#[test]
fn extreme_dimensions_have_a_stiffness() {
    let cases = [
        vec![cylinder(0.01, 0.001, 0.0), cylinder(1.0, 1.0, 0.0)],
        vec![cylinder(0.1, 0.03, 0.02996)],
        vec![cylinder(0.1, 0.03, 0.0), cylinder(0.1, 0.03 + 1e-8, 0.0)],
        vec![cylinder(0.1, 0.03, 0.0), cylinder(1e-5, 0.04, 0.0), cylinder(0.1, 0.03, 0.0)],
        vec![segment(0.05, [0.002, 0.9], [0.0, 0.0]), cylinder(2.0, 0.9, 0.0)],
    ];
    for segments in cases {
        let shaft = shaft(&segments);
        let stiffness = solid(&shaft, shaft.ends(), 1);
        assert!(stiffness.iter().all(|entry| entry.is_finite()), "{segments:?}");
        assert!(stiffness.diagonal().min() > 0.0, "{segments:?}");
    }
}
