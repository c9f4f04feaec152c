//! Lowers one function: converts statements to a graph of basic blocks.

use super::Lowering;
use super::function_values::{FunctionValue, Passed};
use super::sequence::calls;
use crate::ast::Mode;
use crate::check::flow;
use crate::check::tree::{DefId, Expr, FuncId, Kind, Place, Stmt, StmtKind, VarId};
use crate::check::types::{Substitution, Type};
use crate::diagnostic::Diagnostic;
use crate::hashed::{HashMap, HashSet};
use crate::ir::{self, Block, BlockId, Function, Local, LocalId, Statement, Terminator};
use crate::span::{FileId, Span};
use calyx_abi::Repr;

/// The targets of `break` and `continue`.
pub(super) struct Exit {
    pub(super) on_break: usize,
    pub(super) on_continue: Option<usize>,
}

struct Draft {
    statements: Vec<Statement>,
    terminator: Option<Terminator>,
    handler: Option<usize>,
    span: Span,
}

pub(super) struct Body<'l, 'c> {
    pub(super) lowering: &'l mut Lowering<'c>,
    /// The types of the scheme's variables in this instance.
    pub(super) types: Substitution,
    /// The functions that were passed for parameters.
    pub(super) functions: HashMap<VarId, FunctionValue>,
    /// Source range of the current statement.
    pub(super) span: Span,
    pub(super) function: FuncId,
    locals: Vec<Local>,
    by_variable: HashMap<VarId, LocalId>,
    blocks: Vec<Draft>,
    current: usize,
    /// `true` if the current position is reachable.
    alive: bool,
    reached: HashSet<usize>,
    pub(super) exits: Vec<Exit>,
    pub(super) labels: Vec<HashMap<String, usize>>,
    pub(super) cases: Vec<HashMap<Span, usize>>,
    /// The target of errors in new blocks.
    pub(super) handler: Option<usize>,
    /// `true` for an expression that is evaluated before the program runs.
    pub(super) is_constant: bool,
    /// `true` if some expression needs separate statements.
    pub(super) sequenced: bool,
    /// Errors handled by the enclosing `catch` sections, innermost last.
    pub(super) caught: Vec<LocalId>,
    /// The present value of the place that an enclosing `Update` assigns.
    pub(super) updated: Option<ir::Expr>,
}

impl<'l, 'c> Body<'l, 'c> {
    pub(super) fn new(lowering: &'l mut Lowering<'c>, function: FuncId, types: Substitution) -> Self {
        Body {
            lowering,
            types,
            functions: HashMap::default(),
            span: Span::default(),
            function,
            locals: Vec::new(),
            by_variable: HashMap::default(),
            blocks: vec![Draft {
                statements: Vec::new(),
                terminator: None,
                handler: None,
                span: Span::default(),
            }],
            current: 0,
            alive: true,
            reached: HashSet::from_iter([0]),
            exits: Vec::new(),
            labels: Vec::new(),
            cases: Vec::new(),
            handler: None,
            is_constant: false,
            sequenced: true,
            caught: Vec::new(),
            updated: None,
        }
    }

    /// Lowers a function and checks its control flow.
    pub(super) fn lower(
        lowering: &'l mut Lowering<'c>,
        id: FuncId,
        types: Substitution,
        passed: &Passed,
    ) -> Function {
        let checker = lowering.checker;
        let mut body = Body::new(lowering, id, types);
        body.receive(passed);
        let Some(function) = checker.functions.get(&id) else {
            return body.finish("", Vec::new(), Repr::Unit, Span::default());
        };
        body.lowering.list_instances_of(id);
        let modes = body.lowering.modes(id);
        let parameters: Vec<(LocalId, Mode)> =
            modes.into_iter().map(|(v, mode)| (body.local(v), mode)).collect();
        let result = body.repr(&function.result);
        body.begin(function.span);
        if let Some(host) = body.lowering.hosts.get(&(body.lowering.unit, id)).copied() {
            let own: Vec<VarId> = function.parameters.iter().map(|(id, _)| *id).collect();
            body.ask_host(host, &own, &result, function.span);
        }
        body.look_for_statements(function);
        if function.component == Some(id) {
            body.begin_instance(function.span);
        }
        body.block(&function.body);
        if body.alive {
            if result != Repr::Unit {
                body.lowering.report(
                    Diagnostic::error(
                        "E0317",
                        format!("`{}` can end without returning a value", function.name),
                        function.span,
                        "not every path ends with `return`",
                    )
                    .help("add a `return` with a value at its end"),
                );
            }
            body.end(Terminator::Return(None));
        }
        let name = match function.component == Some(id) {
            true => body.lowering.instance_name(&function.name),
            false => function.name.clone(),
        };
        let lowered = body.finish(&name, parameters, result, function.span);
        let shown = function.span.file == FileId(0);
        let found = flow::check(&lowered, shown);
        for diagnostic in found {
            lowering.report(diagnostic);
        }
        lowered
    }

    /// Receives the functions that a call passes.
    pub(super) fn receive(&mut self, passed: &Passed) {
        let Some(function) = self.lowering.checker.functions.get(&self.function) else { return };
        for (at, value) in passed {
            if let Some((parameter, _)) = function.parameters.get(*at) {
                self.functions.insert(*parameter, value.clone());
            }
        }
    }

    fn begin(&mut self, span: Span) {
        self.span = span;
        self.blocks[0].span = span;
    }

    /// Creates a function that returns the value of an expression.
    pub(super) fn lower_expression(lowering: &'l mut Lowering<'c>, name: &str, e: &Expr) -> Function {
        let mut body = Body::new(lowering, FuncId(0), Substitution::default());
        body.is_constant = true;
        body.begin(e.span);
        let value = body.owned(e);
        let repr = value.repr.clone();
        body.end(Terminator::Return(Some(value)));
        body.finish(name, Vec::new(), repr, e.span)
    }

    /// Removes unreachable blocks and numbers the others in order.
    fn finish(mut self, name: &str, parameters: Vec<(LocalId, Mode)>, result: Repr, span: Span) -> Function {
        let mut order = Vec::new();
        let mut number = vec![None; self.blocks.len()];
        let mut stack = vec![0];
        while let Some(at) = stack.pop() {
            if number[at].is_some() {
                continue;
            }
            number[at] = Some(BlockId(order.len() as u32));
            order.push(at);
            match &self.blocks[at].terminator {
                Some(Terminator::Jump(to)) => stack.push(to.0 as usize),
                Some(Terminator::Branch { then, otherwise, .. }) => {
                    stack.push(otherwise.0 as usize);
                    stack.push(then.0 as usize);
                }
                _ => {}
            }
            stack.extend(self.blocks[at].handler);
        }
        let renumber = |id: BlockId| number[id.0 as usize].unwrap_or(BlockId(0));
        let mut blocks = Vec::with_capacity(order.len());
        for at in order {
            let draft = &mut self.blocks[at];
            let terminator = match draft.terminator.take() {
                Some(Terminator::Jump(to)) => Terminator::Jump(renumber(to)),
                Some(Terminator::Branch { condition, then, otherwise }) => {
                    Terminator::Branch { condition, then: renumber(then), otherwise: renumber(otherwise) }
                }
                Some(other) => other,
                None => Terminator::Return(None),
            };
            let handler = draft.handler.map(|block| renumber(BlockId(block as u32)));
            let statements = std::mem::take(&mut draft.statements);
            blocks.push(Block { statements, terminator, handler, span: draft.span });
        }
        Function { name: name.into(), parameters, result, locals: self.locals, blocks, span }
    }

    // Locals and types.

    pub(super) fn repr(&self, ty: &Type) -> Repr {
        let store = &self.lowering.checker.store;
        store.repr(&self.types.ty(store, ty))
    }

    pub(super) fn local(&mut self, id: VarId) -> LocalId {
        if let Some(local) = self.by_variable.get(&id) {
            return *local;
        }
        let checker = self.lowering.checker;
        let repr = self.environment(id).unwrap_or_else(|| self.repr(&checker.type_of(id)));
        let repr = if checker.chosen.contains(&id) { Repr::Symbolic(Box::new(repr)) } else { repr };
        self.locals.push(Local { name: checker.variable(id).name.to_string(), repr });
        let local = LocalId(self.locals.len() as u32 - 1);
        self.by_variable.insert(id, local);
        local
    }

    pub(super) fn local_repr(&self, local: LocalId) -> Repr {
        self.locals[local.0 as usize].repr.clone()
    }

    pub(super) fn temporary(&mut self, value: ir::Expr) -> LocalId {
        let local = self.temporary_of(value.repr.clone());
        let (repr, span) = (value.repr.clone(), value.span);
        self.push(Statement::Assign { place: ir::Place::whole(local, repr), value, span });
        local
    }

    pub(super) fn temporary_of(&mut self, repr: Repr) -> LocalId {
        self.locals.push(Local { name: String::new(), repr });
        LocalId(self.locals.len() as u32 - 1)
    }

    // Blocks.

    pub(super) fn push(&mut self, statement: Statement) {
        self.blocks[self.current].statements.push(statement);
    }

    pub(super) fn new_block(&mut self) -> usize {
        let draft =
            Draft { statements: Vec::new(), terminator: None, handler: self.handler, span: self.span };
        self.blocks.push(draft);
        self.blocks.len() - 1
    }

    /// Marks a block as reachable by a path that is not a terminator.
    pub(super) fn reach(&mut self, block: usize) {
        if self.alive {
            self.reached.insert(block);
        }
    }

    pub(super) fn start(&mut self, block: usize) {
        self.current = block;
        self.alive = self.reached.contains(&block);
    }

    /// Ends the current block. Code that follows is unreachable until another block starts.
    pub(super) fn end(&mut self, terminator: Terminator) {
        if self.alive {
            match &terminator {
                Terminator::Jump(to) => {
                    self.reached.insert(to.0 as usize);
                }
                Terminator::Branch { then, otherwise, .. } => {
                    self.reached.extend([then.0 as usize, otherwise.0 as usize]);
                }
                Terminator::Return(_) | Terminator::Throw { .. } | Terminator::Rethrow(_) => {}
            }
        }
        self.blocks[self.current].terminator = Some(terminator);
        self.current = self.new_block();
        self.alive = false;
    }

    pub(super) fn jump(&mut self, to: usize) {
        self.end(Terminator::Jump(BlockId(to as u32)));
    }

    /// Branches on a condition; a constant condition becomes a jump.
    fn branch(&mut self, condition: &Expr, then: usize, otherwise: usize) {
        match condition.kind {
            Kind::Bool(true) => self.jump(then),
            Kind::Bool(false) => self.jump(otherwise),
            _ => {
                let condition = self.value(condition);
                self.branch_on(condition, then, otherwise);
            }
        }
    }

    pub(super) fn branch_on(&mut self, condition: ir::Expr, then: usize, otherwise: usize) {
        let (then, otherwise) = (BlockId(then as u32), BlockId(otherwise as u32));
        self.end(Terminator::Branch { condition, then, otherwise });
    }

    // Statements.

    pub(super) fn block(&mut self, statements: &[Stmt]) {
        let mut labels = HashMap::default();
        for mut statement in statements {
            while let StmtKind::Label(name, inner) = &statement.kind {
                let block = self.new_block();
                if labels.insert(name.clone(), block).is_some() {
                    self.lowering.report(
                        Diagnostic::error(
                            "E0202",
                            format!("the label `{name}` is declared twice in the same block"),
                            statement.span,
                            "declared again here",
                        )
                        .help("choose another name"),
                    );
                }
                statement = inner;
            }
        }
        self.labels.push(labels);
        let mut warned = false;
        for statement in statements {
            let entered = matches!(
                statement.kind,
                StmtKind::Nothing | StmtKind::Label(..) | StmtKind::Case(..) | StmtKind::Default(_)
            );
            if !self.alive && !warned && !entered {
                warned = true;
                if statement.span.file == FileId(0) {
                    self.lowering.report(
                        Diagnostic::warning("W0202", "this is unreachable", statement.span, "unreachable")
                            .help("remove it, or the `return`, `break` or `goto` before it")
                            .suggest("remove this statement", statement.span, ""),
                    );
                }
            }
            self.statement(statement);
        }
        self.labels.pop();
    }

    pub(super) fn nested(&mut self, statement: &Stmt) {
        match &statement.kind {
            StmtKind::Block(statements) => self.block(statements),
            _ => self.block(std::slice::from_ref(statement)),
        }
    }

    pub(super) fn statement(&mut self, statement: &Stmt) {
        let span = statement.span;
        self.span = span;
        match &statement.kind {
            StmtKind::Nothing => {}
            StmtKind::Assign(place, value) => self.assignment(place, value, span),
            StmtKind::Update(place, value) => self.update(place, value, span),
            StmtKind::Bind(name, def) => self.bind_name(*name, *def, span),
            StmtKind::Eval(value) => self.evaluate(value),
            StmtKind::Push(place, value) => {
                let place = self.place(place, self.needs_statements(value));
                let value = self.owned(value);
                self.push(Statement::Push { place, value, span });
            }
            StmtKind::Output(index, def) => self.output(*index, *def, span),
            StmtKind::ArrayOutput(index, value) => self.array_output(*index, value, span),
            StmtKind::Block(statements) => self.block(statements),
            StmtKind::If(condition, then, otherwise) => {
                self.if_statement(condition, then, otherwise.as_deref());
            }
            StmtKind::While(condition, body) => self.while_loop(condition, body),
            StmtKind::DoWhile(body, condition) => self.do_while_loop(body, condition),
            StmtKind::For { init, condition, step, body } => {
                self.for_loop(init, condition.as_ref(), step, body, span);
            }
            StmtKind::Switch(value, body) => self.switch(value, body),
            StmtKind::Case(_, inner) | StmtKind::Default(inner) => self.case(inner, span),
            StmtKind::Label(name, inner) => self.label(name, inner),
            StmtKind::Goto(name) => self.goto(name, span),
            StmtKind::Break => match self.exits.last().map(|exit| exit.on_break) {
                Some(to) => self.jump(to),
                None => self.outside("break", "a loop or `switch`", span),
            },
            StmtKind::Continue => match self.exits.iter().rev().find_map(|exit| exit.on_continue) {
                Some(to) => self.jump(to),
                None => self.outside("continue", "a loop", span),
            },
            StmtKind::Return(value) => {
                if self.lowering.checker.is_component(self.function) {
                    self.end_instance(span);
                }
                self.return_value(value.as_ref());
            }
            StmtKind::Throw(value) => self.throw(value.as_ref(), span),
            StmtKind::Try { body, error, handler } => self.try_catch(body, *error, handler),
        }
    }

    fn assignment(&mut self, place: &Place, value: &Expr, span: Span) {
        let place = self.place(place, self.needs_statements(value));
        match &value.kind {
            Kind::Call(call) if self.has_out_arguments(call.function) => {
                self.call_statement(call, Some(place), value.span);
            }
            _ => {
                let value = self.owned(value);
                self.push(Statement::Assign { place, value, span });
            }
        }
    }

    /// Assigns a place a value that is computed from its present value.
    fn update(&mut self, place: &Place, value: &Expr, span: Span) {
        let place = self.place(place, place.indices().any(calls) || self.needs_statements(value));
        let present = self.read(place.clone(), span);
        let present = if self.needs_statements(value) { self.kept(present) } else { present };
        let around = self.updated.replace(present);
        let value = self.owned(value);
        self.updated = around;
        self.push(Statement::Assign { place, value, span });
    }

    /// Binds a `:=` name, and stores its expression if the name is selected at run time.
    fn bind_name(&mut self, variable: VarId, def: DefId, span: Span) {
        self.bind(def);
        if self.lowering.checker.chosen.contains(&variable) {
            let value = self.symbolic_value(def, true, span);
            let local = self.local(variable);
            let place = ir::Place { local, steps: Vec::new(), repr: self.local_repr(local) };
            self.push(Statement::Assign { place, value, span });
        }
    }

    /// Evaluates an expression for its effects.
    fn evaluate(&mut self, value: &Expr) {
        let done = match &value.kind {
            Kind::Call(call) => self.call_statement(call, None, value.span),
            Kind::Assert(assertion) => {
                self.assertion(assertion, value.span);
                true
            }
            _ => false,
        };
        if !done {
            let value = self.value(value);
            self.push(Statement::Eval(value));
        }
    }

    fn if_statement(&mut self, condition: &Expr, then: &Stmt, otherwise: Option<&Stmt>) {
        let (on_true, after) = (self.new_block(), self.new_block());
        let on_false = if otherwise.is_some() { self.new_block() } else { after };
        self.branch(condition, on_true, on_false);
        self.start(on_true);
        self.nested(then);
        self.jump(after);
        if let Some(otherwise) = otherwise {
            self.start(on_false);
            self.nested(otherwise);
            self.jump(after);
        }
        self.start(after);
    }

    fn while_loop(&mut self, condition: &Expr, body: &Stmt) {
        self.span = condition.span;
        let (test, inside, after) = (self.new_block(), self.new_block(), self.new_block());
        self.jump(test);
        self.start(test);
        self.branch(condition, inside, after);
        self.start(inside);
        self.loop_body(body, after, test);
        self.jump(test);
        self.start(after);
    }

    fn do_while_loop(&mut self, body: &Stmt, condition: &Expr) {
        self.span = condition.span;
        let (inside, test, after) = (self.new_block(), self.new_block(), self.new_block());
        self.jump(inside);
        self.start(inside);
        self.loop_body(body, after, test);
        self.jump(test);
        self.start(test);
        self.branch(condition, inside, after);
        self.start(after);
    }

    fn for_loop(&mut self, init: &Stmt, condition: Option<&Expr>, step: &Stmt, body: &Stmt, span: Span) {
        self.statement(init);
        // The condition of a loop over values is not written.
        self.span = match condition {
            Some(condition) if condition.span.start < condition.span.end => condition.span,
            Some(_) => init.span,
            None => span,
        };
        let (test, inside) = (self.new_block(), self.new_block());
        let (next, after) = (self.new_block(), self.new_block());
        self.jump(test);
        self.start(test);
        match condition {
            Some(condition) => self.branch(condition, inside, after),
            None => self.jump(inside),
        }
        self.start(inside);
        self.loop_body(body, after, next);
        self.jump(next);
        self.start(next);
        self.statement(step);
        self.jump(test);
        self.start(after);
    }

    fn case(&mut self, inner: &Stmt, span: Span) {
        match self.cases.last().and_then(|cases| cases.get(&span).copied()) {
            Some(block) => {
                self.jump(block);
                self.start(block);
            }
            None => self.lowering.report(
                Diagnostic::error(
                    "E0214",
                    "a case must be directly in the body of its `switch`",
                    span,
                    "inside another statement",
                )
                .help("move it out of the enclosing block"),
            ),
        }
        self.statement(inner);
    }

    fn label(&mut self, name: &str, inner: &Stmt) {
        if let Some(block) = self.labels.last().and_then(|labels| labels.get(name).copied()) {
            self.jump(block);
            // A later `goto` may jump here.
            self.reached.insert(block);
            self.start(block);
        }
        self.statement(inner);
    }

    fn return_value(&mut self, value: Option<&Expr>) {
        let value = value.map(|value| self.owned(value));
        self.end(Terminator::Return(value));
    }

    fn loop_body(&mut self, body: &Stmt, on_break: usize, on_continue: usize) {
        self.exits.push(Exit { on_break, on_continue: Some(on_continue) });
        self.nested(body);
        self.exits.pop();
    }
}
