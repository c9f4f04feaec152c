//! Time to evaluate load and stiffness of a pair of tapered roller bearings, as a ratio to the time
//! of the powers δ^{10/9} that one pass over all laminae takes, in the same run. The pair with
//! elastic contacts is compared with that with laminae, and those of 36 and 72 rollers with that of
//! 18.
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
const ELASTIC_BOUND: f64 = 20.0;

/// Bound of the time of a roller with elastic contacts in a bearing of 72 to that in a bearing of
/// 18.
const COUNT_BOUND: f64 = 1.3;

/// Row of tapered rollers on a pitch circle that grows with their number.
fn rollers(count: usize) -> RollerRow {
    let row = RollerRow::new(RollerGeometry {
        kind: RollerKind::Tapered { outer_angle: 0.244, rib: Rib { end_radius: 0.12, height: 3.2e-3 } },
        count,
        roller_diameter: 10e-3,
        length: 13e-3,
        raceway_widths: [None; 2],
        pitch_diameter: 60e-3 / 18.0 * count as f64,
        profile: Profile::Logarithmic,
        laminae: 41,
        rings: Material::STEEL,
        rollers: Material::STEEL,
    });
    row.expect("valid")
}

/// Pair of rows, with elastic contacts or laminae.
fn pair(count: usize, contact: ContactModel) -> RollingBearing {
    let rollers = rollers(count).with_contact(contact).expect("valid");
    RollingBearing::pair(rollers, Arrangement::BackToBack, 80e-3, 3e-6).expect("valid")
}

fn main() {
    let elastic_contact = ContactModel::Elastic(ElasticContact::default());
    let laminae = pair(18, ContactModel::Laminae);
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
    let solution = laminae.displacement(&load, &Motion::REST).expect("solved");
    let evaluation = time(&mut || {
        let at = black_box(&solution.displacement);
        black_box(laminae.evaluate(at, &Motion::REST, &mut Start::default()).expect("finite"));
    });
    let equilibrium = time(&mut || {
        black_box(laminae.displacement(black_box(&load), &Motion::REST).expect("solved"));
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
    let preparation = time(&mut || {
        black_box(rollers(18).with_contact(black_box(elastic_contact)).expect("valid"));
    });
    println!("preparation of strips  {:8.1} µs", preparation * 1e6);
    let mut per_roller = Vec::new();
    for count in [18, 36, 72] {
        let elastic = pair(count, elastic_contact);
        let share = count as f64 / 18.0;
        // Moments grow with the diameter, too.
        let load = [0, 1, 2, 3, 4].map(|k| load[k] * if k < 3 { share } else { share * share });
        let mut evaluations = 0;
        let duration = time(&mut || {
            let solution = elastic.displacement(black_box(&load), &Motion::REST).expect("solved");
            evaluations = solution.evaluations;
        });
        let ratio = duration / equilibrium;
        println!(
            "elastic contacts, {count}   {:8.1} µs, {ratio:.1} times the equilibrium of laminae of 18 rollers, \
             {evaluations} evaluations",
            duration * 1e6
        );
        per_roller.push(duration / share);
    }
    let ratio = per_roller[0] / equilibrium;
    assert!(
        ratio < ELASTIC_BOUND,
        "the ratio {ratio:.1} of elastic contacts exceeds its bound {ELASTIC_BOUND}"
    );
    let growth = per_roller[2] / per_roller[0];
    println!("time of a roller       {growth:.2} times that of a bearing with 18, in one with 72");
    assert!(growth < COUNT_BOUND, "the ratio {growth:.2} of 72 rollers exceeds its bound {COUNT_BOUND}");
}
