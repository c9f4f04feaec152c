//! Lines that a program prints while it is checked.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Largest total length of the lines kept, bytes. A program may print without end.
const MOST_BYTES: usize = 64_000;

/// The last lines that a program has printed. Clones share them.
#[derive(Clone, Debug, Default)]
pub struct Printed(Arc<Mutex<Lines>>);

#[derive(Debug, Default)]
struct Lines {
    lines: VecDeque<String>,
    bytes: usize,
    omitted: usize,
}

impl Printed {
    /// Adds a line, and drops the first ones if there are too many.
    pub fn push(&self, line: &str) {
        let mut kept = self.lock();
        kept.bytes += line.len() + 1;
        kept.lines.push_back(line.to_owned());
        while kept.bytes > MOST_BYTES {
            let Some(first) = kept.lines.pop_front() else { break };
            kept.bytes -= first.len() + 1;
            kept.omitted += 1;
        }
    }

    /// Returns the lines, after a line that counts those that were dropped, if any.
    pub fn lines(&self) -> Vec<String> {
        let kept = self.lock();
        let omitted = match kept.omitted {
            0 => None,
            1 => Some("... (1 line before)".to_owned()),
            count => Some(format!("... ({count} lines before)")),
        };
        omitted.into_iter().chain(kept.lines.iter().cloned()).collect()
    }

    fn lock(&self) -> MutexGuard<'_, Lines> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
