//! Plain rings for tests.

use calyx_fe::block::uniform;
use calyx_fe::material::{Material, Plane};
use calyx_fe::{Block, Curve, ElementOrder, MeshBuilder, PlaneModel, Side};
use std::f64::consts::PI;

pub const STEEL: Material = Material { youngs_modulus: 2.10e11, poissons_ratio: 0.3, density: 7850.0 };

/// Thin ring in plane stress.
pub const THIN: Annulus = Annulus {
    radii: [0.99, 1.01],
    sectors: 16,
    elements: [1, 2],
    order: 3,
    material: STEEL,
    plane: Plane::Stress,
    turned: 0.0,
};

/// Plain ring, defined by one of its equal sectors.
#[derive(Clone, Copy)]
pub struct Annulus {
    pub radii: [f64; 2],
    pub sectors: u32,
    /// Number of elements across the ring, and along each sector.
    pub elements: [usize; 2],
    pub order: u8,
    pub material: Material,
    pub plane: Plane,
    /// Rotation of its first sector, rad.
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
}
