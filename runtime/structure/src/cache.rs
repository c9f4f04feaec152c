//! Structure cache: structures and body modes by content. Condensation takes far longer than a
//! position, and most variations (loads, speeds, misalignment, pitch deviations) do not change the
//! structure.
//!
//! Threads share a cache. Two threads that request one structure at the same time build it once. A
//! failed or interrupted build leaves no trace, and a waiting thread builds the structure instead.
//! With a [`Store`] structures are also stored on disk, for other processes and later runs.
//!
//! See `docs/theory/runs.md`.

mod store;

pub use store::Store;

use crate::{AnyStructure, AttachmentMatrices, BodyModes};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Duration;

/// Fingerprints of the source that computes structures, so that structures of an earlier method are
/// not reused.
const SOURCES: [&str; 3] = [env!("CALYX_SOURCE"), calyx_fe::SOURCE, calyx_numerics::SOURCE];
/// Interval at which a thread that waits for another build polls its own interrupt.
const PATIENCE: Duration = Duration::from_millis(10);

/// SHA-256 hash of everything that a structure depends on.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Key([u8; 32]);

impl Key {
    /// Starts the key of a kind of structure. The name must be unique.
    pub fn of(kind: &str) -> KeyWriter {
        let begun = KeyWriter(Sha256::new()).text(env!("CARGO_PKG_VERSION"));
        SOURCES.iter().fold(begun, |key, source| key.text(source)).text(kind)
    }

    /// Returns the hash.
    pub fn bytes(&self) -> &[u8; 32] {
        &self.0
    }
}

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// Writer of everything that a structure depends on into a [`Key`]. Values carry their type and
/// length, so different sequences of values give different keys.
#[derive(Clone)]
pub struct KeyWriter(Sha256);

impl KeyWriter {
    /// Writes a number; numbers that differ in any bit give different keys.
    pub fn number(self, number: f64) -> Self {
        self.part(b'n', &number.to_bits().to_le_bytes())
    }

    /// Writes the length and the numbers.
    pub fn numbers(self, numbers: &[f64]) -> Self {
        let begun = self.part(b's', &(numbers.len() as u64).to_le_bytes());
        numbers.iter().fold(begun, |key, &number| key.number(number))
    }

    /// Writes an integer.
    pub fn count(self, count: u64) -> Self {
        self.part(b'c', &count.to_le_bytes())
    }

    /// Writes another key.
    pub fn key(self, key: &Key) -> Self {
        self.part(b'k', key.bytes())
    }

    /// Writes bytes.
    pub fn content(self, bytes: &[u8]) -> Self {
        self.part(b'b', &(bytes.len() as u64).to_le_bytes()).part(b'v', bytes)
    }

    /// Writes a Boolean.
    pub fn flag(self, flag: bool) -> Self {
        self.part(b'f', &[u8::from(flag)])
    }

    /// Writes a string.
    pub fn text(self, text: &str) -> Self {
        self.part(b't', &(text.len() as u64).to_le_bytes()).part(b'u', text.as_bytes())
    }

    /// Returns the key of everything written.
    pub fn finish(self) -> Key {
        Key(self.0.finalize().into())
    }

    fn part(mut self, kind: u8, bytes: &[u8]) -> Self {
        self.0.update([kind]);
        self.0.update(bytes);
        self
    }
}

/// Entry of the cache.
#[derive(Clone)]
pub enum Operator {
    /// Condensed structure.
    Structure(AnyStructure),
    /// Modes of a body; `None` if the body has none.
    Modes(Option<Arc<BodyModes>>),
    /// Matrices of an elastic body on its attachments.
    Attachments(Arc<AttachmentMatrices>),
}

impl Operator {
    fn bytes(&self) -> usize {
        match self {
            Operator::Structure(structure) => structure.bytes(),
            Operator::Modes(modes) => modes.as_ref().map_or(0, |modes| modes.bytes()),
            Operator::Attachments(matrices) => matrices.bytes(),
        }
    }

    /// Returns the structure; `None` for another entry.
    pub fn structure(self) -> Option<AnyStructure> {
        match self {
            Operator::Structure(structure) => Some(structure),
            Operator::Modes(_) | Operator::Attachments(_) => None,
        }
    }

    fn modes(self) -> Option<Option<Arc<BodyModes>>> {
        match self {
            Operator::Modes(modes) => Some(modes),
            Operator::Structure(_) | Operator::Attachments(_) => None,
        }
    }

    fn attachments(self) -> Option<Arc<AttachmentMatrices>> {
        match self {
            Operator::Attachments(matrices) => Some(matrices),
            Operator::Structure(_) | Operator::Modes(_) => None,
        }
    }
}

impl From<AnyStructure> for Operator {
    fn from(structure: AnyStructure) -> Self {
        Operator::Structure(structure)
    }
}

impl From<Option<Arc<BodyModes>>> for Operator {
    fn from(modes: Option<Arc<BodyModes>>) -> Self {
        Operator::Modes(modes)
    }
}

impl From<Arc<AttachmentMatrices>> for Operator {
    fn from(matrices: Arc<AttachmentMatrices>) -> Self {
        Operator::Attachments(matrices)
    }
}

/// Statistics of a cache.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CacheCounts {
    /// Number of requests that needed no build.
    pub hits: u64,
    /// Number of builds started.
    pub misses: u64,
    /// Number of structures in memory.
    pub structures: usize,
    /// Their size, bytes.
    pub bytes: usize,
}

/// Structures by content, up to a number of bytes. The least recently used are evicted first.
pub struct OperatorCache {
    limit: usize,
    store: Option<Store>,
    state: Mutex<State>,
    /// Signals the end of a build, successful or not.
    ended: Condvar,
}

#[derive(Default)]
struct State {
    slots: HashMap<Key, Slot>,
    /// Total size of the cached structures.
    bytes: usize,
    clock: u64,
    hits: u64,
    misses: u64,
}

enum Slot {
    Building(Arc<Flight>),
    Built { operator: Operator, bytes: usize, used: u64 },
}

/// Build in progress. Waiting threads receive the structure through it even if the cache cannot
/// store it.
pub struct Flight(OnceLock<Operator>);

/// Answer of a cache to a request.
pub enum Answer<'c> {
    /// The cache has it.
    Ready(Operator),
    /// Not available: the caller must build it.
    Yours(Claim<'c>),
    /// Another thread is building it.
    Elsewhere(Arc<Flight>),
}

impl OperatorCache {
    /// Creates a cache of at most `limit` bytes. Structures in use are owned by their users and not
    /// counted.
    pub fn new(limit: usize) -> Self {
        Self { limit, store: None, state: Mutex::default(), ended: Condvar::new() }
    }

    /// Adds a disk store for structures that are not in memory.
    pub fn with_store(self, store: Store) -> Self {
        Self { store: Some(store), ..self }
    }

    /// Returns the disk store.
    pub fn store(&self) -> Option<&Store> {
        self.store.as_ref()
    }

    /// Returns the structure of this key: a cached one, one built here, or one that another thread
    /// is building.
    ///
    /// A thread of a rayon pool does not wait. While it builds, it may receive other work of the
    /// pool, and two such threads could deadlock. It builds the structure redundantly instead.
    ///
    /// # Errors
    /// Those of `build` and of the interrupt.
    pub fn structure(
        &self,
        key: Key,
        interrupt: &Interrupt,
        build: impl FnOnce() -> Result<AnyStructure, EngineError>,
    ) -> Result<AnyStructure, EngineError> {
        self.operator(key, interrupt, Operator::structure, |_| build())
    }

    /// Returns the modes of this key in the same way. The builder may own the claim to them.
    pub fn modes(
        &self,
        key: Key,
        interrupt: &Interrupt,
        build: impl FnOnce(Option<&Claim<'_>>) -> Result<Option<Arc<BodyModes>>, EngineError>,
    ) -> Result<Option<Arc<BodyModes>>, EngineError> {
        self.operator(key, interrupt, Operator::modes, build)
    }

    /// Returns the matrices of this key in the same way.
    ///
    /// # Errors
    /// As for [`OperatorCache::structure`].
    pub fn attachments(
        &self,
        key: Key,
        interrupt: &Interrupt,
        build: impl FnOnce(Option<&Claim<'_>>) -> Result<Arc<AttachmentMatrices>, EngineError>,
    ) -> Result<Arc<AttachmentMatrices>, EngineError> {
        self.operator(key, interrupt, Operator::attachments, build)
    }

    /// Does not return an item stored under the same key with another type.
    fn operator<T: Clone + Into<Operator>>(
        &self,
        key: Key,
        interrupt: &Interrupt,
        take: fn(Operator) -> Option<T>,
        build: impl FnOnce(Option<&Claim<'_>>) -> Result<T, EngineError>,
    ) -> Result<T, EngineError> {
        loop {
            let found = match self.ask(key) {
                Answer::Ready(operator) => operator,
                Answer::Yours(claim) => {
                    let built = build(Some(&claim))?;
                    claim.fulfil(&built.clone().into());
                    return Ok(built);
                }
                Answer::Elsewhere(_) if rayon::current_thread_index().is_some() => return build(None),
                Answer::Elsewhere(flight) => match self.wait(key, &flight, interrupt)? {
                    Some(operator) => operator,
                    None => continue,
                },
            };
            return take(found).map_or_else(|| build(None), Ok);
        }
    }

    /// Returns the statistics.
    pub fn counts(&self) -> CacheCounts {
        let state = self.lock();
        let built = state.slots.values().filter(|slot| matches!(slot, Slot::Built { .. }));
        CacheCounts { hits: state.hits, misses: state.misses, structures: built.count(), bytes: state.bytes }
    }

    /// Answers a request without waiting.
    pub fn ask(&self, key: Key) -> Answer<'_> {
        let mut state = self.lock();
        state.clock += 1;
        let now = state.clock;
        match state.slots.get_mut(&key) {
            Some(Slot::Built { operator, used, .. }) => {
                *used = now;
                let operator = operator.clone();
                state.hits += 1;
                Answer::Ready(operator)
            }
            Some(Slot::Building(flight)) => Answer::Elsewhere(flight.clone()),
            None => {
                let flight = Arc::new(Flight(OnceLock::new()));
                state.slots.insert(key, Slot::Building(flight.clone()));
                state.misses += 1;
                Answer::Yours(Claim { cache: self, key, flight })
            }
        }
    }

    /// Waits for the result of another thread's build; `None` if it failed. Not for threads of a
    /// rayon pool.
    pub fn wait(
        &self,
        key: Key,
        flight: &Arc<Flight>,
        interrupt: &Interrupt,
    ) -> Result<Option<Operator>, EngineError> {
        loop {
            interrupt.check()?;
            let mut state = self.lock();
            if let Some(operator) = flight.0.get() {
                state.hits += 1;
                return Ok(Some(operator.clone()));
            }
            match state.slots.get(&key) {
                Some(Slot::Building(current)) if Arc::ptr_eq(current, flight) => {
                    drop(self.ended.wait_timeout(state, PATIENCE).unwrap_or_else(PoisonError::into_inner));
                }
                _ => return Ok(None),
            }
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        // A poisoned lock is harmless: every change of the state is complete before anything can
        // panic.
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl fmt::Debug for OperatorCache {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OperatorCache").field("limit", &self.limit).field("counts", &self.counts()).finish()
    }
}

/// Obligation to build a structure. Dropping it unfulfilled leaves no trace.
pub struct Claim<'c> {
    cache: &'c OperatorCache,
    key: Key,
    flight: Arc<Flight>,
}

impl<'c> Claim<'c> {
    /// Returns the disk store and the key of the structure.
    pub fn on_disk(&self) -> Option<(&'c Store, Key)> {
        self.cache.store.as_ref().map(|store| (store, self.key))
    }

    /// Passes the structure to all waiting threads, and stores it if it fits.
    pub fn fulfil(self, operator: &Operator) {
        let bytes = operator.bytes();
        let mut gone = Vec::new();
        let mut state = self.cache.lock();
        // Set under the lock: a waiter that finds neither this nor the slot can conclude that the
        // build has failed.
        let _ = self.flight.0.set(operator.clone());
        if bytes <= self.cache.limit {
            state.clock += 1;
            let built = Slot::Built { operator: operator.clone(), bytes, used: state.clock };
            state.slots.insert(self.key, built);
            state.bytes += bytes;
            gone = state.shrink(self.cache.limit);
        }
        drop(state);
        // Evicted structures are freed outside the lock. Dropping the claim wakes the waiting
        // threads.
        drop(gone);
    }
}

impl Drop for Claim<'_> {
    fn drop(&mut self) {
        let mut state = self.cache.lock();
        if matches!(state.slots.get(&self.key), Some(Slot::Building(own)) if Arc::ptr_eq(own, &self.flight)) {
            state.slots.remove(&self.key);
        }
        drop(state);
        self.cache.ended.notify_all();
    }
}

impl State {
    /// Evicts the least recently used items until the rest fits.
    fn shrink(&mut self, limit: usize) -> Vec<Slot> {
        let mut gone = Vec::new();
        while self.bytes > limit {
            let age = |(key, slot): (&Key, &Slot)| match slot {
                Slot::Built { used, .. } => Some((*used, *key)),
                Slot::Building(_) => None,
            };
            let Some((_, oldest)) = self.slots.iter().filter_map(age).min() else { break };
            let slot = self.slots.remove(&oldest);
            if let Some(Slot::Built { bytes, .. }) = &slot {
                self.bytes -= bytes;
            }
            gone.extend(slot);
        }
        gone
    }
}

#[cfg(test)]
mod tests;
