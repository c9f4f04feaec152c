//! From the name of an argument to the place where it was written.

use calyx_abi::RuntimeError;
use calyx_lang::ir::{Expr, ExprKind, FormatPart, Place, Program, Statement, Terminator};
use std::collections::HashMap;

/// Byte range `(file, start, end)`.
type Range = (u32, u32, u32);

/// Where the arguments of all calls of provided functions are written.
#[derive(Clone, Debug, Default)]
pub struct CallSites {
    /// By the place of the call: names and places of its arguments.
    arguments: HashMap<Range, Vec<(String, Range)>>,
}

impl CallSites {
    pub fn new(program: &Program) -> Self {
        let range = |expr: &Expr| (expr.span.file.0, expr.span.start, expr.span.end);
        let mut sites = CallSites::default();
        for_each_expression(program, &mut |call| {
            let ExprKind::CallExtern(id, arguments) = &call.kind else { return };
            let Some(declaration) = program.externs.get(id.0 as usize) else { return };
            let (file, start, end) = range(call);
            // A default's text stands in the declaration, outside of the call: such an argument has no place.
            let written = |at: &Range| at.0 == file && at.1 >= start && at.2 <= end;
            let pairs = declaration.parameters.iter().zip(arguments);
            let pairs = pairs.map(|((name, _), argument)| (name.clone(), range(argument)));
            let pairs = pairs.filter(|(_, at)| written(at)).collect();
            sites.arguments.insert((file, start, end), pairs);
        });
        sites
    }

    /// If the error blames an argument of the call at its place, moves the place to that argument.
    /// Arguments left to their default keep the place of the call.
    pub fn blame(&self, error: &mut RuntimeError) {
        let arguments = error.place.and_then(|place| self.arguments.get(&place));
        if let (Some(arguments), Some(name)) = (arguments, &error.argument)
            && let Some((_, place)) = arguments.iter().find(|(argument, _)| argument == name)
        {
            error.place = Some(*place);
        }
    }
}

fn for_each_expression<'p>(program: &'p Program, visit: &mut dyn FnMut(&'p Expr)) {
    for block in program.functions.iter().flat_map(|function| &function.blocks) {
        for statement in &block.statements {
            match statement {
                Statement::Assign { place, value, .. } | Statement::Push { place, value, .. } => {
                    in_place(place, visit);
                    in_expression(value, visit);
                }
                Statement::Eval(value) => in_expression(value, visit),
                Statement::Call { result, arguments, copy_back, .. } => {
                    arguments.iter().for_each(|argument| in_expression(argument, visit));
                    result.iter().chain(copy_back).for_each(|place| in_place(place, visit));
                }
            }
        }
        match &block.terminator {
            Terminator::Branch { condition: value, .. }
            | Terminator::Return(Some(value))
            | Terminator::Throw { error: value, .. }
            | Terminator::Rethrow(value) => {
                in_expression(value, visit);
            }
            Terminator::Jump(_) | Terminator::Return(None) => {}
        }
    }
}

fn in_place<'p>(place: &'p Place, visit: &mut dyn FnMut(&'p Expr)) {
    place.indices().for_each(|index| in_expression(index, visit));
}

fn in_expression<'p>(expr: &'p Expr, visit: &mut dyn FnMut(&'p Expr)) {
    visit(expr);
    let mut each = |parts: &'p [Expr]| parts.iter().for_each(|part| in_expression(part, visit));
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
