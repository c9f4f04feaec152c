//! Restrictions of test functions, which run without arguments and without the model's top level.

use super::Resolver;
use crate::ast::{FunctionBody, FunctionDecl, Ident};
use crate::check::tree::VarId;
use crate::diagnostic::Diagnostic;

impl Resolver<'_> {
    /// Rejects parameters and a result of a test function.
    pub(super) fn test(&mut self, decl: &FunctionDecl) {
        let place = match (decl.parameters.first(), &decl.result) {
            (Some(parameter), _) => parameter.name.span,
            (None, Some(result)) => result.span,
            (None, None) if matches!(decl.body, FunctionBody::Statement(_)) => return,
            (None, None) => decl.name.span,
        };
        self.report(
            Diagnostic::error(
                "E0222",
                format!("the test `{}` has a parameter or a result", decl.name.name),
                place,
                "not allowed in a test",
            )
            .help(
                "write `test function name() { assert(...); }`, and call functions with arguments inside it",
            ),
        );
    }

    /// Rejects variables of the model in tests, which run without the model's top level.
    pub(super) fn refuse_in_test(&mut self, name: &Ident, id: VarId) {
        let variable = &self.names.variables[id.0 as usize];
        let (owner, declared) = (variable.owner, variable.span);
        let mut at = Some(self.function);
        while let Some(function) = at.filter(|function| *function != owner) {
            let info = &self.names.functions[function.0 as usize];
            if info.decl.is_some_and(|decl| decl.is_test) {
                let diagnostic = Diagnostic::error(
                    "E0223",
                    format!("a test cannot use the variable `{}`", name.name),
                    name.span,
                    "a variable of the model",
                )
                .label(declared, "declared here")
                .help("compute the value inside the test, or make it a `const` or a function");
                return self.report(diagnostic);
            }
            at = info.parent;
        }
    }
}
