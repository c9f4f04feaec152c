//! Analyses the dependence of values on params. A derivative with respect to a param, or a value at
//! another value of the param, must not miss a captured value that was computed from the param.
//!
//! A value depends on its operands, and on the conditions that control its assignment: the
//! conditions of the enclosing statements, of jumps past the assignment, of calls of its function,
//! and of earlier errors. The analysis is flow-insensitive and conservative: it may reject a
//! correct derivative, but it accepts no incorrect one.

use super::runtime_definitions::RuntimeDefinitions;
use super::tree::{Call, Def, DefId, Expr, FuncId, Function, Kind, PassedFunction, Place, Sym, VarId};
use crate::ast::BinaryOp;
use crate::hashed::{HashMap, HashSet};
use crate::ir::Op;
use crate::span::Span;
use std::collections::BTreeSet;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Node {
    Variable(VarId),
    Param(u32),
    /// The result and the out parameters of a function.
    Function(FuncId),
    Definition(DefId),
    /// The values that errors carry from `throw` to `catch`.
    Error,
    /// The conditions that decide which statements of a region run.
    Control(u32),
    /// The choice of the expression that a `:=` name has.
    Choice(VarId),
    /// The conditions of calls of a function.
    Called(FuncId),
    /// The conditions of `goto` statements in a function.
    Jumps(FuncId),
    /// The conditions of `return` and `throw` in a function.
    Leaves(FuncId),
    /// The causes of errors that end a function.
    Fails(FuncId),
}

impl Node {
    /// Returns `true` if the node controls the execution of statements, `false` if it is a value.
    fn is_control(self) -> bool {
        !matches!(
            self,
            Node::Variable(_) | Node::Param(_) | Node::Function(_) | Node::Definition(_) | Node::Error
        )
    }
}

/// A statement with conditions that control the statements in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    Choice,
    Switch,
    Loop,
    /// Any expression in it may leave it with an error.
    Try,
}

/// An operation that varies a param, although captured values do not change with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Question {
    Derivative,
    /// `e at p = v`.
    Value,
}

/// The reason why the operation would return an incorrect value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MissedDependence {
    /// The captured variable was computed from the param.
    Computed(VarId),
    /// The captured variable was assigned under a condition on the param.
    Conditional(VarId),
    /// A condition on the param selected the expression of the `:=` name.
    Chosen(VarId),
    /// The default of this other param depends on the param.
    Follows(u32),
}

#[derive(Debug)]
struct DependenceQuery {
    question: Question,
    param: u32,
    named: Named,
    span: Span,
}

/// The variables, params and functions in an expression.
#[derive(Clone, Debug, Default)]
struct Named {
    captured: BTreeSet<VarId>,
    params: BTreeSet<u32>,
    /// Functions that are inlined into the expression.
    functions: BTreeSet<FuncId>,
    /// `true` if the guesses of solutions do not count: a solution, and therefore its derivative,
    /// does not depend on the guess. At another value of a param, the guess selects one of several
    /// solutions.
    without_guesses: bool,
}

/// The function and the statements that contain the current position.
#[derive(Debug, Default)]
pub struct ControlContext {
    function: FuncId,
    regions: Vec<(Region, u32)>,
}

#[derive(Debug, Default)]
pub struct Dependence {
    edges: HashMap<Node, Vec<Node>>,
    asked: Vec<DependenceQuery>,
    around: ControlContext,
    controls: u32,
    /// Number of regions around the declaration of a variable. The conditions of these regions do
    /// not matter, because the variable exists only inside them.
    declared: HashMap<VarId, usize>,
}

impl Dependence {
    // The current position.

    /// Enters the body of a function, and returns the previous position.
    pub fn enter(&mut self, function: FuncId) -> ControlContext {
        std::mem::replace(&mut self.around, ControlContext { function, regions: Vec::new() })
    }

    pub fn leave(&mut self, around: ControlContext) {
        self.around = around;
    }

    pub fn open(&mut self, region: Region) {
        self.around.regions.push((region, self.controls));
        self.controls += 1;
    }

    pub fn close(&mut self) {
        self.around.regions.pop();
    }

    /// Moves from the body of a `try` to its handler.
    pub fn handle(&mut self) {
        let guarded = self.around.regions.pop();
        self.open(Region::Choice);
        if let (Some((_, guarded)), Some((_, handler))) = (guarded, self.around.regions.last()) {
            self.link(Node::Control(*handler), [Node::Control(guarded)]);
        }
    }

    /// Records that a value controls the statements of the innermost region.
    pub fn decides(&mut self, value: &Expr) {
        if let Some((_, control)) = self.around.regions.last() {
            self.add(Node::Control(*control), value);
        }
    }

    pub fn declare(&mut self, id: VarId) {
        self.declared.insert(id, self.around.regions.len());
    }

    pub fn break_out(&mut self) {
        self.jump_to(|region| matches!(region, Region::Loop | Region::Switch));
    }

    pub fn continue_loop(&mut self) {
        self.jump_to(|region| region == Region::Loop);
    }

    /// Adds the conditions of a jump to the regions that it leaves.
    fn jump_to(&mut self, end: impl Fn(Region) -> bool) {
        let here = self.conditions();
        let regions: Vec<_> = self.around.regions.iter().rev().copied().collect();
        for (region, control) in regions {
            self.link(Node::Control(control), here.iter().copied());
            if end(region) {
                break;
            }
        }
    }

    pub fn jump(&mut self) {
        let here = self.conditions();
        self.link(Node::Jumps(self.around.function), here);
    }

    pub fn leave_function(&mut self) {
        let here = self.conditions();
        self.link(Node::Leaves(self.around.function), here);
    }

    /// Returns the conditions of the current statement, given that its function is called.
    fn conditions(&self) -> Vec<Node> {
        let function = self.around.function;
        let regions = self.around.regions.iter().map(|(_, control)| Node::Control(*control));
        regions.chain([Node::Jumps(function), Node::Leaves(function)]).collect()
    }

    /// Returns the conditions of an assignment at the current position to a variable of the
    /// function `owner`.
    fn conditions_of(&self, id: VarId, owner: FuncId) -> Vec<Node> {
        let function = self.around.function;
        if owner != function {
            let mut all = self.conditions();
            all.push(Node::Called(function));
            return all;
        }
        let outside = self.declared.get(&id).copied().unwrap_or(0);
        let inside = self.around.regions.iter().skip(outside).map(|(_, control)| Node::Control(*control));
        inside.chain([Node::Jumps(function)]).collect()
    }

    // Operands of values.

    /// Records the value of a variable that no statement assigns: a parameter, or a variable
    /// captured by a `:=`.
    pub fn variable(&mut self, id: VarId, value: &Expr) {
        self.add(Node::Variable(id), value);
    }

    /// Records the assignment of a variable of the function `owner`, or of a part of the variable.
    pub fn assigned(&mut self, place: &Place, owner: FuncId, value: &Expr) {
        let node = Node::Variable(place.variable);
        self.add(node, value);
        for index in place.indices() {
            self.add(node, index);
            self.may_fail(Some(index));
        }
        self.link(node, self.conditions_of(place.variable, owner));
    }

    /// Records that a `:=` name is bound to a definition.
    pub fn bound(&mut self, id: VarId, owner: FuncId, def: DefId) {
        self.link(Node::Variable(id), [Node::Definition(def), Node::Choice(id)]);
        self.link(Node::Choice(id), self.conditions_of(id, owner));
    }

    /// Records that a function returns the value of a parameter.
    pub fn function_on_variable(&mut self, function: FuncId, id: VarId) {
        self.link(
            Node::Function(function),
            [Node::Variable(id), Node::Jumps(function), Node::Leaves(function)],
        );
    }

    pub fn returned(&mut self, function: FuncId, value: &Expr) {
        self.add(Node::Function(function), value);
        self.link(Node::Function(function), self.conditions());
    }

    pub fn thrown(&mut self, value: &Expr) {
        self.add(Node::Error, value);
        self.link(Node::Error, self.conditions());
    }

    /// Records that an error may contain the variable's value.
    pub fn thrown_variable(&mut self, id: VarId) {
        self.link(Node::Error, [Node::Variable(id)]);
    }

    /// Records the variable of the handler that is the innermost region.
    pub fn caught(&mut self, id: VarId) {
        let handler = self.around.regions.last().map(|(_, control)| Node::Control(*control));
        self.link(Node::Variable(id), handler.into_iter().chain([Node::Error]));
    }

    pub fn definition(&mut self, id: DefId, expr: &Expr) {
        self.add(Node::Definition(id), expr);
    }

    pub fn param(&mut self, id: u32, default: &Expr) {
        self.add(Node::Param(id), default);
    }

    /// Records that a statement evaluates an expression. The called functions run under the current
    /// conditions, and the evaluation may fail.
    pub fn evaluated(&mut self, e: &Expr, owner: &dyn Fn(VarId) -> FuncId) {
        if can_fail(e) {
            self.may_fail(Some(e));
        }
        self.calls(e, &[], owner);
    }

    /// Records that an error may occur here, in the evaluated expression if there is one.
    pub fn may_fail(&mut self, evaluated: Option<&Expr>) {
        let function = self.around.function;
        let guards = self.around.regions.iter().filter(|(region, _)| *region == Region::Try);
        let mut ends: Vec<Node> = guards.map(|(_, control)| Node::Control(*control)).collect();
        // The top level is never called.
        if function != FuncId(0) {
            ends.push(Node::Fails(function));
        }
        if ends.is_empty() {
            return;
        }
        let mut found = self.conditions();
        if let Some(e) = evaluated {
            sources(e, &mut found);
            called(e, &mut |call| {
                found.push(Node::Fails(call.function));
            });
        }
        ends.into_iter().for_each(|end| self.link(end, found.iter().copied()));
    }

    /// Records the calls in an expression; `guards` control its evaluation.
    fn calls(&mut self, e: &Expr, guards: &[Node], owner: &dyn Fn(VarId) -> FuncId) {
        match &e.kind {
            Kind::If(condition, then, otherwise) => {
                self.calls(condition, guards, owner);
                for arm in [then, otherwise].into_iter().filter(|arm| has_call(arm)) {
                    self.calls(arm, &guarded(guards, condition), owner);
                }
                return;
            }
            Kind::Binary(BinaryOp::And | BinaryOp::Or, a, b) => {
                self.calls(a, guards, owner);
                if has_call(b) {
                    self.calls(b, &guarded(guards, a), owner);
                }
                return;
            }
            // Its conditions decide which parts are evaluated.
            Kind::Sequence(..) => {
                if has_call(e) {
                    let guards = guarded(guards, e);
                    e.children().into_iter().for_each(|child| self.calls(child, &guards, owner));
                }
                return;
            }
            Kind::Call(call) => {
                let here = self.conditions();
                let around = Node::Called(self.around.function);
                self.link(
                    Node::Called(call.function),
                    here.into_iter().chain([around]).chain(guards.iter().copied()),
                );
                for place in &call.copy_back {
                    let node = Node::Variable(place.variable);
                    place.indices().for_each(|index| self.add(node, index));
                    let conditions = self.conditions_of(place.variable, owner(place.variable));
                    self.link(
                        node,
                        conditions
                            .into_iter()
                            .chain([Node::Function(call.function)])
                            .chain(guards.iter().copied()),
                    );
                }
            }
            _ => {}
        }
        e.children().into_iter().for_each(|child| self.calls(child, guards, owner));
    }

    /// Records that an expression is differentiated with respect to a symbol, or evaluated at
    /// another value of the symbol.
    pub fn asked(&mut self, question: Question, by: Sym, expr: &Expr, defs: &[Def], span: Span) {
        let Sym::Param(param) = by else { return };
        let named = Named::of(expr, question == Question::Derivative, defs);
        self.asked.push(DependenceQuery { question, param, named, span });
    }

    fn add(&mut self, node: Node, value: &Expr) {
        let found = self.edges.entry(node).or_default();
        sources(value, found);
    }

    fn link(&mut self, node: Node, to: impl IntoIterator<Item = Node>) {
        self.edges.entry(node).or_default().extend(to);
    }

    /// Returns `true` if a node depends on a param; `by_value` ignores conditions.
    fn depends(&self, from: Node, param: u32, by_value: bool) -> bool {
        let (mut seen, mut stack) = (HashSet::default(), vec![from]);
        while let Some(node) = stack.pop() {
            if node == Node::Param(param) {
                return true;
            }
            if seen.insert(node) {
                let next = self.edges.get(&node).into_iter().flatten().copied();
                stack.extend(next.filter(|to| !(by_value && to.is_control())));
            }
        }
        false
    }

    /// Returns the derivatives and values that would miss a dependence: operation, param, reason
    /// and location.
    pub fn blind(
        &self,
        defs: &[Def],
        graphs: &RuntimeDefinitions,
        functions: &HashMap<FuncId, Function>,
    ) -> Vec<(Question, u32, MissedDependence, Span)> {
        let why = |asked: &DependenceQuery| {
            let param = asked.param;
            let named = asked.named.with_functions(functions, defs);
            let (values, names) = through_graphs(&named, defs, graphs);
            let mut values = values.into_iter().map(Node::Variable);
            let hidden = values.find(|value| self.depends(*value, param, false));
            let hidden = hidden.map(|node| match node {
                Node::Variable(id) if !self.depends(node, param, true) => MissedDependence::Conditional(id),
                Node::Variable(id) => MissedDependence::Computed(id),
                _ => MissedDependence::Follows(param),
            });
            let chosen = || {
                let chosen = |id: &VarId| self.depends(Node::Choice(*id), param, false);
                names.into_iter().find(chosen).map(MissedDependence::Chosen)
            };
            let follows = || {
                let mut others = named.params.iter().filter(|other| **other != param);
                others
                    .find(|other| self.depends(Node::Param(**other), param, false))
                    .map(|id| MissedDependence::Follows(*id))
            };
            hidden.or_else(chosen).or_else(follows)
        };
        let all = self.asked.iter();
        all.filter_map(|asked| Some((asked.question, asked.param, why(asked)?, asked.span))).collect()
    }
}

/// Visited definitions, each with the params that an `at` replaces in it.
type Seen = HashSet<(DefId, Vec<u32>)>;

/// Number of nested `at` expressions whose params are excluded. The params of deeper ones count as
/// dependences, which is conservative.
const MOST_REPLACED: usize = 2;

impl Named {
    fn of(e: &Expr, without_guesses: bool, defs: &[Def]) -> Named {
        let mut named = Named { without_guesses, ..Named::default() };
        named.collect(e, defs, &[], &mut HashSet::default());
        named
    }

    /// Collects the names in an expression; `replaced` are the params that an enclosing `at`
    /// replaces.
    fn collect(&mut self, e: &Expr, defs: &[Def], replaced: &[u32], seen: &mut Seen) {
        match &e.kind {
            Kind::Var(id) => {
                self.captured.insert(*id);
            }
            Kind::Param(id) if !replaced.contains(id) => {
                self.params.insert(*id);
            }
            Kind::Def(id) if seen.insert((*id, replaced.to_vec())) => {
                self.collect(&defs[id.0 as usize].expr, defs, replaced, seen);
            }
            Kind::Call(call) | Kind::SymbolicCall(call) => {
                self.functions.insert(call.function);
            }
            Kind::Function(PassedFunction::Declared(function, _), _) => {
                self.functions.insert(*function);
            }
            Kind::Function(PassedFunction::Parameter(id), _) => {
                self.captured.insert(*id);
            }
            Kind::Applied(applied) => {
                self.captured.insert(applied.parameter);
            }
            Kind::At(inner, Sym::Param(param), at) if replaced.len() < MOST_REPLACED => {
                let mut more = replaced.to_vec();
                more.push(*param);
                more.sort_unstable();
                more.dedup();
                self.collect(inner, defs, &more, seen);
                return self.collect(at, defs, replaced, seen);
            }
            _ => {}
        }
        let mut parts = e.children();
        if self.without_guesses && is_solution(e) {
            parts.remove(0);
        }
        parts.into_iter().for_each(|child| self.collect(child, defs, replaced, seen));
    }

    /// Adds the params that the named functions use. A function with only a header in the excerpt
    /// uses no params.
    fn with_functions(&self, functions: &HashMap<FuncId, Function>, defs: &[Def]) -> Named {
        let mut all = self.clone();
        let mut seen = HashSet::default();
        let mut pending: Vec<FuncId> = self.functions.iter().copied().collect();
        while let Some(id) = pending.pop() {
            let Some(function) = functions.get(&id).filter(|_| seen.insert(id)) else { continue };
            let mut inner = Named { without_guesses: self.without_guesses, ..Named::default() };
            let mut met = Seen::default();
            if let Some(body) = &function.definition {
                inner.collect(&defs[body.def.0 as usize].expr, defs, &[], &mut met);
            }
            for statement in &function.body {
                statement.walk(&mut |s| {
                    s.expressions().into_iter().for_each(|e| inner.collect(e, defs, &[], &mut met));
                });
            }
            // The variables of the function are local to it.
            all.params.extend(inner.params);
            pending.extend(inner.functions);
        }
        all
    }
}

/// Returns the values captured by an expression and, transitively, by the expressions that it
/// captures, together with the names of the latter.
fn through_graphs(
    named: &Named,
    defs: &[Def],
    graphs: &RuntimeDefinitions,
) -> (BTreeSet<VarId>, BTreeSet<VarId>) {
    let (mut values, mut seen, mut met) = (BTreeSet::new(), Seen::default(), BTreeSet::new());
    let mut pending: Vec<VarId> = named.captured.iter().copied().collect();
    while let Some(id) = pending.pop() {
        let Some(name) = graphs.captured.get(&id) else {
            values.insert(id);
            continue;
        };
        if met.insert(*name) {
            let mut found = Named { without_guesses: named.without_guesses, ..Named::default() };
            for def in graphs.bound.get(name).into_iter().flatten() {
                found.collect(&defs[def.0 as usize].expr, defs, &[], &mut seen);
            }
            pending.extend(found.captured);
        }
    }
    (values, met)
}

/// Returns `true` for a solution of an equation or a minimum. Its first operand is the guess.
fn is_solution(e: &Expr) -> bool {
    match &e.kind {
        Kind::Call(call) | Kind::SymbolicCall(call) => call.search.is_some() && !call.arguments.is_empty(),
        Kind::Applied(applied) => applied.search.is_some() && !applied.arguments.is_empty(),
        _ => false,
    }
}

fn sources(e: &Expr, found: &mut Vec<Node>) {
    match &e.kind {
        Kind::Var(id) | Kind::Chosen(id) => {
            found.push(Node::Variable(*id));
        }
        Kind::Param(id) => {
            found.push(Node::Param(*id));
        }
        Kind::Def(id) | Kind::MakeSymbolic(id) | Kind::Eval(id, _) => {
            found.push(Node::Definition(*id));
        }
        Kind::Call(call) | Kind::SymbolicCall(call) => {
            found.push(Node::Function(call.function));
        }
        Kind::Function(PassedFunction::Declared(function, _), _) => {
            found.push(Node::Function(*function));
        }
        Kind::Function(PassedFunction::Parameter(id), _) => {
            found.push(Node::Variable(*id));
        }
        Kind::Applied(applied) => {
            found.push(Node::Variable(applied.parameter));
        }
        _ => {}
    }
    e.children().into_iter().for_each(|child| sources(child, found));
}

/// Returns `true` if the evaluation of an expression may fail.
fn can_fail(e: &Expr) -> bool {
    let itself = matches!(
        e.kind,
        Kind::Index(..)
            | Kind::Call(_)
            | Kind::Applied(_)
            | Kind::CallExtern(..)
            | Kind::Standard(..)
            | Kind::Assert(_)
            | Kind::Op(Op::Rotate, _)
    );
    itself || e.children().into_iter().any(can_fail)
}

/// Returns the guards of an operand that is evaluated under a further condition.
fn guarded(guards: &[Node], condition: &Expr) -> Vec<Node> {
    let mut all = guards.to_vec();
    sources(condition, &mut all);
    all
}

fn has_call(e: &Expr) -> bool {
    matches!(e.kind, Kind::Call(_)) || e.children().into_iter().any(has_call)
}

/// Visits the calls in an expression.
fn called(e: &Expr, visit: &mut dyn FnMut(&Call)) {
    if let Kind::Call(call) = &e.kind {
        visit(call);
    }
    e.children().into_iter().for_each(|child| called(child, visit));
}
