//! Lowers blocks and statements.

use crate::error::CodegenError;
use crate::function::{FunctionLowering, slot_types};
use calyx_abi::failure::ERROR_SLOTS;
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
                let target = self.target(*target)?;
                self.builder.ins().jump(target, &[]);
            }
            Terminator::Branch { condition, then, otherwise } => {
                let condition = self.scalar(condition)?;
                let (then, otherwise) = (self.target(*then)?, self.target(*otherwise)?);
                self.builder.ins().brif(condition, then, &[], otherwise, &[]);
            }
            Terminator::Return(value) => {
                let values = value.as_ref().map(|value| self.expression(value)).transpose()?;
                self.return_values(values.unwrap_or_default())?;
            }
            Terminator::Throw { error, help, span } => {
                let fields = self.expression(error)?;
                if fields.len() != ERROR_SLOTS {
                    return Err(CodegenError::Malformed("an error of another form"));
                }
                self.at(*span);
                self.store_buffer(0, &fields);
                let address = self.buffer_address(0);
                let [help, length] = self.constant(help.as_bytes())?;
                let status = self.helper_status("calyx_throw", &[address, help, length])?;
                self.fail(status);
            }
            Terminator::Rethrow(caught) => {
                let caught = self.scalar(caught)?;
                let status = self.helper_status("calyx_rethrow", &[caught])?;
                self.fail(status);
            }
        }
        Ok(())
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
            Statement::Host { function, arguments, result, provided, span } => {
                let arguments = self.expressions(arguments)?;
                let given = slot_types(&result.repr);
                let returned = slot_types(&provided.repr);
                // Arguments, result and status are stored one after the other.
                let (result_at, returned_at) = (arguments.len(), arguments.len() + given.len());
                self.store_buffer(0, &arguments);
                let function = self.word(function.0 as usize);
                let counts = [self.word(arguments.len()), self.word(given.len())];
                let [from, into, answer] = [0, result_at, returned_at].map(|slot| self.buffer_address(slot));
                self.at(*span);
                self.helper("calyx_host", &[function, from, counts[0], into, counts[1], answer])?;
                let values = self.load_buffer(result_at, &[given, returned].concat());
                let (given, returned) = values.split_at(returned_at - result_at);
                self.store(provided, &[], returned)?;
                self.store(result, &[], given)?;
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
                let values = self.call_function(*id, &arguments, &types, *span)?;
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
