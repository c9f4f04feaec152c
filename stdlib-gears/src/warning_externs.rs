//! Warnings of library modules for programs. The checks themselves are written in Calyx
//! (`calyx/bevel_checks.cx`, `calyx/stepped_planets.cx`).

use crate::externs::host;
use calyx_abi::{Context, RuntimeError};

calyx_abi::externs! {
    Scene fn calyx_bevel_checks_warn(context, code: String, message: String, help: String) -> () {
        warn(context, &code, message, &help)
    }

    Scene fn calyx_stepped_planets_warn(context, code: String, message: String, help: String) -> () {
        warn(context, &code, message, &help)
    }
}

/// Reports a warning at the call of the model that causes it.
fn warn(context: &mut Context, code: &str, message: String, help: &str) -> Result<(), RuntimeError> {
    let place = context.place;
    host(context)?.warn(code, message, help, place);
    Ok(())
}
