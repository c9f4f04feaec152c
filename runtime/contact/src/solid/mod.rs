//! Three-dimensional contact of surfaces: contact lines, contact grids and compliance.
//!
//! [`find_contact_line`] finds the contact line, along which two placed surfaces are closest;
//! [`build_grid`] creates the cells; [`compliance`] computes their compliance matrix and
//! [`first_guess`] an initial active set. Contact problem and solver are those of plane contact,
//! with forces in N instead of N/m. [`pressures`], [`assess`] and [`peak`] evaluate the solution.
//!
//! See `docs/theory/contact.md`.

mod active_set_guess;
mod assembly;
mod close_strips;
mod contact_line;
mod deflected_normals;
mod grid;
mod grid_region;
mod half_space;
mod height_field;
mod image;
mod interval_averages;
mod interval_pairs;
mod loaded_ranges;
mod placement;
mod pressure;
mod slant;
mod strips;
mod surface_curvature;
mod transverse_approach;

pub use crate::assembly::Entries;
pub use active_set_guess::first_guess;
pub use assembly::{PatchCells, Side, compliance};
pub use contact_line::{ContactLine, ContactLinePoint, find_contact_line, find_contact_line_within};
pub use deflected_normals::{LineOfAction, LoadedPatch, lines_of_action};
pub use grid::{Cell, Grid, Slice, beside_faces, build_grid, contact_modulus, grid_width};
pub use grid_region::{GridOptions, GridSize};
pub use loaded_ranges::{
    LoadedRanges, estimated_ranges, extended_ranges, renumbered, with_a_cell_for_each_slice, within_ranges,
};
pub use placement::{BodyRotation, PatchFrame, PlacedSurface, Pose, sliding};
pub use pressure::{
    GridReport, Peak, assess, fitting_size, half_axes, peak, peak_in, pressures, slice_peaks_in, zones,
};
pub use surface_curvature::relative_curvature_along;

#[cfg(test)]
mod general_tests;
#[cfg(test)]
mod helical_tests;
#[cfg(test)]
mod hertz_tests;
#[cfg(test)]
mod loaded_ranges_tests;
#[cfg(test)]
mod size_tests;
#[cfg(test)]
mod test_surfaces;
