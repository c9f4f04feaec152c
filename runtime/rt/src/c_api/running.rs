//! C API: runs and their results.

use super::{CInstance, CStatus, State, c_text, lock, store, text, with};
use crate::error::Error;
use crate::names::Output;
use crate::results::Results;
use crate::stepping::{Run, Step};
use calyx_abi::Cancel;
use calyx_runtime::results::OutputSummary;
use std::ffi::{CString, c_char};

/// State of the runs of an instance.
#[derive(Default)]
pub(super) struct Running {
    /// Current run.
    run: Option<Run>,
    /// Last solved position, and the name of its characteristic point.
    step: Option<(Step, CString)>,
    /// Results of the last completed run.
    results: Option<Results>,
}

/// `calyx_position` of the header.
#[repr(C)]
pub struct Position {
    pub index: usize,
    pub count: usize,
    pub time: f64,
    pub cycle: f64,
    pub roll_angle: f64,
    pub point: *const c_char,
}

/// `calyx_summary` of the header.
#[repr(C)]
pub struct Summary {
    pub min: f64,
    pub max: f64,
    pub mean: f64,
    pub peak_to_peak: f64,
    pub max_at: usize,
}

impl From<OutputSummary> for Summary {
    fn from(summary: OutputSummary) -> Summary {
        let OutputSummary { min, max, mean, peak_to_peak, at_max, .. } = summary;
        Summary { min, max, mean, peak_to_peak, max_at: at_max }
    }
}

/// Solves the next position; starts a new run if there is no current one.
///
/// # Safety
/// `instance` is NULL or alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_step(instance: *mut CInstance) -> CStatus {
    let body = |instance: &CInstance, state: &mut State| {
        if state.running.run.is_none() {
            let cancel = Cancel::default();
            state.instance.set_cancel(cancel.clone());
            *lock(&instance.cancel) = cancel;
            // Discards the state of the previous run.
            state.running = Running { run: Some(state.instance.run()?), ..Running::default() };
        }
        let Some(run) = &mut state.running.run else { return Ok(CStatus::End) };
        match run.next() {
            Some(Ok(step)) => {
                let point = c_text(&step.position().name);
                state.running.step = Some((step, point));
                Ok(CStatus::Ok)
            }
            Some(Err(error)) => {
                state.running.run = None;
                Err(error)
            }
            None => {
                let ended = state.running.run.take().map(Run::finish).transpose()?;
                state.running.results = ended;
                Ok(CStatus::End)
            }
        }
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Ends the current run.
///
/// # Safety
/// As for [`calyx_step`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_stop(instance: *mut CInstance) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        state.running.run = None;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Cancels the current run. Does not wait: the thread that steps holds the lock of the state.
///
/// # Safety
/// As for [`calyx_step`], and the instance is not freed meanwhile.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_cancel(instance: *const CInstance) -> CStatus {
    // SAFETY: guaranteed by the caller.
    let Some(instance) = (unsafe { instance.as_ref() }) else { return CStatus::Null };
    lock(&instance.cancel).cancel();
    CStatus::Ok
}

impl State {
    fn step(&self) -> Result<&(Step, CString), Error> {
        self.running.step.as_ref().ok_or_else(|| {
            Error::given("no position has been solved yet", "call `calyx_step` until it returns CALYX_OK")
        })
    }

    fn results(&self) -> Result<&Results, Error> {
        self.running.results.as_ref().ok_or_else(|| {
            Error::given("no run has been completed yet", "call `calyx_step` until it returns CALYX_END")
        })
    }

    fn output(&self, index: usize) -> Result<Output, Error> {
        let description = self.program.description();
        match description.outputs.get(index) {
            Some(output) => Output::named(description, &output.name),
            None => Err(Error::given(
                format!("the model has {} outputs, and none of number {index}", description.outputs.len()),
                "outputs are counted from 0; the header names them",
            )),
        }
    }
}

/// Returns the last solved position, under the former name of [`calyx_last_position`]. Removed in
/// version 0.2.
///
/// # Safety
/// As for [`calyx_last_position`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_where(instance: *const CInstance, position: *mut Position) -> CStatus {
    // SAFETY: guaranteed by the caller.
    unsafe { calyx_last_position(instance, position) }
}

/// Returns the last solved position.
///
/// # Safety
/// As for [`calyx_step`], and `position` is NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_last_position(instance: *const CInstance, position: *mut Position) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        let (step, point) = state.step()?;
        let at = step.position();
        let found = Position {
            index: step.index(),
            count: step.count(),
            time: at.time,
            cycle: at.cycle,
            roll_angle: at.roll,
            point: point.as_ptr(),
        };
        // SAFETY: guaranteed by the caller.
        unsafe { store(position, "the output argument for the position", found) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Returns an output at the last solved position, in the unit in which the model shows it.
///
/// # Safety
/// As for [`calyx_step`], and `value` is NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_output(instance: *const CInstance, output: usize, value: *mut f64) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        let number = state.step()?.0.value(state.output(output)?)?;
        // SAFETY: guaranteed by the caller.
        unsafe { store(value, "the output argument for the value", number) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Returns an output at the last solved position, in the given unit.
///
/// # Safety
/// As for [`calyx_output`], and `unit` is NULL or a null-terminated string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_output_in(
    instance: *const CInstance,
    output: usize,
    unit: *const c_char,
    value: *mut f64,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: guaranteed by the caller.
        let unit = unsafe { text(unit, "the unit") }?;
        let number = state.step()?.0.in_unit(state.output(output)?, unit)?;
        // SAFETY: guaranteed by the caller.
        unsafe { store(value, "the output argument for the value", number) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Returns the summary of an output over all positions of the last completed run, in the unit in
/// which the model shows it.
///
/// # Safety
/// As for [`calyx_step`], and `summary` is NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_summarize(
    instance: *const CInstance,
    output: usize,
    summary: *mut Summary,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        let found = state.results()?.summary(state.output(output)?)?;
        // SAFETY: guaranteed by the caller.
        unsafe { store(summary, "the output argument for the summary", found.into()) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Returns the summary of an output over all positions of the last completed run, in the given
/// unit.
///
/// # Safety
/// As for [`calyx_summarize`], and `unit` is NULL or a null-terminated string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_summarize_in(
    instance: *const CInstance,
    output: usize,
    unit: *const c_char,
    summary: *mut Summary,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: guaranteed by the caller.
        let unit = unsafe { text(unit, "the unit") }?;
        let found = state.results()?.summary_in(state.output(output)?, unit)?;
        // SAFETY: guaranteed by the caller.
        unsafe { store(summary, "the output argument for the summary", found.into()) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}
