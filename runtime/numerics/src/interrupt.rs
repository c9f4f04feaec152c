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
#[must_use = "dropped at once, it is promised to another before it is taken"]
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

/// Asked at checkpoints whether to go on; the error it answers with ends the work, and is what the caller gets.
///
/// It is asked between positions, between the batches of whatever takes long while structures are
/// built, at each row of a contact compliance, and before each factorization of the contact solver
/// and each piece of a large one; by several threads at once where work is done side by side. It should answer fast
/// (a flag, a clock), and having said no once it should keep to it.
///
/// # How long it may take to be asked
/// The longest stages without a checkpoint are of the mesh of one sector, a tooth of a gear with its share of the rim: making it,
/// adding up its stiffness, ordering that and eliminating what its last cut leaves. Each is about a twentieth of an analysis of a mesh cycle at the default
/// mesh, whatever the number of teeth (`cargo bench -p calyx-gears --bench interruption` measures it), and grows with
/// the refinement of its mesh. With kept structures the longest is one piece of
/// a factorization, less than a second.
///
/// # Memory
/// Before anything large is allocated (what condensing a sector takes, a contact matrix), the question is asked whether so many bytes
/// may be taken, so that an analysis ends with an error instead of being killed. What is asked for is at least what is taken, at any
/// number of threads: what threads side by side were promised and may not have taken yet, the question is told too.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Two parallel computations cannot reserve the same memory, and a finished one releases it.
    #[test]
    fn what_is_promised_to_one_is_not_promised_to_another() {
        let full = || EngineError::new("E0707", "it is too much", "");
        let interrupt =
            Interrupt::counting(
                move |wanted| if wanted.bytes + wanted.promised <= 100 { Ok(()) } else { Err(full()) },
            );
        let first = interrupt.reserve_memory(60).expect("there is room");
        assert_eq!(interrupt.reserve_memory(60).map(drop).map_err(|error| error.code), Err("E0707"));
        // A refused request reserves nothing.
        let second = interrupt.clone().reserve_memory(40).expect("there is room");
        assert_eq!(interrupt.largest_request(), 120);
        interrupt.check().expect("it takes nothing");
        drop(first);
        let mut third = interrupt.reserve_memory(60).expect("there is room again");
        third.shrink_to(20);
        third.shrink_to(40);
        let fourth = interrupt.reserve_memory(40).expect("there is room for what is not taken after all");
        assert_eq!(interrupt.reserve_memory(1).map(drop).map_err(|error| error.code), Err("E0707"));
        drop((second, third, fourth));
        interrupt.reserve_memory(100).map(drop).expect("all is given back");
    }
}
