//! Monitor of an analysis: passes on positions, reports progress, and stops the analysis on
//! cancellation or at a limit.

use crate::budget;
use crate::instance::{Progress, ProgressSink, RecordSink, SearchProgressSink};
use crate::program::Program;
use crate::stepping::{Step, Steps};
use calyx_abi::Cancel;
use calyx_abi::error::codes;
use calyx_abi::limits::Limits;
use calyx_runtime::analysis::{Event, Observer};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::{Interrupt, MemoryRequest};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, PoisonError};

/// Monitor of an analysis, see the module.
pub struct Watcher {
    pub program: Arc<dyn Program>,
    pub shape: u64,
    pub hand_over: Option<Steps>,
    pub progress: Option<ProgressSink>,
    pub record: Option<RecordSink>,
    pub choosing: Option<SearchProgressSink>,
}

impl Watcher {
    fn tell(&self, progress: Progress) {
        if let Some(sink) = &self.progress {
            sink.lock().unwrap_or_else(PoisonError::into_inner)(progress);
        }
    }
}

/// Smallest request in bytes for which the memory of the system is queried.
const WORTH_ASKING: u64 = 1 << 22;

/// Returns the interrupt of an analysis: it stops the analysis if it was cancelled, has exceeded
/// its time, or requests more memory than the limit or the machine allows.
pub fn interrupt(cancel: Cancel, limits: Limits) -> Interrupt {
    // Memory of the process when nothing was promised.
    let before = AtomicU64::new(0);
    Interrupt::counting(move |MemoryRequest { bytes: wanted, promised }| {
        if cancel.is_cancelled() {
            return Err(cancelled());
        }
        let taken = limits.memory.and_then(|_| budget::taken()).unwrap_or(0);
        limits.check_time().map_err(|error| EngineError::new(codes::EXHAUSTED, error.message, error.help))?;
        if let Some(limit) = limits.memory.filter(|limit| taken > *limit) {
            let text = format!(
                "the analysis takes {} MB, and its memory limit is {} MB",
                megabytes(taken),
                megabytes(limit)
            );
            return Err(EngineError::new(codes::EXHAUSTED, text, TAKE_LESS));
        }
        if wanted < WORTH_ASKING {
            return Ok(());
        }
        // Memory that was promised and is now in use is counted by the system already.
        let now = budget::taken().unwrap_or(0);
        if promised == 0 {
            before.store(now, Ordering::Relaxed);
        }
        let owed = promised.saturating_sub(now.saturating_sub(before.load(Ordering::Relaxed)));
        match room(limits, taken) {
            Some((room, whose)) if wanted > room.saturating_sub(owed) => {
                Err(too_large(wanted, room.saturating_sub(owed), whose))
            }
            _ => Ok(()),
        }
    })
}

/// Returns the bytes that may still be allocated, and the limit that determines them.
fn room(limits: Limits, taken: u64) -> Option<(u64, &'static str)> {
    let of_run = limits.memory.map(|limit| (limit.saturating_sub(taken), "its memory limit leaves"));
    let of_machine = budget::available().map(|left| (left, "this machine has"));
    of_run.into_iter().chain(of_machine).min_by_key(|(room, _)| *room)
}

/// Remedy for an analysis that requires too much memory.
const TAKE_LESS: &str = "take a coarser fidelity, fewer elements along the face, fewer contact cells or fewer threads, or give it more memory";

fn megabytes(bytes: u64) -> f64 {
    (bytes as f64 * 1e-6).round()
}

fn too_large(wanted: u64, room: u64, whose: &str) -> EngineError {
    EngineError::new(
        codes::EXHAUSTED,
        format!(
            "the analysis needs {} MB for its next step, and {whose} {} MB",
            megabytes(wanted),
            megabytes(room)
        ),
        TAKE_LESS,
    )
}

fn cancelled() -> EngineError {
    EngineError::new(codes::CANCELLED, "the run was cancelled", "")
}

impl Observer for Watcher {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        match event {
            Event::Planned(_) => {}
            Event::SearchProgress(choosing) => {
                if let Some(sink) = &self.choosing {
                    sink.lock().unwrap_or_else(PoisonError::into_inner)(choosing);
                }
            }
            Event::Stage(stage) => self.tell(Progress { stage, done: 0, total: None }),
            Event::Differentiated { index, count } => {
                self.tell(Progress { stage: "sensitivities", done: index, total: Some(count) });
            }
            Event::Step { index, count, solved, fields } => {
                if let Some(record) = &self.record {
                    record.lock().unwrap_or_else(PoisonError::into_inner)(index, solved, fields)?;
                }
                if let Some(steps) = &self.hand_over {
                    let (program, row) = (self.program.clone(), Arc::new(solved.row.clone()));
                    let step = Step { program, shape: self.shape, index, count, row };
                    // The receiver was dropped.
                    steps.send(step).map_err(|_| cancelled())?;
                }
                self.tell(Progress { stage: "positions", done: index + 1, total: Some(count) });
            }
        }
        Ok(())
    }
}
