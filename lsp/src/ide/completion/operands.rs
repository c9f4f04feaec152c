//! Types of the expressions before the cursor, inferred from tokens with the types of known names:
//! the statement may have no tree yet.

use super::request::Request;
use crate::ide::callee;
use crate::ide::shape::Shape;
use calyx_lang::analysis::{CallParameter, NameKind, Visible};
use calyx_lang::dimension::{Dimension, Rational};
use calyx_lang::lexer::Kind;
use calyx_lang::units::Unit;
use std::ops::Range;

impl Request<'_> {
    /// Returns the type of the expression of some tokens.
    pub fn shape_of(&self, tokens: &Range<usize>) -> Shape {
        let around = &self.context.around;
        if tokens.is_empty() {
            return Shape::Unknown;
        }
        if let Some(dimension) = self.quantity(tokens) {
            return Shape::Number(Some(dimension));
        }
        match around.kind(tokens.start) {
            Some(Kind::True | Kind::False) => return Shape::truth(),
            Some(Kind::StringOpen) => return Shape::text(),
            _ => {}
        }
        self.sum(tokens)
    }

    /// Infers the types of new names, which the last check does not know.
    pub fn infer(&mut self) {
        /// Largest number of new names between two checks.
        const MOST: usize = 20;
        let unknown = |known: &Visible| {
            let value = matches!(
                known.kind,
                NameKind::Variable | NameKind::Symbolic | NameKind::Param | NameKind::Const
            );
            value && known.ty.is_none()
        };
        let new: Vec<usize> = self
            .visible
            .iter()
            .enumerate()
            .filter(|(_, known)| unknown(known))
            .map(|(at, _)| at)
            .take(MOST)
            .collect();
        // In order of declaration: later ones may use earlier ones.
        for at in new.into_iter().rev() {
            let shown =
                self.visible.get(at).and_then(|known| self.declared(known)).and_then(|shape| shape.shown());
            if let (Some(known), Some(shown)) = (self.visible.get_mut(at), shown) {
                known.ty = Some(shown.into());
            }
        }
    }

    /// Returns the type of the initial value of a declaration.
    fn declared(&self, known: &Visible) -> Option<Shape> {
        let around = &self.context.around;
        let place = known.declared.as_ref().filter(|place| *place.file == *self.file)?;
        let name = around.token_at(place.start as usize);
        if !matches!(around.kind(name + 1), Some(Kind::Assign | Kind::Bind)) {
            return None;
        }
        let start = name + 2;
        let mut depth = 0_usize;
        let mut end = start;
        while let Some(kind) = around.kind(end) {
            match kind {
                Kind::OpenParen | Kind::OpenBracket => depth += 1,
                Kind::CloseParen | Kind::CloseBracket => depth = depth.saturating_sub(1),
                Kind::Comma | Kind::In if depth == 0 => break,
                Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace => break,
                _ if kind.begins_statement() => break,
                _ => {}
            }
            end += 1;
        }
        Some(self.shape_of(&(start..end)))
    }

    /// Returns the type of a sum, which is that of its last term, or of a comparison, which is
    /// Boolean.
    fn sum(&self, tokens: &Range<usize>) -> Shape {
        let around = &self.context.around;
        let mut term = tokens.start;
        let mut depth = 0_usize;
        for at in tokens.clone() {
            match around.kind(at) {
                Some(Kind::OpenParen | Kind::OpenBracket | Kind::StringOpen) => depth += 1,
                Some(Kind::CloseParen | Kind::CloseBracket | Kind::StringClose) => {
                    depth = depth.saturating_sub(1)
                }
                Some(
                    Kind::Less
                    | Kind::LessEqual
                    | Kind::Greater
                    | Kind::GreaterEqual
                    | Kind::Equal
                    | Kind::NotEqual
                    | Kind::And
                    | Kind::Or
                    | Kind::Not,
                ) if depth == 0 => return Shape::truth(),
                Some(Kind::Plus | Kind::Minus) if depth == 0 => term = at + 1,
                _ => {}
            }
        }
        self.product(&(term..tokens.end))
    }

    /// Returns the type of a product or quotient of names, calls, elements and quantities.
    fn product(&self, tokens: &Range<usize>) -> Shape {
        let around = &self.context.around;
        let mut at = tokens.start;
        let mut whole: Option<Shape> = None;
        let mut divides = false;
        loop {
            let end = self.factor_end(at, tokens.end);
            let factor = at..end;
            let shape = match self.quantity(&factor) {
                Some(dimension) => Shape::Number(Some(dimension)),
                None => self.postfix(&factor),
            };
            whole = Some(match whole {
                None => shape,
                Some(left) => multiplied(&left, &shape, divides),
            });
            match around.kind(end).filter(|_| end < tokens.end) {
                Some(Kind::Star) => divides = false,
                Some(Kind::Slash) => divides = true,
                None => return whole.unwrap_or(Shape::Unknown),
                Some(_) => return Shape::Unknown,
            }
            at = end + 1;
        }
    }

    /// Returns the `*` or `/` after the factor that starts at `start`, or the end.
    fn factor_end(&self, start: usize, end: usize) -> usize {
        let around = &self.context.around;
        let mut depth = 0_usize;
        for at in start..end {
            match around.kind(at) {
                Some(Kind::OpenParen | Kind::OpenBracket | Kind::StringOpen) => depth += 1,
                Some(Kind::CloseParen | Kind::CloseBracket | Kind::StringClose) => {
                    depth = depth.saturating_sub(1)
                }
                Some(Kind::Star | Kind::Slash) if depth == 0 && at > start => return at,
                _ => {}
            }
        }
        end
    }

    /// Returns the type of a name with members, arguments and indices.
    fn postfix(&self, tokens: &Range<usize>) -> Shape {
        let around = &self.context.around;
        match around.kind(tokens.start) {
            Some(Kind::Identifier) => {}
            Some(Kind::OpenParen) if around.opening(tokens.end.saturating_sub(1)) == Some(tokens.start) => {
                return self.shape_of(&(tokens.start + 1..tokens.end - 1));
            }
            Some(Kind::OpenBracket) if around.opening(tokens.end.saturating_sub(1)) == Some(tokens.start) => {
                let end = (tokens.start + 1..tokens.end).find(|&at| around.kind(at) == Some(Kind::Comma));
                let first = tokens.start + 1..end.unwrap_or(tokens.end - 1);
                return match self.shape_of(&first) {
                    Shape::Unknown => Shape::Unknown,
                    element => Shape::Array(Box::new(element)),
                };
            }
            _ => return Shape::Unknown,
        }
        let mut path = vec![around.source(tokens.start).to_string()];
        let known = self.find(&path[0]);
        let mut shape = match known {
            Some(known) if known.kind == NameKind::Module => Shape::Unknown,
            Some(known) => known.ty.as_deref().map_or(Shape::Unknown, Shape::read),
            None => return Shape::Unknown,
        };
        let mut at = tokens.start + 1;
        while at < tokens.end {
            match around.kind(at) {
                Some(Kind::Dot) => {
                    let member = around.source(at + 1);
                    path.push(member.to_string());
                    shape = self.part(&shape, member);
                    at += 2;
                }
                Some(open @ (Kind::OpenParen | Kind::OpenBracket)) => {
                    shape = match (open, shape) {
                        (Kind::OpenParen, _) => self.result(&path),
                        (_, Shape::Array(element)) => *element,
                        _ => Shape::Unknown,
                    };
                    path.clear();
                    let Some(close) = (at + 1..tokens.end).find(|&close| around.opening(close) == Some(at))
                    else {
                        return Shape::Unknown;
                    };
                    at = close + 1;
                }
                _ => return Shape::Unknown,
            }
        }
        shape
    }

    fn result(&self, path: &[String]) -> Shape {
        let callable = callee::callable(self.database, &self.visible, path);
        callable.and_then(|callable| callable.result).map_or(Shape::Unknown, |result| Shape::read(&result))
    }

    fn part(&self, shape: &Shape, name: &str) -> Shape {
        match shape {
            Shape::Vector(dimension) => Shape::Number(*dimension),
            shape => {
                let fields = self.fields(shape).unwrap_or_default();
                let field = fields.iter().find(|field| *field.name == *name);
                field.map_or(Shape::Unknown, |field| Shape::read(&field.ty))
            }
        }
    }

    /// Returns the fields of a name whose value is a record.
    pub fn fields_of(&self, name: &str) -> Option<Vec<CallParameter>> {
        callee::fields_of(self.database, &self.visible, name)
    }

    /// Returns the fields of a record type.
    pub fn fields(&self, shape: &Shape) -> Option<Vec<CallParameter>> {
        callee::fields(self.database, &self.visible, shape)
    }

    /// Returns the dimension of a product of numbers and units only.
    pub fn quantity(&self, tokens: &Range<usize>) -> Option<Dimension> {
        let around = &self.context.around;
        let mut whole = Dimension::NONE;
        let mut divides = false;
        let mut at = tokens.start;
        while at < tokens.end {
            let mut factor = Dimension::NONE;
            if around.kind(at) == Some(Kind::Number) {
                at += 1;
            } else if self.find(around.source(at)).is_some() {
                return None;
            }
            if matches!(around.kind(at), Some(Kind::Identifier | Kind::Percent)) && at < tokens.end {
                factor = self.unit(around.source(at))?;
                at += 1;
                if around.kind(at) == Some(Kind::Caret) && at + 1 < tokens.end {
                    let negative = around.kind(at + 1) == Some(Kind::Minus);
                    let digits = at + 1 + usize::from(negative);
                    let exponent: i64 = around.source(digits).parse().ok()?;
                    factor = factor.power(Rational::new(if negative { -exponent } else { exponent }, 1)?)?;
                    at = digits + 1;
                }
            }
            whole = if divides { whole.over(factor) } else { whole.times(factor) };
            match around.kind(at).filter(|_| at < tokens.end) {
                Some(Kind::Star) => divides = false,
                Some(Kind::Slash) => divides = true,
                None => break,
                Some(_) => return None,
            }
            at += 1;
        }
        Some(whole)
    }

    /// Returns the dimension of a unit, builtin or declared.
    pub fn unit(&self, name: &str) -> Option<Dimension> {
        Unit::find(name).map(|unit| unit.dimension)
    }
}

/// Returns the type of a product or quotient, as far as its factors determine it.
fn multiplied(left: &Shape, right: &Shape, divides: bool) -> Shape {
    let dimension = |left: &Option<Dimension>, right: &Option<Dimension>| {
        left.zip(*right).map(|(left, right)| if divides { left.over(right) } else { left.times(right) })
    };
    match (left, right) {
        (Shape::Number(a), Shape::Number(b)) => Shape::Number(dimension(a, b)),
        (Shape::Vector(a), Shape::Number(b)) => Shape::Vector(dimension(a, b)),
        (Shape::Number(a), Shape::Vector(b)) if !divides => Shape::Vector(dimension(a, b)),
        (Shape::Observable(a), Shape::Observable(b) | Shape::Number(b)) => Shape::Observable(dimension(a, b)),
        (Shape::Number(a), Shape::Observable(b)) => Shape::Observable(dimension(a, b)),
        (Shape::Named(frame), Shape::Named(_) | Shape::Vector(_)) if frame == "Transform" => right.clone(),
        _ => Shape::Unknown,
    }
}
