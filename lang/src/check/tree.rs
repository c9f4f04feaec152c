//! The typed tree: names are resolved, and every expression has its type, which may be generic.
//!
//! It is the result of inference and the input of lowering. Each function occurs once, with its
//! type scheme; lowering instantiates it per representation.

use super::dim::{Dim, DimVar};
use super::types::{Type, TypeVar};
use crate::ast::{BinaryOp, Mode, UnaryOp};
use crate::dimension::Dimension;
use crate::ir::{DisplayUnit, Op};
use crate::span::Span;
use crate::units::UnitSystem;
use calyx_abi::newton::Search;
use smallvec::{SmallVec, smallvec};
use std::collections::BTreeSet;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VarId(pub u32);
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FuncId(pub u32);
/// The index of a record declared in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RecordId(pub u32);
/// The index of a `:=` expression: of a name, an argument or an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct DefId(pub u32);
/// The index of a use of a function's type scheme.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct UseId(pub u32);

/// A symbol with respect to which an expression can be differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Sym {
    Time,
    Param(u32),
    /// A parameter of the enclosing symbolic function.
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
    /// An invalid expression; already reported.
    Error,
    /// A number in SI units.
    Number(f64),
    /// A literal without a unit, in the file system's unit for the inferred dimension.
    Bare(f64, Dim, UnitSystem),
    Bool(bool),
    Text(String),
    Var(VarId),
    Param(u32),
    Time,
    /// A `:=` expression within a symbolic one; it is inlined.
    Def(DefId),
    /// The current expression of a `:=` name that is selected at run time, or of a symbolic
    /// parameter.
    Chosen(VarId),
    /// A `:=` expression passed as a value.
    MakeSymbolic(DefId),
    /// The value of a `:=` expression at a time; at time 0 if it does not depend on time.
    Eval(DefId, Option<Box<Expr>>),
    /// An observable in a symbolic expression.
    Observe(Box<Expr>),
    /// The expression that a value of the type `Symbolic` contains, within a symbolic expression.
    Part(Box<Expr>),
    Unary(UnaryOp, Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A built-in function, by its operation.
    Op(Op, Vec<Expr>),
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    Call(Box<Call>),
    /// A call of a symbolic function in a symbolic expression.
    SymbolicCall(Box<Call>),
    /// A function as an argument, with the values that a declared one captures, or with the value
    /// of the parameter.
    Function(PassedFunction, Vec<Expr>),
    /// A call of a parameter that is a function.
    Applied(Box<Applied>),
    /// A call of a library function: its index, its arguments, and the domains of arguments by
    /// position.
    CallExtern(u32, Vec<Expr>, Vec<(usize, ArgumentRange)>),
    Print(Vec<Expr>, UnitSystem),
    Assert(Box<Assertion>),
    Array(Vec<Expr>),
    Tuple(Vec<Expr>),
    Index(Box<Expr>, Box<Expr>),
    /// Executes statements that assign hidden variables, then has the value of the expression.
    Sequence(Vec<Stmt>, Box<Expr>),
    /// The value that [`StmtKind::Update`] replaces, in a place of this variable.
    Updated(VarId),
    /// The sum of no terms: `0`, or the null vector.
    Zero,
    /// An absent optional value.
    None,
    /// A value as an optional one.
    Some(Box<Expr>),
    /// `e is none`
    IsNone(Box<Expr>),
    /// A function of the runtime without effects.
    Standard(Standard, Vec<Expr>),
    /// An element of a tuple, or a field of a record.
    TupleElement(Box<Expr>, usize),
    /// A field of a record or a component of a vector; the types of a call determine which.
    Field(Box<Expr>, String),
    /// The axis of a rotation, which must be a unit vector.
    UnitAxis(Box<Expr>),
    Len(Box<Expr>),
    /// Alternating text and values; numbers are displayed in units of the model's system, or of
    /// this one if the model declares none.
    Format(Vec<TextPart>, UnitSystem),
    Derivative(Box<Expr>, Sym),
    /// The gradient: derivatives in brackets.
    Gradient(Box<Expr>, Vec<Sym>),
    At(Box<Expr>, Sym, Box<Expr>),
    /// The spline through points: their abscissas and ordinates, and the argument.
    Spline(Box<[Expr; 3]>),
    /// The block of a symbolic function: variables with their expressions, and the result.
    Block(Vec<(VarId, Expr)>, Box<Expr>),
}

/// A function that a call passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PassedFunction {
    Declared(FuncId, UseId),
    /// A parameter of the enclosing function.
    Parameter(VarId),
}

/// A call of a parameter that is a function. The calls of the enclosing function determine the
/// function, so it is known when the enclosing function is lowered for one of them.
#[derive(Clone, Debug)]
pub struct Applied {
    pub parameter: VarId,
    /// The value of the parameter: the values that the function captures.
    pub environment: Expr,
    pub arguments: Vec<Expr>,
    /// See [`Call::search`].
    pub search: Option<Search>,
}

/// A function of the runtime that expressions call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standard {
    /// Returns the start of a range, which must be an integer.
    RangeStart,
    /// Returns the end of a range, which must be an integer or infinite.
    RangeEnd,
    /// Returns the end of a slice: checks its start and its end against the length of the array.
    SliceEnd,
    /// The smallest and the largest element of an array of numbers.
    Smallest,
    Largest,
    /// The elements of an array of numbers in ascending order.
    Sort,
    /// The number of the table of a spline, given the abscissas and the ordinates.
    SplineTable,
    /// The frame of a body, as an expression.
    BodyFrame,
}

#[derive(Clone, Debug)]
pub enum TextPart {
    Text(String),
    Value(Box<Expr>, Option<Style>),
}

/// The explicit format of a value in a string.
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
    /// The source texts of both sides of a comparison, for the message of a failure; `None` for a
    /// side that is the message itself.
    pub sides: Option<[Option<String>; 2]>,
    /// The unit system of the file for the displayed values, see [`Kind::Format`].
    pub system: UnitSystem,
}

#[derive(Clone, Debug)]
pub struct Call {
    pub function: FuncId,
    pub instance: UseId,
    /// One expression per parameter. Expressions for `out` parameters are not evaluated.
    pub arguments: Vec<Expr>,
    /// Places of the `out` and `inout` arguments, in order.
    pub copy_back: Vec<Place>,
    /// Pairs of positions in `copy_back` whose places are the same if their indices are equal.
    pub perhaps_same: Vec<(usize, usize)>,
    /// The domains of arguments, by position.
    pub demands: Vec<(usize, ArgumentRange)>,
    /// Set for `solve(f, guess, ...)` and `minimize(f, guess, ...)` in a symbolic expression: the
    /// value is the first argument for which the function is zero or has a minimum. The guess takes
    /// the place of this argument.
    pub search: Option<Search>,
}

/// The domain of a parameter, with the types of one call.
#[derive(Clone, Debug)]
pub struct ArgumentRange {
    pub name: String,
    pub low: Option<Expr>,
    pub high: Option<Expr>,
    /// Allowed strings; empty if any string is allowed.
    pub choices: Vec<String>,
    /// The domain as written, without `in`.
    pub text: String,
    /// `true` if NaN passes the check: the library rejects it itself (E0722) and reports its
    /// origin.
    pub nan_passes: bool,
}

#[derive(Clone, Debug)]
pub struct Place {
    pub variable: VarId,
    /// Projections, starting at the variable.
    pub steps: Vec<Step>,
    pub ty: Type,
    pub span: Span,
}

/// A projection from a value to a part of it.
#[derive(Clone, Debug)]
pub enum Step {
    /// Element of an array.
    Index(Expr),
    /// Element of a tuple, or field of a record.
    Element(usize),
    /// Field of a record of this type; the types of a call determine its position.
    Field(Type, String),
}

#[derive(Clone, Debug)]
pub struct Stmt {
    pub kind: StmtKind,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub enum StmtKind {
    /// No operation: a declaration, or a statement that was already reported.
    Nothing,
    Assign(Place, Expr),
    /// Assigns a value computed from the present one, [`Kind::Updated`].
    Update(Place, Expr),
    /// Executes a `:=`: stores its captures, and the expression itself if the name is selected at
    /// run time.
    Bind(VarId, DefId),
    Eval(Expr),
    Push(Place, Expr),
    /// Passes an output, by index, to the engine.
    Output(u32, DefId),
    /// Passes the elements of an array as outputs to the engine.
    ArrayOutput(u32, Expr),
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
    /// Throws a text or an `Error`; without a value, the error that is being handled.
    Throw(Option<Expr>),
    Try {
        body: Box<Stmt>,
        /// The variable that receives the error.
        error: Option<VarId>,
        handler: Box<Stmt>,
    },
}

/// A `:=` expression, with the values that it captures when its binding executes.
#[derive(Clone, Debug)]
pub struct Def {
    /// The bound name; for an argument, such as `body.frame`.
    pub name: String,
    pub expr: Expr,
    /// Hidden variables and the values assigned to them when the binding executes.
    pub captures: Vec<(VarId, Expr)>,
    /// `true` if a statement sets its hidden variables. Those of an argument are set where the
    /// argument is evaluated.
    pub stored: bool,
    /// Arguments of a call, as definitions, that are checked before the value is computed.
    pub checks: Vec<(DefId, ArgumentRange)>,
    /// `true` if it depends on `Time`, directly or through other definitions.
    pub on_time: bool,
    /// `true` if it contains an observable, directly or through other definitions.
    pub observes: bool,
    /// `true` if neither it nor the definitions that it uses capture a value.
    pub closed: bool,
    /// Names selected at run time on which it depends at the requested time, directly or through
    /// other definitions.
    pub chosen: BTreeSet<VarId>,
    /// `true` if it is passed as a value that other expressions may capture.
    pub part: bool,
    pub span: Span,
}

/// The quantified variables and the constraints of a generic type.
#[derive(Clone, Debug, Default)]
pub struct Scheme {
    pub types: Vec<TypeVar>,
    pub dims: Vec<DimVar>,
    pub constraints: Vec<Constraint>,
}

/// A constraint of an operator on types that are not known yet.
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
    /// The type is Number or Vector.
    Additive(Type),
    /// Values can be compared for equality.
    Comparable(Type),
    /// Values can be written into a string.
    Printable(Type),
    /// Values can be thrown: a text or an `Error`.
    Throwable(Type),
    /// Values contain numbers that can be formatted with a unit of this dimension, if given, and
    /// with digits, if set.
    Styled(Type, Option<Dimension>, bool),
    /// `base[index] = result`, array or (with a constant index) tuple.
    Index(Type, Option<usize>, Type),
    /// `base.field = result`, record or vector.
    Field(Type, String, Type, FieldUse),
}

/// How a function uses a field of a value whose type its calls determine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FieldUse {
    Read,
    /// Params and outputs of instances and components of vectors cannot be assigned.
    Assigned,
}

/// A function's signature and body.
#[derive(Clone, Debug)]
pub struct Function {
    pub name: String,
    pub parameters: Vec<(VarId, Mode)>,
    pub result: Type,
    pub body: Vec<Stmt>,
    /// The expression of a symbolic function; its body is empty.
    pub definition: Option<SymbolicBody>,
    /// For a host function with its body: its interface.
    pub host: Option<HostOffer>,
    /// The component that contains the function; a component contains itself.
    pub component: Option<FuncId>,
    pub scheme: Scheme,
    pub span: Span,
}

impl Function {
    /// Returns `true` if it is lowered once for each list of types with which it is used.
    pub fn is_generic(&self) -> bool {
        !self.scheme.types.is_empty() || !self.scheme.dims.is_empty()
    }
}

#[derive(Clone, Debug)]
pub struct SymbolicBody {
    pub def: DefId,
    /// `true` for a top-level function of the model, which embedding programs can call by name.
    pub exported: bool,
    pub doc: String,
}

/// The interface of a host function for the embedding program.
#[derive(Clone, Debug, PartialEq)]
pub struct HostOffer {
    /// Name including the module.
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
    /// `true` if the default is an integer without a unit.
    pub whole: bool,
    /// The component that declares it, or the top level.
    pub owner: FuncId,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub struct Output {
    pub name: String,
    pub doc: String,
    pub ty: Type,
    /// The stated unit; `None` for that of the model's unit system.
    pub unit: Option<DisplayUnit>,
    /// Choices that the values number from 0; empty for other numbers.
    pub choices: Vec<String>,
    /// The component that declares it, or the top level.
    pub owner: FuncId,
    /// The variable with its observable, which is a member of the component's instances, or with
    /// the array of its observables.
    pub member: Option<VarId>,
    pub span: Span,
}

impl Place {
    /// Returns the computed indices in order.
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

    /// Returns the expressions that are evaluated as part of this one.
    pub fn children(&self) -> SmallVec<[&Expr; 3]> {
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
            | Kind::Updated(_)
            | Kind::Zero
            | Kind::None
            | Kind::MakeSymbolic(_) => SmallVec::new(),
            Kind::Sequence(statements, value) => {
                let mut all = SmallVec::new();
                statements.iter().for_each(|s| s.walk(&mut |s| all.extend(s.expressions())));
                all.push(&**value);
                all
            }
            Kind::Eval(_, time) => time.iter().map(|e| &**e).collect(),
            Kind::Observe(a)
            | Kind::Part(a)
            | Kind::Unary(_, a)
            | Kind::TupleElement(a, _)
            | Kind::Field(a, _)
            | Kind::Len(a)
            | Kind::Some(a)
            | Kind::IsNone(a)
            | Kind::UnitAxis(a)
            | Kind::Derivative(a, _)
            | Kind::Gradient(a, _) => smallvec![&**a],
            Kind::Binary(_, a, b) | Kind::Index(a, b) | Kind::At(a, _, b) => smallvec![&**a, &**b],
            Kind::Assert(assertion) => smallvec![&assertion.condition, &assertion.message],
            Kind::If(a, b, c) => smallvec![&**a, &**b, &**c],
            Kind::Op(_, all)
            | Kind::CallExtern(_, all, _)
            | Kind::Print(all, _)
            | Kind::Standard(_, all)
            | Kind::Function(_, all)
            | Kind::Array(all)
            | Kind::Tuple(all) => all.iter().collect(),
            Kind::Call(call) | Kind::SymbolicCall(call) => {
                call.arguments.iter().chain(call.copy_back.iter().flat_map(Place::indices)).collect()
            }
            Kind::Applied(applied) => applied.arguments.iter().chain([&applied.environment]).collect(),
            Kind::Spline(parts) => parts.iter().collect(),
            Kind::Block(bindings, result) => {
                bindings.iter().map(|(_, value)| value).chain([&**result]).collect()
            }
            Kind::Format(pieces, _) => pieces
                .iter()
                .filter_map(|piece| match piece {
                    TextPart::Text(_) => None,
                    TextPart::Value(value, _) => Some(&**value),
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

    /// Returns the expressions of this statement, without those of nested statements.
    pub fn expressions(&self) -> Vec<&Expr> {
        match &self.kind {
            StmtKind::Assign(place, value)
            | StmtKind::Update(place, value)
            | StmtKind::Push(place, value) => place.indices().chain([value]).collect(),
            StmtKind::Eval(e)
            | StmtKind::ArrayOutput(_, e)
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
