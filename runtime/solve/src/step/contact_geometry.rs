//! Dimension-dependent part of a position: the trait [`ContactGeometry`], implemented for plane and
//! three-dimensional models.

use super::ContactPatch;
use super::friction::Action;
use crate::modal::Modes;
use crate::system::Teeth;
use calyx_contact::assembly::Entries;
use calyx_contact::problem::{ContactProblem, Solution};
use calyx_contact::solid::LoadedRanges;
use calyx_numerics::error::EngineError;
use faer::Mat;
use nalgebra::DMatrix;
use std::ops::Range;

/// Tooth pair that may come into contact, before the solution.
pub(super) struct Candidate<S> {
    pub(super) teeth: Teeth,
    /// Length of the profiles, m: the scale of gaps.
    pub(super) length: f64,
    /// Closest approach of the surfaces.
    pub(super) nearest: Approach,
    /// Further points at which the gap may close; empty in plane models.
    pub(super) others: Vec<Approach>,
    /// Geometry of the approach.
    pub(super) site: S,
}

/// Gap that rigid motions open and close.
pub(super) struct Approach {
    /// Gap, m; negative for overlap.
    pub(super) gap: f64,
    /// Growth of the gap by each DOF.
    pub(super) arms: Vec<f64>,
}

impl Approach {
    /// Returns the gap after motions, m.
    pub(super) fn gap_growth(&self, motion: &[f64]) -> f64 {
        let rigid: f64 = self.arms.iter().zip(motion).map(|(arm, motion)| arm * motion).sum();
        self.gap + rigid
    }

    pub(super) fn gap_closure(&self, motion: &[f64]) -> bool {
        self.gap_growth(motion) < 0.0
    }
}

impl<S> Candidate<S> {
    pub(super) fn approaches(&self) -> impl Iterator<Item = &Approach> {
        std::iter::once(&self.nearest).chain(&self.others)
    }
}

/// Surfaces whose approach is computed accurately.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Search {
    /// Those that may touch in a time step. Larger gaps are accurate to a few percent.
    Near,
    /// All.
    All,
}

/// Number of cells of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Resolution {
    /// Half as many as in the model along every direction.
    Half,
    /// As many as in the model.
    Full,
}

/// Dimension-dependent part of a position.
pub(super) trait ContactGeometry: Sync {
    /// Geometry of the approach of a tooth pair.
    type Site: Sync;
    /// Contact grid of a patch.
    type Grid: Send + Sync;
    /// Size of a grid.
    type Size: Copy + Send + Sync;

    /// Returns all tooth pairs near enough to face each other, in a fixed order, with the
    /// deviations `moved` from the prescribed motions, m or rad by DOF.
    fn candidates(
        &self,
        time: f64,
        moved: &[f64],
        search: Search,
    ) -> Result<Vec<Candidate<Self::Site>>, EngineError>;

    /// Estimates the force that flattens surfaces with an overlap (m), in the unit of loads.
    fn force_of_overlap(&self, candidate: &Candidate<Self::Site>, overlap: f64) -> f64;

    /// Creates the grid of a patch: of the given size, else of the model's, else of one derived
    /// from the force. There are checkpoints in three dimensions.
    fn build_grid(
        &self,
        candidate: &Candidate<Self::Site>,
        force: f64,
        size: Option<Self::Size>,
        resolution: Resolution,
    ) -> Result<Self::Grid, EngineError>;

    /// Returns whether the size of a grid is determined with half as many cells along every
    /// direction first. This saves time where the first size rarely suits.
    fn sizes_at_half_resolution(&self, _candidate: &Candidate<Self::Site>) -> bool {
        false
    }

    /// Returns the number of cells of a grid.
    fn count(&self, grid: &Self::Grid) -> usize;

    /// Returns its width across, m.
    fn width(&self, grid: &Self::Grid) -> f64;

    /// Returns whether a grid that should be wider ends at the end of a surface.
    fn is_cut_off(&self, _grid: &Self::Grid) -> bool {
        false
    }

    /// Returns the gap of each cell, m.
    fn gaps(&self, grid: &Self::Grid) -> Vec<f64>;

    /// Returns the growth of the gap of each cell by each DOF, row by row.
    fn arms(&self, candidate: &Candidate<Self::Site>, grid: &Self::Grid) -> Vec<f64>;

    /// Returns grids whose cells act along the normals of the flanks that a solution deflects and
    /// rotates; `None` if this does not affect directions.
    ///
    /// # Errors
    /// Those of the interrupt.
    fn with_deflected_normals(
        &self,
        _laid: &[(&Candidate<Self::Site>, &Self::Grid)],
        _solution: &Solution,
    ) -> Result<Option<Vec<Self::Grid>>, EngineError> {
        Ok(None)
    }

    /// Returns the points of action of cells and their normal, for friction.
    fn action(&self, candidate: &Candidate<Self::Site>, grid: &Self::Grid) -> Action;

    /// Returns the point of action of the closest approach, if there is no grid.
    fn approaching(&self, candidate: &Candidate<Self::Site>) -> Action;

    /// Computes the compliance matrix, see [`ContactProblem::compliance`].
    fn compliance(
        &self,
        laid: &[(&Candidate<Self::Site>, &Self::Grid)],
        entries: Entries,
    ) -> Result<Vec<f64>, EngineError>;

    /// Returns the cells whose gaps matter for the size of the grid although they carry no force.
    fn observed_cells(&self, _grid: &Self::Grid) -> Vec<Range<usize>> {
        Vec::new()
    }

    /// Returns the growth of the gap of each cell by the forces on the flanks of all spline teeth;
    /// none in three dimensions. There is a checkpoint before each side of a patch.
    fn by_spline_teeth(
        &self,
        _laid: &[(&Candidate<Self::Site>, &Self::Grid)],
    ) -> Result<Mat<f64>, EngineError> {
        Ok(Mat::zeros(0, 0))
    }

    /// Returns the growth of the gap of each cell by unit forces on the terms of the raceway in the
    /// bore of a body.
    ///
    /// # Errors
    /// Those of the interrupt.
    fn by_raceway(
        &self,
        body: usize,
        laid: &[(&Candidate<Self::Site>, &Self::Grid)],
    ) -> Result<DMatrix<f64>, EngineError>;

    /// Returns an initial active set; it affects only the time of the solution.
    fn guess(&self, _problem: &ContactProblem, _grids: &[Self::Grid]) -> Vec<usize> {
        Vec::new()
    }

    /// Returns whether grids have slices, and problems may contain parts of them.
    fn has_slices(&self) -> bool {
        false
    }

    /// Returns the grid with one cell for each slice, for estimates of the position under load
    /// and of the part that carries load; `None` if problems contain all cells.
    fn with_a_cell_for_each_slice(&self, _grid: &Self::Grid) -> Option<Self::Grid> {
        None
    }

    /// Estimates the part of a grid that carries load from the forces of its slices, see
    /// [`calyx_contact::solid::estimated_ranges`].
    fn estimated_ranges(&self, _grid: &Self::Grid, _forces: &[f64]) -> (LoadedRanges, Vec<usize>) {
        Default::default()
    }

    /// Returns the grid of the cells in some ranges; `None` if problems contain all cells.
    fn within_ranges(&self, _grid: &Self::Grid, _ranges: &[Range<usize>]) -> Option<Self::Grid> {
        None
    }

    /// Returns the ranges extended by cells that may carry load; `None` if there are none. `loaded`
    /// are the cells of the ranges.
    fn extended_ranges(
        &self,
        _candidate: &Candidate<Self::Site>,
        _grid: &Self::Grid,
        _ranges: &[Range<usize>],
        _loaded: &LoadedCells,
    ) -> Option<LoadedRanges> {
        None
    }

    /// Returns whether grids may be enlarged after the usual number of corrections: in three
    /// dimensions, where the extent of the load along the contact line is least predictable.
    fn may_grow(&self) -> bool;

    /// Returns a better size for a grid whose size is not prescribed and is unsuitable. If `wide`
    /// grids are acceptable, only a wider one. `size` is that of an earlier correction.
    fn corrected_grid_size(
        &self,
        candidate: &Candidate<Self::Site>,
        grid: &Self::Grid,
        size: Option<Self::Size>,
        loaded: &LoadedCells,
        wide: bool,
    ) -> Option<Self::Size>;

    /// Returns the width of the grid of a patch that carries this force, as for a pair without a
    /// prescribed width, m.
    fn automatic_width(&self, candidate: &Candidate<Self::Site>, force: f64) -> f64;

    /// Assesses the width of a grid from the solution (report figures 3.40 to 3.42).
    fn assess_width(&self, grid: &Self::Grid, forces: &[f64]) -> WidthReport;

    /// Returns the growth of the gap of each cell by each modal coordinate; none in three
    /// dimensions.
    fn modal_arms(&self, _laid: &[(&Candidate<Self::Site>, &Self::Grid)], _modes: &Modes) -> Mat<f64> {
        Mat::zeros(0, 0)
    }

    /// Creates the patch for the results, without a grid if there is no pressure.
    fn patch(&self, candidate: &Candidate<Self::Site>, laid: Option<(Self::Grid, Vec<f64>)>) -> ContactPatch;
}

/// Cells of a patch in the solution of its contact problem.
pub(super) struct LoadedCells<'a> {
    /// Forces, in the unit of loads.
    pub(super) forces: &'a [f64],
    /// Gaps, m.
    pub(super) gaps: &'a [f64],
    /// Rigid motion by DOF.
    pub(super) motion: &'a [f64],
}

/// Assessment of the width of a grid.
#[derive(Clone, Copy)]
pub(super) struct WidthReport {
    /// Requested width, m.
    pub(super) width: f64,
    /// M: half the number of cells across, the middle one not counted.
    pub(super) half_count: usize,
    /// True if an outermost cell is loaded although the surfaces continue.
    pub(super) truncated: bool,
    /// True if too few cells are loaded for a pressure distribution.
    pub(super) under_resolved: bool,
    /// Recommended width for this patch, m.
    pub(super) recommended: Option<f64>,
}
