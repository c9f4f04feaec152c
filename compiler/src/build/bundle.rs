//! Executables made without a linker: a copy of `calyx` with a module behind its end.
//!
//! Systems load what an executable's own tables name and never look behind it. There stands the module, then a trailer of
//! fixed size by which the copy, when it starts, finds it: checksum, length, and a word that says what it is.

use sha2::{Digest, Sha256};
use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// The last bytes of every bundle.
const MARK: &[u8; 8] = b"\nCALYX1\n";
/// SHA-256 of the module, its length as 64 bits with the least first, and [`MARK`].
const TRAILER: usize = 32 + 8 + 8;

/// A bundle whose module cannot be used: the file was cut or changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DamagedBundle;

impl fmt::Display for DamagedBundle {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the model in this executable is damaged")
    }
}

impl std::error::Error for DamagedBundle {}

/// Writes a copy of an executable with a module behind it.
///
/// # Errors
/// The executable cannot be read or the copy not written.
pub(super) fn write(executable: &Path, module: &[u8], target: &Path) -> io::Result<()> {
    // With its permissions.
    fs::copy(executable, target)?;
    let mut file = OpenOptions::new().append(true).open(target)?;
    file.write_all(module)?;
    file.write_all(&Sha256::digest(module))?;
    file.write_all(&(module.len() as u64).to_le_bytes())?;
    file.write_all(MARK)
}

/// The module behind an executable; `None` if there is none.
///
/// # Errors
/// The file cannot be read. Within: it is a bundle and is damaged.
pub fn read(executable: &Path) -> io::Result<Option<Result<Vec<u8>, DamagedBundle>>> {
    let mut file = File::open(executable)?;
    let size = file.metadata()?.len();
    let Some(end) = size.checked_sub(TRAILER as u64) else { return Ok(None) };
    let mut trailer = [0; TRAILER];
    file.seek(SeekFrom::Start(end))?;
    file.read_exact(&mut trailer)?;
    let (checksum, rest) = trailer.split_at(32);
    let (length, mark) = rest.split_at(8);
    if mark != MARK {
        return Ok(None);
    }
    let length = length.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte));
    let Some(begin) = end.checked_sub(length) else { return Ok(Some(Err(DamagedBundle))) };
    file.seek(SeekFrom::Start(begin))?;
    let mut module = Vec::new();
    file.take(length).read_to_end(&mut module)?;
    let whole = Sha256::digest(&module)[..] == *checksum;
    Ok(Some(if whole { Ok(module) } else { Err(DamagedBundle) }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_are_read_back_and_damage_is_seen() {
        let directory = tempfile::tempdir().unwrap();
        let [plain, bundle] = ["plain", "bundle"].map(|name| directory.path().join(name));
        for program in [&b""[..], b"short", &[7; 1000]] {
            fs::write(&plain, program).unwrap();
            assert_eq!(read(&plain).unwrap(), None);
            for module in [&b""[..], b"a module", &[3; 100]] {
                write(&plain, module, &bundle).unwrap();
                assert_eq!(read(&bundle).unwrap(), Some(Ok(module.to_vec())));
                let bytes = fs::read(&bundle).unwrap();
                assert!(bytes.starts_with(program));
                // Any byte of module, checksum or length.
                for place in program.len()..bytes.len() - MARK.len() {
                    let mut damaged = bytes.clone();
                    damaged[place] ^= 1;
                    fs::write(&plain, &damaged).unwrap();
                    assert_eq!(read(&plain).unwrap(), Some(Err(DamagedBundle)), "{place}");
                }
                fs::write(&plain, program).unwrap();
            }
        }
    }
}
