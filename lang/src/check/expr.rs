//! Checks expressions: converts syntax to the typed tree.

use super::infer::Checker;
use super::records::handle_field;
use super::rules::{self, Rule};
use super::symbols::{Constant, Resolution, with_article};
use super::tree::*;
use super::types::{Store, Type};
use crate::ast::{self, BinaryOp, ExprKind, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::dimension::{Dimension, Rational};
use crate::ir::Op;
use crate::span::Span;
use crate::units::{UnitSystem, powered};
use calyx_abi::units::to_si;

/// The context of an expression.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Position {
    /// A complete initializer or argument: literals without a unit take their dimension from its
    /// use.
    Whole,
    /// An operand: a literal without a unit is a pure number.
    Part,
}

impl<'a> Checker<'a> {
    /// Checks a complete initializer, argument, returned or assigned value.
    pub fn whole(&mut self, e: &'a ast::Expr) -> Expr {
        self.expr_at(e, Position::Whole)
    }

    pub fn expr(&mut self, e: &'a ast::Expr) -> Expr {
        self.expr_at(e, Position::Part)
    }

    /// Checks in a value context, where expressions are evaluated immediately.
    pub fn as_value<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let symbolic = std::mem::replace(&mut self.symbolic, false);
        let result = work(self);
        self.symbolic = symbolic;
        result
    }

    pub fn as_symbolic<T>(&mut self, work: impl FnOnce(&mut Self) -> T) -> T {
        let symbolic = std::mem::replace(&mut self.symbolic, true);
        let result = work(self);
        self.symbolic = symbolic;
        result
    }

    pub fn expr_at(&mut self, e: &'a ast::Expr, given: Position) -> Expr {
        let accepted = std::mem::take(&mut self.may_be_absent);
        let tested = std::mem::take(&mut self.tests_presence);
        if let Some(captured) = self.captured_value(e.span) {
            return captured;
        }
        if let ExprKind::Paren(inner) = &e.kind {
            (self.may_be_absent, self.tests_presence) = (accepted, tested);
            let inner = self.expr_at(inner, given);
            return Expr { span: e.span, ..inner };
        }
        if accepted && let ExprKind::If { condition, then, otherwise } = &e.kind {
            return self.optional_choice([condition, then, otherwise], given, e.span);
        }
        let checked = self.expr_of_any_type(e, given);
        // A field that was tested before is optional.
        if self.is_present(e) {
            self.make_optional(&checked);
        }
        match self.store.known(&checked.ty) {
            Type::Optional(_) => self.presence(e, checked, accepted, tested),
            _ => checked,
        }
    }

    fn expr_of_any_type(&mut self, e: &'a ast::Expr, given: Position) -> Expr {
        let position = if given == Position::Whole && is_bare(e) { Position::Whole } else { Position::Part };
        let span = e.span;
        let (kind, ty) = match &e.kind {
            ExprKind::Error => (Kind::Error, Type::Error),
            ExprKind::Number(value) => self.number(*value, position),
            ExprKind::Quantity { value, unit, exponent, .. } => self.quantity(*value, unit, *exponent),
            ExprKind::Bool(value) => (Kind::Bool(*value), Type::Bool),
            ExprKind::String(parts) => self.string(parts),
            ExprKind::Name(name) => return self.name(name, span),
            ExprKind::Field { base, field } => return self.field(base, field, span),
            ExprKind::Call { callee, arguments } => return self.call_with_records(callee, arguments, span),
            ExprKind::Index { base, index } => return self.index(base, index, span),
            ExprKind::Unary { op, operand } => {
                let value = self.expr_at(operand, position);
                let ty = match op {
                    UnaryOp::Not => {
                        self.expect(&Type::Bool, &value, "the operand of `!`", None);
                        Type::Bool
                    }
                    UnaryOp::Plus | UnaryOp::Minus => {
                        let kind = ConstraintKind::Additive(value.ty.clone());
                        self.constrain(Constraint { kind, span: value.span });
                        value.ty.clone()
                    }
                };
                match (op, &value.kind) {
                    (UnaryOp::Plus, _) => (value.kind, ty),
                    _ => (Kind::Unary(*op, Box::new(value)), ty),
                }
            }
            ExprKind::Binary { op, op_span, left, right } => {
                return self.binary(*op, *op_span, left, right, position, span);
            }
            ExprKind::Slice { base, low, high } => {
                return self.slice(base, low.as_deref(), high.as_deref(), span);
            }
            ExprKind::List(elements) => return self.list(elements, given, span),
            ExprKind::Measured { elements, unit, exponent, .. } => self.measured(elements, unit, *exponent),
            ExprKind::Comprehension(parts) => return self.as_value(|c| c.comprehension(parts, span)),
            ExprKind::Anonymous(_) => {
                self.report(
                    Diagnostic::error(
                        "E0882",
                        "an anonymous function is the argument of a parameter that is a function",
                        span,
                        "functions are not values",
                    )
                    .help(
                        "declare `function name(in x) := ...;` and call it, or pass the anonymous function to \
                         `solve`, `minimize`, or a function that calls its parameter",
                    ),
                );
                return Expr::error(span);
            }
            ExprKind::IsNone { value, negated: false } => return self.is_none(value, span),
            ExprKind::IsNone { value, negated: true } => {
                let absent = self.is_none(value, span);
                (Kind::Unary(UnaryOp::Not, Box::new(absent)), Type::Bool)
            }
            ExprKind::If { condition, then, otherwise } => {
                let (yes, no) = self.facts(condition);
                let condition = self.expr(condition);
                self.expect(&Type::Bool, &condition, "the condition", None);
                let a = self.supposing(yes, |c| c.expr_at(then, given));
                let b = self.supposing(no, |c| c.expr_at(otherwise, given));
                let (a, b) = self.alike(a, b);
                let cause =
                    Some((a.span, format!("the other branch is {}", with_article(&self.store.show(&a.ty)))));
                let ty = a.ty.clone();
                self.expect(&ty, &b, "this branch", cause);
                (Kind::If(Box::new(condition), Box::new(a), Box::new(b)), ty)
            }
            ExprKind::At { value, symbol, at } => return self.at(value, symbol, at, span),
            ExprKind::Paren(inner) => {
                let inner = self.expr_at(inner, given);
                return Expr { span, ..inner };
            }
            ExprKind::Block(block) => return self.symbolic_block(block),
        };
        Expr { kind, ty, span }
    }

    fn number(&mut self, value: f64, position: Position) -> (Kind, Type) {
        if value == 0.0 {
            rules::applied(Rule::ZeroLiteral);
            return (Kind::Number(value), Type::Number(self.store.fresh_dim()));
        }
        match (position, self.system()) {
            (Position::Whole, Some(system)) => {
                rules::applied(Rule::BareLiteral);
                let dim = self.store.fresh_literal_dim();
                (Kind::Bare(value, dim.clone(), system), Type::Number(dim))
            }
            _ => {
                rules::applied(Rule::PureLiteral);
                (Kind::Number(value), Type::number())
            }
        }
    }

    pub(super) fn quantity(&mut self, value: f64, unit: &ast::Ident, exponent: i32) -> (Kind, Type) {
        let known = self.unit_named(unit);
        if known.is_none() && !matches!(self.names.uses.get(&unit.span), Some(Resolution::OwnUnit(_))) {
            self.unknown_unit(unit, "a name right after a number must be a unit");
        }
        let counts = match self.names.uses.get(&unit.span) {
            Some(Resolution::Unit(unit)) => unit.counted().power(Rational::integer(exponent)),
            _ => None,
        };
        let unit = known.and_then(|unit| powered(&unit, exponent));
        match unit.and_then(|unit| Some((unit.factor, Dimension::from_exponents(unit.dimension)?))) {
            Some((factor, dimension)) => {
                let dimension = counts.unwrap_or(dimension);
                (Kind::Number(to_si(value, factor)), Type::quantity(dimension))
            }
            None => (Kind::Error, Type::Error),
        }
    }

    fn string(&mut self, parts: &'a [ast::StringPart]) -> (Kind, Type) {
        let pieces: Vec<TextPart> = parts
            .iter()
            .map(|part| match part {
                ast::StringPart::Text(text) => TextPart::Text(text.clone()),
                ast::StringPart::Value(value, format) => {
                    let value = self.printable(value);
                    let style = format.as_ref().map(|format| self.style(&value, format));
                    TextPart::Value(Box::new(value), style)
                }
            })
            .collect();
        let kind = match pieces.as_slice() {
            [] => Kind::Text(String::new()),
            [TextPart::Text(text)] => Kind::Text(text.clone()),
            _ => Kind::Format(pieces, self.shown_system()),
        };
        (kind, Type::String)
    }

    /// Returns the format of a value in a string, and checks that it applies to the value.
    fn style(&mut self, value: &Expr, format: &'a ast::Format) -> Style {
        let unit = format.unit.as_ref().and_then(|unit| self.format_unit(unit));
        let digits = format.digits.is_some() || format.scientific;
        let dimension = unit.as_ref().map(|(_, dimension)| *dimension);
        let kind = ConstraintKind::Styled(value.ty.clone(), dimension, digits);
        self.constrain(Constraint { kind, span: value.span });
        Style {
            width: format.width,
            digits: format.digits,
            scientific: format.scientific,
            unit: unit.map(|(unit, _)| unit),
        }
    }

    /// Checks a value to be written into a string.
    pub(super) fn printable(&mut self, value: &'a ast::Expr) -> Expr {
        let value = self.as_value(|c| c.expr(value));
        let kind = ConstraintKind::Printable(value.ty.clone());
        self.constrain(Constraint { kind, span: value.span });
        value
    }

    /// Converts an observable in a `:=` to its value as a number, and an expression that is stored
    /// as a value to the expression.
    pub(super) fn observed(&mut self, e: Expr) -> Expr {
        if self.symbolic {
            self.solve_open_constraints(std::iter::once(&e.ty));
        }
        match (self.symbolic, self.store.known(&e.ty)) {
            (true, Type::Observable(dim)) => {
                let (span, dim) = (e.span, dim.clone());
                Expr { kind: Kind::Observe(Box::new(e)), ty: Type::Number(dim), span }
            }
            (true, Type::Symbolic(inner)) => {
                let (span, ty) = (e.span, (**inner).clone());
                Expr { kind: Kind::Part(Box::new(e)), ty, span }
            }
            _ => e,
        }
    }

    fn field(&mut self, base: &'a ast::Expr, field: &'a ast::Ident, span: Span) -> Expr {
        if let ExprKind::Name(name) = &base.kind
            && let Some(Resolution::Module(_)) = self.names.uses.get(&name.span)
        {
            return self.name(field, span);
        }
        if let Some(id) = self.enum_of(base) {
            return self.choice(id, field, span);
        }
        // A field of a `:=` expression may be a component of a vector that depends on time.
        let base = self.expr(base);
        self.named_fields.push((field.clone(), base.ty.clone()));
        let component = component(&field.name);
        let shallow = self.store.shallow(&base.ty);
        match (&shallow, component) {
            (Type::Error, _) => Expr::error(span),
            (Type::Record(id), _) => match self.store.field(*id, &field.name) {
                Some((at, ty)) => {
                    self.observed(Expr { kind: Kind::TupleElement(Box::new(base), at), ty, span })
                }
                None => {
                    self.report(self.no_field(&shallow, &field.name, field.span));
                    Expr::error(span)
                }
            },
            (Type::Vector(dim), Some(op)) => {
                Expr { kind: Kind::Op(op, vec![base]), ty: Type::Number(dim.clone()), span }
            }
            (Type::Handle(handle), _) if let Some((function, ty)) = handle_field(handle, &field.name) => {
                self.observed(Expr { kind: Kind::Standard(function, vec![base]), ty, span })
            }
            (Type::Unknown(_), Some(op)) if self.symbolic => {
                let (vector, dim) = self.fresh_vector();
                self.expect(&vector, &base, format_args!("the value before `.{}`", field.name), None);
                Expr { kind: Kind::Op(op, vec![base]), ty: Type::Number(dim), span }
            }
            (Type::Unknown(_), _) => {
                let ty = self.store.fresh();
                let kind = ConstraintKind::Field(
                    base.ty.clone(),
                    field.name.to_string(),
                    ty.clone(),
                    FieldUse::Read,
                );
                self.constrain(Constraint { kind, span: field.span });
                Expr { kind: Kind::Field(Box::new(base), field.name.to_string()), ty, span }
            }
            _ => {
                self.report(self.no_field(&shallow, &field.name, field.span));
                Expr::error(span)
            }
        }
    }

    fn index(&mut self, base: &'a ast::Expr, index: &'a ast::Expr, span: Span) -> Expr {
        let brackets = self.symbolic && self.names_brackets(base);
        let base = if brackets { self.expr(base) } else { self.as_value(|c| c.expr(base)) };
        let index = self.as_value(|c| c.expr(index));
        let constant = constant_index(&index, &self.store);
        if brackets && constant.is_none() && self.is_brackets(&base) {
            self.report(
                Diagnostic::error(
                    "E0305",
                    "the index of symbolic brackets must be constant",
                    index.span,
                    "known only at run time",
                )
                .help("write the index as a number, such as `[0]`"),
            );
            return Expr::error(span);
        }
        self.expect(&Type::number(), &index, "an index", None);
        let element = self.store.fresh();
        let tuple = matches!(self.store.known(&base.ty), Type::Tuple(_));
        self.constrain(Constraint {
            kind: ConstraintKind::Index(base.ty.clone(), constant.filter(|_| tuple), element.clone()),
            span,
        });
        let kind = match constant {
            Some(at) if tuple => Kind::TupleElement(Box::new(base), at),
            _ => Kind::Index(Box::new(base), Box::new(index)),
        };
        self.observed(Expr { kind, ty: element, span })
    }

    /// Checks a bracket expression: an array, unless the types of its elements differ.
    fn list(&mut self, elements: &'a [ast::Expr], given: Position, span: Span) -> Expr {
        let elements: Vec<Expr> = elements.iter().map(|e| self.element(e, given)).collect();
        self.solve_open_constraints(elements.iter().map(|e| &e.ty));
        let elements = self.all_alike(elements);
        let first = elements.first().map(|e| e.ty.clone());
        if first.is_none_or(|first| elements.iter().all(|e| !self.store.differ(&first, &e.ty))) {
            let element = self.store.fresh();
            for e in &elements {
                self.expect(&element, e, "an element of this array", None);
            }
            return Expr { kind: Kind::Array(elements), ty: Type::array(element), span };
        }
        let ty = Type::Tuple(elements.iter().map(|e| e.ty.clone()).collect());
        Expr { kind: Kind::Tuple(elements), ty, span }
    }

    fn binary(
        &mut self,
        op: BinaryOp,
        op_span: Span,
        left: &'a ast::Expr,
        right: &'a ast::Expr,
        position: Position,
        span: Span,
    ) -> Expr {
        if op == BinaryOp::Power {
            return self.power(left, right, span);
        }
        if let Some((operand, absent)) = self.compared_with_none(op, left, right) {
            return self.wrong_test(operand, absent, span);
        }
        let a = self.expr_at(left, position);
        let supposed = match op {
            BinaryOp::And => self.facts(left).0,
            BinaryOp::Or => self.facts(left).1,
            _ => Default::default(),
        };
        let b = self.supposing(supposed, |c| c.expr_at(right, position));
        self.combined(op, op_span, a, b, span)
    }

    /// Applies an operator other than `^` to checked operands.
    pub(super) fn combined(&mut self, op: BinaryOp, op_span: Span, a: Expr, b: Expr, span: Span) -> Expr {
        let (a, b) = match op {
            BinaryOp::Add | BinaryOp::Subtract => self.alike(a, b),
            _ => (a, b),
        };
        let ty = match op {
            BinaryOp::And | BinaryOp::Or => {
                let what = if op == BinaryOp::And { "an operand of `&`" } else { "an operand of `|`" };
                self.expect(&Type::Bool, &a, what, None);
                self.expect(&Type::Bool, &b, what, None);
                Type::Bool
            }
            BinaryOp::Less | BinaryOp::LessEqual | BinaryOp::Greater | BinaryOp::GreaterEqual => {
                let number = self.fresh_number();
                self.expect(&number, &a, "what is ordered", None);
                self.same(&a, &b, op_span, "compare");
                Type::Bool
            }
            BinaryOp::Equal | BinaryOp::NotEqual => {
                if self.same(&a, &b, op_span, "compare") {
                    let kind = ConstraintKind::Comparable(a.ty.clone());
                    self.constrain(Constraint { kind, span: a.span });
                }
                Type::Bool
            }
            BinaryOp::Add | BinaryOp::Subtract => {
                let verb = if op == BinaryOp::Add { "add" } else { "subtract" };
                if self.same(&a, &b, op_span, verb) {
                    let kind = ConstraintKind::Additive(a.ty.clone());
                    self.constrain(Constraint { kind, span: a.span });
                }
                a.ty.clone()
            }
            BinaryOp::Multiply | BinaryOp::Divide => {
                self.note_reciprocal(op, &a, &b, span);
                let result = self.store.fresh();
                let (l, r) = (a.ty.clone(), b.ty.clone());
                let kind = if op == BinaryOp::Multiply {
                    ConstraintKind::Multiply(l, r, result.clone())
                } else {
                    ConstraintKind::Divide(l, r, result.clone())
                };
                self.constrain(Constraint { kind, span: op_span });
                self.turned(result, &a, &b)
            }
            // Handled above.
            BinaryOp::Power => Type::Error,
        };
        Expr { kind: Kind::Binary(op, Box::new(a), Box::new(b)), ty, span }
    }

    fn power(&mut self, left: &'a ast::Expr, right: &'a ast::Expr, span: Span) -> Expr {
        let (base, exponent) = (self.expr(left), self.expr(right));
        self.expect(&Type::number(), &exponent, "an exponent", None);
        let dim = self.store.fresh_dim();
        let (number, observes) = self.number_of(&base);
        self.expect(&Type::Number(dim.clone()), &number, "the base of `^`", None);
        let ty = match super::constant::number(&exponent, &self.store) {
            Some(value) => match Rational::from_f64(value).and_then(|r| self.store.dim(&dim).power(r)) {
                Some(power) => Type::Number(power),
                None => self.pure_base(&number, "an exponent that is not a simple fraction"),
            },
            None => self.pure_base(&number, "an exponent that is not constant"),
        };
        let ty = self.observable_if(ty, observes);
        Expr { kind: Kind::Binary(BinaryOp::Power, Box::new(base), Box::new(exponent)), ty, span }
    }

    fn pure_base(&mut self, base: &Expr, why: &str) -> Type {
        self.expect(&Type::number(), base, format_args!("the base of {why}"), None);
        Type::number()
    }

    fn at(&mut self, value: &'a ast::Expr, symbol: &ast::Ident, at: &'a ast::Expr, span: Span) -> Expr {
        let Some((sym, dim)) = self.symbol(symbol) else {
            return Expr::error(span);
        };
        let time = self.whole(at);
        let what = format!("the value of `{}`", symbol.name);
        self.expect(&Type::Number(dim), &time, what, None);
        let inner = self.as_symbolic(|c| c.expr(value));
        let ty = inner.ty.clone();
        if self.symbolic {
            return Expr { kind: Kind::At(Box::new(inner), sym, Box::new(time)), ty, span };
        }
        match sym {
            Sym::Time => {
                let name = match &inner.kind {
                    Kind::Def(def) => self.defs[def.0 as usize].name.clone(),
                    _ => "at".to_string(),
                };
                let def = self.make_def(&name, inner, span);
                Expr { kind: Kind::Eval(def, Some(Box::new(time))), ty, span }
            }
            Sym::Param(_) | Sym::Argument(_) => {
                let whole = Expr { kind: Kind::At(Box::new(inner), sym, Box::new(time)), ty, span };
                self.evaluate_now(whole, "at")
            }
        }
    }

    /// Returns the unit system for displayed numbers of this file.
    pub(super) fn shown_system(&self) -> UnitSystem {
        self.system().unwrap_or_default()
    }
}

/// Returns `true` if literals without a unit in this expression take their dimension from its use:
/// a signed literal, a literal times a basis vector, and sums of these. Elements of arrays and arms
/// of conditional expressions are treated separately.
pub fn is_bare(e: &ast::Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_) => true,
        ExprKind::Paren(inner) => is_bare(inner),
        ExprKind::Unary { op: UnaryOp::Plus | UnaryOp::Minus, operand } => is_bare(operand),
        ExprKind::Binary { op: BinaryOp::Add | BinaryOp::Subtract, left, right, .. } => {
            is_bare(left) && is_bare(right)
        }
        ExprKind::Binary { op: BinaryOp::Multiply, left, right, .. } => {
            (is_literal(left) && is_basis(right)) || (is_basis(left) && is_literal(right))
        }
        _ => false,
    }
}

fn is_literal(e: &ast::Expr) -> bool {
    match &e.kind {
        ExprKind::Number(_) => true,
        ExprKind::Paren(inner) => is_literal(inner),
        ExprKind::Unary { op: UnaryOp::Plus | UnaryOp::Minus, operand } => is_literal(operand),
        _ => false,
    }
}

fn is_basis(e: &ast::Expr) -> bool {
    match &e.kind {
        ExprKind::Name(name) => matches!(super::builtins::constant(&name.name), Some(Constant::Basis(_))),
        ExprKind::Paren(inner) => is_basis(inner),
        _ => false,
    }
}

/// Returns the value of a constant index. Indices of tuples must be constant.
pub(super) fn constant_index(index: &Expr, store: &Store) -> Option<usize> {
    let value = super::constant::number(index, store)?;
    (value >= 0.0 && value.fract() == 0.0 && value < 1e6).then_some(value as usize)
}

/// Returns the operation for a component of a vector.
pub(super) fn component(field: &str) -> Option<Op> {
    match field {
        "x" => Some(Op::X),
        "y" => Some(Op::Y),
        "z" => Some(Op::Z),
        _ => None,
    }
}
