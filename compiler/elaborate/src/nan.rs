//! Explains a NaN that stopped a model: the expression that produced it, the operands, and the
//! time.
//!
//! Kernels record the inputs for which an output was NaN. If the NaN was produced earlier, by the
//! program itself, the program is interpreted again with NaN tracing.

use crate::interpreted::Interpreted;
use calyx_abi::error::Place;
use calyx_abi::text::number;
use calyx_abi::{Context, Purity, RuntimeError};
use calyx_gears::host::ModelHost;
use calyx_lang::ir::{Program, SiteId, SymExpr, SymKind};
use calyx_lang::span::{FileId, Span};
use calyx_lower::kernels::trace_nan;
use calyx_lower::nan::NanSource;
use calyx_rt::program::ParamFunction;
use calyx_rt::{NanLog, ParamAssignment, Program as _, apply};
use std::collections::HashSet;

/// Codes of errors that a NaN causes: in an equation, a frame, an argument, an output.
const EQUATION: &str = "E0863";
const FRAME: &str = "E0710";
const ARGUMENT: &str = "E0722";
const OUTPUT: &str = "E0721";
/// Code of an argument outside of its range, which may be infinite or NaN.
const RANGE: &str = "E0314";

/// Returns the site that is responsible for an error, and the inputs for which its kernel returned
/// NaN.
fn blamed(program: &Program, seen: &NanLog, code: &str) -> Option<(usize, Vec<f64>)> {
    let inputs = |site| Some((site, seen.inputs(site)?));
    match code {
        // The error reports the first output that is NaN.
        OUTPUT => program.outputs.iter().find_map(|output| inputs(output.site.0 as usize)),
        _ => inputs(seen.last()?),
    }
}

/// Adds the origin of a NaN to the error that the NaN caused. `given` are the params of the failed
/// run.
pub fn explain(program: &Program, given: &[ParamAssignment], seen: &NanLog, error: &mut RuntimeError) {
    if error.code == EQUATION
        && let Some(equation) = failed_equation(program, seen)
    {
        error.message = error.message.replacen("an equation", &format!("the equation `{equation}`"), 1);
        error.message = error.message.replacen("a function", &format!("the function `{equation}`"), 1);
    }
    let note = match error.code == RANGE {
        true => outside_range(program, given, seen, error),
        false => found(program, given, seen, &error.code),
    };
    error.details.notes.extend(note);
}

/// Returns the function of the `solve` or `minimize` that found nothing.
fn failed_equation(program: &Program, seen: &NanLog) -> Option<String> {
    let (site, inputs) = blamed(program, seen, EQUATION)?;
    trace_nan(program, SiteId(site as u32), &inputs)?.equation
}

fn found(program: &Program, given: &[ParamAssignment], seen: &NanLog, code: &str) -> Option<(Place, String)> {
    match code {
        ARGUMENT => {
            let source = retrace(program, given, seen, |interpreted| interpreted.trace()?.in_call())?;
            Some(note(program, &source, None))
        }
        EQUATION | FRAME | OUTPUT => {
            let (site, inputs) = blamed(program, seen, code)?;
            let site = SiteId(site as u32);
            let time = inputs.first().copied().filter(|_| depends_on_time(program, site));
            let found = trace_nan(program, site, &inputs)?;
            let Some(input) = found.input else { return Some(note(program, &found, time)) };
            let captured = retrace(program, given, seen, |interpreted| interpreted.trace()?.captured(site));
            Some(match captured {
                Some(source) => note(program, &source, None),
                None => from_outside(program, site, input, found.span),
            })
        }
        _ => None,
    }
}

/// Returns `true` if the value of a site may depend on `Time`.
fn depends_on_time(program: &Program, site: SiteId) -> bool {
    let Some(site) = program.sites.get(site.0 as usize) else { return false };
    if site.captures.iter().any(|capture| capture.observable || capture.is_part()) {
        return true;
    }
    let mut left: Vec<&SymExpr> = site.shared.iter().chain([&site.expr]).collect();
    let mut seen = HashSet::new();
    while let Some(e) = left.pop() {
        match &e.kind {
            SymKind::Time => return true,
            SymKind::Call(id, _) | SymKind::Solve(_, id, _) if seen.insert(id.0) => {
                let function = program.symbolic_functions.get(id.0 as usize);
                left.extend(function.into_iter().flat_map(|f| f.shared.iter().chain([&f.body])));
            }
            _ => {}
        }
        left.extend(e.operands());
    }
    false
}

/// Returns the origin of an infinite or NaN argument that is outside of its range, such as a
/// division by zero.
fn outside_range(
    program: &Program,
    given: &[ParamAssignment],
    seen: &NanLog,
    error: &RuntimeError,
) -> Option<(Place, String)> {
    let (_, value) = error.message.split_once(", not ").or(error.message.split_once(" is "))?;
    let infinite = value.trim_start_matches('-').starts_with("inf");
    if !infinite && !value.to_lowercase().starts_with("nan") {
        return None;
    }
    let interpreted = Interpreted::new(program, Purity::Scene).ok()?;
    let interpreted = if infinite { interpreted.tracing_infinities() } else { interpreted.tracing() };
    let mut context = context(&interpreted);
    context.cancel = seen.cancel.clone();
    context.limits = seen.limits;
    apply(&interpreted, given, &mut context).ok()?;
    // NaN in place of an infinite number may fail elsewhere, or as NaN in the call.
    let again = interpreted.main(&mut context).err()?;
    let argument = |error: &RuntimeError| error.message.split('`').nth(1).map(str::to_owned);
    if !matches!(again.code.as_str(), RANGE | ARGUMENT) || argument(&again) != argument(error) {
        return None;
    }
    let source = interpreted.trace()?.compared()?;
    let (at, text) = note(program, &source, None);
    let text = if infinite { text.replacen("NaN", "infinity", 1) } else { text };
    Some((at, text))
}

/// Returns the origin of a NaN in the default of a param.
pub(crate) fn of_default(program: &Program) -> Option<(Span, NanSource)> {
    let interpreted = Interpreted::new(program, Purity::Scene).ok()?.tracing();
    let mut context = context(&interpreted);
    context.params = vec![f64::NAN; program.params.len()];
    context.param_slots = vec![0; program.params.len()];
    for (index, param) in program.params.iter().enumerate() {
        let slot = interpreted.param_function(index, ParamFunction::Default, &mut context).ok()??;
        context.param_slots[index] = slot;
        context.params[index] = f64::from_bits(slot);
        if let Some(source) = interpreted.trace()?.source(slot) {
            return Some((param.span, source));
        }
    }
    None
}

/// Returns the location and the description of a NaN's origin.
pub(crate) fn note(program: &Program, source: &NanSource, time: Option<f64>) -> (Place, String) {
    let Span { file: FileId(file), start, end } = source.span;
    let text = program.files.get(file as usize).and_then(|file| file.text.get(start as usize..end as usize));
    let text = text.filter(|text| !text.is_empty() && !text.contains('\n'));
    let what = text.map_or("NaN arose here".to_owned(), |text| format!("`{text}` gave NaN here"));
    let why = source.made_by.as_ref().map(|made_by| format!(": {made_by}")).unwrap_or_default();
    let when = time.map(|time| format!(" at Time = {} s", number(time))).unwrap_or_default();
    ((file, start, end), format!("{what}{why}{when}"))
}

/// Describes a NaN that an input already had, such as an observable's value.
fn from_outside(program: &Program, site: SiteId, input: u32, span: Span) -> (Place, String) {
    let first = 1 + program.params.len();
    let captures =
        program.sites.get(site.0 as usize).map(|site| site.captures.as_slice()).unwrap_or_default();
    let name = captures.get((input as usize).saturating_sub(first)).map_or("this", |capture| &capture.name);
    ((span.file.0, span.start, span.end), format!("the engine observed NaN for `{name}`"))
}

/// Interprets the program again with the same params and NaN tracing, and returns the result of
/// `ask`.
fn retrace<R>(
    program: &Program,
    given: &[ParamAssignment],
    seen: &NanLog,
    ask: impl FnOnce(&Interpreted) -> Option<R>,
) -> Option<R> {
    let interpreted = Interpreted::new(program, Purity::Scene).ok()?.tracing();
    let mut context = context(&interpreted);
    context.cancel = seen.cancel.clone();
    context.limits = seen.limits;
    apply(&interpreted, given, &mut context).ok()?;
    // It fails again as before.
    let _ = interpreted.main(&mut context);
    ask(&interpreted)
}

fn context(interpreted: &Interpreted) -> Context {
    let host = ModelHost { checking: true, ..ModelHost::new(interpreted.description()) };
    let mut context = Context::new(Box::new(host));
    context.kernels = interpreted.kernels();
    context.print = Box::new(|_| {});
    context
}
