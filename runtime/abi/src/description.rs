//! Description of a compiled model, used by `--help`, hover, results and error messages.
//!
//! Object files contain it as JSON. This module defines its structure, and the C layout of the
//! table of a linked model.

use crate::call::{KernelFn, Repr, SlotFn};
use crate::error::Place;
use crate::fingerprint::Fingerprint;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::path::PathBuf;
use std::sync::Arc;

/// Table of a linked model, exported by the object file under the symbol `NAME_model`.
#[repr(C)]
pub struct ModuleTable {
    /// [`Fingerprint`] of the interface that the code was compiled for.
    pub abi: u64,
    /// Runs the program's top level once.
    pub main: SlotFn,
    /// Kernels by site.
    pub kernels: *const KernelFn,
    pub kernel_count: u64,
    /// Description: UTF-8 JSON of a [`ModelDescription`].
    pub description: *const u8,
    pub description_len: u64,
    /// Three functions per param of the description: its default, and the ends of its range (`None`
    /// if absent). They take no arguments and may read earlier params from the context.
    pub param_functions: *const Option<SlotFn>,
}

// SAFETY: the table and what it points to are constants of the linked program.
unsafe impl Sync for ModuleTable {}

/// Number of base dimensions that a program may declare in addition to the five physical ones.
pub const OWN_BASES: usize = 3;

/// Exponents of length, mass, time, angle and temperature, then of the declared dimensions, each as
/// numerator and denominator.
pub type Exponents = [(i32, i32); 5 + OWN_BASES];

/// Description of a model. Stored as JSON in object files and run directories.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelDescription {
    /// Fingerprint of the interface that the model was compiled for.
    pub abi: Fingerprint,
    /// Displayed name of the model's file.
    pub name: String,
    /// Text of the doc comment at the start of the model's file; empty if there is none.
    pub doc: String,
    /// Name of the unit system of printed results: `SI`, `mm_N_s`, `inch_lbf_s`.
    pub units: String,
    pub params: Vec<ParamDescription>,
    /// Outputs of a run. Elaboration replaces arrays by their elements at the default values of the
    /// params.
    pub outputs: Vec<OutputDescription>,
    /// Outputs as declared, if some of them are arrays; otherwise empty.
    #[serde(default)]
    pub declared_outputs: Vec<OutputDescription>,
    /// Host functions that the embedding program may provide, in the order of
    /// [`crate::Context::host_functions`].
    pub host_functions: Vec<HostFunctionDescription>,
    /// Kernels by symbolic site, in the order of [`ModuleTable::kernels`].
    pub kernels: Vec<KernelDescription>,
    /// The model's file first, then every file that it uses, including those of the library.
    #[serde(with = "shared")]
    pub files: Arc<[FileDescription]>,
    /// All units of the language, for reading values given as text without the compiler.
    pub known_units: Vec<UnitDescription>,
    /// All named dimensions, including the program's own base dimensions. Among several that differ
    /// only in the exponent of angle, the most common one is first.
    pub known_dimensions: Vec<DimensionDescription>,
    /// Tables that the program reads at the default values of its params, by the names that it
    /// uses. Elaboration adds them; they are stored with the program.
    #[serde(with = "shared")]
    pub tables: Arc<[FileDescription]>,
    /// Files and directories outside the model's directory that the program may read, as absolute
    /// paths without links. The permission belongs to this machine and is not stored with the
    /// program.
    #[serde(skip)]
    pub allowed: Arc<[PathBuf]>,
    /// Calls of engine and library functions, in order of location. Elaboration adds them.
    pub calls: Vec<CallDescription>,
}

/// Prefix of the names of library files.
pub const LIBRARY: &str = "<library>/";

/// Call of an engine or library function, so that an error can be located at an argument without
/// the compiler. A `throw` in the library is described as a call without arguments.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CallDescription {
    /// Byte range `(file, start, end)` of the call.
    pub place: Place,
    /// Name and byte range of each argument that is written in the call; others have default
    /// values.
    pub arguments: Vec<(String, Place)>,
    /// For a call in the library: the parameters of the enclosing function that each argument is
    /// computed from.
    #[serde(default)]
    pub carried: Vec<(String, Vec<String>)>,
    /// Name of the called function, such as `gears.mesh`; empty for a `throw`.
    #[serde(default)]
    pub function: String,
}

/// Param: an input of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ParamDescription {
    pub name: String,
    pub doc: String,
    /// Number, Bool or String.
    pub repr: Repr,
    pub unit: UnitDescription,
    /// True if only integers are allowed.
    pub integral: bool,
    /// Allowed strings; empty if any string is allowed.
    pub choices: Vec<String>,
    /// Default and ends of the allowed range in SI. Elaboration computes them by running the
    /// program's functions; `None` before that, and if absent.
    pub default: Option<ParamValue>,
    pub low: Option<f64>,
    pub high: Option<f64>,
    /// True if default and range do not depend on other params.
    pub independent: bool,
}

impl ParamDescription {
    /// Returns whether the param takes decimal numbers, so that outputs can be differentiated with
    /// respect to it.
    pub fn is_continuous(&self) -> bool {
        self.repr == Repr::Number && !self.integral
    }
}

/// Value of a param.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ParamValue {
    Bool(bool),
    /// Number in SI.
    Number(f64),
    String(String),
    /// Array of numbers in SI.
    Numbers(Vec<f64>),
}

/// Requested output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OutputDescription {
    pub name: String,
    pub doc: String,
    /// Index in [`ModelDescription::kernels`].
    pub site: usize,
    /// Unit of results.
    pub unit: UnitDescription,
    /// Name of the coherent SI unit.
    pub si: String,
    /// True for an array, whose elements are outputs of a run: `name[0]`.
    #[serde(default)]
    pub is_array: bool,
    /// Choices of an enumeration that the values number from 0; empty for other numbers.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub choices: Vec<String>,
}

/// Returns the choice that the value of an output numbers; `None` if it numbers none.
pub fn choice_of(choices: &[String], value: f64) -> Option<&str> {
    let index = (value >= 0.0 && value.fract() == 0.0).then_some(value as usize)?;
    choices.get(index).map(String::as_str)
}

impl ModelDescription {
    /// Returns the description with the outputs of a run, by name, in the place of arrays.
    pub fn with_outputs<'n>(&self, names: impl Iterator<Item = &'n str>) -> ModelDescription {
        let outputs = names.filter_map(|name| self.output_of(name)).collect();
        ModelDescription { outputs, ..self.clone() }
    }

    /// Returns the description of an output of a run.
    fn output_of(&self, name: &str) -> Option<OutputDescription> {
        let mut declared = name;
        loop {
            let is_array = declared.len() < name.len();
            let found = |output: &&OutputDescription| output.name == declared && output.is_array == is_array;
            if let Some(found) = self.declared_outputs.iter().find(found) {
                return Some(OutputDescription { name: name.into(), is_array: false, ..found.clone() });
            }
            let (array, _) = declared.strip_suffix(']')?.rsplit_once('[')?;
            declared = array;
        }
    }
}

/// Host function that the embedding program may provide in place of the model's own
/// ([`crate::host`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HostFunctionDescription {
    /// Name under which it is provided: `module.name` for a function of an imported module.
    pub name: String,
    pub doc: String,
    pub parameters: Vec<HostValueDescription>,
    /// Result; its name is empty.
    pub result: HostValueDescription,
}

/// Parameter or result of a host function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HostValueDescription {
    pub name: String,
    /// Number, Bool, String, Vector, or an array of these.
    pub repr: Repr,
    /// Type as written in the model, like `Array(Length)`.
    #[serde(rename = "type")]
    pub ty: String,
    /// Unit of display. Numbers are passed in coherent SI units.
    pub unit: UnitDescription,
}

/// Unit of display: SI value = displayed value * `factor`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct UnitDescription {
    /// Name, e.g. `lbf*inch`; empty for a dimensionless number.
    pub name: String,
    pub factor: f64,
    pub dimension: Exponents,
}

/// Named dimension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DimensionDescription {
    /// Name in annotations of the language: `Length`, `SecondMomentOfArea`.
    pub name: String,
    pub exponents: Exponents,
}

/// Kernel of a symbolic site.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelDescription {
    pub name: String,
    /// Number, Vector or Transform.
    pub repr: Repr,
    /// Highest time derivative that is computed in addition to the value.
    pub order: u8,
    pub inputs: usize,
    pub outputs: usize,
    pub captures: Vec<CaptureDescription>,
}

/// Value that a symbolic expression captured when its binding executed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaptureDescription {
    pub name: String,
    pub repr: Repr,
    /// True for an observable: captured as its index, replaced by its value at each step.
    pub observable: bool,
}

/// File of a program, or one that it reads.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileDescription {
    pub name: String,
    /// Text; that of a binary file is [`stored_text`].
    pub text: String,
}

/// Start of the text that stores a binary file. No text file starts with a zero character.
const BINARY: &str = "\0binary\0";

/// Returns a text that stores the bytes of any file: the text of a text file, or one character for
/// each byte of a binary one.
pub fn stored_text(bytes: Vec<u8>) -> String {
    let binary = |bytes: &[u8]| BINARY.chars().chain(bytes.iter().map(|&byte| char::from(byte))).collect();
    match String::from_utf8(bytes) {
        Ok(text) if !text.starts_with('\0') => text,
        Ok(text) => binary(text.as_bytes()),
        Err(error) => binary(error.as_bytes()),
    }
}

/// Returns the bytes of the file that a text of [`stored_text`] stores.
pub fn stored_bytes(text: &str) -> Cow<'_, [u8]> {
    match text.strip_prefix(BINARY) {
        None => Cow::Borrowed(text.as_bytes()),
        // Characters of a binary file are below 256.
        Some(binary) => binary.chars().map(|c| u8::try_from(u32::from(c)).unwrap_or(b'?')).collect(),
    }
}

/// Serialization of shared slices as lists.
mod shared {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};
    use std::sync::Arc;

    pub fn serialize<T: Serialize, S: Serializer>(list: &Arc<[T]>, serializer: S) -> Result<S::Ok, S::Error> {
        list.as_ref().serialize(serializer)
    }

    pub fn deserialize<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Arc<[T]>, D::Error> {
        Vec::deserialize(deserializer).map(Arc::from)
    }
}

#[cfg(test)]
mod tests {
    use super::{stored_bytes, stored_text};

    #[test]
    fn any_file_is_stored_as_text() {
        let all: Vec<u8> = (0..=255).collect();
        let files: [&[u8]; 6] =
            [b"", b"GRID, 1", "\u{feff}\u{b5}m".as_bytes(), &all, b"\0", b"PK\x03\x04\xff"];
        for bytes in files {
            assert_eq!(&*stored_bytes(&stored_text(bytes.to_vec())), bytes);
        }
        assert_eq!(stored_text(b"GRID, 1".to_vec()), "GRID, 1");
    }
}
