//! Code lenses above declarations: run the model, explain its plan, run a test, show the uses.

use super::Snapshot;
use super::source::Source;
use calyx_lang::analysis::{Name, SourceRange};
use calyx_lang::ast::{Expr, ExprKind, Ident, Stmt, StmtKind};
use std::sync::Arc;

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lens {
    /// Runs the model.
    Run,
    /// Shows the plan of the model's analysis.
    ExplainPlan,
    /// Runs the test of this name.
    RunTest(String),
    /// Shows the uses of the declaration at a position; [`uses`] counts them when the lens is
    /// resolved.
    Uses(SourceRange),
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeLens {
    /// Start of the name or keyword below the lens.
    pub start: u32,
    /// End of the name or keyword.
    pub end: u32,
    pub lens: Lens,
}

/// Returns the lenses of a file, sorted by position.
pub fn lenses(source: &Source<'_>, file: &Arc<str>) -> Vec<CodeLens> {
    let statements = &source.tree.module.statements;
    let analysis = statements.iter().find_map(analysis);
    let first_output = || {
        statements.iter().find_map(|statement| match &statement.kind {
            StmtKind::Output { name, .. } => Some(name),
            _ => None,
        })
    };
    let mut lenses = Vec::new();
    if let Some(name) = analysis.or_else(first_output) {
        let (start, end) = (name.span.start, name.span.end);
        lenses.extend([Lens::Run, Lens::ExplainPlan].map(|lens| CodeLens { start, end, lens }));
    }
    for statement in statements {
        let (name, test) = match &statement.kind {
            StmtKind::Function(function) => (&function.name, function.is_test),
            StmtKind::Record(record) => (&record.name, false),
            StmtKind::Enum(decl) => (&decl.name, false),
            StmtKind::Const { name, .. } => (name, false),
            StmtKind::Param(param) => (&param.name, false),
            _ => continue,
        };
        let (start, end) = (name.span.start, name.span.end);
        let lens = match test {
            true => Lens::RunTest(name.name.to_string()),
            false => Lens::Uses(SourceRange { file: file.clone(), start, end }),
        };
        lenses.push(CodeLens { start, end, lens });
    }
    lenses.sort_by_key(|lens| lens.start);
    lenses
}

/// Returns the identifier `analyze` if a statement calls it.
fn analysis(statement: &Stmt) -> Option<&Ident> {
    let StmtKind::Expr(Expr { kind: ExprKind::Call { callee, .. }, .. }) = &statement.kind else {
        return None;
    };
    match &callee.kind {
        ExprKind::Name(name) if name.name == "analyze" => Some(name),
        _ => None,
    }
}

/// Returns the uses of the declaration at a position, in all files.
pub fn uses(snapshot: &Snapshot, place: &SourceRange) -> Vec<(Arc<str>, Name)> {
    let mut found = snapshot.database.references(place);
    found.retain(|(_, name)| !name.declares);
    found
}
