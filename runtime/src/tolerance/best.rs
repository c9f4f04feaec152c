//! The best results that a search has had before it ends.

use super::{Search, Setting};
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
    /// Tells the observer the positions of these results, unless it was told those of no others
    /// since: who writes them down begins anew with the first.
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
