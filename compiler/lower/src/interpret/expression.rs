//! Evaluation of expressions: each leaves its slots on top of the stack.

use super::scalar::SlotScalars;
use super::{Captured, Machine};
use crate::layout::{blame_table, stride, tuple_offset};
use crate::operations::{Scalars, compared_text, expand, is_scalar};
use calyx_abi::context::RuntimeError;
use calyx_abi::helpers::{self, malformed};
use calyx_abi::{Purity, Repr, blame, failure};
use calyx_lang::ir::{Expr, ExprKind, ExternId, FormatPart, Op, SiteId};
use calyx_lang::span::Span;

impl<'p> Machine<'_, 'p> {
    /// Evaluates an expression onto the stack.
    pub(super) fn eval(&mut self, expr: &'p Expr) -> Result<(), RuntimeError> {
        match &expr.kind {
            ExprKind::Number(value) => {
                let mut slot = value.to_bits();
                self.trace(|trace| trace.literal(&mut slot, expr.span));
                self.stack.push(slot);
            }
            ExprKind::Bool(value) => self.stack.push(u64::from(*value)),
            ExprKind::String(text) => {
                let id = helpers::new_string(self.ctx, text)?;
                self.stack.push(id);
            }
            ExprKind::Local(local) => {
                let slots = self.local(*local)?;
                self.stack.extend_from_within(slots);
            }
            ExprKind::Param(index) => self.param(expr, *index)?,
            ExprKind::Op(op, operands) => self.operation(expr, *op, operands)?,
            ExprKind::And(a, b) => {
                let a = self.slot(a)?;
                let value = if a == 0 { 0 } else { self.slot(b)? };
                self.stack.push(value);
            }
            ExprKind::Or(a, b) => {
                let a = self.slot(a)?;
                let value = if a != 0 { 1 } else { self.slot(b)? };
                self.stack.push(value);
            }
            ExprKind::If(condition, then, otherwise) => {
                let branch = if self.slot(condition)? != 0 { then } else { otherwise };
                self.eval(branch)?;
            }
            ExprKind::Call(callee, arguments) => {
                let start = self.eval_all(arguments)?;
                self.call_at(*callee, start, expr.span)?;
            }
            ExprKind::CallExtern(id, arguments) => {
                let start = self.eval_all(arguments)?;
                self.call_extern(*id, arguments, start, expr)?;
            }
            ExprKind::Array(elements) => {
                let start = self.eval_all(elements)?;
                let slots = self.stack.split_off(start);
                let id = helpers::new_array(self.ctx, stride(&expr.repr), slots)?;
                self.stack.push(id);
            }
            ExprKind::Index(array, index) => {
                let array = self.slot(array)?;
                let value = self.number(index)?;
                self.at(index.span);
                let element = helpers::element(self.ctx, array, value)?;
                self.stack.extend_from_slice(element);
            }
            ExprKind::Tuple(elements) => {
                self.eval_all(elements)?;
            }
            ExprKind::TupleElement(tuple, index) => self.tuple_element(expr, tuple, *index)?,
            ExprKind::Copy(value) => {
                let start = self.stack.len();
                self.eval(value)?;
                self.at(expr.span);
                helpers::copy(self.ctx, &value.repr, &mut self.stack[start..])?;
            }
            ExprKind::Len(array) => {
                let array = self.slot(array)?;
                self.at(expr.span);
                let length = helpers::array_length(self.ctx, array)?;
                self.stack.push(length.to_bits());
            }
            ExprKind::Format(parts) => self.format(parts, expr.span)?,
            ExprKind::Catch => {
                let caught = failure::catch(self.ctx)?;
                self.stack.push(caught);
            }
            ExprKind::CaughtFields(caught) => {
                let caught = self.slot(caught)?;
                self.stack.extend(failure::fields(self.ctx, caught)?);
            }
            ExprKind::MakeSymbolic { site, captures } => {
                let start = self.eval_all(captures)?;
                self.make_symbolic(*site, start, expr.span)?;
            }
            ExprKind::EvalSymbolic { value, time } => self.eval_symbolic(expr, value, time)?,
        }
        Ok(())
    }

    fn param(&mut self, expr: &'p Expr, index: u32) -> Result<(), RuntimeError> {
        let offsets = &self.interpreter.param_offsets;
        let offset = *offsets.get(index as usize).ok_or_else(|| malformed("a param that is not there"))?;
        let start = self.reserve(expr.repr.slots());
        self.at(expr.span);
        helpers::param(self.ctx, offset, &mut self.stack[start..])
    }

    fn tuple_element(&mut self, expr: &'p Expr, tuple: &'p Expr, index: usize) -> Result<(), RuntimeError> {
        let start = self.stack.len();
        if let Some(range) = self.stored(expr)? {
            self.stack.extend_from_within(range);
            return Ok(());
        }
        self.eval(tuple)?;
        let before = tuple_offset(&tuple.repr, index).ok_or_else(|| malformed("not a tuple"))?;
        self.stack.copy_within(start + before..start + before + expr.repr.slots(), start);
        self.stack.truncate(start + expr.repr.slots());
        Ok(())
    }

    fn eval_symbolic(&mut self, expr: &'p Expr, value: &'p Expr, time: &'p Expr) -> Result<(), RuntimeError> {
        if let (ExprKind::MakeSymbolic { site, captures }, None) = (&value.kind, &self.interpreter.trace) {
            return self.evaluate_site(expr, *site, captures, time);
        }
        let value = self.slot(value)?;
        let time = self.number(time)?;
        let start = self.reserve(expr.repr.slots());
        self.at(expr.span);
        helpers::eval_symbolic(self.ctx, value, time, &expr.repr, &mut self.stack[start..])?;
        self.trace_symbolic(value, time, start);
        Ok(())
    }

    /// Evaluates a site without a symbolic value. Tracing needs the symbolic value.
    fn evaluate_site(
        &mut self,
        expr: &'p Expr,
        id: SiteId,
        captures: &'p [Expr],
        time: &'p Expr,
    ) -> Result<(), RuntimeError> {
        let (site, captured) = self.interpreter.site(id)?;
        let start = self.eval_all(captures)?;
        let time = self.number(time)?;
        let end = self.reserve(expr.repr.slots());
        self.at(expr.span);
        let plain = captured.is_plain && captured.is_numbers && site.repr == expr.repr;
        let reprs = if plain { None } else { Some((&site.repr, &expr.repr)) };
        let (slots, result) = self.stack.split_at_mut(end);
        let captures = (&captured.kinds[..], &slots[start..]);
        if captures.0.len() != captures.1.len() {
            return Err(malformed("a symbolic value with other captures"));
        }
        helpers::evaluate_site(self.ctx, id.0 as usize, captures, time, reprs, result)?;
        self.stack.drain(start..end);
        Ok(())
    }

    /// Evaluates expressions in order and returns the start of their slots.
    fn eval_all(&mut self, parts: &'p [Expr]) -> Result<usize, RuntimeError> {
        let start = self.stack.len();
        for part in parts {
            self.eval(part)?;
        }
        Ok(start)
    }

    /// Reserves slots on the stack and returns their start.
    fn reserve(&mut self, slots: usize) -> usize {
        let start = self.stack.len();
        self.stack.resize(start + slots, 0);
        start
    }

    fn operation(&mut self, expr: &Expr, op: Op, operands: &'p [Expr]) -> Result<(), RuntimeError> {
        if let Some((string, text)) = compared_text(op, operands) {
            let string = self.slot(string)?;
            self.at(expr.span);
            let equal = helpers::has_text(self.ctx, string, text)?;
            self.stack.push(u64::from(equal == (op == Op::Equal)));
            return Ok(());
        }
        let start = self.eval_all(operands)?;
        let operands_repr = operands.first().map_or(&Repr::Unit, |operand| &operand.repr);
        let equality = matches!(op, Op::Equal | Op::NotEqual);
        if is_scalar(op) && !equality && self.interpreter.trace.is_none() {
            let result = SlotScalars.apply(op, &self.stack[start..]);
            self.stack.truncate(start);
            self.stack.push(result.ok_or_else(|| malformed("an operation without operands"))?);
            return Ok(());
        }
        let result = if equality && !matches!(operands_repr, Repr::Number | Repr::Vector) {
            self.at(expr.span);
            let (a, b) = self.stack[start..].split_at(operands_repr.slots());
            vec![u64::from(helpers::equal(self.ctx, operands_repr, a, b)? == (op == Op::Equal))]
        } else if is_scalar(op) && !(equality && *operands_repr == Repr::Vector) {
            let result = SlotScalars.apply(op, &self.stack[start..]);
            vec![result.ok_or_else(|| malformed("an operation without operands"))?]
        } else {
            expand(&mut SlotScalars, op, &self.stack[start..])
                .ok_or_else(|| malformed("an operation on other operands"))?
        };
        let mut result = result;
        self.trace(|trace| trace.operation(op, &self.stack[start..], &mut result, expr.span));
        self.stack.truncate(start);
        self.stack.extend(result);
        Ok(())
    }

    fn call_extern(
        &mut self,
        id: ExternId,
        arguments: &[Expr],
        start: usize,
        call: &Expr,
    ) -> Result<(), RuntimeError> {
        let (result, span) = (&call.repr, call.span);
        let row = *self
            .interpreter
            .externs
            .get(id.0 as usize)
            .ok_or_else(|| malformed("a provided function that is not there"))?;
        self.at(span);
        if !allowed(row.purity, self.interpreter.allow) {
            let zero = helpers::zero_value(self.ctx, result);
            self.stack.truncate(start);
            self.stack.extend(zero);
            return Ok(());
        }
        if self.is_poisoned(id, start) {
            self.put_poison(result, start);
            return Ok(());
        }
        self.trace(|trace| trace.call(self.extern_parameters(id), &self.stack[start..], &self.ctx.heap));
        let mut slots = vec![0; result.slots()];
        if let Err(mut error) = helpers::call_extern(row, self.ctx, &self.stack[start..], &mut slots) {
            if let Some(declaration) = self.interpreter.program.externs.get(id.0 as usize) {
                blame::blame(&mut error, &blame_table(declaration, arguments, span));
            }
            self.survive(error)?;
            self.put_poison(result, start);
            return Ok(());
        }
        self.stack.truncate(start);
        self.stack.extend(slots);
        Ok(())
    }

    /// Evaluates all values before joining them: a value may itself build a string.
    fn format(&mut self, parts: &'p [FormatPart], span: Span) -> Result<(), RuntimeError> {
        let start = self.stack.len();
        for part in parts {
            if let FormatPart::Value(value, _) = part {
                self.eval(value)?;
            }
        }
        self.at(span);
        let mut at = start;
        for part in parts {
            match part {
                FormatPart::Text(text) => helpers::append_text(self.ctx, text)?,
                FormatPart::Value(value, display) => {
                    let end = at + value.repr.slots();
                    helpers::append_value(self.ctx, &value.repr, &self.stack[at..end], display)?;
                    at = end;
                }
            }
        }
        let id = helpers::finish_text(self.ctx)?;
        self.stack.truncate(start);
        self.stack.push(id);
        Ok(())
    }

    fn make_symbolic(&mut self, id: SiteId, start: usize, span: Span) -> Result<(), RuntimeError> {
        let (site, Captured { kinds, .. }) = self.interpreter.site(id)?;
        self.at(span);
        self.trace(|trace| trace.capture(id, &self.stack[start..]));
        let id =
            helpers::make_symbolic(self.ctx, id.0 as usize, site.repr.clone(), kinds, &self.stack[start..])?;
        self.stack.truncate(start);
        self.stack.push(id);
        Ok(())
    }
}

/// Returns `true` if a function of this purity may be called under the given limit.
fn allowed(purity: Purity, limit: Purity) -> bool {
    match limit {
        Purity::Pure => purity == Purity::Pure,
        Purity::Scene => purity != Purity::Effect,
        Purity::Effect => true,
    }
}
