//! Checks loops over arrays and ranges, comprehensions, slices, and functions of arrays.
//!
//! They become the `for` loop, the assignments and the `push` that a program could write itself,
//! with hidden variables. So the limits of steps and memory apply to them, and neither evaluator
//! has nodes of its own for them.

use super::constant;
use super::dependence::Region;
use super::infer::Checker;
use super::symbols::{Resolution, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, Comprehension, ExprKind, UnaryOp, Values};
use crate::diagnostic::Diagnostic;
use crate::ir::Op;
use crate::span::Span;

/// The parts of a `for` loop over values.
struct Loop {
    /// Evaluates the array or the limits, once.
    init: Vec<Stmt>,
    condition: Expr,
    step: Stmt,
    /// The value of the loop's variable in each pass.
    element: Expr,
    span: Span,
}

impl Loop {
    fn statement(self, body: Vec<Stmt>) -> Stmt {
        let span = self.span;
        let block = |statements| Box::new(Stmt { kind: StmtKind::Block(statements), span });
        let init = block(self.init);
        let kind = StmtKind::For {
            init,
            condition: Some(self.condition),
            step: Box::new(self.step),
            body: block(body),
        };
        Stmt { kind, span }
    }
}

impl<'a> Checker<'a> {
    /// Checks `for (variable in values) body`.
    pub(super) fn for_each(
        &mut self,
        variable: &'a ast::Ident,
        values: &'a Values,
        body: &'a ast::Stmt,
    ) -> StmtKind {
        let Some(Resolution::Var(id)) = self.names.uses.get(&variable.span).copied() else {
            return StmtKind::Nothing;
        };
        let mut parts = self.loop_over(values, variable);
        for statement in &parts.init {
            statement.expressions().into_iter().for_each(|e| self.note_evaluated(e));
        }
        let element = std::mem::replace(&mut parts.element, Expr::error(variable.span));
        let inside = self.repeated(&[body], |c| {
            c.dependence.open(Region::Loop);
            c.dependence.decides(&parts.condition);
            let element = c.assign_element(id, variable, element);
            let body = c.statement(body);
            c.dependence.close();
            vec![element, body]
        });
        parts.statement(inside).kind
    }

    /// Checks `[element for variable in values if condition]`.
    pub(super) fn comprehension(&mut self, parts: &'a Comprehension, span: Span) -> Expr {
        if self.instance_sites.contains(&parts.element.span) && self.makes_instances(&parts.element) {
            return self.instances_for_each(parts, span);
        }
        let variable = &parts.variable;
        let Some(Resolution::Var(declared)) = self.names.uses.get(&variable.span).copied() else {
            return Expr::error(span);
        };
        let mut walk = self.loop_over(&parts.values, variable);
        let ty = self.variable_type(declared);
        let id = self.hidden_variable(&variable.name, variable.span, ty);
        let around = self.elements.insert(declared, id);
        let element = std::mem::replace(&mut walk.element, Expr::error(variable.span));
        let mut inside = vec![self.assign_element(id, variable, element)];
        let supposed = parts.condition.as_ref().map(|condition| self.facts(condition).0).unwrap_or_default();
        let condition = parts.condition.as_ref().map(|condition| {
            let checked = self.expr(condition);
            self.expect(&Type::Bool, &checked, "the condition of a comprehension", None);
            checked
        });
        let element = self.supposing(supposed, |c| match c.stored_expression(&parts.element) {
            Some(expression) => expression,
            None => c.stored(&parts.element),
        });
        match around {
            Some(around) => self.elements.insert(declared, around),
            None => self.elements.remove(&declared),
        };
        let place = self.collected(element.ty.clone(), span);
        let push = Stmt { kind: StmtKind::Push(place.clone(), element), span };
        inside.push(match condition {
            Some(condition) => Stmt { kind: StmtKind::If(condition, Box::new(push), None), span },
            None => push,
        });
        self.sequence(vec![start(&place), walk.statement(inside)], &place, span)
    }

    /// Checks `base[low .. high]`.
    pub(super) fn slice(
        &mut self,
        base: &'a ast::Expr,
        low: Option<&'a ast::Expr>,
        high: Option<&'a ast::Expr>,
        span: Span,
    ) -> Expr {
        self.as_value(|c| {
            let array = c.expr(base);
            let Some(element) =
                c.element_type(&array, "only arrays can be sliced", "put the values into brackets: `[a, b]`")
            else {
                return Expr::error(span);
            };
            let (values, keep) = c.keep("array", array);
            let low = match low {
                Some(low) => c.limit(low),
                None => number(0.0, span),
            };
            let high = match high {
                Some(high) => c.limit(high),
                None => length(values.clone()),
            };
            let (from, start_at) = c.keep("start", low);
            let end = Expr {
                kind: Kind::Standard(Standard::SliceEnd, vec![from.clone(), high, length(values.clone())]),
                ty: Type::number(),
                span,
            };
            let (end, end_at) = c.keep("end", end);
            let (at, count) = c.keep("index", from);
            let part = Expr {
                kind: Kind::Index(Box::new(values), Box::new(at.clone())),
                ty: element.clone(),
                span: nowhere(span),
            };
            let place = c.collected(element, span);
            let walk = Loop {
                init: vec![count],
                condition: less(at.clone(), end),
                step: increment(at),
                element: Expr::error(span),
                span,
            };
            let push = Stmt { kind: StmtKind::Push(place.clone(), part), span };
            let all = vec![keep, start_at, end_at, start(&place), walk.statement(vec![push])];
            c.sequence(all, &place, span)
        })
    }

    /// Checks `sum(array)`: numbers, vectors, or arrays of these.
    pub(super) fn sum(&mut self, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let Some([array]) = self.plain("sum", arguments, span, ["array"]) else {
            return Expr::error(span);
        };
        let array = self.as_value(|c| c.expr(array));
        let Some(term) = self.element_type(
            &array,
            "`sum` adds the elements of an array",
            "put the numbers into brackets: `sum([a, b])`",
        ) else {
            return Expr::error(span);
        };
        self.constrain(Constraint { kind: ConstraintKind::Additive(term.clone()), span: array.span });
        let (values, keep) = self.keep("array", array);
        self.solve_open_constraints(std::iter::once(&term));
        let zero = match self.store.shallow(&term) {
            Type::Observable(dim) => self.as_observable(Expr { ty: Type::Number(dim), ..number(0.0, span) }),
            _ => Expr { kind: Kind::Zero, ty: term.clone(), span },
        };
        let add = |a: Expr, b: Expr| Kind::Binary(BinaryOp::Add, Box::new(a), Box::new(b));
        self.folded((values, keep), term, zero, add, span)
    }

    /// Checks `min(array)` or `max(array)` of observables.
    pub(super) fn extreme_observable(&mut self, op: Op, array: Expr, span: Span) -> Expr {
        let Type::Array(term) = self.store.shallow(&array.ty) else { return Expr::error(span) };
        let (values, keep) = self.keep("array", array);
        // An array without elements has no extreme: the run reports the index.
        let first = Kind::Index(Box::new(values.clone()), Box::new(number(0.0, span)));
        let first = Expr { kind: first, ty: (*term).clone(), span };
        self.folded((values, keep), *term, first, |a, b| Kind::Op(op, vec![a, b]), span)
    }

    /// Returns the elements of an array combined in order. `start` is the value for an array
    /// without elements.
    fn folded(
        &mut self,
        (values, keep): (Expr, Stmt),
        term: Type,
        start: Expr,
        combine: impl FnOnce(Expr, Expr) -> Kind,
        span: Span,
    ) -> Expr {
        let (total, clear) = self.keep("total", start);
        let (at, count) = self.keep("index", number(0.0, span));
        let part = Expr {
            kind: Kind::Index(Box::new(values.clone()), Box::new(at.clone())),
            ty: term.clone(),
            span: nowhere(span),
        };
        let sum = Expr { kind: combine(total.clone(), part.clone()), ty: term, span: nowhere(span) };
        // The first term starts the sum: it also has the length of a sum of arrays.
        let first = less(at.clone(), number(1.0, span));
        let first = StmtKind::If(
            first,
            Box::new(assign(&total, part, span)),
            Some(Box::new(assign(&total, sum, span))),
        );
        let walk = Loop {
            init: vec![count],
            condition: less(at.clone(), length(values)),
            step: increment(at),
            element: Expr::error(span),
            span,
        };
        let walk = walk.statement(vec![Stmt { kind: first, span }]);
        let ty = total.ty.clone();
        let kind = Kind::Sequence(vec![keep, clear, walk], Box::new(Expr { span, ..total }));
        self.observed(Expr { kind, ty, span })
    }

    /// Checks a function of an array of numbers.
    pub(super) fn of_numbers(&mut self, function: Standard, name: &str, array: Expr, span: Span) -> Expr {
        let number = self.fresh_number();
        let array_type = Type::array(number.clone());
        self.expect(&array_type, &array, format_args!("the argument of `{name}`"), None);
        let ty = if function == Standard::Sort { array_type } else { number };
        Expr { kind: Kind::Standard(function, vec![array]), ty, span }
    }

    /// Checks numbers in brackets followed by a unit.
    pub(super) fn measured(
        &mut self,
        elements: &'a [ast::Expr],
        unit: &'a ast::Ident,
        exponent: i32,
    ) -> (Kind, Type) {
        let (_, ty) = self.quantity(1.0, unit, exponent);
        let mut all = Vec::new();
        for e in elements {
            let Some(value) = plain_number(e) else {
                let place = e.span;
                self.expr(e);
                self.report(
                    Diagnostic::error(
                        "E0850",
                        "a unit after brackets applies to numbers without units",
                        place,
                        "not a plain number",
                    )
                    .label(unit.span, "the unit")
                    .help("write the unit at each element, or multiply the array by it: `[a, b] * 1 mm`"),
                );
                return (Kind::Error, Type::Error);
            };
            let (kind, ty) = self.quantity(value.abs(), unit, exponent);
            let positive = Expr { kind, ty: ty.clone(), span: e.span };
            all.push(match value.is_sign_negative() {
                true => Expr { kind: Kind::Unary(UnaryOp::Minus, Box::new(positive)), ty, span: e.span },
                false => positive,
            });
        }
        (Kind::Array(all), Type::array(ty))
    }

    /// Applies an operator to the elements of an array, and returns the array of the results.
    pub(super) fn each_element(
        &mut self,
        constraint: &Constraint,
        kind: impl FnOnce(Type) -> ConstraintKind,
    ) -> Type {
        let part = self.store.fresh();
        self.constrain(Constraint { kind: kind(part.clone()), span: constraint.span });
        Type::array(part)
    }

    /// Checks the array, or the name of an enumeration, after the `in` of a loop.
    pub(super) fn elements_of(&mut self, values: &'a ast::Expr) -> Expr {
        self.choices_in_order(values).unwrap_or_else(|| self.as_value(|c| c.whole(values)))
    }

    /// Checks the values that a loop goes through.
    fn loop_over(&mut self, values: &'a Values, variable: &'a ast::Ident) -> Loop {
        let span = values.span();
        match values {
            Values::Elements(array) => {
                let array = self.elements_of(array);
                let element = self.element_type(
                    &array,
                    "a loop goes through an array or a range",
                    "write a range to count: `0 .. n`",
                );
                let element = element.unwrap_or(Type::Error);
                let (values, keep) = self.keep("array", array);
                let (at, count) = self.keep("index", number(0.0, span));
                let kind = Kind::Index(Box::new(values.clone()), Box::new(at.clone()));
                Loop {
                    init: vec![keep, count],
                    condition: less(at.clone(), length(values)),
                    step: increment(at),
                    element: Expr { kind, ty: element, span: nowhere(variable.span) },
                    span,
                }
            }
            Values::Range(low, high) => {
                let low = self.whole_number(low, Standard::RangeStart);
                let high = self.whole_number(high, Standard::RangeEnd);
                // Evaluated in this order.
                let (at, count) = self.keep("index", low);
                let (end, keep) = self.keep("end", high);
                Loop {
                    init: vec![count, keep],
                    condition: less(at.clone(), end),
                    step: increment(at.clone()),
                    element: at,
                    span,
                }
            }
        }
    }

    /// Returns the type of the elements of an array; reports any other type. `of_number` is the
    /// help for a number.
    fn element_type(&mut self, array: &Expr, rule: &str, of_number: &str) -> Option<Type> {
        self.solve_open_constraints(std::iter::once(&array.ty));
        let element = self.store.fresh();
        match self.store.shallow(&array.ty) {
            Type::Error => None,
            Type::Array(element) => Some(*element),
            Type::Unknown(_) => {
                self.expect(&Type::array(element.clone()), array, "the array", None);
                Some(element)
            }
            other => {
                let shown = with_article(&self.store.show(&other));
                let help = match other {
                    Type::Number(_) => of_number,
                    Type::Tuple(_) => {
                        "the elements of these brackets have different types; give them one type"
                    }
                    _ => "put the values into brackets: `[a, b]`",
                };
                self.report(
                    Diagnostic::error(
                        "E0301",
                        format!("{rule}, and this is {shown}"),
                        array.span,
                        format!("this is {shown}"),
                    )
                    .help(help),
                );
                None
            }
        }
    }

    /// Checks a limit of a slice.
    fn limit(&mut self, e: &'a ast::Expr) -> Expr {
        let value = self.expr(e);
        self.expect(&Type::number(), &value, "a limit of a slice", None);
        value
    }

    /// Checks a limit of a range; one that is not constant is checked when the loop starts.
    fn whole_number(&mut self, e: &'a ast::Expr, limit: Standard) -> Expr {
        let value = self.as_value(|c| c.expr(e));
        let what = if limit == Standard::RangeStart { "the start of a range" } else { "the end of a range" };
        self.expect(&Type::number(), &value, what, None);
        match constant::number(&value, &self.store) {
            _ if matches!(value.kind, Kind::Len(_)) => value,
            Some(known) if known.fract() == 0.0 => value,
            Some(known) if !known.is_infinite() || limit == Standard::RangeStart => {
                self.report(
                    Diagnostic::error(
                        "E0851",
                        format!("{what} must be a whole number, not {known}"),
                        value.span,
                        "not a whole number",
                    )
                    .help("a range counts by 1; compute other steps from the count: `0.5 * i`"),
                );
                value
            }
            _ => {
                let span = value.span;
                Expr { kind: Kind::Standard(limit, vec![value]), ty: Type::number(), span }
            }
        }
    }

    /// Stores a value in a hidden variable. Returns the variable and the assignment.
    pub(super) fn keep(&mut self, name: &str, value: Expr) -> (Expr, Stmt) {
        let (ty, span) = (value.ty.clone(), value.span);
        let id = self.hidden_variable(name, span, ty.clone());
        self.dependence.declare(id);
        let place = Place { variable: id, steps: Vec::new(), ty: ty.clone(), span };
        self.assigned(&place, &value);
        let variable = Expr { kind: Kind::Var(id), ty, span: nowhere(span) };
        (variable, Stmt { kind: StmtKind::Assign(place, value), span })
    }

    /// Returns the place of a new hidden array.
    fn collected(&mut self, element: Type, span: Span) -> Place {
        let ty = Type::array(element);
        let variable = self.hidden_variable("array", span, ty.clone());
        Place { variable, steps: Vec::new(), ty, span }
    }

    /// Returns the statements as an expression with the value of a place.
    fn sequence(&mut self, statements: Vec<Stmt>, place: &Place, span: Span) -> Expr {
        let value = Expr { kind: Kind::Var(place.variable), ty: place.ty.clone(), span };
        Expr { kind: Kind::Sequence(statements, Box::new(value)), ty: place.ty.clone(), span }
    }

    /// Assigns the value of a pass to the variable of a loop.
    fn assign_element(&mut self, id: VarId, name: &'a ast::Ident, element: Expr) -> Stmt {
        let ty = self.variable_type(id);
        self.expect(&ty, &element, format_args!("`{}`", name.name), None);
        self.dependence.declare(id);
        let place = Place { variable: id, steps: Vec::new(), ty, span: name.span };
        self.assigned(&place, &element);
        Stmt { kind: StmtKind::Assign(place, element), span: name.span }
    }
}

/// Returns an empty location at the start of a range, for an expression that is not written.
fn nowhere(span: Span) -> Span {
    Span { end: span.start, ..span }
}

fn number(value: f64, span: Span) -> Expr {
    Expr { kind: Kind::Number(value), ty: Type::number(), span: nowhere(span) }
}

fn length(array: Expr) -> Expr {
    let span = array.span;
    Expr { kind: Kind::Len(Box::new(array)), ty: Type::number(), span }
}

fn less(a: Expr, b: Expr) -> Expr {
    let span = nowhere(a.span);
    Expr { kind: Kind::Binary(BinaryOp::Less, Box::new(a), Box::new(b)), ty: Type::Bool, span }
}

fn increment(variable: Expr) -> Stmt {
    let span = variable.span;
    let one = Box::new(number(1.0, span));
    let sum =
        Expr { kind: Kind::Binary(BinaryOp::Add, Box::new(variable.clone()), one), ty: Type::number(), span };
    assign(&variable, sum, span)
}

/// Returns an assignment to a hidden variable.
fn assign(variable: &Expr, value: Expr, span: Span) -> Stmt {
    let Kind::Var(id) = variable.kind else { return Stmt { kind: StmtKind::Nothing, span } };
    let place = Place { variable: id, steps: Vec::new(), ty: variable.ty.clone(), span };
    Stmt { kind: StmtKind::Assign(place, value), span }
}

/// Returns the assignment of an empty array.
fn start(place: &Place) -> Stmt {
    let empty = Expr { kind: Kind::Array(Vec::new()), ty: place.ty.clone(), span: nowhere(place.span) };
    Stmt { kind: StmtKind::Assign(place.clone(), empty), span: place.span }
}

/// Returns the value of a literal number with or without sign.
fn plain_number(e: &ast::Expr) -> Option<f64> {
    match &e.kind {
        ExprKind::Number(value) => Some(*value),
        ExprKind::Unary { op: UnaryOp::Minus, operand } => plain_number(operand).map(|value| -value),
        ExprKind::Unary { op: UnaryOp::Plus, operand } => plain_number(operand),
        ExprKind::Paren(inner) => plain_number(inner),
        _ => None,
    }
}
