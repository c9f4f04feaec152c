//! Visits syntax nodes and their descendants.
//!
//! `crate::relocate` visits all source ranges in order to change them.

use crate::ast::*;
use crate::span::Span;

/// A syntax node that can have children.
#[derive(Clone, Copy, Debug)]
pub enum Node<'t> {
    Statement(&'t Stmt),
    Expression(&'t Expr),
    Argument(&'t Argument),
    Variable(&'t VarDecl),
    Parameter(&'t Parameter),
    Field(&'t RecordField),
    Domain(&'t Domain),
    Type(&'t TypeExpr),
    /// A declared name, or a word that is not an expression.
    Name(&'t Ident),
}

impl<'t> Node<'t> {
    /// Returns start and end offset. Excludes the `in` of a parameter and the `..` of a spread
    /// argument, whose positions the tree does not store.
    pub fn range(self) -> (u32, u32) {
        let of = |span: Span| (span.start, span.end);
        match self {
            Node::Statement(statement) => of(statement.span),
            Node::Expression(e) => of(e.span),
            Node::Domain(Domain::Range { span, .. } | Domain::Choices { span, .. }) => of(*span),
            Node::Type(ty) => of(ty.span),
            Node::Name(name) => of(name.span),
            Node::Argument(argument) => {
                let start = argument.name.as_ref().map_or(argument.value.span, |(name, _)| name.span).start;
                (start, argument.value.span.end.max(start))
            }
            Node::Variable(_) | Node::Parameter(_) | Node::Field(_) => {
                let (mut start, mut end) = (u32::MAX, 0);
                self.children(&mut |child| {
                    let (from, to) = child.range();
                    (start, end) = (start.min(from), end.max(to));
                });
                (start.min(end), end)
            }
        }
    }

    /// Visits the direct children, in order of position.
    pub fn children(self, visit: &mut dyn FnMut(Node<'t>)) {
        match self {
            Node::Statement(statement) => statement_children(&statement.kind, visit),
            Node::Expression(e) => expression_children(&e.kind, visit),
            Node::Argument(argument) => {
                argument.name.iter().for_each(|(name, _)| visit(Node::Name(name)));
                visit(Node::Expression(&argument.value));
            }
            Node::Variable(variable) => {
                visit(Node::Name(&variable.name));
                variable.init.iter().for_each(|(_, value)| visit(Node::Expression(value)));
            }
            Node::Parameter(parameter) => {
                visit(Node::Name(&parameter.name));
                parameter.annotation.iter().for_each(|ty| visit(Node::Type(ty)));
                let default = parameter.default.iter().filter_map(|(_, value)| value.as_ref());
                default.chain(&parameter.former_none).for_each(|value| visit(Node::Expression(value)));
                parameter.domain.iter().for_each(|domain| visit(Node::Domain(domain)));
            }
            Node::Field(field) => {
                visit(Node::Name(&field.name));
                field.annotation.iter().for_each(|ty| visit(Node::Type(ty)));
                field.default.iter().for_each(|value| visit(Node::Expression(value)));
            }
            Node::Domain(Domain::Range { low, high, .. }) => {
                low.iter().chain(high).for_each(|e| visit(Node::Expression(e)));
            }
            Node::Domain(Domain::Choices { values, .. }) => {
                values.iter().for_each(|e| visit(Node::Expression(e)));
            }
            Node::Type(ty) => match &ty.kind {
                TypeKind::Name(_) | TypeKind::Member(..) | TypeKind::Error => {}
                TypeKind::Apply(_, arguments) => arguments.iter().for_each(|ty| visit(Node::Type(ty))),
                TypeKind::Product(left, right) | TypeKind::Quotient(left, right) => {
                    visit(Node::Type(left));
                    visit(Node::Type(right));
                }
                TypeKind::Power(base, ..) => visit(Node::Type(base)),
                TypeKind::Function(parameters, result) => {
                    parameters.iter().for_each(|ty| visit(Node::Type(ty)));
                    visit(Node::Type(result));
                }
            },
            Node::Name(_) => {}
        }
    }

    /// Visits the node and its descendants, parents before children.
    pub fn walk(self, visit: &mut dyn FnMut(Node<'t>)) {
        visit(self);
        self.children(&mut |child| child.walk(visit));
    }
}

fn statement_children<'t>(kind: &'t StmtKind, visit: &mut dyn FnMut(Node<'t>)) {
    match kind {
        StmtKind::Empty | StmtKind::Error | StmtKind::Break | StmtKind::Continue => {}
        StmtKind::Import(import) => {
            import.path.iter().chain(&import.alias).for_each(|name| visit(Node::Name(name)));
        }
        StmtKind::Units(name) | StmtKind::Goto(name) => visit(Node::Name(name)),
        StmtKind::Param(param) => {
            visit(Node::Name(&param.name));
            visit(Node::Expression(&param.default));
            param.domain.iter().for_each(|domain| visit(Node::Domain(domain)));
        }
        StmtKind::Const { name, value } => {
            visit(Node::Name(name));
            visit(Node::Expression(value));
        }
        StmtKind::Output { name, value, unit } => {
            visit(Node::Name(name));
            visit(Node::Expression(value));
            unit.iter().for_each(|unit| visit(Node::Expression(unit)));
        }
        StmtKind::Record(record) => {
            visit(Node::Name(&record.name));
            record.fields.iter().for_each(|field| visit(Node::Field(field)));
        }
        StmtKind::Enum(decl) => {
            visit(Node::Name(&decl.name));
            decl.choices.iter().for_each(|choice| visit(Node::Name(&choice.name)));
        }
        StmtKind::Dimension { name, value } => {
            visit(Node::Name(name));
            value.iter().for_each(|ty| visit(Node::Type(ty)));
        }
        StmtKind::Unit(unit) => {
            visit(Node::Name(&unit.name));
            match &unit.meaning {
                UnitMeaning::Coherent(ty) => visit(Node::Type(ty)),
                UnitMeaning::Equal(value) => visit(Node::Expression(value)),
            }
        }
        StmtKind::Var(variables) => variables.iter().for_each(|variable| visit(Node::Variable(variable))),
        StmtKind::Assign { place, value, .. } | StmtKind::Update { place, value, .. } => {
            visit(Node::Expression(place));
            visit(Node::Expression(value));
        }
        StmtKind::Expr(e) => visit(Node::Expression(e)),
        StmtKind::Function(function) => {
            visit(Node::Name(&function.name));
            function.parameters.iter().for_each(|parameter| visit(Node::Parameter(parameter)));
            function.result.iter().for_each(|ty| visit(Node::Type(ty)));
            match &function.body {
                FunctionBody::Statement(body) => visit(Node::Statement(body)),
                FunctionBody::Symbolic(value) => visit(Node::Expression(value)),
                FunctionBody::Extern { unit, .. } => {
                    unit.iter().for_each(|unit| visit(Node::Expression(unit)));
                }
            }
        }
        StmtKind::Block(statements) => {
            statements.iter().for_each(|statement| visit(Node::Statement(statement)));
        }
        StmtKind::If { condition, then, otherwise } => {
            visit(Node::Expression(condition));
            visit(Node::Statement(then));
            otherwise.iter().for_each(|otherwise| visit(Node::Statement(otherwise)));
        }
        StmtKind::While { condition, body } => {
            visit(Node::Expression(condition));
            visit(Node::Statement(body));
        }
        StmtKind::DoWhile { body, condition } => {
            visit(Node::Statement(body));
            visit(Node::Expression(condition));
        }
        StmtKind::For { init, condition, step, body } => {
            visit(Node::Statement(init));
            condition.iter().for_each(|condition| visit(Node::Expression(condition)));
            visit(Node::Statement(step));
            visit(Node::Statement(body));
        }
        StmtKind::ForEach { variable, values, body } => {
            visit(Node::Name(variable));
            values.expressions().into_iter().for_each(|e| visit(Node::Expression(e)));
            visit(Node::Statement(body));
        }
        StmtKind::Switch { value, body } | StmtKind::Case { value, statement: body } => {
            visit(Node::Expression(value));
            visit(Node::Statement(body));
        }
        StmtKind::Default(statement) => visit(Node::Statement(statement)),
        StmtKind::Label { label, statement } => {
            visit(Node::Name(label));
            visit(Node::Statement(statement));
        }
        StmtKind::Return(value) | StmtKind::Throw(value) => {
            value.iter().for_each(|value| visit(Node::Expression(value)));
        }
        StmtKind::Try { body, error, handler } => {
            visit(Node::Statement(body));
            error.iter().for_each(|name| visit(Node::Name(name)));
            visit(Node::Statement(handler));
        }
    }
}

fn expression_children<'t>(kind: &'t ExprKind, visit: &mut dyn FnMut(Node<'t>)) {
    match kind {
        ExprKind::Error | ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::Name(_) => {}
        ExprKind::Quantity { unit, .. } => visit(Node::Name(unit)),
        ExprKind::String(parts) => {
            for part in parts {
                if let StringPart::Value(value, format) = part {
                    visit(Node::Expression(value));
                    let unit = format.iter().filter_map(|format| format.unit.as_ref());
                    unit.for_each(|unit| visit(Node::Expression(unit)));
                }
            }
        }
        ExprKind::Field { base, field } => {
            visit(Node::Expression(base));
            visit(Node::Name(field));
        }
        ExprKind::Call { callee, arguments } => {
            visit(Node::Expression(callee));
            arguments.iter().for_each(|argument| visit(Node::Argument(argument)));
        }
        ExprKind::Index { base, index } => {
            visit(Node::Expression(base));
            visit(Node::Expression(index));
        }
        ExprKind::Slice { base, low, high } => {
            visit(Node::Expression(base));
            low.iter().chain(high).for_each(|limit| visit(Node::Expression(limit)));
        }
        ExprKind::Unary { operand, .. } => visit(Node::Expression(operand)),
        ExprKind::Binary { left, right, .. } => {
            visit(Node::Expression(left));
            visit(Node::Expression(right));
        }
        ExprKind::List(items) => items.iter().for_each(|item| visit(Node::Expression(item))),
        ExprKind::Measured { elements, unit, .. } => {
            elements.iter().for_each(|item| visit(Node::Expression(item)));
            visit(Node::Name(unit));
        }
        ExprKind::Comprehension(parts) => {
            visit(Node::Expression(&parts.element));
            visit(Node::Name(&parts.variable));
            parts.values.expressions().into_iter().for_each(|e| visit(Node::Expression(e)));
            parts.condition.iter().for_each(|e| visit(Node::Expression(e)));
        }
        ExprKind::If { condition, then, otherwise } => {
            visit(Node::Expression(condition));
            visit(Node::Expression(then));
            visit(Node::Expression(otherwise));
        }
        ExprKind::At { value, symbol, at } => {
            visit(Node::Expression(value));
            visit(Node::Name(symbol));
            visit(Node::Expression(at));
        }
        ExprKind::Paren(inner) | ExprKind::IsNone { value: inner, .. } => visit(Node::Expression(inner)),
        ExprKind::Anonymous(decl) => {
            decl.parameters.iter().for_each(|parameter| visit(Node::Parameter(parameter)));
            if let FunctionBody::Symbolic(e) = &decl.body {
                visit(Node::Expression(e));
            }
        }
        ExprKind::Block(body) => visit(Node::Statement(body)),
    }
}
