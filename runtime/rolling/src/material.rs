//! Material of rings and rolling elements.

use crate::error::{RollingError, positive};

/// Isotropic elastic material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Density, kg/m³.
    pub density: f64,
}

impl Material {
    /// Bearing steel: 206 GPa, 0.3, 7800 kg/m³.
    pub const STEEL: Self = Self { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7800.0 };
    /// Silicon nitride, for the elements of hybrid bearings: 310 GPa, 0.27, 3200 kg/m³.
    pub const SILICON_NITRIDE: Self = Self { youngs_modulus: 310e9, poissons_ratio: 0.27, density: 3200.0 };

    /// Returns the plane strain modulus E / (1 - ν²), Pa.
    pub(crate) fn plane_strain_modulus(&self) -> f64 {
        self.youngs_modulus / (1.0 - self.poissons_ratio * self.poissons_ratio)
    }

    /// Checks the ranges of the constants.
    pub(crate) fn check(&self) -> Result<(), RollingError> {
        positive("Young's modulus", self.youngs_modulus)?;
        positive("density", self.density)?;
        if !(self.poissons_ratio > -1.0 && self.poissons_ratio <= 0.5) {
            return Err(RollingError::input(
                format!("Poisson's ratio of a rolling bearing is {}", self.poissons_ratio),
                "give a ratio above -1 and at most 0.5",
            ));
        }
        Ok(())
    }
}

/// Returns the composite modulus E* of a contact, Pa: 1/E* = (1-ν₁²)/E₁ + (1-ν₂²)/E₂.
pub fn composite_modulus(first: &Material, second: &Material) -> f64 {
    1.0 / (1.0 / first.plane_strain_modulus() + 1.0 / second.plane_strain_modulus())
}
