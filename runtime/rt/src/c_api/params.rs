//! Params, limits and printing, for C.

use super::{CInstance, CStatus, State, c_text, store, text, with};
use crate::error::Error;
use crate::param_assignment::AssignedValue;
use calyx_abi::description::ParamValue;
use calyx_abi::units::from_si;
use std::ffi::{c_char, c_int, c_void};
use std::time::Duration;

/// Sets a param to a value that is read from what C gave.
///
/// # Safety
/// `instance` as for [`with`], `param` as for [`text`].
unsafe fn set(
    instance: *mut CInstance,
    param: *const c_char,
    value: impl FnOnce() -> Result<AssignedValue, Error>,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: as promised by the caller.
        let param = unsafe { text(param, "the name of the param") }?;
        state.instance.set(param, value()?)?;
        Ok(CStatus::Ok)
    };
    // SAFETY: as promised by the caller.
    unsafe { with(instance, body) }
}

/// Sets a param to a number in the unit of its default.
///
/// # Safety
/// `instance` is NULL or alive, `param` NULL or a text that ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set(instance: *mut CInstance, param: *const c_char, value: f64) -> CStatus {
    // SAFETY: as promised by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Number(value))) }
}

/// Sets a param to a number in a unit.
///
/// # Safety
/// As for [`calyx_set`], and `unit` is NULL or a text that ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set_in(
    instance: *mut CInstance,
    param: *const c_char,
    value: f64,
    unit: *const c_char,
) -> CStatus {
    // SAFETY: as promised by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Quantity(value, text(unit, "the unit")?.into()))) }
}

/// Sets a param that is TRUE or FALSE.
///
/// # Safety
/// As for [`calyx_set`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set_bool(
    instance: *mut CInstance,
    param: *const c_char,
    value: c_int,
) -> CStatus {
    // SAFETY: as promised by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Bool(value != 0))) }
}

/// Sets a param to what a text says.
///
/// # Safety
/// As for [`calyx_set`], and `value` is NULL or a text that ends with a zero.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_set_text(
    instance: *mut CInstance,
    param: *const c_char,
    value: *const c_char,
) -> CStatus {
    // SAFETY: as promised by the caller.
    unsafe { set(instance, param, || Ok(AssignedValue::Text(text(value, "the text")?.into()))) }
}

/// Gives a param its default again.
///
/// # Safety
/// As for [`calyx_set`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_reset(instance: *mut CInstance, param: *const c_char) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: as promised by the caller.
        state.instance.reset(unsafe { text(param, "the name of the param") }?)?;
        Ok(CStatus::Ok)
    };
    // SAFETY: as promised by the caller.
    unsafe { with(instance, body) }
}

/// What a param would be in a run, in the unit of its default.
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
        // SAFETY: as promised by the caller.
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
        };
        // SAFETY: as promised by the caller.
        unsafe { store(value, "the place for the value", number) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: as promised by the caller.
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
    // SAFETY: as promised by the caller.
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
    // SAFETY: as promised by the caller.
    unsafe { with(instance, body) }
}

/// A function of C that takes lines, with what it wants back.
type Print = unsafe extern "C" fn(line: *const c_char, user: *mut c_void);

struct Printer(Print, *mut c_void);

// SAFETY: the header says that the function is called by a thread of the run; what `user` points to is the program's own
// business, and here it is only handed back.
unsafe impl Send for Printer {}

impl Printer {
    fn print(&self, line: &str) {
        // SAFETY: the program gave this function for this, with this pointer.
        unsafe { (self.0)(c_text(line).as_ptr(), self.1) }
    }
}

/// Says what takes the lines that the model prints.
///
/// # Safety
/// As for [`calyx_set`], and `print` is NULL or may be called with `user` until another is given or the instance is freed.
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
    // SAFETY: as promised by the caller.
    unsafe { with(instance, body) }
}
