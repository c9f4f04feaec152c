//! Surface that is as coarse as the sound permits: with elements that resolve the waves in the
//! fluid and those of the walls, and that keep curved shapes.

use crate::coarsening::coarsened;
use crate::error::AcousticError;
use crate::mesh::SurfaceMesh;
use crate::projection::Projection;
use crate::skin::Skin;

/// Elements per wavelength in the fluid.
pub const PER_WAVELENGTH: f64 = 6.0;
/// Least number of edges in the size of a body.
const LEAST_EDGES: f64 = 6.0;
/// Largest mean distance of the coarsened surface from the fine one, relative to the size of the
/// body. It changes the power of a sphere by at most 1 %; plane walls are coarsened exactly.
const MEAN_DISTANCE: f64 = 1e-3;
/// Part of the mean square velocity that is kept: about six elements in a wavelength of the walls.
const KEPT: f64 = 0.9;
/// Ratio of the longest edges of successive attempts.
const SHORTER: f64 = 0.7;

/// Coarsened surface with the projection of velocities to it.
#[derive(Clone, Debug)]
pub struct CoarseSurface {
    /// Coarsened skin.
    pub skin: Skin,
    /// Projection of normal velocities from the fine surface.
    pub projection: Projection,
}

impl CoarseSurface {
    /// Coarsens a skin to [`PER_WAVELENGTH`] elements in a wavelength, m, in the fluid, and less if
    /// needed for curved walls or for the waves of these real normal velocities: on average they
    /// keep nine tenths of their mean square.
    ///
    /// # Errors
    /// The wavelength is not positive.
    pub fn new(skin: &Skin, wavelength: f64, velocities: &[&[f64]]) -> Result<Self, AcousticError> {
        let fine = &skin.mesh;
        let mut longest = (wavelength / PER_WAVELENGTH).min(fine.size() / LEAST_EDGES);
        loop {
            let coarse = coarsened(skin, longest)?;
            let mesh = &coarse.mesh;
            let is_fine = mesh.triangles().len() == fine.triangles().len();
            let distance = (mesh.volume() - fine.volume()).abs() / fine.area();
            if is_fine || distance <= MEAN_DISTANCE * fine.size() {
                let surface = CoarseSurface { projection: Projection::new(fine, mesh), skin: coarse };
                let kept = surface.kept(fine, velocities);
                // Velocities that overflow are rejected with their sound.
                if is_fine || kept >= KEPT || kept.is_nan() {
                    return Ok(surface);
                }
            }
            longest *= SHORTER;
        }
    }

    /// Returns the mean part of their mean square that velocities of the fine surface keep.
    fn kept(&self, fine: &SurfaceMesh, velocities: &[&[f64]]) -> f64 {
        let mean_square = |mesh: &SurfaceMesh, own: &[f64]| -> f64 {
            own.iter().zip(mesh.areas()).map(|(value, area)| value * value * area).sum()
        };
        let parts = velocities.iter().filter_map(|own| {
            let whole = mean_square(fine, own);
            let part = mean_square(&self.skin.mesh, &self.projection.normal_velocities(own));
            (whole != 0.0).then_some(part / whole)
        });
        let (sum, count) = parts.fold((0.0, 0), |(sum, count), part| (sum + part, count + 1));
        if count == 0 { 1.0 } else { sum / f64::from(count) }
    }
}
