//! Interfaces: the type of a function as its callers need it, independent of the check that
//! inferred it.
//!
//! Equal schemes have equal interfaces, because variables are numbered in order of occurrence. An
//! edit of a body that does not change the scheme therefore does not change the interface.

use super::dim::{Dim, DimVar};
use super::excerpt::RecordKey;
use super::infer::{Checker, Signature};
use super::instances::FixedMembers;
use super::tree::{
    Constraint, ConstraintKind, Def, DefId, Expr, FuncId, Function, RecordId, Scheme, SymbolicBody, VarId,
};
use super::types::{Store, Type, TypeVar};
use crate::ast::{Mode, Stmt, StmtKind};
use crate::span::Span;
use smallvec::SmallVec;
use std::cell::RefCell;
use std::collections::BTreeMap;

#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    parameters: Vec<Type>,
    result: Type,
    /// Number of type variables that a call instantiates; `dims` is the number of dimension
    /// variables.
    types: u32,
    dims: u32,
    constraints: Vec<ConstraintKind>,
    /// The records in these types, by number.
    pub records: Vec<RecordKey>,
    /// For a symbolic function, `true` if it depends on `Time`.
    on_time: Option<bool>,
    /// For a component, the members of its instances.
    members: Option<Vec<(String, Type)>>,
    /// For a component, the members that are params or outputs.
    fixed_members: Option<FixedMembers>,
    /// Positions of the parameters of a component that the default or range of a param uses.
    statics: Vec<usize>,
    /// The only variable that starts with the number 0, if there is one.
    sum: Option<String>,
}

/// Renumbers type and dimension variables.
struct Renaming<'s> {
    store: &'s Store,
    types: BTreeMap<TypeVar, TypeVar>,
    dims: BTreeMap<DimVar, DimVar>,
    /// If `true`, variables without a number get the next one; otherwise such a variable sets
    /// `open`.
    grows: bool,
    open: bool,
    /// Maps records to their numbers.
    record: &'s dyn Fn(RecordId) -> Option<RecordId>,
}

impl Renaming<'_> {
    fn ty(&mut self, ty: &Type) -> Type {
        match self.store.shallow(ty) {
            Type::Unknown(variable) => {
                let next = TypeVar(self.types.len() as u32);
                match self.types.get(&variable) {
                    Some(known) => Type::Unknown(*known),
                    None if self.grows => {
                        self.types.insert(variable, next);
                        Type::Unknown(next)
                    }
                    None => {
                        self.open = true;
                        Type::Error
                    }
                }
            }
            Type::Number(dim) => Type::Number(self.dim(&dim)),
            Type::Vector(dim) => Type::Vector(self.dim(&dim)),
            Type::Observable(dim) => Type::Observable(self.dim(&dim)),
            Type::Array(element) => Type::array(self.ty(&element)),
            Type::Symbolic(inner) => Type::Symbolic(Box::new(self.ty(&inner))),
            Type::Optional(inner) => Type::optional(self.ty(&inner)),
            Type::Tuple(parts) => Type::Tuple(parts.iter().map(|part| self.ty(part)).collect()),
            Type::Function(parts, result) => {
                let parts = parts.iter().map(|part| self.ty(part)).collect();
                Type::Function(parts, Box::new(self.ty(&result)))
            }
            Type::Record(id) => match (self.record)(id) {
                Some(id) => Type::Record(id),
                None => {
                    self.open = true;
                    Type::Error
                }
            },
            other @ (Type::Error
            | Type::Unit
            | Type::Bool
            | Type::String
            | Type::Transform
            | Type::Enum(_)
            | Type::Handle(_)) => other,
        }
    }

    fn dim(&mut self, dim: &Dim) -> Dim {
        let dim = self.store.dim(dim);
        let mut unknowns = SmallVec::new();
        for (variable, exponent) in dim.unknowns {
            let next = DimVar(self.dims.len() as u32);
            let renamed = match self.dims.get(&variable) {
                Some(known) => *known,
                None if self.grows => *self.dims.entry(variable).or_insert(next),
                None => {
                    self.open = true;
                    continue;
                }
            };
            unknowns.push((renamed, exponent));
        }
        unknowns.sort_by_key(|(variable, _)| *variable);
        Dim { fixed: dim.fixed, unknowns }
    }
}

impl Interface {
    /// Returns the interfaces of a group of functions with a common scheme, and numbers the
    /// variables of the scheme in the order of the interface. Returns `None` if other code can
    /// still determine a type, as for a literal without a unit under `units`.
    pub fn of_group(checker: &mut Checker<'_>, group: &[FuncId]) -> Option<Vec<Interface>> {
        let signatures: Vec<Signature> =
            group.iter().map(|id| checker.signatures.get(id).cloned()).collect::<Option<_>>()?;
        let scheme = signatures.first()?.scheme.clone()?;
        let records = RefCell::new(Vec::new());
        let record = |id: RecordId| -> Option<RecordId> {
            let key = checker.record_key(id)?;
            let mut records = records.borrow_mut();
            let at = records.iter().position(|other| *other == key).unwrap_or_else(|| {
                records.push(key);
                records.len() - 1
            });
            Some(RecordId(at as u32))
        };
        let mut order = Renaming {
            store: &checker.store,
            record: &record,
            types: BTreeMap::new(),
            dims: BTreeMap::new(),
            grows: true,
            open: false,
        };
        let all = |order: &mut Renaming<'_>| {
            let each = signatures.iter().zip(group).map(|(signature, id)| {
                let parameters: Vec<Type> = signature.parameters.iter().map(|ty| order.ty(ty)).collect();
                let record = checker.component_record(*id).and_then(|record| checker.store.record(record));
                let members = record.map(|record| {
                    let fields = record.fields.iter();
                    fields.map(|(name, ty)| (name.clone(), order.ty(ty))).collect::<Vec<_>>()
                });
                (parameters, order.ty(&signature.result), members)
            });
            let types: Vec<_> = each.collect();
            let mut constraints: Vec<ConstraintKind> = Vec::new();
            for constraint in &scheme.constraints {
                let kind = constraint.map(|ty| order.ty(ty));
                if !constraints.contains(&kind) {
                    constraints.push(kind);
                }
            }
            (types, constraints)
        };
        all(&mut order);
        // Only quantified variables may remain.
        order.types.retain(|variable, _| scheme.types.contains(variable));
        order.dims.retain(|variable, _| scheme.dims.contains(variable));
        let mut by_number: Vec<_> =
            order.types.iter().map(|(variable, number)| (*number, *variable)).collect();
        by_number.sort();
        let types: Vec<TypeVar> = by_number.into_iter().map(|(_, variable)| variable).collect();
        let mut by_number: Vec<_> =
            order.dims.iter().map(|(variable, number)| (*number, *variable)).collect();
        by_number.sort();
        let dims: Vec<DimVar> = by_number.into_iter().map(|(_, variable)| variable).collect();
        let mut named = Renaming {
            store: &checker.store,
            record: &record,
            types: types.iter().zip(0..).map(|(variable, number)| (*variable, TypeVar(number))).collect(),
            dims: dims.iter().zip(0..).map(|(variable, number)| (*variable, DimVar(number))).collect(),
            grows: false,
            open: false,
        };
        let (members, constraints) = all(&mut named);
        if named.open {
            return None;
        }
        let scheme = Scheme { types, dims, constraints: scheme.constraints.clone() };
        let (types, dims) = (scheme.types.len() as u32, scheme.dims.len() as u32);
        let records = records.take();
        let interfaces = members.into_iter().zip(group).map(|((parameters, result, members), id)| {
            let variables = checker.names.functions[id.0 as usize].parameters.iter().enumerate();
            let is_static = |variable: &VarId| checker.static_parameters.contains(variable);
            let statics = variables.filter(|(_, variable)| is_static(variable)).map(|(at, _)| at);
            let body = checker.functions.get(id).and_then(|function| function.definition.as_ref());
            Interface {
                parameters,
                result,
                types,
                dims,
                constraints: constraints.clone(),
                records: records.clone(),
                on_time: body.map(|body| checker.defs[body.def.0 as usize].on_time),
                members,
                fixed_members: checker.fixed_members.get(id).cloned(),
                statics: statics.collect(),
                sum: checker.sum_of_numbers(*id),
            }
        });
        let interfaces = interfaces.collect();
        for id in group {
            if let Some(function) = checker.functions.get_mut(id) {
                function.scheme = scheme.clone();
            }
        }
        Some(interfaces)
    }

    /// Declares the function in a check that does not contain its body.
    pub fn import(&self, checker: &mut Checker<'_>, id: FuncId) {
        let Some(decl) = checker.names.functions[id.0 as usize].decl else { return };
        let types: Vec<TypeVar> = (0..self.types).map(|_| checker.store.fresh_variable()).collect();
        let dims: Vec<DimVar> = (0..self.dims).map(|_| checker.store.fresh_dim_variable()).collect();
        // The numbered variables are replaced by these.
        let numbered = Store::unknown(self.types, self.dims);
        let record = |id: RecordId| {
            let key = self.records.get(id.0 as usize)?;
            let mut all = (0..checker.record_count() as u32).map(RecordId);
            all.find(|id| checker.record_key(*id).as_ref() == Some(key))
        };
        let mut renaming = Renaming {
            store: &numbered,
            record: &record,
            types: types.iter().zip(0..).map(|(variable, number)| (TypeVar(number), *variable)).collect(),
            dims: dims.iter().zip(0..).map(|(variable, number)| (DimVar(number), *variable)).collect(),
            grows: false,
            open: false,
        };
        let parameters: Vec<Type> = self.parameters.iter().map(|ty| renaming.ty(ty)).collect();
        let result = renaming.ty(&self.result);
        let constraints = self.constraints.iter().map(|kind| Constraint {
            kind: Constraint { kind: kind.clone(), span: Span::default() }.map(|ty| renaming.ty(ty)),
            span: Span::default(),
        });
        let scheme = Scheme { types, dims, constraints: constraints.collect() };
        let variables: Vec<(VarId, Mode)> = checker.names.functions[id.0 as usize]
            .parameters
            .iter()
            .copied()
            .zip(decl.parameters.iter().map(|parameter| parameter.mode))
            .collect();
        if let Some(members) = &self.members {
            let members = members.iter().map(|(name, ty)| (name.clone(), renaming.ty(ty))).collect();
            checker.imported_members.insert(id, members);
        }
        checker.fixed_members.extend(self.fixed_members.clone().map(|fixed| (id, fixed)));
        let all = &checker.names.functions[id.0 as usize].parameters;
        checker.static_parameters.extend(self.statics.iter().filter_map(|at| all.get(*at)));
        checker.sums.extend(self.sum.clone().map(|name| (id, name)));
        let place = decl.name.span;
        let definition = self.on_time.map(|on_time| {
            checker.defs.push(Def {
                name: decl.name.name.to_string(),
                expr: Expr::error(place),
                captures: Vec::new(),
                stored: false,
                checks: Vec::new(),
                on_time,
                observes: false,
                closed: true,
                chosen: Default::default(),
                part: false,
                span: place,
            });
            let def = DefId(checker.defs.len() as u32 - 1);
            SymbolicBody { def, exported: false, doc: String::new() }
        });
        for ((variable, _), ty) in variables.iter().zip(&parameters) {
            // A symbolic parameter has the type of its expression.
            let held = match ty {
                Type::Symbolic(inner) => (**inner).clone(),
                ty => ty.clone(),
            };
            checker.set_variable_type(*variable, held);
            // Without the body, its result is assumed to depend on all arguments.
            checker.dependence.function_on_variable(id, *variable);
            checker.dependence.thrown_variable(*variable);
        }
        checker.functions.insert(
            id,
            Function {
                name: decl.name.name.to_string(),
                parameters: variables,
                result: result.clone(),
                body: Vec::new(),
                definition,
                host: None,
                component: decl.is_component.then_some(id),
                scheme: scheme.clone(),
                span: decl.name.span,
            },
        );
        checker.signatures.insert(id, Signature { parameters, result, scheme: Some(scheme) });
    }
}

impl Checker<'_> {
    /// Returns the identity of a record for other checks; `None` if it is declared in a function.
    pub(super) fn record_key(&self, id: RecordId) -> Option<RecordKey> {
        let Some(record) = self.names.records.get(id.0 as usize) else {
            let component = self.names.functions.get(self.component_of(id)?.0 as usize)?;
            return self.layout.locate(component.decl?.name.span);
        };
        let name = record.decl.name.span;
        let whole =
            |statement: &Stmt| matches!(&statement.kind, StmtKind::Record(decl) if decl.name.span == name);
        let module = self.modules.get(record.file.0 as usize)?;
        module.tree.statements.iter().any(whole).then(|| self.layout.locate(name)).flatten()
    }
}
