//! Files of the comparison: `tradeoff.csv` with a row for each setting and output, and
//! `tradeoff.json` with all data.

use super::comparison::{Comparison, TOLERANCES};
use super::text::{OmittedSetting, cheapest_of_all};
use serde_json::{Map, Value, json};
use std::fs;
use std::io;
use std::path::Path;

/// Columns of the settings.
const SETTING_NAMES: [&str; 7] =
    ["refinement", "order", "face_elements", "displacement_order", "cells", "cells_along", "every"];

/// Writes the table. Times are in seconds, errors are fractions of the output's largest magnitude
/// in the reference run.
pub fn write_table(path: &Path, comparison: &Comparison) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(path)?;
    let header = ["setting", "level"].into_iter().chain(SETTING_NAMES).chain([
        "time",
        "structures",
        "positions",
        "predicted",
        "output",
        "error",
        "deviation",
        "max",
        "min",
        "mean",
        "peak_to_peak",
        "frontier",
        "mesh_seen",
    ]);
    writer.write_record(header)?;
    for (index, measured) in comparison.settings.iter().enumerate() {
        let overridden = measured.setting.overridden();
        let overridden_setting = |name: &str| {
            overridden
                .iter()
                .find(|(overridden_setting, _)| *overridden_setting == name)
                .map_or_else(String::new, |(_, value)| value.clone())
        };
        for output in &comparison.outputs {
            let errors = output.errors[index];
            let mut row = vec![measured.setting.name.clone(), measured.setting.level().to_owned()];
            row.extend(SETTING_NAMES.map(overridden_setting));
            row.extend(
                [measured.time(), measured.structures, measured.positions].map(|time| time.to_string()),
            );
            row.push(measured.predicted.map_or_else(String::new, |time| time.to_string()));
            row.push(output.name.clone());
            row.extend(match errors {
                Some(e) => [e.error(), e.deviation, e.max, e.min, e.mean, e.peak_to_peak]
                    .map(|part| part.to_string()),
                None => Default::default(),
            });
            row.push(output.frontier.contains(&index).to_string());
            row.push(comparison.mesh_seen[index].to_string());
            writer.write_record(row)?;
        }
    }
    writer.flush()
}

/// Returns all data as JSON.
pub fn document(model: &str, params: &Value, comparison: &Comparison, left_out: &[OmittedSetting]) -> Value {
    let settings = comparison.settings.iter().enumerate().map(|(index, measured)| {
        let errors = comparison.outputs.iter().map(|output| {
            let told = output.errors[index].map(|e| {
                json!({
                    "error": e.error(), "deviation": e.deviation, "max": e.max, "min": e.min, "mean": e.mean,
                    "peak_to_peak": e.peak_to_peak,
                })
            });
            (output.name.clone(), json!(told))
        });
        json!({
            "name": measured.setting.name,
            "level": measured.setting.level(),
            "knobs": measured.setting.overridden().into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect::<Map<_, _>>(),
            "directory": format!("runs/{}", measured.setting.folder()),
            "time": { "unit": "s", "structures": measured.structures, "positions": measured.positions, "predicted": measured.predicted },
            "memory": { "unit": "byte", "asked": measured.memory },
            "errors": errors.collect::<Map<_, _>>(),
            "mesh_seen": comparison.mesh_seen[index],
        })
    });
    let name = |index: usize| json!(comparison.settings[index].setting.name);
    let recommended = |cheapest: &dyn Fn(f64) -> Option<usize>| -> Value {
        TOLERANCES
            .map(|tolerance| json!({ "tolerance": tolerance, "setting": cheapest(tolerance).map(name) }))
            .into()
    };
    let outputs = comparison.outputs.iter().map(|output| {
        let frontier: Vec<Value> = output.frontier.iter().map(|index| name(*index)).collect();
        let recommended = recommended(&|tolerance| output.cheapest(tolerance));
        (
            output.name.clone(),
            json!({ "magnitude": output.magnitude, "frontier": frontier, "recommended": recommended }),
        )
    });
    let left_out: Map<String, Value> =
        left_out.iter().map(|OmittedSetting { name, reason }| (name.clone(), json!(reason))).collect();
    json!({
        "calyx": env!("CARGO_PKG_VERSION"),
        "model": model,
        "params": params,
        "error": "the largest deviation at any position, over the largest magnitude in the reference run",
        "reference": name(comparison.reference),
        "settings": settings.collect::<Vec<_>>(),
        "outputs": outputs.collect::<Map<_, _>>(),
        "recommended": recommended(&|tolerance| cheapest_of_all(comparison, tolerance)),
        "left_out": left_out,
    })
}

/// Writes the document.
pub fn write_document(path: &Path, document: &Value) -> io::Result<()> {
    fs::write(path, format!("{document:#}\n"))
}
