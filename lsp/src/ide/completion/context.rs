//! Determines the syntactic category at a cursor, and thereby which sources of items are used.

mod value;

use crate::ide::cursor::{
    Block, BlockKind, Bracket, Call, CursorContext, CursorRegion, OpenDelimiter, Statement,
};
use calyx_lang::ast::Bind;
use calyx_lang::lexer::{Kind, Tokens};
use std::ops::Range;

/// Syntactic category at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub enum CompletionSite {
    /// No completion: in comments, numbers and texts, and for a new name in a declaration.
    Nothing,
    /// Start of a statement.
    Statement,
    /// One of a few words, such as after `private`.
    Words(Vec<&'static str>),
    /// `import parts.`: the written part of the path.
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
    /// After a `.`: the tokens of the base, and the value that contains them.
    Member(Range<usize>, Value),
    /// After a number; the words are those of [`CompletionSite::After`].
    Unit(Value, Vec<&'static str>),
    /// In a format, or after the `in` of an output: the tokens of the value.
    FormatUnit(Range<usize>),
    /// Between the quotes of a string that is the whole value; the range of its text.
    Text(Value, Range<usize>),
    /// Start of a value.
    Value(Value),
    /// After a value, where one of these words may follow.
    After(Vec<&'static str>),
}

/// An incomplete value.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    pub slot: Slot,
    pub operator: Operator,
}

/// Receiver of a value.
#[derive(Clone, Debug, PartialEq)]
pub enum Slot {
    /// Argument of a call, with its name if it is written.
    Argument {
        call: Call,
        name: Option<(String, Bind)>,
    },
    /// `[...]`, where the value inside is an element.
    Element(Box<Value>),
    /// Parentheses: the same value.
    Same(Box<Value>),
    Condition,
    /// An integer, such as an index.
    Count,
    /// Initial value in `var`, `param`, `const` or `output` with a name.
    Initial {
        keyword: Kind,
        name: String,
        bind: Bind,
    },
    /// Bound of a range or choice of the param or parameter whose default has these tokens.
    Bound {
        name: String,
        default: Range<usize>,
    },
    /// Assignment to the place of these tokens.
    Assigned {
        place: Range<usize>,
        bind: Bind,
    },
    /// Value of a parameter or field with this type.
    Annotated {
        annotation: Option<Range<usize>>,
        bind: Bind,
    },
    /// Body of a symbolic function.
    SymbolicBody,
    Returned,
    Thrown,
    /// `case `
    Case,
    /// `at Time = `
    At(String),
    Free,
}

/// Operator before the operand at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub enum Operator {
    /// No operator: the first operand.
    None,
    /// Operator whose operands have the same dimension; the tokens of the left one.
    Alike(Range<usize>),
    /// Product or quotient; the tokens before the operator, and true for a division.
    Factor(Range<usize>, bool),
    /// `^`
    Exponent,
    /// `!`, `&`, `|`
    Truth,
}

/// A cursor and its syntactic category.
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

    /// Returns true if the cursor is inside a function.
    pub fn in_function(&self) -> bool {
        self.blocks.iter().any(|block| block.kind == BlockKind::Function)
    }

    /// Returns true if the cursor is in the arguments of one of these functions.
    pub fn takes_expression(&self, functions: &[&str]) -> bool {
        let calls = self.statement.open.iter().filter(|open| open.kind == Bracket::Call);
        calls
            .filter_map(|open| open.at.checked_sub(1))
            .any(|name| functions.contains(&self.around.source(name)))
    }

    /// Returns true if `:=` binds the incomplete value, or an expression around it.
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

    /// Classifies a cursor in a statement without open delimiters.
    fn plain_statement(&self, end: usize) -> CompletionSite {
        let start = self.statement.start;
        if start == end {
            return match self.blocks.first().map(|block| block.kind) {
                Some(BlockKind::Record) => CompletionSite::Nothing,
                _ => CompletionSite::Statement,
            };
        }
        // A name at the start of a line starts a statement, even if the previous line is
        // incomplete.
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
            Some(Kind::Private) if alone => CompletionSite::Words(vec![
                "function",
                "component",
                "const",
                "record",
                "enum",
                "dimension",
                "unit",
            ]),
            Some(Kind::Extern) if alone => CompletionSite::Words(vec!["pure", "scene", "effect", "function"]),
            Some(Kind::Extern) if end == start + 2 => CompletionSite::Words(vec!["function"]),
            Some(Kind::Host | Kind::Test) if alone => CompletionSite::Words(vec!["function"]),
            Some(Kind::Var) if alone || self.around.previous(end) == Some(Kind::Comma) => {
                CompletionSite::Nothing
            }
            Some(Kind::Function | Kind::Component) => match self.around.previous(end) {
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

    /// Returns the keyword at the start of a statement. Contextual keywords such as `import` are
    /// distinguished from names only by the name that follows, which may be missing.
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
            "enum" => Kind::Enum,
            "component" => Kind::Component,
            "dimension" => Kind::Dimension,
            "unit" => Kind::Unit,
            _ => kind,
        })
    }

    fn path(&self, start: usize, end: usize) -> Vec<String> {
        let names = (start..end).filter(|&at| self.kind(at) == Some(Kind::Identifier));
        names.map(|at| self.around.source(at).to_string()).collect()
    }

    /// Classifies a cursor in a parameter declaration, `in name: Type = default in range` as far as
    /// it is written.
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

    /// Classifies a cursor in `name: Type = default in range` as far as it is written; the type is
    /// handled by the caller.
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

    /// Classifies a cursor in a string.
    fn text(&self, text: Range<usize>, open: Option<usize>) -> CompletionSite {
        match open {
            // Texts are operands of comparisons only.
            Some(open) => match self.value(0, open) {
                Value { operator: Operator::Factor(..) | Operator::Exponent | Operator::Truth, .. } => {
                    CompletionSite::Nothing
                }
                value => CompletionSite::Text(value, text),
            },
            None => CompletionSite::Nothing,
        }
    }

    /// Classifies a cursor before the token `end` if a type is expected there.
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

    /// Returns true if the tokens before `end`, back to a `:`, `->` or `dimension name =`, are part
    /// of a type.
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

    /// Returns true if a `:` precedes a type, and does not end a label or a `case`.
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

    /// Classifies a cursor at an operand of an expression, in the delimiters `open[depth]`.
    fn operand(&self, depth: usize, end: usize) -> CompletionSite {
        let value = self.value(depth, end);
        let start = self.region(depth, end);
        if let Some(shown) = self.shown_value(depth, start) {
            let joins = start == end || matches!(self.kind(end - 1), Some(Kind::Star | Kind::Slash));
            return if joins { CompletionSite::FormatUnit(shown) } else { CompletionSite::Nothing };
        }
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
            // `(2 mm)^`, `2 mm^`: a number is expected.
            Some(Kind::Caret) if last >= 2 && self.kind(last - 2) == Some(Kind::Number) => {
                CompletionSite::Nothing
            }
            _ => CompletionSite::Value(value),
        }
    }

    /// Returns true if `at` is a keyword although no name follows it: `x at `.
    fn is_bare_at(&self, at: usize, start: usize) -> bool {
        at > start && self.around.source(at) == "at" && self.around.ends_expression(at - 1)
    }

    /// Returns the category after a value, where keywords may follow.
    fn behind(&self, depth: usize, start: usize, end: usize) -> CompletionSite {
        // Two consecutive operands on two lines: a `,`, a `;` or an operator is missing.
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
            && matches!(self.kind(self.statement.start), Some(Kind::Param | Kind::Output))
            && !(start..end).any(|at| matches!(self.kind(at), Some(Kind::In | Kind::DotDot)))
        {
            words.push("in");
        }
        if self.kind(end.wrapping_sub(1)) != Some(Kind::Number) {
            words.push("at");
        }
        CompletionSite::After(words)
    }

    /// Returns the tokens of an output's value if the region from the token `start` is its unit.
    fn shown_value(&self, depth: usize, start: usize) -> Option<Range<usize>> {
        let output = self.statement.start;
        let outside = depth == self.statement.open.len() && self.kind(output) == Some(Kind::Output);
        let stated = start.checked_sub(1).filter(|&at| outside && self.kind(at) == Some(Kind::In))?;
        let bind = (output..stated).find(|&at| self.kind(at) == Some(Kind::Bind))?;
        Some(bind + 1..stated)
    }

    /// Returns true if an `if (c) a` expression lacks its `else`.
    fn has_open_choice(&self, start: usize, end: usize) -> bool {
        // `if` at the start of a statement is a statement.
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
        // The operator before the base determines the expected type.
        let value = Value { operator: self.operator(self.region(0, first), first), ..value };
        CompletionSite::Member(first..dot, value)
    }
}

impl Value {
    /// Returns true if `:=` binds the expression that contains the value.
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

    /// Returns true if the value consists of the operand at the cursor only.
    pub fn is_first(&self) -> bool {
        self.operator == Operator::None
    }
}
