//! Files of a tolerance study: statistics of each output, and params that explain its variation.

use super::group::Group;
use super::statistics::{Estimate, PERCENTILES};
use crate::sweep::{Column, SweepTable, exact};
use std::io;
use std::path::Path;

/// File name of the statistics.
pub const SAMPLE_STATISTICS: &str = "sample_statistics.csv";
/// File name of the params that explain the variation.
pub const EXPLAINED_VARIATION: &str = "explained_variation.csv";

/// Returns the headings of the params that are not sampled.
fn heading(table: &SweepTable, groups: &[Group]) -> Vec<String> {
    let fixed = groups.first().map_or(0, |group| group.values.len());
    let name = table.is_named().then(|| "name".to_owned());
    name.into_iter().chain(table.params[..fixed].iter().map(|param| param.heading(""))).collect()
}

fn own(table: &SweepTable, group: &Group) -> Vec<String> {
    let name = table.is_named().then(|| group.name.clone());
    let values = table.params.iter().zip(&group.values).map(|(column, value)| column.exact(value));
    name.into_iter().chain(values).collect()
}

fn bounds(estimate: &Estimate) -> [String; 3] {
    let bound = |bound: Option<f64>| bound.map(exact).unwrap_or_default();
    [exact(estimate.value), bound(estimate.low), bound(estimate.high)]
}

fn unit(column: &Column) -> String {
    if column.unit == "1" { String::new() } else { column.unit.clone() }
}

/// Writes a line for each statistic of each output: its value and its 95 % confidence interval.
///
/// # Errors
/// The file cannot be written.
pub fn write_statistics(path: &Path, table: &SweepTable, groups: &[Group]) -> io::Result<()> {
    let mut file = csv::Writer::from_path(path)?;
    let columns = ["output", "statistic", "unit", "quantity", "value", "low", "high", "samples", "failed"];
    let head = heading(table, groups).into_iter().chain(columns.map(str::to_owned));
    file.write_record(head)?;
    for group in groups {
        for variation in &group.variations {
            let column = &table.outputs[variation.output];
            let percentiles = PERCENTILES.iter().zip(&variation.percentiles);
            let quantities = [
                ("mean".to_owned(), &variation.mean),
                ("standard_deviation".to_owned(), &variation.standard_deviation),
            ]
            .into_iter()
            .chain(percentiles.map(|(percent, estimate)| (format!("percentile_{percent}"), estimate)));
            for (quantity, estimate) in quantities {
                let mut cells = own(table, group);
                cells.extend([column.name.clone(), variation.statistic.name().to_owned(), unit(column)]);
                cells.push(quantity);
                cells.extend(bounds(estimate));
                cells.extend([variation.sorted.len().to_string(), group.failed.to_string()]);
                file.write_record(&cells)?;
            }
        }
    }
    file.flush()
}

/// Writes a line for each statistic of each output and param: rank regression coefficient and
/// first-order Sobol index with their 95 % confidence intervals, or the reason why they are not
/// known.
///
/// # Errors
/// The file cannot be written.
pub fn write_explained_variation(path: &Path, table: &SweepTable, groups: &[Group]) -> io::Result<()> {
    let mut file = csv::Writer::from_path(path)?;
    let columns = [
        "output",
        "statistic",
        "param",
        "rank_coefficient",
        "rank_coefficient_low",
        "rank_coefficient_high",
        "first_order_index",
        "first_order_index_low",
        "first_order_index_high",
        "rank_r2",
        "remark",
    ];
    let head = heading(table, groups).into_iter().chain(columns.map(str::to_owned));
    file.write_record(head)?;
    for group in groups {
        for variation in &group.variations {
            let column = &table.outputs[variation.output];
            let start = |param: &str| {
                let mut cells = own(table, group);
                cells.extend([column.name.as_str(), variation.statistic.name(), param].map(str::to_owned));
                cells
            };
            match &variation.sensitivities {
                Err(reason) => {
                    let mut cells = start("");
                    cells.extend(vec![String::new(); 7]);
                    cells.push(reason.clone());
                    file.write_record(&cells)?;
                }
                Ok(all) => {
                    let params = &table.params[group.values.len()..];
                    for (param, sensitivity) in params.iter().zip(&all.params) {
                        let mut cells = start(&param.name);
                        cells.extend(bounds(&sensitivity.rank_coefficient));
                        cells.extend(bounds(&sensitivity.first_order));
                        cells.push(exact(all.rank_r2));
                        cells.push(if all.uncertain { "few samples" } else { "" }.to_owned());
                        file.write_record(&cells)?;
                    }
                }
            }
        }
    }
    file.flush()
}
