//! Formats statements: one per line, with indented blocks, and bodies on the line of their head if
//! they fit.

use super::document::Item;
use super::printer::Printer;
use crate::ast::{BinaryOp, Bind, Expr, Import, Module, Stmt, StmtKind};
use crate::lexer::Kind;

impl Printer<'_> {
    pub(super) fn file(&mut self, module: &Module) {
        self.statements(&module.statements);
    }

    /// Formats statements on separate lines. Statements after a `case` are indented under it.
    fn statements(&mut self, statements: &[Stmt]) {
        let mut in_case = false;
        for statement in statements {
            if in_case && is_case(statement) {
                self.item(Item::Dedent);
                in_case = false;
            }
            self.begin_item();
            self.statement(statement);
            if !in_case && is_case(statement) {
                self.item(Item::Indent);
                in_case = true;
            }
        }
        if in_case {
            self.comments();
            self.item(Item::Dedent);
        }
    }

    pub(super) fn statement(&mut self, statement: &Stmt) {
        if statement.private {
            self.token(Kind::Private);
            self.space();
        }
        match &statement.kind {
            // Texts with errors are not formatted.
            StmtKind::Error => {}
            StmtKind::Empty => self.token(Kind::Semicolon),
            StmtKind::Import(path) => self.import(path),
            StmtKind::Units(_) => self.keyword_and_name(Kind::Units),
            StmtKind::Param(param) => self.param(param),
            StmtKind::Const { value, .. } => self.named_value(Kind::Const, Bind::Evaluate, value),
            StmtKind::Record(record) => self.record(record),
            StmtKind::Enum(decl) => self.enumeration(decl),
            StmtKind::Dimension { value, .. } => self.dimension(value.is_some()),
            StmtKind::Unit(unit) => self.unit(unit),
            StmtKind::Output { value, unit: None, .. } => {
                self.named_value(Kind::Output, Bind::Symbolic, value);
            }
            StmtKind::Output { value, unit: Some(unit), .. } => self.output_in(value, unit),
            StmtKind::Var(_) | StmtKind::Assign { .. } | StmtKind::Update { .. } | StmtKind::Expr(_) => {
                self.simple(statement);
                self.token(Kind::Semicolon);
            }
            StmtKind::Function(function) => self.function(function),
            StmtKind::Block(statements) => self.block(statement, statements, false),
            StmtKind::If { condition, then, otherwise: None } => self.headed(then, |p| {
                p.token(Kind::If);
                p.condition(condition);
            }),
            StmtKind::If { condition, then, otherwise: Some(otherwise) } => {
                self.open();
                self.branch(condition, then, Some(otherwise));
                self.item(Item::Close);
            }
            StmtKind::While { condition, body } => {
                self.headed(body, |p| {
                    p.token(Kind::While);
                    p.condition(condition);
                });
            }
            StmtKind::DoWhile { body, condition } => {
                self.headed(body, |p| p.token(Kind::Do));
                self.after_body(body);
                self.token(Kind::While);
                self.condition(condition);
                self.token(Kind::Semicolon);
            }
            StmtKind::For { init, condition, step, body } => {
                self.for_loop(init, condition.as_ref(), step, body);
            }
            StmtKind::ForEach { values, body, .. } => {
                self.headed(body, |p| {
                    p.token(Kind::For);
                    p.space();
                    p.token(Kind::OpenParen);
                    p.token(Kind::Identifier);
                    p.space();
                    p.token(Kind::In);
                    p.space();
                    p.values(values);
                    p.token(Kind::CloseParen);
                });
            }
            StmtKind::Switch { value, body } => {
                self.headed(body, |p| {
                    p.token(Kind::Switch);
                    p.condition(value);
                });
            }
            StmtKind::Case { value, statement } => {
                self.token(Kind::Case);
                self.space();
                self.expression(value);
                self.token(Kind::Colon);
                self.after_case(statement);
            }
            StmtKind::Default(statement) => {
                self.token(Kind::Default);
                self.token(Kind::Colon);
                self.after_case(statement);
            }
            StmtKind::Label { statement, .. } => {
                self.token(Kind::Identifier);
                self.token(Kind::Colon);
                self.space();
                self.statement(statement);
            }
            StmtKind::Goto(_) => self.keyword_and_name(Kind::Goto),
            StmtKind::Break => self.jump(Kind::Break, None),
            StmtKind::Continue => self.jump(Kind::Continue, None),
            StmtKind::Return(value) => self.jump(Kind::Return, value.as_ref()),
            StmtKind::Throw(value) => self.jump(Kind::Throw, value.as_ref()),
            StmtKind::Try { body, error, handler } => self.try_catch(body, error.is_some(), handler),
        }
    }

    fn import(&mut self, import: &Import) {
        self.token(Kind::Import);
        self.space();
        if import.is_quoted {
            self.string();
        }
        for index in (0..import.path.len()).filter(|_| !import.is_quoted) {
            if index > 0 {
                self.token(Kind::Dot);
            }
            self.token(Kind::Identifier);
        }
        if import.alias.is_some() {
            self.space();
            self.token(Kind::Identifier);
            self.space();
            self.token(Kind::Identifier);
        }
        self.token(Kind::Semicolon);
    }

    /// Formats a statement of a keyword and a name.
    fn keyword_and_name(&mut self, word: Kind) {
        self.token(word);
        self.space();
        self.token(Kind::Identifier);
        self.token(Kind::Semicolon);
    }

    /// Formats the declaration of a name with a value.
    fn named_value(&mut self, word: Kind, bind: Bind, value: &Expr) {
        self.token(word);
        self.space();
        self.token(Kind::Identifier);
        self.value(bind, value);
        self.token(Kind::Semicolon);
    }

    fn for_loop(&mut self, init: &Stmt, condition: Option<&Expr>, step: &Stmt, body: &Stmt) {
        self.headed(body, |p| {
            p.token(Kind::For);
            p.space();
            p.token(Kind::OpenParen);
            p.group(|p| {
                p.simple(init);
                p.token(Kind::Semicolon);
                if let Some(condition) = condition {
                    p.line();
                    p.expression(condition);
                }
                p.token(Kind::Semicolon);
                if !matches!(step.kind, StmtKind::Empty) {
                    p.line();
                    p.simple(step);
                }
            });
            p.token(Kind::CloseParen);
        });
    }

    fn try_catch(&mut self, body: &Stmt, has_error: bool, handler: &Stmt) {
        self.open();
        self.headed_with(body, true, |p| p.token(Kind::Try));
        self.after_body(body);
        self.headed_with(handler, true, |p| {
            p.token(Kind::Catch);
            p.space();
            p.token(Kind::OpenParen);
            if has_error {
                p.token(Kind::Identifier);
            }
            p.token(Kind::CloseParen);
        });
        self.item(Item::Close);
    }

    /// Formats a statement in the head of a `for`, without the `;`.
    fn simple(&mut self, statement: &Stmt) {
        match &statement.kind {
            StmtKind::Var(declared) => self.variables(declared),
            StmtKind::Assign { place, bind, value } => {
                self.expression(place);
                self.value(*bind, value);
            }
            StmtKind::Update { place, op, value, .. } => {
                self.expression(place);
                self.space();
                self.token(match op {
                    BinaryOp::Subtract => Kind::SubtractAssign,
                    BinaryOp::Multiply => Kind::MultiplyAssign,
                    BinaryOp::Divide => Kind::DivideAssign,
                    _ => Kind::AddAssign,
                });
                self.assigned(value);
            }
            StmtKind::Expr(e) => self.expression(e),
            _ => {}
        }
    }

    /// Formats a statement of a keyword and an optional value.
    fn jump(&mut self, word: Kind, value: Option<&Expr>) {
        self.token(word);
        if let Some(value) = value {
            self.space();
            self.expression(value);
        }
        self.token(Kind::Semicolon);
    }

    /// Formats `{ ... }`. A block of at most one plain statement that is written on one line stays
    /// on one line if it fits. Blocks that are `together`, as those of `if` and `else`, do so only
    /// if all of them fit.
    fn block(&mut self, block: &Stmt, statements: &[Stmt], together: bool) {
        let together = together && !statements.is_empty();
        let in_line = match statements {
            [] => true,
            [only] => is_plain(only) && !self.spans_lines(block.span.end),
            _ => false,
        };
        self.token(Kind::OpenBrace);
        if statements.is_empty() && !self.comment_ahead() {
            self.token(Kind::CloseBrace);
            return;
        }
        if in_line && !together {
            self.open();
        }
        self.item(Item::Indent);
        match statements {
            [only] if in_line => {
                self.line();
                self.statement(only);
            }
            _ => self.statements(statements),
        }
        self.comments();
        self.item(Item::Dedent);
        self.item(if in_line { Item::Line } else { Item::HardLine });
        if in_line && !together {
            self.item(Item::Close);
        }
        self.token(Kind::CloseBrace);
    }

    /// Formats a head such as `while (c)` and its body, which moves to the next line if both do not
    /// fit on one.
    pub(super) fn headed(&mut self, body: &Stmt, head: impl FnOnce(&mut Self)) {
        self.headed_with(body, false, head);
    }

    fn headed_with(&mut self, body: &Stmt, together: bool, head: impl FnOnce(&mut Self)) {
        let in_line = !matches!(body.kind, StmtKind::Block(_));
        if in_line {
            self.open();
        }
        head(self);
        self.governed(body, together);
        if in_line {
            self.item(Item::Close);
        }
    }

    /// Formats a block on the line of its head, or another body indented.
    fn governed(&mut self, body: &Stmt, together: bool) {
        if let StmtKind::Block(statements) = &body.kind {
            self.space();
            self.block(body, statements, together);
            return;
        }
        self.item(Item::Indent);
        self.line();
        self.statement(body);
        self.item(Item::Dedent);
    }

    /// Formats the space between a body and a continuing keyword such as `else`.
    fn after_body(&mut self, body: &Stmt) {
        self.item(match body.kind {
            StmtKind::Block(_) => Item::Space,
            _ => Item::HardLine,
        });
    }

    fn branch(&mut self, condition: &Expr, then: &Stmt, otherwise: Option<&Stmt>) {
        self.headed_with(then, true, |p| {
            p.token(Kind::If);
            p.condition(condition);
        });
        let Some(otherwise) = otherwise else { return };
        self.after_body(then);
        if let StmtKind::If { condition, then, otherwise } = &otherwise.kind {
            self.token(Kind::Else);
            self.space();
            self.branch(condition, then, otherwise.as_deref());
        } else {
            self.headed_with(otherwise, true, |p| p.token(Kind::Else));
        }
    }

    /// Formats the statement of a `case`: indented on the next line, or another `case` below it.
    fn after_case(&mut self, statement: &Stmt) {
        if is_case(statement) {
            self.begin_item();
            self.statement(statement);
            return;
        }
        self.item(Item::Indent);
        self.begin_item();
        self.statement(statement);
        self.item(Item::Dedent);
    }
}

fn is_case(statement: &Stmt) -> bool {
    matches!(statement.kind, StmtKind::Case { .. } | StmtKind::Default(_))
}

/// Returns `true` if a statement may share its line with the surrounding braces.
fn is_plain(statement: &Stmt) -> bool {
    match &statement.kind {
        StmtKind::If { then: body, otherwise: None, .. }
        | StmtKind::While { body, .. }
        | StmtKind::Label { statement: body, .. } => is_plain(body),
        StmtKind::Empty
        | StmtKind::Var(_)
        | StmtKind::Assign { .. }
        | StmtKind::Update { .. }
        | StmtKind::Expr(_)
        | StmtKind::Goto(_)
        | StmtKind::Break
        | StmtKind::Continue
        | StmtKind::Return(_)
        | StmtKind::Throw(_) => true,
        StmtKind::Error
        | StmtKind::Import(_)
        | StmtKind::Units(_)
        | StmtKind::Param(_)
        | StmtKind::Const { .. }
        | StmtKind::Record(_)
        | StmtKind::Enum(_)
        | StmtKind::Dimension { .. }
        | StmtKind::Unit(_)
        | StmtKind::Output { .. }
        | StmtKind::Function(_)
        | StmtKind::Block(_)
        | StmtKind::If { .. }
        | StmtKind::DoWhile { .. }
        | StmtKind::For { .. }
        | StmtKind::ForEach { .. }
        | StmtKind::Switch { .. }
        | StmtKind::Case { .. }
        | StmtKind::Default(_)
        | StmtKind::Try { .. } => false,
    }
}
