//! Free vibrations about an equilibrium: natural frequencies and mode shapes, and whirl modes of
//! rotating systems.

use calyx_numerics::dense::skew_symmetric_eigen;
use faer::Mat;
use nalgebra::{Complex, DMatrix, SymmetricEigen};
use std::sync::{Arc, OnceLock};

/// Free vibrations: coordinates by modes. Coordinates are the DOFs, then the modal coordinates of
/// gears, body by body, then those of elastic connections.
#[derive(Clone, Debug, PartialEq)]
pub struct Vibrations {
    /// Natural frequencies without gyroscopic terms, rad/s, ascending; those of rigid-body motions
    /// are 0 within rounding.
    pub frequencies: Vec<f64>,
    /// Mass-normalized mode shapes, one per column: m and rad by DOF, m kg^1/2 per root of a metre
    /// by modal coordinate, per square root of kg.
    pub shapes: DMatrix<f64>,
    /// Mass matrix: kg, kg m and kg m² for DOFs.
    pub mass: DMatrix<f64>,
    /// Stiffness matrix: N/m, N and N m for DOFs.
    pub stiffness: DMatrix<f64>,
    /// Gyroscopic matrix at the prescribed speeds, skew-symmetric: kg m²/s for DOFs.
    pub gyroscopic: DMatrix<f64>,
    /// Form of the sense of whirl, see
    /// [`quarter_turn_momentum`](calyx_model::whirl::quarter_turn_momentum).
    pub whirl_form: DMatrix<f64>,
    /// Whirl modes at the prescribed speeds, computed on request.
    pub whirl: OnceLock<Option<Arc<WhirlModes>>>,
}

/// Modes of a rotating system, `(K - w² M + i w G) x = 0`, by ascending frequency. There are as
/// many as coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct WhirlModes {
    /// Frequencies w, rad/s.
    pub frequencies: Vec<f64>,
    /// Sense of whirl from -1 to 1: 1 if all moving parts whirl on circles in the sense of their
    /// own rotation (forward), -1 if against it (backward), 0 for motions along lines, for axial
    /// and for torsional modes. Parts count by their kinetic energy.
    pub senses: Vec<f64>,
}

impl Vibrations {
    /// Returns the fraction of a mode's kinetic energy in each coordinate; they add up to 1.
    pub fn energies(&self, mode: usize) -> Vec<f64> {
        let shape = self.shapes.column(mode);
        let momentum = &self.mass * shape;
        shape.iter().zip(momentum.iter()).map(|(moved, momentum)| moved * momentum).collect()
    }

    /// Returns the whirl modes at the prescribed speeds, computed once; `None` if a matrix is not
    /// finite.
    pub fn whirl(&self) -> Option<Arc<WhirlModes>> {
        self.whirl.get_or_init(|| self.whirl_at(1.0).map(Arc::new)).clone()
    }

    /// Computes the whirl modes with all speeds multiplied by a factor; `None` if a matrix is not
    /// finite.
    ///
    /// In the coordinates q of the modes without rotation, `q'' + H q' + W² q = 0` with the
    /// skew-symmetric `H = X' G X` and the diagonal W of their frequencies. The state `(q', W q)`
    /// has the skew-symmetric matrix `[-H, -W; W, 0]`. So frequencies are real, and those of
    /// rigid-body motions need no special treatment.
    pub fn whirl_at(&self, factor: f64) -> Option<WhirlModes> {
        let count = self.frequencies.len();
        let modal = |matrix: &DMatrix<f64>| self.shapes.transpose() * matrix * &self.shapes;
        let (gyroscopic, form) = (modal(&self.gyroscopic), modal(&self.whirl_form));
        // The opposite sign makes positive eigenvalues those of exp(i w t).
        let matrix =
            Mat::from_fn(2 * count, 2 * count, |i, j| match (i.checked_sub(count), j.checked_sub(count)) {
                (None, None) => 0.5 * factor * (gyroscopic[(i, j)] - gyroscopic[(j, i)]),
                (None, Some(j)) if i == j => self.frequencies[i],
                (Some(i), None) if i == j => -self.frequencies[i],
                _ => 0.0,
            });
        let (values, vectors) = skew_symmetric_eigen(matrix.as_ref())?;
        let frequencies: Vec<f64> = values[count..].iter().map(|value| value.max(0.0)).collect();
        let velocities = DMatrix::from_fn(count, count, |row, mode| {
            let velocity = vectors[(row, count + mode)];
            Complex::new(velocity.re, velocity.im)
        });
        let senses = senses(&frequencies, &velocities, &form);
        Some(WhirlModes { frequencies, senses })
    }
}

/// Relative difference of frequencies below which they are equal.
const EQUAL: f64 = 1e-9;

/// Returns the senses of modes, ascending within modes of equal frequency. `velocities` has their
/// velocities by column in coordinates of unit mass, and `form` is the form of the sense of whirl.
///
/// Any combination of modes of equal frequency is a mode. The modes with stationary senses are
/// those that diagonalize the form, so that translations of a rotor on equal springs are a forward
/// and a backward whirl.
fn senses(frequencies: &[f64], velocities: &DMatrix<Complex<f64>>, form: &DMatrix<f64>) -> Vec<f64> {
    let imaginary = form.map(|entry| Complex::new(0.0, -entry));
    let resolution = EQUAL * frequencies.last().copied().unwrap_or_default();
    let mut senses = Vec::with_capacity(frequencies.len());
    while senses.len() < frequencies.len() {
        let first = senses.len();
        let equal = |next: f64| next - frequencies[first] <= EQUAL * frequencies[first] + 1e-3 * resolution;
        let size = frequencies[first..].iter().take_while(|next| equal(**next)).count().max(1);
        let own = velocities.columns(first, size).clone_owned();
        let energies: Vec<f64> = own.column_iter().map(|velocity| velocity.norm()).collect();
        // Rigid-body displacements without velocity have no sense.
        let own = DMatrix::from_fn(own.nrows(), size, |row, k| match energies[k] {
            norm if norm > EQUAL => own[(row, k)] / Complex::from(norm),
            _ => Complex::from(0.0),
        });
        let stationary = SymmetricEigen::new(own.adjoint() * &imaginary * &own).eigenvalues;
        let mut stationary: Vec<f64> = stationary.iter().map(|value| value.clamp(-1.0, 1.0)).collect();
        stationary.sort_by(f64::total_cmp);
        senses.extend(stationary);
    }
    senses
}
