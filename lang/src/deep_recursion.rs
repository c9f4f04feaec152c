//! Stack space for recursion. Trees are limited in depth, but threads that traverse them may have
//! small stacks.

/// Stack size, bytes: more than unoptimized code needs to traverse the deepest tree that the parser
/// accepts.
const STACK_BYTES: usize = 64 << 20;

/// Runs a closure with enough stack to traverse any tree, independent of the remaining stack of the
/// calling thread. A new stack costs some microseconds; a nested call costs nothing. Frequent
/// callers should therefore wrap their loop in one call.
pub fn with_deep_stack<R>(body: impl FnOnce() -> R) -> R {
    stacker::maybe_grow(STACK_BYTES / 2, STACK_BYTES, body)
}
