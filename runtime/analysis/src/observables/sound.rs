//! Observables of the sound that elastic bodies radiate at the speed of the model.

use super::{Equilibrium, Observable, Quantity};
use crate::radiated_sound::{self, JoinedRequests, RadiatedSound, Weighting};
use calyx_acoustics::levels::sound_power_level;
use calyx_model::observed::Observed;

/// Lines of the response that count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SoundLines {
    /// All lines.
    All,
    /// A harmonic of all mesh frequencies, without sidebands.
    Harmonic(usize),
}

impl SoundLines {
    fn harmonic(self) -> Option<usize> {
        match self {
            SoundLines::All => None,
            SoundLines::Harmonic(harmonic) => Some(harmonic),
        }
    }

    /// Returns the weighted power of these lines at the speed of the model, W, or the contribution
    /// of a panel to it; NaN without a result.
    fn power(
        self,
        at: &Equilibrium<'_>,
        (sound, panel): (usize, Option<usize>),
        weighting: Weighting,
    ) -> f64 {
        let Some(all) = radiated_sound::of_system(at.system) else { return f64::NAN };
        let Some(found) = all.result(sound) else { return f64::NAN };
        let is_selected = |line: usize| match self {
            SoundLines::All => true,
            SoundLines::Harmonic(harmonic) => all.harmonics.get(line) == Some(&Some(harmonic)),
        };
        match panel {
            None => found.power_of(&found.own, weighting, is_selected),
            Some(panel) => found.panel_power_of(&found.own, panel, weighting, is_selected),
        }
    }
}

/// Sound power of a body, W.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoundPower {
    /// Index of the request of the scene.
    pub sound: usize,
    /// Index of the panel of the body whose contribution counts; `None` for all of the surface.
    pub panel: Option<usize>,
    /// Lines that count.
    pub lines: SoundLines,
}

impl Observable for SoundPower {
    fn is_of_forced_response(&self) -> bool {
        true
    }

    fn harmonic(&self) -> Option<usize> {
        self.lines.harmonic()
    }

    fn quantity(&self) -> Quantity {
        Quantity::repeating("radiated_power", "W")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(self.lines.power(at, (self.sound, self.panel), Weighting::None))
    }

    fn bounds(&self) -> [f64; 2] {
        // A panel can absorb sound of others.
        [if self.panel.is_some() { f64::NEG_INFINITY } else { 0.0 }, f64::INFINITY]
    }
}

/// Sound power level of a body, dB re 1 pW.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoundPowerLevel {
    /// Index of the request of the scene.
    pub sound: usize,
    /// Index of the panel of the body whose contribution counts; `None` for all of the surface.
    pub panel: Option<usize>,
    /// Lines that count.
    pub lines: SoundLines,
    /// Weighting of frequencies.
    pub weighting: Weighting,
}

impl Observable for SoundPowerLevel {
    fn is_of_forced_response(&self) -> bool {
        true
    }

    fn harmonic(&self) -> Option<usize> {
        self.lines.harmonic()
    }

    fn quantity(&self) -> Quantity {
        Quantity::repeating("sound_power_level", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        Observed::number(sound_power_level(self.lines.power(at, (self.sound, self.panel), self.weighting)))
    }
}

/// Returns a value of a sound at the speed of the model; NaN without a result.
fn own(
    at: &Equilibrium<'_>,
    sound: usize,
    value: impl Fn(&RadiatedSound, &JoinedRequests) -> Option<f64>,
) -> Observed {
    let found = radiated_sound::of_system(at.system);
    let value = found.and_then(|all| value(all.result(sound)?, &all.requests));
    Observed::number(value.unwrap_or(f64::NAN))
}

/// Radiation efficiency of a body: sound power over equivalent radiated power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiationEfficiency(pub usize);

impl Observable for RadiationEfficiency {
    fn is_of_forced_response(&self) -> bool {
        true
    }

    fn quantity(&self) -> Quantity {
        Quantity::repeating("radiation_efficiency", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        own(at, self.0, |sound, _| Some(sound.efficiency(&sound.own)))
    }

    fn bounds(&self) -> [f64; 2] {
        [0.0, f64::INFINITY]
    }
}

/// Sound pressure level of a body at a point, dB re 20 uPa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoundPressureLevel {
    /// Index of the request of the scene.
    pub sound: usize,
    /// Index of the point of the request.
    pub point: usize,
    /// Weighting of frequencies.
    pub weighting: Weighting,
}

impl Observable for SoundPressureLevel {
    fn is_of_forced_response(&self) -> bool {
        true
    }

    fn quantity(&self) -> Quantity {
        Quantity::repeating("sound_pressure_level", "1")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        own(at, self.sound, |sound, requests| {
            let point = requests.point(self.sound, self.point)?;
            Some(sound.pressure_level(&sound.own, point, self.weighting))
        })
    }
}

/// Mean sound pressure level on a field mesh, dB re 20 uPa, or the sound power level that it gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoundFieldLevel {
    /// Index of the request of the scene.
    pub sound: usize,
    /// Index of the field mesh of the request.
    pub field: usize,
    /// Weighting of frequencies.
    pub weighting: Weighting,
    /// True for the sound power level of the enveloping surface method.
    pub is_power: bool,
}

impl Observable for SoundFieldLevel {
    fn is_of_forced_response(&self) -> bool {
        true
    }

    fn quantity(&self) -> Quantity {
        Quantity::repeating(
            if self.is_power { "measured_sound_power_level" } else { "mean_sound_pressure_level" },
            "1",
        )
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        own(at, self.sound, |sound, requests| {
            let field = requests.field(self.sound, self.field)?;
            Some(match self.is_power {
                true => sound.measured_power_level(field, self.weighting),
                false => sound.field_level(field, self.weighting),
            })
        })
    }
}
