//! Options of a contact grid, and the region of the tangent plane that it covers.

use super::contact_line::ContactLine;
use crate::grid::MARGIN;
use crate::pressure::hertz_half_width;

/// Size of a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GridSize {
    /// Width across, measured on the flank, m; `None` derives it from the force.
    pub width: Option<f64>,
    /// Ends along the contact line from the closest approach, m. The grid ends with the contact
    /// line if that is shorter. `None` derives them from the force.
    pub along: Option<[f64; 2]>,
}

/// Options of a grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridOptions {
    /// M: a slice has 2M + 1 cells, more where it is graded towards an edge and fewer where a
    /// surface ends.
    pub half_count: usize,
    /// N: a patch has 2N + 1 slices.
    pub half_slices: usize,
    /// Size.
    pub size: GridSize,
    /// Largest expected force on the patch, N. It determines automatic sizes, which are [`MARGIN`]
    /// times those of a Hertzian contact.
    pub force: f64,
    /// Contact modulus, 1/E* = 1/E'1 + 1/E'2, Pa.
    pub contact_modulus: f64,
    /// Permits cells on rounded edges.
    pub search_edges: bool,
    /// Lets every slice act along the common normal at its own point of the contact line. Otherwise
    /// all slices act along the normal of the frame, which is exact for involutes on parallel axes.
    pub local_normals: bool,
    /// Bodies are laid out under load, as in a time step: their overlap is their deflection, and
    /// they touch nowhere else.
    pub under_load: bool,
}

/// Approach relative to force / (E* length), that of a long patch with uniformly distributed force.
/// The least gap plus this approach bounds the loaded part of the contact line. With this factor a
/// circular contact gets [`MARGIN`] times its length.
const DEPTH: f64 = 1.65;
/// Factor on the approach of point contacts of teeth: where a tooth bends, the load spreads further
/// along the contact line than between half-spaces, and the line load is lower. A grid that is too
/// long is fitted to the load by one correction, one that truncates the load by several.
const SPREAD: f64 = 3.0;

/// Region of the tangent plane that a grid covers.
pub(super) struct Region {
    /// Ends along the contact line, m.
    pub y: [f64; 2],
    /// Width across, m.
    pub width: f64,
    /// True at low and at high y if a surface ends there.
    pub surface_ends: [bool; 2],
}

impl Region {
    /// `flank` is the sum of both curvatures across the contact line, 1/m.
    pub fn new(contact_line: &ContactLine, options: &GridOptions, flank: f64) -> Region {
        let (y, surface_ends) = length_along(contact_line, options);
        let width = options.size.width.unwrap_or_else(|| {
            // In a point contact the middle carries 1.5 times the average line load; in a line
            // contact the load is uniform.
            let share = if surface_ends == [true; 2] { 1.0 } else { 1.5 };
            let line_load = share * options.force / (y[1] - y[0]);
            2.0 * MARGIN * hertz_half_width(line_load, options.contact_modulus, flank)
        });
        Region { y, width, surface_ends }
    }
}

/// Returns y of the grid's ends, and whether they are ends of the surfaces.
fn length_along(contact_line: &ContactLine, options: &GridOptions) -> ([f64; 2], [bool; 2]) {
    let all = contact_line.extent();
    let clipped = |[low, high]: [f64; 2]| {
        let y = [low.max(all[0]), high.min(all[1])];
        (y, [y[0] <= all[0], y[1] >= all[1]])
    };
    if let Some(ends) = options.size.along {
        return clipped(ends);
    }
    // The approach decreases as more of the contact line is loaded.
    let within = |depth: f64| -> [f64; 2] {
        let floor = contact_line.gap;
        let crossing = |step: &mut dyn Iterator<Item = &[f64; 2]>| {
            let (mut y, mut rise) = (0.0, 0.0f64);
            for &[next, gap] in step {
                let above = (gap - floor).max(0.0);
                if above > depth {
                    // Between samples the gap is nearly a parabola from the closest approach.
                    let (from, to) = (rise.max(0.0).sqrt(), above.sqrt());
                    return y + (next - y) * (depth.sqrt() - from) / (to - from);
                }
                (y, rise) = (next, above);
            }
            y
        };
        let points: Vec<[f64; 2]> =
            contact_line.points.iter().map(|point| [point.at[1], point.gap]).collect();
        let low = crossing(&mut points.iter().rev().filter(|[y, _]| *y < 0.0));
        let high = crossing(&mut points.iter().filter(|[y, _]| *y > 0.0));
        // Surfaces may also be near each other beyond a larger gap, as hollow ones at both ends of
        // a face.
        let near = points.iter().filter(|[_, gap]| gap - floor <= depth).map(|[y, _]| *y);
        near.fold([low, high], |[low, high], y| [low.min(y), high.max(y)])
    };
    let spread = if options.local_normals { SPREAD } else { 1.0 };
    let (mut shallow, mut deep) =
        (0.0, 2.0 * contact_line.points.iter().map(|point| point.gap - contact_line.gap).fold(0.0, f64::max));
    let enough = |depth: f64| {
        let [low, high] = within(depth);
        depth * (high - low) * options.contact_modulus >= spread * DEPTH * options.force
    };
    if deep == 0.0 || !enough(deep) {
        return clipped(all);
    }
    for _ in 0..60 {
        let middle = 0.5 * (shallow + deep);
        if enough(middle) { deep = middle } else { shallow = middle }
    }
    // The approach of half-spaces is a part of the deflection.
    let overlap = if options.under_load { -contact_line.gap } else { 0.0 };
    clipped(within(deep.max(overlap)))
}
