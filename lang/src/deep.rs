//! Room for recursion: trees are bounded in depth, but the threads that walk them may have small stacks.

/// What walks over the deepest tree that the parser lets through take, unoptimised, with room to spare.
const STACK_BYTES: usize = 64 << 20;

/// Runs a closure with enough stack for walks over any tree, whatever the calling thread has left. A new stack costs some
/// microseconds, inside of another call nothing: who asks often asks from inside of one.
pub fn deep<R>(body: impl FnOnce() -> R) -> R {
    stacker::maybe_grow(STACK_BYTES / 2, STACK_BYTES, body)
}
