//! Section "Rolling bearings": the load around each bearing as a polar plot, and the pressure along
//! its most loaded rollers.

use super::chart::{Axis, COLOURS, Curve, Error, FONT, Plot, WIDE, curves, drawn};
use super::read::Run;
use super::units::Units;
use super::{figure, number};
use crate::bearing_loads::{ELEMENTS, ElementLoad, RollerLamina};
use crate::signals::tick;
use maud::{Markup, PreEscaped, html};
use plotters::coord::Shift;
use plotters::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Number of bearings shown.
const SHOWN: usize = 12;
/// Size of a polar plot in drawing units.
const SIZE: (u32, u32) = (900, 900);
/// Radius of the circle of the elements and radius of the largest load.
const RADII: [f64; 2] = [150.0, 370.0];
/// Angle between the lines of two rows, rad.
const APART: f64 = 0.14;
/// Number of circles of constant load.
const CIRCLES: usize = 2;

/// Returns the section; empty without rolling bearings.
pub fn section(run: &Run, units: Units) -> Markup {
    let mut bearings: BTreeMap<&str, Vec<&ElementLoad>> = BTreeMap::new();
    for element in &run.elements {
        bearings.entry(&element.bearing).or_default().push(element);
    }
    if bearings.is_empty() {
        return PreEscaped(String::new());
    }
    let mut all: Vec<(&str, Vec<&ElementLoad>)> = bearings.into_iter().collect();
    all.sort_by(|(_, one), (_, other)| largest_load(other).total_cmp(&largest_load(one)));
    let left_out = all.len().saturating_sub(SHOWN);
    html! {
        p.note {
            "Each bearing at the position with the largest load of its elements. Lines point away from the axis and are as long as the load of the element; "
            "x and y are the axes of the bearing."
        }
        @for (name, elements) in all.iter().take(SHOWN) { (bearing(name, elements, &run.laminae, units)) }
        @if left_out > 0 { p.note { (left_out) " more bearings are in " code { (ELEMENTS) } "." } }
    }
}

fn largest_load(elements: &[&ElementLoad]) -> f64 {
    elements.iter().map(|element| element.load()).fold(0.0, f64::max)
}

fn bearing(name: &str, elements: &[&ElementLoad], laminae: &[RollerLamina], units: Units) -> Markup {
    let largest = largest_load(elements);
    let pressure = elements.iter().map(|element| element.pressure).fold(0.0, f64::max);
    let loaded = elements.iter().filter(|element| element.inner_load > 0.0).count();
    let angles: Vec<f64> = elements.iter().filter_map(|element| element.inner_contact_angle).collect();
    let least = angles.iter().copied().fold(f64::INFINITY, f64::min).to_degrees();
    let most = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max).to_degrees();
    let own: Vec<&RollerLamina> = laminae.iter().filter(|lamina| lamina.bearing == name).collect();
    let position = elements.first().map_or(0, |element| element.step + 1);
    html! {
        article {
            h3 { (name) }
            p {
                (loaded) " of " (elements.len()) " elements carry load. Largest load: " b { (number(units.force.of(largest))) } " " (units.force.name)
                ", largest pressure: " b { (number(units.stress.of(pressure))) } " " (units.stress.name) " (position " (position) ")."
                @if !angles.is_empty() {
                    " Contact angles at the inner ring: " (number(least)) " to " (number(most)) " deg."
                }
            }
            (figure(&polar(elements, units), &format!("{name}: loads of the elements around the axis")))
            (figure(&along_rollers(&own, units), &format!("{name}: pressure along the most loaded roller of each row")))
        }
    }
}

/// Draws the loads of the elements around the axis.
fn polar(elements: &[&ElementLoad], units: Units) -> Plot {
    let largest = largest_load(elements);
    if largest <= 0.0 {
        return Plot::default();
    }
    let rows = elements.iter().map(|element| element.row).max().unwrap_or(0) + 1;
    let svg = drawn(SIZE, |area| {
        circles(area, units.force.of(largest), units.force.name)?;
        for element in elements {
            let colour = COLOURS[element.row % COLOURS.len()];
            let radius = RADII[0] + (RADII[1] - RADII[0]) * element.load() / largest;
            // Elements of two rows are at the same azimuths.
            let azimuth = element.azimuth + APART * (element.row as f64 - 0.5 * (rows as f64 - 1.0));
            let (foot, tip) = (at(azimuth, RADII[0]), at(azimuth, radius));
            if element.load() > 0.0 {
                area.draw(&PathElement::new(vec![foot, tip], colour.stroke_width(6)))?;
                area.draw(&Circle::new(tip, 8, colour.filled()))?;
            }
            let style = if element.inner_load > 0.0 { colour.filled() } else { colour.stroke_width(2) };
            area.draw(&Circle::new(foot, 10, style))?;
        }
        Ok(())
    });
    let names = (0..rows).map(|row| (row % COLOURS.len(), format!("row {}", row + 1)));
    Plot { svg, legend: if rows > 1 { names.collect() } else { Vec::new() }, ..Plot::default() }
}

/// Returns the point at an azimuth (rad) and a radius, with x to the right and y up.
fn at(azimuth: f64, radius: f64) -> (i32, i32) {
    let [x, y] = [SIZE.0, SIZE.1].map(|size| 0.5 * f64::from(size));
    let (sine, cosine) = azimuth.sin_cos();
    ((x + radius * cosine).round() as i32, (y - radius * sine).round() as i32)
}

/// Draws the axes, the circle of the elements and circles of constant load up to the largest one.
fn circles(area: &DrawingArea<SVGBackend<'_>, Shift>, largest: f64, unit: &str) -> Result<(), Error> {
    let centre = at(0.0, 0.0);
    for quarter in 0..4 {
        let azimuth = TAU * f64::from(quarter) / 4.0;
        let line = vec![at(azimuth, 0.0), at(azimuth, RADII[1] + 10.0)];
        area.draw(&PathElement::new(line, BLACK.mix(0.15)))?;
    }
    area.draw(&Circle::new(centre, RADII[0] as i32, BLACK.mix(0.5)))?;
    for circle in 1..=CIRCLES {
        let part = circle as f64 / CIRCLES as f64;
        let radius = RADII[0] + part * (RADII[1] - RADII[0]);
        area.draw(&Circle::new(centre, radius as i32, BLACK.mix(0.2)))?;
        let style = ("sans-serif", FONT - 6).into_font().color(&BLACK.mix(0.7));
        let shown: f64 = format!("{:.2e}", part * largest).parse().unwrap_or(part * largest);
        let (x, y) = at(TAU / 8.0, radius);
        area.draw(&Text::new(format!("{} {unit}", tick(shown)), (x + 6, y - 26), style))?;
    }
    let style = || ("sans-serif", FONT).into_font().color(&BLACK);
    let (x, y) = at(0.0, RADII[1] + 22.0);
    area.draw(&Text::new("x", (x, y - 16), style()))?;
    let (x, y) = at(TAU / 4.0, RADII[1] + 22.0);
    area.draw(&Text::new("y", (x - 8, y - 24), style()))?;
    Ok(())
}

/// Draws the pressures along the most loaded roller of each row.
fn along_rollers(laminae: &[&RollerLamina], units: Units) -> Plot {
    let mut rows: BTreeMap<usize, Vec<&RollerLamina>> = BTreeMap::new();
    for lamina in laminae {
        rows.entry(lamina.row).or_default().push(lamina);
    }
    let several = rows.len() > 1;
    let mut all = Vec::new();
    for (row, laminae) in rows {
        for (side, ring) in ["inner", "outer"].into_iter().enumerate() {
            let place = |lamina: &&RollerLamina| {
                let pressure = [lamina.inner_pressure, lamina.outer_pressure][side];
                (units.length.of(lamina.position), units.stress.of(pressure))
            };
            let name = if several { format!("row {}, {ring} ring", row + 1) } else { format!("{ring} ring") };
            all.push(Curve {
                name,
                colour: all.len(),
                points: laminae.iter().map(place).collect(),
                off: None,
            });
        }
    }
    let x = Axis { what: "from mid-length of the roller", unit: units.length.name };
    curves(WIDE, &x, &Axis { what: "pressure", unit: units.stress.name }, &all, &[])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn element(azimuth: f64, load: f64) -> ElementLoad {
        ElementLoad {
            bearing: "left".into(),
            step: 2,
            time: 0.1,
            row: 0,
            element: 0,
            azimuth,
            inner_load: load,
            outer_load: load,
            inner_contact_angle: None,
            outer_contact_angle: None,
            rib_load: None,
            pressure: 1e9,
        }
    }

    /// Lines point away from the axis, with y up, and the longest has the largest load.
    #[test]
    fn loads_are_drawn_at_their_azimuths() {
        let elements = [element(0.0, 0.0), element(TAU / 4.0, 200.0), element(TAU / 2.0, 100.0)];
        let elements: Vec<&ElementLoad> = elements.iter().collect();
        let plot = polar(&elements, Units::of_system("SI"));
        let lines: Vec<&str> =
            plot.svg.split('<').filter(|part| part.contains("stroke-width=\"6\"")).collect();
        assert_eq!(lines.len(), 2, "{}", plot.svg);
        assert!(lines[0].contains("450,300 450,80"), "{}", lines[0]);
        assert!(lines[1].contains("300,450 190,450"), "{}", lines[1]);
        assert!(polar(&[&element(0.0, 0.0)], Units::of_system("SI")).is_empty());
    }
}
