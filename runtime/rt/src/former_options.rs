//! Former names of command-line options.
//!
//! An option declares its former name as a hidden alias, which works until version 0.2. A command
//! that is called with it prints a warning with the current name.

use clap::Command;
use std::ffi::OsString;

/// Returns one warning for each option that `arguments` call by its former name. `command` is the
/// command whose options these are; values of options and text after `--` are no options.
pub fn warnings(command: &Command, arguments: &[OsString]) -> Vec<String> {
    let called = |name: &str| {
        let option = format!("--{name}");
        arguments
            .iter()
            .filter_map(|argument| argument.to_str())
            .take_while(|argument| *argument != "--")
            .any(|argument| argument.split('=').next() == Some(&option))
    };
    let mut all = Vec::new();
    for option in command.get_arguments() {
        let Some(name) = option.get_long() else { continue };
        let visible = option.get_visible_aliases().unwrap_or_default();
        for former in option.get_all_aliases().unwrap_or_default() {
            if !visible.contains(&former) && called(former) {
                all.push(format!("`--{former}` is now called `--{name}`; the former name works until 0.2"));
            }
        }
    }
    all
}
