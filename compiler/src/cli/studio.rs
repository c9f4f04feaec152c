//! `calyx studio`: a form, runs and results of a model in the browser.

use crate::allow::AllowPath;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::{eprintln, println};
use calyx::studio::{Options, Subject, serve};
use clap::Args;
use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::thread;

pub const EXAMPLES: &str = "\
Examples:
  calyx studio pair.cx               a form of the model, its runs and results
  calyx studio pair.cx.run           the results of a run
  calyx studio pair.cx --no-browser --port 8080
  calyx studio pair.cx --listen 192.168.1.20

Runs are stored in pair.cx.studio/run-0001 and so on; pair.cx.studio/session.json has the values of
the form. Nothing is overwritten.

The printed address includes a token that every request needs. The server listens on this computer
only, unless --listen names another address. Connections are not encrypted: on a remote computer,
forward the port with `ssh -L 8080:localhost:8080 HOST`.

Ctrl-C ends the server and the runs that it started.

Exit status: 0 after Ctrl-C, 1 if the server cannot start, 2 for wrong usage of the command.";

#[derive(Args)]
pub struct Studio {
    /// The model (.cx file), or the directory of a run [default: the model in this directory]
    #[arg(value_name = "MODEL or DIR")]
    subject: Option<PathBuf>,
    /// Port to listen on [default: a free one]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    port: u16,
    /// Address to listen on
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1")]
    listen: String,
    /// Do not open the browser
    #[arg(long)]
    no_browser: bool,
    #[command(flatten)]
    allow: AllowPath,
}

impl Studio {
    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let subject = match Subject::of_argument(self.subject.as_deref()) {
            Ok(subject) => subject,
            Err(error) => {
                format.failure(&error.to_string(), error.help());
                return ExitCode::from(USAGE);
            }
        };
        let command = match std::env::current_exe() {
            Ok(command) => command,
            Err(error) => {
                format.failure(&format!("cannot find the program `calyx`: {error}"), "");
                return ExitCode::from(MODEL_ERROR);
            }
        };
        let options =
            Options { subject, listen: self.listen, port: self.port, command, allowed: self.allow.paths() };
        let opens = !self.no_browser;
        let served = serve(options, |url| {
            println!("{url}");
            eprintln!("Ctrl-C ends the studio");
            if opens {
                open(url);
            }
        });
        match served {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                format.failure(&error.to_string(), error.help());
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}

/// Opens an address in the browser. The printed address remains if that fails.
fn open(url: &str) {
    let opener = if cfg!(target_os = "macos") { "open" } else { "xdg-open" };
    let mut command = Command::new(opener);
    command.arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    if let Ok(mut child) = command.spawn() {
        // Without a wait, the ended process would remain in the process table.
        thread::spawn(move || child.wait());
    }
}
