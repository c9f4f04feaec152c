//! Symbolic expressions: every use of a `:=` as a value becomes a site, with the definitions it names fused into it.

use super::body::Body;
use super::values::{BinaryForm, binary_form, unary_op};
use crate::ast::BinaryOp;
use crate::check::tree::{DefId, Expr, Kind, Sym, VarId};
use crate::diagnostic::Diagnostic;
use crate::ir::{self, Capture, ExprKind, Op, Site, SiteId, SymExpr, SymKind, Symbol};
use crate::span::Span;
use calyx_abi::Repr;
use std::collections::HashMap;

/// More nodes than any model needs; definitions that double at each step reach it.
const MOST_NODES: usize = 200_000;
/// Deeper than any model goes; a chain of definitions as long as a program reaches it.
const MOST_LEVELS: usize = 2000;

struct Captures {
    by_variable: HashMap<VarId, u32>,
    all: Vec<(VarId, Span)>,
    nodes: usize,
    level: usize,
    too_large: bool,
}

impl Body<'_, '_> {
    /// Executes the captures of a `:=`.
    pub(super) fn bind(&mut self, def: DefId) {
        let checker = self.lowering.checker;
        for (hidden, value) in &checker.defs[def.0 as usize].captures {
            let local = self.local(*hidden);
            let place = ir::Place::whole(local, self.local_repr(local));
            let value = self.value(value);
            let span = value.span;
            self.push(ir::Statement::Assign { place, value, span });
        }
    }

    /// A site for the definition, with the values it captures here and those its parts captured before.
    pub(super) fn make_symbolic(&mut self, def: DefId, span: Span) -> ir::Expr {
        let checker = self.lowering.checker;
        let definition = &checker.defs[def.0 as usize];
        let mut captures =
            Captures { by_variable: HashMap::new(), all: Vec::new(), nodes: 0, level: 0, too_large: false };
        let expr = self.symbolic(&definition.expr, &mut captures);
        if captures.too_large {
            self.lowering.report(
                Diagnostic::error(
                    "E0510",
                    format!(
                        "`{}` grows beyond {MOST_NODES} operations or {MOST_LEVELS} levels",
                        definition.name
                    ),
                    definition.span,
                    "with all definitions it names put in",
                )
                .help("split the model, or compute parts of it with `=`"),
            );
        }
        let repr = expr.repr.clone();
        let here: HashMap<VarId, &Expr> =
            definition.captures.iter().map(|(id, value)| (*id, value)).collect();
        // A binding executed earlier has set its hidden variables; an argument's captures are taken here.
        let bound_before = definition.stored;
        let kept = !bound_before && definition.captures.iter().any(|(_, value)| self.needs_statements(value));
        let mut values = Vec::new();
        let mut described = Vec::new();
        for (id, span) in captures.all {
            let value = match here.get(&id) {
                Some(value) if !bound_before && kept => {
                    let value = self.value(value);
                    self.kept(value)
                }
                Some(value) if !bound_before => self.value(value),
                _ => {
                    let local = self.local(id);
                    ir::Expr { kind: ExprKind::Local(local), repr: self.local_repr(local), span }
                }
            };
            described.push(Capture {
                name: checker.variable(id).name.clone(),
                observable: matches!(value.repr, Repr::Symbolic(_)),
                repr: value.repr.clone(),
            });
            values.push(value);
        }
        let site = SiteId(self.lowering.program.sites.len() as u32);
        self.lowering.program.sites.push(Site {
            name: definition.name.clone(),
            expr,
            captures: described,
            repr: repr.clone(),
            order: if repr == Repr::Transform { 2 } else { 0 },
            span: definition.span,
        });
        ir::Expr {
            kind: ExprKind::MakeSymbolic { site, captures: values },
            repr: Repr::Symbolic(Box::new(repr)),
            span,
        }
    }

    fn symbolic(&mut self, e: &Expr, captures: &mut Captures) -> SymExpr {
        captures.level += 1;
        let result = self.symbolic_node(e, captures);
        captures.level -= 1;
        result
    }

    fn symbolic_node(&mut self, e: &Expr, captures: &mut Captures) -> SymExpr {
        captures.nodes += 1;
        let span = e.span;
        let make = |kind, repr| SymExpr { kind, repr, span };
        if captures.nodes > MOST_NODES || captures.level > MOST_LEVELS {
            captures.too_large = true;
            return make(SymKind::Number(f64::NAN), Repr::Number);
        }
        match &e.kind {
            Kind::Number(value) => make(SymKind::Number(*value), Repr::Number),
            Kind::Bare(value, dim, system) => {
                make(SymKind::Number(value * self.bare_factor(dim, *system)), Repr::Number)
            }
            Kind::Bool(value) => make(SymKind::Bool(*value), Repr::Bool),
            Kind::Time => make(SymKind::Time, Repr::Number),
            Kind::Param(id) => make(SymKind::Param(*id), Repr::Number),
            Kind::Def(def) => {
                let checker = self.lowering.checker;
                self.symbolic(&checker.defs[def.0 as usize].expr, captures)
            }
            Kind::Observe(inner) => {
                let inner = self.symbolic(inner, captures);
                SymExpr { repr: Repr::Number, ..inner }
            }
            Kind::Var(id) => {
                let index = *captures.by_variable.entry(*id).or_insert_with(|| {
                    captures.all.push((*id, span));
                    captures.all.len() as u32 - 1
                });
                let local = self.local(*id);
                let repr = self.local_repr(local);
                make(SymKind::Capture(index), repr)
            }
            Kind::Unary(op, a) => {
                let a = self.symbolic(a, captures);
                match unary_op(*op, &a.repr) {
                    None => a,
                    Some(op) => {
                        let repr = a.repr.clone();
                        make(SymKind::Op(op, vec![a]), repr)
                    }
                }
            }
            Kind::Binary(op, a, b) => {
                let (a, b) = (self.symbolic(a, captures), self.symbolic(b, captures));
                symbolic_binary(*op, a, b, span)
            }
            Kind::Op(op, all) => {
                let all = all.iter().map(|a| self.symbolic(a, captures)).collect();
                let repr = self.repr(&e.ty);
                make(SymKind::Op(*op, all), repr)
            }
            Kind::If(condition, a, b) => {
                let condition = self.symbolic(condition, captures);
                let (a, b) = (self.symbolic(a, captures), self.symbolic(b, captures));
                let repr = a.repr.clone();
                make(SymKind::If(Box::new(condition), Box::new(a), Box::new(b)), repr)
            }
            Kind::Derivative(inner, sym) => {
                let inner = self.symbolic(inner, captures);
                let repr = inner.repr.clone();
                make(SymKind::Derivative(Box::new(inner), symbol(*sym)), repr)
            }
            Kind::At(inner, sym, at) => {
                let (inner, at) = (self.symbolic(inner, captures), self.symbolic(at, captures));
                let repr = inner.repr.clone();
                make(SymKind::At(Box::new(inner), symbol(*sym), Box::new(at)), repr)
            }
            // Everything else was turned into a capture when the definition was made.
            _ => make(SymKind::Number(f64::NAN), self.repr(&e.ty)),
        }
    }
}

fn symbol(sym: Sym) -> Symbol {
    match sym {
        Sym::Time => Symbol::Time,
        Sym::Param(id) => Symbol::Param(id),
    }
}

fn symbolic_binary(op: BinaryOp, a: SymExpr, b: SymExpr, span: Span) -> SymExpr {
    let make = |kind, repr| SymExpr { kind, repr, span };
    let truth = |value| Box::new(make(SymKind::Bool(value), Repr::Bool));
    match op {
        BinaryOp::And => return make(SymKind::If(Box::new(a), Box::new(b), truth(false)), Repr::Bool),
        BinaryOp::Or => return make(SymKind::If(Box::new(a), truth(true), Box::new(b)), Repr::Bool),
        _ => {}
    }
    match binary_form(op, &a.repr, &b.repr) {
        BinaryForm::Plain(op, repr) => make(SymKind::Op(op, vec![a, b]), repr),
        BinaryForm::Swapped(op, repr) => make(SymKind::Op(op, vec![b, a]), repr),
        BinaryForm::DivideVector => {
            let reciprocal = make(
                SymKind::Op(Op::Divide, vec![make(SymKind::Number(1.0), Repr::Number), b]),
                Repr::Number,
            );
            make(SymKind::Op(Op::Scale, vec![reciprocal, a]), Repr::Vector)
        }
    }
}
