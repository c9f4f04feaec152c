//! Component modes against rings that theory knows, whole meshes, and what must hold of any modes.

mod body;
mod rings;
mod whole;

use super::body::RingFields;
use super::cyclic::ring_modes;
use super::sector::Sector;
use crate::fe::block::uniform;
use crate::fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneModel, Side};
use crate::interrupt::Interrupt;
use crate::material::{Material, Plane};
use crate::structure::condense::{Assembled, match_cuts};
use std::f64::consts::{PI, TAU};

/// A plain ring by one of its equal sectors.
#[derive(Clone, Copy)]
pub struct Annulus {
    pub radii: [f64; 2],
    pub sectors: u32,
    /// Elements across the ring, and along each sector.
    pub elements: [usize; 2],
    pub order: u8,
    pub material: Material,
    pub plane: Plane,
    /// By which its first sector is turned, rad.
    pub turned: f64,
}

impl Annulus {
    pub fn sector(&self) -> PlaneModel {
        let [inner, outer] = self.radii;
        let half = PI / f64::from(self.sectors);
        let (from, to) = (self.turned + half, self.turned - half);
        let ray = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            Curve::line([inner * cos, inner * sin], [outer * cos, outer * sin])
        };
        let block = Block::new(
            Curve::arc([0.0; 2], inner, from, to),
            ray(to),
            Curve::arc([0.0; 2], outer, from, to),
            ray(from),
        );
        let block = block
            .divided(uniform(self.elements[1]), uniform(self.elements[0]))
            .named(Side::Bottom, "bore")
            .named(Side::Left, "cut_last")
            .named(Side::Right, "cut_first");
        let mut builder = MeshBuilder::new();
        builder.block(block);
        let mesh = builder.finish(ElementOrder::full(self.order)).unwrap();
        PlaneModel::new(mesh, self.material, self.plane)
    }

    /// Natural frequencies up to `highest`, rad/s.
    pub fn frequencies(&self, clamped: bool, highest: f64) -> Vec<f64> {
        let sector = sector_of(&self.sector(), self.sectors, clamped);
        let modes = ring_modes(&sector, highest, &Interrupt::never()).unwrap();
        RingFields::new(&sector, modes).squares.iter().map(|square| square.max(0.0).sqrt()).collect()
    }
}

/// A sector whose bore is clamped, or which nothing holds.
pub fn sector_of(model: &PlaneModel, count: u32, clamped: bool) -> Sector {
    let nodes = |name: &str| model.mesh.chain_nodes(model.mesh.chain(name).unwrap());
    let held = if clamped { nodes("bore") } else { Vec::new() };
    let assembled = Assembled::plane(model);
    let angle = TAU / f64::from(count);
    let (first, last) = (nodes("cut_first"), nodes("cut_last"));
    // A mesh that goes all round has no cuts.
    let cuts = (count > 1).then(|| match_cuts(&assembled.positions, &first, &last, &held, angle).unwrap());
    let held = assembled.dofs_of(&held);
    Sector::new((assembled.stiffness, model.mass()), model.mesh.nodes.clone(), &held, count, cuts.as_ref())
}
