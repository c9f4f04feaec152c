//! C API: the functions that `calyx.h` declares.
//!
//! Each is a thin layer over [`Instance`] that checks pointers, stops panics and stores errors for
//! [`calyx_error`]. A lock protects each instance, so that a program that uses one from two threads
//! waits; only [`calyx_cancel`] does not wait.

mod describe;
mod params;
mod running;
mod status;

pub use describe::{
    OutputInfo, ParamInfo, calyx_output_at, calyx_output_count, calyx_output_named, calyx_param_at,
    calyx_param_count,
};
pub use params::{
    calyx_get, calyx_limit_memory, calyx_limit_time, calyx_on_print, calyx_reset, calyx_set, calyx_set_bool,
    calyx_set_in, calyx_set_text,
};
pub use running::{
    Position, Summary, calyx_cancel, calyx_last_position, calyx_output, calyx_output_in, calyx_step,
    calyx_stop, calyx_summarize, calyx_summarize_in, calyx_where,
};
pub use status::{CStatus, calyx_status_message};

use crate::engine::Engine;
use crate::error::Error;
use crate::instance::Instance;
use crate::linked::{LinkedProgram, NotLinked};
use crate::messages::{line_column, problem};
use crate::program::Program;
use calyx_abi::description::{ModelDescription, ModuleTable};
use calyx_abi::error::codes;
use calyx_abi::{Cancel, RuntimeError};
use calyx_gears::error::Severity;
use describe::Described;
use running::Running;
use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The header of these functions.
pub const HEADER: &str = include_str!("calyx.h");

/// `calyx_instance` of the header.
pub struct CInstance {
    state: Mutex<State>,
    /// Cancels the current run.
    cancel: Mutex<Cancel>,
    /// Description of the model with C strings.
    described: Described,
}

/// State that the lock protects.
struct State {
    instance: Instance,
    program: Arc<dyn Program>,
    running: Running,
    problem: Option<ProblemTexts>,
}

/// C strings of a problem.
struct ProblemTexts {
    status: CStatus,
    code: CString,
    message: CString,
    help: CString,
    file: CString,
    line: usize,
    column: usize,
    report: CString,
}

/// `calyx_problem` of the header.
#[repr(C)]
pub struct Problem {
    pub status: CStatus,
    pub code: *const c_char,
    pub message: *const c_char,
    pub help: *const c_char,
    pub file: *const c_char,
    pub line: usize,
    pub column: usize,
    pub report: *const c_char,
}

impl ProblemTexts {
    fn new(error: &Error, description: &ModelDescription) -> ProblemTexts {
        let mut texts = ProblemTexts {
            status: CStatus::of(error),
            code: c_text(error.code().unwrap_or_default()),
            message: c_text(error.message()),
            help: c_text(error.help()),
            file: CString::default(),
            line: 0,
            column: 0,
            report: CString::default(),
        };
        let report = match error {
            Error::Model(error) => {
                let location = error.place.and_then(|(file, start, _)| {
                    description.files.get(file as usize).map(|file| (file, start as usize))
                });
                if let Some((file, start)) = location {
                    texts.file = c_text(&file.name);
                    (texts.line, texts.column) = line_column(file, start);
                }
                problem(Severity::Error, error, description)
            }
            _ => match error.help() {
                "" => format!("error: {}\n", error.message()),
                help => format!("error: {}\n  help: {help}\n", error.message()),
            },
        };
        texts.report = c_text(&report);
        texts
    }
}

/// Converts a text to a C string, truncated at the first null byte.
fn c_text(text: &str) -> CString {
    CString::new(text.replace('\0', "\u{fffd}")).unwrap_or_default()
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // A panic leaves the state consistent: every function changes it by one assignment.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns the error for a NULL pointer.
fn null(what: &str) -> Error {
    Error::given(format!("{what} is NULL"), "")
}

/// Converts a C string.
///
/// # Safety
/// `text` is NULL or points to a null-terminated string that lives for `'a`.
unsafe fn text<'a>(text: *const c_char, what: &str) -> Result<&'a str, Error> {
    if text.is_null() {
        return Err(null(what));
    }
    // SAFETY: guaranteed by the caller.
    let bytes = unsafe { CStr::from_ptr(text) };
    bytes.to_str().map_err(|_| Error::given(format!("{what} is not UTF-8"), ""))
}

/// Stores a result through a pointer from C.
///
/// # Safety
/// `place` is NULL or valid for writing a `T`.
unsafe fn store<T>(place: *mut T, what: &str, value: T) -> Result<(), Error> {
    if place.is_null() {
        return Err(null(what));
    }
    // SAFETY: not null, so valid as guaranteed by the caller.
    unsafe { place.write(value) };
    Ok(())
}

/// Runs the body of a function with an instance. A NULL instance, an error and a panic become a
/// status; errors are stored.
///
/// # Safety
/// `instance` is NULL or was made by [`calyx_create`] and not freed.
unsafe fn with(
    instance: *const CInstance,
    body: impl FnOnce(&CInstance, &mut State) -> Result<CStatus, Error>,
) -> CStatus {
    // SAFETY: guaranteed by the caller.
    let Some(instance) = (unsafe { instance.as_ref() }) else { return CStatus::Null };
    let mut state = lock(&instance.state);
    let result = catch_unwind(AssertUnwindSafe(|| body(instance, &mut state)));
    let error = match result {
        Ok(Ok(status)) => return status,
        Ok(Err(error)) => error,
        Err(_) => panicked(),
    };
    let texts = ProblemTexts::new(&error, state.program.description());
    let status = texts.status;
    state.problem = Some(texts);
    status
}

/// Returns the error for a panic, whose message was already printed.
fn panicked() -> Error {
    RuntimeError::new(codes::INTERNAL, "internal error", "please report it with the model").into()
}

fn instance_of(engine: &Engine, program: Arc<dyn Program>) -> CInstance {
    let instance = Instance::new(engine, program.clone());
    CInstance {
        cancel: Mutex::new(instance.cancel_handle()),
        described: Described::new(program.description()),
        state: Mutex::new(State { instance, program, running: Running::default(), problem: None }),
    }
}

/// Creates an instance of a linked model.
///
/// # Safety
/// `model` is NULL or the module table generated by `calyx build`, of static lifetime; `instance`
/// is NULL or valid for writing a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_create(model: *const ModuleTable, instance: *mut *mut CInstance) -> CStatus {
    if instance.is_null() {
        return CStatus::Null;
    }
    let made = catch_unwind(|| {
        // SAFETY: NULL, or a constant of the program. Its first word is the fingerprint in every
        // version; the rest is read only after the fingerprint has been compared.
        let Some(model) = (unsafe { model.as_ref() }) else { return Err(CStatus::Null) };
        match LinkedProgram::new(model) {
            Ok(program) => Ok(Box::new(instance_of(&Engine::default(), Arc::new(program)))),
            // A description that cannot be parsed was written by another version.
            Err(NotLinked::Version(_) | NotLinked::Damaged(_)) => Err(CStatus::Version),
        }
    });
    match made {
        Ok(Ok(made)) => {
            // SAFETY: not null, so valid for writing as guaranteed by the caller.
            unsafe { instance.write(Box::into_raw(made)) };
            CStatus::Ok
        }
        Ok(Err(status)) => status,
        Err(_) => CStatus::Internal,
    }
}

/// Creates another instance of the same model.
///
/// # Safety
/// As for the other functions, and `another` is NULL or valid for writing a pointer.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_create_like(
    instance: *const CInstance,
    another: *mut *mut CInstance,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        if another.is_null() {
            return Err(null("the output argument for the instance"));
        }
        let made = Box::new(instance_of(state.instance.engine(), state.program.clone()));
        // SAFETY: not null, so valid for writing as guaranteed by the caller.
        unsafe { another.write(Box::into_raw(made)) };
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Frees an instance.
///
/// # Safety
/// `instance` is NULL or was made by [`calyx_create`], is not freed, and no other function is using
/// it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_free(instance: *mut CInstance) {
    if instance.is_null() {
        return;
    }
    // SAFETY: the pointer comes from `Box::into_raw`, and the caller gives up ownership.
    let instance = unsafe { Box::from_raw(instance) };
    // Ends the current run and waits for it. A panic in it could at worst leak memory.
    let _ = catch_unwind(AssertUnwindSafe(|| drop(instance)));
}

/// Returns the error of the last function that failed with this instance.
///
/// # Safety
/// As for the other functions, and `problem` is NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_error(instance: *const CInstance, problem: *mut Problem) -> CStatus {
    // SAFETY: guaranteed by the caller.
    let Some(instance) = (unsafe { instance.as_ref() }) else { return CStatus::Null };
    let state = lock(&instance.state);
    let described = match &state.problem {
        Some(texts) => Problem {
            status: texts.status,
            code: texts.code.as_ptr(),
            message: texts.message.as_ptr(),
            help: texts.help.as_ptr(),
            file: texts.file.as_ptr(),
            line: texts.line,
            column: texts.column,
            report: texts.report.as_ptr(),
        },
        None => {
            let nothing = c"".as_ptr();
            Problem {
                status: CStatus::Ok,
                code: nothing,
                message: nothing,
                help: nothing,
                file: nothing,
                line: 0,
                column: 0,
                report: nothing,
            }
        }
    };
    if problem.is_null() {
        return CStatus::Null;
    }
    // SAFETY: not null, so valid for writing as guaranteed by the caller.
    unsafe { problem.write(described) };
    CStatus::Ok
}
