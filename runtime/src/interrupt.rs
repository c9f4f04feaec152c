//! How whoever started an analysis ends it before its time: a question that is asked at every checkpoint.

use crate::error::EngineError;
use std::fmt;
use std::sync::Arc;

type Question = dyn Fn() -> Result<(), EngineError> + Send + Sync;

/// Asked at checkpoints whether to go on; the error it answers with ends the work, and is what the caller gets.
///
/// It is asked between positions, between the batches of whatever takes long while structures are built, and between the
/// iterations of the contact solver; by several threads at once where work is done side by side. It should answer fast
/// (a flag, a clock), and having said no once it should keep to it.
#[derive(Clone, Default)]
pub struct Interrupt(Option<Arc<Question>>);

impl Interrupt {
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
