//! Component modes of a shaft between its stations: those of beams with many sections in between.
//!
//! See `docs/theory/shafts.md`.

use super::Shaft;
use crate::elastic_body::by_row;
use crate::interior_modes::InteriorModes;
use crate::whirl::quarter_turn_momentum;
use calyx_numerics::error::EngineError;
use calyx_structure::{AttachmentMatrices, ComponentModes, RacewayMatrices};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// Components of a station that move in tension, in torsion, and in bending in both planes.
const FAMILIES: [&[usize]; 4] = [&[2], &[5], &[0, 4], &[1, 3]];
/// Number of sections per diameter, which resolve shear by inertia, and per wavelength of bending
/// and torsion at the highest frequency. The error of a frequency is a few 1e-5.
const PER_DIAMETER: f64 = 8.0;
const PER_WAVE: f64 = 16.0;
/// Least number of parts of a stretch, and most of a shaft. Beyond it there are fewer per diameter.
const LEAST: usize = 4;
const MOST: f64 = 400.0;

impl Shaft {
    /// Returns mass and component modes of the shaft with fixed stations (m, ascending), up to a
    /// frequency (Hz), with the gyroscopic terms of both. The static shapes of the mass are those
    /// of beams.
    ///
    /// # Errors
    /// E0858: there are too many modes, or the matrices are too ill-conditioned.
    pub fn component_modes(&self, stations: &[f64], highest: f64) -> Result<AttachmentMatrices, EngineError> {
        self.modes_between(stations, highest).ok_or_else(|| not_computed(highest))
    }

    /// Checks whether the shaft with these stations (m, ascending) can have modes up to a frequency
    /// (Hz), as far as this is known before they are computed.
    ///
    /// # Errors
    /// E0858: there are too many modes.
    pub fn check_modes(&self, stations: &[f64], highest: f64) -> Result<(), EngineError> {
        let sections = self.sections_between(stations, highest);
        sections.map(|_| ()).ok_or_else(|| not_computed(highest))
    }

    fn modes_between(&self, stations: &[f64], highest: f64) -> Option<AttachmentMatrices> {
        let all = self.sections_between(stations, highest)?;
        let place = |station: f64| all.iter().position(|&other| other == station);
        let attached: Vec<usize> = stations.iter().map(|&station| place(station)).collect::<Option<_>>()?;
        let others: Vec<usize> = (0..all.len()).filter(|k| !attached.contains(k)).collect();
        let size = 6 * all.len();
        let matrix = |entries: Vec<f64>| DMatrix::from_row_slice(size, size, &entries);
        let (stiffness, mass) = (matrix(self.stiffness(&all)), matrix(self.mass(&all)));
        let rows = 6 * stations.len();
        // Motions of all sections by the stations, then by the modes.
        let mut shapes = DMatrix::zeros(size, rows);
        for (k, &section) in attached.iter().enumerate() {
            (0..6).for_each(|component| shapes[(6 * section + component, 6 * k + component)] = 1.0);
        }
        let mut eigenvalues = Vec::new();
        let mut by_modes: Vec<(Vec<usize>, InteriorModes, Vec<usize>)> = Vec::new();
        for family in FAMILIES {
            let of = |sections: &[usize]| -> Vec<usize> {
                sections.iter().flat_map(|section| family.iter().map(move |k| 6 * section + k)).collect()
            };
            let (inner, outer) = (of(&others), of(&attached));
            let block = |matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]| {
                DMatrix::from_fn(rows.len(), columns.len(), |row, column| {
                    matrix[(rows[row], columns[column])]
                })
            };
            let factor = block(&stiffness, &inner, &inner).cholesky()?;
            let moved = -factor.solve(&block(&stiffness, &inner, &outer));
            let inner_mass = block(&mass, &inner, &inner);
            let inertia = block(&mass, &inner, &outer) + &inner_mass * &moved;
            let columns: Vec<usize> =
                (0..stations.len()).flat_map(|k| family.iter().map(move |own| 6 * k + own)).collect();
            for (row, &dof) in inner.iter().enumerate() {
                for (column, &component) in columns.iter().enumerate() {
                    shapes[(dof, component)] = moved[(row, column)];
                }
            }
            let modes = InteriorModes::find(&factor, &inner_mass, &inertia, highest)?;
            eigenvalues.extend(&modes.eigenvalues);
            by_modes.push((inner, modes, columns));
        }
        let count = eigenvalues.len();
        let mut coupling = DMatrix::zeros(rows, count);
        let mut whole = shapes.resize_horizontally(rows + count, 0.0);
        let mut first = 0;
        for (inner, modes, columns) in by_modes {
            for mode in 0..modes.eigenvalues.len() {
                for (row, &dof) in inner.iter().enumerate() {
                    whole[(dof, rows + first + mode)] = modes.shapes[(row, mode)];
                }
                for (row, &component) in columns.iter().enumerate() {
                    coupling[(component, first + mode)] = modes.coupling[(row, mode)];
                }
            }
            first += modes.eigenvalues.len();
        }
        let reduced = |matrix: DMatrix<f64>| whole.transpose() * matrix * &whole;
        let skew = |matrix: DMatrix<f64>| 0.5 * (&matrix - matrix.transpose());
        let of_stations = reduced(mass.clone()).view((0, 0), (rows, rows)).into_owned();
        Some(AttachmentMatrices {
            stiffness: Vec::new(),
            mass: by_row(&(0.5 * (&of_stations + of_stations.transpose()))),
            modes: ComponentModes {
                eigenvalues,
                coupling: by_row(&coupling),
                gyroscopic: by_row(&skew(reduced(matrix(self.gyroscopic(&all))))),
                whirl_form: by_row(&skew(reduced(matrix(quarter_turn_momentum(&by_row(&mass), size, 1.0))))),
            },
            raceways: RacewayMatrices::default(),
        })
    }

    /// Returns the stations with sections between and beyond them, up to both ends; `None` without
    /// stations, or if modes up to a frequency (Hz) need too many sections.
    fn sections_between(&self, stations: &[f64], highest: f64) -> Option<Vec<f64>> {
        let (&low, &high) = (stations.first()?, stations.last()?);
        let mut stretches: Vec<[f64; 2]> = stations.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let least = 1e-6 * self.length();
        stretches.extend([[0.0, low], [high, self.length()]].into_iter().filter(|[a, b]| b - a > least));
        let mut wanted = Vec::new();
        for &[from, to] in &stretches {
            let (mut diameter, mut wave) = (f64::INFINITY, f64::INFINITY);
            for (z, _) in self.gauss(from, to) {
                diameter = diameter.min(self.diameters_at(z)[0]);
                wave = wave.min(self.shortest_wave(z, highest));
            }
            wanted.push([(to - from) * PER_DIAMETER / diameter, (to - from) * PER_WAVE / wave]);
        }
        let total = |k: usize| wanted.iter().map(|parts| parts[k]).sum::<f64>();
        let coarser = (MOST / total(0)).min(1.0);
        if total(1) > MOST {
            return None;
        }
        let mut all = stations.to_vec();
        for ([from, to], [by_diameter, by_wave]) in stretches.into_iter().zip(wanted) {
            let parts = ((coarser * by_diameter).max(by_wave).ceil() as usize).max(LEAST);
            all.extend((0..=parts).map(|k| from + (to - from) * (k as f64 / parts as f64)));
        }
        all.sort_by(f64::total_cmp);
        // Keep stations exactly.
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-3 * least;
        all.retain(|&z| stations.contains(&z) || !stations.iter().any(|&station| near(station, z)));
        all.dedup();
        Some(all)
    }

    /// Returns the shorter of the wavelengths of bending and torsion at a position (m) and a
    /// frequency (Hz), m.
    fn shortest_wave(&self, z: f64, frequency: f64) -> f64 {
        let section = self.section(z, false);
        let [.., bending, torsion] = section.compliances(&self.material);
        let inertia = section.inertia(&self.material);
        let omega = TAU * frequency;
        let of_bending = (omega * omega * inertia[0] * bending).powf(0.25);
        let of_torsion = omega * (inertia[5] * torsion).sqrt();
        TAU / of_bending.max(of_torsion)
    }
}

fn not_computed(highest: f64) -> EngineError {
    EngineError::new(
        "E0858",
        format!(
            "its modes up to {highest} Hz cannot be computed: they are too many, or its stiffnesses differ too much"
        ),
        "reduce `highest_frequency`, or leave out segments that are much thinner or shorter than the others",
    )
    .blame("highest_frequency")
}
