//! Tests of the modes as contact, frame and stress recovery use them.

use super::{Annulus, THIN};
use crate::profile::Profile;
use crate::tests::annulus::STEEL;
use crate::tests::bodies::{COARSE, ring_source, toothed_sector};
use crate::{
    BodyModes, BoreSupport, Chart, ElasticStructure, ModifiedSurface, RingSource, SplineTeeth, SplitOptions,
    Structure, SurfaceLoad,
};
use calyx_numerics::dense::product;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, Side};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

const TEETH: u32 = 9;

fn modes_of(ring: Annulus, support: BoreSupport, highest: f64) -> BodyModes {
    let source = RingSource { support, ..ring_source(ring.sectors) };
    let options = SplitOptions::default();
    BodyModes::ring(&ring.sector(), &source, &[], &options, highest, &Interrupt::never()).unwrap()
}

fn toothed(highest: f64) -> (ElasticStructure, BodyModes) {
    let (model, surfaces) = toothed_sector(TEETH, 1.0, COARSE);
    let (source, options, never) = (ring_source(TEETH), SplitOptions::default(), Interrupt::never());
    let structure = ElasticStructure::ring(&model, &source, &surfaces, &options, &never).unwrap();
    let modes = BodyModes::ring(&model, &source, &surfaces, &options, highest, &never).unwrap();
    (structure, modes)
}

fn eigenvalues(matrix: &Mat<f64>) -> Vec<f64> {
    matrix.self_adjoint_eigenvalues(Side::Lower).unwrap()
}

/// Returns the mass matrix of the motions of the frame and the modes.
fn whole_mass(modes: &BodyModes) -> Mat<f64> {
    let count = modes.count();
    Mat::from_fn(3 + count, 3 + count, |row, column| match (row.checked_sub(3), column.checked_sub(3)) {
        (None, None) => modes.rigid_mass[row][column],
        (Some(mode), None) => modes.coupling[mode][column],
        (None, Some(mode)) => modes.coupling[mode][row],
        (Some(a), Some(b)) => f64::from(u8::from(a == b)),
    })
}

#[test]
fn a_ring_weighs_what_its_section_does() {
    let ring = Annulus { radii: [0.5, 1.0], elements: [2, 2], ..THIN };
    let modes = modes_of(ring, BoreSupport::Rigid, 1.0);
    let mass = STEEL.density * PI * (1.0 - 0.25);
    let polar = 0.5 * STEEL.density * PI * (1.0 - 0.0625);
    let expected = [[mass, 0.0, 0.0], [0.0, mass, 0.0], [0.0, 0.0, polar]];
    for (row, expected) in modes.rigid_mass.iter().zip(expected) {
        for (value, expected) in row.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-6 * mass, "{value} {expected}");
        }
    }
}

#[test]
fn the_mass_matrix_is_definite_and_modes_take_up_the_mass() {
    for support in [BoreSupport::Rigid, BoreSupport::Means { harmonics: None, degree: 0 }] {
        let ring = Annulus { radii: [0.5, 1.0], elements: [3, 2], ..THIN };
        let left = |highest: f64| {
            let modes = modes_of(ring, support, highest);
            let smallest = eigenvalues(&whole_mass(&modes))[0];
            assert!(smallest > 0.0, "{support:?}: {smallest}");
            // Share of the mass in each direction that no mode represents.
            [0, 1, 2].map(|motion| {
                let moved: f64 = modes.coupling.iter().map(|coupling| coupling[motion].powi(2)).sum();
                1.0 - moved / modes.rigid_mass[motion][motion]
            })
        };
        let (few, many) = (left(20_000.0), left(200_000.0));
        assert!((few[0] - few[1]).abs() < 1e-9, "one direction is as good as another: {few:?}");
        assert!(few.iter().zip(&many).all(|(few, many)| many < few), "{few:?} {many:?}");
        if support == BoreSupport::Rigid {
            assert!(
                few.iter().all(|&left| left < 0.3) && many.iter().all(|&left| left < 0.05),
                "{few:?} {many:?}"
            );
        }
    }
}

/// The sum of all modes represents a motion of the frame away from the bore, which checks that the
/// sign of modes in contact is that of their coupling.
#[test]
fn modes_make_up_the_motions_of_the_frame() {
    let (structure, modes) = toothed(150_000.0);
    let profile = structure.profile(0);
    let s = [0.4, 0.6].map(|part| part * profile.length());
    for tooth in [0, 2] {
        let seen = modes.displacements(Chart { tooth, surface: 0 }, &s);
        let (sin, cos) = structure.tooth_angle(tooth).sin_cos();
        for (row, &s) in s.iter().enumerate() {
            let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
            let (point, [nx, ny]) = (turned(profile.at(s).position), turned(profile.at(s).normal));
            // Inward displacement.
            let expected = [-nx, -ny, nx * point[1] - ny * point[0]];
            for (motion, expected) in expected.into_iter().enumerate() {
                let coupling = modes.coupling.iter().zip(seen.row(row).iter());
                let sum: f64 = coupling.map(|(coupling, seen)| coupling[motion] * seen).sum();
                assert!((sum - expected).abs() < 0.1, "tooth {tooth}, motion {motion}: {sum} {expected}");
            }
        }
    }
}

#[test]
fn coupling_turns_with_the_ring() {
    let plain =
        modes_of(Annulus { radii: [0.5, 1.0], elements: [2, 2], ..THIN }, BoreSupport::Rigid, 20_000.0);
    let angle = TAU / 7.0;
    let turned = Annulus { radii: [0.5, 1.0], elements: [2, 2], turned: angle, ..THIN };
    let turned = modes_of(turned, BoreSupport::Rigid, 20_000.0);
    // The total coupling of all modes with a direction is the same for every direction.
    let along = |modes: &BodyModes, angle: f64| -> f64 {
        modes.coupling.iter().map(|c| (c[0] * angle.cos() + c[1] * angle.sin()).powi(2)).sum()
    };
    let expected = along(&plain, 0.0);
    assert!(expected > 0.5 * plain.rigid_mass[0][0]);
    for angle in [0.0, 1.0, 2.0] {
        assert!((along(&plain, angle) / expected - 1.0).abs() < 1e-9);
        assert!((along(&turned, angle) / expected - 1.0).abs() < 1e-9);
    }
}

/// With `n` nodal diameters an inextensible ring has the displacements `cos n phi` outwards and
/// `-sin(n phi)/n` around.
#[test]
fn a_spinning_thin_ring_is_gyroscopic_as_theory_has_it() {
    let modes = modes_of(THIN, BoreSupport::Means { harmonics: None, degree: 0 }, 1500.0);
    let gyroscopic = &modes.gyroscopic;
    assert!(modes.count() >= 8);
    for row in 0..modes.count() {
        for column in 0..modes.count() {
            assert!(gyroscopic[(row, column)] == -gyroscopic[(column, row)]);
            let n = 2.0 + (row / 2) as f64;
            let pair = row / 2 == column / 2 && row != column;
            let expected = if pair { 2.0 * n / (n * n + 1.0) } else { 0.0 };
            let value = gyroscopic[(row, column)].abs();
            assert!((value - expected).abs() < 2e-3, "{row} {column}: {value} {expected}");
        }
    }
}

/// A rotating thin ring expands by `rho omega² R³/E`.
#[test]
fn a_spinning_thin_ring_grows_as_theory_has_it() {
    let modes = modes_of(THIN, BoreSupport::Means { harmonics: None, degree: 0 }, 6000.0);
    let grown: f64 =
        modes.centrifugal.iter().zip(&modes.frequencies).map(|(c, omega)| (c / omega).powi(2)).sum();
    let expected = modes.rigid_mass[0][0] * STEEL.density / STEEL.youngs_modulus;
    assert!((grown / expected - 1.0).abs() < 1e-3, "{grown} {expected}");
}

/// Returns the compliance of cells on flanks of two teeth, and the displacements of modes there.
fn cells(structure: &ElasticStructure, modes: &BodyModes) -> (Mat<f64>, Mat<f64>) {
    let charts: Vec<Chart> =
        (0..2).flat_map(|tooth| (0..2).map(move |surface| Chart { tooth, surface })).collect();
    let length = structure.profile(0).length();
    let s: Vec<f64> = (0..6).map(|k| length * (0.2 + 0.1 * f64::from(k))).collect();
    let half = 0.05 * length;
    let size = charts.len() * s.len();
    let factor = -2.0 / (PI * structure.surface_modulus());
    let (mut compliance, mut shapes) = (Mat::zeros(size, size), Mat::zeros(size, modes.count()));
    for (a, &observe) in charts.iter().enumerate() {
        let seen = modes.displacements(observe, &s);
        shapes.as_mut().subrows_mut(a * s.len(), s.len()).copy_from(&seen);
        for (b, &load) in charts.iter().enumerate() {
            let mut block = vec![0.0; s.len() * s.len()];
            structure.add_compliance(observe, &s, load, &s, &mut block);
            for (row, &x) in s.iter().enumerate() {
                for (column, &y) in s.iter().enumerate() {
                    let near = if a != b {
                        0.0
                    } else if row == column {
                        factor * ((2.0 * half / structure.reference_length()).ln() - 1.5)
                    } else {
                        factor * ((x - y).abs() / structure.reference_length()).ln()
                    };
                    compliance[(a * s.len() + row, b * s.len() + column)] =
                        block[row * s.len() + column] + near;
                }
            }
        }
    }
    (compliance, shapes)
}

/// Returns the residual flexibility: the compliance less the static response of the modes.
fn residual(compliance: &Mat<f64>, shapes: &Mat<f64>, frequencies: &[f64], highest: f64) -> Mat<f64> {
    let below = frequencies.iter().filter(|&&omega| omega <= highest).count();
    let scaled = Mat::from_fn(shapes.nrows(), below, |row, mode| shapes[(row, mode)] / frequencies[mode]);
    compliance - product(scaled.as_ref(), scaled.transpose())
}

#[test]
fn what_modes_leave_of_the_compliance_is_definite_and_vanishes_away_from_the_load() {
    let (structure, modes) = toothed(150_000.0);
    let (compliance, shapes) = cells(&structure, &modes);
    assert!(modes.count() > 100, "{}", modes.count());
    let whole = eigenvalues(&compliance);
    let (smallest, largest) = (whole[0], whole[whole.len() - 1]);
    let cells = compliance.nrows() / 4;
    // Entries of the other flank of the tooth and of the previous tooth.
    let far = |matrix: &Mat<f64>| {
        let entries = (0..cells).flat_map(|row| (cells..4 * cells).map(move |column| (row, column)));
        entries.map(|place| matrix[place].abs()).fold(0.0, f64::max)
    };
    let trace = |matrix: &Mat<f64>| (0..matrix.nrows()).map(|k| matrix[(k, k)]).sum::<f64>();
    let mut last = trace(&compliance);
    for highest in [25_000.0, 50_000.0, 100_000.0, 150_000.0] {
        let left = residual(&compliance, &shapes, &modes.frequencies, highest);
        let least = eigenvalues(&left)[0];
        assert!(least > 0.0 && least <= smallest, "up to {highest}: {least} of {smallest} to {largest}");
        assert!(trace(&left) < last, "up to {highest}: more modes leave less");
        last = trace(&left);
        assert!(far(&left) < 0.02 * far(&compliance), "up to {highest}: {}", far(&left));
    }
    assert!(
        last < 0.1 * trace(&compliance),
        "what is left is near the load: {last} of {}",
        trace(&compliance)
    );
}

#[test]
fn stress_of_modes_is_that_of_statics() {
    let (structure, modes) = toothed(150_000.0);
    let s = 0.6 * structure.profile(0).length();
    let mut largest = 0.0_f64;
    for tooth in 0..2 {
        let load = Chart { tooth: 0, surface: 0 };
        let shapes = modes.displacements(load, &[s]);
        // The fillet on the other side of the loaded tooth, and that of its neighbour.
        let direct = structure.stresses(tooth, 1, &[SurfaceLoad { chart: load, s, force: 1.0 }]);
        let by_modes = modes.stresses(tooth, 1);
        assert_eq!(by_modes.nrows(), direct.len());
        largest = direct.iter().map(|(_, stress)| stress.abs()).fold(largest, f64::max);
        for (row, (_, expected)) in direct.iter().enumerate() {
            let sum: f64 = (0..modes.count())
                .map(|mode| by_modes[(row, mode)] * shapes[(0, mode)] / modes.frequencies[mode].powi(2))
                .sum();
            assert!((sum - expected).abs() < 0.02 * largest, "tooth {tooth}, place {row}: {sum} {expected}");
        }
    }
}

#[test]
fn teeth_all_around_see_one_mode_of_the_ring() {
    let (_, modes) = toothed(40_000.0);
    let s = [0.3, 0.7].map(|share| share * 0.1);
    for mode in 0..modes.count() {
        let around: Vec<f64> =
            (0..TEETH).map(|tooth| modes.displacements(Chart { tooth, surface: 0 }, &s)[(1, mode)]).collect();
        // A single harmonic: its transform has one number of nodal diameters.
        let power = |n: u32| {
            let part = |f: fn(f64) -> f64| {
                around
                    .iter()
                    .zip(0..)
                    .map(|(value, j)| value * f(TAU * f64::from(n * j) / f64::from(TEETH)))
                    .sum::<f64>()
            };
            part(f64::cos).hypot(part(f64::sin))
        };
        let all: Vec<f64> = (0..=TEETH / 2).map(power).collect();
        let largest = all.iter().copied().fold(0.0, f64::max);
        assert_eq!(all.iter().filter(|&&power| power > 1e-9 * largest).count(), 1, "mode {mode}: {all:?}");
    }
}

#[test]
fn a_surface_in_place_of_itself_changes_nothing() {
    let (model, surfaces) = toothed_sector(TEETH, 1.0, COARSE);
    let options = SplitOptions { allows_modified_surfaces: true, ..SplitOptions::default() };
    let modes =
        BodyModes::ring(&model, &ring_source(TEETH), &surfaces, &options, 40_000.0, &Interrupt::never())
            .unwrap();
    let same = surfaces.iter().map(|surface| ModifiedSurface {
        profile: surface.profile.clone() as Arc<dyn Profile>,
        onto: Arc::new(|s| s),
    });
    let modified = modes.with_modified_surfaces(same.collect()).unwrap();
    let chart = Chart { tooth: 3, surface: 1 };
    let s = [0.02, 0.05, 0.07];
    let (a, b) = (modes.displacements(chart, &s), modified.displacements(chart, &s));
    assert!((&a - &b).norm_max() <= 1e-12 * a.norm_max());
    assert!(modes.with_modified_surfaces(Vec::new()).is_none());
}

#[test]
fn what_cannot_be_had_is_refused() {
    let of = |support, highest| {
        let source = RingSource { support, ..ring_source(THIN.sectors) };
        let options = SplitOptions::default();
        let modes = BodyModes::ring(&THIN.sector(), &source, &[], &options, highest, &Interrupt::never());
        modes.map(|modes| modes.count()).map_err(EngineError::from)
    };
    let spline_teeth =
        SplineTeeth { count: 5, first: 0.0, width: 0.1, tangential: 0.0, radial: None, degree: 0 };
    assert_eq!(of(BoreSupport::SplineTeeth(spline_teeth), 100.0).unwrap_err().code, "E0759");
    assert_eq!(of(BoreSupport::Rigid, f64::INFINITY).unwrap_err().code, "E0758");
    assert_eq!(of(BoreSupport::Rigid, 0.0).unwrap(), 0);
    let stop = Interrupt::new(|| Err(EngineError::new("E0704", "stopped", "")));
    let options = SplitOptions::default();
    let stopped = BodyModes::ring(&THIN.sector(), &ring_source(THIN.sectors), &[], &options, 100.0, &stop);
    assert_eq!(stopped.map_err(EngineError::from).err().unwrap().code, "E0704");
}
