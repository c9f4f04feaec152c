//! Cancellation of a running analysis by its caller: a callback at every checkpoint.

use crate::error::EngineError;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

type Question = dyn Fn(MemoryRequest) -> Result<(), EngineError> + Send + Sync;

/// Request for memory.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MemoryRequest {
    /// Memory of the next allocation, bytes; 0 at checkpoints without an allocation.
    pub bytes: u64,
    /// Memory that is reserved for others, allocated or not, bytes.
    pub promised: u64,
}

/// Reservation of memory. Dropping it releases the memory, so its owner keeps it together with the
/// allocation.
#[derive(Debug, Default)]
#[must_use = "if dropped immediately, the memory is reserved for others before it is allocated"]
pub struct MemoryReservation {
    promised: Arc<AtomicU64>,
    bytes: u64,
}

impl MemoryReservation {
    /// Returns the size of the reservation.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }

    /// Reduces the reservation to a number of bytes.
    pub fn shrink_to(&mut self, bytes: u64) {
        self.promised.fetch_sub(self.bytes.saturating_sub(bytes), Ordering::Relaxed);
        self.bytes = self.bytes.min(bytes);
    }
}

impl Drop for MemoryReservation {
    fn drop(&mut self) {
        self.promised.fetch_sub(self.bytes, Ordering::Relaxed);
    }
}

/// Callback that the engine calls at checkpoints. Its error ends the analysis and is returned to
/// the caller.
///
/// Checkpoints are between positions, between the batches of long computations while structures are
/// built, at each slice of a three-dimensional contact grid, at each row of a contact compliance,
/// before each factorization of the contact solver and before each piece of a large one. Parallel
/// computations call the callback from several threads concurrently. It should return quickly (test
/// a flag, read a clock), and continue to fail after its first error.
///
/// # Time between checkpoints
/// The longest stages without a checkpoint concern the mesh of one sector, a tooth of a gear with
/// its part of the rim: mesh generation, stiffness assembly, ordering, and elimination of the last
/// separator. Each takes about a twentieth of an analysis of a mesh cycle at the default mesh, for
/// any number of teeth (`cargo bench -p calyx-gears --bench interruption` measures it), and grows
/// with mesh refinement. With structures from the cache the longest stage is one piece of a
/// factorization, less than a second.
///
/// # Memory
/// Before large allocations (the condensation of a sector, a contact matrix) the callback receives
/// the number of bytes, so that an analysis ends with an error before the operating system stops
/// it. The number is an upper bound of the allocation, at any number of threads: the request
/// includes the memory that is reserved for parallel computations and possibly not yet allocated.
#[derive(Clone, Default)]
pub struct Interrupt {
    question: Option<Arc<Question>>,
    /// Largest number of bytes requested, including reservations of others.
    most: Arc<AtomicU64>,
    /// Reserved bytes.
    promised: Arc<AtomicU64>,
}

impl Interrupt {
    /// Creates an interrupt from a callback; its error ends the work.
    pub fn new(question: impl Fn() -> Result<(), EngineError> + Send + Sync + 'static) -> Self {
        Self::counting(move |_| question())
    }

    /// Creates an interrupt from a callback that receives the requests for memory.
    pub fn counting(
        question: impl Fn(MemoryRequest) -> Result<(), EngineError> + Send + Sync + 'static,
    ) -> Self {
        Self { question: Some(Arc::new(question)), ..Self::default() }
    }

    /// Creates an interrupt that never ends the work.
    pub fn never() -> Self {
        Self::default()
    }

    /// Checkpoint.
    ///
    /// # Errors
    /// The error of the callback.
    pub fn check(&self) -> Result<(), EngineError> {
        self.reserve_memory(0).map(drop)
    }

    /// Checkpoint before an allocation of `bytes`, which are reserved until the result is dropped.
    ///
    /// # Errors
    /// The error of the callback.
    pub fn reserve_memory(&self, bytes: u64) -> Result<MemoryReservation, EngineError> {
        let promised = self.promised.fetch_add(bytes, Ordering::Relaxed);
        // A refused request is released.
        let room = MemoryReservation { promised: self.promised.clone(), bytes };
        self.most.fetch_max(promised + bytes, Ordering::Relaxed);
        let wanted = MemoryRequest { bytes, promised };
        self.question.as_ref().map_or(Ok(()), |question| question(wanted)).map(|()| room)
    }

    /// Returns the largest number of bytes requested at a time by all threads together.
    pub fn largest_request(&self) -> u64 {
        self.most.load(Ordering::Relaxed)
    }
}

impl fmt::Debug for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.question.is_some() { "Interrupt(..)" } else { "Interrupt(never)" })
    }
}
