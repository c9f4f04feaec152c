//! Host functions, `host function f(in v: Velocity) -> Number { ... }`. The program that embeds the
//! model may provide another body, so the header must declare all types.

use super::infer::Checker;
use super::tree::{FuncId, HostOffer};
use super::types::Type;
use crate::ast::{Bind, FunctionBody, FunctionDecl, Mode, StmtKind};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl Checker<'_> {
    /// Checks the header of a host function, which must declare all its types.
    pub(super) fn host_function(&mut self, id: FuncId, decl: &FunctionDecl) -> HostOffer {
        let name = &decl.name.name;
        if matches!(decl.body, FunctionBody::Symbolic(_)) {
            self.no_host(
                format!("the host function `{name}` cannot be symbolic"),
                decl.name.span,
                "declared with `:=`",
                "write a body that returns a value: `{ return ...; }`",
            );
        }
        let signature = self.signatures.get(&id);
        let types = signature.map(|signature| (signature.parameters.clone(), signature.result.clone()));
        let (parameter_types, result) = types.unwrap_or((Vec::new(), Type::Error));
        for (parameter, ty) in decl.parameters.iter().zip(parameter_types) {
            let (given, span) = (&parameter.name.name, parameter.name.span);
            if parameter.mode != Mode::In {
                self.no_host(
                    format!("a host function cannot have the `out` or `inout` parameter `{given}`"),
                    span,
                    "host functions have only `in` parameters",
                    "return the value instead",
                );
            } else if matches!(parameter.default, Some((Bind::Symbolic, _))) {
                self.no_host(
                    format!("the host function `{name}` takes values, not expressions"),
                    span,
                    "declared with `:=`",
                    &format!("write `in {given}: Type`"),
                );
            } else if parameter.annotation.is_none() {
                self.no_host(
                    format!("parameter `{given}` of a host function needs a type"),
                    span,
                    "no type",
                    &format!("write `in {given}: Type`"),
                );
            } else {
                let span = parameter.annotation.as_ref().map_or(span, |annotation| annotation.span);
                self.host_type(&ty, span);
            }
        }
        match &decl.result {
            Some(annotation) => self.host_type(&result, annotation.span),
            None => self.no_host(
                format!("the host function `{name}` needs the type of its result"),
                decl.name.span,
                "no result type",
                "write `-> Type` after the parameters",
            ),
        }
        let module = self.modules.iter().find(|module| module.file == decl.name.span.file);
        let statement = module.and_then(|module| {
            let own =
                |kind: &StmtKind| matches!(kind, StmtKind::Function(f) if f.name.span == decl.name.span);
            module.tree.statements.iter().find(|statement| own(&statement.kind))
        });
        let module = module.map(|module| module.name.as_str()).filter(|module| !module.is_empty());
        HostOffer {
            name: module.map_or_else(|| name.to_string(), |module| format!("{module}.{name}")),
            doc: statement.and_then(|statement| statement.doc.clone()).unwrap_or_default(),
        }
    }

    /// Checks that values of a type can be passed to the embedding program.
    fn host_type(&mut self, ty: &Type, span: Span) {
        let mut inner = self.store.resolve(ty);
        while let Type::Array(element) = inner {
            inner = self.store.resolve(&element);
        }
        let crosses = match &inner {
            Type::Number(dim) | Type::Vector(dim) => dim.as_known().is_some(),
            // An invalid type has already been reported.
            Type::Bool | Type::String | Type::Error => true,
            _ => false,
        };
        if !crosses {
            self.no_host(
                "a value of this type cannot be passed to the embedding program".to_owned(),
                span,
                "in a host function",
                "numbers and vectors of a known dimension, such as `Length` and `Vector(Length)`, `Bool`, `String` and arrays of these can",
            );
        }
    }

    fn no_host(&mut self, message: String, span: Span, label: &str, help: &str) {
        self.report(Diagnostic::error("E0225", message, span, label).help(help));
    }
}
