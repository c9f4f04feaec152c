//! Sizes of rolling bearings against each other and against the shafts, gears and pins that they
//! are mounted on. Bearings act at points, so that an impossible arrangement has an equilibrium
//! like any other; warnings show the mistake.

use crate::bearing_externs::Mounting;
use crate::host::{ModelHost, shown};
use calyx_runtime::bearing::Support;
use calyx_runtime::motion::spatial_pose;
use calyx_runtime::rolling::{Elements, Ring, RollingBearing, Row};
use calyx_runtime::scene::BodyId;

/// Difference between a diameter and that of its seat, relative to it, from which it is reported.
const FIT: f64 = 0.01;
/// Overlap relative to a size that counts as rounding.
const ROUNDING: f64 = 1e-9;

/// Boundary dimensions from a catalogue, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Boundary {
    /// Bore diameter.
    pub(crate) bore: f64,
    /// Outside diameter.
    pub(crate) outside_diameter: f64,
    /// Width.
    pub(crate) width: f64,
}

/// Part of the model that has a ring of a bearing.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Carrier {
    Shaft(usize),
    Body(usize),
}

/// Space that a bearing takes.
#[derive(Clone, Debug, PartialEq)]
pub struct BearingSpace {
    name: String,
    /// Carrier of the first race, and the range along its axis, m.
    carrier: Carrier,
    range: [f64; 2],
    /// Diameters at the inside and at the outside, m.
    diameters: [f64; 2],
}

/// Finds contradictions between the sizes of a new bearing and its surroundings, and records its
/// space. Returns messages with remedies.
pub(crate) fn check(
    host: &mut ModelHost,
    mounting: &Mounting,
    (rows, ring): (&RollingBearing, &str),
    boundary: Option<Boundary>,
) -> Vec<(String, &'static str)> {
    let unit = host.length_unit;
    let mm = |metres: f64| shown(metres, unit);
    let name = &mounting.name;
    let mut found = Vec::new();
    let diameters = match boundary {
        Some(boundary) => [boundary.bore, boundary.outside_diameter],
        None => raceways(rows),
    };
    let seats = match ring {
        "outer" => [second_seat(host, mounting), first_seat(mounting)],
        _ => [first_seat(mounting), second_seat(host, mounting)],
    };
    if let Some(seat) = &seats[0]
        && let Some((of, diameter)) = outside_of(host, seat)
        && (diameter > diameters[0] * (1.0 + ROUNDING)
            || boundary.is_some() && diameter < diameters[0] * (1.0 - FIT))
    {
        found.push(match boundary {
            Some(_) => (
                format!(
                    "bearing \"{name}\" has a bore of {}, and {of} has a diameter of {} there",
                    mm(diameters[0]),
                    mm(diameter)
                ),
                "correct the bore of the bearing, its position `at`, or the diameter of its seat",
            ),
            None => (
                format!(
                    "{of} has a diameter of {} at bearing \"{name}\", whose rolling elements leave {} inside",
                    mm(diameter),
                    mm(diameters[0])
                ),
                "correct `pitch_diameter`, the position `at`, or the diameter of the seat",
            ),
        });
    }
    if let Some(seat) = &seats[1]
        && let Some((of, diameter)) = inside_of(host, seat)
        && (diameter < diameters[1] * (1.0 - ROUNDING)
            || boundary.is_some() && diameter > diameters[1] * (1.0 + FIT))
    {
        found.push(match boundary {
            Some(_) => (
                format!(
                    "bearing \"{name}\" has an outside diameter of {}, and {of} has a bore of {}",
                    mm(diameters[1]),
                    mm(diameter)
                ),
                "correct the outside diameter of the bearing or the bore of its seat",
            ),
            None => (
                format!(
                    "{of} has a bore of {} at bearing \"{name}\", whose rolling elements need {}",
                    mm(diameter),
                    mm(diameters[1])
                ),
                "correct `pitch_diameter` or the bore of the seat",
            ),
        });
    }
    found.extend(rows_in_each_other(name, rows, &mm));
    found.extend(neighbours(host, mounting, (rows, diameters), boundary));
    found
}

/// Returns the smallest and the largest diameter of the raceways, m.
fn raceways(rows: &RollingBearing) -> [f64; 2] {
    let of = |row: &Row| {
        let [diameter, cosine] = match &row.elements {
            // The groove of the inner ring at the middle of the balls.
            Elements::Balls(balls) => [balls.geometry().ball_diameter, 1.0],
            Elements::Rollers(rollers) => {
                [rollers.geometry().roller_diameter, rollers.contact_angles()[1].cos()]
            }
        };
        [row.pitch_diameter() - diameter * cosine, 2.0 * row.contact(Ring::Outer).radius]
    };
    rows.rows().iter().map(of).fold([f64::INFINITY, 0.0], |all, row| [all[0].min(row[0]), all[1].max(row[1])])
}

/// Returns the axial extent of the elements of a row, m; rollers without that of their inclined
/// ends.
fn extent(row: &Row) -> f64 {
    match &row.elements {
        Elements::Balls(balls) => balls.geometry().ball_diameter,
        Elements::Rollers(rollers) => rollers.geometry().length * rollers.contact_angles()[1].cos(),
    }
}

/// Seat of a ring: its carrier and the position along its axis, m.
struct Seat {
    carrier: Carrier,
    at: f64,
}

fn first_seat(mounting: &Mounting) -> Option<Seat> {
    Some(match mounting.shaft {
        Some((shaft, at)) => Seat { carrier: Carrier::Shaft(shaft), at },
        None => Seat { carrier: Carrier::Body(mounting.body.0), at: mounting.at[2] },
    })
}

fn second_seat(host: &ModelHost, mounting: &Mounting) -> Option<Seat> {
    let Support::Body(BodyId(body)) = mounting.to else { return None };
    let Some(shaft) = mounting.to_shaft else { return Some(Seat { carrier: Carrier::Body(body), at: 0.0 }) };
    let pose = spatial_pose(host.scene.bodies.get(mounting.body.0)?.motion.as_ref(), 0.0).ok()?;
    let point = host.shafts.get(shaft)?.position_of(&host.scene, pose.point(mounting.at)).ok()?;
    Some(Seat { carrier: Carrier::Shaft(shaft), at: point.position })
}

/// Returns the outside diameter of a shaft or of a pin at a seat, with its name.
fn outside_of(host: &ModelHost, seat: &Seat) -> Option<(String, f64)> {
    match seat.carrier {
        Carrier::Shaft(shaft) => {
            let shaft = host.shafts.get(shaft)?;
            Some((format!("the shaft \"{}\"", shaft.name), shaft.shaft.diameters_at(seat.at)[0]))
        }
        Carrier::Body(body) => {
            let carrier = host.carriers.iter().find(|carrier| carrier.carries(BodyId(body)))?;
            Some((format!("a pin of the carrier \"{}\"", carrier.name), carrier.shape.pin_diameter))
        }
    }
}

/// Returns the bore of a hollow shaft or of a gear at a seat, with its name; none if no bore is
/// stated.
fn inside_of(host: &ModelHost, seat: &Seat) -> Option<(String, f64)> {
    match seat.carrier {
        Carrier::Shaft(shaft) => {
            let shaft = host.shafts.get(shaft)?;
            let bore = shaft.shaft.diameters_at(seat.at)[1];
            Some((format!("the shaft \"{}\"", shaft.name), bore))
        }
        Carrier::Body(body) => {
            let gear = host.gears.get(host.body_gears.get(body).copied().flatten()?)?.cylindrical()?;
            let is_stated = !gear.solid && !gear.form().internal;
            let name = &host.scene.bodies.get(body)?.name;
            is_stated.then(|| (format!("the gear \"{name}\""), 2.0 * gear.rim.fixed_radius))
        }
    }
}

/// Reports two rows whose elements reach into each other.
fn rows_in_each_other(
    name: &str,
    rows: &RollingBearing,
    mm: &impl Fn(f64) -> String,
) -> Option<(String, &'static str)> {
    let [first, second] = rows.rows() else { return None };
    let distance = (second.position - first.position).abs();
    let needed = 0.5 * (extent(first) + extent(second));
    (distance < needed * (1.0 - ROUNDING)).then(|| {
        let message = format!(
            "the rows of bearing \"{name}\" are {} apart, and their rolling elements need {}",
            mm(distance),
            mm(needed)
        );
        (message, "enlarge the distance of the rows, or reduce the size of the elements")
    })
}

/// Reports a bearing that overlaps another one on the same carrier, and records its space.
fn neighbours(
    host: &mut ModelHost,
    mounting: &Mounting,
    (rows, diameters): (&RollingBearing, [f64; 2]),
    boundary: Option<Boundary>,
) -> Option<(String, &'static str)> {
    let Seat { carrier, at } = first_seat(mounting)?;
    let ends = |row: &Row| [row.position - 0.5 * extent(row), row.position + 0.5 * extent(row)];
    let range = match boundary {
        Some(boundary) => [-0.5 * boundary.width, 0.5 * boundary.width],
        None => rows
            .rows()
            .iter()
            .map(ends)
            .fold([0.0f64; 2], |all, row| [all[0].min(row[0]), all[1].max(row[1])]),
    };
    let range = range.map(|end| at + end);
    let own = BearingSpace { name: mounting.name.clone(), carrier, range, diameters };
    let common = |one: [f64; 2], other: [f64; 2]| one[1].min(other[1]) - one[0].max(other[0]);
    let overlaps = |other: &&BearingSpace| {
        let size = (range[1] - range[0]).max(diameters[1]);
        other.carrier == carrier
            && common(other.range, range) > ROUNDING * size
            && common(other.diameters, diameters) > ROUNDING * size
    };
    let unit = host.length_unit;
    let other = host.bearing_spaces.iter().find(overlaps).map(|other| {
        let distance = 0.5 * (range[0] + range[1] - other.range[0] - other.range[1]).abs();
        let needed = 0.5 * (range[1] - range[0] + other.range[1] - other.range[0]);
        let message = format!(
            "bearings \"{}\" and \"{}\" are {} apart along their axis, and their sizes need {}",
            other.name,
            own.name,
            shown(distance, unit),
            shown(needed, unit)
        );
        (message, "correct their positions `at`")
    });
    host.bearing_spaces.push(own);
    other
}
