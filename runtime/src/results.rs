//! What an analysis yields: a row per position, a summary per output, and how long each stage took.

use crate::analysis::Position;
use crate::contact::problem::Certificate;
use crate::estimate::ErrorEstimate;
use crate::observe::{Course, ModesTable, Observable};
use crate::plan::Plan;
use crate::scene::ObservableId;
use crate::summary::Harmonic;
use crate::tolerance::Chosen;
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
    /// Along the axis from the middle of the face, m; absent in a plane model.
    pub axial: Option<f64>,
}

/// The value of an observable at a position, and where it arose if it is a maximum over places.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Observed {
    /// SI
    pub value: f64,
    /// The least of the values that `value` is the largest of, where an observable tells of a range: of the same place of
    /// several teeth, say.
    pub least: Option<f64>,
    /// Of a maximum over places.
    pub place: Option<Place>,
}

impl Observed {
    /// A value that has no place.
    pub const fn number(value: f64) -> Observed {
        Observed { value, least: None, place: None }
    }
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
        let ranges = |index: usize| observed.get(index).is_some_and(|seen| seen.least.is_some());
        let low =
            |index: usize| observed.get(index).map_or(f64::NAN, |seen| seen.least.unwrap_or(seen.value));
        let least = self.observes(ranges).then(|| self.at(time, &low));
        Observed { value: self.at(time, &seen), least, place }
    }

    /// The value at `time` s for these values of observables, by their indices.
    fn at(&self, time: f64, observed: &dyn Fn(usize) -> f64) -> f64 {
        let outputs = self.value.evaluate(time, &self.params, observed).unwrap_or_default();
        outputs.first().copied().unwrap_or(f64::NAN)
    }

    /// Whether it depends on an observable that is like this.
    fn observes(&self, like: impl Fn(usize) -> bool) -> bool {
        self.value.observes().into_iter().any(like)
    }

    /// Whether every mesh cycle gives the same values of it, if teeth are alike: it observes something, nothing that follows
    /// one tooth, and does not depend on time itself.
    pub(crate) fn repeats(&self, observables: &[Arc<dyn Observable>], times: [f64; 2]) -> bool {
        let passes =
            |index: usize| observables.get(index).is_none_or(|seen| seen.quantity().course == Course::Passes);
        // Any values will do to see whether time makes a difference.
        let [now, later] = times.map(|time| self.at(time, &|index| 0.7 + 0.1 * index as f64).to_bits());
        self.observes(|_| true) && !self.observes(passes) && now == later
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
    /// Of a step in time: the state of its coordinates, from which the next one goes on; empty in equilibrium.
    pub state: Vec<f64>,
}

/// An output over all positions, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputSummary {
    /// Least value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Over time: the trapezoidal rule on the (not quite uniform) positions; of a quantity that every mesh cycle repeats, over the
    /// whole cycle.
    pub mean: f64,
    /// Largest less least.
    pub peak_to_peak: f64,
    /// Index of the position of the maximum, and where on the body it was.
    pub at_max: usize,
    /// Of the maximum.
    pub place: Option<Place>,
    /// Of the tooth mesh frequency and its multiples, where the positions are a mesh cycle and every cycle gives the same values.
    pub harmonics: Vec<Harmonic>,
    /// How wrong all this probably is, where the analysis estimates it.
    pub error: Option<ErrorEstimate>,
}

impl OutputSummary {
    /// Of an output that has no value at the fidelity of the analysis: its numbers are none.
    pub fn none() -> OutputSummary {
        let [min, max, mean, peak_to_peak] = [f64::NAN; 4];
        OutputSummary {
            min,
            max,
            mean,
            peak_to_peak,
            at_max: 0,
            place: None,
            harmonics: Vec::new(),
            error: None,
        }
    }
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
    /// Modes about the first position, if the scene asks for them.
    pub modes: Option<ModesTable>,
    /// How long it took.
    pub timing: Timing,
    /// What was chosen for a tolerance, if there was one.
    pub chosen: Option<Chosen>,
}

/// Where the structures of an analysis came from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StructureCounts {
    /// Condensed anew.
    pub built: usize,
    /// Taken from a cache, in memory or on disk, or from another thread that was building it.
    pub reused: usize,
}

/// Wall time of each stage, in order.
#[derive(Clone, Debug, Default)]
pub struct Timing {
    /// Name and duration.
    pub stages: Vec<(&'static str, Duration)>,
    /// How many were built, how many reused.
    pub structures: StructureCounts,
    /// The most memory that was asked for at once, bytes: to condense a structure, or for the matrices of a position.
    pub memory: u64,
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
