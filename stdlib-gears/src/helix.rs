//! Helix of the teeth: rotation of the transverse section along the axis.
//!
//! Teeth are the transverse section swept along z and rotated in proportion to z. The section at
//! mid-face (z = 0) coincides with the plane one. A right-hand helix rotates counter-clockwise,
//! seen against z, as z increases.

use crate::error::{GeometryError, sentence};
use calyx_abi::math;
use std::f64::consts::{PI, TAU};

/// Hand of a helix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hand {
    /// Right-hand, like a right-hand screw thread.
    Right,
    /// Left-hand.
    Left,
}

impl Hand {
    /// Returns the hand called `"left"` or `"right"`.
    pub fn named(name: &str) -> Option<Hand> {
        match name {
            "left" => Some(Hand::Left),
            "right" => Some(Hand::Right),
            _ => None,
        }
    }

    /// Name that [`Hand::named`] accepts.
    pub fn name(self) -> &'static str {
        match self {
            Hand::Left => "left",
            Hand::Right => "right",
        }
    }

    /// The opposite hand.
    #[must_use]
    pub fn mirrored(self) -> Hand {
        match self {
            Hand::Left => Hand::Right,
            Hand::Right => Hand::Left,
        }
    }
}

/// Helix of the teeth. Its angle is the helix angle at the reference (pitch) circle, as usual for
/// gear data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Helix {
    angle: f64,
    hand: Hand,
}

/// Largest helix angle of a gear on parallel axes, rad.
const STEEPEST: f64 = PI / 3.0;

impl Helix {
    /// Spur teeth.
    pub const SPUR: Helix = Helix { angle: 0.0, hand: Hand::Right };

    /// Creates a helix from its helix angle at the reference circle (rad) and its hand.
    ///
    /// # Errors
    /// E0622: the angle is negative or above 60 deg.
    pub fn new(angle: f64, hand: Hand) -> Result<Helix, GeometryError> {
        if !(0.0..=STEEPEST).contains(&angle) {
            return Err(GeometryError::error(
                "E0622",
                "helix_angle",
                sentence!["the helix angle is ", angle angle, ", not between ", angle 0.0, " and ", angle STEEPEST],
                sentence![
                    "give the angle between tooth and axis at the pitch circle, and say which way it winds by `hand`"
                ],
            ));
        }
        Ok(Helix { angle, hand })
    }

    /// Helix angle at the reference circle, rad, never negative.
    pub fn angle(&self) -> f64 {
        self.angle
    }

    /// Hand of the helix. It has no meaning for spur teeth.
    pub fn hand(&self) -> Hand {
        self.hand
    }

    /// Returns whether the teeth are spur teeth.
    pub fn is_spur(&self) -> bool {
        self.angle == 0.0
    }

    /// Signed helix angle: positive for a right-hand helix, rad.
    pub fn signed_angle(&self) -> f64 {
        match self.hand {
            Hand::Right => self.angle,
            Hand::Left => -self.angle,
        }
    }

    /// Counter-clockwise rotation of the transverse section per length along z, rad/m, for a gear
    /// of this reference radius (m).
    pub fn twist_per_length(&self, reference_radius: f64) -> f64 {
        math::tan(self.signed_angle()) / reference_radius
    }

    /// Lead: axial advance of one revolution, m; infinite for spur teeth. It is the same at every
    /// radius.
    pub fn lead(&self, reference_radius: f64) -> f64 {
        TAU / self.twist_per_length(reference_radius).abs()
    }

    /// Helix angle at another radius, `tan(beta) radius / reference radius`, rad.
    pub fn angle_at(&self, radius: f64, reference_radius: f64) -> f64 {
        math::atan(math::tan(self.angle) * radius / reference_radius)
    }

    /// Helix angle at the base circle: `tan(beta_b) = tan(beta) cos(alpha_t)`, rad.
    pub fn base_angle(&self, transverse_pressure_angle: f64) -> f64 {
        math::atan(math::tan(self.angle) * math::cos(transverse_pressure_angle))
    }
}

impl Default for Helix {
    fn default() -> Self {
        Helix::SPUR
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hands_mirror() {
        let angle = 20.0_f64.to_radians();
        let [left, right] = [Hand::Left, Hand::Right].map(|hand| Helix::new(angle, hand).unwrap());
        assert_eq!(left.twist_per_length(0.03), -right.twist_per_length(0.03));
        assert!(right.twist_per_length(0.03) > 0.0);
        assert_eq!(Hand::named(Hand::Left.name()).map(Hand::mirrored), Some(Hand::Right));
        assert_eq!(Hand::named("up"), None);
    }

    #[test]
    fn one_lead_at_every_radius() {
        let helix = Helix::new(0.4, Hand::Left).unwrap();
        let lead = helix.lead(0.05);
        for radius in [0.04, 0.05, 0.061] {
            let there = TAU * radius / math::tan(helix.angle_at(radius, 0.05));
            assert!((there - lead).abs() < 1e-14, "{radius}");
        }
        let pressure = 0.35;
        let base = helix.angle_at(0.05 * math::cos(pressure), 0.05);
        assert!((helix.base_angle(pressure) - base).abs() < 1e-15);
        assert!(Helix::SPUR.lead(0.05).is_infinite() && Helix::SPUR.is_spur());
    }

    #[test]
    fn angles_out_of_range_are_refused() {
        for angle in [-0.1, 1.1, f64::NAN] {
            assert_eq!(Helix::new(angle, Hand::Left).unwrap_err().code, "E0622");
        }
    }
}
