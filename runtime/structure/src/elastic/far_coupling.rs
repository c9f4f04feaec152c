//! Coupling of arbitrarily distant sectors in plane models without a table for each pair.
//!
//! On a compliant bore a thin ring carries a load all around, and no series below the teeth
//! represents this exactly. But all coupling passes through cuts: beyond its sector a load acts as
//! forces on both cuts and on the mean constraints, a few numbers, and one small matrix gives the
//! resulting displacements of another sector. For distant teeth only the response of the ring at
//! the cuts is stored, for every distance. In three-dimensional models cuts have too many unknowns
//! for this: see [`crate::bore_coupling`].

use super::Prepared;
use crate::bore_coupling::Coupling;
use crate::condense::Condensed;
use crate::dense::{add_product, product};
use crate::ring::RingFlexibility;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};

/// Coupling through cuts. See the module documentation. The equivalent forces of a load are those
/// on the cuts of its sector and on the mean constraints, in the frame of the sector.
pub(crate) struct FarCoupling {
    /// Number of equal sectors around the ring.
    pub sectors: u32,
    /// Smallest distance in sectors without a table.
    pub first: u32,
    /// Displacements of the sector ahead by forces on this one, by distance from there to halfway
    /// round.
    pub by_offset: Vec<Mat<f64>>,
    /// Equivalent forces by the unknowns of a table, for each loadable side.
    pub loads: Vec<Mat<f64>>,
    /// Stress by displacements, for each surface.
    pub stress: Vec<Mat<f64>>,
}

impl FarCoupling {
    /// Returns the memory of [`FarCoupling::new`], bytes.
    pub(crate) fn bytes_of(condensed: &Condensed, ring: &RingFlexibility, first: u32) -> u64 {
        let far = (ring.window() + 1).saturating_sub(first) as usize;
        let (cuts, loads) = (condensed.on_cuts.nrows(), condensed.on_cuts.ncols());
        let numbers =
            if far == 0 { 0 } else { cuts * (far * cuts + 2 * loads + condensed.rows_cuts.nrows()) };
        (size_of::<f64>() * numbers) as u64
    }

    /// Builds the coupling of sectors at least `first` apart on a ring whose flexibility covers all
    /// distances; `None` if there are no such sectors.
    pub(crate) fn new(
        condensed: &Condensed,
        prepared: &[Prepared],
        ring: &RingFlexibility,
        (sectors, first): (u32, u32),
    ) -> Option<Self> {
        let by_offset: Vec<Mat<f64>> =
            (first..=ring.window()).map(|offset| ring.at(offset).to_owned()).collect();
        (!by_offset.is_empty()).then_some(())?;
        let (mut loads, mut stress) = (Vec::new(), Vec::new());
        let (mut load, mut row) = (0, 0);
        for surface in prepared {
            for of_direction in &surface.loads {
                let table = condensed.on_cuts.as_ref().subcols(load, of_direction.len());
                loads.push(surface.surface.spline.coefficients(table.transpose()).transpose().to_owned());
                load += of_direction.len();
            }
            let rows = surface.stress_rows.len();
            stress.push(condensed.rows_cuts.as_ref().subrows(row, rows).to_owned());
            row += rows;
        }
        Some(Self { sectors, first, by_offset, loads, stress })
    }

    /// Returns the cut displacements of an observer's sector, in its own frame, by forces on a
    /// tooth. `None` for near teeth.
    fn displacements(&self, observer: u32, (tooth, forces): (u32, &Mat<f64>)) -> Option<Mat<f64>> {
        let places =
            |from: u32, to: u32| (to % self.sectors + self.sectors - from % self.sectors) % self.sectors;
        let (ahead, behind) = (places(tooth, observer), places(observer, tooth));
        let ring = self.by_offset.get(ahead.min(behind).checked_sub(self.first)? as usize)?;
        Some(if ahead <= behind {
            product(ring.as_ref(), forces.as_ref())
        } else {
            product(ring.transpose(), forces.as_ref())
        })
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        let matrices = self.by_offset.iter().chain(&self.loads).chain(&self.stress);
        matrices.map(|matrix| matrix.nrows() * matrix.ncols() * size_of::<f64>()).sum()
    }
}

impl Coupling for FarCoupling {
    fn add_coupling_forces(&self, forces: &mut Mat<f64>, side: usize, columns: MatRef<'_, f64>) {
        if let Some(loads) = self.loads.get(side) {
            add_product(forces.as_mut(), 1.0, loads.as_ref(), columns);
        }
    }

    fn no_coupling_forces(&self, loads: usize) -> Mat<f64> {
        Mat::zeros(self.loads.first().map_or(0, Mat::nrows), loads)
    }

    // The matrices of a cut in a plane model are small.
    fn compliance(
        &self,
        observed: (u32, &Mat<f64>),
        loaded: (u32, &Mat<f64>),
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        interrupt.check()?;
        Ok(match self.displacements(observed.0, loaded) {
            Some(moved) => product(observed.1.transpose(), moved.as_ref()),
            None => Mat::zeros(observed.1.ncols(), loaded.1.ncols()),
        })
    }

    fn stresses(&self, surface: usize, tooth: u32, loaded: (u32, &Mat<f64>)) -> Option<Mat<f64>> {
        let stress = self.stress.get(surface)?;
        Some(product(stress.as_ref(), self.displacements(tooth, loaded)?.as_ref()))
    }
}
