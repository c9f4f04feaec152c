//! Results of the sound of a vibrating surface.

use super::cases::CaseKind;
use crate::fluid::Fluid;
use crate::levels::{a_weighting, sound_power_level};
use crate::method::SoundMethod;
use calyx_numerics::vec3::Vector;
use faer::c64;

/// Surface that radiates.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceOfSound {
    /// Number of triangles of the mesh, with lids.
    pub triangles: usize,
    /// Least and largest number of triangles of the coarsened surfaces of all frequencies.
    pub coarse_triangles: [usize; 2],
    /// Area, m².
    pub area: f64,
    /// Edges of the box that contains the surface, m.
    pub edges: [f64; 3],
    /// Number of openings that lids close.
    pub lids: usize,
}

/// Sound of a vibrating surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceSound {
    /// Method.
    pub method: SoundMethod,
    /// Fluid.
    pub fluid: Fluid,
    /// Surface.
    pub surface: SurfaceOfSound,
    /// Points of the pressures, m.
    pub points: Vec<Vector>,
    /// Results in the order of the cases of the vibration.
    pub cases: Vec<CaseSound>,
    /// How the file was read and what was changed on the surface, in sentences.
    pub notes: Vec<String>,
    /// Reasons for doubt about the results, in sentences.
    pub warnings: Vec<String>,
}

/// Sound at a frequency, or of a normal mode.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseSound {
    /// Kind of the case.
    pub kind: CaseKind,
    /// Frequency, Hz.
    pub frequency: f64,
    /// Sound power, W.
    pub power: f64,
    /// Equivalent radiated power, W.
    pub equivalent_power: f64,
    /// Mean square of the normal velocity over time and surface, m²/s².
    pub mean_square_velocity: f64,
    /// Complex amplitudes of the pressure at the points, Pa; empty for modes, whose amplitude is
    /// arbitrary.
    pub pressures: Vec<c64>,
    /// Relative difference of the powers on the surface and in the far field; NaN without boundary
    /// elements.
    pub far_field_difference: f64,
}

impl CaseSound {
    /// Returns the sound power level, dB re 1 pW.
    pub fn level(&self) -> f64 {
        sound_power_level(self.power)
    }

    /// Returns the A-weighted sound power level, dB re 1 pW.
    pub fn a_weighted_level(&self) -> f64 {
        self.level() + a_weighting(self.frequency)
    }

    /// Returns the radiation efficiency: the power over that of plane waves of the same mean square
    /// velocity. NaN if the surface is at rest.
    pub fn efficiency(&self) -> f64 {
        self.power / self.equivalent_power
    }

    /// Returns the power per mean square of the normal velocity, W·s²/m². NaN if the surface is at
    /// rest.
    pub fn power_per_mean_square(&self) -> f64 {
        self.power / self.mean_square_velocity
    }
}
