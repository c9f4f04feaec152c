//! Galerkin equations of Burton and Miller for one wavenumber, triangle by triangle.
//!
//! The pressure is continuous and linear on each triangle, its normal derivative constant. With the
//! time factor exp(iωt) the equations are A p = B q with
//! A = ½M - K + ηW and B = -(V + η(½M' + K')).

use crate::mesh::SurfaceMesh;
use crate::pair::{PairMoments, PairQuadrature};
use crate::panel::Panel;
use calyx_numerics::vec3::dot;
use faer::c64;

/// Largest wavenumber, times the radius of the sphere of equal volume, without coupling. By the
/// inequality of Faber and Krahn the first irregular frequency is at least that of this sphere, at
/// π. The imaginary coupling turns errors of discretization into errors of phase, which matter
/// where the body is small and its pressure is almost in quadrature with its velocity.
const UNCOUPLED: f64 = 2.0;

/// Returns the radius of the sphere with the volume of the body, including its mirror image.
fn equal_volume_radius(mesh: &SurfaceMesh) -> f64 {
    let images = if mesh.plane().is_some() { 2.0 } else { 1.0 };
    (0.75 * images * mesh.volume() / std::f64::consts::PI).cbrt()
}

/// Surface, its image, and the coefficients of the equations at one wavenumber.
#[derive(Debug)]
pub(crate) struct Operators {
    pub panels: Vec<Panel>,
    /// Mirror images; empty without a rigid plane.
    pub images: Vec<Panel>,
    pub nodes: usize,
    pub wavenumber: f64,
    /// Coupling parameter η, m.
    pub coupling: c64,
    pub quadrature: PairQuadrature,
}

/// Contribution of a pair of triangles to the equations.
pub(crate) struct PairEntries {
    /// Rows of the first triangle, columns of the second.
    pub forward: [[c64; 3]; 3],
    /// Rows of the second triangle, columns of the first.
    pub backward: [[c64; 3]; 3],
    /// Rows of the first triangle for the normal derivative on the second.
    pub forward_source: [c64; 3],
    /// Rows of the second triangle for the normal derivative on the first.
    pub backward_source: [c64; 3],
}

impl Operators {
    /// Creates the operators of a mesh.
    pub fn new(mesh: &SurfaceMesh, wavenumber: f64, quadrature: PairQuadrature) -> Self {
        let count = mesh.triangles().len();
        let panels = (0..count).map(|triangle| Panel::of(mesh, triangle)).collect();
        let images = (0..count).filter_map(|triangle| Panel::image(mesh, triangle)).collect();
        let coupling = if wavenumber * equal_volume_radius(mesh) < UNCOUPLED {
            c64::new(0.0, 0.0)
        } else {
            c64::new(0.0, -1.0 / wavenumber)
        };
        Self { panels, images, nodes: mesh.vertices().len(), wavenumber, coupling, quadrature }
    }

    /// Returns the contribution of two triangles of the surface; that of a pair in both orders is
    /// one contribution.
    pub fn pair(&self, first: usize, second: usize) -> PairEntries {
        self.entries(&self.panels[first], &self.panels[second])
    }

    /// Returns the contribution of a triangle and the image of another one. The image of the first
    /// and the second have the same.
    pub fn image_pair(&self, first: usize, second: usize) -> PairEntries {
        let image = &self.images[second];
        let found = self.entries(&self.panels[first], image);
        // The corners of images are in the opposite order.
        let order = |[a, b, c]: [c64; 3]| [a, c, b];
        let [a, b, c] = found.backward;
        PairEntries {
            forward: found.forward.map(order),
            backward: [a, c, b],
            forward_source: found.forward_source,
            backward_source: order(found.backward_source),
        }
    }

    fn entries(&self, first: &Panel, second: &Panel) -> PairEntries {
        let PairMoments { single, double, adjoint } = self.quadrature.moments(self.wavenumber, first, second);
        let eta = self.coupling;
        let total: c64 = single.iter().flatten().sum();
        let normals = self.wavenumber * self.wavenumber * dot(first.normal, second.normal);
        let zero = c64::new(0.0, 0.0);
        let mut entries = PairEntries {
            forward: [[zero; 3]; 3],
            backward: [[zero; 3]; 3],
            forward_source: [zero; 3],
            backward_source: [zero; 3],
        };
        for i in 0..3 {
            for j in 0..3 {
                let curls = dot(first.curls[i], second.curls[j]);
                let hypersingular = eta * (total * curls - single[i][j] * normals);
                entries.forward[i][j] = hypersingular - double[i][j];
                entries.backward[j][i] = hypersingular - adjoint[i][j];
                entries.forward_source[i] -= single[i][j] + eta * adjoint[i][j];
                entries.backward_source[j] -= single[i][j] + eta * double[i][j];
            }
        }
        entries
    }

    /// Returns the entries of ½M of a triangle: diagonal and other ones.
    pub fn half_mass(&self, triangle: usize) -> [f64; 2] {
        let area = self.panels[triangle].area;
        [area / 12.0, area / 24.0]
    }

    /// Returns the entry of -½ηM' of a triangle.
    pub fn half_mean(&self, triangle: usize) -> c64 {
        self.coupling * (-self.panels[triangle].area / 6.0)
    }
}
