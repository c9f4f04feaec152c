//! The result of checking without intermediate data: typed functions, ready to be lowered.
//!
//! It does not refer to syntax trees, so it can be stored while texts change.

use super::infer::Checker;
use super::symbols::{Resolution, Variable};
use super::tree::{Def, Expr, FuncId, Function, Output, Param, VarId};
use super::types::{Store, Substitution, Type};
use crate::ast::{FunctionBody, Ident};
use crate::hashed::{HashMap, HashSet};
use crate::ir::ExternDecl;
use crate::span::Span;
use calyx_abi::{Purity, Repr};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Typed functions and the tables that their bodies refer to. Clones share them.
#[derive(Clone, Debug, Default)]
pub struct Typed {
    pub functions: Arc<HashMap<FuncId, Function>>,
    pub instances: Arc<Vec<Substitution>>,
    pub defs: Arc<Vec<Def>>,
    pub params: Arc<Vec<Param>>,
    pub outputs: Arc<Vec<Output>>,
    /// Values of the constants, each in the file of its declaration.
    pub consts: Arc<Vec<Expr>>,
    pub externs: Arc<Vec<ExternDecl>>,
    pub store: Arc<Store>,
    /// Symbolic names whose expression is selected at run time.
    pub chosen: Arc<BTreeSet<VarId>>,
    /// Parameters of components that the default or range of a param uses.
    pub statics: Arc<HashSet<VarId>>,
    /// Hidden variables with what a passed function captures, and the parameters or hidden
    /// variables that they copy.
    pub environments: Arc<HashMap<VarId, VarId>>,
    variables: Arc<Vec<Variable>>,
    variable_types: Arc<HashMap<VarId, Type>>,
}

impl Typed {
    pub fn variable(&self, id: VarId) -> &Variable {
        &self.variables[id.0 as usize]
    }

    /// Returns the inferred type of a variable.
    pub fn type_of(&self, id: VarId) -> Type {
        self.variable_types.get(&id).cloned().unwrap_or(Type::Error)
    }

    /// Returns `true` if it contains a generic function.
    pub fn is_general(&self) -> bool {
        self.functions.values().any(|function| !function.scheme.types.is_empty())
    }

    pub fn is_component(&self, id: FuncId) -> bool {
        self.functions.get(&id).is_some_and(|function| function.component == Some(id))
    }

    pub fn function_name(&self, id: FuncId) -> &str {
        self.functions.get(&id).map_or("", |function| &function.name)
    }
}

impl Checker<'_> {
    /// Converts to data without references to syntax trees. The meanings of identifiers are
    /// returned separately, because only editors need them.
    pub fn into_typed(self) -> (Typed, HashMap<Span, Resolution>) {
        let externs = self.names.externs.iter().map(|info| {
            let purity = match &info.decl.body {
                FunctionBody::Extern { purity: Some(word), .. } if word.name == "pure" => Purity::Pure,
                FunctionBody::Extern { purity: Some(word), .. } if word.name == "scene" => Purity::Scene,
                _ => Purity::Effect,
            };
            let declared = |name: &Ident| match self.names.uses.get(&name.span)? {
                Resolution::Record(id) => Some(self.store.repr(&Type::Record(*id))),
                Resolution::Enum(_) => Some(Repr::String),
                Resolution::Dimension(_) => Some(Repr::Number),
                _ => None,
            };
            let repr = |annotation| super::lower::annotated_repr(annotation, &declared);
            let parameters = info.decl.parameters.iter().map(|p| {
                let value = p.annotation.as_ref().map_or(Repr::Number, repr);
                let value = if self.is_optional(p) { Repr::Tuple(vec![Repr::Bool, value]) } else { value };
                (p.name.name.to_string(), value)
            });
            ExternDecl {
                symbol: info.symbol.clone(),
                name: info.name.clone(),
                purity,
                parameters: parameters.collect(),
                result: info.decl.result.as_ref().map_or(Repr::Unit, repr),
                span: info.decl.name.span,
            }
        });
        let externs: Vec<ExternDecl> = externs.collect();
        let typed = Typed {
            consts: Arc::new(self.consts.into_values().flatten().collect()),
            externs: Arc::new(externs),
            functions: Arc::new(self.functions),
            instances: Arc::new(self.instances),
            defs: Arc::new(self.defs),
            params: Arc::new(self.params),
            outputs: Arc::new(self.outputs),
            store: Arc::new(self.store),
            chosen: Arc::new(self.graphs.chosen),
            statics: Arc::new(self.static_parameters),
            environments: Arc::new(self.environments),
            variables: Arc::new(self.names.variables),
            variable_types: Arc::new(self.variable_types),
        };
        (typed, self.names.uses)
    }
}
