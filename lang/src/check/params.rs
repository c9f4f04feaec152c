//! Checks params and outputs: the interface of the model.

use super::branches::OutputCaptures;
use super::infer::Checker;
use super::symbols::{ParamInfo, with_article};
use super::tree::{DefId, Expr, FuncId, Kind, Output, Param, StmtKind, VarId};
use super::types::Type;
use crate::ast::{self, Domain, ExprKind, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::span::Span;

impl<'a> Checker<'a> {
    /// Checks the params of the model first, because they are set before the program runs. Those of
    /// a component are checked with its body.
    pub(super) fn declare_params(&mut self) {
        for index in 0..self.names.params.len() {
            let info = self.names.params[index];
            let (name, span) = (info.decl.name.name.to_string(), info.decl.name.span);
            let param = match info.owner {
                FuncId(0) => self.declared_param(index as u32),
                owner => Param {
                    name,
                    doc: info.doc.unwrap_or_default().to_string(),
                    ty: self.store.fresh(),
                    default: Expr::error(span),
                    low: None,
                    high: None,
                    choices: Vec::new(),
                    unit: None,
                    whole: takes_whole_numbers(info.decl, &|span| self.text(span)),
                    owner,
                    span,
                },
            };
            self.params.push(param);
        }
    }

    /// Checks the params of a component.
    pub(super) fn declare_component_params(&mut self, component: FuncId) {
        for index in 0..self.names.params.len() {
            if self.names.params[index].owner == component {
                let param = self.declared_param(index as u32);
                // Functions inside the component may already use the type.
                let before = self.params[index].ty.clone();
                self.expect(&before, &param.default.clone(), format_args!("`{}`", param.name), None);
                self.params[index] = param;
            }
        }
    }

    /// Checks the declaration of a param.
    fn declared_param(&mut self, index: u32) -> Param {
        let ParamInfo { decl, doc, owner } = self.names.params[index as usize];
        let around = self.constant_place.replace("a param's default");
        self.declaring_param = true;
        let default = self.whole(&decl.default);
        let ty = default.ty.clone();
        let (mut low, mut high, mut choices) = (None, None, Vec::new());
        // An error in a list of choices is reported once.
        let mut is_sound = true;
        let name = &decl.name.name;
        match &decl.domain {
            Some(Domain::Range { low: l, high: h, .. }) => {
                let cause = Some((
                    decl.default.span,
                    format!("`{name}` is {} by its default", with_article(&self.store.show(&ty))),
                ));
                // The range of an array holds for each element.
                let limit = self.scalar(&ty);
                for (end, e) in [(&mut low, l), (&mut high, h)] {
                    if let Some(e) = e {
                        let e = self.whole(e);
                        let number = self.fresh_number();
                        self.expect(&number, &e, "a limit of a range", None);
                        let what = format!("a limit of the range of `{name}`");
                        self.expect(&limit, &e, what, cause.clone());
                        *end = Some(e);
                    }
                }
            }
            Some(Domain::Choices { values, .. }) => {
                let texts = self.param_choices(&ty, values);
                is_sound = texts.is_some();
                choices = texts.unwrap_or_default();
                if is_sound {
                    self.expect(&Type::String, &default, format_args!("the default of `{name}`"), None);
                }
            }
            None => {}
        }
        if is_sound {
            self.domain(&ty, decl.domain.as_ref(), Some(&default), name);
        }
        self.dependence.param(index, &default);
        self.note_circular_param(index, &default);
        self.constant_place = around;
        self.declaring_param = false;
        Param {
            name: name.to_string(),
            doc: doc.unwrap_or_default().to_string(),
            ty,
            whole: takes_whole_numbers(decl, &|span| self.text(span)),
            default,
            low,
            high,
            choices,
            unit: None,
            owner,
            span: decl.name.span,
        }
    }

    /// Returns the allowed texts of a param of a type; `None` after reporting the first element
    /// that is not a text.
    fn param_choices(&mut self, ty: &Type, values: &'a [ast::Expr]) -> Option<Vec<String>> {
        let mut choices = Vec::new();
        for value in values {
            let value = self.expr(value);
            if let Some(problem) = self.choice_of_other_kind(&value) {
                self.report(problem);
                return None;
            }
            let wanted = if let Type::Enum(_) = self.store.shallow(ty) { ty.clone() } else { Type::String };
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
        Some(choices)
    }

    /// Returns the error for a number or a truth value in a list of choices.
    fn choice_of_other_kind(&self, value: &Expr) -> Option<Diagnostic> {
        let ty = self.store.shallow(&value.ty);
        let help = match ty {
            Type::Number(_) => "give a range such as `in 1 .. 3` for numbers, or write the choices as texts",
            Type::Bool => "a param with the default `true` or `false` needs no list of choices",
            _ => return None,
        };
        let shown = with_article(&self.store.show(&ty));
        let message = format!("a choice must be a String, not {shown}");
        Some(Diagnostic::error("E0301", message, value.span, format!("this is {shown}")).help(help))
    }

    /// Determines the type and the unit of each param, once types are known.
    pub(super) fn finish_params(&mut self) {
        for index in 0..self.params.len() {
            let (ty, span) = (self.store.resolve(&self.params[index].ty), self.params[index].span);
            let decl = self.names.params[index].decl;
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
        let value = self.named_handle(ty, value, &name.name);
        self.constant_place = around;
        // Under a unit system, a literal without a unit has the dimension of each call.
        let open = matches!(self.store.known(ty), Type::Unknown(_));
        if !(open && super::expr::is_bare(default) && self.system().is_some()) {
            self.expect(
                ty,
                &value,
                format_args!("the default of `{}`", name.name),
                Some((name.span, "declared here".into())),
            );
        }
    }

    /// Checks `output name := value in unit;`.
    pub(super) fn output(
        &mut self,
        id: u32,
        name: &ast::Ident,
        value: &'a ast::Expr,
        unit: Option<&'a ast::Expr>,
    ) -> StmtKind {
        let e = match listed(value) {
            Some(elements) => self.listed_outputs(name, elements, value.span),
            None => self.as_symbolic(|c| c.whole(value)),
        };
        self.solve_open_constraints(std::iter::once(&e.ty));
        if matches!(self.store.known(&e.ty), Type::Array(_)) && !self.is_symbolic_brackets(&e) {
            return self.array_output(id, name, e, (value, unit));
        }
        let number = self.fresh_number();
        self.expect(&number, &e, format_args!("the output `{}`", name.name), None);
        let (ty, span) = (e.ty.clone(), e.span);
        self.output_captures = Some(OutputCaptures::Stored);
        let def: DefId = self.make_def(&name.name, e, span);
        self.output_captures = None;
        self.defs[def.0 as usize].stored = true;
        self.output_defs.insert(id, def);
        let info = self.names.outputs.get(id as usize).copied();
        // The instance of a component has the output as a member.
        let member = info.is_some_and(|info| info.owner != FuncId(0));
        let member = member.then(|| self.observable_variable(&name.name, &ty, name.span));
        let index = self.add_output(id, name, ty, (value, unit), member);
        StmtKind::Output(index, def)
    }

    fn add_output(
        &mut self,
        id: u32,
        name: &ast::Ident,
        ty: Type,
        (value, unit): (&'a ast::Expr, Option<&'a ast::Expr>),
        member: Option<VarId>,
    ) -> u32 {
        let choices = match unit {
            Some(stated) => self.stated_choices(&ty, value.span, stated),
            None => self.usual_choices(value),
        };
        let unit = match unit {
            _ if choices.is_some() => None,
            Some(unit) => self.output_unit(&ty, value.span, unit),
            None => self.usual_unit(&ty, value),
        };
        let choices = choices.unwrap_or_default();
        let info = self.names.outputs.get(id as usize);
        let doc = info.and_then(|info| info.doc).unwrap_or_default().to_string();
        let owner = info.map_or(FuncId(0), |info| info.owner);
        self.outputs.push(Output {
            name: name.name.to_string(),
            doc,
            ty,
            unit,
            choices,
            owner,
            member,
            span: name.span,
        });
        self.outputs.len() as u32 - 1
    }

    /// Checks the elements of an array of outputs as written: each may depend on `Time`.
    fn listed_outputs(&mut self, name: &ast::Ident, elements: &'a [ast::Expr], span: Span) -> Expr {
        let element_type = Type::Observable(self.store.fresh_dim());
        let mut ty = element_type.clone();
        let elements: Vec<Expr> = elements
            .iter()
            .map(|element| match listed(element) {
                Some(inner) => self.listed_outputs(name, inner, element.span),
                None => {
                    let e = self.as_symbolic(|c| c.whole(element));
                    let number = self.fresh_number();
                    self.expect(&number, &e, format_args!("an element of the output `{}`", name.name), None);
                    self.output_captures = Some(OutputCaptures::Immediate);
                    let element = self.as_observable(e);
                    self.output_captures = None;
                    element
                }
            })
            .collect();
        if let Some(first) = elements.first() {
            ty = first.ty.clone();
        }
        for element in &elements {
            self.expect(&ty, element, "an element of this array", None);
        }
        Expr { kind: Kind::Array(elements), ty: Type::array(ty), span }
    }

    /// Checks `output name := array;`. The outputs have indices: `name[0]`.
    fn array_output(
        &mut self,
        id: u32,
        name: &ast::Ident,
        e: Expr,
        (value, unit): (&'a ast::Expr, Option<&'a ast::Expr>),
    ) -> StmtKind {
        let mut element = self.store.shallow(&e.ty);
        while let Type::Array(inner) = element {
            element = self.store.shallow(&inner);
        }
        let number = match element {
            Type::Observable(dim) | Type::Number(dim) => Type::Number(dim),
            other => {
                let number = self.fresh_number();
                let found = Expr { ty: other, ..e.clone() };
                self.expect(&number, &found, format_args!("an element of the output `{}`", name.name), None);
                number
            }
        };
        self.note_evaluated(&e);
        let variable = self.hidden_variable(&name.name, name.span, e.ty.clone());
        self.dependence.variable(variable, &e);
        self.output_arrays.insert(id, variable);
        let index = self.add_output(id, name, number, (value, unit), Some(variable));
        StmtKind::ArrayOutput(index, e)
    }
}

/// Returns the elements of brackets.
pub(super) fn listed(e: &ast::Expr) -> Option<&[ast::Expr]> {
    match &e.kind {
        ExprKind::List(elements) => Some(elements),
        ExprKind::Paren(inner) => listed(inner),
        _ => None,
    }
}

/// Text of a number in the source.
type Written<'a> = &'a dyn Fn(Span) -> &'a str;

/// Returns `true` if a param takes whole numbers only: its default and the limits of its range are
/// written as integers. `3.0` is written as a decimal number.
fn takes_whole_numbers(decl: &ast::ParamDecl, written: Written<'_>) -> bool {
    let limits_are_whole = match &decl.domain {
        Some(Domain::Range { low, high, .. }) => {
            low.iter().chain(high).all(|limit| is_integer_or_constant(limit, written))
        }
        _ => true,
    };
    is_whole(&decl.default, written) && limits_are_whole
}

/// Returns `true` unless a limit is written as a fraction.
fn is_integer_or_constant(limit: &ast::Expr, written: Written<'_>) -> bool {
    match &limit.kind {
        ExprKind::Number(_) => is_whole(limit, written),
        ExprKind::Unary { operand, .. } => is_integer_or_constant(operand, written),
        ExprKind::Paren(inner) => is_integer_or_constant(inner, written),
        _ => true,
    }
}

/// Returns `true` for an integer without a unit, possibly signed.
fn is_whole(e: &ast::Expr, written: Written<'_>) -> bool {
    match &e.kind {
        ExprKind::Number(value) => value.fract() == 0.0 && !written(e.span).contains('.'),
        ExprKind::Unary { op: UnaryOp::Plus | UnaryOp::Minus, operand } => is_whole(operand, written),
        ExprKind::Paren(inner) => is_whole(inner, written),
        ExprKind::List(all) => !all.is_empty() && all.iter().all(|element| is_whole(element, written)),
        _ => false,
    }
}
