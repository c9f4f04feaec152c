//! Runs the commands on the pages of the book and compares their output. `CALYX_BLESS=1` rewrites
//! the pages.
//!
//! A page is one session in an empty directory. A block `cx` whose first line is a comment with a
//! file name is that file, as is a block `file NAME`. A block `console` has commands, each after `$
//! `, followed by the terminal output: standard output and standard error in order. A line `...`
//! matches any lines. Blocks of other kinds (`sh`, `text`) are not compared.

use crate::cli::pages::words;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

/// Collects the pages of a directory that show commands.
fn pages(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the book") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            pages(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "md")
            && fs::read_to_string(&path).expect("readable").contains("\n```console\n")
        {
            found.push(path);
        }
    }
}

/// Terminal session of a reader: its current directory, and a directory for its cache.
struct Session {
    directory: PathBuf,
    home: PathBuf,
}

impl Session {
    /// Runs a command and returns the terminal output.
    fn run(&mut self, line: &str) -> String {
        let words = words(line);
        match words[0].as_str() {
            "cd" => {
                self.directory = self.directory.join(&words[1]);
                String::new()
            }
            program if program == "calyx" || program.starts_with("./") => {
                let screen = self.home.join("screen");
                let file = fs::File::create(&screen).expect("a temporary file");
                let program = match program {
                    "calyx" => PathBuf::from(env!("CARGO_BIN_EXE_calyx")),
                    built => self.directory.join(built),
                };
                Command::new(program)
                    .current_dir(&self.directory)
                    .env("CALYX_CACHE", self.home.join("cache"))
                    .args(&words[1..])
                    .stdout(file.try_clone().expect("a second handle"))
                    .stderr(file)
                    .status()
                    .expect("the command runs");
                fs::read_to_string(screen).expect("text")
            }
            other => panic!("`{other}` is not run here: make the block `sh`"),
        }
    }
}

/// Compares lines; `...` matches any number of lines.
fn matches(expected: &[&str], found: &[&str]) -> bool {
    match expected {
        [] => found.is_empty(),
        ["...", rest @ ..] => (0..=found.len()).any(|skipped| matches(rest, &found[skipped..])),
        [line, rest @ ..] => found.first() == Some(line) && matches(rest, &found[1..]),
    }
}

/// Runs the commands of a block and returns the block with their output.
fn replay(block: &[&str], session: &mut Session) -> String {
    let mut shown = String::new();
    let mut lines = block.iter().copied().peekable();
    while let Some(line) = lines.next() {
        let command = line.strip_prefix("$ ").unwrap_or_else(|| panic!("`{line}` belongs to no command"));
        let mut expected = Vec::new();
        while let Some(line) = lines.next_if(|line| !line.starts_with("$ ")) {
            expected.push(line);
        }
        let output = session.run(command);
        let found: Vec<&str> = output.trim_end().lines().map(str::trim_end).collect();
        let kept = if matches(&expected, &found) { &expected } else { &found };
        shown += &format!("$ {command}\n");
        shown.extend(kept.iter().map(|line| format!("{line}\n")));
    }
    shown
}

/// Runs the commands of a page and returns its text with their output.
fn replayed(page: &str) -> String {
    let home = tempfile::tempdir().expect("a temporary folder");
    let directory = home.path().join("work");
    fs::create_dir(&directory).expect("a temporary folder");
    let mut session = Session { directory, home: home.path().into() };
    let mut result = String::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        result += &format!("{line}\n");
        let Some(kind) = line.strip_prefix("```") else { continue };
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        let text: String = block.iter().map(|line| format!("{line}\n")).collect();
        let named = block.first().and_then(|line| line.strip_prefix("// ")).filter(|n| n.ends_with(".cx"));
        let file = kind.strip_prefix("file ").or(named.filter(|_| kind == "cx"));
        if let Some(name) = file {
            fs::write(session.directory.join(name), &text).expect("a temporary file");
        }
        result += &if kind == "console" { replay(&block, &mut session) } else { text };
        result += "```\n";
    }
    result
}

#[test]
fn commands_on_pages_print_what_the_pages_show() {
    let mut paths = Vec::new();
    pages(&docs(), &mut paths);
    paths.sort();
    assert!(paths.len() >= 5, "only {} pages show commands", paths.len());
    let mut problems = Vec::new();
    for path in paths {
        let page = fs::read_to_string(&path).expect("readable");
        let now = replayed(&page);
        if std::env::var_os("CALYX_BLESS").is_some() {
            fs::write(&path, &now).expect("writable");
        } else if now != page {
            let mut pairs = page.lines().zip(now.lines()).enumerate();
            let (line, (old, new)) = pairs.find(|(_, (old, new))| old != new).unwrap_or((0, ("", "")));
            problems.push(format!("{}:{}: not `{old}` but `{new}`", path.display(), line + 1));
        }
    }
    assert!(problems.is_empty(), "CALYX_BLESS=1 rewrites pages:\n{}", problems.join("\n"));
}
