//! Functions of a design: smooth functions whose largest value is the objective or a constraint.
//!
//! A largest value over positions and load cases has kinks, where another position becomes the
//! largest. Its linear model is poor there, but those of the values at each position are not.

use super::evaluation::CaseValues;
use calyx_report::study::Statistic;

/// Largest number of functions of an output; beyond it, a statistic is one function.
const MOST: usize = 20_000;

/// How the statistics of a design become functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A function per position, or per pair of positions for a peak-to-peak value.
    Positions,
    /// A function per statistic: if the positions depend on the design.
    Statistics,
}

/// Returns functions whose largest value is that of a statistic, or of its negative if it has a
/// lower bound or is maximized. `solutions` is the number of load cases and samples of the design.
pub fn of(
    statistic: Statistic,
    upper: bool,
    (case, solutions): (&CaseValues, usize),
    output: &str,
    shape: Shape,
) -> Vec<f64> {
    // A peak-to-peak value needs two positions.
    let positions = case.positions.get(output).filter(|all| shape == Shape::Positions && all.len() > 1);
    if let Some(all) = positions {
        match (statistic, upper) {
            (Statistic::Max, true) => return all.clone(),
            (Statistic::Min, false) => return all.iter().map(|value| -value).collect(),
            (Statistic::PeakToPeak, true) if all.len() * all.len() * solutions <= MOST => {
                let pair = |(k, high): (usize, &f64)| {
                    let others = all.iter().enumerate().filter(move |(other, _)| *other != k);
                    let high = *high;
                    others.map(move |(_, low)| high - low).collect::<Vec<_>>()
                };
                return all.iter().enumerate().flat_map(pair).collect();
            }
            _ => {}
        }
    }
    let value = case.statistic(output, statistic);
    vec![if upper { value } else { -value }]
}
