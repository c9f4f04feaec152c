//! The involute of a circle: the involute function with its inverse, and the curve in terms of the
//! roll angle.
//!
//! The roll angle of a point is the tangent of its pressure angle: the length of the tangent from
//! the point to the base circle divided by the base radius. All angles are in radians.

use calyx_abi::math;

/// Roll angle below which a series evaluates the involute function.
const SERIES_UP_TO: f64 = 0.25;

/// Involute function, `inv(alpha) = tan(alpha) - alpha`.
pub fn involute(pressure_angle: f64) -> f64 {
    involute_of_roll(math::tan(pressure_angle))
}

/// Involute function of a roll angle, `roll - atan(roll)`: the polar angle between the involute's
/// origin on the base circle and the point.
pub fn involute_of_roll(roll: f64) -> f64 {
    if roll.abs() < SERIES_UP_TO {
        // The difference would cancel digits; the first omitted term of the series is below 1e-17
        // of the first.
        let square = roll * roll;
        let mut sum = 0.0;
        for power in (1..=14).rev() {
            let coefficient = 1.0 / f64::from(2 * power + 1);
            sum = (if power % 2 == 1 { coefficient } else { -coefficient }) + square * sum;
        }
        return roll * square * sum;
    }
    roll - math::atan(roll)
}

/// Solves the involute function for the roll angle by Newton's method. Negative values give
/// negative roll angles.
pub fn roll_of_involute(value: f64) -> f64 {
    if value == 0.0 {
        return 0.0;
    }
    let target = value.abs();
    // Initial guess: roll^3 / 3 for small values; for large ones the arc tangent approaches pi/2.
    let small = math::pow(3.0 * target, 1.0 / 3.0);
    let mut roll = if small < 1.5 { small * (1.0 + 0.2 * small * small) } else { target + 1.3 };
    for _ in 0..50 {
        let square = roll * roll;
        let step = (involute_of_roll(roll) - target) * (1.0 + square) / square;
        roll -= step;
        if step.abs() <= 2.0 * f64::EPSILON * roll {
            break;
        }
    }
    roll.copysign(value)
}

/// Pressure angle whose involute function has this value.
pub fn inverse_involute(value: f64) -> f64 {
    math::atan(roll_of_involute(value))
}

/// Radius of the point at a roll angle, in the unit of `base_radius`.
pub fn radius_at_roll(base_radius: f64, roll: f64) -> f64 {
    base_radius * (1.0 + roll * roll).sqrt()
}

/// Roll angle at a radius; 0 below the base circle.
pub fn roll_at_radius(base_radius: f64, radius: f64) -> f64 {
    // The factored form loses no digits near the base circle.
    ((radius - base_radius) * (radius + base_radius)).max(0.0).sqrt() / base_radius
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_undoes_the_involute_function() {
        for k in 1..=1400 {
            let angle = f64::from(k) * 1e-3;
            let back = inverse_involute(involute(angle));
            assert!((back - angle).abs() < 1e-15 * angle.max(0.4) / 0.4, "{angle}: {back}");
            assert_eq!(roll_of_involute(-involute(angle)), -roll_of_involute(involute(angle)));
        }
        // inv(20 deg) to the digits of gear tables.
        assert!((involute(20.0_f64.to_radians()) - 0.014904383867336446).abs() < 1e-17);
    }

    #[test]
    fn series_and_difference_agree_where_they_meet() {
        let roll = SERIES_UP_TO * (1.0 - f64::EPSILON);
        assert!((involute_of_roll(roll) - (roll - roll.atan())).abs() < 1e-16);
    }

    #[test]
    fn radius_and_roll_are_inverse() {
        for roll in [0.0, 1e-6, 0.03, 0.36, 1.4] {
            let back = roll_at_radius(0.024, radius_at_roll(0.024, roll));
            assert!((back - roll).abs() < 1e-15 + 1e-16 / roll.max(1e-9), "{roll}: {back}");
        }
    }
}
