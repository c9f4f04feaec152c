//! Constraints on one type: values that can be added, compared, converted to text, formatted or
//! thrown.

use super::*;
use crate::check::angles::turn_in_format;
use crate::check::tree::RecordId;
use crate::dimension::Base;

impl Checker<'_> {
    /// Solves the constraint that values of a type can be added.
    pub(super) fn solve_additive(&mut self, a: &Type, constraint: &Constraint) -> Outcome {
        match self.store.shallow(a) {
            Type::Unknown(_) => Outcome::Open,
            Type::Number(_) | Type::Vector(_) | Type::Observable(_) | Type::Error => Outcome::Solved,
            Type::Array(part) => self.every_part(vec![*part], Additive, constraint),
            other => {
                let help = match other {
                    Type::String => "join strings by interpolation: `\"{a}{b}\"`",
                    Type::Transform => "combine frames with `*`",
                    _ => "only numbers, vectors and arrays of them can be added",
                };
                self.unsupported("E0304", &other, "cannot be added or subtracted", help, constraint)
            }
        }
    }

    /// Solves the constraint that values of a type can be compared.
    pub(super) fn solve_comparable(&mut self, a: &Type, constraint: &Constraint) -> Outcome {
        match self.store.shallow(a) {
            Type::Unknown(_) => Outcome::Open,
            Type::Array(part) | Type::Optional(part) => self.every_part(vec![*part], Comparable, constraint),
            Type::Tuple(parts) => self.every_part(parts, Comparable, constraint),
            Type::Record(id) => self.every_part(self.field_types(id), Comparable, constraint),
            Type::Number(_) | Type::Bool | Type::String | Type::Enum(_) | Type::Vector(_) | Type::Error => {
                Outcome::Solved
            }
            Type::Observable(_) => Outcome::failed(self.observable_as_value(constraint.span)),
            other => self.unsupported(
                "E0304",
                &other,
                "cannot be compared",
                "numbers, truth values, strings, vectors, and arrays and tuples of them can",
                constraint,
            ),
        }
    }

    /// Solves the constraint that values of a type can be converted to text.
    pub(super) fn solve_printable(&mut self, a: &Type, constraint: &Constraint) -> Outcome {
        match self.store.shallow(a) {
            Type::Unknown(_) => Outcome::Open,
            Type::Number(_)
            | Type::Bool
            | Type::String
            | Type::Enum(_)
            | Type::Vector(_)
            | Type::Transform
            | Type::Error => Outcome::Solved,
            Type::Array(part) | Type::Optional(part) => self.every_part(vec![*part], Printable, constraint),
            Type::Tuple(parts) => self.every_part(parts, Printable, constraint),
            Type::Record(id) => self.every_part(self.field_types(id), Printable, constraint),
            Type::Observable(_) => Outcome::failed(self.observable_as_value(constraint.span)),
            other => {
                let help = "numbers, truth values, strings, vectors, frames, and arrays, tuples and records of \
                            them can";
                self.unsupported("E0304", &other, "cannot be converted to text", help, constraint)
            }
        }
    }

    /// Solves the constraint that values of a type can be thrown.
    pub(super) fn solve_throwable(&mut self, a: &Type, constraint: &Constraint) -> Outcome {
        match self.store.shallow(a) {
            Type::Unknown(_) => Outcome::Open,
            Type::String | Type::Error => Outcome::Solved,
            other if other == self.error_type() => Outcome::Solved,
            other => self.unsupported(
                "E0304",
                &other,
                "cannot be thrown",
                "throw a text: `throw \"...\";`, or an `Error(message = \"...\")`",
                constraint,
            ),
        }
    }

    fn field_types(&self, id: RecordId) -> Vec<Type> {
        let fields = self.store.record(id).into_iter().flat_map(|record| &record.fields);
        fields.map(|(_, ty)| ty.clone()).collect()
    }

    /// Applies the same constraint to all parts of an array, a tuple or a record.
    fn every_part(
        &mut self,
        parts: Vec<Type>,
        demand: impl Fn(Type) -> ConstraintKind,
        constraint: &Constraint,
    ) -> Outcome {
        let mut open = false;
        for ty in parts {
            match self.try_solve(&Constraint { kind: demand(ty), span: constraint.span }) {
                Outcome::Solved => {}
                Outcome::Open => open = true,
                failed => return failed,
            }
        }
        if open { Outcome::Open } else { Outcome::Solved }
    }

    /// Checks that values of a type can be formatted with a unit or a number of digits.
    pub(super) fn styled(
        &mut self,
        ty: Type,
        unit: Option<Dimension>,
        digits: bool,
        constraint: &Constraint,
    ) -> Outcome {
        match (self.store.shallow(&ty), unit) {
            (Type::Unknown(_), _) => Outcome::Open,
            (Type::Number(dim) | Type::Vector(dim), Some(unit)) => {
                let shown = with_article(&self.store.show_dim(&dim));
                if self.store.dim(&dim).as_known().is_some_and(|known| known.lacks_turn(unit)) {
                    return Outcome::failed(turn_in_format(constraint.span));
                }
                match self.store.unify_dims(&dim, &Dim::known(unit)) {
                    Ok(()) => Outcome::Solved,
                    Err(_) => {
                        let unit = with_article(&self.store.vocabulary.show(unit));
                        Outcome::failed(
                            Diagnostic::error(
                                "E0401",
                                format!("{shown} cannot be shown in a unit of {unit}"),
                                constraint.span,
                                format!("this is {shown}"),
                            )
                            .help("use a unit of its dimension, or omit the unit"),
                        )
                    }
                }
            }
            (Type::Transform, Some(unit)) if unit != Dimension::of(Base::Length) => Outcome::failed(
                Diagnostic::error(
                    "E0401",
                    "a frame is shown in a unit of length",
                    constraint.span,
                    "this is a Transform",
                )
                .help("choose a unit such as `mm`"),
            ),
            (Type::Array(element), _) => self.styled(*element, unit, digits, constraint),
            (Type::Number(_) | Type::Vector(_) | Type::Transform | Type::Error, _) => Outcome::Solved,
            (Type::Bool | Type::String | Type::Enum(_), None) if !digits => Outcome::Solved,
            // Elements without numbers ignore the format; all numbers must have the dimension of
            // the unit.
            (Type::Tuple(parts), _) => self.every_part(parts, |ty| Styled(ty, unit, digits), constraint),
            (Type::Record(_), None) => Outcome::Solved,
            (other, _) => self.unsupported(
                "E0408",
                &other,
                "has neither digits nor a unit",
                "digits and units apply to numbers; texts can have a width: `{name : 12}`",
                constraint,
            ),
        }
    }
}
