//! Types parsed from their display form, as far as needed to match values with expected types.

use calyx_lang::dimension::{Dimension, Rational};

/// A type, as far as its display form determines it.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Unknown, or determined by use.
    Unknown,
    Number(Option<Dimension>),
    Vector(Option<Dimension>),
    Observable(Option<Dimension>),
    Array(Box<Shape>),
    /// `Bool`, `String`, `Transform`, a record, or a type of the library.
    Named(String),
}

/// Quality of a match of a value with an expected type, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Fit {
    Exactly,
    /// Not enough is known.
    Perhaps,
    /// Not alone, but as a part of the expression: another factor, a component, an element.
    InPart,
    Not,
}

impl Shape {
    /// Parses the type of a value.
    pub fn read(text: &str) -> Shape {
        let text = text.trim();
        // A value fits where it is optional.
        let text = text.strip_suffix(" or none").unwrap_or(text);
        if let Some((head, inner)) = applied(text) {
            return match head {
                "Vector" => Shape::Vector(dimension(inner)),
                "Observable" => Shape::Observable(dimension(inner)),
                "Array" => Shape::Array(Box::new(Shape::read(inner))),
                "Symbolic" => Shape::read(inner),
                _ => Shape::Unknown,
            };
        }
        if let Some(known) = dimension(text) {
            return Shape::Number(Some(known));
        }
        match text {
            "" | "_" => Shape::Unknown,
            "Vector" => Shape::Vector(Some(Dimension::NONE)),
            "Array" => Shape::Array(Box::new(Shape::Unknown)),
            _ if text.contains("->") || text.starts_with('(') => Shape::Unknown,
            _ if text.starts_with('[') => Shape::Named(text.to_string()),
            // `T` is any type, `a` any dimension.
            _ if text.len() == 1 && text.starts_with(char::is_uppercase) => Shape::Unknown,
            _ if text.starts_with(char::is_uppercase) && !text.contains(['*', '/', '^']) => {
                Shape::Named(text.to_string())
            }
            _ => Shape::Number(None),
        }
    }

    /// Returns the result type of a function type: `(in x: Length) -> Area`.
    pub fn result(scheme: &str) -> Shape {
        match scheme.rsplit_once(") -> ") {
            Some((_, result)) => Shape::read(result.split(" where ").next().unwrap_or(result)),
            None => Shape::Named("nothing".to_string()),
        }
    }

    /// Formats the type; `None` if it is unknown.
    pub fn shown(&self) -> Option<String> {
        Some(match self {
            Shape::Unknown => return None,
            Shape::Number(dimension) => (*dimension)?.to_string(),
            Shape::Vector(dimension) => match (*dimension)? {
                dimension if dimension.is_none() => "Vector".to_string(),
                dimension => format!("Vector({dimension})"),
            },
            Shape::Observable(dimension) => format!("Observable({})", (*dimension)?),
            Shape::Array(element) => format!("Array({})", element.shown()?),
            Shape::Named(name) => name.clone(),
        })
    }

    pub fn number() -> Shape {
        Shape::Number(Some(Dimension::NONE))
    }

    pub fn truth() -> Shape {
        Shape::Named("Bool".to_string())
    }

    pub fn text() -> Shape {
        Shape::Named("String".to_string())
    }

    pub fn frame() -> Shape {
        Shape::Named("Transform".to_string())
    }

    pub fn is(&self, name: &str) -> bool {
        matches!(self, Shape::Named(own) if own == name)
    }

    /// Returns the dimension of a number, a vector or an observable.
    pub fn dimension(&self) -> Option<Dimension> {
        match self {
            Shape::Number(dimension) | Shape::Vector(dimension) | Shape::Observable(dimension) => *dimension,
            _ => None,
        }
    }

    /// Returns how well a value of type `found` matches this expected type.
    pub fn fit(&self, found: &Shape) -> Fit {
        let alike = |a: &Option<Dimension>, b: &Option<Dimension>| match (a, b) {
            (Some(a), Some(b)) if a == b => Fit::Exactly,
            // A radian is 1, but an angle is seldom meant where a number is expected.
            (Some(a), Some(b)) if a.fits(*b) => Fit::Perhaps,
            (Some(_), Some(_)) => Fit::InPart,
            _ => Fit::Perhaps,
        };
        match (self, found) {
            (Shape::Unknown, _) | (_, Shape::Unknown) => Fit::Perhaps,
            // An output accepts any observable.
            (Shape::Observable(None), Shape::Observable(_)) => Fit::Exactly,
            (Shape::Number(a), Shape::Number(b))
            | (Shape::Vector(a), Shape::Vector(b))
            | (Shape::Observable(a), Shape::Observable(b)) => alike(a, b),
            (Shape::Array(a), Shape::Array(b)) => a.fit(b),
            (Shape::Named(a), Shape::Named(b)) if a == b => Fit::Exactly,
            // Multiplied by a direction it has the expected type.
            (Shape::Vector(a), Shape::Number(b)) if alike(a, b) == Fit::Exactly => Fit::Perhaps,
            // A number times a direction; a component; an observable times a number.
            (Shape::Vector(_) | Shape::Observable(_), Shape::Number(_)) => Fit::InPart,
            (Shape::Number(_), Shape::Vector(_)) => Fit::InPart,
            (wanted, Shape::Array(element)) => match wanted.fit(element) {
                Fit::Exactly => Fit::InPart,
                _ => Fit::Not,
            },
            _ => Fit::Not,
        }
    }
}

/// Splits a type application: `Vector(Force)` into `Vector` and `Force`.
fn applied(text: &str) -> Option<(&str, &str)> {
    let (head, rest) = text.split_once('(')?;
    let inner = rest.strip_suffix(')')?;
    head.chars().all(char::is_alphabetic).then_some((head, inner)).filter(|(head, _)| !head.is_empty())
}

/// Parses the dimension of a product of names: `Force/Length^2`, `Length^(1/2)`, `1/Time`.
pub fn dimension(text: &str) -> Option<Dimension> {
    let mut whole = Dimension::NONE;
    let mut divides = false;
    let mut rest = text.trim();
    loop {
        // An exponent may contain a slash, in parentheses.
        let mut depth = 0_i32;
        let end = rest.find(|c: char| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            depth == 0 && (c == '*' || c == '/')
        });
        let factor = rest.get(..end.unwrap_or(rest.len()))?.trim();
        let (name, exponent) = factor.split_once('^').unwrap_or((factor, "1"));
        let base = if name == "1" { Dimension::NONE } else { Dimension::from_name(name.trim())? };
        let powered = base.power(rational(exponent)?)?;
        whole = if divides { whole.over(powered) } else { whole.times(powered) };
        let Some(end) = end else { return Some(whole) };
        divides = rest.get(end..)?.starts_with('/');
        rest = rest.get(end + 1..)?;
    }
}

fn rational(text: &str) -> Option<Rational> {
    let text = text.trim().trim_start_matches('(').trim_end_matches(')');
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    Rational::new(above.trim().parse().ok()?, below.trim().parse().ok()?)
}

#[cfg(test)]
mod tests {
    use super::{Fit, Shape, dimension};

    #[test]
    fn types_fit_as_the_checker_says() {
        for (wanted, found, fit) in [
            ("Length", "Length", Fit::Exactly),
            ("Torque", "Moment", Fit::Exactly),
            ("Number", "Angle", Fit::Perhaps),
            ("Length", "Force", Fit::InPart),
            ("Length", "a", Fit::Perhaps),
            ("Length", "Vector(Length)", Fit::InPart),
            ("Length", "Array(Length)", Fit::InPart),
            ("Length", "Array(Force)", Fit::Not),
            ("Vector(Moment)", "Moment", Fit::Perhaps),
            ("Vector(Moment)", "Force", Fit::InPart),
            ("Array(Modification)", "Modification", Fit::Not),
            ("Symbolic(Transform)", "Transform", Fit::Exactly),
            ("Gear", "Body", Fit::Not),
            ("Gear", "T", Fit::Perhaps),
            ("Observable(Angle)", "Observable(Pressure)", Fit::InPart),
        ] {
            assert_eq!(Shape::read(wanted).fit(&Shape::read(found)), fit, "{wanted} {found}");
        }
    }

    #[test]
    fn dimensions_read_back_as_they_are_shown() {
        for text in ["Force/Length^2", "1/Time", "Length^(1/2)", "Length*Mass/Time^2/Angle"] {
            assert!(dimension(text).is_some(), "{text}");
        }
        assert_eq!(dimension("Force/Length^2"), dimension("Pressure"));
        assert_eq!(dimension("Cost"), None);
        assert_eq!(Shape::result("(in x: Length) -> Area"), Shape::read("Area"));
    }
}
