//! Tests of component modes against analytical ring solutions and whole meshes, and of general
//! properties.

mod body;
mod rings;
mod whole;

use super::body::RingFields;
use super::cyclic::ring_modes;
use super::sector::Sector;
use crate::condense::{Assembled, match_cuts};
pub use crate::tests::annulus::{Annulus, THIN};
use calyx_fe::PlaneModel;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::TAU;

impl Annulus {
    /// Returns the natural frequencies up to `highest`, rad/s.
    pub fn frequencies(&self, clamped: bool, highest: f64) -> Vec<f64> {
        let sector = sector_of(&self.sector(), self.sectors, clamped);
        let modes = ring_modes(&sector, highest, &Interrupt::never()).unwrap();
        RingFields::new(&sector, modes).squares.iter().map(|square| square.max(0.0).sqrt()).collect()
    }
}

/// Returns a sector with a clamped or a free bore.
pub fn sector_of(model: &PlaneModel, count: u32, clamped: bool) -> Sector {
    let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
    let constrained = if clamped { nodes("bore") } else { Vec::new() };
    let assembled = Assembled::plane(model);
    let angle = TAU / f64::from(count);
    let (first, last) = (nodes("cut_first"), nodes("cut_last"));
    // A mesh of the whole ring has no cuts.
    let cuts =
        (count > 1).then(|| match_cuts(&assembled.positions, &first, &last, &constrained, angle).unwrap());
    let constrained = assembled.dofs_of(&constrained);
    Sector::new(
        (assembled.stiffness, model.mass()),
        model.mesh.nodes.clone(),
        &constrained,
        count,
        cuts.as_ref(),
    )
}
