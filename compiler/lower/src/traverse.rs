//! Traversal of all expressions of a function, and properties derived from it.

use calyx_lang::ir::{
    Expr, ExprKind, FormatPart, Function, FunctionId, Place, Program, Statement, Terminator,
};

/// Returns `true` if a function without parameters always returns the same value, for all params.
/// Such a function and its callees read no param and nothing that the engine or an embedding
/// program provides.
pub fn is_constant(program: &Program, function: FunctionId) -> bool {
    let (mut waiting, mut known) = (vec![function], vec![function]);
    let mut constant = true;
    while let Some(id) = waiting.pop() {
        let Some(function) = program.functions.get(id.0 as usize) else { return false };
        let mut call = |called: FunctionId| {
            if !known.contains(&called) {
                known.push(called);
                waiting.push(called);
            }
        };
        for_each_expression(function, &mut |expr| match &expr.kind {
            ExprKind::Param(_)
            | ExprKind::CallExtern(..)
            | ExprKind::MakeSymbolic { .. }
            | ExprKind::EvalSymbolic { .. } => constant = false,
            ExprKind::Call(called, _) => call(*called),
            _ => {}
        });
        for statement in function.blocks.iter().flat_map(|block| &block.statements) {
            match statement {
                Statement::Call { function: called, .. } => call(*called),
                // Each instance may receive a different value.
                Statement::Host { .. } => constant = false,
                _ => {}
            }
        }
        if !constant {
            return false;
        }
    }
    true
}

/// Visits every expression of a function, including subexpressions.
pub fn for_each_expression<'p>(function: &'p Function, visit: &mut dyn FnMut(&'p Expr)) {
    for block in &function.blocks {
        for statement in &block.statements {
            match statement {
                Statement::Assign { place, value, .. } | Statement::Push { place, value, .. } => {
                    in_place(place, visit);
                    for_each_part(value, visit);
                }
                Statement::Host { arguments, .. } => {
                    arguments.iter().for_each(|argument| for_each_part(argument, visit));
                }
                Statement::Eval(value) => for_each_part(value, visit),
                Statement::Call { result, arguments, copy_back, .. } => {
                    arguments.iter().for_each(|argument| for_each_part(argument, visit));
                    result.iter().chain(copy_back).for_each(|place| in_place(place, visit));
                }
            }
        }
        match &block.terminator {
            Terminator::Branch { condition: value, .. }
            | Terminator::Return(Some(value))
            | Terminator::Throw { error: value, .. }
            | Terminator::Rethrow(value) => {
                for_each_part(value, visit);
            }
            Terminator::Jump(_) | Terminator::Return(None) => {}
        }
    }
}

fn in_place<'p>(place: &'p Place, visit: &mut dyn FnMut(&'p Expr)) {
    place.indices().for_each(|index| for_each_part(index, visit));
}

/// Visits an expression and all its subexpressions.
pub fn for_each_part<'p>(expr: &'p Expr, visit: &mut dyn FnMut(&'p Expr)) {
    visit(expr);
    let mut each = |parts: &'p [Expr]| parts.iter().for_each(|part| for_each_part(part, visit));
    match &expr.kind {
        ExprKind::Number(_)
        | ExprKind::Bool(_)
        | ExprKind::String(_)
        | ExprKind::Local(_)
        | ExprKind::Param(_)
        | ExprKind::Catch => {}
        ExprKind::Op(_, parts)
        | ExprKind::Call(_, parts)
        | ExprKind::CallExtern(_, parts)
        | ExprKind::Array(parts)
        | ExprKind::Tuple(parts)
        | ExprKind::MakeSymbolic { captures: parts, .. } => each(parts),
        ExprKind::And(a, b) | ExprKind::Or(a, b) | ExprKind::Index(a, b) => {
            each(std::slice::from_ref(a));
            each(std::slice::from_ref(b));
        }
        ExprKind::EvalSymbolic { value, time } => {
            each(std::slice::from_ref(value));
            each(std::slice::from_ref(time));
        }
        ExprKind::If(condition, then, otherwise) => {
            for part in [condition, then, otherwise] {
                each(std::slice::from_ref(part));
            }
        }
        ExprKind::TupleElement(part, _)
        | ExprKind::Copy(part)
        | ExprKind::Len(part)
        | ExprKind::CaughtFields(part) => {
            each(std::slice::from_ref(part));
        }
        ExprKind::Format(parts) => {
            for part in parts {
                if let FormatPart::Value(value, _) = part {
                    each(std::slice::from_ref(value));
                }
            }
        }
    }
}
