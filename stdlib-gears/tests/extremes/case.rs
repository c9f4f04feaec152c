//! A case: what is driven how far, and what is expected.

use calyx_gears::error::GeometryError;
use calyx_runtime::error::EngineError;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// What happens at an edge.
pub struct Case {
    pub method: &'static str,
    /// The values.
    pub driven: &'static str,
    pub outcome: Outcome,
}

pub enum Outcome {
    /// The largest relative error against a truth stays below a bound.
    Holds { to: f64, truth: &'static str, error: fn() -> f64 },
    /// It is refused with a code, a reason with these words in it, and a remedy.
    Refused { code: &'static str, says: &'static str, why: &'static str, refusal: fn() -> Option<Refusal> },
    /// It is solved, and a warning of the result says what is wrong: its words.
    Told { says: &'static str, why: &'static str, warnings: fn() -> Vec<String> },
}

/// What a refusal consists of.
#[derive(Debug)]
pub struct Refusal {
    pub code: String,
    pub message: String,
    pub help: String,
}

impl From<EngineError> for Refusal {
    fn from(error: EngineError) -> Self {
        Refusal { code: error.code.into(), message: error.message, help: error.help }
    }
}

impl From<GeometryError> for Refusal {
    fn from(error: GeometryError) -> Self {
        Refusal { code: error.code.into(), message: error.message.to_string(), help: error.help.to_string() }
    }
}

impl From<calyx_gears::error::Refusal> for Refusal {
    fn from(refusal: calyx_gears::error::Refusal) -> Self {
        match refusal {
            calyx_gears::error::Refusal::Engine(error) => error.into(),
            calyx_gears::error::Refusal::Geometry(mut findings) => findings.remove(0).into(),
        }
    }
}

/// What was refused of something that should be.
pub fn refusal<T, E: Into<Refusal>>(result: Result<T, E>) -> Option<Refusal> {
    result.err().map(Into::into)
}

/// The largest of some errors; one that is no number counts as infinite.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors
        .into_iter()
        .fold(0.0, |worst, error| if error.is_nan() { f64::INFINITY } else { error.abs().max(worst) })
}

/// By how much a number is off a known one, relative to it.
pub fn off(found: f64, known: f64) -> f64 {
    (found - known).abs() / known.abs()
}

impl Case {
    pub fn holds(
        method: &'static str,
        driven: &'static str,
        to: f64,
        truth: &'static str,
        error: fn() -> f64,
    ) -> Case {
        Case { method, driven, outcome: Outcome::Holds { to, truth, error } }
    }

    pub fn refused(
        method: &'static str,
        driven: &'static str,
        code: &'static str,
        why: &'static str,
        refusal: fn() -> Option<Refusal>,
    ) -> Case {
        Case { method, driven, outcome: Outcome::Refused { code, says: "", why, refusal } }
    }

    /// The same of one that is refused: with these words.
    pub fn saying(mut self, words: &'static str) -> Case {
        if let Outcome::Refused { says, .. } = &mut self.outcome {
            *says = words;
        }
        self
    }

    pub fn told(
        method: &'static str,
        driven: &'static str,
        says: &'static str,
        why: &'static str,
        warnings: fn() -> Vec<String>,
    ) -> Case {
        Case { method, driven, outcome: Outcome::Told { says, why, warnings } }
    }

    /// Why it is not as it should be, if it is not.
    pub fn fails(&self) -> Option<String> {
        let begun = Instant::now();
        // One that panics is one that fails, and hides no other.
        let wrong =
            catch_unwind(AssertUnwindSafe(|| self.wrong())).unwrap_or_else(|_| Some("it panics".into()));
        if std::env::var_os("CALYX_EXTREME").is_some() {
            println!(
                "{:>7.2} s {}, {}: {}",
                begun.elapsed().as_secs_f64(),
                self.method,
                self.driven,
                match &wrong {
                    Some(wrong) => wrong,
                    None => "as it should be",
                }
            );
        }
        wrong.map(|wrong| format!("{}, {}: {wrong}", self.method, self.driven))
    }

    fn wrong(&self) -> Option<String> {
        match &self.outcome {
            Outcome::Holds { to, error, .. } => {
                let error = error();
                if std::env::var_os("CALYX_EXTREME").is_some() {
                    println!("          off by {error:.1e}");
                }
                // What is no number is below no bound.
                (error.is_nan() || error > *to)
                    .then(|| format!("off by {error:e}, and should be by {to:e} at most"))
            }
            Outcome::Refused { code, says, refusal, .. } => match refusal() {
                Some(refusal)
                    if refusal.code == *code
                        && !refusal.message.is_empty()
                        && refusal.message.contains(says)
                        && !refusal.help.is_empty() =>
                {
                    None
                }
                other => Some(format!("expected {code} with a reason and a remedy, found {other:?}")),
            },
            Outcome::Told { says, warnings, .. } => {
                let told = warnings();
                (!told.iter().any(|warning| warning.contains(says)))
                    .then(|| format!("\"{says}\" is not said: {told:?}"))
            }
        }
    }
}
