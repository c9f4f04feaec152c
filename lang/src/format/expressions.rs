//! Formats expressions: operators have spaces and follow line breaks, units are next to their
//! numbers, brackets are filled or have one item per line.

use super::document::{Breaks, Item};
use super::printer::{Layout, Printer};
use crate::ast::{
    Argument, BinaryOp, Bind, Comprehension, Expr, ExprKind, FunctionBody, Parameter, UnaryOp, Values,
};
use crate::lexer::Kind;
use crate::units::Unit;

impl Printer<'_> {
    pub(super) fn expression(&mut self, e: &Expr) {
        match &e.kind {
            // Texts with errors are not formatted.
            ExprKind::Error => {}
            ExprKind::Number(_) => self.token(Kind::Number),
            ExprKind::Quantity { exponent_span, .. } => {
                self.token(Kind::Number);
                self.unit_after(exponent_span.is_some());
            }
            ExprKind::Measured { elements, exponent_span, .. } => {
                self.list(elements);
                self.unit_after(exponent_span.is_some());
            }
            ExprKind::Comprehension(parts) => self.group(|p| p.comprehension(parts)),
            ExprKind::Anonymous(decl) => {
                let parameter = |p: &mut Self, _: &Parameter| p.token(Kind::Identifier);
                self.bracket(
                    (Kind::OpenParen, Kind::CloseParen),
                    &decl.parameters,
                    Layout::Filled,
                    parameter,
                );
                self.space();
                self.token(Kind::FatArrow);
                self.space();
                if let FunctionBody::Symbolic(e) = &decl.body {
                    self.expression(e);
                }
            }
            ExprKind::Bool(value) => self.token(if *value { Kind::True } else { Kind::False }),
            ExprKind::String(_) => self.string(),
            ExprKind::Name(_) => self.token(Kind::Identifier),
            ExprKind::Field { base, .. } => {
                self.expression(base);
                // `1.x` would be the number `1.` with the unit `x`.
                if self.previous() == Some(Kind::Number) {
                    self.space();
                }
                self.token(Kind::Dot);
                self.token(Kind::Identifier);
            }
            ExprKind::Call { callee, arguments } => {
                self.expression(callee);
                let layout = argument_layout(arguments);
                self.bracket((Kind::OpenParen, Kind::CloseParen), arguments, layout, Self::argument);
            }
            ExprKind::Index { base, index } => {
                self.expression(base);
                self.token(Kind::OpenBracket);
                self.expression(index);
                self.token(Kind::CloseBracket);
            }
            ExprKind::Slice { base, low, high } => {
                self.expression(base);
                self.token(Kind::OpenBracket);
                self.range(low.as_deref(), high.as_deref());
                self.token(Kind::CloseBracket);
            }
            ExprKind::Unary { op, operand } => {
                self.token(match op {
                    UnaryOp::Plus => Kind::Plus,
                    UnaryOp::Minus => Kind::Minus,
                    UnaryOp::Not => Kind::Not,
                });
                self.expression(operand);
            }
            ExprKind::Binary { op: BinaryOp::Power, left, right, .. } => {
                self.expression(left);
                self.token(Kind::Caret);
                self.expression(right);
            }
            ExprKind::Binary { op, .. } => self.group(|p| p.chain(e, *op)),
            ExprKind::List(items) => self.list(items),
            ExprKind::IsNone { value, negated } => {
                self.expression(value);
                self.space();
                self.token(Kind::Is);
                self.space();
                if *negated {
                    self.token(Kind::Identifier);
                    self.space();
                }
                self.token(Kind::Identifier);
            }
            ExprKind::If { .. } => self.group(|p| p.conditional(e)),
            ExprKind::At { value, at, .. } => self.group(|p| {
                p.expression(value);
                p.line();
                p.token(Kind::At);
                p.space();
                p.token(Kind::Identifier);
                p.space();
                p.token(Kind::Assign);
                p.space();
                p.expression(at);
            }),
            ExprKind::Paren(inner) => {
                self.token(Kind::OpenParen);
                self.expression(inner);
                self.token(Kind::CloseParen);
            }
            ExprKind::Block(body) => self.statement(body),
        }
    }

    /// Formats ` inch^2` after a number or brackets.
    fn unit_after(&mut self, raised: bool) {
        self.space();
        // A name or `%`.
        self.any_token();
        if raised {
            self.token(Kind::Caret);
            self.exponent();
        }
    }

    /// Formats `[element for x in values if condition]`.
    fn comprehension(&mut self, parts: &Comprehension) {
        self.token(Kind::OpenBracket);
        self.expression(&parts.element);
        self.line();
        self.token(Kind::For);
        self.space();
        self.token(Kind::Identifier);
        self.space();
        self.token(Kind::In);
        self.space();
        self.values(&parts.values);
        if let Some(condition) = &parts.condition {
            self.line();
            self.token(Kind::If);
            self.space();
            self.expression(condition);
        }
        self.token(Kind::CloseBracket);
    }

    /// Formats `array` or `low .. high` after the `in` of a loop.
    pub(super) fn values(&mut self, values: &Values) {
        match values {
            Values::Elements(array) => self.expression(array),
            Values::Range(low, high) => self.range(Some(low), Some(high)),
        }
    }

    /// Formats `low .. high`.
    fn range(&mut self, low: Option<&Expr>, high: Option<&Expr>) {
        if let Some(low) = low {
            self.expression(low);
            self.space();
        }
        self.token(Kind::DotDot);
        if let Some(high) = high {
            self.space();
            self.expression(high);
        }
    }

    /// Formats the value after `=` or `:=`.
    pub(super) fn value(&mut self, bind: Bind, e: &Expr) {
        self.space();
        self.bind(bind);
        self.assigned(e);
    }

    /// Formats the value after the operator of an assignment. A conditional starts on the next line
    /// if its first branch does not fit on this one; then `if` and each `else` are in one column.
    pub(super) fn assigned(&mut self, e: &Expr) {
        if let ExprKind::If { condition, then, otherwise } = &e.kind
            && !self.comment_ahead()
        {
            return self.group(|p| {
                p.item(Item::Open(Breaks::Filled));
                p.line();
                p.first_choice(condition, then);
                p.item(Item::Close);
                p.otherwise(otherwise);
            });
        }
        self.after_operator(e);
    }

    fn after_operator(&mut self, e: &Expr) {
        // Otherwise the value starts on the same line and breaks inside.
        let below = self.comment_ahead();
        if below {
            self.item(Item::Indent);
        }
        self.space();
        self.expression(e);
        if below {
            self.item(Item::Dedent);
        }
    }

    pub(super) fn bind(&mut self, bind: Bind) {
        self.token(match bind {
            Bind::Evaluate => Kind::Assign,
            Bind::Symbolic => Kind::Bind,
        });
    }

    /// Formats `2` or `-2` after the `^` of a unit.
    pub(super) fn exponent(&mut self) {
        if self.kind() == Some(Kind::Minus) {
            self.token(Kind::Minus);
        }
        self.token(Kind::Number);
    }

    pub(super) fn list(&mut self, items: &[Expr]) {
        let layout = match items {
            [only] if breaks_inside(only) => Layout::Hugged,
            _ if items.iter().all(is_short) => Layout::Filled,
            _ => Layout::Each,
        };
        self.bracket((Kind::OpenBracket, Kind::CloseBracket), items, layout, Self::expression);
    }

    fn argument(&mut self, argument: &Argument) {
        if argument.spread {
            self.token(Kind::DotDot);
        }
        match &argument.name {
            Some((_, bind)) => {
                self.token(Kind::Identifier);
                self.space();
                self.bind(*bind);
                self.after_operator(&argument.value);
            }
            None => self.expression(&argument.value),
        }
    }

    /// Formats operands of one precedence, left-associative; lines break before operators.
    fn chain(&mut self, e: &Expr, op: BinaryOp) {
        let mut joined: Vec<(BinaryOp, &Expr)> = Vec::new();
        let mut first = e;
        while let ExprKind::Binary { op: here, left, right, .. } = &first.kind
            && precedence(*here) == precedence(op)
        {
            joined.push((*here, right));
            first = left;
        }
        joined.reverse();
        self.expression(first);
        let mut in_unit = is_quantity(first);
        let mut after_division = false;
        for (op, operand) in joined {
            let scales = matches!(op, BinaryOp::Multiply | BinaryOp::Divide);
            let close = scales && in_unit && self.is_unit(operand);
            if !close {
                self.line();
            }
            self.token(operator(op));
            if !close {
                self.space();
                // `a / 2 N*m` would look like a division by a moment.
                after_division = op == BinaryOp::Divide;
            }
            self.expression(operand);
            in_unit = close || (is_quantity(operand) && !after_division);
        }
    }

    fn is_unit(&self, e: &Expr) -> bool {
        match &e.kind {
            ExprKind::Name(name) => {
                Unit::find(&name.name).is_some() || self.units.contains(name.name.as_str())
            }
            ExprKind::Binary { op: BinaryOp::Power, left, right, .. } => {
                let whole = match &right.kind {
                    ExprKind::Unary { op: UnaryOp::Minus, operand } => &operand.kind,
                    kind => kind,
                };
                matches!(left.kind, ExprKind::Name(_))
                    && self.is_unit(left)
                    && matches!(whole, ExprKind::Number(_))
            }
            _ => false,
        }
    }

    /// Formats `if (c) a else if (d) b else e`.
    fn conditional(&mut self, e: &Expr) {
        if let ExprKind::If { condition, then, otherwise } = &e.kind {
            self.first_choice(condition, then);
            self.otherwise(otherwise);
        }
    }

    /// Formats `if (c) a`.
    fn first_choice(&mut self, condition: &Expr, then: &Expr) {
        self.token(Kind::If);
        self.condition(condition);
        self.space();
        self.expression(then);
    }

    /// Formats `else if (d) b else e`, each `else` after an optional line break.
    fn otherwise(&mut self, e: &Expr) {
        let mut rest = e;
        loop {
            self.line();
            self.token(Kind::Else);
            self.space();
            let ExprKind::If { condition, then, otherwise } = &rest.kind else { break };
            self.first_choice(condition, then);
            rest = otherwise;
        }
        self.expression(rest);
    }

    /// Formats ` (condition)`.
    pub(super) fn condition(&mut self, condition: &Expr) {
        self.space();
        self.token(Kind::OpenParen);
        self.expression(condition);
        self.token(Kind::CloseParen);
    }
}

fn argument_layout(arguments: &[Argument]) -> Layout {
    match arguments {
        [only] if only.name.is_none() && !only.spread && breaks_inside(&only.value) => Layout::Hugged,
        _ if arguments.iter().all(|a| a.name.is_none() && is_short(&a.value)) => Layout::Filled,
        _ => Layout::Each,
    }
}

/// Returns `true` if an expression has suitable line breaks inside.
fn breaks_inside(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Unary { operand, .. } => breaks_inside(operand),
        ExprKind::Call { .. }
        | ExprKind::List(_)
        | ExprKind::Comprehension(_)
        | ExprKind::Binary { .. }
        | ExprKind::Anonymous(_)
        | ExprKind::Paren(_) => true,
        _ => false,
    }
}

/// Returns `true` if several such items may share a line of a list.
fn is_short(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_)
        | ExprKind::Quantity { .. }
        | ExprKind::Bool(_)
        | ExprKind::String(_)
        | ExprKind::Name(_) => true,
        ExprKind::Unary { operand, .. } => is_short(operand),
        ExprKind::Field { base, .. } => is_short(base),
        ExprKind::Index { base, index } => is_short(base) && is_short(index),
        ExprKind::Binary { left, right, .. } => is_leaf(left) && is_leaf(right),
        ExprKind::Error
        | ExprKind::Call { .. }
        | ExprKind::List(_)
        | ExprKind::Measured { .. }
        | ExprKind::Comprehension(_)
        | ExprKind::Slice { .. }
        | ExprKind::IsNone { .. }
        | ExprKind::If { .. }
        | ExprKind::At { .. }
        | ExprKind::Paren(_)
        | ExprKind::Anonymous(_)
        | ExprKind::Block(_) => false,
    }
}

fn is_leaf(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::Number(_) | ExprKind::Quantity { .. } | ExprKind::Name(_))
}

fn is_quantity(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Quantity { .. } | ExprKind::Measured { .. } => true,
        ExprKind::Unary { operand, .. } => is_quantity(operand),
        _ => false,
    }
}

fn precedence(op: BinaryOp) -> u8 {
    match op {
        BinaryOp::Or => 0,
        BinaryOp::And => 1,
        BinaryOp::Less
        | BinaryOp::LessEqual
        | BinaryOp::Greater
        | BinaryOp::GreaterEqual
        | BinaryOp::Equal
        | BinaryOp::NotEqual => 2,
        BinaryOp::Add | BinaryOp::Subtract => 3,
        BinaryOp::Multiply | BinaryOp::Divide => 4,
        BinaryOp::Power => 5,
    }
}

pub(super) fn operator(op: BinaryOp) -> Kind {
    match op {
        BinaryOp::Or => Kind::Or,
        BinaryOp::And => Kind::And,
        BinaryOp::Less => Kind::Less,
        BinaryOp::LessEqual => Kind::LessEqual,
        BinaryOp::Greater => Kind::Greater,
        BinaryOp::GreaterEqual => Kind::GreaterEqual,
        BinaryOp::Equal => Kind::Equal,
        BinaryOp::NotEqual => Kind::NotEqual,
        BinaryOp::Add => Kind::Plus,
        BinaryOp::Subtract => Kind::Minus,
        BinaryOp::Multiply => Kind::Star,
        BinaryOp::Divide => Kind::Slash,
        BinaryOp::Power => Kind::Caret,
    }
}
