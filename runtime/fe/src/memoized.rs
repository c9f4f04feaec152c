//! Functions of one parameter that store their values.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

type Function<T> = dyn Fn(f64) -> T + Send + Sync;

/// Function of one parameter that is evaluated once per parameter. Rows of a structured mesh
/// evaluate the curves of their block at the same parameters. Clones share the values.
#[derive(Clone)]
pub struct Memoized<T> {
    function: Arc<Function<T>>,
    /// Values by the bits of the parameter.
    values: Arc<Mutex<HashMap<u64, T>>>,
}

impl<T: Clone> Memoized<T> {
    /// Wraps a function, which must return the same value whenever it has the same parameter.
    pub fn new(function: impl Fn(f64) -> T + Send + Sync + 'static) -> Self {
        Self { function: Arc::new(function), values: Arc::default() }
    }

    /// Returns the value at a parameter.
    pub fn at(&self, parameter: f64) -> T {
        let bits = parameter.to_bits();
        let values = || self.values.lock().unwrap_or_else(PoisonError::into_inner);
        let known = values().get(&bits).cloned();
        // The lock is free during the evaluation, which may use other functions of this kind.
        known.unwrap_or_else(|| {
            let value = (self.function)(parameter);
            values().insert(bits, value.clone());
            value
        })
    }
}
