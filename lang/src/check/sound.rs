//! Finds functions whose control flow can be checked although the program has errors elsewhere.

use super::infer::Checker;
use super::tree::FuncId;
use crate::ast;
use crate::diagnostic::{Diagnostic, Severity};
use crate::span::{FileId, Span};

impl Checker<'_> {
    /// Returns the functions of the model's own file whose text has no errors, with that text.
    pub fn sound_functions(&self, diagnostics: &[Diagnostic]) -> Vec<(FuncId, Span)> {
        let functions = self.names.functions.iter().enumerate().skip(1);
        let texts = functions.filter_map(|(index, info)| {
            let decl = info.decl.filter(|_| info.file == FileId(0))?;
            let ast::FunctionBody::Statement(body) = &decl.body else { return None };
            Some((FuncId(index as u32), Span { end: body.span.end, ..decl.name.span }))
        });
        let wrong_in = |text: &Span| {
            diagnostics.iter().any(|d| {
                let at = d.primary.span;
                d.severity == Severity::Error
                    && at.file == text.file
                    && at.start >= text.start
                    && at.end <= text.end
            })
        };
        texts.filter(|(_, text)| !wrong_in(text)).collect()
    }
}
