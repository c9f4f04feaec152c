//! Acoustic transfer vectors and radiation impedance: the fluid as a linear map, computed once per
//! frequency for any number of velocities.

use calyx_numerics::vec3::Vector;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, c64};

/// Pressures at points per normal velocity of each triangle, at one frequency.
#[derive(Clone, Debug)]
pub struct TransferVectors {
    frequency: f64,
    points: Vec<Vector>,
    /// A column for each point, a row for each triangle, Pa s/m.
    vectors: Mat<c64>,
}

impl TransferVectors {
    pub(crate) fn new(frequency: f64, points: Vec<Vector>, vectors: Mat<c64>) -> Self {
        Self { frequency, points, vectors }
    }

    /// Returns the frequency, Hz.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// Returns the points, m.
    pub fn points(&self) -> &[Vector] {
        &self.points
    }

    /// Returns the vectors, Pa·s/m: a row for each triangle, a column for each point.
    pub fn vectors(&self) -> MatRef<'_, c64> {
        self.vectors.as_ref()
    }

    /// Returns the pressures of cases, Pa: a row for each point, a column for each case. A column
    /// of the argument has the normal velocities of the triangles in a case, m/s.
    ///
    /// # Panics
    /// The number of rows is not that of the triangles.
    pub fn pressures(&self, velocities: MatRef<'_, c64>) -> Mat<c64> {
        let mut pressures = Mat::zeros(self.points.len(), velocities.ncols());
        let one = c64::new(1.0, 0.0);
        matmul(pressures.as_mut(), Accum::Replace, self.vectors.transpose(), velocities, one, Par::Seq);
        pressures
    }

    /// Returns the contributions of panels to the pressure at a point, Pa. `panels` has the panel
    /// of each triangle, from 0 to `count`; triangles with larger numbers are omitted. The
    /// contributions of all triangles sum to the pressure.
    pub fn panel_contributions(
        &self,
        point: usize,
        velocities: &[c64],
        panels: &[usize],
        count: usize,
    ) -> Vec<c64> {
        let mut sums = vec![c64::new(0.0, 0.0); count];
        for (triangle, (velocity, panel)) in velocities.iter().zip(panels).enumerate() {
            if let Some(sum) = sums.get_mut(*panel) {
                *sum += self.vectors[(triangle, point)] * velocity;
            }
        }
        sums
    }
}

/// Radiation impedance of velocity patterns at one frequency: Z_ij = ∫ v_i* p_j dS, where p_j is
/// the pressure of the pattern j.
#[derive(Clone, Debug)]
pub struct RadiationImpedance {
    frequency: f64,
    impedance: Mat<c64>,
}

impl RadiationImpedance {
    pub(crate) fn new(frequency: f64, impedance: Mat<c64>) -> Self {
        Self { frequency, impedance }
    }

    /// Returns the frequency, Hz.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// Returns the matrix, W per product of two amplitudes.
    pub fn matrix(&self) -> MatRef<'_, c64> {
        self.impedance.as_ref()
    }

    /// Returns the radiated power of a combination of the patterns with these amplitudes, W.
    pub fn power(&self, amplitudes: &[c64]) -> f64 {
        let mut sum = 0.0;
        for (j, column) in amplitudes.iter().enumerate() {
            for (i, row) in amplitudes.iter().enumerate() {
                sum += 0.5 * (row.conj() * self.impedance[(i, j)] * column).re;
            }
        }
        sum
    }
}
