//! Sections of the report about the run itself: inputs, model, solver residuals and timing.

use super::command_line::{changed, command, options, param_value, shown};
use super::read::{End, Run, objects};
use super::{accuracy, number, paragraphs, prose};
use calyx_view::page;
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

fn texts(value: &Value) -> impl Iterator<Item = &str> {
    value.as_array().into_iter().flatten().filter_map(Value::as_str)
}

/// Shows the key facts of the run.
pub fn facts(run: &Run) -> Markup {
    html! {
        p.facts {
            span { "model " code { (run.text("model")) } }
            @if !run.text("fidelity").is_empty() { span { "fidelity " b { (run.text("fidelity")) } } }
            @if !run.positions.is_empty() && !run.is_calculation() {
                span { b { (run.positions.len()) } " positions" }
            }
            span { "Calyx " (run.text("calyx")) }
        }
    }
}

/// Returns a link to the three-dimensional view, if `calyx view` has written it.
pub fn scene(run: &Run) -> Markup {
    html! {
        @if run.files.iter().any(|file| file == page::NAME) {
            p { a href=(page::NAME) { "Three-dimensional view" } }
        }
    }
}

/// Shows the notices: an incomplete run, ignored inputs, warnings.
pub fn notices(run: &Run) -> Markup {
    // Outputs without values are listed separately.
    let others = texts(&run.head["warnings"]).filter(|warning| !warning.starts_with("E0780:"));
    let warnings: Vec<&str> = others.collect();
    let ignored: Vec<_> = objects(&run.head["ignored_inputs"]).collect();
    let refused: Vec<_> = objects(&run.head["refused_outputs"]).collect();
    let solved = run.positions.len();
    html! {
        @match &run.end {
            End::Finished => {},
            End::Stopped(why) => {
                div.notice.alarm {
                    b { "This run is not complete: " (why) "." }
                    " The report shows the " (solved) " positions that were solved. To continue, run the same command with "
                    code { "--resume" } "."
                }
            },
            End::Open => {
                div.notice.alarm {
                    b { "This run is not complete: it is in progress or was interrupted." }
                    " The report shows the " (solved) " positions that were solved so far. To continue an interrupted run, run the same command with "
                    code { "--resume" } "."
                }
            },
        }
        @if !warnings.is_empty() {
            div.notice {
                b { "Warnings" }
                ul { @for warning in warnings { li { (warning) } } }
            }
        }
        @if !refused.is_empty() {
            div.notice {
                b { "Outputs that this fidelity level does not support" }
                ul { @for (output, needs) in refused { li { code { (output) } ": requires " (needs.as_str().unwrap_or_default()) } } }
            }
        }
        @if !ignored.is_empty() {
            div.notice {
                b { "Inputs that this fidelity level ignores" }
                ul { @for (input, reason) in ignored { li { code { (input) } ": " (reason.as_str().unwrap_or_default()) } } }
            }
        }
    }
}

/// Shows the fidelity levels of the model, and the inputs they ignore.
pub fn plan(run: &Run) -> Markup {
    let plan = &run.head["plan"];
    if plan.is_null() {
        return PreEscaped(String::new());
    }
    let parts = |kind: &str, modelled: bool| -> Vec<(String, String)> {
        objects(&plan[kind])
            .filter(|(_, part)| part["modelled"].as_bool().unwrap_or(true) == modelled)
            .map(|(name, part)| {
                let reason = part["reason"].as_str().unwrap_or_default();
                (name.clone(), reason.strip_prefix("left out: ").unwrap_or(reason).to_owned())
            })
            .collect()
    };
    let rows = [
        ("body", parts("bodies", true)),
        ("bearing", parts("bearings", true)),
        ("left out", parts("bodies", false)),
        ("left out", parts("bearings", false)),
    ];
    html! {
        p { (level(run.text("fidelity"))) }
        @if let Some(reason) = run.head["tolerance_search"]["reason"].as_str() { p { (reason) } }
        @if !options(run).is_empty() {
            p { "Settings of the model overridden on the command line: " code { (options(run)) } "." }
        }
        table {
            tbody { @for (kind, parts) in &rows { @for (name, reason) in parts {
                tr { td.faint { (kind) } th scope="row" { (name) } td.word { (reason) } }
            } } }
        }
    }
}

/// Describes a fidelity level.
fn level(fidelity: &str) -> String {
    let words = match fidelity {
        "rigid" => "rigid surfaces at vanishing load; computes contact points and motion",
        "analytic" => {
            "closed-form compliances of tooth, foundation and contact in slices along the face, without a mesh"
        }
        "plane" => "two-dimensional finite elements (plane strain) in the transverse section",
        "" => return "Nothing is analysed.".into(),
        _ => "three-dimensional finite elements; surface contact on grids over the face",
    };
    format!("Fidelity \"{fidelity}\": {words}.")
}

/// Lists all params.
pub fn params(run: &Run) -> Markup {
    let params: Vec<_> = objects(&run.head["params"]).collect();
    if params.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        table {
            thead { tr { th { "param" } th { "value" } th { "unit" } th { "description" } } }
            tbody { @for (name, param) in params {
                tr {
                    th scope="row" { code { (name) } }
                    td.number { @if changed(param) { b { (param_value(param)) } } @else { (param_value(param)) } }
                    td { (param["display"]["unit"].as_str().unwrap_or_default()) }
                    td.word { (prose(&paragraphs(param["doc"].as_str().unwrap_or_default()).join(" "))) }
                }
            } }
        }
        p.note {
            "Bold values differ from the model's defaults."
            @if !options(run).is_empty() { " Command-line options that override the model: " code { (options(run)) } "." }
        }
    }
}

/// Residuals below this are rounding errors.
const ROUNDING: f64 = 1e-9;
/// Residuals below this are negligible for the results.
const NEGLIGIBLE: f64 = 1e-5;

/// Describes the residuals of all contact problems.
pub fn certificate(run: &Run) -> Markup {
    let certificate = &run.head["certificate"];
    if certificate.is_null() {
        return PreEscaped(String::new());
    }
    let residual = |name: &str| certificate[name].as_f64().unwrap_or(f64::NAN);
    let rows = [
        (
            "equilibrium",
            "Residual force on the free degrees of freedom, relative to the magnitude of the forces.",
        ),
        ("penetration", "Largest overlap of contacting surfaces, relative to their displacements."),
        (
            "complementarity",
            "Largest product of contact force and gap, relative to the largest force and displacement.",
        ),
        ("tension", "Largest tensile contact force, relative to the largest contact force."),
    ];
    let verdict = |residual: f64| match residual {
        _ if residual <= ROUNDING => "rounding error",
        _ if residual <= NEGLIGIBLE => "negligible",
        _ => "too large",
    };
    html! {
        p { "Largest residuals over all positions. They measure how accurately the equations were solved; error estimates measure how accurately the equations describe the gears." }
        table {
            tbody { @for (name, what) in rows {
                tr { th scope="row" { (name) } td.number { (number(residual(name))) } td { b { (verdict(residual(name))) } } td.word { (what) } }
            } }
        }
    }
}

/// Returns the display name of a stage.
fn stage(name: &str) -> &str {
    match name {
        "program" => "the program",
        "meshes" => "visualization meshes",
        "errors" => "error estimates",
        other => other,
    }
}

/// Lists the duration of each stage.
pub fn timing(run: &Run) -> Markup {
    let Some(timing) = &run.timing else { return PreEscaped(String::new()) };
    let total = timing["total"].as_f64().unwrap_or(0.0);
    let stages: Vec<(&String, f64)> =
        objects(&timing["stages"]).filter_map(|(name, time)| Some((name, time.as_f64()?))).collect();
    let (built, reused) = (timing["structures"]["built"].as_u64(), timing["structures"]["reused"].as_u64());
    html! {
        table.times {
            tbody {
                @for (name, time) in &stages {
                    @let part = if total > 0.0 { (100.0 * time / total).clamp(0.0, 100.0) } else { 0.0 };
                    tr {
                        th scope="row" { (stage(name)) }
                        td.number { (number(*time)) " s" }
                        td { div.bar style={ "width:" (format!("{part:.1}")) "%" } {} }
                    }
                }
                tr { th scope="row" { "total" } td.number { b { (number(total)) " s" } } td {} }
            }
        }
        @if let (Some(built), Some(reused)) = (built, reused) {
            p { (built) " substructures were condensed, " (reused) " were reused." }
        }
        (accuracy::costs(run, |stage| timing["stages"][stage].as_f64()))
        @if let Some(memory) = timing["memory"]["requested"].as_f64().filter(|bytes| *bytes > 0.0) {
            p { "Peak memory: " (number(memory * 1e-6)) " MB." }
        }
    }
}

/// Shows the provenance: versions and hashes, the files, and the command to repeat the run.
pub fn origin(run: &Run) -> Markup {
    let source = &run.head["source"];
    let files = |kind: &str| source[kind].as_array().cloned().unwrap_or_default();
    html! {
        p { "To repeat this run:" }
        pre { code { (command(run)) } }
        table {
            tbody {
                tr { th scope="row" { "Calyx" } td.word { (run.text("calyx")) ", engine " code { (shown(&run.head["abi"])) } } }
                @for file in files("files").iter().chain(&files("tables")) {
                    tr { th scope="row" { (shown(&file["name"])) } td.word { "sha256 " code.hash { (shown(&file["sha256"])) } } }
                }
            }
        }
        p { "Files in this directory: " @for (index, name) in run.files.iter().enumerate() { @if index > 0 { ", " } code { (name) } } "." }
    }
}
