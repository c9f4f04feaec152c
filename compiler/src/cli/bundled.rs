//! What `calyx build --bundle` makes: a copy of `calyx` with a module behind it is the executable of that module.

use crate::messages::{MODEL_ERROR, MessageFormat};
use calyx::build::bundle;
use calyx::rt::executable;
use calyx::{Engine, Module};
use std::ffi::OsString;
use std::process::ExitCode;

/// Runs the module behind this executable; `None` if there is none, and it is `calyx`.
pub fn run() -> Option<ExitCode> {
    // Without a way to read itself it cannot be a bundle that works, and says so by being `calyx`.
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
    // SAFETY: `calyx build` put them behind this very executable: whoever can change them can change its own code. Its
    // checksum was compared, and the loader compares version, engine and machine.
    match unsafe { Module::deserialize(&Engine::default(), &bytes) } {
        Ok(module) => {
            let arguments: Vec<OsString> = std::env::args_os().collect();
            Some(ExitCode::from(executable::main(module.as_program(), &arguments)))
        }
        Err(error) => failed(&error.to_string(), error.help()),
    }
}
