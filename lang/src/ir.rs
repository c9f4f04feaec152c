//! The typed program: names, types and dimensions resolved, ready to be interpreted or compiled.
//!
//! Control flow is a graph of basic blocks, so that every construct of the language (`goto`, `switch`, `try`)
//! is an edge. Expressions stay trees; `And`, `Or` and `If` in them evaluate only what they need.
//! Dimensions have been checked and are gone: every number is an `f64` in SI, literals converted.
//! Generic functions stand here once per representation of their arguments.

use crate::span::Span;
use calyx_abi::description::Exponents;
use calyx_abi::display::Display;
use calyx_abi::{Purity, Repr};

#[derive(Clone, Debug, Default)]
pub struct Program {
    /// The model first, then every file it uses, the library's included.
    pub files: Vec<SourceFile>,
    pub params: Vec<Param>,
    pub outputs: Vec<Output>,
    pub functions: Vec<Function>,
    /// The function that runs the model's top level. Takes and returns nothing.
    pub main: FunctionId,
    pub externs: Vec<ExternDecl>,
    /// What the embedding program may provide, in order of file and place.
    pub host_functions: Vec<HostFunction>,
    /// Every `:=` expression and every symbolic argument.
    pub sites: Vec<Site>,
    /// Symbolic functions, each once per representation of its arguments. A function stands after those it calls.
    pub symbolic_functions: Vec<SymbolicFunction>,
    /// Params by which expressions are differentiated that captured other expressions: every [`Site::part`] gives its
    /// derivatives by them.
    pub graph_params: Vec<u32>,
    /// Name of the unit system results print in: `SI`, `mm_N_s`, `inch_lbf_s`.
    pub units: String,
    /// Units that the program declares.
    pub own_units: Vec<DisplayUnit>,
    /// Dimensions that the program declares, by name.
    pub own_dimensions: Vec<(String, Exponents)>,
    /// Text of the doc comment that opens the model's file; empty if there is none.
    pub doc: String,
}

#[derive(Clone, Debug)]
pub struct SourceFile {
    /// As shown to people: the path given, or `<library>/gears.cx`.
    pub name: String,
    pub text: String,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FunctionId(pub u32);
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ExternId(pub u32);
/// By index in `Program::host_functions`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct HostId(pub u32);
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SiteId(pub u32);
/// By index in `Program::symbolic_functions`.
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
    /// Evaluates the default (it may use earlier params and functions without effects).
    pub default: FunctionId,
    /// Evaluate the ends of the allowed range.
    pub low: Option<FunctionId>,
    pub high: Option<FunctionId>,
    /// Allowed strings; empty if any string will do.
    pub choices: Vec<String>,
    /// The default's unit: what a bare value given by the user is in, and what it is shown in.
    pub unit: DisplayUnit,
    /// The default is a bare whole number, so only whole numbers are allowed.
    pub integral: bool,
    pub span: Span,
}

/// How a number is shown: SI value = shown value * `factor`.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayUnit {
    /// E.g. `lbf*inch`; empty for a pure number.
    pub name: String,
    pub factor: f64,
    pub dimension: Exponents,
}

/// A wanted observable.
#[derive(Clone, Debug)]
pub struct Output {
    pub name: String,
    pub doc: String,
    pub site: SiteId,
    /// What results are shown in, in the model's units; `si` is the name of the coherent SI unit.
    pub unit: DisplayUnit,
    pub si: String,
    pub span: Span,
}

/// A function the engine provides.
#[derive(Clone, Debug)]
pub struct ExternDecl {
    /// Link symbol: `calyx_` + module + `_` + name.
    pub symbol: String,
    /// As the program names it, e.g. `gears.material`.
    pub name: String,
    pub purity: Purity,
    pub parameters: Vec<(String, Repr)>,
    pub result: Repr,
    /// Where it is declared.
    pub span: Span,
}

/// A function that the program which embeds the model may provide; its own body begins by asking for that
/// ([`Statement::Host`]).
#[derive(Clone, Debug, PartialEq)]
pub struct HostFunction {
    /// With the module it stands in.
    pub name: String,
    pub doc: String,
    pub parameters: Vec<HostValue>,
    /// Its name is empty.
    pub result: HostValue,
    /// Where it is declared.
    pub span: Span,
}

/// What a host function takes or gives.
#[derive(Clone, Debug, PartialEq)]
pub struct HostValue {
    pub name: String,
    /// Number, Bool, String, Vector, or an array of these.
    pub repr: Repr,
    /// The type as people write it.
    pub ty: String,
    pub unit: DisplayUnit,
}

/// A symbolic expression in the source: one kernel, many sets of captured values.
#[derive(Clone, Debug)]
pub struct Site {
    /// Name bound, for messages and for the symbol of its kernel.
    pub name: String,
    /// Parts used more than once; each may name those before it ([`SymKind::Shared`]).
    pub shared: Vec<SymExpr>,
    pub expr: SymExpr,
    /// What is captured by value when the binding executes, in order of `SymExpr::Capture`.
    pub captures: Vec<Capture>,
    /// Number, Vector, Transform, or a tuple of these where brackets are evaluated.
    pub repr: Repr,
    /// Highest time derivative its kernel computes beside the value: 2 for a transform, else 0.
    pub order: u8,
    /// Its value may be captured by other sites: after its time derivatives, of order 2 then, its kernel gives the
    /// same of its derivative by each of [`Program::graph_params`].
    pub part: bool,
    pub span: Span,
}

impl Site {
    /// Number of its kernel's inputs: time, every param, what it captures.
    pub fn inputs(&self, program: &Program) -> usize {
        let captured = self.captures.iter().map(|capture| capture.inputs(program));
        1 + program.params.len() + captured.sum::<usize>()
    }

    /// Number of its kernel's outputs.
    pub fn outputs(&self, program: &Program) -> usize {
        let by = if self.part { 1 + program.graph_params.len() } else { 1 };
        self.repr.slots() * (1 + usize::from(self.order)) * by
    }
}

#[derive(Clone, Debug)]
pub struct Capture {
    pub name: String,
    /// Number, Bool, Vector or Transform; `Symbolic(Number)` with `observable` set for an observable; else
    /// `Symbolic` of Number, Vector or Transform for an expression, the value of a site that is a [`Site::part`].
    pub repr: Repr,
    pub observable: bool,
}

impl Capture {
    /// An expression: what the kernel of its site gives is what the kernel that captured it takes.
    pub fn is_part(&self) -> bool {
        !self.observable && matches!(self.repr, Repr::Symbolic(_))
    }

    /// How many inputs of the kernel it takes.
    pub fn inputs(&self, program: &Program) -> usize {
        match &self.repr {
            Repr::Symbolic(inner) if !self.observable => inner.slots() * 3 * (1 + program.graph_params.len()),
            repr => repr.slots(),
        }
    }
}

/// `function p(in u, in th) := e;`: an expression with free arguments. Its kernel has the inputs time, every param by
/// index, then the arguments in order, and the outputs of `result` in order (see `calyx_lower::kernels`).
#[derive(Clone, Debug)]
pub struct SymbolicFunction {
    pub name: String,
    pub doc: String,
    pub parameters: Vec<SymbolicParameter>,
    /// Parts used more than once; each may name those before it ([`SymKind::Shared`]).
    pub shared: Vec<SymExpr>,
    pub body: SymExpr,
    /// Number, Bool, Vector, Transform, or a tuple of these for brackets (arrays too: every length is known).
    pub result: Repr,
    /// What the numbers of the result are shown in, one per value of `result` that is no tuple; of a frame, its
    /// translation.
    pub units: Vec<DisplayUnit>,
    /// A function of the model itself, outside all others: offered by name. Exported names are unique.
    pub exported: bool,
    pub span: Span,
}

#[derive(Clone, Debug)]
pub struct SymbolicParameter {
    pub name: String,
    /// Number, Bool or Vector.
    pub repr: Repr,
    /// What the argument is shown in; dimensionless where the function takes any dimension.
    pub unit: DisplayUnit,
}

/// A symbolic expression, typed. Becomes a graph of the symbolic crate when lowered.
#[derive(Clone, Debug)]
pub struct SymExpr {
    pub kind: SymKind,
    /// Number, Bool, Vector or Transform, or a tuple of these.
    pub repr: Repr,
    pub span: Span,
}

impl SymExpr {
    /// The expressions directly in this one.
    pub fn operands(&self) -> Vec<&SymExpr> {
        match &self.kind {
            SymKind::Number(_)
            | SymKind::Bool(_)
            | SymKind::Time
            | SymKind::Param(_)
            | SymKind::Capture(_)
            | SymKind::Argument(_)
            | SymKind::Shared(_) => Vec::new(),
            SymKind::Op(_, all) | SymKind::Call(_, all) | SymKind::Brackets(all) => all.iter().collect(),
            SymKind::If(a, b, c) => vec![a, b, c],
            SymKind::Derivative(a, _) | SymKind::Element(a, _) => vec![a],
            SymKind::At(a, _, b) => vec![a, b],
        }
    }
}

#[derive(Clone, Debug)]
pub enum SymKind {
    Number(f64),
    Bool(bool),
    /// Seconds since the start of the motion.
    Time,
    /// A number param, by index in `Program::params`.
    Param(u32),
    /// By index in `Site::captures`.
    Capture(u32),
    /// By index in `SymbolicFunction::parameters`.
    Argument(u32),
    /// By index in `shared` of the site or function.
    Shared(u32),
    Op(Op, Vec<SymExpr>),
    If(Box<SymExpr>, Box<SymExpr>, Box<SymExpr>),
    /// Derivative by a symbol.
    Derivative(Box<SymExpr>, Symbol),
    /// `e at Time = t`: the symbol replaced by the second expression.
    At(Box<SymExpr>, Symbol, Box<SymExpr>),
    /// A symbolic function of arguments. Inside it, its arguments are independent symbols.
    Call(SymbolicFunctionId, Vec<SymExpr>),
    Brackets(Vec<SymExpr>),
    /// Of brackets, by index.
    Element(Box<SymExpr>, u32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    Time,
    Param(u32),
    /// An argument of the symbolic function the expression stands in: a number, by index.
    Argument(u32),
}

#[derive(Clone, Debug)]
pub struct Function {
    pub name: String,
    pub parameters: Vec<(LocalId, Mode)>,
    /// `Unit` if it returns nothing. Values of `out` and `inout` parameters follow the result in the returned slots.
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
    /// Where an error of this block leads; without it, out of the function. What one cannot catch leaves it anyway.
    pub handler: Option<BlockId>,
    /// Where a program that is stopped here is said to be.
    pub span: Span,
}

#[derive(Clone, Debug)]
pub enum Statement {
    Assign {
        place: Place,
        value: Expr,
        span: Span,
    },
    /// Evaluated for what it does.
    Eval(Expr),
    /// A call whose `out` and `inout` results are stored back, after the call, into places evaluated before it.
    Call {
        /// Where the function's own result goes, if it is kept.
        result: Option<Place>,
        function: FunctionId,
        arguments: Vec<Expr>,
        /// One per `out` or `inout` parameter, in order.
        copy_back: Vec<Place>,
        span: Span,
    },
    /// Calls a host function if the embedding program provides it.
    Host {
        function: HostId,
        arguments: Vec<Expr>,
        /// Where its result goes if it is provided; left with no particular value otherwise.
        result: Place,
        /// Where it is told whether it is provided.
        provided: Place,
        span: Span,
    },
    /// Appends an element to the array the place holds.
    Push {
        place: Place,
        value: Expr,
        span: Span,
    },
}

/// Where a value is stored: a local, or a part (of a part ...) of the array or tuple it holds.
#[derive(Clone, Debug)]
pub struct Place {
    pub local: LocalId,
    /// From the local inwards.
    pub steps: Vec<Step>,
    /// Representation of what is stored there.
    pub repr: Repr,
}

/// From a value to a part of it.
#[derive(Clone, Debug)]
pub enum Step {
    /// Element of an array; the index must be a whole number within bounds: checked, code E0701.
    Index(Expr),
    /// Element of a tuple, by constant index.
    Element(usize),
}

impl Place {
    /// A local as a whole.
    pub fn whole(local: LocalId, repr: Repr) -> Place {
        Place { local, steps: Vec::new(), repr }
    }

    /// The indices that are computed, in order.
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
    /// Fails with an error of the program's own making.
    Throw {
        /// The fields of an `Error`: code, message, place, value.
        error: Expr,
        /// What to do about it; empty if nothing can be said.
        help: String,
        span: Span,
    },
    /// Fails again with an error that was caught ([`ExprKind::Catch`]).
    Rethrow(Expr),
}

/// Representation of the record `Error`.
pub fn error_repr() -> Repr {
    Repr::Tuple(vec![Repr::String, Repr::String, Repr::String, Repr::Number])
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
    /// By index in `Program::params`.
    Param(u32),
    Op(Op, Vec<Expr>),
    And(Box<Expr>, Box<Expr>),
    Or(Box<Expr>, Box<Expr>),
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    /// Function without `out` or `inout` parameters.
    Call(FunctionId, Vec<Expr>),
    CallExtern(ExternId, Vec<Expr>),
    /// A fresh array; every element has the representation of the array's element.
    Array(Vec<Expr>),
    /// Element of an array; the index is checked (E0701).
    Index(Box<Expr>, Box<Expr>),
    Tuple(Vec<Expr>),
    /// Element of a tuple, by constant index.
    TupleElement(Box<Expr>, usize),
    /// A copy of an array that shares nothing with the original. Inserted wherever an array read from a place
    /// is bound to another place, passed by `in`, stored in an array, or returned while a place still holds it.
    Copy(Box<Expr>),
    /// Number of elements.
    Len(Box<Expr>),
    /// Text and values joined; each as its display says.
    Format(Vec<FormatPart>),
    /// Takes the error that led to this block and keeps it: a handle. Stands once, at the head of a handler.
    Catch,
    /// The fields of a caught error, as in [`error_repr`].
    CaughtFields(Box<Expr>),
    /// Executes a `:=`: captures the values of `captures`.
    MakeSymbolic {
        site: SiteId,
        captures: Vec<Expr>,
    },
    /// The present value of a symbolic value: kernel outputs of derivative order 0 at the given time.
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

/// Operations on numbers, truth values, vectors and transforms, the same in evaluated and in symbolic expressions.
/// The comment gives the representations of operands and result (N number, B bool, S string, V vector, T transform).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Op {
    /// N,N -> N and so on to `Divide`. `Power` is `abi::math::pow`.
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
    /// N,N or B,B or S,S or V,V -> B (arrays and tuples are expanded or compared by element when lowering)
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
    /// V -> T: takes coordinates into a frame moved by v: `x' = x - v`.
    Translate,
    /// N,V -> T: takes coordinates into a frame turned by the angle about the unit axis: `x' = R(angle, axis)^T x`.
    Rotate,
    /// T,T -> T: `(A * B) x = A (B x)`.
    Compose,
    /// T,V -> V: coordinates of the point in the new frame.
    Apply,
    /// T -> T
    Inverse,
    /// T -> V: where the new frame's origin is, in ground coordinates.
    Origin,
    /// T,V -> V: the direction in ground coordinates of a vector given in the new frame.
    Direction,
    /// T -> V, symbolic only: of the frame's origin, and of its rotation, in ground coordinates.
    Velocity,
    Acceleration,
    AngularVelocity,
    AngularAcceleration,
}
