//! Data block as text: aligned columns, one per gear.

use super::{
    DataBlock, Entry, GEAR_ENTRIES, GearColumn, INTERNAL_SHIFT, MEMBER_ENTRIES, MESH_ENTRIES, MeshColumns,
    Values,
};
use crate::host::LengthUnit;
use std::fmt::Write;

/// Largest number of gears side by side.
const MOST_COLUMNS: usize = 4;

/// Row of a table: name, symbol and unit of the entry, and its values. An empty row separates
/// groups.
struct Row {
    entry: Option<[String; 3]>,
    values: Vec<String>,
}

pub(super) fn text(block: &DataBlock) -> String {
    let length = block.length_unit;
    let gears = block.gears();
    let mut sections: Vec<(String, Vec<Row>)> = Vec::new();
    for columns in gears.chunks(MOST_COLUMNS) {
        let mut rows = vec![names(columns.iter().map(column_name))];
        rows.extend(rows_of(
            GEAR_ENTRIES,
            &columns.iter().map(|column| &column.values).collect::<Vec<_>>(),
            length,
        ));
        sections.push(("Gear data".to_owned(), rows));
    }
    for mesh in block.meshes() {
        sections.push(mesh_section(&mesh, length));
    }
    // All tables have the same columns for names, symbols and units.
    let width = |column: usize| {
        let rows = sections.iter().flat_map(|(_, rows)| rows);
        rows.filter_map(|row| Some(count(row.entry.as_ref()?.get(column)?))).max().unwrap_or(0)
    };
    let widths = [width(0), width(1), width(2)];
    let values = sections.iter().flat_map(|(_, rows)| rows).flat_map(|row| &row.values);
    let value_width = values.map(|value| count(value)).max().unwrap_or(0);
    let mut text = String::new();
    for (title, rows) in &sections {
        let gap = if text.is_empty() { "" } else { "\n" };
        let _ = writeln!(text, "{gap}{title}");
        for row in rows {
            let mut line = String::from(" ");
            for (index, width) in widths.iter().enumerate() {
                let cell = row.entry.as_ref().map_or("", |cells| &cells[index]);
                let _ = write!(line, " {cell:<width$} ");
            }
            for value in &row.values {
                let _ = write!(line, "  {value:>value_width$}");
            }
            let _ = writeln!(text, "{}", line.trim_end());
        }
    }
    if block.has_internal_gears() {
        let _ = writeln!(text, "\n  {INTERNAL_SHIFT}");
    }
    text
}

/// Returns the number of characters.
fn count(text: &str) -> usize {
    text.chars().count()
}

/// Heading of the column of a gear: the first body and the number of others.
fn column_name(column: &GearColumn) -> String {
    match &column.bodies[..] {
        [] => String::new(),
        [name] => name.clone(),
        [name, others @ ..] => format!("{name} +{}", others.len()),
    }
}

fn names(columns: impl Iterator<Item = String>) -> Row {
    Row { entry: None, values: columns.collect() }
}

fn mesh_section(mesh: &MeshColumns, length: LengthUnit) -> (String, Vec<Row>) {
    let mut rows = rows_of(MESH_ENTRIES, &[&mesh.common], length);
    rows.push(names([].into_iter()));
    let [first, second] = mesh.bodies.first().cloned().unwrap_or_default();
    let equal = match mesh.bodies.len() {
        0 | 1 => String::new(),
        2 => ", and an equal mesh".to_owned(),
        count => format!(", and {} equal meshes", count - 1),
    };
    let title = format!("Mesh of \"{first}\" and \"{second}\"{equal}");
    rows.push(names([first, second].into_iter()));
    let members: Vec<&Values> = mesh.members.iter().collect();
    rows.extend(rows_of(MEMBER_ENTRIES, &members, length));
    (title, rows)
}

/// Rows of the entries that have a value in any column.
fn rows_of(entries: &[Entry], columns: &[&Values], length: LengthUnit) -> Vec<Row> {
    let mut rows: Vec<Row> = Vec::new();
    let mut starts_group = false;
    for entry in entries {
        starts_group |= entry.starts_group;
        if columns.iter().all(|values| !values.contains_key(entry.key)) {
            continue;
        }
        // A group without values leaves no gap.
        if std::mem::take(&mut starts_group) && !rows.is_empty() {
            rows.push(names([].into_iter()));
        }
        let value = |values: &&Values| {
            values.get(entry.key).map_or_else(|| "-".to_owned(), |value| entry.kind.shown(value, length))
        };
        let unit = entry.kind.unit(length).name.to_owned();
        rows.push(Row {
            entry: Some([entry.name.to_owned(), entry.symbol.to_owned(), unit]),
            values: columns.iter().map(value).collect(),
        });
    }
    rows
}
