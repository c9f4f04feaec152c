//! How wrong each output may be, by what it comes from, and what it would cost to have it half as wrong.

use super::read::{Output, Run, Statistics};
use super::{about, error, number, percent};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// What an error comes from: its name in `run.json` and for people, what halves it, and what that takes.
struct Source {
    name: &'static str,
    shown: &'static str,
    remedy: &'static str,
    /// Of how many times the run's own time of a stage; none where it is not the run's own.
    cost: Option<(&'static str, f64)>,
}

/// What a level of modelling leaves out, for people.
const LEVEL: &str = "level of modelling";

/// Orders are those of the estimates (`calyx_runtime::estimate`); what they cost is measured (`docs/accuracy.md`), to a factor of two.
const SOURCES: [Source; 5] = [
    Source {
        name: "discretization",
        shown: "mesh",
        remedy: "1.5 times the elements along every direction (--refinement 1.5), or the next fidelity: structures take about twice as long",
        cost: Some(("structures", 2.0)),
    },
    Source {
        name: "contact_grid",
        shown: "contact grid",
        remedy: "1.5 times the contact cells (--cells): positions take about twice as long",
        cost: Some(("positions", 2.0)),
    },
    Source {
        name: "positions",
        shown: "positions",
        remedy: "1.4 times as many positions, for what lies between them falls with their square: they take 1.4 times as long",
        cost: Some(("positions", 1.4)),
    },
    Source {
        name: "level",
        shown: LEVEL,
        remedy: "the fidelity above: calyx explain with --fidelity says what it takes",
        cost: None,
    },
    Source {
        name: "time_step",
        shown: "time step",
        remedy: "0.7 of the time step, for its error falls with the square: positions take 1.4 times as long",
        cost: Some(("positions", 1.4)),
    },
];

/// Which of the sources weighs most in what an output may be off by.
fn worst(output: &Output) -> Option<&'static Source> {
    let estimate = output.error.as_ref().filter(|estimate| !estimate.is_rounding);
    let parts = estimate.into_iter().flat_map(|estimate| &estimate.parts);
    let (name, _) = parts.max_by(|a, b| relative(&a.1, output).total_cmp(&relative(&b.1, output)))?;
    SOURCES.iter().find(|source| source.name == name)
}

/// What halving costs on the machine that ran this, by the times of its stages (s): beside them, for no two runs have the same.
pub fn costs(run: &Run, stage: impl Fn(&str) -> Option<f64>) -> Markup {
    let rows: Vec<(&Source, Vec<&str>, &str, f64)> = SOURCES
        .iter()
        .filter_map(|source| {
            let (named, times) = source.cost?;
            let of =
                run.outputs.iter().filter(|output| worst(output).is_some_and(|it| it.name == source.name));
            let names: Vec<&str> = of.map(|output| &output.name[..]).collect();
            let time = stage(named).filter(|time| *time > 0.0 && !names.is_empty())?;
            Some((source, names, named, times * time))
        })
        .collect();
    html! {
        @if !rows.is_empty() {
            h3 { "What half of the error would cost here" }
            table {
                thead { tr { th { "outputs" } th { "what weighs most" } th { "in place of the above" } } }
                tbody { @for (source, names, stage, time) in rows { tr {
                    td.word { @for (index, name) in names.iter().enumerate() { @if index > 0 { ", " } code { (name) } } }
                    td.word { (source.shown) }
                    td.word { "about " (number(format!("{time:.1e}").parse().unwrap_or(time))) " s for " (stage) }
                } } }
            }
        }
    }
}

/// See the module.
pub fn section(run: &Run) -> Markup {
    if run.outputs.is_empty() {
        return PreEscaped(String::new());
    }
    let estimated: Vec<&Output> =
        run.outputs.iter().filter(|output| output.error.is_some() && output.has_values()).collect();
    let model = run.text("model");
    html! {
        @if estimated.is_empty() {
            p { "This run has no error estimates. " code { "analyze(..., error_estimates = \"cheap\")" } " asks for them." }
        } @else {
            (table(run, &estimated))
        }
        (tradeoff(run))
        @if run.tradeoff.is_none() {
            p { "What more accuracy costs is measured by" }
            pre { code { (about::asked("tradeoff", run)) } }
            p.note { "which runs " code { (model) } " at every level and setting; a report made after it, by " code { "calyx report" } ", shows the result here." }
        }
    }
}

/// Of the largest magnitude that the output has.
fn relative(part: &Statistics, output: &Output) -> f64 {
    part.min.abs().max(part.max.abs()) / output.statistics.magnitude()
}

fn table(run: &Run, outputs: &[&Output]) -> Markup {
    let has = |source: &&Source| {
        outputs.iter().any(|output| {
            output.error.iter().flat_map(|error| &error.parts).any(|(name, _)| name == source.name)
        })
    };
    let sources: Vec<&Source> = SOURCES.iter().filter(has).collect();
    let missing: Vec<&str> = SOURCES
        .iter()
        .filter(|source| {
            outputs
                .iter()
                .flat_map(|output| &output.error)
                .any(|e| e.not_estimated.iter().any(|name| name == source.name))
        })
        .map(|source| source.shown)
        .collect();
    html! {
        p { "How far the largest and the least value of each output may be off, of its largest magnitude, and what that comes from. What weighs most is bold; halving it does most." }
        table.numbers {
            thead { tr {
                th { "output" } th { "largest" } th { "may be off by" } th { "in all" }
                @for source in &sources { th { (source.shown) } }
                th { "mean off by" } th { "peak to peak off by" }
                th { "to halve it" }
            } }
            tbody { @for output in outputs { @if let Some(estimate) = &output.error {
                @let known = estimate.parts.iter().filter(|_| !estimate.is_rounding);
                @let worst = worst(output);
                tr {
                    th scope="row" { code { (output.name) } }
                    td { (number(output.statistics.max)) " " small { (output.unit) } }
                    td.main { (error(estimate.of_values())) }
                    td.main { (super::part_of_value(estimate)) }
                    @for source in &sources {
                        td { @match known.clone().find(|(name, _)| name == source.name) {
                            Some((name, part)) if worst.is_some_and(|source| source.name == name) => b { (percent(relative(part, output))) },
                            Some((_, part)) => (percent(relative(part, output))),
                            None => "–",
                        } }
                    }
                    td { @match estimate.total.mean { Some(mean) => (error(mean)), None => "–" } }
                    td { (error(estimate.total.peak_to_peak)) }
                    td.word { (worst.map_or("", |source| source.remedy)) }
                }
            } } }
        }
        @if !missing.is_empty() {
            p.note {
                "Not estimated, and on top of it: " (missing.join(", ")) "."
                @if missing.contains(&LEVEL) {
                    " What the level of modelling leaves out is estimated by the level above: "
                    code { (about::turned(run, Some(("error_estimates", "full")))) } "."
                }
            }
        }
    }
}

/// A setting that the trade-off command has run.
struct Setting<'j> {
    name: &'j str,
    /// Cold, s.
    time: f64,
    errors: &'j Value,
}

impl<'j> Setting<'j> {
    fn of(json: &'j Value) -> Option<Setting<'j>> {
        let seconds = |stage: &str| json["time"][stage].as_f64();
        let time = seconds("structures")? + seconds("positions")?;
        Some(Setting { name: json["name"].as_str()?, time, errors: &json["errors"] })
    }

    /// Of an output, as a part of its largest magnitude.
    fn error(&self, output: &str) -> Option<f64> {
        self.errors[output]["error"].as_f64()
    }

    fn told(&self, output: &str) -> Markup {
        html! { (self.name) ", " (number(self.time)) " s: " (percent(self.error(output).unwrap_or(f64::NAN))) }
    }
}

/// What the trade-off command has measured: of each output the settings that nothing beats, from cheap to dear.
fn tradeoff(run: &Run) -> Markup {
    let Some(tradeoff) = &run.tradeoff else { return PreEscaped(String::new()) };
    let all = tradeoff["settings"].as_array().into_iter().flatten();
    let settings: Vec<Setting> = all.filter_map(Setting::of).collect();
    let best = |output: &str| -> Vec<&Setting> {
        let names = tradeoff["outputs"][output]["frontier"].as_array().into_iter().flatten();
        let mut best: Vec<&Setting> = names
            .filter_map(|name| settings.iter().find(|setting| name.as_str() == Some(setting.name)))
            .filter(|setting| setting.error(output).is_some())
            .collect();
        best.sort_by(|one, other| one.time.total_cmp(&other.time));
        best
    };
    // What has half of the error that this run states.
    let halved = |output: &Output, best: &[&Setting]| -> Option<Markup> {
        let half = Some(0.5 * output.error.as_ref()?.relative).filter(|half| half.is_finite())?;
        let setting =
            best.iter().find(|setting| setting.error(&output.name).is_some_and(|error| error <= half));
        Some(setting.map_or_else(|| html! { "none that was measured" }, |setting| setting.told(&output.name)))
    };
    html! {
        h3 { "What was measured" }
        p {
            (settings.len()) " settings, each from the beginning, against " b { (tradeoff["reference"].as_str().unwrap_or_default()) }
            ". Of each output those that no other beats in time and error: time, and the largest deviation of any position over the largest magnitude."
        }
        table {
            thead { tr { th { "output" } th { "from cheap to dear" } th { "half of this run's error" } } }
            tbody { @for output in &run.outputs {
                @let best = best(&output.name);
                @if !best.is_empty() { tr {
                    th scope="row" { code { (output.name) } }
                    td.word { @for (index, setting) in best.iter().enumerate() { @if index > 0 { br; } (setting.told(&output.name)) } }
                    td.word { @if let Some(halved) = halved(output, &best) { (halved) } @else { "–" } }
                } }
            } }
        }
    }
}
