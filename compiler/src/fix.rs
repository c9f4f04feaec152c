//! Applies the machine-applicable fixes of diagnostics to the files of a model.

use crate::replace::replace;
use calyx_elaborate::{Checked, check_file_allowing};
use calyx_lang::diagnostic::{Diagnostic, Fix};
use calyx_lang::ir::SourceFile;
use calyx_lang::render::line_column;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Largest number of checks after fixes: a fixed error may reveal another one.
const MOST_ROUNDS: usize = 20;

/// Applied change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Applied {
    /// File, line and column (from 1) before the change.
    pub file: String,
    pub line: usize,
    pub column: usize,
    /// Code of the diagnostic that the change fixes.
    pub code: String,
    pub title: String,
}

/// Model after all applicable fixes.
pub struct Fixed {
    pub applied: Vec<Applied>,
    pub checked: Checked,
}

/// Checks the model in a file, applies the machine-applicable fixes to the file and to the modules
/// in its directory, and repeats until no fix is left. Files that are `allowed` outside of the
/// model's directory are read and not changed.
///
/// # Errors
/// If a file cannot be read or written.
pub fn fix_file(path: &Path, allowed: &Arc<[PathBuf]>) -> io::Result<Fixed> {
    let mut applied = Vec::new();
    for _ in 0..MOST_ROUNDS {
        let checked = check_file_allowing(path, allowed)?;
        let mut diagnostics = checked.diagnostics.clone();
        diagnostics.retain(|found| {
            let file = checked.files.get(found.primary.span.file.0 as usize);
            found.primary.span.file.0 == 0 || file.is_some_and(|file| is_beside(path, Path::new(&file.name)))
        });
        let (changes, texts) = changes(&diagnostics, &checked.files);
        if changes.is_empty() {
            return Ok(Fixed { applied, checked });
        }
        for (file, text) in texts {
            // The model is written to the path it was read from, whatever its shown name; modules
            // are shown by their path.
            let target = if file == 0 { path } else { Path::new(&checked.files[file].name) };
            replace(target, &text)?;
        }
        applied.extend(changes);
    }
    Ok(Fixed { applied, checked: check_file_allowing(path, allowed)? })
}

/// Returns true if a module is in the directory of the model, after resolving links.
fn is_beside(model: &Path, module: &Path) -> bool {
    let folder = model.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    match (folder.canonicalize(), module.canonicalize()) {
        (Ok(folder), Ok(module)) => module.starts_with(folder),
        _ => false,
    }
}

/// Returns the fixes that can be applied together, sorted by location, and the resulting texts by
/// file index.
fn changes(diagnostics: &[Diagnostic], files: &[SourceFile]) -> (Vec<Applied>, BTreeMap<usize, String>) {
    let mut fixes: Vec<(&str, &Fix)> =
        diagnostics.iter().filter_map(|d| Some((d.code.as_str(), d.fix.as_ref()?))).collect();
    fixes.sort_by_key(|(_, fix)| (fix.span.file, fix.span.start, fix.span.end));
    let (mut applied, mut texts) = (Vec::new(), BTreeMap::new());
    let mut ends: BTreeMap<usize, usize> = BTreeMap::new();
    let mut accepted: Vec<&Fix> = Vec::new();
    for (code, fix) in fixes {
        let file = fix.span.file.0 as usize;
        let (start, end) = (fix.span.start as usize, fix.span.end as usize);
        let Some(source) = files.get(file) else { continue };
        // Library files are part of Calyx and not changed. Of overlapping fixes the first is
        // applied; the next check finds the others again if they still apply.
        let own = !source.name.starts_with('<');
        let free = ends.get(&file).is_none_or(|last| start > *last || (start == *last && start < end));
        if !own || !free || source.text.get(start..end).is_none_or(|old| old == fix.replacement) {
            continue;
        }
        ends.insert(file, end);
        accepted.push(fix);
        let (line, column) = line_column(&source.text, start);
        let place =
            Applied { file: source.name.clone(), line, column, code: code.into(), title: fix.title.clone() };
        applied.push(place);
    }
    // In reverse order, so that earlier offsets stay valid.
    for fix in accepted.into_iter().rev() {
        let file = fix.span.file.0 as usize;
        let text = texts.entry(file).or_insert_with(|| files[file].text.clone());
        text.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.replacement);
    }
    (applied, texts)
}
