//! Finds the static library of `calyx-rt` that executables are linked with.
//!
//! It must be of this very version: the engine's fingerprint in it is read and compared before anything is linked. Cargo leaves
//! the library in `deps/` beside an executable that it builds, under a name with a hash, together with those of earlier builds;
//! the newest that fits is taken.

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

/// Names a library that is to be used instead of those in [`places`].
pub const VARIABLE: &str = "CALYX_RT_LIBRARY";

/// The symbol that holds the fingerprint.
const FINGERPRINT_SYMBOL: &str = "CALYX_RT_ABI";

/// The library that fits this compiler: the one given, else the one that [`VARIABLE`] names, else the first that fits in
/// [`places`].
///
/// # Errors
/// There is none, or the one that was named does not fit.
pub fn find(given: Option<&Path>) -> Result<PathBuf, BuildError> {
    let named = std::env::var_os(VARIABLE).filter(|name| !name.is_empty()).map(PathBuf::from);
    if let Some(path) = given.map(Path::to_owned).or(named) {
        check(&path)?;
        return Ok(path);
    }
    find_in(&places())
}

/// The directories that are searched, in this order: that of the running executable and `deps` beside it, where the newer of
/// two libraries counts, then `../lib/calyx`, then `calyx` in the user's data directory.
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

fn find_in(places: &[Vec<PathBuf>]) -> Result<PathBuf, BuildError> {
    let mut unfit = None;
    for directories in places {
        for path in libraries(directories) {
            match check(&path) {
                Ok(()) => return Ok(path),
                Err(error) => unfit = unfit.or(Some(error)),
            }
        }
    }
    Err(unfit.unwrap_or_else(|| BuildError::NoLibrary { searched: places.concat() }))
}

/// The libraries in directories, the newest first.
fn libraries(directories: &[PathBuf]) -> Vec<PathBuf> {
    let entries = directories.iter().flat_map(fs::read_dir).flatten().flatten();
    let mut found: Vec<(SystemTime, PathBuf)> = entries
        .filter(|entry| is_library(&entry.file_name()))
        .filter_map(|entry| Some((entry.metadata().ok()?.modified().ok()?, entry.path())))
        .collect();
    found.sort_by(|one, other| other.cmp(one));
    found.into_iter().map(|(_, path)| path).collect()
}

/// `libcalyx_rt.a`, or as cargo names it among dependencies, `libcalyx_rt-0123456789abcdef.a`.
fn is_library(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    let middle = name.strip_prefix("libcalyx_rt").and_then(|rest| rest.strip_suffix(".a"));
    middle.is_some_and(|middle| middle.is_empty() || middle.starts_with('-'))
}

/// Whether a library is of this version.
fn check(path: &Path) -> Result<(), BuildError> {
    let wrong = |why| Err(BuildError::WrongLibrary { path: path.into(), why });
    match fingerprint(path) {
        Ok(Some(found)) if found == FINGERPRINT => Ok(()),
        Ok(Some(found)) => wrong(WrongLibrary::Version(found)),
        Ok(None) => wrong(WrongLibrary::Foreign),
        Err(error) => wrong(WrongLibrary::Unreadable(error)),
    }
}

/// The fingerprint in a static library; `None` if it holds none. Reads no more of the file than it must: libraries with
/// debugging information take a hundred megabytes.
fn fingerprint(path: &Path) -> Result<Option<Fingerprint>, String> {
    let cache = ReadCache::new(File::open(path).map_err(|error| error.to_string())?);
    read_fingerprint(&cache).map_err(|error| error.to_string())
}

fn read_fingerprint<'data, R: ReadRef<'data>>(data: R) -> object::Result<Option<Fingerprint>> {
    let archive = ArchiveFile::parse(data)?;
    let Some(symbols) = archive.symbols()? else { return Ok(None) };
    // Names begin with an underscore on some systems.
    let is_it = |name: &[u8]| name.strip_prefix(b"_").unwrap_or(name) == FINGERPRINT_SYMBOL.as_bytes();
    for symbol in symbols {
        let symbol = symbol?;
        if !is_it(symbol.name()) {
            continue;
        }
        let file = object::File::parse(archive.member(symbol.offset())?.data(data)?)?;
        let found =
            file.symbols().find(|symbol| symbol.name_bytes().is_ok_and(is_it) && symbol.is_definition());
        let Some(found) = found else { continue };
        let Some(section) = found.section_index() else { continue };
        let bytes = file.section_by_index(section)?.data_range(found.address(), 8)?;
        if let Some(bytes) = bytes.and_then(|bytes| bytes.try_into().ok()) {
            let number =
                if file.is_little_endian() { u64::from_le_bytes(bytes) } else { u64::from_be_bytes(bytes) };
            return Ok(Some(Fingerprint(number)));
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
        let missing = find_in(&places).unwrap_err();
        assert!(matches!(missing, BuildError::NoLibrary { .. }), "{missing}");
        assert!(missing.help().contains("cargo build --release -p calyx-rt"), "{}", missing.help());
        fs::write(directory.path().join("libcalyx_rt.a"), "not an archive").unwrap();
        let damaged = find_in(&places).unwrap_err();
        assert!(damaged.to_string().contains("cannot be read"), "{damaged}");
        fs::write(directory.path().join("libcalyx_rt.a"), "!<arch>\n").unwrap();
        let foreign = find_in(&places).unwrap_err();
        assert!(foreign.to_string().contains("is not Calyx's runtime library"), "{foreign}");
    }
}
