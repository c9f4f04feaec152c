//! Files of an optimization: the optimum as a params file, and all designs as a table.

use super::{FEASIBLE, Optimization};
use crate::sweep::exact;
use calyx_abi::units::from_si;
use std::fs;
use std::io;
use std::path::Path;

/// File name of the params of the optimum, for `calyx run --params`.
pub const OPTIMUM: &str = "optimum.toml";
/// Beginning of the params of an optimum; those of an interrupted optimization have another one.
pub const OPTIMUM_HEADER: &str = "# Optimum of ";
/// File name of the table of all designs.
pub const DESIGNS: &str = "designs.csv";

/// Writes the variables of the best design as a params file; they have all digits.
///
/// # Errors
/// The file cannot be written.
pub fn write_optimum(path: &Path, all: &Optimization) -> io::Result<()> {
    let header = if all.interrupted { "# Best design until an interruption of " } else { OPTIMUM_HEADER };
    let mut text = format!("{header}{}: {}.\n", all.model, all.goal());
    let Some((values, optimum)) = all.best() else {
        return fs::write(path, "# All designs failed.\n");
    };
    if optimum.violation > FEASIBLE {
        text += "# It does not meet all constraints.\n";
    }
    for (variable, si) in all.variables.iter().zip(values) {
        let (name, number) = (&variable.column.name, exact(variable.column.reversible(*si)));
        // Names of params of components have dots.
        let key = if name.chars().all(|c| c.is_alphanumeric() || c == '_') {
            name.clone()
        } else {
            format!("\"{name}\"")
        };
        let unit = variable.column.unit.as_str();
        text += &match unit {
            "" | "1" => format!("{key} = {number}\n"),
            unit => format!("{key} = \"{number} {unit}\"\n"),
        };
    }
    fs::write(path, text)
}

/// Writes a row per design: search, variables, objective, largest violation, objective and
/// constrained values by load case.
///
/// # Errors
/// The file cannot be written.
pub fn write_designs(path: &Path, all: &Optimization) -> io::Result<()> {
    let mut table = csv::Writer::from_path(path)?;
    let mut head = vec!["search".to_owned()];
    head.extend(all.variables.iter().map(|variable| variable.column.heading("")));
    let objective = all.objective.statistic.name();
    head.push(all.column.heading(objective));
    head.push("violation".to_owned());
    let several = all.cases.len() > 1;
    let of_case = |heading: String, case: usize| {
        if several { format!("{heading} case {}", case + 1) } else { heading }
    };
    if several {
        head.extend((0..all.cases.len()).map(|case| of_case(all.column.heading(objective), case)));
    }
    for (constraint, column) in all.constraints.iter().zip(&all.constraint_columns) {
        let heading = column.heading(constraint.statistic.name());
        head.extend((0..all.cases.len()).map(|case| of_case(heading.clone(), case)));
    }
    head.push("failure".to_owned());
    table.write_record(&head)?;
    for design in &all.designs {
        let mut row = vec![design.search.to_string()];
        let values = all.variables.iter().zip(&design.variables);
        row.extend(values.map(|(variable, si)| exact(variable.column.reversible(*si))));
        match &design.values {
            Ok(values) => {
                row.push(exact(from_si(values.objective, all.column.factor)));
                row.push(exact(values.violation.max(0.0)));
                if several {
                    row.extend(values.cases.iter().map(|si| exact(from_si(*si, all.column.factor))));
                }
                for (column, by_case) in all.constraint_columns.iter().zip(&values.constraints) {
                    row.extend(by_case.iter().map(|si| exact(from_si(*si, column.factor))));
                }
                row.resize(head.len(), String::new());
            }
            Err(reason) => {
                row.resize(head.len() - 1, String::new());
                row.push(reason.clone());
            }
        }
        table.write_record(&row)?;
    }
    table.flush()
}
