//! Unknowns that all sectors of a ring share: the forces that hold a mean of its bore.
//!
//! Each sector sees them in its own frame, so that all have the same matrix: from one sector to the next a pair of cosine and
//! sine with `k` waves around turns by `k` times the sector's angle.

use faer::{Mat, MatMut, MatRef};
use std::f64::consts::TAU;

/// How shared unknowns turn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shared {
    /// How many there are.
    pub count: usize,
    /// Those that turn: places of cosine and sine, and their waves around.
    pub pairs: Vec<([usize; 2], f64)>,
}

impl Shared {
    /// Rows of unknowns of one frame in another that is turned by `angle` about the axis, in place.
    pub fn turn_rows(&self, mut rows: MatMut<'_, f64>, angle: f64) {
        for &([of_cosine, of_sine], waves) in &self.pairs {
            let (sin, cos) = (waves * angle).sin_cos();
            for column in 0..rows.ncols() {
                let (a, b) = (rows[(of_cosine, column)], rows[(of_sine, column)]);
                rows[(of_cosine, column)] = cos * a + sin * b;
                rows[(of_sine, column)] = cos * b - sin * a;
            }
        }
    }

    /// Those from number `first` on.
    pub fn from(&self, first: usize) -> Shared {
        let later = self.pairs.iter().filter(|(places, _)| places[0] >= first);
        Shared {
            count: self.count - first,
            pairs: later.map(|&(places, waves)| (places.map(|place| place - first), waves)).collect(),
        }
    }

    /// The sum over so many sectors of a form of unknowns, given for one of them by the unknowns as it sees them.
    pub fn around(&self, form: MatRef<'_, f64>, sectors: u32) -> Mat<f64> {
        let mut sum = Mat::zeros(self.count, self.count);
        for sector in 0..sectors {
            let before = f64::from(sector) * TAU / f64::from(sectors);
            let once = self.turned_back(form, before);
            sum += self.turned_back(once.transpose(), before).transpose();
        }
        sum
    }

    /// Columns that multiply unknowns of a frame turned by `angle`, as columns that multiply those of the first frame.
    pub fn turned_back(&self, columns: MatRef<'_, f64>, angle: f64) -> Mat<f64> {
        let mut rows = columns.transpose().to_owned();
        self.turn_rows(rows.as_mut(), -angle);
        rows.transpose().to_owned()
    }
}
