//! Sound on the surface of a body in the report: pictures of velocity and intensity, and the
//! contributions of panels.

use super::text;
use crate::body_pictures::{colour_scale, signed_colour_scale};
use crate::page::chart::{Axis, Curve, WIDE, bars, curves};
use crate::page::{figure, number, percent};
use crate::radiated_sound::{PanelRow, SoundPicture};
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// Largest number of panels in a plot over the speed.
const SHOWN: usize = 6;
/// Range of levels below the largest one in a plot, dB.
const RANGE: f64 = 60.0;
/// Part of the largest magnitude below which negative values are not worth a scale of their own.
const NEGATIVE: f64 = 0.01;

/// Shows the pictures of a body.
pub fn pictures(name: &str, all: &[(SoundPicture, String)]) -> Markup {
    let of = |quantity: &str| -> Vec<&(SoundPicture, String)> {
        all.iter().filter(|(picture, _)| picture.body == name && picture.quantity == quantity).collect()
    };
    html! { @for quantity in ["velocity", "intensity"] { (pair(name, quantity, &of(quantity))) } }
}

/// Shows the pictures of a quantity from both sides next to each other.
fn pair(name: &str, quantity: &str, pictures: &[&(SoundPicture, String)]) -> Markup {
    let Some((first, _)) = pictures.first() else { return PreEscaped(String::new()) };
    let [least, largest] = first.range;
    let size = largest.max(-least);
    let (title, unit, factor) = match quantity {
        "velocity" => ("normal velocity", "mm/s", 1e3),
        _ => ("sound intensity", "mW/m²", 1e3),
    };
    let shown = |value: f64| format!("{} {unit}", number(factor * value));
    let is_signed = least < -NEGATIVE * size;
    let (from, scale) = match is_signed {
        true => (shown(-size), signed_colour_scale()),
        false => (number(0.0), colour_scale()),
    };
    let caption = format!(
        "{title} of {name} at {} Hz, the loudest line at the speed of the model, from the front and from behind",
        number(first.frequency)
    );
    html! {
        figure {
            div.pair { @for (picture, content) in pictures {
                @let [width, height] = picture.size;
                img.body src={ "data:image/png;base64," (content) } width=(width) height=(height)
                    alt={ (title) " of " (name) ", seen from the " (picture.view) };
            } }
            p.legend {
                (title) ": " (from) " "
                i.scale style={ "background:linear-gradient(90deg," (scale.join(",")) ")" } {}
                " " (shown(size))
                @if is_signed { "; the body absorbs sound where it is blue" }
            }
            figcaption { (caption) }
        }
    }
}

/// Compares the contributions of the panels at the speed of the model and over the speed.
pub fn panels(name: &str, sound: &Value, rows: &[&PanelRow]) -> Markup {
    let Some(all) = sound["panels"].as_array().filter(|all| !all.is_empty()) else {
        return PreEscaped(String::new());
    };
    let power = |panel: &Value| panel["power"].as_f64().unwrap_or(f64::NAN);
    let total: f64 = all.iter().map(power).sum();
    let level = |panel: &Value, key: &str| {
        panel[key].as_f64().map_or_else(|| "–".to_owned(), |value| format!("{value:.1} dB"))
    };
    let heights: Vec<(u64, f64)> =
        all.iter().zip(1..).map(|(panel, index)| (index, 1e2 * (power(panel) / total).max(0.0))).collect();
    let (x, y) = (Axis { what: "panel", unit: "" }, Axis { what: "part of the sound power", unit: "%" });
    let absorbs = all.iter().any(|panel| power(panel) < 0.0);
    html! {
        table.numbers {
            caption { "Contributions of panels at the speed of the model" }
            thead { tr {
                th { "no." } th.word { "panel" } th { "area" } th { "sound power" } th { "part" } th { "level" }
                th { "A-weighted level" }
            } }
            tbody { @for (panel, index) in all.iter().zip(1..) { tr {
                td { (index) }
                th.word scope="row" { (text(panel, "name")) }
                td { (number(1e4 * panel["area"].as_f64().unwrap_or_default())) " cm²" }
                td { (number(power(panel))) " W" }
                td { (percent(power(panel) / total)) }
                td { (level(panel, "level")) }
                td { (level(panel, "a_weighted_level")) }
            } } }
        }
        @if absorbs { p.note { "A negative contribution means that the panel absorbs sound of the others." } }
        (figure(&bars(WIDE, &x, &y, &heights), &format!("contributions of the panels of {name} to its sound power")))
        (over_speed(name, all, rows))
    }
}

/// Plots the levels of the contributions over the speed.
fn over_speed(name: &str, panels: &[Value], rows: &[&PanelRow]) -> Markup {
    let curve = |(index, panel): (usize, &Value)| {
        let title = text(panel, "name");
        let own: Vec<&&PanelRow> = rows.iter().filter(|row| row.panel == title).collect();
        let speeds = own.chunk_by(|one, other| one.speed == other.speed);
        let level = |rows: &[&&PanelRow]| {
            let power: f64 = rows.iter().map(|row| row.power).sum();
            (rows[0].speed, 10.0 * (power / super::REFERENCE).log10())
        };
        let points = speeds.map(level).filter(|(_, level)| level.is_finite()).collect();
        Curve { name: title.to_owned(), colour: index, points, ..Curve::default() }
    };
    let mut all: Vec<Curve> = panels.iter().take(SHOWN).enumerate().map(curve).collect();
    let levels = all.iter().flat_map(|curve| curve.points.iter().map(|point| point.1));
    let largest = levels.fold(f64::NEG_INFINITY, f64::max);
    all.iter_mut().for_each(|curve| curve.points.retain(|(_, level)| *level > largest - RANGE));
    let (x, y) = (Axis { what: "speed", unit: "rpm" }, Axis { what: "sound power level", unit: "dB" });
    figure(
        &curves(WIDE, &x, &y, &all, &[]),
        &format!("contributions of the panels of {name} over the speed; negative ones have no level"),
    )
}
