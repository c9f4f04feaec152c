//! Option `--allow-path` of all commands that read models.

use calyx::allowed_path;
use clap::Args;
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Args, Clone)]
pub struct AllowPath {
    /// Let `import` and `read_table` read this file, or files below this directory, too
    /// (repeatable)
    ///
    /// Models read regular files in their own directory and below it. Another path, or a symbolic
    /// link that leads out of the directory, is refused unless it is allowed. Nothing is written
    /// there.
    #[arg(long = "allow-path", value_name = "PATH", value_parser = allowed_path)]
    paths: Vec<PathBuf>,
}

impl AllowPath {
    /// Returns the allowed files and directories as absolute paths with links resolved.
    pub fn paths(&self) -> Arc<[PathBuf]> {
        self.paths.as_slice().into()
    }
}
