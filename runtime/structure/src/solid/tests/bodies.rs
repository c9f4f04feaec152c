//! Toothed ring of the plane tests, extruded along the z axis with or without twist.

use super::super::{ElasticSolid, SolidSplitOptions, SolidSurfaceSource};
use crate::profile::Profile;
use crate::solid::test_surface::MappedSurface;
use crate::surface::{Surface, SurfacePoint};
use crate::tests::bodies::{Divisions, ring_source, toothed_sector};
use calyx_fe::material::Material;
use calyx_fe::solid::{SolidMesh, SolidModel};
use calyx_numerics::interrupt::Interrupt;
use std::sync::Arc;

pub const TEETH: u32 = 12;

/// Parameters of a ring.
#[derive(Clone, Copy)]
pub struct Ring {
    pub divisions: Divisions,
    pub ratio: f64,
    /// Tangent of the helix angle at the tip.
    pub helix: f64,
    pub face_width: f64,
    pub layers: usize,
    pub axial_order: usize,
}

/// Profile extruded along the z axis with a rotation.
pub struct Screwed {
    pub profile: Arc<dyn Profile>,
    pub rate: f64,
    pub face_width: f64,
}

impl Surface for Screwed {
    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.profile.length()], [-0.5 * self.face_width, 0.5 * self.face_width]]
    }

    fn is_extruded(&self) -> bool {
        true
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let point = self.profile.at(u);
        let (sin, cos) = (self.rate * v).sin_cos();
        let turn = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        let ([x, y], [tx, ty], [nx, ny]) = (turn(point.position), turn(point.tangent), turn(point.normal));
        let along = [-self.rate * y, self.rate * x, 1.0];
        // The normal is perpendicular to the twisted line too.
        let slope = -(along[0] * nx + along[1] * ny);
        let size = 1.0_f64.hypot(slope);
        SurfacePoint {
            position: [x, y, v],
            tangents: [[tx, ty, 0.0], along],
            normal: [nx / size, ny / size, slope / size],
        }
    }
}

struct Shared(Arc<dyn Surface>);

impl Surface for Shared {
    fn range(&self) -> [[f64; 2]; 2] {
        self.0.range()
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        self.0.at(u, v)
    }
}

impl Ring {
    pub fn rate(&self) -> f64 {
        // Approximate tip radius.
        self.helix / 1.2
    }

    pub fn sector(&self) -> (SolidModel, Vec<SolidSurfaceSource>) {
        let (plane, sources) = toothed_sector(TEETH, 1.0, self.divisions);
        let stations: Vec<f64> = (0..=self.layers)
            .map(|station| self.face_width * (station as f64 / self.layers as f64 - 0.5))
            .collect();
        let rate = self.rate();
        let place = |[x, y]: [f64; 2], z: f64| {
            let (sin, cos) = (rate * z).sin_cos();
            [cos * x - sin * y, sin * x + cos * y, z]
        };
        let mesh = SolidMesh::swept(&plane.mesh, &stations, self.axial_order, &place).unwrap();
        let material = Material { poissons_ratio: self.ratio, ..plane.material };
        let surfaces = sources.into_iter().map(|source| SolidSurfaceSource {
            surface: Arc::new(Screwed { profile: source.profile, rate, face_width: self.face_width }),
            faces: source.chain,
            edges: source.edges,
            stress_faces: source.stress_chain,
            stress_points: [source.stress_points_per_edge, 2],
        });
        (SolidModel::new(mesh, material), surfaces.collect())
    }

    /// Returns a sector in other coordinates and at other positions: `coordinates` changes `v`
    /// only, `map` preserves the orientation and the symmetry about the z axis.
    pub fn mapped_sector(
        &self,
        coordinates: fn([f64; 2]) -> [f64; 2],
        map: fn([f64; 3]) -> [f64; 3],
    ) -> (SolidModel, Vec<SolidSurfaceSource>) {
        let (plane, _) = toothed_sector(TEETH, 1.0, self.divisions);
        let (straight, _) = self.sector();
        let rate = self.rate();
        let place = |[x, y]: [f64; 2], v: f64| {
            let [_, z] = coordinates([0.0, v]);
            let (sin, cos) = (rate * z).sin_cos();
            map([cos * x - sin * y, sin * x + cos * y, z])
        };
        let stations = &straight.mesh.swept.as_ref().unwrap().stations;
        let mesh = SolidMesh::swept(&plane.mesh, stations, self.axial_order, &place).unwrap();
        (SolidModel::new(mesh, straight.material), self.mapped_surfaces(coordinates, map))
    }

    /// Returns the surfaces of [`Self::mapped_sector`].
    pub fn mapped_surfaces(
        &self,
        coordinates: fn([f64; 2]) -> [f64; 2],
        map: fn([f64; 3]) -> [f64; 3],
    ) -> Vec<SolidSurfaceSource> {
        let mapped = |source: SolidSurfaceSource| {
            let range = source.surface.range();
            let surface = MappedSurface { base: Shared(source.surface), range, coordinates, map };
            SolidSurfaceSource { surface: Arc::new(surface), ..source }
        };
        self.sector().1.into_iter().map(mapped).collect()
    }

    pub fn structure(&self, options: &SolidSplitOptions) -> ElasticSolid {
        let (model, surfaces) = self.sector();
        ElasticSolid::ring(&model, &ring_source(TEETH), &surfaces, options, &Interrupt::never()).unwrap()
    }
}
