//! Checks calls: applies the requirements of each kind of function to the matched arguments.

use super::argument_help::takes_text;
use super::infer::Checker;
use super::places::place_value;
use super::symbols::{Resolution, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, Bind, ExprKind, Mode};
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::{FileId, Span};

/// A called function, and whether each of its parameters has an argument.
struct Callee<'c> {
    decl: &'c ast::FunctionDecl,
    file: FileId,
    with_argument: &'c [bool],
    /// The function, if it has a body.
    function: Option<FuncId>,
}

/// Arguments that are evaluated before a call, because defaults of other parameters use them.
#[derive(Default)]
struct StoredArguments {
    /// The hidden variable of each parameter.
    variables: HashMap<VarId, VarId>,
    statements: Vec<Stmt>,
}

impl StoredArguments {
    /// Returns the statements in the order of evaluation: arguments as they are written in the
    /// call, then defaults.
    fn in_order(mut self, call: Span) -> Vec<Stmt> {
        let written =
            |s: &Stmt| s.span.file == call.file && call.start <= s.span.start && s.span.end <= call.end;
        self.statements.sort_by_key(|s| if written(s) { (0, s.span.start) } else { (1, 0) });
        self.statements
    }
}

impl<'a> Checker<'a> {
    pub(super) fn call(&mut self, callee: &'a ast::Expr, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let name = match &callee.kind {
            ExprKind::Name(name) | ExprKind::Field { field: name, .. } => name,
            _ => {
                self.as_value(|c| c.expr(callee));
                return self.not_callable("this", callee.span);
            }
        };
        match self.meaning(name.span) {
            Some(Resolution::Function(id)) => self.user_call(id, name, arguments, span),
            Some(Resolution::Record(id)) => self.record_call(id, arguments, span),
            Some(Resolution::Extern(id)) => self.extern_call(id, name, arguments, span),
            Some(Resolution::Builtin(builtin)) => self.builtin_call(builtin, name, arguments, span),
            Some(Resolution::Var(id)) if self.may_be_function(id) => {
                self.parameter_call(id, name, arguments, span)
            }
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

    pub(super) fn not_callable(&mut self, what: &str, span: Span) -> Expr {
        self.report(
            Diagnostic::error("E0306", format!("{what} is not a function"), span, "cannot be called")
                .help("only functions are called; write `*` to multiply")
                .suggest("multiply", Span { start: span.end, ..span }, " *"),
        );
        Expr::error(span)
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
                matches!(&decl.body, ast::FunctionBody::Extern { purity: Some(p), .. } if p.name == "pure");
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
        let with_argument: Vec<bool> = given.iter().map(Option::is_some).collect();
        let callee = Callee { decl, file, with_argument: &with_argument, function: None };
        for (parameter, argument) in decl.parameters.iter().zip(given) {
            let ty = self.in_file(file, |c| c.extern_parameter(parameter));
            let is_default = argument.is_none() && !fields.contains_key(parameter.name.name.as_str());
            let value = match (argument, &parameter.default) {
                (Some(argument), _) => match &ty {
                    Type::Symbolic(inner) => {
                        self.symbolic_argument(inner, &parameter.name, &ty, argument, arguments)
                    }
                    _ => {
                        let value = self.explained_argument(&ty, &parameter.name, argument, &callee);
                        self.former_none(&ty, parameter, value, argument, file)
                    }
                },
                (None, _) if fields.contains_key(parameter.name.name.as_str()) => {
                    self.field_argument(&ty, &parameter.name, &mut fields, span)
                }
                (None, Some((_, Some(default)))) => self.default_value(&ty, default, file, None),
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

    pub(super) fn in_file<T>(&mut self, file: FileId, work: impl FnOnce(&mut Self) -> T) -> T {
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
        if let Some((name, Bind::Symbolic)) = &argument.name
            && !matches!(self.store.known(ty), Type::Symbolic(_))
        {
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
        let value = self.as_value(|c| {
            let value = c.whole_for(ty, &argument.value);
            c.fitted(ty, value)
        });
        let value = self.named_handle(ty, value, &parameter.name);
        let takes = |c: &Self| format!("`{}` takes {}", parameter.name, with_article(&c.store.show(ty)));
        let wanted = self.without_optional(ty, &value);
        self.expect_from(&wanted, &value, format_args!("`{}`", parameter.name), (parameter.span, takes));
        self.as_optional(ty, value)
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
        self.expect(inner, &value, format_args!("`{}`", parameter.name), cause);
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
            None => parameter.name.to_string(),
        };
        self.made_symbolic(&name, value, ty.clone())
    }

    /// Converts a checked expression to a symbolic value of type `ty`.
    fn made_symbolic(&mut self, name: &str, value: Expr, ty: Type) -> Expr {
        let span = value.span;
        let def = self.make_def(name, value, span);
        Expr { kind: Kind::MakeSymbolic(def), ty, span }
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
        self.check_instance(id, span);
        if let ast::FunctionBody::Symbolic(_) = &decl.body {
            return self.symbolic_call(id, name, arguments, span);
        }
        if self.symbolic && self.names_symbols(arguments) {
            return self.symbolic_call(id, name, arguments, span);
        }
        if self.passes_observables(id, arguments) {
            let call = self.as_symbolic(|c| c.symbolic_call(id, name, arguments, span));
            return if self.symbolic { call } else { self.as_observable(call) };
        }
        self.value_call(id, (decl, file), name, arguments, span)
    }

    /// Checks a call whose arguments are evaluated.
    fn value_call(
        &mut self,
        id: FuncId,
        (decl, file): (&'a ast::FunctionDecl, FileId),
        name: &ast::Ident,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let given = self.given(&name.name, decl, arguments, span);
        let (types, result, instance) = self.instantiate(id, span);
        let Some((given, mut fields)) = given else {
            return Expr { kind: Kind::Error, ty: result, span };
        };
        let variables = self.names.functions[id.0 as usize].parameters.clone();
        let (mut values, mut copy_back, mut demands) = (Vec::new(), Vec::new(), Vec::new());
        let with_argument: Vec<bool> = given.iter().map(Option::is_some).collect();
        let mut stored = self.defaults_use_arguments(id, decl, &given).then(StoredArguments::default);
        let callee = Callee { decl, file, with_argument: &with_argument, function: Some(id) };
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
                    Type::Function(..) => {
                        let value = self.as_value(|c| c.function_argument(ty, &parameter.name, argument));
                        self.refuse_time(&value, &name.name);
                        value
                    }
                    _ => {
                        let value = self.explained_argument(ty, &parameter.name, argument, &callee);
                        self.former_none(ty, parameter, value, argument, file)
                    }
                },
                (Mode::In, None) if fields.contains_key(parameter.name.name.as_str()) => {
                    self.field_argument(ty, &parameter.name, &mut fields, span)
                }
                (Mode::In, None) => match (&parameter.default, self.store.shallow(ty)) {
                    (Some((_, Some(default))), Type::Symbolic(inner)) => {
                        let value = self.symbolic_default(&inner, &parameter.name, ty, default, file);
                        self.hand_over(variable, &value);
                        value
                    }
                    (Some((_, Some(default))), _) => self.default_value(ty, default, file, stored.as_ref()),
                    _ => Expr::error(span),
                },
                (_, Some(argument)) => {
                    let Some((place, value)) = self.place_argument(ty, &parameter.name, argument) else {
                        return Expr::error(span);
                    };
                    self.forget_variable(place.variable);
                    copy_back.push(place);
                    value
                }
                (_, None) => self.missing_place(&parameter.name.name, span),
            };
            let is_static = self.static_parameters.contains(&variable);
            if is_static {
                self.static_argument(&parameter.name, &value);
            }
            let value = match &mut stored {
                Some(stored) if parameter.mode == Mode::In => {
                    let kept = self.store_argument(&parameter.name, variable, value.clone(), stored);
                    // Params of the component use the expression before the model runs.
                    if is_static { value } else { kept }
                }
                _ => value,
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
        let call = Call {
            function: id,
            instance,
            arguments: values,
            copy_back,
            perhaps_same,
            demands,
            search: None,
        };
        let call = Expr { kind: Kind::Call(Box::new(call)), ty: result.clone(), span };
        self.observed(match stored {
            Some(stored) => {
                Expr { kind: Kind::Sequence(stored.in_order(span), Box::new(call)), ty: result, span }
            }
            None => call,
        })
    }

    /// Reports a call without a variable for an `out` or `inout` parameter.
    fn missing_place(&mut self, parameter: &str, span: Span) -> Expr {
        self.report(
            Diagnostic::error("E0310", format!("`{parameter}` needs a variable"), span, "missing")
                .help("an `out` or `inout` parameter has no default"),
        );
        Expr::error(span)
    }

    /// Returns `true` if the default of a parameter without an argument uses other parameters.
    fn defaults_use_arguments(
        &self,
        id: FuncId,
        decl: &ast::FunctionDecl,
        given: &[Option<&ast::Argument>],
    ) -> bool {
        let left_out = decl.parameters.iter().zip(given).filter(|(_, argument)| argument.is_none());
        let mut defaults = left_out.filter_map(|(parameter, _)| parameter.default.as_ref()?.1.as_ref());
        defaults.any(|default| self.uses_parameters(id, default))
    }

    /// Stores an argument before the call, so that defaults can use it, and returns its value.
    fn store_argument(
        &mut self,
        parameter: &ast::Ident,
        variable: VarId,
        value: Expr,
        stored: &mut StoredArguments,
    ) -> Expr {
        if matches!(value.kind, Kind::MakeSymbolic(_) | Kind::Function(..) | Kind::Error) {
            return value;
        }
        let written = value.span;
        let (hidden, statement) = self.keep(&parameter.name, value);
        if let Kind::Var(id) = hidden.kind {
            stored.variables.insert(variable, id);
        }
        stored.statements.push(statement);
        Expr { span: written, ..hidden }
    }

    /// Checks an argument that is evaluated. The help of an error names the omitted parameters that
    /// accept its value.
    fn explained_argument(
        &mut self,
        ty: &Type,
        parameter: &ast::Ident,
        argument: &'a ast::Argument,
        callee: &Callee<'_>,
    ) -> Expr {
        let reported = self.diagnostics.len();
        let value = self.value_argument(ty, parameter, argument);
        if self.diagnostics.len() > reported {
            let free = self.in_file(callee.file, |c| c.free_parameters(callee.decl, callee.with_argument));
            self.explain_argument(reported, (parameter, ty), argument, &value, &free);
            let declared = callee.decl.parameters.iter().find(|other| other.name.name == parameter.name);
            if declared.is_some_and(|declared| takes_text(ty, declared)) {
                self.explain_text(reported, parameter, argument);
            }
            if let Some(function) = callee.function {
                self.explain_sum(reported, function, (ty, &value.ty));
            }
        }
        value
    }

    /// Checks the default of a parameter, which is declared in `file`. It may use the stored
    /// arguments.
    fn default_value(
        &mut self,
        ty: &Type,
        default: &'a ast::Expr,
        file: FileId,
        stored: Option<&StoredArguments>,
    ) -> Expr {
        let earlier = stored.map(|stored| stored.variables.clone()).unwrap_or_default();
        let around = std::mem::replace(&mut self.elements, earlier);
        let value = self.in_file(file, |c| {
            c.as_value(|c| {
                let value = c.whole_for(ty, default);
                let value = c.named_handle(ty, value, "the default");
                let wanted = c.without_optional(ty, &value);
                c.expect(&wanted, &value, "the default", None);
                c.as_optional(ty, value)
            })
        });
        self.elements = around;
        value
    }

    fn symbolic_default(
        &mut self,
        inner: &Type,
        parameter: &ast::Ident,
        ty: &Type,
        default: &'a ast::Expr,
        file: FileId,
    ) -> Expr {
        let value = self.in_file(file, |c| c.as_symbolic(|c| c.whole(default)));
        self.expect(inner, &value, "the default", None);
        self.made_symbolic(&parameter.name, value, ty.clone())
    }

    /// Checks the argument of an `out` or `inout` parameter. Reports an argument that cannot be
    /// assigned, and returns `None`.
    fn place_argument(
        &mut self,
        ty: &Type,
        parameter: &ast::Ident,
        argument: &'a ast::Argument,
    ) -> Option<(Place, Expr)> {
        let place = self.as_value(|c| c.place(&argument.value))?;
        let value = Expr { kind: place_value(&place), ty: place.ty.clone(), span: argument.value.span };
        let value = self.presence(&argument.value, value, false, true);
        let cause = (parameter.span, format!("`{}` is an `out` or `inout` parameter", parameter.name));
        self.expect(ty, &value, format_args!("`{}`", parameter.name), Some(cause));
        Some((place, value))
    }
}
