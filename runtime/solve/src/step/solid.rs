//! Three-dimensional implementation of a position: contact lines of surfaces, grids on their common
//! tangent plane.

mod near_teeth;

use super::contact_geometry::{Candidate, ContactGeometry, LoadedCells, Resolution, Search, WidthReport};
use super::friction::Action;
use super::patch::solid_arm;
use super::{ContactGrid, ContactPatch};
use crate::raceways::dense;
use crate::system::{SolidBodies, System};
use calyx_contact::assembly::Entries;
use calyx_contact::grid::MARGIN;
use calyx_contact::problem::{ContactProblem, Solution};
use calyx_contact::solid::{
    self, BodyRotation, ContactLine, Grid, GridOptions, GridSize, LineOfAction, LoadedPatch, LoadedRanges,
    PatchCells, PatchFrame, PlacedSurface, Pose, assess, build_grid, compliance, contact_modulus,
    estimated_ranges, extended_ranges, first_guess, fitting_size, grid_width, lines_of_action, pressures,
    with_a_cell_for_each_slice, within_ranges,
};
use calyx_model::dof::{Component, Dof};
use calyx_model::pairs::SurfacePair;
use calyx_numerics::error::EngineError;
use calyx_numerics::parallel::try_map;
use calyx_structure::Chart;
use calyx_structure::surface::Surface;
use nalgebra::DMatrix;
use near_teeth::{PlacedPair, ToothAt};
use std::ops::Range;
use std::sync::Arc;

/// Largest factor by which a correction enlarges the width of a grid. Along the contact line each
/// end moves by at most the corresponding part of the length.
const MOST_GROWTH: f64 = 2.0;
/// The same for grids that may shrink again.
const FITTED_GROWTH: f64 = 1.5;
/// Smallest M and N for which a grid with half as many cells still resolves the extent of the load.
const FEWEST_TO_HALVE: [usize; 2] = [8, 6];

pub(super) struct Solid<'a> {
    pub(super) system: &'a System<'a>,
    pub(super) bodies: &'a SolidBodies,
    /// True for a time step, at whose start bodies overlap by their deflection.
    pub(super) in_time: bool,
}

/// Contact line of two surfaces.
pub(super) struct Site {
    surfaces: [Arc<dyn Surface>; 2],
    /// Poses of the teeth.
    poses: [Pose; 2],
    /// Axis positions of the bodies.
    origins: [[f64; 3]; 2],
    /// Directions of the DOFs of either body.
    axes: [[[f64; 3]; 3]; 2],
    contact_line: ContactLine,
}

impl Site {
    fn placed(&self, side: usize) -> PlacedSurface<'_> {
        PlacedSurface { surface: self.surfaces[side].as_ref(), pose: self.poses[side] }
    }

    /// Returns the rotation of a body by an angle about its axis.
    fn rotation(&self, side: usize, angle: f64) -> BodyRotation {
        BodyRotation { origin: self.origins[side], axis: self.axes[side][2], angle }
    }
}

impl ContactGeometry for Solid<'_> {
    type Site = Site;
    type Grid = Grid;
    type Size = GridSize;

    /// Tooth pairs are searched by several threads at a time.
    fn candidates(
        &self,
        time: f64,
        moved: &[f64],
        search: Search,
    ) -> Result<Vec<Candidate<Site>>, EngineError> {
        let mut near = Vec::new();
        for index in 0..self.system.scene.pairs.len() {
            if let Some(placed) = self.placed_pair(index, time, moved)? {
                let teeth = self.near_teeth(&placed, time);
                let placed = Arc::new(placed);
                near.extend(teeth.into_iter().map(|teeth| (placed.clone(), teeth)));
            }
        }
        let candidate = |(placed, teeth): &(Arc<PlacedPair<'_>>, [ToothAt; 2])| {
            self.system.interrupt.check()?;
            Ok::<_, EngineError>(self.candidate(placed, *teeth, search))
        };
        Ok(try_map(&near, candidate)?.into_iter().flatten().collect())
    }

    /// The surface displacement is about Q / (E* length), over the overlapping length of the
    /// contact line.
    fn force_of_overlap(&self, candidate: &Candidate<Site>, overlap: f64) -> f64 {
        let contact_line = &candidate.site.contact_line;
        overlap * overlapping_length(contact_line) * self.contact_modulus(candidate)
    }

    fn build_grid(
        &self,
        candidate: &Candidate<Site>,
        force: f64,
        size: Option<GridSize>,
        resolution: Resolution,
    ) -> Result<Grid, EngineError> {
        let GridSize { width, along } = size.unwrap_or_default();
        let size = GridSize { width: width.or(self.pair(candidate).grid.width), along };
        let (site, mut options) = (&candidate.site, self.grid_options(candidate, force, size));
        if resolution == Resolution::Half {
            options.half_count = options.half_count.div_ceil(2);
            options.half_slices = options.half_slices.div_ceil(2);
        }
        let placed = [0, 1].map(|side| site.placed(side));
        build_grid(placed[0], placed[1], &site.contact_line, &options, &self.system.interrupt)
    }

    /// Point contacts shrink with the share of the load that they carry.
    fn sizes_at_half_resolution(&self, candidate: &Candidate<Site>) -> bool {
        let pair = self.pair(candidate);
        let [fewest_across, fewest_along] = FEWEST_TO_HALVE;
        let grid = &pair.grid;
        has_local_normals(pair)
            && grid.solid_half_cells() >= fewest_across
            && grid.half_slices >= fewest_along
    }

    fn automatic_width(&self, candidate: &Candidate<Site>, force: f64) -> f64 {
        let (site, options) = (&candidate.site, self.grid_options(candidate, force, GridSize::default()));
        grid_width(site.placed(0), site.placed(1), &site.contact_line, &options)
    }

    fn count(&self, grid: &Grid) -> usize {
        grid.cells.len()
    }

    fn width(&self, grid: &Grid) -> f64 {
        grid.width
    }

    fn gaps(&self, grid: &Grid) -> Vec<f64> {
        grid.cells.iter().map(|cell| cell.gap).collect()
    }

    /// Every cell acts along the patch's normal through the nearest point of the contact line, or,
    /// on general axes, along its own normal at its own place.
    fn arms(&self, candidate: &Candidate<Site>, grid: &Grid) -> Vec<f64> {
        let bodies = self.pair(candidate).bodies.map(|body| body.0);
        let at = (candidate.site.origins, candidate.site.axes);
        let of = |cell: &solid::Cell| self.arms_at(bodies, at, grid.frame.action(cell.slope), cell.point);
        grid.cells.iter().flat_map(of).collect()
    }

    fn action(&self, _: &Candidate<Site>, grid: &Grid) -> Action {
        let PatchFrame { normal, across, .. } = grid.frame;
        Action { normal, across, points: grid.cells.iter().map(|cell| cell.point).collect() }
    }

    fn approaching(&self, candidate: &Candidate<Site>) -> Action {
        let PatchFrame { normal, across, point, .. } = candidate.site.contact_line.frame;
        Action { normal, across, points: vec![point] }
    }

    fn compliance(
        &self,
        laid: &[(&Candidate<Site>, &Grid)],
        entries: Entries,
    ) -> Result<Vec<f64>, EngineError> {
        let patches: Vec<PatchCells> =
            laid.iter().filter_map(|(candidate, grid)| self.patch_cells(candidate, grid)).collect();
        compliance(&patches, entries, &self.system.interrupt)
    }

    /// The slices at the ends, beyond which contact may be separate.
    fn observed_cells(&self, grid: &Grid) -> Vec<Range<usize>> {
        let ends = [grid.slices.first(), grid.slices.last()];
        ends.into_iter().flatten().map(|slice| slice.cells.clone()).collect()
    }

    fn with_deflected_normals(
        &self,
        laid: &[(&Candidate<Site>, &Grid)],
        solution: &Solution,
    ) -> Result<Option<Vec<Grid>>, EngineError> {
        if !laid.iter().any(|(candidate, _)| has_local_normals(self.pair(candidate))) {
            return Ok(None);
        }
        let mut loaded = Vec::with_capacity(laid.len());
        let mut left = &solution.forces[..];
        for (candidate, grid) in laid {
            let (forces, others) = left.split_at(grid.cells.len());
            left = others;
            let Some(cells) = self.patch_cells(candidate, grid) else { return Ok(None) };
            let angles = self.sole_rotations(cells.sides.map(|side| side.body), &solution.motion);
            let rotations = [0, 1].map(|side: usize| candidate.site.rotation(side, angles[side]));
            loaded.push(LoadedPatch { cells, rotations, slices: &grid.slices, forces });
        }
        let lines = lines_of_action(&loaded, &self.system.interrupt)?;
        let deflected =
            |((candidate, grid), lines): (&(&Candidate<Site>, &Grid), Vec<Option<LineOfAction>>)| {
                let mut grid = Grid::clone(grid);
                if has_local_normals(self.pair(candidate)) {
                    for (slice, line) in grid.slices.iter().zip(lines) {
                        let Some(LineOfAction { point, slope, gap_correction }) = line else { continue };
                        for cell in &mut grid.cells[slice.cells.clone()] {
                            (cell.point, cell.slope) = (point, slope);
                            cell.gap += gap_correction;
                        }
                    }
                }
                grid
            };
        Ok(Some(laid.iter().zip(lines).map(deflected).collect()))
    }

    fn guess(&self, problem: &ContactProblem, grids: &[Grid]) -> Vec<usize> {
        first_guess(problem, &grids.iter().collect::<Vec<_>>(), &self.system.interrupt)
    }

    fn has_slices(&self) -> bool {
        true
    }

    fn with_a_cell_for_each_slice(&self, grid: &Grid) -> Option<Grid> {
        Some(with_a_cell_for_each_slice(grid))
    }

    fn estimated_ranges(&self, grid: &Grid, forces: &[f64]) -> (LoadedRanges, Vec<usize>) {
        estimated_ranges(grid, forces)
    }

    fn within_ranges(&self, grid: &Grid, ranges: &[Range<usize>]) -> Option<Grid> {
        Some(within_ranges(grid, ranges))
    }

    fn extended_ranges(
        &self,
        candidate: &Candidate<Site>,
        grid: &Grid,
        ranges: &[Range<usize>],
        loaded: &LoadedCells,
    ) -> Option<LoadedRanges> {
        extended_ranges(grid, ranges, (loaded.forces, loaded.gaps), self.contact_modulus(candidate))
    }

    fn by_raceway(
        &self,
        body: usize,
        laid: &[(&Candidate<Site>, &Grid)],
    ) -> Result<DMatrix<f64>, EngineError> {
        let structure = self.bodies.structures.get(body).and_then(Option::as_deref);
        let Some((structure, raceway)) = structure.and_then(|own| Some((own, own.raceway()?))) else {
            return Ok(DMatrix::zeros(0, 0));
        };
        let (stop, cells) = (&self.system.interrupt, laid.iter().map(|(_, grid)| grid.cells.len()).sum());
        let (mut growth, mut first) = (DMatrix::zeros(cells, raceway.terms()), 0);
        for (candidate, grid) in laid {
            let (pair, count) = (self.pair(candidate), grid.cells.len());
            for side in (0..2).filter(|&side| pair.bodies[side].0 == body) {
                let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
                let segments: Vec<_> = grid.cells.iter().map(|cell| cell.segment(side)).collect();
                let moved = dense(structure.interface_displacements(chart, &segments, stop)?.transpose());
                growth.rows_mut(first, count).copy_from(&moved);
            }
            first += count;
        }
        Ok(growth)
    }

    fn may_grow(&self) -> bool {
        true
    }

    fn corrected_grid_size(
        &self,
        candidate: &Candidate<Site>,
        grid: &Grid,
        size: Option<GridSize>,
        loaded: &LoadedCells,
        wide: bool,
    ) -> Option<GridSize> {
        let pressures = pressures(&grid.cells, loaded.forces);
        let report = assess(grid, &pressures);
        let [enough_across, enough_along] = report.under_resolved.map(|few| wide && few);
        let mut asked = GridSize {
            width: report.recommended.width.filter(|_| !enough_across),
            along: report.recommended.along.filter(|_| !enough_along),
        };
        let fitted = has_local_normals(self.pair(candidate)) && !wide;
        if fitted && asked == GridSize::default() {
            // Several teeth share the load, and a point contact shrinks with it in both directions.
            asked = fitting_size(grid, &pressures);
        }
        // An extrapolation from the pressure next to an edge is no estimate of the size.
        let most = if fitted { FITTED_GROWTH } else { MOST_GROWTH };
        let [low, high] = grid.along;
        let growth = (most - 1.0) * (high - low);
        let width = asked.width.map(|width| width.min(most * grid.width));
        let along = asked.along.map(|[from, to]| [from.max(low - growth), to.min(high + growth)]);
        // A contact beyond a gap does not appear as pressure at the end of the grid.
        let along = match self.ends_with_separate_contact(candidate, grid, loaded) {
            Some([from, to]) => {
                let [low, high] = along.unwrap_or(grid.along);
                Some([low.min(from), high.max(to)])
            }
            None => along,
        };
        let width = width.filter(|_| self.pair(candidate).grid.width.is_none());
        if width.is_none() && along.is_none() {
            return None;
        }
        let along = along.or(size.and_then(|size| size.along));
        Some(GridSize { width: Some(width.unwrap_or(grid.width)), along })
    }

    fn assess_width(&self, grid: &Grid, forces: &[f64]) -> WidthReport {
        let report = assess(grid, &pressures(&grid.cells, forces));
        WidthReport {
            width: grid.width,
            half_count: grid.half_counts[0],
            truncated: report.recommended.width.is_some() && !report.under_resolved[0],
            under_resolved: report.under_resolved[0],
            recommended: report.recommended.width,
        }
    }

    fn patch(&self, candidate: &Candidate<Site>, laid: Option<(Grid, Vec<f64>)>) -> ContactPatch {
        let (pair, teeth) = candidate.teeth;
        let surfaces = self.pair(candidate).surfaces;
        let empty = || Grid {
            frame: candidate.site.contact_line.frame,
            cells: Vec::new(),
            slices: Vec::new(),
            width: 0.0,
            along: [0.0; 2],
            line: 0.0,
            half_counts: [0; 2],
            surface_ends: [false; 2],
            unit_half_width: 0.0,
            beside_faces: [[0.0; 2]; 2],
        };
        let (grid, forces) = laid.unwrap_or_else(|| (empty(), Vec::new()));
        ContactPatch {
            pair,
            teeth,
            surfaces,
            grid: ContactGrid::Solid(grid),
            forces,
            friction_vectors: Vec::new(),
        }
    }
}

impl Solid<'_> {
    /// Returns the ends of a grid that covers all points of the contact line at which the surfaces
    /// overlap beyond its ends without load, m; `None` without such a point.
    ///
    /// Bodies deflect least where they carry no load, so a point that overlaps after the deflection
    /// at the end of the grid does carry load.
    fn ends_with_separate_contact(
        &self,
        candidate: &Candidate<Site>,
        grid: &Grid,
        loaded: &LoadedCells,
    ) -> Option<[f64; 2]> {
        let slices = [grid.slices.first()?, grid.slices.last()?];
        let dofs = loaded.motion.len();
        let beyond = |end: usize, y: f64| [y < slices[0].y[0], y > slices[1].y[1]][end];
        let mut farthest = grid.along;
        for end in [0, 1] {
            let cells = slices[end].cells.clone();
            // A load up to the end of the grid is not separate.
            if grid.surface_ends[end] || cells.clone().any(|cell| loaded.forces[cell] > 0.0) {
                continue;
            }
            let nearest = cells.min_by(|&i, &j| loaded.gaps[i].total_cmp(&loaded.gaps[j]))?;
            let arms = &self.arms(candidate, grid)[nearest * dofs..(nearest + 1) * dofs];
            let rigid: f64 = arms.iter().zip(loaded.motion).map(|(arm, motion)| arm * motion).sum();
            let deflection = loaded.gaps[nearest] - grid.cells[nearest].gap - rigid;
            for (point, approach) in candidate.site.contact_line.points.iter().zip(&candidate.others) {
                if beyond(end, point.at[1]) && approach.gap_growth(loaded.motion) + deflection < 0.0 {
                    farthest = [farthest[0].min(point.at[1]), farthest[1].max(point.at[1])];
                }
            }
        }
        let margin = 0.5 * (MARGIN - 1.0) * (farthest[1] - farthest[0]);
        let ends = [0, 1].map(|end| {
            let beyond = if farthest[end] == grid.along[end] { 0.0 } else { margin };
            farthest[end] + [-beyond, beyond][end]
        });
        (farthest != grid.along).then_some(ends)
    }

    /// Returns the bodies and cells of a patch; `None` if a body has no surfaces.
    fn patch_cells<'c>(&'c self, candidate: &Candidate<Site>, grid: &'c Grid) -> Option<PatchCells<'c>> {
        let pair = self.pair(candidate);
        let side = |side: usize| {
            let body = pair.bodies[side].0;
            let structure = self.bodies.structures[body].as_deref()?;
            let chart = Chart { tooth: candidate.teeth.1[side], surface: pair.surfaces[side] };
            Some(solid::Side { body, structure, chart, pose: candidate.site.poses[side] })
        };
        Some(PatchCells {
            sides: [side(0)?, side(1)?],
            frame: &grid.frame,
            cells: &grid.cells,
            beside_faces: grid.beside_faces,
        })
    }

    fn pair(&self, candidate: &Candidate<Site>) -> &SurfacePair {
        &self.system.scene.pairs[candidate.teeth.0]
    }

    /// Returns the options of the grid of a patch of this size, or of the one that follows from the
    /// force.
    fn grid_options(&self, candidate: &Candidate<Site>, force: f64, size: GridSize) -> GridOptions {
        let grid = &self.pair(candidate).grid;
        GridOptions {
            half_count: grid.solid_half_cells(),
            half_slices: grid.half_slices,
            size,
            force,
            contact_modulus: self.contact_modulus(candidate),
            search_edges: grid.edges,
            local_normals: has_local_normals(self.pair(candidate)),
            under_load: self.in_time,
        }
    }

    fn contact_modulus(&self, candidate: &Candidate<Site>) -> f64 {
        match self.pair(candidate).bodies.map(|body| self.bodies.structures[body.0].as_deref()) {
            [Some(first), Some(second)] => contact_modulus(first, second),
            _ => f64::INFINITY,
        }
    }

    /// Returns the rotations of the bodies of a pair about their axes if one can only rotate and
    /// the other has no DOF, rad. They are zero otherwise, since other motions may cancel the
    /// displacement of the contact by a rotation.
    fn sole_rotations(&self, bodies: [usize; 2], motion: &[f64]) -> [f64; 2] {
        let of = |body: usize| self.system.dofs.iter().filter(move |dof| dof.body == body);
        let about_axis = |dof: &Dof| dof.component == Component::ThetaZ as usize;
        let is_sole = bodies.iter().any(|&body| of(body).count() == 0)
            && bodies.iter().all(|&body| of(body).all(about_axis));
        bodies.map(|body| match is_sole {
            true => self.system.moved(body, motion)[Component::ThetaZ as usize],
            false => 0.0,
        })
    }

    /// Returns the growth of the gap at a point of a patch by each DOF, m per m or rad.
    fn arms_at(
        &self,
        bodies: [usize; 2],
        (origins, axes): ([[f64; 3]; 2], [[[f64; 3]; 3]; 2]),
        action: [f64; 3],
        point: [f64; 3],
    ) -> Vec<f64> {
        let arm = |dof: &Dof| {
            let of = |side: usize| solid_arm(action, side, dof.component, &axes[side], origins[side], point);
            (0..2).filter(|&side| bodies[side] == dof.body).map(of).sum()
        };
        self.system.dofs.iter().map(arm).collect()
    }
}

/// Returns whether the cells of a pair act along their own normals: on general axes the normals of
/// conjugate flanks vary along their contact.
fn has_local_normals(pair: &SurfacePair) -> bool {
    pair.mesh.as_ref().is_some_and(|mesh| mesh.first_contact.is_some())
}

/// Returns the length of the contact line over which the bodies overlap, m.
fn overlapping_length(contact_line: &ContactLine) -> f64 {
    let reach = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let (mut y, mut gap) = (0.0, contact_line.gap);
        for [next, next_gap] in points {
            if next_gap >= 0.0 {
                // Between samples the gap is nearly a parabola from the closest approach.
                let [from, to, zero] =
                    [gap, next_gap, 0.0].map(|gap| (gap - contact_line.gap).max(0.0).sqrt());
                return y + (next - y) * (zero - from) / (to - from);
            }
            (y, gap) = (next.abs(), next_gap);
        }
        y
    };
    if contact_line.gap >= 0.0 {
        return 0.0;
    }
    let places = || contact_line.points.iter().map(|point| [point.at[1], point.gap]);
    let below = places().rev().filter(|[y, _]| *y < 0.0).map(|[y, gap]| [-y, gap]);
    let above = places().filter(|[y, _]| *y > 0.0);
    reach(&mut { below }) + reach(&mut { above })
}
