//! Lowers host functions: lists them, and calls the embedding program's function where one is
//! provided.

use super::body::Body;
use super::{Lowering, known_dimension};
use crate::check::tree::{FuncId, VarId};
use crate::check::types::{Substitution, Type};
use crate::hashed::HashMap;
use crate::ir::{self, ExprKind, HostFunction, HostId, HostValue, Place, Statement, Terminator};
use crate::span::{FileId, Span};
use calyx_abi::Repr;

/// Host functions by unit and function.
pub(super) type Hosts = HashMap<(usize, FuncId), HostId>;

impl Lowering<'_> {
    /// Lists all host functions in order of file and position, including unused ones.
    pub(super) fn host_functions(&mut self) {
        let mut all: Vec<(FileId, u32, usize, FuncId)> = Vec::new();
        for (unit, typed) in self.linked.typed.iter().enumerate() {
            let Some(places) = self.linked.places(unit) else { continue };
            let hosts = typed.functions.iter().filter(|(_, function)| function.host.is_some());
            all.extend(hosts.map(|(id, function)| {
                let Span { file, start, .. } = places.span(function.span);
                (file, start, unit, *id)
            }));
        }
        all.sort();
        // If a function is in several units, the first one counts, as for calls.
        all.dedup_by_key(|(file, start, ..)| (*file, *start));
        for (_, _, unit, id) in all {
            self.within(unit, |lowering| lowering.host_function(id));
            self.hosts.insert((unit, id), HostId(self.program.host_functions.len() as u32 - 1));
            self.instance(unit, id, Substitution::default(), (None, Vec::new()));
        }
    }

    fn host_function(&mut self, id: FuncId) {
        let (checker, system) = (self.checker, self.system);
        let Some(function) = checker.functions.get(&id) else { return };
        let value = |name: &str, ty: &Type| {
            let mut inner = checker.store.resolve(ty);
            while let Type::Array(element) = inner {
                inner = checker.store.resolve(&element);
            }
            HostValue {
                name: name.to_owned(),
                repr: checker.store.repr(ty),
                ty: checker.store.show(ty),
                unit: checker.store.vocabulary.unit_of(system, known_dimension(checker, &inner)),
            }
        };
        let parameters = function.parameters.iter();
        let parameters =
            parameters.map(|(id, _)| value(&checker.variable(*id).name, &checker.type_of(*id))).collect();
        let result = value("", &function.result);
        let offer = function.host.clone();
        let (name, doc) = offer.map_or_else(Default::default, |offer| (offer.name, offer.doc));
        let span = self.places().map_or(function.span, |places| places.span(function.span));
        self.program.host_functions.push(HostFunction { name, doc, parameters, result, span });
    }
}

impl Body<'_, '_> {
    /// Calls the function of the embedding program. The body that follows runs if it is not
    /// provided.
    pub(super) fn ask_host(&mut self, function: HostId, parameters: &[VarId], result: &Repr, span: Span) {
        let mut arguments = Vec::new();
        for &parameter in parameters {
            let local = self.local(parameter);
            arguments.push(ir::Expr { kind: ExprKind::Local(local), repr: self.local_repr(local), span });
        }
        let provided = Place::whole(self.temporary_of(Repr::Bool), Repr::Bool);
        let given = Place::whole(self.temporary_of(result.clone()), result.clone());
        let read =
            |place: &Place| ir::Expr { kind: ExprKind::Local(place.local), repr: place.repr.clone(), span };
        let (condition, value) = (read(&provided), read(&given));
        self.push(Statement::Host { function, arguments, result: given, provided, span });
        let (there, own) = (self.new_block(), self.new_block());
        self.branch_on(condition, there, own);
        self.start(there);
        self.end(Terminator::Return(Some(value)));
        self.start(own);
    }
}
