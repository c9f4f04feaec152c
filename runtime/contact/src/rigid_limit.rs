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
            if gap < -1e-14 * (rigid + gaps[i].abs()) { -gap } else { 0.0 }
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
        let leaving = (0..m)
            .filter(|&r| relief[r] > 1e-12)
            .map(|r| (forces[r].max(0.0) / relief[r], basis[r], r))
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        match leaving {
            Some((_, _, r)) => basis[r] = entering,
            None => return Err(ContactError::Jammed),
        }
    }
    Err(ContactError::NotConverged)
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
