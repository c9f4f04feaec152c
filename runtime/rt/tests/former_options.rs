//! Tests of former names of options.

use calyx_rt::former_options::warnings;
use clap::{Arg, Command};
use std::ffi::OsString;

#[test]
fn former_names_are_reported_once_with_the_current_name() {
    let command = Command::new("calyx")
        .arg(Arg::new("cells").long("contact-cells").alias("cells"))
        .arg(Arg::new("file").long("params").visible_alias("parameters"));
    let said =
        |arguments: &[&str]| warnings(&command, &arguments.iter().map(OsString::from).collect::<Vec<_>>());
    let warning = "`--cells` is now called `--contact-cells`; the former name works until 0.2";
    assert_eq!(said(&["pair.cx", "--cells", "6"]), [warning]);
    assert_eq!(said(&["--cells=6", "--cells=7"]), [warning]);
    for none in [&["--contact-cells", "6"][..], &["--parameters", "a"], &["cells"], &["--", "--cells"]] {
        assert_eq!(said(none), Vec::<String>::new());
    }
}
