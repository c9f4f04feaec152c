//! Which values depend on which params: a derivative by a param must not overlook one that was computed beforehand.
//!
//! Flow-insensitive, so it may refuse a derivative that would have been right, and never lets a wrong one pass.
//! A branch taken because of a param does not count: params are not differentiable there.

use super::graphs::Graphs;
use super::tree::{Def, DefId, Expr, FuncId, Kind, Sym, VarId};
use crate::span::Span;
use std::collections::{BTreeSet, HashMap, HashSet};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Node {
    Variable(VarId),
    Param(u32),
    /// What a function returns or hands back.
    Function(FuncId),
    Definition(DefId),
    /// What errors carry from where they are thrown to where they are caught.
    Error,
}

#[derive(Debug, Default)]
pub struct Dependence {
    edges: HashMap<Node, BTreeSet<Node>>,
    /// Param, captured variables in the differentiated expression, place.
    derivatives: Vec<(u32, BTreeSet<VarId>, Span)>,
}

impl Dependence {
    /// A variable is given a value.
    pub fn variable(&mut self, id: VarId, value: &Expr) {
        self.add(Node::Variable(id), value);
    }

    /// A name that holds an expression is bound to one.
    pub fn variable_on_definition(&mut self, id: VarId, def: DefId) {
        self.edges.entry(Node::Variable(id)).or_default().insert(Node::Definition(def));
    }

    pub fn variable_on_function(&mut self, id: VarId, function: FuncId) {
        self.edges.entry(Node::Variable(id)).or_default().insert(Node::Function(function));
    }

    /// A function hands back the present value of a parameter.
    pub fn function_on_variable(&mut self, function: FuncId, id: VarId) {
        self.edges.entry(Node::Function(function)).or_default().insert(Node::Variable(id));
    }

    pub fn returned(&mut self, function: FuncId, value: &Expr) {
        self.add(Node::Function(function), value);
    }

    pub fn thrown(&mut self, value: &Expr) {
        self.add(Node::Error, value);
    }

    /// An error may carry the variable's value.
    pub fn thrown_variable(&mut self, id: VarId) {
        self.edges.entry(Node::Error).or_default().insert(Node::Variable(id));
    }

    pub fn caught(&mut self, id: VarId) {
        self.edges.entry(Node::Variable(id)).or_default().insert(Node::Error);
    }

    pub fn definition(&mut self, id: DefId, expr: &Expr) {
        self.add(Node::Definition(id), expr);
    }

    /// An expression is differentiated.
    pub fn derivative(&mut self, by: Sym, expr: &Expr, defs: &[Def], span: Span) {
        let Sym::Param(param) = by else { return };
        let mut captured = BTreeSet::new();
        let mut seen = HashSet::new();
        captured_in(expr, defs, &mut captured, &mut seen);
        self.derivatives.push((param, captured, span));
    }

    fn add(&mut self, node: Node, value: &Expr) {
        let mut found = BTreeSet::new();
        sources(value, &mut found);
        self.edges.entry(node).or_default().extend(found);
    }

    /// Derivatives that would miss something: the param, the captured variable that hides it, the place.
    pub fn blind_derivatives(&self, defs: &[Def], graphs: &Graphs) -> Vec<(u32, VarId, Span)> {
        let hides = |param: u32, id: VarId| {
            let (mut seen, mut stack) = (HashSet::new(), vec![Node::Variable(id)]);
            while let Some(node) = stack.pop() {
                if node == Node::Param(param) {
                    return true;
                }
                if seen.insert(node) {
                    stack.extend(self.edges.get(&node).into_iter().flatten());
                }
            }
            false
        };
        self.derivatives
            .iter()
            .filter_map(|(param, captured, span)| {
                let captured = through_graphs(captured, defs, graphs);
                let id = captured.into_iter().find(|id| hides(*param, *id))?;
                Some((*param, id, *span))
            })
            .collect()
    }
}

/// Values captured by an expression, those of the expressions it captured included.
fn through_graphs(captured: &BTreeSet<VarId>, defs: &[Def], graphs: &Graphs) -> BTreeSet<VarId> {
    let (mut values, mut seen, mut met) = (BTreeSet::new(), HashSet::new(), HashSet::new());
    let mut pending: Vec<VarId> = captured.iter().copied().collect();
    while let Some(id) = pending.pop() {
        let Some(name) = graphs.captured.get(&id) else {
            values.insert(id);
            continue;
        };
        if met.insert(*name) {
            let mut found = BTreeSet::new();
            for def in graphs.bound.get(name).into_iter().flatten() {
                captured_in(&defs[def.0 as usize].expr, defs, &mut found, &mut seen);
            }
            pending.extend(found);
        }
    }
    values
}

fn sources(e: &Expr, found: &mut BTreeSet<Node>) {
    match &e.kind {
        Kind::Var(id) | Kind::Chosen(id) => {
            found.insert(Node::Variable(*id));
        }
        Kind::Param(id) => {
            found.insert(Node::Param(*id));
        }
        Kind::Def(id) | Kind::MakeSymbolic(id) | Kind::Eval(id, _) => {
            found.insert(Node::Definition(*id));
        }
        Kind::Call(call) => {
            found.insert(Node::Function(call.function));
        }
        _ => {}
    }
    e.children().into_iter().for_each(|child| sources(child, found));
}

fn captured_in(e: &Expr, defs: &[Def], captured: &mut BTreeSet<VarId>, seen: &mut HashSet<DefId>) {
    match &e.kind {
        Kind::Var(id) => {
            captured.insert(*id);
        }
        Kind::Def(id) if seen.insert(*id) => captured_in(&defs[id.0 as usize].expr, defs, captured, seen),
        _ => {}
    }
    e.children().into_iter().for_each(|child| captured_in(child, defs, captured, seen));
}
