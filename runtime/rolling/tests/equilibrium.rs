//! Displacements under loads: balance, rotation of the whole, reversal, clearance, pairs.

use crate::sample::{
    angular_contact, balls, close, cylindrical, deep_groove, evaluate, four_point, rollers, tapered,
};
use calyx_rolling::bearing::Contacts;
use calyx_rolling::{
    Arrangement, BallKind, BallRow, Conditions, Displacement, Load, Motion, RollerRow, RollingBearing, Start,
};

fn tapered_pair(arrangement: Arrangement, offset: f64) -> RollingBearing {
    let row = RollerRow::new(tapered()).expect("valid");
    RollingBearing::pair(row, arrangement, 80e-3, offset).expect("valid")
}

fn angular_pair(arrangement: Arrangement, offset: f64) -> RollingBearing {
    let row = BallRow::new(angular_contact()).expect("valid");
    RollingBearing::pair(row, arrangement, 20e-3, offset).expect("valid")
}

const LOADS: [Load; 4] = [
    [3000.0, -1000.0, 2000.0, 20.0, -15.0],
    [500.0, 100.0, -1500.0, 1.0, 2.0],
    [0.0, 0.0, 800.0, 0.0, 0.0],
    [4000.0, 0.0, 200.0, 0.0, 0.0],
];

fn bearings() -> Vec<RollingBearing> {
    vec![
        balls(deep_groove()),
        balls(four_point()),
        angular_pair(Arrangement::BackToBack, 5e-6),
        angular_pair(Arrangement::FaceToFace, -8e-6),
        tapered_pair(Arrangement::BackToBack, 3e-6),
        tapered_pair(Arrangement::FaceToFace, -10e-6),
    ]
}

/// The forces of the elements, summed from their states, balance the load.
#[test]
fn elements_balance_the_load() {
    let bearing = balls(deep_groove());
    for load in LOADS {
        let solution = bearing.displacement(&load, &Motion::REST).expect("solved");
        let mut sum = [0.0; 3];
        let mut scale = 0.0;
        for state in bearing.elements(&solution.displacement, &Motion::REST).expect("finite") {
            let Contacts::Ball(ball) = &state.contacts else { panic!("balls") };
            let contact = ball.inner[0];
            let radial = contact.load * contact.angle.cos();
            sum[0] += radial * state.azimuth.cos();
            sum[1] += radial * state.azimuth.sin();
            sum[2] += contact.load * contact.angle.sin();
            scale += contact.load;
        }
        for k in 0..3 {
            close(sum[k], load[k], scale, 1e-12, "force");
        }
    }
}

#[test]
fn displacements_balance_their_loads() {
    for (index, bearing) in bearings().iter().enumerate() {
        for load in LOADS {
            let solution = bearing.displacement(&load, &Motion::REST);
            let solution = solution.unwrap_or_else(|error| panic!("bearing {index}, {load:?}: {error}"));
            let at = evaluate(bearing, &solution.displacement, &Motion::REST);
            for k in 0..5 {
                let unit = if k < 3 { 1.0 } else { 30e-3 };
                close(at.load[k] / unit, load[k] / unit, at.scale, 1e-10, &format!("bearing {index}, {k}"));
            }
            assert!(solution.evaluations < 120, "bearing {index}: {} evaluations", solution.evaluations);
        }
    }
}

fn rotate(vector: &[f64; 5], angle: f64) -> [f64; 5] {
    let (sine, cosine) = angle.sin_cos();
    let turn = |x: f64, y: f64| (cosine * x - sine * y, sine * x + cosine * y);
    let ((x, y), (about_x, about_y)) = (turn(vector[0], vector[1]), turn(vector[3], vector[4]));
    [x, y, vector[2], about_x, about_y]
}

/// Rotating load and elements rotates the displacement.
#[test]
fn rotation_of_the_whole_rotates_the_displacement() {
    for bearing in bearings() {
        let first = bearing.displacement(&LOADS[0], &Motion::REST).expect("solved").displacement;
        for angle in [0.3, 1.0, 2.5, -2.0] {
            let motion = Motion { azimuth: angle, ..Motion::REST };
            let second = bearing.displacement(&rotate(&LOADS[0], angle), &motion).expect("solved");
            let expected = rotate(&first, angle);
            for k in 0..5 {
                let unit = if k < 3 { 1.0 } else { 30e-3 };
                close(second.displacement[k] * unit, expected[k] * unit, 1e-4, 1e-9, "displacement");
            }
        }
    }
}

/// A radial load through zero: the ring crosses its clearance and is displaced to the other side.
#[test]
fn reversed_load_crosses_the_clearance() {
    for (bearing, clearance) in [(balls(deep_groove()), 12e-6), (rollers(cylindrical()), 30e-6)] {
        let prescribed = [false, false, true, true, true];
        let mut start = [0.0; 5];
        let mut last: Option<Displacement> = None;
        for step in -20i32..=20 {
            let load = [100.0 * f64::from(step), 0.0, 0.0, 0.0, 0.0];
            let solution = bearing
                .equilibrium(&Conditions { load, prescribed, start }, &Motion::REST)
                .unwrap_or_else(|error| panic!("{load:?}: {error}"));
            start = solution.displacement;
            let radial = start[0];
            if step != 0 {
                assert!(radial * f64::from(step) > 0.0);
                assert!(radial.abs() > 0.49 * clearance && radial.abs() < clearance + 30e-6, "{radial}");
                let cold =
                    bearing.equilibrium(&Conditions { load, prescribed, start: [0.0; 5] }, &Motion::REST);
                close(cold.expect("solved").displacement[0], radial, radial.abs(), 1e-9, "from zero");
            }
            if let Some(last) = last
                && step != 0
                && step != 1
            {
                assert!((radial - last[0]).abs() < 6e-6, "continuous");
            }
            last = Some(start);
        }
    }
}

/// Without load, a ring with clearance stays where it is, and a preloaded pair is centred.
#[test]
fn no_load_has_no_displacement() {
    for bearing in bearings() {
        let solution = bearing.displacement(&[0.0; 5], &Motion::REST).expect("solved");
        for k in 0..5 {
            close(solution.displacement[k], 0.0, 1e-6, 1e-6, "displacement");
        }
    }
}

/// One ball carries a load along its direction alone, with the stiffness of its two contacts in
/// series.
#[test]
fn one_element_carries_its_load() {
    let mut geometry = deep_groove();
    geometry.count = 1;
    geometry.kind = BallKind::DeepGroove { clearance: 0.0 };
    let bearing = balls(geometry);
    let prescribed = [false, true, true, true, true];
    let load = [500.0, 0.0, 0.0, 0.0, 0.0];
    let conditions = Conditions { load, prescribed, start: [0.0; 5] };
    let solution = bearing.equilibrium(&conditions, &Motion::REST).expect("solved");
    // Stiffness of both contacts from the reference table, N/mm^1.5 scaled from the approach at 100
    // N.
    let approach = (0.0021814254315395618 + 0.002100719528297654) * 1e-3 * 5f64.powf(2.0 / 3.0);
    close(solution.displacement[0], approach, approach, 1e-9, "approach");
}

/// Pairs with equal rows: O arrangements resist tilting more than X arrangements, and the axial
/// stiffness of the preloaded pair is twice that of a row.
#[test]
fn arrangements_have_their_stiffness() {
    let stiffness = |arrangement| {
        let pair = angular_pair(arrangement, 10e-6);
        evaluate(&pair, &[0.0; 5], &Motion::REST).stiffness
    };
    let (back, face) = (stiffness(Arrangement::BackToBack), stiffness(Arrangement::FaceToFace));
    let row = evaluate(&balls(angular_contact()), &[0.0, 0.0, 10e-6, 0.0, 0.0], &Motion::REST).stiffness;
    for pair in [&back, &face] {
        close(pair[2][2], 2.0 * row[2][2], row[2][2], 1e-12, "axial stiffness");
        close(pair[0][0], 2.0 * row[0][0], row[0][0], 1e-12, "radial stiffness");
        close(pair[0][4], 0.0, row[0][0], 1e-12, "coupling");
    }
    assert!(back[4][4] > 2.0 * face[4][4]);
}

#[test]
fn impossible_loads_are_reported() {
    let bearing = rollers(cylindrical());
    let error = bearing.displacement(&[0.0, 0.0, 100.0, 0.0, 0.0], &Motion::REST).unwrap_err();
    assert!(error.to_string().contains("cannot carry the load"), "{error}");
    let single = rollers(tapered());
    assert!(single.displacement(&[0.0, 0.0, -100.0, 0.0, 0.0], &Motion::REST).is_err());
    assert!(single.displacement(&[f64::NAN, 0.0, 0.0, 0.0, 0.0], &Motion::REST).is_err());
}

/// Loads of any direction and size that the bearing can carry have an equilibrium, at rest and at
/// speed.
#[test]
fn random_loads_have_an_equilibrium() {
    let mut random = 0x1234_5678_9abc_def1u64;
    let mut next = || {
        random ^= random << 13;
        random ^= random >> 7;
        random ^= random << 17;
        (random >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    let speeds = [0.0, 700.0, 1500.0];
    let mut most = 0;
    for (index, bearing) in bearings().iter().enumerate() {
        for case in 0..60 {
            let size = 10f64.powf(2.0 * next() + 2.0);
            let unit = [1.0, 1.0, 1.0, 20e-3, 20e-3];
            let load = unit.map(|unit| size * unit * next());
            let motion = Motion { inner_speed: speeds[case % 3], azimuth: next(), ..Motion::REST };
            let solution = bearing.displacement(&load, &motion);
            let solution =
                solution.unwrap_or_else(|error| panic!("bearing {index}, {load:?}, {motion:?}: {error}"));
            most = most.max(solution.evaluations);
        }
    }
    assert!(most < 400, "{most} evaluations");
}

/// The senses that a bearing supports axially are those in which it has a load beyond all
/// clearances.
#[test]
fn axial_supports_are_those_with_load() {
    let bearings = [
        (balls(deep_groove()), [true, true]),
        (balls(angular_contact()), [true, true]),
        (balls(four_point()), [true, true]),
        (rollers(cylindrical()), [false, false]),
        (rollers(tapered()), [true, false]),
        (tapered_pair(Arrangement::Tandem, 0.0), [true, false]),
        (tapered_pair(Arrangement::BackToBack, 0.0), [true, true]),
        (tapered_pair(Arrangement::FaceToFace, 0.0), [true, true]),
    ];
    for (index, (bearing, expected)) in bearings.iter().enumerate() {
        assert_eq!(bearing.axial_supports(), *expected, "{index}");
        for (sense, supports) in [1.0, -1.0].into_iter().zip(expected) {
            // Opposite flanks of angular contact balls are 0.6 mm away.
            let at = [0.0, 0.0, sense * 0.7e-3, 0.0, 0.0];
            let load = bearing.evaluate(&at, &Motion::REST, &mut Start::default()).expect("finite").load;
            assert_eq!(sense * load[2] > 1.0, *supports, "{index} {sense}: {load:?}");
        }
    }
}

/// Angular contact balls under axial load against their contact angle touch the opposite flanks.
#[test]
fn opposite_flanks_are_found() {
    let bearing = balls(angular_contact());
    for (force, expected) in [(2e3, false), (-2e3, true)] {
        let found = bearing.displacement(&[500.0, 0.0, force, 0.0, 0.0], &Motion::REST).expect("solved");
        let states = bearing.elements(&found.displacement, &Motion::REST).expect("finite");
        assert_eq!(bearing.is_loaded_on_opposite_flanks(&states), expected, "{force}");
    }
    let deep = balls(deep_groove());
    let found = deep.displacement(&[500.0, 0.0, -2e3, 0.0, 0.0], &Motion::REST).expect("solved");
    let states = deep.elements(&found.displacement, &Motion::REST).expect("finite");
    assert!(!deep.is_loaded_on_opposite_flanks(&states));
}
