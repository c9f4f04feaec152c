//! The basic rack, whose teeth cut the gear's spaces by rolling on its pitch circle.

use crate::error::{GeometryError, sentence};
use calyx_abi::math;
use std::f64::consts::PI;

/// A basic rack with straight flanks and rounded tooth tips. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rack {
    /// Pitch diameter divided by number of teeth, m.
    pub module: f64,
    /// Inclination of the flanks, rad.
    pub pressure_angle: f64,
    /// Rounding of the tooth tip, m. Zero is a sharp corner.
    pub tip_radius: f64,
}

impl Rack {
    /// A rack, if its numbers make sense. (Whether the rounding fits depends on the gear that is cut.)
    pub fn new(module: f64, pressure_angle: f64, tip_radius: f64) -> Result<Self, GeometryError> {
        if !(module.is_finite() && module > 0.0) {
            return Err(GeometryError::error(
                "E0601",
                "module",
                sentence!["the module of the rack is ", length module],
                sentence!["give a positive `module`, or a positive `diametral_pitch`"],
            ));
        }
        let (least, most) = (5.0_f64.to_radians(), 45.0_f64.to_radians());
        if !(least..=most).contains(&pressure_angle) {
            return Err(GeometryError::error(
                "E0602",
                "pressure_angle",
                sentence!["the pressure angle is ", angle pressure_angle, ", not between ", angle least, " and ", angle most],
                sentence!["usual pressure angles are 14.5 deg, 20 deg and 25 deg; is a unit missing?"],
            ));
        }
        if !(tip_radius.is_finite() && tip_radius >= 0.0) {
            return Err(GeometryError::error(
                "E0603",
                "tip_radius",
                sentence!["the tip radius of the rack is ", length tip_radius],
                sentence!["give a radius of zero (a sharp corner) or more; ", length 0.3 * module, " (0.3 modules) is usual"],
            ));
        }
        Ok(Self { module, pressure_angle, tip_radius })
    }

    /// Pitch, from one tooth to the next, m.
    pub fn pitch(&self) -> f64 {
        PI * self.module
    }

    /// Thickness at the pitch circle of a gear cut with a profile shift, `m (pi/2 + 2 x tan(alpha))`, m.
    pub fn thickness_of_shift(&self, profile_shift: f64) -> f64 {
        self.module * (0.5 * PI + 2.0 * profile_shift * math::tan(self.pressure_angle))
    }

    /// The inverse of [`Rack::thickness_of_shift`].
    pub fn shift_of_thickness(&self, tooth_thickness: f64) -> f64 {
        (tooth_thickness / self.module - 0.5 * PI) / (2.0 * math::tan(self.pressure_angle))
    }
}
