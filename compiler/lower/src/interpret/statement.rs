//! Lowers blocks and statements.

use super::{Activation, Machine};
use crate::layout::passed;
use calyx_abi::context::RuntimeError;
use calyx_abi::{Slot, Status, failure, helpers, host, limits};
use calyx_lang::ir::{Block, BlockId, Expr, Statement, Terminator};

impl<'p> Machine<'_, 'p> {
    /// Runs from block 0 to a return and leaves the result's slots on top of the stack.
    pub(super) fn run_blocks(&mut self) -> Result<(), RuntimeError> {
        let Activation { function, frame, base } = self.activation;
        let mut block = 0;
        loop {
            let Some(current) = function.blocks.get(block) else {
                return Err(helpers::malformed("a block that is not there"));
            };
            let guard = usize::from(current.handler.is_some());
            self.guards += guard;
            let done = self.block(current);
            self.guards -= guard;
            block = match done {
                Ok(Some(next)) => next.0 as usize,
                Ok(None) => return Ok(()),
                Err(mut error) => {
                    error.place.get_or_insert(self.ctx.place);
                    match current.handler {
                        Some(handler) if error.status() == Status::Failed => {
                            self.stack.truncate(base + frame.slots);
                            self.ctx.error = Some(error);
                            handler.0 as usize
                        }
                        _ => return Err(error),
                    }
                }
            };
        }
    }

    /// Runs one block. Returns the next block, or `None` if the function returns.
    fn block(&mut self, block: &'p Block) -> Result<Option<BlockId>, RuntimeError> {
        if !limits::enter_block(self.ctx) {
            self.at(block.span);
            limits::refuel(self.ctx)?;
            limits::enter_block(self.ctx);
        }
        for statement in &block.statements {
            self.statement(statement)?;
        }
        match &block.terminator {
            Terminator::Jump(target) => Ok(Some(*target)),
            Terminator::Branch { condition, then, otherwise } => {
                Ok(Some(if self.truth(condition)? { *then } else { *otherwise }))
            }
            Terminator::Return(value) => {
                if let Some(value) = value {
                    self.eval(value)?;
                }
                Ok(None)
            }
            Terminator::Throw { error, help, span } => {
                let start = self.stack.len();
                self.eval(error)?;
                self.at(*span);
                Err(failure::thrown(self.ctx, &self.stack[start..], help))
            }
            Terminator::Rethrow(caught) => {
                let caught = self.slot(caught)?;
                Err(failure::rethrown(self.ctx, caught))
            }
        }
    }

    fn statement(&mut self, statement: &'p Statement) -> Result<(), RuntimeError> {
        let bottom = self.stack.len();
        match statement {
            Statement::Eval(value) => self.eval(value)?,
            Statement::Assign { place, value, .. } => {
                let indices = self.indices(place)?;
                let start = self.stack.len();
                self.eval(value)?;
                self.store(place, &indices, start)?;
            }
            Statement::Push { place, value, .. } => {
                let indices = self.indices(place)?;
                let start = self.stack.len();
                self.eval(value)?;
                let element = self.stack.split_off(start);
                let array = self.array_in(place, &indices)?;
                helpers::push(self.ctx, array, &element)?;
            }
            Statement::Call { result, function: callee, arguments, copy_back, span } => {
                let start = self.stack.len();
                let (target, _) = self.interpreter.function(*callee)?;
                for argument in passed(target, arguments) {
                    self.eval(argument)?;
                }
                let places: Vec<_> = result.iter().chain(copy_back).collect();
                let indices = places.iter().map(|place| self.indices(place));
                let indices = indices.collect::<Result<Vec<_>, _>>()?;
                self.call_at(*callee, start, *span)?;
                let skipped = if result.is_none() { target.result.slots() } else { 0 };
                let mut at = start + skipped;
                for (place, indices) in places.iter().zip(&indices) {
                    self.store(place, indices, at)?;
                    at += place.repr.slots();
                }
            }
            Statement::Host { function, arguments, result, provided, span } => {
                for argument in arguments {
                    self.eval(argument)?;
                }
                let arguments = self.stack.split_off(bottom);
                self.at(*span);
                let mut given = vec![0; result.repr.slots()];
                let called = host::ask(self.ctx, function.0 as usize, &arguments, &mut given)?;
                self.stack.push(u64::from(called));
                self.stack.extend(given);
                self.store(provided, &[], bottom)?;
                if called {
                    self.store(result, &[], bottom + 1)?;
                }
            }
        }
        self.stack.truncate(bottom);
        Ok(())
    }

    fn truth(&mut self, expr: &'p Expr) -> Result<bool, RuntimeError> {
        Ok(self.slot(expr)? != 0)
    }

    pub(super) fn number(&mut self, expr: &'p Expr) -> Result<f64, RuntimeError> {
        Ok(f64::from_bits(self.slot(expr)?))
    }

    /// Evaluates an expression that occupies one slot.
    pub(super) fn slot(&mut self, expr: &'p Expr) -> Result<Slot, RuntimeError> {
        self.eval(expr)?;
        self.stack.pop().ok_or_else(|| helpers::malformed("an expression without value"))
    }
}
