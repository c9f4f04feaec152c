//! Executables without a linker: a copy of `calyx` with an appended module.
//!
//! Operating systems load the parts of an executable that its tables list and ignore data after
//! them. The module is appended there, followed by a trailer of fixed size with checksum, length
//! and a mark. The copy finds the module by this trailer when it starts.

use sha2::{Digest, Sha256};
use std::fmt;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::Path;

/// Last bytes of every bundle.
const MARK: &[u8; 8] = b"\nCALYX1\n";
/// Size of the trailer: SHA-256 of the module, its length (64 bits, little-endian), and [`MARK`].
const TRAILER: usize = 32 + 8 + 8;

/// Bundle with an invalid module: the file was truncated or changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DamagedBundle;

impl fmt::Display for DamagedBundle {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the model in this executable is damaged")
    }
}

impl std::error::Error for DamagedBundle {}

/// Writes a copy of an executable with an appended module.
///
/// # Errors
/// If the executable cannot be read or the copy cannot be written.
pub(super) fn write(executable: &Path, module: &[u8], target: &Path) -> io::Result<()> {
    // Copies the permissions too.
    fs::copy(executable, target)?;
    let mut file = OpenOptions::new().append(true).open(target)?;
    file.write_all(module)?;
    file.write_all(&Sha256::digest(module))?;
    file.write_all(&(module.len() as u64).to_le_bytes())?;
    file.write_all(MARK)
}

/// Returns the module appended to an executable; `None` if there is none.
///
/// # Errors
/// If the file cannot be read. The inner error reports a damaged bundle.
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
