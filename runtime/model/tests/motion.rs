//! Tests of prescribed motions: poses, velocities, axles.

use calyx_model::motion::{
    Motion, Orientation, PlanePose, RelocatedMotion, SteadyRotation, angular_velocity, axle, point_velocity,
    rotation_speed, spatial_pose, tilted_axes,
};
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

#[test]
fn the_pose_of_a_turning_body_is_its_angle_and_its_axis() {
    let motion = SteadyRotation { origin: [0.3, -0.2], start: 0.4, speed: -2.0 };
    let pose = PlanePose::of(&motion, 0.1).unwrap();
    assert!((pose.angle - 0.2).abs() < 1e-15);
    assert!((pose.origin[0] - 0.3).abs() < 1e-15 && (pose.origin[1] + 0.2).abs() < 1e-15);
    let [x, y, z] = angular_velocity(&motion, 0.1);
    assert!((z + 2.0).abs() < 1e-14 && x == 0.0 && y == 0.0);
    assert!((rotation_speed(&motion, 0.1).unwrap() + 2.0).abs() < 1e-14);
}

/// Frame that is tilted about x by `tilt`, before or after it is rotated about z by `angle`.
struct Leaning {
    tilt: f64,
    speed: f64,
    wobbles: bool,
}

impl Motion for Leaning {
    fn frame(&self, time: f64) -> [f64; 12] {
        let ((s, c), (st, ct)) = ((self.speed * time).sin_cos(), self.tilt.sin_cos());
        // Ground to body: rotation after tilt, or tilt after rotation.
        let r = if self.wobbles {
            [c, s, 0.0, -ct * s, ct * c, st, st * s, -st * c, ct]
        } else {
            [c, s * ct, s * st, -s, c * ct, c * st, 0.0, -st, ct]
        };
        [r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], 0.0, 0.0, 0.0]
    }
    fn rate(&self, time: f64) -> [f64; 12] {
        let step = 1e-6;
        let (before, after) = (self.frame(time - step), self.frame(time + step));
        std::array::from_fn(|k| (after[k] - before[k]) / (2.0 * step))
    }
    fn acceleration(&self, _: f64) -> [f64; 12] {
        [f64::NAN; 12]
    }
}

#[test]
fn a_tilted_body_turns_about_its_own_axis() {
    for wobbles in [false, true] {
        let motion = Leaning { tilt: 0.05, speed: 3.0, wobbles };
        for time in [0.0, 0.2, 0.7] {
            let stance = Orientation::of(&spatial_pose(&motion, time).unwrap());
            assert!((stance.angle - 3.0 * time).abs() < 1e-14, "{}", stance.angle);
            assert!((stance.tilt() - 0.05).abs() < 1e-14);
            assert!((rotation_speed(&motion, time).unwrap() - 3.0).abs() < 1e-9);
            for (i, one) in stance.axes.iter().enumerate() {
                for (j, other) in stance.axes.iter().enumerate() {
                    let dot: f64 = (0..3).map(|k| one[k] * other[k]).sum();
                    assert!((dot - if i == j { 1.0 } else { 0.0 }).abs() < 1e-15);
                }
            }
        }
    }
}

/// The angle of a body is continuous in its rotation whatever the direction of its axis.
#[test]
fn bodies_on_general_axes_turn_about_their_own() {
    for axis in [[0.6, 0.0, 0.8], [1.0, 0.0, 0.0], [0.0, -0.6, -0.8], [0.0, 0.0, -1.0]] {
        let [x, y, z] = tilted_axes(axis);
        let rotation = [0, 1, 2].map(|k: usize| [x[k], y[k], z[k]]);
        let still = SteadyRotation { origin: [0.0; 2], start: 0.4, speed: -2.0 };
        let placed = RelocatedMotion::rotated_about(Arc::new(still), rotation, [0.1, 0.2, 0.3]);
        let at = Orientation::of(&spatial_pose(&placed, 0.1).unwrap());
        assert!((at.angle - 0.2).abs() < 1e-12, "{axis:?}: {}", at.angle);
        assert!((0..3).all(|k| (at.axis()[k] - axis[k]).abs() < 1e-15), "{axis:?}");
        assert!((rotation_speed(&placed, 0.1).unwrap() + 2.0).abs() < 1e-12, "{axis:?}");
    }
}

#[test]
fn a_motion_put_elsewhere_moves_as_it_did_there() {
    let still = SteadyRotation { origin: [0.3, -0.2], start: 0.4, speed: -2.0 };
    let rotation = tilted_axes([0.6 * 0.05_f64.sin(), 0.8 * 0.05_f64.sin(), 0.05_f64.cos()]);
    // The rows of `swung` are images of axes, so the matrix that maps the axes is its
    // transpose.
    let rotation: [[f64; 3]; 3] = [0, 1, 2].map(|i| [0, 1, 2].map(|j: usize| rotation[j][i]));
    let placed = RelocatedMotion::rotated_about(Arc::new(still), rotation, [0.1, 0.2, 0.3]);
    let (at, there) = (spatial_pose(&still, 0.7).unwrap(), spatial_pose(&placed, 0.7).unwrap());
    let expected = placed.pose.point(at.point([0.01, 0.02, 0.03]));
    let found = there.point([0.01, 0.02, 0.03]);
    assert!((0..3).all(|k| (found[k] - expected[k]).abs() < 1e-15), "{found:?} {expected:?}");
    assert_eq!(placed.pose.point([0.1, 0.2, 0.3]), [0.1, 0.2, 0.3]);
    let velocity = placed.pose.direction(point_velocity(&still, 0.7, at.point([0.01, 0.02, 0.03])));
    let found = point_velocity(&placed, 0.7, found);
    assert!((0..3).all(|k| (found[k] - velocity[k]).abs() < 1e-14), "{found:?} {velocity:?}");
}

/// Rotation with the origin at a distance `by` (m) from the axis, which orbits the ground axis
/// at `orbit`.
struct Around {
    by: f64,
    orbit: f64,
}

impl Motion for Around {
    fn frame(&self, time: f64) -> [f64; 12] {
        let still = SteadyRotation { origin: [0.0; 2], start: 0.0, speed: 2.0 }.frame(time);
        let (sine, cosine) = (0.7 * time).sin_cos();
        let [x, y] = [self.orbit * cosine + 0.1, self.orbit * sine];
        let mut frame = still;
        frame[9] = -(still[0] * x + still[1] * y) - self.by;
        frame[10] = -(still[3] * x + still[4] * y);
        frame
    }
    fn rate(&self, time: f64) -> [f64; 12] {
        let step = 1e-5;
        let (before, after) = (self.frame(time - step), self.frame(time + step));
        std::array::from_fn(|k| (after[k] - before[k]) / (2.0 * step))
    }
    fn acceleration(&self, _: f64) -> [f64; 12] {
        [f64::NAN; 12]
    }
}

#[test]
fn an_axle_is_where_a_body_rests_on_ground() {
    let [x, y, z] = axle(&Around { by: 2e-3, orbit: 0.0 });
    assert!((x + 2e-3).abs() < 1e-9 && y.abs() < 1e-9 && z.abs() < 1e-9, "{x} {y} {z}");
    // A body on its own axis, a planet, which orbits, and a body at rest.
    assert_eq!(axle(&SteadyRotation { origin: [0.3, -0.2], start: 0.4, speed: -2.0 }), [0.0; 3]);
    assert_eq!(axle(&Around { by: 0.0, orbit: 0.05 }), [0.0; 3]);
    // A planet with an eccentricity of two millimetres.
    let [x, y, z] = axle(&Around { by: 2e-3, orbit: 0.05 });
    assert!((x + 2e-3).abs() < 1e-12 && y.abs() < 1e-12 && z == 0.0, "{x} {y} {z}");
    assert_eq!(axle(&SteadyRotation::at_rest([0.3, -0.2])), [0.0; 3]);
}

#[test]
fn the_axle_of_an_eccentric_planet_is_the_same_in_any_orientation() {
    for angle in [0.4f64, FRAC_PI_2, 2.5] {
        let (sine, cosine) = angle.sin_cos();
        let about_y = [[cosine, 0.0, sine], [0.0, 1.0, 0.0], [-sine, 0.0, cosine]];
        let planet = Arc::new(Around { by: 2e-3, orbit: 0.05 });
        let [x, y, z] = axle(&RelocatedMotion::rotated_about(planet, about_y, [0.1, 0.0, 0.2]));
        assert!((x + 2e-3).abs() < 1e-11 && y.abs() < 1e-11 && z.abs() < 1e-11, "{x} {y} {z}");
    }
}

#[test]
fn axes_swing_no_further_than_their_z() {
    // The minimal rotation does not change the direction of its own axis.
    let axis = [0.03_f64.sin() * 0.6, 0.03_f64.sin() * 0.8, 0.03_f64.cos()];
    let [x, y, _] = tilted_axes(axis);
    let across: [f64; 3] = std::array::from_fn(|k| 0.8 * x[k] - 0.6 * y[k]);
    let error = [across[0] - 0.8, across[1] + 0.6, across[2]].map(f64::abs);
    assert!(error.iter().all(|error| *error < 1e-15), "{error:?}");
}

#[test]
fn points_of_a_turning_body_move_about_its_axis() {
    let motion = SteadyRotation { origin: [0.3, -0.2], start: 0.4, speed: -2.0 };
    let [x, y, z] = point_velocity(&motion, 0.7, [1.3, 0.3, 5.0]);
    // Angular velocity times the arm, rotated by a right angle.
    assert!((x - 2.0 * 0.5).abs() < 1e-14 && (y + 2.0).abs() < 1e-14 && z == 0.0, "{x} {y} {z}");
}

#[test]
fn a_frame_tilted_out_of_the_plane_is_refused() {
    struct Tilted;
    impl Motion for Tilted {
        fn frame(&self, _: f64) -> [f64; 12] {
            [1.0, 0.0, 0.0, 0.0, 0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0]
        }
        fn rate(&self, _: f64) -> [f64; 12] {
            [0.0; 12]
        }
        fn acceleration(&self, _: f64) -> [f64; 12] {
            [0.0; 12]
        }
    }
    assert_eq!(PlanePose::of(&Tilted, 0.0).unwrap_err().code, "E0610");
}
