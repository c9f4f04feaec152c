//! Interactive session of the language: statements and expressions one after another, with
//! persistent state (`calyx repl`, `calyx eval`).
//!
//! A session is a model that grows with each entry. Each entry runs the whole model again,
//! interpreted and without solving, and shows only the new output. So the language has one
//! evaluator, errors leave no trace, and definitions can be replaced.

use calyx_elaborate::diagnostics::has_errors;
use calyx_elaborate::{ModelLoader, elaborate_printing};
use calyx_lang::ast::{Module, Stmt, StmtKind};
use calyx_lang::check_program;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::SourceFile;
use calyx_lang::lexer::{Kind, lex};
use calyx_lang::parser::parse;
use calyx_lang::span::{FileId, Span};
use calyx_lang::units::UnitSystem;
use std::io;
use std::path::{Path, PathBuf};

/// File name of the entered text in diagnostics.
const NAME: &str = "input";

/// Warnings about names that are not used yet, and about expressions that are entered to show their
/// value.
const OF_NO_INTEREST: [&str; 2] = ["W0201", "W0203"];

/// Result of an entry.
#[derive(Default)]
pub struct Answer {
    /// Lines that the entry printed.
    pub lines: Vec<String>,
    pub diagnostics: Vec<Diagnostic>,
    pub files: Vec<SourceFile>,
}

impl Answer {
    pub fn has_errors(&self) -> bool {
        has_errors(&self.diagnostics)
    }
}

/// Entries of the session.
#[derive(Clone, Default)]
pub struct Session {
    /// Selected unit system.
    units: Option<String>,
    /// Statements outside of blocks: imports, params, declarations of a file.
    header: Vec<String>,
    entries: Vec<Entry>,
    /// Number of lines that the entries print.
    printed: usize,
    folder: Option<PathBuf>,
}

#[derive(Clone)]
struct Entry {
    text: String,
    /// The entry declares a name again, so that it and later entries are in a new block.
    opens_block: bool,
}

impl Session {
    pub fn new() -> Session {
        Session::default()
    }

    /// Selects a unit system for results and bare literals. Returns false if there is no such
    /// system.
    pub fn set_units(&mut self, name: &str) -> bool {
        let known = UnitSystem::from_name(name).is_some();
        if known {
            self.units = Some(name.to_owned());
        }
        known
    }

    /// Loads the declarations of a file: everything except the statements that it runs.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn load(&mut self, file: &Path) -> io::Result<()> {
        let text = std::fs::read_to_string(file)?;
        let (module, _) = parse(FileId(0), &text);
        for statement in &module.statements {
            match &statement.kind {
                StmtKind::Units(name) => {
                    self.set_units(&name.name);
                }
                _ if is_declaration(&statement.kind) => self.header.push(slice(&text, statement.span).into()),
                _ => {}
            }
        }
        self.folder = file.parent().map(Path::to_path_buf);
        Ok(())
    }

    /// Returns true if a text is a complete entry: its brackets and comments are closed, and its
    /// last token can end a statement.
    pub fn is_complete(text: &str) -> bool {
        use Kind::*;
        let mut open = 0i64;
        let lexed = lex(FileId(0), text);
        for token in &lexed.tokens {
            match token.kind {
                OpenParen | OpenBracket | OpenBrace => open += 1,
                CloseParen | CloseBracket | CloseBrace => open -= 1,
                _ => {}
            }
        }
        let kinds: Vec<Kind> = lexed.tokens.iter().map(|token| token.kind).collect();
        let takes_body = matches!(kinds.first(), Some(Function | If | For | While | Switch | Test | Private));
        let unfinished = match kinds.last() {
            Some(CloseParen) => takes_body && ends_with_head(&kinds),
            Some(last) => {
                matches!(last, Plus | Minus | Star | Slash | Comma | Assign | Bind | Else | Do | Try | Arrow)
            }
            None => false,
        };
        // A string cannot span lines, so an unterminated one is an error; a comment can.
        open <= 0 && !unfinished && !lexed.diagnostics.iter().any(|found| found.code == "E0102")
    }

    /// Enters statements or an expression. An entry with errors leaves the session unchanged.
    pub fn enter(&mut self, text: &str) -> Answer {
        let text = text.trim();
        if text.is_empty() {
            return Answer::default();
        }
        if let Some(expression) = as_expression(text) {
            let shown = self.tried(&format!("print({expression});"), false);
            let untold = ["E0303", "E0304"];
            if !shown.1.diagnostics.iter().any(|found| untold.contains(&found.code.as_str())) {
                return self.keep(shown);
            }
            // The expression returns nothing, or a value without a text, such as a gear: show its
            // type.
            let mut ran = self.tried(&format!("{expression};"), false);
            if !ran.1.has_errors() {
                let ty = self.type_of(expression).ok().filter(|ty| ty != "nothing");
                ran.1.lines.extend(ty);
                return self.keep(ran);
            }
            // If both forms fail, show the errors of the form without `print`.
            return self.keep(ran);
        }
        let ended = if text.ends_with([';', '}']) { text.to_owned() } else { format!("{text};") };
        let (module, _) = parse(FileId(0), &ended);
        if let [Stmt { kind: StmtKind::Units(name), .. }] = module.statements.as_slice() {
            let mut changed = self.clone();
            if changed.set_units(&name.name) {
                *self = changed;
                return Answer::default();
            }
        }
        let mut tried = self.tried(&ended, false);
        if tried.1.diagnostics.iter().any(|found| found.code == "E0202") {
            let again = self.tried(&ended, true);
            if !again.1.has_errors() {
                tried = again;
            }
        }
        self.keep(tried)
    }

    /// Returns the type of an expression, as shown to users.
    pub fn type_of(&self, expression: &str) -> Result<String, Box<Answer>> {
        let mut found = None;
        // A symbolic expression has a type too; try both forms of binding.
        for bind in ["=", ":="] {
            let text = format!("var __value {bind} {expression};");
            let (whole, start) = self.with(&text, false);
            let checked = check_program(NAME, &whole, &self.loader());
            let diagnostics = shown(checked.diagnostics, start);
            match checked.types.get("__value") {
                Some(ty) if !has_errors(&diagnostics) => return Ok(ty.clone()),
                _ => found.get_or_insert(Answer { lines: Vec::new(), diagnostics, files: checked.files }),
            };
        }
        Err(Box::new(found.unwrap_or_default()))
    }

    /// Evaluates an expression, or `EXPRESSION to UNIT` in that unit.
    ///
    /// # Errors
    /// The diagnostics of the expression.
    pub fn evaluate(&self, text: &str) -> Result<String, Box<Answer>> {
        let entered = match target_unit(text) {
            None => format!("print({text});"),
            // The comparison reports incompatible units; a quotient alone would accept angles,
            // which are compatible with numbers.
            Some((value, unit)) => format!("({value}) == ({unit});\nprint(({value}) / ({unit}));"),
        };
        let (_, mut answer) = self.tried(&entered, false);
        // A model may mix cycles and angles with a warning; in a conversion this is an error.
        for diagnostic in answer.diagnostics.iter_mut().filter(|d| d.code == "W0518") {
            diagnostic.severity = Severity::Error;
            diagnostic.code = "E0519".into();
        }
        if answer.has_errors() {
            return Err(Box::new(answer));
        }
        let line = answer.lines.into_iter().next_back().unwrap_or_default();
        let (number, rest) = line.split_once(' ').unwrap_or((&line, ""));
        let unit = target_unit(text).map_or(rest, |(_, unit)| unit);
        Ok(match number.parse::<f64>() {
            Ok(number) => format!("{} {unit}", tidy(number)).trim_end().to_owned(),
            Err(_) => line,
        })
    }

    /// Evaluates `EXPRESSION to UNIT`; `None` if the text has another form.
    pub fn converted(&self, text: &str) -> Option<Result<String, Box<Answer>>> {
        let (value, _) = target_unit(text)?;
        // `for (i in ...)`, `function f(in a)` and the like are statements.
        as_expression(value)?;
        Some(self.evaluate(text.trim().trim_end_matches(';')))
    }

    fn loader(&self) -> ModelLoader {
        ModelLoader { folder: self.folder.clone(), ..ModelLoader::default() }
    }

    /// Returns the session's text with another entry, and the offset of this entry.
    fn with(&self, text: &str, opens_block: bool) -> (String, u32) {
        let mut whole = String::new();
        if let Some(units) = &self.units {
            whole += &format!("units {units};\n");
        }
        for part in &self.header {
            whole += part;
            whole.push('\n');
        }
        let mut blocks = 0;
        for entry in &self.entries {
            if entry.opens_block {
                whole += "{\n";
                blocks += 1;
            }
            whole += &entry.text;
            whole.push('\n');
        }
        if opens_block {
            whole += "{\n";
            blocks += 1;
        }
        let start = whole.len() as u32;
        whole += text;
        whole.push('\n');
        whole += &"}\n".repeat(blocks);
        (whole, start)
    }

    /// Runs the session with another entry.
    fn tried(&self, text: &str, opens_block: bool) -> (Session, Answer) {
        let mut next = self.clone();
        let (module, _) = parse(FileId(0), text);
        let (whole, start) = match header_of(&module) {
            // Declarations that are not allowed in a block go before all others.
            true => {
                next.header.push(text.to_owned());
                let (whole, start) = next.with("", false);
                let before = whole.find(text).map_or(start, |at| at as u32);
                (whole, before)
            }
            false => {
                next.entries.push(Entry { text: text.to_owned(), opens_block });
                self.with(text, opens_block)
            }
        };
        let checked = check_program(NAME, &whole, &self.loader());
        let mut answer = Answer {
            lines: Vec::new(),
            diagnostics: shown(checked.diagnostics, start),
            files: checked.files,
        };
        if let Some(program) = &checked.program {
            let (lines, found) = elaborate_printing(program);
            answer.diagnostics.extend(found);
            next.printed = lines.len();
            answer.lines = lines.into_iter().skip(self.printed).collect();
        }
        (next, answer)
    }

    fn keep(&mut self, (next, answer): (Session, Answer)) -> Answer {
        if !answer.has_errors() {
            *self = next;
        }
        answer
    }
}

/// Selects errors, and warnings about the last entry.
fn shown(diagnostics: Vec<Diagnostic>, start: u32) -> Vec<Diagnostic> {
    let new = |found: &Diagnostic| found.primary.span.file == FileId(0) && found.primary.span.start >= start;
    let wanted = |found: &Diagnostic| {
        found.severity == Severity::Error || new(found) && !OF_NO_INTEREST.contains(&found.code.as_str())
    };
    diagnostics.into_iter().filter(wanted).collect()
}

fn is_declaration(kind: &StmtKind) -> bool {
    matches!(kind, StmtKind::Function(_)) || is_header(kind)
}

/// Returns true if a text contains statements that are not allowed in a block.
fn header_of(module: &Module) -> bool {
    !module.statements.is_empty() && module.statements.iter().all(|statement| is_header(&statement.kind))
}

fn is_header(kind: &StmtKind) -> bool {
    matches!(
        kind,
        StmtKind::Import(_)
            | StmtKind::Param(_)
            | StmtKind::Const { .. }
            | StmtKind::Record(_)
            | StmtKind::Enum(_)
            | StmtKind::Dimension { .. }
            | StmtKind::Unit(_)
    )
}

/// Returns the text if it is an expression without a semicolon.
fn as_expression(text: &str) -> Option<&str> {
    let (module, diagnostics) = parse(FileId(0), &format!("{text};"));
    let single = matches!(module.statements.as_slice(), [Stmt { kind: StmtKind::Expr(_), .. }]);
    (single && diagnostics.is_empty()).then_some(text)
}

/// Splits `EXPRESSION to UNIT` or `EXPRESSION in UNIT` at the last such word outside of brackets
/// and strings.
fn target_unit(text: &str) -> Option<(&str, &str)> {
    let (mut depth, mut found) = (0i64, None);
    for token in lex(FileId(0), text).tokens {
        match token.kind {
            Kind::OpenParen | Kind::OpenBracket | Kind::OpenBrace | Kind::InterpolationOpen => depth += 1,
            Kind::CloseParen | Kind::CloseBracket | Kind::CloseBrace | Kind::InterpolationClose => depth -= 1,
            Kind::In if depth == 0 => found = Some(token.span),
            Kind::Identifier if depth == 0 && slice(text, token.span) == "to" => found = Some(token.span),
            _ => {}
        }
    }
    let at = found?;
    let (value, unit) = (&text[..at.start as usize], &text[at.end as usize..]);
    let (value, unit) = (value.trim(), unit.trim());
    (!value.is_empty() && !unit.is_empty()).then_some((value, unit))
}

/// Returns true if a statement ends with the parenthesis of its head, so that its body is missing.
fn ends_with_head(kinds: &[Kind]) -> bool {
    let mut depth = 0i64;
    let mut closed = 0;
    for kind in kinds {
        match kind {
            Kind::OpenParen => depth += 1,
            Kind::CloseParen => {
                depth -= 1;
                closed += i64::from(depth == 0);
            }
            _ => {}
        }
    }
    closed == 1
}

/// Formats a number without the rounding error of a conversion in the sixteenth digit.
fn tidy(value: f64) -> String {
    let all = calyx_abi::text::number(value);
    let rounded = format!("{value:.14e}").parse().map_or(all.clone(), calyx_abi::text::number);
    if rounded.len() + 3 <= all.len() { rounded } else { all }
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.start as usize..span.end as usize).unwrap_or_default()
}
