//! Derivatives by differences of two widths, extrapolated (Richardson), with estimated errors.

use calyx_model::observed::Observed;

/// Relative rounding error of a value of an output: some thousand roundings, because a contact
/// problem amplifies them by its condition.
const ROUNDING: f64 = 1e-13;
/// Difference of the derivatives of both sides, relative to the larger, above which the output has
/// a kink.
const KINK: f64 = 1e-3;

/// Ratio of that difference to the noise of the derivatives, above which the output has a kink.
const NOISE: f64 = 20.0;

/// Values of an output next to the value of the param: the value, and the smallest value of a
/// range.
type Ends = [f64; 2];

/// Values of the param at which the model is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stencil {
    value: f64,
    width: f64,
    side: Side,
}

/// Side of the value of a param on which differences were taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Both sides.
    Both,
    /// Smaller values only, because larger ones are out of range.
    Below,
    /// Larger values only, because smaller ones are out of range.
    Above,
}

/// Derivative of an output with respect to a param, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derivative {
    /// Derivatives towards smaller and towards larger values of the param. They differ at a kink,
    /// such as the load at which a tooth pair comes into contact.
    pub sides: [f64; 2],
    /// The same of the smallest value, if the output is a range ([`Observed::least`]).
    pub(crate) least: [f64; 2],
    /// Estimated error.
    pub error: f64,
    /// Part of the estimated error that is due to rounding.
    pub(crate) rounding: f64,
}

impl Derivative {
    /// Creates a derivative without a kink.
    pub(crate) fn smooth(value: f64, error: f64) -> Derivative {
        Derivative { sides: [value; 2], least: [value; 2], error, rounding: 0.0 }
    }

    /// Returns all numbers, for storage.
    pub fn to_array(self) -> [f64; 6] {
        let Derivative { sides: [below, above], least: [least_below, least_above], error, rounding } = self;
        [below, above, least_below, least_above, error, rounding]
    }

    /// Returns the derivative of the numbers of [`Derivative::to_array`].
    pub fn from_array([below, above, least_below, least_above, error, rounding]: [f64; 6]) -> Derivative {
        Derivative { sides: [below, above], least: [least_below, least_above], error, rounding }
    }

    /// Returns the derivative, at a kink the mean of both sides.
    pub fn value(&self) -> f64 {
        0.5 * (self.sides[0] + self.sides[1])
    }

    /// Returns whether the derivatives of the two sides differ.
    pub fn is_kink(&self) -> bool {
        let [below, above] = self.sides;
        below != above && !below.is_nan()
    }

    pub(crate) fn magnitude(&self) -> f64 {
        self.sides[0].abs().max(self.sides[1].abs())
    }

    pub(crate) fn is_better_than(&self, other: &Derivative) -> bool {
        if other.is_kink() && !self.is_kink() {
            // Narrow differences show whether a kink of wide ones lies at the value itself, unless
            // their noise hides it.
            return NOISE * self.error < (other.sides[1] - other.sides[0]).abs();
        }
        other.error.is_nan() || self.error < other.error
    }
}

impl Stencil {
    /// Creates the stencil of a half width; `None` if the range has no room on either side, or the
    /// width is below the rounding of the value.
    pub fn new(value: f64, width: f64, [low, high]: [f64; 2]) -> Option<Stencil> {
        let side = match (value - width >= low, value + width <= high) {
            (true, true) => Side::Both,
            (true, false) => Side::Below,
            (false, true) => Side::Above,
            (false, false) => return None,
        };
        let is_wide = width > 1e3 * f64::EPSILON * value.abs();
        is_wide.then_some(Stencil { value, width, side })
    }

    /// Returns the half width, SI.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Returns the values of the param.
    pub fn values(&self) -> Vec<f64> {
        let (value, width) = (self.value, self.width);
        match self.side {
            Side::Both => vec![value - width, value - 0.5 * width, value + 0.5 * width, value + width],
            Side::Below => vec![value - width, value - 0.5 * width, value - 0.25 * width],
            Side::Above => vec![value + width, value + 0.5 * width, value + 0.25 * width],
        }
    }

    /// Returns the derivatives of outputs from their values at the param and, for each of
    /// [`Stencil::values`], beside it; `None` where the state of contact could not be kept.
    pub fn derivatives(&self, at: &[Observed], beside: &[Option<Vec<Observed>>]) -> Vec<Derivative> {
        let ends = |observed: &Observed| [observed.value, observed.least.unwrap_or(observed.value)];
        let derivative = |(output, at): (usize, &Observed)| {
            let samples: Option<Vec<Ends>> =
                beside.iter().map(|row| Some(ends(row.as_ref()?.get(output)?))).collect();
            let Some(samples) = samples else {
                return Derivative::smooth(f64::NAN, f64::NAN);
            };
            let [value, least] = [0, 1].map(|end| {
                let of: Vec<f64> = samples.iter().map(|ends| ends[end]).collect();
                self.derivative(ends(at)[end], &of)
            });
            Derivative {
                least: least.sides,
                error: value.error.max(least.error),
                rounding: value.rounding.max(least.rounding),
                ..value
            }
        };
        at.iter().enumerate().map(derivative).collect()
    }

    /// Returns the derivative of a value from samples at [`Stencil::values`].
    fn derivative(&self, at: f64, samples: &[f64]) -> Derivative {
        let width = self.width;
        let largest = samples.iter().fold(at.abs(), |most, value| most.max(value.abs()));
        let rounding = 4.0 * ROUNDING * largest / width;
        match (self.side, samples) {
            (Side::Both, &[far_below, below, above, far_above]) => {
                let wide = (far_above - far_below) / (2.0 * width);
                let narrow = (above - below) / width;
                let extrapolated = (4.0 * narrow - wide) / 3.0;
                // Differences of second order of each side agree up to the third power of the
                // width if the output is smooth.
                let from_below = (3.0 * at - 4.0 * below + far_below) / width;
                let from_above = (4.0 * above - far_above - 3.0 * at) / width;
                let apart = (from_above - from_below).abs();
                let error = (narrow - wide).abs() + rounding;
                // Central differences of any width are equal at a kink at the value itself. A kink
                // beside it, or noise, shows in their difference.
                let noise = rounding.max((narrow - wide).abs());
                let one_sided = |near: f64, far: f64| 2.0 * (2.0 * (near - at) - (far - at)).abs() / width;
                let bends = one_sided(below, far_below) + one_sided(above, far_above);
                // A smooth output that bends strongly has no kink.
                let is_kink = apart > KINK * from_below.abs().max(from_above.abs());
                if is_kink && apart > NOISE * noise && apart > bends {
                    let error = 0.5 * bends + rounding;
                    let sides = [from_below, from_above];
                    return Derivative { sides, least: sides, error, rounding };
                }
                Derivative { rounding, ..Derivative::smooth(extrapolated, error) }
            }
            (side, &[far, middle, near]) => {
                let sign = if side == Side::Below { -1.0 } else { 1.0 };
                let slopes = [(far, 1.0), (middle, 0.5), (near, 0.25)];
                let [far, middle, near] = slopes.map(|(value, part)| sign * (value - at) / (part * width));
                let [wide, narrow] = [2.0 * middle - far, 2.0 * near - middle];
                let error = (narrow - wide).abs() + 4.0 * rounding;
                let value = (4.0 * narrow - wide) / 3.0;
                Derivative { rounding: 4.0 * rounding, ..Derivative::smooth(value, error) }
            }
            _ => Derivative::smooth(f64::NAN, f64::NAN),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small slope with a strong bend is no kink.
    #[test]
    fn bends_are_no_kinks() {
        let found =
            differentiated(|x| 1e-4 * x + (x - 0.7).powi(2) + 9.0 * (x - 0.7).powi(3), 0.7, 1e-3, UNBOUNDED);
        assert!(!found.is_kink(), "{found:?}");
    }

    fn differentiated(function: impl Fn(f64) -> f64, value: f64, width: f64, range: [f64; 2]) -> Derivative {
        let stencil = Stencil::new(value, width, range).unwrap();
        let beside: Vec<_> =
            stencil.values().into_iter().map(|at| Some(vec![Observed::number(function(at))])).collect();
        stencil.derivatives(&[Observed::number(function(value))], &beside)[0]
    }

    const UNBOUNDED: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    #[test]
    fn smooth_functions_are_differentiated_within_the_estimated_error() {
        for (range, accurate) in [(UNBOUNDED, 1e-10), ([0.7, 2.0], 1e-7), ([0.0, 0.7], 1e-7)] {
            for function in [f64::sin, f64::exp, f64::sqrt] {
                let exact = match function(0.49) {
                    value if value == 0.49f64.sin() => 0.7f64.cos(),
                    value if value == 0.49f64.exp() => 0.7f64.exp(),
                    _ => 0.5 / 0.7f64.sqrt(),
                };
                let found = differentiated(function, 0.7, 1e-3, range);
                let error = (found.value() - exact).abs();
                assert!(!found.is_kink() && error <= found.error && error <= accurate, "{found:?} {exact}");
            }
        }
    }

    #[test]
    fn a_kink_at_the_value_has_two_sides() {
        let found = differentiated(|x| if x < 1.0 { 2.0 * x } else { 3.0 * x - 1.0 }, 1.0, 1e-3, UNBOUNDED);
        assert!(found.is_kink());
        assert!((found.sides[0] - 2.0).abs() < 1e-9 && (found.sides[1] - 3.0).abs() < 1e-9, "{found:?}");
    }

    #[test]
    fn noise_of_narrow_differences_does_not_hide_a_kink() {
        let kink = Derivative { sides: [2.0, 3.0], error: 1e-6, ..Derivative::smooth(0.0, 0.0) };
        assert!(!Derivative::smooth(2.5, 0.1).is_better_than(&kink));
        assert!(Derivative::smooth(2.0, 1e-3).is_better_than(&kink), "the kink is next to the value");
        assert!(kink.is_better_than(&Derivative::smooth(f64::NAN, f64::NAN)));
    }

    #[test]
    fn an_output_that_does_not_depend_on_the_param_is_exact_up_to_rounding() {
        let found = differentiated(|_| 3.7, 1.0, 1e-3, UNBOUNDED);
        assert!(found.value() == 0.0 && found.error <= found.rounding, "{found:?}");
    }

    #[test]
    fn without_room_in_the_range_there_is_no_stencil() {
        assert_eq!(Stencil::new(1.0, 0.1, [1.0, 1.0]), None);
        assert_eq!(Stencil::new(1.0, 1e-17, UNBOUNDED), None);
    }
}
