//! What a run has left in its directory, for those who show it beside the model: the summary of each output.

use crate::shown::rounded;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

pub use calyx_rt::directory::default_directory;

/// A run as its `run.json` tells it.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct RunSummary {
    /// By name. None if the run did not finish.
    #[serde(default)]
    pub outputs: BTreeMap<String, OutputSummary>,
    /// Positions solved.
    #[serde(default)]
    pub positions: usize,
    /// Why the run did not finish; `None` if it did.
    #[serde(default)]
    pub incomplete: Option<Incomplete>,
    #[serde(default)]
    pub warnings: Vec<String>,
    #[serde(default)]
    source: Source,
}

/// What ended a run before its time.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct Incomplete {
    pub code: String,
    pub message: String,
}

/// An output over all positions, in the unit it is shown in.
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
    // Infinity is null in JSON.
    min: Option<f64>,
    max: Option<f64>,
    mean: Option<f64>,
    peak_to_peak: Option<f64>,
}

#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
struct ErrorEstimate {
    /// Of the largest magnitude; null where that is nothing, or rounding.
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

    /// All of it on a line: `2.31 .. 2.44 inch, mean 2.4, peak to peak 0.13`. An output that does not change is one value.
    pub fn line(&self) -> String {
        let Display { unit, min, max, mean, peak_to_peak } = &self.display;
        if self.number(*min) == self.number(*max) {
            return self.mean();
        }
        let [min, max, mean, change] = [*min, *max, *mean, *peak_to_peak].map(|value| self.number(value));
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        format!("{min} .. {max}{unit}, mean {mean}, peak to peak {change}")
    }

    /// Where the maximum was: the roll angle of the first gear, and the name of a characteristic point if it is one.
    pub fn place_of_maximum(&self) -> Option<String> {
        let roll = rounded((self.max_at.roll_angle?.to_degrees() * 100.0).round() / 100.0);
        let point = &self.max_at.point;
        Some(if point.is_empty() {
            format!("at roll angle {roll} deg")
        } else {
            format!("at {point}, roll angle {roll} deg")
        })
    }

    /// The estimated error of the value of largest magnitude, and whether it leaves out what the fidelity level itself is off; `None` if it is
    /// not known.
    pub fn error(&self) -> Option<String> {
        let ErrorEstimate { relative, includes_level } = self.error_estimate.as_ref()?;
        let percent = format!("{:.1e}", 100.0 * (*relative)?).parse().map_or_else(|_| "?".into(), rounded);
        Some(match includes_level {
            true => format!("estimated error {percent} %"),
            false => {
                format!("numerical error {percent} %, the error of the fidelity level itself not included")
            }
        })
    }

    fn number(&self, value: Option<f64>) -> String {
        // Four digits are what a plane model is good for.
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
    /// # Errors
    /// The text is not what a run writes.
    pub fn from_text(text: &str) -> io::Result<RunSummary> {
        serde_json::from_str(text).map_err(io::Error::from)
    }

    /// The last run in a directory.
    ///
    /// # Errors
    /// There is none that can be read.
    pub fn read(directory: &Path) -> io::Result<RunSummary> {
        Self::from_text(&std::fs::read_to_string(directory.join("run.json"))?)
    }

    /// Whether this is a run of the model's text as it stands.
    pub fn is_of(&self, model: &str) -> bool {
        self.source.sha256 == calyx_rt::directory::text_hash(model)
    }
}
