//! The run directory: `run.json`, `timing.json` and `steps.csv`, each position on disk before the next begins.

use calyx_abi::description::{ModelDescription, OutputDescription, ParamDescription};
use calyx_abi::{Context, Repr};
use calyx_runtime::results::{AnalysisResult, OutputSummary, StepRow, Timing};
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes one row per position as it is solved.
pub struct StepTable {
    writer: csv::Writer<File>,
}

impl StepTable {
    /// Makes the directory and the table with its header. All columns are SI; units stand in `run.json`.
    pub fn create(directory: &Path, outputs: &[OutputDescription]) -> io::Result<StepTable> {
        fs::create_dir_all(directory)?;
        let mut writer = csv::Writer::from_path(directory.join("steps.csv"))?;
        let header = ["step", "time", "cycle", "roll_angle", "point"].into_iter();
        writer.write_record(header.chain(outputs.iter().map(|output| output.name.as_str())))?;
        writer.flush()?;
        Ok(StepTable { writer })
    }

    pub fn write(&mut self, index: usize, row: &StepRow) -> io::Result<()> {
        let position = &row.position;
        let mut record = vec![index.to_string()];
        record.extend([position.time, position.cycle, position.roll].map(|number| number.to_string()));
        record.push(position.name.to_owned());
        // The shortest decimal that reads back to the same bits.
        record.extend(row.outputs.iter().map(|output| output.value.to_string()));
        self.writer.write_record(record)?;
        self.writer.flush()
    }
}

/// Writes `run.json` and `timing.json` of a finished run.
pub fn write_run(
    directory: &Path,
    description: &ModelDescription,
    context: &Context,
    result: &AnalysisResult,
    program_time: std::time::Duration,
) -> io::Result<()> {
    fs::create_dir_all(directory)?;
    let mut outputs = Map::new();
    for (output, summary) in description.outputs.iter().zip(&result.summaries) {
        outputs.insert(output.name.clone(), output_json(output, summary, result));
    }
    let ignored: Map<String, Value> =
        result.plan.ignored.iter().map(|ignored| (ignored.input.clone(), json!(ignored.reason))).collect();
    let run = json!({
        "calyx": env!("CARGO_PKG_VERSION"),
        "abi": calyx_abi::ABI_VERSION,
        "model": description.name,
        "source": source_json(description),
        "params": params_json(description, context),
        "fidelity": result.plan.fidelity.name(),
        "positions": result.rows.len(),
        "outputs": outputs,
        "certificate": {
            "complementarity": result.certificate.complementarity,
            "penetration": result.certificate.penetration,
            "tension": result.certificate.tension,
            "equilibrium": result.certificate.equilibrium,
        },
        "ignored_inputs": ignored,
        "warnings": warnings(result),
    });
    write_json(directory.join("run.json"), &run)?;
    write_json(directory.join("timing.json"), &timing_json(&result.timing, program_time))
}

/// Every distinct warning of the positions, once.
pub fn warnings(result: &AnalysisResult) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    for warning in result.rows.iter().flat_map(|row| &row.warnings) {
        if !all.contains(warning) {
            all.push(warning.clone());
        }
    }
    all
}

fn write_json(path: PathBuf, value: &Value) -> io::Result<()> {
    // Written beside and renamed, so that a reader never sees half a file.
    let unfinished = path.with_extension("json.part");
    let mut file = File::create(&unfinished)?;
    serde_json::to_writer_pretty(&mut file, value)?;
    file.write_all(b"\n")?;
    file.sync_all()?;
    fs::rename(unfinished, path)
}

fn output_json(output: &OutputDescription, summary: &OutputSummary, result: &AnalysisResult) -> Value {
    let shown = |si: f64| si / output.unit.factor;
    let row = &result.rows[summary.at_max].position;
    json!({
        "doc": output.doc,
        "unit": output.si,
        "min": summary.min,
        "max": summary.max,
        "mean": summary.mean,
        "peak_to_peak": summary.peak_to_peak,
        "display": {
            "unit": output.unit.name,
            "min": shown(summary.min),
            "max": shown(summary.max),
            "mean": shown(summary.mean),
            "peak_to_peak": shown(summary.peak_to_peak),
        },
        "max_at": {
            "step": summary.at_max,
            "time": row.time,
            "roll_angle": row.roll,
            "point": row.name,
            "place": summary.place,
        },
    })
}

fn params_json(description: &ModelDescription, context: &Context) -> Map<String, Value> {
    let values = description.params.iter().zip(&context.param_slots);
    values.map(|(param, &slot)| (param.name.clone(), param_json(param, slot, context))).collect()
}

fn param_json(param: &ParamDescription, slot: u64, context: &Context) -> Value {
    match param.repr {
        Repr::Bool => json!({ "value": slot != 0 }),
        Repr::String => json!({ "value": context.heap.str(slot) }),
        _ => {
            let value = f64::from_bits(slot);
            // What the conversion adds in the last digit is not the user's.
            let shown: f64 = format!("{:.14e}", value / param.unit.factor).parse().unwrap_or(f64::NAN);
            json!({ "value": value, "display": { "unit": param.unit.name, "value": shown } })
        }
    }
}

/// Name and hash of every file the model consists of; the first is the model itself.
fn source_json(description: &ModelDescription) -> Value {
    let mut all = Sha256::new();
    let mut files = Vec::new();
    for file in &description.files {
        all.update(file.name.as_bytes());
        all.update([0]);
        all.update(file.text.as_bytes());
        all.update([0]);
        files.push(json!({ "name": file.name, "sha256": hex(&Sha256::digest(file.text.as_bytes())) }));
    }
    json!({ "sha256": hex(&all.finalize()), "files": files })
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn timing_json(timing: &Timing, program: std::time::Duration) -> Value {
    let mut stages: Map<String, Value> = Map::new();
    let inside: f64 = timing.stages.iter().map(|(_, time)| time.as_secs_f64()).sum();
    stages.insert("program".into(), json!((program.as_secs_f64() - inside).max(0.0)));
    for (name, time) in &timing.stages {
        stages.insert((*name).into(), json!(time.as_secs_f64()));
    }
    json!({ "unit": "s", "total": program.as_secs_f64(), "stages": stages })
}
