//! Recognizes files of earlier builds: only those are replaced.

use super::{Emit, bundle};
use object::read::archive::ArchiveFile;
use std::fs;
use std::path::Path;

/// Parts of a model's description, which every object file contains and which survive linking and
/// stripping.
const DESCRIPTION: [&[u8]; 2] = [b"],\"host_functions\":[", b"],\"known_units\":[{\"name\":\""];
/// Magic numbers of executables and object files: ELF and 64-bit Mach-O.
const OBJECT: [&[u8]; 2] = [b"\x7fELF", b"\xcf\xfa\xed\xfe"];

/// Returns true if `calyx build` created this file from some model, as this kind of output.
pub(super) fn is_built(path: &Path, emit: Emit) -> bool {
    if !path.is_file() {
        return false;
    }
    if emit == Emit::Executable && bundle::read(path).is_ok_and(|module| module.is_some()) {
        return true;
    }
    let Ok(bytes) = fs::read(path) else { return false };
    match emit {
        Emit::Executable | Emit::Object => is_object_of_a_model(&bytes),
        // The model is the first member.
        Emit::Library => ArchiveFile::parse(&*bytes).is_ok_and(|archive| {
            let first = archive.members().next().and_then(Result::ok);
            first.and_then(|member| member.data(&*bytes).ok()).is_some_and(is_object_of_a_model)
        }),
        Emit::Header => {
            bytes.starts_with(b"#ifndef CALYX_H\n") && contains(&bytes, b"\n#ifndef CALYX_MODEL_")
        }
    }
}

fn is_object_of_a_model(bytes: &[u8]) -> bool {
    OBJECT.iter().any(|magic| bytes.starts_with(magic))
        && DESCRIPTION.iter().all(|part| contains(bytes, part))
}

fn contains(bytes: &[u8], part: &[u8]) -> bool {
    bytes.windows(part.len()).any(|window| window == part)
}
