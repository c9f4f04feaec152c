//! Watches an analysis for an instance: hands over positions, tells of progress, and ends what is to end.

use crate::budget;
use crate::instance::{Progress, ProgressSink, RecordSink};
use crate::program::Program;
use crate::stepping::{Step, Steps};
use calyx_abi::Cancel;
use calyx_abi::error::codes;
use calyx_abi::limits::Limits;
use calyx_runtime::analysis::{Event, Observer};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use std::sync::{Arc, PoisonError};

/// See the module.
pub struct Watcher {
    pub program: Arc<dyn Program>,
    pub shape: u64,
    pub hand_over: Option<Steps>,
    pub progress: Option<ProgressSink>,
    pub record: Option<RecordSink>,
}

impl Watcher {
    fn tell(&self, progress: Progress) {
        if let Some(sink) = &self.progress {
            sink.lock().unwrap_or_else(PoisonError::into_inner)(progress);
        }
    }
}

/// What an analysis asks whether to go on: no, if it was cancelled or has used up its time or memory.
pub fn interrupt(cancel: Cancel, limits: Limits) -> Interrupt {
    Interrupt::new(move || {
        if cancel.is_cancelled() {
            return Err(cancelled());
        }
        let taken = limits.memory.and_then(|_| budget::taken()).unwrap_or(0);
        limits
            .check_time()
            .and_then(|()| limits.check_memory(taken))
            .map_err(|error| EngineError::new(codes::EXHAUSTED, error.message, error.help))
    })
}

fn cancelled() -> EngineError {
    EngineError::new(codes::CANCELLED, "the run was cancelled", "")
}

impl Observer for Watcher {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        match event {
            Event::Planned(_) => {}
            Event::Stage(stage) => self.tell(Progress { stage, done: 0, total: None }),
            Event::Step { index, count, solved, fields } => {
                if let Some(record) = &self.record {
                    record.lock().unwrap_or_else(PoisonError::into_inner)(index, solved, fields)?;
                }
                if let Some(steps) = &self.hand_over {
                    let (program, row) = (self.program.clone(), Arc::new(solved.row.clone()));
                    let step = Step { program, shape: self.shape, index, count, row };
                    // Nobody takes steps any more.
                    steps.send(step).map_err(|_| cancelled())?;
                }
                self.tell(Progress { stage: "positions", done: index + 1, total: Some(count) });
            }
        }
        Ok(())
    }
}
