//! Meshes that were generated without an error in this process, by their content.
//!
//! A check generates the mesh of a gear to find errors, and drops it. The cases of a sweep, the
//! instances of a module and the keystrokes in an editor have the same gears again and again.

use calyx_runtime::cache::Key;
use std::collections::HashSet;
use std::sync::{LazyLock, Mutex, PoisonError};

/// Largest number of meshes that are remembered; then all are forgotten.
const MOST: usize = 4096;

static ACCEPTED: LazyLock<Mutex<HashSet<Key>>> = LazyLock::new(Mutex::default);

/// Runs a check of a mesh unless one with this content has succeeded before; a mesh without a key
/// is always checked.
///
/// # Errors
/// Those of the check.
pub fn check_once<E>(key: Option<Key>, check: impl FnOnce() -> Result<(), E>) -> Result<(), E> {
    let known = || ACCEPTED.lock().unwrap_or_else(PoisonError::into_inner);
    if key.is_some_and(|key| known().contains(&key)) {
        return Ok(());
    }
    check()?;
    if let Some(key) = key {
        let mut known = known();
        if known.len() >= MOST {
            known.clear();
        }
        known.insert(key);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;

    #[test]
    fn a_check_that_succeeded_is_not_repeated() {
        let runs = Cell::new(0);
        let run = |outcome: Result<(), &'static str>| {
            runs.set(runs.get() + 1);
            outcome
        };
        let [first, second] = ["first", "second"].map(|name| Some(Key::of(name).finish()));
        assert_eq!(check_once(first, || run(Err("bad"))), Err("bad"));
        assert_eq!(check_once(first, || run(Ok(()))), Ok(()));
        assert_eq!(check_once(first, || run(Err("bad"))), Ok(()));
        assert_eq!(check_once(second, || run(Err("bad"))), Err("bad"));
        assert_eq!(check_once(None, || run(Ok(()))), Ok(()));
        assert_eq!(check_once(None, || run(Err("bad"))), Err("bad"));
        assert_eq!(runs.get(), 5);
    }
}
