//! Section "Flanks": K-charts of modified flanks, with the amounts of the modifications, the
//! characteristic diameters of the profile, and deviations with their tolerances.

use super::chart::{Axis, Curve, Plot};
use super::gear_data::{names, symbol};
use super::k_chart::{Panel, panels};
use super::read::Run;
use super::units::{Unit, Units};
use super::{figure, number};
use crate::directory::GEAR_DATA;
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// Largest number of gears shown.
const SHOWN: usize = 6;
/// Flanks of a gear, by their keys.
const SIDES: [&str; 2] = ["left", "right"];
/// Colours of traces: of a single one, and of those at both ends of the face and at mid-face.
const AT_MID_FACE: usize = 0;
const ALONG_FACE: [usize; 3] = [3, AT_MID_FACE, 4];
const DESIGN: usize = 1;

pub fn section(run: &Run, units: Units) -> Markup {
    let gears = run.head[GEAR_DATA]["gears"].as_array().map(Vec::as_slice).unwrap_or_default();
    let modified: Vec<&Value> = gears.iter().filter(|gear| gear["flanks"].is_object()).collect();
    if modified.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        p.note { "Deviations from the involute helicoid, normal to the flank in the transverse section. Additional material is positive. Left and right flanks are seen from the end of the face towards +e3, with the tip of the tooth upwards." }
        @for gear in modified.iter().take(SHOWN) { (article(gear, units)) }
        @if modified.len() > SHOWN {
            p.note { (modified.len() - SHOWN) " more gears with modified flanks are in " code { "run.json" } "." }
        }
    }
}

fn article(gear: &Value, units: Units) -> Markup {
    let flanks = &gear["flanks"];
    let tolerances = &flanks["tolerances"];
    let band = match tolerances["standard"].as_str() {
        Some(standard) => format!(
            " The band is the tolerance of the total deviation for grade {} of {standard}, around the design and over the evaluation range.",
            tolerances["grade"]
        ),
        None => String::new(),
    };
    html! {
        article {
            h3 { (names(&gear["bodies"])) }
            (amounts(flanks, units))
            (figure(&profile_chart(flanks, units), &format!("Profile traces over the roll length, from root to tip.{band}")))
            (points(flanks, units))
            (figure(&helix_chart(flanks, units), &format!(
                "Helix traces at the diameter {} {}, over the distance from mid-face.{band}",
                number(units.length.of(value(&flanks["measuring_diameter"]))), units.length.name)))
            (deviations(flanks, units))
        }
    }
}

fn value(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

fn values(list: &Value) -> Vec<f64> {
    list.as_array().into_iter().flatten().map(value).collect()
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

/// Points of a trace, in the units of the page.
fn points_of(trace: &Value, key: &str, units: Units) -> Vec<(f64, f64)> {
    let positions = values(&trace["positions"]).into_iter().map(|position| units.length.of(position));
    positions.zip(values(&trace[key]).into_iter().map(|deviation| units.film.of(deviation))).collect()
}

/// Tolerance band around the design of a trace over the evaluation range. It is shifted to the
/// middle of the deviations, because the zero of a measured trace is arbitrary.
fn band(trace: &Value, range: &Value, tolerance: &Value, units: Units) -> Vec<(f64, [f64; 2])> {
    let (Some(tolerance), &[from, to]) = (tolerance.as_f64(), values(range).as_slice()) else {
        return Vec::new();
    };
    let design = if trace["design"].is_array() { "design" } else { "flank" };
    let middle = trace["deviations"]["middle"].as_f64().unwrap_or(0.0);
    let [middle, half] = [middle, 0.5 * tolerance].map(|length| units.film.of(length));
    let [from, to] = [from, to].map(|length| units.length.of(length));
    let inside = points_of(trace, design, units).into_iter().filter(|(place, _)| (from..=to).contains(place));
    inside.map(|(place, at)| (place, [at + middle - half, at + middle + half])).collect()
}

/// Curves of traces: the flank, and the design if it differs.
fn curves(traces: &[&Value], units: Units) -> Vec<Curve> {
    let several = traces.len() > 1;
    let mut all = Vec::new();
    for (index, trace) in traces.iter().enumerate() {
        let colour = if several { ALONG_FACE[index % ALONG_FACE.len()] } else { AT_MID_FACE };
        let name = match several {
            true => format!(
                "{} {} from mid-face",
                number(units.length.of(value(&trace["at"]))),
                units.length.name
            ),
            false => "flank".to_owned(),
        };
        all.push(Curve { name, colour, points: points_of(trace, "flank", units), off: None });
    }
    let middle = traces.get(traces.len() / 2).filter(|trace| trace["design"].is_array());
    all.extend(middle.map(|trace| Curve {
        name: "design".into(),
        colour: DESIGN,
        points: points_of(trace, "design", units),
        off: None,
    }));
    all
}

fn title(side: &str) -> String {
    format!("{side} flanks")
}

fn profile_chart(flanks: &Value, units: Units) -> Plot {
    let marks: Vec<(f64, String)> = flanks["points"]
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(|point| {
            let name = match text(&point["symbol"]) {
                "d_Nf" => "SAP",
                "d_Na" => "EAP",
                "d_Ff" => "d_Ff",
                "d_a" => "d_a",
                _ => return None,
            };
            let name = match point["mate"].as_str() {
                Some(mate) => format!("{name} ({mate})"),
                None => name.to_owned(),
            };
            Some((units.length.of(value(&point["roll_length"])), name))
        })
        .collect();
    let mut marks = marks;
    marks.sort_by(|one, other| one.0.total_cmp(&other.0));
    let panel = |side: &str| {
        let traces: Vec<&Value> = flanks[side]["profiles"].as_array().into_iter().flatten().collect();
        let middle = traces.get(traces.len() / 2).copied().unwrap_or(&Value::Null);
        let tolerance = &flanks["tolerances"]["profile"]["total"];
        Panel {
            title: title(side),
            marks: marks.clone(),
            band: band(middle, &flanks["profile_range"], tolerance, units),
            curves: curves(&traces, units),
        }
    };
    let x = Axis { what: "roll length", unit: units.length.name };
    panels(&x, &Axis { what: "profile deviation", unit: units.film.name }, &SIDES.map(panel))
}

fn helix_chart(flanks: &Value, units: Units) -> Plot {
    let panel = |side: &str| {
        let trace = &flanks[side]["helix"];
        let tolerance = &flanks["tolerances"]["helix"]["total"];
        Panel {
            title: title(side),
            marks: Vec::new(),
            band: band(trace, &flanks["helix_range"], tolerance, units),
            curves: curves(&[trace], units),
        }
    };
    let x = Axis { what: "from mid-face, towards +e3", unit: units.length.name };
    panels(&x, &Axis { what: "helix deviation", unit: units.film.name }, &SIDES.map(panel))
}

/// Amounts of the modifications on both flanks.
fn amounts(flanks: &Value, units: Units) -> Markup {
    let of = |side: &str| flanks[side]["amounts"].as_array().cloned().unwrap_or_default();
    let sides = SIDES.map(of);
    let mut kinds: Vec<&Value> = Vec::new();
    for amount in sides.iter().flatten() {
        if kinds.iter().all(|known| known["symbol"] != amount["symbol"]) {
            kinds.push(amount);
        }
    }
    let on = |side: &[Value], kind: &Value| {
        let found = side.iter().find(|amount| amount["symbol"] == kind["symbol"]);
        found.map_or_else(|| "–".to_owned(), |amount| number(units.film.of(value(&amount["value"]))))
    };
    html! { @if !kinds.is_empty() {
        table.numbers.data {
            thead { tr { th { "modification" } th.word { "symbol" } th.word { "unit" } th.value { "left" } th.value { "right" } } }
            tbody { @for kind in kinds { tr {
                th scope="row" { (text(&kind["name"])) }
                td.word { (symbol(text(&kind["symbol"]))) }
                td.word { (units.film.name) }
                @for side in &sides { td { (on(side, kind)) } }
            } } }
        }
    } }
}

/// Characteristic points of the profile.
fn points(flanks: &Value, units: Units) -> Markup {
    let points = flanks["points"].as_array().map(Vec::as_slice).unwrap_or_default();
    let shown = |length: &Value, unit: Unit| format!("{:.3}", unit.of(value(length)));
    html! { @if !points.is_empty() {
        table.numbers.data {
            thead { tr {
                th { "point of the profile" } th.word { "symbol" }
                th.value { "diameter [" (units.length.name) "]" }
                th.value { "roll length [" (units.length.name) "]" }
                th.value { "roll angle [deg]" }
            } }
            tbody { @for point in points { tr {
                th scope="row" {
                    (text(&point["name"]))
                    @if let Some(mate) = point["mate"].as_str() { ", mesh with " (mate) }
                }
                td.word { (symbol(text(&point["symbol"]))) }
                td { (shown(&point["diameter"], units.length)) }
                td { (shown(&point["roll_length"], units.length)) }
                td { (format!("{:.3}", value(&point["roll_angle"]).to_degrees())) }
            } } }
        }
    } }
}

/// Deviations from the design with their tolerances, if a flank has any.
fn deviations(flanks: &Value, units: Units) -> Markup {
    let traces = |side: &str| {
        let profiles = flanks[side]["profiles"].as_array().map(Vec::as_slice).unwrap_or_default();
        let middle = profiles.get(profiles.len() / 2).unwrap_or(&Value::Null);
        [&middle["deviations"], &flanks[side]["helix"]["deviations"]]
    };
    let sides = SIDES.map(traces);
    if sides.iter().flatten().all(|found| !found.is_object()) {
        return PreEscaped(String::new());
    }
    let rows = [
        (0, "total", "F_alpha", "total profile deviation"),
        (0, "form", "f_falpha", "profile form deviation"),
        (0, "slope", "f_Halpha", "profile slope deviation"),
        (1, "total", "F_beta", "total helix deviation"),
        (1, "form", "f_fbeta", "helix form deviation"),
        (1, "slope", "f_Hbeta", "helix slope deviation"),
    ];
    // Tolerances have a tenth of a micrometre; smaller deviations are rounding errors.
    let shown = |length: &Value| {
        length.as_f64().map_or_else(
            || "–".to_owned(),
            |length| {
                let rounded = (10.0 * units.film.of(length)).round() / 10.0;
                number(if rounded == 0.0 { 0.0 } else { rounded })
            },
        )
    };
    html! {
        table.numbers.data {
            thead { tr {
                th { "deviation from the design" } th.word { "symbol" } th.word { "unit" }
                th.value { "tolerance" } th.value { "left" } th.value { "right" }
            } }
            tbody { @for (line, key, name, term) in rows { tr {
                th scope="row" { (term) }
                td.word { (symbol(name)) }
                td.word { (units.film.name) }
                td { (shown(&flanks["tolerances"][["profile", "helix"][line]][key])) }
                @for side in &sides {
                    td { @if side[line].is_object() { (shown(&side[line][key])) } @else { "0" } }
                }
            } } }
        }
    }
}
