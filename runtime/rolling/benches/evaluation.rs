//! Time to evaluate load and stiffness of a pair of tapered roller bearings, as a ratio to the time
//! of the powers δ^{10/9} that one pass over all laminae takes, in the same run. The pair with
//! elastic contacts is compared with that with laminae.
//!
//! `cargo bench -p calyx-rolling`

use calyx_rolling::{
    Arrangement, ContactModel, ElasticContact, Material, Motion, Profile, Rib, RollerGeometry, RollerKind,
    RollerRow, RollingBearing, Start,
};
use std::hint::black_box;
use std::time::Instant;

/// Bound of the ratio for an equilibrium of the pair under a load, with some ten evaluations of
/// some eight passes over the laminae each.
const BOUND: f64 = 200.0;

/// Bound of the ratio of an equilibrium with elastic contacts to one with laminae.
const ELASTIC_BOUND: f64 = 60.0;

fn main() {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Tapered { outer_angle: 0.244, rib: Rib { end_radius: 0.12, height: 3.2e-3 } },
        count: 18,
        roller_diameter: 10e-3,
        length: 13e-3,
        pitch_diameter: 60e-3,
        profile: Profile::Logarithmic,
        laminae: 41,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    });
    let rollers = row.expect("valid");
    let elastic =
        rollers.clone().with_contact(ContactModel::Elastic(ElasticContact::default())).expect("valid");
    let elastic = RollingBearing::pair(elastic, Arrangement::BackToBack, 80e-3, 3e-6).expect("valid");
    let pair = RollingBearing::pair(rollers, Arrangement::BackToBack, 80e-3, 3e-6).expect("valid");
    let load = [3000.0, -1000.0, 2000.0, 20.0, -15.0];
    let time = |call: &mut dyn FnMut()| {
        let mut best = f64::INFINITY;
        for _ in 0..20 {
            let start = Instant::now();
            call();
            best = best.min(start.elapsed().as_secs_f64());
        }
        best
    };
    let approaches: Vec<f64> = (0..2 * 18 * 82).map(|k| 1e-6 * (1.0 + 1e-3 * f64::from(k))).collect();
    let powers = time(&mut || {
        let sum: f64 = approaches.iter().map(|x| black_box(*x).powf(10.0 / 9.0)).sum();
        black_box(sum);
    });
    let solution = pair.displacement(&load, &Motion::REST).expect("solved");
    let evaluation = time(&mut || {
        let at = black_box(&solution.displacement);
        black_box(pair.evaluate(at, &Motion::REST, &mut Start::default()).expect("finite"));
    });
    let equilibrium = time(&mut || {
        black_box(pair.displacement(black_box(&load), &Motion::REST).expect("solved"));
    });
    println!("powers of all laminae  {:8.1} µs", powers * 1e6);
    println!("evaluation             {:8.1} µs, ratio {:.1}", evaluation * 1e6, evaluation / powers);
    println!(
        "equilibrium            {:8.1} µs, ratio {:.1}, {} evaluations",
        equilibrium * 1e6,
        equilibrium / powers,
        solution.evaluations
    );
    let ratio = equilibrium / powers;
    assert!(ratio < BOUND, "the ratio {ratio:.1} of the equilibrium exceeds its bound {BOUND}");
    let mut evaluations = 0;
    let with_elastic = time(&mut || {
        let solution = elastic.displacement(black_box(&load), &Motion::REST).expect("solved");
        evaluations = solution.evaluations;
    });
    let ratio = with_elastic / equilibrium;
    println!(
        "elastic contacts       {:8.1} µs, {ratio:.1} times the equilibrium, {evaluations} evaluations",
        with_elastic * 1e6
    );
    assert!(
        ratio < ELASTIC_BOUND,
        "the ratio {ratio:.1} of elastic contacts exceeds its bound {ELASTIC_BOUND}"
    );
}
