//! Internal gears: the fillet as the envelope of the shaper's corner, the geometry of flanks, and what cannot be cut.

use calyx_abi::math;
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::gear::{Gear, ToothForm};
use calyx_gears::internal::{InternalGear, InternalGearData};
use calyx_gears::sector_mesh::{Refinement, sector_mesh};
use calyx_gears::shaper::Shaper;
use calyx_runtime::profile::{Profile, ProfilePoint};
use std::f64::consts::PI;
use std::sync::Arc;

const ALPHA: f64 = 20.0 * PI / 180.0;

/// The ring of the reference pair: 60 teeth of module 4, cut by a shaper of this many teeth and tip radius (modules).
fn ring_data(cutter: u32, tip_radius: f64) -> InternalGearData {
    let module = 4e-3;
    let shaper = Shaper::new(cutter, module, ALPHA, 1.25 * module, tip_radius * module).expect("a shaper");
    InternalGearData {
        teeth: 60,
        shaper,
        tooth_thickness: shaper.thickness_of_shift(0.0),
        minor_radius: 116.8e-3,
        root_radius: 125e-3,
        tip_edge_radius: None,
    }
}

fn ring(cutter: u32, tip_radius: f64) -> InternalGear {
    InternalGear::new(ring_data(cutter, tip_radius)).expect("a sound gear")
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Tangent and curvature against central differences, well inside the smooth parts.
fn check_profile(name: &str, profile: &dyn Profile) {
    let mut bounds = vec![0.0];
    bounds.extend_from_slice(profile.breaks());
    bounds.push(profile.length());
    for part in bounds.windows(2).filter(|part| part[1] - part[0] > 1e-7) {
        let length = part[1] - part[0];
        for k in 1..10 {
            let s = part[0] + length * (0.1 + 0.08 * f64::from(k));
            let h = 1e-3 * length;
            let point = profile.at(s);
            let difference = |f: &dyn Fn(&ProfilePoint) -> [f64; 2]| {
                let [far, near] = [2.0 * h, h].map(|h| {
                    minus(f(&profile.at(s + h)), f(&profile.at(s - h))).map(|part| part / (2.0 * h))
                });
                [0, 1].map(|axis| (4.0 * near[axis] - far[axis]) / 3.0)
            };
            let tangent = difference(&|point| point.position);
            let bend = difference(&|point| point.tangent);
            for axis in 0..2 {
                assert!((tangent[axis] - point.tangent[axis]).abs() < 1e-9, "{name}: tangent at {s}");
                let expected = -point.curvature * point.normal[axis];
                assert!(
                    (bend[axis] - expected).abs() < 1e-6 * point.curvature.abs().max(10.0),
                    "{name}: curvature at {s}: {} {expected}",
                    bend[axis]
                );
            }
            let along = point.tangent[0] * point.normal[0] + point.tangent[1] * point.normal[1];
            assert!(along.abs() < 1e-14, "{name}");
        }
    }
}

#[test]
fn flanks_and_fillets_have_consistent_geometry_and_join() {
    for (cutter, tip_radius) in [(20, 0.25), (20, 0.0), (32, 0.3), (40, 0.2)] {
        let gear = ring(cutter, tip_radius);
        for side in [Side::CounterClockwise, Side::Clockwise] {
            let flank = Flank::new(&gear, &[], side).expect("a flank");
            let fillet = gear.root_fillet(side);
            check_profile("flank", &flank);
            if tip_radius > 0.0 {
                check_profile("fillet", &fillet);
            }
            let (a, b) = (flank.at(0.0), fillet.at(0.0));
            for axis in 0..2 {
                assert!((a.position[axis] - b.position[axis]).abs() < 1e-15, "{cutter}");
                assert!((a.normal[axis] - b.normal[axis]).abs() < 1e-12, "{cutter}");
                // The fillet runs to the root, the flank to the tip.
                assert!((a.tangent[axis] + b.tangent[axis]).abs() < 1e-12, "{cutter}");
            }
            // It ends in the middle of the space on the root circle, the flank on the minor circle.
            let end = fillet.at(fillet.length()).position;
            let middle = if side == Side::CounterClockwise { PI / 60.0 } else { -PI / 60.0 };
            assert!((end[0].hypot(end[1]) - gear.root_radius).abs() < 1e-15);
            assert!((end[1].atan2(end[0]) - middle).abs() < 1e-14);
            let tip = flank.at(flank.length()).position;
            assert!((tip[0].hypot(tip[1]) - gear.minor_radius).abs() < 1e-15);
            assert!(tip[1] * middle > 0.0, "the tip's edge does not cross the centreline");
        }
    }
}

#[test]
fn the_space_is_the_envelope_of_the_cutter() {
    let gear = ring(25, 0.2);
    let shaper = gear.shaper;
    let fillet = gear.root_fillet(Side::CounterClockwise);
    let ratio = f64::from(shaper.teeth) / 60.0;
    // The cutter's corner, its centre in the cutter's coordinates: on the offset of its involute by the rounding.
    let base = shaper.base_radius();
    let centre_radius = shaper.outer_radius() - shaper.tip_radius;
    let tangent = (centre_radius * centre_radius - base * base).sqrt();
    let thickness_angle = gear.cutter_thickness / (2.0 * shaper.reference_radius());
    let half_base = thickness_angle + ALPHA.tan() - ALPHA;
    let centre_angle = half_base - (tangent + shaper.tip_radius) / base + (tangent / base).atan();
    // In tooth coordinates of the ring the space that the cutter's tooth cuts has its middle at half a pitch; the clockwise corner of the
    // cutter's tooth faces this tooth.
    let centre_at = |turn: f64| {
        let middle = PI / 60.0;
        let axis = middle - turn * ratio;
        let corner = axis + turn - centre_angle;
        [
            gear.cutting_distance * axis.cos() + centre_radius * corner.cos(),
            gear.cutting_distance * axis.sin() + centre_radius * corner.sin(),
        ]
    };
    for k in 0..=20 {
        let s = fillet.fillet_length() * f64::from(k) / 20.0;
        let point = fillet.at(s).position;
        // No position of the corner reaches beyond the fillet, and one touches it.
        let nearest = (-4000..=4000)
            .map(|step| {
                let [x, y] = minus(point, centre_at(f64::from(step) * 2e-4));
                x.hypot(y)
            })
            .fold(f64::INFINITY, f64::min);
        assert!((nearest - shaper.tip_radius).abs() < 2e-9, "at {s}: {nearest}");
    }
}

#[test]
fn thickness_and_rolls_are_those_of_the_tooth_form() {
    let gear = ring(25, 0.2);
    let form = ToothForm::from(&gear);
    for radius in [117e-3, 120e-3, 123e-3] {
        assert!((form.thickness_at(radius) - gear.thickness_at(radius)).abs() < 1e-16);
        assert!((form.radius_at_roll(form.roll_at_radius(radius)) - radius).abs() < 1e-15);
    }
    let flank = Flank::new(form, &[], Side::CounterClockwise).expect("a flank");
    for k in 0..=10 {
        let s = 0.1 * f64::from(k) * flank.edge_range()[0];
        let [x, y] = flank.at(s).position;
        let half = math::atan2(y, x);
        let radius = x.hypot(y);
        assert!((2.0 * radius * half - gear.thickness_at(radius)).abs() < 1e-15, "{s}");
        assert!((flank.s_at_roll(flank.roll_at(s)) - s).abs() < 1e-15, "{s}");
    }
}

#[test]
fn sectors_of_rings_are_meshed() {
    for (cutter, tip_radius, module_rim) in [(20, 0.25, 2.0), (32, 0.3, 1.0), (40, 0.2, 4.0)] {
        let gear = ring(cutter, tip_radius);
        let flanks = [Side::CounterClockwise, Side::Clockwise]
            .map(|side| Arc::new(Flank::new(&gear, &[], side).expect("a flank")));
        let outside = gear.root_radius + module_rim * gear.shaper.module;
        for refinement in [Refinement::COARSE, Refinement::MEDIUM] {
            let mesh =
                sector_mesh(&Gear::from(gear.clone()), flanks.clone(), outside, &refinement).expect("a mesh");
            for chain in [
                "flank_0",
                "flank_1",
                "fillet_0",
                "fillet_1",
                "edge_0",
                "edge_1",
                "tip",
                "bore",
                "cut_left",
                "cut_right",
            ] {
                assert!(mesh.chain(chain).is_some(), "{chain}");
            }
            let cuts = ["cut_left", "cut_right"]
                .map(|name| mesh.chain_nodes(mesh.chain(name).expect("a cut")).len());
            assert_eq!(cuts[0], cuts[1]);
        }
    }
}

#[test]
fn rings_that_cannot_be_cut_are_refused() {
    let refused = |data: InternalGearData| {
        let errors = InternalGear::new(data).expect_err("refused");
        errors.iter().map(|error| (error.code, error.argument)).collect::<Vec<_>>()
    };
    let sound = ring_data(25, 0.2);
    let module = sound.shaper.module;
    let with = |change: &dyn Fn(&mut InternalGearData)| {
        let mut data = sound;
        change(&mut data);
        refused(data)
    };
    assert_eq!(with(&|data| data.shaper.teeth = 60), [("E0624", "shaper")]);
    assert_eq!(with(&|data| data.shaper.teeth = 57), [("E0629", "shaper")]);
    assert_eq!(with(&|data| data.shaper.addendum = 3.5 * module), [("E0625", "shaper")]);
    assert_eq!(with(&|data| data.shaper.tip_radius = 0.6 * module), [("E0626", "shaper")]);
    assert_eq!(with(&|data| data.tooth_thickness = 2.2 * module), [("E0627", "shaper")]);
    assert_eq!(with(&|data| data.minor_radius = 112e-3), [("E0618", "minor_diameter")]);
    assert_eq!(with(&|data| data.minor_radius = 113e-3)[0], ("E0628", "minor_diameter"));
    assert_eq!(with(&|data| data.root_radius = 118e-3), [("E0619", "root_diameter")]);
    assert_eq!(with(&|data| data.tooth_thickness = 0.3 * module), [("E0616", "minor_diameter")]);
    assert_eq!(with(&|data| data.tip_edge_radius = Some(1.0 * module)), [("E0617", "tip_edge_radius")]);
    // Near the limit of rolling, feeding straight in already trims.
    let trimmed =
        InternalGear::new(InternalGearData { shaper: Shaper { teeth: 46, ..sound.shaper }, ..sound });
    let warnings = trimmed.expect("a gear").warnings;
    assert_eq!(warnings.iter().map(|warning| warning.code).collect::<Vec<_>>(), ["E0629"]);
    assert!(InternalGear::new(sound).expect("a gear").warnings.is_empty());
}
