//! `calyx repl`: runs the session of [`calyx::session`] in a terminal or from a pipe.

use crate::eval::session;
use crate::messages::{MODEL_ERROR, MessageFormat};
use calyx::rt::console::{eprintln, print, println};
use calyx::session::{Answer, Session};
use clap::Args;
use rustyline::error::ReadlineError;
use rustyline::{DefaultEditor, Result as LineResult};
use std::io::{self, BufRead, IsTerminal};
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx repl
  calyx repl pair.cx                         with the functions of a model
  echo '2 inch + 1 mm' | calyx repl --units mm_N_s

At the prompt, :help lists the commands.";

const HELP: &str = "Enter a statement or an expression; brackets that are open continue on the next line.
  1 inch + 2 mm             shows the value
  15 kW / 1500 rpm to N*m   shows it in a unit
  var d = 20 mm             keeps it
  function area(in d) { return pi * d^2 / 4; }
  units mm_N_s              sets the unit system
Commands:
  :type EXPRESSION          its type
  :help                     this page
  :quit                     end; so does the end of input
";

#[derive(Args)]
pub struct Repl {
    /// A model or module whose declarations are available
    file: Option<PathBuf>,
    /// Unit system for bare numbers and results: SI, mm_N_s or inch_lbf_s [default: the file's, or
    /// SI]
    #[arg(long, value_name = "SYSTEM")]
    units: Option<String>,
}

impl Repl {
    pub fn run(self) -> ExitCode {
        let session = match session(self.file, self.units) {
            Ok(session) => session,
            Err(status) => return status,
        };
        let mut conversation = Conversation { session, pending: String::new(), ended: false };
        let done = if io::stdin().is_terminal() { conversation.interactive() } else { conversation.piped() };
        match done {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                MessageFormat::Human.failure(&format!("cannot read what is entered: {error}"), "");
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}

struct Conversation {
    session: Session,
    /// Lines of an incomplete entry.
    pending: String,
    ended: bool,
}

impl Conversation {
    fn interactive(&mut self) -> LineResult<()> {
        let mut editor = DefaultEditor::new()?;
        eprintln!("Calyx {}. :help lists what can be entered.", env!("CARGO_PKG_VERSION"));
        while !self.ended {
            let prompt = if self.pending.is_empty() { "> " } else { "... " };
            match editor.readline(prompt) {
                Ok(line) => {
                    // Errors of the history do not end the session.
                    let _ = editor.add_history_entry(&line);
                    self.line(&line);
                }
                // Ctrl-C discards an incomplete entry.
                Err(ReadlineError::Interrupted) => self.pending.clear(),
                Err(ReadlineError::Eof) => break,
                Err(error) => return Err(error),
            }
        }
        self.rest();
        Ok(())
    }

    fn piped(&mut self) -> LineResult<()> {
        for line in io::stdin().lock().lines() {
            self.line(&line?);
            if self.ended {
                break;
            }
        }
        self.rest();
        Ok(())
    }

    fn line(&mut self, line: &str) {
        if self.pending.is_empty()
            && let Some(command) = line.trim().strip_prefix(':')
        {
            return self.command(command);
        }
        self.pending += line;
        self.pending.push('\n');
        if Session::is_complete(&self.pending) {
            self.rest();
        }
    }

    /// Enters the pending lines, complete or not.
    fn rest(&mut self) {
        let text = std::mem::take(&mut self.pending);
        match self.session.converted(&text) {
            Some(Ok(value)) => println!("{value}"),
            Some(Err(answer)) => show(&answer),
            None => show(&self.session.enter(&text)),
        }
    }

    fn command(&mut self, command: &str) {
        let (word, rest) = command.split_once(char::is_whitespace).unwrap_or((command, ""));
        match word {
            "quit" | "q" | "exit" => self.ended = true,
            "help" | "h" | "?" => print!("{HELP}"),
            "type" | "t" if !rest.trim().is_empty() => match self.session.type_of(rest.trim()) {
                Ok(ty) => println!("{ty}"),
                Err(answer) => show(&answer),
            },
            "type" | "t" => {
                MessageFormat::Human.failure("`:type` needs an expression", "like `:type 3 mm / 2 s`")
            }
            _ => MessageFormat::Human.failure(
                &format!("there is no command `:{word}`"),
                "the commands are :type, :help and :quit",
            ),
        }
    }
}

fn show(answer: &Answer) {
    for line in &answer.lines {
        println!("{line}");
    }
    MessageFormat::Human.diagnostics(&answer.diagnostics, &answer.files);
}
