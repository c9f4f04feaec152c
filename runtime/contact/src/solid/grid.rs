//! Contact grid of a three-dimensional patch: cells in the common tangent plane, each with its
//! points on both surfaces and its gap.
//!
//! The patch is divided into slices along the contact line, and every slice into cells across it,
//! centred at its point of the contact line. Where the surfaces permit, the cells of all slices lie
//! on one lattice. Near a rounded edge the cells of a slice are graded as in plane contact. At an
//! oblique side face the last cells of a slice are cut at the face, or lengthened where too little
//! of a cell would remain. Gaps are exact separations along the normal of the frame, averaged over
//! the cell like its uniform pressure, or over a parallelogram where an edge or the contact line is
//! oblique.

use super::contact_line::{ContactLine, ContactLinePoint, ends_along, relative_curvature};
use super::grid_region::{GridOptions, Region};
use super::height_field::HeightField;
use super::placement::{PatchFrame, PlacedSurface};
use super::slant::{Slant, rate_on_flanks};
use super::transverse_approach::{SurfaceEnd, TransverseApproach, closest_across, limits};
use crate::grid::{Edge, GradedEdge, cell_bounds, width_to_reach};
use crate::zone::{ENDLESS, Edges, FlankEnds, unit_half_width};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::{Vector, dot, plus, scaled};
use calyx_structure::solid::{SolidStructure, SurfaceSegment};
use std::ops::Range;

/// Contact cell: a rectangle of the tangent plane under uniform pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// x and y of the centre in the patch's frame, m.
    pub center: [f64; 2],
    /// Sizes across and along the contact line, m.
    pub size: [f64; 2],
    /// Surface coordinates of the centre, by side.
    pub places: [[f64; 2]; 2],
    /// Surface coordinates where the bodies are loaded: on a rounded edge those of its start.
    pub loaded_at: [[f64; 2]; 2],
    /// Length along the body's axis, m, by side.
    pub axial: [f64; 2],
    /// Length in the surface coordinate `v`, by side: `axial` on extruded surfaces.
    pub spans: [f64; 2],
    /// Average separation of the undeformed surfaces along the normal of the frame, m; negative for
    /// overlap. It is averaged over a parallelogram if the contact line or an edge is oblique, and
    /// includes [`super::LineOfAction::gap_correction`] after the rotation of a body.
    pub gap: f64,
    /// Point of action of the force, m: that of [`super::LineOfAction`] with local normals, else
    /// the nearest point of the contact line. The offset of the cell from the contact line and the
    /// rotation of its own normal are then neglected together; on involutes they cancel, and on
    /// other conjugate flanks they do to first order.
    pub point: Vector,
    /// Slopes along x and y of the surface between both flanks there, for the direction of the
    /// force ([`PatchFrame::action`]); zero without [`GridOptions::local_normals`].
    pub slope: [f64; 2],
    /// True if either surface is on its rounded edge here.
    pub edge: bool,
}

impl Cell {
    /// Area, m².
    pub fn area(&self) -> f64 {
        self.size[0] * self.size[1]
    }

    /// Returns the loaded spot on the body of a side.
    pub fn segment(&self, side: usize) -> SurfaceSegment {
        SurfaceSegment { place: self.loaded_at[side], length: self.spans[side] }
    }

    /// Returns the ends across (axis 0) or along (1) the contact line, m.
    pub fn ends(&self, axis: usize) -> [f64; 2] {
        [self.center[axis] - 0.5 * self.size[axis], self.center[axis] + 0.5 * self.size[axis]]
    }
}

/// Slice: the cells of a patch at one position along its contact line.
#[derive(Clone, Debug, PartialEq)]
pub struct Slice {
    /// Ends along the contact line, ascending, m; single cells may be cut or lengthened.
    pub y: [f64; 2],
    /// Its cells in [`Grid::cells`], ascending in x.
    pub cells: Range<usize>,
    /// x of the middle of its cells where no edge grades them and no surface ends, m.
    pub middle: f64,
    /// Edges, relative to the middle.
    pub(super) graded: Vec<GradedEdge>,
    /// True at low and at high x if the slice ends there because a surface does.
    pub surface_ends: [bool; 2],
    /// Ends of the flanks next to the slice, within its cells or beyond them.
    pub edges: Edges,
    /// Surface coordinates of its point of the contact line, by side.
    pub places: [[f64; 2]; 2],
}

/// Contact grid: the cells of a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Frame in which cells are measured; they act along its normal.
    pub frame: PatchFrame,
    /// Cells by slice, ascending in y and then in x.
    pub cells: Vec<Cell>,
    /// Slices, ascending in y.
    pub slices: Vec<Slice>,
    /// Width across, measured on the flank, m, as requested or derived.
    pub width: f64,
    /// Ends along the contact line from the closest approach, ascending, m.
    pub along: [f64; 2],
    /// Length of the contact line from end to end, also beyond the grid, m.
    pub line: f64,
    /// M and N.
    pub half_counts: [usize; 2],
    /// True at low and at high y if the grid ends there because a surface does.
    pub surface_ends: [bool; 2],
    /// Hertzian half-width of a line load of 1 N/m, m.
    pub unit_half_width: f64,
    /// Surface coordinate `u` of the cells nearest to the side faces, by side, see
    /// [`beside_faces`].
    pub beside_faces: [[f64; 2]; 2],
}

impl Slice {
    /// Returns the width of a grid whose slice reaches `x`, m.
    pub fn width_to_reach(&self, x: f64) -> f64 {
        width_to_reach(&self.graded, x - self.middle)
    }
}

/// Smallest fraction of a slice's length for a cell cut by a side face; below it the neighbouring
/// cell absorbs the rest.
const LEAST_PART: f64 = 0.4;
/// Smallest ratio of edge cells to flank cells.
const SHARPEST_EDGE: f64 = 1e-5;
/// Distance over which the curvature next to the start of an edge is evaluated, relative to the
/// extent of the surface.
const BESIDE: f64 = 1e-6;
/// Distance from the edge, relative to the surface's range, below which the curvature is evaluated
/// on the flank alone.
const NEAR_EDGE: f64 = 2e-4;
/// Returns the contact modulus of two bodies: 1/E* = 1/E'1 + 1/E'2 (Johnson, eq. 4.5). Infinite if
/// both are rigid.
pub fn contact_modulus(first: &dyn SolidStructure, second: &dyn SolidStructure) -> f64 {
    (first.surface_modulus().recip() + second.surface_modulus().recip()).recip()
}

/// Creates the grid around a contact line of `first` and `second`. The grid has no cells if the
/// surfaces do not face each other. Each slice is a checkpoint.
///
/// # Errors
/// Those of the interrupt.
pub fn build_grid(
    first: PlacedSurface,
    second: PlacedSurface,
    contact_line: &ContactLine,
    options: &GridOptions,
    interrupt: &Interrupt,
) -> Result<Grid, EngineError> {
    let placed = [first, second];
    let frame = contact_line.frame;
    let height_fields = height_fields(placed, contact_line, options);
    let flank = flank_curvature(&height_fields, contact_line);
    let Region { y, width, surface_ends } = Region::new(contact_line, options, flank);
    let half_counts = [options.half_count, options.half_slices];
    let length = y[1] - y[0];
    let [low, high] = contact_line.extent();
    let line = high - low;
    let unit_half_width = unit_half_width(options.contact_modulus, flank);
    let mut grid = Grid {
        frame,
        cells: Vec::new(),
        slices: Vec::new(),
        width,
        along: y,
        line,
        half_counts,
        surface_ends,
        unit_half_width,
        beside_faces: [[0.0; 2]; 2],
    };
    if !([width, length].iter().all(|size| size.is_finite() && *size > 0.0)) {
        return Ok(grid);
    }
    let layer = Layer {
        placed,
        height_fields,
        frame,
        edges: edges(&placed, contact_line, flank),
        pitch: [width / (2 * half_counts[0] + 1) as f64, length / (2 * half_counts[1] + 1) as f64],
        half_count: half_counts[0],
        middle: 0.5 * (y[0] + y[1]),
        reach: half_counts[1] as i32,
        surface_ends,
        search_edges: options.search_edges,
        local_normals: options.local_normals,
        contact_line: &contact_line.points,
    };
    layer.fill(&mut grid, contact_line.places, interrupt)?;
    grid.beside_faces = beside_faces(&grid.cells);
    Ok(grid)
}

/// Returns the surface coordinate `u` of the cells with the smallest and the largest `v`, by side:
/// a curved side face counts where the patch is closest to it, because images matter only there.
pub fn beside_faces(cells: &[Cell]) -> [[f64; 2]; 2] {
    [0, 1].map(|side: usize| {
        let places = || cells.iter().map(|cell| cell.places[side]);
        let by_v = |a: &[f64; 2], b: &[f64; 2]| a[1].total_cmp(&b[1]);
        [places().min_by(by_v), places().max_by(by_v)].map(|place| place.map_or(0.0, |[u, _]| u))
    })
}

/// Returns the width across of the grid that [`build_grid`] creates, m.
pub fn grid_width(
    first: PlacedSurface,
    second: PlacedSurface,
    contact_line: &ContactLine,
    options: &GridOptions,
) -> f64 {
    let height_fields = height_fields([first, second], contact_line, options);
    Region::new(contact_line, options, flank_curvature(&height_fields, contact_line)).width
}

fn height_fields<'a>(
    placed: [PlacedSurface<'a>; 2],
    contact_line: &ContactLine,
    options: &GridOptions,
) -> [HeightField<'a>; 2] {
    [0, 1].map(|side| {
        let start = contact_line.places[side];
        HeightField::new(placed[side], contact_line.frame, start, options.search_edges)
    })
}

/// Returns the sum of both surfaces' curvatures across the contact line at the closest approach,
/// each on its flank, 1/m.
fn flank_curvature(height_fields: &[HeightField; 2], contact_line: &ContactLine) -> f64 {
    // Finite differences next to an edge would include its curvature.
    let beside_edge = |side: usize| {
        let surface = height_fields[side].placed.surface;
        let [[first, last], _] = surface.range();
        surface
            .edge_from()
            .is_some_and(|start| contact_line.places[side][0] + NEAR_EDGE * (last - first) > start)
    };
    if !(0..2).any(beside_edge)
        && !contact_line.at_end
        && let Some([[across, _], _]) = relative_curvature(height_fields, contact_line.places)
    {
        return across;
    }
    (0..2)
        .map(|side| curvature_beside_edge(&height_fields[side].placed, contact_line.places[side], -1.0))
        .sum()
}

/// Returns the curvature along u of the flank (`side` -1) or the edge (+1) next to the start of the
/// edge if the point is beyond it, else at the point; 1/m, positive where convex.
fn curvature_beside_edge(placed: &PlacedSurface, [u, v]: [f64; 2], side: f64) -> f64 {
    let [[first, last], _] = placed.surface.range();
    let step = BESIDE * (last - first);
    let near = match placed.surface.edge_from() {
        Some(start) if u >= start => start + side * step,
        _ => u,
    };
    let far = near + side * step;
    let points = [placed.at([near, v]), placed.at([far, v])];
    let tangent = points[0].tangents[0];
    let turn: f64 = (0..3).map(|k| (points[1].normal[k] - points[0].normal[k]) * tangent[k]).sum();
    turn / (dot(tangent, tangent) * (far - near))
}

/// Rounded edge and its cell size.
struct RoundedEdge {
    side: usize,
    start: f64,
    /// Ratio of the width of its cells to that of the flank.
    ratio: f64,
}

/// Returns the edges of both surfaces that a grid can resolve. Cell sizes follow the root of the
/// curvature like Hertzian widths.
fn edges(placed: &[PlacedSurface; 2], contact_line: &ContactLine, flank: f64) -> Vec<RoundedEdge> {
    let found = (0..2).filter_map(|side| {
        let start = placed[side].surface.edge_from()?;
        let v = contact_line.places[side][1];
        let other = curvature_beside_edge(&placed[1 - side], contact_line.places[1 - side], -1.0);
        let ratio = (flank / (curvature_beside_edge(&placed[side], [start, v], 1.0) + other)).sqrt();
        // A sharper edge is a corner, which no grid resolves.
        let resolved = ratio > SHARPEST_EDGE && start < placed[side].surface.range()[0][1];
        resolved.then(|| RoundedEdge { side, start, ratio: ratio.min(1.0) })
    });
    found.collect()
}

/// Builder of the slices.
struct Layer<'a> {
    placed: [PlacedSurface<'a>; 2],
    height_fields: [HeightField<'a>; 2],
    frame: PatchFrame,
    edges: Vec<RoundedEdge>,
    /// Sizes of a whole cell.
    pitch: [f64; 2],
    half_count: usize,
    /// y of the middle slice's centre, m.
    middle: f64,
    /// Number of slices on either side of the middle one.
    reach: i32,
    surface_ends: [bool; 2],
    search_edges: bool,
    local_normals: bool,
    /// Points of the contact line.
    contact_line: &'a [ContactLinePoint],
}

type Places = [[f64; 2]; 2];

/// Slice under construction.
#[derive(Default)]
struct Laid {
    cells: Vec<Cell>,
    middle: f64,
    graded: Vec<GradedEdge>,
    surface_ends: [bool; 2],
    edges: Option<Edges>,
    /// Surface coordinates of its contact line.
    places: Places,
}

impl Layer<'_> {
    fn fill(&self, grid: &mut Grid, start: Places, interrupt: &Interrupt) -> Result<(), EngineError> {
        // Proceed upwards and downwards from the slice next to the closest approach, each slice
        // starting at the end of the previous one; then sort.
        let nearest = ((-self.middle / self.pitch[1]).round() as i32).clamp(-self.reach, self.reach);
        let mut found: Vec<(i32, Laid)> = Vec::new();
        for direction in [1, -1] {
            let mut guess = start;
            let mut index: i32 = if direction > 0 { nearest } else { nearest - 1 };
            loop {
                let beyond = index.abs() > self.reach;
                let oblique = beyond && self.surface_ends[usize::from(direction > 0)];
                // A slice beyond the end of the contact line contains the rest at an oblique side
                // face; two slices suffice.
                if beyond && (!oblique || index.abs() > self.reach + 2) {
                    break;
                }
                interrupt.check()?;
                let Some(laid) = self.slice(index, guess) else { break };
                guess = laid.places;
                let empty = laid.cells.is_empty();
                found.push((index, laid));
                if beyond && empty {
                    break;
                }
                index += direction;
            }
        }
        found.sort_by_key(|(index, ..)| *index);
        for (index, laid) in found.into_iter().filter(|(_, laid)| !laid.cells.is_empty()) {
            let Laid { cells, middle, graded, surface_ends, edges, places } = laid;
            let edges = edges.unwrap_or(Edges::parallel(ENDLESS, 0.0));
            let first = grid.cells.len();
            grid.cells.extend(cells);
            let center = self.center(index);
            let y = [center - 0.5 * self.pitch[1], center + 0.5 * self.pitch[1]];
            let cells = first..grid.cells.len();
            grid.slices.push(Slice { y, cells, middle, graded, surface_ends, edges, places });
        }
        Ok(())
    }

    fn center(&self, index: i32) -> f64 {
        self.middle + f64::from(index) * self.pitch[1]
    }

    /// Creates a slice; `None` if the surfaces do not face each other.
    fn slice(&self, index: i32, guess: Places) -> Option<Laid> {
        let y = self.center(index);
        let contact_line = closest_across(&self.height_fields, y, guess)?;
        let places = contact_line.places();
        if contact_line.end.is_some() && !self.search_edges {
            return Some(Laid { places, ..Laid::default() });
        }
        let column = (contact_line.at()[0] / self.pitch[0]).round();
        let center = column * self.pitch[0];
        let (bounds, graded, mut surface_ends) = self.bounds(center, y, places);
        let cut = self.is_cut(&bounds, y, places);
        let ends = self.flank_ends(y, places);
        let around = [-0.5, 0.5].map(|part| self.flank_ends(y + part * self.pitch[1], places));
        let on_edge = (0..2).any(|side| self.placed[side].on_edge(places[side]));
        let rate = (!on_edge && contact_line.end.is_none()).then(|| rate_on_flanks(self.contact_line, y));
        let slant = Slant::new(contact_line.at()[0], rate, ends, around, self.pitch[1]);
        let mut cells = Vec::with_capacity(bounds.len());
        let mut guess = places;
        for x in bounds.windows(2) {
            if let Some((cell, found)) = self.cell([x[0], x[1]], y, &contact_line, (cut, &slant), guess) {
                guess = found;
                cells.push(cell);
            }
        }
        if let (Some([first, last]), Some([low, high])) = (ends_of(&cells), ends_of(&bounds)) {
            // Cells are missing where an oblique side face ends a surface.
            surface_ends[0] |= first.ends(0)[0] > low + 0.5 * first.size[0];
            surface_ends[1] |= last.ends(0)[1] < high - 0.5 * last.size[0];
        }
        let edges = Some(edges_beside(ends, around, contact_line.at()[0]));
        Some(Laid { cells, middle: center, graded, surface_ends, edges, places })
    }

    /// Returns the ends of the cells of a slice, the edges that grade them, and whether a surface
    /// ends it.
    fn bounds(&self, center: f64, y: f64, places: Places) -> (Vec<f64>, Vec<GradedEdge>, [bool; 2]) {
        let count = 2 * self.half_count + 1;
        let half = 0.5 * count as f64 * self.pitch[0];
        let mut range = [center - half, center + half];
        let inside = |x: f64| {
            (0..2).all(|side| {
                let height_field = &self.height_fields[side];
                let across = height_field.roles[0];
                let edge = self.edges.iter().find(|edge| edge.side == side && across == 0);
                height_field.over([x, y], places[side]).is_some_and(|foot| {
                    let [low, high] = height_field.range[across];
                    let high = edge.map_or(high, |edge| edge.start.min(high));
                    (low..=high).contains(&foot.place[across])
                })
            })
        };
        // Beyond this distance the grading towards an edge does not change the cells.
        let clearance = 4.0 * self.pitch[0];
        if inside(range[0])
            && inside(range[1])
            && self.edges.iter().all(|edge| self.is_far(edge, range, y, places, clearance))
        {
            let bounds =
                (0..=count).map(|k| center + (k as f64 - 0.5 * count as f64) * self.pitch[0]).collect();
            return (bounds, Vec::new(), [false; 2]);
        }
        let edges: Vec<Edge> = self.edges.iter().filter_map(|edge| self.edge_at(edge, y, places)).collect();
        for edge in &edges {
            // Beyond the start of an edge, or beyond a contact line on it, half a grid of edge
            // cells.
            let side = if edge.towards > 0.0 { 1 } else { 0 };
            let reach = 0.5 * count as f64 * edge.cell;
            let limit = edge.towards * ((edge.towards * edge.x).max(edge.towards * center) + reach);
            range[side] = edge.towards * (edge.towards * range[side]).min(edge.towards * limit);
        }
        let mut surface_ends = [false; 2];
        if let Some([low, high]) = limits(&self.height_fields, y, places) {
            let cut =
                |limit: SurfaceEnd, outside: bool, end: usize, range: &mut [f64; 2], ends: &mut [bool; 2]| {
                    if outside {
                        range[end] = limit.x;
                        ends[end] = true;
                    }
                };
            let (below, above) = (low.x > range[0], high.x < range[1]);
            cut(low, below, 0, &mut range, &mut surface_ends);
            cut(high, above, 1, &mut range, &mut surface_ends);
        }
        let bounds = if range[1] > range[0] { cell_bounds(range, self.pitch[0], &edges) } else { Vec::new() };
        let graded = |edge: &Edge| GradedEdge {
            x: edge.x - center,
            towards: edge.towards,
            ratio: edge.cell / self.pitch[0],
        };
        (bounds, edges.iter().map(graded).collect(), surface_ends)
    }

    /// Returns the nearest ends of the flanks at low and at high x of the slice at `y`.
    fn flank_ends(&self, y: f64, places: Places) -> FlankEnds {
        let surfaces = limits(&self.height_fields, y, places).map_or(ENDLESS, |[low, high]| [low.x, high.x]);
        let edges = self.edges.iter().filter_map(|edge| self.edge_at(edge, y, places));
        edges.fold(surfaces, |[low, high], edge| match edge.towards > 0.0 {
            true => [low, high.min(edge.x)],
            false => [low.max(edge.x), high],
        })
    }

    /// Returns the start of an edge on the tangent plane at `y`.
    fn edge_at(&self, edge: &RoundedEdge, y: f64, places: Places) -> Option<Edge> {
        let height_field = &self.height_fields[edge.side];
        if height_field.roles[0] != 0 {
            return None;
        }
        let foot = height_field.on_line(0, edge.start, 1, y, places[edge.side][1])?;
        Some(Edge { x: foot.at[0], towards: height_field.sense(0, &foot), cell: self.pitch[0] * edge.ratio })
    }

    /// Returns whether an edge is too far from a slice to affect its cells.
    fn is_far(&self, edge: &RoundedEdge, range: [f64; 2], y: f64, places: Places, clearance: f64) -> bool {
        self.edge_at(edge, y, places).is_none_or(|at| {
            if at.towards > 0.0 { at.x > range[1] + clearance } else { at.x < range[0] - clearance }
        })
    }

    /// Returns whether a side face may end a cell of the slice at `y` before or beyond the slice's
    /// own end.
    fn is_cut(&self, bounds: &[f64], y: f64, places: Places) -> bool {
        let (Some(&first), Some(&last)) = (bounds.first(), bounds.last()) else { return false };
        if self.surface_ends == [false; 2] {
            return false;
        }
        let reach = (0.5 + LEAST_PART) * self.pitch[1];
        [first, last].iter().any(|&x| {
            ends_along(&self.height_fields, x, places)
                .is_none_or(|[low, high]| low > y - reach || high < y + reach)
        })
    }

    /// Returns the cell over `x` of the slice at `y`, whose closest approach and slant are given,
    /// optionally `cut` at the side faces, and the surface coordinates of its centre.
    fn cell(
        &self,
        x: [f64; 2],
        y: f64,
        closest: &TransverseApproach,
        (cut, slant): (bool, &Slant),
        guess: Places,
    ) -> Option<(Cell, Places)> {
        let middle = 0.5 * (x[0] + x[1]);
        let slice = [y - 0.5 * self.pitch[1], y + 0.5 * self.pitch[1]];
        let ends = if cut { self.cut_ends(middle, slice, guess)? } else { slice };
        let center = [middle, 0.5 * (ends[0] + ends[1])];
        let size = [x[1] - x[0], ends[1] - ends[0]];
        let feet =
            [self.height_fields[0].over(center, guess[0])?, self.height_fields[1].over(center, guess[1])?];
        let places = feet.map(|foot| foot.place);
        let own = feet[1].height - feet[0].height;
        let slant = slant.at(middle);
        let mut gap = 0.0;
        for (a, weight_a) in ACROSS {
            for b in ALONG {
                let along = 0.5 * b * size[1];
                let at = [middle + 0.5 * a * size[0] + slant * along, center[1] + along];
                let there = |side: usize| self.height_fields[side].height_near(&feet[side], at);
                let separation = there(1).zip(there(0)).map_or(own, |(second, first)| second - first);
                gap += weight_a / ALONG.len() as f64 * separation;
            }
        }
        // A whole cell shares the closest approach of its slice, which costs more than its gap.
        let closest = match ends == slice {
            true => *closest,
            false => closest_across(&self.height_fields, center[1], places)?,
        };
        let edge = (0..2).any(|side| self.placed[side].on_edge(places[side]));
        let axial = self.placed.map(|placed| size[1] * dot(self.frame.along, placed.pose.axis()).abs());
        let span = |side: usize| match self.placed[side].surface.is_extruded() {
            true => axial[side],
            false => size[1] * feet[side].place_by(1)[1].abs(),
        };
        let spans = [span(0), span(1)];
        let (point, slope) = match self.local_normals {
            true => {
                let height = 0.5 * (closest.feet[0].height + closest.feet[1].height);
                let point = self.frame.at([closest.at()[0], center[1]]);
                (plus(point, scaled(self.frame.normal, height)), closest.common_slope())
            }
            false => (self.frame.at([self.snapped(closest.at()[0]), center[1]]), [0.0; 2]),
        };
        let loaded_at = [0, 1].map(|side: usize| self.placed[side].loaded_at(places[side]));
        Some((Cell { center, size, places, loaded_at, axial, spans, gap, point, slope, edge }, places))
    }

    /// Returns the ends along the contact line of a cell at `x` of a slice: those of the side faces
    /// if they are near; `None` if the neighbouring cell absorbs it.
    fn cut_ends(&self, x: f64, slice: [f64; 2], guess: Places) -> Option<[f64; 2]> {
        let mut ends = slice;
        let faces = ends_along(&self.height_fields, x, guess)?;
        let part = LEAST_PART * self.pitch[1];
        if self.surface_ends[0] {
            if faces[0] > slice[1] - part {
                return None;
            }
            // The part below belongs to the slice below, if enough of it remains there.
            if faces[0] > slice[0] - part {
                ends[0] = faces[0];
            }
        }
        if self.surface_ends[1] {
            if faces[1] < slice[0] + part {
                return None;
            }
            if faces[1] < slice[1] + part {
                ends[1] = faces[1];
            }
        }
        Some(ends)
    }

    /// Returns x of the contact line without its rounding.
    fn snapped(&self, x: f64) -> f64 {
        if x.abs() < 1e-9 * self.pitch[0] { 0.0 } else { x }
    }
}

/// Returns the edges next to a slice, from the ends of the flanks at its middle and at both ends.
fn edges_beside(ends: FlankEnds, around: [FlankEnds; 2], closest: f64) -> Edges {
    let nearest = around.into_iter().fold(ends, |[low, high], [from, to]| [low.max(from), high.min(to)]);
    Edges { ends, nearest, closest }
}

/// Returns the first and the last of several values.
fn ends_of<T: Copy>(values: &[T]) -> Option<[T; 2]> {
    Some([*values.first()?, *values.last()?])
}

/// Gauss-Legendre rules on -1 .. 1: three points with weights of sum 1 across, exact for surfaces
/// of fifth degree, and two along.
const ACROSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 18.0), (0.0, 8.0 / 18.0), (0.774_596_669_241_483_4, 5.0 / 18.0)];
const ALONG: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];
