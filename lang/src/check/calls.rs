//! Checks calls: matches arguments to parameters and applies the requirements of each kind of
//! function.

use super::infer::Checker;
use super::name_resolution::note_arguments;
use super::places::place_value;
use super::symbols::{Resolution, similar, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, Bind, ExprKind, Mode};
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use std::collections::HashMap;

/// The argument of each parameter, and the fields of spread records by name.
pub(super) type MatchedArguments<'a> = (Vec<Option<&'a ast::Argument>>, HashMap<String, Expr>);

impl<'a> Checker<'a> {
    pub(super) fn call(&mut self, callee: &'a ast::Expr, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let name = match &callee.kind {
            ExprKind::Name(name) | ExprKind::Field { field: name, .. } => name,
            _ => {
                self.as_value(|c| c.expr(callee));
                return self.not_callable("this", callee.span);
            }
        };
        match self.names.uses.get(&name.span).copied() {
            Some(Resolution::Function(id)) => self.user_call(id, name, arguments, span),
            Some(Resolution::Record(id)) => self.record_call(id, arguments, span),
            Some(Resolution::Extern(id)) => self.extern_call(id, name, arguments, span),
            Some(Resolution::Builtin(builtin)) => self.builtin_call(builtin, name, arguments, span),
            Some(Resolution::Unknown) | None => {
                // Check the arguments for further errors.
                if self.names.uses.contains_key(&name.span) || !matches!(callee.kind, ExprKind::Field { .. })
                {
                    self.check_loosely(arguments);
                    return Expr::error(span);
                }
                self.expr(callee);
                self.check_loosely(arguments);
                self.not_callable(&format!("`{}`", name.name), name.span)
            }
            Some(_) => {
                self.check_loosely(arguments);
                self.not_callable(&format!("`{}`", name.name), name.span)
            }
        }
    }

    fn not_callable(&mut self, what: &str, span: Span) -> Expr {
        self.report(
            Diagnostic::error("E0306", format!("{what} is not a function"), span, "cannot be called")
                .help("only functions are called; write `*` to multiply")
                .suggest("multiply", Span { start: span.end, ..span }, " *"),
        );
        Expr::error(span)
    }

    /// Checks the arguments of an invalid call, to report errors in them.
    pub(super) fn check_loosely(&mut self, arguments: &'a [ast::Argument]) {
        for argument in arguments {
            let symbolic = matches!(argument.name, Some((_, Bind::Symbolic)));
            let around = self.symbolic;
            self.symbolic |= symbolic;
            self.whole(&argument.value);
            self.symbolic = around;
        }
    }

    /// Matches arguments to parameters. `None` stands for a default; errors are reported.
    pub(super) fn match_arguments(
        &mut self,
        function: &str,
        parameters: &[(&str, bool)],
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Option<Vec<Option<&'a ast::Argument>>> {
        let mut given: Vec<Option<&ast::Argument>> = vec![None; parameters.len()];
        let mut named = false;
        let mut sound = true;
        let list = || parameters.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        for (index, argument) in arguments.iter().enumerate() {
            let at = match &argument.name {
                // The caller handles spread arguments.
                _ if argument.spread => {
                    named = true;
                    continue;
                }
                Some((name, _)) => {
                    named = true;
                    match parameters.iter().position(|(parameter, _)| *parameter == name.name) {
                        Some(at) => at,
                        None => {
                            let diagnostic = Diagnostic::error(
                                "E0205",
                                format!("`{function}` has no parameter `{}`", name.name),
                                name.span,
                                "unknown parameter",
                            );
                            // A misspelt name cannot refer to a parameter that already has an
                            // argument.
                            let is_free = |parameter: &str| {
                                let mut named =
                                    arguments.iter().filter_map(|argument| argument.name.as_ref());
                                !named.any(|(name, _)| name.name == parameter)
                            };
                            let free = parameters.iter().map(|(name, _)| *name).filter(|name| is_free(name));
                            let diagnostic = match similar(&name.name, free) {
                                Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                                    format!("change to `{near}`"),
                                    name.span,
                                    near,
                                ),
                                None => diagnostic.help(format!("its parameters are {}", list())),
                            };
                            self.report(diagnostic);
                            sound = false;
                            continue;
                        }
                    }
                }
                None if self.is_decimal_comma(arguments, index, named || index >= parameters.len()) => {
                    sound = false;
                    continue;
                }
                None if named => {
                    let place = Span { end: argument.value.span.start, ..argument.value.span };
                    let written = |parameter: &str| {
                        let mut names = arguments.iter().filter_map(|argument| argument.name.as_ref());
                        names.any(|(name, _)| name.name == *parameter)
                    };
                    let free = parameters
                        .iter()
                        .zip(&given)
                        .filter(|((name, optional), given)| given.is_none() && !optional && !written(name));
                    let diagnostic = Diagnostic::error(
                        "E0206",
                        "an argument without a name follows a named argument",
                        argument.value.span,
                        "which parameter is this?",
                    )
                    .help("name it, or move it to the front");
                    let offer = |diagnostic: Diagnostic, name: &str| {
                        diagnostic.suggest(format!("name it `{name}`"), place, format!("{name} = "))
                    };
                    let diagnostic = free.take(3).fold(diagnostic, |d, ((name, _), _)| offer(d, name));
                    self.report(diagnostic);
                    sound = false;
                    continue;
                }
                None if index >= parameters.len() => {
                    let help = match parameters.len() {
                        0 => "it has no parameters".to_string(),
                        _ => format!("its parameters are {}", list()),
                    };
                    self.report(
                        Diagnostic::error(
                            "E0206",
                            format!(
                                "`{function}` takes {} arguments, not {}",
                                parameters.len(),
                                arguments.len()
                            ),
                            argument.value.span,
                            "extra argument",
                        )
                        .help(help),
                    );
                    sound = false;
                    break;
                }
                None => index,
            };
            if let Some(first) = given[at] {
                let before = index.checked_sub(1).and_then(|before| arguments.get(before));
                let removed = Span {
                    start: before.map_or(argument.value.span.start, |before| before.value.span.end),
                    ..argument.value.span
                };
                self.report(
                    Diagnostic::error(
                        "E0206",
                        format!("the argument `{}` occurs twice", parameters[at].0),
                        argument.value.span,
                        "second occurrence",
                    )
                    .label(first.value.span, "first occurrence")
                    .help("remove one of the two")
                    .suggest(format!("remove this `{}`", parameters[at].0), removed, ""),
                );
                sound = false;
                continue;
            }
            given[at] = Some(argument);
        }
        let missing: Vec<String> = parameters
            .iter()
            .zip(&given)
            .filter(|((_, optional), argument)| argument.is_none() && !optional)
            .map(|((name, _), _)| format!("`{name}`"))
            .collect();
        if !missing.is_empty() && sound {
            self.report(
                Diagnostic::error(
                    "E0206",
                    format!("the call of `{function}` lacks {}", missing.join(" and ")),
                    span,
                    "an argument is missing",
                )
                .help(format!("its parameters are {}", list())),
            );
            sound = false;
        }
        if !sound {
            self.check_loosely(arguments);
        }
        sound.then_some(given)
    }

    /// Reports a decimal comma if an argument without a parameter is the fraction of the previous
    /// number. Returns `true` if reported.
    fn is_decimal_comma(
        &mut self,
        arguments: &[ast::Argument],
        index: usize,
        has_no_parameter: bool,
    ) -> bool {
        let before = index.checked_sub(1).and_then(|before| arguments.get(before));
        let (Some(before), Some(argument)) = (before, arguments.get(index)) else { return false };
        let ExprKind::Number(_) = &before.value.kind else { return false };
        let (first, second) = (before.value.span, argument.value.span);
        let number = match &argument.value.kind {
            ExprKind::Number(_) => second,
            ExprKind::Quantity { unit, .. } => Span { end: unit.span.start, ..second },
            _ => return false,
        };
        let between = Span { start: first.end, end: second.start, ..first };
        if !has_no_parameter || self.text(between) != "," {
            return false;
        }
        let number = self.text(number).trim_end();
        let whole = Span { end: second.start + number.len() as u32, ..first };
        let problem = Diagnostic::decimal_comma(whole, self.text(first), number);
        problem.map(|problem| self.report(problem)).is_some()
    }

    fn extern_call(
        &mut self,
        id: u32,
        name: &ast::Ident,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let (decl, shown, file) = {
            let info = &self.names.externs[id as usize];
            (info.decl, info.name.clone(), info.file)
        };
        let Some((given, mut fields)) = self.given(&shown, decl, arguments, span) else {
            let result =
                self.in_file(file, |c| decl.result.as_ref().map_or(Type::Unit, |r| c.annotation(r, true)));
            return self.observed(Expr { kind: Kind::Error, ty: result, span });
        };
        if let Some(place) = self.constant_place {
            let pure =
                matches!(&decl.body, ast::FunctionBody::Extern { purity: Some(p) } if p.name == "pure");
            if !pure {
                self.report(
                    Diagnostic::error(
                        "E0212",
                        format!("{place} cannot call `{shown}`"),
                        span,
                        "has an effect",
                    )
                    .help("use functions without effects"),
                );
            }
        }
        let (mut values, mut demands) = (Vec::new(), Vec::new());
        let given_ones: Vec<bool> = given.iter().map(Option::is_some).collect();
        for (parameter, argument) in decl.parameters.iter().zip(given) {
            let ty = self.in_file(file, |c| {
                parameter.annotation.as_ref().map_or(Type::Error, |a| c.annotation(a, true))
            });
            let is_default = argument.is_none() && !fields.contains_key(&parameter.name.name);
            let value = match (argument, &parameter.default) {
                (Some(argument), _) => match &ty {
                    Type::Symbolic(inner) => {
                        self.symbolic_argument(inner, &parameter.name, &ty, argument, arguments)
                    }
                    _ => {
                        let reported = self.diagnostics.len();
                        let value = self.value_argument(&ty, &parameter.name, argument);
                        if self.diagnostics.len() > reported {
                            let free = self.in_file(file, |c| c.free_parameters(decl, &given_ones));
                            self.explain_argument(reported, (&parameter.name, &ty), argument, &value, &free);
                        }
                        value
                    }
                },
                (None, _) if fields.contains_key(&parameter.name.name) => {
                    self.field_argument(&ty, &parameter.name, &mut fields, span)
                }
                (None, Some((_, Some(default)))) => self.in_file(file, |c| {
                    c.as_value(|c| {
                        let value = c.whole(default);
                        c.expect(&ty, &value, "the default", None);
                        value
                    })
                }),
                // Already reported as missing.
                (None, _) => Expr::error(span),
            };
            if !is_default {
                let domain = parameter.domain.as_ref();
                let demand =
                    self.in_file(file, |c| c.domain(&ty, domain, Some(&value), &parameter.name.name));
                demands.extend(
                    demand.map(|demand| (values.len(), ArgumentRange { nan_passes: true, ..demand })),
                );
            }
            values.push(value);
        }
        let result =
            self.in_file(file, |c| decl.result.as_ref().map_or(Type::Unit, |r| c.annotation(r, true)));
        let _ = name;
        self.observed(Expr { kind: Kind::CallExtern(id, values, demands), ty: result, span })
    }

    pub(super) fn in_file<T>(&mut self, file: crate::span::FileId, work: impl FnOnce(&mut Self) -> T) -> T {
        let around = std::mem::replace(&mut self.file, file);
        let result = work(self);
        self.file = around;
        result
    }

    pub(super) fn value_argument(
        &mut self,
        ty: &Type,
        parameter: &ast::Ident,
        argument: &'a ast::Argument,
    ) -> Expr {
        if let Some((name, Bind::Symbolic)) = &argument.name {
            let between = Span { start: name.span.end, end: argument.value.span.start, ..name.span };
            self.report(
                Diagnostic::error(
                    "E0503",
                    format!("`{}` takes a value, not an expression", name.name),
                    name.span,
                    "given with `:=`",
                )
                .label(parameter.span, "declared here")
                .help(format!("write `{} = ...`", name.name))
                .fix("use `=`", between, " = "),
            );
        }
        let value = self.as_value(|c| c.whole(&argument.value));
        let cause = Some((
            parameter.span,
            format!("`{}` takes {}", parameter.name, with_article(&self.store.show(ty))),
        ));
        self.expect(ty, &value, &format!("`{}`", parameter.name), cause);
        value
    }

    fn symbolic_argument(
        &mut self,
        inner: &Type,
        parameter: &ast::Ident,
        ty: &Type,
        argument: &'a ast::Argument,
        all: &[ast::Argument],
    ) -> Expr {
        if let Some((name, Bind::Evaluate)) = &argument.name {
            let between = Span { start: name.span.end, end: argument.value.span.start, ..name.span };
            let diagnostic = Diagnostic::error(
                "E0503",
                format!("`{}` takes an expression in `Time`, not a value", name.name),
                name.span,
                "given with `=`",
            )
            .help(format!("write `{} := ...`", name.name))
            .fix("use `:=`", between, " := ");
            self.report(diagnostic);
        }
        let value = self.as_symbolic(|c| c.whole(&argument.value));
        let cause = Some((
            parameter.span,
            format!("`{}` takes {}", parameter.name, with_article(&self.store.show(ty))),
        ));
        self.expect(inner, &value, &format!("`{}`", parameter.name), cause);
        // A string argument, usually the name of a body, identifies the kernel in messages.
        let owner = all.iter().find_map(|argument| match &argument.value.kind {
            ExprKind::String(parts) => match parts.as_slice() {
                [ast::StringPart::Text(text)] => Some(text.as_str()),
                _ => None,
            },
            _ => None,
        });
        let name = match owner {
            Some(owner) => format!("{owner}.{}", parameter.name),
            None => parameter.name.clone(),
        };
        self.made_symbolic(&name, value, ty.clone())
    }

    /// Converts a checked expression to a symbolic value of type `ty`.
    fn made_symbolic(&mut self, name: &str, value: Expr, ty: Type) -> Expr {
        let span = value.span;
        let def = self.make_def(name, value, span);
        Expr { kind: Kind::MakeSymbolic(def), ty, span }
    }

    /// Returns the arguments of a function's parameters and the fields of spread records by name.
    /// Returns `None` if they do not match, which is reported.
    pub(super) fn given(
        &mut self,
        called: &str,
        decl: &ast::FunctionDecl,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Option<MatchedArguments<'a>> {
        let places = decl.parameters.iter().map(|p| (p.name.name.clone(), p.name.span));
        note_arguments(&mut self.named_parts, places, arguments);
        let names: Vec<&str> = decl.parameters.iter().map(|p| p.name.name.as_str()).collect();
        let fields = self.spread(called, &names, arguments)?;
        let optional = |p: &ast::Parameter| matches!(p.default, Some((_, Some(_))));
        let parameters: Vec<(&str, bool)> = decl
            .parameters
            .iter()
            .map(|p| (p.name.name.as_str(), optional(p) || fields.contains_key(&p.name.name)))
            .collect();
        Some((self.match_arguments(called, &parameters, arguments, span)?, fields))
    }

    fn user_call(
        &mut self,
        id: FuncId,
        name: &ast::Ident,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let (Some(decl), file) =
            (self.names.functions[id.0 as usize].decl, self.names.functions[id.0 as usize].file)
        else {
            return Expr::error(span);
        };
        if let ast::FunctionBody::Symbolic(_) = &decl.body {
            return self.symbolic_call(id, name, arguments, span);
        }
        if self.symbolic && self.names_symbols(arguments) {
            return self.symbolic_call(id, name, arguments, span);
        }
        let given = self.given(&name.name, decl, arguments, span);
        let (types, result, instance) = self.instantiate(id, span);
        let Some((given, mut fields)) = given else {
            return Expr { kind: Kind::Error, ty: result, span };
        };
        let variables = self.names.functions[id.0 as usize].parameters.clone();
        let (mut values, mut copy_back, mut demands) = (Vec::new(), Vec::new(), Vec::new());
        let given_ones: Vec<bool> = given.iter().map(Option::is_some).collect();
        for (((parameter, argument), ty), variable) in
            decl.parameters.iter().zip(given).zip(&types).zip(variables)
        {
            let value = match (parameter.mode, argument) {
                (Mode::In, Some(argument)) => match self.store.shallow(ty) {
                    Type::Symbolic(inner) => {
                        let value = self.symbolic_argument(&inner, &parameter.name, ty, argument, arguments);
                        self.hand_over(variable, &value);
                        value
                    }
                    _ => {
                        let reported = self.diagnostics.len();
                        let value = self.value_argument(ty, &parameter.name, argument);
                        if self.diagnostics.len() > reported {
                            let free = self.in_file(file, |c| c.free_parameters(decl, &given_ones));
                            self.explain_argument(reported, (&parameter.name, ty), argument, &value, &free);
                        }
                        value
                    }
                },
                (Mode::In, None) if fields.contains_key(&parameter.name.name) => {
                    self.field_argument(ty, &parameter.name, &mut fields, span)
                }
                (Mode::In, None) if matches!(self.store.shallow(ty), Type::Symbolic(_)) => {
                    match (&parameter.default, self.store.shallow(ty)) {
                        (Some((_, Some(default))), Type::Symbolic(inner)) => {
                            let value = self.in_file(file, |c| c.as_symbolic(|c| c.whole(default)));
                            self.expect(&inner, &value, "the default", None);
                            let value = self.made_symbolic(&parameter.name.name, value, ty.clone());
                            self.hand_over(variable, &value);
                            value
                        }
                        _ => Expr::error(span),
                    }
                }
                (Mode::In, None) => match &parameter.default {
                    Some((_, Some(default))) => self.in_file(file, |c| {
                        c.as_value(|c| {
                            let value = c.whole(default);
                            c.expect(ty, &value, "the default", None);
                            value
                        })
                    }),
                    _ => Expr::error(span),
                },
                (_, Some(argument)) => {
                    let Some(place) = self.as_value(|c| c.place(&argument.value)) else {
                        return Expr::error(span);
                    };
                    let value =
                        Expr { kind: place_value(&place), ty: place.ty.clone(), span: argument.value.span };
                    let cause = (
                        parameter.span(),
                        format!("`{}` is an `out` or `inout` parameter", parameter.name.name),
                    );
                    self.expect(ty, &value, &format!("`{}`", parameter.name.name), Some(cause));
                    copy_back.push(place);
                    value
                }
                (_, None) => {
                    self.report(
                        Diagnostic::error(
                            "E0310",
                            format!("`{}` needs a variable", parameter.name.name),
                            span,
                            "missing",
                        )
                        .help("an `out` or `inout` parameter has no default"),
                    );
                    Expr::error(span)
                }
            };
            self.dependence.variable(variable, &value);
            if parameter.mode != Mode::Out {
                let domain = parameter.domain.as_ref();
                let demand = self.in_file(file, |c| c.domain(ty, domain, Some(&value), &parameter.name.name));
                demands.extend(demand.map(|demand| (values.len(), demand)));
            }
            values.push(value);
        }
        let perhaps_same = self.distinct_places(&copy_back);
        let call = Call { function: id, instance, arguments: values, copy_back, perhaps_same, demands };
        self.observed(Expr { kind: Kind::Call(Box::new(call)), ty: result, span })
    }
}

impl ast::Parameter {
    fn span(&self) -> Span {
        self.name.span
    }
}
