//! `calyx lsp`: the language server, for editors.

use calyx::rt::console::eprintln;
use calyx_gears::library::{LibraryModule, MODULES, PRELUDE};
use calyx_lsp::server::library::{Library, LibraryFile, cache_folder};
use calyx_lsp::server::log::Level;
use calyx_lsp::server::{Options, stdio};
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "\
Editors:
  VS Code   install the extension in lsp/editors/vscode; it starts `calyx lsp` automatically
  Neovim    vim.lsp.start({ name = 'calyx', cmd = { 'calyx', 'lsp' }, root_dir = vim.fn.getcwd() })
            in an autocommand for the file type of *.cx; see lsp/editors/neovim
  Helix     languages.toml:  [language-server.calyx]
                             command = \"calyx\"
                             args = [\"lsp\"]
            see lsp/editors/helix
  Emacs     (add-to-list 'eglot-server-programs '(calyx-mode \"calyx\" \"lsp\")); see lsp/editors/emacs
  others    the command is `calyx lsp`, files end in .cx

Exit status: 0 after the requests `shutdown` and `exit`, 1 if the editor exited before.";

#[derive(Args)]
pub struct Lsp {
    /// Level of log messages on standard error and in the editor's log: error, info or debug
    #[arg(long, value_name = "LEVEL", default_value_t)]
    log: Level,
    /// Write all protocol messages to a file, for bug reports. The file contains the edited texts
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Accepted for compatibility: standard input and output are the only transport
    #[arg(long, hide = true)]
    stdio: bool,
}

impl Lsp {
    pub fn run(self) -> ExitCode {
        let library =
            Library::new(file(&PRELUDE), MODULES.iter().map(file).collect(), cache_folder().as_deref());
        let options = match std::env::current_exe() {
            Ok(executable) => Options { library, log: self.log, executable, record: self.record },
            Err(error) => return failed(&error),
        };
        match stdio(options) {
            Ok(true) => ExitCode::SUCCESS,
            Ok(false) => ExitCode::FAILURE,
            Err(error) => failed(&error),
        }
    }
}

fn failed(error: &std::io::Error) -> ExitCode {
    eprintln!("calyx lsp: {error}");
    ExitCode::FAILURE
}

fn file(module: &LibraryModule) -> LibraryFile {
    LibraryFile { path: module.path.to_owned(), name: module.file.to_owned(), text: module.text.to_owned() }
}
