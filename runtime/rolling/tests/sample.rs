//! Bearings of the tests, and comparisons.

use calyx_rolling::ball::BallGeometry;
use calyx_rolling::{
    BallKind, BallRow, Displacement, Evaluation, Material, Motion, Profile, Rib, RollerGeometry, RollerKind,
    RollerRow, RollingBearing, Start,
};
use std::ops::Range;

pub fn deep_groove() -> BallGeometry {
    BallGeometry {
        kind: BallKind::DeepGroove { clearance: 12e-6 },
        count: 9,
        ball_diameter: 11.906e-3,
        pitch_diameter: 60e-3,
        inner_conformity: 0.52,
        outer_conformity: 0.52,
        rings: Material::STEEL,
        balls: Material::STEEL,
    }
}

pub fn angular_contact() -> BallGeometry {
    BallGeometry {
        kind: BallKind::AngularContact { angle: 40f64.to_radians() },
        count: 14,
        ball_diameter: 11.112e-3,
        ..deep_groove()
    }
}

pub fn four_point() -> BallGeometry {
    BallGeometry {
        kind: BallKind::FourPoint { angle: 35f64.to_radians(), clearance: 10e-6 },
        ..angular_contact()
    }
}

pub fn cylindrical() -> RollerGeometry {
    RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: 30e-6 },
        count: 14,
        roller_diameter: 11e-3,
        length: 10e-3,
        raceway_widths: [None; 2],
        pitch_diameter: 60e-3,
        profile: Profile::Logarithmic,
        laminae: 41,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    }
}

pub fn tapered() -> RollerGeometry {
    // Half taper of 2° and roller axis at 12° to the bearing axis.
    let diameter = 60e-3 / 12f64.to_radians().sin() * 2f64.to_radians().tan();
    RollerGeometry {
        kind: RollerKind::Tapered {
            outer_angle: 14f64.to_radians(),
            rib: Rib { end_radius: 0.12, height: 3.2e-3 },
        },
        count: 17,
        roller_diameter: diameter,
        length: 13e-3,
        raceway_widths: [None; 2],
        ..cylindrical()
    }
}

pub fn spherical() -> RollerGeometry {
    RollerGeometry {
        kind: RollerKind::Spherical {
            angle: 10f64.to_radians(),
            outer_osculation: 0.98,
            inner_osculation: 0.975,
            clearance: 20e-6,
        },
        profile: Profile::Straight,
        ..cylindrical()
    }
}

pub fn balls(geometry: BallGeometry) -> RollingBearing {
    RollingBearing::single(BallRow::new(geometry).expect("valid"))
}

pub fn rollers(geometry: RollerGeometry) -> RollingBearing {
    RollingBearing::single(RollerRow::new(geometry).expect("valid"))
}

pub fn evaluate(bearing: &RollingBearing, displacement: &Displacement, motion: &Motion) -> Evaluation {
    let evaluation = bearing.evaluate(displacement, motion, &mut Start::default()).expect("finite");
    assert_eq!(evaluation.unconverged, 0, "{displacement:?}");
    evaluation
}

/// Compares values relative to a scale.
#[track_caller]
pub fn close(value: f64, expected: f64, scale: f64, tolerance: f64, what: &str) {
    let error = (value - expected).abs() / scale;
    assert!(error <= tolerance, "{what}: {value:e} instead of {expected:e}, error {error:.2e}");
}

/// Compares the stiffness with central differences of two step lengths, extrapolated.
#[track_caller]
pub fn check_stiffness(bearing: &RollingBearing, at: &Displacement, motion: &Motion, tolerance: f64) {
    let evaluation = evaluate(bearing, at, motion);
    let unit = [1.0, 1.0, 1.0, 30e-3f64, 30e-3];
    let largest = (0..5).fold(0.0f64, |most, k| most.max(evaluation.stiffness[k][k].abs() / unit[k].powi(2)));
    for column in 0..5 {
        let difference = |step: f64| {
            let mut ends = [*at; 2];
            ends[0][column] += step / unit[column];
            ends[1][column] -= step / unit[column];
            let loads = ends.map(|at| evaluate(bearing, &at, motion).load);
            [0, 1, 2, 3, 4].map(|k| (loads[0][k] - loads[1][k]) / (2.0 * step))
        };
        let (coarse, fine) = (difference(2e-9), difference(1e-9));
        for row in 0..5 {
            let expected = (4.0 * fine[row] - coarse[row]) / 3.0 / unit[row];
            let value = evaluation.stiffness[row][column] / unit[row] / unit[column];
            close(value, expected, largest, tolerance, &format!("stiffness {row} {column}"));
        }
    }
}

/// Compares the stiffness with its transpose.
pub fn check_symmetry(bearing: &RollingBearing, at: &Displacement) {
    let stiffness = evaluate(bearing, at, &Motion::REST).stiffness;
    for i in 0..5 {
        for j in 0..i {
            let scale = (stiffness[i][i] * stiffness[j][j]).sqrt().max(1.0);
            close(stiffness[i][j], stiffness[j][i], scale, 1e-12, "symmetry");
        }
    }
}

/// Checks that a number of displacements in random directions of each power of ten, m and rad, have
/// finite results, and that elements converge below a power.
pub fn check_hostile(
    bearing: &RollingBearing,
    motions: &[Motion],
    (powers, count): (Range<i32>, usize),
    converged: i32,
) {
    let mut random = 0x2545_f491_4f6c_dd1du64;
    let mut next = || {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    for power in powers {
        for _ in 0..count {
            let at = [0.0; 5].map(|_| 10f64.powi(power) * next());
            for motion in motions {
                let evaluation = bearing.evaluate(&at, motion, &mut Start::default()).expect("finite");
                let finite = evaluation.load.iter().chain(evaluation.stiffness.iter().flatten());
                assert!(finite.copied().all(f64::is_finite), "{at:?} {motion:?}");
                if power < converged {
                    assert_eq!(evaluation.unconverged, 0, "{at:?} {motion:?}");
                }
            }
        }
    }
}
