//! Serialized compiled modules.
//!
//! ```text
//! magic, format, length, SHA-256        52 bytes, little-endian; the hash is of all other bytes
//! identity                              version of Calyx, engine and target machine
//! contents                              description, machine code, functions of params
//! ```
//!
//! Identity and contents are encoded by `postcard`. Reading accepts arbitrary bytes: the result is
//! the contents of a module or an error.

use calyx_abi::Fingerprint;
use calyx_abi::description::ModelDescription;
use calyx_codegen::{CodegenError, LoadError, Machine, ModuleCode, TargetCpu};
use calyx_gears::library::FINGERPRINT;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use std::fmt;

/// First bytes of every artifact. The first byte is not ASCII, and a transfer that converts line
/// ends changes the last two.
const MAGIC: [u8; 8] = *b"\x89CALYX\r\n";

/// Version of the layout described above, including the fields of identity and contents.
const FORMAT: u32 = 1;

const LENGTH_AT: usize = 12;
const CHECKSUM_AT: usize = 20;
const BODY_AT: usize = 52;

/// Version of Calyx, as stored in artifacts.
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Returns true if the bytes begin with the magic of a compiled module.
pub fn is_artifact(bytes: &[u8]) -> bool {
    bytes.starts_with(&MAGIC)
}

/// Error of loading a module from bytes. [`ArtifactError::help`] returns the remedy.
#[derive(Debug)]
pub enum ArtifactError {
    /// The bytes do not begin with the magic.
    NotAnArtifact,
    /// The length differs from the one in the header.
    Length { found: u64, expected: u64 },
    /// The checksum does not match the bytes.
    Corrupted,
    /// The layout belongs to another version of Calyx.
    Format { found: u32, expected: u32 },
    /// The artifact was created by another version of Calyx.
    Version { found: String, expected: String },
    /// The artifact was compiled for an engine with other functions.
    Engine { found: Fingerprint, expected: Fingerprint },
    /// The artifact is for another architecture or operating system.
    Target { found: String, expected: String },
    /// The artifact requires instruction sets that this processor lacks.
    Processor { missing: Vec<String> },
    /// The checksum matches, but the contents are inconsistent.
    Malformed(String),
    /// The code cannot be loaded into memory.
    Code(LoadError),
    /// Calyx does not support this machine.
    Machine(CodegenError),
}

impl ArtifactError {
    /// Returns the remedy as a sentence.
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

/// Creator and target of an artifact.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Identity {
    version: String,
    engine: Fingerprint,
    machine: Machine,
}

/// Parts of a module.
#[derive(Debug)]
pub struct Contents {
    pub description: ModelDescription,
    pub code: ModuleCode,
    /// Function ids of each param: default, lower and upper bound.
    pub params: Vec<[Option<u32>; 3]>,
}

/// Encoded form of the contents: the description is JSON, as in object files.
#[derive(Serialize, Deserialize)]
struct Written {
    description: String,
    code: ModuleCode,
    params: Vec<[Option<u32>; 3]>,
}

/// Writes an artifact of a module for a kind of processors.
pub fn write(contents: Contents, cpu: TargetCpu) -> Result<Vec<u8>, WriteError> {
    let machine = Machine::new(cpu).map_err(WriteError::Machine)?;
    let identity = Identity { version: VERSION.into(), engine: FINGERPRINT, machine };
    let Contents { description, code, params } = contents;
    let description = calyx_lang::description::to_json(&description).map_err(WriteError::Description)?;
    let written = Written { description, code, params };
    let body = postcard::to_stdvec(&(identity, written)).map_err(WriteError::Encoding)?;
    Ok(framed(FORMAT, &body))
}

/// Error of writing an artifact.
#[derive(Debug)]
pub enum WriteError {
    Machine(CodegenError),
    Description(serde_json::Error),
    Encoding(postcard::Error),
}

/// Adds the header to a body.
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

/// Reads an artifact of this version for a machine compatible with this one.
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

/// Returns the body after the header, after comparing length and checksum.
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

/// Returns bytes of a header from an offset.
fn part<const N: usize>(header: &[u8], at: usize) -> [u8; N] {
    std::array::from_fn(|i| header.get(at + i).copied().unwrap_or(0))
}

/// Checks that this version can run the artifact on this machine.
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
    /// Returns true if the counts in the description match the code.
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
