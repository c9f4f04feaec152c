//! Rigid-body limit: positions of rigid bodies in contact as the load vanishes.
//!
//! The limit of the contact problem for loads t g with t towards 0 is the linear program `max g'x
//! subject to  C x + e >= 0`. Its dual, `min e'p, C'p = -g, p >= 0`, has one row per DOF. The
//! simplex method solves it from the basis that balances the load, so the motion is exact to
//! rounding.
//!
//! See `docs/theory/contact.md`.

use super::active_set::free_motion;
use super::dense::row_product;
use super::feasibility::{Balance, balance};
use super::problem::ContactError;
use calyx_numerics::interrupt::Interrupt;
use nalgebra::{DMatrix, DVector};

/// Overlap that counts, relative to the motions and to the largest gap: rounding is smaller, also
/// next to a position in which all teeth touch.
const OVERLAP: f64 = 1e-13;
/// Least pivot relative to the largest one: with smaller ones, contacts of the basis depend on each
/// other.
const LEAST_PIVOT: f64 = 1e-9;
/// Difference of ratios, relative to that of the largest force and the largest pivot, that is due
/// to rounding.
const SAME_RATIO: f64 = 1e-12;

/// Rigid bodies in contact under a vanishing load.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidLimit {
    /// x, one entry per DOF.
    pub motion: Vec<f64>,
    /// Touching contacts that determine the motion, one per DOF, ascending.
    pub touching: Vec<usize>,
}

/// Computes the limit from `gaps` (e, m) and `arms` (C, contacts by DOFs, row-major) of the
/// contacts and the load `direction` (g). Pass the gaps of closest approach, one per patch:
/// averages over cells are larger because of the curvature.
///
/// # Errors
/// [`ContactError::Infeasible`] if no contact stops the motion, [`ContactError::Unconstrained`] if
/// the load does not determine some DOF, [`ContactError::Jammed`] if every position has an overlap;
/// [`ContactError::Interrupted`], because many DOFs take long.
pub fn rigid_limit(
    gaps: &[f64],
    arms: &[f64],
    direction: &[f64],
    interrupt: &Interrupt,
) -> Result<RigidLimit, ContactError> {
    let (n, m) = (gaps.len(), direction.len());
    if arms.len() != n * m {
        return Err(ContactError::Invalid("sizes of the arrays do not match"));
    }
    if !gaps.iter().chain(arms).chain(direction).all(|v| v.is_finite()) {
        return Err(ContactError::Invalid("a number is not finite"));
    }
    let scale: Vec<f64> = (0..m)
        .map(|k| (0..n).fold(0.0f64, |a, i| a.max(arms[i * m + k].abs())))
        .map(|largest| if largest > 0.0 { largest.recip() } else { 1.0 })
        .collect();
    let mut scaled_arms = DMatrix::zeros(n, m);
    for i in 0..n {
        for k in 0..m {
            scaled_arms[(i, k)] = arms[i * m + k] * scale[k];
        }
    }
    let load: Vec<f64> = direction.iter().zip(&scale).map(|(g, s)| g * s).collect();
    let basis = match balance(&scaled_arms, &DMatrix::zeros(m, m), &load, interrupt) {
        Balance::Found { cells, .. } => cells,
        Balance::RunsAway(motion) => return Err(ContactError::Infeasible(free_motion(&motion, &scale))),
        Balance::Interrupted(error) => return Err(ContactError::Interrupted(error)),
    };
    let basis = complete(&scaled_arms, basis, interrupt)?
        .map_err(|motion| ContactError::Unconstrained(free_motion(&motion, &scale)))?;
    let (motion, mut touching) = simplex(gaps, &scaled_arms, &load, basis, interrupt)?;
    touching.sort_unstable();
    Ok(RigidLimit { motion: motion.iter().zip(&scale).map(|(y, s)| y * s).collect(), touching })
}

/// Adds contacts until the basis determines every DOF; the inner error is a motion that no contact
/// resists.
fn complete(
    arms: &DMatrix<f64>,
    mut basis: Vec<usize>,
    interrupt: &Interrupt,
) -> Result<Result<Vec<usize>, Vec<f64>>, ContactError> {
    let m = arms.ncols();
    while basis.len() < m {
        interrupt.check().map_err(ContactError::Interrupted)?;
        // Find a motion that the basis does not resist: the last right singular vector of its rows
        // of C, padded to a square matrix.
        let square = DMatrix::from_fn(m, m, |r, k| basis.get(r).map_or(0.0, |&i| arms[(i, k)]));
        let Some(right) = square.svd(false, true).v_t else { return Ok(Err(vec![1.0; m])) };
        let motion: Vec<f64> = right.row(m - 1).iter().copied().collect();
        let seen = |i: usize| row_product(arms, i, &motion).abs();
        let best = (0..arms.nrows())
            .filter(|i| !basis.contains(i))
            .max_by(|&i, &j| seen(i).total_cmp(&seen(j)).then(j.cmp(&i)));
        match best {
            Some(i) if seen(i) > 1e-12 => basis.push(i),
            _ => return Ok(Err(motion)),
        }
    }
    Ok(Ok(basis))
}

fn simplex(
    gaps: &[f64],
    arms: &DMatrix<f64>,
    load: &[f64],
    mut basis: Vec<usize>,
    interrupt: &Interrupt,
) -> Result<(Vec<f64>, Vec<usize>), ContactError> {
    let (n, m) = arms.shape();
    let limit = 50 * (n + m);
    let largest_gap = gaps.iter().fold(0.0, |largest: f64, gap| largest.max(gap.abs()));
    for iteration in 0..limit {
        interrupt.check().map_err(ContactError::Interrupted)?;
        let matrix = DMatrix::from_fn(m, m, |r, k| arms[(basis[r], k)]);
        let right = DVector::from_fn(m, |r, _| -gaps[basis[r]]);
        let columns = matrix.transpose().lu();
        let Some(motion) = matrix.lu().solve(&right) else { return Err(ContactError::NotConverged) };
        let motion = motion.as_slice().to_vec();
        let violation = |i: usize| {
            let rigid: f64 = arms.row(i).iter().zip(&motion).map(|(c, y)| (c * y).abs()).sum();
            let gap = row_product(arms, i, &motion) + gaps[i];
            if gap < -OVERLAP * (rigid + largest_gap) { -gap } else { 0.0 }
        };
        let candidates = (0..n).filter(|i| !basis.contains(i) && violation(*i) > 0.0);
        // The largest overlap enters the basis. If this cycles, Bland's rule (first index)
        // terminates.
        let entering = if iteration < limit / 2 {
            candidates.max_by(|&i, &j| violation(i).total_cmp(&violation(j)).then(j.cmp(&i)))
        } else {
            candidates.min()
        };
        let Some(entering) = entering else { return Ok((motion, basis)) };
        let solve = |v: DVector<f64>| columns.solve(&v);
        let Some(forces) = solve(DVector::from_fn(m, |k, _| -load[k])) else {
            return Err(ContactError::NotConverged);
        };
        let Some(relief) = solve(DVector::from_fn(m, |k, _| arms[(entering, k)])) else {
            return Err(ContactError::NotConverged);
        };
        let bland = iteration >= limit / 2;
        match leaving(&forces, &relief, &basis, bland) {
            Some(row) => basis[row] = entering,
            None => return Err(ContactError::Jammed),
        }
    }
    Err(ContactError::NotConverged)
}

/// Returns the row of the basis that leaves it: that of the smallest ratio of force to relief.
///
/// Planets that carry no load have equal ratios of zero. Among equal ones, the largest pivot keeps
/// the basis well-conditioned; Bland's rule takes the first contact instead.
fn leaving(forces: &DVector<f64>, relief: &DVector<f64>, basis: &[usize], bland: bool) -> Option<usize> {
    let largest = relief.iter().copied().fold(0.0, f64::max);
    let ratio = |row: usize| forces[row].max(0.0) / relief[row];
    let rows: Vec<usize> = (0..relief.len()).filter(|&row| relief[row] > LEAST_PIVOT * largest).collect();
    let least = rows.iter().map(|&row| ratio(row)).fold(f64::INFINITY, f64::min);
    let scale = forces.iter().fold(0.0, |scale: f64, force| scale.max(force.abs()));
    let equal = rows.into_iter().filter(|&row| ratio(row) <= least + SAME_RATIO * scale / largest);
    match bland {
        true => equal.min_by_key(|&row| basis[row]),
        false => equal.max_by(|&i, &j| relief[i].total_cmp(&relief[j]).then(basis[j].cmp(&basis[i]))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_numerics::error::EngineError;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    /// Train of wheels, each driven by the one before.
    fn train(wheels: usize) -> (Vec<f64>, Vec<f64>) {
        let mut arms = vec![0.0; wheels * wheels];
        for k in 0..wheels {
            arms[k * wheels + k] = -1.0;
            if k + 1 < wheels {
                arms[k * wheels + k + 1] = 1.0;
            }
        }
        let mut load = vec![0.0; wheels];
        load[0] = 1.0;
        (arms, load)
    }

    /// The search for the load's contacts, the completion of the basis and the exchanges of
    /// contacts have checkpoints: two wheels that a stop drives, of which the load determines one,
    /// and the nearer of two stops for the other.
    #[test]
    fn every_stage_has_checkpoints() {
        let arms = [-1.0, 0.0, 0.0, -1.0, 0.0, -1.0];
        let gaps = [0.0, 2.0, 1.0];
        let run = |last: usize| {
            let asked = Arc::new(AtomicUsize::new(0));
            let counter = asked.clone();
            let interrupt = Interrupt::new(move || match counter.fetch_add(1, Ordering::Relaxed) {
                number if number >= last => Err(EngineError::new("E0704", "enough", "")),
                _ => Ok(()),
            });
            (rigid_limit(&gaps, &arms, &[1.0, 0.0], &interrupt), asked.load(Ordering::Relaxed))
        };
        let (whole, all) = run(usize::MAX);
        assert_eq!(whole.map(|limit| limit.touching), Ok(vec![0, 2]));
        assert!(all >= 4, "{all} checkpoints");
        for last in 0..all {
            let (ended, asked) = run(last);
            assert!(matches!(ended, Err(ContactError::Interrupted(_))), "{ended:?}");
            assert_eq!(asked, last + 1);
        }
    }

    /// A sun drives planets in a ring, each with several pairs of teeth: the planet with the least
    /// play stops the sun. Equal planets make the solution degenerate.
    #[test]
    fn equal_planets_stop_the_sun_at_their_least_play() {
        let mut seed = 1_u64;
        let mut random = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for case in 0..400 {
            let planets = 2 + case % 5;
            let noise = [0.0, 1e-17, 1e-12, 1e-6][case / 5 % 4];
            let nearest = if case % 2 == 0 { 2e-5 } else { 0.0 };
            let (sun, planet) = (0.03 + 0.02 * random(), 0.01 + 0.02 * random());
            let (mut gaps, mut arms) = (Vec::new(), Vec::new());
            let mut play = f64::INFINITY;
            for index in 0..planets {
                let mut add = |of_sun: f64, of_planet: f64, gap: f64| {
                    let mut row = vec![0.0; 1 + planets];
                    (row[0], row[1 + index]) = (of_sun, of_planet);
                    arms.extend(row);
                    gaps.push(gap);
                    gap
                };
                let mut least = [f64::INFINITY; 2];
                for pair in 0..3 {
                    let gap = nearest + f64::from(pair) * 1e-5;
                    least[0] = least[0].min(add(-sun, planet, gap + noise * random()));
                    least[1] = least[1].min(add(0.0, -planet, gap + noise * random()));
                }
                play = play.min(least[0] + least[1]);
            }
            let mut load = vec![0.0; 1 + planets];
            load[0] = 350.0;
            let limit = rigid_limit(&gaps, &arms, &load, &Interrupt::never());
            let limit = limit.unwrap_or_else(|error| panic!("case {case}: {error:?}"));
            let error = (limit.motion[0] * sun - play).abs();
            assert!(error < 1e-11 * (play + 1e-5), "case {case}: {error:e}");
        }
    }

    #[test]
    fn it_ends_at_the_checkpoint_that_says_so() {
        let (arms, load) = train(20);
        let gaps = [0.0; 20];
        assert!(rigid_limit(&gaps, &arms, &load, &Interrupt::never()).is_ok());
        let asked = Arc::new(AtomicUsize::new(0));
        let counter = asked.clone();
        let enough = EngineError::new("E0704", "enough", "");
        let third = Interrupt::new({
            let enough = enough.clone();
            move || if counter.fetch_add(1, Ordering::Relaxed) == 2 { Err(enough.clone()) } else { Ok(()) }
        });
        let ended = rigid_limit(&gaps, &arms, &load, &third);
        assert_eq!(ended, Err(ContactError::Interrupted(enough)));
        assert_eq!(asked.load(Ordering::Relaxed), 3);
    }
}
