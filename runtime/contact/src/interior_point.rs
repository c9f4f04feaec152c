//! Interior-point solution of the contact problem with Clarabel: independent check and fallback of
//! the pivoting solver.

use super::problem::{ContactError, ContactProblem};
use super::scaled::Scaled;
use calyx_numerics::interrupt::Interrupt;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, ZeroConeT};
use std::sync::{Arc, OnceLock};

/// Matrices of the size of the compliance that Clarabel keeps, each with values and row indices:
/// the quadratic terms, the scaled copy, the equations of an iteration and their factor.
const MATRICES: usize = 4;

/// Solves for forces and motion, `(p, x)`, to interior-point accuracy.
///
/// # Errors
/// [`ContactError::NotConverged`] for any failure; the pivoting solver reports reasons.
pub fn solve(problem: &ContactProblem) -> Result<(Vec<f64>, Vec<f64>), ContactError> {
    solve_until(problem, &Interrupt::never())
}

/// Solves with a checkpoint before the memory is allocated and before each iteration. An iteration
/// factorizes all equations in one piece of Clarabel, about `cells^3 / 3` multiplications.
///
/// # Errors
/// Those of [`solve`]; [`ContactError::Interrupted`].
pub fn solve_until(
    problem: &ContactProblem,
    interrupt: &Interrupt,
) -> Result<(Vec<f64>, Vec<f64>), ContactError> {
    problem.validate()?;
    let entries = (problem.cells() + problem.dofs()).pow(2) / 2;
    let bytes = MATRICES * entries * (size_of::<f64>() + size_of::<usize>());
    let _room = interrupt.reserve_memory(bytes as u64).map_err(ContactError::Interrupted)?;
    let scaled = Scaled::new(problem);
    let (n, m) = (problem.cells(), problem.dofs());
    // Scale forces to order one: by the load or, if it is zero, by the overlaps.
    let largest = |values: &[f64]| values.iter().fold(0.0f64, |a, v| a.max(v.abs()));
    let size = [largest(&scaled.load), largest(&scaled.gaps)].into_iter().find(|&s| s > 0.0).unwrap_or(1.0);

    // Variables: q, and the motions y that strain springs.
    let mut quadratic = Columns::default();
    for j in 0..n {
        quadratic.push((0..=j).map(|i| (i, scaled.compliance(i, j))));
    }
    for l in 0..m {
        quadratic.push((0..=l).map(|k| (n + k, scaled.stiffness[(k, l)])));
    }
    let mut linear: Vec<f64> = scaled.gaps.iter().map(|e| e / size).collect();
    linear.resize(n + m, 0.0);
    // Rows: equilibrium, then q >= 0.
    let mut constraints = Columns::default();
    for j in 0..n {
        constraints.push((0..m).map(|k| (k, scaled.arms[(j, k)])).chain([(m + j, -1.0)]));
    }
    for l in 0..m {
        constraints.push((0..m).map(|k| (k, -scaled.stiffness[(k, l)])));
    }
    let mut right: Vec<f64> = scaled.load.iter().map(|f| -f / size).collect();
    right.resize(m + n, 0.0);

    let settings = DefaultSettings {
        verbose: false,
        tol_gap_abs: 1e-13,
        tol_gap_rel: 1e-13,
        tol_feas: 1e-12,
        max_threads: 1,
        ..DefaultSettings::default()
    };
    let cones = [ZeroConeT(m), NonnegativeConeT(n)];
    let mut solver = DefaultSolver::new(
        &quadratic.matrix(n + m),
        &linear,
        &constraints.matrix(m + n),
        &right,
        &cones,
        settings,
    )
    .map_err(|_| ContactError::NotConverged)?;
    let ended = Arc::new(OnceLock::new());
    solver.set_termination_callback({
        let (interrupt, ended) = (interrupt.clone(), ended.clone());
        move |_| match interrupt.check() {
            Ok(()) => false,
            Err(error) => {
                ended.get_or_init(|| error);
                true
            }
        }
    });
    solver.solve();
    if let Some(error) = ended.get() {
        return Err(ContactError::Interrupted(error.clone()));
    }
    match solver.solution.status {
        // The tolerances are beyond the attainable accuracy, so the solver stops when it makes no
        // more progress.
        SolverStatus::Solved | SolverStatus::AlmostSolved | SolverStatus::InsufficientProgress => {}
        _ => return Err(ContactError::NotConverged),
    }
    let forces = (0..n).map(|i| (solver.solution.x[i] * size * scaled.cell_scale[i]).max(0.0)).collect();
    let motion = (0..m).map(|k| solver.solution.z[k] * size * scaled.dof_scale[k]).collect();
    Ok((forces, motion))
}

/// Sparse matrix by columns without zeros.
#[derive(Default)]
struct Columns {
    starts: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
}

impl Columns {
    fn push(&mut self, entries: impl Iterator<Item = (usize, f64)>) {
        self.starts.push(self.rows.len());
        for (row, value) in entries.filter(|&(_, value)| value != 0.0) {
            self.rows.push(row);
            self.values.push(value);
        }
    }

    fn matrix(mut self, rows: usize) -> CscMatrix<f64> {
        self.starts.push(self.rows.len());
        CscMatrix::new(rows, self.starts.len() - 1, self.starts, self.rows, self.values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_numerics::error::EngineError;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    #[test]
    fn the_error_of_any_checkpoint_ends_the_solution() {
        let n = 30_usize;
        let compliance = |at: usize| (-0.3 * (at / n).abs_diff(at % n) as f64).exp();
        let problem = ContactProblem {
            compliance: (0..n * n).map(compliance).collect(),
            arms: vec![-1.0; n],
            gaps: (0..n).map(|i| 1e-3 * (i as f64 - 12.0).powi(2)).collect(),
            stiffness: vec![0.0],
            load: vec![1.0],
        };
        let counted = |last: usize| {
            let asked = Arc::new(AtomicUsize::new(0));
            let counter = asked.clone();
            let interrupt = Interrupt::new(move || match counter.fetch_add(1, Relaxed) {
                number if number >= last => Err(EngineError::new("E0704", "enough", "")),
                _ => Ok(()),
            });
            (solve_until(&problem, &interrupt), asked.load(Relaxed))
        };
        let (whole, all) = counted(usize::MAX);
        assert!(whole.is_ok() && all > 5, "{whole:?} after {all} checkpoints");
        for last in [0, 1, all - 1] {
            let (ended, asked) = counted(last);
            assert!(matches!(ended, Err(ContactError::Interrupted(_))), "{ended:?}");
            assert_eq!(asked, last + 1);
        }
    }
}
