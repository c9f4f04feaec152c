//! From the name of an argument to the place where it was written.

use crate::traverse::for_each_expression;
use calyx_abi::RuntimeError;
use calyx_abi::description::CallDescription;
use calyx_lang::ir::{Expr, ExprKind, Program};
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
        let mut visit = |call: &Expr| {
            let ExprKind::CallExtern(id, arguments) = &call.kind else { return };
            let Some(declaration) = program.externs.get(id.0 as usize) else { return };
            let (file, start, end) = range(call);
            // A default's text stands in the declaration, outside of the call: such an argument has no place.
            let written = |at: &Range| at.0 == file && at.1 >= start && at.2 <= end;
            let pairs = declaration.parameters.iter().zip(arguments);
            let pairs = pairs.map(|((name, _), argument)| (name.clone(), range(argument)));
            let pairs = pairs.filter(|(_, at)| written(at)).collect();
            sites.arguments.insert((file, start, end), pairs);
        };
        program.functions.iter().for_each(|function| for_each_expression(function, &mut visit));
        sites
    }

    /// The same for those who have no compiler, in order of place.
    pub fn describe(&self) -> Vec<CallDescription> {
        let calls = self.arguments.iter().filter(|(_, arguments)| !arguments.is_empty());
        let described =
            calls.map(|(&place, arguments)| CallDescription { place, arguments: arguments.clone() });
        let mut described: Vec<_> = described.collect();
        described.sort_by_key(|call| call.place);
        described
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
