//! Queries over a whole model: checks all units and links them.

use super::groups::{Group, groups, links, named, sees_state};
use super::items::{Item, facts, items, module, problems, reachable};
use super::units::{check_group, check_top, dependents, id};
use super::{Library, Storage, Text};
use crate::ast::{ANONYMOUS, Ident, StmtKind};
use crate::check::item::ItemKind;
use crate::check::unit::Unit;
use crate::check::{Checked, Linked, Model, has_errors, lower, rules};
use crate::deep_recursion::with_deep_stack;
use crate::diagnostic::Diagnostic;
use crate::hashed::{HashMap, HashSet};
use crate::ir::SourceFile;
use crate::span::{FileId, Span};
use crate::threads;
use salsa::plumbing::{AsId, FromId};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Returns the files of a program: the model, the prelude, and their imports.
#[salsa::tracked]
fn files(db: &dyn salsa::Database, model: Text, library: Library) -> Vec<Text> {
    let prelude = library.prelude(db);
    let mut files = vec![model, prelude];
    for file in reachable(db, model, library).iter().chain(reachable(db, prelude, library)) {
        if !files.contains(file) {
            files.push(*file);
        }
    }
    files
}

/// Returns the items of sound modules that the other files use, directly or indirectly.
fn used<'db>(db: &'db dyn salsa::Database, files: &[Text], library: Library) -> HashSet<Item<'db>> {
    let mut left: Vec<Item<'db>> = Vec::new();
    for file in files.iter().filter(|file| !file.sound(db)) {
        left.extend(items(db, *file));
    }
    left.extend(named(db, library.prelude(db), "Error".to_string()));
    let mut seen: HashSet<Item<'db>> = left.iter().copied().collect();
    while let Some(item) = left.pop() {
        left.extend(links(db, item, library).iter().copied().filter(|to| seen.insert(*to)));
    }
    seen
}

/// Returns the groups of a file that contain a used item, callees first.
fn used_groups<'db>(
    db: &'db dyn salsa::Database,
    file: Text,
    (library, used): (Library, &HashSet<Item<'db>>),
) -> impl Iterator<Item = Group<'db>> {
    let order = groups(db, file, library).order.iter();
    let own = order.filter(move |members| members.first().is_some_and(|item| item.file(db) == file));
    let used = own.filter(move |members| members.iter().any(|item| used.contains(item)));
    used.map(move |members| Group::new(db, members.clone()))
}

/// Returns the groups that a check of a model checks on their own, callees first.
fn needed_groups(db: &dyn salsa::Database, model: Text, library: Library) -> Vec<Group<'_>> {
    let files = files(db, model, library);
    let used = used(db, files, library);
    let mut all = Vec::new();
    for &file in files.iter().rev() {
        if file.sound(db) {
            all.extend(used_groups(db, file, (library, &used)));
            continue;
        }
        let own = |item: &Item<'_>| item.file(db) == file && *item.kind(db) == ItemKind::Function;
        let order = groups(db, file, library).order.iter();
        let own = order.filter(|members| members.iter().any(own));
        let alone = own.filter(|members| !members.iter().any(|item| sees_state(db, *item)));
        all.extend(alone.map(|members| Group::new(db, members.clone())));
    }
    all
}

/// Checks the groups of a long model on all cores. Their results are the same in any order, and
/// [`check`] then finds them. The queries must not be cancelled meanwhile.
pub(super) fn check_groups(storage: &Storage, model: Text, library: Library) {
    let threads = threads::for_text(model.content(storage).len());
    if threads < 2 {
        return;
    }
    let groups = with_deep_stack(|| needed_groups(storage, model, library));
    let groups: Vec<salsa::Id> = groups.iter().map(Group::as_id).collect();
    let next = AtomicUsize::new(0);
    let work = |storage: &Storage| {
        with_deep_stack(|| {
            while let Some(group) = groups.get(next.fetch_add(1, Ordering::Relaxed)) {
                check_group(storage, Group::from_id(*group), library);
            }
        });
    };
    std::thread::scope(|scope| {
        let others = (1..threads).filter_map(|_| {
            let (storage, work) = (storage.clone(), &work);
            let work = move || {
                work(&storage);
                rules::take()
            };
            // If the system creates no thread, the others do its work.
            std::thread::Builder::new().spawn_scoped(scope, work).ok()
        });
        let spawned: Vec<_> = others.collect();
        work(storage);
        spawned.into_iter().filter_map(|thread| thread.join().ok()).for_each(rules::add);
    });
}

// A checked model is large and rarely equal to the previous one, so comparing does not pay.
#[salsa::tracked(no_eq)]
pub(super) fn check(db: &dyn salsa::Database, model: Text, library: Library) -> Arc<Checked> {
    Arc::new(checked(db, model, library))
}

/// Computes [`check`] without storing the result.
pub(super) fn checked(db: &dyn salsa::Database, model: Text, library: Library) -> Checked {
    let files = files(db, model, library);
    let mut starts = HashMap::default();
    let mut diagnostics = Vec::new();
    for (file, &text) in (0..).map(FileId).zip(files) {
        starts.extend(items(db, text).iter().map(|item| (id(*item), (file, item.start(db)))));
        diagnostics.extend(problems(db, text).iter().map(|diagnostic| in_file(diagnostic, file)));
        diagnostics.extend(missing_modules(db, text, file, library));
    }
    // Callees first, over all files, so that a chain of calls does not become a chain of nested
    // queries.
    let used = used(db, files, library);
    // Sound files of which only some functions are checked, each on its own.
    let mut partly = HashSet::default();
    for &file in files.iter().rev() {
        let mut groups = used_groups(db, file, (library, &used));
        if file.sound(db) && groups.all(|group| check_group(db, group, library).unit.is_some()) {
            partly.insert(file);
        } else {
            dependents(db, file, library);
        }
    }
    let mut kept: Vec<&Unit> = vec![check_top(db, model, library)];
    let mut of_model = 1;
    for &file in files {
        if partly.contains(&file) {
            kept.extend(
                used_groups(db, file, (library, &used))
                    .filter_map(|group| check_group(db, group, library).unit.as_ref()),
            );
            continue;
        }
        let dependents = dependents(db, file, library);
        for members in &groups(db, file, library).order {
            let own = members.first().is_some_and(|item| item.file(db) == file);
            if own && !members.iter().any(|item| dependents.contains(item)) {
                kept.extend(&check_group(db, Group::new(db, members.clone()), library).unit);
            }
        }
        if file == model {
            of_model = kept.len();
        } else {
            kept.push(check_top(db, file, library));
        }
    }
    let linked = Linked::new(kept, &starts);
    let placed = |index: usize, found: &mut dyn Iterator<Item = &Diagnostic>| -> Vec<Diagnostic> {
        let places = linked.places(index);
        found.map(|found| places.map_or_else(|| found.clone(), |p| p.diagnostic(found))).collect()
    };
    let units = || linked.units().iter().enumerate();
    diagnostics.extend(units().flat_map(|(index, unit)| placed(index, &mut unit.diagnostics.iter())));
    let mut program = None;
    let sources = files
        .iter()
        .map(|file| SourceFile { name: file.name(db).to_string(), text: file.content(db).clone() });
    let sources: Vec<SourceFile> = sources.collect();
    if diagnostics.iter().all(|d| !d.code.starts_with("E01")) {
        let facts = facts(db, model);
        let about = Model { system: facts.system, doc: facts.doc.clone() };
        let lowered = (!has_errors(&diagnostics)).then(|| lower(&linked, about, sources.clone()));
        match lowered {
            Some(lowered) if !has_errors(&lowered.diagnostics) => {
                diagnostics.extend(units().flat_map(|(index, unit)| {
                    let is_lowered = |function| lowered.functions.contains(&(index, function));
                    placed(index, &mut unit.flow_besides(is_lowered))
                }));
                diagnostics.extend(lowered.diagnostics);
                program = (!has_errors(&diagnostics)).then_some(lowered.program);
            }
            // An error in the control flow comes first: it may cause errors of lowering.
            lowered => {
                diagnostics.extend(units().flat_map(|(index, unit)| placed(index, &mut unit.flow())));
                if !has_errors(&diagnostics) {
                    diagnostics.extend(lowered.into_iter().flat_map(|lowered| lowered.diagnostics));
                }
            }
        }
    }
    diagnostics.sort_by_key(|d| (d.primary.span.file, d.primary.span.start, d.primary.span.end));
    // Every unit that uses a declaration checks it.
    let mut seen = HashSet::default();
    diagnostics.retain(|d| seen.insert((d.code.clone(), d.primary.span, d.message.clone())));
    let schemes = linked.units().iter().take(of_model).flat_map(|unit| unit.schemes.clone());
    let types = linked.units().first().map(|unit| unit.types.clone()).unwrap_or_default();
    let has_name = |(name, _): &(String, String)| !name.ends_with(ANONYMOUS);
    let types = types.into_iter().chain(schemes).filter(has_name).collect();
    Checked { program, diagnostics, files: sources, types }
}

fn in_file(diagnostic: &Diagnostic, file: FileId) -> Diagnostic {
    let mut diagnostic = diagnostic.clone();
    diagnostic.primary.span.file = file;
    diagnostic.labels.iter_mut().for_each(|label| label.span.file = file);
    for fix in diagnostic.fix.iter_mut().chain(&mut diagnostic.suggestions) {
        fix.span.file = file;
    }
    diagnostic
}

fn missing_modules(db: &dyn salsa::Database, text: Text, file: FileId, library: Library) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut seen = HashSet::default();
    for item in items(db, text) {
        let ItemKind::Import(path) = item.kind(db) else { continue };
        if module(db, library, path.clone()).is_some() || !seen.insert(path) {
            continue;
        }
        let StmtKind::Import(names) = &item.content(db).statement.kind else { continue };
        let start = item.start(db);
        let moved =
            |ident: &Ident| Span { file, start: ident.span.start + start, end: ident.span.end + start };
        if let (Some(first), Some(last)) = (names.first(), names.last()) {
            let place = moved(first).to(moved(last));
            found.push(match library.refused(db).get(path) {
                Some(refusal) => refused(path, place, refusal),
                None => missing(path, place, library.known(db)),
            });
        }
    }
    found
}

/// Returns the error for a module whose file exists but cannot be read.
fn refused(module: &str, span: Span, refusal: &str) -> Diagnostic {
    let file = format!("{}.cx", module.replace('.', "/"));
    Diagnostic::error(
        "E0230",
        format!("the module `{module}` cannot be read: {refusal}"),
        span,
        format!("its file is `{file}`"),
    )
    .help("put the file itself into the model's directory, not a link to another location")
}

fn missing(module: &str, span: Span, known: &[String]) -> Diagnostic {
    let diagnostic = Diagnostic::error(
        "E0209",
        format!("there is no module `{module}`"),
        span,
        "neither in the library nor in the folder of this file",
    );
    match crate::check::similar(module, known.iter().map(String::as_str)) {
        Some(near) => {
            diagnostic.help(format!("did you mean `{near}`?")).fix(format!("change to `{near}`"), span, near)
        }
        None if known.is_empty() => {
            diagnostic.help(format!("create `{}.cx` in the folder of this file", module.replace('.', "/")))
        }
        None => diagnostic.help(format!("the library has {}", known.join(", "))),
    }
}
