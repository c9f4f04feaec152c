//! A complete run: an instance, its progress display, and its run directory.

use crate::engine::Engine;
use crate::error::Error;
use crate::gear_data;
use crate::instance::{Instance, NO_PARAMS};
use crate::param_assignment::ParamAssignment;
use crate::power_flow;
use crate::program::Program;
use crate::progress::{Progress, ProgressFormat};
use crate::results::Results;
use crate::resume::{self, EarlierRun};
use crate::run_directory::{DirectoryError, Kind, RunDirectory};
use crate::sensitivity_journal::{SENSITIVITY_JOURNAL, SensitivityJournal};
use calyx_abi::description::{ModelDescription, OutputDescription};
use calyx_abi::{Cancel, RuntimeError, Status};
use calyx_gears::host::Finding;
use calyx_report::directory::{
    Details, GEAR_DATA, POWER_FLOW, REPORT, Record, RunOutputs, SIGNALS, StageTimes, Stages, head, write_run,
    write_unfinished,
};
use calyx_report::journal::FoundJournal;
use calyx_report::sensitivity::{
    SENSITIVITIES, SENSITIVITIES_BY_POSITION, text, write_positions, write_table,
};
use calyx_report::{
    bearing_loads, body_pictures, campbell, contact_pattern, field_tables, flank_tables, forced_response,
    journal, modes_table, page, radiated_sound, signals, stress_range, summary_table, unv, view, vtu,
};
use calyx_runtime::error::EngineError;
use calyx_runtime::observables::Fields;
use calyx_runtime::results::Solved;
use calyx_runtime::settings_override::Override;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;
use std::{fs, io};

/// Options of a run.
#[derive(Clone, Debug, Default)]
pub struct RunOptions {
    pub engine: Engine,
    /// Directory of the results.
    pub directory: PathBuf,
    /// Values assigned to params; the last one of a name counts.
    pub given: Vec<ParamAssignment>,
    /// Leaves out the derivatives that the model requests.
    pub without_derivatives: bool,
    /// Suppresses all output except errors and the text that the program prints.
    pub quiet: bool,
    /// Format of the progress display; `quiet` suppresses the human-readable one.
    pub progress: ProgressFormat,
    /// Redirects the text that the program prints to standard error.
    pub print_to_error: bool,
    /// Stages that preceded the run, for `timing.json`.
    pub before: StageTimes,
    /// Limit of the duration of the run.
    pub time_limit: Option<Duration>,
    /// Limit of memory in bytes: of the program's values, and of the process during the analysis.
    pub memory_limit: Option<u64>,
    /// Replaces files that bear the names of results but were not written by a run.
    pub force: bool,
    /// Resumes after the positions that an earlier run completed.
    pub resume: bool,
    /// Writes the fields of every position as tables.
    pub fields: bool,
    /// Writes a VTU file of every position, for ParaView.
    pub vtu: bool,
    /// Writes the vibration of radiating surfaces as universal files.
    pub unv: bool,
    /// Settings that override the analysis settings of the model.
    pub overrides: Override,
    /// Cancellation from outside: ends the run soon; the files written so far are kept.
    pub cancel: Cancel,
}

impl RunOptions {
    fn details(&self) -> Details {
        Details { tables: self.fields, vtu: self.vtu, unv: self.unv }
    }
}

/// Reason why a run did not finish.
#[derive(Debug)]
pub enum RunError {
    /// Error in the given values, the model or its analysis.
    Run(Error),
    /// The run was ended from outside or by a limit. The positions solved until then are in its
    /// directory.
    Ended {
        error: Box<RuntimeError>,
        positions: usize,
    },
    /// Results cannot be written to the directory; the directory is unchanged.
    Directory(DirectoryError),
    Io {
        path: PathBuf,
        error: io::Error,
    },
}

/// Text for the user about a finished run.
#[derive(Default)]
pub struct RunReport {
    /// Table of outputs; empty for a model without outputs.
    pub summary: String,
    /// Warnings about the results.
    pub warnings: Vec<String>,
    /// Findings of the library, with source locations.
    pub findings: Vec<Finding>,
    /// True if an earlier run was complete, so that this one did nothing.
    pub finished_before: bool,
    /// Directory of the results, locked against other runs until this is dropped.
    pub directory: Option<Arc<RunDirectory>>,
    /// True if the tolerance search ended early: the results do not meet the tolerance.
    pub tolerance_missed: bool,
}

impl From<DirectoryError> for RunError {
    fn from(error: DirectoryError) -> RunError {
        RunError::Directory(error)
    }
}

/// Runs a model and writes its run directory. Results of an earlier run in the directory are
/// removed when the first position is solved; a run that fails before that leaves them unchanged.
pub fn run(program: Arc<dyn Program>, options: &RunOptions) -> Result<RunReport, RunError> {
    let path = options.directory.as_path();
    let unwritable = |error| RunError::Io { path: path.to_owned(), error };
    let mut instance = Instance::new(&options.engine, program.clone());
    for given in &options.given {
        instance.give(given).map_err(RunError::Run)?;
    }
    if options.without_derivatives {
        instance.request_sensitivities(NO_PARAMS).map_err(RunError::Run)?;
    }
    instance.limit_time(options.time_limit);
    instance.limit_memory(options.memory_limit);
    instance.set_cancel(options.cancel.clone());
    instance.override_analysis(options.overrides);
    let params = instance.params().map_err(RunError::Run)?;
    instance.fix_outputs().map_err(RunError::Run)?;
    let program = instance.program().clone();
    let description = program.description();
    let head = head(description, &params, &options.overrides);
    let directory = lock(path, description, options.force)?;
    instance.store_sensitivities(Arc::new(SensitivityJournal::new(directory.clone(), &head, &[])));
    let progress = Arc::new(Progress::new(options.progress, options.quiet, options.print_to_error));
    let found = match earlier(options, &head)? {
        EarlierRun::Finished => {
            progress.finish();
            // The earlier run may have been ended before it wrote its last file.
            if !path.join(REPORT).exists() {
                directory.write_page().map_err(unwritable)?;
            }
            return Ok(RunReport {
                finished_before: true,
                directory: Some(directory),
                ..RunReport::default()
            });
        }
        EarlierRun::Unfinished(found) => {
            let count = found.solved.len();
            progress.note(&format!("resuming after {count} positions of the run in {}", path.display()));
            instance.resume_after(found.solved.clone());
            directory.keep().map_err(unwritable)?;
            Some(found)
        }
        EarlierRun::Nothing => {
            if options.resume {
                let path = path.display();
                progress.note(&format!("{path} contains nothing to resume: starting a new run"));
            } else if let Some(count) = interrupted(&options.directory, &head) {
                progress.note(&format!(
                    "this run replaces {count} positions of an interrupted run in {}; --resume would continue after them",
                    path.display()
                ));
            }
            None
        }
    };
    let (shown, printed) = (progress.clone(), progress.clone());
    instance.on_progress(move |now| match now.total {
        Some(count) if now.done > 0 => shown.step(now.done - 1, count),
        // A stage that begins.
        _ => shown.stage(now.stage),
    });
    instance.on_print(move |line| printed.print(line));
    let chosen = progress.clone();
    instance.on_choosing(move |choosing| chosen.choosing(choosing));
    let (solved, outcome) =
        write_steps(instance, &directory, &head, found.as_ref(), (options.details(), progress.clone()));
    progress.finish();
    let results = match outcome {
        // The positions solved before a cancellation are kept, with the description of their run.
        Err(RunError::Run(Error::Model(error))) if error.status() == Status::Cancelled && solved > 0 => {
            let written = write_unfinished(path, head, solved, &error);
            written.and_then(|()| directory.write_page()).map_err(unwritable)?;
            return Err(RunError::Ended { error: Box::new(error), positions: solved });
        }
        outcome => outcome?,
    };
    if solved == 0 {
        begin(&directory, options.details()).map_err(unwritable)?;
    }
    let solved_before = found.map_or(0, |found| found.solved.len());
    let stages = Stages { before: options.before.clone(), program: results.time(), solved_before };
    let written = write_results(&directory, head, description, &results, (&stages, options.details()));
    let advice = written.map_err(unwritable)?;
    let mut report = report(description, &results);
    if options.unv && !has_sound(&results) {
        let text =
            "--unv writes no files: the model observes no radiated sound, such as by `gears.radiated_power`";
        report.warnings.push(text.into());
    }
    report.summary.extend(advice.into_iter().map(|line| line + "\n"));
    Ok(RunReport { directory: Some(directory), ..report })
}

/// Locks the directory of a run for writing.
fn lock(
    path: &Path,
    description: &ModelDescription,
    force: bool,
) -> Result<Arc<RunDirectory>, DirectoryError> {
    let directory = RunDirectory::lock(path, Kind::Run, force)?;
    directory.check_folder(SIGNALS, |name| signals::is_name_of_a_run(description, name))?;
    directory.check_folder(vtu::FOLDER, vtu::is_name_of_a_run)?;
    directory.check_folder(unv::FOLDER, unv::is_name_of_a_run)?;
    let is_picture =
        |name: &str| body_pictures::is_name_of_a_run(name) || radiated_sound::is_picture_of_a_run(name);
    directory.check_folder(body_pictures::FOLDER, is_picture)?;
    directory.check_folder(view::FOLDER, view::files::is_name_of_a_run)?;
    Ok(Arc::new(directory))
}

/// Finished run in memory, of a program that embeds models.
pub struct FinishedRun<'r> {
    pub results: &'r Results,
    /// Settings that overrode the analysis settings of the model.
    pub overrides: Override,
    /// Solved positions, with the fields that the run requested ([`Instance::on_solved`]).
    pub positions: &'r [(Solved, Option<Fields>)],
    /// Files of every position.
    pub details: Details,
    /// Stages that preceded the run, for `timing.json`.
    pub before: StageTimes,
}

impl FinishedRun<'_> {
    /// Writes the directory that [`run`] writes for the same run; files that present fields are
    /// omitted if the run requested none. Results of an earlier run in the directory are replaced.
    ///
    /// # Errors
    /// The directory has files that no run wrote and `force` is false; another process writes to
    /// it; or it cannot be written.
    pub fn save(&self, path: &Path, force: bool) -> Result<(), RunError> {
        let unwritable = |error| RunError::Io { path: path.to_owned(), error };
        let description = self.results.description();
        let head = head(description, self.results.params(), &self.overrides);
        let directory = lock(path, description, force)?;
        let mut written = Written { record: None, solved: 0, failure: None };
        for (index, (solved, fields)) in self.positions.iter().enumerate() {
            let position = (index, solved, fields.as_ref());
            let outputs = &description.outputs;
            written.write(&directory, outputs, &head, self.details, position).map_err(unwritable)?;
        }
        if self.positions.is_empty() {
            begin(&directory, self.details).map_err(unwritable)?;
        } else if self.positions.iter().all(|(_, fields)| fields.is_none()) {
            // Without rows, a table would say that there is no load.
            fs::remove_file(path.join(field_tables::LINE_LOAD)).map_err(unwritable)?;
            // The folder stays if it has files of the user.
            let _ = fs::remove_dir(path.join(view::FOLDER));
        }
        let stages = Stages { before: self.before.clone(), program: self.results.time(), solved_before: 0 };
        write_results(&directory, head, description, self.results, (&stages, self.details))
            .map_err(unwritable)?;
        Ok(())
    }
}

/// Removes the results of an earlier run and lists the files that every run writes.
fn begin(directory: &RunDirectory, details: Details) -> io::Result<()> {
    directory.clear()?;
    directory.claim_all(["run.json", "run.json.part", "timing.json", "timing.json.part", "steps.csv"])?;
    directory.claim_all(["journal.jsonl"].iter().chain(&page::FILES))?;
    directory.claim_all([stress_range::NAME, "root_stress_range.csv.part"])?;
    directory.claim_all(contact_pattern::FILES)?;
    directory.claim_all(bearing_loads::FILES)?;
    directory.claim_all(flank_tables::FILES)?;
    let asked_for = if details.tables { &field_tables::NAMES[..] } else { &[field_tables::LINE_LOAD] };
    directory.claim_all(asked_for)
}

/// Writes the final files of a run. Returns the settings that reduce large estimated errors, in one
/// line, if there are such errors.
fn write_results(
    directory: &RunDirectory,
    mut head: Value,
    description: &ModelDescription,
    results: &Results,
    (stages, details): (&Stages, Details),
) -> io::Result<Option<String>> {
    let path = directory.path();
    if !results.gear_data().is_empty() {
        head[GEAR_DATA] = gear_data::json(results.gear_data());
    }
    if !results.power_flows().is_empty() {
        head[POWER_FLOW] = power_flow::json(results.power_flows());
    }
    let findings = results.findings().iter();
    let mut warnings: Vec<String> =
        findings.map(|finding| format!("{}: {}", finding.error.code, finding.error.message)).collect();
    warnings.extend(results.warnings());
    let result = results.analysis();
    if let Some(modes) = result.and_then(|result| result.modes.as_ref()) {
        directory.claim(modes_table::NAME)?;
        modes_table::write(path, modes)?;
    }
    if let Some(diagram) = result.and_then(|result| result.campbell.as_ref()) {
        directory.claim(campbell::NAME)?;
        campbell::write(path, diagram)?;
    }
    if let Some(response) = result.and_then(|result| result.forced_response.as_ref()) {
        directory.claim(forced_response::NAME)?;
        directory.claim(forced_response::MODES)?;
        forced_response::write(path, response)?;
        if !response.sounds.is_empty() {
            head[radiated_sound::KEY] = radiated_sound::json(response);
            directory.claim_all(radiated_sound::files(response))?;
            radiated_sound::write(path, response)?;
            directory.claim_all(radiated_sound::picture_files(response))?;
            radiated_sound::write_pictures(path, response)?;
            if details.vtu {
                directory.claim_all(vtu::sound_files(response))?;
                vtu::write_sound(path, response)?;
            }
            if details.unv {
                directory.claim_all(unv::files(response))?;
                unv::write_sound(path, response)?;
            }
        }
    }
    if let Some(table) = results.model_sensitivities() {
        directory.claim_all([SENSITIVITIES, SENSITIVITIES_BY_POSITION])?;
        write_table(&path.join(SENSITIVITIES), &table)?;
        write_positions(&path.join(SENSITIVITIES_BY_POSITION), &table)?;
    }
    results.flank_tables().write(path)?;
    directory.claim_all(signals::files(results.signals()))?;
    signals::write(path, description, results.signals())?;
    // Before the journal is removed, so that a run that is killed here is resumed.
    directory.draw_pictures()?;
    let listed = signals::list(description, results.signals());
    let outputs = RunOutputs { description, rows: results.rows(), summaries: results.summaries() };
    write_run(path, head, (outputs, result), listed, &warnings, stages)?;
    journal::remove(path)?;
    directory.remove_owned(SENSITIVITY_JOURNAL)?;
    directory.claim_all(page::FILES)?;
    page::write_with_advice(path)
}

/// Builds the report of a finished run.
fn report(description: &ModelDescription, results: &Results) -> RunReport {
    let result = results.analysis();
    let modes = result.and_then(|result| result.modes.as_ref());
    let ignored = result.iter().flat_map(|result| &result.plan.ignored);
    let ignored =
        ignored.map(|ignored| format!("`{}` is not used as given: {}", ignored.input, ignored.reason));
    RunReport {
        summary: result.map_or_else(
            || summary_table::values(description, results.rows()),
            |result| summary_table::summary(description, result),
        ) + &modes.map(modes_table::summary).unwrap_or_default()
            + &signals::summary(description, results.signals())
            + &results.model_sensitivities().map(|table| format!("\n{}", text(&table))).unwrap_or_default(),
        warnings: ignored.chain(results.warnings()).collect(),
        findings: results.findings().to_vec(),
        tolerance_missed: result
            .and_then(|result| result.tolerance_search.as_ref()?.ended.as_ref())
            .is_some(),
        ..RunReport::default()
    }
}

/// Returns true if radiating surfaces vibrate.
fn has_sound(results: &Results) -> bool {
    let response = results.analysis().and_then(|result| result.forced_response.as_ref());
    response.is_some_and(|response| !unv::files(response).is_empty())
}

/// Returns the number of positions of an interrupted run with the same subject, if there is one.
fn interrupted(directory: &Path, head: &Value) -> Option<usize> {
    match resume::find(directory, head) {
        Ok(EarlierRun::Unfinished(found)) => Some(found.solved.len()).filter(|count| *count > 0),
        _ => None,
    }
}

/// Finds the earlier run to resume, if there is one.
fn earlier(options: &RunOptions, head: &Value) -> Result<EarlierRun, RunError> {
    if !options.resume {
        return Ok(EarlierRun::Nothing);
    }
    let found = resume::find(&options.directory, head).map_err(|not| match not {
        resume::ResumeError::Other(refused) => RunError::Run(Error::Given(refused)),
        resume::ResumeError::Io(error) => RunError::Io { path: options.directory.clone(), error },
    })?;
    let positions = match &found {
        EarlierRun::Nothing => return Ok(found),
        // These files are written at the end of a run.
        EarlierRun::Finished if options.unv && !options.directory.join(unv::FOLDER).exists() => {
            return Ok(EarlierRun::Nothing);
        }
        EarlierRun::Unfinished(found) => found.solved.len(),
        EarlierRun::Finished => 1,
    };
    // If requested details of the earlier positions are missing, the positions must be solved
    // again.
    let complete = options.details().are_in(&options.directory, positions);
    Ok(if complete { found } else { EarlierRun::Nothing })
}

/// Runs the instance and writes each position to disk before the next one begins. Returns the
/// number of positions and the outcome of the run.
fn write_steps(
    mut instance: Instance,
    directory: &Arc<RunDirectory>,
    head: &Value,
    found: Option<&FoundJournal>,
    (details, progress): (Details, Arc<Progress>),
) -> (usize, Result<Results, RunError>) {
    let path = directory.path();
    let unwritable = |error| RunError::Io { path: path.to_owned(), error };
    let outputs = instance.description().outputs.clone();
    instance.request_fields(details.positions());
    instance.request_bodies(details.vtu);
    instance.request_parts(true);
    let solved = found.map_or(0, |found| found.solved.len());
    let record = match found.map(|found| Record::resume(path, &outputs, head, found, details)).transpose() {
        Ok(record) => record,
        Err(error) => return (solved, Err(unwritable(error))),
    };
    let written = Arc::new(Mutex::new(Written { record, solved, failure: None }));
    let mut unsaid = true;
    let (writing, head, directory) = (written.clone(), head.clone(), directory.clone());
    instance.on_solved(move |index, solved, fields| {
        for note in fields.iter().filter(|_| unsaid).flat_map(|fields| without_mesh(&fields.without_mesh)) {
            progress.note(&note);
        }
        unsaid &= fields.is_none();
        let mut written = writing.lock().unwrap_or_else(PoisonError::into_inner);
        written.write(&directory, &outputs, &head, details, (index, solved, fields)).map_err(|error| {
            written.failure = Some(error);
            // The run reports the stored I/O error; this error only ends the analysis.
            EngineError::new("E0712", "the results cannot be written", "")
        })
    });
    let outcome = instance.solve().map_err(RunError::Run);
    let mut written = written.lock().unwrap_or_else(PoisonError::into_inner);
    match written.failure.take() {
        Some(error) => (written.solved, Err(unwritable(error))),
        None => (written.solved, outcome),
    }
}

/// Returns a note about the bodies without a mesh for each reason.
fn without_mesh(bodies: &[(String, &'static str)]) -> Vec<String> {
    let mut reasons: Vec<&str> = Vec::new();
    for (_, reason) in bodies {
        if !reasons.contains(reason) {
            reasons.push(reason);
        }
    }
    let note = |reason: &&str| {
        let alike = bodies.iter().filter(|(_, other)| other == reason);
        let names: Vec<String> = alike.map(|(name, _)| format!("`{name}`")).collect();
        match &names[..] {
            [only] => format!("{only} is not among the bodies in the pictures: it {reason}"),
            _ => format!("{} are not among the bodies in the pictures: each {reason}", names.join(", ")),
        }
    };
    reasons.iter().map(note).collect()
}

/// Positions that a run has written to disk.
struct Written {
    record: Option<Record>,
    /// Number of positions.
    solved: usize,
    failure: Option<io::Error>,
}

impl Written {
    fn write(
        &mut self,
        directory: &RunDirectory,
        outputs: &[OutputDescription],
        head: &Value,
        details: Details,
        (index, solved, fields): (usize, &Solved, Option<&Fields>),
    ) -> io::Result<()> {
        // A model may continue after an analysis that failed, and start another.
        let record = match self.record.take().filter(|_| index > 0) {
            Some(record) => record,
            None => {
                begin(directory, details)?;
                Record::begin(directory.path(), outputs, head, details)?
            }
        };
        directory.claim_all(fields.map(body_pictures::files_of).unwrap_or_default())?;
        if let Some(fields) = fields {
            directory.claim_all(view::files::files_of(index, fields))?;
        }
        if details.vtu {
            directory.claim_all(vtu::files_of(index))?;
        }
        self.record.insert(record).write(index, outputs, solved, fields)?;
        self.solved = index + 1;
        Ok(())
    }
}
