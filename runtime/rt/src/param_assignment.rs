//! Values assigned to params: on a command line, in a file, or by an embedding program.

use calyx_abi::description::{FileDescription, ParamValue};
use std::fmt;
use std::sync::Arc;

/// Value assigned to a param.
#[derive(Clone, Debug, PartialEq)]
pub struct ParamAssignment {
    /// Name of the param.
    pub name: String,
    pub value: AssignedValue,
    /// Location of the value, if in a file.
    pub origin: Option<Origin>,
    /// Location of the name.
    pub name_origin: Option<Origin>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum AssignedValue {
    /// Text of a command line, for a param of any kind: `500`, `0.5 mm`, `TRUE`, `plane`.
    Text(String),
    /// Number in the unit of the param's default.
    Number(f64),
    /// Number in the given unit, like `lbf*inch`.
    Quantity(f64, String),
    /// Number in the coherent SI unit.
    Si(f64),
    Bool(bool),
    /// Quantity such as `0.5 mm`, or the value of a string param; never a Boolean.
    String(String),
    /// Elements of an array.
    List(Vec<AssignedValue>),
}

impl ParamAssignment {
    /// Creates an assignment from the text of a command line.
    pub fn text(name: impl Into<String>, text: impl Into<String>) -> ParamAssignment {
        ParamAssignment {
            name: name.into(),
            value: AssignedValue::Text(text.into()),
            origin: None,
            name_origin: None,
        }
    }

    /// Creates an assignment from a value of a program.
    pub fn value(name: impl Into<String>, value: impl Into<AssignedValue>) -> ParamAssignment {
        ParamAssignment { name: name.into(), value: value.into(), origin: None, name_origin: None }
    }

    /// Parses `NAME=VALUE`.
    ///
    /// # Errors
    /// A description of the syntax error.
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

/// Converts the text of a command line.
impl From<&str> for AssignedValue {
    fn from(text: &str) -> AssignedValue {
        AssignedValue::Text(text.into())
    }
}

/// Converts the text of a command line.
impl From<String> for AssignedValue {
    fn from(text: String) -> AssignedValue {
        AssignedValue::Text(text)
    }
}

/// Converts numbers in the unit of the param's default.
impl From<Vec<f64>> for AssignedValue {
    fn from(numbers: Vec<f64>) -> AssignedValue {
        AssignedValue::List(numbers.into_iter().map(AssignedValue::Number).collect())
    }
}

/// Converts a number and its unit.
impl From<(f64, &str)> for AssignedValue {
    fn from((number, unit): (f64, &str)) -> AssignedValue {
        AssignedValue::Quantity(number, unit.into())
    }
}

/// Converts a value of [`Instance::get`](crate::Instance::get), so that it can be set again.
impl From<ParamValue> for AssignedValue {
    fn from(value: ParamValue) -> AssignedValue {
        match value {
            ParamValue::Bool(truth) => AssignedValue::Bool(truth),
            ParamValue::Number(si) => AssignedValue::Si(si),
            ParamValue::String(text) => AssignedValue::String(text),
            ParamValue::Numbers(numbers) => {
                AssignedValue::List(numbers.into_iter().map(AssignedValue::Si).collect())
            }
        }
    }
}

/// Formats the value as messages quote it.
impl fmt::Display for AssignedValue {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            AssignedValue::Text(text) | AssignedValue::String(text) => f.write_str(text),
            AssignedValue::Number(number) => write!(f, "{number}"),
            AssignedValue::Quantity(number, unit) => write!(f, "{number} {unit}"),
            AssignedValue::Si(number) => write!(f, "{number} in SI"),
            AssignedValue::Bool(truth) => write!(f, "{truth}"),
            AssignedValue::List(elements) => {
                let elements: Vec<String> = elements.iter().map(ToString::to_string).collect();
                write!(f, "[{}]", elements.join(", "))
            }
        }
    }
}

/// Location in a params file.
#[derive(Clone, Debug, PartialEq)]
pub struct Origin {
    pub file: Arc<FileDescription>,
    /// First byte in the file's text.
    pub start: usize,
    /// End of the bytes in the file's text, exclusive.
    pub end: usize,
}
