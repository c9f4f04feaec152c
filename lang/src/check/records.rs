//! Checks records: their fields, their construction, and the use of their fields as arguments.

use super::former_names::DeclaredName;
use super::infer::Checker;
use super::order::MOST_OPEN;
use super::symbols::{Resolution, similar, with_article};
use super::tree::*;
use super::type_extent::{MOST_FIELDS, MOST_NESTED};
use super::types::{Mismatch, RecordType, Type};
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::hashed::{HashMap, HashSet};
use crate::span::Span;

impl ast::RecordDecl {
    /// Returns the span from the first field to the last.
    fn span_of_fields(&self) -> Span {
        let ends = |field: &ast::RecordField| {
            let value = field.default.as_ref().map(|default| default.span);
            value.or(field.annotation.as_ref().map(|annotation| annotation.span)).unwrap_or(field.name.span)
        };
        let whole = self.fields.first().zip(self.fields.last());
        whole.map_or(self.name.span, |(first, last)| first.name.span.to(ends(last)))
    }
}

impl<'a> Checker<'a> {
    /// Sets the types of the fields of all records, from annotations and defaults.
    pub(super) fn declare_records(&mut self) {
        let records = self.names.records.clone();
        for record in &records {
            let fields = record.decl.fields.iter();
            let fields = fields.map(|field| (field.name.name.to_string(), self.store.fresh())).collect();
            let formers = record.decl.fields.iter().enumerate();
            let former =
                formers.filter_map(|(at, field)| Some((field.former.as_ref()?.name.to_string(), at)));
            let (name, former) = (record.decl.name.name.to_string(), former.collect());
            self.store.records.push(RecordType { name, fields, former });
        }
        // The types of instances have the members of their components, which are known when these
        // have been checked.
        for component in self.components.clone() {
            let name = self.names.functions[component.0 as usize].name.to_string();
            let fields = self.imported_members.remove(&component).unwrap_or_default();
            self.store.records.push(RecordType { name, fields, former: Vec::new() });
        }
        let all = || {
            (0..).map(RecordId).zip(&records).flat_map(|(id, record)| {
                record.decl.fields.iter().enumerate().map(move |(at, field)| (id, at, field, record.file))
            })
        };
        for (id, at, field, file) in all() {
            let optional = field.default.as_ref().is_some_and(|default| self.is_none_word(default));
            if optional {
                let inner = self.store.fresh();
                self.store.records[id.0 as usize].fields[at].1 = Type::optional(inner);
            }
            if let Some(annotation) = &field.annotation {
                let annotated = self.in_file(file, |c| c.annotation(annotation, true));
                let annotated = if optional { Type::optional(annotated) } else { annotated };
                if self.store.unify(&self.field_type(id, at), &annotated).is_err() {
                    // Infinite or too large, which `refuse_endless_records` reports.
                    self.store.records[id.0 as usize].fields[at].1 = annotated;
                }
            }
        }
        let texts: Vec<Span> = records.iter().map(|record| record.decl.span_of_fields()).collect();
        let of_records = |res| match res {
            Resolution::Record(id) => Some(id.0),
            _ => None,
        };
        let order = self.by_dependence(&texts, of_records);
        self.refuse_endless_records(&order);
        for id in &order {
            self.field_defaults(RecordId(*id));
            self.refuse_endless_records(&[*id]);
        }
        self.solve_constraints();
        self.refuse_endless_records(&order);
    }

    /// Sets the types of a record's fields from their defaults.
    fn field_defaults(&mut self, id: RecordId) {
        let (decl, file) = {
            let record = &self.names.records[id.0 as usize];
            (record.decl, record.file)
        };
        for (at, field) in decl.fields.iter().enumerate() {
            let Some(default) = &field.default else { continue };
            let ty = self.field_type(id, at);
            let around = self.constant_place.replace("the default of a field");
            self.making.push(id);
            self.in_file(file, |c| {
                let value = c.as_value(|c| {
                    let value = c.whole_for(&ty, default);
                    let value = c.fitted(&ty, value);
                    c.named_handle(&ty, value, &field.name.name)
                });
                let what = format!("the default of `{}`", field.name.name);
                match c.store.unify(&ty, &value.ty) {
                    Err(Mismatch::Infinite) if c.holds(&value.ty, id) => c.endless_record(id, at),
                    Err(Mismatch::Infinite) => c.large_record(id),
                    _ => c.expect(&ty, &value, what, Some((field.name.span, "declared here".into()))),
                }
            });
            self.making.pop();
            self.constant_place = around;
        }
    }

    /// Returns `true` if the type of some field depends on its uses, such as `x = [];`.
    pub(super) fn has_open_records(&self) -> bool {
        let (mut types, mut dims) = Default::default();
        let fields = self.store.records.iter().flat_map(|record| &record.fields);
        fields.for_each(|(_, ty)| self.store.unknowns(ty, &mut types, &mut dims));
        !types.is_empty() || !dims.is_empty()
    }

    fn field_type(&self, id: RecordId, at: usize) -> Type {
        let field = self.store.record(id).and_then(|record| record.fields.get(at));
        field.map_or(Type::Error, |(_, ty)| ty.clone())
    }

    /// Reports records that contain themselves, directly or through other records or arrays, and
    /// records that are too large.
    fn refuse_endless_records(&mut self, order: &[u32]) {
        for id in order.iter().copied().map(RecordId) {
            if self.store.is_bounded(&Type::Record(id)) {
                continue;
            }
            let fields = 0..self.store.records[id.0 as usize].fields.len();
            let own: Vec<usize> = fields.filter(|at| self.holds(&self.field_type(id, *at), id)).collect();
            match own.is_empty() {
                true => self.large_record(id),
                false => own.into_iter().for_each(|at| self.endless_record(id, at)),
            }
        }
    }

    /// Reports a field that makes its record infinite, and gives the field the error type.
    fn endless_record(&mut self, id: RecordId, at: usize) {
        let decl = self.names.records[id.0 as usize].decl;
        self.report(
            Diagnostic::error(
                "E0302",
                format!("a `{}` cannot contain itself", decl.name.name),
                decl.fields[at].name.span,
                "its type would be infinite",
            )
            .help("store the parts in a separate array, and an index here"),
        );
        self.store.records[id.0 as usize].fields[at].1 = Type::Error;
    }

    /// Reports a record with too many parts, and gives its fields the error type.
    fn large_record(&mut self, id: RecordId) {
        let name = &self.names.records[id.0 as usize].decl.name;
        self.report(
            Diagnostic::error(
                "E0302",
                format!("a `{}` would be too large", name.name),
                name.span,
                format!("more than {MOST_NESTED} nested values, or {MOST_FIELDS} parts"),
            )
            .help("store the parts in an array"),
        );
        self.store.records[id.0 as usize].fields.iter_mut().for_each(|(_, ty)| *ty = Type::Error);
    }

    /// Returns `true` if a type contains a record.
    fn holds(&self, ty: &Type, id: RecordId) -> bool {
        let (mut left, mut seen) = (vec![ty], HashSet::default());
        while let Some(ty) = left.pop() {
            match self.store.known(ty) {
                Type::Record(inner) if *inner == id => return true,
                Type::Record(inner) if seen.insert(*inner) => {
                    let fields = self.store.record(*inner).into_iter().flat_map(|record| &record.fields);
                    left.extend(fields.map(|(_, ty)| ty));
                }
                Type::Array(inner) | Type::Optional(inner) => left.push(inner),
                Type::Tuple(parts) => left.extend(parts),
                _ => {}
            }
        }
        false
    }

    /// Checks `Name(field = value, ...)`.
    pub(super) fn record_call(&mut self, id: RecordId, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let ty = Type::Record(id);
        let (decl, file) = {
            let record = &self.names.records[id.0 as usize];
            (record.decl, record.file)
        };
        let failed = Expr { kind: Kind::Error, ty: ty.clone(), span };
        let names = decl.field_names();
        self.note_arguments(&names, arguments);
        let Some(mut fields) = self.spread(&decl.name.name, &names, arguments) else { return failed };
        let parameters: Vec<(&str, bool)> = decl
            .fields
            .iter()
            .map(|field| (field.name.name.as_str(), field))
            .map(|(name, field)| (name, field.default.is_some() || fields.contains_key(name)))
            .collect();
        let Some(given) = self.match_arguments(&decl.name.name, &parameters, arguments, span) else {
            return failed;
        };
        let mut values = Vec::new();
        for (at, (field, argument)) in decl.fields.iter().zip(given).enumerate() {
            let wanted = self.field_type(id, at);
            values.push(match (argument, &field.default) {
                (Some(argument), _) if self.symbolic => self.symbolic_field(&wanted, &field.name, argument),
                (Some(argument), _) => self.value_argument(&wanted, &field.name, argument),
                (None, _) if fields.contains_key(field.name.name.as_str()) => {
                    self.field_argument(&wanted, &field.name, &mut fields, span)
                }
                // A record in the default of its own field contains itself, which is reported at
                // the field.
                (None, Some(_)) if self.making.contains(&id) || self.making.len() >= MOST_OPEN => {
                    return failed;
                }
                // Already reported at the field.
                (None, Some(_)) if matches!(self.store.known(&wanted), Type::Error) => Expr::error(span),
                (None, Some(default)) => {
                    self.making.push(id);
                    let value = self.in_file(file, |c| {
                        c.as_value(|c| {
                            let value = c.whole_for(&wanted, default);
                            let value = c.fitted(&wanted, value);
                            let value = c.named_handle(&wanted, value, &field.name.name);
                            c.expect(&wanted, &value, "the default", None);
                            value
                        })
                    });
                    self.making.pop();
                    value
                }
                // Already reported as missing.
                (None, None) => Expr::error(span),
            });
        }
        Expr { kind: Kind::Tuple(values), ty, span }
    }

    /// Checks a field of a record within a symbolic expression.
    fn symbolic_field(&mut self, ty: &Type, field: &ast::Ident, argument: &'a ast::Argument) -> Expr {
        let value = self.whole(&argument.value);
        let shown = with_article(&self.store.show(ty));
        let cause = Some((field.span, format!("`{}` takes {shown}", field.name)));
        // Within an expression, the field is the expression itself.
        let ty = match self.store.shallow(ty) {
            Type::Symbolic(inner) => *inner,
            _ => ty.clone(),
        };
        self.expect(&ty, &value, format_args!("`{}`", field.name), cause);
        value
    }

    /// Checks a call, which computes the records that its arguments spread (`..f()`) first.
    pub(super) fn call_with_records(
        &mut self,
        callee: &'a ast::Expr,
        arguments: &'a [ast::Argument],
        span: Span,
    ) -> Expr {
        let around = std::mem::take(&mut self.spread_records);
        let call = self.call(callee, arguments, span);
        let records = std::mem::replace(&mut self.spread_records, around);
        match records.is_empty() {
            true => call,
            false => {
                let ty = call.ty.clone();
                Expr { kind: Kind::Sequence(records, Box::new(call)), ty, span }
            }
        }
    }

    /// Returns the fields of spread records (`..r`) by name, except those with an explicit
    /// argument. Returns `None` if an error was reported.
    pub(super) fn spread(
        &mut self,
        function: &str,
        parameters: &[DeclaredName<'_>],
        arguments: &'a [ast::Argument],
    ) -> Option<HashMap<String, Expr>> {
        let mut fields = HashMap::default();
        let mut sound = true;
        for argument in arguments.iter().filter(|argument| argument.spread) {
            let brackets = self.symbolic && self.names_brackets(&argument.value);
            let record = match brackets {
                true => self.expr(&argument.value),
                false => self.as_value(|c| c.expr(&argument.value)),
            };
            let id = match self.store.shallow(&record.ty) {
                Type::Record(id) => id,
                Type::Error => {
                    sound = false;
                    continue;
                }
                other => {
                    let shown = with_article(&self.store.show(&other));
                    let message = match other {
                        Type::Unknown(_) => "`..` needs a record whose type is known here".to_string(),
                        _ => format!("`..` takes a record, not {shown}"),
                    };
                    self.report(
                        Diagnostic::error("E0301", message, argument.value.span, "not a record")
                            .help("declare the type of the parameter as a record, because its fields are passed by name"),
                    );
                    sound = false;
                    continue;
                }
            };
            let computed = super::places::calls(&record);
            if computed && (self.symbolic || self.constant_place.is_some()) {
                self.report(
                    Diagnostic::error(
                        "E0206",
                        "the record after `..` must be a variable here, because each field reads it",
                        argument.value.span,
                        "computed here",
                    )
                    .help("put it into a variable first"),
                );
                sound = false;
                continue;
            }
            // Each field reads the record, which is computed once.
            let record = match computed {
                true => {
                    let (record, keep) = self.keep("record", record);
                    self.spread_records.push(keep);
                    record
                }
                false => record,
            };
            let Some(found) = self.store.record(id).cloned() else { continue };
            for (at, (name, ty)) in found.fields.iter().enumerate() {
                let place = argument.value.span;
                let Some(position) = self.spread_position(function, parameters, id, name, place) else {
                    let diagnostic = Diagnostic::error(
                        "E0205",
                        format!("`{function}` has no parameter for the field `{name}` of `{}`", found.name),
                        argument.value.span,
                        "every field is passed as an argument",
                    );
                    let names = parameters.iter().map(|parameter| parameter.name.name.as_str());
                    let diagnostic = match similar(name, names) {
                        Some(near) => diagnostic.help(format!("is the parameter `{near}` meant?")),
                        None => diagnostic.help("pass the fields one by one: `f(a = r.a)`"),
                    };
                    self.report(diagnostic);
                    sound = false;
                    continue;
                };
                // An explicit argument takes precedence.
                let name = &parameters[position].name.name;
                let written = arguments.iter().enumerate().any(|(index, other)| match &other.name {
                    Some((given, _)) => self.current_name(given) == *name,
                    None => !other.spread && index == position,
                });
                if written {
                    continue;
                }
                let kind = Kind::TupleElement(Box::new(record.clone()), at);
                let value = Expr { kind, ty: ty.clone(), span: argument.value.span };
                if fields.insert(name.to_string(), value).is_some() {
                    self.report(
                        Diagnostic::error(
                            "E0206",
                            format!("two records have the field `{name}`"),
                            argument.value.span,
                            "second occurrence",
                        )
                        .help(format!("write `{name} = ...` to choose one")),
                    );
                    sound = false;
                }
            }
        }
        if !sound {
            self.check_loosely(arguments);
        }
        sound.then_some(fields)
    }

    /// Returns a field that is used as an argument.
    pub(super) fn field_argument(
        &mut self,
        ty: &Type,
        parameter: &ast::Ident,
        fields: &mut HashMap<String, Expr>,
        span: Span,
    ) -> Expr {
        let Some(value) = fields.remove(parameter.name.as_str()) else { return Expr::error(span) };
        let cause = Some((
            parameter.span,
            format!("`{}` takes {}", parameter.name, with_article(&self.store.show(ty))),
        ));
        let value = self.named_handle(ty, value, &parameter.name);
        let wanted = self.without_optional(ty, &value);
        self.expect(&wanted, &value, format_args!("`{}`", parameter.name), cause);
        self.as_optional(ty, value)
    }

    fn has_field(&self, ty: &Type, field: &str) -> bool {
        matches!(self.store.known(ty), Type::Record(id) if self.store.field(*id, field).is_some())
    }

    /// Returns the error for a field that does not exist.
    pub(super) fn no_field(&self, ty: &Type, field: &str, span: Span) -> Diagnostic {
        let shown = with_article(&self.store.show(ty));
        let diagnostic =
            Diagnostic::error("E0307", format!("{shown} has no field `{field}`"), span, "no such field");
        match ty {
            Type::Record(id) => {
                let names: Vec<&str> = self
                    .store
                    .record(*id)
                    .map(|record| record.fields.iter().map(|(name, _)| name.as_str()).collect())
                    .unwrap_or_default();
                match similar(field, names.iter().copied()) {
                    Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                        format!("change to `{near}`"),
                        span,
                        near,
                    ),
                    None => {
                        let kind = if self.component_of(*id).is_some() { "component" } else { "record" };
                        let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
                        diagnostic.help(match names.is_empty() {
                            true => format!("the {kind} has no fields"),
                            false => format!("the {kind} has the fields {}", names.join(", ")),
                        })
                    }
                }
            }
            Type::Array(element) if self.has_field(element, field) => {
                diagnostic.help(format!("its elements have this field: write `[0].{field}` after the array"))
            }
            Type::Handle(handle) if handle_field(handle, field).is_some() => {
                diagnostic.help(format!("state the type where the value is declared: `in body: {handle}`"))
            }
            Type::Handle(handle) => match HANDLE_FIELDS.iter().find(|(known, ..)| known == handle) {
                Some((_, name, _)) => diagnostic.help(format!("{shown} has the field `{name}`")),
                None => diagnostic.help("give it to a function of the library, which returns its properties"),
            },
            _ => diagnostic
                .help("vectors have the components `.x`, `.y` and `.z`, records their declared fields"),
        }
    }
}

/// The fields of objects of the library: type, name, and documentation.
pub const HANDLE_FIELDS: &[(&str, &str, &str)] =
    &[("Body", "frame", "Transform from ground coordinates to the coordinates of the body.")];

/// Returns the function that reads a field of an object of the library, and the type of the field.
pub(super) fn handle_field(handle: &str, field: &str) -> Option<(Standard, Type)> {
    match (handle, field) {
        ("Body", "frame") => Some((Standard::BodyFrame, Type::Symbolic(Box::new(Type::Transform)))),
        _ => None,
    }
}
