//! Generalization: type schemes of functions, and their instantiation.

use super::dim::DimVar;
use super::infer::Checker;
use super::rules::{self, Rule};
use super::symbols::FunctionInfo;
use super::tree::{Constraint, FuncId, Scheme, UseId};
use super::types::{Substitution, Type, TypeVar};
use crate::components::components;
use crate::hashed::HashMap;
use crate::span::Span;
use std::collections::BTreeSet;
use std::rc::Rc;

impl Checker<'_> {
    /// Quantifies the types of a group over the variables that no code outside the group can still
    /// determine.
    pub(super) fn generalise(&mut self, group: &[FuncId], constraints: Vec<Constraint>) {
        let (mut types, mut dims) = (BTreeSet::new(), BTreeSet::new());
        for &member in group {
            let Some(signature) = self.signatures.get(&member) else { continue };
            for ty in signature.parameters.iter().chain([&signature.result]) {
                self.store.unknowns(ty, &mut types, &mut dims);
            }
        }
        // Literals have fixed dimensions and are not quantified.
        let of_literals = dims.iter().any(|v| self.store.is_literal(*v));
        dims.retain(|v| !self.store.is_literal(*v));
        let (outer_types, outer_dims) = match types.is_empty() && dims.is_empty() && constraints.is_empty() {
            true => Default::default(),
            false => self.outer_unknowns(group),
        };
        let sees_unknown = of_literals || !types.is_disjoint(&outer_types) || !dims.is_disjoint(&outer_dims);
        types.retain(|v| !outer_types.contains(v));
        dims.retain(|v| !outer_dims.contains(v));
        // If a constraint mentions a quantified type, its other variables are also quantified.
        let mut own = Vec::new();
        let mut rest = constraints;
        loop {
            let (taken, left): (Vec<_>, Vec<_>) = rest.into_iter().partition(|constraint| {
                let (mut t, mut d) = (BTreeSet::new(), BTreeSet::new());
                constraint.types().iter().for_each(|ty| self.store.unknowns(ty, &mut t, &mut d));
                !t.is_disjoint(&types)
            });
            rest = left;
            if taken.is_empty() {
                break;
            }
            for constraint in taken {
                let (mut t, mut d) = (BTreeSet::new(), BTreeSet::new());
                constraint.types().iter().for_each(|ty| self.store.unknowns(ty, &mut t, &mut d));
                types.extend(t.into_iter().filter(|v| !outer_types.contains(v)));
                dims.extend(d.into_iter().filter(|v| !outer_dims.contains(v) && !self.store.is_literal(*v)));
                own.push(constraint);
            }
        }
        self.pending.extend(rest);
        let applied = [
            (!types.is_empty(), Rule::GeneraliseType),
            (!dims.is_empty(), Rule::GeneraliseDimension),
            (!own.is_empty(), Rule::GeneraliseConstraint),
            (group.len() > 1, Rule::RecursiveGroup),
            (sees_unknown, Rule::OuterUnknown),
        ];
        applied.iter().filter(|(holds, _)| *holds).for_each(|(_, rule)| rules::applied(*rule));
        let scheme =
            Scheme { types: types.into_iter().collect(), dims: dims.into_iter().collect(), constraints: own };
        for member in group {
            if let Some(signature) = self.signatures.get_mut(member) {
                signature.scheme = Some(scheme.clone());
            }
            if let Some(function) = self.functions.get_mut(member) {
                function.scheme = scheme.clone();
            }
        }
    }

    /// Returns the type and dimension variables of variables, params and fields outside a group of
    /// functions.
    fn outer_unknowns(&mut self, group: &[FuncId]) -> (BTreeSet<TypeVar>, BTreeSet<DimVar>) {
        let inside: BTreeSet<FuncId> = self.inside(group);
        let (mut types, mut dims) = (BTreeSet::new(), BTreeSet::new());
        // A resolved type stays resolved, so its variable is not visited again.
        let mut open = std::mem::take(&mut self.open_variables);
        open.retain(|id| {
            let Some(ty) = self.variable_types.get(id) else { return false };
            let (mut own_types, mut own_dims) = (BTreeSet::new(), BTreeSet::new());
            self.store.unknowns(ty, &mut own_types, &mut own_dims);
            // The dimension of a literal is never generalized.
            own_dims.retain(|dim| !self.store.is_literal(*dim));
            let is_open = !own_types.is_empty() || !own_dims.is_empty();
            let is_inside = inside.contains(&self.names.variables[id.0 as usize].owner);
            if !is_inside {
                types.extend(own_types);
                dims.extend(own_dims);
            }
            // Code that is checked later does not refer to variables inside the group.
            is_open && !is_inside
        });
        self.open_variables = open;
        for param in &self.params {
            self.store.unknowns(&param.ty, &mut types, &mut dims);
        }
        // Records are never generic: a field has one type in the program.
        for (_, ty) in self.store.records.iter().flat_map(|record| &record.fields) {
            self.store.unknowns(ty, &mut types, &mut dims);
        }
        (types, dims)
    }

    /// Returns the functions of a group and the functions nested in them.
    fn inside(&self, group: &[FuncId]) -> BTreeSet<FuncId> {
        let mut inside: BTreeSet<FuncId> = group.iter().copied().collect();
        let mut left = group.to_vec();
        while let Some(id) = left.pop() {
            let nested = self.nested.get(&id).into_iter().flatten().copied();
            left.extend(nested.filter(|nested| inside.insert(*nested)));
        }
        inside
    }

    /// Instantiates a function: returns its parameter types and result with fresh variables.
    pub fn instantiate(&mut self, id: FuncId, span: Span) -> (Vec<Type>, Type, UseId) {
        self.ensure_inferred(id);
        let Some(signature) = self.signatures.get(&id).cloned() else {
            return (Vec::new(), Type::Error, UseId(0));
        };
        let mut substitution = Substitution::default();
        if let Some(scheme) = &signature.scheme {
            rules::applied(Rule::Instantiate);
            for &variable in &scheme.types {
                let fresh = self.store.fresh();
                substitution.types.insert(variable, fresh);
            }
            for &variable in &scheme.dims {
                let fresh = self.store.fresh_dim();
                substitution.dims.insert(variable, fresh);
            }
            for constraint in &scheme.constraints {
                self.pending
                    .push(Constraint { kind: constraint.map(|ty| substitution.ty(&self.store, ty)), span });
            }
        }
        let parameters = signature.parameters.iter().map(|ty| substitution.ty(&self.store, ty)).collect();
        let result = substitution.ty(&self.store, &signature.result);
        self.instances.push(substitution);
        (parameters, result, UseId(self.instances.len() as u32 - 1))
    }
}

/// Returns the groups of mutually recursive functions. The top level belongs to no group.
pub(super) fn recursive_groups(functions: &[FunctionInfo<'_>]) -> HashMap<FuncId, Rc<[FuncId]>> {
    let all = (1..functions.len() as u32).map(FuncId);
    let mut groups = HashMap::default();
    for mut group in components(all, |id| functions[id.0 as usize].callees.iter().copied()) {
        group.sort();
        let group: Rc<[FuncId]> = group.into();
        groups.extend(group.iter().map(|member| (*member, group.clone())));
    }
    groups
}
