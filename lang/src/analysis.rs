//! Data types for editor queries on checked texts: the meaning of a name, the type of an
//! expression, the parameters of a callable. [`crate::db::Database`] answers the queries.
//!
//! Files are identified by their display names; offsets are in bytes.

use crate::ast::Mode;
use crate::dimension::Dimension;
use std::sync::Arc;

/// A range of a file.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SourceRange {
    pub file: Arc<str>,
    pub start: u32,
    pub end: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum NameKind {
    /// `var x = ...`
    Variable,
    /// `var x := ...`
    Symbolic,
    /// A parameter of a function.
    Parameter,
    Param,
    Output,
    Function,
    /// `function f(in x) := ...`
    SymbolicFunction,
    /// An engine function that is declared in the library.
    Extern,
    Const,
    Record,
    Enum,
    /// `component Stage(gear: Gear) { ... }`
    Component,
    Field,
    Dimension,
    Unit,
    Module,
    /// A function that is part of the language.
    Builtin,
    /// `Time`, `pi`, `e1`, ...
    Constant,
}

impl NameKind {
    /// Returns the description for messages.
    pub fn describe(self) -> &'static str {
        match self {
            NameKind::Variable => "variable",
            NameKind::Symbolic => "symbolic name",
            NameKind::Parameter => "parameter",
            NameKind::Param => "param",
            NameKind::Output => "output",
            NameKind::Function => "function",
            NameKind::SymbolicFunction => "symbolic function",
            NameKind::Extern => "library function",
            NameKind::Const => "constant",
            NameKind::Record => "record",
            NameKind::Enum => "enumeration",
            NameKind::Component => "component",
            NameKind::Field => "field",
            NameKind::Dimension => "dimension",
            NameKind::Unit => "unit",
            NameKind::Module => "module",
            NameKind::Builtin => "built-in function",
            NameKind::Constant => "built-in constant",
        }
    }
}

/// A name in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    pub start: u32,
    pub end: u32,
    pub text: Arc<str>,
    pub kind: NameKind,
    /// Location of the declaration; `None` for built-in names. A module is declared at the start of
    /// its file.
    pub declared: Option<SourceRange>,
    /// Type of the named item as displayed; for a function, its type scheme.
    pub ty: Option<Arc<str>>,
    /// `true` for the name in a declaration.
    pub declares: bool,
    /// `true` if the name is assigned to.
    pub writes: bool,
}

/// An expression and its type.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    pub start: u32,
    pub end: u32,
    pub ty: String,
    /// Dimension of a number, if known.
    pub dimension: Option<Dimension>,
    /// `true` for a number without a unit, whose dimension is inferred from its use.
    pub bare: bool,
}

/// A name that is visible at a source location.
#[derive(Clone, Debug, PartialEq)]
pub struct Visible {
    pub name: Arc<str>,
    pub kind: NameKind,
    pub ty: Option<Arc<str>>,
    pub declared: Option<SourceRange>,
    /// Number of enclosing blocks between the location and the declaration; 0 is the innermost
    /// block. `None` for imported and built-in names.
    pub level: Option<u32>,
}

/// The text of a declaration, for display.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    pub kind: NameKind,
    pub name: Arc<str>,
    /// The former name, which is deprecated.
    pub former: Option<Arc<str>>,
    /// Source text without former names and without the body of a function.
    pub header: String,
    pub doc: Option<String>,
    pub ty: Option<Arc<str>>,
    /// Location of the whole statement.
    pub item: SourceRange,
}

/// A callable and its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Callable {
    pub name: Arc<str>,
    pub kind: NameKind,
    pub doc: Option<String>,
    pub parameters: Vec<CallParameter>,
    /// `true` if more arguments of the last kind may follow.
    pub open: bool,
    /// Result type; `None` if there is no result.
    pub result: Option<String>,
    /// Further requirements on types, such as `T adds`.
    pub demands: Vec<String>,
    pub declared: Option<SourceRange>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct CallParameter {
    pub name: Arc<str>,
    /// The former name, which is deprecated.
    pub former: Option<Arc<str>>,
    pub mode: Mode,
    /// `true` if the parameter takes an expression, given with `:=`.
    pub symbolic: bool,
    /// Type as displayed; empty if unknown.
    pub ty: String,
    /// Dimension of a number, if known.
    pub dimension: Option<Dimension>,
    /// Default as written.
    pub default: Option<String>,
    /// Range as written: `0 mm .. 5 mm`.
    pub range: Option<String>,
    /// Allowed strings.
    pub choices: Vec<String>,
    pub doc: Option<String>,
    pub declared: Option<SourceRange>,
}

impl CallParameter {
    /// Returns `true` for the current and the former name.
    pub fn is_called(&self, name: &str) -> bool {
        *self.name == *name || self.former.as_deref() == Some(name)
    }
}
