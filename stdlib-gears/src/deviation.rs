//! Flank deviations that a program gives as functions: measured profiles and custom relief shapes.
//!
//! The contact solver needs the tangent and curvature of the flank. Each gear therefore samples the
//! function once at [`SAMPLES`] equal steps of roll from the form circle to the tip circle and
//! interpolates it by a cubic spline with continuous second derivative. For a function with a
//! bounded fourth derivative, the error of the amounts is `5/384 h⁴` times that derivative, where
//! `h` is the step (de Boor, A Practical Guide to Splines, chapter V). A jump `J` of the second
//! derivative adds an error of about `J h²/30` near it.

use crate::error::{GeometryError, sentence};
use crate::gear::ToothForm;
use std::fmt;
use std::sync::Arc;

/// Number of steps between samples of a deviation.
pub const SAMPLES: usize = 512;

/// Function that returns the amount of material removed from a flank.
type Amount = dyn Fn(f64) -> f64 + Send + Sync;

/// A deviation of both flanks of every tooth, given as a function of the roll angle.
///
/// ```
/// use calyx_gears::blank::GearBlank;
/// use calyx_gears::deviation::Deviation;
/// use calyx_gears::rack::Rack;
///
/// let rack = Rack::new(2e-3, 20_f64.to_radians(), 0.6e-3)?;
/// // 3 µm of waviness, and a tip relief with the cube of the roll angle.
/// let measured = Deviation::new("flank 7", |roll| {
///     1.5e-6 * (1.0 - (60.0 * roll).cos()) + 20e-6 * ((roll - 0.45) / 0.15).max(0.0).powi(3)
/// });
/// let gear = GearBlank::standard(25, rack).modified(measured.into()).cut()?;
/// # Ok::<(), calyx_gears::error::Refusal>(())
/// ```
#[derive(Clone)]
pub struct Deviation {
    name: Arc<str>,
    amount: Arc<Amount>,
}

impl Deviation {
    /// Creates a deviation from a name for messages and a function from the roll angle (rad) to the
    /// amount (m) normal to the involute. Positive amounts remove material.
    ///
    /// The function is evaluated from the form circle to the tip circle. Its slope should be
    /// continuous. A continuous second derivative is better, because it is the curvature in the
    /// contact problem. Details finer than the samples are lost.
    pub fn new(name: impl Into<Arc<str>>, amount: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Deviation {
        Deviation { name: name.into(), amount: Arc::new(amount) }
    }

    /// Name in messages.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Material removed at a roll angle (rad), m.
    pub fn amount(&self, roll: f64) -> f64 {
        (self.amount)(roll)
    }

    /// Amounts on the flanks of a gear at equal steps of roll from the form circle to the tip
    /// circle, m.
    pub(crate) fn samples(&self, gear: &ToothForm) -> Vec<f64> {
        let step = Self::step(gear);
        (0..=SAMPLES).map(|sample| self.amount((gear.form_roll + step * sample as f64).abs())).collect()
    }

    fn step(gear: &ToothForm) -> f64 {
        (gear.tip_roll - gear.form_roll) / SAMPLES as f64
    }

    /// Samples the deviation on the flanks of a gear; `None` if it is zero everywhere.
    ///
    /// # Errors
    /// E0642: the amount is NaN or infinite at some point, reaches half of the tooth thickness, or
    /// moves an involute beyond its evolute.
    pub(crate) fn sampled(&self, gear: &ToothForm) -> Result<Option<CubicSpline>, GeometryError> {
        let amounts = self.samples(gear);
        let step = Self::step(gear);
        for (sample, &amount) in amounts.iter().enumerate() {
            self.check(gear, gear.form_roll + step * sample as f64, amount)?;
        }
        Ok(amounts
            .iter()
            .any(|&amount| amount != 0.0)
            .then(|| CubicSpline::new(gear.form_roll, step, amounts)))
    }

    fn check(&self, gear: &ToothForm, roll: f64, amount: f64) -> Result<(), GeometryError> {
        // Only on a convex flank can an amount exceed the radius of curvature.
        let radius_of_curvature = if gear.internal { f64::INFINITY } else { gear.base_radius * roll };
        let half_tooth = gear.half_angle_at_roll(roll) * gear.radius_at_roll(roll);
        let roll = roll.abs();
        let message = if !amount.is_finite() {
            sentence!["a flank deviation is not a finite number at a roll angle of ", angle roll]
        } else if amount.abs() >= half_tooth {
            sentence![
                "a flank deviation is ", length amount, " at a roll angle of ", angle roll, ", but half the tooth is only ",
                length half_tooth, " thick there"
            ]
        } else if amount >= radius_of_curvature {
            sentence![
                "a flank deviation takes off ", length amount, " at a roll angle of ", angle roll,
                ", where the flank's radius of curvature is only ", length radius_of_curvature
            ]
        } else {
            return Ok(());
        };
        let help = sentence!["give a finite amount in metres for every roll angle from ", angle gear.form_roll.abs(), " to ",
            angle gear.tip_roll.abs(), "; usual amounts are some hundredths of a millimetre"];
        Err(GeometryError::error("E0642", "modifications", message, help))
    }
}

impl fmt::Debug for Deviation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Deviation").field(&self.name).finish()
    }
}

/// Compares the identity of the function and the name.
impl PartialEq for Deviation {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name && Arc::ptr_eq(&self.amount, &other.amount)
    }
}

/// Cubic spline through equidistant samples with continuous second derivative.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CubicSpline {
    first: f64,
    step: f64,
    /// Values and second derivatives at the samples.
    values: Vec<f64>,
    bends: Vec<f64>,
}

impl CubicSpline {
    /// Interpolates `values` at `first`, `first + step` and so on; at least four values.
    pub fn new(first: f64, step: f64, values: Vec<f64>) -> Self {
        let last = values.len() - 1;
        // Second derivatives of adjacent samples satisfy b[i-1] + 4 b[i] + b[i+1] = 6 (second
        // difference) / h². The first two and the last two intervals share one cubic each
        // (not-a-knot), whose second derivative is linear: b[0] = 2 b[1] - b[2].
        let wanted = |i: usize| 6.0 * (values[i - 1] - 2.0 * values[i] + values[i + 1]) / (step * step);
        let mut bends = vec![0.0; last + 1];
        let mut ratios = vec![0.0; last + 1];
        bends[1] = wanted(1) / 6.0;
        for i in 2..last - 1 {
            ratios[i - 1] = if i == 2 { 0.0 } else { 1.0 / (4.0 - ratios[i - 2]) };
            let pivot = 4.0 - ratios[i - 1];
            bends[i] = (wanted(i) - bends[i - 1]) / pivot;
        }
        bends[last - 1] = wanted(last - 1) / 6.0;
        for i in (2..last - 1).rev() {
            ratios[i] = 1.0 / (4.0 - ratios[i - 1]);
            bends[i] -= ratios[i] * bends[i + 1];
        }
        bends[0] = 2.0 * bends[1] - bends[2];
        bends[last] = 2.0 * bends[last - 1] - bends[last - 2];
        Self { first, step, values, bends }
    }

    /// Value, first and second derivative. Beyond the samples the parabola continues.
    pub fn at(&self, x: f64) -> [f64; 3] {
        let last = self.values.len() - 1;
        let place = (x - self.first) / self.step;
        let piece = place.clamp(0.0, (last - 1) as f64).floor() as usize;
        let (h, within) = (self.step, (place - piece as f64).clamp(0.0, 1.0));
        let (before, after) = (1.0 - within, within);
        let [value, next] = [self.values[piece], self.values[piece + 1]];
        let [bend, next_bend] = [self.bends[piece], self.bends[piece + 1]];
        let third = h * h / 6.0;
        let at = [
            before * value
                + after * next
                + third * ((before.powi(3) - before) * bend + (after.powi(3) - after) * next_bend),
            (next - value) / h
                + h / 6.0 * ((1.0 - 3.0 * before * before) * bend + (3.0 * after * after - 1.0) * next_bend),
            before * bend + after * next_bend,
        ];
        let beyond = h * (place - piece as f64 - within);
        [at[0] + beyond * (at[1] + 0.5 * beyond * at[2]), at[1] + beyond * at[2], at[2]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_met_exactly_with_both_derivatives() {
        let cubic = |x: f64| [1.0 + x * (2.0 + x * (-3.0 + x)), 2.0 + x * (-6.0 + 3.0 * x), -6.0 + 6.0 * x];
        let values = (0..=10).map(|i| cubic(0.3 + 0.1 * f64::from(i))[0]).collect();
        let spline = CubicSpline::new(0.3, 0.1, values);
        for i in 0..=100 {
            let x = 0.3 + 0.01 * f64::from(i);
            let found = spline.at(x);
            for (found, known) in found.into_iter().zip(cubic(x)) {
                assert!((found - known).abs() < 1e-10, "{x}: {found} {known}");
            }
        }
        // Value and slope continue without a jump beyond the samples.
        let [inside, outside] = [0.3 - 1e-9, 0.3 + 1e-9].map(|x| spline.at(x));
        assert!((inside[0] - outside[0]).abs() < 1e-8 && (inside[2] - outside[2]).abs() < 1e-6);
    }

    #[test]
    fn the_error_of_a_smooth_function_falls_with_the_fourth_power() {
        let error = |count: usize| {
            let step = 1.0 / count as f64;
            let values = (0..=count).map(|i| (7.0 * step * i as f64).sin()).collect();
            let spline = CubicSpline::new(0.0, step, values);
            let at = |i: usize| i as f64 / 1000.0;
            (0..=1000).map(|i| (spline.at(at(i))[0] - (7.0 * at(i)).sin()).abs()).fold(0.0, f64::max)
        };
        let [coarse, fine] = [64, 128].map(error);
        assert!(fine < coarse / 13.0 && fine < 3e-7, "{coarse:e} {fine:e}");
    }
}
