//! The extent of types: nesting depth and number of parts, including fields of records.
//!
//! Traversals of types are recursive, and values are stored part by part. Both are limited here, at
//! the only operation that enlarges a type: the assignment of a type variable.

use super::tree::RecordId;
use super::types::{Mismatch, Store, Type, TypeVar};
use crate::hashed::{HashMap, HashSet};

/// Limit of the nesting depth of arrays, tuples and records.
pub const MOST_NESTED: usize = 100;

/// Limit of the parts of a type, without the fields of records. A tuple of two tuples of two tuples
/// ... has a short text but a type of exponential size.
pub const MOST_PARTS: usize = 1000;

/// Limit of the parts of a type, including the fields of records.
pub const MOST_FIELDS: usize = 1000;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct TypeExtent {
    depth: usize,
    parts: usize,
}

/// A traversal of a type that measures each record once.
struct Walk<'s> {
    store: &'s Store,
    /// A type variable that must not occur in the type.
    excluded: Option<TypeVar>,
    /// Remaining number of parts outside of records.
    left: usize,
    /// Extents of records; `None` while a record is being measured.
    records: HashMap<RecordId, Option<TypeExtent>>,
    unknowns: Vec<TypeVar>,
}

impl Walk<'_> {
    /// Returns the extent of a type; `None` if it is infinite or too large. `around` is the number
    /// of enclosing types.
    fn extent(&mut self, ty: &Type, around: usize) -> Option<TypeExtent> {
        self.left = self.left.checked_sub(1)?;
        if around > MOST_NESTED {
            return None;
        }
        let store = self.store;
        let mut whole = TypeExtent { depth: 0, parts: 1 };
        let mut add = |part: TypeExtent| {
            whole.depth = whole.depth.max(part.depth);
            whole.parts = whole.parts.saturating_add(part.parts);
        };
        match store.known(ty) {
            Type::Unknown(variable) if self.excluded == Some(*variable) => return None,
            Type::Unknown(variable) => self.unknowns.push(*variable),
            Type::Array(inner) | Type::Symbolic(inner) | Type::Optional(inner) => {
                add(self.extent(inner, around + 1)?)
            }
            Type::Tuple(parts) => {
                for part in parts {
                    add(self.extent(part, around + 1)?);
                }
            }
            Type::Function(parts, result) => {
                for part in parts.iter().chain([&**result]) {
                    add(self.extent(part, around + 1)?);
                }
            }
            Type::Record(id) => match self.records.get(id) {
                // `None` in the map: the record contains itself.
                Some(known) => return *known,
                None => {
                    self.records.insert(*id, None);
                    for (_, field) in store.record(*id).into_iter().flat_map(|record| &record.fields) {
                        let left = std::mem::replace(&mut self.left, MOST_PARTS);
                        let field = self.extent(field, around + 1);
                        self.left = left;
                        add(field?);
                    }
                }
            },
            _ => {}
        }
        whole.depth += 1;
        if whole.depth > MOST_NESTED || whole.parts > MOST_FIELDS {
            return None;
        }
        if let Type::Record(id) = store.known(ty) {
            self.records.insert(*id, Some(whole));
        }
        Some(whole)
    }
}

impl Store {
    fn walk(&self, excluded: Option<TypeVar>) -> Walk<'_> {
        Walk { store: self, excluded, left: MOST_PARTS, records: HashMap::default(), unknowns: Vec::new() }
    }

    /// Returns `true` if a type is finite and within the limits.
    pub fn is_bounded(&self, ty: &Type) -> bool {
        self.walk(None).extent(ty, 0).is_some()
    }

    /// Assigns a type to a type variable. Fails if the type, or a type that contains the variable,
    /// would become infinite or too large.
    pub(super) fn decide(&mut self, variable: TypeVar, ty: &Type) -> Result<(), Mismatch> {
        let mut walk = self.walk(Some(variable));
        let extent = walk.extent(ty, 0).ok_or(Mismatch::Infinite)?;
        let mut unknowns = walk.unknowns;
        if let Type::Unknown(other) = ty {
            self.set_type(variable, Some(ty.clone()));
            if let Some(around) = self.around.remove(&variable) {
                self.around.entry(*other).or_default().extend(around);
            }
            return Ok(());
        }
        self.set_type(variable, Some(ty.clone()));
        // A type without parts does not enlarge the types that contain it.
        if extent.parts > 1 && !self.all_around_are_bounded(variable) {
            self.set_type(variable, None);
            return Err(Mismatch::Infinite);
        }
        unknowns.sort();
        unknowns.dedup();
        for unknown in unknowns {
            self.around.entry(unknown).or_default().push(variable);
        }
        Ok(())
    }

    /// Returns `true` if the outermost types that contain a type are within the limits.
    fn all_around_are_bounded(&self, variable: TypeVar) -> bool {
        let (mut left, mut seen) = (vec![variable], HashSet::from_iter([variable]));
        while let Some(at) = left.pop() {
            match self.around.get(&at) {
                Some(around) => left.extend(around.iter().copied().filter(|other| seen.insert(*other))),
                None if at != variable && !self.is_bounded(&Type::Unknown(at)) => return false,
                None => {}
            }
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::types::RecordType;

    fn is_refused(results: impl Iterator<Item = Result<(), Mismatch>>) -> bool {
        results.collect::<Vec<_>>().contains(&Err(Mismatch::Infinite))
    }

    #[test]
    fn a_type_never_contains_itself() {
        let mut store = Store::default();
        let x = store.fresh();
        assert_eq!(store.unify(&x, &Type::array(x.clone())), Err(Mismatch::Infinite));
    }

    #[test]
    fn a_record_never_contains_itself_by_an_undecided_field() {
        let mut store = Store::default();
        let (own, list) = (store.fresh(), store.fresh());
        let fields = vec![("own".into(), own.clone()), ("list".into(), Type::array(list.clone()))];
        store.records.push(RecordType { name: "P".into(), fields, former: Vec::new() });
        let record = Type::Record(RecordId(0));
        assert_eq!(store.unify(&own, &record), Err(Mismatch::Infinite));
        assert_eq!(store.unify(&list, &Type::Tuple(vec![Type::Bool, record])), Err(Mismatch::Infinite));
    }

    #[test]
    fn a_type_that_doubles_again_and_again_is_refused() {
        let mut store = Store::default();
        let mut part = Type::Bool;
        assert!(is_refused((0..60).map(|_| {
            let next = store.fresh();
            let fits = store.unify(&next, &Type::Tuple(vec![part.clone(), part.clone()]));
            part = next;
            fits
        })));
    }

    #[test]
    fn a_type_that_doubles_from_the_outside_in_is_refused() {
        let mut store = Store::default();
        let mut outer = store.fresh();
        assert!(is_refused((0..60).map(|_| {
            let inner = store.fresh();
            let fits = store.unify(&outer, &Type::Tuple(vec![inner.clone(), inner.clone()]));
            outer = inner;
            fits
        })));
    }

    #[test]
    fn a_type_that_nests_from_the_outside_in_is_refused() {
        let mut store = Store::default();
        let mut outer = store.fresh();
        assert!(is_refused((0..200).map(|_| {
            let (inner, alias) = (store.fresh(), store.fresh());
            let fits = store.unify(&outer, &Type::array(inner.clone()));
            store.unify(&inner, &alias).expect("an unknown type is decided");
            outer = alias;
            fits
        })));
    }

    #[test]
    fn records_inside_one_another_are_bounded() {
        for fields in [1, 2] {
            let mut store = Store::default();
            let results: Vec<_> = (0..200)
                .map(|at| {
                    let held = match at {
                        0 => Type::Bool,
                        _ => Type::Record(RecordId(at - 1)),
                    };
                    let all = (0..fields).map(|field| (format!("f{field}"), held.clone())).collect();
                    let name = format!("R{at}");
                    store.records.push(RecordType { name, fields: all, former: Vec::new() });
                    let value = store.fresh();
                    store.unify(&value, &Type::Record(RecordId(at)))
                })
                .collect();
            assert!(results[..5].iter().all(Result::is_ok) && results[199].is_err(), "{fields} fields");
        }
    }
}
