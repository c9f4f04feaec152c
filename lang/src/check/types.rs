//! Types during inference, and the store of type and dimension variables.

use super::dim::{Dim, DimVar, solve};
use super::rules::{self, Rule};
use super::tree::RecordId;
use crate::dimension::Dimension;
use crate::hashed::HashMap;
use crate::vocabulary::Vocabulary;
use calyx_abi::Repr;
use std::collections::BTreeSet;
use std::sync::Arc;

/// A type variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TypeVar(pub u32);

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    Unknown(TypeVar),
    /// An invalid type; already reported. It unifies with every type.
    Error,
    /// The result of a function that returns nothing.
    Unit,
    Number(Dim),
    Bool,
    String,
    Vector(Dim),
    Transform,
    Array(Box<Type>),
    Tuple(Vec<Type>),
    /// A value of the type, or `none`. Only parameters and fields have such types.
    Optional(Box<Type>),
    /// A number with a value at every step of an analysis.
    Observable(Dim),
    /// An expression that is passed to the engine without evaluation.
    Symbolic(Box<Type>),
    /// A function that is an argument: the types of its parameters and of its result.
    Function(Vec<Type>, Box<Type>),
    /// An object created by the engine.
    Handle(String),
    Record(RecordId),
    /// One of several choices. Two types are the same if their names and choices are.
    Enum(Arc<EnumType>),
}

/// An enumeration: its name and its choices. Values are the texts of the choices.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct EnumType {
    pub name: String,
    pub choices: Vec<String>,
}

/// A record's name and the types of its fields. Records are nominal and never generic.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordType {
    pub name: String,
    pub fields: Vec<(String, Type)>,
    /// Former names of fields, and the indices of the fields.
    pub former: Vec<(String, usize)>,
}

impl Type {
    pub fn number() -> Type {
        Type::Number(Dim::none())
    }

    pub fn quantity(dimension: Dimension) -> Type {
        Type::Number(Dim::known(dimension))
    }

    /// Returns the type with renumbered records.
    pub fn with_records(&self, number: &dyn Fn(RecordId) -> RecordId) -> Type {
        match self {
            Type::Record(id) => Type::Record(number(*id)),
            Type::Array(element) => Type::array(element.with_records(number)),
            Type::Symbolic(inner) => Type::Symbolic(Box::new(inner.with_records(number))),
            Type::Optional(inner) => Type::optional(inner.with_records(number)),
            Type::Tuple(parts) => Type::Tuple(parts.iter().map(|part| part.with_records(number)).collect()),
            Type::Function(parts, result) => Type::Function(
                parts.iter().map(|part| part.with_records(number)).collect(),
                Box::new(result.with_records(number)),
            ),
            other => other.clone(),
        }
    }

    pub fn optional(inner: Type) -> Type {
        Type::Optional(Box::new(inner))
    }

    pub fn array(element: Type) -> Type {
        Type::Array(Box::new(element))
    }
}

/// The reason why two types do not unify.
#[derive(Clone, Debug, PartialEq)]
pub enum Mismatch {
    /// Two parts differ in kind.
    Kind,
    /// Two dimensions differ.
    Dimension(Box<(Dim, Dim)>),
    /// A type would contain itself, nest too deeply or have too many parts.
    Infinite,
}

/// The assignments of type and dimension variables.
#[derive(Clone, Debug, Default)]
pub struct Store {
    types: Vec<Option<Type>>,
    dims: Vec<Option<Dim>>,
    /// Dimension variables of literals without a unit. Such a literal is one number in the program
    /// and has one dimension, so these are never generalized.
    literals: BTreeSet<DimVar>,
    /// For each unassigned variable, the assigned variables whose types contain it; these types may
    /// still grow.
    pub(super) around: HashMap<TypeVar, Vec<TypeVar>>,
    /// Records by [`RecordId`].
    pub records: Vec<RecordType>,
    /// Dimensions and units declared by the program.
    pub vocabulary: Vocabulary,
}

impl Store {
    pub fn fresh(&mut self) -> Type {
        Type::Unknown(self.fresh_variable())
    }

    pub fn record(&self, id: RecordId) -> Option<&RecordType> {
        self.records.get(id.0 as usize)
    }

    /// Returns the index and the type of a record's field, by its current or former name.
    pub fn field(&self, id: RecordId, name: &str) -> Option<(usize, Type)> {
        let record = self.record(id)?;
        let current = record.fields.iter().position(|(field, _)| field == name);
        let former = || record.former.iter().find(|(former, _)| former == name).map(|(_, at)| *at);
        let at = current.or_else(former)?;
        Some((at, record.fields[at].1.clone()))
    }

    /// Returns `true` if a type contains a record.
    pub fn has_record(&self, ty: &Type) -> bool {
        match self.known(ty) {
            Type::Record(_) => true,
            Type::Array(inner) | Type::Symbolic(inner) | Type::Optional(inner) => self.has_record(inner),
            Type::Tuple(parts) => parts.iter().any(|part| self.has_record(part)),
            Type::Function(parts, result) => {
                parts.iter().chain([&**result]).any(|part| self.has_record(part))
            }
            _ => false,
        }
    }

    pub fn fresh_dim(&mut self) -> Dim {
        Dim::unknown(self.fresh_dim_variable())
    }

    pub fn fresh_variable(&mut self) -> TypeVar {
        self.types.push(None);
        TypeVar(self.types.len() as u32 - 1)
    }

    pub fn fresh_dim_variable(&mut self) -> DimVar {
        self.dims.push(None);
        DimVar(self.dims.len() as u32 - 1)
    }

    /// Creates a store with the given numbers of unassigned variables.
    pub fn unknown(types: u32, dims: u32) -> Store {
        Store { types: vec![None; types as usize], dims: vec![None; dims as usize], ..Store::default() }
    }

    pub fn fresh_literal_dim(&mut self) -> Dim {
        self.dims.push(None);
        let variable = DimVar(self.dims.len() as u32 - 1);
        self.literals.insert(variable);
        Dim::unknown(variable)
    }

    /// Returns `true` if the dimension of some literal is not determined.
    pub fn has_open_literals(&self) -> bool {
        self.literals.iter().any(|variable| self.dims[variable.0 as usize].is_none())
    }

    pub fn is_literal(&self, variable: DimVar) -> bool {
        self.literals.contains(&variable)
    }

    /// Returns the dimension with assigned variables substituted.
    pub fn dim(&self, dim: &Dim) -> Dim {
        let decided = |dim: &Dim| {
            // Newest first: assignments mostly refer to older variables, so each is substituted
            // once.
            let mut unknowns = dim.unknowns.iter().rev();
            unknowns.find_map(|&(v, exponent)| Some((v, exponent, self.dims[v.0 as usize].as_ref()?)))
        };
        let mut result = dim.clone();
        while let Some((variable, exponent, known)) = decided(&result) {
            result.remove(variable);
            result = result.times(&known.power(exponent).unwrap_or_else(Dim::none));
        }
        result
    }

    /// Returns the dimension if all its variables are assigned.
    pub fn known_dim(&self, dim: &Dim) -> Option<Dimension> {
        dim.as_known().or_else(|| self.dim(dim).as_known())
    }

    /// Returns the outermost constructor, if known.
    pub fn shallow(&self, ty: &Type) -> Type {
        self.known(ty).clone()
    }

    /// Returns a reference to the outermost constructor.
    pub(super) fn known<'s>(&'s self, ty: &'s Type) -> &'s Type {
        let mut ty = ty;
        while let Type::Unknown(variable) = ty {
            match &self.types[variable.0 as usize] {
                Some(known) => ty = known,
                None => break,
            }
        }
        ty
    }

    pub(super) fn set_type(&mut self, variable: TypeVar, ty: Option<Type>) {
        self.types[variable.0 as usize] = ty;
    }

    /// Returns the type with assigned variables substituted.
    pub fn resolve(&self, ty: &Type) -> Type {
        match self.known(ty) {
            Type::Number(dim) => Type::Number(self.dim(dim)),
            Type::Vector(dim) => Type::Vector(self.dim(dim)),
            Type::Observable(dim) => Type::Observable(self.dim(dim)),
            Type::Array(element) => Type::array(self.resolve(element)),
            Type::Symbolic(inner) => Type::Symbolic(Box::new(self.resolve(inner))),
            Type::Optional(inner) => Type::optional(self.resolve(inner)),
            Type::Tuple(parts) => Type::Tuple(parts.iter().map(|part| self.resolve(part)).collect()),
            Type::Function(parts, result) => Type::Function(
                parts.iter().map(|part| self.resolve(part)).collect(),
                Box::new(self.resolve(result)),
            ),
            other => other.clone(),
        }
    }

    /// Shortens chains of variables that are assigned to each other. A chain may be as long as a
    /// program; afterwards every look-up takes constant time.
    pub fn compress(&mut self) {
        for index in 0..self.dims.len() {
            if let Some(known) = self.dims[index].take() {
                let known = self.dim(&known);
                self.dims[index] = Some(known);
            }
        }
        for index in 0..self.types.len() {
            let mut chain = Vec::new();
            let mut at = index;
            while let Some(Type::Unknown(next)) = &self.types[at] {
                chain.push(at);
                at = next.0 as usize;
            }
            // The last variable of a chain already has the right value.
            chain.pop();
            for link in chain {
                self.types[link] = Some(Type::Unknown(TypeVar(at as u32)));
            }
        }
    }

    pub fn unify_dims(&mut self, a: &Dim, b: &Dim) -> Result<(), Mismatch> {
        let (a, b) = (self.dim(a), self.dim(b));
        if a == b {
            rules::applied(Rule::KnownDimension);
            return Ok(());
        }
        let difference = a.over(&b);
        // A literal's variable is solved for only if there is no other variable, so that
        // generalization does not affect it. Solving for the newest variable makes assignments
        // refer to older ones and keeps chains short.
        let unknown = difference
            .unknowns
            .iter()
            .rev()
            .find(|(variable, _)| !self.literals.contains(variable))
            .or(difference.unknowns.last());
        match unknown {
            None if difference.fixed.fits(Dimension::NONE) => {
                let equal = difference.fixed.is_none();
                rules::applied(if equal { Rule::KnownDimension } else { Rule::SoftAngle });
                Ok(())
            }
            None => Err(Mismatch::Dimension(Box::new((a, b)))),
            Some(&(variable, exponent)) => {
                let solution = solve(&difference, variable, exponent)
                    .ok_or_else(|| Mismatch::Dimension(Box::new((a, b))))?;
                rules::applied(Rule::SolveDimension);
                self.dims[variable.0 as usize] = Some(solution);
                Ok(())
            }
        }
    }

    /// Returns `true` if two types cannot be unified, whatever the values of their variables.
    pub fn differ(&self, a: &Type, b: &Type) -> bool {
        match (self.shallow(a), self.shallow(b)) {
            (Type::Error | Type::Unknown(_), _) | (_, Type::Error | Type::Unknown(_)) => false,
            (Type::Number(x), Type::Number(y))
            | (Type::Vector(x), Type::Vector(y))
            | (Type::Observable(x), Type::Observable(y)) => {
                let difference = self.dim(&x).over(&self.dim(&y));
                difference.as_known().is_some_and(|d| !d.fits(Dimension::NONE))
            }
            (Type::Array(x), Type::Array(y))
            | (Type::Optional(x), Type::Optional(y))
            | (Type::Symbolic(x), Type::Symbolic(y)) => self.differ(&x, &y),
            (Type::Tuple(x), Type::Tuple(y)) if x.len() == y.len() => {
                x.iter().zip(&y).any(|(x, y)| self.differ(x, y))
            }
            (Type::Function(x, of_x), Type::Function(y, of_y)) if x.len() == y.len() => {
                x.iter().zip(&y).any(|(x, y)| self.differ(x, y)) || self.differ(&of_x, &of_y)
            }
            (a, b) => a != b,
        }
    }

    pub fn unify(&mut self, a: &Type, b: &Type) -> Result<(), Mismatch> {
        let (a, b) = (self.known(a), self.known(b));
        if let (Type::Number(x), Type::Number(y)) = (a, b)
            && x == y
        {
            rules::applied(Rule::KnownDimension);
            rules::unified(a, b, &Ok(()));
            return Ok(());
        }
        let (a, b) = (a.clone(), b.clone());
        let result = self.unify_shallow(&a, &b);
        rules::unified(&a, &b, &result);
        result
    }

    fn unify_shallow(&mut self, a: &Type, b: &Type) -> Result<(), Mismatch> {
        match (a, b) {
            (Type::Error, _) | (_, Type::Error) => Ok(()),
            (Type::Unknown(x), Type::Unknown(y)) if x == y => Ok(()),
            (Type::Unknown(x), other) | (other, Type::Unknown(x)) => self.decide(*x, other),
            (Type::Number(x), Type::Number(y))
            | (Type::Vector(x), Type::Vector(y))
            | (Type::Observable(x), Type::Observable(y)) => self.unify_dims(x, y),
            (Type::Array(x), Type::Array(y))
            | (Type::Optional(x), Type::Optional(y))
            | (Type::Symbolic(x), Type::Symbolic(y)) => self.unify(x, y),
            (Type::Tuple(x), Type::Tuple(y)) if x.len() == y.len() => {
                x.iter().zip(y).try_for_each(|(x, y)| self.unify(x, y))
            }
            (Type::Function(x, of_x), Type::Function(y, of_y)) if x.len() == y.len() => {
                x.iter().zip(y).try_for_each(|(x, y)| self.unify(x, y))?;
                self.unify(of_x, of_y)
            }
            _ if a == b => Ok(()),
            _ => Err(Mismatch::Kind),
        }
    }

    /// Returns the final type at the end of inference: unassigned variables are pure numbers.
    pub fn closed(&self, ty: &Type) -> Type {
        match self.known(ty) {
            Type::Unknown(_) => Type::number(),
            Type::Number(dim) => Type::Number(self.closed_dim(dim)),
            Type::Vector(dim) => Type::Vector(self.closed_dim(dim)),
            Type::Observable(dim) => Type::Observable(self.closed_dim(dim)),
            Type::Array(element) => Type::array(self.closed(element)),
            Type::Symbolic(inner) => Type::Symbolic(Box::new(self.closed(inner))),
            Type::Optional(inner) => Type::optional(self.closed(inner)),
            Type::Tuple(parts) => Type::Tuple(parts.iter().map(|part| self.closed(part)).collect()),
            Type::Function(parts, result) => Type::Function(
                parts.iter().map(|part| self.closed(part)).collect(),
                Box::new(self.closed(result)),
            ),
            other => other.clone(),
        }
    }

    pub fn closed_dim(&self, dim: &Dim) -> Dim {
        Dim::known(self.dim(dim).fixed)
    }

    /// Adds the unassigned variables of a type to the sets.
    pub fn unknowns(&self, ty: &Type, types: &mut BTreeSet<TypeVar>, dims: &mut BTreeSet<DimVar>) {
        match self.known(ty) {
            Type::Unknown(variable) => {
                types.insert(*variable);
            }
            Type::Number(dim) | Type::Vector(dim) | Type::Observable(dim) => {
                dims.extend(self.dim(dim).variables());
            }
            Type::Array(inner) | Type::Symbolic(inner) | Type::Optional(inner) => {
                self.unknowns(inner, types, dims)
            }
            Type::Tuple(parts) => parts.iter().for_each(|part| self.unknowns(part, types, dims)),
            Type::Function(parts, result) => {
                parts.iter().chain([&**result]).for_each(|part| self.unknowns(part, types, dims));
            }
            _ => {}
        }
    }

    /// Returns the representation of values of the type; unassigned variables are numbers.
    pub fn repr(&self, ty: &Type) -> Repr {
        match self.known(ty) {
            Type::Unknown(_) | Type::Error | Type::Number(_) => Repr::Number,
            Type::Unit => Repr::Unit,
            Type::Bool => Repr::Bool,
            Type::String | Type::Enum(_) => Repr::String,
            Type::Vector(_) => Repr::Vector,
            Type::Transform => Repr::Transform,
            Type::Array(element) => Repr::Array(Box::new(self.repr(element))),
            Type::Tuple(parts) => Repr::Tuple(parts.iter().map(|part| self.repr(part)).collect()),
            // The presence of a value, and the value.
            Type::Optional(inner) => Repr::Tuple(vec![Repr::Bool, self.repr(inner)]),
            Type::Observable(_) => Repr::Symbolic(Box::new(Repr::Number)),
            Type::Symbolic(inner) => Repr::Symbolic(Box::new(self.repr(inner))),
            // Calls determine functions when they are compiled, so no value represents them.
            Type::Function(..) => Repr::Tuple(Vec::new()),
            Type::Handle(_) => Repr::Handle,
            Type::Record(id) => {
                let fields = self.record(*id).into_iter().flat_map(|record| &record.fields);
                Repr::Tuple(fields.map(|(_, ty)| self.repr(ty)).collect())
            }
        }
    }

    /// Returns the type as displayed: `Length`, `Array(Vector(Force))`; an unknown type is `_`.
    pub fn show(&self, ty: &Type) -> String {
        match self.known(ty) {
            Type::Unknown(_) | Type::Error => "_".into(),
            Type::Unit => "nothing".into(),
            Type::Number(dim) => self.show_dim(dim),
            Type::Bool => "Bool".into(),
            Type::String => "String".into(),
            Type::Vector(dim) => match self.show_dim(dim).as_str() {
                "Number" => "Vector".into(),
                inner => format!("Vector({inner})"),
            },
            Type::Transform => "Transform".into(),
            Type::Array(element) => format!("Array({})", self.show(element)),
            Type::Tuple(parts) => {
                format!("[{}]", parts.iter().map(|part| self.show(part)).collect::<Vec<_>>().join(", "))
            }
            Type::Observable(dim) => format!("Observable({})", self.show_dim(dim)),
            Type::Symbolic(inner) => format!("Symbolic({})", self.show(inner)),
            Type::Optional(inner) => format!("{} or none", self.show(inner)),
            Type::Function(parts, result) => {
                let parts: Vec<String> = parts.iter().map(|part| self.show(part)).collect();
                format!("Function({}) -> {}", parts.join(", "), self.show(result))
            }
            Type::Handle(name) => name.clone(),
            Type::Enum(of) => of.name.clone(),
            Type::Record(id) => self.record(*id).map_or_else(|| "_".into(), |record| record.name.clone()),
        }
    }

    pub fn show_dim(&self, dim: &Dim) -> String {
        let dim = self.dim(dim);
        match (dim.as_known(), dim.fixed.is_none()) {
            (Some(known), _) => self.vocabulary.show(known),
            (None, true) => "Number".into(),
            (None, false) => format!("{}*_", self.vocabulary.show(dim.fixed)),
        }
    }
}

/// The values of a type scheme's variables at one use.
#[derive(Clone, Debug, Default)]
pub struct Substitution {
    pub types: HashMap<TypeVar, Type>,
    pub dims: HashMap<DimVar, Dim>,
}

impl Substitution {
    pub fn ty(&self, store: &Store, ty: &Type) -> Type {
        match store.known(ty) {
            Type::Unknown(variable) => self.types.get(variable).cloned().unwrap_or(Type::Unknown(*variable)),
            Type::Number(dim) => Type::Number(self.dim(store, dim)),
            Type::Vector(dim) => Type::Vector(self.dim(store, dim)),
            Type::Observable(dim) => Type::Observable(self.dim(store, dim)),
            Type::Array(element) => Type::array(self.ty(store, element)),
            Type::Symbolic(inner) => Type::Symbolic(Box::new(self.ty(store, inner))),
            Type::Optional(inner) => Type::optional(self.ty(store, inner)),
            Type::Tuple(parts) => Type::Tuple(parts.iter().map(|part| self.ty(store, part)).collect()),
            Type::Function(parts, result) => Type::Function(
                parts.iter().map(|part| self.ty(store, part)).collect(),
                Box::new(self.ty(store, result)),
            ),
            other => other.clone(),
        }
    }

    pub fn dim(&self, store: &Store, dim: &Dim) -> Dim {
        let dim = store.dim(dim);
        let mut result = Dim::known(dim.fixed);
        for &(variable, exponent) in &dim.unknowns {
            let part = self.dims.get(&variable).cloned().unwrap_or_else(|| Dim::unknown(variable));
            result = result.times(&part.power(exponent).unwrap_or_else(Dim::none));
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dimension::Rational;

    fn length() -> Dim {
        Dim::known(Dimension::whole([1, 0, 0, 0, 0]))
    }

    #[test]
    fn dimensions_are_solved_with_rational_exponents() {
        // x^2 = Length implies x = Length^(1/2).
        let mut store = Store::default();
        let x = store.fresh_dim();
        store.unify_dims(&x.power(Rational::integer(2)).unwrap(), &length()).unwrap();
        assert_eq!(store.dim(&x), length().power(Rational::new(1, 2).unwrap()).unwrap());
    }

    #[test]
    fn angle_never_blocks_and_is_carried() {
        let mut store = Store::default();
        let angle = Dim::known(Dimension::whole([0, 0, 0, 1, 0]));
        assert!(store.unify_dims(&angle, &Dim::none()).is_ok());
        let x = store.fresh_dim();
        store.unify_dims(&x, &angle).unwrap();
        assert_eq!(store.show_dim(&x), "Angle");
        assert!(store.unify_dims(&x, &length()).is_err());
    }

    #[test]
    fn a_literal_dimension_survives_as_the_unknown() {
        let mut store = Store::default();
        let (literal, other) = (store.fresh_literal_dim(), store.fresh_dim());
        store.unify_dims(&literal, &other).unwrap();
        let left = store.dim(&other);
        assert!(left.variables().all(|v| store.is_literal(v)));
    }
}
