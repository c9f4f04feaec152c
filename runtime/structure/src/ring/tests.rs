//! Tests of doubling against the block-circulant solution and against the uncondensed ring.

use super::*;
use crate::dense::{add_product, cholesky, solve};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::c64;
use faer::linalg::solvers::Solve;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Repeatable pseudorandom numbers in -1 ..= 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn matrix(&mut self, rows: usize, columns: usize) -> Mat<f64> {
        Mat::from_fn(rows, columns, |_, _| self.next())
    }
}

/// Returns a positive definite matrix with one nearly free direction, as of a thin rim.
fn stiffness(size: usize, constraint_stiffness: f64, numbers: &mut Numbers) -> Mat<f64> {
    let factor = numbers.matrix(size, size - 1);
    let mut matrix = Mat::zeros(size, size);
    add_product(matrix.as_mut(), 1.0, factor.as_ref(), factor.transpose());
    for i in 0..size {
        matrix[(i, i)] += constraint_stiffness;
    }
    mirror_lower(&mut matrix);
    matrix
}

fn difference(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> f64 {
    (a - b).norm_max() / b.norm_max()
}

/// Returns the displacements of the cuts of sector `offset` by the discrete Fourier transform of
/// the ring.
fn block_circulant(sector: &CutStiffness, sectors: u32, offset: u32) -> Mat<f64> {
    let n = sector.cut_size();
    let mut displacement = Mat::<f64>::zeros(2 * n, 2 * n);
    for harmonic in 0..sectors {
        let turn = |steps: u32| {
            let steps = u64::from(steps) * u64::from(harmonic) % u64::from(sectors);
            let angle = TAU * steps as f64 / f64::from(sectors);
            c64::new(angle.cos(), angle.sin())
        };
        // Cut i is the first of sector i and the last of sector i - 1; u_i = exp(2 pi i harmonic /
        // N) amplitude.
        let stiffness = Mat::<c64>::from_fn(n, n, |i, j| {
            let real = sector.block(0, 0)[(i, j)] + sector.block(1, 1)[(i, j)];
            c64::new(real, 0.0)
                + turn(1) * sector.block(0, 1)[(i, j)]
                + turn(1).conj() * sector.block(1, 0)[(i, j)]
        });
        let inverse = stiffness.partial_piv_lu().solve(Mat::<c64>::identity(n, n));
        for (row, cut_row) in [offset, offset + 1].into_iter().enumerate() {
            for (column, cut_column) in [0, 1].into_iter().enumerate() {
                let phase = turn(cut_row) * turn(cut_column).conj();
                for j in 0..n {
                    for i in 0..n {
                        displacement[(row * n + i, column * n + j)] +=
                            (phase * inverse[(i, j)]).re / f64::from(sectors);
                    }
                }
            }
        }
    }
    displacement
}

#[test]
fn doubling_agrees_with_the_block_circulant_solution() {
    let mut numbers = Numbers(7);
    let sector = CutStiffness::new(stiffness(12, 1e-3, &mut numbers));
    for sectors in [1, 2, 3, 7, 20, 64, 640] {
        let ring = RingFlexibility::new(&sector, sectors, 3, &Interrupt::never()).unwrap();
        assert_eq!(ring.window(), 3.min(sectors / 2));
        let scale = ring.at(0).norm_max();
        for offset in 0..=ring.window() {
            let other = block_circulant(&sector, sectors, offset);
            let error = (ring.at(offset) - &other).norm_max() / scale;
            assert!(error < 1e-9, "{sectors} sectors, offset {offset}: {error:.1e}");
        }
    }
}

#[test]
fn condensed_ring_agrees_with_the_whole_one() {
    // A sector of 6 inner and twice 4 cut unknowns, with two loads inside it.
    let (inner, n, loads) = (6, 4, 2);
    let mut numbers = Numbers(3);
    let whole_sector = stiffness(inner + 2 * n, 1e-2, &mut numbers);
    let load = numbers.matrix(inner, loads);
    let block = |r: usize, c: usize, h: usize, w: usize| whole_sector.as_ref().submatrix(r, c, h, w);

    let factor = cholesky(block(0, 0, inner, inner).to_owned()).unwrap();
    let carried = solve(factor.as_ref(), block(0, inner, inner, 2 * n).to_owned());
    let mut condensed = block(inner, inner, 2 * n, 2 * n).to_owned();
    add_product(condensed.as_mut(), -1.0, block(inner, 0, 2 * n, inner), carried.as_ref());
    let on_cuts = -(carried.transpose() * &load);
    let own = load.transpose() * solve(factor.as_ref(), load.clone());

    for sectors in [1_u32, 2, 3, 4, 5, 9] {
        let count = sectors as usize;
        let ring =
            RingFlexibility::new(&CutStiffness::new(condensed.clone()), sectors, 3, &Interrupt::never())
                .unwrap();
        // The whole ring: the inner unknowns of every sector, then the cuts.
        let size = count * (inner + n);
        let mut ring_stiffness = Mat::<f64>::zeros(size, size);
        for sector in 0..count {
            let place = |i: usize| {
                if i < inner {
                    sector * inner + i
                } else {
                    let cut = (sector + (i - inner) / n) % count;
                    count * inner + cut * n + (i - inner) % n
                }
            };
            for j in 0..inner + 2 * n {
                for i in 0..inner + 2 * n {
                    ring_stiffness[(place(i), place(j))] += whole_sector[(i, j)];
                }
            }
        }
        let mut right = Mat::zeros(size, loads);
        right.as_mut().submatrix_mut(0, 0, inner, loads).copy_from(&load);
        let whole = solve(cholesky(ring_stiffness).unwrap().as_ref(), right);
        for offset in 0..=ring.window() {
            let direct =
                load.transpose() * whole.as_ref().submatrix(offset as usize * inner, 0, inner, loads);
            let mut through_cuts = on_cuts.transpose() * ring.at(offset) * &on_cuts;
            if offset == 0 {
                through_cuts += &own;
            }
            let error = difference(through_cuts.as_ref(), direct.as_ref());
            assert!(error < 1e-10, "{sectors} sectors, offset {offset}: {error:.1e}");
        }
    }
}

#[test]
fn a_free_ring_is_refused() {
    // Springs between equal ends: the ring has a rigid-body motion.
    let spring = Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { -1.0 });
    assert_eq!(
        RingFlexibility::new(&CutStiffness::new(spring), 8, 3, &Interrupt::never()).err(),
        Some(UnrestrainedRing.into())
    );
}

/// Cuts with many degrees of freedom have checkpoints within each joining, and the error of any
/// checkpoint ends the computation.
#[test]
fn large_cuts_have_checkpoints_within_a_joining() {
    let n = 300;
    let sector = CutStiffness::new(Mat::from_fn(2 * n, 2 * n, |row, column| match row == column {
        true => 4.0,
        false => (-0.1 * row.abs_diff(column) as f64).exp() * 0.1,
    }));
    let joined = |last: usize| {
        let asked = Arc::new(AtomicUsize::new(0));
        let counter = asked.clone();
        let interrupt = Interrupt::new(move || match counter.fetch_add(1, Relaxed) {
            number if number >= last => Err(EngineError::new("E0704", "enough", "")),
            _ => Ok(()),
        });
        (RingFlexibility::new(&sector, 8, 2, &interrupt), asked.load(Relaxed))
    };
    let (whole, all) = joined(usize::MAX);
    assert!(whole.is_ok());
    // Five joinings and one inversion.
    assert!(all > 60, "{all} checkpoints");
    for last in [0, 1, 7, all / 2, all - 1] {
        let (ended, _) = joined(last);
        assert!(matches!(ended, Err(StructureError::Interrupted(_))), "checkpoint {last} of {all}");
    }
}
