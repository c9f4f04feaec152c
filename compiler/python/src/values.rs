//! Values of params from and to Python.

use calyx::rt::{AssignedValue, ParamValue};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};

/// Converts a value: a Boolean, a number in the unit of the param's default, a text as after
/// `--set`, a tuple of number and unit, a dictionary `{"si": number}` or a list of such values.
///
/// # Errors
/// TypeError for other values.
pub fn assigned(value: &Bound<'_, PyAny>) -> PyResult<AssignedValue> {
    if let Ok(truth) = value.cast::<PyBool>() {
        return Ok(AssignedValue::Bool(truth.is_true()));
    }
    if value.is_instance_of::<PyFloat>() || value.is_instance_of::<PyInt>() {
        return Ok(AssignedValue::Number(value.extract()?));
    }
    if let Ok(text) = value.cast::<PyString>() {
        return Ok(AssignedValue::Text(text.extract()?));
    }
    if let Ok(pair) = value.cast::<PyTuple>() {
        let (number, unit): (f64, String) = pair.extract()?;
        return Ok(AssignedValue::Quantity(number, unit));
    }
    if let Ok(list) = value.cast::<PyList>() {
        let elements: PyResult<_> = list.iter().map(|element| assigned(&element)).collect();
        return Ok(AssignedValue::List(elements?));
    }
    if let Ok(si) = value.cast::<PyDict>()
        && let Some(number) = si.get_item("si")?
    {
        return Ok(AssignedValue::Si(number.extract()?));
    }
    Err(PyTypeError::new_err(format!(
        "a param cannot be a {}: give a number, a text like \"120 N*m\", or a tuple (120, \"N*m\")",
        value.get_type().name()?
    )))
}

/// Converts a value for Python, with numbers in a unit.
pub fn shown<'py>(py: Python<'py>, value: &ParamValue, factor: f64) -> PyResult<Bound<'py, PyAny>> {
    let number = |si: f64| crate::describe::from_si(si, factor);
    Ok(match value {
        ParamValue::Bool(truth) => truth.into_pyobject(py)?.to_owned().into_any(),
        ParamValue::Number(si) => number(*si).into_pyobject(py)?.into_any(),
        ParamValue::String(text) => text.into_pyobject(py)?.into_any(),
        ParamValue::Numbers(all) => {
            all.iter().map(|si| number(*si)).collect::<Vec<_>>().into_pyobject(py)?.into_any()
        }
    })
}
