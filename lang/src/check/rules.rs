//! Names of the type inference rules, and a record of the rules that a check applied.
//!
//! The language corpus uses the record, because it must apply every rule
//! (`tests/language/COVERAGE.md`). The record is per thread and requires the feature `rule-record`;
//! otherwise recording does nothing.

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
    BareLiteral "with `units`, a bare literal that is a whole initialiser has the dimension of its use"
    ZeroLiteral "`0` has any dimension"
    MultiplyNumbers "Number(a) * Number(b) is Number(a*b)"
    MultiplyNumberVector "Number(a) * Vector(b) is Vector(a*b)"
    MultiplyVectorNumber "Vector(a) * Number(b) is Vector(a*b)"
    MultiplyFrames "Transform * Transform is Transform"
    MultiplyFramePoint "Transform * Vector(Length) is Vector(Length)"
    MultiplyOpen "a product of unknown types waits for them"
    MultiplyRefused "no other types multiply"
    DivideNumbers "Number(a) / Number(b) is Number(a/b)"
    DivideVector "Vector(a) / Number(b) is Vector(a/b)"
    DivideOpen "a quotient of unknown types waits for them"
    DivideRefused "no other types divide"
    AddNumbers "numbers of one dimension add"
    AddVectors "vectors of one dimension add"
    AddOpen "a sum of unknown types waits for them"
    AddRefused "no other types add"
    CompareNumbers "numbers are compared for equality"
    CompareTruths "truth values are"
    CompareStrings "strings are"
    CompareVectors "vectors are"
    CompareArrays "arrays are, element by element"
    CompareTuples "tuples are, element by element"
    CompareRecords "records are, field by field"
    CompareOpen "a comparison of unknown types waits for them"
    CompareRefused "no other types are compared"
    PrintNumber "a number has a text form"
    PrintTruth "a truth value has"
    PrintString "a string has"
    PrintVector "a vector has"
    PrintFrame "a frame has"
    PrintArray "an array of what has one has"
    PrintTuple "a tuple of what has one has"
    PrintRecord "a record of what has one has"
    PrintOpen "text of an unknown type waits for it"
    PrintRefused "no other type has a text form"
    StyleNumber "a number is shown in a unit of its own dimension"
    StyleOpen "a format of an unknown type waits for it"
    StyleRefused "what holds no numbers has neither digits nor a unit"
    IndexArray "an element of Array(T) is T"
    IndexTuple "an element of a tuple by a constant is that element"
    IndexOpen "an element of an unknown type waits for it"
    IndexRefused "nothing else has elements; an element of a tuple needs a constant"
    ThrowString "a string is thrown as the message of an `Error`"
    ThrowRecord "an `Error` is thrown"
    ThrowOpen "what is thrown of an unknown type waits for it"
    ThrowRefused "nothing else is thrown"
    FieldVector "`.x`, `.y` and `.z` of Vector(d) are Number(d)"
    FieldRecord "a field of a record has the type of its declaration"
    FieldOpen "a field of an unknown type waits for it"
    FieldRefused "nothing else has fields"
    UnifyUnknown "an unknown type becomes the other one"
    UnifyNumbers "Number(a) is Number(b) if a is b"
    UnifyVectors "Vector(a) is Vector(b) if a is b"
    UnifyObservables "Observable(a) is Observable(b) if a is b"
    UnifyArrays "Array(S) is Array(T) if S is T"
    UnifyTuples "tuples are the same if their elements are"
    UnifySame "Bool, String, Transform, nothing, handles and records are themselves"
    UnifyKind "types of different kinds do not fit"
    UnifyDimension "types of different dimensions do not fit"
    UnifyInfinite "no type contains itself"
    SolveDimension "an unknown dimension is solved for, with rational exponents"
    KnownDimension "dimensions fit if their exponents are equal"
    SoftAngle "dimensions that differ in angle alone fit"
    GeneraliseType "what a function leaves open in its types is open in its scheme"
    GeneraliseDimension "so are dimensions"
    GeneraliseConstraint "so are the constraints on them"
    RecursiveGroup "functions that call each other have one scheme"
    OuterUnknown "what is unknown around a function stays one unknown"
    Instantiate "every use of a function has unknowns of its own"
    DefaultNumber "what nothing decides is a number"
    DefaultArray "what is indexed and otherwise undecided is an array"
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
}

#[cfg(not(feature = "rule-record"))]
mod record {
    #[inline]
    pub(in crate::check) fn applied(_: super::Rule) {}
}

pub(super) use record::applied;
#[cfg(feature = "rule-record")]
pub use record::take;

/// Records the result of a constraint: `Some(true)` solved, `Some(false)` failed, `None` still
/// open. `shallow` returns the known outermost constructor of a type.
pub(super) fn constraint(kind: &ConstraintKind, solved: Option<bool>, shallow: impl Fn(&Type) -> Type) {
    use ConstraintKind::{
        Additive, Comparable, Divide, Field, Index, Multiply, Printable, Styled, Throwable,
    };
    use Rule::*;
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
                (Type::Transform, Type::Transform) => Some(MultiplyFrames),
                (Type::Transform, Type::Vector(_)) => Some(MultiplyFramePoint),
                _ => None,
            },
            Divide(a, _, _) => match shallow(a) {
                Type::Number(_) => Some(DivideNumbers),
                Type::Vector(_) => Some(DivideVector),
                _ => None,
            },
            Additive(a) => match shallow(a) {
                Type::Number(_) => Some(AddNumbers),
                Type::Vector(_) => Some(AddVectors),
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
        // Only parameters have such types, and parameters are not unified with each other.
        (Ok(()), Type::Symbolic(_), _) => return,
        (
            Ok(()),
            Type::Unit | Type::Bool | Type::String | Type::Transform | Type::Handle(_) | Type::Record(_),
            _,
        ) => UnifySame,
    };
    applied(rule);
}
