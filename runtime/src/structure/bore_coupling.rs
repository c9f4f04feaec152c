//! What loads on sectors do to each other through the bore of a ring, however far apart they are.
//!
//! On a rigid bore teeth a few pitches apart hardly feel each other. On one that gives way they do all around: two opposite forces make
//! the whole ring oval. Tables for every pair of teeth would be large, and what they say is smooth. So the ring is first solved with a
//! series of the bore's displacements held at nought: now distant teeth hardly feel each other again. Then the amplitudes are let go:
//! they follow from the forces that held them, a few numbers a load, and the flexibility of the ring to such forces. Near teeth have
//! this in their tables; for distant ones it is all there is.

use super::dense::{add_product, product};
use super::ring::{Released, Shared};
use faer::{Mat, MatRef};

/// See the module. A load's forces are those that hold the bore against it, as its own sector sees them.
pub(crate) struct BoreCoupling {
    /// Angle of a sector, rad.
    pub pitch: f64,
    /// How amplitudes turn from sector to sector.
    pub shared: Shared,
    /// Amplitudes by forces.
    pub release: Mat<f64>,
    /// Forces by the unknowns of a table, for each loadable side.
    pub loads: Vec<Mat<f64>>,
    /// Stress by amplitudes, for each surface.
    pub stress: Vec<Mat<f64>>,
}

impl BoreCoupling {
    /// Without loads and stresses.
    pub fn new(released: &Released, pitch: f64) -> Self {
        let (shared, release) = (released.shared.clone(), released.release.clone());
        Self { pitch, shared, release, loads: Vec::new(), stress: Vec::new() }
    }

    /// Adds the forces that hold the bore against loads by columns of weights on the table of a side.
    pub fn add_felt(&self, forces: &mut Mat<f64>, side: usize, columns: MatRef<'_, f64>) {
        if let Some(loads) = self.loads.get(side) {
            add_product(forces.as_mut(), 1.0, loads.as_ref(), columns);
        }
    }

    /// No forces, for so many loads.
    pub fn unfelt(&self, loads: usize) -> Mat<f64> {
        Mat::zeros(self.shared.count, loads)
    }

    /// What some loads do to others, `ahead` sectors ahead of them: rows by the ones ahead.
    pub fn compliance(&self, ahead: u32, observed: &Mat<f64>, loaded: &Mat<f64>) -> Mat<f64> {
        product(observed.transpose(), self.amplitudes(ahead, loaded).as_ref())
    }

    /// Stresses on a surface `ahead` sectors ahead of loads, a column a load.
    pub fn stresses(&self, surface: usize, ahead: u32, loaded: &Mat<f64>) -> Option<Mat<f64>> {
        let stress = self.stress.get(surface)?;
        Some(product(stress.as_ref(), self.amplitudes(ahead, loaded).as_ref()))
    }

    fn amplitudes(&self, ahead: u32, loaded: &Mat<f64>) -> Mat<f64> {
        let mut amplitudes = product(self.release.as_ref(), loaded.as_ref());
        self.shared.turn_rows(amplitudes.as_mut(), f64::from(ahead) * self.pitch);
        amplitudes
    }

    /// Memory, in bytes.
    pub fn bytes(&self) -> usize {
        let matrices = self.loads.iter().chain(&self.stress).chain([&self.release]);
        matrices.map(|matrix| matrix.nrows() * matrix.ncols() * size_of::<f64>()).sum()
    }
}
