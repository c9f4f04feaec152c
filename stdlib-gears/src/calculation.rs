//! Outputs of a model without an analysis: a pure calculation.

use crate::host::ModelHost;
use calyx_abi::RuntimeError;
use calyx_runtime::analysis::Position;
use calyx_runtime::contact::problem::Certificate;
use calyx_runtime::error::{EngineError, Subject};
use calyx_runtime::results::{Observed, OutputRequest, Solved, StepRow};

/// NaN and two arbitrary times, s: an output that is the same at all of them does not depend on
/// time. The last one is shown as the time of a NaN.
const TIMES: [f64; 3] = [f64::NAN, 0.731_058_578_630_004_9, 0.0];

/// Computes the outputs of a model that has run without an analysis, as one position at time zero;
/// `None` for a model without outputs.
///
/// # Errors
/// E0711: an output or a signal needs an analysis, or the analysis failed. E0721: an output is NaN.
pub fn calculate(host: &ModelHost) -> Result<Option<Solved>, RuntimeError> {
    if host.outputs.is_empty() {
        return Ok(None);
    }
    if host.failed_analyses > 0 {
        return Err(needs_analysis(
            host,
            0,
            "the model declares outputs, and its analysis failed".into(),
            "the model caught the error of the analysis; print it there to see what it was",
        ));
    }
    let mut outputs = Vec::with_capacity(host.outputs.len());
    for (index, output) in host.outputs.iter().enumerate() {
        outputs.push(Observed::number(value_of(host, index, output)?));
    }
    if let Some(asked) = host.asked_signals.first() {
        let signal = "a signal needs an analysis, and the model has none".into();
        return Err(RuntimeError { place: Some(asked.place), ..needs_analysis(host, 0, signal, ANALYZE) });
    }
    let row = StepRow { position: Position::at(0.0), outputs, warnings: Vec::new() };
    Ok(Some(Solved { row, certificate: Certificate::default(), state: Vec::new() }))
}

/// Returns the values of the outputs of such a model next to a value of a param; NaN where there is
/// none.
pub fn values(host: &ModelHost) -> Vec<Observed> {
    let value = |output: &OutputRequest| Observed::number(output.at(TIMES[2], &|_| f64::NAN));
    host.outputs.iter().map(value).collect()
}

/// Remedy for an output that needs an analysis.
const ANALYZE: &str = "end the model with `analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 32));`";

fn value_of(host: &ModelHost, index: usize, output: &OutputRequest) -> Result<f64, RuntimeError> {
    let name = &output.name;
    if output.observes(|_| true) {
        let message = format!("the output `{name}` needs an analysis, and the model has none");
        return Err(needs_analysis(host, index, message, ANALYZE));
    }
    let [never, later, value] = TIMES.map(|time| output.at(time, &|_| f64::NAN));
    if value.to_bits() != later.to_bits() || value.to_bits() != never.to_bits() {
        return Err(needs_analysis(
            host,
            index,
            format!("the output `{name}` depends on `Time`, and the model has no analysis"),
            "add a time to the output, as in `at Time = 0 s`, or end the model with `analyze(...)`",
        ));
    }
    if value.is_nan() {
        let error = EngineError::new(
            "E0721",
            format!("output `{name}` is not a number"),
            "look for 0/0, inf - inf or the root of a negative number",
        );
        return Err(host.engine_error(error.about(Subject::Output(index))));
    }
    Ok(value)
}

/// Returns the error of an output that needs an analysis, at its declaration.
fn needs_analysis(host: &ModelHost, output: usize, message: String, help: &str) -> RuntimeError {
    RuntimeError {
        place: host.output_places.get(output).copied(),
        ..RuntimeError::new("E0711", message, help)
    }
}
