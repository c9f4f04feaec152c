//! Initial active set from a coarse contact problem.
//!
//! A group of neighbouring cells of a slice with equal forces is one unknown of the coarse problem;
//! its compliance, gaps and arms are averages of the fine ones. The coarse problem has a quarter of
//! the unknowns, so its cost is small compared with the factorization that a good initial set
//! saves. The bits of the solution do not depend on the initial set.

use super::grid::Grid;
use crate::active_set::estimate;
use crate::problem::ContactProblem;
use calyx_numerics::interrupt::Interrupt;

/// Number of cells of a slice in a group.
const BLOCK: usize = 4;
/// Number of cells below which the problem is solved directly.
const WORTH_IT: usize = 150;

/// Returns an initial active set for [`crate::active_set::solve_until`]; `grids` are those
/// of the problem's patches, in order. Empty if there is none.
pub fn first_guess(problem: &ContactProblem, grids: &[&Grid], interrupt: &Interrupt) -> Vec<usize> {
    let (n, m) = (problem.cells(), problem.dofs());
    let mut blocks: Vec<std::ops::Range<usize>> = Vec::new();
    let mut weights = Vec::with_capacity(n);
    for grid in grids {
        let first = weights.len();
        for slice in &grid.slices {
            let mut from = slice.cells.start;
            while from < slice.cells.end {
                let to = (from + BLOCK).min(slice.cells.end);
                let area: f64 = grid.cells[from..to].iter().map(|cell| cell.area()).sum();
                weights.extend(grid.cells[from..to].iter().map(|cell| cell.area() / area));
                blocks.push(first + from..first + to);
                from = to;
            }
        }
    }
    // Entries after the cells of the grids, such as stops of bearings, are not grouped.
    while weights.len() < n {
        blocks.push(weights.len()..weights.len() + 1);
        weights.push(1.0);
    }
    if weights.len() != n || n < WORTH_IT || problem.compliance.len() != n * n {
        return Vec::new();
    }
    let count = blocks.len();
    let mut compliance = vec![0.0; count * count];
    for (a, rows) in blocks.iter().enumerate() {
        for (b, columns) in blocks.iter().enumerate().skip(a) {
            let mut sum = 0.0;
            for i in rows.clone() {
                let row = &problem.compliance[i * n..(i + 1) * n];
                let seen: f64 = columns.clone().map(|j| weights[j] * row[j]).sum();
                sum += weights[i] * seen;
            }
            compliance[a * count + b] = sum;
            compliance[b * count + a] = sum;
        }
    }
    let average = |values: &[f64], stride: usize, k: usize| -> Vec<f64> {
        blocks.iter().map(|block| block.clone().map(|i| weights[i] * values[i * stride + k]).sum()).collect()
    };
    let columns: Vec<Vec<f64>> = (0..m).map(|k| average(&problem.arms, m, k)).collect();
    let coarse = ContactProblem {
        compliance,
        arms: (0..count * m).map(|entry| columns[entry % m][entry / m]).collect(),
        gaps: average(&problem.gaps, 1, 0),
        stiffness: problem.stiffness.clone(),
        load: problem.load.clone(),
    };
    // Errors are reported by the solution of the problem itself.
    estimate(&coarse, interrupt).into_iter().flat_map(|block| blocks[block].clone()).collect()
}
