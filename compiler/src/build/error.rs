//! Errors of a build, with remedies.

use crate::error::CompileError;
use calyx_abi::Fingerprint;
use calyx_codegen::CodegenError;
use calyx_gears::library::FINGERPRINT;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

/// Error of a build. Its text is one sentence; [`BuildError::help`] returns the remedy.
#[derive(Debug)]
pub enum BuildError {
    /// The model has errors of the language, listed in its diagnostics.
    NotChecked,
    Code(CodegenError),
    Description(String),
    /// The module could not be serialized.
    Module(CompileError),
    /// The linker program does not exist.
    NoLinker {
        command: String,
    },
    /// The linker failed.
    Linker {
        command: String,
        said: String,
    },
    /// The runtime library is in none of these directories.
    NoLibrary {
        searched: Vec<PathBuf>,
    },
    /// The runtime library is damaged, or of another version of Calyx.
    WrongLibrary {
        path: PathBuf,
        why: WrongLibrary,
    },
    /// The output would overwrite the model.
    Source {
        path: PathBuf,
    },
    /// The output would replace a file that no build created.
    Foreign {
        path: PathBuf,
    },
    /// A file cannot be written.
    Io {
        path: PathBuf,
        error: io::Error,
    },
}

/// Mismatch of a runtime library.
#[derive(Debug)]
pub enum WrongLibrary {
    Unreadable(String),
    /// The library has no fingerprint, so it is a different library.
    Foreign,
    Version(Fingerprint),
    /// The library lacks the command line of executables.
    NoCommand,
}

impl BuildError {
    pub(super) fn unwritable(path: &Path, error: io::Error) -> BuildError {
        BuildError::Io { path: path.into(), error }
    }

    /// Returns the remedy; empty if there is none.
    pub fn help(&self) -> String {
        const MAKE: &str = "make it with `cargo build --release -p calyx-rt` in Calyx's source and name it by \
                            CALYX_RT_LIBRARY=target/release/libcalyx_rt.a";
        const BUNDLE: &str = "build with `calyx build --bundle`, which needs neither";
        match self {
            BuildError::NotChecked => "`calyx check` says what is wrong with it".into(),
            BuildError::NoLinker { .. } => format!("{}, name yours by CC=..., or {BUNDLE}", install_linker()),
            BuildError::Linker { .. } => "the linker is the C compiler `cc`, or what CC=... names".into(),
            BuildError::NoLibrary { searched } => {
                let places: Vec<String> = searched.iter().map(|path| path.display().to_string()).collect();
                format!("{MAKE}, or {BUNDLE}; looked in {}", places.join(", "))
            }
            BuildError::WrongLibrary { .. } => MAKE.into(),
            BuildError::Source { .. } => "name the executable with `-o NAME`".into(),
            BuildError::Foreign { .. } => {
                "choose another name with `-o NAME`, or replace the file with --force".into()
            }
            BuildError::Io { .. } => "choose another place with `-o NAME`".into(),
            BuildError::Code(_) | BuildError::Description(_) | BuildError::Module(_) => String::new(),
        }
    }
}

/// Returns the command that installs a C compiler on this kind of system.
fn install_linker() -> &'static str {
    if cfg!(target_os = "macos") {
        return "install Apple's command line tools with `xcode-select --install`";
    }
    let release = std::fs::read_to_string("/etc/os-release").unwrap_or_default();
    let says = |names: &[&str]| {
        let ids = release.lines().filter(|line| line.starts_with("ID=") || line.starts_with("ID_LIKE="));
        ids.flat_map(|line| line.split(['=', ' ', '"'])).any(|word| names.contains(&word))
    };
    match () {
        () if says(&["fedora", "rhel", "centos"]) => "install a C compiler with `sudo dnf install gcc`",
        () if says(&["arch"]) => "install a C compiler with `sudo pacman -S gcc`",
        () if says(&["suse", "opensuse"]) => "install a C compiler with `sudo zypper install gcc`",
        () if says(&["alpine"]) => "install a C compiler with `sudo apk add build-base`",
        () => "install a C compiler with `sudo apt install gcc`",
    }
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            BuildError::NotChecked => f.write_str("the model has errors and cannot be compiled"),
            BuildError::Code(error) => error.fmt(f),
            BuildError::Module(error) => error.fmt(f),
            BuildError::Description(error) => write!(f, "the model's description cannot be written: {error}"),
            BuildError::NoLinker { command } => {
                write!(f, "the linker `{command}` is not there, and an executable cannot be made without one")
            }
            BuildError::Linker { command, said } => {
                write!(f, "the linker `{command}` failed:\n{}", said.trim_end())
            }
            BuildError::NoLibrary { .. } => f.write_str(
                "the library `libcalyx_rt.a`, which contains the engine for executables, was not found",
            ),
            BuildError::WrongLibrary { path, why } => {
                let path = path.display();
                match why {
                    WrongLibrary::Unreadable(error) => {
                        write!(f, "the library {path} cannot be read: {error}")
                    }
                    WrongLibrary::Foreign => write!(f, "{path} is not Calyx's runtime library"),
                    WrongLibrary::NoCommand => write!(
                        f,
                        "the library {path} has no command line for executables: it was built without the feature `command`"
                    ),
                    WrongLibrary::Version(found) => write!(
                        f,
                        "the library {path} is of another version of Calyx: its interface is {found}, and this \
                         `calyx` compiles for {FINGERPRINT}"
                    ),
                }
            }
            BuildError::Source { path } => {
                write!(f, "{} is a source of the model and would be overwritten", path.display())
            }
            BuildError::Foreign { path } => {
                write!(f, "{} is there already, and `calyx build` did not make it", path.display())
            }
            BuildError::Io { path, error } => write!(f, "cannot write {}: {error}", path.display()),
        }
    }
}

impl std::error::Error for BuildError {}

impl From<CompileError> for BuildError {
    fn from(error: CompileError) -> BuildError {
        BuildError::Module(error)
    }
}
