//! Feasibility of equilibrium: non-negative least squares (Lawson & Hanson, Solving Least Squares
//! Problems, ch. 23) on the equilibrium equations. The passive set is a first feasible active set.
//! A nonzero residual is, by the optimality conditions, a motion along which the load is unbalanced
//! (Farkas' lemma).

use super::dense::dot;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// Residual of equilibrium, relative to the load, that counts as balanced.
const BALANCED: f64 = 1e-12;

pub(super) enum Balance {
    /// Cell forces `>= 0` in equilibrium with the load; the rows of C of the loaded cells are
    /// linearly independent.
    Found { forces: Vec<f64>, cells: Vec<usize> },
    /// Motion that closes no gap and strains no spring, and on which the load does positive work.
    RunsAway(Vec<f64>),
    /// The search was interrupted.
    Interrupted(EngineError),
}

/// Finds `p >= 0` and any x with `C'p - K x = -f`. The columns of C must be scaled to order one.
pub(super) fn balance(
    arms: &DMatrix<f64>,
    stiffness: &DMatrix<f64>,
    load: &[f64],
    interrupt: &Interrupt,
) -> Balance {
    let (n, m) = arms.shape();
    // Springs balance any force in the range of K; equilibrium remains on its null space.
    let unsprung = null_space(stiffness);
    let project = |v: &[f64]| -> Vec<f64> { unsprung.iter().map(|basis| dot(basis, v)).collect() };
    let columns: Vec<Vec<f64>> =
        arms.row_iter().map(|row| project(&row.iter().copied().collect::<Vec<_>>())).collect();
    let size: Vec<f64> = columns.iter().map(|c| dot(c, c).sqrt()).collect();
    let target: Vec<f64> = project(load).iter().map(|f| -f).collect();
    let wanted = dot(&target, &target).sqrt();

    let mut forces = vec![0.0; n];
    let mut passive: Vec<usize> = Vec::new();
    let mut residual = target.clone();
    // Each pass increases the balanced part of the load; more than a few passes per DOF are due to
    // rounding alone.
    for _ in 0..10 * (m + 1) * (m + 1) {
        if dot(&residual, &residual).sqrt() <= BALANCED * wanted {
            break;
        }
        let tolerance = BALANCED * dot(&residual, &residual).sqrt();
        let pull = |i: usize| dot(&columns[i], &residual) / size[i];
        let Some(entering) = (0..n)
            .filter(|&i| size[i] > 0.0 && !passive.contains(&i) && pull(i) > tolerance)
            .max_by(|&i, &j| pull(i).total_cmp(&pull(j)).then(j.cmp(&i)))
        else {
            break;
        };
        if let Err(error) = interrupt.check() {
            return Balance::Interrupted(error);
        }
        passive.push(entering);
        while !passive.is_empty() {
            let trial = least_squares(&columns, &passive, &target);
            if trial.iter().all(|&t| t > 0.0) {
                for (&i, &t) in passive.iter().zip(&trial) {
                    forces[i] = t;
                }
                break;
            }
            // Move towards the trial as far as forces remain compressive, and remove cells whose
            // force vanishes.
            let step = passive
                .iter()
                .zip(&trial)
                .filter(|&(_, &t)| t <= 0.0)
                .map(|(&i, &t)| if forces[i] > t { forces[i] / (forces[i] - t) } else { 0.0 })
                .fold(1.0f64, f64::min);
            for (&i, &t) in passive.iter().zip(&trial) {
                forces[i] += step * (t - forces[i]);
            }
            let largest = forces.iter().copied().fold(0.0, f64::max);
            let leaving: Vec<usize> = passive
                .iter()
                .zip(&trial)
                .filter(|&(&i, &t)| t <= 0.0 && forces[i] <= 1e-15 * largest)
                .map(|(&i, _)| i)
                .collect();
            for &i in &leaving {
                forces[i] = 0.0;
            }
            passive.retain(|i| !leaving.contains(i));
        }
        residual = target.clone();
        for &i in &passive {
            for (r, a) in residual.iter_mut().zip(&columns[i]) {
                *r -= a * forces[i];
            }
        }
    }
    if dot(&residual, &residual).sqrt() <= BALANCED * wanted {
        passive.sort_unstable();
        return Balance::Found { forces, cells: passive };
    }
    let mut motion = vec![0.0; m];
    for (basis, r) in unsprung.iter().zip(&residual) {
        for k in 0..m {
            motion[k] -= basis[k] * r;
        }
    }
    Balance::RunsAway(motion)
}

fn least_squares(columns: &[Vec<f64>], passive: &[usize], target: &[f64]) -> Vec<f64> {
    let matrix = DMatrix::from_fn(target.len(), passive.len(), |k, j| columns[passive[j]][k]);
    let decomposition = matrix.svd(true, true);
    let cut = 1e-13 * decomposition.singular_values.max();
    // Both factors were requested, so the solution exists.
    decomposition
        .solve(&DVector::from_column_slice(target), cut)
        .map_or_else(|_| vec![0.0; passive.len()], |x| x.as_slice().to_vec())
}

/// Returns an orthonormal basis of the motions that strain no spring. The decision is made for unit
/// diagonal, so units and the stiffness of springs on other DOFs do not matter.
fn null_space(stiffness: &DMatrix<f64>) -> Vec<Vec<f64>> {
    let m = stiffness.nrows();
    if stiffness.iter().all(|&k| k == 0.0) {
        let unit = |k: usize| (0..m).map(|l| if l == k { 1.0 } else { 0.0 }).collect();
        return (0..m).map(unit).collect();
    }
    let scale: Vec<f64> = (0..m)
        .map(|k| if stiffness[(k, k)] > 0.0 { stiffness[(k, k)].sqrt().recip() } else { 1.0 })
        .collect();
    let unit = DMatrix::from_fn(m, m, |k, l| scale[k] * stiffness[(k, l)] * scale[l]);
    let eigen = SymmetricEigen::new(unit);
    let cut = 1e-12 * eigen.eigenvalues.amax();
    let motions: Vec<DVector<f64>> = (0..m)
        .filter(|&k| eigen.eigenvalues[k] <= cut)
        .map(|k| eigen.eigenvectors.column(k).component_mul(&DVector::from_column_slice(&scale)).normalize())
        .collect();
    if motions.is_empty() {
        return Vec::new();
    }
    let orthonormal = DMatrix::from_columns(&motions).qr().q();
    orthonormal.column_iter().map(|column| column.iter().copied().collect()).collect()
}
