//! Complex linear systems: residuals of the direct solution, and the iterative one against it.

use calyx_numerics::complex::{ComplexLu, solve_complex, solve_iteratively};
use faer::{Mat, MatMut, MatRef, c64};

/// Diagonally dominant matrix without symmetry, with rows in another order.
fn matrix(size: usize) -> Mat<c64> {
    Mat::from_fn(size, size, |i, j| {
        let near = 1.0 / (1.0 + (i as f64 - j as f64).powi(2));
        let own = if i == j { c64::new(3.0 + i as f64, -1.0) } else { c64::new(0.0, 0.0) };
        own + c64::new(0.4 * near, 0.3 * near * (i + 2 * j) as f64 / size as f64)
    })
}

fn right(size: usize) -> Mat<c64> {
    Mat::from_fn(size, 1, |i, _| c64::new((i as f64).sin(), (2.0 * i as f64).cos()))
}

#[test]
fn factors_with_row_exchanges_solve_a_system() {
    let size = 40;
    let ordered = matrix(size);
    let exchanged = Mat::from_fn(size, size, |i, j| ordered[((i * 7) % size, j)]);
    let found = solve_complex(exchanged.clone(), right(size)).expect("a regular matrix");
    let residual = (&exchanged * &found - right(size)).norm_l2();
    assert!(residual < 1e-13 * right(size).norm_l2(), "{residual:e}");
    assert!(solve_complex(Mat::zeros(3, 3), right(3)).is_none());
    let mut transposed = right(size);
    ComplexLu::new(exchanged.clone()).solve_transpose_in_place(transposed.as_mut());
    let residual = (exchanged.transpose() * &transposed - right(size)).norm_l2();
    assert!(residual < 1e-13 * right(size).norm_l2(), "{residual:e}");
}

#[test]
fn the_iterative_solution_is_the_direct_one() {
    let size = 60;
    let whole = matrix(size);
    let apply = |from: MatRef<'_, c64>, mut to: MatMut<'_, c64>| to.copy_from(&whole * from);
    let scale = |from: MatRef<'_, c64>, mut to: MatMut<'_, c64>| {
        for i in 0..size {
            to[(i, 0)] = from[(i, 0)] / whole[(i, i)];
        }
    };
    let found = solve_iteratively(&apply, &scale, right(size).as_ref(), (1e-12, 50)).expect("convergence");
    let expected = solve_complex(whole.clone(), right(size)).expect("a regular matrix");
    let error = (&found - &expected).norm_l2() / expected.norm_l2();
    assert!(error < 1e-11, "{error:e}");
    assert!(solve_iteratively(&apply, &scale, right(size).as_ref(), (1e-12, 1)).is_none());
}
