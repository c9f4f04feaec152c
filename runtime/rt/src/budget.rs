//! Time and memory limits of a run as users write them, and the memory use of the process.

use std::time::Duration;

/// Parses a duration such as `10s`, `500 ms`, `2 min` or `1 h`; a bare number is in seconds.
///
/// # Errors
/// A description of the syntax error.
pub fn time(text: &str) -> Result<Duration, String> {
    let units = [("ms", 1e-3), ("min", 60.0), ("s", 1.0), ("h", 3600.0)];
    let seconds = quantity(text, &units)?;
    Duration::try_from_secs_f64(seconds).map_err(|_| format!("`{text}` is too long"))
}

/// Parses a memory size such as `2GB`, `500 MB` or `64 kB`; a bare number is in bytes.
///
/// # Errors
/// A description of the syntax error.
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
        _ => Err(format!("`{number}` is not a number; write it like `10{}`", units[0].0)),
    }
}

/// Limits the allocator to one arena for all threads, before they start. By default threads have
/// arenas of their own, and [`return_freed`] may leave up to 64 MB of freed memory in one of them:
/// glibc returns the memory at the top of the main arena only. The limit of a run would count it.
pub fn share_one_arena() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: `mallopt` sets a parameter of the allocator and may be called at any time.
    unsafe {
        libc::mallopt(libc::M_ARENA_MAX, 1);
    }
}

/// Returns freed memory to the system, if the allocator supports that. The allocator retains the
/// memory of small values, and the memory limit of a run would count it twice.
pub fn return_freed() {
    #[cfg(all(target_os = "linux", target_env = "gnu"))]
    // SAFETY: `malloc_trim` affects free memory only and may be called at any time.
    unsafe {
        libc::malloc_trim(0);
    }
}

/// Returns the resident memory of this process in bytes, if the system reports it.
pub fn taken() -> Option<u64> {
    system_entry("/proc/self/status", "VmRSS:")
}

/// Returns the available memory of the machine in bytes, if the system reports it.
pub fn available() -> Option<u64> {
    system_entry("/proc/meminfo", "MemAvailable:")
}

/// Reads the entry `name` of a system file, in kilobytes.
fn system_entry(file: &str, name: &str) -> Option<u64> {
    let text = std::fs::read_to_string(file).ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kilobytes * 1024)
}
