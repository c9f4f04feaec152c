//! Marker line that identifies the process that writes to a directory.

use super::{OWNER, read as text_of};
use std::fs::File;
use std::time::{SystemTime, UNIX_EPOCH};

/// Returns the line of this process: its id, its machine and the time.
pub(super) fn line() -> String {
    let since = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
    format!("{OWNER}process {} on {}, since {}\n", std::process::id(), host(), utc(since))
}

/// Returns the process in the last such line of a marker.
pub(super) fn read(marker: &File) -> String {
    let text = text_of(marker).unwrap_or_default();
    let mut lines = text.split_inclusive('\n').filter_map(|line| line.strip_suffix('\n'));
    let last = lines.rfind(|line| line.starts_with(OWNER));
    let known = last.and_then(|line| line.strip_prefix(OWNER));
    let printable = known.map(|known| known.chars().filter(|c| !c.is_control()).take(300).collect());
    printable.unwrap_or_else(|| "a process that has just begun".into())
}

/// Returns the name of the machine.
fn host() -> String {
    let mut name = [0_u8; 256];
    // SAFETY: the length matches the buffer.
    let status = unsafe { libc::gethostname(name.as_mut_ptr().cast(), name.len()) };
    let length = name.iter().position(|&byte| byte == 0).unwrap_or(name.len());
    match std::str::from_utf8(&name[..length]) {
        Ok(name) if status == 0 && !name.is_empty() && !name.contains(char::is_control) => name.to_owned(),
        _ => "an unknown machine".into(),
    }
}

/// Formats seconds since 1970 as date and time.
///
/// Source: H. Hinnant, "chrono-Compatible Low-Level Date Algorithms", `civil_from_days`.
pub fn utc(seconds: u64) -> String {
    let (days, second) = (seconds / 86_400, seconds % 86_400);
    let shifted = days + 719_468;
    let (era, day_of_era) = (shifted / 146_097, shifted % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let march_month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * march_month + 2) / 5 + 1;
    let month = if march_month < 10 { march_month + 3 } else { march_month - 9 };
    let year = year_of_era + 400 * era + u64::from(month <= 2);
    let (hour, minute, second) = (second / 3600, second / 60 % 60, second % 60);
    format!("{year}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02} UTC")
}
