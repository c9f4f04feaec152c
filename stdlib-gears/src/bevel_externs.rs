//! Warnings of the bevel gear modules for programs. The checks themselves are written in Calyx
//! (`calyx/bevel_checks.cx`).

use crate::externs::host;

calyx_abi::externs! {
    Scene fn calyx_bevel_checks_warn(context, code: String, message: String, help: String) -> () {
        let place = context.place;
        host(context)?.warn(&code, message, &help, place);
        Ok(())
    }
}
