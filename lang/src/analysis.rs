//! What an editor asks of checked texts, as plain data: what a name means, of what type an expression is, what can be
//! called and how. The answers come from [`crate::db::Database`].
//!
//! Files are named as they are shown to people; offsets are bytes.

use crate::ast::Mode;
use crate::dimension::Dimension;
use std::sync::Arc;

/// A range of a file.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Place {
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
    /// Of a function.
    Parameter,
    Param,
    Output,
    Function,
    /// `function f(in x) := ...`
    SymbolicFunction,
    /// A function of the engine, declared in the library.
    Extern,
    Const,
    Record,
    Field,
    Dimension,
    Unit,
    Module,
    /// A function of the language itself.
    Builtin,
    /// `Time`, `pi`, `e1`, ...
    Constant,
}

impl NameKind {
    /// As said to people.
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
            NameKind::Field => "field",
            NameKind::Dimension => "dimension",
            NameKind::Unit => "unit",
            NameKind::Module => "module",
            NameKind::Builtin => "function of the language",
            NameKind::Constant => "constant of the language",
        }
    }
}

/// A name that stands in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    pub start: u32,
    pub end: u32,
    pub text: Arc<str>,
    pub kind: NameKind,
    /// `None` for what the language itself has. A module is declared at the start of its file.
    pub declared: Option<Place>,
    /// The type of what it names, a function's scheme, as shown to people.
    pub ty: Option<Arc<str>>,
    /// It is the declaration.
    pub declares: bool,
    /// It is assigned to.
    pub writes: bool,
}

/// An expression and its type.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    pub start: u32,
    pub end: u32,
    pub ty: String,
    /// Of a number, if it is known.
    pub dimension: Option<Dimension>,
    /// A number without a unit, whose dimension follows from its use.
    pub bare: bool,
}

/// A name that can be used at some place.
#[derive(Clone, Debug, PartialEq)]
pub struct Visible {
    pub name: Arc<str>,
    pub kind: NameKind,
    pub ty: Option<Arc<str>>,
    pub declared: Option<Place>,
    /// Levels of blocks around the place: 0 is the innermost. What is imported or the language's own has none.
    pub level: Option<u32>,
}

/// What a declaration says, for people.
#[derive(Clone, Debug, PartialEq)]
pub struct Declaration {
    pub kind: NameKind,
    pub name: Arc<str>,
    /// Its text without a function's body.
    pub header: String,
    pub doc: Option<String>,
    pub ty: Option<Arc<str>>,
    /// The whole statement.
    pub item: Place,
}

/// What can be called, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Callable {
    pub name: Arc<str>,
    pub kind: NameKind,
    pub doc: Option<String>,
    pub parameters: Vec<CallParameter>,
    /// More arguments like the last may follow.
    pub open: bool,
    /// `None` if it gives nothing.
    pub result: Option<String>,
    /// What else is demanded of the types: `T adds`.
    pub demands: Vec<String>,
    pub declared: Option<Place>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct CallParameter {
    pub name: Arc<str>,
    pub mode: Mode,
    /// Takes an expression, given with `:=`.
    pub symbolic: bool,
    /// As shown to people; empty if nothing is known.
    pub ty: String,
    /// The dimension of a number, if it is known.
    pub dimension: Option<Dimension>,
    /// As written.
    pub default: Option<String>,
    /// The ends of its range as written: `0 mm .. 5 mm`.
    pub range: Option<String>,
    /// The strings it may be.
    pub choices: Vec<String>,
    pub doc: Option<String>,
    pub declared: Option<Place>,
}
