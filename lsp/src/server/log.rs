//! Log of the server: standard error, and the log of the client.

use std::fmt;
use std::io::{self, Write};
use std::str::FromStr;
use tokio::runtime::Handle;
use tower_lsp_server::Client;
use tower_lsp_server::ls_types::MessageType;

/// Log level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    Error,
    #[default]
    Info,
    Debug,
}

impl FromStr for Level {
    type Err = String;

    fn from_str(text: &str) -> Result<Level, String> {
        match text {
            "error" => Ok(Level::Error),
            "info" => Ok(Level::Info),
            "debug" => Ok(Level::Debug),
            _ => Err("must be error, info or debug".to_owned()),
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Level::Error => "error",
            Level::Info => "info",
            Level::Debug => "debug",
        })
    }
}

/// Destination of log messages.
#[derive(Clone)]
pub struct Log {
    level: Level,
    client: Client,
    runtime: Handle,
}

impl Log {
    pub fn new(level: Level, client: Client, runtime: Handle) -> Log {
        Log { level, client, runtime }
    }

    pub fn error(&self, message: &str) {
        self.say(Level::Error, MessageType::ERROR, message);
    }

    pub fn info(&self, message: &str) {
        self.say(Level::Info, MessageType::INFO, message);
    }

    pub fn debug(&self, message: &str) {
        self.say(Level::Debug, MessageType::LOG, message);
    }

    fn say(&self, level: Level, kind: MessageType, message: &str) {
        if level > self.level {
            return;
        }
        let _ = writeln!(io::stderr(), "calyx lsp: {level}: {message}");
        let (client, message) = (self.client.clone(), message.to_owned());
        self.runtime.spawn(async move { client.log_message(kind, message).await });
    }
}
