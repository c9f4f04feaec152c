//! Stores of limited size, for kernels and results of earlier programs.

use std::collections::HashMap;
use std::hash::Hash;

/// Values by their content, up to a total size. The least recently used ones are dropped first.
pub struct RecentlyUsed<K, V> {
    values: HashMap<K, Stored<V>>,
    most: usize,
    size: usize,
    uses: u64,
}

struct Stored<V> {
    value: V,
    size: usize,
    last_use: u64,
}

impl<K: Copy + Eq + Hash, V: Clone> RecentlyUsed<K, V> {
    /// Creates an empty store with a limit of the total size.
    pub fn new(most: usize) -> Self {
        Self { values: HashMap::new(), most, size: 0, uses: 0 }
    }

    /// Returns the value of a content, which becomes the last used one.
    pub fn find(&mut self, content: K) -> Option<V> {
        self.uses += 1;
        let stored = self.values.get_mut(&content)?;
        stored.last_use = self.uses;
        Some(stored.value.clone())
    }

    /// Stores a value, unless it is stored already or larger than the limit.
    pub fn store(&mut self, content: K, value: V, size: usize) {
        if size > self.most || self.values.contains_key(&content) {
            return;
        }
        while self.size + size > self.most {
            let oldest = self.values.iter().min_by_key(|(_, stored)| stored.last_use);
            let Some(dropped) = oldest.map(|(content, _)| *content).and_then(|key| self.values.remove(&key))
            else {
                return;
            };
            self.size -= dropped.size;
        }
        self.size += size;
        self.values.insert(content, Stored { value, size, last_use: self.uses });
    }
}
