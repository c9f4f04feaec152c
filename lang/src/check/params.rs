//! Checks params and outputs: the interface of the model.

use super::infer::Checker;
use super::symbols::with_article;
use super::tree::{DefId, Output, Param, StmtKind};
use super::types::Type;
use crate::ast::{self, Domain, ExprKind, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;

impl<'a> Checker<'a> {
    /// Checks all params first, because they are set before the program runs.
    pub(super) fn declare_params(&mut self) {
        self.constant_place = Some("a param's default");
        for (decl, doc) in self.names.params.clone() {
            let default = self.whole(&decl.default);
            let ty = default.ty.clone();
            let (mut low, mut high, mut choices) = (None, None, Vec::new());
            let name = &decl.name.name;
            match &decl.domain {
                Some(Domain::Range { low: l, high: h, .. }) => {
                    let cause = Some((
                        decl.default.span,
                        format!("`{name}` is a {} by its default", self.store.show(&ty)),
                    ));
                    // The range of an array holds for each element.
                    let limit = self.scalar(&ty);
                    for (end, e) in [(&mut low, l), (&mut high, h)] {
                        if let Some(e) = e {
                            let e = self.whole(e);
                            let number = self.fresh_number();
                            self.expect(&number, &e, "a limit of a range", None);
                            self.expect(
                                &limit,
                                &e,
                                &format!("a limit of the range of `{name}`"),
                                cause.clone(),
                            );
                            *end = Some(e);
                        }
                    }
                }
                Some(Domain::Choices { values, .. }) => {
                    for value in values {
                        let value = self.expr(value);
                        let wanted = if let Type::Enum(_) = self.store.shallow(&ty) {
                            ty.clone()
                        } else {
                            Type::String
                        };
                        self.expect(&wanted, &value, "a choice", None);
                        match super::constant::text(&value) {
                            Some(text) => choices.push(text.to_string()),
                            None if matches!(value.ty, Type::String) => {
                                self.report(
                                    Diagnostic::error(
                                        "E0212",
                                        "choices must be texts without values in braces",
                                        value.span,
                                        "this text is not constant",
                                    )
                                    .help("write the text itself"),
                                );
                            }
                            None => {}
                        }
                    }
                    self.expect(&Type::String, &default, &format!("the default of `{name}`"), None);
                }
                None => {}
            }
            self.domain(&ty, decl.domain.as_ref(), Some(&default), name);
            self.dependence.param(self.params.len() as u32, &default);
            self.note_circular_param(self.params.len() as u32, &default);
            self.params.push(Param {
                name: name.clone(),
                doc: doc.unwrap_or_default().to_string(),
                ty,
                whole: is_whole(&decl.default),
                default,
                low,
                high,
                choices,
                unit: None,
                span: decl.name.span,
            });
        }
        self.constant_place = None;
    }

    /// Determines the type and the unit of each param, once types are known.
    pub(super) fn finish_params(&mut self) {
        for index in 0..self.params.len() {
            let (ty, span) = (self.store.resolve(&self.params[index].ty), self.params[index].span);
            let decl = self.names.params[index].0;
            let element = match &ty {
                Type::Array(element) => self.store.resolve(element),
                other => other.clone(),
            };
            match &element {
                Type::Number(dim) => {
                    let dimension = dim.as_known().unwrap_or(Dimension::NONE);
                    let written = self
                        .written_unit(&decl.default)
                        .filter(|unit| !unit.name.is_empty() || dimension.is_none())
                        .unwrap_or_else(|| self.store.vocabulary.unit_of(self.shown_system(), dimension));
                    self.params[index].whole &= dimension.is_none();
                    self.params[index].unit = Some(written);
                }
                Type::Enum(of) if element == ty => {
                    let own = &mut self.params[index].choices;
                    if own.is_empty() {
                        own.clone_from(&of.choices);
                    }
                    self.params[index].whole = false;
                }
                Type::Bool | Type::String | Type::Error if element == ty => self.params[index].whole = false,
                Type::Unknown(_) if element == ty => {}
                _ => {
                    let shown = with_article(&self.store.show(&ty));
                    self.report(
                        Diagnostic::error(
                            "E0312",
                            format!("a param cannot be {shown}"),
                            span,
                            "declared here",
                        )
                        .help("params are numbers, arrays of numbers, truth values and strings"),
                    );
                }
            }
        }
    }

    /// Checks the default of a function's parameter at the declaration.
    pub(super) fn parameter_default(&mut self, ty: &Type, name: &ast::Ident, default: &'a ast::Expr) {
        let around = self.constant_place.replace("a default");
        let value = self.as_value(|c| c.whole_for(ty, default));
        self.constant_place = around;
        // Under a unit system, a literal without a unit has the dimension of each call.
        let open = matches!(self.store.shallow(ty), Type::Unknown(_));
        if !(open && super::expr::is_bare(default) && self.system().is_some()) {
            self.expect(
                ty,
                &value,
                &format!("the default of `{}`", name.name),
                Some((name.span, "declared here".into())),
            );
        }
    }

    /// Checks `output name := value;`.
    pub(super) fn output(&mut self, id: u32, name: &ast::Ident, value: &'a ast::Expr) -> StmtKind {
        let e = self.as_symbolic(|c| c.whole(value));
        let number = self.fresh_number();
        self.expect(&number, &e, &format!("the output `{}`", name.name), None);
        let (ty, span) = (e.ty.clone(), e.span);
        let def: DefId = self.make_def(&name.name, e, span);
        self.defs[def.0 as usize].stored = true;
        self.output_defs.insert(id, def);
        let doc =
            self.names.outputs.get(id as usize).and_then(|(_, _, doc)| *doc).unwrap_or_default().to_string();
        self.outputs.push(Output { name: name.name.clone(), doc, ty, span: name.span });
        StmtKind::Output(self.outputs.len() as u32 - 1, def)
    }
}

/// Returns `true` for an integer without a unit, possibly signed.
fn is_whole(e: &ast::Expr) -> bool {
    match &e.kind {
        ExprKind::Number(value) => value.fract() == 0.0,
        ExprKind::Unary { op: UnaryOp::Plus | UnaryOp::Minus, operand } => is_whole(operand),
        ExprKind::Paren(inner) => is_whole(inner),
        ExprKind::List(all) => !all.is_empty() && all.iter().all(is_whole),
        _ => false,
    }
}
