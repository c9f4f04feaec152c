//! Blocks and statements.

use crate::error::CodegenError;
use crate::function::{FunctionLowering, slot_types};
use calyx_lang::ir::{Block, Mode, Statement, Terminator};
use calyx_lower::layout::passed;
use cranelift_codegen::ir::InstBuilder;
use cranelift_module::Module;

impl<'m, M: Module> FunctionLowering<'_, 'm, '_, M> {
    /// Lowers a basic block.
    pub fn block(&mut self, block: &'m Block) -> Result<(), CodegenError> {
        for statement in &block.statements {
            self.statement(statement)?;
        }
        match &block.terminator {
            Terminator::Jump(target) => {
                let target = self.target(target.0)?;
                self.builder.ins().jump(target, &[]);
            }
            Terminator::Branch { condition, then, otherwise } => {
                let condition = self.scalar(condition)?;
                let (then, otherwise) = (self.target(then.0)?, self.target(otherwise.0)?);
                self.builder.ins().brif(condition, then, &[], otherwise, &[]);
            }
            Terminator::Return(value) => {
                let values = value.as_ref().map(|value| self.expression(value)).transpose()?;
                self.return_values(values.unwrap_or_default())?;
            }
        }
        Ok(())
    }

    fn target(&self, block: u32) -> Result<cranelift_codegen::ir::Block, CodegenError> {
        self.blocks.get(block as usize).copied().ok_or(CodegenError::Malformed("a block that is not there"))
    }

    fn statement(&mut self, statement: &'m Statement) -> Result<(), CodegenError> {
        match statement {
            Statement::Eval(value) => {
                self.expression(value)?;
            }
            Statement::Assign { place, value, .. } => {
                let indices = self.indices(place)?;
                let values = self.expression(value)?;
                self.store(place, &indices, &values)?;
            }
            Statement::Push { place, value, .. } => {
                let indices = self.indices(place)?;
                let values = self.expression(value)?;
                let array = self.array_in(place, &indices)?;
                self.store_buffer(0, &values);
                let (address, count) = (self.buffer_address(0), self.word(values.len()));
                self.helper("calyx_array_push", &[array, address, count])?;
            }
            Statement::Call { result, function: id, arguments, copy_back, span } => {
                let functions = &self.module.program.functions;
                let callee = functions.get(id.0 as usize);
                let callee = callee.ok_or(CodegenError::Malformed("a function that is not there"))?;
                let arguments = self.expressions(passed(callee, arguments))?;
                let places: Vec<_> = result.iter().chain(copy_back).collect();
                let indices =
                    places.iter().map(|place| self.indices(place)).collect::<Result<Vec<_>, _>>()?;
                let mut types = slot_types(&callee.result);
                let own = types.len();
                for (local, mode) in &callee.parameters {
                    if *mode != Mode::In {
                        let local = callee.locals.get(local.0 as usize);
                        let local = local.ok_or(CodegenError::Malformed("a parameter that is not there"))?;
                        types.extend(slot_types(&local.repr));
                    }
                }
                self.at(*span);
                let values = self.call_slots(self.module.functions[id.0 as usize], &arguments, &types)?;
                let mut rest = &values[if result.is_none() { own } else { 0 }..];
                for (place, indices) in places.iter().zip(&indices) {
                    let split = rest.split_at_checked(place.repr.slots());
                    let (values, after) =
                        split.ok_or(CodegenError::Malformed("a call with too few results"))?;
                    self.store(place, indices, values)?;
                    rest = after;
                }
            }
        }
        Ok(())
    }
}
