//! What a run yields.

use crate::error::Error;
use crate::names::{Names, Output, OutputName};
use crate::program::Program;
use crate::stepping::{Step, factor};
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_abi::units::from_si;
use calyx_abi::{Context, RuntimeError};
use calyx_gears::host::{Finding, ModelHost};
use calyx_runtime::contact::problem::Certificate;
use calyx_runtime::plan::Plan;
use calyx_runtime::results::{AnalysisResult, OutputSummary, Timing};
use calyx_runtime::signal::Signal;
use calyx_runtime::summary::Harmonic;
use std::sync::Arc;
use std::time::Duration;

/// What a run yields: of a model without an analysis, only what it found and printed.
pub struct Results {
    program: Arc<dyn Program>,
    shape: u64,
    params: Vec<ParamValue>,
    analysis: Option<AnalysisResult>,
    findings: Vec<Finding>,
    signals: Vec<Signal>,
    time: Duration,
}

impl Results {
    /// Takes from a context what its program has left there.
    pub(crate) fn of(
        program: Arc<dyn Program>,
        shape: u64,
        params: Vec<ParamValue>,
        context: &mut Context,
        time: Duration,
    ) -> Result<Results, Error> {
        let (mut analysis, mut findings, mut signals, mut failed) = (None, Vec::new(), Vec::new(), false);
        if let Some(host) = context.host::<ModelHost>() {
            analysis = host.result.take();
            findings = std::mem::take(&mut host.findings);
            signals = std::mem::take(&mut host.signals);
            failed = host.failed_analyses > 0;
        }
        if analysis.is_none() && !program.description().outputs.is_empty() {
            return Err(no_analysis(program.description(), failed).into());
        }
        Ok(Results { program, shape, params, analysis, findings, signals, time })
    }

    pub fn description(&self) -> &ModelDescription {
        self.program.description()
    }

    fn names(&self) -> Names<'_> {
        Names { description: self.program.description(), shape: self.shape }
    }

    /// # Errors
    /// The model has no such output.
    pub fn output(&self, name: &str) -> Result<Output, Error> {
        Output::named(self.description(), name)
    }

    /// What the params were, in order, in SI.
    pub fn params(&self) -> &[ParamValue] {
        &self.params
    }

    /// All there is of the analysis; `None` for a model without one.
    pub fn analysis(&self) -> Option<&AnalysisResult> {
        self.analysis.as_ref()
    }

    /// Every solved position, in order.
    pub fn steps(&self) -> impl ExactSizeIterator<Item = Step> + '_ {
        let rows = self.analysis.as_ref().map_or(&[][..], |result| &result.rows);
        rows.iter().enumerate().map(|(index, row)| Step {
            program: self.program.clone(),
            shape: self.shape,
            index,
            count: rows.len(),
            row: Arc::new(row.clone()),
        })
    }

    /// An output over all positions, in the unit the model shows it in.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn summary(&self, output: impl OutputName) -> Result<OutputSummary, Error> {
        let (index, summary) = self.summarised(output)?;
        let unit = self.description().outputs.get(index).map_or(1.0, |output| output.unit.factor);
        Ok(shown(summary, unit))
    }

    /// An output over all positions, in SI.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn summary_si(&self, output: impl OutputName) -> Result<&OutputSummary, Error> {
        Ok(self.summarised(output)?.1)
    }

    /// An output over all positions, in a unit of one's choice, like `N*m`.
    ///
    /// # Errors
    /// The model has no such output, or it is of another dimension.
    pub fn summary_in(&self, output: impl OutputName, unit: &str) -> Result<OutputSummary, Error> {
        let (index, summary) = self.summarised(output)?;
        Ok(shown(summary, factor(self.description(), index, unit)?))
    }

    fn summarised(&self, output: impl OutputName) -> Result<(usize, &OutputSummary), Error> {
        let index = output.index_in(self.names())?;
        let summary = self.analysis.as_ref().and_then(|result| result.summaries.get(index));
        let summary = summary.ok_or_else(|| Error::from(no_analysis(self.description(), false)))?;
        Ok((index, summary))
    }

    /// What the model asked of its outputs in the frequency domain, in SI.
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// The worst residuals of all positions; `None` for a model without an analysis.
    pub fn certificate(&self) -> Option<&Certificate> {
        self.analysis.as_ref().map(|result| &result.certificate)
    }

    /// How it was analysed, and which inputs that leaves out; `None` for a model without an analysis.
    pub fn plan(&self) -> Option<&Plan> {
        self.analysis.as_ref().map(|result| &result.plan)
    }

    /// How long the stages of the analysis took; `None` for a model without one.
    pub fn timing(&self) -> Option<&Timing> {
        self.analysis.as_ref().map(|result| &result.timing)
    }

    /// How long the model ran, its analysis included.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// What the library found, with places in the source.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Every distinct warning of the positions, once.
    pub fn warnings(&self) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        let rows = self.analysis.iter().flat_map(|result| &result.rows);
        for warning in rows.flat_map(|row| &row.warnings) {
            if !all.contains(warning) {
                all.push(warning.clone());
            }
        }
        all
    }
}

fn shown(summary: &OutputSummary, unit: f64) -> OutputSummary {
    let harmonic =
        |harmonic: &Harmonic| Harmonic { amplitude: from_si(harmonic.amplitude, unit), ..*harmonic };
    OutputSummary {
        min: from_si(summary.min, unit),
        max: from_si(summary.max, unit),
        mean: from_si(summary.mean, unit),
        peak_to_peak: from_si(summary.peak_to_peak, unit),
        harmonics: summary.harmonics.iter().map(harmonic).collect(),
        ..summary.clone()
    }
}

/// The error of a model that declares outputs without an analysis that yields them; `failed`: it
/// caught the error of one. The place is the end of the model, where an analysis would stand.
pub fn no_analysis(description: &ModelDescription, failed: bool) -> RuntimeError {
    let end = description.files.first().map_or(0, |file| file.text.trim_end().len() as u32);
    let (message, help) = match failed {
        true => (
            "the model declares outputs, and its analysis failed",
            "the model caught the error of the analysis; print it there to see what it was",
        ),
        false => (
            "the model declares outputs and analyses nothing",
            "end it with `analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 32));`",
        ),
    };
    let error = RuntimeError::new("E0711", message, help);
    RuntimeError { place: Some((0, end.saturating_sub(1), end)), ..error }
}
