//! Texts and choices of records that are bound with `:=`. A kernel computes only numbers; the texts
//! are those with which the record was bound.

use super::body::Body;
use crate::check::tree::{Def, DefId, Expr, Kind};
use crate::diagnostic::Diagnostic;
use crate::ir::{self, ExprKind};
use calyx_abi::Repr;

impl Body<'_, '_> {
    /// Adds the texts of a definition to its evaluated numbers.
    pub(super) fn with_texts(&mut self, def: DefId, numbers: ir::Expr, repr: Repr) -> ir::Expr {
        let span = numbers.span;
        let definition = &self.lowering.checker.defs[def.0 as usize];
        match self.filled(&definition.expr, definition, numbers, &repr) {
            Some(filled) => filled,
            None => {
                let name = &definition.name;
                self.lowering.report(
                    Diagnostic::error(
                        "E0507",
                        format!("the texts and choices of the record `{name}` have no value here"),
                        span,
                        "a value of the whole record",
                    )
                    .label(definition.span, "selects or computes the record symbolically")
                    .help("use the fields that are numbers, or bind the record with `=`"),
                );
                ir::Expr { kind: ExprKind::Number(f64::NAN), repr, span }
            }
        }
    }

    /// Returns the value of `e`, whose evaluated numbers are known; `None` if a text in it depends
    /// on more than the binding.
    fn filled(&mut self, e: &Expr, of: &Def, numbers: ir::Expr, repr: &Repr) -> Option<ir::Expr> {
        if !has_text(repr) {
            return Some(numbers);
        }
        let span = numbers.span;
        match (&e.kind, repr) {
            (Kind::Text(text), Repr::String) => {
                Some(ir::Expr { kind: ExprKind::String(text.clone()), repr: Repr::String, span })
            }
            (Kind::Def(inner), _) => {
                let inner = &self.lowering.checker.defs[inner.0 as usize];
                self.filled(&inner.expr, inner, numbers, repr)
            }
            (Kind::Array(all) | Kind::Tuple(all), Repr::Tuple(parts)) => {
                let parts = all.iter().zip(parts).enumerate().map(|(at, (e, repr))| {
                    let kind = ExprKind::TupleElement(Box::new(numbers.clone()), at);
                    self.filled(e, of, ir::Expr { kind, repr: as_numbers(repr), span }, repr)
                });
                let parts = parts.collect::<Option<Vec<_>>>()?;
                Some(ir::Expr { kind: ExprKind::Tuple(parts), repr: repr.clone(), span })
            }
            (Kind::Var(id), _) => {
                let written = of.captures.iter().find(|(captured, _)| captured == id);
                match written.filter(|_| !of.stored) {
                    // The captures of an argument are evaluated where it is passed.
                    Some((_, value)) if self.needs_statements(value) => None,
                    Some((_, value)) => Some(self.value(value)),
                    None => {
                        let local = self.local(*id);
                        let kind = ExprKind::Local(local);
                        (self.local_repr(local) == *repr).then(|| ir::Expr { kind, repr: repr.clone(), span })
                    }
                }
            }
            (Kind::TupleElement(base, at), _) => {
                let repr_of_base = self.repr(&base.ty);
                let missing =
                    ir::Expr { kind: ExprKind::Number(f64::NAN), repr: as_numbers(&repr_of_base), span };
                match self.filled(base, of, missing, &repr_of_base)?.kind {
                    ExprKind::Tuple(mut parts) if *at < parts.len() => {
                        let part = parts.swap_remove(*at);
                        (part.repr == Repr::String).then_some(part)
                    }
                    kind => {
                        let base = ir::Expr { kind, repr: repr_of_base, span };
                        let kind = ExprKind::TupleElement(Box::new(base), *at);
                        Some(ir::Expr { kind, repr: repr.clone(), span })
                    }
                }
            }
            _ => None,
        }
    }
}

/// Returns `true` if a value contains a text or a choice.
pub(super) fn has_text(repr: &Repr) -> bool {
    match repr {
        Repr::String => true,
        Repr::Tuple(parts) => parts.iter().any(has_text),
        Repr::Array(element) => has_text(element),
        _ => false,
    }
}

/// Returns the representation of an evaluated expression, which has numbers in place of its texts.
pub(super) fn as_numbers(repr: &Repr) -> Repr {
    match repr {
        Repr::String => Repr::Number,
        Repr::Tuple(parts) => Repr::Tuple(parts.iter().map(as_numbers).collect()),
        Repr::Array(element) => Repr::Array(Box::new(as_numbers(element))),
        other => other.clone(),
    }
}
