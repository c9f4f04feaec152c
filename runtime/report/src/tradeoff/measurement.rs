//! Measurement of a setting, read from its run directory: times, and values at every position.

use super::Setting;
use crate::directory::read_run;
use crate::former_keys::{self, ResultFile};
use std::fs;
use std::io;
use std::path::Path;

/// Measurement of a setting.
#[derive(Clone, Debug)]
pub struct Measurement {
    pub setting: Setting,
    /// Predicted time, s.
    pub predicted: Option<f64>,
    /// Time to condense structures, s; if it shares them with another setting of the same mesh,
    /// that setting's.
    pub structures: f64,
    /// Time of all positions, s, including those solved by an earlier run.
    pub positions: f64,
    /// Largest estimated memory requirement, bytes.
    pub memory: u64,
    /// Number of structures that were condensed, not taken from the cache.
    pub built: u64,
    /// Times of the positions, s.
    pub times: Vec<f64>,
    /// Outputs, in the model's order.
    pub outputs: Vec<Series>,
}

/// Values of an output at the positions, SI; NaN if the fidelity level lacks it.
#[derive(Clone, Debug)]
pub struct Series {
    pub name: String,
    pub values: Vec<f64>,
    pub min: f64,
    pub max: f64,
    pub mean: f64,
    pub peak_to_peak: f64,
}

impl Measurement {
    /// Reads a finished run; `None` if there is none, or if its time is unknown.
    ///
    /// # Errors
    /// Its files cannot be read.
    pub fn read(
        setting: &Setting,
        predicted: Option<f64>,
        directory: &Path,
    ) -> io::Result<Option<Measurement>> {
        let Some(run) = read_run(directory)?.filter(|run| run.get("incomplete").is_none()) else {
            return Ok(None);
        };
        let timing = match fs::read(directory.join("timing.json")) {
            Ok(text) => former_keys::current(ResultFile::Timing, serde_json::from_slice(&text)?),
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(error),
        };
        let mut reader = csv::Reader::from_path(directory.join("steps.csv"))?;
        let columns = reader.headers()?.clone();
        let rows: Vec<csv::StringRecord> = reader.records().collect::<Result<_, _>>()?;
        let column = |name: &str| -> Vec<f64> {
            let at = columns.iter().position(|column| column == name);
            let cell =
                |row: &csv::StringRecord| at.and_then(|at| row.get(at)?.parse().ok()).unwrap_or(f64::NAN);
            rows.iter().map(cell).collect()
        };
        let stage = |name: &str| timing["stages"][name].as_f64().unwrap_or(0.0);
        let solved_before = timing["solved_before"].as_u64().unwrap_or(0) as usize;
        let Some(solved_here) = rows.len().checked_sub(solved_before).filter(|here| *here > 0) else {
            return Ok(None);
        };
        let series = |name: &String| {
            let output = &run["outputs"][name];
            let number = |statistic: &str| output[statistic].as_f64().unwrap_or(f64::NAN);
            Series {
                name: name.clone(),
                values: column(name),
                min: number("min"),
                max: number("max"),
                mean: number("mean"),
                peak_to_peak: number("peak_to_peak"),
            }
        };
        // The order of the table is that of the model.
        let names = columns.iter().map(str::to_owned).filter(|name| run["outputs"].get(name).is_some());
        Ok(Some(Measurement {
            setting: setting.clone(),
            predicted,
            structures: stage("structures") + stage("modes"),
            positions: stage("positions") * rows.len() as f64 / solved_here as f64,
            memory: timing["memory"]["requested"].as_u64().unwrap_or(0),
            built: timing["structures"]["built"].as_u64().unwrap_or(0),
            times: column("time"),
            outputs: names.collect::<Vec<_>>().iter().map(series).collect(),
        }))
    }

    /// Returns the time of structures and positions, s.
    pub fn time(&self) -> f64 {
        self.structures + self.positions
    }

    pub fn output(&self, name: &str) -> Option<&Series> {
        self.outputs.iter().find(|output| output.name == name)
    }
}

impl Series {
    /// Returns the largest magnitude at any position.
    pub fn magnitude(&self) -> f64 {
        self.values.iter().fold(0.0, |largest, value| largest.max(value.abs()))
    }
}
