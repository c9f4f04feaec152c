//! A conversation with the language: statements and expressions one after another, state kept (`calyx repl`, `calyx eval`).
//!
//! A session is a model that grows by what is entered. Each entry runs the whole model again, interpreted, without solving
//! anything, and shows what it printed anew. So there is one meaning of the language and no second evaluator, errors leave
//! no trace, and a definition can be replaced.

use calyx_elaborate::diagnostics::has_errors;
use calyx_elaborate::{ModelLoader, elaborate_printing};
use calyx_lang::ast::{Module, Stmt, StmtKind};
use calyx_lang::check::check_program;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::SourceFile;
use calyx_lang::lexer::{Kind, lex};
use calyx_lang::parser::parse;
use calyx_lang::span::{FileId, Span};
use calyx_lang::units::UnitSystem;
use std::io;
use std::path::{Path, PathBuf};

/// As diagnostics show the text that was entered.
const NAME: &str = "input";

/// Findings about what a person has not come to use yet, or typed to see its value.
const OF_NO_INTEREST: [&str; 2] = ["W0201", "W0203"];

/// What an entry gave.
#[derive(Default)]
pub struct Answer {
    /// Lines it printed.
    pub lines: Vec<String>,
    pub diagnostics: Vec<Diagnostic>,
    pub files: Vec<SourceFile>,
}

impl Answer {
    pub fn has_errors(&self) -> bool {
        has_errors(&self.diagnostics)
    }
}

/// What was entered so far.
#[derive(Clone, Default)]
pub struct Session {
    /// Unit system, if one was chosen.
    units: Option<String>,
    /// Statements that stand outside blocks: imports, params, declarations of a file.
    header: Vec<String>,
    entries: Vec<Entry>,
    /// Lines the entries print.
    printed: usize,
    folder: Option<PathBuf>,
}

#[derive(Clone)]
struct Entry {
    text: String,
    /// It declares a name again, so it and what follows stand in a block of their own.
    opens_block: bool,
}

impl Session {
    pub fn new() -> Session {
        Session::default()
    }

    /// Shows results in a unit system, and takes bare literals in it. False if there is no such system.
    pub fn set_units(&mut self, name: &str) -> bool {
        let known = UnitSystem::from_name(name).is_some();
        if known {
            self.units = Some(name.to_owned());
        }
        known
    }

    /// Declarations of a file: everything but what it runs.
    ///
    /// # Errors
    /// The file cannot be read.
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

    /// Whether a text can be entered as it is: its brackets and comments are closed, and it does not end where something
    /// must follow.
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
        // A string cannot go over a line, so one without end is an error at once; a comment can.
        open <= 0 && !unfinished && !lexed.diagnostics.iter().any(|found| found.code == "E0102")
    }

    /// Enters statements or an expression. What is wrong leaves the session as it was.
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
            // A call that returns nothing, or something that has no text, such as a gear: its type is said instead.
            let mut ran = self.tried(&format!("{expression};"), false);
            if !ran.1.has_errors() {
                let ty = self.type_of(expression).ok().filter(|ty| ty != "nothing");
                ran.1.lines.extend(ty);
                return self.keep(ran);
            }
            // Of two ways to be wrong the one without the printing is the user's.
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

    /// The type of an expression, as shown to people.
    pub fn type_of(&self, expression: &str) -> Result<String, Box<Answer>> {
        let mut found = None;
        // A symbolic expression has a type too; whichever form is sound says it.
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

    /// The value of an expression, or of `EXPRESSION to UNIT` in that unit.
    ///
    /// # Errors
    /// What is wrong with the expression.
    pub fn evaluate(&self, text: &str) -> Result<String, Box<Answer>> {
        let entered = match target_unit(text) {
            None => format!("print({text});"),
            // The comparison says what does not fit; angles are soft, so a quotient alone would not.
            Some((value, unit)) => format!("({value}) == ({unit});\nprint(({value}) / ({unit}));"),
        };
        let (_, mut answer) = self.tried(&entered, false);
        // A model may mix cycles and angles after a warning; a conversion may not.
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

    /// The value of `EXPRESSION to UNIT`; `None` if the text has another form.
    pub fn converted(&self, text: &str) -> Option<Result<String, Box<Answer>>> {
        let (value, _) = target_unit(text)?;
        // `for (i in ...)`, `function f(in a)` and the like are statements.
        as_expression(value)?;
        Some(self.evaluate(text.trim().trim_end_matches(';')))
    }

    fn loader(&self) -> ModelLoader {
        ModelLoader { folder: self.folder.clone(), ..ModelLoader::default() }
    }

    /// The session's text with another entry, and where that begins.
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

    /// The session with another entry, and what that gives.
    fn tried(&self, text: &str, opens_block: bool) -> (Session, Answer) {
        let mut next = self.clone();
        let (module, _) = parse(FileId(0), text);
        let (whole, start) = match header_of(&module) {
            // Declarations that cannot stand in a block go before all others.
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

/// Errors, and warnings about what was entered last.
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

/// Whether a text holds statements that cannot stand in a block.
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
            | StmtKind::Dimension { .. }
            | StmtKind::Unit(_)
    )
}

/// The text as an expression, if it is one without a semicolon.
fn as_expression(text: &str) -> Option<&str> {
    let (module, diagnostics) = parse(FileId(0), &format!("{text};"));
    let single = matches!(module.statements.as_slice(), [Stmt { kind: StmtKind::Expr(_), .. }]);
    (single && diagnostics.is_empty()).then_some(text)
}

/// `EXPRESSION to UNIT` or `EXPRESSION in UNIT`, split at the last such word outside brackets and strings.
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

/// Whether a statement ends with the parenthesis of its head, so that its body is still to come.
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

/// A number for people: without the noise that a conversion leaves in the sixteenth digit.
fn tidy(value: f64) -> String {
    let all = calyx_abi::text::number(value);
    let rounded = format!("{value:.14e}").parse().map_or(all.clone(), calyx_abi::text::number);
    if rounded.len() + 3 <= all.len() { rounded } else { all }
}

fn slice(text: &str, span: Span) -> &str {
    text.get(span.start as usize..span.end as usize).unwrap_or_default()
}
