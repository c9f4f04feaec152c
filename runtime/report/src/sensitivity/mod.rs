//! Sensitivities of a model: derivatives of the statistics of outputs with respect to params, in the
//! units of the model, ranked by the effect of equal relative changes.

mod files;
mod row;
mod text;

pub use files::{SENSITIVITIES, SENSITIVITIES_BY_POSITION, read_table, write_positions, write_table};
pub use row::DerivativeRow;
pub use text::text;

pub use crate::sample::Statistic;

use crate::sweep::{Column, Statistics};
use calyx_abi::units::from_si;
use calyx_runtime::position::Position;
use calyx_runtime::sensitivity::{Derivative, Sensitivity, StatisticDerivatives};

/// Relative change of a param whose effect ranks the params.
pub const CHANGE: f64 = 0.01;

/// Sensitivities of a model with what is needed to show them.
#[derive(Clone, Debug)]
pub struct SensitivityTable {
    /// Name of the model.
    pub model: String,
    /// Documentation of the model.
    pub doc: String,
    /// Params, in the order of `sensitivities`.
    pub params: Vec<Column>,
    /// All outputs of the model.
    pub outputs: Vec<Column>,
    /// Indices of the outputs that are shown.
    pub shown: Vec<usize>,
    /// Statistics of all outputs.
    pub statistics: Vec<Statistics>,
    /// Positions of the analysis; one for a model without an analysis.
    pub positions: Vec<Position>,
    /// The derivatives by param.
    pub sensitivities: Vec<Sensitivity>,
}

/// Derivative of a statistic with respect to a param, in the units of the model.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Index of the param.
    pub param: usize,
    /// Derivatives towards smaller and towards larger values of the param.
    pub sides: [f64; 2],
    /// Estimated error.
    pub error: f64,
    /// Change of the statistic if the param grows by [`CHANGE`].
    pub effect: f64,
    /// True if the derivatives of both sides differ.
    pub is_kink: bool,
}

impl Entry {
    /// Returns the derivative, at a kink the mean of both sides.
    pub fn value(&self) -> f64 {
        0.5 * (self.sides[0] + self.sides[1])
    }

    /// Returns whether the derivative cannot be distinguished from zero.
    pub fn is_zero(&self) -> bool {
        self.sides.iter().all(|side| side.abs() <= self.error)
    }
}

impl SensitivityTable {
    /// Returns whether there is a single position, whose value is every statistic.
    pub fn is_single(&self) -> bool {
        self.positions.len() <= 1
    }

    /// Returns the statistics to show: the value of a single position, or all.
    pub fn shown_statistics(&self) -> Vec<Statistic> {
        if self.is_single() { vec![Statistic::Max] } else { Statistic::ALL.to_vec() }
    }

    /// Returns the name of a statistic of an output, like `transmission_error.max`.
    pub fn name(&self, output: usize, statistic: Statistic) -> String {
        let name = &self.outputs[output].name;
        if self.is_single() { name.clone() } else { format!("{name}.{}", statistic.name()) }
    }

    /// Returns a statistic of an output in its unit.
    pub fn value(&self, output: usize, statistic: Statistic) -> Option<f64> {
        let si = self.statistics[output].get(statistic)?;
        Some(from_si(si, self.outputs[output].factor))
    }

    /// Returns the derivatives of a statistic, those with the largest effect first.
    pub fn entries(&self, output: usize, statistic: Statistic) -> Vec<Entry> {
        let entry = |(param, own): (usize, &Sensitivity)| {
            let derivative = derivative_of(own.statistics.get(output)?, statistic);
            let scale = self.outputs[output].factor / self.params[param].factor;
            let in_units = |si: f64| si / scale;
            Some(Entry {
                param,
                sides: derivative.sides.map(in_units),
                error: in_units(derivative.error),
                effect: derivative.sides[1] * CHANGE * own.param.scale() / self.outputs[output].factor,
                is_kink: derivative.is_kink(),
            })
        };
        let mut all: Vec<Entry> = self.sensitivities.iter().enumerate().filter_map(entry).collect();
        // Unknown effects come last.
        let size = |entry: &Entry| if entry.effect.is_nan() { -1.0 } else { entry.effect.abs() };
        all.sort_by(|one, other| size(other).total_cmp(&size(one)));
        all
    }

    /// Returns the unit of a derivative, like `um/(N*m)`.
    pub fn unit(&self, output: usize, param: usize) -> String {
        let [of, by] = [&self.outputs[output].unit, &self.params[param].unit].map(String::as_str);
        let by = if by.contains(['*', '/', '^']) { format!("({by})") } else { by.to_owned() };
        match (of, by.as_str()) {
            (of, by) if of == by => String::new(),
            (of, "" | "1") => if of == "1" { "" } else { of }.to_owned(),
            ("" | "1", by) => format!("1/{by}"),
            (of, by) => format!("{of}/{by}"),
        }
    }

    /// Returns the values of a param in its unit.
    pub fn param_value(&self, param: usize) -> f64 {
        self.params[param].reversible(self.sensitivities[param].param.value)
    }
}

/// Returns the derivative of a statistic.
pub fn derivative_of(all: &StatisticDerivatives, statistic: Statistic) -> Derivative {
    match statistic {
        Statistic::Min => all.min,
        Statistic::Mean => all.mean,
        Statistic::Max => all.max,
        Statistic::PeakToPeak => all.peak_to_peak,
    }
}
