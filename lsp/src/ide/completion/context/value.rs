//! Context of the value at the cursor: its start, the operator before the operand, and its
//! receiver.

use super::*;

impl Context<'_> {
    /// Returns the incomplete value before the token `end`, in the delimiters `open[depth]`.
    pub fn value(&self, depth: usize, end: usize) -> Value {
        let region = self.region(depth, end);
        let operator = self.operator(region, end);
        Value { slot: self.slot(depth, region, end), operator }
    }

    /// Returns the start of the expression with the token before `end`, in the delimiters
    /// `open[depth]`.
    pub(super) fn region(&self, depth: usize, end: usize) -> usize {
        let start = match self.statement.open.get(depth) {
            Some(OpenDelimiter { kind: Bracket::For, .. }) => {
                self.statement.start.max(self.bracket_start(depth))
            }
            Some(open) => self.after_comma(open.at + 1, end),
            None => self.statement.start,
        };
        // Last token after which an expression starts.
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

    pub(super) fn bracket_start(&self, depth: usize) -> usize {
        self.statement.open.get(depth).map_or(self.statement.start, |open| open.at + 1)
    }

    /// Returns the token after the last comma between two tokens that is not in delimiters.
    pub(super) fn after_comma(&self, start: usize, end: usize) -> usize {
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

    /// Returns true if a `)` closes the condition of an `if`.
    pub(super) fn closes_condition(&self, at: usize) -> bool {
        self.kind(at) == Some(Kind::CloseParen)
            && self.around.opening(at).is_some_and(|open| self.around.previous(open) == Some(Kind::If))
    }

    /// Returns the operator before the operand that starts at `end`, in the expression that starts
    /// at `start`.
    pub(super) fn operator(&self, start: usize, end: usize) -> Operator {
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
            // The cursor is after a value, or the operand is the first.
            Some(Kind::Number | Kind::Identifier | Kind::CloseParen | Kind::CloseBracket) => {
                let first = self.primary(start, end);
                if first < end { self.operator(start, first) } else { Operator::None }
            }
            _ => Operator::None,
        }
    }

    /// Returns the first token of the operand that ends before `end`.
    pub(super) fn primary(&self, start: usize, end: usize) -> usize {
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

    /// Returns the first token of the term (of a sum or a comparison) that ends before `end`.
    pub(super) fn term(&self, start: usize, end: usize) -> usize {
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

    /// Returns the receiver of the expression that starts at `region`.
    pub(super) fn slot(&self, depth: usize, region: usize, end: usize) -> Slot {
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

    /// Returns the slot of a default or bound in the declaration whose name is the token `name`.
    pub(super) fn declared_slot(&self, name: usize, region: usize) -> Slot {
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

    pub(super) fn statement_slot(&self, start: usize, region: usize, end: usize) -> Slot {
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
        // The `=` of this declaration or assignment; `if (c) a else` may follow it.
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

    pub(super) fn in_no_bracket(&self, from: usize, at: usize) -> bool {
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
