//! Plans of sweeps: a directory with all that other machines need to solve the cases.
//!
//! ```text
//! plan.json      readable index: versions, what is varied, number of cases and indices, settings
//! model.json     description of the model, with its sources and the files that it reads
//! cases.json     axes and durations, from which the cases follow
//! results/       a journal per attempt to solve the cases of an index
//! ```
//!
//! The cases of a sweep are divided into indices of consecutive cases. `plan.json` has the hashes
//! of the other files and is written last, so a plan is complete or absent.

use super::attempts::{self, Attempt};
use super::axis::refused;
use super::{Axis, Outcome, Sweep, Varied, on_large_stack};
use crate::adapted::AdaptedProgram;
use crate::error::Error;
use crate::instance::Instance;
use crate::param_assignment::ParamAssignment;
use crate::params::{InvalidParam, Setting, index_of};
use crate::program::Program;
use crate::run::RunError;
use crate::run_directory::RunDirectory;
use calyx_abi::Fingerprint;
use calyx_abi::description::{FileDescription, ModelDescription, ParamValue};
use calyx_gears::library::FINGERPRINT;
use calyx_report::directory::text_hash;
use calyx_report::durations::Durations;
use calyx_report::study::{Objective, Sample};
use calyx_report::sweep::Case;
use calyx_runtime::settings_override::Override;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, ErrorKind};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;

pub use super::attempts::{RESULTS, lines};

/// File name of the index of a plan.
pub const PLAN: &str = "plan.json";
/// Its name while it is written.
const UNFINISHED: &str = "plan.json.part";
const MODEL: &str = "model.json";
const CASES: &str = "cases.json";
/// Name of the stored files in errors, as of a folder that does not exist.
const STORED: &str = "files";
/// Format of a plan. Other formats are refused.
const FORMAT: u32 = 1;
/// Largest number of indices without a request: the arrays of Slurm have at most 1000 by default.
const MOST_INDICES: usize = 1000;
/// Predicted duration of an index without a request, s: starting a worker takes far less.
const DURATION: f64 = 60.0;
/// Number of cases of an index without a request or a prediction, as of models without an analysis.
const UNPREDICTED: f64 = 100.0;
/// Largest number of cases that are all built to find the files that they read. Of more cases,
/// those that differ only in real numbers are built once.
const MOST_BUILT: usize = 2000;

/// Content of `plan.json`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Index {
    format: u32,
    calyx: String,
    engine: Fingerprint,
    /// Hash of all of the plan except for its division into indices.
    fingerprint: String,
    model: String,
    /// Headings of the varied quantities.
    varied: Vec<String>,
    cases: usize,
    cases_per_index: usize,
    indices: usize,
    /// Values assigned to params in all cases, SI.
    params: BTreeMap<String, ParamValue>,
    overrides: BTreeMap<String, String>,
    load_cases: bool,
    sample: Option<Sample>,
    objectives: Vec<Objective>,
    /// Slopes of damage lines for the equivalent torques of a duty cycle; empty for the default.
    damage_slopes: Vec<f64>,
    /// SHA-256 of the other files.
    files: BTreeMap<String, String>,
}

/// Content of `cases.json`.
#[derive(Serialize, Deserialize)]
struct Cases {
    axes: Vec<PlannedAxis>,
    durations: Option<Durations>,
}

/// Axis whose quantities have names.
#[derive(Serialize, Deserialize)]
struct PlannedAxis {
    varied: Vec<String>,
    names: Vec<String>,
    logarithmic: bool,
    points: Vec<Vec<ParamValue>>,
}

/// Plan of a sweep.
pub struct Plan {
    pub directory: PathBuf,
    index: Index,
    cases: Cases,
    /// Description of the model, with its sources and files.
    pub description: ModelDescription,
}

/// Files that the cases of a sweep read, and the cases that cannot be built, with the reason.
type Built = (Vec<FileDescription>, Vec<(usize, String)>);

/// Result of solving an index.
pub struct Worked {
    /// Number of cases of the index.
    pub count: usize,
    /// Number of cases that earlier attempts have solved.
    pub earlier: usize,
    /// Number of finished cases, with those solved before.
    pub finished: usize,
    /// Failed cases, with the reason.
    pub failures: Vec<(usize, String)>,
}

/// Results that were collected from the workers of a plan.
pub struct Collected {
    pub outcome: Outcome,
    /// Indices that are not finished.
    pub missing: Vec<usize>,
    /// Files and lines that are ignored, with the reason.
    pub ignored: Vec<String>,
}

/// Returns the hash by which a plan is known.
fn fingerprint(index: &Index) -> String {
    let known = Index { fingerprint: String::new(), cases_per_index: 0, indices: 0, ..index.clone() };
    text_hash(&json!(known).to_string())
}

fn given(message: String, help: &str) -> Error {
    Error::Given(InvalidParam::new(message, help))
}

const COPY_AGAIN: &str =
    "copy the directory again from where it was written, or write the plan to another directory";
const SAME_CALYX: &str =
    "use the `calyx` that wrote the plan, or write it again to another directory with this one";

impl Plan {
    /// Plans a sweep. `damage_slopes` are those of `--damage-slope`; `seconds` is the predicted
    /// duration of a case, for an index of about a minute unless `cases_per_index` is given.
    ///
    /// # Errors
    /// A value of a case is invalid.
    pub fn of(
        sweep: &Sweep,
        damage_slopes: &[f64],
        cases_per_index: Option<usize>,
        seconds: Option<f64>,
    ) -> Result<(Plan, Vec<(usize, String)>), Error> {
        let (varied, cases) = sweep.cases()?;
        sweep.check_all(&varied, &cases)?;
        let description = sweep.program.description();
        let (files, failures) = sweep.files(&varied, &cases)?;
        let description =
            ModelDescription { tables: files.into(), allowed: [].into(), ..description.clone() };
        let planned = |axis: &Axis| PlannedAxis {
            varied: axis.params.iter().map(|varied| varied.name(&description).to_owned()).collect(),
            names: axis.names.clone(),
            logarithmic: axis.logarithmic,
            points: axis.points.clone(),
        };
        let axes = sweep.axes.iter().map(planned).collect();
        let mut params = BTreeMap::new();
        for given in &sweep.given {
            let index = index_of(&description, &given.name)?;
            let setting = Setting::new(&description, index, &given.value, given.origin.as_ref())?;
            params.insert(given.name.clone(), setting.value);
        }
        let overrides = sweep.overrides.overridden().into_iter();
        let index = Index {
            format: FORMAT,
            calyx: env!("CARGO_PKG_VERSION").to_owned(),
            engine: FINGERPRINT,
            fingerprint: String::new(),
            model: description.name.clone(),
            varied: varied.iter().map(|varied| varied.column(&description).heading("")).collect(),
            cases: cases.len(),
            cases_per_index: cases_per_index.unwrap_or_else(|| default_size(cases.len(), seconds)),
            indices: 0,
            params,
            overrides: overrides.map(|(name, value)| (name.to_owned(), value)).collect(),
            load_cases: sweep.load_cases,
            sample: sweep.sample.clone(),
            objectives: sweep.objectives.clone(),
            damage_slopes: damage_slopes.to_vec(),
            files: BTreeMap::new(),
        };
        let cases = Cases { axes, durations: sweep.durations.clone() };
        let mut plan = Plan { directory: sweep.directory.clone(), index, cases, description };
        for (name, text) in plan.texts().map_err(|error| given(error.to_string(), ""))? {
            plan.index.files.insert(name.to_owned(), text_hash(&text));
        }
        plan.index.fingerprint = fingerprint(&plan.index);
        plan.index.indices = plan.index.cases.div_ceil(plan.index.cases_per_index);
        Ok((plan, failures))
    }

    /// Returns the contents of the files with hashes.
    fn texts(&self) -> serde_json::Result<[(&'static str, String); 2]> {
        let description = serde_json::to_string(&self.description)?;
        Ok([(MODEL, description), (CASES, serde_json::to_string(&self.cases)?)])
    }

    /// Writes the plan to a locked directory.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn write(&self, directory: &RunDirectory) -> io::Result<()> {
        for (name, text) in self.texts()? {
            fs::write(directory.claim(name)?, text)?;
        }
        let plan = directory.claim(PLAN)?;
        let unfinished = directory.claim(UNFINISHED)?;
        fs::write(&unfinished, serde_json::to_string_pretty(&self.index)? + "\n")?;
        fs::create_dir_all(self.directory.join(RESULTS))?;
        fs::rename(unfinished, plan)
    }

    /// Returns whether a directory has a plan, which may be damaged.
    pub fn exists(directory: &Path) -> bool {
        directory.join(PLAN).symlink_metadata().is_ok()
    }

    /// Reads a plan.
    ///
    /// # Errors
    /// There is none; it is damaged; or another version of Calyx wrote it.
    pub fn read(directory: &Path) -> Result<Plan, Error> {
        let path = directory.join(PLAN);
        let shown = path.display();
        let damaged = |why: String| given(format!("{shown} is damaged: {why}"), COPY_AGAIN);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let message = format!("{} has no plan of a sweep: there is no {PLAN}", directory.display());
                return Err(given(message, "name a directory of `calyx sweep MODEL ... --plan DIR`"));
            }
            Err(error) => return Err(given(format!("cannot read {shown}: {error}"), COPY_AGAIN)),
        };
        let value: Value = serde_json::from_str(&text).map_err(|error| damaged(error.to_string()))?;
        let of = |key: &str| value[key].as_str().unwrap_or("another version").to_owned();
        if value["format"].as_u64().is_some_and(|format| format != u64::from(FORMAT)) {
            let message = format!(
                "{shown} has format {} and was written by Calyx {}, and this is Calyx {}, which reads format {FORMAT}",
                value["format"],
                of("calyx"),
                env!("CARGO_PKG_VERSION"),
            );
            return Err(given(message, SAME_CALYX));
        }
        let (calyx, engine) = (env!("CARGO_PKG_VERSION"), FINGERPRINT.to_string());
        if value["calyx"].is_string() && (of("calyx") != calyx || of("engine") != engine) {
            let message = format!(
                "{shown} was written by Calyx {} (engine {}), and this is Calyx {calyx} (engine {engine})",
                of("calyx"),
                of("engine"),
            );
            return Err(given(message, SAME_CALYX));
        }
        let index: Index = serde_json::from_value(value).map_err(|error| damaged(error.to_string()))?;
        if fingerprint(&index) != index.fingerprint {
            return Err(damaged("it was changed after it was written".to_owned()));
        }
        let indices = index
            .cases
            .checked_div(index.cases_per_index)
            .map(|whole| whole + usize::from(whole * index.cases_per_index < index.cases));
        if indices != Some(index.indices) {
            return Err(damaged("the number of indices does not fit the number of cases".to_owned()));
        }
        let (description, cases) = (index.file(directory, MODEL)?, index.file(directory, CASES)?);
        Ok(Plan { directory: directory.to_owned(), index, cases, description })
    }

    /// Returns whether another plan has the same model, cases and settings; it may divide the cases
    /// into other indices.
    pub fn is_same(&self, other: &Plan) -> bool {
        self.index.fingerprint == other.index.fingerprint
    }

    /// Number of cases.
    pub fn count(&self) -> usize {
        self.index.cases
    }

    pub fn cases_per_index(&self) -> usize {
        self.index.cases_per_index
    }

    /// Number of indices, which are counted from 1.
    pub fn indices(&self) -> usize {
        self.index.indices
    }

    pub fn damage_slopes(&self) -> &[f64] {
        &self.index.damage_slopes
    }

    /// Returns the numbers of the cases of an index.
    fn cases_of(&self, index: usize) -> RangeInclusive<usize> {
        let size = self.index.cases_per_index;
        (index - 1) * size + 1..=(index * size).min(self.index.cases)
    }

    /// Returns the sweep that was planned. `program` is compiled from the plan's description.
    ///
    /// # Errors
    /// The plan does not fit its model.
    pub fn sweep(&self, program: Arc<dyn Program>) -> Result<Sweep, Error> {
        let Index { params, overrides, load_cases, sample, objectives, .. } = self.index.clone();
        // A file that the plan lacks is an error on every machine.
        let program = AdaptedProgram::stored(program, self.directory.join(STORED));
        let given = params.into_iter().map(|(name, value)| ParamAssignment::value(name, value)).collect();
        let mut overridden = Override::default();
        for (name, text) in &overrides {
            overridden.set(name, text).map_err(|error| refused(error.message, COPY_AGAIN))?;
        }
        let axis = |axis: &PlannedAxis| {
            let params = axis.varied.iter().map(|name| Varied::named(name, &self.description));
            let params: Vec<Varied> = params.collect::<Result<_, Error>>()?;
            if axis.points.iter().any(|point| point.len() != params.len()) {
                let message = format!("{} is damaged", self.directory.join(CASES).display());
                return Err(refused(message, COPY_AGAIN));
            }
            let (names, points) = (axis.names.clone(), axis.points.clone());
            Ok(Axis { params, names, points, logarithmic: axis.logarithmic })
        };
        Ok(Sweep {
            given,
            overrides: overridden,
            axes: self.cases.axes.iter().map(axis).collect::<Result<_, Error>>()?,
            load_cases,
            durations: self.cases.durations.clone(),
            sample,
            objectives,
            ..Sweep::new(Arc::new(program), self.directory.clone())
        })
    }

    /// Returns the first line of the journals of the plan.
    fn subject(&self, sweep: &Sweep) -> Result<Value, Error> {
        let mut subject = sweep.subject()?;
        subject["plan"] = json!(self.index.fingerprint);
        Ok(subject)
    }

    /// Solves the cases of an index that no earlier attempt has solved; failed ones are tried
    /// again. `done` receives the number of finished cases after each.
    ///
    /// # Errors
    /// There is no such index, or the journal cannot be read or written.
    pub fn work(
        &self,
        sweep: &Sweep,
        index: usize,
        done: impl Fn(usize, usize) + Sync,
    ) -> Result<Worked, RunError> {
        if !(1..=self.index.indices).contains(&index) {
            let (directory, last) = (self.directory.display(), self.index.indices);
            let message = format!("the plan in {directory} has no index {index}");
            let help = format!("give an index from 1 to {last}");
            return Err(RunError::Run(refused(message, help)));
        }
        let path = self.directory.join(RESULTS);
        let io = |error| RunError::Io { path: path.clone(), error };
        let (varied, cases) = sweep.cases().map_err(RunError::Run)?;
        let subject = self.subject(sweep).map_err(RunError::Run)?;
        let found = attempts::read(&self.directory, &subject, cases.len(), Some(index)).map_err(io)?;
        let numbers = self.cases_of(index);
        let count = numbers.clone().count();
        let left: Vec<usize> = numbers.filter(|case| !found.solved.contains_key(case)).collect();
        let (earlier, attempt) = (count - left.len(), Attempt::new(&self.directory, index, &subject));
        let finished = AtomicUsize::new(earlier);
        let failures: Mutex<Vec<(usize, String)>> = Mutex::default();
        done(earlier, count);
        let lines = sweep.solve_each(&varied, &cases, &left, &|line| {
            attempt.write(line).map_err(io)?;
            if let (Some(reason), Ok(mut failures)) = (&line.row.failure, failures.lock()) {
                failures.push((line.row.case, reason.clone()));
            }
            done(finished.fetch_add(1, Ordering::Relaxed) + 1, count);
            Ok(())
        })?;
        attempt.finish().map_err(io)?;
        let mut failures = failures.into_inner().unwrap_or_default();
        failures.sort();
        Ok(Worked { count, earlier, finished: earlier + lines.len(), failures })
    }

    /// Collects the results of all workers. A case that failed in its last attempt is a row with
    /// its reason.
    ///
    /// # Errors
    /// The results cannot be read.
    pub fn collect(&self, sweep: &Sweep) -> Result<Collected, RunError> {
        let io = |error| RunError::Io { path: self.directory.join(RESULTS), error };
        let (varied, cases) = sweep.cases().map_err(RunError::Run)?;
        let subject = self.subject(sweep).map_err(RunError::Run)?;
        let found = attempts::read(&self.directory, &subject, cases.len(), None).map_err(io)?;
        let mut lines = found.failed;
        lines.extend(found.solved);
        let is_missing = |index: &usize| self.cases_of(*index).any(|case| !lines.contains_key(&case));
        let missing = (1..=self.index.indices).filter(is_missing).collect();
        let solved = lines.into_iter().map(|(case, line)| (case, line.solved())).collect();
        let count = cases.len();
        let outcome = Outcome { table: sweep.table(&varied, cases, solved), count, earlier: 0 };
        Ok(Collected { outcome, missing, ignored: found.ignored })
    }
}

impl Index {
    /// Reads a file of the plan.
    fn file<T: for<'d> Deserialize<'d>>(&self, directory: &Path, name: &str) -> Result<T, Error> {
        let path = directory.join(name);
        let text = fs::read_to_string(&path)
            .map_err(|error| given(format!("cannot read {}: {error}", path.display()), COPY_AGAIN))?;
        if self.files.get(name) != Some(&text_hash(&text)) {
            let message = format!("{} is damaged: it was changed after it was written", path.display());
            return Err(given(message, COPY_AGAIN));
        }
        serde_json::from_str(&text)
            .map_err(|error| given(format!("{} is damaged: {error}", path.display()), COPY_AGAIN))
    }
}

/// Returns the number of cases of an index without a request.
fn default_size(cases: usize, seconds: Option<f64>) -> usize {
    let fast = seconds.map_or(UNPREDICTED, |seconds| DURATION / seconds);
    (fast as usize).clamp(cases.div_ceil(MOST_INDICES).max(1), cases.max(1))
}

impl Sweep {
    /// Returns the files that the cases read, and the cases that cannot be built, with the reason.
    fn files(&self, varied: &[Varied], cases: &[Case]) -> Result<Built, Error> {
        let mut built = BTreeSet::new();
        let is_built = |(_, case): &(usize, &Case)| {
            let discrete = varied.iter().zip(&case.values).filter(|(varied, value)| {
                let integral = varied.param(self.program.description()).is_some_and(|param| param.integral);
                integral || !matches!(value, ParamValue::Number(_))
            });
            let values: Vec<&ParamValue> = discrete.map(|(_, value)| value).collect();
            cases.len() <= MOST_BUILT || built.insert(json!(values).to_string())
        };
        let chosen: Vec<(usize, &Case)> = (1..).zip(cases).filter(is_built).collect();
        let mut files: BTreeMap<String, String> = BTreeMap::new();
        let mut failures = Vec::new();
        let own = self.instance()?;
        let mut add = |found: Vec<FileDescription>| {
            found.into_iter().for_each(|file| drop(files.insert(file.name, file.text)));
        };
        add(own.build().0);
        let next = AtomicUsize::new(0);
        let work = || {
            let mut found = Vec::new();
            while let Some((number, case)) = chosen.get(next.fetch_add(1, Ordering::Relaxed)) {
                let built = self.instance_of(varied, case).map(|instance: Instance| instance.build());
                found.push((*number, built.unwrap_or_else(|error| (Vec::new(), Some(error)))));
                if self.cancel.is_cancelled() {
                    break;
                }
            }
            found
        };
        thread::scope(|scope| {
            let spawn = |_| scope.spawn(|| on_large_stack(&work));
            let threads: Vec<_> = (0..self.workers.max(1)).map(spawn).collect();
            for (number, (found, error)) in
                threads.into_iter().filter_map(|thread| thread.join().ok()).flatten()
            {
                add(found);
                let reason = error.map(|error| match error {
                    Error::Model(error) => format!("{}: {}", error.code, error.message),
                    Error::Given(why) => why.message,
                });
                failures.extend(reason.map(|reason| (number, reason)));
            }
        });
        failures.sort();
        let files = files.into_iter().map(|(name, text)| FileDescription { name, text }).collect();
        Ok((files, failures))
    }
}
