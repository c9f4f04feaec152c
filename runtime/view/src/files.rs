//! Files of parts, positions and meshes in a run directory.

use crate::array_file::{UNFINISHED, write_complete};
use crate::content;
use crate::mesh::{self, Meshes};
use calyx_runtime::observables::Fields;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Folder of the files in a run directory.
pub const FOLDER: &str = "view";
/// File of the parts.
pub const PARTS: &str = "parts.bin";
/// Beginning and end of the names of positions.
const POSITION: [&str; 2] = ["position-", ".bin"];

/// Writer of the files of a run.
pub struct ViewFiles {
    folder: PathBuf,
    model: String,
    units: String,
    meshes: Meshes,
    /// True if files of meshes are those of this run and are kept.
    resumed: bool,
}

impl ViewFiles {
    /// Begins in a run directory. The name of the model and its system of units are written into
    /// the file of parts.
    ///
    /// # Errors
    /// The folder cannot be created.
    pub fn begin(directory: &Path, (model, units): (&str, &str)) -> io::Result<ViewFiles> {
        let folder = directory.join(FOLDER);
        fs::create_dir_all(&folder)?;
        let (model, units) = (model.to_owned(), units.to_owned());
        Ok(ViewFiles { folder, model, units, meshes: Meshes::default(), resumed: false })
    }

    /// Continues the files of a run that is resumed.
    ///
    /// # Errors
    /// As for [`ViewFiles::begin`].
    pub fn resume(directory: &Path, model: (&str, &str)) -> io::Result<ViewFiles> {
        Ok(ViewFiles { resumed: true, ..ViewFiles::begin(directory, model)? })
    }

    /// Writes a position with its index and time (s), its meshes that are not written yet, and the
    /// parts if their file is missing.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn write(&mut self, (index, time): (usize, f64), fields: &Fields) -> io::Result<()> {
        let parts = self.folder.join(PARTS);
        if index == 0 || !parts.exists() {
            write_complete(&parts, &content::parts(&fields.parts, (&self.model, &self.units)))?;
        }
        let bytes = content::position((index, time), fields, &mut self.meshes);
        for (name, bytes) in self.meshes.take_new() {
            let path = self.folder.join(name);
            if !(self.resumed && path.exists()) {
                write_complete(&path, &bytes)?;
            }
        }
        write_complete(&self.folder.join(position(index)), &bytes)
    }
}

/// Returns the file name of a position.
fn position(index: usize) -> String {
    format!("{}{index:04}{}", POSITION[0], POSITION[1])
}

/// Returns the names of the files of a position, relative to the run directory, including those
/// that exist while it is being written.
pub fn files_of(index: usize, fields: &Fields) -> impl Iterator<Item = String> {
    let names = [PARTS.to_owned(), position(index)].into_iter().chain(mesh::names(fields));
    names.flat_map(|name| [format!("{FOLDER}/{name}"), format!("{FOLDER}/{name}.{UNFINISHED}")])
}

/// Returns true if a run may write a file of this name into [`FOLDER`].
pub fn is_name_of_a_run(name: &str) -> bool {
    let name = name.strip_suffix(UNFINISHED).and_then(|name| name.strip_suffix('.')).unwrap_or(name);
    name == PARTS || mesh::is_name(name) || index_of(name).is_some()
}

/// Returns the index of a position from the name of its file.
pub fn index_of(name: &str) -> Option<usize> {
    let digits = name.strip_prefix(POSITION[0])?.strip_suffix(POSITION[1])?;
    let index = digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok()).flatten()?;
    (position(index) == name).then_some(index)
}

/// Returns the file names of the positions in a run directory, in order; none without such files.
pub fn positions(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory.join(FOLDER)).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let mut found: Vec<(usize, String)> = names.filter_map(|name| Some((index_of(&name)?, name))).collect();
    found.sort_unstable();
    found.into_iter().map(|(_, name)| name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_are_known() {
        for name in [
            "parts.bin",
            "parts.bin.part",
            "position-0000.bin",
            "position-12345.bin",
            "mesh-0123456789abcdef.bin",
        ] {
            assert!(is_name_of_a_run(name), "{name}");
        }
        for name in [
            "",
            "part",
            "position-1.bin",
            "position-00000.bin",
            "position-+001.bin",
            "notes.txt",
            "mesh-0.bin",
        ] {
            assert!(!is_name_of_a_run(name), "{name}");
        }
        assert!(files_of(10_000, &Fields::default()).all(|name| is_name_of_a_run(&name[FOLDER.len() + 1..])));
        let directory = tempfile::tempdir().unwrap();
        assert!(positions(directory.path()).is_empty());
        let mut files = ViewFiles::begin(directory.path(), ("pair.cx", "mm_N_s")).unwrap();
        for index in [0, 9_999, 10_000, 2] {
            files.write((index, 0.5), &Fields::default()).unwrap();
        }
        let names = ["position-0000.bin", "position-0002.bin", "position-9999.bin", "position-10000.bin"];
        assert_eq!(positions(directory.path()), names);
    }
}
