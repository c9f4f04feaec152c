//! Linear elastic, isotropic materials, and how a plane section of them is held.

/// An isotropic material. SI units (Pa, kg/m³).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// E, in Pa.
    pub youngs_modulus: f64,
    /// ν, 0 <= ν < 0.5.
    pub poissons_ratio: f64,
    /// ρ, in kg/m³.
    pub density: f64,
}

/// What happens across the plane of a two-dimensional model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// No strain across: a wide face.
    Strain,
    /// No stress across: a thin disc.
    Stress,
}

impl Material {
    /// E', the modulus of a half-plane's surface: E / (1 - ν²) in plane strain, E in plane stress.
    /// Two bodies in contact have 1/E* = 1/E'1 + 1/E'2 (Johnson, Contact Mechanics, eq. 4.5).
    pub fn surface_modulus(&self, plane: Plane) -> f64 {
        match plane {
            Plane::Strain => self.youngs_modulus / (1.0 - self.poissons_ratio * self.poissons_ratio),
            Plane::Stress => self.youngs_modulus,
        }
    }
}
