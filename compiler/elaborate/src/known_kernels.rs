//! Kernels of earlier elaborations. An editor elaborates a model after each edit, and most sites,
//! such as those of the library, are unchanged.

use crate::interpreted::kernel;
use calyx_abi::Kernel;
use calyx_lang::ir::{Program, SiteId};
use calyx_lower::kernels::{KernelError, SiteContent, lower_site};
use calyx_symbolic::Tape;
use std::collections::HashMap;
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError};

/// Limit of the instructions of all stored kernels, of 16 bytes each.
const MOST_INSTRUCTIONS: usize = 1 << 21;

/// Stored kernels; the least recently used ones are dropped first.
struct KnownKernels {
    kernels: HashMap<SiteContent, Stored>,
    most: usize,
    instructions: usize,
    uses: u64,
}

struct Stored {
    kernel: Arc<dyn Kernel>,
    instructions: usize,
    last_use: u64,
}

impl KnownKernels {
    fn new(most: usize) -> Self {
        Self { kernels: HashMap::new(), most, instructions: 0, uses: 0 }
    }

    fn find(&mut self, content: SiteContent) -> Option<Arc<dyn Kernel>> {
        self.uses += 1;
        let stored = self.kernels.get_mut(&content)?;
        stored.last_use = self.uses;
        Some(stored.kernel.clone())
    }

    fn store(&mut self, content: SiteContent, kernel: Arc<dyn Kernel>, instructions: usize) {
        if instructions > self.most || self.kernels.contains_key(&content) {
            return;
        }
        while self.instructions + instructions > self.most {
            let oldest = self.kernels.iter().min_by_key(|(_, stored)| stored.last_use);
            let Some(dropped) = oldest.map(|(content, _)| *content).and_then(|key| self.kernels.remove(&key))
            else {
                return;
            };
            self.instructions -= dropped.instructions;
        }
        self.instructions += instructions;
        self.kernels.insert(content, Stored { kernel, instructions, last_use: self.uses });
    }
}

fn known() -> MutexGuard<'static, KnownKernels> {
    static KNOWN: LazyLock<Mutex<KnownKernels>> =
        LazyLock::new(|| Mutex::new(KnownKernels::new(MOST_INSTRUCTIONS)));
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns the number of instructions of a tape and of the equations that it solves.
fn instructions(tape: &Tape) -> usize {
    let solved = tape.solves.iter().map(|solve| instructions(&solve.system.residual));
    tape.instructions.len() + solved.sum::<usize>()
}

/// Returns the kernel of a site, from an earlier elaboration if that had an equal site.
///
/// # Errors
/// As for [`lower_site`].
pub(crate) fn kernel_of(program: &Program, id: SiteId) -> Result<Arc<dyn Kernel>, KernelError> {
    let content = program.sites.get(id.0 as usize).map(|site| SiteContent::of(program, site));
    if let Some(kernel) = content.and_then(|content| known().find(content)) {
        return Ok(kernel);
    }
    let tape = lower_site(program, id)?;
    let size = instructions(&tape);
    let kernel = kernel(tape);
    if let Some(content) = content {
        known().store(content, kernel.clone(), size);
    }
    Ok(kernel)
}
