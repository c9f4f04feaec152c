//! Rename of a symbol in all files.
//!
//! A rename is tried on a copy of the texts. It is refused if it causes a new error or changes the
//! meaning of any name, so that the meaning of the program is preserved.

use super::labels::label_at;
use super::{Edit, Position, Snapshot};
use calyx_lang::analysis::{Name, NameKind, SourceRange, Visible};
use calyx_lang::check::{Checked, Loader, builtin_names};
use calyx_lang::db::Database;
use calyx_lang::diagnostic::Severity;
use calyx_lang::lexer::{Kind, lex};
use calyx_lang::render::line_column;
use calyx_lang::span::{FileId, Span};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// Reason why a symbol cannot be renamed, as a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal(pub String);

type Answer<T> = Result<T, Refusal>;

fn refuse<T>(why: impl Into<String>) -> Answer<T> {
    Err(Refusal(why.into()))
}

/// Symbol to rename.
struct Subject {
    /// Range of the name at the cursor.
    here: Range<u32>,
    name: String,
    /// References by file and position.
    places: Vec<(Arc<str>, Range<u32>)>,
    label: bool,
}

/// Returns range and text of the name at a cursor, if it can be renamed.
///
/// # Errors
/// There is no name, or it does not belong to the user.
pub fn prepare(snapshot: &Snapshot, at: &Position) -> Answer<(Range<u32>, String)> {
    let subject = subject(snapshot, at)?;
    Ok((subject.here, subject.name))
}

/// Returns the edits that rename the symbol at a cursor.
///
/// # Errors
/// The symbol cannot be renamed, or not to this name.
pub fn rename(snapshot: &Snapshot, at: &Position, to: &str) -> Answer<Vec<Edit>> {
    let subject = subject(snapshot, at)?;
    let tokens = lex(FileId(0), to).tokens;
    let whole =
        matches!(tokens.as_slice(), [token] if token.span.start == 0 && token.span.end as usize == to.len());
    let kind = tokens.first().map(|token| token.kind);
    match kind {
        Some(Kind::Identifier) if whole => {}
        Some(_) if whole && to.starts_with(|c: char| c.is_alphabetic()) => {
            return refuse(format!("`{to}` is a word of the language and cannot be a name"));
        }
        _ => {
            return refuse(format!(
                "`{to}` is no name: names are letters, digits and `_`, and begin with no digit"
            ));
        }
    }
    if to == subject.name {
        return Ok(Vec::new());
    }
    let edits: Vec<Edit> = subject
        .places
        .iter()
        .map(|(file, range)| Edit {
            file: file.clone(),
            start: range.start,
            end: range.end,
            replacement: to.into(),
        })
        .collect();
    if subject.label {
        return label_is_free(snapshot, at, to).map(|()| edits);
    }
    let reserved = |known: &Visible| known.kind == NameKind::Constant && *known.name == *to;
    if snapshot.database.visible(&at.file, at.offset).iter().any(reserved) {
        return refuse(format!("`{to}` is reserved and cannot be declared"));
    }
    RenameTrial::new(snapshot, &edits).judge(to)?;
    Ok(edits)
}

fn subject(snapshot: &Snapshot, at: &Position) -> Answer<Subject> {
    let database = &snapshot.database;
    let Some(name) = database.name_at(&at.file, at.offset) else {
        return label(snapshot, at);
    };
    let text = &name.text;
    let Some(place) = &name.declared else {
        return refuse(match name.kind {
            NameKind::Unit => format!("`{text}` is a unit of the language"),
            _ if builtin_names().any(|known| *known == **text) => format!("`{text}` belongs to the language"),
            _ => format!("`{text}` is not declared anywhere"),
        });
    };
    if name.kind == NameKind::Module {
        return refuse(format!("a module is called like its file: rename {}", place.file));
    }
    if place.file.starts_with('<') {
        return refuse(format!("`{text}` is declared in the library, in {}", place.file));
    }
    let mut places: Vec<(Arc<str>, Range<u32>)> =
        database.references(place).into_iter().map(|(file, name)| (file, name.start..name.end)).collect();
    places.sort_by(|a, b| (&a.0, a.1.start).cmp(&(&b.0, b.1.start)));
    places.dedup();
    Ok(Subject { here: name.start..name.end, name: text.to_string(), places, label: false })
}

fn label(snapshot: &Snapshot, at: &Position) -> Answer<Subject> {
    let database = &snapshot.database;
    let nothing = || Refusal("there is no name here that could be changed".into());
    let (Some(tree), Some(text)) = (database.tree(&at.file), database.text(&at.file)) else {
        return Err(nothing());
    };
    let label = label_at(&tree.module, at.offset).ok_or_else(nothing)?;
    let all: Vec<Range<u32>> =
        [label.declared].into_iter().chain(label.jumps).map(|span| span.start..span.end).collect();
    let here = all.iter().find(|range| range.start <= at.offset && at.offset <= range.end).cloned();
    let here = here.ok_or_else(nothing)?;
    let name = text.get(here.start as usize..here.end as usize).unwrap_or_default().to_string();
    let places = all.into_iter().map(|range| (at.file.clone(), range)).collect();
    Ok(Subject { here, name, places, label: true })
}

/// Checks for conflicts of labels, which have their own namespace.
fn label_is_free(snapshot: &Snapshot, at: &Position, to: &str) -> Answer<()> {
    let database = &snapshot.database;
    let (Some(tokens), Some(text)) = (database.tokens(&at.file), database.text(&at.file)) else {
        return Ok(());
    };
    let word = |index: usize| {
        tokens
            .tokens
            .get(index)
            .and_then(|token| text.get(token.span.start as usize..token.span.end as usize))
    };
    let taken = (0..tokens.tokens.len()).any(|index| {
        let is_label = tokens.tokens.get(index + 1).is_some_and(|token| token.kind == Kind::Colon);
        word(index) == Some(to) && is_label
    });
    if taken { refuse(format!("there is a label `{to}` already")) } else { Ok(()) }
}

/// Texts before and after the rename.
struct RenameTrial<'a> {
    before: &'a Database,
    after: Database,
    models: Vec<String>,
    files: BTreeSet<Arc<str>>,
    edits: BTreeMap<&'a str, Vec<&'a Edit>>,
}

impl<'a> RenameTrial<'a> {
    fn new(snapshot: &'a Snapshot, edits: &'a [Edit]) -> RenameTrial<'a> {
        let before = &snapshot.database;
        let mut by_file: BTreeMap<&str, Vec<&Edit>> = BTreeMap::new();
        for edit in edits {
            by_file.entry(&edit.file).or_default().push(edit);
        }
        by_file.values_mut().for_each(|edits| edits.sort_by_key(|edit| edit.start));
        let texts = Texts { before, edits: &by_file };
        let mut after = Database::new(&texts);
        let touched = |model: &&str| {
            by_file.contains_key(*model)
                || before.imported(model).iter().any(|file| by_file.contains_key(&**file))
        };
        let models: Vec<String> = before.models().filter(touched).map(str::to_string).collect();
        let mut files = BTreeSet::new();
        for model in &models {
            after.set_model(model, &texts.of(model).unwrap_or_default());
            after.load_imports(model, &texts);
            files.insert(Arc::from(model.as_str()));
            files.extend(before.imported(model));
        }
        RenameTrial { before, after, models, files, edits: by_file }
    }

    /// Maps an offset in the texts before to the texts after the edits.
    fn moved(&self, file: &str, offset: u32) -> u32 {
        let before = self.edits.get(file).into_iter().flatten().take_while(|edit| edit.start < offset);
        let by: i64 =
            before.map(|edit| edit.replacement.len() as i64 - i64::from(edit.end - edit.start)).sum();
        u32::try_from(i64::from(offset) + by).unwrap_or(offset)
    }

    /// Checks that the meaning of the program is preserved.
    fn judge(&self, to: &str) -> Answer<()> {
        let error =
            |message: String| Refusal(format!("with the name `{to}` there would be an error: {message}"));
        // For a name conflict, the compiler's message is the most specific one.
        if let Some(message) = self.new_error(&|code| matches!(code, "E0202" | "E0203")) {
            return Err(error(message));
        }
        for file in self.files.iter().filter(|file| !file.starts_with('<')) {
            let after: BTreeMap<u32, Name> = self
                .after
                .aside(|after| after.names(file))
                .into_iter()
                .map(|name| (name.start, name))
                .collect();
            for name in self.before.names(file) {
                let found = after.get(&self.moved(file, name.start));
                let same =
                    found.is_some_and(|found| self.is_same(name.declared.as_ref(), found.declared.as_ref()));
                if !same {
                    return refuse(self.clash(to, file, &name, found));
                }
            }
        }
        match self.new_error(&|_| true) {
            Some(message) => Err(error(message)),
            None => Ok(()),
        }
    }

    /// Returns the message of a new error.
    fn new_error(&self, of_interest: &dyn Fn(&str) -> bool) -> Option<String> {
        for model in &self.models {
            let (Some(old), Some(new)) =
                (self.before.check(model), self.after.aside(|after| after.check(model)))
            else {
                continue;
            };
            let errors = |checked: &Checked| -> Vec<(String, String, u32, String)> {
                let each = checked.diagnostics.iter();
                let each = each.filter(|d| d.severity == Severity::Error && of_interest(&d.code));
                let placed = each.map(|d| {
                    let Span { file, start, .. } = d.primary.span;
                    let file = checked.files.get(file.0 as usize).map_or("", |file| file.name.as_str());
                    (d.code.clone(), file.to_string(), start, d.message.clone())
                });
                placed.collect()
            };
            let mut known = errors(&old);
            for (code, file, start, message) in errors(&new) {
                let before = |(c, f, s, _): &(String, String, u32, String)| {
                    *c == code && *f == file && self.moved(f, *s) == start
                };
                match known.iter().position(before) {
                    Some(index) => {
                        known.swap_remove(index);
                    }
                    None => return Some(message),
                }
            }
        }
        None
    }

    fn is_same(&self, before: Option<&SourceRange>, after: Option<&SourceRange>) -> bool {
        match (before, after) {
            (None, None) => true,
            (Some(before), Some(after)) => {
                before.file == after.file && self.moved(&before.file, before.start) == after.start
            }
            _ => false,
        }
    }

    fn clash(&self, to: &str, file: &str, name: &Name, found: Option<&Name>) -> String {
        let text = self.before.text(file).unwrap_or_default();
        let (line, _) = line_column(text, name.start as usize);
        // Either another declaration captures a renamed use, or the renamed declaration captures
        // another use.
        match found {
            Some(other) if *other.text == *to && *name.text != *to => {
                format!("`{to}` means something else in line {line} of {file}")
            }
            _ => format!(
                "`{to}` is used for something else in line {line} of {file}, which would mean this then"
            ),
        }
    }
}

/// Texts after the edits, as a loader of the database.
struct Texts<'a> {
    before: &'a Database,
    edits: &'a BTreeMap<&'a str, Vec<&'a Edit>>,
}

impl Texts<'_> {
    fn of(&self, file: &str) -> Option<String> {
        let mut text = self.before.text(file)?.to_string();
        for edit in self.edits.get(file).into_iter().flatten().rev() {
            let range = edit.start as usize..edit.end as usize;
            if text.get(range.clone()).is_some() {
                text.replace_range(range, &edit.replacement);
            }
        }
        Some(text)
    }
}

impl Loader for Texts<'_> {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let file = self.before.file_of(&path.join("."))?;
        Some((file.to_string(), self.of(&file)?))
    }

    fn prelude(&self) -> (String, String) {
        let is_prelude = |file: &Arc<str>| self.before.module_of(file).as_deref() == Some("prelude");
        let file = self.before.files().into_iter().find(is_prelude);
        let text = file.as_deref().and_then(|file| self.of(file)).unwrap_or_default();
        (file.map(|file| file.to_string()).unwrap_or_default(), text)
    }

    fn names(&self) -> Vec<String> {
        self.before.modules()
    }
}
