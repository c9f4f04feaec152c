//! `print!`, `println!`, `eprint!` and `eprintln!` that accept a closed pipe, as of
//! `calyx run MODEL.cx | head`. Those of the standard library panic, which would end a run.

use std::fmt::Arguments;
use std::io::{self, ErrorKind, Write};

/// Writes to standard output. A closed pipe is ignored; another failure, such as a full disk, is
/// reported on standard error.
pub fn write_output(text: Arguments<'_>) {
    let written = io::stdout().lock().write_fmt(text);
    if let Some(error) = written.err().filter(|error| error.kind() != ErrorKind::BrokenPipe) {
        write_error(format_args!("error: standard output cannot be written: {error}\n"));
    }
}

/// Writes to standard error. A failure is ignored, because it cannot be reported.
pub fn write_error(text: Arguments<'_>) {
    let _ = io::stderr().lock().write_fmt(text);
}

#[doc(hidden)]
#[macro_export]
macro_rules! console_print {
    ($($text:tt)*) => { $crate::console::write_output(format_args!($($text)*)) };
}

#[doc(hidden)]
#[macro_export]
macro_rules! console_println {
    ($($text:tt)*) => { $crate::console::write_output(format_args!("{}\n", format_args!($($text)*))) };
}

#[doc(hidden)]
#[macro_export]
macro_rules! console_eprint {
    ($($text:tt)*) => { $crate::console::write_error(format_args!($($text)*)) };
}

#[doc(hidden)]
#[macro_export]
macro_rules! console_eprintln {
    ($($text:tt)*) => { $crate::console::write_error(format_args!("{}\n", format_args!($($text)*))) };
}

pub use {
    console_eprint as eprint, console_eprintln as eprintln, console_print as print,
    console_println as println,
};
