//! Methods from velocities to sound.

/// Method from velocities to sound.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SoundMethod {
    /// Equivalent radiated power: plane waves everywhere. It needs no equations.
    EquivalentPower,
    /// Rayleigh integral: every part of the surface radiates as in a plane baffle, and all
    /// interfere.
    Rayleigh,
    /// Boundary elements.
    #[default]
    BoundaryElements,
}

impl SoundMethod {
    /// All methods, the cheapest first.
    pub const ALL: [SoundMethod; 3] = [Self::EquivalentPower, Self::Rayleigh, Self::BoundaryElements];

    /// Returns the name in models and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EquivalentPower => "erp",
            Self::Rayleigh => "rayleigh",
            Self::BoundaryElements => "boundary_elements",
        }
    }

    /// Returns the method of a name.
    pub fn named(name: &str) -> Option<SoundMethod> {
        Self::ALL.into_iter().find(|method| method.name() == name)
    }
}
