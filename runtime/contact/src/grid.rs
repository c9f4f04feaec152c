//! Contact grid of a plane patch: cells in the common tangent plane, each with its part of both
//! surfaces and its gap.
//!
//! Cells are centred at the closest approach; x is the coordinate along the tangent. Gaps are exact
//! separations of the surfaces along the common normal, averaged over the cell like its uniform
//! pressure. Near a rounded edge the cells shrink geometrically to the size required by a patch on
//! the edge itself, so that both are resolved equally.

use super::approach::{Approach, PlacedProfile};
use super::placement::ContactFrame;
use super::pressure::hertz_half_width;
use super::zone::{ENDLESS, FlankEnds, unit_half_width};
use calyx_numerics::vec2::{dot, minus};
use calyx_structure::Structure;

/// Contact cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Ends along the tangent, ascending, m.
    pub x: [f64; 2],
    /// Arc lengths of the cell's ends on each surface, in the order of `x`.
    pub arc: [[f64; 2]; 2],
    /// Arc length of the cell's centre on each surface.
    pub s: [f64; 2],
    /// Arc length at which each body is loaded: on a rounded edge that of its start.
    pub loaded_at: [f64; 2],
    /// Average separation of the undeformed surfaces, m; negative for overlap.
    pub gap: f64,
    /// True if either surface is on its rounded edge here.
    pub edge: bool,
}

impl Cell {
    /// Width, m.
    pub fn width(&self) -> f64 {
        self.x[1] - self.x[0]
    }

    /// Centre along the tangent, m.
    pub fn center(&self) -> f64 {
        0.5 * (self.x[0] + self.x[1])
    }
}

impl super::pressure::PressureStrip for Cell {
    fn ends(&self) -> [f64; 2] {
        self.x
    }
}

/// Width of a grid, measured on the flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Width {
    /// Total width, m.
    Total(f64),
    /// [`MARGIN`] times the width of the Hertzian contact of this force.
    Hertz {
        /// Force per face width, N/m.
        force: f64,
    },
}

/// Ratio of the width of an automatic grid to that of the Hertzian contact. It leaves room for load
/// sharing and reliefs, and three quarters of the cells are loaded.
pub const MARGIN: f64 = 1.3;

/// Options of a plane contact grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// M: a grid has 2M + 1 cells, more where it is graded towards an edge and fewer where a
    /// surface ends.
    pub half_count: usize,
    /// Total width, or the load that determines it.
    pub width: Width,
    /// Contact modulus E*, Pa.
    pub contact_modulus: f64,
    /// Permits cells on the edges of the profiles.
    pub search_edges: bool,
}

/// Contact grid: the cells of a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Reference point, common normal and tangent.
    pub frame: ContactFrame,
    /// Cells, ascending in x.
    pub cells: Vec<Cell>,
    /// Requested width, m.
    pub width: f64,
    /// Smallest permitted width, m.
    least_width: f64,
    /// M: half the number of cells without the middle one.
    pub half_count: usize,
    /// True on the left and right if the grid ends there because a surface does.
    pub surface_ends: [bool; 2],
    /// Ends of the flanks on the left and right, within the grid or beyond it.
    pub flank: FlankEnds,
    /// Hertzian half-width of a line load of 1 N/m, m.
    pub unit_half_width: f64,
    /// Rounded edges within reach.
    edges: Vec<GradedEdge>,
}

/// Rounded edge beyond whose start a grid reaches less far than on the flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GradedEdge {
    /// Start of the edge from the middle of the grid, m.
    pub x: f64,
    /// +1 if the edge lies at larger x, -1 if at smaller x.
    pub towards: f64,
    /// Ratio of the reach on the edge to that on the flank.
    pub ratio: f64,
}

/// Returns the width, measured on the flank, of a grid that reaches `x` from its middle, m.
pub(crate) fn width_to_reach(edges: &[GradedEdge], x: f64) -> f64 {
    let edges = edges.iter().filter(|edge| edge.towards * x > 0.0);
    let beyond = edges.map(|edge| (x.abs() - (edge.towards * edge.x).max(0.0)) / edge.ratio);
    2.0 * beyond.fold(x.abs(), f64::max)
}

impl Grid {
    /// Returns the width, measured on the flank, of a grid that reaches `x`, m.
    fn width_to_reach(&self, x: f64) -> f64 {
        width_to_reach(&self.edges, x)
    }
}

/// Growth of the cell size with the distance from the start of an edge.
const GRADING: f64 = 0.25;
/// Cosine of the largest angle between a surface and the tangent plane; beyond it the surface ends
/// for contact.
const LEAST_COSINE: f64 = 0.2;
/// Smallest ratio of edge cells to flank cells.
const SHARPEST_EDGE: f64 = 1e-5;
/// Smallest width of a grid relative to the length of the shorter profile. Cells of a narrower grid
/// would not be larger than rounding errors of the arc length, and their compliance would be NaN. A
/// patch of this width carries no noticeable load.
const LEAST_WIDTH: f64 = 1e-8;
/// Distance from the start of an edge at which the adjacent curvature is evaluated, relative to the
/// length of the profile.
const BESIDE: f64 = 1e-9;

/// Returns the contact modulus of two bodies: 1/E* = 1/E'1 + 1/E'2 (Johnson, eq. 4.5). Infinite if
/// both are rigid.
pub fn contact_modulus(first: &dyn Structure, second: &dyn Structure) -> f64 {
    (first.surface_modulus().recip() + second.surface_modulus().recip()).recip()
}

/// Creates the grid at a closest approach of `first` and `second`. The grid has no cells if the
/// surfaces do not face each other.
pub fn build_grid(
    first: PlacedProfile,
    second: PlacedProfile,
    approach: &Approach,
    options: &GridOptions,
) -> Grid {
    let placed = [first, second];
    let frame = approach.frame;
    let surfaces =
        [0, 1].map(|side| Surface::new(placed[side], frame, approach.s[side], options.search_edges));
    let flank: [f64; 2] = [0, 1].map(|side| curvature_beside_edge(&placed[side], approach.s[side], -1.0));
    let width = match options.width {
        Width::Total(width) => width,
        Width::Hertz { force } => {
            2.0 * MARGIN * hertz_half_width(force, options.contact_modulus, flank[0] + flank[1])
        }
    };
    let least_width = LEAST_WIDTH * first.profile.length().min(second.profile.length());
    // Without a load, the grid has no cells.
    let width = if width > 0.0 && width < least_width { least_width } else { width };
    let count = (2 * options.half_count + 1) as f64;

    // Edges within reach, and the cell size of a patch on them: Hertzian widths are inversely
    // proportional to the root of the curvature.
    let mut edges = Vec::new();
    for side in 0..2 {
        let Some(start) = placed[side].profile.edge_from().filter(|_| options.search_edges) else { continue };
        let edge_curvature = curvature_beside_edge(&placed[side], start, 1.0) + flank[1 - side];
        let ratio = ((flank[0] + flank[1]) / edge_curvature).sqrt();
        // A sharper edge is a corner, which no grid resolves.
        if ratio > SHARPEST_EDGE && start < placed[side].profile.length() {
            let surface = &surfaces[side];
            let x = surface.x_of(start.clamp(surface.arc[0], surface.arc[1]));
            edges.push(Edge { x, towards: surface.sense, cell: width / count * ratio.min(1.0) });
        }
    }

    let mut range = [-0.5 * width, 0.5 * width];
    for edge in &edges {
        // Beyond the start of an edge, or beyond a reference point on it, half a grid of edge
        // cells.
        let side = if edge.towards > 0.0 { 1 } else { 0 };
        let reach = 0.5 * count * edge.cell;
        let limit = edge.towards * ((edge.towards * edge.x).max(0.0) + reach);
        range[side] = edge.towards * (edge.towards * range[side]).min(edge.towards * limit);
    }
    let mut surface_ends = [false; 2];
    for surface in &surfaces {
        if surface.x[0] > range[0] {
            range[0] = surface.x[0];
            surface_ends[0] = true;
        }
        if surface.x[1] < range[1] {
            range[1] = surface.x[1];
            surface_ends[1] = true;
        }
    }
    let bounds = if range[1] > range[0] { cell_bounds(range, width / count, &edges) } else { Vec::new() };
    let arcs = [0, 1].map(|side| surfaces[side].arcs_at(&bounds));
    let cells = (1..bounds.len())
        .map(|end| {
            let x = [bounds[end - 1], bounds[end]];
            let arc = [0, 1].map(|side| [arcs[side][end - 1], arcs[side][end]]);
            let middle = 0.5 * (x[0] + x[1]);
            let s = [0, 1].map(|side| surfaces[side].arc_at(middle, 0.5 * (arc[side][0] + arc[side][1])));
            let edge = placed[0].on_edge(s[0]) || placed[1].on_edge(s[1]);
            let loaded_at = [0, 1].map(|side| placed[side].loaded_at(s[side]));
            Cell { x, arc, s, loaded_at, gap: average_gap(&surfaces, x, arc, s), edge }
        })
        .collect();
    let unit_half_width = unit_half_width(options.contact_modulus, flank[0] + flank[1]);
    let flank = flank_ends(&surfaces, &edges);
    let graded =
        |edge: &Edge| GradedEdge { x: edge.x, towards: edge.towards, ratio: edge.cell * count / width };
    let edges = edges.iter().map(graded).collect();
    let half_count = options.half_count;
    Grid { frame, cells, width, least_width, half_count, surface_ends, flank, unit_half_width, edges }
}

/// Returns the ends of the flanks on the left and on the right.
fn flank_ends(surfaces: &[Surface; 2], edges: &[Edge]) -> FlankEnds {
    let ends = |[low, high]: FlankEnds, [from, to]: [f64; 2]| [low.max(from), high.min(to)];
    let surfaces = surfaces.iter().map(|surface| surface.x);
    let edges = edges.iter().map(|edge| match edge.towards > 0.0 {
        true => [f64::NEG_INFINITY, edge.x],
        false => [edge.x, f64::INFINITY],
    });
    surfaces.chain(edges).fold(ENDLESS, ends)
}

/// Returns the curvature of the flank (`side` -1) or the edge (+1) next to the start of the edge if
/// `s` is beyond it, else at `s`.
fn curvature_beside_edge(placed: &PlacedProfile, s: f64, side: f64) -> f64 {
    match placed.profile.edge_from() {
        Some(start) if s >= start => {
            placed.profile.at(start + side * BESIDE * placed.profile.length()).curvature
        }
        _ => placed.profile.at(s).curvature,
    }
}

/// Start of a rounded edge on the tangent line.
pub(super) struct Edge {
    pub x: f64,
    /// +1 if the edge lies at larger x, -1 if at smaller x.
    pub towards: f64,
    /// Width of the cells on it, m.
    pub cell: f64,
}

/// Returns the ends of the cells over `range`: of size `flank_cell`, smaller towards edges, with
/// ends at the starts of the edges.
///
/// Between such ends, each cell has an equal share of the integral of 1 / size, so the grid is the
/// same with the sides exchanged.
pub(super) fn cell_bounds(range: [f64; 2], flank_cell: f64, edges: &[Edge]) -> Vec<f64> {
    let inside = |x: &f64| *x > range[0] && *x < range[1];
    let mut stops: Vec<f64> = edges.iter().map(|edge| edge.x).filter(inside).collect();
    stops.sort_by(f64::total_cmp);
    stops.push(range[1]);
    let mut bounds = vec![range[0]];
    let mut from = range[0];
    for to in stops {
        let pieces = size_pieces([from, to], flank_cell, edges);
        let total: f64 = pieces.iter().map(SizeInterval::cells).sum();
        // Round up, but with a tolerance: grids on edges have half cells by design, and rounding
        // must not change their number.
        let count = (total - 1e-6).ceil().max(1.0);
        let (mut piece, mut passed) = (0, 0.0);
        for end in 1..count as usize {
            let share = total * end as f64 / count;
            while piece + 1 < pieces.len() && passed + pieces[piece].cells() < share {
                passed += pieces[piece].cells();
                piece += 1;
            }
            bounds.push(pieces[piece].after(share - passed));
        }
        bounds.push(to);
        from = to;
    }
    bounds
}

/// Part of the tangent line over which the cell size varies linearly.
struct SizeInterval {
    x: [f64; 2],
    size: [f64; 2],
}

impl SizeInterval {
    /// Returns the (fractional) number of cells: the integral of 1 / size.
    fn cells(&self) -> f64 {
        let [a, b] = self.size;
        let length = self.x[1] - self.x[0];
        // Logarithmic mean of the sizes, which suffers from cancellation if they are nearly equal.
        if (b - a).abs() < 1e-9 * a { length / a } else { length * (b / a).ln() / (b - a) }
    }

    /// Returns the end of the first `cells` cells.
    fn after(&self, cells: f64) -> f64 {
        let [a, b] = self.size;
        let slope = (b - a) / (self.x[1] - self.x[0]);
        let along = if (b - a).abs() < 1e-9 * a { a * cells } else { a * (slope * cells).exp_m1() / slope };
        self.x[0] + along
    }
}

/// Returns the cell size over `range`: that of the flank, or that of the nearest edge, which grows
/// with the distance from it.
fn size_pieces(range: [f64; 2], flank_cell: f64, edges: &[Edge]) -> Vec<SizeInterval> {
    let asked = |edge: &Edge, x: f64| edge.cell + GRADING * (edge.towards * (edge.x - x)).max(0.0);
    let size = |x: f64| edges.iter().fold(flank_cell, |size, edge| size.min(asked(edge, x)));
    // Knots where the size of an edge's cells reaches that of the flank, and where the sizes of two
    // facing edges are equal.
    let mut knots = vec![range[0], range[1]];
    for edge in edges {
        knots.push(edge.x - edge.towards * (flank_cell - edge.cell) / GRADING);
        for other in edges.iter().filter(|other| other.towards != edge.towards) {
            knots.push(0.5 * (edge.x + other.x + edge.towards * (edge.cell - other.cell) / GRADING));
        }
    }
    knots.retain(|x| (range[0]..=range[1]).contains(x));
    knots.sort_by(f64::total_cmp);
    knots.dedup();
    let piece = |x: &[f64]| SizeInterval { x: [x[0], x[1]], size: [size(x[0]), size(x[1])] };
    knots.windows(2).map(piece).collect()
}

/// Profile as a function of x, from the reference point as far as it faces the other profile.
struct Surface<'a> {
    placed: PlacedProfile<'a>,
    frame: ContactFrame,
    /// +1 if arc length grows with x, -1 if it decreases.
    sense: f64,
    /// Range of arc length, ascending.
    arc: [f64; 2],
    /// Range of x, ascending.
    x: [f64; 2],
}

impl<'a> Surface<'a> {
    fn new(placed: PlacedProfile<'a>, frame: ContactFrame, reference: f64, search_edges: bool) -> Self {
        let cosine = |s: f64| dot(placed.at(s).tangent, frame.tangent);
        let sense = cosine(reference).signum();
        let arc = [0.0, placed.end(search_edges)].map(|end| {
            if sense * cosine(end) >= LEAST_COSINE || reference == end {
                return end;
            }
            let (mut faces, mut leans) = (reference, end);
            for _ in 0..50 {
                let middle = 0.5 * (faces + leans);
                if sense * cosine(middle) >= LEAST_COSINE { faces = middle } else { leans = middle }
            }
            faces
        });
        let mut surface = Self { placed, frame, sense, arc, x: [0.0; 2] };
        let x = arc.map(|s| surface.x_of(s));
        surface.x = if sense > 0.0 { x } else { [x[1], x[0]] };
        surface
    }

    fn x_of(&self, s: f64) -> f64 {
        dot(minus(self.placed.at(s).position, self.frame.point), self.frame.tangent)
    }

    /// Returns the arc lengths at ascending x, each searched from the one before.
    fn arcs_at(&self, x: &[f64]) -> Vec<f64> {
        let mut arcs = Vec::with_capacity(x.len());
        let mut guess = 0.5 * (self.arc[0] + self.arc[1]);
        for (at, &place) in x.iter().enumerate() {
            let s = self.arc_at(place, guess);
            arcs.push(s);
            guess = x.get(at + 1).map_or(s, |next| s + self.sense * (next - place));
        }
        arcs
    }

    /// Returns the arc length at x by a safeguarded Newton method; x is monotonic in arc length.
    fn arc_at(&self, x: f64, guess: f64) -> f64 {
        let (mut low, mut high) = (self.arc[0], self.arc[1]);
        let resolution = 2.0 * f64::EPSILON * high;
        let mut s = guess.clamp(low, high);
        for _ in 0..100 {
            let point = self.placed.at(s);
            let short = self.sense * (x - dot(minus(point.position, self.frame.point), self.frame.tangent));
            if short > 0.0 {
                low = s
            } else {
                high = s
            }
            let step = short / (self.sense * dot(point.tangent, self.frame.tangent));
            let mut next = s + step;
            if !(next >= low && next <= high) {
                next = 0.5 * (low + high);
            }
            if (next - s).abs() <= resolution {
                return next;
            }
            s = next;
        }
        s
    }

    /// Returns the height over the tangent plane at an arc length, along the common normal.
    fn height(&self, s: f64) -> f64 {
        dot(minus(self.placed.at(s).position, self.frame.point), self.frame.normal)
    }
}

/// Returns the average separation over a cell, with the arc lengths of its ends and its centre `s`
/// on each side, by three-point Gauss-Legendre quadrature: exact for surfaces of fifth degree.
fn average_gap(surfaces: &[Surface; 2], x: [f64; 2], arc: [[f64; 2]; 2], s: [f64; 2]) -> f64 {
    const OUTER_POINT: f64 = 0.774_596_669_241_483_4;
    let (center, half) = (0.5 * (x[0] + x[1]), 0.5 * (x[1] - x[0]));
    let separation = |arcs: [f64; 2]| surfaces[1].height(arcs[1]) - surfaces[0].height(arcs[0]);
    let outer = |end: usize, x: f64| {
        let guess = |side: usize| s[side] + OUTER_POINT * (arc[side][end] - s[side]);
        separation([0, 1].map(|side| surfaces[side].arc_at(x, guess(side))))
    };
    (5.0 * (outer(0, center - OUTER_POINT * half) + outer(1, center + OUTER_POINT * half))
        + 8.0 * separation(s))
        / 18.0
}

/// Assessment of a grid from a solution (report figures 3.40 to 3.42).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridReport {
    /// Number of cells with a positive pressure.
    pub loaded_cells: usize,
    /// True on the left and right if the outermost cell is loaded although the surfaces continue.
    /// Pressures are overestimated then.
    pub truncated: [bool; 2],
    /// True if fewer than five cells are loaded, too few for a pressure distribution.
    pub under_resolved: bool,
    /// Recommended width (m), for the same M. `None` for an under-resolved patch that no narrower
    /// grid covers: it needs more cells.
    pub recommended_width: Option<f64>,
}

/// Number of loaded cells below which a patch is under-resolved.
pub const LEAST_LOADED_CELLS: usize = 5;
/// A grid is made narrower only to less than this part of its width.
pub(crate) const LEAST_CHANGE: f64 = 0.95;

/// Assesses a grid from the pressures (Pa) on it.
pub fn assess(grid: &Grid, pressures: &[f64]) -> GridReport {
    let cells = &grid.cells;
    let loaded_cells = pressures.iter().filter(|&&p| p > 0.0).count();
    let loaded = |p: Option<&f64>| p.is_some_and(|&p| p > 0.0);
    let truncated = [
        loaded(pressures.first()) && !grid.surface_ends[0],
        loaded(pressures.last()) && !grid.surface_ends[1],
    ];
    // No other width improves a patch of few cells that covers its surface from end to end.
    let under_resolved = loaded_cells > 0 && loaded_cells < LEAST_LOADED_CELLS.min(cells.len());
    let recommended_width = if truncated[0] || truncated[1] {
        // Zero of the extrapolated p² if it lies outside; otherwise the patch is truncated too much
        // for an estimate. On a side that is not truncated, the grid already reaches far enough.
        let reach = |[left, right]: [f64; 2]| {
            let ends = [cells[0].x[0], cells[cells.len() - 1].x[1]];
            let left = if truncated[0] { left } else { left.max(ends[0]) };
            let right = if truncated[1] { right } else { right.min(ends[1]) };
            MARGIN * grid.width_to_reach(left).max(grid.width_to_reach(right))
        };
        let wanted = super::pressure::zeros_of_squared_pressure(cells, pressures)
            .map(reach)
            .filter(|&w| w > 1.1 * grid.width);
        Some(wanted.unwrap_or(2.0 * grid.width))
    } else if under_resolved {
        // The loaded cells bound the patch from above: a grid fitted to them has at least as many
        // loaded cells. A grid narrower than they are would truncate the patch.
        let needed = cells
            .iter()
            .zip(pressures)
            .filter(|&(_, &p)| p > 0.0)
            .map(|(cell, _)| grid.width_to_reach(cell.x[0]).max(grid.width_to_reach(cell.x[1])))
            .fold(0.0, f64::max);
        let fitted = (MARGIN * needed).min((0.5 * grid.width).max(needed)).max(grid.least_width);
        Some(fitted).filter(|&fitted| fitted < LEAST_CHANGE * grid.width)
    } else {
        None
    };
    GridReport { loaded_cells, truncated, under_resolved, recommended_width }
}

/// Computes the pressure in each cell (Pa) from the cell forces (N/m).
pub fn pressures(cells: &[Cell], forces: &[f64]) -> Vec<f64> {
    cells.iter().zip(forces).map(|(cell, force)| force / cell.width()).collect()
}
