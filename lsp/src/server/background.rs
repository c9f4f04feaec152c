//! Background elaboration of models, for findings about gears and for derived geometry.
//!
//! One thread elaborates one model at a time, starting with the one checked last. It starts when
//! typing pauses and is cancelled by an edit. It uses a program, not the database, so edits never
//! wait for it.

use super::Shared;
use super::job::{isolated, reason};
use super::workspace::Key;
use crate::ide::elaborated::Elaborated;
use calyx_elaborate::{Cancel, Cancelled, Params, elaborate};
use calyx_lang::check::Checked;
use calyx_lang::ir::Program;
use std::borrow::Cow;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Pause of typing after which elaboration starts; earlier it would only delay answers.
const PAUSE: Duration = Duration::from_millis(150);

/// A model to elaborate.
struct Work {
    home: Key,
    model: Arc<str>,
    checked: Arc<Checked>,
}

#[derive(Default)]
struct State {
    /// Queue with one entry per model, the newest last.
    waiting: Vec<Work>,
    running: Option<(Key, Cancel)>,
    edited: Option<Instant>,
    stopped: bool,
}

/// State shared by the thread and its clients.
#[derive(Default)]
pub(crate) struct Background {
    state: Mutex<State>,
    roused: Condvar,
}

impl Background {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Queues a model for elaboration, unless its program (compared by identity) was already
    /// elaborated.
    pub fn submit(
        &self,
        home: &Key,
        model: &Arc<str>,
        checked: &Arc<Checked>,
        known: Option<&Arc<Elaborated>>,
    ) {
        if checked.program.is_none() || known.is_some_and(|known| known.is_of(checked)) {
            return;
        }
        let mut state = self.lock();
        state.waiting.retain(|work| work.home != *home || work.model != *model);
        state.waiting.push(Work { home: home.clone(), model: model.clone(), checked: checked.clone() });
        self.roused.notify_all();
    }

    /// Cancels the elaboration of a project after an edit: its result would be outdated.
    pub fn edited(&self, home: &Key) {
        let mut state = self.lock();
        state.edited = Some(Instant::now());
        state.waiting.retain(|work| work.home != *home);
        if let Some((running, cancel)) = &state.running
            && running == home
        {
            cancel.cancel();
        }
    }

    pub fn stop(&self) {
        let mut state = self.lock();
        state.stopped = true;
        if let Some((_, cancel)) = &state.running {
            cancel.cancel();
        }
        self.roused.notify_all();
    }

    /// Waits for work; `None` at shutdown.
    fn next(&self) -> Option<(Work, Cancel)> {
        let mut state = self.lock();
        loop {
            state.running = None;
            if state.stopped {
                return None;
            }
            let pause = state.edited.map_or(Duration::ZERO, |edited| PAUSE.saturating_sub(edited.elapsed()));
            state = if state.waiting.is_empty() {
                self.roused.wait(state).unwrap_or_else(PoisonError::into_inner)
            } else if !pause.is_zero() {
                let waited = self.roused.wait_timeout(state, pause);
                waited.unwrap_or_else(PoisonError::into_inner).0
            } else if let Some(work) = state.waiting.pop() {
                let cancel = Cancel::default();
                state.running = Some((work.home.clone(), cancel.clone()));
                return Some((work, cancel));
            } else {
                state
            };
        }
    }
}

/// Starts the thread.
pub(crate) fn start(shared: Arc<Shared>) -> io::Result<()> {
    let run = move || {
        while let Some((work, cancel)) = shared.background.next() {
            isolated(&shared.log, "elaboration", || run(&shared, &work, &cancel));
        }
    };
    thread::Builder::new().name("elaboration".to_owned()).spawn(run)?;
    Ok(())
}

/// Returns the program with the paths outside of its folder that it may read.
pub(crate) fn may_read(program: &Program, allowed: Arc<[PathBuf]>) -> Cow<'_, Program> {
    match allowed.is_empty() {
        true => Cow::Borrowed(program),
        false => Cow::Owned(Program { allowed, ..program.clone() }),
    }
}

fn run(shared: &Shared, work: &Work, cancel: &Cancel) {
    let Some(program) = &work.checked.program else { return };
    let program = may_read(program, shared.workspace().allowed.clone());
    let begun = Instant::now();
    let elaboration = catch_unwind(AssertUnwindSafe(|| elaborate(&program, Params::Defaults, cancel)));
    let took = begun.elapsed().as_millis();
    match elaboration {
        Ok(Ok(elaboration)) => {
            shared.log.debug(&format!("elaborated {} in {took} ms", work.model));
            let elaborated = Elaborated::new(&work.checked, elaboration);
            shared.workspace().set_elaborated(&work.home, &work.model, elaborated);
            shared.wake.wake();
        }
        Ok(Err(Cancelled)) => {
            shared.log.debug(&format!("gave up elaborating {} after {took} ms", work.model))
        }
        Err(panic) => shared.log.error(&format!("elaborating {} failed: {}", work.model, reason(&*panic))),
    }
}
