//! Checks `dimension` and `unit` declarations, and units in source text.

use super::constant;
use super::dim::Dim;
use super::infer::Checker;
use super::order::MOST_OPEN;
use super::symbols::{Resolution, with_article};
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind, UnitMeaning};
use crate::common_units::usual;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Dimension, Rational};
use crate::ir::DisplayUnit;
use crate::span::Span;
use crate::units::{Unit, combined, powered, pure};
use crate::vocabulary::OwnBase;
use calyx_abi::description::OWN_BASES;

/// Largest number of units that the message about an unsuitable one proposes.
const FITTING_UNITS: usize = 4;

impl<'a> Checker<'a> {
    /// Computes all declared dimensions and units, including unused ones.
    pub(super) fn declare_vocabulary(&mut self) {
        let bases = self.layout.bases.iter().take(OWN_BASES);
        self.store.vocabulary.bases =
            bases.map(|(_, name)| OwnBase { name: name.clone(), unit: None }).collect();
        let texts = self.names.dimensions.iter().map(|declared| match declared.decl.value {
            Some(value) => value.span,
            None => declared.decl.name.span,
        });
        let of_dimensions = |res| match res {
            Resolution::Dimension(id) => Some(id),
            _ => None,
        };
        for id in self.by_dependence(&texts.collect::<Vec<_>>(), of_dimensions) {
            self.own_dimension(id);
        }
        let texts = self.names.units.iter().map(|declared| match &declared.decl.meaning {
            UnitMeaning::Coherent(dimension) => dimension.span,
            UnitMeaning::Equal(value) => value.span,
        });
        let of_units = |res| match res {
            Resolution::OwnUnit(id) => Some(id),
            _ => None,
        };
        for id in self.by_dependence(&texts.collect::<Vec<_>>(), of_units) {
            self.own_unit(id);
        }
        for id in 0..self.names.dimensions.len() as u32 {
            if let (Some(dimension), Some(_)) =
                (self.own_dimension(id), self.names.dimensions[id as usize].decl.value)
            {
                let name = self.names.dimensions[id as usize].decl.name.name.to_string();
                self.store.vocabulary.named.push((name, dimension));
            }
        }
        for id in 0..self.names.units.len() as u32 {
            if let Some(unit) = self.own_unit(id) {
                self.store.vocabulary.units.push(unit);
            }
        }
    }

    /// Returns the `id`-th declared dimension.
    pub(super) fn own_dimension(&mut self, id: u32) -> Option<Dimension> {
        let (decl, file) = {
            let declared = &self.names.dimensions[id as usize];
            (declared.decl, declared.file)
        };
        if let Some(known) = self.own_dimensions.get(&id).copied() {
            if known.is_none() && self.opening.contains(&Resolution::Dimension(id)) {
                self.made_of_itself("dimension", decl.name);
            }
            return known;
        }
        if self.opening.len() >= MOST_OPEN {
            self.made_of_itself("dimension", decl.name);
            return None;
        }
        self.own_dimensions.insert(id, None);
        self.opening.push(Resolution::Dimension(id));
        let found = match decl.value {
            Some(value) => self.in_file(file, |c| match c.annotation(value, false) {
                Type::Number(dim) => dim.as_known(),
                Type::Error => None,
                _ => {
                    c.report(
                        Diagnostic::error("E0308", "a dimension is expected", value.span, "not a dimension")
                            .help("write a product of powers of dimensions, such as `Force/Length`"),
                    );
                    None
                }
            }),
            None => {
                let module = self.modules.iter().find(|module| module.file == file);
                let module = module.map_or("", |module| module.name.as_str());
                let mut bases = self.layout.bases.iter();
                let at = bases.position(|(of, name)| of == module && *name == decl.name.name);
                let found = at.and_then(Dimension::own);
                if found.is_none() {
                    self.report(
                        Diagnostic::error(
                            "E0405",
                            format!("a program declares at most {OWN_BASES} base dimensions"),
                            decl.name.span,
                            "exceeds the limit",
                        )
                        .help("derive it from others: `dimension Name = Length/Time;`"),
                    );
                }
                found
            }
        };
        if Dimension::from_name(&decl.name.name).is_some() {
            self.taken("dimension", decl.name);
        }
        self.opening.pop();
        self.own_dimensions.insert(id, found);
        found
    }

    /// Returns the `id`-th declared unit.
    pub(super) fn own_unit(&mut self, id: u32) -> Option<DisplayUnit> {
        let (decl, file) = {
            let declared = &self.names.units[id as usize];
            (declared.decl, declared.file)
        };
        if let Some(known) = self.own_units.get(&id).cloned() {
            if known.is_none() && self.opening.contains(&Resolution::OwnUnit(id)) {
                self.made_of_itself("unit", &decl.name);
            }
            return known;
        }
        if self.opening.len() >= MOST_OPEN {
            self.made_of_itself("unit", &decl.name);
            return None;
        }
        self.own_units.insert(id, None);
        self.opening.push(Resolution::OwnUnit(id));
        if Unit::find(&decl.name.name).is_some() {
            self.taken("unit", &decl.name);
        }
        let found = match &decl.meaning {
            UnitMeaning::Coherent(dimension) => {
                let ty = self.in_file(file, |c| c.annotation(dimension, false));
                self.coherent_unit(&ty, &decl.name, dimension.span)
            }
            UnitMeaning::Equal(value) => self.in_file(file, |c| c.derived_unit(value)),
        };
        let name = decl.name.name.to_string();
        let found =
            found.map(|(dimension, factor)| DisplayUnit { name, factor, dimension: dimension.exponents() });
        self.opening.pop();
        self.own_units.insert(id, found.clone());
        found
    }

    /// Checks `unit euro: Cost;`.
    fn coherent_unit(&mut self, ty: &Type, name: &ast::Ident, span: Span) -> Option<(Dimension, f64)> {
        let Type::Number(dim) = ty else { return None };
        let dimension = dim.as_known()?;
        let base = (0..self.store.vocabulary.bases.len()).find(|&at| Dimension::own(at) == Some(dimension));
        let Some(base) = base else {
            let shown = self.store.vocabulary.show(dimension);
            let example = self.store.vocabulary.unit_of(self.shown_system(), dimension).name;
            self.report(
                Diagnostic::error(
                    "E0406",
                    format!("{shown} already has units"),
                    span,
                    "not a new base dimension",
                )
                .help(format!("define its size: `unit {} = 2 {example};`", name.name)),
            );
            return None;
        };
        let first = self.store.vocabulary.bases[base].unit.clone();
        if let Some(first) = first {
            let message =
                format!("{} already has the unit `{first}`", self.store.vocabulary.bases[base].name);
            self.report(
                Diagnostic::error("E0406", message, span, "a second unit of size 1")
                    .help(format!("define its size: `unit {} = 0.01 {first};`", name.name)),
            );
            return None;
        }
        self.store.vocabulary.bases[base].unit = Some(name.name.to_string());
        Some((dimension, 1.0))
    }

    /// Checks `unit furlong = 220 yard;`.
    fn derived_unit(&mut self, value: &'a ast::Expr) -> Option<(Dimension, f64)> {
        let place = self.constant_place.replace("a unit");
        let value = self.as_value(|c| c.expr(value));
        self.constant_place = place;
        let dimension = match self.store.resolve(&value.ty) {
            Type::Error => return None,
            Type::Number(dim) => dim.as_known(),
            _ => None,
        };
        let factor = constant::number(&value, &self.store).filter(|x| *x > 0.0 && x.is_finite());
        let found = dimension.zip(factor);
        if found.is_none() {
            self.report(
                Diagnostic::error(
                    "E0406",
                    "the size of a unit must be a positive constant",
                    value.span,
                    "not a constant quantity",
                )
                .help("write a number with a unit, such as `220 yard`"),
            );
        }
        found
    }

    fn taken(&mut self, kind: &str, name: &ast::Ident) {
        let message = format!("`{}` is a built-in {kind}", name.name);
        self.report(
            Diagnostic::error("E0202", message, name.span, "declared again here").help("choose another name"),
        );
    }

    fn made_of_itself(&mut self, kind: &str, name: &ast::Ident) {
        let message = format!("the {kind} `{}` depends on itself", name.name);
        self.report(
            Diagnostic::error("E0407", message, name.span, "circular definition")
                .help("define it by other units and dimensions"),
        );
    }

    /// Returns the unit that an identifier denotes after a number or in a format.
    pub(super) fn unit_named(&mut self, name: &ast::Ident) -> Option<DisplayUnit> {
        match self.names.uses.get(&name.span).copied() {
            Some(Resolution::OwnUnit(id)) => self.own_unit(id),
            // A variable may have the name of a unit.
            Some(
                Resolution::Var(_)
                | Resolution::Param(_)
                | Resolution::Const(_)
                | Resolution::Output(_)
                | Resolution::Unknown,
            ) => None,
            _ => Unit::find(&name.name).map(|unit| DisplayUnit {
                name: name.name.to_string(),
                factor: unit.factor,
                dimension: unit.dimension.exponents(),
            }),
        }
    }

    /// Returns the unit of an expression of literals: `lbf*inch` for `1000 lbf*inch`, `1/inch` for
    /// `10 / inch`.
    pub(super) fn written_unit(&mut self, e: &ast::Expr) -> Option<DisplayUnit> {
        match &e.kind {
            ExprKind::Number(_) => Some(pure()),
            ExprKind::Quantity { unit, exponent, .. } | ExprKind::Measured { unit, exponent, .. } => {
                let unit = self.unit_named(unit)?;
                powered(&unit, *exponent)
            }
            ExprKind::List(elements) => self.written_unit(elements.first()?),
            ExprKind::Name(name) => self.unit_named(name),
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => self.written_unit(inner),
            ExprKind::Binary { op: BinaryOp::Power, left, right, .. } => {
                let exponent = whole_exponent(right)?;
                let unit = self.written_unit(left)?;
                powered(&unit, exponent)
            }
            ExprKind::Binary { op: op @ (BinaryOp::Multiply | BinaryOp::Divide), left, right, .. } => {
                let (left, right) = (self.written_unit(left)?, self.written_unit(right)?);
                combined(&left, &right, *op == BinaryOp::Multiply)
            }
            _ => None,
        }
    }

    /// Returns the unit in a format, which must be a product of units.
    pub(super) fn format_unit(&mut self, e: &'a ast::Expr) -> Option<(DisplayUnit, Dimension)> {
        self.stated_unit(e, |span| {
            Diagnostic::error("E0408", "a format must end with a unit", span, "not a product of units")
                .help("write units joined by `*` and `/`: `{x : .3 lbf/inch^2}`")
        })
    }

    /// Returns the unit that stands alone, and its dimension including cycles; reports `otherwise`
    /// if it is not a product of units.
    fn stated_unit(
        &mut self,
        e: &'a ast::Expr,
        otherwise: impl Fn(Span) -> Diagnostic,
    ) -> Option<(DisplayUnit, Dimension)> {
        let mut sound = true;
        let message = otherwise(e.span).message;
        self.check_unit_names(e, &message, &mut sound);
        let unit = if sound { self.written_unit(e).filter(|_| is_unit_product(e)) } else { return None };
        let Some(unit) = unit else {
            self.report(otherwise(e.span));
            return None;
        };
        let dimension = match self.counted_unit(e) {
            Some(counted) => counted,
            None => Dimension::from_exponents(unit.dimension)?,
        };
        Some((unit, dimension))
    }

    /// Returns the unit after `in` of an output of a type, which must have its dimension.
    pub(super) fn output_unit(&mut self, ty: &Type, value: Span, e: &'a ast::Expr) -> Option<DisplayUnit> {
        let (unit, dimension) = self.stated_unit(e, |span| {
            Diagnostic::error("E0925", "after `in` an output states a unit", span, "not a product of units")
                .help("write units joined by `*` and `/`, as in `in N*m`, or an enumeration; a range belongs to a param")
        })?;
        let dim = match self.store.shallow(ty) {
            Type::Number(dim) | Type::Observable(dim) => dim,
            _ => return None,
        };
        let known = self.store.dim(&dim).as_known();
        let without_turn = known.is_some_and(|known| known.lacks_turn(dimension));
        if !without_turn && self.store.unify_dims(&dim, &Dim::known(dimension)).is_ok() {
            return Some(unit);
        }
        let found = with_article(&self.store.show_dim(&dim));
        let stated = with_article(&self.store.vocabulary.show(dimension));
        let message = match without_turn {
            true => "a rate in `1/s` cannot be shown in revolutions or cycles".to_owned(),
            false => format!("this output is {found} and cannot be shown in a unit of {stated}"),
        };
        let mut problem = Diagnostic::error("E0926", message, e.span, format!("a unit of {stated}"))
            .label(value, format!("this is {found}"))
            .help("use a unit of its dimension, or omit `in` and the unit");
        let system = self.system().unwrap_or_default();
        for fitting in known.iter().flat_map(|known| usual(*known, system)).take(FITTING_UNITS) {
            problem = problem.suggest(format!("show it in `{}`", fitting.name), e.span, fitting.name);
        }
        self.report(problem);
        None
    }

    /// Returns the dimension of a product of units, including cycles.
    fn counted_unit(&mut self, e: &ast::Expr) -> Option<Dimension> {
        match &e.kind {
            ExprKind::Name(name) => match self.names.uses.get(&name.span).copied() {
                Some(Resolution::Unit(unit)) => Some(unit.counted()),
                _ => Dimension::from_exponents(self.unit_named(name)?.dimension),
            },
            ExprKind::Paren(inner) => self.counted_unit(inner),
            ExprKind::Binary { op: BinaryOp::Power, left, right, .. } => {
                let exponent = whole_exponent(right)?;
                self.counted_unit(left)?.power(Rational::integer(exponent))
            }
            ExprKind::Binary { op: op @ (BinaryOp::Multiply | BinaryOp::Divide), left, right, .. } => {
                let (left, right) = (self.counted_unit(left)?, self.counted_unit(right)?);
                Some(if *op == BinaryOp::Multiply { left.times(right) } else { left.over(right) })
            }
            _ => None,
        }
    }

    fn check_unit_names(&mut self, e: &ast::Expr, message: &str, sound: &mut bool) {
        match &e.kind {
            ExprKind::Name(name) if self.names.uses.get(&name.span) == Some(&Resolution::Unknown) => {
                *sound = false;
                self.unknown_unit(name, message);
            }
            ExprKind::Binary { left, right, .. } => {
                self.check_unit_names(left, message, sound);
                self.check_unit_names(right, message, sound);
            }
            ExprKind::Paren(inner) => self.check_unit_names(inner, message, sound),
            ExprKind::Error => *sound = false,
            _ => {}
        }
    }
}

/// Returns whether an expression consists of names, products, quotients and powers, and of the 1 of
/// `1/mm`.
fn is_unit_product(e: &ast::Expr) -> bool {
    match &e.kind {
        ExprKind::Name(_) => true,
        ExprKind::Number(value) => *value == 1.0,
        ExprKind::Paren(inner) => is_unit_product(inner),
        ExprKind::Binary { op: BinaryOp::Power, left, .. } => is_unit_product(left),
        ExprKind::Binary { left, right, .. } => is_unit_product(left) && is_unit_product(right),
        _ => false,
    }
}

/// Returns the value of an integer exponent of a unit, possibly negative.
fn whole_exponent(e: &ast::Expr) -> Option<i32> {
    match &e.kind {
        ExprKind::Number(value) if value.fract() == 0.0 && value.abs() < 100.0 => Some(*value as i32),
        ExprKind::Unary { op: ast::UnaryOp::Minus, operand } => whole_exponent(operand).map(|value| -value),
        ExprKind::Paren(inner) => whole_exponent(inner),
        _ => None,
    }
}
