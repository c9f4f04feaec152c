//! The run directory: `run.json`, `timing.json` and `steps.csv`. Each position is on disk before
//! the next one starts.

use crate::bearing_loads::BearingLoads;
use crate::body_pictures;
use crate::choices::counts;
use crate::contact_pattern::ContactPattern;
use crate::field_tables::{self, FieldTables};
use crate::former_keys::{self, ResultFile};
use crate::journal::{FoundJournal, Journal};
use crate::stress_range::StressRange;
use crate::vtu::{self, VtuFiles};
use calyx_abi::RuntimeError;
use calyx_abi::description::{
    FileDescription, ModelDescription, OutputDescription, ParamDescription, ParamValue, stored_bytes,
};
use calyx_abi::units::from_si;
use calyx_runtime::analysis::Position;
use calyx_runtime::estimate::{ErrorEstimate, Statistics};
use calyx_runtime::observables::Fields;
use calyx_runtime::plan::Plan;
use calyx_runtime::results::{AnalysisResult, OutputSummary, Solved, StepRow, StructureCounts, Timing};
use calyx_runtime::settings_override::Override;
use calyx_runtime::summary::Harmonic;
use calyx_runtime::tolerance::{Attempt, Setting, ToleranceOutcome};
use calyx_view::ViewFiles;
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Folder of tables and plots in the frequency domain, in a run directory.
pub const SIGNALS: &str = "signals";
/// HTML report in a run directory, see [`crate::page`].
pub const REPORT: &str = "report.html";

/// Key of the data of gears and meshes in `run.json`.
pub const GEAR_DATA: &str = "gear_data";
/// Key of the power flow of gear trains in `run.json`.
pub const POWER_FLOW: &str = "power_flow";

/// Names of stages in order, with the duration of each.
pub type StageTimes = Vec<(&'static str, Duration)>;

/// Returns the default run directory: next to the model and named after it.
pub fn default_directory(model: &Path) -> PathBuf {
    let mut name = model.file_name().unwrap_or_default().to_owned();
    name.push(".run");
    model.with_file_name(name)
}

/// Reads `run.json` of a directory, with current names of keys; `None` if there is none.
pub fn read_run(directory: &Path) -> io::Result<Option<Value>> {
    match fs::read(directory.join("run.json")) {
        Ok(text) => Ok(Some(former_keys::current(ResultFile::Run, serde_json::from_slice(&text)?))),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// Reads the results in a directory as one document: the contents of `run.json`, and `steps` with
/// the rows of `steps.csv` by column.
pub fn document(directory: &Path) -> io::Result<Value> {
    let run = read_run(directory)?.ok_or(io::ErrorKind::NotFound)?;
    let mut document = former_keys::with_former(ResultFile::Run, run);
    let table = directory.join("steps.csv");
    if table.exists() {
        let mut reader = csv::Reader::from_path(table)?;
        let columns = reader.headers()?.clone();
        let mut rows = Vec::new();
        for record in reader.records() {
            let record = record?;
            let cells = columns
                .iter()
                .zip(&record)
                .map(|(column, cell)| (column.to_owned(), cell_json(column, cell)));
            rows.push(Value::Object(cells.collect()));
        }
        document["steps"] = json!(rows);
    }
    Ok(document)
}

/// Converts a cell to JSON, which has no infinity: numbers that are not finite become null.
fn cell_json(column: &str, cell: &str) -> Value {
    match column {
        "point" => json!(cell),
        "step" => json!(cell.parse::<usize>().ok()),
        _ => json!(cell.parse::<f64>().ok()),
    }
}

/// Largest number of positions whose contact and stress are recorded if not all are requested. It
/// suffices for every position of a mesh cycle and is small compared to the steps of a long
/// simulation.
const RECORDED: usize = 256;

/// Files that a run writes in addition to its rows and the data of the report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Details {
    /// Field tables, see [`crate::field_tables`].
    pub tables: bool,
    /// VTU files for ParaView, see [`crate::vtu`].
    pub vtu: bool,
    /// Universal files of radiating surfaces, see [`crate::unv`]; not for every position.
    pub unv: bool,
}

impl Details {
    /// Returns the largest number of positions whose fields are recorded.
    pub fn positions(self) -> usize {
        if self.tables || self.vtu { usize::MAX } else { RECORDED }
    }

    /// Returns true if an earlier run has written these files for its first positions.
    pub fn are_in(self, directory: &Path, positions: usize) -> bool {
        (positions == 0 || field_tables::are_in(directory, self.tables))
            && (!self.vtu || vtu::are_in(directory, positions))
    }
}

/// Writer of solved positions: tables, pictures and VTU files for users, and the journal for a run
/// that resumes.
pub struct Record {
    directory: PathBuf,
    table: StepTable,
    tables: FieldTables,
    stresses: StressRange,
    pattern: ContactPattern,
    bearings: BearingLoads,
    vtu: Option<VtuFiles>,
    view: ViewFiles,
    journal: Journal,
}

impl Record {
    /// Starts a record at the first position.
    pub fn begin(
        directory: &Path,
        outputs: &[OutputDescription],
        head: &Value,
        details: Details,
    ) -> io::Result<Record> {
        Ok(Record {
            directory: directory.to_owned(),
            table: StepTable::create(directory, outputs)?,
            tables: FieldTables::create(directory, details.tables)?,
            stresses: StressRange::create(directory)?,
            pattern: ContactPattern::create(directory)?,
            bearings: BearingLoads::create(directory)?,
            vtu: details.vtu.then(|| VtuFiles::begin(directory, Vec::new())).transpose()?,
            view: ViewFiles::begin(directory, model_of(head))?,
            journal: Journal::create(directory, head)?,
        })
    }

    /// Continues the record of an earlier run after its solved positions.
    pub fn resume(
        directory: &Path,
        outputs: &[OutputDescription],
        head: &Value,
        found: &FoundJournal,
        details: Details,
    ) -> io::Result<Record> {
        let tables = match found.solved.len() {
            0 => FieldTables::create(directory, details.tables)?,
            solved => FieldTables::resume(directory, solved, details.tables)?,
        };
        let (stresses, pattern) = (StressRange::resume(directory)?, ContactPattern::resume(directory)?);
        let bearings = BearingLoads::resume(directory)?;
        let times = found.solved.iter().map(|solved| solved.row.position.time).collect();
        let vtu = details.vtu.then(|| VtuFiles::begin(directory, times)).transpose()?;
        let mut table = StepTable::create(directory, outputs)?;
        for (index, solved) in found.solved.iter().enumerate() {
            table.write(index, &solved.row)?;
        }
        let journal = Journal::resume(directory, found)?;
        let view = ViewFiles::resume(directory, model_of(head))?;
        let directory = directory.to_owned();
        Ok(Record { directory, table, tables, stresses, pattern, bearings, vtu, view, journal })
    }

    pub fn write(
        &mut self,
        index: usize,
        outputs: &[OutputDescription],
        solved: &Solved,
        fields: Option<&Fields>,
    ) -> io::Result<()> {
        if let Some(fields) = fields {
            self.tables.write(index, &solved.row, outputs, fields)?;
            self.stresses.add(fields)?;
            self.pattern.add(index, fields)?;
            let time = solved.row.position.time;
            self.bearings.add((index, time), fields)?;
            body_pictures::update(&self.directory, (index, time), fields)?;
            self.view.write((index, time), fields)?;
            if let Some(vtu) = &mut self.vtu {
                vtu.write(index, time, fields)?;
            }
        }
        self.journal.write(solved)?;
        self.table.write(index, &solved.row)
    }
}

/// Returns the name of the model of a run, and its system of units.
fn model_of(head: &Value) -> (&str, &str) {
    let text = |key: &str| head[key].as_str().unwrap_or_default();
    (text("model"), text("units"))
}

/// Writer of `steps.csv`, one row per position.
pub struct StepTable {
    writer: csv::Writer<File>,
}

impl StepTable {
    /// Creates the table with its header. All columns are in SI; the units are in `run.json`.
    pub fn create(directory: &Path, outputs: &[OutputDescription]) -> io::Result<StepTable> {
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
        record.push(position.name.clone().into_owned());
        // The shortest decimal that parses to the same bits; empty for an output that the fidelity
        // level does not support.
        let shown = |value: f64| if value.is_nan() { String::new() } else { value.to_string() };
        record.extend(row.outputs.iter().map(|output| shown(output.value)));
        self.writer.write_record(record)?;
        self.writer.flush()
    }
}

/// Writes `run.json` of a run that ended early: its subject (`run`, see [`head`]), its progress,
/// and the reason.
pub fn write_unfinished(
    directory: &Path,
    mut run: Value,
    solved: usize,
    ended_by: &RuntimeError,
) -> io::Result<()> {
    run["incomplete"] = json!({ "code": ended_by.code, "message": ended_by.message });
    run["positions"] = json!(solved);
    write_json(directory, ResultFile::Run, run)
}

/// Returns the subject of a run and the columns of outputs in its table of positions. For an
/// unfinished run this is the only description of the columns.
pub fn head(description: &ModelDescription, params: &[ParamValue], overrides: &Override) -> Value {
    let mut head = subject(description, params, overrides);
    let columns = description.outputs.iter().map(|output| (output.name.clone(), column_json(output)));
    head[COLUMNS] = json!(columns.collect::<Map<_, _>>());
    head
}

/// Returns the subject of a run: versions, source, params, and overrides of the analysis settings,
/// if any.
fn subject(description: &ModelDescription, params: &[ParamValue], overrides: &Override) -> Value {
    let mut head = json!({
        "calyx": env!("CARGO_PKG_VERSION"),
        "abi": description.abi,
        "model": description.name,
        "doc": description.doc,
        "units": description.units,
        "source": source_json(description),
        "params": params_json(description, params),
    });
    if !overrides.is_none() {
        let overridden = overrides.overridden().into_iter();
        // Numbers stay numbers.
        let value = |text: String| serde_json::from_str(&text).unwrap_or(json!(text));
        head["overrides"] = overridden.map(|(name, text)| (name.to_owned(), value(text))).collect();
    }
    head
}

/// Key of the names of the choices that the values of an output number from 0.
pub(crate) const CHOICES: &str = "choices";

/// Key of the table columns in `run.json` of an unfinished run.
const COLUMNS: &str = "columns";

fn column_json(output: &OutputDescription) -> Value {
    let display = json!({ "unit": output.unit.name, "factor": output.unit.factor });
    let mut column = json!({ "doc": output.doc, "unit": output.si, "display": display });
    if !output.choices.is_empty() {
        column[CHOICES] = json!(output.choices);
    }
    column
}

/// Outputs of a finished run: the positions of an analysis, or the only row of a calculation.
#[derive(Clone, Copy)]
pub struct RunOutputs<'a> {
    /// Description of the model.
    pub description: &'a ModelDescription,
    /// A row per position.
    pub rows: &'a [StepRow],
    /// A summary per output, in their order.
    pub summaries: &'a [OutputSummary],
}

/// Writes `run.json` and `timing.json` of a finished run with the subject `run` (see [`head`]).
/// `signals` are those of `signals::list`, which needs the feature `pages`.
pub fn write_run(
    directory: &Path,
    mut run: Value,
    (outputs, result): (RunOutputs, Option<&AnalysisResult>),
    signals: Value,
    warnings: &[String],
    stages: &Stages,
) -> io::Result<()> {
    // A finished run describes its outputs in more detail.
    if let Some(run) = run.as_object_mut() {
        run.remove(COLUMNS);
    }
    if !outputs.rows.is_empty() || result.is_some() {
        let summaries = outputs.description.outputs.iter().zip(outputs.summaries);
        let position = |summary: &OutputSummary| {
            Some(&outputs.rows.get(summary.at_max)?.position).filter(|_| result.is_some())
        };
        let json = summaries.enumerate().map(|(index, (output, summary))| {
            let mut json = output_json(output, summary, position(summary));
            if !output.choices.is_empty() {
                add_choices(&mut json, &output.choices, outputs.rows, index);
            }
            (output.name.clone(), json)
        });
        run["positions"] = json!(outputs.rows.len());
        run["outputs"] = json!(json.collect::<Map<_, _>>());
    }
    if let Some(result) = result {
        let ignored =
            result.plan.ignored.iter().map(|ignored| (ignored.input.clone(), json!(ignored.reason)));
        run["fidelity"] = json!(result.plan.fidelity.name());
        run["plan"] = plan_json(&result.plan);
        run["certificate"] = json!({
            "complementarity": result.certificate.complementarity,
            "penetration": result.certificate.penetration,
            "tension": result.certificate.tension,
            "equilibrium": result.certificate.equilibrium,
        });
        if let Some(outcome) = &result.tolerance_search {
            run["tolerance_search"] = tolerance_json(outcome);
        }
        run["ignored_inputs"] = json!(ignored.collect::<Map<_, _>>());
        let refused =
            result.plan.refused.iter().map(|refused| (refused.name.clone(), json!(refused.needs.name())));
        run["refused_outputs"] = json!(refused.collect::<Map<_, _>>());
        run["signals"] = signals;
    }
    run["warnings"] = json!(warnings);
    write_json(directory, ResultFile::Run, run)?;
    let timing = timing_json(result.map(|result| &result.timing), stages);
    write_json(directory, ResultFile::Timing, timing)
}

/// Durations of the stages around the analysis.
#[derive(Clone, Debug, Default)]
pub struct Stages {
    /// Stages before the run, such as checking and compiling.
    pub before: StageTimes,
    /// Duration of the program, including its analysis.
    pub program: Duration,
    /// Number of positions solved by an earlier run; their time is not included.
    pub solved_before: usize,
}

/// Writes a result file, with the former names of its keys.
fn write_json(directory: &Path, file: ResultFile, document: Value) -> io::Result<()> {
    let path = directory.join(file.name());
    let document = former_keys::with_former(file, document);
    // Written to a temporary file and renamed, so that a reader never sees a partial file.
    let unfinished = path.with_extension("json.part");
    let mut file = File::create(&unfinished)?;
    serde_json::to_writer_pretty(&mut file, &document)?;
    file.write_all(b"\n")?;
    file.sync_all()?;
    fs::rename(unfinished, path)
}

/// Returns the modelling decisions for the scene, with their reasons.
fn plan_json(plan: &Plan) -> Value {
    let bodies = plan.bodies.iter().map(|body| {
        let part = json!({ "modelled": !body.left_out, "elastic": body.is_elastic(), "reason": body.reason });
        (body.name.clone(), part)
    });
    let bearings = plan.bearings.iter().map(|bearing| {
        (bearing.name.clone(), json!({ "modelled": !bearing.left_out, "reason": bearing.reason }))
    });
    let mut all =
        json!({ "bodies": bodies.collect::<Map<_, _>>(), "bearings": bearings.collect::<Map<_, _>>() });
    if !plan.connections.is_empty() {
        let connections = plan.connections.iter().map(|connection| {
            let part = json!({ "modelled": !connection.left_out, "reason": connection.reason });
            (connection.name.clone(), part)
        });
        all["elastic_connections"] = connections.collect::<Map<_, _>>().into();
    }
    all
}

/// Returns the summary of an output. `position` is that of its maximum; `None` without an analysis.
fn output_json(output: &OutputDescription, summary: &OutputSummary, position: Option<&Position>) -> Value {
    let shown = |si: f64| from_si(si, output.unit.factor);
    let harmonics = summary.harmonics.iter().map(|Harmonic { order, amplitude, phase }| {
        json!({ "order": order, "amplitude": amplitude, "phase": phase, "display": shown(*amplitude) })
    });
    let mut all = json!({
        "doc": output.doc,
        "unit": output.si,
        "min": summary.min,
        "max": summary.max,
        "mean": summary.mean,
        "peak_to_peak": summary.peak_to_peak,
        "harmonics": harmonics.collect::<Vec<_>>(),
        "display": {
            "unit": output.unit.name,
            "factor": output.unit.factor,
            "min": shown(summary.min),
            "max": shown(summary.max),
            "mean": shown(summary.mean),
            "peak_to_peak": shown(summary.peak_to_peak),
        },
        "max_at": {
            "step": summary.at_max,
            "time": position.map(|at| at.time),
            "roll_angle": position.map(|at| at.roll),
            "point": position.map_or("", |at| at.name.as_ref()),
            "location": summary.location,
        },
    });
    if let Some(error) = &summary.error {
        all["error_estimate"] = error_json(error, summary);
    }
    all
}

/// Adds the names of the choices of an output, in the order of their numbers, and the number of
/// positions by choice.
fn add_choices(json: &mut Value, choices: &[String], rows: &[StepRow], index: usize) {
    let values = rows.iter().filter_map(|row| row.outputs.get(index)).map(|at| at.value);
    let positions = counts(choices, values).into_iter().map(|(choice, count)| (choice, json!(count)));
    json["display"]["positions"] = json!(positions.collect::<Map<_, _>>());
    json[CHOICES] = json!(choices);
}

/// Returns the result of the tolerance search and its earlier trials.
fn tolerance_json(outcome: &ToleranceOutcome) -> Value {
    let setting = |Setting { fidelity, refinement, cells, positions }: &Setting| json!({ "fidelity": fidelity.name(), "refinement": refinement, "contact_cells": cells, "positions": positions });
    let attempts = outcome.attempts.iter().map(|Attempt { setting: own, whole, worst: (output, error) }| {
        json!({ "setting": setting(own), "all_positions": whole, "output": output, "relative": error })
    });
    let selected = outcome.attempts.get(outcome.selected);
    json!({
        "tolerance": outcome.tolerance,
        "satisfied": outcome.ended.is_none(),
        "ended_by": outcome.ended,
        "relative": selected.map(|attempt| attempt.worst.1),
        "all_positions": selected.is_none_or(|attempt| attempt.whole),
        "setting": setting(&outcome.setting),
        "reason": outcome.describe(),
        "attempts": attempts.collect::<Vec<_>>(),
    })
}

/// Returns an error estimate: errors in SI, `relative` as a fraction of the largest magnitude.
/// `includes_level` states whether the error of the fidelity level is included. `rounding` is the
/// magnitude up to which a value may be rounding error alone.
fn error_json(error: &ErrorEstimate, summary: &OutputSummary) -> Value {
    let statistics = |Statistics { min, max, mean, peak_to_peak }: &Statistics| json!({ "min": min, "max": max, "mean": mean, "peak_to_peak": peak_to_peak });
    let parts: Map<_, _> =
        error.parts.iter().map(|(part, errors)| (part.name().to_owned(), statistics(errors))).collect();
    let reasons: Map<_, _> =
        error.not_estimated.iter().map(|(part, why)| (part.name().to_owned(), json!(why))).collect();
    let mut all = statistics(&error.total);
    all["relative"] = json!(error.relative(summary));
    all["includes_level"] = json!(error.includes_level());
    all["rounding"] = json!(error.rounding);
    all["is_rounding"] = json!(error.is_rounding(summary));
    all["parts"] = json!(parts);
    all["not_estimated"] = json!(error.not_estimated.iter().map(|(part, _)| part.name()).collect::<Vec<_>>());
    all["reasons"] = json!(reasons);
    all
}

fn params_json(description: &ModelDescription, params: &[ParamValue]) -> Map<String, Value> {
    let values = description.params.iter().zip(params);
    values
        .map(|(param, value)| {
            let mut entry = param_json(param, value);
            entry["doc"] = json!(param.doc);
            entry["at_default"] = json!(param.default.as_ref() == Some(value));
            (param.name.clone(), entry)
        })
        .collect()
}

fn param_json(param: &ParamDescription, value: &ParamValue) -> Value {
    match value {
        ParamValue::Bool(value) => json!({ "value": value }),
        ParamValue::String(text) => json!({ "value": text }),
        ParamValue::Number(si) => {
            json!({ "value": si, "display": { "unit": param.unit.name, "value": displayed(*si, param) } })
        }
        ParamValue::Numbers(si) => {
            let shown: Vec<f64> = si.iter().map(|si| displayed(*si, param)).collect();
            json!({ "value": si, "display": { "unit": param.unit.name, "value": shown } })
        }
    }
}

/// Converts a number to the unit of the param's default, without the rounding error of the
/// conversion.
fn displayed(si: f64, param: &ParamDescription) -> f64 {
    format!("{:.14e}", from_si(si, param.unit.factor)).parse().unwrap_or(f64::NAN)
}

/// Returns the model's hash, and name and hash of each of its files and of each table that it reads
/// at the params' defaults.
fn source_json(description: &ModelDescription) -> Value {
    let hash = |file: &FileDescription| text_hash(&file.text);
    let files: Vec<Value> =
        description.files.iter().map(|file| json!({ "name": file.name, "sha256": hash(file) })).collect();
    let tables: Vec<Value> =
        description.tables.iter().map(|file| json!({ "name": file.name, "sha256": hash(file) })).collect();
    json!({ "sha256": description.files.first().map(hash), "files": files, "tables": tables })
}

/// Returns the hash that `run.json` stores to identify the file that this text stores.
pub fn text_hash(text: &str) -> String {
    hex(&Sha256::digest(stored_bytes(text)))
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn timing_json(analysis: Option<&Timing>, around: &Stages) -> Value {
    let mut stages: Map<String, Value> = Map::new();
    let mut add = |name: &str, time: f64| stages.insert(name.into(), json!(time));
    for (name, time) in &around.before {
        add(name, time.as_secs_f64());
    }
    let inside = analysis.map_or(&[][..], |timing| &timing.stages);
    let solving: f64 = inside.iter().map(|(_, time)| time.as_secs_f64()).sum();
    add("program", (around.program.as_secs_f64() - solving).max(0.0));
    for (name, time) in inside {
        add(name, time.as_secs_f64());
    }
    let before: Duration = around.before.iter().map(|(_, time)| *time).sum();
    let mut timing =
        json!({ "unit": "s", "total": (before + around.program).as_secs_f64(), "stages": stages });
    if let Some(Timing { structures: StructureCounts { built, reused }, memory, .. }) = analysis {
        timing["structures"] = json!({ "built": built, "reused": reused });
        timing["solved_before"] = json!(around.solved_before);
        timing["memory"] = json!({ "unit": "byte", "requested": memory });
    }
    timing
}
