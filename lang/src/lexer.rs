//! Lexer: converts text to tokens. It never fails: invalid characters are reported and skipped.
//!
//! Tokens contain only their source range; the parser decodes their text. Strings with interpolated
//! expressions become a flat sequence of tokens (`StringOpen StringText InterpolationOpen ...
//! InterpolationClose StringClose`).

mod token;

pub use token::{Comment, CommentKind, Kind, Token, Tokens, keywords};

use crate::diagnostic::Diagnostic;
use crate::span::{FileId, Span};
use token::{ByFirstByte, CONTEXTUAL_BY_BYTE, KEYWORDS_BY_BYTE, SYMBOLS, SYMBOLS_BY_BYTE, Spelling};

pub fn lex(file: FileId, text: &str) -> Tokens {
    let mut lexer = Lexer {
        file,
        text,
        at: 0,
        keywords: &KEYWORDS_BY_BYTE,
        symbols: &SYMBOLS_BY_BYTE,
        out: Tokens::default(),
        open_strings: Vec::new(),
        doc: None,
        lines_since_doc: 0,
    };
    lexer.run();
    let mut tokens = lexer.out;
    mark_contextual_words(&mut tokens.tokens, text);
    tokens
}

/// Marks contextual keywords: `param torque` is a declaration, but `param` in `param + 1` is a
/// variable. Elsewhere, two names are never adjacent.
fn mark_contextual_words(tokens: &mut [Token], text: &str) {
    let contextual = &*CONTEXTUAL_BY_BYTE;
    for i in 0..tokens.len() {
        let token = tokens[i];
        if token.kind != Kind::Identifier {
            continue;
        }
        let word = &text[token.span.start as usize..token.span.end as usize];
        let Some(kind) = spelled(contextual, word) else { continue };
        let next = tokens.get(i + 1).map(|t| t.kind);
        // In `param at Time = 0 s` and `param is none`, `param` is a variable. In `in unit was
        // length: Length`, `unit` is a parameter. In `record at was place {`, `record` is a
        // keyword.
        let word_at = |at: usize| {
            let token = tokens.get(at).filter(|t| t.kind == Kind::Identifier)?;
            Some(&text[token.span.start as usize..token.span.end as usize])
        };
        let (next_word, name_follows) = (word_at(i + 1), word_at(i + 2).is_some());
        let is_name = match (next_word, word_at(i + 2)) {
            (Some("at" | "was"), Some(_)) => word_at(i + 3).is_none(),
            (Some("is"), Some("none")) => true,
            (Some("is"), Some("not")) => word_at(i + 3) == Some("none"),
            _ => false,
        };
        let previous = i.checked_sub(1).map(|p| tokens[p].kind);
        // In `import param as p`, it is a module.
        let module =
            matches!(previous, Some(Kind::Import | Kind::Dot)) && next_word == Some("as") && name_follows;
        let is_word = match kind {
            Kind::At => next == Some(Kind::Identifier) && previous.is_some_and(Kind::ends_expression),
            Kind::Is => {
                let tests = match next_word {
                    Some("not") => word_at(i + 2) == Some("none"),
                    word => word == Some("none"),
                };
                previous.is_some_and(Kind::ends_expression) && tests
            }
            Kind::Extern | Kind::Private => matches!(next, Some(Kind::Identifier | Kind::Function)),
            Kind::Host | Kind::Test => next == Some(Kind::Function),
            Kind::Import => matches!(next, Some(Kind::Identifier | Kind::StringOpen)),
            _ => next == Some(Kind::Identifier),
        };
        if is_word && !module && !is_name {
            tokens[i].kind = kind;
        }
    }
}

/// Returns the kind of a word in a table.
fn spelled(table: &ByFirstByte, word: &str) -> Option<Kind> {
    let found = table.of(word.as_bytes()).iter().find(|(w, _, _)| *w == word);
    found.map(|(_, kind, _)| *kind)
}

struct OpenString {
    start: usize,
    /// `true` within an interpolated expression of this string.
    interpolating: bool,
}

struct Lexer<'a> {
    file: FileId,
    text: &'a str,
    at: usize,
    keywords: &'static ByFirstByte,
    symbols: &'static ByFirstByte,
    out: Tokens,
    /// The open strings, outermost first.
    open_strings: Vec<OpenString>,
    /// The `///` block under construction.
    doc: Option<String>,
    /// Number of line ends since its last line.
    lines_since_doc: usize,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn span(&self, start: usize) -> Span {
        Span::new(self.file, start, self.at)
    }

    fn push(&mut self, kind: Kind, start: usize) {
        if let Some(doc) = self.take_doc() {
            self.out.docs.insert(self.out.tokens.len(), doc);
        }
        self.out.tokens.push(Token { kind, span: self.span(start) });
    }

    /// Takes the `///` block if it is directly above. A block followed by a blank line documents
    /// only the file.
    fn take_doc(&mut self) -> Option<String> {
        let doc = self.doc.take()?;
        if self.lines_since_doc <= 1 {
            return Some(doc);
        }
        if self.out.tokens.is_empty() && self.out.file_doc.is_none() {
            self.out.file_doc = Some(doc);
        }
        None
    }

    fn error(&mut self, code: &str, message: impl Into<String>, span: Span, label: &str, help: &str) {
        self.out.diagnostics.push(Diagnostic::error(code, message, span, label).help(help));
    }

    fn run(&mut self) {
        // Skip a byte order mark.
        if self.text.starts_with('\u{feff}') {
            self.at = '\u{feff}'.len_utf8();
        }
        while let Some(c) = self.peek() {
            let start = self.at;
            match c {
                '\n' => {
                    self.close_strings("the line ends inside the string");
                    self.lines_since_doc += 1;
                    self.at += 1;
                }
                ' ' => self.at += self.rest().bytes().take_while(|byte| *byte == b' ').count(),
                _ if c.is_whitespace() => self.at += c.len_utf8(),
                '/' if self.rest().starts_with("//") => self.line_comment(),
                '/' if self.rest().starts_with("/*") => self.block_comment(),
                '"' => self.string(start),
                '\'' => self.single_quoted(start),
                '}' if !self.open_strings.is_empty() => {
                    self.at += 1;
                    self.push(Kind::InterpolationClose, start);
                    self.set_interpolating(false);
                    self.string_text();
                }
                ':' if self.interpolating() && !self.rest().starts_with(":=") => self.format(start),
                '0'..='9' => self.number(start),
                '.' if self.rest()[1..].starts_with(|d: char| d.is_ascii_digit()) => self.number(start),
                '#' => self.foreign_comment(start),
                _ if c.is_alphabetic() || c == '_' => self.word(start),
                _ => self.symbol(start),
            }
        }
        self.close_strings("the file ends inside it");
        let _ = self.take_doc();
    }

    fn line_comment(&mut self) {
        let length = self.rest().find('\n').unwrap_or(self.rest().len());
        let line = self.rest()[..length].trim_end();
        let span = Span::new(self.file, self.at, self.at + line.len());
        let mut kind = CommentKind::Line;
        // `////` is a separator line, not documentation.
        if let Some(content) = line.strip_prefix("///").filter(|rest| !rest.starts_with('/')) {
            kind = CommentKind::Doc;
            let content = content.strip_prefix(' ').unwrap_or(content).to_string();
            match self.take_doc() {
                Some(above) => self.doc = Some(above + "\n" + &content),
                None => self.doc = Some(content),
            }
            self.lines_since_doc = 0;
        }
        self.out.comments.push(Comment { kind, span });
        self.at += length;
    }

    /// Skips a `# ...` comment of other languages, up to the end of the line.
    fn foreign_comment(&mut self, start: usize) {
        self.at += 1;
        let span = self.span(start);
        let problem =
            Diagnostic::error("E0101", "`#` does not start a comment", span, "not part of the language");
        self.out.diagnostics.push(problem.help("write `//`").fix("write `//`", span, "//"));
        self.at += self.rest().find('\n').unwrap_or(self.rest().len());
    }

    fn block_comment(&mut self) {
        let start = self.at;
        match self.rest()[2..].find("*/") {
            Some(length) => self.at += length + 4,
            None => {
                self.at += 2;
                let span = self.span(start);
                self.error("E0102", "this comment is not closed", span, "starts here", "close it with `*/`");
                self.at = self.text.len();
            }
        }
        let span = self.span(start);
        self.out.comments.push(Comment { kind: CommentKind::Block, span });
    }

    fn number(&mut self, start: usize) {
        self.digits();
        let fraction = self.rest().strip_prefix('.').is_some_and(|rest| !rest.starts_with('.'));
        if fraction {
            self.at += 1;
            self.digits();
        }
        if let Some(exponent) = self.rest().strip_prefix(['e', 'E']) {
            let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
            if digits.starts_with(|d: char| d.is_ascii_digit()) {
                self.at = self.text.len() - digits.len();
                self.digits();
            }
        }
        let second_point =
            self.rest().strip_prefix('.').is_some_and(|r| r.starts_with(|d: char| d.is_ascii_digit()));
        if second_point || self.rest().starts_with('_') {
            while self.peek().is_some_and(|c| c.is_ascii_alphanumeric() || c == '_' || c == '.') {
                self.at += 1;
            }
            let span = self.span(start);
            let mut problem = Diagnostic::error("E0105", "this is not a number", span, "malformed")
                .help("write numbers as `1250`, `0.15708` or `3e7`");
            let written = &self.text[start..self.at];
            if written.bytes().all(|b| b.is_ascii_digit() || b == b'_') && !written.ends_with('_') {
                let digits = written.replace('_', "");
                problem = problem.fix(format!("write `{digits}`"), span, digits);
            }
            self.out.diagnostics.push(problem);
        } else if self.text[start..self.at].parse::<f64>().is_ok_and(f64::is_infinite) {
            let span = self.span(start);
            let problem = Diagnostic::error("E0105", "this number is too large", span, "beyond 1.8e308");
            let problem = problem.help("write `inf` for infinity").suggest("write `inf`", span, "inf");
            self.out.diagnostics.push(problem);
        }
        self.push(Kind::Number, start);
    }

    /// Returns `true` within an expression between the braces of a string.
    fn interpolating(&self) -> bool {
        self.open_strings.last().is_some_and(|open| open.interpolating)
    }

    /// Reads `: 10.3e` in an interpolation, up to the unit.
    fn format(&mut self, start: usize) {
        self.at += 1;
        let blanks = self.rest().len() - self.rest().trim_start_matches([' ', '\t']).len();
        self.at += blanks;
        let spec = self.at;
        self.digits();
        // `1/mm` is a unit.
        if self.rest().trim_start_matches([' ', '\t']).starts_with('/') {
            self.at = spec;
        }
        if self.rest().starts_with('.') {
            self.at += 1;
            self.digits();
        }
        let word = |c: char| c.is_alphanumeric() || c == '_';
        if self.rest().strip_prefix('e').is_some_and(|rest| !rest.starts_with(word)) {
            self.at += 1;
        }
        self.push(Kind::Format, start);
    }

    fn digits(&mut self) {
        self.at += self.rest().bytes().take_while(u8::is_ascii_digit).count();
    }

    fn word(&mut self, start: usize) {
        let rest = self.rest();
        let simple = rest.bytes().take_while(|byte| byte.is_ascii_alphanumeric() || *byte == b'_').count();
        let others = &rest[simple..];
        let more = others.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(others.len());
        let length = simple + more;
        let word = &rest[..length];
        let kind = spelled(self.keywords, word).unwrap_or(Kind::Identifier);
        self.at += length;
        self.push(kind, start);
    }

    fn symbol(&mut self, start: usize) {
        let rest = self.rest().as_bytes();
        let begins = |(spelling, _, _): &&Spelling| rest.starts_with(spelling.as_bytes());
        if let Some(&(spelling, kind, _)) = self.symbols.of(rest).iter().find(begins) {
            self.at += spelling.len();
            self.push(kind, start);
            return;
        }
        // Consecutive invalid characters are reported once.
        let begins_token = |c: char| {
            c.is_whitespace()
                || c.is_alphanumeric()
                || "_\"'".contains(c)
                || SYMBOLS.iter().any(|(s, _, _)| s.starts_with(c))
        };
        self.at += self.peek().map_or(0, char::len_utf8);
        let rest = self.rest();
        self.at += rest.find(begins_token).unwrap_or(rest.len());
        let shown: String = self.text[start..self.at].chars().take(10).collect();
        let span = self.span(start);
        let message = format!("unexpected character `{}`", shown.escape_debug());
        let problem = Diagnostic::error("E0101", message, span, "not part of the language");
        self.out.diagnostics.push(problem.help("remove it").suggest("remove it", span, ""));
    }

    fn single_quoted(&mut self, start: usize) {
        self.at += 1;
        let line = self.rest().find('\n').unwrap_or(self.rest().len());
        let content_end = self.rest()[..line].find('\'');
        self.push(Kind::StringOpen, start);
        let content_start = self.at;
        self.at += content_end.unwrap_or(line);
        if self.at > content_start {
            self.push(Kind::StringText, content_start);
        }
        let close = self.at;
        self.at += usize::from(content_end.is_some());
        self.push(Kind::StringClose, close);
        let span = self.span(start);
        let fixed = format!("\"{}\"", &self.text[content_start..close]);
        let mut problem =
            Diagnostic::error("E0103", "strings need double quotes", span, "single quotes").help("use `\"`");
        if content_end.is_some() && !fixed[1..fixed.len() - 1].contains(['"', '{', '}', '\\']) {
            problem = problem.fix("use double quotes", span, fixed);
        }
        self.out.diagnostics.push(problem);
    }

    fn string(&mut self, start: usize) {
        self.at += 1;
        self.push(Kind::StringOpen, start);
        self.open_strings.push(OpenString { start, interpolating: false });
        self.string_text();
    }

    /// Reads literal text up to the closing quote, an interpolation, or the end of the line.
    fn string_text(&mut self) {
        let start = self.at;
        loop {
            let here = self.at;
            let rest = &self.text[here..];
            let Some(c) = rest.chars().next() else { break };
            if c == '\n' {
                break;
            }
            if rest.starts_with("{{") || rest.starts_with("}}") {
                self.at += 2;
            } else if c == '"' {
                self.flush_text(start, here);
                self.at = here + 1;
                self.push(Kind::StringClose, here);
                self.open_strings.pop();
                return;
            } else if c == '{' {
                self.flush_text(start, here);
                self.at = here + 1;
                self.push(Kind::InterpolationOpen, here);
                self.set_interpolating(true);
                return;
            } else if c == '}' {
                self.at += 1;
                let span = self.span(here);
                self.out.diagnostics.push(
                    Diagnostic::error(
                        "E0104",
                        "`}` in a string has no matching `{`",
                        span,
                        "no matching `{`",
                    )
                    .help("write `}}` for the character itself")
                    .fix("write `}}`", span, "}}"),
                );
            } else if c == '\\' {
                self.escape(here);
            } else {
                self.at += c.len_utf8();
            }
        }
        let end = self.at;
        self.flush_text(start, end);
    }

    fn flush_text(&mut self, start: usize, end: usize) {
        self.at = end;
        if end > start {
            self.push(Kind::StringText, start);
        }
    }

    fn escape(&mut self, start: usize) {
        self.at += 1;
        match self.peek() {
            Some('n' | 't' | '"' | '\\') => self.at += 1,
            // The unterminated string is reported at the end of the line.
            None | Some('\n') => {}
            Some(other) => {
                self.at += other.len_utf8();
                let span = self.span(start);
                let message = format!("`\\{}` is not an escape", other.escape_debug());
                let help = "the escapes are `\\n`, `\\t`, `\\\"` and `\\\\`; braces are doubled";
                let problem = Diagnostic::error("E0104", message, span, "unknown escape").help(help);
                // A Windows path, or a character that needs no escape.
                let doubled = format!("\\{}", &self.text[start..self.at]);
                self.out.diagnostics.push(problem.suggest("write `\\\\`", span, doubled));
            }
        }
    }

    /// Closes all strings that are open at the end of a line, so that the next line is lexed
    /// independently.
    fn close_strings(&mut self, reason: &str) {
        let Some(outermost) = self.open_strings.first() else { return };
        let span = Span::new(self.file, outermost.start, self.at);
        let help = "close it with `\"` on the same line; `\\n` stands for a line end";
        self.error("E0103", "this string is not closed", span, reason, help);
        while let Some(open) = self.open_strings.pop() {
            let here = self.at;
            if open.interpolating {
                self.push(Kind::InterpolationClose, here);
            }
            self.push(Kind::StringClose, here);
        }
    }

    fn set_interpolating(&mut self, interpolating: bool) {
        if let Some(open) = self.open_strings.last_mut() {
            open.interpolating = interpolating;
        }
    }
}

/// Returns the characters that a `StringText` token represents. Unknown escapes (already reported)
/// are copied as written.
pub fn unescape(raw: &str) -> String {
    let mut text = String::with_capacity(raw.len());
    let mut characters = raw.chars().peekable();
    while let Some(c) = characters.next() {
        match (c, characters.peek()) {
            ('{', Some('{')) | ('}', Some('}')) => {
                characters.next();
                text.push(c);
            }
            ('\\', Some(&escaped)) => {
                characters.next();
                match escaped {
                    'n' => text.push('\n'),
                    't' => text.push('\t'),
                    '"' | '\\' => text.push(escaped),
                    _ => text.extend(['\\', escaped]),
                }
            }
            _ => text.push(c),
        }
    }
    text
}
