//! Symbolic expressions (`:=`): their definitions and captures, and checks of their uses.
//!
//! A `:=` is split into a symbolic part, an expression in `Time`, params and other `:=` names, and
//! the values that it captures when its binding executes. The captured values are stored in hidden
//! variables. A later expression that uses the name therefore inlines its symbolic part and still
//! uses the values of the binding.

use super::axes::has_symbols;
use super::branches::{Branch, OutputCaptures, calls_functions, in_branches, may_fail};
use super::dependence::Question;
use super::dim::Dim;
use super::infer::{Checker, Reaching};
use super::symbols::with_article;
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind};
use crate::diagnostic::Diagnostic;
use crate::hashed::{HashMap, HashSet};
use crate::span::Span;
use std::collections::BTreeSet;

/// A definition under construction.
struct Builder {
    name: String,
    /// The symbolic function whose body this is. Its arguments are symbols, and it captures
    /// nothing.
    function: Option<FuncId>,
    captures: Vec<(VarId, Expr)>,
    /// Variables already captured.
    known: HashMap<VarId, VarId>,
    on_time: bool,
    observes: bool,
    closed: bool,
    chosen: BTreeSet<VarId>,
    /// The branches of an output around the expression being split.
    branches: Vec<Branch>,
}

impl<'a> Checker<'a> {
    pub(super) fn time_as_value(&self, span: Span) -> Diagnostic {
        Diagnostic::error("E0501", "`Time` has no value here", span, "this is evaluated immediately").help(
            "bind the expression with `:=` to keep `Time` in it, or evaluate it with `... at Time = 0.1 s`",
        )
    }

    /// Checks a use of a `:=` name.
    pub(super) fn symbolic_name(&mut self, id: VarId, span: Span) -> Expr {
        let (name, declared, owner) = {
            let variable = self.variable(id);
            (variable.name.clone(), variable.span, variable.owner)
        };
        let reaching = match self.reaching.get(&id) {
            Some(_) if self.graphs.foreign.contains(&id) => Some(Reaching::Several),
            Some(_) if owner != self.function && self.rebound.contains(&id) => Some(Reaching::Several),
            other => other.copied(),
        };
        let def = match reaching {
            Some(Reaching::One(def)) => def,
            Some(Reaching::Several) => return self.chosen_name(id, span),
            None => {
                self.report(
                    Diagnostic::error(
                        "E0504",
                        format!("`{name}` has no expression yet"),
                        span,
                        "used before its binding",
                    )
                    .label(declared, "bound here")
                    .help("move the binding before this use"),
                );
                return Expr { kind: Kind::Error, ty: self.variable_type(id), span };
            }
        };
        self.use_def(def, span)
    }

    pub(super) fn use_def(&mut self, def: DefId, span: Span) -> Expr {
        let found = &self.defs[def.0 as usize];
        let ty = found.expr.ty.clone();
        if self.symbolic {
            return Expr { kind: Kind::Def(def), ty, span };
        }
        self.evaluated(def, span)
    }

    /// Returns the value of a definition that does not depend on time.
    pub(super) fn evaluated(&mut self, def: DefId, span: Span) -> Expr {
        let found = &self.defs[def.0 as usize];
        let (ty, name, bound) = (found.expr.ty.clone(), found.name.clone(), found.span);
        if found.observes {
            // An expression of observables is an observable.
            if let Type::Number(dim) = self.store.shallow(&ty) {
                return Expr { kind: Kind::MakeSymbolic(def), ty: Type::Observable(dim), span };
            }
            let diagnostic = self.observable_as_value(span).label(bound, "bound to an observable here");
            self.report(diagnostic);
        } else if found.on_time {
            let diagnostic = if bound == span {
                self.time_as_value(span)
            } else {
                Diagnostic::error(
                    "E0502",
                    format!("`{name}` depends on `Time`, so it has no value here"),
                    span,
                    "this is evaluated immediately",
                )
                .label(bound, "bound to this expression")
                .help(format!(
                    "bind the result with `:=`, too, or evaluate at a time: `{name} at Time = 0.1 s`"
                ))
            };
            self.report(diagnostic);
        } else {
            self.evaluated_later(def, &name, span);
        }
        Expr { kind: Kind::Eval(def, None), ty, span }
    }

    /// Returns the current value of an expression that was checked as symbolic.
    pub(super) fn evaluate_now(&mut self, e: Expr, name: &str) -> Expr {
        let span = e.span;
        let def = self.make_def(name, e, span);
        self.evaluated(def, span)
    }

    /// Checks `derivative(e, s)`.
    pub(super) fn derivative(&mut self, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let Some([e, by]) = self.plain("derivative", arguments, span, ["e", "s"]) else {
            return Expr::error(span);
        };
        let inner = self.as_symbolic(|c| c.expr(e));
        let Some((sym, dim)) = self.derivative_symbol(by) else { return Expr::error(span) };
        let quotient = self.quotient(&inner.ty.clone(), &Type::Number(dim), inner.span);
        let result = Expr { kind: Kind::Derivative(Box::new(inner), sym), ty: quotient, span };
        if self.symbolic { result } else { self.evaluate_now(result, "derivative") }
    }

    /// Returns the symbol of a derivative as written.
    fn derivative_symbol(&mut self, by: &'a ast::Expr) -> Option<(Sym, Dim)> {
        let mut name = by;
        while let ExprKind::Paren(inner) = &name.kind {
            name = inner;
        }
        if let ExprKind::Name(name) = &name.kind {
            return self.symbol(name);
        }
        self.report(
            Diagnostic::error(
                "E0506",
                "derivatives are with respect to `Time`, a number param or an argument",
                by.span,
                "not a symbol",
            )
            .help("write `derivative(e, Time)` or `derivative(e, some_param)`"),
        );
        None
    }

    /// Returns the type of a quotient by a number, element by element for brackets.
    fn quotient(&mut self, ty: &Type, by: &Type, span: Span) -> Type {
        match self.store.shallow(ty) {
            Type::Array(element) => Type::array(self.quotient(&element, by, span)),
            Type::Tuple(parts) => {
                Type::Tuple(parts.iter().map(|part| self.quotient(part, by, span)).collect())
            }
            Type::Transform => {
                let help =
                    "use `velocity(frame)`, `angular_velocity(frame)`, or the derivative of `origin(frame)`";
                let message = "a frame has no derivative";
                self.report(Diagnostic::error("E0304", message, span, "a frame").help(help));
                Type::Error
            }
            known @ (Type::Bool | Type::String | Type::Record(_) | Type::Handle(_)) => {
                let shown = with_article(&self.store.show(&known));
                let message = format!("{shown} has no derivative");
                let help = "only numbers, vectors, and brackets of them have derivatives";
                self.report(Diagnostic::error("E0304", message, span, format!("this is {shown}")).help(help));
                Type::Error
            }
            _ => {
                let quotient = self.store.fresh();
                let kind = ConstraintKind::Divide(ty.clone(), by.clone(), quotient.clone());
                self.constrain(Constraint { kind, span });
                quotient
            }
        }
    }

    /// Checks `gradient(e, [p, q])`, which returns the derivatives in brackets: a tuple if their
    /// dimensions differ.
    pub(super) fn gradient(&mut self, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let Some([e, by]) = self.plain("gradient", arguments, span, ["e", "symbols"]) else {
            return Expr::error(span);
        };
        let inner = self.as_symbolic(|c| c.expr(e));
        let mut list = by;
        while let ExprKind::Paren(inside) = &list.kind {
            list = inside;
        }
        let ExprKind::List(symbols) = &list.kind else {
            self.report(
                Diagnostic::error(
                    "E0506",
                    "the symbols of a gradient must be in brackets",
                    by.span,
                    "not in brackets",
                )
                .help("write `gradient(e, [p, q])`, or `derivative(e, p)` for one symbol"),
            );
            return Expr::error(span);
        };
        let (mut by, mut types) = (Vec::new(), Vec::new());
        for symbol in symbols {
            let Some((sym, dim)) = self.derivative_symbol(symbol) else { return Expr::error(span) };
            let quotient = self.quotient(&inner.ty.clone(), &Type::Number(dim), inner.span);
            by.push(sym);
            types.push(quotient);
        }
        self.solve_open_constraints(types.iter());
        let differ = |types: &[Type]| types.iter().any(|ty| self.store.differ(&types[0], ty));
        let ty = if differ(&types) {
            Type::Tuple(types)
        } else {
            let element = self.store.fresh();
            // The types do not differ, so unification cannot fail.
            types.iter().for_each(|ty| self.store.unify(&element, ty).unwrap_or_default());
            Type::array(element)
        };
        let result = Expr { kind: Kind::Gradient(Box::new(inner), by), ty, span };
        if self.symbolic { result } else { self.evaluate_now(result, "gradient") }
    }

    // Binding.

    /// Checks `name := value` in a declaration or an assignment.
    pub(super) fn bind(&mut self, id: VarId, value: &'a ast::Expr) -> StmtKind {
        let name = self.variable(id).name.clone();
        let e = self.as_symbolic(|c| c.whole(value));
        let ty = self.variable_type(id);
        let cause = Some((self.variable(id).span, format!("`{name}` is declared here")));
        self.expect(&ty, &e, format_args!("`{name}`"), cause);
        let def = self.make_def(&name, e, value.span);
        self.defs[def.0 as usize].stored = true;
        self.reaching.insert(id, Reaching::One(def));
        self.graphs.bound.entry(id).or_default().push(def);
        let owner = self.variable(id).owner;
        self.dependence.bound(id, owner, def);
        StmtKind::Bind(id, def)
    }

    /// Splits a checked symbolic expression into its symbolic part and its captures.
    pub(super) fn make_def(&mut self, name: &str, e: Expr, span: Span) -> DefId {
        self.make_def_in(name, e, span, None)
    }

    /// Splits the body of a symbolic function, if one is given; otherwise as [`Self::make_def`].
    pub(super) fn make_def_in(&mut self, name: &str, e: Expr, span: Span, function: Option<FuncId>) -> DefId {
        let mut builder = Builder {
            name: name.into(),
            function,
            captures: Vec::new(),
            known: HashMap::default(),
            on_time: false,
            observes: false,
            closed: true,
            chosen: BTreeSet::new(),
            branches: Vec::new(),
        };
        let expr = self.split(e, &mut builder);
        let id = DefId(self.defs.len() as u32);
        for (hidden, value) in &builder.captures {
            self.dependence.variable(*hidden, value);
            self.note_evaluated(value);
        }
        self.dependence.definition(id, &expr);
        self.note_circular_definition(id, &expr);
        self.defs.push(Def {
            name: builder.name,
            expr,
            captures: builder.captures,
            on_time: builder.on_time,
            observes: builder.observes,
            closed: builder.closed,
            chosen: builder.chosen,
            part: false,
            stored: false,
            checks: Vec::new(),
            span,
        });
        id
    }

    fn split(&mut self, e: Expr, to: &mut Builder) -> Expr {
        let Expr { kind, ty, span } = e;
        let kind = match kind {
            Kind::Error | Kind::Number(_) | Kind::Bare(..) | Kind::Bool(_) => kind,
            Kind::Time => {
                to.on_time = true;
                kind
            }
            Kind::Param(_) if matches!(self.store.known(&ty), Type::Number(_) | Type::Bool | Type::Error) => {
                kind
            }
            Kind::Var(id) if to.function == Some(self.variable(id).owner) => kind,
            Kind::Def(def) => {
                self.use_definition(def, span, to);
                kind
            }
            Kind::SymbolicCall(mut call) => {
                to.on_time |= self.depends_on_time(call.function);
                call.arguments = call.arguments.into_iter().map(|a| self.split(a, to)).collect();
                Kind::SymbolicCall(call)
            }
            Kind::Function(function, captured) => {
                if let PassedFunction::Declared(id, _) = function {
                    to.on_time |= self.depends_on_time(id);
                }
                Kind::Function(function, captured.into_iter().map(|value| self.split(value, to)).collect())
            }
            Kind::Applied(mut applied) => {
                applied.environment = self.split(applied.environment, to);
                applied.arguments = applied.arguments.into_iter().map(|a| self.split(a, to)).collect();
                Kind::Applied(applied)
            }
            Kind::Array(all) => Kind::Array(all.into_iter().map(|a| self.split(a, to)).collect()),
            Kind::Tuple(all) => Kind::Tuple(all.into_iter().map(|a| self.split_field(a, to)).collect()),
            Kind::Index(base, index) if self.is_brackets(&base) => {
                Kind::Index(self.split_box(base, to), index)
            }
            Kind::Field(base, name) if self.is_brackets(&base) => Kind::Field(self.split_box(base, to), name),
            Kind::Spline(parts) => {
                let [xs, ys, x] = *parts;
                Kind::Spline(Box::new([xs, ys, self.split(x, to)]))
            }
            Kind::Block(bindings, result) => {
                let bindings = bindings.into_iter().map(|(id, value)| (id, self.split(value, to))).collect();
                Kind::Block(bindings, self.split_box(result, to))
            }
            Kind::TupleElement(base, at) if self.is_brackets(&base) => {
                Kind::TupleElement(self.split_box(base, to), at)
            }
            Kind::Unary(op, a) => Kind::Unary(op, self.split_box(a, to)),
            Kind::Binary(op, a, b) => {
                if self.compares_values(op, &a) {
                    // Strings and arrays never depend on time, so their comparison is a captured
                    // truth value.
                    let [a, b] = [a, b].map(|e| self.text_value(*e));
                    let kind = Kind::Binary(op, Box::new(a), Box::new(b));
                    return self.capture(Expr { kind, ty, span }, to);
                }
                Kind::Binary(op, self.split_box(a, to), self.split_box(b, to))
            }
            Kind::Op(op, all) => Kind::Op(op, all.into_iter().map(|a| self.split(a, to)).collect()),
            Kind::If(condition, a, b)
                if to.function.is_none() && self.chooses_observable(&condition, &a, &b) =>
            {
                return self.chosen_observable(*condition, *a, *b, span, to);
            }
            Kind::If(condition, a, b) => self.split_choice(condition, a, b, to),
            Kind::Derivative(inner, sym) => {
                Kind::Derivative(self.differentiated(inner, &[sym], to, span), sym)
            }
            Kind::Gradient(inner, by) => Kind::Gradient(self.differentiated(inner, &by, to, span), by),
            Kind::At(inner, sym, at) => self.split_at(inner, sym, at, span, to),
            // The captured axis is checked when its value is captured.
            Kind::UnitAxis(inner) if to.function.is_none() && !has_symbols(&inner) => {
                return self.capture(Expr { kind: Kind::UnitAxis(inner), ty, span }, to);
            }
            Kind::UnitAxis(inner) => Kind::UnitAxis(self.split_box(inner, to)),
            Kind::Part(inner) => return Expr { kind: self.split_part(*inner, to).kind, ty, span },
            Kind::Observe(inner) => {
                to.observes = true;
                let inner = self.capture(*inner, to);
                Kind::Observe(Box::new(inner))
            }
            value => return self.capture(Expr { kind: value, ty, span }, to),
        };
        Expr { kind, ty, span }
    }

    /// Records the properties of a definition that the built one uses.
    fn use_definition(&mut self, def: DefId, span: Span, to: &mut Builder) {
        let found = &self.defs[def.0 as usize];
        to.on_time |= found.on_time;
        to.observes |= found.observes;
        to.closed &= found.closed;
        to.chosen.extend(&found.chosen);
        if to.function.is_some() && !found.closed {
            let diagnostic = self
                .outside_argument(&found.name, span)
                .label(found.span, "a symbolic function cannot capture values");
            self.report(diagnostic);
        }
    }

    /// Returns `true` if an operator compares values that have no numeric representation.
    fn compares_values(&self, op: BinaryOp, operand: &Expr) -> bool {
        matches!(op, BinaryOp::Equal | BinaryOp::NotEqual)
            && matches!(
                self.store.known(&operand.ty),
                Type::String | Type::Enum(_) | Type::Array(_) | Type::Tuple(_) | Type::Record(_)
            )
    }

    /// Splits a differentiated expression, and records its symbols.
    fn differentiated(&mut self, inner: Box<Expr>, by: &[Sym], to: &mut Builder, span: Span) -> Box<Expr> {
        let observed = std::mem::replace(&mut to.observes, false);
        let inner = self.split_box(inner, to);
        if to.observes {
            self.report(
                Diagnostic::error(
                    "E0508",
                    "an observable cannot be differentiated",
                    span,
                    "the analysis computes its values",
                )
                .help("differentiate expressions in `Time` and params only"),
            );
        }
        to.observes |= observed;
        by.iter().for_each(|sym| self.dependence.asked(Question::Derivative, *sym, &inner, &self.defs, span));
        inner
    }

    /// Splits an element of a tuple or record. A literal text in it is kept for its value.
    fn split_field(&mut self, e: Expr, to: &mut Builder) -> Expr {
        match (&e.kind, self.store.shallow(&e.ty)) {
            // No argument of a symbolic function can use it.
            (Kind::Text(_), _) => e,
            (_, Type::String | Type::Enum(_)) if to.function.is_some() => {
                Expr { kind: Kind::Text(String::new()), ..e }
            }
            _ => self.split(e, to),
        }
    }

    /// Splits `inner at sym = at`. If `at` replaces the time, `inner` adds no dependence on time.
    fn split_at(&mut self, inner: Box<Expr>, sym: Sym, at: Box<Expr>, span: Span, to: &mut Builder) -> Kind {
        let (on_time, chosen) = (to.on_time, to.chosen.clone());
        let inner = self.split_box(inner, to);
        self.dependence.asked(Question::Value, sym, &inner, &self.defs, span);
        if sym == Sym::Time {
            (to.on_time, to.chosen) = (on_time, chosen);
        }
        Kind::At(inner, sym, self.split_box(at, to))
    }

    /// Splits an argument of a symbolic function or a part of brackets. Any other part is captured.
    fn split_part(&mut self, inner: Expr, to: &mut Builder) -> Expr {
        if self.is_brackets_part(&inner) {
            return self.split(inner, to);
        }
        to.on_time = true;
        self.capture(inner, to)
    }

    /// Splits a choice of observables whose condition is known when the binding executes: only the
    /// observable that is chosen is captured, so the other one need not exist.
    fn chosen_observable(&mut self, condition: Expr, a: Expr, b: Expr, span: Span, to: &mut Builder) -> Expr {
        let condition = self.condition_value(condition);
        let (a, b) = (self.as_observable(a), self.as_observable(b));
        let ty = a.ty.clone();
        let kind = Kind::If(Box::new(condition), Box::new(a), Box::new(b));
        to.observes = true;
        let captured = self.capture(Expr { kind, ty: ty.clone(), span }, to);
        let number = match self.store.shallow(&ty) {
            Type::Observable(dim) => Type::Number(dim),
            other => other,
        };
        Expr { kind: Kind::Observe(Box::new(captured)), ty: number, span }
    }

    fn split_box(&mut self, mut e: Box<Expr>, to: &mut Builder) -> Box<Expr> {
        let inner = std::mem::replace(&mut *e, Expr::error(Span::default()));
        *e = self.split(inner, to);
        e
    }

    fn split_choice(&mut self, condition: Box<Expr>, a: Box<Expr>, b: Box<Expr>, to: &mut Builder) -> Kind {
        let (condition, chosen) = self.branch_condition(condition, [&a, &b], to);
        let condition = self.split_box(condition, to);
        let a = self.split_branch(a, chosen.as_ref(), true, to);
        Kind::If(condition, a, self.split_branch(b, chosen.as_ref(), false, to))
    }

    fn split_branch(
        &mut self,
        e: Box<Expr>,
        condition: Option<&Expr>,
        is_first: bool,
        to: &mut Builder,
    ) -> Box<Expr> {
        let Some(condition) = condition else { return self.split_box(e, to) };
        to.branches.push(Branch { condition: condition.clone(), is_first });
        let split = self.split_box(e, to);
        to.branches.pop();
        split
    }

    /// Returns the condition of a choice in an output, and its value if it is known when the
    /// binding executes and a branch captures values that may not exist otherwise.
    fn branch_condition(
        &mut self,
        condition: Box<Expr>,
        branches: [&Expr; 2],
        to: &mut Builder,
    ) -> (Box<Expr>, Option<Expr>) {
        let may_fail = branches.iter().any(|branch| may_fail(branch));
        let Some(captures) = self.output_captures.filter(|_| may_fail && to.function.is_none()) else {
            return (condition, None);
        };
        if !self.is_known_at_binding(&condition) {
            return (condition, None);
        }
        let value = self.condition_value((*condition).clone());
        if !calls_functions(&value) {
            return (condition, Some(value));
        }
        if captures == OutputCaptures::Immediate {
            return (condition, None);
        }
        // A function may have effects, so it is called once.
        let kept = self.capture(value, to);
        (Box::new(kept.clone()), Some(kept))
    }

    fn capture(&mut self, value: Expr, to: &mut Builder) -> Expr {
        let value = in_branches(value, &self.store, &to.branches);
        let (ty, span) = (value.ty.clone(), value.span);
        to.closed = false;
        if to.function.is_some() {
            self.report_capture_in_function(&value);
            return Expr { kind: Kind::Error, ty, span };
        }
        if let Kind::Chosen(id) = value.kind {
            to.chosen.insert(id);
        }
        if let Kind::Var(id) | Kind::Chosen(id) = value.kind
            && let Some(&hidden) = to.known.get(&id)
        {
            return Expr { kind: Kind::Var(hidden), ty, span };
        }
        let name = match value.kind {
            Kind::Var(id) | Kind::Chosen(id) => self.variable(id).name.to_string(),
            // A short source text is the name of the captured value in results and messages.
            _ => match self.text(span) {
                text if text.len() <= 40 && !text.is_empty() && !text.contains('\n') => text.to_string(),
                _ => to.name.clone(),
            },
        };
        let held = match value.kind {
            Kind::Chosen(_) => Type::Symbolic(Box::new(ty.clone())),
            _ => ty.clone(),
        };
        let hidden = self.hidden_variable(&name, span, held);
        if let Kind::Var(id) | Kind::Chosen(id) = value.kind {
            to.known.insert(id, hidden);
        }
        if let Kind::Chosen(id) = value.kind {
            self.graphs.captured.insert(hidden, id);
        }
        if let Kind::Var(id) = value.kind
            && self.is_function(&ty)
        {
            self.environments.insert(hidden, id);
        }
        to.captures.push((hidden, value));
        Expr { kind: Kind::Var(hidden), ty, span }
    }

    /// Checks definitions after inference: each must be a number, vector or frame, and derivatives
    /// with respect to params must not miss captured values that depend on them.
    pub(super) fn finish_definitions(&mut self) {
        let outputs: HashSet<usize> = self.output_defs.values().map(|def| def.0 as usize).collect();
        for index in 0..self.defs.len() {
            let def = &self.defs[index];
            let (ty, span) = (self.store.resolve(&def.expr.ty), def.expr.span);
            // The type of an output is checked where it is declared.
            if !outputs.contains(&index) && !self.can_stay_symbolic(&def.expr) {
                self.report(
                    Diagnostic::error(
                        "E0507",
                        format!("{} cannot stay symbolic", with_article(&self.store.show(&ty))),
                        span,
                        "bound with `:=`",
                    )
                    .help("only numbers, vectors, frames, and brackets and records of them do; use `=`"),
                );
            }
        }
        for (question, param, blind, span) in self.dependence.blind(&self.defs, &self.graphs, &self.functions)
        {
            let diagnostic = self.blind(question, param, blind, span);
            self.report(diagnostic);
        }
    }
}
