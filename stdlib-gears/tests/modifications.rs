//! Flank modifications: profile, lead and topography, on external and internal teeth.

use calyx_gears::blank::GearBlank;
use calyx_gears::flank::Flank;
use calyx_gears::modification::{Modification, ReliefShape, ReliefStart, TipRelief};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::surface::{Surface, SurfacePoint};
use std::sync::Arc;

const MODULE: f64 = 4e-3;
const FACE: f64 = 40e-3;
const UM: f64 = 1e-6;

/// The external gear (0) or the internal one (1).
fn made(index: usize, modifications: &[Modification]) -> Arc<GearPrototype> {
    let alpha = 20.0_f64.to_radians();
    if index == 0 {
        let rack = Rack::new(MODULE, alpha, 0.3 * MODULE).expect("a rack");
        let mut external = GearBlank::standard(25, rack).face_width(FACE);
        external.modifications = modifications.to_vec();
        return external.cut().expect("a gear");
    }
    let shaper = Shaper::new(25, MODULE, alpha, 1.25 * MODULE, 0.2 * MODULE).expect("a shaper");
    let mut internal = GearBlank::standard(60, shaper);
    internal.modifications = modifications.to_vec();
    internal.face_width = FACE;
    internal.cut().expect("a ring")
}

/// Roll angle of the gear's involute, positive, at a fraction of the range from form circle to tip
/// circle.
fn roll_at(gear: &GearPrototype, part: f64) -> f64 {
    let form = gear.form();
    (form.form_roll + part * (form.tip_roll - form.form_roll)).abs()
}

fn off(flank: &Flank, gear: &GearPrototype, part: f64) -> f64 {
    let roll = gear.form().sense() * roll_at(gear, part);
    flank.relief_at(flank.s_at_roll(roll))
}

#[test]
fn reliefs_of_tip_and_root_are_deepest_at_their_ends() {
    let plain = [made(0, &[]), made(1, &[])];
    for index in 0..2 {
        let [tip_from, root_from] = [0.7, 0.3].map(|part| roll_at(&plain[index], part));
        for shape in [ReliefShape::Linear, ReliefShape::Quadratic] {
            let relief =
                |depth, start_roll| TipRelief { depth, start: ReliefStart::at_roll(start_roll), shape };
            let gear = &made(
                index,
                &[
                    Modification::TipRelief(relief(20.0 * UM, tip_from)),
                    Modification::RootRelief(relief(12.0 * UM, root_from)),
                ],
            );
            for flank in gear.flanks() {
                let linear = if shape == ReliefShape::Linear { 1 } else { 2 };
                for (part, expected) in [
                    (0.0, 12.0 * UM),
                    (0.15, 12.0 * UM * 0.5_f64.powi(linear)),
                    (0.35, 0.0),
                    (0.5, 0.0),
                    (0.65, 0.0),
                    (0.85, 20.0 * UM * 0.5_f64.powi(linear)),
                ] {
                    let found = off(flank, gear, part);
                    assert!(
                        (found - expected).abs() < 1e-12,
                        "{index} {shape:?} {part}: {found:e} {expected:e}"
                    );
                }
                consistent(flank.as_ref());
            }
        }
    }
    // A root relief must also begin on the involute.
    let start = ReliefStart::at_roll(2.0);
    let outside = Modification::RootRelief(TipRelief { depth: 5.0 * UM, start, shape: ReliefShape::Linear });
    let rack = Rack::new(MODULE, 0.35, 0.3 * MODULE).expect("a rack");
    let refused = GearBlank::standard(25, rack).modified(outside).cut().err().expect("refused");
    assert!(refused.to_string().contains("the root relief starts"), "{refused}");
}

/// Tangents are derivatives of positions, and curvatures of tangents.
fn consistent(profile: &dyn Profile) {
    let mut bounds = vec![0.0];
    bounds.extend_from_slice(profile.breaks());
    bounds.push(profile.length());
    for part in bounds.windows(2) {
        let length = part[1] - part[0];
        for k in 1..6 {
            let s = part[0] + length * f64::from(k) / 6.0;
            let h = 1e-3 * length;
            let [before, at, after] = [s - h, s, s + h].map(|s| profile.at(s));
            for axis in 0..2 {
                let tangent = (after.position[axis] - before.position[axis]) / (2.0 * h);
                assert!((tangent - at.tangent[axis]).abs() < 1e-6, "{s}");
                let bend = (after.tangent[axis] - before.tangent[axis]) / (2.0 * h);
                assert!(
                    (bend + at.curvature * at.normal[axis]).abs() < 1e-4 * at.curvature.abs().max(1.0),
                    "{s}"
                );
            }
        }
    }
}

#[test]
fn slopes_and_tables_of_the_profile() {
    let plain = [made(0, &[]), made(1, &[])];
    for index in 0..2 {
        let gear = made(index, &[Modification::ProfileSlope(8.0 * UM)]);
        for part in [0.0, 0.3, 0.9] {
            assert!((off(&gear.flanks()[0], &gear, part) + 8.0 * UM * part).abs() < 1e-14, "{index} {part}");
        }
        consistent(gear.flanks()[0].as_ref());

        let parts = [0.0, 0.2, 0.45, 0.7, 1.0];
        let mut table: Vec<(f64, f64)> = parts
            .iter()
            .map(|&part| (roll_at(&plain[index], part), UM * (3.0 * part * part - part)))
            .collect();
        table.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (rolls, depths): (Vec<f64>, Vec<f64>) = table.into_iter().unzip();
        let gear = made(index, &[Modification::profile_table(rolls, depths).expect("a table")]);
        for part in [0.2, 0.45, 0.7] {
            let found = off(&gear.flanks()[1], &gear, part);
            assert!((found - UM * (3.0 * part * part - part)).abs() < 1e-12, "{index} {part}: {found:e}");
        }
        consistent(gear.flanks()[1].as_ref());
    }
}

/// Surfaces with and without these modifications, of the external and the internal gear.
fn surfaces(index: usize, modifications: &[Modification]) -> [Arc<dyn Surface>; 4] {
    let gear = made(index, modifications);
    let options = StructureOptions::default();
    let [first, second] = gear.surfaces(&options).expect("surfaces");
    let [plain_first, plain_second] = gear.plain_surfaces(&options).expect("surfaces");
    [first, second, plain_first, plain_second]
}

/// Depth of the modified surface below the plain one at a point, along the plain normal.
fn depth(modified: &dyn Surface, plain: &dyn Surface, u: f64, v: f64) -> f64 {
    let (modified, plain) = (modified.at(u, v), plain.at(u, v));
    (0..3).map(|axis| (plain.position[axis] - modified.position[axis]) * plain.normal[axis]).sum()
}

fn well_formed(surface: &dyn Surface) {
    let [[_, length], [low, high]] = surface.range();
    let edge = surface.edge_from().expect("an edge");
    for part in [0.13, 0.52, 0.87] {
        for along in [0.1, 0.45, 0.8] {
            for u in [part * edge, edge + part * (length - edge)] {
                let v = low + along * (high - low);
                let h = 1e-7;
                let SurfacePoint { tangents, normal, .. } = surface.at(u, v);
                let difference = |du: f64, dv: f64| {
                    let [before, after] =
                        [-1.0, 1.0].map(|side| surface.at(u + side * du, v + side * dv).position);
                    [0, 1, 2].map(|axis| (after[axis] - before[axis]) / (2.0 * (du + dv)))
                };
                for (tangent, found) in tangents.into_iter().zip([difference(h, 0.0), difference(0.0, h)]) {
                    let along: f64 = tangent.iter().zip(normal).map(|(a, b)| a * b).sum();
                    assert!(along.abs() < 1e-13, "{u} {v}: {along:e}");
                    for axis in 0..3 {
                        assert!((tangent[axis] - found[axis]).abs() < 2e-6, "{u} {v}: {tangent:?} {found:?}");
                    }
                }
                let size: f64 = normal.iter().map(|part| part * part).sum();
                assert!((size - 1.0).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn the_helix_slope_leans_both_flanks_one_way_and_lead_tables_both_inwards() {
    for index in 0..2 {
        let slope = Modification::HelixSlope(10.0 * UM);
        let table =
            Modification::lead_table(vec![-0.5 * FACE, 0.0, 0.5 * FACE], vec![6.0 * UM, 0.0, 4.0 * UM]);
        let [first, second, plain_first, plain_second] = surfaces(index, &[slope]);
        let u = 0.4 * plain_first.range()[0][1];
        let at = |modified: &Arc<dyn Surface>, plain: &Arc<dyn Surface>, part: f64| {
            depth(modified.as_ref(), plain.as_ref(), u, part * FACE)
        };
        // A right-hand helix rotates counter-clockwise with z: the counter-clockwise flank has
        // excess material there.
        assert!((at(&first, &plain_first, 0.5) + 5.0 * UM).abs() < 1e-9);
        assert!((at(&second, &plain_second, 0.5) - 5.0 * UM).abs() < 1e-9);
        assert!((at(&first, &plain_first, -0.25) - 2.5 * UM).abs() < 1e-9);
        well_formed(first.as_ref());
        let [first, second, plain_first, plain_second] = surfaces(index, &[table.expect("a table")]);
        for (modified, plain) in [(&first, &plain_first), (&second, &plain_second)] {
            assert!((at(modified, plain, -0.5) - 6.0 * UM).abs() < 1e-9);
            assert!((at(modified, plain, 0.5) - 4.0 * UM).abs() < 1e-9);
            well_formed(modified.as_ref());
        }
    }
}

#[test]
fn topographies_are_met_at_their_places() {
    let plain = [made(0, &[]), made(1, &[])];
    for index in 0..2 {
        let mut rolls = [0.1, 0.5, 0.9].map(|part| roll_at(&plain[index], part));
        rolls.sort_by(f64::total_cmp);
        let places = vec![-0.5 * FACE, 0.0, 0.3 * FACE, 0.5 * FACE];
        let depths: Vec<f64> = (0..12).map(|k| UM * f64::from((7 * k) % 5)).collect();
        let topography =
            Modification::topography(rolls.to_vec(), places.clone(), depths.clone()).expect("a table");
        let [first, second, plain_first, plain_second] = surfaces(index, &[topography]);
        let sense = plain[index].form().sense();
        for (modified, plain_surface, flank) in [
            (&first, &plain_first, &plain[index].flanks()[0]),
            (&second, &plain_second, &plain[index].flanks()[1]),
        ] {
            for (row, roll) in rolls.iter().enumerate() {
                let u = flank.s_at_roll(sense * roll);
                for (column, &v) in places.iter().enumerate() {
                    let found = depth(modified.as_ref(), plain_surface.as_ref(), u, v);
                    // The tip edge of the modified profile shifts points near the tip by
                    // micrometres along the flank.
                    assert!(
                        (found - depths[4 * row + column]).abs() < 5e-9,
                        "{index} {row} {column}: {found:e}"
                    );
                }
            }
            well_formed(modified.as_ref());
        }
    }
}
