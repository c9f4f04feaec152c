//! Three-dimensional flanks: derivatives and normals of modified, twisted surfaces, and the contact
//! of two of them.

use crate::common::{INCH, chapter_5};
use calyx_gears::external::ExternalGear;
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::gear_surface::GearSurface;
use calyx_gears::modification::{LeadModification, Modification, ReliefShape};
use calyx_runtime::surface::Surface;
use std::sync::Arc;

const FACE: f64 = INCH;

fn flank(gear: &ExternalGear, modifications: &[Modification], side: Side) -> Arc<Flank> {
    Arc::new(Flank::new(gear, modifications, side).expect("a flank"))
}

fn surface(
    gear: &ExternalGear,
    modifications: &[Modification],
    side: Side,
    twist: f64,
    crown: f64,
) -> GearSurface {
    let (plain, modified) = (flank(gear, &[], side), flank(gear, modifications, side));
    GearSurface::new(plain, modified, FACE, twist, LeadModification { crown, ..LeadModification::default() })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn size(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

#[test]
fn tangents_are_derivatives_and_the_normal_stands_on_them() {
    let gear = chapter_5(20);
    let relief = Modification::tip_relief(0.0005 * INCH, 27.25_f64.to_radians(), ReliefShape::Quadratic);
    for side in [Side::CounterClockwise, Side::Clockwise] {
        for (modifications, crown) in [(vec![], 0.0), (vec![relief.clone()], 0.0005 * INCH)] {
            let surface = surface(&gear, &modifications, side, 14.0, crown);
            let [[_, end], _] = surface.range();
            let edge = surface.edge_from().expect("a tip edge");
            // Within a step of a break, finite differences straddle it.
            for u in [-2e-5, 1e-5, 0.3 * edge, 0.6 * edge, 0.8 * edge, 0.99 * edge, 0.5 * (edge + end)] {
                for v in [-0.6 * FACE, -0.2 * FACE, 0.0, 0.45 * FACE] {
                    let point = surface.at(u, v);
                    let step = 1e-7;
                    let steps = [[step, 0.0], [0.0, step]];
                    for (tangent, [du, dv]) in point.tangents.into_iter().zip(steps) {
                        let ahead = surface.at(u + du, v + dv).position;
                        let behind = surface.at(u - du, v - dv).position;
                        let difference = minus(ahead, behind).map(|part| part / (2.0 * step));
                        let miss = size(minus(tangent, difference));
                        assert!(miss < 1e-6 * size(tangent).max(0.1), "{u} {v}: {tangent:?} {difference:?}");
                        assert!(dot(point.normal, tangent).abs() < 1e-14);
                    }
                    assert!((size(point.normal) - 1.0).abs() < 1e-14);
                }
            }
            // Normals are continuous where the flank meets its tip edge, although curvature is not.
            let [below, above] = [edge - 1e-12, edge + 1e-12].map(|u| surface.at(u, 0.3 * FACE));
            assert!(size(minus(below.normal, above.normal)) < 1e-6);
            assert!(size(minus(below.position, above.position)) < 1e-11);
        }
    }
}

#[test]
fn material_is_taken_off_by_the_amounts_of_relief_and_crown() {
    let gear = chapter_5(20);
    let (depth, start, crown) = (0.0005 * INCH, 27.25_f64.to_radians(), 0.0003 * INCH);
    let relief = [Modification::tip_relief(depth, start, ReliefShape::Quadratic)];
    for side in [Side::CounterClockwise, Side::Clockwise] {
        let (plain, modified) =
            (surface(&gear, &[], side, 0.0, 0.0), surface(&gear, &relief, side, 0.0, crown));
        let profile = flank(&gear, &[], side);
        for roll in [0.2, 0.4, 0.5, 0.55] {
            for v in [0.0, 0.25 * FACE, -0.5 * FACE] {
                let at = profile.s_at_roll(roll);
                let here = plain.at(at, v);
                let taken = -dot(minus(modified.at(at, v).position, here.position), here.normal);
                let part = (roll - start).max(0.0) / (gear.tip_roll - start);
                let expected = depth * part * part + crown * (2.0 * v / FACE).powi(2);
                assert!((taken - expected).abs() < 5e-3 * depth, "{roll} {v}: {taken:e} {expected:e}");
            }
        }
    }
}

#[test]
fn the_normal_of_a_plain_helicoid_does_not_change_along_its_generators() {
    // Sections rotate by the twist. If the roll angle increases by the same angle, the direction of
    // the normal in the section is constant.
    let gear = chapter_5(40);
    let twist = 9.0;
    let surface = surface(&gear, &[], Side::CounterClockwise, twist, 0.0);
    let profile = flank(&gear, &[], Side::CounterClockwise);
    let points: Vec<_> = (-4..=4)
        .map(|step| {
            let v = 0.1 * FACE * f64::from(step);
            surface.at(profile.s_at_roll(gear.roll_at_radius(gear.pitch_radius) + twist * v), v)
        })
        .collect();
    let straight = minus(points[8].position, points[0].position);
    for point in &points {
        assert!(size(minus(point.normal, points[0].normal)) < 1e-14);
        let away = minus(point.position, points[0].position);
        let along = dot(away, straight) / dot(straight, straight);
        assert!(size(minus(away, straight.map(|part| along * part))) < 1e-16 + 1e-14 * FACE);
        assert!(dot(away, point.normal).abs() < 1e-16);
    }
}

#[test]
fn aligned_helical_flanks_touch_along_a_straight_line() {
    let gears = [chapter_5(20), chapter_5(40)];
    let [base, other_base] = [0, 1].map(|k: usize| gears[k].base_radius);
    let distance = 3.02 * INCH;
    // Twists of opposite hands with one helix angle on the base cylinders.
    let lean = 0.2;
    let twists = [lean / base, -lean / other_base];
    let surfaces = [0, 1].map(|k: usize| surface(&gears[k], &[], Side::CounterClockwise, twists[k], 0.0));
    let profiles = [0, 1].map(|k: usize| flank(&gears[k], &[], Side::CounterClockwise));
    let pressure_angle = ((base + other_base) / distance).acos();
    let rolls_at = |v: f64| {
        let first = 0.38 + twists[0] * v;
        [first, (distance * pressure_angle.sin() - base * first) / other_base]
    };
    // Rotations that align the normals at mid-face with the line of action.
    let turn = |k: usize, direction: f64| direction - gears[k].half_base_angle + rolls_at(0.0)[k];
    let turns = [turn(0, -pressure_angle), turn(1, std::f64::consts::PI - pressure_angle)];
    let placed = |k: usize, [x, y, z]: [f64; 3], shift: f64| {
        let (sine, cosine) = turns[k].sin_cos();
        [cosine * x - sine * y + shift, sine * x + cosine * y, z]
    };
    let mut line = Vec::new();
    for step in -5..=5 {
        let v = 0.04 * FACE * f64::from(step);
        let at = |k: usize| surfaces[k].at(profiles[k].s_at_roll(rolls_at(v)[k]), v);
        let (first, second) = (at(0), at(1));
        let gap = minus(placed(0, first.position, 0.0), placed(1, second.position, distance));
        assert!(size(gap) < 1e-15, "{v}: {gap:?}");
        let normals = [placed(0, first.normal, 0.0), placed(1, second.normal, 0.0)];
        assert!((dot(normals[0], normals[1]) + 1.0).abs() < 1e-14);
        line.push(placed(0, first.position, 0.0));
    }
    let straight = minus(line[10], line[0]);
    for point in &line {
        let away = minus(*point, line[0]);
        let along = dot(away, straight) / dot(straight, straight);
        assert!(size(minus(away, straight.map(|part| along * part))) < 1e-15);
    }
}
