//! Start of an executable made by `calyx build --bundle`: a copy of `calyx` with an appended module
//! runs that module.

use crate::messages::{MODEL_ERROR, MessageFormat};
use calyx::build::bundle;
use calyx::rt::executable;
use calyx::{Engine, Module};
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the module appended to this executable; `None` if there is none, so that it is `calyx`.
pub fn run() -> Option<ExitCode> {
    // An executable that cannot read itself is not a working bundle; it runs as `calyx`.
    let found = bundle::read(&std::env::current_exe().ok()?).ok()??;
    let failed = |message: &str, help: &str| {
        MessageFormat::Human.failure(message, help);
        Some(ExitCode::from(MODEL_ERROR))
    };
    let bytes = match found {
        Ok(bytes) => bytes,
        Err(damaged) => {
            return failed(&damaged.to_string(), "copy it again from where it was made, as binary data");
        }
    };
    // SAFETY: `calyx build` appended the bytes to this executable: whoever can change them can
    // change its own code. Their checksum was compared, and the loader compares version, engine and
    // machine.
    match unsafe { Module::deserialize(&Engine::default(), &bytes) } {
        Ok(module) => {
            let arguments: Vec<OsString> = std::env::args_os().collect();
            Some(ExitCode::from(executable::main(module.as_program(), &arguments)))
        }
        Err(error) => failed(&error.to_string(), error.help()),
    }
}
