//! Tables from CSV files. Each file is parsed once. Columns are converted to SI in the requested
//! dimension.
//!
//! The prelude (`calyx/prelude.cx`) wraps these functions for programs. It contains the dimensions,
//! which are erased here.

use crate::files;
use crate::host::ModelHost;
use calyx_abi::description::{Exponents, UnitDescription};
use calyx_abi::externs::Handle;
use calyx_abi::limits::request_memory;
use calyx_abi::quantity::{self, Quantity};
use calyx_abi::units::to_si;
use calyx_abi::{Context, RuntimeError};

/// Parsed table of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Path as the model gives it.
    pub name: String,
    columns: Vec<Column>,
    /// Line number of each row in the file.
    lines: Vec<u64>,
}

#[derive(Clone, Debug, PartialEq)]
struct Column {
    name: String,
    /// Unit in brackets after the name.
    unit: Option<String>,
    cells: Cells,
}

/// Cells of a column. One string for all cells takes a fraction of the memory of separate strings.
#[derive(Clone, Debug, Default, PartialEq)]
struct Cells {
    text: String,
    /// End offset of each cell in the text.
    ends: Vec<usize>,
}

impl Cells {
    fn push(&mut self, cell: &str) {
        self.text.push_str(cell);
        self.ends.push(self.text.len());
    }

    fn iter(&self) -> impl Iterator<Item = &str> {
        let starts = [0].into_iter().chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| self.text.get(start..end).unwrap_or_default())
    }
}

/// Upper bound of the memory that parsing a table of this text takes, bytes: the texts of its cells
/// and the end offset of each cell. Growing vectors take twice their length.
fn memory_of(text: &str) -> u64 {
    let cells = text.bytes().filter(|byte| matches!(byte, b',' | b'\n')).count() as u64 + 1;
    2 * text.len() as u64 + 2 * size_of::<usize>() as u64 * 2 * cells
}

calyx_abi::externs! {
    Pure fn calyx_std_read_table(context, path: String) -> Handle {
        if let Some(known) = host(context)?.tables.iter().position(|known| known.name == path) {
            return Ok(Handle(known as u64));
        }
        let text = files::read(context, &path, "a table is a text file in UTF-8")?;
        let bytes = memory_of(&text);
        request_memory(context, bytes)?;
        let table = parse(&path, &text)?;
        context.kept_tables = context.kept_tables.saturating_add(bytes);
        let tables = &mut host(context)?.tables;
        tables.push(table);
        Ok(Handle(tables.len() as u64 - 1))
    }

    Pure fn calyx_std_table_column(context, table: Handle, name: String, unit: String) -> Vec<f64> {
        let units = context.units.clone();
        let table = table_of(context, table)?;
        let wanted = quantity::parse(&unit, &units).ok();
        column(table, &name, wanted, &units)
    }

    Pure fn calyx_std_magnitude(context, quantity: String) -> f64 {
        match quantity::parse(&quantity, &context.units) {
            Ok(found) if found.value != 0.0 && found.value.is_finite() => Ok(found.value),
            _ => Err(RuntimeError::new("E0732", format!("`{quantity}` is not a unit"),
                "give one unit of the column's quantity: `column(table, \"x\", 1 mm)`")),
        }
    }
}

fn host(context: &mut Context) -> Result<&mut ModelHost, RuntimeError> {
    let missing =
        || RuntimeError::new("E0799", "the engine's state is missing", "please report it with the model");
    context.host::<ModelHost>().ok_or_else(missing)
}

fn table_of(context: &mut Context, handle: Handle) -> Result<&Table, RuntimeError> {
    let tables = &host(context)?.tables;
    let found = usize::try_from(handle.0).ok().and_then(|index| tables.get(index));
    found.ok_or_else(|| {
        RuntimeError::new("E0799", "a table that is not there", "please report it with the model")
    })
}

/// Parses a table: a line of names, then rows with the same number of cells. `#` begins a comment
/// line.
fn parse(name: &str, whole: &str) -> Result<Table, RuntimeError> {
    let malformed = |line: Option<u64>, message: String, help: &str| {
        let place = line.map(|line| format!(", line {line}")).unwrap_or_default();
        RuntimeError::new("E0731", format!("{name}{place}: {message}"), help).of_argument("path")
    };
    let text = whole.strip_prefix('\u{feff}').unwrap_or(whole);
    let mut reader =
        csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let help = "the first line names the columns, separated by commas; every other line has as many cells";
    let header = reader.headers().map_err(|error| malformed(None, error.to_string(), help))?;
    let mut columns: Vec<Column> = Vec::new();
    for title in header {
        let (name, unit) = match title.split_once('[') {
            Some((name, rest)) => match rest.strip_suffix(']') {
                Some(unit) => (name.trim(), Some(unit.trim().to_string())),
                None => {
                    return Err(malformed(
                        Some(1),
                        format!("the bracket of `{title}` does not end"),
                        "write `name [unit]`",
                    ));
                }
            },
            None => (title, None),
        };
        if name.is_empty() || columns.iter().any(|known| known.name == name) {
            let what = if name.is_empty() {
                "a column has no name".into()
            } else {
                format!("two columns are called `{name}`")
            };
            return Err(malformed(Some(1), what, help));
        }
        columns.push(Column { name: name.into(), unit, cells: Cells::default() });
    }
    let mut lines = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map(csv::Position::line);
            let message = match error.kind() {
                csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
                    format!("{len} cells, where the first line names {expected_len} columns")
                }
                _ => error.to_string(),
            };
            malformed(line, message, help)
        })?;
        lines.push(record.position().map_or(0, csv::Position::line));
        for (column, cell) in columns.iter_mut().zip(&record) {
            column.cells.push(cell);
        }
    }
    Ok(Table { name: name.into(), columns, lines })
}

/// Numbers of a column in SI. `wanted` is a sample value of the column: its dimension, and the unit
/// of a column without one.
fn column(
    table: &Table,
    name: &str,
    wanted: Option<Quantity>,
    units: &[UnitDescription],
) -> Result<Vec<f64>, RuntimeError> {
    let Some(column) = table.columns.iter().find(|column| column.name == name) else {
        let names: Vec<_> = table.columns.iter().map(|column| format!("`{}`", column.name)).collect();
        let message = format!("{} has no column `{name}`", table.name);
        return Err(RuntimeError::new("E0733", message, format!("its columns are {}", names.join(", ")))
            .of_argument("name"));
    };
    let wanted = wanted.unwrap_or(Quantity { value: 1.0, dimension: quantity::PURE, unit: false });
    let factor = match &column.unit {
        None => wanted.value,
        Some(unit) => header_factor(table, column, unit, wanted.dimension, units)?,
    };
    let numbers = column.cells.iter().zip(&table.lines).map(|(cell, line)| match cell.parse::<f64>() {
        Ok(number) => Ok(to_si(number, factor)),
        Err(_) => {
            let what = if cell.is_empty() { "nothing stands".into() } else { format!("`{cell}` stands") };
            let message = format!("{}, line {line}: {what} in the column `{name}`, not a number", table.name);
            Err(RuntimeError::new(
                "E0731",
                message,
                "write numbers with a decimal point, like `0.25` or `3e7`",
            ))
        }
    });
    numbers.collect()
}

/// SI value of the unit in a column's header.
fn header_factor(
    table: &Table,
    column: &Column,
    unit: &str,
    wanted: Exponents,
    units: &[UnitDescription],
) -> Result<f64, RuntimeError> {
    let found = match unit {
        "" | "1" | "-" => Ok(Quantity { value: 1.0, dimension: quantity::PURE, unit: true }),
        _ => quantity::parse(&format!("1 {unit}"), units),
    };
    let found = found.map_err(|why| {
        let message = format!("{}, line 1: the unit of `{}` is not known: {why}", table.name, column.name);
        RuntimeError::new("E0731", message, "write units as in a model: `name [lbf/inch^2]`")
    })?;
    if !quantity::fits(found.dimension, wanted) {
        let message = format!(
            "the column `{}` of {} is in {unit}, another kind of quantity than is asked for",
            column.name, table.name
        );
        let help = format!("ask for it in its own dimension: `column(table, \"{}\", 1 {unit})`", column.name);
        return Err(RuntimeError::new("E0732", message, help).of_argument("unit"));
    }
    Ok(found.value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn units() -> Vec<UnitDescription> {
        let mut length = quantity::PURE;
        length[0] = (1, 1);
        let unit = |name: &str, factor| UnitDescription { name: name.into(), factor, dimension: length };
        vec![unit("mm", 1e-3), unit("m", 1.0)]
    }

    #[test]
    fn columns_come_in_the_dimension_asked_for() {
        let text = "\u{feff}# measured\nroll, depth [mm], note\n0.5, 10, a\n# between\n1, 2.5e1,\"b, c\"\n";
        let table = parse("t.csv", text).unwrap();
        let metre = quantity::parse("1 m", &units()).ok();
        assert_eq!(column(&table, "depth", metre, &units()).unwrap(), [0.01, 0.025]);
        assert_eq!(column(&table, "roll", None, &units()).unwrap(), [0.5, 1.0]);
        let error = column(&table, "depth", None, &units()).unwrap_err();
        assert_eq!((error.code.as_str(), error.argument.as_deref()), ("E0732", Some("unit")));
        let error = column(&table, "note", None, &units()).unwrap_err();
        assert!(error.message.starts_with("t.csv, line 3: `a` stands"), "{}", error.message);
        assert_eq!(column(&table, "dept", None, &units()).unwrap_err().code, "E0733");
    }

    #[test]
    fn no_text_makes_the_parser_panic() {
        // A linear congruential generator (Knuth, MMIX) chooses characters that tables consist of.
        let characters: Vec<char> = "a1.-e,[]\"'#\n\r \t\u{feff}µm".chars().collect();
        let mut state = 1_u64;
        let (mut tables, mut refused) = (0, 0);
        for length in (0..4000).map(|case| case % 40) {
            let mut next = || {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                characters[(state >> 33) as usize % characters.len()]
            };
            let text: String = (0..length).map(|_| next()).collect();
            match parse("t.csv", &text) {
                Ok(table) => {
                    tables += 1;
                    for of in &table.columns {
                        drop(column(&table, &of.name, None, &units()));
                    }
                }
                Err(error) => {
                    refused += 1;
                    assert_eq!(error.code, "E0731", "{text:?}");
                }
            }
        }
        assert!(tables > 100 && refused > 100, "{tables} tables, {refused} errors");
    }

    #[test]
    fn malformed_tables_are_refused_with_their_line() {
        for (text, reason) in [
            ("a, b\n1, 2\n3\n", "t.csv, line 3: 1 cells, where the first line names 2 columns"),
            ("a, a\n", "two columns are called `a`"),
            ("a [mm, b\n", "does not end"),
            (", b\n", "has no name"),
        ] {
            let error = parse("t.csv", text).unwrap_err();
            assert!(error.message.contains(reason), "{text:?}: {}", error.message);
        }
        let odd = parse("t.csv", "a [ell]\n1\n").unwrap();
        assert!(column(&odd, "a", None, &units()).unwrap_err().message.contains("no unit called `ell`"));
    }
}
