//! Fluid around the radiating body.

use crate::error::AcousticError;

/// Homogeneous fluid at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fluid {
    /// Density, kg/m³.
    pub density: f64,
    /// Speed of sound, m/s.
    pub speed_of_sound: f64,
}

impl Fluid {
    /// Dry air at 20 °C and 101.325 kPa.
    pub const AIR: Self = Self { density: 1.204, speed_of_sound: 343.2 };
    /// Fresh water at 20 °C.
    pub const WATER: Self = Self { density: 998.2, speed_of_sound: 1482.0 };

    /// Returns the name of a known fluid.
    pub fn name(&self) -> Option<&'static str> {
        [(Self::AIR, "air"), (Self::WATER, "water")]
            .into_iter()
            .find(|(fluid, _)| fluid == self)
            .map(|(_, name)| name)
    }

    /// Returns the characteristic impedance ρc, Pa·s/m.
    pub fn impedance(&self) -> f64 {
        self.density * self.speed_of_sound
    }

    /// Returns the wavenumber k = ω/c at a frequency in Hz, 1/m.
    ///
    /// # Errors
    /// The frequency, density or speed of sound is not positive and finite.
    pub fn wavenumber(&self, frequency: f64) -> Result<f64, AcousticError> {
        for (name, value) in
            [("frequency", frequency), ("density", self.density), ("speed of sound", self.speed_of_sound)]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(AcousticError::input(
                    format!("the {name} is {value}"),
                    format!("state a {name} that is positive and finite"),
                ));
            }
        }
        Ok(std::f64::consts::TAU * frequency / self.speed_of_sound)
    }
}
