//! Errors of results directories.

use super::Kind;
use std::fmt;
use std::io;
use std::path::PathBuf;

/// Largest number of files that a message lists.
const NAMED: usize = 4;

/// Reason why results cannot be written to a directory. Its `Display` is one sentence;
/// [`DirectoryError::help`] is the remedy.
#[derive(Debug)]
pub enum DirectoryError {
    /// The directory has files but no marker: they may belong to the user.
    Foreign { path: PathBuf, kind: Kind, files: Vec<String> },
    /// Files that no run wrote have names of results.
    InTheWay { path: PathBuf, files: Vec<String> },
    /// Another process writes to the directory.
    InUse { path: PathBuf, owner: String },
    /// The directory cannot be read or written.
    Io { path: PathBuf, error: io::Error },
}

impl DirectoryError {
    /// Returns the remedy.
    pub fn help(&self) -> &'static str {
        match self {
            DirectoryError::Foreign { .. } => {
                "choose another directory with --out, or write there with --force, which replaces files with names of results and keeps all others"
            }
            DirectoryError::InTheWay { .. } => {
                "move what you want to keep to another place, or replace it with --force"
            }
            DirectoryError::InUse { .. } => "wait until it has ended, or choose another directory with --out",
            DirectoryError::Io { .. } => "choose another directory with --out",
        }
    }
}

impl fmt::Display for DirectoryError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            DirectoryError::Foreign { path, kind, files } => {
                let written_by = match kind {
                    Kind::Run => "a run",
                    Kind::Tradeoff => "`calyx tradeoff`",
                    Kind::Sweep => "`calyx sweep`",
                    Kind::Optimization => "`calyx optimize`",
                    Kind::Sensitivities => "`calyx sensitivities`",
                    Kind::Sound => "`calyx sound`",
                };
                let has = if files.len() == 1 { "a file" } else { "files" };
                write!(f, "{} has {has} that {written_by} did not write: {}", path.display(), names(files))
            }
            DirectoryError::InTheWay { path, files } => {
                let (what, them) = if files.len() == 1 { ("a file", "it") } else { ("files", "them") };
                write!(
                    f,
                    "the results would replace {what} in {} that no run wrote, or be mixed up with {them}: {}",
                    path.display(),
                    names(files)
                )
            }
            DirectoryError::InUse { path, owner } => {
                write!(f, "another run writes to {}: {owner}", path.display())
            }
            DirectoryError::Io { path, error } => {
                write!(f, "cannot write results to {}: {error}", path.display())
            }
        }
    }
}

impl std::error::Error for DirectoryError {}

/// Lists the first names, and the number of the others.
fn names(files: &[String]) -> String {
    let named = files.iter().take(NAMED);
    let mut list: Vec<String> = named.map(|name| name.escape_debug().to_string()).collect();
    if files.len() > NAMED {
        list.push(format!("and {} more", files.len() - NAMED));
    }
    list.join(", ")
}
