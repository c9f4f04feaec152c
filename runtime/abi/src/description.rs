//! What every compiled model says of itself: the same structure feeds `--help`, hover, results and error messages.
//!
//! In an object file it is stored as JSON. Here are its structure, and the C layout by which a linked model is found.

use crate::call::{KernelFn, Repr, SlotFn};
use crate::error::Place;
use crate::fingerprint::Fingerprint;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::Arc;

/// A linked model, as the object file exports it under the symbol `NAME_model`.
#[repr(C)]
pub struct ModuleTable {
    /// The [`Fingerprint`] that the code was compiled against.
    pub abi: u64,
    /// Runs the program's top level once.
    pub main: SlotFn,
    /// Kernels in order of site.
    pub kernels: *const KernelFn,
    pub kernel_count: u64,
    /// The description, UTF-8 JSON of a [`ModelDescription`].
    pub description: *const u8,
    pub description_len: u64,
    /// Three per param of the description: its default, and the ends of its range (`None` where it has none).
    /// They take nothing; they may read earlier params from the context.
    pub param_functions: *const Option<SlotFn>,
}

// SAFETY: the table and what it points to are constants of the linked program.
unsafe impl Sync for ModuleTable {}

/// Base dimensions that a program may add to the five of physics.
pub const OWN_BASES: usize = 3;

/// Exponents of length, mass, time, angle and temperature, then of the dimensions that the program declares, each as
/// numerator and denominator.
pub type Exponents = [(i32, i32); 5 + OWN_BASES];

/// The description itself. Kept as JSON in object files and run directories.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ModelDescription {
    /// What the code was compiled against.
    pub abi: Fingerprint,
    /// The model's file as shown to people.
    pub name: String,
    /// Text of the doc comment that opens the model's file; empty if there is none.
    pub doc: String,
    /// Name of the unit system results print in: `SI`, `mm_N_s`, `inch_lbf_s`.
    pub units: String,
    pub params: Vec<ParamDescription>,
    pub outputs: Vec<OutputDescription>,
    /// Functions that the embedding program may provide, in the order of [`crate::Context::host_functions`].
    pub host_functions: Vec<HostFunctionDescription>,
    /// One per symbolic site, in order of site: the order of [`ModuleTable::kernels`].
    pub kernels: Vec<KernelDescription>,
    /// The model first, then every file it uses, the library's included.
    #[serde(with = "shared")]
    pub files: Arc<[FileDescription]>,
    /// Every unit of the language, so that values given as text can be read without the compiler.
    pub known_units: Vec<UnitDescription>,
    /// Every dimension that has a name, the program's own base dimensions included. Of several that differ in the
    /// exponent of angle only, the one that people mean comes first.
    pub known_dimensions: Vec<DimensionDescription>,
    /// Tables that the program reads at its params' defaults, by the names it reads them by. Elaboration fills them in;
    /// they travel with the program.
    #[serde(with = "shared")]
    pub tables: Arc<[FileDescription]>,
    /// Files and directories outside of the model's directory that the program may read, as
    /// absolute paths without links. They are allowed on this machine, so they do not travel with
    /// the program.
    #[serde(skip)]
    pub allowed: Arc<[PathBuf]>,
    /// Calls of the engine's and the library's functions, in order of place. Elaboration fills them in.
    pub calls: Vec<CallDescription>,
}

/// How the names of the library's files begin.
pub const LIBRARY: &str = "<library>/";

/// Where a call of a function of the engine or the library is written, so that an error can be placed on an argument
/// without the compiler. A `throw` in the library is described as a call without arguments.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct CallDescription {
    /// Byte range `(file, start, end)` of the call.
    pub place: Place,
    /// Name and byte range of each argument that is written in the call; others are left to their defaults.
    pub arguments: Vec<(String, Place)>,
    /// Of a call in the library: for each argument the parameters of the function around the call that it is computed from.
    #[serde(default)]
    pub carried: Vec<(String, Vec<String>)>,
}

/// An input of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ParamDescription {
    pub name: String,
    pub doc: String,
    /// Number, Bool or String.
    pub repr: Repr,
    pub unit: UnitDescription,
    /// Only whole numbers are allowed.
    pub integral: bool,
    /// Allowed strings; empty if any string will do.
    pub choices: Vec<String>,
    /// The default and the ends of the allowed range in SI. They are computed by running the program's own
    /// functions, so elaboration fills them in; `None` before that, and for what is not there.
    pub default: Option<ParamValue>,
    pub low: Option<f64>,
    pub high: Option<f64>,
    /// Default and range are the same whatever other params are.
    pub independent: bool,
}

/// Value of a param.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ParamValue {
    Bool(bool),
    /// In SI.
    Number(f64),
    String(String),
}

/// A wanted observable.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct OutputDescription {
    pub name: String,
    pub doc: String,
    /// Index in [`ModelDescription::kernels`].
    pub site: usize,
    /// What results are shown in.
    pub unit: UnitDescription,
    /// Name of the coherent SI unit.
    pub si: String,
}

/// A function that the embedding program may provide in place of the model's own ([`crate::host`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HostFunctionDescription {
    /// As it is provided by: of a function of an imported module `module.name`.
    pub name: String,
    pub doc: String,
    pub parameters: Vec<HostValueDescription>,
    /// Its name is empty.
    pub result: HostValueDescription,
}

/// What a host function takes or gives.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct HostValueDescription {
    pub name: String,
    /// Number, Bool, String, Vector, or an array of these.
    pub repr: Repr,
    /// The type as the model writes it, like `Array(Length)`.
    #[serde(rename = "type")]
    pub ty: String,
    /// What the model shows its numbers in. They cross in coherent SI units.
    pub unit: UnitDescription,
}

/// How a number is shown: SI value = shown value * `factor`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct UnitDescription {
    /// E.g. `lbf*inch`; empty for a pure number.
    pub name: String,
    pub factor: f64,
    pub dimension: Exponents,
}

/// A dimension with a name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DimensionDescription {
    /// As annotations of the language have it: `Length`, `SecondMomentOfArea`.
    pub name: String,
    pub exponents: Exponents,
}

/// A symbolic site's kernel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelDescription {
    pub name: String,
    /// Number, Vector or Transform.
    pub repr: Repr,
    /// Highest time derivative computed beside the value.
    pub order: u8,
    pub inputs: usize,
    pub outputs: usize,
    pub captures: Vec<CaptureDescription>,
}

/// A value a symbolic expression captured when its binding executed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaptureDescription {
    pub name: String,
    pub repr: Repr,
    /// An observable: captured as its index, replaced by its value at each step.
    pub observable: bool,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FileDescription {
    pub name: String,
    pub text: String,
}

/// What many instances share, written as a list.
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
