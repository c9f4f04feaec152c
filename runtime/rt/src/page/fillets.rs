//! The stresses that the fillets see over a run: along the profile, and in space over profile and face.

use super::chart::{Axis, Curve, Piece, WIDE, curves, map};
use super::units::Units;
use crate::stress_range::Seen;
use std::collections::BTreeMap;

/// Bodies that are shown.
const SHOWN: usize = 6;

/// The fillets of a body.
pub struct Fillets {
    pub body: String,
    /// Pa
    pub largest: f64,
    pub smallest: f64,
    /// Over the distance along the fillet, the largest and smallest along the face.
    pub along_profile: String,
    /// The largest stress over both; empty in a plane model.
    pub over_face: String,
}

/// The bodies of a run that have stresses, the largest stress first; and how many are left out.
pub fn fillets(seen: &[Seen], units: Units) -> (Vec<Fillets>, usize) {
    let mut bodies: BTreeMap<&str, Vec<&Seen>> = BTreeMap::new();
    for seen in seen {
        bodies.entry(&seen.body).or_default().push(seen);
    }
    let of_body = |(body, seen): (&str, Vec<&Seen>)| {
        let largest = seen.iter().map(|seen| seen.largest).fold(f64::NEG_INFINITY, f64::max);
        Fillets {
            body: body.to_owned(),
            largest,
            smallest: seen.iter().map(|seen| seen.smallest).fold(f64::INFINITY, f64::min),
            along_profile: along_profile(&seen, units),
            over_face: over_face(&seen, units),
        }
    };
    let mut all: Vec<Fillets> = bodies.into_iter().map(of_body).collect();
    all.sort_by(|one, other| other.largest.total_cmp(&one.largest));
    let left_out = all.len().saturating_sub(SHOWN);
    all.truncate(SHOWN);
    (all, left_out)
}

/// The flank beside which the largest stress is.
fn loaded(seen: &[&Seen]) -> u32 {
    seen.iter().max_by(|one, other| one.largest.total_cmp(&other.largest)).map_or(0, |seen| seen.flank)
}

fn along_profile(seen: &[&Seen], units: Units) -> String {
    let loaded = loaded(seen);
    let mut by_point: BTreeMap<(u32, usize), (f64, [f64; 2])> = BTreeMap::new();
    for seen in seen {
        let (_, [largest, smallest]) = by_point
            .entry((seen.flank, seen.point))
            .or_insert((seen.depth, [f64::NEG_INFINITY, f64::INFINITY]));
        *largest = largest.max(seen.largest);
        *smallest = smallest.min(seen.smallest);
    }
    let mut all = Vec::new();
    for (flank, side) in [(loaded, "loaded side"), (1 - loaded.min(1), "other side")] {
        let of_flank =
            || by_point.iter().filter(move |((other, _), _)| *other == flank).map(|(_, seen)| seen);
        for (which, name) in ["largest", "smallest"].into_iter().enumerate() {
            let points: Vec<(f64, f64)> = of_flank()
                .map(|(depth, stresses)| (units.length.of(*depth), units.stress.of(stresses[which])))
                .collect();
            if !points.is_empty() {
                let colour = 2 * usize::from(flank != loaded) + which;
                all.push(Curve { name: format!("{name}, {side}"), colour, points, off: None });
            }
        }
    }
    let x = Axis { what: "along the fillet, from the end of the flank", unit: units.length.name };
    curves(WIDE, &x, &Axis { what: "stress", unit: units.stress.name }, &all, &[])
}

fn over_face(seen: &[&Seen], units: Units) -> String {
    let loaded = loaded(seen);
    let mut sections: BTreeMap<usize, Vec<&Seen>> = BTreeMap::new();
    for seen in seen.iter().filter(|seen| seen.flank == loaded) {
        sections.entry(seen.section).or_default().push(seen);
    }
    let sections: Vec<Vec<&Seen>> = sections.into_values().collect();
    let places = |of: &dyn Fn(&Seen) -> Option<f64>, points: &[&Seen]| -> Option<Vec<f64>> {
        points.iter().map(|seen| of(seen)).collect()
    };
    let firsts: Vec<&Seen> = sections.iter().filter_map(|section| section.first().copied()).collect();
    let Some(axial) = places(&|seen| seen.axial, &firsts).filter(|places| places.len() > 1) else {
        return String::new();
    };
    let mut pieces = Vec::new();
    for (index, section) in sections.iter().enumerate() {
        let depths: Vec<f64> = section.iter().map(|seen| seen.depth).collect();
        let x = between(&axial, index).map(|end| units.length.of(end));
        for (point, seen) in section.iter().enumerate() {
            let y = between(&depths, point).map(|end| units.length.of(end));
            pieces.push(Piece { x, y, value: units.stress.of(seen.largest).max(0.0) });
        }
    }
    let x = Axis { what: "from mid-face", unit: units.length.name };
    let y = Axis { what: "along the fillet", unit: units.length.name };
    map(&x, &y, &Axis { what: "stress", unit: units.stress.name }, &pieces)
}

/// Half the way to both neighbours.
fn between(places: &[f64], index: usize) -> [f64; 2] {
    let here = places[index];
    let half = |other: Option<&f64>| other.map_or(here, |other| 0.5 * (here + other));
    [half(index.checked_sub(1).and_then(|before| places.get(before))), half(places.get(index + 1))]
}
