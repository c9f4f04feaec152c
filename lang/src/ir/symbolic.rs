//! Symbolic expressions of the typed program: the `:=` bindings, the values that they capture, and
//! symbolic functions.

use super::{DisplayUnit, Op, Program, SymbolicFunctionId};
use crate::span::Span;
use calyx_abi::Repr;
use calyx_abi::newton::Search;
use std::sync::Arc;

/// A symbolic expression in the source: one kernel, and one set of captured values per execution.
#[derive(Clone, Debug)]
pub struct Site {
    /// Name of the binding, for messages and for the symbol of its kernel.
    pub name: String,
    /// Shared subexpressions; each may refer to earlier ones ([`SymKind::Shared`]).
    pub shared: Vec<SymExpr>,
    pub expr: SymExpr,
    /// Values captured when the binding executes, in order of `SymExpr::Capture`.
    pub captures: Vec<Capture>,
    /// Number, Vector or Transform; a tuple of these for bracket expressions.
    pub repr: Repr,
    /// Order of the highest time derivative that its kernel computes: 2 for a transform, otherwise
    /// 0.
    pub order: u8,
    /// `true` if other sites may capture its value. The kernel then computes time derivatives up to
    /// order 2, followed by the same outputs differentiated by each of [`Program::graph_params`].
    pub part: bool,
    pub span: Span,
}

impl Site {
    /// Returns the number of its kernel's inputs: time, every param, and the captured values.
    pub fn inputs(&self, program: &Program) -> usize {
        let captured = self.captures.iter().map(|capture| capture.inputs(program));
        1 + program.params.len() + captured.sum::<usize>()
    }

    /// Returns the number of its kernel's outputs.
    pub fn outputs(&self, program: &Program) -> usize {
        let by = if self.part { 1 + program.graph_params.len() } else { 1 };
        self.repr.slots() * (1 + usize::from(self.order)) * by
    }
}

#[derive(Clone, Debug)]
pub struct Capture {
    pub name: String,
    /// Number, Bool, Vector or Transform; a tuple for a record, in which no expression reads the
    /// texts. For an observable, `Symbolic(Number)` with `observable`
    /// set. For an expression (the value of a site that is a [`Site::part`]), `Symbolic` of Number,
    /// Vector or Transform; a tuple may contain such expressions.
    pub repr: Repr,
    pub observable: bool,
}

impl Capture {
    /// Returns `true` for an expression, or a record with one: the outputs of its site's kernel are
    /// inputs of the capturing kernel.
    pub fn is_part(&self) -> bool {
        fn has_expression(repr: &Repr) -> bool {
            match repr {
                Repr::Symbolic(_) => true,
                Repr::Tuple(parts) => parts.iter().any(has_expression),
                _ => false,
            }
        }
        !self.observable && has_expression(&self.repr)
    }

    /// Returns the number of kernel inputs that it takes.
    pub fn inputs(&self, program: &Program) -> usize {
        if self.observable { self.repr.slots() } else { captured_inputs(&self.repr, program) }
    }
}

/// Returns the number of kernel inputs for a captured value that is no observable: of an
/// expression, all outputs of its kernel.
pub fn captured_inputs(repr: &Repr, program: &Program) -> usize {
    match repr {
        Repr::Symbolic(inner) => inner.slots() * 3 * (1 + program.graph_params.len()),
        Repr::Tuple(parts) => parts.iter().map(|part| captured_inputs(part, program)).sum(),
        repr => repr.slots(),
    }
}

/// A symbolic function `function p(in u, in th) := e;`: an expression with free arguments. The
/// inputs of its kernel are time, every param by index, and the arguments in order; the outputs are
/// those of `result` in order (see `calyx_lower::kernels`).
#[derive(Clone, Debug)]
pub struct SymbolicFunction {
    pub name: String,
    pub doc: String,
    pub parameters: Vec<SymbolicParameter>,
    /// Shared subexpressions; each may refer to earlier ones ([`SymKind::Shared`]).
    pub shared: Vec<SymExpr>,
    pub body: SymExpr,
    /// Number, Bool, Vector or Transform; a tuple of these for brackets. Arrays are also tuples,
    /// because all lengths are known.
    pub result: Repr,
    /// Display units, one per value of `result` that is not a tuple. For a frame, the unit of its
    /// translation.
    pub units: Vec<DisplayUnit>,
    /// `true` for a top-level function of the model itself, which embedding programs can call by
    /// name. Exported names are unique.
    pub exported: bool,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub struct SymbolicParameter {
    pub name: String,
    /// Number, Bool, Vector or Transform; a tuple of these for a record or for brackets. An
    /// exported function has no parameters of the last two kinds.
    pub repr: Repr,
    /// Display unit of the argument; dimensionless if the function accepts any dimension.
    pub unit: DisplayUnit,
}

/// A typed symbolic expression. The lowering converts it to a graph.
#[derive(Clone, Debug)]
pub struct SymExpr {
    pub kind: SymKind,
    /// Number, Bool, Vector or Transform, or a tuple of these.
    pub repr: Repr,
    pub span: Span,
}

impl SymExpr {
    /// Returns the direct operands.
    pub fn operands(&self) -> Vec<&SymExpr> {
        match &self.kind {
            SymKind::Number(_)
            | SymKind::Bool(_)
            | SymKind::Time
            | SymKind::Param(_)
            | SymKind::Capture(_)
            | SymKind::Argument(_)
            | SymKind::Shared(_) => Vec::new(),
            SymKind::Op(_, all)
            | SymKind::Call(_, all)
            | SymKind::Solve(_, _, all)
            | SymKind::Brackets(all) => all.iter().collect(),
            SymKind::If(a, b, c) => vec![a, b, c],
            SymKind::Derivative(a, _) | SymKind::Element(a, _) | SymKind::Table(_, a) => vec![a],
            SymKind::At(a, _, b) => vec![a, b],
        }
    }
}

#[derive(Clone, Debug)]
pub enum SymKind {
    Number(f64),
    Bool(bool),
    /// Time since the start of the motion, s.
    Time,
    /// A number param: an index of `Program::params`.
    Param(u32),
    /// An index of `Site::captures`.
    Capture(u32),
    /// An index of `SymbolicFunction::parameters`.
    Argument(u32),
    /// An index of `shared` of the site or function.
    Shared(u32),
    Op(Op, Vec<SymExpr>),
    If(Box<SymExpr>, Box<SymExpr>, Box<SymExpr>),
    /// The derivative with respect to a symbol.
    Derivative(Box<SymExpr>, Symbol),
    /// `e at Time = t`: the expression with the symbol replaced by the second expression.
    At(Box<SymExpr>, Symbol, Box<SymExpr>),
    /// A call of a symbolic function. In its body, the numbers of its arguments are independent
    /// symbols.
    Call(SymbolicFunctionId, Vec<SymExpr>),
    /// The unknown for which a symbolic function is zero or has a minimum: the guess, then the
    /// arguments of the function after the unknown. The unknown has the form of the guess; the
    /// result of the function has as many numbers, or is the number to minimize.
    Solve(Search, SymbolicFunctionId, Vec<SymExpr>),
    /// The value of a piecewise polynomial ([`calyx_abi::piecewise`]) at a number.
    Table(Arc<[f64]>, Box<SymExpr>),
    Brackets(Vec<SymExpr>),
    /// An element of a bracket expression, by index.
    Element(Box<SymExpr>, u32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    Time,
    Param(u32),
    /// A number argument of the enclosing symbolic function, by index.
    Argument(u32),
}
