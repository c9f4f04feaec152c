//! Derivatives of the statistics of outputs over the positions.

use super::Derivative;
use crate::rows::StepRow;

/// Difference of two positions, relative to the largest magnitude, at which both are the extreme.
const TIE: f64 = 1e-10;

/// Difference of the derivatives at such positions, relative to the larger, below which they are the
/// same: the discretization differs a little.
const SAME: f64 = 1e-5;

/// Derivatives of the statistics of an output with respect to a param, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatisticDerivatives {
    /// Of the smallest value.
    pub min: Derivative,
    /// Of the largest value.
    pub max: Derivative,
    /// Of the mean.
    pub mean: Derivative,
    /// Of the difference between the largest and the smallest value.
    pub peak_to_peak: Derivative,
}

impl StatisticDerivatives {
    /// Returns the derivatives of the statistics of a single value.
    pub(super) fn of_constant(derivative: &Derivative) -> StatisticDerivatives {
        let peak_to_peak = Derivative::smooth(0.0, 0.0);
        StatisticDerivatives { min: *derivative, max: *derivative, mean: *derivative, peak_to_peak }
    }
}

/// Returns the derivatives of the statistics by output from those by position and output, and from
/// those of the means.
pub(crate) fn of(
    rows: &[StepRow],
    derivatives: &[Vec<Derivative>],
    means: &[Derivative],
) -> Vec<StatisticDerivatives> {
    let of_output = |(output, &mean): (usize, &Derivative)| {
        let all: Vec<Derivative> = derivatives.iter().map(|row| row[output]).collect();
        let (max, min) = (extreme(rows, output, &all, true), extreme(rows, output, &all, false));
        let peak_to_peak = Derivative {
            sides: [0, 1].map(|side| max.sides[side] - min.sides[side]),
            least: [0.0; 2],
            error: max.error + min.error,
            rounding: max.rounding + min.rounding,
        };
        StatisticDerivatives { min, max, mean, peak_to_peak }
    };
    means.iter().enumerate().map(of_output).collect()
}

/// Returns the derivative of the largest or smallest value over the positions: that of the position
/// of the extreme. If several positions share it, the one that wins on each side.
fn extreme(rows: &[StepRow], output: usize, derivatives: &[Derivative], is_max: bool) -> Derivative {
    let sign = if is_max { 1.0 } else { -1.0 };
    // Values whose largest is wanted, with their derivatives.
    let values: Vec<(f64, [f64; 2], &Derivative)> = rows
        .iter()
        .zip(derivatives)
        .flat_map(|(row, derivative)| {
            let seen = &row.outputs[output];
            let least = seen.least.unwrap_or(seen.value);
            let of = |value: f64, sides: [f64; 2]| (sign * value, sides.map(|side| sign * side), derivative);
            [of(seen.value, derivative.sides), of(least, derivative.least)]
        })
        .collect();
    if values.iter().any(|(value, ..)| value.is_nan()) {
        return Derivative::smooth(f64::NAN, f64::NAN);
    }
    let largest = values.iter().map(|(value, ..)| *value).fold(f64::NEG_INFINITY, f64::max);
    let size = values.iter().map(|(value, ..)| value.abs()).fold(0.0, f64::max);
    let tied = || values.iter().filter(move |(value, ..)| *value >= largest - TIE * size);
    // Towards smaller values of the param, the smallest derivative gives the largest value.
    let below = tied().map(|(_, sides, _)| sides[0]).fold(f64::INFINITY, f64::min);
    let above = tied().map(|(_, sides, _)| sides[1]).fold(f64::NEG_INFINITY, f64::max);
    let most = |of: fn(&Derivative) -> f64| tied().map(|(.., one)| of(one)).fold(0.0, f64::max);
    let (error, rounding) = (most(|one| one.error), most(|one| one.rounding));
    let unknown = tied().any(|(_, sides, _)| sides[0].is_nan() || sides[1].is_nan());
    let [mut below, mut above] = if unknown { [f64::NAN; 2] } else { [sign * below, sign * above] };
    let apart = (above - below).abs();
    if apart <= error + SAME * below.abs().max(above.abs()) {
        // Positions that repeat each other, such as the first and the last of a cycle, are no kink.
        (below, above) = (0.5 * (below + above), 0.5 * (below + above));
        let error = error + 0.5 * apart;
        return Derivative { sides: [below, above], least: [0.0; 2], error, rounding };
    }
    Derivative { sides: [below, above], least: [0.0; 2], error, rounding }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_model::observed::Observed;
    use calyx_model::position::Position;

    fn rows(values: &[f64]) -> Vec<StepRow> {
        let row = |value: &f64| StepRow {
            position: Position::at(0.0),
            outputs: vec![Observed::number(*value)],
            warnings: Vec::new(),
        };
        values.iter().map(row).collect()
    }

    #[test]
    fn the_derivative_of_a_maximum_is_that_of_its_position() {
        let derivatives = [1.0, 5.0, 3.0].map(|value| Derivative::smooth(value, 1e-9));
        let found = extreme(&rows(&[1.0, 4.0, 2.0]), 0, &derivatives, true);
        assert_eq!(found.sides, [5.0; 2]);
        assert_eq!(extreme(&rows(&[1.0, 4.0, 2.0]), 0, &derivatives, false).sides, [1.0; 2]);
    }

    #[test]
    fn a_maximum_that_moves_has_a_kink() {
        let derivatives = [1.0, 5.0, 3.0].map(|value| Derivative::smooth(value, 1e-9));
        let found = extreme(&rows(&[4.0, 4.0, 2.0]), 0, &derivatives, true);
        assert_eq!(found.sides, [1.0, 5.0]);
        let least = extreme(&rows(&[2.0, 4.0, 2.0]), 0, &derivatives, false);
        assert_eq!(least.sides, [3.0, 1.0]);
    }
}
