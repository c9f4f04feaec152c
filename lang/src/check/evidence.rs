//! Evidence for the dimensions of variables: an initializer with a unit fixes the dimension, while
//! a literal without a unit takes the dimension of its uses.
//!
//! A wrong unit, as in `var shift = 0.25 mm;`, spreads through sums to variables of the second kind
//! and makes each of their uses an error. The unit is the cause, so it is reported alone.

use super::infer::Checker;
use super::symbols::with_article;
use super::tree::{Expr, Kind, VarId};
use crate::ast::{self, ExprKind, UnaryOp};
use crate::diagnostic::{Diagnostic, Label};
use crate::dimension::Dimension;
use crate::hashed::HashMap;
use crate::span::Span;

/// Evidence for the dimension of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Evidence {
    /// A literal with a unit.
    Unit(Span),
    /// The uses of a literal without a unit.
    Uses,
}

impl Evidence {
    fn is_unit(self) -> bool {
        matches!(self, Evidence::Unit(_))
    }
}

/// Use of a variable whose dimension is not the required one.
#[derive(Clone, Debug)]
struct Conflict {
    /// Name of the variable.
    name: String,
    evidence: Evidence,
    /// Required and given dimension.
    dimensions: [Dimension; 2],
    /// Shown given dimension.
    given: String,
    /// Location and message of the error.
    span: Span,
    message: String,
}

/// Initializers of variables, and the errors about their dimensions.
#[derive(Debug, Default)]
pub struct DimensionEvidence {
    initializers: HashMap<VarId, Evidence>,
    conflicts: Vec<Conflict>,
}

impl DimensionEvidence {
    /// Records the initializer of a variable.
    pub(super) fn initialize(&mut self, id: VarId, init: &ast::Expr) {
        let evidence = match quantity(init) {
            Some(span) => Evidence::Unit(span),
            None if super::expr::is_bare(init) => Evidence::Uses,
            None => return,
        };
        self.initializers.insert(id, evidence);
    }

    /// Removes errors about variables whose dimension is that of their uses, if a unit causes the
    /// same conflict of dimensions. The errors about the latter refer to the unit.
    pub(super) fn focus(&self, diagnostics: &mut Vec<Diagnostic>) {
        let of = |diagnostic: &Diagnostic| {
            let is_same = |conflict: &&Conflict| {
                conflict.span == diagnostic.primary.span && conflict.message == diagnostic.message
            };
            self.conflicts.iter().find(is_same)
        };
        let reported: Vec<&Conflict> = diagnostics.iter().filter_map(of).collect();
        let has_other = |conflict: &Conflict, by_unit: bool| {
            let is_other = |other: &&Conflict| {
                other.evidence.is_unit() == by_unit && other.dimensions == conflict.dimensions
            };
            conflict.evidence.is_unit() != by_unit && reported.iter().any(is_other)
        };
        diagnostics.retain(|diagnostic| !of(diagnostic).is_some_and(|conflict| has_other(conflict, true)));
        for diagnostic in diagnostics {
            let Some(conflict) = of(diagnostic).filter(|conflict| has_other(conflict, false)) else {
                continue;
            };
            let Evidence::Unit(span) = conflict.evidence else { continue };
            let message = format!("this unit makes `{}` {}", conflict.name, with_article(&conflict.given));
            let used = std::mem::replace(&mut diagnostic.primary, Label { span, message });
            diagnostic.labels.insert(0, used);
        }
    }
}

impl Checker<'_> {
    /// Records an error about the dimension of an expression, if the expression is a variable.
    pub(super) fn note_conflict(
        &mut self,
        [wanted, got]: [Option<Dimension>; 2],
        found: &Expr,
        diagnostic: &Diagnostic,
    ) {
        let (Kind::Var(id), Some(wanted), Some(got)) = (&found.kind, wanted, got) else { return };
        let Some(&evidence) = self.evidence.initializers.get(id) else { return };
        let conflict = Conflict {
            name: self.variable(*id).name.to_string(),
            evidence,
            dimensions: [wanted, got],
            given: self.store.show(&found.ty),
            span: diagnostic.primary.span,
            message: diagnostic.message.clone(),
        };
        self.evidence.conflicts.push(conflict);
    }
}

/// Returns the location of a literal with a unit, which may have a sign.
fn quantity(e: &ast::Expr) -> Option<Span> {
    match &e.kind {
        ExprKind::Quantity { .. } => Some(e.span),
        ExprKind::Paren(inner) => quantity(inner),
        ExprKind::Unary { op: UnaryOp::Plus | UnaryOp::Minus, operand } => quantity(operand).map(|_| e.span),
        _ => None,
    }
}
