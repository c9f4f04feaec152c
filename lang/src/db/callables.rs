//! Parameters and results of functions and records: from the text of their declarations, with types
//! from the checker or a cache.

use super::Database;
use super::analysis::{extern_scheme, unit_of};
use super::items::namings;
use super::units::id;
use crate::analysis::{CallParameter, Callable, NameKind, SourceRange};
use crate::ast::{Bind, FunctionBody, FunctionDecl, Mode, RecordDecl, RecordField, Stmt, StmtKind, TypeKind};
use crate::check::{ShownScheme, declared_names};
use crate::declared::{self, Declared};
use crate::deep_recursion::with_deep_stack;
use crate::dimension::Dimension;
use crate::span::Span;

/// The known types of a declaration.
pub(super) struct Types<'t> {
    pub scheme: &'t dyn Fn(&FunctionDecl) -> ShownScheme,
    pub field: &'t dyn Fn(&RecordDecl, &RecordField) -> String,
    pub dimension: &'t dyn Fn(Span) -> Option<Dimension>,
}

impl Database {
    /// Returns the parameters and the result of the function or record declared at a location.
    pub fn callable(&self, place: &SourceRange) -> Option<Callable> {
        let db = &self.salsa;
        let text = self.find(&place.file)?;
        let part = self.part_at(&place.file, place.start)?;
        let item = with_deep_stack(|| self.items_in(text, place.start..place.start)).into_iter().next()?;
        let unit = with_deep_stack(|| unit_of(db, item, self.library));
        // Converts to locations in the unit's excerpt.
        let base = unit.and_then(|unit| unit.layout.start(id(item)));
        let moved = |span: Span| {
            let (file, base) = base.unwrap_or_default();
            let by = |at: u32| (at + part.start + base).saturating_sub(item.start(db));
            Span { file, start: by(span.start), end: by(span.end) }
        };
        let scheme = |decl: &FunctionDecl| {
            let shown = match decl.body {
                FunctionBody::Extern { .. } => extern_scheme(db, item),
                _ => {
                    let function = unit.and_then(|unit| unit.meanings.function_at(moved(decl.name.span)));
                    function.and_then(|function| unit?.meanings.scheme(function)).cloned()
                }
            };
            shown.unwrap_or_default()
        };
        let field = |_: &RecordDecl, field: &RecordField| {
            let meaning = unit.and_then(|unit| unit.meanings.at(&unit.typed, moved(field.name.span)));
            meaning.and_then(|meaning| meaning.ty).unwrap_or_default()
        };
        let dimension = |span: Span| unit?.meanings.dimension_at(&unit?.typed, moved(span));
        self.called(place, &Types { scheme: &scheme, field: &field, dimension: &dimension })
    }

    /// Returns the former name of the declaration at a location.
    pub(super) fn former_name(&self, place: &SourceRange) -> Option<String> {
        let part = self.part_at(&place.file, place.start)?;
        let (_, found) = declared::find_in(&part.piece.statements, place.start.checked_sub(part.start)?)?;
        declared::former(found).map(|former| former.name.to_string())
    }

    /// Returns the members of the instances of the component declared at a location.
    pub fn members_of_component(&self, place: &SourceRange) -> Option<Vec<CallParameter>> {
        let db = &self.salsa;
        let text = self.find(&place.file)?;
        let item = with_deep_stack(|| self.items_in(text, place.start..place.start)).into_iter().next()?;
        let unit = with_deep_stack(|| unit_of(db, item, self.library))?;
        let (file, base) = unit.layout.start(id(item))?;
        let start = item.start(db);
        let StmtKind::Function(decl) = &item.content(db).statement.kind else { return None };
        let FunctionBody::Statement(body) = &decl.body else { return None };
        let StmtKind::Block(statements) = &body.kind else { return None };
        let parameters = decl.parameters.iter().map(|parameter| (&parameter.name, parameter.doc.clone()));
        let declared = statements.iter().flat_map(|statement| {
            declared_names(statement).into_iter().map(|name| (name, statement.doc.clone()))
        });
        let members = parameters.chain(declared).filter_map(|(name, doc)| {
            let moved = Span { file, start: name.span.start + base, end: name.span.end + base };
            let meaning = unit.meanings.at(&unit.typed, moved)?;
            let at = |from: u32| start + from;
            let declared =
                SourceRange { file: place.file.clone(), start: at(name.span.start), end: at(name.span.end) };
            let observed = meaning.kind == NameKind::Output;
            let ty = meaning.ty.unwrap_or_default();
            Some(CallParameter {
                name: name.name.as_str().into(),
                former: None,
                mode: Mode::In,
                symbolic: false,
                ty: if observed { format!("Observable({ty})") } else { ty },
                dimension: unit.meanings.dimension_at(&unit.typed, moved),
                default: None,
                range: None,
                choices: Vec::new(),
                doc,
                declared: Some(declared),
            })
        });
        Some(members.collect())
    }

    /// Computes [`Database::callable`] with types from another source.
    pub(super) fn called(&self, place: &SourceRange, types: &Types<'_>) -> Option<Callable> {
        let part = self.part_at(&place.file, place.start)?;
        let content = self.text(&place.file)?.get(part.start as usize..)?;
        let found = declared::find_in(&part.piece.statements, place.start - part.start)?;
        let (_, Declared::Statement(statement)) = found else { return None };
        let mut callable = described(place, part.start, content, statement, types)?;
        self.offer_names(place, statement, &mut callable);
        Some(callable)
    }
}

impl Database {
    /// Adds the names of handles to the choices of the parameters that take one.
    fn offer_names(&self, place: &SourceRange, statement: &Stmt, callable: &mut Callable) {
        let (StmtKind::Function(decl), Some(text)) = (&statement.kind, self.find(&place.file)) else {
            return;
        };
        let namings = namings(&self.salsa, text);
        for (parameter, described) in decl.parameters.iter().zip(&mut callable.parameters) {
            let Some(TypeKind::Name(handle)) = parameter.annotation.as_ref().map(|ty| &ty.kind) else {
                continue;
            };
            let Some(item) = namings.get(handle.name.as_str()) else { continue };
            let StmtKind::Function(naming) = &item.content(&self.salsa).statement.kind else { continue };
            let domain = naming.parameters.first().and_then(|parameter| parameter.domain.as_ref());
            described.choices = declared::choices(domain);
        }
    }
}

/// `content` is the text from `start` on, to which the locations of the statement are relative.
fn described(
    place: &SourceRange,
    start: u32,
    content: &str,
    statement: &Stmt,
    types: &Types<'_>,
) -> Option<Callable> {
    let slice = |span: Span| content.get(span.start as usize..span.end as usize).map(str::to_string);
    let at = |span: Span| {
        Some(SourceRange { file: place.file.clone(), start: span.start + start, end: span.end + start })
    };
    let mut callable = Callable {
        name: content.get((place.start - start) as usize..(place.end - start) as usize)?.into(),
        kind: NameKind::Function,
        doc: statement.doc.clone(),
        parameters: Vec::new(),
        open: false,
        result: None,
        demands: Vec::new(),
        declared: Some(place.clone()),
    };
    match &statement.kind {
        StmtKind::Function(decl) => {
            match decl.body {
                FunctionBody::Extern { .. } => callable.kind = NameKind::Extern,
                FunctionBody::Symbolic(_) => callable.kind = NameKind::SymbolicFunction,
                FunctionBody::Statement(_) if decl.is_component => callable.kind = NameKind::Component,
                FunctionBody::Statement(_) => {}
            }
            let shown = (types.scheme)(decl);
            callable.result = shown.result;
            callable.demands = shown.demands;
            for (index, parameter) in decl.parameters.iter().enumerate() {
                let (bind, value) = match &parameter.default {
                    Some((bind, value)) => (*bind, value.as_ref()),
                    None => (Bind::Evaluate, None),
                };
                callable.parameters.push(CallParameter {
                    name: parameter.name.name.as_str().into(),
                    former: parameter.former.as_ref().map(|former| former.name.as_str().into()),
                    mode: parameter.mode,
                    symbolic: bind == Bind::Symbolic,
                    ty: shown.parameters.get(index).map(|(_, _, ty)| ty.clone()).unwrap_or_default(),
                    dimension: (types.dimension)(parameter.name.span),
                    default: value.and_then(|value| slice(value.span)),
                    range: declared::range(parameter.domain.as_ref(), content),
                    choices: declared::choices(parameter.domain.as_ref()),
                    doc: parameter.doc.clone(),
                    declared: at(parameter.name.span),
                });
            }
        }
        StmtKind::Record(decl) => {
            callable.kind = NameKind::Record;
            callable.result = Some(decl.name.name.to_string());
            for field in &decl.fields {
                callable.parameters.push(CallParameter {
                    name: field.name.name.as_str().into(),
                    former: field.former.as_ref().map(|former| former.name.as_str().into()),
                    mode: Mode::In,
                    symbolic: false,
                    ty: (types.field)(decl, field),
                    dimension: (types.dimension)(field.name.span),
                    default: field.default.as_ref().and_then(|value| slice(value.span)),
                    range: None,
                    choices: Vec::new(),
                    doc: field.doc.clone(),
                    declared: at(field.name.span),
                });
            }
        }
        _ => return None,
    }
    Some(callable)
}
