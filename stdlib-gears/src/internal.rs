//! Internal gears with involute flanks, as far as closed forms go: a tooth is what a space of an external gear of the
//! same involutes leaves.

use crate::involute::{involute, involute_of_roll, radius_at_roll, roll_at_radius, roll_of_involute};
use calyx_abi::math;
use std::f64::consts::{FRAC_PI_2, PI};

/// An internal gear. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InternalGear {
    /// Number of teeth.
    pub teeth: u32,
    /// m
    pub module: f64,
    /// rad.
    pub pressure_angle: f64,
    /// Transverse circular thickness at the pitch circle, m.
    pub tooth_thickness: f64,
    /// Radius of the circle through the tips, m.
    pub minor_radius: f64,
}

impl InternalGear {
    /// m
    pub fn pitch_radius(&self) -> f64 {
        0.5 * f64::from(self.teeth) * self.module
    }

    /// m
    pub fn base_radius(&self) -> f64 {
        self.pitch_radius() * math::cos(self.pressure_angle)
    }

    /// Half the angle that the two involutes beside a space enclose at the base circle, rad.
    pub fn half_base_angle_of_space(&self) -> f64 {
        0.5 * (PI * self.module - self.tooth_thickness) / self.pitch_radius() + involute(self.pressure_angle)
    }

    /// Circular thickness of the tooth at a radius not below the base circle, m.
    pub fn thickness_at(&self, radius: f64) -> f64 {
        let half_space =
            self.half_base_angle_of_space() - involute_of_roll(roll_at_radius(self.base_radius(), radius));
        2.0 * radius * (PI / f64::from(self.teeth) - half_space)
    }

    /// Measurement between two pins in spaces as nearly opposite as there are, m.
    pub fn between_pins(&self, pin_diameter: f64) -> f64 {
        let base_radius = self.base_radius();
        let value = self.half_base_angle_of_space() - 0.5 * pin_diameter / base_radius;
        let centre = radius_at_roll(base_radius, roll_of_involute(value));
        let odd = if self.teeth % 2 == 1 { math::cos(FRAC_PI_2 / f64::from(self.teeth)) } else { 1.0 };
        2.0 * centre * odd - pin_diameter
    }
}
