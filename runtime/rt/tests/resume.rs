//! Tests of the comparison of an earlier run with this one.

use calyx_rt::resume::differences;
use serde_json::{Value, json};

fn head() -> Value {
    json!({
        "calyx": "1.0", "abi": 7, "model": "pair.cx",
        "source": {
            "files": [{ "name": "pair.cx", "sha256": "a" }, { "name": "gears.cx", "sha256": "b" }],
            "tables": [{ "name": "roll.csv", "sha256": "c" }],
        },
        "params": {
            "torque": { "value": 113.0, "display": { "unit": "lbf*inch", "value": 1000.0 } },
            "edges": { "value": true }, "kind": { "value": "plane" },
        },
        "overrides": { "contact_cells": 6 },
    })
}

#[test]
fn differences_name_what_changed() {
    assert_eq!(differences(&head(), &head()), Vec::<String>::new());
    // The same model at another path.
    let mut moved = head();
    moved["source"]["files"][0]["name"] = json!("models/pair.cx");
    assert_eq!(differences(&head(), &moved), Vec::<String>::new());
    let changes: [(&[&str], Value, &str); 9] = [
        (&["calyx"], json!("2.0"), "it was begun by Calyx 1.0, and this is 2.0"),
        (&["abi"], json!(8), "it was begun by another build of Calyx"),
        (&["source", "files"], json!([]), "the model consisted of other files"),
        (&["source", "tables"], json!([{ "name": "roll.csv", "sha256": "d" }]), "roll.csv has changed"),
        (
            &["params", "torque"],
            json!({ "value": 56.5, "display": { "unit": "lbf*inch", "value": 500.0 } }),
            "`torque` was 1000 lbf*inch and is 500 lbf*inch now",
        ),
        (&["params", "edges"], json!({ "value": false }), "`edges` was TRUE and is FALSE now"),
        (&["params", "kind"], json!({ "value": "solid" }), "`kind` was \"plane\" and is \"solid\" now"),
        (&["overrides", "contact_cells"], json!(9), "`contact_cells` of the analysis was 6 and is 9 now"),
        (&["overrides"], json!({}), "`contact_cells` of the analysis was 6 and is the model's own now"),
    ];
    for (path, value, said) in changes {
        let mut changed = head();
        let at = path.iter().fold(&mut changed, |value, key| &mut value[key]);
        *at = value;
        assert_eq!(differences(&head(), &changed), [said]);
    }
}
