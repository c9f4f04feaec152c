//! The meanings of names in a check unit, stored for editors.
//!
//! The checker computes this information anyway; here it is stored without references to syntax
//! trees. Locations refer to the unit's excerpt.

use super::infer::Checker;
use super::schemes::ShownScheme;
use super::symbols::{Resolution, VarKind};
use super::tree::FuncId;
use super::typed::Typed;
use super::types::{Store, Type};
use crate::analysis::NameKind;
use crate::ast::FunctionBody;
use crate::dimension::Dimension;
use crate::hashed::{HashMap, HashSet};
use crate::span::Span;

/// The meanings of the names in one unit.
#[derive(Debug, Default)]
pub struct NameTable {
    uses: HashMap<Span, Resolution>,
    /// Names of arguments and fields, and the declarations of the parameters and fields that they
    /// refer to.
    parts: HashMap<Span, Span>,
    /// Parameters of engine functions and fields of records, with their types.
    part_types: HashMap<Span, (NameKind, String, Option<Dimension>)>,
    /// `.x`, `.y` and `.z` of vectors, with their types.
    components: HashMap<Span, String>,
    /// Names that are assigned to.
    written: HashSet<Span>,
    /// Locations where functions are named, and their kinds.
    functions: Vec<(Span, NameKind)>,
    /// Names of members of instances: the name of the component, and the member.
    members: HashMap<Span, (Span, String, String)>,
    /// Schemes of the functions that were checked in this unit, including nested ones.
    schemes: HashMap<FuncId, ShownScheme>,
    externs: Vec<Span>,
    consts: Vec<(Span, String)>,
    records: Vec<Span>,
    enums: Vec<Span>,
    dimensions: Vec<Span>,
    units: Vec<Span>,
    params: Vec<Span>,
    outputs: Vec<Span>,
    modules: Vec<String>,
}

/// The meaning of a name.
#[derive(Clone, Debug, PartialEq)]
pub struct NameMeaning {
    pub kind: NameKind,
    pub declared: Declared,
    /// Type as displayed. It is unknown here for functions that are declared in other units.
    pub ty: Option<String>,
    pub written: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Declared {
    /// A built-in name without a declaration.
    Nowhere,
    At(Span),
    /// A member of the component whose name is at a location.
    Member(Span, String),
    /// A module, by its dotted path.
    Module(String),
}

impl NameTable {
    /// Collects the meanings that a checker found; `schemes` are those of its functions.
    pub fn of(checker: &mut Checker<'_>, schemes: HashMap<FuncId, ShownScheme>) -> NameTable {
        let mut parts: HashMap<Span, Span> = checker.named_parts.drain(..).collect();
        let (mut part_types, mut components) = (HashMap::default(), HashMap::default());
        let mut members = HashMap::default();
        let names = &checker.names;
        for (index, record) in names.records.iter().enumerate() {
            let known = checker.store.record(super::tree::RecordId(index as u32));
            for field in &record.decl.fields {
                let ty = known.and_then(|r| r.fields.iter().find(|(name, _)| *name == field.name.name));
                let shown = ty.map_or_else(|| "_".into(), |(_, ty)| checker.store.show(ty));
                let dimension = ty.and_then(|(_, ty)| dimension(&checker.store, ty));
                part_types.insert(field.name.span, (NameKind::Field, shown, dimension));
                parts.insert(field.name.span, field.name.span);
            }
        }
        for info in &names.enums {
            for choice in &info.decl.choices {
                let ty = info.decl.name.name.to_string();
                part_types.insert(choice.name.span, (NameKind::Const, ty, None));
                parts.insert(choice.name.span, choice.name.span);
            }
        }
        for info in &names.externs {
            for parameter in &info.decl.parameters {
                let ty = parameter.annotation.as_ref().map_or("", |a| checker.text(a.span));
                let known = checker.parameter_types.get(&parameter.name.span);
                let dimension = known.and_then(|ty| dimension(&checker.store, ty));
                part_types.insert(parameter.name.span, (NameKind::Parameter, ty.into(), dimension));
                parts.insert(parameter.name.span, parameter.name.span);
            }
        }
        for (field, base) in &checker.named_fields {
            let id = match checker.store.shallow(base) {
                Type::Record(id) => id,
                Type::Vector(dim) => {
                    components.insert(field.span, checker.store.show(&Type::Number(dim)));
                    continue;
                }
                _ => continue,
            };
            if let Some(component) = checker.component_of(id)
                && let Some(decl) = names.functions[component.0 as usize].decl
                && let Some((_, ty)) = checker.store.field(id, &field.name)
            {
                let shown = checker.store.show(&ty);
                members.insert(field.span, (decl.name.span, field.name.to_string(), shown));
                continue;
            }
            let declared = names.records.get(id.0 as usize).and_then(|record| {
                let names = record.decl.field_names();
                let current = names.iter().find(|declared| declared.name.name == field.name);
                let found = current.or_else(|| names.iter().find(|declared| declared.was(&field.name)));
                found.map(|declared| declared.name.span)
            });
            parts.extend(declared.map(|declared| (field.span, declared)));
        }
        let function = |info: &super::symbols::FunctionInfo<'_>| match info.decl {
            Some(decl) if decl.is_component => (decl.name.span, NameKind::Component),
            Some(decl) if matches!(decl.body, FunctionBody::Symbolic(_)) => {
                (decl.name.span, NameKind::SymbolicFunction)
            }
            Some(decl) => (decl.name.span, NameKind::Function),
            None => (Span::default(), NameKind::Function),
        };
        let const_type = |id: usize| match checker.consts.get(&(id as u32)) {
            Some(Some(value)) => checker.store.show(&value.ty),
            _ => "_".into(),
        };
        NameTable {
            parts,
            part_types,
            components,
            schemes,
            functions: names.functions.iter().map(function).collect(),
            members,
            externs: names.externs.iter().map(|info| info.decl.name.span).collect(),
            consts: names
                .consts
                .iter()
                .enumerate()
                .map(|(id, declared)| (declared.decl.name.span, const_type(id)))
                .collect(),
            records: names.records.iter().map(|record| record.decl.name.span).collect(),
            enums: names.enums.iter().map(|declared| declared.decl.name.span).collect(),
            dimensions: names.dimensions.iter().map(|dimension| dimension.decl.name.span).collect(),
            units: names.units.iter().map(|unit| unit.decl.name.span).collect(),
            params: names.params.iter().map(|param| param.decl.name.span).collect(),
            outputs: names.outputs.iter().map(|output| output.name.span).collect(),
            modules: checker.modules.iter().map(|module| module.name.clone()).collect(),
            written: std::mem::take(&mut checker.names.written),
            uses: HashMap::default(),
        }
    }

    /// Adds the meanings of identifiers, by location.
    pub fn with_uses(mut self, uses: HashMap<Span, Resolution>) -> NameTable {
        self.uses = uses;
        self
    }

    /// Returns the scheme of a function that was checked in this unit.
    pub fn scheme(&self, id: FuncId) -> Option<&ShownScheme> {
        self.schemes.get(&id)
    }

    /// Returns the function declared at a location.
    pub fn function_at(&self, span: Span) -> Option<FuncId> {
        match self.uses.get(&span) {
            Some(Resolution::Function(id)) => Some(*id),
            _ => None,
        }
    }

    /// Returns the dimension of the numbers in a variable, param, parameter or field declared at a
    /// location, if known.
    pub fn dimension_at(&self, typed: &Typed, span: Span) -> Option<Dimension> {
        if let Some((_, _, dimension)) = self.part_types.get(&span) {
            return *dimension;
        }
        match *self.uses.get(&span)? {
            Resolution::Var(id) => dimension(&typed.store, &typed.type_of(id)),
            Resolution::Param(id) => dimension(&typed.store, &typed.params.get(id as usize)?.ty),
            Resolution::Output(id) => dimension(&typed.store, &typed.outputs.get(id as usize)?.ty),
            _ => None,
        }
    }

    /// Returns the meaning of the name at a location.
    pub fn at(&self, typed: &Typed, span: Span) -> Option<NameMeaning> {
        let written = self.written.contains(&span);
        if let Some(declared) = self.parts.get(&span) {
            let declares = Declared::At(*declared);
            if let Some((kind, ty, _)) = self.part_types.get(declared) {
                return Some(NameMeaning { kind: *kind, declared: declares, ty: Some(ty.clone()), written });
            }
            let found = (*declared != span).then(|| self.at(typed, *declared)).flatten();
            return found.map(|found| NameMeaning { declared: declares, written, ..found });
        }
        if let Some((component, member, ty)) = self.members.get(&span) {
            let declared = Declared::Member(*component, member.clone());
            return Some(NameMeaning { kind: NameKind::Field, declared, ty: Some(ty.clone()), written });
        }
        if let Some(ty) = self.components.get(&span) {
            return Some(NameMeaning {
                kind: NameKind::Field,
                declared: Declared::Nowhere,
                ty: Some(ty.clone()),
                written,
            });
        }
        let at = |spans: &[Span], id: u32| spans.get(id as usize).map(|span| Declared::At(*span));
        let (kind, declared, ty) = match *self.uses.get(&span)? {
            Resolution::Var(id) => {
                let variable = typed.variable(id);
                let kind = match variable.kind {
                    VarKind::Value | VarKind::Hidden => NameKind::Variable,
                    VarKind::Symbolic => NameKind::Symbolic,
                    VarKind::Parameter(_) => NameKind::Parameter,
                };
                (kind, Declared::At(variable.span), Some(typed.store.show(&typed.type_of(id))))
            }
            Resolution::Param(id) => {
                let ty = typed.params.get(id as usize).map(|param| typed.store.show(&param.ty));
                (NameKind::Param, at(&self.params, id)?, ty)
            }
            Resolution::Output(id) => {
                let ty = typed.outputs.get(id as usize).map(|output| typed.store.show(&output.ty));
                (NameKind::Output, at(&self.outputs, id)?, ty)
            }
            Resolution::Function(id) => {
                let (span, kind) = *self.functions.get(id.0 as usize)?;
                (kind, Declared::At(span), self.scheme(id).map(ShownScheme::to_string))
            }
            Resolution::Extern(id) => (NameKind::Extern, at(&self.externs, id)?, None),
            Resolution::Const(id) => {
                let (span, ty) = self.consts.get(id as usize)?;
                (NameKind::Const, Declared::At(*span), Some(ty.clone()))
            }
            Resolution::Record(id) => (NameKind::Record, at(&self.records, id.0)?, None),
            Resolution::Enum(id) => (NameKind::Enum, at(&self.enums, id)?, None),
            Resolution::Dimension(id) => (NameKind::Dimension, at(&self.dimensions, id)?, None),
            Resolution::OwnUnit(id) => (NameKind::Unit, at(&self.units, id)?, None),
            Resolution::Module(id) => {
                let path = self.modules.get(id as usize)?.clone();
                (NameKind::Module, Declared::Module(path), None)
            }
            Resolution::Builtin(_) => (NameKind::Builtin, Declared::Nowhere, None),
            Resolution::Constant(_) | Resolution::None => (NameKind::Constant, Declared::Nowhere, None),
            Resolution::Unit(_) => (NameKind::Unit, Declared::Nowhere, None),
            Resolution::Unknown => return None,
        };
        Some(NameMeaning { kind, declared, ty, written })
    }
}

/// Returns the dimension of numbers of a type, including symbolic ones.
pub fn dimension(store: &Store, ty: &Type) -> Option<Dimension> {
    match store.shallow(ty) {
        Type::Number(dim) | Type::Vector(dim) | Type::Observable(dim) => {
            store.dim(&dim).as_known().map(Dimension::without_cycles)
        }
        Type::Symbolic(inner) | Type::Array(inner) | Type::Optional(inner) => dimension(store, &inner),
        _ => None,
    }
}
