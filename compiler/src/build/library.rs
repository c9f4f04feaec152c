//! Finds the static library of `calyx-rt` that executables are linked with.
//!
//! The library must be of the same version: its engine fingerprint is compared before linking.
//! Cargo leaves the library in `deps/` next to an executable that it builds, under a name with a
//! hash, together with those of earlier builds and of builds with other features. The newest
//! library that matches is used. Executables require one with the feature `command`.

use super::error::{BuildError, WrongLibrary};
use calyx_abi::Fingerprint;
use calyx_gears::library::FINGERPRINT;
use etcetera::BaseStrategy;
use object::read::archive::ArchiveFile;
use object::{Object, ObjectSection, ObjectSymbol, ReadCache, ReadRef};
use std::ffi::OsStr;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Environment variable with a library that is used instead of those in [`places`].
pub const VARIABLE: &str = "CALYX_RT_LIBRARY";

/// Symbol of the fingerprint.
const FINGERPRINT_SYMBOL: &str = "CALYX_RT_ABI";
/// Function that `main` of an executable calls.
const COMMAND_SYMBOL: &str = "calyx_rt_main";

/// Finds the library that matches this compiler: the given one, else the one that [`VARIABLE`]
/// names, else the first match in [`places`].
///
/// # Errors
/// If there is none, or the named library does not match.
pub fn find(given: Option<&Path>, needs: Needs) -> Result<PathBuf, BuildError> {
    if let Some(path) = given.map(Path::to_owned).or(named()) {
        check(&path, needs)?;
        return Ok(path);
    }
    find_in(&places(), needs)
}

/// Purpose of a library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// Programs of the user: the C interface.
    Interface,
    /// Executables: the command line too.
    Command,
}

/// Returns true if [`VARIABLE`] names a library.
pub fn is_named() -> bool {
    named().is_some()
}

fn named() -> Option<PathBuf> {
    std::env::var_os(VARIABLE).filter(|name| !name.is_empty()).map(PathBuf::from)
}

/// Returns the directories that are searched, in order: that of the running executable together
/// with its subdirectory `deps`, of which the newest library is used, then `../lib/calyx`, then
/// `calyx` in the user's data directory.
pub fn places() -> Vec<Vec<PathBuf>> {
    let mut places = Vec::new();
    let executable = std::env::current_exe().and_then(|path| path.canonicalize());
    if let Some(beside) = executable.ok().as_deref().and_then(Path::parent) {
        places.push(vec![beside.to_owned(), beside.join("deps")]);
        places.extend(beside.parent().map(|prefix| vec![prefix.join("lib/calyx")]));
    }
    if let Ok(strategy) = etcetera::choose_base_strategy() {
        places.push(vec![strategy.data_dir().join("calyx")]);
    }
    places
}

fn find_in(places: &[Vec<PathBuf>], needs: Needs) -> Result<PathBuf, BuildError> {
    let mut unfit = None;
    for directories in places {
        for path in libraries(directories) {
            match check(&path, needs) {
                Ok(()) => return Ok(path),
                Err(error) => unfit = unfit.or(Some(error)),
            }
        }
    }
    Err(unfit.unwrap_or_else(|| BuildError::NoLibrary { searched: places.concat() }))
}

/// Returns the libraries in directories, the newest first.
fn libraries(directories: &[PathBuf]) -> Vec<PathBuf> {
    let entries = directories.iter().flat_map(fs::read_dir).flatten().flatten();
    let mut found: Vec<(SystemTime, PathBuf)> = entries
        .filter(|entry| is_library(&entry.file_name()))
        .filter_map(|entry| Some((entry.metadata().ok()?.modified().ok()?, entry.path())))
        .collect();
    found.sort_by(|one, other| other.cmp(one));
    found.into_iter().map(|(_, path)| path).collect()
}

/// Matches `libcalyx_rt.a`, and cargo's name for a dependency, `libcalyx_rt-0123456789abcdef.a`.
fn is_library(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    let middle = name.strip_prefix("libcalyx_rt").and_then(|rest| rest.strip_suffix(".a"));
    middle.is_some_and(|middle| middle.is_empty() || middle.starts_with('-'))
}

/// Checks that a library is of this version and has the required functions.
fn check(path: &Path, needs: Needs) -> Result<(), BuildError> {
    let wrong = |why| Err(BuildError::WrongLibrary { path: path.into(), why });
    match read(path) {
        Ok(Some((FINGERPRINT, false))) if needs == Needs::Command => wrong(WrongLibrary::NoCommand),
        Ok(Some((FINGERPRINT, _))) => Ok(()),
        Ok(Some((found, _))) => wrong(WrongLibrary::Version(found)),
        Ok(None) => wrong(WrongLibrary::Foreign),
        Err(error) => wrong(WrongLibrary::Unreadable(error)),
    }
}

/// Returns the fingerprint of a static library, and true if it has the command line of executables;
/// `None` if it has no fingerprint. Reads only the necessary part of the file: libraries with
/// debugging information have a hundred megabytes.
fn read(path: &Path) -> Result<Option<(Fingerprint, bool)>, String> {
    let cache = ReadCache::new(File::open(path).map_err(|error| error.to_string())?);
    read_symbols(&cache).map_err(|error| error.to_string())
}

fn read_symbols<'data, R: ReadRef<'data>>(data: R) -> object::Result<Option<(Fingerprint, bool)>> {
    let archive = ArchiveFile::parse(data)?;
    let Some(symbols) = archive.symbols()? else { return Ok(None) };
    // Names begin with an underscore on some systems.
    let is = |name: &[u8], symbol: &str| name.strip_prefix(b"_").unwrap_or(name) == symbol.as_bytes();
    let is_it = |name: &[u8]| is(name, FINGERPRINT_SYMBOL);
    let (mut found_in, mut command) = (Vec::new(), false);
    for symbol in symbols {
        let symbol = symbol?;
        command |= is(symbol.name(), COMMAND_SYMBOL);
        if is_it(symbol.name()) {
            found_in.push(symbol);
        }
    }
    for symbol in found_in {
        let file = object::File::parse(archive.member(symbol.offset())?.data(data)?)?;
        let found =
            file.symbols().find(|symbol| symbol.name_bytes().is_ok_and(is_it) && symbol.is_definition());
        let Some(found) = found else { continue };
        let Some(section) = found.section_index() else { continue };
        let bytes = file.section_by_index(section)?.data_range(found.address(), 8)?;
        if let Some(bytes) = bytes.and_then(|bytes| bytes.try_into().ok()) {
            let number =
                if file.is_little_endian() { u64::from_le_bytes(bytes) } else { u64::from_be_bytes(bytes) };
            return Ok(Some((Fingerprint(number), command)));
        }
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn libraries_are_known_by_their_names() {
        let table = [
            ("libcalyx_rt.a", true),
            ("libcalyx_rt-2339a858d94f0a66.a", true),
            ("libcalyx_rt.rlib", false),
            ("libcalyx_rtt.a", false),
            ("libcalyx_runtime-1.a", false),
        ];
        for (name, expected) in table {
            assert_eq!(is_library(OsStr::new(name)), expected, "{name}");
        }
    }

    #[test]
    fn what_does_not_fit_is_told_from_what_is_not_there() {
        let directory = tempfile::tempdir().unwrap();
        let places = [vec![directory.path().to_owned()]];
        let missing = find_in(&places, Needs::Command).unwrap_err();
        assert!(matches!(missing, BuildError::NoLibrary { .. }), "{missing}");
        assert!(missing.help().contains("cargo build --release -p calyx-rt"), "{}", missing.help());
        fs::write(directory.path().join("libcalyx_rt.a"), "not an archive").unwrap();
        let damaged = find_in(&places, Needs::Command).unwrap_err();
        assert!(damaged.to_string().contains("cannot be read"), "{damaged}");
        fs::write(directory.path().join("libcalyx_rt.a"), "!<arch>\n").unwrap();
        let foreign = find_in(&places, Needs::Command).unwrap_err();
        assert!(foreign.to_string().contains("is not Calyx's runtime library"), "{foreign}");
    }

    /// Creates a library of this version with the symbols that [`check`] requires.
    fn library(directory: &Path, name: &str, with_command: bool) -> PathBuf {
        let source = directory.join(format!("{name}.c"));
        let command = if with_command { "int calyx_rt_main(void) { return 0; }" } else { "" };
        let text = format!("const unsigned long long CALYX_RT_ABI = {}ull;\n{command}\n", FINGERPRINT.0);
        fs::write(&source, text).unwrap();
        let object = source.with_extension("o");
        let done =
            |command: &mut std::process::Command| assert!(command.status().expect("it starts").success());
        done(std::process::Command::new("cc").arg("-c").arg(&source).arg("-o").arg(&object));
        let archive = directory.join(format!("lib{name}.a"));
        done(std::process::Command::new("ar").arg("rcs").arg(&archive).arg(&object));
        archive
    }

    #[test]
    fn executables_get_a_library_with_a_command_line_though_a_newer_one_has_none() {
        let directory = tempfile::tempdir().unwrap();
        let places = [vec![directory.path().to_owned()]];
        let older = library(directory.path(), "calyx_rt-1", true);
        let newer = library(directory.path(), "calyx_rt-2", false);
        let age = |path: &Path, seconds| {
            let time = SystemTime::now() - std::time::Duration::from_secs(seconds);
            File::options().append(true).open(path).unwrap().set_modified(time).unwrap();
        };
        age(&older, 100);
        age(&newer, 10);
        assert_eq!(find_in(&places, Needs::Command).unwrap(), older);
        assert_eq!(find_in(&places, Needs::Interface).unwrap(), newer);
        fs::remove_file(&older).unwrap();
        let error = find_in(&places, Needs::Command).unwrap_err();
        assert!(error.to_string().contains("has no command line for executables"), "{error}");
    }
}
