//! Responses of a body's mesh to all loads: as one problem, or as one problem for each half of a
//! mirror-symmetric body.

use super::exchange::{LoadsAndRows, Sector};
use super::mirror_symmetry::MirrorMap;
use crate::StructureError;
use crate::condense::{Assembled, Condensed, Cuts, Support, condense};
use crate::dense::Interruptible;
use crate::elastic::{Response, response, starts};
use crate::far_coupling::FarResponse;
use crate::ring::{ReleasedMeans, RingFlexibility};
use calyx_fe::SparseVector;
use calyx_fe::solid::SolidModel;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use faer::{Mat, MatRef};
use rayon::prelude::*;
use std::sync::Arc;

/// Assembles the equations of a whole mesh.
pub(super) fn whole(model: &SolidModel, interrupt: &Interrupt) -> Result<Assembled, StructureError> {
    Assembled::solid(&model.mesh, interrupt, || model.stiffness_until(|| interrupt.check()))
}

/// Responses of a body with uncoupled parts.
pub(super) struct Responses {
    loads: usize,
    rows: usize,
    parts: Vec<Part>,
    /// Responses of sectors beyond the window.
    pub far: Option<FarResponse>,
    /// Coupling of loads with what supports the bore.
    pub bore: Option<BoreResponse>,
}

/// Coupling of loads with the released amplitudes of the bore.
pub(super) struct BoreResponse {
    pub released: ReleasedMeans,
    /// Constraint forces of the amplitudes for each load.
    pub forces: Mat<f64>,
    /// Each row by amplitudes.
    pub stresses: Mat<f64>,
}

struct Part {
    condensed: Condensed,
    ring: Option<RingFlexibility>,
    /// Indices of its loads among all.
    loads: Vec<usize>,
    /// For each of all rows, its index in this part and a sign; `None` if it is zero there.
    rows: Vec<Option<(usize, f64)>>,
}

impl Part {
    fn whole(condensed: Condensed, ring: Option<RingFlexibility>, exchange: &LoadsAndRows) -> Self {
        let rows = (0..exchange.rows.len()).map(|row| Some((row, 1.0))).collect();
        Self { condensed, ring, loads: (0..exchange.loads.len()).collect(), rows }
    }
}

impl Responses {
    /// Builds the responses of a body that was condensed in one piece.
    pub fn of_body(condensed: Condensed, exchange: &LoadsAndRows) -> Self {
        Self::of(vec![Part::whole(condensed, None, exchange)], exchange)
    }

    /// Builds the responses of a ring of sectors: by halves, if `mirrored` is given.
    pub fn for_ring(
        model: &SolidModel,
        sector: &Sector,
        mirrored: Option<&MirrorMap>,
        exchange: &LoadsAndRows,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        let condensed = |assembled: &Assembled,
                         constrained: &[usize],
                         cuts: &Cuts,
                         loads: &[SparseVector],
                         rows: &[SparseVector]| {
            let support = Support::for_ring(constrained, sector.means.as_ref());
            let condensed = condense(assembled, &support, Some(cuts), loads, rows, interrupt)?;
            let ring = |cut| RingFlexibility::new(cut, sector.sectors, sector.coupled, interrupt);
            let ring = condensed.stiffness.as_ref().map(ring).transpose()?;
            Ok::<_, StructureError>((condensed, ring))
        };
        let Some(mirrored) = mirrored.filter(|_| sector.means.is_none()) else {
            let assembled = whole(model, interrupt)?;
            let constrained = assembled.dofs_of(&sector.constrained);
            let (condensed, mut ring) =
                condensed(&assembled, &constrained, &sector.cuts, &exchange.loads, &exchange.rows)?;
            let released = match (&mut ring, &sector.means) {
                (Some(ring), Some(means)) => means.release(ring, interrupt)?,
                _ => None,
            };
            let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
            let dense = Interruptible(&checkpoint);
            let response = |released: ReleasedMeans| {
                let by_cuts = released.constraint_forces.as_ref();
                Ok::<_, StructureError>(BoreResponse {
                    forces: dense.product(by_cuts, condensed.on_cuts.as_ref())?,
                    stresses: dense.product(condensed.rows_cuts.as_ref(), by_cuts.transpose())?,
                    released,
                })
            };
            let bore = released.map(response).transpose()?;
            let responses = Self::of(vec![Part::whole(condensed, ring, exchange)], exchange);
            return Ok(Self { bore, ..responses.with_far(interrupt)? });
        };
        // The folded vectors of both halves together are as large as those of the whole.
        let folded = exchange.rooms.iter().map(MemoryReservation::bytes).sum();
        let _room = interrupt.reserve_memory(folded).map_err(StructureError::Interrupted)?;
        let equations = mirrored.equations(model, interrupt)?;
        let of_half = |(assembled, odd): (Arc<Assembled>, bool)| {
            let half = mirrored.half(odd, sector, exchange);
            let (loads, rows) = (&half.loads.vectors, &half.rows.vectors);
            let (condensed, ring) = condensed(&assembled, &half.constrained, &half.cuts, loads, rows)?;
            Ok(Part { condensed, ring, loads: half.loads.numbers, rows: half.rows.numbers })
        };
        let parts = equations
            .into_par_iter()
            .zip([false, true])
            .map(of_half)
            .collect::<Result<_, StructureError>>()?;
        Self::of(parts, exchange).with_far(interrupt)
    }

    fn of(parts: Vec<Part>, exchange: &LoadsAndRows) -> Self {
        Self { loads: exchange.loads.len(), rows: exchange.rows.len(), parts, far: None, bore: None }
    }

    /// Adds the responses of the sectors outside the window.
    fn with_far(self, interrupt: &Interrupt) -> Result<Self, StructureError> {
        let own = |part: &Part| match &part.ring {
            Some(ring) => FarResponse::new(&part.condensed, ring, interrupt),
            None => Ok(None),
        };
        let by_part = self.parts.iter().map(own).collect::<Result<Option<Vec<_>>, _>>()?;
        let Some(by_part) = by_part else { return Ok(self) };
        let far = self.combined(&by_part);
        Ok(Self { far, ..self })
    }

    /// Returns the responses of distant sectors to all loads: the parts have separate modes.
    fn combined(&self, by_part: &[FarResponse]) -> Option<FarResponse> {
        let first = by_part.first()?.first;
        let of_loads = starts(by_part.iter().map(|far| far.loads.nrows()));
        let of_modes = starts(by_part.iter().map(|far| far.rows.ncols()));
        let mut loads = Mat::zeros(*of_loads.last()?, self.loads);
        let mut rows = Mat::zeros(self.rows, *of_modes.last()?);
        for (place, (part, far)) in self.parts.iter().zip(by_part).enumerate() {
            for (column, &load) in part.loads.iter().enumerate() {
                let mut target = loads.as_mut().col_mut(load).subrows_mut(of_loads[place], far.loads.nrows());
                target.copy_from(far.loads.col(column));
            }
            for (row, own) in part.rows.iter().enumerate() {
                if let Some((own, sign)) = *own {
                    let mut target =
                        rows.as_mut().row_mut(row).subcols_mut(of_modes[place], far.rows.ncols());
                    target.copy_from(far.rows.row(own) * faer::Scale(sign));
                }
            }
        }
        let distances = 0..by_part[0].by_offset.len();
        let diagonal = |of: &dyn Fn(&FarResponse, usize) -> MatRef<'_, f64>| -> Vec<Mat<f64>> {
            distances.clone().map(|place| block_diagonal(by_part.iter().map(|far| of(far, place)))).collect()
        };
        let by_offset = diagonal(&|far, place| far.by_offset[place].as_ref());
        let modes = [0, 1].map(|side| diagonal(&|far, place| far.modes[side][place].as_ref()));
        Some(FarResponse { first, by_offset, loads, modes, rows })
    }

    /// Returns the largest distance of a sector from a loaded one in the responses.
    pub fn window(&self) -> u32 {
        self.parts
            .iter()
            .filter_map(|part| part.ring.as_ref())
            .map(RingFlexibility::window)
            .min()
            .unwrap_or(0)
    }

    /// Returns the responses of the sector at an offset ahead of a loaded one.
    pub fn at(&self, offset: u32, interrupt: &Interrupt) -> Result<Response, StructureError> {
        let own = |part: &Part| response(&part.condensed, part.ring.as_ref(), offset, interrupt);
        let mut all = Response {
            compliance: Mat::zeros(self.loads, self.loads),
            stress_ahead: Mat::zeros(self.rows, self.loads),
            stress_behind: (offset > 0).then(|| Mat::zeros(self.rows, self.loads)),
        };
        for part in &self.parts {
            let own = own(part)?;
            for (column, &load) in part.loads.iter().enumerate() {
                for (row, &observer) in part.loads.iter().enumerate() {
                    all.compliance[(observer, load)] = own.compliance[(row, column)];
                }
                for (row, place) in part.rows.iter().enumerate() {
                    if let Some((place, sign)) = *place {
                        all.stress_ahead[(row, load)] = sign * own.stress_ahead[(place, column)];
                        if let (Some(all), Some(own)) = (&mut all.stress_behind, &own.stress_behind) {
                            all[(row, load)] = sign * own[(place, column)];
                        }
                    }
                }
            }
        }
        Ok(all)
    }
}

/// Returns a matrix with blocks along its diagonal.
fn block_diagonal<'a>(blocks: impl Iterator<Item = MatRef<'a, f64>>) -> Mat<f64> {
    let mut all = Mat::zeros(0, 0);
    for block in blocks {
        let (rows, columns) = (all.nrows(), all.ncols());
        all.resize_with(rows + block.nrows(), columns + block.ncols(), |_, _| 0.0);
        all.as_mut().submatrix_mut(rows, columns, block.nrows(), block.ncols()).copy_from(block);
    }
    all
}
