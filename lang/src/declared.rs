//! Finds the declaration of a name in a syntax tree, and extracts its text.

use crate::ast::{
    Domain, EnumChoice, EnumDecl, Expr, ExprKind, FunctionBody, FunctionDecl, Ident, Module, Parameter,
    RecordDecl, RecordField, Stmt, StmtKind, StringPart, Values, VarDecl,
};
use crate::span::Span;
use crate::walk::Node;

/// A declaration in a syntax tree.
#[derive(Clone, Copy, Debug)]
pub enum Declared<'t> {
    /// A function, record, param, output, constant, dimension, unit or import.
    Statement(&'t Stmt),
    Variable(&'t Stmt, &'t VarDecl),
    Parameter(&'t FunctionDecl, &'t Parameter),
    Field(&'t RecordDecl, &'t RecordField),
    Choice(&'t EnumDecl, &'t EnumChoice),
    /// The variable of a `catch` clause.
    Caught(&'t Stmt),
    /// The variable of a comprehension or of a loop over values, with the statement around it.
    Element(&'t Stmt, &'t Ident, &'t Values),
}

/// Returns the declaration whose name starts at an offset, and the top-level statement that
/// contains it.
pub fn find(module: &Module, offset: u32) -> Option<(&Stmt, Declared<'_>)> {
    find_in(&module.statements, offset)
}

/// As [`find`], among consecutive statements of a file.
pub(crate) fn find_in(statements: &[Stmt], offset: u32) -> Option<(&Stmt, Declared<'_>)> {
    let after = statements.partition_point(|statement| statement.span.start <= offset);
    let item = statements.get(after.checked_sub(1)?)?;
    Some((item, within(item, offset)?))
}

fn within(statement: &Stmt, offset: u32) -> Option<Declared<'_>> {
    named(statement, offset).or_else(|| comprehended(statement, Node::Statement(statement), offset))
}

/// Returns the comprehension in a node whose variable starts at an offset.
fn comprehended<'t>(statement: &'t Stmt, node: Node<'t>, offset: u32) -> Option<Declared<'t>> {
    if let Node::Expression(Expr { kind: ExprKind::Comprehension(parts), .. }) = node
        && parts.variable.span.start == offset
    {
        return Some(Declared::Element(statement, &parts.variable, &parts.values));
    }
    if let Node::Expression(Expr { kind: ExprKind::Anonymous(decl), .. }) = node
        && let Some(parameter) = decl.parameters.iter().find(|p| p.name.span.start == offset)
    {
        return Some(Declared::Parameter(decl, parameter));
    }
    let mut found = None;
    node.children(&mut |child| {
        let (start, end) = child.range();
        if found.is_none() && start <= offset && offset < end {
            found = comprehended(statement, child, offset);
        }
    });
    found
}

/// As [`within`], without the variables of comprehensions.
fn named(statement: &Stmt, offset: u32) -> Option<Declared<'_>> {
    let here = |name: &Ident| name.span.start == offset;
    match &statement.kind {
        StmtKind::Function(decl) => {
            if here(&decl.name) {
                return Some(Declared::Statement(statement));
            }
            let parameter = decl.parameters.iter().find(|parameter| here(&parameter.name));
            parameter.map(|parameter| Declared::Parameter(decl, parameter)).or_else(|| match &decl.body {
                FunctionBody::Statement(body)
                | FunctionBody::Symbolic(Expr { kind: ExprKind::Block(body), .. }) => within(body, offset),
                _ => None,
            })
        }
        StmtKind::Record(decl) if !here(&decl.name) => {
            let field = decl.fields.iter().find(|field| here(&field.name))?;
            Some(Declared::Field(decl, field))
        }
        StmtKind::Enum(decl) if !here(&decl.name) => {
            let choice = decl.choices.iter().find(|choice| here(&choice.name))?;
            Some(Declared::Choice(decl, choice))
        }
        StmtKind::Var(decls) => {
            let decl = decls.iter().find(|decl| here(&decl.name))?;
            Some(Declared::Variable(statement, decl))
        }
        StmtKind::Try { error: Some(error), .. } if here(error) => Some(Declared::Caught(statement)),
        StmtKind::ForEach { variable, values, .. } if here(variable) => {
            Some(Declared::Element(statement, variable, values))
        }
        _ if name_of(statement).is_some_and(here) => Some(Declared::Statement(statement)),
        _ => {
            let inner = children(statement).into_iter();
            inner.filter(|s| s.span.start <= offset && offset < s.span.end).find_map(|s| within(s, offset))
        }
    }
}

/// Returns the name that a statement declares, if any.
pub fn name_of(statement: &Stmt) -> Option<&Ident> {
    match &statement.kind {
        StmtKind::Function(decl) => Some(&decl.name),
        StmtKind::Record(decl) => Some(&decl.name),
        StmtKind::Enum(decl) => Some(&decl.name),
        StmtKind::Unit(decl) => Some(&decl.name),
        StmtKind::Param(decl) => Some(&decl.name),
        StmtKind::Output { name, .. } | StmtKind::Const { name, .. } | StmtKind::Dimension { name, .. } => {
            Some(name)
        }
        StmtKind::Import(import) => import.name(),
        _ => None,
    }
}

/// Returns the direct child statements of a statement in source order.
pub fn children(statement: &Stmt) -> Vec<&Stmt> {
    let mut found = Vec::new();
    Node::Statement(statement).children(&mut |child| {
        if let Node::Statement(inner) = child {
            found.push(inner);
        }
    });
    found
}

/// Returns the source text of a declaration without its body and without former names and values.
pub fn header(declared: Declared<'_>, text: &str) -> String {
    let mut former: Vec<Span> = Vec::new();
    let name =
        |name: &Ident, was: &Option<Ident>| was.as_ref().map(|was| Span { start: name.span.end, ..was.span });
    let value = |parameter: &Parameter| {
        let (_, default) = parameter.default.as_ref()?;
        Some(Span { start: default.as_ref()?.span.end, ..parameter.former_none.as_ref()?.span })
    };
    match declared {
        Declared::Statement(Stmt { kind: StmtKind::Function(decl), .. }) => {
            former.extend(name(&decl.name, &decl.former));
            for parameter in &decl.parameters {
                former.extend(name(&parameter.name, &parameter.former));
                former.extend(value(parameter));
            }
        }
        Declared::Statement(Stmt { kind: StmtKind::Record(decl), .. }) => {
            former.extend(name(&decl.name, &decl.former));
            decl.fields.iter().for_each(|field| former.extend(name(&field.name, &field.former)));
        }
        Declared::Parameter(_, parameter) => {
            former.extend(name(&parameter.name, &parameter.former));
            former.extend(value(parameter));
        }
        Declared::Field(_, field) => former.extend(name(&field.name, &field.former)),
        _ => {}
    }
    let slice = |start: u32, end: u32| {
        let mut kept = String::new();
        let mut from = start;
        for cut in former.iter().filter(|cut| start <= cut.start && cut.end <= end) {
            kept += text.get(from as usize..cut.start as usize).unwrap_or_default();
            from = cut.end;
        }
        kept + text.get(from as usize..end as usize).unwrap_or_default()
    };
    match declared {
        Declared::Statement(statement) => {
            let end = match &statement.kind {
                StmtKind::Function(FunctionDecl { body: FunctionBody::Statement(body), .. }) => {
                    body.span.start
                }
                _ => statement.span.end,
            };
            slice(statement.span.start, end).trim_end().trim_end_matches(';').to_string()
        }
        Declared::Variable(_, decl) => match &decl.init {
            Some((_, value)) => format!("var {}", slice(decl.name.span.start, value.span.end)),
            None => format!("var {}", decl.name.name),
        },
        Declared::Parameter(_, parameter) => {
            let mode = match parameter.mode {
                crate::ast::Mode::In => "in",
                crate::ast::Mode::Out => "out",
                crate::ast::Mode::InOut => "inout",
            };
            let ends = [
                Some(parameter.name.span.end),
                parameter.annotation.as_ref().map(|annotation| annotation.span.end),
                parameter.default.as_ref().and_then(|(_, value)| value.as_ref()).map(|value| value.span.end),
                parameter.domain.as_ref().map(|domain| domain_span(domain).end),
            ];
            let end = ends.into_iter().flatten().max().unwrap_or_default();
            format!("{mode} {}", slice(parameter.name.span.start, end))
        }
        Declared::Field(record, field) => {
            let ends = [
                Some(field.name.span.end),
                field.annotation.as_ref().map(|annotation| annotation.span.end),
                field.default.as_ref().map(|value| value.span.end),
            ];
            let end = ends.into_iter().flatten().max().unwrap_or_default();
            format!("{}.{}", record.name.name, slice(field.name.span.start, end))
        }
        Declared::Choice(decl, choice) => format!("{}.{}", decl.name.name, choice.name.name),
        Declared::Caught(_) => "catch (Error)".into(),
        Declared::Element(_, variable, values) => {
            format!("for {}", slice(variable.span.start, values.span().end))
        }
    }
}

/// Returns the former name of a declaration.
pub fn former(declared: Declared<'_>) -> Option<&Ident> {
    match declared {
        Declared::Statement(Stmt { kind: StmtKind::Function(decl), .. }) => decl.former.as_ref(),
        Declared::Statement(Stmt { kind: StmtKind::Record(decl), .. }) => decl.former.as_ref(),
        Declared::Parameter(_, parameter) => parameter.former.as_ref(),
        Declared::Field(_, field) => field.former.as_ref(),
        Declared::Statement(_)
        | Declared::Variable(..)
        | Declared::Choice(..)
        | Declared::Caught(_)
        | Declared::Element(..) => None,
    }
}

/// Returns the `///` text of a declaration.
pub fn doc(declared: Declared<'_>) -> Option<&str> {
    match declared {
        Declared::Statement(statement) | Declared::Variable(statement, _) => statement.doc.as_deref(),
        Declared::Parameter(_, parameter) => parameter.doc.as_deref(),
        Declared::Field(_, field) => field.doc.as_deref(),
        Declared::Choice(_, choice) => choice.doc.as_deref(),
        Declared::Caught(_) | Declared::Element(..) => None,
    }
}

fn domain_span(domain: &Domain) -> Span {
    match domain {
        Domain::Range { span, .. } | Domain::Choices { span, .. } => *span,
    }
}

/// Returns the limits of a range as written.
pub fn range(domain: Option<&Domain>, text: &str) -> Option<String> {
    let Some(Domain::Range { low, high, .. }) = domain else { return None };
    let slice = |e: &Option<Expr>| {
        let e = e.as_ref()?;
        text.get(e.span.start as usize..e.span.end as usize)
    };
    let ends = format!("{} .. {}", slice(low).unwrap_or_default(), slice(high).unwrap_or_default());
    Some(ends.trim().to_string())
}

/// Returns the allowed strings.
pub fn choices(domain: Option<&Domain>) -> Vec<String> {
    let Some(Domain::Choices { values, .. }) = domain else { return Vec::new() };
    values.iter().filter_map(plain_string).collect()
}

/// Returns the text of a string that has no interpolated values.
pub fn plain_string(e: &Expr) -> Option<String> {
    match &e.kind {
        ExprKind::String(parts) => match parts.as_slice() {
            [] => Some(String::new()),
            [StringPart::Text(text)] => Some(text.clone()),
            _ => None,
        },
        _ => None,
    }
}
