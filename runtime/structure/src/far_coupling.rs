//! Coupling of arbitrarily distant sectors without a table for each pair.
//!
//! All coupling passes through cuts: outside its sector a load acts only through the cuts that
//! bound its surroundings and the mean constraints. Far from the load displacements are smooth,
//! whatever the support of the bore: rigid-body motions of the tooth ring against a small bore, and
//! the oval shape of a thin rim. A few loads therefore have the same effects as all: with `B` the
//! equivalent forces of the loads on the cuts, `B_J` those of the selected ones and `F_d` the
//! displacements of the cuts of the sector `d` ahead by forces on those of the loaded one,
//!
//! ```text
//! F_d B = F_d B_J C,   B^T F_d B = C^T (B_J^T F_d B_J) C
//! ```
//!
//! (an interpolative decomposition). A few modes represent the displacements of all distant
//! sectors, from which their stresses follow. Loads and modes are selected by Gram-Schmidt
//! orthogonalization with pivoting.
//!
//! See `docs/theory/substructures.md`.

use crate::bore_coupling::Coupling;
use crate::condense::Condensed;
use crate::dense::{Interruptible, product};
use crate::error::StructureError;
use crate::ring::RingFlexibility;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::{Mat, MatRef};

/// Displacements that the selected loads and modes do not represent, relative to the largest ones.
const UNREPRESENTED: f64 = 1e-10;

/// Responses of distant sectors to the loads of a body.
pub(crate) struct FarResponse {
    /// Smallest distance of the sectors.
    pub first: u32,
    /// Displacements at the selected loads of the sector ahead by those of this one, by distance
    /// from `first` to halfway round.
    pub by_offset: Vec<Mat<f64>>,
    /// Selected loads that are equivalent to each load, one column each.
    pub loads: Mat<f64>,
    /// Modes of the sector ahead, and of the one behind, by selected loads; by distance as above.
    pub modes: [Vec<Mat<f64>>; 2],
    /// Stress rows by modes.
    pub rows: Mat<f64>,
}

impl FarResponse {
    /// Builds the responses of the sectors outside the window of a ring's flexibility; `None` if
    /// there are none.
    ///
    /// # Errors
    /// Memory is insufficient, or the computation is interrupted.
    pub fn new(
        condensed: &Condensed,
        ring: &RingFlexibility,
        interrupt: &Interrupt,
    ) -> Result<Option<Self>, StructureError> {
        let offsets = ring.offsets_outside();
        if offsets.is_empty() || condensed.on_cuts.ncols() == 0 {
            return Ok(None);
        }
        let checkpoint = || interrupt.check().map_err(StructureError::Interrupted);
        let dense = Interruptible(&checkpoint);
        let on_cuts = condensed.on_cuts.as_ref();
        let (unknowns, n) = (on_cuts.nrows(), ring.cut_size());
        // Distant sectors follow the cuts that bound the window, and the shared unknowns.
        let window = ring.at(ring.window());
        let mut bounds = Mat::zeros(unknowns, on_cuts.ncols());
        dense.add_product(bounds.as_mut().subrows_mut(0, n), 1.0, window.subrows(n, n), on_cuts)?;
        dense.add_product(
            bounds.as_mut().subrows_mut(n, n),
            1.0,
            window.subcols(0, n).transpose(),
            on_cuts,
        )?;
        let shared = ring.at(0).subrows(2 * n, unknowns - 2 * n);
        dense.add_product(bounds.as_mut().subrows_mut(2 * n, unknowns - 2 * n), 1.0, shared, on_cuts)?;
        let bounds = scaled(&bounds, n, shared_scale(&bounds, n));
        let Basis { chosen, vectors } = Basis::of(bounds.clone(), &checkpoint)?;
        let shares = dense.product(vectors.transpose(), bounds.as_ref())?;
        let loads = interpolation(&chosen, shares);
        let forces = columns(on_cuts, &chosen);
        let bytes = size_of::<f64>() * unknowns * chosen.len() * (3 * offsets.len() + 1);
        let _room = interrupt.reserve_memory(bytes as u64).map_err(StructureError::Interrupted)?;
        let displaced = ring.outside(forces.as_ref(), interrupt)?;
        let half = (ring.sectors() / 2 + 1 - offsets.start) as usize;
        let by_offset = |displaced: &Mat<f64>| dense.product(forces.transpose(), displaced.as_ref());
        let by_offset = displaced.iter().take(half).map(by_offset).collect::<Result<_, _>>()?;
        let mut all = Mat::zeros(unknowns, chosen.len() * displaced.len());
        for (place, displaced) in displaced.iter().enumerate() {
            all.as_mut().subcols_mut(place * chosen.len(), chosen.len()).copy_from(displaced);
        }
        let scale = shared_scale(&all, n);
        let Basis { vectors: shapes, .. } = Basis::of(scaled(&all, n, scale), &checkpoint)?;
        let modes =
            |displaced: &Mat<f64>| dense.product(shapes.transpose(), scaled(displaced, n, scale).as_ref());
        let ahead = displaced.iter().take(half).map(modes).collect::<Result<_, _>>()?;
        let behind = displaced.iter().rev().take(half).map(modes).collect::<Result<_, _>>()?;
        let shapes = scaled(&shapes, n, scale.recip());
        let rows = dense.product(condensed.rows_cuts.as_ref(), shapes.as_ref())?;
        Ok(Some(Self { first: offsets.start, by_offset, loads, modes: [ahead, behind], rows }))
    }

    /// Returns the coupling on a ring of a number of sectors. `by_surface` divides loads and stress
    /// rows by surface, the loads by the unknowns of tables.
    pub fn coupling(
        self,
        sectors: u32,
        by_surface: impl FnOnce(&Mat<f64>, &Mat<f64>) -> [Vec<Mat<f64>>; 2],
    ) -> FarCoupling {
        let [loads, stress] = by_surface(&self.loads, &self.rows);
        let Self { first, by_offset, modes, .. } = self;
        FarCoupling { sectors, first, by_offset, modes, loads, stress }
    }
}

fn columns(matrix: MatRef<'_, f64>, chosen: &[usize]) -> Mat<f64> {
    Mat::from_fn(matrix.nrows(), chosen.len(), |row, column| matrix[(row, chosen[column])])
}

/// Returns the coefficients of all columns by the chosen ones from their shares of the basis that
/// was built from these: one column for each.
fn interpolation(chosen: &[usize], shares: Mat<f64>) -> Mat<f64> {
    // A chosen vector has no shares of later ones.
    let triangle = columns(shares.as_ref(), chosen);
    let mut coefficients = shares;
    let serial = faer::Par::Seq;
    solve_upper_triangular_in_place(triangle.as_ref(), coefficients.as_mut(), serial);
    coefficients
}

/// Returns the factor that scales shared unknowns, which are forces, to the size of the
/// displacements of cuts with `n` degrees of freedom each.
fn shared_scale(unknowns: &Mat<f64>, n: usize) -> f64 {
    let moved = unknowns.as_ref().subrows(0, 2 * n).norm_max();
    let shared = unknowns.as_ref().subrows(2 * n, unknowns.nrows() - 2 * n).norm_max();
    if shared > 0.0 && moved > 0.0 { moved / shared } else { 1.0 }
}

/// Multiplies the rows of the shared unknowns by a factor.
fn scaled(unknowns: &Mat<f64>, n: usize, factor: f64) -> Mat<f64> {
    let of_row = |row: usize| if row < 2 * n { 1.0 } else { factor };
    Mat::from_fn(unknowns.nrows(), unknowns.ncols(), |row, column| of_row(row) * unknowns[(row, column)])
}

/// Orthonormal basis of the columns of a matrix.
struct Basis {
    /// Columns that span all but [`UNREPRESENTED`] parts of the largest one.
    chosen: Vec<usize>,
    /// Basis of these columns: each vector in turn is the remainder of one of them.
    vectors: Mat<f64>,
}

impl Basis {
    /// Builds the basis. The column with the largest remainder is next each time.
    fn of(
        mut columns: Mat<f64>,
        checkpoint: &impl Fn() -> Result<(), StructureError>,
    ) -> Result<Self, StructureError> {
        let (mut chosen, mut vectors) = (Vec::new(), Mat::<f64>::zeros(columns.nrows(), 0));
        let mut least = 0.0;
        while chosen.len() < columns.nrows().min(columns.ncols()) {
            checkpoint()?;
            let sizes: Vec<f64> = columns.col_iter().map(|column| column.norm_l2()).collect();
            let largest = (0..sizes.len()).fold(0, |best, k| if sizes[k] > sizes[best] { k } else { best });
            if chosen.is_empty() {
                least = UNREPRESENTED * sizes[largest];
            }
            if sizes[largest] <= least {
                break;
            }
            let mut next = columns.col(largest).to_owned();
            // Again, against rounding.
            let shares = vectors.transpose() * &next;
            next -= &vectors * shares;
            next /= next.norm_l2();
            for mut column in columns.col_iter_mut() {
                let share: f64 = next.transpose() * column.as_ref();
                column -= share * &next;
            }
            chosen.push(largest);
            vectors.resize_with(next.nrows(), chosen.len(), |row, _| next[row]);
        }
        Ok(Self { chosen, vectors })
    }
}

/// Coupling of distant sectors. See the module documentation. The equivalent forces of a load are
/// the selected loads with the same effect, in the frame of its own sector.
pub(crate) struct FarCoupling {
    /// Number of equal sectors around the ring.
    pub sectors: u32,
    /// Smallest distance in sectors without a table.
    pub first: u32,
    /// As in [`FarResponse::by_offset`].
    pub by_offset: Vec<Mat<f64>>,
    /// As in [`FarResponse::modes`].
    pub modes: [Vec<Mat<f64>>; 2],
    /// Selected loads by the unknowns of a table, for each loadable side.
    pub loads: Vec<Mat<f64>>,
    /// Stress by modes, for each surface.
    pub stress: Vec<Mat<f64>>,
}

impl FarCoupling {
    /// Returns the index of the distance between an observer's sector and a tooth, and whether the
    /// observer is ahead. `None` for near teeth.
    fn distance(&self, observer: u32, tooth: u32) -> Option<(usize, bool)> {
        let places =
            |from: u32, to: u32| (to % self.sectors + self.sectors - from % self.sectors) % self.sectors;
        let (ahead, behind) = (places(tooth, observer), places(observer, tooth));
        Some((ahead.min(behind).checked_sub(self.first)? as usize, ahead <= behind))
    }

    /// Returns the memory, in bytes.
    pub fn bytes(&self) -> usize {
        let matrices = self.by_offset.iter().chain(self.modes.iter().flatten());
        let matrices = matrices.chain(&self.loads).chain(&self.stress);
        matrices.map(|matrix| matrix.nrows() * matrix.ncols() * size_of::<f64>()).sum()
    }
}

impl Coupling for FarCoupling {
    fn count(&self) -> usize {
        self.by_offset.first().map_or(0, Mat::nrows)
    }

    fn by_loads(&self, side: usize) -> Option<&Mat<f64>> {
        self.loads.get(side)
    }

    // Few loads are selected.
    fn compliance(
        &self,
        observed: (u32, &Mat<f64>),
        loaded: (u32, &Mat<f64>),
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        interrupt.check()?;
        let distance = self.distance(observed.0, loaded.0);
        let ring = distance.and_then(|(place, ahead)| Some((self.by_offset.get(place)?, ahead)));
        Ok(match ring {
            Some((ring, true)) => {
                product(observed.1.transpose(), product(ring.as_ref(), loaded.1.as_ref()).as_ref())
            }
            Some((ring, false)) => {
                product(observed.1.transpose(), product(ring.transpose(), loaded.1.as_ref()).as_ref())
            }
            None => Mat::zeros(observed.1.ncols(), loaded.1.ncols()),
        })
    }

    fn stresses(&self, surface: usize, tooth: u32, loaded: (u32, &Mat<f64>)) -> Option<Mat<f64>> {
        let (place, ahead) = self.distance(tooth, loaded.0)?;
        let modes = self.modes[usize::from(!ahead)].get(place)?;
        let amplitudes = product(modes.as_ref(), loaded.1.as_ref());
        Some(product(self.stress.get(surface)?.as_ref(), amplitudes.as_ref()))
    }
}
