//! Static condensation of a mesh: what its loads do to themselves, to its cuts and to the recovered stresses.
//!
//! The report's equations 2.69 to 2.89 with `h` the amplitudes of given load vectors and `delta` the work-conjugate
//! displacements, so that `B = A^T`; condensed, they keep that symmetry.

use super::StructureError;
use super::dense::{add_product, cholesky, mirror_lower, product, solve};
use super::ring::CutStiffness;
use crate::fe::{Constraints, PlaneModel, Solver, SparseVector};
use crate::interrupt::Interrupt;
use crate::material::Material;
use faer::{Mat, MatRef};
use rayon::prelude::*;
use std::collections::{BTreeSet, HashMap};

/// Right-hand sides solved at once. Fixed, so that the arithmetic does not depend on the number of threads.
const COLUMNS_AT_ONCE: usize = 32;

/// How the mesh is held.
pub(super) enum Support<'a> {
    /// Nodes that do not move.
    Held(&'a [usize]),
    /// Not at all: loads are balanced by forces distributed like inertia, which load pairs in equilibrium do not feel.
    Free,
}

/// Nodes of the two cuts of a sector, in the same order.
pub(super) struct Cuts {
    pub first: Vec<usize>,
    pub last: Vec<usize>,
    /// By which the last cut is turned against the first, rad.
    pub angle: f64,
}

/// A mesh condensed onto its cuts; `m` loads, `q` rows, `c` unknowns of both cuts.
pub(super) struct Condensed {
    /// `c` by `c`; `None` without cuts.
    pub stiffness: Option<CutStiffness>,
    /// Forces on the cuts that equal each load, `c` by `m`.
    pub on_cuts: Mat<f64>,
    /// Displacements of the loads by the loads with the cuts held, `m` by `m`, symmetric.
    pub own: Mat<f64>,
    /// Rows by loads with the cuts held, `q` by `m`.
    pub rows_own: Mat<f64>,
    /// Rows by displacements of the cuts, `q` by `c`.
    pub rows_cuts: Mat<f64>,
}

/// Condenses a model, with a checkpoint between its stages and before each portion of right-hand sides. `rows` are linear forms of its displacements that vanish for rigid-body motions.
pub(super) fn condense(
    model: &PlaneModel,
    support: &Support<'_>,
    cuts: Option<&Cuts>,
    loads: &[SparseVector],
    rows: &[SparseVector],
    interrupt: &Interrupt,
) -> Result<Condensed, StructureError> {
    let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
    let dofs = model.dof_count();
    let stiffness = model.stiffness();
    checkpoint()?;
    let masters: Vec<usize> = cuts
        .map(|cuts| cuts.first.iter().chain(&cuts.last).flat_map(|&node| [2 * node, 2 * node + 1]).collect())
        .unwrap_or_default();

    let mut constraints = Constraints::new();
    for &dof in &masters {
        constraints.prescribe(dof, 0.0);
    }
    let mut load = columns(dofs, loads);
    match support {
        Support::Held(nodes) => {
            for &node in *nodes {
                constraints.fix_node(node);
            }
        }
        Support::Free => {
            balance(model, &mut load)?;
            for dof in determinate_support(model) {
                constraints.prescribe(dof, 0.0);
            }
        }
    }
    let solver = Solver::new(&stiffness, constraints)?;
    let response = solve_columns(&solver, load.as_ref(), interrupt)?;

    // Displacements of the whole mesh by unit displacements of each cut unknown (`D` of report eq. 2.76), the last
    // cut's in the frame of the next sector.
    let column_of: HashMap<usize, usize> = masters.iter().enumerate().map(|(i, &dof)| (dof, i)).collect();
    let mut coupling = Mat::zeros(dofs, masters.len());
    for entry in stiffness.triplet_iter() {
        if let Some(&column) = column_of.get(&entry.col) {
            coupling[(entry.row, column)] = -*entry.val;
        }
    }
    let mut extension = solve_columns(&solver, coupling.as_ref(), interrupt)?;
    for (column, &dof) in masters.iter().enumerate() {
        extension[(dof, column)] = 1.0;
    }

    let condensed_stiffness = cuts.map(|cuts| {
        let mut matrix = Mat::zeros(masters.len(), masters.len());
        for column in 0..masters.len() {
            for (row, &dof) in masters.iter().enumerate() {
                // K is symmetric: its column is its row.
                let in_column = stiffness.row_idx_of_col(dof).zip(stiffness.val_of_col(dof));
                matrix[(row, column)] =
                    in_column.map(|(other, value)| value * extension[(other, column)]).sum();
            }
        }
        turn_last_cut(&mut matrix, cuts.angle);
        matrix = matrix.transpose().to_owned();
        turn_last_cut(&mut matrix, cuts.angle);
        CutStiffness::new(matrix)
    });
    if let Some(cuts) = cuts {
        turn_last_cut(&mut extension, cuts.angle);
    }

    checkpoint()?;
    let mut own = product(load.transpose(), response.as_ref());
    mirror_lower(&mut own);
    checkpoint()?;
    let on_cuts = product(extension.transpose(), load.as_ref());
    checkpoint()?;
    Ok(Condensed {
        stiffness: condensed_stiffness,
        on_cuts,
        own,
        rows_own: rows_of(rows, response.as_ref()),
        rows_cuts: rows_of(rows, extension.as_ref()),
    })
}

/// Orders the nodes of the last cut as those of the first one, turned by `angle`; nodes in `held` belong to neither.
pub(super) fn match_cuts(
    nodes: &[[f64; 2]],
    first: &[usize],
    last: &[usize],
    held: &[usize],
    angle: f64,
) -> Option<Cuts> {
    let held: BTreeSet<usize> = held.iter().copied().collect();
    let free = |cut: &[usize]| cut.iter().copied().filter(|node| !held.contains(node)).collect::<Vec<_>>();
    let (first, mut rest) = (free(first), free(last));
    if first.len() != rest.len() || first.is_empty() {
        return None;
    }
    let size = nodes.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max);
    let (sin, cos) = angle.sin_cos();
    let mut ordered = Vec::with_capacity(rest.len());
    for &node in &first {
        let [x, y] = nodes[node];
        let target = [cos * x - sin * y, sin * x + cos * y];
        let gap = |other: usize| (nodes[other][0] - target[0]).hypot(nodes[other][1] - target[1]);
        let found = rest.iter().position(|&other| gap(other) <= 1e-8 * size)?;
        ordered.push(rest.swap_remove(found));
    }
    Some(Cuts { first, last: ordered, angle })
}

/// Replaces the columns of the last cut, half of them, by those of displacements given in a frame turned by `angle`.
fn turn_last_cut(matrix: &mut Mat<f64>, angle: f64) {
    let (sin, cos) = angle.sin_cos();
    for column in (matrix.ncols() / 2..matrix.ncols()).step_by(2) {
        for row in 0..matrix.nrows() {
            let (x, y) = (matrix[(row, column)], matrix[(row, column + 1)]);
            matrix[(row, column)] = cos * x + sin * y;
            matrix[(row, column + 1)] = cos * y - sin * x;
        }
    }
}

fn columns(dofs: usize, vectors: &[SparseVector]) -> Mat<f64> {
    let mut matrix = Mat::zeros(dofs, vectors.len());
    for (column, vector) in vectors.iter().enumerate() {
        for &(dof, value) in &vector.entries {
            matrix[(dof, column)] = value;
        }
    }
    matrix
}

fn rows_of(rows: &[SparseVector], displacements: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(rows.len(), displacements.ncols(), |row, column| {
        rows[row].entries.iter().map(|&(dof, value)| value * displacements[(dof, column)]).sum()
    })
}

/// Solves all columns, in fixed portions side by side.
fn solve_columns(
    solver: &Solver,
    right: MatRef<'_, f64>,
    interrupt: &Interrupt,
) -> Result<Mat<f64>, StructureError> {
    let starts: Vec<usize> = (0..right.ncols()).step_by(COLUMNS_AT_ONCE).collect();
    let portions = starts
        .par_iter()
        .map(|&start| {
            interrupt.check().map_err(StructureError::Interrupted)?;
            Ok(solver.solve(right.subcols(start, COLUMNS_AT_ONCE.min(right.ncols() - start)))?)
        })
        .collect::<Result<Vec<_>, StructureError>>()?;
    let mut solution = Mat::zeros(right.nrows(), right.ncols());
    for (&start, portion) in starts.iter().zip(&portions) {
        solution.as_mut().subcols_mut(start, portion.ncols()).copy_from(portion);
    }
    Ok(solution)
}

/// Adds to each load the inertia forces of the rigid-body acceleration it would cause: balanced loads remain as they are.
fn balance(model: &PlaneModel, loads: &mut Mat<f64>) -> Result<(), StructureError> {
    // Any positive density distributes the forces alike.
    let unit = Material { density: 1.0, ..model.material };
    let mass = PlaneModel { material: unit, ..model.clone() }.mass();
    let modes = model.rigid_body_modes();
    let mut forces = Mat::<f64>::zeros(model.dof_count(), 3);
    for entry in mass.triplet_iter() {
        for (mode, motion) in modes.iter().enumerate() {
            forces[(entry.row, mode)] += *entry.val * motion[entry.col];
        }
    }
    let motions = Mat::from_fn(model.dof_count(), 3, |row, mode| modes[mode][row]);
    let inertia = product(motions.transpose(), forces.as_ref());
    let factor = cholesky(inertia).ok_or(StructureError::NoArea)?;
    // Twice: the second pass removes what rounding left of the first.
    for _ in 0..2 {
        let acceleration = solve(factor.as_ref(), product(motions.transpose(), loads.as_ref()));
        add_product(loads.as_mut(), -1.0, forces.as_ref(), acceleration.as_ref());
    }
    Ok(())
}

/// Three degrees of freedom that hold the mesh without straining it: a node, and across the line to the farthest one.
fn determinate_support(model: &PlaneModel) -> [usize; 3] {
    let nodes = &model.mesh.nodes;
    let distance = |node: usize| (nodes[node][0] - nodes[0][0]).hypot(nodes[node][1] - nodes[0][1]);
    let far =
        (0..nodes.len()).fold(0, |best, node| if distance(node) > distance(best) { node } else { best });
    let [dx, dy] = [0, 1].map(|axis| (nodes[far][axis] - nodes[0][axis]).abs());
    [0, 1, 2 * far + usize::from(dx > dy)]
}
