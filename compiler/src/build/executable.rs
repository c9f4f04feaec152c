//! Links executables, and determines the oldest system that they support.

use super::{BuildError, BuildOptions};
use object::endian::Endianness;
use object::read::elf::FileHeader;
use std::ffi::OsString;
use std::fmt;
use std::io;
use std::path::Path;
use std::process::Command;

/// C compiler that links, with its own arguments, if any.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Linker {
    pub program: OsString,
    pub arguments: Vec<OsString>,
}

impl Linker {
    /// Returns the command in `$CC`, such as `clang` or `ccache gcc -m64`; `cc` if it is unset.
    pub fn from_environment() -> Linker {
        let named = std::env::var("CC").unwrap_or_default();
        let mut words = named.split_whitespace().map(OsString::from);
        Linker { program: words.next().unwrap_or_else(|| "cc".into()), arguments: words.collect() }
    }
}

/// Returns the arguments after the objects. The compiler's unwinding support is linked statically,
/// so that the executable requires the C library only.
fn flags(keep_symbols: bool) -> Vec<&'static str> {
    let mut flags = if cfg!(target_os = "macos") {
        vec!["-Wl,-dead_strip"]
    } else {
        vec!["-static-libgcc", "-Wl,--gc-sections", "-Wl,--as-needed"]
    };
    if !keep_symbols {
        // Apple's linker has no single flag for debugging information and names of local symbols.
        flags.extend(if cfg!(target_os = "macos") {
            &["-Wl,-S", "-Wl,-x"][..]
        } else {
            &["-Wl,--strip-all"]
        });
    }
    // On systems whose libc includes these libraries they are empty.
    flags.extend(if cfg!(target_os = "macos") {
        &["-lm"][..]
    } else {
        &["-lm", "-lpthread", "-ldl", "-lrt"]
    });
    flags
}

/// Links an object file that has a `main` with the runtime library.
///
/// # Errors
/// If there is no linker, or it fails.
pub(super) fn link(
    object: &Path,
    library: &Path,
    executable: &Path,
    options: &BuildOptions,
) -> Result<(), BuildError> {
    let Linker { program, arguments } = &options.linker;
    let command = program.to_string_lossy().into_owned();
    let mut linker = Command::new(program);
    linker
        .args(arguments)
        .arg(object)
        .arg(library)
        .args(flags(options.keep_symbols))
        .arg("-o")
        .arg(executable);
    match linker.output() {
        Ok(output) if output.status.success() => Ok(()),
        Ok(output) => {
            Err(BuildError::Linker { command, said: String::from_utf8_lossy(&output.stderr).into() })
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => Err(BuildError::NoLinker { command }),
        Err(error) => Err(BuildError::Linker { command, said: error.to_string() }),
    }
}

/// Version of the GNU C library.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct GlibcVersion {
    pub major: u32,
    pub minor: u32,
}

impl fmt::Display for GlibcVersion {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}.{}", self.major, self.minor)
    }
}

/// Returns the oldest glibc that has every symbol of an executable, from the versions of the
/// symbols; `None` if no symbol has a glibc version, or the file is not a 64-bit ELF file.
pub fn glibc_floor(executable: &[u8]) -> Option<GlibcVersion> {
    version_needs(executable).ok()?.iter().filter_map(|name| glibc_version(name)).max()
}

/// Returns the names of the library versions that an executable requires, such as `GLIBC_2.34`.
fn version_needs(executable: &[u8]) -> object::Result<Vec<String>> {
    let header = object::elf::FileHeader64::<Endianness>::parse(executable)?;
    let endian = header.endian()?;
    let sections = header.sections(endian, executable)?;
    let mut names = Vec::new();
    if let Some((mut needs, link)) = sections.gnu_verneed(endian, executable)? {
        let strings = sections.strings(endian, executable, link)?;
        while let Some((_, mut versions)) = needs.next()? {
            while let Some(version) = versions.next()? {
                names.push(String::from_utf8_lossy(version.name(endian, strings)?).into_owned());
            }
        }
    }
    Ok(names)
}

/// `GLIBC_2.2.5` belongs to version 2.2; packed relative relocations (`GLIBC_ABI_DT_RELR`) require
/// 2.36.
fn glibc_version(name: &str) -> Option<GlibcVersion> {
    let text = name.strip_prefix("GLIBC_")?;
    if text == "ABI_DT_RELR" {
        return Some(GlibcVersion { major: 2, minor: 36 });
    }
    let mut numbers = text.split('.').map(|number| number.parse().ok());
    Some(GlibcVersion { major: numbers.next()??, minor: numbers.next()?? })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_read_as_glibc_writes_them() {
        let version = |major, minor| Some(GlibcVersion { major, minor });
        let table = [
            ("GLIBC_2.2.5", version(2, 2)),
            ("GLIBC_2.34", version(2, 34)),
            ("GLIBC_ABI_DT_RELR", version(2, 36)),
            ("GLIBC_PRIVATE", None),
            ("GCC_3.0", None),
        ];
        for (name, expected) in table {
            assert_eq!(glibc_version(name), expected, "{name}");
        }
        assert!(version(2, 4) < version(2, 34));
    }

    #[test]
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    fn this_executable_needs_a_glibc() {
        let floor = glibc_floor(&std::fs::read(std::env::current_exe().unwrap()).unwrap()).unwrap();
        assert!(floor.major == 2 && floor.minor >= 2, "{floor}");
        assert_eq!(glibc_floor(b"no executable"), None);
    }
}
