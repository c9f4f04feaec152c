//! Rollers: stiffness against differences, equilibrium of a roller, convergence with laminae,
//! spherical rollers that align themselves.

use crate::sample::{
    check_hostile, check_stiffness, check_symmetry, close, cylindrical, evaluate, rollers, spherical, tapered,
};
use calyx_rolling::bearing::Contacts;
use calyx_rolling::roller::RollerState;
use calyx_rolling::{Displacement, Motion, Profile, RollerGeometry, RollingBearing, Start};

const LOADED: Displacement = [22e-6, -6e-6, 25e-6, 3e-4, -2e-4];

fn states(bearing: &RollingBearing, at: &Displacement, motion: &Motion) -> Vec<RollerState> {
    let states = bearing.elements(at, motion).expect("finite").into_iter();
    states
        .map(|state| match state.contacts {
            Contacts::Roller(roller) => *roller,
            Contacts::Ball(_) => panic!("rollers"),
        })
        .collect()
}

fn crowned() -> RollerGeometry {
    RollerGeometry { profile: Profile::Crowned { radius: 4.0 }, ..tapered() }
}

#[test]
fn stiffness_is_the_derivative_of_the_load() {
    let speed = Motion { inner_speed: 800.0, ..Motion::REST };
    for geometry in [cylindrical(), tapered(), crowned(), spherical()] {
        for motion in [Motion::REST, speed] {
            check_stiffness(&rollers(geometry.clone()), &LOADED, &motion, 1e-5);
        }
    }
}

#[test]
fn stiffness_is_symmetric() {
    for geometry in [cylindrical(), tapered(), crowned(), spherical()] {
        check_symmetry(&rollers(geometry), &LOADED);
    }
}

/// Forces and moments on each roller from the loads of its contacts, with the geometry of the cones
/// written out again.
#[test]
fn tapered_rollers_are_in_equilibrium() {
    let bearing = rollers(tapered());
    let motion = Motion { roller_force: Some(16.5), ..Motion::REST };
    let [inner, axis, outer] = [10f64, 12.0, 14.0].map(f64::to_radians);
    let foot = 30e-3 / axis.sin() * 2f64.to_radians().sin();
    let sine = 3.2e-3f64 / 0.12;
    let rib_angle = sine.asin();
    let mut loaded = 0;
    for roller in states(&bearing, &LOADED, &motion) {
        let (fi, fo, rib) = (roller.inner.load, roller.outer.load, roller.rib);
        let normal = [
            -axis.sin() * rib_angle.cos() + axis.cos() * sine,
            axis.cos() * rib_angle.cos() + axis.sin() * sine,
        ];
        let scale = fo + fi;
        close(fi * inner.cos() - fo * outer.cos() + rib * normal[0] + 16.5, 0.0, scale, 1e-12, "radial");
        close(fi * inner.sin() - fo * outer.sin() + rib * normal[1], 0.0, scale, 1e-12, "axial");
        // Moments about the roller centre from radial to axial: the contact lines pass at the same
        // distance, and the line of action of the rib force passes the axis at the centre of the
        // sphere.
        let arm = (0.12 - 6.5e-3) * sine;
        let moment = roller.inner.moment - roller.outer.moment;
        let sum = moment - rib * arm;
        close(sum, 0.0, scale * foot, 1e-11, "moment");
        loaded += usize::from(fi > 100.0);
    }
    assert!(loaded > 3);
}

/// ISO/TS 16281 integrates the load along the contact with laminae: the sum converges.
#[test]
fn laminae_converge() {
    let load = |laminae: usize| {
        let geometry = RollerGeometry { laminae, ..tapered() };
        evaluate(&rollers(geometry), &LOADED, &Motion::REST).load
    };
    let [coarse, fine, exact] = [20, 80, 640].map(load);
    for k in [0, 2] {
        let errors = [coarse, fine].map(|load| ((load[k] - exact[k]) / exact[k]).abs());
        assert!(errors[1] < 0.3 * errors[0] && errors[1] < 1e-3, "{errors:?}");
    }
}

/// The outer raceway is a sphere: the inner ring tilts with its rollers about the centre of the
/// sphere.
#[test]
fn spherical_rollers_align_themselves() {
    let geometry = spherical();
    let bearing = rollers(geometry.clone());
    let at = [0.0, 0.0, 200e-6, 0.0, 0.0];
    let load = evaluate(&bearing, &at, &Motion::REST).load[2];
    assert!(load > 500.0);
    // Rotation about the centre of the sphere: z = -pitch/2 tan 10°.
    let center = -0.5 * geometry.pitch_diameter * 10f64.to_radians().tan();
    let tilt = 1e-5;
    let moved = evaluate(&bearing, &[-center * tilt, 0.0, 200e-6, 0.0, tilt], &Motion::REST);
    // The moment about the centre vanishes; a ring fixed at its own centre has one.
    let about_center = moved.load[4] - center * moved.load[0];
    let stiff = moved.stiffness[2][2] * (0.5 * geometry.pitch_diameter).powi(2) * tilt;
    close(about_center, 0.0, stiff, 1e-3, "moment about the centre of the sphere");
    close(moved.load[2], load, load, 1e-4, "axial load");
}

/// A table of the profile replaces the formula.
#[test]
fn table_of_the_profile_agrees_with_its_formula() {
    let formula = evaluate(&rollers(crowned()), &LOADED, &Motion::REST).load;
    let points = (0..=400).map(|k| (k as f64 / 400.0 - 0.5) * 13e-3).map(|x| [x, x * x / 8.0]).collect();
    let geometry = RollerGeometry { profile: Profile::Table { points }, ..tapered() };
    let tabulated = evaluate(&rollers(geometry), &LOADED, &Motion::REST).load;
    for k in 0..3 {
        close(tabulated[k], formula[k], formula[2].abs(), 1e-4, "load");
    }
}

/// A former position of the rollers changes the number of steps and not the result.
#[test]
fn start_does_not_change_the_result() {
    let bearing = rollers(tapered());
    let cold = evaluate(&bearing, &LOADED, &Motion::REST);
    let mut start = Start::default();
    for scale in [-1.0, 4.0, 0.2, 1.0] {
        let warm = bearing.evaluate(&LOADED.map(|x| scale * x), &Motion::REST, &mut start).expect("finite");
        if scale == 1.0 {
            for k in 0..5 {
                close(warm.load[k], cold.load[k], cold.scale, 1e-11, "load");
            }
        }
    }
}

#[test]
fn hostile_displacements_have_finite_results() {
    let motions = [0.0, 2000.0].map(|inner_speed| Motion { inner_speed, ..Motion::REST });
    for geometry in [cylindrical(), tapered(), spherical()] {
        check_hostile(&rollers(geometry), &motions, (-8..2, 20), -3);
    }
}
