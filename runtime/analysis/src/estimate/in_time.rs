//! The same motion in time once more: in steps twice and four times as long, and in the former with one knob more turned.
//!
//! Motions are not compared step by step: after a blow two that are a little apart in time differ by much at any one time, and by little in what
//! results tell. So their statistics are compared. Longer steps tell the error of shorter ones only if these converge, which the third run shows: by
//! how much differences grow from one doubling of the step to the next is the order at which they do, and Richardson's extrapolation by that order the
//! error. Where differences do not grow, steps are too long to tell anything, and nothing is estimated.

use super::siblings::{OF_GRID, OtherMesh, coarser_grids};
use super::{Ends, Estimates, Evidence, Found, Part, Statistics, ends, is_stress};
use crate::rows::StepRow;
use crate::scene::Scene;
use calyx_model::fidelity::{BodyModel, Fidelity, StructureOptions};
use calyx_model::observed::OutputRequest;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;

/// What the difference from steps twice as long is multiplied by at most and at least, of an error of the first order and of the second: by Richardson's
/// extrapolation, of differences that grow by `g` from one doubling to the next, `1 / (g - 1)`.
const OF_ORDERS: [f64; 2] = [1.0, 1.0 / 3.0];
/// Differences below this part of the largest magnitude are none.
const NOTHING: f64 = 1e-3;

/// The rows of a scene at a fidelity, on structures of some fineness.
type Turned<'a> = dyn Fn(&Scene, Fidelity, StructureOptions) -> Result<Vec<StepRow>, EngineError> + 'a;

/// A motion in time that is done.
pub(crate) struct Moved<'a> {
    pub scene: &'a Scene,
    pub fidelity: Fidelity,
    pub structure: StructureOptions,
    pub outputs: &'a [OutputRequest],
    pub interrupt: &'a Interrupt,
    pub rows: &'a [StepRow],
    /// Whether the scheme is of the second order.
    pub second_order: bool,
    /// Its rows in steps twice and four times as long, or why there are none.
    pub longer: Result<[Vec<StepRow>; 2], String>,
    /// The same of another scene or structure.
    pub turned: &'a Turned<'a>,
}

impl Moved<'_> {
    /// What its siblings tell.
    ///
    /// # Errors
    /// The interrupt's. A sibling that fails otherwise leaves its part unestimated.
    pub(crate) fn siblings(self, estimates: Estimates) -> Result<Evidence, EngineError> {
        let mut evidence = Evidence::default();
        let shared = match &self.longer {
            Ok([longer, _]) => Ok(longer.as_slice()),
            Err(reason) => Err(reason.clone()),
        };
        let factor = self.longer.as_ref().map_err(String::clone).and_then(|longer| self.factor(longer));
        let (of_steps, converging) = match &factor {
            Ok(factor) => (*factor, shared.clone()),
            Err(reason) => (f64::NAN, Err(reason.clone())),
        };
        evidence.found.push(self.found(Part::TimeStep, Ok(self.rows), converging, |_| of_steps));
        let others = [Part::Discretization, Part::ContactGrid, Part::Level];
        let longer = match (estimates, shared) {
            (Estimates::Full, Ok(longer)) => longer,
            (Estimates::Full, Err(reason)) => {
                let missing = |part| Found { part, errors: Err(reason.clone()) };
                evidence.found.extend(others.map(missing));
                return Ok(evidence);
            }
            _ => {
                let reason = "of a motion in time it costs more than the run: \"full\" estimates have it";
                let missing = |part| Found { part, errors: Err(reason.to_owned()) };
                evidence.found.extend(others.map(missing));
                return Ok(evidence);
            }
        };

        let coarse = coarser_grids(self.scene, false);
        let on_coarse = match &coarse {
            Some(coarse) => self.moved(coarse, self.fidelity, self.structure)?,
            None => Err("the contact grid has too few cells to halve them".into()),
        };
        let on_coarse = on_coarse.as_ref().map(Vec::as_slice).map_err(String::clone);
        let (scene, base) = match (&coarse, on_coarse.clone()) {
            (Some(coarse), Ok(rows)) => (coarse, rows),
            _ => (self.scene, longer),
        };
        if self.fidelity.body_model() == BodyModel::Elements {
            let other = OtherMesh::than(self.fidelity, self.structure);
            let meshed = self.moved(scene, self.fidelity, other.structure)?;
            let factor =
                |output: usize| other.factor(is_stress(&self.outputs[output], &self.scene.observables));
            let meshed = meshed.as_ref().map(Vec::as_slice).map_err(String::clone);
            evidence.found.push(self.found(Part::Discretization, Ok(base), meshed, factor));
        }
        evidence.found.push(self.found(Part::ContactGrid, Ok(longer), on_coarse, |_| OF_GRID));
        let level = match self.fidelity.all_above().next() {
            Some(above) => self.moved(self.scene, above, self.structure)?,
            None => Err("there is no level above this one".to_owned()),
        };
        let level = level.as_ref().map(Vec::as_slice).map_err(String::clone);
        evidence.found.push(self.found(Part::Level, Ok(longer), level, |_| 1.0));
        Ok(evidence)
    }

    /// What the difference from steps twice as long is multiplied by, if steps of this length converge.
    fn factor(&self, [longer, longest]: &[Vec<StepRow>; 2]) -> Result<f64, String> {
        let off = |one: &[StepRow], other: &[StepRow]| {
            let (one, other) = at_same_times(one, other);
            let of = |output: usize| {
                let own = ends(&one, output);
                let scale = own.iter().map(|end| end.high.abs().max(end.low.abs())).fold(0.0, f64::max);
                let Statistics { min, max, mean, .. } =
                    differences(&weights(&one), &own, &ends(&other, output));
                let off = (min + max + mean) / scale;
                if off.is_finite() { off } else { 0.0 }
            };
            (0..self.outputs.len()).map(of).sum::<f64>()
        };
        let [near, far] = [off(self.rows, longer), off(longer, longest)];
        of_growth(near, far, self.second_order, NOTHING * self.outputs.len() as f64)
    }

    /// The motion in longer steps with knobs turned, or why there is none.
    fn moved(
        &self,
        scene: &Scene,
        fidelity: Fidelity,
        structure: StructureOptions,
    ) -> Result<Result<Vec<StepRow>, String>, EngineError> {
        match (self.turned)(scene, fidelity, structure) {
            Ok(rows) => Ok(Ok(rows)),
            Err(error) => {
                self.interrupt.check()?;
                Ok(Err(format!("{}: {}", error.code, error.message)))
            }
        }
    }

    /// The error in a part, from rows with and without its knob turned.
    fn found(
        &self,
        part: Part,
        base: Result<&[StepRow], String>,
        turned: Result<&[StepRow], String>,
        factor: impl Fn(usize) -> f64,
    ) -> Found {
        let errors = base.and_then(|base| {
            let turned = turned?;
            let (base, turned) = at_same_times(base, turned);
            if base.len() < 2 {
                return Err("no rows are kept at the ends of steps twice as long".to_owned());
            }
            let error = |output: usize| {
                let weights = weights(&base);
                let [own, other] = [&base, &turned].map(|rows| ends(rows, output));
                differences(&weights, &own, &other).times(factor(output))
            };
            Ok((0..self.outputs.len()).map(error).collect())
        });
        Found { part, errors }
    }
}

/// The factor on a difference, by how large it is and the one at the next doubling of the step; one up to `nothing` is none, and says nothing of its
/// order.
fn of_growth(near: f64, far: f64, second_order: bool, nothing: f64) -> Result<f64, String> {
    let least = OF_ORDERS[usize::from(second_order)];
    if near <= nothing {
        return Ok(least);
    }
    let growth = far / near;
    match growth > 1.0 {
        true => Ok((growth - 1.0).recip().clamp(least, OF_ORDERS[0])),
        false => Err(format!(
            "steps are too long: those twice as long make {growth:.1} times the difference at the next doubling, where converging ones make more"
        )),
    }
}

/// The rows of either that the other one has as well.
fn at_same_times(one: &[StepRow], other: &[StepRow]) -> (Vec<StepRow>, Vec<StepRow>) {
    let mut both = (Vec::new(), Vec::new());
    let mut rest = other.iter().peekable();
    for row in one {
        let time = row.position.time;
        while rest.next_if(|other| other.position.time < time).is_some() {}
        if let Some(same) = rest.next_if(|other| other.position.time == time) {
            both.0.push(row.clone());
            both.1.push(same.clone());
        }
    }
    both
}

/// The part of the time that each row stands for.
fn weights(rows: &[StepRow]) -> Vec<f64> {
    if rows.len() < 2 {
        return vec![1.0; rows.len()];
    }
    let time = |row: usize| rows[row].position.time;
    let last = rows.len() - 1;
    let span = time(last) - time(0);
    (0..rows.len())
        .map(|row| 0.5 * (time((row + 1).min(last)) - time(row.saturating_sub(1))) / span)
        .collect()
}

/// By how much the statistics of two motions at the same times differ.
fn differences(weights: &[f64], own: &[Ends], other: &[Ends]) -> Statistics {
    if !own.iter().chain(other).all(|end| (end.value + end.low + end.high).is_finite()) {
        return Statistics::NONE;
    }
    let extreme =
        |rows: &[Ends], of: &dyn Fn(&Ends) -> f64| rows.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let apart = |of: &dyn Fn(&Ends) -> f64| extreme(own, of) - extreme(other, of);
    let (above, below) = (apart(&|end| end.high), apart(&|end| -end.low));
    let values = own.iter().zip(other).zip(weights);
    let mean: f64 = values.map(|((own, other), weight)| weight * (own.value - other.value)).sum();
    Statistics { min: below.abs(), max: above.abs(), mean: mean.abs(), peak_to_peak: (above + below).abs() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Differences of an error `step^order` at steps 1, 2 and 4 give it back; beyond the orders of schemes the nearest of them counts.
    #[test]
    fn the_order_that_is_seen_tells_the_error() {
        for order in [1.0_f64, 1.3, 1.7, 2.0] {
            let [near, far] = [2.0, 4.0].map(|step: f64| step.powf(order) - (0.5 * step).powf(order));
            let factor = of_growth(near, far, true, 0.0).expect("it converges");
            assert!((factor * near - 1.0).abs() < 1e-12, "{order}: {factor}");
        }
        assert_eq!(of_growth(1.0, 20.0, true, 0.0), Ok(1.0 / 3.0));
        assert_eq!(of_growth(1.0, 4.0, false, 0.0), Ok(1.0));
        assert_eq!(of_growth(1.0, 1.1, true, 0.0), Ok(1.0));
        assert!(of_growth(1.0, 0.9, true, 0.0).is_err());
        // No difference has no order.
        assert_eq!(of_growth(1e-6, 1e-7, true, 1e-3), Ok(1.0 / 3.0));
    }
}
