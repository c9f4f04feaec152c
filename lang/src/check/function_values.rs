//! Checks functions as arguments. A parameter that its function calls is a function; each call
//! passes the name of one. The type of the parameter follows from its calls, like that of any other
//! parameter.
//!
//! Functions are no values: lowering creates a copy of the called function for the functions that a
//! call passes, so kernels and functions contain no indirect calls.

use super::infer::Checker;
use super::symbols::{Resolution, VarKind, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, Bind, ExprKind, FunctionBody, Mode};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl<'a> Checker<'a> {
    /// Returns `true` if a type is known to be that of a function.
    pub(super) fn is_function(&self, ty: &Type) -> bool {
        matches!(self.store.known(ty), Type::Function(..))
    }

    /// Returns `true` for a parameter that may be a function.
    pub(super) fn may_be_function(&self, id: VarId) -> bool {
        let variable = self.variable(id);
        let owner = self.names.functions.get(variable.owner.0 as usize).and_then(|info| info.decl);
        let ty = self.variable_types.get(&id);
        let known = ty.map(|ty| self.store.known(ty));
        variable.kind == VarKind::Parameter(Mode::In)
            && owner.is_some_and(|decl| !decl.is_component && !decl.is_host)
            && matches!(known, None | Some(Type::Unknown(_) | Type::Function(..)))
    }

    /// Returns `true` if the parameter of the current function that is declared at a location has a
    /// type.
    fn is_annotated(&self, declared: Span) -> bool {
        let decl = self.names.functions[self.function.0 as usize].decl;
        let mut parameters = decl.into_iter().flat_map(|decl| &decl.parameters);
        parameters.any(|parameter| parameter.name.span == declared && parameter.annotation.is_some())
    }

    /// Returns `true` if the value of a function depends on `Time`.
    pub(super) fn depends_on_time(&self, id: FuncId) -> bool {
        let definition = self.functions.get(&id).and_then(|function| function.definition.as_ref());
        definition.is_some_and(|body| self.defs[body.def.0 as usize].on_time)
    }

    /// Checks a call of a parameter that is a function.
    pub(super) fn parameter_call(
        &mut self,
        id: VarId,
        name: &ast::Ident,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let shown = &name.name;
        let variable = self.variable(id);
        let (owner, declared) = (variable.owner, variable.span);
        let named = arguments.iter().find_map(|argument| match &argument.name {
            Some((name, _)) => Some(name.span),
            None => argument.spread.then_some(argument.value.span),
        });
        let problem = if owner != self.function {
            Some(("a nested function cannot call it", span, format!("pass it: `in {shown}`")))
        } else if self.names.assigned.contains(&id) {
            Some(("it is assigned", span, "pass another function in the call instead".to_string()))
        } else {
            named.map(|place| {
                ("its parameters have no names here", place, "give its arguments in order".to_string())
            })
        };
        if let Some((reason, place, help)) = problem {
            self.check_loosely(arguments);
            let message = format!("the parameter `{shown}` cannot be called like this: {reason}");
            self.report(
                Diagnostic::error("E0865", message, place, "a parameter that is a function")
                    .label(declared, "the parameter")
                    .help(help),
            );
            return Expr::error(span);
        }
        let values: Vec<Expr> = arguments.iter().map(|argument| self.whole(&argument.value)).collect();
        let ty = self.variable_type(id);
        let count =
            |count: usize| if count == 1 { "1 argument".to_string() } else { format!("{count} arguments") };
        let (parameters, result) = match self.store.shallow(&ty) {
            Type::Function(parameters, _) if parameters.len() != values.len() => {
                let (before, here) = (count(parameters.len()), count(values.len()));
                self.report(
                    Diagnostic::error(
                        "E0865",
                        match self.is_annotated(declared) {
                            true => format!("`{shown}` takes {before}, not {here}"),
                            false => format!("`{shown}` is called with {here} here and with {before} before"),
                        },
                        span,
                        "another number of arguments",
                    )
                    .label(declared, "the parameter")
                    .help("pass two functions, one for each kind of call"),
                );
                return Expr::error(span);
            }
            Type::Function(parameters, result) => (parameters, *result),
            _ => {
                let parameters: Vec<Type> = values.iter().map(|_| self.store.fresh()).collect();
                let result = self.store.fresh();
                let function = Type::Function(parameters.clone(), Box::new(result.clone()));
                // The type of the parameter is unknown, so unification fails only if it would
                // contain itself.
                if self.store.unify(&ty, &function).is_err() {
                    return self.not_callable(&format!("`{shown}`"), name.span);
                }
                (parameters, result)
            }
        };
        let cause = match self.is_annotated(declared) {
            true => format!("the type of `{shown}`"),
            false => format!("`{shown}` is called with other arguments before"),
        };
        for (parameter, value) in parameters.iter().zip(&values) {
            let cause = Some((declared, cause.clone()));
            self.expect(parameter, value, format_args!("an argument of `{shown}`"), cause);
        }
        let environment = Expr { kind: Kind::Var(id), ty: ty.clone(), span: name.span };
        let applied = Applied { parameter: id, environment, arguments: values, search: None };
        Expr { kind: Kind::Applied(Box::new(applied)), ty: result, span }
    }

    /// Checks the argument of a parameter that is a function: the name of a function, or a
    /// parameter of the enclosing function that is one.
    pub(super) fn function_argument(
        &mut self,
        expected: &Type,
        parameter: &ast::Ident,
        argument: &'a ast::Argument,
    ) -> Expr {
        let error = Expr { kind: Kind::Error, ty: expected.clone(), span: argument.value.span };
        let mut written = &argument.value;
        while let ExprKind::Paren(inner) = &written.kind {
            written = inner;
        }
        let span = written.span;
        let name = match &written.kind {
            ExprKind::Name(name) | ExprKind::Field { field: name, .. } => Some(name),
            ExprKind::Anonymous(decl) => Some(&decl.name),
            _ => None,
        };
        let is_symbolic = matches!(&argument.name, Some((_, Bind::Symbolic)));
        let meant = name.and_then(|name| self.meaning(name.span));
        let problem = match meant {
            Some(Resolution::Unknown) => return error,
            Some(Resolution::Function(id)) if self.symbolic && self.is_computed(id) => return error,
            Some(Resolution::Function(id)) if !is_symbolic => match self.unsuitable(id) {
                None => return self.passed(id, expected, parameter, span),
                Some(problem) => problem,
            },
            Some(Resolution::Var(id))
                if !is_symbolic && self.may_be_function(id) && self.variable(id).owner == self.function =>
            {
                let value = self.function_parameter(id, span);
                let cause = Some((parameter.span, format!("`{}` is called as this", parameter.name)));
                self.expect(expected, &value, format_args!("`{}`", parameter.name), cause);
                return value;
            }
            Some(Resolution::Builtin(_) | Resolution::Extern(_)) => {
                "a built-in or library function has no name as an argument".to_string()
            }
            _ => {
                if meant.is_none() || matches!(meant, Some(Resolution::Var(_) | Resolution::Param(_))) {
                    self.as_symbolic(|c| c.expr(&argument.value));
                }
                format!("`{}` is a function, so its argument is the name of one", parameter.name)
            }
        };
        self.report(
            Diagnostic::error("E0866", problem, span, "cannot be passed as a function")
                .label(parameter.span, format!("`{}` is called", parameter.name))
                .help("declare `function name(in x) := ...;`, and pass `name`"),
        );
        error
    }

    /// Returns the reason why a function of the program cannot be passed.
    fn unsuitable(&self, id: FuncId) -> Option<String> {
        let info = &self.names.functions[id.0 as usize];
        let (decl, name) = (info.decl?, &info.name);
        if decl.is_component || matches!(decl.body, FunctionBody::Extern { .. }) {
            return Some(format!("`{name}` is no function of the program"));
        }
        // An anonymous function is symbolic, and the use in its body is reported.
        let reported = matches!(decl.body, FunctionBody::Symbolic(_));
        if !info.outer.is_empty() && !reported {
            return Some(format!(
                "`{name}` uses variables of the function around it, so it cannot be passed"
            ));
        }
        for parameter in &decl.parameters {
            let of = &parameter.name.name;
            if parameter.mode != Mode::In || matches!(parameter.default, Some((Bind::Symbolic, _))) {
                return Some(format!("`{name}` cannot be passed, because `{of}` is no plain `in` parameter"));
            }
            if parameter.domain.is_some() {
                return Some(format!(
                    "`{name}` cannot be passed, because `{of}` has a range, which calls check"
                ));
            }
        }
        None
    }

    /// Checks a function of the program as an argument.
    fn passed(&mut self, id: FuncId, expected: &Type, parameter: &ast::Ident, span: Span) -> Expr {
        let info = &self.names.functions[id.0 as usize];
        let (decl, name) = (info.decl, info.name.clone());
        let (own, result, instance) = self.instantiate(id, span);
        let visible = decl.map_or(own.len(), |decl| decl.parameters.len()).min(own.len());
        let (own, captured) = own.split_at(visible);
        let captured = self.captured_values(id, captured);
        let ty = Type::Function(own.to_vec(), Box::new(result.clone()));
        let kind = Kind::Function(PassedFunction::Declared(id, instance), captured);
        let value = Expr { kind, ty, span };
        let Type::Function(called, wanted) = self.store.shallow(expected) else { return value };
        let place = decl.map_or(span, |decl| decl.name.span);
        if called.len() != own.len() {
            let (has, takes) = (own.len(), called.len());
            let plural = |count: usize| if count == 1 { "" } else { "s" };
            self.report(
                Diagnostic::error(
                    "E0867",
                    format!(
                        "`{}` is called with {takes} argument{}, but `{name}` has {has} parameter{}",
                        parameter.name,
                        plural(takes),
                        plural(has)
                    ),
                    span,
                    "another number of parameters",
                )
                .label(parameter.span, format!("called with {takes} argument{}", plural(takes)))
                .label(place, "declared here")
                .help("pass a function that has as many parameters as the call has arguments"),
            );
            return value;
        }
        for (at, (called, own)) in called.iter().zip(own).enumerate() {
            if self.store.unify(called, own).is_err() {
                let declared = decl.and_then(|decl| decl.parameters.get(at));
                let shown = declared.map_or_else(String::new, |p| format!(" as `{}`", p.name.name));
                let [takes, gets] = [own, called].map(|ty| with_article(&self.store.show(ty)));
                self.report(
                    Diagnostic::error(
                        "E0867",
                        format!(
                            "`{name}` takes {takes}{shown}, but `{}` is called with {gets}",
                            parameter.name
                        ),
                        span,
                        "takes another argument",
                    )
                    .label(parameter.span, format!("called with {gets}"))
                    .label(declared.map_or(place, |p| p.name.span), format!("takes {takes}"))
                    .help(format!("pass a function of {gets}")),
                );
                return value;
            }
        }
        // The parameters may determine the result.
        self.solve_open_constraints(std::iter::once(&result));
        if self.store.unify(&wanted, &result).is_err() {
            let [gives, needs] = [&result, &*wanted].map(|ty| with_article(&self.store.show(ty)));
            self.report(
                Diagnostic::error(
                    "E0867",
                    format!("`{name}` returns {gives}, but the result of `{}` is {needs}", parameter.name),
                    span,
                    "returns another value",
                )
                .label(parameter.span, format!("its result is {needs}"))
                .label(place, format!("returns {gives}"))
                .help(format!("pass a function that returns {needs}")),
            );
        }
        value
    }

    /// Reports an anonymous function that indexes by its arguments as a part of a symbolic
    /// expression.
    pub(super) fn is_computed(&mut self, id: FuncId) -> bool {
        let index = self.names.functions[id.0 as usize].computed;
        index.into_iter().for_each(|index| self.report(computed_index(index, "depends on an argument")));
        index.is_some()
    }

    /// Checks the expression of an anonymous function that indexes by its arguments, as the result
    /// of an ordinary function.
    pub(super) fn computed_body(&mut self, id: FuncId, body: &'a ast::Expr) -> Stmt {
        let value = self.stored(body);
        let result = self.current_result();
        let value = self.fitted(&result, value);
        let name = format!("the result of `{}`", self.names.functions[id.0 as usize].name);
        self.expect(&result, &value, name, None);
        self.dependence.returned(id, &value);
        Stmt { kind: StmtKind::Return(Some(value)), span: body.span }
    }

    /// Returns the meaning of a name. In an anonymous function, a variable around it is a
    /// parameter.
    pub(super) fn meaning(&self, name: Span) -> Option<Resolution> {
        match self.names.captured.get(&(self.function, name)) {
            Some(id) => Some(Resolution::Var(*id)),
            None => self.names.uses.get(&name).copied(),
        }
    }

    /// Returns the parameter of the current anonymous function for a captured expression.
    pub(super) fn captured_value(&mut self, span: Span) -> Option<Expr> {
        let id = *self.names.captured.get(&(self.function, span))?;
        let ty = self.variable_type(id);
        Some(self.observed(Expr { kind: Kind::Var(id), ty, span }))
    }

    /// Returns the expressions that an anonymous function captures.
    pub(super) fn captured_by(&self, decl: &ast::FunctionDecl) -> &[(&'a ast::Expr, VarId)] {
        match self.names.uses.get(&decl.name.span) {
            Some(Resolution::Function(id)) => &self.names.functions[id.0 as usize].captured,
            _ => &[],
        }
    }

    /// Checks the expressions that an anonymous function captures, as arguments of these types.
    pub(super) fn captured_values(&mut self, id: FuncId, types: &[Type]) -> Vec<Expr> {
        let captured = self.names.functions[id.0 as usize].captured.clone();
        let mut values = Vec::new();
        for ((written, variable), ty) in captured.into_iter().zip(types) {
            let function = match &written.kind {
                ExprKind::Name(name) if self.is_function(ty) => match self.meaning(name.span) {
                    Some(Resolution::Var(id)) if self.may_be_function(id) => Some(id),
                    _ => None,
                },
                _ => None,
            };
            let value = match function {
                Some(id) => self.function_parameter(id, written.span),
                None if self.names.spline_points.contains(&variable) => self.captured_spline(written),
                None => self.expr(written),
            };
            self.compute_with(id, &value);
            let name = format!("`{}`", self.variable(variable).name);
            self.expect(ty, &value, name, None);
            values.push(value);
        }
        values
    }

    /// Requests that an anonymous function computes values like an ordinary function, because it
    /// captures an array or a text: no symbolic expression has them as parts.
    fn compute_with(&mut self, id: FuncId, captured: &Expr) {
        let info = &self.names.functions[id.0 as usize];
        if let Some(decl) = info.decl.filter(|_| !self.symbolic && info.computed.is_none())
            && (matches!(self.store.known(&captured.ty), Type::String)
                || self.has_array(&captured.ty)
                // Captured by the function around it, too.
                || self.given.computed.values().any(|place| *place == captured.span))
        {
            self.requested.computed.insert(decl.name.span, captured.span);
        }
    }

    /// Returns `true` if a value is known to contain an array.
    fn has_array(&self, ty: &Type) -> bool {
        match self.store.known(ty) {
            Type::Array(_) => true,
            Type::Tuple(parts) => parts.iter().any(|part| self.has_array(part)),
            Type::Record(id) => {
                let fields = self.store.record(*id).into_iter().flat_map(|record| &record.fields);
                fields.into_iter().any(|(_, ty)| self.has_array(ty))
            }
            _ => false,
        }
    }

    /// Returns a parameter that is a function as an argument.
    fn function_parameter(&mut self, id: VarId, span: Span) -> Expr {
        let ty = self.variable_type(id);
        let value = Expr { kind: Kind::Var(id), ty: ty.clone(), span };
        Expr { kind: Kind::Function(PassedFunction::Parameter(id), vec![value]), ty, span }
    }

    /// Rejects a function of `Time` as an argument of the ordinary function `called`, which
    /// computes values.
    pub(super) fn refuse_time(&mut self, value: &Expr, called: &str) {
        let Kind::Function(PassedFunction::Declared(id, _), _) = value.kind else { return };
        if self.depends_on_time(id) {
            let name = self.names.functions[id.0 as usize].name.clone();
            self.report(
                Diagnostic::error(
                    "E0866",
                    format!("`{called}` computes a value, and `{name}` depends on `Time`"),
                    value.span,
                    "has no value here",
                )
                .help(format!("make the time a parameter of `{name}`, or `{called}` a symbolic function")),
            );
        }
    }
}

/// Returns the error for an index that depends on arguments, in a symbolic expression. `place` is
/// the index or the array.
pub(super) fn computed_index(place: Span, label: &str) -> Diagnostic {
    Diagnostic::error(
        "E0921",
        "a symbolic expression has no element whose index is known only at run time",
        place,
        label,
    )
    .help(
        "declare the elements with `const` and interpolate them, `spline(positions, list, x)`, or pass the \
         function to an ordinary function, which computes values",
    )
}
