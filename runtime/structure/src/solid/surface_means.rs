//! Response of the half-space to loads on any smooth surface: mollifiers across, polynomials along
//! the face, as forces per unit of both coordinates.
//!
//! The mean of `1/r` over two such loads is an integral over four variables. The distance depends
//! on all of them, but it is singular only where both differences `u - u'` and `t = v - v'` vanish,
//! and smooth in the sums. At fixed differences `1/r` is therefore interpolated over `v + v'`
//! between a few points, and so is the product of mollifiers over `u + u'`. The products of
//! polynomials have one distribution over the points of `t` and `v + v'`, the same for all pairs of
//! mollifiers. The integrals over the differences are graded towards the coincidence of both
//! points, in the metric of the surface.
//!
//! An image in a side face is singular where `u = u'` and both points lie on the face: where `u -
//! u'` and the sum `t` of both distances from the end vanish. There, `1/r` is interpolated over `v
//! - v'`. With the heights `h, h'` of two points over the plane that touches the side face at their
//! mean `u`, the distance to the image is `r² + 4 h h'`, which is symmetric.
//!
//! See `docs/theory/compliance.md`.

use super::axial_modes::AxialModes;
use super::half_space::{ACROSS, FINEST, GRADING, PLACES, POINTS, differences};
use super::side_faces::SideFaces;
use crate::kernel::Mollifier;
use crate::surface::Surface;
use calyx_numerics::interpolation::lagrange;
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::{Vector, cross, dot, length};
use faer::Mat;

/// Interpolation points over `v + v'`: the scale of a surface changes slowly along the face.
const SUMS: usize = 6;
/// Interpolation points over `v - v'` for images, on either side of zero.
const DIRECTIONS: usize = 5;
/// Number of intervals in `u` of the tables of positions, interpolated by cubic polynomials.
const INTERVALS: usize = 64;
/// Number of points along the face that determine positions there.
const ALONG: usize = 24;
/// Largest number of panels along the face: for widths of mollifiers that no mesh has.
const MOST_PANELS: usize = 24;

/// Means of `1/r`, with images, over pairs of loads on a surface.
pub(crate) struct SurfaceMeans {
    modes: usize,
    start: f64,
    step: f64,
    panels: Vec<Panel>,
    /// Planes at the entries of the tables, by side.
    planes: [Vec<Plane>; 2],
    /// Interpolation points of the sum of `u` and `u'` on -1 ..= 1, and the quadrature points with
    /// their weights on them.
    across: Vec<f64>,
    onto_places: Vec<(f64, f64, Vec<f64>)>,
    differences: Vec<(f64, f64)>,
    finest: f64,
}

/// Plane that touches a side face.
#[derive(Clone, Copy)]
struct Plane {
    normal: Vector,
    /// Height of the origin below the plane, m.
    height: f64,
}

/// Interval of the distance along the face: pairs of points `v`, `v'` with their distributions of
/// products of polynomials. A pair also occurs with its points exchanged.
struct Panel {
    /// Least distance, in units of `u`.
    from: f64,
    /// Side face of the image, or `None` for the load itself.
    side: Option<usize>,
    /// Number of pairs.
    count: usize,
    /// Positions of the first points of all pairs, then of the second ones (x, y and z after each
    /// other), then their derivatives by the index of the table: one table for each `u`.
    positions: Vec<Vec<f64>>,
    /// Rows by pair, columns by `n * modes + m`: the polynomial `n` at the first point.
    spread: Mat<f64>,
}

/// Pair of points along the face, and the distribution of products of polynomials over it.
struct Pair {
    v: [f64; 2],
    spread: Vec<f64>,
}

impl SurfaceMeans {
    /// Prepares the means for `u` between two coordinates. `smallest` is the least width of a
    /// mollifier, in units of `u`. There are images in the given side faces.
    pub fn new(
        surface: &dyn Surface,
        [start, end]: [f64; 2],
        modes: &AxialModes,
        sides: Option<&SideFaces>,
        smallest: f64,
    ) -> Self {
        let step = (end - start) / INTERVALS as f64;
        let table = PositionTable::new(surface, [start, step], modes.range());
        let finest = FINEST * smallest;
        let ratio = table.ratio;
        let mut ends = vec![2.0 * modes.length(), modes.length()];
        while ratio * ends[ends.len() - 1] > finest && ends.len() < MOST_PANELS {
            ends.push(ends[ends.len() - 1] / GRADING);
        }
        ends.push(0.0);
        ends.reverse();
        let mut panels = Vec::new();
        for interval in ends.windows(2) {
            let panel = |side, pairs| table.panel(modes.count(), ratio * interval[0], side, pairs);
            let points = quadrature(modes, [interval[0], interval[1]]);
            if interval[1] <= modes.length() {
                panels.push(panel(None, direct_pairs(modes, &points)));
            }
            if sides.is_some() {
                panels.extend([0, 1].map(|side| panel(Some(side), image_pairs(modes, side, &points))));
            }
        }
        let plane = |side: usize, index: usize| {
            let Some(sides) = sides else { return Plane { normal: [0.0; 3], height: 0.0 } };
            let mirror = sides.mirror(surface, side, start + step * index as f64);
            Plane { normal: mirror.normal, height: dot(mirror.normal, mirror.point) }
        };
        let across: Vec<f64> = gauss_legendre(PLACES).into_iter().map(|(place, _)| place).collect();
        let onto = |(x, weight)| (x, weight, lagrange(&across, x));
        let onto_places = gauss_legendre(ACROSS).into_iter().map(onto).collect();
        Self {
            modes: modes.count(),
            start,
            step,
            panels,
            planes: [0, 1].map(|side| (0..=INTERVALS).map(|index| plane(side, index)).collect()),
            across,
            onto_places,
            differences: gauss_legendre(POINTS),
            finest,
        }
    }

    /// Returns the means over an observer `a` times a polynomial and a load `b` times another: rows
    /// by the observer's polynomial, 1/m. Exchanging `a` and `b` transposes the result.
    pub fn between(&self, a: &Mollifier, b: &Mollifier) -> Mat<f64> {
        let mut means = Mat::zeros(self.modes, self.modes);
        for panel in &self.panels {
            let [forward, backward] = self.over(panel, a, b);
            for n in 0..self.modes {
                for m in 0..self.modes {
                    let sum = |column: usize, values: &[f64]| -> f64 {
                        let column = panel.spread.col(column);
                        column.iter().zip(values).map(|(share, value)| share * value).sum()
                    };
                    means[(n, m)] += sum(n * self.modes + m, &forward) + sum(m * self.modes + n, &backward);
                }
            }
        }
        means
    }

    /// Returns the means of `1/r` over both mollifiers for the pairs of a panel: with the observer
    /// at their first points, and at their second points.
    fn over(&self, panel: &Panel, a: &Mollifier, b: &Mollifier) -> [Vec<f64>; 2] {
        let ([a_start, a_end], [b_start, b_end]) = (a.support(), b.support());
        let count = panel.count;
        let mut sums = [vec![0.0; count], vec![0.0; count]];
        let mut points = [vec![0.0; 6 * count], vec![0.0; 6 * count]];
        for interval in differences(a, b, self.finest.max(2.0 * panel.from)).windows(2) {
            let half = 0.5 * (interval[1] - interval[0]);
            for (x, along) in &self.differences {
                let half_difference = 0.5 * (interval[0] + half * (1.0 + x));
                // Half the sum of `u` and `u'`.
                let from = (a_start - half_difference).max(b_start + half_difference);
                let to = (a_end - half_difference).min(b_end + half_difference);
                let half_across = 0.5 * (to - from);
                let sum_at = |y: f64| from + half_across * (1.0 + y);
                let mut weights = [0.0; PLACES];
                for (y, across, shares) in &self.onto_places {
                    let product =
                        a.value(sum_at(*y) + half_difference) * b.value(sum_at(*y) - half_difference);
                    for (sum, share) in weights.iter_mut().zip(shares) {
                        *sum += half * along * half_across * across * product * share;
                    }
                }
                for (&y, weight) in self.across.iter().zip(weights) {
                    let u = sum_at(y);
                    self.positions(panel, u + half_difference, &mut points[0]);
                    self.positions(panel, u - half_difference, &mut points[1]);
                    let plane = panel.side.map(|side| self.plane(side, u));
                    let ([observers, loads], [forward, backward]) = (&points, &mut sums);
                    let (first, second) = observers.split_at(3 * count);
                    let (other_first, other_second) = loads.split_at(3 * count);
                    add_reciprocals(forward, [first, other_second], weight, plane);
                    add_reciprocals(backward, [second, other_first], weight, plane);
                }
            }
        }
        sums
    }

    /// Returns the entry of the tables before `u`, and its distance from `u` in entries.
    fn locate(&self, u: f64) -> (usize, f64) {
        let at = (u - self.start) / self.step;
        let index = (at.max(0.0) as usize).min(INTERVALS - 1);
        (index, at - index as f64)
    }

    /// Computes the positions of all points of a panel at `u`.
    fn positions(&self, panel: &Panel, u: f64, target: &mut [f64]) {
        let (index, x) = self.locate(u);
        // Cubic Hermite interpolation.
        let y = 1.0 - x;
        let weights = [y * y * (1.0 + 2.0 * x), x * y * y, x * x * (1.0 + 2.0 * y), -x * x * y];
        let length = target.len();
        let (before, slopes_before) = panel.positions[index].split_at(length);
        let (after, slopes_after) = panel.positions[index + 1].split_at(length);
        let (slopes_before, slopes_after) = (&slopes_before[..length], &slopes_after[..length]);
        for (k, target) in target.iter_mut().enumerate() {
            *target = weights[0] * before[k]
                + weights[1] * slopes_before[k]
                + weights[2] * after[k]
                + weights[3] * slopes_after[k];
        }
    }

    fn plane(&self, side: usize, u: f64) -> Plane {
        let (index, x) = self.locate(u);
        let [a, b] = [0, 1].map(|next| self.planes[side][index + next]);
        let mix = |a: f64, b: f64| (1.0 - x) * a + x * b;
        let normal = [0, 1, 2].map(|axis| mix(a.normal[axis], b.normal[axis]));
        let size = length(normal);
        Plane { normal: normal.map(|part| part / size), height: mix(a.height, b.height) / size }
    }
}

/// Adds `weight / r` for the points of two lists (x, y and z of all points after each other), or
/// for the images of one of them in a plane.
fn add_reciprocals(sums: &mut [f64], [first, second]: [&[f64]; 2], weight: f64, plane: Option<Plane>) {
    let count = sums.len();
    let [x1, y1, z1] = [0, 1, 2].map(|axis| &first[axis * count..][..count]);
    let [x2, y2, z2] = [0, 1, 2].map(|axis| &second[axis * count..][..count]);
    match plane {
        None => {
            for (k, sum) in sums.iter_mut().enumerate() {
                let (dx, dy, dz) = (x1[k] - x2[k], y1[k] - y2[k], z1[k] - z2[k]);
                *sum += weight / (dx * dx + dy * dy + dz * dz).sqrt();
            }
        }
        Some(Plane { normal: [nx, ny, nz], height }) => {
            for (k, sum) in sums.iter_mut().enumerate() {
                let (dx, dy, dz) = (x1[k] - x2[k], y1[k] - y2[k], z1[k] - z2[k]);
                let own = nx * x1[k] + ny * y1[k] + nz * z1[k] - height;
                let other = nx * x2[k] + ny * y2[k] + nz * z2[k] - height;
                *sum += weight / (dx * dx + dy * dy + dz * dz + 4.0 * own * other).sqrt();
            }
        }
    }
}

/// Returns quadrature points over an interval of the distance along the face.
fn quadrature(modes: &AxialModes, [from, to]: [f64; 2]) -> Vec<(f64, f64)> {
    // On a long panel the products of polynomials vary too.
    let long = to * GRADING > 0.5 * modes.length();
    let half = 0.5 * (to - from);
    gauss_legendre(if long { POINTS.max(modes.count() + 4) } else { POINTS })
        .into_iter()
        .map(|(x, weight)| (from + half * (1.0 + x), half * weight))
        .collect()
}

/// Adds the products of all polynomials at two points.
fn add_products(modes: &AxialModes, v: [f64; 2], weight: f64, spread: &mut [f64]) {
    let [first, second] = v.map(|v| modes.values(v));
    for (n, a) in first.iter().enumerate() {
        for (m, b) in second.iter().enumerate() {
            spread[n * modes.count() + m] += weight * a * b;
        }
    }
}

/// Returns the pairs of the load itself: at each distance, points between both ends.
fn direct_pairs(modes: &AxialModes, points: &[(f64, f64)]) -> Vec<Pair> {
    let [start, end] = modes.range();
    let nodes: Vec<f64> = gauss_legendre(SUMS).into_iter().map(|(x, _)| x).collect();
    let mut pairs = Vec::new();
    for &(t, weight) in points {
        let (middle, half) = (0.5 * (start + end), 0.5 * (end - start - t));
        let apart = |x: f64| [1.0, -1.0].map(|sign| middle + half * x + 0.5 * sign * t);
        let mut spreads = vec![vec![0.0; modes.count() * modes.count()]; SUMS];
        for (x, part) in modes.quadrature([-1.0, 1.0], SUMS) {
            for (spread, share) in spreads.iter_mut().zip(lagrange(&nodes, x)) {
                add_products(modes, apart(x), weight * half * part * share, spread);
            }
        }
        let pair = |(&x, spread): (&f64, Vec<f64>)| Pair { v: apart(x), spread };
        pairs.extend(nodes.iter().zip(spreads).map(pair));
    }
    pairs
}

/// Returns the pairs of a point and an image in a side face: at each sum of their distances from
/// the face, points whose first is further from the start.
fn image_pairs(modes: &AxialModes, side: usize, points: &[(f64, f64)]) -> Vec<Pair> {
    let ([start, end], length) = (modes.range(), modes.length());
    let nodes: Vec<f64> = gauss_legendre(2 * DIRECTIONS).into_iter().map(|(x, _)| x).collect();
    let mut pairs = Vec::new();
    for &(t, weight) in points {
        let reach = t.min(2.0 * length - t);
        let at = |x: f64| match side {
            0 => [1.0, -1.0].map(|sign| start + 0.5 * (t + sign * reach * x)),
            _ => [1.0, -1.0].map(|sign| end - 0.5 * (t - sign * reach * x)),
        };
        let mut spreads = vec![vec![0.0; modes.count() * modes.count()]; 2 * DIRECTIONS];
        for (x, part) in modes.quadrature([-1.0, 1.0], 2 * DIRECTIONS) {
            for (spread, share) in spreads.iter_mut().zip(lagrange(&nodes, x)) {
                // dv dv' = dt d(v - v') / 2.
                add_products(modes, at(x), 0.5 * weight * reach * part * share, spread);
            }
        }
        // The pairs with negative differences are those with positive ones, exchanged.
        let pair = |(&x, spread): (&f64, Vec<f64>)| (x > 0.0).then(|| Pair { v: at(x), spread });
        pairs.extend(nodes.iter().zip(spreads).filter_map(pair));
    }
    pairs
}

/// Positions on a surface and their derivatives, on a grid of `u` and `v`.
struct PositionTable {
    v: Vec<f64>,
    /// Position and derivative by the index of the table, by index and point along.
    points: Vec<Vec<[Vector; 2]>>,
    /// Length along `v`, normal to the direction of `u`, per unit of `v`, in units of `u`: the
    /// least.
    ratio: f64,
}

impl PositionTable {
    fn new(surface: &dyn Surface, [start, step]: [f64; 2], [from, to]: [f64; 2]) -> Self {
        let half = 0.5 * (to - from);
        let v: Vec<f64> = gauss_legendre(ALONG).into_iter().map(|(x, _)| from + half * (1.0 + x)).collect();
        let mut ratio = f64::INFINITY;
        let mut at = |u: f64, v: f64| {
            let point = surface.at(u, v);
            let [by_u, by_v] = point.tangents;
            ratio = ratio.min(length(cross(by_u, by_v)) / dot(by_u, by_u));
            [point.position, by_u.map(|part| step * part)]
        };
        let row = |index: usize| v.iter().map(|&v| at(start + step * index as f64, v)).collect();
        let points = (0..=INTERVALS).map(row).collect();
        Self { v, points, ratio }
    }

    fn panel(&self, modes: usize, from: f64, side: Option<usize>, pairs: Vec<Pair>) -> Panel {
        let count = pairs.len();
        let shares: Vec<[Vec<f64>; 2]> =
            pairs.iter().map(|pair| pair.v.map(|v| lagrange(&self.v, v))).collect();
        let positions = |along: &Vec<[Vector; 2]>| {
            let mut values = vec![0.0; 12 * count];
            for (k, shares) in shares.iter().enumerate() {
                for (which, shares) in shares.iter().enumerate() {
                    for (share, point) in shares.iter().zip(along) {
                        for (order, part) in point.iter().enumerate() {
                            for axis in 0..3 {
                                values[((2 * order + which) * 3 + axis) * count + k] += share * part[axis];
                            }
                        }
                    }
                }
            }
            values
        };
        Panel {
            from,
            side,
            count,
            positions: self.points.iter().map(positions).collect(),
            spread: Mat::from_fn(count, modes * modes, |row, column| pairs[row].spread[column]),
        }
    }
}

#[cfg(test)]
mod tests;
