//! Exact solution of the contact problem by active-set methods.
//!
//! Block principal pivoting (Júdice & Pires, Computers & Operations Research 21, 1994) exchanges
//! all cells of wrong sign in each iteration and takes a handful of factorizations. If it makes no
//! progress, a primal active-set method (Nocedal & Wright, Numerical Optimization, alg. 16.3)
//! replaces it: single exchanges from a feasible start with decreasing objective, so it terminates.
//! The interior-point solver Clarabel is the last resort.
//!
//! The problem is first scaled to unit compliance of every cell and to influence of order one of
//! every DOF. The factors are powers of two, so nothing is rounded, and units do not matter. The
//! final equations are always those of the cells in ascending order with one step of iterative
//! refinement, so the bits of the solution do not depend on the start.

use super::dense::{ActiveEquations, Singular, arms_of, dot, null_motion, row_product};
use super::feasibility::{Balance, balance};
use super::interior_point;
use super::problem::{ContactError, ContactProblem, FreeMotion, Method, Solution};
use super::scaled::Scaled;
use calyx_numerics::interrupt::Interrupt;
use nalgebra::DMatrix;

/// Number of block exchanges without a smaller number of wrong signs before single exchanges take
/// over.
const PATIENCE: usize = 10;
/// Forces below this fraction of the largest count as zero: rounding, times the condition number of
/// the compliance.
const FORCE_TOLERANCE: f64 = 1e-12;
/// Overlaps below this fraction of the terms of a gap count as zero.
const GAP_TOLERANCE: f64 = 1e-13;

/// Cells that close slower than this fraction of the fastest one do not stop a motion.
const RESISTS: f64 = 1e-3;
/// Work of the load on a motion, relative to the sum of magnitudes of its terms, that is rounding.
const NO_WORK: f64 = 1e-9;

/// Solves a contact problem. `warm_start` is an estimate of the active set, for example from a
/// neighbouring step; indices beyond the cells are ignored.
///
/// Without any load the motion is not unique; [`super::rigid_limit`] selects the limit under a
/// vanishing drive load.
///
/// # Errors
/// [`ContactError::Infeasible`] and [`ContactError::Unconstrained`] contain the motion,
/// [`ContactError::DependentCells`] the cell.
pub fn solve(problem: &ContactProblem, warm_start: Option<&[usize]>) -> Result<Solution, ContactError> {
    solve_until(problem, warm_start, &Interrupt::never())
}

/// Solves a contact problem and polls an interrupt before each piece of a factorization.
///
/// # Errors
/// Those of [`solve`]; [`ContactError::Interrupted`].
pub fn solve_until(
    problem: &ContactProblem,
    warm_start: Option<&[usize]>,
    interrupt: &Interrupt,
) -> Result<Solution, ContactError> {
    problem.validate()?;
    let solution = pivot(problem, warm_start, interrupt)?;
    // Maxima ignore NaN, so a solution with NaN would pass its certificate.
    let finite = solution.forces.iter().chain(&solution.motion).all(|value| value.is_finite());
    if finite { Ok(solution) } else { Err(ContactError::NotConverged) }
}

/// Computes the forces and the motion that close the gaps of the given cells, ascending; all other
/// cells carry no force. Forces may be negative and other gaps too: with the active set of a
/// solution, this is its smooth continuation to neighbouring problems.
///
/// Returns `None` if these cells and the springs do not determine the forces and the motion.
///
/// # Errors
/// [`ContactError::Invalid`], [`ContactError::Interrupted`].
pub fn solve_with_active_set(
    problem: &ContactProblem,
    active: &[usize],
    interrupt: &Interrupt,
) -> Result<Option<Solution>, ContactError> {
    problem.validate()?;
    if active.last().is_some_and(|&last| last >= problem.cells()) {
        return Err(ContactError::Invalid("an active cell does not exist"));
    }
    let scaled = Scaled::new(problem);
    match scaled.close(active, interrupt) {
        Ok((forces, motion)) => {
            let found = Found { active: active.to_vec(), forces, motion };
            Ok(Some(scaled.solution(problem, found, Method::BlockPivoting, 1)))
        }
        Err(Singular::Interrupted(error)) => Err(ContactError::Interrupted(error)),
        Err(_) => Ok(None),
    }
}

/// Returns the active set of a problem by block pivoting alone; empty if that does not succeed. For
/// estimates, which are not worth the exchange of single cells.
pub(crate) fn estimate(problem: &ContactProblem, interrupt: &Interrupt) -> Vec<usize> {
    if problem.validate().is_err() {
        return Vec::new();
    }
    let all = (0..problem.cells()).collect();
    let found = block_pivoting(&Scaled::new(problem), all, &mut 0, interrupt);
    found.ok().flatten().map_or_else(Vec::new, |found| found.active)
}

/// Solves a valid problem by pivoting.
fn pivot(
    problem: &ContactProblem,
    warm_start: Option<&[usize]>,
    interrupt: &Interrupt,
) -> Result<Solution, ContactError> {
    let scaled = Scaled::new(problem);
    scaled.check_dofs()?;
    let mut warm: Vec<usize> =
        warm_start.unwrap_or_default().iter().copied().filter(|&i| i < problem.cells()).collect();
    warm.sort_unstable();
    warm.dedup();
    let mut iterations = 0;
    // A warm start may fail, for example if it does not determine all DOFs. A cold start with all
    // cells follows.
    for start in [warm, (0..problem.cells()).collect()] {
        if start.is_empty() && problem.cells() > 0 {
            continue;
        }
        if let Some(found) = block_pivoting(&scaled, start, &mut iterations, interrupt)? {
            interrupt.check().map_err(ContactError::Interrupted)?;
            return Ok(scaled.solution(problem, found, Method::BlockPivoting, iterations));
        }
    }
    if let Some(found) = single_pivoting(&scaled, &mut iterations, interrupt)? {
        return Ok(scaled.solution(problem, found, Method::SinglePivoting, iterations));
    }
    let (forces, motion) = interior_point::solve_until(problem, interrupt)?;
    let largest = forces.iter().copied().fold(0.0, f64::max);
    let active = (0..forces.len()).filter(|&i| forces[i] > 1e-6 * largest).collect();
    let certificate = problem.certify(&forces, &motion);
    let gaps = problem.gaps_at(&forces, &motion);
    Ok(Solution { forces, motion, gaps, active, method: Method::Clarabel, iterations, certificate })
}

/// Number of rows of the compliance whose products are summed at a time.
const ROWS: usize = 4;

/// Active set with its forces and the motion, in scaled variables.
struct Found {
    active: Vec<usize>,
    forces: Vec<f64>,
    motion: Vec<f64>,
}

impl Scaled<'_> {
    fn free_motion(&self, scaled_motion: &[f64]) -> FreeMotion {
        free_motion(scaled_motion, &self.dof_scale)
    }

    /// Rejects motions that no cell and no spring resists: the problem is ill-posed for every
    /// active set.
    fn check_dofs(&self) -> Result<(), ContactError> {
        let m = self.load.len();
        let Some(motion) = null_motion(&self.resistance(0..self.cells()), 1e-14) else {
            return Ok(());
        };
        let work = dot(&self.load, &motion);
        let magnitude: f64 = (0..m).map(|k| (self.load[k] * motion[k]).abs()).sum();
        if work.abs() <= NO_WORK * magnitude {
            return Err(ContactError::Unconstrained(self.free_motion(&motion)));
        }
        let motion: Vec<f64> = motion.iter().map(|v| v * work.signum()).collect();
        Err(ContactError::Infeasible(self.free_motion(&motion)))
    }

    /// Computes `K + C_S' C_S`, which is singular on the motions that neither the cells S nor the
    /// springs resist.
    fn resistance(&self, cells: impl Iterator<Item = usize>) -> DMatrix<f64> {
        let mut sum = self.stiffness.clone();
        for cell in cells {
            let own: Vec<(usize, f64)> = arms_of(&self.arms, cell).collect();
            for &(k, arm) in &own {
                for &(l, other) in &own {
                    sum[(k, l)] += arm * other;
                }
            }
        }
        sum
    }

    /// Computes the forces on the active cells and the motion that close their gaps, with one step
    /// of iterative refinement.
    fn close(&self, active: &[usize], interrupt: &Interrupt) -> Result<(Vec<f64>, Vec<f64>), Singular> {
        let m = self.load.len();
        let equations = ActiveEquations::new(
            |cell| self.row(cell),
            &self.cell_scale,
            &self.arms,
            &self.stiffness,
            active,
            interrupt,
        )?;
        let checkpoint = || interrupt.check().map_err(Singular::Interrupted);
        let right_gaps: Vec<f64> = active.iter().map(|&i| -self.gaps[i]).collect();
        let right_loads: Vec<f64> = self.load.iter().map(|f| -f).collect();
        let (mut forces, mut motion) = equations.solve(&right_gaps, &right_loads);
        checkpoint()?;
        let gap_residual: Vec<f64> =
            self.gaps(active, active, &forces, &motion).iter().map(|gap| -gap).collect();
        let load_residual: Vec<f64> = (0..m)
            .map(|k| {
                let contact: f64 = active.iter().zip(&forces).map(|(&i, q)| self.arms[(i, k)] * q).sum();
                row_product(&self.stiffness, k, &motion) - contact - self.load[k]
            })
            .collect();
        checkpoint()?;
        let (more_forces, more_motion) = equations.solve(&gap_residual, &load_residual);
        for (q, dq) in forces.iter_mut().zip(&more_forces) {
            *q += dq;
        }
        for (y, dy) in motion.iter_mut().zip(&more_motion) {
            *y += dy;
        }
        Ok((forces, motion))
    }

    /// Returns the cell outside the active set whose gap without forces a free motion closes first.
    /// The motion is taken in the sense in which the load does work; without work, in either.
    /// `None` if it closes no gap.
    fn stop(&self, active: &[usize], motion: &[f64]) -> Option<usize> {
        let work = dot(&self.load, motion);
        let magnitude: f64 = self.load.iter().zip(motion).map(|(f, v)| (f * v).abs()).sum();
        let first = if work < 0.0 { -1.0 } else { 1.0 };
        let other = (work.abs() <= NO_WORK * magnitude).then_some(-first);
        [Some(first), other].into_iter().flatten().find_map(|sense| self.stop_in(active, motion, sense))
    }

    fn stop_in(&self, active: &[usize], motion: &[f64], sense: f64) -> Option<usize> {
        let closing = |i: usize| -sense * row_product(&self.arms, i, motion);
        let open = (0..self.cells()).filter(|i| active.binary_search(i).is_err());
        let fastest = open.clone().map(closing).fold(0.0, f64::max);
        let until = |i: usize| self.gaps[i] / closing(i);
        open.filter(|&i| closing(i) > RESISTS * fastest)
            .min_by(|&i, &j| until(i).total_cmp(&until(j)).then(i.cmp(&j)))
    }

    /// Returns the gaps of some cells.
    fn gaps(&self, cells: &[usize], active: &[usize], forces: &[f64], motion: &[f64]) -> Vec<f64> {
        let elastic = self.sums(cells, active, forces, |term| term);
        let gap = |(&i, elastic): (&usize, f64)| elastic + row_product(&self.arms, i, motion) + self.gaps[i];
        cells.iter().zip(elastic).map(gap).collect()
    }

    /// Returns for some cells the sum of a function of the deflections by the forces on the active
    /// cells. The function commutes with scaling by a power of two.
    fn sums(&self, cells: &[usize], active: &[usize], forces: &[f64], of: impl Fn(f64) -> f64) -> Vec<f64> {
        // The scales are powers of two, so that they can be factored out without rounding.
        let forces: Vec<(usize, f64)> =
            active.iter().zip(forces).map(|(&j, q)| (j, self.cell_scale[j] * q)).collect();
        let mut all = Vec::with_capacity(cells.len());
        // Several rows at a time, because each sum waits for its last addition.
        for cells in cells.chunks(ROWS) {
            let rows: [&[f64]; ROWS] = std::array::from_fn(|k| self.row(cells[k.min(cells.len() - 1)]));
            let mut sums = [0.0; ROWS];
            for &(j, q) in &forces {
                for (sum, row) in sums.iter_mut().zip(&rows) {
                    *sum += of(row[j] * q);
                }
            }
            all.extend(cells.iter().zip(sums).map(|(&i, sum)| self.cell_scale[i] * sum));
        }
        all
    }

    /// Returns the largest sum of magnitudes of the terms of an active cell's gap: the scale of
    /// overlaps.
    fn gap_scale(&self, active: &[usize], forces: &[f64], motion: &[f64]) -> f64 {
        let elastic = self.sums(active, active, forces, f64::abs);
        let scale = |(&i, elastic): (&usize, f64)| {
            let rigid: f64 = self.arms.row(i).iter().zip(motion).map(|(c, y)| (c * y).abs()).sum();
            elastic + rigid + self.gaps[i].abs()
        };
        active.iter().zip(elastic).map(scale).fold(0.0, f64::max)
    }

    /// Returns cells outside the active set that overlap beyond rounding, with their (negative)
    /// gaps.
    fn overlapping(&self, found: &Found) -> Vec<(usize, f64)> {
        let tolerance = self.gap_tolerance(found);
        self.open(found).filter(|&(_, gap)| gap < -tolerance).collect()
    }

    /// Returns the first of these cells that touches without belonging to the active set.
    fn touching(&self, found: &Found, cells: &[usize]) -> Option<usize> {
        let tolerance = self.gap_tolerance(found);
        self.open(found).find(|(i, gap)| *gap <= tolerance && cells.contains(i)).map(|(i, _)| i)
    }

    /// Returns the gaps of the cells outside the active set.
    fn open(&self, found: &Found) -> impl Iterator<Item = (usize, f64)> {
        let mut loaded = vec![false; self.cells()];
        for &i in &found.active {
            loaded[i] = true;
        }
        let cells: Vec<usize> = (0..self.cells()).filter(|&i| !loaded[i]).collect();
        let gaps = self.gaps(&cells, &found.active, &found.forces, &found.motion);
        cells.into_iter().zip(gaps)
    }

    fn gap_tolerance(&self, found: &Found) -> f64 {
        GAP_TOLERANCE * self.gap_scale(&found.active, &found.forces, &found.motion)
    }

    fn solution(
        &self,
        problem: &ContactProblem,
        found: Found,
        method: Method,
        iterations: usize,
    ) -> Solution {
        let mut forces = vec![0.0; self.cells()];
        for (&i, q) in found.active.iter().zip(&found.forces) {
            forces[i] = q * self.cell_scale[i];
        }
        let motion: Vec<f64> = found.motion.iter().zip(&self.dof_scale).map(|(y, s)| y * s).collect();
        let gaps = problem.gaps_at(&forces, &motion);
        let certificate = problem.certify(&forces, &motion);
        Solution { forces, motion, gaps, active: found.active, method, iterations, certificate }
    }
}

/// Transforms a motion to the units of the DOFs. The DOF that moves most in scaled units is named
/// and set to ±1.
pub(super) fn free_motion(scaled_motion: &[f64], dof_scale: &[f64]) -> FreeMotion {
    let dof = (0..scaled_motion.len())
        .max_by(|&k, &l| scaled_motion[k].abs().total_cmp(&scaled_motion[l].abs()).then(l.cmp(&k)))
        .unwrap_or(0);
    let own: Vec<f64> = scaled_motion.iter().zip(dof_scale).map(|(y, s)| y * s).collect();
    let size = own[dof].abs();
    FreeMotion { dof, direction: own[dof].signum(), motion: own.iter().map(|x| x / size).collect() }
}

/// Returns the force that counts as zero: relative to these forces or, if all are rounding, to the
/// force that closes a gap.
fn force_tolerance(scaled: &Scaled, forces: &[f64]) -> f64 {
    let largest = |values: &[f64]| values.iter().fold(0.0f64, |a, v| a.max(v.abs()));
    (FORCE_TOLERANCE * largest(forces)).max(1e-16 * largest(&scaled.gaps))
}

/// Block principal pivoting; `None` if it does not converge or reaches an active set that does not
/// determine all DOFs.
fn block_pivoting(
    scaled: &Scaled,
    start: Vec<usize>,
    iterations: &mut usize,
    interrupt: &Interrupt,
) -> Result<Option<Found>, ContactError> {
    let mut active = start;
    let mut fewest = usize::MAX;
    let mut patience = PATIENCE;
    let mut dependent = Vec::new();
    // Consecutive cells that were added to hold a motion.
    let mut stops = 0;
    loop {
        *iterations += 1;
        interrupt.check().map_err(ContactError::Interrupted)?;
        let (forces, motion) = match scaled.close(&active, interrupt) {
            Ok(closed) => closed,
            // A dependent cell matters only if it is loaded in the final solution.
            Err(Singular::Compliance(position)) => {
                dependent.push(active.remove(position));
                continue;
            }
            // All cells of a mesh were pulled, and its gears are free.
            Err(Singular::Dofs(motion)) => match scaled.stop(&active, &motion) {
                Some(cell) if stops < scaled.load.len() && !dependent.contains(&cell) => {
                    stops += 1;
                    active.push(cell);
                    active.sort_unstable();
                    continue;
                }
                _ => return Ok(None),
            },
            Err(Singular::Interrupted(error)) => return Err(ContactError::Interrupted(error)),
        };
        interrupt.check().map_err(ContactError::Interrupted)?;
        stops = 0;
        let tolerance = force_tolerance(scaled, &forces);
        let pulled: Vec<usize> =
            active.iter().zip(&forces).filter(|&(_, &q)| q < -tolerance).map(|(&i, _)| i).collect();
        let found = Found { active, forces, motion };
        let overlapping = scaled.overlapping(&found);
        let wrong = pulled.len() + overlapping.len();
        if wrong == 0 {
            return match scaled.touching(&found, &dependent) {
                Some(cell) => Err(ContactError::DependentCells { cell }),
                None => without_idle_cells(scaled, found, interrupt),
            };
        }
        if wrong < fewest {
            fewest = wrong;
            patience = PATIENCE;
        } else if patience == 0 {
            return Ok(None);
        } else {
            patience -= 1;
        }
        active = found.active;
        // Exchanges may alternate between two sets. Then pulled cells stay until no cell overlaps.
        if patience > PATIENCE / 2 || overlapping.is_empty() {
            active.retain(|i| pulled.binary_search(i).is_err());
        }
        active.extend(overlapping.iter().map(|&(i, _)| i));
        active.sort_unstable();
    }
}

/// Removes cells whose force is rounding from the active set, because their membership depends on
/// the start.
fn without_idle_cells(
    scaled: &Scaled,
    mut found: Found,
    interrupt: &Interrupt,
) -> Result<Option<Found>, ContactError> {
    loop {
        let tolerance = force_tolerance(scaled, &found.forces);
        let kept: Vec<usize> = found
            .active
            .iter()
            .zip(&found.forces)
            .filter(|&(_, &q)| q > tolerance)
            .map(|(&i, _)| i)
            .collect();
        if kept.len() == found.active.len() {
            return Ok(Some(found));
        }
        match scaled.close(&kept, interrupt) {
            Ok((forces, motion)) => found = Found { active: kept, forces, motion },
            Err(Singular::Interrupted(error)) => return Err(ContactError::Interrupted(error)),
            // Idle cells alone determine some DOF (its load vanishes): keep them, unloaded.
            Err(_) => {
                for q in found.forces.iter_mut().filter(|q| **q <= tolerance) {
                    *q = 0.0;
                }
                return Ok(Some(found));
            }
        }
    }
}

/// Primal active-set method from a feasible start; `None` at the limit of iterations.
fn single_pivoting(
    scaled: &Scaled,
    iterations: &mut usize,
    interrupt: &Interrupt,
) -> Result<Option<Found>, ContactError> {
    let n = scaled.cells();
    let (mut forces, mut active) = match balance(&scaled.arms, &scaled.stiffness, &scaled.load, interrupt) {
        Balance::Found { forces, cells } => (forces, cells),
        Balance::RunsAway(motion) => return Err(ContactError::Infeasible(scaled.free_motion(&motion))),
        Balance::Interrupted(error) => return Err(ContactError::Interrupted(error)),
    };
    // The active cells must determine every DOF; exchanges preserve this property.
    while let Some(motion) = null_motion(&scaled.resistance(active.iter().copied()), 1e-12) {
        let seen = |i: usize| row_product(&scaled.arms, i, &motion).abs();
        let Some(cell) = (0..n)
            .filter(|i| !active.contains(i))
            .max_by(|&i, &j| seen(i).total_cmp(&seen(j)).then(j.cmp(&i)))
        else {
            return Err(ContactError::Unconstrained(scaled.free_motion(&motion)));
        };
        active.push(cell);
        active.sort_unstable();
    }
    for _ in 0..10 * n + 100 {
        *iterations += 1;
        interrupt.check().map_err(ContactError::Interrupted)?;
        let (target, motion) = match scaled.close(&active, interrupt) {
            Ok(closed) => closed,
            Err(Singular::Compliance(position)) => {
                return Err(ContactError::DependentCells { cell: active[position] });
            }
            Err(Singular::Dofs(_)) => return Ok(None),
            Err(Singular::Interrupted(error)) => return Err(ContactError::Interrupted(error)),
        };
        let tolerance = force_tolerance(scaled, &target);
        // First cell whose force vanishes on the way to the target; ties by index.
        let blocking = active
            .iter()
            .zip(&target)
            .filter(|&(_, &t)| t < -tolerance)
            .map(|(&i, &t)| (forces[i].max(0.0) / (forces[i].max(0.0) - t), i))
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        if let Some((step, cell)) = blocking {
            for (&i, &t) in active.iter().zip(&target) {
                forces[i] += step * (t - forces[i]);
            }
            forces[cell] = 0.0;
            active.retain(|&i| i != cell);
            continue;
        }
        for (&i, &t) in active.iter().zip(&target) {
            forces[i] = t;
        }
        let found = Found { active, forces: target, motion };
        let overlapping = scaled.overlapping(&found);
        let Some(&(cell, _)) = overlapping.iter().min_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)))
        else {
            return without_idle_cells(scaled, found, interrupt);
        };
        active = found.active;
        active.push(cell);
        active.sort_unstable();
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use super::super::solver_tests::{Random, random_problem};
    use super::*;

    #[test]
    fn single_pivoting_ends_where_block_pivoting_does() {
        let mut random = Random(1618033988749895);
        for trial in 0..60 {
            let problem = random_problem(4 + trial % 30, trial % 4, trial % 3 == 0, &mut random);
            let reference = solve(&problem, None).unwrap();
            let scaled = Scaled::new(&problem);
            let found = single_pivoting(&scaled, &mut 0, &Interrupt::never()).unwrap().expect("it ends");
            let solution = scaled.solution(&problem, found, Method::SinglePivoting, 0);
            assert_eq!(solution.forces, reference.forces, "trial {trial}");
            assert_eq!(solution.motion, reference.motion, "trial {trial}");
        }
    }
}
