//! Statistics of the outputs of a sample, for each combination of the other axes.

use super::sensitivity::Sensitivities;
use super::statistics::{Estimate, PERCENTILES, mean, percentile, standard_deviation};
use crate::sample::{Sample, Statistic};
use crate::sweep::{Case, Row, SweepTable};
use calyx_abi::description::ParamValue;

/// Sample at one combination of the other axes.
#[derive(Clone, Debug)]
pub struct Group {
    /// Name of the load case; empty if it has none.
    pub name: String,
    /// Values of the params that are not sampled.
    pub values: Vec<ParamValue>,
    /// Number of solved cases.
    pub solved: usize,
    /// Number of failed cases, which the statistics do not contain.
    pub failed: usize,
    pub variations: Vec<Variation>,
}

/// Variation of a statistic of an output, in the unit of the output.
#[derive(Clone, Debug)]
pub struct Variation {
    /// Index of the output in the table.
    pub output: usize,
    pub statistic: Statistic,
    /// Values in ascending order.
    pub sorted: Vec<f64>,
    pub mean: Estimate,
    pub standard_deviation: Estimate,
    pub percentiles: [Estimate; PERCENTILES.len()],
    /// Params that explain the variation, or the reason why they are not known.
    pub sensitivities: Result<Sensitivities, String>,
}

impl Variation {
    /// Returns whether the values differ by more than rounding.
    pub fn varies(&self) -> bool {
        let (first, last) = (self.sorted[0], self.sorted[self.sorted.len() - 1]);
        last - first > 1e-9 * first.abs().max(last.abs())
    }
}

/// Returns the number of params that are not sampled; they are the first ones.
pub(crate) fn fixed(table: &SweepTable, sample: &Sample) -> usize {
    table.params.len().saturating_sub(sample.distributions.len())
}

/// Returns the statistics of a sample; empty if the table has no sample.
pub fn groups(table: &SweepTable) -> Vec<Group> {
    let Some(sample) = &table.sample else { return Vec::new() };
    let fixed = fixed(table, sample);
    let mut members: Vec<(&Case, Vec<(&Case, &Row)>)> = Vec::new();
    for (case, row) in table.cases.iter().zip(&table.rows) {
        // The sample is the last axis, so that its cases are consecutive.
        let same = |known: &Case| known.name == case.name && known.values[..fixed] == case.values[..fixed];
        match members.last_mut().filter(|(known, _)| same(known)) {
            Some((_, members)) => members.push((case, row)),
            None => members.push((case, vec![(case, row)])),
        }
    }
    members.into_iter().map(|(first, members)| group(table, fixed, first, &members)).collect()
}

fn group(table: &SweepTable, fixed: usize, first: &Case, members: &[(&Case, &Row)]) -> Group {
    let solved: Vec<(&Case, &Row)> =
        members.iter().copied().filter(|(_, row)| row.failure.is_none()).collect();
    let outputs = 0..table.outputs.len();
    let all = outputs.flat_map(|output| Statistic::ALL.map(|statistic| (output, statistic)));
    Group {
        name: first.name.clone(),
        values: first.values[..fixed].to_vec(),
        solved: solved.len(),
        failed: members.len() - solved.len(),
        variations: all
            .filter_map(|(output, statistic)| variation(table, fixed, &solved, (output, statistic)))
            .collect(),
    }
}

/// Returns the variation of a statistic; `None` with fewer than two values.
fn variation(
    table: &SweepTable,
    fixed: usize,
    solved: &[(&Case, &Row)],
    (output, statistic): (usize, Statistic),
) -> Option<Variation> {
    let column = &table.outputs[output];
    let value = |row: &Row| table.value(row, column, |all| all.get(statistic));
    let known: Vec<(&Case, f64)> =
        solved.iter().map(|(case, row)| (*case, value(row))).filter(|(_, value)| value.is_finite()).collect();
    if known.len() < 2 {
        return None;
    }
    let values: Vec<f64> = known.iter().map(|(_, value)| *value).collect();
    let mut sorted = values.clone();
    sorted.sort_by(f64::total_cmp);
    let number = |value: &ParamValue| match value {
        ParamValue::Number(si) => *si,
        _ => f64::NAN,
    };
    let inputs: Vec<Vec<f64>> = (fixed..table.params.len())
        .map(|param| known.iter().map(|(case, _)| number(&case.values[param])).collect())
        .collect();
    Some(Variation {
        output,
        statistic,
        mean: mean(&values),
        standard_deviation: standard_deviation(&sorted),
        percentiles: PERCENTILES.map(|percent| percentile(&sorted, percent)),
        sensitivities: Sensitivities::of(&inputs, &values),
        sorted,
    })
}

impl Group {
    /// Describes the combination of the other axes, like `torque = 50 N*m`; empty without others.
    pub fn label(&self, table: &SweepTable) -> String {
        let values = table.params.iter().zip(&self.values).map(|(column, value)| {
            let unit = if column.unit == "1" { "" } else { column.unit.as_str() };
            format!("{} = {} {unit}", column.name, column.shown(value)).trim_end().to_owned()
        });
        let name = Some(self.name.clone()).filter(|name| !name.is_empty());
        name.into_iter().chain(values).collect::<Vec<_>>().join(", ")
    }
}
