//! Values given for params: on a command line, in a file, or by the program that runs the model.

use calyx_abi::description::{FileDescription, ParamValue};
use std::fmt;
use std::sync::Arc;

/// A value for a param.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamAssignment {
    /// Of the param.
    pub name: String,
    pub value: AssignedValue,
    /// Where the value stands, if it was given in a file.
    pub origin: Option<Origin>,
    /// Where the name stands.
    pub name_origin: Option<Origin>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum AssignedValue {
    /// As typed on a command line, whatever the param is: `500`, `0.5 mm`, `TRUE`, `plane`.
    Text(String),
    /// In the unit of the param's default.
    Number(f64),
    /// In the unit named, like `lbf*inch`.
    Quantity(f64, String),
    /// In the coherent SI unit.
    Si(f64),
    Bool(bool),
    /// A quantity like `0.5 mm`, or the value of a param that is a string; never a truth value.
    String(String),
}

impl ParamAssignment {
    /// A value as typed on a command line.
    pub fn text(name: impl Into<String>, text: impl Into<String>) -> ParamAssignment {
        ParamAssignment {
            name: name.into(),
            value: AssignedValue::Text(text.into()),
            origin: None,
            name_origin: None,
        }
    }

    /// A value of a program.
    pub fn value(name: impl Into<String>, value: impl Into<AssignedValue>) -> ParamAssignment {
        ParamAssignment { name: name.into(), value: value.into(), origin: None, name_origin: None }
    }

    /// Reads `NAME=VALUE`.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn name_and_value(text: &str) -> Result<ParamAssignment, String> {
        let (name, value) = text.split_once('=').ok_or("there is no `=`; give it like `--set torque=500`")?;
        Ok(ParamAssignment::text(name.trim(), value.trim()))
    }
}

impl From<f64> for AssignedValue {
    fn from(number: f64) -> AssignedValue {
        AssignedValue::Number(number)
    }
}

impl From<i32> for AssignedValue {
    fn from(number: i32) -> AssignedValue {
        AssignedValue::Number(f64::from(number))
    }
}

impl From<bool> for AssignedValue {
    fn from(truth: bool) -> AssignedValue {
        AssignedValue::Bool(truth)
    }
}

/// As typed on a command line.
impl From<&str> for AssignedValue {
    fn from(text: &str) -> AssignedValue {
        AssignedValue::Text(text.into())
    }
}

/// As typed on a command line.
impl From<String> for AssignedValue {
    fn from(text: String) -> AssignedValue {
        AssignedValue::Text(text)
    }
}

/// A number and its unit.
impl From<(f64, &str)> for AssignedValue {
    fn from((number, unit): (f64, &str)) -> AssignedValue {
        AssignedValue::Quantity(number, unit.into())
    }
}

/// What [`Instance::get`](crate::Instance::get) gave can be set again.
impl From<ParamValue> for AssignedValue {
    fn from(value: ParamValue) -> AssignedValue {
        match value {
            ParamValue::Bool(truth) => AssignedValue::Bool(truth),
            ParamValue::Number(si) => AssignedValue::Si(si),
            ParamValue::String(text) => AssignedValue::String(text),
        }
    }
}

/// As messages quote it.
impl fmt::Display for AssignedValue {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            AssignedValue::Text(text) | AssignedValue::String(text) => f.write_str(text),
            AssignedValue::Number(number) => write!(f, "{number}"),
            AssignedValue::Quantity(number, unit) => write!(f, "{number} {unit}"),
            AssignedValue::Si(number) => write!(f, "{number} in SI"),
            AssignedValue::Bool(truth) => write!(f, "{truth}"),
        }
    }
}

/// A place in a file of params.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    pub file: Arc<FileDescription>,
    /// Bytes of the file's text.
    pub start: usize,
    pub end: usize,
}
