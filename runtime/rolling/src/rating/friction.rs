//! Friction torque by the model of Palmgren.

use crate::ball::BallKind;
use crate::bearing::{Elements, RollingBearing, Row};
use crate::error::{RollingError, finite, positive};
use crate::roller::RollerKind;
use libm::{pow, tan};

/// Ratio of the length to the diameter of cylindrical rollers from which they are needles.
const NEEDLE: f64 = 3.0;

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
    /// Spherical roller bearings with two rows.
    pub const SPHERICAL_ROLLER: Self = Self { viscous: 4.0, load: 5e-4 };

    /// Returns the coefficients of a bearing by the type of its first row. The viscous torques of
    /// rows add up.
    pub fn of(bearing: &RollingBearing) -> Self {
        let rows = bearing.rows();
        let of_row = |row: &Row| match &row.elements {
            Elements::Balls(balls) => match balls.geometry().kind {
                BallKind::DeepGroove { .. } => Self::DEEP_GROOVE_BALL,
                BallKind::AngularContact { .. } | BallKind::FourPoint { .. } => Self::ANGULAR_CONTACT_BALL,
            },
            Elements::Rollers(rollers) => {
                let geometry = rollers.geometry();
                match geometry.kind {
                    RollerKind::Cylindrical { .. }
                        if geometry.length >= NEEDLE * geometry.roller_diameter =>
                    {
                        Self::NEEDLE_ROLLER
                    }
                    RollerKind::Cylindrical { .. } => Self::CYLINDRICAL_ROLLER,
                    RollerKind::Tapered { .. } => Self::TAPERED_ROLLER,
                    // The coefficient is that of two rows.
                    RollerKind::Spherical { .. } => {
                        let viscous = 0.5 * Self::SPHERICAL_ROLLER.viscous;
                        Self { viscous, ..Self::SPHERICAL_ROLLER }
                    }
                }
            }
        };
        let own = rows.first().map_or(Self { viscous: 0.0, load: 0.0 }, of_row);
        Self { viscous: rows.len() as f64 * own.viscous, ..own }
    }
}

/// Returns the force that determines the torque of the load, N, from the radial and the axial force
/// of a bearing, N: the larger one of the radial force and `0.9 F_a cot α - 0.1 F_r` of ball
/// bearings (`3 F_a - 0.1 F_r` of deep groove ones), or `0.8 F_a cot α` of roller bearings with a
/// contact angle α.
///
/// Source: Harris and Kotzalas, Essential Concepts of Bearing Technology (2007), chapter 10.
pub fn friction_load(bearing: &RollingBearing, [radial, axial]: [f64; 2]) -> f64 {
    let (radial, axial) = (radial.abs(), axial.abs());
    let of_row = |row: &Row| match &row.elements {
        Elements::Balls(balls) => match balls.geometry().kind {
            BallKind::DeepGroove { .. } => 3.0 * axial - 0.1 * radial,
            BallKind::AngularContact { angle } | BallKind::FourPoint { angle, .. } => {
                0.9 * axial / tan(angle) - 0.1 * radial
            }
        },
        Elements::Rollers(rollers) => match rollers.geometry().kind {
            RollerKind::Cylindrical { .. } => 0.0,
            RollerKind::Tapered { outer_angle: angle, .. } | RollerKind::Spherical { angle, .. } => {
                0.8 * axial / tan(angle)
            }
        },
    };
    bearing.rows().first().map_or(radial, |row| radial.max(of_row(row)))
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
