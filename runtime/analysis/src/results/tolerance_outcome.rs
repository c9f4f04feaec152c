//! Outcome of a tolerance search: the settings that were compared, and the selected one.

use calyx_model::fidelity::Fidelity;
use calyx_numerics::error::EngineError;

/// Setting of an analysis. Factors are relative to the model's own options.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Fidelity level.
    pub fidelity: Fidelity,
    /// Factor on the number of elements along every direction.
    pub refinement: f64,
    /// Factor on the number of contact cells, across and along.
    pub cells: usize,
    /// Factor on the number of positions.
    pub positions: usize,
}

impl Setting {
    /// Describes the setting by its differences from the model's options.
    pub fn describe(&self) -> String {
        let mut text = format!("\"{}\"", self.fidelity.name());
        if self.refinement != 1.0 {
            text += &format!(" with {} times the elements along every direction", self.refinement);
        }
        if self.cells != 1 {
            text += &format!(", {} times the cells of contact across and along", self.cells);
        }
        if self.positions != 1 {
            text += &format!(", {} times the positions", self.positions);
        }
        text
    }
}

/// Setting with its estimated error.
#[derive(Clone, Debug, PartialEq)]
pub struct Attempt {
    /// The setting.
    pub setting: Setting,
    /// True if all positions were solved, false for a few.
    pub whole: bool,
    /// Name of the output with the largest relative error, and that error relative to the output's
    /// largest magnitude: infinite for an output without a value or an estimate.
    pub worst: (String, f64),
}

impl Attempt {
    /// Describes the error.
    pub(crate) fn error(&self) -> String {
        match &self.worst {
            (output, error) if error.is_finite() => format!("{} in `{output}`", percent(*error)),
            (output, _) => format!("nothing to judge `{output}` by"),
        }
    }
}

/// Outcome of a tolerance search.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceOutcome {
    /// Tolerance, relative to the largest magnitude of every output.
    pub tolerance: f64,
    /// Setting of the results.
    pub setting: Setting,
    /// All compared settings, in order. If the tolerance is met, the last is the setting of the
    /// results, at all positions.
    pub attempts: Vec<Attempt>,
    /// Index of the attempt with the setting of the results.
    pub selected: usize,
    /// Reason why the search ended before a setting met the tolerance, if so.
    pub ended: Option<String>,
    /// Reason why the estimates do not include the model error, if so.
    pub excluded_model_error: Option<String>,
}

/// Reason for the end of a search without further settings.
pub(crate) const EXHAUSTED: &str = "no setting is estimated to meet it";

/// Remedy if no setting meets a tolerance.
pub(crate) const LARGER: &str =
    "ask for a larger tolerance, or remove the outputs that cannot be computed so accurately";

impl ToleranceOutcome {
    /// Former name of the field [`ToleranceOutcome::attempts`].
    #[deprecated(since = "0.1.0", note = "use the field `attempts`")]
    pub fn tried(&self) -> &[Attempt] {
        &self.attempts
    }

    /// Former name of the field [`ToleranceOutcome::selected`].
    #[deprecated(since = "0.1.0", note = "use the field `selected`")]
    pub fn taken(&self) -> usize {
        self.selected
    }

    /// Returns the warning if the results do not meet the tolerance.
    pub fn missed(&self) -> Option<EngineError> {
        let reason = self.ended.as_ref()?;
        let reached = self.attempts.get(self.selected).map_or_else(String::new, |selected| {
            let all = if selected.whole { "" } else { " at a few of the positions" };
            format!(": they are of {}{all}, with {}", self.setting.describe(), selected.error())
        });
        let tolerance = percent(self.tolerance);
        let message =
            format!("the results do not meet the tolerance of {tolerance}, because {reason}{reached}");
        let help = match reason.starts_with(EXHAUSTED) {
            true => LARGER.to_owned(),
            false => format!("run it again to its end, {LARGER}"),
        };
        Some(EngineError::new("E0793", message, help).blame("tolerance"))
    }

    /// Describes the choice and its reason.
    pub fn describe(&self) -> String {
        let mut text = format!("tolerance {}: took {}", percent(self.tolerance), self.setting.describe());
        if let Some(reason) = &self.ended {
            text = format!(
                "tolerance {} not met, because {reason}: took {}",
                percent(self.tolerance),
                self.setting.describe()
            );
        }
        if let Some(selected) = self.attempts.get(self.selected) {
            let all = if selected.whole { "" } else { " at a few of the positions" };
            text += &format!("{all}, estimated to be within {}", selected.error());
        }
        let others = self.attempts.iter().enumerate().filter(|(index, _)| *index != self.selected);
        for (_, missed) in others.filter(|(_, attempt)| attempt.worst.1 > self.tolerance) {
            text += &format!("; {} has {}", missed.setting.describe(), missed.error());
        }
        if let Some(reason) = &self.excluded_model_error {
            text += &format!("; what the level leaves out is not in it ({reason})");
        }
        text
    }
}

/// Formats a fraction in percent, with two digits.
pub(crate) fn percent(part: f64) -> String {
    let rounded: f64 = format!("{:.1e}", 100.0 * part).parse().unwrap_or(f64::NAN);
    format!("{rounded} %")
}

/// A setting that is tried next for a tolerance, as reported to observers.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchProgress {
    /// The setting.
    pub setting: Setting,
    /// True for all positions, false for a few of them.
    pub whole: bool,
    /// The attempt with the least estimated error so far: an interrupted search ends with it.
    pub best: Option<Attempt>,
    /// Fraction of the permitted work that is done, 0 to 1.
    pub part: f64,
}

impl SearchProgress {
    /// Describes the setting and the progress.
    pub fn describe(&self) -> String {
        let mut text = format!("trying {}", self.setting.describe());
        if !self.whole {
            text += " at a few of the positions";
        }
        if let Some(best) = &self.best {
            text += &format!("; the best so far is {} with {}", best.setting.describe(), best.error());
        }
        text
    }
}
