//! Checks `solve(f, guess, ...)` and `minimize(f, guess, ...)`: the unknown for which a symbolic
//! function is zero or has a minimum.
//!
//! The first parameter of the function is the unknown; the others receive the arguments that follow
//! the guess. The function is given by its name, or is a parameter of the enclosing function.

use super::infer::Checker;
use super::symbols::{Resolution, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, Bind, ExprKind, FunctionBody, Mode};
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use calyx_abi::newton::Search;

/// Returns the name of the built-in function.
pub(super) fn builtin_name(search: Search) -> &'static str {
    match search {
        Search::Root => "solve",
        Search::Minimum => "minimize",
    }
}

impl<'a> Checker<'a> {
    pub(super) fn solution(&mut self, search: Search, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let called = builtin_name(search);
        let (Some((function, rest)), true) = (arguments.split_first(), arguments.len() >= 2) else {
            self.check_loosely(arguments.get(1..).unwrap_or_default());
            self.report(
                Diagnostic::error(
                    "E0206",
                    format!("`{called}` takes a function and a guess"),
                    span,
                    "an argument is missing",
                )
                .help(format!("write `{called}(f, guess)`; the other arguments of `f` follow the guess")),
            );
            return Expr::error(span);
        };
        let id = match self.function_to_solve(search, function) {
            Some(PassedFunction::Declared(id, _)) => id,
            Some(PassedFunction::Parameter(id)) => {
                return self.solution_of_parameter(search, id, (function, rest), span);
            }
            None => {
                self.check_loosely(rest);
                return Expr::error(span);
            }
        };
        let info = &self.names.functions[id.0 as usize];
        let (Some(decl), file, name) = (info.decl, info.file, info.name.clone()) else {
            return Expr::error(span);
        };
        let (guess, rest) = match rest.split_first() {
            Some((guess, rest)) if !guess.spread && is_guess(guess, decl) => (guess, rest),
            _ => {
                self.check_loosely(rest);
                let place = rest.first().map_or(span, |argument| argument.value.span);
                self.report(
                    Diagnostic::error(
                        "E0206",
                        format!("the second argument of `{called}` is the guess"),
                        place,
                        "not a guess",
                    )
                    .help(format!("write `{called}(f, guess)`; the other arguments of `f` follow the guess")),
                );
                return Expr::error(span);
            }
        };
        let Some((unknown, parameters)) = decl.parameters.split_first() else {
            self.check_loosely(rest);
            self.report(
                Diagnostic::error(
                    "E0861",
                    format!("`{name}` has no parameter, so it has no unknown"),
                    function.value.span,
                    "has no unknown",
                )
                .help("make the unknown its first parameter"),
            );
            return Expr::error(span);
        };
        let (types, result, instance) = self.instantiate(id, span);
        let names = decl.parameter_names();
        let names = names.get(1..).unwrap_or_default();
        self.note_arguments(names, rest);
        let Some(fields) = self.spread(&name, names, rest) else { return Expr::error(span) };
        let optional = |p: &ast::Parameter| matches!(p.default, Some((_, Some(_))));
        let listed: Vec<(&str, bool)> = parameters
            .iter()
            .map(|p| (p.name.name.as_str(), optional(p) || fields.contains_key(p.name.name.as_str())))
            .collect();
        if !self.check_number_after_guess(called, &name, &listed, rest, span) {
            self.check_loosely(rest);
            return Expr::error(span);
        }
        let Some(given) = self.match_arguments(&name, &listed, rest, span) else { return Expr::error(span) };
        let ty = types.first().cloned().unwrap_or(Type::Error);
        let guess = self.as_symbolic(|c| c.whole(&guess.value));
        let shown = with_article(&self.store.show(&ty));
        let cause = Some((unknown.name.span, format!("the unknown `{}` is {shown}", unknown.name.name)));
        self.expect(&ty, &guess, "the guess", cause);
        let others = types.get(1..).unwrap_or_default();
        let mut values = vec![guess];
        let (arguments, demands) =
            self.symbolic_arguments(parameters, others, (given, fields), (id, file, span));
        let demands = demands.into_iter().map(|(at, demand)| (at + 1, demand)).collect();
        values.extend(arguments);
        let captured = others.get(parameters.len()..).unwrap_or_default();
        values.extend(self.as_symbolic(|c| c.captured_values(id, captured)));
        self.check_residual(search, &ty, &result, function.value.span);
        let call = Call {
            function: id,
            instance,
            arguments: values,
            copy_back: Vec::new(),
            perhaps_same: Vec::new(),
            demands: Vec::new(),
            search: Some(search),
        };
        self.symbolic_or_evaluated(call, demands, (ty, span), called)
    }

    /// Reports too many or too few arguments after the guess; `parameters` are those of the
    /// function without the unknown, each with its name and `true` if it is optional.
    fn check_number_after_guess(
        &mut self,
        called: &str,
        name: &str,
        parameters: &[(&str, bool)],
        rest: &[ast::Argument],
        span: Span,
    ) -> bool {
        // Named arguments are matched by their names.
        if rest.iter().any(|argument| argument.spread || argument.name.is_some()) {
            return true;
        }
        let form: String = parameters.iter().map(|(parameter, _)| format!(", {parameter}")).collect();
        let help = format!("write `{called}({name}, guess{form})`");
        if let Some(extra) = rest.get(parameters.len()) {
            let arguments = match parameters.len() {
                0 => "no argument".into(),
                1 => "1 argument".into(),
                count => format!("{count} arguments"),
            };
            let message =
                format!("`{called}` of `{name}` takes {arguments} after the guess, not {}", rest.len());
            let problem = Diagnostic::error("E0206", message, extra.value.span, "extra argument");
            self.report(problem.help(help));
            return false;
        }
        let missing: Vec<String> = parameters[rest.len()..]
            .iter()
            .filter(|(_, optional)| !optional)
            .map(|(parameter, _)| format!("`{parameter}`"))
            .collect();
        if !missing.is_empty() {
            let message = format!("`{called}` of `{name}` lacks {} after the guess", missing.join(" and "));
            let problem = Diagnostic::error("E0206", message, span, "an argument is missing");
            self.report(problem.help(help));
        }
        missing.is_empty()
    }

    /// Checks the search of a root or minimum of a function that is a parameter. Its arguments have
    /// no names.
    fn solution_of_parameter(
        &mut self,
        search: Search,
        id: VarId,
        (function, rest): (&'a ast::Argument, &'a [ast::Argument]),
        span: Span,
    ) -> Expr {
        let mut written = &function.value;
        while let ExprKind::Paren(inner) = &written.kind {
            written = inner;
        }
        let ExprKind::Name(name) = &written.kind else { return Expr::error(span) };
        let call = self.as_symbolic(|c| c.parameter_call(id, name, rest, span));
        let Kind::Applied(applied) = call.kind else { return Expr::error(span) };
        let ty = applied.arguments.first().map_or(Type::Error, |guess| guess.ty.clone());
        self.check_residual(search, &ty, &call.ty, function.value.span);
        let applied = Applied { search: Some(search), ..*applied };
        let found = Expr { kind: Kind::Applied(Box::new(applied)), ty, span };
        if self.symbolic { found } else { self.evaluate_now(found, builtin_name(search)) }
    }

    /// Returns the function that is the first argument.
    fn function_to_solve(&mut self, search: Search, argument: &'a ast::Argument) -> Option<PassedFunction> {
        let called = builtin_name(search);
        let mut written = &argument.value;
        while let ExprKind::Paren(inner) = &written.kind {
            written = inner;
        }
        let name = match &written.kind {
            ExprKind::Name(name) | ExprKind::Field { field: name, .. } if !argument.spread => Some(name),
            _ => None,
        };
        let name = match &written.kind {
            ExprKind::Anonymous(decl) => Some(&decl.name),
            _ => name,
        };
        let meant = name.and_then(|name| self.meaning(name.span));
        let diagnostic = match meant {
            Some(Resolution::Function(id)) if self.is_computed(id) => return None,
            Some(Resolution::Function(id)) => {
                let decl = self.names.functions[id.0 as usize].decl;
                let usable = decl.is_some_and(|decl| {
                    !decl.is_host
                        && !matches!(decl.body, FunctionBody::Extern { .. })
                        && decl
                            .parameters
                            .iter()
                            .all(|p| p.mode == Mode::In && !matches!(p.default, Some((Bind::Symbolic, _))))
                });
                if usable {
                    // The caller instantiates it.
                    return Some(PassedFunction::Declared(id, UseId(0)));
                }
                format!("`{called}` needs a symbolic function")
            }
            Some(Resolution::Var(id)) if self.may_be_function(id) => {
                return Some(PassedFunction::Parameter(id));
            }
            Some(Resolution::Unknown) => return None,
            _ => {
                if meant.is_none() || matches!(meant, Some(Resolution::Var(_) | Resolution::Param(_))) {
                    self.as_symbolic(|c| c.expr(&argument.value));
                }
                format!("the first argument of `{called}` is the name of a function")
            }
        };
        self.report(
            Diagnostic::error("E0861", diagnostic, argument.value.span, "not a symbolic function").help(
                match search {
                    Search::Root => {
                        "declare `function f(in x, in a) := ...;`, which is zero at the solution `x`, and write \
                         `solve(f, guess, a)`"
                    }
                    Search::Minimum => {
                        "declare `function f(in x, in a) := ...;`, which is a number, and write \
                         `minimize(f, guess, a)`"
                    }
                },
            ),
        );
        None
    }

    /// Requires that a residual has the form of the unknown, and that a function to minimize
    /// returns a number. Its dimension may be any.
    fn check_residual(&mut self, search: Search, unknown: &Type, residual: &Type, span: Span) {
        self.solve_open_constraints(std::iter::once(residual));
        let expected = match self.store.shallow(unknown) {
            _ if search == Search::Minimum => self.fresh_number(),
            Type::Number(_) => self.fresh_number(),
            Type::Vector(_) => self.fresh_vector().0,
            // Brackets are compared when their numbers of elements are known.
            _ => return,
        };
        let found = Expr { kind: Kind::Error, ty: residual.clone(), span };
        self.expect(&expected, &found, "the result of the function", None);
    }
}

/// Returns `true` if an argument may be the guess: it has no name, or the name of the unknown.
fn is_guess(argument: &ast::Argument, decl: &ast::FunctionDecl) -> bool {
    match &argument.name {
        None => true,
        Some((name, _)) => {
            name.name == "guess" || decl.parameters.first().is_some_and(|p| p.name.name == name.name)
        }
    }
}
