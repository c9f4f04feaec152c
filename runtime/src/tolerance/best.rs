//! The best results of a search before it ends, and what observers are shown of it.

use super::{Search, Setting, Tried};
use crate::analysis::{Event, Observer};
use crate::error::EngineError;
use crate::results::{AnalysisResult, Solved};

/// Results that miss the tolerance by less than any others.
pub(super) struct Best {
    pub result: AnalysisResult,
    pub setting: Setting,
    /// Index of the attempt.
    pub tried: usize,
}

impl Best {
    /// Reports the positions of these results to the observer, unless they are the last ones that it
    /// received. Observers that write positions restart at the first.
    ///
    /// # Errors
    /// The observer's.
    pub(super) fn observed(
        &self,
        search: &Search<'_>,
        observer: &mut dyn Observer,
    ) -> Result<(), EngineError> {
        if search.observed == Some(self.tried) {
            return Ok(());
        }
        let (rows, certificate) = (&self.result.rows, self.result.certificate);
        for (index, row) in rows.iter().enumerate() {
            let solved = Solved { row: row.clone(), certificate, state: Vec::new() };
            let count = rows.len();
            observer.observe(Event::Step { index, count, solved: &solved, fields: None })?;
        }
        Ok(())
    }
}

/// A setting that is tried next for a tolerance, as reported to observers.
#[derive(Clone, Debug, PartialEq)]
pub struct Choosing {
    /// The setting.
    pub setting: Setting,
    /// True at all positions, false at a few of them.
    pub whole: bool,
    /// The attempt with the least estimated error so far: an interrupted search ends with it.
    pub best: Option<Tried>,
    /// Part of the work that the search may do which is done, 0 to 1.
    pub part: f64,
}

impl Choosing {
    /// In words.
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
