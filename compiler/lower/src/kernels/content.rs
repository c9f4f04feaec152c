//! Content of a site: all that its kernel depends on, so that equal sites of different programs,
//! for instance of a model before and after an edit, share a kernel.

use crate::fingerprint::{Fingerprint, FingerprintHasher};
use calyx_lang::ir::{Program, Site, SymExpr, SymKind, SymbolicFunctionId};
use std::collections::HashMap;
use std::hash::Hash;

/// Fingerprint of a site and of the functions that it calls. Sites with equal fingerprints have
/// equal kernels; names and positions in the text do not count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SiteContent(Fingerprint);

impl SiteContent {
    /// Computes the fingerprint of a site.
    pub fn of(program: &Program, site: &Site) -> Self {
        let mut content =
            Content { hashers: FingerprintHasher::default(), functions: HashMap::new(), left: Vec::new() };
        let hashers = &mut content.hashers;
        (program.params.len(), &program.graph_params, &site.repr).hash(hashers);
        (site.order, site.part, site.captures.len()).hash(hashers);
        for capture in &site.captures {
            (&capture.repr, capture.observable).hash(hashers);
        }
        content.body(&site.shared, &site.expr);
        let mut next = 0;
        while let Some(&id) = content.left.get(next) {
            next += 1;
            let Some(function) = program.symbolic_functions.get(id.0 as usize) else { continue };
            (function.parameters.len(), &function.result).hash(&mut content.hashers);
            for parameter in &function.parameters {
                parameter.repr.hash(&mut content.hashers);
            }
            content.body(&function.shared, &function.body);
        }
        SiteContent(content.hashers.fingerprint())
    }
}

struct Content {
    hashers: FingerprintHasher,
    /// Called functions, numbered in the order of their first calls.
    functions: HashMap<u32, usize>,
    left: Vec<SymbolicFunctionId>,
}

impl Content {
    fn body(&mut self, shared: &[SymExpr], expr: &SymExpr) {
        shared.len().hash(&mut self.hashers);
        shared.iter().for_each(|shared| self.expression(shared));
        self.expression(expr);
    }

    /// Adds an expression in prefix order. Each node states its number of operands.
    fn expression(&mut self, expr: &SymExpr) {
        let mut left = vec![expr];
        while let Some(expr) = left.pop() {
            self.node(expr);
            let operands = expr.operands();
            operands.len().hash(&mut self.hashers);
            left.extend(operands.into_iter().rev());
        }
    }

    fn node(&mut self, expr: &SymExpr) {
        std::mem::discriminant(&expr.kind).hash(&mut self.hashers);
        expr.repr.hash(&mut self.hashers);
        match &expr.kind {
            SymKind::Number(value) => value.to_bits().hash(&mut self.hashers),
            SymKind::Bool(value) => value.hash(&mut self.hashers),
            SymKind::Param(index)
            | SymKind::Capture(index)
            | SymKind::Argument(index)
            | SymKind::Shared(index)
            | SymKind::Element(_, index) => index.hash(&mut self.hashers),
            SymKind::Op(op, _) => op.hash(&mut self.hashers),
            SymKind::Derivative(_, symbol) | SymKind::At(_, symbol, _) => symbol.hash(&mut self.hashers),
            SymKind::Call(id, _) => self.function(*id),
            SymKind::Solve(search, id, _) => {
                search.hash(&mut self.hashers);
                self.function(*id);
            }
            SymKind::Table(table, _) => {
                table.len().hash(&mut self.hashers);
                table.iter().for_each(|value| value.to_bits().hash(&mut self.hashers));
            }
            SymKind::Time | SymKind::If(..) | SymKind::Brackets(_) => {}
        }
    }

    fn function(&mut self, id: SymbolicFunctionId) {
        let next = self.functions.len();
        let number = *self.functions.entry(id.0).or_insert(next);
        if number == next {
            self.left.push(id);
        }
        number.hash(&mut self.hashers);
    }
}
