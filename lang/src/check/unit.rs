//! Check units: a function, mutually recursive functions, or the top level of a file.
//!
//! A unit is checked in an excerpt of the program. The result refers to other code only by item.

use super::excerpt::{Excerpt, ItemId, Layout, Part, RecordKey};
use super::infer::{Checker, Requests};
use super::interface::Interface;
use super::lower::{self, Closure};
use super::name_resolution::NameTable;
use super::schemes::ShownScheme;
use super::tree::{FuncId, Function, RecordId, StmtKind, VarId};
use super::typed::Typed;
use super::{ModuleData, has_errors, names};
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::Span;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, OnceLock};

/// Function of the library that creates a handle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Maker {
    /// Name, including the module.
    pub name: String,
    /// Parameters of named types: name and type.
    pub parameters: Vec<(String, String)>,
}

/// Queries of a check about the rest of the program, for suggestions in diagnostics.
pub trait Surroundings {
    /// Returns the names that a module declares.
    fn declared(&self, module: &str) -> Vec<String>;
    /// Returns the documentation of a module.
    fn doc(&self, module: &str) -> String;
    /// Returns the functions of the library that create a handle of this type.
    fn makers(&self, handle: &str) -> Vec<Maker>;
    /// Returns `true` if functions of a module take or return handles of this type.
    fn has_handle(&self, module: &str, handle: &str) -> bool;
    /// Returns `true` if a module with this name can be imported.
    fn is_module(&self, name: &str) -> bool;
    /// Returns the modules that can be imported.
    fn modules(&self) -> Vec<String>;
    /// Returns `true` if suggestions are requested.
    fn suggests(&self) -> bool {
        true
    }
}

/// The result of checking a unit.
#[derive(Debug, Default)]
pub struct Unit {
    pub typed: Typed,
    pub layout: Layout,
    /// The functions of the excerpt's items.
    pub functions: HashMap<ItemId, FuncId>,
    /// Functions of which the excerpt contains only the header.
    pub foreign: HashMap<FuncId, ItemId>,
    pub closures: HashMap<FuncId, Closure>,
    /// Records by their number in this unit.
    pub records: Vec<RecordKey>,
    /// Diagnostics of names, types and dimensions. Locations refer to the excerpt.
    pub diagnostics: Vec<Diagnostic>,
    /// Control-flow diagnostics of generic functions without type errors.
    generic_flow: Vec<Diagnostic>,
    /// Control-flow diagnostics of the other functions. They are computed on demand: a program
    /// without errors also finds them when it lowers these functions.
    plain_flow: OnceLock<Vec<Diagnostic>>,
    /// The functions without type errors, with their texts; `None` if the unit has no errors.
    sound: Option<Vec<(FuncId, Span)>>,
    /// Types of variables, params and outputs, as displayed.
    pub types: BTreeMap<String, String>,
    /// Schemes of the functions checked in this unit, as displayed.
    pub schemes: BTreeMap<String, String>,
    /// Meanings of names, for editors.
    pub meanings: NameTable,
}

/// Information about the rest of the program that a check needs.
pub struct Context<'c> {
    pub interfaces: &'c HashMap<ItemId, Arc<Interface>>,
    /// Names of handle types.
    pub handles: &'c BTreeSet<String>,
    pub surroundings: &'c dyn Surroundings,
}

/// Limit of the repetitions of a check. A repetition is needed if a variable that starts as a
/// number later receives an observable, or if an anonymous function captures an array; few programs
/// need more than one.
const MOST_REPETITIONS: usize = 8;

/// A check of the names and types of an excerpt.
struct CheckedNames<'m> {
    checker: Checker<'m>,
    /// Diagnostics of the names.
    diagnostics: Vec<Diagnostic>,
    functions: HashMap<ItemId, FuncId>,
    foreign: HashMap<FuncId, ItemId>,
}

impl<'m> CheckedNames<'m> {
    /// Checks the modules of an excerpt. Earlier checks requested what is `given`.
    fn of(modules: &'m [ModuleData], layout: &'m Layout, context: &Context<'m>, given: &Requests) -> Self {
        let mut names = names::resolve(modules, context.surroundings);
        let diagnostics = std::mem::take(&mut names.diagnostics);
        let (mut functions, mut foreign) = (HashMap::default(), HashMap::default());
        for (index, info) in names.functions.iter().enumerate() {
            let id = FuncId(index as u32);
            let Some(decl) = info.decl.filter(|_| info.parent == Some(FuncId(0))) else { continue };
            let Some(segment) = layout.segment(decl.name.span.file, decl.name.span.start) else { continue };
            match segment.part {
                Part::Header => {
                    foreign.insert(id, segment.item);
                }
                Part::Own | Part::Whole => {
                    functions.entry(segment.item).or_insert(id);
                }
            }
        }
        let mut checker = Checker::new(modules, names, layout, given.clone());
        checker.handles.extend(context.handles.iter().cloned());
        for (&id, item) in &foreign {
            if let Some(interface) = context.interfaces.get(item) {
                interface.import(&mut checker, id);
            }
        }
        checker.program();
        CheckedNames { checker, diagnostics, functions, foreign }
    }
}

/// Checks an excerpt's own items. Returns the interfaces of `group`, in order, or `None` if they
/// depend on the uses of the functions.
pub fn check(excerpt: Excerpt, group: &[ItemId], context: &Context<'_>) -> (Unit, Option<Vec<Interface>>) {
    let Excerpt { modules, layout } = excerpt;
    let mut given = Requests::default();
    let mut checked = CheckedNames::of(&modules, &layout, context, &given);
    for _ in 0..MOST_REPETITIONS {
        if checked.checker.requested.is_empty() {
            break;
        }
        given.extend(std::mem::take(&mut checked.checker.requested));
        checked = CheckedNames::of(&modules, &layout, context, &given);
    }
    let CheckedNames { mut checker, mut diagnostics, functions, foreign } = checked;
    diagnostics.append(&mut checker.diagnostics);
    let types = checker.shown_types();
    let own = (1..checker.names.functions.len() as u32).map(FuncId).filter(|id| !foreign.contains_key(id));
    let own: HashMap<FuncId, ShownScheme> =
        own.filter_map(|id| Some((id, checker.shown_scheme(id)?))).collect();
    let schemes = functions.values().filter_map(|id| own.get(id));
    let schemes = schemes.map(|scheme| (scheme.name.clone(), scheme.to_string())).collect();
    let meanings = NameTable::of(&mut checker, own);
    let members: Option<Vec<FuncId>> = group.iter().map(|item| functions.get(item).copied()).collect();
    let interfaces = match checker.unsettled {
        true => None,
        false => members.and_then(|members| Interface::of_group(&mut checker, &members)),
    };
    let local = |id: RecordId| (ItemId::MAX, id.0);
    let records = (0..checker.record_count() as u32).map(RecordId);
    let records = records.map(|id| checker.record_key(id).unwrap_or(local(id))).collect();
    let sound = match has_errors(&diagnostics) {
        true => Some(checker.sound_functions(&diagnostics)),
        false => None,
    };
    // Afterwards, because a function with an error that is not shown is not sound.
    checker.evidence.focus(&mut diagnostics);
    let (typed, uses) = checker.into_typed();
    let closures = lower::closures(&typed);
    let mut unit = Unit {
        typed,
        layout,
        functions,
        foreign,
        closures,
        records,
        diagnostics,
        generic_flow: Vec::new(),
        plain_flow: OnceLock::new(),
        sound,
        types,
        schemes,
        meanings: meanings.with_uses(uses),
    };
    unit.generic_flow = unit.flow_of(|function| function.is_generic());
    (unit, interfaces)
}

impl Unit {
    /// Returns the control-flow diagnostics of the functions without type errors.
    pub fn flow(&self) -> impl Iterator<Item = &Diagnostic> {
        let plain = self.plain_flow.get_or_init(|| self.flow_of(|function| !function.is_generic()));
        self.generic_flow.iter().chain(plain)
    }

    /// Returns the control-flow diagnostics without those of functions that are found when they are
    /// lowered; `is_lowered` returns `true` for these functions.
    pub fn flow_besides(&self, is_lowered: impl Fn(FuncId) -> bool) -> impl Iterator<Item = &Diagnostic> {
        let mut plain = self.typed.functions.iter().filter(|(_, function)| !function.is_generic());
        let covered = plain.all(|(id, function)| !self.has_flow(*id, function) || is_lowered(*id));
        let plain = if covered { None } else { Some(self.flow()) };
        let generic = if covered { self.generic_flow.as_slice() } else { &[] };
        generic.iter().chain(plain.into_iter().flatten())
    }

    /// Returns `true` for a function with a control flow: not for functions with only a header, not
    /// for symbolic functions, and not for a top level that only declares.
    fn has_flow(&self, id: FuncId, function: &Function) -> bool {
        let declares = || function.body.iter().all(|statement| matches!(statement.kind, StmtKind::Nothing));
        !self.foreign.contains_key(&id) && function.definition.is_none() && (id != FuncId(0) || !declares())
    }

    /// Returns the control-flow diagnostics of some functions, of well-typed ones if the unit has
    /// errors.
    fn flow_of(&self, wanted: impl Fn(&Function) -> bool) -> Vec<Diagnostic> {
        let wanted =
            |(id, function): &(&FuncId, &Function)| self.has_flow(**id, function) && wanted(function);
        let mut functions: Vec<FuncId> =
            self.typed.functions.iter().filter(wanted).map(|(id, _)| *id).collect();
        functions.sort();
        let Some(sound) = &self.sound else { return lower::flow(self, &functions) };
        functions.retain(|id| sound.iter().any(|(sound, _)| sound == id));
        let mut found = lower::flow(self, &functions);
        found.retain(|d| {
            let at = d.primary.span;
            let of_flow = ["E02", "W02", "E03"].iter().any(|group| d.code.starts_with(group));
            let within = |text: &Span| at.file == text.file && at.start >= text.start && at.end <= text.end;
            of_flow && sound.iter().any(|(_, text)| within(text))
        });
        found
    }
}

/// Returns `true` if a function uses one of the given variables of the enclosing top level, as a
/// variable or as a unit after a number.
pub fn sees(extract: super::excerpt::Extract<'_>, variables: &[&str]) -> bool {
    use crate::ast::{Ident, Stmt, StmtKind, VarDecl};
    let mut excerpt = Excerpt::new(vec![extract]);
    let Some(module) = excerpt.modules.first_mut() else { return false };
    let mut at = module.text.len();
    let mut decls = Vec::new();
    for name in variables {
        let span = Span::new(module.file, at, at + name.len());
        at += name.len() + 1;
        decls.push(VarDecl { name: Ident { name: (*name).into(), span }, init: None });
    }
    let span = Span::new(module.file, at, at);
    module.tree.statements.insert(0, Stmt { kind: StmtKind::Var(decls), span, doc: None, private: false });
    let names = names::resolve(&excerpt.modules, &Nothing);
    let of_top = |id: &VarId| names.variables[id.0 as usize].owner == FuncId(0);
    // The warning about a unit that is also a variable (W0205) needs the variable's declaration.
    names.functions.iter().any(|function| function.outer.iter().any(of_top))
        || names.hidden_by_units.iter().any(of_top)
}

/// The surroundings of a check whose diagnostics are not used.
struct Nothing;

impl Surroundings for Nothing {
    fn declared(&self, _: &str) -> Vec<String> {
        Vec::new()
    }

    fn doc(&self, _: &str) -> String {
        String::new()
    }

    fn makers(&self, _: &str) -> Vec<Maker> {
        Vec::new()
    }

    fn has_handle(&self, _: &str, _: &str) -> bool {
        false
    }

    fn is_module(&self, _: &str) -> bool {
        false
    }

    fn modules(&self) -> Vec<String> {
        Vec::new()
    }

    fn suggests(&self) -> bool {
        false
    }
}
