//! The typed program: names, types and dimensions are resolved, and the program is ready to be
//! interpreted or compiled.
//!
//! Control flow is a graph of basic blocks, so every control structure (`goto`, `switch`, `try`) is
//! represented by edges. Expressions are trees; `And`, `Or` and `If` evaluate only the operands
//! that they need. Dimensions are checked and erased: every number is an `f64` in SI units, and
//! literals are converted. Generic functions are instantiated once per representation of their
//! arguments.

use crate::span::Span;
use calyx_abi::description::Exponents;
use calyx_abi::display::Display;
use calyx_abi::newton::Search;
use calyx_abi::{Purity, Repr};
use std::path::PathBuf;
use std::sync::Arc;

#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The model's file, followed by every imported file, including those of the library.
    pub files: Vec<SourceFile>,
    pub params: Vec<Param>,
    pub outputs: Vec<Output>,
    pub functions: Vec<Function>,
    /// The function for the model's top level, without parameters and result.
    pub main: FunctionId,
    pub externs: Vec<ExternDecl>,
    /// Functions that the embedding program may provide, in order of file and position.
    pub host_functions: Vec<HostFunction>,
    /// All `:=` expressions and symbolic arguments.
    pub sites: Vec<Site>,
    /// Symbolic functions, instantiated once per representation of their arguments. Callees precede
    /// their callers.
    pub symbolic_functions: Vec<SymbolicFunction>,
    /// Params with respect to which expressions with captured expressions are differentiated. Every
    /// [`Site::part`] provides its derivatives with respect to these.
    pub graph_params: Vec<u32>,
    /// Name of the unit system of results: `SI`, `mm_N_s`, `inch_lbf_s`.
    pub units: String,
    /// Units that the program declares.
    pub own_units: Vec<DisplayUnit>,
    /// Dimensions that the program declares, by name.
    pub own_dimensions: Vec<(String, Exponents)>,
    /// Text of the doc comment at the start of the model's file; empty if there is none.
    pub doc: String,
    /// Files and directories outside of the model's directory that the program may read, see
    /// [`Loader::allowed`](crate::check::Loader::allowed).
    pub allowed: Arc<[PathBuf]>,
}

#[derive(Clone, Debug)]
pub struct SourceFile {
    /// Display name: the given path, or `<library>/gears.cx`.
    pub name: String,
    pub text: String,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FunctionId(pub u32);
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ExternId(pub u32);
/// An index of `Program::host_functions`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct HostId(pub u32);
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SiteId(pub u32);
/// An index of `Program::symbolic_functions`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SymbolicFunctionId(pub u32);
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct LocalId(pub u32);
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BlockId(pub u32);

/// An input of the model.
#[derive(Clone, Debug)]
pub struct Param {
    pub name: String,
    pub doc: String,
    pub repr: Repr,
    /// Evaluates the default, which may use earlier params and functions without effects.
    pub default: FunctionId,
    /// Evaluates the lower limit of the allowed range; `high` evaluates the upper one.
    pub low: Option<FunctionId>,
    pub high: Option<FunctionId>,
    /// Allowed strings; empty if any string is allowed.
    pub choices: Vec<String>,
    /// Unit of the default. A value given without a unit is in this unit, and values are displayed
    /// in it.
    pub unit: DisplayUnit,
    /// `true` if the default is an integer without a unit; only integers are then allowed.
    pub integral: bool,
    pub span: Span,
}

/// The display unit of a number: SI value = displayed value * `factor`.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayUnit {
    /// Name, such as `lbf*inch`; empty for a pure number.
    pub name: String,
    pub factor: f64,
    pub dimension: Exponents,
}

/// A requested observable.
#[derive(Clone, Debug)]
pub struct Output {
    pub name: String,
    pub doc: String,
    pub site: SiteId,
    /// `true` if the program passes an array: the results have its elements, `name[0]`.
    pub is_array: bool,
    /// Display unit in the model's unit system; `si` is the name of the coherent SI unit.
    pub unit: DisplayUnit,
    pub si: String,
    pub span: Span,
}

/// A function that the engine provides.
#[derive(Clone, Debug)]
pub struct ExternDecl {
    /// Link symbol: `calyx_` + module + `_` + name.
    pub symbol: String,
    /// Name in the program, such as `gears.material`.
    pub name: String,
    pub purity: Purity,
    pub parameters: Vec<(String, Repr)>,
    pub result: Repr,
    /// Location of the declaration.
    pub span: Span,
}

/// A function that the embedding program may provide. Its own body starts with [`Statement::Host`],
/// which calls the provided function.
#[derive(Clone, Debug, PartialEq)]
pub struct HostFunction {
    /// Name including the module.
    pub name: String,
    pub doc: String,
    pub parameters: Vec<HostValue>,
    /// The result, whose name is empty.
    pub result: HostValue,
    /// Location of the declaration.
    pub span: Span,
}

/// A parameter or the result of a host function.
#[derive(Clone, Debug, PartialEq)]
pub struct HostValue {
    pub name: String,
    /// Number, Bool, String, Vector, or an array of these.
    pub repr: Repr,
    /// The type as displayed.
    pub ty: String,
    pub unit: DisplayUnit,
}

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

#[derive(Clone, Debug)]
pub struct Function {
    pub name: String,
    pub parameters: Vec<(LocalId, Mode)>,
    /// `Unit` without a result. The values of `out` and `inout` parameters follow the result in the
    /// returned slots.
    pub result: Repr,
    pub locals: Vec<Local>,
    /// Execution starts at block 0.
    pub blocks: Vec<Block>,
    pub span: Span,
}

pub use crate::ast::Mode;

#[derive(Clone, Debug)]
pub struct Local {
    pub name: String,
    pub repr: Repr,
}

#[derive(Clone, Debug)]
pub struct Block {
    pub statements: Vec<Statement>,
    pub terminator: Terminator,
    /// The block to which errors in this block jump; without one, the function returns the error.
    /// Errors that cannot be caught always leave the function.
    pub handler: Option<BlockId>,
    /// The location reported if the program is stopped in this block.
    pub span: Span,
}

#[derive(Clone, Debug)]
pub enum Statement {
    Assign {
        place: Place,
        value: Expr,
        span: Span,
    },
    /// Evaluates an expression for its effects.
    Eval(Expr),
    /// A call whose `out` and `inout` results are stored, after the call, in places evaluated
    /// before the call.
    Call {
        /// The place for the function's result, if it is used.
        result: Option<Place>,
        function: FunctionId,
        arguments: Vec<Expr>,
        /// One place per `out` or `inout` parameter, in order.
        copy_back: Vec<Place>,
        span: Span,
    },
    /// Calls a host function if the embedding program provides it.
    Host {
        function: HostId,
        arguments: Vec<Expr>,
        /// The place for the result, which is unspecified if the function is not provided.
        result: Place,
        /// The place for a truth value: whether the function is provided.
        provided: Place,
        span: Span,
    },
    /// Appends an element to the array in a place.
    Push {
        place: Place,
        value: Expr,
        span: Span,
    },
}

/// A storage location: a local, or a (nested) element of the array or tuple in it.
#[derive(Clone, Debug)]
pub struct Place {
    pub local: LocalId,
    /// Projections, starting at the local.
    pub steps: Vec<Step>,
    /// Representation of the stored value.
    pub repr: Repr,
}

/// A projection from a value to an element of it.
#[derive(Clone, Debug)]
pub enum Step {
    /// Element of an array. The index must be an integer within bounds; a check reports E0701.
    Index(Expr),
    /// Element of a tuple, by constant index.
    Element(usize),
}

impl Place {
    /// Returns the place of a whole local.
    pub fn whole(local: LocalId, repr: Repr) -> Place {
        Place { local, steps: Vec::new(), repr }
    }

    /// Returns the computed indices in order.
    pub fn indices(&self) -> impl Iterator<Item = &Expr> {
        self.steps.iter().filter_map(|step| match step {
            Step::Index(index) => Some(index),
            Step::Element(_) => None,
        })
    }
}

#[derive(Clone, Debug)]
pub enum Terminator {
    Jump(BlockId),
    Branch {
        condition: Expr,
        then: BlockId,
        otherwise: BlockId,
    },
    Return(Option<Expr>),
    /// Fails with an error that the program creates.
    Throw {
        /// The fields of an `Error`: code, message, location, value.
        error: Expr,
        /// A suggested fix; may be empty.
        help: String,
        span: Span,
    },
    /// Fails again with a caught error ([`ExprKind::Catch`]).
    Rethrow(Expr),
}

/// Returns the representation of the record `Error`.
pub fn error_repr() -> Repr {
    Repr::Tuple(vec![Repr::String, Repr::String, Repr::String, Repr::Number, Repr::String])
}

#[derive(Clone, Debug)]
pub struct Expr {
    pub kind: ExprKind,
    pub repr: Repr,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub enum ExprKind {
    Number(f64),
    Bool(bool),
    String(String),
    Local(LocalId),
    /// An index of `Program::params`.
    Param(u32),
    Op(Op, Vec<Expr>),
    And(Box<Expr>, Box<Expr>),
    Or(Box<Expr>, Box<Expr>),
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    /// A call of a function without `out` or `inout` parameters.
    Call(FunctionId, Vec<Expr>),
    CallExtern(ExternId, Vec<Expr>),
    /// A new array. Every element has the representation of the array's elements.
    Array(Vec<Expr>),
    /// Element of an array; the index is checked (E0701).
    Index(Box<Expr>, Box<Expr>),
    Tuple(Vec<Expr>),
    /// Element of a tuple, by constant index.
    TupleElement(Box<Expr>, usize),
    /// A copy of an array, which later changes of the original do not affect. It is inserted when
    /// an array that is read from a place is bound to another place, passed by `in`, stored in an
    /// array, or returned while a place still refers to it. The copy shares the elements until one
    /// of the two changes.
    Copy(Box<Expr>),
    /// Number of elements.
    Len(Box<Expr>),
    /// Concatenated text and formatted values.
    Format(Vec<FormatPart>),
    /// Takes the error that led to this block and returns a handle. Occurs once, at the start of a
    /// handler.
    Catch,
    /// The fields of a caught error, as in [`error_repr`].
    CaughtFields(Box<Expr>),
    /// Executes a `:=`: captures the values of `captures`.
    MakeSymbolic {
        site: SiteId,
        captures: Vec<Expr>,
    },
    /// The current value of a symbolic value: the kernel outputs of derivative order 0 at the given
    /// time.
    EvalSymbolic {
        value: Box<Expr>,
        time: Box<Expr>,
    },
}

#[derive(Clone, Debug)]
pub enum FormatPart {
    Text(String),
    Value(Expr, Display),
}

/// Operations on numbers, truth values, vectors and transforms, shared by evaluated and symbolic
/// expressions. The comments give the representations of operands and result (N number, B bool, S
/// string, V vector, T transform).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// N,N -> N, as for all operations up to `Divide`. `Power` is `abi::math::pow`.
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    /// N -> N
    Negate,
    /// B -> B
    Not,
    /// N,N -> B
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    /// N,N or B,B or S,S or V,V -> B. The lowering expands arrays and tuples or compares them
    /// element by element.
    Equal,
    NotEqual,
    /// N -> N
    Sqrt,
    Abs,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    Floor,
    Ceil,
    Round,
    /// N,N -> N: the value of a registered table ([`calyx_abi::piecewise::registered`]) at a
    /// number.
    Spline,
    /// N,N -> N
    Atan2,
    Min,
    Max,
    /// N,N,N -> V
    Vector,
    /// V -> N
    X,
    Y,
    Z,
    Norm,
    /// V,V -> V
    AddVector,
    SubtractVector,
    Cross,
    /// V -> V
    NegateVector,
    /// N,V -> V
    Scale,
    /// V,V -> N
    Dot,
    /// V -> T: transformation into a frame translated by v: `x' = x - v`.
    Translate,
    /// N,V -> T: transformation into a frame rotated by the angle about the unit axis: `x' =
    /// R(angle, axis)^T x`.
    Rotate,
    /// T,T -> T: `(A * B) x = A (B x)`.
    Compose,
    /// T,V -> V: coordinates of the point in the frame.
    Apply,
    /// T -> T
    Inverse,
    /// T -> V: the frame's origin in ground coordinates.
    Origin,
    /// T,V -> V: the direction in ground coordinates of a vector given in the frame.
    Direction,
    /// T -> V, symbolic only: velocity and acceleration of the frame's origin, angular velocity and
    /// angular acceleration of the frame, in ground coordinates.
    Velocity,
    Acceleration,
    AngularVelocity,
    AngularAcceleration,
}
