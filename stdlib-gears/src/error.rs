//! What can be wrong with a gear or a pair of gears, as data: the front end places it on the argument to blame.

use calyx_runtime::error::EngineError;
use std::fmt;

/// How bad a finding is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// There is no such gear, or it cannot run.
    Error,
    /// It can be made and run, but an engineer should know.
    Warning,
}

/// A piece of a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// As it stands.
    Text(&'static str),
    /// Metres.
    Length(f64),
    /// Radians.
    Angle(f64),
    /// Of no dimension.
    Number(f64),
}

/// A sentence with quantities in it, which are written in the unit of whoever reads it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sentence(pub Vec<Part>);

impl Sentence {
    /// The sentence with lengths in a unit: its name, and what it is in metres.
    pub fn in_unit<'a>(&'a self, unit: &'a str, metres: f64) -> impl fmt::Display + 'a {
        Rendered { sentence: self, unit, metres }
    }
}

/// In millimetres and degrees.
impl fmt::Display for Sentence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.in_unit("mm", 1e-3).fmt(f)
    }
}

struct Rendered<'a> {
    sentence: &'a Sentence,
    unit: &'a str,
    metres: f64,
}

impl fmt::Display for Rendered<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for part in &self.sentence.0 {
            match part {
                Part::Text(text) => f.write_str(text)?,
                Part::Length(length) => write!(f, "{} {}", Digits(length / self.metres), self.unit)?,
                Part::Angle(angle) => write!(f, "{} deg", Digits(angle.to_degrees()))?,
                Part::Number(number) => write!(f, "{}", Digits(*number))?,
            }
        }
        Ok(())
    }
}

/// A number with five significant digits and no more zeros than needed.
struct Digits(f64);

impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.0;
        if value == 0.0 || !value.is_finite() {
            return write!(f, "{value}");
        }
        let magnitude = value.abs().log10().floor();
        if !(-5.0..9.0).contains(&magnitude) {
            return write!(f, "{value:.4e}");
        }
        let decimals = (4.0 - magnitude).max(0.0) as usize;
        let text = format!("{value:.decimals$}");
        f.write_str(if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text })
    }
}

/// A finding about a gear or a pair.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometryError {
    /// Stable: `E0601` and so on.
    pub code: &'static str,
    /// Whether it stops the model.
    pub severity: Severity,
    /// Name of the argument to blame, as the library's `rack`, `external`, `tip_relief`, `simple_rim` or `mesh` call it.
    pub argument: &'static str,
    /// What is the matter.
    pub message: Sentence,
    /// What to do about it.
    pub help: Sentence,
}

impl fmt::Display for GeometryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}): {}; {}", self.code, self.argument, self.message, self.help)
    }
}

impl std::error::Error for GeometryError {}

impl GeometryError {
    pub(crate) fn error(
        code: &'static str,
        argument: &'static str,
        message: Sentence,
        help: Sentence,
    ) -> Self {
        Self { code, severity: Severity::Error, argument, message, help }
    }

    pub(crate) fn warning(
        code: &'static str,
        argument: &'static str,
        message: Sentence,
        help: Sentence,
    ) -> Self {
        Self { code, severity: Severity::Warning, argument, message, help }
    }
}

/// Why a gear, a body or a mesh is refused.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// Everything that is wrong with the geometry, as far as it can be told at once; not empty.
    Geometry(Vec<GeometryError>),
    /// What the scene or the engine has against it.
    Engine(EngineError),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Refusal::Geometry(findings) => {
                for (index, finding) in findings.iter().enumerate() {
                    write!(f, "{}{finding}", if index == 0 { "" } else { "\n" })?;
                }
                Ok(())
            }
            Refusal::Engine(error) => write!(f, "{}: {error}; {}", error.code, error.help),
        }
    }
}

impl std::error::Error for Refusal {}

impl From<GeometryError> for Refusal {
    fn from(error: GeometryError) -> Self {
        Refusal::Geometry(vec![error])
    }
}

impl From<Vec<GeometryError>> for Refusal {
    fn from(errors: Vec<GeometryError>) -> Self {
        Refusal::Geometry(errors)
    }
}

impl From<EngineError> for Refusal {
    fn from(error: EngineError) -> Self {
        Refusal::Engine(error)
    }
}

/// A [`Sentence`] from texts and quantities: `sentence!["the tip is ", length t, " thick"]`.
macro_rules! sentence {
    (@ [$($part:expr,)*]) => {
        $crate::error::Sentence(vec![$($part),*])
    };
    (@ [$($part:expr,)*] length $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [$($part,)* $crate::error::Part::Length($value),] $($($rest)*)?)
    };
    (@ [$($part:expr,)*] angle $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [$($part,)* $crate::error::Part::Angle($value),] $($($rest)*)?)
    };
    (@ [$($part:expr,)*] number $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [$($part,)* $crate::error::Part::Number($value),] $($($rest)*)?)
    };
    (@ [$($part:expr,)*] text $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [$($part,)* $crate::error::Part::Text($value),] $($($rest)*)?)
    };
    (@ [$($part:expr,)*] $text:literal $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [$($part,)* $crate::error::Part::Text($text),] $($($rest)*)?)
    };
    ($($parts:tt)*) => {
        $crate::error::sentence!(@ [] $($parts)*)
    };
}
pub(crate) use sentence;

#[cfg(test)]
mod tests {
    #[test]
    fn sentences_are_written_in_the_readers_unit() {
        let sentence =
            sentence!["a tip ", length 0.00254, " thick at ", angle 0.5, " of ", number 20.0, " teeth"];
        assert_eq!(sentence.to_string(), "a tip 2.54 mm thick at 28.648 deg of 20 teeth");
        assert_eq!(
            sentence.in_unit("inch", 0.0254).to_string(),
            "a tip 0.1 inch thick at 28.648 deg of 20 teeth"
        );
    }
}
