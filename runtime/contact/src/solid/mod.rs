//! Contact of surfaces in space: where they approach, which cells could carry pressure, and how cells give.
//!
//! As in the plane: [`find_ridge`] finds where two placed surfaces come closest, all along the patch; [`lay`] lays cells there;
//! [`compliance`] is how they give, [`first_guess`] which of them carry force; the contact problem and its solution are those of the plane, forces in N instead of N/m. Then
//! [`pressures`], [`assess`] and [`peak`] read the solution.

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
