//! Three-dimensional contact of surfaces: contact lines, contact grids and compliance.
//!
//! [`find_ridge`] finds the contact line, along which two placed surfaces are closest; [`lay`]
//! creates the cells; [`compliance`] computes their compliance matrix and [`first_guess`] an
//! initial active set. Contact problem and solver are those of plane contact, with forces in N
//! instead of N/m. [`pressures`], [`assess`] and [`peak`] evaluate the solution.
//!
//! See `docs/theory/contact.md`.

mod across;
mod assembly;
mod grid;
mod guess;
mod half_space;
mod image;
mod intervals;
mod placement;
mod pressure;
mod ridge;
mod sheet;

pub use assembly::{Patch, Side, compliance};
pub use grid::{Cell, Grid, GridOptions, Slice, contact_modulus, lay};
pub use guess::first_guess;
pub use placement::{PatchFrame, PlacedSurface, Pose, sliding};
pub use pressure::{GridReport, Peak, assess, half_axes, peak, peak_in, pressures, slice_peaks_in};
pub use ridge::{Ridge, RidgePoint, find_ridge};

#[cfg(test)]
mod helical_tests;
#[cfg(test)]
mod hertz_tests;
#[cfg(test)]
mod test_surfaces;
