//! Blocks and statements.

use super::Machine;
use crate::layout::passed;
use calyx_abi::context::RuntimeError;
use calyx_abi::{Slot, helpers};
use calyx_lang::ir::{Expr, Statement, Terminator};

impl<'p> Machine<'_, 'p> {
    /// Runs from block 0 to a return, and leaves the result's slots on top of the stack.
    pub(super) fn run_blocks(&mut self) -> Result<(), RuntimeError> {
        let mut block = 0;
        let blocks = &self.activation.function.blocks;
        loop {
            helpers::enter_block(self.ctx)?;
            let Some(current) = blocks.get(block) else {
                return Err(helpers::malformed("a block that is not there"));
            };
            for statement in &current.statements {
                self.statement(statement)?;
            }
            block = match &current.terminator {
                Terminator::Jump(target) => target.0 as usize,
                Terminator::Branch { condition, then, otherwise } => {
                    let target = if self.truth(condition)? { then } else { otherwise };
                    target.0 as usize
                }
                Terminator::Return(value) => {
                    if let Some(value) = value {
                        self.eval(value)?;
                    }
                    return Ok(());
                }
            };
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
                self.at(*span);
                self.call(*callee, start)?;
                let skipped = if result.is_none() { target.result.slots() } else { 0 };
                let mut at = start + skipped;
                for (place, indices) in places.iter().zip(&indices) {
                    self.store(place, indices, at)?;
                    at += place.repr.slots();
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

    /// Evaluates an expression of one slot.
    pub(super) fn slot(&mut self, expr: &'p Expr) -> Result<Slot, RuntimeError> {
        self.eval(expr)?;
        self.stack.pop().ok_or_else(|| helpers::malformed("an expression without value"))
    }
}
