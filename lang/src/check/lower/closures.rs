//! Closure conversion: makes the outer variables of functions explicit.
//!
//! The typed program has no nested functions. A function receives its outer variables as additional
//! parameters: `in` if neither it nor its callees assign them, otherwise `inout`.

use crate::check::tree::{Def, DefId, Expr, FuncId, Function, Kind, StmtKind, VarId};
use crate::hashed::{HashMap, HashSet};
use std::collections::{BTreeMap, BTreeSet};

/// The outer variables of a function, and whether it assigns them.
pub type Closure = BTreeMap<VarId, bool>;

/// Returns the closures of all functions, including the needs of their callees.
pub fn closures(
    functions: &HashMap<FuncId, Function>,
    defs: &[Def],
    chosen: &BTreeSet<VarId>,
    owner: &dyn Fn(VarId) -> FuncId,
) -> HashMap<FuncId, Closure> {
    let mut closures: HashMap<FuncId, Closure> = HashMap::default();
    let mut callees: HashMap<FuncId, HashSet<FuncId>> = HashMap::default();
    for (&id, function) in functions {
        let mut walk =
            Walk { defs, used: BTreeMap::new(), called: HashSet::default(), seen: HashSet::default() };
        for statement in &function.body {
            statement.walk(&mut |s| {
                match &s.kind {
                    StmtKind::Assign(place, _) | StmtKind::Update(place, _) | StmtKind::Push(place, _) => {
                        walk.used.insert(place.variable, true);
                    }
                    StmtKind::Bind(name, def) => {
                        walk.binding(*def);
                        if chosen.contains(name) {
                            walk.used.insert(*name, true);
                        }
                    }
                    StmtKind::Output(_, def) => walk.binding(*def),
                    _ => {}
                }
                s.expressions().into_iter().for_each(|e| walk.expr(e));
            });
        }
        walk.used.retain(|variable, _| owner(*variable) != id);
        closures.insert(id, walk.used);
        callees.insert(id, walk.called);
    }
    let mut changed = true;
    while changed {
        changed = false;
        for (id, called) in &callees {
            let needs: Vec<(VarId, bool)> = called
                .iter()
                .filter_map(|callee| closures.get(callee))
                .flatten()
                .map(|(variable, assigned)| (*variable, *assigned))
                .filter(|(variable, _)| owner(*variable) != *id)
                .collect();
            let Some(own) = closures.get_mut(id) else { continue };
            for (variable, assigned) in needs {
                let entry = own.get(&variable).copied();
                if entry.is_none_or(|known| assigned && !known) {
                    own.insert(variable, assigned || entry == Some(true));
                    changed = true;
                }
            }
        }
    }
    closures
}

struct Walk<'d> {
    defs: &'d [Def],
    used: BTreeMap<VarId, bool>,
    called: HashSet<FuncId>,
    seen: HashSet<DefId>,
}

impl Walk<'_> {
    fn expr(&mut self, e: &Expr) {
        match &e.kind {
            Kind::Var(id) | Kind::Chosen(id) => {
                self.used.entry(*id).or_insert(false);
            }
            Kind::Def(def) => self.fused(*def),
            Kind::MakeSymbolic(def) | Kind::Eval(def, _) if self.defs[def.0 as usize].stored => {
                self.fused(*def)
            }
            Kind::MakeSymbolic(def) | Kind::Eval(def, _) => self.binding(*def),
            Kind::Call(call) => {
                self.called.insert(call.function);
                for place in &call.copy_back {
                    self.used.insert(place.variable, true);
                }
            }
            _ => {}
        }
        e.children().into_iter().for_each(|child| self.expr(child));
    }

    /// Visits a `:=` that executes here: it reads its captures.
    fn binding(&mut self, def: DefId) {
        let defs = self.defs;
        for (hidden, value) in &defs[def.0 as usize].captures {
            self.used.insert(*hidden, true);
            self.expr(value);
        }
        self.fused(def);
    }

    /// Visits a use of a `:=` that executed before: it reads the captured values.
    fn fused(&mut self, def: DefId) {
        if self.seen.insert(def) {
            let defs = self.defs;
            self.expr(&defs[def.0 as usize].expr);
        }
    }
}
