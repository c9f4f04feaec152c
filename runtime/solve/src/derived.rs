//! Results that observables derive from whole mesh cycles, computed once per system.

use std::any::Any;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Results by surface pair and mesh cycle, kept for the observables of later positions. Keys beyond
/// the surface pairs belong to results of all speeds.
///
/// The lock is never held while a result is computed: a position may be solved within the parallel
/// loop of another one, on the same thread.
#[derive(Debug, Default)]
pub struct DerivedResults(Mutex<HashMap<(usize, i64), Arc<dyn Any + Send + Sync>>>);

impl DerivedResults {
    /// Returns the result of a pair and a mesh cycle; creates it by `create` if there is none yet.
    /// `None` if the result has another type.
    pub fn get_or_create<T: Any + Send + Sync>(
        &self,
        key: (usize, i64),
        create: impl FnOnce() -> T,
    ) -> Option<Arc<T>> {
        let mut all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let found = all.entry(key).or_insert_with(|| Arc::new(create())).clone();
        found.downcast().ok()
    }

    /// Returns the result of a key; `None` if there is none of this type.
    pub fn find<T: Any + Send + Sync>(&self, key: (usize, i64)) -> Option<Arc<T>> {
        let all = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        all.get(&key)?.clone().downcast().ok()
    }
}
