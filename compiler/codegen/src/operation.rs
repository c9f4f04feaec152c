//! Lowers one operation of a tape to instructions, on one number or on two SIMD lanes.
//!
//! `+ - * /`, negation, square root, absolute value, minimum, maximum, comparisons and selection
//! are instructions with exactly the semantics of [`calyx_abi::math`], for two lanes as for one.
//! The other operations are calls of these functions, lane by lane.

use crate::error::CodegenError;
use crate::module::ModuleLowering;
use calyx_symbolic::Instruction;
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{FuncRef, InstBuilder, MemFlagsData, Type, Value, types};
use cranelift_frontend::FunctionBuilder;
use cranelift_module::Module;
use std::collections::HashMap;

/// Functions that the function under construction references so far.
pub type References = HashMap<&'static str, FuncRef>;

/// Returns the link symbol of an operation that is a call.
fn symbol(instruction: Instruction) -> Option<&'static str> {
    use Instruction as I;
    Some(match instruction {
        I::Sin(_) => "calyx_math_sin",
        I::Cos(_) => "calyx_math_cos",
        I::Tan(_) => "calyx_math_tan",
        I::Asin(_) => "calyx_math_asin",
        I::Acos(_) => "calyx_math_acos",
        I::Atan(_) => "calyx_math_atan",
        I::Exp(_) => "calyx_math_exp",
        I::Log(_) => "calyx_math_log",
        I::Floor(_) => "calyx_math_floor",
        I::Ceil(_) => "calyx_math_ceil",
        I::Round(_) => "calyx_math_round",
        I::Power(..) => "calyx_math_pow",
        I::Atan2(..) => "calyx_math_atan2",
        _ => return None,
    })
}

/// Returns a reference to the function with a symbol, for calls from the function under
/// construction.
pub fn reference<M: Module>(
    module: &mut ModuleLowering<M>,
    builder: &mut FunctionBuilder,
    references: &mut References,
    symbol: &'static str,
) -> Result<FuncRef, CodegenError> {
    if let Some(reference) = references.get(symbol) {
        return Ok(*reference);
    }
    let id = module.import(symbol)?;
    let reference = module.module.declare_func_in_func(id, builder.func);
    references.insert(symbol, reference);
    Ok(reference)
}

/// Returns the value of a table at an operand of type `ty`, `F64` or `F64X2`. The table is constant
/// data of the module.
pub fn piecewise<M: Module>(
    module: &mut ModuleLowering<M>,
    builder: &mut FunctionBuilder,
    references: &mut References,
    (ty, table): (Type, &[f64]),
    x: Value,
) -> Result<Value, CodegenError> {
    let bytes: Vec<u8> = table.iter().flat_map(|number| number.to_ne_bytes()).collect();
    let data = module.constant(&bytes)?;
    let data = module.module.declare_data_in_func(data, builder.func);
    let address = builder.ins().symbol_value(types::I64, data);
    let function = reference(module, builder, references, "calyx_math_piecewise")?;
    if ty == types::F64 {
        return call(builder, function, &[address, x]);
    }
    let mut lane = |lane: u8| {
        let x = builder.ins().extractlane(x, lane);
        call(builder, function, &[address, x])
    };
    let (first, second) = (lane(0)?, lane(1)?);
    let both = builder.ins().splat(types::F64X2, first);
    Ok(builder.ins().insertlane(both, second, 1))
}

/// Returns the value of a registered table at operands of type `ty`, `F64` or `F64X2`: its number
/// and the argument.
pub fn lookup<M: Module>(
    module: &mut ModuleLowering<M>,
    builder: &mut FunctionBuilder,
    references: &mut References,
    (ty, order): (Type, u8),
    [table, x]: [Value; 2],
) -> Result<Value, CodegenError> {
    let function = reference(module, builder, references, "calyx_math_spline")?;
    let order = builder.ins().f64const(f64::from(order));
    if ty == types::F64 {
        return call(builder, function, &[table, order, x]);
    }
    let mut lane = |lane: u8| {
        let [table, x] = [table, x].map(|operand| builder.ins().extractlane(operand, lane));
        call(builder, function, &[table, order, x])
    };
    let (first, second) = (lane(0)?, lane(1)?);
    let both = builder.ins().splat(types::F64X2, first);
    Ok(builder.ins().insertlane(both, second, 1))
}

/// Returns the value of an operation on operands of type `ty`, `F64` or `F64X2`. Constants and
/// inputs are not operations.
pub fn lower<M: Module>(
    module: &mut ModuleLowering<M>,
    builder: &mut FunctionBuilder,
    references: &mut References,
    ty: Type,
    instruction: Instruction,
    operands: &[Value],
) -> Result<Value, CodegenError> {
    if let Some(symbol) = symbol(instruction) {
        let function = reference(module, builder, references, symbol)?;
        return if ty == types::F64 {
            call(builder, function, operands)
        } else {
            call_in_lanes(builder, function, operands)
        };
    }
    arithmetic(builder, ty, instruction, operands)
        .ok_or(CodegenError::Malformed("an operation without operands"))
}

fn arithmetic(
    builder: &mut FunctionBuilder,
    ty: Type,
    instruction: Instruction,
    operands: &[Value],
) -> Option<Value> {
    use Instruction as I;
    let &first = operands.first()?;
    // Operations with one operand ignore the others.
    let second = operands.get(1).copied().unwrap_or(first);
    let third = operands.get(2).copied().unwrap_or(first);
    let compare = |builder: &mut FunctionBuilder, condition| builder.ins().fcmp(condition, first, second);
    Some(match instruction {
        I::Negate(_) => builder.ins().fneg(first),
        I::Abs(_) => builder.ins().fabs(first),
        I::Sqrt(_) => builder.ins().sqrt(first),
        I::Add(..) => builder.ins().fadd(first, second),
        I::Subtract(..) => builder.ins().fsub(first, second),
        I::Multiply(..) => builder.ins().fmul(first, second),
        I::Divide(..) => builder.ins().fdiv(first, second),
        I::Min(..) => builder.ins().fmin(first, second),
        I::Max(..) => builder.ins().fmax(first, second),
        I::Less(..) => {
            let holds = compare(builder, FloatCC::LessThan);
            truth(builder, ty, holds)
        }
        I::LessEqual(..) => {
            let holds = compare(builder, FloatCC::LessThanOrEqual);
            truth(builder, ty, holds)
        }
        I::Equal(..) => {
            let holds = compare(builder, FloatCC::Equal);
            truth(builder, ty, holds)
        }
        I::Not(_) => {
            let zero = constant(builder, ty, 0.0);
            let fails = builder.ins().fcmp(FloatCC::Equal, first, zero);
            truth(builder, ty, fails)
        }
        I::And(..) => {
            let (a, b) = (holds(builder, ty, first), holds(builder, ty, second));
            let both = builder.ins().band(a, b);
            truth(builder, ty, both)
        }
        I::Or(..) => {
            let (a, b) = (holds(builder, ty, first), holds(builder, ty, second));
            let either = builder.ins().bor(a, b);
            truth(builder, ty, either)
        }
        I::Select(..) => {
            let holds = holds(builder, ty, first);
            choose(builder, ty, holds, second, third)
        }
        _ => return None,
    })
}

/// Returns the same number in every lane.
pub fn constant(builder: &mut FunctionBuilder, ty: Type, value: f64) -> Value {
    let number = builder.ins().f64const(value);
    if ty == types::F64 { number } else { builder.ins().splat(ty, number) }
}

/// Tests a truth value: it is true if it differs from zero, also if it is NaN.
fn holds(builder: &mut FunctionBuilder, ty: Type, value: Value) -> Value {
    let zero = constant(builder, ty, 0.0);
    builder.ins().fcmp(FloatCC::NotEqual, value, zero)
}

/// Converts a condition to 1.0 or 0.0.
fn truth(builder: &mut FunctionBuilder, ty: Type, holds: Value) -> Value {
    let (yes, no) = (constant(builder, ty, 1.0), constant(builder, ty, 0.0));
    choose(builder, ty, holds, yes, no)
}

fn choose(builder: &mut FunctionBuilder, ty: Type, holds: Value, yes: Value, no: Value) -> Value {
    if ty == types::F64 {
        return builder.ins().select(holds, yes, no);
    }
    let mask = builder.ins().bitcast(ty, MemFlagsData::new(), holds);
    builder.ins().bitselect(mask, yes, no)
}

fn call(
    builder: &mut FunctionBuilder,
    function: FuncRef,
    arguments: &[Value],
) -> Result<Value, CodegenError> {
    let call = builder.ins().call(function, arguments);
    let result = builder.inst_results(call).first().copied();
    result.ok_or(CodegenError::Malformed("a call without result"))
}

fn call_in_lanes(
    builder: &mut FunctionBuilder,
    function: FuncRef,
    operands: &[Value],
) -> Result<Value, CodegenError> {
    let mut lane = |lane: u8| {
        let arguments: Vec<Value> =
            operands.iter().map(|&operand| builder.ins().extractlane(operand, lane)).collect();
        call(builder, function, &arguments)
    };
    let (first, second) = (lane(0)?, lane(1)?);
    let both = builder.ins().splat(types::F64X2, first);
    Ok(builder.ins().insertlane(both, second, 1))
}
