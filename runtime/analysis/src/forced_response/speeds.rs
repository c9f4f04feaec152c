//! Solution of a prepared response at each speed, with the motion of surfaces that radiate sound.

use super::quantities::Measure;
use super::{CAUTION, ForcedPoint, ResponseLine, singular};
use crate::radiated_sound::{Lines, RadiatedSound, SoundModels, SoundTask, SurfaceMotion};
use calyx_model::ids::BearingId;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_solve::forced_response::{
    Amplitudes, ForcedVibration, LinearQuantity, Motion, PeriodicSystem, Response,
};
use calyx_solve::system::System;
use nalgebra::{Complex, DVector};
use rayon::prelude::*;

/// Response that is prepared for all speeds.
pub(super) struct Prepared<'a> {
    /// Vibrations with all positions and with every second one.
    pub vibrations: [ForcedVibration; 2],
    /// Phases of the first position by line, rad.
    pub phases: Vec<f64>,
    /// Spectral lines.
    pub lines: &'a [ResponseLine],
    /// Quantities.
    pub measures: &'a [Measure],
    /// Speed of the model, rad/s.
    pub own: f64,
}

/// Prepares a vibration, with all coordinates if sound needs them.
pub(super) fn vibration(
    system: &PeriodicSystem,
    quantities: &[LinearQuantity],
    (highest, with_sound): (f64, bool),
) -> Result<ForcedVibration, EngineError> {
    let vibration = match with_sound {
        true => ForcedVibration::with_coordinates(system, quantities, highest),
        false => ForcedVibration::new(system, quantities, highest),
    };
    vibration.ok_or_else(singular)
}

impl Prepared<'_> {
    /// Solves all speeds (rad/s), and the sound if there are models.
    ///
    /// # Errors
    /// Those of the sound and of the interrupt.
    pub fn solve(
        &self,
        system: &System<'_>,
        mut speeds: Vec<f64>,
        (sound, task): (Option<SoundModels>, &SoundTask<'_>),
        resources: &Resources,
    ) -> Result<(Vec<ForcedPoint>, Vec<RadiatedSound>), EngineError> {
        let count = speeds.len();
        speeds.extend(sound.is_some().then_some(self.own));
        let point = |&speed: &f64| {
            resources.interrupt.check()?;
            Ok::<_, EngineError>(self.point(speed, sound.as_ref()))
        };
        let all = || speeds.par_iter().map(point).collect::<Result<Vec<_>, _>>();
        let (mut points, motions): (Vec<ForcedPoint>, Vec<Vec<SurfaceMotion>>) =
            resources.install(all)?.into_iter().unzip();
        points.truncate(count);
        let Some(sound) = sound else { return Ok((points, Vec::new())) };
        let orders: Vec<f64> = self.lines.iter().map(|line| line.order).collect();
        let harmonic = |line: &ResponseLine| Some(line.harmonic).filter(|&own| own > 0 && line.sideband == 0);
        let harmonics: Vec<Option<usize>> = self.lines.iter().map(harmonic).collect();
        let highest = task.highest_frequency;
        let lines = Lines { orders: &orders, harmonics: &harmonics, highest, caution: CAUTION };
        let sound = sound.finish(system, &lines, (&speeds, &motions), resources)?;
        Ok((points, sound.results.clone()))
    }

    /// Solves a speed, rad/s.
    fn point(&self, speed: f64, sound: Option<&SoundModels>) -> (ForcedPoint, Vec<SurfaceMotion>) {
        let ratio = speed / self.own;
        let [fine, coarse] = [0, 1].map(|k| self.response(&self.vibrations[k], ratio));
        let force = |bearing: BearingId, component: usize, line: usize| {
            let is_it = |measure: &Measure| match measure {
                Measure::BearingForce(other, axis) => *other == bearing && *axis == component,
                _ => false,
            };
            let index = self.measures.iter().position(is_it)?;
            fine.quantities.get(index)?.get(line).copied()
        };
        let frequencies: Vec<f64> = self.lines.iter().map(|line| line.order * speed).collect();
        let motions = match (sound, &fine.motion, &coarse.motion) {
            (Some(sound), Some(fine), Some(coarse)) => {
                let bodies = sound.vibrating().iter();
                bodies.map(|body| body.motion([fine, coarse], &force, &frequencies)).collect()
            }
            _ => Vec::new(),
        };
        let amplitudes = [&fine, &coarse].map(|response| &response.quantities[..]);
        (ForcedPoint::new(speed, amplitudes, self.vibrations[0].growth(ratio)), motions)
    }

    /// Returns the response at a ratio of the reference speed, NaN if there is none.
    fn response(&self, vibration: &ForcedVibration, ratio: f64) -> Response {
        let mut found = vibration.response(ratio).unwrap_or_else(|| unknown(vibration));
        let turn = |phase: &f64| Complex::from_polar(1.0, -phase);
        let turns: Vec<Complex<f64>> = self.phases.iter().map(turn).collect();
        for (value, turn) in found.quantities.iter_mut().flat_map(|values| values.iter_mut().zip(&turns)) {
            *value *= turn;
        }
        if let Some(motion) = &mut found.motion {
            for vectors in [&mut motion.displacements, &mut motion.damping_forces] {
                vectors.iter_mut().zip(&turns).for_each(|(own, turn)| *own *= *turn);
            }
        }
        found
    }
}

/// Returns a response of NaN.
fn unknown(vibration: &ForcedVibration) -> Response {
    let nothing = Complex::new(f64::NAN, f64::NAN);
    let values = |values: &Amplitudes| vec![nothing; values.len()];
    let rest = vibration.response(0.0).and_then(|response| response.motion);
    let of = |vectors: &[DVector<Complex<f64>>]| vectors.iter().map(|own| own.map(|_| nothing)).collect();
    Response {
        quantities: vibration.static_values().iter().map(values).collect(),
        motion: rest.map(|motion| Motion {
            displacements: of(&motion.displacements),
            damping_forces: of(&motion.damping_forces),
        }),
    }
}
