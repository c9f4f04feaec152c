//! Names every program has without declaring or importing them.

use super::symbols::{Constant, NumberConstant};
use crate::ir::Op;

/// A function built into the language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Builtin {
    /// Typed by a table row: [`Signature`].
    Operation(&'static Signature),
    /// Two or more numbers of one dimension.
    Extreme(Op),
    Sqrt,
    Derivative,
    Gradient,
    Print,
    Assert,
    Len,
    Push,
}

/// Parameters and result of a builtin, in terms of at most one unknown dimension `d`.
#[derive(Debug, PartialEq, Eq)]
pub struct Signature {
    pub name: &'static str,
    pub op: Op,
    pub parameters: &'static [(&'static str, Shape)],
    pub result: Shape,
    /// Its argument must be an expression in `Time`, not a value.
    pub symbolic: bool,
}

/// A type in a builtin's signature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A pure number.
    Number,
    Angle,
    /// Number of dimension d.
    Any,
    /// Number of dimension d*e, e being a second unknown dimension.
    Product,
    /// Vector of dimension d, e or d*e.
    VectorAny,
    VectorOther,
    VectorProduct,
    VectorLength,
    /// A direction: dimensionless vector.
    Axis,
    /// Vector of length / time, length / time^2, angle / time, angle / time^2.
    VectorRate(RateOf, u8),
    Transform,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateOf {
    Length,
    Angle,
}

macro_rules! signatures {
    ($($name:literal $op:ident ($($parameter:literal: $shape:expr),*) -> $result:expr $(, $symbolic:ident)?;)*) => {
        &[$(Signature {
            name: $name,
            op: Op::$op,
            parameters: &[$(($parameter, $shape)),*],
            result: $result,
            symbolic: signatures!(@symbolic $($symbolic)?),
        }),*]
    };
    (@symbolic symbolic) => { true };
    (@symbolic) => { false };
}

use Shape::*;

const SIGNATURES: &[Signature] = signatures! {
    "sin" Sin ("x": Angle) -> Number;
    "cos" Cos ("x": Angle) -> Number;
    "tan" Tan ("x": Angle) -> Number;
    "asin" Asin ("x": Number) -> Angle;
    "acos" Acos ("x": Number) -> Angle;
    "atan" Atan ("x": Number) -> Angle;
    "atan2" Atan2 ("y": Any, "x": Any) -> Angle;
    "exp" Exp ("x": Number) -> Number;
    "log" Log ("x": Number) -> Number;
    "abs" Abs ("x": Any) -> Any;
    "floor" Floor ("x": Number) -> Number;
    "ceil" Ceil ("x": Number) -> Number;
    "round" Round ("x": Number) -> Number;
    "dot" Dot ("a": VectorAny, "b": VectorOther) -> Product;
    "cross" Cross ("a": VectorAny, "b": VectorOther) -> VectorProduct;
    "norm" Norm ("v": VectorAny) -> Any;
    "Translate" Translate ("v": VectorLength) -> Transform;
    "Rotate" Rotate ("angle": Angle, "axis": Axis) -> Transform;
    "inverse" Inverse ("frame": Transform) -> Transform;
    "origin" Origin ("frame": Transform) -> VectorLength;
    "direction" Direction ("frame": Transform, "v": VectorAny) -> VectorAny;
    "velocity" Velocity ("frame": Transform) -> VectorRate(RateOf::Length, 1), symbolic;
    "acceleration" Acceleration ("frame": Transform) -> VectorRate(RateOf::Length, 2), symbolic;
    "angular_velocity" AngularVelocity ("frame": Transform) -> VectorRate(RateOf::Angle, 1), symbolic;
    "angular_acceleration" AngularAcceleration ("frame": Transform) -> VectorRate(RateOf::Angle, 2), symbolic;
};

const SPECIAL: &[(&str, Builtin)] = &[
    ("min", Builtin::Extreme(Op::Min)),
    ("max", Builtin::Extreme(Op::Max)),
    ("sqrt", Builtin::Sqrt),
    ("derivative", Builtin::Derivative),
    ("gradient", Builtin::Gradient),
    ("print", Builtin::Print),
    ("assert", Builtin::Assert),
    ("len", Builtin::Len),
    ("push", Builtin::Push),
];

impl Builtin {
    pub fn find(name: &str) -> Option<Builtin> {
        SIGNATURES
            .iter()
            .find(|signature| signature.name == name)
            .map(Builtin::Operation)
            .or_else(|| SPECIAL.iter().find(|(special, _)| *special == name).map(|(_, builtin)| *builtin))
    }
}

const CONSTANTS: &[(&str, Constant)] = &[
    ("Time", Constant::Time),
    ("e1", Constant::Basis(0)),
    ("e2", Constant::Basis(1)),
    ("e3", Constant::Basis(2)),
    ("pi", Constant::Number(NumberConstant::Pi)),
    ("inf", Constant::Number(NumberConstant::Infinity)),
    ("nan", Constant::Number(NumberConstant::NotANumber)),
    ("TRUE", Constant::Bool(true)),
    ("FALSE", Constant::Bool(false)),
];

/// The meaning of a reserved name.
pub fn constant(name: &str) -> Option<Constant> {
    CONSTANTS.iter().find(|(reserved, _)| *reserved == name).map(|(_, constant)| *constant)
}

/// Every name of this module, functions and reserved names, for suggestions and the reference.
pub fn names() -> impl Iterator<Item = &'static str> {
    SIGNATURES
        .iter()
        .map(|signature| signature.name)
        .chain(SPECIAL.iter().map(|(name, _)| *name))
        .chain(CONSTANTS.iter().map(|(name, _)| *name))
}
