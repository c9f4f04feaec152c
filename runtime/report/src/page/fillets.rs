//! Extreme stresses in the fillets over a run: along the profile and, in 3-D models, over profile
//! and face. A level without meshes has one point per profile: its stresses are plotted along the
//! face, or are two numbers.

use super::chart::{Axis, Curve, MapCell, Plot, WIDE, curves, map};
use super::units::Units;
use crate::stress_range::StressExtremes;
use std::collections::BTreeMap;

/// Number of bodies shown.
const SHOWN: usize = 6;

/// Fillets of a body.
pub struct Fillets {
    pub body: String,
    /// Largest stress, Pa.
    pub largest: f64,
    /// Smallest stress, Pa.
    pub smallest: f64,
    /// Largest and smallest stress over the distance along the fillet, extremes along the face;
    /// empty if a profile has one point.
    pub along_profile: Plot,
    /// Largest stress over profile and face; empty in a plane model.
    pub over_face: Plot,
    /// Stresses along the face if a profile has one point; empty in a plane model.
    pub along_face: Plot,
    /// Smallest and largest radius of that point over the face and both flanks, m.
    pub radii: Option<[f64; 2]>,
}

/// Returns the bodies of a run with stresses, in descending order of stress; and the number of
/// omitted ones.
pub fn fillets(seen: &[StressExtremes], units: Units) -> (Vec<Fillets>, usize) {
    let mut bodies: BTreeMap<&str, Vec<&StressExtremes>> = BTreeMap::new();
    for seen in seen {
        bodies.entry(&seen.body).or_default().push(seen);
    }
    let of_body = |(body, seen): (&str, Vec<&StressExtremes>)| {
        let one_place = seen.iter().all(|seen| seen.point == 0);
        let largest = seen.iter().map(|seen| seen.largest).fold(f64::NEG_INFINITY, f64::max);
        Fillets {
            body: body.to_owned(),
            largest,
            smallest: seen.iter().map(|seen| seen.smallest).fold(f64::INFINITY, f64::min),
            along_profile: if one_place { Plot::default() } else { along_profile(&seen, units) },
            over_face: if one_place { Plot::default() } else { over_face(&seen, units) },
            along_face: if one_place { along_face(&seen, units) } else { Plot::default() },
            radii: one_place.then(|| radii(&seen)),
        }
    };
    let mut all: Vec<Fillets> = bodies.into_iter().map(of_body).collect();
    all.sort_by(|one, other| other.largest.total_cmp(&one.largest));
    let left_out = all.len().saturating_sub(SHOWN);
    all.truncate(SHOWN);
    (all, left_out)
}

/// Returns the smallest and the largest radius, m.
fn radii(seen: &[&StressExtremes]) -> [f64; 2] {
    let radii = seen.iter().map(|seen| seen.radius);
    radii.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], radius| {
        [least.min(radius), most.max(radius)]
    })
}

/// Returns the flank next to the largest stress.
fn loaded(seen: &[&StressExtremes]) -> u32 {
    seen.iter().max_by(|one, other| one.largest.total_cmp(&other.largest)).map_or(0, |seen| seen.flank)
}

fn along_profile(seen: &[&StressExtremes], units: Units) -> Plot {
    let x = Axis { what: "along the fillet, from the end of the flank", unit: units.length.name };
    extremes(seen, &x, units, |seen| Some((seen.point, units.length.of(seen.depth))))
}

fn along_face(seen: &[&StressExtremes], units: Units) -> Plot {
    let x = Axis { what: "axial position", unit: units.length.name };
    extremes(seen, &x, units, |seen| Some((seen.section, units.length.of(seen.axial?))))
}

/// Returns the extremes of the stress over the index and coordinate that `place` returns, for both
/// flanks; skips points without a coordinate.
fn extremes(
    seen: &[&StressExtremes],
    x: &Axis<'_>,
    units: Units,
    place: impl Fn(&StressExtremes) -> Option<(usize, f64)>,
) -> Plot {
    let loaded = loaded(seen);
    let mut by_place: BTreeMap<(u32, usize), (f64, [f64; 2])> = BTreeMap::new();
    for seen in seen {
        let Some((number, at)) = place(seen) else { continue };
        let (_, [largest, smallest]) =
            by_place.entry((seen.flank, number)).or_insert((at, [f64::NEG_INFINITY, f64::INFINITY]));
        *largest = largest.max(seen.largest);
        *smallest = smallest.min(seen.smallest);
    }
    let mut all = Vec::new();
    for (flank, side) in [(loaded, "loaded side"), (1 - loaded.min(1), "other side")] {
        let of_flank =
            || by_place.iter().filter(move |((other, _), _)| *other == flank).map(|(_, seen)| seen);
        for (which, name) in ["largest", "smallest"].into_iter().enumerate() {
            let points: Vec<(f64, f64)> =
                of_flank().map(|(at, stresses)| (*at, units.stress.of(stresses[which]))).collect();
            if !points.is_empty() {
                let colour = 2 * usize::from(flank != loaded) + which;
                all.push(Curve { name: format!("{name}, {side}"), colour, points, off: None });
            }
        }
    }
    curves(WIDE, x, &Axis { what: "stress", unit: units.stress.name }, &all, &[])
}

fn over_face(seen: &[&StressExtremes], units: Units) -> Plot {
    let loaded = loaded(seen);
    let mut sections: BTreeMap<usize, Vec<&StressExtremes>> = BTreeMap::new();
    for seen in seen.iter().filter(|seen| seen.flank == loaded) {
        sections.entry(seen.section).or_default().push(seen);
    }
    let sections: Vec<Vec<&StressExtremes>> = sections.into_values().collect();
    let places = |of: &dyn Fn(&StressExtremes) -> Option<f64>,
                  points: &[&StressExtremes]|
     -> Option<Vec<f64>> { points.iter().map(|seen| of(seen)).collect() };
    let firsts: Vec<&StressExtremes> =
        sections.iter().filter_map(|section| section.first().copied()).collect();
    let Some(axial) = places(&|seen| seen.axial, &firsts).filter(|places| places.len() > 1) else {
        return Plot::default();
    };
    let mut pieces = Vec::new();
    for (index, section) in sections.iter().enumerate() {
        let depths: Vec<f64> = section.iter().map(|seen| seen.depth).collect();
        let x = between(&axial, index).map(|end| units.length.of(end));
        for (point, seen) in section.iter().enumerate() {
            let y = between(&depths, point).map(|end| units.length.of(end));
            pieces.push(MapCell { x, y, value: units.stress.of(seen.largest).max(0.0) });
        }
    }
    let x = Axis { what: "axial position", unit: units.length.name };
    let y = Axis { what: "along the fillet", unit: units.length.name };
    map(&x, &y, &Axis { what: "stress", unit: units.stress.name }, &pieces)
}

/// Returns the midpoints to both neighbours.
fn between(places: &[f64], index: usize) -> [f64; 2] {
    let here = places[index];
    let half = |other: Option<&f64>| other.map_or(here, |other| 0.5 * (here + other));
    [half(index.checked_sub(1).and_then(|before| places.get(before))), half(places.get(index + 1))]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(flank: u32, section: usize, point: usize, axial: Option<f64>) -> StressExtremes {
        StressExtremes {
            body: "pinion".into(),
            flank,
            section,
            point,
            depth: 1e-4 * point as f64,
            radius: 0.02,
            axial,
            largest: 1e8 + 1e6 * (section + point) as f64,
            smallest: -1e8,
        }
    }

    /// Closed-form models have one point per profile: a plot along the profile would be a dot.
    #[test]
    fn one_place_of_a_profile_is_no_plot_along_it() {
        let units = Units::of_system("SI");
        let of = |seen: &[StressExtremes]| {
            let (mut all, _) = fillets(seen, units);
            all.remove(0)
        };
        let plane = of(&[seen(0, 0, 0, None), seen(1, 0, 0, None)]);
        assert!(plane.along_profile.is_empty() && plane.over_face.is_empty() && plane.along_face.is_empty());
        assert_eq!((plane.radii, plane.largest), (Some([0.02; 2]), 1e8));
        let slices: Vec<StressExtremes> = (0..5).map(|k| seen(0, k, 0, Some(1e-3 * k as f64))).collect();
        let space = of(&slices);
        assert!(space.along_profile.is_empty() && space.over_face.is_empty());
        assert_eq!(space.along_face.legend.len(), 2);
        let elements: Vec<StressExtremes> =
            (0..20).map(|k| seen(0, k / 4, k % 4, Some(1e-3 * (k / 4) as f64))).collect();
        let elements = of(&elements);
        assert!(!elements.along_profile.is_empty() && !elements.over_face.is_empty());
        assert!(elements.along_face.is_empty() && elements.radii.is_none());
    }
}
