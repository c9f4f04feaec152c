//! Blocks, statements and places.

use crate::error::CodegenError;
use crate::function::{FunctionLowering, SLOT, TRUSTED, slot_types};
use calyx_lang::ir::{Block, Mode, Place, Statement, Terminator};
use calyx_lower::layout::passed;
use cranelift_codegen::ir::{InstBuilder, Value, types};
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

    /// The values of a place's indices, with no check yet.
    fn indices(&mut self, place: &'m Place) -> Result<Vec<Value>, CodegenError> {
        place.indices.iter().map(|index| self.scalar(index)).collect()
    }

    fn store(&mut self, place: &Place, indices: &[Value], values: &[Value]) -> Result<(), CodegenError> {
        let Some((&last, outer)) = indices.split_last() else {
            return self.assign_local(place.local, values);
        };
        let array = self.array_in(place, outer)?;
        self.at(place.indices[outer.len()].span);
        let element = self.element(array, last)?;
        for (slot, &value) in values.iter().enumerate() {
            self.builder.ins().store(TRUSTED, value, element, (slot * SLOT) as i32);
        }
        Ok(())
    }

    /// Follows indices from the array a local holds to the array inside.
    fn array_in(&mut self, place: &Place, indices: &[Value]) -> Result<Value, CodegenError> {
        let slots = self.local(place.local)?;
        let mut array = *slots.first().ok_or(CodegenError::Malformed("a place that is no array"))?;
        for (position, &index) in indices.iter().enumerate() {
            self.at(place.indices[position].span);
            let element = self.element(array, index)?;
            array = self.builder.ins().load(types::I64, TRUSTED, element, 0);
        }
        Ok(array)
    }

    /// Address of an element of an array, valid until the next call.
    pub fn element(&mut self, array: Value, index: Value) -> Result<Value, CodegenError> {
        let index = self.bits(index);
        let into = self.buffer_address(0);
        self.helper("calyx_array_element", &[array, index, into])?;
        Ok(self.load_buffer(0, &[types::I64])[0])
    }
}
