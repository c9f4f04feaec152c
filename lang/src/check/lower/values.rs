//! Lowers expressions that are evaluated.

use super::body::Body;
use super::elementwise::{absent, declaration};
use super::record_texts::{as_numbers, has_text};
use crate::ast::{BinaryOp, UnaryOp};
use crate::check::expr::component;
use crate::check::tree::{DefId, Expr, Kind, PassedFunction, Standard, Stmt, Style, TextPart};
use crate::check::types::Type;
use crate::dimension::Dimension;
use crate::ir::{self, DisplayUnit, ExprKind, FormatPart, Op};
use crate::span::Span;
use crate::units::UnitSystem;
use calyx_abi::display::{Display, NumberStyle};
use calyx_abi::units::to_si;
use calyx_abi::{Purity, Repr};

impl Body<'_, '_> {
    /// Lowers a value to be bound, passed or stored; copies an array that a place still refers to.
    pub(super) fn owned(&mut self, e: &Expr) -> ir::Expr {
        let value = self.value(e);
        own(value)
    }

    pub(super) fn value(&mut self, e: &Expr) -> ir::Expr {
        let span = e.span;
        let make = |kind, repr| ir::Expr { kind, repr, span };
        match &e.kind {
            // Unreachable: programs with errors are not lowered, and assertions are statements.
            Kind::Error
            | Kind::Time
            | Kind::Derivative(..)
            | Kind::Gradient(..)
            | Kind::At(..)
            | Kind::SymbolicCall(_)
            | Kind::Block(..)
            | Kind::Part(_)
            | Kind::Spline(_)
            | Kind::Assert(_) => make(ExprKind::Number(f64::NAN), self.repr(&e.ty)),
            Kind::Function(PassedFunction::Declared(..), captured) => {
                let values = self.owned_values(captured, span);
                let repr = Repr::Tuple(values.iter().map(|value| value.repr.clone()).collect());
                make(ExprKind::Tuple(values), repr)
            }
            Kind::Function(PassedFunction::Parameter(id), environment) => match environment.first() {
                Some(environment) => self.value(environment),
                None => {
                    let local = self.local(*id);
                    make(ExprKind::Local(local), self.local_repr(local))
                }
            },
            Kind::Applied(applied) => self.applied_value(applied, &e.ty, span),
            _ if self.is_observable_operation(e) => self.observable_operation(e),
            Kind::Number(value) => make(ExprKind::Number(*value), Repr::Number),
            Kind::Bare(value, dim, system) => {
                make(ExprKind::Number(to_si(*value, self.bare_factor(dim, *system))), Repr::Number)
            }
            Kind::Bool(value) => make(ExprKind::Bool(*value), Repr::Bool),
            Kind::Text(text) => make(ExprKind::String(text.clone()), Repr::String),
            Kind::Var(id) if self.is_constant && self.lowering.static_argument(*id).is_some() => {
                let argument = self.lowering.static_argument(*id).unwrap_or_default();
                make(ExprKind::Call(argument, Vec::new()), self.repr(&e.ty))
            }
            Kind::Var(id) | Kind::Chosen(id) => {
                let local = self.local(*id);
                make(ExprKind::Local(local), self.local_repr(local))
            }
            Kind::Param(id) => {
                let number = self.lowering.param_number(*id);
                make(ExprKind::Param(number), self.repr(&e.ty))
            }
            Kind::Def(def) | Kind::MakeSymbolic(def) => self.make_symbolic(*def, span),
            Kind::Eval(def, time) => self.evaluation(*def, time.as_deref(), &e.ty, span),
            Kind::Observe(inner) => self.value(inner),
            Kind::Updated(_) => match &self.updated {
                Some(present) => present.clone(),
                // Unreachable: the value occurs in an `Update` only.
                None => make(ExprKind::Number(f64::NAN), self.repr(&e.ty)),
            },
            Kind::Zero => self.zero(&e.ty, span),
            Kind::None => {
                let repr = self.repr(&e.ty);
                absent(&repr, span)
            }
            Kind::Some(value) => self.present_value(value, span),
            Kind::IsNone(value) => self.absence(value, span),
            Kind::Sequence(statements, value) => self.sequence_value(statements, value),
            Kind::Standard(function, all) => {
                let all = self.values(all, span);
                self.standard_call(*function, all, span)
            }
            Kind::Unary(op, a) => {
                let a = self.value(a);
                self.negated(*op, a, span)
            }
            Kind::Binary(op, a, b) => self.binary_value(e, *op, a, b),
            Kind::Op(op, all) => {
                let all = self.values(all, span);
                let repr = self.repr(&e.ty);
                make(ExprKind::Op(*op, all), repr)
            }
            Kind::If(condition, a, b) => self.conditional(condition, a, b, &e.ty, span),
            Kind::Call(call) => self.call_value(call, &e.ty, span),
            Kind::CallExtern(id, all, demands) => {
                let all = self.extern_arguments(all, demands, span);
                let (id, repr) = self.lowering.extern_id(*id);
                make(ExprKind::CallExtern(id, all), repr)
            }
            Kind::Print(values, system) => self.print(values, *system, span),
            Kind::Array(all) => {
                let all = self.owned_values(all, span);
                make(ExprKind::Array(all), self.repr(&e.ty))
            }
            Kind::Tuple(all) => {
                let all = self.owned_values(all, span);
                let repr = Repr::Tuple(all.iter().map(|a| a.repr.clone()).collect());
                make(ExprKind::Tuple(all), repr)
            }
            Kind::Index(base, index) => self.array_element(base, index, &e.ty, span),
            Kind::TupleElement(base, at) => self.tuple_element(base, *at, &e.ty, span),
            Kind::Field(base, name) => self.field_value(base, name, span),
            Kind::UnitAxis(axis) => {
                let axis = self.value(axis);
                let id = self.lowering.unit_axis();
                make(ExprKind::CallExtern(id, vec![axis]), Repr::Vector)
            }
            Kind::Len(array) => {
                let array = self.value(array);
                make(ExprKind::Len(Box::new(array)), Repr::Number)
            }
            Kind::Format(pieces, system) => self.formatted(pieces, *system, span),
        }
    }

    /// Lowers statements, and the value after them.
    fn sequence_value(&mut self, statements: &[Stmt], value: &Expr) -> ir::Expr {
        let around = self.span;
        statements.iter().for_each(|s| self.statement(s));
        self.span = around;
        self.value(value)
    }

    /// Lowers an optional value that is present.
    fn present_value(&mut self, value: &Expr, span: Span) -> ir::Expr {
        let value = self.owned(value);
        let repr = Repr::Tuple(vec![Repr::Bool, value.repr.clone()]);
        let present = ir::Expr { kind: ExprKind::Bool(true), repr: Repr::Bool, span };
        ir::Expr { kind: ExprKind::Tuple(vec![present, value]), repr, span }
    }

    /// Lowers the test that an optional value is absent.
    fn absence(&mut self, value: &Expr, span: Span) -> ir::Expr {
        let make = |kind| ir::Expr { kind, repr: Repr::Bool, span };
        let value = self.value(value);
        let present = make(ExprKind::TupleElement(Box::new(value), 0));
        make(ExprKind::Op(Op::Not, vec![present]))
    }

    fn standard_call(&mut self, function: Standard, arguments: Vec<ir::Expr>, span: Span) -> ir::Expr {
        let (name, parameters, result) = declaration(function);
        let id = self.lowering.standard(name, Purity::Pure, &parameters, result.clone());
        ir::Expr { kind: ExprKind::CallExtern(id, arguments), repr: result, span }
    }

    fn array_element(&mut self, base: &Expr, index: &Expr, ty: &Type, span: Span) -> ir::Expr {
        let (base, index) = self.pair(base, index);
        let repr = match &base.repr {
            Repr::Array(element) => (**element).clone(),
            _ => self.repr(ty),
        };
        ir::Expr { kind: ExprKind::Index(Box::new(base), Box::new(index)), repr, span }
    }

    /// Lowers a record or tuple of which a part of the type `ty` is used.
    fn whole_of(&mut self, base: &Expr, ty: &Type) -> ir::Expr {
        match &base.kind {
            Kind::Eval(def, time) if !has_text(&self.repr(ty)) => {
                let repr = as_numbers(&self.repr(&base.ty));
                self.evaluated_numbers(*def, time.as_deref(), repr, base.span)
            }
            _ => self.value(base),
        }
    }

    fn tuple_element(&mut self, base: &Expr, at: usize, ty: &Type, span: Span) -> ir::Expr {
        let base = self.whole_of(base, ty);
        let repr = match &base.repr {
            Repr::Tuple(parts) => parts.get(at).cloned().unwrap_or(Repr::Number),
            _ => self.repr(ty),
        };
        ir::Expr { kind: ExprKind::TupleElement(Box::new(base), at), repr, span }
    }

    /// Lowers the evaluation of a definition at a time, by default 0.
    fn evaluation(&mut self, def: DefId, time: Option<&Expr>, ty: &Type, span: Span) -> ir::Expr {
        let repr = self.repr(ty);
        let numbers = self.evaluated_numbers(def, time, as_numbers(&repr), span);
        if has_text(&repr) { self.with_texts(def, numbers, repr) } else { numbers }
    }

    /// Lowers the evaluation of a definition; its texts are not evaluated.
    fn evaluated_numbers(&mut self, def: DefId, time: Option<&Expr>, repr: Repr, span: Span) -> ir::Expr {
        let make = |kind, repr| ir::Expr { kind, repr, span };
        let checker = self.lowering.checker;
        for (argument, demand) in &checker.defs[def.0 as usize].checks {
            let written = &checker.defs[argument.0 as usize].expr;
            if !demand.is_decided(written, &checker.store) {
                let value = self.evaluation(*argument, None, &written.ty, written.span);
                let value = self.kept(value);
                self.demand_of_any(demand, value, written);
            }
        }
        let mut value = self.make_symbolic(def, span);
        let time = match time {
            Some(time) => {
                if self.needs_statements(time) {
                    value = self.kept(value);
                }
                self.value(time)
            }
            None => make(ExprKind::Number(0.0), Repr::Number),
        };
        make(ExprKind::EvalSymbolic { value: Box::new(value), time: Box::new(time) }, repr)
    }

    /// Lowers the binary operator of `e`. The second operand of `&` and `|` is evaluated only if
    /// needed.
    fn binary_value(&mut self, e: &Expr, op: BinaryOp, a: &Expr, b: &Expr) -> ir::Expr {
        let span = e.span;
        let make = |kind, repr| ir::Expr { kind, repr, span };
        match op {
            BinaryOp::And if self.needs_statements(b) => {
                let a = self.value(a);
                self.choose(a, Repr::Bool, span, |f| f.value(b), |_| make(ExprKind::Bool(false), Repr::Bool))
            }
            BinaryOp::Or if self.needs_statements(b) => {
                let a = self.value(a);
                self.choose(a, Repr::Bool, span, |_| make(ExprKind::Bool(true), Repr::Bool), |f| f.value(b))
            }
            BinaryOp::And => {
                let (a, b) = (self.value(a), self.value(b));
                make(ExprKind::And(Box::new(a), Box::new(b)), Repr::Bool)
            }
            BinaryOp::Or => {
                let (a, b) = (self.value(a), self.value(b));
                make(ExprKind::Or(Box::new(a), Box::new(b)), Repr::Bool)
            }
            _ => {
                let (mut a, b) = self.pair(a, b);
                if self.exchanged(e) {
                    a = self.kept(a);
                }
                match op {
                    BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply | BinaryOp::Divide => {
                        self.elementwise(op, a, b, span)
                    }
                    _ => binary(op, a, b, span),
                }
            }
        }
    }

    fn conditional(&mut self, condition: &Expr, a: &Expr, b: &Expr, ty: &Type, span: Span) -> ir::Expr {
        if self.needs_statements(a) || self.needs_statements(b) {
            let condition = self.value(condition);
            let repr = self.repr(ty);
            return self.choose(condition, repr, span, |f| f.value(a), |f| f.value(b));
        }
        let (condition, a, b) = (self.value(condition), self.value(a), self.value(b));
        let repr = a.repr.clone();
        ir::Expr { kind: ExprKind::If(Box::new(condition), Box::new(a), Box::new(b)), repr, span }
    }

    /// Lowers the call of `print`, which separates the values by spaces.
    fn print(&mut self, values: &[Expr], system: UnitSystem, span: Span) -> ir::Expr {
        let make = |kind, repr| ir::Expr { kind, repr, span };
        let mut parts = Vec::new();
        let last = values.iter().rposition(|value| self.needs_statements(value));
        for (index, value) in values.iter().enumerate() {
            if index > 0 {
                parts.push(FormatPart::Text(" ".into()));
            }
            let kept = last.is_some_and(|last| index < last);
            self.format_part(value, None, system, kept, &mut parts);
        }
        let line = make(ExprKind::Format(parts), Repr::String);
        let id = self.lowering.standard("print", Purity::Scene, &[("line", Repr::String)], Repr::Unit);
        make(ExprKind::CallExtern(id, vec![line]), Repr::Unit)
    }

    /// Lowers a string that contains values.
    fn formatted(&mut self, pieces: &[TextPart], system: UnitSystem, span: Span) -> ir::Expr {
        let mut parts = Vec::new();
        let last = pieces
            .iter()
            .rposition(|piece| matches!(piece, TextPart::Value(value, _) if self.needs_statements(value)));
        for (index, piece) in pieces.iter().enumerate() {
            match piece {
                TextPart::Text(text) => parts.push(FormatPart::Text(text.clone())),
                TextPart::Value(value, style) => {
                    let kept = last.is_some_and(|last| index < last);
                    self.format_part(value, style.as_ref(), system, kept, &mut parts);
                }
            }
        }
        ir::Expr { kind: ExprKind::Format(parts), repr: Repr::String, span }
    }

    /// Lowers `base.name`: a field of a record or a component of a vector.
    fn field_value(&mut self, base: &Expr, name: &str, span: Span) -> ir::Expr {
        let make = |kind, repr| ir::Expr { kind, repr, span };
        let field = self.field_of(&base.ty, name);
        let base = match &field {
            Some((_, part)) => self.whole_of(base, part),
            None => self.value(base),
        };
        match (field, component(name)) {
            (Some((at, part)), _) => make(ExprKind::TupleElement(Box::new(base), at), self.repr(&part)),
            (None, Some(op)) => make(ExprKind::Op(op, vec![base]), Repr::Number),
            // Unreachable: the checker guarantees that the field exists.
            (None, None) => make(ExprKind::Number(f64::NAN), Repr::Number),
        }
    }

    /// Adds a value to a format; `kept` evaluates the value immediately.
    pub(super) fn format_part(
        &mut self,
        value: &Expr,
        style: Option<&Style>,
        system: UnitSystem,
        kept: bool,
        parts: &mut Vec<FormatPart>,
    ) {
        if let (Kind::Text(text), None) = (&value.kind, style) {
            return parts.push(FormatPart::Text(text.clone()));
        }
        let display = self.display(&value.ty, style, self.lowering.declared_system.unwrap_or(system));
        let value = self.value(value);
        let value = if kept { self.kept(value) } else { value };
        parts.push(FormatPart::Value(value, display));
    }

    /// Returns the display of values of a type in the units of a system.
    pub(super) fn display(&self, ty: &Type, style: Option<&Style>, system: UnitSystem) -> Display {
        let store = &self.lowering.checker.store;
        let number = |unit: Option<DisplayUnit>| {
            let unit = style.and_then(|style| style.unit.clone()).or(unit);
            let mut shown =
                unit.map_or_else(NumberStyle::default, |unit| NumberStyle::in_unit(unit.factor, unit.name));
            if let Some(style) = style {
                shown.width = style.width.unwrap_or(0);
                shown.digits = style.digits;
                shown.scientific = style.scientific;
            }
            Display::Number(shown)
        };
        let text = || match style.and_then(|style| style.width) {
            Some(width) => Display::Text { width },
            None => Display::Plain,
        };
        match store.shallow(&self.types.ty(store, ty)) {
            Type::Number(dim) | Type::Vector(dim) => {
                let dim = store.dim(&dim);
                let dimension: Dimension = dim.as_known().unwrap_or(dim.fixed);
                number((!dimension.is_none()).then(|| store.vocabulary.unit_of(system, dimension)))
            }
            Type::Transform => {
                let length = Dimension::of(crate::dimension::Base::Length);
                number(Some(system.unit_of(length)))
            }
            Type::Array(element) => Display::Array(Box::new(self.display(&element, style, system))),
            Type::Optional(value) => Display::Optional(Box::new(self.display(&value, style, system))),
            Type::Tuple(parts) => {
                Display::Tuple(parts.iter().map(|part| self.display(part, style, system)).collect())
            }
            Type::Record(id) => {
                let Some(record) = store.record(id) else { return Display::Plain };
                let field = |(name, ty): &(String, Type)| (name.clone(), self.display(ty, style, system));
                Display::Record(record.name.clone(), record.fields.iter().map(field).collect())
            }
            Type::Bool | Type::String | Type::Enum(_) => text(),
            _ => Display::Plain,
        }
    }

    /// Returns the index and the type of a record's field in this instance.
    pub(super) fn field_of(&self, record: &Type, name: &str) -> Option<(usize, Type)> {
        let store = &self.lowering.checker.store;
        match store.shallow(&self.types.ty(store, record)) {
            Type::Record(id) => store.field(id, name),
            _ => None,
        }
    }

    pub(super) fn bare_factor(&self, dim: &crate::check::dim::Dim, system: UnitSystem) -> f64 {
        let dim = self.lowering.checker.store.dim(dim);
        system.unit_of(dim.as_known().unwrap_or(dim.fixed)).factor
    }
}

/// Copies a value that a place still refers to, if it contains an array.
pub(super) fn own_value(value: ir::Expr) -> ir::Expr {
    own(value)
}

fn own(value: ir::Expr) -> ir::Expr {
    if !contains_array(&value.repr) {
        return value;
    }
    match value.kind {
        ExprKind::Local(_) | ExprKind::Param(_) | ExprKind::Index(..) | ExprKind::TupleElement(..) => {
            let (repr, span) = (value.repr.clone(), value.span);
            ir::Expr { kind: ExprKind::Copy(Box::new(value)), repr, span }
        }
        ExprKind::If(condition, a, b) => {
            ir::Expr { kind: ExprKind::If(condition, Box::new(own(*a)), Box::new(own(*b))), ..value }
        }
        _ => value,
    }
}

fn contains_array(repr: &Repr) -> bool {
    match repr {
        Repr::Array(_) => true,
        Repr::Tuple(parts) => parts.iter().any(contains_array),
        _ => false,
    }
}

/// Returns the operation of a unary operator on operands of a representation.
pub(super) fn unary_op(op: UnaryOp, repr: &Repr) -> Option<Op> {
    match (op, repr) {
        (UnaryOp::Plus, _) => None,
        (UnaryOp::Minus, Repr::Vector) => Some(Op::NegateVector),
        (UnaryOp::Minus, _) => Some(Op::Negate),
        (UnaryOp::Not, _) => Some(Op::Not),
    }
}

/// The lowered form of a binary operator.
pub(super) enum BinaryForm {
    Plain(Op, Repr),
    /// The operation with exchanged operands.
    Swapped(Op, Repr),
    /// A vector divided by a number: a product with the reciprocal.
    DivideVector,
}

pub(super) fn binary_form(op: BinaryOp, left: &Repr, right: &Repr) -> BinaryForm {
    use BinaryForm::{Plain, Swapped};
    use Repr::{Bool, Number, Transform, Vector};
    match (op, left, right) {
        (BinaryOp::Add, Vector, _) => Plain(Op::AddVector, Vector),
        (BinaryOp::Add, ..) => Plain(Op::Add, Number),
        (BinaryOp::Subtract, Vector, _) => Plain(Op::SubtractVector, Vector),
        (BinaryOp::Subtract, ..) => Plain(Op::Subtract, Number),
        (BinaryOp::Multiply, Transform, Transform) => Plain(Op::Compose, Transform),
        (BinaryOp::Multiply, Transform, _) => Plain(Op::Apply, Vector),
        (BinaryOp::Multiply, Vector, _) => Swapped(Op::Scale, Vector),
        (BinaryOp::Multiply, _, Vector) => Plain(Op::Scale, Vector),
        (BinaryOp::Multiply, ..) => Plain(Op::Multiply, Number),
        (BinaryOp::Divide, Vector, _) => BinaryForm::DivideVector,
        (BinaryOp::Divide, ..) => Plain(Op::Divide, Number),
        (BinaryOp::Power, ..) => Plain(Op::Power, Number),
        (BinaryOp::Less, ..) => Plain(Op::Less, Bool),
        (BinaryOp::LessEqual, ..) => Plain(Op::LessEqual, Bool),
        (BinaryOp::Greater, ..) => Plain(Op::Greater, Bool),
        (BinaryOp::GreaterEqual, ..) => Plain(Op::GreaterEqual, Bool),
        (BinaryOp::Equal, ..) => Plain(Op::Equal, Bool),
        (BinaryOp::NotEqual, ..) => Plain(Op::NotEqual, Bool),
        // Handled separately, because the second operand is evaluated only if needed.
        (BinaryOp::And | BinaryOp::Or, ..) => Plain(Op::Equal, Bool),
    }
}

pub(super) fn unary(op: UnaryOp, a: ir::Expr, span: Span) -> ir::Expr {
    match unary_op(op, &a.repr) {
        None => a,
        Some(op) => {
            let repr = a.repr.clone();
            ir::Expr { kind: ExprKind::Op(op, vec![a]), repr, span }
        }
    }
}

pub(super) fn binary(op: BinaryOp, a: ir::Expr, b: ir::Expr, span: Span) -> ir::Expr {
    let make = |op, all, repr| ir::Expr { kind: ExprKind::Op(op, all), repr, span };
    match binary_form(op, &a.repr, &b.repr) {
        BinaryForm::Plain(op, repr) => make(op, vec![a, b], repr),
        // Evaluation has no side effects here, so the order of the operands does not matter.
        BinaryForm::Swapped(op, repr) => make(op, vec![b, a], repr),
        BinaryForm::DivideVector => {
            let one = ir::Expr { kind: ExprKind::Number(1.0), repr: Repr::Number, span };
            let reciprocal = make(Op::Divide, vec![one, b], Repr::Number);
            make(Op::Scale, vec![reciprocal, a], Repr::Vector)
        }
    }
}
