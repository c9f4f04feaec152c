//! A compiled module as bytes, to be kept and loaded again.
//!
//! ```text
//! magic, format, length, SHA-256        52 bytes, little-endian; the checksum is over all other bytes
//! identity                              which version made it, for which engine and machine
//! contents                              description, machine code, functions of params
//! ```
//!
//! Identity and contents are encoded by `postcard`. Whatever the bytes are, reading them gives a module's parts or says
//! why not.

use calyx_abi::Fingerprint;
use calyx_abi::description::ModelDescription;
use calyx_codegen::{CodegenError, LoadError, Machine, ModuleCode, TargetCpu};
use calyx_gears::library::FINGERPRINT;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fmt;

/// What every artifact begins with. The first byte is no text, and a transfer that changes line ends changes the last.
const MAGIC: [u8; 8] = *b"\x89CALYX\r\n";

/// Counts changes of the layout described above, and of what identity and contents hold.
const FORMAT: u32 = 1;

const LENGTH_AT: usize = 12;
const CHECKSUM_AT: usize = 20;
const BODY_AT: usize = 52;

/// The version of Calyx, as artifacts state it.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Whether bytes are meant to be a compiled module: they begin as one.
pub fn is_artifact(bytes: &[u8]) -> bool {
    bytes.starts_with(&MAGIC)
}

/// Why bytes could not be loaded as a module. [`ArtifactError::help`] says what to do.
#[derive(Debug)]
pub enum ArtifactError {
    /// They do not begin as one.
    NotAnArtifact,
    /// There are fewer bytes than were written, or more.
    Length { found: u64, expected: u64 },
    /// The checksum does not fit the bytes.
    Corrupted,
    /// Its layout is that of another version of Calyx.
    Format { found: u32, expected: u32 },
    /// Another version of Calyx made it.
    Version { found: String, expected: String },
    /// It was compiled for an engine with other functions.
    Engine { found: Fingerprint, expected: Fingerprint },
    /// It is for another architecture or system.
    Target { found: String, expected: String },
    /// It is for a processor that can do more than this one.
    Processor { missing: Vec<String> },
    /// The checksum fits, but the contents contradict themselves.
    Malformed(String),
    /// The code cannot be put into memory.
    Code(LoadError),
    /// This machine is not one that Calyx compiles for.
    Machine(CodegenError),
}

impl ArtifactError {
    /// What to do about it, as a sentence.
    pub fn help(&self) -> &'static str {
        match self {
            ArtifactError::NotAnArtifact => {
                "give what `Module::serialize` made, or compile the model's source"
            }
            ArtifactError::Length { .. } | ArtifactError::Corrupted => {
                "copy it again from where it was made, as binary data, or compile the model again"
            }
            ArtifactError::Format { .. } | ArtifactError::Version { .. } | ArtifactError::Engine { .. } => {
                "compile the model again with this version of Calyx"
            }
            ArtifactError::Target { .. } => "compile the model on a machine of this kind",
            ArtifactError::Processor { .. } => {
                "compile the model on this machine, or for every processor of this kind"
            }
            ArtifactError::Malformed(_) | ArtifactError::Code(_) => {
                "compile the model again; if it was not changed since, please report this with the model"
            }
            ArtifactError::Machine(_) => "run it on an x86-64 or AArch64 machine",
        }
    }
}

impl fmt::Display for ArtifactError {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            ArtifactError::NotAnArtifact => f.write_str("this is not a compiled Calyx module"),
            ArtifactError::Length { found, expected } => {
                let what = if found < expected { "incomplete" } else { "followed by something else" };
                write!(f, "the compiled module is {what}: it has {found} bytes of {expected}")
            }
            ArtifactError::Corrupted => {
                f.write_str("the compiled module is damaged: its checksum does not fit")
            }
            ArtifactError::Format { found, expected } => write!(
                f,
                "the compiled module has the layout {found} and this version of Calyx reads the layout {expected}"
            ),
            ArtifactError::Version { found, expected } => {
                write!(f, "the module was compiled by Calyx {found} and this is Calyx {expected}")
            }
            ArtifactError::Engine { found, expected } => write!(
                f,
                "the module was compiled for an engine with the interface {found} and this engine has {expected}"
            ),
            ArtifactError::Target { found, expected } => {
                write!(f, "the module was compiled for {found} and this machine is {expected}")
            }
            ArtifactError::Processor { missing } => write!(
                f,
                "the module was compiled for a processor with {}, which this one lacks",
                missing.join(", ")
            ),
            ArtifactError::Malformed(what) => write!(f, "the compiled module cannot be read: {what}"),
            ArtifactError::Code(error) => write!(f, "the compiled module cannot be loaded: {error}"),
            ArtifactError::Machine(error) => write!(f, "{error}"),
        }
    }
}

impl std::error::Error for ArtifactError {}

/// Which version made an artifact, and what it runs on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Identity {
    version: String,
    engine: Fingerprint,
    machine: Machine,
}

/// What a module is made of.
#[derive(Debug)]
pub struct Contents {
    pub description: ModelDescription,
    pub code: ModuleCode,
    /// Of each param the numbers of its functions: default, low and high end.
    pub params: Vec<[Option<u32>; 3]>,
}

/// The contents as they are written: the description is JSON, as in object files.
#[derive(Serialize, Deserialize)]
struct Written {
    description: String,
    code: ModuleCode,
    params: Vec<[Option<u32>; 3]>,
}

/// Writes an artifact of a module for processors of some kind.
pub fn write(contents: Contents, cpu: TargetCpu) -> Result<Vec<u8>, WriteError> {
    let machine = Machine::new(cpu).map_err(WriteError::Machine)?;
    let identity = Identity { version: VERSION.into(), engine: FINGERPRINT, machine };
    let Contents { description, code, params } = contents;
    let description = calyx_lang::description::to_json(&description).map_err(WriteError::Description)?;
    let written = Written { description, code, params };
    let body = postcard::to_stdvec(&(identity, written)).map_err(WriteError::Encoding)?;
    Ok(framed(FORMAT, &body))
}

/// Why an artifact could not be written.
#[derive(Debug)]
pub enum WriteError {
    Machine(CodegenError),
    Description(serde_json::Error),
    Encoding(postcard::Error),
}

/// A body behind its header.
fn framed(format: u32, body: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(BODY_AT + body.len());
    bytes.extend(MAGIC);
    bytes.extend(format.to_le_bytes());
    bytes.extend((body.len() as u64).to_le_bytes());
    let checksum = checksum(&bytes, body);
    bytes.extend(checksum);
    bytes.extend(body);
    bytes
}

fn checksum(header: &[u8], body: &[u8]) -> [u8; 32] {
    Sha256::new().chain_update(header).chain_update(body).finalize().into()
}

/// Reads an artifact that this version made for a machine like this one.
pub fn read(bytes: &[u8]) -> Result<Contents, ArtifactError> {
    let body = body(bytes)?;
    let machine = Machine::new(TargetCpu::Native).map_err(ArtifactError::Machine)?;
    let unreadable = |error: postcard::Error| ArtifactError::Malformed(error.to_string());
    let (identity, rest) = postcard::take_from_bytes::<Identity>(body).map_err(unreadable)?;
    fits(identity, &machine)?;
    let (written, rest) = postcard::take_from_bytes::<Written>(rest).map_err(unreadable)?;
    if !rest.is_empty() {
        return Err(ArtifactError::Malformed("there is more in it than a module".into()));
    }
    let Written { description, code, params } = written;
    let description = calyx_lang::description::from_json(&description)
        .map_err(|error| ArtifactError::Malformed(error.to_string()))?;
    let contents = Contents { description, code, params };
    if !contents.agree() {
        return Err(ArtifactError::Malformed("its description does not fit its code".into()));
    }
    Ok(contents)
}

/// What follows the header, if all of it is there as it was written.
fn body(bytes: &[u8]) -> Result<&[u8], ArtifactError> {
    if !is_artifact(bytes) {
        return Err(ArtifactError::NotAnArtifact);
    }
    let Some((header, body)) = bytes.split_at_checked(BODY_AT) else {
        return Err(ArtifactError::Length { found: bytes.len() as u64, expected: BODY_AT as u64 });
    };
    let format = u32::from_le_bytes(part(header, MAGIC.len()));
    if format != FORMAT {
        return Err(ArtifactError::Format { found: format, expected: FORMAT });
    }
    let length = u64::from_le_bytes(part(header, LENGTH_AT));
    if length != body.len() as u64 {
        let expected = length.saturating_add(BODY_AT as u64);
        return Err(ArtifactError::Length { found: bytes.len() as u64, expected });
    }
    if checksum(&header[..CHECKSUM_AT], body) != header[CHECKSUM_AT..] {
        return Err(ArtifactError::Corrupted);
    }
    Ok(body)
}

/// Bytes of a header from an offset on.
fn part<const N: usize>(header: &[u8], at: usize) -> [u8; N] {
    std::array::from_fn(|i| header.get(at + i).copied().unwrap_or(0))
}

/// Whether this version can run it on this machine.
fn fits(identity: Identity, machine: &Machine) -> Result<(), ArtifactError> {
    if identity.version != VERSION {
        return Err(ArtifactError::Version { found: identity.version, expected: VERSION.into() });
    }
    if identity.engine != FINGERPRINT {
        return Err(ArtifactError::Engine { found: identity.engine, expected: FINGERPRINT });
    }
    if identity.machine.triple != machine.triple {
        let expected = machine.triple.clone();
        return Err(ArtifactError::Target { found: identity.machine.triple, expected });
    }
    let missing: Vec<_> = identity.machine.lacking_on(machine).into_iter().map(str::to_owned).collect();
    if missing.is_empty() { Ok(()) } else { Err(ArtifactError::Processor { missing }) }
}

impl Contents {
    /// Whether the description counts what the code has.
    fn agree(&self) -> bool {
        let kernels = self.description.kernels.iter().map(|kernel| (kernel.inputs, kernel.outputs));
        let there = |function: &Option<u32>| function.is_none_or(|number| self.code.has_function(number));
        kernels.eq(self.code.kernel_sizes())
            && self.params.len() == self.description.params.len()
            && self.params.iter().flatten().all(there)
    }
}

#[cfg(test)]
#[path = "artifact_tests.rs"]
mod tests;
