//! Unknowns that all sectors of a ring share: the forces of mean constraints on its bore.
//!
//! Each sector uses them in its own frame, so that all sectors have the same matrix: from one
//! sector to the next, a cosine-sine pair of harmonic `k` rotates by `k` times the sector's angle.

use faer::{Mat, MatMut, MatRef};
use std::f64::consts::TAU;

/// Transformation of shared unknowns under rotation.
#[derive(Clone, Debug, Default)]
pub(crate) struct SharedUnknowns {
    /// Number of unknowns.
    pub count: usize,
    /// Pairs that rotate: indices of cosine and sine, and their harmonic.
    pub pairs: Vec<([usize; 2], f64)>,
}

impl SharedUnknowns {
    /// Transforms rows of unknowns of one frame to another that is rotated by `angle` about the
    /// axis, in place.
    pub fn turn_rows(&self, mut rows: MatMut<'_, f64>, angle: f64) {
        for &([of_cosine, of_sine], harmonic) in &self.pairs {
            let (sin, cos) = (harmonic * angle).sin_cos();
            for column in 0..rows.ncols() {
                let (a, b) = (rows[(of_cosine, column)], rows[(of_sine, column)]);
                rows[(of_cosine, column)] = cos * a + sin * b;
                rows[(of_sine, column)] = cos * b - sin * a;
            }
        }
    }

    /// Returns the unknowns from index `first` on.
    pub fn from(&self, first: usize) -> SharedUnknowns {
        let later = self.pairs.iter().filter(|(places, _)| places[0] >= first);
        SharedUnknowns {
            count: self.count - first,
            pairs: later.map(|&(places, harmonic)| (places.map(|place| place - first), harmonic)).collect(),
        }
    }

    /// Returns the sum over the sectors of a bilinear form of unknowns, given for one sector in its
    /// own frame.
    pub fn around(&self, form: MatRef<'_, f64>, sectors: u32) -> Mat<f64> {
        let mut sum = Mat::zeros(self.count, self.count);
        for sector in 0..sectors {
            let before = f64::from(sector) * TAU / f64::from(sectors);
            let once = self.turned_back(form, before);
            sum += self.turned_back(once.transpose(), before).transpose();
        }
        sum
    }

    /// Transforms columns that multiply unknowns of a frame rotated by `angle` to columns that
    /// multiply those of the first frame.
    pub fn turned_back(&self, columns: MatRef<'_, f64>, angle: f64) -> Mat<f64> {
        let mut rows = columns.transpose().to_owned();
        self.turn_rows(rows.as_mut(), -angle);
        rows.transpose().to_owned()
    }
}
