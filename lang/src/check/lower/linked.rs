//! Links check units: maps calls to functions of other units, and items to their positions in
//! files.

use super::Lowering;
use crate::check::excerpt::{ItemId, Places, RecordKey};
use crate::check::tree::{FuncId, RecordId, UseId};
use crate::check::typed::Typed;
use crate::check::types::{RecordType, Substitution, Type};
use crate::check::unit::Unit;
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::FileId;
use std::collections::btree_map::{BTreeMap, Entry};
use std::sync::Arc;

/// The units of a program.
pub struct Linked<'u> {
    units: Vec<&'u Unit>,
    /// The typed functions of each unit. A unit with generic functions also contains the records of
    /// other units with which generic functions are used.
    pub(super) typed: Vec<Typed>,
    /// Records by unit and number.
    records: Vec<Vec<RecordKey>>,
    /// Unit and function by item.
    functions: HashMap<ItemId, (usize, FuncId)>,
    /// Maps of locations from the excerpt of each unit to files; empty if locations stay relative
    /// to excerpts.
    places: Vec<Places<'u>>,
}

impl<'u> Linked<'u> {
    /// Links units. The first unit is the model's top level. If a function is in several units, the
    /// first one counts. `items` has the start of each item; if it is empty, locations stay
    /// relative to excerpts.
    pub fn new(units: Vec<&'u Unit>, items: &HashMap<ItemId, (FileId, u32)>) -> Self {
        let mut functions = HashMap::default();
        for (index, unit) in units.iter().enumerate() {
            for (&item, &function) in &unit.functions {
                functions.entry(item).or_insert((index, function));
            }
        }
        let all = passed_records(&units);
        let mut records: Vec<Vec<RecordKey>> = units.iter().map(|unit| unit.records.clone()).collect();
        let mut typed: Vec<Typed> = units.iter().map(|unit| unit.typed.clone()).collect();
        for (unit, (typed, records)) in typed.iter_mut().zip(&mut records).enumerate() {
            let missing: Vec<_> = all.iter().filter(|(item, _)| !records.contains(item)).collect();
            if missing.is_empty() || !typed.is_general() {
                continue;
            }
            records.extend(missing.iter().map(|(item, _)| **item));
            for (_, (from, id)) in missing {
                debug_assert_ne!(*from, unit);
                let from = units[*from];
                let Some(record) = from.typed.store.record(*id) else { continue };
                let own = |id: RecordId| renumbered(id, &from.records, records);
                let fields = record.fields.iter();
                let fields = fields
                    .map(|(name, ty)| (name.clone(), from.typed.store.closed(ty).with_records(&own)))
                    .collect();
                let (name, former) = (record.name.clone(), record.former.clone());
                Arc::make_mut(&mut typed.store).records.push(RecordType { name, fields, former });
            }
        }
        // A generic function may be instantiated with dimensions that only the model names.
        if let Some((model, others)) = typed.split_first_mut() {
            for other in others {
                if other.store.vocabulary != model.store.vocabulary {
                    Arc::make_mut(&mut other.store).vocabulary = model.store.vocabulary.clone();
                }
            }
        }
        let places = match items.is_empty() {
            true => Vec::new(),
            false => units.iter().map(|unit| Places::new(&unit.layout, items)).collect(),
        };
        Linked { units, typed, records, functions, places }
    }

    pub fn units(&self) -> &[&'u Unit] {
        &self.units
    }

    /// Returns the map of locations from the excerpt of a unit to files.
    pub fn places(&self, unit: usize) -> Option<&Places<'u>> {
        self.places.get(unit)
    }
}

/// Returns the records of all units with which generic functions are used, and the records in their
/// fields: for each, a unit and its number there.
fn passed_records(units: &[&Unit]) -> BTreeMap<RecordKey, (usize, RecordId)> {
    let mut found = BTreeMap::new();
    for (index, unit) in units.iter().enumerate() {
        let store = &unit.typed.store;
        let mut left: Vec<&Type> = unit.typed.instances.iter().flat_map(|used| used.types.values()).collect();
        while let Some(ty) = left.pop() {
            match store.known(ty) {
                Type::Record(id) => {
                    let Some(key) = unit.records.get(id.0 as usize) else { continue };
                    if let Entry::Vacant(entry) = found.entry(*key) {
                        entry.insert((index, *id));
                        let fields = store.record(*id).into_iter().flat_map(|record| &record.fields);
                        left.extend(fields.map(|(_, ty)| ty));
                    }
                }
                Type::Array(inner) | Type::Symbolic(inner) | Type::Optional(inner) => left.push(inner),
                Type::Tuple(parts) => left.extend(parts),
                Type::Function(parts, result) => {
                    left.extend(parts);
                    left.push(result);
                }
                _ => {}
            }
        }
    }
    found
}

/// Converts the number of a record in one table to its number in another.
fn renumbered(id: RecordId, from: &[RecordKey], to: &[RecordKey]) -> RecordId {
    let item = from.get(id.0 as usize);
    let at = item.and_then(|item| to.iter().position(|other| other == item));
    at.map_or(id, |at| RecordId(at as u32))
}

impl<'c> Lowering<'c> {
    /// Lowers code of another unit, and converts the locations of the result to files.
    pub(super) fn within<T>(&mut self, unit: usize, work: impl FnOnce(&mut Self) -> T) -> T {
        let around = self.unit;
        self.place();
        self.enter(unit);
        let result = work(self);
        self.place();
        self.enter(around);
        result
    }

    /// Returns `true` if a single unit is lowered, so that functions of other units are not
    /// available.
    pub(super) fn alone(&self) -> bool {
        self.linked.places.is_empty()
    }

    /// Converts the locations of everything that the current unit has added so far.
    fn place(&mut self) {
        let (sites, functions, diagnostics) = self.placed;
        if let Some(places) = self.places() {
            let program = &mut self.program;
            program.sites[sites..].iter_mut().for_each(|site| super::relocation::site(site, places));
            let added = &mut program.symbolic_functions[functions..];
            added.iter_mut().for_each(|function| super::relocation::symbolic_function(function, places));
            for found in &mut self.diagnostics[diagnostics..] {
                *found = places.diagnostic(found);
            }
        }
        self.placed =
            (self.program.sites.len(), self.program.symbolic_functions.len(), self.diagnostics.len());
    }

    fn enter(&mut self, unit: usize) {
        let linked: &'c Linked<'c> = self.linked;
        if let (Some(entered), Some(typed)) = (linked.units.get(unit), linked.typed.get(unit)) {
            self.unit = unit;
            self.checker = typed;
            self.closures = &entered.closures;
        }
    }

    /// Returns the map of locations from the excerpt of the current unit to files.
    pub(super) fn places(&self) -> Option<&'c Places<'c>> {
        let linked: &'c Linked<'c> = self.linked;
        linked.places(self.unit)
    }

    /// Returns the unit with a function's body, and the function in that unit; `None` if a single
    /// unit is lowered.
    pub(super) fn resolve(&self, function: FuncId) -> Option<(usize, FuncId)> {
        match self.linked.units.get(self.unit)?.foreign.get(&function) {
            None => Some((self.unit, function)),
            Some(item) => self.linked.functions.get(item).copied(),
        }
    }

    /// Returns the function used at `instance` and the types of its scheme's variables. `types` are
    /// those of the calling body.
    pub(super) fn callee(
        &self,
        function: FuncId,
        instance: UseId,
        types: &Substitution,
    ) -> Option<(usize, FuncId, Substitution)> {
        let (unit, there) = self.resolve(function)?;
        let (here, store) = (self.checker, &self.checker.store);
        let scheme = &here.functions.get(&function)?.scheme;
        let target = &self.linked.typed.get(unit)?.functions.get(&there)?.scheme;
        let (from, to) = (self.linked.records.get(self.unit)?, self.linked.records.get(unit)?);
        let moved = |id| if unit == self.unit { id } else { renumbered(id, from, to) };
        let at_use = here.instances.get(instance.0 as usize);
        let mut concrete = Substitution::default();
        for (variable, to) in scheme.types.iter().zip(&target.types) {
            let ty = at_use.and_then(|used| used.types.get(variable)).cloned();
            let ty = types.ty(store, &ty.unwrap_or(Type::Unknown(*variable)));
            concrete.types.insert(*to, store.closed(&ty).with_records(&moved));
        }
        for (variable, to) in scheme.dims.iter().zip(&target.dims) {
            let dim = at_use.and_then(|used| used.dims.get(variable)).cloned();
            let dim = types.dim(store, &dim.unwrap_or_else(|| crate::check::dim::Dim::unknown(*variable)));
            concrete.dims.insert(*to, store.closed_dim(&dim));
        }
        Some((unit, there, concrete))
    }
}

/// Returns the control-flow diagnostics of some functions of a unit. Locations refer to its
/// excerpt.
pub fn flow(unit: &Unit, functions: &[FuncId]) -> Vec<Diagnostic> {
    if functions.is_empty() {
        return Vec::new();
    }
    let linked = Linked::new(vec![unit], &HashMap::default());
    let mut lowering = Lowering::new(&linked);
    lowering.interface_alone();
    for id in functions {
        super::body::Body::lower(&mut lowering, *id, Substitution::default(), &Vec::new());
    }
    lowering.diagnostics
}
