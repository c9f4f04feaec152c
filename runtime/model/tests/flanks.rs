//! Tests of spline teeth under a rigid ring, against analytical equilibrium and bisection.

use calyx_contact::active_set::solve;
use calyx_contact::interior_point;
use calyx_contact::problem::{ContactProblem, Solution};
use calyx_model::bearing::Springs;
use calyx_model::spline_contact::{SENSES, SplineContact};
use calyx_numerics::interrupt::Interrupt;
use calyx_structure::SplineTeeth;
use calyx_structure::tests::bodies::STEEL;
use calyx_structure::tests::spline_clearance::{FIVE, LoosenedRing, TEETH};
use faer::Mat;

const RADIUS: f64 = 0.155;
const YIELDING: f64 = 4e-11;
const CLEARANCE: f64 = 60e-6;

fn spline_teeth(count: u16) -> SplineContact {
    let spline_teeth =
        SplineTeeth { count, first: 0.0, width: 0.1, tangential: YIELDING, radial: None, degree: 0 };
    SplineContact { spline_teeth, clearance: CLEARANCE, radius: RADIUS }
}

/// Ring free in its plane under a force and a torque, supported only by its spline teeth.
fn problem(contact: &SplineContact, load: [f64; 3]) -> ContactProblem {
    let mut springs = Springs::none(3);
    let arms = contact.arms(0.0, [0.0; 2]);
    let gaps = vec![0.5 * contact.clearance; arms.len()];
    springs.add_walls(&gaps, arms.into_iter().flatten(), &contact.compliance(None));
    let nothing = ContactProblem {
        compliance: Vec::new(),
        arms: Vec::new(),
        gaps: Vec::new(),
        stiffness: vec![0.0; 9],
        load: load.to_vec(),
    };
    let across = Mat::zeros(0, contact.flanks());
    springs.behind(nothing, across.as_ref(), &Interrupt::never()).expect("no interrupt")
}

/// Solves from the flanks that would support a rigid body.
fn solved(problem: &ContactProblem) -> Solution {
    let solution = solve(problem, None).unwrap();
    assert!(solution.certificate.largest() < 1e-12, "{:?}", solution.certificate);
    let (forces, _) = interior_point::solve(problem).unwrap();
    let largest = forces.iter().copied().fold(0.0, f64::max);
    for (found, independent) in solution.forces.iter().zip(&forces) {
        assert!((found - independent).abs() < 1e-7 * largest, "{found} {independent}");
    }
    solution
}

#[test]
fn a_torque_turns_a_ring_through_half_the_clearance_and_goes_evenly_through_all_spline_teeth() {
    for (count, torque) in [(3, 700.0), (50, -2.2e5)] {
        let contact = spline_teeth(count);
        let solution = solved(&problem(&contact, [0.0, 0.0, torque]));
        let each = torque / (f64::from(count) * RADIUS);
        for force in contact.around(&solution.forces) {
            assert!((force / -each - 1.0).abs() < 1e-12, "{force} {each}");
        }
        let [x, y, turn] = solution.motion[..] else { panic!("three freedoms") };
        let expected = (0.5 * CLEARANCE * torque.signum() + YIELDING * each) / RADIUS;
        assert!((turn / expected - 1.0).abs() < 1e-12, "{turn} {expected}");
        assert!(x.abs().max(y.abs()) < 1e-12 * CLEARANCE);
    }
}

/// Returns the zero of a monotonic function.
fn root(value: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (-1e-2, 1e-2);
    for _ in 0..120 {
        let middle = 0.5 * (low + high);
        if value(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// A transverse load with a torque: some spline teeth carry load on one flank, some on the other
/// and some on none. Each force is proportional to the displacement beyond half the clearance.
/// Displacement and rotation follow from the two equations of equilibrium by nested bisection.
#[test]
fn a_side_load_with_torque_lifts_spline_teeth_off_as_bisection_finds() {
    let contact = spline_teeth(24);
    let chord = 0.05_f64.sin() / 0.05;
    let (side, torque) = (3.0e6, 1.2e5);
    let moved = |spline_tooth: u16, y: f64, turn: f64| {
        chord * y * contact.spline_teeth.angle(spline_tooth).cos() + RADIUS * turn
    };
    let bears = |spline_tooth: u16, y: f64, turn: f64| {
        let moved = moved(spline_tooth, y, turn);
        -(moved.abs() - 0.5 * CLEARANCE).max(0.0) / YIELDING * moved.signum()
    };
    let all = || 0..contact.spline_teeth.count;
    let across = |y: f64, turn: f64| -> f64 {
        all()
            .map(|spline_tooth| {
                chord * contact.spline_teeth.angle(spline_tooth).cos() * bears(spline_tooth, y, turn)
            })
            .sum()
    };
    let shifted = |turn: f64| root(|y| -across(y, turn) - side);
    let about = |turn: f64| -> f64 {
        all().map(|spline_tooth| RADIUS * bears(spline_tooth, shifted(turn), turn)).sum()
    };
    let turn = root(|turn| -about(turn) - torque);
    let expected: Vec<f64> = all().map(|spline_tooth| bears(spline_tooth, shifted(turn), turn)).collect();
    let solution = solved(&problem(&contact, [0.0, side, torque]));
    let found = contact.around(&solution.forces);
    let largest = expected.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-9 * largest, "{found} {expected}");
    }
    let count = |sign: f64| found.iter().filter(|&&force| force * sign > 0.0).count();
    let (one, other) = (count(1.0), count(-1.0));
    println!("{other} spline teeth carry load on one flank, {one} on the other");
    assert!(one > 0 && other > one && one + other < found.len());
    assert!((solution.motion[1] / shifted(turn) - 1.0).abs() < 1e-9);
    assert!((solution.motion[2] / turn - 1.0).abs() < 1e-9);
}

/// The work of forces on flanks equals that of the body's displacements at its spline teeth, for
/// any position of its axis.
#[test]
fn arms_are_the_displacements_of_spline_teeth() {
    let contact = SplineContact {
        spline_teeth: SplineTeeth { width: 0.4, first: 0.3, ..spline_teeth(5).spline_teeth },
        ..spline_teeth(5)
    };
    let (angle, off) = (0.7, [0.02, -0.03]);
    let arms = contact.arms(angle, off);
    for spline_tooth in 0..5 {
        let middle = angle + contact.spline_teeth.angle(spline_tooth);
        let (steps, mut mean) = (2000, [0.0; 3]);
        for step in 0..steps {
            let at = middle + 0.4 * ((f64::from(step) + 0.5) / f64::from(steps) - 0.5);
            let (sin, cos) = at.sin_cos();
            let [x, y] = [off[0] + RADIUS * cos, off[1] + RADIUS * sin];
            let around = [-sin, cos, x * cos + y * sin];
            mean.iter_mut().zip(around).for_each(|(mean, part)| *mean += part / f64::from(steps));
        }
        for (flank, sense) in SENSES.into_iter().enumerate() {
            for (arm, mean) in arms[2 * usize::from(spline_tooth) + flank].iter().zip(mean) {
                assert!((arm + sense * mean).abs() < 1e-8, "{arm} {mean}");
            }
        }
    }
}

/// Ring under loads on its teeth, supported only by its spline teeth.
fn ring_problem(ring: &LoosenedRing, contact: &SplineContact) -> ContactProblem {
    let mut springs = Springs::none(3);
    let half = 0.5 * contact.clearance;
    let gaps: Vec<f64> =
        contact.by_flanks(|spline_tooth| ring.moved[spline_tooth]).map(|growth| half + growth).collect();
    let by_motion: Vec<Vec<f64>> = ring
        .by_motion
        .iter()
        .map(|spline_teeth| contact.by_flanks(|spline_tooth| spline_teeth[spline_tooth]).collect())
        .collect();
    let arms = (0..contact.flanks()).flat_map(|flank| by_motion.iter().map(move |arms| arms[flank]));
    springs.add_walls(&gaps, arms, &contact.compliance(Some(ring.compliance.as_ref())));
    let (empty, load) = (Vec::new, ring.load.clone());
    let nothing =
        ContactProblem { compliance: empty(), arms: empty(), gaps: empty(), stiffness: vec![0.0; 9], load };
    let across = Mat::zeros(0, contact.flanks());
    springs.behind(nothing, across.as_ref(), &Interrupt::never()).expect("no interrupt")
}

/// If a load presses every spline tooth in the same sense, the clearance only rotates the ring, and
/// the forces are those of spline teeth without clearance. Under a transverse load the forces agree
/// with those of the interior-point solver.
#[test]
fn spline_teeth_that_are_all_pressed_bear_as_spline_teeth_without_play() {
    let all: Vec<(usize, u32)> = (0..TEETH).map(|tooth| (0, tooth)).collect();
    for spline_teeth in [FIVE, SplineTeeth { tangential: 0.0, ..FIVE }] {
        let ring = LoosenedRing::new(spline_teeth, &all);
        let (expected, radius) = (&ring.bound, ring.radius);
        let agree = |found: &[f64], expected: &[f64], tolerance: f64| {
            let largest = expected.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < tolerance * largest, "{found} {expected}");
            }
        };
        let sense = expected[0].signum();
        assert!(expected.iter().all(|force| force * sense > 0.0), "{expected:?}");
        for clearance in [1e-13, 1e-11] {
            let contact = SplineContact { spline_teeth, clearance, radius };
            let problem = ring_problem(&ring, &contact);
            let solution = solve(&problem, None).unwrap();
            assert!(solution.certificate.largest() < 1e-10, "{:?}", solution.certificate);
            agree(&contact.around(&solution.forces), expected, 1e-9);
            // The bore of the mesh differs slightly from a circle.
            let arms = contact.arms(0.0, [0.0; 2]).into_iter().flatten().collect();
            let round = solve(&ContactProblem { arms, ..problem }, None).unwrap();
            agree(&contact.around(&round.forces), expected, 1e-5);
        }
        let contact = SplineContact { spline_teeth, clearance: 20.0 / STEEL.youngs_modulus, radius };
        let aside = LoosenedRing::new(spline_teeth, &[(0, 0), (1, 2)]);
        let problem = ring_problem(&aside, &contact);
        let solution = solve(&problem, None).unwrap();
        assert!(solution.certificate.largest() < 1e-10, "{:?}", solution.certificate);
        let (forces, _) = interior_point::solve(&problem).unwrap();
        agree(&solution.forces, &forces, 1e-6);
    }
}
