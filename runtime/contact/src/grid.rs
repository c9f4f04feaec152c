//! The grid of a patch: cells in the common tangent plane, each with its piece of both surfaces and its gap.
//!
//! Cells are centred at the closest approach and measured by x along the tangent. Their gaps are exact separations of the true
//! surfaces along the common normal, averaged over the cell as its pressure is uniform over it. Near a rounded edge the cells
//! shrink geometrically to the size that a patch on the edge itself asks for, so that both are resolved alike.

use super::approach::{Approach, PlacedProfile};
use super::placement::{ContactFrame, dot, minus};
use super::pressure::hertz_half_width;
use super::zone::{ENDLESS, FlankEnds, unit_half_width};
use calyx_structure::Structure;

/// A cell of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Its ends along the tangent, ascending, m.
    pub x: [f64; 2],
    /// Per side: arc lengths of the surface over the cell's ends, in the order of `x`.
    pub arc: [[f64; 2]; 2],
    /// Per side: arc length of the surface over the cell's centre.
    pub s: [f64; 2],
    /// Average separation of the undeformed surfaces, m; negative where they overlap.
    pub gap: f64,
    /// Whether either surface is on its rounded edge here.
    pub edge: bool,
}

impl Cell {
    /// m
    pub fn width(&self) -> f64 {
        self.x[1] - self.x[0]
    }

    /// Middle along the tangent, m.
    pub fn center(&self) -> f64 {
        0.5 * (self.x[0] + self.x[1])
    }
}

impl super::pressure::Piece for Cell {
    fn ends(&self) -> [f64; 2] {
        self.x
    }
}

/// How wide a grid is, measured on the flank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Width {
    /// m.
    Total(f64),
    /// [`MARGIN`] times the Hertzian contact of this force (N/m).
    Hertz {
        /// Force per face width, N/m.
        force: f64,
    },
}

/// Width of an automatic grid over that of the Hertzian contact: room for what load sharing and reliefs change,
/// while three quarters of the cells are loaded.
pub const MARGIN: f64 = 1.3;

/// Options of a contact grid in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// M: a grid has 2M + 1 cells, more where it is graded towards an edge and fewer where a surface ends.
    pub half_count: usize,
    /// Total width, or the load it follows from.
    pub width: Width,
    /// E*, Pa.
    pub contact_modulus: f64,
    /// Whether cells may lie on the profiles' edges.
    pub search_edges: bool,
}

/// The cells of a patch.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    /// Reference point, common normal and tangent.
    pub frame: ContactFrame,
    /// Ascending in x.
    pub cells: Vec<Cell>,
    /// Requested width, m.
    pub width: f64,
    /// M: half the number of cells, the middle one not counted.
    pub half_count: usize,
    /// Whether the grid ends on the left and right because a surface does.
    pub surface_ends: [bool; 2],
    /// Where the flanks end on the left and right, in the grid or beyond it.
    pub flank: FlankEnds,
    /// Hertzian half-width of a line load of 1 N/m, m.
    pub unit_half_width: f64,
}

/// Growth of cells per distance from an edge's start.
const GRADING: f64 = 0.25;
/// A surface that leans over by more than acos of this against the tangent plane ends there, as far as contact goes.
const LEAST_COSINE: f64 = 0.2;
/// Smallest size of edge cells beside flank cells.
const SHARPEST_EDGE: f64 = 1e-5;
/// Curvature just beside an edge's start is taken this far from it, relative to the profile's length.
const BESIDE: f64 = 1e-9;

/// E* of two bodies: 1/E* = 1/E'1 + 1/E'2 (Johnson, eq. 4.5). Infinite if both are rigid.
pub fn contact_modulus(first: &dyn Structure, second: &dyn Structure) -> f64 {
    (first.surface_modulus().recip() + second.surface_modulus().recip()).recip()
}

/// Lays the grid of the patch at a closest approach of `first` and `second`. No cells if the surfaces do not face each
/// other over any width.
pub fn lay(first: PlacedProfile, second: PlacedProfile, approach: &Approach, options: &GridOptions) -> Grid {
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
    let count = (2 * options.half_count + 1) as f64;

    // Edges within reach, and the cells that a patch on them wants: Hertzian widths go by the root of curvature.
    let mut edges = Vec::new();
    for side in 0..2 {
        let Some(start) = placed[side].profile.edge_from().filter(|_| options.search_edges) else { continue };
        let edge_curvature = curvature_beside_edge(&placed[side], start, 1.0) + flank[1 - side];
        let ratio = ((flank[0] + flank[1]) / edge_curvature).sqrt();
        // A sharper edge than this is a corner: no grid resolves it.
        if ratio > SHARPEST_EDGE && start < placed[side].profile.length() {
            let surface = &surfaces[side];
            let x = surface.x_of(start.clamp(surface.arc[0], surface.arc[1]));
            edges.push(Edge { x, towards: surface.sense, cell: width / count * ratio.min(1.0) });
        }
    }

    let mut range = [-0.5 * width, 0.5 * width];
    for edge in &edges {
        // Beyond an edge's start, or the reference on it, half a grid of edge cells.
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
            Cell { x, arc, s, gap: average_gap(&surfaces, x, arc, s), edge }
        })
        .collect();
    let unit_half_width = unit_half_width(options.contact_modulus, flank[0] + flank[1]);
    let flank = flank_ends(&surfaces, &edges);
    Grid { frame, cells, width, half_count: options.half_count, surface_ends, flank, unit_half_width }
}

/// Where the first flank ends on the left and on the right.
fn flank_ends(surfaces: &[Surface; 2], edges: &[Edge]) -> FlankEnds {
    let ends = |[low, high]: FlankEnds, [from, to]: [f64; 2]| [low.max(from), high.min(to)];
    let surfaces = surfaces.iter().map(|surface| surface.x);
    let edges = edges.iter().map(|edge| match edge.towards > 0.0 {
        true => [f64::NEG_INFINITY, edge.x],
        false => [edge.x, f64::INFINITY],
    });
    surfaces.chain(edges).fold(ENDLESS, ends)
}

/// Curvature of the flank (`side` -1) or the edge (+1) next to the edge's start, if `s` is beyond it; else at `s`.
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
    /// +1 if the edge lies at larger x, -1 if at smaller.
    pub towards: f64,
    /// Width of cells on it, m.
    pub cell: f64,
}

/// Ends of the cells over `range`: of size `flank_cell`, shrinking towards edges, with ends at the edges' starts.
///
/// Between such ends, cells hold equal shares of the integral of 1 / size, so that a patch seen from the other side has the
/// same cells.
pub(super) fn cell_bounds(range: [f64; 2], flank_cell: f64, edges: &[Edge]) -> Vec<f64> {
    let inside = |x: &f64| *x > range[0] && *x < range[1];
    let mut stops: Vec<f64> = edges.iter().map(|edge| edge.x).filter(inside).collect();
    stops.sort_by(f64::total_cmp);
    stops.push(range[1]);
    let mut bounds = vec![range[0]];
    let mut from = range[0];
    for to in stops {
        let pieces = size_pieces([from, to], flank_cell, edges);
        let total: f64 = pieces.iter().map(Piece::cells).sum();
        // No larger than asked; grids on edges hold half cells by design, which rounding must not push up and down.
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

/// A part of the tangent line over which the size of cells varies linearly.
struct Piece {
    x: [f64; 2],
    size: [f64; 2],
}

impl Piece {
    /// Number of cells, not whole: the integral of 1 / size.
    fn cells(&self) -> f64 {
        let [a, b] = self.size;
        let length = self.x[1] - self.x[0];
        // The logarithmic mean of the sizes, which rounds badly where they are nearly the same.
        if (b - a).abs() < 1e-9 * a { length / a } else { length * (b / a).ln() / (b - a) }
    }

    /// Where `cells` cells from its start end.
    fn after(&self, cells: f64) -> f64 {
        let [a, b] = self.size;
        let slope = (b - a) / (self.x[1] - self.x[0]);
        let along = if (b - a).abs() < 1e-9 * a { a * cells } else { a * (slope * cells).exp_m1() / slope };
        self.x[0] + along
    }
}

/// The size of cells over `range`: the flank's, or what the nearest edge asks for, growing away from it.
fn size_pieces(range: [f64; 2], flank_cell: f64, edges: &[Edge]) -> Vec<Piece> {
    let asked = |edge: &Edge, x: f64| edge.cell + GRADING * (edge.towards * (edge.x - x)).max(0.0);
    let size = |x: f64| edges.iter().fold(flank_cell, |size, edge| size.min(asked(edge, x)));
    // Where an edge's demand meets the flank's size, and where two facing edges' demands meet.
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
    let piece = |x: &[f64]| Piece { x: [x[0], x[1]], size: [size(x[0]), size(x[1])] };
    knots.windows(2).map(piece).collect()
}

/// A profile as a function of x, from the reference point as far as it faces the other.
struct Surface<'a> {
    placed: PlacedProfile<'a>,
    frame: ContactFrame,
    /// +1 if arc length grows with x, -1 if it falls.
    sense: f64,
    /// Ascending.
    arc: [f64; 2],
    /// Ascending.
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

    /// Arc lengths over ascending x, each sought from the one before.
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

    /// Arc length over x: Newton's method inside a shrinking bracket, as x grows or falls steadily with arc length.
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

    /// Height over the tangent plane at an arc length, along the common normal.
    fn height(&self, s: f64) -> f64 {
        dot(minus(self.placed.at(s).position, self.frame.point), self.frame.normal)
    }
}

/// Average separation over a cell with its ends and its middle `s` on either side, by Gauss's three-point rule: exact for
/// surfaces of fifth degree.
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

/// What a solution says about its grid (report figures 3.40 to 3.42).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridReport {
    /// Number of cells with a positive pressure.
    pub loaded_cells: usize,
    /// Left, right: the outermost cell is loaded although the surfaces go on. Pressures are too high.
    pub truncated: [bool; 2],
    /// Fewer than five cells are loaded: the pressure has no shape.
    pub under_resolved: bool,
    /// A better width (m), for the same M.
    pub recommended_width: Option<f64>,
}

/// Loaded cells without which a patch counts as under-resolved.
pub const LEAST_LOADED_CELLS: usize = 5;

/// Judges a grid by the pressures (Pa) found on it.
pub fn assess(grid: &Grid, pressures: &[f64]) -> GridReport {
    let cells = &grid.cells;
    let loaded_cells = pressures.iter().filter(|&&p| p > 0.0).count();
    let loaded = |p: Option<&f64>| p.is_some_and(|&p| p > 0.0);
    let truncated = [
        loaded(pressures.first()) && !grid.surface_ends[0],
        loaded(pressures.last()) && !grid.surface_ends[1],
    ];
    // A patch that fills its surface from end to end, on few cells, cannot be helped by another width.
    let under_resolved = loaded_cells > 0 && loaded_cells < LEAST_LOADED_CELLS.min(cells.len());
    let recommended_width = if truncated[0] || truncated[1] {
        // Where p² would reach zero, if that is outside; else the cut is too deep to tell.
        let wanted = super::pressure::zeros_of_squared_pressure(cells, pressures)
            .map(|zeros| 2.0 * MARGIN * zeros[0].abs().max(zeros[1].abs()))
            .filter(|&w| w > 1.1 * grid.width);
        Some(wanted.unwrap_or(2.0 * grid.width))
    } else if under_resolved {
        // The loaded cells' extent bounds the patch from above: on a grid fitted to it, at least as much is loaded again.
        let farthest = cells
            .iter()
            .zip(pressures)
            .filter(|&(_, &p)| p > 0.0)
            .map(|(cell, _)| cell.x[0].abs().max(cell.x[1].abs()))
            .fold(0.0, f64::max);
        Some((2.0 * MARGIN * farthest).min(0.5 * grid.width))
    } else {
        None
    };
    GridReport { loaded_cells, truncated, under_resolved, recommended_width }
}

/// Pressure in each cell (Pa) for cell forces (N/m).
pub fn pressures(cells: &[Cell], forces: &[f64]) -> Vec<f64> {
    cells.iter().zip(forces).map(|(cell, force)| force / cell.width()).collect()
}
