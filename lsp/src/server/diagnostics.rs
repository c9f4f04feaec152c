//! Publishes diagnostics after every change, on a separate thread.
//!
//! Checks never delay edits: a newer edit cancels a check, which restarts with the newer text.

use super::Shared;
use super::background::Background;
use super::job::{isolated, reason};
use super::view::View;
use super::workspace::{Changed, Key};
use calyx_lang::check::Checked;
use calyx_lang::db::Superseded;
use calyx_lang::diagnostic::{Diagnostic as Finding, Severity};
use calyx_lang::ir::SourceFile;
use calyx_lang::span::Span;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use tokio::runtime::Handle;
use tower_lsp_server::Client;
use tower_lsp_server::ls_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, NumberOrString, Uri,
};

/// Signal that wakes the thread.
#[derive(Default)]
pub(crate) struct PublishSignal {
    state: Mutex<SignalState>,
    roused: Condvar,
}

#[derive(Clone, Copy, Default, PartialEq, Eq)]
enum SignalState {
    #[default]
    Asleep,
    Roused,
    Stopped,
}

impl PublishSignal {
    pub fn wake(&self) {
        self.set(SignalState::Roused);
    }

    /// Stops the thread.
    pub fn stop(&self) {
        self.set(SignalState::Stopped);
    }

    fn set(&self, to: SignalState) {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if *state != SignalState::Stopped {
            *state = to;
        }
        self.roused.notify_all();
    }

    /// Waits for a change; returns false at shutdown.
    fn wait(&self) -> bool {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        while *state == SignalState::Asleep {
            state = self.roused.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        let goes_on = *state == SignalState::Roused;
        if goes_on {
            *state = SignalState::Asleep;
        }
        goes_on
    }
}

/// Starts the thread that publishes diagnostics.
pub(crate) fn start(shared: Arc<Shared>, client: Client, runtime: Handle) -> io::Result<()> {
    thread::Builder::new().name("diagnostics".to_owned()).spawn(move || {
        let mut publisher = Publisher { shared: &shared, client, runtime, shown: BTreeMap::new() };
        let mut kept = VecDeque::new();
        while shared.wake.wait() {
            // One project at a time: a waiting view would block edits of its project.
            let log = &shared.log;
            let next = || isolated(log, "choosing a project", || shared.workspace().next_changed());
            while let Some(changed) = next().flatten() {
                let published = isolated(log, "publishing diagnostics", || publisher.publish(changed));
                kept.push_back(published.unwrap_or_default());
                if kept.len() > KEPT {
                    kept.pop_front();
                }
            }
        }
    })?;
    Ok(())
}

/// Number of retained checked programs. They are large, and the database releases an old one when a
/// text changes, while the client waits. Retained programs are dropped later, on this thread.
const KEPT: usize = 2;

/// Publisher of diagnostics, with a record of the published ones.
struct Publisher<'a> {
    shared: &'a Shared,
    client: Client,
    runtime: Handle,
    /// Files with published diagnostics, by project.
    shown: BTreeMap<Key, BTreeSet<Uri>>,
}

impl Publisher<'_> {
    /// Checks a project and publishes its diagnostics. Returns the checked programs.
    fn publish(&mut self, changed: Changed) -> Vec<Arc<Checked>> {
        let view = match changed {
            Changed::Project(view) => view,
            Changed::Gone(home) => {
                for uri in self.shown.remove(&home).unwrap_or_default() {
                    self.send(uri, None, Vec::new());
                }
                return Vec::new();
            }
        };
        let home = view.project.clone();
        let mut kept = Vec::new();
        let checked =
            catch_unwind(AssertUnwindSafe(|| of_project(&view, &self.shared.background, &mut kept)));
        // Views must be released before a message is sent or the workspace is locked.
        drop(view);
        match checked {
            Ok(Ok(found)) => {
                let speaks = |(uri, (_, found)): (&Uri, &(Option<i32>, Vec<Diagnostic>))| {
                    (!found.is_empty()).then(|| uri.clone())
                };
                let now = found.iter().filter_map(speaks).collect();
                let before = self.shown.insert(home.clone(), now).unwrap_or_default();
                for uri in before.into_iter().filter(|uri| !found.contains_key(uri)) {
                    self.send(uri, None, Vec::new());
                }
                for (uri, (version, found)) in found {
                    self.send(uri, version, found);
                }
                self.remember(&home);
            }
            // Retried immediately, with the newer text.
            Ok(Err(Superseded)) => self.shared.workspace().mark_dirty(&home),
            Err(panic) => self.shared.log.error(&format!("checking failed: {}", reason(&*panic))),
        }
        kept
    }

    fn send(&self, uri: Uri, version: Option<i32>, found: Vec<Diagnostic>) {
        self.runtime.block_on(self.client.publish_diagnostics(uri, found, version));
    }

    /// Records the types of declarations in open files, for completion in texts that are newer than
    /// the last check.
    fn remember(&self, home: &Key) {
        let views = self.shared.workspace().views();
        let Some(view) = views.into_iter().find(|view| view.project == *home) else { return };
        // A change that supersedes this check triggers a new one, which records the types.
        let noted = catch_unwind(AssertUnwindSafe(|| {
            view.snapshot.database.attempt(|database| {
                let own = view.documents.values().filter(|document| document.home == view.project);
                own.for_each(|document| database.remember(&document.name));
            })
        }));
        drop(view);
        if let Err(panic) = noted {
            self.shared.log.error(&format!("noting types failed: {}", reason(&*panic)));
        }
    }
}

/// Findings by file, with the version of the document.
type Found = BTreeMap<Uri, (Option<i32>, Vec<Diagnostic>)>;

/// Returns the findings in the files of a project; open files are included even without findings.
/// Submits models with a new program for elaboration. Appends the checked programs to `kept`.
fn of_project(
    view: &View,
    background: &Background,
    kept: &mut Vec<Arc<Checked>>,
) -> Result<Found, Superseded> {
    let all = view.snapshot.database.attempt(|database| {
        let checked = view.models.iter().filter_map(|model| Some((model.clone(), database.check(model)?)));
        let checked: Vec<(Arc<str>, Arc<Checked>)> = checked.collect();
        let carried = view.snapshot.elaborated.values();
        let carried: Vec<_> = carried.map(|known| (known.clone(), known.found(database))).collect();
        (checked, carried)
    });
    let (checked, carried) = all?;
    let mut findings = Findings::new(view);
    for (model, checked) in &checked {
        findings.add(&checked.files, &checked.diagnostics);
        // A model that only imports a module describes no gears.
        if view.file(model).is_some() {
            background.submit(&view.project, model, checked, view.snapshot.elaborated.get(model));
        }
    }
    for (known, found) in &carried {
        findings.add(known.files(), found);
    }
    kept.extend(checked.into_iter().map(|(_, checked)| checked));
    Ok(findings.found)
}

/// Findings during collection.
struct Findings<'a> {
    view: &'a View,
    found: Found,
    /// Findings so far: a module has the same findings in all models that import it.
    seen: BTreeSet<(String, u32, u32, String, String)>,
}

impl<'a> Findings<'a> {
    fn new(view: &'a View) -> Findings<'a> {
        let open = view.documents.iter().filter(|(_, document)| document.home == view.project);
        let found = open.map(|(uri, document)| (uri.clone(), (Some(document.version), Vec::new()))).collect();
        Findings { view, found, seen: BTreeSet::new() }
    }

    fn add(&mut self, files: &[SourceFile], findings: &[Finding]) {
        let view = self.view;
        for finding in findings {
            let span = finding.primary.span;
            let Some(file) = source(files, span) else { continue };
            // Findings in the library cannot be fixed by the user.
            if view.file(&file.name).is_none_or(|file| file.of_library) {
                continue;
            }
            let key =
                (file.name.clone(), span.start, span.end, finding.code.clone(), finding.message.clone());
            if !self.seen.insert(key) {
                continue;
            }
            if let (Some(uri), Some(diagnostic)) = (view.uri(&file.name), to_protocol(view, files, finding)) {
                let version = view.version(&uri);
                self.found.entry(uri).or_insert_with(|| (version, Vec::new())).1.push(diagnostic);
            }
        }
    }
}

fn source(files: &[SourceFile], span: Span) -> Option<&SourceFile> {
    files.get(span.file.0 as usize)
}

/// Converts a finding; `None` if its file is not part of the project.
pub fn to_protocol(view: &View, files: &[SourceFile], finding: &Finding) -> Option<Diagnostic> {
    let span = finding.primary.span;
    let file = source(files, span)?;
    let mut message = finding.message.clone();
    if !finding.primary.message.is_empty() {
        message += &format!("\n{}", finding.primary.message);
    }
    if let Some(help) = &finding.help {
        message += &format!("\nhelp: {help}");
    }
    let mut related = Vec::new();
    for label in &finding.labels {
        let Some(file) = source(files, label.span) else { continue };
        let Some(location) = view.location(&file.name, label.span.start..label.span.end) else { continue };
        if view.client.related_information {
            related.push(DiagnosticRelatedInformation { location, message: label.message.clone() });
        } else {
            message += &format!("\nline {}: {}", location.range.start.line + 1, label.message);
        }
    }
    let severity = match finding.severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
    };
    Some(Diagnostic {
        range: view.range(&file.name, span.start..span.end)?,
        severity: Some(severity),
        code: Some(NumberOrString::String(finding.code.clone())),
        source: Some("calyx".to_owned()),
        message,
        related_information: (!related.is_empty()).then_some(related),
        tags: tag(&finding.code).map(|tag| vec![tag]),
        data: fix(view, files, finding),
        ..Diagnostic::default()
    })
}

/// Returns the tag of unused names, unreachable statements and unused values, which editors fade
/// out, and of former names, which editors strike through.
fn tag(code: &str) -> Option<DiagnosticTag> {
    match code {
        "W0201" | "W0202" | "W0203" => Some(DiagnosticTag::UNNECESSARY),
        "W0840" => Some(DiagnosticTag::DEPRECATED),
        _ => None,
    }
}

/// Returns the fix of a finding as data that clients send back.
fn fix(view: &View, files: &[SourceFile], finding: &Finding) -> Option<serde_json::Value> {
    let fix = finding.fix.as_ref()?;
    let location = view.location(&source(files, fix.span)?.name, fix.span.start..fix.span.end)?;
    Some(
        serde_json::json!({ "title": fix.title, "uri": location.uri, "range": location.range, "newText": fix.replacement }),
    )
}
