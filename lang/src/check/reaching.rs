//! Reaching definitions of `:=` names: those that hold after branches, loops and jumps.

use super::infer::{Checker, Reaching};
use super::symbols::Resolution;
use super::tree::VarId;
use crate::ast::{self, Bind, ExprKind};
use crate::walk::Node;
use std::collections::BTreeSet;

impl<'a> Checker<'a> {
    /// Finds the `:=` names that statements bind again after their declaration.
    pub(super) fn find_rebound(&mut self, statements: &'a [ast::Stmt]) {
        let mut bound = BTreeSet::new();
        statements.iter().for_each(|s| self.bound_in(s, &mut bound));
        self.rebound.extend(bound);
    }

    /// Collects the `:=` names assigned in a statement, without declarations.
    pub(super) fn bound_in(&self, statement: &ast::Stmt, bound: &mut BTreeSet<VarId>) {
        if let ast::StmtKind::Assign { place, bind: Bind::Symbolic, .. } = &statement.kind
            && let ExprKind::Name(name) = &place.kind
            && let Some(Resolution::Var(id)) = self.names.uses.get(&name.span)
        {
            bound.insert(*id);
        }
        Node::Statement(statement).children(&mut |child| {
            if let Node::Statement(inner) = child {
                self.bound_in(inner, bound);
            }
        });
    }

    /// Checks code that may run repeatedly or be entered in the middle: names bound in it have
    /// several reaching definitions at its start and after it.
    pub(super) fn repeated<T>(
        &mut self,
        statements: &[&'a ast::Stmt],
        work: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let mut bound = BTreeSet::new();
        statements.iter().for_each(|s| self.bound_in(s, &mut bound));
        self.forget(&bound);
        self.forget_present();
        let present = self.present.clone();
        let result = work(self);
        self.present = present;
        self.forget(&bound);
        result
    }

    /// Checks statements that may follow any statement within another one.
    pub(super) fn after_part_of<T>(
        &mut self,
        statement: &'a ast::Stmt,
        work: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let mut bound = BTreeSet::new();
        self.bound_in(statement, &mut bound);
        self.forget(&bound);
        self.forget_present();
        work(self)
    }

    /// Marks all rebound names at a target of jumps, where several definitions may reach.
    pub(super) fn forget_rebound(&mut self) {
        let rebound: BTreeSet<VarId> = self.rebound.iter().copied().collect();
        self.forget(&rebound);
        self.forget_present();
    }

    fn forget(&mut self, bound: &BTreeSet<VarId>) {
        for id in bound {
            if self.reaching.contains_key(id) {
                self.reaching.insert(*id, Reaching::Several);
            }
        }
    }

    /// Checks two alternative branches.
    pub(super) fn either<A, B>(
        &mut self,
        first: impl FnOnce(&mut Self) -> A,
        second: impl FnOnce(&mut Self) -> B,
    ) -> (A, B) {
        let before = self.reaching.clone();
        let present = self.present.clone();
        let a = first(self);
        let after_first = std::mem::replace(&mut self.reaching, before);
        let present_after_first = std::mem::replace(&mut self.present, present);
        let b = second(self);
        self.present.retain(|path| present_after_first.contains(path));
        for (id, reaching) in after_first {
            if *self.reaching.entry(id).or_insert(reaching) != reaching {
                self.reaching.insert(id, Reaching::Several);
            }
        }
        (a, b)
    }
}
