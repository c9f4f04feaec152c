//! Results of a sweep: one row per case, as a file and as text.

use crate::durations::Durations;
use crate::sample::{Objective, Sample, Statistic};
use crate::summary_table::{align, number};
use calyx_abi::description::{Exponents, OWN_BASES, OutputDescription, ParamDescription, ParamValue};
use calyx_abi::quantity::fits;
use calyx_abi::units::{from_si, shortest, to_si};
use calyx_runtime::component_loads::ComponentLoads;
use calyx_runtime::results::OutputSummary;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

/// Magnitudes outside of which numbers have an exponent.
const PLAIN: std::ops::Range<f64> = 1e-6..1e15;

/// Dimension of power: exponents of length, mass and time.
const POWER: Exponents = {
    let mut power = [(0, 1); 5 + OWN_BASES];
    [power[0], power[1], power[2]] = [(2, 1), (1, 1), (-3, 1)];
    power
};

/// Formats a number with all digits.
pub(crate) fn exact(value: f64) -> String {
    if value == 0.0 || PLAIN.contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

/// File name of the text that the model prints, in the directory of a sweep.
pub const PRINTED_TEXT: &str = "printed.txt";

/// Number of outputs in the printed table.
pub(crate) const PRINTED: usize = 6;

/// Column of a table: a param or an output, with its unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Column {
    pub name: String,
    pub unit: String,
    /// Value of the unit in SI.
    pub factor: f64,
    /// True for a power, whose mean over a duty cycle is the energy divided by the time.
    pub is_power: bool,
}

impl From<&ParamDescription> for Column {
    fn from(param: &ParamDescription) -> Column {
        let is_power = fits(param.unit.dimension, POWER);
        Column {
            name: param.name.clone(),
            unit: param.unit.name.clone(),
            factor: param.unit.factor,
            is_power,
        }
    }
}

impl From<&OutputDescription> for Column {
    fn from(output: &OutputDescription) -> Column {
        let is_power = fits(output.unit.dimension, POWER);
        Column {
            name: output.name.clone(),
            unit: output.unit.name.clone(),
            factor: output.unit.factor,
            is_power,
        }
    }
}

impl Column {
    /// Returns the heading of a column with this statistic, like `torque.max [N*m]`.
    pub fn heading(&self, statistic: &str) -> String {
        let name =
            if statistic.is_empty() { self.name.clone() } else { format!("{}.{statistic}", self.name) };
        if self.unit.is_empty() || self.unit == "1" { name } else { format!("{name} [{}]", self.unit) }
    }

    /// Returns a value of a param in the unit of the column with all digits: `--set` with this text
    /// sets the same bits.
    pub(crate) fn exact(&self, value: &ParamValue) -> String {
        match value {
            ParamValue::Number(si) => exact(self.reversible(*si)),
            ParamValue::Numbers(all) => {
                let all: Vec<String> = all.iter().map(|si| exact(self.reversible(*si))).collect();
                format!("[{}]", all.join(", "))
            }
            other => self.shown(other),
        }
    }

    /// Returns the number in the unit of the column that converts to the same number in SI, with
    /// few digits if there is a choice.
    pub(crate) fn reversible(&self, si: f64) -> f64 {
        let value = from_si(si, self.factor);
        let short = format!("{value:.14e}").parse().unwrap_or(value);
        let near = [short, value, value.next_down(), value.next_up()];
        near.into_iter().find(|near| to_si(*near, self.factor) == si).unwrap_or(value)
    }

    /// Returns a value of a param in the unit of the column, as text.
    pub fn shown(&self, value: &ParamValue) -> String {
        match value {
            ParamValue::Bool(truth) => if *truth { "TRUE" } else { "FALSE" }.into(),
            ParamValue::Number(si) => shortest(from_si(*si, self.factor)),
            ParamValue::String(text) => text.clone(),
            ParamValue::Numbers(all) => {
                let all: Vec<String> = all.iter().map(|si| shortest(from_si(*si, self.factor))).collect();
                all.join(" ")
            }
        }
    }
}

/// Statistics of an output over the positions of a case, SI; `None` without a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Statistics {
    pub min: Option<f64>,
    pub mean: Option<f64>,
    pub max: Option<f64>,
    pub peak_to_peak: Option<f64>,
    /// Estimated error of the maximum.
    #[serde(default)]
    pub error: Option<f64>,
}

impl Statistics {
    /// Returns one of the statistics, SI.
    pub fn get(&self, statistic: Statistic) -> Option<f64> {
        match statistic {
            Statistic::Min => self.min,
            Statistic::Mean => self.mean,
            Statistic::Max => self.max,
            Statistic::PeakToPeak => self.peak_to_peak,
        }
    }

    /// Returns the statistics of a summary.
    pub fn of(summary: &OutputSummary) -> Statistics {
        let known = |value: f64| value.is_finite().then_some(value);
        Statistics {
            min: known(summary.min),
            mean: known(summary.mean),
            max: known(summary.max),
            peak_to_peak: known(summary.peak_to_peak),
            error: summary.error.as_ref().and_then(|error| known(error.total.max)),
        }
    }
}

/// Names and values of the statistics of an output in a table.
type Tabulated = (&'static str, fn(&Statistics) -> Option<f64>);
pub(crate) const STATISTICS: [Tabulated; 5] = [
    ("min", |all| all.min),
    ("mean", |all| all.mean),
    ("max", |all| all.max),
    ("peak_to_peak", |all| all.peak_to_peak),
    ("max_error", |all| all.error),
];

/// Result of a case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Number of the case, from 1.
    pub case: usize,
    /// Statistics by output; empty if the case failed.
    pub outputs: BTreeMap<String, Statistics>,
    /// Reason of a failure.
    pub failure: Option<String>,
    /// Warnings of the run.
    pub warnings: Vec<String>,
    /// Loads of meshes and bearings; `None` if they were not recorded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub components: Option<Vec<ComponentLoads>>,
    /// Lines that the model has printed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub printed: Vec<String>,
}

/// A case of a sweep: its name, if it has one, and the values of the varied params.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    pub name: String,
    pub values: Vec<ParamValue>,
}

/// Results of all cases.
#[derive(Clone, Debug, Default)]
pub struct SweepTable {
    /// Name of the model.
    pub model: String,
    /// Doc comment of the model.
    pub doc: String,
    /// Varied params.
    pub params: Vec<Column>,
    pub outputs: Vec<Column>,
    pub cases: Vec<Case>,
    /// Rows by case, in order.
    pub rows: Vec<Row>,
    /// Name of the unit system of the model.
    pub units: String,
    /// Indices of the params whose values are equally spaced on a logarithmic scale.
    pub logarithmic: Vec<usize>,
    /// True if the cases are load cases of a file.
    pub load_cases: bool,
    /// Durations of all cases, solved or not; `None` without a duty cycle.
    pub durations: Option<Durations>,
    /// Sample of toleranced params, which are the last ones; `None` without them.
    pub sample: Option<Sample>,
    /// Objectives whose trade-off is shown: two, or none.
    pub objectives: Vec<Objective>,
}

impl SweepTable {
    /// Returns whether the cases have names.
    pub fn is_named(&self) -> bool {
        self.cases.iter().any(|case| !case.name.is_empty())
    }

    /// Returns the label of a case: its name with its number if other cases have the same name, or
    /// its number.
    pub(crate) fn label(&self, index: usize) -> String {
        let number = self.rows.get(index).map_or(index + 1, |row| row.case);
        let name = self.cases.get(index).map_or("", |case| case.name.as_str());
        match self.cases.iter().filter(|case| case.name == name).count() {
            _ if name.is_empty() => format!("case {number}"),
            1 => name.to_owned(),
            _ => format!("{name} (case {number})"),
        }
    }

    /// Returns the number of outputs that the printed table leaves out.
    pub fn unprinted(&self) -> usize {
        self.outputs.len().saturating_sub(PRINTED)
    }

    /// Returns whether a case has printed text.
    pub fn has_printed(&self) -> bool {
        self.rows.iter().any(|row| !row.printed.is_empty())
    }

    /// Formats one line per case: the varied params, the duration, and a predicted time as text.
    pub fn list(&self, times: &[String]) -> String {
        let mut head = vec!["case".to_owned()];
        head.extend(self.is_named().then(|| "name".to_owned()));
        head.extend(self.params.iter().map(|param| param.heading("")));
        let are_times = self.durations.as_ref().is_some_and(|durations| durations.are_times);
        head.extend(
            self.durations.iter().map(|_| if are_times { "duration [s]" } else { "share" }.to_owned()),
        );
        head.push("predicted time".to_owned());
        let mut lines = vec![head];
        for (index, case) in self.cases.iter().enumerate() {
            let mut cells = vec![(index + 1).to_string()];
            cells.extend(self.is_named().then(|| case.name.clone()));
            cells.extend(self.params.iter().zip(&case.values).map(|(column, value)| column.shown(value)));
            let duration = self.durations.iter().filter_map(|durations| durations.values.get(index));
            cells.extend(duration.map(|duration| number(*duration)));
            cells.push(times.get(index).cloned().unwrap_or_default());
            lines.push(cells);
        }
        align(&lines)
    }

    /// Writes the lines that the model has printed, below a heading per case.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write_printed(&self, path: &Path) -> io::Result<()> {
        let mut text = String::new();
        for (index, row) in self.rows.iter().enumerate().filter(|(_, row)| !row.printed.is_empty()) {
            let name = self.cases.get(index).map_or("", |case| case.name.as_str());
            let heading = format!("# case {} {name}", row.case);
            text += &format!("{}\n{}\n", heading.trim_end(), row.printed.join("\n"));
        }
        fs::write(path, text)
    }

    /// Returns the number of cases with warnings.
    pub fn warned(&self) -> usize {
        self.rows.iter().filter(|row| !row.warnings.is_empty()).count()
    }

    /// Returns the number of failed cases.
    pub fn failures(&self) -> usize {
        self.rows.iter().filter(|row| row.failure.is_some()).count()
    }

    /// Returns a statistic of an output of a row in the unit of the output; NaN without a value.
    pub fn value(&self, row: &Row, output: &Column, of: impl Fn(&Statistics) -> Option<f64>) -> f64 {
        let si = row.outputs.get(&output.name).and_then(of).unwrap_or(f64::NAN);
        from_si(si, output.factor)
    }

    /// Writes one line per case as CSV. Headings have the unit in brackets, as `read_table` reads
    /// it; values have all digits.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        let mut file = csv::Writer::from_path(path)?;
        let mut head = vec!["case".to_owned()];
        head.extend(self.is_named().then(|| "name".to_owned()));
        head.extend(self.params.iter().map(|param| param.heading("")));
        for output in &self.outputs {
            head.extend(STATISTICS.iter().map(|(name, _)| output.heading(name)));
        }
        head.extend(["failure".to_owned(), "warnings".to_owned()]);
        file.write_record(&head)?;
        for (case, row) in self.cases.iter().zip(&self.rows) {
            let mut cells = vec![row.case.to_string()];
            cells.extend(self.is_named().then(|| case.name.clone()));
            cells.extend(self.params.iter().zip(&case.values).map(|(column, value)| column.exact(value)));
            for output in &self.outputs {
                let of = |statistic: fn(&Statistics) -> Option<f64>| self.value(row, output, statistic);
                let text = |value: f64| if value.is_nan() { String::new() } else { exact(value) };
                cells.extend(STATISTICS.iter().map(|(_, statistic)| text(of(*statistic))));
            }
            cells.push(row.failure.clone().unwrap_or_default());
            cells.push(row.warnings.join("; "));
            file.write_record(&cells)?;
        }
        file.flush()
    }

    /// Formats one line per case: the varied params, and the largest values of the first outputs.
    pub fn text(&self) -> String {
        let shown = &self.outputs[..self.outputs.len().min(PRINTED)];
        let mut head = vec!["case".to_owned()];
        head.extend(self.is_named().then(|| "name".to_owned()));
        head.extend(self.params.iter().map(|param| param.heading("")));
        head.extend(shown.iter().map(|output| output.heading("max")));
        head.push(String::new());
        let mut lines = vec![head];
        for (case, row) in self.cases.iter().zip(&self.rows) {
            let mut cells = vec![row.case.to_string()];
            cells.extend(self.is_named().then(|| case.name.clone()));
            cells.extend(self.params.iter().zip(&case.values).map(|(column, value)| column.shown(value)));
            cells.extend(shown.iter().map(|output| number(self.value(row, output, |all| all.max))));
            cells.push(row.failure.clone().unwrap_or_default());
            lines.push(cells);
        }
        align(&lines)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> SweepTable {
        let column = |name: &str, unit: &str, factor| Column {
            name: name.into(),
            unit: unit.into(),
            factor,
            is_power: false,
        };
        let statistics = Statistics {
            min: Some(1e-6),
            mean: Some(2e-6),
            max: Some(3e-6),
            peak_to_peak: Some(2e-6),
            error: None,
        };
        let outputs = BTreeMap::from([("te".to_owned(), statistics)]);
        let solved = Row { case: 1, outputs, ..Row::default() };
        let failed = Row { case: 2, failure: Some("E0714: nothing carries it".into()), ..Row::default() };
        let case = |name: &str, torque| Case {
            name: name.into(),
            values: vec![ParamValue::Number(torque), ParamValue::Bool(true)],
        };
        SweepTable {
            model: "pair".into(),
            doc: String::new(),
            params: vec![column("torque", "N*mm", 1e-3), column("coast", "", 1.0)],
            outputs: vec![column("te", "um", 1e-6)],
            cases: vec![case("drive", 0.5), case("overload", 2.0)],
            rows: vec![solved, failed],
            ..SweepTable::default()
        }
    }

    #[test]
    fn a_table_has_one_line_per_case_with_units_and_failures() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("sweep.csv");
        table().write(&path).expect("written");
        let text = fs::read_to_string(path).expect("a file");
        assert_eq!(
            text,
            "case,name,torque [N*mm],coast,te.min [um],te.mean [um],te.max [um],te.peak_to_peak [um],te.max_error [um],failure,warnings\n\
             1,drive,500,TRUE,1,2,3,2,,,\n\
             2,overload,2000,TRUE,,,,,,E0714: nothing carries it,\n"
        );
        let text = table().text();
        assert!(
            text.lines().nth(2).is_some_and(|line| line.ends_with("E0714: nothing carries it")),
            "{text}"
        );
        assert_eq!(table().failures(), 1);
    }
}
