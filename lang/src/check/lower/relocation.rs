//! Converts locations of lowered code from an excerpt to files.

use crate::check::excerpt::Places;
use crate::ir::*;

pub(super) fn function(f: &mut Function, places: &Places<'_>) {
    f.span = places.span(f.span);
    for block in &mut f.blocks {
        block.statements.iter_mut().for_each(|s| statement(s, places));
        block.span = places.span(block.span);
        match &mut block.terminator {
            Terminator::Jump(_) | Terminator::Return(None) => {}
            Terminator::Branch { condition: e, .. }
            | Terminator::Return(Some(e))
            | Terminator::Rethrow(e) => expr(e, places),
            Terminator::Throw { error, help: _, span } => {
                expr(error, places);
                *span = places.span(*span);
            }
        }
    }
}

fn statement(s: &mut Statement, places: &Places<'_>) {
    match s {
        Statement::Eval(e) => expr(e, places),
        Statement::Assign { place: to, value, span } | Statement::Push { place: to, value, span } => {
            place(to, places);
            expr(value, places);
            *span = places.span(*span);
        }
        Statement::Call { result, function: _, arguments, copy_back, span } => {
            result.iter_mut().chain(copy_back).for_each(|to| place(to, places));
            all(arguments, places);
            *span = places.span(*span);
        }
        Statement::Host { function: _, arguments, result, provided, span } => {
            place(result, places);
            place(provided, places);
            all(arguments, places);
            *span = places.span(*span);
        }
    }
}

fn place(place: &mut Place, places: &Places<'_>) {
    for step in &mut place.steps {
        match step {
            Step::Index(index) => expr(index, places),
            Step::Element(_) => {}
        }
    }
}

fn all(expressions: &mut [Expr], places: &Places<'_>) {
    expressions.iter_mut().for_each(|e| expr(e, places));
}

fn expr(e: &mut Expr, places: &Places<'_>) {
    e.span = places.span(e.span);
    match &mut e.kind {
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
        | ExprKind::MakeSymbolic { captures: parts, .. } => all(parts, places),
        ExprKind::And(a, b)
        | ExprKind::Or(a, b)
        | ExprKind::Index(a, b)
        | ExprKind::EvalSymbolic { value: a, time: b } => {
            expr(a, places);
            expr(b, places);
        }
        ExprKind::If(a, b, c) => {
            expr(a, places);
            expr(b, places);
            expr(c, places);
        }
        ExprKind::TupleElement(a, _) | ExprKind::Copy(a) | ExprKind::Len(a) | ExprKind::CaughtFields(a) => {
            expr(a, places)
        }
        ExprKind::Format(parts) => {
            for part in parts {
                match part {
                    FormatPart::Text(_) => {}
                    FormatPart::Value(value, _) => expr(value, places),
                }
            }
        }
    }
}

pub(super) fn site(site: &mut Site, places: &Places<'_>) {
    site.span = places.span(site.span);
    site.shared.iter_mut().for_each(|part| symbolic(part, places));
    symbolic(&mut site.expr, places);
}

pub(super) fn symbolic_function(function: &mut SymbolicFunction, places: &Places<'_>) {
    function.span = places.span(function.span);
    function.shared.iter_mut().for_each(|part| symbolic(part, places));
    symbolic(&mut function.body, places);
}

fn symbolic(e: &mut SymExpr, places: &Places<'_>) {
    e.span = places.span(e.span);
    match &mut e.kind {
        SymKind::Number(_)
        | SymKind::Bool(_)
        | SymKind::Time
        | SymKind::Param(_)
        | SymKind::Capture(_)
        | SymKind::Argument(_)
        | SymKind::Shared(_) => {}
        SymKind::Op(_, parts)
        | SymKind::Call(_, parts)
        | SymKind::Solve(_, _, parts)
        | SymKind::Brackets(parts) => {
            parts.iter_mut().for_each(|part| symbolic(part, places));
        }
        SymKind::If(a, b, c) => {
            symbolic(a, places);
            symbolic(b, places);
            symbolic(c, places);
        }
        SymKind::Derivative(a, _) | SymKind::Element(a, _) | SymKind::Table(_, a) => symbolic(a, places),
        SymKind::At(a, _, b) => {
            symbolic(a, places);
            symbolic(b, places);
        }
    }
}
