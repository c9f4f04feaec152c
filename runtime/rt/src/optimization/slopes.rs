//! Derivatives of the functions of a design with respect to the variables, from the sensitivities
//! of its load cases.
//!
//! The derivatives of outputs with respect to params that change no structure are accurate to many
//! digits, and take less time than two more solutions. Other params build structures again, and are
//! left to differences of designs.

use super::Problem;
use super::evaluation::{CaseValues, Evaluator, Stop};
use super::functions::Shape;
use calyx_report::optimization::Measure;
use calyx_report::sweep::Statistics;
use calyx_runtime::sensitivity::{Derivative, Kind, Sensitivity, StatisticDerivatives};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Derivatives of the outputs of a load case and sample by the name of the variable; without those
/// that are not known.
pub type CaseSlopes = BTreeMap<String, CaseValues>;

/// Functions of a design, those of the objective and then those of the constraints, differentiated
/// with respect to each variable; `None` for a variable without known derivatives.
pub type Slopes = Vec<Option<Vec<f64>>>;

impl Problem {
    /// Returns whether the functions of a design are linear in the outputs of its load cases, so
    /// that derivatives of the outputs give theirs.
    pub(super) fn is_linear_in_outputs(&self) -> bool {
        let whole = self.over_cases == Measure::Worst;
        whole && (self.samples().is_none() || self.over_samples == Measure::Worst)
    }
}

impl Evaluator<'_> {
    /// Finds the variables that change no structure, at the first load case of a design. Only these
    /// are differentiated.
    ///
    /// # Errors
    /// The optimization is cancelled, or the journal cannot be written.
    pub fn find_exact_variables(&self, at: &[f64]) -> Result<(), Stop> {
        if !self.problem().is_linear_in_outputs() {
            return Ok(());
        }
        let all: Vec<String> = self.variable_names();
        let variables = self.problem().values_at(at);
        let known = self.differentiate_case(&variables, (0, 0), &all)?.unwrap_or_default();
        self.set_exact_variables(all.into_iter().filter(|name| known.contains_key(name)).collect());
        Ok(())
    }

    /// Differentiates the functions of a design; `None` if there are no derivatives.
    ///
    /// # Errors
    /// The optimization is cancelled, or the journal cannot be written.
    pub fn slopes(&self, at: &[f64], shape: Shape, scale: f64) -> Result<Option<Slopes>, Stop> {
        let exact = self.exact_variables();
        if exact.is_empty() {
            return Ok(None);
        }
        let variables = self.problem().values_at(at);
        let samples = self.problem().samples().unwrap_or(1);
        let jobs: Vec<[usize; 2]> =
            (0..self.case_count()).flat_map(|case| (0..samples).map(move |sample| [case, sample])).collect();
        let slopes = jobs
            .into_par_iter()
            .map(|[case, sample]| self.differentiate_case(&variables, (case, sample), exact));
        let Some(slopes) = slopes.collect::<Result<Option<Vec<CaseSlopes>>, Stop>>()? else {
            return Ok(None);
        };
        let of_variable = |variable: &super::Variable| {
            let of_case = |slopes: &CaseSlopes| slopes.get(&variable.column.name).cloned();
            let cases: Vec<CaseValues> = slopes.iter().map(of_case).collect::<Option<_>>()?;
            let cases: Vec<Vec<CaseValues>> = cases.chunks(samples).map(<[CaseValues]>::to_vec).collect();
            let width = variable.high - variable.low;
            let all = self.linear_functions(&cases, shape, scale);
            Some(all.into_iter().map(|slope| slope * width).collect())
        };
        Ok(Some(self.problem().variables.iter().map(of_variable).collect()))
    }

    fn variable_names(&self) -> Vec<String> {
        self.problem().variables.iter().map(|variable| variable.column.name.clone()).collect()
    }
}

/// Returns the derivatives of `outputs`, which are among all outputs by `names`, with respect to
/// each param that changes no structure and for which all of them are known.
pub fn of_results(sensitivities: &[Sensitivity], names: &[&str], outputs: &[String]) -> CaseSlopes {
    let exact = sensitivities.iter().filter(|own| own.failure.is_none() && own.kind == Kind::SameStructures);
    let slopes = |own: &Sensitivity| {
        let mut case = CaseValues::default();
        for output in outputs {
            let index = names.iter().position(|name| name == output)?;
            let positions: Vec<f64> = own.positions.iter().map(|row| row[index].value()).collect();
            let statistics = statistics(own.statistics.get(index)?);
            let known = [statistics.min, statistics.mean, statistics.max, statistics.peak_to_peak];
            if !positions.iter().chain(known.iter().flatten()).all(|value| value.is_finite()) {
                return None;
            }
            case.positions.insert(output.clone(), positions);
            case.statistics.insert(output.clone(), statistics);
        }
        Some((own.param.name.clone(), case))
    };
    exact.filter_map(slopes).collect()
}

fn statistics(all: &StatisticDerivatives) -> Statistics {
    let of = |derivative: &Derivative| Some(derivative.value());
    Statistics {
        min: of(&all.min),
        mean: of(&all.mean),
        max: of(&all.max),
        peak_to_peak: of(&all.peak_to_peak),
        error: None,
    }
}
