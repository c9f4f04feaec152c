//! Component modes of a plane body: its contribution to dynamics beyond its rigid-body motion and
//! its static compliance.
//!
//! The body vibrates relative to its frame, which supports it in the same way as its
//! [`Structure`](super::Structure). A positive modal coordinate opens the gap of a contact by the
//! inward displacement of the surface, the sign of
//! [`Structure::add_compliance`](super::Structure::add_compliance). The omitted modes respond
//! statically, with the residual flexibility: the compliance less `sum phi phi' / omega²`.
//!
//! Cyclic symmetry: the modes of a ring of equal sectors have `n` nodal diameters. The
//! displacements of a sector, in its own frame, are those of the previous one times
//! `exp(i n pitch)`. A mode is therefore one complex field on one sector. Its real and its
//! imaginary part around the ring are two modes of one frequency, except for `n = 0` and half the
//! number of sectors, where the field is real. Only these fields are stored, at the surfaces and
//! stress recovery points, through the same mollifiers and splines as the compliance tables
//! ([`super::elastic`]).
//!
//! All quantities are per metre of face width: modes are normalized to unit mass in kg/m, so a
//! modal coordinate is in m sqrt(kg/m).
//!
//! See `docs/theory/modes.md`.

mod body;
mod complex;
mod cyclic;
mod harmonic;
mod sector;
mod stored;

use super::elastic::Local;
use super::elastic::Surface;
use super::{Chart, ModifiedSurface};
use faer::Mat;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Modes of a plane body up to some frequency, in ascending order; in a pair of one frequency the
/// cosine comes first. See the module documentation.
#[derive(Clone)]
pub struct BodyModes {
    /// Natural frequencies, rad/s, ascending.
    pub frequencies: Vec<f64>,
    /// Coupling `phi' M r` of each mode with the unit motions u_x, u_y, theta_z of the frame, in
    /// the body's axes about its origin: (kg/m)^1/2, and times m.
    pub coupling: Vec<[f64; 3]>,
    /// Mass matrix `r' M r` of those motions by the same mesh, kg/m, kg and kg m. Used as the rigid
    /// body's mass matrix, it makes the complete mass matrix positive definite.
    pub rigid_mass: [[f64; 3]; 3],
    /// Gyroscopic matrix `phi_k' M (e3 x phi_l)`, skew: in a frame that rotates at `omega` the
    /// generalized force on coordinate `k` is `-2 omega` times the product of row `k` with the
    /// rates of the coordinates.
    pub gyroscopic: Mat<f64>,
    /// Centrifugal vector `phi_k' M x`, with x the position in the body: in a frame that rotates
    /// steadily at `omega` the generalized force on coordinate `k` is `omega²` times entry `k`.
    pub centrifugal: Vec<f64>,
    pub(super) fields: Arc<SectorFields>,
    /// Modified surfaces that contact uses in place of those of the mesh, if any.
    pub(super) modified_surfaces: Option<Vec<ModifiedSurface>>,
}

/// Real mode of the whole ring: one part of a complex field on one sector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(super) struct RingMode {
    /// Index of the field.
    pub field: usize,
    /// True for the imaginary part of the field around the ring, false for the real part.
    pub sine: bool,
}

/// Complex fields on sector 0 in table form; each table has a real and an imaginary part with one
/// column for each field.
pub(super) struct SectorFields {
    pub teeth: u32,
    /// Number of nodal diameters of each field.
    pub harmonics: Vec<u32>,
    /// Field and part of each mode.
    pub modes: Vec<RingMode>,
    pub surfaces: Vec<Surface>,
    /// Number of directions in which a point of a surface is observed: 1, into the body, or 2, also
    /// along the surface.
    pub directions: usize,
    /// Spline coefficients over the arc length, by `surface * directions + direction`.
    pub displacements: Vec<[Mat<f64>; 2]>,
    /// Stresses at the stress recovery points, by surface, Pa.
    pub stresses: Vec<[Mat<f64>; 2]>,
}

impl SectorFields {
    /// Returns cosine and sine of the phase angle of a field at a tooth.
    fn advance(&self, field: usize, tooth: u32) -> [f64; 2] {
        let teeth = u64::from(self.teeth.max(1));
        let harmonic = self.harmonics.get(field).copied().unwrap_or(0);
        let steps = u64::from(harmonic) * (u64::from(tooth) % teeth) % teeth;
        let (sin, cos) = (TAU * steps as f64 / teeth as f64).sin_cos();
        [cos, sin]
    }

    /// Converts rows of fields to rows of modes at a tooth.
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
    /// Returns the number of modes.
    pub fn count(&self) -> usize {
        self.frequencies.len()
    }

    /// Returns the inward normal displacement of a surface at these arc lengths (m) by unit modal
    /// coordinates: points by modes.
    pub fn displacements(&self, chart: Chart, s: &[f64]) -> Mat<f64> {
        let fields = &*self.fields;
        let Some(surface) = fields.surfaces.get(chart.surface as usize) else {
            return Mat::zeros(s.len(), self.count());
        };
        let own = self.modified_surfaces.as_ref().and_then(|surfaces| surfaces.get(chart.surface as usize));
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

    /// Returns the stress along the surface (Pa) by unit modal coordinates: points by modes, at the
    /// points of [`Structure::stresses`](super::Structure::stresses).
    pub fn stresses(&self, tooth: u32, surface: u32) -> Mat<f64> {
        let fields = &*self.fields;
        let Some([re, im]) = fields.stresses.get(surface as usize) else {
            return Mat::zeros(0, self.count());
        };
        fields.at_tooth(tooth, re.nrows(), |row, field| [re[(row, field)], im[(row, field)]])
    }

    /// Returns the same modes with surfaces that differ slightly from the body's own, one for each,
    /// as [`Structure::with_modified_surfaces`](super::Structure::with_modified_surfaces); `None`
    /// if the modes do not support this.
    pub fn with_modified_surfaces(&self, surfaces: Vec<ModifiedSurface>) -> Option<BodyModes> {
        let fits = self.fields.directions == 2 && surfaces.len() == self.fields.surfaces.len();
        fits.then(|| BodyModes { modified_surfaces: Some(surfaces), ..self.clone() })
    }

    /// Returns the memory, in bytes: the size that a cache counts.
    pub fn bytes(&self) -> usize {
        let numbers = self.count() * (self.count() + 5);
        self.fields.bytes() + numbers * size_of::<f64>()
    }
}

#[cfg(any(test, feature = "fixtures"))]
impl BodyModes {
    /// Builds modes of a body without surfaces from their coupling with the frame.
    pub fn without_surfaces(
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
        BodyModes {
            frequencies,
            coupling,
            rigid_mass,
            gyroscopic,
            centrifugal,
            fields,
            modified_surfaces: None,
        }
    }
}

#[cfg(test)]
mod tests;
