//! Static libraries with a model and the runtime: the runtime's library with one more member.

use super::BuildError;
use super::error::WrongLibrary;
use ar_archive_writer::{ArchiveKind, DEFAULT_OBJECT_READER, NewArchiveMember, write_archive_to_stream};
use object::read::archive::ArchiveFile;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;

/// Copies a library to `target`, with an object file as its first member, where linkers search
/// first.
pub(super) fn with_member(
    library: &Path,
    name: &str,
    object: &[u8],
    target: &Path,
) -> Result<(), BuildError> {
    let unreadable = |error: String| BuildError::WrongLibrary {
        path: library.into(),
        why: WrongLibrary::Unreadable(error),
    };
    let bytes = fs::read(library).map_err(|error| unreadable(error.to_string()))?;
    let archive = ArchiveFile::parse(&*bytes).map_err(|error| unreadable(error.to_string()))?;
    let mut members = vec![NewArchiveMember::new(object, &DEFAULT_OBJECT_READER, name.to_owned())];
    for member in archive.members() {
        let member = member.map_err(|error| unreadable(error.to_string()))?;
        let data = member.data(&*bytes).map_err(|error| unreadable(error.to_string()))?;
        let name = String::from_utf8_lossy(member.name()).into_owned();
        members.push(NewArchiveMember::new(data, &DEFAULT_OBJECT_READER, name));
    }
    let kind = if cfg!(target_vendor = "apple") { ArchiveKind::Darwin } else { ArchiveKind::Gnu };
    let write = || {
        let mut file = BufWriter::new(File::create(target)?);
        write_archive_to_stream(&mut file, &members, kind, false, Some(false))?;
        file.flush()
    };
    write().map_err(|error| BuildError::unwritable(target, error))
}
