//! The typed program: names, types and dimensions are resolved, and the program is ready to be
//! interpreted or compiled.
//!
//! Control flow is a graph of basic blocks, so every control structure (`goto`, `switch`, `try`) is
//! represented by edges. Expressions are trees; `And`, `Or` and `If` evaluate only the operands
//! that they need. Dimensions are checked and erased: every number is an `f64` in SI units, and
//! literals are converted. Generic functions are instantiated once per representation of their
//! arguments.

mod operation;
mod symbolic;

pub use crate::ast::Mode;
pub use operation::Op;
pub use symbolic::{
    Capture, Site, SymExpr, SymKind, Symbol, SymbolicFunction, SymbolicParameter, captured_inputs,
};

use crate::span::Span;
use calyx_abi::description::Exponents;
use calyx_abi::display::Display;
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
    /// For a param of an instance whose default or range uses an argument: that argument, as the
    /// model gives it.
    pub given: Option<Span>,
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
    /// Choices of an enumeration that the values number from 0; empty for other numbers.
    pub choices: Vec<String>,
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
