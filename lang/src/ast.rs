//! The syntax tree, with unresolved names.
//!
//! Every text has a tree. The tree contains `Error` nodes for parts that cannot be parsed; the
//! parser reports the reason.

use crate::span::Span;
use smol_str::SmolStr;
use std::ops::Deref;

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Ident {
    pub name: SmolStr,
    pub span: Span,
}

/// A file: statements in order. Its functions are visible in the whole file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Module {
    pub statements: Vec<Stmt>,
    /// Text of a `///` block at the start of the file that is followed by a blank line.
    pub doc: Option<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Stmt {
    pub kind: StmtKind,
    pub span: Span,
    /// Text of the `///` comments above, joined with `\n`, without the leading space of each line.
    pub doc: Option<String>,
    /// `true` after `private`: importers do not see the declaration.
    pub private: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub enum StmtKind {
    /// `;`
    Empty,
    /// A statement that could not be parsed (already reported).
    Error,
    /// `import gears.helical;`, `import gears.helical as h;` or `import "folder/file" as name;`
    Import(Import),
    /// `units inch_lbf_s;`
    Units(Ident),
    Param(ParamDecl),
    /// `const name = value;`
    Const {
        name: Ident,
        value: Expr,
    },
    Record(RecordDecl),
    Enum(EnumDecl),
    /// `dimension Cost;` declares a new base dimension, `dimension LineLoad = Force / Length;` a
    /// name for a product.
    Dimension {
        name: Ident,
        value: Option<TypeExpr>,
    },
    Unit(UnitDecl),
    /// `output name := value;` or `output name := value in W;`
    Output {
        name: Ident,
        value: Expr,
        /// The unit of results, a product of units.
        unit: Option<Expr>,
    },
    /// `var a = 1, b := 2, c;`
    Var(Vec<VarDecl>),
    /// `place = value;` or `place := value;`
    Assign {
        place: Expr,
        bind: Bind,
        value: Expr,
    },
    /// `place += value;`: `op` is `Add`, `Subtract`, `Multiply` or `Divide`.
    Update {
        place: Expr,
        op: BinaryOp,
        /// Span of the operator.
        op_span: Span,
        value: Expr,
    },
    Expr(Expr),
    Function(FunctionDecl),
    Block(Vec<Stmt>),
    If {
        condition: Expr,
        then: Box<Stmt>,
        otherwise: Option<Box<Stmt>>,
    },
    While {
        condition: Expr,
        body: Box<Stmt>,
    },
    DoWhile {
        body: Box<Stmt>,
        condition: Expr,
    },
    /// `for (init; condition; step) body`, where `init` and `step` are `Empty`, `Var`, `Assign` or
    /// `Expr`.
    For {
        init: Box<Stmt>,
        condition: Option<Expr>,
        step: Box<Stmt>,
        body: Box<Stmt>,
    },
    /// `for (variable in values) body`
    ForEach {
        variable: Ident,
        values: Values,
        body: Box<Stmt>,
    },
    Switch {
        value: Expr,
        body: Box<Stmt>,
    },
    Case {
        value: Expr,
        statement: Box<Stmt>,
    },
    Default(Box<Stmt>),
    Label {
        label: Ident,
        statement: Box<Stmt>,
    },
    Goto(Ident),
    Break,
    Continue,
    Return(Option<Expr>),
    Throw(Option<Expr>),
    Try {
        body: Box<Stmt>,
        error: Option<Ident>,
        handler: Box<Stmt>,
    },
}

/// An import. It dereferences to the path of the module.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The dotted path of the module. The names of a path in quotation marks have the location of
    /// the string.
    pub path: Vec<Ident>,
    /// The name after `as`.
    pub alias: Option<Ident>,
    /// `true` for a path in quotation marks.
    pub is_quoted: bool,
}

impl Import {
    /// Returns the name under which the module is visible.
    pub fn name(&self) -> Option<&Ident> {
        self.alias.as_ref().or(self.path.last())
    }
}

impl Deref for Import {
    type Target = [Ident];

    fn deref(&self) -> &[Ident] {
        &self.path
    }
}

/// The kind of a binding: `=` evaluates now, `:=` stores the expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bind {
    Evaluate,
    Symbolic,
}

#[derive(Clone, Debug, PartialEq)]
pub struct VarDecl {
    pub name: Ident,
    pub init: Option<(Bind, Expr)>,
}

/// `param torque = 1000 lbf*inch in 0 lbf*inch .. 5000 lbf*inch;`
#[derive(Clone, Debug, PartialEq)]
pub struct ParamDecl {
    pub name: Ident,
    pub default: Expr,
    pub domain: Option<Domain>,
}

/// `record Name { width = 1 inch; teeth: Number; label: String = "x"; }`
#[derive(Clone, Debug, PartialEq)]
pub struct RecordDecl {
    pub name: Ident,
    /// The former name in `Name was Former`, which is deprecated.
    pub former: Option<Ident>,
    pub fields: Vec<RecordField>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct RecordField {
    pub name: Ident,
    /// The former name in `name was former`, which is deprecated.
    pub former: Option<Ident>,
    pub annotation: Option<TypeExpr>,
    pub default: Option<Expr>,
    pub doc: Option<String>,
}

/// `enum Hand { left, right }`
#[derive(Clone, Debug, PartialEq)]
pub struct EnumDecl {
    pub name: Ident,
    pub choices: Vec<EnumChoice>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct EnumChoice {
    pub name: Ident,
    pub doc: Option<String>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct UnitDecl {
    pub name: Ident,
    pub meaning: UnitMeaning,
}

#[derive(Clone, Debug, PartialEq)]
pub enum UnitMeaning {
    /// `unit euro: Cost;`, the unit in which numbers of this dimension are stored.
    Coherent(TypeExpr),
    /// Checks `unit furlong = 220 yard;`.
    Equal(Expr),
}

/// The allowed values of a param or of a library function's parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// `in low .. high`, inclusive; either limit may be missing.
    Range { low: Option<Expr>, high: Option<Expr>, span: Span },
    /// `in ["a", "b"]`, with the other names of choices in the documentation of a parameter, each
    /// followed by its choice.
    Choices { values: Vec<Expr>, span: Span, other_names: Vec<(String, String)> },
}

/// `function f(in a, in b = 2, in frame := e, out c) { ... }`,
/// `function p(in u, in th) := e;` or `extern pure function f(in a: Length) -> Gear;`
#[derive(Clone, Debug, PartialEq)]
pub struct FunctionDecl {
    pub name: Ident,
    /// The former name in `function name was former`, which is deprecated.
    pub former: Option<Ident>,
    pub parameters: Vec<Parameter>,
    pub result: Option<TypeExpr>,
    pub body: FunctionBody,
    /// `true` for `test function f() { ... }`, which `calyx test` runs.
    pub is_test: bool,
    /// `true` for `host function`: the program that embeds the model may replace its body.
    pub is_host: bool,
    /// `true` for `component Stage(gear: Gear) { ... }`: its body is a block, whose declarations
    /// are the members of its instances.
    pub is_component: bool,
}

/// The end of the names of anonymous functions: `(x, y) => ...`.
pub const ANONYMOUS: &str = "=> ...";

impl FunctionDecl {
    /// Returns `true` for the function of an [`ExprKind::Anonymous`].
    pub fn is_anonymous(&self) -> bool {
        self.name.name.ends_with(ANONYMOUS)
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum FunctionBody {
    Statement(Box<Stmt>),
    /// A symbolic function: `:= expression;`, or `:= { ... }` with an [`ExprKind::Block`].
    Symbolic(Expr),
    /// A function of the engine. `purity` is `effect` by default; `pure` or `scene` may be written
    /// before `function`.
    Extern {
        purity: Option<Ident>,
        /// Unit in which outputs show the result:
        /// `extern scene function f() -> Observable(Angle) in urad;`.
        unit: Option<Expr>,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    In,
    Out,
    InOut,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    pub mode: Mode,
    pub name: Ident,
    /// The former name in `name was former`, which is deprecated.
    pub former: Option<Ident>,
    pub annotation: Option<TypeExpr>,
    /// `= default`, or `:= default` for a parameter that takes a symbolic value. `Some((Symbolic,
    /// None))` is written `in frame :=` and has no default.
    pub default: Option<(Bind, Option<Expr>)>,
    /// The value in `= none was value`, which meant `none` in earlier versions and is deprecated.
    pub former_none: Option<Expr>,
    pub domain: Option<Domain>,
    pub doc: Option<String>,
}

/// `Length`, `Array(Number)`, `Number`, `Symbolic(Transform)`, `Force/Length^2`.
#[derive(Clone, Debug, PartialEq)]
pub struct TypeExpr {
    pub kind: TypeKind,
    pub span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub enum TypeKind {
    /// A dimension, `Bool`, `String`, `Vector`, `Transform`, or a handle such as `Body`.
    Name(Ident),
    /// `module.Name`
    Member(Ident, Ident),
    /// `Array(T)`, `Symbolic(T)`, `Vector(Length)`.
    Apply(Ident, Vec<TypeExpr>),
    Product(Box<TypeExpr>, Box<TypeExpr>),
    Quotient(Box<TypeExpr>, Box<TypeExpr>),
    /// A power with the rational exponent `numerator/denominator`.
    Power(Box<TypeExpr>, i32, i32),
    /// The type of a parameter that is a function: `Function(Length, Force) -> Pressure`.
    Function(Vec<TypeExpr>, Box<TypeExpr>),
    Error,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// An expression that could not be parsed (already reported).
    Error,
    Number(f64),
    /// `2 inch^2`: a number followed by one unit with an optional integer exponent.
    Quantity {
        value: f64,
        unit: Ident,
        exponent: i32,
        /// Span of the exponent, if written.
        exponent_span: Option<Span>,
    },
    Bool(bool),
    /// Alternating literal text and `{expressions}`.
    String(Vec<StringPart>),
    /// A variable, param, constant, module, or a unit as an operand.
    Name(Ident),
    /// `module.name`, `vector.x`, `record.field`.
    Field {
        base: Box<Expr>,
        field: Ident,
    },
    Call {
        callee: Box<Expr>,
        arguments: Vec<Argument>,
    },
    Index {
        base: Box<Expr>,
        index: Box<Expr>,
    },
    /// `base[low .. high]`; either limit may be missing.
    Slice {
        base: Box<Expr>,
        low: Option<Box<Expr>>,
        high: Option<Box<Expr>>,
    },
    Unary {
        op: UnaryOp,
        operand: Box<Expr>,
    },
    Binary {
        op: BinaryOp,
        /// Span of the operator.
        op_span: Span,
        left: Box<Expr>,
        right: Box<Expr>,
    },
    /// `[a, b, c]`
    List(Vec<Expr>),
    /// `[a, b, c] inch^2`: numbers in brackets, followed by their unit.
    Measured {
        elements: Vec<Expr>,
        unit: Ident,
        exponent: i32,
        /// Span of the exponent, if written.
        exponent_span: Option<Span>,
    },
    /// `[element for variable in values if condition]`
    Comprehension(Box<Comprehension>),
    /// `e is none`, or `e is not none`.
    IsNone {
        value: Box<Expr>,
        negated: bool,
    },
    /// `if (c) a else b`
    If {
        condition: Box<Expr>,
        then: Box<Expr>,
        otherwise: Box<Expr>,
    },
    /// `e at Time = 0.1 s`
    At {
        value: Box<Expr>,
        symbol: Ident,
        at: Box<Expr>,
    },
    Paren(Box<Expr>),
    /// `(x, y) => e`, an anonymous symbolic function; only arguments are such functions. Its name
    /// is this text without the expression, at the arrow.
    Anonymous(Box<FunctionDecl>),
    /// The body `{ var a = ...; return ...; }` of a symbolic function: a [`StmtKind::Block`]. It
    /// occurs nowhere else.
    Block(Box<Stmt>),
}

#[derive(Clone, Debug, PartialEq)]
pub struct Comprehension {
    pub element: Expr,
    pub variable: Ident,
    pub values: Values,
    pub condition: Option<Expr>,
}

/// The values that a loop goes through.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// The elements of an array.
    Elements(Expr),
    /// `low .. high`: `low`, `low + 1`, and so on, below `high`.
    Range(Expr, Expr),
}

impl Values {
    /// Returns the expressions in order.
    pub fn expressions(&self) -> Vec<&Expr> {
        match self {
            Values::Elements(array) => vec![array],
            Values::Range(low, high) => vec![low, high],
        }
    }

    /// Returns the source range from the first to the last expression.
    pub fn span(&self) -> Span {
        match self {
            Values::Elements(array) => array.span,
            Values::Range(low, high) => low.span.to(high.span),
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a text has few parts")]
pub enum StringPart {
    Text(String),
    Value(Expr, Option<Format>),
}

/// The format of a number after a colon in braces: `{x : 10.3e lbf*inch}`.
#[derive(Clone, Debug, PartialEq)]
pub struct Format {
    /// Minimum number of characters; the number is padded with leading spaces.
    pub width: Option<u8>,
    /// Digits after the decimal point.
    pub digits: Option<u8>,
    /// `true` for scientific notation.
    pub scientific: bool,
    /// The unit, a product of units.
    pub unit: Option<Expr>,
    pub span: Span,
}

/// `value`, `name = value`, `name := value`, or `..record`.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    pub name: Option<(Ident, Bind)>,
    pub value: Expr,
    /// `true` for `..record`: its fields are passed as named arguments.
    pub spread: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnaryOp {
    Plus,
    Minus,
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BinaryOp {
    Or,
    And,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

impl BinaryOp {
    /// Returns `true` for operators that return a truth value and accept other operands.
    pub fn compares(self) -> bool {
        use BinaryOp::*;
        matches!(self, Less | LessEqual | Greater | GreaterEqual | Equal | NotEqual)
    }
}
