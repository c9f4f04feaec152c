//! Meshes on axes that move: a differential in its rotating case, and planetary sets about axes of
//! any direction. The results are those of the same mechanism at rest and upright.

use crate::models::{codes, solved};

/// A differential of straight bevel gears whose case has a speed, its axis tilted from e3.
fn differential(case_speed: &str, tilt: &str) -> String {
    include_str!("moving_axes/differential.cx").replace("CASE_SPEED", case_speed).replace("TILT", tilt)
}

/// A helical planetary set with a position error of a pin and a runout of a planet (um), its axis
/// tilted from e3.
fn planetary(runout: f64, tilt: &str) -> String {
    include_str!("moving_axes/planetary.cx").replace("RUNOUT", &runout.to_string()).replace("TILT", tilt)
}

/// Largest difference of the values of an output relative to its largest value.
fn assert_same(name: &str, found: &str, expected: &str) {
    let (found, expected) = (solved(found).0, solved(expected).0);
    assert_eq!(found.len(), expected.len(), "{name}");
    for output in 0..expected[0].len() {
        let scale = expected.iter().map(|row| row[output].abs()).fold(0.0, f64::max);
        assert!(scale > 0.0, "{name}: output {output} is zero");
        for (found, expected) in found.iter().zip(&expected) {
            let difference = (found[output] - expected[output]).abs();
            assert!(
                difference <= 1e-7 * scale,
                "{name}, output {output}: {} instead of {}",
                found[output],
                expected[output]
            );
        }
    }
}

#[test]
fn a_differential_transmits_the_same_in_a_rotating_case() {
    let resting = differential("0 rpm", "0 deg");
    assert_same("upright", &differential("300 rpm", "0 deg"), &resting);
    assert_same("tilted", &differential("-130 rpm", "90 deg"), &resting);
}

#[test]
fn a_planetary_set_may_have_an_axis_of_any_direction() {
    let upright = planetary(40.0, "0 deg");
    assert_same("across", &planetary(40.0, "90 deg"), &upright);
    assert_same("opposite", &planetary(40.0, "180 deg"), &upright);
}

/// Without a speed relative to the case there is no mesh cycle. Planets that do not move with the
/// case rotate too fast.
#[test]
fn speeds_are_relative_to_the_carrier() {
    let model = differential("300 rpm", "0 deg");
    let resting = codes(&model.replace("var speed = 20 rpm", "var speed = 0 rpm"));
    assert!(resting.contains(&"E0650".to_owned()), "{resting:?}");
    let left_behind =
        model.replace("* Rotate(i * 180 deg, e3)\n            * placed);", "* Rotate(i * 180 deg, e3));");
    assert!(codes(&left_behind).contains(&"E0651".to_owned()), "{:?}", codes(&left_behind));
}
