//! Test cases: the extreme input and the expected outcome.

use calyx_gears::error::GeometryError;
use calyx_runtime::error::EngineError;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// Case of extreme input.
pub struct Case {
    pub method: &'static str,
    /// Extreme values of the input.
    pub driven: &'static str,
    pub outcome: Outcome,
}

pub enum Outcome {
    /// Largest relative error, compared with a reference, stays below a bound.
    Holds { to: f64, truth: &'static str, error: fn() -> f64 },
    /// Input is rejected with a code, a reason that contains these words, and a remedy.
    Refused { code: &'static str, says: &'static str, why: &'static str, refusal: fn() -> Option<Refusal> },
    /// Problem is solved, and a warning of the result with these words states what is wrong.
    Warns { says: &'static str, why: &'static str, warnings: fn() -> Vec<String> },
}

/// Contents of a refusal.
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

/// Returns the refusal of something that must be rejected.
pub fn refusal<T, E: Into<Refusal>>(result: Result<T, E>) -> Option<Refusal> {
    result.err().map(Into::into)
}

/// Largest of several errors; NaN counts as infinite.
pub fn worst(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors
        .into_iter()
        .fold(0.0, |worst, error| if error.is_nan() { f64::INFINITY } else { error.abs().max(worst) })
}

/// Error of a number relative to a known one.
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

    /// Adds words that the refusal must contain.
    pub fn saying(mut self, words: &'static str) -> Case {
        if let Outcome::Refused { says, .. } = &mut self.outcome {
            *says = words;
        }
        self
    }

    pub fn warns(
        method: &'static str,
        driven: &'static str,
        says: &'static str,
        why: &'static str,
        warnings: fn() -> Vec<String>,
    ) -> Case {
        Case { method, driven, outcome: Outcome::Warns { says, why, warnings } }
    }

    /// Returns the reason if the outcome is not the expected one.
    pub fn fails(&self) -> Option<String> {
        let begun = Instant::now();
        // A panic fails the case without hiding the others.
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
                // NaN is below no bound.
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
            Outcome::Warns { says, warnings, .. } => {
                let warns = warnings();
                (!warns.iter().any(|warning| warning.contains(says)))
                    .then(|| format!("\"{says}\" is not said: {warns:?}"))
            }
        }
    }
}
