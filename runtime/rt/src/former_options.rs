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

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Arg;

    #[test]
    fn former_names_are_reported_once_with_the_current_name() {
        let command = Command::new("calyx")
            .arg(Arg::new("cells").long("contact-cells").alias("cells"))
            .arg(Arg::new("file").long("params").visible_alias("parameters"));
        let said = |arguments: &[&str]| {
            warnings(&command, &arguments.iter().map(OsString::from).collect::<Vec<_>>())
        };
        let warning = "`--cells` is now called `--contact-cells`; the former name works until 0.2";
        assert_eq!(said(&["pair.cx", "--cells", "6"]), [warning]);
        assert_eq!(said(&["--cells=6", "--cells=7"]), [warning]);
        for none in [&["--contact-cells", "6"][..], &["--parameters", "a"], &["cells"], &["--", "--cells"]] {
            assert_eq!(said(none), Vec::<String>::new());
        }
    }
}
