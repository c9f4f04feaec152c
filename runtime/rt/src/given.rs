//! Values given for params: on a command line, in a file, or by the program that runs the model.

use calyx_abi::description::{FileDescription, ParamValue};
use std::fmt;
use std::sync::Arc;

/// A value for a param.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Of the param.
    pub name: String,
    pub value: GivenValue,
    /// Where the value stands, if it was given in a file.
    pub origin: Option<Origin>,
    /// Where the name stands.
    pub name_origin: Option<Origin>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum GivenValue {
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

impl Given {
    /// A value as typed on a command line.
    pub fn text(name: impl Into<String>, text: impl Into<String>) -> Given {
        Given { name: name.into(), value: GivenValue::Text(text.into()), origin: None, name_origin: None }
    }

    /// A value of a program.
    pub fn value(name: impl Into<String>, value: impl Into<GivenValue>) -> Given {
        Given { name: name.into(), value: value.into(), origin: None, name_origin: None }
    }

    /// Reads `NAME=VALUE`.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn name_and_value(text: &str) -> Result<Given, String> {
        let (name, value) = text.split_once('=').ok_or("there is no `=`; give it like `--set torque=500`")?;
        Ok(Given::text(name.trim(), value.trim()))
    }
}

impl From<f64> for GivenValue {
    fn from(number: f64) -> GivenValue {
        GivenValue::Number(number)
    }
}

impl From<i32> for GivenValue {
    fn from(number: i32) -> GivenValue {
        GivenValue::Number(f64::from(number))
    }
}

impl From<bool> for GivenValue {
    fn from(truth: bool) -> GivenValue {
        GivenValue::Bool(truth)
    }
}

/// As typed on a command line.
impl From<&str> for GivenValue {
    fn from(text: &str) -> GivenValue {
        GivenValue::Text(text.into())
    }
}

/// As typed on a command line.
impl From<String> for GivenValue {
    fn from(text: String) -> GivenValue {
        GivenValue::Text(text)
    }
}

/// A number and its unit.
impl From<(f64, &str)> for GivenValue {
    fn from((number, unit): (f64, &str)) -> GivenValue {
        GivenValue::Quantity(number, unit.into())
    }
}

/// What [`Instance::get`](crate::Instance::get) gave can be set again.
impl From<ParamValue> for GivenValue {
    fn from(value: ParamValue) -> GivenValue {
        match value {
            ParamValue::Bool(truth) => GivenValue::Bool(truth),
            ParamValue::Number(si) => GivenValue::Si(si),
            ParamValue::String(text) => GivenValue::String(text),
        }
    }
}

/// As messages quote it.
impl fmt::Display for GivenValue {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            GivenValue::Text(text) | GivenValue::String(text) => f.write_str(text),
            GivenValue::Number(number) => write!(f, "{number}"),
            GivenValue::Quantity(number, unit) => write!(f, "{number} {unit}"),
            GivenValue::Si(number) => write!(f, "{number} in SI"),
            GivenValue::Bool(truth) => write!(f, "{truth}"),
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
