//! Tests of the lowering, one module per subject. They are one program, which is linked once.

mod fingerprint;
mod kernels;
mod recently_used;
mod reuse;
