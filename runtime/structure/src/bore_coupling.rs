//! Coupling of loads with what supports the bore of a ring.
//!
//! The ring is first solved with a series of the bore's displacements fixed at zero. Then the
//! amplitudes are released: they follow from their constraint forces, a few numbers for each load,
//! and the flexibility of the ring to such forces. The tables of near teeth and
//! [`super::far_coupling::FarCoupling`] include this part; contact on the bore outside of the
//! structure ([`super::bore_interface`]) uses it.
//!
//! If spline teeth support the amplitudes ([`super::spline_teeth`]), the released amplitudes depend
//! on the position of the loaded tooth, and not only on the distance of the observed one. In this
//! case neither includes this part: it is added for all pairs of teeth, from the indices of both.
//!
//! See `docs/theory/substructures.md`.

use super::bore_interface::BoreInterface;
use super::dense::{Interruptible, product};
use super::ring::{ReleasedMeans, SharedUnknowns};
use super::spline_teeth::{SplineToothForce, SplineToothSet};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};

/// Coupling of teeth without a common table: a load has some equivalent forces, which displace the
/// other tooth's sector.
pub(crate) trait Coupling {
    /// Returns the number of equivalent forces.
    fn count(&self) -> usize;

    /// Returns the equivalent forces by the unknowns of a table, for a loadable side.
    fn by_loads(&self, side: usize) -> Option<&Mat<f64>>;

    /// Returns the compliance between loads on two teeth: rows by the observed ones.
    ///
    /// # Errors
    /// The computation is interrupted.
    fn compliance(
        &self,
        observed: (u32, &Mat<f64>),
        loaded: (u32, &Mat<f64>),
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError>;

    /// Returns the stresses on a surface of a tooth under loads on another one, one column for each
    /// load.
    fn stresses(&self, surface: usize, tooth: u32, loaded: (u32, &Mat<f64>)) -> Option<Mat<f64>>;
}

/// Coupling with what supports the bore. See the module documentation. The equivalent forces of a
/// load are its constraint forces on the bore, in the frame of its own sector.
pub(crate) struct BoreCoupling {
    /// Number of equal sectors around the ring.
    pub sectors: u32,
    /// Angle of a sector, rad.
    pub pitch: f64,
    /// Rotation of the amplitudes from sector to sector.
    pub shared: SharedUnknowns,
    /// Flexibility: amplitudes per unit force, in the body's frame with spline teeth, otherwise in
    /// the frame of any sector.
    pub release: Mat<f64>,
    /// Spline teeth that support the amplitudes, if any.
    pub spline_teeth: Option<SplineToothSet>,
    /// Displacements of the bore on which contact outside of the structure acts, if any.
    pub interface: Option<BoreInterface>,
    /// Equivalent forces per unit of the unknowns of a table, for each loadable side.
    pub loads: Vec<Mat<f64>>,
    /// Stress per unit amplitude, for each surface.
    pub stress: Vec<Mat<f64>>,
}

impl BoreCoupling {
    /// Builds the coupling without loads and stresses.
    pub fn new(released: ReleasedMeans, sectors: u32, pitch: f64) -> Self {
        let ReleasedMeans { shared, release, spline_teeth, interface, .. } = released;
        Self {
            sectors,
            pitch,
            shared,
            release,
            spline_teeth,
            interface,
            loads: Vec::new(),
            stress: Vec::new(),
        }
    }

    /// Returns true if the tables and the coupling of distant teeth include this one.
    pub fn is_in_tables(&self) -> bool {
        self.spline_teeth.is_none()
    }

    /// Returns the amplitudes in the frame of a tooth.
    ///
    /// # Errors
    /// The computation is interrupted.
    pub fn amplitudes(
        &self,
        observer: u32,
        (tooth, forces): (u32, &Mat<f64>),
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        let checkpoint = || interrupt.check();
        let dense = Interruptible(&checkpoint);
        let (observer, tooth) = (observer % self.sectors, tooth % self.sectors);
        let (mut amplitudes, ahead) = if self.spline_teeth.is_some() {
            (dense.product(self.release.as_ref(), self.in_body(tooth, forces).as_ref())?, observer)
        } else {
            let ahead = (observer + self.sectors - tooth) % self.sectors;
            (dense.product(self.release.as_ref(), forces.as_ref())?, ahead)
        };
        self.shared.turn_rows(amplitudes.as_mut(), f64::from(ahead) * self.pitch);
        Ok(amplitudes)
    }

    /// Returns the equivalent forces of loads on a tooth in the body's frame.
    pub fn in_body(&self, tooth: u32, forces: &Mat<f64>) -> Mat<f64> {
        let mut forces = forces.clone();
        self.shared.turn_rows(forces.as_mut(), -f64::from(tooth % self.sectors) * self.pitch);
        forces
    }

    /// Returns the forces of the spline teeth on the ring by forces in the body's frame; empty
    /// without spline teeth.
    pub fn spline_tooth_forces(&self, in_body: &Mat<f64>) -> Vec<SplineToothForce> {
        self.spline_teeth.as_ref().map_or_else(Vec::new, |spline_teeth| spline_teeth.forces(in_body.as_ref()))
    }

    /// Returns the displacements of the interface under loads on a tooth: displacements by loads;
    /// no rows without an interface.
    pub fn interface_displacements(&self, tooth: u32, forces: &Mat<f64>) -> Mat<f64> {
        match &self.interface {
            Some(interface) => {
                product(interface.by_amplitudes.as_ref(), self.in_body(tooth, forces).as_ref())
            }
            None => Mat::zeros(0, forces.ncols()),
        }
    }

    /// Returns the amplitudes in the frame of a tooth under forces on all displacements of the
    /// interface, as a column; `None` without an interface.
    pub fn amplitudes_by_interface(&self, tooth: u32, forces: MatRef<'_, f64>) -> Option<Mat<f64>> {
        let mut amplitudes = product(self.interface.as_ref()?.by_amplitudes.transpose(), forces);
        self.shared.turn_rows(amplitudes.as_mut(), f64::from(tooth % self.sectors) * self.pitch);
        Some(amplitudes)
    }

    /// Returns the stresses on a surface of a tooth under forces on all displacements of the
    /// interface, as a column.
    pub fn stresses_by_interface(
        &self,
        surface: usize,
        tooth: u32,
        forces: MatRef<'_, f64>,
    ) -> Option<Mat<f64>> {
        let amplitudes = self.amplitudes_by_interface(tooth, forces)?;
        Some(product(self.stress.get(surface)?.as_ref(), amplitudes.as_ref()))
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        let matrices = self.loads.iter().chain(&self.stress).chain([&self.release]);
        let spline_teeth = self.spline_teeth.as_ref().map_or(0, SplineToothSet::bytes)
            + self.interface.as_ref().map_or(0, BoreInterface::bytes);
        matrices.map(|matrix| matrix.nrows() * matrix.ncols() * size_of::<f64>()).sum::<usize>()
            + spline_teeth
    }
}

impl Coupling for BoreCoupling {
    fn count(&self) -> usize {
        self.shared.count
    }

    fn by_loads(&self, side: usize) -> Option<&Mat<f64>> {
        self.loads.get(side)
    }

    fn compliance(
        &self,
        observed: (u32, &Mat<f64>),
        loaded: (u32, &Mat<f64>),
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        let checkpoint = || interrupt.check();
        let amplitudes = self.amplitudes(observed.0, loaded, interrupt)?;
        Interruptible(&checkpoint).product(observed.1.transpose(), amplitudes.as_ref())
    }

    fn stresses(&self, surface: usize, tooth: u32, loaded: (u32, &Mat<f64>)) -> Option<Mat<f64>> {
        let stress = self.stress.get(surface)?;
        let amplitudes = self.amplitudes(tooth, loaded, &Interrupt::never()).ok()?;
        Some(product(stress.as_ref(), amplitudes.as_ref()))
    }
}
