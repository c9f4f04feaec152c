//! Other pairs than the report's: a contact ratio above two, profile shift, equal gears.

use crate::common::pair::{MESH, Member, PLAIN, PairOptions, Values, member, pair, system};
use calyx_gears::external::ExternalGearData;
use calyx_gears::mesh_geometry::MeshGeometry;
use calyx_gears::rack::Rack;
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::TransmissionError;
use calyx_runtime::scene::{Body, BodyId, PairId};

struct Case {
    name: &'static str,
    gears: [Member; 2],
    center_distance: f64,
    /// Largest number of tooth pairs in contact.
    shared_by: usize,
}

fn gear(module: f64, teeth: u32, shift: f64, addendum: f64, dedendum: f64) -> Member {
    let rack = Rack::new(module, 20.0_f64.to_radians(), 0.25 * module).expect("a sound rack");
    let pitch_radius = 0.5 * f64::from(teeth) * module;
    let data = ExternalGearData {
        teeth,
        rack,
        tooth_thickness: rack.thickness_of_shift(shift) - 0.02 * module,
        outer_radius: pitch_radius + addendum * module,
        root_radius: pitch_radius - dedendum * module,
        tip_edge_radius: None,
    };
    member(data, 10.0 * module)
}

fn cases() -> [Case; 3] {
    let equal = gear(2e-3, 24, 0.0, 1.0, 1.25);
    [
        Case {
            name: "high teeth",
            gears: [gear(1e-3, 40, 0.0, 1.35, 1.6), gear(1e-3, 60, 0.0, 1.35, 1.6)],
            center_distance: 50e-3,
            shared_by: 3,
        },
        // The pair of gear_geometry.json, at a slightly larger distance than without backlash.
        Case {
            name: "shifted",
            gears: [gear(3e-3, 17, 0.35, 1.35, 0.9), gear(3e-3, 42, -0.1, 0.9, 1.35)],
            center_distance: 89.3e-3,
            shared_by: 2,
        },
        Case { name: "equal", gears: [equal.clone(), equal], center_distance: 48e-3, shared_by: 2 },
    ]
}

#[test]
fn other_pairs_run_and_share_their_load() {
    for Case { name, gears, center_distance, shared_by } in cases() {
        let geometry =
            MeshGeometry::external(gears[0].gear(), gears[1].gear(), center_distance).expect("a mesh");
        assert_eq!(geometry.contact_ratio.ceil() as usize, shared_by, "{name}");
        let moment = 2e9 * center_distance.powi(3) / 1e3;
        for edges in [false, true] {
            let options = PairOptions { center_distance, moment, edges, ..PairOptions::chapter_5(&gears) };
            let (scene, mesh) = pair(&options);
            let system = system(&scene);
            for position in mesh_cycle(&mesh, 3) {
                // A tooth pair is in the present position of its successor after one pitch, so its
                // shares add up to the whole load. With tip edges it also carries a little load
                // before the path of contact.
                let shares: Vec<f64> = (-1..=shared_by as i32)
                    .map(|pitch| {
                        let time = position.time + f64::from(pitch) * mesh.period;
                        let step = system.solve(time).expect("equilibrium");
                        assert!(step.certificate.largest() <= 1e-12);
                        assert!(step.warnings.is_empty(), "{name}: {:?}", step.warnings);
                        Values::of(&system, &step).load_share
                    })
                    .collect();
                let sum: f64 = shares.iter().sum();
                assert!((sum - 1.0).abs() < 1e-8, "{name} at {}: {shares:?}", position.cycle);
                let carrying = shares.iter().filter(|&&share| share > 0.0).count();
                assert!(carrying >= shared_by - 1, "{name} at {}: {shares:?}", position.cycle);
            }
        }
    }
}

#[test]
fn transmission_error_is_continuous_where_tip_edges_carry() {
    for Case { name, gears, center_distance, .. } in cases() {
        let moment = 2e9 * center_distance.powi(3) / 1e3;
        let options = PairOptions { center_distance, moment, edges: true, ..PairOptions::chapter_5(&gears) };
        let (scene, mesh) = pair(&options);
        let system = system(&scene);
        let at = |cycle: f64| {
            let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
            Values::of(&system, &step).transmission_error
        };
        let coarse: Vec<f64> = (0..8).map(|i| at(f64::from(i) / 8.0)).collect();
        let range =
            coarse.iter().copied().fold(f64::MIN, f64::max) - coarse.iter().copied().fold(f64::MAX, f64::min);
        // Positions around the points at which pairs enter and leave, and in between.
        let ratio = mesh.characteristic[1].time / mesh.period;
        for cycle in [0.0, ratio, ratio - 0.01, ratio + 0.01, 0.99, 0.3] {
            let change = (at(cycle + 1e-4) - at(cycle - 1e-4)).abs();
            assert!(change < 0.02 * range, "{name} at {cycle}: {change:e} of {range:e}");
        }
    }
}

#[test]
fn pairs_of_one_scene_do_not_disturb_each_other() {
    // Two pairs of the same gears; one includes contact on tip edges and the other does not.
    let [(mut scene, mesh), (other, _)] =
        [false, true].map(|edges| pair(&PairOptions { edges, ..PairOptions::chapter_5(&PLAIN) }));
    let time = mesh.start + 0.51 * mesh.period;
    let alone = [&scene, &other].map(|scene| {
        let system = system(scene);
        let step = system.solve(time).expect("equilibrium");
        system.value(&step, &TransmissionError(MESH)).value
    });
    for (index, body) in other.mechanism.bodies.into_iter().enumerate() {
        let prototype = scene.bodies[index].prototype.clone();
        scene.add_body(Body { name: format!("{} again", body.name), prototype, ..body });
    }
    for mut pair in other.mechanism.pairs {
        pair.bodies = pair.bodies.map(|body| BodyId(body.0 + 2));
        scene.add_pair(pair);
    }
    // Unobserved pairs are left out.
    scene.add_observable(TransmissionError(PairId(1)));
    let system = system(&scene);
    let step = system.solve(time).expect("equilibrium");
    for (pair, alone) in alone.into_iter().enumerate() {
        let together = system.value(&step, &TransmissionError(PairId(pair))).value;
        assert!((together / alone - 1.0).abs() < 1e-9, "{pair}: {together} {alone}");
    }
    assert!((alone[0] / alone[1] - 1.0).abs() > 1e-4, "the edges make a difference");
}
