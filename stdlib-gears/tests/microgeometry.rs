//! Modifications in the usual terms: equivalent statements of a relief, mirror images, consistent
//! derivatives, and the transmission error of rigid modified flanks.

use crate::common::pair::{COARSE, MESH, Member, PLAIN, PairOptions, pair};
use crate::common::{INCH, built, chapter_5};
use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::gear_surface::GearSurface;
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::modification::{
    EndRelief, FaceEnds, Modification, ReliefShape, ReliefStart, TipRelief, ToothFlank,
};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use calyx_runtime::observables::{Observe, TransmissionError};
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::{Fidelity, StructureOptions};
use calyx_runtime::structure::BoreSupport;
use calyx_runtime::surface::Surface;
use std::sync::Arc;

const MODULE: f64 = 4e-3;
const FACE: f64 = 40e-3;
const UM: f64 = 1e-6;
const SHAPES: [ReliefShape; 5] = [
    ReliefShape::Linear,
    ReliefShape::Quadratic,
    ReliefShape::Arc,
    ReliefShape::Progressive(1.5),
    ReliefShape::Progressive(3.5),
];

fn external(hand: Hand, helix: f64, modifications: &[Modification]) -> Arc<GearPrototype> {
    let rack = Rack::new(MODULE, 20.0_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    let mut blank = GearBlank::standard(25, rack).face_width(FACE);
    blank.helix = Helix::new(helix, hand).expect("a helix");
    blank.modifications = modifications.to_vec();
    blank.cut().expect("a gear")
}

fn internal(hand: Hand, helix: f64, modifications: &[Modification]) -> Arc<GearPrototype> {
    let shaper =
        Shaper::new(25, MODULE, 20.0_f64.to_radians(), 1.25 * MODULE, 0.2 * MODULE).expect("a shaper");
    let mut blank = GearBlank::standard(60, shaper);
    blank.face_width = FACE;
    blank.helix = Helix::new(helix, hand).expect("a helix");
    blank.modifications = modifications.to_vec();
    blank.cut().expect("a ring")
}

#[test]
fn all_statements_of_a_start_give_the_same_relief() {
    for gear in [external(Hand::Right, 0.0, &[]), internal(Hand::Right, 0.0, &[])] {
        let form = gear.form();
        let roll_at = |part: f64| form.form_roll + part * (form.tip_roll - form.form_roll);
        for (at_root, part) in [(false, 0.62), (true, 0.41)] {
            let start = roll_at(part);
            let end = if at_root { form.form_roll } else { form.tip_roll };
            let empty = ReliefStart::default();
            let statements = [
                ReliefStart { roll_angle: Some(start.abs()), ..empty },
                ReliefStart { roll_length: Some(form.base_radius * start.abs()), ..empty },
                ReliefStart { diameter: Some(2.0 * form.base_radius * start.hypot(1.0)), ..empty },
                ReliefStart { length: Some(form.base_radius * (end - start).abs()), ..empty },
            ];
            for shape in SHAPES {
                let flanks = statements.map(|start| {
                    let relief = TipRelief { depth: 20.0 * UM, start, shape };
                    let relief = match at_root {
                        true => Modification::RootRelief(relief),
                        false => Modification::TipRelief(relief),
                    };
                    Flank::new(form, &[relief], Side::Clockwise).expect("a flank")
                });
                for step in 0..=40 {
                    let roll = roll_at(f64::from(step) / 40.0);
                    let [first, others @ ..] = flanks.each_ref().map(|flank| flank.amount_at(roll));
                    for other in others {
                        assert!(
                            (other - first).abs() <= 1e-12 * 20.0 * UM,
                            "{shape:?} {roll}: {first} {other}"
                        );
                    }
                }
                assert!((flanks[3].amount_at(end) - 20.0 * UM).abs() < 1e-18, "{shape:?}");
            }
        }
    }
}

#[test]
fn statements_of_a_start_have_to_agree() {
    let gear = external(Hand::Right, 0.0, &[]);
    let form = gear.form();
    let relief = |start| {
        let relief = TipRelief { depth: 20.0 * UM, start, shape: ReliefShape::Linear };
        Flank::new(form, &[relief.into()], Side::Clockwise).map(|_| ()).map_err(|errors| errors[0].clone())
    };
    let diameter = 2.0 * form.base_radius * 0.5_f64.hypot(1.0);
    let both = |off: f64| ReliefStart {
        roll_angle: Some(0.5),
        diameter: Some(diameter + off),
        ..ReliefStart::default()
    };
    // Drawings round diameters to hundredths of a millimetre.
    assert_eq!(relief(both(0.005e-3)), Ok(()));
    let error = relief(both(0.1e-3)).expect_err("a contradiction");
    assert_eq!(error.code, "E0936");
    let message = error.message.to_string();
    assert!(message.contains("`start_roll_angle` = 28.648 deg is a roll angle of 28.648 deg"), "{message}");
    assert!(message.contains("but `start_diameter` = 105.16 mm is a roll angle of 28.784 deg"), "{message}");
    assert_eq!(relief(ReliefStart::default()).expect_err("no start").code, "E0935");
}

/// Tangents are derivatives of positions, and curvatures of tangents.
fn consistent(profile: &dyn Profile, name: &str) {
    let mut bounds = vec![0.0];
    bounds.extend_from_slice(profile.breaks());
    bounds.push(profile.length());
    for part in bounds.windows(2) {
        let length = part[1] - part[0];
        for k in 1..6 {
            let s = part[0] + length * f64::from(k) / 6.0;
            // The relief of exponent 3.5 has a third derivative of up to 1e5 / m^2.
            let h = 1e-4 * length;
            let [before, at, after] = [s - h, s, s + h].map(|s| profile.at(s));
            for axis in 0..2 {
                let tangent = (after.position[axis] - before.position[axis]) / (2.0 * h);
                assert!((tangent - at.tangent[axis]).abs() < 1e-6, "{name} at {s}");
                let bend = (after.tangent[axis] - before.tangent[axis]) / (2.0 * h);
                let expected = -at.curvature * at.normal[axis];
                let allowed = 1e-4 * at.curvature.abs().max(1.0);
                assert!((bend - expected).abs() < allowed, "{name} at {s}: {bend} {expected}");
            }
        }
    }
}

#[test]
fn every_shape_has_consistent_derivatives() {
    for gear in [external(Hand::Right, 0.0, &[]), internal(Hand::Right, 0.0, &[])] {
        let form = gear.form();
        let start = ReliefStart { length: Some(0.4 * MODULE), ..ReliefStart::default() };
        for shape in SHAPES {
            let relief = TipRelief { depth: 20.0 * UM, start, shape };
            for modification in [Modification::TipRelief(relief), Modification::RootRelief(relief)] {
                let name = format!("{modification:?}");
                consistent(
                    &Flank::new(form, &[modification], Side::CounterClockwise).expect("a flank"),
                    &name,
                );
            }
        }
        let crown = Modification::ProfileCrown(20.0 * UM);
        consistent(&Flank::new(form, &[crown], Side::Clockwise).expect("a flank"), "crown");
    }
}

fn surfaces(gear: &GearPrototype) -> [Arc<GearSurface>; 2] {
    gear.surfaces(&StructureOptions::default()).expect("surfaces")
}

/// Modifications that depend on both coordinates; the second list is its mirror image in a plane
/// that contains the axis.
fn mirrored_lists() -> [Vec<Modification>; 2] {
    let relief = |depth: f64, shape| {
        let start = ReliefStart { length: Some(0.5 * MODULE), ..ReliefStart::default() };
        TipRelief { depth, start, shape }
    };
    let end = |ends, depth| {
        Modification::EndRelief(EndRelief { depth, length: 8e-3, shape: ReliefShape::Progressive(1.5), ends })
    };
    let list = |flank, other, helix: f64| {
        vec![
            Modification::TipRelief(relief(15.0 * UM, ReliefShape::Arc)).on(flank),
            Modification::RootRelief(relief(9.0 * UM, ReliefShape::Progressive(3.0))).on(other),
            Modification::ProfileCrown(4.0 * UM),
            Modification::ProfileSlope(6.0 * UM).on(other),
            Modification::HelixSlope(helix * 7.0 * UM),
            Modification::HelixSlope(helix * 3.0 * UM).on(flank),
            Modification::Twist(8.0 * UM).on(other),
            end(FaceEnds::Positive, 5.0 * UM),
            end(FaceEnds::Both, 3.0 * UM).on(other),
        ]
    };
    [list(ToothFlank::Left, ToothFlank::Right, 1.0), list(ToothFlank::Right, ToothFlank::Left, -1.0)]
}

#[test]
fn mirrored_modifications_give_mirrored_flanks() {
    let [first, second] = mirrored_lists();
    let helix = 12.0_f64.to_radians();
    for made in [external, internal] {
        // The internal gear is cut by a spur shaper.
        let helix = if made(Hand::Right, 0.0, &[]).form().internal { 0.0 } else { helix };
        let gears = [made(Hand::Right, helix, &first), made(Hand::Left, helix, &second)];
        let [one, other] = gears.each_ref().map(|gear| surfaces(gear));
        for side in 0..2 {
            let (one, other) = (&one[side], &other[1 - side]);
            let [[_, length], [low, high]] = one.range();
            for (part, along) in [(0.1, 0.05), (0.35, 0.5), (0.6, 0.93), (0.95, 0.2)] {
                let (u, v) = (part * length, low + along * (high - low));
                let (a, b) = (one.at(u, v), other.at(u, v));
                for (axis, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
                    assert!(
                        (a.position[axis] - sign * b.position[axis]).abs() < 1e-15,
                        "{side} {part} {along}"
                    );
                    assert!((a.normal[axis] - sign * b.normal[axis]).abs() < 1e-12, "{side} {part} {along}");
                }
            }
        }
    }
}

#[test]
fn amounts_are_those_of_the_surfaces() {
    let [list, _] = mirrored_lists();
    for gear in [external(Hand::Left, 0.2, &list), internal(Hand::Right, 0.0, &list)] {
        let plain = gear.plain_surfaces(&StructureOptions::default()).expect("surfaces");
        for (modified, plain) in surfaces(&gear).iter().zip(&plain) {
            for (roll_part, along) in [(0.1, 0.04), (0.4, 0.5), (0.6, 0.97), (0.7, 0.3)] {
                let form = gear.form();
                let roll = form.form_roll + roll_part * (form.tip_roll - form.form_roll);
                let u = Flank::new(form, &[], Side::Clockwise).expect("a flank").s_at_roll(roll);
                let v = (along - 0.5) * FACE;
                let (at, on_plain) = (modified.at(u, v), plain.at(u, v));
                // The amount is measured in the transverse section.
                let [x, y, z] = on_plain.normal;
                let section = (1.0 - z * z).sqrt();
                let difference: Vec<f64> =
                    (0..3).map(|axis| on_plain.position[axis] - at.position[axis]).collect();
                let depth = (difference[0] * x + difference[1] * y) / section;
                let amount = modified.amount_at(roll, v);
                assert!((depth - amount).abs() < 3e-8, "{roll_part} {along}: {depth:e} {amount:e}");
            }
        }
    }
}

/// Unloaded transmission error along the line of action at fractions of the mesh cycle, and the
/// amounts on the pinion that determine it.
fn rigid_errors(modification: Modification) -> Vec<[f64; 2]> {
    let rim = Rim { radius: 0.7 * INCH, fixed_radius: 0.6 * INCH, web: None, support: BoreSupport::Rigid };
    let pinion = GearPrototype::new(
        chapter_5(20),
        vec![modification],
        crate::common::pair::steel(),
        rim,
        INCH,
        Vec::new(),
    );
    let gears = [Member::new(pinion.expect("a gear")), PLAIN[1].clone()];
    let options = PairOptions::chapter_5(&gears);
    let geometry =
        MeshGeometry::external(gears[0].gear(), gears[1].gear(), options.center_distance).expect("they mesh");
    let (scene, mesh) = pair(&options);
    let system = built(&scene, Fidelity::Rigid, COARSE);
    let form = gears[0].form();
    let flank = gears[0].prototype.flanks()[Side::CounterClockwise.surface() as usize].clone();
    let active = geometry.first_roll;
    let mut errors = Vec::new();
    for step in 0..40 {
        let time = mesh.start + (f64::from(step) + 0.3) / 40.0 * mesh.period;
        let touching = system.touch(time).expect("contact");
        let error = system.value(&touching, &TransmissionError(MESH)).value;
        // The pinion rotates counter-clockwise and pushes with its counter-clockwise flanks. These
        // touch the line of action at the roll angle `rotation + half angle + pressure angle`.
        let rotation = options.start + options.speed * time;
        let roll = rotation + form.half_base_angle + geometry.operating_pressure_angle;
        let amounts = (-25..=25)
            .map(|tooth| roll + f64::from(tooth) * form.pitch_angle())
            .filter(|roll| (active.start_of_active_profile..active.end_of_active_profile).contains(roll))
            .map(|roll| flank.amount_at(roll));
        let smallest = amounts.fold(f64::INFINITY, f64::min);
        errors.push([error * gears[1].form().base_radius, smallest]);
    }
    errors
}

#[test]
fn the_unloaded_transmission_error_is_the_modification_along_the_path_of_contact() {
    // Long reliefs, which extend into single-pair contact; elsewhere the other pair touches.
    let length = ReliefStart { length: Some(0.3 * INCH), ..ReliefStart::default() };
    // The shift of the contact point along the flank changes the error by the square of the amount.
    let depth = 0.05 * UM;
    let relief = |shape| Modification::TipRelief(TipRelief { depth, start: length, shape });
    let cases = [
        Modification::ProfileCrown(depth),
        Modification::ProfileSlope(-depth),
        Modification::ProfileSlope(depth),
        relief(ReliefShape::Quadratic),
        relief(ReliefShape::Arc),
        relief(ReliefShape::Progressive(3.0)),
    ];
    for modification in cases {
        let errors = rigid_errors(modification.clone());
        let largest = errors.iter().map(|[_, amount]| amount.abs()).fold(0.0, f64::max);
        assert!(largest > 0.05 * depth, "{modification:?}");
        for [error, amount] in errors {
            assert!((error - amount).abs() < 1e-3 * depth, "{modification:?}: {error:e} {amount:e}");
        }
    }
}

#[test]
fn a_modification_of_one_flank_leaves_the_other_one_unchanged() {
    for (gear, left) in
        [(external as fn(_, _, &[_]) -> _, Side::CounterClockwise), (internal, Side::Clockwise)]
    {
        let gear = gear(Hand::Right, 0.0, &[Modification::ProfileCrown(5.0 * UM).on(ToothFlank::Left)]);
        let [modified, plain] =
            [left.surface(), 1 - left.surface()].map(|side| &gear.flanks()[side as usize]);
        assert!(modified.is_modified() && !plain.is_modified());
    }
    // The other flank transmits without error.
    for [error, amount] in rigid_errors(Modification::ProfileCrown(UM).on(ToothFlank::Right)) {
        assert!(error.abs() < 1e-15 && amount == 0.0, "{error:e}");
    }
}
