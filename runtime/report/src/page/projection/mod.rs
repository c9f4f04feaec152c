//! Section "Tooth contact": contact of gears on general axes on the projection planes of their
//! teeth, loaded and unloaded, with ease-off, transmission error and load sharing.

mod contour;
mod draw;
mod tooth;

use super::chart::{Axis, Curve, Plot, TALL, curves};
use super::read::Run;
use super::units::Units;
use super::{figure, number};
use crate::contact_pattern::{COLUMNS, PathPoint, PressurePoint, ROWS};
use crate::flank_tables::{EaseOffRow, UnloadedRow};
use contour::{Field, Node, levels};
use draw::{EDGE, PATH, PATTERN, Patch, Picture};
use maud::{Markup, PreEscaped, html};
use std::collections::{BTreeMap, BTreeSet};
use tooth::Tooth;

/// Layer thickness of a marking compound, m: the usual 6.35 um (0.25 thousandths of an inch).
const MARKING: f64 = 6.35e-6;
/// Ease-off below which flanks are conjugate, m: the accuracy of their interpolation.
const CONJUGATE: f64 = 1e-7;
/// Variation of a transmission error below which it is that of conjugate flanks, urad: the accuracy
/// of their interpolation.
const NO_ERROR: f64 = 0.01;
/// Largest move of a point of contact from one rotation to the next along face or profile, as a
/// part of either. A longer one leads to another place of contact.
const LONGEST_MOVE: f64 = 0.2;
/// Number of contour lines.
const CONTOURS: usize = 8;
/// Parts into which a cell of the ease-off is divided along either coordinate for its colours.
const PARTS: usize = 3;
/// Part of a point of a pattern by which its drawing overlaps its neighbours, so that no gaps are
/// visible.
const OVERLAP: f64 = 0.12;
/// Relative difference of equal pressures.
const ROUNDING: f64 = 1e-9;
/// Number of flanks with pictures.
const SHOWN: usize = 8;

/// Returns the pairs of bodies that have pictures in this section.
pub fn bodies(run: &Run) -> BTreeSet<[String; 2]> {
    let rows = run.flanks.flanks.iter();
    rows.map(|row| [row.body.clone(), row.mate.clone()]).collect()
}

/// Mesh of two gears on one side of their teeth, with its flanks on both gears.
struct Mesh<'a> {
    teeth: [&'a Tooth; 2],
    unloaded: Vec<&'a UnloadedRow>,
    ease_off: Vec<&'a EaseOffRow>,
    path: Vec<&'a PathPoint>,
    pattern: [Vec<&'a PressurePoint>; 2],
    /// Largest pressure more than one half-width away from edges, Pa.
    largest: f64,
}

impl<'a> Mesh<'a> {
    fn of(run: &'a Run, teeth: [&'a Tooth; 2]) -> Mesh<'a> {
        let [first, second] = teeth.map(|tooth| tooth.body.as_str());
        let flank = teeth[0].flank.as_str();
        let unloaded = run.flanks.unloaded.iter();
        let ease_off = run.flanks.ease_off.iter();
        let path = run.contact_path.iter();
        let on = |tooth: &'a Tooth| {
            let points = run.contact_pattern.iter();
            let mine = move |point: &&PressurePoint| {
                [&point.body, &point.mate, &point.flank] == [&tooth.body, &tooth.mate, &tooth.flank]
            };
            points.filter(mine).collect()
        };
        let is = |a: &str, b: &str, c: &str| [a, b, c] == [first, second, flank];
        let loaded = run.contact.iter().filter(|row| is(&row.first_body, &row.second_body, &row.flank));
        Mesh {
            unloaded: unloaded.filter(|row| is(&row.first_body, &row.second_body, &row.flank)).collect(),
            ease_off: ease_off.filter(|row| is(&row.first_body, &row.second_body, &row.flank)).collect(),
            path: path.filter(|row| is(&row.first_body, &row.second_body, &row.flank)).collect(),
            pattern: teeth.map(on),
            largest: loaded.map(|row| row.pressure).fold(0.0, f64::max),
            teeth,
        }
    }
}

pub fn section(run: &Run, units: Units) -> Markup {
    let teeth = Tooth::all(&run.flanks.flanks);
    // Flanks of the first gear and of the second one alternate.
    let meshes: Vec<Mesh<'_>> = teeth
        .chunks_exact(2)
        .map(|pair| [&pair[0], &pair[1]])
        .filter(|[a, b]| a.body == b.mate && a.mate == b.body && a.flank == b.flank)
        .map(|pair| Mesh::of(run, pair))
        .take(SHOWN / 2)
        .collect();
    if meshes.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        p.note { "Teeth on their projection plane, the axial section of the gear, true to scale. The thin lines are the start of the flank above the fillet and the start of the rounded tip edge." }
        @for mesh in &meshes { (article(mesh, run, units)) }
    }
}

fn article(mesh: &Mesh<'_>, run: &Run, units: Units) -> Markup {
    let [first, second] = mesh.teeth;
    let largest = |of: fn(&PressurePoint) -> f64| {
        mesh.pattern.iter().flatten().map(|point| of(point)).fold(0.0, f64::max)
    };
    let on_edges = largest(|point| point.pressure.max(point.edge_pressure));
    let pressure = mesh.largest;
    let stress = |value: f64| format!("{} {}", number(units.stress.of(value)), units.stress.name);
    html! {
        article {
            h3 { (first.body) ", " (first.describe()) ", and " (second.body) ", " (second.describe()) }
            @if pressure > 0.0 || on_edges > 0.0 {
                p { "Largest pressure away from edges: " b { (stress(pressure)) } "."
                    @if on_edges > pressure { " On edges and within one half-width of them: " (stress(on_edges)) "." }
                }
                @for side in 0..2 { (loaded(mesh, side, units)) }
            }
            @for side in 0..2 { (unloaded(mesh, side, units)) }
            (figure(&transmission_error(mesh), "Transmission error without load: each tooth pair by itself, and the pair that touches. Positive if the second gear lags."))
            (figure(&load_sharing(mesh, run), "Load sharing: part of the normal force that each tooth pair carries."))
        }
    }
}

/// Shows the loaded contact pattern of the gear of a side.
fn loaded(mesh: &Mesh<'_>, side: usize, units: Units) -> Markup {
    let tooth = mesh.teeth[side];
    let points = &mesh.pattern[side];
    let quadrilateral = |point: &PressurePoint| {
        let size = [1.0 / COLUMNS as f64, 1.0 / ROWS as f64].map(|size| (0.5 + OVERLAP) * size);
        let at = |x: f64, y: f64| {
            tooth.position([point.along_face + x * size[0], point.along_profile + y * size[1]])
        };
        [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)]
    };
    // Pressures next to edges would hide those of the flank.
    let is_edge = |point: &&&PressurePoint| {
        point.edge_pressure > 0.0 || point.pressure > (1.0 + ROUNDING) * mesh.largest
    };
    let patch = |point: &&PressurePoint| Patch {
        corners: quadrilateral(point),
        value: units.stress.of(point.pressure),
    };
    let patches: Vec<Patch> = points.iter().filter(|point| !is_edge(point)).map(patch).collect();
    let on_edges: Vec<_> = points.iter().filter(is_edge).map(|point| quadrilateral(point)).collect();
    let largest = units.stress.of(mesh.largest);
    let mut legend = vec![(PATH, "centre of pressure of a tooth pair at each position".to_owned())];
    if !on_edges.is_empty() {
        legend.push((EDGE, "contact of an edge: higher pressures".to_owned()));
    }
    let picture = Picture {
        tooth,
        patches,
        on_edges,
        scale: (largest, Axis { what: "pressure", unit: units.stress.name }),
        contours: None,
        boundary: None,
        paths: loaded_paths(mesh, side).into_iter().map(|path| (PATH, path)).collect(),
        marked: true,
        length: units.length,
        legend,
    };
    let caption = format!(
        "Loaded contact pattern on the {} of {}: largest pressure at each point over all positions and teeth.",
        tooth.describe(),
        tooth.body
    );
    figure(&picture.plot(), &caption)
}

/// Returns the paths of the centres of pressure, in the order of the profile: one tooth pair
/// follows another over the same path.
fn loaded_paths(mesh: &Mesh<'_>, side: usize) -> Vec<Vec<[f64; 2]>> {
    let place = |point: &PathPoint| match side {
        0 => [point.first_along_face, point.first_along_profile],
        _ => [point.second_along_face, point.second_along_profile],
    };
    // Consecutive pairs are one pitch apart: pairs in the order of their teeth, positions within.
    let mut pairs: BTreeMap<[u32; 2], Vec<&PathPoint>> = BTreeMap::new();
    for point in &mesh.path {
        pairs.entry([point.first_tooth, point.second_tooth]).or_default().push(point);
    }
    let mut paths: Vec<Vec<[f64; 2]>> = Vec::new();
    for points in pairs.values() {
        let mut line: Vec<[f64; 2]> = Vec::new();
        for (index, point) in points.iter().enumerate() {
            if index > 0 && point.step != points[index - 1].step + 1 {
                paths.push(std::mem::take(&mut line));
            }
            line.push(mesh.teeth[side].position(place(point)));
        }
        paths.push(line);
    }
    paths
}

/// Shows ease-off and path of unloaded contact on the gear of a side.
fn unloaded(mesh: &Mesh<'_>, side: usize, units: Units) -> Markup {
    if mesh.ease_off.is_empty() {
        return PreEscaped(String::new());
    }
    let tooth = mesh.teeth[side];
    let place = |row: &EaseOffRow| match side {
        0 => [row.first_along_face, row.first_along_profile],
        _ => [row.second_along_face, row.second_along_profile],
    };
    let field = |of: fn(&EaseOffRow) -> f64| -> Field {
        let columns = mesh.ease_off.iter().map(|row| row.column).max().map_or(0, |last| last + 1);
        let rows = mesh.ease_off.iter().map(|row| row.row).max().map_or(0, |last| last + 1);
        let mut field = vec![vec![None; rows]; columns];
        for row in &mesh.ease_off {
            let value = units.film.of(of(row));
            let node = Node { at: tooth.position(place(row)), value };
            field[row.column][row.row] = value.is_finite().then_some(node);
        }
        field
    };
    let (ease_off, gap) = (field(|row| row.ease_off), field(|row| row.gap));
    let largest = ease_off.iter().flatten().flatten().map(|node| node.value).fold(0.0, f64::max);
    // The rest is rounding. The path of a contact line is not unique.
    let smallest_scale = units.film.of(CONJUGATE);
    let is_conjugate = largest < smallest_scale;
    let patches = patches(&ease_off);
    let marking = units.film.of(MARKING);
    let mut legend = vec![
        (PATH, "path of contact without load".to_owned()),
        (
            PATTERN,
            format!("contact pattern with a marking compound of {} {}", number(marking), units.film.name),
        ),
    ];
    if mesh.unloaded.iter().any(|row| row.touches && row.edge) {
        legend.push((EDGE, "contact of an edge".to_owned()));
    }
    if is_conjugate {
        legend.clear();
    }
    let picture = Picture {
        tooth,
        patches,
        on_edges: Vec::new(),
        scale: (largest.max(smallest_scale), Axis { what: "ease-off", unit: units.film.name }),
        contours: (!is_conjugate).then(|| (&ease_off, levels(largest, CONTOURS))),
        boundary: Some((&gap, marking)),
        paths: if is_conjugate { Vec::new() } else { unloaded_paths(mesh, side) },
        marked: false,
        length: units.length,
        legend,
    };
    let mut caption = format!(
        "Ease-off and contact without load on the {} of {}. The ease-off is the normal distance of the flank of {} from the surface that is conjugate to the flank of {}.",
        tooth.describe(),
        tooth.body,
        mesh.teeth[0].body,
        mesh.teeth[1].body
    );
    if is_conjugate {
        caption += " These flanks are conjugate: without load they touch along lines, everywhere on the coloured area.";
    }
    figure(&picture.plot(), &caption)
}

/// Returns the path of contact of one tooth pair while it touches, in another colour where an edge
/// touches.
fn unloaded_paths(mesh: &Mesh<'_>, side: usize) -> Vec<(usize, Vec<[f64; 2]>)> {
    let touching: Vec<&UnloadedRow> = mesh.unloaded.iter().copied().filter(|row| row.touches).collect();
    let step = touching
        .windows(2)
        .map(|two| two[1].rotation - two[0].rotation)
        .filter(|step| *step > 0.0)
        .fold(f64::INFINITY, f64::min);
    let fractions = |row: &UnloadedRow| match side {
        0 => [row.first_along_face, row.first_along_profile],
        _ => [row.second_along_face, row.second_along_profile],
    };
    let place = |row: &&UnloadedRow| mesh.teeth[side].position(fractions(row));
    // The path ends where another pair touches in between, or the contact moves to another edge.
    let follows = |a: &UnloadedRow, b: &UnloadedRow| {
        let (from, to) = (fractions(a), fractions(b));
        let moves = (0..2).map(|k: usize| (to[k] - from[k]).abs()).fold(0.0, f64::max);
        b.rotation - a.rotation < 1.5 * step && moves < LONGEST_MOVE
    };
    let mut paths: Vec<(usize, Vec<[f64; 2]>)> = Vec::new();
    let mut last: Option<&UnloadedRow> = None;
    for part in touching.chunk_by(|a, b| a.edge == b.edge && follows(a, b)) {
        let mut line: Vec<[f64; 2]> = part.iter().map(place).collect();
        // A part begins where the one before ends.
        let joined = last.filter(|last| follows(last, part[0])).and(paths.last());
        let before = joined.and_then(|(_, line)| line.last()).copied();
        line.splice(0..0, before);
        last = part.last().copied();
        paths.push((if part[0].edge { EDGE } else { PATH }, line));
    }
    paths
}

/// Divides the cells of a field into patches with interpolated values.
fn patches(field: &Field) -> Vec<Patch> {
    let mut all = Vec::new();
    for columns in field.windows(2) {
        for row in 1..columns[0].len().min(columns[1].len()) {
            let corners = [columns[0][row - 1], columns[1][row - 1], columns[1][row], columns[0][row]];
            let [Some(a), Some(b), Some(c), Some(d)] = corners else { continue };
            let mixed = |x: f64, y: f64, of: &dyn Fn(&Node) -> f64| {
                let low = of(&a) + x * (of(&b) - of(&a));
                low + y * (of(&d) + x * (of(&c) - of(&d)) - low)
            };
            let at = |x: f64, y: f64| [mixed(x, y, &|node| node.at[0]), mixed(x, y, &|node| node.at[1])];
            for index in 0..PARTS * PARTS {
                let [x, y] = [index % PARTS, index / PARTS].map(|k| (k as f64 + 0.5) / PARTS as f64);
                let half = (0.5 + OVERLAP) / PARTS as f64;
                all.push(Patch {
                    corners: [
                        at(x - half, y - half),
                        at(x + half, y - half),
                        at(x + half, y + half),
                        at(x - half, y + half),
                    ],
                    value: mixed(x, y, &|node| node.value),
                });
            }
        }
    }
    all
}

/// Plots the transmission error of the tooth pairs without load.
fn transmission_error(mesh: &Mesh<'_>) -> Plot {
    let microradians = |row: &UnloadedRow| 1e6 * row.transmission_error;
    let touching: Vec<&&UnloadedRow> = mesh.unloaded.iter().filter(|row| row.touches).collect();
    let (Some(first), Some(last)) = (touching.first(), touching.last()) else { return Plot::default() };
    let period = first.pitch;
    let step = touching
        .windows(2)
        .map(|two| (two[1].rotation - two[0].rotation).to_degrees())
        .filter(|step| *step > 0.0)
        .fold(f64::INFINITY, f64::min);
    let error = |row: &&UnloadedRow| microradians(row);
    let (low, high) = touching
        .iter()
        .map(|row| microradians(row))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if high - low < NO_ERROR {
        return Plot::default();
    }
    // Pairs far from contact would flatten the curve of the pair that touches.
    let limit = high + 1.5 * (high - low).max(1e-9);
    let shifted = |pair: i32, all: bool| -> Vec<(f64, f64)> {
        let rows = mesh.unloaded.iter().filter(|row| all || row.touches);
        let at = |row: &UnloadedRow| row.rotation + f64::from(pair) * period;
        let shown = first.rotation - 0.5 * period..last.rotation + 0.5 * period;
        let rows = rows.filter(|row| error(row) <= limit && shown.contains(&at(row)));
        rows.map(|row| (at(row).to_degrees(), error(row))).collect()
    };
    let mut all: Vec<Curve> = (-1..=1)
        .map(|pair| Curve {
            name: ["previous pair", "tooth pair", "next pair"][(pair + 1) as usize].into(),
            colour: [3, 0, 4][(pair + 1) as usize],
            points: shifted(-pair, true),
            off: None,
        })
        .collect();
    let mut together: Vec<(f64, f64)> = (-1..=1).flat_map(|pair| shifted(pair, false)).collect();
    // Two pairs that touch have the same error but for the accuracy of their contacts.
    together.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    together.dedup_by(|next, kept| next.0 - kept.0 < 0.5 * step);
    all.push(Curve { name: "pair that touches".into(), colour: 1, points: together, off: None });
    let x = Axis { what: "rotation of the first gear", unit: "deg" };
    curves(TALL, &x, &Axis { what: "transmission error", unit: "urad" }, &all, &[])
}

/// Plots the part of the force that each tooth pair carries over the positions.
fn load_sharing(mesh: &Mesh<'_>, run: &Run) -> Plot {
    let mut totals: BTreeMap<usize, f64> = BTreeMap::new();
    for point in &mesh.path {
        *totals.entry(point.step).or_default() += point.force;
    }
    if totals.len() < 2 {
        return Plot::default();
    }
    let pairs: BTreeSet<[u32; 2]> =
        mesh.path.iter().map(|point| [point.first_tooth, point.second_tooth]).collect();
    let by_roll = run.positions.iter().any(|position| position.roll != 0.0);
    let place = |step: usize| match run.positions.get(step) {
        Some(position) if by_roll => position.roll.to_degrees(),
        Some(position) => position.time,
        None => f64::NAN,
    };
    let curve = |(index, pair): (usize, &[u32; 2])| {
        let share = |(step, total): (&usize, &f64)| {
            let mine = mesh
                .path
                .iter()
                .find(|point| point.step == *step && [point.first_tooth, point.second_tooth] == *pair);
            (place(*step), 100.0 * mine.map_or(0.0, |point| point.force / total))
        };
        Curve {
            name: format!("teeth {} and {}", pair[0], pair[1]),
            colour: index,
            points: totals.iter().map(share).collect(),
            off: None,
        }
    };
    let all: Vec<Curve> = pairs.iter().enumerate().map(curve).collect();
    let x = match by_roll {
        true => Axis { what: "roll angle of the entering tooth pair on the first gear", unit: "deg" },
        false => Axis { what: "time", unit: "s" },
    };
    curves(TALL, &x, &Axis { what: "load share", unit: "%" }, &all, &[])
}

#[cfg(test)]
mod tests;
