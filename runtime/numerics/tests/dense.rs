//! Dense operations with checkpoints.

use calyx_numerics::dense::*;
use faer::Mat;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Counts checkpoints and fails at the one with the number `last`.
fn counting(asked: &AtomicUsize, last: usize) -> impl Fn() -> Result<(), usize> + Sync {
    move || match asked.fetch_add(1, Relaxed) {
        number if number == last => Err(number),
        _ => Ok(()),
    }
}

#[test]
fn large_operations_have_checkpoints_and_equal_bits() {
    let n = 1200;
    let matrix = Mat::from_fn(n, n, |i, j| if i == j { 2.0 } else { (-0.01 * i.abs_diff(j) as f64).exp() });
    let (asked, never) = (AtomicUsize::new(0), usize::MAX);
    let checkpoint = counting(&asked, never);
    let pieces = Interruptible(&checkpoint);
    let checkpoints = || asked.swap(0, Relaxed);
    let factor = pieces.cholesky(matrix.clone()).unwrap().unwrap();
    assert!(checkpoints() > 20);
    assert!(factor == cholesky(matrix.clone()).unwrap());
    let inverse = pieces.solve(factor.as_ref(), Mat::identity(n, n)).unwrap();
    assert!(checkpoints() > 20);
    assert!(inverse == solve(factor.as_ref(), Mat::identity(n, n)));
    let square = pieces.product(matrix.as_ref(), inverse.as_ref()).unwrap();
    assert!(checkpoints() > 20);
    assert!(square == product(matrix.as_ref(), inverse.as_ref()));
}

#[test]
fn the_error_of_any_checkpoint_ends_the_operation() {
    let n = 600;
    let matrix = Mat::from_fn(n, n, |i, j| if i == j { 2.0 } else { 0.5 });
    let asked = AtomicUsize::new(0);
    let whole = counting(&asked, usize::MAX);
    Interruptible(&whole).cholesky(matrix.clone()).unwrap().unwrap();
    let all = asked.load(Relaxed);
    for last in [0, 1, all / 2, all - 1] {
        let asked = AtomicUsize::new(0);
        let ended = counting(&asked, last);
        assert_eq!(Interruptible(&ended).cholesky(matrix.clone()).err(), Some(last));
    }
}
