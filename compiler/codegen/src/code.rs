//! Machine code as data, so that it can be stored and loaded again.
//!
//! [`crate::compile_code`] produces it (module `recorder`), and [`crate::load_code`] places it in
//! memory (module `load`). External functions are referenced by symbol, the module's own functions
//! and constants by index.

use crate::backend::{TargetCpu, position_dependent_isa};
use crate::error::CodegenError;
use crate::jit::Signature;
use cranelift_codegen::binemit;
use cranelift_codegen::isa::TargetIsa;
use serde::{Deserialize, Serialize};
use std::fmt;

/// The machine code of a program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModuleCode {
    /// Link symbols of the external functions: helpers, numeric functions and functions of the
    /// engine.
    pub(crate) imports: Vec<String>,
    pub(crate) functions: Vec<FunctionCode>,
    /// Constants.
    pub(crate) data: Vec<DataCode>,
    /// The functions of the program, in order of `Program::functions`.
    pub(crate) program: Vec<ProgramFunction>,
    /// Kernels in order of the sites.
    pub(crate) kernels: Vec<KernelFunction>,
    /// Index of the program function for the top level.
    pub(crate) main: u32,
}

impl ModuleCode {
    /// Returns `true` if the program has a function with this index.
    pub fn has_function(&self, number: u32) -> bool {
        (number as usize) < self.program.len()
    }

    /// Returns the numbers of inputs and outputs of each kernel, in order of the sites.
    pub fn kernel_sizes(&self) -> impl Iterator<Item = (usize, usize)> {
        self.kernels.iter().map(|kernel| (kernel.inputs as usize, kernel.outputs as usize))
    }
}

/// The code of one function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FunctionCode {
    #[serde(with = "serde_bytes")]
    pub bytes: Vec<u8>,
    /// Alignment, a power of two.
    pub alignment: u64,
    pub relocations: Vec<Relocation>,
}

/// Constant bytes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DataCode {
    #[serde(with = "serde_bytes")]
    pub bytes: Vec<u8>,
    /// Alignment, a power of two.
    pub alignment: u64,
}

/// An address that is written into code when it is loaded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Relocation {
    /// Offset from the start of the function, bytes.
    pub offset: u32,
    pub kind: RelocationKind,
    pub target: Target,
    pub addend: i64,
}

/// The symbol whose address is written.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Target {
    /// An index of [`ModuleCode::imports`].
    Import(u32),
    /// An index of [`ModuleCode::functions`].
    Function(u32),
    /// An index of [`ModuleCode::data`].
    Data(u32),
}

/// A function of the program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProgramFunction {
    /// Index in [`ModuleCode::functions`].
    pub function: u32,
    pub signature: Signature,
}

/// A kernel and its function.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelFunction {
    /// Index in [`ModuleCode::functions`].
    pub function: u32,
    pub inputs: u32,
    pub outputs: u32,
}

macro_rules! relocation_kinds {
    ($($(#[$doc:meta])* $kind:ident: $bytes:literal),+ $(,)?) => {
        /// The encoding of an address: the relocation kinds that Cranelift emits on the supported
        /// machines.
        #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
        pub enum RelocationKind { $($(#[$doc])* $kind),+ }

        impl RelocationKind {
            /// Converts Cranelift's relocation kind; `None` if code with this kind cannot be
            /// stored.
            pub fn new(kind: binemit::Reloc) -> Option<Self> {
                match kind {
                    $(binemit::Reloc::$kind => Some(RelocationKind::$kind),)+
                    _ => None,
                }
            }

            /// Returns Cranelift's relocation kind.
            pub fn kind(self) -> binemit::Reloc {
                match self { $(RelocationKind::$kind => binemit::Reloc::$kind),+ }
            }

            /// Returns the number of code bytes that the relocation changes.
            pub fn width(self) -> usize {
                match self { $(RelocationKind::$kind => $bytes),+ }
            }
        }
    };
}

relocation_kinds! {
    /// The absolute address.
    Abs8: 8,
    X86PCRel4: 4,
    X86CallPCRel4: 4,
    Arm64Call: 4,
    Aarch64AdrPrelPgHi21: 4,
    Aarch64AddAbsLo12Nc: 4,
}

impl RelocationKind {
    /// Returns `true` if the relocation reaches any address. The others are relative and have a
    /// limited range.
    pub fn is_absolute(self) -> bool {
        matches!(self, RelocationKind::Abs8)
    }
}

/// The machine for which code was compiled.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// Architecture and system, like `x86_64-unknown-linux-gnu`.
    pub triple: String,
    /// Required processor features in Cranelift's notation (`has_avx2`), in alphabetical order.
    pub features: Vec<String>,
}

impl Machine {
    /// Returns the machine for which [`crate::compile_code`] compiles.
    ///
    /// # Errors
    /// Cranelift does not support this machine.
    pub fn new(cpu: TargetCpu) -> Result<Machine, CodegenError> {
        Ok(Machine::of(&*position_dependent_isa(cpu)?))
    }

    fn of(isa: &dyn TargetIsa) -> Machine {
        let flags = isa.isa_flags();
        let enabled = flags.iter().filter(|flag| flag.as_bool() == Some(true));
        let mut features: Vec<_> = enabled.map(|flag| flag.name.to_owned()).collect();
        features.sort();
        Machine { triple: isa.triple().to_string(), features }
    }

    /// Returns the features that code for this machine requires and another machine lacks.
    pub fn lacking_on(&self, other: &Machine) -> Vec<&str> {
        let lacks = |feature: &&String| !other.features.contains(feature);
        self.features.iter().filter(lacks).map(String::as_str).collect()
    }
}

/// The reason why code could not be loaded.
#[derive(Debug)]
pub enum LoadError {
    /// It refers to an item that does not exist.
    Malformed(&'static str),
    /// It calls a function that this engine does not have.
    Unknown(String),
    /// Its memory could not be allocated.
    Memory(CodegenError),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            LoadError::Malformed(what) => write!(f, "the code holds {what}"),
            LoadError::Unknown(symbol) => {
                write!(f, "the code calls `{symbol}`, which this engine does not have")
            }
            LoadError::Memory(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for LoadError {}
