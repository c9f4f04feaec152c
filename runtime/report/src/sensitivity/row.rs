//! Rows of the table of sensitivities, and how they are shown.

use super::{Entry, SensitivityTable, Statistic};
use crate::summary_table::number;
use crate::sweep::exact;
use calyx_runtime::sensitivity::Kind;
use serde::{Deserialize, Serialize, Serializer};

/// Relative error above which a derivative shows its error.
const SHOWN_ERROR: f64 = 1e-4;

/// Relative error above which a difference is no derivative: the output jumps, or is noise.
const UNCERTAIN: f64 = 0.1;

/// Param changes structures: value of [`DerivativeRow::structures`].
const NEW: &str = "new";

/// Row of the table: derivative of a statistic of an output with respect to a param, in the units
/// of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DerivativeRow {
    /// Name of the output.
    pub output: String,
    /// Name of the statistic; empty if there is a single position.
    pub statistic: String,
    /// Value of the statistic.
    #[serde(serialize_with = "exact_if_known")]
    pub value: Option<f64>,
    /// Unit of the output.
    pub unit: String,
    /// Name of the param.
    pub param: String,
    /// Value of the param.
    #[serde(serialize_with = "exact_number")]
    pub param_value: f64,
    /// Unit of the param.
    pub param_unit: String,
    /// Derivative, at a kink the mean of both sides; `None` where the state of contact is lost.
    #[serde(serialize_with = "exact_if_known")]
    pub derivative: Option<f64>,
    /// Derivative towards smaller values of the param.
    #[serde(serialize_with = "exact_if_known")]
    pub derivative_below: Option<f64>,
    /// Derivative towards larger values of the param.
    #[serde(serialize_with = "exact_if_known")]
    pub derivative_above: Option<f64>,
    /// Unit of the derivatives.
    pub derivative_unit: String,
    /// Estimated error of the derivative.
    #[serde(serialize_with = "exact_if_known")]
    pub estimated_error: Option<f64>,
    /// Change of the statistic if the param grows by one percent.
    #[serde(serialize_with = "exact_if_known")]
    pub effect_of_1_percent: Option<f64>,
    /// `same` or `new`: whether the param changes structures.
    pub structures: String,
}

/// Writes all digits, as in the other tables.
fn exact_number<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    exact(*value).serialize(serializer)
}

fn exact_if_known<S: Serializer>(value: &Option<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    value.map(exact).serialize(serializer)
}

impl SensitivityTable {
    /// Returns the rows of all statistics that are shown.
    pub fn rows(&self) -> Vec<DerivativeRow> {
        let mut rows = Vec::new();
        for &output in &self.shown {
            for statistic in self.shown_statistics() {
                rows.extend(self.rows_of(output, statistic));
            }
        }
        rows
    }

    /// Returns the rows of a statistic, those with the largest effect first.
    pub fn rows_of(&self, output: usize, statistic: Statistic) -> Vec<DerivativeRow> {
        let entries = self.entries(output, statistic);
        entries.iter().map(|entry| self.row(output, statistic, entry)).collect()
    }

    fn row(&self, output: usize, statistic: Statistic, entry: &Entry) -> DerivativeRow {
        let known = |value: f64| Some(value).filter(|value| !value.is_nan());
        let (column, param) = (&self.outputs[output], &self.params[entry.param]);
        DerivativeRow {
            output: column.name.clone(),
            statistic: if self.is_single() { String::new() } else { statistic.name().to_owned() },
            value: self.value(output, statistic),
            unit: column.unit.clone(),
            param: param.name.clone(),
            param_value: self.param_value(entry.param),
            param_unit: param.unit.clone(),
            derivative: known(entry.value()),
            derivative_below: known(entry.sides[0]),
            derivative_above: known(entry.sides[1]),
            derivative_unit: self.unit(output, entry.param),
            estimated_error: known(entry.error),
            effect_of_1_percent: known(entry.effect),
            structures: match self.sensitivities[entry.param].kind {
                Kind::SameStructures => "same",
                Kind::ChangedStructures => NEW,
            }
            .to_owned(),
        }
    }
}

impl DerivativeRow {
    /// Returns whether the derivatives of both sides differ.
    pub fn is_kink(&self) -> bool {
        self.derivative_below != self.derivative_above
    }

    /// Returns whether the derivative cannot be distinguished from zero.
    pub fn is_zero(&self) -> bool {
        let Some(error) = self.estimated_error else { return false };
        let sides = [self.derivative_below, self.derivative_above];
        sides.iter().all(|side| side.is_some_and(|side| side.abs() <= error))
    }

    /// Returns the derivative as text, at a kink those of both sides.
    pub fn shown_derivative(&self) -> String {
        match (self.derivative_below, self.derivative_above) {
            _ if self.is_zero() => "0".to_owned(),
            (Some(below), Some(above)) if self.is_kink() => {
                format!("{} below, {} above", number(below), number(above))
            }
            (value, _) => number(value.unwrap_or(f64::NAN)),
        }
    }

    /// Returns the effect of one percent of the param as text.
    pub fn shown_effect(&self) -> String {
        if self.is_zero() { "0".to_owned() } else { number(self.effect_of_1_percent.unwrap_or(f64::NAN)) }
    }

    /// Returns the effect in percent of the value as text.
    pub fn shown_relative(&self) -> String {
        let (Some(effect), Some(value)) = (self.effect_of_1_percent, self.value) else {
            return String::new();
        };
        let part = 100.0 * effect / value.abs();
        match part {
            _ if self.is_zero() || !part.is_finite() => String::new(),
            // Fewer decimals would round to zero.
            _ if part != 0.0 && part.abs() < 5e-4 => format!("{part:+.1e}"),
            _ => format!("{part:+.3}"),
        }
    }

    /// Returns remarks: a kink, structures that were built again, the error.
    pub fn remarks(&self) -> Vec<String> {
        let mut all = Vec::new();
        if self.derivative.is_none() {
            all.push("contact changes next to this value, or a value of a forced response".to_owned());
        }
        if self.is_kink() {
            all.push("kink".to_owned());
        }
        if self.structures == NEW {
            all.push("new structures".to_owned());
        }
        let size = |side: Option<f64>| side.map_or(0.0, f64::abs);
        let error = self.estimated_error.unwrap_or(f64::NAN);
        let relative = error / size(self.derivative_below).max(size(self.derivative_above));
        if self.is_zero() && error > 0.0 {
            all.push("zero within its error".to_owned());
        } else if self.derivative.is_some() && relative > SHOWN_ERROR {
            let percent = 100.0 * relative;
            let decimals = if percent < 0.1 { 2 } else { 1 };
            let cause = if relative > UNCERTAIN { "a jump or noise, " } else { "" };
            all.push(format!("{cause}±{percent:.decimals$} %"));
        }
        all
    }
}
