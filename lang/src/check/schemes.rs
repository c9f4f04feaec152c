//! Display of type schemes: `(in a: T, in b: U) -> V where T*U = V`.
//!
//! Quantified variables get letters in order of occurrence: `T U V ...` for types, `a b c ...` for
//! dimensions.

use super::dim::{Dim, DimVar};
use super::infer::Checker;
use super::tree::{ConstraintKind, FuncId};
use super::types::{Store, Type, TypeVar};
use crate::ast::Mode;
use crate::dimension::Rational;
use std::fmt::{self, Display, Formatter};

/// The displayed scheme of a function.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShownScheme {
    pub name: String,
    /// `true` for a component, whose parameters have no mode.
    pub is_component: bool,
    /// Mode, name and type of each parameter.
    pub parameters: Vec<(Mode, String, String)>,
    /// Result type; `None` if there is no result.
    pub result: Option<String>,
    /// Further requirements on the types.
    pub demands: Vec<String>,
}

impl Display for ShownScheme {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let parameters = self.parameters.iter().map(|(mode, name, ty)| {
            let mode = match mode {
                Mode::In if self.is_component => "",
                Mode::In => "in ",
                Mode::Out => "out ",
                Mode::InOut => "inout ",
            };
            format!("{mode}{name}: {ty}")
        });
        write!(f, "({})", parameters.collect::<Vec<_>>().join(", "))?;
        if let Some(result) = &self.result {
            write!(f, " -> {result}")?;
        }
        if !self.demands.is_empty() {
            write!(f, " where {}", self.demands.join(", "))?;
        }
        Ok(())
    }
}

impl Checker<'_> {
    /// Returns the scheme of a function; `None` for the top level.
    pub(super) fn shown_scheme(&self, id: FuncId) -> Option<ShownScheme> {
        let (function, signature) = (self.names.functions.get(id.0 as usize)?, self.signatures.get(&id)?);
        let mut letters = Letters { store: &self.store, types: Vec::new(), dims: Vec::new() };
        let is_component = function.is_component();
        let mut shown =
            ShownScheme { name: function.name.to_string(), is_component, ..ShownScheme::default() };
        for (parameter, ty) in function.decl?.parameters.iter().zip(&signature.parameters) {
            shown.parameters.push((parameter.mode, parameter.name.name.to_string(), letters.ty(ty)));
        }
        let result = letters.ty(&signature.result);
        let nothing = matches!(self.store.known(&signature.result), Type::Unit);
        shown.result = (!nothing).then_some(result);
        for constraint in signature.scheme.iter().flat_map(|scheme| &scheme.constraints) {
            let demand = letters.demand(&constraint.kind);
            if !shown.demands.contains(&demand) {
                shown.demands.push(demand);
            }
        }
        Some(shown)
    }
}

/// The variables in order of occurrence; the position determines the letter.
struct Letters<'s> {
    store: &'s Store,
    types: Vec<TypeVar>,
    dims: Vec<DimVar>,
}

impl Letters<'_> {
    fn ty(&mut self, ty: &Type) -> String {
        match self.store.shallow(ty) {
            Type::Unknown(variable) => {
                letter(&mut self.types, variable, &["T", "U", "V", "W", "X", "Y", "Z"])
            }
            Type::Number(dim) => self.dim(&dim),
            Type::Vector(dim) => match self.dim(&dim).as_str() {
                "Number" => "Vector".into(),
                inner => format!("Vector({inner})"),
            },
            Type::Observable(dim) => format!("Observable({})", self.dim(&dim)),
            Type::Array(element) => format!("Array({})", self.ty(&element)),
            Type::Symbolic(inner) => format!("Symbolic({})", self.ty(&inner)),
            Type::Optional(inner) => format!("{} or none", self.ty(&inner)),
            Type::Tuple(parts) => {
                let parts: Vec<String> = parts.iter().map(|part| self.ty(part)).collect();
                format!("[{}]", parts.join(", "))
            }
            Type::Function(parts, result) => {
                let parts: Vec<String> = parts.iter().map(|part| self.ty(part)).collect();
                format!("Function({}) -> {}", parts.join(", "), self.ty(&result))
            }
            closed => self.store.show(&closed),
        }
    }

    fn dim(&mut self, dim: &Dim) -> String {
        let dim = self.store.dim(dim);
        if let Some(known) = dim.as_known() {
            return self.store.vocabulary.show(known);
        }
        let (mut above, mut below) = (Vec::new(), Vec::new());
        if !dim.fixed.is_none() {
            above.push(self.store.vocabulary.show(dim.fixed));
        }
        for &(variable, exponent) in &dim.unknowns {
            let name = letter(&mut self.dims, variable, &["a", "b", "c", "d", "e", "f", "g"]);
            let downwards = exponent.numerator() < 0;
            let size = if downwards { exponent.negated() } else { exponent };
            let factor = if size == Rational::ONE { name } else { format!("{name}^{size}") };
            if downwards { below.push(format!("/{factor}")) } else { above.push(factor) }
        }
        let above = if above.is_empty() { "1".into() } else { above.join("*") };
        format!("{above}{}", below.concat())
    }

    fn demand(&mut self, kind: &ConstraintKind) -> String {
        match kind {
            ConstraintKind::Multiply(a, b, c) => format!("{}*{} = {}", self.ty(a), self.ty(b), self.ty(c)),
            ConstraintKind::Divide(a, b, c) => format!("{}/{} = {}", self.ty(a), self.ty(b), self.ty(c)),
            ConstraintKind::Additive(a) => format!("{} adds", self.ty(a)),
            ConstraintKind::Comparable(a) => format!("{} compares", self.ty(a)),
            ConstraintKind::Printable(a) => format!("{} prints", self.ty(a)),
            ConstraintKind::Styled(a, Some(unit), _) => {
                format!("{} is shown as {}", self.ty(a), self.store.vocabulary.show(*unit))
            }
            ConstraintKind::Styled(a, None, _) => format!("{} is shown by a format", self.ty(a)),
            ConstraintKind::Throwable(a) => format!("{} is thrown", self.ty(a)),
            ConstraintKind::Index(base, at, element) => {
                let at = at.map_or("i".into(), |at| at.to_string());
                format!("{}[{at}] = {}", self.ty(base), self.ty(element))
            }
            ConstraintKind::Field(base, name, field, _) => {
                format!("{}.{name} = {}", self.ty(base), self.ty(field))
            }
        }
    }
}

/// Returns the letter of a variable, with a number after the end of the alphabet.
fn letter<V: PartialEq>(met: &mut Vec<V>, variable: V, alphabet: &[&str]) -> String {
    let place = met.iter().position(|other| *other == variable).unwrap_or_else(|| {
        met.push(variable);
        met.len() - 1
    });
    let letter = alphabet[place % alphabet.len()];
    let round = place / alphabet.len();
    if round == 0 { letter.into() } else { format!("{letter}{round}") }
}
