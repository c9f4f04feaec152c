//! What an analysis yields: a row per position, a summary per output, and how long each stage took.

mod chosen;
mod error_estimate;

pub use crate::rows::{Solved, StepRow};
pub use calyx_model::building::StructureCounts;
pub use calyx_model::observed::{Observed, OutputRequest, Place};
pub use chosen::{Choosing, Chosen, Setting, Tried};
pub(crate) use chosen::{EXHAUSTED, LARGER, percent};
pub use error_estimate::{ErrorEstimate, Part, Statistics};

use crate::observe::ModesTable;
use calyx_contact::problem::Certificate;
use calyx_model::plan::Plan;
use std::time::{Duration, Instant};

/// A multiple of the tooth mesh frequency in a quantity: `amplitude cos(2 pi order cycle + phase)`, with `cycle` the part of the mesh
/// cycle passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// From 1.
    pub order: usize,
    /// Half of peak to peak, in the unit of the quantity.
    pub amplitude: f64,
    /// rad, above -pi and up to pi.
    pub phase: f64,
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
