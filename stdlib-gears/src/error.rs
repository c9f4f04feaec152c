//! Errors and warnings about gears and pairs, as data: the front end locates them at the argument
//! to blame.

use calyx_runtime::error::{EngineError, Subject};
use std::fmt;

/// Severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// The gear is impossible, or the pair cannot run.
    Error,
    /// The gear can be made and run, but the user should know of the finding.
    Warning,
}

/// Part of a sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// Literal text.
    Text(&'static str),
    /// Length, m.
    Length(f64),
    /// Angle, rad.
    Angle(f64),
    /// Dimensionless number.
    Number(f64),
    /// Lower bound: its digits are rounded up so that the printed value suffices.
    AtLeast(Box<Part>),
    /// Upper bound: its digits are rounded down so that the printed value is still permitted.
    AtMost(Box<Part>),
}

/// Sentence with quantities, which are printed in the reader's unit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sentence(pub Vec<Part>);

impl Sentence {
    /// Formats the sentence with lengths in a unit, given by its name and its size in metres.
    pub fn in_unit<'a>(&'a self, unit: &'a str, metres: f64) -> impl fmt::Display + 'a {
        Rendered { sentence: self, unit, metres }
    }
}

/// Formats lengths in millimetres and angles in degrees.
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
        self.sentence.0.iter().try_for_each(|part| self.write(f, part, Rounding::Nearest))
    }
}

impl Rendered<'_> {
    fn write(&self, f: &mut fmt::Formatter<'_>, part: &Part, rounding: Rounding) -> fmt::Result {
        match part {
            Part::Text(text) => f.write_str(text),
            Part::Length(length) => {
                write!(f, "{} {}", digits(length / self.metres, rounding), self.unit)
            }
            Part::Angle(angle) => write!(f, "{} deg", digits(angle.to_degrees(), rounding)),
            Part::Number(number) => f.write_str(&digits(*number, rounding)),
            Part::AtLeast(part) => self.write(f, part, Rounding::Up),
            Part::AtMost(part) => self.write(f, part, Rounding::Down),
        }
    }
}

#[derive(Clone, Copy)]
enum Rounding {
    Nearest,
    Up,
    Down,
}

/// Formats a number with five significant digits, without trailing zeros.
fn digits(value: f64, rounding: Rounding) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let magnitude = value.abs().log10().floor();
    let scientific = !(-5.0..9.0).contains(&magnitude);
    let decimals = (4.0 - magnitude).max(0.0) as usize;
    let written = |value: f64| {
        if scientific { format!("{value:.4e}") } else { format!("{value:.decimals$}") }
    };
    let step = if scientific { 10_f64.powf(magnitude - 4.0) } else { 10_f64.powi(-(decimals as i32)) };
    let mut text = written(value);
    let nearest: f64 = text.parse().unwrap_or(value);
    match rounding {
        Rounding::Up if nearest < value => text = written(nearest + step),
        Rounding::Down if nearest > value => text = written(nearest - step),
        _ => {}
    }
    if scientific || !text.contains('.') {
        return text;
    }
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Finding about a gear or a pair.
#[derive(Clone, Debug, PartialEq)]
pub struct GeometryError {
    /// Stable code: `E0601` and so on.
    pub code: &'static str,
    /// Severity, which decides whether it stops the model.
    pub severity: Severity,
    /// Name of the argument to blame, as in the library's `rack`, `external`, `tip_relief`,
    /// `simple_rim` or `mesh`.
    pub argument: &'static str,
    /// Object of the scene whose creation has the argument; `None` for the current call.
    pub subject: Option<Subject>,
    /// Statement of the problem.
    pub message: Sentence,
    /// Remedy.
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
        Self { code, severity: Severity::Error, argument, subject: None, message, help }
    }

    pub(crate) fn warning(
        code: &'static str,
        argument: &'static str,
        message: Sentence,
        help: Sentence,
    ) -> Self {
        Self { code, severity: Severity::Warning, argument, subject: None, message, help }
    }

    /// Attributes the finding to the call that created an object of the scene.
    #[must_use]
    pub(crate) fn about(self, subject: Subject) -> Self {
        Self { subject: Some(subject), ..self }
    }
}

/// Reason for the rejection of a gear, a body or a mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Refusal {
    /// All errors of the geometry that can be detected together; not empty.
    Geometry(Vec<GeometryError>),
    /// Error of the scene or the engine.
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

/// Builds a [`Sentence`] from texts and quantities: `sentence!["the tip is ", length t, " thick"]`.
macro_rules! sentence {
    (@ [$($part:expr,)*]) => {
        $crate::error::Sentence(vec![$($part),*])
    };
    (@ [$($part:expr,)*] at_least length $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [
            $($part,)* $crate::error::Part::AtLeast(Box::new($crate::error::Part::Length($value))),
        ] $($($rest)*)?)
    };
    (@ [$($part:expr,)*] at_least number $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [
            $($part,)* $crate::error::Part::AtLeast(Box::new($crate::error::Part::Number($value))),
        ] $($($rest)*)?)
    };
    (@ [$($part:expr,)*] at_most length $value:expr $(, $($rest:tt)*)?) => {
        $crate::error::sentence!(@ [
            $($part,)* $crate::error::Part::AtMost(Box::new($crate::error::Part::Length($value))),
        ] $($($rest)*)?)
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

    #[test]
    fn bounds_are_rounded_to_the_safe_side() {
        let bounds = sentence![at_least length 1.000_000_1e-3, " and ", at_most length 0.999_999_9e-3];
        assert_eq!(bounds.to_string(), "1.0001 mm and 0.99999 mm");
        let bounds =
            sentence![at_least number 0.123_451, ", ", at_least number 2.5, ", ", at_least number -0.3333333];
        assert_eq!(bounds.to_string(), "0.12346, 2.5, -0.33333");
        assert_eq!(sentence![at_least number 1.234_51e-9].to_string(), "1.2346e-9");
    }
}
