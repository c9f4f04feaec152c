//! Data of gears and meshes in `run.json`.

use calyx_gears::data_block::{
    Amount, DataBlock, Entry, FlankCharts, GEAR_ENTRIES, INTERNAL_SHIFT, MEMBER_ENTRIES, MESH_ENTRIES, Trace,
    Value as Entered, Values,
};
use calyx_gears::host::LengthUnit;
use serde_json::{Map, Value, json};

/// Returns the data of the gears and meshes of a model. Values are in SI; `text` has them in the
/// unit of a drawing, with its digits.
///
/// `gears` has an object per gear with the names of its `bodies`, its `data` by symbol, and the
/// traces of modified `flanks`.
/// `meshes` has the `data` that both gears have in common, and `members` with the data of each.
pub(crate) fn json(block: &DataBlock) -> Value {
    let length = block.length_unit();
    let gears = block.gears();
    let charts = block.flank_charts().into_iter().chain(std::iter::repeat(None));
    let gears = gears.iter().zip(charts).map(|(gear, charts)| {
        let mut object = json!({ "bodies": gear.bodies, "data": data(GEAR_ENTRIES, &gear.values, length) });
        if let Some(charts) = charts {
            object["flanks"] = flanks(&charts);
        }
        object
    });
    let gears: Vec<Value> = gears.collect();
    let meshes = block.meshes();
    let meshes = meshes.iter().map(|mesh| {
        let members = mesh.members.iter().map(|values| data(MEMBER_ENTRIES, values, length));
        json!({
            "bodies": mesh.bodies,
            "data": data(MESH_ENTRIES, &mesh.common, length),
            "members": members.collect::<Vec<_>>(),
        })
    });
    let meshes: Vec<Value> = meshes.collect();
    let mut section = json!({ "gears": gears, "meshes": meshes });
    if block.has_internal_gears() {
        section["note"] = json!(INTERNAL_SHIFT);
    }
    section
}

fn data(entries: &[Entry], values: &Values, length: LengthUnit) -> Value {
    let known = entries.iter().filter_map(|entry| Some((entry, values.get(entry.key)?)));
    let objects = known.map(|(entry, value)| {
        let number = match value {
            Entered::Number(number) => json!(number),
            Entered::Text(text) => json!(text),
        };
        let object = json!({
            "name": entry.name,
            "symbol": entry.symbol,
            "value": number,
            "unit": entry.kind.si(),
            "display": { "unit": entry.kind.unit(length).name, "text": entry.kind.shown(value, length) },
            "starts_group": entry.starts_group,
        });
        (entry.key.to_owned(), object)
    });
    Value::Object(objects.collect::<Map<_, _>>())
}

/// Traces of modified flanks, in SI. Deviations are positive for additional material. `design` is
/// left out where it equals the flank.
fn flanks(charts: &FlankCharts) -> Value {
    let points = charts.points.iter().map(|point| {
        let mut object = json!({
            "symbol": point.symbol,
            "name": point.name,
            "diameter": point.diameter,
            "roll_length": point.roll_length,
            "roll_angle": point.roll_angle,
        });
        if let Some(mate) = &point.mate {
            object["mate"] = json!(mate);
        }
        object
    });
    let side = |index: usize| {
        let flank = &charts.flanks[index];
        json!({
            "amounts": flank.amounts.iter().map(amount).collect::<Vec<_>>(),
            "profiles": flank.profiles.iter().map(trace).collect::<Vec<_>>(),
            "helix": trace(&flank.helix),
        })
    };
    let mut object = json!({
        "points": points.collect::<Vec<_>>(),
        "measuring_diameter": charts.measuring_diameter,
        "profile_range": charts.profile_range,
        "helix_range": charts.helix_range,
        "left": side(0),
        "right": side(1),
    });
    if let Some(tolerances) = &charts.tolerances {
        let named = |[total, form, slope]: [f64; 3]| json!({ "total": total, "form": form, "slope": slope });
        object["tolerances"] = json!({
            "grade": tolerances.grade,
            "standard": tolerances.edition.standard(),
            "profile": named(tolerances.profile),
            "helix": named(tolerances.helix),
        });
    }
    object
}

fn amount(amount: &Amount) -> Value {
    json!({
        "symbol": amount.symbol,
        "name": amount.name,
        "value": amount.value,
        "deviation": amount.unintended,
    })
}

fn trace(trace: &Trace) -> Value {
    let mut object = json!({ "at": trace.at, "positions": trace.positions, "flank": trace.flank });
    if trace.design != trace.flank {
        let found = trace.deviations;
        object["design"] = json!(trace.design);
        object["deviations"] = json!({
            "total": found.total, "form": found.form, "slope": found.slope, "middle": found.middle,
        });
    }
    object
}
