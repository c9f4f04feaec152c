//! Optimization problem: variables, objective, constraints, load cases and samples.

use crate::error::Error;
use crate::param_assignment::AssignedValue;
use crate::params::{InvalidParam, check_number, index_of, output_of, read_number, shown};
use crate::sweep::objective::output_and_statistic;
use crate::sweep::{Axis, Varied};
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, OutputDescription, ParamDescription, ParamValue};
use calyx_abi::quantity;
use calyx_abi::units::{from_si, to_si};
use calyx_report::optimization::{Constraint, Measure, Variable};
use calyx_report::study::{Objective, Statistic};
use calyx_report::sweep::Column;

/// Optimization problem.
#[derive(Clone, Debug)]
pub struct Problem {
    pub variables: Vec<Variable>,
    /// Indices of the variables in the model's description.
    pub params: Vec<usize>,
    pub objective: Objective,
    pub over_cases: Measure,
    /// Measure over the samples of toleranced params.
    pub over_samples: Measure,
    pub constraints: Vec<Constraint>,
    /// Axes of which the load cases are all combinations.
    pub axes: Vec<Axis>,
    /// Sample of toleranced params. The values of a variable are deviations from it.
    pub sample: Option<Axis>,
    pub effort: Effort,
}

/// How thoroughly the optimum is searched for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Number of local searches of a round.
    pub starts: usize,
    /// Largest number of rounds.
    pub rounds: usize,
    /// Largest number of designs of a search.
    pub designs: usize,
    /// Accuracy of the variables, relative to their ranges.
    pub tolerance: f64,
    /// Seed of the sample from which the starts are chosen.
    pub seed: u64,
}

impl Default for Effort {
    fn default() -> Effort {
        Effort { starts: 5, rounds: 5, designs: 500, tolerance: 1e-4, seed: 0 }
    }
}

impl Problem {
    /// Returns the number of samples; `None` without toleranced params.
    pub fn samples(&self) -> Option<usize> {
        self.sample.as_ref().map(|sample| sample.points.len())
    }

    /// Returns the values of the variables at coordinates in the unit cube, rounded to twelve
    /// digits in the units of the params, so that files have short numbers with the same bits.
    pub(super) fn values_at(&self, at: &[f64]) -> Vec<f64> {
        let value = |(variable, part): (&Variable, &f64)| {
            let si = variable.low + part.clamp(0.0, 1.0) * (variable.high - variable.low);
            let value = rounded(si, &variable.column).clamp(variable.low, variable.high);
            // Rounding near zero.
            if value.abs() < 1e-12 * (variable.high - variable.low) { 0.0 } else { value }
        };
        self.variables.iter().zip(at).map(value).collect()
    }
}

fn rounded(si: f64, column: &Column) -> f64 {
    let value = from_si(si, column.factor);
    to_si(format!("{value:.11e}").parse().unwrap_or(value), column.factor)
}

fn refused(message: impl Into<String>, help: impl Into<String>) -> Error {
    Error::Given(InvalidParam::new(message, help))
}

/// Returns the index of a param that can be a variable.
///
/// # Errors
/// The model has no such param, or it is not a real number.
pub(crate) fn variable(name: &str, description: &ModelDescription) -> Result<usize, Error> {
    let index = index_of(description, name)?;
    let param = &description.params[index];
    let why = match param.repr {
        Repr::Number if param.integral => "takes whole numbers",
        Repr::Number => return Ok(index),
        Repr::Array(_) => "is an array",
        _ => "is not a number",
    };
    Err(refused(
        format!("`{name}` {why}, so it cannot be a variable"),
        "compare its values with `calyx sweep`; a param whose default and range are whole numbers takes whole numbers, until one of them has a fraction",
    ))
}

/// Reads the range of a variable, and its initial value: by default that of the model, or the
/// middle of the range if that is outside.
///
/// # Errors
/// A value is invalid, or the range is empty.
pub(crate) fn parse_range(
    index: usize,
    [low, high]: [&AssignedValue; 2],
    initial: Option<&AssignedValue>,
    description: &ModelDescription,
) -> Result<Variable, Error> {
    let param = &description.params[index];
    let number = |value: &AssignedValue| {
        let si = read_number(param, value, description).map_err(Error::Given)?;
        check_number(param, si).map_err(Error::Given)?;
        Ok::<f64, Error>(si)
    };
    let (low, high) = (number(low)?, number(high)?);
    if low >= high {
        let message = format!(
            "the range of `{}` is empty: {} .. {}",
            param.name,
            shown(param, low),
            shown(param, high)
        );
        let help = match low == high {
            true => "give different bounds, or the value of the param in [params]",
            false => "give the lower bound first",
        };
        return Err(refused(message, help));
    }
    let initial = match initial {
        Some(value) => number(value)?,
        None => default_within(param, low, high),
    };
    if !(low..=high).contains(&initial) {
        let message = format!(
            "`{}` begins at {}, outside of its range {} .. {}",
            param.name,
            shown(param, initial),
            shown(param, low),
            shown(param, high)
        );
        return Err(refused(message, "give an initial value within the range"));
    }
    Ok(Variable { column: Column::from(param), low, high, initial })
}

fn default_within(param: &ParamDescription, low: f64, high: f64) -> f64 {
    match param.default {
        Some(ParamValue::Number(si)) if (low..=high).contains(&si) => si,
        _ => 0.5 * (low + high),
    }
}

/// Parses `OUTPUT.STATISTIC <= BOUND` or `>=`. Without a statistic, the constraint holds at all
/// positions: it is of the largest value for an upper bound, else of the least.
///
/// # Errors
/// The text has another form, the model has no such output, or the bound has another dimension.
pub(crate) fn parse_constraint(text: &str, description: &ModelDescription) -> Result<Constraint, Error> {
    const FORM: &str = "write `OUTPUT <= BOUND` or `OUTPUT >= BOUND`, like `max_contact_pressure <= 1500 MPa`, where OUTPUT may end with .min, .mean, .max or .peak_to_peak";
    let upper = text.split_once("<=").map(|parts| (parts, true));
    let Some(((name, bound), at_most)) = upper.or_else(|| text.split_once(">=").map(|parts| (parts, false)))
    else {
        return Err(refused(format!("`{text}` is not a constraint"), FORM));
    };
    let (name, bound) = (name.trim(), bound.trim());
    let whole = if at_most { Statistic::Max } else { Statistic::Min };
    let (name, statistic) = output_and_statistic(name, description)?;
    let statistic = statistic.unwrap_or(whole);
    let output = &description.outputs[output_of(description, name)?];
    let bound = bound_of(bound, output, description)?;
    Ok(Constraint { output: name.to_owned(), statistic, at_most, bound })
}

/// Reads the bound of an output; a number without a unit is in the unit of the output.
fn bound_of(text: &str, output: &OutputDescription, description: &ModelDescription) -> Result<f64, Error> {
    let unit = if output.unit.name == "1" { "" } else { output.unit.name.as_str() };
    let refused = |why: &str| {
        let help = match unit {
            "" => format!("give a number, as `{}` has no unit", output.name),
            unit => format!("give a number with a unit, like `1 {unit}`"),
        };
        refused(format!("the bound of `{}` cannot be `{text}`: {why}", output.name), help)
    };
    let quantity = quantity::parse(text, &description.known_units).map_err(|why| refused(&why))?;
    if !quantity.unit {
        return Ok(to_si(quantity.value, output.unit.factor));
    }
    if !quantity::fits(quantity.dimension, output.unit.dimension) {
        let kind = quantity::kind(quantity.dimension, &description.known_dimensions);
        return Err(refused(&match kind {
            Some(kind) => format!("that is {kind}, another kind of quantity"),
            None => "it is another kind of quantity".to_owned(),
        }));
    }
    Ok(quantity.value)
}

/// Returns the value of a toleranced variable: the sampled value is a deviation from it.
pub(super) fn deviated(value: f64, deviation: &ParamValue) -> f64 {
    match deviation {
        ParamValue::Number(deviation) => value + deviation,
        _ => value,
    }
}

/// Returns whether a toleranced param is a variable, and which one.
pub(super) fn variable_of(params: &[usize], varied: Varied) -> Option<usize> {
    match varied {
        Varied::Param(index) => params.iter().position(|own| *own == index),
        Varied::Fidelity => None,
    }
}
