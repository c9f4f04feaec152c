//! The checked program as a tree: names resolved, every expression with its (perhaps still general) type.
//!
//! It stands between inference and the typed program: functions are kept once, with their type schemes, and lowered
//! once per representation.

use super::dim::{Dim, DimVar};
use super::types::{Type, TypeVar};
use crate::ast::{BinaryOp, Mode, UnaryOp};
use crate::dimension::Dimension;
use crate::ir::{DisplayUnit, Op};
use crate::span::Span;
use crate::units::UnitSystem;
use std::collections::BTreeSet;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VarId(pub u32);
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FuncId(pub u32);
/// A record declared in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RecordId(pub u32);
/// A `:=` expression: of a name, an argument or an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct DefId(pub u32);
/// One use of a function's type scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct UseId(pub u32);

/// What a symbolic expression can be differentiated by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Sym {
    Time,
    Param(u32),
    /// A parameter of the symbolic function around.
    Argument(VarId),
}

#[derive(Clone, Debug)]
pub struct Expr {
    pub kind: Kind,
    pub ty: Type,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub enum Kind {
    /// Already reported.
    Error,
    /// In SI.
    Number(f64),
    /// A bare literal, in the unit that the file's system has for whatever dimension was inferred.
    Bare(f64, Dim, UnitSystem),
    Bool(bool),
    Text(String),
    Var(VarId),
    Param(u32),
    Time,
    /// A `:=` expression in a symbolic one: fused.
    Def(DefId),
    /// The expression that a `:=` name chosen at run time, or a symbolic parameter, has now.
    Chosen(VarId),
    /// A `:=` expression handed on as a value.
    MakeSymbolic(DefId),
    /// The value of a `:=` expression at a time (0 where it does not depend on time).
    Eval(DefId, Option<Box<Expr>>),
    /// An observable inside a symbolic expression.
    Observe(Box<Expr>),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A function every program has, by the operation that it is.
    Op(Op, Vec<Expr>),
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    Call(Box<Call>),
    /// A symbolic function in a symbolic expression.
    SymbolicCall(Box<Call>),
    /// A library function, its arguments, and what some of them must be, by their position.
    CallExtern(u32, Vec<Expr>, Vec<(usize, Demand)>),
    Print(Vec<Expr>, UnitSystem),
    Assert(Box<Assertion>),
    Array(Vec<Expr>),
    Tuple(Vec<Expr>),
    Index(Box<Expr>, Box<Expr>),
    /// Element of a tuple, field of a record.
    TupleElement(Box<Expr>, usize),
    /// Field of a record or component of a vector, which only the types of a call decide.
    Field(Box<Expr>, String),
    /// The axis of a rotation, which must be a unit vector.
    UnitAxis(Box<Expr>),
    Len(Box<Expr>),
    /// Text and values in turn, numbers shown in the system's units.
    Format(Vec<Piece>, UnitSystem),
    Derivative(Box<Expr>, Sym),
    /// Brackets of derivatives.
    Gradient(Box<Expr>, Vec<Sym>),
    At(Box<Expr>, Sym, Box<Expr>),
}

#[derive(Clone, Debug)]
pub enum Piece {
    Text(String),
    Value(Box<Expr>, Option<Style>),
}

/// How a value in a text is shown, where that is written.
#[derive(Clone, Debug)]
pub struct Style {
    pub width: Option<u8>,
    pub digits: Option<u8>,
    pub scientific: bool,
    pub unit: Option<DisplayUnit>,
}

#[derive(Clone, Debug)]
pub struct Assertion {
    pub condition: Expr,
    pub message: Expr,
    /// The two sides of a comparison as written: a failure says what they were.
    pub sides: Option<[String; 2]>,
    /// What their values are shown in.
    pub system: UnitSystem,
}

#[derive(Clone, Debug)]
pub struct Call {
    pub function: FuncId,
    pub instance: UseId,
    /// One per parameter. For `out` parameters the expression is not evaluated.
    pub arguments: Vec<Expr>,
    /// Places of `out` and `inout` arguments, in order.
    pub copy_back: Vec<Place>,
    /// Places, by position in `copy_back`, that are the same if their indices turn out equal.
    pub perhaps_same: Vec<(usize, usize)>,
    /// What arguments must be, by their position.
    pub demands: Vec<(usize, Demand)>,
}

/// The range or the choices of a parameter, with the types of one call.
#[derive(Clone, Debug)]
pub struct Demand {
    pub name: String,
    pub low: Option<Expr>,
    pub high: Option<Expr>,
    /// Empty if any string will do.
    pub choices: Vec<String>,
    /// As it is written, without `in`.
    pub text: String,
    /// Whether NaN passes: the library refuses it by itself (E0722), and finds out where it arose.
    pub nan_passes: bool,
}

#[derive(Clone, Debug)]
pub struct Place {
    pub variable: VarId,
    /// From the variable inwards.
    pub steps: Vec<Step>,
    pub ty: Type,
    pub span: Span,
}

/// From a value to a part of it.
#[derive(Clone, Debug)]
pub enum Step {
    /// Element of an array.
    Index(Expr),
    /// Element of a tuple, field of a record.
    Element(usize),
    /// Field of a record of this type, which only the types of a call decide.
    Field(Type, String),
}

#[derive(Clone, Debug)]
pub struct Stmt {
    pub kind: StmtKind,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub enum StmtKind {
    /// Nothing to do (a declaration, or something already reported).
    Nothing,
    Assign(Place, Expr),
    /// A `:=` executes: its captures are stored, and the expression itself if the name is chosen at run time.
    Bind(VarId, DefId),
    Eval(Expr),
    Push(Place, Expr),
    /// An output, by index, is handed to the engine.
    Output(u32, DefId),
    Block(Vec<Stmt>),
    If(Expr, Box<Stmt>, Option<Box<Stmt>>),
    While(Expr, Box<Stmt>),
    DoWhile(Box<Stmt>, Expr),
    For {
        init: Box<Stmt>,
        condition: Option<Expr>,
        step: Box<Stmt>,
        body: Box<Stmt>,
    },
    Switch(Expr, Box<Stmt>),
    Case(Expr, Box<Stmt>),
    Default(Box<Stmt>),
    Label(String, Box<Stmt>),
    Goto(String),
    Break,
    Continue,
    Return(Option<Expr>),
    /// A text or an `Error`; without one, the error being handled again.
    Throw(Option<Expr>),
    Try {
        body: Box<Stmt>,
        /// Takes the error.
        error: Option<VarId>,
        handler: Box<Stmt>,
    },
}

/// A `:=` expression, with the values it takes when its binding executes.
#[derive(Clone, Debug)]
pub struct Def {
    /// The name bound, `body.frame` for an argument.
    pub name: String,
    pub expr: Expr,
    /// Hidden variables and what they are set to when the binding executes.
    pub captures: Vec<(VarId, Expr)>,
    /// Its hidden variables are set by a statement; those of an argument where the argument stands.
    pub stored: bool,
    /// Depends on `Time`, directly or through other definitions.
    pub on_time: bool,
    /// Contains an observable, directly or through other definitions.
    pub observes: bool,
    /// Captures nothing, neither directly nor through other definitions.
    pub closed: bool,
    /// Names chosen at run time that it depends on, directly or through other definitions, at the time asked for.
    pub chosen: BTreeSet<VarId>,
    /// Handed on as a value that other expressions may capture.
    pub part: bool,
    pub span: Span,
}

/// A general type: what is unknown in a function's type when its body has been seen.
#[derive(Clone, Debug, Default)]
pub struct Scheme {
    pub types: Vec<TypeVar>,
    pub dims: Vec<DimVar>,
    pub constraints: Vec<Constraint>,
}

/// What operators demand of types that are not known yet.
#[derive(Clone, Debug)]
pub struct Constraint {
    pub kind: ConstraintKind,
    pub span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ConstraintKind {
    /// `left * right = result`
    Multiply(Type, Type, Type),
    /// `left / right = result`
    Divide(Type, Type, Type),
    /// Number or Vector.
    Additive(Type),
    /// Can be compared for equality.
    Comparable(Type),
    /// Can be written into a string.
    Printable(Type),
    /// Can be thrown: a text or an `Error`.
    Throwable(Type),
    /// Holds numbers that can be shown so: in a unit of this dimension, if one is given, with digits if that is said.
    Styled(Type, Option<Dimension>, bool),
    /// `base[index] = result`, array or (with a constant index) tuple.
    Index(Type, Option<usize>, Type),
    /// `base.field = result`, record or vector.
    Field(Type, String, Type),
}

/// A function's signature and body.
#[derive(Clone, Debug)]
pub struct Function {
    pub name: String,
    pub parameters: Vec<(VarId, Mode)>,
    pub result: Type,
    pub body: Vec<Stmt>,
    /// What a symbolic function stands for; its body is empty then.
    pub definition: Option<SymbolicBody>,
    /// Of a host function whose body is there: how it is offered.
    pub host: Option<HostOffer>,
    pub scheme: Scheme,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub struct SymbolicBody {
    pub def: DefId,
    /// Declared at the model's top level: offered by name.
    pub exported: bool,
    pub doc: String,
}

/// How a host function is offered to the program that embeds the model.
#[derive(Clone, Debug, PartialEq)]
pub struct HostOffer {
    /// With the module it stands in.
    pub name: String,
    pub doc: String,
}

#[derive(Clone, Debug)]
pub struct Param {
    pub name: String,
    pub doc: String,
    pub ty: Type,
    pub default: Expr,
    pub low: Option<Expr>,
    pub high: Option<Expr>,
    pub choices: Vec<String>,
    pub unit: Option<DisplayUnit>,
    /// The default was written as a bare whole number.
    pub whole: bool,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub struct Output {
    pub name: String,
    pub doc: String,
    pub ty: Type,
    pub span: Span,
}

impl Place {
    /// The indices that are computed, in order.
    pub fn indices(&self) -> impl Iterator<Item = &Expr> {
        self.steps.iter().filter_map(|step| match step {
            Step::Index(index) => Some(index),
            Step::Element(_) | Step::Field(..) => None,
        })
    }
}

impl Expr {
    pub fn error(span: Span) -> Expr {
        Expr { kind: Kind::Error, ty: Type::Error, span }
    }

    /// The expressions evaluated as part of this one.
    pub fn children(&self) -> Vec<&Expr> {
        match &self.kind {
            Kind::Error
            | Kind::Number(_)
            | Kind::Bare(..)
            | Kind::Bool(_)
            | Kind::Text(_)
            | Kind::Var(_)
            | Kind::Param(_)
            | Kind::Time
            | Kind::Def(_)
            | Kind::Chosen(_)
            | Kind::MakeSymbolic(_) => Vec::new(),
            Kind::Eval(_, time) => time.iter().map(|e| &**e).collect(),
            Kind::Observe(a)
            | Kind::Unary(_, a)
            | Kind::TupleElement(a, _)
            | Kind::Field(a, _)
            | Kind::Len(a)
            | Kind::UnitAxis(a)
            | Kind::Derivative(a, _)
            | Kind::Gradient(a, _) => vec![a],
            Kind::Binary(_, a, b) | Kind::Index(a, b) | Kind::At(a, _, b) => vec![a, b],
            Kind::Assert(assertion) => vec![&assertion.condition, &assertion.message],
            Kind::If(a, b, c) => vec![a, b, c],
            Kind::Op(_, all)
            | Kind::CallExtern(_, all, _)
            | Kind::Print(all, _)
            | Kind::Array(all)
            | Kind::Tuple(all) => all.iter().collect(),
            Kind::Call(call) | Kind::SymbolicCall(call) => {
                call.arguments.iter().chain(call.copy_back.iter().flat_map(Place::indices)).collect()
            }
            Kind::Format(pieces, _) => pieces
                .iter()
                .filter_map(|piece| match piece {
                    Piece::Text(_) => None,
                    Piece::Value(value, _) => Some(&**value),
                })
                .collect(),
        }
    }
}

impl Stmt {
    /// Calls `visit` on every statement, outermost first.
    pub fn walk<'a>(&'a self, visit: &mut dyn FnMut(&'a Stmt)) {
        visit(self);
        match &self.kind {
            StmtKind::Block(all) => all.iter().for_each(|s| s.walk(visit)),
            StmtKind::If(_, then, otherwise) => {
                then.walk(visit);
                if let Some(otherwise) = otherwise {
                    otherwise.walk(visit);
                }
            }
            StmtKind::While(_, body)
            | StmtKind::DoWhile(body, _)
            | StmtKind::Switch(_, body)
            | StmtKind::Case(_, body)
            | StmtKind::Default(body)
            | StmtKind::Label(_, body) => body.walk(visit),
            StmtKind::Try { body, handler, .. } => {
                body.walk(visit);
                handler.walk(visit);
            }
            StmtKind::For { init, step, body, .. } => {
                init.walk(visit);
                body.walk(visit);
                step.walk(visit);
            }
            _ => {}
        }
    }

    /// The expressions of this statement alone (not of those inside it).
    pub fn expressions(&self) -> Vec<&Expr> {
        match &self.kind {
            StmtKind::Assign(place, value) | StmtKind::Push(place, value) => {
                place.indices().chain([value]).collect()
            }
            StmtKind::Eval(e)
            | StmtKind::If(e, ..)
            | StmtKind::While(e, _)
            | StmtKind::DoWhile(_, e)
            | StmtKind::Switch(e, _)
            | StmtKind::Case(e, _)
            | StmtKind::Return(Some(e))
            | StmtKind::Throw(Some(e)) => vec![e],
            StmtKind::For { condition, .. } => condition.iter().collect(),
            _ => Vec::new(),
        }
    }
}
