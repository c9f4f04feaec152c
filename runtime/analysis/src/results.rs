//! Results of an analysis: rows by position, summaries by output, and timings.

mod error_estimate;
mod tolerance_outcome;

pub use crate::rows::{Solved, StepRow};
pub use calyx_model::observed::{Location, Observed, OutputRequest};
pub use calyx_model::structure_building::StructureCounts;
pub(crate) use error_estimate::DirectedErrors;
pub use error_estimate::{ErrorEstimate, Part, Statistics};
pub use tolerance_outcome::{Attempt, SearchProgress, Setting, ToleranceOutcome};
pub(crate) use tolerance_outcome::{EXHAUSTED, LARGER, percent};

use crate::component_loads::ComponentLoads;
use crate::forced_response::ForcedResponse;
use crate::observables::{CampbellDiagram, ModesTable};
use crate::sensitivity::Sensitivity;
use calyx_contact::problem::Certificate;
use calyx_model::plan::Plan;
use std::time::{Duration, Instant};

/// Harmonic of the tooth mesh frequency: `amplitude cos(2 pi order cycle + phase)`, with the
/// fraction `cycle` of the mesh cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Harmonic {
    /// Order, from 1.
    pub order: usize,
    /// Amplitude, half of peak-to-peak, in the unit of the quantity.
    pub amplitude: f64,
    /// Phase, rad, above -pi and up to pi.
    pub phase: f64,
}

/// Statistics of an output over all positions, SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputSummary {
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Mean over time: trapezoidal rule over the (not quite uniform) positions, extended to the
    /// whole cycle for an output that repeats in every mesh cycle.
    pub mean: f64,
    /// Difference between the largest and the smallest value.
    pub peak_to_peak: f64,
    /// Index of the position of the maximum.
    pub at_max: usize,
    /// Location of the maximum on a body.
    pub location: Option<Location>,
    /// Harmonics of the tooth mesh frequency, if the positions are a mesh cycle and the output
    /// repeats in every cycle.
    pub harmonics: Vec<Harmonic>,
    /// Estimated errors, if the analysis estimates them.
    pub error: Option<ErrorEstimate>,
}

impl OutputSummary {
    /// Creates the summary of an output without a value at the fidelity of the analysis; its
    /// numbers are NaN.
    pub fn none() -> OutputSummary {
        let [min, max, mean, peak_to_peak] = [f64::NAN; 4];
        OutputSummary {
            min,
            max,
            mean,
            peak_to_peak,
            at_max: 0,
            location: None,
            harmonics: Vec::new(),
            error: None,
        }
    }
}

/// All results of an analysis.
#[derive(Clone, Debug)]
pub struct AnalysisResult {
    /// Plan of the analysis.
    pub plan: Plan,
    /// Rows by position, in order.
    pub rows: Vec<StepRow>,
    /// Summaries by output.
    pub summaries: Vec<OutputSummary>,
    /// Largest residuals over all positions.
    pub certificate: Certificate,
    /// Loads of meshes and bearings, if the options request them.
    pub component_loads: Option<Vec<ComponentLoads>>,
    /// Modes about the first position, if the scene requests them.
    pub modes: Option<ModesTable>,
    /// Campbell diagram about the first position, if the scene requests it.
    pub campbell: Option<CampbellDiagram>,
    /// Forced response over the speed, if the scene requests it.
    pub forced_response: Option<ForcedResponse>,
    /// Derivatives of the outputs, if the options request them.
    pub sensitivities: Vec<Sensitivity>,
    /// Timings.
    pub timing: Timing,
    /// Outcome of the tolerance search, if a tolerance was given.
    pub tolerance_search: Option<ToleranceOutcome>,
}

impl AnalysisResult {
    /// Former name of the field [`AnalysisResult::tolerance_search`].
    #[deprecated(since = "0.1.0", note = "use the field `tolerance_search`")]
    pub fn chosen(&self) -> Option<&ToleranceOutcome> {
        self.tolerance_search.as_ref()
    }
}

/// Wall time of each stage, in order.
#[derive(Clone, Debug, Default)]
pub struct Timing {
    /// Name and duration.
    pub stages: Vec<(&'static str, Duration)>,
    /// Numbers of built and reused structures.
    pub structures: StructureCounts,
    /// Largest memory requirement of a single computation, bytes: condensation of a structure or
    /// the matrices of a position.
    pub memory: u64,
}

impl Timing {
    /// Runs `work` and records its duration.
    pub fn stage<T>(&mut self, name: &'static str, work: impl FnOnce() -> T) -> T {
        let started = Instant::now();
        let result = work();
        self.add(name, started.elapsed());
        result
    }

    /// Records the duration of a stage.
    pub fn add(&mut self, name: &'static str, time: Duration) {
        self.stages.push((name, time));
    }
}
