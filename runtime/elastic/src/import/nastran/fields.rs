//! Field formats of bulk data lines, and the forms of numbers.
//!
//! Source: NASTRAN Quick Reference Guide, "Format of Bulk Data Entries": small-field, large-field
//! and free-field format, continuations, real numbers.

/// Physical line of bulk data.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Line {
    /// Name of the card in upper case; for a continuation, its name without `+` and `*`.
    pub name: String,
    /// True if the line continues a card.
    pub continues: bool,
    /// True in large-field format.
    pub large: bool,
    /// Data fields: eight, or four in large-field format.
    pub fields: Vec<String>,
    /// Name of the continuation that follows: field 10 without `+` and `*`.
    pub next: String,
}

/// Splits a line. Returns `None` for a blank line or a comment.
pub(super) fn split(line: &str) -> Result<Option<Line>, String> {
    let data = line.split('$').next().unwrap_or_default().trim_end();
    if data.trim().is_empty() {
        return Ok(None);
    }
    if !data.is_ascii() {
        return Err("the line has characters that are not ASCII".into());
    }
    let data = data.to_ascii_uppercase();
    if data.contains(',') { free(&data).map(Some) } else { fixed(&data).map(Some) }
}

/// Name, whether the line continues a card, and whether it is in large-field format.
fn first_field(field: &str) -> Result<(String, bool, bool), String> {
    let field = field.trim();
    let continues = field.is_empty() || field.starts_with(['+', '*']);
    let large = if continues { field.starts_with('*') } else { field.ends_with('*') };
    let name = field.trim_matches(['+', '*']).trim().to_owned();
    // Names of continuations may contain blanks.
    if !continues && (name.is_empty() || name.contains(char::is_whitespace)) {
        return Err(format!("the first field `{field}` is not the name of a card"));
    }
    if field == "=" || field.starts_with("=(") || field.starts_with('/') {
        return Err(format!("replication and deletion (`{field}`) are not supported"));
    }
    Ok((name, continues, large))
}

fn free(data: &str) -> Result<Line, String> {
    let parts: Vec<&str> = data.split(',').map(str::trim).collect();
    let (name, continues, large) = first_field(parts[0])?;
    let count = if large { 4 } else { 8 };
    let mut fields: Vec<String> = parts.iter().skip(1).take(count).map(|part| (*part).to_owned()).collect();
    fields.resize(count, String::new());
    let rest = &parts[parts.len().min(count + 1)..];
    let next = rest.first().copied().unwrap_or_default();
    let extra = rest.iter().skip(1).any(|part| !part.is_empty());
    if extra || !(next.is_empty() || next.starts_with(['+', '*'])) {
        return Err(format!("the line has more than {count} data fields"));
    }
    Ok(Line { name, continues, large, fields, next: continuation_name(next) })
}

fn fixed(data: &str) -> Result<Line, String> {
    let data = expand_tabs(data);
    let column = |from: usize, to: usize| data.get(from..to.min(data.len())).unwrap_or_default().trim();
    let (name, continues, large) = first_field(column(0, 8))?;
    let (count, width) = if large { (4, 16) } else { (8, 8) };
    let fields = (0..count).map(|i| column(8 + i * width, 8 + (i + 1) * width).to_owned()).collect();
    Ok(Line { name, continues, large, fields, next: continuation_name(column(72, 80)) })
}

fn continuation_name(field: &str) -> String {
    field.trim_matches(['+', '*']).trim().to_owned()
}

/// Replaces tabs by blanks up to the next multiple of eight columns.
fn expand_tabs(data: &str) -> String {
    let mut expanded = String::with_capacity(data.len());
    for character in data.chars() {
        match character {
            '\t' => {
                let width = 8 - expanded.len() % 8;
                expanded.extend(std::iter::repeat_n(' ', width));
            }
            other => expanded.push(other),
        }
    }
    expanded
}

/// Returns the integer that a field states.
pub(super) fn integer(field: &str) -> Option<i64> {
    let digits = field.strip_prefix(['+', '-']).unwrap_or(field);
    let valid = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    valid.then(|| field.parse().ok()).flatten()
}

/// Returns the real number that a field states. Besides `1.5` and `1.5E3`, the exponent may be
/// written with `D`, or as a sign and digits only after a decimal point: `7.0+3`, `1.-5`. Integers
/// are valid.
pub(super) fn real(field: &str) -> Option<f64> {
    let (sign, body) = match field.as_bytes().first()? {
        b'-' => ("-", &field[1..]),
        b'+' => ("", &field[1..]),
        _ => ("", field),
    };
    let end = body.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(body.len());
    let (mantissa, exponent) = body.split_at(end);
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    if digits == 0 || mantissa.len() - digits > 1 {
        return None;
    }
    let exponent = match exponent.as_bytes().first() {
        None => "0",
        Some(b'E' | b'D' | b'e' | b'd') => &exponent[1..],
        Some(b'+' | b'-') if mantissa.contains('.') => exponent,
        _ => return None,
    };
    integer(exponent)?;
    let value: f64 = format!("{sign}{mantissa}e{exponent}").parse().ok()?;
    value.is_finite().then_some(value)
}
