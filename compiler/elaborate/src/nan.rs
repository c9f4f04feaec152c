//! Tells where a NaN came from that stopped a model: the expression it arose in, what its operation was given, and when.
//!
//! Kernels note the inputs at which NaN came out of them. If the cause lies before, in the program itself, the program is
//! interpreted once more, following every NaN.

use crate::interpreted::Interpreted;
use calyx_abi::text::number;
use calyx_abi::{Cancel, Context, Kernel, Purity, RuntimeError};
use calyx_gears::host::ModelHost;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{Program, SiteId};
use calyx_lang::span::{FileId, Span};
use calyx_lower::kernels::trace_nan;
use calyx_lower::nan::NanSource;
use calyx_rt::program::ParamFunction;
use calyx_rt::{Given, Program as _, apply};
use std::collections::HashMap;
use std::sync::{Arc, Mutex};

/// Codes of errors that NaN causes: of a frame, an argument, an output.
const FRAME: &str = "E0710";
const ARGUMENT: &str = "E0722";
const OUTPUT: &str = "E0721";

/// Inputs at which kernels gave NaN: by site, and the site that did so last.
#[derive(Clone, Default)]
pub struct Seen {
    state: Arc<Mutex<State>>,
    /// Stops the second run of a program, too.
    cancel: Cancel,
}

#[derive(Default)]
struct State {
    inputs: HashMap<usize, Vec<f64>>,
    last: Option<usize>,
}

impl Seen {
    /// Notes of a run that this flag stops.
    pub(crate) fn stopped_by(cancel: Cancel) -> Seen {
        Seen { cancel, ..Seen::default() }
    }

    /// Kernels, one per site, that note it when NaN comes out of them.
    pub fn watched(&self, kernels: Vec<Arc<dyn Kernel>>) -> Vec<Arc<dyn Kernel>> {
        let watch =
            |(site, kernel)| Arc::new(Watched { kernel, site, seen: self.clone() }) as Arc<dyn Kernel>;
        kernels.into_iter().enumerate().map(watch).collect()
    }

    fn note(&self, site: usize, inputs: &[f64]) {
        if let Ok(mut state) = self.state.lock() {
            state.inputs.insert(site, inputs.to_vec());
            state.last = Some(site);
        }
    }

    /// The site to blame for an error, and its inputs.
    fn of(&self, program: &Program, code: &str) -> Option<(usize, Vec<f64>)> {
        let state = self.state.lock().ok()?;
        let site = match code {
            // The first output that is not a number is the one that is reported.
            OUTPUT => {
                program.outputs.iter().map(|o| o.site.0 as usize).find(|site| state.inputs.contains_key(site))
            }
            _ => state.last,
        }?;
        Some((site, state.inputs.get(&site)?.clone()))
    }
}

struct Watched {
    kernel: Arc<dyn Kernel>,
    site: usize,
    seen: Seen,
}

impl Kernel for Watched {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        self.kernel.eval(inputs, outputs);
        let count = self.kernel.outputs().min(outputs.len());
        if outputs[..count].iter().any(|output| output.is_nan()) {
            self.seen.note(self.site, inputs);
        }
    }

    fn inputs(&self) -> usize {
        self.kernel.inputs()
    }

    fn outputs(&self) -> usize {
        self.kernel.outputs()
    }
}

/// The diagnostic of an error with a label where the NaN behind it arose, if NaN is behind it. `given` are the params of
/// the run that failed.
pub fn explain(
    program: &Program,
    given: &[Given],
    seen: &Seen,
    error: &RuntimeError,
    diagnostic: Diagnostic,
) -> Diagnostic {
    match error.code.as_str() {
        ARGUMENT => match retrace(program, given, seen, |interpreted| interpreted.trace()?.in_call()) {
            Some(source) => label(program, diagnostic, &source, None),
            None => diagnostic,
        },
        FRAME | OUTPUT => {
            let Some((site, inputs)) = seen.of(program, &error.code) else { return diagnostic };
            let time = inputs.first().copied();
            let site = SiteId(site as u32);
            let Some(found) = trace_nan(program, site, &inputs) else { return diagnostic };
            let Some(input) = found.input else { return label(program, diagnostic, &found, time) };
            match retrace(program, given, seen, |interpreted| interpreted.trace()?.captured(site)) {
                Some(source) => label(program, diagnostic, &source, None),
                None => from_outside(program, diagnostic, site, input, found.span),
            }
        }
        _ => diagnostic,
    }
}

/// A param whose default is not a number: where it arose.
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

/// Adds where a NaN arose.
pub(crate) fn label(
    program: &Program,
    diagnostic: Diagnostic,
    source: &NanSource,
    time: Option<f64>,
) -> Diagnostic {
    let Span { file: FileId(file), start, end } = source.span;
    let text = program.files.get(file as usize).and_then(|file| file.text.get(start as usize..end as usize));
    let text = text.filter(|text| !text.is_empty() && !text.contains('\n'));
    let what = text.map_or("NaN arose here".to_owned(), |text| format!("`{text}` gave NaN here"));
    let why = source.made_by.as_ref().map(|made_by| format!(": {made_by}")).unwrap_or_default();
    let when = time.map(|time| format!(" at Time = {} s", number(time))).unwrap_or_default();
    diagnostic.label(source.span, format!("{what}{why}{when}"))
}

/// A NaN that neither the program nor its expression made: an observable's.
fn from_outside(
    program: &Program,
    diagnostic: Diagnostic,
    site: SiteId,
    input: u32,
    span: Span,
) -> Diagnostic {
    let first = 1 + program.params.len();
    let captures =
        program.sites.get(site.0 as usize).map(|site| site.captures.as_slice()).unwrap_or_default();
    let name = captures.get((input as usize).saturating_sub(first)).map_or("this", |capture| &capture.name);
    diagnostic.label(span, format!("the engine observed no number for `{name}`"))
}

/// Interprets the program with the same params, following NaN, and asks what was found.
fn retrace<R>(
    program: &Program,
    given: &[Given],
    seen: &Seen,
    ask: impl FnOnce(&Interpreted) -> Option<R>,
) -> Option<R> {
    let interpreted = Interpreted::new(program, Purity::Scene).ok()?.tracing();
    let mut context = context(&interpreted);
    context.cancel = seen.cancel.clone();
    apply(&interpreted, given, &mut context).ok()?;
    // It ends where it ended before.
    let _ = interpreted.main(&mut context);
    ask(&interpreted)
}

fn context(interpreted: &Interpreted) -> Context {
    let mut context = Context::new(Box::new(ModelHost::new(&interpreted.description().units)));
    context.kernels = interpreted.kernels();
    context.print = Box::new(|_| {});
    context
}
