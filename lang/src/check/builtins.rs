//! Built-in names: names that every program can use without a declaration or an import.

use super::schemes::ShownScheme;
use super::symbols::{Constant, NumberConstant};
use crate::analysis::{CallParameter, Callable, NameKind};
use crate::ast::Mode;
use crate::dimension::{Base, Dimension};
use crate::ir::Op;
use calyx_abi::newton::Search;

/// A built-in function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Builtin {
    /// A function with a [`Signature`] in the table.
    Operation(&'static Signature),
    /// Minimum or maximum of two or more numbers with the same dimension, or of an array of them.
    Extreme(Op),
    Sqrt,
    Derivative,
    Gradient,
    /// `solve` or `minimize`.
    Solve(Search),
    Spline,
    Print,
    Assert,
    Len,
    Push,
    Sum,
    Sort,
}

/// Parameters and result of a built-in function, with at most one dimension variable `d`.
#[derive(Debug, PartialEq, Eq)]
pub struct Signature {
    pub name: &'static str,
    pub op: Op,
    pub parameters: &'static [(&'static str, Shape)],
    pub result: Shape,
    /// `true` if its argument must be an expression in `Time`.
    pub symbolic: bool,
}

/// A type in the signature of a built-in function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A pure number.
    Number,
    Angle,
    /// Number with dimension d.
    Any,
    /// Number with dimension d*e, where e is a second dimension variable.
    Product,
    /// Vector with dimension d, e or d*e.
    VectorAny,
    VectorOther,
    VectorProduct,
    VectorLength,
    /// Direction: a dimensionless vector.
    Axis,
    /// Vector with dimension length / time, length / time^2, angle / time, angle / time^2.
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
    ("solve", Builtin::Solve(Search::Root)),
    ("minimize", Builtin::Solve(Search::Minimum)),
    ("spline", Builtin::Spline),
    ("print", Builtin::Print),
    ("assert", Builtin::Assert),
    ("len", Builtin::Len),
    ("push", Builtin::Push),
    ("sum", Builtin::Sum),
    ("sort", Builtin::Sort),
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

/// Name, parameters with their types, whether it is variadic, result.
type ShownBuiltin = (&'static str, &'static [(&'static str, &'static str)], bool, Option<&'static str>);

/// Parameters and results of functions without a table row. The last parameter of a variadic
/// function may be repeated.
const SHOWN: &[ShownBuiltin] = &[
    ("min", &[("a", "a"), ("b", "a")], true, Some("a")),
    ("max", &[("a", "a"), ("b", "a")], true, Some("a")),
    ("sqrt", &[("x", "a")], false, Some("a^(1/2)")),
    ("derivative", &[("expression", "T"), ("symbol", "a")], false, Some("T/a")),
    ("gradient", &[("expression", "a"), ("symbols", "[b, ...]")], false, Some("[a/b, ...]")),
    ("solve", &[("f", "function"), ("guess", "T"), ("argument", "U")], true, Some("T")),
    ("minimize", &[("f", "function"), ("guess", "T"), ("argument", "U")], true, Some("T")),
    ("spline", &[("xs", "Array(a)"), ("ys", "Array(b)"), ("x", "a")], false, Some("b")),
    ("print", &[("value", "T")], true, None),
    ("assert", &[("condition", "Bool"), ("message", "String")], false, None),
    ("len", &[("array", "Array(T)")], false, Some("Number")),
    ("push", &[("array", "Array(T)"), ("value", "T")], false, None),
    ("sum", &[("array", "Array(T)")], false, Some("T")),
    ("sort", &[("array", "Array(a)")], false, Some("Array(a)")),
];

impl Shape {
    /// Returns the type as displayed; `a` and `b` are dimension variables.
    fn show(self) -> &'static str {
        match self {
            Number => "Number",
            Angle => "Angle",
            Any => "a",
            Product => "a*b",
            VectorAny => "Vector(a)",
            VectorOther => "Vector(b)",
            VectorProduct => "Vector(a*b)",
            VectorLength => "Vector(Length)",
            Axis => "Vector",
            VectorRate(RateOf::Length, 1) => "Vector(Velocity)",
            VectorRate(RateOf::Length, _) => "Vector(Acceleration)",
            VectorRate(RateOf::Angle, 1) => "Vector(AngularVelocity)",
            VectorRate(RateOf::Angle, _) => "Vector(AngularAcceleration)",
            Transform => "Transform",
        }
    }

    fn dimension(self) -> Option<Dimension> {
        match self {
            Number | Axis => Some(Dimension::NONE),
            Angle => Some(Dimension::of(Base::Angle)),
            VectorLength => Some(Dimension::of(Base::Length)),
            VectorRate(RateOf::Length, 1) => Dimension::from_name("Velocity"),
            VectorRate(RateOf::Length, _) => Dimension::from_name("Acceleration"),
            VectorRate(RateOf::Angle, 1) => Dimension::from_name("AngularVelocity"),
            VectorRate(RateOf::Angle, _) => Dimension::from_name("AngularAcceleration"),
            Any | Product | VectorAny | VectorOther | VectorProduct | Transform => None,
        }
    }
}

/// Returns the parameters and the result of a built-in function.
pub fn callable(name: &str) -> Option<Callable> {
    let parameter = |name: &str, ty: &str, dimension| CallParameter {
        name: name.into(),
        former: None,
        mode: Mode::In,
        symbolic: false,
        ty: ty.into(),
        dimension,
        default: None,
        range: None,
        choices: Vec::new(),
        doc: None,
        declared: None,
    };
    let (parameters, open, result) = match SIGNATURES.iter().find(|signature| signature.name == name) {
        Some(signature) => {
            let each = signature.parameters.iter();
            let parameters = each.map(|(name, shape)| parameter(name, shape.show(), shape.dimension()));
            (parameters.collect(), false, Some(signature.result.show()))
        }
        None => {
            let (_, parameters, open, result) = SHOWN.iter().find(|(known, ..)| *known == name)?;
            let parameters = parameters.iter().map(|(name, ty)| parameter(name, ty, None));
            (parameters.collect(), *open, *result)
        }
    };
    Some(Callable {
        name: name.into(),
        kind: NameKind::Builtin,
        doc: crate::help::builtin(name).map(|help| help.text.to_string()),
        parameters,
        open,
        result: result.map(str::to_string),
        demands: Vec::new(),
        declared: None,
    })
}

/// Returns the type of a built-in function or name, as displayed.
pub fn shown(name: &str) -> Option<String> {
    if let Some(constant) = constant(name) {
        let ty = match constant {
            Constant::Time => "Time",
            Constant::Basis(_) => "Vector",
            Constant::Number(_) => "Number",
            Constant::Bool(_) => "Bool",
        };
        return Some(ty.into());
    }
    let callable = callable(name)?;
    let parameters = callable.parameters.iter().map(|p| (p.mode, p.name.to_string(), p.ty.clone()));
    let shown = ShownScheme {
        name: name.into(),
        is_component: false,
        parameters: parameters.collect(),
        result: callable.result,
        demands: Vec::new(),
    };
    Some(shown.to_string())
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

/// Returns the meaning of a reserved name.
pub fn constant(name: &str) -> Option<Constant> {
    CONSTANTS.iter().find(|(reserved, _)| *reserved == name).map(|(_, constant)| *constant)
}

/// Returns all built-in functions and reserved names, for suggestions and the reference.
pub fn names() -> impl Iterator<Item = &'static str> {
    SIGNATURES
        .iter()
        .map(|signature| signature.name)
        .chain(SPECIAL.iter().map(|(name, _)| *name))
        .chain(CONSTANTS.iter().map(|(name, _)| *name))
}
