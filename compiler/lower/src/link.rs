//! Resolves the engine functions that a program calls.

use calyx_abi::Extern;
use calyx_lang::ir::{ExternDecl, Program};
use calyx_lang::span::Span;
use std::fmt;

/// An engine function that does not exist or does not match its declaration in the program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinkError {
    /// Name in the program.
    pub name: String,
    /// Link symbol.
    pub symbol: String,
    /// `true` if the engine provides the function with other parameters or another result.
    pub differs: bool,
    /// Location of the declaration.
    pub span: Span,
}

impl fmt::Display for LinkError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let LinkError { name, symbol, .. } = self;
        if self.differs {
            write!(f, "the engine's `{symbol}` has other parameters or another result than `{name}` declares")
        } else {
            write!(f, "the engine has no function `{symbol}` for `{name}`")
        }
    }
}

impl std::error::Error for LinkError {}

/// Returns the engine's entries for all externs of a program, in order of `Program::externs`.
///
/// # Errors
/// The first extern that is missing, or whose slots differ from the declaration.
pub fn resolve_externs<'e>(program: &Program, externs: &'e [Extern]) -> Result<Vec<&'e Extern>, LinkError> {
    let resolve = |declaration: &ExternDecl| {
        let error = |differs| LinkError {
            name: declaration.name.clone(),
            symbol: declaration.symbol.clone(),
            differs,
            span: declaration.span,
        };
        let row = externs.iter().find(|row| row.symbol == declaration.symbol).ok_or_else(|| error(false))?;
        let provided = row.params.iter().map(|(_, shape)| shape.slots());
        let declared = declaration.parameters.iter().map(|(_, repr)| repr.slots());
        let same = provided.eq(declared) && row.result.slots() == declaration.result.slots();
        if same { Ok(row) } else { Err(error(true)) }
    };
    program.externs.iter().map(resolve).collect()
}
