//! The one scalar definition of every numeric operation.
//!
//! Constant folding, the interpreter, machine code in memory and object files all use these, so that they agree
//! bit for bit. Transcendental functions come from `libm` (pure Rust), never from the system.
//! Multiply-adds are never fused.

/// Sine of `x` (radians).
pub fn sin(x: f64) -> f64 {
    libm::sin(x)
}
