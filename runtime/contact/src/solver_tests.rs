//! Tests of the contact solver against enumeration, Clarabel and itself.

use super::active_set::solve;
use super::feasibility::{Balance, balance};
use super::interior_point;
use super::problem::{ContactError, ContactProblem, Method};
use super::rigid_limit::rigid_limit;
use calyx_numerics::interrupt::Interrupt;
use nalgebra::{DMatrix, DVector};

/// Xorshift generator: the same numbers on every machine.
pub(super) struct Random(pub u64);

impl Random {
    /// Returns a number uniform over -1 .. 1.
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Returns a random problem whose load contact forces balance, with more cells than DOFs so that
/// the motion is unique.
pub(super) fn random_problem(n: usize, m: usize, springs: bool, random: &mut Random) -> ContactProblem {
    let factor = DMatrix::from_fn(n, n, |_, _| random.next());
    let matrix = &factor * factor.transpose() + DMatrix::identity(n, n) * (0.05 * n as f64);
    let arms: Vec<f64> = (0..n * m).map(|_| random.next()).collect();
    let balancing: Vec<f64> = (0..n).map(|i| if i <= m { 1.0 } else { random.next().max(0.0) }).collect();
    let load = (0..m).map(|k| -(0..n).map(|i| arms[i * m + k] * balancing[i]).sum::<f64>()).collect();
    let root = DMatrix::from_fn(m, m.saturating_sub(1), |_, _| random.next());
    let springs = if springs { &root * root.transpose() } else { DMatrix::zeros(m, m) };
    ContactProblem {
        compliance: matrix.as_slice().to_vec(),
        arms,
        gaps: (0..n).map(|_| random.next() * n as f64 * 0.3).collect(),
        stiffness: springs.as_slice().to_vec(),
        load,
    }
}

/// Tries all active sets.
fn by_enumeration(problem: &ContactProblem) -> Option<(Vec<f64>, Vec<f64>)> {
    let (n, m) = (problem.cells(), problem.dofs());
    for set in 0u32..1 << n {
        let active: Vec<usize> = (0..n).filter(|i| set >> i & 1 == 1).collect();
        let k = active.len();
        if k + m == 0 {
            if problem.gaps.iter().all(|&e| e >= 0.0) {
                return Some((vec![0.0; n], vec![]));
            }
            continue;
        }
        let matrix = DMatrix::from_fn(k + m, k + m, |r, c| match (r < k, c < k) {
            (true, true) => problem.compliance[active[r] * n + active[c]],
            (true, false) => problem.arms[active[r] * m + c - k],
            (false, true) => problem.arms[active[c] * m + r - k],
            (false, false) => -problem.stiffness[(r - k) * m + c - k],
        });
        let right =
            DVector::from_fn(
                k + m,
                |r, _| if r < k { -problem.gaps[active[r]] } else { -problem.load[r - k] },
            );
        let decomposition = matrix.svd(true, true);
        if decomposition.singular_values.min() <= 1e-10 * decomposition.singular_values.max() {
            continue;
        }
        let Ok(unknowns) = decomposition.solve(&right, 0.0) else { continue };
        let mut forces = vec![0.0; n];
        for (r, &i) in active.iter().enumerate() {
            forces[i] = unknowns[r];
        }
        let motion: Vec<f64> = unknowns.iter().skip(k).copied().collect();
        let gaps = problem.gaps_at(&forces, &motion);
        let size = motion.iter().chain(&problem.gaps).fold(1.0f64, |a, v| a.max(v.abs()));
        if forces.iter().all(|&p| p >= -1e-12) && gaps.iter().all(|&d| d > -1e-9 * size) {
            return Some((forces, motion));
        }
    }
    None
}

fn assert_close(a: &[f64], b: &[f64], relative: f64, what: &str) {
    let size = a.iter().chain(b).fold(0.0f64, |s, v| s.max(v.abs()));
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() <= relative * size, "{what}: {a:?} and {b:?}");
    }
}

#[test]
fn tiny_problems_by_enumeration() {
    let mut random = Random(0x9e3779b97f4a7c15);
    for trial in 0..300 {
        let (n, m) = (3 + trial % 5, trial % 4);
        let problem = random_problem(n, m.min(n), trial % 2 == 1, &mut random);
        let Some((forces, motion)) = by_enumeration(&problem) else {
            panic!("trial {trial} has no solution")
        };
        let solution = solve(&problem, None).unwrap_or_else(|e| panic!("trial {trial}: {e}"));
        assert_close(&solution.forces, &forces, 1e-9, "forces");
        assert_close(&solution.motion, &motion, 1e-8, "motion");
        assert!(solution.certificate.largest() <= 1e-12, "{:?}", solution.certificate);
        assert_ne!(solution.method, Method::Clarabel);
    }
}

#[test]
fn larger_problems_against_clarabel() {
    let mut random = Random(88172645463325252);
    for (n, m) in [(100, 1), (150, 2), (200, 3), (300, 2)] {
        let problem = random_problem(n, m, m == 3, &mut random);
        let solution = solve(&problem, None).unwrap();
        let (forces, motion) = interior_point::solve(&problem).unwrap();
        let objective = problem.objective(&solution.forces, &solution.motion);
        let check = problem.objective(&forces, &motion);
        assert!((objective - check).abs() <= 1e-9 * objective.abs(), "{objective} {check}");
        assert_close(&solution.forces, &forces, 1e-3, "forces");
        assert!(solution.certificate.largest() <= 1e-12, "{:?}", solution.certificate);
    }
}

#[test]
fn warm_equals_cold_bit_for_bit() {
    let mut random = Random(424242);
    let problem = random_problem(120, 2, false, &mut random);
    let cold = solve(&problem, None).unwrap();
    let odd: Vec<usize> = (0..120).filter(|i| i % 2 == 1).collect();
    let bits = |v: &[f64]| v.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    for start in [cold.active.clone(), odd, vec![3, 70], vec![], vec![119, 5, 5, 4000]] {
        let warm = solve(&problem, Some(&start)).unwrap();
        assert_eq!(bits(&warm.forces), bits(&cold.forces));
        assert_eq!(bits(&warm.motion), bits(&cold.motion));
    }
    assert!(solve(&problem, Some(&cold.active)).unwrap().iterations == 1);
}

#[test]
fn units_do_not_matter() {
    let mut random = Random(77);
    let problem = random_problem(60, 2, true, &mut random);
    let reference = solve(&problem, None).unwrap();
    // Scales lengths by a, forces by b; the second DOF is a rotation.
    for (a, b) in [(3.7e4, 3.7e-4), (3.7e-4, 3.7e4), (3.7e-4, 3.7e-4)] {
        let dof = [a, 1.0];
        let scale = |values: &[f64], factor: &dyn Fn(usize) -> f64| -> Vec<f64> {
            values.iter().enumerate().map(|(i, v)| v * factor(i)).collect()
        };
        let scaled = ContactProblem {
            compliance: scale(&problem.compliance, &|_| a / b),
            arms: scale(&problem.arms, &|i| a / dof[i % 2]),
            gaps: scale(&problem.gaps, &|_| a),
            stiffness: scale(&problem.stiffness, &|i| a * b / dof[i / 2] / dof[i % 2]),
            load: scale(&problem.load, &|k| a * b / dof[k]),
        };
        let solution = solve(&scaled, None).unwrap();
        assert_eq!(solution.active, reference.active);
        assert_close(&solution.forces, &scale(&reference.forces, &|_| b), 1e-9, "forces");
        for k in 0..2 {
            let expected = reference.motion[k] * dof[k];
            assert!((solution.motion[k] - expected).abs() <= 1e-9 * expected.abs());
        }
    }
}

/// Cells on a line that push a body in the sense of DOF 0, without springs.
fn one_way(arms: Vec<f64>, m: usize, load: Vec<f64>) -> ContactProblem {
    let n = arms.len() / m;
    let compliance = (0..n * n).map(|e| if e / n == e % n { 2.0 } else { 0.5 }).collect();
    ContactProblem { compliance, arms, gaps: vec![0.0; n], stiffness: vec![0.0; m * m], load }
}

#[test]
fn loads_that_contact_cannot_balance_are_named() {
    // A positive motion of DOF 0 opens every gap; a load in this sense is infeasible.
    let Err(ContactError::Infeasible(motion)) = solve(&one_way(vec![0.3, 0.2, 0.1], 1, vec![5.0]), None)
    else {
        panic!("the body should run away")
    };
    assert_eq!((motion.dof, motion.direction), (0, 1.0));
    // DOF 0 is pressed into contact; DOF 1 is pulled off, in any unit.
    for unit in [1.0, 1e3] {
        let problem = one_way(vec![0.3, 0.0, 0.2, 0.1 * unit, 0.1, 0.2 * unit], 2, vec![-5.0, 3.0 * unit]);
        let Err(ContactError::Infeasible(motion)) = solve(&problem, None) else {
            panic!("it should run away")
        };
        assert_eq!((motion.dof, motion.direction), (1, 1.0));
    }
}

#[test]
fn dofs_that_nothing_holds_are_named() {
    // No cell constrains DOF 1: without load it is undetermined, with load the problem is
    // infeasible.
    let arms = vec![0.3, 0.0, 0.2, 0.0, 0.1, 0.0];
    let Err(ContactError::Unconstrained(motion)) = solve(&one_way(arms.clone(), 2, vec![-5.0, 0.0]), None)
    else {
        panic!("freedom 1 is free")
    };
    assert_eq!(motion.dof, 1);
    let Err(ContactError::Infeasible(motion)) = solve(&one_way(arms, 2, vec![-5.0, -1.0]), None) else {
        panic!("freedom 1 runs away")
    };
    assert_eq!((motion.dof, motion.direction), (1, -1.0));
    // The cells constrain only a difference of two bodies: rotating both together is free.
    let arms = vec![0.3, -0.6, 0.2, -0.4, 0.1, -0.2];
    let Err(ContactError::Unconstrained(motion)) = solve(&one_way(arms, 2, vec![-5.0, 10.0]), None) else {
        panic!("the common rotation is free")
    };
    assert!((motion.motion[0] / motion.motion[1] - 2.0).abs() < 1e-9, "{motion:?}");
    // A spring resists the motion that contact does not.
    let mut constrained = one_way(vec![0.3, 0.0, 0.2, 0.0, 0.1, 0.0], 2, vec![-5.0, 8.0]);
    constrained.stiffness = vec![0.0, 0.0, 0.0, 4.0];
    assert!((solve(&constrained, None).unwrap().motion[1] - 2.0).abs() < 1e-12);
}

#[test]
fn without_cells_springs_hold_or_nothing_does() {
    let mut problem = one_way(vec![], 1, vec![6.0]);
    let Err(ContactError::Infeasible(motion)) = solve(&problem, None) else { panic!("nothing holds it") };
    assert_eq!(motion.direction, 1.0);
    problem.stiffness = vec![3.0];
    assert_eq!(solve(&problem, None).unwrap().motion, vec![2.0]);
}

#[test]
fn cells_in_one_place_are_named() {
    let mut problem = one_way(vec![0.3, 0.2, 0.2], 1, vec![-5.0]);
    problem.compliance = vec![2.0, 0.5, 0.5, 0.5, 2.0, 2.0, 0.5, 2.0, 2.0];
    assert_eq!(solve(&problem, None), Err(ContactError::DependentCells { cell: 2 }));
    problem.gaps[1] = f64::NAN;
    assert!(matches!(solve(&problem, None), Err(ContactError::Invalid(_))));
}

#[test]
fn cells_that_depend_on_each_other_and_stay_open_do_no_harm() {
    // The last two cells coincide, and stay open.
    let mut problem = one_way(vec![0.3, 0.2, 0.2, 0.2], 1, vec![-5.0]);
    problem.compliance = vec![2.0, 0.5, 0.5, 0.5, 0.5, 2.0, 0.7, 0.7, 0.5, 0.7, 2.0, 2.0, 0.5, 0.7, 2.0, 2.0];
    problem.gaps = vec![0.0, 0.0, 1e3, 1e3];
    let found = solve(&problem, None).unwrap();
    assert_eq!(found.active, [0, 1]);
    assert!(found.certificate.largest() <= 1e-12, "{:?}", found.certificate);
}

#[test]
fn a_degenerate_cell_is_left_out_of_the_active_set() {
    // Cell 1 has exactly zero force and zero gap, by symmetry.
    let mut problem = one_way(vec![1.0, 1.0, 1.0], 1, vec![-2.0]);
    // Forces 1, 0, 1: elastic gaps 2.5, 1.0, 2.5.
    problem.gaps = vec![0.0, 1.5, 0.0];
    let cold = solve(&problem, None).unwrap();
    let warm = solve(&problem, Some(&[1])).unwrap();
    assert_eq!(cold.active, vec![0, 2]);
    assert_eq!(warm.forces, cold.forces);
    assert!(cold.certificate.largest() <= 1e-15);
}

#[test]
fn without_load_nothing_is_pressed() {
    let mut problem = one_way(vec![0.3, 0.2, 0.1], 1, vec![0.0]);
    problem.gaps = vec![0.1, 0.7, 0.3];
    let solution = solve(&problem, None).unwrap();
    assert_eq!(solution.forces, vec![0.0; 3]);
    assert!(solution.gaps.iter().all(|&d| d > -1e-15));
}

#[test]
fn vanishing_load_brings_bodies_to_touch() {
    // With one DOF, the first gap to close determines the limit.
    let limit = rigid_limit(&[3.0, 1.0, 4.0], &[0.5, 0.25, -1.0], &[-1.0], &Interrupt::never()).unwrap();
    assert_eq!((limit.motion[0], limit.touching), (-4.0, vec![1]));
    let limit = rigid_limit(&[3.0, 1.0, 4.0], &[0.5, 0.25, -1.0], &[1.0], &Interrupt::never()).unwrap();
    assert_eq!((limit.motion[0], limit.touching), (4.0, vec![2]));
    assert!(matches!(
        rigid_limit(&[1.0], &[0.5], &[1.0], &Interrupt::never()),
        Err(ContactError::Infeasible(_))
    ));
    assert_eq!(
        rigid_limit(&[-1.0, -1.0], &[1.0, -1.0], &[1.0], &Interrupt::never()),
        Err(ContactError::Jammed)
    );
    assert!(matches!(
        rigid_limit(&[1.0], &[1.0, 0.0], &[-1.0, 0.0], &Interrupt::never()),
        Err(ContactError::Unconstrained(_))
    ));
}

#[test]
fn the_rigid_limit_is_that_of_small_loads() {
    let mut random = Random(2718281828);
    for trial in 0..40 {
        let m = 1 + trial % 3;
        let mut problem = random_problem(12, m, false, &mut random);
        let limit = match rigid_limit(&problem.gaps, &problem.arms, &problem.load, &Interrupt::never()) {
            Ok(limit) => limit,
            // Random gaps may exclude all positions.
            Err(ContactError::Jammed) => continue,
            Err(error) => panic!("trial {trial}: {error}"),
        };
        let size = limit.motion.iter().fold(0.0f64, |a, x| a.max(x.abs()));
        for i in 0..12 {
            let gap =
                problem.gaps[i] + (0..m).map(|k| problem.arms[i * m + k] * limit.motion[k]).sum::<f64>();
            assert!(gap >= -1e-12 * size.max(1.0), "trial {trial}");
        }
        for f in &mut problem.load {
            *f *= 1e-7;
        }
        let loaded = solve(&problem, None).unwrap();
        // The elastic part of the motion is of the order of the load.
        assert_close(&limit.motion, &loaded.motion, 1e-4, "motion");
    }
}

/// A torque that a coupling locks in a loop of two meshes: each turns one end of the coupling, and
/// nothing else holds the loop.
fn locked_loop(n: usize, random: &mut Random) -> ContactProblem {
    let factor = DMatrix::from_fn(n, n, |_, _| random.next());
    let matrix = &factor * factor.transpose() * 0.2 + DMatrix::identity(n, n);
    let stiffness = 10f64.powf(2.0 * random.next());
    let twist = 1.0 + random.next();
    ContactProblem {
        compliance: matrix.as_slice().to_vec(),
        arms: (0..n).flat_map(|i| if i % 2 == 0 { [1.0, 0.0] } else { [0.0, -1.0] }).collect(),
        gaps: (0..n).map(|i| if i < 2 { 0.0 } else { 8.0 * random.next().powi(2) }).collect(),
        stiffness: vec![stiffness, -stiffness, -stiffness, stiffness],
        load: vec![-stiffness * twist, stiffness * twist],
    }
}

/// A mesh may lose all its cells in an exchange, and two sets may alternate.
#[test]
fn block_pivoting_solves_locked_loops() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for trial in 0..5000 {
        let problem = locked_loop(6 + trial % 20, &mut random);
        let found = solve(&problem, None).expect("the coupling presses both meshes");
        assert_eq!(found.method, Method::BlockPivoting, "trial {trial}");
        assert!(found.certificate.largest() < 1e-9, "trial {trial}: {:?}", found.certificate);
    }
}

/// A spring on a DOF counts however stiff that on another DOF is: a body on it is not free.
#[test]
fn soft_springs_hold_next_to_stiff_ones() {
    let arms = DMatrix::from_row_slice(2, 3, &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    let stiffness = DMatrix::from_diagonal(&DVector::from_column_slice(&[1e14, 1.0, 0.0]));
    match balance(&arms, &stiffness, &[0.0, 1.0, -1.0], &Interrupt::never()) {
        Balance::Found { forces, .. } => assert!((forces.iter().sum::<f64>() - 1.0).abs() < 1e-12),
        Balance::RunsAway(motion) => panic!("{motion:?}"),
        Balance::Interrupted(error) => panic!("{error:?}"),
    }
}
