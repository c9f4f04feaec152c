//! The shaper cutter, a pinion-shaped tool that generates the tooth spaces of internal gears.

use crate::error::{GeometryError, sentence};
use crate::rack::check_tool;
use calyx_abi::math;
use std::f64::consts::PI;

/// Shaper cutter with involute flanks and rounded tooth tips. SI units. The thickness of its teeth
/// follows from the gear that it generates, because sharpening changes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaper {
    /// Number of teeth.
    pub teeth: u32,
    /// Transverse module, m.
    pub module: f64,
    /// Transverse pressure angle at the reference circle, rad.
    pub pressure_angle: f64,
    /// Addendum of the cutter: distance from its reference circle to its tips, m.
    pub addendum: f64,
    /// Tip radius in the transverse plane, m. Zero is a sharp corner.
    pub tip_radius: f64,
}

impl Shaper {
    /// Default addendum of a shaper cutter, in modules.
    pub const USUAL_ADDENDUM: f64 = 1.25;

    /// Creates a shaper cutter. Whether it fits depends on the gear and is checked with it.
    ///
    /// # Errors
    /// E0601 to E0603, as for a rack. E0624: too few teeth, or an addendum that is not positive.
    pub fn new(
        teeth: u32,
        module: f64,
        pressure_angle: f64,
        addendum: f64,
        tip_radius: f64,
    ) -> Result<Self, GeometryError> {
        check_tool("shaper", module, pressure_angle, tip_radius)?;
        if !(4..=100_000).contains(&teeth) {
            return Err(GeometryError::error(
                "E0624",
                "teeth",
                sentence!["a shaper of ", number f64::from(teeth), " teeth"],
                sentence![
                    "give the cutter's number of teeth, 4 at least and fewer than those of the gear it cuts"
                ],
            ));
        }
        if !(addendum > 0.0 && addendum.is_finite()) {
            return Err(GeometryError::error(
                "E0624",
                "addendum",
                sentence!["the shaper's addendum is ", length addendum],
                sentence!["give the height of its teeth above its reference circle, usually ", length 1.25 * module],
            ));
        }
        Ok(Self { teeth, module, pressure_angle, addendum, tip_radius })
    }

    /// Pitch at the reference circle, m.
    pub fn pitch(&self) -> f64 {
        PI * self.module
    }

    /// Reference radius, m.
    pub fn reference_radius(&self) -> f64 {
        0.5 * f64::from(self.teeth) * self.module
    }

    /// Base radius, m.
    pub fn base_radius(&self) -> f64 {
        self.reference_radius() * math::cos(self.pressure_angle)
    }

    /// Tip radius of the cutter, m.
    pub fn outer_radius(&self) -> f64 {
        self.reference_radius() + self.addendum
    }

    /// Tooth thickness of an internal gear at the pitch circle with this profile shift coefficient,
    /// `m (pi/2 - 2 x tan(alpha))`, m. As for an external gear, a positive shift moves the teeth
    /// outwards.
    pub fn thickness_of_shift(&self, profile_shift: f64) -> f64 {
        self.module * (0.5 * PI - 2.0 * profile_shift * math::tan(self.pressure_angle))
    }

    /// Profile shift coefficient of a tooth thickness; the inverse of
    /// [`Shaper::thickness_of_shift`].
    pub fn shift_of_thickness(&self, tooth_thickness: f64) -> f64 {
        (0.5 * PI - tooth_thickness / self.module) / (2.0 * math::tan(self.pressure_angle))
    }
}
