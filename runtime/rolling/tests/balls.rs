//! Balls: stiffness against differences, equilibrium at speed, four-point contact.

use crate::sample::{
    angular_contact, balls, check_hostile, check_stiffness, close, deep_groove, evaluate, four_point,
};
use calyx_rolling::ball::{BallContact, BallGeometry, BallState};
use calyx_rolling::bearing::Contacts;
use calyx_rolling::hertz::point::PointContact;
use calyx_rolling::{BallRow, CageSpeed, Motion, RollingBearing};

const LOADED: [f64; 5] = [15e-6, -6e-6, 20e-6, 3e-4, -2e-4];

fn at_speed(speed: f64, cage: CageSpeed, gyroscopic: bool) -> Motion {
    Motion { inner_speed: speed, cage, gyroscopic, ..Motion::REST }
}

fn states(bearing: &RollingBearing, at: &[f64; 5], motion: &Motion) -> Vec<BallState> {
    let states = bearing.elements(at, motion).expect("finite").into_iter();
    states
        .map(|state| match state.contacts {
            Contacts::Ball(ball) => ball,
            Contacts::Roller(_) => panic!("balls"),
        })
        .collect()
}

#[test]
fn stiffness_is_the_derivative_of_the_load() {
    for geometry in [deep_groove(), angular_contact(), four_point()] {
        let bearing = balls(geometry);
        for motion in [
            Motion::REST,
            at_speed(900.0, CageSpeed::Nominal, false),
            at_speed(900.0, CageSpeed::InnerRaceControl, false),
            at_speed(2500.0, CageSpeed::OuterRaceControl, true),
        ] {
            check_stiffness(&bearing, &LOADED, &motion, 1e-6);
        }
    }
}

/// The potential energy of the balls at rest depends on the contact angle through the curvature,
/// which leaves an asymmetry of its order.
#[test]
fn stiffness_is_nearly_symmetric() {
    for geometry in [deep_groove(), angular_contact(), four_point()] {
        let stiffness = evaluate(&balls(geometry), &LOADED, &Motion::REST).stiffness;
        for i in 0..5 {
            for j in 0..i {
                let scale = (stiffness[i][i] * stiffness[j][j]).sqrt();
                close(stiffness[i][j], stiffness[j][i], scale, 5e-4, "symmetry");
            }
        }
    }
}

/// Equations of Harris and Kotzalas (2007) for a ball at speed, written with the contact angles.
#[test]
fn balls_at_speed_are_in_equilibrium() {
    let geometry = angular_contact();
    let row = BallRow::new(geometry).expect("valid");
    let bearing = balls(geometry);
    let (speed, g) = (1500.0, geometry.ball_diameter / geometry.pitch_diameter);
    for (cage, gyroscopic) in [
        (CageSpeed::Nominal, false),
        (CageSpeed::Nominal, true),
        (CageSpeed::InnerRaceControl, false),
        (CageSpeed::InnerRaceControl, true),
        (CageSpeed::OuterRaceControl, true),
    ] {
        let balls = states(&bearing, &LOADED, &at_speed(speed, cage, gyroscopic));
        for (index, ball) in balls.iter().enumerate() {
            let (inner, outer) = (ball.inner[0], ball.outer[0]);
            let (ai, ao) = (inner.angle, outer.angle);
            if inner.load == 0.0 {
                continue;
            }
            let free = 40f64.to_radians();
            let ratio = match cage {
                CageSpeed::Nominal => 0.5 * (1.0 - g * free.cos()),
                CageSpeed::InnerRaceControl => ((ai - ao).cos() - g * ao.cos()) / (1.0 + (ai - ao).cos()),
                CageSpeed::OuterRaceControl => (1.0 - g * ai.cos()) / (1.0 + (ai - ao).cos()),
            };
            let orbital = ratio * speed;
            let mass = row.ball_mass();
            let centrifugal = 0.5 * mass * geometry.pitch_diameter * orbital * orbital;
            let pitch = (ao.sin() / (ao.cos() + g)).atan();
            let rolling = (ao.cos() + pitch.tan() * ao.sin()) / (1.0 + g * ao.cos())
                + (ai.cos() + pitch.tan() * ai.sin()) / (1.0 - g * ai.cos());
            let spin = speed / (rolling * g * pitch.cos());
            let diameter = geometry.ball_diameter;
            let moment = if gyroscopic {
                0.1 * mass * diameter * diameter * spin * orbital * pitch.sin()
            } else {
                0.0
            };
            let friction = 2.0 * moment / diameter;
            let radial = inner.load * ai.cos() - outer.load * ao.cos() - friction * ao.sin() + centrifugal;
            let axial = inner.load * ai.sin() - outer.load * ao.sin() + friction * ao.cos();
            close(ball.friction, friction, outer.load, 1e-12, "friction");
            close(radial, 0.0, outer.load, 1e-12, "radial balance");
            close(axial, 0.0, outer.load, 1e-12, "axial balance");
            check_approaches(geometry, std::f64::consts::TAU * index as f64 / 14.0, [inner, outer]);
            assert!(ai > ao, "centrifugal force makes the outer contact angle smaller");
        }
    }
}

/// Both contacts lead from the outer to the inner groove centre: the approaches of their loads,
/// with the curvature at their own contact angles, agree with the displacement of the ring.
fn check_approaches(geometry: BallGeometry, azimuth: f64, contacts: [BallContact; 2]) {
    let (diameter, free) = (geometry.ball_diameter, 40f64.to_radians());
    let reach = (geometry.inner_conformity - 0.5) * diameter;
    let [ux, uy, uz, about_x, about_y] = LOADED;
    let (radial, tilt) =
        (ux * azimuth.cos() + uy * azimuth.sin(), about_y * azimuth.cos() - about_x * azimuth.sin());
    let (radius, axial) = (0.5 * geometry.pitch_diameter + reach * free.cos(), reach * free.sin());
    let moved =
        [2.0 * reach * free.cos() + radial + axial * tilt, 2.0 * reach * free.sin() + uz - radius * tilt];
    let mut sum = [0.0; 2];
    for (contact, side) in contacts.iter().zip([-1.0, 1.0]) {
        let ratio = diameter * contact.angle.cos() / geometry.pitch_diameter;
        let (a, b) =
            ((1.0 - 0.5 / geometry.inner_conformity) / diameter, 1.0 / (diameter * (1.0 + side * ratio)));
        let modulus = 206e9 / (2.0 * 0.91);
        let hertz = PointContact::new(a, b, modulus);
        let length = reach + (contact.load / hertz.stiffness).powf(2.0 / 3.0);
        sum[0] += length * contact.angle.cos();
        sum[1] += length * contact.angle.sin();
    }
    for k in 0..2 {
        close(sum[k], moved[k], 1e-5, 1e-9, "distance of the groove centres");
    }
}

/// A ball without load on the inner ring is pressed against the outer ring by its centrifugal
/// force.
#[test]
fn unloaded_balls_at_speed_touch_the_outer_ring() {
    let bearing = balls(deep_groove());
    let motion = at_speed(1000.0, CageSpeed::InnerRaceControl, true);
    let row = BallRow::new(deep_groove()).expect("valid");
    for ball in states(&bearing, &[0.0; 5], &motion) {
        assert_eq!(ball.inner[0].load, 0.0);
        let orbital = 500.0 * (1.0 - 11.906 / 60.0);
        let expected = row.ball_mass() * 30e-3 * orbital * orbital;
        close(ball.outer[0].load, expected, expected, 1e-9, "load of the outer contact");
    }
    let evaluation = evaluate(&bearing, &[0.0; 5], &motion);
    assert_eq!((evaluation.load, evaluation.stiffness), ([0.0; 5], [[0.0; 5]; 5]));
}

/// At the contact angle, a four-point bearing without clearance is an angular contact bearing as
/// soon as one pair of arcs has no contact.
#[test]
fn axial_load_leaves_two_contacts_of_a_four_point_bearing() {
    let mut geometry = four_point();
    let angle = 35f64.to_radians();
    geometry.kind = calyx_rolling::BallKind::FourPoint { angle, clearance: 0.0 };
    let four = balls(geometry);
    geometry.kind = calyx_rolling::BallKind::AngularContact { angle };
    let two = balls(geometry);
    for side in [1.0, -1.0] {
        let at = [0.0, 0.0, 30e-6 * side, 0.0, 0.0];
        let load = evaluate(&four, &at, &Motion::REST).load;
        let expected = evaluate(&two, &[0.0, 0.0, 30e-6, 0.0, 0.0], &Motion::REST).load;
        close(side * load[2], expected[2], expected[2], 1e-12, "axial load");
        for ball in states(&four, &at, &Motion::REST) {
            let loaded = usize::from(side < 0.0);
            assert_eq!((ball.inner[1 - loaded].load, ball.outer[1 - loaded].load), (0.0, 0.0));
        }
    }
    // All four contacts share a radial load.
    let states = states(&four, &[20e-6, 0.0, 0.0, 0.0, 0.0], &Motion::REST);
    let (inner, outer) = (&states[0].inner, &states[0].outer);
    for pair in [inner, outer] {
        close(pair[1].load, pair[0].load, pair[0].load, 1e-9, "load of a contact");
        close(pair[1].angle, -pair[0].angle, 1.0, 1e-9, "contact angle");
    }
    let radial = [inner[0], outer[0]].map(|contact| contact.load * contact.angle.cos());
    close(radial[1], radial[0], radial[0], 1e-12, "radial balance");
    assert!(inner[0].load > 10.0 && inner[0].angle > 0.0 && inner[1].angle < 0.0);
}

/// Hostile displacements of any direction and size have a finite result.
#[test]
fn hostile_displacements_have_finite_results() {
    let motions = [
        Motion::REST,
        at_speed(2000.0, CageSpeed::Nominal, false),
        at_speed(5000.0, CageSpeed::InnerRaceControl, true),
    ];
    for geometry in [deep_groove(), angular_contact(), four_point()] {
        check_hostile(&balls(geometry), &motions, (-8..2, 20), -4);
    }
}
