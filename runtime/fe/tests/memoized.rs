//! Tests of functions that store their values.

use calyx_fe::memoized::Memoized;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

#[test]
fn clones_evaluate_each_parameter_once() {
    let evaluations = Arc::new(AtomicUsize::new(0));
    let counted = Arc::clone(&evaluations);
    let square = Memoized::new(move |x| {
        counted.fetch_add(1, Ordering::Relaxed);
        x * x
    });
    let other = square.clone();
    assert_eq!([square.at(3.0), other.at(3.0), other.at(2.0), square.at(2.0)], [9.0, 9.0, 4.0, 4.0]);
    assert_eq!(evaluations.load(Ordering::Relaxed), 2);
}
