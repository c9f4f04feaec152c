//! Tests of finite elements, one module per subject. They are one program: it is linked once, and
//! its tests run in parallel.

mod inertia;
mod memoized;
mod plane;
mod revolution;
mod solid;
