//! C API: params, limits and printing.

use super::{CInstance, CStatus, State, c_text, store, text, with};
use crate::error::Error;
use crate::param_assignment::AssignedValue;
use calyx_abi::description::ParamValue;
use calyx_abi::units::from_si;
use std::ffi::{c_char, c_int, c_void};
use std::time::Duration;

/// Sets a param to a value that `value` converts from C.
///
/// # Safety
/// `instance` as for [`with`], `param` as for [`text`].
unsafe fn set(
    instance: *mut CInstance,
    param: *const c_char,
    value: impl FnOnce() -> Result<AssignedValue, Error>,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: guaranteed by the caller.
        let param = unsafe { text(param, "the name of the param") }?;
        state.instance.set(param, value()?)?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Sets a param to a number in the unit of its default.
///
/// # Safety
/// `instance` is NULL or alive, `param` NULL or a null-terminated string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set(instance: *mut CInstance, param: *const c_char, value: f64) -> CStatus {
    // SAFETY: guaranteed by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Number(value))) }
}

/// Sets a param to a number in a unit.
///
/// # Safety
/// As for [`calyx_set`], and `unit` is NULL or a null-terminated string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set_in(
    instance: *mut CInstance,
    param: *const c_char,
    value: f64,
    unit: *const c_char,
) -> CStatus {
    // SAFETY: guaranteed by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Quantity(value, text(unit, "the unit")?.into()))) }
}

/// Sets a Boolean param.
///
/// # Safety
/// As for [`calyx_set`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set_bool(
    instance: *mut CInstance,
    param: *const c_char,
    value: c_int,
) -> CStatus {
    // SAFETY: guaranteed by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Bool(value != 0))) }
}

/// Sets a param to a value parsed from a text.
///
/// # Safety
/// As for [`calyx_set`], and `value` is NULL or a null-terminated string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set_text(
    instance: *mut CInstance,
    param: *const c_char,
    value: *const c_char,
) -> CStatus {
    // SAFETY: guaranteed by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Text(text(value, "the text")?.into()))) }
}

/// Resets a param to its default.
///
/// # Safety
/// As for [`calyx_set`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_reset(instance: *mut CInstance, param: *const c_char) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: guaranteed by the caller.
        state.instance.reset(unsafe { text(param, "the name of the param") }?)?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Returns the value that a param would have in a run, in the unit of its default.
///
/// # Safety
/// As for [`calyx_set`], and `value` is NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_get(
    instance: *const CInstance,
    param: *const c_char,
    value: *mut f64,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: guaranteed by the caller.
        let name = unsafe { text(param, "the name of the param") }?;
        let found = state.instance.param(name)?;
        let number = match state.instance.get(found)? {
            ParamValue::Number(si) => {
                let params = &state.instance.description().params;
                from_si(si, params.get(found.index()).map_or(1.0, |param| param.unit.factor))
            }
            ParamValue::Bool(value) => f64::from(u8::from(value)),
            ParamValue::String(_) => {
                return Err(Error::given(format!("`{name}` is a text, not a number"), ""));
            }
            ParamValue::Numbers(_) => {
                return Err(Error::given(format!("`{name}` is an array, not a number"), ""));
            }
        };
        // SAFETY: guaranteed by the caller.
        unsafe { store(value, "the output argument for the value", number) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Limits the time of each run.
///
/// # Safety
/// As for [`calyx_set`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_limit_time(instance: *mut CInstance, seconds: f64) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        let limit = Duration::try_from_secs_f64(seconds)
            .map_err(|error| Error::given(format!("a run cannot be limited to {seconds} s: {error}"), ""))?;
        state.instance.limit_time((!limit.is_zero()).then_some(limit));
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Limits the memory of each run.
///
/// # Safety
/// As for [`calyx_set`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_limit_memory(instance: *mut CInstance, bytes: u64) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        state.instance.limit_memory((bytes != 0).then_some(bytes));
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// C function that receives a line, with the user pointer of the program.
type Print = unsafe extern "C" fn(line: *const c_char, user: *mut c_void);

struct Printer(Print, *mut c_void);

// SAFETY: the header states that a thread of the run calls the function. The `user` pointer is only
// passed back; its thread safety is the responsibility of the program.
unsafe impl Send for Printer {}

impl Printer {
    fn print(&self, line: &str) {
        // SAFETY: the program registered this function to be called with this pointer.
        unsafe { (self.0)(c_text(line).as_ptr(), self.1) }
    }
}

/// Sets the function that receives the lines that the model prints.
///
/// # Safety
/// As for [`calyx_set`], and `print` is NULL or may be called with `user` until it is replaced or
/// the instance is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_on_print(
    instance: *mut CInstance,
    print: Option<Print>,
    user: *mut c_void,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        match print.map(|print| Printer(print, user)) {
            Some(printer) => state.instance.on_print(move |line| printer.print(line)),
            None => state.instance.on_print(|_| ()),
        }
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}
