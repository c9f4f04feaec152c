//! Names of the type inference rules, and a record of the rules that a check applied.
//!
//! The test of the language corpus uses the record, because the corpus must apply every rule. The
//! record is per thread and requires the feature `rule-record`; otherwise recording does nothing.

use super::tree::ConstraintKind;
use super::types::{Mismatch, Type};

/// Declares the rules with a sentence each.
macro_rules! rules {
    ($($name:ident $text:literal)*) => {
        /// A rule of type inference.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Rule {
            $(#[doc = $text] $name,)*
        }

        impl Rule {
            /// All rules, in order.
            pub const ALL: &[Rule] = &[$(Rule::$name),*];

            /// Returns the sentence that describes the rule.
            pub fn text(self) -> &'static str {
                match self {
                    $(Rule::$name => $text,)*
                }
            }
        }
    };
}

rules! {
    PureLiteral "a number without a unit is a pure number"
    BareLiteral "with `units`, a literal without a unit that is a complete initializer has the dimension of its use"
    ZeroLiteral "`0` has any dimension"
    MultiplyNumbers "Number(a) * Number(b) is Number(a*b)"
    MultiplyNumberVector "Number(a) * Vector(b) is Vector(a*b)"
    MultiplyVectorNumber "Vector(a) * Number(b) is Vector(a*b)"
    MultiplyArray "a product of a number and an array is the array of the products"
    MultiplyFrames "Transform * Transform is Transform"
    MultiplyFramePoint "Transform * Vector(Length) is Vector(Length)"
    MultiplyOpen "a product of unknown types is a pending constraint"
    MultiplyRefused "other types cannot be multiplied"
    DivideNumbers "Number(a) / Number(b) is Number(a/b)"
    DivideArray "a quotient of an array and a number is the array of the quotients"
    DivideVector "Vector(a) / Number(b) is Vector(a/b)"
    DivideOpen "a quotient of unknown types is a pending constraint"
    DivideRefused "other types cannot be divided"
    AddNumbers "numbers with the same dimension can be added"
    AddArrays "arrays are added element by element"
    AddVectors "vectors with the same dimension can be added"
    AddOpen "a sum of unknown types is a pending constraint"
    AddRefused "other types cannot be added"
    CompareNumbers "numbers can be compared for equality"
    CompareTruths "truth values can be compared"
    CompareStrings "strings can be compared"
    CompareVectors "vectors can be compared"
    CompareArrays "arrays are compared element by element"
    CompareTuples "tuples are compared element by element"
    CompareRecords "records are compared field by field"
    CompareOpen "a comparison of unknown types is a pending constraint"
    CompareRefused "other types cannot be compared"
    PrintNumber "a number can be converted to text"
    PrintTruth "a truth value can be converted to text"
    PrintString "a string can be converted to text"
    PrintVector "a vector can be converted to text"
    PrintFrame "a frame can be converted to text"
    PrintArray "an array can be converted to text if its elements can"
    PrintTuple "a tuple can be converted to text if its elements can"
    PrintRecord "a record can be converted to text if its fields can"
    PrintOpen "text of an unknown type is a pending constraint"
    PrintRefused "other types cannot be converted to text"
    StyleNumber "the unit in a format must have the dimension of the number"
    StyleOpen "a format of an unknown type is a pending constraint"
    StyleRefused "a type without numbers has neither digits nor a unit"
    IndexArray "an element of Array(T) is T"
    IndexTuple "an element of a tuple by a constant index has the type of that element"
    IndexOpen "an element of an unknown type is a pending constraint"
    IndexRefused "other types cannot be indexed; the index of a tuple must be constant"
    ThrowString "a thrown string is the message of an `Error`"
    ThrowRecord "an `Error` can be thrown"
    ThrowOpen "a thrown value of an unknown type is a pending constraint"
    ThrowRefused "other types cannot be thrown"
    FieldVector "`.x`, `.y` and `.z` of Vector(d) are Number(d)"
    FieldRecord "a field of a record has the type of its declaration"
    FieldOpen "a field of an unknown type is a pending constraint"
    FieldRefused "other types have no fields"
    UnifyUnknown "a type variable unifies with any type"
    UnifyNumbers "Number(a) unifies with Number(b) if a unifies with b"
    UnifyVectors "Vector(a) unifies with Vector(b) if a unifies with b"
    UnifyObservables "Observable(a) unifies with Observable(b) if a unifies with b"
    UnifyArrays "Array(S) unifies with Array(T) if S unifies with T"
    UnifyOptionals "optional types unify if their values do"
    UnifyExpressions "expressions that are stored as values unify if their types do"
    UnifyTuples "tuples unify if their elements do"
    UnifyFunctions "functions unify if their parameters and results do"
    UnifySame "Bool, String, Transform, the unit type, handles and records unify with themselves"
    UnifyKind "types of different kinds do not unify"
    UnifyDimension "types with different dimensions do not unify"
    UnifyInfinite "no type contains itself"
    SolveDimension "a dimension variable is solved for, with rational exponents"
    KnownDimension "dimensions unify if their exponents are equal"
    SoftAngle "dimensions that differ only in angle unify"
    GeneraliseType "undetermined types of a function are quantified in its scheme"
    GeneraliseDimension "undetermined dimensions are quantified"
    GeneraliseConstraint "constraints on quantified variables are part of the scheme"
    RecursiveGroup "mutually recursive functions are generalized together"
    OuterUnknown "variables that also occur outside a function are not quantified"
    Instantiate "every use of a function instantiates its scheme with fresh variables"
    DefaultNumber "an undetermined type is a number"
    DefaultArray "an undetermined type that is indexed is an array"
}

#[cfg(feature = "rule-record")]
mod record {
    use super::Rule;
    use std::cell::RefCell;
    use std::collections::BTreeSet;

    thread_local! {
        static APPLIED: RefCell<BTreeSet<Rule>> = const { RefCell::new(BTreeSet::new()) };
    }

    pub(in crate::check) fn applied(rule: Rule) {
        APPLIED.with_borrow_mut(|rules| rules.insert(rule));
    }

    /// Returns the rules applied on this thread since the last call.
    pub fn take() -> BTreeSet<Rule> {
        APPLIED.take()
    }

    /// Adds rules that another thread applied for this one.
    pub(crate) fn add(rules: BTreeSet<Rule>) {
        APPLIED.with_borrow_mut(|own| own.extend(rules));
    }
}

#[cfg(not(feature = "rule-record"))]
mod record {
    #[inline]
    pub(in crate::check) fn applied(_: super::Rule) {}

    pub(crate) fn take() {}

    pub(crate) fn add((): ()) {}
}

pub(crate) use record::add;
pub(super) use record::applied;
#[cfg(feature = "rule-record")]
pub use record::take;
#[cfg(not(feature = "rule-record"))]
pub(crate) use record::take;

/// Records the result of a constraint: `Some(true)` solved, `Some(false)` failed, `None` still
/// open. `shallow` returns the known outermost constructor of a type.
pub(super) fn constraint(kind: &ConstraintKind, solved: Option<bool>, shallow: impl Fn(&Type) -> Type) {
    use ConstraintKind::{
        Additive, Comparable, Divide, Field, Index, Multiply, Printable, Styled, Throwable,
    };
    use Rule::*;
    if !cfg!(feature = "rule-record") {
        return;
    }
    let (open, refused) = match kind {
        Multiply(..) => (MultiplyOpen, MultiplyRefused),
        Divide(..) => (DivideOpen, DivideRefused),
        Additive(_) => (AddOpen, AddRefused),
        Comparable(_) => (CompareOpen, CompareRefused),
        Printable(_) => (PrintOpen, PrintRefused),
        Styled(..) => (StyleOpen, StyleRefused),
        Index(..) => (IndexOpen, IndexRefused),
        Field(..) => (FieldOpen, FieldRefused),
        Throwable(_) => (ThrowOpen, ThrowRefused),
    };
    let rule = match solved {
        None => Some(open),
        Some(false) => Some(refused),
        Some(true) => match kind {
            Multiply(a, b, _) => match (shallow(a), shallow(b)) {
                (Type::Number(_), Type::Number(_)) => Some(MultiplyNumbers),
                (Type::Number(_), Type::Vector(_)) => Some(MultiplyNumberVector),
                (Type::Vector(_), Type::Number(_)) => Some(MultiplyVectorNumber),
                (Type::Array(_), _) | (_, Type::Array(_)) => Some(MultiplyArray),
                (Type::Transform, Type::Transform) => Some(MultiplyFrames),
                (Type::Transform, Type::Vector(_)) => Some(MultiplyFramePoint),
                _ => None,
            },
            Divide(a, _, _) => match shallow(a) {
                Type::Number(_) => Some(DivideNumbers),
                Type::Vector(_) => Some(DivideVector),
                Type::Array(_) => Some(DivideArray),
                _ => None,
            },
            Additive(a) => match shallow(a) {
                Type::Number(_) => Some(AddNumbers),
                Type::Vector(_) => Some(AddVectors),
                Type::Array(_) => Some(AddArrays),
                _ => None,
            },
            Comparable(a) => match shallow(a) {
                Type::Number(_) => Some(CompareNumbers),
                Type::Bool => Some(CompareTruths),
                Type::String => Some(CompareStrings),
                Type::Vector(_) => Some(CompareVectors),
                Type::Array(_) => Some(CompareArrays),
                Type::Tuple(_) => Some(CompareTuples),
                Type::Record(_) => Some(CompareRecords),
                _ => None,
            },
            Printable(a) => match shallow(a) {
                Type::Number(_) => Some(PrintNumber),
                Type::Bool => Some(PrintTruth),
                Type::String => Some(PrintString),
                Type::Vector(_) => Some(PrintVector),
                Type::Transform => Some(PrintFrame),
                Type::Array(_) => Some(PrintArray),
                Type::Tuple(_) => Some(PrintTuple),
                Type::Record(_) => Some(PrintRecord),
                _ => None,
            },
            Styled(a, ..) => matches!(shallow(a), Type::Number(_)).then_some(StyleNumber),
            Index(base, ..) => match shallow(base) {
                Type::Array(_) => Some(IndexArray),
                Type::Tuple(_) => Some(IndexTuple),
                _ => None,
            },
            Throwable(a) => match shallow(a) {
                Type::String => Some(ThrowString),
                Type::Record(_) => Some(ThrowRecord),
                _ => None,
            },
            Field(base, ..) => match shallow(base) {
                Type::Vector(_) => Some(FieldVector),
                Type::Record(_) => Some(FieldRecord),
                _ => None,
            },
        },
    };
    rule.into_iter().for_each(applied);
}

/// Records the unification of two types, given as they were known before.
pub(super) fn unified(a: &Type, b: &Type, result: &Result<(), Mismatch>) {
    use Rule::*;
    let rule = match (result, a, b) {
        (_, Type::Error, _) | (_, _, Type::Error) => return,
        (Err(Mismatch::Kind), ..) => UnifyKind,
        (Err(Mismatch::Dimension(_)), ..) => UnifyDimension,
        (Err(Mismatch::Infinite), ..) => UnifyInfinite,
        (Ok(()), Type::Unknown(_), _) | (Ok(()), _, Type::Unknown(_)) => UnifyUnknown,
        (Ok(()), Type::Number(_), _) => UnifyNumbers,
        (Ok(()), Type::Vector(_), _) => UnifyVectors,
        (Ok(()), Type::Observable(_), _) => UnifyObservables,
        (Ok(()), Type::Array(_), _) => UnifyArrays,
        (Ok(()), Type::Tuple(_), _) => UnifyTuples,
        (Ok(()), Type::Function(..), _) => UnifyFunctions,
        (Ok(()), Type::Optional(_), _) => UnifyOptionals,
        (Ok(()), Type::Symbolic(_), _) => UnifyExpressions,
        (
            Ok(()),
            Type::Unit
            | Type::Bool
            | Type::String
            | Type::Transform
            | Type::Handle(_)
            | Type::Enum(_)
            | Type::Record(_),
            _,
        ) => UnifySame,
    };
    applied(rule);
}
