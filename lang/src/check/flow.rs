//! Control-flow checks: variables read before they have a value, and out parameters that are never
//! set.

use crate::ast::Mode;
use crate::diagnostic::Diagnostic;
use crate::ir::{Expr, ExprKind, FormatPart, Function, LocalId, Place, Statement, Terminator};
use crate::span::Span;

/// Checks a lowered function. Reports warnings only if `shown` is set.
pub fn check(function: &Function, shown: bool) -> Vec<Diagnostic> {
    let count = function.locals.len();
    let entry = {
        let mut set = Set::new(count, false);
        for (local, mode) in &function.parameters {
            if *mode != Mode::Out {
                set.insert(*local);
            }
        }
        set
    };
    // Locals assigned on every path to the start of each block; all locals until a path is found.
    let mut before = vec![Set::new(count, true); function.blocks.len()];
    if let Some(first) = before.first_mut() {
        *first = entry;
    }
    let mut work: Vec<usize> = (0..function.blocks.len()).rev().collect();
    while let Some(at) = work.pop() {
        let mut set = before[at].clone();
        for statement in &function.blocks[at].statements {
            assigned(statement, &mut set);
        }
        let successors = match &function.blocks[at].terminator {
            Terminator::Jump(to) => vec![to.0 as usize],
            Terminator::Branch { then, otherwise, .. } => vec![then.0 as usize, otherwise.0 as usize],
            Terminator::Return(_) | Terminator::Throw { .. } | Terminator::Rethrow(_) => Vec::new(),
        };
        for next in successors {
            if before[next].intersect(&set) {
                work.push(next);
            }
        }
        // An error may occur before the first assignment.
        if let Some(handler) = function.blocks[at].handler {
            let start = before[at].clone();
            if before[handler.0 as usize].intersect(&start) {
                work.push(handler.0 as usize);
            }
        }
    }
    let mut finder = Finder { function, reported: Set::new(count, false), diagnostics: Vec::new() };
    for (block, set) in function.blocks.iter().zip(before) {
        finder.set_of(block, set);
    }
    let mut diagnostics = finder.diagnostics;
    if !shown {
        diagnostics.retain(|d| d.severity == crate::diagnostic::Severity::Error);
    }
    diagnostics
}

/// A set of locals.
#[derive(Clone)]
struct Set(Vec<u64>);

impl Set {
    fn new(count: usize, full: bool) -> Set {
        Set(vec![if full { u64::MAX } else { 0 }; count.div_ceil(64)])
    }

    fn insert(&mut self, local: LocalId) {
        self.0[local.0 as usize / 64] |= 1 << (local.0 % 64);
    }

    fn contains(&self, local: LocalId) -> bool {
        self.0[local.0 as usize / 64] & (1 << (local.0 % 64)) != 0
    }

    /// Intersects with another set; returns `true` if the set changed.
    fn intersect(&mut self, other: &Set) -> bool {
        let mut changed = false;
        for (mine, theirs) in self.0.iter_mut().zip(&other.0) {
            changed |= *mine & !theirs != 0;
            *mine &= theirs;
        }
        changed
    }
}

fn assigned(statement: &Statement, set: &mut Set) {
    match statement {
        Statement::Assign { place, .. } if place.steps.is_empty() => set.insert(place.local),
        Statement::Call { result, copy_back, .. } => {
            for place in result.iter().chain(copy_back).filter(|place| place.steps.is_empty()) {
                set.insert(place.local);
            }
        }
        Statement::Host { result, provided, .. } => {
            set.insert(result.local);
            set.insert(provided.local);
        }
        _ => {}
    }
}

struct Finder<'f> {
    function: &'f Function,
    reported: Set,
    diagnostics: Vec<Diagnostic>,
}

impl Finder<'_> {
    fn set_of(&mut self, block: &crate::ir::Block, mut set: Set) {
        for statement in &block.statements {
            match statement {
                Statement::Assign { place, value, span } => {
                    self.place(place, &set, *span);
                    self.expr(value, &set);
                }
                Statement::Push { place, value, span } => {
                    self.read(place.local, *span, &set);
                    place.indices().for_each(|e| self.expr(e, &set));
                    self.expr(value, &set);
                }
                Statement::Eval(value) => self.expr(value, &set),
                Statement::Call { result, arguments, copy_back, span, .. } => {
                    arguments.iter().for_each(|e| self.expr(e, &set));
                    result.iter().chain(copy_back).for_each(|place| self.place(place, &set, *span));
                }
                Statement::Host { arguments, .. } => arguments.iter().for_each(|e| self.expr(e, &set)),
            }
            assigned(statement, &mut set);
        }
        match &block.terminator {
            Terminator::Jump(_) => {}
            Terminator::Branch { condition, .. } => self.expr(condition, &set),
            Terminator::Return(value) => {
                value.iter().for_each(|e| self.expr(e, &set));
                self.outputs(&set);
            }
            Terminator::Throw { error: value, .. } | Terminator::Rethrow(value) => self.expr(value, &set),
        }
    }

    fn outputs(&mut self, set: &Set) {
        for (local, mode) in &self.function.parameters {
            if *mode == Mode::Out && !set.contains(*local) && !self.reported.contains(*local) {
                self.reported.insert(*local);
                let name = &self.function.locals[local.0 as usize].name;
                self.diagnostics.push(
                    Diagnostic::error(
                        "E0218",
                        format!(
                            "`{}` can return before its out parameter `{name}` has a value",
                            self.function.name
                        ),
                        self.function.span,
                        "not assigned on every path",
                    )
                    .help(format!("assign `{name}` before every `return` and at the end")),
                );
            }
        }
    }

    fn place(&mut self, place: &Place, set: &Set, span: Span) {
        if !place.steps.is_empty() {
            self.read(place.local, span, set);
        }
        place.indices().for_each(|e| self.expr(e, set));
    }

    fn read(&mut self, local: LocalId, span: Span, set: &Set) {
        if set.contains(local) || self.reported.contains(local) {
            return;
        }
        self.reported.insert(local);
        let name = &self.function.locals[local.0 as usize].name;
        self.diagnostics.push(
            Diagnostic::error(
                "E0217",
                format!("`{name}` is read before it has a value"),
                span,
                "may have no value",
            )
            .help(format!("assign `{name}` on every path to this point")),
        );
    }

    fn expr(&mut self, e: &Expr, set: &Set) {
        match &e.kind {
            ExprKind::Local(local) => self.read(*local, e.span, set),
            ExprKind::Number(_)
            | ExprKind::Bool(_)
            | ExprKind::String(_)
            | ExprKind::Param(_)
            | ExprKind::Catch => {}
            ExprKind::Op(_, all)
            | ExprKind::Call(_, all)
            | ExprKind::CallExtern(_, all)
            | ExprKind::Array(all)
            | ExprKind::Tuple(all)
            | ExprKind::MakeSymbolic { captures: all, .. } => all.iter().for_each(|e| self.expr(e, set)),
            ExprKind::And(a, b) | ExprKind::Or(a, b) | ExprKind::Index(a, b) => {
                self.expr(a, set);
                self.expr(b, set);
            }
            ExprKind::If(a, b, c) => [a, b, c].into_iter().for_each(|e| self.expr(e, set)),
            ExprKind::TupleElement(a, _)
            | ExprKind::Copy(a)
            | ExprKind::Len(a)
            | ExprKind::CaughtFields(a) => self.expr(a, set),
            ExprKind::EvalSymbolic { value, time } => {
                self.expr(value, set);
                self.expr(time, set);
            }
            ExprKind::Format(parts) => {
                for part in parts {
                    if let FormatPart::Value(value, _) = part {
                        self.expr(value, set);
                    }
                }
            }
        }
    }
}
