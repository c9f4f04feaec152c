//! Operations on vectors and transforms, expanded into scalar operations, and comparisons with
//! texts. The interpreter and the code generator share these definitions.
//!
//! The order of additions is part of the definition, so that both produce the same bits.

use calyx_lang::ir::{Expr, ExprKind, Op};

/// A backend for scalar operations: on numbers, or on values of machine code.
pub trait Scalars {
    /// A number or a truth value.
    type Value: Copy;
    fn number(&mut self, value: f64) -> Self::Value;
    /// Applies one of the operations for which [`is_scalar`] returns `true`. Returns `None` for
    /// other operations or if operands are missing. The operands of `Equal` and `NotEqual` are
    /// numbers.
    fn apply(&mut self, op: Op, operands: &[Self::Value]) -> Option<Self::Value>;
    /// Returns the conjunction of two truth values.
    fn both(&mut self, a: Self::Value, b: Self::Value) -> Self::Value;
}

/// Returns the string and the literal of a comparison with a literal, such as the choice of an
/// enumeration. The literal then needs no string of its own.
pub fn compared_text(op: Op, operands: &[Expr]) -> Option<(&Expr, &str)> {
    match (op, operands) {
        (Op::Equal | Op::NotEqual, [string, Expr { kind: ExprKind::String(text), .. }])
        | (Op::Equal | Op::NotEqual, [Expr { kind: ExprKind::String(text), .. }, string]) => {
            Some((string, text))
        }
        _ => None,
    }
}

/// Returns `true` if an operation maps scalars to a scalar. `Equal` and `NotEqual` do so for scalar
/// operands only.
pub fn is_scalar(op: Op) -> bool {
    use Op::*;
    matches!(
        op,
        Add | Subtract
            | Multiply
            | Divide
            | Power
            | Negate
            | Not
            | Less
            | LessEqual
            | Greater
            | GreaterEqual
            | Equal
            | NotEqual
            | Sqrt
            | Abs
            | Sin
            | Cos
            | Tan
            | Asin
            | Acos
            | Atan
            | Exp
            | Log
            | Floor
            | Ceil
            | Round
            | Spline
            | Atan2
            | Min
            | Max
    )
}

/// Returns the slots of the result of an operation on vectors or transforms, given the concatenated
/// slots of all operands.
///
/// Returns `None` for operations that exist only in symbolic expressions, and for operands of the
/// wrong size.
pub fn expand<S: Scalars>(s: &mut S, op: Op, operands: &[S::Value]) -> Option<Vec<S::Value>> {
    let mut e = Expansion(s);
    let v = |at: usize| -> Option<[S::Value; 3]> { operands.get(at..at + 3)?.try_into().ok() };
    let matrix = |at: usize| -> Option<[[S::Value; 3]; 3]> { Some([v(at)?, v(at + 3)?, v(at + 6)?]) };
    let scalar = |at: usize| operands.get(at).copied();
    Some(match op {
        Op::Vector => v(0)?.to_vec(),
        Op::X => vec![v(0)?[0]],
        Op::Y => vec![v(0)?[1]],
        Op::Z => vec![v(0)?[2]],
        Op::Norm => {
            let square = e.dot(v(0)?, v(0)?)?;
            vec![e.0.apply(Op::Sqrt, &[square])?]
        }
        Op::AddVector => e.each(Op::Add, v(0)?, v(3)?)?.to_vec(),
        Op::SubtractVector => e.each(Op::Subtract, v(0)?, v(3)?)?.to_vec(),
        Op::NegateVector => e.negated(v(0)?)?.to_vec(),
        Op::Scale => {
            let factor = scalar(0)?;
            e.each(Op::Multiply, [factor; 3], v(1)?)?.to_vec()
        }
        Op::Dot => vec![e.dot(v(0)?, v(3)?)?],
        Op::Cross => e.cross(v(0)?, v(3)?)?.to_vec(),
        Op::Equal | Op::NotEqual => {
            let [x, y, z] = e.each(Op::Equal, v(0)?, v(3)?)?;
            let xy = e.0.both(x, y);
            let equal = e.0.both(xy, z);
            vec![if op == Op::Equal { equal } else { e.0.apply(Op::Not, &[equal])? }]
        }
        Op::Translate => {
            let (zero, one) = (e.0.number(0.0), e.0.number(1.0));
            let identity = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
            transform(identity, e.negated(v(0)?)?)
        }
        Op::Rotate => {
            let zero = e.0.number(0.0);
            transform(e.rotation(scalar(0)?, v(1)?)?, [zero; 3])
        }
        // A (B x) = Ra Rb x + Ra tb + ta.
        Op::Compose => {
            let (a, b) = (matrix(0)?, transposed(matrix(12)?));
            let rotation = three(|i| three(|j| e.dot(a[i], b[j])))?;
            let moved = e.times(a, v(21)?)?;
            transform(rotation, e.each(Op::Add, moved, v(9)?)?)
        }
        Op::Apply => {
            let turned = e.times(matrix(0)?, v(12)?)?;
            e.each(Op::Add, turned, v(9)?)?.to_vec()
        }
        Op::Inverse => {
            let back = transposed(matrix(0)?);
            let moved = e.times(back, v(9)?)?;
            transform(back, e.negated(moved)?)
        }
        // The point that maps to zero: R x + t = 0.
        Op::Origin => {
            let moved = e.times(transposed(matrix(0)?), v(9)?)?;
            e.negated(moved)?.to_vec()
        }
        Op::Direction => e.times(transposed(matrix(0)?), v(12)?)?.to_vec(),
        _ => return None,
    })
}

fn transposed<V: Copy>(m: [[V; 3]; 3]) -> [[V; 3]; 3] {
    [0, 1, 2].map(|i| [m[0][i], m[1][i], m[2][i]])
}

fn transform<V: Copy>(rotation: [[V; 3]; 3], translation: [V; 3]) -> Vec<V> {
    [rotation.concat().as_slice(), &translation].concat()
}

fn three<T>(mut element: impl FnMut(usize) -> Option<T>) -> Option<[T; 3]> {
    Some([element(0)?, element(1)?, element(2)?])
}

struct Expansion<'s, S>(&'s mut S);

impl<S: Scalars> Expansion<'_, S> {
    fn each(&mut self, op: Op, a: [S::Value; 3], b: [S::Value; 3]) -> Option<[S::Value; 3]> {
        three(|i| self.0.apply(op, &[a[i], b[i]]))
    }

    fn negated(&mut self, a: [S::Value; 3]) -> Option<[S::Value; 3]> {
        three(|i| self.0.apply(Op::Negate, &[a[i]]))
    }

    fn dot(&mut self, a: [S::Value; 3], b: [S::Value; 3]) -> Option<S::Value> {
        let [x, y, z] = self.each(Op::Multiply, a, b)?;
        let xy = self.0.apply(Op::Add, &[x, y])?;
        self.0.apply(Op::Add, &[xy, z])
    }

    fn cross(&mut self, a: [S::Value; 3], b: [S::Value; 3]) -> Option<[S::Value; 3]> {
        three(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let positive = self.0.apply(Op::Multiply, &[a[i], b[j]])?;
            let negative = self.0.apply(Op::Multiply, &[a[j], b[i]])?;
            self.0.apply(Op::Subtract, &[positive, negative])
        })
    }

    fn times(&mut self, m: [[S::Value; 3]; 3], v: [S::Value; 3]) -> Option<[S::Value; 3]> {
        three(|i| self.dot(m[i], v))
    }

    /// Transpose of Rodrigues' rotation matrix `c I + s [u]x + (1 - c) u u^T` about a unit axis
    /// `u`.
    fn rotation(&mut self, angle: S::Value, u: [S::Value; 3]) -> Option<[[S::Value; 3]; 3]> {
        let sine = self.0.apply(Op::Sin, &[angle])?;
        let cosine = self.0.apply(Op::Cos, &[angle])?;
        let one = self.0.number(1.0);
        let versine = self.0.apply(Op::Subtract, &[one, cosine])?;
        three(|i| {
            three(|j| {
                let product = self.0.apply(Op::Multiply, &[u[i], u[j]])?;
                let dyadic = self.0.apply(Op::Multiply, &[versine, product])?;
                if i == j {
                    return self.0.apply(Op::Add, &[cosine, dyadic]);
                }
                // Transposed: + sin u_k for (i, j, k) in cyclic order, - for the rest.
                let along = self.0.apply(Op::Multiply, &[sine, u[3 - i - j]])?;
                let sign = if (i + 1) % 3 == j { Op::Add } else { Op::Subtract };
                self.0.apply(sign, &[dyadic, along])
            })
        })
    }
}
