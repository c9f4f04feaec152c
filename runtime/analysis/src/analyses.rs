//! Interface of an analysis for programs that run any of them: [`Analysis`], implemented by the
//! options of each analysis.
//!
//! A new analysis is a type with options that implements [`Method`] and [`Analysis`]. Validation,
//! plausibility checks and the prediction of costs work on these traits.

use crate::analysis::{Observer, quasi_static};
use crate::dynamic_options::DynamicOptions;
use crate::dynamics::dynamic;
use crate::method::{Method, QuasiStatic};
use crate::options::AnalysisOptions;
use crate::results::AnalysisResult;
use crate::scene::Scene;
use crate::tolerance::quasi_static_within;
use calyx_model::observed::OutputRequest;
use calyx_model::position::Position;
use calyx_numerics::error::EngineError;

/// Analysis of a scene, from planning to results.
pub trait Analysis: Method {
    /// Returns the number of contact problems that the analysis solves: positions or time steps.
    fn problems(&self) -> usize;

    /// Returns up to about `count` times of the analysis, s, from its start to its end. Loads are
    /// checked at these times.
    fn sample_times(&self, count: usize) -> Vec<f64>;

    /// Returns the list of positions of a quasi-static analysis; `None` of a motion in time.
    fn positions(&self) -> Option<&[Position]> {
        None
    }

    /// Runs the analysis and reports its events to an observer.
    ///
    /// # Errors
    /// Those of planning, building and solving, and of the observer.
    fn run(
        &self,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        observer: &mut dyn Observer,
    ) -> Result<AnalysisResult, EngineError>;

    /// Returns whether [`Analysis::run_within`] is available.
    fn supports_tolerance(&self) -> bool {
        false
    }

    /// Runs the analysis with the cheapest settings whose estimated errors are within a tolerance,
    /// relative to the largest magnitude of every output.
    ///
    /// # Errors
    /// E0791: the analysis has no such search; this is the default. Otherwise those of
    /// [`Analysis::run`].
    fn run_within(
        &self,
        _tolerance: f64,
        _scene: &Scene,
        _outputs: &[OutputRequest],
        _options: &AnalysisOptions,
        _observer: &mut dyn Observer,
    ) -> Result<AnalysisResult, EngineError> {
        Err(without_tolerance())
    }
}

/// Returns the error for a tolerance that an analysis does not support.
pub fn without_tolerance() -> EngineError {
    EngineError::new(
        "E0791",
        "a motion in time cannot be analysed to a tolerance",
        "leave it out, and take shorter steps and finer meshes; or analyse quasi-statically",
    )
    .blame("tolerance")
}

impl Analysis for QuasiStatic<'_> {
    fn problems(&self) -> usize {
        self.positions.len()
    }

    fn sample_times(&self, count: usize) -> Vec<f64> {
        let step = self.positions.len().div_ceil(count.max(1)).max(1);
        let last = self.positions.last();
        self.positions.iter().step_by(step).chain(last).map(|position| position.time).collect()
    }

    fn positions(&self) -> Option<&[Position]> {
        Some(&self.positions)
    }

    fn run(
        &self,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        observer: &mut dyn Observer,
    ) -> Result<AnalysisResult, EngineError> {
        quasi_static(scene, &self.positions, outputs, options, observer)
    }

    fn supports_tolerance(&self) -> bool {
        true
    }

    fn run_within(
        &self,
        tolerance: f64,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        observer: &mut dyn Observer,
    ) -> Result<AnalysisResult, EngineError> {
        quasi_static_within(tolerance, scene, &self.positions, outputs, options, observer)
    }
}

impl Analysis for DynamicOptions {
    fn problems(&self) -> usize {
        self.ranges.iter().map(|range| range.steps).sum()
    }

    fn sample_times(&self, count: usize) -> Vec<f64> {
        let whole: f64 = self.ranges.iter().map(|range| range.duration).sum();
        let count = count.max(1);
        (0..=count).map(|k| self.from + whole * k as f64 / count as f64).collect()
    }

    fn run(
        &self,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        observer: &mut dyn Observer,
    ) -> Result<AnalysisResult, EngineError> {
        dynamic(scene, outputs, options, self, observer)
    }
}
