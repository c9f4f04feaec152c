//! Data of gears and meshes in `run.json`.

use calyx_gears::data_block::{
    DataBlock, Entry, GEAR_ENTRIES, INTERNAL_SHIFT, MEMBER_ENTRIES, MESH_ENTRIES, Value as Entered, Values,
};
use calyx_gears::host::LengthUnit;
use serde_json::{Map, Value, json};

/// Returns the data of the gears and meshes of a model. Values are in SI; `text` has them in the
/// unit of a drawing, with its digits.
///
/// `gears` has an object per gear with the names of its `bodies` and its `data`, by symbol.
/// `meshes` has the `data` that both gears have in common, and `members` with the data of each.
pub(crate) fn json(block: &DataBlock) -> Value {
    let length = block.length_unit();
    let gears = block.gears();
    let gears = gears
        .iter()
        .map(|gear| json!({ "bodies": gear.bodies, "data": data(GEAR_ENTRIES, &gear.values, length) }));
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
