//! Component modes of a shaft between its stations: those of beams with many sections in between.
//!
//! See `docs/theory/shafts.md`.

use super::Shaft;
use crate::elastic_body::by_row;
use crate::interior_modes::InteriorModes;
use crate::whirl::quarter_turn_momentum;
use calyx_numerics::error::EngineError;
use calyx_structure::{AttachmentMatrices, ComponentModes};
use nalgebra::DMatrix;

/// Components of a station that move in tension, in torsion, and in bending in both planes.
const FAMILIES: [&[usize]; 4] = [&[2], &[5], &[0, 4], &[1, 3]];
/// Number of sections per diameter, which resolve shear by inertia: the error of a frequency is a
/// few 1e-5.
const PER_DIAMETER: f64 = 8.0;
/// Least and largest number of parts of a stretch, and of the whole shaft.
const PARTS: [usize; 2] = [4, 64];
const MOST: usize = 400;

impl Shaft {
    /// Returns mass and component modes of the shaft with fixed stations (m, ascending), up to a
    /// frequency (Hz), with the gyroscopic terms of both. The static shapes of the mass are those of
    /// beams.
    ///
    /// # Errors
    /// E0858: the matrices are too ill-conditioned.
    pub fn component_modes(&self, stations: &[f64], highest: f64) -> Result<AttachmentMatrices, EngineError> {
        self.modes_between(stations, highest).ok_or_else(|| {
            EngineError::new(
                "E0858",
                "the modes between its sections cannot be computed, because their stiffnesses differ too much",
                "leave out segments that are much thinner or shorter than the others, or leave `highest_frequency` at 0",
            )
            .blame("segments")
        })
    }

    fn modes_between(&self, stations: &[f64], highest: f64) -> Option<AttachmentMatrices> {
        let all = self.sections_between(stations)?;
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
        })
    }

    /// Returns the stations with sections between and beyond them, up to both ends; `None` without
    /// stations.
    fn sections_between(&self, stations: &[f64]) -> Option<Vec<f64>> {
        let (&low, &high) = (stations.first()?, stations.last()?);
        let mut stretches: Vec<[f64; 2]> = stations.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        let least = 1e-6 * self.length();
        stretches.extend([[0.0, low], [high, self.length()]].into_iter().filter(|[a, b]| b - a > least));
        // Thinnest section of each stretch.
        let thinnest = |[from, to]: [f64; 2]| {
            let diameters = self.gauss(from, to).into_iter().map(|(z, _)| self.diameters_at(z)[0]);
            diameters.fold(f64::INFINITY, f64::min)
        };
        let wanted = |stretch: [f64; 2]| PER_DIAMETER * (stretch[1] - stretch[0]) / thinnest(stretch);
        let total: f64 = stretches.iter().map(|&stretch| wanted(stretch)).sum();
        let coarser = (MOST as f64 / total).min(1.0);
        let mut all = stations.to_vec();
        for stretch in stretches {
            let [from, to] = stretch;
            let parts = ((coarser * wanted(stretch)).ceil() as usize).clamp(PARTS[0], PARTS[1]);
            all.extend((0..=parts).map(|k| from + (to - from) * (k as f64 / parts as f64)));
        }
        all.sort_by(f64::total_cmp);
        // Keep stations exactly.
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-3 * least;
        all.retain(|&z| stations.contains(&z) || !stations.iter().any(|&station| near(station, z)));
        all.dedup();
        Some(all)
    }
}
