//! Type constraints of operators, which are solved as soon as the types of the operands are known.

mod properties;

use super::dim::Dim;
use super::expected_type::too_large;
use super::infer::Checker;
use super::places::{component_assigned, member_assigned};
use super::rules::{self, Rule};
use super::symbols::with_article;
use super::tree::{Constraint, ConstraintKind, FieldUse};
use super::types::{Mismatch, Type};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::hashed::HashMap;
use std::collections::hash_map::Entry;
use std::mem::{Discriminant, discriminant};

/// The result of solving a constraint.
enum Outcome {
    Solved,
    /// Some types are still unknown.
    Open,
    Failed(Box<Diagnostic>),
}

impl Outcome {
    fn failed(diagnostic: Diagnostic) -> Outcome {
        Outcome::Failed(Box::new(diagnostic))
    }
}

use ConstraintKind::*;

impl Constraint {
    /// Returns the types in the constraint.
    pub fn types(&self) -> Vec<&Type> {
        match &self.kind {
            Multiply(a, b, c) | Divide(a, b, c) => vec![a, b, c],
            Additive(a) | Comparable(a) | Printable(a) | Throwable(a) | Styled(a, ..) => vec![a],
            Index(a, _, b) | Field(a, _, b, _) => vec![a, b],
        }
    }

    /// Returns the same constraint on other types.
    pub fn map(&self, mut f: impl FnMut(&Type) -> Type) -> ConstraintKind {
        match &self.kind {
            Multiply(a, b, c) => Multiply(f(a), f(b), f(c)),
            Divide(a, b, c) => Divide(f(a), f(b), f(c)),
            Additive(a) => Additive(f(a)),
            Comparable(a) => Comparable(f(a)),
            Printable(a) => Printable(f(a)),
            Throwable(a) => Throwable(f(a)),
            Styled(a, unit, digits) => Styled(f(a), *unit, *digits),
            Index(a, at, b) => Index(f(a), *at, f(b)),
            Field(a, name, b, field_use) => Field(f(a), name.clone(), f(b), *field_use),
        }
    }
}

/// Key of equal constraints: their kind, name and the types of their arguments.
type ConstraintKey = (Discriminant<ConstraintKind>, String, Vec<Type>);

impl Checker<'_> {
    /// Adds a constraint, and solves it immediately if possible.
    pub fn constrain(&mut self, constraint: Constraint) {
        let outcome = self.try_solve(&constraint);
        let solved = match &outcome {
            Outcome::Solved => Some(true),
            Outcome::Open => None,
            Outcome::Failed(_) => Some(false),
        };
        rules::constraint(&constraint.kind, solved, |ty| self.store.shallow(ty));
        match outcome {
            Outcome::Solved => {}
            Outcome::Open => self.pending.push(constraint),
            Outcome::Failed(diagnostic) => self.report(*diagnostic),
        }
    }

    /// Solves constraints until no more can be solved.
    pub fn solve_constraints(&mut self) {
        loop {
            let before = self.pending.len();
            for constraint in std::mem::take(&mut self.pending) {
                self.constrain(constraint);
            }
            self.merge_constraints();
            if self.pending.len() >= before {
                return;
            }
        }
    }

    /// Solves the constraints on types before a decision depends on them. Known types cost nothing.
    pub fn solve_open_constraints<'t>(&mut self, types: impl Iterator<Item = &'t Type>) {
        let (mut unknown, mut dims) = Default::default();
        types.for_each(|ty| self.store.unknowns(ty, &mut unknown, &mut dims));
        if !unknown.is_empty() || !dims.is_empty() {
            self.solve_constraints();
        }
    }

    /// Merges equal constraints. The operands of an operator determine its result, so equal
    /// operands have equal results. Without merging, the schemes of functions that call each other
    /// twice would double at each level.
    fn merge_constraints(&mut self) {
        if self.pending.len() < 2 {
            return;
        }
        // The result of each constraint and its index.
        let mut seen: HashMap<ConstraintKey, (Type, usize)> = HashMap::default();
        for constraint in std::mem::take(&mut self.pending) {
            let kind = discriminant(&constraint.kind);
            let field = match &constraint.kind {
                Field(_, name, ..) => name.clone(),
                Styled(_, unit, digits) => format!("{unit:?}{digits}"),
                _ => String::new(),
            };
            let mut operands: Vec<Type> =
                constraint.types().into_iter().map(|ty| self.store.resolve(ty)).collect();
            let result = match &constraint.kind {
                Multiply(..) | Divide(..) | Index(..) | Field(..) => operands.pop(),
                Additive(_) | Comparable(_) | Printable(_) | Throwable(_) | Styled(..) => None,
            };
            match (seen.entry((kind, field, operands)), result) {
                (Entry::Vacant(entry), result) => {
                    entry.insert((result.unwrap_or(Type::Unit), self.pending.len()));
                    self.pending.push(constraint);
                }
                (Entry::Occupied(entry), Some(result)) => {
                    let (known, at) = entry.get();
                    if self.store.unify(known, &result).is_err() {
                        // Kept until its operands are known, when it is reported.
                        self.pending.push(constraint);
                    } else if let (Field(.., FieldUse::Assigned), Some(Field(.., field_use))) =
                        (&constraint.kind, self.pending.get_mut(*at).map(|merged| &mut merged.kind))
                    {
                        *field_use = FieldUse::Assigned;
                    }
                }
                (Entry::Occupied(_), None) => {}
            }
        }
    }

    /// Ends inference: types that no constraint determines are numbers.
    pub fn finish_constraints(&mut self) {
        self.solve_constraints();
        while let Some(constraint) = self.pending.first().cloned() {
            let unknown = constraint
                .types()
                .into_iter()
                .map(|ty| self.store.shallow(ty))
                .find(|ty| matches!(ty, Type::Unknown(_)));
            let Some(unknown) = unknown else {
                // A constraint on known types is always solved; this prevents an endless loop in
                // case of a defect.
                self.pending.remove(0);
                continue;
            };
            let number = match &constraint.kind {
                Index(..) => {
                    rules::applied(Rule::DefaultArray);
                    let element = self.store.fresh();
                    Type::array(element)
                }
                Field(_, name, ..) if matches!(name.as_str(), "x" | "y" | "z") => self.fresh_vector().0,
                Field(_, name, ..) => {
                    self.report(
                        Diagnostic::error(
                            "E0307",
                            format!("the type of the value with the field `{name}` is not known"),
                            constraint.span,
                            "unknown type",
                        )
                        .help("assign a record to the variable before using its fields"),
                    );
                    self.pending.remove(0);
                    continue;
                }
                _ => {
                    rules::applied(Rule::DefaultNumber);
                    self.fresh_number()
                }
            };
            if self.store.unify(&unknown, &number).is_err() {
                // No constraint determines the type, and an array would exceed the limits of the
                // types that contain it.
                self.report(too_large(constraint.span));
                self.pending.remove(0);
            }
            self.solve_constraints();
        }
    }

    fn fit(&mut self, constraint: &Constraint, a: &Type, b: &Type) -> Outcome {
        match self.store.unify(a, b) {
            Ok(()) => Outcome::Solved,
            Err(Mismatch::Infinite) => Outcome::failed(too_large(constraint.span)),
            Err(Mismatch::Kind) if matches!(self.store.known(b), Type::Observable(_)) => {
                Outcome::failed(self.observable_as_value(constraint.span))
            }
            Err(mismatch) => {
                let (found, wanted) = (with_article(&self.store.show(a)), with_article(&self.store.show(b)));
                let code = if matches!(mismatch, Mismatch::Dimension(..)) { "E0402" } else { "E0301" };
                Outcome::failed(
                    Diagnostic::error(
                        code,
                        format!("this is used as {found}, but it is {wanted}"),
                        constraint.span,
                        format!("gives {wanted}"),
                    )
                    .help("make both sides the same"),
                )
            }
        }
    }

    fn try_solve(&mut self, constraint: &Constraint) -> Outcome {
        match &constraint.kind {
            Multiply(a, b, c) => self.solve_product(a, b, c, constraint),
            Divide(a, b, c) => self.solve_quotient(a, b, c, constraint),
            Additive(a) => self.solve_additive(a, constraint),
            Comparable(a) => self.solve_comparable(a, constraint),
            Printable(a) => self.solve_printable(a, constraint),
            Styled(a, unit, digits) => self.styled(a.clone(), *unit, *digits, constraint),
            Field(base, name, result, field_use) => {
                self.solve_field(base, name, result, *field_use, constraint)
            }
            Throwable(a) => self.solve_throwable(a, constraint),
            Index(base, at, element) => self.solve_index(base, *at, element, constraint),
        }
    }

    /// Solves `a * b = c`.
    fn solve_product(&mut self, a: &Type, b: &Type, c: &Type, constraint: &Constraint) -> Outcome {
        let (left, right, result) = (self.store.shallow(a), self.store.shallow(b), self.store.shallow(c));
        let number = |d: Dim| Type::Number(d);
        let product = match (&left, &right) {
            (Type::Error, _) | (_, Type::Error) => Type::Error,
            (Type::Number(x), Type::Number(y)) => number(x.times(y)),
            (Type::Number(x), Type::Vector(y)) | (Type::Vector(x), Type::Number(y)) => {
                Type::Vector(x.times(y))
            }
            (Type::Number(_) | Type::Observable(_), Type::Array(element)) => {
                self.each_element(constraint, |part| Multiply(left.clone(), (**element).clone(), part))
            }
            (Type::Array(element), Type::Number(_) | Type::Observable(_)) => {
                self.each_element(constraint, |part| Multiply((**element).clone(), right.clone(), part))
            }
            (Type::Observable(x), Type::Observable(y) | Type::Number(y))
            | (Type::Number(x), Type::Observable(y)) => Type::Observable(x.times(y)),
            (Type::Transform, Type::Transform) => Type::Transform,
            (Type::Transform, Type::Vector(dim)) => {
                let length = super::length();
                if self.store.unify_dims(dim, &length).is_err() {
                    let found = with_article(&self.store.show(&right));
                    return Outcome::failed(
                        Diagnostic::error(
                            "E0401",
                            format!("a frame takes a point, a Vector(Length), not {found}"),
                            constraint.span,
                            "frame times vector",
                        )
                        .help("use `direction(frame, v)` for a vector that is not a point"),
                    );
                }
                Type::Vector(length)
            }
            (Type::Unknown(_), _) | (_, Type::Unknown(_)) => {
                // The result may determine the operands: a number is a product of numbers, a frame
                // of frames.
                let part = match result {
                    Type::Number(_) => None,
                    Type::Transform => Some(Type::Transform),
                    _ => return Outcome::Open,
                };
                for side in [&left, &right] {
                    let part = match &part {
                        Some(part) => part.clone(),
                        None => self.fresh_number(),
                    };
                    if let Outcome::Failed(diagnostic) = self.fit(constraint, side, &part) {
                        return Outcome::Failed(diagnostic);
                    }
                }
                return self.try_solve(constraint);
            }
            _ => {
                return Outcome::failed(self.bad_operands("multiply", "by", &left, &right, constraint));
            }
        };
        self.fit(constraint, c, &product)
    }

    /// Solves `a / b = c`.
    fn solve_quotient(&mut self, a: &Type, b: &Type, c: &Type, constraint: &Constraint) -> Outcome {
        let (left, right) = (self.store.shallow(a), self.store.shallow(b));
        if matches!(right, Type::Unknown(_)) {
            // Only numbers can be divisors.
            let divisor = self.fresh_number();
            let _ = self.store.unify(&right, &divisor);
        }
        let right = self.store.shallow(b);
        let quotient = match (&left, &right) {
            (Type::Error, _) | (_, Type::Error) => Type::Error,
            (Type::Number(x), Type::Number(y)) => Type::Number(x.over(y)),
            (Type::Vector(x), Type::Number(y)) => Type::Vector(x.over(y)),
            (Type::Array(element), Type::Number(_) | Type::Observable(_)) => {
                self.each_element(constraint, |part| Divide((**element).clone(), right.clone(), part))
            }
            (Type::Observable(x), Type::Observable(y) | Type::Number(y))
            | (Type::Number(x), Type::Observable(y)) => Type::Observable(x.over(y)),
            (Type::Unknown(_), _) => match self.store.shallow(c) {
                Type::Number(_) => {
                    let dividend = self.fresh_number();
                    let _ = self.store.unify(&left, &dividend);
                    return self.try_solve(constraint);
                }
                _ => return Outcome::Open,
            },
            _ => {
                return Outcome::failed(self.bad_operands("divide", "by", &left, &right, constraint));
            }
        };
        self.fit(constraint, c, &quotient)
    }

    /// Solves `base.name = result`.
    fn solve_field(
        &mut self,
        base: &Type,
        name: &str,
        result: &Type,
        field_use: FieldUse,
        constraint: &Constraint,
    ) -> Outcome {
        let is_assigned = field_use == FieldUse::Assigned;
        match self.store.shallow(base) {
            Type::Error => self.fit(constraint, result, &Type::Error),
            Type::Unknown(_) => Outcome::Open,
            Type::Vector(_) if is_assigned => Outcome::failed(component_assigned(name, constraint.span)),
            Type::Vector(dim) if matches!(name, "x" | "y" | "z") => {
                self.fit(constraint, result, &Type::Number(dim))
            }
            Type::Record(id) => match self.store.field(id, name) {
                Some((_, ty)) => match self.fixed_member(id, name).filter(|_| is_assigned) {
                    Some(kind) => Outcome::failed(member_assigned(kind, name, constraint.span)),
                    None => self.fit(constraint, result, &ty),
                },
                None => Outcome::failed(self.no_field(&Type::Record(id), name, constraint.span)),
            },
            other => Outcome::failed(self.no_field(&other, name, constraint.span)),
        }
    }

    /// Solves `base[at] = element`; `at` is the index if it is constant.
    fn solve_index(
        &mut self,
        base: &Type,
        at: Option<usize>,
        element: &Type,
        constraint: &Constraint,
    ) -> Outcome {
        match (self.store.shallow(base), at) {
            (Type::Error, _) => self.fit(constraint, element, &Type::Error),
            (Type::Unknown(_), _) => Outcome::Open,
            (Type::Array(inner), _) => self.fit(constraint, element, &inner),
            (Type::Tuple(parts), Some(at)) => match parts.get(at) {
                Some(part) => self.fit(constraint, element, part),
                None => Outcome::failed(
                    Diagnostic::error(
                        "E0305",
                        format!("this tuple has {} elements, so there is no element {at}", parts.len()),
                        constraint.span,
                        "index out of range",
                    )
                    .help("indices start at 0"),
                ),
            },
            (Type::Tuple(_), None) => Outcome::failed(
                Diagnostic::error(
                    "E0305",
                    "the index of a tuple must be a constant whole number",
                    constraint.span,
                    "its elements have different types",
                )
                .help("make the elements the same type to get an array"),
            ),
            (other, _) => self.unsupported(
                "E0305",
                &other,
                "cannot be indexed",
                "only arrays and tuples can be indexed",
                constraint,
            ),
        }
    }

    /// Returns the error for an operation that values of a type do not support. `problem` follows
    /// the type in the message.
    fn unsupported(
        &self,
        code: &str,
        ty: &Type,
        problem: &str,
        help: &str,
        constraint: &Constraint,
    ) -> Outcome {
        let shown = with_article(&self.store.show(ty));
        let message = format!("{shown} {problem}");
        let label = format!("this is {shown}");
        Outcome::failed(Diagnostic::error(code, message, constraint.span, label).help(help))
    }

    fn bad_operands(
        &self,
        verb: &str,
        preposition: &str,
        left: &Type,
        right: &Type,
        constraint: &Constraint,
    ) -> Diagnostic {
        if matches!(left, Type::Observable(_)) || matches!(right, Type::Observable(_)) {
            return self.observable_as_value(constraint.span);
        }
        let (l, r) = (self.store.show(left), self.store.show(right));
        let help = match (left, right) {
            (Type::Vector(_), Type::Vector(_)) if verb == "multiply" => "use `dot(a, b)` or `cross(a, b)`",
            (Type::Vector(_), Type::Transform) => "write the frame first: `frame * point`",
            (_, Type::Transform) if verb == "divide" => "multiply by `inverse(frame)`",
            (Type::Array(_), Type::Array(_)) if verb == "multiply" => {
                "multiply the elements in a comprehension: `[a[i] * b[i] for i in 0 .. len(a)]`"
            }
            _ => {
                "numbers multiply and divide numbers, vectors and arrays of them; frames multiply frames and points"
            }
        };
        Diagnostic::error(
            "E0304",
            format!("cannot {verb} {} {preposition} {}", with_article(&l), with_article(&r)),
            constraint.span,
            format!("{l} and {r}"),
        )
        .help(help)
    }
}
