//! Results of a run.

use crate::error::Error;
#[cfg(feature = "command")]
use crate::flank_tables::MeshedFlanks;
use crate::names::{Names, Output, OutputName};
use crate::program::Program;
use crate::stepping::{Step, factor};
use calyx_abi::Context;
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_abi::units::from_si;
use calyx_gears::data_block::DataBlock;
use calyx_gears::host::{Finding, ModelHost};
use calyx_gears::power_flow::PowerFlow;
use calyx_gears::sensitivity_externs;
#[cfg(feature = "command")]
use calyx_report::flank_tables::FlankTables;
use calyx_runtime::contact::problem::Certificate;
use calyx_runtime::forced_response::ForcedResponse;
use calyx_runtime::plan::Plan;
use calyx_runtime::results::{AnalysisResult, Observed, OutputSummary, Solved, StepRow, Timing};
use calyx_runtime::sensitivity::Sensitivity;
use calyx_runtime::signal::Signal;
use calyx_runtime::summary::Harmonic;
use std::sync::Arc;
use std::time::Duration;

/// Results of a run; for a model without an analysis its calculated outputs, findings and printed
/// lines.
pub struct Results {
    program: Arc<dyn Program>,
    shape: u64,
    params: Vec<ParamValue>,
    analysis: Option<AnalysisResult>,
    calculated: Option<Calculated>,
    findings: Vec<Finding>,
    signals: Vec<Signal>,
    /// Indices of the outputs that are differentiated.
    differentiated: Vec<usize>,
    /// True if the model requests the derivatives, not the program that runs it.
    of_model: bool,
    gear_data: DataBlock,
    power_flows: Vec<PowerFlow>,
    #[cfg(feature = "command")]
    flanks: Option<MeshedFlanks>,
    tables: Vec<String>,
    time: Duration,
}

/// Outputs of a model without an analysis.
struct Calculated {
    /// The only row, at time zero.
    row: StepRow,
    summaries: Vec<OutputSummary>,
    sensitivities: Vec<Sensitivity>,
}

impl Calculated {
    fn new(row: StepRow, sensitivities: Vec<Sensitivity>) -> Calculated {
        let constant = |output: &Observed| OutputSummary {
            min: output.value,
            max: output.value,
            mean: output.value,
            peak_to_peak: 0.0,
            ..OutputSummary::none()
        };
        let summaries = row.outputs.iter().map(constant).collect();
        Calculated { row, summaries, sensitivities }
    }
}

impl Results {
    /// Takes the results that the program has left in a context. `calculated` has the outputs of a
    /// model without an analysis.
    pub(crate) fn of(
        program: Arc<dyn Program>,
        shape: u64,
        params: Vec<ParamValue>,
        context: &mut Context,
        (calculated, time): (Option<(Solved, Vec<Sensitivity>)>, Duration),
    ) -> Results {
        let (mut analysis, mut findings, mut signals) = (None, Vec::new(), Vec::new());
        #[cfg(feature = "command")]
        let flanks = context.host::<ModelHost>().map(|host| MeshedFlanks::of(host));
        let (mut gear_data, mut tables) = (DataBlock::default(), Vec::new());
        let (mut power_flows, mut differentiated, mut of_model) = (Vec::new(), Vec::new(), false);
        if let Some(host) = context.host::<ModelHost>() {
            gear_data = DataBlock::of(host);
            power_flows = std::mem::take(&mut host.power_flows);
            tables = host.tables.iter().map(|table| table.name.clone()).collect();
            analysis = host.result.take();
            findings = std::mem::take(&mut host.findings);
            signals = std::mem::take(&mut host.signals);
            differentiated = sensitivity_externs::differentiated(host);
            of_model = host.analysis.sensitivities.is_none();
        }
        let calculated = calculated.map(|(solved, derivatives)| Calculated::new(solved.row, derivatives));
        Results {
            program,
            shape,
            params,
            analysis,
            calculated,
            findings,
            signals,
            differentiated,
            of_model,
            gear_data,
            power_flows,
            #[cfg(feature = "command")]
            flanks,
            tables,
            time,
        }
    }

    pub fn description(&self) -> &ModelDescription {
        self.program.description()
    }

    fn names(&self) -> Names<'_> {
        Names { description: self.program.description(), shape: self.shape }
    }

    /// Returns the handle of an output.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn output(&self, name: &str) -> Result<Output, Error> {
        Output::named(self.description(), name)
    }

    /// Returns the values of the params, in order, in SI.
    pub fn params(&self) -> &[ParamValue] {
        &self.params
    }

    /// Returns the result of the analysis; `None` for a model without one.
    pub fn analysis(&self) -> Option<&AnalysisResult> {
        self.analysis.as_ref()
    }

    /// Returns the rows by position, in order; one row for a model without an analysis that has
    /// outputs.
    pub(crate) fn rows(&self) -> &[StepRow] {
        match (&self.analysis, &self.calculated) {
            (Some(result), _) => &result.rows,
            (None, Some(calculated)) => std::slice::from_ref(&calculated.row),
            (None, None) => &[],
        }
    }

    /// Returns the summaries by output.
    pub(crate) fn summaries(&self) -> &[OutputSummary] {
        match (&self.analysis, &self.calculated) {
            (Some(result), _) => &result.summaries,
            (None, Some(calculated)) => &calculated.summaries,
            (None, None) => &[],
        }
    }

    /// Returns the solved positions, in order. The outputs of a model without an analysis are one
    /// position at time zero.
    pub fn steps(&self) -> impl ExactSizeIterator<Item = Step> + '_ {
        let rows = self.rows();
        rows.iter().enumerate().map(|(index, row)| Step {
            program: self.program.clone(),
            shape: self.shape,
            index,
            count: rows.len(),
            row: Arc::new(row.clone()),
        })
    }

    /// Returns the summary of an output over all positions, in the unit in which the model shows
    /// it.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn summary(&self, output: impl OutputName) -> Result<OutputSummary, Error> {
        let (index, summary) = self.summarised(output)?;
        let unit = self.description().outputs.get(index).map_or(1.0, |output| output.unit.factor);
        Ok(shown(summary, unit))
    }

    /// Returns the summary of an output over all positions, in SI.
    ///
    /// # Errors
    /// The model has no such output.
    pub fn summary_si(&self, output: impl OutputName) -> Result<&OutputSummary, Error> {
        Ok(self.summarised(output)?.1)
    }

    /// Returns the summary of an output over all positions, in the given unit, like `N*m`.
    ///
    /// # Errors
    /// The model has no such output, or it has another dimension.
    pub fn summary_in(&self, output: impl OutputName, unit: &str) -> Result<OutputSummary, Error> {
        let (index, summary) = self.summarised(output)?;
        Ok(shown(summary, factor(self.description(), index, unit)?))
    }

    fn summarised(&self, output: impl OutputName) -> Result<(usize, &OutputSummary), Error> {
        let index = output.index_in(self.names())?;
        let summary = self.summaries().get(index);
        Ok((index, summary.ok_or_else(|| Error::given("the run has no results", ""))?))
    }

    /// Returns the signals in the frequency domain that the model requests, in SI.
    pub fn signals(&self) -> &[Signal] {
        &self.signals
    }

    /// Computes the tables of the flanks of meshes on general axes.
    #[cfg(feature = "command")]
    pub(crate) fn flank_tables(&self) -> FlankTables {
        self.flanks.as_ref().map(MeshedFlanks::tables).unwrap_or_default()
    }

    /// Returns the data of the gears and meshes of the model, as in the data block of a drawing.
    pub fn gear_data(&self) -> &DataBlock {
        &self.gear_data
    }

    /// Returns the power flow of the gear trains that the model reports.
    pub fn power_flows(&self) -> &[PowerFlow] {
        &self.power_flows
    }

    /// Returns the derivatives of the outputs that [`crate::Instance::request_sensitivities`]
    /// requested, by param, in SI.
    pub fn sensitivities(&self) -> &[Sensitivity] {
        match (&self.analysis, &self.calculated) {
            (Some(result), _) => &result.sensitivities,
            (None, Some(calculated)) => &calculated.sensitivities,
            (None, None) => &[],
        }
    }

    /// Returns the indices of the outputs that are differentiated.
    pub fn differentiated(&self) -> &[usize] {
        &self.differentiated
    }

    /// Returns whether the model requests the derivatives, not the program that runs it.
    pub fn are_derivatives_of_model(&self) -> bool {
        self.of_model
    }

    /// Returns the largest residuals over all positions; `None` for a model without an analysis.
    pub fn certificate(&self) -> Option<&Certificate> {
        self.analysis.as_ref().map(|result| &result.certificate)
    }

    /// Returns the modelling decisions and the inputs that they ignore; `None` for a model without
    /// an analysis.
    pub fn plan(&self) -> Option<&Plan> {
        self.analysis.as_ref().map(|result| &result.plan)
    }

    /// Returns the durations of the stages of the analysis; `None` for a model without one.
    pub fn timing(&self) -> Option<&Timing> {
        self.analysis.as_ref().map(|result| &result.timing)
    }

    /// Returns the names of the tables that the run has read, as the model gives them.
    pub fn tables(&self) -> &[String] {
        &self.tables
    }

    /// Returns the duration of the program, including its analysis.
    pub fn time(&self) -> Duration {
        self.time
    }

    /// Returns the findings of the library, with source locations.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Returns each distinct warning of the positions once.
    pub fn warnings(&self) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        let rows = self.analysis.iter().flat_map(|result| &result.rows);
        for warning in rows.flat_map(|row| &row.warnings) {
            if !all.contains(warning) {
                all.push(warning.clone());
            }
        }
        let response = self.analysis.as_ref().and_then(|result| result.forced_response.as_ref());
        all.extend(response.map_or(Vec::new(), ForcedResponse::warnings));
        let failures = self.sensitivities().iter().filter_map(|own| Some((own, own.failure.as_ref()?)));
        all.extend(failures.map(|(own, why)| {
            format!("{}: no derivative with respect to `{}`: {}", why.code, own.param.name, why.message)
        }));
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
