//! The table of a sweep as a Parquet file: the columns of `sweep.csv`, with numbers as 64-bit
//! floating-point numbers.
//!
//! Names of columns have no unit. The metadata of the file has the units by column, as a JSON
//! object under the key [`UNITS`].

use crate::sweep::{Case, Column, Row, STATISTICS, Statistics, SweepTable};
use calyx_abi::description::ParamValue;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use serde_json::{Map, Value, json};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;

/// File name of the table in the directory of a sweep.
pub const NAME: &str = "sweep.parquet";
/// Key of the units in the metadata of the file.
pub const UNITS: &str = "units";

/// Values of a column; `None` without a value.
enum Values {
    Integers(Vec<Option<i64>>),
    Booleans(Vec<Option<bool>>),
    Numbers(Vec<Option<f64>>),
    Texts(Vec<Option<String>>),
}

/// Column of the file.
struct Written {
    name: String,
    unit: String,
    values: Values,
}

impl Written {
    fn texts(name: &str, values: impl Iterator<Item = Option<String>>) -> Written {
        Written { name: name.to_owned(), unit: String::new(), values: Values::Texts(values.collect()) }
    }

    /// Column of a param: numbers in its unit, truth values, or texts as in `sweep.csv`.
    fn param(column: &Column, index: usize, cases: &[Case]) -> Written {
        let values = || cases.iter().map(|case| case.values.get(index));
        let values = match cases.first().and_then(|case| case.values.get(index)) {
            Some(ParamValue::Number(_)) => Values::Numbers(
                values()
                    .map(|value| match value {
                        Some(ParamValue::Number(si)) => Some(column.reversible(*si)),
                        _ => None,
                    })
                    .collect(),
            ),
            Some(ParamValue::Bool(_)) => Values::Booleans(
                values()
                    .map(|value| match value {
                        Some(ParamValue::Bool(truth)) => Some(*truth),
                        _ => None,
                    })
                    .collect(),
            ),
            _ => Values::Texts(values().map(|value| Some(column.exact(value?))).collect()),
        };
        Written { name: column.name.clone(), unit: column.unit.clone(), values }
    }

    /// Column of a statistic of an output in the unit of the output.
    fn output(
        table: &SweepTable,
        output: &Column,
        (name, statistic): (&str, fn(&Statistics) -> Option<f64>),
    ) -> Written {
        let value = |row: &Row| Some(table.value(row, output, statistic)).filter(|value| !value.is_nan());
        let values = Values::Numbers(table.rows.iter().map(value).collect());
        Written { name: format!("{}.{name}", output.name), unit: output.unit.clone(), values }
    }

    fn schema(&self) -> Result<Arc<Type>, ParquetError> {
        let (physical, logical) = match self.values {
            Values::Integers(_) => (Physical::INT64, None),
            Values::Booleans(_) => (Physical::BOOLEAN, None),
            Values::Numbers(_) => (Physical::DOUBLE, None),
            Values::Texts(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let column = Type::primitive_type_builder(&self.name, physical);
        column.with_repetition(Repetition::OPTIONAL).with_logical_type(logical).build().map(Arc::new)
    }

    fn write<W: Write + Send>(&self, group: &mut SerializedRowGroupWriter<W>) -> Result<(), ParquetError> {
        match &self.values {
            Values::Integers(all) => write::<Int64Type, W>(group, all),
            Values::Booleans(all) => write::<BoolType, W>(group, all),
            Values::Numbers(all) => write::<DoubleType, W>(group, all),
            Values::Texts(all) => {
                let bytes = |text: &Option<String>| text.as_deref().map(ByteArray::from);
                write::<ByteArrayType, W>(group, &all.iter().map(bytes).collect::<Vec<_>>())
            }
        }
    }
}

/// Writes the next column of a row group.
fn write<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<W>,
    values: &[Option<T::T>],
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else {
        return Err(ParquetError::General("the schema has too few columns".to_owned()));
    };
    let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
    let values: Vec<T::T> = values.iter().flatten().cloned().collect();
    column.typed::<T>().write_batch(&values, Some(&levels), None)?;
    column.close()
}

/// Writes the table of a sweep as a Parquet file.
///
/// # Errors
/// The file cannot be written.
pub fn write_sweep(path: &Path, table: &SweepTable) -> io::Result<()> {
    let SweepTable { cases, rows, .. } = table;
    let numbers = rows.iter().map(|row| i64::try_from(row.case).ok()).collect();
    let mut columns =
        vec![Written { name: "case".to_owned(), unit: String::new(), values: Values::Integers(numbers) }];
    if table.is_named() {
        columns.push(Written::texts("name", cases.iter().map(|case| Some(case.name.clone()))));
    }
    let params = table.params.iter().enumerate();
    columns.extend(params.map(|(index, param)| Written::param(param, index, cases)));
    for output in &table.outputs {
        columns.extend(STATISTICS.iter().map(|statistic| Written::output(table, output, *statistic)));
    }
    columns.push(Written::texts("failure", rows.iter().map(|row| row.failure.clone())));
    let warnings = |row: &Row| Some(row.warnings.join("; ")).filter(|text| !text.is_empty());
    columns.push(Written::texts("warnings", rows.iter().map(warnings)));
    // The file is replaced when it is complete: a reader needs its end.
    let unfinished = path.with_extension("parquet.part");
    write_columns(File::create(&unfinished)?, &table.model, &columns).map_err(io::Error::other)?;
    fs::rename(unfinished, path)
}

fn write_columns(file: File, model: &str, columns: &[Written]) -> Result<(), ParquetError> {
    let fields = columns.iter().map(Written::schema).collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("sweep").with_fields(fields).build()?;
    let units: Map<String, Value> = columns
        .iter()
        .filter(|column| !column.unit.is_empty() && column.unit != "1")
        .map(|column| (column.name.clone(), json!(column.unit)))
        .collect();
    let metadata = vec![
        KeyValue::new("model".to_owned(), model.to_owned()),
        KeyValue::new(UNITS.to_owned(), json!(units).to_string()),
    ];
    let properties = WriterProperties::builder()
        .set_created_by(concat!("calyx ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(metadata))
        .build();
    let mut writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
    let mut group = writer.next_row_group()?;
    columns.iter().try_for_each(|column| column.write(&mut group))?;
    group.close()?;
    writer.close().map(drop)
}
