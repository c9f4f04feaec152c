//! Methods from velocities to sound.

/// Method from velocities to sound.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SoundMethod {
    /// Equivalent radiated power: plane waves everywhere.
    EquivalentPower,
    /// Rayleigh integral: every part of the surface radiates as in a plane baffle, and all
    /// interfere.
    Rayleigh,
    /// Boundary elements.
    #[default]
    BoundaryElements,
}

impl SoundMethod {
    /// Returns the name in models and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EquivalentPower => "erp",
            Self::Rayleigh => "rayleigh",
            Self::BoundaryElements => "boundary_elements",
        }
    }
}
