//! Machine code as data: what a module's code is made of, so that it can be kept and loaded again.
//!
//! [`crate::compile_code`] makes it (module `recorder`), [`crate::load_code`] puts it into memory (module `load`). It says
//! by name what it calls, and by number what is its own.

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
    /// Link symbols of what it calls: helpers, numeric functions and functions of the engine.
    pub(crate) imports: Vec<String>,
    pub(crate) functions: Vec<FunctionCode>,
    /// Constants.
    pub(crate) data: Vec<DataCode>,
    /// The functions of the program, in order of its own.
    pub(crate) program: Vec<ProgramFunction>,
    /// In order of site.
    pub(crate) kernels: Vec<KernelFunction>,
    /// Which function of the program is its top level.
    pub(crate) main: u32,
}

impl ModuleCode {
    /// Whether there is a function of this number in the program.
    pub fn has_function(&self, number: u32) -> bool {
        (number as usize) < self.program.len()
    }

    /// How many numbers each kernel takes and gives, in order of site.
    pub fn kernel_sizes(&self) -> impl Iterator<Item = (usize, usize)> {
        self.kernels.iter().map(|kernel| (kernel.inputs as usize, kernel.outputs as usize))
    }
}

/// One function's code.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FunctionCode {
    #[serde(with = "serde_bytes")]
    pub bytes: Vec<u8>,
    /// A power of two.
    pub alignment: u64,
    pub relocations: Vec<Relocation>,
}

/// Constant bytes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DataCode {
    #[serde(with = "serde_bytes")]
    pub bytes: Vec<u8>,
    /// A power of two.
    pub alignment: u64,
}

/// An address that is written into code when it is loaded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Relocation {
    /// Where, from the function's start.
    pub offset: u32,
    pub kind: RelocationKind,
    pub target: Target,
    pub addend: i64,
}

/// Whose address.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Target {
    /// Of a row of [`ModuleCode::imports`].
    Import(u32),
    /// Of a row of [`ModuleCode::functions`].
    Function(u32),
    /// Of a row of [`ModuleCode::data`].
    Data(u32),
}

/// A function of the program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ProgramFunction {
    /// Row of [`ModuleCode::functions`].
    pub function: u32,
    pub signature: Signature,
}

/// A kernel.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct KernelFunction {
    /// Row of [`ModuleCode::functions`].
    pub function: u32,
    pub inputs: u32,
    pub outputs: u32,
}

macro_rules! relocation_kinds {
    ($($(#[$doc:meta])* $kind:ident: $bytes:literal),+ $(,)?) => {
        /// How an address is written: the kinds that code of this compiler has on the machines it knows.
        #[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
        pub enum RelocationKind { $($(#[$doc])* $kind),+ }

        impl RelocationKind {
            /// `None` if code of this kind cannot be kept.
            pub fn new(kind: binemit::Reloc) -> Option<Self> {
                match kind {
                    $(binemit::Reloc::$kind => Some(RelocationKind::$kind),)+
                    _ => None,
                }
            }

            /// As Cranelift has it.
            pub fn kind(self) -> binemit::Reloc {
                match self { $(RelocationKind::$kind => binemit::Reloc::$kind),+ }
            }

            /// Bytes of code it changes.
            pub fn width(self) -> usize {
                match self { $(RelocationKind::$kind => $bytes),+ }
            }
        }
    };
}

relocation_kinds! {
    /// The whole address.
    Abs8: 8,
    X86PCRel4: 4,
    X86CallPCRel4: 4,
    Arm64Call: 4,
    Aarch64AdrPrelPgHi21: 4,
    Aarch64AddAbsLo12Nc: 4,
}

impl RelocationKind {
    /// Whether it reaches any address. The others reach what lies near.
    pub fn is_absolute(self) -> bool {
        matches!(self, RelocationKind::Abs8)
    }
}

/// The machine that code is for.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// Architecture and system, like `x86_64-unknown-linux-gnu`.
    pub triple: String,
    /// What the processor must be able to do, as Cranelift calls it (`has_avx2`), in alphabetical order.
    pub features: Vec<String>,
}

impl Machine {
    /// The machine that [`crate::compile_code`] compiles for.
    ///
    /// # Errors
    /// Cranelift does not know this machine.
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

    /// Which features of this machine's code another machine lacks.
    pub fn lacking_on(&self, other: &Machine) -> Vec<&str> {
        let lacks = |feature: &&String| !other.features.contains(feature);
        self.features.iter().filter(lacks).map(String::as_str).collect()
    }
}

/// Why code could not be loaded.
#[derive(Debug)]
pub enum LoadError {
    /// It refers to something that is not there.
    Malformed(&'static str),
    /// It calls a function that this engine does not have.
    Unknown(String),
    /// Memory for it could not be had.
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
