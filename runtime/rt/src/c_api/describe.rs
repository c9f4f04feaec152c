//! C API: description of the params and outputs of a model.

use super::{CInstance, CStatus, State, c_text, store, text, with};
use crate::error::Error;
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_abi::units::from_si;
use std::ffi::{CString, c_char};

/// C strings of a param or an output.
struct Texts {
    name: CString,
    doc: CString,
    unit: CString,
}

/// Description of a model with C strings.
pub(super) struct Described {
    /// Strings, and default and range in the param's unit.
    params: Vec<(Texts, [f64; 3])>,
    outputs: Vec<Texts>,
}

impl Described {
    pub(super) fn new(description: &ModelDescription) -> Described {
        let texts = |name: &str, doc: &str, unit: &str| Texts {
            name: c_text(name),
            doc: c_text(doc),
            unit: c_text(unit),
        };
        let params = description.params.iter().map(|param| {
            let shown = |si: Option<f64>| si.map_or(f64::NAN, |si| from_si(si, param.unit.factor));
            let default = match param.default {
                Some(ParamValue::Number(si)) => shown(Some(si)),
                Some(ParamValue::Bool(value)) => f64::from(u8::from(value)),
                _ => f64::NAN,
            };
            (texts(&param.name, &param.doc, &param.unit.name), [default, shown(param.low), shown(param.high)])
        });
        let outputs = description.outputs.iter();
        let outputs = outputs.map(|output| texts(&output.name, &output.doc, &output.unit.name));
        Described { params: params.collect(), outputs: outputs.collect() }
    }
}

/// `calyx_param_info` of the header.
#[repr(C)]
pub struct ParamInfo {
    pub name: *const c_char,
    pub doc: *const c_char,
    pub unit: *const c_char,
    pub default_value: f64,
    pub low: f64,
    pub high: f64,
}

/// `calyx_output_info` of the header.
#[repr(C)]
pub struct OutputInfo {
    pub name: *const c_char,
    pub doc: *const c_char,
    pub unit: *const c_char,
}

/// Returns the number of params.
///
/// # Safety
/// `instance` is NULL or alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_param_count(instance: *const CInstance) -> usize {
    // SAFETY: guaranteed by the caller.
    unsafe { instance.as_ref() }.map_or(0, |instance| instance.described.params.len())
}

/// Returns the number of outputs.
///
/// # Safety
/// `instance` is NULL or alive.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_output_count(instance: *const CInstance) -> usize {
    // SAFETY: guaranteed by the caller.
    unsafe { instance.as_ref() }.map_or(0, |instance| instance.described.outputs.len())
}

fn none_of(index: usize, what: &str, count: usize) -> Error {
    let help = format!("{what}s are counted from 0; the header names them");
    Error::given(format!("the model has {count} {what}s, and none of number {index}"), help)
}

/// Describes a param.
///
/// # Safety
/// `instance` is NULL or alive, `info` NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_param_at(
    instance: *const CInstance,
    param: usize,
    info: *mut ParamInfo,
) -> CStatus {
    let body = |instance: &CInstance, _: &mut State| {
        let params = &instance.described.params;
        let (Texts { name, doc, unit }, [default_value, low, high]) =
            params.get(param).ok_or_else(|| none_of(param, "param", params.len()))?;
        let (default_value, low, high) = (*default_value, *low, *high);
        let [name, doc, unit] = [name, doc, unit].map(|text| text.as_ptr());
        let found = ParamInfo { name, doc, unit, default_value, low, high };
        // SAFETY: guaranteed by the caller.
        unsafe { store(info, "the output argument for the param", found) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Describes an output.
///
/// # Safety
/// `instance` is NULL or alive, `info` NULL or valid for writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_output_at(
    instance: *const CInstance,
    output: usize,
    info: *mut OutputInfo,
) -> CStatus {
    let body = |instance: &CInstance, _: &mut State| {
        let outputs = &instance.described.outputs;
        let Texts { name, doc, unit } =
            outputs.get(output).ok_or_else(|| none_of(output, "output", outputs.len()))?;
        let [name, doc, unit] = [name, doc, unit].map(|text| text.as_ptr());
        // SAFETY: guaranteed by the caller.
        unsafe { store(info, "the output argument for the output", OutputInfo { name, doc, unit }) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}

/// Looks up an output by name.
///
/// # Safety
/// `instance` is NULL or alive, `name` NULL or a null-terminated string, `output` NULL or valid for
/// writing.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_output_named(
    instance: *const CInstance,
    name: *const c_char,
    output: *mut usize,
) -> CStatus {
    let body = |_: &CInstance, state: &mut State| {
        // SAFETY: guaranteed by the caller.
        let found = state.instance.output(unsafe { text(name, "the name of the output") }?)?;
        // SAFETY: guaranteed by the caller.
        unsafe { store(output, "the output argument for the output", found.index()) }?;
        Ok(CStatus::Ok)
    };
    // SAFETY: guaranteed by the caller.
    unsafe { with(instance, body) }
}
