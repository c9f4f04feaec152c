//! Runs a program without solving anything, and collects what it describes.

use crate::diagnostics::{diagnostic, finding_diagnostic, place};
use crate::geometry::Geometry;
use crate::interpreted::{Interpreted, no_kernel};
use crate::known_kernels::kernel_of;
use crate::nan::{explain, note, of_default};
use crate::plan::Planned;
use crate::printed::Printed;
use crate::values::{self, Value};
use calyx_abi::context::codes;
use calyx_abi::description::{FileDescription, ModelDescription};
use calyx_abi::{Cancel, Context, Purity, RuntimeError, stack};
use calyx_gears::calculation::calculate;
use calyx_gears::data_block::DataBlock;
use calyx_gears::externs::{check_plan, check_unrestrained};
use calyx_gears::host::ModelHost;
use calyx_gears::sensitivity_externs::check as check_sensitivities;
use calyx_gears::signal_externs::check as check_signals;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::{Program, SiteId};
use calyx_lang::span::Span;
use calyx_lower::interpret::CallSites;
use calyx_lower::kernels::SiteContent;
use calyx_lower::repeatable::RepeatableFunctions;
use calyx_rt::{Error, InvalidParam, NanLog, ParamAssignment, Program as _, apply};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::settings_override::Override;
use calyx_symbolic::TapeKernel;
use std::collections::{BTreeMap, HashSet};
use std::fmt;
use std::num::NonZero;
use std::panic::resume_unwind;
use std::sync::{Arc, Mutex};
use std::thread::{Builder, available_parallelism};

/// Limit of the basic blocks that a program may enter during checking. A program that does not end
/// is stopped.
pub const FUEL: u64 = 20_000_000;

/// Memory limit, bytes, for the program's values and output during checking. It is small because an
/// editor checks several models at the same time.
pub const MEMORY: u64 = 256_000_000;

/// Returns an error if the elaboration was cancelled.
fn ensure_running(cancel: &Cancel) -> Result<(), Cancelled> {
    if cancel.is_cancelled() { Err(Cancelled) } else { Ok(()) }
}

/// Returns the interrupt that the engine polls.
fn interrupt(cancel: &Cancel) -> Interrupt {
    let cancel = cancel.clone();
    // The message is never shown: a cancelled elaboration has no result.
    Interrupt::new(move || {
        ensure_running(&cancel)
            .map_err(|Cancelled| EngineError::new(codes::CANCELLED, Cancelled.to_string(), ""))
    })
}

/// The elaboration was stopped by its [`Cancel`]; there is no partial result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl fmt::Display for Cancelled {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the elaboration was cancelled")
    }
}

impl std::error::Error for Cancelled {}

/// The params for which a model is elaborated.
#[derive(Clone, Copy, Debug)]
pub enum Params<'a> {
    Defaults,
    /// The params of a run, the settings that override its analysis, and its memory limit in bytes,
    /// if any. A run has no time limit.
    Given(&'a [ParamAssignment], Override, Option<u64>),
}

/// The description of a model for particular params.
#[derive(Debug, Default)]
pub struct Elaboration {
    /// The model's own description, with the defaults and ranges of its params.
    pub description: ModelDescription,
    /// Problems of the gears and the scene, and failures, in order of file and position.
    pub found: Vec<Diagnostic>,
    /// The reason why the given params were rejected.
    pub refused: Option<InvalidParam>,
    /// `false` if the program cannot run for any params; `found` has the reason.
    pub runnable: bool,
    /// The plan of the analysis; `None` if there is no analysis or the scene has errors.
    pub plan: Option<Planned>,
    /// Final values of the top level's variables. Variables are omitted unless their value is an
    /// expression, a number, text or a truth value.
    pub values: BTreeMap<String, Value>,
    /// Derived geometry of the valid gears and meshes, also if others are impossible.
    pub geometry: Geometry,
    /// Data of the gears and meshes, as in the data block of a drawing.
    pub gear_data: DataBlock,
    /// The last lines that the program printed before its first failure.
    pub printed: Vec<String>,
    /// Number of basic blocks that the program entered.
    pub blocks: u64,
}

/// Runs a program without solving anything. Problems of the model are collected in the result, and
/// an impossible gear does not hide the problems of the others.
///
/// # Errors
/// The elaboration was cancelled.
pub fn elaborate(program: &Program, params: Params, cancel: &Cancel) -> Result<Elaboration, Cancelled> {
    Ok(elaborate_and_keep(program, params, cancel)?.0)
}

/// As [`elaborate`]. Returns also what further elaborations of the program need; `None` if it
/// cannot run for any params.
pub(crate) fn elaborate_and_keep(
    program: &Program,
    params: Params,
    cancel: &Cancel,
) -> Result<(Elaboration, Option<Lowered>), Cancelled> {
    let lines = Printed::default();
    let printed = lines.clone();
    let print = Box::new(move |line: &str| printed.push(line));
    let (elaboration, kept) = match lowered(program, cancel)? {
        Ok(lowered) => (elaborate_with(program, &lowered, params, cancel, (print, false))?, Some(lowered)),
        Err(unrunnable) => (*unrunnable, None),
    };
    Ok((Elaboration { printed: lines.lines(), ..elaboration }, kept))
}

/// As [`elaborate`], for a program with the kernels of all sites; returns the problems only.
pub(crate) fn problems_with(
    program: &Program,
    lowered: &Lowered,
    given: &[ParamAssignment],
    cancel: &Cancel,
) -> Result<Vec<Diagnostic>, Cancelled> {
    let params = Params::Given(given, Override::default(), None);
    let print = Box::new(|_: &str| {});
    Ok(elaborate_with(program, lowered, params, cancel, (print, false))?.found)
}

/// Parts that all elaborations of a program share.
pub(crate) struct Lowered {
    /// The kernels of all sites, in order.
    pub(crate) kernels: Vec<Arc<TapeKernel>>,
    sites: CallSites,
    /// Functions whose results earlier elaborations may have.
    repeatable: RepeatableFunctions,
}

/// Number of sites for which another thread pays off.
const SITES_OF_A_THREAD: usize = 32;

/// Lowers the kernels of all sites; or returns the result of a program that has a site without a
/// kernel.
fn lowered(program: &Program, cancel: &Cancel) -> Result<Result<Lowered, Box<Elaboration>>, Cancelled> {
    let each: Vec<SiteId> = (0..program.sites.len() as u32).map(SiteId).collect();
    let lower = |sites: &[SiteId]| {
        let mut kernels = Vec::with_capacity(sites.len());
        for &id in sites {
            ensure_running(cancel)?;
            let Some(site) = program.sites.get(id.0 as usize) else { continue };
            let content = SiteContent::of(program, site);
            match kernel_of(program, id, content) {
                Ok(kernel) => kernels.push((kernel, content)),
                Err(error) => return Ok(Err(Box::new(unrunnable(no_kernel(&error))))),
            }
        }
        Ok(Ok(kernels))
    };
    let threads = match each.len() / SITES_OF_A_THREAD {
        0 | 1 => 1,
        most => available_parallelism().map_or(1, NonZero::get).min(most),
    };
    let mut parts = each.chunks(each.len().div_ceil(threads).max(1));
    let first = parts.next().unwrap_or_default();
    let results = std::thread::scope(|scope| {
        let spawn = |part| (part, Builder::new().spawn_scoped(scope, move || lower(part)));
        let others: Vec<_> = parts.map(spawn).collect();
        let mut results = vec![lower(first)];
        for (part, thread) in others {
            results.push(match thread {
                Ok(thread) => thread.join().unwrap_or_else(|payload| resume_unwind(payload)),
                Err(_) => lower(part),
            });
        }
        results
    });
    let (mut kernels, mut contents) = (Vec::with_capacity(each.len()), Vec::with_capacity(each.len()));
    for result in results {
        match result? {
            Ok(part) => {
                for (kernel, content) in part {
                    kernels.push(kernel);
                    contents.push(content);
                }
            }
            Err(unrunnable) => return Ok(Err(unrunnable)),
        }
    }
    let repeatable = RepeatableFunctions::of(program, &contents);
    Ok(Ok(Lowered { kernels, sites: CallSites::new(program), repeatable }))
}

/// Elaborates a program with the defaults of its params. Returns the lines it prints and the
/// diagnostics.
pub fn elaborate_printing(program: &Program) -> (Vec<String>, Vec<Diagnostic>) {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let printed = lines.clone();
    let print = move |line: &str| {
        if let Ok(mut lines) = printed.lock() {
            lines.push(line.to_owned());
        }
    };
    let cancel = Cancel::default();
    let found = lowered(program, &cancel).and_then(|lowered| match lowered {
        Ok(lowered) => {
            let print: PrintLine = Box::new(print);
            Ok(elaborate_with(program, &lowered, Params::Defaults, &cancel, (print, true))?.found)
        }
        Err(unrunnable) => Ok(unrunnable.found),
    });
    let lines = lines.lock().map(|lines| lines.clone()).unwrap_or_default();
    (lines, found.unwrap_or_default())
}

/// A callback that receives each line that a program prints.
type PrintLine = Box<dyn FnMut(&str) + Send>;

/// As [`elaborate`]; `keeps_output` if all printed lines count as memory of the program.
fn elaborate_with(
    program: &Program,
    lowered: &Lowered,
    params: Params,
    cancel: &Cancel,
    output: (PrintLine, bool),
) -> Result<Elaboration, Cancelled> {
    // The defaults and ranges of all params run on this stack. Otherwise, each of them would run on
    // a thread of its own.
    stack::with_stack(|| elaborate_here(program, lowered, params, cancel, output))
        .unwrap_or_else(|error| Ok(unrunnable(Box::new(diagnostic(&error)))))
}

/// As [`elaborate_with`], on the stack of this thread.
fn elaborate_here(
    program: &Program,
    Lowered { kernels, sites, repeatable }: &Lowered,
    params: Params,
    cancel: &Cancel,
    (print, keeps_output): (PrintLine, bool),
) -> Result<Elaboration, Cancelled> {
    let mut interpreted = match Interpreted::with_kernels(program, Purity::Scene, kernels) {
        Ok(interpreted) => interpreted.recovering().reusing(repeatable),
        Err(found) => return Ok(unrunnable(found)),
    };
    ensure_running(cancel)?;
    let mut context = checking_context(&interpreted, params, cancel);
    (context.print, context.keeps_output) = (print, keeps_output);
    let seen = NanLog::new(cancel.clone(), context.limits);
    context.kernels = seen.watched(interpreted.kernels());
    let defaults =
        apply(&interpreted, &[], &mut context).and_then(|()| interpreted.describe_params(&mut context));
    let (applied, given) = match params {
        Params::Defaults => (defaults, &[][..]),
        Params::Given(given, ..) => (apply(&interpreted, given, &mut context), given),
    };
    let ran = applied.and_then(|()| interpreted.main_to_values(&mut context).map_err(Error::Model));
    let values = ran.as_ref().map(|slots| values::of_top_level(program, slots, &context)).unwrap_or_default();
    ensure_running(cancel)?;
    let survived = interpreted.failures();
    let at_place = |error: &RuntimeError| {
        let mut error = error.clone();
        sites.blame(&mut error);
        explain(program, given, &seen, &mut error);
        diagnostic(&error)
    };
    let mut found: Vec<Diagnostic> = survived.iter().map(at_place).collect();
    let (mut refused, mut planned, mut geometry) = (None, None, Geometry::default());
    let (mut read, mut gear_data) = (Vec::new(), DataBlock::default());
    let mut outputs = None;
    if let Some(host) = context.host::<ModelHost>() {
        let description = interpreted.description();
        if !description.declared_outputs.is_empty() && ran.is_ok() {
            outputs = Some(host.outputs.iter().map(|output| output.name.clone()).collect::<Vec<_>>());
        }
        host.instance.clear();
        host.library_call = None;
        // An incomplete scene has no meaningful analysis.
        if ran.is_ok() && survived.is_empty() {
            let (plan, errors) = check_analysis(host, description, cancel);
            planned = plan;
            found.extend(errors.iter().map(at_place));
        }
        let files = host.files.iter();
        read = files
            .map(|file| FileDescription { name: file.name.clone(), text: file.text.to_string() })
            .collect();
        geometry = Geometry::of(host);
        gear_data = DataBlock::of(host);
        found.extend(host.findings.iter().map(|finding| finding_diagnostic(finding, sites)));
    }
    match ran {
        // A run may need more steps and memory than checking allows.
        Err(Error::Model(error)) if matches!(error.code.as_str(), codes::LIMIT | codes::EXHAUSTED) => {
            if matches!(params, Params::Defaults) {
                found.push(unfinished(at_place(&error)));
            }
        }
        // An error after a failed call may be a consequence of that failure.
        Err(Error::Model(error)) if survived.is_empty() => found.push(at_place(&error)),
        Err(Error::Model(_)) => {}
        Err(Error::Given(why)) => match params {
            Params::Given(..) => refused = Some(why),
            Params::Defaults => found.push(wrong_default(program, why)),
        },
        Ok(_) => {}
    }
    found.sort_by_key(|diagnostic| (diagnostic.primary.span.file, diagnostic.primary.span.start));
    // A loop repeats the same diagnostics in every iteration.
    let mut reported = HashSet::new();
    found.retain(|diagnostic| {
        reported.insert((diagnostic.primary.span, diagnostic.code.clone(), diagnostic.message.clone()))
    });
    ensure_running(cancel)?;
    let description = interpreted.into_description();
    let description = match outputs {
        Some(names) => description.with_outputs(names.iter().map(String::as_str)),
        None => description,
    };
    Ok(Elaboration {
        description: ModelDescription { tables: read.into(), calls: sites.describe(), ..description },
        found,
        refused,
        runnable: true,
        plan: planned,
        values,
        geometry,
        gear_data,
        printed: Vec::new(),
        blocks: FUEL.saturating_sub(context.fuel.saturating_add(context.granted)),
    })
}

/// Plans the analysis of a complete scene. Returns the plan, if there is an analysis that can be
/// planned, and the errors of the analysis.
fn check_analysis(
    host: &mut ModelHost,
    description: &ModelDescription,
    cancel: &Cancel,
) -> (Option<Planned>, Vec<RuntimeError>) {
    check_unrestrained(host);
    let (mut planned, mut errors) = (None, Vec::new());
    if !host.scene.pairs.is_empty() || host.asked.is_some() {
        match check_plan(host, &interrupt(cancel)) {
            Ok(plan) => planned = Some(Planned::of(host, &plan, description)),
            Err(error) => errors.push(error),
        }
    }
    // An analysis checks this itself, but the model may not have one yet.
    if host.asked.is_none() {
        errors.extend(check_signals(host).err());
        errors.extend(check_sensitivities(host).err());
        errors.extend(calculate(host).err());
    }
    (planned, errors)
}

/// Returns the context of a run that builds the scene and solves nothing, without kernels.
fn checking_context(interpreted: &Interpreted, params: Params, cancel: &Cancel) -> Context {
    let overrides = match params {
        Params::Defaults => Override::default(),
        Params::Given(_, overrides, _) => overrides,
    };
    let host = ModelHost { checking: true, overrides, ..ModelHost::new(interpreted.description()) };
    let mut context = Context::new(Box::new(host));
    context.cancel = cancel.clone();
    context.fuel = FUEL;
    let memory = if let Params::Given(_, _, Some(limit)) = params { limit.min(MEMORY) } else { MEMORY };
    context.limits.memory = Some(memory);
    context
}

/// Returns the warning for a program that exceeds a limit of checking, which a run does not have.
fn unfinished(error: Diagnostic) -> Diagnostic {
    let limit = match error.code.as_str() {
        codes::LIMIT => format!("{} million steps", FUEL / 1_000_000),
        _ => format!("{} MB of memory", MEMORY / 1_000_000),
    };
    Diagnostic {
        severity: Severity::Warning,
        code: error.code.replacen('E', "W", 1),
        message: format!("the check ends at its limit of {limit}; a run has no such limit"),
        help: Some("look for a loop that does not end; the statements after it are not checked".into()),
        ..error
    }
}

/// Returns the result for a program that cannot run for any params.
fn unrunnable(found: Box<Diagnostic>) -> Elaboration {
    Elaboration { found: vec![*found], ..Elaboration::default() }
}

/// Returns the diagnostic for a default that its param does not allow.
fn wrong_default(program: &Program, InvalidParam { message, help, .. }: InvalidParam) -> Diagnostic {
    // Messages about params start with the name.
    let name = message.split('`').nth(1).unwrap_or_default();
    let param = program.params.iter().find(|param| param.name == name);
    let span = param.map_or(Span::default(), |param| param.span);
    let found = match param.and_then(|param| param.given) {
        // The model gives the value, so its own text comes first.
        Some(given) => Diagnostic::error("E0314", message.clone(), given, "the argument that determines it")
            .label(span, "the default value"),
        None => Diagnostic::error("E0314", message.clone(), span, "the default value"),
    };
    let found = found.help(help);
    match of_default(program) {
        Some((default, source)) if default == span => {
            let (at, note) = note(program, &source, None);
            found.label(place(Some(at)), note)
        }
        _ => found,
    }
}
