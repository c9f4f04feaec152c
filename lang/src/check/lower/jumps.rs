//! Lowers `switch` and `goto`, and `break` and `continue` outside of loops.

use super::body::{Body, Exit};
use crate::check::constant;
use crate::check::symbols::similar;
use crate::check::tree::{Expr, Stmt, StmtKind};
use crate::check::types::Type;
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::ir::{self, ExprKind, Op};
use crate::span::Span;
use calyx_abi::Repr;

impl Body<'_, '_> {
    pub(super) fn switch(&mut self, value: &Expr, body: &Stmt) {
        let switched = value;
        let value = self.value(value);
        let span = value.span;
        let repr = value.repr.clone();
        let local = self.temporary(value);
        let statements = match &body.kind {
            StmtKind::Block(statements) => statements.as_slice(),
            _ => std::slice::from_ref(body),
        };
        let after = self.new_block();
        let mut cases = HashMap::default();
        let mut default = None;
        let mut tests = Vec::new();
        for mut statement in statements {
            loop {
                match &statement.kind {
                    StmtKind::Case(value, inner) => {
                        let block = self.new_block();
                        cases.insert(statement.span, block);
                        tests.push((value, block));
                        statement = inner;
                    }
                    StmtKind::Default(inner) => {
                        let block = self.new_block();
                        cases.insert(statement.span, block);
                        if default.replace(block).is_some() {
                            self.lowering.report(
                                Diagnostic::error(
                                    "E0315",
                                    "this switch has two defaults",
                                    statement.span,
                                    "second default",
                                )
                                .help("remove one of them"),
                            );
                        }
                        statement = inner;
                    }
                    StmtKind::Label(_, inner) => statement = inner,
                    _ => break,
                }
            }
        }
        let is_covered = default.is_none() && self.covers_all_choices(switched, &tests);
        let last = tests.len().saturating_sub(1);
        for (index, (case, block)) in tests.into_iter().enumerate() {
            if is_covered && index == last {
                self.jump(block);
                break;
            }
            let next = self.new_block();
            let left = ir::Expr { kind: ExprKind::Local(local), repr: repr.clone(), span };
            let right = self.value(case);
            let kind = ExprKind::Op(Op::Equal, vec![left, right]);
            self.branch_on(ir::Expr { kind, repr: Repr::Bool, span: case.span }, block, next);
            self.start(next);
        }
        if !is_covered {
            self.jump(default.unwrap_or(after));
        }
        self.cases.push(cases);
        self.exits.push(Exit { on_break: after, on_continue: None });
        self.block(statements);
        self.exits.pop();
        self.cases.pop();
        self.jump(after);
        self.start(after);
    }

    /// Returns `true` if the cases of a `switch` over an enumeration are all of its choices.
    fn covers_all_choices(&self, value: &Expr, cases: &[(&Expr, usize)]) -> bool {
        let checker = self.lowering.checker;
        let Type::Enum(of) = checker.store.shallow(&self.types.ty(&checker.store, &value.ty)) else {
            return false;
        };
        let has_case =
            |choice: &String| cases.iter().any(|(case, _)| constant::text(case) == Some(choice.as_str()));
        of.choices.iter().all(has_case)
    }

    pub(super) fn goto(&mut self, name: &str, span: Span) {
        let found = self.labels.iter().rev().find_map(|labels| labels.get(name).copied());
        match found {
            Some(block) => self.jump(block),
            None => {
                let checker = self.lowering.checker;
                let mut elsewhere = false;
                if let Some(function) = checker.functions.get(&self.function) {
                    for statement in &function.body {
                        statement.walk(&mut |s| {
                            elsewhere |= matches!(&s.kind, StmtKind::Label(label, _) if label == name)
                        });
                    }
                }
                let known = self.labels.iter().flat_map(|labels| labels.keys().map(String::as_str));
                let diagnostic = if elsewhere {
                    Diagnostic::error(
                        "E0215",
                        format!("`goto {name}` would enter a block"),
                        span,
                        "the label is inside another block",
                    )
                    .help("move the label out of that block")
                } else {
                    let diagnostic = Diagnostic::error(
                        "E0215",
                        format!("there is no label `{name}` here"),
                        span,
                        "unknown label",
                    );
                    match similar(name, known) {
                        Some(near) => diagnostic.help(format!("did you mean `{near}`?")),
                        None => diagnostic.help(format!("put `{name}:` before the target statement")),
                    }
                };
                self.lowering.report(diagnostic);
            }
        }
    }

    pub(super) fn outside(&mut self, word: &str, place: &str, span: Span) {
        self.lowering.report(
            Diagnostic::error("E0214", format!("`{word}` is outside {place}"), span, "nothing to leave")
                .help(format!("move it into {place}")),
        );
    }
}
