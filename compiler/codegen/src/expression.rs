//! Lowers expressions to the values of their slots.

use crate::error::CodegenError;
use crate::function::{FunctionLowering, slot_types};
use calyx_abi::helpers::CaptureKind;
use calyx_abi::{Repr, repr_code};
use calyx_lang::ir::{Expr, ExprKind, ExternId, FormatPart, Op, SiteId};
use calyx_lower::layout::{blame_table, stride, tuple_offset};
use calyx_lower::operations::{Scalars, compared_text, expand, is_scalar};
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::{BlockArg, InstBuilder, Type, Value, types};
use cranelift_module::Module;

type Values = Result<Vec<Value>, CodegenError>;

impl<'m, M: Module> FunctionLowering<'_, 'm, '_, M> {
    /// Returns the slots of an expression.
    pub fn expression(&mut self, expr: &'m Expr) -> Values {
        Ok(match &expr.kind {
            ExprKind::Number(value) => vec![self.number(*value)],
            ExprKind::Bool(value) => vec![self.word(usize::from(*value))],
            ExprKind::String(text) => {
                self.text(text)?;
                self.finish_text()?
            }
            ExprKind::Local(local) => self.local(*local)?,
            ExprKind::Param(index) => self.param(expr, *index)?,
            ExprKind::Op(op, operands) => self.operation(expr, *op, operands)?,
            ExprKind::And(a, b) => {
                let a = self.scalar(a)?;
                let no = self.word(0);
                self.choose(a, &[types::I64], |f| f.expression(b), |_| Ok(vec![no]))?
            }
            ExprKind::Or(a, b) => {
                let a = self.scalar(a)?;
                let yes = self.word(1);
                self.choose(a, &[types::I64], |_| Ok(vec![yes]), |f| f.expression(b))?
            }
            ExprKind::If(condition, then, otherwise) => {
                let condition = self.scalar(condition)?;
                let types = slot_types(&expr.repr);
                self.choose(condition, &types, |f| f.expression(then), |f| f.expression(otherwise))?
            }
            ExprKind::Call(id, arguments) => {
                let arguments = self.expressions(arguments)?;
                self.call_function(*id, &arguments, &slot_types(&expr.repr), expr.span)?
            }
            ExprKind::CallExtern(id, arguments) => self.call_extern(expr, *id, arguments)?,
            ExprKind::Array(elements) => self.array(expr, elements)?,
            ExprKind::Index(array, index) => {
                let array = self.scalar(array)?;
                let value = self.scalar(index)?;
                self.at(index.span);
                let element = self.element("calyx_array_element", array, value)?;
                self.load_slots(element, 0, &slot_types(&expr.repr))
            }
            ExprKind::Tuple(elements) => self.expressions(elements)?,
            ExprKind::TupleElement(tuple, index) => {
                let values = self.expression(tuple)?;
                let slots = tuple_offset(&tuple.repr, *index)
                    .and_then(|before| values.get(before..before + expr.repr.slots()));
                slots.ok_or(CodegenError::Malformed("an element of what is no tuple"))?.to_vec()
            }
            ExprKind::Copy(value) => self.copy(expr, value)?,
            ExprKind::Len(array) => {
                let array = self.scalar(array)?;
                self.at(expr.span);
                self.helper_into(&[types::F64], |f, into| f.helper("calyx_array_length", &[array, into]))?
            }
            ExprKind::Format(parts) => {
                let mut values = Vec::new();
                for part in parts {
                    if let FormatPart::Value(value, _) = part {
                        values.push(self.expression(value)?);
                    }
                }
                self.at(expr.span);
                self.format(parts, values)?
            }
            ExprKind::Catch => self.helper_into(&[types::I64], |f, into| f.helper("calyx_catch", &[into]))?,
            ExprKind::CaughtFields(caught) => {
                let caught = self.scalar(caught)?;
                let types = slot_types(&expr.repr);
                self.helper_into(&types, |f, into| f.helper("calyx_caught", &[caught, into]))?
            }
            ExprKind::MakeSymbolic { site, captures } => {
                let captures = self.expressions(captures)?;
                self.at(expr.span);
                self.make_symbolic(*site, &captures)?
            }
            ExprKind::EvalSymbolic { value, time } => self.eval_symbolic(expr, value, time)?,
        })
    }

    fn param(&mut self, expr: &'m Expr, index: u32) -> Values {
        let offset = self.module.param_offsets.get(index as usize);
        let offset = *offset.ok_or(CodegenError::Malformed("a param that is not there"))?;
        let types = slot_types(&expr.repr);
        let (offset, count) = (self.word(offset), self.word(types.len()));
        self.at(expr.span);
        self.helper_into(&types, |f, into| f.helper("calyx_param", &[offset, into, count]))
    }

    fn call_extern(&mut self, expr: &'m Expr, id: ExternId, arguments: &'m [Expr]) -> Values {
        let values = self.expressions(arguments)?;
        let index = id.0 as usize;
        let declaration = self.module.program.externs.get(index);
        let (Some(&target), Some(declaration)) = (self.module.externs.get(index), declaration) else {
            return Err(CodegenError::Malformed("a provided function that is not there"));
        };
        self.at(expr.span);
        self.call_slots(target, &values, &slot_types(&expr.repr), |f| {
            let table = f.constant(&blame_table(declaration, arguments, expr.span))?;
            f.helper_status("calyx_blame", &table)
        })
    }

    fn array(&mut self, expr: &'m Expr, elements: &'m [Expr]) -> Values {
        let values = self.expressions(elements)?;
        self.store_buffer(0, &values);
        let (from, into) = (self.buffer_address(0), self.buffer_address(values.len()));
        let (stride, count) = (self.word(stride(&expr.repr)), self.word(values.len()));
        self.helper("calyx_array_new", &[stride, from, count, into])?;
        Ok(self.load_buffer(values.len(), &[types::I64]))
    }

    fn copy(&mut self, expr: &'m Expr, value: &'m Expr) -> Values {
        let values = self.expression(value)?;
        let types = slot_types(&value.repr);
        self.at(expr.span);
        self.store_buffer(0, &values);
        let [code, length] = self.constant(&repr_code::encode(&value.repr))?;
        let (address, count) = (self.buffer_address(0), self.word(values.len()));
        self.helper("calyx_copy", &[code, length, address, count])?;
        Ok(self.load_buffer(0, &types))
    }

    fn eval_symbolic(&mut self, expr: &'m Expr, value: &'m Expr, time: &'m Expr) -> Values {
        if let ExprKind::MakeSymbolic { site, captures } = &value.kind {
            let captures = self.expressions(captures)?;
            return self.evaluate_site(expr, *site, &captures, time);
        }
        let value = self.scalar(value)?;
        let time = self.scalar(time)?;
        let time = self.bits(time);
        let types = slot_types(&expr.repr);
        let count = self.word(types.len());
        let [code, length] = self.constant(&repr_code::encode(&expr.repr))?;
        self.at(expr.span);
        self.helper_into(&types, |f, into| {
            f.helper("calyx_eval_symbolic", &[value, time, code, length, into, count])
        })
    }

    /// Returns the concatenated slots of expressions.
    pub fn expressions(&mut self, parts: impl IntoIterator<Item = &'m Expr>) -> Values {
        let mut values = Vec::new();
        for part in parts {
            values.extend(self.expression(part)?);
        }
        Ok(values)
    }

    /// Returns the value of an expression that occupies one slot.
    pub fn scalar(&mut self, expr: &'m Expr) -> Result<Value, CodegenError> {
        match self.expression(expr)?[..] {
            [value] => Ok(value),
            _ => Err(CodegenError::Malformed("an expression that is no scalar")),
        }
    }

    /// Calls a helper that stores its results in the buffer.
    fn helper_into(
        &mut self,
        types: &[Type],
        call: impl FnOnce(&mut Self, Value) -> Result<(), CodegenError>,
    ) -> Values {
        let into = self.buffer_address(0);
        call(self, into)?;
        Ok(self.load_buffer(0, types))
    }

    /// Evaluates one of two branches.
    fn choose(
        &mut self,
        condition: Value,
        types: &[Type],
        then: impl FnOnce(&mut Self) -> Values,
        otherwise: impl FnOnce(&mut Self) -> Values,
    ) -> Values {
        let blocks = [self.builder.create_block(), self.builder.create_block()];
        let join = self.builder.create_block();
        for &ty in types {
            self.builder.append_block_param(join, ty);
        }
        self.builder.ins().brif(condition, blocks[0], &[], blocks[1], &[]);
        self.builder.switch_to_block(blocks[0]);
        let values = then(self)?;
        self.join(join, values);
        self.builder.switch_to_block(blocks[1]);
        let values = otherwise(self)?;
        self.join(join, values);
        self.builder.switch_to_block(join);
        Ok(self.builder.block_params(join).to_vec())
    }

    fn join(&mut self, join: cranelift_codegen::ir::Block, values: Vec<Value>) {
        let arguments: Vec<_> = values.into_iter().map(BlockArg::Value).collect();
        self.builder.ins().jump(join, &arguments);
    }

    fn operation(&mut self, expr: &'m Expr, op: Op, operands: &'m [Expr]) -> Values {
        if let Some((string, text)) = compared_text(op, operands) {
            let string = self.scalar(string)?;
            let [address, count] = self.constant(text.as_bytes())?;
            self.at(expr.span);
            let equal = self.helper_into(&[types::I64], |f, into| {
                f.helper("calyx_has_text", &[string, address, count, into])
            })?;
            return if op == Op::Equal {
                Ok(equal)
            } else {
                let unknown = CodegenError::Malformed("an operation on other operands");
                Ok(vec![self.apply(Op::Not, &equal).ok_or(unknown)?])
            };
        }
        let values = self.expressions(operands)?;
        let repr = operands.first().map_or(&Repr::Unit, |operand| &operand.repr);
        let unknown = CodegenError::Malformed("an operation on other operands");
        if matches!(op, Op::Equal | Op::NotEqual) && !matches!(repr, Repr::Number | Repr::Vector) {
            self.at(expr.span);
            let equal = self.equal(repr, &values)?;
            return Ok(vec![if op == Op::Equal {
                equal
            } else {
                self.apply(Op::Not, &[equal]).ok_or(unknown)?
            }]);
        }
        if is_scalar(op) && *repr != Repr::Vector {
            return Ok(vec![self.apply(op, &values).ok_or(unknown)?]);
        }
        expand(self, op, &values).ok_or(unknown)
    }

    /// Compares two values whose slots are concatenated.
    fn equal(&mut self, repr: &Repr, values: &[Value]) -> Result<Value, CodegenError> {
        if let (Repr::Bool | Repr::Handle, &[a, b]) = (repr, values) {
            let equal = self.builder.ins().icmp(IntCC::Equal, a, b);
            return Ok(self.builder.ins().uextend(types::I64, equal));
        }
        self.store_buffer(0, values);
        let [code, length] = self.constant(&repr_code::encode(repr))?;
        let (a, b) = (self.buffer_address(0), self.buffer_address(values.len() / 2));
        let (count, into) = (self.word(values.len() / 2), self.buffer_address(values.len()));
        self.helper("calyx_equal", &[code, length, a, b, count, into])?;
        Ok(self.load_buffer(values.len(), &[types::I64])[0])
    }

    /// Appends text to the string under construction.
    fn text(&mut self, text: &str) -> Result<(), CodegenError> {
        let arguments = self.constant(text.as_bytes())?;
        self.helper("calyx_text", &arguments)
    }

    fn finish_text(&mut self) -> Values {
        self.helper_into(&[types::I64], |f, into| f.helper("calyx_text_finish", &[into]))
    }

    fn format(&mut self, parts: &'m [FormatPart], values: Vec<Vec<Value>>) -> Values {
        let mut values = values.into_iter();
        for part in parts {
            match part {
                FormatPart::Text(text) => self.text(text)?,
                FormatPart::Value(expr, display) => {
                    let values = values.next().unwrap_or_default();
                    self.store_buffer(0, &values);
                    let [code, length] = self.constant(&repr_code::encode(&expr.repr))?;
                    let (address, count) = (self.buffer_address(0), self.word(values.len()));
                    let [display, display_length] = self.constant(&display.encode())?;
                    let arguments = [code, length, address, count, display, display_length];
                    self.helper("calyx_text_value", &arguments)?;
                }
            }
        }
        self.finish_text()
    }

    fn make_symbolic(&mut self, id: SiteId, captures: &[Value]) -> Values {
        let captured = self.captured(id, captures)?;
        let into = self.buffer_address(captures.len());
        self.helper("calyx_make_symbolic", &[&captured[..], &[into]].concat())?;
        Ok(self.load_buffer(captures.len(), &[types::I64]))
    }

    /// Evaluates a site without a symbolic value.
    fn evaluate_site(&mut self, expr: &'m Expr, id: SiteId, captures: &[Value], time: &'m Expr) -> Values {
        let time = self.scalar(time)?;
        let time = self.bits(time);
        self.at(expr.span);
        let captured = self.captured(id, captures)?;
        let types = slot_types(&expr.repr);
        let [code, length] = self.constant(&repr_code::encode(&expr.repr))?;
        let (into, count) = (self.buffer_address(captures.len()), self.word(types.len()));
        let result = [time, code, length, into, count];
        self.helper("calyx_evaluate_site", &[&captured[..], &result].concat())?;
        Ok(self.load_buffer(captures.len(), &types))
    }

    /// Stores captures at the start of the buffer. Returns the words that describe them: the site,
    /// its representation, the kinds of the captures, their address and number.
    fn captured(&mut self, id: SiteId, captures: &[Value]) -> Result<[Value; 6], CodegenError> {
        let site = self.module.program.sites.get(id.0 as usize);
        let site = site.ok_or(CodegenError::Malformed("a symbolic site that is not there"))?;
        let kinds = site.captures.iter();
        let kinds = kinds.flat_map(|capture| CaptureKind::of_slots(&capture.repr, capture.observable));
        let kinds: Vec<u8> = kinds.map(|kind| kind as u8).collect();
        if kinds.len() != captures.len() {
            return Err(CodegenError::Malformed("a symbolic value with other captures"));
        }
        self.store_buffer(0, captures);
        let index = self.word(id.0 as usize);
        let [code, length] = self.constant(&repr_code::encode(&site.repr))?;
        let [kinds, _] = self.constant(&kinds)?;
        Ok([index, code, length, kinds, self.buffer_address(0), self.word(captures.len())])
    }
}
