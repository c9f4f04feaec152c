//! What loads on sectors do to each other through the bore of a ring, however far apart they are.
//!
//! On a rigid bore teeth a few pitches apart hardly feel each other. On one that gives way they do all around: two opposite forces make
//! the whole ring oval. Tables for every pair of teeth would be large, and what they say is smooth. So the ring is first solved with a
//! series of the bore's displacements held at nought: now distant teeth hardly feel each other again. Then the amplitudes are let go:
//! they follow from the forces that held them, a few numbers a load, and the flexibility of the ring to such forces. Near teeth have
//! this in their tables; for distant ones it is all there is. (In the plane cuts are small, and distant teeth on a bore that nothing but means
//! hold are known through them, exactly: [`super::far_coupling`].)
//!
//! Where lugs hold the amplitudes ([`super::lugs`]), what they become depends on where the loaded tooth stands, and not only on how far ahead
//! the observed one is. Then no table has anything of it: it is added for near teeth as for distant ones, by the number of both.

use super::dense::{add_product, product};
use super::loose_lugs::LooseLugs;
use super::lugs::{LugForce, LugSet};
use super::ring::{Released, Shared};
use faer::{Mat, MatRef};

/// How teeth without a table of each other feel each other: a load by some forces, which move the other tooth's sector.
pub(crate) trait Coupling {
    /// Adds the forces of loads by columns of weights on the table of a side.
    fn add_felt(&self, forces: &mut Mat<f64>, side: usize, columns: MatRef<'_, f64>);

    /// No forces, for so many loads.
    fn unfelt(&self, loads: usize) -> Mat<f64>;

    /// What loads on a tooth do to others on another one: rows by the observed ones.
    fn compliance(&self, observed: (u32, &Mat<f64>), loaded: (u32, &Mat<f64>)) -> Mat<f64>;

    /// Stresses on a surface of a tooth under loads on another one, a column a load.
    fn stresses(&self, surface: usize, tooth: u32, loaded: (u32, &Mat<f64>)) -> Option<Mat<f64>>;
}

/// See the module. A load's forces are those that hold the bore against it, as its own sector sees them.
pub(crate) struct BoreCoupling {
    /// Equal sectors around.
    pub sectors: u32,
    /// Angle of a sector, rad.
    pub pitch: f64,
    /// How amplitudes turn from sector to sector.
    pub shared: Shared,
    /// Amplitudes by forces; with lugs in the body's frame, else in that of any sector.
    pub release: Mat<f64>,
    /// What holds the amplitudes, if anything does.
    pub lugs: Option<LugSet>,
    /// Lugs with clearance, if there are any.
    pub loose: Option<LooseLugs>,
    /// Forces by the unknowns of a table, for each loadable side.
    pub loads: Vec<Mat<f64>>,
    /// Stress by amplitudes, for each surface.
    pub stress: Vec<Mat<f64>>,
}

impl BoreCoupling {
    /// Without loads and stresses.
    pub fn new(released: Released, sectors: u32, pitch: f64) -> Self {
        let Released { shared, release, lugs, loose, .. } = released;
        Self { sectors, pitch, shared, release, lugs, loose, loads: Vec::new(), stress: Vec::new() }
    }

    /// Whether tables of near teeth have in them what teeth do to each other through the bore.
    pub fn is_in_tables(&self) -> bool {
        self.lugs.is_none()
    }

    /// Amplitudes as a tooth sees them.
    pub fn amplitudes(&self, observer: u32, (tooth, forces): (u32, &Mat<f64>)) -> Mat<f64> {
        let (observer, tooth) = (observer % self.sectors, tooth % self.sectors);
        let (mut amplitudes, ahead) = if self.lugs.is_some() {
            (product(self.release.as_ref(), self.in_body(tooth, forces).as_ref()), observer)
        } else {
            let ahead = (observer + self.sectors - tooth) % self.sectors;
            (product(self.release.as_ref(), forces.as_ref()), ahead)
        };
        self.shared.turn_rows(amplitudes.as_mut(), f64::from(ahead) * self.pitch);
        amplitudes
    }

    /// Forces of loads on a tooth in the body's frame.
    pub fn in_body(&self, tooth: u32, forces: &Mat<f64>) -> Mat<f64> {
        let mut forces = forces.clone();
        self.shared.turn_rows(forces.as_mut(), -f64::from(tooth % self.sectors) * self.pitch);
        forces
    }

    /// Forces of the lugs on the ring by forces in the body's frame; none without lugs.
    pub fn lug_forces(&self, in_body: &Mat<f64>) -> Vec<LugForce> {
        self.lugs.as_ref().map_or_else(Vec::new, |lugs| lugs.forces(in_body.as_ref()))
    }

    /// Displacements of loose lugs under loads on a tooth: lugs by loads; no rows without such lugs.
    pub fn lug_displacements(&self, tooth: u32, forces: &Mat<f64>) -> Mat<f64> {
        match &self.loose {
            Some(lugs) => product(lugs.by_amplitudes.as_ref(), self.in_body(tooth, forces).as_ref()),
            None => Mat::zeros(0, forces.ncols()),
        }
    }

    /// Amplitudes as a tooth sees them under forces of all loose lugs on the ring, a column; `None` without such lugs.
    pub fn amplitudes_by_lugs(&self, tooth: u32, forces: MatRef<'_, f64>) -> Option<Mat<f64>> {
        let mut amplitudes = product(self.loose.as_ref()?.by_amplitudes.transpose(), forces);
        self.shared.turn_rows(amplitudes.as_mut(), f64::from(tooth % self.sectors) * self.pitch);
        Some(amplitudes)
    }

    /// Stresses on a surface of a tooth under forces of all loose lugs on the ring, a column.
    pub fn stresses_by_lugs(&self, surface: usize, tooth: u32, forces: MatRef<'_, f64>) -> Option<Mat<f64>> {
        let amplitudes = self.amplitudes_by_lugs(tooth, forces)?;
        Some(product(self.stress.get(surface)?.as_ref(), amplitudes.as_ref()))
    }

    /// Memory, in bytes.
    pub fn bytes(&self) -> usize {
        let matrices = self.loads.iter().chain(&self.stress).chain([&self.release]);
        let lugs =
            self.lugs.as_ref().map_or(0, LugSet::bytes) + self.loose.as_ref().map_or(0, LooseLugs::bytes);
        matrices.map(|matrix| matrix.nrows() * matrix.ncols() * size_of::<f64>()).sum::<usize>() + lugs
    }
}

impl Coupling for BoreCoupling {
    /// Those that hold the bore against loads.
    fn add_felt(&self, forces: &mut Mat<f64>, side: usize, columns: MatRef<'_, f64>) {
        if let Some(loads) = self.loads.get(side) {
            add_product(forces.as_mut(), 1.0, loads.as_ref(), columns);
        }
    }

    fn unfelt(&self, loads: usize) -> Mat<f64> {
        Mat::zeros(self.shared.count, loads)
    }

    fn compliance(&self, observed: (u32, &Mat<f64>), loaded: (u32, &Mat<f64>)) -> Mat<f64> {
        product(observed.1.transpose(), self.amplitudes(observed.0, loaded).as_ref())
    }

    fn stresses(&self, surface: usize, tooth: u32, loaded: (u32, &Mat<f64>)) -> Option<Mat<f64>> {
        let stress = self.stress.get(surface)?;
        Some(product(stress.as_ref(), self.amplitudes(tooth, loaded).as_ref()))
    }
}
