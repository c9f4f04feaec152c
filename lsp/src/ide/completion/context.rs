//! What can stand at a cursor: the one place that decides which sources of items are asked.

use crate::ide::cursor::{Around, Block, BlockKind, Bracket, Call, Open, Standing, Statement};
use calyx_lang::ast::Bind;
use calyx_lang::lexer::{Kind, Tokens};
use std::ops::Range;

/// What can stand at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub enum Spot {
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
    /// Behind a number; the words are those of [`Spot::After`].
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
    pub around: Around<'a>,
    pub statement: Statement,
    pub blocks: Vec<Block>,
    pub spot: Spot,
}

impl<'a> Context<'a> {
    pub fn new(text: &'a str, tokens: &'a Tokens, offset: usize) -> Self {
        let around = Around::new(text, tokens, offset);
        let standing = around.standing(tokens);
        let string = matches!(standing, Standing::Text(_)).then(|| around.string_open()).flatten();
        let statement = around.statement(string.unwrap_or(around.before));
        let blocks = around.blocks(statement.start).collect();
        let mut context = Context { around, statement, blocks, spot: Spot::Nothing };
        context.spot = match standing {
            Standing::Comment | Standing::Number | Standing::Text(None) => Spot::Nothing,
            Standing::Text(Some(text)) => context.text(text, string),
            Standing::Code => context.find(),
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

    fn find(&self) -> Spot {
        let end = self.around.before;
        let last = self.around.previous(end);
        if let Some(spot) = self.type_spot(end) {
            return spot;
        }
        match self.statement.open.first() {
            Some(open) => match open.kind {
                Bracket::Catch => Spot::Nothing,
                Bracket::Parameters => self.parameter(open.at),
                Bracket::Interpolation => self.interpolated(open.at),
                Bracket::For if last == Some(Kind::OpenParen) => Spot::Words(vec!["var"]),
                _ => self.operand(0, end),
            },
            None => self.plain_statement(end),
        }
    }

    /// A statement without open brackets.
    fn plain_statement(&self, end: usize) -> Spot {
        let start = self.statement.start;
        if start == end {
            return match self.blocks.first().map(|block| block.kind) {
                Some(BlockKind::Record) => Spot::Nothing,
                _ => Spot::Statement,
            };
        }
        // A name on a line of its own begins a statement, though the line above is not ended.
        if self.around.cursor_begins_line() && self.around.ends_expression(end - 1) {
            return Spot::Statement;
        }
        if self.blocks.first().is_some_and(|block| block.kind == BlockKind::Record) {
            return self.declared(start, end);
        }
        let alone = end == start + 1;
        match self.word(start, end) {
            Some(Kind::Import) => Spot::Import(self.path(start + 1, end)),
            Some(Kind::Units) if alone => Spot::System,
            Some(Kind::Goto) if alone => Spot::Label,
            Some(Kind::Private) if alone => {
                Spot::Words(vec!["function", "const", "record", "dimension", "unit"])
            }
            Some(Kind::Extern) if alone => Spot::Words(vec!["pure", "scene", "effect", "function"]),
            Some(Kind::Extern) if end == start + 2 => Spot::Words(vec!["function"]),
            Some(Kind::Host | Kind::Test) if alone => Spot::Words(vec!["function"]),
            Some(Kind::Var) if alone || self.around.previous(end) == Some(Kind::Comma) => Spot::Nothing,
            Some(Kind::Function) => match self.around.previous(end) {
                Some(Kind::Bind) => self.operand(0, end),
                _ => Spot::Nothing,
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
            ) if alone => Spot::Nothing,
            Some(Kind::Break | Kind::Continue | Kind::Units | Kind::Goto | Kind::Record) => Spot::Nothing,
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
    fn parameter(&self, open: usize) -> Spot {
        let end = self.around.before;
        let start = self.after_comma(open + 1, end);
        if start == end {
            return Spot::Words(vec!["in", "out", "inout"]);
        }
        if matches!(self.kind(start), Some(Kind::In | Kind::Out | Kind::InOut)) {
            return self.declared(start + 1, end);
        }
        Spot::Nothing
    }

    /// `name: Type = default in range` as far as it is written; a type is told before.
    fn declared(&self, start: usize, end: usize) -> Spot {
        let assigned = (start..end).find(|&at| matches!(self.kind(at), Some(Kind::Assign | Kind::Bind)));
        let domain = (start..end).any(|at| self.kind(at) == Some(Kind::In));
        if assigned.is_some() || domain {
            return self.operand(0, end);
        }
        Spot::Nothing
    }

    fn interpolated(&self, open: usize) -> Spot {
        let end = self.around.before;
        let format = (open + 1..end).find(|&at| self.kind(at) == Some(Kind::Format));
        match format {
            Some(format)
                if matches!(self.around.previous(end), Some(Kind::Format | Kind::Star | Kind::Slash)) =>
            {
                Spot::FormatUnit(open + 1..format)
            }
            Some(_) => Spot::Nothing,
            None => self.operand(0, end),
        }
    }

    /// The inside of a string.
    fn text(&self, text: Range<usize>, open: Option<usize>) -> Spot {
        match open {
            // Texts are not parts of expressions, but for comparisons.
            Some(open) => match self.value(0, open) {
                Value { operator: Operator::Factor(..) | Operator::Exponent | Operator::Truth, .. } => {
                    Spot::Nothing
                }
                value => Spot::Text(value, text),
            },
            None => Spot::Nothing,
        }
    }

    /// Whether a type belongs before the token `end`.
    fn type_spot(&self, end: usize) -> Option<Spot> {
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
            Some(Kind::Dot) => Spot::TypeMember(self.around.source(last.checked_sub(1)?).to_string()),
            _ if begun => Spot::Type,
            _ if self.around.cursor_begins_line() => return None,
            _ => Spot::Nothing,
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
    fn operand(&self, depth: usize, end: usize) -> Spot {
        let value = self.value(depth, end);
        let start = self.region(depth, end);
        let Some(last) = end.checked_sub(1).filter(|&last| last >= start) else {
            return Spot::Value(value);
        };
        match self.kind(last) {
            Some(Kind::Dot) => self.member(last, value),
            Some(Kind::At) => Spot::Symbol,
            Some(Kind::Identifier) if self.is_bare_at(last, start) => Spot::Symbol,
            Some(Kind::Number) if !self.around.cursor_begins_line() => match self.behind(depth, start, end) {
                Spot::After(words) => Spot::Unit(value, words),
                _ => Spot::Nothing,
            },
            Some(Kind::CloseParen) if self.closes_condition(last) => Spot::Value(value),
            _ if self.around.ends_expression(last) => self.behind(depth, start, end),
            // `(2 mm)^`, `2 mm^`: a number is typed here.
            Some(Kind::Caret) if last >= 2 && self.kind(last - 2) == Some(Kind::Number) => Spot::Nothing,
            _ => Spot::Value(value),
        }
    }

    /// `x at ` before the name that makes `at` a word.
    fn is_bare_at(&self, at: usize, start: usize) -> bool {
        at > start && self.around.source(at) == "at" && self.around.ends_expression(at - 1)
    }

    /// Words that go on behind a value.
    fn behind(&self, depth: usize, start: usize, end: usize) -> Spot {
        // Two operands in a row, on two lines: a `,`, a `;` or an operator is missing.
        if self.around.cursor_begins_line() && depth < self.statement.open.len() {
            let outer = self.around.indentation(self.around.range(self.statement.start).start);
            let begins = self.around.indentation(self.around.word.start) <= outer;
            return if begins { Spot::Statement } else { Spot::Nothing };
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
        Spot::After(words)
    }

    /// Whether an `if (c) a` of an expression lacks its `else`.
    fn has_open_choice(&self, start: usize, end: usize) -> bool {
        // `if` at the beginning of a statement is the statement.
        let count = |kind| (start..end).filter(|&at| self.kind(at) == Some(kind)).count();
        count(Kind::If) > count(Kind::Else)
    }

    fn member(&self, dot: usize, value: Value) -> Spot {
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
        Spot::Member(first..dot, value)
    }

    /// The value that is being written before the token `end`, in the brackets `open[depth]`.
    pub fn value(&self, depth: usize, end: usize) -> Value {
        let region = self.region(depth, end);
        let operator = self.operator(region, end);
        Value { slot: self.slot(depth, region, end), operator }
    }

    /// Where the expression begins that the token before `end` belongs to, in the brackets `open[depth]`.
    fn region(&self, depth: usize, end: usize) -> usize {
        let start = match self.statement.open.get(depth) {
            Some(Open { kind: Bracket::For, .. }) => self.statement.start.max(self.bracket_start(depth)),
            Some(open) => self.after_comma(open.at + 1, end),
            None => self.statement.start,
        };
        // The last token that an expression begins behind.
        let mut at = end;
        while let Some(before) = at.checked_sub(1).filter(|&before| before >= start) {
            match self.kind(before) {
                Some(Kind::CloseParen | Kind::CloseBracket | Kind::StringClose) => {
                    if self.closes_condition(before) {
                        return at;
                    }
                    at = self.around.opening(before).unwrap_or(before);
                }
                Some(
                    Kind::Assign
                    | Kind::Bind
                    | Kind::Else
                    | Kind::Return
                    | Kind::Throw
                    | Kind::Case
                    | Kind::DotDot
                    | Kind::In
                    | Kind::Comma,
                ) => return at,
                _ => at = before,
            }
        }
        start
    }

    fn bracket_start(&self, depth: usize) -> usize {
        self.statement.open.get(depth).map_or(self.statement.start, |open| open.at + 1)
    }

    /// The token behind the last comma between two tokens that is not in brackets.
    fn after_comma(&self, start: usize, end: usize) -> usize {
        let mut at = end;
        while let Some(before) = at.checked_sub(1).filter(|&before| before >= start) {
            match self.kind(before) {
                Some(Kind::Comma) => return at,
                Some(Kind::CloseParen | Kind::CloseBracket | Kind::StringClose) => {
                    at = self.around.opening(before).unwrap_or(before);
                }
                _ => at = before,
            }
        }
        start
    }

    /// Whether a `)` closes the condition of an `if`.
    fn closes_condition(&self, at: usize) -> bool {
        self.kind(at) == Some(Kind::CloseParen)
            && self.around.opening(at).is_some_and(|open| self.around.previous(open) == Some(Kind::If))
    }

    /// What stands before the operand that begins at `end`, in the expression that begins at `start`.
    fn operator(&self, start: usize, end: usize) -> Operator {
        let Some(last) = end.checked_sub(1).filter(|&last| last >= start) else { return Operator::None };
        let binary = last > start && self.around.ends_expression(last - 1);
        match self.kind(last) {
            Some(Kind::Plus | Kind::Minus) if !binary => self.operator(start, last),
            Some(
                Kind::Plus
                | Kind::Minus
                | Kind::Less
                | Kind::LessEqual
                | Kind::Greater
                | Kind::GreaterEqual
                | Kind::Equal
                | Kind::NotEqual,
            ) => Operator::Alike(self.term(start, last)..last),
            Some(Kind::Star | Kind::Slash) => {
                Operator::Factor(self.term(start, last)..last, self.kind(last) == Some(Kind::Slash))
            }
            Some(Kind::Caret) => Operator::Exponent,
            Some(Kind::Not | Kind::And | Kind::Or | Kind::AndAnd | Kind::OrOr) => Operator::Truth,
            // The cursor is behind a value, or the operand is the first.
            Some(Kind::Number | Kind::Identifier | Kind::CloseParen | Kind::CloseBracket) => {
                let first = self.primary(start, end);
                if first < end { self.operator(start, first) } else { Operator::None }
            }
            _ => Operator::None,
        }
    }

    /// The first token of the operand that ends before `end`.
    fn primary(&self, start: usize, end: usize) -> usize {
        let mut at = end;
        while let Some(before) = at.checked_sub(1).filter(|&before| before >= start) {
            match self.kind(before) {
                Some(Kind::CloseParen | Kind::CloseBracket) => {
                    at = self.around.opening(before).unwrap_or(before);
                }
                Some(Kind::Number | Kind::Identifier | Kind::Dot) => at = before,
                _ => break,
            }
        }
        at
    }

    /// The first token of the term (of a sum or a comparison) that ends before `end`.
    fn term(&self, start: usize, end: usize) -> usize {
        let mut at = end;
        while let Some(before) = at.checked_sub(1).filter(|&before| before >= start) {
            match self.kind(before) {
                Some(Kind::CloseParen | Kind::CloseBracket | Kind::StringClose) => {
                    at = self.around.opening(before).unwrap_or(before);
                }
                Some(
                    Kind::Number
                    | Kind::Identifier
                    | Kind::Dot
                    | Kind::Star
                    | Kind::Slash
                    | Kind::Caret
                    | Kind::Percent
                    | Kind::True
                    | Kind::False,
                ) => at = before,
                _ => break,
            }
        }
        at
    }

    /// What the expression that begins at `region` is for.
    fn slot(&self, depth: usize, region: usize, end: usize) -> Slot {
        // `x at Time = `
        if region >= 3
            && self.kind(region - 1) == Some(Kind::Assign)
            && self.kind(region - 2) == Some(Kind::Identifier)
            && self.kind(region - 3) == Some(Kind::At)
        {
            return Slot::At(self.around.source(region - 2).to_string());
        }
        let Some(open) = self.statement.open.get(depth).copied() else {
            return self.statement_slot(self.statement.start, region, end);
        };
        match open.kind {
            Bracket::Call => match self.around.call(open.at) {
                Some(call) => {
                    let start = self.after_comma(open.at + 1, end);
                    let bind = match self.kind(start + 1) {
                        Some(Kind::Assign) => Some(Bind::Evaluate),
                        Some(Kind::Bind) => Some(Bind::Symbolic),
                        _ => None,
                    };
                    let named = bind.filter(|_| start + 1 < end);
                    let name = named.map(|bind| (self.around.source(start).to_string(), bind));
                    Slot::Argument { call, name }
                }
                None => Slot::Free,
            },
            Bracket::List => Slot::Element(Box::new(self.value(depth + 1, open.at))),
            Bracket::Group => Slot::Same(Box::new(self.value(depth + 1, open.at))),
            Bracket::Choices => match self.value(depth + 1, open.at) {
                Value { slot: slot @ Slot::Bound { .. }, .. } => slot,
                _ => Slot::Free,
            },
            Bracket::Condition => Slot::Condition,
            Bracket::Index => Slot::Count,
            Bracket::Parameters => {
                let start = self.after_comma(open.at + 1, end);
                self.declared_slot(start + 1, region)
            }
            Bracket::For => {
                let parts = (open.at..end).filter(|&at| self.kind(at) == Some(Kind::Semicolon)).count();
                match parts {
                    1 => Slot::Condition,
                    _ => self.statement_slot(self.statement.start, region, end),
                }
            }
            Bracket::Switch | Bracket::Catch | Bracket::Interpolation => Slot::Free,
        }
    }

    /// A default or bound of what is declared by the tokens from its name on.
    fn declared_slot(&self, name: usize, region: usize) -> Slot {
        let before = |kind| (name..region).find(|&at| self.kind(at) == Some(kind));
        let assign = before(Kind::Assign).or(before(Kind::Bind));
        if let Some(domain) = before(Kind::In) {
            let default = assign.map_or(domain..domain, |assign| assign + 1..domain);
            return Slot::Bound { name: self.around.source(name).to_string(), default };
        }
        let bind = if before(Kind::Bind).is_some() { Bind::Symbolic } else { Bind::Evaluate };
        let end = assign.unwrap_or(region);
        let annotation = before(Kind::Colon).filter(|&colon| colon + 1 < end).map(|colon| colon + 1..end);
        Slot::Annotated { annotation, bind }
    }

    fn statement_slot(&self, start: usize, region: usize, end: usize) -> Slot {
        let last = region.checked_sub(1).filter(|&last| last >= start).and_then(|last| self.kind(last));
        match self.kind(start) {
            Some(Kind::Return) => return Slot::Returned,
            Some(Kind::Throw) => return Slot::Thrown,
            Some(Kind::Case) => return Slot::Case,
            Some(Kind::Function) if last == Some(Kind::Bind) => return Slot::SymbolicBody,
            Some(Kind::Param) => {
                if let slot @ Slot::Bound { .. } = self.declared_slot(start + 1, region) {
                    return slot;
                }
            }
            _ => {}
        }
        if self.blocks.first().is_some_and(|block| block.kind == BlockKind::Record) {
            return self.declared_slot(start, region);
        }
        // The `=` of this declaration or assignment, which may have `if (c) a else` behind it.
        let from = self.after_comma(start, end).max(start);
        let mut signs = (from..region).filter(|&at| {
            matches!(self.kind(at), Some(Kind::Assign | Kind::Bind)) && self.in_no_bracket(from, at)
        });
        let Some(assign) = signs.next() else { return Slot::Free };
        let bind = if self.kind(assign) == Some(Kind::Bind) { Bind::Symbolic } else { Bind::Evaluate };
        match self.kind(start) {
            Some(keyword @ (Kind::Var | Kind::Param | Kind::Const | Kind::Output)) => {
                let name = assign.checked_sub(1).map_or("", |name| self.around.source(name)).to_string();
                Slot::Initial { keyword, name, bind }
            }
            _ => Slot::Assigned { place: from..assign, bind },
        }
    }

    fn in_no_bracket(&self, from: usize, at: usize) -> bool {
        let mut depth = 0_i32;
        for index in from..at {
            match self.kind(index) {
                Some(Kind::OpenParen | Kind::OpenBracket) => depth += 1,
                Some(Kind::CloseParen | Kind::CloseBracket) => depth -= 1,
                _ => {}
            }
        }
        depth <= 0
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
