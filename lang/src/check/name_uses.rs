//! Checks names in expressions: variables, params, constants and units.

use super::builtins::Builtin;
use super::dim::Dim;
use super::infer::Checker;
use super::symbols::{Constant, NumberConstant, Resolution, VarKind};
use super::tree::*;
use super::types::Type;
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Base, Dimension};
use crate::ir::Op;
use crate::span::Span;
use crate::units::Unit;

impl Checker<'_> {
    pub(super) fn name(&mut self, name: &ast::Ident, span: Span) -> Expr {
        let res = self.names.uses.get(&name.span).copied().unwrap_or(Resolution::Unknown);
        let (kind, ty) = match res {
            Resolution::Var(id) if self.unrolled.contains_key(&id) => {
                let value = &self.unrolled[&id];
                (value.kind.clone(), value.ty.clone())
            }
            Resolution::Var(id) if self.elements.contains_key(&id) => {
                let id = self.elements[&id];
                (Kind::Var(id), self.variable_type(id))
            }
            Resolution::Var(id) => return self.variable_use(id, span),
            Resolution::Param(id) => self.param_use(id, span),
            Resolution::Output(id) => match self.output_defs.get(&id).copied() {
                Some(def) => return self.use_def(def, span),
                None => match self.output_arrays.get(&id).copied() {
                    Some(variable) => (Kind::Var(variable), self.variable_type(variable)),
                    None => (Kind::Error, Type::Error),
                },
            },
            Resolution::Constant(constant) => return self.constant(constant, span),
            Resolution::Const(id) => return self.const_use(id, span),
            Resolution::OwnUnit(id) => {
                let unit = self.own_unit(id);
                match unit.and_then(|unit| Some((unit.factor, Dimension::from_exponents(unit.dimension)?))) {
                    Some((factor, dimension)) => (Kind::Number(factor), Type::quantity(dimension)),
                    None => (Kind::Error, Type::Error),
                }
            }
            Resolution::Unit(unit) => (Kind::Number(unit.factor), Type::quantity(unit.counted())),
            Resolution::Builtin(_) if Unit::find(&name.name).is_some() => {
                // `min` is a function if it is called, and otherwise the minute.
                let unit = Unit::find(&name.name);
                let (factor, dimension) = unit.map_or((1.0, Dimension::NONE), |u| (u.factor, u.dimension));
                (Kind::Number(factor), Type::quantity(dimension))
            }
            Resolution::Record(_)
            | Resolution::Enum(_)
            | Resolution::Dimension(_)
            | Resolution::Builtin(_)
            | Resolution::Function(_)
            | Resolution::Extern(_)
            | Resolution::Module(_) => {
                let is_component = matches!(res, Resolution::Function(id)
                    if self.names.functions[id.0 as usize].is_component());
                self.report(not_a_value(res, is_component, &name.name, span));
                (Kind::Error, Type::Error)
            }
            Resolution::None => (Kind::None, Type::optional(self.store.fresh())),
            Resolution::Unknown => (Kind::Error, Type::Error),
        };
        self.observed(Expr { kind, ty, span })
    }

    fn variable_use(&mut self, id: VarId, span: Span) -> Expr {
        if let Some(place) = self.constant_place
            && !self.static_parameter(id)
        {
            self.report(
                Diagnostic::error(
                    "E0212",
                    format!("{place} cannot use a variable"),
                    span,
                    "variables have no values when params are set",
                )
                .help("use literals, earlier params, and functions of them"),
            );
            return Expr::error(span);
        }
        if self.variable(id).kind == VarKind::Symbolic && !self.is_of_symbolic_function(id) {
            return self.symbolic_name(id, span);
        }
        let ty = self.variable_type(id);
        self.observed(Expr { kind: Kind::Var(id), ty, span })
    }

    fn param_use(&mut self, id: u32, span: Span) -> (Kind, Type) {
        match self.params.get(id as usize) {
            Some(param) => (Kind::Param(id), param.ty.clone()),
            None => {
                let place = self.constant_place.unwrap_or("this");
                self.report(
                    Diagnostic::error(
                        "E0212",
                        format!("{place} cannot use a param, which is set before the run"),
                        span,
                        "not constant",
                    )
                    .help("use literals, units and constants"),
                );
                (Kind::Error, Type::Error)
            }
        }
    }

    fn constant(&mut self, constant: Constant, span: Span) -> Expr {
        let (kind, ty) = match constant {
            Constant::Bool(value) => (Kind::Bool(value), Type::Bool),
            Constant::Number(NumberConstant::Pi) => (Kind::Number(std::f64::consts::PI), Type::number()),
            Constant::Number(NumberConstant::Infinity) => {
                (Kind::Number(f64::INFINITY), Type::Number(self.store.fresh_dim()))
            }
            Constant::Number(NumberConstant::NotANumber) => {
                (Kind::Number(f64::NAN), Type::Number(self.store.fresh_dim()))
            }
            Constant::Basis(axis) => {
                let components = (0..3)
                    .map(|i| Expr {
                        kind: Kind::Number(f64::from(u8::from(i == axis))),
                        ty: Type::number(),
                        span,
                    })
                    .collect();
                (Kind::Op(Op::Vector, components), Type::Vector(Dim::none()))
            }
            Constant::Time => {
                let ty = Type::quantity(Dimension::of(Base::Time));
                if !self.symbolic {
                    self.report(self.time_as_value(span));
                    return Expr { kind: Kind::Error, ty, span };
                }
                (Kind::Time, ty)
            }
        };
        Expr { kind, ty, span }
    }

    /// Returns a symbol that can be differentiated or replaced: `Time` or a number param.
    pub(super) fn symbol(&mut self, name: &ast::Ident) -> Option<(Sym, Dim)> {
        match self.names.uses.get(&name.span).copied() {
            Some(Resolution::Constant(Constant::Time)) => {
                Some((Sym::Time, Dim::known(Dimension::of(Base::Time))))
            }
            Some(Resolution::Param(id)) => {
                match self.params.get(id as usize).map(|param| self.store.shallow(&param.ty)) {
                    Some(Type::Number(dim)) => Some((Sym::Param(id), dim)),
                    Some(Type::Error) | None => None,
                    Some(_) => {
                        self.bad_symbol(name, "this param is not a number");
                        None
                    }
                }
            }
            Some(Resolution::Var(id)) if self.is_argument(id) => {
                let dim = self.store.fresh_dim();
                let ty = self.variable_type(id);
                if self.store.unify(&ty, &Type::Number(dim.clone())).is_err() {
                    self.bad_symbol(name, "this argument is not a number");
                    return None;
                }
                Some((Sym::Argument(id), dim))
            }
            Some(Resolution::Unknown) | None => None,
            Some(_) => {
                self.bad_symbol(name, "not a symbol");
                None
            }
        }
    }

    fn bad_symbol(&mut self, name: &ast::Ident, label: &str) {
        self.report(
            Diagnostic::error(
                "E0506",
                format!("`{}` is neither `Time` nor a number param", name.name),
                name.span,
                label,
            )
            .help("only `Time`, number params and arguments of the enclosing symbolic function are symbols"),
        );
    }

    /// Returns the built-in function that a name denotes if it is called.
    pub(super) fn builtin(&self, name: &ast::Ident) -> Option<Builtin> {
        match self.names.uses.get(&name.span) {
            Some(Resolution::Builtin(builtin)) => Some(*builtin),
            _ => None,
        }
    }
}

/// Returns the error for a name that is used as a value but denotes something else.
fn not_a_value(meaning: Resolution, is_component: bool, name: &str, span: Span) -> Diagnostic {
    match meaning {
        Resolution::Record(_) => {
            Diagnostic::error("E0306", format!("`{name}` is a record type, not a value"), span, "not a value")
                .help(format!("write `{name}(field = value)`"))
                .suggest(format!("write `{name}()`"), span, format!("{name}()"))
        }
        Resolution::Enum(_) => {
            let message = format!("`{name}` is an enumeration, not a value");
            Diagnostic::error("E0306", message, span, "not a value").help(format!(
                "write a choice of it, `{name}.choice`; a loop goes through all: `for (x in {name})`"
            ))
        }
        Resolution::Dimension(_) => {
            Diagnostic::error("E0306", format!("`{name}` is a dimension"), span, "not a value")
                .help("use dimensions in types and units in values")
        }
        Resolution::Module(_) => {
            Diagnostic::error("E0306", format!("`{name}` is a module"), span, "not a value")
                .help(format!("use one of its names: `{name}.name`"))
        }
        _ if is_component => {
            let message = format!("`{name}` is a component, not a value");
            Diagnostic::error("E0306", message, span, "not an instance")
                .help(format!("declare an instance: `var part = {name}(...);`"))
        }
        _ => Diagnostic::error(
            "E0306",
            format!("`{name}` is a function, and functions are not values"),
            span,
            "not called",
        )
        .help(format!("call it: `{name}(...)`"))
        .suggest(format!("write `{name}()`"), span, format!("{name}()")),
    }
}
