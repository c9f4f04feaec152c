//! Functions whose calls are repeatable: equal arguments give equal results, in this program and in
//! others, for instance in the model before an edit.
//!
//! A repeatable function of the library reads no param and no file, has no effect, and exchanges
//! only plain data with its callers: no handles and no symbolic values. Its fingerprint covers
//! everything that its results depend on besides the arguments: its own code, the kernels that it
//! evaluates, and its callees. Functions of models are not repeatable, because the location of an
//! error that they catch changes with every edit above them.

use crate::fingerprint::{Fingerprint, FingerprintHasher};
use crate::kernels::SiteContent;
use calyx_abi::description::LIBRARY;
use calyx_abi::{Purity, Repr, standard};
use calyx_lang::ir::{
    BlockId, Expr, ExprKind, ExternId, FormatPart, Function, FunctionId, Place, Program, Site, SiteId,
    Statement, Step, SymExpr, SymKind, Symbol, SymbolicFunctionId, Terminator,
};
use std::collections::HashMap;
use std::hash::Hash;

/// The repeatable functions of a program.
#[derive(Debug)]
pub struct RepeatableFunctions(Vec<State>);

/// A function whose calls are repeatable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Repeatable {
    pub(crate) content: Fingerprint,
    /// Largest depth of calls, including this one.
    pub(crate) depth: u64,
    /// `true` if it or a callee evaluates kernels.
    evaluates: bool,
    /// `true` if it or a callee evaluates kernels in a loop. Other functions take less time than
    /// finding an earlier result.
    is_long: bool,
}

/// The state of the analysis of a function.
#[derive(Clone, Copy, Debug)]
enum State {
    Unknown,
    /// Being analysed. Recursive functions are not repeatable.
    Active,
    Known(Option<Repeatable>),
}

impl RepeatableFunctions {
    /// Finds the repeatable functions of a program. `sites` contains the contents of its sites, in
    /// order.
    pub fn of(program: &Program, sites: &[SiteContent]) -> Self {
        let mut analysis = Analysis {
            program,
            sites,
            functions: vec![State::Unknown; program.functions.len()],
            closed: vec![None; program.sites.len()],
            symbolic: HashMap::new(),
        };
        for id in 0..program.functions.len() as u32 {
            analysis.function(FunctionId(id));
        }
        RepeatableFunctions(analysis.functions)
    }

    /// Returns the properties of a function whose calls are repeatable and long.
    pub(crate) fn long(&self, id: FunctionId) -> Option<Repeatable> {
        match self.0.get(id.0 as usize)? {
            State::Known(found) => found.filter(|function| function.is_long),
            _ => None,
        }
    }
}

/// Returns `true` if values of a representation consist of numbers, texts and truth values.
fn is_plain(repr: &Repr) -> bool {
    match repr {
        Repr::Unit | Repr::Number | Repr::Bool | Repr::String | Repr::Vector | Repr::Transform => true,
        Repr::Array(element) => is_plain(element),
        Repr::Tuple(parts) => parts.iter().all(is_plain),
        Repr::Symbolic(_) | Repr::Handle => false,
    }
}

struct Analysis<'p> {
    program: &'p Program,
    sites: &'p [SiteContent],
    functions: Vec<State>,
    /// Sites whose kernels read no param and no observable.
    closed: Vec<Option<bool>>,
    /// The same for symbolic functions.
    symbolic: HashMap<u32, bool>,
}

impl<'p> Analysis<'p> {
    fn function(&mut self, id: FunctionId) -> Option<Repeatable> {
        let index = id.0 as usize;
        match *self.functions.get(index)? {
            State::Unknown => {}
            State::Active => return None,
            State::Known(found) => return found,
        }
        self.functions[index] = State::Active;
        let program: &'p Program = self.program;
        let found = self.analyse(&program.functions[index]);
        self.functions[index] = State::Known(found);
        found
    }

    fn analyse(&mut self, function: &'p Function) -> Option<Repeatable> {
        let file = &self.program.files.get(function.span.file.0 as usize)?.name;
        let parameters =
            function.parameters.iter().map(|(local, mode)| (function.locals.get(local.0 as usize), mode));
        if !file.starts_with(LIBRARY)
            || !is_plain(&function.result)
            || !parameters.clone().all(|(local, _)| local.is_some_and(|local| is_plain(&local.repr)))
        {
            return None;
        }
        let mut content = Content {
            analysis: self,
            hasher: FingerprintHasher::default(),
            depth: 0,
            evaluates: false,
            is_long: false,
        };
        let hasher = &mut content.hasher;
        // Caught errors have locations.
        (file, function.span.start, function.span.end).hash(hasher);
        (&function.result, function.locals.len(), function.parameters.len()).hash(hasher);
        function.locals.iter().for_each(|local| local.repr.hash(hasher));
        for (local, mode) in &function.parameters {
            (local.0, std::mem::discriminant(mode)).hash(hasher);
        }
        let mut loops = false;
        for (index, block) in function.blocks.iter().enumerate() {
            let index = BlockId(index as u32);
            content.block(block)?;
            loops |= match block.terminator {
                Terminator::Jump(target) => target <= index,
                Terminator::Branch { then, otherwise, .. } => then <= index || otherwise <= index,
                _ => false,
            };
        }
        Some(Repeatable {
            content: content.hasher.fingerprint(),
            depth: content.depth + 1,
            evaluates: content.evaluates,
            is_long: content.is_long || loops && content.evaluates,
        })
    }

    /// Returns `true` if the kernel of a site depends on its captured values only.
    fn is_closed(&mut self, id: SiteId) -> bool {
        let index = id.0 as usize;
        let program: &'p Program = self.program;
        let Some(site) = program.sites.get(index) else { return false };
        if let Some(known) = self.closed[index] {
            return known;
        }
        let closed = self.is_closed_site(site);
        self.closed[index] = Some(closed);
        closed
    }

    fn is_closed_site(&mut self, site: &'p Site) -> bool {
        !site.captures.iter().any(|capture| capture.observable)
            && site.shared.iter().chain([&site.expr]).all(|expr| self.reads_no_param(expr))
    }

    fn is_closed_function(&mut self, id: SymbolicFunctionId) -> bool {
        if let Some(known) = self.symbolic.get(&id.0) {
            return *known;
        }
        let program: &'p Program = self.program;
        let Some(function) = program.symbolic_functions.get(id.0 as usize) else { return false };
        let closed = function.shared.iter().chain([&function.body]).all(|expr| self.reads_no_param(expr));
        self.symbolic.insert(id.0, closed);
        closed
    }

    fn reads_no_param(&mut self, expr: &'p SymExpr) -> bool {
        let mut left = vec![expr];
        while let Some(expr) = left.pop() {
            let closed = match &expr.kind {
                SymKind::Param(_)
                | SymKind::Derivative(_, Symbol::Param(_))
                | SymKind::At(_, Symbol::Param(_), _) => false,
                SymKind::Call(id, _) | SymKind::Solve(_, id, _) => self.is_closed_function(*id),
                _ => true,
            };
            if !closed {
                return false;
            }
            left.extend(expr.operands());
        }
        true
    }
}

/// The content of a function, in the order of its text. Methods return `None` for what makes a
/// function not repeatable.
struct Content<'a, 'p> {
    analysis: &'a mut Analysis<'p>,
    hasher: FingerprintHasher,
    /// Largest depth of calls of the callees.
    depth: u64,
    /// `true` if the function or a callee evaluates kernels.
    evaluates: bool,
    /// `true` if a callee is long.
    is_long: bool,
}

impl<'p> Content<'_, 'p> {
    fn block(&mut self, block: &'p calyx_lang::ir::Block) -> Option<()> {
        (block.statements.len(), block.handler.map(|handler| handler.0)).hash(&mut self.hasher);
        block.statements.iter().try_for_each(|statement| self.statement(statement))?;
        std::mem::discriminant(&block.terminator).hash(&mut self.hasher);
        match &block.terminator {
            Terminator::Jump(target) => target.0.hash(&mut self.hasher),
            Terminator::Branch { condition, then, otherwise } => {
                (then.0, otherwise.0).hash(&mut self.hasher);
                self.expression(condition)?;
            }
            Terminator::Return(value) => {
                value.is_some().hash(&mut self.hasher);
                value.iter().try_for_each(|value| self.expression(value))?;
            }
            Terminator::Throw { error, help, .. } => {
                help.hash(&mut self.hasher);
                self.expression(error)?;
            }
            Terminator::Rethrow(caught) => self.expression(caught)?,
        }
        Some(())
    }

    fn statement(&mut self, statement: &'p Statement) -> Option<()> {
        std::mem::discriminant(statement).hash(&mut self.hasher);
        match statement {
            Statement::Assign { place, value, .. } | Statement::Push { place, value, .. } => {
                self.place(place)?;
                self.expression(value)
            }
            Statement::Eval(value) => self.expression(value),
            Statement::Call { result, function, arguments, copy_back, .. } => {
                self.call(*function)?;
                (result.is_some(), copy_back.len()).hash(&mut self.hasher);
                result.iter().chain(copy_back).try_for_each(|place| self.place(place))?;
                self.expressions(arguments)
            }
            // Each run may provide another function.
            Statement::Host { .. } => None,
        }
    }

    fn place(&mut self, place: &'p Place) -> Option<()> {
        (place.local.0, &place.repr, place.steps.len()).hash(&mut self.hasher);
        place.steps.iter().try_for_each(|step| match step {
            Step::Index(index) => {
                true.hash(&mut self.hasher);
                self.expression(index)
            }
            Step::Element(at) => {
                (false, at).hash(&mut self.hasher);
                Some(())
            }
        })
    }

    fn expressions(&mut self, expressions: &'p [Expr]) -> Option<()> {
        expressions.len().hash(&mut self.hasher);
        expressions.iter().try_for_each(|expr| self.expression(expr))
    }

    fn expression(&mut self, expr: &'p Expr) -> Option<()> {
        std::mem::discriminant(&expr.kind).hash(&mut self.hasher);
        expr.repr.hash(&mut self.hasher);
        match &expr.kind {
            ExprKind::Number(value) => value.to_bits().hash(&mut self.hasher),
            ExprKind::Bool(value) => value.hash(&mut self.hasher),
            ExprKind::String(text) => text.hash(&mut self.hasher),
            ExprKind::Local(local) => local.0.hash(&mut self.hasher),
            ExprKind::Param(_) => return None,
            ExprKind::Op(op, operands) => {
                op.hash(&mut self.hasher);
                self.expressions(operands)?;
            }
            ExprKind::And(a, b) | ExprKind::Or(a, b) | ExprKind::Index(a, b) => {
                self.expression(a)?;
                self.expression(b)?;
            }
            ExprKind::If(condition, then, otherwise) => {
                self.expression(condition)?;
                self.expression(then)?;
                self.expression(otherwise)?;
            }
            ExprKind::Call(callee, arguments) => {
                self.call(*callee)?;
                self.expressions(arguments)?;
            }
            ExprKind::CallExtern(id, arguments) => {
                self.engine_call(*id)?;
                self.expressions(arguments)?;
            }
            ExprKind::Array(parts) | ExprKind::Tuple(parts) => self.expressions(parts)?,
            ExprKind::TupleElement(tuple, index) => {
                index.hash(&mut self.hasher);
                self.expression(tuple)?;
            }
            ExprKind::Copy(value) | ExprKind::Len(value) | ExprKind::CaughtFields(value) => {
                self.expression(value)?;
            }
            ExprKind::Format(parts) => {
                parts.len().hash(&mut self.hasher);
                parts.iter().try_for_each(|part| self.format_part(part))?;
            }
            ExprKind::Catch => {}
            ExprKind::MakeSymbolic { site, captures } => {
                if !self.analysis.is_closed(*site) {
                    return None;
                }
                self.analysis.sites.get(site.0 as usize)?.hash(&mut self.hasher);
                self.expressions(captures)?;
            }
            ExprKind::EvalSymbolic { value, time } => {
                self.evaluates = true;
                self.expression(value)?;
                self.expression(time)?;
            }
        }
        Some(())
    }

    fn format_part(&mut self, part: &'p FormatPart) -> Option<()> {
        match part {
            FormatPart::Text(text) => text.hash(&mut self.hasher),
            FormatPart::Value(value, display) => {
                display.encode().hash(&mut self.hasher);
                self.expression(value)?;
            }
        }
        Some(())
    }

    fn call(&mut self, id: FunctionId) -> Option<()> {
        let callee = self.analysis.function(id)?;
        callee.content.hash(&mut self.hasher);
        self.depth = self.depth.max(callee.depth);
        self.is_long |= callee.is_long;
        self.evaluates |= callee.evaluates;
        Some(())
    }

    /// Engine functions of the language depend on their arguments only if they are pure. Numbers of
    /// tables that they return are valid in this process.
    fn engine_call(&mut self, id: ExternId) -> Option<()> {
        let declaration = self.analysis.program.externs.get(id.0 as usize)?;
        let mut rows = standard::EXTERNS.iter();
        rows.find(|row| row.symbol == declaration.symbol && row.purity == Purity::Pure)?;
        declaration.symbol.hash(&mut self.hasher);
        Some(())
    }
}
