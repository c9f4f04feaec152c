//! Limits of a computation: interruption and memory.

use crate::error::ElasticError;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};

/// Interruption and memory limit of a computation.
#[derive(Clone, Debug)]
pub struct Resources {
    /// Callback at checkpoints, which also receives requests for memory.
    pub interrupt: Interrupt,
    /// Largest memory of a matrix or factor with its work space, bytes; `None` without a limit.
    pub memory: Option<u64>,
}

impl Default for Resources {
    /// Creates resources without interruption, with a limit of 24 GB.
    fn default() -> Self {
        Self { interrupt: Interrupt::never(), memory: Some(24 << 30) }
    }
}

impl Resources {
    /// Checkpoint.
    ///
    /// # Errors
    /// The caller ends the computation.
    pub fn check(&self) -> Result<(), ElasticError> {
        Ok(self.interrupt.check()?)
    }

    /// Reserves memory before an allocation for a number of unknowns. `exponent` is that of the
    /// growth of the memory with the number of unknowns.
    ///
    /// # Errors
    /// The memory exceeds the limit, or the caller refuses it.
    pub fn reserve(
        &self,
        purpose: &str,
        bytes: u64,
        unknowns: usize,
        exponent: f64,
    ) -> Result<MemoryReservation, ElasticError> {
        if let Some(limit) = self.memory.filter(|&limit| bytes > limit) {
            let fitting = unknowns as f64 * (limit as f64 / bytes as f64).powf(1.0 / exponent);
            let gigabytes = |bytes: u64| bytes as f64 / f64::from(1 << 30);
            return Err(ElasticError::Memory {
                message: format!(
                    "{purpose} of {unknowns} unknowns needs {:.3} GB; the limit is {:.3} GB",
                    gigabytes(bytes),
                    gigabytes(limit)
                ),
                help: format!("coarsen the mesh to about {} unknowns", fitting as u64),
            });
        }
        Ok(self.interrupt.reserve_memory(bytes)?)
    }
}
