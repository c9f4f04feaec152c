//! Parallel computation of the parts of a value.

use calyx_numerics::parallel::{try_map, while_all_are_busy};
use std::collections::BTreeSet;
use std::thread::{self, ThreadId};
use std::time::Duration;

/// Returns the threads that compute parts.
fn threads() -> BTreeSet<String> {
    let compute = |_: &u32| {
        thread::sleep(Duration::from_millis(1));
        Ok::<ThreadId, ()>(thread::current().id())
    };
    let found = try_map(&[0; 400], compute).expect("no part fails");
    found.into_iter().map(|thread| format!("{thread:?}")).collect()
}

#[test]
fn one_thread_computes_all_parts_while_the_others_are_busy() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads");
    pool.install(|| {
        assert_eq!(while_all_are_busy(threads).len(), 1);
        assert!(threads().len() > 1);
        let panics = std::panic::catch_unwind(|| while_all_are_busy(|| panic!("while busy")));
        assert!(panics.is_err());
        assert!(threads().len() > 1, "after a panic");
    });
}

#[test]
fn errors_are_returned() {
    let fails = |&item: &u32| if item == 3 { Err(item) } else { Ok(item) };
    assert_eq!(try_map(&[1, 2, 3, 4], fails), Err(3));
    assert_eq!(while_all_are_busy(|| try_map(&[1, 2], fails)), Ok(vec![1, 2]));
}
