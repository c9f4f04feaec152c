//! A checked model as a file of its own: an executable, an object file, a static library, a C header.
//!
//! ```no_run
//! use calyx::build::{BuildOptions, build};
//! let checked = calyx::check_file("examples/spur_pair.cx".as_ref())?;
//! let built = build(&checked, &BuildOptions::executable("spur_pair"))?;
//! println!("{}", built[0].path.display());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Code comes from the same lowering as code in memory. An executable is linked by the system's C compiler with the static
//! library of `calyx-rt`, which holds the engine ([`library`] finds it), so that it needs nothing of Calyx where it runs; or it is
//! a copy of `calyx` with the compiled module behind it ([`bundle`]), which takes neither linker nor library to make.
//! Whatever is written is made beside its place and renamed: nobody finds half a file.

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

/// What a model is made into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Emit {
    /// A program that runs the model.
    Executable,
    /// The model's code without `main`, to be linked with the runtime library into a program of one's own.
    Object,
    /// Model and runtime in one static library.
    Library,
    /// The C header of object and library.
    Header,
}

/// How to build.
#[derive(Clone, Debug)]
pub struct BuildOptions {
    /// Where to: the path of the executable. What else is made stands beside it: `NAME.o`, `libNAME.a`, `NAME.h`.
    pub output: PathBuf,
    pub emit: BTreeSet<Emit>,
    pub cpu: TargetCpu,
    /// Leave the names of functions in the executable, for debuggers and profilers.
    pub keep_symbols: bool,
    /// The runtime library; searched for if there is none.
    pub library: Option<PathBuf>,
    pub linker: Linker,
    /// The `calyx` that executables are to be copies of, with the module behind them. Then neither linker nor runtime library is
    /// needed for them.
    pub bundle: Option<PathBuf>,
    /// The `calyx` that executables become copies of if no runtime library is found, and none was named.
    pub bundle_without_library: Option<PathBuf>,
    /// Replaces files that no build made.
    pub force: bool,
}

impl BuildOptions {
    /// An executable for every machine of this architecture, linked by `$CC` or `cc`.
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

    /// The model's name in C, made from the name of the output: its table is `NAME_model`.
    pub fn name(&self) -> String {
        c_name(&self.output.file_name().unwrap_or_default().to_string_lossy())
    }

    /// Where a kind of file goes.
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

/// A file that was built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Built {
    pub emit: Emit,
    pub path: PathBuf,
    /// Its size in bytes.
    pub size: u64,
    /// The oldest glibc that an executable runs with; `None` if it needs none, and for what is not an executable.
    pub glibc: Option<GlibcVersion>,
    /// Why an executable is a copy of `calyx` although that was not asked for; `None` if it is none.
    pub why_bundled: Option<String>,
}

/// Builds everything that is asked for; in order of [`Emit`].
///
/// # Errors
/// The model has errors of the language, the linker or the runtime library is missing, or a file cannot be written. Files
/// that were complete by then stay.
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

/// # Errors
/// A file to be written is one that the model was read from.
fn keep_sources(checked: &Checked, options: &BuildOptions) -> Result<(), BuildError> {
    let sources: Vec<PathBuf> = checked.files.iter().flat_map(|file| fs::canonicalize(&file.name)).collect();
    let targets = options.emit.iter().map(|&emit| options.path(emit));
    match targets.into_iter().find(|path| fs::canonicalize(path).is_ok_and(|path| sources.contains(&path))) {
        Some(path) => Err(BuildError::Source { path }),
        None => Ok(()),
    }
}

/// # Errors
/// A file to be written exists, and no build made it.
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

/// How an executable is made.
enum OutputOrigin {
    /// Linked with this library.
    Linked(PathBuf),
    /// As a copy of this `calyx`, and why, if that was not asked for.
    Copied(PathBuf, Option<String>),
}

/// # Errors
/// There is no runtime library that fits, and nothing to copy.
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

/// A directory beside the output, on the same file system, for what is not finished. It goes with this value.
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

    /// Where a file is made.
    fn path(&self, target: &Path) -> PathBuf {
        self.0.path().join(target.file_name().unwrap_or_default())
    }

    fn write(&self, name: impl AsRef<Path>, bytes: &[u8]) -> Result<PathBuf, BuildError> {
        let path = self.0.path().join(name);
        fs::write(&path, bytes).map_err(|error| BuildError::unwritable(&path, error))?;
        Ok(path)
    }

    /// Puts a file that is finished to its place.
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

/// A word of C that is like a file's name: `spur-pair.v2` gives `spur_pair_v2`.
fn c_name(name: &str) -> String {
    let word = c_letters(name);
    match word.chars().next() {
        Some(first) if first.is_ascii_digit() => format!("model_{word}"),
        Some(_) => word,
        None => "model".into(),
    }
}

/// A text with letters, digits and underscores only.
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
