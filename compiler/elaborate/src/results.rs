//! Reads the results of the last run from its directory, for display next to the model: a summary
//! of each output.

use crate::shown::rounded;
use calyx_abi::units::from_si;
use calyx_report::choices::{described, ordered};
use calyx_report::summary_table::without_rounding;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

pub use calyx_report::directory::default_directory;

/// A run, as described in its `run.json`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct RunSummary {
    /// Outputs by name; empty if the run did not finish.
    #[serde(default)]
    pub outputs: BTreeMap<String, OutputSummary>,
    /// Number of positions solved.
    #[serde(default)]
    pub positions: usize,
    /// The reason why the run did not finish; `None` if it did.
    #[serde(default)]
    pub incomplete: Option<Incomplete>,
    #[serde(default)]
    pub warnings: Vec<String>,
    #[serde(default)]
    source: Source,
}

/// The reason why a run stopped early.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct Incomplete {
    pub code: String,
    pub message: String,
}

/// An output over all positions, in its display unit.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct OutputSummary {
    display: Display,
    max_at: MaxAt,
    #[serde(default)]
    error_estimate: Option<ErrorEstimate>,
}

#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
struct Display {
    unit: String,
    /// Value of the unit in SI.
    #[serde(default)]
    factor: f64,
    // JSON represents infinity as null.
    min: Option<f64>,
    max: Option<f64>,
    mean: Option<f64>,
    peak_to_peak: Option<f64>,
    /// Number of positions by choice, for an output that numbers the choices of an enumeration.
    #[serde(default)]
    positions: BTreeMap<String, usize>,
}

#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
struct ErrorEstimate {
    /// Magnitude in SI up to which a value is a rounding error.
    #[serde(default)]
    rounding: f64,
    /// Estimated error relative to the largest magnitude; null if the magnitude is zero or rounding
    /// noise.
    #[serde(default)]
    relative: Option<f64>,
    #[serde(default)]
    includes_level: bool,
}

#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
struct MaxAt {
    #[serde(default)]
    roll_angle: Option<f64>,
    #[serde(default)]
    point: String,
}

#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
struct Source {
    #[serde(default)]
    sha256: String,
}

impl OutputSummary {
    pub fn mean(&self) -> String {
        self.quantity(self.display.mean)
    }

    pub fn min(&self) -> String {
        self.quantity(self.display.min)
    }

    pub fn max(&self) -> String {
        self.quantity(self.display.max)
    }

    pub fn peak_to_peak(&self) -> String {
        self.quantity(self.display.peak_to_peak)
    }

    /// Returns the summary on one line: `2.31 .. 2.44 inch, mean 2.4, peak to peak 0.13`. A
    /// constant output is shown as one value.
    pub fn line(&self) -> String {
        let Display { unit, min, max, mean, peak_to_peak, positions, .. } = &self.display;
        if !positions.is_empty() {
            let counts: Vec<_> = positions.iter().map(|(name, count)| (name.clone(), *count)).collect();
            return described(&ordered(counts));
        }
        if self.number(*min) == self.number(*max) {
            return self.mean();
        }
        let [min, max, mean, change] = [*min, *max, *mean, *peak_to_peak].map(|value| self.number(value));
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        format!("{min} .. {max}{unit}, mean {mean}, peak to peak {change}")
    }

    /// Returns the position of the maximum: the roll angle of the first gear, and the name of a
    /// characteristic point if it is one.
    pub fn place_of_maximum(&self) -> Option<String> {
        let roll = rounded((self.max_at.roll_angle?.to_degrees() * 100.0).round() / 100.0);
        let point = &self.max_at.point;
        Some(if point.is_empty() {
            format!("at roll angle {roll} deg")
        } else {
            format!("at {point}, roll angle {roll} deg")
        })
    }

    /// Returns the estimated error of the value of largest magnitude, and whether it excludes the
    /// error of the fidelity level itself; `None` if it is unknown.
    pub fn error(&self) -> Option<String> {
        let ErrorEstimate { relative, includes_level, .. } = self.error_estimate.as_ref()?;
        let percent = format!("{:.1e}", 100.0 * (*relative)?).parse().map_or_else(|_| "?".into(), rounded);
        Some(match includes_level {
            true => format!("estimated error {percent} %"),
            false => {
                format!("numerical error {percent} %, the error of the fidelity level itself not included")
            }
        })
    }

    fn number(&self, value: Option<f64>) -> String {
        let largest = [self.display.min, self.display.max]
            .into_iter()
            .flatten()
            .fold(0.0, |most: f64, own| most.max(own.abs()));
        let rounding =
            self.error_estimate.as_ref().map_or(0.0, |error| from_si(error.rounding, self.display.factor));
        let value = value.map(|value| without_rounding(value, largest, rounding));
        // Two-dimensional models are accurate to at most four digits.
        value.map_or_else(
            || "inf".into(),
            |value| format!("{value:.3e}").parse().map_or_else(|_| "?".into(), rounded),
        )
    }

    fn quantity(&self, value: Option<f64>) -> String {
        format!("{} {}", self.number(value), self.display.unit).trim_end().to_owned()
    }
}

impl RunSummary {
    /// Parses a `run.json` text.
    ///
    /// # Errors
    /// The text does not have the format of a `run.json`.
    pub fn from_text(text: &str) -> io::Result<RunSummary> {
        serde_json::from_str(text).map_err(io::Error::from)
    }

    /// Reads the last run in a directory.
    ///
    /// # Errors
    /// The directory has no readable `run.json`.
    pub fn read(directory: &Path) -> io::Result<RunSummary> {
        Self::from_text(&std::fs::read_to_string(directory.join("run.json"))?)
    }

    /// Returns `true` if the run used the current text of the model.
    pub fn is_of(&self, model: &str) -> bool {
        self.source.sha256 == calyx_report::directory::text_hash(model)
    }
}
