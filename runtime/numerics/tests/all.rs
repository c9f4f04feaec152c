//! Tests of the numerical foundations, one module per subject. They are one program, which is
//! linked once.

mod complex;
mod dense;
mod fourier;
mod interpolation;
mod interrupt;
mod stress;
