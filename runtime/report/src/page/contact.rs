//! Contact over a run, from the line loads along the contact lines: the contact pattern on a flank,
//! the load distribution along the face, and the load of a tooth pair along the path of contact.

use super::chart::{Axis, Curve, MapCell, Plot, TALL, WIDE, curves, map};
use super::read::Loaded;
use super::units::Units;
use std::collections::BTreeMap;

/// Number of meshes shown, those with the largest pressures.
const SHOWN: usize = 4;
/// Largest number of strips along the face in a contact pattern.
const STRIPS: usize = 48;
/// Points farther apart than this multiple of the usual distance are not connected.
const APART: f64 = 3.0;

/// Contact of two bodies, on one side of their teeth.
pub struct Mesh {
    pub bodies: [String; 2],
    /// True for the flanks opposite to the driving ones.
    pub back: bool,
    /// Largest pressure away from edges, Pa.
    pub largest: f64,
    /// Largest pressure on and next to edges, Pa.
    pub largest_on_edges: f64,
    /// Largest pressure at each point of the first body's flank, away from edges.
    pub pattern: Plot,
    /// Load distribution along the face; empty in a plane model.
    pub along_face: Plot,
    /// Load of a tooth pair along its path of contact.
    pub path: Plot,
    /// Sliding, friction, temperature and film of a lubricated mesh, with their captions.
    pub lubricated: Vec<(Plot, &'static str)>,
}

/// Returns the meshes of a run by side of the teeth, in descending order of pressure; and the
/// number of omitted ones.
pub fn meshes(rows: &[Loaded], units: Units) -> (Vec<Mesh>, usize) {
    let mut by_bodies: BTreeMap<([&str; 2], bool), Vec<&Loaded>> = BTreeMap::new();
    for row in rows {
        let bodies = [&row.first_body[..], &row.second_body];
        by_bodies.entry((bodies, row.is_coast_side())).or_default().push(row);
    }
    type Side<'r> = (([&'r str; 2], bool), Vec<&'r Loaded>, f64);
    let mut all: Vec<Side<'_>> = by_bodies
        .into_iter()
        .map(|(of, rows)| {
            let largest = rows.iter().map(|row| row.pressure).fold(0.0, f64::max);
            (of, rows, largest)
        })
        .collect();
    all.sort_by(|one, other| other.2.total_cmp(&one.2));
    let left_out = all.len().saturating_sub(SHOWN);
    let mesh = |((bodies, back), rows, largest): Side<'_>| {
        let along = FaceCurve::of(&rows, units);
        Mesh {
            bodies: bodies.map(str::to_owned),
            back,
            largest,
            largest_on_edges: rows.iter().map(|row| row.edge_pressure).fold(0.0, f64::max),
            pattern: pattern(&rows, &along, bodies[0], units),
            along_face: along_face(&rows, units),
            path: path(&rows, &along, bodies[0], units),
            lubricated: lubricated(&rows, &along, bodies[0], units),
        }
    };
    (all.into_iter().take(SHOWN).map(mesh).collect(), left_out)
}

/// Coordinate along the profile of the first body: its roll angle, or the radius if the profile is
/// no involute.
struct FaceCurve {
    what: &'static str,
    unit: &'static str,
    place: Box<dyn Fn(&Loaded) -> f64>,
}

impl FaceCurve {
    fn of(rows: &[&Loaded], units: Units) -> FaceCurve {
        match rows.iter().all(|row| row.first_roll_angle.is_some()) {
            true => FaceCurve {
                what: "roll angle",
                unit: "deg",
                place: Box::new(|row| row.first_roll_angle.unwrap_or(f64::NAN).to_degrees()),
            },
            false => FaceCurve {
                what: "radius",
                unit: units.length.name,
                place: Box::new(move |row| units.length.of(row.first_radius)),
            },
        }
    }

    fn axis<'a>(&self, what: &'a str) -> Axis<'a>
    where
        Self: 'a,
    {
        Axis { what, unit: self.unit }
    }
}

fn pattern(rows: &[&Loaded], along: &FaceCurve, body: &str, units: Units) -> Plot {
    let pressure = Axis { what: "pressure", unit: units.stress.name };
    over_flank(rows, along, (body, units), &pressure, (f64::max, &|row| Some(units.stress.of(row.pressure))))
}

/// Plots sliding, friction, temperature and film of a lubricated mesh over the flank; none without
/// lubrication. The smallest film thickness is shown at each point, and the largest value of the
/// other quantities.
fn lubricated(rows: &[&Loaded], along: &FaceCurve, body: &str, units: Units) -> Vec<(Plot, &'static str)> {
    if rows.iter().all(|row| row.film_thickness.is_none()) {
        return Vec::new();
    }
    let Units { film, velocity, line_power, .. } = units;
    let plot =
        |what, unit, seen: Seen<'_>| over_flank(rows, along, (body, units), &Axis { what, unit }, seen);
    let sliding = |row: &Loaded| Some(velocity.of(row.sliding_velocity?));
    let power = |row: &Loaded| Some(line_power.of(row.friction_power?));
    let thickness = |row: &Loaded| Some(film.of(row.film_thickness?));
    vec![
        (
            plot("sliding velocity", velocity.name, (f64::max, &sliding)),
            "Largest sliding velocity at each point of the flank.",
        ),
        (
            plot("friction power", line_power.name, (f64::max, &power)),
            "Largest frictional power per length of the contact line.",
        ),
        (
            plot("flash temperature", "K", (f64::max, &|row| row.flash_temperature)),
            "Largest flash temperature (Blok).",
        ),
        (
            plot("film thickness", film.name, (f64::min, &thickness)),
            "Smallest film thickness (Dowson and Higginson).",
        ),
    ]
}

/// Choice between two values at one point of the flank, and the value of a row.
type Seen<'a> = (fn(f64, f64) -> f64, &'a dyn Fn(&Loaded) -> Option<f64>);

/// Plots the largest or smallest value of a quantity at each point of the flank of the first body:
/// a map, or a curve along the profile in a plane model.
fn over_flank(
    rows: &[&Loaded],
    along: &FaceCurve,
    (body, units): (&str, Units),
    axis: &Axis<'_>,
    (choose, value): Seen<'_>,
) -> Plot {
    let what = format!("{} on {body}", along.what);
    let points = |rows: &[&Loaded]| {
        let points = rows.iter().filter_map(|row| Some(((along.place)(row), value(row)?)));
        seen_along(points.collect(), choose)
    };
    let Some(strips) = strips(rows) else {
        // In a plane model a flank is a line.
        let curve = Curve { points: points(rows), ..Curve::default() };
        return curves(WIDE, &along.axis(&what), axis, &[curve], &[]);
    };
    let mut pieces = Vec::new();
    for (ends, rows) in strips {
        let x = ends.map(|end| units.length.of(end));
        pieces.extend(steps_of(&points(&rows)).into_iter().map(|(y, value)| MapCell { x, y, value }));
    }
    let across = Axis { what: "axial position", unit: units.length.name };
    map(&across, &along.axis(&what), axis, &pieces)
}

/// Divides the face into strips with their rows; `None` in a plane model.
fn strips<'r>(rows: &[&'r Loaded]) -> Option<Vec<([f64; 2], Vec<&'r Loaded>)>> {
    let at = |row: &Loaded| row.axial.unwrap_or(f64::NAN);
    let mut lengths: Vec<f64> = rows.iter().filter(|row| row.axial.is_some()).map(|row| row.length).collect();
    lengths.sort_by(f64::total_cmp);
    let usual = *lengths.get(lengths.len() / 2)?;
    let low = rows.iter().map(|row| at(row) - 0.5 * usual).fold(f64::INFINITY, f64::min);
    let high = rows.iter().map(|row| at(row) + 0.5 * usual).fold(f64::NEG_INFINITY, f64::max);
    // Slightly wider than a slice, so that every strip has one.
    let count = (((high - low) / (1.05 * usual)) as usize).clamp(1, STRIPS);
    let width = (high - low) / count as f64;
    let mut strips: Vec<([f64; 2], Vec<&Loaded>)> =
        (0..count).map(|k| ([low + k as f64 * width, low + (k + 1) as f64 * width], Vec::new())).collect();
    for row in rows.iter().filter(|row| at(row).is_finite()) {
        let place = |z: f64| ((z - low) / width).clamp(0.0, count as f64);
        // The strips whose centre the slice covers, and the strip of its own centre: slices of
        // other positions have other bounds.
        let half = 0.5 * row.length.max(usual);
        let own = (place(at(row)) as usize).min(count - 1);
        let [from, to] = [at(row) - half, at(row) + half].map(|end| (place(end) + 0.5 - 1e-6) as usize);
        let reached = from.min(own)..=to.saturating_sub(1).max(own);
        strips[reached].iter_mut().for_each(|strip| strip.1.push(*row));
    }
    Some(strips)
}

/// Sorts values by coordinate and keeps one of those at the same coordinate.
fn seen_along(mut points: Vec<(f64, f64)>, choose: fn(f64, f64) -> f64) -> Vec<(f64, f64)> {
    points.retain(|(place, value)| place.is_finite() && value.is_finite());
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return points };
    // Values of several tooth pairs, and on both sides of a jump, are merged.
    let together = (last.0 - first.0) / 400.0;
    let mut seen: Vec<(f64, f64)> = Vec::new();
    for (place, value) in points {
        match seen.last_mut() {
            Some(last) if place - last.0 < together => last.1 = choose(last.1, value),
            _ => seen.push((place, value)),
        }
    }
    seen
}

/// Returns the interval of each point: half way to its neighbours, if they are near.
fn steps_of(points: &[(f64, f64)]) -> Vec<([f64; 2], f64)> {
    let mut gaps: Vec<f64> = points.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    gaps.sort_by(f64::total_cmp);
    let Some(&usual) = gaps.get(gaps.len() / 2) else { return Vec::new() };
    let half = |gap: f64| 0.5 * if gap > APART * usual { usual } else { gap };
    let reach = |index: usize| {
        let place = points[index].0;
        let before = index.checked_sub(1).map_or(usual, |before| place - points[before].0);
        let after = points.get(index + 1).map_or(usual, |after| after.0 - place);
        [place - half(before), place + half(after)]
    };
    let mut steps: Vec<([f64; 2], f64)> =
        (0..points.len()).map(|index| (reach(index), points[index].1)).collect();
    // Bounds of neighbours are equal to the bit.
    for index in 1..steps.len() {
        if points[index].0 - points[index - 1].0 <= APART * usual {
            steps[index].0[0] = steps[index - 1].0[1];
        }
    }
    steps
}

/// Plots the load along the face: one curve per tooth pair at the position with the largest load,
/// and the envelope of all positions.
fn along_face(rows: &[&Loaded], units: Units) -> Plot {
    let Some(strips) = strips(rows) else { return Plot::default() };
    let Some(worst) = rows.iter().max_by(|one, other| one.line_load.total_cmp(&other.line_load)) else {
        return Plot::default();
    };
    // Slices of other positions have other centres: loads are interpolated linearly between them.
    type Points = Vec<(f64, f64)>;
    let mut lines: BTreeMap<(usize, [u32; 2]), Points> = BTreeMap::new();
    for row in rows {
        let Some(axial) = row.axial else { continue };
        let line = lines.entry((row.step, [row.first_tooth, row.second_tooth])).or_default();
        line.push((units.length.of(axial), units.line_load.of(row.line_load)));
    }
    lines.values_mut().for_each(|line| line.sort_by(|one, other| one.0.total_cmp(&other.0)));
    let largest = strips.iter().filter_map(|(ends, _)| {
        let at = units.length.of(0.5 * (ends[0] + ends[1]));
        Some((at, lines.values().filter_map(|line| between(line, at)).max_by(f64::total_cmp)?))
    });
    let mut all = vec![Curve {
        name: "maximum over all positions".into(),
        colour: 0,
        points: largest.collect(),
        off: None,
    }];
    let of_worst = lines.iter().filter(|((step, _), _)| *step == worst.step);
    for (index, ((_, [first, second]), points)) in of_worst.enumerate() {
        let name = format!("teeth {first} and {second} at the maximum");
        all.push(Curve { name, colour: index + 1, points: points.clone(), off: None });
    }
    let across = Axis { what: "axial position", unit: units.length.name };
    curves(TALL, &across, &Axis { what: "load", unit: units.line_load.name }, &all, &[])
}

/// Interpolates linearly in sorted points; `None` outside.
fn between(line: &[(f64, f64)], at: f64) -> Option<f64> {
    let behind = line.partition_point(|point| point.0 < at);
    let (x, y) = *line.get(behind)?;
    let (before, value) = match behind.checked_sub(1) {
        Some(before) => line[before],
        None => return (x == at).then_some(y),
    };
    Some(value + (y - value) * (at - before) / (x - before))
}

/// Plots the load of a tooth pair along the path of contact: one curve, from several pairs at every
/// position.
fn path(rows: &[&Loaded], along: &FaceCurve, body: &str, units: Units) -> Plot {
    let mut of_pairs: BTreeMap<(usize, [u32; 2]), [f64; 2]> = BTreeMap::new();
    for row in rows {
        let [force, moment] = of_pairs.entry((row.step, [row.first_tooth, row.second_tooth])).or_default();
        *force += row.force;
        *moment += row.force * (along.place)(row);
    }
    let points = of_pairs.into_values().map(|[force, moment]| (moment / force, units.force.of(force)));
    let mut points: Vec<(f64, f64)> = points.filter(|point| point.0.is_finite()).collect();
    points.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.total_cmp(&other.1)));
    let what = format!("{} on {body}", along.what);
    let load = Axis { what: "load of a tooth pair", unit: units.force.name };
    curves(WIDE, &along.axis(&what), &load, &[Curve { points, ..Curve::default() }], &[])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(step: usize, tooth: u32, roll: f64, axial: Option<f64>, load: f64) -> Loaded {
        Loaded {
            step,
            first_body: "pinion".into(),
            first_tooth: tooth,
            second_body: "gear".into(),
            second_tooth: tooth,
            flank: String::new(),
            side: String::new(),
            first_radius: 0.02,
            first_roll_angle: Some(roll),
            second_radius: 0.04,
            second_roll_angle: None,
            axial,
            length: 1e-3,
            force: 1e-3 * load,
            line_load: load,
            pressure: load,
            edge_pressure: 0.0,
            sliding_velocity: None,
            friction_power: None,
            flash_temperature: None,
            film_thickness: None,
        }
    }

    #[test]
    fn strips_hold_every_slice_and_steps_cover_the_flank() {
        // Two teeth that engage in succession, four slices along the face.
        let rows: Vec<Loaded> = (0..20)
            .flat_map(|k| {
                let place = |s: usize| Some(1e-3 * s as f64 - 1.5e-3);
                (0..4).map(move |s| row(k % 10, (k / 10) as u32, 0.01 * k as f64, place(s), 1e5 + k as f64))
            })
            .collect();
        let rows: Vec<&Loaded> = rows.iter().collect();
        let strips = strips(&rows).unwrap();
        assert!(strips.iter().all(|strip| strip.1.len() >= 20));
        assert!((strips[0].0[0] + 2e-3).abs() < 1e-12 && (strips.last().unwrap().0[1] - 2e-3).abs() < 1e-12);
        for (_, rows) in &strips {
            let points = rows.iter().map(|row| (row.first_roll_angle.unwrap(), row.pressure)).collect();
            let steps = steps_of(&seen_along(points, f64::max));
            assert!(steps.windows(2).all(|pair| pair[0].0[1] == pair[1].0[0]), "{steps:?}");
            assert_eq!(steps.len(), 20);
        }
        let (meshes, left_out) =
            meshes(&rows.iter().map(|row| (*row).clone()).collect::<Vec<_>>(), Units::of_system("SI"));
        assert_eq!((meshes.len(), left_out), (1, 0));
        let [mesh] = &meshes[..] else { panic!() };
        assert!(
            mesh.pattern.svg.contains("<rect")
                && mesh.along_face.legend.iter().any(|(_, name)| name.contains("teeth 1 and 1"))
                && !mesh.path.is_empty()
        );
    }

    /// Flanks on both sides of teeth have the same roll angles but separate maps.
    #[test]
    fn both_sides_of_teeth_have_maps_of_their_own() {
        // Tables of earlier versions have the column `side` only.
        for [drive, coast] in [[("drive", "driving"), ("coast", "back")], [("", "driving"), ("", "back")]] {
            let on = |(flank, side): (&str, &str), load: f64| -> Vec<Loaded> {
                let row = |k| row(k, 0, 0.1 * k as f64, None, load);
                (0..9).map(|k| Loaded { flank: flank.into(), side: side.into(), ..row(k) }).collect()
            };
            let (meshes, _) = meshes(&[on(coast, 2e5), on(drive, 7e5)].concat(), Units::of_system("SI"));
            let sides: Vec<(bool, f64)> = meshes.iter().map(|mesh| (mesh.back, mesh.largest)).collect();
            assert_eq!(sides, [(false, 7e5), (true, 2e5)]);
            assert!(meshes.iter().all(|mesh| mesh.pattern.svg.contains("<polyline")));
        }
    }

    /// Grids of positions have different lengths, and an odd number of slices.
    #[test]
    fn no_strip_is_left_out_where_slices_lie_on_its_ends() {
        let rows: Vec<Loaded> = (0..12)
            .flat_map(|k| {
                let length = 1e-3 * (1.0 + 0.01 * k as f64);
                (-3..=3).map(move |s| Loaded {
                    length,
                    ..row(k, 0, 0.01 * k as f64, Some(length * f64::from(s) - 1e-17), 1e5)
                })
            })
            .collect();
        let rows: Vec<&Loaded> = rows.iter().collect();
        for (ends, rows) in strips(&rows).unwrap() {
            assert!(rows.len() >= 12, "{ends:?}: {} of 12 positions", rows.len());
        }
    }

    /// A lubricated mesh has four more plots; of two films at one point, the thinner one counts.
    #[test]
    fn a_lubricated_mesh_shows_temperature_and_film() {
        assert_eq!(seen_along(vec![(0.0, 3.0), (0.0, 2.0), (1.0, 5.0)], f64::min), [(0.0, 2.0), (1.0, 5.0)]);
        for axial in [None, Some(0.0)] {
            let dry: Vec<Loaded> = (0..9).map(|k| row(k, 0, 0.1 * k as f64, axial, 1e5)).collect();
            assert!(meshes(&dry, Units::of_system("mm_N_s")).0[0].lubricated.is_empty());
            let wet = dry.into_iter().map(|row| Loaded {
                sliding_velocity: Some(1.0),
                friction_power: Some(2e3),
                flash_temperature: Some(20.0 + row.step as f64),
                film_thickness: Some(3e-7),
                ..row
            });
            let (meshes, _) = meshes(&wet.collect::<Vec<_>>(), Units::of_system("mm_N_s"));
            let plots = &meshes[0].lubricated;
            assert!(plots.len() == 4 && plots.iter().all(|(plot, _)| !plot.is_empty()));
            assert!(
                plots[2].0.svg.contains("flash temperature") && plots[3].0.svg.contains("film thickness")
            );
        }
    }

    /// Slices of a position are wider than the strips: the envelope is linear between their
    /// centres, without steps.
    #[test]
    fn the_largest_load_along_the_face_has_no_steps() {
        let line = [(0.0, 1.0), (1.0, 3.0), (2.0, 3.0)];
        let found = [-0.1, 0.0, 0.25, 1.0, 1.5, 2.0, 2.1].map(|at| between(&line, at));
        assert_eq!(found, [None, Some(1.0), Some(1.5), Some(3.0), Some(3.0), Some(3.0), None]);
    }

    #[test]
    fn a_place_far_from_all_others_stands_for_itself() {
        let points = [(0.0, 1.0), (1.0, 1.0), (2.0, 1.0), (10.0, 5.0)];
        let steps = steps_of(&points);
        assert_eq!(steps[2].0, [1.5, 2.5]);
        assert_eq!(steps[3].0, [9.5, 10.5]);
    }

    #[test]
    fn a_plane_model_has_a_curve_and_nothing_along_the_face() {
        let rows: Vec<Loaded> = (0..9).map(|k| row(k, 0, 0.1 * k as f64, None, 1e5)).collect();
        let (meshes, _) = meshes(&rows, Units::of_system("inch_lbf_s"));
        assert!(meshes[0].pattern.svg.contains("<polyline") && meshes[0].along_face.is_empty());
    }
}
