//! `calyx sensitivities`: derivatives of outputs with respect to params.

use crate::allow::AllowPath;
use crate::compile::compile;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use crate::solving::Solving;
use crate::sweep::failed;
use calyx::rt::console::print;
use calyx::rt::options::given_of;
use calyx::rt::page::sensitivity as page;
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::sensitivity::{
    SENSITIVITIES, SENSITIVITIES_BY_POSITION, SensitivityTable, text, write_positions, write_table,
};
use calyx::rt::sensitivity_journal::SensitivityJournal;
use calyx::rt::settings_override::OverrideArguments;
use calyx::rt::{
    Error, ErrorKind, Instance, InvalidParam, ModelDescription, ParamAssignment, Results, RunError, interrupt,
};
use calyx::{Module, check_run_within};
use calyx_runtime::estimate::Estimates;
use calyx_runtime::sensitivity::is_named;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

pub const EXAMPLES: &str = "\
Examples:
  calyx sensitivities pair.cx                            results go to pair.cx.sensitivities
  calyx sensitivities pair.cx --of transmission_error --to torque --to tip_relief
  calyx sensitivities pair.cx --set torque=500 --fidelity plane

Without `--to`, outputs are differentiated with respect to all params that take decimal numbers. A
model with an analysis in time or a tolerance search has no derivatives: give a fidelity level for
the latter. Derivatives of an interrupted command, or of former params, are not computed again.

Exit status: 0 if the results were written, 1 if the model or its analysis failed or after an
interruption, 2 for wrong usage of the command.";

#[derive(Args)]
pub struct Sensitivities {
    /// The model (.cx file)
    file: PathBuf,
    /// Show derivatives of this output, or of all elements of an array; may be repeated [default:
    /// all outputs]
    #[arg(long, value_name = "OUTPUT")]
    of: Vec<String>,
    /// Differentiate with respect to this param; may be repeated [default: all that take decimal
    /// numbers]
    #[arg(long, value_name = "PARAM")]
    to: Vec<String>,
    /// Set a param, see `calyx run`
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value)]
    set: Vec<ParamAssignment>,
    /// Read params from FILE.json or FILE.toml, see `calyx run`
    #[arg(long, value_name = "FILE")]
    params: Option<PathBuf>,
    #[command(flatten)]
    overrides: OverrideArguments,
    #[command(flatten)]
    allow: AllowPath,
    /// Directory for the results [default: the model's file name with the suffix .sensitivities]
    ///
    /// Contains sensitivities.html, sensitivities.csv (derivatives of the statistics of outputs),
    /// sensitivities_by_position.csv, and sensitivities.jsonl, from which the same command
    /// continues after an interruption.
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Files with the names of results are replaced; all others are kept.
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    solving: Solving,
}

impl Sensitivities {
    /// Returns the format of warnings; `None` if only errors are printed.
    pub fn warnings(&self) -> Option<MessageFormat> {
        (!self.solving.quiet).then_some(MessageFormat::Human)
    }

    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let given = match given_of(self.params.as_deref(), &self.set) {
            Ok(given) => given,
            Err(why) => {
                format.refused(&why);
                return ExitCode::from(USAGE);
            }
        };
        let overrides = self.overrides.to_override();
        let check = || check_run_within(&self.file, &self.allow.paths(), &given, overrides, None);
        let (module, _) = match compile(&self.file, self.solving.quiet, format, check) {
            Ok(compiled) => compiled,
            Err(status) => return status,
        };
        if module.has_errors() {
            return ExitCode::from(MODEL_ERROR);
        }
        let mut instance = match self.instance(&module, &given) {
            Ok(instance) => instance,
            Err(error) => return failed(format, &module, RunError::Run(error)),
        };
        let directory = self.out.clone().unwrap_or_else(|| beside(&self.file, ".sensitivities"));
        let locked = RunDirectory::lock(&directory, Kind::Sensitivities, self.force).and_then(|locked| {
            let listed = locked.claim_all([SENSITIVITIES, SENSITIVITIES_BY_POSITION, page::NAME]);
            listed
                .map(|()| Arc::new(locked))
                .map_err(|error| DirectoryError::Io { path: directory.clone(), error })
        });
        let locked = match locked {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        match SensitivityJournal::of_instance(&instance, locked.clone(), &self.of) {
            Ok(journal) => {
                self.note_replaced(&journal);
                instance.store_sensitivities(Arc::new(journal));
            }
            Err(error) => return failed(format, &module, RunError::Run(error)),
        }
        match self.solve(instance).and_then(|results| Ok((self.shown(&results)?, results))) {
            Ok((shown, results)) => self.report(&results.sensitivity_table(shown), &locked),
            Err(error) => {
                let is_interrupted = error.kind() == ErrorKind::Cancelled;
                let status = failed(format, &module, RunError::Run(error));
                if is_interrupted {
                    format.note(&format!(
                        "the derivatives found so far are in {}; the same command continues after them\n",
                        locked.path().display()
                    ));
                }
                status
            }
        }
    }

    /// States that stored derivatives cannot be used.
    fn note_replaced(&self, journal: &SensitivityJournal) {
        let params = match journal.replaced() {
            0 => return,
            1 => "a param".to_owned(),
            count => format!("{count} params"),
        };
        if !self.solving.quiet {
            MessageFormat::Human.note(&format!(
                "the stored derivatives by {params} belong to another text of the model, or to other values, settings or outputs, and are replaced\n"
            ));
        }
    }

    /// Creates the instance with its params, settings and requested derivatives.
    fn instance(&self, module: &Module, given: &[ParamAssignment]) -> Result<Instance, Error> {
        let mut instance = Instance::new(&self.solving.engine(), module.as_program());
        for given in given {
            instance.give(given)?;
        }
        // Estimates of errors cost more than the values.
        let mut overrides = self.overrides.to_override();
        overrides.error_estimates = overrides.error_estimates.or(Some(Estimates::None));
        instance.override_analysis(overrides);
        let requested =
            if self.to.is_empty() { all_params(instance.description())? } else { self.to.clone() };
        instance.request_sensitivities(&requested)?;
        instance.limit_sensitivities(self.of.iter().cloned())?;
        instance.set_cancel(interrupt::flag());
        Ok(instance)
    }

    fn solve(&self, mut instance: Instance) -> Result<Results, Error> {
        let progress = Arc::new(self.solving.progress());
        let shown = progress.clone();
        instance.on_progress(move |state| match state.total {
            Some(total) if state.done > 0 => shown.step(state.done - 1, total),
            _ => shown.stage(state.stage),
        });
        let results = instance.solve();
        progress.finish();
        results
    }

    /// Returns the indices of the outputs to show.
    fn shown(&self, results: &Results) -> Result<Vec<usize>, Error> {
        if self.of.is_empty() {
            return Ok((0..results.description().outputs.len()).collect());
        }
        let outputs = &results.description().outputs;
        let of_name = |name: &String| -> Result<Vec<usize>, Error> {
            let elements: Vec<usize> =
                (0..outputs.len()).filter(|&index| is_named(&outputs[index].name, name)).collect();
            // Neither an output nor an array: the message lists the outputs.
            if elements.is_empty() { Ok(vec![results.output(name.as_str())?.index()]) } else { Ok(elements) }
        };
        let shown = self.of.iter().map(of_name).collect::<Result<Vec<_>, Error>>()?;
        Ok(shown.into_iter().flatten().collect())
    }

    /// Writes the results and prints the table.
    fn report(&self, all: &SensitivityTable, directory: &RunDirectory) -> ExitCode {
        let (format, path) = (MessageFormat::Human, directory.path());
        let written = write_table(&path.join(SENSITIVITIES), all)
            .and_then(|()| write_positions(&path.join(SENSITIVITIES_BY_POSITION), all))
            .and_then(|()| page::write(&path.join(page::NAME), all));
        if let Err(error) = written {
            return format.unwritable(path, &error.to_string());
        }
        print!("{}", text(all));
        if !self.solving.quiet {
            format.note(&format!("all statistics and plots are in {}\n", path.join(page::NAME).display()));
        }
        if all.sensitivities.iter().all(|own| own.failure.is_some()) {
            return ExitCode::from(MODEL_ERROR);
        }
        ExitCode::SUCCESS
    }
}

/// Returns the names of all params with respect to which outputs can be differentiated.
fn all_params(description: &ModelDescription) -> Result<Vec<String>, Error> {
    let names: Vec<String> = description
        .params
        .iter()
        .filter(|param| param.is_continuous())
        .map(|param| param.name.clone())
        .collect();
    if names.is_empty() {
        return Err(Error::Given(InvalidParam::new(
            "the model has no params that take decimal numbers",
            "declare one, like `param torque = 100 N*m;`",
        )));
    }
    Ok(names)
}
