//! Component modes of a plane body: what it contributes to dynamics beside its rigid motion and its static compliance.
//!
//! The body vibrates relative to its frame, which holds it as it holds its [`Structure`](super::Structure). A modal coordinate grows the gap of
//! a contact by the inward displacement of the surface, the sign of [`Structure::add_compliance`](super::Structure::add_compliance); what
//! the modes left out answer is static: the compliance less `sum phi phi' / omega²`.
//!
//! A ring of equal sectors has modes of `n` waves: the displacements of a sector, seen in its own frame, are those of the one before times
//! `exp(i n pitch)`. So a mode is one complex field on one sector; its real and its imaginary part around the ring are two modes of one
//! frequency, but for `n = 0` and half the number of sectors, where the field is real. Only these fields are kept, seen
//! where contact and stress see them: by the same mollifiers and splines as the compliance tables ([`super::elastic`]).
//!
//! Everything is per metre of face width: modes have unit mass in kg/m, so a modal coordinate is in m sqrt(kg/m).

mod body;
mod complex;
mod cyclic;
mod harmonic;
mod sector;
mod stored;

use super::answers::Local;
use super::elastic::Surface;
use super::{Chart, ReshapedSurface};
use faer::Mat;
use std::f64::consts::TAU;
use std::sync::Arc;

/// The modes of a plane body up to some frequency, in ascending order; of a pair of one frequency the cosine comes first. See the module.
#[derive(Clone)]
pub struct BodyModes {
    /// Natural frequencies, rad/s, ascending.
    pub frequencies: Vec<f64>,
    /// `phi' M r` of each mode with the unit motions u_x, u_y, theta_z of the frame, in the body's axes about its origin: kg/m to the power
    /// 1/2, and times m.
    pub coupling: Vec<[f64; 3]>,
    /// `r' M r`: mass matrix of those motions by the same mesh, kg/m, kg and kg m. With it as the rigid body's the whole mass matrix is
    /// positive definite.
    pub rigid_mass: [[f64; 3]; 3],
    /// `phi_k' M (e3 x phi_l)`, skew: a frame that turns at `omega` acts on coordinate `k` with `-2 omega` times the row's product with the
    /// rates of the coordinates.
    pub gyroscopic: Mat<f64>,
    /// `phi_k' M x`, x the place in the body: a frame that turns steadily at `omega` acts on coordinate `k` with `omega²` times it.
    pub centrifugal: Vec<f64>,
    pub(super) fields: Arc<SectorFields>,
    /// What contact sees in place of the surfaces of the mesh, if it does.
    pub(super) reshaped: Option<Vec<ReshapedSurface>>,
}

/// A real mode of the whole ring: a part of a complex field on one sector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(super) struct RingMode {
    /// Which field.
    pub field: usize,
    /// Its imaginary part around the ring, instead of the real one.
    pub sine: bool,
}

/// Complex fields on sector 0 as tables see them; of each table the real and the imaginary part, a column a field.
pub(super) struct SectorFields {
    pub teeth: u32,
    /// Waves around, of each field.
    pub harmonics: Vec<u32>,
    /// Of each mode.
    pub modes: Vec<RingMode>,
    pub surfaces: Vec<Surface>,
    /// In which a point of a surface is seen: into the body, and along the surface if there are two.
    pub directions: usize,
    /// By `surface * directions + direction`: spline coefficients over the arc length.
    pub displacements: Vec<[Mat<f64>; 2]>,
    /// By surface: Pa, at the places of recovered stress.
    pub stresses: Vec<[Mat<f64>; 2]>,
}

impl SectorFields {
    /// Cosine and sine of the angle by which a field has advanced at a tooth.
    fn advance(&self, field: usize, tooth: u32) -> [f64; 2] {
        let teeth = u64::from(self.teeth.max(1));
        let harmonic = self.harmonics.get(field).copied().unwrap_or(0);
        let steps = u64::from(harmonic) * (u64::from(tooth) % teeth) % teeth;
        let (sin, cos) = (TAU * steps as f64 / teeth as f64).sin_cos();
        [cos, sin]
    }

    /// Rows of fields as rows of modes at a tooth.
    fn at_tooth(&self, tooth: u32, rows: usize, value: impl Fn(usize, usize) -> [f64; 2]) -> Mat<f64> {
        let mut of_modes = Mat::zeros(rows, self.modes.len());
        for (column, mode) in self.modes.iter().enumerate() {
            let [cos, sin] = self.advance(mode.field, tooth);
            for row in 0..rows {
                let [re, im] = value(row, mode.field);
                of_modes[(row, column)] = if mode.sine { cos * im + sin * re } else { cos * re - sin * im };
            }
        }
        of_modes
    }

    pub fn bytes(&self) -> usize {
        let tables = self.displacements.iter().chain(&self.stresses).flatten();
        let entries: usize = tables.map(|table| table.nrows() * table.ncols()).sum();
        self.surfaces.iter().map(Surface::bytes).sum::<usize>() + entries * size_of::<f64>()
    }
}

impl BodyModes {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.frequencies.len()
    }

    /// Inward normal displacement of a surface at each of these arc lengths (m) by unit modal coordinates: points by modes.
    pub fn displacements(&self, chart: Chart, s: &[f64]) -> Mat<f64> {
        let fields = &*self.fields;
        let Some(surface) = fields.surfaces.get(chart.surface as usize) else {
            return Mat::zeros(s.len(), self.count());
        };
        let own = self.reshaped.as_ref().and_then(|surfaces| surfaces.get(chart.surface as usize));
        let local = |&s: &f64| own.map_or_else(|| surface.local(s), |own| own.local(surface, s));
        let points: Vec<Local> = s.iter().map(local).collect();
        let first = chart.surface as usize * fields.directions;
        fields.at_tooth(chart.tooth, s.len(), |row, field| {
            let Local { direction, weights, .. } = points[row];
            let mut value = [0.0; 2];
            for (side, share) in (first..first + fields.directions).zip(direction) {
                for (value, table) in value.iter_mut().zip(&fields.displacements[side]) {
                    *value += share * weights.sum(|i| table[(i, field)]);
                }
            }
            value
        })
    }

    /// Stress along the surface (Pa) by unit modal coordinates: places by modes, at the places of [`Structure::stresses`](super::Structure::stresses).
    pub fn stresses(&self, tooth: u32, surface: u32) -> Mat<f64> {
        let fields = &*self.fields;
        let Some([re, im]) = fields.stresses.get(surface as usize) else {
            return Mat::zeros(0, self.count());
        };
        fields.at_tooth(tooth, re.nrows(), |row, field| [re[(row, field)], im[(row, field)]])
    }

    /// The same modes seen through surfaces that differ from the body's own by little, one for each, as [`Structure::reshaped`](super::Structure::reshaped);
    /// `None` if they were not made for it.
    pub fn reshaped(&self, surfaces: Vec<ReshapedSurface>) -> Option<BodyModes> {
        let fits = self.fields.directions == 2 && surfaces.len() == self.fields.surfaces.len();
        fits.then(|| BodyModes { reshaped: Some(surfaces), ..self.clone() })
    }

    /// Memory taken, in bytes: what a cache counts.
    pub fn bytes(&self) -> usize {
        let numbers = self.count() * (self.count() + 5);
        self.fields.bytes() + numbers * size_of::<f64>()
    }
}

#[cfg(test)]
impl BodyModes {
    /// Of a body whose modes no surface sees, by what frames see of them.
    pub(crate) fn unseen(
        frequencies: Vec<f64>,
        coupling: Vec<[f64; 3]>,
        gyroscopic: Mat<f64>,
        centrifugal: Vec<f64>,
    ) -> BodyModes {
        let fields = SectorFields {
            teeth: 1,
            harmonics: Vec::new(),
            modes: Vec::new(),
            surfaces: Vec::new(),
            directions: 1,
            displacements: Vec::new(),
            stresses: Vec::new(),
        };
        let fields = Arc::new(fields);
        let rigid_mass = [[0.0; 3]; 3];
        BodyModes { frequencies, coupling, rigid_mass, gyroscopic, centrifugal, fields, reshaped: None }
    }
}

#[cfg(test)]
mod tests;
