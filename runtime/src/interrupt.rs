//! How whoever started an analysis ends it before its time: a question that is asked at every checkpoint.

use crate::error::EngineError;
use std::fmt;
use std::sync::Arc;

type Question = dyn Fn() -> Result<(), EngineError> + Send + Sync;

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
#[derive(Clone, Default)]
pub struct Interrupt(Option<Arc<Question>>);

impl Interrupt {
    /// An interrupt that asks a question: an error ends the work with it.
    pub fn new(question: impl Fn() -> Result<(), EngineError> + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(question)))
    }

    /// Lets everything run to its end.
    pub fn never() -> Self {
        Self(None)
    }

    /// A checkpoint.
    ///
    /// # Errors
    /// The error to end with.
    pub fn check(&self) -> Result<(), EngineError> {
        self.0.as_ref().map_or(Ok(()), |question| question())
    }
}

impl fmt::Debug for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0.is_some() { "Interrupt(..)" } else { "Interrupt(never)" })
    }
}
