//! Files of the comparison: `tradeoff.csv` with a row for each setting and output, and
//! `tradeoff.json` with all data.

use super::comparison::{Comparison, TOLERANCES};
use super::text::{OmittedSetting, cheapest_of_all};
use crate::former_keys::{self, ResultFile, TRADEOFF_COLUMNS};
use serde_json::{Map, Value, json};
use std::fs;
use std::io;
use std::path::Path;

/// Columns of the settings.
const SETTING_NAMES: [&str; 7] = [
    "refinement",
    "element_order",
    "face_elements",
    "displacement_order",
    "contact_cells",
    "contact_slices",
    "position_stride",
];

/// Writes the table. Times are in seconds, errors are fractions of the output's largest magnitude
/// in the reference run.
pub fn write_table(path: &Path, comparison: &Comparison) -> io::Result<()> {
    let mut writer = csv::Writer::from_path(path)?;
    let header = ["setting", "fidelity"].into_iter().chain(SETTING_NAMES).chain([
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
        "includes_mesh_error",
    ]);
    let header: Vec<&str> = header.collect();
    // Columns under their former names, behind all others.
    let former = TRADEOFF_COLUMNS
        .iter()
        .filter_map(|(name, former)| Some((header.iter().position(|column| column == name)?, *former)));
    let (repeated, former): (Vec<usize>, Vec<&str>) = former.unzip();
    writer.write_record(header.iter().chain(&former))?;
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
            row.push(comparison.includes_mesh_error[index].to_string());
            row.extend(repeated.iter().map(|column| row[*column].clone()).collect::<Vec<_>>());
            writer.write_record(row)?;
        }
    }
    writer.flush()
}

/// Returns all data as JSON, with the former names of keys.
pub fn document(model: &str, params: &Value, comparison: &Comparison, omitted: &[OmittedSetting]) -> Value {
    let settings = comparison.settings.iter().enumerate().map(|(index, measured)| {
        let errors = comparison.outputs.iter().map(|output| {
            let errors = output.errors[index].map(|e| {
                json!({
                    "error": e.error(), "deviation": e.deviation, "max": e.max, "min": e.min, "mean": e.mean,
                    "peak_to_peak": e.peak_to_peak,
                })
            });
            (output.name.clone(), json!(errors))
        });
        json!({
            "name": measured.setting.name,
            "fidelity": measured.setting.level(),
            "overrides": measured.setting.overridden().into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect::<Map<_, _>>(),
            "directory": format!("runs/{}", measured.setting.folder()),
            "time": { "unit": "s", "structures": measured.structures, "positions": measured.positions, "predicted": measured.predicted },
            "memory": { "unit": "byte", "requested": measured.memory },
            "errors": errors.collect::<Map<_, _>>(),
            "includes_mesh_error": comparison.includes_mesh_error[index],
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
    let omitted: Map<String, Value> =
        omitted.iter().map(|OmittedSetting { name, reason }| (name.clone(), json!(reason))).collect();
    let document = json!({
        "calyx": env!("CARGO_PKG_VERSION"),
        "model": model,
        "params": params,
        "error": "the largest deviation at any position, over the largest magnitude in the reference run",
        "reference": name(comparison.reference),
        "settings": settings.collect::<Vec<_>>(),
        "outputs": outputs.collect::<Map<_, _>>(),
        "recommended": recommended(&|tolerance| cheapest_of_all(comparison, tolerance)),
        "omitted": omitted,
    });
    former_keys::with_former(ResultFile::Tradeoff, document)
}

/// Writes the document.
pub fn write_document(path: &Path, document: &Value) -> io::Result<()> {
    fs::write(path, format!("{document:#}\n"))
}
