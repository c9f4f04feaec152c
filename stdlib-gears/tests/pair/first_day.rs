//! Basic outputs of a pair, compared with closed forms and with each other.

use super::CYCLE;
use crate::common::INCH;
use crate::common::pair::{FIRST, MESH, PLAIN, PSI, PairOptions, RELIEVED, SECOND, TORQUE, pair, system};
use calyx_gears::gauge_externs::{FilletLocation, GaugePlacement};
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    Coordinate, Displacement, Efficiency, FaceLoadFactor, FilletSide, FrictionLoss, Gauge, GaugeReading,
    HighestContact, LoadedFace, LowestContact, MaxLineLoad, MaxRootCompression, MaxRootStress,
    MaxSlidingVelocity, Maximum, MaximumLocation, Observable, PairLoad, PairsInContact, Reading, Rotation,
    SecantStiffness, SlidingVelocity, SupportForce, SupportMoment, ToothLoad, TransmissionError,
    UnloadedTransmissionError,
};
use calyx_runtime::results::Observed;
use calyx_runtime::scene::{BodyId, GearMesh};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// The chapter 5 pair at fractions of its mesh cycle.
fn at_each(
    options: &PairOptions,
    mut test: impl FnMut(&MeshGeometry, &GearMesh, f64, &dyn Fn(&dyn Observable) -> Observed),
) {
    let [first, second] = options.gears.each_ref().map(|member| member.gear());
    let geometry = MeshGeometry::external(first, second, options.center_distance).expect("they mesh");
    let (scene, mesh) = pair(options);
    let system: System<'_> = system(&scene);
    for cycle in CYCLE {
        let step: StepResult = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
        test(&geometry, &mesh, cycle, &|observable| system.value(&step, observable));
    }
}

/// Gauge along the profile of the chapter 5 pair without modifications.
fn gauge(body: BodyId, radius: f64, side: FilletSide) -> Gauge {
    let placing =
        GaugePlacement { along: FilletLocation::Radius(radius), axial: 0.0, direction: 0.0, length: 0.0 };
    let gear = &PLAIN[body.0].prototype;
    let place = placing.on(gear).expect("a place in the fillet");
    Gauge { body, place, direction: 0.0, length: 0.0, side, tooth: None, material: gear.material }
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
}

#[test]
fn loads_of_pairs_and_teeth_add_up_to_that_of_the_mesh() {
    for speed in [0.3, -0.3] {
        at_each(&PairOptions { speed, ..PairOptions::chapter_5(&PLAIN) }, |_, mesh, cycle, value| {
            let of_mesh = TORQUE / mesh.base_radii[0];
            let pairs: Vec<f64> = (-2..=2).map(|pair| value(&PairLoad(MESH, pair)).value).collect();
            assert!(close(pairs.iter().sum(), of_mesh, 1e-9), "cycle {cycle}: {pairs:?}");
            // Two pairs up to 0.49 of the cycle and one from there on: the pair that enters at its
            // start and the preceding one.
            assert!(pairs[2] > 0.0 && (pairs[1] > 0.0) == (cycle < 0.49), "cycle {cycle}: {pairs:?}");
            assert_eq!(value(&PairsInContact(MESH)).value, if cycle < 0.49 { 2.0 } else { 1.0 });
            for (body, side) in [(FIRST, 0), (SECOND, 1)] {
                let tooth = mesh.entering[side];
                assert_eq!(value(&ToothLoad(body, tooth)).value, pairs[2]);
            }
            // A plane model distributes the load uniformly over the face width of an inch.
            let largest = pairs.iter().copied().fold(0.0, f64::max);
            assert!(close(value(&MaxLineLoad(MESH)).value, largest / 0.0254, 1e-12));
            assert_eq!(value(&FaceLoadFactor(MESH)).value, 1.0);
            assert_eq!(value(&LoadedFace(MESH)).value, 1.0);
        });
    }
}

#[test]
fn what_holds_the_gears_leans_over_by_the_operating_pressure_angle() {
    at_each(&PairOptions::chapter_5(&PLAIN), |geometry, _, cycle, value| {
        let [x, y, z] = [0, 1, 2].map(|axis| value(&SupportForce(FIRST, axis)).value);
        // The line of centres lies along x; the pinion pushes counter-clockwise, and the reaction
        // pushes it back and away.
        assert!(close(x / y, geometry.operating_pressure_angle.tan(), 1e-9), "cycle {cycle}: {x} {y}");
        assert_eq!(z, 0.0);
        let on_second = [0, 1, 2].map(|axis| value(&SupportForce(SECOND, axis)).value);
        assert!(close(on_second[0], -x, 1e-12) && close(on_second[1], -y, 1e-12));
        assert!(close(y.abs(), TORQUE / (0.0254 * 1.0), 1e-9), "{y}");
        // The pinion is free to rotate, the gear is fixed.
        assert!(value(&SupportMoment(FIRST, 2)).value.abs() < 1e-9 * TORQUE);
        assert!(close(value(&SupportMoment(SECOND, 2)).value.abs(), 2.0 * TORQUE, 1e-9));
        assert_eq!(value(&Displacement(FIRST, 0)).value, 0.0);
        assert_eq!(value(&Rotation(SECOND, 2)).value, 0.0);
        let turned = value(&Rotation(FIRST, 2)).value;
        assert!(close(0.5 * turned, value(&TransmissionError(MESH)).value, 1e-9), "{turned}");
    });
}

#[test]
fn flanks_slide_by_the_sum_of_the_speeds_times_the_distance_from_the_pitch_point() {
    for (speed, moment) in [(2.0, TORQUE), (-2.0, TORQUE), (-2.0, -TORQUE)] {
        at_each(
            &PairOptions { speed, moment, ..PairOptions::chapter_5(&PLAIN) },
            |geometry, mesh, cycle, value| {
                let sum = speed.abs() * 1.5;
                let pitch_point = geometry.first_roll.pitch_point;
                // The entered pair is at the roll angle of the position; the preceding ones are
                // whole pitches ahead.
                let roll = mesh.roll[0] + cycle * (mesh.roll[1] - mesh.roll[0]);
                // Contact moves from root to tip where the gear moves in the direction of its push.
                let forward = if speed * moment > 0.0 { 1.0 } else { -1.0 };
                let expected = |roll: f64| forward * sum * geometry.base_radius[0] * (roll - pitch_point);
                let found = value(&SlidingVelocity(MESH, 0)).value;
                assert!(close(found, expected(roll), 1e-6), "cycle {cycle}: {found} {}", expected(roll));
                let before = roll + (mesh.roll[1] - mesh.roll[0]);
                let found = value(&SlidingVelocity(MESH, -1)).value;
                assert!(
                    if cycle < 0.49 { close(found, expected(before), 1e-6) } else { found == 0.0 },
                    "{found}"
                );
                let fastest = value(&MaxSlidingVelocity(MESH)).value;
                assert!(close(fastest, found.abs().max(expected(roll).abs()), 1e-6));
                // Loss: force times sliding velocity summed over both pairs, and the remaining
                // fraction of the power.
                let loads = [0, -1].map(|pair| value(&PairLoad(MESH, pair)).value);
                let loss = 0.05 * (loads[0] * expected(roll).abs() + loads[1] * expected(before).abs());
                assert!(close(value(&FrictionLoss(MESH, 0.05)).value, loss, 1e-6));
                let left = 1.0 - loss / (TORQUE * speed.abs());
                assert!(close(value(&Efficiency(MESH, 0.05)).value, left, 1e-9), "cycle {cycle}");
            },
        );
    }
}

/// Ohlendorf's degree of loss assumes two pairs that carry half the load each. Elastic teeth share
/// it differently: a pair at the ends of its path, where flanks slide fastest, carries less.
#[test]
fn the_loss_over_a_cycle_is_near_the_classical_degree_of_loss() {
    let options = PairOptions::chapter_5(&PLAIN);
    let (scene, mesh) = pair(&options);
    let system = system(&scene);
    let positions = mesh_cycle(&mesh, 16);
    let [first, second] = options.gears.each_ref().map(|member| member.gear());
    let geometry = MeshGeometry::external(first, second, options.center_distance).expect("they mesh");
    let (mut found, mut halves, mut weight) = (0.0, 0.0, 0.0);
    let part =
        |roll: f64| geometry.base_radius[0] * (roll - geometry.first_roll.pitch_point) / geometry.base_pitch;
    for (index, position) in positions.iter().enumerate() {
        let before =
            index.checked_sub(1).map_or(positions[positions.len() - 1].cycle - 1.0, |at| positions[at].cycle);
        let after = positions.get(index + 1).map_or(1.0 + positions[0].cycle, |next| next.cycle);
        let step = system.solve(position.time).expect("equilibrium");
        let own = 0.5 * (after - before);
        found += own * (1.0 - system.value(&step, &Efficiency(MESH, 1.0)).value);
        // The same sum with both pairs carrying half.
        let at = part(position.roll).abs();
        let pairs = if system.value(&step, &PairsInContact(MESH)).value > 1.0 {
            0.5 * (at + (part(position.roll) + 1.0).abs())
        } else {
            at
        };
        halves += own * pairs;
        weight += own;
    }
    assert!((weight - 1.0).abs() < 1e-12);
    let path = geometry.first_roll;
    let [access, recess] = [-part(path.start_of_active_profile), part(path.end_of_active_profile)];
    let degree = 1.0 - geometry.contact_ratio + access * access + recess * recess;
    // H_v = pi (u + 1) / (z_1 u cos alpha_w) (1 - eps + eps_1^2 + eps_2^2), with sums of |x| of
    // half the degree.
    assert!(close(halves, 0.5 * degree, 0.01), "{halves} {}", 0.5 * degree);
    let classical = std::f64::consts::PI * 1.5 / 20.0 / geometry.operating_pressure_angle.cos() * degree;
    assert!(found < classical && found > 0.8 * classical, "{found} {classical}");
}

#[test]
fn stiffness_is_force_by_what_the_load_moves() {
    for gears in [&*PLAIN, &*RELIEVED] {
        let reliefs = gears[0].prototype.modifications.len();
        at_each(&PairOptions::chapter_5(gears), |_, mesh, cycle, value| {
            let unloaded = value(&UnloadedTransmissionError(MESH)).value;
            assert!(unloaded.abs() < if reliefs == 0 { 1e-9 } else { 1e-3 }, "cycle {cycle}: {unloaded}");
            let moved = value(&TransmissionError(MESH)).value - unloaded;
            let force = TORQUE / mesh.base_radii[0];
            assert!(moved > 0.0);
            let secant = value(&SecantStiffness(MESH)).value;
            assert!(close(secant, force / (moved * mesh.base_radii[1]), 1e-9), "cycle {cycle}: {secant}");
        });
    }
}

#[test]
fn places_are_those_of_the_maxima() {
    at_each(&PairOptions::chapter_5(&PLAIN), |geometry, mesh, cycle, value| {
        for body in [FIRST, SECOND] {
            let place_of = |maximum, coordinate| value(&MaximumLocation { body, maximum, coordinate }).value;
            let stress = value(&MaxRootStress(body));
            let place = stress.location.expect("a loaded body has a location of its largest stress");
            assert_eq!(place_of(Maximum::RootStress, Coordinate::Radius), place.radius);
            assert_eq!(place_of(Maximum::RootStress, Coordinate::Tooth), f64::from(place.tooth));
            assert_eq!(place_of(Maximum::RootStress, Coordinate::Axial), 0.0);
            // Tip edges carry no load here.
            assert_eq!(place_of(Maximum::EdgePressure, Coordinate::Tooth), -1.0);
            let compression = value(&MaxRootCompression(body));
            assert!(compression.value > stress.value, "cycle {cycle}: compression is the larger one");
            // A gauge at the point of the largest stress, and one on the other side of the tooth.
            let gauge_value =
                value(&GaugeReading(gauge(body, place.radius, FilletSide::Loaded), Reading::Stress));
            // They agree to the accuracy with which the coarse mesh approximates the fillet.
            assert!(close(gauge_value.value, stress.value, 1e-3));
            assert!(gauge_value.least.is_some_and(|least| least < 0.0 && least > -stress.value));
            let radius = compression.location.expect("a location").radius;
            let other = gauge(body, radius, FilletSide::Other);
            let least = value(&GaugeReading(other, Reading::Stress)).least;
            assert!(least.is_some_and(|least| close(-least, compression.value, 1e-3)), "{least:?}");
            // Plane strain: along the profile (1 - nu^2) / E of the stress, along the face zero, at
            // 45 degrees half of it.
            let strain = |direction, length| {
                let gauge = Gauge { direction, length, ..gauge(body, place.radius, FilletSide::Loaded) };
                value(&GaugeReading(gauge, Reading::Strain)).value
            };
            let along = gauge_value.value * (1.0 - 0.09) / (3e7 * PSI);
            assert!(close(strain(0.0, 0.0), along, 1e-9) && strain(FRAC_PI_2, 0.0).abs() < 1e-12 * along);
            assert!(close(strain(FRAC_PI_4, 0.0), 0.5 * along, 1e-9));
            // The mean over a length is less than the value at the largest stress.
            let mean = strain(0.0, 0.01 * INCH) / along;
            assert!((0.9..1.0).contains(&mean), "{mean}");
            // The gauge reads the same on the loaded tooth, and zero on a distant one.
            let on = |tooth| {
                let gauge = Gauge { tooth: Some(tooth), ..gauge(body, place.radius, FilletSide::Loaded) };
                value(&GaugeReading(gauge, Reading::LargestPrincipal)).value
            };
            assert!(close(on(place.tooth), stress.value, 1e-3));
            assert!(on((place.tooth + 10) % 20).abs() < 1e-2 * stress.value);
        }
        // Contact of the pinion at its roll angle and of the gear at the corresponding one, within
        // the contact width.
        let roll = |body| {
            value(&MaximumLocation { body, maximum: Maximum::LineLoad, coordinate: Coordinate::RollAngle })
                .value
        };
        let position = mesh.roll[0] + cycle * (mesh.roll[1] - mesh.roll[0]);
        let nearest = [0.0, 1.0]
            .map(|pitches| (position + pitches * (mesh.roll[1] - mesh.roll[0]) - roll(FIRST)).abs());
        assert!(nearest[0].min(nearest[1]) < 0.02, "cycle {cycle}: {nearest:?}");
        assert!((geometry.second_roll(roll(FIRST)) - roll(SECOND)).abs() < 0.01);
        let ends = [value(&LowestContact(FIRST)).value, value(&HighestContact(FIRST)).value];
        let active = [mesh.path[0], mesh.path[1]].map(|roll| geometry.first_radius(roll));
        assert!(
            ends[0] < ends[1] && ends[1] <= active[1] && ends[0] > 0.99 * active[0],
            "{ends:?} {active:?}"
        );
    });
}

#[test]
fn a_pair_without_load_has_no_places_and_loses_nothing() {
    at_each(&PairOptions { moment: 0.0, ..PairOptions::chapter_5(&PLAIN) }, |_, _, _, value| {
        let place = |coordinate| {
            value(&MaximumLocation { body: FIRST, maximum: Maximum::ContactPressure, coordinate }).value
        };
        assert_eq!(place(Coordinate::Tooth), -1.0);
        assert_eq!(place(Coordinate::Radius), 0.0);
        for observable in [
            &PairsInContact(MESH) as &dyn Observable,
            &MaxLineLoad(MESH),
            &LoadedFace(MESH),
            &SlidingVelocity(MESH, 0),
            &FrictionLoss(MESH, 0.05),
            &SecantStiffness(MESH),
            &MaxRootCompression(FIRST),
            &LowestContact(SECOND),
            &GaugeReading(gauge(FIRST, 0.023, FilletSide::Loaded), Reading::Strain),
        ] {
            assert_eq!(value(observable).value, 0.0, "{observable:?}");
        }
        assert_eq!(value(&Efficiency(MESH, 0.05)).value, 1.0);
        assert_eq!(value(&FaceLoadFactor(MESH)).value, 1.0);
    });
}
