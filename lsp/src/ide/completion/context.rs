//! What can stand at a cursor: the one place that decides which sources of items are asked.

mod value;

use crate::ide::cursor::{
    Block, BlockKind, Bracket, Call, CursorContext, CursorRegion, OpenDelimiter, Statement,
};
use calyx_lang::ast::Bind;
use calyx_lang::lexer::{Kind, Tokens};
use std::ops::Range;

/// What can stand at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub enum CompletionSite {
    /// Nothing is offered: in comments, numbers and texts, and where a new name is declared.
    Nothing,
    /// The beginning of a statement.
    Statement,
    /// One of a few words, e.g. after `private`.
    Words(Vec<&'static str>),
    /// `import parts.`: what is written of the path.
    Import(Vec<String>),
    /// `units `
    System,
    /// `goto `
    Label,
    /// `... at `
    Symbol,
    /// A type or dimension.
    Type,
    /// `module.` in a type.
    TypeMember(String),
    /// Behind a `.`: the tokens of what stands before it, and the value that is being written.
    Member(Range<usize>, Value),
    /// Behind a number; the words are those of [`CompletionSite::After`].
    Unit(Value, Vec<&'static str>),
    /// In a format: the tokens of the value that is shown.
    FormatUnit(Range<usize>),
    /// Between the quotes of a string that is a whole value; where its text lies.
    Text(Value, Range<usize>),
    /// Where a value begins.
    Value(Value),
    /// Behind a value, where a few words go on.
    After(Vec<&'static str>),
}

/// A value that is being written.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    pub slot: Slot,
    pub operator: Operator,
}

/// What a value is for.
#[derive(Clone, Debug, PartialEq)]
pub enum Slot {
    /// Of a call; the name is given if it is written.
    Argument {
        call: Call,
        name: Option<(String, Bind)>,
    },
    /// `[...]` where the value inside is expected to be an element.
    Element(Box<Value>),
    /// Parentheses.
    Same(Box<Value>),
    Condition,
    /// A whole number, e.g. an index.
    Count,
    /// `var`, `param`, `const`, `output` and a name.
    Initial {
        keyword: Kind,
        name: String,
        bind: Bind,
    },
    /// An end of a range or a choice of the param or parameter whose default these tokens are.
    Bound {
        name: String,
        default: Range<usize>,
    },
    /// Assigned to the place of these tokens.
    Assigned {
        place: Range<usize>,
        bind: Bind,
    },
    /// Of a parameter or field with this type.
    Annotated {
        annotation: Option<Range<usize>>,
        bind: Bind,
    },
    /// The whole of a symbolic function.
    SymbolicBody,
    Returned,
    Thrown,
    /// `case `
    Case,
    /// `at Time = `
    At(String),
    Free,
}

/// What stands before the operand at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub enum Operator {
    /// Nothing: the operand is all there is so far.
    None,
    /// Both operands have one dimension; the tokens of the left one.
    Alike(Range<usize>),
    /// A product or quotient; the tokens before the operator, and whether it divides.
    Factor(Range<usize>, bool),
    /// `^`
    Exponent,
    /// `!`, `&`, `|`
    Truth,
}

/// A cursor and what can stand there.
pub struct Context<'a> {
    pub around: CursorContext<'a>,
    pub statement: Statement,
    pub blocks: Vec<Block>,
    pub spot: CompletionSite,
}

impl<'a> Context<'a> {
    pub fn new(text: &'a str, tokens: &'a Tokens, offset: usize) -> Self {
        let around = CursorContext::new(text, tokens, offset);
        let standing = around.standing(tokens);
        let string = matches!(standing, CursorRegion::Text(_)).then(|| around.string_open()).flatten();
        let statement = around.statement(string.unwrap_or(around.before));
        let blocks = around.blocks(statement.start).collect();
        let mut context = Context { around, statement, blocks, spot: CompletionSite::Nothing };
        context.spot = match standing {
            CursorRegion::Comment | CursorRegion::Number | CursorRegion::Text(None) => {
                CompletionSite::Nothing
            }
            CursorRegion::Text(Some(text)) => context.text(text, string),
            CursorRegion::Code => context.find(),
        };
        context
    }

    /// Whether the cursor is inside a function.
    pub fn in_function(&self) -> bool {
        self.blocks.iter().any(|block| block.kind == BlockKind::Function)
    }

    /// Whether the cursor is in the arguments of one of these functions.
    pub fn takes_expression(&self, functions: &[&str]) -> bool {
        let calls = self.statement.open.iter().filter(|open| open.kind == Bracket::Call);
        calls
            .filter_map(|open| open.at.checked_sub(1))
            .any(|name| functions.contains(&self.around.source(name)))
    }

    /// Whether `:=` keeps what is being written, or something around it.
    pub fn is_symbolic(&self) -> bool {
        let open = &self.statement.open;
        let ends = std::iter::once(self.around.before).chain(open.iter().map(|open| open.at));
        ends.enumerate().any(|(depth, end)| self.value(depth, end).is_symbolic())
    }

    fn kind(&self, at: usize) -> Option<Kind> {
        self.around.kind(at)
    }

    fn find(&self) -> CompletionSite {
        let end = self.around.before;
        let last = self.around.previous(end);
        if let Some(spot) = self.type_spot(end) {
            return spot;
        }
        match self.statement.open.first() {
            Some(open) => match open.kind {
                Bracket::Catch => CompletionSite::Nothing,
                Bracket::Parameters => self.parameter(open.at),
                Bracket::Interpolation => self.interpolated(open.at),
                Bracket::For if last == Some(Kind::OpenParen) => CompletionSite::Words(vec!["var"]),
                _ => self.operand(0, end),
            },
            None => self.plain_statement(end),
        }
    }

    /// A statement without open brackets.
    fn plain_statement(&self, end: usize) -> CompletionSite {
        let start = self.statement.start;
        if start == end {
            return match self.blocks.first().map(|block| block.kind) {
                Some(BlockKind::Record) => CompletionSite::Nothing,
                _ => CompletionSite::Statement,
            };
        }
        // A name on a line of its own begins a statement, though the line above is not ended.
        if self.around.cursor_begins_line() && self.around.ends_expression(end - 1) {
            return CompletionSite::Statement;
        }
        if self.blocks.first().is_some_and(|block| block.kind == BlockKind::Record) {
            return self.declared(start, end);
        }
        let alone = end == start + 1;
        match self.word(start, end) {
            Some(Kind::Import) => CompletionSite::Import(self.path(start + 1, end)),
            Some(Kind::Units) if alone => CompletionSite::System,
            Some(Kind::Goto) if alone => CompletionSite::Label,
            Some(Kind::Private) if alone => {
                CompletionSite::Words(vec!["function", "const", "record", "dimension", "unit"])
            }
            Some(Kind::Extern) if alone => CompletionSite::Words(vec!["pure", "scene", "effect", "function"]),
            Some(Kind::Extern) if end == start + 2 => CompletionSite::Words(vec!["function"]),
            Some(Kind::Host | Kind::Test) if alone => CompletionSite::Words(vec!["function"]),
            Some(Kind::Var) if alone || self.around.previous(end) == Some(Kind::Comma) => {
                CompletionSite::Nothing
            }
            Some(Kind::Function) => match self.around.previous(end) {
                Some(Kind::Bind) => self.operand(0, end),
                _ => CompletionSite::Nothing,
            },
            Some(
                Kind::Param
                | Kind::Const
                | Kind::Output
                | Kind::Record
                | Kind::Dimension
                | Kind::Unit
                | Kind::Units
                | Kind::Goto,
            ) if alone => CompletionSite::Nothing,
            Some(Kind::Break | Kind::Continue | Kind::Units | Kind::Goto | Kind::Record) => {
                CompletionSite::Nothing
            }
            _ => self.operand(0, end),
        }
    }

    /// The word a statement begins with. Words such as `import` are told from names only by the name that follows, which may
    /// not be there yet.
    fn word(&self, start: usize, end: usize) -> Option<Kind> {
        let kind = self.kind(start)?;
        if kind != Kind::Identifier || end != start + 1 {
            return Some(kind);
        }
        Some(match self.around.source(start) {
            "import" => Kind::Import,
            "units" => Kind::Units,
            "param" => Kind::Param,
            "output" => Kind::Output,
            "extern" => Kind::Extern,
            "private" => Kind::Private,
            "host" => Kind::Host,
            "test" => Kind::Test,
            "const" => Kind::Const,
            "record" => Kind::Record,
            "dimension" => Kind::Dimension,
            "unit" => Kind::Unit,
            _ => kind,
        })
    }

    fn path(&self, start: usize, end: usize) -> Vec<String> {
        let names = (start..end).filter(|&at| self.kind(at) == Some(Kind::Identifier));
        names.map(|at| self.around.source(at).to_string()).collect()
    }

    /// `in name: Type = default in range` as far as it is written, in a list of parameters.
    fn parameter(&self, open: usize) -> CompletionSite {
        let end = self.around.before;
        let start = self.after_comma(open + 1, end);
        if start == end {
            return CompletionSite::Words(vec!["in", "out", "inout"]);
        }
        if matches!(self.kind(start), Some(Kind::In | Kind::Out | Kind::InOut)) {
            return self.declared(start + 1, end);
        }
        CompletionSite::Nothing
    }

    /// `name: Type = default in range` as far as it is written; a type is told before.
    fn declared(&self, start: usize, end: usize) -> CompletionSite {
        let assigned = (start..end).find(|&at| matches!(self.kind(at), Some(Kind::Assign | Kind::Bind)));
        let domain = (start..end).any(|at| self.kind(at) == Some(Kind::In));
        if assigned.is_some() || domain {
            return self.operand(0, end);
        }
        CompletionSite::Nothing
    }

    fn interpolated(&self, open: usize) -> CompletionSite {
        let end = self.around.before;
        let format = (open + 1..end).find(|&at| self.kind(at) == Some(Kind::Format));
        match format {
            Some(format)
                if matches!(self.around.previous(end), Some(Kind::Format | Kind::Star | Kind::Slash)) =>
            {
                CompletionSite::FormatUnit(open + 1..format)
            }
            Some(_) => CompletionSite::Nothing,
            None => self.operand(0, end),
        }
    }

    /// The inside of a string.
    fn text(&self, text: Range<usize>, open: Option<usize>) -> CompletionSite {
        match open {
            // Texts are not parts of expressions, but for comparisons.
            Some(open) => match self.value(0, open) {
                Value { operator: Operator::Factor(..) | Operator::Exponent | Operator::Truth, .. } => {
                    CompletionSite::Nothing
                }
                value => CompletionSite::Text(value, text),
            },
            None => CompletionSite::Nothing,
        }
    }

    /// Whether a type belongs before the token `end`.
    fn type_spot(&self, end: usize) -> Option<CompletionSite> {
        let last = end.checked_sub(1)?;
        let begun = match self.kind(last)? {
            Kind::Colon | Kind::Arrow | Kind::Assign | Kind::Star | Kind::Slash | Kind::OpenParen => true,
            Kind::Dot => true,
            Kind::Identifier | Kind::CloseParen | Kind::Number | Kind::Caret => false,
            _ => return None,
        };
        if !self.in_type(end) {
            return None;
        }
        Some(match self.kind(last) {
            Some(Kind::Dot) => {
                CompletionSite::TypeMember(self.around.source(last.checked_sub(1)?).to_string())
            }
            _ if begun => CompletionSite::Type,
            _ if self.around.cursor_begins_line() => return None,
            _ => CompletionSite::Nothing,
        })
    }

    /// Whether what is written before a token, up to a `:`, `->` or `dimension name =`, is part of a type.
    fn in_type(&self, end: usize) -> bool {
        let mut at = end;
        while let Some(before) = at.checked_sub(1) {
            match self.kind(before) {
                Some(
                    Kind::Identifier
                    | Kind::Dot
                    | Kind::Star
                    | Kind::Slash
                    | Kind::Caret
                    | Kind::Number
                    | Kind::Minus
                    | Kind::OpenParen
                    | Kind::CloseParen,
                ) => at = before,
                Some(Kind::Arrow) => return true,
                Some(Kind::Colon) => return self.annotates(before),
                Some(Kind::Assign) => {
                    return before >= 2 && self.kind(before - 2) == Some(Kind::Dimension);
                }
                _ => return false,
            }
        }
        false
    }

    /// Whether a `:` stands before a type, and not after a label or a `case`.
    fn annotates(&self, colon: usize) -> bool {
        let Some(before) = colon.checked_sub(2) else { return false };
        if self.kind(colon - 1) != Some(Kind::Identifier) {
            return false;
        }
        match self.kind(before) {
            Some(Kind::In | Kind::Out | Kind::InOut | Kind::Unit) => true,
            begins => {
                (matches!(begins, Some(Kind::Semicolon | Kind::OpenBrace))
                    || self.around.begins_line(colon - 1))
                    && self.around.block(colon).is_some_and(|block| block.kind == BlockKind::Record)
            }
        }
    }

    /// An operand of an expression, in the brackets `open[depth]`.
    fn operand(&self, depth: usize, end: usize) -> CompletionSite {
        let value = self.value(depth, end);
        let start = self.region(depth, end);
        let Some(last) = end.checked_sub(1).filter(|&last| last >= start) else {
            return CompletionSite::Value(value);
        };
        match self.kind(last) {
            Some(Kind::Dot) => self.member(last, value),
            Some(Kind::At) => CompletionSite::Symbol,
            Some(Kind::Identifier) if self.is_bare_at(last, start) => CompletionSite::Symbol,
            Some(Kind::Number) if !self.around.cursor_begins_line() => match self.behind(depth, start, end) {
                CompletionSite::After(words) => CompletionSite::Unit(value, words),
                _ => CompletionSite::Nothing,
            },
            Some(Kind::CloseParen) if self.closes_condition(last) => CompletionSite::Value(value),
            _ if self.around.ends_expression(last) => self.behind(depth, start, end),
            // `(2 mm)^`, `2 mm^`: a number is typed here.
            Some(Kind::Caret) if last >= 2 && self.kind(last - 2) == Some(Kind::Number) => {
                CompletionSite::Nothing
            }
            _ => CompletionSite::Value(value),
        }
    }

    /// `x at ` before the name that makes `at` a word.
    fn is_bare_at(&self, at: usize, start: usize) -> bool {
        at > start && self.around.source(at) == "at" && self.around.ends_expression(at - 1)
    }

    /// Words that go on behind a value.
    fn behind(&self, depth: usize, start: usize, end: usize) -> CompletionSite {
        // Two operands in a row, on two lines: a `,`, a `;` or an operator is missing.
        if self.around.cursor_begins_line() && depth < self.statement.open.len() {
            let outer = self.around.indentation(self.around.range(self.statement.start).start);
            let begins = self.around.indentation(self.around.word.start) <= outer;
            return if begins { CompletionSite::Statement } else { CompletionSite::Nothing };
        }
        let mut words = Vec::new();
        if self.has_open_choice(start, end) {
            words.push("else");
        }
        if depth == self.statement.open.len()
            && self.kind(self.statement.start) == Some(Kind::Param)
            && !(start..end).any(|at| matches!(self.kind(at), Some(Kind::In | Kind::DotDot)))
        {
            words.push("in");
        }
        if self.kind(end.wrapping_sub(1)) != Some(Kind::Number) {
            words.push("at");
        }
        CompletionSite::After(words)
    }

    /// Whether an `if (c) a` of an expression lacks its `else`.
    fn has_open_choice(&self, start: usize, end: usize) -> bool {
        // `if` at the beginning of a statement is the statement.
        let count = |kind| (start..end).filter(|&at| self.kind(at) == Some(kind)).count();
        count(Kind::If) > count(Kind::Else)
    }

    fn member(&self, dot: usize, value: Value) -> CompletionSite {
        let mut first = dot;
        while let Some(before) = first.checked_sub(1) {
            match self.kind(before) {
                Some(Kind::Identifier) => {
                    first = before;
                    if self.around.previous(first) != Some(Kind::Dot) {
                        break;
                    }
                    first -= 1;
                }
                Some(Kind::CloseParen | Kind::CloseBracket) => match self.around.opening(before) {
                    // `(a + b).x`
                    Some(open) if self.around.previous(open) != Some(Kind::Identifier) => {
                        first = open;
                        break;
                    }
                    Some(open) => first = open,
                    None => break,
                },
                _ => break,
            }
        }
        // The operator before the base decides what is expected.
        let value = Value { operator: self.operator(self.region(0, first), first), ..value };
        CompletionSite::Member(first..dot, value)
    }
}

impl Value {
    /// Whether `:=` keeps the expression that the value is part of.
    pub fn is_symbolic(&self) -> bool {
        match &self.slot {
            Slot::Argument { name: Some((_, bind)), .. }
            | Slot::Initial { bind, .. }
            | Slot::Assigned { bind, .. }
            | Slot::Annotated { bind, .. } => *bind == Bind::Symbolic,
            Slot::SymbolicBody => true,
            Slot::Element(inner) | Slot::Same(inner) => inner.is_symbolic(),
            _ => false,
        }
    }

    /// Whether nothing but the operand at the cursor is written of the value.
    pub fn is_first(&self) -> bool {
        self.operator == Operator::None
    }
}
