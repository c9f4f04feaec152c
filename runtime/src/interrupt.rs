//! How whoever started an analysis ends it before its time: a question that is asked at every checkpoint.

use crate::error::EngineError;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

type Question = dyn Fn(u64) -> Result<(), EngineError> + Send + Sync;

/// Asked at checkpoints whether to go on; the error it answers with ends the work, and is what the caller gets.
///
/// It is asked between positions, between the batches of whatever takes long while structures are built, and before each
/// factorisation of the contact solver; by several threads at once where work is done side by side. It should answer fast
/// (a flag, a clock), and having said no once it should keep to it.
///
/// # How long it may take to be asked
/// The longest stages without a checkpoint are of the mesh of one sector, a tooth of a gear with its share of the rim: making it,
/// adding up its stiffness, ordering that and eliminating what its last cut leaves. Each is about a twentieth of an analysis of a mesh cycle at the default
/// mesh, whatever the number of teeth (`cargo bench -p calyx-gears --bench interruption` measures it), and grows with
/// [`StructureOptions::refinement`](crate::scene::StructureOptions::refinement). With kept structures the longest is one round of
/// the contact solver, a fraction of a position.
///
/// # Memory
/// Before anything large is allocated (what condensing a sector takes, a contact matrix), the question is asked whether so many bytes
/// may be taken, so that an analysis ends with an error instead of being killed. What is asked for is at least what is taken, at any
/// number of threads.
#[derive(Clone, Default)]
pub struct Interrupt {
    question: Option<Arc<Question>>,
    /// The largest number of bytes asked for.
    most: Arc<AtomicU64>,
}

impl Interrupt {
    /// An interrupt that asks a question: an error ends the work with it.
    pub fn new(question: impl Fn() -> Result<(), EngineError> + Send + Sync + 'static) -> Self {
        Self::counting(move |_| question())
    }

    /// The same of a question that is told how many bytes are to be taken next, of which most checkpoints know nothing: 0.
    pub fn counting(question: impl Fn(u64) -> Result<(), EngineError> + Send + Sync + 'static) -> Self {
        Self { question: Some(Arc::new(question)), most: Arc::default() }
    }

    /// Lets everything run to its end.
    pub fn never() -> Self {
        Self::default()
    }

    /// A checkpoint.
    ///
    /// # Errors
    /// The error to end with.
    pub fn check(&self) -> Result<(), EngineError> {
        self.room_for(0)
    }

    /// A checkpoint before so many bytes are taken.
    ///
    /// # Errors
    /// The error to end with.
    pub fn room_for(&self, bytes: u64) -> Result<(), EngineError> {
        self.most.fetch_max(bytes, Ordering::Relaxed);
        self.question.as_ref().map_or(Ok(()), |question| question(bytes))
    }

    /// The most bytes that were asked for at once.
    pub fn most_asked(&self) -> u64 {
        self.most.load(Ordering::Relaxed)
    }
}

impl fmt::Debug for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.question.is_some() { "Interrupt(..)" } else { "Interrupt(never)" })
    }
}
