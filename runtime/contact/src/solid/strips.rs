//! Influence matrix of the cells of a patch by the average of 1/r, strip by strip.
//!
//! The cells of a slice share their interval along the patch and form a strip. The influence
//! between two distant strips, or a strip and a distant image, is a smooth function of the
//! positions x and x' across them: the average of 1/r over both intervals along the patch is
//! analytic within the ellipses that end at the distance. It is therefore evaluated at Chebyshev
//! points of both strips and interpolated (Trefethen, Approximation Theory and Approximation
//! Practice, 2013, theorem 8.2). The positions of the points depend on the strips alone, not on the
//! cells in them, so that rounding does not change the method from one pitch to the next. Close
//! strips, and cells that a side face cuts, are evaluated by pairs of cells.

use super::grid::Cell;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::quadrature::gauss_legendre;
use calyx_numerics::vec3::Vector;
use std::cell::OnceCell;
use std::f64::consts::PI;
use std::ops::Range;

/// Error of interpolation and quadrature relative to the largest value near the strips.
const TOLERANCE: f64 = 1e-9;
/// Largest number of points across a strip; closer strips are evaluated by pairs of cells.
const MOST_POINTS: usize = 16;

/// Influence between strips.
pub(super) trait StripInfluence {
    /// Common part of the influence of all pairs of cells of two strips.
    type Close;

    /// Returns a lower bound of the distance between the points of a strip and the sources of
    /// another, m.
    fn distance(&self, observe: &Strip, load: &Strip) -> f64;

    /// Returns the common part of two strips if it saves time.
    fn close(&self, _observe: &Strip, _load: &Strip) -> Option<Self::Close> {
        None
    }

    /// Returns the displacements of lines by forces of 1 N on lines, m/N, row-major.
    fn between_lines(&self, observe: &StripPoints, load: &StripPoints) -> Vec<f64>;
}

/// Points of a strip: lines along it at points across it.
pub(super) struct StripPoints {
    /// Positions in the patch's frame, line by line, m.
    pub places: Vec<[f64; 2]>,
    /// Weights of the points of a line, of sum 1.
    pub weights: Vec<f64>,
}

impl StripPoints {
    /// Returns the averages of 1/r between the lines of two strips, 1/m, row-major. `source`
    /// returns the place of a load, and `observer` that of a displacement, m.
    pub fn mean_inverse_distances(
        &self,
        load: &StripPoints,
        observer: impl Fn([f64; 2]) -> Vector,
        source: impl Fn([f64; 2]) -> Vector,
    ) -> Vec<f64> {
        let sources: Vec<Vector> = load.places.iter().map(|&at| source(at)).collect();
        let coordinates = [0, 1, 2].map(|k: usize| sources.iter().map(|at| at[k]).collect::<Vec<f64>>());
        let mut means = Vec::new();
        let (mut sums, mut inverse) = (vec![0.0; sources.len()], vec![0.0; sources.len()]);
        for line in self.places.chunks_exact(self.weights.len()) {
            sums.fill(0.0);
            for (&at, weight) in line.iter().zip(&self.weights) {
                inverse_distances(observer(at), &coordinates, &mut inverse);
                sums.iter_mut().zip(&inverse).for_each(|(sum, inverse)| *sum += weight * inverse);
            }
            let mean =
                |line: &[f64]| line.iter().zip(&load.weights).map(|(sum, weight)| sum * weight).sum::<f64>();
            means.extend(sums.chunks_exact(load.weights.len()).map(mean));
        }
        means
    }
}

/// Computes 1/r of points, given by coordinate, from a point, 1/m.
fn inverse_distances(from: Vector, [x, y, z]: &[Vec<f64>; 3], inverse: &mut [f64]) {
    for (((inverse, x), y), z) in inverse.iter_mut().zip(x).zip(y).zip(z) {
        let [x, y, z] = [x - from[0], y - from[1], z - from[2]];
        *inverse = (x * x + y * y + z * z).sqrt().recip();
    }
}

/// Common part of two close strips, which is computed when a pair of cells first needs it.
pub(super) struct Common<'a, I: StripInfluence> {
    influence: &'a I,
    strips: [&'a Strip; 2],
    known: OnceCell<Option<I::Close>>,
}

impl<I: StripInfluence> Common<'_, I> {
    pub fn get(&self) -> Option<&I::Close> {
        let [observe, load] = self.strips;
        self.known.get_or_init(|| self.influence.close(observe, load)).as_ref()
    }
}

/// Adds an influence to a symmetric block, row-major. `pair` returns the influence between two
/// cells of close strips by index, of which the second is at most the first. Each pair of strips is
/// a checkpoint.
///
/// # Errors
/// Those of the interrupt.
pub(super) fn add_influence<I: StripInfluence>(
    cells: &[Cell],
    influence: &I,
    mut pair: impl FnMut(usize, usize, &Common<I>) -> f64,
    block: &mut [f64],
    interrupt: &Interrupt,
) -> Result<(), EngineError> {
    let n = cells.len();
    let mut add = |i: usize, j: usize, value: f64| {
        block[i * n + j] += value;
        if j < i {
            block[j * n + i] += value;
        }
    };
    let strips = Strip::of(cells);
    let mut weights: Vec<[Option<Vec<f64>>; MOST_POINTS]> =
        strips.iter().map(|_| std::array::from_fn(|_| None)).collect();
    for (p, first) in strips.iter().enumerate() {
        for (q, second) in strips[..=p].iter().enumerate() {
            interrupt.check()?;
            let Some([along_first, along_second]) = Orders::between(first, second, influence) else {
                let close = Common { influence, strips: [first, second], known: OnceCell::new() };
                for i in first.cells.clone() {
                    for j in second.cells.clone().take_while(|&j| j <= i) {
                        add(i, j, pair(i, j, &close));
                    }
                }
                continue;
            };
            for (strip, orders) in [(p, along_first), (q, along_second)] {
                weights[strip][orders.across - 1]
                    .get_or_insert_with(|| strips[strip].interpolation(cells, orders.across));
            }
            let known = |strip: usize, orders: Orders| weights[strip][orders.across - 1].as_deref();
            let (Some(rows), Some(columns)) = (known(p, along_first), known(q, along_second)) else {
                continue;
            };
            let nodes = influence.between_lines(&first.points(along_first), &second.points(along_second));
            let (m, k) = (along_first.across, along_second.across);
            for (i, row) in first.cells.clone().zip(rows.chunks_exact(m)) {
                let mut by_node = [0.0; MOST_POINTS];
                for (weight, values) in row.iter().zip(nodes.chunks_exact(k)) {
                    by_node.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
                }
                for (j, column) in second.cells.clone().zip(columns.chunks_exact(k)) {
                    if j <= i {
                        add(i, j, column.iter().zip(&by_node).map(|(weight, value)| weight * value).sum());
                    }
                }
            }
        }
    }
    Ok(())
}

/// Consecutive cells with one interval along the patch.
pub(super) struct Strip {
    cells: Range<usize>,
    /// Centre across and along the patch, m.
    pub center: [f64; 2],
    /// Half-sizes, m.
    pub half: [f64; 2],
}

/// Numbers of points across and along a strip.
#[derive(Clone, Copy)]
struct Orders {
    across: usize,
    along: usize,
}

impl Strip {
    pub fn of(cells: &[Cell]) -> Vec<Strip> {
        let mut strips = Vec::new();
        let mut first = 0;
        let along = |cell: &Cell| [cell.center[1], cell.size[1]];
        for end in 1..=cells.len() {
            if end < cells.len() && along(&cells[end]) == along(&cells[first]) {
                continue;
            }
            let own = &cells[first..end];
            let ends = own.iter().map(|cell| cell.ends(0));
            let [low, high] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], [from, to]| {
                [low.min(from), high.max(to)]
            });
            let [y, size] = along(&own[0]);
            let (center, half) = ([0.5 * (low + high), y], [0.5 * (high - low), 0.5 * size]);
            strips.push(Strip { cells: first..end, center, half });
            first = end;
        }
        strips
    }

    /// Returns Chebyshev points by Gauss points.
    fn points(&self, orders: Orders) -> StripPoints {
        let rule = gauss_legendre(orders.along);
        let across =
            (0..orders.across).map(|node| self.center[0] + self.half[0] * chebyshev(node, orders.across));
        let places = across
            .flat_map(|x| rule.iter().map(move |&(t, _)| [x, self.center[1] + self.half[1] * t]))
            .collect();
        StripPoints { places, weights: rule.iter().map(|(_, weight)| 0.5 * weight).collect() }
    }

    /// Returns the averages of the Lagrange polynomials on the Chebyshev points over each cell,
    /// one row for each cell.
    fn interpolation(&self, cells: &[Cell], count: usize) -> Vec<f64> {
        let nodes: Vec<f64> = (0..count).map(|node| chebyshev(node, count)).collect();
        // Barycentric weights of Chebyshev points of the first kind.
        let barycentric: Vec<f64> = (0..count)
            .map(|node| {
                let sine = (PI * (node as f64 + 0.5) / count as f64).sin();
                if node % 2 == 0 { sine } else { -sine }
            })
            .collect();
        let rule = gauss_legendre(count.div_ceil(2));
        let mut averages = Vec::with_capacity(self.cells.len() * count);
        for cell in &cells[self.cells.clone()] {
            let mut average = vec![0.0; count];
            for &(t, weight) in &rule {
                let x = (cell.center[0] + 0.5 * cell.size[0] * t - self.center[0]) / self.half[0];
                let value = |node: usize| barycentric[node] / (x - nodes[node]);
                match nodes.iter().position(|&node| x == node) {
                    Some(node) => average[node] += 0.5 * weight,
                    None => {
                        let sum: f64 = (0..count).map(value).sum();
                        average
                            .iter_mut()
                            .enumerate()
                            .for_each(|(node, part)| *part += 0.5 * weight * value(node) / sum);
                    }
                }
            }
            averages.extend(average);
        }
        averages
    }
}

/// Returns a Chebyshev point of the first kind between -1 and 1, descending.
fn chebyshev(node: usize, count: usize) -> f64 {
    (PI * (node as f64 + 0.5) / count as f64).cos()
}

impl Orders {
    /// Returns the numbers of points for the influence between two strips; `None` if they are too
    /// close or have few cells.
    fn between(first: &Strip, second: &Strip, influence: &impl StripInfluence) -> Option<[Orders; 2]> {
        let distance = influence.distance(first, second);
        let of = |strip: &Strip| {
            // The sum of the half-axes of the ellipse about a side of the strip that ends at the
            // distance.
            let digits = |half: f64| {
                let ratio = distance / half;
                TOLERANCE.recip().ln() / (ratio + ratio.hypot(1.0)).ln()
            };
            let [across, along] = strip.half.map(digits);
            let enough = distance > 0.0 && across < MOST_POINTS.min(strip.cells.len()) as f64;
            enough.then(|| Orders {
                across: (across.ceil() as usize).max(1),
                along: ((0.5 * along).ceil() as usize).max(1),
            })
        };
        Some([of(first)?, of(second)?])
    }
}

#[cfg(test)]
mod tests {
    use super::super::half_space::HalfSpace;
    use super::super::image::Images;
    use super::super::image::tests::{FRAME, cell, face};
    use super::super::placement::PatchFrame;
    use super::*;

    /// Slices that end at `end`, with columns as on a contact line that is oblique, one cell cut by
    /// a side face, and the cells of another slice as at an edge.
    fn slices(end: f64) -> Vec<Cell> {
        let place = |k: usize| {
            let slice = k / 17;
            [0.03 * ((k % 17) as f64 + (slice / 3) as f64), end - 0.5 * slice as f64 - 0.25]
        };
        let mut cells: Vec<Cell> = (0..17 * 14).map(|k| cell(place(k), [0.03, 0.5])).collect();
        cells[16] = cell([place(16)[0], end - 0.35], [0.03, 0.3]);
        for graded in &mut cells[17 * 8..17 * 9] {
            graded.center[0] = 0.031 * graded.center[0] * (1.0 + graded.center[0]);
            graded.size[0] = 4e-4;
        }
        cells
    }

    fn matrix(images: &Images, cells: &[Cell]) -> Vec<f64> {
        let mut block = vec![0.0; cells.len() * cells.len()];
        let pair = |i: usize, j: usize, _: &Common<Images>| images.influence(&cells[i], &cells[j]);
        add_influence(cells, images, pair, &mut block, &Interrupt::never()).unwrap();
        block
    }

    /// Average by Gauss points, which is exact to rounding for distant cells.
    fn by_gauss_points(influence: &impl StripInfluence, cells: [&Cell; 2]) -> f64 {
        let rule = gauss_legendre(8);
        let points = |cell: &Cell| StripPoints {
            places: rule
                .iter()
                .flat_map(|(s, _)| {
                    let x = cell.center[0] + 0.5 * cell.size[0] * s;
                    rule.iter().map(move |(t, _)| [x, cell.center[1] + 0.5 * cell.size[1] * t])
                })
                .collect(),
            weights: rule.iter().map(|(_, weight)| 0.5 * weight).collect(),
        };
        let nodes = influence.between_lines(&points(cells[0]), &points(cells[1]));
        let weight = |k: usize| 0.5 * rule[k].1;
        (0..64).map(|k| weight(k / 8) * weight(k % 8) * nodes[k]).sum()
    }

    /// Compares the entries of distant strips, of which there are at least so many as a share of
    /// all.
    fn compare(influence: &impl StripInfluence, cells: &[Cell], block: &[f64], share: f64) {
        let strips = Strip::of(cells);
        let (mut interpolated, mut worst) = (0, 0.0_f64);
        for first in &strips {
            for second in &strips {
                if Orders::between(first, second, influence).is_none() {
                    continue;
                }
                for i in first.cells.clone() {
                    for j in second.cells.clone() {
                        let exact = by_gauss_points(influence, [&cells[i], &cells[j]]);
                        worst = worst.max((block[i * cells.len() + j] / exact - 1.0).abs());
                        interpolated += 1;
                    }
                }
            }
        }
        assert!(worst < 20.0 * TOLERANCE, "{worst:e}");
        let found = f64::from(interpolated) / (cells.len() as f64).powi(2);
        assert!(found > share, "{found} of all pairs of cells");
    }

    #[test]
    fn images_of_distant_strips_are_interpolated_to_the_tolerance() {
        for (end, lean) in [(1.99, 0.4), (1.2, 0.3), (-4.0, -0.6), (1.99, 0.0)] {
            let images = Images::new(face(lean), &FRAME);
            let cells = slices(end);
            compare(&images, &cells, &matrix(&images, &cells), 0.5);
        }
    }

    #[test]
    fn the_half_space_between_distant_strips_is_interpolated_to_the_tolerance() {
        let half_space = HalfSpace { softness: 0.7 };
        let cells = slices(1.99);
        let mut block = vec![0.0; cells.len() * cells.len()];
        let pair = |i: usize, j: usize, close: &Common<HalfSpace>| {
            half_space.influence(&cells[i], &cells[j], close.get())
        };
        add_influence(&cells, &half_space, pair, &mut block, &Interrupt::never()).unwrap();
        compare(&half_space, &cells, &block, 0.3);
        for (entry, found) in block.iter().enumerate() {
            let (i, j) = (entry / cells.len(), entry % cells.len());
            let exact = half_space.influence(&cells[i], &cells[j], None);
            assert!((found / exact - 1.0).abs() < 20.0 * TOLERANCE, "{i} {j}: {found:e} {exact:e}");
            assert_eq!(found.to_bits(), block[j * cells.len() + i].to_bits());
        }
    }

    #[test]
    fn all_images_are_those_of_pairs_of_cells() {
        let images = Images::new(face(0.4), &FRAME);
        let cells = slices(1.99);
        let block = matrix(&images, &cells);
        for (entry, found) in block.iter().enumerate() {
            let (i, j) = (entry / cells.len(), entry % cells.len());
            let exact = images.influence(&cells[i], &cells[j]);
            assert!((found / exact - 1.0).abs() < 3e-6, "{i} {j}: {found:e} {exact:e}");
            assert_eq!(found.to_bits(), block[j * cells.len() + i].to_bits());
        }
    }

    /// The same patch and mirror in other ground coordinates: rounding decides nothing.
    #[test]
    fn a_rotation_of_the_ground_changes_rounding_only() {
        let (sine, cosine) = 0.7_f64.sin_cos();
        let turned = |[x, y, z]: [f64; 3]| [cosine * x - sine * y, sine * x + cosine * y, z];
        let frame = PatchFrame {
            point: turned(FRAME.point),
            normal: turned(FRAME.normal),
            across: turned(FRAME.across),
            along: turned(FRAME.along),
        };
        let cells = slices(1.99);
        let mirror = face(0.4);
        let one = matrix(&Images::new(mirror, &FRAME), &cells);
        let other = matrix(&Images::new(mirror.rotated(turned), &frame), &cells);
        for (one, other) in one.iter().zip(&other) {
            assert!((one / other - 1.0).abs() < 1e-11, "{one:e} {other:e}");
        }
    }
}
