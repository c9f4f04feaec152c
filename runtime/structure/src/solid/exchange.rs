//! Loads on a solid body and linear forms of its displacements, before it is condensed.

use crate::bore::BoreMeans;
use crate::condense::Cuts;
use calyx_fe::SparseVector;
use calyx_numerics::interrupt::MemoryReservation;

/// Sector of a ring, before it is condensed.
pub(super) struct Sector {
    pub cuts: Cuts,
    /// Fixed nodes.
    pub constrained: Vec<usize>,
    /// Means of the bore's displacements that vanish, for mean constraints; the sector is then
    /// condensed in one piece.
    pub means: Option<BoreMeans>,
    pub sectors: u32,
    /// Largest distance of coupled sectors.
    pub coupled: u32,
}

/// Loads of a body and linear forms of its displacements.
pub(super) struct LoadsAndRows {
    pub loads: Vec<SparseVector>,
    /// For each load, true if it is antisymmetric.
    pub odd: Vec<bool>,
    pub rows: Vec<SparseVector>,
    /// For each row, the row of the mirrored point, if any, and the sign of the mirror image.
    pub images: Vec<Option<(usize, f64)>>,
    /// Memory reservations for the rows.
    pub rooms: Vec<MemoryReservation>,
}
