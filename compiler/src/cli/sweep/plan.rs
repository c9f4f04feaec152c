//! `calyx sweep --plan`, `--work` and `--collect`: sweeps that other processes solve, on any
//! machines.

use super::report::Report;
use super::{Sweep, failed, failed_without_module};
use crate::dry_run;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::println;
use calyx::rt::run_directory::{Kind, RunDirectory};
use calyx::rt::sweep::Sweep as Cases;
use calyx::rt::sweep::plan::{Collected, Plan, Worked};
use calyx::rt::{Error, InvalidParam, RunError, shell};
use calyx::{CompileError, Engine, Module};
use std::path::Path;
use std::process::ExitCode;

/// Largest number of cases and indices that a message lists.
const LISTED: usize = 5;

/// Writes the plan of a sweep to its directory, unless it is there. Returns the plan.
pub fn written(command: &Sweep, sweep: &Cases, directory: &RunDirectory) -> Result<Plan, ExitCode> {
    let format = MessageFormat::Human;
    let refused = |why: InvalidParam| {
        format.refused(&why);
        ExitCode::from(USAGE)
    };
    let path = directory.path();
    let seconds = match command.cases_per_index {
        Some(_) => None,
        None => dry_run::predicted_time(command.file(), sweep, &command.allow.paths()),
    };
    let size = command.cases_per_index.map(std::num::NonZeroUsize::get);
    let progress = command.solving.progress();
    progress.stage("plan");
    let planned = Plan::of(sweep, &command.damage_slope, size, seconds);
    progress.finish();
    let (plan, failures) = match planned {
        Ok(planned) => planned,
        Err(error) => return Err(failed_without_module(format, RunError::Run(error))),
    };
    if Plan::exists(path) {
        let shown = path.display();
        return match Plan::read(path) {
            Ok(known) if !known.is_same(&plan) => Err(refused(InvalidParam::new(
                format!("{shown} has a plan of other cases, of another model, or of other settings"),
                "choose another directory, or remove this one if its results are not needed",
            ))),
            Ok(known) if size.is_some_and(|size| size != known.cases_per_index()) => {
                let message = format!(
                    "the plan in {shown} has {} cases per index, not {}",
                    known.cases_per_index(),
                    plan.cases_per_index()
                );
                let help = "leave out `--cases-per-index`, or choose another directory";
                Err(refused(InvalidParam::new(message, help)))
            }
            Ok(known) => Ok(known),
            Err(error) => Err(failed_without_module(format, RunError::Run(error))),
        };
    }
    if let Err(error) = plan.write(directory) {
        return Err(format.unwritable(path, &error.to_string()));
    }
    for (case, reason) in failures.iter().take(LISTED) {
        format.warning(&format!("case {case} will fail: {reason}"));
    }
    if failures.len() > LISTED {
        format.warning(&format!("{} more cases will fail", failures.len() - LISTED));
    }
    Ok(plan)
}

/// Writes a plan and prints the commands that solve it.
pub fn write(command: &Sweep, sweep: &Cases) -> ExitCode {
    let directory = match RunDirectory::lock(&sweep.directory, Kind::Sweep, command.force) {
        Ok(directory) => directory,
        Err(error) => return MessageFormat::Human.directory(&error),
    };
    let plan = match written(command, sweep, &directory) {
        Ok(plan) => plan,
        Err(status) => return status,
    };
    if !command.solving.quiet {
        let shown = shell::path(directory.path());
        println!("{}", summary(&plan));
        println!("solve an index:       calyx sweep --work {shown} --index 1");
        println!("collect the results:  calyx sweep --collect {shown}");
    }
    ExitCode::SUCCESS
}

/// Describes a plan in a line.
fn summary(plan: &Plan) -> String {
    let of = |count: usize, one: &str, more: &str| format!("{count} {}", if count == 1 { one } else { more });
    let indices = of(plan.indices(), "index", "indices");
    let most = of(plan.cases_per_index(), "case", "cases");
    format!("{} in {indices} of at most {most}", of(plan.count(), "case", "cases"))
}

/// Reads a plan and compiles its model.
pub fn read(command: &Sweep, directory: &Path) -> Result<(Plan, Module, Cases), ExitCode> {
    let format = MessageFormat::Human;
    let run = |error: Error| failed_without_module(format, RunError::Run(error));
    let plan = Plan::read(directory).map_err(run)?;
    let module = Module::from_description(&Engine::default(), plan.description.clone()).map_err(|error| {
        if let CompileError::Model(found) = &error {
            format.diagnostics(&found.list, &found.files);
        }
        let message = format!("the model of the plan in {} cannot be compiled: {error}", directory.display());
        format.failure(&message, "write the plan again to another directory with this version of Calyx");
        ExitCode::from(MODEL_ERROR)
    })?;
    let sweep = plan.sweep(module.as_program()).map_err(run)?;
    Ok((plan, module, command.on_engine(sweep)))
}

/// Solves the cases of an index.
pub fn work(command: &Sweep, directory: &Path) -> ExitCode {
    let format = MessageFormat::Human;
    let (plan, module, sweep) = match read(command, directory) {
        Ok(read) => read,
        Err(status) => return status,
    };
    let index = command.index.unwrap_or_default();
    let progress = command.solving.progress();
    progress.stage("cases");
    let worked = plan.work(&sweep, index, |done, count| {
        if done > 0 {
            progress.step(done - 1, count)
        }
    });
    progress.finish();
    let Worked { count, earlier, finished, failures } = match worked {
        Ok(worked) => worked,
        Err(error) => return failed(format, &module, error),
    };
    for (case, reason) in failures.iter().take(LISTED) {
        format.warning(&format!("case {case} failed: {reason}"));
    }
    if finished < count {
        let message = format!("interrupted after {finished} of {count} cases of index {index}");
        format.failure(&message, "run the same command again to continue");
        return ExitCode::from(MODEL_ERROR);
    }
    if !command.solving.quiet {
        let before = if earlier > 0 { format!(", {earlier} of them before") } else { String::new() };
        let cases = if count == 1 { "case" } else { "cases" };
        format
            .note(&format!("index {index}: {} of {count} {cases} solved{before}\n", count - failures.len()));
    }
    match failures.len() {
        0 => ExitCode::SUCCESS,
        failures => {
            let message = format!("{failures} of {count} cases of index {index} failed");
            let help =
                "collect the results, whose rows have the reasons, or run the same command to try them again";
            format.failure(&message, help);
            ExitCode::from(MODEL_ERROR)
        }
    }
}

/// Collects the results of all workers.
pub fn collect(command: &Sweep, directory: &Path) -> ExitCode {
    let (plan, module, sweep) = match read(command, directory) {
        Ok(read) => read,
        Err(status) => return status,
    };
    let out = command.out.as_deref().unwrap_or(directory);
    let locked = match RunDirectory::lock(out, Kind::Sweep, command.force) {
        Ok(locked) => locked,
        Err(error) => return MessageFormat::Human.directory(&error),
    };
    match plan.collect(&sweep) {
        Ok(collected) => report(command.solving.quiet, &plan, &collected, &locked),
        Err(error) => failed(MessageFormat::Human, &module, error),
    }
}

/// Writes the collected results and prints the table. If some are missing, the help has the command
/// that solves them.
pub fn report(quiet: bool, plan: &Plan, collected: &Collected, directory: &RunDirectory) -> ExitCode {
    let format = MessageFormat::Human;
    for ignored in collected.ignored.iter().take(LISTED) {
        format.warning(ignored);
    }
    if collected.ignored.len() > LISTED {
        format.warning(&format!("{} more files or lines are ignored", collected.ignored.len() - LISTED));
    }
    let report = Report { quiet, damage_slopes: plan.damage_slopes(), to_continue: None };
    let Collected { outcome, missing, .. } = collected;
    let status = report.write(outcome, directory);
    let Some(first) = missing.first() else { return status };
    let (left, count) = (outcome.count - outcome.table.rows.len(), outcome.count);
    let (index, each) = match missing.len() {
        1 => ("index", "run"),
        _ => ("indices", "for each index, run"),
    };
    let are = if left == 1 { "is" } else { "are" };
    let message = format!("{left} of {count} cases {are} missing: {index} {}", ranges(missing));
    let shown = shell::path(&plan.directory);
    format.failure(
        &message,
        &format!("{each} `calyx sweep --work {shown} --index {first}`, then collect again"),
    );
    ExitCode::from(MODEL_ERROR)
}

/// Formats ascending numbers as ranges, as queues accept them: 1-3,7.
pub fn ranges(numbers: &[usize]) -> String {
    let mut ranges: Vec<[usize; 2]> = Vec::new();
    for &number in numbers {
        match ranges.last_mut() {
            Some([_, last]) if *last + 1 == number => *last = number,
            _ => ranges.push([number; 2]),
        }
    }
    let text = |[first, last]: &[usize; 2]| match last - first {
        0 => first.to_string(),
        _ => format!("{first}-{last}"),
    };
    ranges.iter().map(text).collect::<Vec<_>>().join(",")
}
