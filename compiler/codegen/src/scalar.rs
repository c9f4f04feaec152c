//! Lowers scalar operations to instructions.
//!
//! `+ - * /`, square root, absolute value, minimum, maximum and comparisons are instructions with
//! exactly the semantics of [`calyx_abi::math`]. The other operations are calls of these functions.

use crate::function::FunctionLowering;
use calyx_lang::ir::Op;
use calyx_lower::operations::Scalars;
use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::{InstBuilder, Value, types};
use cranelift_module::Module;

/// Returns the link symbol of an operation that is a call.
fn symbol(op: Op) -> Option<&'static str> {
    Some(match op {
        Op::Power => "calyx_math_pow",
        Op::Sin => "calyx_math_sin",
        Op::Cos => "calyx_math_cos",
        Op::Tan => "calyx_math_tan",
        Op::Asin => "calyx_math_asin",
        Op::Acos => "calyx_math_acos",
        Op::Atan => "calyx_math_atan",
        Op::Exp => "calyx_math_exp",
        Op::Log => "calyx_math_log",
        Op::Floor => "calyx_math_floor",
        Op::Ceil => "calyx_math_ceil",
        Op::Round => "calyx_math_round",
        Op::Atan2 => "calyx_math_atan2",
        _ => return None,
    })
}

impl<M: Module> Scalars for FunctionLowering<'_, '_, '_, M> {
    type Value = Value;

    fn number(&mut self, value: f64) -> Value {
        self.builder.ins().f64const(value)
    }

    fn apply(&mut self, op: Op, operands: &[Value]) -> Option<Value> {
        if let Some(symbol) = symbol(op) {
            let id = self.module.import(symbol).ok()?;
            let function = self.reference(id);
            let call = self.builder.ins().call(function, operands);
            return self.builder.inst_results(call).first().copied();
        }
        let &first = operands.first()?;
        // Operations with one operand ignore the second.
        let second = operands.get(1).copied().unwrap_or(first);
        let condition = match op {
            Op::Less => Some(FloatCC::LessThan),
            Op::LessEqual => Some(FloatCC::LessThanOrEqual),
            Op::Greater => Some(FloatCC::GreaterThan),
            Op::GreaterEqual => Some(FloatCC::GreaterThanOrEqual),
            Op::Equal => Some(FloatCC::Equal),
            Op::NotEqual => Some(FloatCC::NotEqual),
            _ => None,
        };
        if let Some(condition) = condition {
            let truth = self.builder.ins().fcmp(condition, first, second);
            return Some(self.builder.ins().uextend(types::I64, truth));
        }
        Some(match op {
            Op::Add => self.builder.ins().fadd(first, second),
            Op::Subtract => self.builder.ins().fsub(first, second),
            Op::Multiply => self.builder.ins().fmul(first, second),
            Op::Divide => self.builder.ins().fdiv(first, second),
            Op::Negate => self.builder.ins().fneg(first),
            Op::Sqrt => self.builder.ins().sqrt(first),
            Op::Abs => self.builder.ins().fabs(first),
            Op::Min => self.builder.ins().fmin(first, second),
            Op::Max => self.builder.ins().fmax(first, second),
            Op::Not => {
                let truth = self.builder.ins().icmp_imm_u(IntCC::Equal, first, 0);
                self.builder.ins().uextend(types::I64, truth)
            }
            _ => return None,
        })
    }

    fn both(&mut self, a: Value, b: Value) -> Value {
        self.builder.ins().band(a, b)
    }
}
