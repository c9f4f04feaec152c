//! Checks calls of built-in functions.

use super::builtins::{Builtin, RateOf, Shape, Signature};
use super::dim::Dim;
use super::infer::Checker;
use super::symbols::with_article;
use super::tree::*;
use super::types::Type;
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Base, Dimension, Rational};
use crate::ir::Op;
use crate::span::Span;

impl<'a> Checker<'a> {
    pub(super) fn builtin_call(
        &mut self,
        builtin: Builtin,
        name: &'a ast::Ident,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        match builtin {
            Builtin::Operation(signature) => self.operation(signature, arguments, span),
            Builtin::Extreme(op) => self.extreme(op, &name.name, arguments, span),
            Builtin::Sqrt => self.square_root(&name.name, arguments, span),
            Builtin::Derivative => self.derivative(arguments, span),
            Builtin::Gradient => self.gradient(arguments, span),
            Builtin::Solve(search) => self.solution(search, arguments, span),
            Builtin::Spline => self.spline(arguments, span),
            Builtin::Print => {
                self.refuse_names("print", arguments);
                let values: Vec<Expr> = arguments.iter().map(|a| self.printable(&a.value)).collect();
                Expr { kind: Kind::Print(values, self.shown_system()), ty: Type::Unit, span }
            }
            Builtin::Assert => self.assertion(arguments, span),
            Builtin::Len => {
                let Some([array]) = self.plain("len", arguments, span, ["array"]) else {
                    return Expr::error(span);
                };
                let array = self.as_value(|c| c.expr(array));
                let element = self.store.fresh();
                self.expect(&Type::array(element), &array, "the argument of `len`", None);
                Expr { kind: Kind::Len(Box::new(array)), ty: Type::number(), span }
            }
            Builtin::Sum => self.sum(arguments, span),
            Builtin::Sort => {
                let Some([array]) = self.plain("sort", arguments, span, ["array"]) else {
                    return Expr::error(span);
                };
                let array = self.as_value(|c| c.expr(array));
                self.of_numbers(Standard::Sort, "sort", array, span)
            }
            Builtin::Push => {
                self.check_loosely(arguments);
                self.report(
                    Diagnostic::error("E0311", "`push` is a statement", span, "has no value")
                        .help("write `push(array, value);` on its own"),
                );
                Expr::error(span)
            }
        }
    }

    /// Checks `min` or `max`, of numbers or of an array.
    fn extreme(&mut self, op: Op, name: &str, arguments: &'a [ast::Argument], span: Span) -> Expr {
        self.refuse_names(name, arguments);
        if let [array] = arguments {
            let array = self.as_value(|c| c.expr(&array.value));
            if matches!(self.store.known(&array.ty), Type::Number(_)) {
                return self.wrong_count(name, span);
            }
            self.solve_open_constraints(std::iter::once(&array.ty));
            if self.is_array_of_observables(&array.ty) {
                return self.extreme_observable(op, array, span);
            }
            let function = if op == Op::Min { Standard::Smallest } else { Standard::Largest };
            return self.of_numbers(function, name, array, span);
        }
        if arguments.is_empty() {
            return self.wrong_count(name, span);
        }
        let ty = self.fresh_number();
        let values: Vec<Expr> = arguments.iter().map(|a| self.expr(&a.value)).collect();
        let mut observes = false;
        for value in &values {
            let shown = with_article(&self.store.show(&values[0].ty));
            let cause = Some((values[0].span, format!("this is {shown}")));
            let (number, is_observable) = self.number_of(value);
            observes |= is_observable;
            self.expect(&ty, &number, format_args!("an argument of `{}`", name), cause);
        }
        let ty = self.observable_if(ty, observes);
        let mut values = values.into_iter();
        let first = values.next().unwrap_or_else(|| Expr::error(span));
        values.fold(first, |a, b| Expr { kind: Kind::Op(op, vec![a, b]), ty: ty.clone(), span })
    }

    fn square_root(&mut self, name: &str, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let Some([x]) = self.plain(name, arguments, span, ["x"]) else {
            return Expr::error(span);
        };
        let x = self.expr(x);
        let dim = self.store.fresh_dim();
        let (number, observes) = self.number_of(&x);
        self.expect(&Type::Number(dim.clone()), &number, "the argument of `sqrt`", None);
        let half = Rational::new(1, 2).unwrap_or(Rational::ONE);
        let root = self.store.dim(&dim).power(half).unwrap_or_else(Dim::none);
        let ty = self.observable_if(Type::Number(root), observes);
        Expr { kind: Kind::Op(Op::Sqrt, vec![x]), ty, span }
    }

    fn assertion(&mut self, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let parameters = [("condition", false), ("message", true)];
        let given = self.match_arguments("assert", &parameters, arguments, span).unwrap_or_default();
        let [Some(written), message] = given[..] else { return Expr::error(span) };
        let condition = self.as_value(|c| c.expr(&written.value));
        self.expect(&Type::Bool, &condition, "the condition of `assert`", None);
        // The message already contains the value of a side that it consists of.
        let shown = message.map_or("", |message| self.text(message.value.span));
        let message = match message {
            Some(message) => {
                let message = self.as_value(|c| c.expr(&message.value));
                self.expect(&Type::String, &message, "the message", None);
                message
            }
            None => {
                Expr { kind: Kind::Text(self.text(written.value.span).to_string()), ty: Type::String, span }
            }
        };
        let sides = match &condition.kind {
            Kind::Binary(op, a, b) if op.compares() => Some([a, b].map(|side| {
                let text = self.text(side.span);
                (text != shown).then(|| text.to_string())
            })),
            _ => None,
        };
        let assertion = Assertion { condition, message, sides, system: self.shown_system() };
        Expr { kind: Kind::Assert(Box::new(assertion)), ty: Type::Unit, span }
    }

    /// Rejects named arguments: the parameters of a variadic function have no names.
    fn refuse_names(&mut self, function: &str, arguments: &[ast::Argument]) {
        for argument in arguments {
            let Some((name, _)) = &argument.name else { continue };
            let written = Span { end: argument.value.span.start, ..name.span };
            self.report(
                Diagnostic::error(
                    "E0205",
                    format!("`{function}` has no parameter `{}`", name.name),
                    name.span,
                    "has no named parameters",
                )
                .help(format!("omit the names: `{function}(a, b)`"))
                .suggest(format!("remove `{} =`", name.name), written, ""),
            );
        }
    }

    fn wrong_count(&mut self, function: &str, span: Span) -> Expr {
        let wanted = "two or more numbers, or an array of numbers";
        self.report(
            Diagnostic::error(
                "E0206",
                format!("`{function}` takes {wanted}"),
                span,
                "wrong number of arguments",
            )
            .help(format!("give `{function}` {wanted}")),
        );
        Expr::error(span)
    }

    /// Matches the arguments of a built-in function to its parameters, in their order.
    pub(super) fn plain<const N: usize>(
        &mut self,
        function: &str,
        arguments: &'a [ast::Argument],
        span: Span,
        parameters: [&str; N],
    ) -> Option<[&'a ast::Expr; N]> {
        let parameters: Vec<(&str, bool)> = parameters.iter().map(|name| (*name, false)).collect();
        let given = self.match_arguments(function, &parameters, arguments, span)?;
        let values: Vec<&ast::Expr> = given.into_iter().flatten().map(|argument| &argument.value).collect();
        values.try_into().ok()
    }

    fn operation(
        &mut self,
        signature: &'static Signature,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let parameters: Vec<(&str, bool)> =
            signature.parameters.iter().map(|(name, _)| (*name, false)).collect();
        let Some(given) = self.match_arguments(signature.name, &parameters, arguments, span) else {
            return Expr::error(span);
        };
        let (d, e) = (self.store.fresh_dim(), self.store.fresh_dim());
        let around = self.symbolic;
        self.symbolic |= signature.symbolic;
        let (mut values, mut observes) = (Vec::new(), false);
        for ((name, shape), argument) in signature.parameters.iter().zip(given.into_iter().flatten()) {
            let value = self.whole(&argument.value);
            let ty = shape_type(*shape, &d, &e);
            // Functions of numbers also take observables; vectors and frames have no observables.
            let numeric = matches!(shape_type(signature.result, &d, &e), Type::Number(_));
            let (number, is_observable) = self.number_of(&value);
            let given = if numeric { &number } else { &value };
            observes |= numeric && is_observable;
            self.expect(&ty, given, format_args!("`{name}` of `{}`", signature.name), None);
            values.push(value);
        }
        self.symbolic = around;
        if let (Op::Rotate, [_, axis]) = (signature.op, values.as_mut_slice()) {
            self.check_axis(axis);
        }
        let ty = self.observable_if(shape_type(signature.result, &d, &e), observes);
        let result = Expr { kind: Kind::Op(signature.op, values), ty, span };
        if signature.symbolic && !self.symbolic { self.evaluate_now(result, signature.name) } else { result }
    }
}

fn shape_type(shape: Shape, d: &Dim, e: &Dim) -> Type {
    let known = |exponents| Dim::known(Dimension::whole(exponents));
    match shape {
        Shape::Number => Type::number(),
        Shape::Angle => Type::Number(Dim::known(Dimension::of(Base::Angle))),
        Shape::Any => Type::Number(d.clone()),
        Shape::Product => Type::Number(d.times(e)),
        Shape::VectorAny => Type::Vector(d.clone()),
        Shape::VectorOther => Type::Vector(e.clone()),
        Shape::VectorProduct => Type::Vector(d.times(e)),
        Shape::VectorLength => Type::Vector(known([1, 0, 0, 0, 0])),
        Shape::Axis => Type::Vector(Dim::none()),
        Shape::VectorRate(RateOf::Length, n) => Type::Vector(known([1, 0, -i32::from(n), 0, 0])),
        Shape::VectorRate(RateOf::Angle, n) => Type::Vector(known([0, 0, -i32::from(n), 1, 0])),
        Shape::Transform => Type::Transform,
    }
}
