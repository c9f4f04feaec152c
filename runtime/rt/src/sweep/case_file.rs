//! Load cases in a CSV file: a line with the names of params, then a line per case.

use super::axis::{Axis, refused};
use super::duration::{self, Entry};
use super::varied::Varied;
use crate::error::Error;
use crate::param_assignment::AssignedValue;
use crate::params::{InvalidParam, index_of};
use calyx_abi::description::{ModelDescription, ParamValue};
use calyx_report::durations::Durations;
use std::fmt::Display;
use std::path::Path;

/// Column with the names of the cases, unless the model has a param of this name.
const NAME: &str = "name";
/// Column with the durations of the cases, unless the model has a param of this name.
const DURATION: &str = "duration";

/// Load cases of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseFile {
    /// Values of the params, and names of the cases.
    pub axis: Axis,
    /// Durations of the cases, if the file has a column `duration`.
    pub durations: Option<Durations>,
    /// True if `duration` is a column and a param of the model: then it is the value of the param,
    /// and there is no duty cycle.
    pub duration_is_param: bool,
}

/// Meaning of a column.
enum Column {
    Name,
    /// Durations, with the unit in the heading.
    Duration(String),
    /// Param, with the unit in the heading.
    Param(Varied, String),
}

impl CaseFile {
    /// Reads cases from a CSV file: a line with the names of params, then a line per case with
    /// their values as after `--set`. A column `name` names the cases, and a column `duration`
    /// makes them a duty cycle, unless the model has a param of this name.
    ///
    /// # Errors
    /// The file cannot be read; it has no case; a name is unknown; a value or a duration is
    /// invalid.
    pub fn read(path: &Path, description: &ModelDescription) -> Result<CaseFile, Error> {
        let shown = path.display();
        let unreadable = |error: csv::Error| {
            refused(
                format!("cannot read the cases in {shown}: {error}"),
                "give a CSV file with a line of param names",
            )
        };
        let reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_path(path);
        let mut reader = reader.map_err(unreadable)?;
        let head = reader.headers().map_err(unreadable)?.clone();
        check_separator(&head, &shown)?;
        let columns = head.iter().map(|heading| column_of(heading, description));
        let columns: Vec<Column> =
            columns.collect::<Result<_, _>>().map_err(|error| in_file(error, &shown))?;
        let count = |is: fn(&Column) -> bool| columns.iter().filter(|column| is(column)).count();
        let names = count(|column| matches!(column, Column::Name));
        let durations = count(|column| matches!(column, Column::Duration(_)));
        for (count, name) in [(names, NAME), (durations, DURATION)] {
            if count > 1 {
                return Err(refused(format!("{shown} has {count} columns `{name}`"), "keep one of them"));
            }
        }
        let param = |column: &Column| match column {
            Column::Param(varied, _) => Some(*varied),
            Column::Name | Column::Duration(_) => None,
        };
        let mut axis = Axis {
            params: columns.iter().filter_map(param).collect(),
            names: Vec::new(),
            points: Vec::new(),
            logarithmic: false,
        };
        let mut entries: Vec<Entry> = Vec::new();
        for (line, record) in reader.records().enumerate() {
            let record = record.map_err(unreadable)?;
            let place = format!("case {} of {shown}", line + 1);
            let mut point = Vec::new();
            for (cell, column) in record.iter().zip(&columns) {
                match column {
                    Column::Name => axis.names.push(cell.to_owned()),
                    Column::Duration(unit) => {
                        entries.push(duration::parse(cell, unit, &place, &description.known_units)?);
                    }
                    Column::Param(varied, unit) => {
                        point.push(value_of((cell, unit), *varied, &place, description)?);
                    }
                }
            }
            axis.points.push(point);
        }
        if axis.points.is_empty() {
            return Err(refused(format!("{shown} has no case"), "add a line of values below the names"));
        }
        let is_param =
            index_of(description, DURATION).is_ok_and(|index| axis.params.contains(&Varied::Param(index)));
        Ok(CaseFile {
            durations: (durations == 1).then(|| duration::of(&entries, &shown)).transpose()?,
            axis,
            duration_is_param: is_param,
        })
    }
}

/// Rejects a file whose columns are separated by semicolons or tabs, as spreadsheet programs write
/// them in some countries.
fn check_separator(head: &csv::StringRecord, shown: &impl Display) -> Result<(), Error> {
    let text = head.iter().collect::<Vec<_>>().join(",");
    for (separator, name) in [(';', "semicolons"), ('\t', "tabs")] {
        if text.contains(separator) {
            return Err(refused(
                format!("{shown} separates its columns by {name}"),
                "separate the columns by commas, and write decimal points",
            ));
        }
    }
    Ok(())
}

/// Returns the meaning of a column. Its heading may have a unit in brackets, as those of sweep.csv.
fn column_of(heading: &str, description: &ModelDescription) -> Result<Column, Error> {
    let (name, unit) = match heading.strip_suffix(']').and_then(|heading| heading.split_once('[')) {
        Some((name, unit)) if index_of(description, heading).is_err() => (name.trim(), unit.trim()),
        _ => (heading, ""),
    };
    match (name, Varied::named(name, description)) {
        (_, Ok(varied)) => Ok(Column::Param(varied, unit.to_owned())),
        (NAME, Err(_)) => Ok(Column::Name),
        (DURATION, Err(_)) => Ok(Column::Duration(unit.to_owned())),
        (_, Err(error)) => Err(error),
    }
}

/// Returns the value of a param from a cell and the unit of its heading.
fn value_of(
    (cell, unit): (&str, &str),
    varied: Varied,
    place: &str,
    description: &ModelDescription,
) -> Result<ParamValue, Error> {
    if cell.is_empty() {
        return Err(refused(
            format!("{place} has no value of `{}`", varied.name(description)),
            "give every case a value of every param in the first line",
        ));
    }
    let has_unit = cell.parse::<f64>().is_err();
    let text = if unit.is_empty() || has_unit { cell.to_owned() } else { format!("{cell} {unit}") };
    let value = varied.value(&AssignedValue::Text(text), None, description);
    value.map_err(|error| in_file(error, &place))
}

/// Adds the name of a file, or a place in it, to an error.
fn in_file(error: Error, place: &impl Display) -> Error {
    match error {
        Error::Given(why) => {
            Error::Given(InvalidParam { message: format!("{place}: {}", why.message), ..why })
        }
        error => error,
    }
}
