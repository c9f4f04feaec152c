//! Limits of a run as users write them, and the memory that the process takes.

use std::time::Duration;

/// Reads `10s`, `500 ms`, `2 min`, `1 h`; a bare number is in seconds.
///
/// # Errors
/// What is wrong with it.
pub fn time(text: &str) -> Result<Duration, String> {
    let units = [("ms", 1e-3), ("min", 60.0), ("s", 1.0), ("h", 3600.0)];
    let seconds = quantity(text, &units)?;
    Duration::try_from_secs_f64(seconds).map_err(|_| format!("`{text}` is too long"))
}

/// Reads `2GB`, `500 MB`, `64 kB`; a bare number is in bytes.
///
/// # Errors
/// What is wrong with it.
pub fn memory(text: &str) -> Result<u64, String> {
    let units = [("kB", 1e3), ("MB", 1e6), ("GB", 1e9), ("TB", 1e12)];
    Ok(quantity(text, &units)? as u64)
}

fn quantity(text: &str, units: &[(&str, f64)]) -> Result<f64, String> {
    let trimmed = text.trim();
    let end = trimmed.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(trimmed.len());
    let (number, unit) = (trimmed[..end].trim(), trimmed[end..].trim());
    let names = || units.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let factor = match unit {
        "" => 1.0,
        _ => match units.iter().find(|(name, _)| name.eq_ignore_ascii_case(unit)) {
            Some((_, factor)) => *factor,
            None => return Err(format!("`{unit}` is none of the units {}", names())),
        },
    };
    match number.parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value * factor),
        _ => Err(format!("`{number}` is no number; give it like `10{}`", units[0].0)),
    }
}

/// Returns memory that was freed to the system, where the allocator can: it keeps what small values took, and a limit of a run
/// would count that twice.
pub fn return_freed() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: it touches free memory alone, and may be called at any time.
    unsafe {
        libc::malloc_trim(0);
    }
}

/// Bytes of memory that this process takes, where the system tells.
pub fn taken() -> Option<u64> {
    told("/proc/self/status", "VmRSS:")
}

/// Bytes of memory that the machine can still give, where the system tells.
pub fn available() -> Option<u64> {
    told("/proc/meminfo", "MemAvailable:")
}

/// What the system says in a file, in kilobytes, under a name.
fn told(file: &str, name: &str) -> Option<u64> {
    let said = std::fs::read_to_string(file).ok()?;
    let line = said.lines().find_map(|line| line.strip_prefix(name))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_read_as_they_are_written() {
        assert_eq!(time("10s").unwrap(), Duration::from_secs(10));
        assert_eq!(time("500 ms").unwrap(), Duration::from_millis(500));
        assert_eq!(time("1.5 min").unwrap(), Duration::from_secs(90));
        assert_eq!(time("3").unwrap(), Duration::from_secs(3));
        assert_eq!(memory("2GB").unwrap(), 2_000_000_000);
        assert_eq!(memory("64 kB").unwrap(), 64_000);
        for wrong in ["ten", "10 weeks", "-1s", "", "nan s"] {
            assert!(time(wrong).is_err(), "{wrong}");
        }
        assert!(memory("2 s").unwrap_err().contains("`GB`"));
    }
}
