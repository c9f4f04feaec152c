//! Elaboration in the background: what is wrong with the gears, and the geometry that follows, without anybody waiting.
//!
//! One thread, one model at a time, the one checked last first. It begins when typing pauses, and an edit stops it. It works on a program,
//! not on the database, so edits never wait for it.

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

/// How long typing pauses before elaboration begins: it would only take time from answers.
const PAUSE: Duration = Duration::from_millis(150);

/// A model to elaborate.
struct Work {
    home: Key,
    model: Arc<str>,
    checked: Arc<Checked>,
}

#[derive(Default)]
struct State {
    /// One a model, the newest last.
    waiting: Vec<Work>,
    running: Option<(Key, Cancel)>,
    edited: Option<Instant>,
    stopped: bool,
}

/// What the thread and those who ask it know.
#[derive(Default)]
pub(crate) struct Background {
    state: Mutex<State>,
    roused: Condvar,
}

impl Background {
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Has a model elaborated, unless it has been: a program is told by its identity.
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

    /// A text of a project has changed: what would be said of its models comes too late.
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

    /// Waits for something to do; `None` when all is over.
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

/// The program with the paths outside of its folder that it may read.
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
