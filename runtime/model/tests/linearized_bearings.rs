//! Rolling bearings as constant stiffnesses, against closed forms and differences of displacements.

use calyx_model::bearing::RollingElements;
use calyx_rolling::{
    BallGeometry, BallKind, BallRow, Material, Motion, Profile, RollerGeometry, RollerKind, RollerRow,
    RollingBearing,
};
use std::sync::Arc;

fn balls(kind: BallKind) -> Arc<RollingElements> {
    let row = BallRow::new(BallGeometry {
        kind,
        count: 9,
        ball_diameter: 11.9e-3,
        pitch_diameter: 60e-3,
        inner_conformity: 0.52,
        outer_conformity: 0.52,
        rings: Material::STEEL,
        balls: Material::STEEL,
    });
    elements(RollingBearing::single(row.expect("balls")))
}

fn rollers() -> Arc<RollingElements> {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Cylindrical { clearance: 0.0 },
        count: 14,
        roller_diameter: 9e-3,
        length: 10e-3,
        raceway_widths: [None; 2],
        pitch_diameter: 55e-3,
        profile: Profile::Straight,
        laminae: 31,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    });
    elements(RollingBearing::single(row.expect("rollers")))
}

fn elements(bearing: RollingBearing) -> Arc<RollingElements> {
    Arc::new(RollingElements::new(bearing, Motion::REST).expect("elements"))
}

/// Without clearance, the load of an element is a power of its approach: 3/2 for balls, 10/9 for
/// rollers. So the radial stiffness grows with the power 1/3 or 1/10 of the force.
#[test]
fn the_range_follows_from_the_law_of_contact() {
    let ball = balls(BallKind::DeepGroove { clearance: 0.0 });
    for (bearing, power) in [(ball, 3.0), (rollers(), 10.0)] {
        let (_, linearization) = bearing.linearized([2e3, 0.0, 0.0]).expect("a linearization");
        for (end, stiffness) in linearization.range.into_iter().zip([0.9f64, 1.1]) {
            let expected = 2e3 * stiffness.powf(power);
            assert!((end / expected - 1.0).abs() < 1e-3, "{end} instead of {expected}");
        }
        assert!(linearization.covers([2e3, 300.0, 0.0]));
        for other in [[1e5, 0.0, 0.0], [0.0, 2e3, 0.0], [-2e3, 0.0, 0.0]] {
            assert!(!linearization.covers(other), "{other:?}");
        }
    }
}

/// The tangent is the derivative of the force with respect to the displacement, and the preload
/// balances the external force at the operating point.
#[test]
fn the_tangent_is_the_derivative_of_the_load() {
    let bearing = balls(BallKind::AngularContact { angle: 25f64.to_radians() });
    let force = [1500.0, -400.0, 900.0];
    let (tangent, _) = bearing.linearized(force).expect("a linearization");
    // The deflection at which the linear bearing carries the external force.
    let k = nalgebra::Matrix3::from_fn(|i, j| tangent.stiffness[i][j]);
    let load = nalgebra::Vector3::from_fn(|i, _| tangent.load[i] + force[i]);
    let deflection = k.lu().solve(&load).expect("a deflection");
    let at = |axis: usize, by: f64| {
        let mut moved = [deflection[0], deflection[1], deflection[2], 0.0, 0.0];
        moved[axis] += by;
        bearing.state(moved).expect("a state").evaluation.load
    };
    let here = at(0, 0.0);
    for component in 0..3 {
        assert!((here[component] - force[component]).abs() < 1e-6 * 1500.0, "{here:?}");
    }
    let mut differences = [[0.0; 5]; 5];
    for axis in 0..5 {
        let step = if axis < 3 { 1e-9 } else { 1e-8 };
        let (more, less) = (at(axis, step), at(axis, -step));
        for component in 0..5 {
            differences[component][axis] = (more[component] - less[component]) / (2.0 * step);
        }
    }
    for (row, column) in (0..5).flat_map(|row| (0..5).map(move |column| (row, column))) {
        // Kinematics are linear in the tilt, so the load is not exactly that of a potential.
        let expected = 0.5 * (differences[row][column] + differences[column][row]);
        let scale = (tangent.stiffness[row][row] * tangent.stiffness[column][column]).sqrt();
        let found = tangent.stiffness[row][column];
        assert!((found - expected).abs() < 1e-6 * scale, "{row} {column}: {found} {expected}");
    }
}

/// The outer ring on the first race moves against the inner ring.
#[test]
fn exchanged_rings_exchange_the_force() {
    let bearing = balls(BallKind::DeepGroove { clearance: 5e-6 });
    let exchanged = Arc::new(bearing.as_ref().clone().inverted());
    let force = [1200.0, 300.0, 150.0];
    let (expected, range) = bearing.linearized(force.map(|part| -part)).expect("a linearization");
    let (found, exchanged) = exchanged.linearized(force).expect("a linearization");
    for (found, expected) in found.stiffness.as_flattened().iter().zip(expected.stiffness.as_flattened()) {
        assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{found} {expected}");
    }
    assert!((exchanged.range[0] / range.range[0] - 1.0).abs() < 1e-6);
}

#[test]
fn impossible_operating_points_are_rejected() {
    let message = |force| rollers().linearized(force).expect_err("it is rejected").message;
    assert!(message([1e3, 0.0, 10.0]).contains("no axial force"));
    assert!(message([0.0; 3]).contains("is zero or not a number"));
    assert!(message([f64::NAN, 0.0, 0.0]).contains("is zero or not a number"));
    assert!(message([1e6, 0.0, 0.0]).contains("indents its raceways"));
    let angular = balls(BallKind::AngularContact { angle: 25f64.to_radians() });
    let against = angular.linearized([0.0, 0.0, -900.0]).expect_err("it is rejected").message;
    assert!(against.contains("against its `thrust`"), "{against}");
}
