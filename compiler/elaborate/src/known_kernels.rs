//! Kernels of earlier elaborations. An editor elaborates a model after each edit, and most sites,
//! such as those of the library, are unchanged.

use calyx_lang::ir::{Program, SiteId};
use calyx_lower::kernels::{KernelError, SiteContent, lower_site};
use calyx_lower::recently_used::RecentlyUsed;
use calyx_symbolic::{Tape, TapeKernel};
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError};

/// Limit of the instructions of all stored kernels, of 16 bytes each.
const MOST_INSTRUCTIONS: usize = 1 << 21;

type KnownKernels = RecentlyUsed<SiteContent, Arc<TapeKernel>>;

fn known() -> MutexGuard<'static, KnownKernels> {
    static KNOWN: LazyLock<Mutex<KnownKernels>> =
        LazyLock::new(|| Mutex::new(RecentlyUsed::new(MOST_INSTRUCTIONS)));
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns the number of instructions of a tape and of the equations that it solves.
fn instructions(tape: &Tape) -> usize {
    let solved = tape.solves.iter().map(|solve| instructions(&solve.system.residual));
    tape.instructions.len() + solved.sum::<usize>()
}

/// Returns the kernel of a site with this content, from an earlier elaboration if that had an equal
/// site.
///
/// # Errors
/// As for [`lower_site`].
pub(crate) fn kernel_of(
    program: &Program,
    id: SiteId,
    content: SiteContent,
) -> Result<Arc<TapeKernel>, KernelError> {
    if let Some(kernel) = known().find(content) {
        return Ok(kernel);
    }
    let tape = lower_site(program, id)?;
    let size = instructions(&tape);
    let kernel = Arc::new(TapeKernel(tape));
    known().store(content, kernel.clone(), size);
    Ok(kernel)
}
