//! What an analysis yields: a row per position, a summary per output, and how long each stage took.

use crate::analysis::Position;
use crate::contact::problem::Certificate;
use crate::plan::Plan;
use crate::scene::ObservableId;
use calyx_abi::{Kernel, Repr, SymbolicValue};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Where on a body something was found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// Its name.
    pub body: String,
    /// Counted counter-clockwise from 0.
    pub tooth: u32,
    /// rad; absent where there is no involute.
    pub roll_angle: Option<f64>,
    /// m
    pub radius: f64,
}

/// The value of an observable at a position, and where it arose if it is a maximum over places.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observed {
    /// SI
    pub value: f64,
    /// Of a maximum over places.
    pub place: Option<Place>,
}

/// A wanted output: a kernel over time, params and observables.
#[derive(Clone)]
pub struct OutputRequest {
    /// As results call it.
    pub name: String,
    /// What is evaluated.
    pub value: Arc<SymbolicValue>,
    /// The kernel's param inputs.
    pub params: Arc<[f64]>,
}

impl OutputRequest {
    /// The output that is an observable of the scene and nothing more.
    pub fn observing(name: impl Into<String>, observable: ObservableId) -> OutputRequest {
        let observed = vec![observable.0 as f64];
        let value = SymbolicValue::new(0, Repr::Number, Arc::new(Itself), observed, vec![0], Vec::new());
        OutputRequest { name: name.into(), value: Arc::new(value), params: Arc::from([]) }
    }

    /// The output's value at `time` s, given the value of every observable of the scene.
    pub fn evaluate(&self, time: f64, observed: &[Observed]) -> Observed {
        let seen = |index: usize| observed.get(index).map_or(f64::NAN, |seen| seen.value);
        // An output made of one observable keeps that one's place.
        let place = match self.value.observables.as_slice() {
            [at] => observed.get(self.value.captured[*at] as usize).and_then(|seen| seen.place.clone()),
            _ => None,
        };
        let outputs = self.value.evaluate(time, &self.params, &seen).unwrap_or_default();
        Observed { value: outputs.first().copied().unwrap_or(f64::NAN), place }
    }
}

/// The kernel whose value is what it captured.
struct Itself;

impl Kernel for Itself {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        // Time comes first.
        outputs[0] = inputs[1];
    }

    fn inputs(&self) -> usize {
        2
    }

    fn outputs(&self) -> usize {
        1
    }
}

/// A solved position, as reported.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepRow {
    /// Where it was solved.
    pub position: Position,
    /// One per output.
    pub outputs: Vec<Observed>,
    /// What should be known about the position, in sentences.
    pub warnings: Vec<String>,
}

impl StepRow {
    /// The row of a position from the values of all observables of the scene.
    pub fn new(
        position: Position,
        requests: &[OutputRequest],
        observed: &[Observed],
        warnings: Vec<String>,
    ) -> Self {
        let outputs = requests.iter().map(|request| request.evaluate(position.time, observed)).collect();
        StepRow { position, outputs, warnings }
    }
}

/// A solved position and how well it was solved: what a later run needs of it to go on behind it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solved {
    /// As reported.
    pub row: StepRow,
    /// How well it is solved.
    pub certificate: Certificate,
}

/// An output over all positions, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputSummary {
    /// Least value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Over time: the trapezoidal rule on the (not quite uniform) positions.
    pub mean: f64,
    /// Largest less least.
    pub peak_to_peak: f64,
    /// Index of the position of the maximum, and where on the body it was.
    pub at_max: usize,
    /// Of the maximum.
    pub place: Option<Place>,
}

/// Everything an analysis yields.
#[derive(Clone, Debug)]
pub struct AnalysisResult {
    /// What was modelled, and why.
    pub plan: Plan,
    /// One a position, in order.
    pub rows: Vec<StepRow>,
    /// One per output.
    pub summaries: Vec<OutputSummary>,
    /// The worst residuals of all positions.
    pub certificate: Certificate,
    /// How long it took.
    pub timing: Timing,
}

/// Summarises every output over the rows.
pub fn summarize(rows: &[StepRow], outputs: &[OutputRequest]) -> Vec<OutputSummary> {
    (0..outputs.len())
        .map(|output| {
            let value = |row: &StepRow| row.outputs[output].value;
            let mut summary = OutputSummary {
                min: f64::INFINITY,
                max: f64::NEG_INFINITY,
                mean: mean_over_time(rows, value),
                peak_to_peak: 0.0,
                at_max: 0,
                place: None,
            };
            for (index, row) in rows.iter().enumerate() {
                summary.min = summary.min.min(value(row));
                if value(row) > summary.max {
                    summary.max = value(row);
                    summary.at_max = index;
                    summary.place = row.outputs[output].place.clone();
                }
            }
            summary.peak_to_peak = summary.max - summary.min;
            summary
        })
        .collect()
}

fn mean_over_time(rows: &[StepRow], value: impl Fn(&StepRow) -> f64) -> f64 {
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else { return f64::NAN };
    let span = last.position.time - first.position.time;
    if span <= 0.0 {
        return value(first);
    }
    let area: f64 = rows
        .windows(2)
        .map(|pair| {
            0.5 * (value(&pair[0]) + value(&pair[1])) * (pair[1].position.time - pair[0].position.time)
        })
        .sum();
    area / span
}

/// Where the structures of an analysis came from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StructureCounts {
    /// Condensed anew.
    pub built: usize,
    /// Taken from a cache, or from another thread that was building it.
    pub reused: usize,
}

/// Wall time of each stage, in order.
#[derive(Clone, Debug, Default)]
pub struct Timing {
    /// Name and duration.
    pub stages: Vec<(&'static str, Duration)>,
    /// How many were built, how many reused.
    pub structures: StructureCounts,
}

impl Timing {
    /// Runs `work` and records how long it took.
    pub fn stage<T>(&mut self, name: &'static str, work: impl FnOnce() -> T) -> T {
        let started = Instant::now();
        let result = work();
        self.add(name, started.elapsed());
        result
    }

    /// Records how long a stage took.
    pub fn add(&mut self, name: &'static str, time: Duration) {
        self.stages.push((name, time));
    }
}
