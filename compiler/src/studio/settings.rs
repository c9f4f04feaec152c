//! Analysis settings of a form: the overrides of `calyx run`, and the meshes that it writes on
//! request. A setting that the form does not assign is that of the model.

use calyx_rt::params::with_decimal_point;
use calyx_runtime::settings_override::Override;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::ffi::OsString;

/// Values of settings: texts by name.
pub(crate) type Settings = BTreeMap<String, String>;

/// Name of the setting that requests meshes with stresses.
const MESHES: &str = "vtu";

/// Control of a setting in the form.
#[derive(Clone, Copy)]
enum Kind {
    /// One of the names, each with its description.
    Choice(&'static [(&'static str, &'static str)]),
    Number,
    Boolean,
}

/// A setting in the form.
struct Setting {
    /// Name in requests and in `overrides` of `run.json`.
    name: &'static str,
    label: &'static str,
    doc: &'static str,
    kind: Kind,
    /// Shown on request only: few users change it.
    is_detail: bool,
}

/// Descriptions of the fidelity levels, in order of cost.
const LEVELS: [(&str, &str); 7] = [
    ("rigid", "rigid bodies, vanishing load: motions only"),
    ("analytic", "closed-form compliance of teeth and bodies"),
    ("plane", "two-dimensional finite elements"),
    ("medium", "three-dimensional finite elements"),
    ("thinrim", "as medium, finer through thin rims"),
    ("fineroot", "as medium, finer in the fillets"),
    ("finest", "as medium, finer everywhere"),
];

const ESTIMATES: [(&str, &str); 3] = [
    ("none", "no estimates"),
    ("cheap", "of mesh, contact grid and positions; less time than the run"),
    ("full", "also of the fidelity level; more time than the run"),
];

const fn detail(name: &'static str, label: &'static str, doc: &'static str) -> Setting {
    Setting { name, label, doc, kind: Kind::Number, is_detail: true }
}

const SETTINGS: [Setting; 10] = [
    Setting {
        name: "fidelity",
        label: "Fidelity level",
        doc: "Model of teeth and bodies, from fast to exact.",
        kind: Kind::Choice(&LEVELS),
        is_detail: false,
    },
    Setting {
        name: "error_estimates",
        label: "Error estimates",
        doc: "Estimated numerical errors of the outputs.",
        kind: Kind::Choice(&ESTIMATES),
        is_detail: false,
    },
    Setting {
        name: MESHES,
        label: "Finite-element meshes with stresses",
        doc: "Stores displacements and stresses of the meshes at every position, for the 3-D scene and ParaView. \
              Needs more disk space.",
        kind: Kind::Boolean,
        is_detail: false,
    },
    detail(
        "position_stride",
        "Position stride",
        "Analyses only every n-th position and the characteristic points.",
    ),
    detail(
        "refinement",
        "Mesh refinement",
        "Factor for the number of elements in every direction; 1 is the mesh of the fidelity level.",
    ),
    detail("element_order", "Element order", "Polynomial order of the elements in the transverse section."),
    detail(
        "face_elements",
        "Elements along the face",
        "Number of elements along the face, in three dimensions.",
    ),
    detail(
        "displacement_order",
        "Order along the face",
        "Polynomial order of these elements along the face.",
    ),
    detail("contact_cells", "Contact cells M", "Contact grids have 2M+1 cells across the contact."),
    detail(
        "contact_slices",
        "Contact slices N",
        "Contact grids have 2N+1 slices along the face, in three dimensions.",
    ),
];

/// Returns the settings for the form as JSON.
pub(crate) fn described() -> Value {
    let described = SETTINGS.iter().map(|setting| {
        let kind = match setting.kind {
            Kind::Choice(_) => "choice",
            Kind::Number => "number",
            Kind::Boolean => "boolean",
        };
        let choices: Vec<Value> = match setting.kind {
            Kind::Choice(all) => all.iter().map(|(name, doc)| json!({ "name": name, "doc": doc })).collect(),
            _ => Vec::new(),
        };
        let domain = match setting.kind {
            Kind::Number => domain(setting.name),
            _ => String::new(),
        };
        json!({
            "name": setting.name, "label": setting.label, "doc": setting.doc, "kind": kind,
            "choices": choices, "domain": domain, "detail": setting.is_detail,
        })
    });
    described.collect()
}

/// Returns the accepted numbers as text.
fn domain(name: &str) -> String {
    // The remedy for an invalid value states them: "give a whole number from 1 to 400".
    let help = Override::default().set(name, "").err().map(|error| error.help).unwrap_or_default();
    let range = help.split(';').next().unwrap_or_default();
    range.trim_start_matches("give a ").to_owned()
}

/// Settings of a form, checked one by one.
#[derive(Default)]
pub(crate) struct CheckedSettings {
    pub overrides: Override,
    /// Errors by setting.
    pub errors: Map<String, Value>,
}

/// Checks settings.
pub(crate) fn checked(settings: &Settings) -> CheckedSettings {
    let mut all = CheckedSettings::default();
    for (name, text) in settings {
        let known = SETTINGS.iter().find(|setting| setting.name == name);
        let outcome = match name.as_str() {
            MESHES => boolean(text).map(|_| ()).ok_or_else(|| (None, "choose TRUE or FALSE".to_owned())),
            _ => all
                .overrides
                .set(name, text.trim())
                .map_err(|error| (known.is_none().then_some(error.message), error.help)),
        };
        let outcome = outcome.map_err(|(message, help)| {
            let label = known.map_or(name.as_str(), |setting| setting.label);
            (message.unwrap_or_else(|| refusal(label, text.trim())), help)
        });
        if let Err((message, help)) = outcome {
            all.errors.insert(name.clone(), json!({ "message": message, "help": help }));
        }
    }
    all
}

/// Returns the message about an invalid value, with the label of its field.
fn refusal(label: &str, text: &str) -> String {
    match with_decimal_point(text) {
        _ if text.is_empty() => "a value is missing".to_owned(),
        Some(number) => {
            format!("{label} cannot be `{text}`: write a decimal point in place of the comma, `{number}`")
        }
        None => format!("{label} cannot be `{text}`"),
    }
}

fn boolean(text: &str) -> Option<bool> {
    match text.trim() {
        "TRUE" => Some(true),
        "FALSE" => Some(false),
        _ => None,
    }
}

/// Returns true if a form requests meshes with stresses.
pub(crate) fn requests_meshes(settings: &Settings) -> bool {
    settings.get(MESHES).is_some_and(|text| boolean(text) == Some(true))
}

/// Returns the options of `calyx run` for valid settings.
pub(crate) fn options(settings: &Settings) -> Vec<OsString> {
    let option = |(name, text): (&String, &String)| match name.as_str() {
        MESHES => boolean(text).unwrap_or(false).then(|| "--vtu".to_owned()),
        _ => Some(format!("--{}={}", name.replace('_', "-"), text.trim())),
    };
    settings.iter().filter_map(option).map(OsString::from).collect()
}

/// Returns the settings of a run by its `overrides` in `run.json`.
pub(crate) fn of_run(run: &Value, has_meshes: bool) -> Map<String, Value> {
    let overrides = run["overrides"].as_object().into_iter().flatten();
    let text = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let mut all: Map<String, Value> =
        overrides.map(|(name, value)| (name.clone(), json!(text(value)))).collect();
    if has_meshes {
        all.insert(MESHES.to_owned(), json!("TRUE"));
    }
    all
}

/// Returns the first setting that a diagnostic of the analysis names as overridden.
pub(crate) fn named_in(help: &str) -> Option<&'static str> {
    let listed = help.split_once("the run overrides settings of the model: ")?.1;
    let first = listed.split(" = ").next()?;
    SETTINGS.iter().map(|setting| setting.name).find(|name| *name == first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_runtime::fidelity::Fidelity;

    fn settings(all: &[(&str, &str)]) -> Settings {
        all.iter().map(|(name, text)| (name.to_string(), text.to_string())).collect()
    }

    #[test]
    fn each_setting_has_its_own_error() {
        let given = settings(&[
            ("fidelity", "exact"),
            ("contact_cells", " 6 "),
            ("refinement", ""),
            ("vtu", "yes"),
            ("torque", "1"),
        ]);
        let CheckedSettings { overrides, errors } = checked(&given);
        assert_eq!(overrides.overridden(), [("contact_cells", "6".to_owned())]);
        assert_eq!(errors.keys().collect::<Vec<_>>(), ["fidelity", "refinement", "torque", "vtu"]);
        assert_eq!(errors["refinement"]["message"], "a value is missing");
        assert!(errors["fidelity"]["help"].as_str().expect("a remedy").contains("plane"));
        assert_eq!(errors["vtu"]["message"], "Finite-element meshes with stresses cannot be `yes`");
        let CheckedSettings { errors, .. } =
            checked(&settings(&[("contact_cells", "abc"), ("refinement", "1,5")]));
        assert_eq!(errors["contact_cells"]["message"], "Contact cells M cannot be `abc`");
        let message = "Mesh refinement cannot be `1,5`: write a decimal point in place of the comma, `1.5`";
        assert_eq!(errors["refinement"]["message"], message);
    }

    #[test]
    fn the_form_offers_all_levels_and_overrides() {
        assert_eq!(LEVELS.map(|(name, _)| name), Fidelity::ALL.map(Fidelity::name));
        let mut one = Override::default();
        for setting in SETTINGS.iter().filter(|setting| setting.name != MESHES) {
            let text = match setting.kind {
                Kind::Choice(all) => all[0].0,
                _ => "1",
            };
            one.set(setting.name, text).expect(setting.name);
        }
        assert_eq!(one.overridden().len(), SETTINGS.len() - 1);
        assert_eq!(domain("contact_cells"), "whole number from 1 to 400");
        assert_eq!(domain("refinement"), "number from 0.1 to 10");
    }

    #[test]
    fn settings_are_options_of_a_run() {
        let given = settings(&[("fidelity", "plane"), ("position_stride", "2"), ("vtu", "TRUE")]);
        assert_eq!(options(&given), ["--fidelity=plane", "--position-stride=2", "--vtu"]);
        assert_eq!(options(&settings(&[("vtu", "FALSE")])).len(), 0);
        let run = json!({ "overrides": { "fidelity": "plane", "contact_cells": 6 } });
        assert_eq!(
            Value::Object(of_run(&run, true)),
            json!({ "fidelity": "plane", "contact_cells": "6", "vtu": "TRUE" })
        );
        assert_eq!(
            named_in("do; the run overrides settings of the model: fidelity = plane"),
            Some("fidelity")
        );
        assert_eq!(named_in("do"), None);
    }
}
