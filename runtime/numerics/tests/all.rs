//! Tests of the numerical foundations, one module per subject. They are one program, which is
//! linked once.

mod complex;
mod dense;
mod eigenvalues;
mod fourier;
mod interpolation;
mod interrupt;
mod parallel;
mod stress;
