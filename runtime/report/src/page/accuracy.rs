//! Estimated error of each output by source, and the estimated cost of halving it.

use super::read::{Estimate, Output, Run, Statistics};
use super::{DIGITS, command_line, error, number, part_of_value, percent};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// Source of errors: its name in `run.json` and its display name, the remedy that halves it, and
/// the cost of that.
struct Source {
    name: &'static str,
    shown: &'static str,
    remedy: &'static str,
    /// Short form of the remedy.
    finer: &'static str,
    /// Command-line option of the remedy.
    option: Option<&'static str>,
    /// Stage whose duration increases, and the factor; `None` if it is no stage of this run.
    cost: Option<(&'static str, f64)>,
    /// True if the source applies to dynamic analyses only, false if it applies to static ones
    /// only; `None` for both.
    in_time: Option<bool>,
}

/// Name in `run.json` of the model error of the fidelity level.
const LEVEL: &str = "level";
/// Name in `run.json` of the discretization error of its mesh.
const MESH: &str = "discretization";
const TIME_STEP: &str = "time_step";

/// Orders of convergence are those of the estimates (`calyx_runtime::estimate`); costs are measured
/// (`docs/accuracy.md`), to a factor of two.
const SOURCES: [Source; 6] = [
    Source {
        name: MESH,
        shown: "mesh",
        remedy: "1.5 times the elements in every direction, or the next fidelity level",
        finer: "a finer mesh",
        option: Some("--refinement"),
        cost: Some(("structures", 2.0)),
        in_time: None,
    },
    Source {
        name: "contact_grid",
        shown: "contact grid",
        remedy: "1.5 times the contact cells",
        finer: "a finer contact grid",
        option: Some("--contact-cells"),
        cost: Some(("positions", 2.0)),
        in_time: None,
    },
    Source {
        name: "positions",
        shown: "positions",
        remedy: "1.4 times as many positions (second-order convergence)",
        finer: "more positions",
        option: None,
        cost: Some(("positions", 1.4)),
        in_time: Some(false),
    },
    Source {
        name: "positions",
        shown: "stored steps",
        remedy: "1.4 times as many stored steps; if all are stored, steps 0.7 times as long",
        finer: "more stored steps",
        option: None,
        cost: Some(("positions", 1.0)),
        in_time: Some(true),
    },
    Source {
        name: LEVEL,
        shown: "fidelity level",
        remedy: "the next fidelity level",
        finer: "the next fidelity level",
        option: Some("--fidelity"),
        cost: None,
        in_time: None,
    },
    Source {
        name: TIME_STEP,
        shown: "time step",
        remedy: "0.7 times the time step (second-order convergence)",
        finer: "shorter time steps",
        option: None,
        cost: Some(("positions", 1.4)),
        in_time: None,
    },
];

impl Source {
    /// Finds the source of an error of an output by name.
    fn of(name: &str, output: &Output) -> Option<&'static Source> {
        let estimate = output.error.as_ref()?;
        let in_time = estimate.parts.iter().any(|(part, _)| part == TIME_STEP)
            || estimate.not_estimated.iter().any(|(part, _)| part == TIME_STEP);
        SOURCES.iter().find(|source| source.name == name && source.in_time.is_none_or(|only| only == in_time))
    }
}

/// Fraction of an error that the sources to halve must cover; the other ones are negligible.
const WORTH: f64 = 0.8;

/// Returns the error of the value of largest magnitude relative to it. If that value is certain,
/// such as a load share of 1, uses the error of the mean.
fn relative(errors: &Statistics, output: &Output) -> f64 {
    let error = if is_sure(output) { errors.mean.unwrap_or(0.0) } else { output.of_largest(errors) };
    let part = error.abs() / output.statistics.magnitude();
    if part < DIGITS { 0.0 } else { part }
}

/// Returns true if the error of the value of largest magnitude is rounding only.
fn is_sure(output: &Output) -> bool {
    let total = output.error.as_ref().map(|estimate| output.of_largest(&estimate.total));
    total.is_some_and(|total| total.abs() <= DIGITS * output.statistics.magnitude())
}

/// Returns true if the displayed errors exclude the error of the fidelity level.
fn lacks_level(run: &Run) -> bool {
    let shown =
        run.outputs.iter().filter(|output| output.has_values()).filter_map(|output| output.error.as_ref());
    shown.into_iter().any(|error| !error.parts.is_empty() && !error.includes_level())
}

/// Returns the header of the columns of errors.
pub fn error_header(run: &Run) -> &'static str {
    if lacks_level(run) { "numerical error" } else { "estimated error" }
}

/// Notes which errors are excluded, if any.
pub fn without_level(run: &Run) -> Markup {
    html! {
        @if lacks_level(run) {
            p.note {
                "Numerical error (mesh, contact grid, positions, time step). The model error of fidelity level " q { (run.text("fidelity")) }
                " is not included; see " a href="#accuracy" { "accuracy" } "."
            }
        }
    }
}

/// Formats the estimated error of the value of largest magnitude.
pub fn of_largest(output: &Output, estimate: &Estimate) -> String {
    off_by(output, output.of_largest(&estimate.total))
}

/// Formats an error of an output, without rounding errors.
fn off_by(output: &Output, off: f64) -> String {
    error(if off.abs() <= DIGITS * output.statistics.magnitude() { 0.0 } else { off })
}

/// Returns the known sources of an output's error, the largest first.
fn by_weight(output: &Output) -> Vec<(&'static Source, f64)> {
    let estimate = output.error.as_ref().filter(|estimate| !estimate.is_rounding);
    let parts = estimate.into_iter().flat_map(|estimate| &estimate.parts);
    let part =
        |(name, part): &(String, Statistics)| Some((Source::of(name, output)?, relative(part, output)));
    let mut all: Vec<(&Source, f64)> = parts.filter_map(part).collect();
    all.sort_by(|one, other| other.1.total_cmp(&one.1));
    all
}

/// Returns the sources that must be halved to halve an output's error approximately: those with the
/// largest parts.
fn to_halve(output: &Output) -> Vec<&'static Source> {
    let mut parts = by_weight(output);
    let of = |wanted: &str| parts.iter().find(|(source, _)| source.name == wanted).map_or(0.0, |part| part.1);
    // The next level has another mesh and resolves more than this one: both are one error.
    let other = if of(LEVEL) > 0.5 * of(MESH) { MESH } else { LEVEL };
    parts.retain(|(source, part)| source.name != other && *part > 0.0);
    let all: f64 = parts.iter().map(|part| part.1).sum();
    let mut taken = 0.0;
    let worth = |(source, part): (&'static Source, f64)| {
        let wanted = taken < WORTH * all;
        taken += part;
        wanted.then_some(source)
    };
    parts.into_iter().map_while(worth).collect()
}

/// Relative error above which a run names the settings that reduce it.
const LARGE: f64 = 0.1;

/// Returns a line with the settings that reduce large estimated errors; `None` if no output has a
/// large error.
pub fn advice(outputs: &[Output]) -> Option<String> {
    let is_large = |output: &&Output| {
        output.error.as_ref().is_some_and(|error| !error.is_rounding && error.relative > LARGE)
    };
    let needed: Vec<&Source> = outputs.iter().filter(is_large).flat_map(to_halve).collect();
    let is_needed = |source: &&Source| needed.iter().any(|other| other.shown == source.shown);
    let settings = SOURCES.iter().filter(is_needed).map(|source| match source.option {
        Some(option) => format!("{} ({option})", source.finer),
        None => source.finer.to_owned(),
    });
    let settings: Vec<String> = settings.collect();
    let text = || format!("to reduce the errors above {} %: {}", 100.0 * LARGE, settings.join(", "));
    (!settings.is_empty()).then(text)
}

/// Returns the stages that take longer and the factors; and true if another fidelity level is
/// required, whose cost this run does not know.
fn taking(sources: &[&Source]) -> (Vec<(&'static str, f64)>, bool) {
    let mut stages: Vec<(&str, f64)> = Vec::new();
    for (stage, times) in sources.iter().filter_map(|source| source.cost) {
        match stages.iter_mut().find(|(known, _)| *known == stage) {
            Some((_, factor)) => *factor *= times,
            None => stages.push((stage, times)),
        }
    }
    (stages, sources.iter().any(|source| source.cost.is_none()))
}

/// Describes the cost of halving.
fn cost(sources: &[&Source]) -> String {
    let (stages, other_level) = taking(sources);
    let longer = |(stage, times): &(&str, f64)| match *times == 1.0 {
        true => "little more time".to_owned(),
        false => format!("{stage} take {} times as long", number(*times)),
    };
    let mut words: Vec<String> = stages.iter().map(longer).collect();
    if other_level {
        words.push("the next fidelity level".into());
    }
    words.join(", ")
}

fn names(sources: &[&Source]) -> String {
    sources.iter().map(|source| source.shown).collect::<Vec<_>>().join(", ")
}

/// Shows the estimated error of an output, its sources, and the remedies, next to the plot.
pub fn of_output(output: &Output) -> Markup {
    let Some(estimate) = &output.error else { return PreEscaped(String::new()) };
    let parts = by_weight(output);
    // The output is zero and so are all estimates.
    if output.statistics.magnitude() == 0.0 && estimate.total.min == 0.0 && estimate.total.max == 0.0 {
        return PreEscaped(String::new());
    }
    let sources = to_halve(output);
    // No line break between sign, number and unit.
    let with_unit =
        |off: f64| format!("{} {}", off_by(output, off), output.unit).trim_end().replace(' ', "\u{a0}");
    let Statistics { min, max, mean, .. } = estimate.total;
    let other = if output.of_largest(&estimate.total) == max { ("minimum", min) } else { ("maximum", max) };
    html! {
        p.off {
            @if estimate.is_rounding {
                "Rounding only: values and errors are as small as the cancellation errors of the sums."
            } @else {
                @if is_sure(output) {
                    "The value of largest magnitude is exact. Estimated error: "
                } @else {
                    @if estimate.includes_level() { "Estimated error: " } @else { "Estimated numerical error: " }
                    b { (with_unit(output.of_largest(&estimate.total))) }
                    " at the value of largest magnitude (" (part_of_value(estimate)) "), "
                }
                (with_unit(other.1)) " at the " (other.0)
                @if let Some(mean) = mean { ", " (with_unit(mean)) " for the mean" }
                "."
                @if parts.iter().any(|(_, part)| *part > 0.0) {
                    " " (if is_sure(output) { "Contributions to the error of the mean: " } else { "Contributions: " })
                    @for (index, (source, part)) in parts.iter().enumerate() { @if index > 0 { ", " } (source.shown) " " (percent(*part)) }
                    ". " a href="#accuracy" { "To halve it" } ": " (names(&sources)) " (" (cost(&sources)) ")."
                }
            }
        }
    }
}

/// Estimates the cost of halving on the machine of this run from the durations of its stages (s).
/// The durations are shown next to the estimates, because they differ between runs.
pub fn costs(run: &Run, stage: impl Fn(&str) -> Option<f64>) -> Markup {
    // Outputs with the same sources to halve are grouped.
    let mut groups: Vec<(Vec<&'static Source>, Vec<&str>)> = Vec::new();
    for output in &run.outputs {
        let mut sources = to_halve(output);
        sources.sort_by_key(|source| source.name);
        let same = |group: &&mut (Vec<&Source>, Vec<&str>)| {
            group.0.iter().map(|source| source.name).eq(sources.iter().map(|source| source.name))
        };
        match groups.iter_mut().find(same) {
            _ if sources.is_empty() => {}
            Some((_, names)) => names.push(&output.name),
            None => groups.push((sources, vec![&output.name])),
        }
    }
    // Times of structures and positions together, before and after.
    let seconds = |sources: &[&Source]| {
        let (stages, other_level) = taking(sources);
        let times =
            |named: &str| stages.iter().find(|(stage, _)| *stage == named).map_or(1.0, |stage| stage.1);
        let both = ["structures", "positions"].map(|named| (stage(named).unwrap_or(0.0), times(named)));
        let [now, then] = [both.map(|(time, _)| time), both.map(|(time, times)| times * time)];
        let [now, then] = [now, then].map(|times| times.iter().sum::<f64>());
        (!other_level && now > 0.0).then_some([now, then])
    };
    let rough = |time: f64| number(format!("{time:.1e}").parse().unwrap_or(time));
    html! {
        @if !groups.is_empty() {
            h3 { "Cost of halving the error" }
            table {
                thead { tr { th { "outputs" } th { "errors to halve" } th { "time for substructures and positions" } } }
                tbody { @for (sources, outputs) in &groups { tr {
                    td.word { @for (index, name) in outputs.iter().enumerate() { @if index > 0 { ", " } code { (name) } } }
                    td.word { (names(sources)) }
                    td.word { @match seconds(sources) {
                        Some([now, then]) => { "about " b { (rough(then)) " s" } ", now " (rough(now)) " s" },
                        None => { "that of the next fidelity level, as predicted by " code { "calyx explain" } },
                    } }
                } } }
            }
        }
    }
}

/// Shows the section, see the module.
pub fn section(run: &Run) -> Markup {
    if run.outputs.is_empty() {
        return PreEscaped(String::new());
    }
    let estimated: Vec<&Output> =
        run.outputs.iter().filter(|output| output.error.is_some() && output.has_values()).collect();
    let model = run.text("model");
    html! {
        @if estimated.is_empty() {
            p { "This run has no error estimates. Request them in the model with " code { "analyze(..., error_estimates = \"cheap\")" } ", or run" }
            pre { code { (command_line::with_setting(run, Some(("error_estimates", "cheap")))) } }
        } @else {
            (table(run, &estimated))
            (without_level(run))
            (halving(&estimated))
            (not_estimated(run, &estimated))
        }
        (tradeoff(run))
        @if run.tradeoff.is_none() {
            p { "To measure accuracy against computing time, run" }
            pre { code { (command_line::subcommand("tradeoff", run)) } }
            p.note { "This command runs " code { (model) } " with every fidelity level and setting. Then " code { "calyx report" } " includes the result here." }
        }
    }
}

/// Returns the sources that contribute to any of the outputs.
fn sources(outputs: &[&Output]) -> Vec<&'static Source> {
    let of = |output: &&Output| -> Vec<&'static str> {
        let parts = output.error.iter().flat_map(|error| &error.parts);
        parts.filter_map(|(name, _)| Some(Source::of(name, output)?.shown)).collect()
    };
    let shown: Vec<&str> = outputs.iter().flat_map(of).collect();
    SOURCES.iter().filter(|source| shown.contains(&source.shown)).collect()
}

fn table(run: &Run, outputs: &[&Output]) -> Markup {
    let sources = sources(outputs);
    let shown = |estimate: &Estimate, output: &Output, source: &Source| -> Markup {
        let of_source = |(name, _): &&(String, Statistics)| name == source.name;
        let part = estimate.parts.iter().find(of_source).filter(|_| !estimate.is_rounding);
        let most =
            by_weight(output).first().is_some_and(|(worst, part)| worst.name == source.name && *part > 0.0);
        html! { @match part.map(|(_, part)| percent(relative(part, output))) {
            Some(part) if most => b { (part) },
            Some(part) => (part),
            None => "–",
        }
        @if part.is_some() && is_sure(output) { small { " of the mean" } } }
    };
    html! {
        p { "Estimated error of the value of largest magnitude of each output: total and contributions, the largest in bold; then of the mean and of the peak-to-peak value. Contributions add up. Halving those in the last column about halves the total." }
        table.numbers {
            thead { tr {
                th { "output" } th { "largest magnitude" } th { (error_header(run)) } th { "total" }
                @for source in &sources { th { (source.shown) } }
                th { "error of mean" } th { "error of peak to peak" }
                th { "to halve it" }
            } }
            tbody { @for output in outputs { @if let Some(estimate) = &output.error {
                tr {
                    th scope="row" { a href={ "#output-" (output.name) } { code { (output.name) } } }
                    td { (number(largest(output))) " " small { (output.unit) } }
                    td.main { (of_largest(output, estimate)) }
                    td.main { (part_of_value(estimate)) }
                    @for source in &sources { td { (shown(estimate, output, source)) } }
                    td { @match estimate.total.mean { Some(mean) => (off_by(output, mean)), None => "–" } }
                    td { (off_by(output, estimate.total.peak_to_peak)) }
                    td.word { (names(&to_halve(output))) }
                }
            } } }
        }
    }
}

/// Returns the value of largest magnitude.
fn largest(output: &Output) -> f64 {
    output.of_largest(&output.statistics)
}

/// Lists the remedies of the sources and their costs.
fn halving(outputs: &[&Output]) -> Markup {
    let sources = sources(outputs);
    html! {
        @if !sources.is_empty() {
            table {
                thead { tr { th { "contribution" } th { "halved by" } th { "option" } th { "computing time" } } }
                tbody { @for source in sources { tr {
                    th scope="row" { (source.shown) }
                    td.word { (source.remedy) } td { @if let Some(option) = source.option { code.option { (option) } } }
                    td.word { @match source.cost {
                        Some((_, 1.0)) => "little more time",
                        Some((stage, times)) => { (number(times)) " times the time for " (stage) },
                        None => { "see " code { "calyx explain --fidelity" } },
                    } }
                } } }
            }
            p.note { "Times in seconds: " a href="#time" { "time and memory" } "." }
        }
    }
}

/// Lists the errors that are not estimated.
fn not_estimated(run: &Run, outputs: &[&Output]) -> Markup {
    let all = || outputs.iter().flat_map(|output| &output.error).flat_map(|error| &error.not_estimated);
    let mut missing: Vec<(&Source, &str)> = Vec::new();
    for source in SOURCES.iter().filter(|source| source.in_time != Some(true)) {
        for (_, reason) in all().filter(|(name, _)| name == source.name) {
            if !missing.iter().any(|(known, why)| known.name == source.name && why == reason) {
                missing.push((source, reason));
            }
        }
    }
    html! {
        @if !missing.is_empty() {
            p.note { "Errors that are not estimated:" }
            ul.note { @for (source, reason) in &missing {
                li { (source.shown) @if !reason.is_empty() { ": " (reason) } }
            } }
        }
        @if missing.iter().any(|(source, _)| source.name == LEVEL) {
            p.note { "To estimate the model error of the fidelity level with the next level, run" }
            pre { code { (command_line::with_setting(run, Some(("error_estimates", "full")))) } }
        }
    }
}

/// A setting measured by the trade-off command.
struct Setting<'j> {
    name: &'j str,
    /// Time without cached structures, s.
    time: f64,
    errors: &'j Value,
}

impl<'j> Setting<'j> {
    fn of(json: &'j Value) -> Option<Setting<'j>> {
        let seconds = |stage: &str| json["time"][stage].as_f64();
        let time = seconds("structures")? + seconds("positions")?;
        Some(Setting { name: json["name"].as_str()?, time, errors: &json["errors"] })
    }

    /// Returns the error of an output relative to its largest magnitude.
    fn error(&self, output: &str) -> Option<f64> {
        self.errors[output]["error"].as_f64()
    }

    /// Formats the setting with its time and the error of an output.
    fn time_and_error(&self, output: &str) -> Markup {
        html! { (self.name) ", " (number(self.time)) " s: " (percent(self.error(output).unwrap_or(f64::NAN))) }
    }
}

/// Shows the results of the trade-off command: the Pareto frontier of each output, from cheap to
/// expensive.
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
    // The cheapest setting with half of the error that this run states.
    let halved =
        |output: &Output, best: &[&Setting]| -> Option<Markup> {
            let half = Some(0.5 * output.error.as_ref()?.relative).filter(|half| half.is_finite())?;
            let setting =
                best.iter().find(|setting| setting.error(&output.name).is_some_and(|error| error <= half));
            Some(setting.map_or_else(
                || html! { "no measured setting" },
                |setting| setting.time_and_error(&output.name),
            ))
        };
    html! {
        h3 { "Accuracy and computing time" }
        p {
            (settings.len()) " settings, each without cached structures, compared with " b { (tradeoff["reference"].as_str().unwrap_or_default()) }
            ". For each output the Pareto-optimal settings: time, and the largest deviation at any position relative to the largest magnitude."
        }
        table {
            thead { tr { th { "output" } th { "settings in order of time" } th { "setting with half of this run's error" } } }
            tbody { @for output in &run.outputs {
                @let best = best(&output.name);
                @if !best.is_empty() { tr {
                    th scope="row" { code { (output.name) } }
                    td.word { @for (index, setting) in best.iter().enumerate() { @if index > 0 { br; } (setting.time_and_error(&output.name)) } }
                    td.word { @if let Some(halved) = halved(output, &best) { (halved) } @else { "–" } }
                } }
            } }
        }
    }
}
