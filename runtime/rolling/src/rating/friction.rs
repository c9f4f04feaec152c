//! Friction torque by the model of Palmgren.

use crate::error::{RollingError, finite, positive};
use libm::pow;

/// Coefficients of the friction torque.
///
/// Source: Harris and Kotzalas, Essential Concepts of Bearing Technology (2007), chapter 10. They
/// depend on the type of the bearing and on its lubrication; those here are for oil bath
/// lubrication.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionCoefficients {
    /// Coefficient f₀ of the torque without load.
    pub viscous: f64,
    /// Coefficient f₁ of the torque of the load.
    pub load: f64,
}

impl FrictionCoefficients {
    /// Deep groove ball bearings, under about a tenth of their static load rating.
    pub const DEEP_GROOVE_BALL: Self = Self { viscous: 2.0, load: 2.5e-4 };
    /// Angular contact ball bearings.
    pub const ANGULAR_CONTACT_BALL: Self = Self { viscous: 3.3, load: 4.7e-4 };
    /// Cylindrical roller bearings with cage.
    pub const CYLINDRICAL_ROLLER: Self = Self { viscous: 2.0, load: 3e-4 };
    /// Needle roller bearings.
    pub const NEEDLE_ROLLER: Self = Self { viscous: 12.0, load: 1.5e-3 };
    /// Tapered roller bearings.
    pub const TAPERED_ROLLER: Self = Self { viscous: 4.0, load: 4e-4 };
    /// Spherical roller bearings.
    pub const SPHERICAL_ROLLER: Self = Self { viscous: 4.0, load: 5e-4 };
}

/// Friction torque of a bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction {
    /// Torque of the lubricant, independent of the load, N m.
    pub viscous: f64,
    /// Torque of the load, N m.
    pub load: f64,
}

impl Friction {
    /// Returns the sum of both torques, N m.
    pub fn torque(&self) -> f64 {
        self.viscous + self.load
    }
}

/// Computes the friction torque from pitch diameter, m, load, N, angular speed, rad/s, and
/// kinematic viscosity of the oil at its operating temperature, m²/s.
///
/// Palmgren (1957): the viscous torque is f₀ (ν n)^{2/3} d_m³ · 10⁻⁷ N mm with mm²/s, 1/min and mm,
/// and that of ν n = 2000 mm²/s/min below this product; the torque of the load is f₁ P d_m. A
/// bearing at rest has no viscous torque.
///
/// # Errors
/// [`RollingError::Input`] if an input is not finite or not positive where it must be.
pub fn friction(
    coefficients: &FrictionCoefficients,
    pitch_diameter: f64,
    load: f64,
    speed: f64,
    viscosity: f64,
) -> Result<Friction, RollingError> {
    positive("pitch diameter", pitch_diameter)?;
    positive("viscosity", viscosity)?;
    finite("load", load)?;
    finite("speed", speed)?;
    let rotations = speed.abs() * 30.0 / std::f64::consts::PI;
    let product = (1e6 * viscosity * rotations).max(2000.0);
    let diameter = 1e3 * pitch_diameter;
    let viscous = if speed == 0.0 {
        0.0
    } else {
        1e-10 * coefficients.viscous * pow(product, 2.0 / 3.0) * diameter * diameter * diameter
    };
    Ok(Friction { viscous, load: coefficients.load * load.abs() * pitch_diameter })
}
