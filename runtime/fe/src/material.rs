//! Linear elastic, isotropic materials, and the assumption of plane models.

use calyx_numerics::error::EngineError;

/// Linear elastic, isotropic material. SI units (Pa, kg/m³).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν, 0 <= ν < 0.5.
    pub poissons_ratio: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
}

/// Assumption of a two-dimensional model about the direction normal to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// Plane strain: no normal strain, for a wide face.
    Strain,
    /// Plane stress: no normal stress, for a thin disc.
    Stress,
}

impl Material {
    /// Common steel: 206 GPa, 0.3, 7850 kg/m³.
    pub const STEEL: Material = Material { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7850.0 };

    /// Creates a material after a check of its constants: E in Pa, ν, ρ in kg/m³.
    ///
    /// # Errors
    /// E0660: Young's modulus is not positive; E0661: Poisson's ratio is negative or not below 0.5;
    /// E0662: the density is negative.
    pub fn new(youngs_modulus: f64, poissons_ratio: f64, density: f64) -> Result<Material, EngineError> {
        let refusal = |code, argument, message: &str, help: &str| {
            Err(EngineError::new(code, message, help).blame(argument))
        };
        if !(youngs_modulus > 0.0 && youngs_modulus.is_finite()) {
            return refusal(
                "E0660",
                "youngs_modulus",
                "Young's modulus must be positive",
                "steel has about 206 GPa, or 3e7 psi",
            );
        }
        if !(0.0..0.5).contains(&poissons_ratio) {
            return refusal(
                "E0661",
                "poissons_ratio",
                "Poisson's ratio must be at least 0 and less than 0.5",
                "steel has 0.3",
            );
        }
        if !(density >= 0.0 && density.is_finite()) {
            return refusal("E0662", "density", "the density cannot be negative", "steel has 7850 kg/m^3");
        }
        Ok(Material { youngs_modulus, poissons_ratio, density })
    }

    /// Returns E', the modulus of the surface of a half-plane: E / (1 - ν²) in plane strain, E in
    /// plane stress. Two bodies in contact have 1/E* = 1/E'1 + 1/E'2 (Johnson, Contact Mechanics,
    /// eq. 4.5).
    pub fn surface_modulus(&self, plane: Plane) -> f64 {
        match plane {
            Plane::Strain => self.youngs_modulus / (1.0 - self.poissons_ratio * self.poissons_ratio),
            Plane::Stress => self.youngs_modulus,
        }
    }
}
