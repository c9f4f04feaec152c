//! Atomic replacement of user files: after a crash or on a full disk, the file contains either the
//! old or the new text.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::Path;

/// Replaces the text of an existing file, or creates the file. Preserves its permissions, and a
/// symbolic link to it.
///
/// # Errors
/// If the file or its directory cannot be written. The file is unchanged in this case.
pub fn replace(path: &Path, text: &str) -> io::Result<()> {
    let target = match fs::canonicalize(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => path.to_owned(),
        target => target?,
    };
    // A read-only file is not replaced.
    let permissions = match File::options().write(true).open(&target) {
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        file => Some(file?.metadata()?.permissions()),
    };
    let mut name = OsString::from(".");
    name.push(target.file_name().unwrap_or_default());
    name.push(format!(".{}.part", std::process::id()));
    let unfinished = target.with_file_name(name);
    let written = File::create_new(&unfinished).and_then(|mut file| {
        file.write_all(text.as_bytes())?;
        permissions.map_or(Ok(()), |permissions| file.set_permissions(permissions))?;
        file.sync_all()?;
        fs::rename(&unfinished, &target)
    });
    match written {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => Err(error),
        Err(error) => {
            let _ = fs::remove_file(&unfinished);
            Err(error)
        }
        Ok(()) => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::os::unix::fs::{PermissionsExt, symlink};

    #[test]
    fn a_file_is_replaced_with_its_permissions_and_links() {
        let folder = tempfile::tempdir().unwrap();
        let [file, link] = ["pair.cx", "link.cx"].map(|name| folder.path().join(name));
        replace(&file, "new").unwrap();
        fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
        symlink("pair.cx", &link).unwrap();
        replace(&link, "newer").unwrap();
        assert_eq!(fs::read_to_string(&file).unwrap(), "newer");
        assert!(link.symlink_metadata().unwrap().is_symlink());
        assert_eq!(file.metadata().unwrap().permissions().mode() & 0o777, 0o640);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
        // If writing fails, the file is unchanged and no temporary file is left.
        let directory = folder.path().join("directory");
        fs::create_dir(&directory).unwrap();
        assert!(replace(&directory, "text").is_err());
        assert!(replace(&folder.path().join("missing/x.cx"), "text").is_err());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
    }
}
