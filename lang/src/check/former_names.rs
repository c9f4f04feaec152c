//! Former names. `in teeth was lugs` declares a parameter that calls may still name `lugs`.
//!
//! A former name means the same as the current name. Each use is reported with a fix (W0840).

use super::infer::Checker;
use super::tree::RecordId;
use super::types::Type;
use crate::ast::{Argument, FunctionDecl, Ident, RecordDecl};
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::Span;

/// The name of a parameter or field, and its former name.
#[derive(Clone, Copy)]
pub(super) struct DeclaredName<'d> {
    pub name: &'d Ident,
    pub former: Option<&'d Ident>,
}

impl DeclaredName<'_> {
    pub fn was(&self, name: &str) -> bool {
        self.former.is_some_and(|former| former.name == name)
    }
}

impl FunctionDecl {
    pub(super) fn parameter_names(&self) -> Vec<DeclaredName<'_>> {
        let each = self.parameters.iter();
        each.map(|p| DeclaredName { name: &p.name, former: p.former.as_ref() }).collect()
    }
}

impl RecordDecl {
    pub(super) fn field_names(&self) -> Vec<DeclaredName<'_>> {
        let each = self.fields.iter();
        each.map(|f| DeclaredName { name: &f.name, former: f.former.as_ref() }).collect()
    }
}

/// Returns the warning for the use of a former name.
pub(super) fn warning(used: &Ident, current: &str) -> Diagnostic {
    renamed(&used.name, current, used.span)
        .help("use the new name; a later version will not accept the former one")
        .fix(format!("change to `{current}`"), used.span, current)
}

fn renamed(former: &str, current: &str, span: Span) -> Diagnostic {
    Diagnostic::warning("W0840", format!("`{former}` is now called `{current}`"), span, "former name")
}

impl Checker<'_> {
    /// Records the parameter or field that each named argument refers to, and reports former names.
    pub(super) fn note_arguments(&mut self, declared: &[DeclaredName<'_>], arguments: &[Argument]) {
        let named = || arguments.iter().filter_map(|argument| argument.name.as_ref());
        if named().next().is_none() {
            return;
        }
        let current: HashMap<&str, &DeclaredName<'_>> =
            declared.iter().map(|declared| (declared.name.name.as_str(), declared)).collect();
        for (used, _) in named() {
            if let Some(found) = current.get(used.name.as_str()) {
                self.named_parts.push((used.span, found.name.span));
            } else if let Some(found) = declared.iter().find(|declared| declared.was(&used.name)) {
                self.named_parts.push((used.span, found.name.span));
                self.current_names.insert(used.span, found.name.name.to_string());
                // With both names in a call, the fix would give one name twice.
                if !named().any(|(other, _)| other.name == found.name.name) {
                    self.report(warning(used, &found.name.name));
                }
            }
        }
    }

    /// Returns the current name of the parameter that an argument names.
    pub(super) fn current_name<'n>(&'n self, used: &'n Ident) -> &'n str {
        self.current_names.get(&used.span).map_or(&used.name, String::as_str)
    }

    /// Returns the index of the parameter that takes a field of a spread record, and reports it if
    /// their names agree only by a former name.
    pub(super) fn spread_position(
        &mut self,
        function: &str,
        parameters: &[DeclaredName<'_>],
        record: RecordId,
        field: &str,
        span: Span,
    ) -> Option<usize> {
        if let Some(at) = parameters.iter().position(|parameter| parameter.name.name == field) {
            return Some(at);
        }
        let decl = self.names.records.get(record.0 as usize)?.decl;
        let of_record = &decl.name.name;
        if let Some(at) = parameters.iter().position(|parameter| parameter.was(field)) {
            let current = &parameters[at].name.name;
            let help = format!("rename the field `{field}` of `{of_record}`");
            self.report(renamed(field, current, span).help(help));
            return Some(at);
        }
        let own = decl.fields.iter().find(|declared| declared.name.name == field)?;
        let former = &own.former.as_ref()?.name;
        let at = parameters.iter().position(|parameter| parameter.name.name == *former)?;
        let help = format!("rename the parameter `{former}` of `{function}`");
        self.report(renamed(former, field, span).help(help));
        Some(at)
    }

    /// Reports the fields that are read or assigned by their former names.
    pub(super) fn report_former_fields(&mut self) {
        let mut found = Vec::new();
        for (field, base) in &self.named_fields {
            let Type::Record(id) = self.store.shallow(base) else { continue };
            let Some(record) = self.names.records.get(id.0 as usize) else { continue };
            let names = record.decl.field_names();
            let is_current = names.iter().any(|declared| declared.name.name == field.name);
            let former = names.iter().find(|declared| declared.was(&field.name)).filter(|_| !is_current);
            found.extend(former.map(|declared| warning(field, &declared.name.name)));
        }
        found.into_iter().for_each(|warning| self.report(warning));
    }
}
