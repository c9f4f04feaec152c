//! `calyx sweep --on slurm`: submits a plan as an array job, follows it and collects the results.
//!
//! The commands of Slurm do the work: sbatch submits, squeue lists the tasks that are not finished,
//! and sacct, where accounting is set up, has the states of finished ones. `job.json` in the
//! directory of the plan has the job, so that the same command continues to follow it.

use super::plan::{ranges, report, written};
use super::{Sweep, failed};
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::eprintln;
use calyx::rt::run_directory::{Kind, RunDirectory};
use calyx::rt::shell;
use calyx::rt::sweep::Sweep as Cases;
use calyx::rt::sweep::plan::{Collected, Plan, lines};
use calyx_abi::visible::visible;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// File with the job that solves a plan.
const JOB: &str = "job.json";
/// Script of the job.
const SCRIPT: &str = "job.sh";
/// Folder with the output of the tasks.
const LOGS: &str = "logs";
/// Largest number of unfinished indices whose logs are shown.
const SHOWN: usize = 3;
/// Number of last lines of a log that are shown.
const LOG_LINES: usize = 10;
/// Number of failures of squeue one after another, as of a controller that restarts, after which
/// the job is no longer followed.
const ATTEMPTS: usize = 20;
/// Number of times that the results are read until those of all tasks are there: a network file
/// system shows new files with a delay.
const READS: usize = 4;
const PAUSE: Duration = Duration::from_secs(1);

/// A submitted job.
#[derive(Serialize, Deserialize)]
struct Job {
    id: String,
    /// Cluster, if Slurm has several.
    cluster: Option<String>,
    indices: String,
    options: Vec<String>,
}

/// Unfinished tasks of a job by state.
type States = BTreeMap<String, usize>;

/// Reason why a command of Slurm did not succeed, with the remedy.
struct Failure {
    message: String,
    help: &'static str,
}

impl Failure {
    fn print(&self) -> ExitCode {
        MessageFormat::Human.failure(&self.message, self.help);
        ExitCode::from(MODEL_ERROR)
    }
}

/// Runs a command of Slurm and returns what it prints. The inner error is the reason that the
/// command states.
fn output(command: &mut Command) -> Result<Result<String, String>, Failure> {
    let name = command.get_program().to_string_lossy().into_owned();
    match command.output() {
        Ok(output) if output.status.success() => Ok(Ok(String::from_utf8_lossy(&output.stdout).into_owned())),
        Ok(output) => Ok(Err(String::from_utf8_lossy(&output.stderr).trim().to_owned())),
        Err(error) => {
            let help = match error.kind() {
                ErrorKind::NotFound => {
                    "run the command where the commands of Slurm are installed, or use `--plan` for another queue"
                }
                _ => "check the installation of Slurm",
            };
            Err(Failure { message: format!("cannot run `{name}`: {error}"), help })
        }
    }
}

impl Job {
    /// Reads the job of a plan; `None` if there is none.
    fn read(directory: &Path) -> Result<Option<Job>, Failure> {
        let path = directory.join(JOB);
        let unreadable = |error: io::Error| Failure {
            message: format!("cannot read {}: {error}", path.display()),
            help: "remove the file if no job solves this plan",
        };
        match fs::read(&path) {
            Ok(text) => serde_json::from_slice(&text).map(Some).map_err(|error| unreadable(error.into())),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(unreadable(error)),
        }
    }

    /// Returns a command about this job.
    fn command(&self, name: &str) -> Command {
        let mut command = Command::new(name);
        command.arg("--noheader").arg(format!("--jobs={}", self.id));
        command.args(self.cluster.iter().map(|cluster| format!("--clusters={cluster}")));
        command
    }

    /// Returns the unfinished tasks; empty if the job has ended. The inner error is the reason why
    /// they are not known.
    fn states(&self) -> Result<Result<States, String>, Failure> {
        let listed = output(self.command("squeue").args(["--array", "--format=%T|%r"]))?;
        let text = match listed {
            Ok(text) => text,
            // Slurm forgets jobs some minutes after their end.
            Err(reason) if reason.contains("Invalid job id") => return Ok(Ok(States::new())),
            Err(reason) => return Ok(Err(reason)),
        };
        let mut states = States::new();
        for line in text.lines().filter(|line| line.contains('|') && !line.starts_with("CLUSTER")) {
            let (state, reason) = line.trim().split_once('|').unwrap_or((line, ""));
            let state = state.to_lowercase();
            let named = if state == "pending" { format!("{state} ({reason})") } else { state };
            *states.entry(named).or_default() += 1;
        }
        Ok(Ok(states))
    }

    /// Returns the state of a finished task and its exit status, if Slurm accounts for jobs.
    fn outcome(&self, index: usize) -> Option<String> {
        let mut command = self.command("sacct");
        command.args(["--allocations", "--parsable2", "--format=JobID,State,ExitCode"]);
        let text = output(&mut command).ok()?.ok()?;
        let task = format!("{}_{index}", self.id);
        let mut fields = text.lines().map(|line| line.split('|'));
        let mut fields = fields.find(|fields| fields.clone().next() == Some(&task))?;
        Some(format!("{}, exit status {}", fields.nth(1)?, fields.next()?))
    }

    fn log(&self, directory: &Path, index: usize) -> PathBuf {
        directory.join(LOGS).join(format!("{}_{index}.log", self.id))
    }

    /// Shows the end of a task: its state, and the last lines of its log.
    fn show(&self, directory: &Path, index: usize) {
        let path = self.log(directory, index);
        let state = self.outcome(index).map(|state| format!(": {state}")).unwrap_or_default();
        let text = fs::read(&path).map(|text| String::from_utf8_lossy(&text).into_owned());
        let shown = path.display();
        match text {
            Ok(text) if text.trim().is_empty() => eprintln!("index {index}{state}; {shown} is empty"),
            Ok(text) => {
                eprintln!("index {index}{state}; the end of {shown}:");
                let lines: Vec<&str> = text.trim_end().lines().collect();
                for line in &lines[lines.len().saturating_sub(LOG_LINES)..] {
                    eprintln!("  {}", visible(line));
                }
            }
            Err(error) => eprintln!("index {index}{state}; cannot read {shown}: {error}"),
        }
    }
}

/// Submits, follows and collects a sweep.
pub fn run(command: &Sweep, module: &calyx::Module, sweep: &Cases) -> ExitCode {
    let directory = match RunDirectory::lock(&sweep.directory, Kind::Sweep, command.force) {
        Ok(directory) => directory,
        Err(error) => return MessageFormat::Human.directory(&error),
    };
    let plan = match written(command, sweep, &directory) {
        Ok(plan) => plan,
        Err(status) => return status,
    };
    let found = |collected| match collected {
        Ok(collected) => Ok(collected),
        Err(error) => Err(failed(MessageFormat::Human, module, error)),
    };
    let earlier: Collected = match found(plan.collect(sweep)) {
        Ok(collected) => collected,
        Err(status) => return status,
    };
    let job = match job_of(command, &plan, &directory, &earlier) {
        Ok(job) => job,
        Err(status) => return status,
    };
    let Some(job) = job else { return report(command.solving.quiet, &plan, &earlier, &directory) };
    if let Err(status) = follow(command, &job, &plan, sweep) {
        return status;
    }
    for read in 1.. {
        let collected = match found(plan.collect(sweep)) {
            Ok(collected) => collected,
            Err(status) => return status,
        };
        if read < READS && !collected.missing.is_empty() {
            sleep(PAUSE);
            continue;
        }
        return finish(command, &job, &plan, &collected, &directory);
    }
    ExitCode::from(MODEL_ERROR)
}

/// Returns the job of a plan: the one that was submitted before, or a new one. `None` if no index
/// is left to be solved.
fn job_of(
    command: &Sweep,
    plan: &Plan,
    directory: &RunDirectory,
    earlier: &Collected,
) -> Result<Option<Job>, ExitCode> {
    let known = Job::read(directory.path()).map_err(|failure| failure.print())?;
    if earlier.missing.is_empty() {
        return Ok(None);
    }
    let Some(job) = known else { return submit(command, plan, directory, earlier).map(Some) };
    if command.resubmit {
        return match job.states().map_err(|failure| failure.print())? {
            Ok(states) if states.is_empty() => submit(command, plan, directory, earlier).map(Some),
            Ok(_) => {
                let message = format!("the job {} has not ended", job.id);
                let help =
                    format!("leave out `--resubmit` to follow it, or end it with `scancel {}`", job.id);
                MessageFormat::Human.failure(&message, &help);
                Err(ExitCode::from(USAGE))
            }
            Err(reason) => Err(unknown(&job, &reason)),
        };
    }
    if !command.solving.quiet && split(&command.slurm_options) != job.options {
        MessageFormat::Human.warning(&format!(
            "the job {} has the options with which it was submitted: {}",
            job.id,
            if job.options.is_empty() { "none".to_owned() } else { job.options.join(" ") }
        ));
    }
    Ok(Some(job))
}

/// Splits options at blanks.
fn split(options: &[String]) -> Vec<String> {
    options.iter().flat_map(|text| text.split_whitespace()).map(str::to_owned).collect()
}

/// Submits the indices that are not finished.
fn submit(
    command: &Sweep,
    plan: &Plan,
    directory: &RunDirectory,
    earlier: &Collected,
) -> Result<Job, ExitCode> {
    let format = MessageFormat::Human;
    let path = directory.path();
    let unwritable = |error: io::Error| format.unwritable(path, &error.to_string());
    let whole = path.canonicalize().map_err(unwritable)?;
    let calyx = std::env::current_exe().map_err(unwritable)?;
    fs::create_dir_all(whole.join(LOGS)).map_err(unwritable)?;
    let script = directory.claim(SCRIPT).map_err(unwritable)?;
    let cache = if command.solving.no_cache { " --no-cache" } else { "" };
    let text = format!(
        "#!/bin/sh\n# Solves an index of the plan; written by `calyx sweep --on slurm`.\nexec {} sweep --work {} \
         --index \"$SLURM_ARRAY_TASK_ID\" --threads \"${{SLURM_CPUS_PER_TASK:-1}}\" --quiet{cache}\n",
        shell::command(&calyx),
        shell::path(&whole),
    );
    fs::write(&script, text).map_err(unwritable)?;
    let (indices, options) = (ranges(&earlier.missing), split(&command.slurm_options));
    let model = Path::new(&plan.description.name).file_name().unwrap_or_default().to_string_lossy();
    let mut sbatch = Command::new("sbatch");
    sbatch.arg("--parsable").arg(format!("--array={indices}")).arg(format!("--job-name={model}"));
    sbatch.arg(format!("--output={}", whole.join(LOGS).join("%A_%a.log").display()));
    sbatch.args(&options).arg(whole.join(SCRIPT));
    let told = match output(&mut sbatch).map_err(|failure| failure.print())? {
        Ok(told) => told,
        Err(reason) => {
            let help = "correct `--slurm-options`; if Slurm refuses the array, give more `--cases-per-index` in another directory";
            format.failure(&format!("sbatch did not accept the job: {reason}"), help);
            return Err(ExitCode::from(MODEL_ERROR));
        }
    };
    // The identifier, and the cluster if there are several.
    let mut parts = told.trim().splitn(2, ';').map(str::to_owned);
    let id = parts.next().unwrap_or_default();
    if id.is_empty() || !id.bytes().all(|byte| byte.is_ascii_digit()) {
        format.failure(&format!("sbatch printed no job identifier, but `{}`", told.trim()), "");
        return Err(ExitCode::from(MODEL_ERROR));
    }
    let job = Job { id, cluster: parts.next(), indices, options };
    let text = serde_json::to_string_pretty(&job).map_err(|error| unwritable(error.into()))?;
    let file = directory.claim(JOB).map_err(unwritable)?;
    fs::write(file, text + "\n").map_err(|error| {
        eprintln!("the job {} was submitted", job.id);
        unwritable(error)
    })?;
    if !command.solving.quiet {
        format.note(&format!("submitted the job {}, array {}\n", job.id, job.indices));
    }
    Ok(job)
}

/// Reports a job whose state is not known.
fn unknown(job: &Job, reason: &str) -> ExitCode {
    let message = format!("the state of the job {} is not known: {reason}", job.id);
    MessageFormat::Human
        .failure(&message, "run the same command again when the controller of Slurm responds");
    ExitCode::from(MODEL_ERROR)
}

/// Follows a job until all its tasks have ended. An interrupt leaves the job running.
fn follow(command: &Sweep, job: &Job, plan: &Plan, sweep: &Cases) -> Result<(), ExitCode> {
    let progress = command.solving.progress();
    progress.stage("cases");
    let (began, mut failures, mut before) = (Instant::now(), 0, Vec::new());
    let ended = loop {
        match job.states() {
            Ok(Ok(states)) => {
                failures = 0;
                let kinds: Vec<String> = states.keys().cloned().collect();
                if kinds != before && !states.is_empty() {
                    let all = states.iter().map(|(state, count)| format!("{count} {state}"));
                    progress.note(&format!("job {}: {}", job.id, all.collect::<Vec<_>>().join(", ")));
                }
                before = kinds;
                let done = lines(&plan.directory).unwrap_or(0).min(plan.count());
                if done > 0 {
                    progress.step(done - 1, plan.count());
                }
                if states.is_empty() {
                    break Ok(());
                }
            }
            Ok(Err(reason)) => {
                failures += 1;
                if failures == ATTEMPTS {
                    break Err(Some(reason));
                }
            }
            Err(failure) => {
                progress.finish();
                return Err(failure.print());
            }
        }
        // Soon at first, and seldom for a long job.
        let interval = Duration::from_secs_f64((began.elapsed().as_secs_f64() / 20.0).clamp(1.0, 15.0));
        let next = Instant::now() + interval;
        while Instant::now() < next && !sweep.cancel.is_cancelled() {
            sleep(Duration::from_millis(50));
        }
        if sweep.cancel.is_cancelled() {
            break Err(None);
        }
    };
    progress.finish();
    match ended {
        Ok(()) => Ok(()),
        Err(Some(reason)) => Err(unknown(job, &reason)),
        Err(None) => {
            let help = format!(
                "run the same command again to follow and collect it, or end it with `scancel {}`",
                job.id
            );
            MessageFormat::Human.failure(&format!("interrupted; the job {} continues", job.id), &help);
            Err(ExitCode::from(MODEL_ERROR))
        }
    }
}

/// Reports the results of a job that has ended, and the tasks that have not finished their index.
fn finish(
    command: &Sweep,
    job: &Job,
    plan: &Plan,
    collected: &Collected,
    directory: &RunDirectory,
) -> ExitCode {
    let status = report(command.solving.quiet, plan, collected, directory);
    if collected.missing.is_empty() {
        return status;
    }
    collected.missing.iter().take(SHOWN).for_each(|index| job.show(directory.path(), *index));
    let (left, all) = (collected.missing.len(), plan.indices());
    MessageFormat::Human.failure(
        &format!("the job {} has ended, and {left} of {all} indices are not finished", job.id),
        "submit them again by the same command with `--resubmit`; change `--slurm-options` if they need more time or memory",
    );
    status
}
