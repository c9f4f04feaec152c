//! Lowers operators on arrays to loops over their elements, and calls of the runtime's functions.

use super::body::Body;
use super::values::{BinaryForm, binary, binary_form, unary};
use crate::ast::{BinaryOp, UnaryOp};
use crate::check::tree::Standard;
use crate::check::types::Type;
use crate::ir::{self, ExprKind, Op, Place, Statement};
use crate::span::Span;
use calyx_abi::{Purity, Repr};

/// Name, parameters and result of a function of the runtime.
pub(super) type Declaration = (&'static str, Vec<(&'static str, Repr)>, Repr);

/// Returns the declaration of a function of the runtime.
pub(super) fn declaration(function: Standard) -> Declaration {
    let numbers = || Repr::Array(Box::new(Repr::Number));
    let n = Repr::Number;
    match function {
        Standard::RangeStart => ("range_start", vec![("start", n.clone())], n),
        Standard::RangeEnd => ("range_end", vec![("end", n.clone())], n),
        Standard::SliceEnd => {
            ("slice_end", vec![("start", n.clone()), ("end", n.clone()), ("length", n.clone())], n)
        }
        Standard::SplineTable => ("spline_table", vec![("xs", numbers()), ("ys", numbers())], n),
        Standard::BodyFrame => {
            ("body_frame", vec![("body", Repr::Handle)], Repr::Symbolic(Box::new(Repr::Transform)))
        }
        Standard::Smallest => ("smallest", vec![("values", numbers())], n),
        Standard::Largest => ("largest", vec![("values", numbers())], n),
        Standard::Sort => ("sorted", vec![("values", numbers())], numbers()),
    }
}

impl Body<'_, '_> {
    /// Returns `true` if values of a type are arrays in this instance.
    pub(super) fn is_array(&self, ty: &Type) -> bool {
        match self.lowering.checker.store.known(ty) {
            Type::Array(_) => true,
            Type::Unknown(_) => matches!(self.repr(ty), Repr::Array(_)),
            _ => false,
        }
    }

    /// Returns the value of a sum without terms.
    pub(super) fn zero(&self, ty: &Type, span: Span) -> ir::Expr {
        let repr = self.repr(ty);
        let number = || ir::Expr { kind: ExprKind::Number(0.0), repr: Repr::Number, span };
        let kind = match &repr {
            Repr::Vector => ExprKind::Op(Op::Vector, vec![number(), number(), number()]),
            Repr::Array(_) => ExprKind::Array(Vec::new()),
            _ => return number(),
        };
        ir::Expr { kind, repr, span }
    }

    /// Applies a sign to a value, or to each element of an array.
    pub(super) fn negated(&mut self, op: UnaryOp, a: ir::Expr, span: Span) -> ir::Expr {
        match &a.repr {
            Repr::Array(_) => {
                let repr = a.repr.clone();
                self.each(&[a], repr, span, |f, parts| f.negated(op, parts[0].clone(), span))
            }
            Repr::Symbolic(_) => self.observable_unary(op, a, span),
            _ => unary(op, a, span),
        }
    }

    /// Applies `+`, `-`, `*` or `/` to two values, or to each element of an array.
    pub(super) fn elementwise(&mut self, op: BinaryOp, a: ir::Expr, b: ir::Expr, span: Span) -> ir::Expr {
        let arrays = [&a.repr, &b.repr].map(|repr| matches!(repr, Repr::Array(_)));
        if arrays == [false, false] {
            let observable = [&a.repr, &b.repr].iter().any(|repr| matches!(repr, Repr::Symbolic(_)));
            return if observable { self.observable_binary(op, a, b, span) } else { binary(op, a, b, span) };
        }
        let repr = result(op, &a.repr, &b.repr);
        let (a, b) = (self.local_value(a), self.local_value(b));
        match arrays {
            [true, true] => {
                let lengths = [&a, &b].map(|array| length(array, span)).to_vec();
                let parameters = [("left", Repr::Number), ("right", Repr::Number)];
                let id = self.lowering.standard("same_length", Purity::Pure, &parameters, Repr::Unit);
                let check = ir::Expr { kind: ExprKind::CallExtern(id, lengths), repr: Repr::Unit, span };
                self.push(Statement::Eval(check));
                self.each(&[a, b], repr, span, |f, parts| {
                    f.elementwise(op, parts[0].clone(), parts[1].clone(), span)
                })
            }
            [true, false] => {
                self.each(&[a], repr, span, |f, parts| f.elementwise(op, parts[0].clone(), b.clone(), span))
            }
            _ => self.each(&[b], repr, span, |f, parts| f.elementwise(op, a.clone(), parts[0].clone(), span)),
        }
    }

    /// Stores a value in a local, unless it is one.
    fn local_value(&mut self, value: ir::Expr) -> ir::Expr {
        if matches!(value.kind, ExprKind::Local(_)) { value } else { self.kept(value) }
    }

    /// Returns a new array with the values of `element` for the elements of arrays of one length.
    fn each(
        &mut self,
        arrays: &[ir::Expr],
        repr: Repr,
        span: Span,
        element: impl FnOnce(&mut Self, &[ir::Expr]) -> ir::Expr,
    ) -> ir::Expr {
        let arrays: Vec<ir::Expr> = arrays.iter().map(|array| self.local_value(array.clone())).collect();
        let make = |kind, repr| ir::Expr { kind, repr, span };
        let number = |value| make(ExprKind::Number(value), Repr::Number);
        let collected = self.temporary(make(ExprKind::Array(Vec::new()), repr.clone()));
        let at = self.temporary(number(0.0));
        let index = || make(ExprKind::Local(at), Repr::Number);
        let (test, inside, after) = (self.new_block(), self.new_block(), self.new_block());
        self.jump(test);
        self.start(test);
        let below = ExprKind::Op(Op::Less, vec![index(), length(&arrays[0], span)]);
        self.branch_on(make(below, Repr::Bool), inside, after);
        self.start(inside);
        let parts = arrays.iter().map(|array| {
            let part = match &array.repr {
                Repr::Array(part) => (**part).clone(),
                other => other.clone(),
            };
            make(ExprKind::Index(Box::new(array.clone()), Box::new(index())), part)
        });
        let parts: Vec<ir::Expr> = parts.collect();
        let value = element(self, &parts);
        self.push(Statement::Push { place: Place::whole(collected, repr.clone()), value, span });
        let next = make(ExprKind::Op(Op::Add, vec![index(), number(1.0)]), Repr::Number);
        self.push(Statement::Assign { place: Place::whole(at, Repr::Number), value: next, span });
        self.jump(test);
        self.start(after);
        make(ExprKind::Local(collected), repr)
    }
}

/// Returns a value of a representation that the program does not use, such as that of an absent
/// optional value.
pub(super) fn absent(repr: &Repr, span: Span) -> ir::Expr {
    let number = || ir::Expr { kind: ExprKind::Number(0.0), repr: Repr::Number, span };
    let vector = || ir::Expr {
        kind: ExprKind::Op(Op::Vector, vec![number(), number(), number()]),
        repr: Repr::Vector,
        span,
    };
    let kind = match repr {
        Repr::Number | Repr::Unit => return number(),
        Repr::Vector => return vector(),
        Repr::Transform => ExprKind::Op(Op::Translate, vec![vector()]),
        Repr::String => ExprKind::String(String::new()),
        Repr::Array(_) => ExprKind::Array(Vec::new()),
        Repr::Tuple(parts) => ExprKind::Tuple(parts.iter().map(|part| absent(part, span)).collect()),
        // A word that is zero.
        Repr::Bool | Repr::Handle | Repr::Symbolic(_) => ExprKind::Bool(false),
    };
    ir::Expr { kind, repr: repr.clone(), span }
}

fn length(array: &ir::Expr, span: Span) -> ir::Expr {
    ir::Expr { kind: ExprKind::Len(Box::new(array.clone())), repr: Repr::Number, span }
}

/// Returns the representation of the result of an operator.
fn result(op: BinaryOp, a: &Repr, b: &Repr) -> Repr {
    let array = |part| Repr::Array(Box::new(part));
    match (a, b) {
        (Repr::Array(a), Repr::Array(b)) => array(result(op, a, b)),
        (Repr::Array(a), b) => array(result(op, a, b)),
        (a, Repr::Array(b)) => array(result(op, a, b)),
        (Repr::Symbolic(_), _) | (_, Repr::Symbolic(_)) => Repr::Symbolic(Box::new(Repr::Number)),
        _ => match binary_form(op, a, b) {
            BinaryForm::Plain(_, repr) | BinaryForm::Swapped(_, repr) => repr,
            BinaryForm::DivideVector => Repr::Vector,
        },
    }
}
