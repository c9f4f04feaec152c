//! Error estimates of transient analyses: the motion is repeated with steps of two and four times
//! the length, and with the former and one more setting changed.
//!
//! Motions are not compared step by step: after an impact, two motions with a small shift in time
//! differ much at each time but little in the results. Therefore statistics are compared. Longer
//! steps determine the error only if the steps converge, which the third run shows. The growth of
//! the differences from one doubling of the step to the next gives the order of convergence, and
//! Richardson extrapolation of this order gives the error. If the differences do not grow, the
//! steps are too long, and nothing is estimated.

use super::mesh_variants::MeshVariant;
use super::perturbed_solves::{OF_GRID, coarser_grids};
use super::{Ends, ErrorPart, Estimates, Evidence, Part, Statistics, ends, is_stress};
use crate::results::DirectedErrors;
use crate::rows::StepRow;
use crate::scene::Scene;
use calyx_model::fidelity::{BodyModel, Fidelity, StructureOptions};
use calyx_model::observed::OutputRequest;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;

/// Largest and smallest factor on the difference from steps of twice the length, for errors of
/// first and second order: by Richardson extrapolation, for differences that grow by `g` per
/// doubling, `1 / (g - 1)`.
const OF_ORDERS: [f64; 2] = [1.0, 1.0 / 3.0];
/// Differences below this fraction of the largest magnitude count as zero.
const NOTHING: f64 = 1e-3;

/// Computes the rows of a scene at a fidelity with a structure discretization.
type Turned<'a> = dyn Fn(&Scene, Fidelity, StructureOptions) -> Result<Vec<StepRow>, EngineError> + 'a;

/// Finished transient analysis.
pub(crate) struct BaseMotion<'a> {
    pub scene: &'a Scene,
    pub fidelity: Fidelity,
    pub structure: StructureOptions,
    pub outputs: &'a [OutputRequest],
    pub interrupt: &'a Interrupt,
    pub rows: &'a [StepRow],
    /// True if the scheme is of second order.
    pub second_order: bool,
    /// Rows with steps of two and four times the length, or the reason why there are none.
    pub longer: Result<[Vec<StepRow>; 2], String>,
    /// Computes the rows of another scene or structure with steps of twice the length.
    pub turned: &'a Turned<'a>,
}

impl BaseMotion<'_> {
    /// Runs the perturbed solves.
    ///
    /// # Errors
    /// Those of the interrupt. A perturbed solve that fails otherwise leaves its part unestimated.
    pub(crate) fn perturbed_solves(self, estimates: Estimates) -> Result<Evidence, EngineError> {
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
                let missing = |part| ErrorPart { part, errors: Err(reason.clone()) };
                evidence.found.extend(others.map(missing));
                return Ok(evidence);
            }
            _ => {
                let reason = "of a motion in time it costs more than the run: \"full\" estimates have it";
                let missing = |part| ErrorPart { part, errors: Err(reason.to_owned()) };
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
            let [preferred, other] = MeshVariant::of(self.fidelity, self.structure);
            let first = self.moved(scene, self.fidelity, preferred.structure)?;
            let second = match first {
                Ok(_) => None,
                Err(_) => self.moved(scene, self.fidelity, other.structure)?.ok(),
            };
            let (meshed, other) = match second {
                Some(rows) => (Ok(rows), other),
                None => (first, preferred),
            };
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

    /// Returns the factor on the difference from steps of twice the length, if steps of this length
    /// converge.
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

    /// Computes the motion in longer steps with settings changed, or returns the reason why there
    /// is none.
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

    /// Computes a part of the error from rows with and without its setting changed.
    fn found(
        &self,
        part: Part,
        base: Result<&[StepRow], String>,
        turned: Result<&[StepRow], String>,
        factor: impl Fn(usize) -> f64,
    ) -> ErrorPart {
        let errors = base.and_then(|base| {
            let turned = turned?;
            let (base, turned) = at_same_times(base, turned);
            if base.len() < 2 {
                return Err("no rows are kept at the ends of steps twice as long".to_owned());
            }
            let error = |output: usize| {
                let weights = weights(&base);
                let [own, other] = [&base, &turned].map(|rows| ends(rows, output));
                DirectedErrors::from(differences(&weights, &own, &other).times(factor(output)))
            };
            Ok((0..self.outputs.len()).map(error).collect())
        });
        ErrorPart { part, errors }
    }
}

/// Returns the factor on a difference from its size and that at the next doubling of the step. A
/// difference up to `nothing` counts as zero and has no order.
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

/// Returns the rows of either analysis at times that the other has as well.
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

/// Returns the fraction of the time that each row represents.
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

/// Returns the differences of the statistics of two motions at the same times.
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

    /// Differences of an error `step^order` at steps 1, 2 and 4 reproduce it; outside the orders of
    /// the schemes the nearest order is used.
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
        // A zero difference has no order.
        assert_eq!(of_growth(1e-6, 1e-7, true, 1e-3), Ok(1.0 / 3.0));
    }
}
