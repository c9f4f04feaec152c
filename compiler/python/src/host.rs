//! Python functions that replace host functions of a model.

use calyx::rt::Host;
use calyx::{Error, Instance, ModelDescription};
use calyx_abi::host::{HostCall, HostFunction, Provided, failed};
use calyx_abi::{Repr, RuntimeError};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Arc;

/// Functions by name.
pub type Functions<'py> = Vec<(String, Bound<'py, PyAny>)>;

/// Provides functions to an instance. Names that the model does not declare are errors.
///
/// # Errors
/// TypeError if a type of a function has no equivalent in Python. The inner error is that of
/// [`Instance::set_host`].
pub fn provide(instance: &mut Instance, functions: Functions<'_>) -> PyResult<Result<(), Error>> {
    let mut host = Host::new();
    for (name, function) in functions {
        let (parameters, result) = types(instance.description(), &name)?;
        let called =
            Called { function: function.unbind(), parameters: parameters.clone(), result: result.clone() };
        host = host.provided(name, Provided::new(parameters, result, Arc::new(called)));
    }
    Ok(instance.set_host(&host))
}

/// Returns the types of a host function. A function that is not declared has none, and
/// [`Instance::set_host`] rejects it.
fn types(description: &ModelDescription, name: &str) -> PyResult<(Vec<Repr>, Repr)> {
    let Some(declared) = description.host_functions.iter().find(|declared| declared.name == name) else {
        return Ok((Vec::new(), Repr::Number));
    };
    let values = declared.parameters.iter().chain([&declared.result]);
    if let Some(other) = values.clone().find(|value| !is_supported(&value.repr)) {
        return Err(PyTypeError::new_err(format!(
            "the host function `{name}` cannot be a Python function: the type {} is neither a number, a Boolean, a text, a vector nor an array of numbers",
            other.ty
        )));
    }
    let parameters = declared.parameters.iter().map(|parameter| parameter.repr.clone()).collect();
    Ok((parameters, declared.result.repr.clone()))
}

fn is_supported(repr: &Repr) -> bool {
    match repr {
        Repr::Number | Repr::Bool | Repr::String | Repr::Vector => true,
        Repr::Array(element) => **element == Repr::Number,
        _ => false,
    }
}

/// Python function with the types of the host function that it replaces.
struct Called {
    function: Py<PyAny>,
    parameters: Vec<Repr>,
    result: Repr,
}

impl HostFunction for Called {
    fn call(&self, call: &mut HostCall) -> Result<(), RuntimeError> {
        Python::attach(|py| {
            let raised = |error: PyErr| failed(format!("the Python function raised {error}"));
            let mut arguments = Vec::new();
            for repr in &self.parameters {
                arguments.push(match repr {
                    Repr::Bool => call.argument::<bool>()?.into_py_any(py),
                    Repr::String => call.argument::<String>()?.into_py_any(py),
                    Repr::Vector => call.argument::<[f64; 3]>()?.into_py_any(py),
                    Repr::Array(_) => call.argument::<Vec<f64>>()?.into_py_any(py),
                    _ => call.argument::<f64>()?.into_py_any(py),
                });
            }
            let arguments: PyResult<Vec<_>> = arguments.into_iter().collect();
            let arguments = arguments.and_then(|arguments| PyTuple::new(py, arguments)).map_err(raised)?;
            let result = self.function.bind(py).call1(arguments).map_err(raised)?;
            match self.result {
                Repr::Bool => call.give(result.extract::<bool>().map_err(raised)?),
                Repr::String => call.give(result.extract::<String>().map_err(raised)?),
                Repr::Vector => call.give(result.extract::<[f64; 3]>().map_err(raised)?),
                Repr::Array(_) => call.give(result.extract::<Vec<f64>>().map_err(raised)?),
                _ => call.give(result.extract::<f64>().map_err(raised)?),
            }
        })
    }
}
