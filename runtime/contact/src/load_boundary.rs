//! Boundary of the loaded zone between cell edges, for tangent stiffnesses.
//!
//! The load of a patch moves its boundary continuously, but the active set changes by whole cells.
//! A stiffness with the active set alone jumps with every cell that joins or leaves it, by up to
//! 1 % on usual grids. The ratio of the pressures of the two outermost cells shows where between
//! cell edges the boundary lies, because pressure vanishes with the square root of the distance
//! from it. The stiffness is interpolated between the active sets with and without the outermost
//! cell accordingly.

use calyx_numerics::dense::Interruptible;
use faer::Mat;
use std::ops::Range;

/// Coefficients of the participation of an outermost cell and its outer neighbour, a polynomial in
/// the ratio of the outermost pressure to the one before it. It was found from the boundary of a
/// wide Hertzian contact at random locations on a lattice of equal cells; the first coefficient is
/// 1/2 and the polynomial is 3/2 at the largest ratio, so the stiffness is continuous while cells
/// join. The part of 0.1145 cells by which a row of cells of uniform pressures behaves as a
/// narrower rigid punch is included.
const PARTICIPATION: [f64; 3] = [0.5, 0.95, 0.48];
/// Bounds of the participation of both cells together.
const PARTICIPATIONS: [f64; 2] = [0.5, 1.5];

/// Returns the participation of the cells of a patch in its stiffness, from 0 to 1. `rows` are rows
/// of cells across the contact, `pressures` those of all cells, Pa, and `is_active` states whether
/// a cell is in the active set. Rows end abruptly where surfaces do: there cells participate fully.
pub fn participations(
    rows: impl IntoIterator<Item = Range<usize>>,
    pressures: &[f64],
    is_active: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let mut participations: Vec<f64> =
        (0..pressures.len()).map(|cell| f64::from(u8::from(is_active(cell)))).collect();
    for row in rows {
        let cells: Vec<usize> = row.collect();
        for forward in [true, false] {
            let at = |k: usize| cells[if forward { k } else { cells.len() - 1 - k }];
            for k in 1..cells.len() {
                let (before, outermost) = (at(k - 1), at(k));
                let next = (k + 1 < cells.len()).then(|| at(k + 1));
                let is_outermost = is_active(before) && is_active(outermost) && !next.is_some_and(&is_active);
                let ratio = pressures[outermost] / pressures[before];
                // Pressure that grows outwards does not vanish with the distance from a boundary.
                if !is_outermost || !(0.0..1.0).contains(&ratio) {
                    continue;
                }
                let [constant, linear, quadratic] = PARTICIPATION;
                let both = (constant + ratio * (linear + ratio * quadratic))
                    .clamp(PARTICIPATIONS[0], PARTICIPATIONS[1]);
                participations[outermost] = both.min(1.0);
                if let Some(next) = next {
                    participations[next] = (both - 1.0).max(participations[next]);
                }
            }
        }
    }
    participations
}

/// Returns what is added to the diagonal of the static compliance matrix for cells that participate
/// in part (participations above 0): then the stiffness of all cells is interpolated linearly
/// between those with and without each of them. `None` if the matrix is not positive definite.
///
/// # Errors
/// Those of the checkpoints.
pub fn added_compliances<C, E>(
    compliance: &Mat<f64>,
    participations: &[f64],
    dense: Interruptible<'_, C>,
) -> Result<Option<Vec<f64>>, E>
where
    C: Fn() -> Result<(), E> + Sync,
    E: Send,
{
    let mut added = vec![0.0; participations.len()];
    let partial: Vec<usize> = (0..participations.len()).filter(|&cell| participations[cell] < 1.0).collect();
    if partial.is_empty() {
        return Ok(Some(added));
    }
    let Some(factor) = dense.cholesky(compliance.clone())? else { return Ok(None) };
    let units = Mat::from_fn(participations.len(), partial.len(), |row, column| {
        f64::from(u8::from(row == partial[column]))
    });
    let solved = dense.solve_lower(factor.as_ref(), units)?;
    for (column, &cell) in partial.iter().enumerate() {
        // Force on the cell per unit displacement of it alone.
        let stiffness: f64 = solved.col(column).iter().map(|part| part * part).sum();
        added[cell] = (participations[cell].recip() - 1.0) / stiffness;
    }
    Ok(Some(added))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::active_set::solve;
    use crate::problem::ContactProblem;
    use crate::solver_tests::Random;
    use calyx_structure::half_plane::HalfPlane;
    use std::f64::consts::PI;

    /// E' of the half-plane, Pa, and its reference length in cells.
    const MODULUS: f64 = 1.0;
    const REFERENCE: f64 = 400.0;

    /// Returns the errors of the boundary that a tangent stiffness implies, in cells: of the active
    /// set alone, and with participations. A parabola presses on a lattice of unit cells; its
    /// half-width and the offset of its vertex are in cells. The incremental contact is a flat
    /// punch of the loaded width `w`, whose compliance is `2/(pi E') ln(4 L/w)`.
    fn boundary_errors(half_width: f64, offset: f64) -> [f64; 2] {
        let reach = half_width.ceil() as i32 + 3;
        let centers: Vec<f64> = (-reach..=reach).map(f64::from).collect();
        let ends = |center: f64| [center - 0.5, center + 0.5];
        let body = HalfPlane { surface_modulus: MODULUS, reference_length: REFERENCE };
        let n = centers.len();
        // Average of x^2/2 over a cell.
        let gap = |center: &f64| 0.5 * (center - offset).powi(2) + 1.0 / 24.0;
        let problem = ContactProblem {
            compliance: (0..n * n)
                .map(|k| body.cell_compliance(ends(centers[k / n]), ends(centers[k % n])))
                .collect(),
            arms: vec![1.0; n],
            gaps: centers.iter().map(gap).collect(),
            stiffness: vec![0.0],
            load: vec![-0.25 * PI * MODULUS * half_width.powi(2)],
        };
        let solution = solve(&problem, None).expect("it is well posed");
        let is_active = |cell: usize| solution.active.contains(&cell);
        let alone: Vec<f64> = (0..n).map(|cell| f64::from(u8::from(is_active(cell)))).collect();
        let participations = participations(std::iter::once(0..n), &solution.forces, is_active);
        [alone, participations].map(|participations| {
            let cells: Vec<usize> = (0..n).filter(|&cell| participations[cell] > 0.0).collect();
            let of_cells: Vec<f64> = cells.iter().map(|&cell| participations[cell]).collect();
            let mut compliance =
                Mat::from_fn(cells.len(), cells.len(), |i, j| problem.compliance[cells[i] * n + cells[j]]);
            let checkpoint = || Ok::<(), ()>(());
            let dense = Interruptible(&checkpoint);
            let added = added_compliances(&compliance, &of_cells, dense).expect("no interrupt");
            for (cell, added) in added.expect("it is definite").into_iter().enumerate() {
                compliance[(cell, cell)] += added;
            }
            let factor = dense.cholesky(compliance).expect("no interrupt").expect("it is definite");
            let ones = Mat::from_fn(cells.len(), 1, |_, _| 1.0);
            let solved = dense.solve_lower(factor.as_ref(), ones).expect("no interrupt");
            let stiffness: f64 = solved.col(0).iter().map(|part| part * part).sum();
            let width = 4.0 * REFERENCE * (-0.5 * PI * MODULUS / stiffness).exp();
            0.5 * width - half_width
        })
    }

    #[test]
    fn stiffness_follows_the_boundary_between_cells() {
        let mut random = Random(0x5eed);
        let (mut alone, mut interpolated) = (0.0_f64, 0.0_f64);
        for _ in 0..200 {
            let [one, other] = boundary_errors(7.0 + 4.0 * random.next(), 0.5 * random.next());
            alone = alone.max(one.abs());
            interpolated = interpolated.max(other.abs());
        }
        assert!(alone > 0.4 && interpolated < 0.07, "{alone} {interpolated}");
    }

    #[test]
    fn rows_end_where_surfaces_do() {
        // Pressure grows towards the right end of the row.
        let all = participations(std::iter::once(0..4), &[1.0, 2.0, 3.0, 4.0], |_| true);
        assert_eq!(all[1..], [1.0, 1.0, 1.0]);
        assert!((0.5..=1.0).contains(&all[0]), "{all:?}");
        // Each row has boundaries of its own; single cells participate fully.
        let rows = participations([0..2, 2..4], &[1.0, 0.0, 5.0, 0.0], |cell| cell % 2 == 0);
        assert_eq!(rows, [1.0, 0.0, 1.0, 0.0]);
    }
}
