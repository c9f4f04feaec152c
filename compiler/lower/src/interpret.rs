//! An interpreter of the typed program, for `check` and the editor. It is also the reference for
//! compiled code.
//!
//! Machine code must produce the same bits, the same errors and the same source locations.
//! Everything that could differ is therefore defined once, elsewhere: scalar operations in
//! [`calyx_abi::math`], vectors and frames in [`crate::operations`], arrays, strings and limits in
//! [`calyx_abi::helpers`].

mod blame;
mod error_recovery;
mod expression;
mod place;
mod reuse;
mod scalar;
mod statement;
mod trace;

pub use blame::CallSites;
pub use reuse::{CallContent, CallResult, CallResults};
pub use trace::NanTrace;

use crate::fingerprint::FingerprintHasher;
use crate::layout::{running_sums, tuple_offset};
use crate::link::{LinkError, resolve_externs};
use calyx_abi::context::{Context, MAX_DEPTH, RuntimeError};
use calyx_abi::description::LIBRARY;
use calyx_abi::error::Place;
use calyx_abi::helpers::CaptureKind;
use calyx_abi::{Extern, Purity, Slot, helpers, limits, repr_code, stack};
use calyx_lang::ir::{Expr, ExprKind, Function, FunctionId, LocalId, Mode, Program, Site, SiteId};
use calyx_lang::span::Span;
use std::collections::HashMap;
use std::hash::BuildHasherDefault;
use std::ops::Range;

/// A program and the engine functions that it calls.
pub struct Interpreter<'p> {
    program: &'p Program,
    externs: Vec<&'p Extern>,
    /// The highest purity of engine functions that are called; others are skipped.
    allow: Purity,
    frames: Vec<Frame>,
    sites: Vec<Captured>,
    /// For each param, the number of slots of all params before it.
    param_offsets: Vec<usize>,
    /// Library failures after which the program continued; `None` if it stops at the first failure.
    failures: Option<error_recovery::Failures>,
    /// The NaN trace, if tracing is enabled.
    trace: Option<NanTrace>,
    /// Results of earlier calls, if the interpreter reuses them.
    reuse: Option<reuse::Reuse<'p>>,
}

/// The positions of a function's locals in its stack frame.
struct Frame {
    /// Start and number of slots of each local.
    locals: Vec<(usize, usize)>,
    slots: usize,
}

/// Slots of a local or of an element of it.
#[derive(Clone, Copy)]
struct LocalPart {
    /// Position in the frame of the function.
    offset: usize,
    slots: usize,
}

/// The captures of a site, and its value.
struct Captured {
    /// [`CaptureKind`]s of the captured slots as bytes.
    kinds: Vec<u8>,
    /// `true` if no capture is symbolic.
    is_plain: bool,
    /// `true` if the slots of the value are the bits of numbers.
    is_numbers: bool,
}

impl Captured {
    fn of(site: &Site) -> Self {
        let captures = site.captures.iter();
        let kinds = captures.flat_map(|capture| CaptureKind::of_slots(&capture.repr, capture.observable));
        let kinds: Vec<u8> = kinds.map(|kind| kind as u8).collect();
        let is_plain = helpers::are_plain(&kinds);
        Captured { kinds, is_plain, is_numbers: repr_code::is_numbers(&repr_code::encode(&site.repr)) }
    }
}

impl<'p> Interpreter<'p> {
    /// Prepares to run a program. Calls only engine functions whose purity is at most `allow`. With
    /// `Purity::Scene`, as `check` uses it, an `Effect` is skipped and returns zeros, an empty
    /// string or an empty array.
    ///
    /// # Errors
    /// The engine lacks a function that the program declares.
    pub fn new(program: &'p Program, externs: &'p [Extern], allow: Purity) -> Result<Self, LinkError> {
        let externs = resolve_externs(program, externs)?;
        let frames = program.functions.iter().map(|function| {
            let sizes: Vec<usize> = function.locals.iter().map(|local| local.repr.slots()).collect();
            let (offsets, slots) = running_sums(sizes.iter().copied());
            Frame { locals: offsets.into_iter().zip(sizes).collect(), slots }
        });
        let frames = frames.collect();
        let sites = program.sites.iter().map(Captured::of).collect();
        let (param_offsets, _) = running_sums(program.params.iter().map(|param| param.repr.slots()));
        Ok(Interpreter {
            program,
            externs,
            allow,
            frames,
            sites,
            param_offsets,
            failures: None,
            trace: None,
            reuse: None,
        })
    }

    /// Runs the top level of the model.
    ///
    /// # Errors
    /// Any error of the program or of the engine, with its source location.
    pub fn run_main(&self, ctx: &mut Context) -> Result<(), RuntimeError> {
        self.run_function(self.program.main, &[], ctx).map(|_| ())
    }

    /// Runs the top level of the model and returns the final slots of its variables, in order.
    ///
    /// # Errors
    /// As for [`Interpreter::run_main`].
    pub fn run_main_to_values(&self, ctx: &mut Context) -> Result<Vec<Slot>, RuntimeError> {
        self.run(self.program.main, &[], ctx, true)
    }

    /// Runs one function (for example a param's default) and returns the slots of its result,
    /// followed by those of its `out` and `inout` parameters. `arguments` holds the slots of its
    /// `in` and `inout` parameters.
    ///
    /// # Errors
    /// As for [`Interpreter::run_main`].
    pub fn run_function(
        &self,
        id: FunctionId,
        arguments: &[Slot],
        ctx: &mut Context,
    ) -> Result<Vec<Slot>, RuntimeError> {
        self.run(id, arguments, ctx, false)
    }

    /// Runs a function. If `keep` is set, returns the slots of its variables instead of its result.
    fn run(
        &self,
        id: FunctionId,
        arguments: &[Slot],
        ctx: &mut Context,
        keep: bool,
    ) -> Result<Vec<Slot>, RuntimeError> {
        let here = stack::is_large();
        stack::with_stack(|| {
            ctx.text.clear();
            let depth = ctx.depth;
            if !here {
                ctx.depth = 0;
            }
            let (function, frame) = self.function(id)?;
            let activation = Activation { function, frame, base: 0 };
            let mut machine = Machine {
                interpreter: self,
                ctx,
                stack: arguments.to_vec(),
                activation,
                parts: HashMap::default(),
                guards: 0,
                calls: Vec::new(),
                kept: None,
            };
            machine.kept = keep.then(Vec::new);
            machine.at(function.span);
            let result = machine.call(id, 0);
            let slots = machine.kept.unwrap_or(machine.stack);
            ctx.depth = depth;
            result.map(|()| slots).map_err(|mut error| {
                error.place.get_or_insert(ctx.place);
                error
            })
        })?
    }

    fn site(&self, id: SiteId) -> Result<(&'p Site, &Captured), RuntimeError> {
        let index = id.0 as usize;
        let site = self.program.sites.get(index).zip(self.sites.get(index));
        site.ok_or_else(|| helpers::malformed("a symbolic site that is not there"))
    }

    fn function(&self, id: FunctionId) -> Result<(&'p Function, &Frame), RuntimeError> {
        let index = id.0 as usize;
        let function = self.program.functions.get(index).zip(self.frames.get(index));
        function.ok_or_else(|| helpers::malformed("a function that is not there"))
    }
}

/// The state of one run. Frames and intermediate values share one stack of slots.
struct Machine<'m, 'p> {
    interpreter: &'m Interpreter<'p>,
    ctx: &'m mut Context,
    stack: Vec<Slot>,
    activation: Activation<'m, 'p>,
    /// Parts of locals by the addresses of the expressions that read them; `None` for expressions
    /// that are computed.
    parts: HashMap<*const Expr, Option<LocalPart>, BuildHasherDefault<FingerprintHasher>>,
    /// The active calls, outermost first.
    calls: Vec<(FunctionId, Place)>,
    /// Number of active blocks, in this function and its callers, whose errors the program catches.
    guards: usize,
    /// The final variables of the outermost function, if requested.
    kept: Option<Vec<Slot>>,
}

/// The function that is running.
#[derive(Clone, Copy)]
struct Activation<'m, 'p> {
    function: &'p Function,
    frame: &'m Frame,
    /// Start of its frame on the stack.
    base: usize,
}

impl<'p> Machine<'_, 'p> {
    /// Records the source range of the next operation, for errors.
    fn at(&mut self, span: Span) {
        self.ctx.place = (span.file.0, span.start, span.end);
    }

    /// Calls a function as [`Machine::call`] does, at a source location.
    fn call_at(&mut self, id: FunctionId, start: usize, span: Span) -> Result<(), RuntimeError> {
        self.at(span);
        let place = self.ctx.place;
        self.calls.push((id, place));
        let around = self.ctx.library_call;
        let callee = self.interpreter.program.functions.get(id.0 as usize);
        if !self.is_library(span) && callee.is_some_and(|callee| self.is_library(callee.span)) {
            self.ctx.library_call = place;
        }
        let result = self.call_or_reuse(id, start);
        self.ctx.library_call = around;
        self.calls.pop();
        result.map_err(|mut error| {
            error.place.get_or_insert(self.ctx.place);
            let name = self.interpreter.program.functions.get(id.0 as usize).map_or("", |f| &f.name);
            error.passed(name, place);
            error
        })
    }

    fn is_library(&self, span: Span) -> bool {
        let file = self.interpreter.program.files.get(span.file.0 as usize);
        file.is_some_and(|file| file.name.starts_with(LIBRARY))
    }

    /// Calls a function whose arguments are the slots from `start` on, and replaces the arguments
    /// by the results.
    fn call(&mut self, id: FunctionId, start: usize) -> Result<(), RuntimeError> {
        let (function, frame) = self.interpreter.function(id)?;
        if self.ctx.depth >= MAX_DEPTH {
            return Err(limits::too_deep());
        }
        self.ctx.depth += 1;
        let activation = Activation { function, frame, base: self.stack.len() };
        let caller = std::mem::replace(&mut self.activation, activation);
        let result = self.run(start);
        self.activation = caller;
        self.ctx.depth -= 1;
        result
    }

    /// Runs the current function in a new frame.
    fn run(&mut self, start: usize) -> Result<(), RuntimeError> {
        let Activation { function, frame, base } = self.activation;
        self.stack.resize(base + frame.slots, 0);
        let mut argument = start;
        for (local, mode) in &function.parameters {
            if *mode != Mode::Out {
                let target = self.local(*local)?;
                let count = target.len();
                if argument + count > base {
                    return Err(helpers::malformed("a call with too few arguments"));
                }
                self.stack.copy_within(argument..argument + count, target.start);
                argument += count;
            }
        }
        self.run_blocks()?;
        if let Some(kept) = self.kept.as_mut().filter(|_| start == 0 && self.ctx.depth == 1) {
            kept.extend(self.stack.get(base..base + frame.slots).unwrap_or_default());
        }
        for (local, mode) in &function.parameters {
            if *mode != Mode::In {
                let slots = self.local(*local)?;
                self.stack.extend_from_within(slots);
            }
        }
        self.stack.drain(start..base + frame.slots);
        Ok(())
    }

    /// Returns the stack range of an element of a local tuple; `None` for other expressions.
    fn stored(&mut self, expr: &'p Expr) -> Result<Option<Range<usize>>, RuntimeError> {
        let base = self.activation.base;
        let part = match self.parts.get(&std::ptr::from_ref(expr)) {
            Some(known) => *known,
            None => {
                let part = self.local_part(expr)?;
                self.parts.insert(expr, part);
                part
            }
        };
        Ok(part.map(|LocalPart { offset, slots }| base + offset..base + offset + slots))
    }

    fn local_part(&self, expr: &Expr) -> Result<Option<LocalPart>, RuntimeError> {
        Ok(match &expr.kind {
            ExprKind::Local(local) => {
                let range = self.local(*local)?;
                Some(LocalPart { offset: range.start - self.activation.base, slots: range.len() })
            }
            ExprKind::TupleElement(tuple, index) => {
                let Some(whole) = self.local_part(tuple)? else { return Ok(None) };
                let before = tuple_offset(&tuple.repr, *index);
                let before = before.ok_or_else(|| helpers::malformed("not a tuple"))?;
                Some(LocalPart { offset: whole.offset + before, slots: expr.repr.slots() })
            }
            _ => None,
        })
    }

    /// Returns the stack range of a local.
    fn local(&self, local: LocalId) -> Result<Range<usize>, RuntimeError> {
        let Activation { frame, base, .. } = self.activation;
        match frame.locals.get(local.0 as usize) {
            Some((offset, slots)) => Ok(base + offset..base + offset + slots),
            None => Err(helpers::malformed("a local that is not there")),
        }
    }
}
