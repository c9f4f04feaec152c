//! Power flow of gear trains in `run.json`.

use calyx_gears::power_flow::PowerFlow;
use serde_json::{Value, json};

/// Returns the rotors and connections of gear trains, in SI. Unknown powers are null.
pub(crate) fn json(flows: &[PowerFlow]) -> Value {
    let known = |value: f64| if value.is_finite() { json!(value) } else { Value::Null };
    let train = |flow: &PowerFlow| {
        let rotors = flow.rotors.iter().map(|rotor| {
            json!({
                "name": rotor.name,
                "carrier": rotor.carrier,
                "speed": known(rotor.speed),
                "torque": known(rotor.torque),
            })
        });
        let connections = flow.connections.iter().map(|connection| {
            json!({
                "name": connection.name,
                "kind": connection.kind,
                "rotors": connection.rotors,
                "power": known(connection.power),
                "loss": known(connection.loss),
                "assumed": connection.is_assumed,
            })
        });
        json!({
            "rotors": rotors.collect::<Vec<_>>(),
            "connections": connections.collect::<Vec<_>>(),
        })
    };
    flows.iter().map(train).collect()
}
