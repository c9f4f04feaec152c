//! Checks components: their params, the members of their instances, and where they are
//! instantiated.
//!
//! A component is a function whose body runs once per instance. Its result is a record, nominal as
//! the component, with its parameters, params, variables and outputs. A params file names the
//! params of every instance, so the instances of a program must be known before it runs: they are
//! the declarations `var name = Component(...)` at the top level of the model and of components.

use super::infer::{Checker, Reaching};
use super::stored_expressions::is_stored;
use super::symbols::{Resolution, VarKind};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, ExprKind};
use crate::diagnostic::{Diagnostic, Severity};
use crate::span::Span;
use std::collections::{BTreeMap, BTreeSet};

/// The params and outputs of a component by name, each as "param" or "output".
pub(super) type FixedMembers = BTreeMap<String, &'static str>;

impl<'a> Checker<'a> {
    /// Returns the record of a component's instances; `None` for other functions.
    pub(super) fn component_record(&self, id: FuncId) -> Option<RecordId> {
        let at = self.components.iter().position(|component| *component == id)?;
        Some(RecordId((self.names.records.len() + at) as u32))
    }

    /// Returns the component whose instances have the type of a record.
    pub(super) fn component_of(&self, record: RecordId) -> Option<FuncId> {
        let at = (record.0 as usize).checked_sub(self.names.records.len())?;
        self.components.get(at).copied()
    }

    /// Returns the number of records, including those of components.
    pub(super) fn record_count(&self) -> usize {
        self.names.records.len() + self.components.len()
    }

    /// Returns the component that contains a function; a component contains itself.
    pub(super) fn component_around(&self, id: FuncId) -> Option<FuncId> {
        let mut at = Some(id);
        while let Some(function) = at {
            let info = &self.names.functions[function.0 as usize];
            if info.is_component() {
                return Some(function);
            }
            at = info.parent;
        }
        None
    }

    /// Creates a variable for the observable of an output.
    pub(super) fn observable_variable(&mut self, name: &str, ty: &Type, span: Span) -> VarId {
        let dim = match self.store.shallow(ty) {
            Type::Number(dim) => dim,
            _ => self.store.fresh_dim(),
        };
        self.hidden_variable(name, span, Type::Observable(dim))
    }

    // Members.

    /// Returns the statement that ends the body of a component: it returns the members of the
    /// instance. Their types become those of the component's record.
    pub(super) fn members(
        &mut self,
        id: FuncId,
        decl: &'a ast::FunctionDecl,
        statements: &'a [ast::Stmt],
    ) -> Stmt {
        let mut members: Vec<(String, Expr)> = Vec::new();
        let parameters = self.names.functions[id.0 as usize].parameters.clone();
        for (parameter, variable) in decl.parameters.iter().zip(parameters) {
            if self.variable(variable).kind != VarKind::Symbolic {
                let member = self.member_value(Kind::Var(variable), variable, parameter.name.span);
                members.push((parameter.name.name.to_string(), member));
            }
        }
        for name in statements.iter().flat_map(declared_names) {
            let kind = match self.names.uses.get(&name.span).copied() {
                Some(Resolution::Var(variable)) if self.variable(variable).kind == VarKind::Value => {
                    let member = self.member_value(Kind::Var(variable), variable, name.span);
                    members.push((name.name.to_string(), member));
                    continue;
                }
                Some(Resolution::Var(variable)) if self.variable(variable).kind == VarKind::Symbolic => {
                    let member = self.expression_member(variable, name.span);
                    members.extend(member.map(|member| (name.name.to_string(), member)));
                    continue;
                }
                Some(Resolution::Param(param)) => {
                    let ty = self.params[param as usize].ty.clone();
                    Expr { kind: Kind::Param(param), ty, span: name.span }
                }
                Some(Resolution::Output(_)) => {
                    let own = |known: &&Output| known.span == name.span;
                    let Some(variable) = self.outputs.iter().find(own).and_then(|known| known.member) else {
                        continue;
                    };
                    self.member_value(Kind::Var(variable), variable, name.span)
                }
                _ => continue,
            };
            members.push((name.name.to_string(), kind));
        }
        let fixed = statements.iter().filter_map(|statement| match &statement.kind {
            ast::StmtKind::Param(decl) => Some((decl.name.name.to_string(), "param")),
            ast::StmtKind::Output { name, .. } => Some((name.name.to_string(), "output")),
            _ => None,
        });
        self.fixed_members.insert(id, fixed.collect());
        let fields = members.iter().map(|(name, value)| (name.clone(), value.ty.clone())).collect();
        let record = self.component_record(id).unwrap_or(RecordId(0));
        if let Some(known) = self.store.records.get_mut(record.0 as usize) {
            known.fields = fields;
        }
        let span = decl.name.span;
        let values = members.into_iter().map(|(_, value)| value).collect();
        let result = Expr { kind: Kind::Tuple(values), ty: Type::Record(record), span };
        self.note_evaluated(&result);
        self.dependence.returned(id, &result);
        Stmt { kind: StmtKind::Return(Some(result)), span }
    }

    /// Returns the value of a name bound with `:=` as a member: an expression if it depends on
    /// `Time`.
    /// `None` if its expression is selected at run time.
    fn expression_member(&mut self, variable: VarId, span: Span) -> Option<Expr> {
        let Some(Reaching::One(def)) = self.reaching.get(&variable).copied() else { return None };
        let found = &self.defs[def.0 as usize];
        let ty = self.store.shallow(&found.expr.ty);
        let (on_time, observes) = (found.on_time, found.observes);
        if !found.chosen.is_empty() || observes && !matches!(ty, Type::Number(_)) {
            return None;
        }
        if !on_time || observes {
            return Some(self.as_value(|c| c.evaluated(def, span)));
        }
        let (name, ty) = (self.variable(variable).name.clone(), found_type(&ty)?);
        let expression = Expr { kind: Kind::Def(def), ty, span };
        Some(self.as_value(|c| c.as_expression(&name, expression)))
    }

    fn member_value(&mut self, kind: Kind, variable: VarId, span: Span) -> Expr {
        Expr { kind, ty: self.variable_type(variable), span }
    }

    /// Checks components after inference: an instance contains no instance of its own component,
    /// and the types of its members are known.
    pub(super) fn check_components(&mut self, group: &[FuncId]) {
        for &id in group {
            let info = &self.names.functions[id.0 as usize];
            let Some(decl) = info.decl.filter(|decl| decl.is_component) else { continue };
            let (name, recursive) = (decl.name.name.clone(), group.len() > 1 || info.callees.contains(&id));
            if recursive {
                let others = group.iter().filter(|other| **other != id);
                let others = others.map(|other| &self.names.functions[other.0 as usize]);
                let through: Vec<String> = others.map(|other| format!("`{}`", other.name)).collect();
                let message = match through.is_empty() {
                    true => format!("the component `{name}` contains itself"),
                    false => format!("the component `{name}` contains itself through {}", through.join(", ")),
                };
                self.report(
                    Diagnostic::error("E0872", message, decl.name.span, "its instances would never end")
                        .help("describe repeated parts by an array of instances of another component"),
                );
                self.cut_endless_members(id);
            }
            self.check_member_types(id, decl);
        }
    }

    /// Removes the types of the members through which a component contains itself, so that its
    /// instances have a finite type and their uses cause no further errors.
    fn cut_endless_members(&mut self, id: FuncId) {
        let Some(record) = self.component_record(id) else { return };
        let fields = self.store.record(record).map_or(0, |record| record.fields.len());
        for at in 0..fields {
            let endless = self.store.record(record).is_some_and(|record| {
                record.fields.get(at).is_some_and(|(_, ty)| !self.store.is_bounded(ty))
            });
            let known = self.store.records.get_mut(record.0 as usize);
            if let Some((_, ty)) = known.filter(|_| endless).and_then(|known| known.fields.get_mut(at)) {
                *ty = Type::Error;
            }
        }
    }

    /// Returns what a member of an instance is, a param or an output, if it cannot be assigned.
    pub(super) fn fixed_member(&self, record: RecordId, name: &str) -> Option<&'static str> {
        self.fixed_members.get(&self.component_of(record)?)?.get(name).copied()
    }

    /// Reports members whose type depends on the uses of the component.
    fn check_member_types(&mut self, id: FuncId, decl: &'a ast::FunctionDecl) {
        let Some(record) = self.component_record(id).and_then(|record| self.store.record(record)).cloned()
        else {
            return;
        };
        let parameters = self.names.functions[id.0 as usize].parameters.clone();
        let parameters: Vec<(ast::Ident, Type)> = decl
            .parameters
            .iter()
            .zip(parameters)
            .map(|(parameter, variable)| (parameter.name.clone(), self.variable_type(variable)))
            .collect();
        let open = |checker: &Self, ty: &Type| {
            let (mut types, mut dims) = (BTreeSet::new(), BTreeSet::new());
            checker.store.unknowns(ty, &mut types, &mut dims);
            !types.is_empty() || dims.iter().any(|dim| !checker.store.is_literal(*dim))
        };
        let mut reported = false;
        for (name, ty) in &parameters {
            if open(self, ty) {
                reported = true;
                self.report(
                    Diagnostic::error(
                        "E0873",
                        format!("the type of `{}` does not follow from the component", name.name),
                        name.span,
                        "all instances have one type",
                    )
                    .help(format!("write the type: `{}: Length`, `{0}: Number`, `{0}: Gear`", name.name)),
                );
            }
        }
        let ast::FunctionBody::Statement(body) = &decl.body else { return };
        let ast::StmtKind::Block(statements) = &body.kind else { return };
        for name in statements.iter().flat_map(declared_names) {
            let ty = record.fields.iter().find(|(field, _)| *field == name.name).map(|(_, ty)| ty);
            // Another error in the component may be the reason, and is reported.
            if !reported && ty.is_some_and(|ty| open(self, ty)) && !self.is_wrong_within(body.span) {
                self.report(
                    Diagnostic::error(
                        "E0873",
                        format!("the type of `{}` does not follow from the component", name.name),
                        name.span,
                        "all instances have one type",
                    )
                    .help("give it a value whose type is known, or move it into a function"),
                );
            }
        }
    }

    /// Returns whether an error is reported within a part of the text.
    fn is_wrong_within(&self, part: Span) -> bool {
        let within = |span: &Span| span.file == part.file && part.start <= span.start && span.end <= part.end;
        let errors = self.diagnostics.iter().filter(|found| found.severity == Severity::Error);
        let unknown = |(span, res): (&Span, &Resolution)| *res == Resolution::Unknown && within(span);
        errors.map(|found| &found.primary.span).any(within) || self.names.uses.iter().any(unknown)
    }

    // Instances.

    /// Records the calls in declarations of a top level or of a component, which may instantiate
    /// components: initial values, and elements of arrays in them.
    pub(super) fn note_instance_sites(&mut self, statements: &'a [ast::Stmt]) {
        for statement in statements {
            let ast::StmtKind::Var(decls) = &statement.kind else { continue };
            for decl in decls {
                if let Some((ast::Bind::Evaluate, value)) = &decl.init {
                    self.note_instance_site(value);
                }
            }
        }
    }

    fn note_instance_site(&mut self, value: &'a ast::Expr) {
        match &value.kind {
            ExprKind::Call { .. } => {
                self.instance_sites.insert(value.span);
            }
            ExprKind::Paren(inner) => self.note_instance_site(inner),
            ExprKind::List(elements) => elements.iter().for_each(|element| self.note_instance_site(element)),
            ExprKind::Comprehension(parts) => {
                self.instance_sites.insert(parts.element.span);
                self.note_instance_site(&parts.element);
            }
            _ => {}
        }
    }

    /// Checks that a call of a component is a declaration of an instance.
    pub(super) fn check_instance(&mut self, id: FuncId, span: Span) {
        if !self.names.functions[id.0 as usize].is_component() || self.instance_sites.contains(&span) {
            return;
        }
        let name = self.names.functions[id.0 as usize].name.clone();
        self.report(
            Diagnostic::error(
                "E0874",
                format!("an instance of `{name}` has no name here"),
                span,
                "not a declaration at the top level of a model or component",
            )
            .help(format!(
                "declare it there: `var part = {name}(...);`, or several: `var parts = [{name}(...), {name}(...)];`"
            )),
        );
    }

    /// Returns `true` for a parameter of the component being checked that a param's default may
    /// use, and records this use.
    pub(super) fn static_parameter(&mut self, id: VarId) -> bool {
        let variable = self.variable(id);
        let own = variable.owner == self.function
            && matches!(variable.kind, VarKind::Parameter(_))
            && self.names.functions[self.function.0 as usize].is_component();
        let found = own && self.declaring_param;
        if found {
            self.static_parameters.insert(id);
        }
        found
    }

    /// Checks an argument of a component that a param's default uses: it must be known before the
    /// run.
    pub(super) fn static_argument(&mut self, parameter: &ast::Ident, argument: &Expr) {
        let mut pending = vec![argument];
        let mut found: Vec<(Span, String)> = Vec::new();
        let mut outer = Vec::new();
        while let Some(e) = pending.pop() {
            match &e.kind {
                Kind::Var(id) => {
                    let variable = self.variable(*id);
                    let own = variable.owner == self.function
                        && matches!(variable.kind, VarKind::Parameter(_))
                        && self.names.functions[self.function.0 as usize].is_component();
                    match own {
                        true => outer.push(*id),
                        false => found.push((e.span, format!("the variable `{}`", variable.name))),
                    }
                }
                Kind::Eval(..)
                | Kind::Def(_)
                | Kind::MakeSymbolic(_)
                | Kind::Chosen(_)
                | Kind::Observe(_) => {
                    found.push((e.span, "a name that is bound with `:=`".into()));
                }
                Kind::CallExtern(id, ..) => {
                    let decl = self.names.externs[*id as usize].decl;
                    let pure = matches!(&decl.body, ast::FunctionBody::Extern { purity: Some(word), .. } if word.name == "pure");
                    if !pure {
                        found.push((e.span, "a call that changes the model".into()));
                    }
                }
                Kind::Sequence(..) => {
                    found.push((e.span, "a value that a loop computes".into()));
                    continue;
                }
                _ => {}
            }
            pending.extend(e.children());
        }
        self.static_parameters.extend(outer);
        if let Some((span, used)) = found.into_iter().next() {
            let name = &parameter.name;
            let help = match used.strip_prefix("the variable ") {
                Some(variable) => format!("declare {variable} with `param` or `const`, or pass a literal"),
                None => "pass literals, params, and functions of them".into(),
            };
            self.report(
                Diagnostic::error(
                    "E0875",
                    format!("the argument `{name}` sets a param, so it cannot use {used}"),
                    span,
                    "has no value yet when params are set",
                )
                .label(
                    parameter.span,
                    format!("a param of the component uses `{name}` in its default or range"),
                )
                .help(help),
            );
        }
    }
}

/// Returns the type of an expression that is stored.
fn found_type(ty: &Type) -> Option<Type> {
    is_stored(ty).then(|| ty.clone())
}

/// Returns the names that a statement of a component declares.
pub(crate) fn declared_names(statement: &ast::Stmt) -> Vec<&ast::Ident> {
    match &statement.kind {
        ast::StmtKind::Var(decls) => decls.iter().map(|decl| &decl.name).collect(),
        ast::StmtKind::Param(decl) => vec![&decl.name],
        ast::StmtKind::Output { name, .. } => vec![name],
        _ => Vec::new(),
    }
}
