//! Choice of the contact model of rollers.

/// Model of the contacts of rollers with raceways.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ContactModel {
    /// Laminae of ISO/TS 16281, which do not affect each other.
    #[default]
    Laminae,
    /// Elastic half-spaces, with the compliance of the roller's body and its free ends.
    Elastic(ElasticContact),
}

/// Settings of the elastic contact of rollers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticContact {
    /// Number of strips of a contact line.
    pub strips: usize,
    /// The roller ends at its end faces; if false, it is a half-space that extends beyond the
    /// contact line.
    pub free_ends: bool,
    /// The roller's body between both raceways is that of a cylinder; if false, it is that of
    /// half-spaces. Without free ends it has no effect.
    pub body: bool,
}

impl Default for ElasticContact {
    fn default() -> Self {
        Self { strips: 32, free_ends: true, body: true }
    }
}
