//! Visits all source ranges and names in a syntax tree, to move the tree or to collect its names.
//!
//! The checker works on top-level statements whose source ranges are relative to their own start,
//! so that edits above a statement do not invalidate its results.

use crate::ast::*;
use crate::hashed::HashSet;
use crate::span::{FileId, Span};
use smol_str::SmolStr;

/// A callback that receives each source range and, if the range is a name, the name.
pub type Visit<'v> = dyn FnMut(&mut Span, Option<&SmolStr>) + 'v;

/// Moves a statement so that it starts at `start` of `file`.
pub fn to(statement: &mut Stmt, file: FileId, start: u32) {
    let from = statement.span.start;
    self::statement(statement, &mut |span, _| {
        // All ranges of a statement follow its start. In a malformed text, other ranges are clamped
        // to the start.
        span.file = file;
        span.start = span.start.saturating_sub(from).saturating_add(start);
        span.end = span.end.saturating_sub(from).saturating_add(start).max(span.start);
    });
}

/// Adds the names that `visit_part` visits.
pub fn names(found: &mut HashSet<SmolStr>, visit_part: impl FnOnce(&mut Visit<'_>)) {
    visit_part(&mut |_, name| {
        if let Some(name) = name
            && !found.contains(name.as_str())
        {
            found.insert(name.clone());
        }
    });
}

fn ident(ident: &mut Ident, visit: &mut Visit<'_>) {
    visit(&mut ident.span, Some(&ident.name));
}

/// Visits a declared name and its former name.
fn declared(name: &mut Ident, former: &mut Option<Ident>, visit: &mut Visit<'_>) {
    ident(name, visit);
    if let Some(former) = former {
        ident(former, visit);
    }
}

pub fn statement(s: &mut Stmt, visit: &mut Visit<'_>) {
    visit(&mut s.span, None);
    match &mut s.kind {
        StmtKind::Empty | StmtKind::Error | StmtKind::Break | StmtKind::Continue => {}
        StmtKind::Import(import) => {
            import.path.iter_mut().chain(&mut import.alias).for_each(|name| ident(name, visit));
        }
        StmtKind::Units(name) | StmtKind::Goto(name) => ident(name, visit),
        StmtKind::Param(decl) => {
            ident(&mut decl.name, visit);
            expr(&mut decl.default, visit);
            domain(&mut decl.domain, visit);
        }
        StmtKind::Const { name, value } => {
            ident(name, visit);
            expr(value, visit);
        }
        StmtKind::Output { name, value, unit } => {
            ident(name, visit);
            expr(value, visit);
            if let Some(unit) = unit {
                expr(unit, visit);
            }
        }
        StmtKind::Record(decl) => record(decl, visit),
        StmtKind::Enum(decl) => {
            ident(&mut decl.name, visit);
            decl.choices.iter_mut().for_each(|choice| ident(&mut choice.name, visit));
        }
        StmtKind::Dimension { name, value } => {
            ident(name, visit);
            if let Some(value) = value {
                type_expr(value, visit);
            }
        }
        StmtKind::Unit(decl) => unit(decl, visit),
        StmtKind::Var(decls) => {
            for decl in decls {
                ident(&mut decl.name, visit);
                if let Some((_, value)) = &mut decl.init {
                    expr(value, visit);
                }
            }
        }
        StmtKind::Assign { place, value, .. } => {
            expr(place, visit);
            expr(value, visit);
        }
        StmtKind::Update { place, op_span, value, .. } => {
            visit(op_span, None);
            expr(place, visit);
            expr(value, visit);
        }
        StmtKind::Expr(e) => expr(e, visit),
        StmtKind::Function(decl) => {
            function_header(decl, visit);
            function_body(decl, visit);
        }
        StmtKind::Block(all) => all.iter_mut().for_each(|s| statement(s, visit)),
        StmtKind::If { condition, then, otherwise } => {
            expr(condition, visit);
            statement(then, visit);
            if let Some(otherwise) = otherwise {
                statement(otherwise, visit);
            }
        }
        StmtKind::While { condition, body } | StmtKind::DoWhile { body, condition } => {
            expr(condition, visit);
            statement(body, visit);
        }
        StmtKind::For { init, condition, step, body } => {
            statement(init, visit);
            if let Some(condition) = condition {
                expr(condition, visit);
            }
            statement(step, visit);
            statement(body, visit);
        }
        StmtKind::ForEach { variable, values, body } => {
            ident(variable, visit);
            loop_values(values, visit);
            statement(body, visit);
        }
        StmtKind::Switch { value, body } | StmtKind::Case { value, statement: body } => {
            expr(value, visit);
            statement(body, visit);
        }
        StmtKind::Default(body) => statement(body, visit),
        StmtKind::Label { label, statement: body } => {
            ident(label, visit);
            statement(body, visit);
        }
        StmtKind::Return(value) | StmtKind::Throw(value) => {
            if let Some(value) = value {
                expr(value, visit);
            }
        }
        StmtKind::Try { body, error, handler } => {
            statement(body, visit);
            if let Some(error) = error {
                ident(error, visit);
            }
            statement(handler, visit);
        }
    }
}

fn record(decl: &mut RecordDecl, visit: &mut Visit<'_>) {
    declared(&mut decl.name, &mut decl.former, visit);
    for field in &mut decl.fields {
        declared(&mut field.name, &mut field.former, visit);
        if let Some(annotation) = &mut field.annotation {
            type_expr(annotation, visit);
        }
        if let Some(default) = &mut field.default {
            expr(default, visit);
        }
    }
}

fn unit(decl: &mut UnitDecl, visit: &mut Visit<'_>) {
    ident(&mut decl.name, visit);
    match &mut decl.meaning {
        UnitMeaning::Coherent(dimension) => type_expr(dimension, visit),
        UnitMeaning::Equal(value) => expr(value, visit),
    }
}

/// Visits the parts of a function that its callers depend on.
pub fn function_header(decl: &mut FunctionDecl, visit: &mut Visit<'_>) {
    declared(&mut decl.name, &mut decl.former, visit);
    for parameter in &mut decl.parameters {
        declared(&mut parameter.name, &mut parameter.former, visit);
        if let Some(annotation) = &mut parameter.annotation {
            type_expr(annotation, visit);
        }
        if let Some((_, Some(default))) = &mut parameter.default {
            expr(default, visit);
        }
        if let Some(former) = &mut parameter.former_none {
            expr(former, visit);
        }
        domain(&mut parameter.domain, visit);
    }
    if let Some(result) = &mut decl.result {
        type_expr(result, visit);
    }
}

pub fn function_body(decl: &mut FunctionDecl, visit: &mut Visit<'_>) {
    match &mut decl.body {
        FunctionBody::Statement(body) => statement(body, visit),
        FunctionBody::Symbolic(e) => expr(e, visit),
        FunctionBody::Extern { purity, unit } => {
            if let Some(purity) = purity {
                ident(purity, visit);
            }
            if let Some(unit) = unit {
                expr(unit, visit);
            }
        }
    }
}

fn domain(domain: &mut Option<Domain>, visit: &mut Visit<'_>) {
    match domain {
        None => {}
        Some(Domain::Range { low, high, span }) => {
            visit(span, None);
            low.iter_mut().chain(high).for_each(|e| expr(e, visit));
        }
        Some(Domain::Choices { values, span, .. }) => {
            visit(span, None);
            values.iter_mut().for_each(|e| expr(e, visit));
        }
    }
}

fn type_expr(ty: &mut TypeExpr, visit: &mut Visit<'_>) {
    visit(&mut ty.span, None);
    match &mut ty.kind {
        TypeKind::Name(name) => ident(name, visit),
        TypeKind::Member(module, name) => {
            ident(module, visit);
            ident(name, visit);
        }
        TypeKind::Apply(name, parts) => {
            ident(name, visit);
            parts.iter_mut().for_each(|part| type_expr(part, visit));
        }
        TypeKind::Product(a, b) | TypeKind::Quotient(a, b) => {
            type_expr(a, visit);
            type_expr(b, visit);
        }
        TypeKind::Power(base, ..) => type_expr(base, visit),
        TypeKind::Function(parameters, result) => {
            parameters.iter_mut().for_each(|part| type_expr(part, visit));
            type_expr(result, visit);
        }
        TypeKind::Error => {}
    }
}

fn loop_values(values: &mut Values, visit: &mut Visit<'_>) {
    match values {
        Values::Elements(array) => expr(array, visit),
        Values::Range(low, high) => {
            expr(low, visit);
            expr(high, visit);
        }
    }
}

pub fn expr(e: &mut Expr, visit: &mut Visit<'_>) {
    visit(&mut e.span, None);
    match &mut e.kind {
        ExprKind::Error | ExprKind::Number(_) | ExprKind::Bool(_) => {}
        ExprKind::Quantity { unit, exponent_span, .. } => {
            ident(unit, visit);
            if let Some(span) = exponent_span {
                visit(span, None);
            }
        }
        ExprKind::String(parts) => {
            for part in parts {
                match part {
                    StringPart::Text(_) => {}
                    StringPart::Value(value, format) => {
                        expr(value, visit);
                        if let Some(format) = format {
                            visit(&mut format.span, None);
                            if let Some(unit) = &mut format.unit {
                                expr(unit, visit);
                            }
                        }
                    }
                }
            }
        }
        ExprKind::Name(name) => ident(name, visit),
        ExprKind::Field { base, field } => {
            expr(base, visit);
            ident(field, visit);
        }
        ExprKind::Call { callee, arguments } => {
            expr(callee, visit);
            for argument in arguments {
                if let Some((name, _)) = &mut argument.name {
                    ident(name, visit);
                }
                expr(&mut argument.value, visit);
            }
        }
        ExprKind::Index { base, index } => {
            expr(base, visit);
            expr(index, visit);
        }
        ExprKind::Slice { base, low, high } => {
            expr(base, visit);
            low.iter_mut().chain(high).for_each(|limit| expr(limit, visit));
        }
        ExprKind::Unary { operand, .. } => expr(operand, visit),
        ExprKind::Binary { op_span, left, right, .. } => {
            visit(op_span, None);
            expr(left, visit);
            expr(right, visit);
        }
        ExprKind::List(all) => all.iter_mut().for_each(|e| expr(e, visit)),
        ExprKind::Measured { elements, unit, exponent_span, .. } => {
            elements.iter_mut().for_each(|e| expr(e, visit));
            ident(unit, visit);
            if let Some(span) = exponent_span {
                visit(span, None);
            }
        }
        ExprKind::Comprehension(parts) => {
            expr(&mut parts.element, visit);
            ident(&mut parts.variable, visit);
            loop_values(&mut parts.values, visit);
            if let Some(condition) = &mut parts.condition {
                expr(condition, visit);
            }
        }
        ExprKind::If { condition, then, otherwise } => {
            expr(condition, visit);
            expr(then, visit);
            expr(otherwise, visit);
        }
        ExprKind::At { value, symbol, at } => {
            expr(value, visit);
            ident(symbol, visit);
            expr(at, visit);
        }
        ExprKind::Paren(inner) | ExprKind::IsNone { value: inner, .. } => expr(inner, visit),
        ExprKind::Anonymous(decl) => {
            function_header(decl, visit);
            function_body(decl, visit);
        }
        ExprKind::Block(body) => statement(body, visit),
    }
}
