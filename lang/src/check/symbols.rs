//! The meanings of identifiers, and the tables of declarations that they refer to.

use super::builtins::Builtin;
use super::tree::{FuncId, RecordId, VarId};
use super::unit::Surroundings;
use crate::ast::{
    EnumDecl, Expr, FunctionBody, FunctionDecl, Ident, Mode, ParamDecl, RecordDecl, TypeExpr, UnitDecl,
};
use crate::diagnostic::Diagnostic;
use crate::hashed::{HashMap, HashSet};
use crate::span::{FileId, Span};
use crate::units::Unit;
use smol_str::SmolStr;
use std::collections::BTreeSet;

/// The meaning of an identifier.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    Var(VarId),
    Param(u32),
    Output(u32),
    Function(FuncId),
    Extern(u32),
    /// A `const`, by index in [`Names::consts`].
    Const(u32),
    Record(RecordId),
    /// An `enum`, by index in [`Names::enums`].
    Enum(u32),
    /// A `dimension`, by index in [`Names::dimensions`].
    Dimension(u32),
    /// A `unit`, by index in [`Names::units`].
    OwnUnit(u32),
    Module(u32),
    Builtin(Builtin),
    Constant(Constant),
    Unit(&'static Unit),
    /// `none`, the absence of an optional value.
    None,
    /// Not found; already reported.
    Unknown,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constant {
    Time,
    /// A basis vector, by axis 0 to 2.
    Basis(u8),
    Number(NumberConstant),
    Bool(bool),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberConstant {
    Pi,
    Infinity,
    NotANumber,
}

/// The kind of declaration of a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VarKind {
    /// `var x = ...`
    Value,
    /// `var x := ...`
    Symbolic,
    Parameter(Mode),
    /// Contains a value captured by a `:=`.
    Hidden,
}

#[derive(Clone, Debug)]
pub struct Variable {
    pub name: SmolStr,
    pub span: Span,
    pub kind: VarKind,
    pub owner: FuncId,
    pub reads: u32,
}

#[derive(Clone, Debug)]
pub struct FunctionInfo<'a> {
    /// The declaration; `None` for the model's top level.
    pub decl: Option<&'a FunctionDecl>,
    pub name: SmolStr,
    pub file: FileId,
    pub parent: Option<FuncId>,
    pub parameters: Vec<VarId>,
    /// Variables of enclosing functions that it uses.
    pub outer: BTreeSet<VarId>,
    /// Expressions with variables around an anonymous function, and the further parameters of the
    /// function for their values.
    pub captured: Vec<(&'a Expr, VarId)>,
    /// An index in an anonymous function that depends on its arguments. Such a function computes
    /// values like an ordinary function, because a choice of elements has no derivative.
    pub computed: Option<Span>,
    /// Functions that it uses.
    pub callees: BTreeSet<FuncId>,
}

impl FunctionInfo<'_> {
    pub fn is_component(&self) -> bool {
        self.decl.is_some_and(|decl| decl.is_component)
    }

    /// Returns `true` for a function whose body is an expression of free arguments.
    pub fn is_symbolic(&self) -> bool {
        self.computed.is_none()
            && self.decl.is_some_and(|decl| matches!(decl.body, FunctionBody::Symbolic(_)))
    }
}

#[derive(Clone, Debug)]
pub struct ExternInfo<'a> {
    pub decl: &'a FunctionDecl,
    /// Name in the program, such as `gears.material`.
    pub name: String,
    pub symbol: String,
    pub file: FileId,
}

/// A declaration and its file.
#[derive(Clone, Debug)]
pub struct Declared<T> {
    pub decl: T,
    pub file: FileId,
}

#[derive(Clone, Copy, Debug)]
pub struct ConstDecl<'a> {
    pub name: &'a Ident,
    pub value: &'a Expr,
}

#[derive(Clone, Copy, Debug)]
pub struct DimensionDecl<'a> {
    pub name: &'a Ident,
    pub value: Option<&'a TypeExpr>,
}

/// A param of the model or of a component.
#[derive(Clone, Copy, Debug)]
pub struct ParamInfo<'a> {
    pub decl: &'a ParamDecl,
    pub doc: Option<&'a str>,
    /// The component that declares it, or the top level.
    pub owner: FuncId,
}

/// An output of the model or of a component.
#[derive(Clone, Copy, Debug)]
pub struct OutputInfo<'a> {
    pub name: &'a Ident,
    pub doc: Option<&'a str>,
    /// The component that declares it, or the top level.
    pub owner: FuncId,
}

/// The result of name resolution.
#[derive(Default)]
pub struct Names<'a> {
    /// The rest of the program, for suggestions.
    pub around: Option<&'a dyn Surroundings>,
    /// Meanings by the location of the identifier, including declarations.
    pub uses: HashMap<Span, Resolution>,
    /// The parameters for captured expressions, by anonymous function and location.
    pub captured: HashMap<(FuncId, Span), VarId>,
    /// Those of them that stand for the points of a spline. The captured expression is the spline.
    pub spline_points: HashSet<VarId>,
    /// Names that are assigned to.
    pub written: HashSet<Span>,
    /// Variables that a statement assigns, wholly or in part.
    pub assigned: HashSet<VarId>,
    pub variables: Vec<Variable>,
    /// Variables whose names are units after a number where they are visible (W0205).
    pub hidden_by_units: HashSet<VarId>,
    pub functions: Vec<FunctionInfo<'a>>,
    pub externs: Vec<ExternInfo<'a>>,
    pub consts: Vec<Declared<ConstDecl<'a>>>,
    pub records: Vec<Declared<&'a RecordDecl>>,
    pub enums: Vec<Declared<&'a EnumDecl>>,
    pub dimensions: Vec<Declared<DimensionDecl<'a>>>,
    pub units: Vec<Declared<&'a UnitDecl>>,
    pub params: Vec<ParamInfo<'a>>,
    pub outputs: Vec<OutputInfo<'a>>,
    pub diagnostics: Vec<Diagnostic>,
}

/// Returns a word with its indefinite article: `a Length`, `an Angle`.
pub fn with_article(word: &str) -> String {
    // A type shown as `_` is unknown. No type name starts with a vowel that is pronounced as a
    // consonant.
    let article = if word.starts_with(['A', 'E', 'I', 'O', 'U']) { "an" } else { "a" };
    format!("{article} {word}")
}

/// Returns the candidate with the most similar spelling, if it is similar enough.
pub fn similar<'s>(name: &str, candidates: impl Iterator<Item = &'s str>) -> Option<String> {
    candidates
        .map(|candidate| (strsim::damerau_levenshtein(name, candidate), candidate))
        .filter(|(distance, candidate)| {
            *distance <= (name.chars().count().max(candidate.chars().count()) / 3).max(1)
                && *distance < name.chars().count()
        })
        .min_by(|a, b| a.cmp(b))
        .map(|(_, candidate)| candidate.to_string())
}
