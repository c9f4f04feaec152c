//! Output files of a checked model: an executable, an object file, a static library, a C header.
//!
//! ```no_run
//! use calyx::build::{BuildOptions, build};
//! let checked = calyx::check_file("examples/spur_pair.cx".as_ref())?;
//! let built = build(&checked, &BuildOptions::executable("spur_pair"))?;
//! println!("{}", built[0].path.display());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The code comes from the same lowering as code in memory. The system's C compiler links an
//! executable with the static library of `calyx-rt`, which contains the engine ([`library`] finds
//! it), so that it runs without a Calyx installation. Alternatively the executable is a copy of
//! `calyx` with the compiled module appended ([`bundle`]), which requires neither linker nor
//! library. Every output is written to a temporary file in the same directory and renamed, so that
//! no incomplete file is visible.

mod archive;
pub mod bundle;
mod error;
mod executable;
mod header;
pub mod library;
mod recognise;

pub use calyx_codegen::TargetCpu;
pub use error::BuildError;
pub use executable::{GlibcVersion, Linker, glibc_floor};
pub use library::Needs;

use crate::module::serialize;
use calyx_codegen::{ObjectOptions, compile_object};
use calyx_elaborate::Checked;
use calyx_gears::library::FINGERPRINT;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{fs, io};
use tempfile::TempDir;

/// Kind of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Emit {
    /// Program that runs the model.
    Executable,
    /// Object file without `main`, to be linked with the runtime library into the user's program.
    Object,
    /// Static library of model and runtime.
    Library,
    /// C header of object and library.
    Header,
}

/// Options of a build.
#[derive(Clone, Debug)]
pub struct BuildOptions {
    /// Path of the executable. Other outputs have the same directory and name: `NAME.o`,
    /// `libNAME.a`, `NAME.h`.
    pub output: PathBuf,
    pub emit: BTreeSet<Emit>,
    pub cpu: TargetCpu,
    /// Keeps function names in the executable, for debuggers and profilers.
    pub keep_symbols: bool,
    /// Runtime library; `None` searches for it.
    pub library: Option<PathBuf>,
    pub linker: Linker,
    /// `calyx` executable to which the module is appended. Executables then require neither linker
    /// nor runtime library.
    pub bundle: Option<PathBuf>,
    /// `calyx` executable to copy if no runtime library is found, and none was named.
    pub bundle_without_library: Option<PathBuf>,
    /// Replaces files that no build created.
    pub force: bool,
}

impl BuildOptions {
    /// Creates options of an executable for every machine of this architecture, linked by `$CC` or
    /// `cc`.
    pub fn executable(output: impl Into<PathBuf>) -> BuildOptions {
        BuildOptions {
            output: output.into(),
            emit: BTreeSet::from([Emit::Executable]),
            cpu: TargetCpu::Baseline,
            keep_symbols: false,
            library: None,
            linker: Linker::from_environment(),
            bundle: None,
            bundle_without_library: None,
            force: false,
        }
    }

    /// Returns the model's name in C, derived from the name of the output: its table is
    /// `NAME_model`.
    pub fn name(&self) -> String {
        c_name(&self.output.file_name().unwrap_or_default().to_string_lossy())
    }

    /// Returns the path of a kind of output.
    pub fn path(&self, emit: Emit) -> PathBuf {
        let name = self.output.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match emit {
            Emit::Executable => self.output.clone(),
            Emit::Object => self.output.with_file_name(name + ".o"),
            Emit::Library => self.output.with_file_name(format!("lib{name}.a")),
            Emit::Header => self.output.with_file_name(name + ".h"),
        }
    }
}

/// Output file of a build.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    pub emit: Emit,
    pub path: PathBuf,
    /// Size in bytes.
    pub size: u64,
    /// Oldest glibc that an executable supports; `None` if it needs none, and for other kinds of
    /// output.
    pub glibc: Option<GlibcVersion>,
    /// Reason why an executable is a copy of `calyx` without having been requested; `None`
    /// otherwise.
    pub why_bundled: Option<String>,
}

/// Builds all requested outputs, in the order of [`Emit`].
///
/// # Errors
/// If the model has errors of the language, the linker or the runtime library is missing, or a file
/// cannot be written. Outputs that were complete before the error remain.
pub fn build(checked: &Checked, options: &BuildOptions) -> Result<Vec<Built>, BuildError> {
    let program = checked.program.as_ref().ok_or(BuildError::NotChecked)?;
    let description = calyx_lang::description::to_json(&checked.description)
        .map_err(|error| BuildError::Description(error.to_string()))?;
    let name = options.name();
    let object = |entry| {
        let object =
            ObjectOptions { cpu: options.cpu, entry, ..ObjectOptions::new(&name, &description, FINGERPRINT) };
        compile_object(program, &object).map_err(BuildError::Code)
    };
    keep_sources(checked, options)?;
    keep_foreign(options)?;
    if options.output.file_name().is_none() || options.output.is_dir() {
        return Err(BuildError::unwritable(&options.output, io::ErrorKind::IsADirectory.into()));
    }
    let staging = Staging::beside(&options.output)?;
    let (mut built, mut why_bundled) = (Vec::new(), None);
    for &emit in &options.emit {
        let unfinished = staging.path(&options.path(emit));
        match emit {
            Emit::Executable => match executable_from(options)? {
                OutputOrigin::Copied(calyx, why) => {
                    let module = serialize(program, &checked.description, options.cpu)?;
                    bundle::write(&calyx, &module, &unfinished)
                        .map_err(|error| BuildError::unwritable(&unfinished, error))?;
                    why_bundled = why;
                }
                OutputOrigin::Linked(library) => {
                    let file = staging.write("model.o", &object(true)?)?;
                    executable::link(&file, &library, &unfinished, options)?;
                }
            },
            Emit::Object => {
                staging.write(&unfinished, &object(false)?)?;
            }
            Emit::Library => {
                let library = library::find(options.library.as_deref(), Needs::Interface)?;
                archive::with_member(&library, &format!("{name}.o"), &object(false)?, &unfinished)?;
            }
            Emit::Header => {
                staging.write(&unfinished, header::header(&name, &checked.description).as_bytes())?;
            }
        }
        let finished = staging.finish(&unfinished, emit, options)?;
        built.push(Built { why_bundled: why_bundled.take(), ..finished });
    }
    Ok(built)
}

/// Checks that no output would overwrite a source file.
///
/// # Errors
/// If an output is a file that the model was read from.
fn keep_sources(checked: &Checked, options: &BuildOptions) -> Result<(), BuildError> {
    let sources: Vec<PathBuf> = checked.files.iter().flat_map(|file| fs::canonicalize(&file.name)).collect();
    let targets = options.emit.iter().map(|&emit| options.path(emit));
    match targets.into_iter().find(|path| fs::canonicalize(path).is_ok_and(|path| sources.contains(&path))) {
        Some(path) => Err(BuildError::Source { path }),
        None => Ok(()),
    }
}

/// Checks that no output would replace a file of the user.
///
/// # Errors
/// If an output exists and no build created it.
fn keep_foreign(options: &BuildOptions) -> Result<(), BuildError> {
    let foreign = |emit: &Emit| {
        let path = options.path(*emit);
        let there = path.symlink_metadata().is_ok() && !path.is_dir();
        (there && !recognise::is_built(&path, *emit)).then_some(path)
    };
    match options.emit.iter().find_map(foreign) {
        Some(path) if !options.force => Err(BuildError::Foreign { path }),
        _ => Ok(()),
    }
}

/// Way to create an executable.
enum OutputOrigin {
    /// Linked with this library.
    Linked(PathBuf),
    /// Copied from this `calyx`, with the reason if this was not requested.
    Copied(PathBuf, Option<String>),
}

/// Selects the way to create the executable.
///
/// # Errors
/// If there is no matching runtime library and nothing to copy.
fn executable_from(options: &BuildOptions) -> Result<OutputOrigin, BuildError> {
    if let Some(calyx) = &options.bundle {
        return Ok(OutputOrigin::Copied(calyx.clone(), None));
    }
    match (library::find(options.library.as_deref(), Needs::Command), &options.bundle_without_library) {
        (Err(error), Some(calyx)) if options.library.is_none() && !library::is_named() => {
            Ok(OutputOrigin::Copied(calyx.clone(), Some(error.to_string())))
        }
        (library, _) => library.map(OutputOrigin::Linked),
    }
}

/// Temporary directory next to the output, on the same file system, for incomplete files. Dropping
/// this value removes it.
struct Staging(TempDir);

impl Staging {
    fn beside(output: &Path) -> Result<Staging, BuildError> {
        let parent = match output.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        let directory = tempfile::Builder::new().prefix(".calyx-build-").tempdir_in(parent);
        directory.map(Staging).map_err(|error| BuildError::unwritable(parent, error))
    }

    /// Returns the temporary path of a file.
    fn path(&self, target: &Path) -> PathBuf {
        self.0.path().join(target.file_name().unwrap_or_default())
    }

    fn write(&self, name: impl AsRef<Path>, bytes: &[u8]) -> Result<PathBuf, BuildError> {
        let path = self.0.path().join(name);
        fs::write(&path, bytes).map_err(|error| BuildError::unwritable(&path, error))?;
        Ok(path)
    }

    /// Moves a complete file to its final path.
    fn finish(&self, file: &Path, emit: Emit, options: &BuildOptions) -> Result<Built, BuildError> {
        let path = options.path(emit);
        let glibc = match emit {
            Emit::Executable => fs::read(file).ok().and_then(|bytes| glibc_floor(&bytes)),
            _ => None,
        };
        let size = fs::metadata(file).map_err(|error| BuildError::unwritable(file, error))?.len();
        fs::rename(file, &path).map_err(|error| BuildError::unwritable(&path, error))?;
        Ok(Built { emit, path, size, glibc, why_bundled: None })
    }
}

/// Converts a file name to a C identifier: `spur-pair.v2` becomes `spur_pair_v2`.
fn c_name(name: &str) -> String {
    let word = c_letters(name);
    match word.chars().next() {
        Some(first) if first.is_ascii_digit() => format!("model_{word}"),
        Some(_) => word,
        None => "model".into(),
    }
}

/// Replaces all characters other than letters and digits by underscores.
fn c_letters(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_become_words_of_c() {
        let table = [
            ("spur_pair", "spur_pair"),
            ("a-b.v2", "a_b_v2"),
            ("20x40", "model_20x40"),
            ("é", "_"),
            ("", "model"),
        ];
        for (name, word) in table {
            assert_eq!(c_name(name), word);
        }
    }

    #[test]
    fn kinds_of_files_stand_beside_each_other() {
        let options = BuildOptions::executable("out/pair.v2");
        let paths =
            [Emit::Executable, Emit::Object, Emit::Library, Emit::Header].map(|emit| options.path(emit));
        assert_eq!(
            paths,
            ["out/pair.v2", "out/pair.v2.o", "out/libpair.v2.a", "out/pair.v2.h"].map(PathBuf::from)
        );
    }
}
