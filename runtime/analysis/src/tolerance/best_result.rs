//! The best results of a search before it ends, and what observers are shown of it.

use super::{Search, Setting};
use crate::analysis::{Event, Observer};
use crate::results::AnalysisResult;
use crate::rows::Solved;
use calyx_numerics::error::EngineError;

/// Results that miss the tolerance by less than any others.
pub(super) struct Best {
    pub result: AnalysisResult,
    pub setting: Setting,
    /// Index of the attempt.
    pub attempt: usize,
}

impl Best {
    /// Reports the positions of these results to the observer, unless they are the last ones that
    /// it received. Observers that write positions restart at the first.
    ///
    /// # Errors
    /// The observer's.
    pub(super) fn observed(
        &self,
        search: &Search<'_>,
        observer: &mut dyn Observer,
    ) -> Result<(), EngineError> {
        if search.observed == Some(self.attempt) {
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
