//! Descriptions of models, and units.

use crate::arrays::{Array, array};
use crate::errors::Problem;
use calyx::ModelDescription;
use calyx_abi::Repr;
use calyx_abi::description::{OutputDescription, ParamDescription, ParamValue, UnitDescription};
use calyx_abi::quantity;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde_json::{Value, json};

pub use calyx_abi::units::from_si;

/// Returns the description of a model as JSON. Numbers are in the unit of a param's default.
pub fn model_json(description: &ModelDescription) -> Value {
    json!({
        "name": description.name,
        "doc": description.doc,
        "units": description.units,
        "params": description.params.iter().map(param_json).collect::<Vec<_>>(),
        "outputs": declared(description).iter().map(output_json).collect::<Vec<_>>(),
    })
}

/// Returns the outputs as the model declares them; an array is one of them.
fn declared(description: &ModelDescription) -> &[OutputDescription] {
    match &description.declared_outputs[..] {
        [] => &description.outputs,
        declared => declared,
    }
}

fn param_json(param: &ParamDescription) -> Value {
    let factor = param.unit.factor;
    let shown = |si: f64| from_si(si, factor);
    let default = param.default.as_ref().map(|default| match default {
        ParamValue::Bool(truth) => json!(truth),
        ParamValue::Number(si) => json!(shown(*si)),
        ParamValue::String(text) => json!(text),
        ParamValue::Numbers(all) => all.iter().map(|si| shown(*si)).collect(),
    });
    let kind = match &param.repr {
        Repr::Bool => "bool",
        Repr::String => "text",
        Repr::Array(_) => "array",
        _ if param.integral => "integer",
        _ => "number",
    };
    json!({
        "name": param.name,
        "doc": param.doc,
        "kind": kind,
        "unit": unit_json(&param.unit),
        "choices": param.choices,
        "default": default,
        "low": param.low.map(shown),
        "high": param.high.map(shown),
        "independent": param.independent,
    })
}

/// Returns the description of an output as JSON.
pub fn output_json(output: &OutputDescription) -> Value {
    json!({
        "name": output.name,
        "doc": output.doc,
        "unit": unit_json(&output.unit),
        "si": output.si,
        "is_array": output.is_array,
        "choices": output.choices,
    })
}

fn unit_json(unit: &UnitDescription) -> Value {
    json!({ "name": unit.name, "factor": unit.factor, "dimension": unit.dimension })
}

/// Units of a model, independent of it.
#[pyclass(frozen, module = "calyx._calyx", name = "Units")]
pub struct Units(Vec<UnitDescription>);

impl Units {
    pub fn new(description: &ModelDescription) -> Units {
        Units(description.known_units.clone())
    }
}

#[pymethods]
impl Units {
    /// Restores units from `json`.
    #[new]
    fn from_json(text: &str) -> PyResult<Units> {
        let read = serde_json::from_str(text);
        read.map(Units).map_err(|error| PyValueError::new_err(format!("these are not units: {error}")))
    }

    fn json(&self) -> PyResult<String> {
        serde_json::to_string(&self.0).map_err(|error| PyValueError::new_err(error.to_string()))
    }

    fn __reduce__<'py>(this: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((this.get_type().into_any(), (this.get().json()?,)))
    }

    /// Returns the SI value of a unit for an output of the model.
    fn factor(&self, py: Python<'_>, output: &str, own: &str, unit: &str) -> PyResult<f64> {
        let refused = |why: &str| {
            let own = if own.is_empty() { "a pure number".to_owned() } else { format!("shown in {own}") };
            let message = format!("`{output}` cannot be shown in `{unit}`: {why}");
            Problem::new(&message, &format!("`{output}` is {own}")).raised(py, "ParamError")
        };
        let parse = |unit: &str| quantity::with_unit(1.0, unit, &self.0).map_err(|why| refused(&why));
        let (requested, shown) = (parse(unit)?, parse(own)?);
        if !quantity::fits(requested.dimension, shown.dimension) {
            return Err(refused("that is another kind of quantity"));
        }
        Ok(requested.value)
    }

    /// Converts numbers, as bytes of `float64`, from SI to a unit.
    #[staticmethod]
    fn from_si<'py>(py: Python<'py>, numbers: &Bound<'py, PyBytes>, factor: f64) -> PyResult<Array<'py>> {
        let (numbers, _) = numbers.as_bytes().as_chunks();
        let converted: Vec<f64> =
            numbers.iter().map(|number| from_si(f64::from_ne_bytes(*number), factor)).collect();
        array(py, &converted)
    }
}
