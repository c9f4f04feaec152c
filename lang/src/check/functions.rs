//! Inference of functions: groups of mutually recursive functions, their signatures and bodies.

use super::infer::{Checker, Signature};
use super::symbols::VarKind;
use super::tree::*;
use super::types::Type;
use crate::ast;
use crate::hashed::HashMap;
use std::rc::Rc;

impl Checker<'_> {
    /// Infers a function and its group after the functions that it calls. Does nothing if they are
    /// already inferred.
    pub fn ensure_inferred(&mut self, id: FuncId) {
        // Iterative, because a chain of calls may be as long as a program.
        let mut open = vec![(id, false)];
        while let Some((id, called_are_inferred)) = open.pop() {
            // The enclosing function may already have reached its body.
            if self.signatures.contains_key(&id) {
                continue;
            }
            let Some(group) = self.groups.get(&id).cloned() else { continue };
            if called_are_inferred {
                self.infer_group(&group);
                continue;
            }
            open.push((id, true));
            let called: Vec<FuncId> = group
                .iter()
                .flat_map(|member| &self.names.functions[member.0 as usize].callees)
                .copied()
                .collect();
            // Functions of a component are inferred where its body reaches them, when the types of
            // the variables before them are known.
            let inside = |callee: &FuncId| {
                let around = self.component_around(*callee).filter(|around| around != callee);
                around.is_some_and(|around| group.contains(&around))
            };
            let outside = |callee: &FuncId| {
                !inside(callee) && !self.groups.get(callee).is_some_and(|of| Rc::ptr_eq(of, &group))
            };
            open.extend(called.into_iter().rev().filter(outside).map(|callee| (callee, false)));
        }
    }

    fn infer_group(&mut self, group: &[FuncId]) {
        let outer_constraints = std::mem::take(&mut self.pending);
        self.check_symbolic_recursion(group);
        for &member in group {
            self.declare_signature(member);
        }
        for &member in group {
            self.function_body(member);
        }
        self.solve_constraints();
        let inner = std::mem::replace(&mut self.pending, outer_constraints);
        self.generalise(group, inner);
        self.check_components(group);
    }

    fn declare_signature(&mut self, id: FuncId) {
        let Some(decl) = self.names.functions[id.0 as usize].decl else { return };
        let file = std::mem::replace(&mut self.file, self.names.functions[id.0 as usize].file);
        let variables = self.names.functions[id.0 as usize].parameters.clone();
        let mut parameters = Vec::new();
        for (parameter, variable) in decl.parameters.iter().zip(variables) {
            let ty = self.variable_type(variable);
            let symbolic = self.variable(variable).kind == VarKind::Symbolic;
            let ty = if symbolic { Type::Symbolic(Box::new(ty)) } else { ty };
            let optional = self.is_optional(parameter);
            if optional {
                let inner = self.store.fresh();
                let _ = self.store.unify(&ty, &Type::optional(inner));
            }
            if let Some(annotation) = &parameter.annotation {
                let annotated = self.parameter_annotation(decl, parameter, annotation, symbolic);
                let annotated = if optional { Type::optional(annotated) } else { annotated };
                // A fresh type variable unifies with any type.
                let _ = self.store.unify(&ty, &annotated);
            }
            parameters.push(ty);
        }
        let captured: Vec<VarId> =
            self.names.functions[id.0 as usize].captured.iter().map(|(_, variable)| *variable).collect();
        parameters.extend(captured.into_iter().map(|variable| self.variable_type(variable)));
        let result = match &decl.result {
            Some(annotation) => self.annotation(annotation, false),
            None => match self.component_record(id) {
                Some(record) => Type::Record(record),
                None => match self.requested_type(decl.name.span, &Type::number()) {
                    Some(observable) => observable,
                    None => self.store.fresh(),
                },
            },
        };
        self.signatures.insert(id, Signature { parameters, result, scheme: None });
        self.file = file;
    }

    fn function_body(&mut self, id: FuncId) {
        let Some(decl) = self.names.functions[id.0 as usize].decl else { return };
        let file = std::mem::replace(&mut self.file, self.names.functions[id.0 as usize].file);
        let function = std::mem::replace(&mut self.function, id);
        let symbolic = std::mem::replace(&mut self.symbolic, false);
        let handlers = std::mem::take(&mut self.handlers);
        let around = self.dependence.enter(id);
        let reaching = self.reaching.clone();
        let present = std::mem::take(&mut self.present);
        let variables = self.names.functions[id.0 as usize].parameters.clone();
        for (parameter, &variable) in decl.parameters.iter().zip(&variables) {
            if parameter.mode != ast::Mode::In {
                self.dependence.function_on_variable(id, variable);
            }
            match &parameter.default {
                Some((ast::Bind::Evaluate, Some(default))) => {
                    let ty = self.variable_type(variable);
                    let earlier =
                        decl.parameters.iter().zip(&variables).take_while(|(p, _)| p.name != parameter.name);
                    let earlier = earlier.filter(|(p, id)| {
                        p.mode == ast::Mode::In && self.variable(**id).kind != VarKind::Symbolic
                    });
                    let earlier: HashMap<VarId, VarId> = match &decl.body {
                        ast::FunctionBody::Statement(_) => earlier.map(|(_, id)| (*id, *id)).collect(),
                        _ => HashMap::default(),
                    };
                    let around = std::mem::replace(&mut self.elements, earlier);
                    self.parameter_default(&ty, &parameter.name, default);
                    self.elements = around;
                }
                Some((ast::Bind::Symbolic, default)) if self.variable(variable).kind == VarKind::Symbolic => {
                    self.symbolic_parameter(variable);
                    if let Some(default) = default {
                        let ty = self.variable_type(variable);
                        let value = self.as_symbolic(|c| c.whole(default));
                        self.expect(&ty, &value, "the default", None);
                    }
                }
                _ => {}
            }
            let ty = self.variable_type(variable);
            self.check_former_none(&ty, parameter);
            self.parameter_domain(&ty, parameter);
        }
        let host = decl.is_host.then(|| self.host_function(id, decl));
        let (mut body, mut definition) = (Vec::new(), None);
        match &decl.body {
            ast::FunctionBody::Statement(statement) => match &statement.kind {
                ast::StmtKind::Block(statements) => {
                    self.find_rebound(statements);
                    self.find_foreign(statements);
                    if decl.is_component || decl.is_test {
                        self.note_instance_sites(statements);
                    }
                    if decl.is_component {
                        self.declare_component_params(id);
                    }
                    body = self.statements(statements);
                    if decl.is_component {
                        body.push(self.members(id, decl, statements));
                    }
                }
                _ => body.push(self.statement(statement)),
            },
            ast::FunctionBody::Symbolic(e) if self.names.functions[id.0 as usize].computed.is_some() => {
                body.push(self.computed_body(id, e));
            }
            ast::FunctionBody::Symbolic(e) => definition = Some(self.symbolic_body(id, decl, e)),
            ast::FunctionBody::Extern { .. } => {}
        }
        let returns = definition.is_some() || body.iter().any(returns_value);
        let result = self.signatures.get(&id).map_or(Type::Unit, |signature| signature.result.clone());
        if !returns && matches!(self.store.known(&result), Type::Unknown(_)) {
            let _ = self.store.unify(&result, &Type::Unit);
        }
        let own = variables.iter().copied().zip(decl.parameters.iter().map(|p| p.mode));
        let captured = self.names.functions[id.0 as usize]
            .captured
            .iter()
            .map(|(_, variable)| (*variable, ast::Mode::In));
        self.functions.insert(
            id,
            Function {
                name: decl.name.name.to_string(),
                parameters: own.chain(captured).collect(),
                result,
                body,
                definition,
                host,
                component: self.component_around(id),
                scheme: Scheme::default(),
                span: decl.name.span,
            },
        );
        self.reaching = reaching;
        self.present = present;
        self.symbolic = symbolic;
        self.handlers = handlers;
        self.dependence.leave(around);
        self.function = function;
        self.file = file;
    }

    /// Returns the result type of the current function; `Unit` at the top level.
    pub fn current_result(&self) -> Type {
        self.signatures.get(&self.function).map_or(Type::Unit, |signature| signature.result.clone())
    }
}

fn returns_value(statement: &Stmt) -> bool {
    let mut found = false;
    statement.walk(&mut |s| found |= matches!(s.kind, StmtKind::Return(Some(_))));
    found
}
