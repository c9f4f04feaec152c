//! Checks symbolic functions, `function p(in u, in th) := e;`: their bodies and calls, and brackets
//! in symbolic expressions.
//!
//! A symbolic function is an expression with free arguments. A call in a `:=` is inlined into the
//! expression; elsewhere, a call evaluates the function's kernel. The function has no binding that
//! executes, so it captures no values: its body can use its arguments, `Time`, params, constants
//! and other symbolic functions.

use super::arguments::MatchedArguments;
use super::builtins::Builtin;
use super::infer::Checker;
use super::symbols::{Constant, Resolution, VarKind, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, Bind, ExprKind, Mode};
use crate::diagnostic::Diagnostic;
use crate::span::{FileId, Span};

impl<'a> Checker<'a> {
    /// Checks the body of a symbolic function.
    pub(super) fn symbolic_body(
        &mut self,
        id: FuncId,
        decl: &'a ast::FunctionDecl,
        body: &'a ast::Expr,
    ) -> SymbolicBody {
        for parameter in &decl.parameters {
            let symbolic = matches!(parameter.default, Some((Bind::Symbolic, _)));
            if parameter.mode != Mode::In || symbolic {
                self.report(
                    Diagnostic::error(
                        "E0512",
                        format!(
                            "the arguments of the symbolic function `{}` are free symbols",
                            decl.name.name
                        ),
                        parameter.name.span,
                        if symbolic { "declared with `:=`" } else { "handed back" },
                    )
                    .help(format!("write `in {}`", parameter.name.name)),
                );
            }
        }
        let value = self.as_symbolic(|c| c.whole(body));
        let result = self.current_result();
        let declared = decl.result.as_ref().map(|r| (r.span, format!("result of `{}`", decl.name.name)));
        self.expect(&result, &value, format_args!("the result of `{}`", decl.name.name), declared);
        self.dependence.returned(id, &value);
        let def = self.make_def_in(&decl.name.name, value, body.span, Some(id));
        if self.defs[def.0 as usize].observes {
            let diagnostic = self.observable_as_value(body.span);
            self.report(diagnostic);
        }
        let name = decl.name.span;
        let is_outside = self.names.functions[id.0 as usize].parent == Some(FuncId(0));
        let exported = name.file == FileId(0) && is_outside && !decl.is_anonymous();
        let statements = self.modules.first().map(|module| module.tree.statements.as_slice());
        let statement = statements.unwrap_or_default().iter().find(
            |statement| matches!(&statement.kind, ast::StmtKind::Function(decl) if decl.name.span == name),
        );
        let doc = statement.and_then(|statement| statement.doc.clone()).unwrap_or_default();
        SymbolicBody { def, exported, doc }
    }

    /// Rejects recursive symbolic functions, which have no finite expression.
    pub(super) fn check_symbolic_recursion(&mut self, group: &[FuncId]) {
        let recursive = group.len() > 1
            || group.iter().any(|id| self.names.functions[id.0 as usize].callees.contains(id));
        if !recursive {
            return;
        }
        for &id in group {
            let Some(decl) = self.names.functions[id.0 as usize].decl else { continue };
            if matches!(decl.body, ast::FunctionBody::Symbolic(_)) {
                self.report(
                    Diagnostic::error(
                        "E0513",
                        format!("the symbolic function `{}` is recursive", decl.name.name),
                        decl.name.span,
                        "its expression would be infinite",
                    )
                    .help("write a loop that binds a `:=` name again, or an ordinary function"),
                );
            }
        }
    }

    /// Checks a call of a symbolic function.
    pub(super) fn symbolic_call(
        &mut self,
        id: FuncId,
        name: &ast::Ident,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let info = &self.names.functions[id.0 as usize];
        let (Some(decl), file) = (info.decl, info.file) else { return Expr::error(span) };
        let given = self.given(&name.name, decl, arguments, span);
        let (types, result, instance) = self.instantiate(id, span);
        let Some(given) = given else {
            return Expr { kind: Kind::Error, ty: result, span };
        };
        let (arguments, demands) = self.symbolic_arguments(&decl.parameters, &types, given, (id, file, span));
        let call = Call {
            function: id,
            instance,
            arguments,
            copy_back: Vec::new(),
            perhaps_same: Vec::new(),
            demands: Vec::new(),
            search: None,
        };
        self.symbolic_or_evaluated(call, demands, (result, span), &name.name)
    }

    /// Returns a call of a symbolic function: as a part of the current symbolic expression, or as
    /// its value. A value is computed after a check of the arguments.
    pub(super) fn symbolic_or_evaluated(
        &mut self,
        mut call: Call,
        demands: Vec<(usize, ArgumentRange)>,
        (ty, span): (Type, Span),
        name: &str,
    ) -> Expr {
        let (mut kept, mut checks) = (Vec::new(), Vec::new());
        if !self.symbolic {
            for (at, demand) in demands {
                let Some(argument) = call.arguments.get_mut(at) else { continue };
                if demand.is_decided(argument, &self.store) {
                    continue;
                }
                // The check and the call use the same value.
                if super::places::calls(argument) {
                    let value = std::mem::replace(argument, Expr::error(span));
                    let written = value.span;
                    let value = self.evaluate_now(value, &demand.name);
                    let (value, keep) = self.keep(&demand.name, value);
                    kept.push(keep);
                    *argument = Expr { span: written, ..value };
                }
                let def = self.make_def(&demand.name, argument.clone(), argument.span);
                let checked = &self.defs[def.0 as usize];
                // Otherwise, the evaluation of the call reports that it has no value.
                if !checked.on_time && !checked.observes {
                    checks.push((def, demand));
                }
            }
        }
        let call = Expr { kind: Kind::SymbolicCall(Box::new(call)), ty: ty.clone(), span };
        if self.symbolic {
            return call;
        }
        let def = self.make_def(name, call, span);
        self.defs[def.0 as usize].checks = checks;
        let value = self.evaluated(def, span);
        match kept.is_empty() {
            true => value,
            false => Expr { kind: Kind::Sequence(kept, Box::new(value)), ty, span },
        }
    }

    /// Checks the arguments of parameters of the symbolic function `id`, which is declared in
    /// `file` and called at `span`. Returns the arguments, and the domains of those that are no
    /// defaults, by position.
    pub(super) fn symbolic_arguments(
        &mut self,
        parameters: &'a [ast::Parameter],
        types: &[Type],
        (given, mut fields): MatchedArguments<'a>,
        (id, file, span): (FuncId, FileId, Span),
    ) -> (Vec<Expr>, Vec<(usize, ArgumentRange)>) {
        let (mut values, mut demands) = (Vec::new(), Vec::new());
        for ((parameter, argument), ty) in parameters.iter().zip(given).zip(types) {
            let is_default = argument.is_none() && !fields.contains_key(parameter.name.name.as_str());
            let value = match (argument, &parameter.default) {
                (Some(argument), _) if self.is_function(ty) => {
                    self.as_symbolic(|c| c.function_argument(ty, &parameter.name, argument))
                }
                (Some(argument), _) => {
                    let value = self.as_symbolic(|c| c.whole(&argument.value));
                    let shown = with_article(&self.store.show(ty));
                    let cause = (parameter.name.span, format!("`{}` is {shown} here", parameter.name.name));
                    self.expect(ty, &value, format_args!("`{}`", parameter.name.name), Some(cause));
                    value
                }
                (None, _) if fields.contains_key(parameter.name.name.as_str()) => {
                    self.field_argument(ty, &parameter.name, &mut fields, span)
                }
                (None, Some((_, Some(default)))) if self.uses_parameters(id, default) => {
                    let name = &parameter.name.name;
                    self.report(
                        Diagnostic::error(
                            "E0512",
                            format!("a symbolic expression needs a value for `{name}`"),
                            span,
                            "left out",
                        )
                        .label(default.span, "the default uses another parameter")
                        .help(format!("pass it: `{name} = ...`")),
                    );
                    Expr { kind: Kind::Error, ty: ty.clone(), span }
                }
                (None, Some((_, Some(default)))) => self.in_file(file, |c| {
                    let value = c.as_symbolic(|c| c.whole(default));
                    c.expect(ty, &value, "the default", None);
                    value
                }),
                // Already reported as missing.
                (None, _) => Expr::error(span),
            };
            if !is_default {
                let domain = parameter.domain.as_ref();
                let demand = self.in_file(file, |c| c.domain(ty, domain, Some(&value), &parameter.name.name));
                demands.extend(demand.map(|demand| (values.len(), demand)));
            }
            values.push(value);
        }
        (values, demands)
    }

    /// Returns `true` if a variable is an argument of the current symbolic function.
    pub(super) fn is_argument(&self, id: VarId) -> bool {
        let variable = self.variable(id);
        variable.owner == self.function
            && matches!(variable.kind, VarKind::Parameter(_))
            && self.names.functions[self.function.0 as usize].is_symbolic()
    }

    pub(super) fn outside_argument(&self, name: &str, span: Span) -> Diagnostic {
        Diagnostic::error(
            "E0511",
            format!("a symbolic function cannot use the value of `{name}`"),
            span,
            "not an argument",
        )
        .help(format!(
            "pass `{name}` as an argument; the body can use only arguments, `Time`, params, constants and symbolic functions"
        ))
    }

    pub(super) fn report_capture_in_function(&mut self, value: &Expr) {
        let diagnostic = match &value.kind {
            Kind::Error => return,
            Kind::Var(id) | Kind::Chosen(id) => {
                let variable = self.variable(*id);
                self.outside_argument(&variable.name, value.span).label(variable.span, "declared here")
            }
            _ => Diagnostic::error(
                "E0511",
                "a symbolic function cannot evaluate this, because it is not a symbolic expression",
                value.span,
                "not symbolic",
            )
            .help("compute it before the call and pass it as an argument"),
        };
        self.report(diagnostic);
    }

    /// Returns `true` if arguments contain `Time`, `:=` names or arguments of the enclosing
    /// symbolic function. A function that is called with such arguments must be inlined into the
    /// expression.
    pub(super) fn names_symbols(&self, arguments: &'a [ast::Argument]) -> bool {
        let mut pending: Vec<&ast::Expr> = arguments.iter().map(|argument| &argument.value).collect();
        while let Some(e) = pending.pop() {
            // A captured value is an argument of the anonymous function.
            if self.names.captured.contains_key(&(self.function, e.span)) {
                return true;
            }
            if let ExprKind::Anonymous(decl) = &e.kind {
                pending.extend(self.captured_by(decl).iter().map(|(value, _)| *value));
            }
            if let ExprKind::Name(name) = &e.kind {
                let symbol = match self.names.uses.get(&name.span) {
                    Some(Resolution::Constant(Constant::Time)) => true,
                    Some(Resolution::Var(id)) => {
                        self.variable(*id).kind == VarKind::Symbolic || self.is_argument(*id)
                    }
                    _ => false,
                };
                if symbol {
                    return true;
                }
            }
            pending.extend(parts(e));
        }
        false
    }

    // Brackets.

    /// Returns `true` if the syntax of an expression may denote brackets of symbolic expressions
    /// (and not the value of an array).
    pub(super) fn names_brackets(&self, e: &ast::Expr) -> bool {
        if self.names.captured.contains_key(&(self.function, e.span)) {
            return true;
        }
        match &e.kind {
            ExprKind::List(_) => true,
            ExprKind::Paren(inner) => self.names_brackets(inner),
            ExprKind::Index { base, .. } | ExprKind::Field { base, .. } => self.names_brackets(base),
            ExprKind::At { value, .. } => self.names_brackets(value),
            ExprKind::If { then, otherwise, .. } => {
                self.names_brackets(then) && self.names_brackets(otherwise)
            }
            ExprKind::Name(name) => match self.names.uses.get(&name.span) {
                Some(Resolution::Var(id)) => {
                    self.variable(*id).kind == VarKind::Symbolic || self.is_of_symbolic_function(*id)
                }
                _ => false,
            },
            ExprKind::Call { callee, .. } => {
                let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
                    return false;
                };
                match self.names.uses.get(&name.span) {
                    Some(Resolution::Function(id)) => self.names.functions[id.0 as usize].is_symbolic(),
                    Some(Resolution::Builtin(builtin)) => {
                        matches!(builtin, Builtin::Gradient | Builtin::Derivative | Builtin::Solve(_))
                    }
                    // A parameter that is a function.
                    Some(Resolution::Var(_)) => true,
                    _ => false,
                }
            }
            _ => false,
        }
    }

    /// Returns `true` if a checked expression has brackets of symbolic expressions as its value.
    pub(super) fn is_symbolic_brackets(&self, e: &Expr) -> bool {
        !matches!(e.kind, Kind::Array(_)) && self.is_brackets(e)
    }

    pub(super) fn is_brackets(&self, e: &Expr) -> bool {
        match &e.kind {
            Kind::Array(_)
            | Kind::Tuple(_)
            | Kind::SymbolicCall(_)
            | Kind::Applied(_)
            | Kind::Gradient(..) => true,
            Kind::Def(def) => self.is_brackets(&self.defs[def.0 as usize].expr),
            Kind::Var(id) if self.variable(*id).kind == VarKind::Hidden => {
                // A captured record or tuple has a known number of values, unlike an array.
                matches!(self.store.known(&e.ty), Type::Record(_) | Type::Tuple(_))
            }
            Kind::Var(id) => self.is_of_symbolic_function(*id),
            Kind::Block(_, result) | Kind::Part(result) => self.is_brackets(result),
            Kind::Index(base, _)
            | Kind::TupleElement(base, _)
            | Kind::Field(base, _)
            | Kind::At(base, ..)
            | Kind::Derivative(base, _) => self.is_brackets(base),
            Kind::If(_, then, otherwise) => self.is_brackets(then) && self.is_brackets(otherwise),
            _ => false,
        }
    }

    /// Returns `true` for numbers, vectors, frames, and brackets of them, which can stay symbolic.
    pub(super) fn can_stay_symbolic(&self, e: &Expr) -> bool {
        let ty = self.store.resolve(&e.ty);
        is_symbolic_value(&ty)
            || matches!(ty, Type::Array(_) | Type::Tuple(_) | Type::Record(_))
                && self.is_brackets_of_values(&ty)
                && self.is_brackets(e)
    }

    /// Returns `true` for an element of symbolic brackets.
    pub(super) fn is_brackets_part(&self, e: &Expr) -> bool {
        match &e.kind {
            Kind::Index(base, _) | Kind::TupleElement(base, _) | Kind::Field(base, _) => {
                self.is_brackets(base)
            }
            _ => false,
        }
    }

    /// Converts a text of a `:=` record to its value: that with which the record was bound.
    pub(super) fn text_value(&self, e: Expr) -> Expr {
        if let Some(bound) = self.bound_part(&e) {
            return bound;
        }
        let kind = match e.kind {
            Kind::Def(def) => Kind::Eval(def, None),
            Kind::TupleElement(base, at) => Kind::TupleElement(Box::new(self.text_value(*base)), at),
            Kind::Field(base, name) => Kind::Field(Box::new(self.text_value(*base)), name),
            kind => kind,
        };
        Expr { kind, ..e }
    }

    /// Returns the literal or the captured value that is bound as a part of a `:=` record; `None`
    /// if the part is another expression.
    fn bound_part(&self, e: &Expr) -> Option<Expr> {
        match &e.kind {
            Kind::Text(_) | Kind::Var(_) => Some(e.clone()),
            Kind::TupleElement(base, at) => {
                let mut base = &**base;
                while let Kind::Def(def) = base.kind {
                    base = &self.defs[def.0 as usize].expr;
                }
                match &base.kind {
                    Kind::Tuple(all) => self.bound_part(all.get(*at)?),
                    _ => {
                        let base = Box::new(self.bound_part(base)?);
                        Some(Expr { kind: Kind::TupleElement(base, *at), ..e.clone() })
                    }
                }
            }
            _ => None,
        }
    }

    fn is_brackets_of_values(&self, ty: &Type) -> bool {
        match self.store.known(ty) {
            // The expression itself.
            Type::Symbolic(inner) => self.is_brackets_of_values(inner),
            // No expression can use a text or a choice of a record.
            Type::String | Type::Enum(_) => true,
            Type::Array(element) => self.is_brackets_of_values(element),
            Type::Tuple(parts) => parts.iter().all(|part| self.is_brackets_of_values(part)),
            Type::Record(id) => self
                .store
                .record(*id)
                .is_some_and(|record| record.fields.iter().all(|(_, ty)| self.is_brackets_of_values(ty))),
            other => is_symbolic_value(other),
        }
    }
}

impl Checker<'_> {
    /// Returns `true` if an expression uses a parameter of a function.
    pub(super) fn uses_parameters(&self, id: FuncId, e: &ast::Expr) -> bool {
        let own = &self.names.functions[id.0 as usize].parameters;
        let mut pending = vec![e];
        while let Some(e) = pending.pop() {
            if let ExprKind::Name(name) = &e.kind
                && let Some(Resolution::Var(variable)) = self.names.uses.get(&name.span)
                && own.contains(variable)
            {
                return true;
            }
            if let ExprKind::String(text) = &e.kind {
                pending.extend(text.iter().filter_map(|part| match part {
                    ast::StringPart::Value(value, _) => Some(value),
                    ast::StringPart::Text(_) => None,
                }));
            }
            pending.extend(parts(e));
        }
        false
    }
}

/// Returns the subexpressions from which an expression's value is computed.
fn parts(e: &ast::Expr) -> Vec<&ast::Expr> {
    match &e.kind {
        ExprKind::Field { base: a, .. }
        | ExprKind::Unary { operand: a, .. }
        | ExprKind::Paren(a)
        | ExprKind::IsNone { value: a, .. } => vec![a],
        ExprKind::Index { base: a, index: b } | ExprKind::Binary { left: a, right: b, .. } => vec![a, b],
        ExprKind::At { value, at, .. } => vec![value, at],
        ExprKind::If { condition, then, otherwise } => vec![condition, then, otherwise],
        ExprKind::Call { arguments, .. } => arguments.iter().map(|argument| &argument.value).collect(),
        ExprKind::List(all) | ExprKind::Measured { elements: all, .. } => all.iter().collect(),
        ExprKind::Slice { base, low, high } => {
            low.iter().chain(high).chain([base]).map(|part| &**part).collect()
        }
        ExprKind::Comprehension(parts) => {
            let inside = parts.condition.iter().chain([&parts.element]);
            parts.values.expressions().into_iter().chain(inside).collect()
        }
        _ => Vec::new(),
    }
}

fn is_symbolic_value(ty: &Type) -> bool {
    matches!(ty, Type::Number(_) | Type::Vector(_) | Type::Transform | Type::Unknown(_) | Type::Error)
}
