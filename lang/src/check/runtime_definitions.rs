//! Symbolic names whose expression is selected at run time: bound again in a loop or on one of
//! several branches, bound by another function, or passed to a function by `in frame :=`.
//!
//! Such a name is a variable whose value is an expression. Expressions that use it capture this
//! value, so at run time they form a graph. A use that only one binding can reach is still inlined.

use super::infer::{Checker, Reaching};
use super::symbols::VarKind;
use super::tree::*;
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::Span;
use std::collections::BTreeSet;

#[derive(Debug, Default)]
pub struct RuntimeDefinitions {
    /// Names with a use that several definitions can reach.
    pub chosen: BTreeSet<VarId>,
    /// Names that are bound by functions other than their own.
    pub foreign: BTreeSet<VarId>,
    /// All definitions of each name.
    pub bound: HashMap<VarId, Vec<DefId>>,
    /// For each hidden variable, the name whose expression it captures.
    pub captured: HashMap<VarId, VarId>,
    /// Evaluations without a time of expressions that depend on run-time selected names:
    /// definition, name, location.
    evaluated: Vec<(DefId, String, Span)>,
}

impl<'a> Checker<'a> {
    /// Returns the expression for a use of a `:=` name that several definitions can reach.
    pub(super) fn chosen_name(&mut self, id: VarId, span: Span) -> Expr {
        self.graphs.chosen.insert(id);
        let e = Expr { kind: Kind::Chosen(id), ty: self.variable_type(id), span };
        if self.symbolic {
            return e;
        }
        let name = self.variable(id).name.clone();
        self.evaluate_now(e, &name)
    }

    /// Marks a symbolic parameter: its expression is that of the call.
    pub(super) fn symbolic_parameter(&mut self, variable: VarId) {
        self.graphs.chosen.insert(variable);
        self.reaching.insert(variable, Reaching::Several);
    }

    /// Records an expression that is passed to a symbolic parameter.
    pub(super) fn hand_over(&mut self, parameter: VarId, value: &Expr) {
        if let Kind::MakeSymbolic(def) = value.kind {
            self.defs[def.0 as usize].part = true;
            self.graphs.bound.entry(parameter).or_default().push(def);
        }
    }

    /// Records an evaluation that must not depend on time; this is checked when all definitions are
    /// known.
    pub(super) fn evaluated_later(&mut self, def: DefId, name: &str, span: Span) {
        if !self.defs[def.0 as usize].chosen.is_empty() {
            self.graphs.evaluated.push((def, name.into(), span));
        }
    }

    /// Finds names that nested functions bind although other functions declare them.
    pub(super) fn find_foreign(&mut self, statements: &'a [ast::Stmt]) {
        for statement in statements {
            let mut inside: Vec<(&'a ast::FunctionDecl, BTreeSet<VarId>)> = Vec::new();
            self.bound_in_functions(statement, &mut inside);
            for (decl, bound) in inside {
                let own = match self.names.uses.get(&decl.name.span) {
                    Some(super::symbols::Resolution::Function(id)) => Some(*id),
                    _ => None,
                };
                let foreign = bound.into_iter().filter(|id| {
                    Some(self.variable(*id).owner) != own && self.variable(*id).kind == VarKind::Symbolic
                });
                let foreign: Vec<VarId> = foreign.collect();
                self.graphs.foreign.extend(foreign);
            }
        }
    }

    /// Collects the names that functions declared in a statement bind.
    fn bound_in_functions(
        &self,
        statement: &'a ast::Stmt,
        found: &mut Vec<(&'a ast::FunctionDecl, BTreeSet<VarId>)>,
    ) {
        use ast::StmtKind::*;
        match &statement.kind {
            Function(decl) => {
                if let ast::FunctionBody::Statement(body) = &decl.body {
                    let mut bound = BTreeSet::new();
                    self.bound_in(body, &mut bound);
                    found.push((decl, bound));
                    self.bound_in_functions(body, found);
                }
            }
            Block(all) => all.iter().for_each(|s| self.bound_in_functions(s, found)),
            If { then, otherwise, .. } => {
                self.bound_in_functions(then, found);
                otherwise.iter().for_each(|s| self.bound_in_functions(s, found));
            }
            While { body, .. }
            | DoWhile { body, .. }
            | Switch { body, .. }
            | For { body, .. }
            | ForEach { body, .. } => self.bound_in_functions(body, found),
            Case { statement, .. } | Default(statement) | Label { statement, .. } => {
                self.bound_in_functions(statement, found)
            }
            Try { body, handler, .. } => {
                self.bound_in_functions(body, found);
                self.bound_in_functions(handler, found);
            }
            _ => {}
        }
    }

    /// Checks run-time selected names after inference: a property of any definition of a name is a
    /// property of the name.
    pub(super) fn finish_graphs(&mut self) {
        let mut on_time: BTreeSet<VarId> = BTreeSet::new();
        loop {
            let before = on_time.len();
            for id in &self.graphs.chosen {
                let depends = |def: &DefId| {
                    let def = &self.defs[def.0 as usize];
                    def.on_time || !def.chosen.is_disjoint(&on_time)
                };
                if self.graphs.bound.get(id).is_some_and(|defs| defs.iter().any(depends)) {
                    on_time.insert(*id);
                }
            }
            if on_time.len() == before {
                break;
            }
        }
        let mut found = Vec::new();
        for (def, name, span) in &self.graphs.evaluated {
            let def = &self.defs[def.0 as usize];
            let Some(id) = def.chosen.intersection(&on_time).next() else { continue };
            found.push(
                Diagnostic::error(
                    "E0502",
                    format!("`{name}` depends on `Time`, so it has no value here"),
                    *span,
                    "this is evaluated immediately",
                )
                .label(self.variable(*id).span, "declared here")
                .help(format!(
                    "bind the result with `:=`, too, or evaluate at a time: `{name} at Time = 0.1 s`"
                )),
            );
        }
        for id in &self.graphs.chosen {
            for def in self.graphs.bound.get(id).into_iter().flatten() {
                let def = &self.defs[def.0 as usize];
                if def.observes {
                    let name = &self.variable(*id).name;
                    found.push(
                        Diagnostic::error(
                            "E0505",
                            format!("the expression of `{name}` is selected at run time and cannot contain an observable"),
                            def.span,
                            "this contains an observable",
                        )
                        .label(self.variable(*id).span, "has several expressions")
                        .help("bind the observable to a separate name"),
                    );
                }
            }
        }
        found.into_iter().for_each(|diagnostic| self.report(diagnostic));
    }
}
